//! How a spring that is held stretched slowly loses force.
//!
//! Next door: the force of a spring that does not (`spring`), who has to tell that loss from a sensor's (`coilsense-lab`'s rig).

use crate::error::{Error, above_zero, called, check};

/// Loss of force with the logarithm of time.
///
/// ```
/// // 0.05 % of the force each decade, watched from two minutes after the spring was stretched.
/// let relaxation = coilsense::relaxation::Relaxation::new(5e-4, 120.0)?;
/// assert_eq!(relaxation.lost_share(0.0), 0.0);
/// assert!((relaxation.lost_share(1080.0) - 5e-4).abs() < 1e-18);
/// # Ok::<(), coilsense::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Relaxation {
    per_decade: f64,
    age: f64,
}

impl Relaxation {
    /// A spring that loses a share of its force per decade of time since it was stretched.
    ///
    /// - `per_decade`: r \[1\], from 0 to 1; `age`: t_a \[s\], time since it was stretched when time begins to count, above zero
    ///
    /// # Errors
    /// [`Error::Value`] for a share outside of that, or an age that is not above zero.
    pub fn new(per_decade: f64, age: f64) -> Result<Self, Error> {
        check(
            (0.0..=1.0).contains(&per_decade),
            called("per_decade", "relaxation per decade"),
            per_decade,
            "",
            "from 0 to 1",
        )?;
        Ok(Self { per_decade, age: above_zero(called("age", "age of the preload"), age, "s")? })
    }

    /// Share of the force lost since time began to count \[1\].
    ///
    /// (F(0) − F(t))/F(0) = r log10(1 + t/t_a)
    ///
    /// - `time`: t \[s\], not below zero
    ///
    /// Source:   logarithmic creep, `[Phillips1905]`, turned into a loss of force at a held length.
    /// Valid:    small losses at room temperature, the length held; oscillation about it is taken as if it did not hurry the loss.
    /// Accuracy: 2e-16 relative.
    pub fn lost_share(&self, time: f64) -> f64 {
        self.per_decade * (time / self.age).ln_1p() / std::f64::consts::LN_10
    }
}
