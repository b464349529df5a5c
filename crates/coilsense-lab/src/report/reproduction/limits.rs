//! Errors and limits of the paper, with the figures that go with them computed for the springs at hand.
//!
//! Next door: the page that shows them (`html`).

use coilsense::inductance::{MaxwellSum, SelfDistance};
use coilsense::{Calibration, Error, Spring};

use crate::reproduce::{Condition, Reproduction};

/// Density of spring steel \[kg/m³\], EN 10270-1's usual value.
const STEEL: f64 = 7850.0;

/// What the program must state about the paper and its own reach, a heading and a paragraph each.
pub(super) fn limits(reproduction: &Reproduction) -> Result<Vec<(&'static str, String)>, Error> {
    Ok(vec![
        ("The self term of eq. (10)", self_term(reproduction)),
        ("Coil clash", clash(reproduction)),
        ("Close-wound springs", close_wound(reproduction)),
        ("Eq. (13) is itself an approximation", calibration_form(reproduction)?),
        (
            "Eq. (1) and eq. (3) name different frequencies",
            "The poles of eq. (1) and Fig. 2 are those of a coil held at one end and driven by a force at the other, (j − ½)/2τ; \
             eq. (3) gives those of a coil held at both ends, j/2τ."
                .to_owned(),
        ),
        (
            "Eq. (8) as printed cancels",
            "Far rings lose about (h/r)⁴ of the digits and near ones half of them; coilsense computes the same mutual inductance in a \
             form without differences, to 2·10⁻¹⁵."
                .to_owned(),
        ),
        (
            "What the axial model leaves out",
            "No damping, no lateral and no torsional motion, no contact, no initial tension. As a helix, S_T of Table I stretched to 230 mm swings \
             sideways from 40.3 Hz (hooks that tilt freely) or 44.1 Hz (held) on, and turns about its axis at 60.8 Hz with 1.1 % of the surge's \
             strength in the axial force, around the axial 54 Hz."
                .to_owned(),
        ),
        (
            "Solver tolerance",
            "An adaptive Runge–Kutta method at a relative tolerance of 10⁻³, a solver's usual default, is not accurate enough for these \
             tables: SciPy's misses S_T's forces by 29 to 59 % of their peak (`cargo xtask bench`). Nothing is integrated in steps here."
                .to_owned(),
        ),
    ])
}

/// One sentence per spring, in a row.
fn for_each_spring(reproduction: &Reproduction, sentence: impl Fn(&str, &Spring) -> String) -> String {
    let sentences: Vec<String> = reproduction.springs.each().map(|(name, spring)| sentence(name, spring)).collect();
    sentences.join(" ")
}

fn self_term(reproduction: &Reproduction) -> String {
    let shares = for_each_spring(reproduction, |name, spring| {
        let coil = |distance| MaxwellSum::new(spring, distance).at_length(spring.mid_length());
        let (printed, mean) = (coil(SelfDistance::AsPrinted), coil(SelfDistance::GeometricMean));
        let (turns, radius) = (spring.windings(), spring.coil_radius());
        let wire = std::f64::consts::TAU * radius * std::f64::consts::PI * spring.wire_radius().powi(2);
        format!(
            "For {name} it raises L by {:.2} µH ({:.0} %); its wire of radius {} mm in steel weighs {:.1} g, its mass is given as {} g.",
            1e6 * (printed - mean),
            100.0 * (printed / mean - 1.0),
            1e3 * spring.wire_radius(),
            1e3 * turns * wire * STEEL,
            1e3 * spring.mass(),
        )
    });
    format!(
        "The geometric mean distance of a round wire of radius ρ is ρ e^(−1/4) (Maxwell, art. 693), not half of it, and Table I's ρ is a \
         radius. {shares} The ½ is a constant in L, so β takes it up and F_L does not change. Eq. (10) as printed is used in this report; \
         the library offers both."
    )
}

fn clash(reproduction: &Reproduction) -> String {
    let mut text = reproduction.of_cases().collect::<Vec<_>>().join(" ");
    for (name, _) in reproduction.springs.each() {
        let Some(stop) = reproduction.case(name, Condition::EndStopMin).filter(|stop| !stop.clash.happens()) else {
            continue;
        };
        let clearance = 1e3 * stop.clash.clearance();
        text.push_str(&format!(" {name} at end stop min stays clear by {clearance:.2} mm."));
    }
    text.trim().to_owned()
}

fn close_wound(reproduction: &Reproduction) -> String {
    let lengths = for_each_spring(reproduction, |name, spring| {
        format!(
            "{name}: N·2ρ is {:.0} mm of a rest length of {:.0} mm.",
            1e3 * spring.solid_length(),
            1e3 * spring.rest_length()
        )
    });
    format!("{lengths} Springs wound as close as those of Table I carry initial tension; the paper has none.")
}

fn calibration_form(reproduction: &Reproduction) -> Result<String, Error> {
    let mut misfits = Vec::new();
    for (name, spring) in reproduction.springs.each() {
        let coil = MaxwellSum::new(spring, SelfDistance::AsPrinted);
        let fit = Calibration::theoretical(spring, &coil, spring.mid_length())?;
        let (shortest, longest) = spring.operating_range();
        let misfit = (0..=100)
            .map(|step| shortest + (longest - shortest) * f64::from(step) / 100.0)
            .map(|length| spring.stiffness() * (fit.length(coil.at_length(length)) - length).abs())
            .fold(0.0, f64::max);
        misfits.push(format!("{:.2} % of F_nom for {name}", 100.0 * misfit / spring.nominal_force()));
    }
    Ok(format!(
        "With uniform windings and no error at all, its fit misses the force by up to {} within the operating range; Table II judges it at \
         one length only, where the fit is exact.",
        misfits.join(" and ")
    ))
}
