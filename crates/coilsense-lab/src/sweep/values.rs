//! The values of a variable as people write them: `600..900 N/m : 11`, `log 1e-3..5e-2`, `600, 700, 800 N/m`, `normal(760 N/m, 5 %)`.
//!
//! ```text
//! VALUES       = (RANGE | DISTRIBUTION) [":" POINTS] | LIST
//! RANGE        = ["log"] NUMBER ".." NUMBER [UNIT]
//! DISTRIBUTION = NAME "(" NUMBER [UNIT] {"," NUMBER [UNIT]} ")"      normal, lognormal, uniform, triangular
//! LIST         = NUMBER [UNIT] {"," NUMBER [UNIT]} | '"' TEXT '"' {"," '"' TEXT '"'}
//! ```
//!
//! Next door: what key they are of (`variable`), how they are spread (`spread`).

use super::spread::Spread;
use crate::quantity::Dimension;
use crate::spec::Domain;

/// Values that a variable takes, in the unit in which they are written.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Values {
    Numbers(Vec<f64>),
    Texts(Vec<String>),
    Spread { spread: Spread, points: Option<u64> },
}

/// A unit and what it is a unit of.
pub(super) type Unit = (String, Dimension);

/// Most points of one variable's grid.
const MOST_POINTS: u64 = 1_000_000;

/// Reads values of a key that takes `domain`; the unit is `None` where numbers carry none.
pub(super) fn parse(text: &str, domain: &Domain) -> Result<(Values, Option<Unit>), String> {
    let text = text.trim();
    if text.is_empty() {
        return Err("no values are given, such as 1..2, or 1, 2, 3".to_owned());
    }
    if text.starts_with('"') {
        return texts(text, domain).map(|texts| (Values::Texts(texts), None));
    }
    if *domain == Domain::Text {
        return Err("takes texts: \"…\", \"…\", each in quotes".to_owned());
    }
    let (body, points) = match text.rsplit_once(':') {
        Some((body, points)) => (body.trim(), Some(number_of_points(points)?)),
        None => (text, None),
    };
    let (spread, unit) = if let Some(inner) = body.strip_suffix(')') {
        distribution(inner, domain)?
    } else if let Some((from, to)) = body.split_once("..") {
        range(from, to, domain)?
    } else if points.is_some() {
        return Err("a list has its own points; \": POINTS\" belongs to a range or a distribution".to_owned());
    } else {
        let numbers = body.split(',').map(Measured::parse).collect::<Result<Vec<_>, _>>()?;
        let unit = common_unit(&numbers, domain)?;
        return Ok((Values::Numbers(numbers.iter().map(|number| number.value).collect()), unit));
    };
    Ok((Values::Spread { spread, points }, unit))
}

fn number_of_points(text: &str) -> Result<u64, String> {
    let points = text.trim().parse().ok().filter(|points| (2..=MOST_POINTS).contains(points));
    points.ok_or_else(|| {
        format!("behind the colon stands the number of points, from 2 to {MOST_POINTS}, got {:?}", text.trim())
    })
}

fn texts(text: &str, domain: &Domain) -> Result<Vec<String>, String> {
    if *domain == Domain::Number {
        return Err("takes numbers without quotes".to_owned());
    }
    let mut rest = text;
    let mut texts = Vec::new();
    loop {
        let opened = rest.trim_start().strip_prefix('"').ok_or("texts stand in quotes with commas between them")?;
        let (inner, behind) = opened.split_once('"').ok_or("a quote is not closed")?;
        texts.push(inner.to_owned());
        rest = behind.trim_start();
        if rest.is_empty() {
            return Ok(texts);
        }
        rest = rest.strip_prefix(',').ok_or("texts stand in quotes with commas between them")?;
    }
}

/// A number as it is written, with its unit or without.
struct Measured<'a> {
    value: f64,
    unit: &'a str,
}

impl<'a> Measured<'a> {
    fn parse(text: &'a str) -> Result<Self, String> {
        let text = text.trim();
        let ends = text.char_indices().map(|(at, c)| at + c.len_utf8()).rev();
        let mut numbers =
            ends.filter_map(|end| Some((text[..end].trim_end().parse::<f64>().ok()?, text[end..].trim())));
        match numbers.next() {
            Some((value, unit)) if value.is_finite() => Ok(Self { value, unit }),
            _ => Err(format!("{text:?} is no number with its unit")),
        }
    }
}

/// The unit that all numbers share; that of the last counts for those without.
fn common_unit(numbers: &[Measured<'_>], domain: &Domain) -> Result<Option<Unit>, String> {
    let written: Vec<&str> = numbers.iter().map(|number| number.unit).filter(|unit| !unit.is_empty()).collect();
    if let Some(other) = written.iter().find(|unit| **unit != written[0]) {
        return Err(format!("all numbers need one unit, got {} and {other}", written[0]));
    }
    let dimensions = match domain {
        Domain::Quantity(dimensions) => dimensions.as_slice(),
        _ if written.is_empty() => return Ok(None),
        _ => return Err(format!("takes numbers without a unit, got {}", written[0])),
    };
    let expected = || {
        let each: Vec<String> = dimensions.iter().map(|dimension| dimension.expectation()).collect();
        format!("must be {}", each.join(", or "))
    };
    let Some(unit) = numbers.last().map(|number| number.unit).filter(|unit| !unit.is_empty()) else {
        return Err(format!("the unit is missing; {}", expected()));
    };
    let of = dimensions.iter().find(|dimension| dimension.scale(unit).is_some());
    of.map(|dimension| Some((unit.to_owned(), *dimension))).ok_or_else(|| format!("{}, got {unit}", expected()))
}

fn range(from: &str, to: &str, domain: &Domain) -> Result<(Spread, Option<Unit>), String> {
    let (from, log) = match from.trim().strip_prefix("log ") {
        Some(from) => (from, true),
        None => (from, false),
    };
    let numbers = [Measured::parse(from)?, Measured::parse(to)?];
    let unit = common_unit(&numbers, domain)?;
    let [from, to] = numbers.map(|number| number.value);
    rising(from, to)?;
    match log {
        true if from > 0.0 => Ok((Spread::LogUniform { from, to }, unit)),
        true => Err(format!("a range by logarithm must be above zero, got {from}")),
        false => Ok((Spread::Uniform { from, to }, unit)),
    }
}

fn rising(from: f64, to: f64) -> Result<(), String> {
    match from < to && (to - from).is_finite() {
        true => Ok(()),
        false => Err(format!("the range must rise, got {from} to {to}")),
    }
}

fn distribution(text: &str, domain: &Domain) -> Result<(Spread, Option<Unit>), String> {
    let (name, inner) = text.split_once('(').ok_or("a bracket is closed that was never opened")?;
    let mut numbers = inner.split(',').map(Measured::parse).collect::<Result<Vec<_>, _>>()?;
    let needs = |count: usize, what: &str| match numbers.len() == count {
        true => Ok(()),
        false => Err(format!("{} takes {count} numbers, {what}, got {}", name.trim(), numbers.len())),
    };
    match name.trim() {
        "normal" => {
            needs(2, "the mean and the standard deviation")?;
            let relative = numbers[1].unit == "%" && numbers[0].unit != "%";
            let unit = common_unit(if relative { &numbers[..1] } else { &numbers }, domain)?;
            let (mean, second) = (numbers[0].value, numbers[1].value);
            let deviation = if relative { 0.01 * second * mean.abs() } else { second };
            above_zero("the standard deviation", deviation)?;
            Ok((Spread::Normal { mean, deviation }, unit))
        }
        "lognormal" => {
            needs(2, "the median and the standard deviation of the logarithm")?;
            let Some(second) = numbers.pop() else { return Err("numbers are missing".to_owned()) };
            let scale = match second.unit {
                "" => 1.0,
                "%" => 0.01,
                other => {
                    return Err(format!("the standard deviation of the logarithm is a number or in %, got {other}"));
                }
            };
            let (median, log_deviation) = (numbers[0].value, scale * second.value);
            above_zero("the median", median)?;
            above_zero("the standard deviation", log_deviation)?;
            Ok((Spread::LogNormal { median, log_deviation }, common_unit(&numbers, domain)?))
        }
        "uniform" => {
            needs(2, "from and to")?;
            let (from, to) = (numbers[0].value, numbers[1].value);
            rising(from, to)?;
            Ok((Spread::Uniform { from, to }, common_unit(&numbers, domain)?))
        }
        "triangular" => {
            needs(3, "from, the most likely and to")?;
            let (from, mode, to) = (numbers[0].value, numbers[1].value, numbers[2].value);
            rising(from, to)?;
            if !(from..=to).contains(&mode) {
                return Err(format!("the most likely value must lie from {from} to {to}, got {mode}"));
            }
            Ok((Spread::Triangular { from, mode, to }, common_unit(&numbers, domain)?))
        }
        other => Err(format!("{other:?} is no distribution; there are normal, lognormal, uniform, triangular")),
    }
}

fn above_zero(what: &str, value: f64) -> Result<(), String> {
    if value > 0.0 { Ok(()) } else { Err(format!("{what} must be above zero, got {value}")) }
}

#[cfg(test)]
mod tests {
    use super::super::spread::Spread;
    use super::{Values, parse};
    use crate::quantity::Dimension;
    use crate::spec::Domain;

    fn stiffness(text: &str) -> Result<(Values, Option<super::Unit>), String> {
        parse(text, &Domain::Quantity(vec![Dimension::Stiffness]))
    }

    #[test]
    fn every_form_is_read() {
        let unit = Some(("N/m".to_owned(), Dimension::Stiffness));
        let range = Spread::Uniform { from: 600.0, to: 900.0 };
        assert_eq!(stiffness("600..900 N/m"), Ok((Values::Spread { spread: range, points: None }, unit.clone())));
        assert_eq!(
            stiffness("600 N/m .. 900 N/m : 11"),
            Ok((Values::Spread { spread: range, points: Some(11) }, unit.clone()))
        );
        assert_eq!(stiffness("600, 700,800 N/m"), Ok((Values::Numbers(vec![600.0, 700.0, 800.0]), unit.clone())));
        let normal = |deviation| Values::Spread { spread: Spread::Normal { mean: 760.0, deviation }, points: None };
        assert_eq!(stiffness("normal(760 N/m, 5 %)"), Ok((normal(38.0), unit.clone())));
        assert_eq!(stiffness("normal(760, 10 N/m)"), Ok((normal(10.0), unit)));
        let log = Spread::LogUniform { from: 1e-3, to: 5e-2 };
        assert_eq!(parse("log 1e-3..5e-2", &Domain::Number), Ok((Values::Spread { spread: log, points: None }, None)));
        assert_eq!(parse("-1..2e3", &Domain::Number).map(|read| read.1), Ok(None));
        let texts = Values::Texts(vec!["a, b".to_owned(), "c".to_owned()]);
        assert_eq!(parse("\"a, b\" , \"c\"", &Domain::Text), Ok((texts, None)));
    }

    #[test]
    fn what_is_malformed_is_refused_in_one_line() {
        for text in [
            "",
            "N/m",
            "600..900",
            "600..900 mm",
            "900..600 N/m",
            "600..600 N/m",
            "600.. N/m",
            "..900 N/m",
            "1..2..3 N/m",
            "600 N/m..900 N/mm",
            "600..900 N/m : 1",
            "600..900 N/m : x",
            "600..900 N/m : 2000000",
            "600, 700 N/m : 3",
            "600,,700 N/m",
            "nan N/m",
            "1..inf N/m",
            "log 0..5 N/m",
            "log -1..5 N/m",
            "normal(760 N/m)",
            "normal(760 N/m, -5 %)",
            "normal(760 N/m, 5 mm)",
            "gauss(1, 2 N/m)",
            "760 N/m)",
            "triangular(1, 5, 3 N/m)",
            "lognormal(-1 N/m, 0.1)",
            "lognormal(1 N/m, 3 N/m)",
            "uniform(3, 1 N/m)",
            "\"600",
            "\"a\" \"b\"",
            "six hundred N/m",
        ] {
            let error = stiffness(text).expect_err(text);
            assert!(!error.contains('\n') && !error.is_empty(), "{text}: {error}");
        }
        assert!(parse("1 N/m", &Domain::Number).is_err());
        assert!(parse("\"1\"", &Domain::Number).is_err());
        assert!(parse("hooks", &Domain::Text).is_err());
    }
}
