"""Small tables for notebooks. No colours of their own, so that they look right on light and dark pages."""

from __future__ import annotations

import html
from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from coilsense import Analysis, Deviation, Signals, Spring


def table(caption: str, rows: Iterable[Sequence[str]], header: Sequence[str] = ()) -> str:
    """A table of texts: the first column names, the others hold numbers."""
    edge = "border-bottom:1px solid color-mix(in srgb, currentColor 20%, transparent)"
    style = f"padding:.15em .8em;background:transparent;{edge}"

    def cells(row: Sequence[str], tag: str) -> str:
        sides = ["left"] + ["right"] * (len(row) - 1)
        parts = (
            f'<{tag} style="text-align:{side};{style}">{html.escape(text)}</{tag}>'
            for side, text in zip(sides, row, strict=True)
        )
        return f"<tr>{''.join(parts)}</tr>"

    head = f"<thead>{cells(header, 'th')}</thead>" if header else ""
    body = "".join(cells(row, "td") for row in rows)
    label = f'<caption style="text-align:left;font-weight:bold">{html.escape(caption)}</caption>'
    return f'<table style="border-collapse:collapse">{label}{head}<tbody>{body}</tbody></table>'


def number(value: float, scale: float = 1.0, unit: str = "") -> str:
    """A value with four digits in a unit that is handy."""
    return f"{scale * value:.4g} {unit}".rstrip()


def spring(shown: Spring) -> str:
    """What is asked first of a spring."""
    rows = [
        ("rest length l0", number(shown.rest_length, 1e3, "mm")),
        ("length in use", f"{number(shown.min_length, 1e3)} to {number(shown.max_length, 1e3, 'mm')}"),
        ("stiffness k", number(shown.stiffness, 1.0, "N/m")),
        ("mass m", number(shown.mass, 1e3, "g")),
        ("windings N", number(shown.windings)),
        ("coil radius r", number(shown.coil_radius, 1e3, "mm")),
        ("wire radius ρ", number(shown.wire_radius, 1e3, "mm")),
        ("surge frequency f1", number(shown.surge_frequency, 1.0, "Hz")),
        ("transit time τ", number(shown.transit_time, 1e3, "ms")),
        ("nominal force F_nom", number(shown.nominal_force, 1.0, "N")),
        ("wave impedance", number(shown.wave_impedance, 1.0, "N s/m")),
    ]
    return table("Spring", rows)


def signals(shown: Signals) -> str:
    """The range of each channel."""
    rows = [
        (f"{name} [{shown.unit(name)}]", number(values.min()), number(values.mean()), number(values.max()))
        for name, values in shown.items()
    ]
    time = shown.time
    window = f"{len(time)} samples from {number(time[0])} to {number(time[-1], 1.0, 's')}" if len(time) else "no samples"
    return table(f"Signals: {window}", rows, ("channel", "least", "mean", "largest"))


def deviation(shown: Deviation) -> str:
    """Its values."""
    return table("Deviation", [(name.replace("_", " "), number(value)) for name, value in shown.to_dict().items()])


def analysis(shown: Analysis) -> str:
    """The answer, and the sensors, best first."""
    rows = [(name, number(value, 1.0, "N")) for name, value in shown.uncertainties.items()]
    answer = "".join(f"<p>{html.escape(line)}</p>" for line in shown.answer)
    return answer + table("Sensors, best first", rows, ("sensor", "standard uncertainty, worst case"))
