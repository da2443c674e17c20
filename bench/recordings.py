#!/usr/bin/env python3
"""axisc compare on a recording of 100 MB, and its reader alone, beside numpy.loadtxt and wc -l on the same file.

    bench/recordings.py AXISC [REPETITIONS]

Needs numpy. Prints seconds (best of the repetitions, in turns) and the largest memory of each.
"""
import os
import pathlib
import subprocess
import sys
import tempfile
import time

SIZE = 100_000_000
LIST = "kenngr.achs_typ 1\nfilter_fir.enable 1\nfilter_fir.type 1\nfilter_fir.order 41\nfilter_fir.share 100\nEnde\n"


def write_recording(path):
    """A random walk of velocities behind 43 taps in 0.1 µm, with times, and 0.1 % of the rows lost."""
    import numpy as np
    rng = np.random.default_rng(1)
    cycles = SIZE // 16
    x = np.cumsum(np.repeat(rng.integers(-250, 251, cycles // 200 + 1), 200)[:cycles])
    sums = np.cumsum(np.r_[np.full(43, x[0]), x].astype(float))
    y = np.rint((sums[43:] - sums[:-43]) / 43).astype(np.int64)
    kept = np.flatnonzero(rng.random(cycles) > 0.001)
    with path.open("w") as out:
        out.write("time\tsetpoint\tfiltered\n")
        while out.tell() < SIZE:
            if not len(kept):
                sys.exit("too few rows")
            part, kept = kept[:100_000], kept[100_000:]
            out.write("".join(f"{n}.0\t{a}\t{b}\n" for n, a, b in zip(part, x[part], y[part])))


def measure(command, cwd, expected=0):
    """Seconds and MB."""
    begin = time.perf_counter()
    child = subprocess.Popen(command, cwd=cwd, stdout=subprocess.DEVNULL,
                             stderr=subprocess.DEVNULL if expected else None)
    _, status, usage = os.wait4(child.pid, 0)
    if os.waitstatus_to_exitcode(status) != expected:
        sys.exit(f"{command} failed")
    return time.perf_counter() - begin, usage.ru_maxrss / 1000


def main():
    if sys.argv[1] == "--write":
        return write_recording(pathlib.Path(sys.argv[2]))
    axisc, repetitions = os.path.abspath(sys.argv[1]), int(sys.argv[2]) if len(sys.argv) > 2 else 3
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        (folder / "x.lis").write_text(LIST)
        # In a process of its own: a child's largest memory begins with that of its parent.
        subprocess.run([sys.executable, __file__, "--write", folder / "scope.csv"], check=True)
        load = "import numpy; numpy.loadtxt('scope.csv', delimiter='\\t', skiprows=1)"
        compare = [axisc, "compare", "x.lis", "scope.csv", "--cycle-time", "1ms"]
        # A column that is not there is refused when all of the recording has been read.
        reader = "axisc's reader"
        contenders = {"axisc compare": compare,
                      reader: compare + ["--in", "nothing"],
                      "numpy.loadtxt": [sys.executable, "-c", load],
                      "wc -l": ["wc", "-l", "scope.csv"]}
        best = {}
        for _ in range(repetitions):
            for what, command in contenders.items():
                seconds, memory = measure(command, folder, 2 if what == reader else 0)
                best[what] = min(best.get(what, (1e9, 0)), (seconds, memory))
        own = best["axisc compare"][0]
        print(f"{(folder / 'scope.csv').stat().st_size / 1e6:.0f} MB")
        for what, (seconds, memory) in best.items():
            print(f"{what}: {seconds:.2f} s ({seconds / own:.2f}), {memory:.0f} MB")


if __name__ == "__main__":
    main()
