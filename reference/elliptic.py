"""Complete elliptic integrals K, E and D = (K - E)/m, for the loop inductance of eq. (8).

Here: the integrals alone. Next door: mutual_inductance.py (eqs. 8 and 9).

Route: the trapezoidal rule on the defining integrals, no AGM and no series. With tan(theta) = exp(t),

    K = int dx / sqrt((1 + x^2)(1 + kc^2 x^2)),                x = exp(t), over all t
    E = int sqrt(1 + kc^2 x^2) / (1 + x^2)^(3/2) dx,
    D = int x^2 / ((1 + x^2)^(3/2) sqrt(1 + kc^2 x^2)) dx,

whose integrands in t are analytic for |Im t| < pi/2, so a step s errs by about exp(-pi^2/s).
D is integrated by itself: nothing cancels at kc = 1. Checked below against mpmath's ellipk and ellipe.

kc is a double, written with repr(); the sums use that double exactly.
"""


import mpmath
from mpmath import mp

from golden import SCIENCE

mp.dps = 60
STEP = mp.mpf(1) / 16  # exp(-pi^2 * 16) = 1e-68
REACH = 140  # the integrands fall as exp(-|t|), the last one from t = -ln(kc) = 14 on


def moduli():
    """Complementary moduli as doubles: 1e-6 to 1 log-spaced, then crowding towards 1."""
    spread = [float(mp.mpf(10) ** (mp.mpf(-6) + mp.mpf(i) / 8)) for i in range(48)]
    near_one = [0.9, 0.95, 0.99, 0.999, 1 - 1e-4, 1 - 1e-6, 1 - 1e-8, 1 - 1e-10, 1 - 1e-12, 1 - 1e-14]
    near_one += [1 - 2.0**-52, 1 - 2.0**-53, 1.0]
    return sorted(spread + near_one)


def elliptic(kc):
    """(K, E, D) of the complementary modulus kc, by the trapezoidal rule in t."""
    first = second = third = mp.zero
    kc2 = mp.mpf(kc) ** 2
    ratio = mp.exp(STEP)
    x = mp.exp(-REACH)
    for _ in range(2 * REACH * 16 + 1):
        rise = mp.sqrt(1 + x * x)
        slant = mp.sqrt(1 + kc2 * x * x)
        first += x / (rise * slant)
        second += x * slant / rise**3
        third += x**3 / (rise**3 * slant)
        x *= ratio
    return first * STEP, second * STEP, third * STEP


def check(kc, values):
    """Compare with mpmath's own ellipk and ellipe, at 120 digits because K - E cancels."""
    with mp.workdps(120):
        m = 1 - mp.mpf(kc) ** 2
        k, e = mp.ellipk(m), mp.ellipe(m)
        d = (k - e) / m if m else mp.pi / 4
        for ours, theirs in zip(values, (k, e, d)):
            assert abs(ours / theirs - 1) < mp.mpf(10) ** -50, (kc, ours, theirs)


def main():
    lines = [
        f"# mpmath {mpmath.__version__}; 40 digits; reference/elliptic.py;"
        " trapezoidal rule on the defining integrals, checked against ellipk and ellipe to 1e-50;"
        " kc is an exact double, m = 1 - kc^2",
        "kc [-],K [-],E [-],D [-]",
    ]
    for kc in moduli():
        values = elliptic(kc)
        check(kc, values)
        lines.append(",".join([repr(kc)] + [mp.nstr(v, 40, strip_zeros=False) for v in values]))
    (SCIENCE / "elliptic.csv").write_text("\n".join(lines) + "\n", encoding="utf-8", newline="\n")


if __name__ == "__main__":
    main()
