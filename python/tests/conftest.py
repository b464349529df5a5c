"""Where the tests' own modules are, plots without a screen, and Ctrl-C as a terminal sends it."""

import pathlib
import signal
import sys

import pytest

sys.path.insert(0, str(pathlib.Path(__file__).parent))

# A script that starts the tests in the background has them ignore Ctrl-C, and what they start as well; some of them test just that.
signal.signal(signal.SIGINT, signal.default_int_handler)


@pytest.fixture(autouse=True)
def _no_screen(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("MPLBACKEND", "Agg")
