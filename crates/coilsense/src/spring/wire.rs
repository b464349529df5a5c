//! Whether mass and dimensions are those of a wire.
//!
//! Next door: the values themselves (the parent), wire and coil with a material (`geometry`).

use std::f64::consts::{PI, TAU};

use super::Spring;
use crate::error::{Error, check};

/// Half way, by powers, between steel's density and a thousandth of it \[kg/m³\]: no plastic is as light.
const LIGHTEST: f64 = 250.0;
/// The same to a thousand times it \[kg/m³\]: no metal is as heavy.
const HEAVIEST: f64 = 250_000.0;

impl Spring {
    /// Density that the wire has by mass and dimensions \[kg/m³\].
    ///
    /// m / (2π r N π ρ²)
    ///
    /// Source:   mass over volume of N rings of wire.
    /// Valid:    windings that are nearly flat; a coil without sections.
    /// Accuracy: 4e-16 relative. Of the paper's springs, whose masses are measured: 7916 (S_T) kg/m³.
    ///
    /// ```
    /// # let spring = coilsense::paper::s_t();
    /// assert!((spring.wire_density() - 7916.0).abs() < 1.0);
    /// ```
    pub fn wire_density(&self) -> f64 {
        let (length, radius) = (TAU * self.coil_radius() * self.windings(), self.wire_radius());
        self.mass() / (length * PI * radius * radius)
    }

    /// Refuses a mass that no wire of these dimensions has: then a unit is wrong. Numbers without units ask for it; a text with units need not.
    ///
    /// From polypropylene (900 kg/m³) to platinum (21 450 kg/m³) every material is let through, with its mass off by a factor of 3 either way (ends,
    /// hollow wire, a mass that is all of the spring's) and refused with a factor of 1000.
    ///
    /// # Errors
    /// [`Error::Value`] for a density of the wire that is not from 250 to 250 000 kg/m³.
    ///
    /// ```
    /// # let spring = coilsense::paper::s_t();
    /// let grams = coilsense::SpringParameters { mass: 65.0, ..spring.parameters().clone() };
    /// let error = coilsense::Spring::new(grams)?.check_wire().unwrap_err();
    /// assert!(error.to_string().contains("is the mass in kg"));
    /// # Ok::<(), coilsense::Error>(())
    /// ```
    pub fn check_wire(&self) -> Result<(), Error> {
        let density = self.wire_density();
        let quantity = "density of the wire, which mass, windings, coil_radius and wire_radius make,";
        let allowed = "from 250 to 250000 kg/m³: is the mass in kg, and every length in m? Where the spring is no wire, take the wire_radius that fits its mass";
        check((LIGHTEST..=HEAVIEST).contains(&density), quantity, density, "kg/m³", allowed).map(|_| ())
    }
}
