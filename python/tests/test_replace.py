"""The same with other arguments: every value, checked as its constructor checks it."""

import copy
import sys
import typing

import pytest
import samples

import coilsense

SPRING = samples.SPRING


def _replaceable() -> list[typing.Any]:
    return [value for value in samples.values() if not isinstance(value, coilsense.Cascade | coilsense.Signals | coilsense.Windings | coilsense.Spec)]


def _called(value: object) -> str:
    return f"{type(value).__name__}.{getattr(value, 'kind', '')}"


@pytest.mark.parametrize("value", _replaceable(), ids=_called)
def test_nothing_replaced_is_the_same_and_a_name_that_is_none_is_refused_with_those_there_are(value: typing.Any) -> None:
    assert value.replace() == value == value.__replace__()
    assert type(value.replace()) is type(value)
    with pytest.raises(TypeError, match=rf"^replace\(\) of {type(value).__name__}\S* takes .*, got colour$") as caught:
        value.replace(colour="red")
    known = [name for name in value.to_dict() if name not in ("kind", "modes")]
    assert ", ".join(known) in str(caught.value) or not known


def test_one_argument_is_replaced_the_others_stay() -> None:
    heavier = SPRING.replace(mass="80 g", max_length=0.27)
    assert heavier == coilsense.Spring(**SPRING.to_dict() | {"mass": 0.08, "max_length": 0.27})
    assert SPRING.mass == 0.065
    excitation = samples.IMPACT.replace(mean_length="240 mm")
    assert excitation == coilsense.Excitation.impact(0.24, 0.25)
    assert coilsense.EndInput.ramp(0.01, 0.1, 0.2).replace(height="5 mm") == coilsense.EndInput.ramp(0.005, 0.1, 0.2)
    mount = coilsense.Mount(coilsense.FarEnd.mass(0.5), coilsense.Damping.modal(0.005))
    assert mount.replace(far_end=None) == coilsense.Mount(damping=coilsense.Damping.modal(0.005))
    motion = coilsense.Motion(SPRING, samples.IMPACT).truncated(3)
    assert motion.replace(spring=heavier) == coilsense.Motion(heavier, samples.IMPACT).truncated(3)


def test_what_the_constructor_refuses_is_refused() -> None:
    with pytest.raises(coilsense.Error, match="stiffness must be above zero and finite, got -1 N/m"):
        SPRING.replace(stiffness=-1)
    with pytest.raises(coilsense.Error, match="density of the wire"):
        SPRING.replace(mass=65)
    with pytest.raises(coilsense.Error, match='mass must be a number in kg or a mass with its unit .*, got "80 mm"'):
        SPRING.replace(mass="80 mm")
    with pytest.raises(TypeError, match="takes nothing, got amplitude"):
        coilsense.EndInput.held().replace(amplitude=1.0)
    with pytest.raises(TypeError, match="takes height, begin, duration, got kind"):
        coilsense.EndInput.ramp(0.01, 0.1, 0.2).replace(kind="step")


def test_a_spring_of_a_spec_keeps_the_mass_that_it_was_given() -> None:
    heavy = coilsense.Spec.parse(coilsense.Spec.template("S_T").replace('mass = "65 g"', 'mass = "65 kg"', 1)).spring
    assert heavy.replace(stiffness="0.8 N/mm").mass == 65


@pytest.mark.skipif(sys.version_info < (3, 13), reason="copy.replace came with Python 3.13")
def test_copy_replace_is_the_same() -> None:
    assert getattr(copy, "replace")(SPRING, mass=0.08) == SPRING.replace(mass=0.08)
