//! The spring's motion, exact: modal coefficients found once, then evaluated at any times; step by step only where an input has no
//! elementary solution.
//!
//! Next door: what is done to the spring (`excitation`), how it is mounted (`mount`), its modes (`modes`), what sensors make of it
//! (`sensors`).

mod closed;
mod ends;
mod exponentials;
mod forces;
mod kicked_blocks;
mod live;
mod march;
mod modal_block;
mod modal_rows;
mod oscillator;
mod panel;
mod phasor_sum;
mod phasors;
mod placing;
mod reach;
mod recorded;
mod sines;
mod start;
#[cfg(test)]
mod stepwise;
mod stream;
mod stretch;
mod stride;
mod truncated;
mod turns;
mod windings;

pub use live::Live;
pub(crate) use modal_rows::WIDTH;
use placing::Placing;
pub use stream::{ForceSample, Stream};
pub use windings::Windings;

pub use forces::EndForces;

use crate::damping::Damping;
use crate::error::{Error, at_least_one, check, entry};
use crate::excitation::{End, EndInput, Excitation};
use crate::modes::ModalModel;
use crate::mount::{FarEnd, Mount};
use crate::signals::{Channel, Signals};
use crate::spring::Spring;
use closed::{Closed, ModalState};
use march::March;
use truncated::Remainder;

/// Most windings whose positions are found: their shapes are a matrix of that many rows and columns, 200 MB.
const MOST_PLACED: usize = 5000;

/// Largest damping ratio of a motion over time: a mode that creeps a thousand times slower than it would swing is no spring.
const LARGEST_RATIO: f64 = 1e3;

/// Motion of the paper's chain under one excitation.
///
/// Winding i sits at `x_i = u1 + s_i (û2 − u1) + Σ_j q_j φ_j(i)`, `s_i = (i−½)/N`, where û2 is u2 if its position is prescribed and
/// otherwise where a spring without mass would end; `q̈_j + 2ζ_jω_j q̇_j + ω_j² q_j = −(c1_j ẅ1 + c2_j ẅ2)` (see [`ModalModel`], of which the chain's closed form is one).
/// Where an input jumps by h, q_j jumps by −c_j h and, as damping acts on it, q̇_j by 2ζ_jω_j c_j h: a step is the limit of short ramps.
/// Sums of sines, steps, ramps, half sines and short recordings have a closed solution. A chirp and a long recording are followed from
/// time to time, exactly: a recording by its kicks under first-order hold, a chirp by Gauss's rule to 1e-16 a step.
///
/// Source:   `[Weijde2017]` eqs. 4–7; end mass, prescribed force and damping derived in `modes` and `damping`.
/// Valid:    linear, windings that never touch (see [`crate::measures::Clash`]).
/// Accuracy: end forces and positions within 1e-12 of their peak over 1 s, against a 40-digit reference.
///
/// ```
/// use coilsense::{Excitation, Motion};
/// # let spring = coilsense::paper::s_t();
/// let motion = Motion::new(&spring, &Excitation::impact(0.23, 0.25)?)?;
/// let forces = motion.end_forces(&[0.0, 0.75, 1.0])?;
/// assert!((forces.input[0] - spring.static_force(0.23)).abs() < 1e-9); // windings still uniform
/// # Ok::<(), coilsense::Error>(())
/// ```
#[derive(Debug, Clone)]
pub struct Motion {
    spring: Spring,
    mount: Mount,
    excitation: Excitation,
    modes: ModalModel,
    ratios: Vec<f64>,
    start: ModalState,
    closed: Option<Closed>,
    remainder: Remainder,
}

impl Motion {
    /// On the paper's mount: both positions prescribed, no damping.
    ///
    /// # Errors
    /// [`Error::Count`] where the excitation starts a number of windings that the spring's chain does not have.
    pub fn new(spring: &Spring, excitation: &Excitation) -> Result<Self, Error> {
        Self::mounted(spring, &Mount::default(), excitation)
    }

    /// On any mount. Where end 2's position is not prescribed, its input is a force \[N\] about that of the mean length.
    ///
    /// # Errors
    /// As [`Self::new`], those of [`crate::Damping::ratios`], and [`Error::Value`] for a mode with a damping ratio above 1000.
    pub fn mounted(spring: &Spring, mount: &Mount, excitation: &Excitation) -> Result<Self, Error> {
        Self::built(spring, mount.clone(), ModalModel::chain(spring, mount.far_end()), excitation)
    }

    /// Of a spring whose modes were found elsewhere: a helix's come with [`crate::helix::Surge::motion`]. F_x, the mean force and where windings may touch are those of `spring`.
    ///
    /// # Errors
    /// As [`Self::mounted`].
    pub fn of_modes(
        spring: &Spring,
        modes: ModalModel,
        damping: Damping,
        excitation: &Excitation,
    ) -> Result<Self, Error> {
        let mount = Mount::new(modes.far_end(), damping)?;
        Self::built(spring, mount, modes, excitation)
    }

    fn built(spring: &Spring, mount: Mount, modes: ModalModel, excitation: &Excitation) -> Result<Self, Error> {
        let ratios = mount.damping().ratios(modes.frequencies())?;
        if let Some(mode) = ratios.iter().position(|ratio| *ratio > LARGEST_RATIO) {
            let quantity = format!("damping ratio of mode {}", mode + 1);
            check(false, quantity, ratios[mode], "", format!("at most {LARGEST_RATIO}"))?;
        }
        let mut motion = Self {
            spring: spring.clone(),
            mount,
            excitation: excitation.clone(),
            remainder: Remainder::of(&modes),
            modes,
            ratios,
            start: ModalState { coordinates: Vec::new(), rates: Vec::new() },
            closed: None,
        };
        motion.start = motion.relative_start()?;
        motion.closed = Closed::new(&motion.modes, &motion.ratios, motion.start.clone(), motion.inputs());
        Ok(motion)
    }

    /// The spring that moves.
    pub fn spring(&self) -> &Spring {
        &self.spring
    }

    /// What its end 2 is tied to, and its damping.
    pub fn mount(&self) -> &Mount {
        &self.mount
    }

    /// What is done to it.
    pub fn excitation(&self) -> &Excitation {
        &self.excitation
    }

    /// Its modes.
    pub fn modes(&self) -> &ModalModel {
        &self.modes
    }

    fn inputs(&self) -> [&EndInput; 2] {
        [self.excitation.input(End::One), self.excitation.input(End::Two)]
    }

    /// A march from t = 0, in steps that are mostly `nominal`.
    fn march(&self, nominal: f64) -> March {
        March::new(&self.modes, &self.ratios, self.start.clone(), self.inputs(), nominal)
    }

    /// Ends of the straight line from which the modes count, at time `time` \[s\], in \[m\]: u1 and û2.
    fn line(&self, time: f64) -> [f64; 2] {
        self.line_of(self.inputs().map(|input| input.displacement(time)))
    }

    /// The same for inputs counted from their means.
    fn line_of(&self, [first, second]: [f64; 2]) -> [f64; 2] {
        let mean = self.excitation.mean_length();
        match self.mount.far_end() {
            FarEnd::Position => [first, mean + second],
            _ => [first, mean + first + second / self.spring.stiffness()],
        }
    }

    /// How fast the ends of that line move \[m/s\].
    fn line_velocity(&self, time: f64) -> [f64; 2] {
        let [first, second] = self.inputs().map(|input| input.velocity(time));
        match self.mount.far_end() {
            FarEnd::Position => [first, second],
            _ => [first, first + second / self.spring.stiffness()],
        }
    }

    /// Positions of both ends and all windings \[m\].
    ///
    /// - `times`: t \[s\], shape `samples`, in any order, none below zero
    ///
    /// # Errors
    /// [`Error::Count`] for no times; [`Error::Value`] for the first that is not finite or below zero, or more than 5000 windings.
    pub fn windings(&self, times: &[f64]) -> Result<Windings, Error> {
        let masses = self.placeable()?;
        let mut windings = Windings::zero(self.end_positions(times)?, masses);
        let lines = self.lines(times);
        let shape = |mode: usize, place: usize| self.modes.shape_at(mode + 1, place + 1);
        let mut placing = Placing::new(masses, self.modes.count(), self.modes.is_mirrored(), shape);
        let places: Vec<f64> = (1..=masses).map(|mass| self.modes.place_at(mass)).collect();
        let evenly = self.modes.is_evenly_wound();
        let offsets: Vec<f64> = (1..=masses).filter(|_| !evenly).map(|mass| self.modes.offset_at(mass)).collect();
        self.for_each_block(times, |block| {
            let displacements = placing.displace(&block);
            windings.place(block.samples, displacements, &places, &lines);
        })?;
        windings.shift(&offsets);
        Ok(windings)
    }

    /// Velocities of all windings \[m/s\], shape `N`, at time `time` \[s\].
    ///
    /// # Errors
    /// [`Error::Value`] for a time that is not finite or below zero.
    pub fn velocities(&self, time: f64) -> Result<Vec<f64>, Error> {
        check_times(&[time])?;
        let state = self.modal_state(time);
        let masses = self.placeable()?;
        let mut row = vec![0.0; masses];
        let [first, last] = self.line_velocity(time);
        for (index, velocity) in row.iter_mut().enumerate() {
            let modes = state.rates.iter().enumerate();
            let surge: f64 = modes.map(|(mode, rate)| self.modes.shape_at(mode + 1, index + 1) * rate).sum();
            *velocity = first + self.modes.place_at(index + 1) * (last - first) + surge;
        }
        Ok(row)
    }

    /// Velocity of end 2 \[m/s\] where it follows its mass, or of the line where it does not; the time is trusted.
    pub(crate) fn end_velocity(&self, time: f64) -> f64 {
        let state = self.modal_state(time);
        let of_modes: f64 = self.modes.end_shapes().iter().zip(&state.rates).map(|(shape, rate)| shape * rate).sum();
        self.line_velocity(time)[1] + of_modes
    }

    /// u1, u2, F_i, F_o and F_x over `times`; sensors add theirs.
    ///
    /// - `times`: t \[s\], shape `samples`, strictly increasing, none below zero
    ///
    /// # Errors
    /// [`Error::Value`] for the first time that is not finite, below zero, or not after its predecessor.
    pub fn signals(&self, times: &[f64]) -> Result<Signals, Error> {
        let forces = self.end_forces(times)?;
        let [u1, u2] = self.end_positions(times)?;
        // As `sensors::deflection_force`, which stands after this module in the corridor.
        let deflection = u1.iter().zip(&u2).map(|(u1, u2)| self.spring.static_force(u2 - u1)).collect();
        let mut signals = Signals::new(times.to_vec())?;
        signals.insert(Channel::U1, u1)?;
        signals.insert(Channel::U2, u2)?;
        signals.insert(Channel::InputForce, forces.input)?;
        signals.insert(Channel::OutputForce, forces.output)?;
        signals.insert(Channel::DeflectionForce, deflection)?;
        Ok(signals)
    }

    /// The masses' mechanical energy at time `time` \[s\], in \[J\]: kinetic plus elastic (counted from the rest length), without an end mass.
    /// Of a helix ([`crate::helix::Surge`]) that of all motions of its wire.
    ///
    /// E = ½ Σ m_i ẋ_i² + ½ k (û2 − u1 − l0)² + k (û2 − u1 − l0) Σ ψ_j q_j + ½ Σ κ_j q_j², κ_j a mode's stiffness
    ///
    /// Source:   `[Weijde2017]` eqs. 4–6 in modal coordinates, in which the straight line and the modes share no energy but end 2's work.
    /// Valid:    as [`Motion`]; constant while both ends are held and nothing is damped.
    /// Accuracy: 1e-12 relative over 1 s for the paper's springs (test).
    ///
    /// # Errors
    /// [`Error::Value`] for a time that is not finite or below zero.
    pub fn energy(&self, time: f64) -> Result<f64, Error> {
        let [first, last] = self.line(time);
        let (k, stretch) = (self.spring.stiffness(), last - first - self.spring.rest_length());
        if let Some(FarEnd::Mass(_) | FarEnd::Force) = self.modes.tie().map(|_| self.mount.far_end()) {
            let allowed = "none of a helix whose end 2 has no prescribed position";
            check(false, "energy", time, "s", allowed)?;
        }
        if self.modes.left_out().is_some() {
            check_times(&[time])?;
            let state = self.modal_state(time);
            let each = |of: fn(&EndInput, f64) -> f64| self.inputs().map(|input| of(input, time));
            let line = [EndInput::velocity, EndInput::acceleration, EndInput::jerk].map(each);
            let beside = self.modes.wire_energy(line, [&state.coordinates, &state.rates]).unwrap_or_default();
            return Ok(0.5 * k * stretch * stretch + beside);
        }
        let velocities = self.velocities(time)?;
        let each = velocities.iter().enumerate();
        let kinetic: f64 = each.map(|(index, velocity)| self.modes.mass(index + 1) * velocity * velocity).sum();
        let state = self.modal_state(time);
        let of_mode = |(index, (q, shape)): (usize, (&f64, &f64))| {
            2.0 * k * stretch * shape * q + self.modes.modal_stiffness(index + 1) * q * q
        };
        let each = state.coordinates.iter().zip(self.modes.end_shapes()).enumerate();
        Ok(0.5 * (kinetic + k * stretch * stretch + each.map(of_mode).sum::<f64>()))
    }

    /// Modal coordinates at a time that is trusted.
    fn modal_state(&self, time: f64) -> ModalState {
        match &self.closed {
            Some(closed) => {
                let mut state = ModalState::zero(self.modes.count());
                closed.state_into(time, &mut state);
                state
            }
            None => {
                let mut march = self.march(time);
                march.advance_to(time);
                march.state()
            }
        }
    }

    /// N, where there are not too many windings to place them all.
    fn placeable(&self) -> Result<usize, Error> {
        let masses = self.modes.masses();
        let allowed = format!("at most {MOST_PLACED} for their positions");
        check(masses <= MOST_PLACED, "windings", masses as f64, "", allowed)?;
        Ok(masses)
    }
}

/// Numbers of the samples in the order of their times.
fn in_order(times: &[f64]) -> Vec<usize> {
    let mut order: Vec<usize> = (0..times.len()).collect();
    if !times.is_sorted() {
        order.sort_by(|&a, &b| times[a].total_cmp(&times[b]));
    }
    order
}

/// Mean step of a series of times, in order or in reverse.
fn step_of(times: &[f64]) -> f64 {
    match times.len() {
        0 | 1 => 1.0,
        count => (times[count - 1] - times[0]).abs() / (count - 1) as f64,
    }
}

/// Times must be finite and not before the start.
fn check_times(times: &[f64]) -> Result<(), Error> {
    at_least_one("times", times.len())?;
    match times.iter().position(|time| !time.is_finite() || *time < 0.0) {
        None => Ok(()),
        Some(index) => check(false, entry("time", index), times[index], "s", "finite and not below zero").map(|_| ()),
    }
}
