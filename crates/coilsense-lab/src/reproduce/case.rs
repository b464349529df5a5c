//! One simulation: a spring under one excitation, its signals, its measures, and whether its windings touch.
//!
//! Next door: what is simulated (`protocol`), the table cells made of it (`cell`).

use coilsense::inductance::{MaxwellSum, SelfDistance};
use coilsense::signals::sampled_window;
use coilsense::{Channel, Clash, Deviation, Error, Excitation, Motion, Mount, Signals, Spring};

use super::{Condition, PaperSprings, Protocol, ReproduceError};
use crate::published::COLUMNS;
use crate::study::{self, Coil, Method, Setup, Simulation};

/// Samples per second of the paper's tables here, and the window that is judged \[s\]: the last quarter of the first second.
const SAMPLE_RATE: f64 = 10_000.0;
const WINDOW: (f64, f64) = (0.75, 1.0);

/// Sample rates over which Table III's maxima are shown to depend on where samples fall: from 1 to 20 kHz in steps of 0.1 kHz.
const OTHER_RATES: std::ops::RangeInclusive<u32> = 10..=200;
const RATE_STEP: f64 = 100.0;

/// A simulation to run.
#[derive(Debug, Clone)]
pub struct Case {
    /// `S_T` or `S_A`.
    pub spring_name: &'static str,
    /// The spring.
    pub spring: Spring,
    /// The condition.
    pub condition: Condition,
    /// What is done to the spring.
    pub excitation: Excitation,
    /// The protocols that read the condition like this.
    pub protocols: Vec<Protocol>,
}

/// A simulation that was run.
#[derive(Debug, Clone)]
pub struct CaseResult {
    /// What was run.
    pub case: Case,
    /// u1, u2, F_i, F_o, F_x, F_L, L over the judged window at 10 kHz.
    pub signals: Signals,
    /// Deviation of F_i, F_o and F_L from F_x \[N\].
    pub deviations: [(Channel, Deviation); 3],
    /// How the maxima of F_i and F_o hang on the sample rate \[N\], for the caveat beside Table III.
    pub maxima: [(Channel, Maxima); 2],
    /// How near the windings come, from t = 0 on.
    pub clash: Clash,
}

/// Lowest and highest maximum of a force's deviation over sample rates from 1 to 20 kHz \[N\].
#[derive(Debug, Clone, Copy)]
pub struct Maxima {
    /// Of max (F − F_x).
    pub signed: [f64; 2],
    /// Of max |F − F_x|.
    pub absolute: [f64; 2],
}

impl Case {
    /// Every simulation that the protocols ask for, those that they share only once.
    pub(super) fn distinct(springs: &PaperSprings, protocols: &[Protocol]) -> Result<Vec<Self>, ReproduceError> {
        let mut cases: Vec<Self> = Vec::new();
        for (spring_name, spring) in springs.each() {
            for condition in Condition::ALL {
                for &protocol in protocols {
                    let excitation =
                        protocol.excitation(condition, spring).map_err(|source| at(spring_name, condition, source))?;
                    let same = |case: &&mut Self| {
                        case.spring_name == spring_name && case.condition == condition && case.excitation == excitation
                    };
                    match cases.iter_mut().find(same) {
                        Some(case) => case.protocols.push(protocol),
                        None => cases.push(Self {
                            spring_name,
                            spring: spring.clone(),
                            condition,
                            excitation,
                            protocols: vec![protocol],
                        }),
                    }
                }
            }
        }
        Ok(cases)
    }

    /// Runs it.
    pub(super) fn run(self) -> Result<CaseResult, ReproduceError> {
        let (name, condition) = (self.spring_name, self.condition);
        self.simulate().map_err(|source| at(name, condition, source))
    }

    fn simulate(self) -> Result<CaseResult, Error> {
        let times = sampled_window(SAMPLE_RATE, WINDOW.0, WINDOW.1)?;
        let sum = crate::spec::SpringInductance::Air(MaxwellSum::new(&self.spring, SelfDistance::AsPrinted));
        let coil = Coil::of(&self.spring, &sum, self.excitation.mean_length(), Method::Exact)?;
        let (mount, excitation) = (&Mount::default(), &self.excitation);
        let (spring, coil) = (&self.spring, Some(coil));
        let setup = Setup { spring, mount, excitation, coil, positions: false, helix: None, contact: None };
        let Simulation { motion, signals, .. } = study::simulate(&setup, &times)?;
        let reference = signals.channel(Channel::DeflectionForce)?;
        let deviation = |force| Ok((force, Deviation::between(signals.channel(force)?, reference)?));
        let deviations = [deviation(COLUMNS[0])?, deviation(COLUMNS[1])?, deviation(COLUMNS[2])?];
        let maxima = maxima(&motion)?;
        let clash = Clash::of(&motion, &sampled_window(SAMPLE_RATE, 0.0, WINDOW.1)?)?;
        Ok(CaseResult { case: self, signals, deviations, maxima, clash })
    }
}

/// The maxima of both end forces over other sample rates.
fn maxima(motion: &Motion) -> Result<[(Channel, Maxima); 2], Error> {
    let nothing = Maxima { signed: [f64::INFINITY, f64::NEG_INFINITY], absolute: [f64::INFINITY, f64::NEG_INFINITY] };
    let mut maxima = [(Channel::InputForce, nothing), (Channel::OutputForce, nothing)];
    for rate in OTHER_RATES {
        let signals = motion.signals(&sampled_window(RATE_STEP * f64::from(rate), WINDOW.0, WINDOW.1)?)?;
        let reference = signals.channel(Channel::DeflectionForce)?;
        for (force, maxima) in &mut maxima {
            let deviation = Deviation::between(signals.channel(*force)?, reference)?;
            maxima.signed = widen(maxima.signed, deviation.maximum);
            maxima.absolute = widen(maxima.absolute, deviation.maximum_absolute);
        }
    }
    Ok(maxima)
}

fn widen([low, high]: [f64; 2], value: f64) -> [f64; 2] {
    [low.min(value), high.max(value)]
}

fn at(spring: &'static str, condition: Condition, source: Error) -> ReproduceError {
    ReproduceError::Case { spring, condition: condition.name(), source }
}

impl CaseResult {
    /// `S_T, end stop min (text)`; the protocol only where it stands for one reading of the two.
    pub fn title(&self) -> String {
        let (name, condition) = (self.case.spring_name, self.case.condition.name());
        match self.reading() {
            Some(protocol) => format!("{name}, {condition} ({})", protocol.name()),
            None => format!("{name}, {condition}"),
        }
    }

    /// `S_T-end-stop-min-text`, for file names.
    pub fn file_stem(&self) -> String {
        let of_reading = self.reading().map_or(String::new(), |protocol| format!("-{}", protocol.name()));
        file_stem(self.case.spring_name, self.case.condition, &of_reading)
    }

    /// The protocol whose reading this is, where the protocols read the condition differently.
    fn reading(&self) -> Option<Protocol> {
        let excitation = |protocol: Protocol| protocol.excitation(self.case.condition, &self.case.spring).ok();
        let shared = excitation(Protocol::Text) == excitation(Protocol::Tables);
        self.case.protocols.first().copied().filter(|_| !shared)
    }

    /// What a reader must know before using its numbers.
    pub fn warnings(&self) -> Vec<String> {
        let mut warnings = Vec::new();
        let case = &self.case;
        let ((shortest, longest), (min, max)) = (case.excitation.length_bounds(), case.spring.operating_range());
        for length in [shortest, longest] {
            if !case.spring.in_operating_range(length) {
                let title = self.title();
                let [length, min, max] = [length, min, max].map(|metres| 1e3 * metres);
                warnings.push(format!("{title}: length {length} mm is outside of the operating range {min}–{max} mm."));
            }
        }
        if let Some(contact) = self.clash.first_contact {
            warnings.push(format!(
                "{}: windings touch from t = {contact:.3} s on ({:.2} mm from winding to winding at t = {:.3} s, wire {:.2} mm). \
                 The numbers of this row lie beyond what this spring can do.",
                self.title(),
                1e3 * self.clash.smallest_pitch,
                self.clash.time,
                1e3 * self.clash.contact_pitch,
            ));
        }
        warnings
    }
}

/// Every file stem that any choice of protocols can have.
pub(crate) fn all_file_stems() -> Vec<String> {
    let readings = ["", "-text", "-tables"];
    let of_spring = |name| Condition::ALL.into_iter().map(move |condition| (name, condition));
    let cases = ["S_T", "S_A"].into_iter().flat_map(of_spring);
    cases.flat_map(|(name, condition)| readings.map(|reading| file_stem(name, condition, reading))).collect()
}

fn file_stem(spring: &str, condition: Condition, reading: &str) -> String {
    format!("{spring}-{}{reading}", condition.name().replace(' ', "-"))
}
