"""Runs a sweep here or on a Dask cluster: the same chunks, the same bytes, the same folder."""

from __future__ import annotations

import os
from collections.abc import Callable, Generator, Iterable, Mapping, Sequence
from contextlib import closing, suppress
from itertools import islice
from typing import TYPE_CHECKING, Any, Literal
from warnings import warn

from coilsense._coilsense import Spec, SweepDataset, SweepError, SweepPlan, __version__, simd_path

if TYPE_CHECKING:
    from distributed import Client, Future

#: What ``over`` takes: the command's texts, or values by key.
Over = Sequence[str] | Mapping[str, Any]

#: Chunks by number, as they are computed.
Chunks = Generator[tuple[int, bytes], None, None]

#: What a chunk needs of where it is computed: coilsense of one version, on one path of vector instructions.
Needs = tuple[str, str]


def sweep(
    spec: Spec | str | os.PathLike[str],
    over: Over = (),
    out: str | os.PathLike[str] | None = None,
    *,
    catalogue: Any = None,
    sampling: Literal["grid", "lhs", "monte-carlo", "sobol", "saltelli"] | None = None,
    rows: int | None = None,
    seed: int = 0,
    columns: str | Iterable[str] = (),
    chunk: int | None = None,
    jobs: int | None = None,
    client: Client | None = None,
    progress: Callable[[int, int], object] | None = None,
) -> SweepDataset:
    """Judge many designs: a spec with some of its values replaced, row by row, into a folder of Parquet files.

    A folder that a killed run left is gone on with, and then holds the same files as after an unbroken one. Chunks that are not as they were written,
    damaged, cut off or copied over another, are made anew; a `UserWarning` names them.

    Parameters
    ----------
    spec : Spec, path-like, or str
        The spec whose values are varied: itself, a file, or its text where that holds a line break.
    over : mapping, or sequence of str
        What is varied. ``{"spring.stiffness": "600..900 N/m", "spring.mass [kg]": [0.05, 0.065]}``: values as the command takes them, or a series of
        numbers in the unit that stands in brackets behind the key (none behind a key without unit), or of texts. A sequence holds the command's
        ``"KEY=VALUES"``.
    out : path-like
        The folder.
    catalogue : path-like, or pandas.DataFrame, optional
        A table whose titles are keys (``"spring.stiffness [N/m]"``) and whose rows are designs.
    sampling : {"grid", "lhs", "monte-carlo", "sobol", "saltelli"}, optional
        How rows are laid; without it a grid where all variables have points, else a Latin hypercube.
    rows : int, optional
        How many rows, for each of the catalogue where there is one; a grid has its own number.
    seed : int
        Of all randomness: row k is a function of this seed and k alone.
    columns : str or iterable of str, optional
        What is recorded: ``"mass"``, ``"F_o.rmsd"``, ``"F_o.max[heel strike]"``, ``"laser.combined"`` ...
    chunk : int, optional
        Rows of a file; without it by how long a row takes.
    jobs : int, optional
        Threads here; without it as many as there are cores. On a cluster every task has one thread.
    client : distributed.Client, optional
        Computes the chunks on its workers, which need coilsense of the same version; the files are written here.
    progress : callable, optional
        Called with how many chunks are whole, and of how many.

    Returns
    -------
    SweepDataset
        The folder, with all rows.

    Raises
    ------
    SweepError
        For a key, a value or a column that cannot be, a folder that cannot be written or holds another sweep, a worker that would compute other
        digits; what is whole stays.

    Notes
    -----
    Source: the same words and the same rows as the command ``coilsense sweep``; see book/src/guide/sweep.md.
    """
    if out is None:
        raise TypeError("sweep() needs out, the folder of the rows")
    plan = SweepPlan(
        spec,
        _written(over),
        catalogue=_table(catalogue),
        sampling=sampling,
        rows=rows,
        seed=seed,
        columns=[columns] if isinstance(columns, str) else list(columns),
        chunk=chunk,
    )
    # However this ends, the folder and the workers are let go of at once: a traceback may keep everything here alive for as long as it likes.
    with SweepDataset(out, plan) as dataset:
        # The folder's own, which may call the same spec otherwise: rows are those of an unbroken run.
        plan = dataset.plan
        missing = dataset.missing
        if damaged := [f"chunk {number} {why}" for number, why in dataset.damaged.items()]:
            others = [f"and {len(damaged) - _TOLD} others"] if len(damaged) > _TOLD else []
            warn(f"made anew: {'; '.join(damaged[:_TOLD] + others)}", stacklevel=2)
        whole = plan.chunks - len(missing)
        with closing(_here(plan, missing, jobs) if client is None else _on(client, plan, missing)) as chunks:
            for index, data in chunks:
                dataset.write(index, data)
                whole += 1
                if progress is not None:
                    progress(whole, plan.chunks)
    return SweepDataset(out)


def _here(plan: SweepPlan, missing: Iterable[int], jobs: int | None) -> Chunks:
    """The chunks one after the other, each on all threads."""
    for index in missing:
        yield index, plan.chunk_bytes(index, jobs)


#: Chunks that a warning names.
_TOLD = 10

#: Chunks that wait at the workers for each of their threads: one is worked on, others are at hand.
_AHEAD = 3


def _on(client: Client, plan: SweepPlan, missing: Sequence[int]) -> Chunks:
    """The chunks as workers finish them; never more of them under way than the workers are kept busy with."""
    from distributed import as_completed

    needs = (__version__, simd_path())
    left = iter(missing)
    # The plan may hold a catalogue of many springs: it goes to the workers once. As a task, not as data, so that it is made anew where the only
    # worker that has it is lost.
    shared = client.submit(SweepPlan.from_json, plan.to_json(), pure=False, key=_key("plan"))
    # Of a client of this kind the answer itself, of an asynchronous one a promise of it.
    asked: Any = client.nthreads()
    threads = sum(asked.values())
    running: set[Future[Any]] = set()
    try:
        # A cluster may still be waiting for its first worker.
        first = [_submit(client, shared, needs, index) for index in islice(left, _AHEAD * max(threads, 1))]
        running.update(first)
        done = as_completed(first)
        for future in done:
            running.discard(future)
            result: tuple[int, bytes] = future.result()
            future.release()
            yield result
            for index in islice(left, 1):
                following = _submit(client, shared, needs, index)
                running.add(following)
                done.add(following)
    finally:
        # After an error, or where nobody wants the rest: workers need not go on.
        with suppress(Exception):
            client.cancel([*running, shared], force=True)


def _submit(client: Client, plan: Any, needs: Needs, index: int) -> Future[Any]:
    """One chunk as a task; earlier chunks first, so that files come in their order."""
    return client.submit(_chunk, plan, needs, index, pure=False, priority=-index, key=_key(f"chunk-{index}"))


def _key(what: str) -> str:
    """A task's name, unlike that of any other run."""
    return f"coilsense-{what}-{os.urandom(4).hex()}"


def _chunk(plan: SweepPlan, needs: Needs, index: int) -> tuple[int, bytes]:
    """A chunk on a worker. Dask runs as many tasks as the worker has threads, so that each has one."""
    version, path = needs
    if __version__ != version:
        raise SweepError(f"a worker has coilsense {__version__}, the client {version}: their last digits may differ; install the same version")
    if simd_path() != path:
        raise SweepError(
            f"a worker computes with the vector instructions {simd_path()}, the client with {path}: their last digits differ; "
            f"set COILSENSE_SIMD on both to what both have, at the least COILSENSE_SIMD=scalar"
        )
    return index, plan.chunk_bytes(index, 1)


def _written(over: Over) -> list[str]:
    """``KEY=VALUES`` as the command takes them."""
    if isinstance(over, str):
        raise TypeError('over must be a mapping or a sequence of "KEY=VALUES", got a str')
    if hasattr(over, "itertuples"):
        raise TypeError("over must be a mapping or a sequence of \"KEY=VALUES\", got a data frame: its rows are designs; give it as catalogue")
    if not isinstance(over, Mapping):
        return list(over)
    return [_pair(key, values) for key, values in over.items()]


def _pair(title: str, values: Any) -> str:
    if isinstance(values, str):
        return f"{title}={values}"
    key, unit = _taken_apart(title)
    # One number is a series of one, and stays as it is.
    items = list(values) if hasattr(values, "__iter__") else [values]
    if items and all(isinstance(item, str) for item in items):
        return f"{key}=" + ", ".join(f'"{item}"' for item in items)
    # The shortest decimals that mean a number: nothing is lost on the way through a text.
    return f"{key}=" + ", ".join(repr(float(item)) for item in items) + (f" {unit}" if unit else "")


def _taken_apart(title: str) -> tuple[str, str]:
    """``"spring.mass [kg]"`` as ``"spring.mass"`` and ``"kg"``."""
    if title.endswith("]") and " [" in title:
        key, _, unit = title[:-1].rpartition(" [")
        return key.strip(), unit.strip()
    return title, ""


def _table(catalogue: Any) -> Any:
    """A data frame as titles and rows of texts; anything else as it is."""
    if catalogue is None or not hasattr(catalogue, "itertuples"):
        return catalogue
    rows = [[_cell(value) for value in row] for row in catalogue.itertuples(index=False, name=None)]
    return [str(title) for title in catalogue.columns], rows


def _cell(value: Any) -> str:
    if isinstance(value, str):
        return value
    if value is None or value != value:
        return ""
    return repr(float(value)) if isinstance(value, float) else str(value)
