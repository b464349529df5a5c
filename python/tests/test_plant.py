"""The spring as a part of another's model: its matrices beside SciPy, python-control, the motion and the limits of placement.

Next door: the spring over frequency (test_frequency), other forms of it (Rust's tests of `plant`).
"""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import control
import numpy as np
import pytest
import scipy.signal

import coilsense
from coilsense import Damping, Load, TwoPort

EXAMPLE = Path(__file__).parents[2] / "examples" / "sea-ankle.toml"
RATIO = 0.005


@pytest.fixture(scope="module")
def ankle() -> coilsense.Plant:
    return coilsense.plant(EXAMPLE, damping_ratio=RATIO)


def test_matrices_for_a_step_are_scipys_of_the_continuous_ones(ankle: coilsense.Plant) -> None:
    step = 2e-4
    theirs = scipy.signal.cont2discrete(ankle.to_state_space(), step, method="foh")
    for ours, other in zip(ankle.to_state_space(step), theirs[:4], strict=True):
        # Rounding of an exponential of 104 states: 2e-14.
        assert np.abs(ours - other).max() < 1e-13 * np.abs(other).max()
    for ours, other in zip(ankle.to_state_space("0.2 ms"), ankle.to_state_space(step), strict=True):
        assert np.array_equal(ours, other)


def test_a_plant_in_python_control_has_the_springs_poles_and_responses(ankle: coilsense.Plant) -> None:
    system = control.ss(*ankle.to_state_space(), inputs=list(ankle.inputs), outputs=list(ankle.outputs))
    poles = np.sort(np.abs(system.poles()))[::2] / (2 * np.pi)
    assert np.allclose(poles, ankle.frequencies, rtol=1e-9)
    assert np.allclose(ankle.damping_ratios, RATIO, rtol=1e-12)
    frequencies = np.geomspace(1.0, 1500.0, 40)
    response, omega = ankle.to_frd(frequencies)
    of_matrices = system(1j * omega)[:3]
    assert np.abs(of_matrices - response).max() < 1e-9 * np.abs(response).max()
    # The two-port is the spring by another formula; it counts F_i over u1, u2 in the same signs.
    ends = TwoPort(ankle_spring(), Damping.modal(RATIO))
    stiffness = np.moveaxis(ends.matrix(frequencies), 0, -1)
    assert np.abs(np.abs(stiffness) - np.abs(response[:2])).max() < 1e-8 * np.abs(response).max()
    control.frd(response, omega)


def ankle_spring() -> coilsense.Spring:
    return coilsense.Spec.read(EXAMPLE).spring


def test_sampled_steps_are_the_motion(ankle: coilsense.Plant) -> None:
    step, count = 1e-4, 4000
    time = step * np.arange(count)
    spring = ankle_spring()
    # Straight between samples, as recorded ends are: the motion is exact for it as well.
    u1 = 1e-3 * np.interp(time, [0.0, 0.01, 0.013, 0.2, 0.4], [0.0, 0.0, 1.0, -0.5, 0.3])
    A, B, C, D = ankle.to_state_space(step)
    _, forces, _ = scipy.signal.dlsim((A, B, C, D, step), np.column_stack([u1, np.zeros(count)]))
    live = coilsense.Live(spring, ankle.mean_length, step, mount=coilsense.Mount(damping=Damping.modal(RATIO)))
    told = np.array([live.advance(value, ankle.mean_length) for value in u1])
    assert np.abs(forces[:, :2] + ankle.mean_force - told[:, 1:]).max() < 1e-10 * np.abs(told[:, 1:]).max()


def stable(gain: float, force: int, matrices: tuple[np.ndarray, ...], step: float, steps: int) -> bool:
    """Whether a velocity held for a step, by a force read some steps before, settles."""
    plant = control.ss(*matrices, step)[force, 0]
    # The velocity v makes u1 fall by v each step, straight: what the matrices are exact for.
    integrator = control.ss([[1.0]], [[1.0]], [[-step]], [[0.0]], step)
    first, last = np.eye(steps)[:, :1], np.eye(steps)[-1:]
    late = control.ss(np.eye(steps, k=-1), first, last, [[0.0]], step)
    poles = control.feedback(gain * late * plant * integrator, 1).poles()
    return bool(np.abs(poles).max() < 1.0)


def limit(force: int, matrices: tuple[np.ndarray, ...], step: float, steps: int = 1) -> float:
    """The gain above which the loop no longer settles."""
    low, high = 1e-4, 1.2e-4
    assert stable(low, force, matrices, step, steps)
    while stable(high, force, matrices, step, steps):
        low, high = high, 1.2 * high
    while high / low - 1 > 1e-6:
        middle = (low * high) ** 0.5
        low, high = (middle, high) if stable(middle, force, matrices, step, steps) else (low, middle)
    return high


# Samples of 0.5 ms from a force to its reading, fresh and old, of the example's sensors: load cells of 0.225 ms (second order at 1 kHz) and up to 0.2 ms
# of hold, encoders of 0.096 ms and up to 0.048 ms more, a meter that averages over 20 ms and holds for up to 20 ms.
LATE = {"F_i": (0, 1), "F_o": (0, 1), "F_x": (0, 1), "F_L": (20, 60)}


def matrices_of(ratio: float) -> tuple[np.ndarray, ...]:
    """The ankle in samples of 0.5 ms, F_L brought to k times the stretch."""
    A, B, C, D = coilsense.plant(EXAMPLE, damping_ratio=ratio, also="F_L").to_state_space(5e-4)
    # placement's F_L is k times the stretch when all moves slowly; a meter's departs from it by its calibration's form.
    slowly = C[4] @ np.linalg.solve(np.eye(len(A)) - A, B) + D[4]
    form = slowly[1] / ankle_spring().stiffness
    assert 0.9 < form < 1.1 and np.isclose(slowly[0], -slowly[1], rtol=1e-9)
    C[4], D[4] = C[4] / form, D[4] / form
    return A, B, C, D


FORCES = {"F_i": 0, "F_o": 1, "F_x": 2, "F_L": 4}


def judged_of(placement: coilsense.Placement, name: str, ratio: float) -> dict[str, Any]:
    candidate = next(one for one in placement.to_dict()["candidates"] if one["force"] == name)
    return next(one for one in candidate["dampings"] if one["damping"] == f"ζ = {ratio}")


def test_python_control_settles_by_late_sensors_where_placement_says() -> None:
    placement, ratio = coilsense.placement(EXAMPLE), 0.02
    matrices = matrices_of(ratio)
    for name, force in FORCES.items():
        nominal = judged_of(placement, name, ratio)["nominal_gain_limit"]
        for share, settles in ((0.1, True), (0.5, True), (1 - 1e-5, True), (1 + 1e-5, False)):
            found = [stable(share * nominal, force, matrices, 5e-4, 1 + steps) for steps in LATE[name]]
            assert all(found) == settles, (name, share, found)


def test_python_control_finds_the_limits_of_placement() -> None:
    text = EXAMPLE.read_text()
    assert 'sample_time = "0.5 ms"' in text and 'delay = "0.5 ms"' in text and 'drive = "velocity"' in text
    # Without sensors, so that each force is read at once.
    head, rest = text.split("[[sensor]]", 1)
    placement = coilsense.placement(coilsense.Spec.parse(head + rest[rest.index("[goal]") :]))
    worst = 0.0
    for ratio in (0.005, 0.02):
        matrices = matrices_of(ratio)
        for name, force in FORCES.items():
            judged = judged_of(placement, name, ratio)
            high = limit(force, matrices, 5e-4)
            nominal = judged["nominal_gain_limit"]
            off = high / nominal - 1
            print(f"{name}, ζ = {ratio}: {high:.6g} beside {nominal:.6g}, {100 * off:+.4f} %")
            # Over the tolerances, half a per cent of k and of frequency, it is less, and not by much.
            assert 0.9 * nominal < judged["gain_limit"] <= nominal
            worst = max(worst, abs(off))
    # Asked: 0.5 %. The search ends at 1e-6.
    assert worst < 1e-5


def test_f_l_is_the_fifth_output_where_it_is_asked_for(ankle: coilsense.Plant, tmp_path: Path) -> None:
    assert ankle.outputs == ("F_i", "F_o", "F_x", "u2") and ankle.warnings == []
    by_coil = coilsense.plant(EXAMPLE, damping_ratio=RATIO, also=["F_L", "closest_pitch"])
    assert by_coil.outputs == ("F_i", "F_o", "F_x", "u2", "F_L")
    _, _, C, D = by_coil.to_state_space()
    assert C.shape[0] == D.shape[0] == 5
    response, omega = by_coil.to_frd([20.0, 70.0])
    system = control.ss(*by_coil.to_state_space())
    assert response.shape == (4, 2, 2)
    assert np.abs(system(1j * omega)[4] - response[3]).max() < 1e-9 * np.abs(response).max()
    by_coil.save(tmp_path / "ankle.h")
    header = (tmp_path / "ankle.h").read_text()
    assert "ankle_coil(" in header and "ankle_closest_pitch(" in header
    with pytest.raises(coilsense.Error, match="closest_pitch is no straight line"):
        by_coil.save(tmp_path / "ankle.json", "state-space")
    with pytest.raises(coilsense.Error, match="also must be of F_L, closest_pitch, readings, with commas between, got \"F_l\""):
        coilsense.plant(EXAMPLE, damping_ratio=RATIO, also="F_l")


def test_what_has_no_plant_or_no_matrices_says_so_in_a_line(tmp_path: Path) -> None:
    def told(call: object) -> str:
        with pytest.raises(coilsense.Error) as raised:
            call()  # type: ignore[operator]
        assert len(str(raised.value).splitlines()) == 1
        return str(raised.value)

    assert "one damping makes a plant" in told(lambda: coilsense.plant(EXAMPLE))
    assert "bandwidth" in told(lambda: coilsense.plant(EXAMPLE, damping_ratio=RATIO, error=0.01))
    too_few = told(lambda: coilsense.plant(EXAMPLE, damping_ratio=RATIO, modes=2, error=0.001, bandwidth="200 Hz"))
    assert "takes" in too_few and "modes" in too_few
    plant = coilsense.plant(EXAMPLE, damping_ratio=RATIO, modes=4)
    assert "step" in told(lambda: plant.to_state_space(0.0))
    assert "form" in told(lambda: plant.save(tmp_path / "a.h", "fortran"))  # type: ignore[arg-type]
    assert "state-space" in told(lambda: plant.save(tmp_path / "a.h", "c", step=1e-3))
    assert "precision" in told(lambda: plant.save(tmp_path / "a.fmu", "fmu", precision="single"))
    assert "is no name of a file" in str(pytest.raises(coilsense.OutputError, plant.save, "/").value)
    assert list(tmp_path.iterdir()) == []
    plant.save(tmp_path / "ankle.h")
    assert "ankle_step(" in (tmp_path / "ankle.h").read_text()
    plant.save(tmp_path / "ankle.json", "state-space", step="1 ms")
    assert json.loads((tmp_path / "ankle.json").read_text())["sampled"] is not None
    text = EXAMPLE.read_text()
    start = text.index("[mount]")
    dashpots = text[:start] + '[mount]\nend2 = "held"\nstiffness_damping = "10 us"\n\n[[' + text[start:].split("[[", 1)[1]
    felt = coilsense.plant(coilsense.Spec.parse(dashpots, folder=EXAMPLE.parent))
    assert "no input of a continuous state space" in told(felt.to_state_space)
    felt.to_state_space(1e-3)


def test_a_load_at_the_end_is_the_force_on_it(ankle: coilsense.Plant) -> None:
    # With u2 held nothing else is at end 2: F_o over u1 is what the two-port says of a held load.
    response, omega = ankle.to_frd([20.0, 120.0])
    through = TwoPort(ankle_spring(), Damping.modal(RATIO)).transmittance(omega / (2 * np.pi), Load.held())
    assert np.allclose(np.abs(response[1, 0] / response[0, 0]), np.abs(through), rtol=1e-9)
