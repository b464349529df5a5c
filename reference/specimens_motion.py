"""How one specimen moves and what its sensors make of it: used by specimens.py, which explains the whole.

Formulas
  Chain     n masses m/n, springs n k between them, half segments 2 n k to both ends; absolute coordinates, an eigen-solver.
            x = S p + Phi q: S p is the straight line of a massless spring under the inputs p, which are u1 and u2 of a held end 2,
            else u1 and F_2/k. With mass-normalised Phi, c = Phi' M S:  q'' + 2 zeta w q' + w^2 q = -c p''.
            Start: q = -c p, q' = -c p' from rest; 0 and 0 massless; q' = Phi' M v with moving windings.
            A jump h of p: q -= c h, q' += 2 zeta w c h. A jump v of p': q' -= c v. With one driven end q = c z, one z per mode.
  Inputs    Free vibration and steady sines, piece by piece in closed form. A sweep: exact integrals of exp(lambda t) over parabolas
            through p'' at the samples and half way between.
  Forces    F_i, F_o of the end segments, F_x = k (u2 - u1 - l0), tension positive.
  Sensor    Butterworth low-pass with straight lines between samples (exact), delay, mean over a window, sample and hold.
  Error     of the specimen's own motion: reading - true force, as if the instrument knew its k and l0. With a goal bandwidth B it goes
            through a Butterworth low-pass of order 8 at B, about its mean over the window.

A spec is a dictionary of the tables of the TOML file with the same keys in SI units, and besides `k`, `m` and `nominal_force`.
Checked: against `coilsense simulate` by `specimens.py --check`; a step against a ramp of 1 ns to 6e-10 of the peak.
"""

import functools
import math

import numpy as np
from scipy import fft, interpolate, linalg, signal

F_I, F_O, STRETCH = 0, 1, 2  # read off the chain, each divided by k
END_1, END_2, UNIFORM, LINEAR = 0, 1, 2, 3  # what moves it: an end, or start velocities by profile
OUTPUT = {"F_i": F_I, "F_o": F_O, "F_x": STRETCH}

# ---------------------------------------------------------------------------------------------------------------- the chain


def chain(masses, mount, end_mass):
    """Modes for k = m = 1 and an end mass in units of m: frequencies [mode] in rad/s and weights [input, output, mode]."""
    n, size = masses, masses + (mount == "mass")
    stiffness, place, bond = np.zeros((size, size)), (np.arange(n) + 0.5) / n, np.array([[1, -1], [-1, 1]])
    read, inertia = np.zeros((3, size)), np.full(size, 1 / n)
    stiffness[0, 0] = read[F_I, 0] = 2 * n
    for i in range(n - 1):
        stiffness[i : i + 2, i : i + 2] += n * bond
    if mount == "held":
        stiffness[n - 1, n - 1] += 2 * n
        read[F_O, n - 1] = -2 * n
    elif mount == "force":
        read[STRETCH, n - 1] = 1
    else:
        stiffness[n - 1 :, n - 1 :] += 2 * n * bond
        read[F_O, n - 1], read[F_O, n], read[STRETCH, n] = -2 * n, 2 * n, 1
        inertia[n], place = end_mass, np.append(place, 1.0)
    squares, shapes = linalg.eigh(stiffness, np.diag(inertia))
    end_1 = 1 - place if mount == "held" else np.ones(size)
    moving = np.array([end_1, place, np.ones(size), place]) * inertia @ shapes
    return np.sqrt(squares), moving[:, None, :] * (read @ shapes)


class Chains:
    """Modes over the ratio end mass / spring mass, from nine eigen-solutions and the polynomial through them."""

    def __init__(self, masses, spec, ratios):
        low, high = np.min(ratios), np.max(ratios)
        self.alike = high <= low * (1 + 1e-12)
        nodes = [low] if self.alike else (low + high) / 2 + (high - low) / 2 * np.cos(np.pi * (np.arange(9) + 0.5) / 9)
        self.modes = [np.array(y) for y in zip(*(chain(masses, spec["mount"]["end2"], ratio) for ratio in nodes))]
        self.between = None if self.alike else [interpolate.BarycentricInterpolator(nodes, y) for y in self.modes]

    def at(self, ratios):
        """Frequencies [specimen, mode] and weights [specimen, input, output, mode]; one row where all are alike."""
        return self.modes if self.alike else [f(ratios) for f in self.between]


# --------------------------------------------------------------------------------------------------------------- the motion


def sweep_phase(c, t):
    """Phase of a sweep, its rate and the rate of that [rad, rad/s, rad/s2]."""
    start, stop = c["frequency"]
    slope = (stop - start) / c["duration"]
    return c["phase"] + 2 * np.pi * (start * t + slope * t * t / 2), 2 * np.pi * (start + slope * t), 2 * np.pi * slope


def line(c, amplitude, t):
    """The input p of condition c at times t, counted from its mean."""
    after = t - c.get("begin", 0.0)
    if c["kind"] == "harmonic":
        return amplitude * np.sin(2 * np.pi * c["frequency"] * t + c["phase"])
    if c["kind"] == "sweep":
        return amplitude * np.sin(sweep_phase(c, t)[0])
    if c["kind"] == "pulse":
        return amplitude * np.sin(np.pi * np.clip(after / c["width"], 0, 1))
    if c["kind"] == "ramp":
        return amplitude * np.clip(after / c["rise_time"], 0, 1)
    return amplitude * (after > -1e-12) if c["kind"] == "step" else 0 * t


def pieces(c, amplitude):
    """The motion in pieces: (begin, jump of p, kick of z, kick of z', steady p as (amplitude, rate, phase) or None)."""
    begin, kind = c.get("begin", 0.0), c["kind"]
    if "velocity" in c:
        return [(0.0, 0.0, 0.0, -c["velocity"] if c.get("at") == "min" else c["velocity"], None)]
    if kind == "step":
        return [(begin, amplitude, 0.0, 0.0, None)]
    if kind == "ramp":
        speed = amplitude / c["rise_time"]
        return [(begin, 0.0, 0.0, -speed, None), (begin + c["rise_time"], 0.0, 0.0, speed, None)]
    if kind == "pulse":
        rate = np.pi / c["width"]
        sine = (amplitude, rate, -rate * begin)
        return [(begin, 0.0, 0.0, -amplitude * rate, sine), (begin + c["width"], 0.0, 0.0, -amplitude * rate, None)]
    rate = 2 * np.pi * c["frequency"] if kind == "harmonic" else sweep_phase(c, 0.0)[1]
    rest = amplitude * (c["start"] == "rest")
    sine = (amplitude, rate, c["phase"]) if kind == "harmonic" else None
    return [(0.0, 0.0, -rest * np.sin(c["phase"]), -rest * rate * np.cos(c["phase"]), sine)]


def phasor_sum(strength, rate, step, count):
    """Re sum_j strength[s, a, j] exp(rate[s, j] i step) for i = 0 ... count - 1, as the product of a coarse and a fine table."""
    size = np.abs(strength).max(axis=(0, 1))
    kept = size > 1e-9 * max(size.max(), 1e-300)
    if not kept.any():
        return np.zeros((*strength.shape[:2], count))
    strength, rate, fine = strength[..., kept], rate[:, kept], math.ceil(math.sqrt(count))
    far = strength[:, :, None] * np.exp(rate[:, None, None] * (step * fine * np.arange(math.ceil(count / fine)))[:, None])
    near = np.exp(rate[:, :, None] * (step * np.arange(fine)))
    far = np.concatenate([far.real, -far.imag], axis=-1).reshape(len(strength), -1, 2 * kept.sum())
    return (far @ np.concatenate([near.real, near.imag], axis=1)).reshape(*strength.shape[:2], -1)[..., :count]


def vibration(c, amplitude, omega, zeta, weights, first, last):
    """What the modes add to the line of the massless spring: [specimen, output, sample first ... last], divided by k."""
    step, damped = 1 / c["sample_rate"], omega * np.sqrt(1 - zeta**2)
    rate = -zeta * omega + 1j * damped
    out = np.zeros((len(omega), weights.shape[1], last - first + 1))
    z, v, parts = np.zeros_like(omega), np.zeros_like(omega), pieces(c, amplitude)
    for (begin, jump, kick_z, kick_v, sine), end in zip(parts, [part[0] for part in parts[1:]] + [math.inf]):
        a, w, phase = sine or (0.0, 1.0, 0.0)
        answer = a * w * w / (omega**2 - w * w + 2j * zeta * omega * w)  # z = Im answer exp(i (w t + phase)) in the steady state
        steady = answer * np.exp(1j * (w * begin + phase))
        z = z + kick_z - jump - steady.imag
        v = v + kick_v + 2 * zeta * omega * jump - (1j * w * steady).imag
        free = z - 1j * (zeta * omega * z + v) / damped  # z - steady = Re free exp(rate (t - begin))
        start, stop = (min(max(math.ceil(t / step - 1e-6), first), last + 1) if t < math.inf else last + 1 for t in (begin, end))
        if stop > start:
            here = weights * (free * np.exp(rate * (start * step - begin)))[:, None]
            wave = np.exp(1j * (w * step * np.arange(start, stop) + phase))
            out[..., start - first : stop - first] = phasor_sum(here, rate, step, stop - start)
            out[..., start - first : stop - first] += ((weights * answer[:, None]).sum(-1)[..., None] * wave).imag
        if end < math.inf:
            free, steady = free * np.exp(rate * (end - begin)), answer * np.exp(1j * (w * end + phase))
            z, v = free.real + steady.imag, (rate * free).real + (1j * w * steady).imag
    return out + swept(c, amplitude, rate, weights / damped[:, None], last)[..., first:] if c["kind"] == "sweep" else out


def swept(c, amplitude, rate, weights, last):
    """The answer to -p'' of a sweep from z = z' = 0, samples 0 ... last: a convolution with the answers to 1, t and t^2 of one step."""
    step = 1 / c["sample_rate"]
    phase, speed, turn = sweep_phase(c, step / 2 * np.arange(2 * last + 1))
    force = amplitude * (speed**2 * np.sin(phase) - turn * np.cos(phase))
    left, middle, right = force[:-1:2], force[1::2], force[2::2]
    unit = np.expm1(rate * step) / (rate * step)
    ramp = (unit - 1) / (rate * step)
    bow = 2 * (ramp - 0.5) / (rate * step)
    length, answer = fft.next_fast_len(2 * last + 1, real=True), 0.0
    for part, one in ((left, unit), (4 * middle - 3 * left - right, ramp), (2 * left - 4 * middle + 2 * right, bow)):
        kernel = phasor_sum(-1j * weights * (step * one)[:, None], rate, step, last)
        answer = answer + fft.rfft(kernel, length) * fft.rfft(part, length)
    return np.pad(fft.irfft(answer, length)[..., :last], [(0, 0), (0, 0), (1, 0)])


# -------------------------------------------------------------------------------------------------------------- the readout


def low_pass(x, bandwidth, order, sample_rate, settled=True):
    """Butterworth low-pass of x with straight lines between the samples, exact, pole by pole; settled at x[0] or at zero."""
    _, poles, gain = signal.butter(order, 2 * np.pi * bandwidth, analog=True, output="zpk")
    h, out = 1 / sample_rate, 0.0
    for i, pole in enumerate(poles):
        if pole.imag < -1e-9 * abs(pole):
            continue  # the twin of another pole
        share = gain / np.prod(pole - np.delete(poles, i)) * (2 if pole.imag > 1e-9 * abs(pole) else 1)
        decay = np.exp(pole * h)
        late = (decay - 1 - pole * h) / (pole * pole * h)
        early = (decay - 1) / pole - late
        first = (-x[..., :1] / pole if settled else 0 * x[..., :1]).astype(complex)
        rest = signal.lfilter([1], [1, -decay], early * x[..., :-1] + late * x[..., 1:], zi=decay * first)[0]
        out = out + (share * np.concatenate([first, rest], axis=-1)).real
    return out


def settling(bandwidth, order):
    """How long a Butterworth low-pass remembers, to 1e-6 [s]."""
    return 14 / (2 * np.pi * bandwidth * math.sin(np.pi / 2 / order))


def at_numbers(x, number):
    """x at fractional sample numbers, on straight lines; before the first sample its value."""
    number = np.clip(number, 0, x.shape[-1] - 1)
    whole = np.minimum(np.floor(number + 1e-9).astype(int), x.shape[-1] - 2)
    part = np.clip(number - whole, 0, 1)
    return x[..., whole] * (1 - part) + x[..., whole + 1] * part


def mean_over(x, width):
    """Mean over the last `width` samples, a fractional number, of straight lines between them."""
    whole, part = int(width), width - int(width)
    share = np.zeros(whole + 2)
    share[:whole] += 0.5
    share[1 : whole + 1] += 0.5
    share[whole:] += part - part**2 / 2, part**2 / 2
    before = np.repeat(x[..., :1], whole + 2, axis=-1)
    return signal.lfilter(share / width, [1], np.concatenate([before, x], axis=-1))[..., whole + 2 :]


def readout(s, x, first, rate):
    """What sensor s makes of x, whose first sample has the number `first`."""
    number = np.arange(x.shape[-1])
    x = low_pass(x, s["bandwidth"], s["order"], rate) if "bandwidth" in s else x
    x = at_numbers(x, number - s["delay"] * rate) if "delay" in s else x
    x = mean_over(x, s["averaging"] * rate) if "averaging" in s else x
    if "sample_rate" in s:
        reading = np.floor((number + first) * s["sample_rate"] / rate + 1e-6)
        x = at_numbers(x, reading * rate / s["sample_rate"] - first)
    return x


def memory(s):
    """How far back a sensor looks [s]."""
    lag = s.get("delay", 0) + s.get("averaging", 0) + (1 / s["sample_rate"] if "sample_rate" in s else 0)
    return lag + (settling(s["bandwidth"], s["order"]) if "bandwidth" in s else 0)


# ----------------------------------------------------------------------------------------------------- a case and its errors


def nominal(spec):
    """sqrt(k/m) and end-mass ratio of the spec's spring, as arrays of one."""
    return np.array([math.sqrt(spec["k"] / spec["m"])]), np.array([spec["mount"].get("end_mass", 0.0) / spec["m"]])


class Case:
    """A condition at one damping: simulates specimens of given sqrt(k/m) and end-mass ratio."""

    def __init__(self, spec, c, zeta, chains):
        self.spec, self.c, self.chains, self.band = spec, c, chains, spec["goal"].get("bandwidth")
        self.zeta = np.full(chains.modes[0].shape[1], float(zeta))
        self.zeta[0] = spec["mount"].get("first_mode_damping_ratio", zeta)
        self.held = spec["mount"]["end2"] == "held"
        self.forced = not self.held and c.get("end") == 2  # p is then F_2/k: forces do not grow with k
        self.input = {"uniform": UNIFORM, "linear": LINEAR}[c["profile"]] if "profile" in c else (END_1, END_2)[c["end"] - 1]
        self.amplitude = c.get("amplitude", 0.0) / (spec["k"] if self.forced else 1.0)
        self.window = [round(t * c["sample_rate"]) for t in c["window"]]
        lead = max(memory(s) for s in spec["sensor"]) + (settling(self.band, 8) if self.band else 0)
        self.first = max(0, self.window[0] - math.ceil(lead * c["sample_rate"]) - 3)

    def series(self, roots, ratios, first, last):
        """F_i/k, F_o/k and stretch about the mean length: [specimen, output, sample first ... last]."""
        frequencies, weights = self.chains.at(ratios)
        weights = np.broadcast_to(weights, (len(roots), *weights.shape[1:]))[:, self.input]
        p = line(self.c, self.amplitude, np.arange(first, last + 1) / self.c["sample_rate"])
        p = p if self.input == END_2 else -p if self.held else 0 * p
        return p + vibration(self.c, self.amplitude, roots[:, None] * frequencies, self.zeta, weights, first, last)

    def errors(self, roots, ratios):
        """Error of the specimen's own motion over the window, divided by k: [sensor, specimen, sample]."""
        rate, judged, out = self.c["sample_rate"], slice(self.window[0] - self.first, None), []
        x = self.series(roots, ratios, self.first, self.window[1])
        for s in self.spec["sensor"]:
            source = STRETCH if s["kind"] == "deflection" else (F_I, F_O)[s["end"] - 1]
            e = readout(s, x[:, source], self.first, rate) - x[:, OUTPUT[self.spec["goal"]["force"]]]
            if self.band:
                mean = e[:, judged].mean(-1, keepdims=True)
                e = mean + low_pass(e - mean, self.band, 8, rate, settled=False)
            out.append(e[:, judged])
        return np.array(out)

    def moments(self, roots, ratios):
        """Mean and mean square of these errors, [sensor, 2, specimen], in batches that fit the memory."""
        batch, parts = max(1, int(5e5 / (self.window[1] - self.first + 1))), []
        for at in range(0, len(roots), batch):
            e = self.errors(roots[at : at + batch], ratios[at : at + batch])
            parts.append(np.stack([e.mean(-1), (e * e).mean(-1)], axis=1))
        return np.concatenate(parts, axis=-1)

    @functools.cached_property
    def worst_point(self):
        """Largest true nominal force in the window, and length less rest length there."""
        x, still = self.series(*nominal(self.spec), *self.window)[0], self.c["length"] - self.spec["spring"]["rest_length"]
        force = still + x[OUTPUT[self.spec["goal"]["force"]]]
        at = np.argmax(np.abs(force))
        return self.spec["k"] * force[at], still + x[STRETCH, at]
