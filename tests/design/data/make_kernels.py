#!/usr/bin/env python3
"""Writes kernels.json: tail sums and frequency responses of FIR kernels, computed independently of design/.

make_kernels.py > kernels.json       (Python standard library only)

Where design/ works on one half of the kernel, with recurrences and closed forms, this script evaluates every tap by its
definition in 60 decimal digits (the moving average in fractions), convolves NoVib's box tap by tap, and takes the
response as the sum over all taps. A parameter means its nearest double, and results are written as nearest doubles.
"""
import json
from decimal import ROUND_CEILING, Decimal, getcontext
from fractions import Fraction

getcontext().prec = 60
TINY = Decimal(10) ** -58


def arctangent_of_inverse(n):
    total, power, k = Decimal(0), Decimal(1) / n, 0
    while power > TINY:
        total += (-1) ** k * power / (2 * k + 1)
        power /= n * n
        k += 1
    return total


PI = 4 * (4 * arctangent_of_inverse(5) - arctangent_of_inverse(239))


def series(x, term, k):
    total = term
    while abs(term) > TINY:
        term *= -x * x / ((k + 1) * (k + 2))
        total += term
        k += 2
    return total


def sine(x):
    x %= 2 * PI
    return series(x, x, 1)


def cosine(x):
    x %= 2 * PI
    return series(x, Decimal(1), 0)


def moving_average(order, **_):
    h = -(-order // 2)
    return [Fraction(1)] * (2 * h + 1)


def gaussian(order, quality, **_):
    h = -(-order // 2)
    sigma = Decimal(float(quality)) * h / Decimal("2.5")
    return [(-(Decimal(k) / sigma) ** 2 / 2).exp() for k in range(-h, h + 1)]


def windowed_sinc(order, frequency, T, **_):
    h = -(-order // 2)

    def tap(k):
        x = 2 * Decimal(float(frequency)) * T * k * PI
        window = Decimal("0.54") + Decimal("0.46") * cosine(PI * k / h)
        return window * (sine(x) / x if k else 1)
    return [tap(k) for k in range(-h, h + 1)]


def novib(frequency, T, **_):
    f0 = Decimal(float(frequency))
    m = int(((1 / (f0 * T) - 1) / 2).to_integral_value(ROUND_CEILING)) - 1
    theta = 2 * PI * f0 * T
    w = -(1 + 2 * sum(cosine(k * theta) for k in range(1, m + 1))) / (2 * cosine((m + 1) * theta))
    box = [w] + [Decimal(1)] * (2 * m + 1) + [w]
    taps = [Decimal(0)] * (2 * len(box) - 1)
    for i, x in enumerate(box):
        for j, y in enumerate(box):
            taps[i + j] += x * y
    return taps


def shared(taps, percent, number):
    s = number(float(percent)) / 100
    total = sum(taps)
    taps = [s * b / total for b in taps]
    taps[len(taps) // 2] += 1 - s
    return taps


def tail_sums(taps):
    sums, tail = [], 0
    for b in reversed(taps[1:]):
        tail += b
        sums.append(tail)
    return sums[::-1]


def response(taps, frequency, T):
    theta = 2 * PI * Decimal(frequency) * T
    taps = [Decimal(b.numerator) / b.denominator if isinstance(b, Fraction) else b for b in taps]
    return [frequency, float(sum(b * cosine(n * theta) for n, b in enumerate(taps))),
            float(-sum(b * sine(n * theta) for n, b in enumerate(taps)))]


KINDS = {"moving_average": moving_average, "gaussian": gaussian, "windowed_sinc": windowed_sinc, "novib": novib}


def case(kind, cycle_time_us, share="100", **parameters):
    T = Decimal(cycle_time_us) / 1000000
    number = Fraction if kind == "moving_average" else Decimal
    taps = shared(KINDS[kind](T=T, **parameters), share, number)
    sums = tail_sums(taps)
    step = 1 if len(sums) <= 12 else 7
    limit = 500000 / cycle_time_us
    return {"kind": kind, "cycle_time_us": cycle_time_us, "share": float(share),
            **{name: float(value) for name, value in parameters.items()},
            "half_width": len(sums) // 2,
            "tail_sums": [[j, float(sums[j])] for j in range(0, len(sums), step)],
            "response": [response(taps, f, T) for f in (0.25, limit / 64, limit / 5, limit * 0.75)]}


CASES = [
    case("moving_average", 1000, order=1),
    case("moving_average", 1000, order=20),
    case("moving_average", 4000, order=21, share="62.5"),
    case("moving_average", 125, order=200, share="0.1"),
    case("gaussian", 1000, order=2, quality="1"),
    case("gaussian", 1000, order=40, quality="1"),
    case("gaussian", 250, order=199, quality="0.125"),
    case("gaussian", 2000, order=75, quality="0.5", share="12.5"),
    case("windowed_sinc", 1000, order=1, frequency="30"),
    case("windowed_sinc", 1000, order=40, frequency="100"),
    case("windowed_sinc", 125, order=200, frequency="1"),
    case("windowed_sinc", 4000, order=33, frequency="124.5", share="75"),
    case("novib", 1000, frequency="10"),
    case("novib", 1000, frequency="53"),
    case("novib", 250, frequency="1750"),
    case("novib", 125, frequency="400.5", share="87.5"),
    case("novib", 2000, frequency="20"),
]

print("[\n" + ",\n".join(json.dumps(c) for c in CASES) + "\n]")
