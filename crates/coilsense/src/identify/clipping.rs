//! Whether a channel is clipped: whether it stays at its least or largest value in runs that nothing smooth has.
//!
//! Next door: what else a channel can show (`channel_check`).

/// Fewest runs at a limit, and fewest samples in them.
const LEAST_RUNS: usize = 3;
const LEAST_SAMPLES: usize = 8;
/// A reading that most samples have is no limit but where the force rests.
const REST: f64 = 0.5;
/// How many steps of the last digit beyond a parabola's a neighbour may lie.
const STEPS: f64 = 2.0;

/// Readings beyond which a channel says nothing.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Clipping {
    /// The least reading \[N\], where it is a limit.
    pub low: Option<f64>,
    /// The largest reading \[N\], where it is a limit.
    pub high: Option<f64>,
    /// Share of the samples at a limit \[1\].
    pub share: f64,
}

impl Clipping {
    /// Whether a reading is at a limit.
    pub(super) fn holds(&self, value: f64) -> bool {
        self.low.is_some_and(|low| value <= low) || self.high.is_some_and(|high| value >= high)
    }
}

/// The limits of a channel whose last digit is worth `digit` (zero where it has none).
pub(super) fn of(values: &[f64], digit: f64) -> Option<Clipping> {
    let high = values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let low = values.iter().copied().fold(f64::INFINITY, f64::min);
    // What rounding leaves of a step.
    let digit = digit.max(1e-9 * (high - low));
    let high = clips(values, high, digit).then_some(high);
    let low = clips(values, low, digit).then_some(low);
    if high.is_none() && low.is_none() {
        return None;
    }
    let whole = Clipping { low, high, share: 0.0 };
    let share = values.iter().filter(|value| whole.holds(**value)).count() as f64 / values.len() as f64;
    Some(Clipping { share, ..whole })
}

/// Whether a channel stays at an extreme reading as no crest does.
///
/// About a crest, x = c n²: where L readings show the same last digit q, the next ones to either side lie (1 + 2/L)² q off at most.
fn clips(values: &[f64], limit: f64, digit: f64) -> bool {
    let at = |index: usize| (values[index] - limit).abs() <= 0.01 * digit;
    let (mut runs, mut samples, mut all) = (0, 0, 0);
    let mut index = 0;
    while index < values.len() {
        if !at(index) {
            index += 1;
            continue;
        }
        let begin = index;
        while index < values.len() && at(index) {
            index += 1;
        }
        let length = index - begin;
        all += length;
        // What touches the record's begin or end is rest.
        if begin == 0 || index == values.len() || length < 2 {
            continue;
        }
        let fall = (values[begin - 1] - limit).abs().max((values[index] - limit).abs());
        let parabola = (1.0 + 2.0 / length as f64).powi(2) * digit;
        if fall > 2.0 * parabola + STEPS * digit {
            runs += 1;
            samples += length;
        }
    }
    runs >= LEAST_RUNS && samples >= LEAST_SAMPLES && (all as f64) < REST * values.len() as f64
}
