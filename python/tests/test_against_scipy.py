"""SciPy computes the same; book/src/guide/python.md has the table of all comparisons, which is compared here, so that it cannot go stale."""

import pathlib
from collections.abc import Callable

import against_scipy
import pytest

DOCUMENT = pathlib.Path(__file__).parents[2] / "book" / "src" / "guide" / "python.md"


def table() -> str:
    """The comparisons as a table of Markdown."""
    lines = ["| ours | theirs | largest difference | why not less |", "|---|---|---|---|"]
    for compare, (limit, reason) in against_scipy.COMPARISONS.items():
        ours, theirs = (compare.__doc__ or "").split(" <-> ")
        lines.append(f"| {ours} | {theirs} | {limit:.0e} | {reason} |")
    return "\n".join(lines) + "\n"


@pytest.mark.parametrize("compare", against_scipy.COMPARISONS, ids=lambda compare: compare.__name__)
def test_it_differs_from_scipy_by_no_more_than_the_table_says(compare: Callable[[], float]) -> None:
    measured, limit = compare(), against_scipy.COMPARISONS[compare][0]
    print(f"{compare.__name__}: {measured:.2e}")
    assert measured <= limit
    # A table that says far more than what is measured would hide a change; rounding may differ by some times between machines.
    assert limit <= 30 * max(measured, 1e-16)


def test_the_table_of_the_document_is_this_one() -> None:
    text = DOCUMENT.read_text()
    assert table() in text, "book/src/guide/python.md must hold this table:\n" + table()
