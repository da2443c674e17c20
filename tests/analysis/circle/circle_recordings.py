"""Circles of two axes as a scope records them, from equations alone: a program that shares nothing with axisc.

    circle_recordings.py --store FOLDER    the recordings of samples/circle

The setpoint turns at constant speed from angle 0, φ = ωt; the actual position is behind it by the delay of its axis,
φ' = ω(t - delay), with backlash and with a spike of friction that decays after each reversal:

    setpoint  centre + R (cos φ, s sin φ)
    actual    centre + gain R (cos φ', s sin φ') - sgn(velocity) (backlash/2 + spike exp(-time since reversal/spike_ms))

and u -= squareness v about the centre; s = 1 is counterclockwise (G03), -1 clockwise (G02).
"""
import math
import sys

MOVING_AVERAGE = 21  # taps of the filters of samples/circle: order 20

SAMPLE = {
    "cycle_time_us": 2000, "radius_mm": 10, "feed_mm_per_min": 3000, "turns": 2.25, "centre_mm": [120, 80],
    "delay_us": [1500, 1350], "gain": [1, 1], "backlash_mm": [0.003, 0], "spike_mm": [0, 0.004], "spike_ms": 9,
    "squareness": 0, "resolution_mm": 0.0001,
}


def moving_average(taps, omega, cycle):
    """Gain and delay of a mean of `taps` values at a frequency: sin(nθ/2)/(n sin(θ/2)), (n - 1)/2 cycles."""
    theta = omega * cycle
    return math.sin(taps * theta / 2) / (taps * math.sin(theta / 2)), (taps - 1) / 2 * cycle


def sign(value):
    return (value > 0) - (value < 0)


def record(case, sense, filters=None):
    """Rows of time in ms, setpoints and actual positions in mm."""
    cycle, radius = case["cycle_time_us"] * 1e-6, case["radius_mm"]
    omega = case["feed_mm_per_min"] / 60 / radius
    gain, delay = filters(omega, cycle) if filters else (1, 0)
    grid = case["resolution_mm"]
    rows = []
    for n in range(int(case["turns"] * 2 * math.pi / omega / cycle) + 1):
        t = n * cycle
        at = [omega * (t - delay - own * 1e-6) for own in case["delay_us"]]
        path = [gain * case["gain"][0] * radius * math.cos(at[0]), sense * gain * case["gain"][1] * radius * math.sin(at[1])]
        velocity = [-math.sin(at[0]), sense * math.cos(at[1])]
        since = [at[0] % math.pi / omega, (at[1] - math.pi / 2) % math.pi / omega]
        for i in range(2):
            path[i] -= sign(velocity[i]) * (case["backlash_mm"][i] / 2
                                            + case["spike_mm"][i] * math.exp(-since[i] * 1000 / case["spike_ms"]))
        path[0] -= case["squareness"] * path[1]
        setpoint = [radius * math.cos(omega * t), sense * radius * math.sin(omega * t)]
        rows.append([t * 1000] + [round((case["centre_mm"][i] + values[i]) / grid) * grid
                                  for values in (setpoint, path) for i in range(2)])
    return rows


def text(rows, names):
    """Of a recording with columns X setpoint, Y setpoint, X actual, Y actual, and the time."""
    head = "time [ms]" + "".join(f";{name} {what}" for what in ("setpoint", "actual") for name in names)
    return head + "\n" + "".join(f"{row[0]:.10g};" + ";".join(f"{value:.4f}" for value in row[1:]) + "\n" for row in rows)


def main():
    folder = sys.argv[sys.argv.index("--store") + 1]
    for name, sense in (("ccw", 1), ("cw", -1)):
        rows = record(SAMPLE, sense, lambda omega, cycle: moving_average(MOVING_AVERAGE, omega, cycle))
        with open(f"{folder}/{name}.csv", "w", encoding="utf-8", newline="\n") as file:
            file.write(text(rows, "XY"))


if __name__ == "__main__":
    main()
