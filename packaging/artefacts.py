"""The files of a release, and what must be true of each before it is attached."""
import fnmatch
import hashlib
import io
import json
import re
import subprocess
import tarfile
import zipfile
from dataclasses import dataclass

from project import Refused

BILL = "axisc.spdx.json"


@dataclass(frozen=True)
class Kind:
    pattern: str  # VERSION stands for the version, * for anything
    made_by: str


KINDS = [
    Kind("axisc_VERSION-1_amd64.deb", ".ci/packages"),
    Kind("libaxisrt5_VERSION-1_amd64.deb", ".ci/packages"),
    Kind("libaxisrt-dev_VERSION-1_amd64.deb", ".ci/packages"),
    Kind("libaxisc0_VERSION-1_amd64.deb", ".ci/packages"),
    Kind("libaxisc-dev_VERSION-1_amd64.deb", ".ci/packages"),
    Kind("python3-axisc_VERSION-1_all.deb", ".ci/packages"),
    Kind("axisc-VERSION-py3-none-*.whl", ".ci/packages"),
    Kind("axisc-VERSION-linux-x86_64.tar.xz", ".ci/packages"),
    Kind("axisc-VERSION-windows-x86_64.zip", ".ci/windows"),
    Kind("axisc-VERSION.vsix", "editor/clients/vscode/package.sh"),
    Kind("axisc.html", ".ci/web"),
]


def digest_of(path):
    return hashlib.sha256(path.read_bytes()).hexdigest()


def recorded_digest(path):
    """The digest that was written when the file was made."""
    record = path.with_name(path.name + ".sha256")
    if not record.is_file():
        raise Refused(f"{path}: {record.name} is missing; what makes the file writes its digest beside it")
    match = re.fullmatch(r"([0-9a-f]{64}) [ *](\S+)\n?", record.read_text(encoding="utf-8"))
    if not match or match[2] != path.name:
        raise Refused(f"{record}: not one line \"SHA-256  {path.name}\"; make {path.name} again")
    return match[1]


def entries(path):
    """What an archive contains: names without the leading ./, and a function that reads one."""
    try:
        if path.suffix in (".zip", ".vsix", ".whl"):
            archive = zipfile.ZipFile(path)
            if archive.testzip() is not None:
                raise Refused(f"{path}: damaged; make it again")
            return archive.namelist(), archive.read
        if path.suffix == ".deb":
            done = subprocess.run(["dpkg-deb", "--fsys-tarfile", path], capture_output=True)
            if done.returncode != 0:
                raise Refused(f"{path}: {done.stderr.decode(errors='replace').strip()}; make it again")
            archive = tarfile.open(fileobj=io.BytesIO(done.stdout))
        else:
            archive = tarfile.open(path)
        members = {member.name.removeprefix("./"): member for member in archive.getmembers() if member.isfile()}
        return list(members), lambda name: archive.extractfile(members[name]).read()
    except (zipfile.BadZipFile, tarfile.TarError, EOFError, OSError) as error:
        raise Refused(f"{path}: not an archive ({error}); make it again") from None


def inside(path, name):
    names, read = entries(path)
    found = [entry for entry in names if entry == name or entry.endswith("/" + name)]
    if len(found) != 1:
        raise Refused(f"{path}: {name} is in it {len(found)} times, not once; make it again")
    return found[0], read(found[0])


def bill_of(path, project, commit):
    """The bill of materials in an archive, which also says from which commit the program was built."""
    _, text = inside(path, BILL)
    program = next((row for row in json.loads(text)["packages"] if row["name"] in ("axisc", "libaxisc")), None)
    if program is None or program["versionInfo"] != project.version:
        raise Refused(f"{path}: its bill of materials is not that of axisc {project.version}; build it again")
    built = re.match(r"commit ([0-9a-f]{7,40})\b", program.get("comment", ""))
    if not built or not commit.startswith(built[1]):
        raise Refused(f"{path}: built from {built[0] if built else 'an unknown commit'}, released is {commit[:12]}; build it again")
    return text


def check_page(path):
    text = path.read_bytes()
    if not text.lstrip()[:15].lower() == b"<!doctype html>":
        raise Refused(f"{path}: not a page; make it again (.ci/web)")
    if len(text) > 3 * 1024 * 1024:
        raise Refused(f"{path}: {len(text)} bytes, a page of one file has at most 3 MiB")


def find(folder, project, commit):
    """Names, sorted, to paths; and the bills of materials of those that contain the program, by name."""
    if not folder.is_dir():
        raise Refused(f"{folder}: no such folder; .ci/release builds what belongs there")
    files = {path.name: path for path in sorted(folder.iterdir()) if not path.name.endswith(".sha256")}
    named = lambda pattern: pattern.replace("VERSION", project.version)
    missing = [f"{named(kind.pattern)} ({kind.made_by})" for kind in KINDS if not fnmatch.filter(files, named(kind.pattern))]
    if missing:
        raise Refused(f"{folder}: missing: {', '.join(missing)}; .ci/release builds them")
    known = [named(kind.pattern) for kind in KINDS]
    others = [name for name in files if not any(fnmatch.fnmatchcase(name, pattern) for pattern in known)]
    if others:
        raise Refused(f"{folder}: no release of {project.version} has {', '.join(others)}; remove them")
    bills = {}
    for name, path in files.items():
        if digest_of(path) != recorded_digest(path):
            raise Refused(f"{path}: changed since it was made: it does not have the SHA-256 in {name}.sha256; make it again")
        if name == "axisc.html":
            check_page(path)
        elif name.endswith(".vsix"):
            _, manifest = inside(path, "extension/package.json")
            if json.loads(manifest)["version"] != project.version:
                raise Refused(f"{path}: the extension has the version {json.loads(manifest)['version']}; write {project.version} into package.json")
        elif name.startswith(("axisc-", "axisc_", "libaxisc0_")):
            bills[re.sub(r"\.(deb|zip|tar\.xz|whl)$", ".spdx.json", name)] = bill_of(path, project, commit)
    return files, bills
