"""How far off is a load cell, and how far the deflection, as a spring is shaken faster and faster?

Both are compared with the force at the driven end, up to just below half of the surge frequency, where that force vanishes.
"""

import pathlib
import tempfile

import numpy

import coilsense

spring = coilsense.Spring.of_paper("S_T")
mount = coilsense.Mount(damping=coilsense.Damping.modal(0.005))
first = coilsense.ChainModes(spring).frequencies[0]
shares = numpy.geomspace(0.02, 0.45, 40)
errors: dict[str, list[float]] = {"F_o": [], "F_x": []}
for share in shares:
    period = 1 / (share * first)
    shaken = coilsense.EndInput.harmonic(1e-3, share * first)
    motion = coilsense.Motion(spring, coilsense.Excitation(0.23, end1=shaken, start=coilsense.Start.steady()), mount)
    signals = motion.signals(numpy.linspace(0, period, 400, endpoint=False))
    swing = numpy.ptp(signals["F_i"])
    for name, values in errors.items():
        values.append(numpy.ptp(signals[name] - signals["F_i"]) / swing)

trusted = {name: first * numpy.interp(0.01, values, shares) for name, values in errors.items()}
for name, frequency in trusted.items():
    print(f"{name} is within 1 % of F_i up to {frequency:.2f} Hz, {frequency / first:.3f} of the surge frequency {first:.1f} Hz")
better = max(trusted, key=lambda name: trusted[name])
print(f"for the force at the driven end take {better}")
# The wave equation says 1/cos(ωτ) − 1 and tan(ωτ)/(ωτ) − 1: ratio of the limits √(3/2), as 1/2 stands against 1/3.
assert abs(trusted["F_x"] / trusted["F_o"] - 1.5**0.5) < 0.02

try:
    import matplotlib.pyplot as plt
except ImportError:
    pass
else:
    figure, axes = plt.subplots(figsize=(7, 4), layout="constrained")
    labels = {"F_o": "F_o: load cell at the far end", "F_x": "F_x: deflection"}
    for (name, values), colour in zip(errors.items(), ("#d55e00", "#0072b2")):
        axes.loglog(shares * first, 100 * numpy.array(values), color=colour, label=labels[name])
    axes.axhline(1, color="#777777", linewidth=0.8, linestyle=":")
    axes.annotate("1 %", (shares[0] * first, 1.1), fontsize=9, color="#555555")
    axes.set_xlabel("Frequency of the driven end [Hz]")
    axes.set_ylabel("Off from F_i [% of its swing]")
    axes.legend()
    axes.grid(alpha=0.3, which="both")
    axes.set_xticks([1, 2, 5, 10, 20], ["1", "2", "5", "10", "20"])
    axes.xaxis.set_minor_formatter("")
    axes.yaxis.set_major_formatter("{x:g}")
    path = pathlib.Path(tempfile.mkdtemp(prefix="coilsense-")) / "which_sensor.png"
    figure.savefig(path, dpi=120)
    print(f"figure: {path}")
