#!/usr/bin/env python3
"""Writes road-c-20mps.csv: height of an ISO 8608 class C road under a wheel at 20 m/s, as a sum of sines with random phases.

    python3 examples/road.py

Gives the same file each time (Python's own generator, seeded); needs nothing but the standard library.
Displacement spectrum G_d(n) = G_d(n0) (n/n0)^-2, ISO 8608: class C has G_d(n0) = 256e-6 m3 at n0 = 0.1 cycles/m.
"""
import math
import pathlib
import random

G_N0, N0 = 256e-6, 0.1  # [m3], [cycles/m]
N_MIN, N_MAX = 0.011, 2.83  # [cycles/m], the band of ISO 8608; 0.22 Hz to 56.6 Hz at 20 m/s
SPEED, DURATION, RATE, SEED = 20.0, 10.0, 1000, 1  # [m/s], [s], [Hz]
FADE_IN = 1.0  # [s]; the road rises out of a plane, so that neither height nor velocity jumps at t = 0

step = 1 / (SPEED * DURATION)  # [cycles/m]; no sine repeats together with the others before the file ends
rng = random.Random(SEED)
sines = []  # (amplitude [m], phase [rad], angular frequency [rad/s])
for i in range(int((N_MAX - N_MIN) / step)):
    n = N_MIN + (i + 0.5) * step
    amplitude = math.sqrt(2 * G_N0 * (n / N0) ** -2 * step)
    sines.append((amplitude, rng.uniform(0, 2 * math.pi), 2 * math.pi * n * SPEED))


def fade(t):
    """From 0 to 1 over FADE_IN, velocity and acceleration zero at both ends."""
    s = min(t / FADE_IN, 1.0)
    return s**3 * (10 - 15 * s + 6 * s**2)


lines = [
    "# generated: ISO 8608 class C, 20 m/s, seed 1, by road.py",
    "# height of the wheel on a rigid tyre, as a sum of 563 sines; not a measurement",
    "time [s],u1 [mm]",
]
for i in range(int(DURATION * RATE) + 1):
    t = i / RATE
    height = fade(t) * sum(a * math.sin(w * t + p) for a, p, w in sines) + 0.0  # no "-0"
    lines.append(f"{t:g},{1000 * height:.4g}")
pathlib.Path(__file__).with_name("road-c-20mps.csv").write_text("\n".join(lines) + "\n")
print(len(sines), "sines,", len(lines) - 3, "rows")
