"""Inductance of a coil with given winding positions by Maxwell's summation, eqs. (8) to (11).

Writes maxwell_sum.csv (the inductances) and maxwell_sum_positions.csv (the positions, as doubles).

    L = sum over all i and j of M(|x_i - x_j|),  M(0) taken at the self distance h_11

with h_11 = 1/2 rho exp(-1/4) as printed in eq. (10), and h_11 = rho exp(-1/4), the geometric mean distance of a
round wire. mu0 = 4 pi 1e-7 H/m exactly.

Positions: x_i = l (i - 1/2)/N + A (l/N) sin(w (i - 1/2)), rounded to double; those doubles are used exactly.

Route: eqs. (8) and (9) as printed at 100 digits, every pair by itself.
"""


import mpmath
from mpmath import mp

from golden import SCIENCE
from springs import S_A, S_T, SPRINGS

mp.dps = 100
FOLDER = SCIENCE
MU0 = 4 * mp.pi / 10**7

# configuration, length [m], A [-], w [rad]
CONFIGURATIONS = {
    S_T: [
        ("uniform-min", 0.196, 0.0, 0.0),
        ("uniform-mid", 0.23, 0.0, 0.0),
        ("uniform-max", 0.264, 0.0, 0.0),
        ("uniform-close-wound", 0.104, 0.0, 0.0),
        ("uniform-long", 1.3, 0.0, 0.0),
        ("mode-1", 0.23, 0.8, 0.06041524333826525),
        ("mode-2", 0.23, 2.5, 0.1208304866765305),
        ("mode-2-reversed", 0.23, -2.5, 0.1208304866765305),
        ("mode-3", 0.264, 0.1, 0.18124573001479575),
        ("ripple", 0.196, 0.2, 3.1),
        ("ripple-small", 0.23, 1e-06, 1.7),
        ("uneven", 0.264, 0.45, 2.3),
    ],
    S_A: [
        ("uniform-min", 0.082, 0.0, 0.0),
        ("uniform-mid", 0.102, 0.0, 0.0),
        ("uniform-max", 0.122, 0.0, 0.0),
        ("uniform-low", 0.092, 0.0, 0.0),
        ("uniform-long", 0.9, 0.0, 0.0),
        ("mode-1", 0.102, 0.7, 0.12566370614359174),
        ("mode-2", 0.102, 0.6, 0.25132741228718347),
        ("mode-2-reversed", 0.102, -0.6, 0.25132741228718347),
        ("mode-3", 0.122, 0.1, 0.37699111843077515),
        ("ripple", 0.122, 0.1, 3.1),
        ("ripple-small", 0.102, 1e-06, 1.7),
        ("uneven", 0.122, 0.3, 2.3),
    ],
}


def positions(spring, length, amplitude, wave):
    """Winding positions [m] as doubles."""
    n = spring.windings
    places = []
    for i in range(1, n + 1):
        middle = mp.mpf(i) - mp.mpf(1) / 2
        pitch = mp.mpf(length) / n
        places.append(float(pitch * middle + mp.mpf(amplitude) * pitch * mp.sin(mp.mpf(wave) * middle)))
    assert all(a < b for a, b in zip(places, places[1:]))
    return places


def mutual(radius, distance):
    """M [H] of two loops, eqs. (8) and (9)."""
    m = (2 * radius) ** 2 / ((2 * radius) ** 2 + distance**2)
    kappa = mp.sqrt(m)
    return -MU0 * radius * ((kappa - 2 / kappa) * mp.ellipk(m) + 2 / kappa * mp.ellipe(m))


def inductances(spring, places):
    """L [H], eq. (11), with the self distance as printed and with the geometric mean distance."""
    n, radius = spring.windings, mp.mpf(spring.radius)
    exact = [mp.mpf(x) for x in places]
    pairs = mp.fsum(mutual(radius, exact[j] - exact[i]) for i in range(n) for j in range(i + 1, n))
    mean_distance = mp.mpf(spring.wire_radius) * mp.exp(-mp.mpf(1) / 4)
    return [2 * pairs + n * mutual(radius, factor * mean_distance) for factor in (mp.mpf(1) / 2, mp.one)]


def main():
    rows, place_rows = [], []
    for spring in SPRINGS:
        for name, length, amplitude, wave in CONFIGURATIONS[spring]:
            places = positions(spring, length, amplitude, wave)
            numbers = [mp.nstr(v, 40, strip_zeros=False) for v in inductances(spring, places)]
            rows.append(",".join([spring.name, name, repr(length), repr(amplitude), repr(wave), *numbers]))
            place_rows += [f"{spring.name},{name},{i + 1},{x!r}" for i, x in enumerate(places)]
    header = [
        f"# mpmath {mpmath.__version__}; 40 digits; reference/maxwell_sum.py; eqs. 8 to 11 as printed at 100 digits;"
        " positions are the exact doubles of maxwell_sum_positions.csv",
        "spring,configuration,l [m],A [-],w [rad],L with h_11 = rho e^(-1/4)/2 [H],L with h_11 = rho e^(-1/4) [H]",
    ]
    text = "\n".join(header + rows) + "\n"
    (FOLDER / "maxwell_sum.csv").write_text(text, encoding="utf-8", newline="\n")
    header = [
        f"# mpmath {mpmath.__version__}; shortest round-trip doubles; reference/maxwell_sum.py;"
        " x_i = l (i - 1/2)/N + A (l/N) sin(w (i - 1/2)) with l A w of maxwell_sum.csv",
        "spring,configuration,winding i [-],x_i [m]",
    ]
    text = "\n".join(header + place_rows) + "\n"
    (FOLDER / "maxwell_sum_positions.csv").write_text(text, encoding="utf-8", newline="\n")


if __name__ == "__main__":
    main()
