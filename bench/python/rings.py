"""SciPy: eqs. (8) to (11) on whole arrays.

With `ellipkm1` near rings keep their digits; Carlson's R_D loses none, near or far.
"""

import numpy as np
from scipy.special import ellipe, ellipkm1, elliprd

MU0 = 4e-7 * np.pi


def mutual(radius, distance):
    """M [H], eq. (8) as printed."""
    square = distance * distance
    whole = 4 * radius**2 + square
    m = 4 * radius**2 / whole
    kappa = np.sqrt(m)
    return -MU0 * radius * ((kappa - 2 / kappa) * ellipkm1(square / whole) + 2 / kappa * ellipe(m))


def mutual_carlson(radius, distance):
    """M [H], eq. (8) after a Landen step.

    2 mu0 r y^3 R_D(0, c, 1)/3 with S = sqrt(4r^2 + h^2), y = 2r/(S + h), c = 4hS/(S + h)^2.
    """
    s = np.sqrt(4 * radius**2 + distance * distance)
    y = 2 * radius / (s + distance)
    return 2 / 3 * MU0 * radius * y**3 * elliprd(0.0, 4 * distance * s / (s + distance) ** 2, 1.0)


# setting of a row, its kernel
KERNELS = {"eq. 8, ellipkm1 and ellipe": mutual, "elliprd, no cancellation": mutual_carlson}


def inductance(job, kernel):
    """L [H] of every row, some rows at a time so that the arrays stay in the cache."""
    n, radius = job["spring"]["windings"], job["spring"]["coil_radius"]
    rows = job["positions"].reshape(job["steps"], n)
    first, second = np.triu_indices(n, 1)
    own = n * kernel(radius, job["self_distance"])
    chunks = (rows[at : at + 20] for at in range(0, len(rows), 20))
    return np.concatenate([own + 2 * kernel(radius, c[:, second] - c[:, first]).sum(axis=1) for c in chunks])
