//! A coil of magnetic wire over a range of lengths: rings, the current along it, a radius that shrinks as it is stretched.
//!
//! Next door: the rings at one length (`susceptible`), the current along (`leads`), permeability and a constant from measured points (`crate::calibrate`).

use std::f64::consts::TAU;

use super::grid::{Grid, Polynomial};
use super::leads::Leads;
use super::surface::Row;
use super::susceptible::Susceptible;
use super::{LEAST_PITCH, MOST_TURNS, check_permeability, disc::Disc};
use crate::error::{Error, above_zero, check};
use crate::inductance::coil::Coil;

/// A coil of magnetic wire at every length of a range and for every permeability, at hand.
///
/// L = (1 − f) L_n + f L_(n+1) + L_along
///
/// with n = ⌊N⌋, f = N − n, L_n of [`super::PermeableRings`] with the pitch l/N and the radius r that leaves the wire its length:
/// 2πNr = √((2πNr₀)² + l₀² − l²). L_along is [`super::inductance_along`]'s.
///
/// The rings are solved at seven lengths (Chebyshev's points in 1/l), between which L is the polynomial in 1/l through them.
///
/// Source:   bound currents as [`super::PermeableRings`]; the rest as `[Grover1946]` and, of turns between whole numbers, `[Vlasblom2015]`.
/// Valid:    as [`super::PermeableRings`]: stainless wire to some 10 kHz, pitch from 1.04 wire diameters on; ends that do not turn.
/// Accuracy: from 1.05 to 1.6 wire diameters the polynomial is off by 1e-6 for μ_r up to 2, 3e-5 at 5, 3e-4 at 20 (tests); the rings as
///           [`super::PermeableRings`].
///
/// ```
/// use coilsense::inductance::theories::Coil;
/// use coilsense::inductance::{Leads, SteelCoil};
/// let coil = Coil::new(41.904, 8.47e-3, 1.41e-3)?; // measured where it is 118.17 mm long
/// let steel = SteelCoil::new(&coil, 0.11817, Leads::Open, [0.125, 0.178])?;
/// let microhenry = 1e6 * steel.of(2.08)?.inductance(0.1434);
/// assert!((3.3..3.6).contains(&microhenry), "{microhenry}");
/// # Ok::<(), coilsense::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct SteelCoil {
    coil: Coil,
    measured_at: f64,
    shape: Shape,
    leads: Leads,
    /// Shortest and longest \[m\].
    range: [f64; 2],
    grid: Grid,
    /// The rings at its lengths.
    turns: Vec<Turns>,
}

/// The same for one permeability.
#[derive(Debug, Clone, PartialEq)]
pub struct SteelCurve {
    shape: Shape,
    leads: Leads,
    range: [f64; 2],
    /// L of the rings \[H\].
    rings: Polynomial,
}

/// Lengths at which the rings are solved.
const NODES: usize = 7;
/// The same where a hundredth of the difference between two coils matters.
const FEW_NODES: usize = 3;
/// Shares of a length and of a radius by which two coils differ whose difference is taken for a derivative.
const STEP: f64 = 1e-4;
const WIDER: f64 = 2e-3;
/// The least permeability that a fit may go to: below 1 nothing is, but noise about 1 has two sides.
pub(crate) const LEAST_FITTED: f64 = 0.5;

/// A coil that keeps its windings and the length of its wire.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Shape {
    windings: f64,
    wire_radius: f64,
    /// Of the length of the wire \[m²\].
    wire_squared: f64,
}

impl Shape {
    fn new(coil: &Coil, measured_at: f64) -> Result<Self, Error> {
        above_zero("measured_at", measured_at, "m")?;
        let round = TAU * coil.windings() * coil.coil_radius();
        let wire_squared = round * round + measured_at * measured_at;
        Ok(Self { windings: coil.windings(), wire_radius: coil.wire_radius(), wire_squared })
    }

    fn coil_radius(&self, length: f64) -> f64 {
        (self.wire_squared - length * length).sqrt() / (TAU * self.windings)
    }

    /// Refuses what the rings do not hold for; `pitch`: the least, in wire diameters.
    fn holds_at(&self, length: f64, pitch: f64) -> Result<(), Error> {
        // Rounding of a length that was itself computed from the pitch.
        let least = pitch * 2.0 * self.wire_radius * self.windings * (1.0 - 1e-12);
        let allowed = format!("at least {least:.6} m, {pitch} wire diameters a winding (nearer turns touch and short)");
        check(length.is_finite() && length >= least, "length", length, "m", allowed)?;
        let open = self.coil_radius(length) > self.wire_radius;
        check(open, "length", length, "m", "below that at which the wire is stretched straight").map(|_| ())
    }
}

/// The rings of one length.
#[derive(Debug, Clone, PartialEq)]
struct Turns {
    whole: Susceptible,
    /// One more.
    more: Susceptible,
}

impl Turns {
    fn new(shape: &Shape, length: f64) -> Self {
        let disc = Disc::new(shape.coil_radius(length), shape.wire_radius, length / shape.windings);
        let whole = shape.windings as usize;
        let row = Row::new(&disc, whole + 1);
        Self { whole: Susceptible::new(&row, whole), more: Susceptible::new(&row, whole + 1) }
    }

    /// L of the whole turns, and how much more it is with one more \[H\].
    fn inductances(&self, permeability: f64) -> [f64; 2] {
        let whole = self.whole.inductance(permeability);
        [whole, self.more.inductance(permeability) - whole]
    }
}

/// By how much L of the rings changes with what is taken for granted.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct Changes {
    /// L \[H\] for each change of 1 of ln N, ln r and ln a; nothing where it was not asked for.
    by: [Polynomial; 3],
}

impl Changes {
    /// \[H\] at a length \[m\].
    pub fn at(&self, length: f64) -> [f64; 3] {
        self.by.each_ref().map(|polynomial| polynomial.at(1.0 / length))
    }
}

/// Lengths of a range between which quantities are polynomials in 1/l.
fn by_inverse_length([shortest, longest]: [f64; 2], count: usize) -> Grid {
    Grid::new([1.0 / longest, 1.0 / shortest], count)
}

/// The lengths \[m\] of such a grid.
fn lengths(grid: &Grid) -> Vec<f64> {
    grid.places().into_iter().map(f64::recip).collect()
}

/// What becomes of each place, in their order; a row takes some 20 ms.
pub(super) fn on_all_cores<T: Send>(places: Vec<f64>, solve: impl Fn(f64) -> T + Sync) -> Vec<T> {
    // A browser has no threads to give.
    let cores =
        if cfg!(target_family = "wasm") { 1 } else { std::thread::available_parallelism().map_or(1, usize::from) };
    if cores == 1 {
        return places.into_iter().map(solve).collect();
    }
    let solve = &solve;
    let of_chunk = |chunk: Vec<f64>| move || chunk.into_iter().map(solve).collect::<Vec<T>>();
    std::thread::scope(|scope| {
        let chunks = places.chunks(places.len().div_ceil(cores)).map(|chunk| scope.spawn(of_chunk(chunk.to_vec())));
        let running: Vec<_> = chunks.collect();
        running
            .into_iter()
            .flat_map(|thread| thread.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic)))
            .collect()
    })
}

/// Refuses a coil of more windings than are solved at once.
fn few_enough(coil: &Coil) -> Result<(), Error> {
    let allowed = format!("from 1 to {}", MOST_TURNS - 1);
    check(coil.windings() <= (MOST_TURNS - 1) as f64, "windings", coil.windings(), "", allowed).map(|_| ())
}

impl SteelCoil {
    /// - `coil`: of at most 149 windings, its radius as it is at the length `measured_at` \[m\]
    /// - `range`: the shortest and the longest length in use \[m\]
    ///
    /// # Errors
    /// [`Error::Value`] for a length at which windings are nearer than 1.04 wire diameters or the wire is straight, a range that is none, too
    /// many windings, and leads inside the coil.
    pub fn new(coil: &Coil, measured_at: f64, leads: Leads, range: [f64; 2]) -> Result<Self, Error> {
        Self::from_pitch(coil, measured_at, leads, range, LEAST_PITCH)
    }

    /// The same from another pitch on, in wire diameters. Nearer than those of [`Self::new`] the points on an edge tell less: over S_A's range, from 1.025 on, what
    /// eq. (13) leaves is 0.3 % more than by finite elements.
    pub(crate) fn from_pitch(
        coil: &Coil,
        measured_at: f64,
        leads: Leads,
        range: [f64; 2],
        pitch: f64,
    ) -> Result<Self, Error> {
        few_enough(coil)?;
        leads.outside(coil.coil_radius())?;
        let shape = Shape::new(coil, measured_at)?;
        let [shortest, longest] = range;
        shape.holds_at(shortest, pitch)?;
        shape.holds_at(longest, pitch)?;
        check(longest > shortest, "longest length", longest, "m", format!("above the shortest, {shortest} m"))?;
        let grid = by_inverse_length(range, NODES);
        let turns = on_all_cores(lengths(&grid), |length| Turns::new(&shape, length));
        Ok(Self { coil: *coil, measured_at, shape, leads, range, grid, turns })
    }

    /// The coil.
    pub fn coil(&self) -> &Coil {
        &self.coil
    }

    /// The length at which its radius was measured \[m\].
    pub fn measured_at(&self) -> f64 {
        self.measured_at
    }

    /// Radius of the coil \[m\] at a length \[m\], which leaves its wire as long as it is.
    pub fn coil_radius(&self, length: f64) -> f64 {
        self.shape.coil_radius(length)
    }

    /// The shortest and the longest length \[m\].
    pub fn range(&self) -> [f64; 2] {
        self.range
    }

    /// L over length for one permeability of the wire, 1 to 20.
    ///
    /// # Errors
    /// [`Error::Value`] for another.
    pub fn of(&self, permeability: f64) -> Result<SteelCurve, Error> {
        check_permeability(permeability)?;
        Ok(self.fitted(permeability))
    }

    /// The same for what a fit may come by.
    pub(crate) fn fitted(&self, permeability: f64) -> SteelCurve {
        let share = self.shape.windings.fract();
        let [whole, more] = self.inductances(permeability);
        let values: Vec<f64> = whole.iter().zip(&more).map(|(whole, more)| whole + share * more).collect();
        SteelCurve { shape: self.shape, leads: self.leads, range: self.range, rings: self.grid.through(&values) }
    }

    /// Of whole turns at the lengths, and how much more it is with one more.
    fn inductances(&self, permeability: f64) -> [Vec<f64>; 2] {
        let each: Vec<[f64; 2]> = self.turns.iter().map(|turns| turns.inductances(permeability)).collect();
        [0, 1].map(|which| each.iter().map(|pair| pair[which]).collect())
    }

    /// How its rings depend on windings, radius and wire.
    ///
    /// By windings from one more turn at the same pitch; by radius from another row; by the wire's, as L of a coil that is larger in all grows with it:
    /// L = r ∂L/∂r + a ∂L/∂a + l ∂L/∂l.
    pub(crate) fn changes(&self, permeability: f64) -> Changes {
        let Shape { windings, wire_radius, .. } = self.shape;
        let [of_whole, of_more] = self.inductances(permeability).map(|values| self.grid.through(&values));
        let rings = self.fitted(permeability).rings;
        let whole = windings as usize;
        let changed = |length: f64| {
            let [before, here, after] = [1.0 - STEP, 1.0, 1.0 + STEP].map(|times| rings.at(1.0 / (times * length)));
            let by_length = (after - before) / (2.0 * STEP);
            let by_windings = windings * of_more.at(1.0 / length) - by_length;
            let disc = Disc::new((1.0 + WIDER) * self.shape.coil_radius(length), wire_radius, length / windings);
            let wider = Susceptible::new(&Row::new(&disc, whole), whole).inductance(permeability);
            let by_radius = (wider / of_whole.at(1.0 / length)).ln() / WIDER * here;
            [by_windings, by_radius, here - by_radius - by_length]
        };
        let few = by_inverse_length(self.range, FEW_NODES);
        let changes = on_all_cores(lengths(&few), changed);
        let of = |which: usize| few.through(&changes.iter().map(|change| change[which]).collect::<Vec<f64>>());
        Changes { by: [of(0), of(1), of(2)] }
    }

    /// L \[H\] at one length \[m\] and one permeability, solved there.
    ///
    /// # Errors
    /// As [`Self::new`] and [`Self::of`].
    pub fn at_length(
        coil: &Coil,
        measured_at: f64,
        leads: Leads,
        permeability: f64,
        length: f64,
    ) -> Result<f64, Error> {
        check_permeability(permeability)?;
        few_enough(coil)?;
        leads.outside(coil.coil_radius())?;
        let shape = Shape::new(coil, measured_at)?;
        shape.holds_at(length, LEAST_PITCH)?;
        let [whole, more] = Turns::new(&shape, length).inductances(permeability);
        Ok(whole + shape.windings.fract() * more + leads.along(length, shape.coil_radius(length)))
    }
}

impl SteelCurve {
    /// The shortest and the longest length \[m\].
    pub fn range(&self) -> [f64; 2] {
        self.range
    }

    /// How much more L is at a length with other leads \[H\].
    pub(crate) fn by_leads(&self, length: f64, other: Leads) -> f64 {
        let radius = self.shape.coil_radius(length);
        other.along(length, radius) - self.leads.along(length, radius)
    }

    /// L \[H\] at a length \[m\]; NaN outside of the range.
    pub fn inductance(&self, length: f64) -> f64 {
        let [shortest, longest] = self.range;
        if !(shortest..=longest).contains(&length) {
            return f64::NAN;
        }
        self.rings.at(1.0 / length) + self.leads.along(length, self.shape.coil_radius(length))
    }
}
