//! The lines of the modes against length, as a chart shows them: curves by kind, and bands where the ends lie between two ways.
//!
//! Next door: all that is known of the modes at one length (`modes`), who draws them (`report`, the page).

use coilsense::Error;
use coilsense::helix::{Helix, Kind, Modes};

use super::held::Held;
use super::modes::{Coil, is_standing, kind_name};

/// Lines over lengths, up to a frequency.
#[derive(Debug, Clone, PartialEq)]
pub struct Lines {
    /// The lengths \[m\], from the shortest to the longest in use.
    pub lengths: Vec<f64>,
    /// Up to where there are lines \[Hz\]: so many times the first surge as `REACH` says.
    pub top: f64,
    /// The ends as they are held, and as loose as they may be where that lies between two ways.
    pub ways: Vec<WayLines>,
    /// Between the two ways; none where there is one.
    pub bands: Vec<BandOfKind>,
}

/// Lines with the ends held in one way.
#[derive(Debug, Clone, PartialEq)]
pub struct WayLines {
    /// How the ends are held.
    pub ends: String,
    /// At which of the lengths the spring has buckled: there are no lines there.
    pub buckles: Vec<bool>,
    /// The curves, those of a mode beside each other.
    pub curves: Vec<CurveOfKind>,
}

/// The n-th frequency of all where it is of one kind, and on to the next length.
#[derive(Debug, Clone, PartialEq)]
pub struct CurveOfKind {
    /// Number of the mode, from 1.
    pub number: usize,
    /// `axial`, `torsional`, `lateral` or `mixed`.
    pub kind: &'static str,
    /// Its frequency at each length \[Hz\]; not a number where there is none.
    pub frequency: Vec<f64>,
}

/// How far the n-th line of a kind moves from one way of the ends to the other; of lateral pairs, the first of each.
#[derive(Debug, Clone, PartialEq)]
pub struct BandOfKind {
    /// `axial`, `torsional` or `lateral`.
    pub kind: &'static str,
    /// Lowest at each length \[Hz\]; not a number where there is none.
    pub lower: Vec<f64>,
    /// Highest at each length \[Hz\]; not a number where there is none.
    pub upper: Vec<f64>,
}

/// Lines are followed up to so many times the first surge.
pub const REACH: f64 = 2.4;
/// Lengths from one at which kinds are looked at to the next. Where they are alike at both, they are so between: lines that meet change places.
const STEP: usize = 8;
/// Most modes that are followed.
const MOST: usize = 60;

/// What swings at one length.
struct Spot {
    modes: Modes,
    /// How many modes there are up to the top, those that do not swing among them.
    count: usize,
    /// Frequencies of what swings \[Hz\].
    frequencies: Vec<f64>,
    /// Their kinds, once looked at.
    kinds: Vec<Kind>,
    buckles: bool,
}

impl Coil {
    /// Its lines at `count` lengths evenly spread over those in use, at least two.
    ///
    /// # Errors
    /// As [`Coil::over_lengths`].
    pub fn lines(&self, count: usize) -> Result<Lines, Error> {
        let lengths = self.lengths(count);
        let top = REACH * self.first_surges()?.1;
        let mut ways = vec![&self.ways.0];
        ways.extend(&self.ways.1);
        let (mut told, mut spots) = (Vec::new(), Vec::new());
        for way in ways {
            let of_way = self.spots(way, &lengths, top)?;
            let buckles = of_way.iter().map(|spot| spot.buckles).collect();
            told.push(WayLines { ends: way.words(), buckles, curves: curves(&of_way) });
            spots.push(of_way);
        }
        let bands = match spots.as_slice() {
            [tight, loose] => bands(tight, loose),
            _ => Vec::new(),
        };
        Ok(Lines { ways: told, bands, lengths, top })
    }

    fn spots(&self, way: &Held, lengths: &[f64], top: f64) -> Result<Vec<Spot>, Error> {
        let mut spots = Vec::with_capacity(lengths.len());
        for length in lengths {
            spots.push(self.spot(way, *length, top)?);
        }
        let last = spots.len() - 1;
        let mut at = 0;
        spots[0].look()?;
        while at < last {
            let next = (at + STEP).min(last);
            spots[next].look()?;
            let alike = spots[at].kinds.iter().zip(&spots[next].kinds).all(|(one, other)| one == other);
            let known = if spots[at].kinds.len() >= spots[next].kinds.len() { at } else { next };
            let kinds = spots[known].kinds.clone();
            for spot in &mut spots[at + 1..next] {
                if alike && spot.frequencies.len() <= kinds.len() {
                    spot.kinds = kinds[..spot.frequencies.len()].to_vec();
                } else {
                    spot.look()?;
                }
            }
            at = next;
        }
        Ok(spots)
    }

    fn spot(&self, way: &Held, length: f64, top: f64) -> Result<Spot, Error> {
        let helix = Helix::new(&self.rod, length - self.dead_length, way.turning())?;
        let modes = Modes::new(&helix, way.ends())?;
        let count = modes.count_below(top)?.min(MOST);
        let mut frequencies = if count > 0 { modes.frequencies(count)? } else { Vec::new() };
        frequencies.retain(|hertz| *hertz > 0.0);
        let buckles = is_standing(&modes, &self.rod, way)?;
        Ok(Spot { modes, count, frequencies, kinds: Vec::new(), buckles })
    }
}

impl Spot {
    /// Finds the kinds.
    fn look(&mut self) -> Result<(), Error> {
        if self.count > 0 {
            self.kinds = self.modes.lowest(self.count)?.iter().map(|mode| mode.kind()).collect();
        }
        Ok(())
    }

    /// A mode's frequency and kind, by its number from 0; none of a spring that has buckled.
    fn line(&self, index: usize) -> Option<(f64, Kind)> {
        let line = self.frequencies.get(index).copied().zip(self.kinds.get(index).copied());
        line.filter(|_| !self.buckles)
    }

    /// Frequencies of a kind; of lateral pairs the first.
    fn of_kind(&self, kind: Kind) -> Vec<f64> {
        let mut found = Vec::new();
        let mut is_second = false;
        for index in 0..self.frequencies.len() {
            let Some((hertz, _)) = self.line(index).filter(|(_, of)| *of == kind) else { continue };
            if !is_second {
                found.push(hertz);
            }
            is_second = kind == Kind::Lateral && !is_second;
        }
        found
    }
}

// Loops in place of chains of iterators: a page loads this, and it is half as large.

fn curves(spots: &[Spot]) -> Vec<CurveOfKind> {
    let most = spots.iter().map(|spot| spot.frequencies.len()).max().unwrap_or(0);
    let mut found = Vec::new();
    for index in 0..most {
        for kind in [Kind::Axial, Kind::Torsional, Kind::Lateral, Kind::Mixed] {
            let mut frequency = vec![f64::NAN; spots.len()];
            let (mut was, mut any) = (false, false);
            for (at, spot) in spots.iter().enumerate() {
                let line = spot.line(index);
                let is = line.is_some_and(|(_, of)| of == kind);
                if is || was {
                    frequency[at] = line.map_or(f64::NAN, |(hertz, _)| hertz);
                }
                (was, any) = (is, any || is);
            }
            if any {
                found.push(CurveOfKind { number: index + 1, kind: kind_name(kind), frequency });
            }
        }
    }
    found
}

fn bands(tight: &[Spot], loose: &[Spot]) -> Vec<BandOfKind> {
    let mut found: Vec<BandOfKind> = Vec::new();
    for kind in [Kind::Axial, Kind::Torsional, Kind::Lateral] {
        let first = found.len();
        for (at, (one, other)) in tight.iter().zip(loose).enumerate() {
            for (order, (a, b)) in one.of_kind(kind).into_iter().zip(other.of_kind(kind)).enumerate() {
                if found.len() <= first + order {
                    let none = vec![f64::NAN; tight.len()];
                    found.push(BandOfKind { kind: kind_name(kind), lower: none.clone(), upper: none });
                }
                let band = &mut found[first + order];
                (band.lower[at], band.upper[at]) = (a.min(b), a.max(b));
            }
        }
    }
    found
}
