"""What to do about ringing, where to put the sensor, and an experiment on a simulated rig: the commands' results as objects."""

import json
import math
import pathlib
import signal
import time

import numpy
import pytest
from matplotlib.patches import Rectangle
from samples import SPRING, hit_log

import coilsense

TEMPLATE = coilsense.Spec.template("S_T").replace('end2 = "held"', 'end2 = "held"\ndamping_ratio = 0.005', 1)
SPEC = coilsense.Spec.parse(TEMPLATE)
LOOP = coilsense.Spec.parse(TEMPLATE + '\n[control]\ndrive = "velocity"\nsample_time = "0.4 ms"\n')


@pytest.fixture(scope="module")
def remedies() -> coilsense.Mitigation:
    """Judged on a record of six seconds with one tap."""
    return coilsense.mitigate(SPEC, coilsense.Recording(hit_log(seconds=6)))


def test_the_ranking_is_that_of_the_report(remedies: coilsense.Mitigation, tmp_path: pathlib.Path) -> None:
    assert len(remedies) == len(remedies.remedies) == len(remedies.ranking) > 10
    for against in ("k·Δl", "F_o"):
        worst = [remedy.worst_rms_error for remedy in remedies.remedies if remedy.against == against]
        assert worst and worst == sorted(worst)
    for remedy, row in zip(remedies.remedies, remedies.ranking):
        assert (remedy.name, remedy.worst_rms_error) == (row["name"], row["worst_rms_error_n"])
        assert remedy.lag == row["lag_at_bandwidth_rad"]
    best = remedies.best_filter
    assert best is not None and best.lag <= math.radians(30) and best.name in repr(remedies)
    assert remedies[0].name == remedies.remedies[0].name and remedies[-1].name == remedies.remedies[-1].name
    with pytest.raises(IndexError, match="got place 1000"):
        remedies[1000]
    assert remedies.save(tmp_path, date="2026-11-22") == sum(path.is_file() for path in tmp_path.rglob("[!.]*"))
    assert (tmp_path / "force_filter.h").read_text() == best.to_c()
    assert (tmp_path / "force_filter.rs").read_text() == best.to_rust()
    assert (tmp_path / "force_filter.json").read_text() == best.to_json()
    assert "\x1b" not in str(remedies) and best.name in str(remedies) and best.name in remedies._repr_html_()
    assert list(remedies.to_pandas().index) == [remedy.name for remedy in remedies.remedies]
    assert remedies.plot().get_ylabel() == "Worst rms error [N]"


def test_a_filter_run_on_a_record_takes_the_ringing_out(remedies: coilsense.Mitigation) -> None:
    signals, best = hit_log(seconds=6), remedies.best_filter
    assert best is not None
    truth = SPRING.static_force(0.23) - SPRING.stiffness * signals["u1"]
    raw = signals["F_i"] - truth
    left = best.apply(signals["F_i"], signals["u1"], signals["u2"]) - truth
    # The record is the one on which the filter was judged: its figure is the rms over all samples.
    assert numpy.sqrt(numpy.mean(left**2)) == pytest.approx(best.rms_error, rel=1e-6)
    assert numpy.sqrt(numpy.mean(left**2)) < 0.5 * numpy.sqrt(numpy.mean(raw**2))
    estimator = remedies.best_estimator
    assert estimator is not None
    out = estimator.apply(signals["F_i"], signals["u1"], signals["u2"])
    assert numpy.sqrt(numpy.mean((out - signals["F_o"]) ** 2)) == pytest.approx(estimator.rms_error, rel=1e-6)


def test_what_cannot_be_applied_is_refused(remedies: coilsense.Mitigation) -> None:
    estimator, best = remedies.best_estimator, remedies.best_filter
    assert estimator is not None and best is not None
    with pytest.raises(coilsense.Error, match="needs u1 and u2 beside the force"):
        estimator.apply([1.0, 2.0])
    with pytest.raises(coilsense.Error, match=r"^u2 must hold 2 values, as force does, got 1$"):
        estimator.apply([1.0, 2.0], [0.0, 0.0], [0.2])
    with pytest.raises(coilsense.Error, match=r"^force\[1\] must be finite, got NaN N$"):
        estimator.apply([1.0, math.nan], [0.0, 0.0], [0.2, 0.2])
    with pytest.raises(coilsense.Error, match="lower-case"):
        best.to_c("No Name")
    raw = next(remedy for remedy in remedies.remedies if remedy.settings is None)
    with pytest.raises(coilsense.Error, match="has no settings"):
        raw.to_c()
    with pytest.raises(coilsense.Error, match="seeds must be from 1 to 1000, got 0"):
        coilsense.mitigate(SPEC, seeds=0)
    with pytest.raises(coilsense.Error, match="give one of them"):
        coilsense.mitigate(SPEC, hit_log(seconds=1), stated=True)
    with pytest.raises(coilsense.LogError, match="has F_o, the force at end 2, and no F_i: "):
        coilsense.mitigate(SPEC, coilsense.Signals([0.0, 1.0], {"F_o": [1.0, 2.0]}))


class Alarm(Exception):
    """What the tests' signal handler raises."""


def test_ctrl_c_ends_what_takes_long() -> None:
    def ring(number: int, frame: object) -> None:
        raise Alarm

    before = signal.signal(signal.SIGALRM, ring)
    signal.setitimer(signal.ITIMER_REAL, 0.1)
    begun = time.perf_counter()
    try:
        with pytest.raises(Alarm):
            # A second or two of work: ten series of noise on five conditions.
            coilsense.mitigate(SPEC, seeds=10)
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, before)
    # A sixth of a second by itself, at once after the signal; a machine that builds something else may be slow.
    assert time.perf_counter() - begun < 1


def test_a_placement_says_what_to_feed_back(tmp_path: pathlib.Path) -> None:
    placed = coilsense.placement(LOOP)
    assert placed.feed_back in placed.limits and placed.answer[0].startswith(f"Feed back {placed.feed_back}")
    stable, robust = placed.limits[placed.feed_back]
    assert 0 < placed.crossover <= robust <= stable
    assert all(margins["stable"] for margins in placed.margins[placed.feed_back])
    assert placed == coilsense.placement(LOOP) and placed.confirmed in (True, None)
    assert placed.save(tmp_path, date="2026-11-22") == 2
    assert json.loads((tmp_path / "results.json").read_text()) == placed.to_dict()
    assert placed.feed_back in str(placed) and placed.feed_back in placed._repr_html_()
    assert placed.feed_back in placed.to_pandas().index
    with pytest.raises(coilsense.Error, match=r"the table \[control\] is missing"):
        coilsense.placement(SPEC)


def test_two_integrators_are_robust_from_a_crossover_on_and_every_view_says_so() -> None:
    control = '\n[control]\ndrive = "velocity"\ncontroller = "PI"\nintegral_time = "0.1 s"\n'
    placed = coilsense.placement(TEMPLATE + control)
    # 0.088/T_I for F_x with end 2 held: |1 + L| of a (x + 1)/x² is at least 1/2 from a = 2 − √3 on.
    square = (2 - 3**0.5) ** 2
    expected = ((square + (square * square + 4 * square) ** 0.5) / 2) ** 0.5 / (0.1 * 2 * numpy.pi)
    assert placed.robust_from["F_x"] == pytest.approx(expected, rel=0.02)
    assert placed.robust_from == {row["force"]: row["robust_from_hz"] for row in placed.to_dict()["candidates"]}
    assert placed.to_pandas()["robust_from"]["F_x"] == placed.robust_from["F_x"]
    assert f"{placed.robust_from['F_x']:.4g}" in placed._repr_html_()
    # The second bar of a force is that of its sensitivity.
    bar = placed.plot().patches[2 * list(placed.limits).index("F_x") + 1]
    assert isinstance(bar, Rectangle) and bar.get_x() == placed.robust_from["F_x"]


def test_every_loop_of_a_placement_is_run_over_time() -> None:
    placed = coilsense.placement(LOOP)
    runs = placed.over_time
    assert placed.drive == "an ideal velocity source" and list(runs)[:4] == ["F_i", "F_o", "F_x", "F_L"]
    assert list(runs) == list(placed.limits) and runs[placed.feed_back]["limit_confirmed"] == placed.confirmed
    for name, run in runs.items():
        assert run["not_run"] is None and run["limit_confirmed"] in (True, None), name
        assert run["time"].shape == run["F_o"].shape == run["fed_back"].shape == run["command"].shape, name
        assert numpy.isfinite(run["F_i"]).all() and run["largest_command"] == numpy.abs(run["command"]).max(), name
        # What is unstable has no place to settle at that could be taken for one.
        assert run["stable"] or run["ran_away_at"] is not None or run["load_swing"] > 0, name
    best = runs[placed.feed_back]
    assert best["stable"] and abs(best["load"] - 1) < 0.1 and best["ran_away_at"] is None
    assert runs["F_x"]["coil_error"] is None


def test_a_rig_s_logs_are_worked_off(tmp_path: pathlib.Path) -> None:
    settings = '\n[rig]\nfrequencies = 5\nduration = "8 s"\nreadings = 10\nhits = 1\n'
    spec = coilsense.Spec.parse(TEMPLATE + settings)
    warnings = coilsense.rig(spec, tmp_path / "rig", seed=3)
    assert isinstance(warnings, list)
    found = coilsense.experiment(tmp_path / "rig")
    assert found.simulated and len(found) == len(found.rows) >= 4
    assert found.stiffness == pytest.approx(SPRING.stiffness, rel=0.01)  # the rig's instruments are good for a per cent
    assert found.peak is not None and {bias["force"] for bias in found.biases} <= {"F_o", "F_x", "F_L"}
    assert found.drift and found == coilsense.experiment(tmp_path / "rig")
    assert found.save(tmp_path / "out", date="2026-11-22") > 3
    assert json.loads((tmp_path / "out" / "results.json").read_text()) == {**found.to_dict(), "date": "2026-11-22"}
    assert found.answer[0] in str(found) and "<table" in found._repr_html_()
    assert len(found.to_pandas()) == len(found) and found.plot().get_xlabel() == "Frequency [Hz]"
    (tmp_path / "file").write_text("")
    with pytest.raises(coilsense.OutputError, match="file: is a file, a folder is needed"):
        coilsense.rig(spec, tmp_path / "file")
    with pytest.raises(coilsense.Error, match="experiment.toml"):
        coilsense.experiment(tmp_path)
