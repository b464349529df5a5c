//! A cam as harmonics of its turn.
//!
//! Next door: laws and files (the parent).

use std::f64::consts::TAU;

use toml::de::DeValue;

use super::super::SpecError;
use super::super::section::Section;
use super::CamSpec;
use crate::quantity::Dimension;

/// Most harmonics, and the highest.
const MOST: usize = 64;
/// Pieces for a turn of the highest harmonic: to the eighth power a span of π/16 leaves out 1e-12 of it.
const PIECES: usize = 32;
/// Samples for a turn of the highest harmonic, among which the least lift is looked for, and how often it is then improved.
const SAMPLES: usize = 32;
const NEWTON: usize = 8;

/// One of them.
#[derive(Clone, Copy)]
struct Wave {
    number: f64,
    amplitude: f64,
    phase: f64,
}

impl Wave {
    /// Derivative of an order by the turn.
    fn derivative(&self, order: i32, turn: f64) -> f64 {
        let angular = TAU * self.number;
        let quarter = 0.25 * TAU * f64::from(order);
        self.amplitude * angular.powi(order) * (angular * turn + self.phase + quarter).cos()
    }
}

/// Σ A_n cos(n θ + φ_n), counted from its least.
pub(super) fn of_harmonics(section: &Section<'_>, length: f64) -> Result<CamSpec, SpecError> {
    let expected = || {
        format!(
            "a list of 1 to {MOST} lists of number, amplitude and phase, such as [[1, \"4 mm\", \"180 deg\"], [2, \"1 mm\"]], numbers from 1 to {MOST} and none twice"
        )
    };
    let waves = section.read("harmonics", waves, expected)?.ok_or_else(|| section.missing("harmonics", &expected()))?;
    let highest = waves.iter().map(|wave| wave.number as usize).max().unwrap_or(1);
    let lift = |order: i32, turn: f64| waves.iter().map(|wave| wave.derivative(order, turn)).sum::<f64>();
    let extreme = |sign: f64| {
        let places = (0..SAMPLES * highest).map(|sample| sample as f64 / (SAMPLES * highest) as f64);
        let found = places.min_by(|a, b| (sign * lift(0, *a)).total_cmp(&(sign * lift(0, *b)))).unwrap_or(0.0);
        (0..NEWTON).fold(found, |turn, _| {
            let next = turn - lift(1, turn) / lift(2, turn);
            // A flat extreme is not improved by this.
            if (next - turn).abs() < 1.0 / (SAMPLES * highest) as f64 { next } else { turn }
        })
    };
    let (least_at, largest_at) = (extreme(1.0), extreme(-1.0));
    let least = lift(0, least_at);
    let count = PIECES * highest;
    let begins: Vec<f64> = (0..count).map(|piece| piece as f64 / count as f64).collect();
    let piece = |begin: &f64| {
        let mut factorial = 1.0;
        let power = |order: i32| {
            factorial *= f64::from(order).max(1.0);
            lift(order, *begin) / factorial - if order == 0 { least } else { 0.0 }
        };
        (0..=8).map(power).collect()
    };
    let pieces = begins.iter().map(piece).collect();
    let words = match waves.len() {
        1 => format!("harmonic {highest} alone"),
        count => format!("{count} harmonics up to number {highest}"),
    };
    Ok(CamSpec {
        begins,
        pieces,
        lift: lift(0, largest_at) - least,
        length,
        least_at: least_at.rem_euclid(1.0),
        words,
        rows: None,
    })
}

fn waves(value: &DeValue<'_>) -> Option<Vec<Wave>> {
    let rows = value.as_array()?;
    let waves: Vec<Wave> = rows.iter().map(|row| wave(row.get_ref())).collect::<Option<_>>()?;
    let are_different = |index: usize| waves[..index].iter().all(|other| other.number != waves[index].number);
    ((1..=MOST).contains(&waves.len()) && (0..waves.len()).all(are_different)).then_some(waves)
}

fn wave(row: &DeValue<'_>) -> Option<Wave> {
    let row = row.as_array()?;
    let quantity = |index: usize, dimension: Dimension| {
        let text = row.get(index)?.get_ref().as_str()?;
        dimension.parse(text).filter(|value| value.is_finite())
    };
    let number = match row.first()?.get_ref() {
        DeValue::Integer(integer) => usize::from_str_radix(integer.as_str(), integer.radix()).ok()?,
        _ => return None,
    };
    let phase = if row.len() == 3 { quantity(2, Dimension::Angle)? } else { 0.0 };
    let amplitude = quantity(1, Dimension::Length)?;
    let holds = (1..=MOST).contains(&number) && row.len() <= 3 && amplitude != 0.0;
    holds.then_some(Wave { number: number as f64, amplitude, phase })
}
