//! What damps the windings, and how much of it each mode feels.
//!
//! Next door: the mount that carries it (`mount`), the motion under it (`motion`), its effect over frequency (`two_port`).

use crate::error::{Error, called, check, count, entry, not_negative};

/// Damping of the windings.
///
/// It acts on winding velocities *relative to the straight line between the ends*, so a spring that is carried along feels none, and an end
/// that jumps by h gives each mode an impulse, 2ζ_jω_j c_j h of q̇_j ([`crate::Motion`]).
/// Over time, where end 2 carries a mass or is under a force, the line ends where a spring without mass would end: each mode of the
/// mounted spring has its ζ_j, the swing of the end mass included. Over frequency a [`crate::two_port::TwoPort`] knows no mount: its line
/// runs to end 2 wherever that is, so under a load only what the coil does between its ends is damped.
/// F_i and F_o are the end segments' elastic force, plus their dashpot for stiffness-proportional damping only.
///
/// No citable measured range of ζ for coil springs is known: identify it from a log, and show results as a band.
#[derive(Debug, Clone, PartialEq, Default)]
pub enum Damping {
    /// None: the paper's case.
    #[default]
    None,
    /// The same damping ratio ζ \[1\] in every mode.
    Modal(f64),
    /// A damping ratio ζ_j \[1\] for each mode, lowest first.
    ModalEach(Vec<f64>),
    /// ζ_j = α / 2ω_j: as in a viscous fluid.
    MassProportional {
        /// α \[1/s\].
        rate: f64,
    },
    /// ζ_j = β ω_j / 2: a dashpot beside every segment.
    StiffnessProportional {
        /// β \[s\].
        time: f64,
    },
    /// Stiffness k (1 + iη), which has a meaning over frequency only.
    Hysteretic {
        /// η \[1\].
        loss_factor: f64,
    },
}

impl Damping {
    /// Lets through damping whose every value is finite and not below zero.
    ///
    /// # Errors
    /// [`Error::Value`] for the first value that is not.
    pub(crate) fn checked(self) -> Result<Self, Error> {
        match &self {
            Self::None => {}
            Self::Modal(ratio) => {
                not_negative("damping_ratio", *ratio, "")?;
            }
            Self::ModalEach(ratios) => {
                for (index, &ratio) in ratios.iter().enumerate() {
                    let holds = ratio.is_finite() && ratio >= 0.0;
                    check(holds, entry("damping_ratio", index), ratio, "", "finite and not below zero")?;
                }
            }
            Self::MassProportional { rate } => {
                not_negative(called("rate", "mass-proportional damping"), *rate, "1/s")?;
            }
            Self::StiffnessProportional { time } => {
                not_negative(called("time", "stiffness-proportional damping"), *time, "s")?;
            }
            Self::Hysteretic { loss_factor } => {
                not_negative("loss_factor", *loss_factor, "")?;
            }
        }
        Ok(self)
    }

    /// ζ_j \[1\] of modes with the angular frequencies ω_j \[rad/s\], shape `modes` to shape `modes`.
    ///
    /// ζ_j = ζ, ζ_j, α / 2ω_j or β ω_j / 2
    ///
    /// Source:   definition; any text on modal analysis.
    /// Valid:    viscous damping; a loss factor has no ζ over time.
    /// Accuracy: 2e-16 relative.
    ///
    /// # Errors
    /// [`Error::Count`] where damping for each mode is given for another number of modes; [`Error::Value`] for a loss factor.
    ///
    /// ```
    /// let ratios = coilsense::Damping::StiffnessProportional { time: 1e-4 }.ratios(&[100.0, 200.0])?;
    /// assert_eq!(ratios, [0.005, 0.01]);
    /// # Ok::<(), coilsense::Error>(())
    /// ```
    pub fn ratios(&self, frequencies: &[f64]) -> Result<Vec<f64>, Error> {
        let each = frequencies.iter();
        Ok(match self {
            Self::None => vec![0.0; frequencies.len()],
            Self::Modal(ratio) => vec![*ratio; frequencies.len()],
            Self::ModalEach(ratios) => {
                count("damping_ratios", ratios.len(), frequencies.len())?;
                ratios.clone()
            }
            Self::MassProportional { rate } => each.map(|frequency| 0.5 * rate / frequency).collect(),
            Self::StiffnessProportional { time } => each.map(|frequency| 0.5 * time * frequency).collect(),
            Self::Hysteretic { loss_factor } => {
                let allowed = "zero for a motion over time: it has a meaning over frequency only";
                check(*loss_factor == 0.0, "loss_factor", *loss_factor, "", allowed)?;
                vec![0.0; frequencies.len()]
            }
        })
    }

    /// β \[s\] of the dashpots in the end segments: zero but for stiffness-proportional damping.
    pub(crate) fn dashpot_time(&self) -> f64 {
        match self {
            Self::StiffnessProportional { time } => *time,
            _ => 0.0,
        }
    }
}
