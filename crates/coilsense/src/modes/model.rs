//! What a motion needs to know of a spring's modes, whatever found them.
//!
//! Next door: the chain's modes in closed form (the parent), those of a continuous wire (`wire`), the motion that is built from them (`motion`).

mod of_sections;
mod tied;
mod wire;

use super::{ChainModes, ChainShapes};
use crate::error::{Error, Subject, all_bounded, at_least_one, called, check, count};
use crate::mount::FarEnd;
use crate::spring::Spring;
pub(crate) use tied::Tied;
pub(crate) use wire::{LeftOut, SlowInertia, WireModes};

/// A spring's modes, ready for a motion: frequencies, participations, end forces, and where its masses are.
///
/// Mass i of N sits at `x_i = u1 + s_i (û2 − u1) + Σ_j q_j φ_j(i)`, end 2 at `û2 + Σ_j q_j ψ_j`, where û2 is where end 2 of a spring without
/// mass would be, and `q̈_j + 2ζ_jω_j q̇_j + ω_j² q_j = −(c1_j ẅ1 + c2_j ẅ2)`, w the inputs ([`crate::Motion`]). The forces at the ends are
/// that of the massless spring and `Σ_j p_j q_j`.
///
/// ```
/// use coilsense::modes::{ChainModes, ModalModel};
/// # let spring = coilsense::paper::s_t();
/// let model = ModalModel::chain(&spring, coilsense::FarEnd::Position);
/// assert_eq!(model.frequencies(), ChainModes::of(&spring).frequencies());
/// # Ok::<(), coilsense::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct ModalModel {
    far_end: FarEnd,
    frequencies: Vec<f64>,
    participations: [Vec<f64>; 2],
    /// p_j of both ends in units of `segment`.
    weights: [Vec<f64>; 2],
    /// A stiffness \[N/m\]: of the chain, that of an end segment.
    segment: f64,
    end_shapes: Vec<f64>,
    /// Projections of a rigid translation, and of the straight line from 0 at end 1 to 1 at end 2.
    line: [Vec<f64>; 2],
    norms: Vec<f64>,
    /// Mean of the masses \[kg\], of which `norms` are counted.
    mean_mass: f64,
    /// Mass of end 2 over that; zero but for an end mass.
    relative_end_mass: f64,
    shapes: Shapes,
    /// How much further from end 1 each mass of the unloaded spring is than its share of the length \[m\], shape `N`; none where the coil is evenly
    /// wound.
    offsets: Vec<f64>,
}

/// Where the masses are, and how they move.
#[derive(Debug, Clone, PartialEq)]
enum Shapes {
    /// Of the chain of equal masses.
    Chain(ChainShapes),
    /// Found elsewhere.
    Table {
        /// m_i over the mean \[1\].
        masses: Vec<f64>,
        /// s_i.
        places: Vec<f64>,
        /// φ_j(i), mode by mode.
        shapes: Vec<f64>,
    },
    /// Of equal shares of a continuous wire, evenly wound.
    Wire {
        count: usize,
        /// φ_j(i), mode by mode.
        shapes: Vec<f64>,
        inertia: SlowInertia,
        /// Where end 2 has no prescribed position.
        tied: Option<Tied>,
    },
}

/// Modes that were found elsewhere: of a spring of unequal masses or segments, say. Shapes may be scaled at will.
#[derive(Debug, Clone, PartialEq)]
pub struct ModalParameters {
    /// What end 2 is tied to.
    pub far_end: FarEnd,
    /// m_i \[kg\], shape `N`.
    pub masses: Vec<f64>,
    /// s_i: which share of the ends' distance mass i keeps from end 1 while the spring moves slowly \[1\], ascending, shape `N`.
    pub places: Vec<f64>,
    /// Stiffness of the segments between end 1 and mass 1, and between mass N and end 2 \[N/m\].
    pub end_segments: [f64; 2],
    /// ω_j \[rad/s\], shape `modes`, ascending.
    pub frequencies: Vec<f64>,
    /// φ_j(i) \[1\], shape `modes × N`, row-major.
    pub shapes: Vec<f64>,
    /// ψ_j, how far end 2 moves in each mode \[1\], shape `modes`; zero where its position is prescribed.
    pub end_shapes: Vec<f64>,
}

impl ModalParameters {
    /// Lengths that go together, and numbers that a spring can have.
    fn check(&self) -> Result<(), Error> {
        let (masses, modes) = (self.masses.len(), self.frequencies.len());
        at_least_one("masses", masses)?;
        at_least_one("modes", modes)?;
        count("places", self.places.len(), masses)?;
        count("end_shapes", self.end_shapes.len(), modes)?;
        count("shapes", self.shapes.len(), modes * masses)?;
        check_each(called("end_segments", "stiffness of an end segment"), "N/m", &self.end_segments)?;
        check_each("mass", "kg", &self.masses)?;
        check_rising("frequency", "rad/s", &self.frequencies, f64::INFINITY)?;
        check_rising("place", "", &self.places, 1.0)?;
        all_bounded("shapes", &self.shapes, "")?;
        all_bounded("end_shapes", &self.end_shapes, "")
    }
}

/// Lets through values that are finite and above zero.
fn check_each(quantity: impl Into<Subject> + Clone, unit: &'static str, values: &[f64]) -> Result<(), Error> {
    let each = values.iter();
    each.map(|value| check(value.is_finite() && *value > 0.0, quantity.clone(), *value, unit, "finite and above zero"))
        .try_for_each(|checked| checked.map(|_| ()))
}

/// Lets through values that rise from above zero to below `top`.
fn check_rising(quantity: &'static str, unit: &'static str, values: &[f64], top: f64) -> Result<(), Error> {
    let mut before = 0.0;
    for &value in values {
        let allowed =
            if top.is_finite() { format!("above {before}, below {top}") } else { format!("above {before} and finite") };
        check(value > before && value < top, quantity, value, unit, allowed)?;
        before = value;
    }
    Ok(())
}

impl ModalModel {
    /// The modes of a spring's chain with end 2 tied to `far_end`; of a coil of sections those of its unequal masses, all windings open.
    pub fn chain(spring: &Spring, far_end: FarEnd) -> Self {
        if let Some(sections) = spring.sections() {
            return Self::of_sections(spring, sections, far_end);
        }
        let modes = ChainModes::mounted(spring, far_end);
        let ChainModes { shapes, relative_end_mass, frequencies, norms, end_shapes, rigid, second, .. } = modes;
        Self {
            far_end,
            frequencies,
            participations: modes.participations,
            weights: [modes.input_weights, modes.output_weights],
            segment: 2.0 * shapes.masses as f64 * spring.stiffness(),
            end_shapes,
            line: [rigid, second],
            norms,
            mean_mass: spring.mass() / shapes.masses as f64,
            relative_end_mass,
            shapes: Shapes::Chain(shapes),
            offsets: Vec::new(),
        }
    }

    /// From modes that were found elsewhere, of a spring with the stiffness `stiffness` \[N/m\] as a whole.
    ///
    /// n_j = Σ_i m_i φ_j(i)² + M ψ_j²; c1_j = Σ_i m_i φ_j(i) (1 − s_i)/n_j, c2_j = Σ_i m_i φ_j(i) s_i/n_j where both positions are prescribed;
    /// else c1_j = (Σ_i m_i φ_j(i) + M ψ_j)/n_j and c2_j = (Σ_i m_i φ_j(i) s_i + M ψ_j)/(k n_j); p1_j = k_1 φ_j(1), p2_j = k_(N+1) (ψ_j − φ_j(N))
    ///
    /// Source:   the equations of motion in modal coordinates relative to the massless line.
    /// Valid:    shapes that are orthogonal in the masses, M among them, as modes are.
    /// Accuracy: that of the modes; with those of the chain found numerically a motion is the closed form's within 1e-9 (test).
    ///
    /// # Errors
    /// [`Error::Count`] for lengths that do not go together; [`Error::Value`] for masses, stiffnesses and frequencies that are not above zero,
    /// places that do not rise from above 0 to below 1, and numbers that are not finite.
    pub fn new(stiffness: f64, parameters: ModalParameters) -> Result<Self, Error> {
        parameters.check()?;
        check_each("stiffness", "N/m", &[stiffness])?;
        Ok(Self::trusted(stiffness, parameters))
    }

    fn trusted(stiffness: f64, parameters: ModalParameters) -> Self {
        let ModalParameters { far_end, masses, places, end_segments, frequencies, shapes, end_shapes } = parameters;
        let (places_count, modes) = (masses.len(), frequencies.len());
        let end_mass = if let FarEnd::Mass(mass) = far_end { mass } else { 0.0 };
        let mean = masses.iter().sum::<f64>() / places_count as f64;
        let masses: Vec<f64> = masses.iter().map(|mass| mass / mean).collect();
        let mut model = Self {
            far_end,
            frequencies,
            participations: [Vec::with_capacity(modes), Vec::with_capacity(modes)],
            weights: [Vec::with_capacity(modes), Vec::with_capacity(modes)],
            segment: end_segments[0],
            end_shapes,
            line: [Vec::with_capacity(modes), Vec::with_capacity(modes)],
            norms: Vec::with_capacity(modes),
            mean_mass: mean,
            relative_end_mass: end_mass / mean,
            shapes: Shapes::Table { masses: Vec::new(), places: Vec::new(), shapes: Vec::new() },
            offsets: Vec::new(),
        };
        for (shape, end) in shapes.chunks_exact(places_count).zip(model.end_shapes.clone()) {
            let sum = |value: &dyn Fn(usize) -> f64, of_end: f64| {
                let each = shape.iter().zip(&masses).enumerate();
                each.map(|(index, (shape, mass))| mass * shape * value(index)).sum::<f64>()
                    + model.relative_end_mass * end * of_end
            };
            let norm = sum(&|index| shape[index], end);
            let (rigid, second) = (sum(&|_| 1.0, 1.0) / norm, sum(&|index| places[index], 1.0) / norm);
            let (first, last) = match far_end {
                FarEnd::Position => (rigid - second, second),
                _ => (rigid, second / stiffness),
            };
            model.norms.push(norm);
            model.line[0].push(rigid);
            model.line[1].push(second);
            model.participations[0].push(first);
            model.participations[1].push(last);
            model.weights[0].push(shape[0]);
            model.weights[1].push(end_segments[1] / end_segments[0] * (end - shape[places_count - 1]));
        }
        model.shapes = Shapes::Table { masses, places, shapes };
        model
    }

    /// The first `count` of these modes.
    pub(crate) fn first(&self, count: usize) -> Self {
        let mut model = self.clone();
        model.leave_out_from(count);
        let Self { frequencies, participations, weights, end_shapes, line, norms, .. } = &mut model;
        let pairs = participations.iter_mut().chain(weights).chain(line);
        [frequencies, end_shapes, norms].into_iter().chain(pairs).for_each(|series| series.truncate(count));
        model
    }

    /// How many modes there are.
    pub fn count(&self) -> usize {
        self.frequencies.len()
    }

    /// N: how many masses there are.
    pub fn masses(&self) -> usize {
        match &self.shapes {
            Shapes::Chain(chain) => chain.masses,
            Shapes::Table { masses, .. } => masses.len(),
            Shapes::Wire { count, .. } => *count,
        }
    }

    /// What end 2 is tied to.
    pub fn far_end(&self) -> FarEnd {
        self.far_end
    }

    /// ω_j \[rad/s\], shape `count`, mode 1 first.
    pub fn frequencies(&self) -> &[f64] {
        &self.frequencies
    }

    /// ψ_j: how far end 2 moves in each mode, in units of its shape; zero where its position is prescribed. Shape `count`.
    pub fn end_shapes(&self) -> &[f64] {
        &self.end_shapes
    }

    /// s_i of mass `mass` (1…N): which share of the ends' distance it keeps from end 1 while the spring moves slowly \[1\].
    ///
    /// # Errors
    /// [`Error::Value`] where the mass is not there.
    pub fn place(&self, mass: usize) -> Result<f64, Error> {
        self.check_number("mass", mass, self.masses())?;
        Ok(self.place_at(mass))
    }

    /// φ_j(i), shape of mode `mode` (1…count) at mass `mass` (1…N) \[1\].
    ///
    /// # Errors
    /// [`Error::Value`] where the mode or the mass is not there.
    pub fn shape(&self, mode: usize, mass: usize) -> Result<f64, Error> {
        self.check_number("mode", mode, self.count())?;
        self.check_number("mass", mass, self.masses())?;
        Ok(self.shape_at(mode, mass))
    }

    fn check_number(&self, quantity: &'static str, number: usize, last: usize) -> Result<(), Error> {
        check((1..=last).contains(&number), quantity, number as f64, "", format!("from 1 to {last}")).map(|_| ())
    }

    /// Whether they are all those of a chain of equal masses on equal segments.
    pub(crate) fn is_chain(&self) -> bool {
        matches!(self.shapes, Shapes::Chain(_)) && self.count() >= self.masses()
    }

    /// As [`Self::shape`], numbers trusted.
    pub(crate) fn shape_at(&self, mode: usize, mass: usize) -> f64 {
        match &self.shapes {
            Shapes::Chain(chain) => chain.at(mode, mass),
            Shapes::Table { masses, shapes, .. } => shapes[(mode - 1) * masses.len() + mass - 1],
            Shapes::Wire { count, shapes, .. } => shapes[(mode - 1) * count + mass - 1],
        }
    }

    /// As [`Self::place`], the number trusted.
    pub(crate) fn place_at(&self, mass: usize) -> f64 {
        match &self.shapes {
            Shapes::Chain(_) | Shapes::Wire { .. } => (mass as f64 - 0.5) / self.masses() as f64,
            Shapes::Table { places, .. } => places[mass - 1],
        }
    }

    /// How much further mass `mass`, the number trusted, is from end 1 of the unloaded spring than its share of the length \[m\].
    pub(crate) fn offset_at(&self, mass: usize) -> f64 {
        self.offsets.get(mass - 1).copied().unwrap_or(0.0)
    }

    /// Whether the unloaded coil is evenly wound.
    pub(crate) fn is_evenly_wound(&self) -> bool {
        self.offsets.is_empty()
    }

    /// m_i over the mean \[1\], the number trusted.
    fn share_of_mass(&self, mass: usize) -> f64 {
        match &self.shapes {
            Shapes::Chain(_) | Shapes::Wire { .. } => 1.0,
            Shapes::Table { masses, .. } => masses[mass - 1],
        }
    }

    /// m_i \[kg\], the number trusted.
    pub(crate) fn mass(&self, mass: usize) -> f64 {
        self.mean_mass * self.share_of_mass(mass)
    }

    /// What a mode's spring would be \[N/m\]: its elastic energy is half of this times q_j².
    pub(crate) fn modal_stiffness(&self, mode: usize) -> f64 {
        self.mean_mass * self.norms[mode - 1] * self.frequencies[mode - 1].powi(2)
    }

    /// Whether all masses and segments are alike, so that what is known of an even coil holds.
    pub(crate) fn is_even(&self) -> bool {
        matches!(self.shapes, Shapes::Chain(_) | Shapes::Wire { .. })
    }

    /// Whether modes 1, 3, 5 … look the same from both ends and the others are mirrored.
    pub(crate) fn is_mirrored(&self) -> bool {
        matches!(self.shapes, Shapes::Chain(_)) && self.far_end == FarEnd::Position
    }

    /// How far masses `apart` masses from each other move towards each other in a mode, at most, per unit of q_j; `transit_time` τ \[s\].
    pub(crate) fn most_between(&self, mode: usize, apart: usize, transit_time: f64) -> f64 {
        match &self.shapes {
            Shapes::Chain(chain) => {
                let share = apart as f64 / chain.masses as f64;
                (self.frequencies[mode - 1] * transit_time * share).min(2.0)
            }
            Shapes::Table { .. } | Shapes::Wire { .. } => {
                let each = (1..=self.masses().saturating_sub(apart))
                    .map(|mass| (self.shape_at(mode, mass + apart) - self.shape_at(mode, mass)).abs());
                each.fold(0.0, f64::max)
            }
        }
    }

    /// The smallest share of the ends' distance between masses `apart` masses from each other.
    pub(crate) fn least_between(&self, apart: usize) -> f64 {
        match &self.shapes {
            Shapes::Chain(_) | Shapes::Wire { .. } => apart as f64 / self.masses() as f64,
            Shapes::Table { places, .. } => {
                let each = places.iter().zip(places.iter().skip(apart)).map(|(before, after)| after - before);
                each.fold(f64::INFINITY, f64::min)
            }
        }
    }

    /// Weights of each mode in F_i and F_o, in units of [`Self::segment`]; shape `count` each.
    pub(crate) fn weights(&self) -> [&[f64]; 2] {
        [&self.weights[0], &self.weights[1]]
    }

    /// A stiffness \[N/m\]: `F = F_static + segment Σ_j weight_j q_j`.
    pub(crate) fn segment(&self) -> f64 {
        self.segment
    }

    /// c1_j \[1\] and c2_j (\[1\], or \[m/N\] for a force at end 2): how strongly each input drives each mode; shape `count` each.
    pub(crate) fn participations(&self) -> [&[f64]; 2] {
        [&self.participations[0], &self.participations[1]]
    }

    /// Modal coordinates of the straight line with the values `line` at ends 1 and 2; shape `count`.
    pub(crate) fn project_line(&self, line: [f64; 2]) -> Vec<f64> {
        let each = self.line[0].iter().zip(&self.line[1]);
        each.map(|(rigid, second)| line[0] * rigid + (line[1] - line[0]) * second).collect()
    }

    /// Modal coordinates of a pattern of the masses and of end 2: (Σ_i m_i φ_j(i) v_i + M ψ_j v_end)/n_j; shape `N` to shape `count`.
    pub(crate) fn project(&self, pattern: &[f64], end: f64) -> Vec<f64> {
        let each = self.norms.iter().zip(&self.end_shapes).enumerate();
        let of_mode = |(index, (norm, end_shape)): (usize, (&f64, &f64))| {
            let of_mass = |(mass, value): (usize, &f64)| {
                self.shape_at(index + 1, mass + 1) * (self.share_of_mass(mass + 1) * value)
            };
            let sum: f64 = pattern.iter().enumerate().map(of_mass).sum();
            (sum + self.relative_end_mass * end_shape * end) / norm
        };
        each.map(of_mode).collect()
    }
}
