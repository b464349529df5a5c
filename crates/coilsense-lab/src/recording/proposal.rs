//! What a log does not tell of its columns, asked for in one message with one line that may be given as it stands.
//!
//! Next door: what it does tell (`selection`), how titles are written (`title`), what their words may mean (`guess`).

use coilsense::Channel;

use super::error::clipped;
use super::guess::{self, guess};
use super::quantity::Quantity;
use super::title::Title;
use super::unit;
use crate::message::{Hint, Message};
use crate::quantity::Dimension;

/// What is not told.
#[derive(Debug, Clone, Default)]
pub(super) struct Proposal {
    /// Why something is asked for, in clauses.
    reasons: Vec<String>,
    /// What to say.
    hints: Vec<Hint>,
    /// Whether what is proposed is a guess by names, units and places.
    guessed: bool,
    /// Whether a gain of one is proposed.
    of_one: bool,
    /// Whether a column is proposed for the time that may be none.
    maybe_time: bool,
    /// The column that is proposed for the time.
    time_place: Option<usize>,
}

impl Proposal {
    /// Whether nothing is to be asked.
    pub fn is_empty(&self) -> bool {
        self.hints.is_empty()
    }

    /// A column that is known, but not its unit.
    pub fn unit(&mut self, titles: &[Title], index: usize, quantity: Quantity) {
        let Some(title) = titles.get(index) else { return };
        self.reasons.push(format!("{}: its unit is not told", title.place(index)));
        self.hints.push(column(titles, index, quantity, quantity.dimension().si_unit()));
        self.guessed = true;
    }

    /// A column that is known, and holds a sensor's own signal.
    pub fn gain(&mut self, titles: &[Title], index: usize, quantity: Quantity, unit: &str) {
        let Some(title) = titles.get(index) else { return };
        let dimension = quantity.dimension();
        self.reasons.push(format!(
            "{}: {unit} is no unit of {}, it needs a gain",
            title.place(index),
            dimension.name()
        ));
        self.hints.push(of_one(quantity, unit));
        self.of_one = true;
    }

    /// No column is known as a channel: those whose titles look like one are proposed, else the last.
    pub fn channels(&mut self, titles: &[Title], taken: &[usize]) {
        let for_time = self.time_place;
        let names: Vec<String> = titles.iter().enumerate().map(|(index, title)| title.place(index)).take(8).collect();
        let more = if titles.len() > 8 { format!(" and {} more", titles.len() - 8) } else { String::new() };
        self.reasons.push(format!("no column is recognised as a channel: it has {}{more}", names.join(", ")));
        self.guessed = true;
        let is_free = |index: &usize| !taken.contains(index) && Some(*index) != for_time;
        let free: Vec<usize> = (0..titles.len()).filter(is_free).collect();
        let before = self.hints.len();
        for (index, channel) in guess(titles, &free) {
            self.channel(titles, index, Quantity::Channel(channel));
        }
        if let (true, Some(&last)) = (self.hints.len() == before, free.last().or(titles.len().checked_sub(1).as_ref()))
        {
            self.channel(titles, last, Quantity::Channel(Channel::OutputForce));
        }
    }

    /// No column is known as the time.
    pub fn time(&mut self, titles: &[Title], taken: &[usize]) {
        self.reasons.push("no column is recognised as the time".to_owned());
        self.guessed = true;
        let free: Vec<usize> = (0..titles.len()).filter(|index| !taken.contains(index)).collect();
        let is_time = |index: &usize| {
            titles[*index].stamps || titles[*index].unit.as_deref().and_then(unit::dimension) == Some(Dimension::Time)
        };
        // A wrong column does not rise, which is said; a wrong rate would be taken.
        let first = free.first().copied().filter(|_| titles.len() > 1);
        let found = guess::time(titles, &free).or(first);
        self.time_place = found;
        match found {
            Some(index) if is_time(&index) => {
                self.hints.push(column(titles, index, Quantity::Time, ""));
            }
            Some(index) => {
                self.maybe_time = true;
                self.hints.push(column(titles, index, Quantity::Time, likely_unit(&titles[index], Quantity::Time)));
            }
            None => self.hints.push(Hint::Value("sample_rate", "1 kHz".to_owned())),
        }
    }

    fn channel(&mut self, titles: &[Title], index: usize, quantity: Quantity) {
        let own = titles[index].unit.as_deref();
        if let Some(own) = own.filter(|unit| unit::is_signal(unit)) {
            self.hints.push(column(titles, index, quantity, ""));
            self.hints.push(of_one(quantity, own));
            self.of_one = true;
            return;
        }
        let fits = own.is_some_and(|unit| unit::scale(quantity.dimension(), unit).is_some());
        self.hints.push(column(titles, index, quantity, if fits { "" } else { likely_unit(&titles[index], quantity) }));
    }

    /// All that is asked for, in one line.
    pub fn message(self) -> Message {
        let needs = match (self.guessed, self.of_one) {
            (true, true) => {
                "; add these options, corrected where the guess is wrong and with your sensors' gains in place of 1: "
            }
            (true, false) => "; add these options, corrected where the guess is wrong: ",
            (false, _) => "; add this option, with your sensor's gain in place of 1: ",
        };
        let text = self.reasons.join("; ") + needs;
        let message = Message::from(text) + Hint::All(self.hints);
        match self.maybe_time {
            true => {
                message
                    + "; if the log has no time column, "
                    + Hint::Open("sample_rate")
                    + " says how often it was sampled"
            }
            false => message,
        }
    }
}

/// A column as the value of `--column`: by its title where that is one of its kind, else by its number.
fn column(titles: &[Title], index: usize, quantity: Quantity, unit: &str) -> Hint {
    let title = &titles[index];
    let alike = titles.iter().filter(|other| other.name == title.name || other.text == title.text).count();
    let is_plain = alike == 1
        && !title.name.is_empty()
        && !title.name.starts_with('#')
        && clipped(&title.name) == format!("{:?}", title.name);
    let name = if is_plain { title.name.clone() } else { format!("#{}", index + 1) };
    Hint::Column(quantity.name(), if unit.is_empty() { name } else { format!("{name} [{unit}]") })
}

/// A gain of one, to be replaced by the sensor's.
fn of_one(quantity: Quantity, unit: &str) -> Hint {
    Hint::Named("gain", quantity.name(), format!("1 {}/{unit}", usual_unit(quantity)))
}

/// The unit that a title ends with, as in `t_ms`, else the usual one. An inch is none: `force_in` goes in.
fn likely_unit(title: &Title, quantity: Quantity) -> &str {
    let last = title.name.rsplit(['_', '.', ' ']).next().filter(|last| last.len() < title.name.len() && *last != "in");
    let told = last.filter(|last| unit::scale(quantity.dimension(), last).is_some());
    told.unwrap_or_else(|| usual_unit(quantity))
}

fn usual_unit(quantity: Quantity) -> &'static str {
    match quantity.dimension() {
        Dimension::Length => "mm",
        Dimension::Inductance => "uH",
        other => other.si_unit(),
    }
}
