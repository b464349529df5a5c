//! The modes of a continuous wire, which never end: those that are here, and what the others follow slow motion with.
//!
//! Next door: who finds them (`crate::helix::Surge`), what a motion takes of them (the parent).

use super::{ModalModel, Shapes};
use crate::mount::FarEnd;

/// How the force along the axis at the ends of a wire follows slow motion: to `K u` of a wire without mass come `M ü − S u⁗ + …`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct SlowInertia {
    /// M, Σ_j c_j c_jᵀ over all modes \[kg\]: of the wire that follows its ends as if it had no mass.
    pub mass: [[f64; 2]; 2],
    /// S, Σ_j c_j c_jᵀ/ω_j² over all modes \[kg s²\].
    pub second: [[f64; 2]; 2],
}

/// Modes of a continuous wire, for a modal mass of 1 kg.
pub(crate) struct WireModes {
    /// ω_j \[rad/s\], ascending.
    pub frequencies: Vec<f64>,
    /// Axial force of the mode on what holds each end \[N/(m √kg)\].
    pub reactions: [Vec<f64>; 2],
    /// Mean axial displacement of each of N equal shares of the wire \[1/√kg\], mode by mode.
    pub shapes: Vec<f64>,
    /// N.
    pub count: usize,
    /// Of the whole wire \[kg\].
    pub mass: f64,
    /// Of all modes, those that are not here included.
    pub inertia: SlowInertia,
}

/// Force at each end per derivative of each input that modes which are not here add, `[end][input]`, tension positive.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct LeftOut {
    /// Per acceleration \[kg\].
    pub per_acceleration: [[f64; 2]; 2],
    /// Per fourth derivative of the position \[kg s²\].
    pub per_snap: [[f64; 2]; 2],
}

impl ModalModel {
    /// Of a continuous wire between two prescribed positions.
    ///
    /// c_ij = r_ij/ω_j², p1_j = r_1j, p2_j = −r_2j
    ///
    /// Source:   reciprocity: what a mode's inertia does along the displacements that a slow motion of end i gives is what it pulls with at
    ///           end i.
    pub(crate) fn wire(modes: WireModes) -> Self {
        let WireModes { frequencies, reactions, shapes, count, mass, inertia } = modes;
        let per = |reactions: &Vec<f64>| -> Vec<f64> {
            reactions.iter().zip(&frequencies).map(|(reaction, frequency)| reaction / (frequency * frequency)).collect()
        };
        let participations = reactions.each_ref().map(per);
        let [first, second] = &participations;
        let rigid = first.iter().zip(second).map(|(first, second)| first + second).collect();
        let mean_mass = mass / count as f64;
        let [input, output] = reactions;
        Self {
            far_end: FarEnd::Position,
            norms: vec![1.0 / mean_mass; frequencies.len()],
            end_shapes: vec![0.0; frequencies.len()],
            line: [rigid, second.clone()],
            frequencies,
            participations,
            weights: [input, output.into_iter().map(|reaction| -reaction).collect()],
            segment: 1.0,
            mean_mass,
            relative_end_mass: 0.0,
            shapes: Shapes::Wire { count, shapes, inertia, tied: None },
            offsets: Vec::new(),
        }
    }

    /// What modes of a wire that are not here add to the forces; `None` of a chain, which has all.
    ///
    /// F_i −= R_1 ü − T_1 u⁗, F_o += R_2 ü − T_2 u⁗; R = M − Σ_j c_j c_jᵀ, T = S − Σ_j c_j c_jᵀ/ω_j²
    ///
    /// Source:   a mode far above its drive follows as `q = −c (ü/ω² − u⁗/ω⁴ + …)`.
    pub(crate) fn left_out(&self) -> Option<LeftOut> {
        if let Some(tied) = self.tie() {
            return Some(tied.left_out());
        }
        let [mass, second] = self.inertia_left_out()?;
        let signed =
            |[one, two]: [[f64; 2]; 2], sign: f64| [one.map(|value| -sign * value), two.map(|value| sign * value)];
        Some(LeftOut { per_acceleration: signed(mass, 1.0), per_snap: signed(second, -1.0) })
    }

    /// R and T of [`Self::left_out`].
    fn inertia_left_out(&self) -> Option<[[[f64; 2]; 2]; 2]> {
        let Shapes::Wire { inertia: SlowInertia { mass, second }, tied: None, .. } = &self.shapes else { return None };
        let less = |all: &[[f64; 2]; 2], of_mode: &dyn Fn(f64) -> f64| -> [[f64; 2]; 2] {
            let kept = |i: usize, j: usize| -> f64 {
                let pairs = self.participations[i].iter().zip(&self.participations[j]);
                pairs.zip(&self.frequencies).map(|((one, other), frequency)| one * other * of_mode(*frequency)).sum()
            };
            std::array::from_fn(|i| std::array::from_fn(|j| all[i][j] - kept(i, j)))
        };
        Some([less(mass, &|_| 1.0), less(second, &|frequency| frequency.powi(-2))])
    }

    /// The same wire with moduli and mass multiplied, its shape kept: forces times `stiffness`, all frequencies times `frequency`.
    ///
    /// Modes for a modal mass of 1 kg scale with √m, m being multiplied by stiffness/frequency².
    pub(crate) fn of_changed_wire(&self, stiffness: f64, frequency: f64) -> Option<Self> {
        let Shapes::Wire { count, shapes, inertia, tied: None } = &self.shapes else { return None };
        let mass = stiffness / (frequency * frequency);
        let all = |values: &[f64], by: f64| -> Vec<f64> { values.iter().map(|value| by * value).collect() };
        let square = |matrix: &[[f64; 2]; 2], by: f64| matrix.map(|row| row.map(|value| by * value));
        let (participation, reaction) = (mass.sqrt(), stiffness / mass.sqrt());
        let mean_mass = mass * self.mean_mass;
        Some(Self {
            frequencies: all(&self.frequencies, frequency),
            participations: self.participations.each_ref().map(|each| all(each, participation)),
            weights: self.weights.each_ref().map(|each| all(each, reaction)),
            line: self.line.each_ref().map(|each| all(each, participation)),
            norms: vec![1.0 / mean_mass; self.frequencies.len()],
            mean_mass,
            shapes: Shapes::Wire {
                count: *count,
                shapes: all(shapes, 1.0 / mass.sqrt()),
                inertia: SlowInertia {
                    mass: square(&inertia.mass, mass),
                    second: square(&inertia.second, mass / (frequency * frequency)),
                },
                tied: None,
            },
            ..self.clone()
        })
    }

    /// Energy \[J\] of a wire but for what a wire without mass would store; `None` of a chain, whose masses tell.
    ///
    /// ½ Σ_j ((q̇_j + c_j·u̇)² + ω_j² q_j²) + ½ u̇ᵀ R u̇ − u̇ᵀ T u⃛ + ½ üᵀ T ü: all motions of the wire, modes that are not here included, and what
    /// the forces at both ends do work on, to rounding
    ///
    /// - `line`: u̇ \[m/s\], ü \[m/s²\], u⃛ \[m/s³\] of both ends
    pub(crate) fn wire_energy(
        &self,
        [velocity, acceleration, jerk]: [[f64; 2]; 3],
        [q, rates]: [&[f64]; 2],
    ) -> Option<f64> {
        let [mass, second] = self.inertia_left_out()?;
        let product = |one: [f64; 2], matrix: [[f64; 2]; 2], other: [f64; 2]| -> f64 {
            (0..2).map(|i| one[i] * (matrix[i][0] * other[0] + matrix[i][1] * other[1])).sum()
        };
        let left_out = product(velocity, mass, velocity) - 2.0 * product(velocity, second, jerk)
            + product(acceleration, second, acceleration);
        let each = self.participations[0].iter().zip(&self.participations[1]).zip(&self.frequencies);
        let swings: f64 = each
            .zip(q.iter().zip(rates))
            .map(|(((first, last), frequency), (q, rate))| {
                (rate + first * velocity[0] + last * velocity[1]).powi(2) + (frequency * q).powi(2)
            })
            .sum();
        Some(0.5 * (left_out + swings))
    }
}
