"""Files of the programs with which people keep tables come in with the values that the programs themselves read, to the last bit.

Each row of the table is a way to write a log, and says what comes of it: it is read at the first try, after one thing is told, or refused with the line that
converts it.
"""

import collections.abc
import datetime
import decimal
import gzip
import os
import pathlib
import re
import shutil
import subprocess
import sys
import typing
import warnings

import duckdb
import numpy
import openpyxl
import pandas
import polars
import pyarrow
import pyarrow.csv
import pyarrow.feather
import pyarrow.parquet
import pytest
import xlsxwriter

import coilsense

ROWS = 60
NAMES = {"time [s]": "time", "F_o [N]": "F_o", "L [H]": "L"}


def log() -> pandas.DataFrame:
    rng = numpy.random.default_rng(7)
    time = numpy.arange(ROWS) / 2500
    return pandas.DataFrame(
        {"time [s]": time, "F_o [N]": 26 + rng.normal(size=ROWS), "L [H]": 3e-6 + 1e-8 * rng.normal(size=ROWS)}
    )


# What writes a log to a path, and what reads the columns that are in it, by their titles.
Write = collections.abc.Callable[..., object]
Read = collections.abc.Callable[..., typing.Any]


class Writer(typing.NamedTuple):
    name: str
    ending: str
    write: Write
    read: Read
    # The columns that are told; the words of a refusal.
    told: dict[str, str | int] = {}
    refused: str = ""


def german(path: pathlib.Path) -> pandas.DataFrame:
    return pandas.read_csv(path, sep=";", decimal=",")


def raw(path: pathlib.Path, **options: typing.Any) -> dict[str, typing.Any]:
    columns = numpy.loadtxt(path, unpack=True, **options)
    return dict(zip(NAMES, columns, strict=True))


def duck(path: pathlib.Path, options: str) -> None:
    table = log()
    with duckdb.connect() as connection:
        connection.register("log", table)
        connection.execute(f"copy (select * from log) to '{path}' ({options})")


def duck_read(path: pathlib.Path) -> dict[str, typing.Any]:
    with duckdb.connect() as connection:
        return dict(connection.execute(f"select * from '{path}'").fetchnumpy())


def arrow_stream(path: pathlib.Path, codec: str | None) -> None:
    table = pyarrow.Table.from_pandas(log())
    with pyarrow.ipc.new_stream(path, table.schema, options=pyarrow.ipc.IpcWriteOptions(compression=codec)) as file:
        file.write_table(table, max_chunksize=25)


def arrow_read(path: pathlib.Path) -> typing.Any:
    with pyarrow.ipc.open_stream(path) as file:
        return file.read_all().to_pandas()


def parquet_of_arrow(path: pathlib.Path, **options: typing.Any) -> None:
    pyarrow.parquet.write_table(pyarrow.Table.from_pandas(log()), path, **options)


def old_feather(path: pathlib.Path) -> None:
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", DeprecationWarning)
        pyarrow.feather.write_feather(log(), path, version=1)


def units_below(path: pathlib.Path) -> None:
    """Titles over a row of units, a remark above, a sheet of settings before."""
    book = openpyxl.Workbook()
    sheet = typing.cast(typing.Any, book.active)
    sheet.title = "settings"
    sheet.append(["rate", 2500, "Hz"])
    sheet = book.create_sheet("run")
    sheet.append(["the rig, second run"])
    sheet.append(["time", "F_o", "L"])
    sheet.append(["s", "N", "H"])
    for row in log().itertuples(index=False):
        sheet.append(list(row))
    book.save(path)


def below(path: pathlib.Path) -> dict[str, typing.Any]:
    sheet = openpyxl.load_workbook(path, data_only=True)["run"]
    rows = numpy.array(list(sheet.iter_rows(min_row=4, values_only=True)), dtype=float)
    return dict(zip(NAMES, rows.T, strict=True))


def by_rows(path: pathlib.Path) -> None:
    """Row by row, the force by a formula whose value stands beside it."""
    with xlsxwriter.Workbook(str(path), {"constant_memory": True}) as book:
        sheet = book.add_worksheet("run")
        sheet.write_row(0, 0, list(NAMES))
        for index, (time, force, inductance) in enumerate(log().itertuples(index=False), start=1):
            sheet.write_number(index, 0, time)
            sheet.write_formula(index, 1, f"={force!r}+0", None, force)
            sheet.write_number(index, 2, inductance)


def uncalculated(path: pathlib.Path) -> None:
    book = openpyxl.Workbook()
    sheet = typing.cast(typing.Any, book.active)
    sheet.append(list(NAMES))
    for index, row in enumerate(log().itertuples(index=False), start=2):
        sheet.append([row[0], f"=2*C{index}", row[2]])
    book.save(path)


def of_r(path: pathlib.Path, separator: str, decimal_sign: str) -> None:
    """As R's write.csv and write.csv2 do: names between quotes, the number of each row in front, 15 digits."""
    lines = [separator.join(f'"{name}"' for name in ["", *NAMES])]
    for index, row in enumerate(log().itertuples(index=False), start=1):
        numbers = [f"{value:.15g}".replace(".", decimal_sign) for value in row]
        lines.append(separator.join([f'"{index}"', *numbers]))
    path.write_text("\n".join(lines) + "\n")


def of_numpy(path: pathlib.Path, **options: typing.Any) -> None:
    numpy.savetxt(path, log().to_numpy(), fmt="%.17g", **options)


# pandas takes it, its stubs do not name it.
ODF: typing.Any = "odf"
OWN_NUMBERS: dict[str, str | int] = {"time": "#1 [s]", "F_o": "#2 [N]", "L": "#3 [H]"}

WRITERS = [
    # Texts
    Writer("pandas", "csv", lambda path: log().to_csv(path, index=False), pandas.read_csv),
    Writer("pandas with its index", "csv", lambda path: log().to_csv(path), pandas.read_csv),
    Writer("pandas, German", "csv", lambda path: log().to_csv(path, index=False, sep=";", decimal=","), german),
    Writer("pandas, UTF-16", "csv", lambda path: log().to_csv(path, index=False, encoding="utf-16"),
           lambda path: pandas.read_csv(path, encoding="utf-16")),
    Writer("pandas, UTF-16 of Excel", "txt", lambda path: log().to_csv(path, index=False, encoding="utf-16", sep="\t"),
           lambda path: pandas.read_csv(path, encoding="utf-16", sep="\t")),
    Writer("pandas, UTF-8 with its mark", "csv", lambda path: log().to_csv(path, index=False, encoding="utf-8-sig"), pandas.read_csv),
    Writer("pandas, gzip", "csv.gz", lambda path: log().to_csv(path, index=False), pandas.read_csv),
    Writer("pandas, zstd", "csv.zst", lambda path: log().to_csv(path, index=False), pandas.read_csv),
    Writer("pandas, gzip without saying so", "csv", lambda path: log().to_csv(path, index=False, compression="gzip"),
           lambda path: pandas.read_csv(path, compression="gzip")),
    Writer("pandas, bzip2", "csv.bz2", lambda path: log().to_csv(path, index=False), pandas.read_csv,
           refused="is compressed by bzip2, which is not read; unpack it first: "),
    Writer("pandas, xz", "csv.xz", lambda path: log().to_csv(path, index=False), pandas.read_csv,
           refused="is compressed by xz, which is not read; unpack it first: "),
    Writer("pandas, zip", "csv.zip", lambda path: log().to_csv(path, index=False), pandas.read_csv,
           refused="is a ZIP archive, which is not read; unpack it first: "),
    Writer("polars", "csv", lambda path: polars.from_pandas(log()).write_csv(path), pandas.read_csv),
    Writer("pyarrow", "csv", lambda path: pyarrow.csv.write_csv(pyarrow.Table.from_pandas(log()), path), pandas.read_csv),
    Writer("DuckDB", "csv", lambda path: duck(path, "format csv"), pandas.read_csv),
    Writer("DuckDB, gzip", "csv.gz", lambda path: duck(path, "format csv, compression gzip"), pandas.read_csv),
    Writer("DuckDB, zstd", "csv.zst", lambda path: duck(path, "format csv, compression zstd"), pandas.read_csv),
    Writer("R's write.csv", "csv", lambda path: of_r(path, ",", "."), pandas.read_csv),
    Writer("R's write.csv2", "csv", lambda path: of_r(path, ";", ","), german),
    Writer("numpy with titles", "txt", lambda path: of_numpy(path, header=",".join(NAMES)), raw),
    Writer("numpy with titles, commas", "csv", lambda path: of_numpy(path, header=",".join(NAMES), delimiter=","),
           lambda path: raw(path, delimiter=",")),
    Writer("numpy", "txt", of_numpy, raw, OWN_NUMBERS),
    Writer("numpy, gzip", "txt.gz", of_numpy, raw, OWN_NUMBERS),
    # Parquet
    *(Writer(f"pandas, {codec}", "parquet", lambda path, codec=codec: log().to_parquet(path, compression=codec), pandas.read_parquet)
      for codec in ("snappy", "gzip", "zstd", "lz4", "brotli", None)),
    *(Writer(f"polars, {codec}", "parquet", lambda path, codec=codec: polars.from_pandas(log()).write_parquet(path, compression=codec),
             lambda path: polars.read_parquet(path).to_dict(as_series=False))
      for codec in ("snappy", "gzip", "zstd", "lz4", "brotli", "uncompressed")),
    *(Writer(f"DuckDB, {codec}, {version}", "parquet",
             lambda path, codec=codec, version=version: duck(path, f"format parquet, compression {codec}, parquet_version {version}"),
             duck_read)
      for codec in ("snappy", "gzip", "zstd", "lz4_raw", "brotli", "uncompressed") for version in ("v1", "v2")),
    Writer("pyarrow, pages of version 2", "parquet",
           lambda path: parquet_of_arrow(path, data_page_version="2.0", row_group_size=25, compression="zstd"), pandas.read_parquet),
    Writer("pyarrow, split bytes", "parquet",
           lambda path: parquet_of_arrow(path, use_dictionary=False, use_byte_stream_split=True, compression="zstd"), pandas.read_parquet),
    # Feather and Arrow
    *(Writer(f"pandas, {codec}", "feather", lambda path, codec=codec: log().to_feather(path, compression=codec), pandas.read_feather)
      for codec in ("lz4", "zstd", "uncompressed")),
    *(Writer(f"polars, {codec}", "arrow", lambda path, codec=codec: polars.from_pandas(log()).write_ipc(path, compression=codec),
             lambda path: polars.read_ipc(path).to_dict(as_series=False))
      for codec in ("lz4", "zstd", "uncompressed")),
    *(Writer(f"polars, stream, {codec}", "arrows",
             lambda path, codec=codec: polars.from_pandas(log()).write_ipc_stream(path, compression=codec),
             lambda path: polars.read_ipc_stream(path).to_dict(as_series=False))
      for codec in ("lz4", "zstd", "uncompressed")),
    *(Writer(f"pyarrow, stream, {codec}", "arrows", lambda path, codec=codec: arrow_stream(path, codec), arrow_read)
      for codec in ("lz4", "zstd", None)),
    Writer("pyarrow, Feather of version 1", "feather", old_feather, lambda _: log(),
           refused="is Feather of version 1, which is not read; convert it by: "),
    # Workbooks
    Writer("pandas, openpyxl", "xlsx", lambda path: log().to_excel(path, index=False, engine="openpyxl"), pandas.read_excel),
    Writer("pandas with its index, openpyxl", "xlsx", lambda path: log().to_excel(path, engine="openpyxl"), pandas.read_excel),
    Writer("pandas, XlsxWriter", "xlsx", lambda path: log().to_excel(path, index=False, engine="xlsxwriter"), pandas.read_excel),
    Writer("pandas, odfpy", "ods", lambda path: log().to_excel(path, index=False, engine=ODF),
           lambda path: pandas.read_excel(path, engine="odf")),
    Writer("polars", "xlsx", lambda path: polars.from_pandas(log()).write_excel(path), pandas.read_excel),
    Writer("openpyxl, units below titles", "xlsx", units_below, below),
    Writer("XlsxWriter, row by row", "xlsx", by_rows, pandas.read_excel),
    Writer("openpyxl, formulas", "xlsx", uncalculated, lambda _: log(), refused='"a formula without a value" is not a number'),
]


def bits(values: typing.Any) -> list[int]:
    return [int(each) for each in numpy.asarray(values, dtype=numpy.float64).view(numpy.uint64)]


def agrees(recording: coilsense.Recording, columns: typing.Any) -> None:
    for title, name in NAMES.items():
        found = recording.signals.time if name == "time" else recording.signals[name]
        assert bits(found) == bits(columns[title]), title


@pytest.mark.parametrize("writer", WRITERS, ids=lambda writer: f"{writer.ending}: {writer.name}")
def test_what_a_program_writes_is_what_is_read(writer: Writer, tmp_path: pathlib.Path) -> None:
    path = tmp_path / f"a run.{writer.ending}"
    writer.write(path)
    if not writer.refused:
        agrees(coilsense.open_log(path, writer.told), writer.read(path))
        return
    with pytest.raises(coilsense.LogError, match=re.escape(writer.refused)) as caught:
        coilsense.open_log(path, writer.told)
    assert "\n" not in str(caught.value)
    if not writer.refused.endswith(": "):
        return
    # What it says can be pasted, and then the log comes in.
    line = str(caught.value).partition(writer.refused)[2]
    if shutil.which(line.split()[0]) is None:
        pytest.skip(f"{line.split()[0]} is not there")
    here = os.pathsep.join([str(pathlib.Path(sys.executable).parent), os.environ["PATH"]])
    before = set(tmp_path.iterdir())
    subprocess.run(line, shell=True, check=True, cwd=tmp_path, env={**os.environ, "PATH": here}, capture_output=True)
    [made] = set(tmp_path.iterdir()) - before
    agrees(coilsense.open_log(made), writer.read(path))


TYPES: dict[str, typing.Any] = {
    "int8": numpy.arange(-30, 30, dtype=numpy.int8),
    "int16": numpy.arange(-30, 30, dtype=numpy.int16) * 1000,
    "int32": numpy.arange(-30, 30, dtype=numpy.int32) * 71_582_788,
    "int64": 2**53 + 1 + 2 * numpy.arange(60, dtype=numpy.int64),
    "uint8": numpy.arange(196, 256, dtype=numpy.uint8),
    "uint16": numpy.arange(65_476, 65_536, dtype=numpy.uint16),
    "uint32": numpy.arange(2**32 - 60, 2**32, dtype=numpy.uint32),
    "uint64": numpy.uint64(2**64 - 1) - 1500 * numpy.arange(60, dtype=numpy.uint64),
    "float16": numpy.linspace(-3, 3, 60).astype(numpy.float16),
    "float32": numpy.linspace(-3, 3, 60).astype(numpy.float32),
    "float64": numpy.linspace(-3, 3, 60) ** 3,
}


def typed(values: typing.Any) -> "pyarrow.Table":
    return pyarrow.table({"time [s]": numpy.arange(ROWS) / 2500, "counts": values})


FORMS: dict[str, tuple[str, collections.abc.Callable[["pyarrow.Table", pathlib.Path], object]]] = {
    "pyarrow": ("parquet", lambda table, path: pyarrow.parquet.write_table(table, path, compression="zstd")),
    "pyarrow, Feather": ("feather", lambda table, path: pyarrow.feather.write_feather(table, path, compression="lz4")),
    "polars": ("parquet", lambda table, path: polars.DataFrame(polars.from_arrow(table)).write_parquet(path)),
    "polars, Arrow": ("arrow", lambda table, path: polars.DataFrame(polars.from_arrow(table)).write_ipc(path, compression="zstd")),
}


def gained(tmp_path: pathlib.Path) -> pathlib.Path:
    """A mapping for counts of any size: a pN each."""
    mapping = tmp_path / "map.toml"
    mapping.write_text('[columns]\nF_o = { column = "counts", gain = "1e-12 N" }\n')
    return mapping


@pytest.mark.parametrize("form", FORMS)
@pytest.mark.parametrize("kind", TYPES)
def test_each_type_of_numbers_is_the_nearest_double(kind: str, form: str, tmp_path: pathlib.Path) -> None:
    ending, write = FORMS[form]
    path = tmp_path / f"run.{ending}"
    write(typed(TYPES[kind]), path)
    found = coilsense.open_log(path, mapping=gained(tmp_path))
    assert bits(found.signals["F_o"]) == bits(TYPES[kind].astype(numpy.float64) * 1e-12)


@pytest.mark.parametrize("form", FORMS)
def test_decimals_and_gaps_are_those_of_the_writer(form: str, tmp_path: pathlib.Path) -> None:
    ending, write = FORMS[form]
    path = tmp_path / f"run.{ending}"
    exact = [None if row == 7 else decimal.Decimal(row * 1234567) / 10**6 for row in range(ROWS)]
    write(typed(pyarrow.array(exact, pyarrow.decimal128(20, 6))), path)
    with pytest.raises(coilsense.LogError, match=":8: F_o has no value"):
        coilsense.open_log(path, mapping=gained(tmp_path))
    found = coilsense.open_log(path, mapping=gained(tmp_path), drop_incomplete=True)
    assert bits(found.signals["F_o"]) == bits([float(value) * 1e-12 for value in exact if value is not None])
    assert found.rows["with a missing value"] == 1


@pytest.mark.parametrize("form", FORMS)
@pytest.mark.parametrize("zone", [None, "UTC", "Europe/Berlin"])
@pytest.mark.parametrize(("unit", "step"), [("ms", 1), ("us", 400), ("ns", 400_001)])
def test_stamps_count_from_the_first(unit: str, step: int, zone: str | None, form: str, tmp_path: pathlib.Path) -> None:
    ending, write = FORMS[form]
    path = tmp_path / f"run.{ending}"
    a_second = {"ms": 10**3, "us": 10**6, "ns": 10**9}[unit]
    ticks = 1_795_262_400 * a_second + step * numpy.arange(ROWS)
    when = pyarrow.array(ticks, pyarrow.timestamp(unit, zone))
    write(pyarrow.table({"when": when, "F_o [N]": numpy.arange(float(ROWS))}), path)
    found = coilsense.open_log(path, {"time": "when"})
    assert bits(found.signals.time) == bits((ticks - ticks[0]) / a_second)


@pytest.mark.parametrize("form", FORMS)
@pytest.mark.parametrize(("unit", "step"), [("ms", 4), ("us", 400), ("ns", 400_001)])
def test_stretches_of_time_need_no_unit(unit: str, step: int, form: str, tmp_path: pathlib.Path) -> None:
    ending, write = FORMS[form]
    path = tmp_path / f"run.{ending}"
    ticks = step * numpy.arange(1, ROWS + 1)
    write(pyarrow.table({"time": pyarrow.array(ticks, pyarrow.duration(unit)), "F_o [N]": numpy.arange(float(ROWS))}), path)
    found = coilsense.open_log(path)
    assert bits(found.signals.time) == bits(ticks / {"ms": 10**3, "us": 10**6, "ns": 10**9}[unit])


@pytest.mark.parametrize("form", FORMS)
@pytest.mark.parametrize(("what", "values"), [("true and false", [True] * ROWS), ("texts", ["12"] * ROWS), ("lists", [[1.0]] * ROWS)])
def test_what_is_no_number_is_none(what: str, values: list[object], form: str, tmp_path: pathlib.Path) -> None:
    ending, write = FORMS[form]
    path = tmp_path / f"run.{ending}"
    write(typed(pyarrow.array(values)), path)
    with pytest.raises(coilsense.LogError, match=f"column 2 \"counts\": it holds {what}"):
        coilsense.open_log(path, mapping=gained(tmp_path))


@pytest.mark.parametrize(("ending", "engine"), [("xlsx", "openpyxl"), ("xlsx", "xlsxwriter"), ("ods", "odf")])
def test_instants_of_a_workbook_count_from_midnight(ending: str, engine: typing.Any, tmp_path: pathlib.Path) -> None:
    path = tmp_path / f"run.{ending}"
    noon = datetime.datetime(2026, 11, 21, 12)
    when = [noon + row * datetime.timedelta(milliseconds=4) for row in range(ROWS)]
    pandas.DataFrame({"when": when, "F_o [N]": numpy.arange(float(ROWS))}).to_excel(path, index=False, engine=engine)
    found = coilsense.open_log(path, {"time": "when"})
    assert bits(found.signals.time) == bits([(instant - noon.replace(hour=0)).total_seconds() for instant in when])


def test_a_sheet_is_told_by_the_mapping(tmp_path: pathlib.Path) -> None:
    path = tmp_path / "run.xlsx"
    with pandas.ExcelWriter(path) as book:
        for number in (1, 2):
            (number * log()).to_excel(book, sheet_name=f"Run {number}", index=False)
    first = coilsense.open_log(path)
    assert 'sheet "Run 1" (numbers are in "Run 2", too; sheet = "Run 2" under [log] of a mapping takes that)' in str(first)
    agrees(first, pandas.read_excel(path))
    mapping = tmp_path / "map.toml"
    mapping.write_text('[log]\nsheet = "Run 2"\n')
    agrees(coilsense.open_log(path, mapping=mapping), pandas.read_excel(path, sheet_name="Run 2"))
    mapping.write_text('[log]\nsheet = "Run 3"\n')
    with pytest.raises(coilsense.LogError, match='no sheet is called "Run 3"; it has "Run 1", "Run 2"'):
        coilsense.open_log(path, mapping=mapping)


def test_a_gzip_that_is_cut_off_gives_no_rows(tmp_path: pathlib.Path) -> None:
    path = tmp_path / "run.csv.gz"
    packed = gzip.compress(log().to_csv(index=False).encode())
    path.write_bytes(packed[:-20])
    with pytest.raises(coilsense.LogError, match="is cut off: its gzip data break off before their end"):
        coilsense.open_log(path, drop_incomplete=True)


def test_standard_input_is_left_to_the_command() -> None:
    with pytest.raises(coilsense.LogError, match='got "-": standard input is read by the command only'):
        coilsense.open_log("-")
