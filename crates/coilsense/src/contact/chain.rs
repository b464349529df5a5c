//! A chain of lumps whose segments close: masses, stiffnesses and gaps, all of which may differ.
//!
//! Next door: what a contact does (`law`), what damps the lumps (`damper`), how the ends move (`drive`).

use crate::error::{Error, above_zero, check, count, entry};
use crate::modes::ModalModel;
use crate::mount::FarEnd;
use crate::sections::{Lumps, Sections};
use crate::spring::Spring;

/// Lumps between two ends. Segment j lies before lump j + 1: segment 0 between end 1 and the first lump, the last one at end 2. Points are
/// counted from end 1, which is 0; lump i is point i.
#[derive(Debug, Clone, PartialEq)]
pub struct Chain {
    masses: Vec<f64>,
    inverse: Vec<f64>,
    stiffnesses: Vec<f64>,
    pairs: Vec<Pair>,
    shares: Vec<f64>,
    /// Of all segments in series \[N/m\].
    stiffness: f64,
    /// Compliance beyond the last lump where end 2 is under a force \[m/N\].
    beyond: f64,
    far_end: FarEnd,
    /// Whether the first lump is a follower, which end 0 pushes as a cam and which end 1 of the spring stands on.
    has_follower: bool,
    /// The follower, where more than one class of points meets it.
    shared: Option<usize>,
}

/// Two points that can meet. Pairs are in the order in which each begins where the one before it ends, as far as they do.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pair {
    /// The point nearer to end 1.
    pub first: usize,
    /// The one nearer to end 2.
    pub second: usize,
    /// How far they come nearer to each other from the unloaded spring until they meet \[m\].
    pub gap: f64,
}

/// A gap that rounding has made this much of a length \[1\] too small is none.
const ROUNDING: f64 = 1e-14;

impl Chain {
    /// A chain with both ends' positions prescribed.
    ///
    /// - `masses`: m_i \[kg\], shape `N`; `stiffnesses`: k_j \[N/m\], shape `N + 1`
    /// - `gaps`: g_j \[m\], shape `N + 1`: how far each segment can be pressed from its unloaded length until it touches; infinite for one
    ///   that never does
    ///
    /// # Errors
    /// [`Error::Count`] for lengths that do not go together; [`Error::Value`] for a mass or stiffness that is not above zero, and a gap that is
    /// below zero or no number.
    pub fn new(masses: Vec<f64>, stiffnesses: Vec<f64>, gaps: Vec<f64>) -> Result<Self, Error> {
        crate::error::at_least_one("masses", masses.len())?;
        count("stiffnesses", stiffnesses.len(), masses.len() + 1)?;
        count("gaps", gaps.len(), masses.len() + 1)?;
        for &mass in &masses {
            above_zero("mass", mass, "kg")?;
        }
        for &stiffness in &stiffnesses {
            above_zero("stiffness", stiffness, "N/m")?;
        }
        for (index, &gap) in gaps.iter().enumerate() {
            check(gap >= 0.0, entry("gaps", index), gap, "m", "zero, above zero, or infinite")?;
        }
        let pair = |(first, gap): (usize, f64)| Pair { first, second: first + 1, gap };
        let pairs = gaps.into_iter().enumerate().filter(|(_, gap)| gap.is_finite()).map(pair).collect();
        Ok(Self::trusted(masses, stiffnesses, pairs, FarEnd::Position))
    }

    pub(super) fn trusted(masses: Vec<f64>, mut stiffnesses: Vec<f64>, pairs: Vec<Pair>, far_end: FarEnd) -> Self {
        let inverse = std::iter::once(0.0).chain(masses.iter().map(|mass| 1.0 / mass)).chain([0.0]).collect();
        let whole: f64 = stiffnesses.iter().map(|stiffness| 1.0 / stiffness).sum();
        let so_far = stiffnesses.iter().scan(0.0, |sum, stiffness| {
            *sum += 1.0 / stiffness;
            Some(*sum / whole)
        });
        let mut shares: Vec<f64> = std::iter::once(0.0).chain(so_far).collect();
        shares[masses.len() + 1] = 1.0;
        let mut beyond = 0.0;
        if far_end != FarEnd::Position
            && let Some(last) = stiffnesses.last_mut()
        {
            (beyond, *last) = (1.0 / *last, 0.0);
        }
        Self {
            masses,
            inverse,
            stiffnesses,
            pairs,
            shares,
            stiffness: 1.0 / whole,
            beyond,
            far_end,
            has_follower: false,
            shared: None,
        }
    }

    /// The same with a mass at end 1 \[kg\] that a cam pushes and cannot pull: point 0 is the cam, point 1 the follower, on which the spring stands.
    ///
    /// # Errors
    /// [`Error::Value`] for a mass that is not above zero, and for a second follower.
    pub fn on_follower(mut self, mass: f64) -> Result<Self, Error> {
        above_zero("follower_mass", mass, "kg")?;
        check(!self.has_follower, "followers", 2.0, "", "at most one")?;
        self.shared = (self.pairs.iter().filter(|pair| pair.first == 0).count() > 1).then_some(1);
        for pair in &mut self.pairs {
            (pair.first, pair.second) = (pair.first + 1, pair.second + 1);
        }
        self.pairs.insert(0, Pair { first: 0, second: 1, gap: 0.0 });
        self.masses.insert(0, mass);
        self.inverse.insert(1, 1.0 / mass);
        self.stiffnesses.insert(0, 0.0);
        self.shares.insert(0, 0.0);
        self.has_follower = true;
        Ok(self)
    }

    /// The paper's chain of a spring on its mount, and where its windings touch: `contact_pitch` \[m\], centre to centre, as
    /// [`crate::measures::Clash::seen`] has it.
    ///
    /// N masses m/N, N k between them and 2 N k at the ends. A mass meets the one a turn further on, n masses at n masses per winding, where
    /// the pitch of the unloaded spring, l0 over its whole windings, is used up. `ends`: whether the first and the last winding meet their seats:
    /// a coil rises from its seat over its first turn, so that a point of that turn has as much of the pitch below it as of the turn before
    /// it, half of it at one mass per winding, and the turn rolls on its seat where there are more.
    ///
    /// # Errors
    /// [`Error::Value`] for a contact pitch that is not above zero, or above the pitch of the unloaded spring: its gap would be below zero;
    /// for `ends` with more than one mass per winding where end 2 is a mass: more than one point would lie on it.
    pub fn of(spring: &Spring, far_end: FarEnd, contact_pitch: f64, ends: bool) -> Result<Self, Error> {
        let gap = Self::gap(spring, far_end, contact_pitch, ends)?;
        let (lumps, apart) = (spring.chain_masses(), spring.masses_per_winding());
        if let Some(sections) = spring.sections() {
            return Ok(Self::of_sections(spring, sections, far_end, ends));
        }
        let stiffness = lumps as f64 * spring.stiffness();
        let masses = vec![spring.mass() / lumps as f64; lumps];
        let mut stiffnesses = vec![stiffness; lumps + 1];
        (stiffnesses[0], stiffnesses[lumps]) = (2.0 * stiffness, 2.0 * stiffness);
        let gap_of = |first: usize, second: usize| match (first, second) {
            (0, second) => gap * (second as f64 - 0.5) / apart as f64,
            (first, second) if second > lumps => gap * ((second - first) as f64 - 0.5) / apart as f64,
            _ => gap,
        };
        let pairs = pairs([lumps, apart], ends, far_end, gap_of);
        Ok(Self::with_far_end(masses, stiffnesses, pairs, far_end))
    }

    /// The same of a coil of sections: masses in the middle of equal stretches of the wire, each with the gaps that lie between it and the wire a turn
    /// further on.
    fn of_sections(spring: &Spring, sections: &Sections, far_end: FarEnd, ends: bool) -> Self {
        let [stiffer, heavier] = spring.scales(sections);
        let Lumps { masses, stiffnesses, windings } = sections.lumps(spring.masses_per_winding());
        let masses: Vec<f64> = masses.iter().map(|mass| heavier * mass).collect();
        let stiffnesses = stiffnesses.iter().map(|stiffness| stiffer * stiffness).collect();
        let gap = |first: usize, second: usize| sections.gap_between(windings[first], windings[second]);
        let pairs = pairs([masses.len(), spring.masses_per_winding()], ends, far_end, gap);
        Self::with_far_end(masses, stiffnesses, pairs, far_end)
    }

    fn with_far_end(mut masses: Vec<f64>, mut stiffnesses: Vec<f64>, pairs: Vec<Pair>, far_end: FarEnd) -> Self {
        if let FarEnd::Mass(mass) = far_end {
            masses.push(mass);
            // A stiffness that is not there: end 2 is the mass.
            stiffnesses.push(f64::INFINITY);
        }
        Self::trusted(masses, stiffnesses, pairs, far_end)
    }

    /// By how much the unloaded spring's pitch is above that of contact \[m\]: all that [`Self::of`] checks.
    ///
    /// # Errors
    /// Those of [`Self::of`].
    pub(super) fn gap(spring: &Spring, far_end: FarEnd, contact_pitch: f64, ends: bool) -> Result<f64, Error> {
        above_zero("contact_pitch", contact_pitch, "m")?;
        let apart = spring.masses_per_winding();
        let one = "one where windings meet their seats and end 2 is a mass";
        let is_one = apart == 1 || !matches!(far_end, FarEnd::Mass(_));
        check(!ends || is_one, "masses_per_winding", apart as f64, "", one)?;
        if spring.sections().is_some() {
            // Each pair has a gap of its own, none of which is below zero.
            return Ok(0.0);
        }
        let pitch = spring.rest_length() / spring.whole_windings() as f64;
        let slack = pitch - contact_pitch;
        if slack < -ROUNDING * pitch || slack.is_nan() {
            let allowed = format!(
                "at most the {pitch} m of the unloaded spring: windings that touch without force are not covered"
            );
            check(false, "contact_pitch", contact_pitch, "m", allowed)?;
        }
        Ok(slack.max(0.0))
    }

    /// N: how many lumps there are, an end mass and a follower among them.
    pub fn lumps(&self) -> usize {
        self.masses.len()
    }

    /// m_i \[kg\], shape `N`.
    pub fn masses(&self) -> &[f64] {
        &self.masses
    }

    /// k_j \[N/m\], shape `N + 1`; the last is zero where end 2 is under a force.
    pub fn stiffnesses(&self) -> &[f64] {
        &self.stiffnesses
    }

    /// Its modes, for a linear motion: [`crate::Motion::of_modes`] takes them.
    ///
    /// Source:   singular values of √K S M^(−1/2) by Sturm's count (`bidiagonal`).
    /// Valid:    any chain; N² numbers.
    /// Accuracy: 1e-13 of every frequency, the lowest of a thousand masses too (test).
    ///
    /// ```
    /// use coilsense::contact::Chain;
    /// // Two masses between three springs: √(k/m) and √(3k/m).
    /// let chain = Chain::new(vec![1.0; 2], vec![4.0; 3], vec![f64::INFINITY; 3])?;
    /// let modes = chain.modes()?;
    /// assert!((modes.frequencies()[0] - 2.0).abs() < 1e-14 && (modes.frequencies()[1] - 12_f64.sqrt()).abs() < 1e-14);
    /// # Ok::<(), coilsense::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Value`] for a chain of nothing but an end mass, and for one on a follower, which is no lump of the spring.
    pub fn modes(&self) -> Result<ModalModel, Error> {
        check(!self.has_follower, "followers", 1.0, "", "none: the modes are those of the spring without it")?;
        let inner = self.masses.len() - usize::from(matches!(self.far_end, FarEnd::Mass(_)));
        check(inner > 0, "lumps", inner as f64, "", "at least one beside the end mass")?;
        let mut stiffnesses = self.stiffnesses[..=inner].to_vec();
        if self.far_end == FarEnd::Force {
            stiffnesses[inner] = 1.0 / self.beyond;
        }
        let parameters = ModalModel::of_lumps(&self.masses[..inner], &stiffnesses, self.far_end);
        ModalModel::new(self.stiffness, parameters)
    }

    /// Points that can meet.
    pub fn pairs(&self) -> &[Pair] {
        &self.pairs
    }

    /// The first pair's points, where every pair is one point further than the one before.
    pub(super) fn neighbours(&self) -> Option<[usize; 2]> {
        let begin = self.pairs.first()?;
        let follows =
            |(index, pair): (usize, &Pair)| pair.first == begin.first + index && pair.second == begin.second + index;
        self.pairs.iter().enumerate().all(follows).then_some([begin.first, begin.second])
    }

    /// Of the whole chain at rest \[N/m\].
    pub fn stiffness(&self) -> f64 {
        self.stiffness
    }

    /// What end 2 is tied to.
    pub fn far_end(&self) -> FarEnd {
        self.far_end
    }

    /// 1/m_i, zero at the ends: shape `N + 2`.
    pub(super) fn inverse_masses(&self) -> &[f64] {
        &self.inverse
    }

    /// Which share of the ends' distance each point keeps while the spring moves slowly; shape `N + 2`.
    pub(super) fn shares(&self) -> &[f64] {
        &self.shares
    }

    /// Whether end 2's position is not prescribed.
    pub(super) fn is_open(&self) -> bool {
        self.far_end != FarEnd::Position
    }

    /// Compliance beyond the last lump where end 2 is under a force \[m/N\].
    pub(super) fn beyond(&self) -> f64 {
        self.beyond
    }

    /// The last segment that pulls at end 2, or at its mass.
    pub(super) fn last_segment(&self) -> usize {
        self.masses.len() - usize::from(self.is_open())
    }

    /// The point that is end 1 of the spring, which is also the number of its first segment.
    pub(super) fn base(&self) -> usize {
        usize::from(self.has_follower)
    }

    /// The pair of cam and follower.
    pub(super) fn cam(&self) -> Option<usize> {
        self.has_follower.then_some(0)
    }

    /// The one point that gives way and is in more than two pairs.
    pub(super) fn shared(&self) -> Option<usize> {
        self.shared
    }

    /// Points of the chain, both ends among them.
    pub(super) fn points(&self) -> usize {
        self.masses.len() + 2
    }
}

/// Pairs one turn apart, `apart` of `lumps` masses, class by class; with their seats where `ends` says so.
fn pairs([lumps, apart]: [usize; 2], ends: bool, far_end: FarEnd, gap: impl Fn(usize, usize) -> f64) -> Vec<Pair> {
    let pair = |first: usize, second: usize| Pair { first, second, gap: gap(first, second) };
    let mut pairs: Vec<Pair> = Vec::new();
    for class in 1..=apart.min(lumps) {
        let points: Vec<usize> = (class..=lumps).step_by(apart).collect();
        if ends {
            pairs.push(pair(0, class));
        }
        pairs.extend(points.windows(2).map(|points| pair(points[0], points[1])));
        if let Some(&last) = points.last().filter(|_| ends && far_end != FarEnd::Force) {
            pairs.push(pair(last, lumps + 1));
        }
    }
    pairs
}
