"""Many processes at a time: what a parent has computed takes nothing from its children, however they are started.

Everything here runs in a process of its own with a limit of time, so that what hangs fails.
"""

import os
import pathlib
import signal
import subprocess
import sys
import textwrap

import pytest

TESTS = str(pathlib.Path(__file__).parent)

#: What every script begins with. ``doors`` are all calls that may spread over threads, by name; each gives what its result is compared by.
PRELUDE = """
import multiprocessing, os, pathlib, sys, tempfile
sys.path.insert(0, {tests!r})
import numpy, samples, sweeps
import coilsense

HELD = 'end2 = "held"'
WHOLE = coilsense.Spec.template("S_T").replace(HELD, HELD + "\\ndamping_ratio = 0.005", 1)
# Two of its conditions are several runs at a time, and are run again and again here.
TEXT = "[[condition]]".join(WHOLE.split("[[condition]]")[:3]) + WHOLE[WHOLE.index("[[sensor]]"):]
SPEC = coilsense.Spec.parse(TEXT)
LOOP = coilsense.Spec.parse(TEXT + '\\n[control]\\ndrive = "velocity"\\nsample_time = "0.4 ms"\\n')
RIG = coilsense.Spec.parse(TEXT + '\\n[rig]\\nfrequencies = 3\\nduration = "4 s"\\nreadings = 10\\nhits = 1\\n')
TRAIN = pathlib.Path({tests!r}).parents[1] / "examples/valve-train.toml"
COIL = coilsense.MaxwellSum(samples.SPRING)


def folder():
    return pathlib.Path(tempfile.mkdtemp()) / "out"


def saved(result):
    return result.save(folder(), date="2026-11-22")


def calibrated():
    lengths = numpy.linspace(samples.SPRING.min_length, samples.SPRING.max_length, 7)
    return coilsense.calibrate((lengths, COIL.at_lengths(lengths)), spring=samples.SPRING)


def swept():
    over = {{"spring.stiffness": "600..900 N/m", "spring.mass": "50..80 g"}}
    return coilsense.sweep(sweeps.SPEC, over, folder(), sampling="saltelli", rows=8, columns=["mass", "f1"])


def experimented():
    coilsense.rig(RIG, place := folder(), seed=3)
    return coilsense.experiment(place)


def rolled():
    batch = coilsense.Live(samples.SPRING, 0.23, 1e-4).batch(20)
    return batch.rollout(numpy.zeros((20, 1000)), numpy.full((20, 1000), 0.2301))[1].tolist()


DOORS = {{
    "simulate": lambda: float(coilsense.simulate(SPEC)[0].signals["F_o"].max()),
    "analyze": lambda: coilsense.analyze(SPEC).to_dict("2026-11-22"),
    "Analysis.save": lambda: saved(coilsense.analyze(SPEC)),
    "mitigate": lambda: coilsense.mitigate(SPEC, seeds=1).to_dict(),
    "placement": lambda: coilsense.placement(LOOP).limits,
    "speed": lambda: coilsense.speed(TRAIN, 50, 60, step=10).answer,
    "sweep": lambda: sweeps.files(swept().folder),
    "sensitivity": lambda: coilsense.sensitivity(swept(), resamples=20).total,
    "calibrate": lambda: calibrated().to_dict(),
    "Calibration.save": lambda: saved(calibrated()),
    "identify": lambda: coilsense.identify(coilsense.Recording(samples.hit_log(seconds=6))).verdict,
    "data_sheet": lambda: SPEC.data_sheet(),
    "rig, experiment": lambda: experimented().rows,
    "Experiment.save": lambda: saved(experimented()),
    "LiveBatch.rollout": rolled,
}}


def door(name):
    return DOORS[name]()
"""

def run(script: str, limit: float) -> str:
    """What a script prints; it fails where it takes longer than it may."""
    return finished(["-c", PRELUDE.format(tests=TESTS) + textwrap.dedent(script)], limit)


def finished(arguments: list[str], limit: float) -> str:
    """What Python prints; where it takes longer than it may, neither it nor a child of it is left."""
    process = subprocess.Popen(
        [sys.executable, *arguments], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, start_new_session=True
    )
    try:
        said, errors = process.communicate(timeout=limit)
    except subprocess.TimeoutExpired:
        os.killpg(process.pid, signal.SIGKILL)
        process.communicate()
        pytest.fail(f"has not ended after {limit} s")
    assert process.returncode == 0, errors
    return said


@pytest.mark.parametrize("verb", ["simulate", "analyze", "mitigate"])
def test_a_forked_child_computes_what_its_parent_computed_before(verb: str) -> None:
    script = f"""
        expected = door({verb!r})
        for _ in range(20):
            with multiprocessing.get_context("fork").Pool(2) as pool:
                assert pool.map(door, [{verb!r}] * 2) == [expected] * 2
        print("done")
    """
    assert run(script, 120) == "done\n"


def test_every_door_works_in_a_forked_child() -> None:
    script = """
        expected = {name: door(name) for name in DOORS}
        with multiprocessing.get_context("fork").Pool(2) as pool:
            found = dict(zip(DOORS, pool.map(door, DOORS)))
        assert found == expected, [name for name in DOORS if found[name] != expected[name]]
        # The children's children have it no worse.
        if (child := os.fork()) == 0:
            door("analyze")
            if (grandchild := os.fork()) == 0:
                door("analyze")
                os._exit(7)
            os._exit(os.waitstatus_to_exitcode(os.waitpid(grandchild, 0)[1]))
        print(os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]))
    """
    assert run(script, 120) == "7\n"


def test_no_door_leaves_threads_that_have_no_name_of_ours() -> None:
    """Rayon's global pool would be inherited by a child without its threads; those of a pool of ours are called after it."""
    if not sys.platform.startswith("linux"):
        pytest.skip("the names of threads are read from /proc")
    script = """
        def threads():
            return [path.read_text().strip() for path in pathlib.Path("/proc/self/task").glob("*/comm")]

        before = threads()
        for name in DOORS:
            door(name)
        after = threads()
        ours = [name for name in after if name.startswith("coilsense")]
        print(len(ours) > 0, len(after) - len(ours) - len(before))
    """
    assert run(script, 120) == "True 0\n"


@pytest.mark.parametrize("method", ["spawn", "forkserver"])
def test_children_that_are_started_anew_compute_the_same(method: str, tmp_path: pathlib.Path) -> None:
    # Such children import what they run from a file.
    script = PRELUDE.format(tests=TESTS) + textwrap.dedent(f"""
        if __name__ == "__main__":
            names = ["simulate", "analyze", "mitigate"]
            expected = [door(name) for name in names]
            with multiprocessing.get_context({method!r}).Pool(2) as pool:
                assert pool.map(door, names) == expected
            print("done")
    """)
    (tmp_path / "script.py").write_text(script)
    assert finished([str(tmp_path / "script.py")], 120) == "done\n"


@pytest.mark.parametrize("backend", ["loky", "multiprocessing", "threading"])
def test_joblib_computes_the_same(backend: str) -> None:
    pytest.importorskip("joblib")
    script = f"""
        import joblib

        names = ["simulate", "analyze", "mitigate"]
        expected = [door(name) for name in names]
        found = joblib.Parallel(n_jobs=2, backend={backend!r})(joblib.delayed(door)(name) for name in names)
        assert found == expected
        print("done")
    """
    assert run(script, 120) == "done\n"
