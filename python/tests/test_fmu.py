"""`coilsense export --as fmu` for co-simulation in a simulator that others wrote: FMPy reads, checks, compiles and steps it, and gets the forces of
`simulate`.

Next door: what is shared (`fmus`), model exchange (`test_fmu_equations`), the command's words and refusals (`crates/coilsense-cli/tests/specs/fmu.rs`),
the spring's step itself (`coilsense`, `tests/plant.rs`).
"""

import ctypes
import inspect
import os
import pathlib
import random
import re
import sys
import warnings
import zipfile
from typing import Any

import coilsense
import fmpy
import numpy as np
import pytest
from fmpy.build import build_platform_binary
from fmpy.fmi1 import FMICallException
from fmpy.fmi3 import FMU3Model, FMU3ScheduledExecution, FMU3Slave
from fmpy.validation import validate_fmu
from fmus import DAMPINGS, ENDS, ERROR, SAMPLES, STEP, Slave, assert_near, exported, names, refused, shaken, simulated

VERSIONS = ["2.0", "3.0"]
# Where the standards have a binary for this machine.
BINARIES = {"2.0": "binaries/linux64/spring.so", "3.0": "binaries/x86_64-linux/spring.so"}


@pytest.mark.parametrize("version", VERSIONS)
@pytest.mark.parametrize("damping", DAMPINGS)
@pytest.mark.parametrize("end", ENDS)
def test_forces_with_rates_are_those_of_simulate_in_any_steps(tmp_path: pathlib.Path, end: str, damping: str, version: str) -> None:
    file = exported(tmp_path, ENDS[end] + damping, version)
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
                if len(parts) == 2 and version == "2.0":
                    slave.fmu.setRealInputDerivatives([slave.numbers["u1"], slave.numbers[second]], [1, 1], list(rate))
                else:
                    slave.set(**{"der_u1": rate[0], f"der_{second}": rate[1]})
                slave.step((k + gone) * STEP, part * STEP)
                gone += part
            found.append(slave.get(*names(end)))
        slave.close()
        assert_near(np.array(found)[told], expected[told])


@pytest.mark.parametrize("version", VERSIONS)
@pytest.mark.parametrize("end", ENDS)
def test_without_rates_the_forces_are_one_step_late(tmp_path: pathlib.Path, end: str, version: str) -> None:
    file = exported(tmp_path, ENDS[end] + DAMPINGS[1], version)
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


@pytest.mark.parametrize("version", VERSIONS)
def test_fmpy_simulates_it_from_a_table(tmp_path: pathlib.Path, version: str) -> None:
    file = exported(tmp_path, ENDS["held"] + DAMPINGS[1], version)
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


@pytest.mark.parametrize("version", VERSIONS)
def test_a_step_taken_back_gives_the_same_bits(tmp_path: pathlib.Path, version: str) -> None:
    slave = Slave(exported(tmp_path, ENDS["mass"] + DAMPINGS[4], version))
    source = random.Random(3)

    def go(start: int) -> list[list[float]]:
        random_inputs, out = random.Random(start), []
        for k in range(start, start + 20):
            slave.set(u1=1e-3 * random_inputs.uniform(-1, 1), der_u1=random_inputs.uniform(-1, 1), F_2=random_inputs.uniform(-1, 1))
            slave.step(k * STEP, STEP)
            out.append(slave.get("F_i", "F_o", "F_x", "u2"))
        return out

    go(0)
    kept = slave.fmu.getFMUState()
    packed = slave.fmu.serializeFMUState(kept)
    first = go(20)
    # A step of another size in between changes coefficients, not what is kept.
    slave.step(40 * STEP, source.random() * STEP)
    slave.fmu.setFMUState(kept)
    assert go(20) == first
    slave.fmu.freeFMUState(kept)
    unpacked = slave.fmu.deserializeFMUState(packed)
    slave.fmu.setFMUState(unpacked)
    assert go(20) == first
    slave.fmu.freeFMUState(unpacked)
    with refused(slave, "no state of this FMU"):
        slave.fmu.deserializeFMUState(bytes(len(packed)))
    slave.close()


@pytest.mark.parametrize("version", VERSIONS)
def test_two_instances_do_not_know_of_each_other(tmp_path: pathlib.Path, version: str) -> None:
    file = exported(tmp_path, ENDS["held"] + DAMPINGS[1], version)
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


@pytest.mark.parametrize("version", VERSIONS)
def test_what_cannot_be_is_an_error_with_a_line_in_the_log(tmp_path: pathlib.Path, version: str) -> None:
    file = exported(tmp_path, ENDS["held"] + DAMPINGS[1], version)
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
    for number in [len(slave.numbers) + 1, 2**32 - 1]:
        with refused(slave, "no value of this reference"):
            slave.read([number])
        with refused(slave, "no value of this reference"):
            slave.put([number], [0.0])
    if version == "2.0":
        with refused(slave, "no integer values"):
            slave.fmu.getInteger([1])
    else:
        for kind in ["Float32", "Int8", "UInt64", "Boolean", "String", "Clock"]:
            with refused(slave, "all values are Float64"):
                getattr(slave.fmu, "get" + kind)([1])
        with refused(slave, "no event mode"):
            slave.fmu.enterEventMode()
        with refused(slave, "each reference has one value"):
            slave.fmu.getFloat64([1, 2], nValues=1)
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


@pytest.mark.parametrize("version", VERSIONS)
@pytest.mark.parametrize(
    ("start", "says"),
    [({"k": 0.0}, "k must be above zero"), ({"m": -1.0}, "m must be above zero"), ({"zeta": -0.1}, "zeta must be from zero on")],
)
def test_parameters_that_cannot_be_end_the_initialization(tmp_path: pathlib.Path, start: dict[str, float], says: str, version: str) -> None:
    said: list[str] = []

    class Told(Slave):
        def __init__(self) -> None:
            try:
                super().__init__(file, "told", **start)
            finally:
                said.extend(message for _, message in self.said)

    file = exported(tmp_path, ENDS["held"] + DAMPINGS[1], version)
    with pytest.raises(FMICallException) as caught:
        Told()
    assert caught.value.status == ERROR and len(said) == 1 and says in said[0], said


@pytest.mark.parametrize("version", VERSIONS)
def test_the_mass_of_a_spring_with_an_end_mass_stays(tmp_path: pathlib.Path, version: str) -> None:
    slave = Slave(exported(tmp_path, ENDS["mass"] + DAMPINGS[1], version))
    mass = next(variable for variable in slave.description.modelVariables if variable.name == "m")
    assert (mass.causality, mass.variability) == ("local", "constant")
    with refused(slave, "only inputs and parameters"):
        slave.set(m=0.1)
    slave.close()


def test_what_a_step_tells_beside_in_3(tmp_path: pathlib.Path) -> None:
    slave = Slave(exported(tmp_path, ENDS["held"] + DAMPINGS[1], "3.0"))
    # No event, no end, no early return, and until when it went.
    assert slave.step(0.0, 0.25) == (False, False, False, 0.25)
    assert slave.read([0]) == [0.25]
    # Again from the start, which is another time.
    slave.fmu.reset()
    slave.fmu.enterInitializationMode(startTime=3.0)
    slave.fmu.exitInitializationMode()
    assert slave.step(3.0, 1.0) == (False, False, False, 4.0)
    slave.close()


def test_interfaces_that_are_not_in_3_make_no_instance(tmp_path: pathlib.Path) -> None:
    file = exported(tmp_path, ENDS["held"] + DAMPINGS[1], "3.0")
    slave = Slave(file)
    said: list[str] = []

    def log(_: object, __: int, ___: bytes, message: bytes) -> None:
        said.append(message.decode())

    asked: list[tuple[dict[str, Any], str]] = [
        ({"eventModeUsed": True}, "no event mode"),
        ({"requiredIntermediateVariables": [8]}, "no intermediate update"),
    ]
    for arguments, says in asked:
        with pytest.raises(Exception, match="Failed to instantiate"):
            FMU3Slave(guid=slave.fmu.guid, unzipDirectory=slave.fmu.unzipDirectory, modelIdentifier="spring").instantiate(logMessage=log, **arguments)
        assert len(said) == 1 and says in said.pop()
    for other in [FMU3Model, FMU3ScheduledExecution]:
        with pytest.raises(Exception, match="Failed to instantiate"):
            other(guid=slave.fmu.guid, unzipDirectory=slave.fmu.unzipDirectory, modelIdentifier="spring").instantiate(logMessage=log)
        assert len(said) == 1 and "only co-simulation" in said.pop()
    slave.close()


def test_all_functions_of_3_are_there(tmp_path: pathlib.Path) -> None:
    file = exported(tmp_path, ENDS["held"] + DAMPINGS[1], "3.0")
    with zipfile.ZipFile(file) as archive:
        archive.extract(BINARIES["3.0"], tmp_path)
    library = ctypes.CDLL(str(tmp_path / BINARIES["3.0"]))
    wanted = re.findall(r"def (fmi3[A-Z]\w+)\(", inspect.getsource(fmpy.fmi3))
    assert len(wanted) == 75
    assert [name for name in wanted if not hasattr(library, name)] == []


@pytest.mark.parametrize("version", VERSIONS)
def test_another_guid_makes_no_instance(tmp_path: pathlib.Path, version: str) -> None:
    file = exported(tmp_path, ENDS["held"] + DAMPINGS[1], version)
    with zipfile.ZipFile(file) as archive:
        archive.extract(BINARIES[version], tmp_path)
    library = ctypes.CDLL(str(tmp_path / BINARIES[version]))
    for guid in [b"{00000000-0000-0000-0000-000000000000}", b"", None]:
        if version == "2.0":
            library.fmi2Instantiate.restype = ctypes.c_void_p
            assert library.fmi2Instantiate(b"one", 1, guid, b"", None, 0, 0) is None
        else:
            library.fmi3InstantiateCoSimulation.restype = ctypes.c_void_p
            assert library.fmi3InstantiateCoSimulation(b"one", guid, b"", 0, 0, 0, 0, None, 0, None, None, None) is None
    if version == "2.0":
        assert library.fmi2DoStep(None, ctypes.c_double(0.0), ctypes.c_double(1.0), 0) == ERROR
    else:
        assert library.fmi3DoStep(None, ctypes.c_double(0.0), ctypes.c_double(1.0), 0, None, None, None, None) == ERROR


@pytest.mark.parametrize("version", VERSIONS)
def test_the_guid_is_that_of_the_content(tmp_path: pathlib.Path, version: str) -> None:
    first = exported(tmp_path, ENDS["held"] + DAMPINGS[1], version)
    bytes_of_first, guid = first.read_bytes(), fmpy.read_model_description(str(first)).guid
    assert exported(tmp_path, ENDS["held"] + DAMPINGS[1], version).read_bytes() == bytes_of_first
    assert fmpy.read_model_description(str(exported(tmp_path, ENDS["held"] + DAMPINGS[2], version))).guid != guid


@pytest.mark.parametrize("version", VERSIONS)
def test_the_sources_build_in_another_s_hands(tmp_path: pathlib.Path, monkeypatch: pytest.MonkeyPatch, version: str) -> None:
    # Where pip lays the CMake that FMPy brings.
    monkeypatch.setenv("PATH", os.pathsep.join([str(pathlib.Path(sys.executable).parent), os.environ["PATH"]]))
    file = exported(tmp_path, ENDS["held"] + DAMPINGS[1], version)
    folder = tmp_path / "unpacked"
    with zipfile.ZipFile(file) as archive:
        archive.extractall(folder)
    (folder / BINARIES[version]).unlink()
    with warnings.catch_warnings():
        # FMPy leaves its temporary folder to the collector.
        warnings.simplefilter("ignore", ResourceWarning)
        build_platform_binary(folder)
    found = fmpy.simulate_fmu(str(folder), stop_time=0.01, start_values={"u1": 1e-3})
    assert found["F_i"] == pytest.approx(95.76 - 0.76, rel=1e-14)


def test_python_writes_what_the_command_writes(tmp_path: pathlib.Path) -> None:
    for version in VERSIONS:
        expected = exported(tmp_path, ENDS["held"] + DAMPINGS[1], version).read_bytes()
        plant = coilsense.plant(tmp_path / "spec.toml")
        plant.save(tmp_path / "spring.fmu", "fmu", fmi=version)  # type: ignore[arg-type]
        assert (tmp_path / "spring.fmu").read_bytes() == expected
    with pytest.raises(coilsense.Error, match="fmi.*goes with fmu, got 3.0 with c"):
        plant.save(tmp_path / "a.h", "c", fmi="3.0")
    with pytest.raises(coilsense.Error, match="fmi.*must be one of 2.0, 3.0"):
        plant.save(tmp_path / "a.fmu", "fmu", fmi="1.0")  # type: ignore[arg-type]
