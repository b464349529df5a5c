//! A spec's spring as a part of another's model: `coilsense export`.
//!
//! Next door: the plant (`coilsense::plant`), a step of it (`coilsense_rt::Plant`), what may be asked (`request`), how many modes it takes (`order`),
//! what it tells beside forces (`windings`), its forms (`header`, `constant`, `fmu`; matrices: `crate::report`), settings of filters and observers (`crate::mitigation::export`).

mod constant;
#[cfg(feature = "fmu")]
mod fmu;
mod header;
mod order;
mod readings;
pub mod request;
mod windings;

use std::fmt;

use coilsense::plant::{ModalCoil, ModalPlant, ModalWindings};
use coilsense::{Damping, Error, Mount};

use crate::mitigation::export::{ExportError, Precision};
use crate::spec::{SensorSpec, Spec, SpecError};
use crate::study;
use order::Wanted;
use readings::{Seen, Sensor};
pub use request::Request;
pub use windings::Also;
use windings::Meter;

/// As what a plant is written.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Form {
    /// A header of C99 that needs no library.
    C {
        /// In which numbers it is stepped.
        precision: Precision,
        /// In which steps instruments are read \[s\], where they are.
        step: Option<f64>,
    },
    /// A constant for `coilsense-rt`, which is stepped in either.
    Rust {
        /// In which numbers F_L, the closest pitch and readings are found.
        precision: Precision,
        /// In which steps instruments are read \[s\], where they are.
        step: Option<f64>,
    },
    /// JSON with A, B, C, D.
    StateSpace {
        /// With those of this step \[s\], too.
        step: Option<f64>,
    },
    /// An FMU.
    Fmu {
        /// Of which FMI.
        version: Fmi,
        /// The step of its default experiment \[s\].
        step: f64,
    },
}

/// A version of the standard of FMUs.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Fmi {
    /// FMI 2.0, for co-simulation and model exchange.
    Two,
    /// FMI 3.0, for co-simulation.
    Three,
}

impl fmt::Display for Fmi {
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        to.write_str(match self {
            Self::Two => "2.0",
            Self::Three => "3.0",
        })
    }
}

/// A file that is ready to be written.
#[derive(Debug)]
pub struct Made {
    /// What is in it.
    pub bytes: Vec<u8>,
    /// What is not, though it could be, and why; one line.
    pub left_out: Option<String>,
}

/// Why there is no plant.
#[derive(Debug, thiserror::Error)]
pub enum PlantError {
    /// Of a spec that has none, or whose words do not say which.
    #[error("{0}")]
    Spec(String),
    /// A name or a number that a language cannot hold.
    #[error(transparent)]
    Export(#[from] ExportError),
}

impl PlantError {
    /// What the science refuses of a spec.
    pub(crate) fn science(file: &str) -> impl Fn(Error) -> Self {
        move |refused| Self::Spec(format!("{file}: {refused}"))
    }
}

impl From<SpecError> for PlantError {
    fn from(refused: SpecError) -> Self {
        Self::Spec(refused.to_string())
    }
}

/// A spec's plant, ready to be written.
#[derive(Debug, Clone)]
pub struct Plant {
    /// The spec.
    pub spec_file: String,
    /// The name of its spring.
    pub spring: String,
    /// Its damping in words.
    pub damping: String,
    /// The plant.
    pub plant: ModalPlant,
    /// F_L, where it was asked for.
    pub coil: Option<ModalCoil>,
    /// How near its windings are, where that was asked for.
    pub windings: Option<ModalWindings>,
    /// The sensors that are read, where that was asked for.
    pub sensors: Option<Vec<SensorSpec>>,
    /// What a reader must know of these, each in a line.
    pub warnings: Vec<String>,
    /// Bandwidth \[Hz\] and the error up to there, where they were asked for.
    pub error: Option<(f64, f64)>,
    /// As what it is written.
    pub form: Form,
}

/// Most modes that a file gets: beyond, a matrix has a million numbers.
const MOST_MODES: usize = 512;

impl Plant {
    /// Finds the plant of a spec.
    ///
    /// # Errors
    /// [`PlantError`], one line, for contact, a helix, a coil of sections, several springs, several dampings of which none is named, an order too
    /// low for the error that is asked for.
    pub fn of(mut spec: Spec, request: &Request) -> Result<Self, PlantError> {
        spec.needs_chain("export")?;
        spec.needs_no_contact("export")?;
        let file = spec.file.clone();
        let science = PlantError::science(&file);
        study::prepare(&mut spec.spring, &mut spec.mount, &spec.conditions).map_err(&science)?;
        let (mount, damping) = mount(&spec, request)?;
        let mean_length = request.mean_length.unwrap_or_else(|| mean_length(&spec));
        let spring = &spec.spring.spring;
        if !spring.in_operating_range(mean_length) {
            let (shortest, longest) = spring.operating_range();
            let [from, to, got] = [shortest, longest, mean_length].map(|length| 1e3 * length);
            let told = format!("mean length must be from {from:.3} to {to:.3} mm, the lengths in use, got {got:.3} mm");
            return Err(PlantError::Spec(format!("{file}: {told}")));
        }
        let (sensors, mut warnings) = if request.also.readings { read(&spec)? } else { (None, Vec::new()) };
        let reads_coil = sensors.iter().flatten().any(|sensor| Seen::of(sensor) == Some(Seen::Inductance));
        let meter = if request.also.inductance || reads_coil { Some(Meter::of(&spec, mean_length)?) } else { None };
        warnings.extend(meter.as_ref().and_then(|meter| meter.doubt.clone()));
        let wanted = Wanted { file: &file, spring, mount: &mount, mean_length, meter: meter.as_ref() };
        let (plant, error) = wanted.plant(request)?;
        if plant.count() > MOST_MODES {
            let told = format!("modes must be at most {MOST_MODES} for an export, got {}", plant.count());
            return Err(PlantError::Spec(format!("{file}: {told}; --error and --bandwidth find how few are enough")));
        }
        let coil = meter.as_ref().map(|meter| meter.on(&plant)).transpose().map_err(&science)?;
        let pitch = spec.spring.contact_pitch();
        let windings = request.also.closest_pitch.then(|| plant.windings(pitch)).transpose().map_err(&science)?;
        Ok(Self {
            spec_file: spec.file,
            spring: spec.spring.name,
            damping,
            plant,
            coil,
            windings,
            sensors,
            warnings,
            error,
            form: request.form,
        })
    }

    /// A header of C99; `name` is what it is called, and is that of the file; `step`: that of the instruments \[s\], where these are read.
    ///
    /// # Errors
    /// [`PlantError::Export`] for a name that is none in C or Rust; [`PlantError::Spec`] for readings without a step, or a step without readings.
    pub fn header(&self, name: &str, precision: Precision, step: Option<f64>) -> Result<String, PlantError> {
        let sensors = self.read_in("c", step)?;
        header::text(self, &identifier(name), precision, &sensors)
    }

    /// A Rust constant; those of F_L and the closest pitch are in this precision.
    ///
    /// # Errors
    /// As [`Self::header`].
    pub fn constant(&self, name: &str, precision: Precision, step: Option<f64>) -> Result<String, PlantError> {
        let sensors = self.read_in("rust", step)?;
        constant::text(self, &identifier(name), precision, &sensors)
    }

    /// The sensors that are read in these steps.
    fn read_in(&self, form: &str, step: Option<f64>) -> Result<Vec<Sensor>, PlantError> {
        let refused = |told: String| Err(PlantError::Spec(format!("{}: {told}", self.spec_file)));
        match (&self.sensors, step) {
            (Some(sensors), Some(step)) => readings::of(&self.spec_file, sensors, step),
            (Some(_), None) => refused("readings need a step, in which the instruments are read".to_owned()),
            (None, None) => Ok(Vec::new()),
            (None, Some(_)) => refused(format!(
                "step goes with state-space, fmu or readings, got {form}, which is told its step when it starts"
            )),
        }
    }

    /// Refuses readings where they are not.
    ///
    /// # Errors
    /// [`PlantError::Spec`] where they were asked for.
    pub fn needs_no_readings(&self, form: &str) -> Result<(), PlantError> {
        if self.sensors.is_none() {
            return Ok(());
        }
        let told = format!("readings go with c and rust, got {form}: an instrument has steps of its own");
        Err(PlantError::Spec(format!("{}: {told}", self.spec_file)))
    }

    /// An FMU, with this step in its default experiment \[s\].
    ///
    /// # Errors
    /// As [`Self::header`]; [`PlantError::Spec`] in a build without the feature `fmu`.
    pub fn fmu(&self, name: &str, version: Fmi, step: f64) -> Result<Made, PlantError> {
        self.needs_no_readings("fmu")?;
        #[cfg(feature = "fmu")]
        return fmu::archive(self, &identifier(name), version, step);
        #[cfg(not(feature = "fmu"))]
        Err(PlantError::Spec(format!(
            "{name}, FMI {version}, {step} s: an FMU is not in this build: feature fmu is off"
        )))
    }

    /// What was made, in two lines.
    pub fn summary(&self) -> String {
        let plant = &self.plant;
        let (kept, all) = (plant.kept(), plant.available());
        let order = if kept == all {
            format!("all {all} modes: exact for inputs that move straight between samples")
        } else {
            format!("{kept} of {all} modes, and one for each input with the inertia of all others")
        };
        let error = match self.error {
            Some((bandwidth, error)) if error.is_finite() => format!("; error up to {bandwidth} Hz {}", percent(error)),
            Some((bandwidth, _)) => format!("; modes below {bandwidth} Hz are left out"),
            None => String::new(),
        };
        let length = 1e3 * plant.mean_length();
        format!(
            "{}, {}, about {length:.3} mm ({:.4} N)\n{order}{error}\n",
            self.spring,
            self.damping,
            plant.mean_force()
        )
    }
}

/// The sensors of a spec that look at what a plant has, and what is left out.
fn read(spec: &Spec) -> Result<(Option<Vec<SensorSpec>>, Vec<String>), PlantError> {
    let (seen, not): (Vec<&SensorSpec>, Vec<&SensorSpec>) =
        spec.sensors.iter().partition(|sensor| Seen::of(sensor).is_some());
    if seen.is_empty() {
        let told = "readings: no [[sensor]] looks at a force, a length or the inductance of the spring";
        return Err(PlantError::Spec(format!("{}: {told}", spec.file)));
    }
    let left_out = |sensor: &SensorSpec| {
        format!(
            "{} is not read: the drive train that a two-encoder sensor looks through is not in a plant",
            sensor.name
        )
    };
    Ok((Some(seen.into_iter().cloned().collect()), not.into_iter().map(left_out).collect()))
}

/// A file's name as C and Rust can have it.
fn identifier(name: &str) -> String {
    name.replace(['-', '.', ' '], "_").to_ascii_lowercase()
}

/// The shortest decimal that means a double number.
fn digits(value: f64) -> String {
    format!("{value:?}")
}

/// Three digits of a share.
fn percent(share: f64) -> String {
    let percent = 100.0 * share;
    if percent >= 0.001 { format!("{percent:.3} %") } else { format!("{percent:.1e} %") }
}

/// The mount under the damping that is asked for, and that damping in words.
fn mount(spec: &Spec, request: &Request) -> Result<(Mount, String), PlantError> {
    let of = spec.mount.without_ways();
    let labels = of.cases.iter().map(|case| case.label.as_str()).collect::<Vec<_>>().join(", ");
    let refused = |what: String| Err(PlantError::Spec(format!("{}: [mount]: {what}", spec.file)));
    match (request.damping_ratio, of.cases.as_slice()) {
        (None, [one]) => Ok((one.mount.clone(), one.label.clone())),
        (None, _) => refused(format!("one damping makes a plant, got {labels}: --damping-ratio says which")),
        (Some(ratio), cases) => match cases.iter().find(|case| case.ratio == Some(ratio)) {
            Some(case) => Ok((case.mount.clone(), case.label.clone())),
            None if of.is_band => match Mount::new(of.far_end(), Damping::Modal(ratio)) {
                Ok(mount) => Ok((mount, format!("ζ = {ratio}"))),
                Err(refused) => Err(PlantError::science(&spec.file)(refused)),
            },
            None => refused(format!("--damping-ratio must be one of {labels}, got {ratio}")),
        },
    }
}

/// The mean length of all conditions \[m\], or the middle of the operating range.
fn mean_length(spec: &Spec) -> f64 {
    let mut lengths = spec.conditions.iter().map(|condition| condition.excitation.mean_length());
    match lengths.next() {
        Some(first) if lengths.all(|length| length == first) => first,
        _ => spec.spring.spring.mid_length(),
    }
}
