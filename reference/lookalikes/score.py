"""Scores of answers beside truths: a row per log, a table over kinds.

Next door: who is asked (bench.py), what is true (record.py).
"""

import csv
import math
import re

OFF = 0.01  # how far f1 may be off, relative
COVERED = ("first", "mass", "stiffness")


def inside(answer, truth, others=()):
    """Whether the 95 % interval of an answer holds the truth; None where either is missing."""
    if answer is None or truth is None:
        return None
    return any(answer["low"] <= value <= answer["high"] for value in (truth, *others))


def turn_said(sentence, channel):
    """Whether a sentence speaks of a channel's sign."""
    return channel in sentence and re.search(r"\bsigns?\b|\bturned\b", sentence) is not None


def row(kind, number, log, answer):
    """What is scored of one log."""
    truth, verdict, first = log.truth, answer["verdict"], answer.get("first")
    said = verdict == "spring"
    off = math.nan
    if truth.is_spring and first:
        off = min((first["value"] / value - 1 for value in (truth.first, *truth.others)), key=abs)
    right = said and truth.is_spring and abs(off) <= OFF
    wrong = ""
    if said and not truth.is_spring:
        wrong = "spring of no spring"
    elif said and not right:
        wrong = "f1 off"
    elif truth.is_spring and verdict == "not the spring":
        wrong = "not the spring of a spring"
    elif verdict == "error":
        wrong = "error"
    cover = {f"{name} inside": inside(answer.get(name), getattr(truth, name), truth.others if name == "first" else ()) for name in COVERED}
    if not right:
        cover = dict.fromkeys(cover)
    return {
        "kind": kind,
        "number": number,
        "is spring": truth.is_spring,
        "forces": sum(name.startswith("F") for name in log.columns),
        "verdict": verdict,
        "f1 [Hz]": first["value"] if first else None,
        "true f1 [Hz]": truth.first,
        "f1 off": None if math.isnan(off) else off,
        "found": right,
        "wrong": wrong,
        "turn said": bool(truth.turned) and any(turn_said(sentence, truth.turned) for sentence in answer.get("sentences", ())),
        **cover,
        "runtime [s]": round(answer["seconds"], 4),
        "why": answer["why"],
    }


def write_csv(rows, path):
    """One line per log."""
    with open(path, "w", encoding="utf-8", newline="") as file:
        writer = csv.DictWriter(file, list(rows[0]), lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)


def percent(part, whole):
    """A share in words; a dash where there is nothing to share."""
    return f"{100 * part / whole:.0f}" if whole else "–"


def shares(rows):
    """The cells of a line of the table."""
    springs = [x for x in rows if x["is spring"]]
    strangers = [x for x in rows if not x["is spring"]]
    count = lambda of, what: sum(x["wrong"] == what for x in of)
    cover = []
    for name in COVERED:
        known = [x[f"{name} inside"] for x in rows if x[f"{name} inside"] is not None]
        cover.append(f"{percent(sum(known), len(known))} ({len(known)})" if known else "–")
    times = sorted(x["runtime [s]"] for x in rows)
    cells = [
        percent(count(strangers, "spring of no spring"), len(strangers)),
        percent(count(springs, "f1 off"), len(springs)),
        percent(sum(x["found"] for x in springs), len(springs)),
        percent(sum(x["verdict"] == "undecided" for x in rows), len(rows)),
        percent(count(springs, "not the spring of a spring"), len(springs)),
        *cover,
        str(count(rows, "error")),
        f"{times[len(times) // 2]:.2f} / {times[-1]:.2f}",
    ]
    return cells


HEADS = (
    "kind", "logs", "spring of none %", "f1 off %", "found %", "undecided %", "not the spring, of one %", "95 % holds f1 %", "m %", "k %", "errors",
    "time, median / most s",
)  # fmt: skip


def table(rows, title):
    """Markdown: a line per kind, then all; the counts that intervals are of stand in brackets."""
    lines = [f"Look-alikes: {title}.", "", "| " + " | ".join(HEADS) + " |", "|---" * len(HEADS) + "|"]
    groups = {}
    for x in rows:
        groups.setdefault(x["kind"], []).append(x)
    for kind, own in groups.items():
        lines.append("| " + " | ".join([kind, str(len(own)), *shares(own)]) + " |")
    summary = {
        "**all springs**": [x for x in rows if x["is spring"]],
        "**of them with both forces**": [x for x in rows if x["is spring"] and x["forces"] == 2],
        "**all others**": [x for x in rows if not x["is spring"]],
        "**all**": rows,
    }
    for name, own in summary.items():
        if own:
            lines.append("| " + " | ".join([name, str(len(own)), *shares(own)]) + " |")
    turned = [x for x in rows if x["kind"] == "sign-turned"]
    if turned:
        said = sum(x["turn said"] and x["found"] for x in turned)
        lines += ["", f"Turned signs: found and said {percent(said, len(turned))} %."]
    return "\n".join(lines) + "\n"
