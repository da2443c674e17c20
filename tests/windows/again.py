#!/usr/bin/env python3
"""Runs a program of tests, and what fails in it again by itself: on a busy machine wine loses the output or the status
of one program in some hundred or thousand, even of one that only prints a line, and the tests start ten thousand.

    again.py TESTS [FILTER …]
"""
import re
import subprocess
import sys
import xml.etree.ElementTree


def escaped(name):
    """As a filter that means this name alone."""
    return re.sub(r"([\\,\[])", r"\\\1", name)


tests, *filters = sys.argv[1:]
# It ends with the number of names.
listed = subprocess.run([tests, *filters, "--list-test-names-only"], capture_output=True, text=True)
names = listed.stdout.splitlines()
run = subprocess.run([tests, *filters, "-r", "junit"], stdout=subprocess.PIPE)
bad = [
    case.get("name")
    for case in xml.etree.ElementTree.fromstring(run.stdout).iter("testcase")
    if case.find("failure") is not None or case.find("error") is not None
]
# What fails in a section is called "name/section".
failed = [name for name in names if any(one == name or one.startswith(name + "/") for one in bad)]
if not names or bool(run.returncode) != bool(failed):
    sys.exit(f"{tests}: {len(names)} tests, ended with {run.returncode}, of its failures are known: {failed}")
print(f"{len(names)} tests", flush=True)
for _ in range(3):
    if failed:
        print(f"again: {failed}", flush=True)
    failed = [name for name in failed if subprocess.run([tests, escaped(name)]).returncode]
sys.exit(f"failed every time: {failed}" if failed else 0)
