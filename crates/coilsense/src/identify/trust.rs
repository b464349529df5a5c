//! Up to which frequency a force may be taken for another, on a spring that is not damped.
//!
//! Next door: the transit time it goes by (the parent), the full response (`crate::two_port`).

use crate::error::{Error, above_zero, check};

/// Where the dynamic error of a force reaches a tolerance, end 1 driven and end 2 held \[Hz\].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Trust {
    /// F_o taken for F_i: 1/cos ωτ − 1.
    pub output_for_input: f64,
    /// F_x taken for F_i: tan(ωτ)/ωτ − 1.
    pub deflection_for_input: f64,
    /// F_x taken for F_o: 1 − sin(ωτ)/ωτ.
    pub deflection_for_output: f64,
    /// The tolerance \[1\].
    pub tolerance: f64,
}

impl Trust {
    /// For a coil of transit time τ \[s\] and a relative tolerance.
    ///
    /// F_o = F_i/cos ωτ (`[Weijde2017]` eq. 1), F_i = k u ωτ/tan ωτ, F_o = k u ωτ/sin ωτ: each error solved for ω
    ///
    /// - `transit_time`: τ \[s\], `tolerance`: \[1\], both above zero, the tolerance below 1
    ///
    /// Source:   `[Weijde2017]` eq. 1; the wave equation between a driven and a held end for the other two.
    /// Valid:    no damping (a lightly damped spring below its first resonance), continuous coil.
    /// Accuracy: 1e-12 relative.
    ///
    /// # Errors
    /// [`Error::Value`] for a transit time or a tolerance outside of its range.
    ///
    /// ```
    /// let trust = coilsense::identify::Trust::of(9.248e-3, 0.01)?;
    /// assert!((trust.output_for_input - 2.42).abs() < 0.01); // S_T: 1 % is reached at 2.4 Hz, f1 is 54 Hz
    /// # Ok::<(), coilsense::Error>(())
    /// ```
    pub fn of(transit_time: f64, tolerance: f64) -> Result<Self, Error> {
        above_zero("transit_time", transit_time, "s")?;
        check(tolerance > 0.0 && tolerance < 1.0, "tolerance", tolerance, "", "above 0 and below 1")?;
        let turn = std::f64::consts::TAU * transit_time;
        let quarter = std::f64::consts::FRAC_PI_2;
        Ok(Self {
            output_for_input: (1.0 / (1.0 + tolerance)).acos() / turn,
            deflection_for_input: bisect(quarter, |x| x.tan() / x - 1.0 < tolerance) / turn,
            deflection_for_output: bisect(2.0 * quarter, |x| 1.0 - x.sin() / x < tolerance) / turn,
            tolerance,
        })
    }
}

/// Where `below` turns false between zero and `high`.
fn bisect(high: f64, below: impl Fn(f64) -> bool) -> f64 {
    let (mut low, mut high) = (0.0, high);
    loop {
        let middle = 0.5 * (low + high);
        if middle <= low || middle >= high {
            return middle;
        }
        if below(middle) { low = middle } else { high = middle }
    }
}
