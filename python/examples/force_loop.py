"""How fast may a force loop be that feeds back the leg's load cell? python-control, with the spring's own modes in it, beside coilsense's answer.

Needs python-control: pip install control
"""

from typing import Any

import control
import numpy

import coilsense

STEP = 5e-4
LOOP = """
[control]
drive = "velocity"
crossover = "2 Hz"
sample_time = "0.5 ms"
delay = "0.5 ms"
"""
text = coilsense.Spec.template("S_T")
spec = coilsense.Spec.parse(text if "\n[control]" in text else text + LOOP)

# The spring, exact at the samples for a motor that moves straight between them, as a held velocity makes it.
spring = coilsense.plant(spec, damping_ratio=0.005)
model: Any = control.ss(*spring.to_state_space(STEP), STEP, inputs=list(spring.inputs), outputs=list(spring.outputs))
motor = control.ss([[1.0]], [[1.0]], [[-STEP]], [[0.0]], STEP)  # a velocity above zero pulls end 1 away from the leg
late = control.ss([[0.0]], [[1.0]], [[1.0]], [[0.0]], STEP)  # the command is by the force of the sample before


def is_stable(gain: float, force: str) -> bool:
    """Whether the loop that feeds back a force settles."""
    loop: Any = control.feedback(gain * late * model[force, "u1"] * motor, 1)
    return bool(numpy.abs(loop.poles()).max() < 1)


def limit(force: str) -> float:
    """The gain at which it no longer does [m/s per N]."""
    low, high = 1e-6, 1e-6
    while is_stable(high, force):
        low, high = high, 1.5 * high
    while high / low > 1 + 1e-5:
        middle = (low * high) ** 0.5
        low, high = (middle, high) if is_stable(middle, force) else (low, middle)
    return high


for force in ("F_i", "F_o", "F_x"):
    crossover = limit(force) * spec.spring.stiffness / (2 * numpy.pi)
    print(f"{force}: stable up to a crossover of {crossover:.4g} Hz of the loop with a spring without mass")
print(coilsense.placement(spec).answer[0])
