"""`coilsense export --as fmu` in a simulator that others wrote: FMPy reads, checks, compiles and steps it, and gets the forces of `simulate`.

Next door: the command's words and refusals (`crates/coilsense-cli/tests/specs/fmu.rs`), the spring's step itself (`coilsense`, `tests/plant.rs`).
"""

import csv
import ctypes
import os
import pathlib
import random
import subprocess
import sys
import warnings
import zipfile
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

import fmpy
import numpy as np
import pytest
from fmpy.build import build_platform_binary
from fmpy.fmi1 import FMICallException
from fmpy.fmi2 import FMU2Slave, fmi2CallbackFunctions, fmi2CallbackLoggerTYPE
from fmpy.validation import validate_fmu

# Forces of S_T are 1e2 N and inputs 1e-3 m; the rates lose a digit or two in a difference of samples.
NEAR = 1e-10
STEP = 1e-3
SAMPLES = 300
ERROR = 3

S_T = """[spring]
name = "S_T"
model = "chain"
rest_length = "104 mm"
windings = 52
masses_per_winding = 1
coil_radius = "8 mm"
wire_radius = "1 mm"
mass = "65 g"
stiffness = "760 N/m"
min_length = "196 mm"
max_length = "264 mm"
[mount]
"""
ENDS = {"held": 'end2 = "held"\n', "force": 'end2 = "force"\n', "mass": 'end2 = "mass"\nend_mass = "0.3 kg"\n'}
DAMPINGS = ["damping_ratio = 0", "damping_ratio = 0.005", "damping_ratio = 1", 'mass_damping = "20 1/s"', 'stiffness_damping = "0.3 ms"']
SHAKEN = """
[[condition]]
name = "shaken"
kind = "recorded"
file = "shaken.csv"
length = "230 mm"
sample_rate = "1 kHz"
"""


def coilsense(folder: pathlib.Path, *words: str) -> None:
    """Runs the command: that of `COILSENSE_COMMAND`, which `cargo xtask test` sets."""
    command = os.environ.get("COILSENSE_COMMAND")
    assert command, "COILSENSE_COMMAND must name the command that cargo built"
    subprocess.run([command, *words], cwd=folder, check=True, capture_output=True)


def exported(folder: pathlib.Path, mount: str) -> pathlib.Path:
    """An FMU of S_T."""
    (folder / "spec.toml").write_text(S_T + mount + "\n")
    coilsense(folder, "export", "spec.toml", "--as", "fmu", "--out", "spring.fmu")
    return folder / "spring.fmu"


class Slave:
    """An instance from its start to the end of its initialization, and what it says."""

    def __init__(self, file: pathlib.Path, name: str = "one", **start: float) -> None:
        self.said: list[tuple[int, str]] = []
        self.description = fmpy.read_model_description(str(file))
        folder = fmpy.extract(str(file))
        identifier = self.description.coSimulation.modelIdentifier
        self.fmu = FMU2Slave(guid=self.description.guid, unzipDirectory=folder, modelIdentifier=identifier, instanceName=name)
        def log(_: Any, __: bytes, status: int, ___: bytes, message: bytes) -> None:
            self.said.append((status, message.decode()))

        host = fmi2CallbackFunctions()
        host.logger = fmi2CallbackLoggerTYPE(log)
        self.host = host
        self.numbers = {variable.name: variable.valueReference for variable in self.description.modelVariables}
        self.fmu.instantiate(callbacks=host)
        self.fmu.setupExperiment(startTime=0.0)
        self.set(**start)
        self.fmu.enterInitializationMode()
        self.fmu.exitInitializationMode()

    def set(self, **values: float) -> None:
        self.fmu.setReal([self.numbers[name] for name in values], list(values.values()))

    def get(self, *names: str) -> list[float]:
        found: list[float] = self.fmu.getReal([self.numbers[name] for name in names])
        return found

    def step(self, time: float, step: float) -> None:
        self.fmu.doStep(currentCommunicationPoint=time, communicationStepSize=step)

    def close(self) -> None:
        self.fmu.terminate()
        self.fmu.freeInstance()


@contextmanager
def refused(slave: Slave, says: str) -> Iterator[None]:
    """What is done inside is an error of which the log has a line."""
    slave.said.clear()
    with pytest.raises(FMICallException) as caught:
        yield
    assert caught.value.status == ERROR
    assert len(slave.said) == 1 and slave.said[0][0] == ERROR and says in slave.said[0][1], slave.said


def shaken(end: str) -> "np.ndarray[Any, Any]":
    """Inputs as rough as can be, of which the first is zero: [m], and [m] or [N]."""
    source = random.Random(7)
    second = 1e-3 if end == "held" else 1.0
    rows = [[0.0, 0.0]] + [[1e-3 * source.uniform(-1, 1), second * source.uniform(-1, 1)] for _ in range(SAMPLES - 1)]
    return np.array(rows)


def simulated(folder: pathlib.Path, end: str, inputs: "np.ndarray[Any, Any]") -> "np.ndarray[Any, Any]":
    """F_i, F_o, F_x and u2 that `coilsense simulate` has of the spec in the folder."""
    head = "time [s],u1 [m]," + ("u2 [m]" if end == "held" else "F_2 [N]")
    lines = [f"{STEP * k!r},{float(a)!r},{float(b)!r}" for k, (a, b) in enumerate(inputs)]
    (folder / "shaken.csv").write_text("\n".join([head, *lines]) + "\n")
    with open(folder / "spec.toml", "a") as spec:
        spec.write(SHAKEN)
    coilsense(folder, "simulate", "spec.toml", "--out", "out.csv")
    with open(folder / "out.csv") as file:
        rows = list(csv.DictReader(file))
    assert len(rows) == SAMPLES
    return np.array([[float(row["F_i [N]"]), float(row["F_o [N]"]), float(row["F_x [N]"]), float(row["u2 [m]"]) - 0.23] for row in rows])


def names(end: str) -> list[str]:
    return ["F_i", "F_o", "F_x"] if end == "held" else ["F_i", "F_o", "F_x", "u2"]


def assert_near(found: "np.ndarray[Any, Any]", expected: "np.ndarray[Any, Any]") -> None:
    for column in range(found.shape[1]):
        peak = np.abs(expected[:, column]).max()
        # What `simulate` writes of u2 counts from end 1, and so has lost what 0.23 m cannot hold.
        slack = NEAR * peak + (1e-16 if column == 3 else 0.0)
        assert np.abs(found[:, column] - expected[:, column]).max() <= slack, column


@pytest.mark.parametrize("damping", DAMPINGS)
@pytest.mark.parametrize("end", ENDS)
def test_forces_with_rates_are_those_of_simulate_in_any_steps(tmp_path: pathlib.Path, end: str, damping: str) -> None:
    file = exported(tmp_path, ENDS[end] + damping)
    assert validate_fmu(str(file)) == []
    inputs = shaken(end)
    # Dashpots pull with the ends' velocity, which jumps at every other sample: there `simulate` tells the force after, a step that before it.
    inputs[1:-1:2] = 0.5 * (inputs[0:-2:2] + inputs[2::2])
    told = slice(1, -1, 2) if damping.startswith("stiffness") else slice(None)
    expected = simulated(tmp_path, end, inputs)
    second = "u2" if end == "held" else "F_2"
    for parts in [(1.0,), (0.25, 0.5, 0.25), (0.9, 0.1)]:
        slave = Slave(file)
        assert slave.get("F_i", "F_o", "F_x") == pytest.approx([95.76] * 3, rel=1e-14)
        found = [slave.get(*names(end))]
        for k in range(SAMPLES - 1):
            rate, gone = (inputs[k + 1] - inputs[k]) / STEP, 0.0
            for part in parts:
                at = inputs[k] + rate * (gone * STEP)
                slave.set(**{"u1": at[0], second: at[1]})
                if len(parts) == 2:
                    slave.fmu.setRealInputDerivatives([slave.numbers["u1"], slave.numbers[second]], [1, 1], list(rate))
                else:
                    slave.set(**{"der_u1": rate[0], f"der_{second}": rate[1]})
                slave.step((k + gone) * STEP, part * STEP)
                gone += part
            found.append(slave.get(*names(end)))
        slave.close()
        assert_near(np.array(found)[told], expected[told])


@pytest.mark.parametrize("end", ENDS)
def test_without_rates_the_forces_are_one_step_late(tmp_path: pathlib.Path, end: str) -> None:
    file = exported(tmp_path, ENDS[end] + DAMPINGS[1])
    inputs = shaken(end)
    expected = simulated(tmp_path, end, inputs)
    slave = Slave(file)
    found = []
    for k in range(SAMPLES):
        slave.set(**{"u1": inputs[k][0], "u2" if end == "held" else "F_2": inputs[k][1]})
        slave.step(k * STEP, STEP)
        found.append(slave.get(*names(end)))
    slave.close()
    assert "one step late" in slave.description.description
    # What is set at a sample is reached a step later.
    assert_near(np.array(found), expected)


def test_fmpy_simulates_it_from_a_table(tmp_path: pathlib.Path) -> None:
    file = exported(tmp_path, ENDS["held"] + DAMPINGS[1])
    inputs = shaken("held")
    expected = simulated(tmp_path, "held", inputs)
    table = np.zeros(SAMPLES, dtype=[("time", float), ("u1", float), ("u2", float)])
    table["time"], table["u1"], table["u2"] = STEP * np.arange(SAMPLES), inputs[:, 0], inputs[:, 1]
    end = STEP * (SAMPLES - 1)
    found = fmpy.simulate_fmu(str(file), stop_time=end, output_interval=STEP, input=table)
    # FMPy sets what the table has at a step's start, and no rate: one step late.
    forces = np.stack([found[name][1:] for name in ("F_i", "F_o", "F_x")], axis=1)
    assert_near(forces, expected[: len(forces), :3])
    assert len(forces) == SAMPLES - 1


def test_a_step_taken_back_gives_the_same_bits(tmp_path: pathlib.Path) -> None:
    slave = Slave(exported(tmp_path, ENDS["mass"] + DAMPINGS[4]))
    source = random.Random(3)

    def go(start: int) -> list[list[float]]:
        random_inputs, out = random.Random(start), []
        for k in range(start, start + 20):
            slave.set(u1=1e-3 * random_inputs.uniform(-1, 1), der_u1=random_inputs.uniform(-1, 1), F_2=random_inputs.uniform(-1, 1))
            slave.step(k * STEP, STEP)
            out.append(slave.get("F_i", "F_o", "F_x", "u2"))
        return out

    go(0)
    kept = slave.fmu.getFMUstate()
    packed = slave.fmu.serializeFMUstate(kept)
    first = go(20)
    # A step of another size in between changes coefficients, not what is kept.
    slave.step(40 * STEP, source.random() * STEP)
    slave.fmu.setFMUstate(kept)
    assert go(20) == first
    slave.fmu.freeFMUstate(kept)
    unpacked = slave.fmu.deSerializeFMUstate(packed)
    slave.fmu.setFMUstate(unpacked)
    assert go(20) == first
    slave.fmu.freeFMUstate(unpacked)
    with refused(slave, "no state of this FMU"):
        slave.fmu.deSerializeFMUstate(bytes(len(packed)))
    slave.close()


def test_two_instances_do_not_know_of_each_other(tmp_path: pathlib.Path) -> None:
    file = exported(tmp_path, ENDS["held"] + DAMPINGS[1])
    alone = Slave(file, u1=1e-3)
    one, two = Slave(file, "one", u1=1e-3), Slave(file, "two", k=900.0, m=0.05, zeta=0.5)
    for k in range(50):
        for slave in (alone, one):
            slave.set(der_u1=1.0)
            slave.step(k * STEP, STEP)
        two.set(u2=1e-4 * k)
        two.step(k * 0.5 * STEP, 0.5 * STEP)
        assert one.get("F_i", "F_o") == alone.get("F_i", "F_o")
    assert two.get("k", "m", "zeta") == [900.0, 0.05, 0.5]
    # 900 N/m about 126 mm of stretch.
    assert abs(two.get("F_x")[0] - 900.0 * (0.126 + 49e-4)) < 1e-9
    for slave in (alone, one, two):
        slave.close()


def test_what_cannot_be_is_an_error_with_a_line_in_the_log(tmp_path: pathlib.Path) -> None:
    file = exported(tmp_path, ENDS["held"] + DAMPINGS[1])
    slave = Slave(file)
    for step in [0.0, -STEP, float("nan"), float("inf")]:
        with refused(slave, "communication step must be above zero and finite"):
            slave.step(0.0, step)
    for value in [float("nan"), float("inf")]:
        for name in ["u1", "der_u2"]:
            with refused(slave, "must be finite"):
                slave.set(**{name: value})
    with refused(slave, "too long or too short"):
        slave.step(0.0, 1e9)
    for time in [float("nan"), 1.0]:
        with refused(slave, "must begin where the last one ended"):
            slave.step(time, STEP)
    with refused(slave, "up to the end of initialization only"):
        slave.set(k=800.0)
    with refused(slave, "only inputs and parameters"):
        slave.set(F_i=1.0)
    with refused(slave, "no value of this reference"):
        slave.fmu.getReal([8])
    with refused(slave, "no value of this reference"):
        slave.fmu.getReal([2**32 - 1])
    with refused(slave, "no integer values"):
        slave.fmu.getInteger([1])
    with refused(slave, "comes once"):
        slave.fmu.enterInitializationMode()
    slave.set(u1=1.7e308)
    with refused(slave, "beyond what numbers hold"):
        slave.step(0.0, STEP)
    # Nothing of all that is left in it.
    slave.set(u1=0.0)
    slave.step(0.0, STEP)
    assert slave.get("F_i", "F_o", "F_x") == pytest.approx([95.76] * 3, rel=1e-14)
    slave.close()


@pytest.mark.parametrize(
    ("start", "says"),
    [({"k": 0.0}, "k must be above zero"), ({"m": -1.0}, "m must be above zero"), ({"zeta": -0.1}, "zeta must be from zero on")],
)
def test_parameters_that_cannot_be_end_the_initialization(tmp_path: pathlib.Path, start: dict[str, float], says: str) -> None:
    said: list[str] = []

    class Told(Slave):
        def __init__(self) -> None:
            try:
                super().__init__(file, "told", **start)
            finally:
                said.extend(message for _, message in self.said)

    file = exported(tmp_path, ENDS["held"] + DAMPINGS[1])
    with pytest.raises(FMICallException) as caught:
        Told()
    assert caught.value.status == ERROR and len(said) == 1 and says in said[0], said


def test_the_mass_of_a_spring_with_an_end_mass_stays(tmp_path: pathlib.Path) -> None:
    slave = Slave(exported(tmp_path, ENDS["mass"] + DAMPINGS[1]))
    mass = next(variable for variable in slave.description.modelVariables if variable.name == "m")
    assert (mass.causality, mass.variability) == ("local", "constant")
    with refused(slave, "only inputs and parameters"):
        slave.set(m=0.1)
    slave.close()


def test_another_guid_makes_no_instance(tmp_path: pathlib.Path) -> None:
    file = exported(tmp_path, ENDS["held"] + DAMPINGS[1])
    with zipfile.ZipFile(file) as archive:
        archive.extract("binaries/linux64/spring.so", tmp_path)
    library = ctypes.CDLL(str(tmp_path / "binaries/linux64/spring.so"))
    library.fmi2Instantiate.restype = ctypes.c_void_p
    for guid in [b"{00000000-0000-0000-0000-000000000000}", b"", None]:
        assert library.fmi2Instantiate(b"one", 1, guid, b"", None, 0, 0) is None
    assert library.fmi2DoStep(None, ctypes.c_double(0.0), ctypes.c_double(1.0), 0) == ERROR


def test_the_guid_is_that_of_the_content(tmp_path: pathlib.Path) -> None:
    first = exported(tmp_path, ENDS["held"] + DAMPINGS[1])
    bytes_of_first, guid = first.read_bytes(), fmpy.read_model_description(str(first)).guid
    assert exported(tmp_path, ENDS["held"] + DAMPINGS[1]).read_bytes() == bytes_of_first
    assert fmpy.read_model_description(str(exported(tmp_path, ENDS["held"] + DAMPINGS[2]))).guid != guid


def test_the_sources_build_in_another_s_hands(tmp_path: pathlib.Path, monkeypatch: pytest.MonkeyPatch) -> None:
    # Where pip lays the CMake that FMPy brings.
    monkeypatch.setenv("PATH", os.pathsep.join([str(pathlib.Path(sys.executable).parent), os.environ["PATH"]]))
    file = exported(tmp_path, ENDS["held"] + DAMPINGS[1])
    folder = tmp_path / "unpacked"
    with zipfile.ZipFile(file) as archive:
        archive.extractall(folder)
    (folder / "binaries/linux64/spring.so").unlink()
    with warnings.catch_warnings():
        # FMPy leaves its temporary folder to the collector.
        warnings.simplefilter("ignore", ResourceWarning)
        build_platform_binary(folder)
    found = fmpy.simulate_fmu(str(folder), stop_time=0.01, start_values={"u1": 1e-3})
    assert found["F_i"] == pytest.approx(95.76 - 0.76, rel=1e-14)
