//! The motions on which candidates are judged: each condition on the nominal spring and on every corner of the box, under every damping.
//!
//! Next door: what is read off them (`judge`).

use coilsense::excitation::{EndInput, Start};
use coilsense::mitigation::ToleranceBox;
use coilsense::signals::sampled_window;
use coilsense::{Damping, Error, Excitation, FarEnd, Motion, Mount, Spring};
use coilsense_rt::Measured;

use super::candidate::Truth;
use super::recorded::Recorded;
use super::sources::corner_label;
use super::study::Study;

/// One motion as a controller samples it, without noise.
pub(super) struct Run {
    /// Which it is: condition, spring, damping.
    pub label: String,
    /// F_i, u1, u2.
    pub measured: Vec<Measured<f64>>,
    /// F_o \[N\].
    output: Vec<f64>,
    /// k (u2 − u1 − l0) of the spring that moves \[N\].
    still: Vec<f64>,
    /// What a controller reads before it begins.
    pub at_rest: Measured<f64>,
}

impl Run {
    fn of(label: String, motion: &Motion, rate: f64, duration: f64) -> Result<Self, Error> {
        let times = sampled_window(rate, 0.0, duration)?;
        let forces = motion.end_forces(&times)?;
        let ends = motion.ends(&times)?;
        let spring = motion.spring();
        let still: Vec<f64> = ends.iter().map(|[first, second]| spring.static_force(second - first)).collect();
        let at_rest = Measured { force: still[0], ends: ends[0] };
        let each = forces.input.iter().zip(&ends);
        let measured = each.map(|(force, ends)| Measured { force: *force, ends: *ends }).collect();
        Ok(Self { label, measured, output: forces.output, still, at_rest })
    }

    /// A log, held against the nominal spring's k·Δl, and against F_o where it was recorded.
    pub fn recorded(study: &Study, log: &Recorded) -> Self {
        let length = |measured: &Measured<f64>| measured.ends[1] - measured.ends[0];
        Self {
            label: log.name.clone(),
            measured: log.measured.clone(),
            output: log.output.clone().unwrap_or_default(),
            still: log.measured.iter().map(|measured| study.spring.static_force(length(measured))).collect(),
            at_rest: log.measured[0],
        }
    }

    /// What is true.
    pub fn truth(&self, truth: Truth) -> &[f64] {
        match truth {
            Truth::Static => &self.still,
            Truth::Output => &self.output,
        }
    }

    /// Largest |F_i − k·Δl| \[N\], an offset left out.
    pub fn ringing(&self) -> f64 {
        self.difference().into_iter().fold(0.0, f64::max)
    }

    /// At which sample that is.
    pub fn loudest(&self) -> usize {
        let each = self.difference().into_iter().enumerate();
        each.max_by(|a, b| a.1.total_cmp(&b.1)).map_or(0, |(index, _)| index)
    }

    /// |F_i − k·Δl| \[N\], an offset left out.
    fn difference(&self) -> Vec<f64> {
        let difference = || self.measured.iter().zip(&self.still).map(|(measured, still)| measured.force - still);
        let offset = difference().sum::<f64>() / self.measured.len() as f64;
        difference().map(|force| (force - offset).abs()).collect()
    }

    /// Rms of k·Δl about its mean \[N\].
    pub fn motion(&self) -> f64 {
        let count = self.still.len() as f64;
        let mean = self.still.iter().sum::<f64>() / count;
        (self.still.iter().map(|force| (force - mean).powi(2)).sum::<f64>() / count).sqrt()
    }
}

/// Every condition on the nominal spring under the nominal damping; or the log.
pub(super) fn nominal(study: &Study) -> Result<Vec<Run>, Error> {
    if let Some(recorded) = &study.recorded {
        return Ok(vec![Run::recorded(study, recorded)]);
    }
    let damping = &study.dampings[study.nominal_damping];
    study.conditions.iter().map(|condition| run(study, condition, &study.spring, damping, "nominal")).collect()
}

/// Every condition on every spring of the box under every damping, the nominal ones among them; or the log.
pub(super) fn over_the_box(study: &Study) -> Result<Vec<Run>, Error> {
    if let Some(recorded) = &study.recorded {
        return Ok(vec![Run::recorded(study, recorded)]);
    }
    let mut runs = Vec::new();
    for corner in study.tolerances.corners() {
        let spring = ToleranceBox::changed(&study.spring, corner)?;
        let label = corner_label(corner);
        for damping in &study.dampings {
            for condition in &study.conditions {
                runs.push(run(study, condition, &spring, damping, &label)?);
            }
        }
    }
    Ok(runs)
}

fn run(
    study: &Study,
    condition: &(String, Excitation, f64),
    spring: &Spring,
    damping: &(String, Damping),
    label: &str,
) -> Result<Run, Error> {
    let mount = Mount::new(study.far_end, damping.1.clone())?;
    let motion = Motion::mounted(spring, &mount, &condition.1)?;
    Run::of(format!("{}, {label}, {}", condition.0, damping.0), &motion, study.rate, condition.2)
}

/// An impact alone, at the velocity that rings as much as the study's conditions do, ends held.
pub(super) fn impact(study: &Study, velocity: f64) -> Result<Run, Error> {
    let excitation = Excitation::impact(study.spring.mid_length(), velocity)?;
    alone(study, &excitation, 100.0 / study.spring.surge_frequency())
}

/// A slow motion at `frequency` of 1 % of the length in use, without a shock; four periods.
pub(super) fn swing(study: &Study, frequency: f64) -> Result<Run, Error> {
    let (shortest, longest) = study.spring.operating_range();
    let input = EndInput::harmonic(0.01 * (longest - shortest), frequency, 0.0);
    let excitation = Excitation::new(study.spring.mid_length(), input, EndInput::Held, Start::Massless)?;
    alone(study, &excitation, 4.0 / frequency)
}

fn alone(study: &Study, excitation: &Excitation, duration: f64) -> Result<Run, Error> {
    let mount = Mount::new(FarEnd::Position, study.dampings[study.nominal_damping].1.clone())?;
    let motion = Motion::mounted(&study.spring, &mount, excitation)?;
    Run::of(String::new(), &motion, study.rate, duration)
}
