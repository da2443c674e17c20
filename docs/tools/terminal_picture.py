#!/usr/bin/env python3
"""Draws what a command prints to a terminal, colours included, as SVG; compares it with the picture that is there.

    terminal_picture.py [--check] PICTURE.svg COMMAND [ARGUMENT...]

The picture in README.md, which a test compares:
    terminal_picture.py docs/lint.svg build/release/bin/axisc lint samples/mistakes/units.lis --cycle-time 1ms --lang en --color always
"""
import html
import re
import subprocess
import sys

WIDTH, HEIGHT, MARGIN = 8.4, 18, 14
COLOURS = {"31": "#e06c75", "33": "#e5c07b", "36": "#56b6c2", "34": "#61afef", "32": "#98c379"}


def spans(line):
    """Text of one line with the style that holds for it."""
    style = {"fill": "#d7dae0", "weight": "normal"}
    for part in re.split(r"(\x1b\[[0-9;]*m)", line):
        if not part.startswith("\x1b["):
            if part:
                yield dict(style), part
            continue
        for code in part[2:-1].split(";"):
            if code in ("", "0"):
                style = {"fill": "#d7dae0", "weight": "normal"}
            elif code == "1":
                style["weight"] = "bold"
            else:
                style["fill"] = COLOURS.get(code.replace("9", "3", 1) if len(code) == 2 else code, style["fill"])


def picture(command, output):
    shown = ["\x1b[32m$\x1b[0m " + command] + output.rstrip("\n").split("\n")
    plain = [re.sub(r"\x1b\[[0-9;]*m", "", line) for line in shown]
    width = MARGIN * 2 + WIDTH * max(map(len, plain))
    height = MARGIN * 2 + HEIGHT * len(shown)
    out = [f'<svg xmlns="http://www.w3.org/2000/svg" width="{width:.0f}" height="{height:.0f}" '
           f'font-family="DejaVu Sans Mono, Menlo, Consolas, monospace" font-size="14">',
           f'<rect width="100%" height="100%" rx="6" fill="#1e2127"/>']
    for row, line in enumerate(shown):
        column = 0
        for style, text in spans(line):
            out.append(f'<text x="{MARGIN + WIDTH * column:.1f}" y="{MARGIN + HEIGHT * (row + 0.75):.1f}" '
                       f'fill="{style["fill"]}" font-weight="{style["weight"]}" xml:space="preserve" '
                       f'textLength="{WIDTH * len(text):.1f}">{html.escape(text)}</text>')
            column += len(text)
    return "\n".join(out + ["</svg>", ""])


def main():
    arguments = sys.argv[1:]
    check = arguments[0] == "--check"
    target, *command = arguments[check:]
    output = subprocess.run(command, capture_output=True, text=True).stdout
    words = [word for word in command if word not in ("--color", "always")]
    words[0] = words[0].rsplit("/", 1)[-1]
    drawn = picture(" ".join(words), output)
    if check:
        with open(target, encoding="utf-8") as file:
            if file.read() != drawn:
                sys.exit(f"{target} is not what the command prints; without --check it is drawn again")
        return
    with open(target, "w", encoding="utf-8") as file:
        file.write(drawn)


main()
