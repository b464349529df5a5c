"""The clock, the judgement and one JSON line per measurement; the contract is in bench/README.md."""

import json
import sys
import time
from pathlib import Path

import numpy as np

PATIENCE = 20.0  # a run expected to last longer is not made [s]
SHARE = 2.0  # time given to the runs of one row [s]
LONG_RUN = SHARE / 5  # of a run that takes longer, fewer than five will do [s]
MOST_RUNS = 1000


def read_jobs(folder):
    """The jobs, with each file's name replaced by what is in it."""
    jobs = json.loads((Path(folder) / "jobs.json").read_text(encoding="utf-8"))
    for job in jobs:
        for key in ("reference", "positions", "distances"):
            if key in job:
                job[key] = np.fromfile(Path(folder) / job[key], dtype="<f8")
        if job["kind"] == "motion":
            job["reference"] = job["reference"].reshape(2, -1)
            job["times"] = np.arange(job["samples"]) / job["rate"]
            if job["u1"]["kind"] == "sampled":
                job["u1"]["samples"] = np.fromfile(Path(folder) / job["u1"]["file"], dtype="<f8")
    return jobs


def drive(job):
    """u1 [m] as a function of time."""
    u1 = job["u1"]
    if u1["kind"] == "held":
        return lambda t: 0.0 * t
    if u1["kind"] == "harmonic":
        amplitude, omega, phase = u1["amplitude"], 2 * np.pi * u1["frequency"], u1["phase"]
        return lambda t: amplitude * np.sin(omega * t + phase)
    return lambda t: np.interp(t, job["times"], u1["samples"])


def static_force(job):
    """F_x [N] of the spring without mass for a displacement u1 [m] of end 1."""
    spring = job["spring"]
    return lambda u1: spring["stiffness"] * (job["mean_length"] - u1 - spring["rest_length"])


def motion_error(job):
    """max |F - F_ref| over max |F_ref - F_x|, the worse of both ends."""

    def error(forces):
        static = static_force(job)(drive(job)(job["times"]))
        ends = zip(forces, job["reference"])
        return max(float(np.abs(f - r).max() / np.abs(r - static).max()) for f, r in ends)

    return error


def value_error(job):
    """max |value / reference - 1| over the values that have a reference."""
    return lambda values: float(np.abs(values[:: job["reference_stride"]] / job["reference"] - 1).max())


def timed(solve):
    """Median duration [s], number of runs, last answer."""

    def once():
        begun = time.perf_counter()
        answer = solve()
        return time.perf_counter() - begun, answer

    warm_up, answer = once()
    if warm_up > SHARE:
        return warm_up, 1, answer
    least, times = (1 if warm_up > LONG_RUN else 5), []
    while len(times) < least or (sum(times) + warm_up < SHARE and len(times) < MOST_RUNS):
        seconds, answer = once()
        times.append(seconds)
    return sorted(times)[len(times) // 2], len(times), answer


class Bench:
    def __init__(self, only):
        self.only = only
        self.seen = {}  # last duration [s] and N of a peer in jobs that differ by N alone

    def wanted(self, job, system, setting):
        return self.only is None or any(self.only in part for part in (job["job"], system, setting))

    def row(self, job, system, setting, prepare, error, growth=0.0, remark=""):
        """Times `prepare()()` but for `prepare` itself, judges the answer by `error`, prints the row.

        The peer's time grows with N to the power `growth`.
        """
        if not self.wanted(job, system, setting):
            return
        print(job["job"], system, setting, file=sys.stderr)
        key = (system, setting, job["job"].rstrip("-0123456789"))
        size = job.get("spring", {}).get("windings", 1)
        answer = {"job": job["job"], "system": system, "setting": setting, "median_ms": None, "max_rel_error": None}
        if key in self.seen:
            seconds, before = self.seen[key]
            expected = seconds * (size / before) ** growth
            if expected > PATIENCE:
                note = f"skipped: about {expected:.0f} s expected, from N = {before} and time as N^{growth:g}"
                return self.emit(answer | {"note": note})
        try:
            seconds, runs, result = timed(prepare())
        except Exception as failure:  # a peer's failure is a row, not the end of the run
            return self.emit(answer | {"note": f"failed: {type(failure).__name__}: {failure}"})
        self.seen[key] = (seconds, size)
        note = "; ".join(part for part in (f"{runs} run{'s' if runs > 1 else ''}", remark) if part)
        worst = error(result)
        # JSON knows no infinity and no NaN.
        answer |= {"median_ms": 1e3 * seconds, "max_rel_error": worst if np.isfinite(worst) else None}
        self.emit(answer | {"note": note + ("" if np.isfinite(worst) else "; the answer is not finite")})

    @staticmethod
    def emit(row):
        print(json.dumps(row), flush=True)
