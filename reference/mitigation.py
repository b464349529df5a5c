"""Filters and gains that coilsense::mitigation designs, by SciPy.

Writes mitigation_filters.csv (frequency responses of Butterworth low-passes and notches) and mitigation_kalman.csv (steady-state
gains of the modal Kalman filter).

Route for the filters: scipy.signal.butter as second-order sections and scipy.signal.iirnotch, evaluated by freqz_sos and freqz.

Route for the gains: the chain of eqs. (4) to (6) with both ends held, its modes by numpy.linalg.eigh (no closed form); each mode's
transition over one sample by scipy.linalg.expm of its 2 x 2 system in (q, qdot/omega), scaled to the force that q adds to F_i;
shocks as a white uniform velocity of all windings (projected on the shapes); a force bias as a random walk; the gain K = P h'/(h P h' + r) with P by scipy.linalg.solve_discrete_are of the transposed system.
The residual of the Riccati equation is checked here.
"""


import numpy as np
import scipy
from scipy.linalg import expm, solve_discrete_are
from scipy.signal import butter, freqz, freqz_sos, iirnotch

from golden import SCIENCE
from springs import S_A, S_T

FOLDER = SCIENCE
RATE = 2500.0
FREQUENCIES = [0.1, 1.0, 5.0, 27.0, 54.0, 54.0654, 100.0, 333.0, 900.0, 1249.0]
LOW_PASSES = [(1, 27.0), (2, 27.0), (3, 100.0), (4, 10.0), (5, 400.0), (8, 60.0), (8, 1100.0)]
NOTCHES = [(54.0654, 2.0), (54.0654, 0.7), (270.0, 3.0), (1000.0, 5.0), (540.0, 30.0)]
# spring, modes, zeta, rate, noise of the force, of shocks, of the ringing, drift
FILTERS = [
    (S_T, 3, 0.005, 2500.0, 0.24, 0.15, 2.0, 0.5),
    (S_T, 1, 0.0, 2500.0, 0.24, 0.0, 0.3, 0.05),
    (S_T, 5, 0.02, 10000.0, 0.1, 0.3, 0.1, 2.0),
    (S_A, 3, 0.01, 5000.0, 1.0, 0.5, 20.0, 3.0),
    (S_A, 2, 0.3, 1000.0, 1.0, 0.02, 20.0, 3.0),
]


def versions():
    return f"# NumPy {np.__version__} SciPy {scipy.__version__}; doubles; reference/mitigation.py"


def filters():
    lines = [versions() + "; scipy.signal", "kind,order or quality,frequency [Hz],rate [Hz],at [Hz],re,im"]
    for order, cutoff in LOW_PASSES:
        _, response = freqz_sos(butter(order, cutoff, fs=RATE, output="sos"), worN=FREQUENCIES, fs=RATE)
        lines += rows("low-pass", order, cutoff, response)
    for centre, quality in NOTCHES:
        _, response = freqz(*iirnotch(centre, quality, fs=RATE), worN=FREQUENCIES, fs=RATE)
        lines += rows("notch", quality, centre, response)
    (FOLDER / "mitigation_filters.csv").write_text("\n".join(lines) + "\n", encoding="utf-8")


def rows(kind, number, frequency, response):
    for at, value in zip(FREQUENCIES, response):
        yield f"{kind},{number},{frequency!r},{RATE!r},{at!r},{value.real:.17g},{value.imag:.17g}"


def modes(spring):
    """omega [rad/s], force at end 1 and at end 2 per unit of each mode, and its share of a uniform velocity, lowest first."""
    n, k = spring.windings, spring.stiffness
    matrix = np.zeros((n, n))
    for i in range(n):
        matrix[i, i] = n * k * (2 + (i == 0) + (i == n - 1))
        if i:
            matrix[i, i - 1] = matrix[i - 1, i] = -n * k
    values, shapes = np.linalg.eigh(matrix * n / spring.mass)
    return np.sqrt(values), 2 * n * k * shapes[0], -2 * n * k * shapes[-1], shapes.sum(axis=0)


def gains(spring, count, zeta, rate, force, shock, ringing, drift):
    omegas, first, second, share = (series[:count] for series in modes(spring))
    size = 2 * count + 1
    phi, h, knock = np.eye(size), np.zeros(size), np.zeros(size)
    for j, omega in enumerate(omegas):
        phi[2 * j : 2 * j + 2, 2 * j : 2 * j + 2] = expm(np.array([[0, omega], [-omega, -2 * zeta * omega]]) / rate)
        h[2 * j] = 1
        knock[2 * j + 1] = first[j] * share[j] / omega
    h[-1] = 1
    knock = phi @ knock
    q = np.diag([ringing**2 / rate] * (size - 1) + [drift**2 / rate]) + shock**2 / rate * np.outer(knock, knock)
    p = solve_discrete_are(phi.T, h[:, None], q, [[force**2]])
    k = p @ h / (h @ p @ h + force**2)
    residual = phi @ p @ phi.T - np.outer(phi @ k, h @ p @ phi.T) + q - p
    assert np.abs(residual).max() < 1e-11 * np.abs(p).max(), np.abs(residual).max()
    assert np.abs(np.linalg.eigvals(phi - np.outer(phi @ k, h))).max() < 1
    return k, second / first


def kalman():
    header = "spring,modes,zeta,rate [Hz],force noise [N],shock [m/s/sqrt(s)],ringing [N/sqrt(s)],drift [N/sqrt(s)],state,gain,F_o over F_i"
    lines = [versions() + "; numpy.linalg.eigh, scipy.linalg.expm and solve_discrete_are", header]
    for case in FILTERS:
        k, ratio = gains(*case)
        given = ",".join([case[0].name, *map(repr, case[1:])])
        for state, gain in enumerate(k):
            shown = ratio[state // 2] if state < 2 * case[1] else 1.0
            lines.append(f"{given},{state},{gain:.17g},{shown:.17g}")
    (FOLDER / "mitigation_kalman.csv").write_text("\n".join(lines) + "\n", encoding="utf-8")


if __name__ == "__main__":
    filters()
    kalman()
