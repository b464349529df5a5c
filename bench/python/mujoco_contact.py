"""MuJoCo: a chain of masses on slide joints whose neighbours may not come nearer than a gap.

One body on a slide joint per mass; fixed tendons as springs between neighbours, each with a lower limit on its length as the contact:
MuJoCo's soft constraint, with the time constant and the impedance of `solref` and `solimp`. The joints' zero is the uniform chain at rest;
u1 acts as a force on the first joint, held over a step at its value in the middle. `mujoco.rollout` runs all steps.
"""

import csv
import math
from pathlib import Path

import mujoco
import numpy as np
from mujoco import rollout

GOLDEN = Path(__file__).resolve().parents[2] / "crates" / "coilsense" / "tests" / "golden" / "contact_steps_rms.csv"
RATE = 50_000.0


def cam(t):
    """10 mm 64 s^3 (1 - s)^3 over 130 degrees of a turn in 20 ms, from a quarter of a turn on."""
    s = np.mod(t / 0.02 - 0.25, 1.0) / (130 / 360) * (t > 0.005)
    return np.where(s < 1, 0.01 * 64 * (s * (1 - s)) ** 3, 0.0)


def shake(t):
    """40 um at S_A's first frequency, pi sqrt(k/m), from -90 degrees on."""
    return -40e-6 * np.cos(math.pi * math.sqrt(9100 / 0.08) * t)


# Masses, k [N/m], m [kg], gap left at the mean length [m], u1, preload [N], duration [s], window of the mean square [s].
CHAINS = {
    "valve": (6, 29028.0, 44.549e-3, 0.017 / 6, cam, -29028.0 * 0.009, 0.3, (0.1, 0.12)),
    "contact": (25, 9100.0, 0.08, 0.102 / 25 - 0.0032, shake, 9100.0 * 0.021, 1.0, (0.6, 0.75)),
}


def model_text(chain, step, limit):
    count, k, mass, gap = chain[:4]
    k, mass = count * k, mass / count

    def body(i):
        end = f' stiffness="{2 * k!r}"' if i in (0, count - 1) else ""
        inertial = f'<inertial pos="0 0 0" mass="{mass!r}" diaginertia="1e-6 1e-6 1e-6"/>'
        return f'<body>{inertial}<joint name="j{i}" type="slide" axis="1 0 0"{end}/></body>'

    def tendon(i):
        sides = f'<joint joint="j{i}" coef="-1"/><joint joint="j{i + 1}" coef="1"/>'
        return f'<fixed stiffness="{k!r}" springlength="0" limited="true" range="{-gap!r} 1" {limit}>{sides}</fixed>'

    motor = f'<motor joint="j0" gear="{2 * k!r}"/>'
    return f"""<mujoco><option timestep="{step!r}" integrator="RK4" gravity="0 0 0"/>
        <worldbody>{"".join(map(body, range(count)))}</worldbody>
        <tendon>{"".join(map(tendon, range(count - 1)))}</tendon><actuator>{motor}</actuator></mujoco>"""


def simulation(name, substeps, limit):
    """A function that simulates with `substeps` steps per sample and returns F_i and F_o."""
    chain = CHAINS[name]
    count, k, _, _, u1, preload, duration, _ = chain
    step, samples = 1 / RATE / substeps, round(duration * RATE)
    model = mujoco.MjModel.from_xml_string(model_text(chain, step, limit))
    data = mujoco.MjData(model)
    data.qpos[:] = float(u1(np.float64(0.0))) * (1 - (np.arange(count) + 0.5) / count)
    full = mujoco.mjtState.mjSTATE_FULLPHYSICS
    start = np.empty(mujoco.mj_stateSize(model, full))
    mujoco.mj_getState(model, data, start, full)
    times, twice = np.arange(samples + 1) / RATE, 2 * count * k

    def solve():
        control = u1((np.arange(samples * substeps) + 0.5) * step)[:, None]
        states = rollout.rollout(model, data, start[None, :], control[None, :, :])[0][0, substeps - 1 :: substeps]
        first, last = (np.concatenate([[start[at]], states[:, at]]) for at in (1, count))
        return preload + twice * (first - u1(times)), preload - twice * last

    return solve


def error(name):
    """|rms(F_o - F_i) / reference - 1| over the chain's window; the reference by small steps of 0.1 us, good to 4e-4."""
    begin, end = CHAINS[name][-1]
    spring = {"valve": "valve", "contact": "S_A"}[name]
    with GOLDEN.open(encoding="utf-8") as file:
        rows = [row for row in csv.reader(file) if row[:3] == [spring, "0.0", "0.1"]]
    reference = next(float(row[7]) for row in rows if (float(row[3]), float(row[4])) == (begin, end))

    def of(forces):
        apart = (forces[1] - forces[0])[round(begin * RATE) : round(end * RATE)]
        return abs(math.sqrt(np.mean(apart**2)) / reference - 1)

    return of
