"""A plain spring through channels that are not plain: a sign turned, filters, too few samples, held, coarse, clipped or late values; and
a hint that the log contradicts.

Next door: springs on other mounts (mount_kinds.py), the channels themselves (record.py).
"""

import numpy as np

from record import log_uniform
from spring import blows, chosen, plain, rig, simulate, spring_log

FORCES = ("F_i", "F_o")


def sprung(rng, forces=None, positions=None, **options):
    """A plain spring and its chosen series."""
    spring = rig(rng, **options)
    built = plain(spring)
    forces = forces or ("both", "one")[rng.integers(2)]
    return spring, chosen(rng, simulate(spring, built, *blows(spring, built)), forces, positions)


def instruments(spring, series, **more):
    """The same instrument for each force: a good one but for what is said."""
    return {name: spring.scene.plain(name, **more) for name in series if name in FORCES}


def ringing(series):
    """Half of how far the forces swing [N], per channel."""
    return {name: 0.5 * np.ptp(values) for name, values in series.items() if name in FORCES}


def sign_turned(rng):
    """One of F_i, F_o (both recorded) or u1 has the wrong sign."""
    turned = ("F_i", "F_o", "F_i", "F_o", "u1")[rng.integers(5)]
    spring, series = sprung(rng, "both", (["u1"], ["u1", "u2"])[rng.integers(2)])
    return spring_log(spring, "sign-turned", series, {turned: spring.scene.plain(turned, sign=-1)}, turned=turned)


def low_passed(rng):
    """The amplifiers' Butterworth low-pass lies between 0.6 and 10 f1; little noise comes in behind it."""
    spring, series = sprung(rng)
    corner = min(log_uniform(rng, 0.6, 10) * spring.first, 0.4 * spring.scene.rate)
    filters = ((int(rng.choice([2, 4, 8])), corner, "low"),)
    noises = {"noise_before": 2 * spring.scene.noise, "noise": spring.scene.noise * log_uniform(rng, 1e-3, 0.3)}
    return spring_log(spring, "low-passed", series, instruments(spring, series, filters=filters, **noises))


def high_passed(rng):
    """The amplifiers are coupled by a high-pass, as charge amplifiers are, at 0.3 Hz to 3 f1."""
    spring, series = sprung(rng)
    filters = ((int(rng.integers(1, 5)), log_uniform(rng, 0.3, 3 * spring.first), "high"),)
    return spring_log(spring, "high-passed", series, instruments(spring, series, filters=filters))


def aliased(rng):
    """Sampled at 1.3 to 8 f1 with no filter before."""
    first = log_uniform(rng, 14, 120)
    spring, series = sprung(rng, first=first, rate=first * rng.uniform(1.3, 8), duration=30.0)
    return spring_log(spring, "aliased", series, instruments(spring, series, filters=()))


def held_samples(rng):
    """The log's rate is above that at which one or each force has a new value, 0.8 to 20 f1."""
    spring, series = sprung(rng)
    channels = instruments(spring, series, update_rate=min(log_uniform(rng, 0.8, 20) * spring.first, 0.45 * spring.scene.rate))
    if len(channels) == 2 and rng.random() < 0.5:
        channels.pop(FORCES[rng.integers(2)])
    return spring_log(spring, "held-samples", series, channels)


def quantised(rng):
    """The last digit is worth 0.3 to 12 % of what rings, and noise is less than it."""
    spring, series = sprung(rng)
    channels = {
        name: spring.scene.plain(name, noise=min(spring.scene.noise, 0.2 * step), step=step)
        for name, step in ((name, log_uniform(rng, 3e-3, 0.12) * size) for name, size in ringing(series).items())
    }
    return spring_log(spring, "quantised", series, channels)


def clipped(rng):
    """One or each force ends at 15 to 90 % of its swing, on one side or both."""
    spring, series = sprung(rng)
    channels = {}
    for name, size in ringing(series).items():
        middle, share = np.median(series[name]), rng.uniform(0.15, 0.9)
        limits = [(middle - share * size, middle + share * size), (-np.inf, middle + share * size)][rng.integers(2)]
        channels[name] = spring.scene.plain(name, limits=limits)
    return spring_log(spring, "clipped", series, channels)


def late_channel(rng):
    """One force is 0.02 to 0.6 periods of f1 behind the other, or u1 is 1 to 60 ms behind."""
    spring, series = sprung(rng, "both", ["u1"])
    late = ("F_i", "F_o", "u1")[rng.integers(3)]
    delay = log_uniform(rng, 1e-3, 0.06) if late == "u1" else log_uniform(rng, 0.02, 0.6) / spring.first
    return spring_log(spring, "late-channel", series, {late: spring.scene.plain(late, delay=delay)})


def wrong_windings(rng):
    """The command is told two to four times, or a half to a quarter of, the number of windings."""
    windings = int(rng.integers(8, 41))
    spring, series = sprung(rng, masses=windings)
    said = windings * rng.uniform(2, 4) ** rng.choice([-1, 1])
    return spring_log(spring, "wrong-windings", series, arguments=["--windings", f"{max(said, 3):.1f}"])


KINDS = (sign_turned, low_passed, high_passed, aliased, held_samples, quantised, clipped, late_channel, wrong_windings)
