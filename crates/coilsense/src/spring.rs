//! The spring: what Table I of the paper gives, checked, and what follows from it alone.
//!
//! Next door: how fast a wave runs through it (`surge`), its vibration modes (`modes`), its inductance (`inductance`), what is done to it (`excitation`).

mod parameters;
mod surge;
mod wire;

use std::sync::Arc;

use crate::error::{Error, above_zero, check, finite};
use crate::sections::Sections;
pub use parameters::SpringParameters;

/// A spring whose every value has been checked.
///
/// ```
/// use coilsense::{Spring, SpringParameters};
///
/// // S_T of the paper: the ankle spring of the humanoid TUlip.
/// let spring = Spring::new(SpringParameters {
///     rest_length: 0.104,
///     windings: 52.0,
///     coil_radius: 0.008,
///     wire_radius: 0.001,
///     mass: 0.065,
///     stiffness: 760.0,
///     min_length: 0.196,
///     max_length: 0.264,
///     nominal_force: None,
///     inductance_windings: None,
///     sections: None,
/// })?;
/// assert!((spring.transit_time() - 9.248e-3).abs() < 1e-6);
/// assert!((spring.surge_frequency() - 54.065).abs() < 1e-3);
/// assert!((spring.nominal_force() - 121.6).abs() < 1e-9);
/// assert!((spring.wave_impedance() - 7.0285).abs() < 1e-4);
/// # Ok::<(), coilsense::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Spring {
    parameters: SpringParameters,
    nominal_force: f64,
    masses_per_winding: usize,
}

impl Spring {
    /// Checks the parameters.
    ///
    /// # Errors
    /// [`Error::Value`] for the first value that is not finite, not above zero, a wire that is not thinner than the coil,
    /// or an operating range that is empty or reversed.
    pub fn new(parameters: SpringParameters) -> Result<Self, Error> {
        let p = &parameters;
        above_zero("rest_length", p.rest_length, "m")?;
        check(
            p.windings.is_finite() && p.windings > 0.0 && p.windings <= MAX_WINDINGS,
            "windings",
            p.windings,
            "",
            format!("above zero and at most {MAX_WINDINGS}"),
        )?;
        above_zero("coil_radius", p.coil_radius, "m")?;
        above_zero("wire_radius", p.wire_radius, "m")?;
        check(
            p.wire_radius < p.coil_radius,
            "wire_radius",
            p.wire_radius,
            "m",
            format!("below the coil radius of {} m", p.coil_radius),
        )?;
        above_zero("mass", p.mass, "kg")?;
        above_zero("stiffness", p.stiffness, "N/m")?;
        above_zero("min_length", p.min_length, "m")?;
        finite("max_length", p.max_length, "m")?;
        check(
            p.max_length > p.min_length,
            "max_length",
            p.max_length,
            "m",
            format!("above the min length of {} m", p.min_length),
        )?;
        if let Some(windings) = p.inductance_windings {
            check(
                windings.is_finite() && (0.5..=MAX_WINDINGS).contains(&windings),
                "inductance_windings",
                windings,
                "",
                format!("from 0.5 to {MAX_WINDINGS}"),
            )?;
        }
        check(p.sections.is_none() || cfg!(feature = "sections"), "sections", 1.0, "", "none in this build")?;
        if let Some(sections) = &p.sections {
            let allowed = format!("the {} of its sections", sections.windings());
            check((p.windings / sections.windings() - 1.0).abs() < 1e-9, "windings", p.windings, "", allowed)?;
        }
        let given = p.nominal_force.map(|force| above_zero("nominal_force", force, "N")).transpose()?;
        let mut spring = Self { parameters, nominal_force: 0.0, masses_per_winding: 1 };
        let (shortest, longest) = spring.operating_range();
        let extremes = [shortest, longest].map(|length| spring.static_force(length).abs());
        spring.nominal_force = given.unwrap_or(extremes[1].max(extremes[0]));
        Ok(spring)
    }

    /// Of a coil of sections whose ends are `dead_length` \[m\] further apart than its active wire is long, and between which lengths it is used \[m\].
    ///
    /// Windings, stiffness, mass and rest length are the sections' own, the radii means over the wire.
    ///
    /// # Errors
    /// As [`Self::new`].
    ///
    /// ```
    /// use coilsense::Spring;
    /// use coilsense::sections::{Section, Sections};
    /// // Stiffer from the force on at which the narrow windings of its first section close.
    /// let narrow = Section { windings: 2.0, pitch: [5.5e-3; 2], coil_diameter: [25e-3; 2], wire_diameter: 4e-3, telescopes: false };
    /// let wide = Section { windings: 4.0, pitch: [8e-3; 2], ..narrow };
    /// let spring = Spring::of_sections(Sections::new(vec![narrow, wide], 79.3e9, 7850.0)?, 0.0, (0.030, 0.042))?;
    /// let (soft, stiff) = (spring.rate_at(0.042), spring.rate_at(0.032));
    /// assert!((stiff / soft - 6.0 / 4.0).abs() < 1e-9);
    /// # Ok::<(), coilsense::Error>(())
    /// ```
    pub fn of_sections(sections: Sections, dead_length: f64, (shortest, longest): (f64, f64)) -> Result<Self, Error> {
        let all = sections.windings();
        let mean = |of: usize| {
            let each = sections.sections().iter();
            let radius = |windings: f64| sections.radii_at(windings)[of];
            let mut begin = 0.0;
            let sum = each.map(|section| {
                let middle = begin + 0.5 * section.windings;
                begin += section.windings;
                // Diameters change evenly along a section.
                section.windings * radius(middle)
            });
            sum.sum::<f64>() / all
        };
        Self::new(SpringParameters {
            rest_length: sections.span() + dead_length,
            windings: all,
            coil_radius: mean(0),
            wire_radius: mean(1),
            mass: sections.mass(),
            stiffness: sections.stiffness(),
            min_length: shortest,
            max_length: longest,
            nominal_force: None,
            inductance_windings: None,
            sections: Some(Arc::new(sections)),
        })
    }

    /// Its sections, where the coil is not uniform.
    #[inline]
    pub fn sections(&self) -> Option<&Sections> {
        self.shared_sections().map(Arc::as_ref)
    }

    /// The same, to be kept. Known when it is compiled without the feature `sections`, so that such a build does not carry what they need.
    #[inline]
    pub(crate) fn shared_sections(&self) -> Option<&Arc<Sections>> {
        if cfg!(feature = "sections") { self.parameters.sections.as_ref() } else { None }
    }

    /// Refuses a coil of sections, for what is computed of a uniform one: `what` it is.
    ///
    /// # Errors
    /// [`Error::Value`] with the number of its sections.
    pub(crate) fn check_uniform(&self, what: &'static str) -> Result<(), Error> {
        let count = self.sections().map_or(1, |sections| sections.sections().len());
        let allowed = format!("a uniform coil for {what}, which knows no sections");
        check(self.sections().is_none(), "sections", count as f64, "", allowed).map(|_| ())
    }

    /// By how much stiffer \[1\] it is than its sections make it, and by how much heavier \[1\]: what tolerances and measured values do.
    pub(crate) fn scales(&self, sections: &Sections) -> [f64; 2] {
        [self.stiffness() / sections.stiffness(), self.mass() / sections.mass()]
    }

    /// The parameters it was made from.
    pub fn parameters(&self) -> &SpringParameters {
        &self.parameters
    }

    /// l0: length without force \[m\].
    pub fn rest_length(&self) -> f64 {
        self.parameters.rest_length
    }

    /// k: stiffness \[N/m\].
    pub fn stiffness(&self) -> f64 {
        self.parameters.stiffness
    }

    /// m: mass of the active coil \[kg\].
    pub fn mass(&self) -> f64 {
        self.parameters.mass
    }

    /// r: radius of the coil to the centre of the wire \[m\].
    pub fn coil_radius(&self) -> f64 {
        self.parameters.coil_radius
    }

    /// ρ: radius of the wire \[m\].
    pub fn wire_radius(&self) -> f64 {
        self.parameters.wire_radius
    }

    /// 2ρ: diameter of the wire \[m\].
    pub fn wire_diameter(&self) -> f64 {
        2.0 * self.parameters.wire_radius
    }

    /// N: active windings \[1\], may be fractional.
    pub fn windings(&self) -> f64 {
        self.parameters.windings
    }

    /// Windings that carry the current \[1\].
    pub fn inductance_windings(&self) -> f64 {
        self.parameters.inductance_windings.unwrap_or(self.parameters.windings)
    }

    /// Windings of the model: the active ones rounded, at least 1.
    pub fn whole_windings(&self) -> usize {
        (self.parameters.windings.round() as usize).max(1)
    }

    /// The same spring as a chain of `masses` masses for each winding; the paper's chain, and every spring as it is made, has one.
    ///
    /// More masses bring the chain nearer to a continuous bar, whose surge frequencies are multiples of f1. Neither end of that road is the
    /// coil: see [`Self::first_frequency_band`].
    ///
    /// # Errors
    /// [`Error::Value`] for no masses, or more than 1024 for a winding.
    pub fn with_masses_per_winding(self, masses: usize) -> Result<Self, Error> {
        let allowed = format!("from 1 to {MAX_MASSES_PER_WINDING}");
        check((1..=MAX_MASSES_PER_WINDING).contains(&masses), "masses_per_winding", masses as f64, "", allowed)?;
        Ok(Self { masses_per_winding: masses, ..self })
    }

    /// How many masses of the chain stand for one winding; 1 where nobody asked for more.
    pub fn masses_per_winding(&self) -> usize {
        self.masses_per_winding
    }

    /// Masses of the chain that stands for the spring: [`Self::whole_windings`] times [`Self::masses_per_winding`].
    pub fn chain_masses(&self) -> usize {
        self.whole_windings() * self.masses_per_winding
    }

    /// Shortest and longest length in use \[m\].
    pub fn operating_range(&self) -> (f64, f64) {
        (self.parameters.min_length, self.parameters.max_length)
    }

    /// Half way through the operating range \[m\].
    pub fn mid_length(&self) -> f64 {
        0.5 * (self.parameters.min_length + self.parameters.max_length)
    }

    /// Whether a length \[m\] lies in the operating range, its ends included.
    pub fn in_operating_range(&self, length: f64) -> bool {
        (self.parameters.min_length..=self.parameters.max_length).contains(&length)
    }

    /// F_nom: largest static force in use \[N\].
    ///
    /// F_nom = k max(|l_min − l0|, |l_max − l0|), or the parameter `nominal_force` where it is given.
    ///
    /// Source:   `[Weijde2017]` eq. 14.
    /// Valid:    a linear spring.
    /// Accuracy: rounding of the difference of lengths.
    /// Differs:  eq. 14 takes l_max only; the absolute value makes compression springs work and is the same for S_T and S_A.
    pub fn nominal_force(&self) -> f64 {
        self.nominal_force
    }

    /// Length with all active windings touching \[m\].
    ///
    /// l_s = N · 2ρ
    ///
    /// Source:   geometry.
    /// Valid:    active windings only; closed end turns add their own wire diameters.
    /// Accuracy: exact but for rounding.
    pub fn solid_length(&self) -> f64 {
        match self.sections() {
            Some(sections) => sections.place_at(sections.windings(), sections.solid_force()),
            None => self.parameters.windings * self.wire_diameter(),
        }
    }

    /// Distance from winding to winding when they are spread uniformly over a length \[m\].
    ///
    /// p = l / N
    ///
    /// - `length`: l \[m\]
    ///
    /// Source:   geometry.
    /// Valid:    uniform windings; a chain of round(N) masses has its own pitch l/round(N).
    /// Accuracy: exact but for rounding.
    pub fn pitch_at(&self, length: f64) -> f64 {
        length / self.parameters.windings
    }

    /// Force of a spring without mass \[N\], tension positive.
    ///
    /// F = k (l − l0); of a coil of sections its static curve, with windings that close
    ///
    /// - `length`: l \[m\]
    ///
    /// Source:   Hooke's law; the paper's F_x. [`Sections::pushes`].
    /// Valid:    no initial tension, no clash but that of sections.
    /// Accuracy: rounding of the difference of lengths; of sections 1e-7.
    pub fn static_force(&self, length: f64) -> f64 {
        let Some(sections) = self.sections() else { return self.open_force(length) };
        let [stiffer, _] = self.scales(sections);
        let [force, _] = sections.pushes(self.parameters.rest_length - length);
        -stiffer * force
    }

    /// How the static force grows with a length \[m\] there, in \[N/m\]: k, but for a coil of sections.
    pub fn rate_at(&self, length: f64) -> f64 {
        let Some(sections) = self.sections() else { return self.parameters.stiffness };
        let [stiffer, _] = self.scales(sections);
        let [_, rate] = sections.pushes(self.parameters.rest_length - length);
        stiffer * rate
    }

    /// The force \[N\] of a spring all of whose windings stay open.
    pub(crate) fn open_force(&self, length: f64) -> f64 {
        self.parameters.stiffness * (length - self.parameters.rest_length)
    }
}

/// Most masses for a winding: far beyond what any figure still moves by.
const MAX_MASSES_PER_WINDING: usize = 1024;

/// Most windings that are taken: far above any coil; end forces of so many still take well under a second per simulated second.
const MAX_WINDINGS: f64 = 1e5;
