"""Two springs whose windings meet, by small steps: forces and their mean squares at eight steps each.

Writes contact_steps.csv and contact_steps_rms.csv. N masses m/N, springs Nk between them and 2Nk at the ends, no damping; neighbouring
masses may not come nearer than the gap allows; tension positive.

Route: explicit steps in velocities half a step apart and impulses on the gaps that the velocities lead to (Moreau's scheme in the explicit
form called CD-Lagrange):
    x' = x + h v;  v_free = v + h a(x');  where the gap at x' is not above zero:  0 <= impulse, 0 <= r_free + W impulse + e r, one of them zero,
with r the speeds at which the masses of a pair part and W = G M^-1 G^T. W is an M-matrix, so that adding every pair that still closes to
those that push, until none does, is a direct solution of the complementarity problem (Chandrasekaran 1970). No event is looked for, nothing
is bonded or released: contacts are known to a step, and the answer to first order of it.

Springs: S_A at a mean length of 102 mm, 40 um at the first frequency of eq. (3) and -90 degrees, from the massless spring's state; a valve
spring of six masses (29028 N/m, 44.549 g, free 57 mm, mean 48 mm, solid 31 mm), from rest, under a cam that rises by
10 mm 64 s^3 (1 - s)^3 over 130 of 360 degrees, 50 turns a second, from a quarter of a turn on.

Only sums, differences and products of doubles, one after the other: the same bytes on every machine but for the sine.
"""

import math

import numpy as np

from golden import SCIENCE
from springs import S_A

STEPS = [20, 10, 5, 2, 1, 0.5, 0.2, 0.1]  # [us]
SAMPLE = 20e-6  # of the mean squares [s]
EVERY = 10  # samples between two rows of the forces


class Chain:
    def __init__(self, count, stiffness, mass, gap, u1, start, far):
        self.count, self.gap, self.u1, self.start, self.far = count, gap, u1, start, far
        self.springs = np.full(count + 1, count * stiffness)
        self.springs[[0, -1]] *= 2
        self.mass = mass / count


def shaken():
    """S_A: places are counted from the unloaded spring, so that forces have the preload in them."""
    count, stretch = S_A.windings, 0.102 - S_A.rest_length
    omega = math.pi * math.sqrt(S_A.stiffness / S_A.mass)
    begin = 40e-6 * math.sin(-0.5 * math.pi)
    share = (np.arange(count) + 0.5) / count
    # The end's speed at t = 0 is that of a cosine at -90 degrees: zero.
    return Chain(
        count, S_A.stiffness, S_A.mass, S_A.rest_length / count - 2 * S_A.wire_radius,
        lambda t: 40e-6 * np.sin(omega * t - 0.5 * math.pi), begin + share * (stretch - begin), stretch,
    )


def valve():
    """The valve spring: places are counted from the spring of 57 mm, shortened by 9 mm."""
    count, shorter = 6, -0.009

    def cam(t):
        s = (np.mod(t / 0.02 - 0.25, 1.0) / (130 / 360)) * (t > 0.005)
        return np.where(s < 1, 0.01 * 64 * (s * (1 - s)) ** 3, 0.0)

    start = shorter * (np.arange(count) + 0.5) / count
    return Chain(count, 29028.0, 44.549e-3, (0.057 - 0.031) / count, cam, start, shorter)


def impulses(closing):
    """Of pairs {pair: r_free + e r}: what they push with, in units of a mass's speed."""
    pushing, found = set(), {}
    while True:
        more = {p for p, r in closing.items() if p not in pushing and r < found.get(p - 1, 0.0) + found.get(p + 1, 0.0)}
        if not more:
            return found
        pushing |= more
        found = eliminated(sorted(pushing), closing)


def eliminated(pairs, closing):
    """2 i_p - i_(p-1) - i_(p+1) = -r_p over these pairs."""
    pivots, rights = [], []
    for at, p in enumerate(pairs):
        linked = at > 0 and pairs[at - 1] == p - 1
        pivots.append(2 - 1 / pivots[-1] if linked else 2.0)
        rights.append(-closing[p] + (rights[-1] / pivots[-2] if linked else 0.0))
    found = {}
    for p, pivot, right in zip(reversed(pairs), reversed(pivots), reversed(rights)):
        found[p] = (right + found.get(p + 1, 0.0)) / pivot
    return found


def forces(chain, restitution, step, until):
    """F_i and F_o [N] at every sample up to `until`."""
    count, per_sample = chain.count, round(SAMPLE / step)
    steps = round(until / SAMPLE) * per_sample + 1
    places = np.concatenate([[0.0], chain.start, [chain.far]])
    inner, speeds = places[1:-1], np.zeros(count)
    stretch, pull, change = np.empty(count + 1), np.empty(count + 1), np.empty(count)
    kicks, limit = step / chain.mass * chain.springs, -chain.gap
    between = stretch[1:-1]
    answer = np.empty((2, round(until / SAMPLE) + 1))
    block = 1 << 16
    for first in range(0, steps, block):
        input_ = chain.u1(np.arange(first, min(first + block, steps)) * step).tolist()
        for n, u1 in enumerate(input_, first):
            places[0] = u1
            np.subtract(places[1:], places[:-1], out=stretch)
            if n % per_sample == 0:
                answer[:, n // per_sample] = chain.springs[0] * stretch[0], chain.springs[-1] * stretch[-1]
            np.multiply(kicks, stretch, out=pull)
            np.subtract(pull[1:], pull[:-1], out=change)
            if n == 0:
                change *= 0.5  # from the speeds at t = 0 to those half a step on
            if between[between.argmin()] <= limit:
                touching = np.flatnonzero(between <= limit).tolist()
                parting = {p: (1 + restitution) * (speeds[p + 1] - speeds[p]) + change[p + 1] - change[p] for p in touching}
                for p, impulse in impulses(parting).items():
                    change[p] -= impulse
                    change[p + 1] += impulse
            speeds += change
            inner += step * speeds
    return answer


# Spring, restitutions, until [s], rows of the forces from and to [s] and at these instants [s], windows of the mean squares [s].
CASES = [
    ("S_A", shaken(), [0.0], 0.75, (0.53, 0.6), [], [(0.55, 0.6), (0.6, 0.75)]),
    ("valve", valve(), [0.0, 0.2, 0.5], 0.3, (0.08, 0.12), [0.2, 0.25, 0.3], [(0.1, 0.12), (0.24, 0.3)]),
]


def rms(values):
    return math.sqrt(np.mean(values**2))


def main():
    tools = f"# NumPy {np.__version__}; 1e-6 N printed, right to first order of the step; reference/contact_steps.py; "
    heads = ",".join(f"F_i at {h} us [N],F_o at {h} us [N]" for h in STEPS)
    rows = [tools + "velocity impulses on predicted gaps, no events", f"spring,restitution,time [s],{heads}"]
    squares = [tools + "mean squares of samples every 20 us", "spring,restitution,step [us],from [s],to [s],F_i [N],F_o [N],F_o - F_i [N]"]
    for name, chain, restitutions, until, (begin, end), instants, windows in CASES:
        for e in restitutions:
            found = [forces(chain, e, h * 1e-6, until) for h in STEPS]
            print(name, e, flush=True)
            at = list(range(round(begin / SAMPLE), round(end / SAMPLE) + 1, EVERY))
            for sample in at + [round(instant / SAMPLE) for instant in instants]:
                values = ",".join(f"{value:.6f}" for each in found for value in each[:, sample])
                rows.append(f"{name},{e},{sample * SAMPLE:.4f},{values}")
            for h, each in zip(STEPS, found):
                for lower, upper in windows:
                    i, o = each[:, round(lower / SAMPLE) : round(upper / SAMPLE)]
                    squares.append(f"{name},{e},{h},{lower},{upper},{rms(i):.6f},{rms(o):.6f},{rms(o - i):.6f}")
    for file, lines in (("contact_steps.csv", rows), ("contact_steps_rms.csv", squares)):
        (SCIENCE / file).write_text("\n".join(lines) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
