"""Polynomials P and Q of degree 10 with D(c) = P(c) - Q(c) ln(c), c = 1 - m in (0, 1], D = (K - E)/m.

D is all that the mutual inductance of two equal loops needs: eqs. (8) and (9) are M = 2 mu0 r y^3 D(c) with
S = sqrt(4 r^2 + h^2), y = 2r/(S + h), c = 4hS/(S + h)^2 (Landen's transformation). As c -> 0,
D -> (ln 4 - 1) - ln(c)/2, so P(0) = ln 4 - 1 and Q(0) = 1/2 are kept.

Route: Remez exchange on the relative error over c in [1e-12, 1] at 60 digits (the functions c^k, c^k ln c form a
Chebyshev system), D from mpmath's ellipk and ellipe. The coefficients are rounded to double from the lowest degree
up, and after each pair the remaining ones are fitted again, so that they take up the rounding.

The script prints the relative errors and asserts them: of the rounded polynomials in exact arithmetic, and of their
evaluation in doubles by Horner's rule with and without fused multiply-add, over 100 000 points.
"""

import sys

import gmpy2
import mpmath
import numpy as np
from mpmath import mp

from golden import SCIENCE

mp.dps = 60
SMALLEST = mp.mpf(10) ** -12


def d_of(c):
    """D = (K - E)/m at m = 1 - c; at 100 digits because K - E cancels near c = 1."""
    with mp.workdps(100):
        m = 1 - mp.mpf(c)
        return (mp.ellipk(m) - mp.ellipe(m)) / m if m else mp.pi / 4


def fit_points(count):
    """Points of [1e-12, 1] on which the error is searched: c = s^6, s from small to 1, crowding towards 1."""
    first = SMALLEST ** (mp.mpf(1) / 6)
    angles = [mp.pi * i / (2 * (count - 1)) for i in range(count)]
    return [(first + (1 - first) * mp.sin(a)) ** 6 for a in angles[:-1]] + [mp.one]


class Fit:
    """Relative minimax fit of D over fixed points; `known` maps (is_q, degree) to fixed coefficients."""

    def __init__(self, degree, count=3000):
        self.degree = degree
        self.points = fit_points(count)
        self.d = np.array([d_of(c) for c in self.points], dtype=object)
        self.columns = {}
        for is_q in (False, True):
            for power in range(degree + 1):
                factors = [-mp.log(c) if is_q else mp.one for c in self.points]
                column = [f * c**power for f, c in zip(factors, self.points)]
                self.columns[is_q, power] = np.array(column, dtype=object) / self.d

    def error(self, coefficients):
        """Relative error (fit - D)/D at all points."""
        return sum(v * self.columns[key] for key, v in coefficients.items()) - 1

    def remez(self, known):
        """All coefficients, those in `known` fixed; the others by the exchange of extrema."""
        free = [key for key in self.columns if key not in known]
        rest = 1 - sum(v * self.columns[key] for key, v in known.items())
        count = len(free) + 1
        last = len(self.points) - 1
        nodes = [round(last * (i + 1) / count) for i in range(count)]
        for _ in range(60):
            matrix = mp.matrix(count, count)
            right = mp.matrix(count, 1)
            for row, node in enumerate(nodes):
                for col, key in enumerate(free):
                    matrix[row, col] = self.columns[key][node]
                matrix[row, count - 1] = (-1) ** row
                right[row] = rest[node]
            solution = mp.lu_solve(matrix, right)
            coefficients = dict(known) | {key: solution[i] for i, key in enumerate(free)}
            error = self.error(coefficients)
            level = abs(solution[count - 1])
            nodes = alternating_extrema(error, count)
            if max(abs(error)) < level * mp.mpf("1.001"):
                return coefficients
        return coefficients


def alternating_extrema(error, count):
    """Indices of `count` extrema of alternating sign, the largest ones kept."""
    groups = []
    for i, value in enumerate(error):
        if groups and (value > 0) == (error[groups[-1]] > 0):
            if abs(value) > abs(error[groups[-1]]):
                groups[-1] = i
        else:
            groups.append(i)
    if len(groups) < count:
        raise ValueError(f"error has {len(groups)} alternations, {count} are needed")
    while len(groups) > count:
        if len(groups) == count + 1:
            groups.pop(0 if abs(error[groups[0]]) < abs(error[groups[-1]]) else -1)
        else:
            weakest = min(range(len(groups) - 1), key=lambda i: max(abs(error[groups[i]]), abs(error[groups[i + 1]])))
            del groups[weakest : weakest + 2]
    return groups


def rounded_fit(fit):
    """Coefficients as doubles, the lowest degrees rounded first and the rest fitted again."""
    start = {(False, 0): mp.log(4) - 1, (True, 0): mp.mpf(1) / 2}
    ideal = fit.remez(start)
    known = {}
    for power in range(fit.degree + 1):
        source = ideal if power == 0 else fit.remez(known)
        for is_q in (False, True):
            known[is_q, power] = mp.mpf(float(source[is_q, power]))
    return ideal, known


def horner(coefficients, x):
    total = np.full_like(x, coefficients[-1])
    for value in coefficients[-2::-1]:
        total = total * x + value
    return total


def in_doubles(p, q, c):
    """P(c) - Q(c) ln c, plain doubles."""
    return horner(p, c) - horner(q, c) * np.log(c)


def with_fma(p, q, c):
    """The same with every multiply-add fused (gmpy2 at 53 bits rounds as IEEE double does)."""
    with gmpy2.context(gmpy2.get_context(), precision=53):
        result = []
        for x in map(gmpy2.mpfr, c.tolist()):
            log = gmpy2.mpfr(float(np.log(float(x))))
            totals = []
            for values in (p, q):
                total = gmpy2.mpfr(values[-1])
                for value in values[-2::-1]:
                    total = gmpy2.fma(total, x, gmpy2.mpfr(value))
                totals.append(total)
            result.append(float(gmpy2.fma(-totals[1], log, totals[0])))
    return np.array(result)


def evaluation_errors(p, q, count=100_000):
    """Largest relative errors of the three evaluations over `count` doubles of [1e-12, 1], half log-spaced."""
    c = np.unique(np.concatenate([10.0 ** np.linspace(-12, 0, count // 2), np.linspace(1e-5, 1, count // 2)]))
    mp.dps = 40
    exact = [mp.elliprd(0, mp.mpf(x), 1) / 3 for x in c.tolist()]  # another route to D than the fit's
    ours = []
    for x in c.tolist():
        x = mp.mpf(x)
        ours.append(mp.polyval(p[::-1], x) - mp.polyval(q[::-1], x) * mp.log(x))
    mp.dps = 60
    return [
        max((abs(a / b - 1), x) for a, b, x in zip(map(mp.mpf, values), exact, c.tolist()))
        for values in (ours, in_doubles(p, q, c).tolist(), with_fma(p, q, c).tolist())
    ]


def main(degree=10):
    fit = Fit(degree)
    ideal, rounded = rounded_fit(fit)
    p = [float(rounded[False, i]) for i in range(degree + 1)]
    q = [float(rounded[True, i]) for i in range(degree + 1)]
    print(f"degree {degree}: minimax error {mp.nstr(max(abs(fit.error(ideal))), 4)},")
    print(f"rounded coefficients {mp.nstr(max(abs(fit.error(rounded))), 4)} at the fit's points")
    errors = evaluation_errors(p, q)
    for name, (error, where) in zip(("exact arithmetic", "doubles", "doubles with fma"), errors):
        print(f"  {name}: {mp.nstr(error, 4)} at c = {where!r}")
    if degree != 10:
        return
    assert errors[0][0] < 2e-16 and errors[1][0] < 9e-16 and errors[2][0] < 9e-16
    lines = [
        f"# mpmath {mpmath.__version__}; shortest round-trip doubles; reference/elliptic_d_fit.py;"
        f" relative minimax fit of D = (K - E)/m on c in [1e-12 1], error {mp.nstr(errors[0][0], 2)} exact,"
        f" {mp.nstr(errors[1][0], 2)} in doubles by Horner",
        "degree [-],P [-],Q [-]",
    ]
    lines += [f"{i},{p[i]!r},{q[i]!r}" for i in range(degree + 1)]
    (SCIENCE / "elliptic_d_fit.csv").write_text("\n".join(lines) + "\n", encoding="utf-8", newline="\n")


if __name__ == "__main__":
    main(*map(int, sys.argv[1:]))
