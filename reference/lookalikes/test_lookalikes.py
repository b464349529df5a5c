"""The generator held against physics: `python3 bench.py --check`, or pytest. Each test is a sentence; it does not need the command."""

import sys
from pathlib import Path

import numpy as np
from scipy import integrate, optimize, signal

sys.path.insert(0, str(Path(__file__).parent))

from assembly import END1, END2, Assembly, Modes, first_held, held, tension  # noqa: E402
from kinds import KINDS, SPRINGS, make  # noqa: E402
from record import Instrument  # noqa: E402
from resonance_kinds import beam_roots  # noqa: E402
from spring import blows, plain, rig, simulate  # noqa: E402
from unsmooth import rubbing  # noqa: E402


def calm(seed, **options):
    """A rig with two hits on windings and no slow motion."""
    spring = rig(np.random.default_rng(seed), hits=2, **options)
    spring.where, spring.scene.slow = "winding", (0.0, 1.0)
    return spring


def test_the_chain_has_the_frequencies_of_its_closed_form():
    # An eigen-solver is good to its rounding of the highest mode: 1e-15 (w_100/w_1)^2 / 2 = 2e-12 of the first.
    assembly = Assembly()
    assembly.chain(END1, END2, 100, 0.065, 760.0)
    found = Modes(assembly, lambda f: 0 * f).angular / (2 * np.pi)
    number = np.arange(1, 101)
    expected = 2 * 100 * np.sqrt(760 / 0.065) * np.sin(number * np.pi / 200) / (2 * np.pi)
    assert np.abs(found / expected - 1).max() < 1e-10
    # The coil's own f1 is sqrt(k/m)/2; a chain lies pi^2/24 N^2 below it.
    assert abs(first_held(100, 0.065, 760.0) / (0.5 * np.sqrt(760 / 0.065) * (1 - np.pi**2 / 240_000)) - 1) < 1e-8


def test_the_spectrum_of_a_clean_spring_peaks_at_its_modes():
    spring = calm(3, first=40.0, rate=2500.0)
    spring.zeta = lambda f: 1e-3 + 0 * f
    spring.places[:] = 0.3
    series = simulate(spring, plain(spring), *blows(spring, plain(spring)))
    start = round((spring.scene.hits[0] + 0.01) * spring.scene.fine_rate)
    stretch = series["F_o"][start : start + round(5 * spring.scene.fine_rate)] - spring.scene.preload
    lines = np.abs(np.fft.rfft(stretch * np.hanning(len(stretch)), 16 * len(stretch)))
    frequencies = np.fft.rfftfreq(16 * len(stretch), 1 / spring.scene.fine_rate)
    for mode in (1, 2, 4):
        expected = 2 * 100 * np.sqrt(spring.stiffness / spring.mass) * np.sin(mode * np.pi / 200) / (2 * np.pi)
        near = np.abs(frequencies / expected - 1) < 0.2 / mode
        peak = frequencies[near][lines[near].argmax()]
        # Lines of the transform are 0.0125 Hz apart, of 40 Hz 3e-4; half of it may be missed.
        assert abs(peak - expected) < 0.007 + 1e-4 * expected, (mode, peak, expected)


def test_the_forces_at_both_ends_change_the_momentum():
    spring = calm(5, duration=4.0, first=30.0, rate=2500.0, width=0.01)
    built = plain(spring)
    forces, ends = blows(spring, built)
    modes = Modes(built.assembly, lambda f: 0 * f)
    rows = np.array([tension(built.input, 100)[0], tension(built.output, 100)[0], np.array(built.assembly.masses)])
    input_force, output_force, moment = modes.answer(spring.scene.fine_rate, rows, forces, ends)
    step = 1 / spring.scene.fine_rate
    pulls = output_force - input_force + sum(shape.sum() * values for shape, values in forces)
    impulse = integrate.cumulative_trapezoid(pulls, dx=step, initial=0)
    momentum = np.gradient(moment, step)
    # Differences of samples miss (w step)^2/6: 4e-3 at 250 Hz, above which a hit of 10 ms excites little.
    assert np.abs(impulse - momentum)[1:-1].max() < 4e-3 * np.abs(momentum).max()


def test_the_slow_force_is_the_stiffness_times_the_stretch():
    spring = rig(np.random.default_rng(8), first=50.0)
    spring.scene.sizes[:] = 0
    series = simulate(spring, plain(spring), *blows(spring, plain(spring)))
    for name in ("F_i", "F_o"):
        slope = np.polyfit(series["u1"], series[name], 1)[0]
        assert abs(slope / -spring.stiffness - 1) < 1e-3  # the coil's mass adds (w tau)^2/6, 1e-5 at 0.4 Hz


def test_a_mode_follows_a_force_that_is_straight_between_samples():
    for angular, ratio, rate in ((300.0, 2e-3, 1e4), (2e4, 0.05, 1e4), (60.0, 0.2, 1e4)):
        numerator, denominator = held(angular, ratio, rate)
        scipys, poles, _ = signal.cont2discrete(([1.0], [1.0, 2 * ratio * angular, angular**2]), 1 / rate, method="foh")
        # Both lose digits where the step is short: cancellation of (w/rate)^3.
        assert np.allclose(numerator, np.ravel(scipys), rtol=2e-6) and np.allclose(denominator, poles, rtol=1e-12)


def test_behind_a_cell_the_held_spring_is_not_the_coupled_line():
    # Two formulas for the coupled lines: eigenvalues, and the rod's w tau / tan(w tau) = (w^2 M - K)/k.
    mass, stiffness, head, cell = 0.065, 760.0, 0.2, 760.0 * 300
    assembly = Assembly()
    nodes, _, last = assembly.chain(END1, END2, 400, mass, stiffness)
    assembly.links.pop()
    node = assembly.mass(head)
    assembly.link(nodes[-1], node, last.stiffness)
    assembly.link(node, END2, cell)
    line = Modes(assembly, lambda f: 0 * f).angular[0]
    tau = np.sqrt(mass / stiffness)
    rod = optimize.brentq(lambda w: w * tau / np.tan(w * tau) - (w * w * head - cell) / stiffness, 2.9 / tau, 3.14159 / tau)
    assert abs(line / rod - 1) < 1e-5
    assert 1e-3 < 1 - line / (2 * np.pi * first_held(100, mass, stiffness)) < 0.01


def test_beams_have_the_roots_of_their_equations():
    assert np.abs((beam_roots("clamped-free", 4) / 1.875104068711961) ** 2 / (1, 6.26689, 17.5475, 34.3861) - 1).max() < 1e-5
    assert np.abs(beam_roots("clamped-clamped", 3) - (4.730040745, 7.853204624, 10.995607838)).max() < 1e-8
    assert np.abs(beam_roots("clamped-hinged", 2) - (3.926602312, 7.068582746)).max() < 1e-8


def test_a_late_channel_is_late():
    rng, rate, factor = np.random.default_rng(1), 10_000.0, 4
    fine = signal.sosfilt(signal.butter(2, 200, fs=rate, output="sos"), rng.standard_normal(40_000))
    late = Instrument(delay=0.0103).record(fine, rate, factor, rng)
    plain_one = fine[::factor]
    best = np.argmax(np.correlate(late, plain_one, "full")) - (len(plain_one) - 1)
    assert abs(best - 0.0103 * rate / factor) <= 0.5  # 25.75 samples of the log


def test_a_held_channel_has_as_many_values_as_its_device():
    held_one = Instrument(update_rate=100.0).record(np.sin(np.arange(50_000) / 50), 10_000.0, 4, np.random.default_rng(2))
    assert abs((np.diff(held_one) != 0).sum() - 500) <= 2  # 5 s at 100 Hz


def test_friction_takes_energy_and_stops_what_is_slow():
    # One mass: amplitudes fall by 4 F/k a turn, and it stops where the spring pulls less than the friction.
    assembly = Assembly()
    node = assembly.mass(1.0)
    assembly.link(node, END2, 400.0)
    modes, rate = Modes(assembly, lambda f: 0 * f), 10_000.0
    time = np.arange(60_000) / rate
    swing = np.cos(20 * time)
    place = swing + rubbing(modes, rate, node, 20.0, -20 * np.sin(20 * time), np.eye(1))[0]
    peaks = [place[round(turn * 2 * np.pi / 20 * rate)] for turn in range(5)]
    assert np.abs(np.array(peaks) - (1.0 - 0.2 * np.arange(5))).max() < 2e-3
    assert np.ptp(place[-10_000:]) < 1e-6


def test_every_kind_makes_the_same_log_twice_and_tells_the_truth():
    for kind in KINDS:
        log, again = make(kind, 2, 1), make(kind, 2, 1)
        assert all(np.array_equal(log.columns[name], again.columns[name]) for name in log.columns), kind
        assert all(np.isfinite(values).all() for values in log.columns.values()), kind
        forces = [name for name in log.columns if name.startswith("F")]
        assert forces and log.truth.is_spring == (KINDS[kind] in SPRINGS), kind
        assert all(1e-3 < np.ptp(log.columns[name]) < 1e4 for name in forces), kind
        if log.truth.is_spring:
            assert 10 < log.truth.first < 200, kind
            if log.truth.mass:
                assert abs(np.sqrt(log.truth.stiffness / log.truth.mass) / 2 / log.truth.first - 1) < 1e-3, kind


def run():
    """Runs all tests and says which failed; how many."""
    failed = 0
    for name, test in list(globals().items()):
        if name.startswith("test_"):
            try:
                test()
                print(f"ok      {name[5:].replace('_', ' ')}", flush=True)
            except AssertionError as error:
                failed += 1
                print(f"FAILED  {name[5:].replace('_', ' ')}: {error}", flush=True)
    return failed


if __name__ == "__main__":
    sys.exit(run())
