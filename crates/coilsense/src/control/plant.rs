//! The plant: a drive, the spring with its load, and what each force signal makes of a command.
//!
//! Next door: the controller around it (`force_loop`), the spring alone (`crate::two_port`).

use num_complex::Complex64;

use super::coil::Coil;
use super::drive::Drive;
use super::environment::Environment;
use crate::damping::Damping;
use crate::error::{Error, check};
use crate::modes::ChainModes;
use crate::signals::Channel;
use crate::spring::Spring;
use crate::two_port::{DynamicStiffness, Load, TwoPort};

/// A drive, a spring and what end 2 meets.
#[derive(Debug, Clone, PartialEq)]
pub struct Plant {
    spring: Spring,
    damping: Damping,
    drive: Drive,
    environment: Environment,
    two_port: TwoPort,
    coil: Coil,
}

/// The least damping ratio for which a loop is followed along its lines.
const LEAST_RATIO: f64 = 1e-6;

/// Force signals over the command \[N per command\], and y = −u1 \[m per command\].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Response {
    /// y = −u1.
    pub stroke: Complex64,
    /// F_i.
    pub input: Complex64,
    /// F_o.
    pub output: Complex64,
    /// F_x.
    pub deflection: Complex64,
    /// F_L, for small motions about the mean length.
    pub inductance: Complex64,
}

impl Response {
    /// So many times as much.
    pub(super) fn times(&self, factor: Complex64) -> Self {
        Self {
            stroke: factor * self.stroke,
            input: factor * self.input,
            output: factor * self.output,
            deflection: factor * self.deflection,
            inductance: factor * self.inductance,
        }
    }

    /// The force of a channel.
    ///
    /// # Errors
    /// [`Error::MissingSignal`] for a channel that is no force.
    pub fn of(&self, channel: Channel) -> Result<Complex64, Error> {
        match channel {
            Channel::InputForce => Ok(self.input),
            Channel::OutputForce => Ok(self.output),
            Channel::DeflectionForce => Ok(self.deflection),
            Channel::InductanceForce => Ok(self.inductance),
            other => Err(Error::MissingSignal(other.name())),
        }
    }
}

impl Plant {
    /// A drive at end 1 of a spring with a load on end 2.
    ///
    /// The chain is damped relative to the straight line between its ends ([`Damping`]); F_L is taken at the middle of the operating range.
    ///
    /// # Errors
    /// [`Error::Value`] for a drive or damping whose numbers are not sound; a loss factor has no loop over time and is refused.
    pub fn new(spring: &Spring, damping: Damping, drive: Drive, environment: Environment) -> Result<Self, Error> {
        let two_port = TwoPort::chain(spring, damping.clone())?;
        let coil = Coil::of(spring, &damping)?;
        let (drive, environment) = (drive.checked()?, environment.checked()?);
        Ok(Self { spring: spring.clone(), damping, drive, environment, two_port, coil })
    }

    /// The spring.
    pub fn spring(&self) -> &Spring {
        &self.spring
    }

    /// Its damping.
    pub fn damping(&self) -> &Damping {
        &self.damping
    }

    /// The drive.
    pub fn drive(&self) -> &Drive {
        &self.drive
    }

    /// What end 2 meets.
    pub fn environment(&self) -> &Environment {
        &self.environment
    }

    /// The spring over frequency.
    pub(super) fn two_port(&self) -> &TwoPort {
        &self.two_port
    }

    /// Surge with both ends held: angular frequencies and half widths \[rad/s\], near which the plant turns quickly.
    pub(super) fn lines(&self) -> impl Iterator<Item = (f64, f64)> {
        let held = self.coil.frequencies.iter().zip(&self.coil.ratios);
        held.map(|(frequency, ratio)| (*frequency, (ratio * frequency).max(1e-9 * frequency)))
    }

    /// ω_j \[rad/s\] and ζ_j of the modes with both ends held.
    pub(super) fn held_modes(&self) -> [&[f64]; 2] {
        [&self.coil.frequencies, &self.coil.ratios]
    }

    /// What a force jumps by with the command \[N per m/s\]: where dashpots hang on an end that an ideal velocity source moves, β Σ p_j c1_j.
    pub(super) fn jump(&self, force: Channel) -> f64 {
        let dashpot = self.damping.dashpot_time();
        if dashpot == 0.0 || self.drive != Drive::IDEAL_VELOCITY {
            return 0.0;
        }
        let modes = ChainModes::of(&self.spring);
        let weights = match force {
            Channel::InputForce => modes.input_weights(),
            Channel::OutputForce => modes.output_weights(),
            _ => return 0.0,
        };
        let by_segment = 2.0 * modes.masses() as f64 * self.spring.stiffness();
        let [drive, _] = modes.participations();
        dashpot * by_segment * weights.iter().zip(drive).map(|(weight, drive)| weight * drive).sum::<f64>()
    }

    /// A line of no width cannot be followed: every mode must be damped.
    pub(super) fn check_damped(&self) -> Result<(), Error> {
        let least = self.coil.ratios.iter().copied().fold(f64::INFINITY, f64::min);
        check(least >= LEAST_RATIO, "damping_ratio", least, "", format!("at least {LEAST_RATIO} for a loop's response"))
            .map(|_| ())
    }

    /// Force by windings out of line per modal coordinate \[N/m\], as F_x loses it to F_L; shape `modes`.
    pub(super) fn coil_weights(&self) -> &[f64] {
        &self.coil.weights
    }

    /// Everything over the command at one angular frequency.
    ///
    /// F_i = K y, F_o = T F_i, F_x = k (1 − R) y, y the drive's; K, T, R the spring's stiffness at end 1, transmittance and motion ratio
    /// with its load
    ///
    /// - `angular_frequency`: ω \[rad/s\], above zero
    ///
    /// Source:   [`crate::two_port::DynamicStiffness`]; F_L by the modes and the gradient of Maxwell's sum, `[Weijde2017]` eqs. 8–13.
    /// Valid:    small motions, windings that never touch.
    /// Accuracy: that of the two-port; F_L sums the chain's modes, to 1e-13 of its largest term.
    ///
    /// # Errors
    /// [`Error::Value`] for a frequency that is not above zero and finite.
    pub fn at(&self, angular_frequency: f64) -> Result<Response, Error> {
        check(angular_frequency > 0.0, "angular_frequency", angular_frequency, "rad/s", "above zero and finite")?;
        let ends = self.two_port.at(angular_frequency)?;
        let s = Complex64::new(0.0, angular_frequency);
        let load = self.environment.at(angular_frequency)?;
        let stroke = self.drive.stroke(s, ends.loaded(&load));
        Ok(self.response(&ends, s, &load, stroke))
    }

    fn response(&self, ends: &DynamicStiffness, s: Complex64, load: &Load, stroke: Complex64) -> Response {
        let follow = ends.motion_ratio(load);
        let input = ends.loaded(load) * stroke;
        let deflection = self.spring.stiffness() * (1.0 - follow) * stroke;
        Response {
            stroke,
            input,
            output: ends.transmittance(load) * input,
            deflection,
            inductance: deflection - self.coil.surge(s, follow) * stroke,
        }
    }

    /// Force over the command of the same drive and load with a spring without mass.
    ///
    /// K = k K_L/(k + K_L); k where end 2 is held
    ///
    /// # Errors
    /// As [`Self::at`].
    pub fn massless(&self, angular_frequency: f64) -> Result<Complex64, Error> {
        check(angular_frequency > 0.0, "angular_frequency", angular_frequency, "rad/s", "above zero and finite")?;
        let k = self.spring.stiffness();
        let stiffness = match self.environment.at(angular_frequency)?.at(angular_frequency) {
            None => Complex64::from(k),
            Some(load) if load.norm() == 0.0 => Complex64::ZERO,
            Some(load) => k * load / (k + load),
        };
        Ok(stiffness * self.drive.stroke(Complex64::new(0.0, angular_frequency), stiffness))
    }
}
