#!/usr/bin/env python3
"""What Python costs beside C: measure.py BUILD_TREE. Processor time, best of the repetitions.

Needs the targets axisc, libaxisc, axisrt and axisrt_shared; blocks of numpy are left out where there is no numpy.
"""
import array
import importlib.util
import os
import pathlib
import subprocess
import sys
import tempfile
import time

BUILD = pathlib.Path(sys.argv[1]).resolve()
SOURCE = pathlib.Path(__file__).resolve().parents[2]
sys.path[:0] = [str(SOURCE / "python"), str(SOURCE / "bench")]
os.environ["AXISC_LIBRARIES"] = str(BUILD / "lib")
sys.argv[1:] = [str(BUILD / "bin" / "axisc")]
import axisc  # noqa: E402
import editor  # noqa: E402

CYCLES, REPETITIONS, LINES = 1_000_000, 7, 326
FINDINGS = """
import time
begin = time.process_time(), time.perf_counter()
import axisc
findings = axisc.open({path!r}).check()
print((time.process_time() - begin[0]) * 1e3, (time.perf_counter() - begin[1]) * 1e3, len(findings))
"""


def in_python(image, block):
    """The quickest of as many repetitions as in C."""
    runtime = axisc.Runtime(image)
    times = []
    for _ in range(REPETITIONS):
        runtime.reset(None, 0.0)
        begin = time.process_time()
        runtime.run(block)
        times.append(time.process_time() - begin)
        assert runtime.status == "AXISRT_OK"
    return min(times)


def runtime(folder):
    image = axisc.open(SOURCE / "samples" / "mill").compile()
    (folder / "mill.axim").write_bytes(image)
    examples, include = SOURCE / "examples", SOURCE / "runtime" / "include"
    subprocess.run(["cc", "-O2", "-std=c11", f"-I{include}", f"-I{examples}", SOURCE / "bench/python/steps.c", examples / "image_file.c",
                    BUILD / "runtime" / "libaxisrt.a", "-o", folder / "steps"], check=True)
    axes = len(axisc.Runtime(image).axes)
    values = array.array("d", (i % 1009 for i in range(CYCLES * axes)))
    blocks = {"array.array": values}
    if importlib.util.find_spec("numpy"):
        import numpy

        blocks["numpy"] = numpy.array(values).reshape(-1, axes)
    done = subprocess.run([folder / "steps", folder / "mill.axim", str(CYCLES), str(REPETITIONS)], check=True, capture_output=True, text=True)
    in_c = min(float(line) for line in done.stdout.split())
    print(f"{CYCLES} cycles of {axes} axes: C {in_c * 1e3:.1f} ms")
    for name, block in blocks.items():
        seconds = in_python(image, block)
        print(f"  Runtime.run, {name}: {seconds * 1e3:.1f} ms, {seconds / in_c:.2f} times")


def findings(folder):
    editor.LINES = LINES
    editor.machine(str(folder))
    script = FINDINGS.format(path=str(folder))
    environment = {**os.environ, "PYTHONPATH": str(SOURCE / "python")}
    rows = []
    for _ in range(4 * REPETITIONS):
        done = subprocess.run([sys.executable, "-c", script], check=True, capture_output=True, text=True, env=environment)
        rows.append([float(word) for word in done.stdout.split()])
    rows.sort()
    print(f"import axisc to {rows[0][2]:.0f} findings of 16 axes with lists of {LINES} lines:")
    print(f"  processor time {rows[0][0]:.1f} to {rows[-1][0]:.1f} ms; clock at best {min(row[1] for row in rows):.1f} ms")


with tempfile.TemporaryDirectory() as name:
    (pathlib.Path(name) / "machine").mkdir()
    findings(pathlib.Path(name) / "machine")
    runtime(pathlib.Path(name))
