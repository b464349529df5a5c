"""Signals are a mapping of read-only arrays, and become data frames, datasets and plots."""

import collections.abc
import sys
import types
import typing

import numpy
import pytest
from samples import IMPACT, SPRING, hit_log

import coilsense

SIGNALS = coilsense.Motion(SPRING, IMPACT).signals([0.0, 0.1, 0.2])


def test_they_are_a_mapping() -> None:
    assert list(SIGNALS) == SIGNALS.keys() == ["u1", "u2", "F_i", "F_o", "F_x"]
    assert "F_o" in SIGNALS and "F_L" not in SIGNALS and "nonsense" not in SIGNALS
    assert dict(SIGNALS.items()).keys() == set(SIGNALS)
    assert SIGNALS.get("F_L") is None and SIGNALS.get("F_L", 3) == 3
    with pytest.raises(KeyError, match="signal F_L is missing"):
        SIGNALS["F_L"]
    with pytest.raises(KeyError, match="channel must be one of u1, u2, F_i, F_o, F_x, F_L, L, R, got .*F_y"):
        SIGNALS["F_y"]


def test_a_channel_is_not_copied_and_cannot_be_spoilt() -> None:
    assert SIGNALS["F_o"] is SIGNALS["F_o"]
    with pytest.raises(ValueError, match="read-only"):
        SIGNALS["F_o"][0] = 1.0
    with pytest.raises(ValueError, match="read-only"):
        SIGNALS.time[0] = 1.0


def test_a_channel_is_added_to_new_signals() -> None:
    more = SIGNALS.inserted("F_L", [1, 2, 3])
    assert "F_L" in more and "F_L" not in SIGNALS
    with pytest.raises(coilsense.Error, match="^F_L must hold 3 values, got 1$"):
        SIGNALS.inserted("F_L", [1.0])
    with pytest.raises(coilsense.Error, match=r"^F_L\[1\] must be finite, got NaN N$"):
        SIGNALS.inserted("F_L", [1.0, numpy.nan, 2.0])


def test_they_become_a_data_frame() -> None:
    frame = SIGNALS.to_pandas()
    assert list(frame.columns) == list(SIGNALS)
    assert frame.attrs["units"]["F_o"] == "N"
    numpy.testing.assert_array_equal(frame["F_o"], SIGNALS["F_o"])
    numpy.testing.assert_array_equal(frame.index, SIGNALS.time)


def test_they_become_a_dataset() -> None:
    dataset = SIGNALS.to_xarray()
    assert dataset["F_o"].attrs["units"] == "N" and dataset["time"].attrs["units"] == "s"
    numpy.testing.assert_array_equal(dataset["F_o"].sel(time=0.1), SIGNALS["F_o"][1])


def test_they_are_drawn() -> None:
    axes = SIGNALS.plot()
    assert [line.get_label() for line in axes.lines] == ["F_i", "F_o", "F_x"]
    numpy.testing.assert_array_equal(axes.lines[0].get_ydata(), SIGNALS["F_i"])
    assert SIGNALS.plot(["u1"], axes) is axes
    with pytest.raises(coilsense.Error, match="one unit"):
        SIGNALS.plot(["u1", "F_o"])


@pytest.mark.parametrize(
    ("library", "method", "extra"),
    [("pandas", "to_pandas", "pandas"), ("xarray", "to_xarray", "xarray"), ("matplotlib.pyplot", "plot", "plot")],
)
def test_a_library_that_is_not_there_is_named_with_its_extra(
    monkeypatch: pytest.MonkeyPatch, library: str, method: str, extra: str
) -> None:
    monkeypatch.setitem(sys.modules, library, None)
    with pytest.raises(ImportError, match=rf"pip install 'coilsense\[{extra}\]'"):
        getattr(SIGNALS, method)()


def test_mappings_and_data_frames_are_signals_wherever_those_are_taken() -> None:
    pandas = pytest.importorskip("pandas")
    assert isinstance(SIGNALS, collections.abc.Mapping)
    assert coilsense.Signals.from_pandas(SIGNALS.to_pandas()) == SIGNALS
    assert coilsense.Signals.from_dict(SIGNALS.to_dict()) == SIGNALS
    table = pandas.DataFrame({"time": SIGNALS.time, **SIGNALS})
    counted = pandas.DataFrame(dict(SIGNALS), index=pandas.to_timedelta(SIGNALS.time, unit="s"))
    assert coilsense.Signals.from_pandas(table) == SIGNALS
    numpy.testing.assert_allclose(coilsense.Signals.from_pandas(counted).time, SIGNALS.time, atol=1e-9)
    wanted = coilsense.Recording(SIGNALS)
    for told in (SIGNALS.to_pandas(), table, SIGNALS.to_dict(), types.MappingProxyType(SIGNALS.to_dict())):
        assert coilsense.Recording(told) == wanted
    hit = hit_log(seconds=6)
    assert coilsense.identify(hit.to_pandas()).verdict == coilsense.identify(hit).verdict == coilsense.identify(hit.to_dict()).verdict


def test_a_table_that_could_be_misread_is_refused() -> None:
    pandas = pytest.importorskip("pandas")
    frame = SIGNALS.to_pandas()
    with pytest.raises(coilsense.Error, match=r"signals need times: a column time \[s\], or an index that is named so"):
        coilsense.Signals.from_pandas(frame.reset_index(drop=True))
    with pytest.raises(coilsense.Error, match="channel must be one of .*, got \"temperature\""):
        coilsense.identify(frame.assign(temperature=20.0))
    frame.attrs["units"] = {"u1": "mm"}
    with pytest.raises(coilsense.Error, match=r"u1 must be in m, attrs\['units'\] says mm"):
        coilsense.Signals.from_pandas(frame)
    with pytest.raises(coilsense.Error, match=r"F_o\[1\] must be finite, got NaN N"):
        coilsense.Signals.from_pandas(pandas.DataFrame({"time": [0.0, 0.1], "F_o": [1.0, None]}))
    with pytest.raises(coilsense.Error, match="signals need time beside their channels, got F_o"):
        coilsense.Recording({"F_o": [1.0]})
    nothing: list[typing.Any] = [3, [1.0, 2.0], pandas.Series([1.0])]
    for wrong in nothing:
        with pytest.raises(TypeError, match="must be Signals, a data frame, or a mapping with time and channels, got"):
            coilsense.Recording(wrong)
    # Of a mapping NumPy makes the names; so would pandas by it.
    for makes in (numpy.asarray, pandas.DataFrame):
        with pytest.raises(TypeError, match="Signals are a mapping of arrays: take one as"):
            makes(SIGNALS)
