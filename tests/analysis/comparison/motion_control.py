"""A control that plans paths in a known reading of what its manuals leave open, made without axisc's arithmetic: plain Python, mm and s.

It reads the few words that `axisc compare --emit program` writes. Blocks are planned by way(v) and bisection, where axisc has closed
forms and windows; all blocks between two rests are known at once.
"""
import itertools
import math
import re

KEYS = {"projection": ("weakest-jerk", "longest-ramp"), "borders": ("rest", "continuous"),
        "sine": ("ramps", "whole-change", "same-peak-jerk"), "circle": ("shared", "full"),
        "corner": ("per-cycle", "up-only", "down-only"), "weights": ("r-follows-a", "a-follows-r"),
        "cycles": ("continuous", "whole"), "hsc": ("stretches", "trapez")}
T = 0.001
RAMPS = ("up_build", "up_take", "down_build", "down_take")


def combinations(keys):
    """Each reading of these keys with each of the others."""
    for words in itertools.product(*(KEYS[key] for key in keys)):
        yield dict(zip(keys, words))


# Ramps: from a slow to a fast velocity; braking is the same backwards in time.

class Ramp:
    def __init__(self, a, slow_time, fast_time, sine, constant_times, readings):
        self.whole_change = sine and readings["sine"] == "whole-change"
        if self.whole_change:
            slow_time = fast_time = (slow_time + fast_time) / 2
        self.a, self.slow, self.fast = a, slow_time, fast_time
        self.sine, self.constant_times = sine, constant_times
        self.whole_cycles = readings["cycles"] == "whole"

    def course(self, change):
        """Peak, time of the slow end, at the peak, of the fast end."""
        if change <= 0:
            return 0.0, 0.0, 0.0, 0.0
        both = self.slow + self.fast
        if change >= self.a * both / 2:
            peak, slow, held, fast = self.a, self.slow, change / self.a - both / 2, self.fast
            if self.whole_change:
                slow, held, fast = change / self.a, 0.0, change / self.a
        elif self.constant_times:
            peak, slow, held, fast = 2 * change / both, self.slow, 0.0, self.fast
        else:
            q = math.sqrt(2 * change / (self.a * both))
            peak, slow, held, fast = q * self.a, q * self.slow, 0.0, q * self.fast
        if self.whole_cycles:
            slow, fast = (T * max(1, math.ceil(t / T - 1e-9)) for t in (slow, fast))
            held = T * max(0, math.ceil(held / T - 1e-9))
            peak = change / ((slow + fast) / 2 + held)
        return peak, slow, held, fast

    def way(self, slow, fast):
        if fast <= slow:
            return 0.0
        p, ts, h, tf = self.course(fast - slow)
        c1 = 1 / 4 - 1 / math.pi ** 2 if self.sine else 1 / 6
        c2 = 1 / 4 + 1 / math.pi ** 2 if self.sine else 1 / 3
        return slow * (ts + h + tf) + p * (c1 * ts * ts + ts * h / 2 + h * h / 2 + (ts / 2 + h) * tf + c2 * tf * tf)

    def velocity_and_way(self, course, slow, t):
        """So long after the slow end."""
        p, ts, h, tf = course
        v, s = slow, 0.0
        step = min(t, ts)
        if step > 0:
            s += v * step + p * self.risen(step, ts)[1]
            v += p * self.risen(step, ts)[0]
        step = min(max(t - ts, 0), h)
        s += v * step + p * step * step / 2
        v += p * step
        step = min(max(t - ts - h, 0), tf)
        if step > 0:  # the fall is the rise backwards: p - rise(tf - t)
            whole, rest = self.risen(tf, tf), self.risen(tf - step, tf)
            s += v * step + p * (whole[0] * step - (whole[1] - rest[1]))
            v += p * (whole[0] - rest[0])
        return v, s

    def risen(self, t, whole):
        """Velocity and way that an acceleration rising to 1 within `whole` has given by t."""
        if not self.sine:
            return t * t / (2 * whole), t ** 3 / (6 * whole)
        w = math.pi / whole
        return t / 2 - math.sin(w * t) / (2 * w), t * t / 4 - (1 - math.cos(w * t)) / (2 * w * w)


def highest(fits, low, high):
    """The highest number up to `high` for which a condition holds that holds for `low` and only ends."""
    if fits(high):
        return high
    for _ in range(200):
        middle = (low + high) / 2
        if middle in (low, high):
            break
        low, high = (middle, high) if fits(middle) else (low, middle)
    return low


class Profile:
    """From one velocity to another: up, along, down."""

    def __init__(self, up, down, length, v0, v1, limit):
        self.up, self.down, self.length, self.v0, self.v1 = up, down, length, v0, v1
        self.v = highest(lambda v: up.way(v0, v) + down.way(v1, v) <= length, max(v0, v1), max(limit, v0, v1))
        self.course_up, self.course_down = up.course(self.v - v0), down.course(self.v - v1)
        self.t_up, self.t_down = sum(self.course_up[1:]), sum(self.course_down[1:])
        self.way_up = up.way(v0, self.v)
        along = max(0.0, length - self.way_up - down.way(v1, self.v))
        self.t_along = along / self.v if self.v > 0 else 0.0
        self.time = self.t_up + self.t_along + self.t_down

    def at(self, t):
        """Velocity and way."""
        if t < self.t_up:
            return self.up.velocity_and_way(self.course_up, self.v0, t)
        if t < self.t_up + self.t_along:
            return self.v, self.way_up + self.v * (t - self.t_up)
        v, left = self.down.velocity_and_way(self.course_down, self.v1, max(0.0, self.time - t))
        return v, self.length - left

    def signature(self):
        """The same for the same motion."""
        parts = (self.v0, self.v1, self.length, self.t_along, *self.course_up, *self.course_down)
        return self.up.sine, tuple(round(part, 11) for part in parts)

    def velocity_at(self, way):
        low, high = 0.0, self.time
        for _ in range(80):
            middle = (low + high) / 2
            low, high = (middle, high) if self.at(middle)[1] < way else (low, middle)
        return self.at(low)[0]

    def highest_between(self, begin, end):
        top_begin, top_end = self.up.way(self.v0, self.v), self.length - self.down.way(self.v1, self.v)
        if end <= top_begin:
            return self.velocity_at(end)
        return self.velocity_at(begin) if begin >= top_end else self.v


# Blocks: what the axes allow.

class Block:
    def __init__(self, machine, readings, state, begin, end, center=None, turn=0):
        self.readings, self.slope = readings, state["slope"]
        self.begin, self.end, self.center, self.turn = begin, end, center, turn
        weight = state["acceleration"] / 100
        self.axes = {}
        for name in begin:
            axis = dict(machine["axes"][name])
            axis["up"] *= weight
            axis["down"] *= weight
            longest = max(axis[ramp] for ramp in RAMPS)
            axis["longest"] = longest
            if self.slope == "HSC":
                axis.update({ramp: longest for ramp in RAMPS})
            if self.slope == "SIN2" and readings["sine"] == "same-peak-jerk":
                axis.update({ramp: axis[ramp] * math.pi / 2 for ramp in RAMPS})
            self.axes[name] = axis
        self.machine = machine
        if center is None:
            way = {name: end[name] - begin[name] for name in begin}
            self.length = math.sqrt(sum(d * d for d in way.values()))
            self.u = {name: d / self.length for name, d in way.items()}
            shares = {name: abs(u) for name, u in self.u.items() if u}
            self.velocity = min([state["feed"]] + [self.axes[name]["v"] / share for name, share in shares.items()])
        else:
            self.plane = state["plane"]
            x, y = (begin[name] - center[name] for name in self.plane)
            self.radius, self.angle = math.hypot(x, y), math.atan2(y, x)
            to = math.atan2(*(end[name] - center[name] for name in reversed(self.plane)))
            self.sweep = (to - self.angle) % (2 * math.pi)
            if turn < 0:
                self.sweep -= 2 * math.pi
            if abs(self.sweep) < 1e-9 or abs(abs(self.sweep) - 2 * math.pi) < 1e-9:
                self.sweep = turn * 2 * math.pi
            self.length = self.radius * abs(self.sweep)
            shares = {name: 1.0 for name in self.plane}
            a = min(min(self.axes[name]["up"], self.axes[name]["down"]) for name in self.plane)
            full = readings["circle"] == "full"
            limits = [state["feed"]] + [self.axes[name]["v"] for name in self.plane]
            limits.append(math.sqrt(a * self.radius / machine.get("circle_part", 1 if full else math.sqrt(2))))
            for name in self.plane:
                axis = self.axes[name]
                limits.append((min(axis["up"], axis["down"]) / axis["curve"] * self.radius ** 2) ** (1 / 3))
            self.velocity = min(limits)
            across = min(self.velocity ** 2 / self.radius, a / math.sqrt(2))
            self.along = a if full else math.sqrt(a * a - across * across)
        self.ramps = {sense: self.ramp(sense, shares) for sense in ("up", "down")}

    def ramp(self, sense, shares):
        """Acceleration and both times along the path: weakest jerk of the axes, or their longest times."""
        moving = [(self.axes[name], share) for name, share in shares.items()]
        a = min(axis[sense] / share for axis, share in moving)
        times = {}
        for end in ("build", "take"):
            jerk = min(axis[sense] / axis[f"{sense}_{end}"] / share for axis, share in moving)
            longest = max(axis[f"{sense}_{end}"] for axis, _ in moving)
            times[end] = a / jerk if self.readings["projection"] == "weakest-jerk" else longest
        if self.center is not None:  # ramp times stay
            a = self.along
        slow, fast = (times["build"], times["take"]) if sense == "up" else (times["take"], times["build"])
        return a, slow, fast

    def rules(self):
        sine = self.slope == "SIN2"
        return sine, self.machine["constant_times"] and self.slope in ("TRAPEZ", "SIN2"), self.readings

    def made(self, sense):
        return Ramp(*self.ramps[sense], *self.rules())

    def direction(self, at_end):
        if self.center is None:
            return self.u
        angle = self.angle + (self.sweep if at_end else 0)
        sign = 1 if self.sweep > 0 else -1
        found = {name: 0.0 for name in self.begin}
        found[self.plane[0]], found[self.plane[1]] = -sign * math.sin(angle), sign * math.cos(angle)
        return found

    def curvature(self, at_end):
        found = {name: 0.0 for name in self.begin}
        if self.center is not None:
            angle = self.angle + (self.sweep if at_end else 0)
            found[self.plane[0]], found[self.plane[1]] = -math.cos(angle) / self.radius, -math.sin(angle) / self.radius
        return found

    def point(self, way):
        way = min(way, self.length)
        if self.center is None:
            return {name: self.begin[name] + self.u[name] * way for name in self.begin}
        angle = self.angle + self.sweep * way / self.length
        found = dict(self.begin)
        for name, part in zip(self.plane, (math.cos(angle), math.sin(angle))):
            found[name] = self.center[name] + self.radius * part
        return found


def steps_of(block, name):
    """w a T and w' a of an axis."""
    axis, machine = block.axes[name], block.machine
    a = min(axis["up"], axis["down"])
    of_jerk = min(1.0, T / axis["longest"])
    if machine["transition_mode"] == 2:
        w = min(1.0, axis["corner_jerk"] * 1000 * T / a) or of_jerk
        w_curve = min(1.0, axis["curve_jerk"] * 1000 * T / a) or of_jerk
    else:
        w = axis["a_weight"] / 1000 or of_jerk
        w_curve = axis["r_weight"] / 1000 or of_jerk
    if machine["transition_mode"] == 0:
        if block.readings["weights"] == "r-follows-a":
            w_curve = max(w, w_curve)
        else:
            w = max(w, w_curve)
    return w * a * T, w_curve * a


def junction(before, after):
    u0, u1 = before.direction(True), after.direction(False)
    k0, k1 = before.curvature(True), after.curvature(False)
    limit = min(before.velocity, after.velocity)
    for block in (before, after):
        for name in block.axes:
            step, curve_step = steps_of(block, name)
            turn = abs(u1[name] - u0[name])
            rises = abs(u1[name]) > abs(u0[name])
            wanted = {"per-cycle": True, "up-only": rises, "down-only": not rises}[block.readings["corner"]]
            if turn > 1e-9 and (wanted or u0[name] * u1[name] < 0):
                limit = min(limit, step / turn)
            bend = abs(k1[name] - k0[name])
            if block.machine["limits_curvature"] and bend > 1e-9:
                limit = min(limit, math.sqrt(curve_step / bend))
    return limit


# Paths.

class Element:
    def __init__(self, blocks, first):
        self.first, self.count = first, len(blocks)
        self.length = sum(block.length for block in blocks)
        self.velocity = max(block.velocity for block in blocks)
        if len(blocks) == 1:
            self.up, self.down = blocks[0].made("up"), blocks[0].made("down")
            return
        for sense in ("up", "down"):
            ramps = [block.ramps[sense] for block in blocks]
            a = min(ramp[0] for ramp in ramps)
            times = (a / min(ramp[0] / ramp[end] for ramp in ramps) for end in (1, 2))
            setattr(self, sense, Ramp(a, *times, *blocks[0].rules()))


def planned(elements, entries):
    """Backwards what still allows to stop, forwards what is reached."""
    allowed = [0.0] * (len(elements) + 1)
    for i in reversed(range(1, len(elements))):
        down, length, after = elements[i].down, elements[i].length, allowed[i + 1]
        allowed[i] = highest(lambda v: down.way(after, v) <= length, min(after, entries[i]), entries[i])
    found, v = [], 0.0
    for i, element in enumerate(elements):
        out = allowed[i + 1]
        if out > v:
            out = highest(lambda w: element.up.way(v, w) <= element.length, v, out)
        found.append(Profile(element.up, element.down, element.length, v, out, element.velocity))
        v = out
    return found


def profiles(blocks, readings):
    """Pairs of a profile and the blocks that it passes."""
    limits = [0.0] + [junction(a, b) for a, b in zip(blocks, blocks[1:])]
    slope = blocks[0].slope
    across = readings["hsc"] == "stretches" if slope == "HSC" else readings["borders"] == "continuous"
    places = {0, len(blocks)} if across else set(range(len(blocks) + 1))
    while True:
        marks = sorted(places)
        elements = [Element(blocks[a:b], a) for a, b in zip(marks, marks[1:])]
        plans = planned(elements, [limits[a] for a in marks[:-1]])
        exceeded = []
        for element, plan in zip(elements, plans):
            if element.count == 1:
                continue
            way = 0.0
            for i in range(element.first, element.first + element.count):
                block = blocks[i]
                if i > element.first and plan.velocity_at(way) > limits[i] * (1 + 1e-9):
                    exceeded.append((limits[i], {i}))
                if plan.highest_between(way, way + block.length) > block.velocity * (1 + 1e-9):
                    exceeded.append((block.velocity, {i, i + 1}))
                way += block.length
        if not exceeded:
            return [(plan, blocks[e.first:e.first + e.count]) for e, plan in zip(elements, plans)]
        lowest = min(limit for limit, _ in exceeded)
        for limit, found in exceeded:
            if limit <= lowest * (1 + 1e-9):
                places |= found


def setpoints(blocks, planned_profiles):
    """A point a cycle, from rest to rest."""
    points, begun, n = [dict(blocks[0].begin)], 0.0, 1
    for plan, passed in planned_profiles:
        while n * T < begun + plan.time - 1e-12:
            way = plan.at(n * T - begun)[1]
            for block in passed:
                if way <= block.length or block is passed[-1]:
                    points.append(block.point(way))
                    break
                way -= block.length
            n += 1
        begun += plan.time
    points.append(dict(blocks[-1].end))
    return points


# Programs.

def moves(program, names):
    """Lists of what makes a Block: state, begin, end, center, turn. A list for each move between two rests."""
    state = {"slope": None, "acceleration": 100.0, "feed": None, "plane": ("X", "Y")}
    planes = {"G17": ("X", "Y"), "G18": ("Z", "X"), "G19": ("Y", "Z")}
    at, found, mode = {name: 0.0 for name in names}, [[]], "G01"
    for line in program.split("\n"):
        line = line.split(";")[0].strip()
        slope = re.match(r"(?:N\d+ )?#SLOPE \[TYPE=(\w+)\]", line)
        if slope:
            state["slope"] = slope.group(1)
            continue
        words = line.split()
        if "G04" in words:
            if found[-1]:
                found.append([])
            continue
        end, center = dict(at), {}
        for word in words:
            value = re.match(r"([A-Z])(-?[\d.]+)$", word)
            weight = re.match(r"G131=([\d.]+)$", word)
            if weight:
                state["acceleration"] = float(weight.group(1))
            elif word in planes:
                state["plane"] = planes[word]
            elif word in ("G01", "G02", "G03"):
                mode = word
            elif value and value.group(1) == "F":
                state["feed"] = float(value.group(2)) / 60
            elif value and value.group(1) in names:
                end[value.group(1)] = at[value.group(1)] + float(value.group(2))
            elif value and value.group(1) in "IJK":
                center["XYZ"["IJK".index(value.group(1))]] = float(value.group(2))
        if center or end != at:
            middle = None
            if mode != "G01":
                middle = {name: at[name] + center.get(name, 0.0) for name in state["plane"]}
            found[-1].append((dict(state), dict(at), end, middle, {"G01": 0, "G02": -1, "G03": 1}[mode]))
            at = end
    return [move for move in found if move]


def pause_of(program):
    """Cycles of the rest after each move."""
    return round(float(re.search(r"G04 F([\d.]+)", program).group(1)) / T)


def blocks_of(move, machine, readings):
    return [Block(machine, readings, state, begin, end, center, turn) for state, begin, end, center, turn in move]


def executed(move, machine, readings):
    blocks = blocks_of(move, machine, readings)
    return setpoints(blocks, profiles(blocks, readings))


def acting_keys(move, machine):
    """Whose readings may change this move."""
    keys = ["cycles"]
    if any(state["slope"] == "SIN2" for state, *_ in move):
        keys.append("sine")
    if any(center is not None for _, _, _, center, _ in move):
        keys.append("circle")
    if any(center is not None or sum(end[n] != begin[n] for n in end) > 1 for _, begin, end, center, _ in move):
        keys.append("projection")
    if len(move) > 1:
        keys += ["corner"] + (["weights"] if machine["transition_mode"] == 0 else [])
        keys.append("hsc" if move[0][0]["slope"] == "HSC" else "borders")
    return keys


DEFAULTS = {key: words[0] for key, words in KEYS.items()}
