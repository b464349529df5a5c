//! What moves end 1: a velocity source, or a force on the motor's mass.
//!
//! Next door: the spring it pulls at (`plant`).

use std::f64::consts::TAU;

use num_complex::Complex64;

use crate::error::{Error, above_zero, called, not_negative};

/// A drive: its command pulls end 1 away from end 2, so that a command above zero stretches the spring; y = −u1.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Drive {
    /// A stiff gear with a velocity loop: the command is ẏ \[m/s\].
    Velocity {
        /// Where the velocity loop's first-order lag has lost 3 dB \[Hz\]; `None` for an ideal source.
        bandwidth: Option<f64>,
    },
    /// A motor: the command is its force \[N\] on its own mass, against which the spring pulls.
    Force {
        /// Motor mass seen at end 1 \[kg\]: rotor inertia times the square of the gear ratio.
        mass: f64,
        /// Viscous friction \[N s/m\].
        friction: f64,
        /// Where the current loop's first-order lag has lost 3 dB \[Hz\]; `None` for an ideal one.
        bandwidth: Option<f64>,
    },
}

impl Drive {
    /// A velocity source without a lag.
    pub const IDEAL_VELOCITY: Self = Self::Velocity { bandwidth: None };

    /// Lets through a drive whose numbers are sound.
    pub(super) fn checked(self) -> Result<Self, Error> {
        let (Self::Velocity { bandwidth } | Self::Force { bandwidth, .. }) = self;
        if let Some(bandwidth) = bandwidth {
            above_zero(called("bandwidth", "drive bandwidth"), bandwidth, "Hz")?;
        }
        if let Self::Force { mass, friction, .. } = self {
            above_zero(called("mass", "motor mass"), mass, "kg")?;
            not_negative(called("friction", "motor friction"), friction, "N s/m")?;
        }
        Ok(self)
    }

    /// The unit of its command.
    pub fn command_unit(&self) -> &'static str {
        match self {
            Self::Velocity { .. } => "m/s",
            Self::Force { .. } => "N",
        }
    }

    /// The lag between command and what it stands for \[1\].
    fn lag(&self, s: Complex64) -> Complex64 {
        let (Self::Velocity { bandwidth } | Self::Force { bandwidth, .. }) = self;
        bandwidth.map_or(Complex64::ONE, |bandwidth| (1.0 + s / (TAU * bandwidth)).inv())
    }

    /// y over the command, where the spring answers y with the force `stiffness` y \[N/m\].
    ///
    /// velocity: G/s; force: G / (M s² + b s + K), G = 1/(1 + s/ω_b)
    pub(super) fn stroke(&self, s: Complex64, stiffness: Complex64) -> Complex64 {
        match self {
            Self::Velocity { .. } => self.lag(s) / s,
            Self::Force { .. } => self.lag(s) / (self.own_stiffness(s) + stiffness),
        }
    }

    /// What it takes to move the drive itself, force over y \[N/m\]; a velocity source cannot be moved.
    pub(super) fn own_stiffness(&self, s: Complex64) -> Complex64 {
        match self {
            Self::Velocity { .. } => Complex64::from(f64::INFINITY),
            Self::Force { mass, friction, .. } => (mass * s + friction) * s,
        }
    }

    /// Answer of its own motion to a command, the spring let go: G/s, or G/(M s² + b s).
    pub(super) fn free_stroke(&self, s: Complex64) -> Complex64 {
        match self {
            Self::Velocity { .. } => self.lag(s) / s,
            Self::Force { .. } => self.lag(s) / self.own_stiffness(s),
        }
    }

    /// Command over the force of a spring of stiffness k without mass, the lag left out: what a disturbance observer inverts;
    /// coefficients of rising powers of s.
    pub(super) fn nominal_inverse(&self, stiffness: f64) -> Vec<f64> {
        match self {
            Self::Velocity { .. } => vec![0.0, 1.0 / stiffness],
            Self::Force { mass, friction, .. } => vec![1.0, friction / stiffness, mass / stiffness],
        }
    }
}
