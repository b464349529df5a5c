"""Recordings, calibrations and identifications laid out. Next door: what they are laid out with (`_layout`)."""

from __future__ import annotations

import html
from typing import TYPE_CHECKING, Any

import numpy

from coilsense._html import table
from coilsense._layout import BLUE, GREY, RED, frame, new_axes, paragraphs

if TYPE_CHECKING:
    import matplotlib.axes
    import pandas

    from coilsense import Calibration, Estimate, Identification, Recording

# recording


def recording_html(recording: Recording) -> str:
    """The account of the rows."""
    lines = "\n".join(html.escape(line) for line in recording.account)
    return f"<pre>{lines}</pre>"


# calibration


def points_frame(calibration: Calibration) -> pandas.DataFrame:
    """One row per point."""
    return frame(calibration.to_dict()["points"], "row")


def calibration_plot(calibration: Calibration, ax: matplotlib.axes.Axes | None) -> matplotlib.axes.Axes:
    """Points, and the curve through them over their range."""
    axes = new_axes(ax)
    lengths, inductances = calibration.lengths, calibration.inductances
    over = numpy.linspace(lengths.min(), lengths.max(), 200)
    axes.plot(1e3 * over, 1e6 * calibration.inductance(over), color=RED, linewidth=1.2, label="1/l = αL + β")
    axes.plot(1e3 * lengths, 1e6 * inductances, "o", color=BLUE, markersize=4, label="measured")
    axes.set_xlabel("Length [mm]")
    axes.set_ylabel("Inductance [µH]")
    axes.legend()
    return axes


def calibration_html(calibration: Calibration) -> str:
    """The answer, and the theories."""
    rows = [
        (theory["name"], *((f"{theory['r2']:.5f}", f"{1e3 * theory['rmse']:.4g}") if "r2" in theory else ("", theory["refused"])))
        for theory in calibration.theories
    ]
    return paragraphs(calibration.answer) + (table("Theories", rows, ("theory", "R²", "RMSE [mm]")) if rows else "")


# identification


def lines_frame(identification: Identification) -> pandas.DataFrame:
    """One row per line of the record, values and their 95 % intervals side by side."""
    rows = []
    for line in identification.lines:
        row: dict[str, Any] = {}
        for key, value in line.items():
            if isinstance(value, dict):
                row[key] = value["value"]
                row[f"{key}_low"], row[f"{key}_high"] = value["low"], value["high"]
            else:
                row[key] = value
        rows.append(row)
    return frame(rows)


def identification_plot(identification: Identification, ax: matplotlib.axes.Axes | None) -> matplotlib.axes.Axes:
    """The spectrum of the record, with a mark at each line and the names of the modes."""
    axes = new_axes(ax)
    nyquist = 0.5 * identification.sample_rate
    seen = [line["frequency_hz"]["value"] for line in identification.lines]
    highest = min(1.15 * max(seen), nyquist) if seen else nyquist
    floor, peak = numpy.inf, 0.0
    for colour, (part, (frequencies, density)) in zip((RED, BLUE), identification.spectra.items()):
        # The mean's line says nothing.
        shown = (frequencies > 0) & (frequencies <= highest)
        amplitude = numpy.sqrt(density[shown])
        axes.semilogy(frequencies[shown], amplitude, color=colour, linewidth=1, label=f"{part} component")
        floor, peak = min(floor, numpy.quantile(amplitude, 0.05)), max(peak, amplitude.max())
    if peak > 0:
        axes.set_ylim(max(0.5 * floor, 1e-9 * peak), 4 * peak)
    for line in identification.lines:
        frequency = line["frequency_hz"]["value"]
        axes.axvline(frequency, color=GREY, linewidth=0.7, linestyle=":", zorder=0)
        if line["kind"] in ("mode", "alias"):
            name = f"f$_{{{line['number']}}}$" + (" folded" if line["kind"] == "alias" else "")
            axes.annotate(name, (frequency, 0.99), xycoords=("data", "axes fraction"), ha="center", va="top", fontsize=9,
                          bbox={"facecolor": "white", "edgecolor": "none", "pad": 1})
    axes.set_xlim(0, highest)
    axes.set_xlabel("Frequency [Hz]")
    axes.set_ylabel("Density [N/√Hz]")
    # Below the names of the modes.
    axes.legend(loc="upper right", bbox_to_anchor=(1, 0.94))
    return axes


def identification_html(identification: Identification) -> str:
    """The answer, the values with their intervals, the lines."""
    values: list[tuple[str, Estimate | None, float, str]] = [
        ("f₁", identification.first_frequency, 1, "Hz"),
        ("ζ", identification.damping_ratio, 1, ""),
        ("k", identification.stiffness, 1, "N/m"),
        ("l₀", identification.rest_length, 1e3, "mm"),
        ("m", identification.mass, 1e3, "g"),
        ("τ", identification.transit_time, 1e3, "ms"),
    ]
    rows = [
        (name, f"{scale * found.value:.6g}", f"± {scale * found.expanded:.2g}", unit)
        for name, found, scale, unit in values
        if found is not None
    ]
    lines = [
        (f"{line['frequency_hz']['value']:.3f}", f"{line['amplitude_n']:.3g}", line["kind"], line["reason"])
        for line in identification.lines
    ]
    shown = table("The spring", rows, ("", "value", "95 %", "unit")) if rows else ""
    return paragraphs(identification.answer) + shown + table("Lines", lines, ("line [Hz]", "amplitude [N]", "what", "why"))
