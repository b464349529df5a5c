//! Single numbers of a data sheet, under headings.
//!
//! Next door: frequencies of the axial model (`frequencies`).

use coilsense::Error;
use coilsense::helix::buckling_length;

use crate::helix::{Coil, ModesAt};
use crate::spec::SpringSpec;

/// One number: for machines in SI, for people in the unit they use.
#[derive(Debug, Clone, PartialEq)]
pub struct Row {
    /// Its key in JSON, with its SI unit as suffix.
    pub key: &'static str,
    /// What it is, with its letter.
    pub label: &'static str,
    /// Its value in SI; `None` where it is not known.
    pub value: Option<f64>,
    /// What takes the SI value to the unit that people read.
    scale: f64,
    /// That unit.
    pub unit: &'static str,
}

impl Row {
    fn new(
        key: &'static str,
        label: &'static str,
        value: impl Into<Option<f64>>,
        scale: f64,
        unit: &'static str,
    ) -> Self {
        Self { key, label, value: value.into(), scale, unit }
    }

    /// The value as people read it, without its unit: five significant digits.
    pub fn shown(&self) -> String {
        let Some(value) = self.value else { return "not known".to_owned() };
        let value = value * self.scale;
        if value == 0.0 {
            return "0".to_owned();
        }
        let decimals = (4 - value.abs().log10().floor() as i32).clamp(0, 9) as usize;
        let text = format!("{value:.decimals$}");
        if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.').to_owned() } else { text }
    }
}

pub(super) fn groups(
    spec: &SpringSpec,
    solid_length: f64,
    coil: Option<&Coil>,
    modes_at: &[ModesAt],
) -> Result<Vec<(&'static str, Vec<Row>)>, Error> {
    let groups = vec![
        ("Spring", of_spring(spec)),
        ("Lengths", of_lengths(spec, solid_length)),
        ("Sections", of_sections(spec)),
        ("Stress", of_stress(spec)),
        ("Surge wave", of_wave(spec, modes_at)),
        ("Force of the helix", of_helix(spec, coil, modes_at)?),
        ("Inductance", of_inductance(spec)?),
    ];
    Ok(groups.into_iter().filter(|(_, rows)| !rows.is_empty()).collect())
}

/// What a coil of sections has beside.
fn of_sections(spec: &SpringSpec) -> Vec<Row> {
    let (Some(sections), Some(dead)) = (spec.spring.sections(), spec.dead_ends) else { return Vec::new() };
    let knees = super::curve::knees(spec, sections);
    let (first, last) = (knees.first().copied().unzip(), knees.last().copied().unzip());
    vec![
        Row::new("first_closing_force_n", "force at which the first windings close", first.0, 1.0, "N"),
        Row::new("first_closing_length_m", "length at which they do", first.1, MM, "mm"),
        Row::new("solid_force_n", "force at which all are closed", last.0, 1.0, "N"),
        Row::new("dead_windings_1", "closed windings at end 1, which do not move", dead.windings[0], 1.0, ""),
        Row::new("dead_windings_2", "the same at end 2", dead.windings[1], 1.0, ""),
        Row::new("dead_mass_kg", "mass of both", dead.mass, 1e3, "g"),
    ]
}

/// The static force of the wire as a helix, where it is one.
fn of_helix(spec: &SpringSpec, coil: Option<&Coil>, modes_at: &[ModesAt]) -> Result<Vec<Row>, Error> {
    let (Some(coil), [shortest, middle, longest]) = (coil, modes_at) else { return Ok(Vec::new()) };
    let slope = |at: &ModesAt| at.held.stiffness_n_per_m;
    let from_rest = middle.held.force_n / (middle.length_m - spec.spring.rest_length());
    let mut rows = vec![
        Row::new("stiffness_at_min_n_per_m", "slope of the force at the shortest length", slope(shortest), 1.0, "N/m"),
        Row::new(
            "stiffness_at_mid_n_per_m",
            "the same at mid range: what a fit in use finds",
            slope(middle),
            1.0,
            "N/m",
        ),
        Row::new("stiffness_at_max_n_per_m", "the same at the longest length", slope(longest), 1.0, "N/m"),
        Row::new("force_at_mid_n", "force at mid range", middle.held.force_n, 1.0, "N"),
        Row::new("stiffness_from_rest_n_per_m", "F/(l − l0) at mid range: not the slope", from_rest, 1.0, "N/m"),
    ];
    if !spec.geometry.parameters().end_type.is_extension() {
        let ways = [
            (Some(&coil.ways.0), "buckling_length_m", "length at which it buckles, ends as held"),
            (coil.ways.1.as_ref(), "buckling_length_loosest_m", "the same with ends as loose as may be"),
        ];
        for (way, key, label) in ways {
            let Some(way) = way else { continue };
            if let Some(span) = buckling_length(&coil.rod, way.ends(), way.turning())? {
                rows.push(Row::new(key, label, span + coil.dead_length, MM, "mm"));
            }
        }
    }
    Ok(rows)
}

const MM: f64 = 1e3;

fn of_spring(spec: &SpringSpec) -> Vec<Row> {
    let (spring, geometry) = (&spec.spring, &spec.geometry);
    let of_sections = spec.dead_ends.is_some();
    let rate = if of_sections { "k, spring rate with all windings open" } else { "k, spring rate" };
    let mut rows = vec![
        Row::new("stiffness_n_per_m", rate, spring.stiffness(), 1.0, "N/m"),
        Row::new("mass_kg", "m, mass of the active windings", spec.mass, 1e3, "g"),
        Row::new("windings", "N, active windings", spring.windings(), 1.0, ""),
        Row::new("wire_diameter_m", "d, wire diameter", spring.wire_diameter(), MM, "mm"),
        Row::new("coil_diameter_m", "D, mean coil diameter", 2.0 * spring.coil_radius(), MM, "mm"),
        Row::new("spring_index", "D/d, spring index", geometry.index(), 1.0, ""),
        Row::new("nominal_force_n", "F_nom, largest static force in use", spring.nominal_force(), 1.0, "N"),
    ];
    if of_sections {
        // Its wire and coil are the sections'.
    } else if spec.by_geometry {
        rows.push(Row::new("total_mass_kg", "mass of all windings", geometry.total_mass(), 1e3, "g"));
    } else {
        let (stiffness, mass) = (geometry.stiffness(), geometry.active_mass());
        rows.push(Row::new("stiffness_by_geometry_n_per_m", "k that wire and coil would give", stiffness, 1.0, "N/m"));
        rows.push(Row::new("mass_by_geometry_kg", "m that wire and coil would give", mass, 1e3, "g"));
    }
    if spec.initial_tension > 0.0 {
        rows.push(Row::new("initial_tension_n", "F_0, initial tension", spec.initial_tension, 1.0, "N"));
    }
    if spec.stiffness_tolerance() > 0.0 {
        rows.push(Row::new(
            "stiffness_tolerance",
            "tolerance of k, either way",
            spec.stiffness_tolerance(),
            100.0,
            "%",
        ));
    }
    if spec.tolerances.of_mass() > 0.0 {
        rows.push(Row::new("mass_tolerance", "tolerance of m, either way", spec.tolerances.of_mass(), 100.0, "%"));
    }
    rows
}

fn of_lengths(spec: &SpringSpec, solid_length: f64) -> Vec<Row> {
    let spring = &spec.spring;
    let (shortest, longest) = spring.operating_range();
    let is_uniform = spec.dead_ends.is_none();
    let speed = |length: f64| is_uniform.then_some((length - solid_length) / spring.transit_time());
    let mut rows = vec![Row::new("rest_length_m", "l0, length without force", spec.closed_length, MM, "mm")];
    if spec.initial_tension > 0.0 {
        let label = "l0 − F_0/k, where the line of force crosses zero";
        rows.push(Row::new("effective_rest_length_m", label, spring.rest_length(), MM, "mm"));
    }
    rows.extend([
        Row::new("min_length_m", "shortest length in use", shortest, MM, "mm"),
        Row::new("max_length_m", "longest length in use", longest, MM, "mm"),
        Row::new("solid_length_m", "solid length", solid_length, MM, "mm"),
        Row::new(
            "gap_at_min_length_m",
            "gap from wire to wire at the shortest length",
            (shortest - solid_length) / spring.windings(),
            MM,
            "mm",
        ),
        Row::new(
            "clash_speed_at_min_m_per_s",
            "impact speed at which windings touch, shortest",
            speed(shortest),
            1.0,
            "m/s",
        ),
        Row::new(
            "clash_speed_at_max_m_per_s",
            "impact speed at which windings touch, longest",
            speed(longest),
            1.0,
            "m/s",
        ),
    ]);
    rows
}

fn of_stress(spec: &SpringSpec) -> Vec<Row> {
    let (geometry, force) = (&spec.geometry, spec.spring.nominal_force());
    if spec.dead_ends.is_some() {
        let impact = geometry.material().impact_stress(1.0);
        return vec![
            Row::new(
                "corrected_shear_stress_pa",
                "largest shear stress at F_nom, with Wahl's factor",
                spec.corrected_shear_stress(force),
                1e-6,
                "MPa",
            ),
            Row::new("impact_stress_pa_per_m_per_s", "impact stress per m/s", impact, 1e-6, "MPa"),
        ];
    }
    vec![
        Row::new("wahl_factor", "Wahl's factor", geometry.wahl_factor(), 1.0, ""),
        Row::new("shear_stress_pa", "shear stress at F_nom, uncorrected", geometry.shear_stress(force), 1e-6, "MPa"),
        Row::new(
            "corrected_shear_stress_pa",
            "shear stress at F_nom, with Wahl's factor",
            geometry.corrected_shear_stress(force),
            1e-6,
            "MPa",
        ),
        Row::new(
            "impact_stress_pa_per_m_per_s",
            "impact stress per m/s",
            geometry.material().impact_stress(1.0),
            1e-6,
            "MPa",
        ),
    ]
}

fn of_wave(spec: &SpringSpec, modes_at: &[ModesAt]) -> Vec<Row> {
    let spring = &spec.spring;
    let surges = || modes_at.iter().flat_map(ModesAt::ways).map(|way| way.first_surge_hz);
    let (lowest, highest) = match modes_at {
        [] => spec.first_frequency_band(),
        _ => (surges().fold(f64::INFINITY, f64::min), surges().fold(0.0, f64::max)),
    };
    let bar = spec.dead_ends.is_none().then_some(0.5 * (spring.stiffness() / spec.mass).sqrt());
    // Of a coil as a helix the mass that reaches f1 is larger than that of its windings.
    let impedance = match spring.sections() {
        None => "k τ, wave impedance: force per m/s of impact",
        Some(_) => "√(km), wave impedance: force per m/s of impact",
    };
    vec![
        Row::new(
            "surge_frequency_hz",
            "f1, first surge frequency, both ends held",
            spring.surge_frequency(),
            1.0,
            "Hz",
        ),
        Row::new("bar_frequency_hz", "½√(k/m), that of a uniform bar", bar, 1.0, "Hz"),
        Row::new(
            "model_frequency_hz",
            "first frequency of the chain that is used",
            spring.chain_frequency(),
            1.0,
            "Hz",
        ),
        Row::new("masses_per_winding", "masses of that chain per winding", spring.masses_per_winding() as f64, 1.0, ""),
        Row::new("lowest_first_frequency_hz", "f1 of the coil as a helix, lowest in use", lowest, 1.0, "Hz"),
        Row::new("highest_first_frequency_hz", "f1 of the coil as a helix, highest in use", highest, 1.0, "Hz"),
        Row::new(
            "surge_frequency_en13906_hz",
            "the same by EN 13906-1, from wire and coil",
            spec.dead_ends.is_none().then(|| spec.geometry.surge_frequency_en13906()),
            1.0,
            "Hz",
        ),
        Row::new("transit_time_s", "τ = 1/(2 f1), once through the coil", spring.transit_time(), 1e3, "ms"),
        Row::new("wave_impedance_n_s_per_m", impedance, spring.wave_impedance(), 1.0, "N s/m"),
        Row::new(
            "impact_force_share_per_m_per_s",
            "the same as a share of F_nom, per m/s",
            spring.wave_impedance() / spring.nominal_force(),
            100.0,
            "%",
        ),
    ]
}

fn of_inductance(spec: &SpringSpec) -> Result<Vec<Row>, Error> {
    let spring = &spec.spring;
    let coil = spec.inductance_at_rest()?;
    let (shortest, longest) = spring.operating_range();
    let (short, long) = (coil.at_length(shortest), coil.at_length(longest));
    let [at_shortest, at_longest] = match spec.permeability_found() {
        // Of wire that may be magnetic, and is not in these figures.
        Some(_) => ["L at the shortest length, wire not magnetic", "L at the longest length, wire not magnetic"],
        None => ["L at the shortest length", "L at the longest length"],
    };
    Ok(vec![
        Row::new("inductance_at_min_h", at_shortest, short, 1e6, "µH"),
        Row::new("inductance_at_max_h", at_longest, long, 1e6, "µH"),
        Row::new(
            "inductance_per_length_h_per_m",
            "mean slope over the range",
            (long - short) / (longest - shortest),
            1e3,
            "µH/mm",
        ),
        Row::new(
            "wire_resistance_ohm",
            "resistance of the wire",
            spec.dead_ends.is_none().then(|| spec.geometry.wire_resistance()).flatten(),
            1e3,
            "mΩ",
        ),
    ])
}
