//! Satellites: lines of the coil that are no axial modes, by where they lie beside those: its torsion, and its sideways (lateral) motion.
//!
//! They are named once the axial modes are sure and take no part in what f1, the mount and the verdict rest on. Next door: how the weak ones
//! are heard (`weak_lines`), every mode of a coil with its strength in the axial force (`crate::helix`).

use super::explain::Coil;
use super::line::{Line, Meaning};
use super::mode_series::ModeSeries;

/// Torsional over axial frequency of the same number: √(E/2G) is 1.12 to 1.14, short springs reach 1.17, and their higher modes more (`[0]` is
/// j = 1). Of `helix`: 1.124 to 1.168 at j = 1 and 1.124 to 1.188 at j = 2, for six springs from 3 to 52 windings.
const TORSION: [(f64, f64); 3] = [(1.11, 1.18), (1.105, 1.19), (1.1, 1.2)];
/// Higher modes, up to this one, are torsional where they lie where a lower one's ratio puts them \[1, relative\].
const HIGHEST: usize = 6;
const SAME_RATIO: f64 = 0.007;
/// Strength in the axial force over that of the axial line of the same number \[1\]: 0.04 to 9 % by `helix`.
const SHARE: (f64, f64) = (1e-3, 0.1);
/// Quarter and three quarter waves of torsion where an end may turn (a swivel), over f1.
const QUARTER: (f64, f64) = (0.55, 0.6);
const THREE_QUARTERS: (f64, f64) = (1.65, 1.76);
/// How far these are from 1 : 3, at most \[1\].
const OFF_THREE: f64 = 0.05;
/// How far the two of a lateral pair lie apart \[1, relative\].
const PAIR: (f64, f64) = (1e-4, 0.04);
/// Pairs are sought up to this many f1: higher up lines of anything lie as near one another.
const PAIRS_UP_TO: f64 = 4.0;
/// A third line is this many times farther, at least: else they are no pair.
const ALONE: f64 = 3.0;
/// How unlike in size, and how strong beside the strongest mode, lines of a pair may be \[1\].
const UNLIKE: f64 = 5.0;
const STRONGEST: f64 = 0.3;
/// How unlike ζ may be \[1\]: of torsion beside its axial mode, of the lines of a pair.
const UNLIKE_DAMPING: f64 = 5.0;
/// A line this near an axial mode may be what the fit left of it \[1, relative\].
const OF_MODE: f64 = 0.01;

/// Names satellites among `lines`, to which those of `weak` that are satellites are added; what is said of them, and whether lines that looked
/// like a second coil's are the torsion.
pub(super) fn name(lines: &mut Vec<Line>, weak: Vec<Line>, coil: &Coil) -> (Vec<String>, bool) {
    let known = lines.len();
    let replaced = heard_better(lines, weak);
    let mut search = Search { lines, coil };
    let mut evidence: Vec<String> = search.torsion().into_iter().collect();
    evidence.extend(search.swivel());
    evidence.extend(search.pairs());
    let is_second = |index: &usize| matches!(lines[*index].meaning, Meaning::Torsional { .. });
    let no_second = coil.second_lines.iter().any(is_second);
    // What has no name stays as it was.
    for (index, line) in replaced {
        if lines[index].meaning == Meaning::Unknown {
            lines[index] = line;
        }
    }
    let mut index = 0;
    lines.retain(|line| {
        index += 1;
        index <= known || line.meaning != Meaning::Unknown
    });
    lines.sort_by(|a, b| a.frequency.value.total_cmp(&b.frequency.value));
    (evidence, no_second)
}

/// Puts weak lines in the place of those within their width that have no name, and the others behind all; what was replaced, and where.
fn heard_better(lines: &mut Vec<Line>, mut weak: Vec<Line>) -> Vec<(usize, Line)> {
    let mut replaced = Vec::new();
    for (index, line) in
        lines.iter_mut().enumerate().filter(|(_, line)| line.decays && line.meaning == Meaning::Unknown)
    {
        let off = |other: &Line| (other.frequency.value - line.frequency.value).abs();
        let nearest = (0..weak.len()).min_by(|&a, &b| off(&weak[a]).total_cmp(&off(&weak[b])));
        let same = |other: &Line| off(other) < line.width().max(other.width()).max(3.0 * line.frequency.standard);
        if let Some(nearest) = nearest.filter(|&nearest| same(&weak[nearest])) {
            let better = Line { reason: line.reason.clone(), ..weak.swap_remove(nearest) };
            replaced.push((index, std::mem::replace(line, better)));
        }
    }
    lines.extend(weak);
    replaced
}

/// Lines and the coil beside whose modes they are looked at.
struct Search<'a> {
    lines: &'a mut Vec<Line>,
    coil: &'a Coil,
}

impl Search<'_> {
    /// Torsion between ends that hold it, beside axial modes. An end mass turns otherwise than it moves: there no ratio is known.
    fn torsion(&mut self) -> Option<String> {
        if matches!(self.coil.mode_series, ModeSeries::EndMass { .. }) {
            return None;
        }
        let within: Vec<Vec<usize>> = TORSION.iter().enumerate().map(|(n, range)| self.beside(n + 1, *range)).collect();
        // A family as strong as the modes is another spring's.
        let (mut satellite, mut axial) = (0.0, 0.0);
        for (number, found) in within.iter().enumerate() {
            let amplitudes = found.iter().map(|&index| self.lines[index].amplitude);
            if let (Some(largest), Some(mode)) = (amplitudes.reduce(f64::max), self.mode(number + 1)) {
                satellite += largest * largest;
                axial += mode.amplitude * mode.amplitude;
            }
        }
        if satellite > SHARE.1 * SHARE.1 * axial {
            return None;
        }
        let mut named: Vec<(usize, usize)> = Vec::new();
        for (number, found) in within.iter().enumerate() {
            let mode = number + 1;
            let fit: Vec<usize> = found.iter().copied().filter(|&index| self.is_weak(index, mode)).collect();
            let confirmed = |index: &usize| {
                let own = self.ratio(*index, mode);
                within.iter().enumerate().any(|(other, lines)| {
                    let same = |at: &usize| (self.ratio(*at, other + 1) / own - 1.0).abs() < SAME_RATIO;
                    other != number && lines.iter().any(same)
                })
            };
            // Torsion is single: one of two alike is so only where another number has the same ratio.
            let sure: Vec<usize> = fit.iter().copied().filter(confirmed).collect();
            match (&fit[..], &sure[..]) {
                (_, &[index]) => named.push((mode, index)),
                (&[index], []) if self.partner(index).is_none() => named.push((mode, index)),
                _ => {}
            }
        }
        let &(_, lowest) = named.first()?;
        for mode in TORSION.len() + 1..=HIGHEST {
            let &(last, own) = named.last()?;
            let ratio = self.ratio(own, last);
            let near = self.beside(mode, (ratio * (1.0 - SAME_RATIO), ratio * (1.0 + SAME_RATIO)));
            if let [index] = near[..]
                && self.is_weak(index, mode)
            {
                named.push((mode, index));
            }
        }
        let text = |&(mode, index): &(usize, usize)| {
            let (ratio, of) = (self.ratio(index, mode), self.name_of(mode));
            let share = percent(self.share(index, mode).unwrap_or_default());
            format!("{ratio:.3} {of} with {share} of its strength")
        };
        let texts: Vec<String> = named.iter().map(text).collect();
        let others: Vec<String> =
            named[1..].iter().map(|&(_, index)| format!("{:.1}", self.lines[index].frequency.value)).collect();
        let beside = if others.is_empty() {
            String::new()
        } else {
            format!(" (so {} {} Hz)", if others.len() == 1 { "is" } else { "are" }, others.join(", "))
        };
        let sentence = format!(
            "{:.1} Hz, {}, is the coil's torsion: not in the axial series{beside}",
            self.lines[lowest].frequency.value, texts[0]
        );
        for ((mode, index), text) in named.into_iter().zip(texts) {
            self.lines[index].meaning = Meaning::Torsional { mode: Some(mode) };
            self.lines[index].reason = format!("torsional: {text}");
        }
        Some(sentence)
    }

    /// Quarter waves of torsion, of which one alone says nothing.
    fn swivel(&mut self) -> Option<String> {
        if !matches!(self.coil.mode_series, ModeSeries::HeldHeld | ModeSeries::Gives { .. }) {
            return None;
        }
        let first = self.coil.first;
        let within = |range: (f64, f64)| -> Vec<usize> {
            let inside = |index: &usize| {
                let over = self.lines[*index].frequency.value / first;
                over >= range.0 && over <= range.1 && self.is_open(*index) && self.is_weak(*index, 1)
            };
            (0..self.lines.len()).filter(inside).collect()
        };
        let (lows, highs) = (within(QUARTER), within(THREE_QUARTERS));
        let off = |low: usize, high: usize| {
            (self.lines[high].frequency.value / (3.0 * self.lines[low].frequency.value) - 1.0).abs()
        };
        let both = lows.iter().flat_map(|&low| highs.iter().map(move |&high| (low, high)));
        let (low, high) = both
            .filter(|&(low, high)| off(low, high) < OFF_THREE)
            .min_by(|a, b| off(a.0, a.1).total_cmp(&off(b.0, b.1)))?;
        let at = |index: usize| self.lines[index].frequency.value;
        let sentence = format!(
            "{:.1} Hz and {:.1} Hz, {:.3} and {:.3} f1, are the coil's torsion with an end that turns: not in the axial series",
            at(low),
            at(high),
            at(low) / first,
            at(high) / first
        );
        for index in [low, high] {
            let over = at_first(&self.lines[index], first);
            self.lines[index].meaning = Meaning::Torsional { mode: None };
            self.lines[index].reason = format!("torsional: {over:.3} f1, with an end that turns");
        }
        Some(sentence)
    }

    /// Close pairs: a coil is nearly as limp in one direction across its axis as in the other.
    fn pairs(&mut self) -> Vec<String> {
        let pairs: Vec<(usize, usize)> = (0..self.lines.len())
            .filter_map(|index| {
                let partner = self.partner(index)?;
                let mutual = self.partner(partner) == Some(index);
                (mutual && self.lines[index].frequency.value < self.lines[partner].frequency.value)
                    .then_some((index, partner))
            })
            .collect();
        let mut evidence = Vec::new();
        for (low, high) in pairs {
            let (below, above) = (self.lines[low].frequency.value, self.lines[high].frequency.value);
            let apart = percent(above / below - 1.0);
            evidence.push(format!(
                "{below:.2} Hz and {above:.2} Hz, {apart} apart, are a pair as sideways motion of the coil has: not in the axial series"
            ));
            for (index, other) in [(low, above), (high, below)] {
                self.lines[index].meaning = Meaning::Lateral;
                self.lines[index].reason = format!("lateral (pair): {apart} from {other:.2} Hz");
            }
        }
        evidence
    }

    /// The other line of a pair.
    fn partner(&self, index: usize) -> Option<usize> {
        let own = &self.lines[index];
        let may = |at: &usize| self.may_pair(*at);
        if !may(&index) {
            return None;
        }
        let off = |at: usize| (self.lines[at].frequency.value / own.frequency.value).ln().abs();
        let mut others: Vec<usize> = (0..self.lines.len()).filter(|at| *at != index).filter(may).collect();
        others.sort_by(|&a, &b| off(a).total_cmp(&off(b)));
        let nearest = *others.first()?;
        let alone = others.get(1).is_none_or(|&third| off(third) > ALONE * off(nearest));
        let other = &self.lines[nearest];
        let like = |of: f64, most: f64| of < most && of > 1.0 / most;
        let alike = like(other.amplitude / own.amplitude, UNLIKE)
            && like(damping(other)? / damping(own)?, UNLIKE_DAMPING)
            && off(nearest) > PAIR.0
            && off(nearest) < PAIR.1;
        (alone && alike).then_some(nearest)
    }

    /// Whether a line may be one of a pair: not far above f1, not beside an axial mode, not too strong, not of a second coil.
    fn may_pair(&self, index: usize) -> bool {
        let line = &self.lines[index];
        let largest = self.coil.modes.iter().map(|(at, ..)| self.lines[*at].amplitude).fold(0.0, f64::max);
        let beside = |place: f64| (line.frequency.value / place - 1.0).abs() < OF_MODE;
        self.is_open(index)
            && line.frequency.value < PAIRS_UP_TO * self.coil.first
            && line.amplitude < STRONGEST * largest
            && !self.coil.modes.iter().any(|entry| beside(entry.2))
            && !self.coil.second_lines.contains(&index)
    }

    /// Whether a line decays and has no name.
    fn is_open(&self, index: usize) -> bool {
        self.lines[index].decays && self.lines[index].meaning == Meaning::Unknown
    }

    /// Lines without a name within a range of ratios to an axial mode's line. Those of a second coil are that coil's, unless it is the torsion.
    fn beside(&self, mode: usize, range: (f64, f64)) -> Vec<usize> {
        let Some(own) = self.mode(mode) else { return Vec::new() };
        let of_torsion = self.coil.second.is_none_or(|second| {
            let over = second / self.coil.first;
            over >= TORSION[0].0 && over <= TORSION[0].1
        });
        let inside = |index: &usize| {
            let over = self.lines[*index].frequency.value / own.frequency.value;
            over >= range.0 && over <= range.1 && (of_torsion || !self.coil.second_lines.contains(index))
        };
        (0..self.lines.len()).filter(|index| self.is_open(*index)).filter(inside).collect()
    }

    /// Whether a line is as strong as torsion is beside a mode, and decays about as fast.
    fn is_weak(&self, index: usize, mode: usize) -> bool {
        let own = self.mode(mode).and_then(damping).zip(damping(&self.lines[index]));
        let like = own.is_some_and(|(axial, own)| own < UNLIKE_DAMPING * axial && axial < UNLIKE_DAMPING * own);
        like && self.share(index, mode).is_some_and(|share| share >= SHARE.0 && share <= SHARE.1)
    }

    /// The line of an axial mode.
    fn mode(&self, mode: usize) -> Option<&Line> {
        self.lines.iter().find(|line| line.mode() == Some(mode))
    }

    fn ratio(&self, index: usize, mode: usize) -> f64 {
        self.mode(mode).map_or(f64::NAN, |own| self.lines[index].frequency.value / own.frequency.value)
    }

    fn share(&self, index: usize, mode: usize) -> Option<f64> {
        Some(self.lines[index].amplitude / self.mode(mode)?.amplitude)
    }

    /// What follows a ratio to a mode: f1 where the lowest axial line is that of held ends.
    fn name_of(&self, mode: usize) -> String {
        match self.coil.mode_series {
            ModeSeries::HeldHeld | ModeSeries::Gives { .. } if mode == 1 => "f1".to_owned(),
            _ => format!("times mode {mode}"),
        }
    }
}

fn at_first(line: &Line, first: f64) -> f64 {
    line.frequency.value / first
}

fn damping(line: &Line) -> Option<f64> {
    line.ratio.map(|ratio| ratio.value).filter(|ratio| *ratio > 0.0)
}

/// A share in percent, of two digits.
fn percent(share: f64) -> String {
    let percent = 100.0 * share;
    let digits = (1.0 - percent.log10().floor()).clamp(0.0, 4.0) as usize;
    format!("{percent:.digits$} %")
}
