"""What laid-out results are made of: axes, paragraphs, data frames. Next door: tables (`_html`), what is laid out (`_logs`, `_studies`)."""

from __future__ import annotations

import html
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from coilsense._frames import imported, checked_axes

if TYPE_CHECKING:
    import matplotlib.axes
    import pandas

# Colours that people who see red and green alike can tell apart (Okabe and Ito).
BLUE, RED, GREY = "#0072b2", "#d55e00", "#777777"


def new_axes(ax: matplotlib.axes.Axes | None) -> matplotlib.axes.Axes:
    """The axes that were given, or those of a new figure."""
    if ax is not None:
        return checked_axes(ax)
    made: matplotlib.axes.Axes = imported("matplotlib.pyplot", "plot").subplots(layout="constrained", figsize=(7.5, 4))[1]
    made.grid(alpha=0.3)
    return made


def paragraphs(lines: Sequence[str]) -> str:
    """The first line in bold, the others below it."""
    escaped = [html.escape(line) for line in lines]
    return "".join(f"<p>{'<b>' + line + '</b>' if place == 0 else line}</p>" for place, line in enumerate(escaped))


def frame(rows: Sequence[dict[str, Any]], index: str | None = None) -> pandas.DataFrame:
    """A data frame of dicts."""
    made: pandas.DataFrame = imported("pandas", "pandas").DataFrame(list(rows))
    return made if index is None or made.empty else made.set_index(index)
