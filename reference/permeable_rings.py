"""Inductance of a row of equal rings of round wire of one permeability, in series, by finite elements: no boundary integrals, no K or E.

N turns of radius r (to the wire's middle), wire of radius a, p apart along the axis. A turn carries I = 1 A of direct current, which goes
round the axis only and crowds inwards as it does in a helical wire: j = c/sqrt((2 pi rho)^2 + p^2), rho the distance from the axis, c such
that the integral of j over a wire's section is I. Permeability mu_r mu0 in the wires, mu0 around them.

    curl(curl A/mu) = j,   A = rho w,   B_z = 2 w + rho dw/drho,   B_rho = -rho dw/dz
    for all v:  2 pi int (B(w) . B(v))/mu rho drho dz = 2 pi int j rho v rho drho dz
    L = 2 pi int j A rho drho dz / I^2

w = A/rho is smooth and even in rho, so that the axis asks for no condition and nothing is divided by rho. w is even in z too (nothing to
ask at the middle plane, half the space is enough), and zero on a sphere 35 m from the coil's middle.

Elements: quadrilaterals of order 6, isoparametric, nodes at Gauss and Lobatto's points of an exact map, so that the edges of wires are
circles to order 6, 8 by 8 Gauss points. The mesh is made of blocks. Every quarter of a wire's section is a square of bent sides and two
blocks around it; two more lie between it and a box p high, whose upper and lower sides carry nodes above those of the wire, for gaps that
are thin. Rectangles fill the half plane up to a little beyond the coil, and from there blocks grow in geometric progression along rays up
to the sphere. No edge of a wire has a corner, so that all converges as fast as the order allows. Meshes of 1, 2, 3 elements to an eighth of
a wire's edge; the third is the value, how far the second lies from it (1e-10 of L at least) the error estimate, too large for the third.

The far end: the field of a coil falls with 1/R^3, and a sphere at R on which A = 0 takes from L a part that goes with (r/R)^3: at 0.35 m
8e-6 to 1e-5 (1 turn), 1.5e-5 to 2.4e-5 (3, 4 turns), 3e-5 to 4e-5 (8 turns), at 35 m 3e-11. A sphere at 350 m changes less than
1e-10 (checked).

Second route, another unknown, order and meshes: A itself, zero on the axis, by elements of order 2, 4, 8 and 16 of them to an eighth of a
wire's edge, extrapolated by their error of fourth order. It must agree to 1e-8 (does to 3e-9), and their order must be 4. Also checked:
turns in air (mu_r = 1) superpose: L of four from meshes of one turn and of two at one, two and three pitches, to 1e-9;
a thin ring, mu0 r (ln(8 r/a) - 2 + mu_r/4), to 2e-6 at a = r/1000, mu_r = 1, 5, 20;
a ring of uniform current and mu_r = 1, mu0 r ((1 + a^2/(8 r^2)) ln(8 r/a) + a^2/(24 r^2) - 7/4) (Rayleigh, Proc. R. Soc. A 86 (1912)
562-571), to 3e-8 at a = r/100.

Figures of another author's finite elements (in crates/coilsense/tests/permeable.rs, up to 4e-5 below ours) are printed beside these, with
ours for a sphere at 0.35 m, where that author's space ends: there they agree to 1e-5. Nothing is fitted to them. Printed too: how much
larger L is if j goes along the wire and its part about the axis is j 2 pi rho/sqrt((2 pi rho)^2 + p^2), 4e-5 to 1.5e-4.

    OMP_NUM_THREADS=1 python permeable_rings.py        (1.5 minutes on one core)

Inputs are doubles, written with repr(), used exactly; mu0 = 4 pi 1e-7 H/m.
"""

import math
from collections.abc import Callable
from functools import cache
from typing import NamedTuple

import numpy as np
import scipy
from numpy.polynomial import legendre
from scipy import sparse
from scipy.sparse.csgraph import connected_components
from scipy.sparse.linalg import splu
from scipy.spatial import cKDTree

from golden import SCIENCE

MU0 = 4e-7 * math.pi  # [H/m]
COIL_RADIUS, WIRE_RADIUS = 8.47e-3, 1.41e-3  # [m]
SPHERE = 35.0  # where A = 0 [m]
NEAR_SPHERE = 0.35  # of the other author [m]
ORDER, MESHES = 6, (1, 2, 3)  # elements to an eighth of a wire's edge
SECOND_ORDER, SECOND_MESHES = 2, (4, 8, 16)

# Turns, pitch over wire diameter, {mu_r: L of the other author [nH], where there is one}.
CASES = [
    (4, 1.1, {1.0: 195.411, 1.5: 206.858, 2.0: 216.784, 5.0: 262.786, 20.0: 434.63}),
    (4, 1.6, {1.0: 161.780, 1.5: 170.206, 2.0: 177.694, 5.0: 215.277, 20.0: 377.66}),
    (8, 1.3, {1.0: 439.749, 1.5: 464.060, 2.0: 484.894, 5.0: 579.105, 20.0: 923.20}),
    (4, 1.05, dict.fromkeys((1.0, 2.0, 5.0, 20.0))),
    (3, 1.2, dict.fromkeys((1.0, 2.5))),
    (1, 1.3, dict.fromkeys((1.0, 5.0))),
]


class Row(NamedTuple):
    """Turns, each in a box, and what is meshed around them. Lengths in m."""

    turns: int
    coil_radius: float
    wire_radius: float
    half_height: float  # of a box: half the pitch
    half_width: float  # of a box
    margin: float  # around the boxes, before the rays begin
    sphere: float
    layers: int = 1  # between wire and box, in a mesh of 1


class Block(NamedTuple):
    """The image of the unit square, cut into across x along elements."""

    place: Callable  # (u, v) -> (rho, z)
    across: int
    along: int
    wire: bool


def row_of(turns, pitch, sphere=SPHERE):
    return Row(turns, COIL_RADIUS, WIRE_RADIUS, pitch / 2, 1.5 * WIRE_RADIUS, 4e-3, sphere)


def pitch_of(over_diameter):
    return round(over_diameter * 2 * WIRE_RADIUS, 9)


def straight(start, end):
    return lambda t: start + (end - start) * t


def quarter(row, middle, side, upward, n):
    """Blocks of a quarter of a turn's box, outwards or inwards, upwards or downwards. v goes from the box's middle line to its corner."""
    a, width, height = row.wire_radius, row.half_width, row.half_height
    core, corner = 0.5 * a, 0.42 * a
    growth = min(width, height) / a  # of layers between wire and box

    def layer(u):
        return (growth**u - 1) / (growth - 1)

    def arc(v):
        return a * np.cos(math.pi / 4 * v), a * np.sin(math.pi / 4 * v)

    def at(x, z):
        return row.coil_radius + side * x, middle + upward * z

    def square(u, v):
        return at(core * u + (corner - core) * u * v, core * v + (corner - core) * u * v)

    def around(u, v):
        far, along = arc(v)
        near, beside = core + (corner - core) * v, corner * v
        return near + (far - near) * u, beside + (along - beside) * u

    def beside(u, v):
        x, z = arc(v)
        return at(x + (width - x) * layer(u), z + (height * v - z) * layer(u))

    def above(u, v):
        z, x = arc(v)
        return at(x + (upper_side(row)(v) - x) * layer(u), z + (height - z) * layer(u))

    layers = row.layers * n
    return [
        Block(square, n, n, True),
        Block(lambda u, v: at(*around(u, v)), n, n, True),
        Block(lambda u, v: at(*around(u, v)[::-1]), n, n, True),
        Block(beside, layers, n, False),
        Block(above, layers, n, False),
    ]


def upper_side(row):
    """x of the nodes of a box's upper side, first straight above those of the wire."""
    a = row.wire_radius
    return lambda v: a * np.sin(math.pi / 4 * v) + (row.half_width - a * math.sqrt(0.5)) * v**3


def blocks(row, n):
    """Of the half z > 0: boxes, rectangles beside and above them, rays."""
    r, height = row.coil_radius, row.half_height
    inside, outside, top = r - row.half_width, r + row.half_width, row.turns * height
    found, rows = [], []
    for turn in range((row.turns + 1) // 2):
        middle = (2 * turn + (row.turns + 1) % 2) * height
        for upward in (-1, 1) if middle > 0 else (1,):
            rows.append((straight(middle, middle + upward * height), n))
            for side in (-1, 1):
                found += quarter(row, middle, side, upward, n)
    columns = [(lambda v, side=side: r + side * upper_side(row)(v), n) for side in (-1, 1)]
    left, right = (straight(0.0, inside), 2 * n), (straight(outside, outside + row.margin), n)
    over = (straight(top, top + row.margin), n)

    def rectangle(x, z):
        found.append(Block(lambda u, v: (x[0](u), z[0](v)), x[1], z[1], False))

    for z in rows:
        rectangle(left, z)
        rectangle(right, z)
    for x in (left, *columns, right):
        rectangle(x, over)

    rays = math.ceil(3 * n * math.log10(row.sphere / (outside + row.margin)))

    def fan(side, along):
        def place(u, v):
            rho, z = side(v)
            stretch = (row.sphere / np.hypot(rho, z)) ** u
            return rho * stretch, z * stretch

        found.append(Block(place, rays, along, False))

    for z, along in (*rows, over):
        fan(lambda v, z=z: (outside + row.margin + 0 * v, z(v)), along)
    for x, along in (left, *columns, right):
        fan(lambda v, x=x: (x(v), top + row.margin + 0 * v), along)
    return found


def lobatto(order):
    """order + 1 points of Gauss and Lobatto on [-1, 1]."""
    return np.concatenate([[-1.0], np.sort(legendre.legroots(legendre.legder([0] * order + [1]))), [1.0]])


def lagrange(nodes, points):
    """Values and slopes of the nodes' polynomials (columns) at points (rows)."""
    count = len(nodes)
    slopes = np.stack([legendre.legval(points, legendre.legder(unit)) for unit in np.eye(count)], axis=1)
    coefficients = np.linalg.inv(legendre.legvander(nodes, count - 1))
    return legendre.legvander(points, count - 1) @ coefficients, slopes @ coefficients


class Elements:
    """The system for u, A = rho^power u, of one mesh: power 1 is w, power 0 is A itself."""

    def __init__(self, row, n, order, power=1):
        self.row, self.power = row, power
        nodes = lobatto(order)
        places, wire = [], []
        for block in blocks(row, n):
            i, j = (index.ravel()[:, None] for index in np.indices((block.across, block.along)))
            u, v = (i + (nodes + 1) / 2) / block.across, (j + (nodes + 1) / 2) / block.along
            rho, z = np.broadcast_arrays(*block.place(u[:, :, None], v[:, None, :]), u[:, :, None] + v[:, None, :])[:2]
            places.append(np.stack([rho, z], axis=-1).reshape(len(i), -1, 2))
            wire += [block.wire] * len(i)
        places, self.wire = np.concatenate(places), np.array(wire)
        self.number(places)
        self.assemble(places, nodes)

    def number(self, places):
        """Nodes of several elements that lie at one place are one; those that are held at zero are left out."""
        flat = places.reshape(-1, 2)
        pairs = cKDTree(flat).query_pairs(1e-7 * self.row.wire_radius, output_type="ndarray")
        graph = sparse.coo_matrix((np.ones(len(pairs)), pairs.T), (len(flat), len(flat)))
        self.count, labels = connected_components(graph, directed=False)
        self.nodes = labels.reshape(places.shape[:2])
        held = np.hypot(*flat.T) > self.row.sphere * (1 - 1e-9)
        if self.power == 0:
            held |= flat[:, 0] < 1e-9 * self.row.wire_radius
        self.free = np.setdiff1d(np.arange(self.count), labels[held])

    def assemble(self, places, nodes):
        points, weights = legendre.leggauss(len(nodes) + 1)
        values, slopes = lagrange(nodes, points)
        shape, by_u, by_v = np.kron(values, values), np.kron(slopes, values), np.kron(values, slopes)
        at, along_u, along_v = shape @ places, by_u @ places, by_v @ places
        size = along_u[..., 0] * along_v[..., 1] - along_u[..., 1] * along_v[..., 0]
        assert (np.abs(np.sign(size).sum(axis=1)) == size.shape[1]).all(), "an element is folded"
        by_rho = by_u * (along_v[..., 1] / size)[..., None] - by_v * (along_u[..., 1] / size)[..., None]
        by_z = by_v * (along_u[..., 0] / size)[..., None] - by_u * (along_v[..., 0] / size)[..., None]
        self.shape, self.rho = shape, at[..., 0]
        self.area = np.outer(weights, weights).ravel() * np.abs(size)
        rho = self.rho[..., None]
        axial = rho ** (self.power - 1) * ((1 + self.power) * shape + rho * by_rho)
        radial = -(rho**self.power) * by_z
        volume = 2 * math.pi * self.area[..., None] * rho
        parts = [(volume * field).transpose(0, 2, 1) @ field for field in (axial, radial)]
        matrices = parts[0] + parts[1]
        each = self.nodes.shape[1]
        places_in = np.repeat(self.nodes, each, axis=1).ravel(), np.tile(self.nodes, each).ravel()

        def total(where):
            entries = (matrices * where[:, None, None]).ravel()
            return sparse.coo_matrix((entries, places_in), (self.count, self.count)).tocsc()[self.free][:, self.free]

        self.air, self.wires = total(~self.wire), total(self.wire)

    def load(self, density):
        """Right-hand side for a current density of a shape, 1 A in every turn."""
        rho, area = self.rho[self.wire], self.area[self.wire]
        current = density(rho)
        current *= self.row.turns / 2 / (current * area).sum()
        load = np.zeros(self.count)
        np.add.at(load, self.nodes[self.wire], (2 * math.pi * current * rho ** (1 + self.power) * area) @ self.shape)
        return load[self.free]

    def inductance(self, density, permeability):
        """L [H]."""
        load = self.load(density)
        matrix = self.air + self.wires / permeability
        # Symmetric and positive: no pivoting.
        factors = splu(matrix, permc_spec="MMD_AT_PLUS_A", diag_pivot_thresh=0.0, options={"SymmetricMode": True})
        return 2 * MU0 * float(load @ factors.solve(load))


def helical(pitch):
    """The shape of j."""
    return lambda rho: 1 / np.sqrt((2 * math.pi * rho) ** 2 + pitch**2)


def uniform(rho):
    return np.ones_like(rho)


def differs(value, right):
    return abs(value / right - 1)


def solved(turns, over_diameter, permeabilities):
    """L and its error estimate, by permeability, after the second route has agreed."""
    pitch = pitch_of(over_diameter)
    row, density = row_of(turns, pitch), helical(pitch)

    def of(meshes, order, power):
        each = [Elements(row, n, order, power) for n in meshes]
        return np.array([[elements.inductance(density, mu) for elements in each] for mu in permeabilities])

    values = of(MESHES, ORDER, 1)
    found, errors = values[:, -1], np.maximum(np.abs(values[:, -1] - values[:, -2]), 1e-10 * values[:, -1])
    coarse, middle, fine = of(SECOND_MESHES, SECOND_ORDER, 0).T
    order = np.log2((middle - coarse) / (fine - middle))
    apart = np.max(np.abs((16 * fine - middle) / 15 / found - 1))
    print(f"{turns} turns, {over_diameter}: second route {apart:.1e} apart, its order {order.min():.2f} to {order.max():.2f};", end=" ")
    print(f"error estimate {np.max(errors / found):.1e}", flush=True)
    assert apart < 1e-8, apart
    assert np.all(np.abs(order - 4) < 0.2), order
    return found, errors


def check_far_end():
    for turns, over_diameter in ((4, 1.6), (8, 1.3)):
        pitch = pitch_of(over_diameter)
        near, far = (Elements(row_of(turns, pitch, sphere), 2, ORDER).inductance(helical(pitch), 5.0) for sphere in (SPHERE, 10 * SPHERE))
        print(f"sphere at {SPHERE} m and ten times as far: {near / far - 1:.1e}", flush=True)
        assert differs(near, far) < 1e-10


def check_superposition():
    """Four turns in air by one turn and by two of every distance."""
    pitch = pitch_of(1.1)

    @cache
    def of(turns, apart):
        return Elements(row_of(turns, apart), 2, ORDER).inductance(helical(pitch), 1.0)

    alone = of(1, 1.3 * pitch)
    mutual = [of(2, distance * pitch) / 2 - alone for distance in (1, 2, 3)]
    right = 4 * alone + 2 * (3 * mutual[0] + 2 * mutual[1] + mutual[2])
    print(f"superposition: {of(4, pitch) / right - 1:.1e}", flush=True)
    assert differs(of(4, pitch), right) < 1e-9


def check_thin_rings():
    ring = Elements(Row(1, 1.0, 1e-3, 0.3, 0.3, 0.5, 1e4, layers=8), 2, ORDER)
    for permeability in (1.0, 5.0, 20.0):
        right = MU0 * (math.log(8e3) - 2 + permeability / 4)
        value = ring.inductance(helical(0.0), permeability)
        print(f"thin ring, permeability {permeability}: {value / right - 1:.1e}", flush=True)
        assert differs(value, right) < 2e-6
    a = 0.01
    right = MU0 * ((1 + a * a / 8) * math.log(8 / a) + a * a / 24 - 1.75)
    value = Elements(Row(1, 1.0, a, 0.3, 0.3, 0.5, 1e4, layers=4), 2, ORDER).inductance(uniform, 1.0)
    print(f"ring of uniform current: {value / right - 1:.1e}", flush=True)
    assert differs(value, right) < 3e-8


def compare(turns, over_diameter, others, found):
    """Prints the other author's figures, those of a near sphere and of the other reading of j beside ours."""
    pitch = pitch_of(over_diameter)
    near, far = (Elements(row_of(turns, pitch, sphere), 2, ORDER) for sphere in (NEAR_SPHERE, SPHERE))
    for (permeability, other), value in zip(others.items(), found):
        enclosed = near.inductance(helical(pitch), permeability)
        along = far.inductance(lambda rho: rho * helical(pitch)(rho) ** 2, permeability)
        line = f"{turns} turns, {over_diameter}, permeability {permeability}: {value * 1e9:.6f} nH"
        if other is not None:
            line += f", other {other} ({other * 1e-9 / value - 1:+.1e})"
        line += f", sphere at {NEAR_SPHERE} m {enclosed * 1e9:.5f} ({enclosed / value - 1:+.1e})"
        print(f"{line}, part of a current along the wire {along / value - 1:+.1e}", flush=True)


def main():
    check_thin_rings()
    check_superposition()
    check_far_end()
    rows = [
        f"# numpy {np.__version__} scipy {scipy.__version__}; 10 digits; reference/permeable_rings.py; finite elements of order 6,"
        " A = 0 at 35 m, j as direct current in a helix; checked by elements of order 2 to 1e-8; inputs are exact doubles,"
        " mu0 = 4 pi 1e-7 H/m",
        "turns [-],coil radius [m],wire radius [m],pitch over wire diameter [-],pitch [m],relative permeability [-],inductance [H],"
        "error estimate [H]",
    ]
    for turns, over_diameter, others in CASES:
        found, errors = solved(turns, over_diameter, list(others))
        compare(turns, over_diameter, others, found)
        start = f"{turns},{COIL_RADIUS!r},{WIRE_RADIUS!r},{over_diameter!r},{pitch_of(over_diameter)!r}"
        rows += [f"{start},{mu!r},{value:.9e},{error:.0e}" for mu, value, error in zip(others, found, errors)]
    (SCIENCE / "permeable_rings.csv").write_text("\n".join(rows) + "\n", encoding="utf-8", newline="\n")


if __name__ == "__main__":
    main()
