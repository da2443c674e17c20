#!/usr/bin/env python3
"""Links of the documents lead to files and headings that are there: links.py SOURCES. Addresses elsewhere are not looked at."""
import functools
import pathlib
import re
import sys
import urllib.parse

SOURCES = pathlib.Path(sys.argv[1]).resolve()
LEFT_OUT = {"build", "node_modules", ".git", "data", "golden"}


def documents(folder):
    for path in sorted(folder.iterdir()):
        if path.is_dir() and not path.is_symlink() and path.name not in LEFT_OUT:
            yield from documents(path)
        elif path.suffix == ".md":
            yield path


def prose(path):
    """Numbered lines, without blocks of code and code in running text."""
    fence = None
    for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
        mark = re.match(r"\s*(```+|~~~+)", line)
        if mark and fence in (None, mark[1]):
            fence = None if fence else mark[1]
        elif not fence:
            yield number, line


@functools.cache
def anchors(path):
    """Of headings, as GitHub makes them, and those that are written out."""
    found, seen = set(), {}
    for _, line in prose(path):
        found |= set(re.findall(r'<a (?:id|name)="([^"]+)"', line))
        if heading := re.match(r"#{1,6} +(.*?)[ #]*(?:\{#([\w-]+)\})?$", line):
            text = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", heading[1])
            slug = re.sub(r"[^\w\- ]", "", text.lower()).strip().replace(" ", "-")
            found |= {f"{slug}-{seen[slug]}" if slug in seen else slug, *filter(None, [heading[2]])}
            seen[slug] = seen.get(slug, 0) + 1
    return found


def complaint(path, target):
    file, _, anchor = urllib.parse.unquote(target).partition("#")
    # What `axisc explain` prints is written as if it were in docs/.
    folder = SOURCES / "docs" if {"rules", "help"} & set(path.parts) else path.parent
    place = (folder / file).resolve() if file else path
    if not place.exists():
        return "there is no such file"
    if not place.is_relative_to(SOURCES):
        return "outside the sources"
    if anchor and place.suffix == ".md" and anchor.lower() not in {name.lower() for name in anchors(place)}:
        return f"{place.name} has no such heading"
    return None


wrong, links = [], 0
for document in documents(SOURCES):
    for number, line in prose(document):
        words = re.sub(r"`[^`]*`", "``", line)
        for target in re.findall(r"\]\(([^)\s]+)\)|^\[[^\]]+\]: (\S+)", words):
            target = target[0] or target[1]
            if re.match(r"[a-z]+:", target):
                continue
            links += 1
            if why := complaint(document, target):
                wrong.append(f"{document.relative_to(SOURCES)}:{number}: {target}: {why}")
print("\n".join(wrong) or f"{links} links lead somewhere")
assert links > 300, links
sys.exit(1 if wrong else 0)
