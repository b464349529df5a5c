"""The Python code of book/src/guide/python.md, run block after block as a reader would, and the example scripts."""

import os
import pathlib
import subprocess
import sys
import time

import pytest

ROOT = pathlib.Path(__file__).parents[2]
EXAMPLES = sorted((ROOT / "python" / "examples").glob("*.py"))


def blocks(text: str) -> list[str]:
    """The fenced blocks of Python."""
    return [part.split("\n```", 1)[0] for part in text.split("```python\n")[1:]]


def test_the_code_of_the_document_runs(tmp_path: pathlib.Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "examples").symlink_to(ROOT / "examples")
    monkeypatch.chdir(tmp_path)
    names: dict[str, object] = {}
    found = blocks((ROOT / "book" / "src" / "guide" / "python.md").read_text())
    assert len(found) >= 5
    for number, block in enumerate(found, 1):
        exec(compile(block, f"book/src/guide/python.md, block {number}", "exec"), names)


@pytest.mark.parametrize("script", EXAMPLES, ids=lambda path: path.stem)
def test_an_example_prints_its_finding_in_seconds(script: pathlib.Path, tmp_path: pathlib.Path) -> None:
    begun = time.perf_counter()
    environment = {**os.environ, "MPLBACKEND": "Agg", "TMPDIR": str(tmp_path)}
    done = subprocess.run([sys.executable, script], cwd=tmp_path, env=environment, capture_output=True, text=True, timeout=60)
    assert done.returncode == 0, done.stderr
    assert len(done.stdout.strip()) > 20
    # Five seconds by themselves; a machine that builds something else at the same time may take four times as long.
    assert time.perf_counter() - begun < 20
