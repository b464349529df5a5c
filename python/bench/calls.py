"""What a call from Python costs: prints one JSON object per measurement, as the other peers of `cargo xtask bench` do."""

import json
import statistics
import timeit
from collections.abc import Callable

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
motion = coilsense.Motion(spring, coilsense.Excitation.impact(spring.mid_length, 0.25))
times = coilsense.sampled_window(10_000, 0.0, 1.0)
tell("impact-10001", "Motion.end_forces", median_ms(lambda: motion.end_forces(times), 2000))
