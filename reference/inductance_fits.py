"""Polynomials behind the vector kernel of `inductance`: the other elliptic integral, and the logarithm.

    B(c) = P(c) - c Q(c) ln(c),  c = 1 - m in (0, 1],  B = (E - (1 - m) K)/m          (degree 10, as `elliptic_d_fit.py` for D)
    ln((1 + z)/(1 - z)) = 2 z + z^3 R(z^2),  |z| <= 0.2021                            (degree 7)

D and B are all that the mutual inductance of two equal loops and its derivatives need: with y, c of eq. 8's Landen form,
y d/dy of y^3 D is y^3 (D + 2 B/c), and so on, sums of positive terms (see `mutual.rs`).
As c -> 0, B -> 1 + (3/4 - ln(4)/2) c + c ln(c)/4, so P(0) = 1 and Q(0) = -1/4 are kept.

|z| reaches 0.2021 because the power of two of c = n/w is taken from the difference of the bit patterns of n and w, which is the
logarithm to 0.0861 twice at most: n/w lies within 2^+-(1/2 + 0.0861) of that power, and tanh(0.5861 ln(2)/2) = 0.2004.

Route: Remez exchange at 60 digits of `elliptic_d_fit.py`, rounded from the lowest degree up. The script asserts the errors.
"""


import mpmath
import numpy as np
from elliptic_d_fit import Fit, fit_points
from mpmath import mp

from golden import SCIENCE

mp.dps = 60
DEGREE = 10
REACH = mp.mpf("0.2021")


def b_of(c):
    """B = (E - c K)/m at m = 1 - c; at 100 digits because E - c K cancels near c = 1."""
    with mp.workdps(100):
        m = 1 - mp.mpf(c)
        return (mp.ellipe(m) - c * mp.ellipk(m)) / m if m else mp.pi / 4


class FitB(Fit):
    """As `Fit`, for B: columns c^k and c^(k+1) ln c."""

    def __init__(self, degree, count=3000):
        self.degree = degree
        self.points = fit_points(count)
        target = np.array([b_of(c) for c in self.points], dtype=object)
        self.columns = {}
        for is_q in (False, True):
            for power in range(degree + 1):
                factors = [-c * mp.log(c) if is_q else mp.one for c in self.points]
                column = [f * c**power for f, c in zip(factors, self.points)]
                self.columns[is_q, power] = np.array(column, dtype=object) / target


def rounded(fit):
    """Coefficients as doubles, the lowest degrees rounded first and the rest fitted again."""
    known = {(False, 0): mp.one, (True, 0): -mp.mpf(1) / 4}
    ideal = fit.remez(known)
    for power in range(1, fit.degree + 1):
        source = fit.remez(known)
        for is_q in (False, True):
            known[is_q, power] = mp.mpf(float(source[is_q, power]))
    return ideal, known


def logarithm(degree=7):
    """Coefficients of R, by interpolation at Chebyshev's points of z^2 in [0, REACH^2]."""

    def r(x):
        return mp.nsum(lambda n: 2 * x**n / (2 * n + 3), [0, mp.inf])

    half = REACH**2 / 2
    points = [half * (1 + mp.cos(mp.pi * (2 * i + 1) / (2 * degree + 2))) for i in range(degree + 1)]
    matrix = mp.matrix([[x**n for n in range(degree + 1)] for x in points])
    values = mp.lu_solve(matrix, mp.matrix([r(x) for x in points]))
    values = [float(v) for v in values]
    worst = mp.mpf(0)
    for i in range(1, 400):
        z = REACH * i / 400
        ours = 2 * z + z**3 * mp.polyval([mp.mpf(v) for v in values[::-1]], z**2)
        worst = max(worst, abs(ours - mp.log((1 + z) / (1 - z))))
    return values, worst


def main():
    logs, log_error = logarithm()
    print("logarithm: absolute error", mp.nstr(log_error, 3))
    assert log_error < mp.mpf("1e-18")
    fit = FitB(DEGREE)
    ideal, known = rounded(fit)
    error = max(abs(fit.error(known)))
    print("B: relative error", mp.nstr(max(abs(fit.error(ideal))), 3), "rounded", mp.nstr(error, 3))
    assert error < mp.mpf("1e-16")
    p = [float(known[False, i]) for i in range(DEGREE + 1)]
    q = [float(known[True, i]) for i in range(DEGREE + 1)]
    lines = [
        f"# mpmath {mpmath.__version__}; shortest round-trip doubles; reference/inductance_fits.py; relative minimax fit of"
        f" B = (E - c K)/m on c in [1e-12 1], error {mp.nstr(error, 2)} exact; R of the logarithm for |z| <= 0.2021,"
        f" absolute error {mp.nstr(log_error, 2)}",
        "degree [-],P [-],Q [-],R [-]",
    ]
    for i in range(DEGREE + 1):
        lines.append(f"{i},{p[i]!r},{q[i]!r},{logs[i]!r}" if i < len(logs) else f"{i},{p[i]!r},{q[i]!r},")
    (SCIENCE / "inductance_fits.csv").write_text("\n".join(lines) + "\n", encoding="utf-8", newline="\n")


if __name__ == "__main__":
    main()
