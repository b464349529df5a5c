"""Modes of a stretched, prestressed helical wire with both ends clamped, by straight beam elements that may turn without limit.

Nothing here is linearised by hand, and nothing is a dynamic stiffness: an energy, its second derivatives by differences at 60 digits, a
mass matrix, and eigenvectors of sparse matrices, on meshes of 20, 40, 80 and 160 elements a winding.

Element between nodes 1 and 2, at x_1 and x_2 with rotations Q_1 and Q_2 (of the section's directors d_1 along the wire, d_2, d_3), one
point, straight and of length h without load (Simo and Vu-Quoc, Comput. Methods Appl. Mech. Eng. 58 (1986) 79-116; strains by the
relative rotation of the nodes, Crisfield and Jelenic, Proc. R. Soc. A 455 (1999) 1125-1147, so that rigid turning strains nothing):

    theta = log(Q_2 Q_1^T),  Q_m = exp(theta/2) Q_1
    Gamma = Q_m^T (x_2 - x_1)/h   extension and two shears,  kappa = Q_m^T theta/h   torsion and two bendings
    W = h/2 ((Gamma - Gamma_0) . diag(EA, kGA, kGA) (Gamma - Gamma_0) + (kappa - kappa_0) . diag(GJ, EI, EI) (kappa - kappa_0))

Without load the nodes stand on the helix of radius R_0 and height l_0, phi = 2 pi N/n apart; d_1 of Q_m lies along the chord. There
Gamma_0 = (1, 0, 0), and kappa_0 = (sin g_0, 0, cos g_0) phi/h with the chord's angle g_0. Shear coefficient k of a round section:
Hutchinson, J. Appl. Mech. 68 (2001) 87-92, 6 (1 + nu)^2/(7 + 12 nu + 4 nu^2); the section is A = pi d^2/4, I = pi d^4/64, J = 2I.

Stretched, at l and the same phi, the nodes stand on a helix again, of radius R, directors tilted by g: W stationary in (R, g), all nodes
then in balance (checked to 1e-25). Force F = dW/d(l/n) along the axis, tension positive; couple C = dW/dphi about it, which keeps end 2
from turning, as a right-hand screw. Stiffness: the Hessian of W by displacements and turns of both nodes, in the nodes' own cylindrical
directions, in which all elements are alike. At a balanced state with clamped ends it does not depend on how turns are written.
Mass: consistent, displacement and spin linear over the element, rho A and the rotary inertia rho diag(J, I, I) in the directors of Q_m.

Frequencies: eigenvectors by SciPy; their Rayleigh quotients, element by element in 64-bit mantissas, since doubles of a fine mesh lose
1e-7. By signs of block pivots no mode was passed over. Every figure of n, 2n, 4n elements a winding, a, b, c, is freed of its errors of
second and fourth order: (16 (4c - b)/3 - (4b - a)/3)/15. The finer three meshes give the value; how far that of the coarser three lies
from it is the error estimate, 60 times what is to be expected of the next order. The second order is checked.

Wire: S_T and S_A of springs.py, E and G times k/(G d^4/(64 R_0^3 N)), density such that the flat coil's wire has mass m. Valve, car and knee
springs are those of examples/, of nominal steel; a wire of closed and ground coils spans the length less 2 d, the knee's unloaded length
is less by its initial tension over k. "test" is the unloaded spring by which programs of helices are commonly compared.

    OMP_NUM_THREADS=1 python helix_elements.py        (1 minute on one core)

Inputs are doubles, written with repr(), used exactly.
"""

from math import pi, radians, tan
from typing import NamedTuple

import mpmath
import numpy as np
import scipy
from mpmath import mp, mpf
from scipy import sparse
from scipy.sparse.linalg import eigsh

from golden import SCIENCE
from springs import S_A, S_T

mp.dps = 60
STEP = mpf(10) ** -15  # of differences: 1e-30 both by what they leave out and by rounding
MESHES = (20, 40, 80, 160)  # elements a winding
MODES = 12
STEEL = (206e9, 81.5e9, 7850.0)  # E, G [Pa], density [kg/m3]


class Case(NamedTuple):
    name: str
    wire: float  # d [m]
    radius: float  # R_0 [m]
    windings: float  # N
    rest: float  # l_0 [m], of the active windings
    span: float  # l [m]
    young: float  # E [Pa]
    shear: float  # G [Pa]
    density: float  # [kg/m3]
    counts: tuple = ()  # frequencies [Hz], and how many modes an earlier program found below them


def of_table(name, spring, span, counts=()):
    """A spring of Table I, its wire's constants brought to k and m of the flat coil."""
    d, (young, shear, _) = 2 * spring.wire_radius, STEEL
    factor = spring.stiffness / (shear * d**4 / (64 * spring.radius**3 * spring.windings))
    density = spring.mass / (0.25 * pi * d**2 * 2 * pi * spring.windings * spring.radius)
    sizes = (float(d), spring.radius, float(spring.windings), spring.rest_length, span)
    return Case(name, *sizes, factor * young, factor * shear, density, counts)


def cases():
    knee_stiffness = STEEL[1] * 0.0015**4 / (64 * 0.006**3 * 40)
    knee_rest = 0.0615 - 8.0 / knee_stiffness
    test_rest = 2 * pi * 7.6 * 0.005 * tan(radians(8.5744))
    return [
        of_table("S_T 196 mm", S_T, 0.196),
        of_table("S_T 230 mm", S_T, 0.230, ((460.0, 31), (697.0, 46), (1142.0, 89))),
        of_table("S_T 264 mm", S_T, 0.264),
        of_table("S_A 102 mm", S_A, 0.102),
        Case("valve 43 mm", 0.004, 0.0125, 5.75, 0.049, 0.035, *STEEL, ((795.0, 6), (1100.0, 9), (1400.0, 15))),
        Case("car 223.3 mm", 0.0125, 0.0575, 6.5, 0.325, 0.1983, *STEEL),
        Case("knee 105 mm", 0.0015, 0.006, 40.0, knee_rest, 0.105, *STEEL),
        Case("test", 0.001, 0.005, 7.6, test_rest, test_rest, 206e9, 206e9 / 2.6, 7900.0),
    ]


def shear_coefficient(poisson):
    """k of a round section, of Hutchinson 2001: 0.925 at nu = 0.3. With Cowper's 0.886 "test" has 393.400 Hz, not 393.416."""
    return 6 * (1 + poisson) ** 2 / (7 + 12 * poisson + 4 * poisson**2)


def product(p, q):
    """Of two quaternions, scalar part first."""
    a, b, c, d = p
    e, f, g, h = q
    return (
        a * e - b * f - c * g - d * h,
        a * f + b * e + c * h - d * g,
        a * g - b * h + c * e + d * f,
        a * h + b * g - c * f + d * e,
    )


def conjugate(q):
    return (q[0], -q[1], -q[2], -q[3])


def turned(q, vector):
    return product(product(q, (0, *vector)), conjugate(q))[1:]


def unit(q):
    size = mp.sqrt(sum(part * part for part in q))
    return tuple(part / size for part in q)


def directors(tilt):
    """Q_m of an element that is cut at x > 0: d_1 = (0, cos g, sin g), d_2 = (-1, 0, 0), d_3 = (0, -sin g, cos g)."""
    about_x = (mp.cos(tilt / 2), mp.sin(tilt / 2), 0, 0)
    return product(about_x, (mp.sqrt(mpf(0.5)), 0, 0, mp.sqrt(mpf(0.5))))


def derivatives(function, point):
    """Gradient and Hessian, by central differences."""
    size = len(point)

    def at(*moves):
        moved = list(point)
        for index, sign in moves:
            moved[index] += sign * STEP
        return function(moved)

    here, ahead, behind = at(), [at((i, 1)) for i in range(size)], [at((i, -1)) for i in range(size)]
    gradient = [(ahead[i] - behind[i]) / (2 * STEP) for i in range(size)]
    hessian = mp.zeros(size)
    for i in range(size):
        hessian[i, i] = (ahead[i] - 2 * here + behind[i]) / STEP**2
        for j in range(i):
            mixed = at((i, 1), (j, 1)) - at((i, 1), (j, -1)) - at((i, -1), (j, 1)) + at((i, -1), (j, -1))
            hessian[i, j] = hessian[j, i] = mixed / (4 * STEP**2)
    return gradient, hessian


class Element:
    """One of n elements of a case. Units: R_0, EI/R_0^2, and mass so that rho A is 1."""

    def __init__(self, case, per_winding):
        self.count = round(per_winding * mpf(case.windings))
        self.angle = 2 * mp.pi * mpf(case.windings) / self.count
        advance = mpf(case.rest) / mpf(case.radius) / self.count
        chord = 2 * mp.sin(self.angle / 2)
        self.length = mp.hypot(chord, advance)
        self.tilt = mp.atan2(advance, chord)
        self.bent = (mp.sin(self.tilt) * self.angle / self.length, 0, mp.cos(self.tilt) * self.angle / self.length)
        ratio = mpf(case.young) / (2 * mpf(case.shear))  # 1 + nu
        self.inertia = (mpf(case.wire) / mpf(case.radius)) ** 2 / 16  # I/A
        sheared = shear_coefficient(ratio - 1) / (2 * ratio * self.inertia)
        self.against_stretch = (1 / self.inertia, sheared, sheared)
        self.against_bending = (1 / ratio, 1, 1)

    def energy(self, state, moves=(0,) * 12):
        """W at (R, g, l/n, phi), the nodes displaced and turned besides."""
        radius, tilt, advance, angle = state
        places, turns = [], []
        for side, move in ((-1, moves[:6]), (1, moves[6:])):
            stands = (mp.cos(angle / 4), 0, 0, side * mp.sin(angle / 4))
            places.append(turned(stands, (radius + move[0], move[1], side * advance / 2 + move[2])))
            turns.append(product(stands, unit((1, move[3] / 2, move[4] / 2, move[5] / 2))))
        between = product(turns[1], conjugate(turns[0]))
        sine = mp.sqrt(sum(part * part for part in between[1:]))
        theta = [2 * mp.atan2(sine, between[0]) / sine * part for part in between[1:]]
        middle = product(unit([a + b for a, b in zip(*turns)]), directors(tilt))
        gamma = turned(conjugate(middle), [(b - a) / self.length for a, b in zip(*places)])
        kappa = turned(conjugate(middle), [part / self.length for part in theta])
        total = sum(c * (v - v0) ** 2 for c, v, v0 in zip(self.against_stretch, gamma, (1, 0, 0)))
        total += sum(c * (v - v0) ** 2 for c, v, v0 in zip(self.against_bending, kappa, self.bent))
        return total * self.length / 2

    def stretched(self, span):
        """(R, g, l/n, phi) that is stationary in R and g, by Newton from the state without load, in ten parts of the way."""
        state = [mpf(1), self.tilt, 2 * mp.sin(self.angle / 2) * mp.tan(self.tilt), self.angle]
        first = state[2]
        for part in range(1, 11):
            state[2] = first + (span / self.count - first) * part / 10
            for _ in range(5 if part < 10 else 9):
                gradient, hessian = derivatives(lambda pair: self.energy([*pair, *state[2:]]), state[:2])
                step = mp.lu_solve(hessian, mp.matrix(gradient))
                state[:2] = [state[0] - step[0], state[1] - step[1]]
        return state

    def stiffness(self, state):
        """Hessian, 12 by 12, after a look at the balance of a node between two elements."""
        gradient, hessian = derivatives(lambda moves: self.energy(state, moves), [mpf(0)] * 12)
        left = max(abs(gradient[i] + gradient[i + 6]) for i in range(6))
        assert left < mpf(10) ** -25, left
        return np.array([[np.longdouble(mp.nstr(value, 25)) for value in row] for row in hessian.tolist()])

    def mass(self, state):
        """Of displacements and spins that are linear over the element; nodes' cylindrical directions."""
        frame = np.array([[float(v) for v in turned(directors(state[1]), row)] for row in np.eye(3).tolist()])
        spin = float(self.inertia) * frame.T @ np.diag([2.0, 1.0, 1.0]) @ frame
        half = float(state[3]) / 2
        out = np.zeros((12, 12))
        turns = [np.array([[np.cos(a), -np.sin(a), 0], [np.sin(a), np.cos(a), 0], [0, 0, 1]]) for a in (-half, half)]
        for i in range(2):
            for j in range(2):
                weight = float(self.length) / (3 if i == j else 6)
                out[6 * i : 6 * i + 3, 6 * j : 6 * j + 3] = weight * turns[i].T @ turns[j]
                out[6 * i + 3 : 6 * i + 6, 6 * j + 3 : 6 * j + 6] = weight * turns[i].T @ spin @ turns[j]
        return out


def chain(element, count):
    """Of the free nodes between `count` like elements in a row: the matrix, its block on the diagonal and that above."""
    element = element.astype(float)
    middle, beside = element[:6, :6] + element[6:, 6:], element[:6, 6:]
    right = sparse.eye(count - 1, k=1)
    whole = sparse.kron(sparse.eye(count - 1), middle) + sparse.kron(right, beside) + sparse.kron(right.T, beside.T)
    return whole.tocsc(), middle, beside


def below(stiffness, mass, value, nodes):
    """How many eigenvalues lie below a value: negative ones of the pivots of K - value M."""
    middle, beside = (k - value * m for k, m in zip(stiffness, mass))
    pivot, found = middle, 0
    for node in range(nodes):
        pivot = middle - beside.T @ np.linalg.solve(pivot, beside) if node else middle
        pivot = (pivot + pivot.T) / 2
        found += int(np.sum(np.linalg.eigvalsh(pivot) < 0))
    return found


def quotients(stiffness, mass, vectors):
    """Rayleigh quotients of the free nodes' vectors (columns)."""
    nodes = np.zeros((len(vectors) // 6 + 2, 6, vectors.shape[1]), dtype=np.longdouble)
    nodes[1:-1] = vectors.reshape(-1, 6, vectors.shape[1])
    ends = np.concatenate([nodes[:-1], nodes[1:]], axis=1)

    def form(element):
        return sum((ends[:, i] * np.tensordot(ends, element[i], axes=(1, 0))).sum(axis=0) for i in range(12))

    return form(stiffness) / form(mass)


def solve(case, per_winding, modes):
    """Force [N], couple [N m], frequencies [Hz] of one mesh."""
    element = Element(case, per_winding)
    state = element.stretched(mpf(case.span) / mpf(case.radius))
    gradient, _ = derivatives(element.energy, state)
    bending = mpf(case.young) * mp.pi * mpf(case.wire) ** 4 / 64
    force, couple = gradient[2] * bending / mpf(case.radius) ** 2, gradient[3] * bending / mpf(case.radius)
    area = mp.pi * mpf(case.wire) ** 2 / 4
    rate = float(mp.sqrt(bending / (mpf(case.density) * area)) / mpf(case.radius) ** 2)
    stiffness, mass = element.stiffness(state), element.mass(state)
    k, *blocks = chain(stiffness, element.count)
    m, *mass_blocks = chain(mass, element.count)
    start = np.random.default_rng(1).standard_normal(k.shape[0])
    _, vectors = eigsh(k, modes, m, sigma=0.0, v0=start)
    values = np.sort(quotients(stiffness, mass, vectors))
    inside = float(values[-2] + values[-1]) / 2
    assert below(blocks, mass_blocks, inside, element.count - 1) == modes - 1, "a mode was passed over"
    frequencies = np.sqrt(values).astype(float) * rate / (2 * np.pi)
    return np.array([float(force), float(couple), *frequencies])


def extrapolated(case):
    """Force, couple, frequencies, and their error estimates."""
    modes = max([MODES, *(expected for _, expected in case.counts)]) + 5
    meshes = np.array([solve(case, per_winding, modes) for per_winding in MESHES])
    differences = meshes[1:] - meshes[:-1]
    for index in range(0 if case.span != case.rest else 2, MODES + 2):
        order = np.log2(differences[:-1, index] / differences[1:, index])
        assert abs(order[-1] - 2) < 0.02, (case.name, index, order)
    second = (4 * meshes[1:] - meshes[:-1]) / 3
    fourth = (16 * second[1:] - second[:-1]) / 15
    return fourth[1], np.abs(fourth[1] - fourth[0])


def rows_of(case):
    """Lines of the table."""
    values, errors = extrapolated(case)
    rows = []
    if case.span != case.rest:
        rows += [f"{case.name},force [N],0,{values[0]:.12g},{errors[0]:.1e}"]
        rows += [f"{case.name},couple [N m],0,{values[1]:.12g},{errors[1]:.1e}"]
    frequencies, errors = values[2:], errors[2:]
    rows += [f"{case.name},frequency [Hz],{j + 1},{frequencies[j]:.12g},{errors[j]:.1e}" for j in range(MODES)]
    for limit, expected in case.counts:
        count = int(np.sum(frequencies < limit))
        assert count < len(frequencies) and count == expected, (case.name, limit, count)
        rows.append(f"{case.name},modes below [Hz],{count},{limit!r},0")
    print("\n".join(rows), f"largest relative error estimate {(errors / frequencies)[:MODES].max():.1e}", sep="\n", flush=True)
    return rows


def write(name, tools, columns, rows):
    (SCIENCE / name).write_text("\n".join([tools, columns, *rows]) + "\n", encoding="utf-8", newline="\n")


def main():
    assert np.finfo(np.longdouble).nmant >= 63, "needs a mantissa of 64 bits"
    tools = f"# mpmath {mpmath.__version__} numpy {np.__version__} scipy {scipy.__version__}"
    inputs = [",".join([case.name, *(repr(value) for value in case[1:9])]) for case in cases()]
    head = f"{tools}; shortest round-trip doubles; reference/helix_elements.py; cases of helix_modes.csv, without load but for l"
    columns = "case,d [m],R_0 [m],N [-],l_0 [m],l [m],E [Pa],G [Pa],density [kg/m3]"
    write("helix_modes_cases.csv", head, columns, inputs)
    head = (
        f"{tools}; digits as the error estimates say; reference/helix_elements.py; straight beam elements, 40, 80, 160 a winding,"
        " extrapolated; both ends clamped; mode counts of those below a frequency"
    )
    rows = [row for case in cases() for row in rows_of(case)]
    write("helix_modes.csv", head, "case,quantity,mode [-],value,error estimate", rows)


if __name__ == "__main__":
    main()
