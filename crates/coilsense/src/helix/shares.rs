//! What a motion of the wire is: along the axis, about it, sideways, or within the windings.
//!
//! Next door: the motion (`mode`).

use super::block::reduce;

/// What most of a mode's motion is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Kind {
    /// Windings move along the axis: surge.
    Axial,
    /// Windings turn about the axis.
    Torsional,
    /// Windings move sideways and tilt.
    Lateral,
    /// No one of these has three fifths of the energy.
    Mixed,
}

/// Share of the energy from which a mode is of one kind.
const ONE_KIND: f64 = 0.6;

/// How a mode's kinetic energy is divided; the four add up to one \[1\].
///
/// Each winding, as a rigid body: its motion along the axis, about the axis, sideways with its tilt; and what is left is deformation of
/// the winding itself.
///
/// Source:   least squares, winding by winding, over points evenly spaced along the wire.
/// Valid:    the energy of displacement; that of the wire's own rotation is (d/4R)² of it.
/// Accuracy: a definition; the last, part of a winding counts with the windings beside it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Shares {
    /// Along the axis.
    pub axial: f64,
    /// About the axis.
    pub torsional: f64,
    /// Sideways, and tilting.
    pub lateral: f64,
    /// Within the windings.
    pub within: f64,
}

impl Shares {
    /// Of points of the wire and how they move.
    pub(super) fn of(wire: &[[f64; 3]], moved: &[[f64; 3]], windings: f64) -> Self {
        let last = wire.len() - 1;
        let bodies = (windings.round() as usize).clamp(1, last);
        let mut sums = [0.0; 4];
        for body in 0..bodies {
            let from = body * last / bodies;
            let to = ((body + 1) * last / bodies).min(last);
            let one = winding(&wire[from..=to], &moved[from..=to]);
            (0..4).for_each(|i| sums[i] += one[i]);
        }
        let all: f64 = sums.iter().sum();
        let [axial, torsional, lateral, within] = sums.map(|value| value / all.max(f64::MIN_POSITIVE));
        Self { axial, torsional, lateral, within }
    }

    /// What most of it is.
    pub(super) fn kind(&self) -> Kind {
        let whole = self.axial + self.torsional + self.lateral;
        let most = |share: f64| share > ONE_KIND * whole;
        match () {
            () if most(self.axial) => Kind::Axial,
            () if most(self.torsional) => Kind::Torsional,
            () if most(self.lateral) => Kind::Lateral,
            () => Kind::Mixed,
        }
    }
}

/// Energies of one winding as a rigid body, axial, torsional, lateral, and the rest.
fn winding(wire: &[[f64; 3]], moved: &[[f64; 3]]) -> [f64; 4] {
    let last = wire.len() - 1;
    let height = wire.iter().map(|point| point[2]).sum::<f64>() / wire.len() as f64;
    let radius = wire[0][0].hypot(wire[0][1]);
    // Displacement per freedom: along x, y, z, then about them, the rotations in radii.
    let per_freedom = |point: &[f64; 3]| {
        let [x, y, z] = [point[0] / radius, point[1] / radius, (point[2] - height) / radius];
        [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]]
    };
    let weight = |at: usize| if at == 0 || at == last { 0.5 } else { 1.0 };
    let (mut system, mut total) = ([[0.0; 7]; 6], 0.0);
    for (at, (point, w)) in wire.iter().zip(moved).enumerate() {
        let rows = per_freedom(point);
        let dot = |one: &[f64; 3], other: &[f64; 3]| weight(at) * (0..3).map(|k| one[k] * other[k]).sum::<f64>();
        total += dot(w, w);
        for i in 0..6 {
            (0..6).for_each(|j| system[i][j] += dot(&rows[i], &rows[j]));
            system[i][6] += dot(&rows[i], w);
        }
    }
    let normal = system;
    reduce(&mut system);
    let fitted = system.map(|row| row[6]);
    let energy = |freedoms: &[usize]| -> f64 {
        let row = |i: &usize| freedoms.iter().map(|j| normal[*i][*j] * fitted[*j]).sum::<f64>();
        freedoms.iter().map(|i| fitted[*i] * row(i)).sum()
    };
    let explained: f64 = (0..6).map(|i| fitted[i] * normal[i][6]).sum();
    [energy(&[2]), energy(&[5]), energy(&[0, 1, 3, 4]), (total - explained).max(0.0)]
}
