"""F_L and the closest pitch of an FMU in FMPy, beside `simulate` and the positions of the motion.

Next door: its forces (`test_fmu`), how far F_L may be off (`coilsense`, `tests/plant/coil.rs`).
"""

import csv
import pathlib
import sys

import coilsense
import fmpy
import numpy as np
import pytest
from fmpy.validation import validate_fmu
from fmus import DAMPINGS, ENDS, SAMPLES, STEP, Slave, exported, shaken, simulated
from fmus import coilsense as command

ALSO = ["--also", "F_L,closest_pitch"]


@pytest.mark.parametrize("version", ["2.0", "3.0"])
@pytest.mark.parametrize("end", ENDS)
def test_they_are_those_of_the_motion(tmp_path: pathlib.Path, end: str, version: str) -> None:
    file = exported(tmp_path, ENDS[end] + DAMPINGS[1], version, *ALSO)
    assert validate_fmu(str(file)) == []
    inputs = 0.2 * shaken(end)
    simulated(tmp_path, end, inputs)
    with open(tmp_path / "out.csv") as rows:
        table = list(csv.DictReader(rows))
    lengths = np.array([float(row["u2 [m]"]) - float(row["u1 [m]"]) for row in table])
    expected = np.array([[float(row["F_L [N]"]), float(row["L [H]"])] for row in table])
    spring = coilsense.Spec.read(tmp_path / "spec.toml").spring
    kind = {"held": coilsense.FarEnd.position(), "force": coilsense.FarEnd.force(), "mass": coilsense.FarEnd.mass(0.3)}[end]
    mount = coilsense.Mount(kind, coilsense.Damping.modal(0.005))
    times = STEP * np.arange(SAMPLES)
    end1, end2 = (coilsense.EndInput.sampled(times, inputs[:, column]) for column in range(2))
    motion = coilsense.Motion(spring, coilsense.Excitation(0.23, end1, end2, start=coilsense.Start.rest()), mount=mount)
    pitches = np.diff(np.asarray(motion.windings(times).positions), axis=1).min(axis=1)

    slave = Slave(file)
    second = "u2" if end == "held" else "F_2"
    found = [slave.get("F_L", "L", "F_L_bound", "L_bound", "closest_pitch")]
    assert found[0][0] == pytest.approx(95.76, rel=1e-9) and found[0][4] == pytest.approx(0.23 / 52, rel=1e-14)
    for k in range(SAMPLES - 1):
        rate = (inputs[k + 1] - inputs[k]) / STEP
        slave.set(**{"u1": inputs[k][0], second: inputs[k][1], "der_u1": rate[0], f"der_{second}": rate[1]})
        slave.step(k * STEP, STEP)
        found.append(slave.get("F_L", "L", "F_L_bound", "L_bound", "closest_pitch"))
    slave.close()
    read = np.array(found)
    # `simulate` takes L to second order where that is good to 1e-5 of it.
    assert (np.abs(read[:, 1] - expected[:, 1]) <= read[:, 3] + 1e-5 * expected[:, 1]).all()
    assert (np.abs(read[:, 0] - expected[:, 0]) <= read[:, 2] + 5e-3).all()
    assert (read[:, 2] < 0.5).all() and (read[:, 2] > 0).all()
    assert np.abs(read[:, 4] - pitches).max() < 1e-10 * np.abs(lengths - 0.23).max() + 1e-15
    assert np.ptp(pitches) > 1e-5


@pytest.mark.parametrize("version", ["2.0", "3.0"])
def test_the_description_has_their_units_and_what_is_not_known(tmp_path: pathlib.Path, version: str) -> None:
    mount = ENDS["held"] + DAMPINGS[1]
    slave = Slave(exported(tmp_path, mount, version, *ALSO))
    units = {one.name: one.unit for one in slave.description.modelVariables}
    assert [units[name] for name in ("F_L", "F_L_bound", "L", "L_bound", "closest_pitch")] == ["N", "N", "H", "H", "m"]
    # Beyond the lengths in use there is no bound; the forces are what they were.
    slave.set(u1=-0.06)
    slave.step(0.0, STEP)
    force, bound, inductance = slave.get("F_L", "F_L_bound", "L_bound")
    assert bound == inductance == sys.float_info.max and np.isfinite(force)
    slave.close()
    (tmp_path / "spec.toml").write_text((tmp_path / "spec.toml").read_text().replace("[mount]", 'material = "stainless 1.4310"\n[mount]'))
    told = fmpy.read_model_description(str(exported_again(tmp_path, version))).description
    assert "found with a relative permeability of 1 to 3" in told
    plain = Slave(exported(tmp_path, mount, version))
    assert not {"F_L", "closest_pitch"} & set(plain.numbers)
    plain.close()


def exported_again(folder: pathlib.Path, version: str) -> pathlib.Path:
    """The spec in the folder as it is."""
    command(folder, "export", "spec.toml", "--as", "fmu", "--fmi", version, "--out", "again.fmu", *ALSO)
    return folder / "again.fmu"
