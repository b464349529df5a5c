"""Masses joined by massless springs, two of whose nodes may be moved: modes, and the exact answer to forces between samples.

Forces and accelerations are straight between the samples of a fine grid; each mode then follows exactly (first-order hold). Modes
above a quarter of the grid's rate answer as springs do. Next door: links that rub or touch (unsmooth.py).
"""

from dataclasses import dataclass

import numpy as np
from scipy import signal

END1, END2 = -1, -2  # nodes whose motion is given


@dataclass(frozen=True)
class Link:
    """A spring between two nodes; its tension is stiffness * (motion of b - motion of a)."""

    a: int
    b: int
    stiffness: float


class Assembly:
    """Grows by `mass` and `link`; `chain` adds a coil."""

    def __init__(self):
        self.masses, self.links = [], []

    def mass(self, kg):
        """A new mass; its node."""
        self.masses.append(kg)
        return len(self.masses) - 1

    def link(self, a, b, stiffness):
        """A new spring from a to b."""
        self.links.append(Link(a, b, stiffness))
        return self.links[-1]

    def chain(self, a, b, count, kg, stiffness):
        """A coil as `count` masses, with half a step of spring to either end; its nodes, its first and its last link."""
        nodes = [self.mass(kg / count) for _ in range(count)]
        first = self.link(a, nodes[0], 2 * count * stiffness)
        for left, right in zip(nodes, nodes[1:]):
            self.link(left, right, count * stiffness)
        return nodes, first, self.link(nodes[-1], b, 2 * count * stiffness)

    def matrices(self):
        """Stiffness among the masses, and the force on each mass per motion of END1 and END2."""
        stiffness, tie = np.zeros((len(self.masses),) * 2), np.zeros((len(self.masses), 2))
        for link in self.links:
            for here, there in ((link.a, link.b), (link.b, link.a)):
                if here >= 0:
                    stiffness[here, here] += link.stiffness
                    if there >= 0:
                        stiffness[here, there] -= link.stiffness
                    else:
                        tie[here, -there - 1] += link.stiffness
        return stiffness, tie


def tension(link, count):
    """The row that makes a link's tension of the masses' motion, and that of END1's and END2's."""
    row = np.zeros(count + 2)
    row[link.b] += link.stiffness
    row[link.a] -= link.stiffness
    return row[:count], np.array([row[END1], row[END2]])


def first_held(count, kg, stiffness):
    """f1 [Hz] of a chain with both ends held: 2 N sqrt(k/m) sin(pi/2N) / 2 pi."""
    return 2 * count * np.sqrt(stiffness / kg) * np.sin(np.pi / 2 / count) / (2 * np.pi)


class Modes:
    """The modes of an assembly whose damping ratios are `zeta`, a function of frequencies [Hz]."""

    def __init__(self, assembly, zeta):
        stiffness, tie = assembly.matrices()
        root = np.sqrt(np.array(assembly.masses))
        squares, vectors = np.linalg.eigh(stiffness / np.outer(root, root))
        self.masses = root**2
        self.angular = np.sqrt(squares)
        self.shapes = vectors / root[:, None]  # of unit modal mass, shape masses x modes
        self.ratios = np.broadcast_to(zeta(self.angular / (2 * np.pi)), squares.shape)
        self.statics = np.linalg.solve(stiffness, tie)  # motion of the masses per motion of the ends
        self.flexibility = np.linalg.inv(stiffness)

    def answer(self, rate, rows, forces=(), ends=()):
        """Rows times the masses' motion over time, shape rows x samples.

        forces: (weight of each mass, newtons over time); ends: (0 for END1 or 1 for END2, motion, its acceleration), all over the grid.
        """
        shapes = [np.asarray(weight) for weight, _ in forces] + [-self.masses * self.statics[:, end] for end, _, _ in ends]
        inputs = np.array([values for _, values in forces] + [pull for _, _, pull in ends])
        rows, shapes = np.atleast_2d(rows), np.array(shapes).T
        gains, sights = self.shapes.T @ shapes, rows @ self.shapes
        kept = self.angular < 0.5 * np.pi * rate
        dropped = self.flexibility - (self.shapes[:, kept] / self.angular[kept] ** 2) @ self.shapes[:, kept].T
        out = (rows @ dropped @ shapes) @ inputs
        kept = np.flatnonzero(kept)
        for some in np.split(kept, range(8, len(kept), 8)):
            struck = gains[some] @ inputs
            for row, mode in enumerate(some):
                struck[row] = signal.lfilter(*held(self.angular[mode], self.ratios[mode], rate), struck[row])
            out += sights[:, some] @ struck
        for end, motion, _ in ends:
            out += np.outer(rows @ self.statics[:, end], motion)
        return out


def held(angular, ratio, rate):
    """The filter that makes a unit mass's motion of a force that is straight between samples: numerator, denominator.

    The motion under a ramp is r(t) = t/w^2 - 2 zeta/w^3 + a part that rings; a straight piece is three ramps, (1, -2, 1) a sample apart.
    """
    step, turn = 1 / rate, angular * np.sqrt(1 - ratio**2)
    pole = np.exp((-ratio * angular + 1j * turn) * step)
    denominator = np.array([1.0, -2 * pole.real, abs(pole) ** 2])

    def ramp(time):
        rings = np.exp(-ratio * angular * time)
        swing = 2 * ratio * np.cos(turn * time) + (2 * ratio**2 - 1) * angular / turn * np.sin(turn * time)
        return (time * angular - 2 * ratio + rings * swing) / angular**3 * rate

    one, two, three = (ramp(n * step) for n in (1, 2, 3))
    tent = np.array([one, two - 2 * one, three - 2 * two + one])
    # The numerator is what the denominator leaves of the answer to one tent.
    return np.convolve(denominator, tent)[:3], denominator
