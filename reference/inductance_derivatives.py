"""Derivatives of the mutual inductance of two equal coaxial loops by their distance, over h/r.

    f(q) = M / (mu0 r), q = h/r;  f', f'', f''' by q

Route: eqs. 8 and 9 as printed, differentiated by central differences with a step of 1e-40 q at 300 digits; checked to 1e-35 against
Neumann's integral f(q) = 1/2 int_0^2pi cos(phi) (2 (1 - cos(phi)) + q^2)^(-1/2) dphi differentiated under the integral sign, by the
trapezoidal rule, for q = 0.1...100. Neither is the form that the program uses.

h/r is a double, written with repr().
"""


import mpmath
from mpmath import mp
from mutual_inductance import by_equation_8

from golden import SCIENCE

DIGITS = 40


def distances():
    """h/r as doubles: 1e-5 to 1e4 log-spaced, and a few marks."""
    return sorted({float(mp.mpf(10) ** (mp.mpf(-5) + mp.mpf(9 * i) / 120)) for i in range(121)} | {0.1, 0.55, 1.0, 2.0, 10.0})


def formula(q):
    """Eqs. 8 and 9 for a working number q."""
    kappa = 2 / mp.sqrt(4 + q**2)
    m = kappa**2
    return -((kappa - 2 / kappa) * mp.ellipk(m) + 2 / kappa * mp.ellipe(m))


def by_formula(ratio):
    """f, f', f'', f''' by central differences with a step of 1e-40 q at 300 digits: error 1e-80 relative."""
    with mp.workdps(300):
        q = mp.mpf(ratio)
        step = q * mp.mpf(10) ** -40
        values = [formula(q + i * step) for i in (-2, -1, 0, 1, 2)]
        a, b, c, d, e = values
        return [c, (d - b) / (2 * step), (d - 2 * c + b) / step**2, (e - 2 * d + 2 * b - a) / (2 * step**3)]


def by_neumann(ratio):
    """The same under the integral sign, trapezoidal rule (the integrand is periodic and analytic)."""
    with mp.workdps(70):
        q = mp.mpf(ratio)
        reach = mp.asinh(q / 2) * 2
        points = int(45 * mp.log(10) / reach) + 100
        sums = [mp.mpf(0)] * 4
        for i in range(points):
            cosine = mp.cos(2 * mp.pi * i / points)
            w = 2 * (1 - cosine) + q**2
            root = mp.sqrt(w)
            sums[0] += cosine / root
            sums[1] -= cosine * q / root**3
            sums[2] += cosine * (3 * q**2 / root**5 - 1 / root**3)
            sums[3] += cosine * (9 * q / root**5 - 15 * q**3 / root**7)
        return [mp.pi / points * total for total in sums]


def main():
    lines = [
        f"# mpmath {mpmath.__version__}; 40 digits; reference/inductance_derivatives.py; eqs. 8 and 9 differentiated at 300 digits,"
        " checked against Neumann's integral to 1e-35 for h/r = 0.1...100; h/r is an exact double, q = h/r, M' = d(M/(mu0 r))/dq",
        "h/r [-],M/(mu0 r) [-],M' [-],M'' [-],M''' [-]",
    ]
    for ratio in distances():
        values = by_formula(ratio)
        assert abs(values[0] / by_equation_8(ratio) - 1) < mp.mpf(10) ** -60
        if 0.1 <= ratio <= 100:
            for ours, theirs in zip(values, by_neumann(ratio)):
                assert abs(ours / theirs - 1) < mp.mpf(10) ** -35, (ratio, ours, theirs)
        lines.append(",".join([repr(ratio)] + [mp.nstr(v, DIGITS, strip_zeros=False) for v in values]))
    (SCIENCE / "inductance_derivatives.csv").write_text("\n".join(lines) + "\n", encoding="utf-8", newline="\n")


if __name__ == "__main__":
    main()
