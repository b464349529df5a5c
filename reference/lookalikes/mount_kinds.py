"""Springs on the mounts that rigs have: held, behind a load cell that resonates, compliant, moving, rubbing; with an end mass, another
spring inside, touching windings, or lines of torsion and of lateral motion beside their own.

Next door: the same spring through imperfect channels (channel_kinds.py).
"""

import numpy as np

from assembly import END1, END2, Assembly
from record import log_uniform
from scene import modes_after_hits
from spring import Built, blows, chosen, plain, rig, simulate, spring_log
from unsmooth import rubbing, touching


def clean(rng, kind, forces):
    spring = rig(rng)
    built = plain(spring)
    return spring_log(spring, kind, chosen(rng, simulate(spring, built, *blows(spring, built)), forces))


def clean_both(rng):
    """Both ends held, both forces."""
    return clean(rng, "clean-both", "both")


def clean_one(rng):
    """Both ends held, one force."""
    return clean(rng, "clean-one", "one")


def few_windings(rng):
    """Five to 40 masses: modes lie below the multiples of f1."""
    spring = rig(rng, masses=int(rng.integers(5, 41)))
    built = plain(spring)
    forces = ("both", "one")[rng.integers(2)]
    return spring_log(spring, "few-windings", chosen(rng, simulate(spring, built, *blows(spring, built)), forces))


def parity(rng):
    """Struck so that only odd modes ring (amid the coil), or only even ones (both halves against each other; both forces then)."""
    spring = rig(rng)
    spring.where, even = "winding", rng.random() < 0.5
    built = plain(spring)
    middle = (spring.masses - 1) / 2
    offset = round(rng.uniform(0.1, 0.42) * spring.masses) if even else int(rng.integers(0, 2))
    forces, ends = blows(spring, built)
    for number, (target, _) in enumerate(forces):
        target[:] = 0
        target[int(middle - offset)] = 1 + 0.003 * rng.standard_normal()
        target[int(middle + offset + 1)] = -1 if even else 1
    series = simulate(spring, built, forces, ends)
    return spring_log(spring, "parity", chosen(rng, series, "both" if even or rng.random() < 0.5 else "one"))


def behind_cell(rng, kind, forces):
    """F_o is what a load cell with a mass of its own feels between the spring and the ground; F_i is felt rigidly."""
    spring = rig(rng)
    assembly = Assembly()
    nodes, first, last = assembly.chain(END1, END2, spring.masses, spring.mass, spring.stiffness)
    assembly.links.pop()
    head = assembly.mass(spring.mass * log_uniform(rng, 0.8, 10))
    assembly.link(nodes[-1], head, last.stiffness)
    cell = assembly.link(head, END2, spring.stiffness * log_uniform(rng, 250, 8000))
    built = Built(assembly, nodes, first, cell, head)
    series = simulate(spring, built, *blows(spring, built))
    held = np.full_like(series["u2"], series["u2"][0])
    if forces == "one":
        forces = "F_o"
    return spring_log(spring, kind, chosen(rng, series | {"u2": held}, forces))


def cell_both(rng):
    """Behind a load cell that resonates, both forces."""
    return behind_cell(rng, "cell-both", "both")


def cell_one(rng):
    """Behind a load cell that resonates, its force only."""
    return behind_cell(rng, "cell-one", "one")


def compliant_mount(rng):
    """One or both ends give by 0.2 to 8 % of the spring's own compliance; forces are felt at the spring's ends."""
    spring = rig(rng)
    assembly = Assembly()
    gives = (log_uniform(rng, 12, 500), log_uniform(rng, 12, 500))
    soft = rng.integers(3)  # end 1, end 2, both
    seat = [assembly.mass(0.01 * spring.mass * log_uniform(rng, 0.3, 30)) if soft in (end, 2) else (END1, END2)[end] for end in (0, 1)]
    nodes, first, last = assembly.chain(*seat, spring.masses, spring.mass, spring.stiffness)
    for end, node in enumerate(seat):
        if node >= 0:
            assembly.link((END1, END2)[end], node, gives[end] * spring.stiffness)
    built = Built(assembly, nodes, first, last, seat[1])
    series = simulate(spring, built, *blows(spring, built))
    series["u2"] = np.full_like(series["u2"], series["u2"][0])
    return spring_log(spring, "compliant-mount", chosen(rng, series, ("both", "one")[rng.integers(2)]))


def moving_mount(rng):
    """End 2 stands on a frame with a mass and a line of its own, which hits set in motion too; u2 is recorded in half of the logs."""
    spring = rig(rng)
    assembly = Assembly()
    frame = assembly.mass(spring.mass * log_uniform(rng, 15, 200))
    nodes, first, last = assembly.chain(END1, frame, spring.masses, spring.mass, spring.stiffness)
    own = log_uniform(rng, 0.25, 4) * spring.first
    assembly.link(frame, END2, max(assembly.masses[frame] * (2 * np.pi * own) ** 2, 10 * spring.stiffness))
    built = Built(assembly, nodes, first, last, frame)
    forces, ends = blows(spring, built)
    shaken = np.zeros(len(assembly.masses))
    shaken[frame] = 1
    for number, size in enumerate(spring.scene.sizes):
        momentum = rng.uniform(0.5, 5) * spring.peak * size / (4 * spring.first)
        forces.append((shaken, momentum * spring.scene.pulse(number)))
    series = simulate(spring, built, forces, ends)
    positions = (["u1", "u2"], ["u1", "u2"], ["u1"], [])[rng.integers(4)]
    return spring_log(spring, "moving-mount", chosen(rng, series, ("both", "one")[rng.integers(2)], positions))


def rubbing_mount(rng):
    """End 2 sits on a seat that slips against Coulomb friction where the ringing pulls harder, and is stiff where not."""
    spring = rig(rng, masses=80)
    assembly = Assembly()
    seat = assembly.mass(spring.mass * log_uniform(rng, 0.1, 1))
    nodes, first, last = assembly.chain(END1, seat, spring.masses, spring.mass, spring.stiffness)
    assembly.link(seat, END2, spring.stiffness * log_uniform(rng, 15, 300))
    built = Built(assembly, nodes, first, last, seat)
    forces, ends = blows(spring, built)
    friction = spring.peak * log_uniform(rng, 0.02, 0.8)

    def law(modes, rate, rows, answer):
        speed = np.gradient(answer(np.eye(len(assembly.masses))[seat : seat + 1])[0], 1 / rate)
        return rubbing(modes, rate, seat, friction, speed, rows)

    series = simulate(spring, built, forces, ends, law)
    series["u2"] = np.full_like(series["u2"], series["u2"][0])
    return spring_log(spring, "rubbing-mount", chosen(rng, series, ("both", "one")[rng.integers(2)]))


def end_mass(rng):
    """A free mass of 0.3 to 20 coils at end 2, which is struck; F_o, u1 and in most logs u2."""
    spring = rig(rng)
    assembly = Assembly()
    load = assembly.mass(spring.mass * log_uniform(rng, 0.3, 20))
    nodes, first, last = assembly.chain(END1, load, spring.masses, spring.mass, spring.stiffness)
    built = Built(assembly, nodes, first, last, load)
    spring.scene.slow = (spring.scene.slow[0], 0.02 * spring.first)
    targets = [load if rng.random() < 0.5 else nodes[round(place * (spring.masses - 1))] for place in spring.places]
    series = simulate(spring, built, *blows(spring, built, targets))
    positions = ["u1", "u2"] if rng.random() < 0.8 else ["u1"]
    return spring_log(spring, "end-mass", chosen(rng, series, ("both", "F_o")[rng.integers(2)], positions))


def nested_pair(rng):
    """Two springs between the same ends, one inside the other: two series, one stiffness."""
    spring = rig(rng)
    assembly = Assembly()
    ratio, share = log_uniform(rng, 1.04, 2.2) ** rng.choice([-1, 1]), rng.uniform(0.15, 0.5)
    outer = assembly.chain(END1, END2, spring.masses, spring.mass, spring.stiffness)
    inner_stiffness = share * spring.stiffness
    inner = assembly.chain(END1, END2, spring.masses, inner_stiffness / (4 * (ratio * spring.first) ** 2), inner_stiffness)
    series = None
    for nodes, first, last in (outer, inner):
        built = Built(assembly, nodes, first, last)
        # Hits are shared out by the forces that they leave at the ends; both feel what moves end 1.
        forces, ends = blows(spring, built)
        answer = simulate(spring, built, forces, ends)
        series = answer if series is None else {name: series[name] + answer[name] * name.startswith("F") for name in series}
    log = chosen(rng, series, ("both", "one")[rng.integers(2)])
    own = ratio * spring.first
    return spring_log(spring, "nested-pair", log, others=(float(own),), mass=None, stiffness=spring.stiffness + inner_stiffness)


def satellites(rng):
    """Lines of torsion (1.12 to 1.17 of the axial ones; with a swivel also of quarter waves) and close pairs of lateral lines beside."""
    spring = rig(rng)
    built = plain(spring)
    series = simulate(spring, built, *blows(spring, built))
    turns = rng.uniform(1.115, 1.17) * np.arange(1, 4)
    if rng.random() < 0.4:
        turns = np.append(turns, turns[0] * np.array([0.5, 1.5]))
    pairs = np.repeat(rng.uniform(0.3, 3.5, rng.integers(1, 4)), 2)
    pairs[1::2] *= 1 + log_uniform(rng, 1e-4, 0.04)
    lines = np.concatenate([turns, pairs])
    sizes = spring.peak * np.repeat([log_uniform(rng, 1e-3, 0.1), log_uniform(rng, 7e-4, 0.07)], [len(turns), len(pairs)])
    ratios = spring.zeta(spring.first * lines) * rng.uniform(0.5, 1.5, len(lines))
    happening = spring.scene
    frequencies = spring.first * lines
    kept = frequencies < 0.4 * happening.fine_rate
    rung = modes_after_hits(happening, frequencies[kept], ratios[kept], rng.standard_normal((len(happening.hits), kept.sum())))
    for name, sign in (("F_i", 1), ("F_o", rng.choice([-1, 1], kept.sum()))):
        series[name] = series[name] + (sizes[kept] * sign) @ rung
    return spring_log(spring, "satellites", chosen(rng, series, ("both", "one")[rng.integers(2)]))


def coil_contact(rng):
    """Hits close some of the gaps between windings for a moment; what rings afterwards is a plain spring."""
    spring = rig(rng, masses=24, first=log_uniform(rng, 14, 45), duration=11.0, hits=int(rng.integers(3, 6)), rate=2500.0)
    spring.scene.factor = 8
    built = plain(spring)
    forces, ends = blows(spring, built)

    def law(modes, rate, rows, answer):
        place = answer(np.eye(spring.masses))
        closing = -np.diff(place, axis=0).min(axis=1)
        gaps = np.quantile(closing, 0.9) * rng.uniform(0.5, 0.95) * np.exp(0.1 * rng.standard_normal(len(closing)))
        link = 25 * spring.masses * spring.stiffness
        damping = 0.3 * 2 * np.sqrt(link * spring.mass / spring.masses / 2)
        return touching(modes, rate, gaps, link, damping, place, rows)

    series = simulate(spring, built, forces, ends, law)
    return spring_log(spring, "coil-contact", chosen(rng, series, ("both", "one")[rng.integers(2)]))


KINDS = (clean_both, clean_one, few_windings, parity, cell_both, cell_one, compliant_mount, moving_mount, rubbing_mount, end_mass, nested_pair,
         satellites, coil_contact)  # fmt: skip
