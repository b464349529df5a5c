"""Five kinds that were written when `identify` was finished, and on which nothing of it was tuned.

Next door: the kinds that it was tuned on (mount_kinds.py, channel_kinds.py, resonance_kinds.py, source_kinds.py).
"""

import numpy as np
from scipy import linalg, special

from channel_kinds import FORCES, sprung
from record import log_uniform
from resonance_kinds import finish, heard, sensors
from scene import modes_after_hits, scene
from source_kinds import harmonics, wander
from spring import spring_log


def spring_in_hum(rng):
    """A spring beside a drive: mains or a motor's orders on the force all the time, up to as large as the ringing."""
    spring, series = sprung(rng)
    happening = spring.scene
    frequency = (50.0, 60.0, rng.uniform(15, 80))[rng.integers(3)] * (1 + 1e-3 * wander(happening, 3.0))
    numbers = np.arange(1, 9)
    hum = harmonics(happening, frequency, numbers, np.exp(0.7 * rng.standard_normal(8)) / numbers)
    size = spring.peak * log_uniform(rng, 0.02, 1) / np.abs(hum).max()
    for name in series:
        if name in FORCES:
            series[name] = series[name] + size * rng.uniform(0.3, 1) * rng.choice([-1, 1]) * hum
    return spring_log(spring, "spring-in-hum", series)


def drifting_zero(rng):
    """A spring whose force amplifiers warm up: each channel's zero and gain creep, and jump once."""
    spring, series = sprung(rng)
    time = spring.scene.time
    for name in series:
        if name in FORCES:
            creep = spring.peak * log_uniform(rng, 0.1, 10) * rng.choice([-1, 1]) * (1 - np.exp(-time / rng.uniform(3, 30)))
            jump = spring.peak * log_uniform(rng, 0.01, 0.3) * (time > rng.uniform(2, 18))
            series[name] = series[name] * (1 + 0.01 * rng.standard_normal() * time / time[-1]) + creep + jump
    # What a gain off by under 1 % does to k is not what is asked here.
    return spring_log(spring, "drifting-zero", series, mass=None, stiffness=None)


def drive_train(rng):
    """Two to six inertias on shafts, one end held or none: the torque of one shaft or two after hits on any inertia."""
    count = int(rng.integers(2, 7))
    shafts = log_uniform(rng, 0.5, 2) * np.exp(0.6 * rng.standard_normal(count + 1))
    inertias = np.exp(0.7 * rng.standard_normal(count))
    if rng.random() < 0.5:
        shafts[0] = 0
    shafts[-1] = 0 if rng.random() < 0.5 else shafts[-1]
    stiffness = np.diag(shafts[:-1] + shafts[1:]) - np.diag(shafts[1:-1], 1) - np.diag(shafts[1:-1], -1)
    squares, shapes = linalg.eigh(stiffness, np.diag(inertias))
    elastic = squares > 1e-9 * squares[-1]
    frequencies = np.sqrt(squares[elastic])
    frequencies *= log_uniform(rng, 12, 120) / frequencies[0]
    # Torque of a shaft: its stiffness times the twist between its ends.
    padded = np.vstack([np.zeros(count), shapes, np.zeros(count)])[:, elastic]
    torques = shafts[:, None] * np.diff(padded, axis=0)
    used = np.flatnonzero(shafts)
    chosen = rng.choice(used, size=min(2, len(used)), replace=False)
    happening = scene(rng, frequencies[0])
    kept = frequencies < 0.38 * happening.rate
    frequencies, torques, shapes = frequencies[kept], torques[:, kept], shapes[:, elastic][:, kept]
    struck = rng.integers(count, size=len(happening.hits))
    rung = modes_after_hits(happening, frequencies, log_uniform(rng, 5e-4, 1.2e-2) * np.exp(0.4 * rng.standard_normal(len(frequencies))), shapes[struck])
    forces = {name: torques[chosen[min(place, len(chosen) - 1)]] @ rung for place, name in enumerate(sensors(rng))}
    size = log_uniform(rng, 0.5, 5) / max(np.abs(values).max() for values in forces.values())
    return finish(happening, "drive-train", {name: size * values for name, values in forces.items()})


def drum(rng):
    """A drum or a tank's lid: the zeros of Bessel functions, each but the rings a pair that is split a little.

    A pipe, a bar or a string that does not resist bending has a coil's own lines and is no kind here: lines do not tell them apart.
    """
    zeros = np.sort(np.concatenate([special.jn_zeros(order, 3) for order in range(5)]))[:11]
    split = log_uniform(rng, 1e-4, 1e-2)
    frequencies = log_uniform(rng, 20, 150) * np.sort(np.concatenate([zeros, zeros * (1 + split)])) / zeros[0]
    return heard(scene(rng, frequencies[0]), "drum", frequencies, log_uniform(rng, 5e-4, 1e-2) * np.exp(0.4 * rng.standard_normal(22)))


def run_down(rng):
    """A machine that is switched off at each hit: orders of a speed that falls, each dying out."""
    happening = scene(rng, 40, duration=25.0, hits=int(rng.integers(2, 5)))
    rate, time = happening.fine_rate, happening.time
    numbers = np.arange(1, 9)
    sizes = np.exp(0.6 * rng.standard_normal(8)) / numbers ** rng.uniform(0, 1)
    total = np.zeros(len(time))
    for start in happening.hits:
        since = np.maximum(time - start, 0)
        speed = rng.uniform(20, 100) * np.exp(-since / rng.uniform(2, 30))
        turns = 2 * np.pi * np.cumsum(speed * (time >= start)) / rate
        envelope = np.exp(-since / rng.uniform(0.2, 1.5)) * (time >= start)
        total += envelope * sum(size * np.sin(number * turns) for number, size in zip(numbers, sizes) if number < 0.38 * happening.rate / 100)
    total *= log_uniform(rng, 0.3, 5) / np.abs(total).max()
    return finish(happening, "run-down", {name: (rng.uniform(0.3, 1) * rng.choice([-1, 1]) if name == "F_o" else 1) * total for name in sensors(rng)})


SPRINGS = (spring_in_hum, drifting_zero)
STRANGERS = (drive_train, drum, run_down)
