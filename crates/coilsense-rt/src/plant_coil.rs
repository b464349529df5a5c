//! The inductance of a plant's windings and the force that it tells, to second order, with a bound.
//!
//! Next door: where its modes are (`plant`), how near its windings are (`plant_windings`), where the numbers come from (`coilsense::plant`).

use crate::plant::{Plant, PlantState};
use crate::real::Real;

/// A spring in `MODES` modes as a coil of `GAPS` + 1 turns, in polynomials of `TERMS` coefficients: plain numbers that the host finds, in the
/// precision of the plant's steps.
///
/// Coefficients are those of 1, z, z² …, z = (p − p0)/w from −1 to 1, p the mean pitch.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PlantCoil<T, const MODES: usize, const GAPS: usize, const TERMS: usize> {
    /// The distance between the ends where all inputs are zero \[m\].
    pub mean_length: f64,
    /// N_L: over how many windings that distance is divided.
    pub windings: f64,
    /// p0 and w \[m\]: the middle and the half of the pitches that polynomials are good for.
    pub pitches: [f64; 2],
    /// α \[1/(H m)\] and β \[1/m\] of the calibration 1/l = αL + β.
    pub calibration: [f64; 2],
    /// What polynomials leave of L, at most \[1\].
    pub left: f64,
    /// L of evenly spaced turns \[H\].
    pub inductance: [T; TERMS],
    /// 2M′(ap) \[H/m\] of turns a = 1, 2 … apart.
    pub slopes: [[T; TERMS]; GAPS],
    /// M″(ap) \[H/m²\].
    pub curvatures: [[T; TERMS]; GAPS],
    /// ⅓ |M‴(ap)| ap \[H/m²\].
    pub remainders: [[T; TERMS]; GAPS],
    /// How much the distance of each turn to the next grows per q of each mode \[1\].
    pub gaps: [[T; MODES]; GAPS],
}

/// What the coil of a plant reads.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CoilReading<T> {
    /// L \[H\].
    pub inductance: T,
    /// How far that may be from Maxwell's sum over the plant's windings \[H\]; [`Real::LARGEST`] where nothing is known: beyond the lengths that
    /// the polynomials are good for, or where windings would meet.
    pub inductance_bound: T,
    /// F_L \[N\], tension-positive: the force that a meter of L tells by its calibration.
    pub force: T,
    /// How far that may be off by [`Self::inductance_bound`] \[N\]; what the calibration is off is not in it, as it is F_L's own.
    pub force_bound: T,
}

/// Operations that one after the other may each leave half a last digit: of the largest terms, some dozens.
const ROUNDINGS: f64 = 64.0;

impl<T: Real, const MODES: usize, const GAPS: usize, const TERMS: usize> PlantCoil<T, MODES, GAPS, TERMS> {
    /// L and F_L of a state, one sample.
    ///
    /// L ≈ L0(p) + Σ_a (2M′(ap) Σ_i d_ia + M″(ap) Σ_i d_ia²), d_ia how much turns i and i + a are further apart than a·p;
    /// F_L = k (1/(αL + β) − l0)
    ///
    /// Source:   `coilsense::inductance::SecondOrder` at the mean pitch p of each instant, and its bound; `[Weijde2017]` eqs. 11 and 13.
    /// Valid:    as [`Plant`]; wire that is not magnetic, direct current, a coil of one radius.
    /// Accuracy: its bound, which the tests hold against Maxwell's sum (`coilsense`, `tests/plant`).
    #[inline]
    pub fn reading(&self, plant: &Plant<T, MODES>, state: &PlantState<T, MODES>) -> CoilReading<T> {
        let pitch = (T::nearest(self.mean_length) + plant.longer(state)) * T::nearest(1.0 / self.windings);
        let z = (pitch - T::nearest(self.pitches[0])) * T::nearest(1.0 / self.pitches[1]);
        let mut nearer = [T::ZERO; GAPS];
        let mut largest = T::ZERO;
        for (gap, change) in self.gaps.iter().zip(&mut nearer) {
            *change = state.sum(gap);
            let size = if *change < T::ZERO { -*change } else { *change };
            // Kept where it is not a number, too: there is then no bound.
            largest = if size <= largest { largest } else { size };
        }
        let (uneven, remainder) = self.uneven(&nearer, z);
        let inductance = polynomial(&self.inductance, z) + uneven;
        let strain = largest / pitch;
        let room = T::ONE - strain;
        let inductance_bound = if pitch > T::ZERO && room > T::ZERO && z <= T::ONE && -T::ONE <= z {
            let cube = room * room * room;
            strain * remainder / (cube * cube) + T::nearest(self.left + ROUNDINGS * T::ROUNDING) * inductance
        } else {
            T::LARGEST
        };
        let [alpha, beta] = self.calibration.map(T::nearest);
        let length = T::ONE / (alpha * inductance + beta);
        let force = plant.force_at(length - T::nearest(self.mean_length));
        let steep = if alpha < T::ZERO { -alpha } else { alpha };
        let share = steep * length * inductance_bound;
        let room = T::ONE - share;
        let force_bound = if room > T::ZERO { plant.stiffness() * (length * share) / room } else { T::LARGEST };
        CoilReading { inductance, inductance_bound, force, force_bound }
    }

    /// What unevenly spaced turns add to L, and Σ_a ⅓ |M‴(ap)| ap Σ_i d².
    #[inline]
    fn uneven(&self, nearer: &[T; GAPS], z: T) -> (T, T) {
        let (mut uneven, mut remainder) = (T::ZERO, T::ZERO);
        let mut distances = [T::ZERO; GAPS];
        let coefficients = self.slopes.iter().zip(&self.curvatures).zip(&self.remainders);
        for (lag, ((slope, curvature), third)) in coefficients.enumerate() {
            let (mut sum, mut squares) = (T::ZERO, T::ZERO);
            for (distance, change) in distances.iter_mut().zip(nearer.iter().skip(lag)) {
                *distance = *distance + *change;
                sum = sum + *distance;
                squares = squares + *distance * *distance;
            }
            uneven = uneven + (polynomial(slope, z) * sum + polynomial(curvature, z) * squares);
            remainder = remainder + polynomial(third, z) * squares;
        }
        (uneven, remainder)
    }
}

/// Horner's scheme.
#[inline]
fn polynomial<T: Real>(coefficients: &[T], z: T) -> T {
    let mut value = T::ZERO;
    for coefficient in coefficients.iter().rev() {
        value = value * z + *coefficient;
    }
    value
}
