//! The table `[contact]`: what windings do when they meet, in each way for which results are given.
//!
//! Next door: the ways beside the dampings (`mount`), the motion that follows (`crate::study`).

use coilsense::contact::{Contact, Hertz};
use coilsense::{FarEnd, Spring};

use super::document::Document;
use super::section::Section;
use super::spring::{Model, SpringSpec};
use super::{SpecError, plain, stem};
use crate::quantity::Dimension;

/// Restitutions for which results are given where a spec names none: no measured value of windings is known.
const RESTITUTIONS: [f64; 2] = [0.0, 0.5];
/// The same of elastic windings: ζ_c of restitutions of 0.02 and 0.45.
const CONTACT_DAMPINGS: [f64; 2] = [3.0, 0.3];
/// Most ways in a list.
const MOST_WAYS: usize = 8;
/// After so many events a run gives up: that of a minute of a chattering stack of a hundred masses.
const MOST_EVENTS: usize = 300_000;

/// One way in which windings meet.
#[derive(Debug, Clone, PartialEq)]
pub struct ContactCase {
    /// `e = 0.5`, or `ζ_c = 3`.
    pub label: String,
    /// The law, at the pitch at which the spring's windings touch.
    pub contact: Contact,
    /// Whether it is one of the ways that are assumed where the spec is silent.
    pub is_assumed: bool,
}

impl ContactCase {
    /// The same for file names.
    pub(super) fn stem(&self) -> String {
        stem(&self.label.replace(" = ", "-").replace('ζ', "zeta"))
    }

    /// The ways of a spec whose spring ends at `far_end`; none without the table, and where it says `off`.
    pub(super) fn parse_all(
        document: &Document<'_>,
        spec: &SpringSpec,
        far_end: FarEnd,
    ) -> Result<Vec<Self>, SpecError> {
        let follower = follower_mass(document)?;
        let alone = |key: &str| match follower {
            None => Ok(Vec::new()),
            Some(_) => Err(document.section("mount")?.refuse("follower_mass", format!("takes {key}"))),
        };
        let Some(section) = document.optional_section("contact")? else {
            return alone("a table [contact]: without it no end leaves what it stands on");
        };
        let word = section.optional_word("windings", &["hard", "elastic", "off"])?.unwrap_or("hard");
        section.only_of(word, &format!("windings that are \"{word}\""))?;
        if word == "off" {
            return alone("[contact] windings = \"hard\"");
        }
        if !cfg!(feature = "contact") {
            let allowed = "takes \"off\" in this build; windings that meet are for the command";
            return Err(section.refuse("windings", allowed));
        }
        if let Some(why) = why_not(spec) {
            return Err(section.refuse("windings", why));
        }
        let pushes_only = !spec.geometry.parameters().end_type.is_extension();
        let is_mass = matches!(far_end, FarEnd::Mass(_));
        let ends = section.optional_flag("ends")?;
        if ends == Some(true) && is_mass && spec.masses_per_winding != Some(1) {
            let why =
                "with an end mass takes [spring] masses_per_winding = 1: more than one point would lie on the mass";
            return Err(section.refuse("ends", why));
        }
        let ends = ends.unwrap_or(pushes_only && (!is_mass || spec.masses_per_winding == Some(1)));
        let lifts = section.optional_flag("lift_off")?.unwrap_or(pushes_only);
        let of = |label: String, contact: Result<Contact, coilsense::Error>, is_assumed: bool| {
            let contact = contact
                .and_then(|contact| contact.at_pitch(spec.contact_pitch()))
                .map_err(|error| section.refuse_science(&error, &[]))?;
            let contact = contact.with_ends(ends).with_lift_off(lifts).with_most_events(MOST_EVENTS);
            let contact = match follower {
                Some(mass) => contact.with_follower(mass).map_err(|error| refuse_follower(document, &error))?,
                None => contact,
            };
            Ok(Self { label, contact, is_assumed })
        };
        let key = if word == "hard" { "restitution" } else { "damping_ratio" };
        let given = section.optional_numbers(key)?;
        let assumed = given.is_none();
        if word == "hard" {
            let each =
                distinct(&section, key, given.unwrap_or(RESTITUTIONS.to_vec()), "from 0 to 1", |value| value <= 1.0)?;
            return each.into_iter().map(|e| of(format!("e = {}", plain(e)), Contact::hard(e), assumed)).collect();
        }
        let stiffness = stiffness(&section, spec)?;
        let each = distinct(&section, key, given.unwrap_or(CONTACT_DAMPINGS.to_vec()), "from 0 to 100", |value| {
            value <= 100.0
        })?;
        let one = |ratio: f64| of(format!("ζ_c = {}", plain(ratio)), Contact::elastic(stiffness, ratio), assumed);
        each.into_iter().map(one).collect()
    }
}

/// The mass that the input pushes at end 1 \[kg\].
fn follower_mass(document: &Document<'_>) -> Result<Option<f64>, SpecError> {
    match document.optional_section("mount")? {
        Some(section) => section.above_zero("follower_mass", Dimension::Mass),
        None => Ok(None),
    }
}

fn refuse_follower(document: &Document<'_>, error: &coilsense::Error) -> SpecError {
    match document.section("mount") {
        Ok(section) => section.refuse("follower_mass", error),
        Err(error) => error,
    }
}

/// Why windings of this spring cannot be followed when they meet; `None` where they can.
pub(crate) fn why_not(spec: &SpringSpec) -> Option<&'static str> {
    if spec.model == Model::Helix {
        return Some("takes [spring] model = \"coil\" or \"chain\": the modes of a \"helix\" know no contact");
    }
    if spec.initial_tension > 0.0 {
        return Some(
            "takes a spring without initial_tension: windings that press on one another at rest are not covered",
        );
    }
    let (rest, solid) = (spec.spring.rest_length(), spec.solid_length());
    let closed = "takes a spring whose windings are apart when it is unloaded: this one is solid at its rest_length";
    (rest < solid * (1.0 + 1e-9)).then_some(closed)
}

/// K_c, as given or by Hertz.
fn stiffness(section: &Section<'_>, spec: &SpringSpec) -> Result<f64, SpecError> {
    let by_hertz = || hertz(&spec.spring, spec).map_err(|error| section.refuse_science(&error, &[]));
    if !section.has("stiffness") || section.optional_text("stiffness").ok().flatten().as_deref() == Some("Hertz") {
        return by_hertz();
    }
    let value = section.optional_quantity("stiffness", Dimension::Stiffness)?;
    let Some(value) = value else { return by_hertz() };
    let chain = spec.spring.whole_windings() as f64 * spec.spring.stiffness();
    let allowed =
        format!("from {} N/m, ten times a winding's own, to 1e12 N/m; or \"Hertz\"", plain((10.0 * chain).ceil()));
    section.check("stiffness", (10.0 * chain..=1e12).contains(&value), value, &allowed)
}

/// K_c of a full turn under F_nom.
fn hertz(spring: &Spring, spec: &SpringSpec) -> Result<f64, coilsense::Error> {
    let material = spec.geometry.material();
    let (shear, youngs) = (material.shear_modulus(), material.youngs_modulus());
    let turn = Hertz {
        wire_radius: 0.5 * spring.wire_diameter(),
        length: std::f64::consts::TAU * spring.parameters().coil_radius,
        youngs_modulus: youngs,
        // E and G that do not go together are warned of elsewhere.
        poisson_ratio: (0.5 * youngs / shear - 1.0).clamp(0.0, 0.5),
    };
    turn.stiffness(spring.nominal_force())
}

/// Numbers of a list, each of which gives results of its own.
fn distinct(
    section: &Section<'_>,
    key: &str,
    values: Vec<f64>,
    allowed: &str,
    holds: impl Fn(f64) -> bool,
) -> Result<Vec<f64>, SpecError> {
    for (index, value) in values.iter().enumerate() {
        section.check(key, *value >= 0.0 && holds(*value), *value, allowed)?;
        if values[..index].contains(value) {
            return Err(section.refuse(key, format!("{} is there twice; give each once", value + 0.0)));
        }
    }
    if values.len() > MOST_WAYS {
        return Err(section.refuse(key, format!("must be at most {MOST_WAYS} values, got {}", values.len())));
    }
    Ok(values)
}
