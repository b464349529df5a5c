"""Files of instruments and of MATLAB, written by their own libraries, come in with the numbers that these libraries read, bit by bit.

Each row of `WRITERS` is a writer: at the first try, after the line that the error printed, or refused with a line that converts.
"""

import ast
import collections.abc
import dataclasses
import io
import json
import pathlib
import re
import struct
import subprocess
import sys
import typing

import asammdf
import h5py
import nptdms
import numpy
import pandas
import pytest
import scipy.io
import tables
from google.protobuf.type_pb2 import EnumValue
from mcap.reader import make_reader
from mcap.writer import CompressionType
from mcap.writer import Writer as McapWriter
from mcap_protobuf.writer import Writer as ProtobufWriter
from mcap_ros2.writer import Writer as RosWriter

import coilsense

ROWS = 400
TIME = numpy.arange(ROWS) / 2500.0
FORCE = 26.0 + numpy.sin(340.0 * TIME) + 0.01 * numpy.random.default_rng(26).standard_normal(ROWS)
COUNTS = (100 * FORCE - 2600).astype(numpy.int16)
LOG = pandas.DataFrame({"time": TIME, "F_o": FORCE, "F_i": COUNTS})
# What a channel holds in newtons or seconds, by the library that reads it.
Numbers = dict[str, numpy.typing.NDArray[typing.Any]]


@dataclasses.dataclass
class Writer:
    """How a file is written, what its library reads of it, and how often the error's own words have to be followed."""

    name: str
    write: collections.abc.Callable[[pathlib.Path], None]
    truth: collections.abc.Callable[[pathlib.Path], Numbers]
    rounds: int = 0
    columns: dict[str, str | int] = dataclasses.field(default_factory=dict)
    sample_rate: float | None = None


# ---- NI TDMS

WAVE = {"wf_increment": 0.0004, "wf_start_offset": 0.0, "wf_samples": 1, "unit_string": "N"}
LINEAR = {"NI_Number_Of_Scales": 1, "NI_Scaling_Status": "unscaled", "NI_Scale[0]_Scale_Type": "Linear", "NI_Scale[0]_Linear_Slope": 0.01,
          "NI_Scale[0]_Linear_Y_Intercept": 26.0}
POLYNOMIAL = {"NI_Number_Of_Scales": 1, "NI_Scale[0]_Scale_Type": "Polynomial", "NI_Scale[0]_Polynomial_Coefficients_Size": 3,
              **{f"NI_Scale[0]_Polynomial_Coefficients[{place}]": value for place, value in enumerate((26.0, 0.01, 1e-7))}}


def tdms(*channels: tuple[str, typing.Any, dict[str, typing.Any]], parts: int = 1) -> collections.abc.Callable[[pathlib.Path], None]:
    """Channels of one group, in so many segments."""

    def write(path: pathlib.Path) -> None:
        with nptdms.TdmsWriter(path) as file:
            for part in numpy.array_split(numpy.arange(ROWS), parts):
                file.write_segment([nptdms.ChannelObject("run", name, values[part], told) for name, values, told in channels])

    return write


def text(words: str) -> bytes:
    return struct.pack("<I", len(words)) + words.encode()


def told(properties: dict[str, typing.Any], order: str = "<") -> bytes:
    """Properties as a segment's metadata have them."""
    out = struct.pack(order + "I", len(properties))
    for name, value in properties.items():
        out += struct.pack(order + "I", len(name)) + name.encode()
        if isinstance(value, str):
            out += struct.pack(order + "II", 0x20, len(value)) + value.encode()
        else:
            out += struct.pack(order + "Id", 10, value) if isinstance(value, float) else struct.pack(order + "II", 7, value)
    return out


def segment(contents: int, metadata: bytes, data: bytes, order: str = "<", stopped: bool = False) -> bytes:
    following = 2**64 - 1 if stopped else len(metadata) + len(data)
    return b"TDSm" + struct.pack("<I", contents) + struct.pack(order + "IQQ", 4713, following, len(metadata)) + metadata + data


def interleaved(order: str, stopped: bool) -> collections.abc.Callable[[pathlib.Path], None]:
    """Two channels value by value; chunks that repeat, a segment without metadata, and perhaps one that was cut off in a row."""

    def write(path: pathlib.Path) -> None:
        metadata = struct.pack(order + "I", 2)
        for name, kind in [("F_o", 10), ("F_i", 3)]:
            place = f"/'run'/'{name}'"
            metadata += struct.pack(order + "I", len(place)) + place.encode() + struct.pack(order + "IIIQ", 20, kind, 1, 100) + told(WAVE, order)
        rows = numpy.rec.fromarrays([FORCE, COUNTS.astype(numpy.int32)], dtype=[("a", order + "f8"), ("b", order + "i4")]).tobytes()
        big = 1 << 6 if order == ">" else 0
        end = 12 * ROWS - (7 if stopped else 0)
        path.write_bytes(segment(1 << 1 | 1 << 2 | 1 << 3 | 1 << 5 | big, metadata, rows[:2400], order)
                         + segment(1 << 3 | 1 << 5 | big, b"", rows[2400:end], order, stopped))

    return write


def card(path: pathlib.Path) -> None:
    """A DAQmx card: its own 16 bits with a scale, beside a digital line."""
    metadata = struct.pack("<I", 2)
    scales = {"NI_Number_Of_Scales": 2, "NI_Scaling_Status": "unscaled", "NI_Scale[1]_Scale_Type": "Linear", "NI_Scale[1]_Linear_Slope": 0.01,
              "NI_Scale[1]_Linear_Y_Intercept": 26.0, "NI_Scale[1]_Linear_Input_Source": 0}
    metadata += text("/'run'/'F_o'") + struct.pack("<IIIQI", 0x1269, 0xFFFFFFFF, 1, 100, 1) + struct.pack("<IIIII", 3, 0, 0, 0, 0)
    metadata += struct.pack("<II", 1, 3) + told({**WAVE, **scales})
    metadata += text("/'run'/'F_i'") + struct.pack("<IIIQI", 0x126A, 5, 1, 100, 1) + struct.pack("<IIIBI", 0, 0, 17, 0, 0)
    metadata += struct.pack("<II", 1, 3) + told(WAVE)
    rows = numpy.rec.fromarrays([COUNTS, (COUNTS & 2).astype("u1")], dtype=[("a", "<i2"), ("b", "u1")]).tobytes()
    path.write_bytes(segment(1 << 1 | 1 << 2 | 1 << 3 | 1 << 7, metadata, rows[:900]) + segment(1 << 3 | 1 << 7, b"", rows[900:]))


def tdms_truth(path: pathlib.Path) -> Numbers:
    channels = nptdms.TdmsFile.read(path)["run"].channels()
    return {channel.name: channel[:] for channel in channels}


# ---- MATLAB

def matlab(**settings: typing.Any) -> collections.abc.Callable[[pathlib.Path], None]:
    return lambda path: scipy.io.savemat(path, {"time": TIME, "F_o": FORCE.reshape(-1, 1), "F_i": COUNTS, "rate": 2500.0}, **settings)


def structs(path: pathlib.Path) -> None:
    scipy.io.savemat(path, {"run": {"time": TIME, "cell": {"F_o": FORCE}, "F_i": COUNTS.astype(numpy.uint8)}}, do_compression=True)


def matlab_truth(path: pathlib.Path) -> Numbers:
    found = scipy.io.loadmat(path)
    return {name: found[name].ravel() for name in ("time", "F_o", "F_i")}


def structs_truth(path: pathlib.Path) -> Numbers:
    run = scipy.io.loadmat(path, simplify_cells=True)["run"]
    return {"time": run["time"], "F_o": run["cell"]["F_o"], "F_i": run["F_i"]}


def matlab_7_3(path: pathlib.Path) -> None:
    with h5py.File(path, "w", userblock_size=512) as file:
        columns: Numbers = {"time": TIME, "F_o": FORCE, "F_i": COUNTS}
        for name, values in columns.items():
            file.create_dataset(name, data=values.reshape(1, -1), chunks=(1, 100), compression="gzip")
            file[name].attrs["MATLAB_class"] = numpy.bytes_("int16" if values is COUNTS else "double")
    with path.open("r+b") as opened:
        opened.write(b"MATLAB 7.3 MAT-file, as MATLAB lays it out".ljust(116) + bytes(8) + b"\x00\x02IM")


# ---- HDF5

def hdf5(file_settings: dict[str, typing.Any], settings: dict[str, typing.Any], order: str = "<") -> collections.abc.Callable[[pathlib.Path], None]:
    def write(path: pathlib.Path) -> None:
        with h5py.File(path, "w", **file_settings) as file:
            run = file.create_group("run")
            for name, values, unit in [("time", TIME.astype(order + "f8"), "s"), ("F_o", FORCE.astype(order + "f8"), "N"), ("F_i", COUNTS.astype(order + "i2"), "N")]:
                run.create_dataset(name, data=values, **settings)
                run[name].attrs["unit"] = unit

    return write


def frame(**settings: typing.Any) -> collections.abc.Callable[[pathlib.Path], None]:
    return lambda path: LOG.to_hdf(path, key="run", format="table", data_columns=True, **settings)


def pytables(path: pathlib.Path) -> None:
    with tables.open_file(path, "w") as file:
        file.create_table("/", "run", LOG.to_records(index=False), filters=tables.Filters(complevel=5, complib="zlib", shuffle=True))


def hdf5_truth(path: pathlib.Path) -> Numbers:
    with h5py.File(path) as file:
        within = file["run"] if "run" in file else file
        within = within["table"] if isinstance(within, h5py.Group) and "table" in within else within
        return {name: within[name][()].ravel() for name in ("time", "F_o", "F_i")}


# ---- MDF 2 and 3

def mdf(version: str, suffix: str = "mdf") -> collections.abc.Callable[[pathlib.Path], None]:
    def write(path: pathlib.Path) -> None:
        file = asammdf.MDF(version=version)
        file.append([asammdf.Signal(FORCE, TIME, name="F_o", unit="N"),
                     asammdf.Signal(COUNTS, TIME, name="F_i", unit="N", conversion={"a": 0.01, "b": 26.0})])
        written = file.save(path.with_suffix("." + suffix), overwrite=True)
        pathlib.Path(written).rename(path)

    return write


def mdf_truth(path: pathlib.Path) -> Numbers:
    with asammdf.MDF(io.BytesIO(path.read_bytes())) as file:
        return {"time": file.get("F_o").timestamps, **{name: file.get(name).samples for name in ("F_o", "F_i")}}


# ---- MCAP

STAMPS = [1_795_262_400_000_000_000 + 400_000 * row for row in range(ROWS)]


def mcap(packing: CompressionType, *, chunks: bool = True) -> collections.abc.Callable[[pathlib.Path], None]:
    def write(path: pathlib.Path) -> None:
        with path.open("wb") as file:
            writer = McapWriter(file, compression=packing, use_chunking=chunks, chunk_size=4000)
            writer.start()
            channel = writer.register_channel("/cell", "json", writer.register_schema("log", "jsonschema", b"{}"))
            for stamp, force, count in zip(STAMPS, FORCE.tolist(), COUNTS.tolist()):
                message = {"F_o [N]": force, "F_i [N]": count, "who": "the rig"}
                writer.add_message(channel, log_time=stamp, publish_time=stamp, data=json.dumps(message).encode())
            writer.finish()

    return write


def mcap_truth(path: pathlib.Path) -> Numbers:
    with path.open("rb") as file:
        messages = [json.loads(message.data) for _, _, message in make_reader(file).iter_messages()]
    return {name: numpy.array([message[f"{name} [N]"] for message in messages]) for name in ("F_o", "F_i")}


def protobuf(path: pathlib.Path) -> None:
    with path.open("wb") as file:
        writer = ProtobufWriter(file)
        for stamp, count in zip(STAMPS, COUNTS.tolist()):
            writer.write_message("/cell", EnumValue(number=count), log_time=stamp)
        writer.finish()


def ros(path: pathlib.Path) -> None:
    with path.open("wb") as file:
        writer = RosWriter(file)
        schema = writer.register_msgdef("rig/Cell", "rig/Force force\n" + 64 * "=" + "\nMSG: rig/Force\nfloat64 x\n")
        for stamp, force in zip(STAMPS, FORCE.tolist()):
            writer.write_message("/cell", schema, {"force": {"x": force}}, log_time=stamp)
        writer.finish()


FIELDS: dict[str, str | int] = {"time": "run.time [s]", "F_o": "run.cell.F_o [N]", "F_i": "run.F_i [N]"}
SECONDS = {"unit_string": "s"}
WRITERS = [
    Writer("npTDMS, waveform", tdms(("F_o", FORCE, WAVE), ("F_i", COUNTS, WAVE)), tdms_truth),
    Writer("npTDMS, channel of time, three segments", tdms(("time", TIME, SECONDS), ("F_o", FORCE, {"unit_string": "N"}), parts=3), tdms_truth),
    Writer("npTDMS, scales", tdms(("F_o", COUNTS, {**WAVE, **LINEAR}), ("F_i", COUNTS, {**WAVE, **POLYNOMIAL})), tdms_truth),
    Writer("npTDMS, no clock", tdms(("F_o", FORCE, {"unit_string": "N"})), tdms_truth, rounds=1, sample_rate=2500.0),
    Writer("npTDMS, no unit", tdms(("F_o", FORCE, {**WAVE, "unit_string": ""})), tdms_truth, rounds=1),
    Writer("TDMS, interleaved", interleaved("<", stopped=False), tdms_truth),
    Writer("TDMS, interleaved, big-endian", interleaved(">", stopped=False), tdms_truth),
    Writer("TDMS, interleaved, stopped in a row", interleaved("<", stopped=True), tdms_truth),
    Writer("TDMS, DAQmx", card, tdms_truth),
    Writer("SciPy, MATLAB 4", matlab(format="4"), matlab_truth, rounds=1),
    Writer("SciPy, MATLAB 5", matlab(), matlab_truth, rounds=1),
    Writer("SciPy, MATLAB 7", matlab(do_compression=True), matlab_truth, rounds=1),
    Writer("SciPy, structs", structs, structs_truth, columns=FIELDS),
    Writer("h5py, as MATLAB 7.3", matlab_7_3, hdf5_truth, rounds=1),
    Writer("h5py, contiguous", hdf5({}, {}), hdf5_truth),
    Writer("h5py, big-endian", hdf5({}, {}, order=">"), hdf5_truth),
    Writer("h5py, gzip, shuffle, fletcher32", hdf5({}, {"chunks": (64,), "compression": "gzip", "shuffle": True, "fletcher32": True}), hdf5_truth),
    Writer("h5py, lzf", hdf5({}, {"chunks": (64,), "compression": "lzf"}), hdf5_truth),
    Writer("h5py, latest, contiguous", hdf5({"libver": "latest"}, {}), hdf5_truth),
    Writer("pandas, table", frame(), hdf5_truth, rounds=1),
    Writer("PyTables, zlib", pytables, hdf5_truth, rounds=1),
    *(Writer(f"asammdf, MDF {version}", mdf(version), mdf_truth) for version in ("3.30", "3.20", "3.10", "3.00", "2.14", "2.10")),
    Writer("asammdf, MDF 4.10", mdf("4.10", "mf4"), mdf_truth),
    Writer("MCAP, JSON", mcap(CompressionType.NONE, chunks=False), mcap_truth),
    Writer("MCAP, JSON, zstd", mcap(CompressionType.ZSTD), mcap_truth),
    Writer("MCAP, JSON, lz4", mcap(CompressionType.LZ4), mcap_truth),
]


@pytest.mark.parametrize("writer", WRITERS, ids=lambda writer: writer.name)
def test_a_file_comes_in_with_the_numbers_of_its_own_library(writer: Writer, tmp_path: pathlib.Path) -> None:
    path = tmp_path / "run.log"
    writer.write(path)
    columns, rounds, recording, rate = dict(writer.columns), 0, None, None
    while recording is None:
        try:
            recording = coilsense.open_log(path, columns or None, sample_rate=rate)
        except coilsense.LogError as error:
            message, rounds = str(error), rounds + 1
            assert rounds <= writer.rounds, message
            assert "\n" not in message
            told = re.search(r"columns=(\{[^}]*\})", message)
            if writer.sample_rate is None:
                assert told is not None, message
                columns |= ast.literal_eval(told[1])
            else:
                assert "sample_rate" in message
                rate = writer.sample_rate
    assert rounds == writer.rounds
    truth = writer.truth(path)
    for name, values in truth.items():
        found = recording.signals.time if name == "time" else recording.signals[name]
        expected = values.astype(float)
        assert found.shape == expected.shape and (found.view(numpy.uint64) == expected.view(numpy.uint64)).all(), name
    if "time" not in truth:
        assert (recording.signals.time == TIME[: len(recording)]).all()


def timetable(path: pathlib.Path) -> None:
    with h5py.File(path, "w", userblock_size=512) as file:
        file["TT"] = numpy.array([[3707764736, 2, 1, 1, 1, 1]], dtype="u4")
        file["TT"].attrs["MATLAB_class"] = numpy.bytes_("timetable")
        file["TT"].attrs["MATLAB_object_decode"] = numpy.int32(3)
    with path.open("r+b") as opened:
        opened.write(b"MATLAB 7.3 MAT-file, as MATLAB lays it out".ljust(116) + bytes(8) + b"\x00\x02IM")


REFUSED = [
    ("MATLAB's timetable", timetable, r'TT is a timetable, which only MATLAB reads; there: S = table2struct\(timetable2table\(TT.*save\("log.mat", "-struct", "S", "-v7"\)$'),
    ("TDMS's index", lambda path: path.write_bytes(b"TDSh" + bytes(60)), "is the index of an NI TDMS file, which holds no data; read the .tdms beside it$"),
    ("pandas, blosc", frame(complib="blosc", complevel=5), "run/table is packed by filter 32001, which is not read; write it anew: python -c '.*'$"),
]


@pytest.mark.parametrize(("write", "words"), [pytest.param(write, words, id=name) for name, write, words in REFUSED])
def test_what_is_not_read_is_refused_with_what_to_do(write: collections.abc.Callable[[pathlib.Path], None], words: str, tmp_path: pathlib.Path) -> None:
    write(tmp_path / "run.log")
    with pytest.raises(coilsense.LogError, match=words) as caught:
        coilsense.open_log(tmp_path / "run.log")
    assert "\n" not in str(caught.value)


CONVERTED = [
    ("HDF5, chunks in the layout of HDF5 2", hdf5({"libver": "latest"}, {"chunks": (64,), "compression": "gzip"}), "log.h5", FORCE, {}),
    ("MCAP, protobuf", protobuf, "log.csv", COUNTS, {"F_o": "number [N]"}),
    ("MCAP, ROS 2", ros, "log.csv", FORCE, {"F_o": "force.x [N]"}),
]


@pytest.mark.parametrize(("write", "converted", "force", "columns"), [pytest.param(*row, id=name) for name, *row in CONVERTED])
def test_the_line_that_is_printed_converts(
    write: collections.abc.Callable[[pathlib.Path], None],
    converted: str,
    force: numpy.typing.NDArray[typing.Any],
    columns: dict[str, str | int],
    tmp_path: pathlib.Path,
) -> None:
    path = tmp_path / "run.log"
    write(path)
    with pytest.raises(coilsense.LogError) as caught:
        coilsense.open_log(path)
    line = re.search(r"python -c '(.*)'$", str(caught.value))
    assert line is not None, str(caught.value)
    subprocess.run([sys.executable, "-c", line[1]], cwd=tmp_path, check=True)
    recording = coilsense.open_log(tmp_path / converted, columns or None)
    assert (recording.signals["F_o"] == force).all() and (recording.signals.time == TIME).all()
