"""A sweep that the tests share: S_T hit and shaken, one damping, quick columns."""

import pathlib

import coilsense

SPEC = """
[spring]
name = "S_T"
model = "chain"
rest_length = "104 mm"
windings = 52
coil_radius = "8 mm"
wire_radius = "1 mm"
mass = "65 g"
stiffness = "760 N/m"
min_length = "196 mm"
max_length = "264 mm"

[mount]
damping_ratio = 0.005

[[condition]]
name = "heel strike"
kind = "impact"
length = "mid"
velocity = "0.25 m/s"
duration = "1 s"
window = ["0.75 s", "1 s"]
sample_rate = "10 kHz"

[[condition]]
name = "shaken"
kind = "harmonic"
frequency = "20 Hz"
amplitude = "1 %"
duration = "1 s"
window = ["0.75 s", "1 s"]
sample_rate = "10 kHz"
"""

OVER = {"spring.stiffness": "600..900 N/m", "spring.mass": "uniform(50, 80 g)"}
COLUMNS = ["f1", "F_o.rmsd", "F_i.max[heel strike]"]


def files(folder: pathlib.Path) -> dict[str, bytes]:
    """Every chunk's bytes by name."""
    return {path.name: path.read_bytes() for path in sorted(folder.glob("chunk-*.parquet"))}


def whole(folder: pathlib.Path, rows: int, chunk: int) -> coilsense.SweepDataset:
    """The sweep in a folder, here."""
    return coilsense.sweep(SPEC, OVER, folder, rows=rows, chunk=chunk, columns=COLUMNS, seed=7)
