//! Where the windings start, in modal coordinates.
//!
//! Next door: how they go on (`closed`, `march`).

use super::Motion;
use super::closed::ModalState;
use crate::error::{Error, count};
use crate::excitation::{Start, VelocityProfile};

impl Motion {
    /// The start relative to the straight line between the ends. What is affine along the coil is projected in closed form.
    ///
    /// An end mass starts as a winding at end 2 would; with a start given winding by winding, at its mean and at rest.
    pub(super) fn relative_start(&self) -> Result<ModalState, Error> {
        let mean = self.excitation.mean_length();
        let [first, second] = self.line(0.0);
        let (u, v) = ([first, second - mean], self.line_velocity(0.0));
        let lines = |displacement, velocity| ModalState {
            coordinates: self.modes.project_line(displacement),
            rates: self.modes.project_line(velocity),
        };
        Ok(match self.excitation.start() {
            Start::Massless => lines([0.0; 2], [0.0; 2]),
            Start::Rest => lines([-u[0], -u[1]], [-v[0], -v[1]]),
            Start::Moving { velocity, profile } => {
                let at_end_1 = match profile {
                    VelocityProfile::Uniform => *velocity,
                    VelocityProfile::Linear => 0.0,
                };
                lines([-u[0], -u[1]], [at_end_1 - v[0], velocity - v[1]])
            }
            Start::Windings { positions, velocities } => {
                count("start positions", positions.len(), self.modes.masses())?;
                ModalState {
                    coordinates: self.modes.project(&less_line(positions, [u[0], mean + u[1]]), -u[1]),
                    rates: self.modes.project(&less_line(velocities, v), -v[1]),
                }
            }
        })
    }
}

/// `values` less the straight line from `line[0]` at end 1 to `line[1]` at end 2.
fn less_line(values: &[f64], line: [f64; 2]) -> Vec<f64> {
    let spacing = (line[1] - line[0]) / values.len() as f64;
    let each = values.iter().enumerate();
    each.map(|(index, value)| value - (line[0] + (index as f64 + 0.5) * spacing)).collect()
}
