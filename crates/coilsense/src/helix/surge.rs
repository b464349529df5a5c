//! Every motion of a helix over time: its modes, and what its ends feel at rest, made ready for [`Motion`].
//!
//! Next door: modes one by one (`mode`), what ends feel beside the axial force (`reaction_series`), the motion itself (`crate::motion`).

use std::f64::consts::TAU;

use super::ends::Ends;
use super::mode::Mode;
use super::modes::Modes;
use super::response::{Response, Slow};
use super::state::Helix;
use crate::error::{Error, called, check};
use crate::excitation::{End, Excitation};
use crate::geometry::Geometry;
use crate::modes::{ModalModel, WireModes};
use crate::motion::Motion;
use crate::mount::{FarEnd, Mount};
use crate::spring::{Spring, SpringParameters};

/// Up to this many times f1 all modes are found.
const REACH: f64 = 20.0;

/// How far lengths that are the same may lie apart, relative.
const SAME: f64 = 1e-9;

/// ω² below which a mode grows, in that of a bar; what rounding leaves of a motion without stiffness lies above.
const GROWS: f64 = -1e-8;

/// A helix between two ends that move along its axis: all its axial, torsional and sideways modes up to 20 f1, ready for a [`Motion`].
///
/// The wire's motion is that which it would follow slowly, and its modes with held ends: `y = ψ_1 u1 + ψ_2 u2 + Σ_j φ_j q_j`,
///
/// ```text
/// q̈_j + 2ζ_jω_j q̇_j + ω_j² q_j = −(c_1j ü1 + c_2j ü2),   c_ij = r_ij/ω_j²
/// F_i = F + k (u2 − u1) + Σ_j r_1j q_j − R_1 ü,   F_o = F + k (u2 − u1) − Σ_j r_2j q_j + R_2 ü,   R = M − Σ_j c_j c_jᵀ
/// ```
///
/// with r_ij the axial reaction of mode j at end i for a modal mass of 1 kg ([`Mode::reaction`]), F and k the force and its slope at the
/// helix's length, and R what modes beyond the reach follow with. M, the inertia of the slow motion, is the slope of the dynamic
/// stiffness over −ω² at zero, found exactly by an imaginary ω².
///
/// Source:   modes with held ends about a static motion of the ends (Craig and Bampton); c by reciprocity.
/// Valid:    small motions about one length; both positions prescribed, along the axis. Winding i of a [`Motion`] is the mean of its share of
///           the wire, along the axis; a start winding by winding is the axial part only. Ringing beyond 20 f1 is left out.
/// Accuracy: forces under sines below 0.75 f1 are those of [`Response`] to 1.4e-5 of their dynamic part, at 0.25 f1 to 2.5e-6; with the modes
///           below 10 f1 alone 5.5e-5. Work and energy agree to 1e-10 (`tests/helix`).
/// Differs:  k is the slope with the ends as they are held; clamped ends keep the angle of the wire and are a little stiffer than
///           [`Helix::stiffness`], S_T by 0.04 %, a valve spring of 5.75 windings by 0.5 %. F bends with the length: k is that of the
///           helix's.
///
/// ```
/// use coilsense::geometry::{EndType, Geometry, Material, MaterialParameters};
/// use coilsense::helix::{Ends, Hand, Helix, Rod, StiffnessAt, Surge, Turning};
/// use coilsense::{Excitation, Mount};
///
/// let spring = coilsense::paper::s_t();
/// let steel = Material::new(MaterialParameters::elastic(81.5e9, 206e9, 7850.0))?;
/// let geometry = Geometry::of_spring(&spring, EndType::Hooks, steel)?;
/// let rod = Rod::of_spring(&spring, &geometry, StiffnessAt::Range, Hand::Right)?;
/// let surge = Surge::new(&spring, &geometry, &Helix::new(&rod, 0.230, Turning::Held)?, Ends::clamped())?;
///
/// // An impact sets off torsion, too: what holds end 2 feels a couple about the axis.
/// let motion = surge.motion(&Mount::default(), &Excitation::impact(0.230, 0.25)?)?;
/// let times = coilsense::signals::sampled_window(10_000.0, 0.0, 0.1)?;
/// let forces = motion.end_forces(&times)?;
/// let [_, end2] = surge.reactions(&motion, &times)?;
/// assert!(end2.force[2].iter().zip(&forces.output).all(|(pull, force)| (pull + force).abs() < 1e-9));
/// # Ok::<(), coilsense::Error>(())
/// ```
#[derive(Debug, Clone)]
pub struct Surge {
    pub(super) helix: Helix,
    ends: Ends,
    modes: Vec<Mode>,
    model: ModalModel,
    spring: Spring,
    length: f64,
    reach: f64,
    /// What each end feels per metre of each end's motion at rest, and by inertia, `[at][moved]`.
    pub(super) slow: [[[Slow; 2]; 2]; 2],
}

impl Surge {
    /// Finds all modes of a helix up to 20 f1, f1 that of a bar of its stiffness and mass.
    ///
    /// - `spring`, `geometry`: of which the helix is the wire: they give what a [`Motion`] needs besides (dimensions, F_nom, dead length)
    ///
    /// # Errors
    /// [`Error::Value`] for an end that is not held along the axis, a helix that has buckled, one that can turn or move as a whole without any
    /// stiffness, a spring of other windings, and as [`Modes::lowest`] and [`Spring::new`].
    pub fn new(spring: &Spring, geometry: &Geometry, helix: &Helix, ends: Ends) -> Result<Self, Error> {
        let (windings, wound) = (spring.windings(), helix.rod().parameters().windings);
        let same = (windings - wound).abs() <= SAME * wound;
        check(same, "windings", windings, "", format!("those of the helix, {wound}"))?;
        check_held(&ends)?;
        let modes = Modes::new(helix, ends)?;
        check_swings(&modes)?;
        let response = Response::new(helix, ends, 0.0)?;
        let slow = [End::One, End::Two].map(|at| [End::One, End::Two].map(|moved| response.slow_reaction(moved, at)));
        // What end 1 feels of a motion of end 2, along the axis.
        let stiffness = slow[0][1][0][2];
        let length = helix.span() - geometry.active_span(0.0);
        let spring = effective(spring, helix, stiffness, length)?;
        let reach = REACH * 0.5 * (stiffness / helix.rod().mass()).sqrt();
        let modes = modes.lowest(modes.count_below(reach)?.max(1))?;
        let masses = spring.chain_masses();
        let model = ModalModel::wire(WireModes {
            frequencies: modes.iter().map(|mode| TAU * mode.frequency()).collect(),
            reactions: [End::One, End::Two].map(|end| modes.iter().map(|mode| of_mode(mode, end)[2]).collect()),
            shapes: modes.iter().flat_map(|mode| shares_of_wire(mode, masses)).collect(),
            count: masses,
            mass: helix.rod().mass(),
            inertia: [0, 1].map(|at| [0, 1].map(|moved| slow[at][moved][1][2])),
        });
        Ok(Self { helix: *helix, ends, modes, model, spring, length, reach, slow })
    }

    /// The helix.
    pub fn helix(&self) -> &Helix {
        &self.helix
    }

    /// How its ends are held.
    pub fn ends(&self) -> &Ends {
        &self.ends
    }

    /// Its modes up to the reach, lowest first: as many as [`Modes::count_below`] counts there.
    pub fn modes(&self) -> &[Mode] {
        &self.modes
    }

    /// Up to which frequency all modes are there \[Hz\].
    pub fn reach(&self) -> f64 {
        self.reach
    }

    /// The modes as a motion takes them.
    pub fn model(&self) -> &ModalModel {
        &self.model
    }

    /// The spring with the straight line that its force follows about the helix's length: k, and the rest length `l − F/k`.
    pub fn spring(&self) -> &Spring {
        &self.spring
    }

    /// The motion of the helix under an excitation about its length.
    ///
    /// # Errors
    /// [`Error::Value`] for a mount whose end 2 is under a force or carries a mass, and for an excitation about another length than the
    /// helix's; and as [`Motion::of_modes`].
    pub fn motion(&self, mount: &Mount, excitation: &Excitation) -> Result<Motion, Error> {
        let allowed =
            "none for a motion of the helix, whose end 2 has a prescribed position (Motion::mounted takes it)";
        match mount.far_end() {
            FarEnd::Position => {}
            FarEnd::Mass(mass) => check(false, "end_mass", mass, "kg", allowed).map(|_| ())?,
            FarEnd::Force => check(false, "prescribed forces at end 2", 1.0, "", allowed).map(|_| ())?,
        }
        let mean = excitation.mean_length();
        let same = (mean - self.length).abs() <= SAME * self.length;
        check(same, "mean_length", mean, "m", format!("that of the helix, {} m", self.length))?;
        Motion::of_modes(&self.spring, self.model.clone(), mount.damping().clone(), excitation)
    }
}

/// Force and couple of a mode on what holds an end.
pub(super) fn of_mode(mode: &Mode, end: End) -> Slow {
    let reaction = mode.reaction(end);
    std::array::from_fn(|i| if i < 3 { reaction.force()[i].re } else { reaction.couple()[i - 3].re })
}

/// Both ends must be held along the axis.
fn check_held(ends: &Ends) -> Result<(), Error> {
    let free = [ends.end1, ends.end2].iter().filter(|end| end.is_free(2)).count();
    let allowed = "0 for a motion of the helix: each end has a prescribed position";
    check(free == 0, called("ends", "ends that are free along the axis"), free as f64, "", allowed).map(|_| ())
}

/// All modes must swing.
fn check_swings(modes: &Modes) -> Result<(), Error> {
    let grow = modes.growing();
    check(grow == 0, called("ends", "modes that grow, as of a spring that has buckled,"), grow as f64, "", "0")?;
    let mut loose = 0;
    while modes.frequencies(loose + 1)?[loose] == 0.0 {
        loose += 1;
    }
    let quantity = called("ends", "motions without any stiffness, as of a spring that is free to turn at both ends,");
    check(loose == 0, quantity, loose as f64, "", "0").map(|_| ())
}

/// The spring that pulls as the helix does about its length.
fn effective(spring: &Spring, helix: &Helix, stiffness: f64, length: f64) -> Result<Spring, Error> {
    let parameters = SpringParameters {
        stiffness,
        rest_length: length - helix.force() / stiffness,
        mass: helix.rod().mass(),
        nominal_force: Some(spring.nominal_force()),
        ..spring.parameters().clone()
    };
    Spring::new(parameters)?.with_masses_per_winding(spring.masses_per_winding())
}

/// Mean axial displacement of each of so many equal shares of the wire, for a modal mass of 1 kg.
fn shares_of_wire(mode: &Mode, count: usize) -> Vec<f64> {
    let shape = mode.shape();
    let pieces = shape.len() - 1;
    let along = |at: usize| shape[at][2] * mode.largest();
    let mut until = vec![0.0; pieces + 1];
    for at in 0..pieces {
        until[at + 1] = until[at] + 0.5 * (along(at) + along(at + 1));
    }
    // ∫ of the straight lines between the points, up to a share of the wire.
    let integral = |share: usize| {
        let place = (share * pieces) as f64 / count as f64;
        let at = (place as usize).min(pieces - 1);
        let part = place - at as f64;
        until[at] + part * (along(at) + 0.5 * part * (along(at + 1) - along(at)))
    };
    (0..count).map(|share| (integral(share + 1) - integral(share)) * count as f64 / pieces as f64).collect()
}

impl Modes {
    /// How many modes grow: of a helix that has buckled. Motions without stiffness do not.
    fn growing(&self) -> usize {
        self.chain.count(GROWS * self.bar())
    }
}
