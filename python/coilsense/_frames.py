"""Signals as what other libraries hold: data frames, datasets, plots. Each library is imported where it is asked for."""

from __future__ import annotations

import importlib
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    import matplotlib.axes
    import pandas
    import xarray

    from coilsense import Signals


def imported(name: str, extra: str) -> Any:
    """The module ``name``, or an error that says which extra of coilsense brings it."""
    try:
        return importlib.import_module(name)
    except ImportError as error:
        library = name.partition(".")[0]
        raise ImportError(f"{library} is needed for this; install it with: pip install 'coilsense[{extra}]'") from error


def checked_axes(ax: matplotlib.axes.Axes) -> matplotlib.axes.Axes:
    """The same axes, or an error that says what else was given."""
    if not hasattr(ax, "plot"):
        raise TypeError(f"ax must be the Axes of a figure of matplotlib, got {type(ax).__name__}")
    return ax


def to_pandas(signals: Signals) -> pandas.DataFrame:
    """One column per channel over an index of time."""
    library = imported("pandas", "pandas")
    index = library.Index(signals.time, name="time [s]")
    frame: pandas.DataFrame = library.DataFrame(dict(signals.items()), index=index)
    frame.attrs["units"] = {name: signals.unit(name) for name in signals}
    return frame


def of_mapping(told: Mapping[str, Any]) -> Signals:
    """Signals of times and channels by name."""
    from coilsense import Error, Signals

    if "time" not in told:
        raise Error(f"signals need time beside their channels, got {', '.join(map(str, told)) or 'nothing'}")
    return Signals(told["time"], {name: values for name, values in told.items() if name != "time"})


def of_pandas(frame: pandas.DataFrame) -> Signals:
    """Signals of a data frame whose columns are channels."""
    from coilsense import Error, Signals

    if not _is_frame(frame):
        raise TypeError(f"frame must be a pandas.DataFrame, got {type(frame).__name__}")
    for name, unit in frame.attrs.get("units", {}).items():
        if name in frame.columns and unit != Signals.unit(name):
            raise Error(f"{name} must be in {Signals.unit(name)}, attrs['units'] says {unit}")
    channels = {name: frame[name].to_numpy() for name in frame.columns if name != "time"}
    if "time" in frame.columns:
        return Signals(frame["time"].to_numpy(), channels)
    index = frame.index
    if index.dtype.kind == "m":
        return Signals(index.total_seconds().to_numpy(), channels)  # type: ignore[attr-defined]
    if index.name in ("time [s]", "time"):
        return Signals(index.to_numpy(), channels)
    raise Error("signals need times: a column time [s], or an index that is named so; this frame has neither")


def _is_frame(told: object) -> bool:
    """Whether it is a data frame, without importing pandas for it."""
    return type(told).__module__.partition(".")[0] == "pandas" and hasattr(told, "columns")


def signals_of(told: Any) -> Signals | None:
    """Signals of a data frame or a mapping; None for anything else."""
    if _is_frame(told):
        return of_pandas(told)
    return of_mapping(told) if isinstance(told, Mapping) else None


def to_xarray(signals: Signals) -> xarray.Dataset:
    """One variable per channel over the coordinate time, each with its unit."""
    library = imported("xarray", "xarray")
    variables = {name: ("time", values, {"units": signals.unit(name)}) for name, values in signals.items()}
    time = ("time", signals.time, {"units": "s"})
    dataset: xarray.Dataset = library.Dataset(variables, coords={"time": time})
    return dataset


def plot(signals: Signals, channels: list[str] | None, ax: matplotlib.axes.Axes | None) -> matplotlib.axes.Axes:
    """The channels over time in one panel; without a choice, the forces."""
    names = [name for name in signals if signals.unit(name) == "N"] if channels is None else channels
    if not names:
        raise _no_channels(signals)
    units = {signals.unit(name) for name in names}
    if len(units) > 1:
        raise _unlike_units(names, units)
    axes = imported("matplotlib.pyplot", "plot").subplots(layout="constrained")[1] if ax is None else checked_axes(ax)
    for name in names:
        axes.plot(signals.time, signals[name], label=name, linewidth=1)
    axes.set_xlabel("t [s]")
    axes.set_ylabel(f"{', '.join(names)} [{units.pop()}]")
    axes.legend()
    axes.grid(alpha=0.3)
    return axes


def _no_channels(signals: Signals) -> Exception:
    from coilsense import Error

    return Error(f"channels must hold at least one of {', '.join(signals)}")


def _unlike_units(names: list[str], units: set[str]) -> Exception:
    from coilsense import Error

    return Error(f"channels must have one unit in one plot, got {', '.join(names)} in {', '.join(sorted(units))}")


def frame(columns: dict[str, Any]) -> pandas.DataFrame:
    """Columns by title as a data frame."""
    made: pandas.DataFrame = imported("pandas", "pandas").DataFrame(columns)
    return made
