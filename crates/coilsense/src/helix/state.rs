//! The helix at a length: its radius, its angle, what it pulls and turns with, and how these change with the length.
//!
//! Next door: the same without shear and extension in closed form (`inextensible`), small motions about it (`modes`).

use std::f64::consts::TAU;

use super::rod::Rod;
use crate::error::{Error, check, finite};

/// What the ends allow while the spring is brought to its length.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum Turning {
    /// Held against turning about the spring's axis.
    #[default]
    Held,
    /// One end free to turn: no couple about the axis.
    Free,
}

/// A helix stretched or compressed along its axis, in equilibrium.
///
/// The wire is a Cosserat rod: it bends, twists, shears and extends, without limit to the angles. A uniform helix stays one, so that
/// its state is two numbers: the angle g of its section and the force F along the axis,
///
/// ```text
/// l/L = sin g + F (c_a sin²g + c_s cos²g),   F cos g + F² (c_a − c_s) sin g cos g = p (T cos g − B sin g),
/// T = GJ (p sin g − p_0 sin α_0),   B = EI (p cos g − p_0 cos α_0),   c_a = 1/EA,   c_s = 1/κGA
/// ```
///
/// with p the turn per length of wire, 2π N/L held, or such that the couple C = T sin g + B cos g is zero.
///
/// Source:   derived: the energy per length, stationary in radius and angle. κ = 6 (1 + ν)²/(7 + 12ν + 4ν²) of `[Hutchinson2001]`.
/// Valid:    windings that do not touch, ends that follow the angle of the wire.
/// Accuracy: solved to 1e-14; F(l) and k(l) of a wire without shear and extension are the closed forms of [`super::inextensible`] to
///           1e-9, and the dynamic stiffness leads from one length to the next to 1e-6 of the force (`tests/helix`).
/// Differs:  ends that are clamped do not follow the angle and the radius: a layer of a winding or so at each end makes such a spring
///           stiffer than [`Helix::stiffness`], S_T by 0.04 %, a valve spring of 5.75 windings by 0.5 %.
///
/// ```
/// use coilsense::helix::{Hand, Helix, Rod, RodParameters, Turning};
///
/// let rod = Rod::new(RodParameters {
///     wire_diameter: 0.001, coil_radius: 0.005, windings: 7.6, rest_span: 0.036,
///     youngs_modulus: 206e9, shear_modulus: 206e9 / 2.6, density: 7900.0, hand: Hand::Right,
/// })?;
/// let helix = Helix::new(&rod, 0.050, Turning::Held)?;
/// assert!((helix.force() - 18.4).abs() < 0.1); // N
/// assert!(helix.coil_radius() < 0.005);
/// # Ok::<(), coilsense::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Helix {
    rod: Rod,
    span: f64,
    turning: Turning,
    pub(super) scaled: Scaled,
}

/// The state in units of a length, [`Scaled::unit`], and of EI.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Scaled {
    /// The unit of length \[m\]: the coil's radius, or the wire's length where that is less.
    pub unit: f64,
    /// EI \[N m²\].
    pub bending: f64,
    /// GJ/EI.
    pub torsion: f64,
    /// Compliance to extension.
    pub extension: f64,
    /// Compliance to shear.
    pub shear: f64,
    /// Second moment of the section over its area.
    pub inertia: f64,
    /// Length of the wire.
    pub wire: f64,
    /// g: angle of the section, above π/2 for a left-handed helix.
    pub angle: f64,
    /// p: turn per length of wire, below zero for a left-handed helix.
    pub turn: f64,
    /// Radius of the helix.
    pub radius: f64,
    /// F: force along the axis.
    pub force: f64,
    /// C: couple about the axis.
    pub couple: f64,
    /// Shear along and extension along the section's axes 1 (the wire), 3.
    pub v: [f64; 3],
    /// Twist and bend per length.
    pub u: [f64; 3],
    /// Force in the wire.
    pub n: [f64; 3],
    /// Couple in the wire.
    pub m: [f64; 3],
    /// dF/d(l/L) and dC/d(l/L).
    pub slopes: [f64; 2],
}

/// Most steps of Newton's method; five are common.
const MOST_STEPS: usize = 60;

/// A step of Newton's method after which the next is at rounding.
const SETTLED: f64 = 1e-9;

/// Longest span in lengths of wire: at 1 the coil is a straight wire.
const LONGEST: f64 = 0.995;

impl Helix {
    /// Finds the state of a wire at a span of its active windings.
    ///
    /// - `span`: l \[m\], along the axis from wire end to wire end
    ///
    /// # Errors
    /// [`Error::Value`] for a span that is not above zero and below the length of the wire, or that has no equilibrium.
    pub fn new(rod: &Rod, span: f64, turning: Turning) -> Result<Self, Error> {
        finite("span", span, "m")?;
        let most = LONGEST * rod.wire_length();
        let allowed = || format!("above zero and below {most} m, where the wire is nearly straight");
        if !(span > 0.0 && span < most) {
            check(false, "span", span, "m", allowed())?;
        }
        let scaled = Equations::new(rod, turning).solve(span / rod.wire_length()).ok_or(Error::Value {
            field: Some("span"),
            quantity: "span".into(),
            value: span,
            unit: "m",
            allowed: "one at which the helix is in equilibrium".into(),
        })?;
        Ok(Self { rod: *rod, span, turning, scaled })
    }

    /// The same wire at another span.
    ///
    /// # Errors
    /// As [`Self::new`].
    pub fn at(&self, span: f64) -> Result<Self, Error> {
        Self::new(&self.rod, span, self.turning)
    }

    /// The wire without load.
    pub fn rod(&self) -> &Rod {
        &self.rod
    }

    /// What the ends allowed while it was brought to its length.
    pub fn turning(&self) -> Turning {
        self.turning
    }

    /// l: what the active windings span along the axis \[m\].
    pub fn span(&self) -> f64 {
        self.span
    }

    /// F: force along the axis \[N\], tension positive.
    pub fn force(&self) -> f64 {
        self.scaled.force * self.scaled.bending / self.scaled.unit.powi(2)
    }

    /// C: couple about the axis that holds the ends \[N m\]; on end 2, in the sense of a right-hand screw along the axis.
    pub fn couple(&self) -> f64 {
        self.scaled.couple * self.scaled.bending / self.scaled.unit
    }

    /// k: dF/dl, the slope of the force at this length \[N/m\].
    pub fn stiffness(&self) -> f64 {
        self.scaled.slopes[0] * self.scaled.bending / self.scaled.unit.powi(2) / self.rod.wire_length()
    }

    /// dC/dF along the length \[m\]: couple per newton, both as they change with the length.
    pub fn couple_per_force(&self) -> f64 {
        self.scaled.slopes[1] / self.scaled.slopes[0] * self.scaled.unit
    }

    /// R: radius of the helix \[m\].
    pub fn coil_radius(&self) -> f64 {
        self.scaled.radius * self.scaled.unit
    }

    /// α: angle of the wire to a plane across the axis \[rad\].
    pub fn pitch_angle(&self) -> f64 {
        let s = &self.scaled;
        (self.span / self.rod.wire_length()).atan2(s.radius * s.turn.abs())
    }

    /// By how much end 2 has turned against end 1 since the wire was without load \[rad\], right-handed along the axis.
    pub fn turn(&self) -> f64 {
        let p = self.rod.parameters();
        self.swept() - p.hand.sign() * TAU * p.windings
    }

    /// ψ: angle that the helix sweeps from end 1 to end 2 \[rad\], below zero for a left-handed one.
    pub(super) fn swept(&self) -> f64 {
        self.scaled.turn * self.scaled.wire
    }

    /// What λ = (ω²) in scaled units is per \[rad²/s²\].
    pub(super) fn eigenvalue_unit(&self) -> f64 {
        let s = &self.scaled;
        self.rod.parameters().density * self.rod.area() * s.unit.powi(4) / s.bending
    }
}

/// The equations of the state, in units of a length and of EI.
struct Equations {
    rest: Scaled,
    turning: Turning,
    /// Twist and bend without load.
    u1: f64,
    u3: f64,
}

impl Equations {
    fn new(rod: &Rod, turning: Turning) -> Self {
        let p = rod.parameters();
        let unit = p.coil_radius.min(rod.wire_length());
        let slender = if rod.is_thin() { 0.0 } else { (0.25 * p.wire_diameter / unit).powi(2) };
        let ratio = p.youngs_modulus / (2.0 * p.shear_modulus);
        let wire = rod.wire_length() / unit;
        let turn = p.hand.sign() * TAU * p.windings / wire;
        let angle = (p.rest_span / unit).atan2(turn * p.coil_radius / unit * wire);
        let zero = [0.0; 3];
        let rest = Scaled {
            unit,
            bending: rod.bending(),
            torsion: 1.0 / ratio,
            extension: slender,
            shear: slender * 2.0 * ratio / rod.shear_factor(),
            inertia: slender,
            wire,
            angle,
            turn,
            radius: p.coil_radius / unit,
            force: 0.0,
            couple: 0.0,
            v: zero,
            u: zero,
            n: zero,
            m: zero,
            slopes: [0.0; 2],
        };
        Self { rest, turning, u1: turn * angle.sin(), u3: turn * angle.cos() }
    }

    /// p and dp/dg at an angle.
    fn turn(&self, s: f64, c: f64) -> (f64, f64) {
        if self.turning == Turning::Held {
            return (self.rest.turn, 0.0);
        }
        let b = self.rest.torsion;
        let weight = b * s * s + c * c;
        let p = (b * self.u1 * s + self.u3 * c) / weight;
        (p, (b * self.u1 * c - self.u3 * s - 2.0 * p * (b - 1.0) * s * c) / weight)
    }

    /// Both residuals and their derivatives by F and g, at l/L = q.
    fn residuals(&self, q: f64, force: f64, angle: f64) -> ([f64; 2], [[f64; 2]; 2]) {
        let (s, c) = angle.sin_cos();
        let (b, ca, cs) = (self.rest.torsion, self.rest.extension, self.rest.shear);
        let (p, slope) = self.turn(s, c);
        let (twist, bend) = (b * (p * s - self.u1), p * c - self.u3);
        let length = q - s - force * (ca * s * s + cs * c * c);
        let moment = force * force * s * c * (cs - ca) - force * c + p * (twist * c - bend * s);
        let by_turn = b * (2.0 * p * s - self.u1) * c - (2.0 * p * c - self.u3) * s;
        let by_angle = force * force * (c * c - s * s) * (cs - ca)
            + force * s
            + p * (b * p * c * c - twist * s + p * s * s - bend * c);
        let derivatives = [
            [-(ca * s * s + cs * c * c), -c - 2.0 * force * s * c * (ca - cs)],
            [2.0 * force * s * c * (cs - ca) - c, by_angle + by_turn * slope],
        ];
        ([length, moment], derivatives)
    }

    /// The state at l/L = q by Newton's method from that of an inextensible wire; `None` where it does not settle on one.
    fn solve(&self, q: f64) -> Option<Scaled> {
        let slope = q.asin();
        let mut angle = if self.rest.turn < 0.0 { std::f64::consts::PI - slope } else { slope };
        let mut force = {
            let (s, c) = angle.sin_cos();
            let (p, _) = self.turn(s, c);
            p * (self.rest.torsion * (p * s - self.u1) - s / c * (p * c - self.u3))
        };
        let mut last = f64::INFINITY;
        for _ in 0..MOST_STEPS {
            let (residual, derivatives) = self.residuals(q, force, angle);
            let step = solve2(derivatives, [-residual[0], -residual[1]]);
            force += step[0];
            angle += step[1];
            let size = step[0].abs() / (1.0 + force.abs()) + step[1].abs();
            // Steps stop shrinking at rounding.
            let settled = size < 1e-15 || (size < SETTLED && size >= 0.5 * last);
            last = size;
            if settled {
                break;
            }
        }
        (last < SETTLED).then(|| self.state(q, force, angle)).flatten()
    }

    fn state(&self, q: f64, force: f64, angle: f64) -> Option<Scaled> {
        let (s, c) = angle.sin_cos();
        let (b, ca, cs) = (self.rest.torsion, self.rest.extension, self.rest.shear);
        let (p, slope) = self.turn(s, c);
        let v = [1.0 + ca * force * s, 0.0, cs * force * c];
        let (twist, bend) = (b * (p * s - self.u1), p * c - self.u3);
        let (_, derivatives) = self.residuals(q, force, angle);
        let [force_slope, angle_slope] = solve2(derivatives, [-1.0, 0.0]);
        let by_angle = b * (p * c + slope * s) * s + twist * c + (slope * c - p * s) * c - bend * s;
        let radius = (v[0] * c - v[2] * s) / p;
        let good = radius > 0.0 && force_slope.is_finite() && force.is_finite();
        good.then_some(Scaled {
            angle,
            turn: p,
            radius,
            force,
            couple: twist * s + bend * c,
            v,
            u: [p * s, 0.0, p * c],
            n: [force * s, 0.0, force * c],
            m: [twist, 0.0, bend],
            slopes: [force_slope, by_angle * angle_slope],
            ..self.rest
        })
    }
}

/// Solves two linear equations.
fn solve2([[a, b], [c, d]]: [[f64; 2]; 2], [x, y]: [f64; 2]) -> [f64; 2] {
    let determinant = a * d - b * c;
    [(d * x - b * y) / determinant, (a * y - c * x) / determinant]
}
