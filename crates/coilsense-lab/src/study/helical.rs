//! The coil as a helix, moving about the length of a condition: what `model = "helix"` simulates.
//!
//! Next door: its modes at rest (`crate::helix`), one simulation of any model (`simulation`).

use std::sync::Arc;

use coilsense::helix::{Helix, ReactionSeries, Surge};
use coilsense::{Channel, Error, Excitation, Motion, Mount, Signals};

use super::bent::Bent;
use crate::helix::Held;
use crate::spec::{Model, Spec, SpringSpec};

/// Whether helices move in this build: known when it is compiled, so that one without the feature does not carry what moves them.
const MOVES: Result<(), Error> = if cfg!(feature = "moving-helix") {
    Ok(())
} else {
    Err(Error::Value {
        field: None,
        quantity: std::borrow::Cow::Borrowed("feature \"moving-helix\" of this build"),
        value: 0.0,
        unit: "",
        allowed: std::borrow::Cow::Borrowed("on where model = \"helix\" is to move"),
    })
};

/// A helix about one length, its ends held in one way.
#[derive(Debug, Clone)]
pub struct Helical {
    surge: Surge,
    bent: Bent,
    /// Length about which it moves \[m\].
    length: f64,
    /// Angle between the spring's axis and that of a load cell \[rad\].
    misalignment: f64,
}

/// What holds an end feels beside the axial force.
#[derive(Debug, Clone, PartialEq)]
pub struct EndLoads {
    /// In the direction across the axis in which its mean square is largest \[N\], shape `samples`.
    pub side_force: Vec<f64>,
    /// About the axis \[N m\], shape `samples`.
    pub couple: Vec<f64>,
}

/// A helix that has moved.
#[derive(Debug)]
pub struct Moved {
    /// The motion about the length.
    pub motion: Motion,
    /// u1, u2, F_i, F_o and F_x: the motion's, bent with the static curve of the helix.
    pub signals: Signals,
    /// What holds end 1 and end 2 feels beside the axial force.
    pub loads: [EndLoads; 2],
    /// F_i and F_o as load cells read them that are out of line, where they are.
    pub read: Option<[Vec<f64>; 2]>,
}

impl Helical {
    /// Of a spec's spring about a length \[m\].
    ///
    /// # Errors
    /// Those of [`SpringSpec::rod`], [`Helix::new`] and [`Surge::new`]: no helix, or one that has buckled; and in a build
    /// without the feature `moving-helix`.
    pub fn new(spring: &SpringSpec, way: &Held, misalignment: f64, length: f64) -> Result<Self, Error> {
        MOVES?;
        let bent = Bent::of(spring, way.turning())?;
        let helix = Helix::new(&spring.rod()?, spring.geometry.active_span(length), way.turning())?;
        let surge = Surge::new(&spring.spring, &spring.geometry, &helix, way.ends())?;
        Ok(Self { surge, bent, length, misalignment })
    }

    /// Its modes.
    pub fn surge(&self) -> &Surge {
        &self.surge
    }

    /// Moves it, with its stiffness and its frequencies multiplied as tolerances do.
    ///
    /// # Errors
    /// As [`Helical::new`], [`Surge::motion`] and [`Motion::signals`]; [`Error::Value`] for lengths at which the spring is no helix.
    pub fn simulate(
        &self,
        [stiffness, frequencies]: [f64; 2],
        mount: &Mount,
        excitation: &Excitation,
        times: &[f64],
    ) -> Result<Moved, Error> {
        MOVES?;
        let wire = self.surge.changed(stiffness, frequencies)?;
        let motion = wire.motion(mount, excitation)?;
        let mut signals = motion.signals(times)?;
        let bend = self.bend(stiffness, &signals)?;
        for channel in [Channel::InputForce, Channel::OutputForce, Channel::DeflectionForce] {
            let bent = signals.channel(channel)?.iter().zip(&bend).map(|(force, bend)| force + bend).collect();
            signals.insert(channel, bent)?;
        }
        let reactions = wire.reactions(&motion, times)?;
        let loads = reactions.map(EndLoads::of);
        let read = (self.misalignment > 0.0).then(|| self.read(&signals, &loads)).transpose()?;
        Ok(Moved { motion, signals, loads, read })
    }

    /// What the static force is more than the straight line of the motion \[N\], at each sample.
    fn bend(&self, stiffness: f64, signals: &Signals) -> Result<Vec<f64>, Error> {
        let helix = self.surge.helix();
        let straight = |length: f64| helix.force() + helix.stiffness() * (length - self.length);
        let ends = signals.channel(Channel::U1)?.iter().zip(signals.channel(Channel::U2)?);
        let bend = |(u1, u2): (&f64, &f64)| Ok(stiffness * (self.bent.force(u2 - u1)? - straight(u2 - u1)));
        ends.map(bend).collect()
    }

    /// What load cells read: the axial force, and of the side force what their tilt shows, in the direction in which it is largest.
    fn read(&self, signals: &Signals, loads: &[EndLoads; 2]) -> Result<[Vec<f64>; 2], Error> {
        let (sine, cosine) = self.misalignment.sin_cos();
        let of = |channel: Channel, loads: &EndLoads| -> Result<Vec<f64>, Error> {
            let axial = signals.channel(channel)?;
            Ok(axial.iter().zip(&loads.side_force).map(|(axial, side)| cosine * axial + sine * side).collect())
        };
        Ok([of(Channel::InputForce, &loads[0])?, of(Channel::OutputForce, &loads[1])?])
    }
}

impl EndLoads {
    fn of(reaction: ReactionSeries) -> Self {
        let side_force = along_largest(&reaction);
        let [_, _, couple] = reaction.couple;
        Self { side_force, couple }
    }
}

/// The side force \[N\] in the direction in which its mean square is largest, shape `samples`.
fn along_largest(reaction: &ReactionSeries) -> Vec<f64> {
    let [x, y, _] = &reaction.force;
    let sum = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    let direction = 0.5 * (2.0 * sum(x, y)).atan2(sum(x, x) - sum(y, y));
    let (sine, cosine) = direction.sin_cos();
    x.iter().zip(y).map(|(x, y)| cosine * x + sine * y).collect()
}

/// The helices of a spec, one for each condition under each damping; none where its model is another.
#[derive(Debug, Clone, Default)]
pub struct Helices {
    each: Vec<Arc<Helical>>,
    dampings: usize,
}

impl Helices {
    /// Finds them; conditions about one length with ends held in one way share one.
    ///
    /// # Errors
    /// As [`Helical::new`], with the numbers of condition and damping.
    pub fn of(spec: &Spec) -> Result<Self, (usize, usize, Error)> {
        let mut helices = Self { each: Vec::new(), dampings: spec.mount.cases.len() };
        if spec.spring.model != Model::Helix {
            return Ok(helices);
        }
        let mut known: Vec<(f64, Held, Arc<Helical>)> = Vec::new();
        for (condition, asked) in spec.conditions.iter().enumerate() {
            let length = asked.excitation.mean_length();
            for (damping, case) in spec.mount.cases.iter().enumerate() {
                let way = case.held.unwrap_or(spec.mount.ends.ways().0);
                let same = known.iter().find(|(at, held, _)| *at == length && *held == way);
                let helical = match same {
                    Some((_, _, helical)) => Arc::clone(helical),
                    None => {
                        let found = Helical::new(&spec.spring, &way, spec.mount.ends.misalignment, length);
                        let found = Arc::new(found.map_err(|error| (condition, damping, error))?);
                        known.push((length, way, Arc::clone(&found)));
                        found
                    }
                };
                helices.each.push(helical);
            }
        }
        Ok(helices)
    }

    /// Whether the spec's model is another.
    pub fn is_empty(&self) -> bool {
        self.each.is_empty()
    }

    /// That of a condition under a damping.
    pub fn get(&self, condition: usize, damping: usize) -> Option<&Helical> {
        self.each.get(condition * self.dampings + damping).map(Arc::as_ref)
    }
}
