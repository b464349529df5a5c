//! Modal coordinates of equidistant samples: `e^(λ(t + s)) = e^(λt) e^(λs)` with t a block's begin and s within it.
//!
//! Next door: samples of any kind (`modal_block`), the closed solution (`closed`), the tables' entries (`phasors`).

use aligned_vec::{AVec, avec};
use num_complex::Complex64;
use pulp::{Simd, WithSimd};

use super::closed::{Closed, Drive, Segment};
use super::exponentials::Exponentials;
use super::modal_rows::{WIDTH, row_of};
use super::oscillator::{divided_exponential, exponential};
use super::phasors::{Phasors, Steps};
use crate::simd::dispatch;

const I: Complex64 = Complex64::new(0.0, 1.0);

/// Equidistant samples under one free motion and the same sines: sums of products of a number per block and a table over its samples.
pub(super) struct Stretch<'a> {
    segment: &'a Segment,
    drives: Vec<&'a Drive>,
    modes: usize,
    /// Row and table of each product.
    products: Vec<(usize, usize)>,
    /// Each product's factor at the block's begin.
    factors: Vec<Complex64>,
    /// Shape `tables × WIDTH` each.
    tables: [AVec<f64>; 2],
    /// Shape `modes × WIDTH`.
    pub coordinates: AVec<f64>,
}

impl<'a> Stretch<'a> {
    /// Of the segment with a number; `step`: between samples \[s\].
    pub(super) fn new(closed: &'a Closed, segment: usize, step: f64) -> Self {
        let segment = &closed.segments[segment];
        let drives = closed.drives.iter().filter(|drive| drive.sine.acts_at(segment.from)).collect();
        let modes = closed.oscillators.len();
        let tables = [avec![], avec![]];
        let coordinates = avec![0.0; modes * WIDTH];
        let mut stretch =
            Self { segment, drives, modes, products: Vec::new(), factors: Vec::new(), tables, coordinates };
        stretch.list_products();
        dispatch(Tabulate { stretch: &mut stretch, step });
        stretch
    }

    /// Rows and tables of all products, in the order in which [`Self::begin`] finds their factors.
    fn list_products(&mut self) {
        let mut table = 0;
        for part in self.segment.exponentials.iter().filter(|part| part.coefficient != Complex64::default()) {
            self.products.push((row_of(part.mode, self.modes), table));
            table += 1;
        }
        for drive in &self.drives {
            let shared = table;
            table += 1;
            for (mode, gain) in drive.gains.iter().enumerate() {
                if *gain != Complex64::default() {
                    self.products.push((row_of(mode, self.modes), shared));
                }
            }
            for near in &drive.near {
                let row = row_of(near.mode, self.modes);
                self.products.extend([(row, shared), (row, table), (row, table + 1)]);
                table += 2;
            }
        }
    }

    /// Finds the coordinates of the block that begins at a time.
    pub(super) fn begin(&mut self, time: f64) {
        self.factors.clear();
        dispatch(Free { stretch: self, time });
        for drive in &self.drives {
            let elapsed = time - drive.sine.since;
            let turn = I * drive.sine.angular;
            // Im(z) = Re(−i z)
            let phasor = -I * exponential(turn * elapsed + I * drive.sine.phase);
            let gains = drive.gains.iter().filter(|gain| **gain != Complex64::default());
            self.factors.extend(gains.map(|gain| gain * phasor));
            for near in &drive.near {
                // E(t + s) = e^(λt) E(s) + E(t) e^(iωs), for λ and its conjugate.
                let [first, second] = [near.root, near.root.conj()];
                let value = divided_exponential(first, turn, elapsed) - divided_exponential(second, turn, elapsed);
                let [carried, against] = [first, second].map(|root| near.coefficient * exponential(root * elapsed));
                self.factors.extend([near.coefficient * value, carried, -against]);
            }
        }
        dispatch(Sum(self));
    }

    #[inline(always)]
    fn tabulate<const FUSED: bool>(&mut self, step: f64) {
        let steps = Steps::new(0.0, step, WIDTH);
        let mut direct = Exponentials::default();
        let free = self.segment.exponentials.iter().filter(|part| part.coefficient != Complex64::default());
        for part in free.clone() {
            steps.push(part.root, &mut direct);
        }
        for drive in &self.drives {
            steps.push(I * drive.sine.angular, &mut direct);
        }
        direct.evaluate::<FUSED>();
        let mut phasors = Phasors::of(WIDTH);
        let mut next = 0;
        for _ in free {
            phasors.powers(&direct, next);
            next += steps.count();
            phasors.append_to(&mut self.tables);
        }
        let mut divided = Phasors::of(WIDTH);
        for drive in &self.drives {
            phasors.powers(&direct, next);
            next += steps.count();
            phasors.append_to(&mut self.tables);
            for near in &drive.near {
                for root in [near.root, near.root.conj()] {
                    divided.divided(root, I * drive.sine.angular, 0.0, step, &phasors);
                    divided.append_to(&mut self.tables);
                }
            }
        }
    }

    #[inline(always)]
    fn free<const FUSED: bool>(&mut self, time: f64) {
        let parts = self.segment.exponentials.iter().filter(|part| part.coefficient != Complex64::default());
        let mut values = Exponentials::default();
        for part in parts.clone() {
            values.push(part.root * (time - self.segment.from));
        }
        values.evaluate::<FUSED>();
        self.factors.extend(parts.enumerate().map(|(index, part)| part.coefficient * values.get(index)));
    }
}

/// Fills a stretch's tables.
struct Tabulate<'a, 'b> {
    stretch: &'a mut Stretch<'b>,
    step: f64,
}

impl WithSimd for Tabulate<'_, '_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, _: S) {
        if S::IS_SCALAR { self.stretch.tabulate::<false>(self.step) } else { self.stretch.tabulate::<true>(self.step) }
    }
}

/// Finds the factors of the free motion at a time.
struct Free<'a, 'b> {
    stretch: &'a mut Stretch<'b>,
    time: f64,
}

impl WithSimd for Free<'_, '_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, _: S) {
        if S::IS_SCALAR { self.stretch.free::<false>(self.time) } else { self.stretch.free::<true>(self.time) }
    }
}

/// Adds the products up.
struct Sum<'a, 'b>(&'a mut Stretch<'b>);

impl WithSimd for Sum<'_, '_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) {
        let stretch = self.0;
        stretch.coordinates.fill(0.0);
        for ((row, table), factor) in stretch.products.iter().zip(&stretch.factors) {
            let [real, imaginary] =
                stretch.tables.each_ref().map(|parts| S::as_simd_f64s(&parts[table * WIDTH..][..WIDTH]).0);
            let (coordinates, _) = S::as_mut_simd_f64s(&mut stretch.coordinates[row * WIDTH..][..WIDTH]);
            let (re, im) = (simd.splat_f64s(factor.re), simd.splat_f64s(-factor.im));
            for ((sum, real), imaginary) in coordinates.iter_mut().zip(real).zip(imaginary) {
                *sum = simd.mul_add_e_f64s(im, *imaginary, simd.mul_add_e_f64s(re, *real, *sum));
            }
        }
    }
}
