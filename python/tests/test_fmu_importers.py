"""FMUs of `coilsense export` in a second simulator, Ecos (C++, with a loader of its own), beside `simulate`.

Next door: what is shared (`fmus`), FMPy (`test_fmu`, `test_fmu_equations`).
"""

import ctypes
import pathlib
import platform
import sys

import numpy as np
import pytest
from fmus import DAMPINGS, ENDS, SAMPLES, STEP, assert_near, exported, names, shaken, simulated

# As python/requirements-test.txt has it.
HAS_ECOS = sys.platform == "linux" and platform.machine() == "x86_64"
pytestmark = pytest.mark.skipif(not HAS_ECOS, reason="ecospy has no binary for this machine")
if HAS_ECOS:
    # Ecos wants it and does not bring it; pip lays it where the environment's libraries are.
    ctypes.CDLL(str(pathlib.Path(sys.prefix) / "lib/libtbb.so.12"), mode=ctypes.RTLD_GLOBAL)
    from ecospy import EcosSimulation, EcosSimulationStructure


def both(folder: pathlib.Path, end: str) -> dict[str, pathlib.Path]:
    """An FMU of each version, in folders of their own as their names are one."""
    files = {}
    for version in ["2.0", "3.0"]:
        (folder / version).mkdir()
        files["two" if version == "2.0" else "three"] = exported(folder / version, ENDS[end] + DAMPINGS[1], version)
    return files


@pytest.mark.parametrize("has_rates", [True, False])
@pytest.mark.parametrize("end", ENDS)
def test_both_versions_side_by_side_have_the_forces_of_simulate(tmp_path: pathlib.Path, end: str, has_rates: bool) -> None:
    files, inputs = both(tmp_path, end), shaken(end)
    expected = simulated(tmp_path / "2.0", end, inputs)
    rates, second = np.diff(inputs, axis=0) / STEP, "u2" if end == "held" else "F_2"
    found: dict[str, list[list[float]]] = {name: [] for name in files}
    with EcosSimulationStructure() as structure:
        for name, file in files.items():
            structure.add_model(name, str(file))
        with EcosSimulation(structure=structure, step_size=STEP) as simulation:
            simulation.init()
            for k in range(SAMPLES - 1):
                told = {"u1": inputs[k][0], second: inputs[k][1]}
                if has_rates:
                    told |= {"der_u1": rates[k][0], f"der_{second}": rates[k][1]}
                for name in files:
                    for variable, value in told.items():
                        simulation.set_real(f"{name}::{variable}", float(value))
                simulation.step()
                for name, rows in found.items():
                    rows.append([simulation.get_real(f"{name}::{variable}") for variable in names(end)])
            simulation.terminate()
    # With rates the sample at a step's end, without them the one at its start.
    reached = expected[1:] if has_rates else expected[:-1]
    for rows in found.values():
        assert_near(np.array(rows), reached)


def test_parameters_are_told_at_the_start(tmp_path: pathlib.Path) -> None:
    for name, file in both(tmp_path, "held").items():
        with EcosSimulationStructure() as structure:
            structure.add_model(name, str(file))
            structure.add_parameter_set("stiffer", {f"{name}::k": 900.0})
            with EcosSimulation(structure=structure, step_size=STEP) as simulation:
                simulation.init(parameter_set="stiffer")
                # 126 mm of stretch.
                assert simulation.get_real(f"{name}::F_x") == pytest.approx(900.0 * 0.126, rel=1e-14)
                simulation.terminate()
