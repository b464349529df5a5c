"""A motion from Python is the one that Rust computes: laws, limits and numbers of the paper."""

import threading
import time
from typing import Any

import numpy
import pytest
from samples import IMPACT, SPRING

import coilsense

WINDOW = coilsense.sampled_window(10_000, 0.75, 1.0)


def test_heel_strike_of_s_t_has_the_rmsd_of_table_ii() -> None:
    signals = coilsense.Motion(SPRING, IMPACT).signals(WINDOW)
    rmsd = numpy.sqrt(numpy.mean((signals["F_o"] - signals["F_x"]) ** 2)) / SPRING.nominal_force
    assert abs(100 * rmsd - 1.44) < 0.01  # Table II prints two decimals


def test_an_impact_carries_the_wave_impedance() -> None:
    # Half a transit time after the impact, on the plateau, F_o is off by v Z; a chain of 52 masses rings about it by some per cent.
    times = numpy.linspace(0.3, 0.7, 50) * SPRING.transit_time
    F_i, F_o = coilsense.Motion(SPRING, IMPACT).end_forces(times)
    jump = 0.25 * SPRING.wave_impedance
    assert abs(numpy.mean(F_o) - SPRING.static_force(0.23) + jump) < 0.05 * jump
    assert abs(numpy.mean(F_i) - SPRING.static_force(0.23) - jump) < 0.05 * jump


@pytest.mark.parametrize("kind", ["list", "tuple", "float32", "integers", "reversed", "strided"])
def test_times_may_be_anything_that_is_like_an_array(kind: str) -> None:
    times = numpy.arange(0.0, 5.0)
    given: Any = {
        "list": times.tolist(),
        "tuple": tuple(times.tolist()),
        "float32": times.astype(numpy.float32),
        "integers": times.astype(int),
        "reversed": times[::-1],
        "strided": numpy.repeat(times, 2)[::2],
    }[kind]
    motion = coilsense.Motion(SPRING, IMPACT)
    wanted = motion.end_forces(numpy.ascontiguousarray(given, dtype=float))
    numpy.testing.assert_array_equal(motion.end_forces(given), wanted)


@pytest.mark.parametrize("wrong", ["1.0", None, ["a"], [1j], [[1.0, 2.0]], numpy.array([True]), object(), 1.0])
def test_a_wrong_type_is_a_type_error_that_names_the_argument(wrong: object) -> None:
    motion = coilsense.Motion(SPRING, IMPACT)
    with pytest.raises(TypeError, match="^times must be a series of real numbers, got "):
        motion.signals(wrong)  # type: ignore[arg-type]
    with pytest.raises(TypeError, match="^times must be a series of real numbers, got "):
        motion.windings(wrong)  # type: ignore[arg-type]


def test_errors_have_the_text_of_rust() -> None:
    with pytest.raises(coilsense.Error, match=r"^time\[1\] must be finite and not below zero, got -1 s$"):
        coilsense.Motion(SPRING, IMPACT).end_forces([0.0, -1.0])
    with pytest.raises(coilsense.Error, match=r"^stiffness must be above zero and finite, got -1 N/m$"):
        coilsense.Spring(**{**SPRING.to_dict(), "stiffness": -1})
    with pytest.raises(coilsense.Error, match="^end must be 1 or 2, got 3$"):
        coilsense.Excitation.harmonic(0.23, 3, coilsense.EndInput.held())  # type: ignore[arg-type]
    with pytest.raises(coilsense.Error, match=r"S_T, S_A, got \"S_X\""):
        coilsense.Spring.of_paper("S_X")  # type: ignore[arg-type]
    with pytest.raises(coilsense.Error, match='^stiffness must be a number in N/m or a stiffness with its unit .*, got "stiff"$'):
        coilsense.Spring(**{**SPRING.to_dict(), "stiffness": "stiff"})
    with pytest.raises(TypeError, match="stiffness"):
        coilsense.Spring(**{**SPRING.to_dict(), "stiffness": [760.0]})


def test_other_threads_run_while_a_motion_is_computed() -> None:
    motion = coilsense.Motion(SPRING, IMPACT)
    times = numpy.sort(numpy.random.default_rng(1).uniform(0, 10, 300_000))  # uneven, so that it takes a while
    ticks, done = 0, threading.Event()

    def compute() -> None:
        motion.end_forces(times)
        done.set()

    worker = threading.Thread(target=compute)
    worker.start()
    while not done.is_set():
        ticks += 1
        time.sleep(1e-3)
    worker.join()
    assert ticks > 10  # with the lock held there would be one
