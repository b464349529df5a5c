"""What coilsense computes, and the same by SciPy and NumPy from the physics down: each pair gives its largest relative difference.

The docstring of each function says what both sides are: ``ours <-> theirs``. Here nothing of coilsense is used on the right-hand side but
the numbers of the spring and of the record.
"""

import math
from typing import Any

import numpy
import scipy
from numpy.typing import NDArray

from samples import SPRING, hit_log

import coilsense

Floats = NDArray[numpy.float64]

LENGTH = 0.23


def difference(ours: object, theirs: object) -> float:
    """The largest difference over the largest value."""
    right = numpy.asarray(theirs)
    return float(abs(numpy.asarray(ours) - right).max() / abs(right).max())


def chain() -> tuple[Floats, Floats]:
    """Stiffness and mass matrices of the paper's chain: N masses m/N between N - 1 springs Nk and, to each end, one of 2Nk."""
    count, stiffness = SPRING.chain_masses, SPRING.chain_masses * SPRING.stiffness
    matrix = 2 * stiffness * numpy.eye(count) - stiffness * (numpy.eye(count, k=1) + numpy.eye(count, k=-1))
    matrix[0, 0] = matrix[-1, -1] = 3 * stiffness
    return matrix, SPRING.mass / count * numpy.eye(count)


def modes() -> float:
    """`ChainModes.frequencies` <-> `scipy.linalg.eigh` of the chain's two matrices"""
    squares = scipy.linalg.eigh(*chain(), eigvals_only=True)
    return difference(coilsense.ChainModes(SPRING).frequencies, numpy.sqrt(squares) / (2 * math.pi))


def impact() -> float:
    """`Motion.end_forces` after an impact, damped <-> `scipy.linalg.expm` of the chain's state matrix"""
    stiffness, mass = chain()
    squares, count = stiffness / mass[0, 0], SPRING.chain_masses
    # The same ratio for every mode: the damping matrix is a multiple of the root of the stiffness matrix.
    damping = 2 * 0.005 * scipy.linalg.sqrtm(squares).real
    state = numpy.block([[numpy.zeros((count, count)), numpy.eye(count)], [-squares, -damping]])
    step, now = scipy.linalg.expm(state * 1e-4), numpy.r_[numpy.zeros(count), 0.25 * numpy.ones(count)]
    theirs = []
    for _ in range(1000):
        theirs.append([now[0], -now[count - 1]])
        now = step @ now
    static = SPRING.stiffness * (LENGTH - SPRING.rest_length)
    forces = static + 2 * count * SPRING.stiffness * numpy.array(theirs)
    mount = coilsense.Mount(damping=coilsense.Damping.modal(0.005))
    motion = coilsense.Motion(SPRING, coilsense.Excitation.impact(LENGTH, 0.25), mount)
    return difference(motion.end_forces(numpy.arange(1000) * 1e-4), forces.T)


def shaken() -> float:
    """`Motion.end_forces` of a shaken end <-> `scipy.signal.lsim` of the chain with a finely sampled input"""
    stiffness, mass = chain()
    count, ends = SPRING.chain_masses, 2 * SPRING.chain_masses * SPRING.stiffness
    state = numpy.block([[numpy.zeros((count, count)), numpy.eye(count)], [-stiffness / mass[0, 0], numpy.zeros((count, count))]])
    force = numpy.zeros((2 * count, 1))
    force[count] = ends / mass[0, 0]
    read = numpy.zeros((2, 2 * count))
    read[0, 0], read[1, count - 1] = ends, -ends
    times = numpy.arange(20_001) * 1e-5
    moved = 1e-3 * numpy.sin(2 * numpy.pi * 20 * times)
    system = scipy.signal.StateSpace(state, force, read, [[-ends], [0.0]])
    # At rest while the end begins to move.
    _, out, _ = scipy.signal.lsim(system, moved, times)
    static = SPRING.stiffness * (LENGTH - SPRING.rest_length)
    excitation = coilsense.Excitation(LENGTH, end1=coilsense.EndInput.harmonic(1e-3, 20.0), start=coilsense.Start.rest())
    return difference(coilsense.Motion(SPRING, excitation).end_forces(times), static + out.T)


def end_mass() -> float:
    """`continuous_frequencies` with a mass at end 2 <-> `scipy.optimize.brentq` of b tan b = m/M"""
    mass, ours = 0.2, coilsense.continuous_frequencies(SPRING, coilsense.FarEnd.mass(0.2), 5)
    root = math.sqrt(SPRING.stiffness / SPRING.mass)
    theirs = []
    for number in range(5):
        low = number * math.pi
        high = low + 0.5 * math.pi
        turns = scipy.optimize.brentq(lambda b: b * math.sin(b) - SPRING.mass / mass * math.cos(b), low + 1e-9, high, xtol=1e-14)
        theirs.append(turns * root / (2 * math.pi))
    return difference(ours, theirs)


def inductance() -> float:
    """`MaxwellSum.at_lengths` <-> the sum over all pairs of rings by `scipy.special.ellipk` and `ellipe`"""
    radius, wire, count = SPRING.coil_radius, SPRING.wire_radius, SPRING.chain_masses
    lengths = numpy.linspace(SPRING.min_length, SPRING.max_length, 5)
    theirs = []
    for length in lengths:
        places = length * (numpy.arange(count) + 0.5) / count
        apart = abs(places[:, None] - places[None, :])
        numpy.fill_diagonal(apart, 0.5 * wire * math.exp(-0.25))
        modulus = 4 * radius**2 / (4 * radius**2 + apart**2)
        # Near rings need 1 - m, which ellipkm1 takes.
        first, second = scipy.special.ellipkm1(apart**2 / (4 * radius**2 + apart**2)), scipy.special.ellipe(modulus)
        root = numpy.sqrt(modulus)
        theirs.append((4e-7 * math.pi * radius * ((2 / root - root) * first - 2 / root * second)).sum())
    return difference(coilsense.MaxwellSum(SPRING, "as-printed").at_lengths(lengths), theirs)


def deviation() -> float:
    """`Deviation.between` <-> `numpy.mean`, `numpy.std` and `numpy.max`"""
    random = numpy.random.default_rng(1)
    force, reference = random.normal(100, 3, 5000), random.normal(100, 1, 5000)
    error = force - reference
    ours = coilsense.Deviation.between(force, reference)
    theirs = [math.sqrt(numpy.mean(error**2)), error.max(), abs(error).max()]
    return difference([ours.rmsd, ours.maximum, ours.maximum_absolute], theirs)


def spectrum() -> float:
    """`Spectrum.amplitudes` <-> `scipy.signal.periodogram(window="hann", scaling="spectrum")`"""
    values = numpy.random.default_rng(2).normal(0, 1, 1000)
    ours = coilsense.Spectrum(numpy.arange(1000) / 500, values)
    _, power = scipy.signal.periodogram(values, 500, window="hann", detrend="constant", scaling="spectrum")
    # The lines at 0 Hz and at half the rate stand for no sine.
    return difference(ours.amplitudes[1:-1], numpy.sqrt(2 * power[1:-1]))


def chirp() -> float:
    """`EndInput.chirp` <-> `scipy.signal.chirp(method="linear")`"""
    times = numpy.linspace(0, 2, 400)
    ours = [coilsense.EndInput.chirp(1e-3, 1.0, 50.0, 2.0).displacement(time) for time in times]
    return difference(ours, 1e-3 * scipy.signal.chirp(times, 1.0, 2.0, 50.0, phi=-90))


def steps() -> float:
    """`EndInput.sampled` <-> `numpy.interp`"""
    knots, values = numpy.array([0.0, 0.1, 0.15, 0.4]), numpy.array([0.0, 1e-3, -2e-3, 5e-4])
    times = numpy.linspace(0, 0.4, 321)
    sampled = coilsense.EndInput.sampled(knots, values)
    return difference([sampled.displacement(time) for time in times], numpy.interp(times, knots, values))


def straight_line() -> float:
    """`calibrate`: α, β and their standard errors <-> `scipy.stats.linregress` of 1/l over L"""
    lengths = numpy.linspace(0.2, 0.26, 13)
    inductances = (1 / lengths - 0.4) / 1.5e6 * (1 + 1e-3 * numpy.random.default_rng(3).normal(size=13))
    fit, line = coilsense.calibrate((lengths, inductances)), scipy.stats.linregress(inductances, 1 / lengths)
    pairs = [(fit.alpha, line.slope), (fit.beta, line.intercept), (fit.alpha_se, line.stderr), (fit.beta_se, line.intercept_stderr)]
    return max(difference(ours, theirs) for ours, theirs in pairs)


def running_mean(values: Floats, window: int) -> Floats:
    """Means over `window` samples about each, fewer at the ends, as many on either side."""
    sums, places = numpy.concatenate([[0.0], numpy.cumsum(values)]), numpy.arange(len(values))
    reach = numpy.minimum(window // 2, numpy.minimum(places, len(values) - 1 - places))
    means: Floats = (sums[places + reach + 1] - sums[places - reach]) / (2 * reach + 1)
    return means


def density() -> float:
    """`Identification.spectra` of ½(F_o − F_i), slow motion taken out <-> `scipy.signal.welch(window="hann")`"""
    signals = hit_log()
    found = coilsense.identify(signals)
    frequencies, ours = found.spectra["antisymmetric"]
    length = round(found.sample_rate / frequencies[1])
    half = 0.5 * (signals["F_o"] - signals["F_i"])
    # What is slower than 0.4 s is taken out beforehand.
    half -= running_mean(running_mean(half, 1000), 1000)
    _, theirs = scipy.signal.welch(half, found.sample_rate, "hann", length, length - length // 2, detrend="constant")
    return difference(ours, theirs)


def trust() -> float:
    """`Identification.trust` <-> `scipy.optimize.brentq` of the wave equation's errors"""
    found = coilsense.identify(hit_log())
    assert found.trust is not None and found.transit_time is not None
    time, tolerance = found.transit_time.value, found.trust["tolerance"]
    errors = {
        "output_for_input": lambda x: 1 / math.cos(x) - 1 - tolerance,
        "deflection_for_input": lambda x: math.tan(x) / x - 1 - tolerance,
        "deflection_for_output": lambda x: 1 - math.sin(x) / x - tolerance,
    }
    theirs = {name: scipy.optimize.brentq(error, 1e-6, 1.5, xtol=1e-15) / time / math.tau for name, error in errors.items()}
    return max(difference(found.trust[name], value) for name, value in theirs.items())


def remedies() -> coilsense.Mitigation:
    """Every remedy for the spring, designed for 2.5 kHz, 0.24 N of noise and a damping ratio of 0.005."""
    text = coilsense.Spec.template("S_T").replace('end2 = "held"', 'end2 = "held"\ndamping_ratio = 0.005', 1)
    return coilsense.mitigate(coilsense.Spec.parse(text), hit_log(seconds=2.5), noise=0.24)


def settings(name: str) -> dict[str, Any]:
    """What a remedy consists of."""
    found = next(remedy for remedy in remedies().remedies if remedy.name == name).settings
    assert found is not None
    return found


def section(numbers: dict[str, float]) -> list[float]:
    """A second-order section as SciPy writes it."""
    return [numbers["b0"], numbers["b1"], numbers["b2"], 1.0, numbers["a1"], numbers["a2"]]


def low_pass() -> float:
    """`mitigate`: the Butterworth low-pass at f1/2 <-> `scipy.signal.butter(output="sos")`"""
    ours = [section(numbers) for numbers in settings("Butterworth of order 2 at f1/2")["sections"]]
    return difference(ours, scipy.signal.butter(2, 0.5 * SPRING.surge_frequency, fs=2500, output="sos"))


def notches() -> float:
    """`mitigate`: notches at n·f1 <-> `scipy.signal.iirnotch`"""
    ours = [section(numbers) for numbers in settings("five notches n·f1, Q = 3")["sections"]]
    theirs = [numpy.concatenate(scipy.signal.iirnotch(n * SPRING.surge_frequency, 3.0, fs=2500)) for n in range(1, 6)]
    return difference(ours, theirs)


def filtered() -> float:
    """`Remedy.apply` of these notches <-> `scipy.signal.sosfilt`, begun at rest by `sosfilt_zi`"""
    force = hit_log(seconds=2.5)["F_i"]
    found = next(remedy for remedy in remedies().remedies if remedy.name == "five notches n·f1, Q = 3")
    sections = [numpy.concatenate(scipy.signal.iirnotch(n * SPRING.surge_frequency, 3.0, fs=2500)) for n in range(1, 6)]
    theirs, _ = scipy.signal.sosfilt(sections, force, zi=force[0] * scipy.signal.sosfilt_zi(sections))
    return difference(found.apply(force), theirs)


def kalman() -> float:
    """`mitigate`: gains of the modal Kalman filter <-> `scipy.linalg.solve_discrete_are` on modes by `eigh` and `expm`"""
    rate, noise, member = 2500.0, 0.24, settings("Kalman filter, 3 modes, bias")["members"][0]
    ours = [gain for mode in member["modes"] for gain in mode["gain"]] + [member["bias_gain"]]
    frequencies = numpy.sqrt(scipy.linalg.eigh(*chain(), eigvals_only=True))[:3]
    turn, read = numpy.eye(7), numpy.array([1.0, 0, 1, 0, 1, 0, 1])
    for mode, omega in enumerate(frequencies):
        place = slice(2 * mode, 2 * mode + 2)
        turn[place, place] = scipy.linalg.expm(numpy.array([[0, omega], [-omega, -2 * 0.005 * omega]]) / rate)
    # What a first try expects: modes that are knocked about by 8.3 times the noise, a bias that wanders by 2.1 times, each per root of a second.
    wander = numpy.diag([(8.3 * noise) ** 2 / rate] * 6 + [(2.1 * noise) ** 2 / rate])
    spread = scipy.linalg.solve_discrete_are(turn.T, read[:, None], wander, [[noise**2]])
    return difference(ours, spread @ read / (read @ spread @ read + noise**2))


COMPARISONS = {
    # What, the largest difference that was measured rounded up, and why it is no smaller.
    modes: (1e-14, "rounding"),
    impact: (1e-13, "a thousand steps of the matrix exponential"),
    shaken: (3e-7, "lsim takes straight lines between samples 10 µs apart"),
    end_mass: (3e-15, "rounding"),
    inductance: (1e-13, "rounding in 2704 pairs"),
    deviation: (3e-15, "rounding"),
    spectrum: (1e-14, "rounding in two Fourier transforms"),
    chirp: (1e-12, "rounding of the phase"),
    steps: (3e-15, "rounding"),
    straight_line: (3e-12, "sums of squares that nearly cancel"),
    density: (1e-14, "rounding"),
    low_pass: (3e-15, "rounding"),
    notches: (3e-15, "rounding"),
    filtered: (2e-13, "rounding, summed up by narrow filters"),
    kalman: (5e-13, "two ways of solving a Riccati equation"),
    trust: (3e-14, "both solve to their own tolerance"),
}
