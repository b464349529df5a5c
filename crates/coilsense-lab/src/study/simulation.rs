//! Motion, positions of the windings, inductance and the forces that follow, over a series of times.
//!
//! Next door: how many masses stand for a winding (`masses`), the judgement of sensors (`crate::analysis`).

use coilsense::inductance::{BoundedSeries, MaxwellSum};
use coilsense::motion::Windings;
use coilsense::{Calibration, Channel, Error, Excitation, InductanceSensor, Motion, Mount, Signals, Spring};

use super::helical::{EndLoads, Helical, Moved};

/// What is simulated.
#[derive(Debug, Clone, Copy)]
pub struct Setup<'a> {
    /// The spring, with as many masses as its chain is to have.
    pub spring: &'a Spring,
    /// What end 2 is tied to, and what damps the windings.
    pub mount: &'a Mount,
    /// How the ends move and how the windings start.
    pub excitation: &'a Excitation,
    /// The coil whose inductance is wanted; without it there is no L and no F_L.
    pub coil: Option<Coil<'a>>,
    /// Whether the positions of the windings are wanted.
    pub positions: bool,
    /// The helix that moves in place of the spring's chain, its stiffness and its frequencies multiplied.
    pub helix: Option<(&'a Helical, [f64; 2])>,
}

/// The spring as an inductance, with what its meter is told.
#[derive(Debug, Clone, Copy)]
pub struct Coil<'a> {
    /// Maxwell's sum over its windings.
    pub sum: &'a MaxwellSum,
    /// α and β of eq. (13).
    pub calibration: Calibration,
    /// How L is found.
    pub method: Method,
}

/// How L is found.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Method {
    /// By the exact sum.
    Exact,
    /// To second order where that is within this share of L, by the exact sum elsewhere.
    Within(f64),
}

/// A spring, simulated.
#[derive(Debug, Clone)]
pub struct Simulation {
    /// The motion, for more times.
    pub motion: Motion,
    /// u1, u2, F_i, F_o, F_x, and of a coil L and F_L; shape `times`.
    pub signals: Signals,
    /// Where the masses of the chain are, where that was wanted.
    pub windings: Option<Windings>,
    /// L with its bounds, where it was found within a tolerance.
    pub bounded: Option<BoundedSeries>,
    /// Of a helix: what holds end 1 and end 2 feels beside the axial force.
    pub loads: Option<[EndLoads; 2]>,
    /// The signals as sensors see them, where load cells are out of line with a helix.
    pub seen: Option<Signals>,
}

impl<'a> Coil<'a> {
    /// A coil whose meter is calibrated by theory over the operating range and set to zero at `mean_length` \[m\].
    ///
    /// # Errors
    /// [`Error::Value`] for a coil whose eq. (13) cannot be fitted, such as a single winding.
    pub fn of(spring: &Spring, sum: &'a MaxwellSum, mean_length: f64, method: Method) -> Result<Self, Error> {
        Ok(Self { sum, calibration: Calibration::theoretical(spring, sum, mean_length)?, method })
    }
}

/// Simulates a setup at `times` \[s\], strictly increasing, none below zero.
///
/// # Errors
/// Those of [`Motion::mounted`], [`Helical::simulate`], [`Motion::signals`], [`Motion::windings`] and [`MaxwellSum::series_within`].
pub fn simulate(setup: &Setup<'_>, times: &[f64]) -> Result<Simulation, Error> {
    let (motion, mut signals, loads, read) = match setup.helix {
        Some((helix, change)) => {
            let Moved { motion, signals, loads, read } =
                helix.simulate(change, setup.mount, setup.excitation, times)?;
            (motion, signals, Some(loads), read)
        }
        None => {
            let motion = Motion::mounted(setup.spring, setup.mount, setup.excitation)?;
            let signals = motion.signals(times)?;
            (motion, signals, None, None)
        }
    };
    let exact = matches!(setup.coil, Some(Coil { method: Method::Exact, .. }));
    let windings = if setup.positions || exact { Some(motion.windings(times)?) } else { None };
    let mut bounded = None;
    if let Some(coil) = &setup.coil {
        let inductance = match (&windings, coil.method) {
            (Some(windings), Method::Exact) => coil.sum.series(windings),
            (Some(windings), Method::Within(share)) => values(coil.sum.series_within(windings, share)?, &mut bounded),
            (None, Method::Within(share)) => values(coil.sum.along(&motion, times, share)?, &mut bounded),
            (None, Method::Exact) => values(coil.sum.along(&motion, times, 0.0)?, &mut bounded),
        };
        let force = InductanceSensor::new(setup.spring, coil.calibration).force(&inductance);
        signals.insert(Channel::InductanceForce, force)?;
        signals.insert(Channel::Inductance, inductance)?;
    }
    let seen = read.map(|read| seen_by(&signals, read)).transpose()?;
    Ok(Simulation { motion, signals, windings, bounded, loads, seen })
}

/// Signals with F_i and F_o as load cells read them.
fn seen_by(signals: &Signals, [input, output]: [Vec<f64>; 2]) -> Result<Signals, Error> {
    let mut seen = signals.clone();
    seen.insert(Channel::InputForce, input)?;
    seen.insert(Channel::OutputForce, output)?;
    Ok(seen)
}

/// L of a series, which is kept with its bounds.
fn values(series: BoundedSeries, kept: &mut Option<BoundedSeries>) -> Vec<f64> {
    let values = series.samples.iter().map(|sample| sample.inductance).collect();
    *kept = Some(series);
    values
}
