"""Rosa's mutual correction k_m of a single-layer coil of round wire, for whole numbers of turns.

    k_m = (2/N) sum_{i=1}^{N-1} (N - i) (ln i - ln R_i)

R_i is the geometric mean distance of two strips of width 1 in one plane whose centres are i apart. Route: Maxwell's closed form

    ln R_i = ((i+1)^2 ln(i+1) - 2 i^2 ln i + (i-1)^2 ln(i-1)) / 2 - 3/2

at 60 digits. It is checked below against the double integral that defines it, and k_m against its limit ln 2 pi - 3/2.
"""


import mpmath
from mpmath import mp

from golden import SCIENCE

mp.dps = 60


def log_distance(i):
    """ln R_i."""
    i = mp.mpf(i)
    inner = (i - 1) ** 2 * mp.log(i - 1) if i > 1 else mp.mpf(0)
    return ((i + 1) ** 2 * mp.log(i + 1) - 2 * i**2 * mp.log(i) + inner) / 2 - mp.mpf(3) / 2


def correction(turns):
    terms = ((turns - i) * (mp.log(i) - log_distance(i)) for i in range(1, turns))
    return mp.mpf(2) / turns * mp.fsum(terms)


def check():
    for i in (1, 2, 7):
        # Points x and y of two strips are |i + t| apart, t = x - y on (-1, 1) with density 1 - |t|.
        by_integral = mp.quad(lambda t, i=i: (1 - abs(t)) * mp.log(abs(i + t)), [-1, 0, 1])
        assert abs(by_integral - log_distance(i)) < mp.mpf(10) ** -40, i
    assert abs(correction(20000) - (mp.log(2 * mp.pi) - mp.mpf(3) / 2)) < mp.mpf(10) ** -3


def main():
    check()
    lines = [
        f"# mpmath {mpmath.__version__}; 40 digits; reference/round_wire.py; Rosa's sum of geometric mean distances at 60 digits,"
        " distances checked by their integral to 1e-40",
        "turns [-],k_m [-]",
    ]
    for turns in [1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 12, 15, 20, 25, 30, 39, 42, 50, 52, 75, 100, 200, 500, 1000]:
        lines.append(f"{turns},{mp.nstr(correction(turns), 40, strip_zeros=False)}")
    (SCIENCE / "round_wire.csv").write_text("\n".join(lines) + "\n", encoding="utf-8", newline="\n")


if __name__ == "__main__":
    main()
