//! The table `[control]`: the force loop of `coilsense placement`.
//!
//! Next door: what it means (`coilsense::control`), what is asked of it (`crate::placement`).

use coilsense::control::{Drive, Environment, Gains};
use coilsense::{FarEnd, Spring};

use super::SpecError;
use super::document::Document;
use super::mount::MountSpec;
use super::section::Section;
use crate::quantity::Dimension;

/// A drive, a controller's shape, and what end 2 meets.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ControlSpec {
    /// What moves end 1.
    pub drive: Drive,
    /// Gains for a proportional gain of 1.
    pub shape: Gains,
    /// The crossover wanted, with a spring without mass \[Hz\].
    pub crossover: Option<f64>,
    /// From force to command \[s\].
    pub delay: f64,
    /// Of the controller \[s\]; `None` where it is continuous.
    pub sample_time: Option<f64>,
    /// What end 2 meets.
    pub environment: Environment,
    /// Up to where the rendered impedance is looked at \[Hz\].
    pub passive_up_to: f64,
}

/// Where the derivative's filter sits: T_D/10.
const DERIVATIVE_FILTER: f64 = 10.0;

impl ControlSpec {
    pub(super) fn parse(
        document: &Document<'_>,
        spring: &Spring,
        mount: &MountSpec,
    ) -> Result<Option<Self>, SpecError> {
        let Some(section) = document.optional_section("control")? else {
            return Ok(None);
        };
        let drive = drive(&section)?;
        let sample_time = section.above_zero("sample_time", Dimension::Time)?;
        let delay = section.not_negative("delay", Dimension::Time)?.unwrap_or(0.0);
        if let Some(step) = sample_time {
            check_samples(&section, spring, step, delay)?;
        }
        let crossover = section.above_zero("crossover", Dimension::Frequency)?;
        let passive_up_to = section.above_zero("passive_up_to", Dimension::Frequency)?;
        let least = 2e-3 * spring.surge_frequency();
        if let Some(up_to) = passive_up_to {
            section.check("passive_up_to", up_to > least, up_to, &format!("above {least:.3} Hz"))?;
        }
        Ok(Some(Self {
            drive,
            shape: shape(&section, &drive)?,
            crossover,
            delay,
            sample_time,
            environment: environment(&section, mount)?,
            passive_up_to: passive_up_to.unwrap_or(spring.surge_frequency()),
        }))
    }
}

fn drive(section: &Section<'_>) -> Result<Drive, SpecError> {
    let word = section.word("drive", &["velocity", "force"])?;
    section.only_of(word, &format!("a drive that is \"{word}\""))?;
    let bandwidth = section.above_zero("drive_bandwidth", Dimension::Frequency)?;
    if word == "velocity" {
        return Ok(Drive::Velocity { bandwidth });
    }
    let mass = section.positive("motor_mass", Dimension::Mass)?;
    let friction = section.not_negative("motor_friction", Dimension::Friction)?.unwrap_or(0.0);
    Ok(Drive::Force { mass, friction, bandwidth })
}

fn shape(section: &Section<'_>, drive: &Drive) -> Result<Gains, SpecError> {
    let usual = if matches!(drive, Drive::Velocity { .. }) { "P" } else { "PI" };
    let controller = section.optional_word("controller", &["P", "PI", "PID"])?.unwrap_or(usual);
    let integral_time = section.above_zero("integral_time", Dimension::Time)?;
    let derivative_time = section.above_zero("derivative_time", Dimension::Time)?;
    for (key, given, letter) in [("integral_time", integral_time, 'I'), ("derivative_time", derivative_time, 'D')] {
        if given.is_some() && !controller.contains(letter) {
            return Err(
                section.refuse(key, format!("goes with a controller that has {letter}, not with \"{controller}\""))
            );
        }
    }
    let feed_forward = section.optional_number("feed_forward")?.unwrap_or(0.0);
    section.check("feed_forward", (0.0..=10.0).contains(&feed_forward), feed_forward, "from 0 to 10")?;
    let mut gains = Gains {
        proportional: 1.0,
        feed_forward,
        observer_bandwidth: section.above_zero("observer_bandwidth", Dimension::Frequency)?,
        ..Gains::default()
    };
    if controller.contains('I') {
        gains.integral = 1.0 / integral_time.unwrap_or(0.1);
    }
    if controller.contains('D') {
        let time = derivative_time.unwrap_or(10e-3);
        gains.derivative = time;
        gains.derivative_bandwidth = Some(DERIVATIVE_FILTER / (std::f64::consts::TAU * time));
    }
    Ok(gains)
}

/// A sampled loop sees the first surge line, and is late by whole steps.
fn check_samples(section: &Section<'_>, spring: &Spring, step: f64, delay: f64) -> Result<(), SpecError> {
    let most = 0.5 / spring.surge_frequency();
    let allowed = format!("below {most:.4e} s, half a surge period, or its line cannot be told from another");
    section.check("sample_time", step < most, step, &allowed)?;
    let steps = delay / step;
    let whole = (steps - steps.round()).abs() <= 1e-6 && steps <= 1e4;
    section
        .check("delay", whole, delay, &format!("a whole number, up to 10 000, of sample times of {step} s"))
        .map(|_| ())
}

fn environment(section: &Section<'_>, mount: &MountSpec) -> Result<Environment, SpecError> {
    let mass = section.not_negative("load_mass", Dimension::Mass)?;
    let damping = section.not_negative("load_damping", Dimension::Friction)?;
    let stiffness = section.not_negative("load_stiffness", Dimension::Stiffness)?;
    if mass.is_some() || damping.is_some() || stiffness.is_some() {
        let [mass, damping, stiffness] = [mass, damping, stiffness].map(|value| value.unwrap_or(0.0));
        return Ok(Environment::Impedance { mass, damping, stiffness });
    }
    match mount.far_end() {
        FarEnd::Position => Ok(Environment::Held),
        FarEnd::Mass(mass) => Ok(Environment::Impedance { mass, damping: 0.0, stiffness: 0.0 }),
        FarEnd::Force => {
            let allowed = "what end 2 meets must be given where [mount] end2 is \"force\": a load without mass takes no force of the loop";
            Err(section.missing("load_mass", allowed))
        }
    }
}
