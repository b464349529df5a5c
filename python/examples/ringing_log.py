"""A log that rings: is it the spring, what spring is it, and what should the controller do about it? All from a CSV file.

There is no rig here: the log is simulated, written as a foreign recorder would write it, and read back.
"""

import pathlib
import tempfile

import numpy

import coilsense

folder = pathlib.Path(tempfile.mkdtemp(prefix="coilsense-"))

# An ankle spring is pulled slowly while something hits it every five seconds; load cells and encoders sample at 2.5 kHz.
# The motion is linear: each hit's ringing adds to what is there.
spring = coilsense.Spring.of_paper("S_T")
mount = coilsense.Mount(damping=coilsense.Damping.modal(0.005))
times = coilsense.sampled_window(2500, 0, 30)
pulled = coilsense.Excitation(0.23, end1=coilsense.EndInput.harmonic(5e-3, 0.2))
signals = coilsense.Motion(spring, pulled, mount).signals(times)
hit = coilsense.Motion(spring, coilsense.Excitation.impact(0.23, 0.25), mount).signals(times)
random = numpy.random.default_rng(1)
forces = {}
for name in ("F_i", "F_o"):
    forces[name] = signals[name] + random.normal(0, 0.05, len(times))
    for begin in range(5000, len(times), 12_500):
        forces[name][begin:] += hit[name][: len(times) - begin] - spring.static_force(0.23)
log = folder / "run.csv"
table = numpy.transpose([times, forces["F_i"], forces["F_o"], 1e3 * signals["u1"], 1e3 * signals["u2"]])
titles = "Time [s];Drive [N];Load cell [N];Motor [mm];Foot [mm]"
numpy.savetxt(log, table, "%.6f", ";", header=f"simulated by coilsense {coilsense.__version__}\n{titles}")

# From here on as with any log.
columns: dict[str, str | int] = {
    "time": "Time [s]", "F_i": "Drive [N]", "F_o": "Load cell [N]", "u1": "Motor [mm]", "u2": "Foot [mm]"
}
recording = coilsense.open_log(log, columns)
found = coilsense.identify(recording, spring=spring)
print(found.answer[0])
for name in ("first_frequency", "damping_ratio", "stiffness", "mass"):
    estimate = getattr(found, name)
    print(f"  {name}: {estimate.value:.6g} ± {estimate.expanded:.2g}")

# What to do about it, judged on a few seconds of the log.
spec = coilsense.Spec.parse(found.to_spec(spring=spring))
part = coilsense.open_log(log, columns, from_=1.0, to=5.0)
remedies = coilsense.mitigate(spec, part)
raw = next(remedy for remedy in remedies.remedies if remedy.name == "F_i, unfiltered")
best = remedies.best_filter
assert best is not None and best.rms_error < raw.rms_error
print(f"best of {len(remedies)}: {best.name}, {best.rms_error:.3f} N rms off instead of {raw.rms_error:.3f} N")
force = part.signals["F_i"]
clean = best.apply(force, part.signals["u1"], part.signals["u2"])
(folder / "force_filter.h").write_text(best.to_c())
print(f"as C: {folder / 'force_filter.h'}")

try:
    import matplotlib.pyplot as plt
except ImportError:
    pass
else:
    figure, (above, below) = plt.subplots(2, 1, figsize=(8, 7), layout="constrained")
    found.plot(above)
    above.set_title("What rings, by the log (simulated)")
    time = part.signals.time
    shown = (time > 1.9) & (time < 2.6)
    below.plot(time[shown], force[shown], color="#999999", linewidth=0.7, label="F_i, unfiltered")
    below.plot(time[shown], clean[shown], color="#0072b2", label=best.name)
    below.set_xlabel("t [s]")
    below.set_ylabel("Force [N]")
    below.legend(loc="upper left")
    below.grid(alpha=0.3)
    figure.savefig(folder / "ringing_log.png", dpi=120)
    print(f"figure: {folder / 'ringing_log.png'}")
