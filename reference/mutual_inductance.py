"""Mutual inductance of two equal coaxial loops, M / (mu0 r) over h/r, eqs. (8) and (9).

    M = -mu0 r ((kappa - 2/kappa) K(kappa) + (2/kappa) E(kappa)),   kappa^2 = (2r)^2 / ((2r)^2 + h^2)

Route: the printed formula as it stands, at 140 digits (it cancels by up to (h/r)^4 = 1e16 here), so not the
cancellation-free forms that the program uses. Checked below against Neumann's integral

    M / (mu0 r) = 1/2 int_0^2pi cos(phi) / sqrt(2 (1 - cos(phi)) + (h/r)^2) dphi      (h/r >= 0.1)

against the limits ln(8r/h) - 2 and (pi/2)(r/h)^3, and against four values of an earlier 40-digit computation.

h/r is a double, written with repr(); the formula uses that double exactly. With mu0 = 4 pi 1e-7 H/m exactly.
"""


import mpmath
from mpmath import mp

from golden import SCIENCE

mp.dps = 140

EARLIER = {
    "0.1": "2.3896130361380605929",
    "1": "0.39317514837200473104",
    "10": "0.0015250985222542957704",
    "100": "1.5703252351109243798e-6",
}


def distances():
    """h/r as doubles: 1e-5 to 1e4 log-spaced, and a few marks."""
    spread = [float(mp.mpf(10) ** (mp.mpf(-5) + mp.mpf(9 * i) / 190)) for i in range(191)]
    return sorted(set(spread + [1e-7, 1e-6, 1e-3, 1e-2, 0.1, 0.5, 1.0, 2.0, 5.0, 10.0, 100.0, 1000.0]))


def by_equation_8(ratio):
    """M / (mu0 r) at h/r = ratio, eqs. (8) and (9)."""
    kappa = 2 / mp.sqrt(4 + mp.mpf(ratio) ** 2)
    m = kappa**2
    return -((kappa - 2 / kappa) * mp.ellipk(m) + 2 / kappa * mp.ellipe(m))


def by_neumann(ratio):
    """The same by Neumann's integral, with the trapezoidal rule (the integrand is periodic and analytic)."""
    reach = mp.asinh(mp.mpf(ratio) / 2) * 2  # half width of the strip of analyticity
    points = int(45 * mp.log(10) / reach) + 100
    angles = (2 * mp.pi * i / points for i in range(points))
    total = mp.fsum(mp.cos(a) / mp.sqrt(2 * (1 - mp.cos(a)) + mp.mpf(ratio) ** 2) for a in angles)
    return mp.pi / points * total


def check(ratio, value):
    if 0.1 <= ratio <= 100:
        with mp.workdps(60):
            assert abs(by_neumann(ratio) / value - 1) < mp.mpf(10) ** -35, ratio
    h = mp.mpf(ratio)
    if ratio < 1e-4:
        assert abs(value / (mp.log(8 / h) - 2) - 1) < 2 * h**2, ratio
    if ratio > 1e3:
        assert abs(value / (mp.pi / 2 / h**3) - 1) < 4 / h**2, ratio


def main():
    lines = [
        f"# mpmath {mpmath.__version__}; 40 digits; reference/mutual_inductance.py;"
        " eqs. 8 and 9 as printed at 140 digits, checked against Neumann's integral to 1e-35;"
        " h/r is an exact double, mu0 = 4 pi 1e-7 H/m",
        "h/r [-],M/(mu0 r) [-]",
    ]
    for ratio, value in EARLIER.items():  # at the decimal 0.1, not at the double nearest to it
        assert abs(by_equation_8(ratio) / mp.mpf(value) - 1) < mp.mpf(10) ** -18, ratio
    for ratio in distances():
        value = by_equation_8(ratio)
        check(ratio, value)
        lines.append(f"{ratio!r},{mp.nstr(value, 40, strip_zeros=False)}")
    (SCIENCE / "mutual_inductance.csv").write_text("\n".join(lines) + "\n", encoding="utf-8", newline="\n")


if __name__ == "__main__":
    main()
