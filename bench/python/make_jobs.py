"""Writes the jobs of the benchmark and their references into a folder; no code of coilsense is used.

    python bench/python/make_jobs.py FOLDER [--check]

A folder that these very scripts have filled before is left as it is; --check fills it anew and checks more.

The contract of the files is in bench/README.md. Here: which jobs there are, and the files' writing.
Next door: the reference motion (reference_motion.py), the reference inductance (reference_inductance.py).
"""

import hashlib
import json
import sys
from pathlib import Path

import numpy as np

import reference_inductance
import reference_motion

ROOT = Path(__file__).resolve().parents[2]
# Table I of the paper, S_T (SI units).
SPRING = {
    "rest_length": 0.104,
    "windings": 52,
    "mass": 0.065,
    "stiffness": 760.0,
    "coil_radius": 0.008,
    "wire_radius": 0.001,
}
MIDDLE, LONGEST, SPAN = 0.23, 0.264, 0.068
RATE, DURATION, SAMPLES = 10_000, 1.0, 10_001
CHAINS = (52, 500, 5_000, 50_000)
STEPS = 10_000  # of the inductance job
DISTANCES, NEAREST, FARTHEST = 1_000_000, 1e-5, 1e4  # of the mutual job, as h/r
HELD = {"kind": "held"}


def motion(job, length, start, u1=HELD, windings=52):
    """A motion job; `start` is ((x at end 1, x at end 2), (v at end 1, v at end 2))."""
    return {
        "job": job,
        "kind": "motion",
        "spring": SPRING | {"windings": windings},
        "mean_length": length,
        "u1": u1,
        "start": {"position": list(start[0]), "velocity": list(start[1])},
        "rate": float(RATE),
        "duration": DURATION,
        "samples": SAMPLES,
        "reference": f"{job}.reference.f64",
    }


def recorded_input():
    """u1 [m] of the job `recorded`: a smooth random motion, 1 to 200 Hz, largest value 1 mm, from rest at zero."""
    draw = np.random.default_rng(3)
    times = np.arange(SAMPLES) / RATE
    hertz, phase = draw.uniform(1.0, 200.0, 40), draw.uniform(0.0, 2.0 * np.pi, 40)
    sines = np.sin(2.0 * np.pi * hertz * times[:, None] + phase).sum(axis=1)
    fade_in = 1.0 - np.exp(-((times / 0.02) ** 2))
    smooth = fade_in * sines
    return smooth * (1e-3 / np.abs(smooth).max())


def motion_jobs():
    impacts = [
        motion(f"impact-{n}" if n != 52 else "impact", MIDDLE, ((0.0, MIDDLE), (0.25, 0.25)), windings=n)
        for n in CHAINS
    ]
    # Eq. (3) of the paper, f = 1/(2 tau).
    frequency = 0.5 / float(np.sqrt(SPRING["mass"] / SPRING["stiffness"]))
    sine = {"kind": "harmonic", "amplitude": 68e-6, "frequency": frequency, "phase": -0.5 * np.pi}
    return [
        impacts[0],
        motion("end-stop", LONGEST, ((0.0, LONGEST), (0.0, SPAN))),
        # The massless start: between the ends as they are at t = 0, where u1 = -a and its velocity is zero.
        motion("resonance", MIDDLE, ((-68e-6, MIDDLE), (0.0, 0.0)), sine),
        motion("recorded", MIDDLE, ((0.0, MIDDLE), (0.0, 0.0)), {"kind": "sampled", "file": "recorded.u1.f64"}),
        *impacts[1:],
    ]


def inductance_job():
    return {
        "job": "inductance",
        "kind": "inductance",
        "spring": SPRING,
        # Eq. (10) as printed: half of rho e^(-1/4).
        "self_distance": 0.5 * SPRING["wire_radius"] * float(np.exp(-0.25)),
        "steps": STEPS,
        "positions": "inductance.positions.f64",
        "reference": "inductance.reference.f64",
        "reference_stride": 20,
    }


def mutual_job():
    return {
        "job": "mutual",
        "kind": "mutual",
        "coil_radius": SPRING["coil_radius"],
        "count": DISTANCES,
        "distances": "mutual.distances.f64",
        "reference": "mutual.reference.f64",
        "reference_stride": 500,
    }


def write(folder, name, *arrays):
    """Little-endian doubles, one array after the other."""
    joined = np.concatenate([np.asarray(array, dtype=np.float64).ravel() for array in arrays])
    joined.astype("<f8").tofile(folder / name)


def fingerprint():
    """Of the scripts that decide what is in the folder."""
    here = Path(__file__).parent
    names = ("make_jobs.py", "reference_motion.py", "reference_inductance.py", "requirements.txt")
    return hashlib.sha256(b"".join((here / name).read_bytes() for name in names)).hexdigest()


def main(folder, check):
    folder.mkdir(parents=True, exist_ok=True)
    stamp = folder / "made-by.sha256"
    if not check and stamp.exists() and stamp.read_text(encoding="utf-8") == fingerprint():
        return
    stamp.unlink(missing_ok=True)
    motions, coil, pairs = motion_jobs(), inductance_job(), mutual_job()
    u1 = recorded_input()
    write(folder, "recorded.u1.f64", u1)
    for job in motions:
        write(folder, job["reference"], *reference_motion.end_forces(job, u1))
        print("reference of", job["job"], file=sys.stderr)

    positions = reference_motion.winding_positions(motions[0])[1 : STEPS + 1]
    write(folder, coil["positions"], positions)
    write(folder, coil["reference"], reference_inductance.of_rows(coil, positions[:: coil["reference_stride"]]))

    radius = pairs["coil_radius"]
    distances = radius * np.logspace(np.log10(NEAREST), np.log10(FARTHEST), DISTANCES)
    write(folder, pairs["distances"], distances)
    write(folder, pairs["reference"], reference_inductance.reduced_mutual(distances[:: pairs["reference_stride"]], radius))

    (folder / "jobs.json").write_text(json.dumps([*motions, coil, pairs], indent=1) + "\n", encoding="utf-8")
    reference_motion.check_against_golden(motions, folder, ROOT / "crates" / "coilsense" / "tests" / "golden")
    if check:
        reference_motion.check_recorded_without_modes(motions[3], u1, folder)
    # Last, so that a folder with this file is a whole and checked one.
    stamp.write_text(fingerprint(), encoding="utf-8")


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    main(Path(sys.argv[1]), "--check" in sys.argv[2:])
