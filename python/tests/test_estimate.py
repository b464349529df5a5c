"""An estimate is shown with the digits that mean something, moved and stretched by numbers, and never given a wrong doubt."""

import operator
import pickle
import typing

import pytest

import coilsense

STIFFNESS = coilsense.Estimate(760.0, 0.5, 1.0)


@pytest.mark.parametrize(
    ("value", "half", "text"),
    [
        (12.3412, 0.05, "12.341 ± 0.050"),
        (12.3412, 0.0523, "12.341 ± 0.052"),
        (760.0, 1.0, "760.0 ± 1.0"),
        (54.06, 0.99, "54.06 ± 0.99"),
        (54.06, 0.996, "54.1 ± 1.0"),
        (-0.5, 0.02, "-0.500 ± 0.020"),
        (123456.0, 2345.0, "123500 ± 2300"),
        (0.065, 0.0011, "0.0650 ± 0.0011"),
        (2.4e-6, 3e-8, "(2.400 ± 0.030)e-06"),
        (0.0, 2.5, "0.0 ± 2.5"),
        (1.0, 20.0, "1 ± 20"),
        (5.0, 0.0, "5 ± 0"),
        (5.0, float("inf"), "5 ± inf"),
        (float("nan"), 1.0, "NaN ± 1"),
    ],
)
def test_it_is_shown_with_the_digits_that_its_interval_has_a_say_in(value: float, half: float, text: str) -> None:
    shown = str(coilsense.Estimate(value, half / 2, half))
    assert shown == text
    assert f"{coilsense.Estimate(value, half / 2, half)}" == shown


def test_a_format_of_floats_is_that_of_both_numbers() -> None:
    assert f"{STIFFNESS:.2f}" == "760.00 ± 1.00"
    assert f"{STIFFNESS:.1e}" == "7.6e+02 ± 1.0e+00"
    assert f"{coilsense.Estimate(0.005, 1e-4, 2e-4):.2%}" == "0.50% ± 0.02%"
    with pytest.raises(ValueError, match="format"):
        f"{STIFFNESS:q}"


def test_numbers_move_and_stretch_the_interval() -> None:
    def parts(estimate: coilsense.Estimate) -> tuple[float, float, float]:
        return estimate.value, estimate.standard, estimate.expanded

    assert parts(STIFFNESS + 40) == parts(40 + STIFFNESS) == (800.0, 0.5, 1.0)
    assert parts(STIFFNESS - 60) == (700.0, 0.5, 1.0)
    assert parts(1000 - STIFFNESS) == (240.0, 0.5, 1.0)
    assert parts(STIFFNESS * -2) == parts(-2 * STIFFNESS) == (-1520.0, 1.0, 2.0)
    assert parts(STIFFNESS / 2) == (380.0, 0.25, 0.5)
    assert parts(-STIFFNESS) == (-760.0, 0.5, 1.0) and parts(+STIFFNESS) == parts(STIFFNESS) == parts(abs(-STIFFNESS))
    assert pickle.loads(pickle.dumps(STIFFNESS * 2)) == STIFFNESS * 2


@pytest.mark.parametrize("operation", [operator.add, operator.sub, operator.mul, operator.truediv])
def test_two_estimates_are_not_put_together(operation: typing.Callable[[object, object], object]) -> None:
    for other in (STIFFNESS, coilsense.Estimate(1.0, 0.1, 0.2)):
        with pytest.raises(TypeError, match="may share their errors"):
            operation(STIFFNESS, other)
    with pytest.raises(TypeError):
        operation(STIFFNESS, "1")


def test_what_has_no_even_interval_is_refused() -> None:
    one: typing.Any = STIFFNESS
    with pytest.raises(TypeError, match="is not even about its value; take it of low and high"):
        1 / one
    with pytest.raises(TypeError, match="not supported"):
        one < 800  # noqa: B015
    with pytest.raises(TypeError, match="unsupported operand"):
        one**2
    with pytest.raises(ZeroDivisionError):
        STIFFNESS / 0
    with pytest.raises(coilsense.Error, match="whose interval holds zero has another interval, got 0.5 ± 1.0"):
        abs(coilsense.Estimate(0.5, 0.5, 1.0))


def test_uncertainties_goes_on_with_it_and_a_difference_with_itself_is_zero() -> None:
    pytest.importorskip("uncertainties")
    variable = STIFFNESS.to_ufloat()
    assert (variable.nominal_value, variable.std_dev) == (760.0, 0.5)
    assert (STIFFNESS.to_ufloat() - variable).std_dev == 0
    assert (1 / variable).std_dev == pytest.approx(0.5 / 760**2)
    other = coilsense.Estimate(760.0, 0.5, 1.0).to_ufloat()
    assert (other - variable).std_dev == pytest.approx(0.5 * 2**0.5)
