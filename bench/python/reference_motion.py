"""End forces of the chain by its modal sum in 80-bit floats, about 1e-16 of the peak before rounding to double.

Eqs. (4) to (7) of the paper as a DST-II chain: modes sin(j pi (i - 1/2)/N), omega_j = 2N sqrt(k/m) s_j,
s_j = sin(j pi / 2N). With y the winding displacements from the straight line between the ends,
q_j'' + omega_j^2 q_j = -g_j u1'' and F_i = F_x + 2Nk sum s_j q_j, F_o = F_x -+ 2Nk sum s_j q_j (j odd: -, even: +).
Sample n is at exactly n / rate seconds.

Checked on every run against crates/coilsense/tests/golden/modal_sum.csv (matrix exponential in Arb, no modes).
"""

import csv

import numpy as np

LONG = np.longdouble
PI = LONG("3.14159265358979323846264338327950288")
if np.finfo(LONG).nmant < 63:
    raise SystemExit("make_jobs.py needs an 80-bit long double (x86-64 Linux): the references would not be exact enough")


class Chain:
    """Modes of one job's spring, and the projection of a straight line on them."""

    def __init__(self, spring):
        n = spring["windings"]
        self.windings, self.stiffness = n, LONG(spring["stiffness"])
        self.mode = np.arange(1, n + 1)
        self.odd = self.mode % 2 == 1
        self.half_sine = np.sin(self.mode * PI / (2 * n))
        self.omega = 2 * n * np.sqrt(self.stiffness / LONG(spring["mass"])) * self.half_sine
        self.to_force = 2 * n * self.stiffness * self.half_sine

    def project(self, at_end_1, at_end_2):
        """Modal coordinates of the straight line between two values, in closed form."""
        square_norm = np.where(self.mode == self.windings, LONG(self.windings), LONG(self.windings) / 2)
        first, second = LONG(at_end_1), LONG(at_end_2)
        return np.where(self.odd, first + second, first - second) / (2 * self.half_sine * square_norm)


def oscillation(cosine, sine, omega, samples, rate):
    """sum_j cosine_j cos(omega_j t) + sine_j sin(omega_j t) at all samples.

    On two levels, t = (p B + q)/rate: only 2 sqrt(samples) sines per mode.
    """
    block = int(np.ceil(np.sqrt(samples)))
    coarse = np.outer(np.arange(block) * block / LONG(rate), omega)
    fine = np.outer(omega, np.arange(block) / LONG(rate))
    c, s = np.cos(coarse), np.sin(coarse)
    rows = np.concatenate([cosine * c + sine * s, sine * c - cosine * s], axis=1)
    return (rows @ np.concatenate([np.cos(fine), np.sin(fine)])).ravel()[:samples]


def free_start(chain, job, u1_start, u1_velocity):
    """Modal displacement and velocity at t = 0 of the windings from the line between the ends."""
    (x1, x2), (v1, v2) = job["start"]["position"], job["start"]["velocity"]
    place = chain.project(LONG(x1) - u1_start, LONG(x2) - LONG(job["mean_length"]))
    return place, chain.project(LONG(v1) - u1_velocity, v2)


def modal_sums(chain, job, u1):
    """[sum over odd modes, sum over even modes] of the force, and u1, at all samples."""
    samples, rate, drive = job["samples"], job["rate"], job["u1"]
    if drive["kind"] == "sampled":
        return recorded_sums(chain, job, u1), u1.astype(LONG)
    forced = np.zeros(chain.windings, dtype=LONG)
    big_omega, phase, amplitude = LONG(0), LONG(0), LONG(0)
    if drive["kind"] == "harmonic":
        big_omega, phase, amplitude = 2 * PI * LONG(drive["frequency"]), LONG(drive["phase"]), LONG(drive["amplitude"])
        forced = chain.project(1, 0) * amplitude * big_omega**2 / (chain.omega**2 - big_omega**2)
    place, velocity = free_start(chain, job, amplitude * np.sin(phase), amplitude * big_omega * np.cos(phase))
    cosine = place - forced * np.sin(phase)
    sine = (velocity - forced * big_omega * np.cos(phase)) / chain.omega
    drive_sine = np.sin(big_omega * (np.arange(samples) / LONG(rate)) + phase)
    sums = []
    for part in (chain.odd, ~chain.odd):
        weight = chain.to_force[part]
        free = oscillation(weight * cosine[part], weight * sine[part], chain.omega[part], samples, rate)
        sums.append(free + (weight * forced[part]).sum() * drive_sine)
    return sums, amplitude * drive_sine


def recorded_sums(chain, job, u1):
    """The same for u1 linear between its samples: every change of slope is a blow, and the modes turn freely between.

    Before t = 0 end 1 stands still, so that the first slope is a change too.
    """
    rate = LONG(job["rate"])
    slopes = np.diff(u1.astype(LONG)) * rate
    blows = np.diff(slopes, prepend=LONG(0))
    place, velocity = free_start(chain, job, LONG(u1[0]), LONG(0))
    gain = chain.project(1, 0)
    turn = np.exp(1j * (chain.omega / rate).astype(np.clongdouble))
    state = place * chain.omega + 1j * velocity  # q omega + i q', turning clockwise
    turn = turn.conj()
    sums = np.zeros((2, job["samples"]), dtype=LONG)
    weight = chain.to_force / chain.omega
    for n in range(job["samples"]):
        force = weight * state.real
        sums[0, n], sums[1, n] = force[chain.odd].sum(), force[~chain.odd].sum()
        if n < len(blows):
            state = (state - 1j * (gain * blows[n])) * turn
    return list(sums)


def end_forces(job, u1):
    """F_i and F_o [N] in doubles; `u1` [m] are the samples of a sampled input."""
    chain = Chain(job["spring"])
    (odd, even), place = modal_sums(chain, job, u1)
    static = chain.stiffness * (LONG(job["mean_length"]) - place - LONG(job["spring"]["rest_length"]))
    return (static + odd + even).astype(float), (static - odd + even).astype(float)


def winding_positions(job):
    """Positions [m] of all windings at all samples, for ends held; shape samples x windings. Doubles do: it is data."""
    chain = Chain(job["spring"])
    times = (np.arange(job["samples"]) / LONG(job["rate"])).astype(float)
    place, velocity = (part.astype(float) for part in free_start(chain, job, LONG(0), LONG(0)))
    omega = chain.omega.astype(float)
    turning = np.outer(times, omega)
    modal = place * np.cos(turning) + velocity / omega * np.sin(turning)
    along = (np.arange(chain.windings) + 0.5) / chain.windings
    shapes = np.sin(np.outer(chain.mode, np.pi * along))
    return along * job["mean_length"] + modal @ shapes


def peaks(job, forces, u1):
    """Largest |F - F_x| of each end force."""
    spring = job["spring"]
    static = spring["stiffness"] * (job["mean_length"] - u1 - spring["rest_length"])
    return [np.abs(force - static).max() for force in forces]


def check_against_golden(jobs, folder, golden):
    """The three jobs that crates/coilsense/tests/golden/modal_sum.csv also has, at its 40 instants."""
    names = {"impact": "impact", "end-stop": "end-stop-max-linear", "resonance": "resonance-tables"}
    with open(golden / "modal_sum.csv", encoding="utf-8") as file:
        rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
    for job in jobs:
        mine = [row for row in rows if row["spring"] == "S_T" and row["case"] == names.get(job["job"])]
        if not mine:
            continue
        forces = np.fromfile(folder / job["reference"], dtype="<f8").reshape(2, -1)
        at = [round(float(row["time [s]"]) * job["rate"]) for row in mine]
        for force, column, peak in zip(forces, ("F_i [N]", "F_o [N]"), peaks(job, forces, 0.0)):
            theirs = np.array([float(row[column]) for row in mine])
            error = np.abs(force[at] - theirs).max() / peak
            # 1e-12: the golden instants are doubles, up to 5e-17 s from n/rate; forces change by up to 1e4 peaks a second.
            assert error < 1e-12, (job["job"], column, error)
            print(f"{job['job']} {column}: {error:.1e} of the peak from the golden file")


def check_recorded_without_modes(job, u1, folder):
    """The job `recorded` step by step with the matrix exponential of chain and input in Arb, 192 bits; about a minute."""
    import flint

    flint.ctx.prec = 192
    arb, n = flint.arb, job["spring"]["windings"]
    k, mass = arb(job["spring"]["stiffness"]) * n, arb(job["spring"]["mass"]) / n
    system = flint.arb_mat(2 * n + 3, 2 * n + 3)  # x, v, u1, slope of u1, length
    for i in range(n):
        left, right = (2 if i == 0 else 1), (2 if i == n - 1 else 1)
        system[i, n + i] = 1
        system[n + i, i] = -(left + right) * k / mass
        system[n + i, i - 1 if i else 2 * n] = left * k / mass
        system[n + i, i + 1 if i < n - 1 else 2 * n + 2] = right * k / mass
    system[2 * n, 2 * n + 1] = 1
    step = (system / arb(job["rate"])).exp()
    length = arb(job["mean_length"])
    state = [length * (arb(i) + arb(0.5)) / n for i in range(n)] + [arb(0)] * (n + 2) + [length]
    rest = arb(job["spring"]["rest_length"]) / (2 * n)
    forces = np.zeros((2, job["samples"]))
    for sample in range(job["samples"]):
        state[2 * n] = arb(float(u1[sample]))
        forces[0, sample] = float(2 * k * (state[0] - state[2 * n] - rest))
        forces[1, sample] = float(2 * k * (length - state[n - 1] - rest))
        if sample + 1 < job["samples"]:
            state[2 * n + 1] = (arb(float(u1[sample + 1])) - state[2 * n]) * arb(job["rate"])
            moved = step * flint.arb_mat(2 * n + 3, 1, state)
            # Middles only: balls that are multiplied 10 000 times would burst; 192 bits leave 40 digits.
            state = [moved[i, 0].mid() for i in range(2 * n + 3)]
    mine = np.fromfile(folder / job["reference"], dtype="<f8").reshape(2, -1)
    error = max(np.abs(mine - forces).max(axis=1) / peaks(job, forces, u1))
    assert error < 1e-13, error
    print(f"recorded: {error:.1e} of the peak from Arb, no modes")
