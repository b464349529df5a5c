"""What every public name must have: a docstring that runs, and for a value equality, repr, a dict and pickle."""

import copy
import doctest
import inspect
import pickle
from collections.abc import Iterator

import pytest
import samples

import coilsense


def _public() -> Iterator[tuple[str, object]]:
    """Every public name of the module, and of its classes."""
    yield "coilsense", coilsense
    for name in coilsense.__all__:
        noun = getattr(coilsense, name)
        yield name, noun
        if inspect.isclass(noun):
            for member in sorted(vars(noun)):
                if not member.startswith("_"):
                    yield f"{name}.{member}", getattr(noun, member)


def _called(value: object) -> str:
    return f"{type(value).__name__}.{getattr(value, 'kind', '')}"


def _documented() -> list[tuple[str, object]]:
    return [(name, noun) for name, noun in _public() if name != "__version__"]


@pytest.mark.parametrize(("name", "noun"), _documented(), ids=lambda part: part if isinstance(part, str) else "")
def test_every_public_name_has_a_docstring(name: str, noun: object) -> None:
    text = inspect.getdoc(noun)
    assert text, f"{name} has none"
    # A capital or a symbol at the beginning, and sections underlined as NumPy's are.
    for section in ("Parameters", "Returns", "Raises", "Notes", "Examples"):
        assert f"{section}:" not in text.splitlines(), f"{name}: {section} is not underlined"


def test_methods_say_what_they_take_and_give() -> None:
    for name, noun in _documented():
        if not callable(noun) or inspect.isclass(noun):
            continue
        text, parameters = inspect.getdoc(noun) or "", inspect.signature(noun).parameters
        taken = [each for each in parameters if each not in ("self", "cls", "class")]
        for each in taken:
            assert each in text, f"{name} does not say what {each} is"
        if not name.endswith(("plot",)):
            assert "Returns\n-------" in text, f"{name} does not say what it gives"


def test_examples_of_the_docstrings_run_and_most_docstrings_have_one() -> None:
    runner = doctest.DocTestRunner(optionflags=doctest.NORMALIZE_WHITESPACE)
    parser, tried, could = doctest.DocTestParser(), 0, 0
    for name, noun in _documented():
        test = parser.get_doctest(inspect.getdoc(noun) or "", {}, name, None, None)
        if test.examples:
            runner.run(test)
            tried += 1
        # Attributes are said in a line, and nobody makes an exception.
        could += callable(noun) and not (inspect.isclass(noun) and issubclass(noun, Exception))
    assert runner.summarize(verbose=False).failed == 0
    assert tried >= 0.5 * could, f"{tried} of {could} classes, functions and methods have an example"


@pytest.mark.parametrize("value", samples.values(), ids=_called)
def test_a_value_survives_pickling_and_copying(value: object) -> None:
    for protocol in range(2, pickle.HIGHEST_PROTOCOL + 1):
        assert pickle.loads(pickle.dumps(value, protocol)) == value
    assert copy.copy(value) == value
    assert copy.deepcopy(value) == value


@pytest.mark.parametrize("value", samples.values(), ids=_called)
def test_a_value_differs_from_every_other(value: object) -> None:
    assert sum(other == value for other in samples.values()) == 1
    assert value != object()


@pytest.mark.parametrize("value", samples.values(), ids=_called)
def test_a_value_is_printed_by_its_name_and_turned_into_a_dict(value: object) -> None:
    assert type(value).__name__ in repr(value)
    if not repr(value).startswith("<") and "array" not in repr(value):
        assert eval(repr(value), vars(coilsense)) == value  # what is printed is what makes it
    kept = value.to_dict()  # type: ignore[attr-defined]
    assert kept
    _only_plain(kept)


def _only_plain(part: object) -> None:
    """A dict that JSON could hold."""
    if isinstance(part, dict):
        for key, each in part.items():
            assert isinstance(key, str)
            _only_plain(each)
    elif isinstance(part, (list, tuple)):
        for each in part:
            _only_plain(each)
    else:
        assert part is None or type(part) in (bool, int, float, str), repr(part)


def test_kinds_come_back_from_their_dicts() -> None:
    for value in samples.values():
        if hasattr(type(value), "from_dict"):
            assert type(value).from_dict(value.to_dict()) == value  # type: ignore[attr-defined]


def test_exceptions_are_value_errors_that_pickle() -> None:
    for name in coilsense.__all__:
        noun = getattr(coilsense, name)
        if inspect.isclass(noun) and issubclass(noun, Exception):
            assert issubclass(noun, coilsense.Error)
            assert issubclass(noun, ValueError)
            assert pickle.loads(pickle.dumps(noun("a text"))).args == ("a text",)


def test_what_only_a_spec_tells_of_a_spring_is_kept() -> None:
    text = coilsense.Spec.template("S_T").replace("masses_per_winding = 1", "masses_per_winding = 4")
    fine = coilsense.Spec.parse(text).spring
    assert fine.chain_masses == 208
    wound = coilsense.Spec.read("examples/progressive-spring.toml").spring
    for spring in (fine, wound):
        for again in (pickle.loads(pickle.dumps(spring)), copy.copy(spring), copy.deepcopy(spring)):
            assert again == spring and again.chain_masses == spring.chain_masses
    assert fine.replace(mass=0.06).chain_masses == 208
    with pytest.raises(coilsense.Error, match=r"made of these: change them there"):
        wound.replace(mass=0.06)
