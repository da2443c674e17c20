#!/usr/bin/env python3
"""Recordings of a control that reads the parameters in a known way, made without axisc's arithmetic.

    recordings.py AXISC FOLDER [MACHINES [SEED]]
    recordings.py --store FOLDER                     the recordings that the tests read, and the sample

The first makes MACHINES random machines (1000) in FOLDER, runs `axisc compare` on each and counts how often the right reading is
named, how often none is, and how often a wrong one. Every fifth control has no reading at all: it filters once more. Ends
with 1 where a wrong one was named for certain, where one was named alone though the recording rules it out or another one explains the
recording as well (looked at for every fourth machine), or where the right one was named in less than 99 % of the recordings that can
tell: those with jumps of the setpoint or of its velocity that do not look the same behind filters in another reading.
Needs numpy.
"""
import json
import pathlib
import subprocess
import sys

import numpy as np
from control import (ALLPASS, AVERAGE, BANDSTOP, BESSEL, BUTTERWORTH, CRITICAL_DAMPING, CYCLE_READINGS, GAUSSIAN,
                     LOWPASS, NOVIB, PT1, PT2, SINC, T, computed, filter_readings, is_lag, kernel_readings)

ALL_FILTER_READINGS = {"listed", "no-prewarping", "backward-euler", "forward-euler", "matched", "matched-poles", "impulse-invariant",
                       "step-invariant", "half-gain-at-frequency", "poles-at-frequency", "analogue-quality",
                       "quality-of-poles", "bessel-delay", "allpass-phase", "filters-off"}
LISTED = {"filter": "listed", "kernel": "listed"}
UNTOLD = ("smooth", "alike", "outside")  # recordings that need not tell a reading


def motion(rng, excitation, cycles=4000):
    """Setpoints in 0.1 µm: moves at constant velocity with sharp changes, or one slow and smooth move."""
    if excitation == "smooth":
        return 2000 * (1 - np.cos(np.pi * np.arange(cycles) / cycles)) / 2
    if excitation == "planned":
        return planned(rng, cycles)
    velocity = np.zeros(cycles)
    at = 100
    while at < cycles - 400:
        length = int(rng.integers(60, 400))
        velocity[at:at + length] = rng.uniform(-250, 250)
        at += length + int(rng.integers(0, 2)) * int(rng.integers(50, 300))
    position = np.cumsum(velocity)
    if excitation == "step":
        for _ in range(4):
            position[int(rng.integers(min(200, cycles // 4), cycles - 400)):] += 10000
    return position


def planned(rng, cycles):
    """Moves of a planner that gives out whole units: each accelerates, travels and brakes."""
    steps = [0.0] * 100
    while len(steps) < cycles - 400:
        top, acceleration = rng.uniform(20, 200), rng.uniform(4, 40)
        up = np.minimum(top, acceleration * np.arange(1, int(np.ceil(top / acceleration)) + 1))
        move = np.r_[up, np.full(int(rng.integers(60, 400)), top), up[::-1], np.zeros(int(rng.integers(20, 200)))]
        steps += list(move * rng.choice([-1, 1]))
    return np.round(np.cumsum(np.r_[steps, np.zeros(max(0, cycles - len(steps)))]))[:cycles]


def machine(rng):
    chosen = {"filter": None, "kernel": None}
    of = rng.integers(0, 3)
    if of != 1:
        kind = int(rng.choice([LOWPASS, LOWPASS, BANDSTOP, BANDSTOP, ALLPASS, PT1, PT2]))
        chosen["filter"] = {"type": kind, "order": int(rng.integers(1, 4 if kind == BANDSTOP else 5)), "fg": round(float(rng.uniform(8, 120)), 1),
                            "prototype": int(rng.choice([CRITICAL_DAMPING, BUTTERWORTH, BESSEL])),
                            "quality": round(float(rng.uniform(1, 6)), 2), "tau": int(rng.integers(1500, 20000)) * 1e-6}
    if of != 0:
        chosen["kernel"] = {"type": int(rng.choice([AVERAGE, GAUSSIAN, SINC, NOVIB])), "order": int(rng.integers(7, 120)),
                            "quality": round(float(rng.uniform(0.4, 1)), 2), "share": int(rng.choice([100, 100, 80, 60])),
                            "fcut": round(float(rng.uniform(5, 60)), 1), "fg": round(float(rng.uniform(12, 60)), 1)}
    readings = dict(LISTED)
    if rng.random() < 0.7:
        readings["filter"] = str(rng.choice(filter_readings(chosen["filter"])))
    if rng.random() < 0.7:
        readings["kernel"] = str(rng.choice(kernel_readings(chosen["kernel"])))
    if rng.random() < 0.1:
        readings = {**LISTED, "cycle": str(rng.choice(list(CYCLE_READINGS)))}
    return chosen, readings


def list_text(chosen):
    lines = ["kenngr.achs_typ 1"]
    k = chosen["kernel"]
    is_hsc = k is not None and k["type"] == NOVIB
    if is_hsc:  # always the first one
        lines += ["filter[0].enable 0", "filter[0].prototype HSC", "filter[0].type 12", "filter[0].order 1", f"filter[0].fg_f0 {k['fg']}",
                  f"filter[0].share_percent {k['share']}"]
    if chosen["filter"]:
        f = chosen["filter"]
        name = "filter[1]" if is_hsc else "filter[0]"
        lines += [f"{name}.enable 1", f"{name}.type {f['type']}", f"{name}.share_percent 100"]
        if is_lag(f):
            lines += [f"{name}.order {1 if f['type'] == PT1 else 2}", f"{name}.time_constant {round(f['tau'] * 1e6)}"]
        else:
            lines += [f"{name}.prototype {f['prototype']}", f"{name}.order {f['order']}", f"{name}.fg_f0 {f['fg']}",
                      f"{name}.guete {f['quality']}"]
    if k is not None and not is_hsc:
        lines += ["filter_fir.enable 1", f"filter_fir.type {k['type']}", f"filter_fir.order {k['order']}",
                  f"filter_fir.share {k['share']}", f"filter_fir.quality {k['quality']}", f"filter_fir.fcut {k['fcut']}"]
    return "\n".join(lines + ["Ende", ""])


def recording_text(rng, setpoints, answer, shift, lost=0.001):
    """As TwinCAT Scope exports it: a pair of time and value a signal, milliseconds, decimal commas, EOF."""
    answer = np.r_[np.full(shift, answer[0]), answer[:len(answer) - shift]]
    rows = ["Name\tRecording", "", "Time\tsetpoint\tTime\tfiltered"]
    for n, (x, y) in enumerate(zip(np.round(setpoints), np.round(answer))):
        if n > 0 and rng.random() < lost:
            continue
        rows.append(f"{n},0\t{int(x)}\t{n},0\t{int(y)}")
    return "\n".join(rows + ["EOF", ""])


def same_but_delayed(one, other):
    """Whether answers to a jump agree but for whole cycles, which no recording can tell: of a jump by 1 mm, 0.03 µm are less than the
    half unit that is rounded off."""
    n = len(one)
    return any(np.abs(one[max(0, d):n + min(0, d)] - other[max(0, -d):n - max(0, d)]).max() < 3e-5 for d in range(-8, 9))


def jump_answer(chosen, readings):
    return computed(chosen, readings, np.r_[np.zeros(20), np.ones(2500)])


def right(chosen, readings, named):
    """Whether what is named computes what was made, but for whole cycles."""
    if len(named) == 1 and named[0] in CYCLE_READINGS:
        told = {**LISTED, "cycle": named[0]}
    else:
        filters = [n for n in named if n in ALL_FILTER_READINGS]
        kernels = [n for n in named if n not in ALL_FILTER_READINGS]
        if len(filters) > 1 or len(kernels) > 1:
            return False
        if not set(filters) <= set(filter_readings(chosen["filter"])) or not set(kernels) <= set(kernel_readings(chosen["kernel"])):
            return False
        told = {"filter": (filters or ["listed"])[0], "kernel": (kernels or ["listed"])[0]}
    answer = jump_answer(chosen, told)
    return answer is not None and same_but_delayed(jump_answer(chosen, readings), answer)


def residual(answer, setpoints, recorded):
    """Largest and rms deviation where the recording moves, at the best whole offset."""
    moves = np.abs(np.diff(recorded, prepend=recorded[0])) > 1
    errors = [(recorded - np.roll(answer, shift))[moves] for shift in range(-4, 5)]
    return min(((np.sqrt(np.mean(e ** 2)), np.abs(e).max()) for e in errors))


def named_readings(chosen, named):
    filters = [n for n in named if n in ALL_FILTER_READINGS]
    kernels = [n for n in named if n not in ALL_FILTER_READINGS]
    if named and named[0] in CYCLE_READINGS:
        return {**LISTED, "cycle": named[0]}
    return {"filter": (filters or ["listed"])[0], "kernel": (kernels or ["listed"])[0]}


def explanation(chosen, readings, setpoints, recorded):
    """Rms and largest deviation of a reading, and what rounding both columns makes of the largest at most; None for unstable ones."""
    answer = computed(chosen, readings, setpoints)
    if answer is None:
        return None
    rms, largest = residual(answer, setpoints, recorded)
    impulse = np.diff(jump_answer(chosen, readings))
    return rms, largest, (1 + np.abs(impulse).sum()) / 2


def contradiction(chosen, named, setpoints, recorded):
    """Why a reading must not be named alone; None where it may."""
    rms, largest, bound = explanation(chosen, named_readings(chosen, named), setpoints, recorded)
    if largest > 1.1 * bound:
        return f"ruled out: {largest:.3f} of {bound:.3f}"
    answer = jump_answer(chosen, named_readings(chosen, named))
    for f in filter_readings(chosen["filter"]):
        for k in kernel_readings(chosen["kernel"]):
            readings = {"filter": f, "kernel": k}
            if readings == LISTED:
                continue
            other = explanation(chosen, readings, setpoints, recorded)
            if other is None or other[0] > max(rms, 0.29) or other[1] > other[2]:
                continue
            if not same_but_delayed(jump_answer(chosen, readings), answer):
                return f"{f} + {k} explains it too: rms {other[0]:.3f} and {rms:.3f}"
    return None


def lowpass(order, frequency):
    return {"filter": {"type": LOWPASS, "order": order, "fg": frequency, "prototype": BUTTERWORTH}, "kernel": None}


def other(kind, prototype, order, quality=1.0):
    return {"filter": {"type": kind, "order": order, "fg": 30.0, "prototype": prototype, "quality": quality}, "kernel": None}


def linear_phase(kind, order, share=100):
    return {"filter": None, "kernel": {"type": kind, "order": order, "quality": 1.0, "share": share, "fcut": 30.0, "fg": 20.0}}


STORED = [
    ("listed", lowpass(3, 40.0)), ("no-prewarping", lowpass(3, 60.0)), ("backward-euler", lowpass(2, 20.0)),
    ("forward-euler", lowpass(2, 20.0)), ("matched-poles", lowpass(4, 50.0)),
    ("taps-n-plus-1", linear_phase(AVERAGE, 41)), ("order-is-half-width", linear_phase(AVERAGE, 24)),
    ("gaussian-width-3", linear_phase(GAUSSIAN, 40)), ("sinc-blackman", linear_phase(SINC, 40)),
    ("share-undelayed", linear_phase(AVERAGE, 40, 70)),
    ("quality-of-poles", other(BANDSTOP, CRITICAL_DAMPING, 2, 1.5)), ("analogue-quality", other(BANDSTOP, BUTTERWORTH, 2, 1.0)),
    ("matched", other(BANDSTOP, BUTTERWORTH, 1, 1.0)), ("bessel-delay", other(LOWPASS, BESSEL, 3)),
    ("allpass-phase", other(ALLPASS, BESSEL, 3)), ("novib-one-box", linear_phase(NOVIB, 1)),
]


def store(folder):
    folder.mkdir(parents=True, exist_ok=True)
    for seed, (name, chosen) in enumerate(STORED):
        rng = np.random.default_rng(seed)
        setpoints = motion(rng, "step", 900)
        answer = computed(chosen, {"filter": name if chosen["filter"] else "listed", "kernel": name if chosen["kernel"] else "listed"}, setpoints)
        (folder / f"{name}.csv").write_text(recording_text(rng, setpoints, answer, 1))


def rms_where_it_moves(answer, other, shifts, fraction):
    """The least one over the shifts, and over parts of a cycle from each of them where `fraction` says so."""
    moves = np.abs(np.diff(answer, prepend=answer[0])) > 1
    if not moves.any():
        return 0
    cycles = np.arange(len(answer))
    least = np.inf
    for shift in shifts:
        error = answer - np.interp(cycles - shift, cycles, other)
        if fraction:  # the other one a part of a cycle later: the part by least squares
            later = np.interp(cycles - shift - 1, cycles, other) - np.interp(cycles - shift, cycles, other)
            energy = np.sum(later[moves] ** 2)
            error = error - later * (np.clip(np.sum((later * error)[moves]) / energy, 0, 1) if energy > 0 else 0)
        least = min(least, np.sqrt(np.mean(error[moves] ** 2)))
    return least


def can_tell(chosen, readings, setpoints, answer):
    """Whether the answer differs from that of every other reading, at any offset, by more than rounding hides. What the lists
    say may be off by parts of a cycle, others by whole ones."""
    hidden = 0.5
    others = [{"filter": f, "kernel": readings["kernel"]} for f in filter_readings(chosen["filter"])]
    others += [{"filter": readings["filter"], "kernel": k} for k in kernel_readings(chosen["kernel"])]
    for reading in others + [LISTED] + [{**LISTED, "cycle": c} for c in CYCLE_READINGS]:
        named = [n for n in reading.values() if n != "listed"]
        if right(chosen, readings, named):
            continue
        other = computed(chosen, reading, setpoints)
        if other is not None and rms_where_it_moves(answer, other, np.arange(-3, 4), not named) <= hidden:
            return False
    return True


def main():
    if sys.argv[1] == "--store":
        return store(pathlib.Path(sys.argv[2]))
    axisc, folder = sys.argv[1], pathlib.Path(sys.argv[2])
    machines = int(sys.argv[3]) if len(sys.argv) > 3 else 1000
    rng = np.random.default_rng(int(sys.argv[4]) if len(sys.argv) > 4 else 1)
    folder.mkdir(parents=True, exist_ok=True)
    counts = {}
    at = 0
    while at < machines:
        chosen, readings = machine(rng)
        excitation = str(rng.choice(["step", "velocity", "planned", "smooth"], p=[0.35, 0.35, 0.2, 0.1]))
        setpoints = motion(rng, excitation)
        cycle = T * CYCLE_READINGS.get(readings.get("cycle"), 1)
        if chosen["filter"] and is_lag(chosen["filter"]) and chosen["filter"]["tau"] < cycle:  # the control switches it off
            continue
        is_hsc = chosen["kernel"] is not None and chosen["kernel"]["type"] == NOVIB
        if is_hsc:  # switched on at rest, before anything moves
            if cycle * chosen["kernel"]["fg"] < 1 / 101:  # more taps than the control has
                continue
            setpoints = np.r_[np.full(4000, setpoints[0]), setpoints]
        answer = computed(chosen, readings, setpoints)
        if answer is None:
            continue
        at += 1
        is_outside = rng.random() < 0.2
        if is_outside:  # narrower or wider by little
            side = float(rng.choice([-1, 1]) * 10 ** rng.uniform(-3, -0.7))
            answer = np.convolve(answer - answer[0], [side, 1 - 2 * side, side])[:len(answer)] + answer[0]
        if is_outside:
            excitation = "outside"
        elif excitation != "smooth" and not can_tell(chosen, readings, setpoints, answer):
            excitation = "alike"
        (folder / "x.lis").write_text(list_text(chosen), newline="\n")
        (folder / "scope.csv").write_text(recording_text(rng, setpoints, answer, int(rng.integers(0, 3))))
        ran = subprocess.run([axisc, "compare", "x.lis", "scope.csv", "--cycle-time", "1ms", "--format", "json"]
                             + (["--at", "20:#FILTER ON [HSC]"] if is_hsc else []), cwd=folder, capture_output=True, text=True)
        if not ran.stdout:
            sys.exit(f"{list_text(chosen)}{ran.stderr}")
        told = json.loads(ran.stdout)
        fitting = told["fitting"]
        if told["verdict"] in ("same", "delayed"):
            fitting = [{"readings": []}] + fitting
        hits = [right(chosen, readings, f["readings"]) for f in fitting]
        alone = told["fitting"][0]["readings"] if told["verdict"] == "different" and len(fitting) == 1 else None
        why = contradiction(chosen, alone, np.round(setpoints), np.round(answer)) if alone and (is_outside or at % 4 == 0) else None
        if why is not None:
            result = "WRONG"
        elif told["verdict"] == "cannot-tell" or not hits:
            result = "none"
        elif is_outside:  # what is named explains the recording
            result = "within rounding"
        elif all(hits):  # several are right where they differ by whole cycles only
            result = "right"
        elif len(hits) > 1:
            result = "several" if any(hits) else "none"
        else:
            result = "WRONG"
        counts[excitation, result] = counts.get((excitation, result), 0) + 1
        if result == "WRONG" or (result == "none" and excitation not in UNTOLD):
            print(result, why, excitation, readings, chosen, told["verdict"], told["listed"], fitting, told["next"],
                  told["allowed_rms"])
            (folder / f"{at}.lis").write_text(list_text(chosen))
            (folder / f"{at}.csv").write_text((folder / "scope.csv").read_text())
    for key in sorted(counts):
        print(*key, counts[key])
    excited = sum(n for (e, _), n in counts.items() if e not in UNTOLD)
    named = sum(n for (e, r), n in counts.items() if e not in UNTOLD and r == "right")
    print(f"{named} of {excited} named where the motion excites the filters")
    wrong = sum(n for (_, r), n in counts.items() if r == "WRONG")
    sys.exit(1 if wrong or named < 0.99 * excited else 0)


if __name__ == "__main__":
    main()
