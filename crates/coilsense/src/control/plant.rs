//! The plant: a drive, the spring with its load, and what each force signal makes of a command.
//!
//! Next door: the controller around it (`force_loop`), the spring alone (`crate::two_port`).

use num_complex::Complex64;

use super::drive::Drive;
use crate::damping::Damping;
use crate::error::{Error, check, not_negative};
use crate::inductance::{MaxwellSum, SelfDistance};
use crate::modes::ChainModes;
use crate::signals::Channel;
use crate::spring::Spring;
use crate::two_port::{DynamicStiffness, Load, TwoPort};

/// What end 2 meets.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Environment {
    /// It does not move.
    Held,
    /// A mass on a spring and a damper to the ground: K_L = k_L + jω b_L − ω² M_L, each zero or above.
    Impedance {
        /// M_L \[kg\].
        mass: f64,
        /// b_L \[N s/m\].
        damping: f64,
        /// k_L \[N/m\].
        stiffness: f64,
    },
}

impl Environment {
    fn checked(self) -> Result<Self, Error> {
        if let Self::Impedance { mass, damping, stiffness } = self {
            not_negative("load mass", mass, "kg")?;
            not_negative("load damping", damping, "N s/m")?;
            not_negative("load stiffness", stiffness, "N/m")?;
        }
        Ok(self)
    }

    /// The load at one angular frequency \[rad/s\].
    fn at(&self, angular_frequency: f64) -> Result<Load, Error> {
        match *self {
            Self::Held => Ok(Load::HELD),
            Self::Impedance { mass, damping: 0.0, stiffness: 0.0 } => Load::mass(mass),
            Self::Impedance { mass, damping, stiffness } => {
                let elastic = stiffness - mass * angular_frequency * angular_frequency;
                Load::stiffness(Complex64::new(elastic, damping * angular_frequency))
            }
        }
    }
}

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

/// What windings out of line do to the inductance's force, mode by mode.
#[derive(Debug, Clone, PartialEq)]
struct Coil {
    frequencies: Vec<f64>,
    ratios: Vec<f64>,
    /// c1_j, c2_j.
    participations: [Vec<f64>; 2],
    /// Force by the inductance per modal coordinate \[N/m\].
    weights: Vec<f64>,
}

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

    /// A line of no width cannot be followed: every mode must be damped.
    pub(super) fn check_damped(&self) -> Result<(), Error> {
        let least = self.coil.ratios.iter().copied().fold(f64::INFINITY, f64::min);
        check(least >= LEAST_RATIO, "damping ratio", least, "", format!("at least {LEAST_RATIO} for a loop's response"))
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
        check(angular_frequency > 0.0, "angular frequency", angular_frequency, "rad/s", "above zero and finite")?;
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
        check(angular_frequency > 0.0, "angular frequency", angular_frequency, "rad/s", "above zero and finite")?;
        let k = self.spring.stiffness();
        let stiffness = match self.environment.at(angular_frequency)?.at(angular_frequency) {
            None => Complex64::from(k),
            Some(load) if load.norm() == 0.0 => Complex64::ZERO,
            Some(load) => k * load / (k + load),
        };
        Ok(stiffness * self.drive.stroke(Complex64::new(0.0, angular_frequency), stiffness))
    }
}

impl Coil {
    fn of(spring: &Spring, damping: &Damping) -> Result<Self, Error> {
        let modes = ChainModes::of(spring);
        let (masses, length) = (modes.masses(), spring.mid_length());
        let places: Vec<f64> = (1..=masses).map(|winding| (winding as f64 - 0.5) / masses as f64).collect();
        let uniform: Vec<f64> = places.iter().map(|place| place * length).collect();
        let gradient = MaxwellSum::new(spring, SelfDistance::AsPrinted).gradient([0.0, length], &uniform)?;
        // dL/dl of a uniform stretch: what a calibration divides by.
        let stretch: f64 = gradient[1..=masses].iter().zip(&places).map(|(slope, place)| slope * place).sum();
        let by_length = stretch + gradient[masses + 1];
        let weight = |mode: usize| {
            let shape = (1..=masses).map(|winding| gradient[winding] * modes.shape_at(mode, winding));
            spring.stiffness() * shape.sum::<f64>() / by_length
        };
        let ratios = damping.ratios(modes.frequencies())?;
        let [first, second] = modes.participations();
        Ok(Self {
            weights: (1..=modes.count()).map(weight).collect(),
            participations: [first.to_vec(), second.to_vec()],
            frequencies: modes.frequencies().to_vec(),
            ratios,
        })
    }

    /// Force by windings out of line over U1 \[N/m\], end 2 following by `follow`: Σ w_j q_j/U1, q_j = −s² (c1 + c2 R)/(s² + 2ζωs + ω²).
    fn surge(&self, s: Complex64, follow: Complex64) -> Complex64 {
        let [first, second] = &self.participations;
        let each = self.frequencies.iter().zip(&self.ratios).zip(first.iter().zip(second)).zip(&self.weights);
        each.map(|(((frequency, ratio), (c1, c2)), weight)| {
            let resonance = s * s + 2.0 * ratio * frequency * s + frequency * frequency;
            -weight * s * s * (c1 + c2 * follow) / resonance
        })
        .sum()
    }
}
