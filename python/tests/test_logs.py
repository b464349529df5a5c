"""Logs of any layout become recordings, and recordings become calibrations and identifications."""

import json
import pathlib
import time
import typing

import numpy
import pytest
from samples import SPRING, hit_log

import coilsense

RATE = 2500.0


def german(path: pathlib.Path, signals: coilsense.Signals, every: int = 1) -> None:
    """Writes time in ms, the load cells in N and the positions in mm, as German software does."""
    rows = ["Zeit;Antrieb [N];LC;x1;x2", "ms;;;;"]
    columns = (1e3 * signals.time, signals["F_i"], signals["F_o"], 1e3 * signals["u1"], 1e3 * signals["u2"])
    for row in numpy.stack(columns, axis=1)[::every]:
        rows.append(";".join(f"{value:.6f}" for value in row).replace(".", ","))
    path.write_text("\n".join(rows) + "\n")


COLUMNS: dict[str, str | int] = {"time": "Zeit [ms]", "F_i": 2, "F_o": "LC", "u1": "x1", "u2": "x2"}
UNITS = {"F_i": "N", "F_o": "N", "u1": "mm", "u2": "mm"}


def test_a_log_comes_in_with_an_account_of_its_rows(tmp_path: pathlib.Path) -> None:
    signals = hit_log(seconds=4)
    german(tmp_path / "run.csv", signals)
    recording = coilsense.open_log(tmp_path / "run.csv", COLUMNS, UNITS)
    assert len(recording) == len(signals.time) == recording.rows["kept"]
    assert recording.sample_rate == pytest.approx(RATE)
    for name in ("F_i", "F_o", "u1", "u2"):
        # Six decimals of N and of mm were written.
        assert abs(recording.signals[name] - signals[name]).max() <= 0.51e-6
    assert "10001 rows read, none left out, 10001 kept" in str(recording)
    assert recording.file in recording._repr_html_()
    assert list(recording.to_pandas().columns) == list(recording.signals)
    assert recording.plot().get_ylabel() == "F_i, F_o, F_x [N]" or recording.plot().get_ylabel() == "F_i, F_o [N]"


def test_only_a_window_is_taken_and_texts_have_units(tmp_path: pathlib.Path) -> None:
    german(tmp_path / "run.csv", hit_log(seconds=4))
    recording = coilsense.open_log(tmp_path / "run.csv", COLUMNS, UNITS, from_="500 ms", to=1.0)
    assert (recording.signals.time[0], recording.signals.time[-1]) == (0.5, 1.0)
    assert recording.rows["outside of the window of time"] == 10001 - 1251


def test_what_is_wrong_is_named_with_the_argument_that_mends_it(tmp_path: pathlib.Path) -> None:
    path = tmp_path / "run.csv"
    path.write_text("time [s],F_o [N]\n0,1\n0.001,\n0.002,3\n0.010,4\n")
    with pytest.raises(coilsense.LogError, match=r"run.csv:3: .*drop_incomplete=True.*fill_gaps fills") as caught:
        coilsense.open_log(path)
    assert "--" not in str(caught.value)
    cleaned = coilsense.open_log(path, drop_incomplete=True)
    assert cleaned.rows["with a missing value"] == 1 and list(cleaned.signals["F_o"]) == [1, 3, 4]
    with pytest.raises(coilsense.LogError, match="is not evenly sampled.*resample=\"500 Hz\" makes them even"):
        _ = cleaned.sample_rate
    assert coilsense.open_log(path, resample="500 Hz").sample_rate == pytest.approx(500)
    path.write_text("t,kraft\n0,1\n1,2\n")
    with pytest.raises(coilsense.LogError, match="columns"):
        coilsense.open_log(path)
    with pytest.raises(coilsense.LogError, match="no_such.csv"):
        coilsense.open_log(tmp_path / "no_such.csv")
    with pytest.raises(coilsense.Error, match="^resample must be .*Hz.*got \"often\"$"):
        coilsense.open_log(path, resample="often")
    with pytest.raises(coilsense.Error, match="^fill_gaps must be above zero, got -1 s$"):
        coilsense.open_log(path, fill_gaps=-1)


def test_what_the_command_refuses_is_refused_in_the_same_words(tmp_path: pathlib.Path) -> None:
    path = tmp_path / "run.csv"
    path.write_text("F_o [N]\n1\n2\n")
    nan = float("nan")
    # By name, which types do not follow.
    given: dict[str, typing.Any]
    for name, value, reason in [
        ("sample_rate", -1, "must be from 1e-9 to 1e9 Hz, got -1 Hz"),
        ("resample", 1e12, "must be from 1e-9 to 1e9 Hz, got 1000000000000 Hz"),
        ("resample", nan, "must be finite, got NaN Hz"),
        ("fill_gaps", 0, "must be above zero, got 0 s"),
        ("from_", nan, "must be finite, got NaN s"),
        ("to", float("inf"), "must be finite, got inf s"),
    ]:
        given = {name: value}
        with pytest.raises(coilsense.Error, match=f"^{name} {reason}$"):
            coilsense.open_log(path, **given)
    for name, value, reason in [
        ("windings", 0.5, "must be from 1 to 1000000, got 0.5"),
        ("mass", -1, "must be above zero, got -1 kg"),
        ("tolerance", 0, "must be above 0 and below 1, got 0"),
        ("prediction_tolerance", nan, "must be finite, got NaN"),
        ("accuracy_force", 1, "must be from 0 to below 1, got 1"),
    ]:
        given = {name: value}
        with pytest.raises(coilsense.Error, match=f"^{name} {reason}$"):
            coilsense.identify(hit_log(), **given)
    with pytest.raises(coilsense.Error, match="^end_mass goes with a mass at end 2 only$"):
        coilsense.identify(hit_log(), end2="held", end_mass=1)
    with pytest.raises(coilsense.LogError, match="no preset of that name; there are: lab-data"):
        coilsense.calibrate(path, preset="x")  # type: ignore[arg-type]


def test_two_devices_are_put_on_one_clock() -> None:
    signals = hit_log(0.0, 4)
    first = coilsense.Recording(coilsense.Signals(signals.time, {"F_i": signals["F_i"]}), "first")
    late = coilsense.Signals(signals.time[:-500] - 0.1, {"F_o": signals["F_o"][:-500]})
    both = first.joined(coilsense.Recording(late, "second"), clock=0.1)
    there = both.signals.time <= 3.0
    assert abs(both.signals["F_o"][there] - signals["F_o"][: there.sum()]).max() < 1e-9  # straight lines between the same times
    with pytest.raises(coilsense.LogError, match="no channel is in both"):
        first.joined(coilsense.Recording(late, "second"))


def test_a_ringing_log_is_identified_within_its_own_intervals(tmp_path: pathlib.Path) -> None:
    signals = hit_log()
    found = coilsense.identify(signals, spring=SPRING)
    assert found.verdict == "spring" and found.evidence
    assert found.first_frequency is not None and found.stiffness is not None and found.mass is not None
    assert found.damping_ratio is not None and found.trust is not None and found.rest_length is not None
    # The chain's first mode, 0.015 % below the continuous coil's.
    assert coilsense.ChainModes(SPRING).frequencies[0] in found.first_frequency
    assert SPRING.stiffness in found.stiffness and 0.005 in found.damping_ratio and SPRING.rest_length in found.rest_length
    assert SPRING.mass in found.mass and len(found.hits) == 6
    with pytest.deprecated_call():
        assert list(found.taps) == list(found.hits)
    assert found.lines[0]["kind"] == "mode" and len(found.to_pandas()) == len(found.lines)
    assert found.verdict in found._repr_html_() and found.plot().get_xlabel() == "Frequency [Hz]"
    assert found == coilsense.identify(coilsense.Recording(signals), spring=SPRING)
    assert found != coilsense.identify(coilsense.Recording(signals))
    files = found.save(tmp_path / "out", date="2026-11-22")
    written = json.loads((tmp_path / "out" / "results.json").read_text())
    assert files == sum(path.is_file() for path in (tmp_path / "out").rglob("[!.]*"))
    assert written == {**found.to_dict(), "date": "2026-11-22"}


def test_what_was_identified_becomes_a_spec(tmp_path: pathlib.Path) -> None:
    found = coilsense.identify(hit_log(), spring=SPRING)
    text = found.to_spec(spring=SPRING)
    assert text == found.to_spec(SPRING.windings, SPRING.coil_radius, "1 mm")
    path = tmp_path / "found.toml"
    path.write_text(text)
    again = coilsense.identify(hit_log(), spring=path)
    assert again.first_frequency == found.first_frequency
    with pytest.raises(coilsense.Error, match="windings, coil_radius and wire_radius, or spring"):
        found.to_spec(52)


def test_a_record_that_tells_nothing_says_so() -> None:
    times = coilsense.sampled_window(RATE, 0, 2)
    noise = numpy.random.default_rng(2).normal(0, 0.1, len(times))
    found = coilsense.identify(coilsense.Signals(times, {"F_o": noise}))
    assert found.verdict != "spring" and found.first_frequency is None and found.stiffness is None
    assert found.stiffness_refused and found.record_next and found._repr_html_()
    with pytest.raises(coilsense.Error, match="F_i, F_o or F_L"):
        coilsense.identify(coilsense.Signals(times, {"u1": noise}))
    with pytest.raises(coilsense.Error, match="end2 must be one of held, free, mass"):
        coilsense.identify(hit_log(), end2="loose")  # type: ignore[arg-type]
    with pytest.raises(TypeError, match="record must be a Recording, Signals, a data frame, .* or the path of a log, got int"):
        coilsense.identify(3)  # type: ignore[arg-type]


def test_a_calibration_gives_back_the_curve_that_made_its_points(tmp_path: pathlib.Path) -> None:
    lengths = numpy.linspace(0.2, 0.26, 13)
    alpha, beta = 1.5e6, 0.4
    inductances = (1 / lengths - beta) / alpha
    fit = coilsense.calibrate((lengths, inductances), spring=SPRING)
    assert fit.alpha == pytest.approx(alpha, rel=1e-9) and fit.beta == pytest.approx(beta, rel=1e-9)  # rounding alone
    assert fit.degrees_of_freedom == 11 and fit.rmse < 1e-12
    assert fit.length(inductances) == pytest.approx(lengths) and fit.inductance(lengths) == pytest.approx(inductances)
    assert {theory["name"] for theory in fit.theories} and len(fit.to_pandas()) == 13
    assert "1/l = αL + β" in str(fit) and "\x1b" not in str(fit) and "<table" in fit._repr_html_()
    assert fit.plot().get_xlabel() == "Length [mm]" and fit.save(tmp_path / "out") > 3
    of_a_log = coilsense.Recording(coilsense.Signals(numpy.arange(13.0), {"u2": lengths - 0.1, "L": inductances}))
    assert coilsense.calibrate(of_a_log, length_at_zero="100 mm").alpha == pytest.approx(alpha, rel=1e-9)
    through = coilsense.calibrate((lengths, inductances + 1e-9), preload=(0.23, inductances[6]))
    assert through.inductance([0.23])[0] == pytest.approx(inductances[6], rel=1e-12)


def test_a_calibration_by_the_theory_of_magnetic_wire_is_stored_and_read(tmp_path: pathlib.Path) -> None:
    lengths = numpy.linspace(0.2, 0.26, 13)
    # A sum of rings of air: what is left of a coil's own is in the constant.
    inductances = coilsense.MaxwellSum(SPRING).at_lengths(lengths) + 5e-8
    fit = coilsense.calibrate((lengths, inductances), spring=SPRING, theory="steel", fit_points=2, leads="50 mm")
    assert fit.relation == "steel" and fit.permeability is not None and fit.permeability_u is not None
    assert abs(fit.permeability - 1) < 3 * fit.permeability_u and fit.offset is not None
    assert fit.length_rms_percent_of_range < 0.3  # with a lead that rings of air have not
    assert numpy.all(numpy.abs(fit.length(inductances) - lengths) < 2 * fit.length_u(inductances))
    path = tmp_path / "calibration.toml"
    path.write_text(fit.stored("2026-11-27"), encoding="utf-8")
    stored = coilsense.open_calibration(path)
    length, uncertainty = stored.length(inductances)
    assert length == pytest.approx(fit.length(inductances), abs=1e-8)  # a cubic between rows of a table
    assert numpy.all(uncertainty > fit.length_u(inductances)) and stored.remounting > 0
    force, force_u = stored.force(inductances)
    assert force == pytest.approx(SPRING.stiffness * (length - SPRING.rest_length)) and numpy.all(force_u > 0)
    again = stored.re_zeroed(0.23, inductances[6] + 2e-9)
    assert again.remounting == 0 and again.length(inductances + 2e-9)[0] == pytest.approx(lengths, abs=4e-4)
    assert numpy.isnan(stored.length([1.0])[0][0])
    with pytest.raises(coilsense.Error, match="re_zero: length must be from"):
        stored.re_zeroed(1.0, 3e-6)
    with pytest.raises(coilsense.Error, match="no stored calibration"):
        path.write_text("schema = 3", encoding="utf-8")
        coilsense.open_calibration(path)
    with pytest.raises(coilsense.Error, match="theory: needs the coil"):
        coilsense.calibrate((lengths, inductances), theory="steel")
    cubic = coilsense.calibrate((lengths, inductances), form="cubic", re_zero=(0.23, inductances[6]))
    assert cubic.relation == "cubic" and cubic.permeability is None


def test_a_calibration_that_cannot_be_is_refused() -> None:
    lengths, inductances = [0.2, 0.21, 0.22], [3e-6, 2.9e-6, 2.8e-6]
    with pytest.raises(coilsense.Error, match="method must be one of two-point, all, through-preload, got \"some\""):
        coilsense.calibrate((lengths, inductances), method="some")  # type: ignore[arg-type]
    with pytest.raises(coilsense.Error, match="stiffness and length_at_zero_force go together"):
        coilsense.calibrate((lengths, inductances), stiffness=760)
    with pytest.raises(coilsense.Error):
        coilsense.calibrate((lengths, inductances[:2]))
    with pytest.raises(coilsense.Error, match="length_at_zero is needed"):
        coilsense.calibrate("S2_01.csv", preset="lab-data")


def test_an_estimate_is_a_number_with_an_interval() -> None:
    estimate = coilsense.Estimate(54.0, 0.1, 0.2)
    assert (float(estimate), estimate.low, estimate.high) == (54.0, 53.8, 54.2)
    assert 54.1 in estimate and 55 not in estimate
    assert eval(repr(estimate), vars(coilsense)) == estimate


def test_a_call_costs_little() -> None:
    estimate = coilsense.Estimate(54.0, 0.1, 0.2)
    begun = time.perf_counter()
    for _ in range(10_000):
        float(estimate)
    # A microsecond is usual; a busy machine may take ten times as long.
    assert (time.perf_counter() - begun) / 10_000 < 2e-5


@pytest.mark.parametrize("name", ["run--torque-2.csv", "run--to.csv", "a--sort-b.csv", "--over.csv"])
def test_the_name_of_a_file_is_told_as_it_is(tmp_path: pathlib.Path, name: str) -> None:
    path = tmp_path / name
    path.write_text("time [s],F_i [N]\n0,1\n0.1,x\n")
    with pytest.raises(coilsense.LogError) as caught:
        coilsense.open_log(path)
    assert name in str(caught.value)
