"""Dynamic stiffness of the chain of eqs. (4) to (7) and of its continuous limit, with damping; forces through a load.

Writes two_port.csv. N masses m/N, springs Nk between them and 2Nk at the ends; time factor e^(j omega t); tension positive;
[F_i; F_o] = [[-drive, transfer], [-transfer, drive]] [U1; U2].

Route for the chain: no dispersion relation and no closed-form modes. The windings' N complex equations, with the damping
matrix C acting on velocities relative to the straight line between the ends, are solved by LU in ball arithmetic (Arb,
512 bits) for a unit displacement of each end. C = beta K or alpha M as they stand; for modal ratios from the eigenvectors
of mpmath's symmetric eigen-solver, 80 digits. With a load the two ends are two further unknowns of the same system.

Route for the wave (windings = 0): the boundary-value problem of the continuous coil solved by a particular solution and
two exponentials; modal ratios by the digamma function, the last ratio going on for ever. 80 digits.

Loads at end 2: an end mass of 0.04 kg; a stiffness of 310 + 95j N/m. All inputs are doubles, used exactly.
"""


import flint
import mpmath
from flint import acb, acb_mat, arb
from mpmath import mp, mpc, mpf

from golden import SCIENCE
from springs import S_A, S_T

flint.ctx.prec = 512
mp.dps = 80
END_MASS = 0.04
LOAD = (310.0, 95.0)
EACH = [0.01, 0.02, 0.005, 0.03, 0.015, 0.007]  # cycled over the modes of a chain; the wave takes these six

DAMPINGS = [
    ("none", 0.0),
    ("modal", 0.005),
    ("modal", 1.3),
    ("each", 0.0),
    ("mass", 12.5),
    ("mass", 2000.0),
    ("stiffness", 3e-5),
    ("stiffness", 0.002),
    ("hysteretic", 0.04),
]
COUNTS = [(S_T, 52), (S_T, 1), (S_T, 2), (S_T, 3), (S_A, 25), (S_T, 0)]
RADIANS = [0.0628, 17.0, 169.0, 339.6, 1234.5, 5431.0, 11245.0, 20001.0]


def number(value):
    """A double or mpf as a ball."""
    return arb(value) if isinstance(value, float) else arb(mp.nstr(value, 75))


def stiffness_rows(spring, n):
    """K of the windings with both ends held, in units of k: diagonal and off-diagonal integers."""
    rows = [[0] * n for _ in range(n)]
    for i in range(n):
        rows[i][i] = n * (2 + (i == 0) + (i == n - 1))
        if i:
            rows[i][i - 1] = rows[i - 1][i] = -n
    return rows


def modal_matrix(spring, n, ratios):
    """C with the given ratio in each mode: (m/N) sum_j 2 zeta_j omega_j v_j v_j^T."""
    mass = mpf(spring.mass) / n
    matrix = mp.matrix(stiffness_rows(spring, n)) * (mpf(spring.stiffness) / mass)
    values, vectors = mp.eigsy(matrix)
    order = sorted(range(n), key=lambda j: values[j])
    scale = [2 * mpf(ratios[place]) * mp.sqrt(values[j]) for place, j in enumerate(order)]
    scaled = mp.matrix(n, n)
    for place, j in enumerate(order):
        for i in range(n):
            scaled[i, place] = vectors[i, j] * scale[place]
    plain = mp.matrix(n, n)
    for place, j in enumerate(order):
        for i in range(n):
            plain[i, place] = vectors[i, j]
    product = mass * (scaled * plain.T)
    return [[number(product[i, j]) for j in range(n)] for i in range(n)]


def damping_rows(spring, n, kind, value):
    """C [N s/m] and the dashpot's share of an end segment, as a time [s]."""
    if kind == "modal":
        return modal_matrix(spring, n, [value] * n)
    if kind == "each":
        return modal_matrix(spring, n, [EACH[j % len(EACH)] for j in range(n)])
    if kind == "mass":
        c = arb(value) * arb(spring.mass) / n
        return [[c if i == j else arb(0) for j in range(n)] for i in range(n)]
    if kind == "stiffness":
        c = arb(value) * arb(spring.stiffness)
        return [[c * entry for entry in row] for row in stiffness_rows(spring, n)]
    return [[arb(0)] * n for _ in range(n)]


class Chain:
    """The linear system over (x_1 ... x_N, u1, u2) at one frequency."""

    def __init__(self, spring, n, kind, value, dashpots, omega):
        self.n = n
        w = arb(omega)
        k = acb(arb(spring.stiffness), arb(spring.stiffness) * arb(value) if kind == "hysteretic" else 0)
        share = acb(0, w * arb(value)) if kind == "stiffness" else acb(0)
        line = [(acb(1) - (acb(i) + acb(0.5)) / n, (acb(i) + acb(0.5)) / n) for i in range(n)]
        rows = []
        springs = stiffness_rows(spring, n)
        for i in range(n):
            row = [k * springs[i][j] + acb(0, w * dashpots[i][j]) for j in range(n)] + [acb(0), acb(0)]
            row[i] -= w * w * arb(spring.mass) / n
            for end in (0, 1):
                row[n + end] -= sum((acb(0, w * dashpots[i][j]) * line[j][end] for j in range(n)), acb(0))
            if i == 0:
                row[n] -= 2 * n * k
            if i == n - 1:
                row[n + 1] -= 2 * n * k
            rows.append(row)
        self.rows = rows
        elastic, extra = 2 * n * k, 2 * n * k * share
        f_i, f_o = [acb(0)] * (n + 2), [acb(0)] * (n + 2)
        f_i[0] += elastic + extra
        f_i[n] -= elastic
        f_o[n + 1] += elastic
        f_o[n - 1] -= elastic + extra
        for end in (0, 1):
            f_i[n + end] -= extra * line[0][end]
            f_o[n + end] += extra * line[n - 1][end]
        self.f_i, self.f_o = f_i, f_o

    def solve(self, first, second, values):
        """State with two further equations `first`, `second` over all unknowns."""
        size = self.n + 2
        matrix = acb_mat(size, size, [entry for row in self.rows + [first, second] for entry in row])
        right = acb_mat(size, 1, [acb(0)] * self.n + [acb(v) for v in values])
        return matrix.solve(right)

    def unit(self, at):
        row = [acb(0)] * (self.n + 2)
        row[self.n + at] = acb(1)
        return row

    @staticmethod
    def value(row, state):
        return sum((entry * state[i, 0] for i, entry in enumerate(row)), acb(0))

    def stiffness(self):
        """drive, transfer; the mirrored pair must be the same."""
        by2 = self.solve(self.unit(0), self.unit(1), (0, 1))
        by1 = self.solve(self.unit(0), self.unit(1), (1, 0))
        drive, transfer = self.value(self.f_o, by2), self.value(self.f_i, by2)
        for ours, mirrored in ((drive, -self.value(self.f_i, by1)), (transfer, -self.value(self.f_o, by1))):
            assert abs(ours - mirrored) < arb("1e-60") * (abs(ours) + 1)
        return drive, transfer

    def loaded(self, load):
        """F_o/F_i and U2/U1 with F_o = -load U2 at end 2 (None: held), a unit force at end 1."""
        second = self.unit(1) if load is None else [a + load * b for a, b in zip(self.f_o, self.unit(1))]
        state = self.solve(self.f_i, second, (1, 0))
        return self.value(self.f_o, state), state[self.n + 1, 0] / state[self.n, 0]


def to_mp(value):
    """A ball as mpc, its radius checked."""
    parts = []
    for part in (value.real, value.imag):
        assert part.rad() < arb("1e-44") * (abs(value) + arb("1e-30")), part
        parts.append(mpf(part.mid().str(70, radius=False)))
    return mpc(*parts)


def chain_row(spring, n, kind, value, dashpots, omega):
    system = Chain(spring, n, kind, value, dashpots, omega)
    drive, transfer = system.stiffness()
    k = acb(arb(spring.stiffness), arb(spring.stiffness) * arb(value) if kind == "hysteretic" else 0)
    clamped, _ = system.loaded(None)
    by_mass, follow = system.loaded(acb(-arb(END_MASS) * arb(omega) ** 2))
    by_load, _ = system.loaded(acb(*map(arb, LOAD)))
    return [to_mp(v) for v in (drive, transfer, drive - k, transfer - k, clamped, by_mass, by_load, follow)]


def wave_sums(kind, value, x):
    """sum over odd and even modes of 1/(n^2 + 2j zeta_n x n - x^2)."""

    def poles(ratio):
        root = mp.sqrt(mpc(1 - mpf(ratio) ** 2))
        return x * (-1j * mpf(ratio) + root), x * (-1j * mpf(ratio) - root)

    ratios = [value] if kind == "modal" else EACH
    sums = [mpc(0), mpc(0)]
    for mode, ratio in enumerate(ratios, 1):
        sums[(mode + 1) % 2] += 1 / (mode**2 + 2j * mpf(ratio) * x * mode - x * x)
    a, b = poles(ratios[-1])
    for at, first in ((0, 1), (1, 2)):
        while first <= len(ratios):
            first += 2
        # sum_{i>=0} 1/((first + 2i - a)(first + 2i - b))
        sums[at] += (mp.digamma((first - b) / 2) - mp.digamma((first - a) / 2)) / (2 * (a - b))
    return sums


def wave_row(spring, kind, value, omega):
    k, m, w = mpf(spring.stiffness), mpf(spring.mass), mpf(omega)
    if kind == "hysteretic":
        k = k * mpc(1, mpf(value))
    if kind in ("modal", "each"):
        tau = mp.sqrt(m / k)
        odd, even = wave_sums(kind, value, w * tau / mp.pi)
        scale = 4 * m * w * w / mp.pi**2
        drive, transfer = k - scale * (odd + even) / 2, k + scale * (odd - even) / 2
    else:
        alpha = mpf(value) if kind == "mass" else mpf(0)
        beta = mpf(value) if kind == "stiffness" else mpf(0)
        # -m w^2 u + j w alpha m (u - L) = k u'' + j w beta k (u - L)'', L = x (end 2 moves): u = c x + A e^(gx) + B e^(-gx)
        share = 1 + 1j * w * beta
        g = mp.sqrt((-m * w * w + 1j * w * alpha * m) / (k * share))
        c = 1j * w * alpha * m / (-m * w * w + 1j * w * alpha * m)
        wave = (1 - c) / (2 * mp.sinh(g))  # A = wave, B = -wave: u(0) = 0, u(1) = 1
        slope = lambda x: c + wave * g * 2 * mp.cosh(g * x)
        force = lambda x: k * slope(x) + 1j * w * beta * k * (slope(x) - 1)
        drive, transfer = force(1), force(0)
    mass, load = -mpf(END_MASS) * w * w, mpc(*LOAD)
    through = lambda z: z * transfer / (z * drive + drive**2 - transfer**2)
    follow = transfer / (drive + mass)
    return [drive, transfer, drive - k, transfer - k, transfer / drive, through(mass), through(load), follow]


NAMES = ["drive [N/m]", "transfer [N/m]", "drive less static [N/m]", "transfer less static [N/m]"]
NAMES += ["F_o/F_i held [-]", "F_o/F_i end mass [-]", "F_o/F_i load [-]", "U2/U1 end mass [-]"]


def main():
    header = ["spring", "windings", "damping", "value", "omega [rad/s]"]
    header += [f"{part} {name}" for name in NAMES for part in ("re", "im")]
    lines = [
        f"# python-flint {flint.__version__} (Arb, 512 bits) mpmath {mpmath.__version__}; 25 digits; reference/two_port.py; "
        "LU of the windings' equations, no dispersion relation; windings 0 is the continuous coil; value in 1, 1/s or s",
        ",".join(header),
    ]
    for spring, n in COUNTS:
        for kind, value in DAMPINGS:
            dashpots = damping_rows(spring, n, kind, value) if n else None
            for omega in RADIANS:
                if n:
                    answers = chain_row(spring, n, kind, value, dashpots, omega)
                else:
                    answers = wave_row(spring, kind, value, omega)
                shown = [mp.nstr(part, 25) for answer in map(mpc, answers) for part in (answer.real, answer.imag)]
                lines.append(",".join([spring.name, str(n), kind, repr(value), repr(omega), *shown]))
    (SCIENCE / "two_port.csv").write_text("\n".join(lines) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
