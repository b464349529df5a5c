"""Sweeps on this machine: rows against single designs, folders that are continued, refusals in one line."""

import hashlib
import pathlib
import pickle
import signal
import subprocess
import sys
import textwrap
import time

import numpy
import pandas
import pytest
import sweeps

import coilsense


def test_a_row_is_what_a_single_design_gives(tmp_path: pathlib.Path) -> None:
    dataset = sweeps.whole(tmp_path, rows=12, chunk=5)
    rows = dataset.read()
    assert list(rows["row"]) == list(range(12))
    times = coilsense.sampled_window(10_000, 0.75, 1.0)
    mount = coilsense.Mount(coilsense.FarEnd.position(), coilsense.Damping.modal(0.005))
    parameters = coilsense.Spring.of_paper("S_T").to_dict()
    for row in range(12):
        stiffness, mass = rows["spring.stiffness [N/m]"][row], rows["spring.mass [kg]"][row]
        spring = coilsense.Spring(**{**parameters, "stiffness": stiffness, "mass": mass})
        motion = coilsense.Motion(spring, coilsense.Excitation.impact(0.23, 0.25), mount)
        signals = motion.signals(times)
        share = coilsense.Deviation.between(signals["F_i"], signals["F_x"]).relative_to(spring.nominal_force)
        # The same numbers by another order of sums.
        assert rows["F_i.max[heel strike] [%]"][row] == pytest.approx(100 * share.maximum_absolute, rel=1e-11)
        assert rows["f1 [Hz]"][row] == pytest.approx(spring.surge_frequency, rel=1e-14)


def test_a_plan_is_a_value() -> None:
    plan = coilsense.SweepPlan(sweeps.SPEC, ["spring.mass=50..80 g : 3"], columns=["f1"])
    assert pickle.loads(pickle.dumps(plan)) == plan == coilsense.SweepPlan.from_json(plan.to_json())
    assert plan != coilsense.SweepPlan(sweeps.SPEC, ["spring.mass=50..80 g : 4"], columns=["f1"])
    assert (plan.rows, plan.chunks, plan.rows_of(0), plan.rows_of(1)) == (3, 1, range(3), range(0))
    assert repr(plan) == "<SweepPlan of spec: 3 rows (grid) in 1 chunks>"
    assert plan.to_dict()["over"] == ["spring.mass=50..80 g : 3"]
    assert plan.titles == ["row", "spring.mass [kg]", "status", "reason", "f1 [Hz]"]
    assert len(plan.digest) == 64
    numbers = plan.chunk(0, jobs=1)["spring.mass [kg]"]
    assert numbers.dtype == numpy.float64
    numpy.testing.assert_allclose(numbers, [0.05, 0.065, 0.08], rtol=1e-15)


def test_values_come_as_texts_numbers_and_tables(tmp_path: pathlib.Path) -> None:
    def stiffnesses(name: str, **what: object) -> list[float]:
        arguments = {"columns": ["f1"], **what}
        dataset = coilsense.sweep(sweeps.SPEC, out=tmp_path / name, **arguments)  # type: ignore[arg-type]
        return list(dataset.read(["spring.stiffness [N/m]"])["spring.stiffness [N/m]"])

    values = [600.1, 700.0, 1e3 / 3]
    assert stiffnesses("list", over={"spring.stiffness [N/m]": values}) == values
    assert stiffnesses("array", over={"spring.stiffness [N/m]": numpy.array(values)}) == values
    assert stiffnesses("command", over=["spring.stiffness=600..700 N/m : 2"]) == [600.0, 700.0]
    assert stiffnesses("text", over={"spring.stiffness": "600..700 N/m : 2"}) == [600.0, 700.0]
    table = pandas.DataFrame({"spring.name": ["a", "b", "c"], "spring.stiffness [N/m]": values})
    assert stiffnesses("table", catalogue=table) == values
    path = tmp_path / "springs.csv"
    table.to_csv(path, index=False)
    assert stiffnesses("file", catalogue=path) == values


@pytest.mark.parametrize(
    ("over", "text"),
    [
        ({"spring.stifness": "600..900 N/m"}, "stiffness"),
        ({"spring.stiffness": "900..600 N/m"}, "900"),
        ({"spring.stiffness": "600..900 kg"}, "kg"),
        ({"spring.stiffness": ""}, "spring.stiffness"),
        ({}, "nothing is varied"),
    ],
)
def test_what_cannot_be_is_one_line(tmp_path: pathlib.Path, over: dict[str, str], text: str) -> None:
    with pytest.raises(coilsense.SweepError) as raised:
        coilsense.sweep(sweeps.SPEC, over, tmp_path / "out", rows=3, columns=["f1"])
    assert text in str(raised.value)
    assert "\n" not in str(raised.value)
    assert not (tmp_path / "out").exists()


def test_wrong_arguments_say_which(tmp_path: pathlib.Path) -> None:
    with pytest.raises(TypeError, match="out"):
        coilsense.sweep(sweeps.SPEC, sweeps.OVER)
    with pytest.raises(TypeError, match="over"):
        coilsense.sweep(sweeps.SPEC, "spring.mass=1..2 g", tmp_path)
    with pytest.raises(coilsense.Error, match="sampling must be one of grid"):
        coilsense.SweepPlan(sweeps.SPEC, ["spring.mass=50..80 g"], sampling="latin")  # type: ignore[arg-type]
    with pytest.raises(coilsense.SweepError, match="jobs must be at least 1"):
        coilsense.SweepPlan(sweeps.SPEC, ["spring.mass=50..80 g : 2"], columns=["f1"]).chunk(0, jobs=0)


def test_designs_that_cannot_be_are_rows_with_a_reason(tmp_path: pathlib.Path) -> None:
    over = {"spring.wire_radius [mm]": [1.0, 9.0], "spring.windings": "52, 200"}
    dataset = coilsense.sweep(sweeps.SPEC, over, tmp_path, columns=["f1", "F_o.rmsd"])
    frame = dataset.to_pandas()
    tally = dataset.tally()
    assert (tally["rows"], tally["ok"] + tally["clash"] + tally["refused"]) == (4, 4)
    assert tally["refused"] >= 2
    refused = frame[frame["status"] == "refused"]
    assert refused["F_o.rmsd [%]"].isna().all()
    assert refused["reason"].str.len().min() > 10


def test_a_folder_is_gone_on_with_and_read_by_others(tmp_path: pathlib.Path) -> None:
    dataset = sweeps.whole(tmp_path / "one", rows=40, chunk=10)
    before = sweeps.files(tmp_path / "one")
    plan = dataset.plan
    (tmp_path / "one" / "chunk-000002.parquet").unlink()
    assert coilsense.SweepDataset(tmp_path / "one").missing == [2]
    assert len(coilsense.SweepDataset(tmp_path / "one")) == 30
    told: list[tuple[int, int]] = []
    again = coilsense.sweep(
        sweeps.SPEC, sweeps.OVER, tmp_path / "one", rows=40, chunk=10, columns=sweeps.COLUMNS, seed=7, jobs=1,
        progress=lambda done, of: told.append((done, of)),
    )
    assert told == [(4, 4)]
    assert sweeps.files(tmp_path / "one") == before
    assert again.plan == plan
    with pytest.raises(coilsense.SweepError, match="seed is 8, not 7; take the same options"):
        coilsense.sweep(sweeps.SPEC, sweeps.OVER, tmp_path / "one", rows=40, chunk=10, columns=sweeps.COLUMNS, seed=8)
    with pytest.raises(coilsense.SweepError, match="opened to be read"):
        again.write(0, b"")
    holder = coilsense.SweepDataset(tmp_path / "one", plan)
    with pytest.raises(coilsense.SweepError, match="another run is writing"):
        coilsense.SweepDataset(tmp_path / "one", plan)
    del holder
    assert "40 of 40 rows, 4 of 4 chunks" in repr(again)


SCRIPT = """
    import sys
    sys.path.insert(0, {tests!r})
    import pathlib, sweeps
    print("begun", flush=True)
    sweeps.whole(pathlib.Path(sys.argv[1]), rows={rows}, chunk={chunk})
"""


def script(rows: int, chunk: int) -> list[str]:
    """A process that sweeps into the folder that follows."""
    tests = str(pathlib.Path(__file__).parent)
    return [sys.executable, "-c", textwrap.dedent(SCRIPT).format(tests=tests, rows=rows, chunk=chunk)]


def test_ctrl_c_stops_in_the_middle_of_a_chunk(tmp_path: pathlib.Path) -> None:
    run = subprocess.Popen(
        [*script(rows=1_000_000, chunk=1_000_000), str(tmp_path)],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        # Who runs the tests in the background of a script has Ctrl-C ignored, and children inherit that.
        preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL),
    )
    assert run.stdout is not None
    assert run.stdout.readline() == b"begun\n"
    while not (tmp_path / "_manifest.json").exists():
        time.sleep(0.01)
    run.send_signal(signal.SIGINT)
    _, errors = run.communicate(timeout=20)
    assert b"KeyboardInterrupt" in errors
    assert coilsense.SweepDataset(tmp_path).missing == [0]


def test_runs_that_are_killed_leave_what_an_unbroken_one_leaves(tmp_path: pathlib.Path) -> None:
    sweeps.whole(tmp_path / "unbroken", rows=6000, chunk=100)
    expected = sweeps.files(tmp_path / "unbroken")
    random = numpy.random.default_rng(1)
    killed = 0
    for _ in range(7):
        command = [*script(rows=6000, chunk=100), str(tmp_path / "killed")]
        run = subprocess.Popen(command, stdout=subprocess.PIPE)
        assert run.stdout is not None
        run.stdout.readline()
        time.sleep(random.uniform(0.0, 0.3))
        run.kill()
        killed += run.wait() == -signal.SIGKILL
        run.stdout.close()
        there = sweeps.files(tmp_path / "killed")
        assert all(expected[name] == data for name, data in there.items())  # none is torn
    assert killed > 0
    sweeps.whole(tmp_path / "killed", rows=6000, chunk=100)
    assert sweeps.files(tmp_path / "killed") == expected


def test_a_number_alone_is_varied_by_nothing_and_a_frame_is_a_catalogue(tmp_path: pathlib.Path) -> None:
    pandas = pytest.importorskip("pandas")
    over = {"spring.stiffness [N/m]": pandas.Series([600.0, 700.0]), "spring.mass [kg]": 0.065}
    found = coilsense.sweep(sweeps.SPEC, over, tmp_path / "one", columns="f1").to_pandas()
    assert len(found) == 2
    frame = pandas.DataFrame({"spring.stiffness [N/m]": [600.0, 700.0]})
    with pytest.raises(TypeError, match="over must be .*, got a data frame: its rows are designs; give it as catalogue"):
        coilsense.sweep(sweeps.SPEC, frame, tmp_path / "two", columns="f1")
    same = coilsense.sweep(sweeps.SPEC, catalogue=frame, out=tmp_path / "two", columns="f1").to_pandas()
    assert same["f1 [Hz]"].tolist() == found["f1 [Hz]"].tolist()


def test_what_is_not_as_written_is_refused_and_made_anew(tmp_path: pathlib.Path) -> None:
    sweeps.whole(tmp_path, rows=40, chunk=10)
    before = sweeps.files(tmp_path)
    one, two = tmp_path / "chunk-000001.parquet", tmp_path / "chunk-000002.parquet"
    flipped = bytearray(before[one.name])
    flipped[200] ^= 1
    for data, words in [(bytes(flipped), "is damaged"), (before[two.name], "of another chunk"), (before[one.name][:1000], "is damaged or cut off")]:
        one.write_bytes(data)
        dataset = coilsense.SweepDataset(tmp_path)
        assert dataset.damaged == {}  # only who writes looks through all of it
        for asked in (
            dataset.read,
            dataset.tally,
            dataset.to_pandas,
            lambda: coilsense.pareto(tmp_path, minimize="f1"),
        ):
            with pytest.raises(coilsense.SweepError, match=f"chunk-000001.parquet: .*{words}.*sweep with the same options") as raised:
                asked()
            assert "\n" not in str(raised.value)
        with pytest.warns(UserWarning, match=f"^made anew: chunk 1 .*{words}"):
            sweeps.whole(tmp_path, rows=40, chunk=10)
        assert sweeps.files(tmp_path) == before
    with coilsense.SweepDataset(tmp_path, dataset.plan) as writer:
        with pytest.raises(coilsense.SweepError, match="chunk-000001.parquet: what is to be written there holds rows 20 to 29"):
            writer.write(1, before[two.name])
    assert sweeps.files(tmp_path) == before


def test_a_manifest_that_was_edited_is_refused(tmp_path: pathlib.Path) -> None:
    sweeps.whole(tmp_path, rows=10, chunk=10)
    manifest = tmp_path / "_manifest.json"
    manifest.write_text(manifest.read_text().replace("65 g", "66 g"))
    words = "_manifest.json: has been changed since it was written"
    with pytest.raises(coilsense.SweepError, match=words):
        coilsense.SweepDataset(tmp_path)
    with pytest.raises(coilsense.SweepError, match=words):
        sweeps.whole(tmp_path, rows=10, chunk=10)


def test_the_same_spec_by_another_name_is_the_same_sweep(tmp_path: pathlib.Path) -> None:
    def swept(name: str, text: str) -> dict[str, bytes]:
        (tmp_path / name).write_text(text)
        options = {"rows": 20, "chunk": 10, "columns": ["f1"], "seed": 7}
        coilsense.sweep(tmp_path / name, {"spring.mass": "-8..80 g"}, tmp_path / "out", **options)  # type: ignore[arg-type]
        return sweeps.files(tmp_path / "out")

    before = swept("a.toml", sweeps.SPEC)
    (tmp_path / "out" / "chunk-000000.parquet").unlink()
    assert swept("b.toml", f"# of today\n{sweeps.SPEC}") == before
    with pytest.raises(coilsense.SweepError, match="holds another sweep: the spec .*c.toml says other than .*a.toml did"):
        swept("c.toml", sweeps.SPEC.replace("windings = 52", "windings = 51"))


def test_any_program_can_check_a_chunks_digest(tmp_path: pathlib.Path) -> None:
    dataset = sweeps.whole(tmp_path, rows=40, chunk=10)
    for number, (name, data) in enumerate(sweeps.files(tmp_path).items()):
        before, key, after = data.rpartition(b"coilsense.sha256")
        # Between key and digits stand, in Thrift, that a text follows and how long it is.
        digits, behind = after[2:66], after[66:]
        assert hashlib.sha256(before + key + after[:2] + b"0" * 64 + behind).hexdigest().encode() == digits, name
        for said in (dataset.plan.digest, f"{10 * number} to {10 * number + 9}"):
            assert before.count(said.encode()) == 1, (name, said)


def test_other_readers_pass_over_what_chunks_say_of_themselves(tmp_path: pathlib.Path) -> None:
    parquet = pytest.importorskip("pyarrow.parquet")
    dataset = sweeps.whole(tmp_path, rows=40, chunk=10)
    said = parquet.read_metadata(tmp_path / "chunk-000001.parquet").metadata
    assert said[b"coilsense.plan"].decode() == dataset.plan.digest
    assert (said[b"coilsense.chunk"], said[b"coilsense.rows"], len(said[b"coilsense.sha256"])) == (b"1", b"10 to 19", 64)
    pandas.testing.assert_frame_equal(pandas.read_parquet(tmp_path)[list(dataset.plan.titles)], dataset.to_pandas(), check_dtype=False)
