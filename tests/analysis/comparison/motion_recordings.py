#!/usr/bin/env python3
"""Recordings of programs on controls that plan in a known way: does `axisc compare --program` name it?

    motion_recordings.py AXISC FOLDER [MACHINES [SEED]]
    motion_recordings.py --store FOLDER                     the recording of samples/recording/motion

For each of MACHINES random machines (1000) axisc writes the program, motion_control.py executes it in random readings, and axisc compares
the recording with it. Every tenth control is none of the readings: it accelerates otherwise than its lists say, or passes circles otherwise, which must not
keep moves without either from telling. A key can be told where every combination with another word of it leaves more than rounding in
some move that one explains, whatever the offset. Ends with 1 where a wrong word was told, where one was told that the recording does not
decide, or where less than 99 % of what can be told was told.
"""
import json
import math
import pathlib
import random
import subprocess
import sys

sys.dont_write_bytecode = True
from motion_control import DEFAULTS, KEYS, T, acting_keys, blocks_of, combinations, executed, moves, pause_of, profiles, setpoints

NOT_HIDDEN = 1.3  # range of what rounding leaves, in steps: certainly more than that


def random_machine(rng):
    names = ["X", "Y", "Z"][:rng.choice([1, 2, 2, 2, 2, 3])]
    alike = rng.random() < 0.3
    axes = {}
    for name in names:
        a = rng.choice([500, 1000, 2000, 4000, rng.randint(300, 6000)])
        tr = rng.choice([20, 50, 100, rng.randint(10, 250)]) / 1000
        four = [tr] * 4 if rng.random() < 0.6 else [rng.randint(10, 250) / 1000 for _ in range(4)]
        axes[name] = {"v": rng.choice([100, 200, 500]), "up": a, "down": a if rng.random() < 0.6 else rng.randint(300, 6000),
                      "up_build": four[0], "up_take": four[1], "down_build": four[2], "down_take": four[3],
                      "curve": rng.choice([10, 20, 50]) / 1000,
                      "a_weight": rng.choice([0, 0, 100, 500, 1000]), "r_weight": rng.choice([1000, 1000, 0, 154]),
                      "corner_jerk": rng.choice([0, 50, 200]), "curve_jerk": rng.choice([0, 50, 200])}
        if alike and axes:
            axes[name] = dict(next(iter(axes.values())))
    return {"axes": axes, "constant_times": rng.random() < 0.2, "transition_mode": rng.choice([0, 0, 0, 1, 2]),
            "limits_curvature": rng.random() < 0.3}


def write_machine(machine, folder):
    for name, axis in machine["axes"].items():
        us = {ramp: round(axis[ramp] * 1e6) for ramp in ("up_build", "up_take", "down_build", "down_take", "curve")}
        lines = [f"kopf.log_achs_name {name}", "kenngr.achs_typ 1"]
        lines += [f"getriebe[0].{key} {value}" for key, value in {
            "dynamik.vb_max": axis["v"] * 1000, "vb_eilgang": axis["v"] * 1000, "dynamik.a_max": 6000, "dynamik.tr_min": 10000,
            "slope_profil.a_beschl": axis["up"], "slope_profil.a_brems": axis["down"],
            "slope_profil.tr_beschl_zu": us["up_build"], "slope_profil.tr_beschl_ab": us["up_take"],
            "slope_profil.tr_brems_zu": us["down_build"], "slope_profil.tr_brems_ab": us["down_take"], "dynamik.tr_geom": us["curve"],
            "dynamik.a_trans_weight": axis["a_weight"], "dynamik.r_trans_weight": axis["r_weight"],
            "dynamik.j_trans_c0": axis["corner_jerk"], "dynamik.j_trans_c1": axis["curve_jerk"]}.items()]
        (folder / f"{name.lower()}.lis").write_text("\n".join(lines + ["Ende", ""]))
    (folder / "channel.lis").write_text(
        f"prog_start.slope.profile 1\nprog_start.slope.mode_ramp_time {int(machine['constant_times'])}\n"
        f"mode_trans_jerk {machine['transition_mode']}\ncorr_v_trans_jerk {int(machine['limits_curvature'])}\nEnde\n")
    names = list(machine["axes"])
    (folder / "machine.json").write_text(json.dumps(
        {"cycle_time_us": round(T * 1e6), "axes": [{"name": n, "list": f"{n.lower()}.lis"} for n in names],
         "groups": [{"axes": names, "channel_list": "channel.lis"}]}))


class Scope:
    """Rests of unknown length, an unknown zero, whole steps; now and then a row is lost."""

    def __init__(self, rng, plans, columns, pause):
        self.per_mm = rng.choice([10_000, 10_000, 1000])
        zero = {name: rng.uniform(-500, 500) for name in columns}
        self.rows, self.begins = [], []
        rest = plans[0][0]
        self.rows += [rest] * rng.randint(150, 600)
        for plan in plans:
            self.begins.append(len(self.rows) - 1)
            self.rows += plan[1:] + [plan[-1]] * (pause + rng.randint(0, 40))
        cut = math.floor if rng.random() < 0.3 else round
        self.columns = {n: [cut((row[n] + zero[n]) * self.per_mm) for row in self.rows] for n in columns}
        lost = 0.001 if rng.random() < 0.2 else 0.0
        self.kept = [n == 0 or rng.random() >= lost for n in range(len(self.rows))]

    def text(self):
        names = list(self.columns)
        lines = ["time\t" + "\t".join(names)]
        for n, kept in enumerate(self.kept):
            if not kept:
                continue
            values = (self.columns[name][n] for name in names)
            shown = (str(v) if self.per_mm == 10_000 else f"{v / self.per_mm:.3f}".replace(".", ",") for v in values)
            lines.append(f"{n}\t" + "\t".join(shown))
        return "\n".join(lines) + "\n"

    def hidden(self, plan, move):
        """The least range of differences from a plan, in steps, at any whole offset."""
        least = math.inf
        begin = self.begins[move]
        names = list(self.columns)
        scaled = [[point[name] * self.per_mm for point in plan] for name in names]
        end = self.begins[move + 1] if move + 1 < len(self.begins) else len(self.rows) - 1
        for shift in sorted(range(-60, 61), key=abs):
            largest = 0.0
            for name, values in zip(names, scaled):
                column, last = self.columns[name], len(values) - 1
                low, high = math.inf, -math.inf
                for n in range(max(0, begin - 60), min(end, begin + last + 200)):
                    if not self.kept[n]:
                        continue
                    difference = column[n] - values[min(max(n - begin - shift, 0), last)]
                    low, high = min(low, difference), max(high, difference)
                    if high - low > least or high - low > 4:
                        break
                largest = max(largest, high - low)
                if largest > least:
                    break
            least = min(least, largest)
            if least <= 1.0001:
                break
        return least


def alternatives(machine, program, scope):
    """By move: its keys, and for each combination of their readings the range that it leaves."""
    found = []
    for i, move in enumerate(program):
        keys = acting_keys(move, machine)
        known, ranges = {}, {}
        for chosen in combinations(keys):
            readings = {**DEFAULTS, **chosen}
            blocks = blocks_of(move, machine, readings)
            plan = profiles(blocks, readings)
            signature = tuple(profile.signature() for profile, _ in plan)
            if signature not in known:
                known[signature] = scope.hidden(setpoints(blocks, plan), i)
            ranges[tuple(chosen.values())] = known[signature]
        found.append((keys, ranges))
    return found


def judgement(found):
    """For each key: the words with which some combination leaves rounding alone, and those of which none certainly leaves more."""
    surely, perhaps = {key: set() for key in KEYS}, {key: set() for key in KEYS}
    found = [(keys, ranges) for keys, ranges in found if min(ranges.values()) <= NOT_HIDDEN]
    for whole in combinations(list(KEYS)):
        worst = max((ranges[tuple(whole[key] for key in keys)] for keys, ranges in found), default=math.inf)
        for key, word in whole.items():
            if worst <= 1.0001:
                surely[key].add(word)
            if worst <= NOT_HIDDEN:
                perhaps[key].add(word)
    return surely, perhaps


def run(axisc, folder, *arguments):
    return subprocess.run([axisc, "compare", "machine.json", *arguments], cwd=folder, capture_output=True, text=True)


SAMPLE = {"axes": {"X": {"v": 500, "up": 2000, "down": 2000, "up_build": 0.05, "up_take": 0.05, "down_build": 0.05, "down_take": 0.05,
                         "curve": 0.01, "a_weight": 100, "r_weight": 1000, "corner_jerk": 0, "curve_jerk": 0},
                   "Y": {"v": 500, "up": 1500, "down": 1500, "up_build": 0.08, "up_take": 0.08, "down_build": 0.08, "down_take": 0.08,
                         "curve": 0.01, "a_weight": 100, "r_weight": 1000, "corner_jerk": 0, "curve_jerk": 0}},
          "constant_times": False, "transition_mode": 0, "limits_curvature": False}


def store(folder):
    """The machine's files and program are there; the control of the sample has two readings that are not the defaults."""
    text = (folder / "tell.nc").read_text()
    program = moves(text, list(SAMPLE["axes"]))
    readings = {**DEFAULTS, "sine": "whole-change", "circle": "full"}
    rng = random.Random(1)
    scope = Scope(rng, [executed(move, SAMPLE, readings) for move in program], list(SAMPLE["axes"]), pause_of(text))
    (folder / "scope.csv").write_text(scope.text())


def main():
    if sys.argv[1] == "--store":
        return store(pathlib.Path(sys.argv[2]))
    axisc, folder = sys.argv[1], pathlib.Path(sys.argv[2])
    machines = int(sys.argv[3]) if len(sys.argv) > 3 else 1000
    rng = random.Random(int(sys.argv[4]) if len(sys.argv) > 4 else 1)
    folder.mkdir(parents=True, exist_ok=True)
    counts = {key: {"told": 0, "alike": 0, "missed": 0, "wrong": 0, "rash": 0} for key in KEYS}
    outside = {"told": 0, "alike": 0, "missed": 0, "wrong": 0, "rash": 0}
    for number in range(machines):
        machine = random_machine(rng)
        write_machine(machine, folder)
        emitted = run(axisc, folder, "--emit", "program")
        if emitted.returncode != 0:
            sys.exit(f"machine {number}: no program: {emitted.stderr}{emitted.stdout}")
        (folder / "p.nc").write_text(emitted.stdout)
        program = moves(emitted.stdout, list(machine["axes"]))
        readings = {key: rng.choice(words) if rng.random() < 0.6 else words[0] for key, words in KEYS.items()}
        real = json.loads(json.dumps(machine))
        if number % 20 == 9:  # not what the lists say
            for axis in real["axes"].values():
                axis["up"] *= 1.03
        if number % 20 == 19:
            real["circle_part"] = 2.2
        plans = [executed(move, real, readings) for move in program]
        names = list(machine["axes"])
        columns = names if rng.random() < 0.8 else [names[0]]
        moving = [i for i, plan in enumerate(plans) if any(p[c] != plan[0][c] for p in plan for c in columns)]
        plans, program = [plans[i] for i in moving], [program[i] for i in moving]
        scope = Scope(rng, plans, columns, pause_of(emitted.stdout))
        (folder / "scope.csv").write_text(scope.text())
        unit = ["--unit", "mm"] if scope.per_mm == 1000 else []
        done = run(axisc, folder, "scope.csv", "--program", "p.nc", "--format", "json", *unit)
        if done.returncode not in (0, 1) or not done.stdout:
            sys.exit(f"machine {number}: {done.stderr}{done.stdout}")
        answer = {row["key"]: row for row in json.loads(done.stdout)["readings"]}
        told = {key: row["reading"] for key, row in answer.items() if row["reading"] is not None}
        found = alternatives(machine, program, scope)
        surely, perhaps = judgement(found)
        for key, word in readings.items():
            if real == machine and word not in surely[key]:
                sys.exit(f"machine {number}: {key} {word} does not explain its own recording")
            if key in told:
                is_right = told[key] == word or "circle_part" in real and key == "circle" and told[key] in surely[key]
                kind = "wrong" if not is_right else "rash" if len(surely[key]) > 1 else "told"
            else:
                kind = "missed" if len(surely[key]) == 1 and surely[key] == perhaps[key] else "alike"
            (counts[key] if real == machine else outside)[kind] += 1
            if kind in ("wrong", "rash", "missed"):
                print(f"machine {number}: {kind} {key}: {told.get(key)} for {word}, fitting {surely[key]}")
    total = {kind: sum(row[kind] for row in counts.values()) for kind in counts["cycles"]}
    for key, row in counts.items():
        print(key, row)
    print("all", total, "outside", outside)
    tellable = total["told"] + total["missed"]
    bad = not tellable or total["wrong"] or total["rash"] or outside["wrong"] or outside["rash"] or total["told"] < 0.99 * tellable
    sys.exit(1 if bad else 0)


if __name__ == "__main__":
    main()
