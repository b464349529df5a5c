"""A spring under a cam, and what windings did when they met, from Python: against the command's own words and against physics."""

import json
import pathlib

import numpy
import pytest

import coilsense

TRAIN = pathlib.Path(__file__).parents[2] / "examples" / "valve-train.toml"


def chain() -> str:
    """The example with the six masses of one per winding, at one damping and rebound."""
    text = TRAIN.read_text().replace("[0.002, 0.01]", "0.01").replace("windings = 5.75", "windings = 5.75\nmasses_per_winding = 1")
    return text.replace('windings = "hard"', 'windings = "hard"\nrestitution = 0.0')


@pytest.fixture(scope="module")
def speeds() -> coilsense.SpeedMap:
    """From 3000 to 7000 rpm in steps of 1000."""
    return coilsense.speed(coilsense.Spec.parse(chain()), 3000 / 60, 7000 / 60, step=1000 / 60)


def test_runs_are_arrays_by_case_in_si(speeds: coilsense.SpeedMap) -> None:
    (case,) = speeds.cases
    runs = speeds.runs[case]
    assert runs["speed_hz"][0] == 50 and numpy.isclose(runs["speed_hz"][-1], 7000 / 60)
    assert (numpy.diff(runs["speed_hz"]) > 0).all()
    assert len({len(values) for values in runs.values()}) == 1
    # A seat cannot pull: what presses it least is not below zero, and its force is the largest with the sign turned.
    numpy.testing.assert_array_equal(runs["least_push_seat_1_n"], 0.0 - runs["input_force_largest_n"])
    assert (runs["least_push_seat_2_n"] >= -1e-6).all()
    # No strengths in the spec: no factor, but a stress.
    assert numpy.isnan(runs["goodman_factor"]).all() and (runs["stress_amplitude_pa"] > 1e7).all()
    # Slowest, where surge adds little: the static stroke, k times the lift, within its ringing.
    stroke = runs["input_force_largest_n"][0] - runs["input_force_least_n"][0]
    assert 0.9 < stroke / (29e3 * 10e-3) < 1.2


def test_harmonics_meet_the_surge_frequency_where_it_says(speeds: coilsense.SpeedMap) -> None:
    name, first = speeds.lines[0]
    assert name == "f1"
    (case,) = speeds.cases
    for harmonic, speed, lift in speeds.crossings:
        assert numpy.isclose(harmonic * 0.5 * speed, first)
        assert lift > 0
        assert numpy.isclose(speeds.runs[case]["speed_hz"], speed).any()
    amplitudes = speeds.harmonics[case]
    assert len(amplitudes) == len(speeds.runs[case]["speed_hz"]) and {len(each) for each in amplitudes} == {40}


def test_a_map_is_shown_and_saved_as_the_command_does(speeds: coilsense.SpeedMap, tmp_path: pathlib.Path) -> None:
    assert speeds.answer[0] in str(speeds)
    assert speeds.save(tmp_path / "map", date="2026-11-22") == 4
    assert json.loads((tmp_path / "map/results.json").read_text()) == speeds.to_dict()
    frame = speeds.to_pandas()
    assert list(frame.columns[:2]) == ["case", "speed_hz"] and len(frame) == len(speeds.to_dict()["runs"])
    assert speeds._repr_html_().count("<tr>") == 1 + len(speeds.crossings)
    table = (tmp_path / "map/speed.csv").read_text().splitlines()
    assert len(table) == 1 + len(frame) and table[0].startswith("speed [rpm],case,F_i least [N]")


def test_parquet_holds_what_the_csv_does(speeds: coilsense.SpeedMap, tmp_path: pathlib.Path) -> None:
    parquet = pytest.importorskip("pyarrow.parquet")
    speeds.save(tmp_path / "map")
    titles = (tmp_path / "map/speed.csv").read_text().splitlines()[0].split(",")
    table = parquet.read_table(tmp_path / "map/speed.parquet")
    assert table.column_names == titles
    (case,) = speeds.cases
    numpy.testing.assert_allclose(table["speed [rpm]"], 60 * speeds.runs[case]["speed_hz"])
    assert table["Goodman factor [1]"].null_count in (0, len(table))


def test_what_is_no_map_is_refused_in_a_line() -> None:
    with pytest.raises(coilsense.Error, match="to must be from 3000 to 600000 rpm, got 1200 rpm"):
        coilsense.speed(TRAIN, 50, 20)
    with pytest.raises(coilsense.Error, match=r"no table \[cam\]"):
        coilsense.speed(coilsense.Spec.parse(chain().partition("[cam]")[0]), 50, 60)


def test_progress_stops_the_work() -> None:
    def tell(done: int, of: int) -> None:
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        coilsense.speed(TRAIN, 20, 100, progress=tell)


def test_what_windings_did_is_with_each_case() -> None:
    condition = (
        '\n[[condition]]\nname = "shaken"\nkind = "harmonic"\nlength = "mid"\namplitude = "5 mm"\nfrequency = "390 Hz"\n'
        'window = ["0 s", "50 ms"]\nsample_rate = "20 kHz"\n'
    )
    text = chain().replace('follower_mass = "80 g"', "").partition("[cam]")[0] + condition
    (case,) = coilsense.simulate(coilsense.Spec.parse(text))
    contact = case.contact
    assert contact is not None
    touches = contact["touches"]
    assert len(touches["between"]) == len(touches["time"]) > 3
    assert contact["first_contact"] <= touches["time"][0] and (touches["closing_speed"] > 0).any()
    assert sum(meeting["touches"] for meeting in contact["meetings"]) == len(touches["time"])
    assert contact["energy_lost"] > 0 and len(contact["floats"]["time"]) == 0
    # Without the table windings pass through one another, and nobody asks.
    (plain,) = coilsense.simulate(coilsense.Spec.parse(text.replace('[contact]\nwindings = "hard"\nrestitution = 0.0', "")))
    assert plain.contact is None
