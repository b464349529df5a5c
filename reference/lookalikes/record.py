"""A log with its truth: what the instruments leave of signals that are known finely, and the CSV that `coilsense identify` reads.

Next door: the signals (scene.py, assembly.py), the kinds of log (*_kinds.py).
"""

import math
from dataclasses import dataclass, field

import numpy as np
from scipy import signal

COLUMNS = {"u1": "u1 [m]", "u2": "u2 [m]", "F_i": "F_i [N]", "F_o": "F_o [N]"}


@dataclass
class Truth:
    """What is true of a log. `first` [Hz] is that of the spring with both ends held, undamped; `others` [Hz] are as right as it."""

    kind: str
    is_spring: bool
    first: float | None = None
    others: tuple = ()
    mass: float | None = None  # kg; none where a chain of few masses leaves open what it is
    stiffness: float | None = None  # N/m; none where no position was recorded
    zeta: float | None = None  # of the lowest mode with both ends held
    turned: str = ""  # the channel whose sign is turned


@dataclass
class Log:
    """Columns by channel, their rate, the truth, and arguments that the command is given beside the log."""

    rate: float
    columns: dict
    truth: Truth
    arguments: list = field(default_factory=list)

    def write(self, path):
        """As CSV, nine significant digits."""
        names = [name for name in COLUMNS if name in self.columns]
        rows = len(self.columns[names[0]])
        table = np.column_stack([np.arange(rows) / self.rate] + [self.columns[name] for name in names])
        line = ",".join(["%.9g"] * table.shape[1]) + "\n"
        with open(path, "w", encoding="ascii", newline="\n") as file:
            file.write(",".join(["t [s]"] + [COLUMNS[name] for name in names]) + "\n")
            file.write("".join(line % tuple(row) for row in table.tolist()))


@dataclass
class Instrument:
    """One channel from its sensor to the log, in the order in which it is applied."""

    noise_before: float = 0.0  # standard deviation ahead of the filters, per sample of the fine series
    filters: tuple = ()  # (order, corner [Hz], "low" or "high") of Butterworth filters
    delay: float = 0.0  # s
    update_rate: float | None = None  # Hz at which the device has a new value; none: at every sample
    noise: float = 0.0  # standard deviation per new value
    limits: tuple | None = None  # the least and largest value that it shows
    step: float = 0.0  # what its last digit is worth
    sign: float = 1.0

    def record(self, fine, fine_rate, factor, rng):
        """The log's samples, every `factor`th of the fine ones."""
        values = np.asarray(fine, float)
        if self.noise_before:
            values = values + self.noise_before * rng.standard_normal(len(values))
        for order, corner, kind in self.filters:
            values = filtered(values, order, corner, kind, fine_rate)
        moments = np.arange(0, len(values), factor)
        if self.update_rate:
            own = self.update_rate / fine_rate
            ticks = np.floor(moments * own + rng.random())
            moments, back = (ticks - ticks[0]) / own, None
            new, back = np.unique(moments, return_inverse=True)
        else:
            new, back = moments, slice(None)
        values = np.interp(new - self.delay * fine_rate, np.arange(len(values)), values)
        values = values + self.noise * rng.standard_normal(len(values))
        if self.limits:
            values = np.clip(values, *self.limits)
        if self.step:
            values = self.step * np.round(values / self.step)
        return self.sign * values[back]


def filtered(values, order, corner, kind, rate):
    """Through a Butterworth filter that has seen the first value for ever."""
    sections = signal.butter(order, corner, kind, fs=rate, output="sos")
    start = signal.sosfilt_zi(sections) * values[0]
    return signal.sosfilt(sections, values, zi=start)[0]


def log_uniform(rng, low, high):
    """A number whose logarithm is uniform."""
    return math.exp(rng.uniform(math.log(low), math.log(high)))
