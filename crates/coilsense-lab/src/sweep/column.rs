//! What is recorded of a design, by a word: `mass`, `F_o.rmsd`, `F_L.max[heel strike]`, `worst`, `laser.combined`.
//!
//! Next door: how it is computed (`row`), which work that needs (`Needs`).

use coilsense::{Channel, neighbours};

use super::SweepError;
use crate::likeness::nearest;
use crate::spec::Core;

/// What kind of values a column holds.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Kind {
    Whole,
    Numbers,
    Texts,
    Flags,
}

/// A column of results.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Column {
    /// A number of the spring alone.
    Spring(&'static SpringNumber),
    /// How far a force is off, in % of F_nom; of one condition, or of the worst.
    Force { force: usize, measure: Measure, condition: Option<usize> },
    /// The condition in which the RMSD of a force is largest.
    WorstOf { force: usize },
    /// The condition in which any RMSD that is asked for is largest.
    Worst,
    /// How F_L was found: `second-order`, `exact`, `mixed`.
    Method { condition: Option<usize> },
    /// The largest stated bound of L's error, as a share of L.
    Bound { condition: Option<usize> },
    /// The smallest distance of neighbouring windings from t = 0 on, and the same less that at which they touch \[m\].
    Pitch { clearance: bool },
    /// What an analysis says of a sensor.
    Sensor { sensor: usize, of: OfSensor },
}

/// A measure of how far a force is off.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Measure {
    Rmsd,
    /// The largest, either way.
    Maximum,
    /// The mean.
    Bias,
}

/// What the analysis says of a sensor.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum OfSensor {
    /// Combined standard uncertainty of the worst case, % of F_nom.
    Combined,
    /// Whether it meets the goal.
    Meets,
    /// How late it is \[s\].
    Lag,
}

/// A number of a spring: its word, its unit, and how it is had.
#[derive(Debug, Clone, Copy)]
pub(super) struct SpringNumber {
    pub word: &'static str,
    unit: &'static str,
    pub of: fn(&Core) -> f64,
}

impl PartialEq for SpringNumber {
    fn eq(&self, other: &Self) -> bool {
        self.word == other.word
    }
}

const fn number(word: &'static str, unit: &'static str, of: fn(&Core) -> f64) -> SpringNumber {
    SpringNumber { word, unit, of }
}

/// Every number of a spring that can be asked for.
const OF_SPRING: [SpringNumber; 19] = [
    number("stiffness", "N/m", |core| core.spring.spring.stiffness()),
    number("mass", "kg", |core| core.spring.mass),
    number("windings", "1", |core| core.spring.spring.windings()),
    number("wire_diameter", "m", |core| core.spring.spring.wire_diameter()),
    number("coil_diameter", "m", |core| 2.0 * core.spring.spring.coil_radius()),
    number("index", "1", |core| core.spring.spring.coil_radius() / core.spring.spring.wire_radius()),
    number("rest_length", "m", |core| core.spring.closed_length),
    number("solid_length", "m", |core| core.spring.solid_length()),
    number("travel", "m", |core| core.spring.spring.operating_range().1 - core.spring.spring.operating_range().0),
    number("f1", "Hz", |core| core.spring.spring.surge_frequency()),
    number("model_f1", "Hz", |core| core.spring.spring.chain_frequency()),
    number("masses_per_winding", "1", |core| core.spring.spring.masses_per_winding() as f64),
    number("tau", "s", |core| core.spring.spring.transit_time()),
    number("nominal_force", "N", |core| core.spring.spring.nominal_force()),
    number("wave_impedance", "N s/m", |core| of_uniform(core, core.spring.spring.wave_impedance())),
    number("stress", "Pa", |core| core.spring.corrected_shear_stress(core.spring.spring.nominal_force())),
    number("f_lateral", "Hz", |core| of_uniform(core, lateral(core).unwrap_or(f64::NAN))),
    number("f_torsional", "Hz", |core| {
        column(core, core.spring.spring.mid_length()).map_or(f64::NAN, |it| of_uniform(core, it.torsional()))
    }),
    number("buckling", "1", |core| of_uniform(core, f64::from(u8::from(lateral(core).is_none())))),
];

/// What is known of a uniform coil only: NaN of one of sections.
fn of_uniform(core: &Core, value: f64) -> f64 {
    if core.spring.dead_ends.is_some() { f64::NAN } else { value }
}

/// The coil as a column at a length, by formula: a sweep has no time for the helix.
fn column(core: &Core, length: f64) -> Option<neighbours::Column> {
    let spring = &core.spring;
    neighbours::Column::new(
        &spring.rod().ok()?,
        spring.geometry.active_span(length),
        spring.spring.static_force(length),
    )
    .ok()
}

/// Its lowest lateral frequency at either end of the range \[Hz\], with ends as loose as they may be; `None` where it has buckled.
fn lateral(core: &Core) -> Option<f64> {
    let (shortest, longest) = core.spring.spring.operating_range();
    let at = |length: f64| {
        let column = column(core, length)?;
        if core.mount.ends.may_tilt() { column.pinned() } else { column.clamped() }
    };
    Some(at(shortest)?.min(at(longest)?))
}

const MEASURES: [(&str, Measure); 3] = [("rmsd", Measure::Rmsd), ("max", Measure::Maximum), ("bias", Measure::Bias)];
const OF_SENSOR: [(&str, OfSensor); 3] =
    [("combined", OfSensor::Combined), ("meets", OfSensor::Meets), ("lag", OfSensor::Lag)];

/// F_L among [`Channel::FORCES`].
pub(super) const BY_INDUCTANCE: usize = 3;
/// What a sweep calls what needs a motion, where it refuses it.
pub(super) const MOVES: &str = "a sweep of forces";

/// Which work some columns need.
#[derive(Debug, Clone, PartialEq, Default)]
pub(super) struct Needs {
    /// Forces at the ends and by the ends' positions, each of [`Channel::FORCES`].
    pub forces: [bool; 4],
    /// Positions from t = 0 on.
    pub pitch: bool,
    /// What sensors read, those of these numbers in the spec.
    pub sensors: Vec<usize>,
}

impl Needs {
    /// Whether anything moves for it.
    pub fn motion(&self) -> bool {
        self.forces.contains(&true) || self.pitch || !self.sensors.is_empty()
    }
}

/// Names of a spec that columns may call.
pub(super) struct Names {
    pub conditions: Vec<String>,
    pub sensors: Vec<String>,
    /// How many springs there are.
    pub springs: usize,
}

impl Column {
    /// Reads a column's word.
    pub fn parse(text: &str, names: &Names) -> Result<Self, SweepError> {
        let column = Self::read(text, names)?;
        if names.springs > 1 && !column.is_of_all() {
            let allowed = "is of one spring, and the spec has several; allowed: F_i, F_o and F_x of all, worst";
            return Err(SweepError::new(format!("column {}: {allowed}", text.trim())));
        }
        Ok(column)
    }

    /// Whether it can be told of several springs together.
    fn is_of_all(&self) -> bool {
        match self {
            Self::Force { force, .. } | Self::WorstOf { force } => *force != BY_INDUCTANCE,
            Self::Worst => true,
            Self::Spring(_) | Self::Method { .. } | Self::Bound { .. } | Self::Pitch { .. } | Self::Sensor { .. } => {
                false
            }
        }
    }

    fn read(text: &str, names: &Names) -> Result<Self, SweepError> {
        let text = text.trim();
        let (word, condition) = match text.strip_suffix(']').and_then(|text| text.rsplit_once('[')) {
            Some((word, name)) => (word.trim(), Some(found(&names.conditions, "condition", name)?)),
            None => (text, None),
        };
        if let Some(column) = of_force(word, condition) {
            return Ok(column);
        }
        if condition.is_some() {
            return Err(SweepError::new(format!("column {text}: only forces can be asked for by condition")));
        }
        if let Some(number) = OF_SPRING.iter().find(|number| number.word == word) {
            return Ok(Self::Spring(number));
        }
        match word {
            "worst" => return Ok(Self::Worst),
            "closest_pitch" => return Ok(Self::Pitch { clearance: false }),
            "clearance" => return Ok(Self::Pitch { clearance: true }),
            _ => {}
        }
        if let Some((name, what)) = word.rsplit_once('.')
            && let Some((_, of)) = OF_SENSOR.iter().find(|(known, _)| *known == what)
        {
            let name = name.strip_prefix("sensor.").unwrap_or(name);
            return Ok(Self::Sensor { sensor: found(&names.sensors, "sensor", name)?, of: *of });
        }
        Err(unknown(text))
    }

    /// Which work it needs.
    pub fn add_to(&self, needs: &mut Needs) {
        match self {
            Self::Spring(_) | Self::Worst => {}
            Self::Force { force, .. } | Self::WorstOf { force } => needs.forces[*force] = true,
            Self::Method { .. } | Self::Bound { .. } => needs.forces[BY_INDUCTANCE] = true,
            Self::Pitch { .. } => needs.pitch = true,
            Self::Sensor { sensor, .. } if needs.sensors.contains(sensor) => {}
            Self::Sensor { sensor, .. } => needs.sensors.push(*sensor),
        }
    }

    /// What kind of values it holds.
    pub fn kind(&self) -> Kind {
        match (self.unit(), self) {
            (Some(_), _) => Kind::Numbers,
            (None, Self::Sensor { .. }) => Kind::Flags,
            (None, _) => Kind::Texts,
        }
    }

    /// The unit of its numbers; `None` where it holds texts or truths.
    pub fn unit(&self) -> Option<&'static str> {
        match self {
            Self::Spring(number) => Some(number.unit),
            Self::Force { .. } | Self::Sensor { of: OfSensor::Combined, .. } => Some("%"),
            Self::Bound { .. } => Some("1"),
            Self::Pitch { .. } => Some("m"),
            Self::Sensor { of: OfSensor::Lag, .. } => Some("s"),
            _ => None,
        }
    }
}

/// What is asked of a force: `F_o.rmsd`, `F_o.worst`, `F_L.method`.
fn of_force(word: &str, condition: Option<usize>) -> Option<Column> {
    let (name, what) = word.split_once('.')?;
    let force = Channel::FORCES.iter().position(|channel| channel.name() == name)?;
    if let Some((_, measure)) = MEASURES.iter().find(|(known, _)| *known == what) {
        return Some(Column::Force { force, measure: *measure, condition });
    }
    match what {
        "worst" if condition.is_none() => Some(Column::WorstOf { force }),
        "method" if force == BY_INDUCTANCE => Some(Column::Method { condition }),
        "bound" if force == BY_INDUCTANCE => Some(Column::Bound { condition }),
        _ => None,
    }
}

/// Number of a name, or of a number from 1.
fn found(names: &[String], what: &str, name: &str) -> Result<usize, SweepError> {
    let name = name.trim().trim_matches('"');
    let by_number = || name.parse::<usize>().ok().filter(|n| (1..=names.len()).contains(n)).map(|n| n - 1);
    names.iter().position(|known| known == name).or_else(by_number).ok_or_else(|| {
        let known = if names.is_empty() { "none".to_owned() } else { names.join("; ") };
        SweepError::new(format!("column: no {what} {name:?} is there; there are: {known}"))
    })
}

fn unknown(text: &str) -> SweepError {
    let mut known: Vec<String> = OF_SPRING.iter().map(|number| number.word.to_owned()).collect();
    let forces = Channel::FORCES.map(Channel::name);
    known.extend(forces.iter().flat_map(|force| {
        let words = MEASURES.iter().map(|(word, _)| *word).chain(["worst"]);
        words.map(move |word| format!("{force}.{word}"))
    }));
    known.extend(["F_L.method", "F_L.bound", "worst", "closest_pitch", "clearance"].map(str::to_owned));
    known.extend(OF_SENSOR.map(|(word, _)| format!("SENSOR.{word}")));
    let meant = match nearest(text, known.iter().map(String::as_str)) {
        Some(nearest) => format!("; did you mean {nearest}? Allowed"),
        None => "; allowed".to_owned(),
    };
    SweepError::new(format!("column {text}: is not known{meant}: {}", known.join(", ")))
}

/// Words with commas between them; those in quotes or brackets belong to a name.
///
/// ```
/// let words = coilsense_lab::sweep::column_words("mass, F_o.rmsd[heel, left], \"load cell, 1\".lag");
/// assert_eq!(words, ["mass", "F_o.rmsd[heel, left]", "\"load cell, 1\".lag"]);
/// ```
pub fn column_words(text: &str) -> Vec<String> {
    let (mut quoted, mut bracketed) = (false, false);
    let words = text.split(|c: char| {
        match c {
            '"' => quoted = !quoted,
            '[' => bracketed = true,
            ']' => bracketed = false,
            _ => {}
        }
        c == ',' && !quoted && !bracketed
    });
    words.map(|word| word.trim().to_owned()).filter(|word| !word.is_empty()).collect()
}

/// What is recorded where nothing is asked for: the spring, and every force but the one that counts as true and F_L, which takes longest.
pub(super) fn usual(truth: Channel, names: &Names) -> Vec<String> {
    let mut columns: Vec<String> = Vec::new();
    if names.springs == 1 {
        columns.extend(["stiffness", "mass", "f1", "nominal_force", "stress"].map(str::to_owned));
    }
    if !names.conditions.is_empty() {
        let forces = Channel::FORCES.into_iter().take(BY_INDUCTANCE).filter(|force| *force != truth);
        columns.extend(forces.flat_map(|force| MEASURES.map(|(word, _)| format!("{}.{word}", force.name()))));
        columns.push("worst".to_owned());
    }
    columns
}
