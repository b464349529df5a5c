"""Tables and figures of nouns and outcomes that the studies' own modules do not hold. Next door: those of studies (`_studies`) and logs (`_logs`)."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy

from coilsense._frames import frame, to_pandas
from coilsense._frames import plot as signals_plot
from coilsense._layout import BLUE, GREY, RED, new_axes

if TYPE_CHECKING:
    import matplotlib.axes
    import pandas

    from coilsense import (
        Analysis,
        Case,
        ChainModes,
        Pareto,
        Placement,
        Plant,
        Sensitivity,
        Spectrum,
        SpeedMap,
        SweepDataset,
        Together,
        TwoPort,
        Windings,
    )

# analysis


def deviations_frame(analysis: Analysis) -> pandas.DataFrame:
    """One row per case and force: its condition and damping, and the deviation from the true force."""
    rows = [
        {"condition": case.condition, "damping": case.damping, "force": name, **deviation.to_dict()}
        for case in analysis.cases
        for name, deviation in case.deviations.items()
    ]
    return frame({key: [row[key] for row in rows] for key in rows[0]} if rows else {})


def analysis_plot(analysis: Analysis, ax: matplotlib.axes.Axes | None) -> matplotlib.axes.Axes:
    """Combined standard uncertainty of each sensor in its worst case, the best on top."""
    axes = new_axes(ax)
    names, values = list(analysis.uncertainties), list(analysis.uncertainties.values())
    axes.barh(names, values, color=BLUE)
    axes.invert_yaxis()
    axes.set_xlabel("Standard uncertainty, worst case [N]")
    return axes


def case_frame(case: Case) -> pandas.DataFrame:
    """The channels, and the force that each sensor's reading means, over time."""
    made = to_pandas(case.signals)
    for name, force in case.forces.items():
        made[name] = force
        made.attrs["units"][name] = "N"
    return made


def together_frame(together: Together) -> pandas.DataFrame:
    """The channels of all springs over time."""
    return to_pandas(together.signals)


def forces_plot(case: Case | Together, ax: matplotlib.axes.Axes | None) -> matplotlib.axes.Axes:
    """The forces over time."""
    axes = signals_plot(case.signals, None, ax)
    axes.set_title(f"{case.condition}, {case.damping}")
    return axes


# nouns


def windings_frame(windings: Windings) -> pandas.DataFrame:
    """One row per sample: end 1, the windings, end 2."""
    columns: dict[str, Any] = {"u1": windings.ends[:, 0]}
    columns |= {f"x_{place + 1}": windings.positions[:, place] for place in range(windings.count)}
    return frame(columns | {"u2": windings.ends[:, 1]})


def windings_plot(windings: Windings, ax: matplotlib.axes.Axes | None) -> matplotlib.axes.Axes:
    """Every winding's path, the ends in colour."""
    axes = new_axes(ax)
    samples = numpy.arange(windings.samples)
    axes.plot(samples, 1e3 * windings.positions, color=GREY, linewidth=0.6)
    for end, colour, name in ((0, BLUE, "end 1"), (1, RED, "end 2")):
        axes.plot(samples, 1e3 * windings.ends[:, end], color=colour, linewidth=1.5, label=name)
    axes.set_xlabel("Sample")
    axes.set_ylabel("Position [mm]")
    axes.legend()
    return axes


def spectrum_frame(spectrum: Spectrum) -> pandas.DataFrame:
    """One row per line."""
    return frame({"frequency": spectrum.frequencies, "amplitude": spectrum.amplitudes})


def spectrum_plot(spectrum: Spectrum, ax: matplotlib.axes.Axes | None) -> matplotlib.axes.Axes:
    """Amplitudes over frequency, without the mean."""
    axes = new_axes(ax)
    axes.semilogy(spectrum.frequencies[1:], spectrum.amplitudes[1:], color=BLUE, linewidth=1)
    axes.set_xlabel("Frequency [Hz]")
    axes.set_ylabel("Amplitude")
    return axes


def modes_frame(modes: ChainModes) -> pandas.DataFrame:
    """One row per mode."""
    numbers = numpy.arange(1, modes.count + 1)
    return frame({"mode": numbers, "frequency": modes.frequencies, "end_shape": modes.end_shapes})


def modes_plot(modes: ChainModes, ax: matplotlib.axes.Axes | None) -> matplotlib.axes.Axes:
    """Frequency over the mode's number."""
    axes = new_axes(ax)
    axes.plot(numpy.arange(1, modes.count + 1), modes.frequencies, "o", color=BLUE, markersize=3)
    axes.set_xlabel("Mode")
    axes.set_ylabel("Frequency [Hz]")
    return axes


def two_port_plot(port: TwoPort, frequencies: Any, ax: matplotlib.axes.Axes | None) -> matplotlib.axes.Axes:
    """Sizes of drive-point and transfer stiffness over frequency."""
    axes = new_axes(ax)
    for values, colour, name in ((port.drive_point(frequencies), BLUE, "drive point"), (port.transfer(frequencies), RED, "transfer")):
        axes.semilogy(frequencies, numpy.abs(values), color=colour, linewidth=1, label=name)
    axes.set_xlabel("Frequency [Hz]")
    axes.set_ylabel("Dynamic stiffness [N/m]")
    axes.legend()
    return axes


def plant_frame(plant: Plant) -> pandas.DataFrame:
    """One row per mode that is kept."""
    return frame({"frequency": plant.frequencies, "damping_ratio": plant.damping_ratios})


def plant_plot(plant: Plant, ax: matplotlib.axes.Axes | None) -> matplotlib.axes.Axes:
    """What the motion of end 1 does to the forces, up to beyond the highest mode that is kept."""
    axes = new_axes(ax)
    frequencies = numpy.geomspace(0.1 * plant.frequencies[0], 1.5 * plant.frequencies[plant.kept - 1], 600)
    response = plant.to_frd(frequencies)[0]
    for row, colour in ((0, BLUE), (1, RED)):
        axes.loglog(frequencies, numpy.abs(response[row, 0]), color=colour, linewidth=1, label=plant.outputs[row])
    axes.set_xlabel("Frequency [Hz]")
    axes.set_ylabel("Force over u1 [N/m]")
    axes.legend()
    return axes


# studies


def placement_plot(placement: Placement, ax: matplotlib.axes.Axes | None) -> matplotlib.axes.Axes:
    """Crossovers at which each force may be fed back: stable, and with a sensitivity of at most 2."""
    axes = new_axes(ax)
    limits = placement.limits
    finite = [value for pair in limits.values() for value in pair if math.isfinite(value)]
    finite += placement.robust_from.values()
    edge = 1.2 * max(finite, default=1.0)
    for place, (name, pair) in enumerate(limits.items()):
        begins = (0.0, placement.robust_from[name])
        for value, begin, colour, height in zip(pair, begins, (BLUE, RED), (0.7, 0.35), strict=True):
            axes.barh(place, max(min(value, edge) - begin, 0.0), height, left=begin, color=colour)
            if not math.isfinite(value):
                axes.annotate("no limit", (edge, place), ha="right", va="center", color="white", fontsize=8)
    axes.set_yticks(range(len(limits)), list(limits))
    axes.invert_yaxis()
    axes.set_xlabel("Crossover [Hz]: stable (blue), sensitivity 2 (red)")
    return axes


def speed_plot(speeds: SpeedMap, ax: matplotlib.axes.Axes | None) -> matplotlib.axes.Axes:
    """Largest and least force at end 1 over the engine's speed, each case in its colour."""
    axes = new_axes(ax)
    for place, (case, runs) in enumerate(speeds.runs.items()):
        turns = 60 * runs["speed_hz"]
        axes.plot(turns, runs["input_force_largest_n"], "-", color=f"C{place}", linewidth=1, label=case)
        axes.plot(turns, runs["input_force_least_n"], "--", color=f"C{place}", linewidth=1)
    axes.set_xlabel("Speed of the engine [rpm]")
    axes.set_ylabel("F_i, largest and least [N]")
    axes.legend()
    return axes


def pareto_plot(pareto: Pareto, ax: matplotlib.axes.Axes | None) -> matplotlib.axes.Axes:
    """The front in its first two objectives, the knee marked; of one objective its value by the design's place."""
    axes = new_axes(ax)
    values, knee = pareto.values, list(pareto.rows).index(pareto.knee)
    two = values.shape[1] > 1
    over, up = (values[:, 0], values[:, 1]) if two else (numpy.arange(len(values)), values[:, 0])
    axes.plot(over, up, "o", color=BLUE, markersize=4, label="front")
    axes.plot([over[knee]], [up[knee]], "o", color=RED, fillstyle="none", markersize=11, label=f"knee, row {pareto.knee}")
    axes.set_xlabel(pareto.objectives[0] if two else "Design")
    axes.set_ylabel(pareto.objectives[1] if two else pareto.objectives[0])
    axes.legend()
    return axes


def sensitivity_plot(sensitivity: Sensitivity, ax: matplotlib.axes.Axes | None) -> matplotlib.axes.Axes:
    """Total indices of every column with their 95 % intervals, key by key."""
    axes = new_axes(ax)
    keys, columns = sensitivity.variables, list(sensitivity.total.items())
    width = 0.8 / max(len(columns), 1)
    for number, (column, found) in enumerate(columns):
        there = [key for key in keys if key in found]
        total, low, high = numpy.array([found[key] for key in there]).reshape(-1, 3).T
        places = numpy.array([keys.index(key) for key in there]) + (number - (len(columns) - 1) / 2) * width
        spans = numpy.maximum([total - low, high - total], 0)
        axes.bar(places, total, width, yerr=spans, label=column)
    axes.set_xticks(range(len(keys)), keys)
    axes.set_xlabel("Key")
    axes.set_ylabel("Total index [1]")
    axes.legend()
    return axes


def sweep_plot(sweep: SweepDataset, over: str, of: str, ax: matplotlib.axes.Axes | None) -> matplotlib.axes.Axes:
    """One column over another, a dot a design; those that were refused are left out."""
    axes = new_axes(ax)
    columns = sweep.read([over, of])
    axes.plot(columns[over], columns[of], "o", color=BLUE, markersize=3)
    axes.set_xlabel(over)
    axes.set_ylabel(of)
    return axes
