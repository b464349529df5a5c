"""What happens in a log: its length and rates, the hits, the slow motion of end 1, and what is recorded.

Next door: what answers (assembly.py and the *_kinds.py), what instruments leave of it (record.py).
"""

from dataclasses import dataclass

import numpy as np
from scipy import signal

from assembly import held
from record import Instrument, Log, log_uniform

FINEST = 10_000.0  # Hz, at least, of the grid that signals are computed on


@dataclass
class Scene:
    """Random, but for what a kind asks of it."""

    rng: np.random.Generator
    rate: float  # of the log [Hz]
    factor: int  # samples of the fine grid per sample of the log
    duration: float  # s
    hits: np.ndarray  # when [s]
    sizes: np.ndarray  # 0.4 to 1, of either sign
    width: float  # of a hit [s]
    noise: float  # of a force sensor [N]
    noise_position: float  # m
    slow: tuple  # amplitude [m] and frequency [Hz] of the motion of end 1
    preload: float  # N

    @property
    def fine_rate(self):
        return self.rate * self.factor

    @property
    def time(self):
        """The fine grid [s]."""
        return np.arange(round(self.duration * self.fine_rate)) / self.fine_rate

    def pulse(self, number):
        """Hit `number` over the grid: half a sine of unit area [1/s]."""
        since = (self.time - self.hits[number]) / self.width
        shape = np.where((since > 0) & (since < 1), np.sin(np.pi * since), 0)
        return shape / (shape.sum() / self.fine_rate)

    def slow_motion(self):
        """Motion of end 1 [m] and its acceleration [m/s^2]."""
        amplitude, frequency = self.slow
        angular = 2 * np.pi * frequency
        motion = amplitude * np.sin(angular * self.time)
        return motion, -(angular**2) * motion

    def jerk(self, number, size, stays):
        """Motion of end 1 in hit `number`, by `size` [m] and there to stay, or there and back; and its acceleration."""
        since = np.clip((self.time - self.hits[number]) / self.width, 0, 1)
        sine, cosine = np.sin(np.pi * since), np.cos(np.pi * since)
        if stays:
            motion = since - np.sin(2 * np.pi * since) / (2 * np.pi)
            pull = 2 * np.pi * np.sin(2 * np.pi * since)
        else:
            motion, pull = sine**4, np.pi**2 * sine**2 * (12 * cosine**2 - 4 * sine**2)
        return size * motion, size / self.width**2 * pull

    def plain(self, name, **more):
        """A good instrument: white noise, and for forces a steep low-pass at 0.4 of the rate."""
        if not name.startswith("F"):
            return Instrument(**({"noise": self.noise_position} | more))
        return Instrument(**({"noise": self.noise, "filters": ((8, 0.4 * self.rate, "low"),)} | more))

    def log(self, series, truth, instruments=None, arguments=()):
        """The log of fine series by channel; a channel without an instrument of its own has a plain one."""
        columns = {}
        for name, values in series.items():
            instrument = (instruments or {}).get(name) or self.plain(name)
            columns[name] = instrument.record(values, self.fine_rate, self.factor, self.rng)
        return Log(self.rate, columns, truth, list(arguments))


def scene(rng, first, rate=None, duration=20.0, hits=None, width=None):
    """A scene for lines from `first` [Hz] upwards."""
    if rate is None:
        rates = [rate for rate in (1000.0, 2000.0, 2500.0, 2500.0, 2500.0, 5000.0) if rate > 14 * first]
        rate = rates[rng.integers(len(rates))] if rates else 5000.0
    factor = int(np.ceil(FINEST / rate))
    count = hits or int(rng.integers(4, 8))
    room = (duration - 1.5) / count
    times = 0.7 + room * (np.arange(count) + 0.4 * rng.random(count))
    width = width or min(rng.uniform(0.01, 0.12) / first, 0.0035)
    return Scene(
        rng,
        rate,
        factor,
        duration,
        times,
        rng.uniform(0.4, 1, count) * rng.choice([-1, 1], count),
        max(width, 6 / (rate * factor)),
        0.01 * rng.uniform(0.5, 2),
        1e-6 * rng.uniform(0.5, 3),
        (1e-3 * rng.uniform(0.5, 2), rng.uniform(0.1, 0.4)),
        rng.uniform(5, 60),
    )


def modes_after_hits(scene, frequencies, ratios, gains):
    """Lines that ring down: each mode's force after hits of unit size, shape modes x samples; gains has shape hits x modes."""
    pulses = np.array([scene.pulse(number) for number in range(len(scene.hits))])
    out = []
    for mode, (frequency, ratio) in enumerate(zip(frequencies, ratios)):
        numerator, denominator = held(2 * np.pi * frequency, ratio, scene.fine_rate)
        struck = (gains[:, mode] * scene.sizes) @ pulses
        out.append(2 * np.pi * frequency * signal.lfilter(numerator, denominator, struck))
    return np.array(out)


def zeta_law(rng, first):
    """A spring's damping ratio over frequency [Hz], and its name: the same for all modes, viscous, of the material, or scattered."""
    base = log_uniform(rng, 5e-4, 1.2e-2)
    name = ("constant", "viscous", "material", "scattered")[rng.integers(4)]
    scatter = np.exp(0.25 * rng.standard_normal(400))
    if name == "material":
        base = min(base, 4e-3)
    laws = {
        "constant": lambda f: base + 0 * f,
        "viscous": lambda f: base * first / f + 2e-4,  # no spring is without a loss of its own
        "material": lambda f: np.minimum(base * np.maximum(f / first, 0.2), 0.2),
        "scattered": lambda f: base * scatter[np.minimum(np.rint(f / first).astype(int), 399)],
    }
    return laws[name], name
