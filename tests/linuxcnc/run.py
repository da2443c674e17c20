#!/usr/bin/env python3
"""The component axisrt in LinuxCNC. Usage: run.py AXISC FOLDER_FOR_FILES"""
import json
import math
import os
import re
import shutil
import subprocess
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
EXAMPLE = os.path.join(HERE, "../../examples/linuxcnc")
AXISC, FOLDER = os.path.abspath(sys.argv[1]), sys.argv[2]
SCALE = 2.0**80


def axisc(*words):
    return subprocess.run([AXISC, *words], check=True, capture_output=True, text=True).stdout


def hal(script, **names):
    """Runs a HAL script; its output, whatever the status."""
    environment = dict(os.environ, **names)
    done = subprocess.run(["halrun", script], capture_output=True, text=True, timeout=200, env=environment, cwd=FOLDER)
    return done.returncode, done.stdout + done.stderr


def check(holds, text):
    print(("ok    " if holds else "FAIL  ") + text, flush=True)
    check.failed += not holds


check.failed = 0


def image_of(machine):
    path = os.path.join(FOLDER, os.path.basename(machine).replace(".json", ".axim"))
    axisc("compile", machine, "-o", path, "--quiet")
    return path


def stream(cycles=100000, switched=40000):
    """Setpoints of a Lissajous figure with a stop, in whole and broken units; the FIR filters are switched on in motion."""
    image = image_of(HERE + "/fast.json")
    rows = []
    for n in range(cycles):
        t = n * 1e-4 if n < cycles // 2 else cycles // 2 * 1e-4
        rows.append((50000 * math.sin(7 * t), 33333.3 * math.sin(11 * t) + 1e-3 * n, 250.25 * t))
    commands, setpoints = os.path.join(FOLDER, "commands"), os.path.join(FOLDER, "setpoints.csv")
    with open(commands, "w") as file:
        for n, row in enumerate(rows):
            file.write(" ".join(f"{value * SCALE:.17g}" for value in row) + f" {int(n >= switched)}\n")
    with open(setpoints, "w") as file:
        file.write("X,Y,Z\n")
        file.writelines(",".join(repr(value) for value in row) + "\n" for row in rows)
    filtered = os.path.join(FOLDER, "filtered")
    _, said = hal(os.path.join(HERE, "stream.hal"), IMAGE=image, COMMANDS=commands, FILTERED=filtered, CYCLES=str(cycles))
    # The runtime of the component begins at its first setpoint.
    wanted = axisc("run", image, "--input", setpoints, "--level", "auto", "--at", f"{switched}:#FILTER ON").split("\n")[1:-1]
    with open(filtered) as file:
        got = [line.split() for line in file]
    same = sum(
        [float(value) for value in row[:3]] == [float(value) * SCALE for value in line.split(",")]
        for row, line in zip(got, wanted)
    )
    check(len(got) == cycles == len(wanted), f"{len(got)} of {cycles} cycles of 100 µs were sampled")
    check(all(row[3] == "0" for row in got), "no cycle came without a setpoint")
    check(same == cycles, f"{same} of {cycles} cycles are those of axisc run, bit for bit")
    cost = re.search(r"axisrt\.update\.tmax.*|.*axisrt\.update\.tmax", said)
    print("      " + (cost.group(0).strip() if cost else said[-300:]))


def simulate(program, acceleration):
    """Commanded and filtered X and Y of a G-code program on the machine of the example, in mm."""
    image_of(EXAMPLE + "/machine.json")
    shutil.copy(os.path.join(EXAMPLE, "simulated.hal"), FOLDER)
    ini, samples = os.path.join(FOLDER, "simulated.ini"), os.path.join(FOLDER, "samples")
    with open(os.path.join(EXAMPLE, "simulated.ini")) as template, open(ini, "w") as file:
        text = template.read().replace("DISPLAY = axis", f"DISPLAY = {HERE}/drive.py")
        file.write(re.sub("MAX_ACCELERATION = .*", f"MAX_ACCELERATION = {acceleration}", text))
    for name in ("simulated.var", "simulated.tbl", "samples"):
        with open(os.path.join(FOLDER, name), "w"):
            pass
    environment = dict(os.environ, PROGRAM=os.path.join(HERE, program), SAMPLES=samples)
    done = subprocess.run(["linuxcnc", "-r", ini], capture_output=True, text=True, timeout=200, env=environment, cwd=FOLDER)
    with open(samples) as file:
        rows = [[float(value) for value in line.split()] for line in file if "overrun" not in line]
    if not rows:
        print(done.stdout[-2000:], done.stderr[-2000:])
    return rows


def predicted(feed):
    words = ["contour", EXAMPLE + "/machine.json", "--feed", str(feed), "--radius", "10", "--format", "json"]
    return json.loads(axisc(*words))["groups"][0]


def circle():
    rows = simulate("circle.ngc", 10000)
    step = [math.dist(row[:2], before[:2]) for before, row in zip(rows, rows[1:])]
    turning = [row for row, length in zip(rows[1:], step) if abs(length - 0.05) < 1e-4 and abs(math.hypot(*row[:2]) - 10) < 1e-3]
    # The second of three turns: away from where the path velocity changes.
    middle = turning[len(turning) * 2 // 5 : len(turning) * 3 // 5]
    measured = 1000 * (10 - sum(math.hypot(row[2], row[3]) for row in middle) / max(len(middle), 1))
    wanted = predicted(3000)["circle"]["contour_deviation_um"]
    check(abs(measured / wanted - 1) < 0.02, f"circle of 10 mm at 3000 mm/min, {len(middle)} cycles: {measured:.3f} µm inside, predicted {wanted:.3f} µm")
    tested_circle(rows, wanted)


def tested_circle(rows, wanted):
    """The circular test of the sampled positions: to the six decimals of a millimetre that samples have."""
    recording = os.path.join(FOLDER, "circle.csv")
    with open(recording, "w") as file:
        file.write("time [ms];X setpoint;Y setpoint;X actual;Y actual\n")
        file.writelines(";".join([str(n), *(f"{value:.6f}" for value in row[:4])]) + "\n" for n, row in enumerate(rows))
    answer = json.loads(axisc("circle", EXAMPLE + "/machine.json", recording, "--format", "json"))
    figures = answer["circles"][0]["recording"]
    radial = figures["radial_deviation_um"]
    text = f"{figures['points_per_turn']} points, F {radial['min']:.3f} to {radial['max']:.3f} µm, contour {-wanted:.3f} µm"
    check(max(abs(radial["max"] + wanted), abs(radial["min"] + wanted)) < 0.01, "circular test: " + text)


def corner():
    rows = simulate("square.ngc", 1e7)
    near = min(math.hypot(row[2] - 30, row[3]) for row in rows) if rows else 0
    wanted = predicted(3000)["contour_deviation_um"]
    check(abs(1000 * near / wanted - 1) < 0.02, f"corner at 3000 mm/min: {1000 * near:.1f} µm, predicted {wanted:.1f} µm")


def braked():
    """With an acceleration that brakes before the corner: what the runtime makes of the sampled commands."""
    rows = simulate("square.ngc", 508)
    setpoints = os.path.join(FOLDER, "sampled.csv")
    with open(setpoints, "w") as file:
        file.write("X,Y\n")
        file.writelines(f"{1e4 * row[0]!r},{1e4 * row[1]!r}\n" for row in rows)
    output = axisc("run", os.path.join(FOLDER, "machine.axim"), "--input", setpoints, "--at", "0:#FILTER ON").split("\n")[1:-1]
    worst = 0.0
    for row, line in zip(rows, output):
        x, y = (float(value) for value in line.split(",")[:2])
        worst = max(worst, abs(row[2] - x / 1e4), abs(row[3] - y / 1e4))
    # Samples have six decimals of a millimetre.
    check(len(rows) > 1000 and worst < 1.1e-6, f"square with 508 mm/s²: {len(rows)} cycles within {worst * 1e6:.2f} nm of axisc run")


def refused():
    image = image_of(EXAMPLE + "/machine.json")
    with open(image, "rb") as file:
        bytes_ = file.read()
    with open(os.path.join(FOLDER, "damaged.axim"), "wb") as file:
        file.write(bytes_[:1000] + bytes([bytes_[1000] ^ 1]) + bytes_[1001:])
    with open(os.path.join(FOLDER, "short.axim"), "wb") as file:
        file.write(bytes_[:40])
    for words, reason in (
        ("image=nowhere.axim period=1000000", "cannot be read"),
        ("image=damaged.axim period=1000000", "AXISRT_WRONG_CHECKSUM"),
        ("image=short.axim period=1000000", "AXISRT_TOO_SHORT"),
        ("image=machine.axim period=500000", "AXISRT_OTHER_CYCLE_TIME"),
        ("image=machine.axim", "are needed"),
    ):
        script = os.path.join(FOLDER, "refused.hal")
        with open(script, "w") as file:
            file.write(f"loadrt axisrt {words}\n")
        code, said = hal(script)
        check(code != 0 and reason in said, f"loadrt axisrt {words}: {reason}")


def other_period():
    image_of(EXAMPLE + "/machine.json")
    script = os.path.join(FOLDER, "period.hal")
    with open(script, "w") as file:
        file.write(
            "loadrt threads name1=servo period1=2000000\nloadrt axisrt image=machine.axim period=1000000\n"
            "setp axisrt.0.in 12.5\naddf axisrt.update servo\nstart\nloadusr -w sleep 1\n"
            "loadusr -w halcmd getp axisrt.fault\nloadusr -w halcmd getp axisrt.0.out\n"
        )
    _, said = hal(script)
    check("TRUE" in said and "12.5" in said, "a thread with another period: fault, and setpoints pass")
    check("nothing is filtered" in said, "and it says why")


def scales():
    """Scales that cannot be divided by pass the command, and one that changes moves nothing."""
    image_of(EXAMPLE + "/machine.json")
    script = os.path.join(FOLDER, "scale.hal")
    with open(script, "w") as file:
        file.write(
            "loadrt threads name1=servo period1=1000000\nloadrt axisrt image=machine.axim period=1000000\n"
            "setp axisrt.0.in 12.5\nsetp axisrt.1.in 12.5\nsetp axisrt.filter-on 1\naddf axisrt.update servo\nstart\n"
            "setp axisrt.0.scale 0\nsetp axisrt.1.scale 254000\nloadusr -w sleep 1\n"
            "loadusr -w halcmd getp axisrt.0.out\nloadusr -w halcmd getp axisrt.0.status\nloadusr -w halcmd getp axisrt.1.out\n"
        )
    _, said = hal(script)
    words = said.split()[:3]
    check(words[:2] == ["12.5", "23"], "a scale of 0: the command passes with AXISRT_BAD_ARGUMENT")
    check(words[2:] == ["12.5"], "another scale: the position stays")


def main():
    refused()
    scales()
    other_period()
    stream()
    circle()
    corner()
    braked()
    sys.exit(check.failed > 0)


main()
