"""How far a load cell is off after a heel strike, and for how long: the ankle spring of the humanoid TUlip."""

import coilsense

spring = coilsense.Spring.of_paper("S_T")
motion = coilsense.Motion(spring, coilsense.Excitation.impact(spring.mid_length, 0.25))
signals = motion.signals(coilsense.sampled_window(10_000, 0.0, 1.0))

error = signals["F_o"] - signals["F_x"]
share = 100 * abs(error).max() / spring.nominal_force
print(f"{spring.surge_frequency:.1f} Hz: F_o is off by up to {abs(error).max():.2f} N ({share:.2f} % of F_nom)")
assert abs(error).max() > 0.25 * spring.wave_impedance, "the impact's first wave alone carries v Z"
