//! One simulation: a spring under one excitation, its signals, its measures, and whether its windings touch.
//!
//! Next door: what is simulated (`protocol`), the table cells made of it (`cell`).

use coilsense::inductance::{MaxwellSum, SelfDistance};
use coilsense::signals::sampled_window;
use coilsense::{Calibration, Channel, Clash, Deviation, Error, Excitation, InductanceSensor, Motion, Signals, Spring};

use super::{Condition, PaperSprings, Protocol, ReproduceError};
use crate::published::COLUMNS;

/// Samples per second of the paper's tables here, and the window that is judged \[s\]: the last quarter of the first second.
const SAMPLE_RATE: f64 = 10_000.0;
const WINDOW: (f64, f64) = (0.75, 1.0);

/// Sample rates \[Hz\] over which Table III's maxima are shown to depend on where samples fall.
const OTHER_RATES: [f64; 4] = [1_000.0, 2_000.0, 5_000.0, 20_000.0];

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
    /// Deviations of F_i and F_o at other sample rates \[N\], for the caveat beside Table III.
    pub resampled: Vec<[(Channel, Deviation); 2]>,
    /// How near the windings come, from t = 0 on.
    pub clash: Clash,
}

impl Case {
    /// Every simulation that the protocols ask for, those that they share only once.
    pub(super) fn distinct(springs: &PaperSprings, protocols: &[Protocol]) -> Result<Vec<Self>, ReproduceError> {
        let mut cases: Vec<Self> = Vec::new();
        for (spring_name, spring) in springs.each() {
            for condition in Condition::ALL {
                for &protocol in protocols {
                    let excitation = protocol
                        .excitation(condition, spring)
                        .map_err(|source| at(spring_name, condition, source))?;
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
        let motion = Motion::new(&self.spring, &self.excitation)?;
        let times = sampled_window(SAMPLE_RATE, WINDOW.0, WINDOW.1)?;
        let mut signals = motion.signals(&times)?;
        let coil = MaxwellSum::new(&self.spring, SelfDistance::AsPrinted);
        let inductance = coil.series(&motion.windings(&times)?);
        let calibration = Calibration::theoretical(&self.spring, &coil, self.excitation.mean_length())?;
        let sensor = InductanceSensor::new(&self.spring, calibration);
        signals.insert(Channel::InductanceForce, sensor.force(&inductance))?;
        signals.insert(Channel::Inductance, inductance)?;
        let reference = signals.channel(Channel::DeflectionForce)?;
        let deviation = |force| Ok((force, Deviation::between(signals.channel(force)?, reference)?));
        let deviations = [deviation(COLUMNS[0])?, deviation(COLUMNS[1])?, deviation(COLUMNS[2])?];
        let resampled = OTHER_RATES
            .into_iter()
            .map(|rate| end_deviations(&motion, rate))
            .collect::<Result<_, _>>()?;
        let clash = Clash::of(&motion, &sampled_window(SAMPLE_RATE, 0.0, WINDOW.1)?)?;
        Ok(CaseResult {
            case: self,
            signals,
            deviations,
            resampled,
            clash,
        })
    }
}

/// Deviations of the end forces \[N\] in the judged window at another sample rate.
fn end_deviations(motion: &Motion, rate: f64) -> Result<[(Channel, Deviation); 2], Error> {
    let signals = motion.signals(&sampled_window(rate, WINDOW.0, WINDOW.1)?)?;
    let reference = signals.channel(Channel::DeflectionForce)?;
    let deviation = |force| Ok((force, Deviation::between(signals.channel(force)?, reference)?));
    Ok([deviation(Channel::InputForce)?, deviation(Channel::OutputForce)?])
}

fn at(spring: &'static str, condition: Condition, source: Error) -> ReproduceError {
    ReproduceError::Case {
        spring,
        condition: condition.name(),
        source,
    }
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
        let (name, condition) = (self.case.spring_name, self.case.condition.name().replace(' ', "-"));
        match self.reading() {
            Some(protocol) => format!("{name}-{condition}-{}", protocol.name()),
            None => format!("{name}-{condition}"),
        }
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
                warnings.push(format!(
                    "{title}: length {length} mm is outside of the operating range {min}–{max} mm."
                ));
            }
        }
        if let Some(contact) = self.clash.first_contact {
            warnings.push(format!(
                "{}: windings touch from t = {contact:.3} s on ({:.2} mm from winding to winding at t = {:.3} s, wire {:.2} mm). \
                 The numbers of this row lie beyond what this spring can do.",
                self.title(),
                1e3 * self.clash.smallest_pitch,
                self.clash.time,
                1e3 * self.clash.wire_diameter,
            ));
        }
        warnings
    }
}
