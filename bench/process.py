#!/usr/bin/env python3
"""Whole processes: one list, a fleet of lists, beside dtc on the same values and an empty static program.

    build/bench/bin/bench_lists --write FOLDER --lists 2000
    bench/process.py --axisc build/static/bin/axisc --fleet FOLDER [--rounds 21] [--many 40000]

Contenders take turns, in rounds; printed are the median of their times and the median of the ratios within the rounds.
One file is measured twice: with one run per turn, which finds the program displaced from the caches by the others, and
with ten, which finds it there, as pipelines do. Nothing stands between the clock and the program but posix_spawn and waitpid.
"""
import argparse
import os
import pathlib
import shutil
import statistics
import subprocess
import tempfile
import time

SILENCE = [(os.POSIX_SPAWN_OPEN, 1, "/dev/null", os.O_WRONLY, 0), (os.POSIX_SPAWN_OPEN, 2, "/dev/null", os.O_WRONLY, 0)]


def run(command):
    """Seconds of one process."""
    begin = time.perf_counter()
    process = os.posix_spawnp(command[0], command, os.environ, file_actions=SILENCE)
    os.waitpid(process, 0)
    return time.perf_counter() - begin


def run_each(commands):
    return sum(run(command) for command in commands)


def run_again(command, count):
    """Seconds of one of several processes in a row, the first left out."""
    run(command)
    return statistics.median(run(command) for _ in range(count))


def compare(title, contenders, rounds):
    """`contenders` is a list of (name, function, files); the first one is what the others are divided by."""
    times = {name: [] for name, _, _ in contenders}
    for _ in range(rounds):
        for name, function, _ in contenders:
            times[name].append(function())
    first = contenders[0][0]
    print(title)
    for name, _, files in contenders:
        ratios = [own / base for own, base in zip(times[name], times[first])]
        middle = statistics.median(times[name])
        print(f"  {name:34} {1e3 * middle:10.2f} ms {1e6 * middle / files:10.1f} us/file  x {statistics.median(ratios):.3f}")


def installed(program, folder):
    """A copy, as installing makes one: what a linker wrote in small pieces is also mapped in small pieces, a tenth of a lint."""
    return shutil.copy(program, folder / f"installed-{pathlib.Path(program).name}")


def empty_program(folder):
    source = folder / "empty.c"
    source.write_text("int main(void) { return 0; }\n")
    program = folder / "empty"
    subprocess.run(["cc", "-O2", "-static", "-o", str(program), str(source)], check=True)
    return [str(installed(program, folder))]


def linked_copies(lists, folder, count):
    """`count` names for the given lists; files of their own would only fill the page cache."""
    for number in range(count):
        place = folder / f"part{number // 1000}"
        place.mkdir(exist_ok=True)
        os.link(lists[number % len(lists)], place / f"{number}.lis")
    return folder


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--axisc", required=True)
    parser.add_argument("--fleet", required=True, type=pathlib.Path)
    parser.add_argument("--rounds", type=int, default=21)
    parser.add_argument("--many", type=int, default=0)
    words = parser.parse_args()
    lists = sorted((words.fleet / "lists").iterdir())
    trees = sorted((words.fleet / "trees").iterdir())
    mistakes = str(sorted((words.fleet / "mistakes").iterdir())[0])
    dtc = ["dtc", "-q", "-O", "dtb", "-o", "/dev/null"]

    with tempfile.TemporaryDirectory(dir=words.fleet) as name:
        folder = pathlib.Path(name)
        lint = [str(installed(words.axisc, folder)), "lint", "--cycle-time", "1ms"]
        empty = empty_program(folder)
        one = {
            "empty static program": empty,
            "axisc lint": lint + ["-j1", str(lists[0])],
            "dtc": dtc + [str(trees[0])],
        }
        wrong = {
            "without mistakes": lint + ["-j1", str(lists[0])],
            "with mistakes, as text": lint + ["-j1", mistakes],
            "with mistakes, as json": lint + ["-j1", "--format", "json", mistakes],
            "with mistakes, as sarif": lint + ["-j1", "--format", "sarif", mistakes],
        }
        for title, commands in ("one file", one), ("one file, a mistake in every line", wrong):
            compare(f"{title}, one by one",
                    [(name, lambda command=command: run(command), 1) for name, command in commands.items()], 5 * words.rounds)
            compare(f"{title}, again and again",
                    [(name, lambda command=command: run_again(command, 10), 1) for name, command in commands.items()],
                    words.rounds)

        few = trees[:200]
        fleet = str(words.fleet / "lists")
        count = len(lists)
        compare(f"{count} files (dtc: {len(few)})", [
            ("axisc lint -j1", lambda: run(lint + ["-j1", fleet]), count),
            ("axisc lint -j2", lambda: run(lint + ["-j2", fleet]), count),
            ("dtc, one process per file", lambda: run_each([dtc + [str(tree)] for tree in few]), len(few)),
        ], max(words.rounds // 4, 3))

        if words.many:
            many = str(linked_copies(lists, folder, words.many))
            compare(f"{words.many} files", [
                ("axisc lint -j1", lambda: run(lint + ["-j1", many]), words.many),
                ("axisc lint -j2", lambda: run(lint + ["-j2", many]), words.many),
            ], 3)


if __name__ == "__main__":
    main()
