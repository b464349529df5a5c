//! The stiffness that a record tells of a spring whose first surge frequency is known.
//!
//! Next door: how it is fitted (`quasi_static`), which readings are at a limit (`channel_check`).

use super::channel_check;
use super::quasi_static::Stiffness;
use super::sampling::Sampling;
use super::settings::Settings;
use crate::signals::Signals;

impl Stiffness {
    /// Of a record by itself, of a spring whose first surge frequency is known \[Hz\]; a text says why there is none.
    ///
    /// F = k (l − l0) by least squares over Hann means of 0.2 s, the lengths' own noise taken off their variance; k's interval holds k (ωτ)²/6 of
    /// the coil's own mass, τ = 1/2f1, ω the blocks' √(−Σ l l̈/Σ l²).
    ///
    /// Source:   `[Bendat2010]` section 6.1.4 (H1); `[Rao2011]` for the static limit of a heavy spring.
    /// Valid:    a slow motion of at least a twentieth of the length's power; both forces' mean where both are recorded.
    /// Accuracy: intervals of `identify`'s tests.
    ///
    /// ```
    /// use coilsense::identify::Stiffness;
    /// use coilsense::{Channel, Signals};
    ///
    /// let time: Vec<f64> = (0..4000).map(|n| f64::from(n) / 200.0).collect();
    /// let length: Vec<f64> = time.iter().map(|t| 0.14 + 1e-3 * (1.9 * t).sin()).collect();
    /// let mut signals = Signals::new(time)?;
    /// signals.insert(Channel::InputForce, length.iter().map(|l| 760.0 * (l - 0.104)).collect())?;
    /// signals.insert(Channel::U2, length)?;
    /// let found = Stiffness::of_record(&signals, 54.0)?;
    /// assert!((found.stiffness.value - 760.0).abs() < 0.1);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// Why there is none, in words.
    pub fn of_record(signals: &Signals, first_frequency: f64) -> Result<Self, String> {
        let sampling = Sampling::of(signals).map_err(|error| error.to_string())?;
        let checks = channel_check::check(signals, &sampling);
        let mut found = Self::of(signals, &[], &channel_check::limits(&checks), &sampling, &Settings::default())?;
        found.with_mass(first_frequency);
        Ok(found)
    }
}
