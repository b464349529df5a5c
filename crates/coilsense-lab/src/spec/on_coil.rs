//! A sensor by the spring's own inductance: how its calibration was found, and how far that departs from a measured spring.
//!
//! Next door: the other kinds (`measurand`), what eq. (13) leaves of magnetic wire (`coilsense::sensors::magnetic_form`).

use coilsense::inductance::Leads;
use coilsense::sensors::{FormBy, Quantity, magnetic_form, usual_form};

use super::catalogue::PermeabilityFound;
use super::inductance::MAGNETIC;
use super::section::Section;
use super::{Files, SpecError, SpringSpec, plain};
use crate::quantity::Dimension;
use crate::stored::StoredCalibration;

/// How eq. (13), or what stands in for it, was found.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Calibrated {
    /// Fitted to measured lengths over the range.
    Fitted,
    /// Through two of them, the ends of the range.
    TwoPoint,
    /// By the theory of magnetic wire.
    Steel,
    /// Not at all.
    Theory,
}

impl Calibrated {
    const ALL: [(&'static str, Self); 4] =
        [("fitted", Self::Fitted), ("two-point", Self::TwoPoint), ("steel", Self::Steel), ("theory", Self::Theory)];
}

/// Departure from eq. (13) through two end points, of four measured springs, root mean square: 1.50, 0.98, 2.16 and 0.32 % of the travel.
const THROUGH_ENDS: f64 = 0.014;
/// What the theory of magnetic wire left of two points on the same springs: 0.14 to 0.37 %.
const STEEL: f64 = 0.003;
/// What mounting a spring anew adds: runs held out against another run's calibration were 0.5 to 0.7 % of the travel off.
const REMOUNTING: f64 = 0.007;

/// What it measures, by its table; `files` reads a stored calibration.
pub(super) fn on_coil(section: &Section<'_>, spec: &SpringSpec, files: &Files<'_>) -> Result<Quantity, SpecError> {
    // They count where what eq. (13) leaves is computed.
    let leads = if cfg!(feature = "steel") { leads(section, spec)? } else { Leads::Open };
    let form = section.share("calibration_form")?;
    let told = section.optional_text("calibration").ok().flatten();
    if let Some(name) = told.as_deref().filter(|text| text.ends_with(ENDING)) {
        let doubts = stored(name, form, spec, files).map_err(|why| section.refuse("calibration", why))?;
        let (form, remounting, form_by) = (doubts[0], doubts[1], FormBy::Stored);
        return Ok(Quantity::Inductance { uncalibrated: false, form, form_by, remounting });
    }
    let word = section.optional_word("calibration", &Calibrated::ALL.map(|(word, _)| word));
    let word = word.map_err(|error| error.or_also("the name of a .toml file that coilsense calibrate wrote"))?;
    let known = Calibrated::ALL.into_iter().find(|(name, _)| Some(*name) == word);
    let way = known.map_or(Calibrated::Fitted, |(_, way)| way);
    let uncalibrated = way == Calibrated::Theory;
    let of =
        |form: f64, form_by: FormBy, remounting: f64| Quantity::Inductance { uncalibrated, form, form_by, remounting };
    if let Some(form) = form {
        return Ok(of(form, FormBy::Measured, 0.0));
    }
    let wire = spec.geometry.material();
    let usual = usual_form(uncalibrated, wire);
    let relative = wire.relative_permeability().unwrap_or(1.0);
    let largest = relative * (1.0 + spec.tolerances.permeability);
    match way {
        Calibrated::Theory | Calibrated::Steel
            if let Some(PermeabilityFound::Above(least)) = spec.permeability_found() =>
        {
            let why = format!(
                "needs calibration_form: {} has a relative permeability above {}, which neither Maxwell's sum nor the theory of magnetic wire covers",
                spec.material,
                plain(least)
            );
            Err(section.refuse("calibration", why))
        }
        Calibrated::Theory => Ok(of(usual, FormBy::Measured, 0.0)),
        Calibrated::Steel => Ok(of(STEEL, FormBy::Steel, REMOUNTING)),
        // Of wire whose permeability is told, what eq. (13) leaves is computed.
        Calibrated::Fitted | Calibrated::TwoPoint if largest > 1.0 + MAGNETIC => {
            let needs = "needs calibration_form: relative_permeability says that the wire is magnetic";
            if !cfg!(feature = "steel") {
                let why = format!("{needs}, and this build does not compute what eq. (13) then leaves");
                return Err(section.refuse("kind", why));
            }
            let found = magnetic_form(&spec.spring, largest, way == Calibrated::TwoPoint, leads);
            let why = |error| format!("{needs}, and what eq. (13) then leaves cannot be computed: {error}");
            Ok(of(found.map_err(|error| section.refuse("kind", why(error)))?, FormBy::Magnetic, REMOUNTING))
        }
        // Of wire that may be magnetic it is no less than what was measured.
        Calibrated::Fitted | Calibrated::TwoPoint
            if cfg!(feature = "steel")
                && let Some(found) = spec.permeability_found() =>
        {
            let (PermeabilityFound::Between(_, most) | PermeabilityFound::Above(most)) = found;
            let through_ends = way == Calibrated::TwoPoint;
            let measured = if through_ends {
                of(THROUGH_ENDS, FormBy::Measured, REMOUNTING)
            } else {
                of(usual, FormBy::Measured, 0.0)
            };
            let least = if through_ends { THROUGH_ENDS } else { usual };
            // Where it cannot be computed, what was measured stands.
            let form = magnetic_form(&spec.spring, most, through_ends, leads).ok().filter(|form| *form > least);
            Ok(form.map_or(measured, |form| of(form, FormBy::Magnetic, REMOUNTING)))
        }
        Calibrated::Fitted => Ok(of(usual, FormBy::Measured, 0.0)),
        Calibrated::TwoPoint => Ok(of(THROUGH_ENDS, FormBy::Measured, REMOUNTING)),
    }
}

/// How a stored calibration's file ends.
const ENDING: &str = ".toml";

/// Where the current goes back.
fn leads(section: &Section<'_>, spec: &SpringSpec) -> Result<Leads, SpecError> {
    if !section.has("leads") {
        return Ok(Leads::Open);
    }
    if let Some(leads) = section.optional_text("leads").ok().flatten().and_then(|word| Leads::named(&word)) {
        return Ok(leads);
    }
    let distance =
        section.quantity("leads", Dimension::Length).map_err(|error| error.or_also("\"open\" or \"none\""))?;
    let radius = spec.spring.coil_radius();
    let allowed = format!("\"open\", \"none\", or above the coil radius of {} mm", plain(1e3 * radius));
    section.check("leads", distance > radius && distance.is_finite(), distance, &allowed).map(Leads::Beside)
}

/// How far lengths by a stored calibration may be off over the operating range, `form` where that is given, and what mounting the spring anew adds, as shares of
/// the travel \[1\].
fn stored(name: &str, form: Option<f64>, spec: &SpringSpec, files: &Files<'_>) -> Result<[f64; 2], String> {
    if !cfg!(feature = "steel") {
        let why = "is a stored calibration, which this build does not read: give calibration_form";
        return form.map(|form| [form, 0.0]).ok_or_else(|| why.to_owned());
    }
    let stored = StoredCalibration::of_text(name, &files(name)?).map_err(|error| error.message)?;
    let (shortest, longest) = spec.spring.operating_range();
    let [from, to] = stored.lengths();
    let millimetres = |length: f64| plain((1e6 * length).round() / 1e3);
    if !(from <= shortest && to >= longest) {
        return Err(format!(
            "must hold over the spring's operating range, {} to {} mm, got {} to {} mm",
            millimetres(shortest),
            millimetres(longest),
            millimetres(from),
            millimetres(to)
        ));
    }
    match (form, stored.doubts([shortest, longest])) {
        (Some(form), _) => Ok([form, 0.0]),
        (None, Some(doubts)) => Ok(doubts.map(|doubt| doubt / (longest - shortest))),
        (None, None) => Err("does not say how surely it tells lengths: give calibration_form".to_owned()),
    }
}
