"""Roots of beta tan(beta) = m/M: the continuous coil with an end mass.

Here: the roots alone, without unit. Next door: two_port.py, which knows no modes.

Route: with mode j, beta = (j - 1) pi + x and x in (0, pi/2), the equation reads x = atan2(m/M, beta): bisection on
beta sin(x) - (m/M) cos(x), which is monotonic in x, at 80 digits. Checked against the equation as printed.

m/M is a double, written with repr(); the roots are those of that double exactly.
"""


import mpmath
from mpmath import mp

from golden import SCIENCE

mp.dps = 80
RATIOS = sorted({float(f"1e{p}") for p in range(-9, 10)} | {1 / 3, 0.5, 2.0, 3.0, 65.0 / 760.0})
MODES = (1, 2, 3, 10, 100, 1000)


def root(ratio, mode):
    """beta_j, by bisection to the working precision."""
    base = (mode - 1) * mp.pi
    low, high = mp.zero, mp.pi / 2
    for _ in range(int(mp.prec) + 40):
        x = (low + high) / 2
        if (base + x) * mp.sin(x) < ratio * mp.cos(x):
            low = x
        else:
            high = x
    return base + (low + high) / 2


def main():
    rows = []
    for ratio in RATIOS:
        for mode in MODES:
            beta = root(mp.mpf(ratio), mode)
            assert abs(beta * mp.tan(beta) / mp.mpf(ratio) - 1) < mp.mpf(10) ** -40, (ratio, mode)
            rows.append(f"{ratio!r},{mode},{mp.nstr(beta, 40)}")
    head = f"# mpmath {mpmath.__version__}; 40 digits; reference/continuous_modes.py; bisection"
    text = "\n".join([head, "mass ratio [-],mode,beta [-]", *rows]) + "\n"
    (SCIENCE / "continuous_modes.csv").write_text(text)


if __name__ == "__main__":
    main()
