//! Whether a cascade is stable, also once its coefficients are rounded.
//!
//! Next door: the designs (`butterworth`, `notch`).

use std::f64::consts::PI;

use coilsense_rt::Biquad;
use num_complex::Complex64;

use crate::error::{Error, at_least_one, called, check};

/// How coefficients are stored on the target.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Rounding {
    /// As they are: `f64`.
    Double,
    /// `f32`.
    Single,
    /// Whole multiples of 2⁻ⁿ, n the bits behind the point: 30 in a Q1.30 of 32 bits, which holds −2 to 2.
    Fixed {
        /// n, 1 to 52.
        fraction_bits: u32,
    },
}

impl Rounding {
    /// A coefficient as it is stored.
    pub fn of(self, value: f64) -> f64 {
        match self {
            Self::Double => value,
            Self::Single => f64::from(value as f32),
            Self::Fixed { fraction_bits } => {
                let steps = (u64::from(fraction_bits) as f64).exp2();
                (value * steps).round() / steps
            }
        }
    }
}

/// A cascade as it is stored, judged.
#[derive(Debug, Clone, PartialEq)]
pub struct Coefficients {
    /// The sections after rounding.
    pub sections: Vec<Biquad<f64>>,
    /// Distance from the origin of the pole nearest to the unit circle \[1\], below 1.
    pub pole_radius: f64,
    /// The largest change of the response that rounding makes, over frequency \[1\].
    pub response_change: f64,
}

impl Coefficients {
    /// Rounds and judges.
    ///
    /// |a2| < 1 and |a1| < 1 + a2 of every section
    ///
    /// Source:   the stability triangle, `[Oppenheim2010]` section 6.
    /// Valid:    rounding of coefficients alone: states are taken to be exact.
    /// Accuracy: the response is compared at 512 frequencies up to half of the sampling rate and at those of the poles.
    ///
    /// # Errors
    /// [`Error::Count`] for no section; [`Error::Value`] for a section that is unstable as stored, naming it, and for bits outside of 1 to 52.
    ///
    /// ```
    /// use coilsense::mitigation::{Coefficients, Rounding, low_pass};
    /// let slow = low_pass(2, 0.5, 2500.0)?;
    /// assert!(Coefficients::checked(&slow, Rounding::Single)?.response_change < 0.02);
    /// // Sixteen bits cannot tell its poles from 1.
    /// assert!(Coefficients::checked(&slow, Rounding::Fixed { fraction_bits: 14 }).is_err());
    /// # Ok::<(), coilsense::Error>(())
    /// ```
    pub fn checked(sections: &[Biquad<f64>], rounding: Rounding) -> Result<Self, Error> {
        at_least_one("sections", sections.len())?;
        if let Rounding::Fixed { fraction_bits } = rounding {
            let holds = (1..=52).contains(&fraction_bits);
            check(
                holds,
                called("fraction_bits", "bits behind the point"),
                f64::from(fraction_bits),
                "",
                "from 1 to 52",
            )?;
        }
        let rounded: Vec<Biquad<f64>> =
            sections.iter().map(|section| section.map(|value| rounding.of(value))).collect();
        let mut pole_radius = 0.0_f64;
        for (index, section) in rounded.iter().enumerate() {
            let radius = radius(section);
            let stable = section.a2.abs() < 1.0 && section.a1.abs() < 1.0 + section.a2;
            let quantity = format!("pole radius of section {} as stored", index + 1);
            check(stable, quantity, radius, "", "below 1")?;
            pole_radius = pole_radius.max(radius);
        }
        let angles = sections.iter().map(angle).chain((0..=512).map(|i| PI * f64::from(i) / 512.0));
        let change = |omega: f64| (response(sections, omega) - response(&rounded, omega)).norm();
        let response_change = angles.map(change).fold(0.0, f64::max);
        Ok(Self { sections: rounded, pole_radius, response_change })
    }
}

/// H at `omega` \[rad per sample\].
pub(super) fn response(sections: &[Biquad<f64>], omega: f64) -> Complex64 {
    let z = Complex64::cis(-omega);
    sections.iter().map(|s| (s.b0 + z * (s.b1 + z * s.b2)) / (1.0 + z * (s.a1 + z * s.a2))).product()
}

/// Distance of the farther pole from the origin.
fn radius(section: &Biquad<f64>) -> f64 {
    let quarter = 0.25 * section.a1 * section.a1 - section.a2;
    if quarter < 0.0 { section.a2.sqrt() } else { 0.5 * section.a1.abs() + quarter.sqrt() }
}

/// Angle of the upper pole \[rad\].
fn angle(section: &Biquad<f64>) -> f64 {
    let quarter = section.a2 - 0.25 * section.a1 * section.a1;
    quarter.max(0.0).sqrt().atan2(-0.5 * section.a1)
}
