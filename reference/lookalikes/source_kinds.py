"""No spring: what machines, mains, voices and instruments put on a force. Lines that stay, swell, or move with a speed.

Next door: structures that ring after hits (resonance_kinds.py).
"""

import numpy as np
from scipy import signal

from record import log_uniform
from resonance_kinds import finish, sensors
from scene import scene


def wander(happening, seconds):
    """Slow noise of unit size."""
    rng, rate = happening.rng, happening.fine_rate
    count = int(happening.duration / seconds) + 4
    knots = rng.standard_normal(count)
    return np.interp(happening.time, np.arange(count) * happening.duration / (count - 3), knots)


def harmonics(happening, frequency, numbers, sizes):
    """Multiples of a frequency over time [Hz], with phases of their own; nothing above half of the fine rate."""
    turns = 2 * np.pi * np.cumsum(frequency) / happening.fine_rate
    phases = happening.rng.uniform(0, 2 * np.pi, len(numbers))
    out = 0 * turns
    for number, size, phase in zip(numbers, sizes, phases):
        if number * frequency.max() < 0.4 * happening.fine_rate:
            out += size * np.sin(number * turns + phase)
    return out


def bursts(happening, least, most):
    """An envelope that opens at each hit for some time [s] and closes with a tail."""
    rng, envelope = happening.rng, np.zeros(len(happening.time))
    for start in happening.hits:
        since, length, tail = happening.time - start, rng.uniform(least, most), log_uniform(rng, 0.01, 0.3)
        opened = np.clip(since / 0.02, 0, 1) * np.where(since < length, 1, np.exp(-np.maximum(since - length, 0) / tail))
        envelope = np.maximum(envelope, opened)
    return envelope


def two(happening, kind, values):
    """One or both sensors hear it, each with its own gain."""
    rng = happening.rng
    values = values * log_uniform(rng, 0.05, 5) / max(np.abs(values).max(), 1e-12)
    other = rng.uniform(0.3, 1) * rng.choice([-1, 1])
    return finish(happening, kind, {name: values * (other if name == "F_o" else 1) for name in sensors(rng)})


def mains_hum(rng):
    """50 or 60 Hz and multiples, their size wandering; in half of the logs switched on and off."""
    happening = scene(rng, 50)
    frequency = (50.0, 60.0)[rng.integers(2)] + 0.03 * wander(happening, 3.0)
    numbers = np.arange(1, 16)
    sizes = np.exp(0.7 * rng.standard_normal(15)) / numbers * np.where(numbers % 2, 1, rng.uniform(0.1, 1))
    hum = harmonics(happening, frequency, numbers, sizes) * (1 + 0.15 * wander(happening, 2.0))
    if rng.random() < 0.5:
        hum = hum * bursts(happening, 0.3, 2.0)
    return two(happening, "mains-hum", hum)


def motor(rng):
    """A motor whose speed climbs, or starts at each hit: cogging at orders of its speed, and the fixed tone of its PWM with side bands."""
    happening = scene(rng, 40)
    low, high = rng.uniform(3, 15), rng.uniform(15, 60)
    speed = low + (high - low) * (0.5 - 0.5 * np.cos(2 * np.pi * happening.time / happening.duration * rng.uniform(0.5, 3)))
    starts = rng.random() < 0.5
    envelope = bursts(happening, 0.3, 1.5) if starts else np.ones(len(happening.time))
    if starts:
        speed = 2 + high * envelope * rng.uniform(0.5, 1)
    poles = int(rng.choice([2, 4, 6, 7, 12]))
    numbers = np.array([1, 2, poles, 2 * poles, 3 * poles, 6 * poles])
    cogging = harmonics(happening, speed, numbers, np.exp(0.6 * rng.standard_normal(6)) * (speed.mean() / 30))
    tone = harmonics(happening, np.full(len(speed), log_uniform(rng, 120, 900)), np.array([1, 2]), np.array([1.0, 0.4]))
    return two(happening, "motor", (cogging + rng.uniform(0, 1) * tone * (1 + 0.5 * cogging / np.abs(cogging).max())) * envelope)


def speech(rng):
    """Bursts of a voice: pulses at a pitch that glides, through formants, or noise through them."""
    happening = scene(rng, 60, duration=20.0, hits=7)
    pitch = log_uniform(rng, 80, 220) * (1 + 0.1 * wander(happening, 0.4)) * (1 + 0.01 * wander(happening, 0.05))
    turns = np.cumsum(pitch) / happening.fine_rate
    voice = np.diff(np.floor(turns), prepend=0.0) + (0.02 + 0.1 * rng.random()) * rng.standard_normal(len(turns))
    out = 0.0
    for formant in (rng.uniform(250, 800), rng.uniform(800, 2000)):
        out = out + signal.sosfilt(signal.butter(1, [0.9 * formant, 1.1 * formant], "band", fs=happening.fine_rate, output="sos"), voice)
    return two(happening, "speech", out * bursts(happening, 0.15, 0.8))


def noise(rng):
    """White noise, noise that falls with frequency, or a random walk; clicks without ringing in half of the logs."""
    happening = scene(rng, 60)
    values = rng.standard_normal(len(happening.time))
    colour = rng.integers(3)
    if colour == 1:
        values = signal.sosfilt(signal.butter(1, log_uniform(rng, 2, 200), fs=happening.fine_rate, output="sos"), values)
    elif colour == 2:
        values = np.cumsum(values)
    values = values / values.std()
    if rng.random() < 0.5:
        pulses = np.array([happening.pulse(number) for number in range(len(happening.hits))])
        values = values + rng.uniform(5, 50) * happening.width * happening.sizes @ pulses
    return two(happening, "noise", values)


def pump(rng):
    """A pump or fan that starts at each hit and runs down: multiples of its blades' rate, which falls as they die out."""
    happening = scene(rng, 40, hits=int(rng.integers(3, 6)))
    first = log_uniform(rng, 20, 120)
    speed, size = np.full(len(happening.time), first), np.zeros(len(happening.time))
    slows, dies = log_uniform(rng, 0.002, 0.2), log_uniform(rng, 0.1, 1.0)
    for start in happening.hits:
        since = happening.time - start
        speed = np.where(since > 0, first * np.exp(-slows * since), speed)
        size = np.where(since > 0, np.clip(since / 0.003, 0, 1) * np.exp(-since / dies), size)
    numbers = np.arange(1, 9)
    wave = harmonics(happening, speed, numbers, np.exp(0.5 * rng.standard_normal(8)) / numbers ** rng.uniform(0.3, 1.5))
    return two(happening, "pump", wave * size)


KINDS = (mains_hum, motor, speech, noise, pump)
