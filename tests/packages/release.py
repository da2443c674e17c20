#!/usr/bin/env python3
"""Collects a release of dummy artefacts, and is refused whatever must not be released: release.py SOURCES."""
import hashlib
import io
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tarfile
import tempfile
import zipfile

try:
    import yaml
except ImportError:
    print("python3-yaml is not installed: not tried")
    sys.exit(77)
if missing := [name for name in ("git", "dpkg-deb") if not shutil.which(name)]:
    print(f"{', '.join(missing)}: not installed: not tried")
    sys.exit(77)

SOURCES = pathlib.Path(sys.argv[1])
VERSION, DAY, HOME = "9.8.7", "2031-02-03", "https://git.example.com/somebody/axisc"
LINUX, WINDOWS = f"axisc-{VERSION}-linux-x86_64", f"axisc-{VERSION}-windows-x86_64"
CMAKE = f'project(axisc VERSION {VERSION} LANGUAGES C\n  DESCRIPTION "Lists: checked" HOMEPAGE_URL "{HOME}")\n'
CHANGELOG = f"# Changes\n\n## {VERSION} ({DAY})\n\n- New is\n  [this](docs/this.md).\n\n## 9.8.6 (2031-01-01)\n\n- Old.\n"
OTHERS = {
    "vcpkg.json": f'{{"version-string": "{VERSION}"}}', "python/axisc/_library.py": f'version = "{VERSION}"\n',
    "editor/clients/vscode/package.json": f'{{\n  "version": "{VERSION}"\n}}', "web/package.json": f'{{\n  "version": "{VERSION}"\n}}',
    "editor/clients/vscode/CHANGELOG.md": f"# Changes\n\n## {VERSION}\n\n- New.\n\n## 9.8.0\n\n- Old.\n",
    "action.yml": f"# uses: somebody/axisc@v{VERSION}\n", "templates/axisc.yml": f"# component: x/axisc/axisc@{VERSION}\n",
    "docs/installation.md": f"axisc-{VERSION}.zip, axisc:{VERSION}\n", "docs/packages.md": f"rev: v{VERSION}, download/v{VERSION}/axisc-{VERSION}.zip\n",
    "validator/rules/AX0001-first/facts.json": f'{{"since": "{VERSION}"}}',
}


def run(*words, folder, status=0, **variables):
    clean = {key: value for key, value in os.environ.items() if not key.startswith(("AXISC_", "GIT_"))}
    done = subprocess.run(words, cwd=folder, capture_output=True, text=True, env={**clean, **variables})
    assert done.returncode == status, (words, done.returncode, done.stdout, done.stderr)
    return done.stdout + done.stderr


def sources(folder):
    """A repository that can be released."""
    shutil.copytree(SOURCES / "packaging", folder / "packaging", ignore=shutil.ignore_patterns("__pycache__"))
    (folder / "CMakeLists.txt").write_text(CMAKE)
    (folder / "CHANGELOG.md").write_text(CHANGELOG)
    for name, text in OTHERS.items():
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_text(text)
    run("git", "init", "-q", ".", folder=folder)
    commit(folder)
    run("git", "tag", f"v{VERSION}", folder=folder)


def commit(folder):
    run("git", "add", ".", folder=folder)
    run("git", "-c", "user.name=x", "-c", "user.email=x@example.com", "commit", "-qm", "x", folder=folder)


def bill(version, commit_of):
    return json.dumps({"packages": [{"name": "axisc", "versionInfo": version, "comment": f"commit {commit_of}, GCC 12.2.0"}]}).encode()


def record(path):
    path.with_name(path.name + ".sha256").write_text(f"{digest_of(path)}  {path.name}\n")


def digest_of(path):
    return hashlib.sha256(path.read_bytes()).hexdigest()


def write_zip(path, files):
    with zipfile.ZipFile(path, "w") as archive:
        for name, contents in files.items():
            archive.writestr(name, contents)


def write_tar(path, files):
    with tarfile.open(path, "w:xz") as archive:
        for name, contents in files.items():
            row = tarfile.TarInfo(name)
            row.size = len(contents)
            archive.addfile(row, io.BytesIO(contents))


def write_deb(path, package, files):
    with tempfile.TemporaryDirectory() as root:
        for name, contents in files.items():
            file = pathlib.Path(root) / name
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_bytes(contents)
        control = pathlib.Path(root) / "DEBIAN" / "control"
        control.parent.mkdir()
        control.write_text(f"Package: {package}\nVersion: {VERSION}-1\nArchitecture: amd64\nMaintainer: x <x@example.com>\nDescription: x\n")
        run("dpkg-deb", "--root-owner-group", "--build", root, str(path), folder=root)


def artefacts(folder, commit_of, version=VERSION):
    """What the builds leave: the names and layouts of the real ones, next to nothing in them."""
    folder.mkdir()
    document = "share/doc/axisc/axisc.spdx.json"
    text = bill(version, commit_of)
    write_deb(folder / f"axisc_{VERSION}-1_amd64.deb", "axisc", {"usr/bin/axisc": b"program", f"usr/{document}": text})
    for package in ("libaxisrt5", "libaxisrt-dev", "libaxisc-dev"):
        write_deb(folder / f"{package}_{VERSION}-1_amd64.deb", package, {f"usr/{package}": b"library"})
    write_deb(folder / f"libaxisc0_{VERSION}-1_amd64.deb", "libaxisc0", {"usr/share/doc/libaxisc0/axisc.spdx.json": text})
    write_deb(folder / f"python3-axisc_{VERSION}-1_all.deb", "python3-axisc", {"usr/lib/python3/dist-packages/axisc/__init__.py": b""})
    write_zip(folder / f"axisc-{VERSION}-py3-none-manylinux_2_35_x86_64.whl", {f"axisc-{VERSION}.dist-info/licenses/axisc.spdx.json": text})
    write_tar(folder / f"{LINUX}.tar.xz", {f"{LINUX}/bin/axisc": b"program", f"{LINUX}/{document}": text})
    write_zip(folder / f"{WINDOWS}.zip", {f"{WINDOWS}/bin/axisc.exe": b"program", f"{WINDOWS}/{document}": text})
    write_zip(folder / f"axisc-{VERSION}.vsix", {"extension/package.json": json.dumps({"version": version})})
    (folder / "axisc.html").write_text("<!doctype html><title>axisc</title>")
    for path in list(folder.iterdir()):
        record(path)


def release(folder, *words, **more):
    return run(sys.executable, str(folder / "packaging" / "release.py"), *words, folder=folder, **more)


def check_sums(out):
    run("sha256sum", "--check", "--strict", "--quiet", "SHA256SUMS", folder=out)
    names = [line.split("  ")[1] for line in (out / "SHA256SUMS").read_text().splitlines()]
    assert names == sorted(names)
    assert {path.name for path in out.iterdir()} == {"SHA256SUMS", *names, *(f"{name}.sha256" for name in names)}
    for name in names:
        run("sha256sum", "--check", "--strict", "--quiet", f"{name}.sha256", folder=out)
    return names


def check_manifests(out):
    """Fields and patterns that the schemas 1.6.0 of winget and the schema of scoop demand."""
    zipped = out / f"{WINDOWS}.zip"
    address = f"{HOME}/releases/download/v{VERSION}/{WINDOWS}.zip"
    files = {kind: yaml.safe_load((out / f"somebody.axisc{kind}.yaml").read_text()) for kind in ("", ".installer", ".locale.en-US")}
    for kind, manifest in (("", "version"), (".installer", "installer"), (".locale.en-US", "defaultLocale")):
        assert files[kind]["ManifestType"] == manifest and files[kind]["ManifestVersion"] == "1.6.0"
        assert files[kind]["PackageIdentifier"] == "somebody.axisc" and files[kind]["PackageVersion"] == VERSION
        assert f"winget-manifest.{manifest}.1.6.0.schema.json" in (out / f"somebody.axisc{kind}.yaml").read_text()
    assert files[""]["DefaultLocale"] == files[".locale.en-US"]["PackageLocale"] == "en-US"
    assert {"Publisher", "PackageName", "License", "ShortDescription"} <= set(files[".locale.en-US"])
    assert files[".locale.en-US"]["ShortDescription"] == "Lists: checked" and len(files[".locale.en-US"]["Tags"]) <= 16
    installer = files[".installer"]
    assert installer["InstallerType"] == "zip" and installer["NestedInstallerType"] == "portable" and installer["ReleaseDate"] == DAY
    assert installer["NestedInstallerFiles"] == [{"RelativeFilePath": f"{WINDOWS}\\bin\\axisc.exe", "PortableCommandAlias": "axisc"}]
    assert installer["Installers"] == [{"Architecture": "x64", "InstallerUrl": address, "InstallerSha256": digest_of(zipped).upper()}]
    scoop = json.loads((out / "axisc.json").read_text())
    assert {"version", "homepage", "license"} <= set(scoop) <= {"version", "description", "homepage", "license", "architecture", "bin"}
    assert (scoop["version"], scoop["homepage"], scoop["license"]) == (VERSION, HOME, "MIT")
    assert scoop["architecture"] == {"64bit": {"url": address, "hash": digest_of(zipped), "extract_dir": WINDOWS}}
    with zipfile.ZipFile(zipped) as archive:
        assert f"{scoop['architecture']['64bit']['extract_dir']}\\{scoop['bin']}".replace("\\", "/") in archive.namelist()


def check_container(out):
    text = (out / "Containerfile").read_text()
    assert f"\nARG ARCHIVE={HOME}/releases/download/v{VERSION}/{LINUX}.tar.xz\n" in text
    assert f"\nARG SHA256={digest_of(out / f'{LINUX}.tar.xz')}\n" in text
    assert text.index("sha256sum --check") < text.index("tar ") and re.search(r"^USER [1-9]\d*$", text, re.MULTILINE)
    assert not re.search(r"@\w+@", text), text


def collected(folder, work):
    """The whole folder, and what it says; nothing of it can be changed afterwards."""
    assert f"axisc {VERSION} of {DAY}" in release(folder, "check")
    out = work / "out"
    release(folder, "collect", str(work / "made"), str(out))
    names = check_sums(out)
    assert {f"{LINUX}.spdx.json", f"{WINDOWS}.spdx.json", f"axisc_{VERSION}-1_amd64.spdx.json", "axisc.html"} <= set(names)
    check_manifests(out)
    check_container(out)
    release(folder, "verify", str(out))
    shown = release(folder, "notes", str(out))
    assert shown.endswith(f"## What is new\n\n- New is [this]({HOME}/blob/v{VERSION}/docs/this.md).\n") and "Old" not in shown, shown
    assert f"uses: somebody/axisc@v{VERSION}" in shown and digest_of(out / f"{LINUX}.tar.xz") in shown
    assert f"{HOME}/releases/latest/download/axisc.json" in shown and not re.search(r"@[A-Z]+@", shown), shown
    assert "exists" in release(folder, "collect", str(work / "made"), str(out), status=2)
    for name in (f"{LINUX}.tar.xz", "axisc.json"):
        whole = (out / name).read_bytes()
        (out / name).write_bytes(whole + b"more")
        assert f"{name}: does not have the SHA-256" in release(folder, "verify", str(out), status=2)
        (out / name).write_bytes(whole)
    (out / "new.txt").write_text("new")
    assert "added" in release(folder, "verify", str(out), status=2)
    (out / "new.txt").unlink()
    # The same again gives the same bytes.
    release(folder, "collect", str(work / "made"), str(work / "again"))
    run("diff", "-r", str(out), str(work / "again"), folder=work)


def refused_sources(folder, work):
    """What is wrong with the sources: what is changed in them, and what is said."""
    def change(name, before, after):
        path = folder / name
        text = path.read_text()
        assert before in text
        path.write_text(text.replace(before, after))
        commit(folder)
        run("git", "tag", "--force", f"v{VERSION}", folder=folder)

    def refused(*said, **variables):
        shown = release(folder, "check", status=2, **variables)
        assert shown.startswith("release: ") and all(text in shown for text in said), shown
        assert release(folder, "collect", str(work / "made"), str(work / "none"), status=2, **variables) == shown
        assert not (work / "none").exists()

    refused("https://github.com/OWNER/axisc is not an address", "HOMEPAGE_URL", AXISC_HOMEPAGE="https://github.com/OWNER/axisc")
    for address in ("http://example.com/a/axisc", "https://example.com/axisc", "https://example.com/a b/axisc"):
        refused("is not an address", AXISC_HOMEPAGE=address)
    assert "for https://example.com/a/axisc" in release(folder, "check", AXISC_HOMEPAGE="https://example.com/a/axisc/")
    (folder / "left.txt").write_text("left")
    refused("left.txt", "commit or remove")
    (folder / "left.txt").unlink()
    run("git", "tag", "--delete", f"v{VERSION}", folder=folder)
    refused("no tag", f"git tag v{VERSION}")
    run("git", "tag", "v9.9.9", folder=folder)
    refused("the tag v9.9.9", VERSION)
    run("git", "tag", "--delete", "v9.9.9", folder=folder)
    change("CHANGELOG.md", "# Changes\n", "# Changes\n\n## Unreleased\n\n- More.\n")
    refused('the newest heading is "Unreleased"', f"## {VERSION} (YYYY-MM-DD)")
    change("CHANGELOG.md", "## Unreleased\n\n- More.\n", "")
    change("CHANGELOG.md", "## 9.8.6 (", f"## {VERSION} (")
    refused(f"{VERSION} has a section below the newest one", "the next version")
    change("CHANGELOG.md", f"\n\n## {VERSION} (2031-01-01)", "\n\n## 9.8.6 (2031-01-01)")
    change("CMakeLists.txt", VERSION, "9.9.0")
    refused("has the version 9.9.0", f"the tag v{VERSION}")
    change("CMakeLists.txt", "9.9.0", VERSION)
    for name in OTHERS:
        other = "unreleased" if name.endswith("facts.json") else "9.8.6"
        change(name, VERSION, other)
        refused(*(["AX0001-first", "docs/rules.md"] if other == "unreleased" else [f"{name} has the version 9.8.6; write {VERSION}"]))
        change(name, other, VERSION)
    change("CMakeLists.txt", "HOMEPAGE_URL", "HOME")
    refused("project() has no HOMEPAGE_URL")
    change("CMakeLists.txt", "HOME", "HOMEPAGE_URL")
    release(folder, "check")


def refused_artefacts(folder, work):
    """What is wrong with an artefact: the file, what is done to it, what is said."""
    head = run("git", "rev-parse", "HEAD", folder=folder).strip()
    place = work / "damaged"

    def damaged(name, act, *said, recorded=True, **made):
        shutil.rmtree(place, ignore_errors=True)
        artefacts(place, made.pop("commit_of", head), **made)
        act(place / name)
        if recorded:
            record(place / name)
        shown = release(folder, "collect", str(place), str(work / "none"), status=2)
        assert shown.startswith("release: ") and all(text in shown for text in said), shown
        assert not (work / "none").exists() and not list(work.glob("tmp*"))

    def append(path):
        path.write_bytes(path.read_bytes() + b"more")

    nothing = lambda path: None
    for name in (f"{LINUX}.tar.xz", f"{WINDOWS}.zip", "axisc.html", f"axisc_{VERSION}-1_amd64.deb"):
        damaged(name, append, f"{name}: changed since it was made", recorded=False)
    damaged("axisc.html", lambda path: path.unlink(), "missing: axisc.html (.ci/web)", recorded=False)
    damaged("axisc.html", lambda path: path.with_name("axisc.html.sha256").unlink(), "axisc.html.sha256 is missing", recorded=False)
    damaged("axisc.html", lambda path: shutil.copy(path.with_name(f"{LINUX}.tar.xz.sha256"), f"{path}.sha256"), "not one line", recorded=False)
    damaged("axisc.html", lambda path: path.write_text("not a page"), "not a page")
    damaged("axisc.html", lambda path: path.write_text("<!doctype html>" + " " * 3_200_000), "at most 3 MiB")
    damaged("axisc-9.8.6.vsix", lambda path: path.write_text("old"), f"no release of {VERSION} has axisc-9.8.6.vsix")
    damaged(f"{LINUX}.tar.xz", lambda path: path.write_text("not an archive"), "not an archive")
    damaged(f"axisc_{VERSION}-1_amd64.deb", lambda path: path.write_text("not a package"), "make it again")
    damaged(f"{WINDOWS}.zip", lambda path: write_zip(path, {"readme.txt": "nothing"}), "axisc.spdx.json is in it 0 times")
    damaged(f"{WINDOWS}.zip", lambda path: write_zip(path, {f"{WINDOWS}/share/doc/axisc/axisc.spdx.json": bill(VERSION, head)}),
            "bin/axisc.exe is in it 0 times")
    damaged("axisc.html", nothing, "is not that of axisc " + VERSION, version="9.8.6")
    damaged("axisc.html", nothing, "built from commit 0123456789ab, released is " + head[:12], commit_of="0123456789ab")
    damaged(f"axisc-{VERSION}.vsix", lambda path: write_zip(path, {"extension/package.json": '{"version": "9.8.6"}'}), "has the version 9.8.6")


def one_address():
    """Documents, action and component name the address and the version that project() has."""
    text = (SOURCES / "CMakeLists.txt").read_text(encoding="utf-8")
    home = re.search(r'HOMEPAGE_URL "([^"]+)"', text)[1]
    version = re.search(r"project\(axisc VERSION ([\d.]+)", text)[1]
    named = 0
    for path in [*SOURCES.glob("*.md"), *SOURCES.glob("docs/*.md"), SOURCES / "action.yml", SOURCES / "templates" / "axisc.yml"]:
        if path.name == "CHANGELOG.md":
            continue
        words = path.read_text(encoding="utf-8")
        for address in re.findall(r"https?://[\w.-]+/[\w./-]*\baxisc\b", words):
            assert address.startswith(home), f"{path}: {address}, but project() has {home}"
            named += 1
        for repository, used in re.findall(r"uses: (\S+/axisc)@v([\d.]*\d)", words):
            assert home.endswith(f"/{repository}") and used == version, f"{path}: {repository}@v{used}, but project() has {home} and {version}"
            named += 1
        for used in re.findall(r"\baxisc[-_](\d+\.\d+\.\d+)|\brev: v([\d.]*\d)|/axisc@([\d.]*\d)|/download/v([\d.]*\d)", words):
            assert version in used, f"{path}: version {''.join(used)}, but project() has {version}"
            named += 1
    assert named >= 8, named


with tempfile.TemporaryDirectory() as temporary:
    one_address()
    place = pathlib.Path(temporary)
    tree = place / "tree"
    sources(tree)
    artefacts(place / "made", run("git", "rev-parse", "--short=12", "HEAD", folder=tree).strip())
    collected(tree, place)
    refused_artefacts(tree, place)
    refused_sources(tree, place)
    print("collected, described, verified; refused what must not be released")
