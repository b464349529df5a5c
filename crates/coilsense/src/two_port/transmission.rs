//! A cascade at one frequency: its matrices, and what gets through to a load on its last end.
//!
//! Next door: what it is made of (`cascade`), the same for one spring, which is symmetric (`response`, `loaded`).

use num_complex::Complex64;

use super::load::{Kind, Load};
use super::response::{DynamicStiffness, Matrix};
use super::trigonometry::quotient;
use crate::excitation::End;

/// A cascade seen from its two ends at one angular frequency; made by [`super::Cascade::at`].
///
/// t \[U2; F_o\] = \[\[a, b\], \[−ω² c, d\]\] \[U1; F_i\], with a d + ω² b c = t²
///
/// Kept over a common factor, five numbers stay finite where the matrices are not: where an inner joint rings undamped while both outer ends are
/// held (b = 0, the two sides' stiffnesses cancel), which is a resonance as any other, stiffnesses are infinite and ratios keep their limits; so
/// it is at the poles of a single spring, and for rigid masses. Where nothing gets through (t = 0) the transmission matrix is infinite.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Transmission {
    square: f64,
    /// a
    near: Complex64,
    /// b, the compliance's part.
    apart: Complex64,
    /// c, without −ω²: what is felt of the masses.
    inertia: Complex64,
    /// d
    far: Complex64,
    /// t
    through: Complex64,
}

impl Transmission {
    /// Ends that are one point.
    pub(super) fn nothing(omega: f64) -> Self {
        let (one, zero) = (Complex64::ONE, Complex64::ZERO);
        Self { square: omega * omega, near: one, apart: zero, inertia: zero, far: one, through: one }
    }

    pub(super) fn mass(mass: f64, omega: f64) -> Self {
        Self { inertia: mass.into(), ..Self::nothing(omega) }
    }

    /// Of a stiffness k + jωc.
    pub(super) fn link(stiffness: Complex64, omega: f64) -> Self {
        let (one, zero) = (Complex64::ONE, Complex64::ZERO);
        let square = omega * omega;
        Self { square, near: stiffness, apart: one, inertia: zero, far: stiffness, through: stiffness }
    }

    pub(super) fn spring(at: &DynamicStiffness, omega: f64) -> Self {
        let ratios = at.ratios();
        Self {
            square: omega * omega,
            near: ratios.drive,
            apart: ratios.one,
            inertia: at.together_by_mass() * at.mass,
            far: ratios.drive,
            through: ratios.transfer,
        }
    }

    /// This, then `next`, over a power of two that keeps a long cascade from overflowing.
    pub(super) fn then(&self, next: &Self) -> Self {
        let product = Self {
            square: self.square,
            near: next.near * self.near - self.square * next.apart * self.inertia,
            apart: next.near * self.apart + next.apart * self.far,
            inertia: next.inertia * self.near + next.far * self.inertia,
            far: next.far * self.far - self.square * next.inertia * self.apart,
            through: next.through * self.through,
        };
        let parts = [product.near, product.apart, product.far, product.through];
        let largest = parts.iter().fold(0.0_f64, |largest, part| largest.max(part.re.abs()).max(part.im.abs()));
        if !(largest.is_normal()) {
            return product;
        }
        let scale = largest.log2().floor().exp2().recip();
        Self {
            square: product.square,
            near: product.near * scale,
            apart: product.apart * scale,
            inertia: product.inertia * scale,
            far: product.far * scale,
            through: product.through * scale,
        }
    }

    /// −ω² c
    fn product(&self) -> Complex64 {
        -self.square * self.inertia
    }

    /// Drive-point stiffness \[N/m\]: −F_i/U1 with end 2 held, or F_o/U2 with end 1 held.
    ///
    /// a/b and d/b
    ///
    /// - `end`: which of them moves
    ///
    /// Source:   [`Self::transmission`] solved for the forces.
    /// Valid:    as the parts.
    /// Accuracy: as [`super::Cascade`].
    ///
    /// ```
    /// use coilsense::{End, two_port::Cascade};
    /// let two = Cascade::link(300.0, 0.0)?.then(&Cascade::link(600.0, 0.0)?).at(0.0)?;
    /// assert_eq!(two.drive_point(End::One).re, 200.0); // 1/300 + 1/600
    /// # Ok::<(), coilsense::Error>(())
    /// ```
    pub fn drive_point(&self, end: End) -> Complex64 {
        quotient(if end == End::One { self.near } else { self.far }, self.apart)
    }

    /// Transfer stiffness \[N/m\]: F_i/U2 with end 1 held, and −F_o/U1 with end 2 held.
    ///
    /// t/b: the same both ways, for all parts are reciprocal
    ///
    /// Source:   as [`Self::drive_point`].
    /// Valid:    as the parts.
    /// Accuracy: as [`super::Cascade`].
    ///
    /// ```
    /// use coilsense::two_port::Cascade;
    /// let two = Cascade::link(300.0, 0.0)?.then(&Cascade::link(600.0, 0.0)?).at(0.0)?;
    /// assert_eq!(two.transfer().re, 200.0);
    /// # Ok::<(), coilsense::Error>(())
    /// ```
    pub fn transfer(&self) -> Complex64 {
        quotient(self.through, self.apart)
    }

    /// Dynamic stiffness matrix D \[N/m\]: \[F_i; F_o\] = D \[U1; U2\].
    ///
    /// D = \[\[−a, t\], \[−t, d\]\] / b; infinite where the ends cannot move apart
    ///
    /// Source:   as [`Self::drive_point`].
    /// Valid:    as the parts.
    /// Accuracy: as [`super::Cascade`].
    ///
    /// ```
    /// use coilsense::two_port::Cascade;
    /// let hung = Cascade::link(300.0, 0.0)?.then(&Cascade::mass(2.0)?).at(10.0)?;
    /// assert_eq!(hung.matrix()[1][1].re, 300.0 - 2.0 * 100.0); // k − M ω² at the mass
    /// # Ok::<(), coilsense::Error>(())
    /// ```
    pub fn matrix(&self) -> Matrix {
        let transfer = self.transfer();
        [[-self.drive_point(End::One), transfer], [-transfer, self.drive_point(End::Two)]]
    }

    /// Receptance D⁻¹ \[m/N\]: \[U1; U2\] = D⁻¹ \[F_i; F_o\].
    ///
    /// D⁻¹ = \[\[d, −t\], \[t, −a\]\] / ω² c; infinite at ω = 0, where all floats away, and everywhere without masses
    ///
    /// Source:   [`Self::transmission`] solved for the displacements.
    /// Valid:    ω ≠ 0.
    /// Accuracy: as [`super::Cascade`], away from the free–free resonances.
    ///
    /// ```
    /// use coilsense::two_port::Cascade;
    /// let hung = Cascade::link(300.0, 0.0)?.then(&Cascade::mass(2.0)?).at(10.0)?;
    /// assert_eq!(hung.receptance()[1][1].re, -1.0 / 200.0); // pulled at the mass, −1/M ω²
    /// # Ok::<(), coilsense::Error>(())
    /// ```
    pub fn receptance(&self) -> Matrix {
        let by = |entry: Complex64| quotient(entry, self.product());
        let through = by(self.through);
        [[-by(self.far), through], [-through, by(self.near)]]
    }

    /// Transmission (ABCD) matrix: \[U2; F_o\] = T \[U1; F_i\], entries \[1, m/N; N/m, 1\]; those of parts in series multiply, end 1's last.
    ///
    /// T = \[\[a, b\], \[−ω² c, d\]\] / t, det T = 1; infinite where nothing gets through
    ///
    /// Source:   definition.
    /// Valid:    as the parts.
    /// Accuracy: as [`super::Cascade`], relative to the largest term.
    ///
    /// ```
    /// use coilsense::two_port::Cascade;
    /// let mass = Cascade::mass(2.0)?.at(10.0)?.transmission();
    /// assert_eq!((mass[0][0].re, mass[1][0].re), (1.0, -200.0)); // moves as one, and takes M ω²
    /// # Ok::<(), coilsense::Error>(())
    /// ```
    pub fn transmission(&self) -> Matrix {
        let by = |entry: Complex64| quotient(entry, self.through);
        [[by(self.near), by(self.apart)], [by(self.product()), by(self.far)]]
    }

    /// Transmittance \[1\]: F_o/F_i, force in at end 1, force out at the load on end 2.
    ///
    /// t / (a − ω² c / K_L); a mass: t / (a + c/M), M/(M + m) at rest; held: t/a
    ///
    /// - `load`: on end 2
    ///
    /// Source:   [`Self::transmission`] with F_o = −K_L U2.
    /// Valid:    as the parts; a free end takes no force: 0.
    /// Accuracy: as [`super::Cascade`].
    ///
    /// ```
    /// use coilsense::two_port::{Cascade, Load};
    /// let mass = Cascade::mass(2.0)?.at(0.0)?;
    /// assert_eq!(mass.transmittance(&Load::mass(6.0)?).re, 0.75); // what accelerates the first does not arrive
    /// # Ok::<(), coilsense::Error>(())
    /// ```
    pub fn transmittance(&self, load: &Load) -> Complex64 {
        match load.0 {
            Kind::Held => quotient(self.through, self.near),
            Kind::Mass(0.0) => Complex64::ZERO,
            Kind::Mass(mass) => quotient(self.through, self.near + self.inertia / mass),
            Kind::Stiffness(stiffness) if stiffness.norm() == 0.0 => Complex64::ZERO,
            Kind::Stiffness(stiffness) => quotient(self.through, self.near + quotient(self.product(), stiffness)),
        }
    }

    /// How far end 2 follows end 1 \[1\]: U2/U1 with end 1 moved and the load on end 2.
    ///
    /// t / (d + K_L b)
    ///
    /// - `load`: on end 2
    ///
    /// Source:   as [`Self::transmittance`].
    /// Valid:    as the parts.
    /// Accuracy: as [`super::Cascade`].
    ///
    /// ```
    /// use coilsense::two_port::{Cascade, Load};
    /// let link = Cascade::link(300.0, 0.0)?.at(10.0)?;
    /// assert_eq!(link.motion_ratio(&Load::mass(2.0)?).re, 3.0); // 300 / (300 − 200)
    /// # Ok::<(), coilsense::Error>(())
    /// ```
    pub fn motion_ratio(&self, load: &Load) -> Complex64 {
        self.stiffness_of(load)
            .map_or(Complex64::ZERO, |stiffness| quotient(self.through, self.far + stiffness * self.apart))
    }

    /// Stiffness at end 1 with a load on end 2 \[N/m\]: −F_i/U1.
    ///
    /// (−ω² c + K_L a) / (d + K_L b); a/b where end 2 is held
    ///
    /// - `load`: on end 2
    ///
    /// Source:   as [`Self::transmittance`].
    /// Valid:    as the parts.
    /// Accuracy: as [`super::Cascade`], relative to the largest term.
    ///
    /// ```
    /// use coilsense::two_port::{Cascade, Load};
    /// let mass = Cascade::mass(2.0)?.at(10.0)?;
    /// assert_eq!(mass.loaded(&Load::FREE).re, -200.0); // a mass by itself
    /// # Ok::<(), coilsense::Error>(())
    /// ```
    pub fn loaded(&self, load: &Load) -> Complex64 {
        match self.stiffness_of(load) {
            None => self.drive_point(End::One),
            Some(stiffness) => quotient(self.product() + stiffness * self.near, self.far + stiffness * self.apart),
        }
    }

    /// K_L \[N/m\], None where held.
    fn stiffness_of(&self, load: &Load) -> Option<Complex64> {
        load.at(self.square.sqrt())
    }
}
