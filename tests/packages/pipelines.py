#!/usr/bin/env python3
"""Runs what pre-commit, the action for GitHub and the component for GitLab run: pipelines.py AXISC SOURCES."""
import functools
import hashlib
import http.server
import json
import os
import re
import shutil
import subprocess
import sys
import tarfile
import tempfile
import threading

try:
    import yaml
except ImportError:
    print("python3-yaml is not installed: not tried")
    sys.exit(77)

AXISC, SOURCES = sys.argv[1:]
GOOD = "kenngr.achs_typ 1\n"
BAD = "getriebe[0].dynamik.a_max 3000,0\n"
VERSION = "9.8.7"


def shell(script, folder, status=0, path="", **variables):
    """GitHub and GitLab run scripts in bash and stop at the first mistake."""
    variables = {"PATH": f"{path}:/usr/bin:/bin" if path else "/usr/bin:/bin", "HOME": folder, "LANG": "C.UTF-8", **variables}
    done = subprocess.run(["bash", "-eo", "pipefail", "-c", script], cwd=folder, env=variables, capture_output=True, text=True)
    assert done.returncode == status, (done.returncode, script, done.stdout, done.stderr)
    return done.stdout + done.stderr


def make_archive(folder):
    archive = f"{folder}/axisc-{VERSION}-linux-x86_64.tar.xz"
    with tarfile.open(archive, "w:xz", preset=0) as out:
        out.add(AXISC, f"axisc-{VERSION}-linux-x86_64/bin/axisc")
    return archive


def digest_of(file):
    with open(file, "rb") as bytes_of_file:
        return hashlib.sha256(bytes_of_file.read()).hexdigest()


def serve(folder):
    """The address of a server, without encryption, that hands out the files of a folder."""
    class Quiet(http.server.SimpleHTTPRequestHandler):
        def log_message(self, *words):
            pass

    server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), functools.partial(Quiet, directory=folder))
    threading.Thread(target=server.serve_forever, daemon=True).start()
    return f"http://127.0.0.1:{server.server_port}"


def refusals(folder, archive, served):
    """Ways in which an archive is not the one that was meant: the archive, the digest that is given, what is said of it."""
    alone = f"{folder}/alone.tar.xz"
    shutil.copy(archive, alone)
    damaged = f"{folder}/damaged.tar.xz"
    shutil.copy(archive, damaged)
    with open(f"{damaged}.sha256", "w", encoding="utf-8") as file:
        file.write(f"{digest_of(archive)}  {os.path.basename(archive)}\n")
    with open(damaged, "ab") as file:
        file.write(b"more")
    empty = f"{folder}/empty.tar.xz"
    shutil.copy(archive, empty)
    with open(f"{empty}.sha256", "w", encoding="utf-8"):
        pass
    sums = f"{folder}/sums.tar.xz"
    shutil.copy(archive, sums)
    with open(f"{sums}.sha256", "w", encoding="utf-8") as file:
        file.write(f"{digest_of(damaged)}  another.tar.xz\n{digest_of(sums)}  sums.tar.xz\n")
    page = f"{folder}/page.tar.xz"
    shutil.copy(archive, page)
    with open(f"{page}.sha256", "w", encoding="utf-8") as file:
        file.write("<html>Sign in")
    other = "0" * 64
    return [(alone, "", "no digest"), (sums, "", "does not have the SHA-256"), (page, "", "does not have the SHA-256"),
            (f"{folder}/nowhere.tar.xz", digest_of(archive), "cannot be read"), (damaged, digest_of(archive), "does not have the SHA-256"),
            (f"{served}/{os.path.basename(archive)}", "", "set sha256, or use https"), (f"{served}/nothing", other, "cannot be read"),
            (damaged, "", "does not have the SHA-256"), (empty, "", "does not have the SHA-256"),
            (archive, other, "does not have the SHA-256"), (archive, digest_of(archive)[:63], "does not have the SHA-256"),
            (archive, f"{other}\n{digest_of(archive)}", "does not have the SHA-256")]


def github(folder, archive, served):
    with open(f"{SOURCES}/action.yml", encoding="utf-8") as file:
        action = yaml.safe_load(file)
    assert action["runs"]["using"] == "composite"
    install, check = action["runs"]["steps"]
    inputs = {name: row["default"] for name, row in action["inputs"].items()}

    def environment(step, **given):
        values = {**{f"inputs.{name}": text for name, text in {**inputs, **given}.items()},
                  "github.server_url": "file:/", "github.action_repository": "repository",
                  "github.action_path": SOURCES, "runner.temp": folder}
        return {key: re.sub(r"\$\{\{ ([\w.]+) \}\}", lambda match: values[match[1]], text) for key, text in step["env"].items()}

    paths = f"{folder}/path"
    for refused, digest, why in refusals(folder, archive, served):
        shown = shell(install["run"], folder, 1, GITHUB_PATH=paths, **environment(install, archive=refused, sha256=digest))
        assert why in shown, shown
        assert not os.path.exists(f"{folder}/axisc") and not os.path.exists(paths), (refused, digest)
    shell(install["run"], folder, GITHUB_PATH=paths, **environment(install, archive=f"{folder}/alone.tar.xz", sha256=digest_of(archive)))
    shell(install["run"], folder, GITHUB_PATH=paths, **environment(install, archive=archive))
    named = f"{served}/{os.path.basename(archive)}"
    shell(install["run"], folder, GITHUB_PATH=paths, **environment(install, archive=named, sha256=digest_of(archive)))
    with open(paths, encoding="utf-8") as file:
        path = file.read().split()[-1]
    assert os.path.samefile(path, f"{folder}/axisc/bin")
    shown = shell(check["run"], folder, path=path, **environment(check, paths="good.lis\n", options="--cycle-time\n1ms\n"))
    assert "::error" not in shown, shown
    shown = shell(check["run"], folder, 1, path, **environment(check, paths="good.lis\nbad.lis", sarif="found.sarif"))
    assert "::error file=bad.lis,line=1" in shown, shown
    with open(f"{folder}/found.sarif", encoding="utf-8") as file:
        assert json.load(file)["version"] == "2.1.0"
    print("GitHub: refused, installed, checked")


def gitlab(folder, archive, served):
    with open(f"{SOURCES}/templates/axisc.yml", encoding="utf-8") as file:
        text = file.read()
    header, body = yaml.safe_load_all(text)
    inputs = {name: (row or {}).get("default") for name, row in header["spec"]["inputs"].items()}

    def run(status, **given):
        given = {**inputs, "options": "--cycle-time 1ms", **given}
        filled = re.sub(r"\$\[\[ inputs\.(\w+) \]\]", lambda match: json.dumps(given[match[1]]) if match[1] == "sha256" else given[match[1]],
                        text.split("---\n")[1])
        job = yaml.safe_load(filled)["axisc-lint"]
        assert set(job) == set(body["axisc-lint"])
        script = "\n".join(job["script"]).replace("/tmp/axisc", f"{folder}/unpacked")
        return job, shell(script, folder, status, **job["variables"])

    for refused, digest, why in refusals(folder, archive, served):
        _, shown = run(1, archive=refused, sha256=digest)
        assert why in shown, shown
        assert not os.path.exists(f"{folder}/unpacked"), (refused, digest)
    for list_name, status in (("good.lis", 0), ("bad.lis", 1)):
        job, _ = run(status, archive=archive, paths=list_name)
        with open(f"{folder}/{job['artifacts']['reports']['codequality']}", encoding="utf-8") as file:
            assert (len([row for row in json.load(file) if row["severity"] == "major"]) > 0) == (status == 1)
    print("GitLab: refused, installed, checked")


def pre_commit(folder):
    if not shutil.which("pre-commit"):
        print("pre-commit is not installed: not tried")
        return
    hooks = f"{folder}/hooks"
    work = f"{folder}/work"
    os.makedirs(hooks)
    os.makedirs(work)
    shutil.copy(f"{SOURCES}/.pre-commit-hooks.yaml", hooks)
    commit = "git -c user.name=x -c user.email=x@example.com commit -qm x"
    for repository in (hooks, work):
        shell(f"git init -q . && git add . && {commit} --allow-empty", repository)
    files = (("good.lis", GOOD), ("bad.lis", BAD), ("other.txt", BAD), ("@WORSE.LIS", BAD), ("package.json", "{}"))
    for name, text in files:
        with open(f"{work}/{name}", "w", encoding="utf-8") as file:
            file.write(text)
    path = os.path.dirname(AXISC) + ":" + os.path.dirname(shutil.which("pre-commit"))
    settings = {"path": path, "PRE_COMMIT_HOME": f"{folder}/cache"}
    shell("git add .", work)
    passed = shell(f"pre-commit try-repo '{hooks}' axisc-lint --files good.lis other.txt", work, **settings)
    assert "Passed" in passed, passed
    failed = shell(f"pre-commit try-repo '{hooks}' axisc-lint --all-files", work, 1, **settings)
    assert "bad.lis" in failed and "@WORSE.LIS" in failed, failed
    assert "other.txt" not in failed and "package.json" not in failed, failed
    aligned = shell(f"pre-commit try-repo '{hooks}' axisc-fmt --files good.lis other.txt", work, 1, **settings)
    assert "files were modified by this hook" in aligned, aligned
    print("pre-commit: passed, failed, modified")


with tempfile.TemporaryDirectory() as temporary:
    for name, text in (("good.lis", GOOD), ("bad.lis", BAD)):
        with open(f"{temporary}/{name}", "w", encoding="utf-8") as file:
            file.write(text)
    packed = make_archive(temporary)
    with open(f"{packed}.sha256", "w", encoding="utf-8") as file:
        file.write(f"{digest_of(packed)}  {os.path.basename(packed)}\n")
    address = serve(temporary)
    github(temporary, packed, address)
    gitlab(temporary, packed, address)
    pre_commit(temporary)
