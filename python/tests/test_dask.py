"""Sweeps on a cluster: real worker processes, killed in the middle; the rows are those of this machine."""

import os
import pathlib
import signal
import subprocess
import sys
import textwrap
import threading
import time

import numpy
import pytest
import sweeps

import coilsense

distributed = pytest.importorskip("distributed", reason="distributed is not installed: pip install 'coilsense[dask]'")

pytestmark = pytest.mark.filterwarnings("default")  # what Dask warns of is not ours

ROWS, CHUNK = 24_000, 200


@pytest.fixture(scope="module")
def expected(tmp_path_factory: pytest.TempPathFactory) -> dict[str, bytes]:
    folder = tmp_path_factory.mktemp("local")
    sweeps.whole(folder, ROWS, CHUNK)
    return sweeps.files(folder)


def on(client: object, folder: pathlib.Path) -> coilsense.SweepDataset:
    return coilsense.sweep(
        sweeps.SPEC, sweeps.OVER, folder, rows=ROWS, chunk=CHUNK, columns=sweeps.COLUMNS, seed=7, client=client  # type: ignore[arg-type]
    )


def pids(client: object) -> list[int]:
    return list(client.run(os.getpid).values())  # type: ignore[attr-defined]


def test_workers_that_are_killed_cost_no_row(tmp_path: pathlib.Path, expected: dict[str, bytes]) -> None:
    options = {"n_workers": 2, "threads_per_worker": 1, "processes": True, "dashboard_address": None}
    random = numpy.random.default_rng(2)
    killed: list[int] = []
    with distributed.LocalCluster(**options) as cluster, distributed.Client(cluster) as client:
        workers = pids(client)
        assert len(set(workers)) == 2

        def kill() -> None:
            # A worker at a time, the other goes on; the nanny starts a new one.
            for turn in range(3):
                while len(sweeps.files(tmp_path)) < 15 * (turn + 1):
                    time.sleep(0.01)
                time.sleep(random.uniform(0.0, 0.2))
                victim = workers[turn % 2] if turn < 2 else next(iter(set(pids_now(cluster)) - set(workers)), None)
                if victim is not None:
                    os.kill(victim, signal.SIGKILL)
                    killed.append(victim)

        killer = threading.Thread(target=kill)
        killer.start()
        dataset = on(client, tmp_path)
        killer.join()
    assert len(killed) >= 2
    assert sweeps.files(tmp_path) == expected
    assert list(dataset.read(["row"])["row"]) == list(range(ROWS))


def pids_now(cluster: object) -> list[int]:
    """Of the cluster's nannies, without asking their workers."""
    return [w.process.pid for w in cluster.workers.values() if w.process is not None]  # type: ignore[attr-defined]


CLIENT = """
    import sys
    sys.path.insert(0, {tests!r})
    import pathlib, distributed, test_dask
    with distributed.Client({address!r}) as client:
        print("begun", flush=True)
        test_dask.on(client, pathlib.Path({folder!r}))
"""


def test_clients_that_are_killed_cost_no_row(tmp_path: pathlib.Path, expected: dict[str, bytes]) -> None:
    options = {"n_workers": 2, "threads_per_worker": 1, "processes": True, "dashboard_address": None}
    random = numpy.random.default_rng(3)
    tests = str(pathlib.Path(__file__).parent)
    with distributed.LocalCluster(**options) as cluster:
        text = textwrap.dedent(CLIENT).format(tests=tests, address=cluster.scheduler_address, folder=str(tmp_path))
        for _ in range(6):
            run = subprocess.Popen([sys.executable, "-c", text], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
            assert run.stdout is not None
            assert run.stdout.readline() == b"begun\n"
            time.sleep(random.uniform(0.0, 0.5))
            run.kill()
            run.wait()
            run.stdout.close()
            assert all(expected[name] == data for name, data in sweeps.files(tmp_path).items())  # none is torn
        with distributed.Client(cluster) as client:
            on(client, tmp_path)
    assert sweeps.files(tmp_path) == expected


def test_a_worker_of_another_kind_is_refused() -> None:
    from coilsense import _sweep

    plan = coilsense.SweepPlan(sweeps.SPEC, ["spring.mass=50..80 g : 3"], columns=["f1"])
    here = (coilsense.__version__, coilsense.simd_path())
    assert _sweep._chunk(plan, here, 0) == (0, plan.chunk_bytes(0))
    with pytest.raises(coilsense.SweepError, match=r"COILSENSE_SIMD=scalar"):
        _sweep._chunk(plan, (here[0], "mmx"), 0)
    with pytest.raises(coilsense.SweepError, match="install the same version"):
        _sweep._chunk(plan, ("0.0.0", here[1]), 0)


def test_an_error_on_a_worker_is_the_clients(tmp_path: pathlib.Path, monkeypatch: pytest.MonkeyPatch) -> None:
    # This process says of itself what its worker cannot be.
    monkeypatch.setattr("coilsense._sweep.simd_path", lambda: "mmx")
    options = {"n_workers": 1, "threads_per_worker": 1, "processes": True, "dashboard_address": None}
    with distributed.LocalCluster(**options) as cluster, distributed.Client(cluster) as client:
        with pytest.raises(coilsense.SweepError, match="a worker computes with the vector instructions"):
            on(client, tmp_path)
    assert sweeps.files(tmp_path) == {}
    assert len(coilsense.SweepDataset(tmp_path).missing) == ROWS // CHUNK
