#!/usr/bin/env python3
"""Recordings of simulated axes with and without resonances, made without axisc's arithmetic.

    mode_recordings.py AXISC FOLDER [AXES [SEED]]
    mode_recordings.py --store FOLDER               full.csv and 60-percent.csv of samples/resonance

The first makes AXES axes (20) of each kind in FOLDER, runs `axisc suggest --measured` on each and counts how often it gives a
frequency, how often the right one (6 %), how often one within three times its uncertainty, how often none. Ends with 1
where a frequency is invented (10 % off), or where too few are given. Needs numpy.

An axis is two masses with a spring and a damper between them, driven by a force on the first, with Coulomb friction
and torque ripple that depends on the position; a controller with proportional position loop and proportional and
integral velocity loop samples it every millisecond. What is true is not taken from the recording: with a force as
input it is the natural frequency of the two free masses, else an eigenvalue of the loop (without friction).
"""
import json
import math
import pathlib
import subprocess
import sys

import numpy as np

T = 1e-3
STEPS = 10
H = T / STEPS


class Axes:
    """Many axes at once: each attribute has an entry for each of them. mm, kg, N, s."""

    def __init__(self, rng, count, frequency, damping, load=(0.2, 0.5), friction=(0, 1), loop=True, bandwidth=(4, 10)):
        uniform = lambda low_high: rng.uniform(*low_high, count)
        self.count = count
        mass = uniform((100, 300))
        share = uniform(load)
        self.m1, self.m2 = mass * (1 - share), mass * share
        self.frequency, self.damping = uniform(frequency), uniform(damping)
        reduced = self.m1 * self.m2 / mass
        omega = 2 * math.pi * self.frequency
        self.k, self.c = reduced * omega**2 / 1000, 2 * self.damping * omega * reduced / 1000
        self.friction = uniform(friction)
        self.pitch = uniform((8, 20))
        self.phase = uniform((0, 6.28))
        self.ripple = np.zeros((3, count))
        self.roughness = np.zeros(count)
        self.shaking, self.shake_frequency = np.zeros(count), np.ones(count)
        self.force_noise = np.zeros(count)
        velocity_loop = 2 * math.pi * uniform(bandwidth)
        self.kv = velocity_loop * uniform((0.15, 0.3)) * loop
        self.kp = mass * velocity_loop / 1000 * loop
        self.tn = uniform((2, 5)) / velocity_loop
        self.feedforward = 0.0
        self.direct = False  # the load is measured as well

    def make_rigid(self):
        """One mass."""
        self.k = (self.m1 * self.m2 / (self.m1 + self.m2)) * (2 * math.pi * 900)**2 / 1000
        self.c = 2 * 0.7 * 2 * math.pi * 900 * self.m1 * self.m2 / (self.m1 + self.m2) / 1000

    def step(self, state, force, time, rng=None, is_linear=False, moves=True):
        """A sample under a force, with semi-implicit steps; the guide is rough only where the axis `moves`."""
        x1, v1, x2, v2 = state
        rough = 0 if rng is None else self.roughness * rng.standard_normal(self.count) * moves
        for i in range(STEPS):
            push = force
            if not is_linear:
                angle = 2 * np.pi * x1 / self.pitch + self.phase
                slide = np.tanh(v1 / 0.3)
                push = push - self.friction * slide + rough
                for n, amplitude in zip((1, 2, 5), self.ripple):
                    push = push + amplitude * np.sin(n * angle)
                push = push + self.shaking * np.sin(2 * np.pi * self.shake_frequency * (time + i * H))
            spring = self.k * (x2 - x1) + self.c * (v2 - v1)
            v1 = v1 + H * 1000 * (push + spring) / self.m1
            v2 = v2 - H * 1000 * spring / self.m2
            x1, x2 = x1 + H * v1, x2 + H * v2
        return x1, v1, x2, v2

    def control(self, setpoint, speed, x1, v1, integral):
        wanted = self.kv * (setpoint - x1) + self.feedforward * speed
        integral = integral + T / self.tn * (wanted - v1)
        return self.kp * (wanted - v1 + integral), integral

    def poles(self):
        """Natural frequencies and dampings of the loop, for each axis, from the map of one sample."""
        size = 5
        columns = []
        for unit in range(size):
            state = [np.full(self.count, 1.0 if i == unit else 0.0) for i in range(size)]
            force, integral = self.control(0, 0, state[0], state[1], state[4])
            columns.append(np.array([*self.step(state[:4], force, 0, is_linear=True), integral]))
        found = []
        for axis in range(self.count):
            matrix = np.array([column[:, axis] for column in columns]).T
            roots = np.log(np.linalg.eigvals(matrix).astype(complex)) / T
            roots = roots[roots.imag > 1]
            found.append([(abs(root) / (2 * math.pi), -root.real / abs(root)) for root in roots])
        return found

    def travel(self, setpoint, rng):
        """Actual positions under control, a column an axis, in whole 0.1 µm."""
        zero = np.zeros(self.count)
        state, integral = (zero + setpoint[0], zero, zero + setpoint[0], zero), zero
        actual = np.empty((len(setpoint), self.count))
        for n, wanted in enumerate(setpoint):
            speed = (wanted - setpoint[n - 1]) / T if n else zero
            measured = np.round(state[0], 4)
            actual[n] = np.round(state[2], 4) if self.direct else measured
            force, integral = self.control(wanted, speed, measured, state[1], integral)
            state = self.step(state, force + self.force_noise * rng.standard_normal(self.count), n * T, rng,
                              moves=np.abs(speed) > 1)
        return actual

    def excite(self, force, rng):
        """Velocities under a force, without control but for a weak one that keeps the axis in place."""
        zero = np.zeros(self.count)
        state = (zero, zero, zero, zero)
        velocity = np.empty((len(force), self.count))
        total = np.empty_like(velocity)
        for n, push in enumerate(force):
            velocity[n] = state[1]
            total[n] = push - 0.3 * state[1] - 0.1 * state[0]
            state = self.step(state, total[n], n * T, rng)
        return total, velocity


def moves(count, distance, speed, acceleration, rest, repeats, jerk_time=0.0):
    """Setpoints there and back, with a rest after each."""
    steps = [0.0] * 200
    for n in range(repeats):
        top = min(speed, math.sqrt(distance * acceleration))
        up = np.arange(1, int(top / acceleration / T) + 1) * acceleration * T
        cruise = max(0, int((distance - top * top / acceleration) / top / T))
        move = np.r_[up, np.full(cruise, top), up[::-1]]
        if jerk_time:
            taps = max(1, int(jerk_time / T))
            move = np.convolve(move, np.ones(taps) / taps)
        steps += list(move * (1 if n % 2 == 0 else -1)) + [0.0] * int(rest / T)
    return np.repeat(np.round(np.cumsum(steps) * T, 4)[:, None], count, axis=1)


def store(path, first, second, names=("Setpoint [mm]", "Actual [mm]"), form="%.4f"):
    with open(path, "w") as file:
        file.write(f'time_ms,"{names[0]}","{names[1]}"\n')
        for n, (a, b) in enumerate(zip(first, second)):
            file.write(f"{n},{form % a},{form % b}\n")
    return str(path)


class Trial:
    def __init__(self, axisc, folder):
        self.axisc, self.folder = axisc, pathlib.Path(folder)
        self.bad = False
        (self.folder / "x.lis").write_text("filter_fir.enable 1\nfilter_fir.order 20\nfilter_fir.type 1\nEnde\n")

    def ask(self, files):
        command = [self.axisc, "suggest", str(self.folder / "x.lis"), "--cycle-time", "1ms", "--tolerance", "10",
                   "--format", "json"]
        for file in files:
            command += ["--measured", file]
        done = subprocess.run(command, capture_output=True, text=True)
        if done.returncode == 2:
            return [], done.stderr
        return json.loads(done.stdout).get("measured", []), done.stderr

    def count(self, name, cases, least=None, words=None):
        """`cases`: files and the frequencies that are true (natural frequency, damping)."""
        given = right = inside = close_damping = dampings = said = 0
        worst = 0.0
        for files, truth in cases:
            found, text = self.ask(files)
            said += words is not None and words in text
            for mode in found[:]:
                apart = [abs(mode["frequency_hz"] - f) / f for f, _ in truth] or [1.0]
                nearest = int(np.argmin(apart))
                mode["error"], mode["true"] = apart[nearest], truth[nearest] if truth else (0, 0)
            if not found:
                continue
            given += 1
            worst = max([worst] + [mode["error"] for mode in found])
            # Under friction a strongly damped pole lies elsewhere than without: 10 % off is invented.
            is_right = all(mode["error"] <= 0.06 for mode in found)
            right += is_right
            if not is_right:
                print("   ", files, truth, [(m["frequency_hz"], m["evidence"]) for m in found])
            inside += all(abs(mode["frequency_hz"] - mode["true"][0]) <= 3 * mode["frequency_uncertainty_hz"]
                          for mode in found)
            for mode in found:
                if mode["damping"] is not None:
                    dampings += 1
                    close_damping += abs(mode["damping"] / mode["true"][1] - 1) < 0.3 if mode["true"][1] else 0
        told = f", {said} say so" if words else ""
        print(f"{name}: {len(cases)} axes, {given} given, {right} right (6 %), {inside} within three uncertainties, worst "
              f"{100 * worst:.1f} %, damping within 30 %: {close_damping} of {dampings}{told}", flush=True)
        self.bad |= worst > 0.1 or (least is not None and given < least * len(cases))
        if not any(truth for _, truth in cases):
            self.bad |= given > 0
        if words:
            self.bad |= said < len(cases) - given


def noise_cases(trial, rng, count, rigid=False, crossed=False, seconds=16, pulses=False):
    axes = Axes(rng, count, (15, 150), (0.005, 0.05), friction=(0, 0.1), loop=False)
    if rigid:
        axes.make_rigid()
    samples = int(seconds / T)
    if pulses:
        force = np.zeros((samples, count))
        for n in range(500, samples - 1500, 2000):
            force[n:n + 400] = 100 * rng.choice([-1, 1]) * rng.uniform(0.5, 1, count)
    else:
        force = np.repeat(rng.normal(0, 100, (samples // 2, count)), 2, axis=0)
    axes.roughness[:] = rng.uniform(0, 30, count)
    total, velocity = axes.excite(force, rng)
    velocity = velocity + rng.normal(0, 1, velocity.shape) * rng.uniform(0.01, 0.3, count) * velocity.std(axis=0)
    cases = []
    for i in range(count):
        other = (i + 1) % count if crossed else i
        name = f"{'rigid' if rigid else 'crossed' if crossed else 'pulses' if pulses else 'noise'}{seconds}-{i}.csv"
        file = store(trial.folder / name, total[:, other], velocity[:, i], ("Torque [N]", "Velocity [mm/s]"))
        cases.append(([file], [] if rigid or crossed else [(axes.frequency[i], axes.damping[i])]))
    return cases


def rest_cases(trial, rng, count, rigid=False, shaken=False):
    axes = Axes(rng, count, (8, 30), (0.005, 0.05), load=(0.1, 0.4), bandwidth=(10, 40))
    axes.feedforward, axes.direct = 1.0, True
    if rigid:
        axes.make_rigid()
    if shaken:
        axes.shaking[:], axes.shake_frequency[:] = rng.uniform(5, 20, count), rng.uniform(15, 60, count)
    axes.force_noise[:] = rng.uniform(0, 5, count)
    setpoint = moves(count, 30, 150, 2000, rng.uniform(0.3, 0.8), 10, jerk_time=0 if count % 2 else 0.01)
    actual = axes.travel(setpoint, rng)
    poles = axes.poles()
    kind = "shaken" if shaken else "stiff" if rigid else "rests"
    return [([store(trial.folder / f"{kind}-{i}.csv", setpoint[:, i], actual[:, i])],
             [] if rigid or shaken else [pole for pole in poles[i] if pole[1] < 0.3]) for i in range(count)]


def line_cases(trial, rng, count, rigid=False, fan=False, speeds=(1, 0.6), mains=False):
    axes = Axes(rng, count, (35, 120), (0.002, 0.008), load=(0.2, 0.5), bandwidth=(1, 3))
    if rigid:
        axes.make_rigid()
    axes.force_noise[:] = rng.uniform(1, 5, count)
    axes.roughness[:] = rng.uniform(15, 60, count)
    axes.ripple[:] = rng.uniform(2, 15, (3, count))
    axes.feedforward = 1.0
    if fan:
        axes.shaking[:], axes.shake_frequency[:] = rng.uniform(5, 15, count), rng.uniform(21, 47, count)
    if mains:
        axes.shaking[:], axes.shake_frequency[:] = rng.uniform(5, 15, count), 100
    fast = rng.uniform(60, 200)
    files = [[] for _ in range(count)]
    kind = "fan" if fan else "hum" if mains else "smooth" if rigid else "lines"
    for run, share in enumerate(speeds):
        speed = fast * share
        setpoint = moves(count, speed * 1.2, speed, 1000, 0.4, 6, jerk_time=0.05)
        actual = axes.travel(setpoint, rng)
        for i in range(count):
            files[i].append(store(trial.folder / f"{kind}{len(speeds)}-{i}-{run}.csv", setpoint[:, i], actual[:, i]))
    poles = axes.poles()
    none = rigid or len(speeds) < 2
    return [(files[i], [] if none else [pole for pole in poles[i] if pole[1] < 0.3]) for i in range(count)]


def store_sample(folder):
    """The axis of samples/resonance, two speeds: 48 Hz, and a ball screw with a pitch of 10 mm."""
    rng = np.random.default_rng(49)
    axes = Axes(rng, 1, (48, 48), (0.002, 0.002), load=(0.3, 0.3), bandwidth=(2, 2))
    axes.force_noise[:], axes.roughness[:], axes.pitch[:] = 1, 20, 10
    axes.ripple[1][:], axes.feedforward = 20, 1.0
    for name, speed in (("full", 120), ("60-percent", 72)):
        setpoint = moves(1, speed * 0.9, speed, 2000, 0.25, 4, jerk_time=0.02)
        actual = axes.travel(setpoint, rng)
        store(pathlib.Path(folder) / f"{name}.csv", setpoint[:, 0], actual[:, 0], ("Setpoint X [mm]", "Position X [mm]"))
    print(axes.poles())


def main():
    if sys.argv[1] == "--store":
        return store_sample(sys.argv[2])
    trial = Trial(sys.argv[1], sys.argv[2])
    count = int(sys.argv[3]) if len(sys.argv) > 3 else 20
    seed = int(sys.argv[4]) if len(sys.argv) > 4 else 1
    stream = lambda n: np.random.default_rng([seed, n])
    trial.count("noise, 16 s", noise_cases(trial, stream(1), count), least=0.7)
    trial.count("noise, 6 s", noise_cases(trial, stream(2), count, seconds=6), least=0.5)
    trial.count("rigid, noise", noise_cases(trial, stream(3), count, rigid=True))
    trial.count("input of another axis", noise_cases(trial, stream(4), count, crossed=True))
    trial.count("pulses of force", noise_cases(trial, stream(5), count, pulses=True))
    trial.count("rests", rest_cases(trial, stream(6), count), least=0.4)
    trial.count("rests, rigid", rest_cases(trial, stream(7), count, rigid=True))
    trial.count("rests, rigid, shaken", rest_cases(trial, stream(8), count, rigid=True, shaken=True))
    trial.count("two speeds", line_cases(trial, stream(9), count), least=0.15)
    trial.count("three speeds", line_cases(trial, stream(10), count, speeds=(1, 0.8, 0.6)), least=0.15)
    trial.count("two speeds, rigid", line_cases(trial, stream(11), count, rigid=True))
    trial.count("two speeds, rigid, a fan", line_cases(trial, stream(12), count, rigid=True, fan=True))
    trial.count("two speeds, rigid, mains", line_cases(trial, stream(13), count, rigid=True, mains=True))
    trial.count("one speed", line_cases(trial, stream(14), count, speeds=(1,)), words="60 % override")
    sys.exit(trial.bad)


if __name__ == "__main__":
    main()
