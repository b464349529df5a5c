"""Ctrl-C, and what an interrupted call leaves behind: nothing that is in the way of the next one."""

import gc
import pathlib
import subprocess
import sys
import textwrap
import time
from collections.abc import Iterator

import pytest
import sweeps

import coilsense


@pytest.fixture
def _uncollected() -> Iterator[None]:
    """Nothing is collected by chance: what is let go of was let go of."""
    gc.disable()
    yield
    gc.enable()


class Enough(Exception):
    """What a progress raises."""


@pytest.mark.usefixtures("_uncollected")
@pytest.mark.parametrize("raised", [KeyboardInterrupt, Enough])
def test_a_sweep_that_progress_ended_is_gone_on_with_while_its_traceback_is_held(
    raised: type[BaseException], tmp_path: pathlib.Path
) -> None:
    def tell(done: int, of: int) -> None:
        if done == 2:
            raise raised

    def go(progress: object = None) -> coilsense.SweepDataset:
        return coilsense.sweep(
            sweeps.SPEC, sweeps.OVER, tmp_path, rows=40, chunk=10, columns=sweeps.COLUMNS, seed=7, progress=progress  # type: ignore[arg-type]
        )

    with pytest.raises(raised) as held:
        go(tell)
    assert "sweep" in [entry.name for entry in held.traceback]  # the frame that has the dataset is alive
    assert coilsense.SweepDataset(tmp_path).missing == [2, 3]
    assert len(go()) == 40


def test_a_dataset_lets_go_of_its_folder_when_it_is_closed(tmp_path: pathlib.Path) -> None:
    plan = coilsense.SweepPlan(sweeps.SPEC, ["spring.mass=50..80 g : 4"], columns=["f1"], chunk=2)
    with coilsense.SweepDataset(tmp_path, plan) as first:
        first.write(0, plan.chunk_bytes(0))
        with pytest.raises(coilsense.SweepError, match="another run is writing"):
            coilsense.SweepDataset(tmp_path, plan)
    second = coilsense.SweepDataset(tmp_path, plan)
    assert second.missing == first.missing == [1] and len(first) == 2
    with pytest.raises(coilsense.SweepError, match="opened to be read"):
        first.write(1, plan.chunk_bytes(1))
    second.write(1, plan.chunk_bytes(1))
    second.close()
    second.close()
    assert coilsense.SweepDataset(tmp_path, plan).missing == []


CELL = """
import sys
sys.path.insert(0, {tests!r})
import coilsense, sweeps

print("begun", flush=True)
coilsense.sweep(sweeps.SPEC, sweeps.OVER, {folder!r}, rows=20_000, chunk=100, columns=sweeps.COLUMNS)
print("whole", flush=True)
"""


def test_a_cell_of_a_notebook_that_was_interrupted_runs_again(tmp_path: pathlib.Path) -> None:
    manager = pytest.importorskip("jupyter_client.manager")
    pytest.importorskip("ipykernel")
    tests = str(pathlib.Path(__file__).parent)
    kernel = manager.KernelManager(kernel_name="python3")
    kernel.start_kernel()
    client = kernel.client()
    client.start_channels()
    try:
        client.wait_for_ready(timeout=60)

        def run(interrupted: bool) -> tuple[str, str]:
            """What the cell prints, and the exception that ends it."""
            client.execute(CELL.format(tests=tests, folder=str(tmp_path / "sweep")))
            printed, error = "", ""
            while True:
                message = client.get_iopub_msg(timeout=60)
                kind, content = message["msg_type"], message["content"]
                if kind == "stream":
                    printed += content["text"]
                    if interrupted and "begun" in printed:
                        while not list((tmp_path / "sweep").glob("chunk-*")):
                            time.sleep(0.02)
                        kernel.interrupt_kernel()
                        interrupted = False
                elif kind == "error":
                    error = f"{content['ename']}: {content['evalue']}"
                elif kind == "status" and content["execution_state"] == "idle" and (error or printed):
                    return printed, error

        printed, error = run(interrupted=True)
        assert error.startswith("KeyboardInterrupt") and printed == "begun\n"
        assert 0 < len(list((tmp_path / "sweep").glob("chunk-*"))) < 200
        printed, error = run(interrupted=False)
        assert (printed, error) == ("begun\nwhole\n", "")
    finally:
        client.stop_channels()
        kernel.shutdown_kernel(now=True)


#: Calls of some seconds at least, by name: of what, and the call.
LONG = {
    "Motion.end_forces": ("scattered", "long.end_forces(it)"),
    "Motion.signals": ("numpy.sort(scattered)", "long.signals(it)"),
    "Motion.windings": ("scattered[:3000]", "long.windings(it)"),
    "Motion.ends": ("scattered", "long.ends(it)"),
    "Clash.of": ("numpy.sort(scattered[:3000])", "coilsense.Clash.of(long, it)"),
    "Stream.take": ("long.stream(1e-6)", "it.take(10**9)"),
    "MaxwellSum.at_lengths": ("numpy.linspace(0.2, 0.3, 10**7)", "coil.at_lengths(it)"),
    "MaxwellSum.series": ("coilsense.Windings(numpy.tile([0.0, 0.3], (3000, 1)), numpy.tile(places, (3000, 1)))", "wide.series(it)"),
    "theories": ("numpy.linspace(0.2, 0.3, 10**7)", "coilsense.theories(spring, it)"),
    "Readout.series": ("numpy.arange(2 * 10**7) * 1e-4", "coilsense.Readout(bandwidth=1e3, order=8, averaging=0.01, noise=1.0).series(it, it)"),
    "Remedy.apply": ("(remedies().best_estimator, numpy.zeros(10**7))", "it[0].apply(it[1], it[1], it[1])"),
    "Spectrum": ("numpy.arange(2 * 10**7 + 3) * 1e-4", "coilsense.Spectrum(it, numpy.cos(it))"),
    "TwoPort": ("numpy.linspace(1, 1e3, 10**7)", "coilsense.TwoPort(spring).transmittance(it)"),
}

INTERRUPTED = """
    import os, signal, threading, time
    import numpy
    import coilsense

    signal.signal(signal.SIGINT, signal.default_int_handler)
    spring = coilsense.Spring.of_paper("S_T")
    coil = coilsense.MaxwellSum(spring)
    places = 0.3 * (numpy.arange(2000) + 0.5) / 2000
    many = spring.to_dict() | {{"windings": 2000, "wire_radius": 4e-5}}
    wide = coilsense.MaxwellSum(coilsense.Spring(**many))
    harmonic = coilsense.Excitation(0.23, end1=coilsense.EndInput.harmonic(1e-3, 10.0))
    long = coilsense.Motion(coilsense.Spring(**many), harmonic, coilsense.Mount(coilsense.FarEnd.mass(0.5)))
    scattered = numpy.random.default_rng(1).uniform(0, 1, 200_000)
    sent = []

    def remedies():
        spec = coilsense.Spec.template("S_T").replace('end2 = "held"', 'end2 = "held"\\ndamping_ratio = 0.005', 1)
        times = coilsense.sampled_window(2500, 0, 2)
        hit = coilsense.Motion(spring, coilsense.Excitation.impact(0.23, 0.25), coilsense.Mount(damping=coilsense.Damping.modal(0.005)))
        return coilsense.mitigate(spec, hit.signals(times), seeds=1)

    def ctrl_c():
        sent.append(time.perf_counter())
        os.kill(os.getpid(), signal.SIGINT)

    it = {of}
    try:
        threading.Timer(0.2, ctrl_c).start()
        {call}
        print("nobody was interrupted")
    except KeyboardInterrupt:
        print(time.perf_counter() - sent[0], flush=True)
        os._exit(0)  # what was left behind need not be waited for
"""


@pytest.mark.parametrize(("of", "call"), LONG.values(), ids=LONG)
def test_ctrl_c_ends_a_long_call_on_an_array(of: str, call: str) -> None:
    script = textwrap.dedent(INTERRUPTED).format(of=of, call=call)
    done = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, timeout=120)
    assert done.returncode == 0, done.stderr
    # A twentieth of a second by itself; a machine that does something else may be slow.
    assert float(done.stdout) < 1
