"""FMUs of `coilsense export` in FMPy's hands, and what `coilsense simulate` has of the same spring.

Next door: the tests (`test_fmu`, `test_fmu_equations`, `test_fmu_importers`).
"""

import csv
import os
import pathlib
import random
import subprocess
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

import fmpy
import numpy as np
import pytest
from fmpy.fmi1 import FMICallException
from fmpy.fmi2 import FMU2Slave, fmi2CallbackFunctions, fmi2CallbackLoggerTYPE
from fmpy.fmi3 import FMU3Slave

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


def exported(folder: pathlib.Path, mount: str, version: str = "2.0", *more: str) -> pathlib.Path:
    """An FMU of S_T."""
    (folder / "spec.toml").write_text(S_T + mount + "\n")
    coilsense(folder, "export", "spec.toml", "--as", "fmu", "--fmi", version, "--out", "spring.fmu", *more)
    return folder / "spring.fmu"


class Slave:
    """An instance for co-simulation from its start to the end of its initialization, and what it says; 2.0 or 3.0 as the file has it."""

    def __init__(self, file: pathlib.Path, name: str = "one", /, **start: float) -> None:
        self.said: list[tuple[int, str]] = []
        self.description = fmpy.read_model_description(str(file))
        self.is_three = self.description.fmiVersion == "3.0"
        arguments = {
            "guid": self.description.guid,
            "unzipDirectory": fmpy.extract(str(file)),
            "modelIdentifier": self.description.coSimulation.modelIdentifier,
            "instanceName": name,
        }
        self.numbers = {variable.name: variable.valueReference for variable in self.description.modelVariables}
        if self.is_three:
            self.fmu = FMU3Slave(**arguments)
            self.fmu.instantiate(logMessage=lambda _, status, __, message: self.said.append((status, message.decode())))
        else:
            self.fmu = FMU2Slave(**arguments)
            self.host = logging_to(self.said)
            self.fmu.instantiate(callbacks=self.host)
            self.fmu.setupExperiment(startTime=0.0)
        self.set(**start)
        self.fmu.enterInitializationMode()
        self.fmu.exitInitializationMode()

    def set(self, **values: float) -> None:
        self.put([self.numbers[name] for name in values], list(values.values()))

    def put(self, numbers: list[int], values: list[float]) -> None:
        (self.fmu.setFloat64 if self.is_three else self.fmu.setReal)(numbers, values)

    def get(self, *names: str) -> list[float]:
        return self.read([self.numbers[name] for name in names])

    def read(self, numbers: list[int]) -> list[float]:
        found: list[float] = (self.fmu.getFloat64 if self.is_three else self.fmu.getReal)(numbers)
        return found

    def step(self, time: float, step: float) -> Any:
        return self.fmu.doStep(currentCommunicationPoint=time, communicationStepSize=step)

    def close(self) -> None:
        self.fmu.terminate()
        self.fmu.freeInstance()


def logging_to(said: list[tuple[int, str]]) -> Any:
    """What an FMU of 2.0 calls when it says something."""

    def log(_: Any, __: bytes, status: int, ___: bytes, message: bytes) -> None:
        said.append((status, message.decode()))

    host = fmi2CallbackFunctions()
    host.logger = fmi2CallbackLoggerTYPE(log)
    return host


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
