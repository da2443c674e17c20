#!/usr/bin/env python3
"""Writes the wheel: modules, shared libraries, and what installers want to know. The same inputs give the same bytes.

wheel.py FOLDER VERSION EPOCH PROCESSOR STRIP --about METADATA NOTICE... --modules FILE... --libraries FILE...
"""

import argparse
import base64
import hashlib
import pathlib
import re
import subprocess
import sys
import tempfile
import time
import zipfile

# What a manylinux wheel may expect of every system, of what these libraries could need.
EVERYWHERE = {"libc.so.6", "libm.so.6", "ld-linux-x86-64.so.2", "ld-linux-aarch64.so.1"}
OLDEST = (2, 17)  # the C library of the first system that a tag of this kind can name


def printed(*words):
    return subprocess.run(words, check=True, capture_output=True, text=True).stdout


def stripped(path, strip):
    with tempfile.NamedTemporaryFile() as file:
        subprocess.run([strip, "--strip-unneeded", "-o", file.name, str(path)], check=True)
        return pathlib.Path(file.name).read_bytes()


def platform_of(libraries, processor):
    """The oldest C library that has every symbol which they take from it."""
    newest = OLDEST
    for path in libraries:
        needed = set(re.findall(r"NEEDED\s+(\S+)", printed("objdump", "-p", str(path))))
        if needed - EVERYWHERE:
            sys.exit(f"wheel.py: {path} needs {', '.join(sorted(needed - EVERYWHERE))}, which not every system has")
        versions = re.findall(r"\(?GLIBC_(\d+)\.(\d+)", printed("objdump", "-T", str(path)))
        newest = max([newest, *((int(major), int(minor)) for major, minor in versions)])
    return f"manylinux_{newest[0]}_{newest[1]}_{processor}"


def main():
    parser = argparse.ArgumentParser()
    for name in ("folder", "version", "epoch", "processor", "strip"):
        parser.add_argument(name)
    for name in ("about", "modules", "libraries"):
        parser.add_argument(f"--{name}", nargs="+", type=pathlib.Path, required=True)
    given = parser.parse_args()
    metadata, *notices = given.about
    tag = f"py3-none-{platform_of(given.libraries, given.processor)}"
    about = f"axisc-{given.version}.dist-info"
    files = [(f"axisc/{path.name}", path.read_bytes()) for path in sorted(given.modules)]
    files += [(f"axisc/{path.name}", stripped(path, given.strip)) for path in sorted(given.libraries)]
    files += [(f"{about}/METADATA", metadata.read_bytes())]
    files += [(f"{about}/licenses/{path.name}", path.read_bytes()) for path in sorted(notices)]
    files += [(f"{about}/WHEEL", f"Wheel-Version: 1.0\nGenerator: axisc ({given.version})\nRoot-Is-Purelib: false\nTag: {tag}\n".encode())]
    record = ""
    for name, data in files:
        digest = base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b"=").decode()
        record += f"{name},sha256={digest},{len(data)}\n"
    files += [(f"{about}/RECORD", f"{record}{about}/RECORD,,\n".encode())]
    folder = pathlib.Path(given.folder)
    folder.mkdir(parents=True, exist_ok=True)
    with zipfile.ZipFile(folder / f"axisc-{given.version}-{tag}.whl", "w") as wheel:
        for name, data in files:
            entry = zipfile.ZipInfo(name, time.gmtime(int(given.epoch))[:6])
            entry.compress_type = zipfile.ZIP_DEFLATED
            entry.create_system = 3  # Unix, whose permissions follow
            entry.external_attr = (0o100755 if ".so" in name else 0o100644) << 16
            wheel.writestr(entry, data)


if __name__ == "__main__":
    main()
