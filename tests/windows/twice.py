#!/usr/bin/env python3
"""Runs a program of tests, and what fails in it once more by itself: wine fails to start or to end about one program
in ten thousand, even one that only prints a line, and the tests start some ten thousand.

    twice.py TESTS [FILTER …]
"""
import re
import subprocess
import sys
import xml.etree.ElementTree

tests, *filters = sys.argv[1:]
# It ends with the number of names.
names = subprocess.run([tests, *filters, "--list-test-names-only"], capture_output=True, text=True).stdout.splitlines()
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
print(f"{len(names)} tests, once more: {failed}", flush=True)
sys.exit(max((subprocess.run([tests, re.sub(r"([\\,\[])", r"\\\1", name)]).returncode for name in failed), default=0))
