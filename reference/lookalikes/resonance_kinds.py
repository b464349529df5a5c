"""No spring: structures that ring after hits. Their lines lie where beams, plates, frames, belts, bells or chance put them; or one line
is bent or cut so that it has harmonics. Half of the logs also hold the slow pull of a spring that does not ring, with u1.

Next door: machines, mains, speech and noise (source_kinds.py).
"""

import numpy as np
from scipy import optimize, signal

from assembly import END1, END2, Assembly, Modes, tension
from record import Truth, log_uniform
from scene import modes_after_hits, scene


def finish(happening, kind, forces):
    """The log of forces by channel, with a slow pull in half of the logs."""
    rng, series = happening.rng, {name: happening.preload + values for name, values in forces.items()}
    if rng.random() < 0.5:
        motion, _ = happening.slow_motion()
        stiffness = log_uniform(rng, 100, 10_000)
        series = {"u1": motion} | {name: values - stiffness * motion for name, values in series.items()}
    return happening.log(series, Truth(kind, False))


def sensors(rng, both=None):
    """F_i and F_o, or one of them."""
    both = rng.random() < 0.5 if both is None else both
    return ["F_i", "F_o"] if both else [("F_i", "F_o")[rng.integers(2)]]


def heard(happening, kind, frequencies, ratios=None, both=None, ends=None, fall=0.0):
    """A log of lines that ring down. ends: +1 or -1 per line, how F_o goes beside F_i; without it each sensor hears a line as it likes.

    fall: amplitudes fall with a line's number to this power.
    """
    rng = happening.rng
    frequencies = np.asarray(frequencies)[np.asarray(frequencies) < 0.38 * happening.rate]
    count = len(frequencies)
    if ratios is None:
        ratios = log_uniform(rng, 5e-4, 1.2e-2) * np.exp(0.4 * rng.standard_normal(count))
    gains = rng.normal(size=(len(happening.hits), count))
    if rng.random() < 0.5:
        gains[:] = gains[0]
    rung = modes_after_hits(happening, frequencies, ratios[:count], gains)
    sizes = log_uniform(rng, 0.3, 5) * np.exp(0.5 * rng.standard_normal(count)) / np.arange(1, count + 1) ** fall
    forces = {}
    for name in sensors(rng, both):
        if ends is None:
            forces[name] = (sizes * rng.normal(size=count)) @ rung
        else:
            forces[name] = (sizes * (np.asarray(ends)[:count] if name == "F_o" else 1)) @ rung
    return finish(happening, kind, forces)


def unrelated(rng, kind, both):
    count = int(rng.integers(5, 16))
    frequencies = np.sort(np.exp(rng.uniform(np.log(20), np.log(900), count)))
    return heard(scene(rng, 50), kind, frequencies, log_uniform(rng, 5e-4, 1e-2) * np.exp(0.7 * rng.standard_normal(count)), both)


def unrelated_one(rng):
    """5 to 15 lines from 20 to 900 Hz that have nothing to do with one another, one force."""
    return unrelated(rng, "unrelated-one", False)


def unrelated_both(rng):
    """The same, both forces."""
    return unrelated(rng, "unrelated-both", True)


def nonlinear_mode(rng):
    """One mode r, heard as r + a r^2 + b r^3, or swinging in a spring that is not straight itself; by one or both cells."""
    frequency = log_uniform(rng, 20, 120)
    happening = scene(rng, frequency)
    ratio, peak = log_uniform(rng, 5e-4, 1e-2), log_uniform(rng, 0.5, 3)
    if rng.random() < 0.6:
        rung = modes_after_hits(happening, [frequency], [ratio], np.ones((len(happening.hits), 1)))[0]
        bent = [(1.0, rng.uniform(0.01, 0.12), rng.uniform(0.01, 0.12) * rng.choice([-1, 1])) for _ in range(2)]
        answers = [a * rung + b * rung**2 + c * rung**3 for a, b, c in bent]
    else:
        rung = bent_swing(happening, 2 * np.pi * frequency, ratio, rng.uniform(0.02, 0.25), rng.uniform(0.0, 0.25))
        answers = [rung, rung]
    gains = {"F_i": peak, "F_o": peak * rng.uniform(0.5, 1.2) * rng.choice([-1, 1])}
    return finish(happening, "nonlinear-mode", {name: gains[name] * answers[int(name == "F_o")] for name in sensors(rng)})


def bent_swing(happening, angular, ratio, square, cube):
    """The force x + square x^2 + cube x^3 on a unit mass that hits set swinging, x about 1: turns of the straight part between kicks."""
    rate = happening.fine_rate
    struck = np.zeros(len(happening.time))
    for number, size in enumerate(happening.sizes):
        struck += 0.6 * size * angular * happening.pulse(number)
    turn, fall = angular / rate, np.exp(-ratio * angular / rate)
    cosine, sine = fall * np.cos(turn), fall * np.sin(turn)
    place = speed = 0.0  # speed over angular
    out = []
    for kick in (struck / rate / angular).tolist():
        force = place + (square + cube * place) * place * place
        out.append(force)
        speed += kick - turn * (force - place)
        place, speed = place * cosine + speed * sine, speed * cosine - place * sine
        if abs(place) > 2:  # a hit too many: what holds it does not let go
            place, speed = 0.5 * place, 0.5 * speed
    return np.array(out)


def clipped_mode(rng):
    """One mode, cut at 40 to 80 % of its peak, above or on both sides."""
    frequency = log_uniform(rng, 20, 120)
    happening = scene(rng, frequency)
    rung = modes_after_hits(happening, [frequency], [log_uniform(rng, 5e-4, 1e-2)], np.ones((len(happening.hits), 1)))[0]
    peak, forces = log_uniform(rng, 0.5, 5), {}
    for name in sensors(rng):
        values = peak * rng.uniform(0.5, 1.2) * (rng.choice([-1, 1]) if name == "F_o" else 1) * rung
        level = rng.uniform(0.4, 0.8) * np.abs(values).max()
        forces[name] = np.clip(values, -np.inf if rng.random() < 0.5 else -level, level)
    return finish(happening, "clipped-mode", forces)


def beam_roots(kind, count):
    """Roots of a uniform beam's frequency equation; those of a beam free at both ends are of "clamped-clamped"."""
    if kind == "hinged":
        return np.pi * np.arange(1, count + 1)
    if kind == "clamped-hinged":
        first, reach, equation = 1.25, 0.2, lambda x: np.tan(x) - np.tanh(x)
    else:
        sign, first = (1, 0.5) if kind == "clamped-free" else (-1, 1.5)
        reach, equation = 0.4, lambda x: np.cos(x) + sign / np.cosh(x)
    return np.array([optimize.brentq(equation, (first + n - reach) * np.pi, (first + n + reach) * np.pi) for n in range(count)])


def beam(rng):
    """A beam of Euler and Bernoulli: clamped and free, clamped or free at both ends, hinged, clamped and hinged."""
    kind = ("clamped-free", "clamped-clamped", "hinged", "clamped-hinged")[rng.integers(4)]
    roots = beam_roots(kind, 8)
    first = log_uniform(rng, 10, 100)
    # A symmetric beam's odd modes press on both supports the same way: one pulls while the other pushes.
    ends = -((-1.0) ** np.arange(len(roots))) if kind in ("clamped-clamped", "hinged") and rng.random() < 0.7 else None
    return heard(scene(rng, first), "beam", first * (roots / roots[0]) ** 2, ends=ends, fall=rng.uniform(0, 1))


def plate(rng):
    """A plate on simple supports: f over (p/a)^2 + (q/b)^2."""
    ratio, first = rng.uniform(1, 2.5) ** 2, log_uniform(rng, 20, 120)
    lines = np.sort([p * p + ratio * q * q for p in range(1, 6) for q in range(1, 6)])[: rng.integers(6, 13)]
    return heard(scene(rng, first), "plate", first * lines / lines[0])


def frame(rng):
    """Two to six coupled masses between two cells, masses and springs spread by ten: forces by their own equations of motion."""
    assembly, count = Assembly(), int(rng.integers(2, 7))
    unit = log_uniform(rng, 0.2, 5)
    nodes = [assembly.mass(unit * log_uniform(rng, 0.3, 3)) for _ in range(count)]
    springs = log_uniform(rng, 20, 120) ** 2 * 40 * unit
    chain = [END1, *nodes, END2]
    links = [assembly.link(a, b, springs * log_uniform(rng, 0.3, 3)) for a, b in zip(chain, chain[1:])]
    happening = scene(rng, 40)
    zeta = log_uniform(rng, 5e-4, 1.2e-2) * np.exp(0.3 * rng.standard_normal(count))
    modes, rows = Modes(assembly, lambda f: zeta), np.array([tension(links[0], count)[0], tension(links[-1], count)[0]])
    struck = [np.eye(count)[rng.integers(count)] for _ in happening.hits]
    pulses = [(shape, size * happening.pulse(number)) for number, (shape, size) in enumerate(zip(struck, happening.sizes))]
    answer = modes.answer(happening.fine_rate, rows, pulses)
    answer *= log_uniform(rng, 0.5, 5) / np.abs(answer).max()
    return finish(happening, "frame", {name: answer[int(name == "F_o")] for name in sensors(rng)})


def belt(rng):
    """A belt or string that resists bending: f_n = n f sqrt(1 + B n^2), B 3e-4 to 0.02, its ends in turn and together as a coil's."""
    first, bending = log_uniform(rng, 20, 120), log_uniform(rng, 3e-4, 2e-2)
    number = np.arange(1, 13)
    ends = -((-1.0) ** (number - 1))
    ratios = log_uniform(rng, 5e-4, 6e-3) * number ** rng.uniform(-1, 1) * np.exp(0.1 * rng.standard_normal(len(number)))
    return heard(scene(rng, first), "belt", first * number * np.sqrt(1 + bending * number**2), ratios, ends=ends, fall=rng.uniform(0, 1))


def bell(rng):
    """A struck casting with the partials of a bell: 0.5, 1, 1.2, 1.5, 2, 2.5, 2.67, 3, 4 of its tone, each a pair that beats, a few off."""
    tone = log_uniform(rng, 50, 250)
    partials = np.array([0.5, 1, 1.2, 1.5, 2, 2.5, 2.67, 3, 4]) * (1 + 0.008 * rng.standard_normal(9))
    pairs = np.sort(np.concatenate([partials, partials * (1 + log_uniform(rng, 5e-4, 6e-3))]))
    return heard(scene(rng, 0.5 * tone), "bell", tone * pairs)


def pendulum(rng):
    """A pendulum or a tank that slops at 0.4 to 6 Hz, large enough to have harmonics."""
    frequency = log_uniform(rng, 0.4, 6)
    happening = scene(rng, frequency, rate=(1000.0, 2500.0)[rng.integers(2)], duration=30.0, hits=int(rng.integers(2, 5)), width=0.02)
    swing = bent_swing(happening, 2 * np.pi * frequency, log_uniform(rng, 2e-3, 4e-2), rng.uniform(0.05, 0.3), rng.uniform(-0.08, 0.2))
    size = log_uniform(rng, 0.3, 10)
    other = rng.uniform(-1, 1)
    return finish(happening, "pendulum", {name: size * (other if name == "F_o" else 1) * swing for name in sensors(rng)})


def soft_mass(rng):
    """One mass on a spring so light that its own lines lie above what is sampled: one line; u2 moves with the force where recorded."""
    frequency, mass = log_uniform(rng, 2, 40), log_uniform(rng, 0.3, 10)
    happening = scene(rng, max(frequency, 15))
    happening.slow = (happening.slow[0], 0.02 * frequency)
    rung = modes_after_hits(happening, [frequency], [log_uniform(rng, 5e-4, 2e-2)], np.ones((len(happening.hits), 1)))[0]
    stiffness = (2 * np.pi * frequency) ** 2 * mass
    force = log_uniform(rng, 0.3, 5) * rung
    series = {name: happening.preload + force for name in sensors(rng)}
    if rng.random() < 0.7:
        # The mass hangs on end 1, which moves slowly: its force and its place as far as the mass rings.
        series = {"u1": happening.slow_motion()[0], "u2": 0.2 + happening.slow_motion()[0] + force / stiffness} | series
    return happening.log(series, Truth("soft-mass", False))


def comb_filter(rng):
    """Noise and clicks through a comb that takes mains out: it rings at every multiple of 50 or 60 Hz, dying out, after each hit."""
    mains = (50.0, 60.0)[rng.integers(2)]
    happening = scene(rng, mains, rate=(2500.0, 5000.0)[rng.integers(2)] if mains == 50 else 3000.0)
    clicks = sum(size * happening.pulse(number) for number, size in enumerate(happening.sizes))
    delay, keeps = round(happening.fine_rate / mains), rng.uniform(0.7, 0.98)
    notches = np.zeros(delay + 1)
    notches[[0, -1]] = 1, -1
    poles = notches * np.where(np.arange(delay + 1) == 0, 1, keeps)
    rung = signal.lfilter(0.5 * (1 + keeps) * notches, poles, clicks)
    rung *= log_uniform(rng, 1, 20) / np.abs(rung).max()
    other = rng.uniform(0.3, 1) * rng.choice([-1, 1])
    return finish(happening, "comb-filter", {name: rung * (other if name == "F_o" else 1) for name in sensors(rng)})


KINDS = (unrelated_one, unrelated_both, nonlinear_mode, clipped_mode, beam, plate, frame, belt, bell, pendulum, soft_mass, comb_filter)
