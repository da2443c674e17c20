#!/usr/bin/env python3
"""The table of commands in docs/README.md has those of the program: commands.py AXISC SOURCES."""
import re
import subprocess
import sys

AXISC, SOURCES = sys.argv[1:]
said = subprocess.run([AXISC, "--help", "--lang", "en"], capture_output=True, text=True, check=True).stdout
known = set(re.findall(r"^  ([a-z]+)  ", said.split("Commands:")[1].split("Options:")[0], re.MULTILINE))
with open(f"{SOURCES}/docs/README.md", encoding="utf-8") as file:
    table = file.read().split("## Commands")[1]
listed = {word for cell in re.findall(r"^\| (`[^|]*) \|", table, re.MULTILINE) for word in re.findall(r"`([a-z]+)`", cell)}
assert len(known) > 20 and listed == known, f"docs/README.md and axisc --help differ: {sorted(listed ^ known)}"
print(f"{len(known)} commands")
