"""A spring whose inputs come one by one, and many of them: rest, copies, states, and the same bits together as alone."""

import copy
import os
import pathlib
import pickle
import signal
import threading
import time
from collections.abc import Callable

import numpy
import pytest
from samples import SPRING

import coilsense

EXAMPLES = pathlib.Path(__file__).parents[2] / "examples"
STEP = 2e-4
FAR_ENDS = [coilsense.FarEnd.position(), coilsense.FarEnd.force(), coilsense.FarEnd.mass(0.5)]


def made(far_end: coilsense.FarEnd = FAR_ENDS[0], spring: coilsense.Spring = SPRING) -> coilsense.Live:
    return coilsense.Live(spring, 0.23, STEP, coilsense.Mount(far_end, coilsense.Damping.modal(0.005)))


def pulled(live: coilsense.Live, count: int, seed: int = 1) -> numpy.ndarray:
    """End 1 and end 2 of so many samples, about where they rest."""
    random, is_held = numpy.random.default_rng(seed), live.mount.far_end.kind == "position"
    end2 = (0.23, 1e-4) if is_held else (SPRING.static_force(0.23), 0.5)
    return numpy.transpose([random.normal(0, 1e-4, count), random.normal(*end2, count)])


def driven(live: coilsense.Live, ends: numpy.ndarray) -> list[tuple[float, float, float]]:
    return [live.advance(u1, end2) for u1, end2 in ends]


@pytest.mark.parametrize("far_end", FAR_ENDS, ids=lambda it: it.kind)
def test_a_state_that_was_got_goes_on_with_the_same_bits_when_it_is_set(far_end: coilsense.FarEnd) -> None:
    live = made(far_end)
    ends = pulled(live, 60)
    driven(live, ends[:20])
    saved = live.state
    modes = len(coilsense.ChainModes(SPRING, far_end).frequencies)
    assert saved.shape == (2 * modes + 5,) and saved.dtype == float and saved[-1] == 20
    once = driven(live, ends[20:])
    assert (live.state != saved).any()  # what was got is a copy, not a view
    live.state = saved
    assert live.time == pytest.approx(20 * STEP, rel=1e-15)
    assert driven(live, ends[20:]) == once
    other = made(far_end)
    other.state = list(saved)
    assert driven(other, ends[20:]) == once


@pytest.mark.parametrize("copied", [
    coilsense.Live.copy, copy.copy, copy.deepcopy, lambda live: pickle.loads(pickle.dumps(live)), lambda live: live.batch(2)[1],
], ids=["method", "copy", "deepcopy", "pickle", "batch"])
def test_a_copy_goes_on_by_itself_with_the_same_bits(copied) -> None:  # type: ignore[no-untyped-def]
    live = made(FAR_ENDS[2])
    ends = pulled(live, 50)
    driven(live, ends[:20])
    other = copied(live)
    assert other == live and other is not live and (other.time, other.step) == (live.time, live.step)
    assert (other.spring, other.mount, other.mean_length) == (live.spring, live.mount, live.mean_length)
    once = driven(live, ends[20:])
    assert other != live
    assert driven(other, ends[20:]) == once and other == live and repr(other) == repr(live)
    assert live != made(FAR_ENDS[1]) and live != "a spring"


def test_a_coil_of_sections_is_copied_and_not_sent() -> None:
    spring = coilsense.Spec.read(EXAMPLES / "progressive-spring.toml").spring
    live = coilsense.Live(spring, spring.mid_length, 1e-4)
    live.advance(1e-4, spring.mid_length)
    other = live.copy()
    assert other == live and other.advance(0.0, spring.mid_length) == live.advance(0.0, spring.mid_length)
    for one in (live, live.batch(2)):
        with pytest.raises(coilsense.Error, match="must be a uniform coil to be pickled, got sections"):
            pickle.dumps(one)


def test_at_rest_it_is_as_new_or_somewhere_else() -> None:
    live = made()
    ends = pulled(live, 30)
    once = driven(live, ends)
    live.reset()
    assert live.time == 0 and live == made()
    assert driven(live, ends) == once
    live.reset(0.01, 0.25)
    for _ in range(20):
        # 100 N, and end segments of 8e4 N/m times the rounding of a length.
        assert live.advance(0.01, 0.25)[1:] == pytest.approx(2 * [SPRING.static_force(0.24)], abs=1e-10)
    hung = made(FAR_ENDS[2])
    hung.reset(end2=120.0)
    assert hung.advance(0.0, 120.0)[1:] == pytest.approx((120.0, 120.0), abs=1e-9)


def test_what_is_no_state_and_no_rest_changes_nothing() -> None:
    live = made()
    driven(live, pulled(live, 10))
    saved = live.state
    for place, value, told in [
        (3, numpy.nan, r"state\[3\] must be finite, got NaN"),
        (-1, -1.0, r"state\[108\] must be a whole number of steps taken, not below zero, got -1"),
        (-4, -1.0, "u2 - u1 of the state, the spring's length, must be above zero"),
    ]:
        wrong = saved.copy()
        wrong[place] = value
        with pytest.raises(coilsense.Error, match=told):
            live.state = wrong
    with pytest.raises(coilsense.Error, match="state must hold 109 values, got 108"):
        live.state = saved[1:]
    with pytest.raises(TypeError, match="must be a series of real numbers"):
        live.state = saved[None]
    with pytest.raises(coilsense.Error, match="u1 must be finite, got NaN m"):
        live.reset(numpy.nan)
    with pytest.raises(coilsense.Error, match="u2 - u1, the spring's length, must be above zero"):
        live.reset(0.3, 0.2)
    with pytest.raises(AttributeError, match="time"):
        live.time = 0.0  # type: ignore[misc]
    assert (live.state == saved).all()


@pytest.mark.parametrize("far_end", FAR_ENDS, ids=lambda it: it.kind)
def test_many_at_once_are_each_by_itself_to_the_last_bit(far_end: coilsense.FarEnd) -> None:
    heavy = coilsense.Spring(**SPRING.to_dict() | {"mass": 0.08})
    alone = [made(far_end, spring) for spring in (SPRING, heavy, SPRING)]
    batch = coilsense.LiveBatch(alone)
    ends = numpy.stack([pulled(live, 700, seed) for seed, live in enumerate(alone)])
    expected = numpy.array([driven(live, own) for live, own in zip(alone, ends)])
    for sample in range(20):
        t, F_i, F_o = batch.advance(*ends[:, sample].T)
        assert (numpy.transpose([t, F_i, F_o]) == expected[:, sample]).all()
    F_i, F_o = batch.rollout(*numpy.moveaxis(ends[:, 20:], 2, 0))
    assert F_i.shape == (3, 680)
    assert (F_i == expected[:, 20:, 1]).all() and (F_o == expected[:, 20:, 2]).all()
    assert [batch[place] for place in range(3)] == alone and batch[-1] == alone[2] and len(batch) == 3
    assert (batch.state == [live.state for live in alone]).all() and (batch.time == [live.time for live in alone]).all()


def test_a_long_rollout_is_spread_over_threads_and_gives_the_same_bits() -> None:
    live = made()
    ends = numpy.stack([pulled(live, 4000, seed) for seed in range(8)])
    batch = live.batch(8)
    F_i, F_o = batch.rollout(ends[:, :, 0], ends[:, :, 1])  # 1.7 million steps of a mode
    for place in (0, 7):
        alone = made()
        assert (numpy.array(driven(alone, ends[place]))[:, 1:] == numpy.transpose([F_i[place], F_o[place]])).all()
        assert batch[place] == alone


def test_a_batch_is_saved_copied_and_brought_to_rest() -> None:
    batch = made().batch(4)
    u1, end2 = numpy.zeros((4, 50)), numpy.full((4, 50), 0.231)
    batch.rollout(u1, end2)
    saved, twin, sent = batch.state, batch.copy(), pickle.loads(pickle.dumps(batch))
    once = batch.rollout(u1, end2)
    batch.state = saved
    for other in (batch, twin, sent, copy.deepcopy(sent)):
        if other is not sent:
            assert (numpy.array(other.rollout(u1, end2)) == once).all()
    lengths = numpy.array([0.2, 0.21, 0.22, 0.23])
    batch.reset(end2=lengths)
    assert (batch.time == 0).all()
    felt = batch.advance(numpy.zeros(4), lengths)[1]
    numpy.testing.assert_allclose(felt, [SPRING.static_force(length) for length in lengths], atol=1e-10)
    batch.reset()
    assert batch[0] == made()


def test_what_does_not_fit_a_batch_is_named_and_moves_none() -> None:
    live = made()
    with pytest.raises(coilsense.Error, match="lives must hold at least 1 spring, got 0"):
        coilsense.LiveBatch([])
    for count in (0, 10**15):
        with pytest.raises(coilsense.Error, match=f"count must be from 1 to 1000000, got {count}"):
            live.batch(count)
    with pytest.raises(OverflowError):
        live.batch(-1)
    others = {
        "step of lives.1. must be that of lives.0., 0.0002 s, got 0.0003 s": coilsense.Live(SPRING, 0.23, 3e-4, live.mount),
        "far end of lives.1. must be of the kind of lives.0.": made(FAR_ENDS[1]),
        "modes of lives.1. must be as many as of lives.0., 52, got 25": coilsense.Live(coilsense.Spring.of_paper("S_A"), 0.1, STEP),
    }
    for told, other in others.items():
        with pytest.raises(coilsense.Error, match=told):
            coilsense.LiveBatch([live, other])
    with pytest.raises(TypeError):
        coilsense.LiveBatch([live, "another"])  # type: ignore[list-item]
    batch = live.batch(3)
    zeros, long = numpy.zeros(3), numpy.full(3, 0.23)
    batch.advance(zeros, long)
    saved = batch.state
    wrong = long.copy()
    wrong[1] = numpy.nan
    rows, lengths = numpy.zeros((3, 5)), numpy.full((3, 5), 0.23)
    broken, swapped = lengths.copy(), lengths.copy()
    broken[2, 4], swapped[1, 3] = numpy.inf, -0.1
    calls: list[tuple[str, Callable[[], object]]] = [
        ("u1 must hold 3 values, one for each spring, got 2", lambda: batch.advance(zeros[:2], long)),
        ("end2 must hold 3 values, one for each spring, got 0", lambda: batch.advance(zeros, [])),
        ("spring 1: u2 must be finite, got NaN m", lambda: batch.advance(zeros, wrong)),
        ("spring 1: u2 must be finite, got NaN m", lambda: batch.reset(end2=wrong)),
        ("u1 must hold 3 values, one for each spring, got 1", lambda: batch.reset([0.0])),
        ("u1 must hold 3 rows, one for each spring, got 5", lambda: batch.rollout(rows.T, lengths.T)),
        ("end2 must have as many columns as u1, 5, got 4", lambda: batch.rollout(rows, lengths[:, 1:])),
        ("u1 must have at least 1 column, one for each sample, got 0", lambda: batch.rollout(rows[:, :0], lengths[:, :0])),
        ("spring 2, sample 4: u2 must be finite, got inf m", lambda: batch.rollout(rows, broken)),
        ("spring 1, sample 3: u2 - u1, the spring's length, must be above zero and finite, got -0.1 m", lambda: batch.rollout(rows, swapped)),
        ("state must hold 3 rows, one for each spring, got 2", lambda: setattr(batch, "state", saved[1:])),
        ("state must have 109 columns, twice the modes and 5, got 108", lambda: setattr(batch, "state", saved[:, 1:])),
        (r"spring 2: state\[0\] must be finite, got NaN", lambda: setattr(batch, "state", [*saved[:2], 109 * [numpy.nan]])),
    ]
    for told, call in calls:
        with pytest.raises(coilsense.Error, match=told):
            call()
        assert (batch.state == saved).all(), told
    with pytest.raises(TypeError, match="rows of real numbers"):
        batch.rollout(zeros, long)
    for place in (3, -4):
        with pytest.raises(IndexError, match=f"spring {place} of a batch of 3"):
            batch[place]


def test_ctrl_c_ends_a_rollout_and_leaves_all_springs_where_they_were() -> None:
    many = coilsense.Spring(**SPRING.to_dict() | {"windings": 2000, "wire_radius": 4e-5})
    batch = made(spring=many).batch(20)
    batch.advance(numpy.zeros(20), numpy.full(20, 0.2301))
    saved = batch.state
    u1, end2 = numpy.zeros((20, 50_000)), numpy.full((20, 50_000), 0.23)  # some seconds
    others = 0

    def count() -> None:
        nonlocal others
        time.sleep(0.15)
        others = threading.active_count()  # runs meanwhile: the interpreter's lock is let go
        os.kill(os.getpid(), signal.SIGINT)

    thread = threading.Thread(target=count)
    thread.start()
    with pytest.raises(KeyboardInterrupt):
        batch.rollout(u1, end2)
    thread.join()
    assert others >= 2
    assert (batch.state == saved).all()
    assert batch.rollout(u1[:, :3], end2[:, :3])[0].shape == (20, 3)
