"""A spec from Python is processed as the command does it; long work can be watched and stopped."""

import json
import os
import pathlib
import re
import signal
import threading
import time

import numpy
import pytest

import coilsense

TEMPLATE = coilsense.Spec.template("S_T")
SPEC = coilsense.Spec.parse(TEMPLATE)
EXAMPLES = pathlib.Path(__file__).parents[2] / "examples"


def test_a_spec_says_what_its_file_says() -> None:
    assert SPEC.spring == coilsense.Spring.of_paper("S_T")
    heel_strike = SPEC.conditions[0]
    assert heel_strike.name == "heel strike" and heel_strike.kind == "impact"
    assert heel_strike.excitation.start.kind == "moving"
    assert all(mount.far_end == coilsense.FarEnd.position() for mount in SPEC.mounts.values())
    assert SPEC.data_sheet()["schema"] == "coilsense/data-sheet/2"


def test_the_error_of_a_spec_is_one_line_with_file_line_and_key() -> None:
    with pytest.raises(coilsense.SpecError, match=r"^my\.toml:11: .*stiffness"):
        coilsense.Spec.parse(TEMPLATE.replace('"760 N/m"', '"-1 N/m"'), file="my.toml")
    with pytest.raises(coilsense.SpecError, match=r"nowhere\.toml: cannot be read"):
        coilsense.Spec.read("nowhere.toml")
    with pytest.raises(coilsense.AnalysisError, match="no .*condition"):
        coilsense.analyze(coilsense.Spec.parse(TEMPLATE[: TEMPLATE.index("[[condition]]")]))


def test_recorded_files_are_looked_for_beside_the_spec(tmp_path: pathlib.Path) -> None:
    (tmp_path / "u.csv").write_text("time [s],u1 [m]\n0,0\n0.1,0.001\n0.5,0\n")
    condition = '[[condition]]\nname = "log"\nkind = "recorded"\nfile = "u.csv"\nlength = "mid"\n'
    text = TEMPLATE[: TEMPLATE.index("[[condition]]")] + condition
    here = coilsense.Spec.parse(text, folder=tmp_path)
    assert here.conditions[0].excitation.end1.kind == "sampled" or here.conditions[0].excitation.end2.kind == "sampled"
    with pytest.raises(coilsense.SpecError, match=r"u\.csv cannot be read"):
        coilsense.Spec.parse(text, folder=tmp_path / "elsewhere")


def test_a_simulated_case_is_the_motion_of_its_condition() -> None:
    for case in coilsense.simulate(SPEC):
        condition = next(each for each in SPEC.conditions if each.name == case.condition)
        motion = coilsense.Motion(SPEC.spring, condition.excitation, SPEC.mounts[case.damping])
        numpy.testing.assert_array_equal(motion.signals(case.signals.time)["F_o"], case.signals["F_o"])
        times = case.signals.time[case.judged]
        assert (times[0], times[-1]) == pytest.approx(condition.window, abs=1e-9)  # the window is on the grid
        judged = coilsense.Deviation.between(case.signals["F_o"][case.judged], case.signals["F_x"][case.judged])
        assert case.deviations["F_o"] == judged
        assert case.forces.keys() == set(SPEC.sensors)


def test_an_analysis_writes_what_the_command_writes(tmp_path: pathlib.Path) -> None:
    analysis = coilsense.analyze(SPEC)
    assert analysis.save(tmp_path / "out", date="2026-11-22") == 3
    results = json.loads((tmp_path / "out/results.json").read_text())
    assert results == analysis.to_dict("2026-11-22")
    assert results["answer"] == analysis.answer
    assert [each["sensor"] for each in results["ranking"]] == analysis.ranking == list(analysis.uncertainties)
    assert (tmp_path / "out/report.html").read_text().startswith("<!doctype html>")
    assert analysis.answer[0].split(".")[0] in analysis.text and "\x1b" not in analysis.text
    assert len(analysis.cases) == len(SPEC.conditions) * len(SPEC.mounts)
    (tmp_path / "file").write_text("")
    with pytest.raises(coilsense.OutputError, match="file"):
        analysis.save(tmp_path / "file")


def test_progress_is_told_and_an_exception_of_it_stops_the_work() -> None:
    told: list[tuple[int, int]] = []
    coilsense.analyze(SPEC, progress=lambda done, of: told.append((done, of)))
    assert told[-1][0] == told[-1][1] == len(SPEC.conditions) * len(SPEC.mounts)
    assert told == sorted(told)

    def refuse(done: int, of: int) -> None:
        raise RuntimeError("enough")

    with pytest.raises(RuntimeError, match="enough"):
        coilsense.analyze(SPEC, progress=refuse)


def test_a_keyboard_interrupt_gets_through() -> None:
    timer = threading.Timer(0.3, lambda: os.kill(os.getpid(), signal.SIGINT))
    # Who runs the tests in the background of a script has Ctrl-C ignored.
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    try:
        timer.start()
        begun = time.monotonic()
        with pytest.raises(KeyboardInterrupt):
            for _ in range(1000):
                coilsense.simulate(SPEC)
    finally:
        signal.signal(signal.SIGINT, before)
    assert time.monotonic() - begun < 30  # at the next case, and not after a thousand runs of 20 cases


@pytest.mark.parametrize("noun", [SPEC.spring, coilsense.analyze(SPEC), coilsense.simulate(SPEC)[0].signals])
def test_a_notebook_shows_a_table_without_colours_of_its_own(noun: coilsense.Spring) -> None:
    page = noun._repr_html_()
    assert page.count("<table") == page.count("</table>") == 1
    assert not re.search(r"[^-]color:|#[0-9a-fA-F]{3,8};", page)
