"""How much faster two Dask workers are than one, on a sweep of at least half a minute: the same chunks, each worker one thread.

`cargo xtask bench --dask` runs it where the wheel is installed with its extra "dask"; by hand: `python bench/python/dask_sweep.py [ROWS]`. Prints a line of
JSON for each number of workers.
"""

import json
import pathlib
import sys
import tempfile
import time

import distributed

import coilsense

SPEC = pathlib.Path(__file__).parents[2] / "examples" / "sea-ankle.toml"
OVER = {"spring.stiffness": "600..900 N/m", "spring.mass": "50..80 g", "mount.damping_ratio": "log 1e-3..5e-2"}
COLUMNS = ["f1", "F_i.rmsd", "F_o.rmsd", "F_L.rmsd"]


def seconds(workers: int, rows: int) -> float:
    """Of a sweep on so many workers of one thread each, once they have warmed up."""
    options = {"n_workers": workers, "threads_per_worker": 1, "processes": True, "dashboard_address": None}
    with distributed.LocalCluster(**options) as cluster, distributed.Client(cluster) as client:
        for name, count in (("warm", 64 * workers), ("timed", rows)):
            with tempfile.TemporaryDirectory() as folder:
                begun = time.perf_counter()
                coilsense.sweep(SPEC, OVER, f"{folder}/{name}", rows=count, chunk=32, columns=COLUMNS, client=client)
                elapsed = time.perf_counter() - begun
    return elapsed


def main() -> None:
    rows = int(sys.argv[1]) if len(sys.argv) > 1 else 8000
    for workers, setting in ((1, "1 worker"), (2, "2 workers")):
        measurement = {
            "job": "sweep on Dask",
            "system": "coilsense",
            "setting": setting,
            "median_ms": 1e3 * seconds(workers, rows),
            "max_rel_error": None,
            "note": f"{rows} designs with F_L under five conditions",
        }
        print(json.dumps(measurement), flush=True)


if __name__ == "__main__":
    main()
