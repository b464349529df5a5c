"""Reference inductances: eqs. (8) to (11) of the paper.

Single rings in mpmath, eq. (8) as printed with enough digits for its cancellation; Maxwell's sum, which needs a million
rings, in 80-bit floats by the arithmetic-geometric mean, checked against mpmath on every run.
mu0 = 4 pi 1e-7 H/m exactly, as in reference/.
"""

import mpmath
import numpy as np
from mpmath import mp

mp.dps = 50
LONG = np.longdouble
PI = LONG("3.14159265358979323846264338327950288")


def exact(ratio):
    """M / (mu0 r) at h/r = `ratio` (mpf): eq. (8) with 50 digits left after losing (h/r)^4."""
    with mp.workdps(50 + max(0, int(5 * mpmath.log10(ratio)))):
        m = 4 / (4 + ratio**2)
        kappa = mp.sqrt(m)
        return -((kappa - 2 / kappa) * mp.ellipk(m) + 2 / kappa * mp.ellipe(m))


def reduced_mutual(distances, radius):
    """M / (mu0 r) of distances [m], rounded to double."""
    return np.array([float(exact(mp.mpf(float(h)) / mp.mpf(radius))) for h in distances])


def by_mean(distance, radius):
    """M / (mu0 r) = pi / (4 r agm(S, h)) sum 2^n c_n^2 with S = sqrt(4r^2 + h^2), c_1 = 2r^2/(S + h); 80-bit floats."""
    s = np.sqrt(4 * radius**2 + distance**2)
    c = 2 * radius**2 / (s + distance)
    a, b = (s + distance) / 2, np.sqrt(s * distance)
    total, weight = 2 * c * c, 2
    for _ in range(6):  # quadratic: the last c is below 1e-20 for all distances of a coil
        c = c * c / (4 * ((a + b) / 2))
        a, b = (a + b) / 2, np.sqrt(a * b)
        weight *= 2
        total = total + weight * c * c
    return PI / (4 * radius * a) * total


def of_rows(job, rows):
    """L [H] of every row of winding positions [m]."""
    radius = LONG(job["spring"]["coil_radius"])
    own = LONG(job["self_distance"])
    for h in (float(own), 1e-5, 4.4e-3, 0.1, 0.3):
        truth = exact(mp.mpf(h) / mp.mpf(float(radius)))
        assert abs(float(by_mean(LONG(h), radius) / LONG(mp.nstr(truth, 25)) - 1)) < 3e-18, h
    mu0 = 4 * PI / LONG(10) ** 7
    first, second = np.triu_indices(rows.shape[1], 1)
    exact_rows = rows.astype(LONG)
    sums = [by_mean(np.abs(row[second] - row[first]), radius).sum() for row in exact_rows]
    total = rows.shape[1] * by_mean(own, radius) + 2 * np.array(sums)
    return (mu0 * radius * total).astype(float)
