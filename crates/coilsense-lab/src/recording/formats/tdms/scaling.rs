//! What a channel's properties make of its raw numbers: scales that build on one another.
//!
//! Next door: properties (`properties`), raw numbers (`data`).
//! As npTDMS does it, in double precision throughout.

use super::super::super::error::shortened;
use super::super::between::between;
use super::data::Raw;
use super::properties::Properties;

/// One scale, and the number of the one that it starts from.
#[derive(Debug, Clone, PartialEq)]
enum Scale {
    /// The numbers of a card's scaler.
    Scaler(u32),
    Same(u32),
    Linear {
        slope: f64,
        intercept: f64,
        input: u32,
    },
    Polynomial {
        coefficients: Vec<f64>,
        input: u32,
    },
    /// Straight lines between points whose first numbers rise.
    Table {
        points: Vec<[f64; 2]>,
        input: u32,
    },
    Add(u32, u32),
    /// The second less the first, as NI's own importer does it.
    Subtract(u32, u32),
}

/// The scales of a channel.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Scaling(Vec<Scale>);

/// The raw numbers, as the start of a scale.
const RAW: u32 = u32::MAX;
/// Most scales of a channel, most coefficients of one.
const MOST_SCALES: usize = 100;
const MOST_COEFFICIENTS: usize = 100;
/// Numbers that are scaled at once.
const BLOCK: usize = 4096;

impl Scaling {
    /// Of a channel, or else of its group, or else of the file; `None` where the numbers are what they say.
    pub fn of<'a>(all: impl Iterator<Item = &'a Properties>) -> Result<Option<Self>, String> {
        for properties in all {
            if let Some(scaling) = Self::own(properties)? {
                return Ok(Some(scaling));
            }
        }
        Ok(None)
    }

    fn own(properties: &Properties) -> Result<Option<Self>, String> {
        let numbered = |name: &str| {
            name.strip_prefix("NI_Scale[")?.strip_suffix("]_Scale_Type")?.parse::<usize>().ok()?.checked_add(1)
        };
        let told = properties.number("NI_Number_Of_Scales").map(|count| count as usize);
        let count = told.or_else(|| properties.names().filter_map(numbered).max()).unwrap_or(0);
        if count == 0 || properties.text("NI_Scaling_Status") == Some("scaled") {
            return Ok(None);
        }
        if count > MOST_SCALES {
            return Err(format!("it has more than {MOST_SCALES} scales"));
        }
        let scales: Result<Vec<Scale>, String> = (0..count).map(|number| Scale::of(properties, number)).collect();
        Ok(Some(Self(scales?)))
    }

    /// The scaled numbers.
    pub fn apply(&self, raw: &Raw) -> Result<Vec<f64>, String> {
        let last = self.0.len() - 1;
        let (mut order, mut open) = (Vec::new(), Vec::new());
        self.order(last, &mut order, &mut open)?;
        for scale in &order {
            self.0[*scale].check(raw)?;
        }
        let mut scaled = Vec::with_capacity(raw.len());
        let mut blocks: Vec<Vec<f64>> = vec![Vec::new(); self.0.len()];
        for start in (0..raw.len()).step_by(BLOCK) {
            let end = (start + BLOCK).min(raw.len());
            for &number in &order {
                let done = self.0[number].block(raw, start..end, &blocks);
                blocks[number] = done;
            }
            scaled.extend_from_slice(&blocks[last]);
        }
        Ok(scaled)
    }

    /// The scales that one builds on, and then itself.
    fn order(&self, scale: usize, order: &mut Vec<usize>, open: &mut Vec<usize>) -> Result<(), String> {
        if order.contains(&scale) {
            return Ok(());
        }
        if open.contains(&scale) {
            return Err("its scales build on one another in a circle".to_owned());
        }
        open.push(scale);
        let missing = || format!("it has no scale {scale}");
        for input in self.0.get(scale).ok_or_else(missing)?.inputs().into_iter().filter(|input| *input != RAW) {
            self.order(input as usize, order, open)?;
        }
        open.pop();
        order.push(scale);
        Ok(())
    }
}

impl Scale {
    fn of(properties: &Properties, number: usize) -> Result<Self, String> {
        let prefix = format!("NI_Scale[{number}]_");
        let Some(kind) = properties.text(&format!("{prefix}Scale_Type")) else {
            return Ok(Self::Scaler(number as u32));
        };
        let told = |name: &str| properties.number(&format!("{prefix}{kind}_{name}"));
        let needed = |name: &str| told(name).ok_or_else(|| format!("its scale {number} lacks {kind}_{name}"));
        let input = || told("Input_Source").map_or(RAW, |input| input as u32);
        let list = |name: &str, count: f64| -> Result<Vec<f64>, String> {
            (0..count as usize).map(|index| needed(&format!("{name}[{index}]"))).collect()
        };
        Ok(match kind {
            "Linear" => Self::Linear { slope: needed("Slope")?, intercept: needed("Y_Intercept")?, input: input() },
            "Polynomial" => {
                let count = told("Coefficients_Size").unwrap_or(4.0);
                if count > MOST_COEFFICIENTS as f64 {
                    return Err(format!("its scale {number} has more than {MOST_COEFFICIENTS} coefficients"));
                }
                Self::Polynomial { coefficients: list("Coefficients", count)?, input: input() }
            }
            "Table" => {
                let from = list("Pre_Scaled_Values", needed("Pre_Scaled_Values_Size")?)?;
                let to = list("Scaled_Values", needed("Scaled_Values_Size")?)?;
                Self::Table {
                    points: points(&from, &to).map_err(|word| format!("its scale {number} {word}"))?,
                    input: input(),
                }
            }
            "Add" | "Subtract" => {
                let left = needed("Left_Operand_Input_Source")? as u32;
                let right = needed("Right_Operand_Input_Source")? as u32;
                if kind == "Add" { Self::Add(left, right) } else { Self::Subtract(left, right) }
            }
            "AdvancedAPI" => Self::Same(input()),
            other => return Err(format!("its scale is of the kind {}, which is not done", shortened(other))),
        })
    }

    fn inputs(&self) -> Vec<u32> {
        match self {
            Self::Scaler(_) => Vec::new(),
            Self::Same(input)
            | Self::Linear { input, .. }
            | Self::Polynomial { input, .. }
            | Self::Table { input, .. } => vec![*input],
            Self::Add(left, right) | Self::Subtract(left, right) => vec![*left, *right],
        }
    }

    /// Whether what it starts from is there.
    fn check(&self, raw: &Raw) -> Result<(), String> {
        match self {
            Self::Scaler(scale)
                if raw.scalers.iter().all(|(other, values)| other != scale || values.len() != raw.len()) =>
            {
                Err(format!("it has no scale {scale}"))
            }
            _ if self.inputs().contains(&RAW) && !raw.scalers.is_empty() => {
                Err("its scale starts from raw numbers that a DAQmx channel does not have".to_owned())
            }
            _ => Ok(()),
        }
    }

    /// Its numbers over a range, by those of the scales before it.
    fn block(&self, raw: &Raw, range: std::ops::Range<usize>, done: &[Vec<f64>]) -> Vec<f64> {
        let input = |scale: u32| -> &[f64] {
            if scale == RAW { &raw.values[range.clone()] } else { done.get(scale as usize).map_or(&[], Vec::as_slice) }
        };
        let both = |left: u32, right: u32, join: fn(f64, f64) -> f64| -> Vec<f64> {
            input(left).iter().zip(input(right)).map(|(left, right)| join(*left, *right)).collect()
        };
        match self {
            Self::Scaler(scale) => {
                let values = raw.scalers.iter().find(|(other, _)| other == scale);
                values.map_or(Vec::new(), |(_, values)| values[range.clone()].to_vec())
            }
            Self::Same(scale) => input(*scale).to_vec(),
            Self::Linear { slope, intercept, input: scale } => {
                input(*scale).iter().map(|value| value * slope + intercept).collect()
            }
            Self::Polynomial { coefficients, input: scale } => {
                input(*scale).iter().map(|value| polynomial(coefficients, *value)).collect()
            }
            Self::Table { points, input: scale } => input(*scale).iter().map(|value| between(points, *value)).collect(),
            Self::Add(left, right) => both(*left, *right, |left, right| left + right),
            Self::Subtract(left, right) => both(*left, *right, |left, right| right - left),
        }
    }
}

/// By Horner's rule.
fn polynomial(coefficients: &[f64], value: f64) -> f64 {
    let Some((last, others)) = coefficients.split_last() else { return 0.0 };
    others.iter().rev().fold(last + value * 0.0, |sum, coefficient| coefficient + sum * value)
}

/// The points of a table by rising first number.
fn points(from: &[f64], to: &[f64]) -> Result<Vec<[f64; 2]>, &'static str> {
    if from.is_empty() || from.len() != to.len() {
        return Err("is a table whose columns do not match");
    }
    let mut points: Vec<[f64; 2]> = from.iter().zip(to).map(|(from, to)| [*from, *to]).collect();
    let rises = |points: &[[f64; 2]]| points.windows(2).all(|pair| pair[1][0] > pair[0][0]);
    if !rises(&points) {
        points.reverse();
    }
    if rises(&points) { Ok(points) } else { Err("is a table that neither rises nor falls") }
}

#[cfg(test)]
mod tests {
    use super::{Raw, Scaling};
    use crate::recording::formats::tdms::properties::{Properties, Value};

    fn told(pairs: &[(&str, &str, f64)]) -> Properties {
        let value = |text: &str, number: f64| match text {
            "" => Value::Number(number),
            text => Value::Text(text.to_owned()),
        };
        Properties::of(&pairs.iter().map(|(name, text, number)| (*name, value(text, *number))).collect::<Vec<_>>())
    }

    fn scaled(pairs: &[(&str, &str, f64)]) -> Result<Vec<f64>, String> {
        let raw = Raw { values: vec![1.0, 2.0, 4.0], ..Raw::default() };
        let properties = told(pairs);
        Scaling::of([&Properties::default(), &properties].into_iter())?
            .map_or(Ok(raw.values.clone()), |found| found.apply(&raw))
    }

    const RAW: f64 = u32::MAX as f64;

    #[test]
    fn scales_build_on_one_another() {
        let linear = [
            ("NI_Number_Of_Scales", "", 3.0),
            ("NI_Scale[0]_Scale_Type", "Linear", 0.0),
            ("NI_Scale[0]_Linear_Slope", "", 2.0),
            ("NI_Scale[0]_Linear_Y_Intercept", "", 1.0),
            ("NI_Scale[1]_Scale_Type", "Table", 0.0),
            ("NI_Scale[1]_Table_Pre_Scaled_Values_Size", "", 2.0),
            ("NI_Scale[1]_Table_Scaled_Values_Size", "", 2.0),
            ("NI_Scale[1]_Table_Pre_Scaled_Values[0]", "", 9.0),
            ("NI_Scale[1]_Table_Pre_Scaled_Values[1]", "", 1.0),
            ("NI_Scale[1]_Table_Scaled_Values[0]", "", 0.0),
            ("NI_Scale[1]_Table_Scaled_Values[1]", "", 16.0),
            ("NI_Scale[1]_Table_Input_Source", "", 0.0),
            ("NI_Scale[2]_Scale_Type", "Subtract", 0.0),
            ("NI_Scale[2]_Subtract_Left_Operand_Input_Source", "", RAW),
            ("NI_Scale[2]_Subtract_Right_Operand_Input_Source", "", 1.0),
        ];
        // 3, 5, 9 by the first; 12, 8, 0 by the table, which falls; less 1, 2, 4.
        assert_eq!(scaled(&linear).unwrap(), [11.0, 6.0, -4.0]);
        let already = [&linear[..], &[("NI_Scaling_Status", "scaled", 0.0)]].concat();
        assert_eq!(scaled(&already).unwrap(), [1.0, 2.0, 4.0]);
    }

    #[test]
    fn numbers_whose_scale_is_not_done_are_never_raw_ones() {
        for (pairs, words) in [
            (&[("NI_Scale[0]_Scale_Type", "Thermocouple", 0.0)][..], "of the kind Thermocouple, which is not done"),
            (&[("NI_Scale[0]_Scale_Type", "Linear", 0.0)], "its scale 0 lacks Linear_Slope"),
            (&[("NI_Number_Of_Scales", "", 1e9)], "more than 100 scales"),
            (&[("NI_Number_Of_Scales", "", 1.0)], "it has no scale 0"),
            (
                &[
                    ("NI_Scale[0]_Scale_Type", "Add", 0.0),
                    ("NI_Scale[0]_Add_Left_Operand_Input_Source", "", 0.0),
                    ("NI_Scale[0]_Add_Right_Operand_Input_Source", "", RAW),
                ],
                "in a circle",
            ),
        ] {
            let message = scaled(pairs).unwrap_err();
            assert!(message.contains(words), "{message}");
        }
    }
}
