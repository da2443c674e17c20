#!/usr/bin/env python3
"""Checks the bounds of coefficient images in whole numbers of 220 binary places, and so those who check them.

    check.py IMAGE...

Where axisc and examples/axim_check.c sum up doubles and count their errors, this program follows every chain
twice as long with next to no error, and looks whether the claims enclose what it finds: gains, overshoot,
distance, poles, states, and the sum of all roundings (docs/image-format.md, "Bounds"). Records of more than
4,000 cycles are left out, and so are rest_cycles. Exit status 1 if a claim is false, or far from tight.
"""
import struct
import sys
from fractions import Fraction

PLACES = 220
ONE = 1 << PLACES
MOST_CYCLES = 4000
TIGHT = Fraction(1, 10**9)
NONE = 0xFFFFFFFF


def fixed(value):
    return int(Fraction(value) * ONE)


def times(a, b):
    return a * b >> PLACES


class Image:
    def __init__(self, path):
        self.bytes = open(path, "rb").read()
        self.sections = {}
        for i in range(self.u32(28)):
            kind, _, offset, _, size, count = struct.unpack_from("<IIQQII", self.bytes, 128 + 32 * i)
            self.sections[kind] = (offset, size, count)

    def u32(self, at):
        return struct.unpack_from("<I", self.bytes, at)[0]

    def f64(self, at):
        return struct.unpack_from("<d", self.bytes, at)[0]

    def at(self, kind, index):
        offset, size, count = self.sections[kind]
        assert index < count
        return offset + index * size

    def count(self, kind):
        return self.sections.get(kind, (0, 0, 0))[2]


class Section:
    """p, g, k, b, and the sums of |A^n| that errors meet, run until nothing is left."""

    def __init__(self, image, at, blocks):
        self.stored = [image.f64(at + 8 * i) for i in range(4)]
        p, q, k, b = (fixed(x) for x in self.stored)
        self.p, self.g, self.k, self.b, self.blocks = p, p + q, k, b, blocks
        self.ee, self.re, _ = self.walk(ONE, 0)
        self.er, self.rr, self.change = self.walk(0, ONE)
        self.excess, self.following, _ = self.walk(p, self.g - times(k + b, p))
        self.passed = (abs(p) if blocks else abs(ONE + p)) + self.following

    def walk(self, e, r):
        of_e = of_r = change = 0
        while abs(e) + abs(r) > ONE >> 90:
            of_e += abs(e)
            of_r += abs(r)
            e += r
            last, r = r, r - times(self.b, r) - times(self.k, e)
            change += abs(r - last)
        return of_e, of_r, change

    def is_within(self, radius):
        _, _, k, b = (Fraction(x) for x in self.stored)
        if radius == 0:
            return k == 1 and b == 1
        return abs(1 - b) <= radius**2 and abs(2 - k - b) * radius <= radius**2 + 1 - b


class Filter:
    def __init__(self, image, at, base):
        delays = image.u32(at + 12) == 2
        self.blocks = image.u32(at + 20) != 0
        first, count = image.u32(at + 24), image.u32(at + 28)
        self.sections = [Section(image, image.at(3, first + i), self.blocks) for i in range(count)]
        self.delay = image.u32(at + 32) if delays else 0
        self.passes = not self.sections and self.delay == 0
        self.share = fixed(image.f64(at + 48))
        # What the exact filter uses: 1 - share, however it is stored.
        self.direct = ONE - self.share
        self.is_shared = image.f64(at + 48) not in (0, 1)
        self.base = base


class Sizes:
    """Sums of magnitudes of d, de, e, r, and of their changes."""

    def __init__(self):
        self.v, self.x, self.last = [0] * 4, [0] * 4, [0] * 4

    def add(self, values):
        for i, value in enumerate(values):
            self.v[i] += abs(value)
            self.x[i] += abs(value - self.last[i])
        self.last = values


class Run:
    def __init__(self, filters, tails, cycles):
        self.filters = filters
        self.states = [[[0, 0] for _ in f.sections] for f in filters]
        self.sizes = [[Sizes() for _ in f.sections] for f in filters]
        self.rings = [[(-f.base, 0)] * f.delay for f in filters]
        self.gain = self.distance = self.change = last = 0
        self.highest = None
        for n in range(cycles):
            before = ONE if n == 0 else tails[n - 1] if n <= len(tails) else 0
            tail = tails[n] if n < len(tails) else 0
            excess, d = self.step(-tail, before - tail)
            self.gain += abs(d)
            self.distance += abs(excess)
            self.change += abs(d - last)
            last = d
            self.highest = excess if self.highest is None else max(self.highest, excess)

    def step(self, excess, d):
        for f, states, sizes, ring in zip(self.filters, self.states, self.sizes, self.rings):
            y, yd = (0 if f.blocks else excess), d
            for section, state, size in zip(f.sections, states, sizes):
                de = times(section.p, yd) + state[1]
                state[0] += de
                state[1] += times(section.g, yd) - times(section.k, state[0]) - times(section.b, de)
                size.add([yd, de, state[0], state[1]])
                y, yd = (state[0], de) if f.blocks else (y + state[0], yd + de)
            if f.delay:
                y, yd = ring.pop(0)
                ring.append((excess, d))
            excess = times(f.share, y) + times(f.direct, excess)
            d = times(f.share, yd) + times(f.direct, d)
        return excess, d

    def rounding(self, measure, total, d, to_sum, to_d):
        """Errors of all operations in units of u, and what errors before the chain do to its end."""
        path = lambda f: (f.delay if measure == "v" else 2) * ONE
        before, error = [], 0
        for f, sizes in zip(self.filters, self.sizes):
            of = [getattr(size, measure) for size in sizes]
            in_sum, in_d = total, d
            if of:
                in_sum = of[-1][2] if f.blocks else total + sum(size[2] for size in of)
                in_d = of[-1][1] if f.blocks else of[-1][0] + of[-1][1]
            before.append((f, of, total, d, in_sum, in_d))
            total = times(f.share, in_sum) + times(f.direct, total + (path(f) if f.delay else 0))
            d = times(f.share, in_d) + times(f.direct, d)
        position = ONE
        for f, of, sum_before, d_before, in_sum, in_d in reversed(before):
            behind = to_sum, to_d, position
            share = 4 * f.share + (ONE >> 9) if f.is_shared else 0
            direct = (5 if f.delay else 4) * f.direct + (ONE >> 9) if f.is_shared else 0
            if f.delay:
                error += times(share + direct, times(path(f) + sum_before, to_sum) + times(d_before, to_d))
                continue
            error += times(times(share, in_sum) + times(direct, sum_before), to_sum)
            error += times(times(share, in_d) + times(direct, d_before), to_d)
            to_sum, to_d, position = (times(f.share, x) for x in behind)
            for i in reversed(range(len(of))):
                s, (D, DE, E, R) = f.sections[i], of[i]
                to_e = 0 if f.blocks and i + 1 < len(of) else to_sum
                if not f.blocks:
                    error += times(in_sum, to_sum) + times(D + DE, to_d)
                    in_sum -= E
                p = abs(s.p) * (1 if abs(s.stored[0]) >= 2.0**-44 else 2**53 + 1)
                g = abs(s.g) * (4 if abs(s.stored[0] + s.stored[1]) >= 2.0**-62 else 2**53 + 4)
                of_r = times(to_e, s.er) + times(to_d, s.rr)
                error += times(times(p, D) + DE, times(to_e, s.rr) + times(to_d, ONE + s.change))
                error += times(E, times(to_e, s.ee - ONE) + times(to_d, s.re))
                error += times(times(g, D) + 3 * times(s.k, E) + 2 * times(s.b, DE) + R, of_r)
                to_d = times(to_e, s.excess) + times(s.passed, to_d)
                position = times(position, s.passed)
            to_sum = (0 if f.blocks else to_sum) + times(f.direct, behind[0])
            to_d += times(f.direct, behind[1])
            position += times(f.direct, behind[2])
        return error, to_sum, to_d, position, total


def rounding_error(alone, joint, tails, is_before, measure):
    d = ONE if measure == "v" else 2 * ONE
    S = sum(abs(x) for x in tails)
    taps = sum(abs(x - y) for x, y in zip([ONE] + tails, tails + [0]))
    kernel = (10 * len(tails) + 16) * S + (ONE >> 60)
    if not tails:
        error, _, to_d, _, _ = alone.rounding(measure, 0, d, ONE, 0)
        more = times(d, to_d)
    elif is_before:
        error, to_sum, to_d, position, _ = joint.rounding(measure, times(S, d), times(taps, d), ONE, 0)
        more = 2 * times(S, to_sum) + times(taps, to_d) + times(kernel, position)
        more = times(d, more + times(ONE + 2 * taps, to_d))
    else:
        error, _, to_d, _, total = alone.rounding(measure, 0, d, ONE, S)
        out = alone.gain if measure == "v" else alone.change
        more = times(d, to_d) + times(kernel, out) + total + times(S, out)
    return Fraction(error + more, ONE << 53)


class Checker:
    def __init__(self, image):
        self.image, self.chains, self.slots = image, {}, {}
        self.failures = self.checked = self.left_out = 0
        for i in range(image.count(6)):
            self.slots[image.u32(image.at(6, i))] = image.u32(image.at(6, i) + 4)

    def fail(self, index, field, claimed, found):
        self.failures += 1
        print(f"record {index}: {field} claims {float(claimed)!r}, found {float(found)!r}")

    def filters(self, axis, port, stage):
        image = self.image
        at = image.at(12, stage) + 8 if port == 2 else image.at(1, axis) + (28 if port == 1 else 20)
        filters, base = [], ONE
        for i in range(image.u32(at + 4)):
            f = Filter(image, image.at(2, image.u32(at) + i), base)
            base = times(base, f.direct) if f.blocks else base
            if not f.passes:
                filters.append(f)
        return filters, base

    def check(self, index):
        image, at = self.image, self.image.at(20, index)
        axis, port, kernel, flags, cycles, stage = struct.unpack_from("<6I", image.bytes, at)
        if cycles > MOST_CYCLES:
            self.left_out += 1
            return
        self.checked += 1
        claim = {name: Fraction(image.f64(at + 24 + 8 * i)) for i, name in enumerate(
            ("gain_low", "gain_high", "overshoot_high", "distance_high", "radius_high", "rounding_increment",
             "rounding_position", "state_increment", "state_position"))}
        key = axis, port, stage
        if key not in self.chains:
            filters, base = self.filters(*key)
            self.chains = {key: (filters, base, Run(filters, [], 2 * cycles))}
        filters, base, alone = self.chains[key]
        tails, is_before = [], self.slots.get(axis) == 1 and port == 0
        if kernel != NONE:
            record = image.at(4, kernel)
            first, count = image.u32(record + 16), image.u32(record + 20)
            tails = [fixed(image.f64(image.at(5, first + j))) for j in range(count)]
        joint = Run(filters, tails, 2 * cycles) if tails else alone
        executed = joint if is_before else alone

        def enclose(field, found, width=TIGHT, more=Fraction(0)):
            found = Fraction(found)
            # 2^-80 is what twice the cycles leave.
            if claim[field] < found * (1 - Fraction(1, 1 << 60)) - Fraction(1, 1 << 80):
                self.fail(index, field, claim[field], found)
            if not flags and claim[field] > found * (1 + width) + more:
                self.fail(index, field + " (not tight)", claim[field], found)

        E = claim["rounding_increment"]
        gain = Fraction(joint.gain, ONE)
        enclose("gain_high", gain)
        if claim["gain_low"] > gain or (not flags and claim["gain_low"] < gain * (1 - TIGHT)):
            self.fail(index, "gain_low", claim["gain_low"], gain)
        if base > 0:
            enclose("overshoot_high", Fraction(max(joint.highest, 0), base), more=2 * E + Fraction(1, 10**8))
        if base == ONE:
            enclose("distance_high", Fraction(joint.distance, ONE), more=2 * E)
        for f in filters:
            for section in f.sections:
                if not section.is_within(claim["radius_high"]):
                    self.fail(index, "radius_high", claim["radius_high"], 1)
        sizes = [size for of_filter in executed.sizes for size in of_filter]
        for field, measure in (("state_increment", "v"), ("state_position", "x")):
            enclose(field, Fraction(max((max(getattr(s, measure)[2:]) for s in sizes), default=0), ONE), 1e-5)
        for field, measure in (("rounding_increment", "v"), ("rounding_position", "x")):
            enclose(field, rounding_error(alone, joint, tails, is_before, measure), Fraction(1, 10**4))


def main(paths):
    failures = 0
    for path in paths:
        checker = Checker(Image(path))
        for index in range(checker.image.count(20)):
            checker.check(index)
        print(f"{path}: {checker.checked} records checked, {checker.left_out} left out, "
              f"{checker.failures} claims false")
        failures += checker.failures
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
