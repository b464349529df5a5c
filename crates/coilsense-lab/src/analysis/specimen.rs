//! Springs that the tolerances allow, spread evenly over them.
//!
//! Next door: the tolerances (`spec::Tolerances`), how far a sensor is off on such a spring (`response`), what that makes of a verdict
//! (`spread`).

use crate::spec::{Departure, Spec, SpringSpec, TOLERANCE_DIMENSIONS, Tolerances};

/// A change of stiffness at the same surge frequencies, and of surge frequencies at the same stiffness: ln κ and ln s.
pub(super) type Change = [f64; 2];

/// A spring that the tolerances allow.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Specimen {
    /// How it differs from the spec.
    pub departure: Departure,
    /// Its first surge frequency over that of a chain with its stiffness and mass \[1\]: how far a chain is a coil.
    pub coil: f64,
    /// How its stiffness and its surge frequencies differ: ln of the factors.
    pub change: Change,
}

/// Many of them, each as likely as any other; the first is the middle of the box.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Specimens {
    pub each: Vec<Specimen>,
    recipe: Option<Recipe>,
}

/// How they are drawn.
#[derive(Debug, Clone, PartialEq)]
struct Recipe {
    tolerances: Tolerances,
    /// Numbers of a departure that vary.
    varied: Vec<usize>,
    steps: Vec<f64>,
    /// First surge frequency over that of the model, from and to.
    coil: [f64; 2],
}

/// The first so many numbers of a departure move frequencies: not those of rest length and initial tension.
const MOVING: usize = 7;
/// How many are drawn for a verdict, and for a column of a sweep: a share of them is then known to about a percentage point.
pub(super) const MANY: usize = 2048;
/// How many are drawn for what would be so within the usual tolerance, where only the rms is wanted.
pub(super) const SOME: usize = 256;

impl Specimen {
    fn new(departure: Departure, coil: f64) -> Self {
        let specimen = Self { departure, coil, change: [0.0; 2] };
        Self { change: [departure.stiffness.ln(), specimen.frequency().ln()], ..specimen }
    }

    /// How far its surge frequencies are shifted, as a factor.
    pub fn frequency(&self) -> f64 {
        (self.departure.stiffness / self.departure.mass).sqrt() * self.coil
    }
}

impl Specimens {
    /// Of a spring within tolerances: points of an additive recurrence, which fill the box evenly in every number that varies.
    ///
    /// x_i = frac(½ + i/φ^k), k = 1…d, φ^(d+1) = φ + 1
    ///
    /// Source:   the generalised golden ratio, a Kronecker sequence; `[Niederreiter1992]` for its discrepancy.
    /// Valid:    up to some ten numbers.
    /// Accuracy: mean squares of smooth responses to 0.1 % from 256 points.
    pub fn of(spring: &SpringSpec, tolerances: &Tolerances, count: usize) -> Self {
        let (lowest, highest) = spring.first_frequency_band();
        let of_model = spring.spring.chain_frequency();
        let varied = varied(tolerances);
        let steps = steps(varied.len() + 1);
        let coil = [lowest / of_model, highest / of_model];
        let recipe = Recipe { tolerances: *tolerances, varied, steps, coil };
        Self { each: (0..count).map(|index| recipe.specimen(index)).collect(), recipe: Some(recipe) }
    }

    /// Those that come after the ones at hand, until there are `count`.
    pub fn more(&self, count: usize) -> impl Iterator<Item = Specimen> {
        let recipe = self.recipe.as_ref();
        (self.each.len()..count).filter_map(move |index| Some(recipe?.specimen(index)))
    }

    /// Those in the corners of the box, as far as they move frequencies: no specimen lies further out.
    pub fn corners(&self) -> Vec<Specimen> {
        self.recipe.as_ref().map_or_else(Vec::new, Recipe::corners)
    }

    /// The same springs as if each were the chain that the model is.
    pub fn as_chains(&self) -> Self {
        let each = self.each.iter().map(|specimen| Specimen::new(specimen.departure, 1.0)).collect();
        let recipe = self.recipe.clone().map(|recipe| Recipe { coil: [1.0; 2], ..recipe });
        Self { each, recipe }
    }
}

impl Recipe {
    fn corners(&self) -> Vec<Specimen> {
        let moving: Vec<usize> = self.varied.iter().copied().filter(|dimension| *dimension < MOVING).collect();
        let corner = |number: usize| {
            let mut units = [0.0; TOLERANCE_DIMENSIONS];
            let side = |bit: usize| if number >> bit & 1 == 0 { -1.0 } else { 1.0 };
            moving.iter().enumerate().for_each(|(bit, dimension)| units[*dimension] = side(bit));
            let coil = self.coil[number >> moving.len() & 1];
            Specimen::new(self.tolerances.at(&units), coil)
        };
        (0..2 << moving.len()).map(corner).collect()
    }

    fn specimen(&self, index: usize) -> Specimen {
        let unit = |step: f64| 2.0 * (0.5 + index as f64 * step).fract() - 1.0;
        let mut units = [0.0; TOLERANCE_DIMENSIONS];
        let each = self.varied.iter().zip(&self.steps[1..]);
        each.for_each(|(dimension, step)| units[*dimension] = unit(*step));
        let [lowest, highest] = self.coil;
        let coil = lowest + 0.5 * (1.0 + unit(self.steps[0])) * (highest - lowest);
        Specimen::new(self.tolerances.at(&units), coil)
    }
}

/// The springs over which sensors are judged.
#[derive(Debug, Clone)]
pub(super) struct Springs {
    /// As tolerances allow them.
    pub specimens: Specimens,
    /// The same as if each were the chain that the model is, where its line is wanted.
    pub as_chains: Option<Specimens>,
    /// Whether shares and the worst of them are wanted.
    pub one_by_one: bool,
}

impl Springs {
    /// Of a spec, within other tolerances than its own where they are given.
    pub fn of(spec: &Spec, tolerances: &Tolerances, count: usize) -> Self {
        let specimens = Specimens::of(&spec.spring, tolerances, count);
        Self { as_chains: None, specimens, one_by_one: false }
    }

    /// The same, each of them looked at.
    pub fn one_by_one(self) -> Self {
        Self { as_chains: Some(self.specimens.as_chains()), one_by_one: true, ..self }
    }
}

/// Numbers of a departure that vary.
fn varied(tolerances: &Tolerances) -> Vec<usize> {
    let given = |share: Option<f64>| share.unwrap_or(0.0);
    let mut widths = [0.0; TOLERANCE_DIMENSIONS];
    (widths[0], widths[1]) = (given(tolerances.stiffness), given(tolerances.mass));
    widths[2..7].copy_from_slice(&tolerances.geometry);
    (widths[7], widths[8]) = (tolerances.rest_length, tolerances.initial_tension);
    (0..TOLERANCE_DIMENSIONS).filter(|dimension| widths[*dimension] > 0.0).collect()
}

/// Steps of the recurrence in so many numbers.
fn steps(dimensions: usize) -> Vec<f64> {
    // The root of φ^(d+1) = φ + 1 by fixed-point iteration, which contracts by more than a half.
    let ratio = (0..64).fold(1.5_f64, |ratio, _| (1.0 + ratio).powf(1.0 / (dimensions as f64 + 1.0)));
    (1..=dimensions).map(|power| ratio.powi(-(power as i32))).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_longer_series_goes_on_as_it_began() {
        let recipe = Recipe {
            tolerances: Tolerances { stiffness: Some(0.1), ..Tolerances::default() },
            varied: vec![0],
            steps: steps(2),
            coil: [0.9, 1.0],
        };
        let of = |count: usize| Specimens {
            each: (0..count).map(|index| recipe.specimen(index)).collect(),
            recipe: Some(recipe.clone()),
        };
        let all: Vec<Specimen> = of(5).each.iter().copied().chain(of(5).more(9)).collect();
        assert_eq!(all, of(9).each);
        assert!(of(5).as_chains().more(9).all(|specimen| specimen.coil == 1.0));
    }

    #[test]
    fn the_recurrence_fills_every_interval_alike() {
        for dimensions in [1, 2, 5] {
            for step in steps(dimensions) {
                let inside = (0..1000).filter(|index| (0.5 + *index as f64 * step).fract() < 0.3).count();
                // A sequence of bounded discrepancy: some log(n)/n off, where chance would be ±15.
                assert!(inside.abs_diff(300) <= 4, "{dimensions} {step}: {inside}");
            }
        }
    }
}
