"""The Python peers of coilsense's benchmark: peers.py FOLDER [--only WORD]. The contract is in bench/README.md."""

import os

# One thread, as coilsense: before NumPy is loaded, for its BLAS reads this once.
for library in ("OMP", "OPENBLAS", "MKL"):
    os.environ[f"{library}_NUM_THREADS"] = "1"

import importlib  # noqa: E402
import math  # noqa: E402
import sys  # noqa: E402

from measure import Bench, motion_error, read_jobs, value_error  # noqa: E402


def library(name):
    """A module of this folder, or the failure that its library gives."""
    try:
        return importlib.import_module(name)
    except Exception as failure:
        return failure


def from_library(module, make):
    """`make(module)`, or the import's failure raised where it becomes a row."""

    def prepare():
        if isinstance(module, Exception):
            raise module
        return make(module)

    return prepare


MODULES = {name: library(name) for name in ("numpy_modal", "scipy_motion", "mujoco_chain", "mujoco_contact", "exudyn_chain", "rings")}

DOP853 = {"method": "DOP853", "rtol": 1e-9, "atol": 1e-12}
TWO_LEVELS = "phasors on two levels"
JOINTS = "slide joints, fixed tendons, rollout"
MASSES = "Mass1D, CoordinateSpringDamper"
# system, setting, module, what makes the solve from module and job, growth of time with N, remark
MOTION = [
    ("NumPy", "modal sum, matrix product", "numpy_modal", lambda m, j: lambda: m.end_forces(j), 1.0, TWO_LEVELS),
    ("SciPy", "signal.lsim", "scipy_motion", lambda m, j: m.linear_simulation(j), 2.5, "first-order hold"),
    ("SciPy", "solve_ivp, default", "scipy_motion", lambda m, j: lambda: m.integrated(j), 1.5, "RK45, rtol 1e-3"),
    ("SciPy", "solve_ivp, DOP853 1e-9", "scipy_motion", lambda m, j: lambda: m.integrated(j, **DOP853), 1.5, ""),
    ("MuJoCo", "RK4, step 10 us", "mujoco_chain", lambda m, j: m.simulation(j, 10), 2.0, JOINTS),
    ("Exudyn", "RK67, step 33 us", "exudyn_chain", lambda m, j: m.simulation(j, "RK67", 3), 2.0, MASSES),
]
# Step [us], steps a sample, limits' settings, remark. The hardest contact that MuJoCo takes has a time constant of two steps.
HARDEST = 'solreflimit="{} 1" solimplimit="0.99 0.99 0.001"'
SOFT_CONTACT = [
    ("RK4, step 20 us, contact as it is", 1, "", "solref 0.02 s, solimp 0.9 to 0.95"),
    ("RK4, step 20 us, hardest contact", 1, HARDEST.format(40e-6), "solref 40 us, solimp 0.99"),
    ("RK4, step 5 us, hardest contact", 4, HARDEST.format(10e-6), "solref 10 us, solimp 0.99"),
]
RINGS = ("eq. 8, ellipkm1 and ellipe", "elliprd, no cancellation")


def motion(bench, job):
    for system, setting, name, make, growth, remark in MOTION:
        prepare = from_library(MODULES[name], lambda module, make=make: make(module, job))
        bench.row(job, system, setting, prepare, motion_error(job), growth, remark)


def inductance(bench, job):
    for setting in RINGS:
        prepare = from_library(MODULES["rings"], lambda m, s=setting: lambda: m.inductance(job, m.KERNELS[s]))
        bench.row(job, "SciPy", setting, prepare, value_error(job), remark="sum over pairs i < j by arrays")


def mutual(bench, job):
    radius, distances = job["coil_radius"], job["distances"]
    whole = job | {"reference": job["reference"] * (4e-7 * math.pi * radius)}
    for setting in RINGS:
        prepare = from_library(MODULES["rings"], lambda m, s=setting: lambda: m.KERNELS[s](radius, distances))
        bench.row(job, "SciPy", setting, prepare, value_error(whole))


def contact(bench):
    """Windings that meet: chains of the job's own, no file of the folder."""
    for job in ("valve", "contact"):
        for setting, substeps, limit, remark in SOFT_CONTACT:
            make = lambda m, n=substeps, limit=limit, job=job: m.simulation(job, n, limit)  # noqa: E731
            error = lambda forces, job=job: MODULES["mujoco_contact"].error(job)(forces)  # noqa: E731
            bench.row({"job": job}, "MuJoCo", setting, from_library(MODULES["mujoco_contact"], make), error, remark=remark)


def main(folder, only):
    bench = Bench(only)
    for job in read_jobs(folder):
        {"motion": motion, "inductance": inductance, "mutual": mutual}[job["kind"]](bench, job)
    contact(bench)


if __name__ == "__main__":
    if len(sys.argv) not in (2, 4) or (len(sys.argv) == 4 and sys.argv[2] != "--only"):
        sys.exit(__doc__)
    main(sys.argv[1], sys.argv[3] if len(sys.argv) == 4 else None)
