//! A simulated log for those who have none at hand: the page's spring on a bench, pulled slowly through its range and then struck.
//!
//! What moves it is the engine's own chain of windings; what records it has noise and steps. L is that of round wire, whatever the spec takes from the
//! paper. The same seed gives the same text. Next door:
//! a whole rig with its instruments (`coilsense_lab::rig`), which records only one end.

use std::fmt::Write as _;

use coilsense::excitation::Sampled;
use coilsense::inductance::{MaxwellSum, SelfDistance};
use coilsense::sensors::{Readout, ReadoutParameters};
use coilsense::{Damping, EndInput, Error, Excitation, FarEnd, Motion, Mount, Spring, Start};
use coilsense_lab::spec::Spec;
use serde_json::json;

use crate::answer::Answer;

/// Slow pull from the resting length to either side and back \[s\].
const PULL: f64 = 6.0;
/// How many times it is struck, and the straight pieces of each, half a sine.
const HITS: usize = 5;
const PIECES: usize = 8;
/// A strike lasts at most so long \[s\]: a hammer's does.
const SHORT: f64 = 3e-3;
/// Damping where the page's is none, which would never decay \[1\].
const USUAL_RATIO: f64 = 0.005;

/// Name and text of the log of a spec's condition and damping.
///
/// # Errors
/// One line: what the science says.
pub fn trial(spec: &Spec, condition: usize, damping: usize, seed: u64) -> Result<Answer, String> {
    let (Some(asked), Some(case)) = (spec.conditions.get(condition), spec.mount.cases.get(damping)) else {
        return Err(format!("condition {condition}, damping {damping}: is not in the spec"));
    };
    let (damped, told) = match case.ratio {
        Some(0.0) => (Damping::Modal(USUAL_RATIO), format!("ζ = {USUAL_RATIO} (the page's 0 would ring for ever)")),
        // Without the swing of an end mass, which is not there where end 2 is held.
        Some(ratio) => (Damping::Modal(ratio), case.label.clone()),
        None => (case.mount.damping().clone(), case.label.clone()),
    };
    let science = |error: Error| format!("{}: {error}", spec.spring.name);
    let mount = Mount::new(FarEnd::Position, damped).map_err(science)?;
    let bench = Bench::new(&spec.spring.spring, asked.excitation.mean_length());
    let columns =
        bench.record(&mount, &MaxwellSum::new(&bench.spring, SelfDistance::GeometricMean)).map_err(science)?;
    let mut text = format!(
        "# Simulated data: by coilsense {}, spring {}, {told}, seed {seed}; nothing of it was measured\n\
         # end 1 is pulled slowly and then struck {HITS} times at {} mm, the length of {:?}; end 2 is held; each column has noise and steps\n",
        env!("CARGO_PKG_VERSION"),
        spec.spring.name,
        (1e6 * bench.length).round() / 1e3,
        asked.name
    );
    bench.write(columns, seed, &mut text).map_err(science)?;
    let name: String =
        spec.spring.name.chars().map(|c| if c.is_alphanumeric() || c == '_' { c } else { '-' }).collect();
    Ok(Answer::new(&json!({ "name": format!("simulated-{name}.csv"), "text": text }), Vec::new()))
}

/// When what happens, and how large: all in proportion to the spring.
struct Bench {
    spring: Spring,
    /// Of the condition \[m\].
    length: f64,
    rate: f64,
    times: Vec<f64>,
    /// From hit to hit, and how long each lasts \[s\].
    between: f64,
    lasting: f64,
    /// How far one moves end 1 \[m\].
    height: f64,
}

/// A column: title, reading in the title's unit, noise and step in that unit.
struct Column {
    title: &'static str,
    values: Vec<f64>,
    noise: f64,
    step: f64,
}

impl Bench {
    fn new(spring: &Spring, length: f64) -> Self {
        let first = spring.surge_frequency();
        let (between, lasting) = ((100.0 / first).max(0.6), (0.25 / first).min(SHORT));
        // A round rate, so that times have few decimals; ten lines lie below half of it.
        let wanted = 25.0 * first;
        let power = 10f64.powf(wanted.log10().floor());
        let rate = [1.0, 2.0, 5.0, 10.0].map(|times| times * power).into_iter().find(|rate| *rate >= wanted);
        let rate = rate.unwrap_or(wanted);
        let samples = ((PULL + HITS as f64 * between) * rate).ceil() as usize;
        // Struck so hard that the wave carries 3 % of the nominal force, √(km) v.
        let velocity = 0.03 * spring.nominal_force() / (spring.stiffness() * spring.mass()).sqrt();
        Self {
            spring: spring.clone(),
            length,
            rate,
            times: (0..samples).map(|sample| sample as f64 / rate).collect(),
            between,
            lasting,
            height: velocity * lasting / std::f64::consts::PI,
        }
    }

    /// Half sines at end 1, none quite like another.
    fn hits(&self) -> Result<EndInput, Error> {
        let (mut times, mut values) = (Vec::new(), Vec::new());
        for number in 0..HITS {
            let begin = PULL + (number as f64 + 0.1 + 0.013 * (number * number) as f64) * self.between;
            for piece in 0..=PIECES {
                let share = piece as f64 / PIECES as f64;
                let height = self.height * (1.0 - 0.1 * number as f64);
                times.push(begin + share * self.lasting);
                values.push(if piece == PIECES { 0.0 } else { height * (std::f64::consts::PI * share).sin() });
            }
        }
        Ok(EndInput::Sampled(Sampled::new(times, values)?))
    }

    /// How much longer the spring is in the slow pull \[m\]: to both sides within 60 % of its range, one whole period of a sine that begins and
    /// ends gently.
    fn pulled(&self, time: f64) -> f64 {
        if time >= PULL {
            return 0.0;
        }
        let (shortest, longest) = self.spring.operating_range();
        let room = 0.6 * (longest - shortest);
        let (above, below) = (room.min(longest - self.length).max(0.0), room.min(self.length - shortest).max(0.0));
        let (turn, envelope) = (2.0 * time / PULL - 1.0, (std::f64::consts::PI * time / PULL).sin());
        let swing = (std::f64::consts::PI * turn).sin() * envelope;
        // The largest of sin(πx) cos(πx/2) is 0.77.
        swing / 0.77 * if swing > 0.0 { above } else { below }
    }

    /// Hits by the chain of windings; the pull, slow against its waves, at rest from moment to moment.
    fn record(&self, mount: &Mount, coil: &MaxwellSum) -> Result<[Column; 5], Error> {
        let excitation = Excitation::new(self.length, self.hits()?, EndInput::Held, Start::Rest)?;
        let motion = Motion::mounted(&self.spring, mount, &excitation)?;
        let (ends, forces) = (motion.ends(&self.times)?, motion.end_forces(&self.times)?);
        let pulled: Vec<f64> = self.times.iter().map(|time| self.pulled(*time)).collect();
        let more = |forces: Vec<f64>| -> Vec<f64> {
            let added =
                |extra: &f64| self.spring.static_force(self.length + extra) - self.spring.static_force(self.length);
            forces.iter().zip(&pulled).map(|(force, extra)| force + added(extra)).collect()
        };
        let u1: Vec<f64> = ends.iter().zip(&pulled).map(|([u1, _], extra)| u1 - extra).collect();
        let u2: Vec<f64> = ends.iter().map(|[_, u2]| *u2).collect();
        let lengths: Vec<f64> = u1.iter().zip(&u2).map(|(u1, u2)| u2 - u1).collect();
        let henries = coil.at_lengths(&lengths);
        let scale = |values: Vec<f64>, factor: f64| values.into_iter().map(|value| factor * value).collect();
        let (shortest, longest) = self.spring.operating_range();
        let range = 1e3 * (longest - shortest).max(0.01 * longest);
        let force = 1.5 * self.spring.nominal_force().abs();
        let size = 1e6 * henries.first().copied().unwrap_or(1e-6);
        let (input, output) = (more(forces.input), more(forces.output));
        let column = |title, values, noise, step| Column { title, values, noise, step: power_below(step) };
        Ok([
            column("u1 [mm]", scale(u1, 1e3), 3e-5 * range, 3e-5 * range),
            column("u2 [mm]", scale(u2, 1e3), 3e-5 * range, 3e-5 * range),
            column("F_i [N]", input, 2e-4 * force, force / 32768.0),
            column("F_o [N]", output, 2e-4 * force, force / 32768.0),
            column("L [uH]", scale(henries, 1e6), 2e-4 * size, 1e-4 * size),
        ])
    }

    /// The columns as text, with noise of their own and in their steps.
    fn write(&self, columns: [Column; 5], seed: u64, text: &mut String) -> Result<(), Error> {
        let mut shown = Vec::new();
        for (number, Column { title, values, noise, step }) in columns.into_iter().enumerate() {
            let digits = ReadoutParameters { noise, resolution: Some(step), ..Default::default() };
            let values = Readout::new(digits)?.series(&self.times, &values, seed.wrapping_mul(31) + number as u64)?;
            let decimals = (-step.log10()).round().max(0.0) as usize;
            shown.push((title, values, decimals));
        }
        let titles: Vec<&str> = shown.iter().map(|(title, ..)| *title).collect();
        // Writing to a String cannot fail.
        let _ = writeln!(text, "time [s],{}", titles.join(","));
        let places = (2.0 * self.rate).log10().ceil().max(0.0) as usize;
        for (row, time) in self.times.iter().enumerate() {
            let _ = write!(text, "{time:.places$}");
            for (_, values, decimals) in &shown {
                let _ = write!(text, ",{:.decimals$}", values[row]);
            }
            text.push('\n');
        }
        Ok(())
    }
}

/// The power of ten at or below a size.
fn power_below(size: f64) -> f64 {
    10f64.powf(size.log10().floor())
}
