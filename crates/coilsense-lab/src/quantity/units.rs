//! Which units each dimension may be written in, and what takes them to SI.
//!
//! Next door: how a number with its unit is read (the parent).

use std::f64::consts::PI;

use super::Dimension;

/// A unit: its symbol and what takes it to SI.
pub(super) type Unit = (&'static str, Factor);

/// What takes a unit to SI.
#[derive(Debug, Clone, Copy)]
pub(super) enum Factor {
    /// A power of ten, which is read together with the digits, so that the result is the nearest double.
    Ten(i32),
    /// Any other factor.
    Times(f64),
    /// Any other divisor.
    Over(f64),
}

use Factor::{Over, Ten, Times};

/// One inch \[m\], exactly.
///
/// Source: the international yard and pound agreement of 1959, as the next one.
const INCH: f64 = 0.0254;
/// One avoirdupois pound \[kg\], exactly.
const POUND: f64 = 0.453_592_37;
/// Standard gravity \[m/s²\], exactly: what makes a force of a kilogram or a pound.
///
/// Source: 3rd General Conference on Weights and Measures, 1901.
const GRAVITY: f64 = 9.806_65;
const POUND_FORCE: f64 = POUND * GRAVITY;

impl Dimension {
    /// The units it may be written in, the SI unit first.
    pub(super) fn units(self) -> &'static [Unit] {
        match self {
            Self::Length => &[
                ("m", Ten(0)),
                ("cm", Ten(-2)),
                ("mm", Ten(-3)),
                ("um", Ten(-6)),
                ("µm", Ten(-6)),
                ("nm", Ten(-9)),
                ("in", Times(INCH)),
                ("inch", Times(INCH)),
                ("\"", Times(INCH)),
                ("ft", Times(12.0 * INCH)),
                ("mil", Times(1e-3 * INCH)),
            ],
            Self::Mass => {
                &[("kg", Ten(0)), ("g", Ten(-3)), ("mg", Ten(-6)), ("lb", Times(POUND)), ("oz", Times(POUND / 16.0))]
            }
            Self::Stiffness => &[
                ("N/m", Ten(0)),
                ("kN/m", Ten(3)),
                ("N/mm", Ten(3)),
                ("lbf/in", Times(POUND_FORCE / INCH)),
                ("kgf/mm", Times(1e3 * GRAVITY)),
            ],
            Self::Force => &[
                ("N", Ten(0)),
                ("kN", Ten(3)),
                ("mN", Ten(-3)),
                ("lbf", Times(POUND_FORCE)),
                ("kgf", Times(GRAVITY)),
                ("gf", Times(1e-3 * GRAVITY)),
            ],
            Self::Time => &[
                ("s", Ten(0)),
                ("ms", Ten(-3)),
                ("us", Ten(-6)),
                ("µs", Ten(-6)),
                ("ns", Ten(-9)),
                ("min", Times(60.0)),
                ("h", Times(3600.0)),
                ("d", Times(86_400.0)),
            ],
            Self::Frequency => &[("Hz", Ten(0)), ("kHz", Ten(3)), ("MHz", Ten(6)), ("rpm", Over(60.0))],
            Self::SurgeMultiple => &[("f1", Ten(0))],
            Self::Velocity => &[("m/s", Ten(0)), ("cm/s", Ten(-2)), ("mm/s", Ten(-3)), ("km/h", Over(3.6))],
            Self::Angle => &[("rad", Ten(0)), ("deg", Times(PI / 180.0))],
            Self::Inductance => &[("H", Ten(0)), ("mH", Ten(-3)), ("uH", Ten(-6)), ("µH", Ten(-6)), ("nH", Ten(-9))],
            Self::Temperature => &[("K", Ten(0))],
            Self::Share => &[("%", Ten(-2)), ("ppm", Ten(-6))],
            Self::Modulus => &[("Pa", Ten(0)), ("MPa", Ten(6)), ("GPa", Ten(9))],
            Self::Density => &[("kg/m3", Ten(0)), ("kg/m³", Ten(0)), ("g/cm3", Ten(3))],
            Self::Resistance => {
                &[("Ohm", Ten(0)), ("Ω", Ten(0)), ("mOhm", Ten(-3)), ("mΩ", Ten(-3)), ("kOhm", Ten(3)), ("kΩ", Ten(3))]
            }
            Self::Resistivity => &[("Ohm m", Ten(0)), ("Ω m", Ten(0)), ("uOhm m", Ten(-6))],
            Self::Compliance => &[("m/N", Ten(0)), ("mm/N", Ten(-3)), ("um/N", Ten(-6)), ("µm/N", Ten(-6))],
            Self::PerKelvin => &[("1/K", Ten(0)), ("%/K", Ten(-2)), ("ppm/K", Ten(-6))],
            Self::Rate => &[("1/s", Ten(0))],
            Self::Friction => &[("N s/m", Ten(0)), ("N s/mm", Ten(3))],
        }
    }
}
