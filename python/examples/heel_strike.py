"""How far a load cell is off after a heel strike, and for how long: the ankle spring of the humanoid TUlip."""

import pathlib
import tempfile

import coilsense

spring = coilsense.Spring.of_paper("S_T")
motion = coilsense.Motion(spring, coilsense.Excitation.impact(spring.mid_length, 0.25))
signals = motion.signals(coilsense.sampled_window(10_000, 0.0, 1.0))

error = signals["F_o"] - signals["F_x"]
share = 100 * abs(error).max() / spring.nominal_force
print(f"{spring.surge_frequency:.1f} Hz: F_o is off by up to {abs(error).max():.2f} N ({share:.2f} % of F_nom)")
assert abs(error).max() > 0.25 * spring.wave_impedance, "the impact's first wave alone carries v Z"

try:
    import matplotlib.pyplot as plt
except ImportError:
    pass
else:
    figure, axes = plt.subplots(figsize=(8, 4), layout="constrained")
    first = signals.time < 0.1
    for name, colour in (("F_i", "#0072b2"), ("F_o", "#d55e00"), ("F_x", "#333333")):
        axes.plot(1e3 * signals.time[first], signals[name][first], color=colour, linewidth=1, label=name)
    axes.set_xlabel("Time since the ends stopped [ms]")
    axes.set_ylabel("Force [N]")
    axes.legend(loc="lower left", bbox_to_anchor=(0, 1), ncols=3, frameon=False)
    axes.grid(alpha=0.3)
    path = pathlib.Path(tempfile.mkdtemp(prefix="coilsense-")) / "heel_strike.png"
    figure.savefig(path, dpi=120)
    print(f"figure: {path}")
