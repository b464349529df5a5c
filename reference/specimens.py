"""Judges `coilsense analyze` from outside: random specs, and for each a Monte Carlo over springs and instruments.

It shares nothing with the project but the command under test. Specs are made from a seed, so that a finding is a number; 300 take
about 5 minutes on one core.

    python specimens.py --command coilsense --keep /tmp/specimens             compare 300 specs, keep them with their results
    python specimens.py --command coilsense --only 17 --keep /tmp/specimens   one spec again
    python specimens.py --command coilsense --check                           motion and readings against `coilsense simulate`
    --specs N, --seed S  how many specs, and of which seed
    --with-masses        half of the specs say masses_per_winding = 1, for a command that knows the key
    --without KEY,KEY    leaves out keys that the command does not know, such as mass_tolerance,density_tolerance
    --direct             simulates every specimen where otherwise a grid of surge frequencies does

Formulas (those of the motion and of the sensors are in specimens_motion.py; the specs are made by specimens_random.py)
  Error     e(t) = static + error of the specimen's own motion. Static: that of instrument, k and l0 at the sample of the window with the
            largest true nominal force. Mean square: mean of e^2 + noise^2 min(1, 2 B/rate) + resolution^2/12, B the goal's bandwidth.
  Specimen  k (or d, D, n, G), m (or d, D, n, density), l0 rectangular within their tolerances. The coil as a chain: m is scaled so that the
            first surge frequency of a nominal specimen is rectangular from (1 - w) that of a chain of one mass per winding to (1 + w)
            that of a bar, w = max(0.002, 0.25/N). Limits of error and temperature rectangular, calibration normal.
  rms       Root of the mean of the specimens' mean squares; share: of specimens whose root mean square is within the goal.
            Unless end 2 has a mass, forces over k depend on sqrt(k/m) alone: simulated on a grid of it, halved until rms and share
            stand still. With a mass every specimen is simulated. Standard errors from replicates of a scrambled Sobol sequence.
"""

import argparse
import csv
import functools
import json
import math
import subprocess
import tempfile
import time
from pathlib import Path

import numpy as np
from scipy import interpolate, special
from scipy.stats import qmc

from specimens_motion import OUTPUT, STRETCH, Case, Chains, nominal, readout
from specimens_random import SPRING, random_spec, toml

EXPANSION = 12e-6  # of steel [1/K]; it raises k and l0 with temperature
TEMPERATURE_CHANGE = 10.0  # K, the default of [uncertainty]
LARGEST_ERROR = 0.01  # standard error of an rms
GRID_SPECIMENS = 8192  # in each replicate, where a grid does the motion

# ------------------------------------------------------------------------------------------------------------ the specimens

INSTRUMENT = ("surge", "full_scale", "reading", "calibration", "temperature")


def specimens(spec, masses, count, seed):
    """Springs and instruments: `count` points of a scrambled Sobol sequence."""
    points = qmc.Sobol(len(SPRING + INSTRUMENT), rng=seed).random(count).T
    y = dict(zip(SPRING + INSTRUMENT, 2 * points - 1))
    off = {name: y[name] * spec["spring"].get(f"{name}_tolerance", 0.0) for name in SPRING}
    wire, coil, windings = 1 + off["wire_diameter"], 1 + off["coil_diameter"], 1 + off["windings"]
    k = spec["k"] * (1 + off["stiffness"]) * (1 + off["shear_modulus"]) * wire**4 / (coil**3 * windings)
    m = spec["m"] * (1 + off["mass"]) * (1 + off["density"]) * wire**2 * coil * windings
    n = round(spec["spring"]["windings"])
    width = max(0.002, 0.25 / n)
    first = lambda count: math.sin(np.pi / 2 / count) / (np.pi / 2 / count)  # surge frequency of a chain over that of a bar
    low, high = first(n) * (1 - width), 1 + width
    m = m * (first(masses) / (low + (high - low) * (1 + y["surge"]) / 2)) ** 2
    y["calibration"] = special.ndtri(np.clip((1 + y["calibration"]) / 2, 1e-12, 1 - 1e-12))
    motion = {"k": k, "late": off["rest_length"], "root": np.sqrt(k / m), "ratio": spec["mount"].get("end_mass", 0.0) / m}
    return motion | {name: y[name] for name in INSTRUMENT}


def population(spec, masses, count, seed, replicates=8):
    """Replicates of `specimens`, as arrays [replicate, specimen]."""
    draws = [specimens(spec, masses, count, np.random.default_rng([seed, r])) for r in range(replicates)]
    return {name: np.array([y[name] for y in draws]) for name in draws[0]}


def mean_squares(case, s, y, mean, square):
    """Mean square of the total error of every specimen with sensor s, from the moments of its motion's error."""
    k, (force, stretch), deflection = case.spec["k"], case.worst_point, s["kind"] == "deflection"
    warmth, unit = TEMPERATURE_CHANGE * y["temperature"], k if deflection else 1.0  # unit: newtons in a native unit
    gain = s.get("accuracy_reading", 0) * y["reading"] + s.get("calibration_uncertainty", 0) * y["calibration"]
    gain = gain + s.get("temperature_coefficient", 0) * warmth
    grown = EXPANSION * warmth
    true = y["k"] * (1 + grown) * (stretch - y["late"] - grown * case.spec["spring"]["rest_length"])
    static = k * stretch * (1 + gain) - true if deflection else gain * (force + true - k * stretch)
    static = static + unit * s.get("accuracy_full_scale", 0) * s["range"] * y["full_scale"]
    noise, step = (unit * s.get(name, 0) * s["range"] for name in ("noise", "resolution"))
    steady = noise**2 * min(1.0, 2 * (case.band or math.inf) / s.get("sample_rate", case.c["sample_rate"])) + step**2 / 12
    scale = k if case.forced else y["k"]
    return static**2 + 2 * static * scale * mean + scale**2 * square + steady


def answers(case, y, moments):
    """Per sensor: rms over the specimens and its relative standard error, share within the goal, worst specimen."""
    out = []
    for s, (mean, square) in zip(case.spec["sensor"], moments):
        squares = mean_squares(case, s, y, mean, square)
        replicates = squares.mean(1)
        error = replicates.std(ddof=1) / math.sqrt(len(replicates)) / (2 * replicates.mean())
        share = (squares <= case.spec["goal"]["error"] ** 2).mean()
        out.append({"rms": math.sqrt(replicates.mean()), "error": error, "share": share, "worst": math.sqrt(squares.max())})
    return out


def judge(spec, masses, seed, direct=False):
    """Monte Carlo of every condition, damping and sensor of a spec: {(condition, damping, sensor): answer}."""
    out, draw = {}, functools.cache(lambda count: population(spec, masses, count, seed))
    chains = Chains(masses, spec, np.append(draw(GRID_SPECIMENS)["ratio"], nominal(spec)[1]))
    for c in spec["condition"]:
        for zeta in spec["mount"]["damping_ratio"]:
            case = Case(spec, c, zeta, chains)
            found = (by_specimen if direct or not chains.alike else by_grid)(case, draw)
            still = spec["k"] * np.sqrt(case.moments(*nominal(spec))[:, 1, 0])
            for s, own, nominal_rms in zip(spec["sensor"], found, still):
                out[c["name"], zeta, s["name"]] = own | {"nominal": nominal_rms}
    return out


def by_specimen(case, draw, count=256, most=4096):
    """Every specimen simulated, more of them until the standard error is small."""
    while True:
        y = draw(count)
        moments = case.moments(y["root"].ravel(), y["ratio"].ravel())
        found = answers(case, y, moments.reshape(*moments.shape[:2], *y["root"].shape))
        if max(f["error"] for f in found) < LARGEST_ERROR / 2 or count >= most:
            return found
        count *= 2


def by_grid(case, draw, count=GRID_SPECIMENS, most=16 * GRID_SPECIMENS):
    """Motion on a grid of sqrt(k/m), halved until rms and share stand still; a monotone cubic between its points."""
    y = draw(count)
    low, high = y["root"].min(), y["root"].max()
    periods = case.c["window"][1] * nominal(case.spec)[0][0] / 2
    fine = max(case.zeta.min(), 1 / (4 * periods)) * low / 2
    grid = np.linspace(low, high, 1 + 2 ** int(np.clip(math.ceil(math.log2((high - low) / fine)), 5, 10)))
    moments, before, change = case.moments(grid, 0 * grid), None, [math.inf]
    while True:
        found = answers(case, y, interpolate.PchipInterpolator(grid, moments, axis=-1)(np.clip(y["root"], low, high)))
        if before:
            change = [abs(f["rms"] / old["rms"] - 1) for f, old in zip(found, before)]
            moved = [abs(f["share"] - old["share"]) for f, old in zip(found, before)]
        if len(grid) > 8192 or before and max(change + moved) < 0.002:
            break
        half = (grid[1:] + grid[:-1]) / 2
        moments, before = np.concatenate([moments, case.moments(half, 0 * half)], axis=-1), found
        order = np.argsort(np.concatenate([grid, half]))
        grid, moments = np.concatenate([grid, half])[order], moments[..., order]
    while max(f["error"] for f in found) > LARGEST_ERROR / 2 and count < most:
        y = draw(count := 4 * count)
        found = answers(case, y, interpolate.PchipInterpolator(grid, moments, axis=-1)(np.clip(y["root"], low, high)))
    return [f | {"error": math.hypot(f["error"], wrong)} for f, wrong in zip(found, change)]


# ----------------------------------------------------------------------------------------------------------- the comparison


def run(*arguments):
    """Runs the command under test; its complaint ends the comparison of this spec."""
    done = subprocess.run([str(x) for x in arguments], capture_output=True, text=True, errors="replace")
    if done.returncode:
        raise RuntimeError(done.stderr.strip() or f"exit code {done.returncode}")
    return done.stdout


def masses_of(spec, sheet):
    """How many masses the command gives the spring, by its data sheet."""
    return round(spec["spring"]["windings"]) * int(sheet.get("masses_per_winding") or 1)


THERE = {"share": "share_inside_goal", "rms": "rms_over_specimens_n", "worst": "worst_specimen_n"}  # keys of results.json


def compare(spec, path, options):
    """Rows: what the command says of a spec beside the Monte Carlo."""
    run(options.command, "analyze", path, "--out", path.parent)
    results = json.loads((path.parent / "results.json").read_text())
    sheet, rows = results["spring"], []
    for key, printed in (("k", sheet["stiffness_n_per_m"]), ("m", sheet["mass_kg"])):
        if abs(spec[key] / printed - 1) > 1e-9:
            raise RuntimeError(f"{key} is {spec[key]} here and {printed} there")
    for (name, zeta, sensor), own in judge(spec, masses_of(spec, sheet), options.seed, options.direct).items():
        case = next(x for x in results["cases"] if x["condition"] == name and abs(x["damping_ratio"] - zeta) < 1e-12)
        said = next(x for x in case["sensors"] if x["sensor"] == sensor)
        c, s = next(x for x in spec["condition"] if x["name"] == name), next(x for x in spec["sensor"] if x["name"] == sensor)
        by_surge = c["frequency"] / (nominal(spec)[0][0] / 2) if c["kind"] == "harmonic" else math.nan
        row = {"mount": spec["mount"]["end2"], "kind": c["kind"], "f/f1": by_surge, "zeta": zeta, "sensor": s["kind"], "path": path}
        there = {f"{key} there": said.get(name) for key, name in THERE.items()} | {"combined": said["combined_n"]}
        there["nominal there"] = said.get("oscillation_in_band_n", said.get("nominal_n"))
        rows.append(row | {"goal": spec["goal"]["error"]} | there | own | {"ratio": there["combined"] / own["rms"]})
    return rows


COLUMNS = {
    "mount": "5", "kind": "8", "f/f1": "5.2f", "zeta": "7.4g", "sensor": "10", "goal": "9.4g", "combined": "9.4g", "rms there": "9.4g",
    "rms": "9.4g", "error": "7.1%", "ratio": "6.3f", "share there": "11.3f", "share": "6.3f", "worst there": "11.4g", "worst": "9.4g",
    "nominal there": "13.4g", "nominal": "9.4g", "path": "",
}  # fmt: skip


def show(rows, header=True):
    """Prints rows of the comparison; `there` is the command's, forces in N, `error` the standard error of rms."""
    width = {key: int(form.split(".")[0] or 0) for key, form in COLUMNS.items()}
    if header:
        print(" ".join(f"{key:{'>' if '.' in form else '<'}{width[key]}}" for key, form in COLUMNS.items()))
    for r in rows:
        cell = lambda x, key, form: "-".rjust(width[key]) if x is None else format(x, form) if form else str(x)
        print(" ".join(cell(r[key], key, form) for key, form in COLUMNS.items()), flush=True)


def summary(rows):
    """Prints how ratios and shares are spread, and the offenders."""
    ratio, points = np.array([r["ratio"] for r in rows]), (0, 1, 5, 25, 50, 75, 95, 99, 100)
    print(f"\n{len(rows)} rows; combined / rms over specimens\n  percentile " + "".join(f"{p:8d}" for p in points))
    print("  ratio      " + "".join(f"{x:8.3f}" for x in np.percentile(ratio, points)))
    below, above = sum(ratio < 0.95), sum(ratio > 1.1)
    print(f"  within 0.95 to 1.10: {1 - (below + above) / len(ratio):.1%}; below: {below}; above: {above}; least {ratio.min():.3f}")
    print(f"  standard error above 1 %: {sum(r['error'] > LARGEST_ERROR for r in rows)} rows; largest {max(r['error'] for r in rows):.1%}")
    for key in ("rms", "worst", "nominal"):
        known = np.array([r[f"{key} there"] / r[key] for r in rows if r[f"{key} there"] is not None and r[key] > 1e-9 * r["goal"]])
        if len(known):
            least, low, high, most = np.percentile(known, (0, 5, 95, 100))
            print(f"  {key} there / here: {least:.4f} to {most:.4f}, 5 to 95 %: {low:.4f} to {high:.4f}")
    shares = [(abs(r["share there"] - r["share"]), str(r["path"])) for r in rows if r["share there"] is not None]
    if shares:
        far, path = max(shares)
        print(f"  largest |share there - share here|: {far:.3f} in {path}; above 0.03: {sum(x > 0.03 for x, _ in shares)} of {len(shares)}")
    print("\nOffenders (ratio outside 0.95 to 1.10), least ratio first")
    show(sorted((r for r in rows if not 0.95 <= r["ratio"] <= 1.1), key=lambda r: r["ratio"]))


def check(spec, path, options):
    """Largest differences of motion and readings from `coilsense simulate`, as shares of the dynamic peak: (share, what) pairs."""
    run(options.command, "simulate", path, "--out", path.with_name("signals.csv"), "--one-file")
    out, dampings = [], spec["mount"]["damping_ratio"]
    with path.with_name("signals.csv").open(newline="") as file:
        lines = list(csv.DictReader(file))
    chains = Chains(masses_of(spec, json.loads(run(options.command, "spring", path, "--json"))), spec, nominal(spec)[1])
    for c in spec["condition"]:
        of_condition = [x for x in lines if x.get("condition", c["name"]) == c["name"]]
        for i, zeta in enumerate(dampings):
            there = of_condition[i * len(of_condition) // len(dampings) : (i + 1) * len(of_condition) // len(dampings)]
            x = spec["k"] * Case(spec, c, zeta, chains).series(*nominal(spec), 0, len(there) - 1)[0]
            here = {name: x[at] for name, at in OUTPUT.items()}
            for s in spec["sensor"]:
                here[s["name"]] = readout(s, x[STRETCH if s["kind"] == "deflection" else s["end"] - 1], 0, c["sample_rate"])
            for name, y in here.items():
                read = np.array([float(x[f"{name} [N]"]) for x in there]) - spec["k"] * (c["length"] - spec["spring"]["rest_length"])
                out.append((np.abs(read - y).max() / np.abs(x).max(), f"{c['kind']:8} {name} zeta {zeta} {path}"))
    return out


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--command", required=True, help="the command under test")
    parser.add_argument("--specs", type=int, default=300)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--only", type=int, metavar="NUMBER", help="one spec")
    parser.add_argument("--keep", type=Path, metavar="DIR", help="folder for specs and results; without it they are not kept")
    parser.add_argument("--without", default=[], type=lambda word: word.split(","), metavar="KEY,KEY")
    for name in ("with-masses", "direct", "check"):
        parser.add_argument(f"--{name}", action="store_true")
    options = parser.parse_args()
    began, rows, failures = time.monotonic(), [], []
    with tempfile.TemporaryDirectory() as temporary:
        for number in range(options.specs) if options.only is None else [options.only]:
            spec = random_spec(options, number)
            path = (options.keep or Path(temporary)) / f"{number:03d}" / "spec.toml"
            path.parent.mkdir(parents=True, exist_ok=True)
            if options.check:
                spec["sensor"] = [{key: x for key, x in s.items() if key not in ("noise", "resolution")} for s in spec["sensor"]]
            path.write_text(toml(spec))
            try:
                rows += (new := check(spec, path, options) if options.check else compare(spec, path, options))
                if not options.check:
                    show(new, header=len(rows) == len(new))
            except RuntimeError as error:
                failures.append(f"{path}: {error}")
    if options.check:
        print(*(f"{share:.1e} {what}" for share, what in sorted(rows, reverse=True)), sep="\n")
    elif rows:
        summary(rows)
    print(*failures, f"{time.monotonic() - began:.0f} s, {len(failures)} specs failed", sep="\n")


if __name__ == "__main__":
    main()
