#!/usr/bin/env python3
"""Writes cam-6000rpm.csv: lift of a valve over 15 turns of the camshaft at 6000 rpm of the engine (50 Hz of the camshaft).

    python3 examples/cam.py

Law: the 3-4-5-6 polynomial h 64 x^3 (1 - x)^3, x from 0 to 1 over the time that the valve is open: lift, velocity and acceleration are
continuous everywhere, so are all derivatives at the nose. 260 degrees of the crankshaft open, as 130 of the camshaft.
Needs nothing but the standard library; nothing in it is random.
"""
import pathlib

LIFT = 10.0  # [mm]
TURN = 0.02  # [s]
OPEN = 130 / 360  # share of a turn
TURNS, RATE = 15, 20000  # [Hz]


def lift(t):
    """Lift [mm]; the valve opens a quarter of a turn after t = 0."""
    x = (t / TURN % 1 - 0.25) / OPEN
    return LIFT * 64 * (x * (1 - x)) ** 3 if 0 < x < 1 else 0.0


lines = [
    "# generated: 3-4-5-6 polynomial, lift 10 mm over 130 degrees of a camshaft at 50 Hz, by cam.py; not a measurement",
    "# u1 is the valve's lift: the spring's upper end moves towards the lower one",
    "time [s],u1 [mm]",
]
for i in range(round(TURNS * TURN * RATE) + 1):
    lines.append(f"{i / RATE:g},{lift(i / RATE):.6g}")
pathlib.Path(__file__).with_name("cam-6000rpm.csv").write_text("\n".join(lines) + "\n")
print(len(lines) - 3, "rows")
