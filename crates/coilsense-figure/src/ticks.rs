//! Where an axis is ticked, and what stands at each tick.
//!
//! Ranges and mapping are `ruler`'s; whether labels fit side by side is asked by `layout`.

use crate::Scale;
use crate::ruler::Ruler;

/// The ticks of one axis, as shares of its length; none where names stand in their place.
#[derive(Default)]
pub(crate) struct Ticks {
    /// Share and label of the ticks that carry one.
    pub major: Vec<(f64, String)>,
    /// Shares of those that do not.
    pub minor: Vec<f64>,
}

/// Ticks with round labels, at most about `most` of them.
pub(crate) fn ticks(ruler: &Ruler, most: usize) -> Ticks {
    match ruler.scale {
        Scale::Linear => linear(ruler, ruler.lower, ruler.upper, most),
        Scale::Log10 => logarithmic(ruler, most),
    }
}

fn linear(ruler: &Ruler, lower: f64, upper: f64, most: usize) -> Ticks {
    let (unit, decade) = round_step((upper - lower) / most.max(1) as f64);
    let step = unit * 10f64.powi(decade);
    let exponent = common_exponent(lower.abs().max(upper.abs()));
    let digits = (exponent.unwrap_or(0) - decade).max(0) as usize;
    let label = |value: f64| match exponent {
        Some(power) if value != 0.0 => {
            format!("{}·10^{{{}}}", number(value / 10f64.powi(power), digits), signed(power))
        }
        _ => number(value, digits),
    };
    let parts = if unit == 2.0 { 4.0 } else { 5.0 };
    Ticks {
        major: multiples(lower, upper, step).map(|value| (ruler.share(value), label(value))).collect(),
        minor: multiples(lower, upper, step / parts).map(|value| ruler.share(value)).collect(),
    }
}

/// The least of 1, 2, 5 times a power of ten that reaches `raw`: leading digit and power.
fn round_step(raw: f64) -> (f64, i32) {
    let decade = raw.log10().floor() as i32;
    let lead = raw / 10f64.powi(decade) * (1.0 - 1e-9);
    match [1.0, 2.0, 5.0].into_iter().find(|unit| *unit >= lead) {
        Some(unit) => (unit, decade),
        None => (1.0, decade + 1),
    }
}

/// The power of ten that labels share when plain digits would be long.
fn common_exponent(size: f64) -> Option<i32> {
    (!(1e-3..1e5).contains(&size)).then(|| size.log10().floor() as i32)
}

fn multiples(lower: f64, upper: f64, step: f64) -> impl Iterator<Item = f64> {
    let first = (lower / step - 1e-6).ceil() as i64;
    let last = (upper / step + 1e-6).floor() as i64;
    (first..=last).map(move |index| index as f64 * step)
}

/// Decades; on a short axis 1, 2, 5, or round values evenly apart when even those are few.
fn logarithmic(ruler: &Ruler, most: usize) -> Ticks {
    let decades: Vec<i32> = multiples(ruler.lower, ruler.upper, 1.0).map(|d| d as i32).collect();
    let fine: Vec<f64> = between_decades(ruler, &[1, 2, 5]).collect();
    if decades.len() < 3 && (3..=most).contains(&fine.len()) {
        return one_two_five(ruler, &fine);
    }
    if decades.len() < 2 {
        return linear(ruler, 10f64.powf(ruler.lower), 10f64.powf(ruler.upper), most.min(5));
    }
    let stride = decades.len().div_ceil(most.max(2)) as i32;
    let (labelled, bare): (Vec<i32>, Vec<i32>) = decades.iter().partition(|decade| decade.rem_euclid(stride) == 0);
    let place = |decade: i32| ruler.share(10f64.powi(decade));
    let minor = if stride == 1 {
        between_decades(ruler, &[2, 3, 4, 5, 6, 7, 8, 9]).map(|value| ruler.share(value)).collect()
    } else {
        bare.into_iter().map(place).collect()
    };
    let label = |decade: i32| (place(decade), format!("10^{{{}}}", signed(decade)));
    Ticks { major: labelled.into_iter().map(label).collect(), minor }
}

fn one_two_five(ruler: &Ruler, values: &[f64]) -> Ticks {
    let between = between_decades(ruler, &[3, 4, 6, 7, 8, 9]);
    Ticks {
        major: values.iter().map(|value| (ruler.share(*value), shortest(*value))).collect(),
        minor: between.map(|value| ruler.share(value)).collect(),
    }
}

fn between_decades(ruler: &Ruler, leads: &[i32]) -> impl Iterator<Item = f64> {
    let (first, last) = (ruler.lower.floor() as i32, ruler.upper.ceil() as i32);
    (first..=last)
        .flat_map(move |decade| leads.iter().map(move |lead| f64::from(*lead) * 10f64.powi(decade)))
        .filter(|value| Ruler::holds(ruler.share(*value)))
}

/// A value of one leading digit in as few characters as it takes.
fn shortest(value: f64) -> String {
    let decade = (value.log10() + 1e-9).floor() as i32;
    if (-3..5).contains(&decade) {
        number(value, (-decade).max(0) as usize)
    } else {
        format!("{}·10^{{{}}}", number(value / 10f64.powi(decade), 0), signed(decade))
    }
}

/// A number with a true minus sign, and none before zero.
fn number(value: f64, digits: usize) -> String {
    let text = format!("{value:.digits$}");
    match text.strip_prefix('-') {
        Some(rest) if rest.chars().all(|digit| digit == '0' || digit == '.') => rest.to_owned(),
        Some(rest) => format!("\u{2212}{rest}"),
        None => text,
    }
}

fn signed(power: i32) -> String {
    number(f64::from(power), 0)
}
