"""Over frequency, from wire to rate, and through an instrument: laws and limits where two models meet."""

import numpy
import pytest
from samples import SPRING

import coilsense

HERTZ = numpy.array([1.0, 10.0, 33.0])


def test_a_clamped_spring_has_the_transmittance_of_eq_1() -> None:
    wave = coilsense.TwoPort(SPRING, model="wave")
    wanted = 1 / numpy.cos(2 * numpy.pi * HERTZ * SPRING.transit_time)
    numpy.testing.assert_allclose(wave.transmittance(HERTZ), wanted, rtol=1e-12)  # closed forms of one number


def test_matrices_are_each_others_inverses_and_obey_reciprocity() -> None:
    ends = coilsense.TwoPort(SPRING, coilsense.Damping.modal(0.01))
    stiffness, receptance = ends.matrix(HERTZ), ends.receptance(HERTZ)
    assert stiffness.shape == (3, 2, 2) and stiffness.dtype == complex
    identity = numpy.broadcast_to(numpy.eye(2), (3, 2, 2))
    numpy.testing.assert_allclose(stiffness @ receptance, identity, atol=1e-9)  # condition number about 1e3
    numpy.testing.assert_allclose(stiffness[:, 0, 1], -stiffness[:, 1, 0], rtol=1e-14)
    numpy.testing.assert_allclose(numpy.linalg.det(ends.transmission(HERTZ)), 1, rtol=1e-10)


def test_a_mass_is_the_load_whose_stiffness_is_minus_m_omega_squared() -> None:
    ends = coilsense.TwoPort(SPRING)
    for frequency in HERTZ:
        same = coilsense.Load.stiffness(-0.3 * (2 * numpy.pi * frequency) ** 2)
        by_mass, by_stiffness = (ends.motion_ratio([frequency], load) for load in (coilsense.Load.mass(0.3), same))
        numpy.testing.assert_allclose(by_mass, by_stiffness, rtol=1e-14)


def test_modes_are_the_eigenvalues_of_the_chain() -> None:
    count, rate = SPRING.chain_masses, SPRING.stiffness * SPRING.chain_masses
    # eqs. 5-6: half segments at both ends are twice as stiff.
    diagonal = numpy.full(count, 2.0)
    diagonal[[0, -1]] = 3.0
    matrix = numpy.diag(diagonal) - numpy.eye(count, k=1) - numpy.eye(count, k=-1)
    wanted = numpy.sqrt(numpy.linalg.eigvalsh(matrix) * rate * count / SPRING.mass)
    modes = coilsense.ChainModes(SPRING)
    numpy.testing.assert_allclose(modes.angular_frequencies, wanted, rtol=1e-11)  # LAPACK's own
    numpy.testing.assert_allclose(modes.frequencies, wanted / (2 * numpy.pi), rtol=1e-11)


def test_one_frequency_has_one_number_at_every_door() -> None:
    """Hz, whichever noun is asked."""
    first = coilsense.ChainModes(SPRING).frequencies[0]
    assert f"{first:.6f} Hz" in repr(coilsense.ChainModes(SPRING)) and coilsense.ChainModes(SPRING).to_dict()["frequencies"][0] == first
    assert first == pytest.approx(SPRING.surge_frequency, rel=2e-4)  # 52 masses are not a continuous coil
    assert coilsense.continuous_frequency(SPRING.transit_time, 1) == pytest.approx(SPRING.surge_frequency, rel=1e-14)
    held = coilsense.continuous_frequencies(SPRING, coilsense.FarEnd.position(), 3)
    numpy.testing.assert_allclose(held, SPRING.surge_frequency * numpy.array([1, 2, 3]), rtol=1e-14)
    grid = numpy.linspace(40, 70, 3001)
    # With one end held, the other's motion is felt the most where the chain between held ends rings.
    felt = abs(coilsense.TwoPort(SPRING, coilsense.Damping.modal(0.005)).transfer(grid))
    assert grid[felt.argmax()] == pytest.approx(first, abs=0.02)  # of a grid of 0.01 Hz
    time = 1e-5
    assert coilsense.Damping.stiffness_proportional(time).ratios([first])[0] == pytest.approx(numpy.pi * first * time, rel=1e-14)
    heavy = 100 * SPRING.mass
    by_rule = coilsense.third_rule_frequency(SPRING, heavy)
    exact = coilsense.continuous_frequencies(SPRING, coilsense.FarEnd.mass(heavy), 1)[0]
    assert by_rule / exact - 1 == pytest.approx(coilsense.third_rule_error(SPRING, heavy), abs=1e-12)
    assert by_rule == pytest.approx((SPRING.stiffness / heavy) ** 0.5 / (2 * numpy.pi), rel=0.01)  # the spring adds a 300th


def test_a_geometry_gives_rate_and_mass_of_table_i() -> None:
    steel = coilsense.Material(shear_modulus=81.5e9, youngs_modulus=206e9, density=7850)
    wound = coilsense.Geometry.of_spring(SPRING, "hooks", steel)
    assert wound.stiffness == pytest.approx(760, rel=0.01)  # Table I is measured
    assert wound.active_mass == pytest.approx(0.065, rel=0.01)
    assert wound.surge_frequency == pytest.approx(0.5 * (wound.stiffness / wound.active_mass) ** 0.5, rel=1e-14)
    with pytest.raises(coilsense.Error, match='end type must be one of hooks, open, .*, got "hook"'):
        coilsense.Geometry.of_spring(SPRING, "hook", steel)  # type: ignore[arg-type]


def test_a_reading_lags_and_repeats_with_its_seed() -> None:
    times = numpy.arange(0, 1, 1e-3)
    late = coilsense.Readout(delay=0.01)
    numpy.testing.assert_allclose(late.series(times, times)[20:], times[20:] - 0.01, atol=1e-12)  # a straight line is exact
    noisy = coilsense.Readout(noise=1.0)
    numpy.testing.assert_array_equal(noisy.series(times, times, seed=3), noisy.series(times, times, seed=3))
    assert numpy.std(noisy.series(times, 0 * times, seed=3)) == pytest.approx(1.0, abs=0.1)  # of 1000 samples: 2 % standard error
    assert abs(coilsense.Readout(bandwidth=100).response([100.0])[0]) == pytest.approx(0.5**0.5, rel=1e-12)


def test_a_stream_goes_where_the_motion_goes() -> None:
    motion = coilsense.Motion(SPRING, coilsense.Excitation.impact(0.23, 0.25))
    times, F_i, F_o = motion.stream(1e-4).take(1000)
    batch = motion.end_forces(times)
    numpy.testing.assert_allclose([F_i, F_o], batch, atol=1e-10)  # 1e-12 of 98 N, as the engine states
    live = coilsense.Live(SPRING, 0.23, 1e-4)
    for _ in range(10):
        assert live.advance(0.0, 0.23)[1:] == pytest.approx((95.76, 95.76), abs=1e-9)  # at rest it stays
    with pytest.raises(coilsense.Error, match="u2 must be finite, got NaN m"):
        live.advance(0.0, numpy.nan)
    with pytest.raises(coilsense.Error, match="u2 - u1, the spring's length, must be above zero and finite, got 0 m"):
        live.advance(0.0, 0.0)
    assert live.advance(0.0, 0.23)[0] == pytest.approx(11e-4)  # what was refused is no step


@pytest.mark.parametrize("far_end", [coilsense.FarEnd.position(), coilsense.FarEnd.force(), coilsense.FarEnd.mass(0.5)], ids=lambda it: it.kind)
def test_a_live_spring_takes_what_signals_show(far_end: coilsense.FarEnd) -> None:
    times = 1e-4 * numpy.arange(400)
    shaken = coilsense.EndInput.sampled(times, 2e-3 * numpy.sin(60 * times))
    positions, forces = 1e-3 * numpy.sin(200 * times), 5 * numpy.sin(200 * times)
    pulled = coilsense.EndInput.sampled(times, positions if far_end.kind == "position" else forces)
    mount = coilsense.Mount(far_end, coilsense.Damping.modal(0.005))
    signals = coilsense.Motion(SPRING, coilsense.Excitation(0.23, end1=shaken, end2=pulled), mount).signals(times)
    live = coilsense.Live(SPRING, 0.23, 1e-4, mount)
    end2 = {"position": signals["u2"], "force": signals["F_o"], "mass": SPRING.static_force(0.23) + forces}[far_end.kind]
    felt = [live.advance(u1, end)[1:] for u1, end in zip(signals["u1"][1:], end2[1:])]
    expected = numpy.transpose([signals["F_i"], signals["F_o"]])[1:]
    numpy.testing.assert_allclose(felt, expected, atol=1e-8)  # N; u2 is a difference of two lengths here


def test_energy_stays_where_both_ends_are_held() -> None:
    motion = coilsense.Motion(SPRING, coilsense.Excitation.impact(0.23, 0.25))
    assert motion.energy(0.9) == pytest.approx(motion.energy(0.0), rel=1e-12)  # as the engine states
    assert motion.velocities(0.0) == pytest.approx(numpy.full(52, 0.25), rel=1e-10)
    assert motion.ends([0.0, 0.5]).tolist() == [[0.0, 0.23], [0.0, 0.23]]
