#!/usr/bin/env python3
"""Presses TAB in real shells and looks at what they complete: completions.py SHARE."""
import os
import pty
import select
import shutil
import subprocess
import sys
import tempfile
import time

SHARE = os.path.abspath(sys.argv[1])
STUB = "axisc() { printf '<%s>' \"$@\"; echo; }\n"
# What is typed, and what the program is then called with.
LINES = [
    ("axisc expl\tAX1001", "<explain><AX1001>"),
    ("axisc lint --stat\t", "<lint><--statistics>"),
    ("axisc lint --format sa\t", "<lint><--format><sarif>"),
    ("axisc lint --format=gitl\t", "<lint><--format=gitlab>"),
    ("axisc --lang de plot --kind cor\t", "<--lang><de><plot><--kind><corner>"),
    ("axisc lint --kind zero\t", "<lint><--kind><zero_offset>"),
    ("axisc run --port inter\t", "<run><--port><interface>"),
    ("axisc schema pl\t", "<schema><plant>"),
    ("axisc help cont\t", "<help><contour>"),
    ("axisc lint ach\t", "<lint><achsen.lis>"),
    ("axisc lint --baseline ach\t", "<lint><--baseline><achsen.lis>"),
    ("axisc compile --output-folder ord\t", "<compile><--output-folder><ordner"),
]


def bash(folder):
    path = f"{folder}/bash.rc"
    with open(path, "w", encoding="utf-8") as out:
        out.write(STUB + f"source '{SHARE}/bash-completion/completions/axisc'\nPS1='$ '\n")
    return ["bash", "--noprofile", "--rcfile", path, "-i"]


def zsh(folder):
    with open(f"{folder}/.zshrc", "w", encoding="utf-8") as out:
        out.write(f"fpath=('{SHARE}/zsh/vendor-completions' $fpath)\nautoload -U compinit\ncompinit -u -D\n{STUB}PS1='$ '\n"
                  "unsetopt zle_bracketed_paste 2>/dev/null\nunset zle_bracketed_paste\n")
    return ["zsh", "-i"]


def press(shell, folder, typed, expected):
    """Types the line in the shell; gives what the shell showed."""
    child, terminal = pty.fork()
    if child == 0:
        os.chdir(f"{folder}/plant")
        environment = {"PATH": "/usr/bin:/bin", "HOME": folder, "ZDOTDIR": folder, "TERM": "dumb", "LANG": "C.UTF-8"}
        os.execvpe(shell[0], shell, environment)
    shown = ""
    sent = False
    until = time.monotonic() + 60
    while expected not in shown and time.monotonic() < until:
        if not select.select([terminal], [], [], 1)[0]:
            continue
        try:
            shown += os.read(terminal, 65536).decode(errors="replace")
        except OSError:
            break
        if not sent and "$ " in shown:
            os.write(terminal, (typed + "\r").encode())
            sent = True
    os.close(terminal)
    os.waitpid(child, 0)
    return shown


def fish(folder, typed):
    word = typed.rstrip("\t")
    script = f"source '{SHARE}/fish/vendor_completions.d/axisc.fish'; cd '{folder}/plant'; complete -C '{word}'"
    return subprocess.run(["fish", "-N", "-c", script], capture_output=True, text=True, check=True,
                          env={"PATH": "/usr/bin:/bin", "HOME": folder}).stdout


def main():
    mistakes = 0
    with tempfile.TemporaryDirectory() as folder:
        os.makedirs(f"{folder}/plant/ordner")
        with open(f"{folder}/plant/achsen.lis", "w", encoding="utf-8"):
            pass
        for name, start in (("bash", bash), ("zsh", zsh)):
            if not shutil.which(name):
                print(f"{name} is not installed: not tried")
                continue
            shell = start(folder)
            for typed, expected in LINES:
                shown = press(shell, folder, typed, expected)
                if expected not in shown:
                    print(f"{name}: {typed!r} does not give {expected}: {shown!r}")
                    mistakes += 1
            print(f"{name}: {len(LINES)} lines")
        if not shutil.which("fish"):
            print("fish is not installed: not tried")
            return mistakes
        for typed, expected in LINES:
            # Words after the key are no matter of completion.
            typed = typed[:typed.index("\t")]
            wanted = [word for word in expected.strip("<>").split("><") if word.startswith(typed.split(" ")[-1])][0]
            offered = [line.split("\t")[0].rstrip("/") for line in fish(folder, typed).splitlines()]
            if offered != [wanted]:
                print(f"fish: {typed!r} does not give {wanted}: {offered}")
                mistakes += 1
        print(f"fish: {len(LINES)} lines")
    return mistakes


sys.exit(1 if main() else 0)
