//! A plant as a sum of poles: what each adds to every force, and how it goes on from sample to sample.
//!
//! Next door: the matrices that they are found from (`matrices`), the loop that is run on them (`over_time`).

use nalgebra::{Complex, DMatrix, Schur};
use num_complex::Complex64;

use super::matrices::{Matrices, OUTPUTS, STROKE};
use super::plant::Plant;
use crate::error::{Error, check};

/// Most winding masses of a spring whose poles are looked for: the work goes with the third power of their number.
const MOST_MASSES: usize = 200;
/// How far the sum of poles may be from the plant's own response \[1\].
const CLOSE: f64 = 1e-5;
/// Distance of poles that coincide, over their size \[1\].
const APART: f64 = 2e-8;
/// Sweeps of the eigenvalue solver, for each state.
const SWEEPS: usize = 200;

/// `[F_i, F_o, F_x, F_L, y](s)/c = D + Σ_p R_p/(s − p)`: every pole of drive, spring and load.
///
/// Source:   Schur's form of [`Matrices`], eigenvectors by back-substitution: any text on linear algebra.
/// Valid:    as [`Plant`], up to 200 winding masses.
/// Accuracy: 1e-9 of the largest force beside [`Plant::at`], 1e-5 where poles coincide, as of critical modes (test); what is off by more than
/// that about the first surge frequencies is refused.
#[derive(Debug, Clone)]
pub(super) struct Poles {
    each: Vec<Pole>,
    direct: [f64; OUTPUTS],
}

/// One pole, or a conjugate pair.
#[derive(Debug, Clone)]
struct Pole {
    /// p \[rad/s\].
    value: Complex64,
    /// R_p, twice that for a pair.
    residues: [Complex64; OUTPUTS],
    /// What q_j has of it, twice that for a pair; shape `modes`.
    modes: Vec<Complex64>,
}

impl Poles {
    /// Finds them.
    ///
    /// # Errors
    /// [`Error::Value`] for more than 200 winding masses, or where the sum does not give the plant's response again.
    pub fn of(plant: &Plant) -> Result<Self, Error> {
        let masses = plant.spring().chain_masses();
        let allowed = format!("at most {MOST_MASSES} for a run over time of this drive and load");
        check(masses <= MOST_MASSES, "number of winding masses", masses as f64, "", allowed)?;
        let matrices = Matrices::of(plant);
        let size = matrices.b.len();
        let schur = Schur::try_new(matrices.a.map(|value| Complex::new(value, 0.0)), f64::EPSILON, SWEEPS * size);
        let slowest = plant.held_modes()[0][0];
        let found = schur.map(|schur| Self::in_form(&matrices, schur, slowest));
        let off = found.as_ref().map_or(Ok(f64::INFINITY), |poles| poles.off(plant))?;
        check(off <= CLOSE, "error of a plant's poles", off, "", format!("at most {CLOSE}"))?;
        // An error of none is finite.
        Ok(found.unwrap_or(Self { each: Vec::new(), direct: [0.0; OUTPUTS] }))
    }

    fn in_form(matrices: &Matrices, schur: Schur<Complex<f64>, nalgebra::Dyn>, slowest: f64) -> Self {
        let (basis, mut upper) = schur.unpack();
        part(&mut upper, slowest);
        let size = matrices.b.len();
        let vectors = eigenvectors(&upper);
        // B = Q Y w, Y upper triangular with a diagonal of ones.
        let mut inputs = basis.ad_mul(&matrices.b.map(|value| Complex::new(value, 0.0)));
        for row in (0..size).rev() {
            for column in row + 1..size {
                let known = vectors[(row, column)] * inputs[column];
                inputs[row] -= known;
            }
        }
        let vectors = basis * vectors;
        let seen = |row: &[f64], pole: usize| -> Complex64 {
            row.iter().zip(vectors.column(pole).iter()).map(|(factor, value)| value * *factor).sum()
        };
        let norm = upper.diagonal().iter().map(|value| value.norm()).fold(0.0, f64::max);
        let each = (0..size).filter_map(|pole| {
            let value: Complex64 = upper[(pole, pole)];
            // Of a pair the one above. Two poles that nearly coincide, as of a critical mode, are found with the root of what rounding leaves
            // only: they are no exact pair, and both count.
            let real = value.im.abs() <= 1e-5 * norm;
            let twice = if real { 1.0 } else { 2.0 };
            (real || value.im > 0.0).then(|| Pole {
                value,
                residues: std::array::from_fn(|output| {
                    seen(matrices.c[output].as_slice(), pole) * inputs[pole] * twice
                }),
                modes: matrices.modes.iter().map(|form| seen(form.as_slice(), pole) * inputs[pole] * twice).collect(),
            })
        });
        Self { each: each.collect(), direct: matrices.d }
    }

    /// The response over the command at s = jω; a pair by its real and imaginary part: (R/(s − p) + R̄/(s − p̄))/2.
    pub fn at(&self, angular_frequency: f64) -> [Complex64; OUTPUTS] {
        let s = Complex64::new(0.0, angular_frequency);
        let mut sum = self.direct.map(Complex64::from);
        for pole in &self.each {
            let [above, below] = [(s - pole.value).inv(), (s - pole.value.conj()).inv()];
            for (sum, residue) in sum.iter_mut().zip(&pole.residues) {
                *sum += 0.5 * (residue * above + residue.conj() * below);
            }
        }
        sum
    }

    /// p \[rad/s\], of a pair the upper one.
    pub fn values(&self) -> impl Iterator<Item = Complex64> + '_ {
        self.each.iter().map(|pole| pole.value)
    }

    /// D.
    pub fn direct(&self) -> [f64; OUTPUTS] {
        self.direct
    }

    /// Σ_p Re(R_p x_p).
    pub fn outputs(&self, state: &[Complex64]) -> [f64; OUTPUTS] {
        let mut sum = [0.0; OUTPUTS];
        for (pole, x) in self.each.iter().zip(state) {
            for (sum, residue) in sum.iter_mut().zip(&pole.residues) {
                *sum += residue.re * x.re - residue.im * x.im;
            }
        }
        sum
    }

    /// q_j of a state \[m\].
    pub fn modes(&self, state: &[Complex64]) -> Vec<f64> {
        let mut sum = vec![0.0; self.each.first().map_or(0, |pole| pole.modes.len())];
        for (pole, x) in self.each.iter().zip(state) {
            for (sum, share) in sum.iter_mut().zip(&pole.modes) {
                *sum += share.re * x.re - share.im * x.im;
            }
        }
        sum
    }

    /// How far the sum is from [`Plant::at`], as a share of the forces: on and beside the first surge frequency, and far above.
    fn off(&self, plant: &Plant) -> Result<f64, Error> {
        let surge = std::f64::consts::TAU * plant.spring().surge_frequency();
        let mut worst = 0.0_f64;
        for share in [0.11, 0.97, 1.0, 2.3, 7.7] {
            let (ours, theirs) = (self.at(share * surge), plant.at(share * surge)?);
            let theirs = [theirs.input, theirs.output, theirs.deflection, theirs.inductance];
            let size = theirs.iter().map(|force| force.norm()).fold(f64::MIN_POSITIVE, f64::max);
            for (ours, theirs) in ours[..STROKE].iter().zip(theirs) {
                let off = (ours - theirs).norm() / size;
                worst = worst.max(if off.is_nan() { f64::INFINITY } else { off });
            }
        }
        Ok(worst)
    }
}

/// Parts poles that coincide, as those of a critical mode: two near ones stand for a double one, with half the digits.
fn part(upper: &mut DMatrix<Complex<f64>>, slowest: f64) {
    for pole in 1..upper.nrows() {
        let least = APART * upper[(pole, pole)].norm().max(slowest);
        let met = |value: Complex<f64>| (0..pole).any(|other| (upper[(other, other)] - value).norm() < 0.5 * least);
        let mut value = upper[(pole, pole)];
        while met(value) {
            value += least;
        }
        upper[(pole, pole)] = value;
    }
}

/// Right eigenvectors of an upper triangular matrix, its diagonal's order, each with a 1 on the diagonal.
fn eigenvectors(upper: &DMatrix<Complex<f64>>) -> DMatrix<Complex<f64>> {
    let size = upper.nrows();
    let mut vectors = DMatrix::identity(size, size);
    for column in 0..size {
        for row in (0..column).rev() {
            let sum: Complex<f64> = (row + 1..=column).map(|k| upper[(row, k)] * vectors[(k, column)]).sum();
            vectors[(row, column)] = -sum / (upper[(row, row)] - upper[(column, column)]);
        }
    }
    vectors
}

#[cfg(test)]
mod tests {
    use std::f64::consts::TAU;

    use super::super::drive::Drive;
    use super::super::environment::Environment;
    use super::*;
    use crate::paper;
    use crate::{Damping, Spring, SpringParameters};

    fn drives() -> [Drive; 5] {
        [
            Drive::IDEAL_VELOCITY,
            Drive::Velocity { bandwidth: Some(40.0) },
            Drive::Force { mass: 2.0, friction: 30.0, bandwidth: None },
            Drive::Force { mass: 0.02, friction: 0.0, bandwidth: Some(1e4) },
            // Heavier than all the rest by far, and held back by friction that no wave moves.
            Drive::Force { mass: 100.0, friction: 1e4, bandwidth: Some(3.0) },
        ]
    }

    fn environments() -> [Environment; 6] {
        let meets = |mass, damping, stiffness| Environment::Impedance { mass, damping, stiffness };
        [
            Environment::Held,
            meets(1.0, 0.0, 0.0),
            meets(0.3, 5.0, 500.0),
            meets(0.0, 0.0, 500.0),
            meets(0.0, 7.0, 0.0),
            meets(0.0, 0.0, 0.0),
        ]
    }

    /// Largest difference of each output over its own largest, forces over that of all four.
    fn off(poles: &Poles, plant: &Plant) -> f64 {
        let hertz = [0.3, 6.0, 27.0, 54.05, 54.06, 90.0, 400.0, 1700.0, 5e4];
        let theirs = hertz.map(|hertz| plant.at(TAU * hertz).unwrap());
        let theirs = theirs.map(|one| [one.input, one.output, one.deflection, one.inductance, one.stroke]);
        let peak = |outputs: std::ops::Range<usize>| {
            theirs.iter().flat_map(|each| each[outputs.clone()].to_vec()).map(|value| value.norm()).fold(0.0, f64::max)
        };
        let scales = [peak(0..STROKE), peak(STROKE..OUTPUTS)];
        let pairs = hertz.iter().map(|hertz| poles.at(TAU * hertz)).zip(&theirs);
        let each = pairs.flat_map(|(ours, theirs)| {
            std::array::from_fn::<f64, OUTPUTS, _>(|output| {
                (ours[output] - theirs[output]).norm() / scales[usize::from(output == STROKE)]
            })
        });
        each.fold(0.0, f64::max)
    }

    #[test]
    fn the_sum_of_poles_is_the_plants_own_response() {
        let critical = Damping::Modal(1.0);
        let dampings = [
            Damping::Modal(0.005),
            critical.clone(),
            Damping::MassProportional { rate: 30.0 },
            Damping::StiffnessProportional { time: 3e-5 },
        ];
        let mut worst = [0.0_f64; 2];
        for spring in [paper::s_t(), Spring::new(SpringParameters { windings: 3.0, ..paper::S_T }).unwrap()] {
            for (drive, environment) in drives().into_iter().flat_map(|drive| environments().map(|e| (drive, e))) {
                for damping in &dampings {
                    let plant = Plant::new(&spring, damping.clone(), drive, environment).unwrap();
                    let poles = Poles::of(&plant)
                        .unwrap_or_else(|error| panic!("{drive:?} {environment:?} {damping:?}: {error}"));
                    let off = off(&poles, &plant);
                    // Two poles coincide of critical modes, and at rest where nothing holds motor and load: half the digits are left.
                    let slides = matches!(drive, Drive::Force { friction: 0.0, .. })
                        && matches!(environment, Environment::Impedance { damping: 0.0, stiffness: 0.0, .. });
                    let doubled = *damping == critical || slides;
                    worst[usize::from(doubled)] = worst[usize::from(doubled)].max(off);
                    let close = if doubled { CLOSE } else { 1e-9 };
                    assert!(off < close, "{drive:?} {environment:?} {damping:?}: {off:e}");
                }
            }
        }
        println!("poles beside the plant: {:e} of the largest force, {:e} where poles coincide", worst[0], worst[1]);
    }

    #[test]
    fn a_spring_of_too_many_masses_is_refused_by_their_number() {
        let spring = Spring::new(SpringParameters { windings: 201.0, ..paper::S_T }).unwrap();
        let plant = Plant::new(&spring, Damping::Modal(0.01), drives()[2], Environment::Held).unwrap();
        let text = Poles::of(&plant).unwrap_err().to_string();
        assert!(text.starts_with("number of winding masses must be at most 200 for a run over time"), "{text}");
    }
}
