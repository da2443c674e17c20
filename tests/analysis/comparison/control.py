"""A control that reads the parameters in a known way: its filters, written from their definitions without axisc's arithmetic.

A filter is a dictionary of the parameters of one filter[i], a kernel one of filter_fir or of the HSC filter. Frequencies are in Hz.
"""
import numpy as np

T = 0.001
LOWPASS, BANDSTOP, ALLPASS, PT1, PT2 = 1, 4, 5, 6, 10
CRITICAL_DAMPING, BUTTERWORTH, BESSEL = 1, 2, 3
AVERAGE, GAUSSIAN, SINC, NOVIB = 1, 2, 3, 12
CYCLE_READINGS = {"cycle-time-double": 2, "cycle-time-half": 0.5, "cycle-time-fourfold": 4, "cycle-time-quarter": 0.25}
BILINEAR = ("listed", "half-gain-at-frequency", "poles-at-frequency", "analogue-quality", "quality-of-poles", "bessel-delay",
            "allpass-phase")


def is_lag(f):
    return f["type"] in (PT1, PT2)


def filter_readings(f):
    """Those that mean something for the filter."""
    if f is None:
        return ["listed"]
    found = ["listed", "no-prewarping", "backward-euler", "forward-euler", "matched", "matched-poles", "filters-off"]
    if f["type"] in (LOWPASS, PT1, PT2):
        found += ["impulse-invariant", "step-invariant"]
    if f["type"] == LOWPASS:
        found.append("half-gain-at-frequency")
    if f["type"] == BANDSTOP:
        found.append("analogue-quality")
    if f["order"] == 1 or is_lag(f):
        return found
    critical = f["prototype"] == CRITICAL_DAMPING
    if critical:
        found.append("quality-of-poles" if f["type"] == BANDSTOP else "poles-at-frequency")
    if f["prototype"] == BESSEL and f["type"] != BANDSTOP:
        found.append("bessel-delay")
    if f["type"] == ALLPASS and f["prototype"] != BUTTERWORTH:
        found.append("allpass-phase")
    return found


def kernel_readings(k):
    if k is None:
        return ["listed"]
    found = ["listed"]
    if k["type"] == NOVIB:
        found.append("novib-one-box")
    else:
        found += ["taps-n", "taps-n-plus-1", "half-width-rounded-down", "order-is-half-width"]
    if k["type"] == GAUSSIAN:
        found += ["gaussian-width-1", "gaussian-width-2", "gaussian-width-3"]
    if k["type"] == SINC:
        found += ["sinc-hann", "sinc-blackman", "sinc-no-window"]
    if k["share"] < 100:
        found += ["share-undelayed", "share-ignored"]
    return found


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


def rising(function, wanted):
    """Where a function that grows with its argument has a value."""
    low, high = 1e-6, 1e6
    for _ in range(200):
        middle = np.sqrt(low * high)
        low, high = (middle, high) if function(middle) < wanted else (low, middle)
    return middle


def bessel_poles(n):
    """Of the low-pass that delays by 1 at rest: the roots of the reverse Bessel polynomial."""
    coefficients = [1.0]
    for k in range(n, 0, -1):  # a_(n-j) = (n + j)!/(2^j j! (n - j)!), one from the other
        j = n - k + 1
        coefficients.append(coefficients[-1] * (n + j) * (n - j + 1) / (2 * j))
    return np.roots(coefficients)


def attenuation(poles, omega):
    return float(np.prod(np.abs((1j * omega - poles) / poles)))


def lag_angle(poles, omega):
    """By which the low-pass lags: the sum over its poles of the angle that j omega and the origin make there."""
    return float(np.sum(np.angle((1j * omega - poles) / -poles)))


def prototype_poles(f, reading):
    """Of the low-pass with its characteristic frequency at 1."""
    n = f["order"]
    if is_lag(f):
        return np.full({PT1: 1, PT2: 2}[f["type"]], -1.0)
    if f["prototype"] == BUTTERWORTH:
        poles = np.exp(1j * np.pi * (2 * np.arange(n) + n + 1) / (2 * n))
    elif f["prototype"] == BESSEL:
        poles = bessel_poles(n)
        if reading == "bessel-delay":
            return poles
    else:
        poles = np.full(n, -1.0)
        if reading in ("poles-at-frequency", "quality-of-poles"):
            return poles
    if reading == "allpass-phase":  # the all-pass turns by twice the low-pass' angle, by n pi in all
        return poles / rising(lambda omega: lag_angle(poles, omega), n * np.pi / 4)
    return poles / rising(lambda omega: attenuation(poles, omega), 2 if reading == "half-gain-at-frequency" else np.sqrt(2))


def analogue(f, reading, cycle):
    """Poles and zeros in 1/s."""
    poles = prototype_poles(f, reading)
    frequency = 1 / (2 * np.pi * f["tau"]) if is_lag(f) else f["fg"]
    omega = 2 * np.pi * frequency
    if reading in BILINEAR:
        omega = 2 / cycle * np.tan(omega * cycle / 2)
    if f["type"] == ALLPASS:
        return omega * poles, -omega * poles
    if f["type"] != BANDSTOP:
        return omega * poles, np.array([])
    quality = f["quality"]
    if reading in BILINEAR and reading != "analogue-quality":  # the edges are fg/quality apart after the transform
        angle = 2 * np.pi * f["fg"] * cycle
        quality = np.sin(angle) / (2 * np.tan(angle / 2 / f["quality"]))
    # The low-pass' s becomes 1/(quality (s + 1/s)), so that each pole p makes two: s² - s/(quality p) + 1 = 0
    split = np.concatenate([np.roots([1, -1 / (quality * p), 1]) for p in poles])
    return omega * split, omega * 1j * np.array([1, -1] * len(poles))


def pairs(roots):
    """Polynomials in z^-1 of at most two roots each: of conjugates, and of real ones in twos."""
    complex_ones = sorted((z for z in roots if z.imag > 1e-12), key=abs)
    real_ones = sorted(z.real for z in roots if abs(z.imag) <= 1e-12)
    made = [np.array([1, -2 * z.real, abs(z) ** 2]) for z in complex_ones]
    return made + [np.poly(real_ones[i:i + 2]) for i in range(0, len(real_ones), 2)]


def standard_filter(f, reading, cycle=T):
    """Sections of numerator and denominator in z^-1, each with gain 1 at rest; None where the reading is unstable."""
    if reading == "filters-off":
        return []
    poles, zeros = analogue(f, reading, cycle)
    if reading in ("impulse-invariant", "step-invariant"):
        numerator, denominator = invariant(poles * cycle, reading)
        return [(numerator * denominator.sum() / numerator.sum(), denominator)]
    if reading in BILINEAR or reading == "no-prewarping":  # s = 2/T (1 - z^-1)/(1 + z^-1)
        move, at_infinity = lambda s: (1 + s * cycle / 2) / (1 - s * cycle / 2), -1
    elif reading in ("matched", "matched-poles"):
        move, at_infinity = lambda s: np.exp(s * cycle), -1
    elif reading == "backward-euler":  # s = (1 - z^-1)/T
        move, at_infinity = lambda s: 1 / (1 - s * cycle), 0
    else:  # s = (z - 1)/T
        move, at_infinity = lambda s: 1 + s * cycle, None
    moved = move(poles)
    missing = len(poles) - len(zeros)
    if np.max(np.abs(moved)) >= 1:
        return None
    made = list(move(zeros)) + ([at_infinity] * missing if at_infinity == -1 and reading != "matched-poles" else [])
    denominators, numerators = pairs(moved), pairs(np.array(made, dtype=complex))
    numerators += [np.ones(1)] * (len(denominators) - len(numerators))
    sections = [(n * d.sum() / n.sum(), d) for n, d in zip(numerators, denominators)]
    if at_infinity is None and missing:
        sections.append((np.r_[np.zeros(missing), 1.0], np.ones(1)))
    return sections


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


def period_box(frequency, cycle):
    """Ones over a period, and at both ends a weight that puts the zero exactly on the frequency."""
    per_period = 1 / (cycle * frequency)
    m = int(np.ceil((per_period - 1) / 2)) - 1
    angle = 2 * np.pi / per_period
    inner = 1 + 2 * np.cos(angle * np.arange(1, m + 1)).sum()
    edge = -inner / (2 * np.cos(angle * (m + 1)))
    return np.r_[edge, np.ones(2 * m + 1), edge]


def shape_of(k, reading, cycle):
    if k["type"] == NOVIB:
        box = period_box(k["fg"], cycle)
        return box if reading == "novib-one-box" else np.convolve(box, box)
    n = k["order"]
    taps = {"taps-n": n, "taps-n-plus-1": n + 1, "half-width-rounded-down": 2 * (n // 2) + 1,
            "order-is-half-width": 2 * n + 1}.get(reading, 2 * -(-n // 2) + 1)
    half = (taps - 1) / 2
    at = np.arange(taps) - half
    if k["type"] == AVERAGE:
        return np.ones(taps)
    if k["type"] == GAUSSIAN:
        width = {"gaussian-width-1": 1, "gaussian-width-2": 2, "gaussian-width-3": 3}.get(reading, 2.5)
        return np.exp(-0.5 * (at / (k["quality"] * half / width)) ** 2)
    window = {"sinc-hann": np.hanning, "sinc-blackman": np.blackman, "sinc-no-window": np.ones}
    return np.sinc(2 * k["fcut"] * cycle * at) * window.get(reading, np.hamming)(taps)


def kernel(k, reading, cycle=T):
    share = k["share"] / 100
    shape = shape_of(k, reading, cycle)
    shape = shape / shape.sum()
    if reading == "share-ignored":
        return shape
    result = share * shape
    if reading == "share-undelayed":
        result[0] += 1 - share
    else:
        result[(len(shape) - 1) // 2] += (1 - share) / 2
        result[len(shape) // 2] += (1 - share) / 2
    return result


def computed(chosen, readings, setpoints):
    """What the control makes of setpoints; None where the reading is unstable."""
    values = setpoints - setpoints[0]
    cycle = T * CYCLE_READINGS.get(readings.get("cycle"), 1)
    if chosen["filter"]:
        made = standard_filter(chosen["filter"], readings["filter"], cycle)
        if made is None:
            return None
        for numerator, denominator in made:
            values = filtered(numerator, denominator, values)
    if chosen["kernel"]:
        values = filtered(kernel(chosen["kernel"], readings["kernel"], cycle), [1], values)
    return values + setpoints[0]
