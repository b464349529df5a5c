"""What a call from Python costs: prints one JSON object per measurement, as the other peers of `cargo xtask bench` do."""

import json
import statistics
import timeit
from collections.abc import Callable

import numpy

import coilsense


def median_ms(work: Callable[[], object], calls: int, batch: int = 1) -> float:
    """Median time of a call [ms]. As in Rust each is timed by itself, or in batches where it is shorter than the clock's own time."""
    timer = timeit.Timer(work)
    return statistics.median(timer.repeat(calls, batch)) / batch * 1e3


def tell(job: str, setting: str, median: float) -> None:
    print(json.dumps({"job": job, "system": "coilsense from Python", "setting": setting, "median_ms": median}))


spring = coilsense.Spring.of_paper("S_T")
tell("call", "Spring.static_force", median_ms(lambda: spring.static_force(0.2), 1000, 1000))
tell("call", "Spring.surge_frequency", median_ms(lambda: spring.surge_frequency, 1000, 1000))
tell("call", "Spring.static_force of a text", median_ms(lambda: spring.static_force("200 mm"), 1000, 100))
tell("call", "Spring.replace", median_ms(lambda: spring.replace(mass=0.07), 1000, 100))
fit = coilsense.calibrate(([0.2, 0.23, 0.26], [3e-6, 2.6e-6, 2.3e-6]))
readings = coilsense.MaxwellSum(spring).at_lengths(coilsense.sampled_window(1000, 0.2, 0.25))
tell("call", "Calibration.length of 51", median_ms(lambda: fit.length(readings), 1000, 100))
estimate = coilsense.Estimate(760.0, 0.5, 1.0)
tell("call", "Estimate times a number", median_ms(lambda: estimate * 2, 1000, 100))
motion = coilsense.Motion(spring, coilsense.Excitation.impact(spring.mid_length, 0.25))
times = coilsense.sampled_window(10_000, 0.0, 1.0)
tell("impact-10001", "Motion.end_forces", median_ms(lambda: motion.end_forces(times), 2000))

# A step of a spring of 52 modes, by itself and with others.
live = coilsense.Live(spring, spring.mid_length, 1e-4)
length = spring.mid_length
tell("live-step", "Live.advance", median_ms(lambda: live.advance(0.0, length), 1000, 100))
for count in (1, 16, 1000):
    batch, still, long = live.batch(count), numpy.zeros(count), numpy.full(count, length)
    calls = max(100_000 // count, 100)
    tell("live-step", f"LiveBatch.advance, each of {count}", median_ms(lambda: batch.advance(still, long), calls) / count)
batch, still, long = live.batch(100), numpy.zeros((100, 1000)), numpy.full((100, 1000), length)
tell("live-step", "LiveBatch.rollout, each step of 1000 of each of 100", median_ms(lambda: batch.rollout(still, long), 20) / 100_000)
