"""Writes python/coilsense/_coilsense.pyi: PyO3's account of the module, with the types that it cannot know.

PyO3 knows every name, argument, default and all types but three: an array is Incomplete, a dict has no types within, and an object that
Python code makes is Any. An array's type follows from where it stands and from the docstring; the others are said in the docstring's
sections Parameters and Returns, or below. Where neither says one, nothing is written.

Usage: python write.py ACCOUNT OUT; the account is what ``maturin generate-stubs`` writes in this folder. Next door: who calls both
(``cargo xtask stubs``), and who holds the outcome against the module (stubtest, in ``cargo xtask test --only Python``).
"""

import ast
import copy
import pathlib
import re
import sys

HEAD = '''"""Types of the compiled module, written by `cargo xtask stubs`; docstrings are the module's own."""

from collections.abc import Callable, Iterator, Mapping, Sequence
from os import PathLike
from pathlib import Path
from types import TracebackType
from typing import Any, Literal, Never, NoReturn, Self, TypeAlias, TypeVar, final, overload

import matplotlib.axes
import numpy
import pandas
import xarray
from numpy.typing import ArrayLike, NDArray

__version__: str

_Floats: TypeAlias = NDArray[numpy.float64]
_Complexes: TypeAlias = NDArray[numpy.complex128]
_Bools: TypeAlias = NDArray[numpy.bool_]
_Default = TypeVar("_Default")

class Error(ValueError): ...
class SpecError(Error): ...
class AnalysisError(Error): ...
class OutputError(Error): ...
class LogError(Error): ...
class SweepError(Error): ...
'''

# What a line may hold.
WIDTH = 120

# Types that neither Rust nor a docstring tells, by Class.name and, of an argument, Class.name.argument.
TOLD: dict[str, str] = {
    "Analysis.uncertainties": "dict[str, float]",
    "Calibration.theories": "list[dict[str, Any]]",
    "Cascade.__matmul__.other": "TwoPort | Cascade",
    "Cascade.__reduce__": "tuple[Any, tuple[list[tuple[str, dict[str, Any]]]]]",
    "Cascade.parts": "list[TwoPort | Cascade]",
    "Case.contact": "dict[str, Any] | None",
    "Case.deviations": "dict[str, Deviation]",
    "Case.forces": "dict[str, _Floats]",
    "Case.judged": "slice[int, int, int]",
    "Case.readings": "dict[str, _Floats]",
    "Estimate.to_dict": "dict[str, float]",
    "Experiment.biases": "list[dict[str, Any]]",
    "Experiment.drift": "list[dict[str, Any]]",
    "Experiment.peak": "dict[str, Any] | None",
    "Experiment.rows": "list[dict[str, Any]]",
    "Plant.outputs": "tuple[str, ...]",
    "Plant.to_frd": "tuple[_Complexes, _Floats]",
    "Identification.lines": "list[dict[str, Any]]",
    "Identification.channels": "list[dict[str, Any]]",
    "Identification.explanations": "list[dict[str, Any]]",
    "Identification.spectra": "dict[str, tuple[_Floats, _Floats]]",
    "Identification.trust": "dict[str, float] | None",
    "Live.__deepcopy__._memo": "object",
    "Live.__reduce__": "tuple[Any, tuple[Spring, float, float, Mount], _Floats]",
    "LiveBatch.__deepcopy__._memo": "object",
    "LiveBatch.__reduce__": "tuple[Any, tuple[list[Live]]]",
    "Mitigation.ranking": "list[dict[str, Any]]",
    "Pareto.columns": "dict[str, Any]",
    "Pareto.extremes": "dict[str, int]",
    "Pareto.rows": "NDArray[numpy.uint64]",
    "Placement.limits": "dict[str, tuple[float, float]]",
    "Placement.margins": "dict[str, list[dict[str, Any]]]",
    "Placement.over_time": "dict[str, dict[str, Any]]",
    "Placement.robust_from": "dict[str, float]",
    "Recording.rows": "dict[str, int]",
    "Remedy.settings": "dict[str, Any] | None",
    "Sensitivity.first_order": "dict[str, dict[str, tuple[float, float, float]]]",
    "Sensitivity.total": "dict[str, dict[str, tuple[float, float, float]]]",
    "Sensitivity.without": "dict[str, str]",
    "Signals.__array__": "NoReturn",
    "Signals.__array__.copy": "bool | None",
    "Signals.__array__.dtype": "object",
    "Signals.__getnewargs__": "tuple[_Floats, dict[str, _Floats]]",
    "Signals.__iter__": "Iterator[str]",
    "Signals.__new__.channels": "Mapping[str, ArrayLike] | None",
    "Signals.get": "_Floats | _Default | None",
    "Signals.get.default": "_Default | None",
    "Signals.from_dict.dict": "Mapping[str, ArrayLike]",
    "Signals.to_dict": "dict[str, list[float]]",
    "Spec.mounts": "dict[str, Mount]",
    "SpeedMap.harmonics": "dict[str, list[list[float]]]",
    "SpeedMap.runs": "dict[str, dict[str, _Floats]]",
    "SweepDataset.__exit__._kind": "type[BaseException] | None",
    "SweepDataset.__exit__._raised": "BaseException | None",
    "SweepDataset.__exit__._traceback": "TracebackType | None",
    "SweepPlan.rows_of": "range",
    "Together.signs": "dict[str, float]",
    "Together.springs": "dict[str, Case]",
    "TwoPort.__matmul__.other": "TwoPort | Cascade",
    "analyze.progress": "Callable[[int, int], object] | None",
    "calibrate.columns": "Mapping[str, str | int] | None",
    "calibrate.units": "Mapping[str, str] | None",
    "materials": "dict[str, Material]",
    "open_log.columns": "Mapping[str, str | int] | None",
    "open_log.units": "Mapping[str, str] | None",
    "open_log.gain": "Mapping[str, str] | None",
    "open_log.offset": "Mapping[str, str] | None",
    "open_log.constant": "Mapping[str, str] | None",
    "simd_path": 'Literal["scalar", "avx2", "avx512"]',
    "simulate.progress": "Callable[[int, int], object] | None",
    "simulate_together.progress": "Callable[[int, int], object] | None",
    "speed.progress": "Callable[[int, int], object] | None",
}

# What pickle and notebooks call has no docstring: its types by PyO3's words, or by its name.
WITHOUT_DOCSTRING = {
    "_repr_html_": "str",
    "__replace__": "Self",
    "tuple[tuple, dict]": "tuple[tuple[()], dict[str, Any]]",
    "tuple[Any, tuple[dict]]": "tuple[Any, tuple[dict[str, Any]]]",
    "tuple[Any, tuple]": "tuple[Any, tuple[Any, ...]]",
}

# What a number does to a noun: another of its kind.
WITH_A_NUMBER = ("__add__", "__radd__", "__sub__", "__rsub__", "__mul__", "__rmul__", "__truediv__", "__rtruediv__")

# What the docstrings call a type.
WORDS = {
    "dict": "dict[str, Any]",
    "mapping": "Mapping[str, Any]",
    "pandas.DataFrame": "pandas.DataFrame",
    "xarray.Dataset": "xarray.Dataset",
    "uncertainties.UFloat": "Any",
    "matplotlib.axes.Axes": "matplotlib.axes.Axes",
    "matplotlib.axes.Axes, optional": "matplotlib.axes.Axes | None",
    "Recording, Signals, pandas.DataFrame, mapping, str or os.PathLike": "Recording | Signals | pandas.DataFrame | Mapping[str, ArrayLike] | str | PathLike[str]",
    "Recording, Signals, pandas.DataFrame, mapping, str or os.PathLike, optional": (
        "Recording | Signals | pandas.DataFrame | Mapping[str, ArrayLike] | str | PathLike[str] | None"
    ),
    "Signals, pandas.DataFrame or mapping": "Signals | pandas.DataFrame | Mapping[str, ArrayLike]",
}

# What holds many of a kind.
ARRAYS = {"float": "_Floats", "complex": "_Complexes", "bool": "_Bools"}

# PyO3's words for what is taken, and ours.
TAKEN = (
    ("SupportsFloat | SupportsIndex", "float"),
    ("SupportsIndex", "int"),
    ("SupportsGetItem[int, ", "Sequence["),
    ("SupportsLenAndGetItem[", "Sequence["),
    # What is taken to be refused by its name.
    (" | Incomplete", ""),
    ("Incomplete", "ArrayLike"),
)


class Refined(ast.NodeTransformer):
    """The module's tree with types for what PyO3 has no type for, and without docstrings."""

    def __init__(self) -> None:
        self.place: list[str] = []
        self.of_class = ""
        self.used: set[str] = set()
        self.unknown: list[str] = []

    def visit_Module(self, node: ast.Module) -> ast.Module:
        kept = [self.visit(child) for child in node.body if isinstance(child, ast.ClassDef | ast.FunctionDef)]
        node.body = [each for child in kept for each in (child if isinstance(child, list) else [child]) if each.name != "__getattr__"]
        return node

    def visit_ClassDef(self, node: ast.ClassDef) -> ast.ClassDef:
        self.place.append(node.name)
        self.of_class = ast.get_docstring(node) or ""
        methods = [child for child in node.body if isinstance(child, ast.FunctionDef)]
        # Every object has these two.
        shown = [self.visit(child) for child in methods if child.name not in ("__repr__", "__str__")]
        node.body = [each for child in shown for each in (child if isinstance(child, list) else [child])]
        named(node)
        names = {method.name for method in methods}
        if "__eq__" in names:
            more = [] if "__ne__" in names else ["def __ne__(self, other: object, /) -> bool: ..."]
            node.body += [parsed(line) for line in [*more, "__hash__ = None"]]
        if "__matmul__" in names:
            # Python's slot serves both sides; the other one takes nothing that the first does not.
            node.body.append(parsed("def __rmatmul__(self, value: Never, /) -> Cascade: ..."))
        self.place.pop()
        return node

    def visit_FunctionDef(self, node: ast.FunctionDef) -> ast.FunctionDef | list[ast.FunctionDef]:
        described = ast.get_docstring(node) or ""
        head = next(iter(typed(described, "Returns")), "")
        if "of the shape of" not in head:
            return self.refined(node, described)
        # One number makes one, an array an array.
        kind = re.search(r"\b(?:float|complex|bool)\b", head)
        assert kind is not None and node.returns is not None
        both = []
        for taken, given in (("float | str", kind.group()), ("ArrayLike", ARRAYS[kind.group()])):
            one = copy.deepcopy(node)
            one.decorator_list.append(ast.Name("overload"))
            assert one.returns is not None
            text = re.sub(r"\bdict\b", "dict[str, Any]", ast.unparse(one.returns)).replace("Any", given)
            one.returns = ast.parse(text, mode="eval").body
            for argument in (*one.args.posonlyargs, *one.args.args, *one.args.kwonlyargs):
                if "array_like" in typed(described, "Parameters").get(argument.arg, ""):
                    argument.annotation = ast.parse(taken, mode="eval").body
            both.append(self.refined(one, described))
        # A number is an array, too, to NumPy.
        both[0].type_comment = "ignore[overload-overlap]"
        return both

    def refined(self, node: ast.FunctionDef, described: str) -> ast.FunctionDef:
        """One function with its types."""
        self.place.append(node.name)
        arguments = node.args
        if arguments.kwarg is not None:
            arguments.kwarg.annotation = ast.Name("Any")
        if node.name in WITH_A_NUMBER:
            # A number over a noun has no answer.
            made = "NoReturn" if node.name == "__rtruediv__" else self.place[-2]
            arguments.posonlyargs[-1].annotation, node.returns = ast.Name("float"), ast.Name(made)
        # What a constructor takes stands in the docstring of the class.
        told = self.of_class if node.name == "__new__" else described
        if [each.arg for each in arguments.posonlyargs] in (["self"], ["cls"]):
            # Behind these alone nobody needs to know that they have no name.
            arguments.args, arguments.posonlyargs = arguments.posonlyargs + arguments.args, []
        for argument in arguments.posonlyargs + arguments.args + arguments.kwonlyargs:
            if argument.annotation is not None:
                argument.annotation = self.taken(argument, told)
        if node.returns is not None:
            node.returns = self.given(node.returns, described)
        node.body = [ast.Expr(ast.Constant(...))]
        self.place.pop()
        return node

    def taken(self, argument: ast.arg, described: str) -> ast.expr:
        """The type of an argument."""
        assert argument.annotation is not None
        noun = re.match(r"[A-Z]\w+$", typed(described, "Parameters").get(argument.arg, "").removesuffix(", optional"))
        text = re.sub("^Incomplete", noun.group() if noun else "Incomplete", ast.unparse(argument.annotation))
        for theirs, ours in TAKEN:
            text = text.replace(theirs, ours)
        self.place.append(argument.arg)
        word = typed(described, "Parameters").get(argument.arg)
        if word and "str" not in word:
            # A number that has no unit.
            text = text.replace("float | str", "float")
        words = re.match(r"\{(.*)\}", word or "")
        if words:
            # One of some words.
            text = re.sub(r"\b(str|int)\b", f"Literal[{words.group(1)}]", text)
        found = self.known(text, "mapping" if word == "dict" else word)
        self.place.pop()
        return found

    def given(self, returns: ast.expr, described: str) -> ast.expr:
        """The type of what is returned."""
        array = "_Complexes" if "numpy.ndarray of complex" in described else "_Floats"
        text = ast.unparse(returns).replace("Incomplete", array)
        word = next(iter(typed(described, "Returns")), None)
        if not described:
            word = WITHOUT_DOCSTRING.get(self.place[-1], WITHOUT_DOCSTRING.get(text))
        return self.known(text, word)

    def known(self, text: str, word: str | None) -> ast.expr:
        """What is told here, else PyO3's type where it is whole, else what the docstring says."""
        name = ".".join(self.place)
        if name in TOLD:
            self.used.add(name)
            text = TOLD[name]
        elif re.search(r"\bAny\b|\b(dict|tuple|slice)\b(?!\[)", text):
            if word in WORDS:
                text = WORDS[word]
            elif word and word.startswith("numpy.ndarray"):
                text = "_Complexes" if "of complex" in word else "_Floats"
            elif word and (word in WITHOUT_DOCSTRING.values() or re.fullmatch(r"[A-Z]\w+", word)):
                text = word
            else:
                self.unknown.append(f"{name}: {text}, in its docstring {word!r}")
        return ast.parse(text, mode="eval").body


def typed(described: str, section: str) -> dict[str, str]:
    """The names of a section of a docstring with their types; of what is returned the types alone."""
    found = re.search(rf"^{section}\n-+\n((?:.*\n?)*?)(?=^\w.*\n-+\n|\Z)", described, re.MULTILINE)
    heads = [line for line in (found.group(1) if found else "").splitlines() if line and not line.startswith(" ")]
    pairs = (line.partition(" : ") for line in heads)
    if section == "Returns":
        return dict.fromkeys(heads, "")
    return {name: kind for names, _, kind in pairs for name in names.split(", ")}


def named(node: ast.ClassDef) -> None:
    """What ``replace`` takes: the arguments of the constructor by name, where there is one."""
    methods = {each.name: each for each in node.body if isinstance(each, ast.FunctionDef)}
    for each in ("replace", "__replace__"):
        if each in methods and "__new__" in methods:
            made, method = methods["__new__"].args, methods[each]
            method.args.kwonlyargs = [*made.posonlyargs, *made.args, *made.kwonlyargs][1:]
            method.args.kw_defaults, method.args.kwarg = [ast.Constant(...)] * len(method.args.kwonlyargs), None


def parsed(line: str) -> ast.stmt:
    """One statement."""
    return ast.parse(line).body[0]


def lines(node: ast.stmt, indent: str = "") -> list[str]:
    """A statement of a stub, an argument to a line where one line is too narrow."""
    if isinstance(node, ast.ClassDef):
        heads = [f"@{ast.unparse(decorator)}" for decorator in node.decorator_list] + [f"class {node.name}:"]
        return ["", *heads, *(line for child in node.body for line in lines(child, "    "))]
    if not isinstance(node, ast.FunctionDef):
        return [f"{indent}{ast.unparse(node)}  # type: ignore[assignment]"]
    heads = [f"{indent}@{ast.unparse(decorator)}" for decorator in node.decorator_list]
    returns = f" -> {ast.unparse(node.returns)}" if node.returns else ""
    taken = split(ast.unparse(node.args))
    remark = f"  # type: {node.type_comment}" if node.type_comment else ""
    line = f"{indent}def {node.name}({', '.join(taken)}){returns}: ...{remark}"
    if len(line) <= WIDTH:
        return [*heads, line]
    return [*heads, f"{indent}def {node.name}({remark}", *(f"{indent}    {each}," for each in taken), f"{indent}){returns}: ..."]


def split(arguments: str) -> list[str]:
    """The arguments one by one, as one writes them."""
    parts = [""]
    for mark in arguments:
        depth = sum(map(parts[-1].count, "[(")) - sum(map(parts[-1].count, "])"))
        if mark == "," and depth == 0:
            parts.append("")
        else:
            parts[-1] += mark
    spaced = (re.sub(r"^(\w+: .*?)=", r"\1 = ", part.strip()) for part in parts)
    return [part.replace("'", '"') for part in spaced if part]


def main(account: str, out: str) -> None:
    """Writes the file, or says which types are not known."""
    refined = Refined()
    tree = refined.visit(ast.parse(pathlib.Path(account).read_text()))
    stale = [f"{name}: told in vain" for name in sorted(TOLD.keys() - refined.used)]
    if refined.unknown or stale:
        sys.exit("\n".join(["TOLD in python/stubs/write.py has to say these types:", *refined.unknown, *stale]))
    body = [line for node in tree.body for line in lines(node)]
    pathlib.Path(out).write_text(HEAD + "\n".join(body) + "\n")


if __name__ == "__main__":
    main(*sys.argv[1:])
