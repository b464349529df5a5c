//! One mode of the stretched helix: what moves, and what its ends feel.
//!
//! Next door: its frequency (`modes`), how much of the motion is axial, torsional, sideways (`shares`).

use std::f64::consts::TAU;

use num_complex::Complex;

use super::block::{Block, Square, reduce};
use super::chain::Chain;
use super::ends::Holding;
use super::modes::{Modes, beyond, finite, symmetric};
use super::reaction::Reaction;
use super::shares::{Kind, Shares};
use super::state::Helix;
use crate::error::{Error, check};
use crate::excitation::End;

/// Pieces per winding at the least: points per winding of the shape, too.
const POINTS_PER_WINDING: f64 = 16.0;

/// A mode of a helix between its ends.
///
/// ```
/// use coilsense::geometry::{EndType, Geometry, Material, MaterialParameters};
/// use coilsense::helix::{Ends, Hand, Helix, Kind, Modes, Rod, StiffnessAt, Turning};
///
/// // S_T of the paper at mid range: two sideways modes lie below the surge, and torsion 12 % above it.
/// let spring = coilsense::paper::s_t();
/// let steel = Material::new(MaterialParameters::elastic(81.5e9, 206e9, 7850.0))?;
/// let geometry = Geometry::of_spring(&spring, EndType::Hooks, steel)?;
/// let rod = Rod::of_spring(&spring, &geometry, StiffnessAt::Range, Hand::Right)?;
/// let modes = Modes::new(&Helix::new(&rod, 0.230, Turning::Held)?, Ends::clamped())?;
/// let kinds = (1..=4).map(|index| Ok(modes.mode(index)?.kind())).collect::<Result<Vec<_>, coilsense::Error>>()?;
/// assert_eq!(kinds, [Kind::Lateral, Kind::Lateral, Kind::Axial, Kind::Torsional]);
/// assert!((modes.mode(4)?.line_strength() - 0.011).abs() < 1e-3);
/// # Ok::<(), coilsense::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Mode {
    frequency: f64,
    shares: Shares,
    line_strength: f64,
    reactions: [Reaction; 2],
    wire: Vec<[f64; 3]>,
    shape: Vec<[f64; 3]>,
    largest: f64,
}

impl Mode {
    /// Its natural frequency \[Hz\].
    pub fn frequency(&self) -> f64 {
        self.frequency
    }

    /// What most of the motion is.
    pub fn kind(&self) -> Kind {
        self.shares.kind()
    }

    /// How the kinetic energy is divided.
    pub fn shares(&self) -> Shares {
        self.shares
    }

    /// How strong its line stands in the axial force at one end when the other moves along the axis \[1\].
    ///
    /// s = |r_1 r_2| / (2 k ω²)
    ///
    /// with r the axial force of the mode at either end for a modal mass of one, and k the slope of the force over length. A mode of a
    /// bar of the stiffness k has 1, whatever its number.
    ///
    /// Source:   residue of the force at one end over the motion of the other, over that of a uniform bar.
    /// Valid:    one line at a time; of a close pair, the sum counts.
    /// Accuracy: the residue of [`super::Response`] to 1e-4 (`tests/helix`).
    pub fn line_strength(&self) -> f64 {
        self.line_strength
    }

    /// Force and couples on what holds an end, for a modal mass of 1 kg \[N/(m √kg)\]; its ratios say what an axial force comes with.
    pub fn reaction(&self, end: End) -> Reaction {
        match end {
            End::One => self.reactions[0],
            End::Two => self.reactions[1],
        }
    }

    /// Where the wire's centre rests, from end 1 to end 2 \[m\]: x through its beginning, z along the axis.
    pub fn wire(&self) -> &[[f64; 3]] {
        &self.wire
    }

    /// How far each of these points moves along x, y, z; the farthest by 1.
    pub fn shape(&self) -> &[[f64; 3]] {
        &self.shape
    }

    /// How far the farthest of them moves for a modal mass of 1 kg \[1/√kg\], as [`Self::reaction`] is counted.
    pub fn largest(&self) -> f64 {
        self.largest
    }
}

impl Modes {
    /// One mode, by its number from 1 as in [`Self::frequencies`].
    ///
    /// # Errors
    /// [`Error::Value`] as [`Self::frequencies`], and for a mode that does not swing: a helix that has buckled, a free rotation.
    pub fn mode(&self, index: usize) -> Result<Mode, Error> {
        let roots = self.roots("index", index)?;
        let root = roots.last().copied().unwrap_or(0.0);
        check(root > 0.0, "index", index as f64, "", "that of a mode that swings")?;
        self.shaped(&self.fine(root), root, index).ok_or_else(|| beyond("index", index as f64, ""))
    }

    /// The lowest modes, lowest first, found together; those that do not swing (see [`Self::frequencies`]) are left out.
    ///
    /// # Errors
    /// [`Error::Value`] as [`Self::frequencies`].
    pub fn lowest(&self, count: usize) -> Result<Vec<Mode>, Error> {
        let roots = self.roots("count", count)?;
        let chain = self.fine(roots.last().copied().unwrap_or(0.0));
        let swinging = roots.iter().zip(1..).filter(|(root, _)| **root > 0.0);
        let modes = swinging.map(|(root, index)| self.shaped(&chain, *root, index)).collect::<Option<_>>();
        modes.ok_or_else(|| beyond("count", count as f64, ""))
    }

    /// Pieces that are short enough for a shape.
    pub(super) fn fine(&self, root: f64) -> Chain {
        let fine = Chain::new(self.helix(), self.ends(), POINTS_PER_WINDING, root * root);
        fine.unwrap_or_else(|| self.chain.clone())
    }

    pub(super) fn shaped(&self, chain: &Chain, root: f64, index: usize) -> Option<Mode> {
        Some(Motion::new(chain, root * root, index)?.mode(self.helix(), chain, root * root))
    }
}

/// Displacements and rotations of every joint in the section's axes, modal mass one, in scaled units.
struct Motion {
    joints: Vec<[f64; 6]>,
    /// External forces at the points of the axis, in the axes of each holding.
    forces: [[f64; 6]; 2],
}

impl Motion {
    fn new(chain: &Chain, lambda: f64, index: usize) -> Option<Self> {
        let tree = Tree::new(chain, lambda);
        let middle = middle(chain, lambda, index)?;
        let [mut one, mut two] = tree.parts.map(|part| part.stiffness);
        chain.arms[0].apply(&mut one, 0);
        chain.arms[1].apply(&mut two, 6);
        let ends = [freed(&one, &chain.ends.end1, (0, 6), &middle), freed(&two, &chain.ends.end2, (6, 0), &middle)];
        let forces = [force(&one, (0, 6), &ends[0], &middle), force(&two, (6, 0), &ends[1], &middle)];
        let at_wire = |end: usize| times(&chain.arms[end].motion, &ends[end]);
        let mut motion = Self { joints: tree.spread(at_wire(0), middle, at_wire(1)), forces };
        let size = motion.mass(chain, lambda).sqrt();
        motion.joints.iter_mut().chain(&mut motion.forces).flatten().for_each(|value| *value /= size);
        Some(motion)
    }

    fn mass(&self, chain: &Chain, lambda: f64) -> f64 {
        let mass = chain.segment.mass(lambda);
        let one = |pair: &[[f64; 6]]| {
            let both: [f64; 12] = std::array::from_fn(|i| pair[i / 6][i % 6]);
            both.iter().zip(&mass).map(|(value, row)| value * dot(row, &both)).sum::<f64>()
        };
        self.joints.windows(2).map(one).sum()
    }

    fn mode(&self, helix: &Helix, chain: &Chain, lambda: f64) -> Mode {
        let state = &helix.scaled;
        let last = self.joints.len() - 1;
        let step = state.wire / last as f64;
        let (s, c) = state.angle.sin_cos();
        let rise = state.wire.recip() * helix.span() / state.unit;
        let (mut wire, mut moved) = (Vec::with_capacity(last + 1), Vec::with_capacity(last + 1));
        for (at, [along, inward, across, ..]) in self.joints.iter().enumerate() {
            let place = at as f64 * step;
            let (sine, cosine) = (state.turn * place).sin_cos();
            wire.push([state.radius * cosine, state.radius * sine, rise * place].map(|x| x * state.unit));
            let around = along * c - across * s;
            moved.push([-inward * cosine - around * sine, -inward * sine + around * cosine, along * s + across * c]);
        }
        let shares = Shares::of(&wire, &moved, helix.rod().parameters().windings);
        let largest = moved.iter().map(|w| dot(w, w).sqrt()).fold(f64::MIN_POSITIVE, f64::max);
        let scaled_stiffness = state.slopes[0] / state.wire;
        let line_strength = (self.forces[0][2] * self.forces[1][2]).abs() / (2.0 * scaled_stiffness * lambda);
        Mode {
            frequency: (lambda / helix.eigenvalue_unit()).sqrt() / TAU,
            shares,
            line_strength,
            reactions: [(0, &chain.ends.end1), (1, &chain.ends.end2)]
                .map(|(end, holding)| self.reaction(helix, end, holding)),
            wire,
            shape: moved.into_iter().map(|w| w.map(|value| value / largest)).collect(),
            largest: largest / unit_mass(helix).sqrt(),
        }
    }

    /// What the spring does to a holding: the opposite of what holds it.
    fn reaction(&self, helix: &Helix, end: usize, holding: &Holding) -> Reaction {
        let state = &helix.scaled;
        let force = state.bending / state.unit.powi(3) / unit_mass(helix).sqrt();
        let values = std::array::from_fn(|i| {
            let unit = if i < 3 { force } else { force * state.unit };
            // A free direction has no reaction, but rounding.
            Complex::from(if holding.is_free(i) { 0.0 } else { -self.forces[end][i] * unit })
        });
        Reaction::turned(values, holding.direction())
    }
}

/// What a modal mass of one in scaled units is \[kg\]: the mass of a unit of length.
fn unit_mass(helix: &Helix) -> f64 {
    helix.rod().parameters().density * helix.rod().area() * helix.scaled.unit
}

/// The motion of the section where both parts meet: the eigenvector of the eigenvalue that is zero.
fn middle(chain: &Chain, lambda: f64, index: usize) -> Option<[f64; 6]> {
    let (held, stiffness) = chain.section(lambda);
    if !finite(&stiffness) {
        return None;
    }
    let eigen = symmetric(&stiffness).symmetric_eigen();
    let mut order: [usize; 6] = std::array::from_fn(|i| i);
    order.sort_by(|i, j| eigen.eigenvalues[*i].total_cmp(&eigen.eigenvalues[*j]));
    let smallest = || (0..6).min_by(|i, j| eigen.eigenvalues[*i].abs().total_cmp(&eigen.eigenvalues[*j].abs()));
    let counted = index.checked_sub(held + 1).and_then(|at| order.get(at).copied());
    let column = eigen.eigenvectors.column(counted.or_else(smallest).unwrap_or(0));
    Some(std::array::from_fn(|i| column[i]))
}

/// The wire's joints by halves of halves.
struct Tree {
    /// What the middle of two equal blocks follows, from single pieces up.
    doublings: Vec<[[f64; 12]; 6]>,
    /// The same within both parts, where unequal blocks meet.
    unequal: [[[f64; 12]; 6]; 2],
    parts: [Block<f64>; 2],
}

impl Tree {
    fn new(chain: &Chain, lambda: f64) -> Self {
        let mut blocks = vec![chain.segment.at(lambda)];
        let mut doublings = Vec::new();
        for level in 0..chain.segment.doublings() as usize - 1 {
            let block = blocks[level];
            doublings.push(block.follows(&block));
            blocks.push(block.then(&block));
        }
        let at = blocks.len() - 1;
        let (half, quarter, eighth) = (&blocks[at], &blocks[at - 1], &blocks[at - 2]);
        let unequal = [half.follows(eighth), quarter.follows(eighth)];
        Self { doublings, unequal, parts: [half.then(eighth), quarter.then(eighth)] }
    }

    /// Every joint from the motion of both ends and of the section between the parts.
    fn spread(&self, first: [f64; 6], middle: [f64; 6], last: [f64; 6]) -> Vec<[f64; 6]> {
        let levels = self.doublings.len();
        let eighth = 1 << (levels - 2);
        let mut joints = vec![[0.0; 6]; 8 * eighth + 1];
        (joints[0], joints[5 * eighth], joints[8 * eighth]) = (first, middle, last);
        joints[4 * eighth] = follow(&self.unequal[0], &first, &middle);
        joints[7 * eighth] = follow(&self.unequal[1], &middle, &last);
        for (start, level) in [(0, levels), (4, levels - 2), (5, levels - 1), (7, levels - 2)] {
            self.fill(&mut joints, start * eighth, level);
        }
        joints
    }

    fn fill(&self, joints: &mut [[f64; 6]], first: usize, level: usize) {
        if level == 0 {
            return;
        }
        let half = 1 << (level - 1);
        joints[first + half] = follow(&self.doublings[level - 1], &joints[first], &joints[first + 2 * half]);
        self.fill(joints, first, level - 1);
        self.fill(joints, first + half, level - 1);
    }
}

fn follow(map: &[[f64; 12]; 6], near: &[f64; 6], far: &[f64; 6]) -> [f64; 6] {
    map.map(|row| dot(&row[..6], near) + dot(&row[6..], far))
}

fn times(matrix: &Square<f64, 6>, vector: &[f64; 6]) -> [f64; 6] {
    matrix.map(|row| dot(&row, vector))
}

fn dot(one: &[f64], other: &[f64]) -> f64 {
    one.iter().zip(other).map(|(x, y)| x * y).sum()
}

/// How an end moves at the axis where it is free to; its freedoms stand from `at.0` on, those of the section from `at.1` on.
fn freed(stiffness: &Square<f64, 12>, holding: &Holding, at: (usize, usize), middle: &[f64; 6]) -> [f64; 6] {
    let mut system = [[0.0; 7]; 6];
    for (i, row) in system.iter_mut().enumerate() {
        row[i] = 1.0;
        if holding.is_free(i) {
            for j in (0..6).filter(|j| holding.is_free(*j)) {
                row[j] = stiffness[at.0 + i][at.0 + j];
            }
            row[6] = -dot(&stiffness[at.0 + i][at.1..at.1 + 6], middle);
        }
    }
    reduce(&mut system);
    system.map(|row| row[6])
}

/// The force that holds an end.
fn force(stiffness: &Square<f64, 12>, at: (usize, usize), end: &[f64; 6], middle: &[f64; 6]) -> [f64; 6] {
    std::array::from_fn(|i| {
        let row = &stiffness[at.0 + i];
        dot(&row[at.0..at.0 + 6], end) + dot(&row[at.1..at.1 + 6], middle)
    })
}
