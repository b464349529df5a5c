//! Exponentials at equidistant times: few of them evaluated directly, the others products.
//!
//! Next door: many direct ones at once (`exponentials`), what they are tables for (`phasor_sum`, `stretch`).

use aligned_vec::AVec;
use num_complex::Complex64;

use super::exponentials::Exponentials;
use super::oscillator::{divided_exponential, exponential};

/// Times at which an exponential is evaluated directly: the first, and strides from it by powers of two.
pub(super) struct Steps {
    first: f64,
    step: f64,
    doublings: usize,
}

impl Steps {
    /// For `count` equidistant times.
    pub(super) fn new(first: f64, step: f64, count: usize) -> Self {
        Self { first, step, doublings: count.next_power_of_two().ilog2() as usize }
    }

    /// How many there are.
    pub(super) fn count(&self) -> usize {
        1 + self.doublings
    }

    /// Appends a root's exponents.
    #[inline(always)]
    pub(super) fn push(&self, root: Complex64, direct: &mut Exponentials) {
        direct.push(root * self.first);
        let mut stride = root * self.step;
        for _ in 0..self.doublings {
            direct.push(stride);
            stride *= 2.0;
        }
    }
}

/// Values of a function at equidistant times.
pub(super) struct Phasors {
    pub re: Vec<f64>,
    pub im: Vec<f64>,
}

impl Phasors {
    #[inline(always)]
    pub(super) fn of(count: usize) -> Self {
        Self { re: vec![0.0; count], im: vec![0.0; count] }
    }

    /// Appends its real and its imaginary parts.
    pub(super) fn append_to(&self, [re, im]: &mut [AVec<f64>; 2]) {
        re.extend_from_slice(&self.re);
        im.extend_from_slice(&self.im);
    }

    /// e^(λ(first + k step)) from what [`Steps`] had evaluated, `begin` on: direct at powers of two, products between, so that no entry is
    /// more than log2(count) products away from a direct one.
    #[inline(always)]
    pub(super) fn powers(&mut self, direct: &Exponentials, begin: usize) {
        let start = direct.get(begin);
        (self.re[0], self.im[0]) = (start.re, start.im);
        let (mut known, mut next) = (1, begin + 1);
        while known < self.re.len() {
            let factor = direct.get(next);
            let (re, more_re) = self.re.split_at_mut(known);
            let (im, more_im) = self.im.split_at_mut(known);
            for (((re, im), new_re), new_im) in re.iter().zip(im.iter()).zip(more_re).zip(more_im) {
                *new_re = re * factor.re - im * factor.im;
                *new_im = re * factor.im + im * factor.re;
            }
            known *= 2;
            next += 1;
        }
    }

    /// E(first + k step) of a and b, likewise: `E(t + s) = e^(as) E(t) + E(s) e^(bt)`; `drive`: e^(bt) at the same times.
    #[inline(always)]
    pub(super) fn divided(&mut self, a: Complex64, b: Complex64, first: f64, step: f64, drive: &Self) {
        let start = divided_exponential(a, b, first);
        (self.re[0], self.im[0]) = (start.re, start.im);
        let (mut known, mut stride) = (1, step);
        while known < self.re.len() {
            let (factor, added) = (exponential(a * stride), divided_exponential(a, b, stride));
            let (re, more_re) = self.re.split_at_mut(known);
            let (im, more_im) = self.im.split_at_mut(known);
            let olds = re.iter().zip(im.iter()).zip(drive.re.iter().zip(&drive.im));
            for (((re, im), (drive_re, drive_im)), (new_re, new_im)) in olds.zip(more_re.iter_mut().zip(more_im)) {
                *new_re = re * factor.re - im * factor.im + drive_re * added.re - drive_im * added.im;
                *new_im = re * factor.im + im * factor.re + drive_re * added.im + drive_im * added.re;
            }
            known *= 2;
            stride *= 2.0;
        }
    }
}
