"""Force loops through a chain of twelve masses, over time and at their limit: every drive, load and force, in samples and continuous.

Here: cases with the gain factor at which the loop loses its stability, and 40 instants of each run. Next door: plant.py, the chain alone.

Route: Newton's equations of the masses, the motor and the load in absolute coordinates, no modes but for the damping's matrix. In samples the
exponential of the whole plant under a held command; the controller as SciPy's bilinear filters; the limit by the spectral radius of the closed
loop's matrix. Continuous without delay the exponential of the closed loop; with one, interval by interval of the delay, DOP853 at 1e-11.
F_L by the gradient of Maxwell's sum with derivatives at 30 digits.
"""

import csv
import math
from dataclasses import dataclass, field

import mpmath
import numpy
import scipy
from scipy.integrate import solve_ivp
from scipy.linalg import eigh, expm
from scipy.signal import cont2discrete, iirnotch

from golden import SCIENCE
from springs import S_T

mpmath.mp.dps = 30
N, MEAN = 12, 0.23
K, MASS, RADIUS = float(S_T.stiffness), float(S_T.mass), float(S_T.radius)
FORCES = ("F_i", "F_o", "F_x", "F_L")
NOTCHES, QUALITY = (54.0, 108.0, 162.0), 2.0
INSTANTS = 40


@dataclass
class Case:
    name: str
    drive: str
    force: str
    proportional: float
    integral: float = 0.0
    derivative: float = 0.0
    derivative_bandwidth: float = 0.0
    observer_bandwidth: float = 0.0
    motor_mass: float = 0.0
    friction: float = 0.0
    bandwidth: float = 0.0
    load: tuple = ()
    step: float = 5e-4
    late: int = 1
    delay: float = 0.0
    notches: bool = False
    ratio: float = 0.01
    duration: float = 0.6
    limit: float = field(default=math.nan)

    @property
    def is_sampled(self):
        return self.step > 0


CASES = (
    Case("motor on F_i", "force", "F_i", 0.5, 5.0, motor_mass=2.0, friction=30.0),
    Case("motor with a lag on F_o", "force", "F_o", 0.4, 4.0, motor_mass=1.0, friction=20.0, bandwidth=200.0, late=0),
    Case("motor on F_x against a load", "force", "F_x", 0.5, 5.0, motor_mass=2.0, friction=30.0, load=(1.0, 2.0, 100.0)),
    Case("motor on F_L", "force", "F_L", 0.6, 3.0, motor_mass=1.5, friction=25.0, late=2),
    Case("slow velocity on F_i", "velocity", "F_i", 3e-3, bandwidth=80.0),
    Case("slow velocity on F_L against a spring", "velocity", "F_L", 2e-2, bandwidth=80.0, load=(0.0, 0.0, 900.0)),
    Case("velocity on F_L", "velocity", "F_L", 5e-3, late=0),
    Case("velocity on F_x against a damper", "velocity", "F_x", 1e-2, load=(0.0, 7.0, 0.0)),
    Case("motor with PID and observer on F_i carrying a mass", "force", "F_i", 0.4, 2.0, 5e-3, 60.0, 2.0, 2.0, 30.0, 500.0, (1.0, 5.0, 0.0)),
    Case("motor on F_i behind notches", "force", "F_i", 0.5, 4.0, motor_mass=2.0, friction=30.0, notches=True),
    Case("continuous, motor on F_o", "force", "F_o", 0.3, 3.0, motor_mass=1.0, friction=20.0, bandwidth=200.0, step=0.0, late=0),
    Case("continuous, motor on F_i, late", "force", "F_i", 0.3, 3.0, motor_mass=1.0, friction=20.0, step=0.0, late=0, delay=1e-3),
    Case("continuous, slow velocity on F_L", "velocity", "F_L", 5e-3, bandwidth=80.0, step=0.0, late=0),
)


def inductance_weights():
    """g_i/(g · place): what F_L/k sees of each mass."""

    def mutual(h):
        r = mpmath.mpf(RADIUS)
        m = 4 * r**2 / (4 * r**2 + h**2)
        kappa = mpmath.sqrt(m)
        return (2 / kappa - kappa) * mpmath.ellipk(m) - 2 / kappa * mpmath.ellipe(m)

    pitch = mpmath.mpf(MEAN) / N
    slope = [None] + [mpmath.diff(mutual, a * pitch) for a in range(1, N)]
    gradient = [sum((1 if i > j else -1) * slope[abs(i - j)] for j in range(N) if j != i) for i in range(N)]
    by_length = sum(g * (mpmath.mpf(i) + mpmath.mpf("0.5")) / N for i, g in enumerate(gradient))
    return numpy.array([float(g / by_length) for g in gradient])


WEIGHTS = inductance_weights()


def plant(case):
    """A, B and rows of F_i, F_o, F_x, F_L: states x, x', y, then y' of a mass, f or y' behind a lag, u2 and u2' of a load with a mass."""
    k, segment, m = N * K, 2 * N * K, MASS / N
    stiffness = numpy.diag([2.0 * k] * N) - k * (numpy.eye(N, k=1) + numpy.eye(N, k=-1))
    stiffness[0, 0] = stiffness[-1, -1] = k + segment
    squares, shapes = eigh(stiffness / m)
    damping = m * shapes @ numpy.diag(2 * case.ratio * numpy.sqrt(squares)) @ shapes.T
    line = (numpy.arange(N) + 0.5) / N

    names = [*(f"x{i}" for i in range(N)), *(f"v{i}" for i in range(N)), "y"]
    names += ["w"] if case.drive == "force" else []
    names += ["g"] if case.bandwidth else []
    mass, damper, spring = case.load or (0.0, 0.0, 0.0)
    if case.load:
        names += ["u2", "s2"] if mass else ["u2"] if damper else []
    size = len(names)

    def unit(name):
        row = numpy.zeros(size + 1)
        row[size if name == "c" else names.index(name)] = 1.0
        return row

    x, v = ([unit(f"{letter}{i}") for i in range(N)] for letter in "xv")
    u1, source = -unit("y"), unit("g" if case.bandwidth else "c")
    s1 = -(unit("w") if case.drive == "force" else source)
    f_i = segment * (x[0] - u1)
    rates = {}
    if not case.load:
        u2 = s2 = numpy.zeros(size + 1)
    elif mass:
        u2, s2 = unit("u2"), unit("s2")
    elif damper:
        u2 = unit("u2")
        s2 = -(segment * (u2 - x[-1]) + spring * u2) / damper
    else:
        u2, s2 = (segment / (segment + spring) * row[-1] for row in (x, v))
    f_o = segment * (u2 - x[-1])
    for i in range(N):
        relative = [v[j] - (1 - line[j]) * s1 - line[j] * s2 for j in range(N)]
        bonds = sum(stiffness[i, j] * x[j] for j in range(N))
        drag = sum(damping[i, j] * relative[j] for j in range(N))
        outer = segment * ((i == 0) * u1 + (i == N - 1) * u2)
        rates[f"x{i}"], rates[f"v{i}"] = v[i], (outer - bonds - drag) / m
    rates["y"] = -s1
    if case.drive == "force":
        rates["w"] = (source - case.friction * unit("w") - f_i) / case.motor_mass
    if case.bandwidth:
        rates["g"] = 2 * math.pi * case.bandwidth * (unit("c") - unit("g"))
    if case.load and (mass or damper):
        rates["u2"] = s2
    if mass:
        rates["s2"] = -(f_o + damper * s2 + spring * u2) / mass
    whole = numpy.array([rates[name] for name in names])
    f_l = K * sum(weight * row for weight, row in zip(WEIGHTS, x, strict=True))
    # Turns move, ends do not count: a shift of all changes nothing.
    assert abs(WEIGHTS.sum()) < 1e-9
    return whole[:, :size], whole[:, size], dict(zip(FORCES, (f_i[:size], f_o[:size], (K * (u2 - u1))[:size], f_l[:size]), strict=True))


def polynomials(case):
    """Numerator and denominator of reference and of feedback, falling powers of s: (C)/(1 - Q) and (C + Q/P)/(1 - Q)."""
    numerator, denominator = numpy.array([case.proportional, case.integral]), numpy.array([1.0, 0.0])
    if not case.integral:
        numerator, denominator = numpy.array([case.proportional]), numpy.array([1.0])
    if case.derivative:
        slow = 1 / (2 * math.pi * case.derivative_bandwidth)
        numerator = numpy.polyadd(numpy.polymul(numerator, [slow, 1.0]), numpy.polymul(denominator, [case.derivative, 0.0]))
        denominator = numpy.polymul(denominator, [slow, 1.0])
    if not case.observer_bandwidth:
        return (numerator, denominator), (numerator, denominator)
    slow = 1 / (2 * math.pi * case.observer_bandwidth)
    over, rest = [slow**2, 2 * slow, 1.0], [slow**2, 2 * slow, 0.0]
    inverse = numpy.array([case.motor_mass, case.friction, K]) / K if case.drive == "force" else numpy.array([1 / K, 0.0])
    below = numpy.polymul(denominator, rest)
    fed = numpy.polyadd(numpy.polymul(numerator, over), numpy.polymul(denominator, inverse))
    return (numpy.polymul(numerator, over), below), (fed, below)


def state_space(numerator, denominator, step):
    """A filter as matrices; bilinear where a step is given."""
    a, b, c, d = scipy.signal.tf2ss(numerator, denominator)
    if a.size == 1 and not numpy.any(a) and not numpy.any(b):
        a, b, c = numpy.zeros((0, 0)), numpy.zeros((0, 1)), numpy.zeros((1, 0))
    elif step:
        a, b, c, d, _ = cont2discrete((a, b, c, d), step, "bilinear")
    return a, b[:, 0], c[0], float(d[0, 0])


def series(first, second):
    """One filter behind the other."""
    (a1, b1, c1, d1), (a2, b2, c2, d2) = first, second
    a = numpy.block([[a1, numpy.zeros((len(b1), len(b2)))], [numpy.outer(b2, c1), a2]])
    return a, numpy.concatenate([b1, b2 * d1]), numpy.concatenate([d2 * c1, c2]), d1 * d2


def fed_back(case, step):
    """The filter of the force: notches and controller."""
    filtered = state_space(*polynomials(case)[1], step)
    if case.notches:
        for frequency in NOTCHES:
            a, b, c, d = scipy.signal.tf2ss(*iirnotch(frequency, QUALITY, 1 / case.step))
            filtered = series((a, b[:, 0], c[0], float(d[0, 0])), filtered)
    return filtered


def held(a, b, step):
    whole = expm(numpy.block([[a, b[:, None]], [numpy.zeros((1, len(b) + 1))]]) * step)
    return whole[:-1, :-1], whole[:-1, -1]


def closed_matrix(case, gain, step):
    """The closed loop from sample to sample, or in time where there is no step; the reference's filter left out."""
    a, b, rows = plant(case)
    row = rows[case.force]
    if step:
        a, b = held(a, b, step)
    fa, fb, fc, fd = fed_back(case, step)
    n, f, late = len(b), len(fb), case.late
    whole = numpy.zeros((n + f + late,) * 2)
    whole[:n, :n], whole[n : n + f, :n], whole[n : n + f, n : n + f] = a, numpy.outer(fb, row), fa
    command = numpy.concatenate([-gain * fd * row, -gain * fc])
    if late:
        whole[:n, n + f] = b
        for place in range(n + f, n + f + late - 1):
            whole[place, place + 1] = 1.0
        whole[-1, : n + f] = command
    else:
        whole[:n, : n + f] += numpy.outer(b, command)
    return whole


def limit(case):
    """The gain factor from which on the loop grows."""
    if case.delay:
        return math.nan
    def grows(gain):
        values = numpy.linalg.eigvals(closed_matrix(case, gain, case.step))
        # Where end 2 is free, the whole may drift: a pole at rest.
        apart = values[numpy.abs(values - (1.0 if case.is_sampled else 0.0)) > 1e-6]
        return numpy.abs(apart).max() > 1 + 1e-13 if case.is_sampled else apart.real.max() > 1e-9

    low, high = 1e-3, 1e-3
    assert not grows(low), case.name
    while not grows(high):
        low, high = high, 1.05 * high
    while high / low > 1 + 1e-10:
        middle = math.sqrt(low * high)
        low, high = (low, middle) if grows(middle) else (middle, high)
    return high


def run_sampled(case):
    a, b, rows = plant(case)
    a, b = held(a, b, case.step)
    back, forward = fed_back(case, case.step), state_space(*polynomials(case)[0], case.step)
    x, back_state, forward_state = numpy.zeros(len(b)), numpy.zeros(len(back[1])), numpy.zeros(len(forward[1]))
    pending, found = [0.0] * case.late, []

    def through(kind, state, value):
        fa, fb, fc, fd = kind
        return fa @ state + fb * value, float(fc @ state + fd * value)

    count = round(case.duration / case.step)
    for sample in range(count):
        forces = {name: float(row @ x) for name, row in rows.items()}
        back_state, fed = through(back, back_state, forces[case.force])
        forward_state, wanted = through(forward, forward_state, 1.0)
        pending.append(wanted - fed)
        command = pending.pop(0)
        if sample % (count // INSTANTS) == count // INSTANTS - 1:
            found.append((sample * case.step, forces["F_i"], forces["F_o"], forces[case.force], command))
        x = a @ x + b * command
    return found


def run_continuous(case):
    """PI by an integral of the error as a further state."""
    a, b, rows = plant(case)
    row, n = rows[case.force], len(b)
    p, i = case.proportional, case.integral
    times = [case.duration * (instant + 1) / INSTANTS for instant in range(INSTANTS)]
    if not case.delay:
        whole = numpy.zeros((n + 2, n + 2))
        whole[:n, :n], whole[:n, n], whole[:n, n + 1] = a - p * numpy.outer(b, row), i * b, p * b
        whole[n, :n], whole[n, n + 1] = -row, 1.0
        start = numpy.zeros(n + 2)
        start[-1] = 1.0
        states = [expm(whole * time) @ start for time in times]
        command = [p * (1.0 - row @ state[:n]) + i * state[n] for state in states]
    else:
        history, state, states, command = None, numpy.zeros(n + 1), [], []
        intervals = round(case.duration / case.delay)
        for interval in range(intervals):
            begin = interval * case.delay

            def error(time, history=history, begin=begin, interval=interval):
                return 1.0 - float(row @ history(time - case.delay)[:n]) if interval else 0.0

            def rate(time, z, error=error):
                late = error(time)
                return numpy.concatenate([a @ z[:n] + b * (p * late + i * z[n]), [late]])

            solved = solve_ivp(rate, (begin, begin + case.delay), state, method="DOP853", rtol=1e-11, atol=1e-13, dense_output=True)
            for time in times:
                # At a whole number of delays the command is from just before.
                if begin < time - 1e-12 <= begin + case.delay:
                    z = solved.sol(time)
                    states.append(z)
                    command.append(p * error(time) + i * z[n])
            history, state = solved.sol, solved.y[:, -1]
        assert len(states) == INSTANTS
    each = zip(times, states, command, strict=True)
    return [(t, float(rows["F_i"] @ z[:n]), float(rows["F_o"] @ z[:n]), float(row @ z[:n]), c) for t, z, c in each]


def main():
    tools = f"# numpy {numpy.__version__}, scipy {scipy.__version__}, mpmath {mpmath.__version__}; 12 digits; reference/force_loops.py; "
    with open(SCIENCE / "force_loops_cases.csv", "w", newline="") as stream:
        stream.write(tools + "spectral radius of the closed loop of masses, no modes; 0 stands for what is not there\n")
        writer = csv.writer(stream, lineterminator="\n")
        writer.writerow(
            ["case", "drive", "force", "K_P", "K_I", "K_D", "derivative bandwidth [Hz]", "observer bandwidth [Hz]", "motor mass [kg]"]
            + ["friction [N s/m]", "drive bandwidth [Hz]", "loaded", "load mass [kg]", "load damping [N s/m]", "load stiffness [N/m]"]
            + ["step [s]", "delay [s]", "notches", "damping ratio", "gain limit"]
        )
        for case in CASES:
            load, delay = case.load or (0.0, 0.0, 0.0), case.delay or case.late * case.step
            bound = limit(case)
            print(f"{case.name}: limit {bound:.6g}")
            writer.writerow(
                [case.name, case.drive, case.force, case.proportional, case.integral, case.derivative, case.derivative_bandwidth]
                + [case.observer_bandwidth, case.motor_mass, case.friction, case.bandwidth, int(bool(case.load)), *load, case.step]
                + [delay, int(case.notches), case.ratio, repr(float(bound))]
            )
    with open(SCIENCE / "force_loops.csv", "w", newline="") as stream:
        stream.write(tools + "exponential of the masses' equations under a held command, no modes; a reference of 1 N\n")
        writer = csv.writer(stream, lineterminator="\n")
        writer.writerow(["case", "t [s]", "F_i [N]", "F_o [N]", "fed back [N]", "command"])
        for case in CASES:
            for values in run_sampled(case) if case.is_sampled else run_continuous(case):
                writer.writerow([case.name, *(repr(float(value)) for value in values)])


if __name__ == "__main__":
    main()
