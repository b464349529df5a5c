"""What a function takes is taken in every form in which users have it."""

import pathlib
import types

import pytest
import sweeps

import coilsense

DOORS = [coilsense.simulate, coilsense.simulate_together, coilsense.analyze, coilsense.mitigate]


@pytest.mark.parametrize("door", DOORS, ids=lambda door: door.__name__)
def test_a_spec_is_taken_as_a_noun_a_file_or_its_text(door: object, tmp_path: pathlib.Path) -> None:
    path = tmp_path / "spec.toml"
    path.write_text(sweeps.SPEC)
    assert callable(door)
    results = [door(given) for given in (coilsense.Spec.parse(sweeps.SPEC), path, str(path), sweeps.SPEC)]
    lengths = {len(result) if hasattr(result, "__len__") else len(result.cases) for result in results}
    assert len(lengths) == 1 and lengths.pop() > 0
    with pytest.raises(coilsense.SpecError, match="nowhere.toml"):
        door("nowhere.toml")
    with pytest.raises(TypeError, match="^spec must be a Spec, its file or its text, got int$"):
        door(3)


def test_one_name_is_as_good_as_a_list_of_one(tmp_path: pathlib.Path) -> None:
    over = {"spring.stiffness": "600..900 N/m", "spring.mass": "50..80 g"}
    one = coilsense.sweep(sweeps.SPEC, over, tmp_path / "one", sampling="saltelli", rows=32, columns="f1")
    listed = coilsense.sweep(sweeps.SPEC, over, tmp_path / "listed", sampling="saltelli", rows=32, columns=["f1"])
    assert one.plan == listed.plan
    assert coilsense.pareto(one, minimize="f1", where="f1 > 1 Hz").rows.tolist() == coilsense.pareto(one, minimize=["f1"]).rows.tolist()
    assert coilsense.sensitivity(one, "f1", resamples=20) == coilsense.sensitivity(one, ["f1"], resamples=20)


def test_channels_come_in_any_mapping() -> None:
    channels = types.MappingProxyType({"F_o": [1.0, 2.0]})
    assert coilsense.Signals([0.0, 0.1], channels) == coilsense.Signals([0.0, 0.1], dict(channels))
