"""The spring as a coil: limits where two ways meet, and the paper's F_L."""

import numpy
import pytest
from samples import IMPACT, SPRING

import coilsense

COIL = coilsense.MaxwellSum(SPRING)


def test_the_force_by_inductance_is_as_good_as_table_ii_says() -> None:
    motion, times = coilsense.Motion(SPRING, IMPACT), coilsense.sampled_window(10_000, 0.75, 1.0)
    sensor = coilsense.InductanceSensor.theoretical(COIL, SPRING.mid_length)
    signals = motion.signals(times).inserted("F_L", sensor.force(COIL.series(motion.windings(times))))
    share = coilsense.Deviation.between(signals["F_L"], signals["F_x"]).relative_to(SPRING.nominal_force)
    assert abs(100 * share.rmsd - 0.01) < 0.01  # Table II prints two decimals


def test_the_second_order_form_stays_within_its_bound() -> None:
    uniform = (numpy.arange(52) + 0.5) / 52 * 0.23
    near = coilsense.SecondOrder(COIL, 0.23)
    random = numpy.random.default_rng(1)
    for size in (1e-6, 1e-5, 1e-4):
        displacements = random.normal(0, size, 52)
        inductance, bound = near.at_displacements(displacements)
        exact = COIL.at_positions(uniform + displacements)
        assert abs(inductance - exact) <= bound + 1e-14 * exact  # and rounding of the sum
    assert near.gradient.shape == (52,) and near.curvatures.shape == (51,)
    assert near.gradient == pytest.approx(-near.gradient[::-1], abs=1e-15)  # a coil is the same from both ends


def test_far_rings_are_dipoles() -> None:
    radius, distance = 0.008, 8.0
    dipole = 4e-7 * numpy.pi * numpy.pi * radius**4 / (2 * distance**3)
    far = coilsense.mutual_inductances(radius, [distance])[0]
    assert far == pytest.approx(dipole, rel=1e-5)  # the next term is 3 (r/h)^2


def test_one_name_stands_for_one_sum() -> None:
    lengths = numpy.linspace(SPRING.min_length, SPRING.max_length, 25)
    by_default = coilsense.MaxwellSum(SPRING).at_lengths(lengths)
    found = coilsense.theories(SPRING, lengths)
    numpy.testing.assert_array_equal(by_default, found["Maxwell sum"])
    # Rosa's correction for round wire was made without it.
    numpy.testing.assert_allclose(by_default, found["Nagaoka with Rosa's round-wire correction"], rtol=2e-3)
    printed = coilsense.MaxwellSum(SPRING, "as-printed").at_lengths(lengths)
    constant = 4e-7 * numpy.pi * SPRING.coil_radius * SPRING.windings * numpy.log(2)
    # The distance is small against the radius, not nothing: 1e-3 of what a ring's own inductance is made of.
    numpy.testing.assert_allclose(printed - by_default, constant, rtol=1e-2)
    coil = (lengths, by_default)
    assert "the nearest is Maxwell sum" in str(coilsense.calibrate(coil, spring=SPRING))


def test_theories_agree_on_a_long_coil() -> None:
    found = coilsense.theories(SPRING, [0.2, 0.26])
    reference = found["Maxwell sum"]
    for name, values in found.items():
        assert values == pytest.approx(reference, rel=0.1), name  # the ideal solenoid is off by about r/l
    assert numpy.isnan(coilsense.theories(SPRING, [-1.0])["Nagaoka"][0])
