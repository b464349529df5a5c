//! A wire whose end 2 carries a mass or is driven by a force: its modes between prescribed positions and the position of that end, together.
//!
//! Next door: the wire between prescribed positions (`wire`).

use nalgebra::{DMatrix, SymmetricEigen};

use super::wire::LeftOut;
use super::{ModalModel, Shapes};
use crate::mount::FarEnd;

/// What makes the modes of a tied wire from those between prescribed positions.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Tied {
    /// Of each mode: its parts in the modes between prescribed positions, then what end 2 moves; `count + 1` numbers a mode.
    pub(crate) parts: Vec<f64>,
    /// What is left of end 1's acceleration in that of end 2 when that of the modes is taken away \[1\].
    pub(crate) dragged: f64,
    /// What modes that are not here add to the forces under the inputs.
    left_out: LeftOut,
}

impl Tied {
    /// What modes that are not here add to the forces under the inputs.
    pub(super) fn left_out(&self) -> LeftOut {
        self.left_out
    }
}

impl ModalModel {
    /// This wire with its end 2 tied to something; itself where that is a position.
    ///
    /// With `y = u1 + ψ_2 (f/k + v) + Σ_j φ_j q_j`, v what end 2 is off the place where a wire without mass would have it:
    ///
    /// ```text
    /// ⎡ I      c_2     ⎤ ⎡q̈⎤   ⎡ω²  0⎤ ⎡q⎤     ⎡ c_1 + c_2        ⎤      ⎡ c_2      ⎤ f̈
    /// ⎣ c_2ᵀ  M + M_22 ⎦ ⎣v̈⎦ + ⎣0   k⎦ ⎣v⎦ = − ⎣ M + M_22 + M_21  ⎦ ü1 − ⎣ M + M_22 ⎦ ―
    ///                                                                                  k
    /// ```
    ///
    /// The forces are `F_i = F + f + k v + Σ r_1 q − R_11 ü1 − R_12 ü2` and `F_o = F + f − M ü2`; what is left out of F_i goes on with ü2 as the
    /// modes have it.
    ///
    /// - `stiffness`: k \[N/m\]
    ///
    /// Source:   `[Craig1968]`, component modes; the shape of the slow motion carries all of the wire's inertia.
    /// Valid:    below the highest mode that is there.
    /// Accuracy: a long flat wire with its chain to 1e-3 at masses of 0.3 to 30 m; the chain's limit of a heavy mass (`tests/helix`).
    pub(crate) fn tied(&self, far_end: FarEnd, stiffness: f64) -> Option<Self> {
        let mass = match far_end {
            FarEnd::Position => return Some(self.clone()),
            FarEnd::Force => 0.0,
            FarEnd::Mass(mass) => mass,
        };
        let Shapes::Wire { count, shapes, inertia, tied: None } = &self.shapes else { return None };
        let (count, kept) = (*count, self.count());
        let [first, second] = &self.participations;
        let [[_, _], [across, own]] = inertia.mass;
        let size = kept + 1;
        // Modes of 1/ω²: the lowest are its largest, and the most accurate.
        let root = |index: usize| if index < kept { self.frequencies[index] } else { stiffness.sqrt() };
        let flexibility = DMatrix::from_fn(size, size, |row, column| {
            let entry = match (row.min(column), row.max(column)) {
                (a, b) if b < kept => f64::from(u8::from(a == b)),
                (a, _) if a < kept => second[a],
                _ => mass + own,
            };
            entry / (root(row) * root(column))
        });
        let solved = SymmetricEigen::new(flexibility);
        let mut order: Vec<usize> = (0..size).collect();
        order.sort_by(|a, b| solved.eigenvalues[*b].total_cmp(&solved.eigenvalues[*a]));
        let [per_first, _] = self.left_out()?.per_acceleration;
        let (remaining, heavy) = (-per_first[1], mass + own - second.iter().map(|c| c * c).sum::<f64>());
        let crossing = across - first.iter().zip(second).map(|(one, other)| one * other).sum::<f64>();
        let mut model = Self {
            far_end,
            frequencies: Vec::with_capacity(size),
            participations: [Vec::with_capacity(size), Vec::with_capacity(size)],
            weights: [Vec::with_capacity(size), Vec::with_capacity(size)],
            segment: 1.0,
            end_shapes: Vec::with_capacity(size),
            line: [Vec::with_capacity(size), Vec::with_capacity(size)],
            norms: vec![1.0 / self.mean_mass; size],
            mean_mass: self.mean_mass,
            relative_end_mass: mass / self.mean_mass,
            shapes: Shapes::Wire { count, shapes: Vec::new(), inertia: *inertia, tied: None },
            offsets: Vec::new(),
        };
        let (mut own_shapes, mut parts) = (Vec::with_capacity(size * count), Vec::with_capacity(size * size));
        for index in order {
            let value = solved.eigenvalues[index].max(f64::MIN_POSITIVE);
            let part = |row: usize| solved.eigenvectors[(row, index)] / (root(row) * value.sqrt());
            let (q, moves, square) = ((0..kept).map(part).collect::<Vec<f64>>(), part(kept), 1.0 / value);
            let sum = |of: &dyn Fn(usize) -> f64| q.iter().enumerate().map(|(j, q)| q * of(j)).sum::<f64>();
            let rigid = sum(&|j| first[j] + second[j]) + moves * (mass + own + across);
            let straight = sum(&|j| second[j]) + moves * (mass + own);
            model.frequencies.push(square.sqrt());
            model.participations[0].push(rigid);
            model.participations[1].push(straight / stiffness);
            model.line[0].push(rigid);
            model.line[1].push(straight);
            let pull = stiffness * moves + sum(&|j| self.weights[0][j]) + remaining * square * moves;
            model.weights[0].push(pull);
            model.weights[1].push(mass * square * moves);
            model.end_shapes.push(moves);
            let shape =
                |place: usize| sum(&|j| shapes[j * count + place]) + moves * (place as f64 + 0.5) / count as f64;
            own_shapes.extend((0..count).map(shape));
            parts.extend(q.iter().copied().chain([moves]));
        }
        let dragged = -crossing / heavy;
        let left_out = LeftOut {
            per_acceleration: [[per_first[0] - remaining * dragged, 0.0], [-mass * dragged, 0.0]],
            per_snap: [[0.0; 2]; 2],
        };
        model.shapes = Shapes::Wire {
            count,
            shapes: own_shapes,
            inertia: *inertia,
            tied: Some(Tied { parts, dragged, left_out }),
        };
        Some(model)
    }

    /// Keeps what modes from this one on do at rest, where they are those of a tied wire.
    pub(super) fn leave_out_from(&mut self, count: usize) {
        let follows = |end: usize, input: usize| -> f64 {
            let each = self.weights[end].iter().zip(&self.participations[input]).zip(&self.frequencies).skip(count);
            each.map(|((weight, part), frequency)| weight * part / (frequency * frequency)).sum()
        };
        let all: [[f64; 2]; 2] = std::array::from_fn(|end| std::array::from_fn(|input| follows(end, input)));
        let Shapes::Wire { tied: Some(Tied { left_out, .. }), .. } = &mut self.shapes else { return };
        for (per, follows) in left_out.per_acceleration.iter_mut().flatten().zip(all.iter().flatten()) {
            *per -= follows;
        }
    }

    /// What a tied wire is made of.
    pub(crate) fn tie(&self) -> Option<&Tied> {
        match &self.shapes {
            Shapes::Wire { tied, .. } => tied.as_ref(),
            Shapes::Chain(_) | Shapes::Table { .. } => None,
        }
    }
}
