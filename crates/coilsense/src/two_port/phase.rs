//! Damping that only makes the phase of the undamped spring complex: none, mass- and stiffness-proportional, hysteretic.
//!
//! Next door: what the spring does at that phase (`propagation`); ratios mode by mode, which have no such phase (`modal`).

use num_complex::Complex64;

use crate::damping::Damping;
use crate::error::{Error, called, check};

/// One of the kinds of damping with a phase of its own.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Loss {
    None,
    /// α \[1/s\]
    Mass(f64),
    /// β \[s\]
    Stiffness(f64),
    /// η \[1\]
    Hysteretic(f64),
}

/// K/k, z and the share d of K that does not propagate: k_t = K (d + (1 − d) k_t(z)/k).
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Phase {
    pub rest: Complex64,
    pub phase: Complex64,
    pub direct: Complex64,
}

impl Loss {
    /// `None` for ratios mode by mode.
    pub fn of(damping: &Damping) -> Option<Self> {
        match damping {
            Damping::None => Some(Self::None),
            // ζ = 0 is no damping, and has a closed form.
            Damping::Modal(ratio) => (*ratio == 0.0).then_some(Self::None),
            Damping::ModalEach(_) => None,
            Damping::MassProportional { rate } => Some(Self::Mass(*rate)),
            Damping::StiffnessProportional { time } => Some(Self::Stiffness(*time)),
            Damping::Hysteretic { loss_factor } => Some(Self::Hysteretic(*loss_factor)),
        }
    }

    /// The phase at ω ≥ 0 \[rad/s\]; `phase` is ωτ, `transit_time` τ \[s\].
    ///
    /// The windings move relative to the line as those of the undamped spring at z, (1 − d) = ω²τ²/z² times as far (K real);
    /// the line itself carries the share d.
    pub fn at(self, omega: f64, phase: f64, transit_time: f64) -> Phase {
        let (rest, direct) = (Complex64::ONE, Complex64::ZERO);
        match self {
            Self::None | Self::Mass(0.0) => Phase { rest, phase: phase.into(), direct },
            Self::Mass(rate) => Phase {
                rest,
                phase: Complex64::new(phase * phase, -rate * transit_time * phase).sqrt(),
                direct: Complex64::new(0.0, -rate) / Complex64::new(omega, -rate),
            },
            Self::Stiffness(time) => Phase {
                rest,
                phase: phase / Complex64::new(1.0, omega * time).sqrt(),
                direct: Complex64::new(0.0, -omega * time),
            },
            Self::Hysteretic(loss_factor) => {
                let rest = Complex64::new(1.0, if omega == 0.0 { 0.0 } else { loss_factor });
                Phase { rest, phase: phase / rest.sqrt(), direct }
            }
        }
    }
}

/// Largest number of any damping: far above sense, low enough that no square overflows.
const LARGEST: f64 = 1e12;

/// Lets through damping whose numbers are sound and at most [`LARGEST`].
pub(super) fn moderate(damping: Damping) -> Result<Damping, Error> {
    let damping = damping.checked()?;
    let (quantity, value, unit) = match &damping {
        Damping::None => ("damping".into(), 0.0, ""),
        Damping::Modal(ratio) => ("damping_ratio".into(), *ratio, ""),
        Damping::ModalEach(ratios) => {
            (called("damping_ratio", "largest damping ratio"), ratios.iter().copied().fold(0.0, f64::max), "")
        }
        Damping::MassProportional { rate } => (called("rate", "mass-proportional damping"), *rate, "1/s"),
        Damping::StiffnessProportional { time } => (called("time", "stiffness-proportional damping"), *time, "s"),
        Damping::Hysteretic { loss_factor } => ("loss_factor".into(), *loss_factor, ""),
    };
    check(value <= LARGEST, quantity, value, unit, format!("at most {LARGEST:e}"))?;
    Ok(damping)
}
