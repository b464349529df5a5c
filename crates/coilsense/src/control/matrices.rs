//! A plant as matrices: drive, modes of the spring with both ends held, and what end 2 meets.
//!
//! Next door: the same over frequency without matrices (`plant`), its poles (`poles`).

use nalgebra::{DMatrix, DVector};

use super::drive::Drive;
use super::environment::Environment;
use super::plant::Plant;
use crate::modes::ChainModes;

/// Outputs of a plant, in this order.
pub(super) const OUTPUTS: usize = 5;
/// Where the stroke y = −u1 stands among them; before it F_i, F_o, F_x, F_L.
pub(super) const STROKE: usize = 4;

/// `ẋ = A x + B c, [F_i, F_o, F_x, F_L, y] = C x + D c`, all states in metres.
///
/// Modes by their motion relative to the mean, z_j = q_j + c1_j u1 + c2_j u2, so that no acceleration of an end is asked for:
/// z̈_j = −2ζ_jω_j q̇_j − ω_j² q_j. The ends by Newton: M ÿ + b ẏ = f − F_i; M_L ü2 + b_L u̇2 + k_L u2 = −F_o; an end without mass or
/// damping stands where its forces balance.
///
/// Source:   the equations of [`Plant::at`], of first order in time; F = k(u2 − u1) + Σ p_j (q_j + β q̇_j).
/// Valid:    as [`Plant`]: small motions, windings that never touch.
/// Accuracy: as [`super::poles::Poles`], which is found from it.
#[derive(Debug, Clone)]
pub(super) struct Matrices {
    /// A, shape `states × states`.
    pub a: DMatrix<f64>,
    /// B, shape `states`.
    pub b: DVector<f64>,
    /// C, shape `states` each.
    pub c: [DVector<f64>; OUTPUTS],
    /// D: zero but for F_i and F_o beside dashpots, where an ideal velocity source makes their speed jump.
    pub d: [f64; OUTPUTS],
    /// q_j, shape `states + 1` each: of the states, and of the command.
    pub modes: Vec<DVector<f64>>,
}

/// A quantity as a sum of states and the command: `states + 1` factors.
type Form = DVector<f64>;

/// What pulls: forms of q_j and of q̇_j, each less what u̇2 does to it.
struct Spring<'a> {
    plant: &'a Plant,
    frequencies: &'a [f64],
    ratios: &'a [f64],
    participations: [Vec<f64>; 2],
    /// p_j of F_i and F_o \[N/m\].
    pulls: [Vec<f64>; 2],
    /// β \[s\].
    dashpot: f64,
}

/// Where each state stands.
struct Layout {
    modes: usize,
    size: usize,
    /// f or ẏ behind a lag.
    lag: Option<usize>,
    /// ẏ of a mass.
    speed: Option<usize>,
    /// u2 and u̇2.
    end: [Option<usize>; 2],
}

impl Layout {
    fn of(spring: &Spring<'_>) -> Self {
        let modes = spring.frequencies.len();
        let mut size = 2 * modes + 1;
        let mut next = |wanted: bool| {
            size += usize::from(wanted);
            wanted.then_some(size - 1)
        };
        let (Drive::Velocity { bandwidth } | Drive::Force { bandwidth, .. }) = spring.plant.drive();
        let lag = next(bandwidth.is_some());
        let speed = next(matches!(spring.plant.drive(), Drive::Force { .. }));
        let end = match *spring.plant.environment() {
            Environment::Held => [None, None],
            Environment::Impedance { mass, .. } if mass > 0.0 => [next(true), next(true)],
            Environment::Impedance { damping, .. } => [next(damping + spring.dashpot > 0.0), None],
        };
        Self { modes, size, lag, speed, end }
    }

    fn unit(&self, place: usize) -> Form {
        let mut form = Form::zeros(self.size + 1);
        form[place] = 1.0;
        form
    }

    fn zero(&self) -> Form {
        Form::zeros(self.size + 1)
    }

    /// Where y stands.
    fn stroke(&self) -> usize {
        2 * self.modes
    }
}

impl Matrices {
    /// Of a plant.
    pub fn of(plant: &Plant) -> Self {
        let spring = Spring::of(plant);
        let layout = Layout::of(&spring);
        let base = spring.frequencies[0];
        let mut rows = vec![layout.zero(); layout.size];
        let stroke = layout.unit(layout.stroke());
        let command = layout.unit(layout.size);
        // What the drive does: ẏ, and its own state's rate.
        let (Drive::Velocity { bandwidth } | Drive::Force { bandwidth, .. }) = plant.drive();
        let is_force = layout.speed.is_some();
        let scale = if is_force { plant.spring().stiffness() } else { base };
        let driven = match (bandwidth, layout.lag) {
            (Some(bandwidth), Some(lag)) => {
                let fast = std::f64::consts::TAU * bandwidth;
                rows[lag] = (&command / scale - layout.unit(lag)) * fast;
                layout.unit(lag) * scale
            }
            _ => command,
        };
        let speed = layout.speed.map_or_else(|| driven.clone(), |place| layout.unit(place) * base);
        rows[layout.stroke()].copy_from(&speed);
        let [end, end_speed] = spring.end(&layout, &stroke, &speed);
        let (positions, rates) = spring.modes(&layout, [&stroke, &speed], [&end, &end_speed]);
        for (mode, (q, rate)) in positions.iter().zip(&rates).enumerate() {
            let natural = spring.frequencies[mode];
            rows[2 * mode] = layout.unit(2 * mode + 1) * natural;
            rows[2 * mode + 1] = rate * (-2.0 * spring.ratios[mode]) - q * natural;
        }
        let straight = (&stroke + &end) * plant.spring().stiffness();
        let [input, output] = [0, 1].map(|side| spring.force(side, &straight, &positions, &rates));
        if let (Some(place), Drive::Force { mass, friction, .. }) = (layout.speed, plant.drive()) {
            rows[place] = (driven - &speed * *friction - &input) / (mass * base);
        }
        if let Some(place) = layout.end[0] {
            rows[place].copy_from(&end_speed);
        }
        if let (Some(place), Environment::Impedance { mass, damping, stiffness }) = (layout.end[1], plant.environment())
        {
            rows[place] = -(&output + &end_speed * *damping + &end * *stiffness) / (mass * base);
        }
        let coil = positions.iter().zip(plant.coil_weights()).map(|(q, weight)| q * *weight);
        let inductance = coil.fold(straight.clone(), |sum, form| sum + form);
        let outputs = [input, output, straight, inductance, stroke];
        let size = layout.size;
        Self {
            a: DMatrix::from_fn(size, size, |row, column| rows[row][column]),
            b: DVector::from_fn(size, |row, _| rows[row][size]),
            d: std::array::from_fn(|output| outputs[output][size]),
            c: outputs.map(|form| form.rows(0, size).into_owned()),
            modes: positions,
        }
    }
}

impl<'a> Spring<'a> {
    fn of(plant: &'a Plant) -> Self {
        let modes = ChainModes::of(plant.spring());
        let by_segment = 2.0 * modes.masses() as f64 * plant.spring().stiffness();
        let scaled = |weights: &[f64]| weights.iter().map(|weight| by_segment * weight).collect();
        let [frequencies, ratios] = plant.held_modes();
        Self {
            plant,
            frequencies,
            ratios,
            participations: modes.participations().map(<[f64]>::to_vec),
            pulls: [scaled(modes.input_weights()), scaled(modes.output_weights())],
            dashpot: plant.damping().dashpot_time(),
        }
    }

    /// Forms of u2 and u̇2.
    fn end(&self, layout: &Layout, stroke: &Form, speed: &Form) -> [Form; 2] {
        let base = self.frequencies[0];
        let [place, moving] = layout.end;
        let Environment::Impedance { damping, stiffness, .. } = *self.plant.environment() else {
            return [layout.zero(), layout.zero()];
        };
        if let (Some(place), Some(moving)) = (place, moving) {
            return [layout.unit(place), layout.unit(moving) * base];
        }
        let k = self.plant.spring().stiffness();
        // How F_o answers u2 and, beside dashpots, u̇2: what the last segment adds to k.
        let segment: f64 = -self.pulls[1].iter().zip(&self.participations[1]).map(|(pull, c)| pull * c).sum::<f64>();
        let resting = layout.zero();
        if let Some(place) = place {
            // No mass: the damper takes what is left.
            let end = layout.unit(place);
            let (positions, rates) = self.modes(layout, [stroke, speed], [&end, &resting]);
            let force = self.force(1, &((stroke + &end) * k), &positions, &rates);
            let end_speed = -(force + &end * stiffness) / (damping + self.dashpot * segment);
            return [end, end_speed];
        }
        // Neither mass nor damper: u2 where F_o + k_L u2 = 0, and its rate that of the states it follows.
        let (positions, rates) = self.modes(layout, [stroke, speed], [&resting, &resting]);
        let give = -1.0 / (k + segment + stiffness);
        [(stroke, &positions), (speed, &rates)].map(|(along, each)| self.force(1, &(along * k), each, &[]) * give)
    }

    /// Forms of q_j = z_j + c1_j y − c2_j u2 and of q̇_j.
    fn modes(
        &self,
        layout: &Layout,
        [stroke, speed]: [&Form; 2],
        [end, end_speed]: [&Form; 2],
    ) -> (Vec<Form>, Vec<Form>) {
        let [first, second] = &self.participations;
        let one = |mode: usize| {
            let carried = |near: &Form, far: &Form| near * first[mode] - far * second[mode];
            let q = layout.unit(2 * mode) + carried(stroke, end);
            let rate = layout.unit(2 * mode + 1) * self.frequencies[mode] + carried(speed, end_speed);
            (q, rate)
        };
        (0..layout.modes).map(one).unzip()
    }

    /// The form of an end's force: k (u2 − u1) + Σ p_j (q_j + β q̇_j); of rates none where there are no dashpots to be felt.
    fn force(&self, side: usize, straight: &Form, positions: &[Form], rates: &[Form]) -> Form {
        let mut force = straight.clone();
        for (q, pull) in positions.iter().zip(&self.pulls[side]) {
            force.axpy(*pull, q, 1.0);
        }
        for (rate, pull) in rates.iter().zip(&self.pulls[side]) {
            force.axpy(self.dashpot * pull, rate, 1.0);
        }
        force
    }
}
