"""Quantities with their unit: texts as a spec has them, numbers of a library of units, and numbers in units that nobody meant."""

import copy
import pickle
import typing

import numpy
import pytest
from samples import SPRING

import coilsense

IN_TEXTS: dict[str, typing.Any] = {
    "rest_length": "104 mm", "windings": 52, "coil_radius": "8 mm", "wire_radius": "1 mm", "mass": "65 g", "stiffness": "0.76 N/mm",
    "min_length": "19.6 cm", "max_length": "264 mm",
}

#: A noun or a number by texts, and the same in SI.
SAME: dict[str, tuple[typing.Callable[[], object], typing.Callable[[], object]]] = {
    "Spring": (lambda: coilsense.Spring(**IN_TEXTS), lambda: SPRING),
    "Spring.static_force": (lambda: SPRING.static_force("264 mm"), lambda: SPRING.static_force(0.264)),
    "Spring.in_operating_range": (lambda: SPRING.in_operating_range("264 mm"), lambda: True),
    "Excitation": (lambda: coilsense.Excitation("230 mm"), lambda: coilsense.Excitation(0.23)),
    "Excitation.impact": (lambda: coilsense.Excitation.impact("230 mm", "25 cm/s"), lambda: coilsense.Excitation.impact(0.23, 0.25)),
    "Excitation.end_stop": (lambda: coilsense.Excitation.end_stop("0.23 m", "0.25 m/s"), lambda: coilsense.Excitation.end_stop(0.23, 0.25)),
    "EndInput.harmonic": (lambda: coilsense.EndInput.harmonic("5 mm", "10 Hz", "90 deg"), lambda: coilsense.EndInput.harmonic(5e-3, 10, numpy.pi / 2)),
    "EndInput.step": (lambda: coilsense.EndInput.step("5 N", "20 ms"), lambda: coilsense.EndInput.step(5.0, 0.02)),
    "EndInput.chirp": (lambda: coilsense.EndInput.chirp("1 mm", "1 Hz", "0.5 kHz", "2 s"), lambda: coilsense.EndInput.chirp(1e-3, 1, 500, 2)),
    "EndInput.ramp": (lambda: coilsense.EndInput.ramp("1 mm", "1 ms", "2 ms"), lambda: coilsense.EndInput.ramp(1e-3, 1e-3, 2e-3)),
    "EndInput.half_sine": (lambda: coilsense.EndInput.half_sine("1 mm", "1 ms", "2 ms"), lambda: coilsense.EndInput.half_sine(1e-3, 1e-3, 2e-3)),
    "Start.moving": (lambda: coilsense.Start.moving("25 cm/s"), lambda: coilsense.Start.moving(0.25)),
    "FarEnd.mass": (lambda: coilsense.FarEnd.mass("500 g"), lambda: coilsense.FarEnd.mass(0.5)),
    "Load.mass": (lambda: coilsense.Load.mass("500 g"), lambda: coilsense.Load.mass(0.5)),
    "Damping.modal": (lambda: coilsense.Damping.modal("0.5 %"), lambda: coilsense.Damping.modal(0.005)),
    "Readout": (
        lambda: coilsense.Readout(bandwidth="1 kHz", delay="1 ms", averaging="2 ms", sample_rate="5 kHz"),
        lambda: coilsense.Readout(bandwidth=1e3, delay=1e-3, averaging=2e-3, sample_rate=5e3),
    ),
    "sampled_window": (
        lambda: coilsense.sampled_window("10 kHz", "750 ms", "1 s").tolist(), lambda: coilsense.sampled_window(1e4, 0.75, 1.0).tolist()
    ),
    "third_rule_frequency": (lambda: coilsense.third_rule_frequency(SPRING, "500 g"), lambda: coilsense.third_rule_frequency(SPRING, 0.5)),
    "alias_of": (lambda: coilsense.alias_of("54 Hz", "0.1 kHz"), lambda: coilsense.alias_of(54.0, 100.0)),
    "Live": (lambda: coilsense.Live(SPRING, "230 mm", "1 ms").advance(0, 0.23), lambda: coilsense.Live(SPRING, 0.23, 1e-3).advance(0, 0.23)),
}


@pytest.mark.parametrize("name", SAME)
def test_a_text_with_its_unit_is_the_number_in_si(name: str) -> None:
    by_text, by_number = SAME[name]
    assert by_text() == by_number()


def test_a_unit_of_another_quantity_is_refused_by_name() -> None:
    wanted = r'rest_length must be a number in m or a length with its unit \(m, .*mm.*\), got "104 g"'
    with pytest.raises(coilsense.Error, match=wanted):
        coilsense.Spring(**IN_TEXTS | {"rest_length": "104 g"})
    with pytest.raises(coilsense.Error, match='velocity must be a number in m/s or a velocity with its unit .*, got "0.25"'):
        coilsense.Excitation.impact("230 mm", "0.25")
    with pytest.raises(coilsense.Error, match='height must be a number in m or N or a length .* or a force .*, got "5 Hz"'):
        coilsense.EndInput.step("5 Hz", 0.1)
    with pytest.raises(TypeError, match="bandwidth must be a number in Hz or a frequency .*, got list"):
        coilsense.Readout(bandwidth=typing.cast(float, [1, 2]))


def test_a_number_of_pint_is_converted_or_refused() -> None:
    pint = pytest.importorskip("pint")
    unit = pint.UnitRegistry()
    of_pint = {name: unit(text) if isinstance(text, str) else text for name, text in IN_TEXTS.items()}
    made, kept = coilsense.Spring(**of_pint), SPRING.to_dict()
    for name, value in made.to_dict().items():
        assert value == pytest.approx(kept[name], rel=1e-15) if value is not None else kept[name] is None
    assert coilsense.Readout(bandwidth=unit("1 kHz")) == coilsense.Readout(bandwidth=1e3)
    with pytest.raises(TypeError, match="mass must be a number in kg or a mass .*, got 65 millimeter"):
        coilsense.Spring(**IN_TEXTS | {"mass": unit("65 mm")})
    # To pint a turn is 2 pi: 60 rpm would be 6.28 Hz.
    with pytest.raises(TypeError, match="frequency must be a number in Hz"):
        coilsense.EndInput.harmonic(1e-3, unit("60 rpm"))
    motion = coilsense.Motion(SPRING, coilsense.Excitation.impact(0.23, 0.25))
    for door in (motion.end_forces, motion.signals, motion.windings, lambda times: coilsense.Signals(times, {"F_o": [1.0, 2.0]})):
        with pytest.raises(TypeError, match="must be plain numbers in SI, got an array in millisecond"):
            door([0.0, 1.0] * unit.ms)


@pytest.mark.parametrize(
    "wrong",
    [
        {"mass": 65},
        {"coil_radius": 8, "wire_radius": 1},
        {"mass": 65, "rest_length": 104, "coil_radius": 8, "wire_radius": 1, "stiffness": 0.76, "min_length": 196, "max_length": 264},
        {"rest_length": 104, "coil_radius": 8, "wire_radius": 1, "min_length": 196, "max_length": 264},
        {"mass": 65e-6},
    ],
    ids=["grams", "radii in mm", "grams, mm", "mm", "tonnes"],
)
def test_a_wire_that_no_metal_makes_is_refused_with_the_reason(wrong: dict[str, float]) -> None:
    with pytest.raises(coilsense.Error, match=r"density of the wire.* from 250 to 250000 kg/m³: is the mass in kg, and every length in m\?"):
        coilsense.Spring(**SPRING.to_dict() | wrong)


@pytest.mark.parametrize("density", [900, 1150, 1740, 4500, 7850, 19_300, 21_450], ids=lambda density: f"{density} kg/m³")
@pytest.mark.parametrize("share", [1 / 3, 1, 3])
def test_every_material_is_let_through_with_its_ends_or_hollow(density: float, share: float) -> None:
    mass = SPRING.mass * density / 7916 * share
    assert coilsense.Spring(**SPRING.to_dict() | {"mass": mass}).mass == mass


def test_a_spec_s_spring_may_weigh_what_it_likes_and_still_travels() -> None:
    text = coilsense.Spec.template("S_T").replace('mass = "65 g"', 'mass = "65 kg"', 1)
    spring = coilsense.Spec.parse(text).spring
    assert spring.mass == 65
    assert pickle.loads(pickle.dumps(spring)) == copy.deepcopy(spring) == spring
