#!/usr/bin/env python3
"""axisc.exe and the files of Windows, under wine: files.py NATIVE AXISC.EXE HOLD_OPEN.EXE SAMPLES"""
import os
import shutil
import subprocess
import sys
import tempfile
import time

NATIVE, PROGRAM, HOLD_OPEN, SAMPLES = (os.path.abspath(word) for word in sys.argv[1:5])
ENVIRONMENT = dict(os.environ, LANG="C.UTF-8", WINEDEBUG="-all")
failed = 0


def check(holds, text):
    global failed
    print(("ok    " if holds else "FAIL  ") + text, flush=True)
    failed += not holds


def axisc(*words, folder, native=False, **options):
    command = [NATIVE] if native else ["wine64", PROGRAM]
    return subprocess.run([*command, *words], cwd=folder, env=ENVIRONMENT, capture_output=True, **options)


def same(folder, *words, text):
    here, there = axisc(*words, folder=folder), axisc(*words, folder=folder, native=True)
    alike = (here.stdout, here.stderr, here.returncode) == (there.stdout, there.stderr, there.returncode)
    check(alike, text)
    if not alike:
        print(here.stdout[-400:], here.stderr[-400:], there.stdout[-400:], there.stderr[-400:])


def names(root):
    for name in ("Anlage ü", "mit Leerzeichen und 100 %", "a" * 100 + "/" + "b" * 100 + "/" + "c" * 100):
        folder = os.path.join(root, name)
        shutil.copytree(os.path.join(SAMPLES, "mill"), folder)
        same(root, "lint", name, "--format", "json", text=f"findings in a folder called {name[:30]}")
        same(root, "compile", name + "/machine.json", "-o", "-", "--quiet", text="its image")
        written = axisc("compile", name + "/machine.json", "-o", name + "/größe.axim", "--quiet", folder=root)
        check(written.returncode == 0 and os.path.exists(os.path.join(folder, "größe.axim")), "its image as a file")
        there = axisc("lint", name.replace("/", "\\") + "\\machine.json", folder=root)
        here = axisc("lint", name + "/machine.json", folder=root, native=True)
        check(there.stdout == here.stdout, "backslashes between folders; reports have /")


def drives(root):
    shutil.copytree(os.path.join(SAMPLES, "mill"), os.path.join(root, "drive"))
    path = "Z:" + os.path.join(root, "drive", "machine.json")
    here = axisc("lint", path, folder="/")
    native = axisc("lint", path[2:], folder="/", native=True)
    check(here.stdout == native.stdout.replace(root.encode(), b"Z:" + root.encode()), "a drive letter")
    check(axisc("lint", path.replace("/", "\\"), folder="/").stdout == here.stdout, "a drive letter and backslashes")
    pattern = axisc("lint", "--cycle-time", "1ms", "drive\\*.lis", folder=root)
    lists = sorted("drive/" + name for name in os.listdir(os.path.join(root, "drive")) if name.endswith(".lis"))
    native = axisc("lint", "--cycle-time", "1ms", *lists, folder=root, native=True)
    check(len(lists) > 1 and pattern.stdout == native.stdout, "*.lis stands for the lists of a folder")
    nothing = axisc("compile", path, "-o", "NUL", "--quiet", folder=root)
    check(nothing.returncode == 0 and not os.path.exists(os.path.join(root, "NUL")), "NUL takes an image and keeps nothing")
    option = axisc("lint", "/nothing", folder=root)
    check(b"/nothing" in option.stderr and b"option" not in option.stderr, "/path is no option")


def line_ends(root):
    path = os.path.join(root, "crlf.lis")
    with open(path, "wb") as file:
        file.write(b"kenngr.achs_typ 1\r\nfilter[0].typ PT1 ( \xfc\r\n")
    shutil.copy(path, os.path.join(root, "native.lis"))
    axisc("lint", "--cycle-time", "1ms", "--fix=all", "crlf.lis", folder=root)
    axisc("lint", "--cycle-time", "1ms", "--fix=all", "native.lis", folder=root, native=True)
    with open(path, "rb") as one, open(os.path.join(root, "native.lis"), "rb") as other:
        fixed = one.read()
        check(fixed == other.read() and b"\r\n" in fixed and b"\r\r" not in fixed, "CRLF and windows-1252 stay")


def held_open(root):
    path = os.path.join(root, "held.axim")
    machine = os.path.join(SAMPLES, "mill", "machine.json")
    axisc("compile", machine, "-o", "held.axim", "--quiet", folder=root)
    with open(path, "rb") as file:
        before = file.read()
    holder = subprocess.Popen(["wine64", HOLD_OPEN, "held.axim", "4000"], cwd=root, env=ENVIRONMENT)
    time.sleep(1.5)
    refused = axisc("compile", os.path.join(SAMPLES, "tutorial", "y.lis"), "--cycle-time", "1ms", "-o", "held.axim", "--quiet", folder=root)
    holder.wait()
    with open(path, "rb") as file:
        after = file.read()
    check(refused.returncode == 2 and refused.stderr.count(b"\n") == 1, f"a file held open: {refused.stderr.decode().strip()}")
    check(before == after, "it stays whole")
    check(not [name for name in os.listdir(root) if name.startswith(".axisc")], "nothing half-written stays")


def keys(root):
    made = axisc("keygen", "key", folder=root)
    check(made.returncode == 0, "a pair of keys")
    signed = axisc("sign", "held.axim", "--key", "key", "-o", "signed.axim", folder=root)
    check(signed.returncode == 0, f"a signature {signed.stderr.decode().strip()}")


def main():
    with tempfile.TemporaryDirectory() as root:
        names(root)
        drives(root)
        line_ends(root)
        held_open(root)
        keys(root)
    sys.exit(failed > 0)


main()
