"""Nagaoka's coefficient K_L over length/diameter of a cylindrical current sheet.

    K_L = 4 / (3 pi k') ((k'^2/k^2) (K - E) + E - k),   k^2 = d^2 / (d^2 + l^2),  k'^2 = l^2 / (d^2 + l^2)

Route: the classical formula as it stands, at 120 digits (it cancels by up to (l/d)^2 = 1e12 for long coils and by d/l for
short ones), so not the forms that the program uses. Checked below by the double integral of the mutual inductance of two
rings over the sheet,

    K_L = (2 / (pi r l)) int_0^l (l - h) M(h) / (mu0 r) dh,

and by the limits 1 - 4d/(3 pi l) + d^2/(8 l^2) (long) and (2 l / (pi d)) (ln(4 d/l) - 1/2) (short).

l/d is a double, written with repr(); the formula uses that double exactly.
"""


import mpmath
from mpmath import mp

from golden import SCIENCE

mp.dps = 120


def ratios():
    """l/d as doubles: 1e-6 to 1e6 log-spaced, and a few marks."""
    spread = [float(mp.mpf(10) ** (mp.mpf(-6) + mp.mpf(12 * i) / 180)) for i in range(181)]
    return sorted(set(spread + [0.1, 0.5, 0.75, 1.0, 2.0, 5.0, 10.0, 100.0]))


def coefficient(ratio):
    """K_L at l/d = ratio."""
    u = mp.mpf(ratio)
    kc2 = u**2 / (1 + u**2)
    m = 1 / (1 + u**2)
    k, kc = mp.sqrt(m), mp.sqrt(kc2)
    big_k, big_e = mp.ellipk(m), mp.ellipe(m)
    return 4 / (3 * mp.pi * kc) * (kc2 / m * (big_k - big_e) + big_e - k)


def by_rings(ratio):
    """The same by summing rings; r = 1, l = 2 ratio."""
    length = 2 * mp.mpf(ratio)

    def mutual(h):
        m = 4 / (4 + h**2)
        kappa = mp.sqrt(m)
        big_k = mp.pi / 2 / mp.agm(1, h / mp.sqrt(4 + h**2))  # m rounds to 1 at the first points of the rule
        return -((kappa - 2 / kappa) * big_k + 2 / kappa * mp.ellipe(m))

    # mutual(h) has a logarithm at h = 0, which tanh-sinh takes.
    total = mp.quad(lambda h: (length - h) * mutual(h), [0, length / 8, length / 2, length])
    return 2 / (mp.pi * length) * total


def check(ratio, value):
    u = mp.mpf(ratio)
    if ratio in (0.1, 0.5, 1.0, 2.0, 5.0):
        with mp.workdps(110):
            assert abs(by_rings(ratio) / value - 1) < mp.mpf(10) ** -35, ratio
    if ratio > 1e3:
        assert abs(value - (1 - 4 / (3 * mp.pi * u) + 1 / (8 * u**2))) < u**-4, ratio
    if ratio < 1e-3:
        assert abs(value / (2 * u / mp.pi * (mp.log(4 / u) - mp.mpf(1) / 2)) - 1) < u**2, ratio


def main():
    lines = [
        f"# mpmath {mpmath.__version__}; 40 digits; reference/nagaoka.py; the classical formula at 120 digits,"
        " checked by the integral over rings to 1e-35; l/d is an exact double",
        "l/d [-],K_L [-]",
    ]
    for ratio in ratios():
        value = coefficient(ratio)
        check(ratio, value)
        lines.append(f"{ratio!r},{mp.nstr(value, 40, strip_zeros=False)}")
    (SCIENCE / "nagaoka.csv").write_text("\n".join(lines) + "\n", encoding="utf-8", newline="\n")


if __name__ == "__main__":
    main()
