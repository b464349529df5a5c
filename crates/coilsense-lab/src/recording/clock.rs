//! The first stage: the times of rows as the device meant them. The window of time; midnights and counters that roll over; and what it is where time
//! does not rise.
//!
//! Next door: rows that are put in order or merged (`order`), gaps and rates (`spacing`), rates as people set them (`nominal`).

use super::account::{Account, Reason};
use super::cleaning::Cleaning;
use super::nominal::nominal;
use super::telling::{hertz, what_turns};
use crate::message::{Hint, Message};

/// Follows the times of a log's rows.
#[derive(Debug, Clone)]
pub(super) struct Clock {
    cleaning: Cleaning,
    /// Times at which the clock may begin anew \[s\].
    turns: Vec<f64>,
    /// The row before, as the file has it.
    raw: f64,
    /// The same as it went on.
    last: f64,
    /// What turns have added.
    added: f64,
    /// The last step that was above zero, the usual one of a log that is even.
    step: f64,
}

/// Where time does not rise.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Fault {
    /// The clock begins anew, as it does every `turn` \[s\].
    Turn { before: f64, now: f64, turn: f64 },
    /// It goes back otherwise.
    Back { before: f64, now: f64 },
    /// It stands still.
    Again { time: f64 },
}

/// Counters roll over at these powers of two.
const POWERS: [i32; 5] = [16, 24, 31, 32, 48];
/// Ticks of counters \[s\] beside the unit of the column.
const TICKS: [f64; 4] = [1e-9, 1e-6, 1e-5, 1e-3];
/// What may lie between the rows before and behind a turn: so many usual steps, or this share of it.
const MISSING_STEPS: f64 = 20.0;
const MISSING_SHARE: f64 = 1e-3;
/// Hours, half days and days of stamps.
const OF_STAMPS: [f64; 3] = [3600.0, 43_200.0, DAY];
const DAY: f64 = 86_400.0;

impl Clock {
    /// Of a column of stamps, or of numbers whose unit is `tick` \[s\].
    pub fn new(cleaning: Cleaning, stamps: bool, tick: f64) -> Self {
        let counters = TICKS.iter().chain([&tick]).flat_map(|tick| POWERS.map(|power| tick * 2f64.powi(power)));
        let mut turns: Vec<f64> = if stamps { OF_STAMPS.to_vec() } else { counters.chain([DAY]).collect() };
        turns.sort_by(f64::total_cmp);
        Self { cleaning, turns, raw: f64::NEG_INFINITY, last: f64::NEG_INFINITY, added: 0.0, step: 0.0 }
    }

    /// The time of a row on a rising clock; `None` outside the window.
    pub fn follow(&mut self, raw: f64, line: u64, account: &mut Account) -> Result<Option<f64>, Fault> {
        let turn = self.turn(raw);
        let before = self.last;
        let fault =
            turn.filter(|_| !self.cleaning.unwrap).map(|turn| Fault::Turn { before, now: raw + self.added, turn });
        if let Some(turn) = turn.filter(|_| self.cleaning.unwrap) {
            self.added += turn;
            account.turned(turn, line);
        }
        self.raw = raw;
        let time = raw + self.added;
        let is_before = self.cleaning.from.is_some_and(|from| time < from);
        if is_before || self.cleaning.to.is_some_and(|to| time > to) {
            account.leave_out(Reason::OutsideWindow, line);
            return Ok(None);
        }
        if let Some(fault) = fault {
            return Err(fault);
        }
        if time < before && !self.cleaning.sort {
            return Err(Fault::Back { before, now: time });
        }
        if time == before && !self.cleaning.merge_repeated {
            return Err(Fault::Again { time });
        }
        if time > before && before.is_finite() {
            self.step = time - before;
        }
        self.last = self.last.max(time);
        Ok(Some(time))
    }

    /// At what the clock has begun anew, if it has: it was close below that, and is close above zero, or half a turn below each as signed counters are.
    fn turn(&self, raw: f64) -> Option<f64> {
        let before = self.raw;
        if !before.is_finite() || raw >= before {
            return None;
        }
        let begins_anew = |turn: &f64| {
            let most = (MISSING_STEPS * self.step).max(MISSING_SHARE * turn).min(0.25 * turn);
            let missing = turn - (before - raw);
            let unsigned = raw >= 0.0 && before <= *turn;
            let signed = raw >= -0.5 * turn - most && before <= 0.5 * turn;
            // As far as the numbers of a text are rounded.
            (-1e-9 * turn..=most).contains(&missing) && (unsigned || signed)
        };
        self.turns.iter().copied().find(begins_anew)
    }
}

/// What the rows behind a fault tell of it.
pub(super) struct Behind {
    /// Times of the row with the fault and of those behind it \[s\].
    pub times: Vec<f64>,
    /// How many rows are up to it.
    pub rows: u64,
    /// The time of the first of them \[s\].
    pub first: f64,
}

impl Fault {
    /// What it is, and what helps: never what destroys more than it mends.
    pub fn message(self, behind: &Behind) -> Message {
        match self {
            Self::Turn { before, now, turn } => {
                let text = format!("time goes back from {before} s to {now} s: {}; ", what_turns(turn));
                Message::from(text) + Hint::Flag("unwrap") + " counts on from there"
            }
            Self::Back { before, now } => {
                let text = format!("time goes back from {before} s to {now} s");
                let returns = behind.times.iter().take(OUT_OF_ORDER).any(|time| *time >= before);
                if returns || behind.times.len() < FEW {
                    return Message::from(text + "; ") + Hint::Flag("sort") + " puts the rows in order";
                }
                let text = text
                    + " and goes on from there: the clock was set back, or another run begins; cut the file at this line";
                match rate(&behind.times) {
                    Some(rate) => {
                        Message::from(text + ", or take its rows for evenly sampled by ")
                            + Hint::Value("sample_rate", hertz(rate))
                    }
                    None => text.into(),
                }
            }
            Self::Again { time } => {
                let all = behind.times.len();
                let again = 1 + behind.times.windows(2).filter(|pair| pair[1] == pair[0]).count();
                let text = format!("time {time} s is there again");
                if again as f64 <= 0.01 * all as f64 || all < FEW {
                    return Message::from(text + "; ") + Hint::Flag("merge_repeated") + " takes the mean of such rows";
                }
                let share = 100.0 * again as f64 / all as f64;
                let text = format!(
                    "{text}; {share:.0} % of the rows repeat the time before them: the clock is coarser than the rows; "
                );
                let span = behind.times.last().copied().unwrap_or(time) - behind.first;
                let rows = (behind.rows as usize + behind.times.len() - 2) as f64;
                let even = nominal(rows / span.max(f64::MIN_POSITIVE));
                Message::from(text + "if they are evenly sampled, ")
                    + Hint::Value("sample_rate", hertz(even))
                    + " takes them so"
            }
        }
    }
}

/// So many rows may stand out of their order.
const OUT_OF_ORDER: usize = 100;
/// Of fewer rows no share is told.
const FEW: usize = 20;

/// The rate of times that rise evenly.
fn rate(times: &[f64]) -> Option<f64> {
    let (first, last) = (times.first()?, times.last()?);
    let rises = times.len() >= FEW && times.windows(2).all(|pair| pair[1] > pair[0]);
    rises.then(|| nominal((times.len() - 1) as f64 / (last - first)))
}

#[cfg(test)]
mod tests {
    use super::{Clock, Fault};
    use crate::recording::account::Account;
    use crate::recording::cleaning::Cleaning;

    fn follow(times: &[f64], stamps: bool, tick: f64, unwrap: bool) -> Result<Vec<f64>, Fault> {
        let mut clock = Clock::new(Cleaning { unwrap, ..Cleaning::default() }, stamps, tick);
        let mut account = Account::default();
        times.iter().map(|time| clock.follow(*time, 1, &mut account).map(|time| time.unwrap_or(f64::NAN))).collect()
    }

    #[test]
    fn midnights_and_counters_count_on_and_nothing_else_does() {
        let midnight = [86_399.8, 86_399.9, 0.0, 0.1];
        assert!(matches!(follow(&midnight, true, 1.0, false), Err(Fault::Turn { turn: 86_400.0, .. })));
        assert_eq!(follow(&midnight, true, 1.0, true).unwrap(), [86_399.8, 86_399.9, 86_400.0, 86_400.1]);
        // A 16-bit counter of milliseconds, in seconds; one of microseconds of 32 bit; a signed one.
        for turn in [65.536, 4_294.967_296] {
            let times = [turn - 0.002, turn - 0.001, 0.0, 0.001];
            let found = follow(&times, false, 1.0, true).unwrap();
            assert!((found[3] - turn - 0.001).abs() < 1e-9, "{found:?}");
        }
        let signed = [32.766, 32.767, -32.768, -32.767];
        assert!((follow(&signed, false, 1.0, true).unwrap()[3] - 32.769).abs() < 1e-9);
        // A clock that is set back, a run that begins anew after a minute or ten seconds: no turn, told or not.
        for times in [
            [100.0, 100.1, 98.2, 98.3],
            [59.8, 59.9, 0.0, 0.1],
            [9.998, 9.999, 0.0, 0.001],
            [50_000.0, 50_000.1, 0.0, 0.1],
        ] {
            assert!(matches!(follow(&times, false, 1.0, true), Err(Fault::Back { .. })), "{times:?}");
        }
        // In the middle of the day no midnight passes.
        assert!(matches!(follow(&[40_000.0, 40_000.1, 0.1], true, 1.0, true), Err(Fault::Back { .. })));
    }
}
