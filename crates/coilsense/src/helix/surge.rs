//! Every motion of a helix over time: its modes, and what its ends feel at rest, made ready for [`Motion`].
//!
//! Next door: modes one by one (`mode`), what ends feel beside the axial force (`reaction_series`), the motion itself (`crate::motion`).

use std::f64::consts::{PI, TAU};

use num_complex::Complex;

use super::ends::Ends;
use super::mode::Mode;
use super::modes::Modes;
use super::mounted::{SAME, moved};
use super::response::Response;
use super::state::Helix;
use crate::error::{Error, called, check};
use crate::excitation::{End, Excitation};
use crate::geometry::Geometry;
use crate::modes::{ModalModel, SlowInertia, WireModes};
use crate::motion::Motion;
use crate::mount::Mount;
use crate::spring::{Spring, SpringParameters};

/// Up to this many times f1 all modes are found.
const REACH: f64 = 20.0;

/// An imaginary ω² over that of a bar's first mode whose square is nothing beside it.
const TINY: f64 = 1e-60;

/// An imaginary ω² over that of a bar's first mode at which modes beyond the reach are told apart from those within: well above rounding, and
/// of the terms that are left the next is (16/20²)² of it.
const TELLING: f64 = 16.0;

/// ω² over that of a bar which rounding may leave of a motion without stiffness, either way.
const NEUTRAL: f64 = 1e-8;

/// A helix between two ends that move along its axis: all its axial, torsional and sideways modes up to 20 f1, ready for a [`Motion`].
///
/// The wire's motion is that which it would follow slowly, and its modes with held ends: `y = ψ_1 u1 + ψ_2 u2 + Σ_j φ_j q_j`,
///
/// ```text
/// q̈_j + 2ζ_jω_j q̇_j + ω_j² q_j = −(c_1j ü1 + c_2j ü2),   c_ij = r_ij/ω_j²
/// F_i = F + k (u2 − u1) + Σ_j r_1j q_j − R_1 ü + T_1 u⁗,   F_o = F + k (u2 − u1) − Σ_j r_2j q_j + R_2 ü − T_2 u⁗
/// R = M − Σ_j c_j c_jᵀ,   T = S − Σ_j c_j c_jᵀ/ω_j²
/// ```
///
/// with r_ij the axial reaction of mode j at end i for a modal mass of 1 kg ([`Mode::reaction`]), F and k the force and its slope at the
/// helix's length, and R and T what modes beyond the reach follow with, `q = −c (ü/ω² − u⁗/ω⁴ + …)`. M and S are those of all modes: of the
/// dynamic stiffness `K − ω² M − ω⁴ S − …` at an imaginary ω², where the terms alternate between real and imaginary parts.
///
/// Source:   derived: modes with held ends about the slow motion that the ends give; c by reciprocity.
/// Valid:    small motions about one length, along the axis, with inputs slow against 20 f1; ringing beyond is left out. An end 2 that carries
///           a mass or is driven by a force adds its position to the modes (component modes); its energy is not told. Winding i of a [`Motion`] is the mean of its share of the wire, along the axis; of a start winding by winding, only the
///           axial part is known. Windings stand evenly from end to end at rest, dead windings or not, as the chain's do.
/// Accuracy: forces under sines below 0.75 f1 are those of [`Response`] to 1e-7 of their dynamic part, and with the modes below 10 f1 alone
///           to 4e-7; work and energy agree to 1e-10 (`tests/helix`).
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
    pub(super) model: ModalModel,
    pub(super) spring: Spring,
    pub(super) length: f64,
    reach: f64,
    /// What each end feels of each end's slow motion, `[at][moved]`.
    pub(super) slow: [[Slow; 2]; 2],
}

/// Force along x, y, z and couple about them on what holds an end.
pub(super) type Six = [f64; 6];

/// What an end feels of a slow motion u of one: `rest u − mass ü + second u⁗ − …`.
#[derive(Debug, Clone, Copy)]
pub(super) struct Slow {
    pub rest: Six,
    pub mass: Six,
    pub second: Six,
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
        let stiffness = response.reaction_at(Complex::ZERO, End::Two, End::One)?[2].re;
        let length = helix.span() - geometry.active_span(0.0);
        let spring = effective(spring, helix, stiffness, length)?;
        let first = PI * (stiffness / helix.rod().mass()).sqrt();
        let reach = REACH * first / TAU;
        let modes = modes.lowest(modes.count_below(reach)?.max(1))?;
        let pair = |at: End| -> Result<[Slow; 2], Error> {
            Ok([
                Slow::of(&response, &modes, first, [End::One, at])?,
                Slow::of(&response, &modes, first, [End::Two, at])?,
            ])
        };
        let slow = [pair(End::One)?, pair(End::Two)?];
        let along = |of: fn(&Slow) -> &Six| [0, 1].map(|at| [0, 1].map(|moved| of(&slow[at][moved])[2]));
        let masses = spring.chain_masses();
        let model = ModalModel::wire(WireModes {
            frequencies: modes.iter().map(|mode| TAU * mode.frequency()).collect(),
            reactions: [End::One, End::Two].map(|end| modes.iter().map(|mode| of_mode(mode, end)[2]).collect()),
            shapes: modes.iter().flat_map(|mode| shares_of_wire(mode, masses)).collect(),
            count: masses,
            mass: helix.rod().mass(),
            inertia: SlowInertia { mass: along(|slow| &slow.mass), second: along(|slow| &slow.second) },
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
    /// [`Error::Value`] for an excitation about another length than the helix's; and as [`Motion::of_modes`].
    pub fn motion(&self, mount: &Mount, excitation: &Excitation) -> Result<Motion, Error> {
        moved(&self.spring, &self.model, self.length, mount, excitation)
    }
}

impl Slow {
    /// - `first`: ω of a bar's first mode \[rad/s\]; `moved` and `at`: the end that moves and the one that feels it
    ///
    /// With ω² imaginary the terms alternate between real and imaginary parts, so that none is a small difference of large numbers.
    fn of(response: &Response, modes: &[Mode], first: f64, [moved, at]: [End; 2]) -> Result<Self, Error> {
        let (tiny, telling) = (TINY * first * first, TELLING * first * first);
        let slow = response.reaction_at(Complex::new(0.0, tiny), moved, at)?;
        let (rest, mass): (Six, Six) = (slow.map(|value| value.re), slow.map(|value| value.im / tiny));
        let imaginary = Complex::new(0.0, telling);
        let mut beyond = response.reaction_at(imaginary, moved, at)?;
        let mut second = [0.0; 6];
        for mode in modes {
            let (felt, square) = (of_mode(mode, at), (TAU * mode.frequency()).powi(2));
            let carried = of_mode(mode, moved)[2] / square;
            for i in 0..6 {
                beyond[i] -= felt[i] * carried * imaginary / (square - imaginary);
                second[i] += felt[i] * carried / (square * square);
            }
        }
        for i in 0..6 {
            second[i] -= (beyond[i].re - rest[i]) / (telling * telling);
        }
        Ok(Self { rest, mass, second })
    }
}

/// Force and couple of a mode on what holds an end.
pub(super) fn of_mode(mode: &Mode, end: End) -> Six {
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
    let [grow, neutral] = modes.unstable();
    check(grow == 0, called("ends", "modes that grow, as of a spring that has buckled,"), grow as f64, "", "0")?;
    // Rounding of a long thin wire may hide the turning in a count: it is known from the ends.
    let turns = [modes.ends().end1, modes.ends().end2].iter().all(|end| end.is_free(5));
    let loose = neutral.max(usize::from(turns));
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
    let bend = |at: usize| along(at - 1) - 2.0 * along(at) + along(at + 1);
    // ∫ over a part of a piece: straight from point to point, less what the bend of both points adds.
    let within = |at: usize, part: f64| {
        let bend = match at {
            0 => bend(1),
            at if at + 1 == pieces => bend(at),
            at => 0.5 * (bend(at) + bend(at + 1)),
        };
        let rise = along(at + 1) - along(at);
        part * (along(at) + part * (0.5 * rise - bend * (0.25 - part / 6.0)))
    };
    let mut until = vec![0.0; pieces + 1];
    for at in 0..pieces {
        until[at + 1] = until[at] + within(at, 1.0);
    }
    let integral = |share: usize| {
        let place = (share * pieces) as f64 / count as f64;
        let at = (place as usize).min(pieces - 1);
        until[at] + within(at, place - at as f64)
    };
    (0..count).map(|share| (integral(share + 1) - integral(share)) * count as f64 / pieces as f64).collect()
}

impl Modes {
    /// How many modes grow, of a helix that has buckled, and how many neither grow nor swing, having no stiffness.
    fn unstable(&self) -> [usize; 2] {
        let grow = self.chain.count(-NEUTRAL * self.bar());
        [grow, self.chain.count(NEUTRAL * self.bar()) - grow]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::{EndType, Material, MaterialParameters};
    use crate::helix::{Hand, Rod, StiffnessAt, Turning};

    #[test]
    fn what_is_left_out_is_what_a_bars_modes_beyond_would_carry() {
        let steel = Material::new(MaterialParameters::elastic(81.5e9, 206e9, 7850.0)).unwrap();
        let (spring, length) = (crate::paper::s_t(), 0.230);
        let geometry = Geometry::of_spring(&spring, EndType::Hooks, steel).unwrap();
        let rod = Rod::of_spring(&spring, &geometry, StiffnessAt::Range, Hand::Right).unwrap();
        let helix = Helix::new(&rod, length, Turning::Held).unwrap();
        let surge = Surge::new(&spring, &geometry, &helix, Ends::clamped()).unwrap();
        let left_out = surge.model().left_out().unwrap();
        let [[a, b], [c, d]] = left_out.per_acceleration;
        // Inertia is alike from both ends, above zero, and drops from term to term.
        assert!((a + d).abs() < 1e-3 * d && (b + c).abs() < 1e-3 * d && b.abs() < 0.1 * d, "{a} {b} {c} {d}");
        // 2m/(π²j²) of a bar's mode j; S_T has 20 axial modes below 20 f1.
        let axial = surge.modes().iter().filter(|mode| mode.line_strength() > 0.5).count();
        let beyond = |power: i32| (axial + 1..100_000).map(|mode| (mode as f64).powi(-power)).sum::<f64>();
        let (mass, first) = (2.0 * rod.mass() / PI.powi(2), PI * surge.spring().transit_time().recip());
        let bars = [mass * beyond(2), mass * beyond(4) / (first * first)];
        let ours = [d, -left_out.per_snap[1][1]];
        // 8 % more and 9 % less than a bar's, for axial modes of the helix crowd and mix; the first would be 8000 % of it.
        assert!(ours.iter().zip(bars).all(|(ours, bar)| (ours / bar - 1.0).abs() < 0.1), "{ours:?} {bars:?}");
    }
}
