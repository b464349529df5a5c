"""Neumann's integral of a helix of round wire, current uniform, its two ends left open (partial inductance).

Radius r, pitch p = l/N, S^2 = r^2 + (p/2pi)^2, wire of length W = 2 pi N S, point phi at S phi along the wire. Two points phi apart
have tangents whose product is T = (r^2 cos phi + (p/2pi)^2)/S^2 and lie R = sqrt(4 r^2 sin^2(phi/2) + (p phi/2pi)^2) apart.

    geometric mean:     L = (mu0/4pi) 2 (int_0^W (W - s) (T/R - 1/s) ds + W asinh(W/g) - sqrt(W^2 + g^2) + g)
    parallel filament:  L = (mu0/4pi) int_0^W (W - s) (T(s-)/R(s-) + T(s+)/R(s+)) ds, the mutual inductance of the wire's axis and a like
                        helix on the same cylinder, g away across the wire

with g = rho e^(-1/4). Route: both by tanh-sinh quadrature over half turns at 40 digits. Checked below, at the parallel filament, by the
double sum over points of both helices (no use of the helix's symmetry) and, of few flat turns, by Maxwell's rings.

Inputs are doubles, written with repr(), used exactly; mu0 = 4 pi 1e-7 H/m exactly.
"""


import mpmath
import numpy as np
from mpmath import mp

from golden import SCIENCE

mp.dps = 40

COILS = [  # windings, r [m], rho [m], l [m]
    (41.90425531914894, 0.00847, 0.00141, 0.124),
    (41.90425531914894, 0.00847, 0.00141, 0.17),
    (38.76377952755905, 0.012545, 0.00127, 0.104),
    (38.76377952755905, 0.012545, 0.00127, 0.15),
    (52.0, 0.008, 0.001, 0.23),
    (3.3, 0.01, 0.0005, 0.02),
    (1.0, 0.05, 0.001, 0.004),
    (10.5, 0.01, 0.00002, 0.001),
    (2.25, 0.004, 0.001, 0.2),
]


class Helix:
    def __init__(self, windings, radius, wire_radius, length):
        self.windings, self.radius = mp.mpf(windings), mp.mpf(radius)
        self.advance = mp.mpf(length) / self.windings / (2 * mp.pi)  # axial, per radian
        self.along = mp.sqrt(self.radius**2 + self.advance**2)  # wire, per radian
        self.wire = 2 * mp.pi * self.windings * self.along
        self.g = mp.mpf(wire_radius) * mp.exp(-mp.mpf(1) / 4)

    def kernel(self, phi, turned=0, lifted=0):
        """T/R of two points phi apart, the second one turned and lifted."""
        angle = phi + turned
        tangents = (self.radius**2 * mp.cos(angle) + self.advance**2) / self.along**2
        distance = mp.sqrt(4 * self.radius**2 * mp.sin(angle / 2) ** 2 + (self.advance * phi + lifted) ** 2)
        return tangents / distance

    def breaks(self):
        end = 2 * mp.pi * self.windings
        marks = [mp.mpf(0), mp.pi / 16]
        half = mp.pi
        while half < end:
            marks.append(half)
            half += mp.pi
        return marks + [end]

    def integral(self, function):
        return mp.quad(lambda phi: (self.wire - self.along * phi) * function(phi) * self.along, self.breaks())

    def geometric_mean(self):
        near = lambda phi: self.kernel(phi) - 1 / (self.along * phi)
        with mp.workdps(60):  # the difference loses digits at the first points of the rule
            bent = self.integral(near)
        straight = self.wire * mp.asinh(self.wire / self.g) - mp.sqrt(self.wire**2 + self.g**2) + self.g
        return mp.mpf("1e-7") * 2 * (bent + straight)

    def offset(self):
        """Turn and lift of the parallel filament: w across the wire on the unrolled cylinder, with a chord of g."""

        def chord(w):
            turned, lifted = -w * self.advance / self.along / self.radius, w * self.radius / self.along
            return 4 * self.radius**2 * mp.sin(turned / 2) ** 2 + lifted**2 - self.g**2

        w = mp.findroot(chord, self.g)
        return -w * self.advance / self.along / self.radius, w * self.radius / self.along

    def parallel_filament(self):
        turned, lifted = self.offset()
        both = lambda phi: self.kernel(phi, turned, lifted) + self.kernel(-phi, turned, lifted)
        return mp.mpf("1e-7") * self.integral(both)

    def by_points(self, count):
        """The parallel filament by the trapezoidal rule over both wires."""
        turned, lifted = (float(value) for value in self.offset())
        r, advance = float(self.radius), float(self.advance)
        end = 2 * np.pi * float(self.windings)
        phi = np.linspace(0, end, count + 1)
        weights = np.full(count + 1, end / count)
        weights[[0, -1]] /= 2
        total = 0.0
        for one, weight in zip(phi, weights):
            other = phi + turned
            apart = 2 * r * r * (1 - np.cos(other - one)) + (advance * (phi - one) + lifted) ** 2
            total += weight * np.sum(weights * (r * r * np.cos(other - one) + advance**2) / np.sqrt(apart))
        return 1e-7 * total


def rings(windings, radius, g, pitch):
    """Maxwell's sum."""

    def mutual(h):
        m = 4 * radius**2 / (4 * radius**2 + h**2)
        kappa = mp.sqrt(m)
        return -4e-7 * mp.pi * radius * ((kappa - 2 / kappa) * mp.ellipk(m) + 2 / kappa * mp.ellipe(m))

    return windings * mutual(g) + 2 * mp.fsum((windings - i) * mutual(i * pitch) for i in range(1, windings))


def check():
    few = Helix(3.3, 0.01, 0.0005, 0.02)
    assert abs(few.by_points(12000) / float(few.parallel_filament()) - 1) < 1e-6
    ring = Helix(1, 0.01, 1e-5, 1e-7)  # one flat turn is a ring, but for the gap across its ends
    assert abs(ring.geometric_mean() / rings(1, ring.radius, ring.g, 0) - 1) < 1e-4


def main():
    check()
    lines = [
        f"# mpmath {mpmath.__version__}; 25 digits; reference/helix.py; tanh-sinh quadrature over half turns at 40 digits,"
        " checked by a double sum over points to 1e-6; inputs are exact doubles, mu0 = 4 pi 1e-7 H/m",
        "windings [-],r [m],rho [m],l [m],L geometric mean [H],L parallel filament [H]",
    ]
    for coil in COILS:
        helix = Helix(*coil)
        values = [helix.geometric_mean(), helix.parallel_filament()]
        inputs = ",".join(repr(value) for value in coil)
        lines.append(inputs + "," + ",".join(mp.nstr(value, 25, strip_zeros=False) for value in values))
        print(lines[-1], flush=True)
    (SCIENCE / "helix.csv").write_text("\n".join(lines) + "\n", encoding="utf-8", newline="\n")


if __name__ == "__main__":
    main()
