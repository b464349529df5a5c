"""Remedies, placements, experiments, and what is asked of sweeps, laid out. Next door: what they are laid out with (`_layout`)."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from coilsense._frames import imported
from coilsense._frames import frame as designs_frame
from coilsense._html import table
from coilsense._layout import BLUE, RED, frame, new_axes, paragraphs

if TYPE_CHECKING:
    import matplotlib.axes
    import pandas

    from coilsense import Experiment, Mitigation, Pareto, Placement, Sensitivity, SpeedMap

# mitigation


def ranking_frame(mitigation: Mitigation) -> pandas.DataFrame:
    """One row per remedy, best first; without the settings."""
    rows = [{key: value for key, value in remedy.to_dict().items() if key != "settings"} for remedy in mitigation.remedies]
    return frame(rows, "name")


def mitigation_plot(mitigation: Mitigation, ax: matplotlib.axes.Axes | None) -> matplotlib.axes.Axes:
    """Worst error over lag; the best of either kind by its name."""
    axes = new_axes(ax)
    looks = {"k·Δl": (BLUE, "o", "filters of F_i, against k·Δl"), "F_o": (RED, "s", "estimators, against F_o")}
    for against, (colour, mark, label) in looks.items():
        those = [remedy for remedy in mitigation.remedies if remedy.against == against]
        lags = [math.degrees(remedy.lag) for remedy in those]
        axes.semilogy(lags, [remedy.worst_rms_error for remedy in those], mark, color=colour, label=label, markersize=5)
    for best in (mitigation.best_filter, mitigation.best_estimator):
        if best is not None:
            at = ([math.degrees(best.lag)], [best.worst_rms_error])
            colour, mark, _ = looks[best.against]
            axes.plot(*at, mark, color=colour, fillstyle="none", markersize=12, label=f"best: {best.name}")
    axes.yaxis.set_major_locator(imported("matplotlib.ticker", "plot").LogLocator(subs=(1, 2, 5)))
    axes.yaxis.set_major_formatter("{x:g}")
    axes.yaxis.set_minor_formatter("")
    axes.set_xlabel(f"Lag at {mitigation.bandwidth:.3g} Hz [deg]")
    axes.set_ylabel("Worst rms error [N]")
    axes.legend()
    return axes


def mitigation_html(mitigation: Mitigation) -> str:
    """The advice, and the ranking."""
    rows = [
        (
            remedy.name,
            remedy.against,
            f"{remedy.worst_rms_error:.3g}",
            f"{remedy.rms_error:.3g}",
            f"{math.degrees(remedy.lag):.1f}",
            f"{remedy.noise_gain:.2f}",
            f"{1e3 * remedy.settling:.0f}",
        )
        for remedy in mitigation.remedies
    ]
    head = ("remedy", "against", "worst rms [N]", "nominal rms [N]", "lag [deg]", "noise gain", "settles [ms]")
    return paragraphs(mitigation.to_dict()["advice"]) + table("Remedies", rows, head)


# placement


def limits_frame(placement: Placement) -> pandas.DataFrame:
    """One row per force or estimate."""
    rows = [
        {"force": name, "stable_crossover": stable, "robust_from": placement.robust_from[name], "robust_crossover": robust}
        for name, (stable, robust) in placement.limits.items()
    ]
    return frame(rows, "force")


def placement_html(placement: Placement) -> str:
    """The answer, and the limits."""
    rows = [
        (name, f"{stable:.4g}", f"{placement.robust_from[name]:.4g}", f"{robust:.4g}")
        for name, (stable, robust) in placement.limits.items()
    ]
    head = ("fed back", "stable up to [Hz]", "sensitivity 2 from [Hz]", "up to [Hz]")
    return paragraphs(placement.answer) + table("Limits", rows, head)


# speed


def speeds_frame(speeds: SpeedMap) -> pandas.DataFrame:
    """One row per run: its case, then the columns in SI."""
    library = imported("pandas", "pandas")
    cases = [library.DataFrame({"case": case, **columns}) for case, columns in speeds.runs.items()]
    made: pandas.DataFrame = library.concat(cases, ignore_index=True)
    return made


def speed_html(speeds: SpeedMap) -> str:
    """The answer, and where harmonics meet the first surge frequency."""
    rows = [(f"{60 * speed:.0f}", str(harmonic), f"{1e6 * lift:.3g}") for harmonic, speed, lift in speeds.crossings]
    return paragraphs(speeds.answer) + table("Crossings", rows, ("n [rpm]", "harmonic", "its lift [µm]"))


# experiment


def runs_frame(experiment: Experiment) -> pandas.DataFrame:
    """One row per run; of each force its mean and how uncertain that is."""
    rows = []
    for run in experiment.rows:
        row = {key: value for key, value in run.items() if key != "means"}
        for force, mean in run["means"].items():
            row[f"{force}_mean_n"], row[f"{force}_standard_error_n"] = mean["mean_n"], mean["standard_error_n"]
        rows.append(row)
    return frame(rows, "name")


def experiment_plot(experiment: Experiment, ax: matplotlib.axes.Axes | None) -> matplotlib.axes.Axes:
    """Deviation of F_o from F_x over the frequency of the sines, as a share of F_nom."""
    axes = new_axes(ax)
    sines = sorted((run for run in experiment.rows if run["kind"] == "harmonic"), key=lambda run: run["frequency_hz"])
    over = [run["frequency_hz"] for run in sines]
    axes.semilogy(over, [run["maximum_absolute_percent"] for run in sines], "s--", color=RED, markersize=4, label="largest")
    axes.semilogy(over, [run["rmsd_percent"] for run in sines], "o-", color=BLUE, markersize=4, label="RMSD")
    axes.set_xlabel("Frequency [Hz]")
    axes.set_ylabel("F_o against F_x [% of F_nom]")
    axes.set_title("simulated data" if experiment.simulated else "")
    axes.legend()
    return axes


def experiment_html(experiment: Experiment) -> str:
    """The answer, and the runs."""
    rows = [
        (run["name"], run["kind"], f"{run['frequency_hz']:g}", f"{run['rmsd_percent']:.3g}", f"{run['maximum_absolute_percent']:.3g}")
        for run in experiment.rows
    ]
    head = ("run", "kind", "frequency [Hz]", "RMSD [% of F_nom]", "largest [% of F_nom]")
    return paragraphs(experiment.answer) + table("Runs", rows, head)


# what is asked of sweeps


def pareto_html(pareto: Pareto) -> str:
    """The answer, and the objectives of the first designs."""
    most = 20
    values = zip(pareto.rows[:most], pareto.values[:most], strict=True)
    rows = [(str(row), *(f"{value:.4g}" for value in each)) for row, each in values]
    return paragraphs(pareto.answer) + table("The front", rows, ("row", *pareto.objectives))


def front_frame(pareto: Pareto) -> pandas.DataFrame:
    """One row per design on the front, every column of the sweep."""
    return designs_frame(pareto.columns)


def indices_frame(sensitivity: Sensitivity) -> pandas.DataFrame:
    """One row per column and key."""
    rows = []
    for column, keys in sensitivity.total.items():
        for key, (total, low, high) in keys.items():
            first, first_low, first_high = sensitivity.first_order[column][key]
            rows.append({
                "column": column, "key": key,
                "first_order": first, "first_order_low": first_low, "first_order_high": first_high,
                "total": total, "total_low": low, "total_high": high,
            })
    return frame(rows)


def sensitivity_html(sensitivity: Sensitivity) -> str:
    """The answer, and the indices of each column."""
    tables = []
    for column, keys in sensitivity.total.items():
        first = sensitivity.first_order[column]
        rows = [(key, f"{first[key][0]:.2f}", f"{total:.2f}", f"{low:.2f} to {high:.2f}") for key, (total, low, high) in keys.items()]
        tables.append(table(column, rows, ("key", "S_1", "S_T", "S_T, 95 %")))
    return paragraphs(sensitivity.answer) + "".join(tables)
