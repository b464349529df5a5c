"""A random spring in a random rig: hits on windings or at end 1, a slow motion of end 1, and the forces at both ends.

By default f1 14 to 150 Hz (a third of them S_T: 54.06 Hz, 65 g, 760 N/m), 100 masses, 4 to 7 hits in 20 s.
Next door: the mounts that kinds put it on (mount_kinds.py), what their channels do to it (channel_kinds.py).
"""

from dataclasses import dataclass
from typing import Callable

import numpy as np

from assembly import END1, END2, Assembly, Modes, first_held, tension
from record import Truth, log_uniform
from scene import Scene, scene, zeta_law

PLAIN = (54.06, 0.065)  # f1 [Hz], mass [kg]: 760 N/m
REST = 0.1  # length without force [m]


@dataclass
class Rig:
    """A spring and its scene. `peak` [N] is what a hit's wave pulls at an end, about."""

    scene: Scene
    first: float
    mass: float
    stiffness: float
    zeta: Callable
    masses: int
    peak: float
    places: np.ndarray  # of the hits, 0 at end 1 to 1
    where: str  # "winding"; "step" or "bump" of end 1

    def truth(self, kind, **more):
        """Of a log of this spring whose positions were recorded."""
        exact = self.masses >= 80  # below, a mass and a stiffness of a chain do not give f1 as those of a coil do
        known = {"mass": self.mass if exact else None, "stiffness": self.stiffness, "zeta": float(self.zeta(np.array(self.first)))}
        return Truth(kind, True, self.first, **(known | more))


def rig(rng, masses=100, first=None, peak=None, **options):
    """A random rig; `options` are those of `scene`."""
    if first is None:
        first, mass = PLAIN if rng.random() < 1 / 3 else (log_uniform(rng, 14, 150), log_uniform(rng, 0.02, 0.4))
    else:
        mass = log_uniform(rng, 0.02, 0.4)
    stiffness = 4 * first**2 * mass
    first = float(first_held(masses, mass, stiffness))
    happening = scene(rng, first, **options)
    count = len(happening.hits)
    places = rng.uniform(0.04, 0.96, count) if rng.random() < 0.5 else np.full(count, rng.uniform(0.04, 0.96))
    where = ("winding", "winding", "winding", "step", "step", "bump")[rng.integers(6)]
    if where == "bump":  # there and back takes time
        happening.width = min(max(happening.width, 0.04 / first), 0.0035)
    peak = peak or log_uniform(rng, 0.5, 6)
    return Rig(happening, first, mass, stiffness, zeta_law(rng, first)[0], masses, peak, places, where)


@dataclass
class Built:
    """An assembly that holds the spring: its nodes, and the links whose tensions are F_i and F_o."""

    assembly: Assembly
    nodes: list
    input: object
    output: object
    end2: int = END2  # the node at which the spring ends


def plain(rig):
    """The spring between end 1 and a rigid cell."""
    assembly = Assembly()
    return Built(assembly, *assembly.chain(END1, END2, rig.masses, rig.mass, rig.stiffness))


def blows(rig, built, targets=None):
    """The forces and end motions of a rig's hits and slow motion, for `Modes.answer`; hits go to `targets` where given (a mass per hit)."""
    forces, ends = [], [(0, *rig.scene.slow_motion())]
    for number, size in enumerate(rig.scene.sizes):
        if rig.where == "winding" or targets is not None:
            target = np.zeros(len(built.assembly.masses))
            momentum = rig.peak * size / (4 * rig.first)
            at = rig.places[number] * (len(built.nodes) - 1)
            node = built.nodes[round(at)] if targets is None else targets[number]
            target[node] = 1
            forces.append((target, momentum * rig.scene.pulse(number)))
        else:
            reach = rig.peak * rig.scene.width / np.sqrt(rig.stiffness * rig.mass)
            ends.append((0, *rig.scene.jerk(number, reach * size, rig.where == "step")))
    return forces, ends


def simulate(rig, built, forces, ends, law=None):
    """Fine series of F_i, F_o, u1 and u2 (lengths from END1's mean).

    law: from (modes, rate, rows, answer) what a law that is not linear adds to the rows; answer(rows) is the linear one.
    """
    rate, count = rig.scene.fine_rate, len(built.assembly.masses)
    modes = Modes(built.assembly, lambda f: np.minimum(rig.zeta(f), 0.2))
    (input_row, input_ends), (output_row, output_ends) = (tension(link, count) for link in (built.input, built.output))
    place = np.zeros(count)
    if built.end2 >= 0:
        place[built.end2] = 1
    rows = np.array([input_row, output_row, place])
    answer = modes.answer(rate, rows, forces, ends)
    if law:
        answer += law(modes, rate, rows, lambda rows: modes.answer(rate, rows, forces, ends))
    motion = np.zeros((2, len(rig.scene.time)))
    for end, path, _ in ends:
        motion[end] += path
    length = REST + rig.scene.preload / rig.stiffness
    return {
        "F_i": rig.scene.preload + answer[0] + input_ends @ motion,
        "F_o": rig.scene.preload + answer[1] + output_ends @ motion,
        "u1": motion[0],
        "u2": length + answer[2] + motion[1],
    }


def chosen(rng, series, forces="both", positions=None):
    """The channels of a log: forces "both", "one" or a name; positions None for a random choice of u1, u1 and u2, or none."""
    if forces == "one":
        forces = ("F_i", "F_o", "F_o")[rng.integers(3)]
    names = ["F_i", "F_o"] if forces == "both" else [forces]
    if positions is None:
        positions = (["u1"], ["u1"], ["u1", "u2"], [])[rng.integers(4)]
    return {name: series[name] for name in [*positions, *names]}


def spring_log(rig, kind, series, instruments=None, arguments=(), **more):
    """The log of chosen series of one spring."""
    if "u1" not in series:
        more |= {"mass": None, "stiffness": None}
    return rig.scene.log(series, rig.truth(kind, **more), instruments, arguments)
