"""Writes specimens.csv: S_T driven near its first surge frequency, over springs within a tolerance of the rate, by specimens.py.

    python specimens_s_t.py

One load cell at end 2 with 0.1 % of full scale; a sine of 0.5 % of the range, start massless, judged from 3 s to 4 s; zeta 0.005.
"""

import math
import platform

import numpy as np
import scipy

from specimens import judge
from golden import LAB

CASES = [(0.5, 0.1), (0.8, 0.1), (0.9, 0.1), (0.93, 0.1), (0.95, 0.1), (0.94, 0.08), (0.96, 0.05), (1.07, 0.1), (1.0, 0.1), (1.9, 0.1), (0.95, 0.0)]
F1 = 0.5 * math.sqrt(760 / 0.065)


def spec(frequency, tolerance):
    """The spec of a case, as specimens.py has it."""
    return {
        "spring": {"windings": 52, "stiffness_tolerance": tolerance, "rest_length": 0.104},
        "k": 760.0,
        "m": 0.065,
        "mount": {"end2": "held", "damping_ratio": [0.005]},
        "condition": [
            {"name": "sine", "kind": "harmonic", "end": 1, "frequency": frequency * F1, "amplitude": 0.005 * 0.068, "phase": 0.0,
             "start": "massless", "duration": 4.0, "window": [3.0, 4.0], "sample_rate": 10000.0, "length": 0.23}
        ],
        "sensor": [{"name": "cell", "kind": "load-cell", "end": 2, "range": 121.6, "accuracy_full_scale": 0.001}],
        "goal": {"error": 0.05 * 121.6, "force": "F_x"},
    }  # fmt: skip


def main():
    tools = f"Python {platform.python_version()}, NumPy {np.__version__}, SciPy {scipy.__version__}"
    rows = [f"# {tools}; standard error of an rms below 0.5 %; specimens_s_t.py: chain by an eigen-solver, Monte Carlo over springs"]
    rows.append("frequency [f1],tolerance [1],rms [N],share inside [1],worst [N],nominal oscillation [N]")
    for frequency, tolerance in CASES:
        (found,) = judge(spec(frequency, tolerance), 52, 1).values()
        values = [found[key] for key in ("rms", "share", "worst", "nominal")]
        rows.append(",".join([f"{frequency}", f"{tolerance}", *(f"{value:.5g}" for value in values)]))
    (LAB / "specimens.csv").write_text("\n".join(rows) + "\n")


if __name__ == "__main__":
    main()
