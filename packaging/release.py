#!/usr/bin/env python3
"""A release: what it consists of, and what prevents it. Nothing is built or published here (.ci/release).

  release.py check                   whether the sources can be released
  release.py collect ARTEFACTS OUT   the folder OUT: the artefacts, manifests, bills of materials and digests
  release.py verify OUT              whether OUT is still what was collected
  release.py notes OUT               what is new, and how to get it, as Markdown
  release.py version | homepage      as the sources say it
"""
import os
import pathlib
import re
import shutil
import sys
import tempfile

sys.dont_write_bytecode = True
import artefacts
import manifests
import project as sources
from project import Refused

SUMS = "SHA256SUMS"


def write_digests(folder):
    rows = {path.name: artefacts.digest_of(path) for path in sorted(folder.iterdir())}
    for name, digest in rows.items():
        (folder / f"{name}.sha256").write_text(f"{digest}  {name}\n", encoding="utf-8")
    (folder / SUMS).write_text("".join(f"{digest}  {name}\n" for name, digest in rows.items()), encoding="utf-8")


def archive_in(files, ending):
    return next(path for name, path in files.items() if name.endswith(ending))


def collect(project, folder, out):
    if out.exists():
        raise Refused(f"{out}: exists; remove it")
    files, texts = artefacts.find(folder, project, sources.git("rev-parse", "HEAD"))
    windows, linux = archive_in(files, ".zip"), archive_in(files, ".tar.xz")
    for write, archive in ((manifests.winget, windows), (manifests.scoop, windows), (manifests.container, linux)):
        texts |= write(project, archive, artefacts.digest_of(archive))
    out.parent.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(dir=out.parent) as temporary:
        whole = pathlib.Path(temporary) / "whole"
        whole.mkdir()
        for name, path in files.items():
            shutil.copyfile(path, whole / name)
        for name, text in texts.items():
            (whole / name).write_bytes(text if isinstance(text, bytes) else text.encode())
        write_digests(whole)
        os.rename(whole, out)
    print(f"{len(files)} artefacts, {len(texts)} descriptions, {SUMS} in {out}")


def verify(project, out):
    """Every file is there, none is new, all have their digests, and the manifests name those of the archives."""
    if not (out / SUMS).is_file():
        raise Refused(f"{out}: has no {SUMS}; collect it")
    sums = dict(reversed(line.split("  ", 1)) for line in (out / SUMS).read_text(encoding="utf-8").splitlines())
    there = {path.name for path in out.iterdir()} - {SUMS}
    if wrong := sorted(there ^ ({*sums} | {f"{name}.sha256" for name in sums})):
        raise Refused(f"{out}: missing or added since it was collected: {', '.join(wrong)}; collect it again")
    for name, digest in sums.items():
        if artefacts.digest_of(out / name) != digest or artefacts.recorded_digest(out / name) != digest:
            raise Refused(f"{out / name}: does not have the SHA-256 in {SUMS}; collect it again")
    for ending, named in ((".zip", ["axisc.json", f"{project.owner}.axisc.installer.yaml"]), (".tar.xz", ["Containerfile"])):
        archive = archive_in({name: out / name for name in sums}, ending)
        for name in named:
            text = (out / name).read_text(encoding="utf-8")
            if sums[archive.name] not in text.lower() or project.address_of(archive.name) not in text:
                raise Refused(f"{out / name}: does not name {project.address_of(archive.name)} with its digest; collect it again")
    return sums


def notes(project, out):
    sums = verify(project, out)
    linux = next(name for name in sums if name.endswith(".tar.xz"))
    # Servers show line breaks of notes as such, and know no paths of the repository.
    news = re.sub(r"\n +(?![-*] )", " ", project.news)
    news = re.sub(r"\]\((?!https?:|#)", f"]({project.homepage}/blob/{project.tag}/", news)
    text = (pathlib.Path(__file__).parent / "notes.md.in").read_text(encoding="utf-8")
    for key, value in (("NEWS", news), ("VERSION", project.version), ("HOMEPAGE", project.homepage), ("OWNER", project.owner),
                       ("REPOSITORY", "/".join(project.homepage.split("/")[-2:])), ("LINUX", linux), ("SHA256", sums[linux])):
        text = text.replace(f"@{key}@", value)
    return text


def main(words):
    project = sources.read()
    match words:
        case ["check"]:
            sources.check(project)
            print(f"axisc {project.version} of {project.day}, commit {sources.git('rev-parse', '--short=12', 'HEAD')}, "
                  f"for {project.homepage}")
        case ["collect", folder, out]:
            sources.check(project)
            collect(project, pathlib.Path(folder), pathlib.Path(out))
        case ["verify", out]:
            print(f"{len(verify(project, pathlib.Path(out)))} files have their digests")
        case ["notes", out]:
            print(notes(project, pathlib.Path(out)), end="")
        case ["version"]:
            print(project.version)
        case ["homepage"]:
            print(project.homepage)
        case _:
            raise Refused(f"not a step: {' '.join(words) or '(none)'}\n{__doc__}")


try:
    main(sys.argv[1:])
except Refused as refused:
    print(f"release: {refused}", file=sys.stderr)
    sys.exit(2)
