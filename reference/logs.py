"""Small logs as other programs write them, for the readers of coilsense-lab to be held against.

Writes into the golden logs of the crate coilsense-lab. `motion.csv` holds the values as 17-digit decimals, which bring back the same doubles; every other
file holds the same values, or what is told here of its narrower type.
"""

import datetime
import decimal
import json
import struct

import asammdf
import h5py
import numpy as np
import nptdms
import openpyxl
import pyarrow as pa
import pyarrow.feather as feather
import pyarrow.parquet as pq
import scipy.io
from mcap.writer import CompressionType, Writer as McapWriter
from odf.opendocument import OpenDocumentSpreadsheet
from odf.table import Table, TableCell, TableRow
from odf.text import P

from golden import LAB

OUT = LAB / "logs"
ROWS = 50


def motion():
    rng = np.random.default_rng(26)
    time = np.arange(ROWS) / 2500.0
    force = 26.0 + np.sin(340.0 * time) + 0.01 * rng.standard_normal(ROWS)
    inductance = 3.3e-6 + 2e-8 * rng.standard_normal(ROWS)
    counts = rng.integers(-2000, 2000, ROWS).astype(np.int16)
    return time, force, inductance, counts


def write_csv(time, force, inductance, counts):
    # What asammdf itself makes of the counts and their conversion.
    converted = asammdf.MDF(OUT / "motion.mf4").get("counts").samples.astype(float)
    with open(OUT / "motion.csv", "w", encoding="ascii", newline="\n") as file:
        file.write("time [s],F_o [N],L [H],counts,converted [mN]\n")
        for row in zip(time, force, inductance, counts, converted):
            file.write(",".join(repr(x.item()) for x in row) + "\n")


def write_parquet(time, force, inductance, counts):
    columns = {"time [s]": time, "F_o [N]": force, "L [H]": inductance, "counts": counts}
    pq.write_table(pa.table(columns), OUT / "motion.parquet", row_group_size=20)
    pq.write_table(pa.table(columns), OUT / "motion-plain.parquet", use_dictionary=False, compression="none", data_page_version="2.0")
    stamps = pa.array(np.round(time * 1e6).astype(np.int64) + 1_795_262_400_000_000, pa.timestamp("us"))
    force_of_some = pa.array([None if row % 7 == 3 else value for row, value in enumerate(force)], pa.float64())
    narrow = {"when": stamps, "F_o [N]": force_of_some, "F_i [N]": pa.array(force.astype(np.float32)), "note": ["x"] * ROWS}
    pq.write_table(pa.table(narrow), OUT / "narrow.parquet")


def write_arrow(time, force, inductance, counts):
    table = pa.table({"time [s]": time, "F_o [N]": force, "L [H]": inductance, "counts": counts})
    feather.write_feather(table, OUT / "motion.feather", compression="lz4", chunksize=20)
    options = pa.ipc.IpcWriteOptions(compression="zstd")
    with pa.ipc.new_stream(OUT / "motion.arrows", table.schema, options=options) as file:
        file.write_table(table, max_chunksize=20)


def write_types():
    """Each type of a column that holds numbers, in eight rows; `types.csv` has the same as the nearest doubles, instants from the first one on."""
    count, stamp = range(8), 1_795_262_400_123_456_789
    parts = [0, 400_000, 800_001, 1_200_000, 1_600_007, 2_000_000, 2_400_000, 90_000_000_000_123]
    money = [decimal.Decimal(x) for x in ("0.1", "-2.345678", "0", "999999.999999", "-0.000001", "3", "1e3", "7.7")]
    columns = {
        "int8": (pa.int8(), [-128, -1, 0, 1, 2, 3, 4, 127], float),
        "uint8": (pa.uint8(), [255, 128, 0, 1, 2, 3, 4, 5], float),
        "uint16": (pa.uint16(), [65_535 - i for i in count], float),
        "int32": (pa.int32(), [-(2**31), *range(7)], float),
        "uint32": (pa.uint32(), [2**32 - 1 - i for i in count], float),
        "int64": (pa.int64(), [2**53 + 1 + 2 * i for i in count], float),
        "uint64": (pa.uint64(), [2**64 - 1 - 1500 * i for i in count], float),
        "float16": (pa.float16(), [np.float16(x) for x in (0.1, -2.5, 6e-8, 65_504, 1, 2, 3, 4)], float),
        "float32": (pa.float32(), [float(np.float32(x)) for x in (0.1, -2.5, 1e-40, 3e38, 1, 2, 3, 4)], float),
        "gaps": (pa.float64(), [0.1, None, 0.3, None, None, 0.6, 0.7, 0.8], float),
        "gaps in whole numbers": (pa.int64(), [1, None, 3, None, None, 6, 7, 8], float),
        "decimal": (pa.decimal128(12, 6), money, float),
        "long decimal": (pa.decimal128(38, 20), [x / 3 for x in money], float),
        "longer decimal": (pa.decimal256(60, 6), money, float),
        "stamps in s": (pa.timestamp("s"), [stamp // 10**9 + i for i in count], 1),
        "stamps in ms": (pa.timestamp("ms", "UTC"), [stamp // 10**6 + i for i in count], 10**3),
        "stamps in us": (pa.timestamp("us", "Europe/Berlin"), [stamp // 10**3 + i for i in parts], 10**6),
        "stamps in ns": (pa.timestamp("ns"), [stamp + i for i in parts], 10**9),
        "times of day": (pa.time64("us"), [43_200_000_000 + i // 2000 for i in parts], 10**6),
        "days": (pa.date32(), [20_000 + i for i in count], 1 / 86_400),
        "stretches": (pa.duration("ns"), parts, None),
    }
    table = {}
    with open(OUT / "types.csv", "w", encoding="ascii", newline="\n") as file:
        numbers = []
        for name, (kind, values, meaning) in columns.items():
            exact = [x if x is None or not isinstance(x, decimal.Decimal) else round(x, kind.scale) for x in values]
            table[name] = pa.array(exact, kind)
            if meaning is float:
                numbers.append(["" if x is None else repr(float(x)) for x in exact])
            elif meaning is None:
                numbers.append([repr(x / 10**9) for x in exact])
            else:
                numbers.append([repr((x - exact[0]) / meaning) for x in exact])
        file.write(",".join(columns) + "\n")
        file.writelines(",".join(row) + "\n" for row in zip(*numbers))
    others = {"ok": pa.array([True] * 8), "note": pa.array(["x"] * 8), "list": pa.array([[1.0]] * 8), "none": pa.nulls(8)}
    table = pa.table(table | others)
    pq.write_table(table, OUT / "types.parquet", compression="zstd")
    # Other pages, and other encodings than dictionaries.
    pq.write_table(table, OUT / "types-v2.parquet", compression="brotli", data_page_version="2.0", use_dictionary=False, row_group_size=5,
                   column_encoding={"int32": "DELTA_BINARY_PACKED", "int64": "DELTA_BINARY_PACKED", "float32": "BYTE_STREAM_SPLIT",
                                    "long decimal": "DELTA_BYTE_ARRAY", "uint64": "BYTE_STREAM_SPLIT"})
    # Stamps of 96 bits.
    pq.write_table(table, OUT / "types-old.parquet", compression="gzip", use_deprecated_int96_timestamps=True)
    feather.write_feather(table, OUT / "types.feather", compression="zstd", chunksize=5)
    feather.write_feather(table.select([0]), OUT / "old.feather", version=1)


def write_workbooks(time, force, inductance, counts):
    """A sheet of settings, the log below a remark and over a row of units, and five rows with instants, gaps, shares and truth values."""
    noon = datetime.datetime(2026, 11, 21, 12, 0, 0)
    settings = [["device", "rig"], ["rate", 2500, "Hz"]]
    run = [["the rig, 21.11.2026"], ["time", "F_o", "L", "counts"], ["s", "N", "H", ""]]
    run += [[x.item() for x in row] for row in zip(time, force, inductance, counts)]
    stamped = [["five rows"], ["when", "elapsed", "F_o [N]", "share", "ok"]]
    stamped += [[noon + i * datetime.timedelta(milliseconds=4), i * datetime.timedelta(milliseconds=4), None if i == 2 else force[i].item(), 0.05 * i, True]
                for i in range(5)]
    sheets = {"settings": settings, "run": run, "stamped": stamped}
    book = openpyxl.Workbook()
    book.remove(book.active)
    for name, rows in sheets.items():
        sheet = book.create_sheet(name)
        for row in rows:
            sheet.append(row)
    for row in sheet.iter_rows(min_row=3):
        row[0].number_format, row[1].number_format, row[3].number_format = "yyyy-mm-dd hh:mm:ss.000", "[h]:mm:ss.000", "0 %"
    book.save(OUT / "motion.xlsx")
    document = OpenDocumentSpreadsheet()
    for name, rows in sheets.items():
        table = Table(name=name)
        for row in rows:
            cells = TableRow()
            for value in row:
                cells.addElement(cell_of(value))
            table.addElement(cells)
        document.spreadsheet.addElement(table)
    document.save(OUT / "motion.ods")


def cell_of(value):
    """A cell of OpenDocument as LibreOffice writes it."""
    match value:
        case bool():
            return TableCell(valuetype="boolean", booleanvalue="true")
        case datetime.datetime():
            return TableCell(valuetype="date", datevalue=value.isoformat())
        case datetime.timedelta():
            return TableCell(valuetype="time", timevalue=f"PT00H00M{value.total_seconds():06.3f}S")
        case str():
            cell = TableCell(valuetype="string")
            cell.addElement(P(text=value))
            return cell
        case None:
            return TableCell()
    return TableCell(valuetype="float", value=repr(value))


def write_mat(time, force, inductance, counts):
    variables = {"time": time, "F_o": force.reshape(-1, 1), "L": inductance, "counts": counts, "rate": 2500.0,
                 "both": np.column_stack([force, inductance]), "who": "the rig"}
    scipy.io.savemat(OUT / "motion-v5.mat", variables, do_compression=False)
    scipy.io.savemat(OUT / "motion-v7.mat", variables, do_compression=True)
    scipy.io.savemat(OUT / "motion-v4.mat", variables, format="4")
    run = {"time": time, "F_o": force.reshape(-1, 1), "cell": {"counts": counts, "offset": 3.0}}
    scipy.io.savemat(OUT / "motion-struct.mat", {"run": run, "L": inductance}, do_compression=True)


def write_mdf(time, force, inductance, counts):
    mdf = asammdf.MDF(version="4.10")
    fast = [
        asammdf.Signal(force, time, name="F_o", unit="N"),
        asammdf.Signal(counts, time, name="counts", unit="mN",
                       conversion={"a": 0.5, "b": 3.0}),
    ]
    mdf.append(fast, comment="load cell")
    # Every tenth sample: a slower device in a group of its own.
    mdf.append([asammdf.Signal(inductance[::10], time[::10], name="L", unit="H")], comment="LCR meter")
    mdf.header.start_time = datetime.datetime(2026, 11, 21, 12, 0, 0, tzinfo=datetime.timezone.utc)
    mdf.save(OUT / "motion.mf4", overwrite=True)
    mdf.save(OUT / "motion-packed.mf4", overwrite=True, compression=1)
    old = asammdf.MDF(version="3.30")
    old.append(fast, comment="load cell")
    old.append([asammdf.Signal(inductance[::10], time[::10], name="L", unit="H")], comment="LCR meter")
    old.append([asammdf.Signal((counts > 0).astype("u1"), time, name="state", conversion={"val_0": 0, "text_0": b"off", "val_1": 1, "text_1": b"on"})])
    old.header.start_time = mdf.header.start_time
    old.save(OUT / "motion.mdf", overwrite=True)


LINEAR = {"NI_Number_Of_Scales": 1, "NI_Scaling_Status": "unscaled", "NI_Scale[0]_Scale_Type": "Linear",
          "NI_Scale[0]_Linear_Slope": 0.5, "NI_Scale[0]_Linear_Y_Intercept": 3.0, "NI_Scale[0]_Linear_Input_Source": 0xFFFFFFFF}


def write_tdms(time, force, inductance, counts):
    columns = [("time", time, {"unit_string": "s"}), ("F_o", force, {"unit_string": "N"}), ("L", inductance, {"unit_string": "H"}),
               ("counts", counts, {"unit_string": "mN", **LINEAR})]
    with nptdms.TdmsWriter(OUT / "motion.tdms") as file:
        for part in (slice(20), slice(20, 40), slice(40, 50)):
            file.write_segment([nptdms.ChannelObject("run", name, values[part], told) for name, values, told in columns])
    # LabVIEW's waveforms: no column of time, an increment for each channel.
    fast, slow = ({"wf_increment": step, "wf_start_offset": 0.0, "wf_samples": 1} for step in (0.0004, 0.004))
    with nptdms.TdmsWriter(OUT / "motion-wave.tdms") as file:
        file.write_segment([nptdms.ChannelObject("cell", "F_o", force, {**fast, "NI_UnitDescription": "Newtons"}),
                            nptdms.ChannelObject("meter", "L", inductance[::10], {**slow, "unit_string": "H"}),
                            nptdms.ChannelObject("meter", "note", ["a", "b"])])


def text(value):
    return struct.pack("<I", len(value)) + value.encode()


def property_of(name, value):
    if isinstance(value, str):
        return text(name) + struct.pack("<I", 0x20) + text(value)
    return text(name) + (struct.pack("<Id", 10, value) if isinstance(value, float) else struct.pack("<II", 7, value))


def card_channel(name, byte, rows, told):
    """A DAQmx channel: one scaler of 16 bits at a byte of a row of 4, by a format changing scaler."""
    index = struct.pack("<IIIQI", 0x1269, 0xFFFFFFFF, 1, rows, 1) + struct.pack("<IIIII", 3, 0, byte, 0, 0) + struct.pack("<II", 1, 4)
    return text(f"/'card'/'{name}'") + index + struct.pack("<I", len(told)) + b"".join(property_of(*each) for each in told.items())


def write_card(counts):
    """What a card leaves: its own numbers with scales, chunks that repeat, a segment without metadata, and one cut off in a row."""
    scales = {"NI_Number_Of_Scales": 2, "NI_Scaling_Status": "unscaled", "NI_Scale[1]_Scale_Type": "Linear",
              "NI_Scale[1]_Linear_Slope": 0.5, "NI_Scale[1]_Linear_Y_Intercept": 3.0, "NI_Scale[1]_Linear_Input_Source": 0}
    told = {"unit_string": "mN", "wf_increment": 0.0004, "wf_start_offset": 0.0, **scales}
    metadata = struct.pack("<I", 2) + card_channel("F_o", 0, 10, told) + card_channel("F_i", 2, 10, told)
    rows = np.stack([counts, -counts], axis=1).astype("<i2").tobytes()
    with open(OUT / "motion-card.tdms", "wb") as file:
        both = 1 << 1 | 1 << 2 | 1 << 3 | 1 << 7
        file.write(struct.pack("<4siIQQ", b"TDSm", both, 4713, len(metadata) + 80, len(metadata)) + metadata + rows[:80])
        file.write(struct.pack("<4siIQQ", b"TDSm", 1 << 3 | 1 << 7, 4713, 40, 0) + rows[80:120])
        file.write(struct.pack("<4siIQQ", b"TDSm", 1 << 3 | 1 << 7, 4713, 2**64 - 1, 0) + rows[120:190])


def write_mcap(time, force, inductance, counts):
    nanoseconds = 1_795_262_400_000_000_000 + np.round(time * 1e9).astype(int)
    for name, packing in [("motion.mcap", CompressionType.ZSTD), ("motion-lz4.mcap", CompressionType.LZ4)]:
        with open(OUT / name, "wb") as file:
            writer = McapWriter(file, compression=packing, chunk_size=1500)
            writer.start()
            schema = writer.register_schema("log", "jsonschema", b"{}")
            cell, meter = (writer.register_channel(topic, "json", schema) for topic in ("/cell", "/meter"))
            for row, at in enumerate(nanoseconds.tolist()):
                message = {"F_o [N]": force[row].item(), "raw": {"counts": counts[row].item()}, "who": "the rig"}
                writer.add_message(cell, log_time=at, publish_time=at, data=json.dumps(message).encode())
                if row % 10 == 0:
                    writer.add_message(meter, log_time=at, publish_time=at, data=json.dumps({"L [H]": inductance[row].item()}).encode())
            writer.finish()
    with open(OUT / "proto.mcap", "wb") as file:
        writer = McapWriter(file)
        writer.start()
        schema = writer.register_schema("Force", "protobuf", b"")
        channel = writer.register_channel("/cell", "protobuf", schema)
        writer.add_message(channel, log_time=1, publish_time=1, data=b"\x08\x01")
        writer.finish()


def write_hdf5(time, force, inductance, counts):
    with h5py.File(OUT / "motion.h5", "w") as file:
        run = file.create_group("run")
        run["time"] = time
        run.create_dataset("F_o", data=force, chunks=(16,), compression="gzip", shuffle=True, fletcher32=True)
        run.create_dataset("L", data=inductance.astype(">f8"), chunks=(16,), compression="lzf")
        run["counts"] = counts
        for name, unit in [("time", "s"), ("F_o", "N"), ("L", "H"), ("counts", "mN")]:
            run[name].attrs["unit"] = unit
    rows = np.rec.fromarrays([time, force, counts], names=["time", "F_o", "counts"])
    with h5py.File(OUT / "motion-rows.h5", "w", libver="latest") as file:
        file["log"] = rows
        file["both"] = np.column_stack([force, inductance])
        file["note"] = "the rig"
    # MATLAB writes 7.3 as HDF5 behind a header of its own of 512 bytes, a column as a row.
    with h5py.File(OUT / "motion-v73.mat", "w", userblock_size=512) as file:
        for name, values in [("time", time), ("F_o", force), ("run/L", inductance), ("run/counts", counts.astype(float))]:
            file.create_dataset(name, data=values.reshape(1, -1), chunks=(1, ROWS), compression="gzip")
            file[name].attrs["MATLAB_class"] = np.bytes_("double")
        file["both"] = np.stack([force, inductance])
        file["who"] = np.frombuffer("the rig".encode("utf-16-le"), dtype="<u2").reshape(-1, 1)
        file["who"].attrs["MATLAB_class"] = np.bytes_("char")
    with open(OUT / "motion-v73.mat", "r+b") as file:
        file.write(b"MATLAB 7.3 MAT-file, written by h5py".ljust(116) + bytes(8) + b"\x00\x02IM")
    with h5py.File(OUT / "timetable-v73.mat", "w", userblock_size=512) as file:
        file["TT"] = np.array([[3707764736, 2, 1, 1, 1, 1]], dtype="u4")
        file["TT"].attrs["MATLAB_class"] = np.bytes_("timetable")
        file["TT"].attrs["MATLAB_object_decode"] = np.int32(3)
    with open(OUT / "timetable-v73.mat", "r+b") as file:
        file.write(b"MATLAB 7.3 MAT-file, written by h5py".ljust(116) + bytes(8) + b"\x00\x02IM")


if __name__ == "__main__":
    OUT.mkdir(exist_ok=True)
    values = motion()
    write_parquet(*values)
    write_arrow(*values)
    write_types()
    write_workbooks(*values)
    write_mat(*values)
    write_mdf(*values)
    write_csv(*values)
    write_tdms(*values)
    write_card(values[3])
    write_hdf5(*values)
    write_mcap(*values)
