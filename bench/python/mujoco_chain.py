"""MuJoCo: one body on a slide joint per winding, fixed tendons as springs between them, joint springs at the ends.

The joints' zero is the uniform chain at rest, so that only changes are simulated. u1 acts as a force 2Nk u1 on the first
joint, held over a step at its value in the middle. `mujoco.rollout` runs all steps without returning to Python.
"""

import mujoco
import numpy as np
from mujoco import rollout

from measure import drive
from scipy_motion import start_line


def model_text(job, step):
    spring, n = job["spring"], job["spring"]["windings"]
    k, mass = n * spring["stiffness"], spring["mass"] / n

    def body(i):
        end = f' stiffness="{2 * k!r}"' if i in (0, n - 1) else ""
        inertial = f'<inertial pos="0 0 0" mass="{mass!r}" diaginertia="1e-6 1e-6 1e-6"/>'
        return f'<body>{inertial}<joint name="j{i}" type="slide" axis="1 0 0"{end}/></body>'

    def tendon(i):
        sides = f'<joint joint="j{i}" coef="-1"/><joint joint="j{i + 1}" coef="1"/>'
        return f'<fixed stiffness="{k!r}">{sides}</fixed>'

    motor = f'<motor joint="j0" gear="{2 * k!r}"/>'
    return f"""<mujoco><option timestep="{step!r}" integrator="RK4" gravity="0 0 0">
        <flag contact="disable" constraint="disable"/></option>
        <worldbody>{"".join(map(body, range(n)))}</worldbody>
        <tendon>{"".join(map(tendon, range(n - 1)))}</tendon><actuator>{motor}</actuator></mujoco>"""


def simulation(job, substeps):
    """A function that simulates with `substeps` steps per sample and returns the end forces."""
    spring, n, times = job["spring"], job["spring"]["windings"], job["times"]
    step = 1 / job["rate"] / substeps
    model = mujoco.MjModel.from_xml_string(model_text(job, step))
    data = mujoco.MjData(model)
    data.qpos[:] = start_line(job, job["start"]["position"]) - start_line(job, (0.0, job["mean_length"]))
    data.qvel[:] = start_line(job, job["start"]["velocity"])
    full = mujoco.mjtState.mjSTATE_FULLPHYSICS
    start = np.empty(mujoco.mj_stateSize(model, full))
    mujoco.mj_getState(model, data, start, full)
    u1, twice = drive(job), 2 * n * spring["stiffness"]
    preload = spring["stiffness"] * (job["mean_length"] - spring["rest_length"])
    steps = (job["samples"] - 1) * substeps

    def solve():
        control = u1((np.arange(steps) + 0.5) * step)[:, None]
        states = rollout.rollout(model, data, start[None, :], control[None, :, :])[0][0, substeps - 1 :: substeps]
        # A state is time, positions, velocities.
        first, last = (np.concatenate([[start[at]], states[:, at]]) for at in (1, n))
        return preload + twice * (first - u1(times)), preload - twice * last

    return solve
