"""How far one can trust a force measured through a coil spring.

SI units at every door; force is tension-positive; end 1 has ``u1`` and ``F_i``, end 2 has ``u2`` and ``F_o``. The nouns are those of the Rust
crate, with the same names: ``Spring`` and ``Excitation`` make a ``Motion``, that makes ``Signals``, and measures judge them.

Examples
--------
>>> import coilsense
>>> spring = coilsense.Spring.of_paper("S_T")
>>> motion = coilsense.Motion(spring, coilsense.Excitation.impact(0.23, 0.25))
>>> signals = motion.signals(coilsense.sampled_window(10_000, 0.75, 1.0))
>>> print(f"the load cell reads up to {signals['F_o'].max():.2f} N")
the load cell reads up to 99.72 N
"""

from coilsense._coilsense import (
    Analysis,
    AnalysisError,
    Case,
    ChainModes,
    Clash,
    Condition,
    Damping,
    Deviation,
    EndInput,
    Error,
    Excitation,
    FarEnd,
    Live,
    Motion,
    Mount,
    OutputError,
    Signals,
    Spec,
    SpecError,
    Spectrum,
    Spring,
    Start,
    Stream,
    Windings,
    alias_of,
    analyze,
    continuous_frequencies,
    continuous_frequency,
    sampled_window,
    simulate,
    third_rule_error,
    third_rule_frequency,
    traverse_velocity,
    __version__,
)

__all__ = [
    "Analysis",
    "AnalysisError",
    "Case",
    "ChainModes",
    "Clash",
    "Condition",
    "Damping",
    "Deviation",
    "EndInput",
    "Error",
    "Excitation",
    "FarEnd",
    "Live",
    "Motion",
    "Mount",
    "OutputError",
    "Signals",
    "Spec",
    "SpecError",
    "Spectrum",
    "Spring",
    "Start",
    "Stream",
    "Windings",
    "alias_of",
    "analyze",
    "continuous_frequencies",
    "continuous_frequency",
    "sampled_window",
    "simulate",
    "third_rule_error",
    "third_rule_frequency",
    "traverse_velocity",
    "__version__",
]
