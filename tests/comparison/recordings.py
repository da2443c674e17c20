#!/usr/bin/env python3
"""Recordings of a control that reads the parameters in a known way, made without axisc's arithmetic.

    recordings.py AXISC FOLDER [MACHINES [SEED]]
    recordings.py --store FOLDER                     the recordings that the tests read, and the sample

The first makes MACHINES random machines (1000) in FOLDER, runs `axisc compare` on each and counts how often the right reading is
named, how often none is, and how often a wrong one. Ends with 1 where a wrong one was named for certain, or where the
right one was named in less than 99 % of the recordings that can tell: those with jumps of the setpoint or of its velocity
that do not look the same behind filters in another reading.
Needs numpy.
"""
import json
import pathlib
import subprocess
import sys

import numpy as np

T = 0.001
FILTER_READINGS = ["listed", "no-prewarping", "backward-euler", "forward-euler", "matched-poles", "impulse-invariant",
                   "step-invariant", "half-gain-at-frequency", "poles-at-frequency", "filters-off"]
KERNEL_READINGS = ["listed", "taps-n", "taps-n-plus-1", "half-width-rounded-down", "order-is-half-width"]
GAUSS_READINGS = ["gaussian-width-1", "gaussian-width-2", "gaussian-width-3"]
SINC_READINGS = ["sinc-hann", "sinc-blackman", "sinc-no-window"]
SHARE_READINGS = ["share-undelayed", "share-ignored"]
CYCLE_READINGS = {"cycle-time-double": 2, "cycle-time-half": 0.5, "cycle-time-fourfold": 4, "cycle-time-quarter": 0.25}


def exponential(matrix):
    """By its series, of a matrix with small numbers."""
    squarings = max(0, int(np.ceil(np.log2(max(1e-9, np.abs(matrix).sum(axis=1).max())))) + 6)
    term = result = np.eye(len(matrix))
    for k in range(1, 16):
        term = term @ matrix / 2 ** squarings / k
        result = result + term
    for _ in range(squarings):
        result = result @ result
    return result


def invariant(poles, reading):
    """Numerator and denominator in z^-1 of a low-pass with these poles, per cycle, whose answer is sampled."""
    n = len(poles)
    coefficients = np.real(np.poly(poles))
    state = np.zeros((n + 1, n + 1))  # the states in a chain, and the input
    state[:n - 1, 1:n] = np.eye(n - 1)
    state[n - 1, :n] = -coefficients[:0:-1]
    state[n - 1, n] = 1
    move = exponential(state)
    answers = []
    inner, vector = move[:n, :n], np.eye(n)[:, n - 1] if reading == "impulse-invariant" else move[:n, n]
    for _ in range(n + 1):
        answers.append(vector[0])
        vector = inner @ vector
    if reading == "step-invariant":
        answers = [0.0] + answers[:n]
    denominator = np.real(np.poly(np.exp(poles)))
    return np.convolve(denominator, answers)[:n + 1], denominator


def standard_filter(f, reading, cycle=T):
    """Numerator and denominator in z^-1 of a low-pass of order n at `fg` Hz."""
    n = f["order"]
    if reading == "filters-off":
        return [1.0], [1.0]
    omega = 2 * np.pi * f["fg"]
    if reading in ("listed", "half-gain-at-frequency", "poles-at-frequency"):
        omega = 2 / cycle * np.tan(omega * cycle / 2)
    if f["prototype"] == 2:
        poles = omega * np.exp(1j * np.pi * (2 * np.arange(n) + n + 1) / (2 * n))
        if reading == "half-gain-at-frequency":
            poles = poles / 3 ** (1 / (2 * n))
    else:
        width = {"half-gain-at-frequency": 4, "poles-at-frequency": 2 ** n}.get(reading, 2)
        poles = np.full(n, -omega / np.sqrt(width ** (1 / n) - 1))
    zeros = []
    if reading in ("impulse-invariant", "step-invariant"):
        numerator, denominator = invariant(poles * cycle, reading)
        return numerator * denominator.sum() / numerator.sum(), denominator
    if reading in ("listed", "no-prewarping", "half-gain-at-frequency", "poles-at-frequency"):
        z = (1 + poles * cycle / 2) / (1 - poles * cycle / 2)  # s = 2/T (1 - z^-1)/(1 + z^-1)
        zeros = [-1] * n
    elif reading == "matched-poles":
        z = np.exp(poles * cycle)
    elif reading == "backward-euler":  # s = (1 - z^-1)/T
        z = 1 / (1 - poles * cycle)
    else:  # s = (z - 1)/T
        z = 1 + poles * cycle
    if np.max(np.abs(z)) >= 1:
        return None
    denominator, numerator = np.real(np.poly(z)), np.atleast_1d(np.real(np.poly(zeros)))
    numerator = numerator * denominator.sum() / numerator.sum()
    return (np.r_[np.zeros(n), numerator] if reading == "forward-euler" else numerator), denominator


def filtered(numerator, denominator, values):
    values = np.convolve(values, numerator)[:len(values)]
    if len(denominator) == 1:
        return values
    answer = [0.0] * len(values)
    for i, value in enumerate(values.tolist()):
        for k, a in enumerate(denominator[1:].tolist(), 1):
            if i >= k:
                value -= a * answer[i - k]
        answer[i] = value
    return np.array(answer)


def kernel(k, reading, cycle=T):
    n, share = k["order"], k["share"] / 100
    taps = {"taps-n": n, "taps-n-plus-1": n + 1, "half-width-rounded-down": 2 * (n // 2) + 1,
            "order-is-half-width": 2 * n + 1}.get(reading, 2 * -(-n // 2) + 1)
    half = (taps - 1) / 2
    at = np.arange(taps) - half
    if k["type"] == 1:
        shape = np.ones(taps)
    elif k["type"] == 2:
        width = {"gaussian-width-1": 1, "gaussian-width-2": 2, "gaussian-width-3": 3}.get(reading, 2.5)
        shape = np.exp(-0.5 * (at / (k["quality"] * half / width)) ** 2)
    else:
        window = {"sinc-hann": np.hanning, "sinc-blackman": np.blackman, "sinc-no-window": np.ones}
        shape = np.sinc(2 * k["fcut"] * cycle * at) * window.get(reading, np.hamming)(taps)
    shape = shape / shape.sum()
    if reading == "share-ignored":
        return shape
    result = share * shape
    if reading == "share-undelayed":
        result[0] += 1 - share
    else:
        result[(taps - 1) // 2] += (1 - share) / 2
        result[taps // 2] += (1 - share) / 2
    return result


def motion(rng, excitation, cycles=4000):
    """Setpoints in 0.1 µm: moves at constant velocity with sharp changes, or one slow and smooth move."""
    if excitation == "smooth":
        return 2000 * (1 - np.cos(np.pi * np.arange(cycles) / cycles)) / 2
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


def machine(rng):
    chosen = {"filter": None, "kernel": None}
    kind = rng.integers(0, 3)
    if kind != 1:
        chosen["filter"] = {"order": int(rng.integers(1, 5)), "fg": round(float(rng.uniform(8, 120)), 1),
                            "prototype": int(rng.choice([1, 2, 2]))}
    if kind != 0:
        chosen["kernel"] = {"type": int(rng.integers(1, 4)), "order": int(rng.integers(7, 120)),
                            "quality": round(float(rng.uniform(0.4, 1)), 2), "share": int(rng.choice([100, 100, 80, 60])),
                            "fcut": round(float(rng.uniform(5, 60)), 1)}
    readings = {"filter": "listed", "kernel": "listed"}
    if chosen["filter"] and rng.random() < 0.7:
        readings["filter"] = str(rng.choice(FILTER_READINGS))
        alike = chosen["filter"]["prototype"] == 2 or chosen["filter"]["order"] == 1
        if readings["filter"] == "poles-at-frequency" and alike:
            readings["filter"] = "listed"
    if chosen["kernel"] and rng.random() < 0.7:
        k = chosen["kernel"]
        known = KERNEL_READINGS + {1: [], 2: GAUSS_READINGS, 3: SINC_READINGS}[k["type"]]
        readings["kernel"] = str(rng.choice(known + (SHARE_READINGS if k["share"] < 100 else [])))
    if rng.random() < 0.1:
        readings = {"filter": "listed", "kernel": "listed", "cycle": str(rng.choice(list(CYCLE_READINGS)))}
    return chosen, readings


def list_text(chosen):
    lines = ["kenngr.achs_typ 1"]
    if chosen["filter"]:
        f = chosen["filter"]
        lines += ["filter[0].enable 1", "filter[0].type 1", f"filter[0].prototype {f['prototype']}", f"filter[0].order {f['order']}",
                  f"filter[0].fg_f0 {f['fg']}", "filter[0].share_percent 100"]
    if chosen["kernel"]:
        k = chosen["kernel"]
        lines += ["filter_fir.enable 1", f"filter_fir.type {k['type']}", f"filter_fir.order {k['order']}",
                  f"filter_fir.share {k['share']}", f"filter_fir.quality {k['quality']}", f"filter_fir.fcut {k['fcut']}"]
    return "\n".join(lines + ["Ende", ""])


def computed(chosen, readings, setpoints):
    """None where the reading is unstable."""
    values = setpoints - setpoints[0]
    cycle = T * CYCLE_READINGS.get(readings.get("cycle"), 1)
    if chosen["filter"]:
        made = standard_filter(chosen["filter"], readings["filter"], cycle)
        if made is None:
            return None
        values = filtered(*made, values)
    if chosen["kernel"]:
        values = filtered(kernel(chosen["kernel"], readings["kernel"], cycle), [1], values)
    return values + setpoints[0]


def recording_text(rng, setpoints, answer, shift, lost=0.001):
    """As TwinCAT Scope exports it: a pair of time and value a signal, milliseconds, decimal commas, EOF."""
    answer = np.r_[np.full(shift, answer[0]), answer[:len(answer) - shift]]
    rows = ["Name\tRecording", "", "Time\tsetpoint\tTime\tfiltered"]
    for n, (x, y) in enumerate(zip(np.round(setpoints), np.round(answer))):
        if n > 0 and rng.random() < lost:
            continue
        rows.append(f"{n},0\t{int(x)}\t{n},0\t{int(y)}")
    return "\n".join(rows + ["EOF", ""])


def same_taps(chosen, one, other):
    if not chosen["kernel"]:
        return True
    a, b = kernel(chosen["kernel"], one), kernel(chosen["kernel"], other)
    return len(a) == len(b) and np.allclose(a, b, atol=1e-12)


def same_but_delayed(one, other):
    """Whether answers to a jump agree but for whole cycles, which no recording can tell."""
    n = len(one)
    return any(np.abs(one[max(0, d):n + min(0, d)] - other[max(0, -d):n - max(0, d)]).max() < 1e-5 for d in range(-8, 9))


def jump_answer(chosen, readings):
    return computed(chosen, readings, np.r_[np.zeros(20), np.ones(2500)])


def right(chosen, readings, named):
    """Whether what is named computes what was made, but for whole cycles."""
    if len(named) == 1 and named[0] in CYCLE_READINGS:
        told = {"filter": "listed", "kernel": "listed", "cycle": named[0]}
    else:
        known = set(FILTER_READINGS + KERNEL_READINGS + GAUSS_READINGS + SINC_READINGS + SHARE_READINGS)
        filters = [n for n in named if n in FILTER_READINGS]
        kernels = [n for n in named if n not in FILTER_READINGS]
        if not set(named) <= known or len(filters) > 1 or len(kernels) > 1:
            return False
        if chosen["filter"] is None and filters or chosen["kernel"] is None and kernels:
            return False
        told = {"filter": (filters or ["listed"])[0], "kernel": (kernels or ["listed"])[0]}
    answer = jump_answer(chosen, told)
    return answer is not None and same_but_delayed(jump_answer(chosen, readings), answer)


STORED = [
    ("listed", {"filter": {"order": 3, "fg": 40.0, "prototype": 2}, "kernel": None}, {}),
    ("no-prewarping", {"filter": {"order": 3, "fg": 60.0, "prototype": 2}, "kernel": None}, {"filter": "no-prewarping"}),
    ("backward-euler", {"filter": {"order": 2, "fg": 20.0, "prototype": 2}, "kernel": None}, {"filter": "backward-euler"}),
    ("forward-euler", {"filter": {"order": 2, "fg": 20.0, "prototype": 2}, "kernel": None}, {"filter": "forward-euler"}),
    ("matched-poles", {"filter": {"order": 4, "fg": 50.0, "prototype": 2}, "kernel": None}, {"filter": "matched-poles"}),
    ("taps-n-plus-1", {"kernel": {"type": 1, "order": 41}}, {"kernel": "taps-n-plus-1"}),
    ("order-is-half-width", {"kernel": {"type": 1, "order": 24}}, {"kernel": "order-is-half-width"}),
    ("gaussian-width-3", {"kernel": {"type": 2, "order": 40}}, {"kernel": "gaussian-width-3"}),
    ("sinc-blackman", {"kernel": {"type": 3, "order": 40}}, {"kernel": "sinc-blackman"}),
    ("share-undelayed", {"kernel": {"type": 1, "order": 40, "share": 70}}, {"kernel": "share-undelayed"}),
]


def store(folder):
    folder.mkdir(parents=True, exist_ok=True)
    for seed, (name, chosen, readings) in enumerate(STORED):
        rng = np.random.default_rng(seed)
        chosen = {"filter": None, **chosen}
        if chosen["kernel"]:
            chosen["kernel"] = {"quality": 1.0, "share": 100, "fcut": 30.0, **chosen["kernel"]}
        setpoints = motion(rng, "step", 900)
        answer = computed(chosen, {"filter": "listed", "kernel": "listed", **readings}, setpoints)
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
    others = [{"filter": f, "kernel": readings["kernel"]} for f in FILTER_READINGS if chosen["filter"]]
    if chosen["kernel"]:
        k = chosen["kernel"]
        known = KERNEL_READINGS + {1: [], 2: GAUSS_READINGS, 3: SINC_READINGS}[k["type"]]
        others += [{"filter": readings["filter"], "kernel": r} for r in known + (SHARE_READINGS if k["share"] < 100 else [])]
    listed = {"filter": "listed", "kernel": "listed"}
    for reading in others + [listed] + [{**listed, "cycle": c} for c in CYCLE_READINGS]:
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
        excitation = str(rng.choice(["step", "velocity", "smooth"], p=[0.45, 0.45, 0.1]))
        setpoints = motion(rng, excitation)
        answer = computed(chosen, readings, setpoints)
        if answer is None:
            continue
        at += 1
        if excitation != "smooth" and not can_tell(chosen, readings, setpoints, answer):
            excitation = "alike"
        (folder / "x.lis").write_text(list_text(chosen), newline="\n")
        (folder / "scope.csv").write_text(recording_text(rng, setpoints, answer, int(rng.integers(0, 3))))
        ran = subprocess.run([axisc, "compare", "x.lis", "scope.csv", "--cycle-time", "1ms", "--format", "json"],
                             cwd=folder, capture_output=True, text=True)
        if not ran.stdout:
            sys.exit(f"{list_text(chosen)}{ran.stderr}")
        told = json.loads(ran.stdout)
        fitting = told["fitting"]
        if told["verdict"] in ("same", "delayed"):
            fitting = [{"readings": []}] + fitting
        hits = [right(chosen, readings, f["readings"]) for f in fitting]
        if told["verdict"] == "cannot-tell" or not hits:
            result = "none"
        elif all(hits):  # several are right where they differ by whole cycles only
            result = "right"
        elif len(hits) > 1:
            result = "several" if any(hits) else "none"
        else:
            result = "WRONG"
        counts[excitation, result] = counts.get((excitation, result), 0) + 1
        if result == "WRONG" or (result == "none" and excitation not in ("smooth", "alike")):
            print(result, excitation, readings, chosen, told["verdict"], told["listed"], fitting, told["next"],
                  told["allowed_rms"])
            (folder / f"{at}.lis").write_text(list_text(chosen))
            (folder / f"{at}.csv").write_text((folder / "scope.csv").read_text())
    for key in sorted(counts):
        print(*key, counts[key])
    excited = sum(n for (e, _), n in counts.items() if e not in ("smooth", "alike"))
    named = sum(n for (e, r), n in counts.items() if e not in ("smooth", "alike") and r == "right")
    print(f"{named} of {excited} named where the motion excites the filters")
    wrong = sum(n for (_, r), n in counts.items() if r == "WRONG")
    sys.exit(1 if wrong or named < 0.99 * excited else 0)


if __name__ == "__main__":
    main()
