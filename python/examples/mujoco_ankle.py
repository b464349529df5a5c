"""An ankle in MuJoCo whose spring has a mass: motor and leg are MuJoCo's, the spring between them is coilsense's, beside MuJoCo's own massless one.

The spring is a `Live`, not the matrices of `plant(spec).to_state_space(h)`: both take ends that move straight between samples and give the same
forces, but `Live` steps 52 modes as such, 104 numbers, where the matrices multiply 104 by 104. Each step MuJoCo tells where the ends are and
`Live` what they are pulled with, held until the next one. That pull is late by half a step: what it costs in energy is measured below, against
spring and bodies solved together.

Needs MuJoCo and SciPy: pip install mujoco scipy
"""

import pathlib
import tempfile
from typing import Any

import mujoco
import numpy
import scipy.linalg
from numpy.typing import NDArray

import coilsense

STEP, SAMPLES = 2e-5, 10_000
MOTOR, LEG = 1.2, 0.8  # kg
HIT = 0.25  # m/s, the leg's towards the motor when the heel strikes
SPRING = coilsense.Spring.of_paper("S_T")
LENGTH = SPRING.mid_length
RATIO = 0.005

MODEL = """
<mujoco>
  <option timestep="{step!r}" gravity="0 0 0"/>
  <worldbody>
    <body><joint name="motor" type="slide" axis="1 0 0"/><inertial pos="0 0 0" mass="{motor}" diaginertia="1 1 1"/></body>
    <body><joint name="leg" type="slide" axis="1 0 0"/><inertial pos="0 0 0" mass="{leg}" diaginertia="1 1 1"/></body>
  </worldbody>
  {tendon}
</mujoco>
"""

# MuJoCo's spring pulls by the difference of the joints; both are at zero at the mean length, where its pull is balanced.
TENDON = """<tendon><fixed stiffness="{stiffness!r}" springlength="0">
  <joint joint="leg" coef="1"/><joint joint="motor" coef="-1"/></fixed></tendon>"""

Run = dict[str, NDArray[numpy.float64]]


def energy(motor: Any, leg: Any, stretch: Any) -> Any:
    """That of the bodies, and the least that a spring stretched by so much can have: never more than there is [J]."""
    return 0.5 * (MOTOR * motor**2 + LEG * leg**2 + SPRING.stiffness * stretch**2)


def simulated(spring: coilsense.Spring | None, step: float = STEP, samples: int = SAMPLES) -> Run:
    """Forces and bodies over time: with a spring of coilsense, or with MuJoCo's own."""
    tendon = TENDON.format(stiffness=SPRING.stiffness) if spring is None else ""
    model = mujoco.MjModel.from_xml_string(MODEL.format(step=step, motor=MOTOR, leg=LEG, tendon=tendon))
    data = mujoco.MjData(model)
    data.qvel[:] = 0.0, -HIT
    rest = SPRING.static_force(LENGTH)  # whatever else holds motor and leg bears the preload
    live = None
    if spring is not None:
        live = coilsense.Live(spring, LENGTH, step, coilsense.Mount(damping=coilsense.Damping.modal(RATIO)))
    run: Run = {name: numpy.zeros(samples) for name in ("t", "F_i", "F_o", "energy")}
    for sample in range(samples):
        mujoco.mj_step1(model, data)  # positions and velocities are those of now; forces may be set
        motor, leg = data.qpos
        if live is None:
            pull = numpy.full(2, SPRING.stiffness * (leg - motor))
        else:
            # At t = 0 it is at rest; from then on each step ends now.
            pull = numpy.array(live.advance(motor, LENGTH + leg)[1:]) - rest if sample else numpy.zeros(2)
            data.qfrc_applied[:] = pull[0], -pull[1]  # tension: the motor is pulled up, the leg back
        for name, value in zip(run, (sample * step, *(rest + pull), energy(data.qvel[0], data.qvel[1], leg - motor))):
            run[name][sample] = value
        mujoco.mj_step2(model, data)
    return run


def together(spring: coilsense.Spring, step: float = STEP, samples: int = SAMPLES) -> Run:
    """The same with spring and bodies as one linear system, solved exactly from step to step: what stepping in turns is judged by.

    The windings' damping acts on velocities relative to the straight line between the ends, 2 zeta omega_j in each mode of the held chain; the
    bodies feel the end segments' elastic force, as F_i and F_o are meant.
    """
    count, segment = spring.chain_masses, spring.stiffness * spring.chain_masses
    ties = numpy.full(count + 1, segment)
    ties[[0, -1]] *= 2
    stiffness = numpy.diag(numpy.append(ties, 0) + numpy.append(0, ties)) - numpy.diag(ties, 1) - numpy.diag(ties, -1)
    masses = numpy.concatenate([[MOTOR], numpy.full(count, spring.mass / count), [LEG]])
    squares, shapes = numpy.linalg.eigh(stiffness[1:-1, 1:-1] / masses[1])
    rates = (shapes * (2 * RATIO * numpy.sqrt(squares))) @ shapes.T
    share = (numpy.arange(count) + 0.5) / count
    beside = numpy.column_stack([share - 1, numpy.eye(count), -share])
    damping = numpy.zeros_like(stiffness)
    damping[1:-1] = rates @ beside
    none, one = numpy.zeros_like(stiffness), numpy.eye(count + 2)
    exact = scipy.linalg.expm(step * numpy.block([[none, one], [-stiffness / masses[:, None], -damping]]))
    states = numpy.zeros((samples, 2 * count + 4))
    states[0, -1] = -HIT
    for sample in range(1, samples):
        states[sample] = exact @ states[sample - 1]
    places, speeds = states[:, : count + 2], states[:, count + 2 :]
    rest = spring.static_force(LENGTH)
    return {
        "t": step * numpy.arange(samples),
        "F_i": rest + ties[0] * (places[:, 1] - places[:, 0]),
        "F_o": rest + ties[-1] * (places[:, -1] - places[:, -2]),
        "energy": energy(speeds[:, 0], speeds[:, -1], places[:, -1] - places[:, 0]),
    }


def main() -> None:
    """Prints what the spring's mass changes, and what stepping in turns costs."""
    real, massless, exact = simulated(SPRING), simulated(None), together(SPRING)
    apart = abs(real["F_i"] - real["F_o"])
    soon = round(1e-3 / STEP)
    print(f"leg at {HIT} m/s towards the motor: after 1 ms its end feels {abs(real['F_o'][soon] - real['F_o'][0]):.2f} N (v sqrt(k m) is"
          f" {HIT * SPRING.wave_impedance:.2f} N), the motor's {abs(real['F_i'][soon] - real['F_i'][0]):.2f} N: the wave takes"
          f" {1e3 * SPRING.transit_time:.1f} ms")
    print(f"motor and leg disagree by up to {apart.max():.2f} N, {apart[len(apart) // 2 :].max():.2f} N still after {1e3 * STEP * SAMPLES / 2:.0f} ms")
    print(f"MuJoCo's massless spring: both the same, off from the motor's end by up to {abs(massless['F_i'] - real['F_i']).max():.2f} N,"
          f" from the leg's by {abs(massless['F_o'] - real['F_o']).max():.2f} N")
    for divided in (1, 4):
        fine = real if divided == 1 else simulated(SPRING, STEP / divided, divided * SAMPLES)
        ours = {name: series[::divided] for name, series in fine.items()}
        off = max(abs(ours[name] - exact[name])[1:].max() for name in ("F_i", "F_o"))
        share = abs(ours["energy"] - exact["energy"]).max() / exact["energy"][0]
        print(f"in turns at {1e6 * STEP / divided:.0f} us, beside spring and bodies solved together: {off:.1e} N, {100 * share:.3f} % of the energy")

    try:
        import matplotlib.pyplot as plt
    except ImportError:
        return
    figure, axes = plt.subplots(figsize=(8, 4), layout="constrained")
    for name, colour, label in (("F_i", "#0072b2", "F_i: motor"), ("F_o", "#d55e00", "F_o: leg")):
        axes.plot(1e3 * real["t"], real[name], color=colour, linewidth=1, label=label)
    axes.plot(1e3 * massless["t"], massless["F_i"], color="#333333", linewidth=1, linestyle="--", label="MuJoCo's massless spring")
    axes.set_xlabel("Time since the heel strike [ms]")
    axes.set_ylabel("Force [N]")
    axes.legend(loc="lower left", bbox_to_anchor=(0, 1), ncols=3, frameon=False)
    axes.grid(alpha=0.3)
    path = pathlib.Path(tempfile.mkdtemp(prefix="coilsense-")) / "mujoco_ankle.png"
    figure.savefig(path, dpi=120)
    print(f"figure: {path}")


if __name__ == "__main__":
    main()
