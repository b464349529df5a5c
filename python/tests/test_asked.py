"""What is asked of a sweep afterwards, and the small nouns beside a spring: against their definitions."""

import json
import pathlib

import numpy
import pytest
import samples
import sweeps

import coilsense


@pytest.fixture(scope="module")
def designs(tmp_path_factory: pytest.TempPathFactory) -> coilsense.SweepDataset:
    """Some hundred designs, a tenth of them with a mass that cannot be."""
    over = {"spring.stiffness": "600..900 N/m", "spring.mass": "-8..80 g"}
    folder = tmp_path_factory.mktemp("designs") / "sweep"
    return coilsense.sweep(sweeps.SPEC, over, folder, rows=200, columns=["f1", "mass", "stress", "F_o.rmsd"], seed=3)


def test_the_front_is_what_no_design_beats(designs: coilsense.SweepDataset) -> None:
    found = coilsense.pareto(designs, minimize=["F_o.rmsd", "stress"], maximize=["f1"], where=["mass > 20 g"])
    columns = designs.read()
    fine = (numpy.array(columns["status"]) == "ok") & (columns["mass [kg]"] > 0.02)
    costs = numpy.stack([columns["F_o.rmsd [%]"], columns["stress [Pa]"], -columns["f1 [Hz]"]], axis=1)[fine]
    # By the definition: no other is as good everywhere and better somewhere.
    beaten = [((costs <= own).all(axis=1) & (costs < own).any(axis=1)).any() for own in costs]
    expected = columns["row"][fine][~numpy.array(beaten)]
    assert 3 < len(expected) < fine.sum()
    assert sorted(found.rows) == list(expected)
    assert found.objectives == ["F_o.rmsd [%]", "stress [Pa]", "f1 [Hz]"]
    assert found.values.shape == (len(found), 3)
    numpy.testing.assert_array_equal(found.values[:, 1], columns["stress [Pa]"][found.rows.astype(int)])
    numpy.testing.assert_array_equal(found.columns["f1 [Hz]"], found.values[:, 2])
    assert found.knee in found.rows
    assert found.extremes["f1 [Hz]"] == found.rows[found.values[:, 2].argmax()]
    assert found == coilsense.pareto(designs.folder, minimize=["F_o.rmsd", "stress"], maximize=["f1"], where=["mass > 20 g"])


def test_a_front_is_shown_and_saved_as_the_command_does(designs: coilsense.SweepDataset, tmp_path: pathlib.Path) -> None:
    found = coilsense.pareto(designs, minimize=["mass"], maximize=["f1"])
    assert found.answer[0] in str(found)
    assert f"{len(found)} of " in repr(found)
    assert found.save(tmp_path / "front", date="2026-11-22") == 6
    assert json.loads((tmp_path / "front/results.json").read_text()) == found.to_dict()
    frame = found.to_pandas()
    assert list(frame["row"]) == list(found.rows)
    assert found._repr_html_().count("<tr>") == 1 + min(len(found), 20)
    # The knee as a spec of its own is the design of that row.
    spring = coilsense.Spec.parse(designs.plan.spec_of(found.knee)).spring
    assert spring.mass == designs.read(["mass [kg]"])["mass [kg]"][found.knee]


def test_indices_of_a_product_are_those_of_its_closed_form(tmp_path: pathlib.Path) -> None:
    over = {"spring.stiffness": "400..1200 N/m", "spring.max_length": "250..290 mm", "mount.damping_ratio": "0.001..0.01"}
    folder = tmp_path / "sweep"
    columns = ["nominal_force", "coil_diameter"]
    designs = coilsense.sweep(sweeps.SPEC, over, folder, sampling="saltelli", rows=512, columns=columns)
    found = coilsense.sensitivity(designs, ["nominal_force"])
    # F_nom = k (l_max - l0) of independent uniform factors.
    k, k_variance = 800.0, 800.0**2 / 12
    travel, travel_variance = 0.270 - 0.104, 0.040**2 / 12
    whole = (k**2 + k_variance) * (travel**2 + travel_variance) - (k * travel) ** 2
    first = [k_variance * travel**2 / whole, travel_variance * k**2 / whole, 0]
    total = [k_variance * (travel**2 + travel_variance) / whole, travel_variance * (k**2 + k_variance) / whole, 0]
    assert found.variables == list(over)
    for place, key in enumerate(over):
        # 512 base rows of a scrambled Sobol sequence on a smooth function.
        assert found.first_order["nominal_force [N]"][key][0] == pytest.approx(first[place], abs=0.01)
        value, low, high = found.total["nominal_force [N]"][key]
        assert value == pytest.approx(total[place], abs=0.01)
        assert low <= value <= high
    assert found.answer[0].startswith("nominal_force hangs on spring.stiffness")
    assert found.save(tmp_path / "asked") == 2
    frame = found.to_pandas()
    assert frame["total"].tolist() == [found.total["nominal_force [N]"][key][0] for key in over]
    assert "S_T" in found._repr_html_() and "1 columns to 3 keys" in repr(found)
    everything = coilsense.sensitivity(folder, resamples=50, seed=1)
    assert list(everything.without) == ["coil_diameter [m]"]
    assert everything != found


def test_what_cannot_be_asked_is_a_sweep_error(designs: coilsense.SweepDataset, tmp_path: pathlib.Path) -> None:
    with pytest.raises(coilsense.SweepError, match='no column "mas"; did you mean mass'):
        coilsense.pareto(designs, minimize=["mas"])
    with pytest.raises(coilsense.SweepError, match="from 1 to 6 objectives, got 0"):
        coilsense.pareto(designs)
    with pytest.raises(coilsense.SweepError, match="holds no sweep"):
        coilsense.pareto(tmp_path / "nowhere", minimize=["mass"])
    with pytest.raises(coilsense.SweepError, match='sampling="saltelli", this one is lhs'):
        coilsense.sensitivity(designs)
    with pytest.raises(coilsense.SweepError, match="row 200: there are 200, counted from 0"):
        designs.plan.spec_of(200)
    with pytest.raises(TypeError):
        coilsense.pareto(3, minimize=["mass"])  # type: ignore[arg-type]


def test_two_encoders_read_a_static_load_through_their_drive_train() -> None:
    compliance, backlash, length = 1e-5, 2e-4, 0.204
    encoders = coilsense.TwoEncoder(samples.SPRING, compliance, backlash, length)
    force = samples.SPRING.static_force(length)
    elongation = encoders.elongation([0.0, 0.0], [length, length + 0.01], [force, force + 7.6])
    numpy.testing.assert_allclose(elongation - [length, length + 0.01], compliance * numpy.array([force, force + 7.6]) + backlash / 2)
    # Springs in series share their force, so that both loads read right.
    numpy.testing.assert_allclose(encoders.force(elongation), [force, force + 7.6], rtol=1e-12)
    assert encoders.stiffness == pytest.approx(1 / (1 / samples.SPRING.stiffness + compliance), rel=1e-15)
    with pytest.raises(coilsense.Error, match="backlash"):
        coilsense.TwoEncoder(samples.SPRING, compliance, -1e-4, length)
    with pytest.raises(coilsense.Error, match="u1, u2, f_i must have shapes that go together"):
        encoders.elongation([0.0, 0.0, 0.0], [0.1, 0.2], [1.0])


VALVE = """
[spring]
name = "valve spring"
rest_length = "57 mm"
min_length = "38 mm"
max_length = "48 mm"
windings = 5.75
wire_diameter = "4 mm"
coil_diameter = "25 mm"
end_type = "closed-ground"
[[condition]]
kind = "impact"
velocity = "0.1 m/s"
"""


def test_a_spec_has_the_modes_of_its_coil_and_its_own_mass() -> None:
    spec = coilsense.Spec.parse(VALVE)
    sheet = spec.data_sheet()
    assert [round(at["length_m"], 4) for at in sheet["modes_at"]] == [0.038, 0.043, 0.048]
    first = sheet["modes_at"][1]["modes"][0]
    assert first["kind"] == "axial" and abs(first["frequency_hz"] / 391.44 - 1) < 1e-4
    # The chain has the surge of the helix; the spring that Python has is what its numbers say.
    assert abs(sheet["surge_frequency_hz"] / 391.44 - 1) < 1e-4
    assert abs(spec.spring.mass / sheet["mass_kg"] - 1) < 1e-12 and abs(spec.spring.surge_frequency / 403.61 - 1) < 1e-4


def test_neighbours_of_the_surge_meet_their_limits() -> None:
    steel = coilsense.Material.named("steel EN 10270-1")
    coil = coilsense.Geometry.of_spring(samples.SPRING, "hooks", steel)
    mass, length = samples.SPRING.mass, 0.23
    # Twice the mass turns slower by the root of two.
    ratio = coilsense.torsional_frequency(coil, mass) / coilsense.torsional_frequency(coil, 2 * mass)
    assert ratio == pytest.approx(2**0.5, rel=1e-14)
    # Under much tension a coil swings as a string does, and at its buckling force not at all.
    pull = 95.76
    string = (pull / (mass * length)) ** 0.5 / 2
    assert 1.0 < coilsense.lateral_frequency(coil, mass, length, pull) / string < 1.05
    push = coilsense.buckling_force(coil, length)
    assert coilsense.lateral_frequency(coil, mass, length, -push * (1 - 1e-9)) < 1e-3 * string
    with pytest.raises(coilsense.Error, match="where the spring buckles"):
        coilsense.lateral_frequency(coil, mass, length, -1.01 * push)


def test_named_materials_are_those_of_a_spec() -> None:
    named = coilsense.materials()
    assert list(named)[0] == "steel EN 10270-1"
    assert all(coilsense.Material.named(name) == material for name, material in named.items())
    with pytest.raises(coilsense.Error, match="material must be one of steel EN 10270-1, .*got \"cheese\""):
        coilsense.Material.named("cheese")
