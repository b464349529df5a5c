//! The impedance that a force-controlled spring renders at end 2: its stiffness there, and whether it could ever give energy away.
//!
//! Next door: the loop (`force_loop`).

use std::f64::consts::TAU;

use num_complex::Complex64;

use super::force_loop::ForceLoop;
use crate::error::{Error, check};
use crate::signals::Channel;

/// Stiffness that end 2 feels \[N/m\]: F_o/U2 at a constant reference, the loop closed.
///
/// From y = c·G_0 − F_i/K_M (K_M the drive's own stiffness), c = −C e^(−sT) F_fed and the spring's F_i = k_d y + k_t U2,
/// F_o = k_t y + k_d U2, F_x = k (y + U2): y/U2 = −(a k_t + C G_0 f_2)/(1 + a k_d + C G_0 f_1), a = 1/K_M, f = [f_1, f_2] of the force fed back
///
/// - `angular_frequency`: ω \[rad/s\], above zero
///
/// Source:   [`crate::two_port::DynamicStiffness::matrix`] with the loop's own equations.
/// Valid:    small motions; the loop stable with what it meets. F_L is not offered: it is a sum over modes, not a two-port.
/// Accuracy: that of the two-port.
///
/// # Errors
/// [`Error::Value`] for a frequency that is not above zero and finite; [`Error::MissingSignal`] for F_L.
pub fn rendered_stiffness(force_loop: &ForceLoop, angular_frequency: f64) -> Result<Complex64, Error> {
    check(angular_frequency > 0.0, "angular_frequency", angular_frequency, "rad/s", "above zero and finite")?;
    let plant = force_loop.plant();
    let ends = plant.two_port().at(angular_frequency)?;
    let s = Complex64::new(0.0, angular_frequency);
    let (drive_point, transfer) = (ends.drive_point(), ends.transfer());
    let spring = Complex64::from(plant.spring().stiffness());
    let [by_stroke, by_end] = match force_loop.feedback() {
        Channel::InputForce => [drive_point, transfer],
        Channel::OutputForce => [transfer, drive_point],
        Channel::DeflectionForce => [spring, spring],
        other => return Err(Error::MissingSignal(other.name())),
    };
    let own = plant.drive().own_stiffness(s);
    let give = if own.re.is_infinite() { Complex64::ZERO } else { own.inv() };
    let control = force_loop.control(s) * plant.drive().free_stroke(s);
    let stroke = -(give * transfer + control * by_end) / (1.0 + give * drive_point + control * by_stroke);
    Ok(transfer * stroke + drive_point)
}

/// Where a rendered impedance is passive.
#[derive(Debug, Clone, PartialEq)]
pub struct Passivity {
    /// Bands in which the real part of F_o/(jω U2) is below zero \[Hz\]: there some passive environment makes the loop unstable.
    pub active: Vec<[f64; 2]>,
    /// The least real part of F_o/(jω U2) \[N s/m\], over the spring's wave impedance \[1\].
    pub least: f64,
    /// Up to where it was looked at \[Hz\].
    pub up_to: f64,
}

impl Passivity {
    /// Looks at Re(F_o/(jω U2)) from 1e-3 of the first surge frequency up to `up_to` \[Hz\].
    ///
    /// # Errors
    /// As [`rendered_stiffness`]; [`Error::Value`] where `up_to` is not above the band's beginning.
    pub fn of(force_loop: &ForceLoop, up_to: f64) -> Result<Self, Error> {
        let spring = force_loop.plant().spring();
        let from = 1e-3 * spring.surge_frequency();
        check(up_to > from && up_to.is_finite(), "frequency", up_to, "Hz", format!("above {from} Hz"))?;
        let mut frequencies: Vec<f64> =
            (0..4000).map(|index| from * (up_to / from).powf(f64::from(index) / 3999.0)).collect();
        frequencies.extend(force_loop.known().into_iter().map(|line| line / TAU).filter(|f| (from..up_to).contains(f)));
        frequencies.sort_by(f64::total_cmp);
        let (mut active, mut least) = (Vec::<[f64; 2]>::new(), f64::INFINITY);
        let mut was_active = false;
        for frequency in frequencies {
            let omega = TAU * frequency;
            // Re(K/jω) = Im K/ω.
            let stiffness = rendered_stiffness(force_loop, omega)?;
            let real = stiffness.im / omega;
            least = least.min(real / spring.wave_impedance());
            // What rounding of K leaves is neither.
            let is_active = stiffness.im < -1e-12 * stiffness.norm();
            match active.last_mut().filter(|_| is_active && was_active) {
                Some(band) => band[1] = frequency,
                None if is_active => active.push([frequency; 2]),
                None => {}
            }
            was_active = is_active;
        }
        Ok(Self { active, least, up_to })
    }
}
