"""Signals are a mapping of read-only arrays, and become data frames, datasets and plots."""

import sys

import numpy
import pytest
from samples import IMPACT, SPRING

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
