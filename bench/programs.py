#!/usr/bin/env python3
"""How long `simulate` takes for long NC programs, and how much memory: programs.py AXISC [BLOCKS]"""
import math
import os
import random
import subprocess
import sys
import tempfile
import time

PROGRAM = os.path.abspath(sys.argv[1])
BLOCKS = int(sys.argv[2]) if len(sys.argv) > 2 else 100_000
MILL = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "samples", "mill", "machine.json")


def lines(random_numbers):
    """Straight blocks of about 1 mm in any direction."""
    x = y = 0.0
    for _ in range(BLOCKS):
        angle = random_numbers.uniform(0, math.tau)
        x, y = x + math.cos(angle), y + math.sin(angle)
        yield f"G01 X{x:.3f} Y{y:.3f}"


def arcs(random_numbers):
    """Half circles of up to 1 mm radius that follow one another tangentially."""
    x = 0.0
    for number in range(BLOCKS):
        radius = round(random_numbers.uniform(0.2, 1), 3)
        x += 2 * radius
        yield f"G0{2 + number % 2} X{x:.3f} Y0 I{radius:.3f} J0"


def circles(random_numbers):
    """Full circles of up to 1 mm radius, all through one point."""
    for _ in range(BLOCKS):
        yield f"G02 I{random_numbers.uniform(0.2, 1):.3f} J0"


def waves(_):
    """A free-form curve in blocks of 0.5 mm, as a CAM system writes it."""
    for number in range(BLOCKS):
        x = 0.5 * number
        yield f"G01 X{x:.3f} Y{5 * math.sin(x / 10):.4f} Z{math.cos(x / 7):.4f}"


def loop(_):
    """The same number of blocks from a loop of three lines."""
    yield f"$FOR P1 = 1, {BLOCKS}, 1"
    yield "X[P1 / 2] Y[10 * SIN[P1]]"
    yield "$ENDFOR"


def measure(path):
    begin = time.perf_counter()
    process = subprocess.Popen([PROGRAM, "simulate", MILL, "--program", path], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
    errors = process.stderr.read().decode()
    _, status, usage = os.wait4(process.pid, 0)
    if status not in (0, 256):
        sys.exit(f"{path}: {errors}")
    return time.perf_counter() - begin, usage.ru_maxrss / 1024


with tempfile.TemporaryDirectory() as folder:
    print(f"{BLOCKS} blocks    s  ms/1000 blocks   MB")
    for kind in (lines, arcs, circles, waves, loop):
        path = f"{folder}/{kind.__name__}.nc"
        with open(path, "w", encoding="ascii") as file:
            file.write("%PROGRAM\nG00 X0 Y0 Z0\n#FILTER ON [ORDER=40]\nG01 F4000\n")
            file.writelines(block + "\n" for block in kind(random.Random(1)))
            file.write("M30\n")
        seconds, megabytes = measure(path)
        print(f"{kind.__name__:12} {seconds:6.2f} {1e6 * seconds / BLOCKS:8.2f} {megabytes:10.1f}", flush=True)
