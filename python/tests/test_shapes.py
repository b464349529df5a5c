"""One number in, one number out; an array in, an array of its shape out: what NumPy's own functions do."""

import fractions
import typing

import numpy
import pytest
from samples import IMPACT, SPRING

import coilsense

MOTION = coilsense.Motion(SPRING, IMPACT)
LENGTHS = numpy.linspace(0.2, 0.26, 7)
CALIBRATION = coilsense.calibrate((LENGTHS, (1 / LENGTHS - 0.4) / 1.5e6))
STORED = coilsense.open_calibration
COIL = coilsense.MaxwellSum(SPRING)
METER = coilsense.InductanceSensor.theoretical(COIL, 0.23)
ENCODERS = coilsense.TwoEncoder(SPRING, compliance="10 um/N", backlash="0.2 mm", mean_length="204 mm")
STEEL = coilsense.Material.named("steel EN 10270-1")
GEOMETRY = coilsense.Geometry.of_spring(SPRING, "hooks", STEEL)

#: Functions that work number by number; a value that they take, and the same as a text.
NUMBER_BY_NUMBER: dict[str, tuple[typing.Callable[[typing.Any], typing.Any], float, str]] = {
    "Calibration.length": (CALIBRATION.length, 2.5e-6, "2.5 uH"),
    "Calibration.inductance": (CALIBRATION.inductance, 0.23, "230 mm"),
    "Damping.ratios": (coilsense.Damping.modal(0.005).ratios, 54.0, "54 Hz"),
    "EndInput.displacement": (coilsense.EndInput.ramp(0.01, 0.1, 0.2).displacement, 0.2, "200 ms"),
    "EndInput.velocity": (coilsense.EndInput.ramp(0.01, 0.1, 0.2).velocity, 0.2, "200 ms"),
    "Geometry.shear_stress": (GEOMETRY.shear_stress, 100.0, "0.1 kN"),
    "Geometry.corrected_shear_stress": (GEOMETRY.corrected_shear_stress, 100.0, "0.1 kN"),
    "InductanceSensor.force": (METER.force, 3e-6, "3 uH"),
    "Material.impact_stress": (STEEL.impact_stress, 0.25, "25 cm/s"),
    "MaxwellSum.at_lengths": (COIL.at_lengths, 0.23, "230 mm"),
    "Motion.end_forces, F_i": (lambda times: MOTION.end_forces(times)[0], 0.1, "100 ms"),
    "Motion.end_forces, F_o": (lambda times: MOTION.end_forces(times)[1], 0.1, "100 ms"),
    "Motion.energy": (MOTION.energy, 0.1, "100 ms"),
    "Readout.lag": (coilsense.Readout(bandwidth=1e3).lag, 100.0, "0.1 kHz"),
    "Readout.response": (coilsense.Readout(bandwidth=1e3).response, 100.0, "0.1 kHz"),
    "Spring.static_force": (SPRING.static_force, 0.23, "230 mm"),
    "Spring.pitch_at": (SPRING.pitch_at, 0.23, "230 mm"),
    "Spring.in_operating_range": (SPRING.in_operating_range, 0.23, "230 mm"),
    "TwoEncoder.force": (ENCODERS.force, 0.2, "20 cm"),
    "TwoEncoder.elongation": (lambda u2: ENCODERS.elongation(0.0, u2, 76.0), 0.2, "20 cm"),
    "alias_of": (lambda frequency: coilsense.alias_of(frequency, 100), 54.0, "54 Hz"),
    "mutual_inductances": (lambda distances: coilsense.mutual_inductances("8 mm", distances), 0.008, "8 mm"),
    "theories": (lambda lengths: coilsense.theories(SPRING, lengths)["Maxwell sum"], 0.23, "230 mm"),
}


@pytest.mark.parametrize("name", NUMBER_BY_NUMBER)
def test_a_number_gives_a_number_and_an_array_one_of_its_shape(name: str) -> None:
    function, value, text = NUMBER_BY_NUMBER[name]
    alone = function(value)
    assert type(alone) in (float, complex, bool)
    for same in (text, numpy.float64(value), numpy.array(value), fractions.Fraction(value)):
        assert function(same) == alone and type(function(same)) is type(alone)
    grid = numpy.full((2, 3), value)
    given: typing.Any
    none: list[typing.Any] = [] if name.startswith("Motion.end_forces") else [grid[:0]]
    for given in (grid, grid.tolist(), grid[:, ::2], numpy.asfortranarray(grid), grid[None], *none):
        found = function(given)
        assert found.shape == numpy.shape(given) and found.dtype == type(alone)
        # Many forces at once are summed in another order.
        numpy.testing.assert_allclose(found, alone, rtol=1e-12)


@pytest.mark.parametrize("name", NUMBER_BY_NUMBER)
@pytest.mark.parametrize("wrong", [None, [1.0, None], [1j], [[1.0, 2.0], [3.0]], numpy.array([True]), object(), {}, b"1", ["1 mm"]], ids=lambda wrong: "object" if type(wrong) is object else repr(wrong))
def test_what_numpy_would_take_for_numbers_is_refused_by_the_argument_s_name(name: str, wrong: object) -> None:
    function = NUMBER_BY_NUMBER[name][0]
    with pytest.raises(TypeError, match=r"^\w+ must be a number, a text with its unit, or an array of real numbers, got "):
        function(wrong)


def test_the_order_of_rows_is_kept() -> None:
    grid = LENGTHS[:6].reshape(2, 3)
    for given in (grid, numpy.asfortranarray(grid), grid.T.copy().T):
        assert (SPRING.static_force(given) == [[SPRING.static_force(float(length)) for length in row] for row in grid]).all()


def test_positions_of_the_ends_come_behind_the_dimensions_of_the_times() -> None:
    assert MOTION.ends(0.1).shape == (2,)
    assert MOTION.ends(numpy.full((3, 4), 0.1)).shape == (3, 4, 2)
    assert (MOTION.ends([[0.1, 0.2]])[0, 1] == MOTION.ends(0.2)).all()


def test_shapes_that_go_together_are_spread_and_others_named() -> None:
    wide = ENCODERS.elongation([[0.0], [0.001]], [0.2, 0.21, 0.22], 76.0)
    assert wide.shape == (2, 3)
    assert wide[1, 2] == ENCODERS.elongation(0.001, 0.22, 76.0)
    with pytest.raises(coilsense.Error, match=r"^u1, u2, f_i must have shapes that go together, got \(2\), \(3\), \(\)"):
        ENCODERS.elongation([0.0, 0.0], [0.2, 0.2, 0.2], 76.0)


@pytest.mark.parametrize("wrong", [0.1, [[0.0, 0.1]], numpy.zeros((2, 2))], ids=repr)
def test_what_needs_an_order_takes_one_dimension(wrong: typing.Any) -> None:
    with pytest.raises(TypeError, match="^times must be a series of real numbers, got "):
        MOTION.signals(wrong)
    with pytest.raises(TypeError, match="^times must be a series of real numbers, got "):
        coilsense.Readout(delay=0.1).series(wrong, [0.0, 1.0])
    with pytest.raises(TypeError, match="^positions must be rows of real numbers, all of one length, got list"):
        coilsense.Windings([[0.0, 0.2]], [0.1])


def test_a_calibration_of_a_file_gives_its_doubt_in_the_same_shape(tmp_path: typing.Any) -> None:
    (tmp_path / "calibration.toml").write_text(CALIBRATION.stored("2026-11-21"))
    stored = STORED(tmp_path / "calibration.toml")
    length, doubt = stored.length("2.5 uH")
    assert (type(length), type(doubt)) == (float, float)
    lengths, doubts = stored.length([[2.5e-6, 2.6e-6]])
    assert lengths.shape == doubts.shape == (1, 2) and lengths[0, 0] == length and doubts[0, 0] == doubt
    assert numpy.shape(stored.re_zeroed("230 mm", "2.6 uH").force([2.5e-6])) == (2, 1)
