"""Every outcome is drawn into the axes that it is given, and becomes a data frame."""

import functools
import pathlib
import tempfile
import typing

import numpy
import pytest
import samples
import sweeps

import coilsense

pandas = pytest.importorskip("pandas")
pyplot = pytest.importorskip("matplotlib.pyplot")

DAMPED = coilsense.Spec.template("S_T").replace('end2 = "held"', 'end2 = "held"\ndamping_ratio = 0.005', 1)
LOOP = DAMPED + '\n[control]\ndrive = "velocity"\nsample_time = "0.4 ms"\n'
VALVE = pathlib.Path(__file__).parents[2] / "examples" / "valve-train.toml"
OVER = {"spring.stiffness": "600..900 N/m", "spring.max_length": "250..264 mm"}


@functools.cache
def _designs() -> coilsense.SweepDataset:
    folder = pathlib.Path(tempfile.mkdtemp()) / "sweep"
    return coilsense.sweep(sweeps.SPEC, OVER, folder, sampling="saltelli", rows=32, columns=["f1", "nominal_force"])


def _rig() -> coilsense.Experiment:
    folder = pathlib.Path(tempfile.mkdtemp())
    settings = '\n[rig]\nfrequencies = 5\nduration = "8 s"\nreadings = 10\nhits = 1\n'
    coilsense.rig(DAMPED + settings, folder / "rig", seed=3)
    return coilsense.experiment(folder / "rig")


def _speeds() -> coilsense.SpeedMap:
    text = VALVE.read_text().replace("[0.002, 0.01]", "0.01").replace("windings = 5.75", "windings = 5.75\nmasses_per_winding = 1")
    return coilsense.speed(text.replace('windings = "hard"', 'windings = "hard"\nrestitution = 0.0'), "3000 rpm", "4000 rpm", step="1000 rpm")


MADE: dict[str, typing.Callable[[], typing.Any]] = {
    "Analysis": lambda: coilsense.analyze(sweeps.SPEC),
    "Calibration": lambda: coilsense.calibrate(([0.2, 0.23, 0.26], [3e-6, 2.6e-6, 2.3e-6])),
    "Case": lambda: coilsense.simulate(sweeps.SPEC)[0],
    "ChainModes": lambda: coilsense.ChainModes(samples.SPRING),
    "Experiment": _rig,
    "Identification": lambda: coilsense.identify(samples.hit_log(seconds=6)),
    "Mitigation": lambda: coilsense.mitigate(DAMPED, samples.hit_log(seconds=6)),
    "Pareto": lambda: coilsense.pareto(_designs(), minimize="nominal_force", maximize="f1"),
    "Placement": lambda: coilsense.placement(LOOP),
    "Plant": lambda: coilsense.plant(sweeps.SPEC, damping_ratio=0.005, modes=5),
    "Recording": lambda: coilsense.Recording(samples.hit_log(seconds=6)),
    "Sensitivity": lambda: coilsense.sensitivity(_designs(), resamples=20),
    "Signals": lambda: samples.hit_log(seconds=6),
    "Spectrum": lambda: coilsense.Spectrum(numpy.arange(100) / 100, numpy.sin(numpy.arange(100))),
    "SpeedMap": _speeds,
    "SweepDataset": _designs,
    "Together": lambda: coilsense.simulate_together(sweeps.SPEC)[0],
    "TwoPort": lambda: coilsense.TwoPort(samples.SPRING, coilsense.Damping.modal(0.005)),
    "Windings": lambda: coilsense.Motion(samples.SPRING, samples.IMPACT).windings([0.0, 0.01, 0.02]),
}

#: What a figure needs to be told.
TOLD: dict[str, tuple[object, ...]] = {"SweepDataset": ("spring.stiffness [N/m]", "f1 [Hz]"), "TwoPort": (numpy.linspace(1, 200, 50),)}


def test_all_that_can_be_drawn_is_drawn_here() -> None:
    drawn = {name for name in coilsense.__all__ if hasattr(getattr(coilsense, name), "plot")}
    assert drawn == MADE.keys()
    outcomes = {name for name in coilsense.__all__ if hasattr(getattr(coilsense, name), "_repr_html_")} - {"Spring", "Deviation"}
    assert outcomes <= MADE.keys()


@pytest.mark.parametrize("name", MADE)
def test_it_is_drawn_into_the_axes_that_are_given_and_becomes_a_data_frame(name: str) -> None:
    made, told = MADE[name](), TOLD.get(name, ())
    figure, (left, right) = pyplot.subplots(1, 2)
    assert made.plot(*told, ax=right) is right
    assert right.has_data() and not left.has_data()
    assert right.get_xlabel() and (right.get_ylabel() or right.get_yticklabels())
    figure.canvas.draw()
    new = made.plot(*told)
    assert new.figure is not figure and new.has_data()
    with pytest.raises(TypeError, match="^ax must be the Axes of a figure of matplotlib, got Figure$"):
        made.plot(*told, ax=pyplot.figure())
    pyplot.close("all")
    if name != "TwoPort":
        frame = made.to_pandas()
        assert isinstance(frame, pandas.DataFrame) and len(frame) > 0 and len(frame.columns) > 1


def test_a_case_s_frame_holds_what_its_sensors_mean() -> None:
    case = coilsense.simulate(sweeps.SPEC)[0]
    frame = case.to_pandas()
    assert [*case.signals, *case.forces] == list(frame.columns)
    numpy.testing.assert_array_equal(frame["F_o"], case.signals["F_o"])
    analysis = coilsense.analyze(sweeps.SPEC).to_pandas()
    row = analysis[(analysis["condition"] == case.condition) & (analysis["force"] == "F_o")].iloc[0]
    assert row["rmsd"] == case.deviations["F_o"].rmsd
