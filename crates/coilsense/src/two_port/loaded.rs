//! What gets through the spring to a load on end 2: force, motion, and the stiffness that end 1 then has.
//!
//! Next door: the spring itself (`response`), the kinds of load (`load`).

use num_complex::Complex64;

use super::load::{Kind, Load};
use super::response::{DynamicStiffness, Ratios};
use super::trigonometry::quotient;

impl DynamicStiffness {
    /// Transmittance \[1\]: F_o/F_i, force in at end 1, force out at the load on end 2.
    ///
    /// F_o/F_i = k_t / (k_d + (k_d² − k_t²)/K_L); held: k_t/k_d = 1/cos(Nθ) undamped; end mass: M/(M + m) at ω = 0.
    /// The same number is F_i/F_o with force in at end 2 and the load on end 1.
    ///
    /// - `load`: on end 2
    ///
    /// Source:   `[Weijde2017]` eq. 1 with chain, damping and load; [`Self::matrix`] with F_o = −K_L U2.
    /// Valid:    windings that never touch; a free end takes no force: 0.
    /// Accuracy: as [`Self::drive_point`]; with modal ratios relative to k_d/k_t where k_t decays.
    ///
    /// ```
    /// # let spring = coilsense::paper::s_t();
    /// use coilsense::Damping;
    /// use coilsense::two_port::{Load, TwoPort};
    ///
    /// let spring = TwoPort::wave(&spring, Damping::Modal(0.005))?;
    /// let at_surge = spring.at(std::f64::consts::TAU * 27.03)?;
    /// assert!(at_surge.transmittance(&Load::HELD).norm() > 50.0); // the first fixed–free resonance
    /// assert!(at_surge.transmittance(&Load::mass(0.1)?).norm() < 3.0); // no longer one
    /// # Ok::<(), coilsense::Error>(())
    /// ```
    pub fn transmittance(&self, load: &Load) -> Complex64 {
        let Ratios { transfer, drive, product, .. } = self.ratios();
        match load.0 {
            Kind::Held => quotient(transfer, drive),
            Kind::Mass(0.0) => Complex64::ZERO,
            Kind::Mass(mass) => {
                // p q / K_L = (m/M) μ q: no ω² left to divide by.
                let through = self.together_by_mass() * (self.mass / mass);
                quotient(transfer, drive + through)
            }
            Kind::Stiffness(stiffness) if stiffness.norm() == 0.0 => Complex64::ZERO,
            Kind::Stiffness(stiffness) => quotient(transfer, drive + quotient(product, stiffness)),
        }
    }

    /// How far end 2 follows end 1 \[1\]: U2/U1 with end 1 moved and the load on end 2.
    ///
    /// U2/U1 = k_t / (k_d + K_L); with an end mass its poles are β tan β = m/M (wave, β = ωτ), N sin θ tan(Nθ) = m/M (chain)
    ///
    /// - `load`: on end 2
    ///
    /// Source:   [`Self::matrix`] with F_o = −K_L U2.
    /// Valid:    windings that never touch.
    /// Accuracy: as [`Self::transmittance`].
    ///
    /// ```
    /// # let spring = coilsense::paper::s_t();
    /// use coilsense::Damping;
    /// use coilsense::two_port::{Load, TwoPort};
    /// let ends = TwoPort::chain(&spring, Damping::None)?.at(0.0)?;
    /// assert_eq!(ends.motion_ratio(&Load::mass(1.0)?).re, 1.0); // carried along
    /// # Ok::<(), coilsense::Error>(())
    /// ```
    pub fn motion_ratio(&self, load: &Load) -> Complex64 {
        let Ratios { transfer, drive, one, .. } = self.ratios();
        match self.stiffness_of(load) {
            None => Complex64::ZERO,
            Some(stiffness) => quotient(transfer, drive + one * stiffness),
        }
    }

    /// Stiffness at end 1 with a load on end 2 \[N/m\]: −F_i/U1.
    ///
    /// −F_i/U1 = (k_d K_L + k_d² − k_t²) / (k_d + K_L); k_d where end 2 is held
    ///
    /// - `load`: on end 2
    ///
    /// Source:   [`Self::matrix`] with F_o = −K_L U2.
    /// Valid:    windings that never touch.
    /// Accuracy: as [`Self::transmittance`], relative to the largest term.
    ///
    /// ```
    /// # let spring = coilsense::paper::s_t();
    /// use coilsense::Damping;
    /// use coilsense::two_port::{Load, TwoPort};
    /// let ends = TwoPort::chain(&spring, Damping::None)?.at(0.0)?;
    /// let same = Load::stiffness(spring.stiffness().into())?;
    /// assert_eq!(ends.loaded(&same).re, 0.5 * spring.stiffness()); // two alike in series
    /// # Ok::<(), coilsense::Error>(())
    /// ```
    pub fn loaded(&self, load: &Load) -> Complex64 {
        let Ratios { drive, product, one, .. } = self.ratios();
        match self.stiffness_of(load) {
            None => quotient(drive, one),
            Some(stiffness) => quotient(drive * stiffness + product, drive + one * stiffness),
        }
    }

    /// K_L \[N/m\], None where held; −M ω² from m ω².
    fn stiffness_of(&self, load: &Load) -> Option<Complex64> {
        match load.0 {
            Kind::Held => None,
            Kind::Mass(mass) => Some(Complex64::from(-mass / self.mass * self.massive)),
            Kind::Stiffness(stiffness) => Some(stiffness),
        }
    }
}
