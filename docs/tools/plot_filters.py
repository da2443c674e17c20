#!/usr/bin/env python3
"""Draws the plots of docs/filters.md with axisc itself: every curve is an image's own response.

plot_filters.py AXISC FOLDER       (Python standard library only; FOLDER is docs/filters)
"""
import csv
import io
import math
import subprocess
import sys
import tempfile
from pathlib import Path

COLOURS = ("#0060a8", "#c04000", "#2e8b3d", "#7a3d9a", "#8a6d00", "#444444")
WIDTH, HEIGHT, LEFT, RIGHT, TOP, BOTTOM = 640, 340, 58, 16, 30, 44


def axisc(program, *arguments):
    return subprocess.run([program, *arguments], check=True, capture_output=True, text=True).stdout


def rows(program, lines, *arguments):
    """Compiles a list with these filter parameters at T = 1 ms and asks for `run` or `response`."""
    with tempfile.TemporaryDirectory() as folder:
        source, image = Path(folder) / "x.lis", Path(folder) / "x.axim"
        head = ["kopf.achs_nr 1", "kopf.log_achs_name X", "kenngr.achs_typ 1", "kenngr.antr_typ 2"]
        filters = [f"filter[0].{line}" for line in ("enable 1", *lines)]
        source.write_text("\n".join((*head, *filters, "Ende")) + "\n")
        axisc(program, "compile", str(source), "--cycle-time", "1ms", "-o", str(image), "--quiet")
        command, *options = arguments
        return list(csv.DictReader(io.StringIO(axisc(program, command, str(image), *options))))


def response(program, lines, frequencies, column="decibel"):
    answer = rows(program, lines, "response", "--frequencies", ",".join(map(repr, frequencies)), "--format", "csv")
    points = []
    for row in answer:
        f, magnitude = float(row["frequency_hz"]), float(row["magnitude"])
        if column == "decibel":
            points.append((f, 20 * math.log10(max(magnitude, 1e-9))))
        else:
            delay = float(row["group_delay_s"] or "nan")
            points.append((f, delay * 1e3))
    return [p for p in points if not math.isnan(p[1])]


def step(program, lines, cycles):
    answer = rows(program, lines, "run", "--signal", "step", "--cycles", str(cycles))
    return [(0.0, 0.0), (0.0, float(answer[0]["X"]))] + [(i * 1.0, float(row["X"])) for i, row in enumerate(answer)]


def logarithmic(low, high, count):
    return [low * (high / low) ** (i / (count - 1)) for i in range(count)]


class Plot:
    def __init__(self, title, x_label, y_label, x_range, y_range, x_ticks, y_ticks, log=False,
                 legend="left"):
        self.legend = legend
        self.title, self.x_label, self.y_label = title, x_label, y_label
        self.x_range, self.y_range, self.x_ticks, self.y_ticks, self.log = x_range, y_range, x_ticks, y_ticks, log
        self.curves = []

    def add(self, name, points):
        self.curves.append((name, points))

    def x(self, value):
        low, high = self.x_range
        share = math.log(value / low) / math.log(high / low) if self.log else (value - low) / (high - low)
        return LEFT + share * (WIDTH - LEFT - RIGHT)

    def y(self, value):
        low, high = self.y_range
        return HEIGHT - BOTTOM - (value - low) / (high - low) * (HEIGHT - TOP - BOTTOM)

    def legend_corner(self):
        """Where the first line of the legend stands; the corners are left and right (both low) and top."""
        lines = 16 * (len(self.curves) - 1)
        if self.legend == "top":
            return LEFT, TOP + 18
        return LEFT if self.legend == "left" else WIDTH - 180, HEIGHT - BOTTOM - 12 - lines

    def svg(self):
        out = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {HEIGHT}" '
               'font-family="sans-serif" font-size="12">',
               f'<rect width="{WIDTH}" height="{HEIGHT}" fill="white"/>',
               f'<clipPath id="plot"><rect x="{LEFT}" y="{TOP}" width="{WIDTH - LEFT - RIGHT}" '
               f'height="{HEIGHT - TOP - BOTTOM}"/></clipPath>',
               f'<text x="{LEFT}" y="18" font-size="13">{self.title}</text>']
        for tick in self.x_ticks:
            x = self.x(tick)
            out.append(f'<path d="M{x:.1f} {TOP}V{HEIGHT - BOTTOM}" stroke="#ddd"/>')
            out.append(f'<text x="{x:.1f}" y="{HEIGHT - BOTTOM + 16}" text-anchor="middle">{tick:g}</text>')
        for tick in self.y_ticks:
            y = self.y(tick)
            out.append(f'<path d="M{LEFT} {y:.1f}H{WIDTH - RIGHT}" stroke="#ddd"/>')
            out.append(f'<text x="{LEFT - 6}" y="{y + 4:.1f}" text-anchor="end">{tick:g}</text>')
        out.append(f'<text x="{(LEFT + WIDTH - RIGHT) / 2}" y="{HEIGHT - 8}" text-anchor="middle">{self.x_label}</text>')
        out.append(f'<text transform="translate(14 {(TOP + HEIGHT - BOTTOM) / 2}) rotate(-90)" '
                   f'text-anchor="middle">{self.y_label}</text>')
        corner_x, corner_y = self.legend_corner()
        for i, (name, points) in enumerate(self.curves):
            path = " ".join(f"{self.x(x):.1f},{self.y(y):.1f}" for x, y in points)
            colour = COLOURS[i % len(COLOURS)]
            out.append(f'<polyline points="{path}" fill="none" stroke="{colour}" stroke-width="1.6" '
                       'clip-path="url(#plot)"/>')
            y = corner_y + 16 * i
            out.append(f'<path d="M{corner_x + 12} {y - 4}h22" stroke="{colour}" stroke-width="3"/>')
            out.append(f'<text x="{corner_x + 40}" y="{y}">{name}</text>')
        return "\n".join((*out, "</svg>")) + "\n"


PROTOTYPES = (("CRIT_DAMPING", "critical damping"), ("BESSEL", "Bessel"), ("BUTTERWORTH", "Butterworth"))


def of(kind, prototype, order, f0, *more):
    return [f"type {kind}", f"prototype {prototype}", f"order {order}", f"fg_f0 {f0}", *more]


def plots(program):
    wide = logarithmic(1.0, 450.0, 160)
    around = logarithmic(10.0, 90.0, 241)
    decades = (1, 2, 5, 10, 20, 50, 100, 200)

    plot = Plot("Low-pass, order 4, 15 Hz", "frequency in Hz", "magnitude in dB", (1, 450), (-60, 6), decades,
                (-60, -40, -20, -3, 0), log=True)
    for key, name in PROTOTYPES:
        plot.add(name, response(program, of("LOWPASS", key, 4, 15), wide))
    yield "lowpass-prototypes-response", plot

    plot = Plot("Low-pass, order 4, 15 Hz", "time in ms", "step response", (0, 120), (0, 1.2), range(0, 121, 20),
                (0, 0.2, 0.4, 0.6, 0.8, 1.0, 1.2), legend="right")
    for key, name in PROTOTYPES:
        plot.add(name, step(program, of("LOWPASS", key, 4, 15), 121))
    yield "lowpass-prototypes-step", plot

    plot = Plot("Low-pass, critical damping, 15 Hz", "time in ms", "step response", (0, 120), (0, 1.2),
                range(0, 121, 20), (0, 0.2, 0.4, 0.6, 0.8, 1.0, 1.2), legend="right")
    for order in (1, 2, 4, 6):
        plot.add(f"order {order}", step(program, of("LOWPASS", "CRIT_DAMPING", order, 15), 121))
    yield "lowpass-orders-step", plot

    plot = Plot("Band-stop, Butterworth, 30 Hz, guete 2", "frequency in Hz", "magnitude in dB", (10, 90), (-60, 6),
                (10, 20, 30, 40, 50, 70, 90), (-60, -40, -20, -3, 0), log=True)
    for order in (1, 2, 3):
        plot.add(f"order {order}", response(program, of("BANDSTOP", "BUTTERWORTH", order, 30, "guete 2"), around))
    yield "bandstop-orders-response", plot

    plot = Plot("Band-stop, order 2, 30 Hz, guete 2", "time in ms", "step response", (0, 250), (0.4, 1.3),
                range(0, 251, 50), (0.4, 0.6, 0.8, 1.0, 1.2), legend="right")
    for key, name in PROTOTYPES:
        plot.add(name, step(program, of("BANDSTOP", key, 2, 30, "guete 2"), 251))
    yield "bandstop-prototypes-step", plot

    plot = Plot("All-pass, order 4, 15 Hz", "frequency in Hz", "group delay in ms", (1, 60), (0, 90),
                (1, 2, 5, 10, 20, 50), range(0, 91, 15), log=True)
    for key, name in PROTOTYPES:
        plot.add(name, response(program, of("ALLPASS", key, 4, 15), logarithmic(1.0, 60.0, 160), "delay"))
    yield "allpass-prototypes-delay", plot

    plot = Plot("TIME_DELAY, T = 1 ms", "frequency in Hz", "group delay in ms", (0, 500), (0, 7), range(0, 501, 100),
                range(0, 8), legend="top")
    for time in (400, 1700, 3000, 4400):
        lines = ["type TIME_DELAY", "order 1", f"time_constant {time}"]
        plot.add(f"{time} us", response(program, lines, [5.0 * i for i in range(100)], "delay"))
    yield "time-delay-delay", plot


def main():
    program, folder = sys.argv[1], Path(sys.argv[2])
    folder.mkdir(parents=True, exist_ok=True)
    for name, plot in plots(program):
        (folder / f"{name}.svg").write_text(plot.svg())


main()
