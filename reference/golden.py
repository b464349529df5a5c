"""Where the golden files stand: in the crate whose tests read them, so that a packed crate can be tested by itself."""

from pathlib import Path

CRATES = Path(__file__).resolve().parent.parent / "crates"
SCIENCE = CRATES / "coilsense" / "tests" / "golden"
LAB = CRATES / "coilsense-lab" / "tests" / "golden"
