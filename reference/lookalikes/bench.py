"""The bench of look-alikes: random logs of many kinds with known truth, and how `coilsense identify` judges them.

    python3 reference/lookalikes/bench.py --command target/release/coilsense --logs-per-kind 12
    python3 reference/lookalikes/bench.py --check                        the generator's own tests, without the command
    --seed N, --kinds clean-both,beam    which logs
    --keep DIR                           keeps the logs that were judged wrongly, each with its truth and the answer
    --markdown FILE, --csv FILE          the table, and one line per log; without them the table is printed
    --jobs N                             processes, 1 by default; the runtimes in the table are the command's own

A log is the same for the same seed, kind and number. Kinds: *_kinds.py; scores: score.py.
"""

import argparse
import json
import subprocess
import tempfile
import time
from concurrent.futures import ProcessPoolExecutor
from dataclasses import asdict
from functools import partial
from pathlib import Path

import score
from kinds import KINDS, make

PATIENCE = 60.0  # s for one log


def ask(command, path, arguments):
    """The command's answer to a log, as far as it is scored; its complaint where it has none."""
    began = time.perf_counter()
    try:
        done = subprocess.run([command, "identify", path, "--json", *arguments], capture_output=True, text=True, timeout=PATIENCE)
    except subprocess.TimeoutExpired:
        return {"verdict": "error", "why": f"no answer within {PATIENCE:.0f} s", "seconds": PATIENCE}
    seconds = time.perf_counter() - began
    if done.returncode:
        return {"verdict": "error", "why": (done.stderr.strip() or f"exit code {done.returncode}")[:300], "seconds": seconds}
    said = json.loads(done.stdout)
    named = {"first": "first_frequency_hz", "mass": "mass_kg", "stiffness": "stiffness_n_per_m", "zeta": "damping_ratio"}
    numbers = {name: said.get(key) for name, key in named.items()}
    # What a mount may do to f1 and m is part of their intervals.
    for name, key in {"first": "first_frequency_range_hz", "mass": "mass_range_kg"}.items():
        if numbers[name] and said.get(key):
            numbers[name] |= dict(zip(("low", "high"), said[key]))
    sentences = said.get("answer", []) + said.get("evidence", []) + said.get("record_next", [])
    return {"verdict": said["verdict"], "why": "; ".join(said.get("evidence", [])), "sentences": sentences, "seconds": seconds} | numbers


def judge(task, command, seed, keep):
    """One log made, asked about and scored: a row."""
    kind, number = task
    began = time.perf_counter()
    log = make(kind, seed, number)
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / f"{kind}-{number:03d}.csv"
        log.write(path)
        made = time.perf_counter() - began
        answer = ask(command, path, log.arguments)
        row = score.row(kind, number, log, answer) | {"made in [s]": round(made, 3)}
        if keep and row["wrong"]:
            keep.mkdir(parents=True, exist_ok=True)
            (keep / path.name).write_bytes(path.read_bytes())
            truth = {"truth": asdict(log.truth), "arguments": log.arguments, "answer": answer, "wrong": row["wrong"]}
            (keep / f"{path.stem}.json").write_text(json.dumps(truth, indent=1, default=float) + "\n")
    return row


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--command", default="coilsense", help="the command under test")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--logs-per-kind", type=int, default=12)
    parser.add_argument("--kinds", type=lambda word: word.split(","), default=list(KINDS), metavar="NAME,NAME")
    parser.add_argument("--keep", type=Path, metavar="DIR")
    parser.add_argument("--markdown", type=Path, metavar="FILE")
    parser.add_argument("--csv", type=Path, metavar="FILE")
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--check", action="store_true")
    options = parser.parse_args()
    if options.check:
        import test_lookalikes

        raise SystemExit(test_lookalikes.run())
    unknown = [kind for kind in options.kinds if kind not in KINDS]
    if unknown:
        parser.error(f"no kind {', '.join(unknown)}; there are {', '.join(KINDS)}")
    tasks = [(kind, number) for kind in options.kinds for number in range(options.logs_per_kind)]
    job = partial(judge, command=options.command, seed=options.seed, keep=options.keep)
    if options.jobs > 1:
        with ProcessPoolExecutor(options.jobs) as pool:
            rows = list(pool.map(job, tasks))
    else:
        rows = [job(task) for task in tasks]
    if options.csv:
        score.write_csv(rows, options.csv)
    table = score.table(rows, f"seed {options.seed}, {options.logs_per_kind} logs of each of {len(options.kinds)} kinds")
    if options.markdown:
        options.markdown.write_text(table, encoding="utf-8")
    else:
        print(table)


if __name__ == "__main__":
    main()
