"""What the examples say, by other means: bodies and spring solved together, every spring that was not chosen, a notebook from top to bottom."""

from __future__ import annotations

import importlib.util
import sys
from pathlib import Path
from types import ModuleType

import numpy
import pytest

import coilsense

EXAMPLES = Path(__file__).parents[1] / "examples"


def example(name: str) -> ModuleType:
    """An example's functions, nothing run."""
    spec = importlib.util.spec_from_file_location(name, EXAMPLES / f"{name}.py")
    assert spec is not None and spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    sys.modules[name] = module
    spec.loader.exec_module(module)
    return module


@pytest.fixture
def ankle() -> ModuleType:
    pytest.importorskip("mujoco")
    return example("mujoco_ankle")


def test_stepped_in_turns_with_mujoco_it_is_bodies_and_spring_solved_together(ankle: ModuleType) -> None:
    exact = ankle.together(ankle.SPRING, 2e-5, 5000)
    off, share = [], []
    for divided in (1, 2):
        fine = ankle.simulated(ankle.SPRING, 2e-5 / divided, 5000 * divided)
        ours = {name: series[::divided] for name, series in fine.items()}
        off.append(max(abs(ours[name] - exact[name])[1:].max() for name in ("F_i", "F_o")))
        share.append(abs(ours["energy"] - exact["energy"]).max() / exact["energy"][0])
    print(f"{off} N, {share} of the energy")
    # Of 2.7 N between motor and leg; a force held for a step is half a step late: both fall with the step.
    assert off[0] < 5e-4 and off[1] < 0.6 * off[0]
    assert share[0] < 6e-4 and share[1] < 0.6 * share[0]
    apart = abs(exact["F_i"] - exact["F_o"]).max()
    assert apart > 1.0  # what is compared is not nothing


def test_stepping_in_turns_makes_no_energy(ankle: ModuleType, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(ankle, "RATIO", 0.0)
    # Two seconds of an undamped ankle. Bodies and stretch hold no more than all there is: were any made, that would grow beyond what was put in.
    run = ankle.simulated(ankle.SPRING, 1e-4, 20_000)
    share = run["energy"] / run["energy"][0]
    assert share.max() < 1 + 1e-4  # positions and velocities of a step are half a step apart
    assert share[-5000:].max() < 1
    # What must not pass: a pull that is a step later feeds the swing, and this is how it would show.
    fed, motor, leg, u = 1.0, 0.0, -ankle.HIT, 0.0
    late = 0.0
    for _ in range(20_000):
        motor, leg = motor + 1e-3 * late / ankle.MOTOR, leg - 1e-3 * late / ankle.LEG
        late, u = ankle.SPRING.stiffness * u, u + 1e-3 * (leg - motor)
        fed = max(fed, ankle.energy(motor, leg, u) / run["energy"][0])
    assert fed > 2


def test_a_spring_of_hardly_any_mass_is_mujocos_own(ankle: ModuleType) -> None:
    light = coilsense.Spring(**ankle.SPRING.to_dict() | {"mass": ankle.SPRING.mass / 1024, "wire_radius": ankle.SPRING.wire_radius / 32})
    ours, theirs = ankle.simulated(light, 2e-5, 5000), ankle.simulated(None, 2e-5, 5000)
    swing = numpy.ptp(theirs["F_i"])
    # v sqrt(k m) falls with the root of the mass, to 1/32 of 1.8 N.
    for name in ("F_i", "F_o"):
        assert abs(ours[name] - theirs[name]).max() < 0.1 < 0.02 * swing
    assert (theirs["F_i"] == theirs["F_o"]).all()
    heavy = ankle.simulated(ankle.SPRING, 2e-5, 5000)
    assert abs(heavy["F_o"] - theirs["F_o"]).max() > 10 * abs(ours["F_o"] - theirs["F_o"]).max()
