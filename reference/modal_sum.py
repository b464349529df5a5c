"""Motion of the chain of eqs. (4) to (7): end forces and three windings at 40 instants, nine cases per spring.

Writes modal_sum.csv (the answers), modal_sum_cases.csv (inputs and start of each case) and
modal_sum_start.csv (the winding displacements and velocities of the case `given-start`).

Route: no modes at all. Windings, their velocities, two constants and five sine-cosine pairs (the inputs) form one
linear autonomous system z' = A z; its solution z(t) = exp(A t) z(0) is a matrix exponential in ball arithmetic
(Arb, 768 bits), whose proven error is asserted below 1e-45. Every case is only another z(0). A resonant input
needs nothing special. A is built from eqs. (4) to (6) by matrix products.

Conventions: positions from end 1 (u1) to end 2 (u2); tension positive;
F_i = 2Nk (x_1 - u1 - l0/2N), F_o = 2Nk (u2 - x_N - l0/2N), which is eq. (7) less the rest lengths.
u(t) = mean + amplitude sin(2 pi frequency t + phase). All inputs (Table I, cases, times) are doubles, used exactly:
the decimals of the files, parsed as doubles, are those numbers.
"""

from typing import NamedTuple

import flint
import mpmath
from flint import arb, arb_mat
from mpmath import mp

from golden import SCIENCE
from springs import SPRINGS, Spring

flint.ctx.prec = 768
mp.dps = 60
FOLDER = SCIENCE

EARLY = [0, 1, 2, 3, 7, 20, 55, 148, 403, 1000, 2500, 5000, 7499]
LATE = [7500, 7501, 7517, 7554, 7600, 7683, 7777, 7850, 7919, 8000, 8128, 8191, 8283, 8400, 8500, 8611, 8713, 8888]
LATE += [9001, 9109, 9241, 9377, 9500, 9689, 9876, 9999, 10000]
TIMES = [k / 10000 for k in EARLY + LATE]

STILL = (0.0, 0.0, 0.0)
PAIRS = ((1, "first"), (1, "half"), (2, "third"), (1, "low"), (2, "high"))  # end and name of the input sines
BOTH_ENDS = {  # amplitude [m], frequency [Hz], phase [rad] of each end
    "S_T": ((0.0012, 31.7, 0.4), (0.0008, 88.3, -1.9)),
    "S_A": ((0.0003, 101.3, 0.4), (0.0002, 267.9, -1.9)),
}


class Case(NamedTuple):
    name: str
    length: float  # mean of u2 [m]; the mean of u1 is zero
    u1: tuple = STILL  # amplitude [m], frequency [Hz], phase [rad]
    u2: tuple = STILL
    start: str = "uniform"  # uniform for the mean length | massless, between the moving ends | given
    speed: float = 0.0  # start velocity of every winding [m/s]
    slope: float = 0.0  # start velocity besides, times (i - 1/2)/N [m/s]
    pairs: tuple = ()  # which sines of PAIRS carry u1 and u2


def incidence(spring):
    """S_,x and S_,u of eq. (4): deflections of the N + 1 springs per winding and per end position."""
    n = spring.windings
    s_x = arb_mat(n + 1, n)
    s_u = arb_mat(n + 1, 2)
    for i in range(n):
        s_x[i, i] = 1
        s_x[i + 1, i] = -1
    s_u[0, 0] = -1
    s_u[n, 1] = 1
    return s_x, s_u


def stiffnesses(spring):
    """K of eq. (4)."""
    n, k = spring.windings, arb(spring.stiffness)
    matrix = arb_mat(n + 1, n + 1)
    for i in range(n + 1):
        matrix[i, i] = (2 if i in (0, n) else 1) * n * k
    return matrix


def first_surge_frequency(spring):
    """f_1 of eq. (3) [Hz], rounded to double."""
    return float(1 / (2 * mp.sqrt(mp.mpf(spring.mass) / mp.mpf(spring.stiffness))))


def own_frequency(spring, mode):
    """Frequency of the chain's own mode [Hz], rounded to double, from the eigenvalues of eqs. (5) and (6)."""
    s_x, _ = incidence(spring)
    product = s_x.transpose() * stiffnesses(spring) * s_x
    n = spring.windings
    matrix = mp.matrix(n, n)
    for i in range(n):
        for j in range(n):
            matrix[i, j] = mp.mpf(float(product[i, j])) * n / mp.mpf(spring.mass)  # entries are integers times k
            assert arb(float(product[i, j])) == product[i, j]
    squares = sorted(mp.eigsy(matrix, eigvals_only=True))
    return float(mp.sqrt(squares[mode - 1]) / (2 * mp.pi))


def cases(spring):
    """The nine cases (eight for S_A)."""
    middle, span = spring.middle, spring.span
    f1 = first_surge_frequency(spring)
    small, large = 0.001 * span, 0.01 * span
    quarter = float(-mp.pi / 2)
    low, high = BOTH_ENDS[spring.name]
    third = (small, own_frequency(spring, 3), 0.7)
    result = [
        Case("impact", middle, speed=0.25),
        Case("end-stop-max-linear", spring.longest, slope=span),
        Case("end-stop-min-uniform", spring.shortest, speed=-span),
        Case("resonance-text", middle, u1=(small, f1, 0.0), pairs=("first",)),
        Case("resonance-tables", middle, u1=(small, f1, quarter), start="massless", pairs=("first",)),
        Case("half-resonance-tables", middle, u1=(large, 0.5 * f1, quarter), start="massless", pairs=("half",)),
        Case("exactly-on-mode-3", middle, u2=third, pairs=("third",)),
        Case("both-ends", middle, u1=low, u2=high, start="massless", pairs=("low", "high")),
    ]
    if spring.name == "S_T":
        result.append(Case("given-start", 0.23, start="given"))
    return result


def given_start(spring):
    """Displacements from uniform 1e-3 sin(3.1 i) [m] and velocities 0.2 cos(1.7 i) [m/s], rounded to double."""
    windings = range(1, spring.windings + 1)
    places = [float(mp.mpf(1) / 1000 * mp.sin(mp.mpf(31) / 10 * i)) for i in windings]
    speeds = [float(mp.mpf(2) / 10 * mp.cos(mp.mpf(17) / 10 * i)) for i in windings]
    return places, speeds


def frequencies(all_cases):
    """Frequency [Hz] of each sine of PAIRS."""
    found = {}
    for case in all_cases:
        moving = [u for u in (case.u1, case.u2) if u[0]]
        for name, u in zip(case.pairs, moving):
            assert found.setdefault(name, u[1]) == u[1]
    return found


def system(spring, hertz):
    """A of z' = A z, z = (x, x', u1 mean, u2 mean, (sine, cosine) for each of PAIRS)."""
    n = spring.windings
    s_x, s_u = incidence(spring)
    per_mass = arb(n) / arb(spring.mass)
    by_x = -(s_x.transpose() * stiffnesses(spring) * s_x) * per_mass  # eqs. (5) and (6)
    by_u = -(s_x.transpose() * stiffnesses(spring) * s_u) * per_mass
    size = 2 * n + 2 + 2 * len(PAIRS)
    matrix = arb_mat(size, size)
    for i in range(n):
        matrix[i, n + i] = 1
        for j in range(n):
            matrix[n + i, j] = by_x[i, j]
        for end in (0, 1):
            matrix[n + i, 2 * n + end] = by_u[i, end]
        for at, (end, _) in enumerate(PAIRS):
            matrix[n + i, 2 * n + 2 + 2 * at] = by_u[i, end - 1]
    for at, (_, name) in enumerate(PAIRS):
        sine = 2 * n + 2 + 2 * at
        omega = 2 * arb.pi() * arb(hertz[name])
        matrix[sine, sine + 1] = omega
        matrix[sine + 1, sine] = -omega
    return matrix


def start_state(spring, case):
    """z(0) of a case."""
    n = spring.windings
    z = [arb(0)] * (2 * n + 2 + 2 * len(PAIRS))
    z[2 * n + 1] = arb(case.length)
    moving = iter(case.pairs)
    places, speeds = [arb(0), arb(case.length)], [arb(0), arb(0)]
    for end, (amplitude, hertz, phase) in enumerate((case.u1, case.u2)):
        if amplitude:
            sine = 2 * n + 2 + 2 * [name for _, name in PAIRS].index(next(moving))
            z[sine] = arb(amplitude) * arb(phase).sin()
            z[sine + 1] = arb(amplitude) * arb(phase).cos()
            if case.start == "massless":
                places[end] += z[sine]
                speeds[end] += 2 * arb.pi() * arb(hertz) * z[sine + 1]
    for i in range(n):
        part = (arb(i) + arb(0.5)) / n
        z[i] = places[0] + part * (places[1] - places[0])
        z[n + i] = speeds[0] + part * (speeds[1] - speeds[0]) + arb(case.speed) + part * arb(case.slope)
    if case.start == "given":
        for i, (place, speed) in enumerate(zip(*given_start(spring))):
            z[i] += arb(place)
            z[n + i] += arb(speed)
    return arb_mat(len(z), 1, z)


def answers(spring, z):
    """F_i, F_o [N] and x_1, x_(N/2), x_N [m] of a state."""
    n, k = spring.windings, arb(spring.stiffness)
    ends = [z[2 * n, 0], z[2 * n + 1, 0]]
    for at, (end, _) in enumerate(PAIRS):
        ends[end - 1] += z[2 * n + 2 + 2 * at, 0]
    rest = arb(spring.rest_length) / (2 * n)
    f_i = 2 * n * k * (z[0, 0] - ends[0] - rest)
    f_o = 2 * n * k * (ends[1] - z[n - 1, 0] - rest)
    return [f_i, f_o, z[0, 0], z[n // 2 - 1, 0], z[n - 1, 0]]


def digits(value):
    """40 digits of a ball that is known to better than 1e-45."""
    assert value.rad() < 1e-45, value
    man, exp = value.mid().man_exp()
    return mp.nstr(mp.ldexp(mp.mpf(int(man)), int(exp)), 40, strip_zeros=False)


def solve(spring: Spring):
    """Rows of modal_sum.csv and modal_sum_cases.csv of one spring."""
    all_cases = cases(spring)
    matrix = system(spring, frequencies(all_cases))
    starts = [start_state(spring, case) for case in all_cases]
    rows = {case.name: [] for case in all_cases}
    for time in TIMES:
        flow = (matrix * arb(time)).exp()
        for case, z in zip(all_cases, starts):
            values = [digits(v) for v in answers(spring, flow * z)]
            rows[case.name].append(",".join([spring.name, case.name, repr(time), *values]))
    inputs = []
    for case in all_cases:
        numbers = [0.0, *case.u1, case.length, *case.u2, case.speed, case.slope]
        inputs.append(",".join([spring.name, case.name, *map(repr, numbers), case.start]))
    return [row for block in rows.values() for row in block], inputs


def write(name, header, rows):
    (FOLDER / name).write_text("\n".join(header + rows) + "\n", encoding="utf-8", newline="\n")


def main():
    results, inputs = [], []
    for spring in SPRINGS:
        more_results, more_inputs = solve(spring)
        results += more_results
        inputs += more_inputs
    tools = f"# python-flint {flint.__version__} (Arb, 768 bits) mpmath {mpmath.__version__}"
    write(
        "modal_sum.csv",
        [
            f"{tools}; 40 digits; reference/modal_sum.py; matrix exponential of chain and inputs, no modes;"
            " times and parameters are exact doubles; mid is winding N/2 rounded down, counted from 1",
            "spring,case,time [s],F_i [N],F_o [N],x_1 [m],x_mid [m],x_N [m]",
        ],
        results,
    )
    sides = ",".join(f"{u} mean [m],{u} amplitude [m],{u} frequency [Hz],{u} phase [rad]" for u in ("u1", "u2"))
    write(
        "modal_sum_cases.csv",
        [
            f"{tools}; shortest round-trip doubles; reference/modal_sum.py;"
            " u = mean + amplitude sin(2 pi frequency t + phase);"
            " start velocity = uniform + slope (i - 1/2)/N besides what the start kind gives",
            f"spring,case,{sides},start velocity uniform [m/s],start velocity slope [m/s],start [-]",
        ],
        inputs,
    )
    places, speeds = given_start(SPRINGS[0])
    write(
        "modal_sum_start.csv",
        [
            f"{tools}; shortest round-trip doubles; reference/modal_sum.py;"
            " start of the case given-start of S_T: displacement from u1 + (i - 1/2)(u2 - u1)/N",
            "winding i [-],displacement [m],velocity [m/s]",
        ],
        [f"{i + 1},{x!r},{v!r}" for i, (x, v) in enumerate(zip(places, speeds))],
    )


if __name__ == "__main__":
    main()
