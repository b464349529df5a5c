//! Maxwell's summation: the inductance of windings wherever they are.
//!
//! Next door: the mutual inductance of one pair (`mutual`), the distance of a winding from itself (`self_term`).

use super::carry::Carry;
use super::coil::Coil;
use super::mutual::{MU_0, mutual_inductance};
use super::pairs;
use super::rings::Rings;
use super::self_term::SelfDistance;
use super::uniform;
use crate::spring::Spring;

/// The inductance of a spring by Maxwell's sum over its windings.
///
/// L = Σ_i Σ_j M(|x_i − x_j|) = N M(h_self) + 2 Σ_{i<j} M(|x_i − x_j|)
///
/// Fractional windings: N_L of them stand for round(N_L) turns at pitch l/N_L, centred on the coil and carried by the chain's
/// piecewise-linear displacement; the self term counts N_L times.
///
/// Source:   `[Weijde2017]` eqs. 8–11, `[Maxwell1873]` arts. 693 and 701; fractions as in the processing of `[Vlasblom2015]`.
/// Valid:    one layer of circular rings, of one radius but for a coil of sections; direct current, no core.
/// Accuracy: 2e-15 relative, against 40 digits.
///
/// ```
/// use coilsense::inductance::{MaxwellSum, SelfDistance};
/// # let spring = coilsense::paper::s_t();
/// let coil = MaxwellSum::new(&spring, SelfDistance::AsPrinted);
/// let microhenry = 1e6 * coil.at_length(0.23);
/// assert!((3.0..4.0).contains(&microhenry));
/// # Ok::<(), coilsense::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct MaxwellSum {
    coil_radius: f64,
    windings: f64,
    /// N_L M(h_self) \[H\].
    self_part: f64,
    /// Where the turns sit along the coil, 0 at end 1 and 1 at end 2.
    places: Vec<f64>,
    chain_masses: usize,
    /// Of a coil of sections, its turns as rings of different radii.
    rings: Option<Rings>,
}

impl MaxwellSum {
    /// The sum for a spring.
    pub fn new(spring: &Spring, self_distance: SelfDistance) -> Self {
        let own = self_distance.of_wire(spring.wire_radius());
        let even = Self::with_chain(spring.inductance_windings(), spring.coil_radius(), own, spring.chain_masses());
        match Rings::of(spring, &even.places, self_distance) {
            Some(rings) => {
                let self_part = even.windings * rings.own();
                Self { self_part, rings: Some(rings), ..even }
            }
            None => even,
        }
    }

    /// The sum for a coil by itself: a chain of as many masses as turns.
    pub fn of_coil(coil: &Coil, self_distance: SelfDistance) -> Self {
        let own = self_distance.of_wire(coil.wire_radius());
        Self::with_chain(coil.windings(), coil.coil_radius(), own, coil.windings().round() as usize)
    }

    fn with_chain(windings: f64, coil_radius: f64, own: f64, chain_masses: usize) -> Self {
        let turns = windings.round().max(1.0);
        Self {
            coil_radius,
            windings,
            self_part: windings * mutual_inductance(coil_radius, own),
            places: (0..turns as usize).map(|index| 0.5 + (index as f64 - 0.5 * (turns - 1.0)) / windings).collect(),
            chain_masses,
            rings: None,
        }
    }

    /// L \[H\] of windings spread uniformly over a length \[m\]; of a coil of sections as it lies at rest at that length.
    pub fn at_length(&self, length: f64) -> f64 {
        self.at_lengths(&[length])[0]
    }

    /// The same for many lengths at once, shape `lengths`.
    pub fn at_lengths(&self, lengths: &[f64]) -> Vec<f64> {
        if let Some(rings) = self.rings() {
            return lengths.iter().map(|length| self.of_turns(&rings.at_rest(*length))).collect();
        }
        let pitches: Vec<f64> = lengths.iter().map(|length| length / self.windings).collect();
        // Uniform windings repeat each distance: Σ_{i<j} is a sum over N − 1 distances.
        let pairs = uniform::sums(self.places.len(), self.coil_radius, &pitches);
        pairs.into_iter().map(|sum| self.self_part + 4.0 * MU_0 * self.coil_radius * sum).collect()
    }

    /// L \[H\] of turns at given positions \[m\], in any order, one per turn of the coil (round(N_L)).
    ///
    /// # Errors
    /// [`crate::Error::Count`] for another number of turns; [`crate::Error::Value`] for the first position that is not finite.
    pub fn at_positions(&self, positions: &[f64]) -> Result<f64, crate::Error> {
        crate::error::count("positions", positions.len(), self.places.len())?;
        crate::error::all_finite("positions", positions, "m")?;
        Ok(self.of_turns(positions))
    }

    /// Whether its turns are rings of one radius, evenly wound.
    pub(super) fn is_even(&self) -> bool {
        self.rings().is_none()
    }

    #[inline]
    fn rings(&self) -> Option<&Rings> {
        if cfg!(feature = "sections") { self.rings.as_ref() } else { None }
    }

    /// Refuses a coil of sections, for what is of an even one.
    pub(super) fn check_even(&self) -> Result<(), crate::error::Error> {
        let allowed = "one radius and one pitch: a coil of sections has its inductance by positions only";
        crate::error::check(self.is_even(), "radii of the coil", self.coil_radius, "m", allowed).map(|_| ())
    }

    /// r \[m\].
    pub(super) fn coil_radius(&self) -> f64 {
        self.coil_radius
    }

    /// N_L M(h_self) \[H\].
    pub(super) fn self_part(&self) -> f64 {
        self.self_part
    }

    /// N of the spring's chain.
    pub(super) fn chain_masses(&self) -> usize {
        self.chain_masses
    }

    /// N_L.
    pub(super) fn windings(&self) -> f64 {
        self.windings
    }

    /// Where the turns sit along the coil, 0 at end 1 and 1 at end 2.
    pub(super) fn places(&self) -> &[f64] {
        &self.places
    }

    /// How a chain of so many masses carries the turns.
    pub(super) fn carry(&self, masses: usize) -> Carry {
        Carry::new(&self.places, masses, self.windings == masses as f64)
    }

    /// Which nodes of a chain of so many masses carry each turn, with their weights: end 1, the masses, end 2.
    pub(crate) fn carriers(&self, masses: usize) -> Vec<[(usize, f64); 2]> {
        let carry = self.carry(masses);
        (0..self.places.len()).map(|turn| carry.of_turn(turn)).collect()
    }

    /// N_L, as [`Self::at_length`] divides a length by it.
    pub(crate) fn turns(&self) -> f64 {
        self.windings
    }

    pub(super) fn of_turns(&self, turns: &[f64]) -> f64 {
        if let Some(rings) = self.rings() {
            return self.self_part + 2.0 * rings.pairs(turns);
        }
        // Twice 2 μ₀ r: each pair counts in both orders.
        self.self_part + 4.0 * MU_0 * self.coil_radius * pairs::sum(self.coil_radius, turns)
    }
}
