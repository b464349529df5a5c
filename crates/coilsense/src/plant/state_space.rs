//! A plant as matrices, continuous and for a step.
//!
//! Next door: the plant (the parent), its steps without matrices (`coilsense_rt::Plant`).

use coilsense_rt::ModeStep;

use super::{ModalCoil, ModalPlant};
use crate::error::{Error, above_zero};
use crate::mount::FarEnd;

/// `ẋ = A x + B u, y = C x + D u + D_v u̇`, about the mean.
///
/// Inputs: u1, and u2 or the force at end 2. Outputs: F_i, F_o, F_x, u2, and where a coil is given F_L in a straight line about its mean. States, two a mode: z = q + c·u, the motion relative to the mean
/// instead of the line between the ends, and (ż − 2ζω c·u)/ω; so no input's acceleration is asked for.
///
/// A_j = ω [[0, 1], [−1, −2ζ]], B_j = ω [2ζ, 1 − 4ζ²] c
///
/// Source:   the plant's equation, with q = z − c·u.
/// Valid:    as [`ModalPlant`]. D_v, of dashpots at the ends only, is zero for all other damping.
/// Accuracy: poles and responses 1e-11 of the largest beside the modal sums (test).
#[derive(Debug, Clone, PartialEq)]
pub struct StateSpace {
    /// A, shape `states × states`.
    pub a: Vec<Vec<f64>>,
    /// B, shape `states × 2`.
    pub b: Vec<[f64; 2]>,
    /// C, shape `outputs × states`.
    pub c: Vec<Vec<f64>>,
    /// D, shape `outputs × 2`.
    pub d: Vec<[f64; 2]>,
    /// D_v \[per m/s or N/s\], likewise.
    pub d_rate: Vec<[f64; 2]>,
}

/// `x⁺ = A x + B u, y = C x + D u`, exact at the samples for inputs that move straight between them.
///
/// x is what `z(t)` and the input of that sample make, `z − Γ u`, as first-order hold has it; where dashpots pull at the ends two states more
/// hold the inputs of the sample before.
///
/// Source:   `[Franklin1998]` section 6.3, triangle hold.
/// Valid:    as [`StateSpace`].
/// Accuracy: 1e-10 of the peak beside steps of [`coilsense_rt::Plant`] over 10⁴ steps (test).
#[derive(Debug, Clone, PartialEq)]
pub struct Sampled {
    /// h \[s\].
    pub step: f64,
    /// A, shape `states × states`.
    pub a: Vec<Vec<f64>>,
    /// B, shape `states × 2`.
    pub b: Vec<[f64; 2]>,
    /// C, shape `outputs × states`.
    pub c: Vec<Vec<f64>>,
    /// D, shape `outputs × 2`.
    pub d: Vec<[f64; 2]>,
}

/// A mode's two rows of everything.
struct Block {
    /// Of each output per q.
    pulls: Vec<f64>,
    participations: [f64; 2],
    natural: f64,
    ratio: f64,
}

impl ModalPlant {
    /// The plant as matrices, with F_L by `coil` as a fifth output where that is given.
    pub fn state_space(&self, coil: Option<&ModalCoil>) -> StateSpace {
        let (states, dashpot) = (2 * self.count(), self.dashpot_time());
        let mut space = StateSpace {
            a: vec![vec![0.0; states]; states],
            b: Vec::with_capacity(states),
            c: Vec::new(),
            d: self.straight(coil),
            d_rate: Vec::new(),
        };
        space.c = vec![Vec::with_capacity(states); space.d.len()];
        space.d_rate = vec![[0.0; 2]; space.d.len()];
        for (index, block) in self.blocks(coil).enumerate() {
            let Block { pulls, participations, natural, ratio } = block;
            let (upper, lower) = (2 * index, 2 * index + 1);
            space.a[upper][lower] = natural;
            space.a[lower][upper] = -natural;
            space.a[lower][lower] = -2.0 * ratio * natural;
            space.b.push(participations.map(|c| 2.0 * ratio * natural * c));
            space.b.push(participations.map(|c| natural * (1.0 - 4.0 * ratio * ratio) * c));
            for (output, pull) in pulls.into_iter().enumerate() {
                let felt = if output < 2 { pull * dashpot } else { 0.0 };
                space.c[output].extend([pull, felt * natural]);
                for (input, c) in participations.into_iter().enumerate() {
                    space.d[output][input] += (2.0 * ratio * natural * felt - pull) * c;
                    space.d_rate[output][input] -= felt * c;
                }
            }
        }
        space
    }

    /// The plant as matrices for a step h \[s\].
    ///
    /// # Errors
    /// [`Error::Value`] for a step that is not above zero, or too long for where in its turn the fastest mode is (ωh above 1e9).
    pub fn sampled(&self, step: f64, coil: Option<&ModalCoil>) -> Result<Sampled, Error> {
        above_zero("step", step, "s")?;
        let continuous = self.state_space(coil);
        let states = 2 * self.count();
        let (mut a, mut b) = (vec![vec![0.0; states]; states], Vec::with_capacity(states));
        let mut holds = Vec::with_capacity(states);
        for (index, block) in self.blocks(None).enumerate() {
            let Block { participations, natural, ratio, .. } = block;
            let angle = natural * step;
            crate::error::check(angle <= 1e9, "step", step, "s", format!("at most {} s", 1e9 / natural))?;
            let (turned, at) = (ModeStep::new(angle, ratio).matrix(), 2 * index);
            for (row, values) in turned.iter().enumerate() {
                a[at + row][at..at + 2].copy_from_slice(values);
            }
            // (q, q̇/ω) = (z − c u, z₂ + 2ζ c u − c Δu/ωh): what both samples' inputs put in, turned, and taken out again.
            let product = |x: f64, y: f64| turned.map(|row| row[0] * x + row[1] * y);
            let (before, now) = (product(-1.0, 2.0 * ratio + 1.0 / angle), product(0.0, -1.0 / angle));
            let before = [before[0], before[1] - 1.0 / angle];
            let now = [now[0] + 1.0, now[1] - 2.0 * ratio + 1.0 / angle];
            let through = product(now[0], now[1]);
            for row in 0..2 {
                b.push(participations.map(|c| (before[row] + through[row]) * c));
                holds.push(participations.map(|c| now[row] * c));
            }
        }
        let mut sampled = Sampled { step, a, b, c: continuous.c, d: continuous.d };
        for (row, out) in sampled.c.iter().zip(&mut sampled.d) {
            for (weight, hold) in row.iter().zip(&holds) {
                (out[0], out[1]) = (out[0] + weight * hold[0], out[1] + weight * hold[1]);
            }
        }
        if self.dashpot_time() > 0.0 {
            sampled.remember(&continuous.d_rate);
        }
        Ok(sampled)
    }

    /// What each output has of each input without any mode.
    fn straight(&self, coil: Option<&ModalCoil>) -> Vec<[f64; 2]> {
        let [input, output, deflection] = self.of_line();
        let end = match self.mount().far_end() {
            FarEnd::Position => [0.0, 1.0],
            _ => [1.0, 1.0 / self.spring().stiffness()],
        };
        [input, output, deflection, end].into_iter().chain(coil.map(|coil| coil.straight(self))).collect()
    }

    fn blocks<'a>(&'a self, coil: Option<&'a ModalCoil>) -> impl Iterator<Item = Block> + 'a {
        self.modes().iter().zip(self.ratios()).enumerate().map(move |(index, (mode, ratio))| {
            let [input, output, deflection] = self.pulls(mode);
            let by_coil = coil.map(|coil| coil.pull(index, mode.end));
            Block {
                pulls: [input, output, deflection, mode.end].into_iter().chain(by_coil).collect(),
                participations: mode.participations,
                natural: mode.frequency,
                ratio,
            }
        })
    }
}

impl Sampled {
    /// Adds the inputs of the sample before as states, and what outputs have of the inputs' rates.
    fn remember(&mut self, d_rate: &[[f64; 2]]) {
        let states = self.a.len();
        self.a.iter_mut().for_each(|row| row.extend([0.0; 2]));
        self.a.extend([vec![0.0; states + 2], vec![0.0; states + 2]]);
        self.b.extend([[1.0, 0.0], [0.0, 1.0]]);
        for ((row, out), rates) in self.c.iter_mut().zip(&mut self.d).zip(d_rate) {
            row.extend(rates.map(|rate| -rate / self.step));
            for (out, rate) in out.iter_mut().zip(rates) {
                *out += rate / self.step;
            }
        }
    }
}
