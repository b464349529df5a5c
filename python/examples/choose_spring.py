"""Which spring in the place of S_T disturbs a load cell least after a heel strike? An optimisation by SciPy over wire, coil and stiffness.

An impact of v puts a wave of v sqrt(k m) on the force at once. In the ankle's place a spring pulls with as much at the middle of its range,
has the same range, may be 26 mm wide, is as long as its windings at least without force, and its wire is loaded no higher than S_T's.

Needs SciPy: pip install scipy
"""

import numpy
import scipy.optimize
from numpy.typing import NDArray

import coilsense

S_T = coilsense.Spring.of_paper("S_T")
STEEL = coilsense.Material(shear_modulus=81.5e9, youngs_modulus=206e9, density=7850)
VELOCITY = 0.25  # m/s
HALF_RANGE = S_T.max_length - S_T.mid_length
PULL = S_T.static_force(S_T.mid_length)  # N, in the middle
OUTER = 0.026  # m: S_T is 18 mm wide, and the shank has room
STRESS = coilsense.Geometry.of_spring(S_T, "hooks", STEEL).corrected_shear_stress(S_T.static_force(S_T.max_length))
INDEX = (4.0, 16.0)  # what is wound without trouble

# d [mm], D [mm], k [N/mm]: numbers of one size, as an optimiser likes them.
LOWEST, HIGHEST = (1.0, 8.0, 0.45), (4.0, 25.0, 3.0)
START = numpy.array([2e3 * S_T.wire_radius, 2e3 * S_T.coil_radius, 1e-3 * S_T.stiffness])


def wound(design: NDArray[numpy.float64]) -> coilsense.Geometry:
    """Wire and coil with as many windings as make the stiffness."""
    wire, coil, stiffness = 1e-3 * design[0], 1e-3 * design[1], 1e3 * design[2]
    windings = STEEL.shear_modulus * wire**4 / (8 * coil**3 * stiffness)
    long = 2 * (windings + 1) * wire  # whether the windings are short enough is a limit of its own, below
    return coilsense.Geometry(
        wire_diameter=wire, coil_diameter=coil, active_windings=windings, end_type="hooks", material=STEEL, rest_length=long
    )


def wave(design: NDArray[numpy.float64]) -> float:
    """What the impact puts on the force at once [N]: v sqrt(k m)."""
    coil = wound(design)
    return float(VELOCITY * (coil.stiffness * coil.active_mass) ** 0.5)


def room(design: NDArray[numpy.float64]) -> NDArray[numpy.float64]:
    """What is left of each limit, as a share of it; all at zero or above where the spring may be built."""
    coil = wound(design)
    wire, diameter, stiffness = 1e-3 * design[0], 1e-3 * design[1], 1e3 * design[2]
    return numpy.array([
        1 - coil.corrected_shear_stress(PULL + stiffness * HALF_RANGE) / STRESS,
        1 - (diameter + wire) / OUTER,
        1 - coil.total_windings * wire / (S_T.mid_length - PULL / stiffness),
        coil.index / INDEX[0] - 1,
        1 - coil.index / INDEX[1],
    ])


def chosen() -> NDArray[numpy.float64]:
    """The best design that SciPy finds, from S_T and from springs beside it."""
    limits = {"type": "ineq", "fun": room}
    best = None
    for stretched in (1.0, 0.8, 1.25):
        found = scipy.optimize.minimize(
            wave, START * [1, 1, stretched], method="SLSQP", bounds=list(zip(LOWEST, HIGHEST)), constraints=limits,
            options={"ftol": 1e-12, "maxiter": 300},
        )
        if found.success and (room(found.x) > -1e-6).all() and (best is None or found.fun < best.fun):
            best = found
    assert best is not None, "no spring fits"
    return numpy.asarray(best.x)


def in_place(design: NDArray[numpy.float64]) -> coilsense.Spring:
    """The spring of a design, in the place of S_T."""
    coil = wound(design)
    return coilsense.Spring(
        rest_length=S_T.mid_length - PULL / coil.stiffness, windings=coil.total_windings, coil_radius=5e-4 * design[1],
        wire_radius=5e-4 * design[0], mass=coil.active_mass, stiffness=coil.stiffness, min_length=S_T.min_length, max_length=S_T.max_length,
    )


def disturbed(spring: coilsense.Spring) -> tuple[float, float]:
    """The wave of an impact by the spring's own numbers, and what a load cell at end 2 then is off by at most within a second [N]."""
    mount = coilsense.Mount(damping=coilsense.Damping.modal(0.005))
    hit = coilsense.Motion(spring, coilsense.Excitation.impact(spring.mid_length, VELOCITY), mount)
    signals = hit.signals(coilsense.sampled_window(10_000, 0, 1))
    return VELOCITY * spring.wave_impedance, float(abs(signals["F_o"] - signals["F_x"]).max())


def main() -> None:
    """Prints both springs."""
    best = chosen()
    print("              wire     coil  windings  stiffness     mass       f1   wave  load cell off by")
    for name, spring in (("S_T", S_T), ("chosen", in_place(best))):
        wave_force, off = disturbed(spring)
        print(f"{name:8} {1e3 * spring.wire_diameter:7.3f} mm {2e3 * spring.coil_radius:5.2f} mm {spring.windings:9.2f} {spring.stiffness:6.1f} N/m"
              f" {1e3 * spring.mass:6.2f} g {spring.surge_frequency:5.1f} Hz {wave_force:5.3f} N {off:9.3f} N")
    names = ("stress", "width", "length of the windings", "index above 4", "index below 16")
    left = ", ".join(f"{name} {100 * abs(share):.1f} %" for name, share in zip(names, room(best)))
    print(f"room left: {left}")
    saved = 1 - disturbed(in_place(best))[1] / disturbed(S_T)[1]
    print(f"eight millimetres more in width disturb a load cell {100 * saved:.0f} % less: the wave hardly depends on which spring holds a force")


if __name__ == "__main__":
    main()
