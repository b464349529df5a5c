"""Every public function, asked with what is nothing of its arguments' kind: one plain sentence that names the argument."""

import ast
import functools
import inspect
import pathlib
import re
import tempfile
import typing

import pytest
import samples
import sweeps

import coilsense

VALVE = (pathlib.Path(__file__).parents[2] / "examples" / "valve-train.toml").read_text()
STUB = pathlib.Path(coilsense.__file__).with_name("_coilsense.pyi")

#: Words that mean something to who writes Rust.
RUST = re.compile(r"\b(enum|PyAny|Py[A-Z]\w+|extract\w*|variant|[iu]size|[fiu](32|64)|Vec|Option|String|struct|unwrap|Ok|Err|Bound|downcast)\b|::|&str|<class")

#: What nobody can mean, but where an argument takes everything.
WRONG: list[object] = [None, [], {}, object()]

#: Arguments that are good, so that only one of a call is bad.
GOOD: dict[str, typing.Any] = {
    "spring": samples.SPRING, "spec": sweeps.SPEC, "geometry": coilsense.Geometry.of_spring(samples.SPRING, "hooks", coilsense.Material.named("steel EN 10270-1")),
    "material": coilsense.Material.named("steel EN 10270-1"), "coil": coilsense.MaxwellSum(samples.SPRING), "excitation": samples.IMPACT,
    "motion": coilsense.Motion(samples.SPRING, samples.IMPACT), "far_end": coilsense.FarEnd.mass(0.5), "input": coilsense.EndInput.held(),
    "windings": 52, "model": "chain", "end": 1, "name": "S_T", "times": [0.0, 0.1, 0.2], "values": [0.0, 0.0, 0.0], "force": [1.0], "reference": [1.0],
    "signals": coilsense.Signals([0.0, 0.1], {"F_o": [1.0, 2.0]}), "positions": [[0.1]], "ends": [[0.0, 0.2]], "mean_length": 0.2, "count": 3, "mode": 1, "modes": 3,
    "end_type": "hooks", "rest_length": 0.104, "min_length": 0.196, "max_length": 0.264, "coil_radius": 0.008, "wire_radius": 0.001, "mass": 0.065,
    "stiffness": 760.0, "wire_diameter": 0.002, "coil_diameter": 0.016, "active_windings": 52.0, "length": 0.23, "dict": {"kind": "held"}, "text": sweeps.SPEC,
    "shear_modulus": 81.5e9, "youngs_modulus": 206e9, "density": 7850.0, "radius": 0.01, "distances": [0.01], "points": ([0.2, 0.25], [3e-6, 2.5e-6]),
    "frequencies": [1.0], "frequency": 1.0, "sample_rate": 100.0, "components": [(1.0, 1.0, 0.0)], "ratios": [0.1], "velocities": [0.0], "channels": {},
    "step": 0.001, "over": [], "date": "2026-11-21", "record": coilsense.Signals([0.0, 0.1], {"F_o": [1.0, 2.0]}), "winding": 1, "nominal": 1.0, "form": "c", "precision": "single",
    "seed": 1, "columns": [], "time": 0.1, "first_frequency": 1.0, "last_frequency": 2.0, "duration": 1.0, "data": b"", "index": 0, "row": 0,
    "path": "log.csv", "folder": "nowhere", "sweep": "nowhere", "out": "nowhere", "other": coilsense.Recording(coilsense.Signals([0.0, 0.1], {"F_o": [1.0, 2.0]})),
}

#: Where an argument of the same name is something else.
GOOD_HERE: dict[str, dict[str, typing.Any]] = {
    "Material.named": {"name": "steel EN 10270-1"}, "Signals.inserted": {"name": "F_o", "values": [1.0, 2.0]}, "Start.windings": {"positions": [0.1]},
    "LiveBatch.advance": {"u1": [0.0], "end2": [0.23]}, "LiveBatch.rollout": {"u1": [[0.0]], "end2": [[0.23]]},
    "SweepDataset.plot": {"over": "spring.stiffness [N/m]", "of": "f1 [Hz]"},
    "calibrate.preset": {"points": "log.csv"}, "mitigate.calibration": {"record": coilsense.Signals([0.0, 0.1], {"F_o": [1.0, 2.0]})}, "speed": {"spec": VALVE},
}

#: What a method is asked of, where its class is not among the values that other tests share.
MADE: dict[str, typing.Callable[[], object]] = {
    "Calibration": lambda: coilsense.calibrate(([0.2, 0.23, 0.26], [3e-6, 2.6e-6, 2.3e-6])),
    "ChainModes": lambda: coilsense.ChainModes(samples.SPRING),
    "Identification": lambda: coilsense.identify(samples.hit_log(seconds=6)),
    "Live": lambda: coilsense.Live(samples.SPRING, 0.23, 1e-3),
    "LiveBatch": lambda: coilsense.Live(samples.SPRING, 0.23, 1e-3).batch(1),
    "Plant": lambda: coilsense.plant(sweeps.SPEC, damping_ratio=0.005),
    "Recording": lambda: coilsense.Recording(GOOD["signals"]),
    "SecondOrder": lambda: coilsense.SecondOrder(GOOD["coil"], 0.23),
    "Spectrum": lambda: coilsense.Spectrum([0.0, 0.1, 0.2], [0.0, 1.0, 0.0]),
    "StoredCalibration": lambda: _stored(),
    "SweepDataset": lambda: coilsense.SweepDataset(tempfile.mkdtemp(), typing.cast(coilsense.SweepPlan, MADE["SweepPlan"]())),
    "Stream": lambda: GOOD["motion"].stream(1e-3),
    "SweepPlan": lambda: coilsense.SweepPlan(sweeps.SPEC, ["spring.stiffness=600..900 N/m : 4"], columns=["f1"]),
}

#: Long to make; what they share with others is asked of those.
LEFT_OUT = {"Analysis", "Case", "Condition", "Experiment", "Mitigation", "Pareto", "Placement", "Remedy", "Sensitivity", "SpeedMap", "Together"}


def _stored() -> coilsense.StoredCalibration:
    file = pathlib.Path(tempfile.mkdtemp()) / "calibration.toml"
    file.write_text(coilsense.calibrate(([0.2, 0.23, 0.26], [3e-6, 2.6e-6, 2.3e-6])).stored("2026-11-21"))
    return coilsense.open_calibration(file)


def _functions() -> dict[str, ast.FunctionDef]:
    """Public functions, methods and constructors of the stub; of overloads the one that takes most."""
    found = {}
    for node in ast.parse(STUB.read_text()).body:
        if isinstance(node, ast.FunctionDef):
            found[node.name] = node
        if isinstance(node, ast.ClassDef) and node.name not in LEFT_OUT:
            methods = [each for each in node.body if isinstance(each, ast.FunctionDef) and "setter" not in ast.unparse(each).splitlines()[0]]
            found |= {f"{node.name}.{each.name}": each for each in methods if not each.name.startswith("_") or each.name == "__new__"}
    return found


FUNCTIONS = _functions()


def _taken(node: ast.FunctionDef) -> list[str]:
    every = [*node.args.posonlyargs, *node.args.args, *node.args.kwonlyargs]
    return [each.arg for each in every if each.arg not in ("self", "cls")]


CALLS = [(name, argument) for name, node in FUNCTIONS.items() for argument in _taken(node)]


@functools.cache
def _noun(name: str) -> object:
    shared = {type(value).__name__: value for value in samples.values()}
    return MADE[name]() if name in MADE else shared[name]


def _called(name: str) -> typing.Callable[..., object]:
    owner, _, method = name.rpartition(".")
    if not owner:
        return typing.cast("typing.Callable[..., object]", getattr(coilsense, name))
    if method == "__new__":
        return typing.cast("typing.Callable[..., object]", getattr(coilsense, owner))
    static = any(ast.unparse(mark) in ("staticmethod", "classmethod") for mark in FUNCTIONS[name].decorator_list)
    return typing.cast("typing.Callable[..., object]", getattr(getattr(coilsense, owner) if static else _noun(owner), method))


def _optional(node: ast.FunctionDef) -> set[str]:
    """Arguments that may be None."""
    every = [*node.args.posonlyargs, *node.args.args, *node.args.kwonlyargs]
    return {each.arg for each in every if each.annotation is not None and ast.unparse(each.annotation).endswith("| None")}


def _required(node: ast.FunctionDef) -> list[str]:
    places = [*node.args.posonlyargs, *node.args.args]
    first = len(places) - len(node.args.defaults)
    needed = [each.arg for each in places[:first]]
    needed += [each.arg for each, default in zip(node.args.kwonlyargs, node.args.kw_defaults) if default is None]
    return [each for each in needed if each not in ("self", "cls")]


@pytest.mark.parametrize(("name", "argument"), CALLS)
def test_what_an_argument_cannot_be_is_said_in_one_plain_sentence(name: str, argument: str, tmp_path: pathlib.Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    for wrong in WRONG[argument in _optional(FUNCTIONS[name]) :]:
        given = {each: GOOD.get(each, 0.1) for each in _required(FUNCTIONS[name])}
        given |= GOOD_HERE.get(name, {}) | GOOD_HERE.get(f"{name}.{argument}", {}) | {argument: wrong}
        try:
            _called(name)(**given)
        except (TypeError, coilsense.Error) as error:
            sentence = str(error)
            noted = " ".join([sentence, *getattr(error, "__notes__", [])])
            assert not RUST.search(sentence), sentence
            assert "\n" not in sentence, sentence
            if type(wrong) is object:
                assert isinstance(error, TypeError), repr(error)
                assert re.search(rf"\b{argument.rstrip('_')}", noted), noted
        else:
            assert type(wrong) is not object or f"{name}.{argument}" == "Signals.get.default", f"{name}({argument}={wrong!r}) was taken"


@pytest.mark.parametrize(("name", "argument"), [("Readout.__new__", "order"), ("Motion.truncated", "modes"), ("SweepPlan.chunk", "index"), ("identify", "windings")])
@pytest.mark.parametrize("wrong", [-1, -(10**30)])
def test_a_number_below_zero_is_no_number_of_things(name: str, argument: str, wrong: int) -> None:
    given = {each: GOOD[each] for each in _required(FUNCTIONS[name])} | {argument: wrong}
    with pytest.raises(coilsense.Error, match=rf"{argument} must be .*got -1"):
        _called(name)(**given)


def _words(node: ast.FunctionDef) -> dict[str, list[str]]:
    """The words that an argument takes, as its type has them."""
    every = [*node.args.posonlyargs, *node.args.args, *node.args.kwonlyargs]
    found = {}
    for each in every:
        for part in ast.walk(each.annotation) if each.annotation is not None else ():
            if isinstance(part, ast.Subscript) and ast.unparse(part.value) == "Literal":
                words = part.slice.elts if isinstance(part.slice, ast.Tuple) else [part.slice]
                found[each.arg] = [word.value for word in words if isinstance(word, ast.Constant) and isinstance(word.value, str)]
    return {argument: words for argument, words in found.items() if words}


WORDS = [(name, argument) for name, node in FUNCTIONS.items() for argument in _words(node) if not name.endswith(("replace", "__replace__"))]


@pytest.mark.parametrize(("name", "argument"), WORDS)
def test_the_type_of_a_word_is_what_the_function_takes(name: str, argument: str, tmp_path: pathlib.Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    given = {each: GOOD.get(each, 0.1) for each in _required(FUNCTIONS[name])} | GOOD_HERE.get(name, {})
    given |= GOOD_HERE.get(f"{name}.{argument}", {}) | {argument: "nonsense"}
    with pytest.raises(coilsense.Error) as caught:
        _called(name)(**given)
    said = re.search(r"must be (?:one of )?(.*?), got", str(caught.value)) or re.search(r"there are:? (.*)", str(caught.value))
    assert said is not None, caught.value
    assert sorted(re.split(r", | or ", said.group(1).replace('"', ""))) == sorted(_words(FUNCTIONS[name])[argument])


def test_sweep_takes_the_words_of_its_plan() -> None:
    told = re.search(r"Literal\[(.*?)\]", str(inspect.signature(coilsense.sweep).parameters["sampling"].annotation))
    assert told is not None
    assert ast.literal_eval(f"[{told.group(1)}]") == _words(FUNCTIONS["SweepPlan.__new__"])["sampling"]
