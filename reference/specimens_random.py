"""Random specs for specimens.py: springs, mounts, conditions and sensors from a seed, as texts that the command reads."""

import json
import math

import numpy as np

from specimens_motion import F_I, F_O, STRETCH, Case, Chains, nominal

SPRING = ("stiffness", "mass", "rest_length", "wire_diameter", "coil_diameter", "windings", "shear_modulus", "density")
SHEAR_MODULUS, DENSITY = 81.5e9, 7850.0  # steel EN 10270-1 [Pa, kg/m3]
UNITS = {
    "delay": "s", "averaging": "s", "begin": "s", "rise_time": "s", "width": "s", "duration": "s", "window": "s", "bandwidth": "Hz",
    "sample_rate": "Hz", "frequency": "Hz", "phase": "rad", "velocity": "m/s", "amplitude": "m", "range": "N", "error": "N",
    "stiffness": "N/m", "mass": "kg", "end_mass": "kg", "temperature_coefficient": "%/K", "shear_modulus_temperature": "%/K",
    "shear_modulus": "Pa", "density": "kg/m3", "rest_length_tolerance": "m",
    **dict.fromkeys(("length", "rest_length", "min_length", "max_length"), "m"),
    **dict.fromkeys(("wire_diameter", "coil_diameter", "wire_radius", "coil_radius"), "m"),
    **dict.fromkeys(("noise", "resolution", "accuracy_full_scale", "accuracy_reading", "calibration_uncertainty"), "%"),
    **{f"{name}_tolerance": "%" for name in SPRING if name != "rest_length"},
}  # fmt: skip


def toml(spec):
    """The spec as the command reads it."""
    lines = []
    for name in ("spring", "mount", "condition", "sensor", "goal"):
        for entries in spec[name] if isinstance(spec[name], list) else [spec[name]]:
            lines.append(f"[[{name}]]" if isinstance(spec[name], list) else f"[{name}]")
            units = UNITS | ({"range": "m"} if entries.get("kind") == "deflection" else {})
            units |= {"amplitude": "N"} if spec["mount"]["end2"] != "held" and entries.get("end") == 2 else {}
            for key, value in entries.items():
                unit = units.get(key, "")
                worded = lambda x: f'"{x * (100 if unit.startswith("%") else 1):.9g} {unit}"' if unit else json.dumps(x)
                lines.append(f"{key} = " + (f"[{', '.join(map(worded, value))}]" if isinstance(value, list) else worded(value)))
    return "\n".join(lines) + "\n"


class Chance:
    """Random choices, rounded as they stand in a spec."""

    def __init__(self, *seed):
        self.rng = np.random.default_rng(seed)

    def even(self, low, high, digits=5):
        return float(f"{self.rng.uniform(low, high):.{digits}g}")

    def log(self, low, high, digits=5):
        return float(f"{math.exp(self.rng.uniform(math.log(low), math.log(high))):.{digits}g}")

    def percent(self, most):
        return self.even(0, most, 3) / 100

    def pick(self, *choices):
        return choices[self.rng.integers(len(choices))]


def random_spring(chance):
    """A steel spring, pushed or pulled, by values or by geometry; wire and coil follow from windings, surge frequency and index."""
    wire = 0.0
    while not 0.3e-3 < wire < 20e-3:
        n, surge, index = round(chance.log(4, 80)), chance.log(20, 400), chance.even(5, 12)
        wire = float(f"{math.sqrt(SHEAR_MODULUS / DENSITY / 2) / (2 * math.pi * index**2 * n * surge):.4g}")
    n, coil, pushed = n + chance.pick(0, 0, 0, 0.25, -0.25), float(f"{index * wire:.4g}"), chance.pick(True, False)
    k, m = SHEAR_MODULUS * wire**4 / (8 * coil**3 * n), DENSITY * math.pi**2 / 4 * wire**2 * coil * n
    solid = (n + 2) * wire
    rest = chance.even(1.8 * solid, 3 * solid) if pushed else chance.even(solid, 1.1 * solid)
    if pushed:
        low, high = (chance.even(*(solid + (rest - solid) * np.array(part))) for part in ((0.25, 0.5), (0.6, 0.9)))
    else:
        low = chance.even(1.2 * rest, 1.5 * rest)
        high = chance.even(low + 0.2 * rest, low + 0.6 * rest)
    table = {"windings": n, "rest_length": rest, "min_length": low, "max_length": high, "shear_modulus_temperature": 0.0, "model": "chain"}
    if chance.even(0, 1) < 0.3:
        table |= {"wire_diameter": wire, "coil_diameter": coil, "end_type": "closed-ground" if pushed else "hooks"}
        table |= {"shear_modulus": SHEAR_MODULUS, "density": DENSITY}
        most = {"wire_diameter": 1, "coil_diameter": 1.5, "windings": 1, "shear_modulus": 1.5, "density": 1}
    else:
        k, m = float(f"{k:.5g}"), float(f"{m:.5g}")
        table |= {"stiffness": k, "mass": m, "coil_radius": float(f"{coil / 2:.5g}"), "wire_radius": float(f"{wire / 2:.5g}")}
        most = {"stiffness": chance.pick(0, 10, 10, 10), "mass": chance.pick(0, 5)}
    table |= {f"{name}_tolerance": chance.percent(value) for name, value in most.items()}
    table["rest_length_tolerance"] = chance.pick(0.0, chance.even(0, 0.01 * (high - low), 3))
    return {"spring": table, "k": k, "m": m, "nominal_force": k * max(abs(low - rest), abs(high - rest))}


def random_condition(chance, spec, name):
    """A condition, as loud at the ends of the nominal spring as 0.1 to 2 times the goal, within bounds."""
    chains = Chains(round(spec["spring"]["windings"]), spec, nominal(spec)[1])
    modes, surge = nominal(spec)[0][0] * chains.modes[0][0] / (2 * np.pi), nominal(spec)[0][0] / 2
    low, high, end2 = spec["spring"]["min_length"], spec["spring"]["max_length"], spec["mount"]["end2"]
    resonance = modes[chance.pick(0, 1) if end2 == "mass" else 0]
    short = ["ramp", "pulse", "sweep", "impact", "step" if min(spec["mount"]["damping_ratio"]) > 0 else "ramp"]
    kind = chance.pick(*["harmonic"] * 6, *short, *(["end-stop"] if end2 == "held" else []))
    c = {"kind": kind, "name": name, "length": chance.even(low, high)}
    c["sample_rate"] = 100 * math.ceil(max(20, surge * chance.even(0.4, 0.6)))
    periods = chance.even(60, 250) if kind in ("harmonic", "sweep") else chance.even(15, 60)
    c["duration"] = round(min(4.0, max(0.3, periods / surge)), 2)
    c["window"] = [round(0.75 * c["duration"], 2) if kind == "harmonic" else 0.0, c["duration"]]
    if kind in ("impact", "end-stop"):
        c |= {"velocity": 1.0, "profile": chance.pick("uniform", "linear")}
        at = chance.pick("min", "max")
        c |= {"at": at, "length": {"min": low, "max": high}[at]} if kind == "end-stop" else {}
    else:
        c |= {"end": chance.pick(1, 2), "amplitude": 1.0}
    if kind in ("harmonic", "sweep"):
        c |= {"phase": chance.pick(0.0, chance.even(-3, 3)), "start": chance.pick("massless", "rest")}
        near, away = chance.even(0.88 * resonance, 1.12 * resonance), chance.even(0.2 * resonance, 1.3 * resonance)
        c["frequency"] = chance.pick(*[near] * 5, *[away] * 3, chance.even(0.9 * modes[1], 1.1 * modes[1]))
        if kind == "sweep":
            c["frequency"] = [chance.even(0.1 * resonance, 0.2 * resonance), chance.even(0.8 * resonance, 1.3 * resonance)]
    elif "end" in c:
        c["begin"] = round(chance.even(0, 0.05), 4)
        c |= {"rise_time": chance.log(0.1 / surge, 3 / surge, 4)} if kind == "ramp" else {}
        c |= {"width": chance.log(0.2 / surge, 3 / surge, 4)} if kind == "pulse" else {}
    case = Case(spec, c, spec["mount"]["damping_ratio"][0], chains)
    x = case.series(*nominal(spec), *case.window)[0]
    off = spec["k"] * max(np.sqrt(np.mean((x[out] - x[STRETCH]) ** 2)) for out in (F_I, F_O))
    most = 5.0 if "velocity" in c else 0.1 * (spec["nominal_force"] if case.forced else high - low)
    return c | {"velocity" if "velocity" in c else "amplitude": float(f"{min(spec['goal']['error'] * chance.log(0.1, 2) / off, most):.4g}")}


def random_sensor(chance, spec, name):
    """A load cell at either end or a deflection sensor, with and without filters."""
    s, surge = {"kind": chance.pick("load-cell", "load-cell", "deflection"), "name": name}, nominal(spec)[0][0] / 2
    full = spec["spring"]["max_length"] - spec["spring"]["min_length"] if s["kind"] == "deflection" else spec["nominal_force"]
    s |= {"end": chance.pick(1, 2)} if s["kind"] == "load-cell" else {}
    s |= {"range": chance.even(full, 2 * full), "accuracy_full_scale": chance.percent(0.5)}
    parts = {
        "bandwidth": (0.4, chance.log(0.7 * surge, 8 * surge, 4)), "delay": (0.2, chance.even(0, 0.02 / surge, 3)),
        "averaging": (0.15, chance.even(0.05 / surge, 0.6 / surge, 3)), "sample_rate": (0.2, chance.even(8 * surge, 30 * surge, 4)),
        "noise": (0.35, chance.percent(0.3)), "resolution": (0.35, chance.percent(0.2)), "accuracy_reading": (0.35, chance.percent(0.5)),
        "calibration_uncertainty": (0.35, chance.percent(0.3)), "temperature_coefficient": (0.35, chance.percent(0.02)),
    }  # fmt: skip
    s |= {key: value for key, (often, value) in parts.items() if chance.even(0, 1) < often}
    return s | ({"order": chance.pick(1, 2, 3, 4)} if "bandwidth" in s else {})


def random_spec(options, number):
    """Spec `number` of a seed."""
    chance = Chance(options.seed, number)
    spec = random_spring(chance)
    zetas = [chance.pick(*[chance.log(0.001, 0.05, 3)] * 9, 0.0) for _ in range(chance.pick(1, 1, 1, 1, 2))]
    mount = {"end2": chance.pick(*["held"] * 15, *["mass"] * 3, *["force"] * 2), "damping_ratio": sorted(set(zetas))}
    if mount["end2"] == "mass":
        mount |= {"end_mass": chance.log(2 * spec["m"], 50 * spec["m"])}
        mount |= chance.pick({}, {"first_mode_damping_ratio": chance.log(0.01, 0.3, 3)})
    force, surge = spec["nominal_force"], math.sqrt(spec["k"] / spec["m"]) / 2
    goal = {"error": chance.log(0.005 * force, 0.05 * force), "force": chance.pick(*["F_x"] * 5, "F_i", "F_o")}
    goal |= chance.pick({}, {}, {"bandwidth": chance.log(0.2 * surge, 3 * surge, 4)})
    spec |= {"mount": mount, "goal": goal}
    spec["sensor"] = [random_sensor(chance, spec, f"s{i + 1}") for i in range(chance.pick(1, 2))]
    spec["condition"] = [random_condition(chance, spec, f"c{i + 1}") for i in range(chance.pick(1, 1, 2))]
    masses = {"masses_per_winding": 1} if chance.pick(True, False) and options.with_masses else {}
    spec["spring"] = {"name": f"spring {number}"} | {key: x for key, x in spec["spring"].items() if key not in options.without} | masses
    return spec
