"""`coilsense export --as fmu` for model exchange: its equations are those of the state space, FMPy's CVode solves them, and the tighter its tolerance the
nearer it is to the steps of the same file.

Next door: what is shared (`fmus`), co-simulation (`test_fmu`), the state space itself (`coilsense`, `tests/plant.rs`).
"""

import ctypes
import json
import pathlib
from collections.abc import Callable
from typing import Any

import fmpy
import numpy as np
import pytest
from fmpy.fmi2 import FMU2Model
from fmpy.sundials import CVodeSolver
from fmus import DAMPINGS, ENDS, STEP, Slave, coilsense, exported, logging_to, names, refused

MEAN = 95.76
CONTINUOUS = 200


class Model(Slave):
    """An instance for model exchange, from its start to continuous-time mode."""

    def __init__(self, file: pathlib.Path, /, **start: float) -> None:
        self.said: list[tuple[int, str]] = []
        self.description = fmpy.read_model_description(str(file))
        self.is_three = False
        self.numbers = {variable.name: variable.valueReference for variable in self.description.modelVariables}
        self.states: int = self.description.numberOfContinuousStates
        identifier = self.description.modelExchange.modelIdentifier
        self.fmu = FMU2Model(guid=self.description.guid, unzipDirectory=fmpy.extract(str(file)), modelIdentifier=identifier, instanceName="one")
        self.host = logging_to(self.said)
        self.fmu.instantiate(callbacks=self.host)
        self.fmu.setupExperiment(startTime=0.0)
        self.set(**start)
        self.fmu.enterInitializationMode()
        self.fmu.exitInitializationMode()
        assert self.fmu.newDiscreteStates() == (False, False, False, False, False, 0.0)
        self.fmu.enterContinuousTimeMode()

    def put_states(self, states: "np.ndarray[Any, Any]") -> None:
        self.fmu.setContinuousStates((ctypes.c_double * len(states))(*states), len(states))

    def got(self, read: Callable[[Any, int], None]) -> "np.ndarray[Any, Any]":
        values = (ctypes.c_double * self.states)()
        read(values, self.states)
        return np.array(values)


def matrices(folder: pathlib.Path) -> dict[str, "np.ndarray[Any, Any]"]:
    """A, B, C, D and D_v of the spec in the folder."""
    coilsense(folder, "export", "spec.toml", "--as", "state-space", "--out", "matrices.json")
    continuous = json.loads((folder / "matrices.json").read_text())["continuous"]
    # D_v is there where dashpots are.
    return {name: np.array(continuous.get(name) or np.zeros((4, 2))) for name in ["a", "b", "c", "d", "d_rate"]}


def second(end: str) -> str:
    return "u2" if end == "held" else "F_2"


@pytest.mark.parametrize("damping", DAMPINGS)
@pytest.mark.parametrize("end", ENDS)
def test_equations_are_those_of_the_state_space(tmp_path: pathlib.Path, end: str, damping: str) -> None:
    model = Model(exported(tmp_path, ENDS[end] + damping))
    told = matrices(tmp_path)
    random = np.random.default_rng(5)
    states, rates = 1e-4 * random.standard_normal(model.states), random.standard_normal(2)
    inputs = 1e-3 * random.standard_normal(2) * ([1, 1] if end == "held" else [1, 1e3])
    model.put_states(states)
    model.set(**{"u1": inputs[0], second(end): inputs[1], "der_u1": rates[0], f"der_{second(end)}": rates[1]})
    expected = told["a"] @ states + told["b"] @ inputs
    # What is left is the rounding of products and sums.
    assert np.abs(model.got(model.fmu.getDerivatives) - expected).max() <= 1e-13 * np.abs(expected).max()
    assert (model.got(model.fmu.getContinuousStates) == states).all()
    outputs = told["c"] @ states + told["d"] @ inputs + told["d_rate"] @ rates
    found = np.array(model.get(*names(end))) - [MEAN, MEAN, MEAN, 0.0][: len(names(end))]
    assert np.abs(found[:3] - outputs[:3]).max() <= 1e-12 * np.abs(outputs[:3]).max()
    assert end == "held" or abs(found[3] - outputs[3]) <= 1e-12 * abs(outputs[3])
    # Only dashpots ask for the inputs' rates, and the file says so.
    has_dashpots = damping.startswith("stiffness")
    assert (told["d_rate"] != 0.0).any() == has_dashpots
    model.set(**{"der_u1": 0.0, f"der_{second(end)}": 0.0})
    assert (model.get("F_i", "F_o") == list(found[:2] + MEAN)) != has_dashpots
    says = "F_i and F_o lack that part" if has_dashpots else "der_... are not used"
    assert says in model.description.description
    # Each value by its reference is that of the lists.
    assert model.get("z_1", "w_1", "der_z_2", "der_w_2") == [*states[:2], *model.got(model.fmu.getDerivatives)[2:4]]
    model.close()


class Solver(CVodeSolver):  # type: ignore[misc]
    """FMPy's CVode; of itself, it holds inputs between two outputs, and here they are what they are at every moment."""

    def f(self, t: float, y: Any, ydot: Any, user_data: Any) -> int:
        self.input(t)
        done: int = super().f(t, y, ydot, user_data)
        return done


def solved(model: Model, inputs: Callable[[float], dict[str, float]], tolerance: float, times: "np.ndarray[Any, Any]") -> "np.ndarray[Any, Any]":
    """F_i, F_o and F_x at the times."""
    fmu = model.fmu

    def apply(time: float) -> None:
        model.set(**inputs(time))

    solver = Solver(
        nx=model.states,
        nz=0,
        get_x=fmu.getContinuousStates,
        set_x=fmu.setContinuousStates,
        get_dx=fmu.getDerivatives,
        get_z=fmu.getEventIndicators,
        get_nominals=fmu.getNominalsOfContinuousStates,
        set_time=fmu.setTime,
        input=apply,
        startTime=0.0,
        relativeTolerance=tolerance,
        maxNumSteps=100_000,
    )
    found = []
    for time, following in zip(times, [*times[1:], None], strict=True):
        apply(time)
        fmu.completedIntegratorStep()
        found.append(model.get("F_i", "F_o", "F_x"))
        if following is not None:
            solver.step(time, following)
    return np.array(found)


@pytest.mark.parametrize("damping", [DAMPINGS[1], DAMPINGS[2], DAMPINGS[4]])
@pytest.mark.parametrize("end", ENDS)
def test_a_solver_comes_as_near_as_its_tolerance_says(tmp_path: pathlib.Path, end: str, damping: str) -> None:
    file = exported(tmp_path, ENDS[end] + damping)
    times = STEP * np.arange(61)
    size = 5e-4 if end == "held" else 0.5
    # Smooth, so that rates just before a sample and after it are one; straight between samples in both.
    at = np.stack([1e-3 * np.sin(125.0 * times), size * (1.0 - np.cos(90.0 * times))], axis=1)
    rates = np.diff(at, axis=0) / STEP

    def inputs(time: float) -> dict[str, float]:
        part = min(int(time / STEP * (1.0 + 1e-12)), len(rates) - 1)
        # A sample belongs to the part before it: the steps tell forces of dashpots from just before.
        part = max(part - 1, 0) if abs(time - part * STEP) < 1e-12 else part
        first, other = at[part] + rates[part] * (time - part * STEP)
        return {"u1": first, second(end): other, "der_u1": rates[part][0], f"der_{second(end)}": rates[part][1]}

    changed = {"k": 800.0, "zeta": 0.005 if damping.startswith("stiffness") else 0.02}
    changed |= {} if end == "mass" else {"m": 0.06}
    begun: list[dict[str, float]] = [{}, changed]
    for start in begun:
        slave = Slave(file, **start)
        expected = [slave.get("F_i", "F_o", "F_x")]
        for k in range(len(rates)):
            slave.set(**{"u1": at[k][0], second(end): at[k][1], "der_u1": rates[k][0], f"der_{second(end)}": rates[k][1]})
            slave.step(times[k], STEP)
            expected.append(slave.get("F_i", "F_o", "F_x"))
        slave.close()
        peak = np.abs(np.array(expected) - np.array(expected)[0]).max()
        errors = []
        for tolerance in [1e-4, 1e-6, 1e-8]:
            model = Model(file, **start)
            found = solved(model, inputs, tolerance, times)
            model.close()
            # Before the first sample dashpots feel no rate in the steps.
            errors.append(float(np.abs(found - expected)[1:].max() / peak))
        # Measured: 1e-2, 4e-4, 7e-6; 5e-2, 1e-3, 3e-5 of dashpots, which pull with the rates, and these jump at every sample.
        loose = 5.0 if damping.startswith("stiffness") else 1.0
        assert errors[0] < 2e-2 * loose and errors[1] < 5e-4 * loose and errors[2] < 2e-5 * loose, errors
        assert errors[1] < 0.2 * errors[0] and errors[2] < 0.2 * errors[1], errors


def test_fmpy_solves_a_jump_by_itself(tmp_path: pathlib.Path) -> None:
    file = exported(tmp_path, ENDS["held"] + DAMPINGS[1])
    times = STEP * np.arange(CONTINUOUS // 5)
    table = np.array([(0.0, 0.0), (STEP, 0.0), (STEP, 1e-4), (1.0, 1e-4)], dtype=[("time", float), ("u1", float)])
    arguments = {"fmi_type": "ModelExchange", "solver": "CVode", "stop_time": times[-1], "output_interval": STEP, "input": table}
    expected, slave = [], Slave(file)
    for k, time in enumerate(times):
        expected.append(slave.get("F_i", "F_o", "F_x"))
        if k == 1:
            # A jump of an end, as good as at once: no mode turns by more than 1e-6 meanwhile.
            slave.set(der_u1=1e-4 / 1e-10)
            slave.step(time, 1e-10)
            slave.set(u1=1e-4, der_u1=0.0)
        slave.step(time, STEP)
    slave.close()
    errors = []
    for tolerance in [1e-5, 1e-7]:
        found = fmpy.simulate_fmu(str(file), relative_tolerance=tolerance, output=["F_i", "F_o", "F_x"], **arguments)
        forces = np.stack([found[name] for name in ("F_i", "F_o", "F_x")], axis=1)[-len(times) + 3 :]
        errors.append(np.abs(forces - expected[3:]).max())
    # The jump hits all modes: several newtons.
    peak = np.abs(np.array(expected) - MEAN).max()
    assert peak > 1.0 and errors[0] < 3e-2 * peak and errors[1] < 0.1 * errors[0], (errors, peak)


def test_it_begins_at_rest_under_the_inputs_and_the_slave_has_the_same_states(tmp_path: pathlib.Path) -> None:
    file = exported(tmp_path, ENDS["mass"] + DAMPINGS[3])
    start: dict[str, float] = {"u1": 1e-3, "F_2": 0.5, "k": 900.0}
    model, slave = Model(file, **start), Slave(file, **start)
    some = ["z_1", "w_1", "z_52", "w_52", "F_i", "F_o", "F_x", "u2"]
    assert model.get(*some) == pytest.approx(slave.get(*some), rel=1e-14, abs=1e-20)
    assert np.abs(model.got(model.fmu.getDerivatives)).max() < 1e-14
    # After a step of the slave its states, put into the model, give its forces.
    slave.set(der_u1=0.3, der_F_2=-2.0)
    slave.step(0.0, STEP)
    model.put_states(np.array(slave.read([slave.numbers["z_1"] + place for place in range(model.states)])))
    model.set(**dict(zip(["u1", "F_2"], [1e-3 + 0.3 * STEP, 0.5 - 2.0 * STEP], strict=True)))
    assert model.get("F_i", "F_o", "F_x", "u2") == pytest.approx(slave.get("F_i", "F_o", "F_x", "u2"), rel=1e-13)
    rates = [slave.get(f"der_z_{mode}", f"der_w_{mode}") for mode in (1, 52)]
    assert np.array([model.get(f"der_z_{mode}", f"der_w_{mode}") for mode in (1, 52)]) == pytest.approx(np.array(rates), rel=1e-10)
    # Each interface keeps to itself.
    kept = slave.fmu.getFMUState()
    with refused(model, "an instance for the other interface"):
        model.fmu.setFMUState(kept)
    slave.fmu.freeFMUState(kept)
    kept, states = model.fmu.getFMUState(), model.got(model.fmu.getContinuousStates)
    model.put_states(0.0 * states)
    model.fmu.setFMUState(kept)
    assert (model.got(model.fmu.getContinuousStates) == states).all()
    model.fmu.freeFMUState(kept)
    slave.close()
    model.close()


def test_what_cannot_be_is_an_error_with_a_line_in_the_log(tmp_path: pathlib.Path) -> None:
    file = exported(tmp_path, ENDS["held"] + DAMPINGS[1])
    model, slave = Model(file), Slave(file)
    states = model.got(model.fmu.getContinuousStates)
    for value in [float("nan"), float("inf")]:
        with refused(model, "a state must be finite"):
            model.put_states(states + [value, *[0.0] * (model.states - 1)])
        with refused(model, "takes a finite time"):
            model.fmu.setTime(value)
    with refused(model, "two for each mode"):
        model.put_states(states[:-1])
    with refused(model, "two for each mode"):
        model.fmu.getDerivatives((ctypes.c_double * 2)(), 2)
    with refused(model, "no event indicators"):
        model.fmu.getEventIndicators((ctypes.c_double * 1)(), 1)
    with refused(model, "only inputs and parameters"):
        model.set(z_1=0.0)
    with refused(model, "up to the end of initialization only"):
        model.set(k=800.0)
    with refused(model, "fmi2EnterContinuousTimeMode is of model exchange and comes in event mode"):
        model.fmu.enterContinuousTimeMode()
    # Nothing of all that is left in it.
    assert (model.got(model.fmu.getContinuousStates) == states).all()
    assert model.get("F_i") == pytest.approx([MEAN], rel=1e-14)
    stepped = ctypes.CFUNCTYPE(ctypes.c_int, ctypes.c_void_p, ctypes.c_double, ctypes.c_double, ctypes.c_int)(("fmi2DoStep", model.fmu.dll))
    model.said.clear()
    assert stepped(model.fmu.component, 0.0, STEP, 0) == 3 and "fmi2DoStep is of co-simulation" in model.said[0][1]
    event = ctypes.CFUNCTYPE(ctypes.c_int, ctypes.c_void_p)(("fmi2EnterEventMode", slave.fmu.dll))
    assert event(slave.fmu.component) == 3 and "is of model exchange" in slave.said[-1][1]
    # Again from the start: it is one for model exchange still.
    model.fmu.enterEventMode()
    model.fmu.terminate()
    model.fmu.reset()
    model.fmu.enterInitializationMode()
    model.fmu.exitInitializationMode()
    model.fmu.enterContinuousTimeMode()
    slave.close()
    model.close()
