"""Table II of the paper, recomputed: how far F_i, F_o and F_L are off from the force by deflection, in per cent of F_nom.

The paper's five conditions are those of `coilsense init`; u2 is held and nothing damps the spring.
"""

import pathlib
import tempfile

import coilsense

# Columns F_i, F_o, F_L, as printed in [Weijde2017].
PRINTED = {
    "heel strike": (1.44, 1.44, 0.01),
    "end stop max": (0.22, 0.23, 0.01),
    "end stop min": (0.39, 0.39, 0.00),
    "half resonance": (0.37, 0.27, 0.00),
    "resonance": (8.93, 8.94, 0.34),
}
FORCES = ("F_i", "F_o", "F_L")

text = coilsense.Spec.template("S_T").replace('end2 = "held"', 'end2 = "held"\ndamping_ratio = 0', 1)
spec = coilsense.Spec.parse(text)
nominal = spec.spring.nominal_force
found = {
    case.condition: [100 * case.deviations[force].rmsd / nominal for force in FORCES] for case in coilsense.simulate(spec)
}

print(f"{'RMSD [% of F_nom]':18}" + "".join(f"{force:>8}{'printed':>9}" for force in FORCES))
for condition, printed in PRINTED.items():
    pairs = zip(found[condition], printed)
    print(f"{condition:18}" + "".join(f"{ours:8.2f}{theirs:9.2f}" for ours, theirs in pairs))
worst = max(abs(ours - theirs) for condition, printed in PRINTED.items() for ours, theirs in zip(found[condition], printed))
print(f"largest difference from what is printed: {worst:.3f} % of F_nom")
assert worst < 0.03, "two digits were printed; at resonance the last one depends on the frequency's own last digit"

try:
    import matplotlib.pyplot as plt
except ImportError:
    pass
else:
    figure, axes = plt.subplots(figsize=(8, 4), layout="constrained")
    for place, (force, colour) in enumerate(zip(FORCES, ("#0072b2", "#d55e00", "#009e73"))):
        rows = [row + 0.27 * (place - 1) for row in range(len(PRINTED))]
        axes.barh(rows, [found[condition][place] for condition in PRINTED], height=0.24, color=colour, label=force)
        axes.plot([PRINTED[condition][place] or float("nan") for condition in PRINTED], rows, "k|", markersize=9,
                  label="printed in the paper" if place == 2 else None)
    axes.set_xscale("log")
    axes.set_xlim(3e-4, 20)
    axes.set_yticks(range(len(PRINTED)), list(PRINTED))
    axes.invert_yaxis()
    axes.set_xlabel("RMSD from F_x [% of F_nom]")
    axes.legend(loc="lower left", bbox_to_anchor=(0, 1), ncols=4, frameon=False)
    axes.grid(alpha=0.3, axis="x")
    path = pathlib.Path(tempfile.mkdtemp(prefix="coilsense-")) / "paper_table_2.png"
    figure.savefig(path, dpi=120)
    print(f"figure: {path}")
