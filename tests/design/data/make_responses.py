#!/usr/bin/env python3
"""Writes responses.json: frequency and step responses of standard filters, computed independently of design/.

make_responses.py > responses.json       (Python standard library only)

Where design/ works with poles and second-order sections, this script multiplies whole polynomials: prototype as a
polynomial in s, substitution for the filter type, bilinear substitution, difference equation of the full order, all in
80 decimal digits. It finds no roots, except Butterworth's, which are known.
"""
import json
from decimal import Decimal, getcontext
from math import comb

getcontext().prec = 80
TINY = Decimal(10) ** -78


def sine(x):
    term, total, k = x, x, 1
    while abs(term) > TINY:
        term *= -x * x / ((2 * k) * (2 * k + 1))
        total += term
        k += 1
    return total


def cosine(x):
    term, total, k = Decimal(1), Decimal(1), 1
    while abs(term) > TINY:
        term *= -x * x / ((2 * k - 1) * (2 * k))
        total += term
        k += 1
    return total


def tangent(x):
    return sine(x) / cosine(x)


def arctangent_of_inverse(n):
    total, power, k = Decimal(0), Decimal(1) / n, 0
    while power > TINY:
        total += (-1) ** k * power / (2 * k + 1)
        power /= n * n
        k += 1
    return total


PI = 4 * (4 * arctangent_of_inverse(5) - arctangent_of_inverse(239))


def times(a, b):
    product = [Decimal(0)] * (len(a) + len(b) - 1)
    for i, x in enumerate(a):
        for j, y in enumerate(b):
            product[i + j] += x * y
    return product


def power(a, n):
    product = [Decimal(1)]
    for _ in range(n):
        product = times(product, a)
    return product


def plus(a, b):
    n = max(len(a), len(b))
    return [(a[i] if i < len(a) else 0) + (b[i] if i < len(b) else 0) for i in range(n)]


def substitute(a, degree, numerator, denominator):
    """The numerator of a(numerator/denominator) · denominator^degree."""
    total = [Decimal(0)]
    for k, x in enumerate(a):
        total = plus(total, [x * y for y in times(power(numerator, k), power(denominator, degree - k))])
    return total


def prototype(name, n):
    """Denominator of the low-pass, lowest power first; the numerator is its first coefficient."""
    if name == "CRIT_DAMPING":
        root = (Decimal(2).ln() / n).exp()
        return power([Decimal(1), (root - 1).sqrt()], n)
    if name == "BUTTERWORTH":
        den = [Decimal(1), Decimal(1)] if n % 2 else [Decimal(1)]
        for i in range(n // 2):
            den = times(den, [Decimal(1), 2 * sine(PI * (2 * i + 1) / (2 * n)), Decimal(1)])
        return den
    theta = [Decimal(comb(2 * n - k, n) * comb(n, k))
             * Decimal(factorial(n - k)) / Decimal(2) ** (n - k) for k in range(n + 1)]
    low, high = Decimal(0), Decimal(10)
    while high - low > Decimal(10) ** -75:
        w = (low + high) / 2
        re = sum((-1) ** (k // 2) * theta[k] * w ** k for k in range(0, n + 1, 2))
        im = sum((-1) ** (k // 2) * theta[k] * w ** k for k in range(1, n + 1, 2))
        low, high = (w, high) if re * re + im * im < 2 * theta[0] ** 2 else (low, w)
    return [c * low ** k for k, c in enumerate(theta)]


def factorial(n):
    return 1 if n < 2 else n * factorial(n - 1)


def analogue(case, cycle):
    """Numerator and denominator in s, normalised to the frequency that t = tan(π f T) belongs to."""
    kind, n = case["type"], case.get("order", 1)
    one = Decimal(1)
    if kind in ("PT1", "PT2"):
        tau = Decimal(case["time_constant"]) / 10 ** 6
        return [one], power([one, one], 1 if kind == "PT1" else 2), tangent(cycle / (2 * tau))
    den = prototype(case["prototype"], n)
    f0 = Decimal(case["frequency"])
    t = tangent(PI * f0 * cycle)
    if kind == "LOWPASS":
        return [den[0]], den, t
    if kind == "HIGHPASS":
        return [Decimal(0)] * n + [den[0]], den[::-1], t
    if kind == "ALLPASS":
        return [(-1) ** k * c for k, c in enumerate(den)], den, t
    q = sine(2 * PI * f0 * cycle) / (2 * tangent(PI * f0 / Decimal(case["quality"]) * cycle))
    band, line = [q, Decimal(0), q], [Decimal(0), one]
    top, bottom = (band, line) if kind == "BANDPASS" else (line, band)
    return [den[0] * c for c in power(bottom, n)], substitute(den, n, top, bottom), t


def digital(case, cycle):
    """Numerator and denominator in z^-1."""
    if case["type"] == "TIME_DELAY":
        d = Decimal(case["time_constant"]) / 10 ** 6 / cycle
        if d == int(d):
            return [Decimal(0)] * int(d) + [Decimal(1)], [Decimal(1)]
        n = max(1, int(d + Decimal("0.5")))
        a = []
        for k in range(n + 1):
            product = Decimal((-1) ** k * comb(n, k))
            for i in range(n + 1):
                product *= (d - n + i) / (d - n + k + i)
            a.append(product)
        return a[::-1], a
    num, den, t = analogue(case, cycle)
    degree = len(den) - 1
    top, bottom = [Decimal(1), Decimal(-1)], [t, t]
    return substitute(num, degree, top, bottom), substitute(den, degree, top, bottom)


def response(num, den, share, angle):
    def value(a):
        return (sum(x * cosine(k * angle) for k, x in enumerate(a)),
                -sum(x * sine(k * angle) for k, x in enumerate(a)))
    (br, bi), (ar, ai) = value(num), value(den)
    n = ar * ar + ai * ai
    return (share * (br * ar + bi * ai) / n + 1 - share, share * (bi * ar - br * ai) / n)


def step_response(num, den, share, cycles):
    y = []
    for n in range(cycles):
        total = sum(num[: n + 1]) - sum(den[k] * y[n - k] for k in range(1, min(n, len(den) - 1) + 1))
        y.append(total / den[0])
    return [share * v + 1 - share for v in y]


def cases():
    for name, shift in (("CRIT_DAMPING", 0), ("BUTTERWORTH", 1), ("BESSEL", 2)):
        for kind, orders in (("LOWPASS", (2, 5)), ("HIGHPASS", (1, 4)), ("ALLPASS", (3, 6))):
            for i, order in enumerate(orders):
                yield {"type": kind, "prototype": name, "order": order,
                       "frequency": ("12.5", "77.3", "3")[(shift + i) % 3], "cycle_time_us": (1000, 250, 4000)[shift]}
        for kind in ("BANDPASS", "BANDSTOP"):
            for order in (1, 2, 3):
                yield {"type": kind, "prototype": name, "order": order, "frequency": ("41", "8.25", "23.7")[shift],
                       "quality": ("1", "4.5", "10")[(order + shift) % 3], "cycle_time_us": (2000, 1000, 500)[shift]}
    yield {"type": "LOWPASS", "prototype": "BESSEL", "order": 6, "frequency": "480", "cycle_time_us": 1000}
    yield {"type": "BANDSTOP", "prototype": "BUTTERWORTH", "order": 3, "frequency": "1", "quality": "10",
           "cycle_time_us": 125}
    for tau, cycle in (("1000", 1000), ("20000", 500)):
        yield {"type": "PT1", "time_constant": tau, "cycle_time_us": cycle}
        yield {"type": "PT2", "time_constant": tau, "cycle_time_us": cycle, "share": "62.5"}
    for delay in ("300", "1400", "1700", "3000", "3600", "4400", "5999"):
        yield {"type": "TIME_DELAY", "time_constant": delay, "cycle_time_us": 1000}
    yield {"type": "HIGHPASS", "prototype": "BESSEL", "order": 3, "frequency": "20", "share": "30",
           "cycle_time_us": 1000}


def main():
    rows = []
    for case in cases():
        cycle = Decimal(case["cycle_time_us"]) / 10 ** 6
        num, den = digital(case, cycle)
        share = Decimal(case.get("share", 100)) / 100
        centre = Decimal(case.get("frequency", "30"))
        # Doubles, because that is what the program is asked for.
        frequencies = [float(centre / 3), float(centre), float(Decimal("0.4") / cycle)]
        points = []
        for f in frequencies:
            re, im = response(num, den, share, 2 * PI * Decimal(f) * cycle)
            points.append([f, float(re), float(im)])
        step = [float(v) for v in step_response(num, den, share, 120)]
        rows.append({**case, "response": points, "step": step[:4] + step[7::28]})
    print("[")
    print(",\n".join(json.dumps(row) for row in rows))
    print("]")


main()
