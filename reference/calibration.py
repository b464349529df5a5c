"""alpha and beta of the inductance calibration 1/l = alpha L + beta, eq. (13).

Least squares in 1/l over 101 lengths equally spaced over [l_min, l_max], windings uniform, with the constraint that
the fit meets the preload length exactly (section III-C of the paper). L by eqs. (8) to (11).

The last column is the largest |F_L - F_x| = k |1/(alpha L + beta) - l| over the 101 lengths.

Route: the constrained problem as its Karush-Kuhn-Tucker system in (alpha, beta, multiplier), solved at 100 digits;
L as the sum over the N - 1 pitches of a uniform coil, eqs. (8) and (9) as printed. l_min, l_max, the middle
0.5 (l_min + l_max) and Table I are exact doubles, the 101 lengths exact divisions between them.
"""


import mpmath
from mpmath import mp

from maxwell_sum import mutual
from golden import SCIENCE
from springs import SPRINGS

mp.dps = 100
COUNT = 101
SELF_FACTORS = {"as printed": mp.mpf(1) / 2, "geometric mean": mp.one}


def uniform_inductance(spring, length, self_factor):
    """L [H] of N windings at (i - 1/2) l/N, eq. (11): 2 (N - d) pairs lie d pitches apart."""
    n, radius = spring.windings, mp.mpf(spring.radius)
    own = mutual(radius, self_factor * mp.mpf(spring.wire_radius) * mp.exp(-mp.mpf(1) / 4))
    return n * own + mp.fsum(2 * (n - d) * mutual(radius, d * length / n) for d in range(1, n))


def constrained_fit(spring, self_factor, preload, lengths, inductances):
    """alpha [1/(H m)] and beta [1/m], exact at the preload length."""
    scale = mp.mpf(10) ** 6  # microhenries inside the system, for its condition
    level = [scale * value for value in inductances]
    at_preload = scale * uniform_inductance(spring, preload, self_factor)
    inverse = [1 / length for length in lengths]
    system = mp.matrix(
        [
            [2 * mp.fsum(v * v for v in level), 2 * mp.fsum(level), at_preload],
            [2 * mp.fsum(level), 2 * len(level), 1],
            [at_preload, 1, 0],
        ]
    )
    right = mp.matrix([2 * mp.fsum(a * b for a, b in zip(level, inverse)), 2 * mp.fsum(inverse), 1 / preload])
    alpha, beta, _ = mp.lu_solve(system, right)
    return alpha * scale, beta


def main():
    rows = []
    for spring in SPRINGS:
        first, last = mp.mpf(spring.shortest), mp.mpf(spring.longest)
        lengths = [first + (last - first) * i / (COUNT - 1) for i in range(COUNT)]
        for kind, factor in SELF_FACTORS.items():
            inductances = [uniform_inductance(spring, length, factor) for length in lengths]
            for name in ("shortest", "middle", "longest"):
                preload = getattr(spring, name)
                alpha, beta = constrained_fit(spring, factor, mp.mpf(preload), lengths, inductances)
                misfits = [1 / (alpha * level + beta) - x for level, x in zip(inductances, lengths)]
                worst = mp.mpf(spring.stiffness) * max(map(abs, misfits))
                numbers = [mp.nstr(v, 40, strip_zeros=False) for v in (alpha, beta, worst)]
                rows.append(",".join([spring.name, kind, repr(preload), *numbers]))
    header = [
        f"# mpmath {mpmath.__version__}; 40 digits; reference/calibration.py;"
        " constrained least squares of eq. 13 by its KKT system; uniform windings at 101 lengths from l_min to l_max",
        "spring,self distance,preload length [m],alpha [1/(H m)],beta [1/m],largest |F_L - F_x| [N]",
    ]
    (SCIENCE / "calibration.csv").write_text("\n".join(header + rows) + "\n", encoding="utf-8", newline="\n")


if __name__ == "__main__":
    main()
