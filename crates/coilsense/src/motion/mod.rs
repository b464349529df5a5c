//! The spring's motion, exact: modal coefficients found once, then evaluated at any times. Nothing is integrated in steps.
//!
//! Next door: what is done to the spring (`excitation`), its modes (`modes`), what sensors make of it (`sensors`).

mod forced;
mod modal;
mod windings;

pub use windings::Windings;

use crate::error::{Error, check, count};
use crate::excitation::{End, Excitation, Start, VelocityProfile};
use crate::modes::{ChainModes, end_sign};
use crate::signals::{Channel, Signals};
use crate::spring::Spring;
use modal::{Modal, Relative};

/// Motion of the paper's chain under one excitation.
///
/// Winding i sits at `x_i = u1 + s_i (u2 − u1) + Σ_j q_j φ_j(i)`, `s_i = (i−½)/N`, and
/// `q̈_j + ω_j² q_j = −c_j (ü1 + σ_j ü2)` (see [`ChainModes`]): every input here has a closed solution.
///
/// Source:   `[Weijde2017]` eqs. 4–7.
/// Valid:    no damping, linear, windings that never touch (see [`crate::measures::Clash`]).
/// Accuracy: end forces and positions within 1e-11 of their peak over 1 s, against a 40-digit modal sum.
///
/// ```
/// use coilsense::{Excitation, Motion};
/// # let spring = coilsense::Spring::new(coilsense::SpringParameters { rest_length: 0.104, windings: 52.0,
/// #     coil_radius: 0.008, wire_radius: 0.001, mass: 0.065, stiffness: 760.0, min_length: 0.196,
/// #     max_length: 0.264, nominal_force: None, inductance_windings: None })?;
/// let motion = Motion::new(&spring, &Excitation::impact(0.23, 0.25)?)?;
/// let forces = motion.end_forces(&[0.0, 0.75, 1.0])?;
/// assert!((forces.input[0] - spring.static_force(0.23)).abs() < 1e-9); // windings still uniform
/// # Ok::<(), coilsense::Error>(())
/// ```
#[derive(Debug, Clone)]
pub struct Motion {
    spring: Spring,
    excitation: Excitation,
    modes: ChainModes,
    modal: Modal,
}

/// The forces at both ends, each of shape `samples`, \[N\], tension positive.
#[derive(Debug, Clone, PartialEq)]
pub struct EndForces {
    /// F_i, at end 1.
    pub input: Vec<f64>,
    /// F_o, at end 2.
    pub output: Vec<f64>,
}

impl Motion {
    /// Solves for the modal coefficients.
    ///
    /// # Errors
    /// [`Error::Count`] where the excitation starts a number of windings that the spring's chain does not have.
    pub fn new(spring: &Spring, excitation: &Excitation) -> Result<Self, Error> {
        let modes = ChainModes::of(spring);
        if let Start::Windings { positions, .. } = excitation.start() {
            count("start positions", positions.len(), modes.count())?;
        }
        let (displacement, velocity) = relative_start(&modes, excitation);
        let inputs = [excitation.input(End::One), excitation.input(End::Two)];
        let modal = Modal::new(&modes, &displacement, &velocity, inputs);
        Ok(Self {
            spring: spring.clone(),
            excitation: excitation.clone(),
            modes,
            modal,
        })
    }

    /// The spring that moves.
    pub fn spring(&self) -> &Spring {
        &self.spring
    }

    /// What is done to it.
    pub fn excitation(&self) -> &Excitation {
        &self.excitation
    }

    /// u1 and u2 at time `time` \[s\], in \[m\]; end 1 has its mean at 0, end 2 at the mean length.
    pub fn ends(&self, time: f64) -> [f64; 2] {
        let input = |end| self.excitation.input(end).displacement(time);
        [input(End::One), self.excitation.mean_length() + input(End::Two)]
    }

    /// Forces at both ends \[N\], tension positive.
    ///
    /// F_i = F_x + 2Nk Σ_j q_j sin(jπ/2N), F_o = F_x + 2Nk Σ_j (−1)^j q_j sin(jπ/2N), F_x = k (u2 − u1 − l0)
    ///
    /// - `times`: t \[s\], shape `samples`, in any order, none below zero
    ///
    /// Source:   `[Weijde2017]` eq. 7, modal form.
    /// Valid:    as [`Motion`].
    /// Accuracy: 1e-11 of the peak, as [`Motion`].
    ///
    /// # Errors
    /// [`Error::Value`] for the first time that is not finite or below zero.
    pub fn end_forces(&self, times: &[f64]) -> Result<EndForces, Error> {
        check_times(times)?;
        let scale = 2.0 * self.modes.count() as f64 * self.spring.stiffness();
        let mut coordinates = vec![0.0; self.modes.count()];
        let (input, output) = times
            .iter()
            .map(|&time| {
                self.modal.coordinates(time, &mut coordinates);
                let (odd, even) = self.end_sums(&coordinates);
                let [u1, u2] = self.ends(time);
                let quasi_static = self.spring.static_force(u2 - u1);
                (quasi_static + scale * (odd + even), quasi_static - scale * (odd - even))
            })
            .unzip();
        Ok(EndForces { input, output })
    }

    /// Positions of both ends and all windings \[m\].
    ///
    /// - `times`: t \[s\], shape `samples`, in any order, none below zero
    ///
    /// # Errors
    /// [`Error::Value`] for the first time that is not finite or below zero.
    pub fn windings(&self, times: &[f64]) -> Result<Windings, Error> {
        check_times(times)?;
        let masses = self.modes.count();
        let mut windings = Windings::with_capacity(masses, times.len());
        let mut coordinates = vec![0.0; masses];
        let shapes = modal::shape_rows(&self.modes);
        let mut row = vec![0.0; masses];
        for &time in times {
            self.modal.coordinates(time, &mut coordinates);
            let ends = self.ends(time);
            place(&mut row, &shapes, &coordinates, ends);
            windings.push(ends, &row);
        }
        Ok(windings)
    }

    /// The chain's mechanical energy at time `time` \[s\], in \[J\]: kinetic plus elastic (counted from the rest length).
    ///
    /// E = ½ (m/N) Σ ẋ_i² + ½ Nk (2 S_0² + Σ S_i² + 2 S_N²), S of eq. (4) less its rest value
    ///
    /// Source:   `[Weijde2017]` eqs. 4–6.
    /// Valid:    as [`Motion`]; constant while both ends are held.
    /// Accuracy: 1e-12 relative over 1 s for the paper's springs (test).
    ///
    /// # Errors
    /// [`Error::Value`] for a time that is not finite or below zero.
    pub fn energy(&self, time: f64) -> Result<f64, Error> {
        let windings = self.windings(&[time])?;
        let masses = self.modes.count() as f64;
        let segment = self.spring.rest_length() / masses;
        let ([u1, u2], row) = (windings.ends(0), windings.row(0));
        let inner: f64 = row.windows(2).map(|pair| (pair[1] - pair[0] - segment).powi(2)).sum();
        let first = row[0] - u1 - 0.5 * segment;
        let last = u2 - row[row.len() - 1] - 0.5 * segment;
        let elastic = masses * self.spring.stiffness() * (2.0 * (first * first + last * last) + inner);
        let kinetic: f64 = self.velocities(time).iter().map(|v| v * v).sum();
        Ok(0.5 * (elastic + self.spring.mass() / masses * kinetic))
    }

    /// The mechanical signals u1, u2, F_i, F_o and F_x over `times`; sensors add theirs.
    ///
    /// - `times`: t \[s\], shape `samples`, strictly increasing, none below zero
    ///
    /// # Errors
    /// [`Error::Value`] for the first time that is not finite, below zero, or not after its predecessor.
    pub fn signals(&self, times: &[f64]) -> Result<Signals, Error> {
        let forces = self.end_forces(times)?;
        let (u1, u2): (Vec<f64>, Vec<f64>) = times.iter().map(|&time| self.ends(time).into()).unzip();
        let deflection = crate::sensors::deflection_force(&self.spring, &u1, &u2)?;
        let mut signals = Signals::new(times.to_vec())?;
        signals.insert(Channel::U1, u1)?;
        signals.insert(Channel::U2, u2)?;
        signals.insert(Channel::InputForce, forces.input)?;
        signals.insert(Channel::OutputForce, forces.output)?;
        signals.insert(Channel::DeflectionForce, deflection)?;
        Ok(signals)
    }

    /// Σ q_j sin(jπ/2N) over odd and over even modes \[m\].
    fn end_sums(&self, coordinates: &[f64]) -> (f64, f64) {
        let mut sums = [0.0; 2];
        for (index, (coordinate, shape)) in coordinates.iter().zip(self.modes.end_shapes()).enumerate() {
            sums[index % 2] += coordinate * shape;
        }
        (sums[0], sums[1])
    }

    /// Velocities of all windings \[m/s\], shape `N`.
    fn velocities(&self, time: f64) -> Vec<f64> {
        let masses = self.modes.count();
        let mut coordinates = vec![0.0; masses];
        self.modal.rates(time, &mut coordinates);
        let velocity = |end| self.excitation.input(end).velocity(time);
        let mut row = vec![0.0; masses];
        let ends = [velocity(End::One), velocity(End::Two)];
        place(&mut row, &modal::shape_rows(&self.modes), &coordinates, ends);
        row
    }
}

/// Straight line between the ends plus the modal pattern: works for positions and for velocities alike.
fn place(row: &mut [f64], shapes: &[f64], coordinates: &[f64], ends: [f64; 2]) {
    let masses = row.len();
    let spacing = (ends[1] - ends[0]) / masses as f64;
    row.fill(0.0);
    for (shape, coordinate) in shapes.chunks_exact(masses).zip(coordinates) {
        for (position, shape) in row.iter_mut().zip(shape) {
            *position += shape * coordinate;
        }
    }
    for (index, position) in row.iter_mut().enumerate() {
        *position += ends[0] + (index as f64 + 0.5) * spacing;
    }
}

/// Start of the windings relative to the straight line between the ends: displacements \[m\] and velocities \[m/s\].
fn relative_start(modes: &ChainModes, excitation: &Excitation) -> (Relative, Relative) {
    let displacement = |end| excitation.input(end).displacement(0.0);
    let velocity = |end| excitation.input(end).velocity(0.0);
    let (u, v) = (
        [displacement(End::One), displacement(End::Two)],
        [velocity(End::One), velocity(End::Two)],
    );
    match excitation.start() {
        Start::Massless => (Relative::Line([0.0; 2]), Relative::Line([0.0; 2])),
        Start::Rest => (Relative::Line([-u[0], -u[1]]), Relative::Line([-v[0], -v[1]])),
        Start::Moving {
            velocity: speed,
            profile,
        } => {
            let at_end_1 = match profile {
                VelocityProfile::Uniform => *speed,
                VelocityProfile::Linear => 0.0,
            };
            let line = [at_end_1 - v[0], speed - v[1]];
            (Relative::Line([-u[0], -u[1]]), Relative::Line(line))
        }
        Start::Windings { positions, velocities } => {
            let length = excitation.mean_length();
            let line = [u[0], length + u[1]];
            (
                Relative::Pattern(modes.project(&less_line(positions, line))),
                Relative::Pattern(modes.project(&less_line(velocities, v))),
            )
        }
    }
}

/// `values` less the straight line from `line[0]` at end 1 to `line[1]` at end 2.
fn less_line(values: &[f64], line: [f64; 2]) -> Vec<f64> {
    let spacing = (line[1] - line[0]) / values.len() as f64;
    values
        .iter()
        .enumerate()
        .map(|(index, value)| value - (line[0] + (index as f64 + 0.5) * spacing))
        .collect()
}

/// Times must be finite and not before the start.
fn check_times(times: &[f64]) -> Result<(), Error> {
    for (index, &time) in times.iter().enumerate() {
        check(
            time.is_finite() && time >= 0.0,
            format!("time[{index}]"),
            time,
            "s",
            "finite and not below zero",
        )?;
    }
    Ok(())
}

/// Modal coordinates of a straight line with the values `line` at ends 1 and 2, in closed form; shape `N`.
fn project_line(modes: &ChainModes, line: [f64; 2]) -> Vec<f64> {
    modes
        .participations()
        .iter()
        .enumerate()
        .map(|(index, participation)| participation * (line[0] + end_sign(index + 1) * line[1]))
        .collect()
}
