"""SciPy: `solve_ivp` on eqs. (4) to (6), and `signal.lsim` on the same chain as a state space."""

import numpy as np
from scipy.integrate import solve_ivp
from scipy.signal import StateSpace, lsim

from measure import drive


def start_line(job, ends):
    n = job["spring"]["windings"]
    return ends[0] + (ends[1] - ends[0]) * (np.arange(n) + 0.5) / n


def start_state(job):
    return np.concatenate([start_line(job, job["start"][part]) for part in ("position", "velocity")])


def integrated(job, **options):
    """End forces by `solve_ivp`; states are positions and velocities."""
    spring, n, u1, length = job["spring"], job["spring"]["windings"], drive(job), job["mean_length"]
    k, rest, per_mass = n * spring["stiffness"], spring["rest_length"] / n, n / spring["mass"]
    tension = np.empty(n + 1)

    def rates(t, y):
        x = y[:n]
        tension[0] = 2 * k * (x[0] - u1(t) - 0.5 * rest)
        tension[1:n] = k * (x[1:] - x[:-1] - rest)
        tension[n] = 2 * k * (length - x[n - 1] - 0.5 * rest)
        return np.concatenate([y[n:], per_mass * (tension[1:] - tension[:-1])])

    solution = solve_ivp(rates, (0.0, job["times"][-1]), start_state(job), t_eval=job["times"], **options)
    if not solution.success:
        raise RuntimeError(solution.message)
    first, last = solution.y[0], solution.y[n - 1]
    return 2 * k * (first - u1(job["times"]) - 0.5 * rest), 2 * k * (length - last - 0.5 * rest)


def state_space(job):
    """Chain about uniform windings: state (displacements, velocities), input u1, outputs the end forces' changes."""
    spring, n = job["spring"], job["spring"]["windings"]
    k, per_mass = n * spring["stiffness"], n / spring["mass"]
    stiffness = 2 * np.eye(n) - np.eye(n, k=1) - np.eye(n, k=-1)
    stiffness[0, 0] = stiffness[-1, -1] = 3
    a = np.block([[np.zeros((n, n)), np.eye(n)], [-k * per_mass * stiffness, np.zeros((n, n))]])
    b, c, d = np.zeros((2 * n, 1)), np.zeros((2, 2 * n)), np.array([[-2 * k], [0.0]])
    b[n, 0] = 2 * k * per_mass
    c[0, 0], c[1, n - 1] = 2 * k, -2 * k
    return StateSpace(a, b, c, d)


def linear_simulation(job):
    """End forces by `lsim`, linear between samples; the state space is made before the clock starts."""
    system, times, spring = state_space(job), job["times"], job["spring"]
    preload = spring["stiffness"] * (job["mean_length"] - spring["rest_length"])
    # No input is 0, not zeros: lsim then leaves the input out.
    u1 = 0 if job["u1"]["kind"] == "held" else drive(job)(times)

    def solve():
        start = start_state(job)
        start[: len(start) // 2] -= start_line(job, (0.0, job["mean_length"]))
        forces = lsim(system, u1, times, start)[1] + preload
        return forces[:, 0], forces[:, 1]

    return solve
