"""One value of each noun, for the tests that ask the same of all."""

import numpy

import coilsense

SPRING = coilsense.Spring.of_paper("S_T")
IMPACT = coilsense.Excitation.impact(0.23, 0.25)


def values() -> list[object]:
    """Values that must compare, print, become dicts and pickle."""
    inputs = [
        coilsense.EndInput.held(),
        coilsense.EndInput.harmonics([(1e-3, 10.0, 0.5), (2e-3, 20.0, 0.0)]),
        coilsense.EndInput.chirp(1e-3, 1.0, 50.0, 2.0),
        coilsense.EndInput.step(0.01, 0.2),
        coilsense.EndInput.ramp(0.01, 0.1, 0.2),
        coilsense.EndInput.half_sine(0.01, 0.1, 0.2),
        coilsense.EndInput.sampled([0.0, 0.1, 0.3], [0.0, 1e-3, 2e-3]),
    ]
    starts = [
        coilsense.Start.rest(),
        coilsense.Start.massless(),
        coilsense.Start.steady(),
        coilsense.Start.moving(0.25, "linear"),
        coilsense.Start.windings([0.1, 0.2], [0.0, 0.3]),
    ]
    dampings = [
        coilsense.Damping.none(),
        coilsense.Damping.modal(0.005),
        coilsense.Damping.modal_each([0.005, 0.01]),
        coilsense.Damping.mass_proportional(1.0),
        coilsense.Damping.stiffness_proportional(1e-5),
        coilsense.Damping.hysteretic(0.01),
    ]
    far_ends = [coilsense.FarEnd.position(), coilsense.FarEnd.force(), coilsense.FarEnd.mass(0.5)]
    mount = coilsense.Mount(far_ends[2], dampings[1])
    shaken = coilsense.Excitation(0.23, end1=inputs[1], end2=inputs[4], start=starts[3])
    motion = coilsense.Motion(SPRING, shaken, mount)
    signals = coilsense.Signals([0.0, 0.1], {"F_o": [1.0, 2.0], "L": [1e-6, 2e-6]})
    windings = coilsense.Windings([[0.0, 0.3], [0.0, 0.31]], [[0.1, 0.2], [0.11, 0.2]])
    deviation = coilsense.Deviation.between([1.0, 2.0], [0.5, 2.0])
    clash = coilsense.Clash.of(motion, [0.0, 0.1])
    steel = coilsense.Material(shear_modulus=81.5e9, youngs_modulus=206e9, density=7850.0, resistivity=2e-7)
    loads = [coilsense.Load.held(), coilsense.Load.free(), coilsense.Load.mass(0.5), coilsense.Load.stiffness(300.0, 40.0)]
    others = [
        steel,
        coilsense.Geometry.of_spring(SPRING, "hooks", steel),
        coilsense.TwoPort(SPRING, dampings[1], "wave"),
        coilsense.TwoPort(SPRING) @ coilsense.Cascade.mass(0.5) @ coilsense.Cascade.link(3e4, 20.0),
        coilsense.Cascade.mass(0.5),
        coilsense.Readout(bandwidth=1e3, order=2, noise=0.1),
        coilsense.Spec.parse(coilsense.Spec.template("S_T")),
    ]
    nouns = [shaken, IMPACT, mount, motion, motion.truncated(3), signals, windings, deviation, clash]
    coil = coilsense.MaxwellSum(SPRING, "geometric-mean")
    estimate = coilsense.Estimate(54.0, 0.1, 0.2)
    meter = coilsense.InductanceSensor.theoretical(coil, 0.23)
    encoders = coilsense.TwoEncoder(SPRING, compliance=1e-5, backlash=2e-4, mean_length=0.204)
    return [SPRING, coil, meter, encoders, estimate, *inputs, *starts, *dampings, *far_ends, *loads, *others, *nouns]


def hit_log(noise: float = 0.05, seconds: float = 30.0, pulled: bool = True) -> coilsense.Signals:
    """A slow pull at end 1 and a hit every five seconds, 2.5 kHz, both load cells with noise: the motion is linear, so that hits add up."""
    mount, times = coilsense.Mount(damping=coilsense.Damping.modal(0.005)), coilsense.sampled_window(2500, 0, seconds)
    end1 = coilsense.EndInput.harmonic(5e-3, 0.2) if pulled else None
    signals = coilsense.Motion(SPRING, coilsense.Excitation(0.23, end1=end1), mount).signals(times)
    hit = coilsense.Motion(SPRING, IMPACT, mount).signals(times)
    random = numpy.random.default_rng(1)
    for name in ("F_i", "F_o"):
        force = signals[name] + random.normal(0, noise, len(times))
        for begin in range(5000, len(times), 12_500):
            force[begin:] += hit[name][: len(times) - begin] - SPRING.static_force(0.23)
        signals = signals.inserted(name, force)
    return signals
