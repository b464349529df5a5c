"""Forces of a chain of eight masses on every mount, under inputs that move straight between samples.

Here: samples of both inputs, F_i, F_o, F_x and u2. Next door: modal_sum.py, whose inputs are sines and steps.

Route: Newton's equations of the masses in absolute coordinates, with the inputs and their rates as further states,

    M x'' = -K (x - L p) - (a M + b K)(x' - L p'),   p' constant over a step

stepped by the exponential of the whole matrix (mpmath, 50 digits). No modes, no coordinates relative to a line, no kicks. L p is the line of a
spring without mass: from u1 to u2, or to u1 + f/k where end 2 is under a force f. Forces are the end segments', relative damping included,
from just before a sample. Checked: half the step, twice as often, gives the same to 1e-40.

Inputs are whole multiples of 2^-31 m and 2^-20 N by a congruential series: doubles, and exact in the CSV.
"""

import mpmath
from mpmath import mp

from golden import SCIENCE
from springs import S_T

mp.dps = 50
N, STEP, SAMPLES = 8, mp.mpf(3e-4), 60
K, MASS, MEAN = mp.mpf(S_T.stiffness), mp.mpf(S_T.mass), mp.mpf(0.23)
REST = mp.mpf(S_T.rest_length)
END_MASS = mp.mpf(0.1)
MOUNTS = ("position", "force", "mass")
DAMPINGS = (("none", 0.0, 0.0), ("mass", 20.0, 0.0), ("stiffness", 0.0, 3e-4))


def matrices(mount):
    """M and K of the masses that move, L by columns, and rows that read F_i, F_o off x - L p."""
    size = N + (mount == "mass")
    inertia = [MASS / N] * N + [END_MASS] * (size - N)
    stiffness = mp.zeros(size)
    stiffness[0, 0] += 2 * N * K
    bonds = [(i, i + 1, N * K) for i in range(N - 1)] + ([(N - 1, N, 2 * N * K)] if mount == "mass" else [])
    for i, j, k in bonds:
        stiffness[i, i] += k
        stiffness[j, j] += k
        stiffness[i, j] -= k
        stiffness[j, i] -= k
    if mount == "position":
        stiffness[N - 1, N - 1] += 2 * N * K
    place = [(mp.mpf(i) + mp.mpf(1) / 2) / N for i in range(N)] + [mp.one] * (size - N)
    held = mount == "position"
    line = [[1 - s, s] if held else [mp.one, s / K] for s in place]
    first, last = mp.zeros(1, size), mp.zeros(1, size)
    first[0] = 2 * N * K
    if held:
        last[N - 1] = -2 * N * K
    elif mount == "mass":
        last[N - 1], last[N] = -2 * N * K, 2 * N * K
    return inertia, stiffness, line, first, last


def generator(mount, alpha, beta):
    """Rates of (x, x', p, p') over itself, all counted from rest at the mean length."""
    inertia, stiffness, line, _, _ = matrices(mount)
    size = len(inertia)
    whole = mp.zeros(2 * size + 4)
    spring = [[-stiffness[i, j] / inertia[i] for j in range(size)] for i in range(size)]
    for i in range(size):
        whole[i, size + i] = 1
        for j in range(size):
            damper = beta * spring[i][j] - (alpha if i == j else 0)
            whole[size + i, j] += spring[i][j]
            whole[size + i, size + j] += damper
            for end in range(2):
                whole[size + i, 2 * size + end] -= spring[i][j] * line[j][end]
                whole[size + i, 2 * size + 2 + end] -= damper * line[j][end]
    for end in range(2):
        whole[2 * size + end, 2 * size + 2 + end] = 1
    return whole


def inputs(mount):
    """Whole multiples of 2^-31 m, and of 2^-20 N: a rough walk of some tenths of a millimetre."""
    state, walk, rows = 12345, [0, 0], []
    for _ in range(SAMPLES):
        for end in range(2):
            state = (1103515245 * state + 12345) % 2**31
            walk[end] += state // 2**12 - 2**18
        second = walk[1] if mount == "position" else walk[1] // 4
        rows.append([mp.mpf(walk[0]) / 2**31, mp.mpf(second) / (2**31 if mount == "position" else 2**20)])
    return rows


def samples(mount, alpha, beta, parts):
    """F_i, F_o, F_x, u2 at each sample; a step in so many parts."""
    inertia, _, line, first, last = matrices(mount)
    size = len(inertia)
    turn = mpmath.expm(generator(mount, mp.mpf(alpha), mp.mpf(beta)) * STEP / parts)
    state, before = mp.zeros(2 * size + 4, 1), [mp.zero, mp.zero]
    for row in inputs(mount):
        for end in range(2):
            state[2 * size + 2 + end] = (row[end] - before[end]) / STEP
        for _ in range(parts):
            state = turn * state
        before = row
        place = [state[i] - sum(line[i][end] * row[end] for end in range(2)) for i in range(size)]
        rates = [
            state[size + i] - sum(line[i][end] * state[2 * size + 2 + end] for end in range(2)) for i in range(size)
        ]
        ends = [sum(read[i] * (place[i] + mp.mpf(beta) * rates[i]) for i in range(size)) for read in (first, last)]
        still = K * (MEAN - REST) + (K * (row[1] - row[0]) if mount == "position" else row[1])
        if mount == "position":
            end_2 = row[1]
        elif mount == "mass":
            end_2 = state[N]
        else:
            # No segment's force at the free end: it is the last mass and half a segment of the massless line.
            end_2 = row[0] + row[1] / K + place[N - 1]
        deflection = K * (MEAN - REST + end_2 - row[0])
        yield row, [still + ends[0], still + ends[1], deflection, end_2]


def main():
    path = SCIENCE / "plant.csv"
    route = "exponential of the masses' equations with inputs as states, no modes; inputs are exact doubles"
    with path.open("w") as file:
        file.write(f"# mpmath {mpmath.__version__}; 20 digits; reference/plant.py; {route}\n")
        file.write("mount,damping,u1 [m],input 2 [m or N],F_i [N],F_o [N],F_x [N],u2 [m]\n")
        for mount in MOUNTS:
            for damping, alpha, beta in DAMPINGS:
                whole = list(samples(mount, alpha, beta, 1))
                for (row, values), (_, again) in zip(whole, samples(mount, alpha, beta, 2)):
                    assert max(abs(a - b) for a, b in zip(values, again)) < mp.mpf(10) ** -40
                    numbers = [repr(float(value)) for value in row] + [mp.nstr(value, 20) for value in values]
                    file.write(",".join([mount, damping, *numbers]) + "\n")


if __name__ == "__main__":
    main()
