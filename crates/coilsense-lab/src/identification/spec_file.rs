//! What was identified as a spec that `coilsense analyze` reads.
//!
//! Next door: the reader of specs (`crate::spec`), what was identified (the parent).

use std::fmt::Write;

use coilsense::Channel;
use coilsense::identify::{ModeSeries, Part};

use super::{Identified, interval};

/// What no record of forces and positions tells.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Coil {
    /// N.
    pub windings: f64,
    /// r \[m\], to the wire's centre.
    pub coil_radius: f64,
    /// ρ \[m\].
    pub wire_radius: f64,
}

/// What is missing for a spec.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[error("a spec cannot be written: {0}")]
pub struct SpecFileError(String);

/// Least share of the shortest length by which it is widened where the length hardly moved.
const WIDENED: f64 = 0.01;

/// The spec: spring and damping as identified, a blow as strong as the record's strongest, both load cells and the deflection with their noise.
///
/// # Errors
/// [`SpecFileError`] where stiffness, length or first mode is not known.
pub fn spec_file(identified: &Identified, coil: &Coil) -> Result<String, SpecFileError> {
    let found = &identified.found;
    let line = found.stiffness.as_ref().map_err(|reason| SpecFileError(reason.clone()))?;
    let missing = |what: &str| SpecFileError(what.to_owned());
    if !line.both_positions {
        return Err(missing(
            "only one end's position was recorded, so no length is known; for an end that is held give its position, such as --constant u2=\"150 mm\"",
        ));
    }
    let first = found.first_frequency.ok_or_else(|| missing("no mode of the spring was found"))?;
    // Of a continuous coil: however many masses stand for a winding, they come to its first frequency.
    let held = found.mass.ok_or_else(|| missing("no mode of the spring was found"))?;
    let mass = held.scaled(line.value() / (4.0 * first.value * first.value) / held.value);
    let time = found.transit_time.ok_or_else(|| missing("no mode of the spring was found"))?;
    let rest = line.length_at_zero;
    if !(rest.value > 0.0 && line.range.0 > 0.0) {
        return Err(missing("the recorded positions make lengths below zero"));
    }
    let room = (WIDENED * line.range.0 - (line.range.1 - line.range.0)).max(0.0);
    let (shortest, longest) = (line.range.0 - 0.5 * room, line.range.1 + 0.5 * room);
    let mut text = String::new();
    // Writing to a String cannot fail.
    let _ =
        writeln!(text, "# Identified by coilsense {} from {}.", env!("CARGO_PKG_VERSION"), file_name(&identified.file));
    if identified.simulated.is_some() {
        let _ = writeln!(text, "# The log is of simulated data.");
    }
    let _ = writeln!(text, "# Verdict: {}. ± is half of a 95 % interval.", found.verdict.answer.name());
    let _ = writeln!(
        text,
        "# First mode with both ends held: {} Hz, transit time {} ms.",
        interval(&first, 1.0),
        interval(&time, 1e3)
    );
    let _ = writeln!(text, "\n[spring]\nname = \"identified\"");
    let _ = writeln!(text, "model = \"chain\"           # its mass is the one that gives the measured first frequency");
    let _ = writeln!(text, "rest_length = \"{:.7} m\"  # {} mm", rest.value, interval(&rest, 1e3));
    let _ = writeln!(text, "min_length = \"{shortest:.6} m\"   # the range of the log");
    let _ = writeln!(text, "max_length = \"{longest:.6} m\"");
    let _ = writeln!(text, "windings = {}            # given", coil.windings);
    let _ = writeln!(text, "coil_radius = \"{} m\"     # given", coil.coil_radius);
    let _ = writeln!(text, "wire_radius = \"{} m\"     # given", coil.wire_radius);
    let _ = writeln!(text, "mass = \"{:.8} kg\"        # {} g", mass.value, interval(&mass, 1e3));
    let _ = writeln!(text, "stiffness = \"{:.6} N/m\"  # {} N/m", line.value(), interval(&line.stiffness, 1.0));
    let tolerance = (100.0 * line.stiffness.expanded / line.value()).max(1e-6);
    let _ = writeln!(text, "stiffness_tolerance = \"{tolerance:.6} %\"");
    let _ = writeln!(text, "\n[mount]");
    match (found.mode_series, found.end_mass) {
        (Some(ModeSeries::EndMass { .. }), Some(mass)) => {
            let _ = writeln!(text, "end2 = \"mass\"\nend_mass = \"{mass:.6} kg\"");
        }
        (Some(ModeSeries::HeldFree), _) => {
            let _ = writeln!(text, "end2 = \"force\"");
        }
        _ => {
            let _ = writeln!(text, "end2 = \"held\"");
        }
    }
    if let Some(ratio) = found.ratio {
        let _ = writeln!(text, "damping_ratio = {:.6}    # {}, of the lowest mode", ratio.value, interval(&ratio, 1.0));
    }
    blow(&mut text, identified, 0.5 * (shortest + longest));
    sensors(&mut text, identified);
    let _ = writeln!(text, "\n[goal]\nerror = \"1 %\"            # chosen");
    Ok(text)
}

/// A blow whose first mode is as strong as the record's strongest: a uniform v makes a square wave of v√(km), its first harmonic 4/π of it.
fn blow(text: &mut String, identified: &Identified, length: f64) {
    let found = &identified.found;
    let amplitude = found.lines.iter().find(|line| line.mode() == Some(1)).map_or(0.0, |line| line.amplitude);
    let impedance = match (&found.stiffness, found.mass) {
        (Ok(line), Some(mass)) => (line.value() * mass.value).sqrt(),
        _ => f64::INFINITY,
    };
    let velocity = (std::f64::consts::FRAC_PI_4 * amplitude / impedance).max(1e-3);
    let _ = writeln!(
        text,
        "\n[[condition]]\nname = \"blow\"\nkind = \"impact\"           # as strong as the strongest in the log\nlength = \"{length:.6} m\"\n\
         velocity = \"{velocity:.4} m/s\"\nduration = \"1 s\"\nsample_rate = \"10 kHz\""
    );
}

/// What was recorded, with its noise.
fn sensors(text: &mut String, identified: &Identified) {
    let found = &identified.found;
    // Nine digits: the rate is the mean of rounded times.
    let rate = (1e6 * found.sampling.rate).round() / 1e6;
    let noise =
        found.noise.iter().find(|(part, _)| !matches!(part, Part::Sum)).map_or(0.0, |(part, noise)| match part {
            // Half the difference of two independent sensors has 1/√2 of one's noise.
            Part::Difference => std::f64::consts::SQRT_2 * noise,
            _ => *noise,
        });
    let largest = match &found.stiffness {
        Ok(line) => line.forces.iter().fold(0.0_f64, |largest, force| largest.max(force.abs())),
        Err(_) => 0.0,
    };
    let range = 1.5 * largest.max(1e-3);
    for (channel, end) in [(Channel::InputForce, 1), (Channel::OutputForce, 2)] {
        if identified.signals.channel(channel).is_ok() {
            let _ = writeln!(
                text,
                "\n[[sensor]]\nname = \"load cell at end {end}\"\nkind = \"load-cell\"\nend = {end}\nrange = \"{range:.4} N\"\nsample_rate = \"{rate} Hz\"\n\
                 noise = \"{noise:.6} N\"       # as in the log"
            );
        }
    }
    let _ = writeln!(
        text,
        "\n[[sensor]]\nname = \"length by positions\"\nkind = \"deflection\"\nsample_rate = \"{rate} Hz\""
    );
}

fn file_name(path: &str) -> &str {
    path.rsplit(['/', '\\']).next().unwrap_or(path)
}
