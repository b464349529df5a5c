//! From inductance to length, and from length to force: fits to measured points, how well they do, and how well the theories of a coil do beside them.
//!
//! Next door: the theories (`inductance::theories`), the sensor that uses a fit (`sensors`).

mod calibration;
mod cubic;
mod inductance;
mod inverse_length;
mod inversion;
mod line;
mod misfit;
mod points;
mod reading;
mod steel;
mod steel_doubts;
mod stiffness;

pub use calibration::{CALIBRATION_LENGTHS, Calibration, Theory};
pub use cubic::CubicFit;
pub use inductance::InductanceFit;
pub use inverse_length::InverseLengthFit;
pub use inversion::Inversion;
pub use line::FitMethod;
pub use misfit::Misfit;
pub use points::CalibrationPoints;
pub use reading::ReadingUncertainty;
pub use steel::{Permeability, SteelFit};
pub use steel_doubts::SteelDoubts;
pub use stiffness::StiffnessFit;
