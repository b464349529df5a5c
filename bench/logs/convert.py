"""A CSV to Parquet by polars, read and written in one piece or streamed; prints nothing.

    POLARS_MAX_THREADS=1 python convert.py whole|streamed LOG OUT
"""

import sys

import polars


def main() -> None:
    way, log, out = sys.argv[1:]
    if way == "whole":
        polars.read_csv(log).write_parquet(out)
    else:
        polars.scan_csv(log).sink_parquet(out)


main()
