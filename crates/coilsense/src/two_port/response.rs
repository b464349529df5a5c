//! The spring as a two-port at one frequency: stiffness, receptance, transmission.
//!
//! Next door: how it is made (`super::TwoPort`), what gets through to a load on end 2 (`loaded`).

use num_complex::Complex64;

use super::propagation::Inertia;
use super::trigonometry::quotient;

/// A 2 × 2 complex matrix, `[row][column]`.
pub type Matrix = [[Complex64; 2]; 2];

/// The spring seen from its two ends at one angular frequency; made by [`super::TwoPort::at`].
///
/// \[F_i; F_o\] = \[\[−k_d, k_t\], \[−k_t, k_d\]\] \[U1; U2\]
///
/// Reciprocity and the spring's mirror symmetry leave two numbers: the drive-point stiffness k_d and the transfer stiffness k_t,
/// both k at rest. At a pole of an undamped spring, hit exactly, they are infinite and the ratios below keep their limits.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DynamicStiffness {
    /// K: stiffness of the spring without mass \[N/m\], complex with hysteresis.
    pub(super) rest: Complex64,
    /// m \[kg\].
    pub(super) mass: f64,
    /// m ω² \[N/m\].
    pub(super) massive: f64,
    pub(super) inertia: Inertia,
    /// k_t \[N/m\].
    pub(super) transfer: Complex64,
}

/// k_t, k_d, p q and 1, all over one factor that keeps them finite; p = k_d − k_t, q = k_d + k_t.
pub(super) struct Ratios {
    pub transfer: Complex64,
    pub drive: Complex64,
    pub product: Complex64,
    pub one: Complex64,
}

impl DynamicStiffness {
    /// Drive-point stiffness \[N/m\]: −F_i/U1 with end 2 held, and F_o/U2 with end 1 held.
    ///
    /// k_d = 2Nk tan(θ/2) cot(Nθ), sin(θ/2) = ωτ/2N; the wave: k ωτ cot(ωτ); with damping K − m ω² (μ + ν)/2, see [`super::TwoPort`]
    ///
    /// Source:   `[Weijde2017]` eqs. 5–7 with harmonic ends.
    /// Valid:    windings that never touch.
    /// Accuracy: 2e-15 (30 + κ) relative with κ = |d ln / d ln ω|, against 25-digit direct solves for N ≤ 52 up to twice the cut-off.
    ///
    /// ```
    /// # let spring = coilsense::paper::s_t();
    /// use coilsense::{Damping, two_port::TwoPort};
    ///
    /// let still = TwoPort::chain(&spring, Damping::None)?.at(0.0)?;
    /// assert_eq!(still.drive_point().re, spring.stiffness());
    /// # Ok::<(), coilsense::Error>(())
    /// ```
    pub fn drive_point(&self) -> Complex64 {
        self.rest + self.drive_point_inertia()
    }

    /// Transfer stiffness \[N/m\]: F_i/U2 with end 1 held, and −F_o/U1 with end 2 held.
    ///
    /// k_t = 2Nk tan(θ/2) / sin(Nθ); the wave: k ωτ / sin(ωτ); with damping K + m ω² (μ − ν)/2
    ///
    /// Source:   as [`Self::drive_point`].
    /// Valid:    windings that never touch.
    /// Accuracy: as [`Self::drive_point`], also where it decays above cut-off; with modal ratios relative to k_d there.
    ///
    /// ```
    /// # let spring = coilsense::paper::s_t();
    /// use coilsense::{Damping, two_port::TwoPort};
    /// let moving = TwoPort::chain(&spring, Damping::None)?.at(100.0)?;
    /// assert!(moving.transfer().re > spring.stiffness() && moving.drive_point().re < spring.stiffness());
    /// # Ok::<(), coilsense::Error>(())
    /// ```
    pub fn transfer(&self) -> Complex64 {
        self.transfer
    }

    /// What the spring's mass adds to the drive-point stiffness \[N/m\]: k_d − K = −m ω² (μ + ν)/2, −m ω² (⅓ + …) at low frequency.
    ///
    /// Source:   as [`Self::drive_point`].
    /// Valid:    windings that never touch.
    /// Accuracy: as [`Self::drive_point`], and so down to ω = 0: no difference of stiffnesses is taken.
    ///
    /// ```
    /// # let spring = coilsense::paper::s_t();
    /// use coilsense::{Damping, two_port::TwoPort};
    /// let slow = TwoPort::wave(&spring, Damping::None)?.at(1e-6)?;
    /// assert!((slow.drive_point_inertia().re / (spring.mass() * 1e-12) + 1.0 / 3.0).abs() < 1e-12);
    /// # Ok::<(), coilsense::Error>(())
    /// ```
    pub fn drive_point_inertia(&self) -> Complex64 {
        -0.5 * self.massive * (self.inertia.together + self.inertia.apart)
    }

    /// What the spring's mass adds to the transfer stiffness \[N/m\]: k_t − K = m ω² (μ − ν)/2, m ω² (1/6 + …) at low frequency.
    ///
    /// Source:   as [`Self::drive_point`].
    /// Valid:    windings that never touch.
    /// Accuracy: as [`Self::drive_point_inertia`]; with modal ratios relative to k_d.
    ///
    /// ```
    /// # let spring = coilsense::paper::s_t();
    /// use coilsense::{Damping, two_port::TwoPort};
    /// let slow = TwoPort::wave(&spring, Damping::None)?.at(1e-6)?;
    /// assert!((slow.transfer_inertia().re / (spring.mass() * 1e-12) - 1.0 / 6.0).abs() < 1e-12);
    /// # Ok::<(), coilsense::Error>(())
    /// ```
    pub fn transfer_inertia(&self) -> Complex64 {
        0.5 * self.massive * (self.inertia.together - self.inertia.apart)
    }

    /// Dynamic stiffness matrix D \[N/m\]: \[F_i; F_o\] = D \[U1; U2\].
    ///
    /// D = \[\[−k_d, k_t\], \[−k_t, k_d\]\]. Forces are tension-positive: reciprocity reads D_12 = −D_21.
    ///
    /// Source:   as [`Self::drive_point`], mirrored for end 1.
    /// Valid:    windings that never touch.
    /// Accuracy: that of its entries.
    ///
    /// ```
    /// # let spring = coilsense::paper::s_t();
    /// use coilsense::{Damping, two_port::TwoPort};
    /// let [[f_i_by_u1, f_i_by_u2], [f_o_by_u1, f_o_by_u2]] = TwoPort::chain(&spring, Damping::None)?.at(0.0)?.matrix();
    /// assert_eq!([f_i_by_u1, f_o_by_u1], [-f_i_by_u2, -f_o_by_u2]); // moved as a whole, it feels nothing at rest
    /// # Ok::<(), coilsense::Error>(())
    /// ```
    pub fn matrix(&self) -> Matrix {
        let (drive, transfer) = (self.drive_point(), self.transfer());
        [[-drive, transfer], [-transfer, drive]]
    }

    /// Receptance D⁻¹ \[m/N\]: \[U1; U2\] = D⁻¹ \[F_i; F_o\].
    ///
    /// D⁻¹ = \[\[−k_d, k_t\], \[−k_t, k_d\]\] / (k_d² − k_t²); infinite at ω = 0, where a free spring floats away
    ///
    /// Source:   inverse of [`Self::matrix`], k_d² − k_t² as (k_d − k_t)(k_d + k_t).
    /// Valid:    ω ≠ 0.
    /// Accuracy: as [`Self::drive_point`], away from the free–free resonances.
    ///
    /// ```
    /// # let spring = coilsense::paper::s_t();
    /// use coilsense::{Damping, two_port::TwoPort};
    /// let ends = TwoPort::chain(&spring, Damping::None)?.at(0.1)?;
    /// // Pulled slowly at end 2, free at end 1, it moves as a rigid mass: U2 = −F_o / m ω².
    /// assert!((ends.receptance()[1][1].re * spring.mass() * 0.01 + 1.0).abs() < 1e-5);
    /// # Ok::<(), coilsense::Error>(())
    /// ```
    pub fn receptance(&self) -> Matrix {
        let ratios = self.ratios();
        let drive = quotient(ratios.drive, ratios.product);
        let transfer = quotient(ratios.transfer, ratios.product);
        [[-drive, transfer], [-transfer, drive]]
    }

    /// Transmission (ABCD) matrix: \[U2; F_o\] = T \[U1; F_i\], entries \[1, m/N; N/m, 1\]; springs in series multiply, T of end 1's last.
    ///
    /// T = \[\[k_d, 1\], \[k_d² − k_t², k_d\]\] / k_t, det T = 1; undamped \[\[cos Nθ, sin(Nθ)/Z\], \[−Z sin Nθ, cos Nθ\]\], Z = 2Nk tan(θ/2)
    ///
    /// Source:   [`Self::matrix`] solved for end 2.
    /// Valid:    where k_t has not underflowed (far above cut-off, Im Nθ > 700); infinite there.
    /// Accuracy: as [`Self::drive_point`], relative to the largest term.
    ///
    /// ```
    /// # let spring = coilsense::paper::s_t();
    /// use coilsense::{Damping, two_port::TwoPort};
    /// let [[a, b], [c, d]] = TwoPort::wave(&spring, Damping::None)?.at(100.0)?.transmission();
    /// assert!((a.re - (100.0 * spring.transit_time()).cos()).abs() < 1e-14);
    /// assert!((a * d - b * c - 1.0).norm() < 1e-14);
    /// # Ok::<(), coilsense::Error>(())
    /// ```
    pub fn transmission(&self) -> Matrix {
        let ratios = self.ratios();
        let by = |entry: Complex64| quotient(entry, ratios.transfer);
        [[by(ratios.drive), by(ratios.one)], [by(ratios.product), by(ratios.drive)]]
    }

    /// p, q: stiffness of both ends moved together and apart.
    fn pair(&self) -> (Complex64, Complex64) {
        let together = -self.massive * self.inertia.together;
        (together, 2.0 * self.rest - self.massive * self.inertia.apart)
    }

    /// μ q over the same factor as [`Self::ratios`].
    pub(super) fn together_by_mass(&self) -> Complex64 {
        if self.is_regular() {
            return self.inertia.together * self.pair().1;
        }
        Complex64::from(-1.0 / self.massive)
    }

    /// Away from a pole hit exactly.
    fn is_regular(&self) -> bool {
        self.drive_point().is_finite() && self.transfer.is_finite()
    }

    /// Over 1, or over p q at a pole: k_t/pq = (1/p − 1/q)/2, k_d/pq = (1/p + 1/q)/2.
    pub(super) fn ratios(&self) -> Ratios {
        let (together, apart) = self.pair();
        if self.is_regular() {
            return Ratios {
                transfer: self.transfer,
                drive: self.drive_point(),
                product: together * apart,
                one: Complex64::ONE,
            };
        }
        let yields = (quotient(Complex64::ONE, together), quotient(Complex64::ONE, apart));
        Ratios {
            transfer: 0.5 * (yields.0 - yields.1),
            drive: 0.5 * (yields.0 + yields.1),
            product: Complex64::ONE,
            one: yields.0 * yields.1,
        }
    }

    /// The same at the mirrored frequency −ω.
    pub(super) fn conjugate(self) -> Self {
        Self {
            rest: self.rest.conj(),
            inertia: Inertia { together: self.inertia.together.conj(), apart: self.inertia.apart.conj() },
            transfer: self.transfer.conj(),
            ..self
        }
    }
}
