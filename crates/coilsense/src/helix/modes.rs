//! Natural frequencies of the stretched helix: counted, then found, so that none is missed.
//!
//! Next door: what a mode looks like (`mode`), the response to a motion of the ends (`response`).

use std::f64::consts::TAU;

use super::chain::Chain;
use super::ends::Ends;
use super::state::Helix;
use crate::error::{Error, check};

/// Pieces per winding at the least: the series in λ of one piece then holds up to about 100 times the surge of common springs, and no
/// frequency moves by more than 1e-9 with more of them.
pub(super) const PER_WINDING: f64 = 4.0;

/// Most modes that are asked for at once.
const MOST_MODES: usize = 10_000;

/// Relative width at which a root is found.
const WIDTH: f64 = 4e-13;

/// Zero, for a root: a frequency this much below that of a bar \[1\].
const FLOOR: f64 = 1e-5;

/// The modes of a helix between its ends.
///
/// How many lie below a frequency is counted from signs alone: the modes of pieces that are held at their ends, and the negative
/// eigenvalues of what holds the pieces together. The i-th frequency is then the zero of one eigenvalue between two counts, so that
/// none is missed however close two are.
///
/// Source:   `[WittrickWilliams1971]` for the count; the wire as in [`Helix`], with the couple and the force that it is under.
/// Valid:    small motions about the state; linear material, no damping, windings that do not touch, no dead windings.
/// Accuracy: 1e-8 by another number of pieces, 2.1e-9 against straight finite elements; `tests/helix` has these, the limits (beam,
///           column, bar) and the figures.
///
/// ```
/// use coilsense::helix::{Ends, Hand, Helix, Modes, Rod, RodParameters, Turning};
///
/// let rod = Rod::new(RodParameters {
///     wire_diameter: 0.001, coil_radius: 0.005, windings: 7.6, rest_span: 0.036,
///     youngs_modulus: 206e9, shear_modulus: 206e9 / 2.6, density: 7900.0, hand: Hand::Right,
/// })?;
/// let modes = Modes::new(&Helix::new(&rod, 0.036, Turning::Held)?, Ends::clamped())?;
/// assert_eq!(modes.count_below(400.0)?, 2);
/// let frequencies = modes.frequencies(4)?;
/// assert!((frequencies[2] - 462.8).abs() < 0.2);
/// # Ok::<(), coilsense::Error>(())
/// ```
#[derive(Debug, Clone)]
pub struct Modes {
    pub(super) helix: Helix,
    pub(super) chain: Chain,
    /// λ per (rad/s)².
    unit: f64,
    /// First frequency of a bar of the stiffness and mass of the helix \[Hz\].
    pub(super) bar_frequency: f64,
    /// Its √λ, from which the search starts.
    start: f64,
}

/// What is known at one √λ.
#[derive(Debug, Clone, Copy)]
struct Sample {
    root: f64,
    /// Modes below with the middle section held.
    held: usize,
    /// Eigenvalues of the stiffness at that section, lowest first.
    eigenvalues: [f64; 6],
}

impl Sample {
    fn count(&self) -> usize {
        self.held + self.eigenvalues.iter().filter(|value| **value < 0.0).count()
    }

    /// The eigenvalue whose zero is mode `index` (from 1), where it is one of the section's.
    fn eigenvalue(&self, index: usize) -> Option<f64> {
        self.eigenvalues.get(index.checked_sub(self.held + 1)?).copied()
    }
}

impl Modes {
    /// The modes of a helix whose ends are held in some way.
    ///
    /// # Errors
    /// [`Error::Value`] for a helix so long or so thin that it cannot be divided into pieces.
    pub fn new(helix: &Helix, ends: Ends) -> Result<Self, Error> {
        let unit = helix.eigenvalue_unit();
        let mass = helix.rod().mass();
        let bar = 0.5 * (helix.stiffness().abs() / mass).sqrt();
        let start = 0.5 * TAU * bar * unit.sqrt();
        let swings = start.is_finite() && start > 0.0;
        match Chain::new(helix, &ends, PER_WINDING, start * start) {
            Some(chain) if swings => Ok(Self { helix: *helix, chain, unit, bar_frequency: bar, start }),
            _ => Err(beyond("windings", helix.rod().parameters().windings, "")),
        }
    }

    /// The helix.
    pub fn helix(&self) -> &Helix {
        &self.helix
    }

    /// How the ends are held.
    pub fn ends(&self) -> &Ends {
        &self.chain.ends
    }

    /// How many modes lie below a frequency \[Hz\].
    ///
    /// A helix that has buckled has modes below every frequency; a wire that can turn freely about its axis one at zero.
    ///
    /// # Errors
    /// [`Error::Value`] for a frequency that is not finite, is below zero, or is so high that no piece is short enough for it.
    pub fn count_below(&self, frequency: f64) -> Result<usize, Error> {
        check(frequency.is_finite() && frequency >= 0.0, "frequency", frequency, "Hz", "finite and not below zero")?;
        let lambda = (TAU * frequency).powi(2) * self.unit;
        self.count(lambda).ok_or_else(|| beyond("frequency", frequency, "Hz"))
    }

    /// The lowest frequencies, lowest first \[Hz\].
    ///
    /// - `count`: how many. Modes that grow instead of swinging (a buckled helix) and free rotations come first, as zero.
    ///
    /// # Errors
    /// [`Error::Value`] for no modes or more than 10 000, and where they lie so high that no piece is short enough for them.
    pub fn frequencies(&self, count: usize) -> Result<Vec<f64>, Error> {
        let roots = self.roots("count", count)?;
        Ok(roots.into_iter().map(|root| root / self.unit.sqrt() / TAU).collect())
    }

    /// √λ of the lowest modes.
    pub(super) fn roots(&self, quantity: &'static str, count: usize) -> Result<Vec<f64>, Error> {
        let allowed = format!("from 1 to {MOST_MODES}");
        check((1..=MOST_MODES).contains(&count), quantity, count as f64, "", allowed)?;
        let mut search = Search { modes: self, chain: self.chain.clone(), samples: Vec::new() };
        let found = search.start(count).and_then(|()| (1..=count).map(|index| search.root(index)).collect());
        found.ok_or_else(|| beyond(quantity, count as f64, ""))
    }

    /// Numbers and √λ of the modes between two frequencies \[Hz\], at most so many; `None` where there are more, or no piece is short enough.
    pub(super) fn roots_between(&self, from: f64, to: f64, most: usize) -> Option<Vec<(usize, f64)>> {
        let mut search = Search { modes: self, chain: self.chain.clone(), samples: Vec::new() };
        let root = |frequency: f64| TAU * frequency * self.unit.sqrt();
        let below = search.look(root(from))?.count();
        let last = search.look(root(to))?.count();
        if last > below + most {
            return None;
        }
        (below + 1..=last).map(|index| Some((index, search.root(index)?))).collect()
    }

    /// λ of a bar of the helix's stiffness and mass, about.
    pub(super) fn bar(&self) -> f64 {
        self.start * self.start
    }

    fn count(&self, lambda: f64) -> Option<usize> {
        if lambda <= self.chain.segment.most() {
            return Some(self.chain.count(lambda));
        }
        Some(Chain::new(&self.helix, &self.chain.ends, PER_WINDING, lambda)?.count(lambda))
    }
}

/// As nalgebra takes it.
pub(super) fn symmetric(matrix: &[[f64; 6]; 6]) -> nalgebra::Matrix6<f64> {
    nalgebra::Matrix6::from_fn(|i, j| matrix[i][j])
}

/// Whether a stiffness is one: its eigenvalues are not asked for else.
pub(super) fn finite(matrix: &[[f64; 6]; 6]) -> bool {
    matrix.iter().flatten().all(|value| value.is_finite())
}

/// What cannot be followed.
pub(super) fn beyond(field: &'static str, value: f64, unit: &'static str) -> Error {
    Error::Value {
        field: Some(field),
        quantity: field.into(),
        value,
        unit,
        allowed: "one that the helix can be divided for".into(),
    }
}

/// A search, with all that it has seen, by rising frequency.
struct Search<'a> {
    modes: &'a Modes,
    /// Pieces that are short enough for all that has been looked at.
    chain: Chain,
    samples: Vec<Sample>,
}

impl Search<'_> {
    /// Samples from almost zero until so many modes lie below.
    fn start(&mut self, count: usize) -> Option<()> {
        let mut root = FLOOR * self.modes.start;
        self.look(root)?;
        root = 0.5 * self.modes.start;
        while self.look(root)?.count() < count {
            root *= 1.5;
        }
        Some(())
    }

    fn look(&mut self, root: f64) -> Option<Sample> {
        let lambda = root * root;
        if lambda > self.chain.segment.most() {
            self.chain = Chain::new(&self.modes.helix, &self.chain.ends, PER_WINDING, lambda)?;
        }
        let (held, middle) = self.chain.section(lambda);
        if !finite(&middle) {
            return None;
        }
        let mut eigenvalues: [f64; 6] = symmetric(&middle).symmetric_eigenvalues().into();
        eigenvalues.sort_by(f64::total_cmp);
        let sample = Sample { root, held, eigenvalues };
        let at = self.samples.partition_point(|other| other.root < root);
        self.samples.insert(at, sample);
        Some(sample)
    }

    /// √λ of mode `index`, from 1.
    fn root(&mut self, index: usize) -> Option<f64> {
        loop {
            let at = self.samples.partition_point(|sample| sample.count() < index);
            let high = *self.samples.get(at)?;
            let Some(low) = at.checked_sub(1).map(|at| self.samples[at]) else { return Some(0.0) };
            if high.root - low.root <= WIDTH * high.root {
                return Some(0.5 * (low.root + high.root));
            }
            // No mode of the held parts between: the eigenvalue falls through zero without a jump.
            if low.held == high.held
                && let (Some(above), Some(under)) = (low.eigenvalue(index), high.eigenvalue(index))
            {
                // Where rounding moves a mode of the held parts in between, what has been seen narrows the search all the same.
                match self.refine(index, (low.root, above), (high.root, under)) {
                    Some(root) => return Some(root),
                    None => continue,
                }
            }
            self.look(0.5 * (low.root + high.root))?;
        }
    }

    /// Zero of an eigenvalue between two samples, by Chandrupatla's choice of interpolation or halving.
    fn refine(&mut self, index: usize, (mut a, mut fa): (f64, f64), (mut b, mut fb): (f64, f64)) -> Option<f64> {
        let (mut share, mut c, mut fc);
        share = 0.5;
        for _ in 0..100 {
            if fb == 0.0 {
                return Some(b);
            }
            let x = a + share * (b - a);
            let sample = self.look(x)?;
            let fx = sample.eigenvalue(index)?;
            if (fx < 0.0) == (fa < 0.0) {
                (c, fc) = (a, fa);
            } else {
                (c, fc, b, fb) = (b, fb, a, fa);
            }
            (a, fa) = (x, fx);
            let (best, value) = if fa.abs() < fb.abs() { (a, fa) } else { (b, fb) };
            let limit = WIDTH * best.abs() / (b - a).abs();
            if limit > 0.5 || value == 0.0 {
                return Some(best);
            }
            let (xi, phi) = ((a - b) / (c - b), (fa - fb) / (fc - fb));
            let inside = phi * phi < xi && (1.0 - phi).powi(2) < 1.0 - xi;
            share = if inside {
                fa / (fb - fa) * fc / (fb - fc) + (c - a) / (b - a) * fa / (fc - fa) * fb / (fc - fb)
            } else {
                0.5
            };
            share = share.clamp(limit, 1.0 - limit);
        }
        Some(0.5 * (a + b))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::helix::{Hand, Rod, RodParameters, Turning};

    #[test]
    fn no_number_of_pieces_changes_a_frequency() {
        let s_t = RodParameters {
            wire_diameter: 0.002,
            coil_radius: 0.008,
            windings: 52.0,
            rest_span: 0.104,
            youngs_modulus: 206e9,
            shear_modulus: 81.5e9,
            density: 7850.0,
            hand: Hand::Right,
        };
        let short =
            RodParameters { windings: 5.75, wire_diameter: 0.004, coil_radius: 0.0125, rest_span: 0.049, ..s_t };
        for (parameters, span) in [(s_t, 0.230), (short, 0.035)] {
            let helix = Helix::new(&Rod::new(parameters).unwrap(), span, Turning::Held).unwrap();
            let mut modes = Modes::new(&helix, Ends::clamped()).unwrap();
            let expected = modes.frequencies(30).unwrap();
            for per_winding in [1.0, 2.0, 8.0, 16.0] {
                modes.chain = Chain::new(&helix, &Ends::clamped(), per_winding, 0.0).unwrap();
                let found = modes.frequencies(30).unwrap();
                let apart = found.iter().zip(&expected).map(|(one, other)| (one / other - 1.0).abs());
                let largest = apart.fold(0.0, f64::max);
                // Rounding of stiff pieces joined to a soft chain: 4e-11 of S_T with one piece per winding, 6e-9 with 16, and 3e-8
                // with 32, that no frequency below 150 kHz asks for.
                assert!(largest < 1e-8, "{per_winding}: {largest:e}");
            }
        }
    }
}
