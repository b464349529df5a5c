//! What people call a key in other places, and what an unknown key probably means.
//!
//! Next door: likeness of names (`crate::likeness`), the keys (`keys`).

use super::keys::Table;
use crate::likeness::nearest;

/// Words of other places for what a table calls differently.
struct Synonym {
    table: &'static str,
    words: &'static [&'static str],
    /// The keys that are meant, each with what to mind; the first that the kind at hand has is told.
    keys: &'static [(&'static str, &'static str)],
}

const fn same(
    table: &'static str,
    words: &'static [&'static str],
    keys: &'static [(&'static str, &'static str)],
) -> Synonym {
    Synonym { table, words, keys }
}

/// What to mind where a diameter is not the mean one.
const OUTER: &str = "the mean diameter: the outer one less the wire's";
const OUTER_HALVED: &str = "half the mean diameter: half of the outer one less the wire's";
const INNER: &str = "the mean diameter: the inner one and the wire's";
const INNER_HALVED: &str = "half the mean diameter: half of the inner one and the wire's";
const BY_PITCH: &str = "the pitch follows from rest_length and windings";

const SYNONYMS: [Synonym; 39] = [
    same(
        "spring",
        &["outer_diameter", "outside_diameter", "external_diameter", "OD", "De", "Da"],
        &[("coil_diameter", OUTER), ("coil_radius", OUTER_HALVED)],
    ),
    same(
        "spring",
        &["inner_diameter", "inside_diameter", "internal_diameter", "ID", "Di"],
        &[("coil_diameter", INNER), ("coil_radius", INNER_HALVED)],
    ),
    same("spring", &["mean_diameter", "diameter", "D", "Dm"], &[("coil_diameter", ""), ("coil_radius", "half of it")]),
    same("spring", &["radius", "mean_radius", "r", "R"], &[("coil_radius", ""), ("coil_diameter", "twice it")]),
    same(
        "spring",
        &["wire", "wire_size", "wire_thickness", "thickness", "gauge", "d"],
        &[("wire_diameter", ""), ("wire_radius", "half of it")],
    ),
    same("spring", &["k", "c", "rate", "spring_rate", "spring_constant", "constant"], &[("stiffness", "")]),
    same("spring", &["m", "weight"], &[("mass", "")]),
    same(
        "spring",
        &["n", "N", "turns", "coils", "active_turns", "active_coils", "active_windings"],
        &[("windings", "")],
    ),
    same("spring", &["n_t", "total_turns", "total_coils"], &[("total_windings", "")]),
    same("spring", &["pitch"], &[("windings", BY_PITCH)]),
    same(
        "spring",
        &["l0", "L0", "free_length", "natural_length", "unloaded_length", "initial_length"],
        &[("rest_length", "")],
    ),
    same("spring", &["l_min", "lmin", "shortest_length", "compressed_length", "minimum_length"], &[("min_length", "")]),
    same("spring", &["l_max", "lmax", "longest_length", "extended_length", "maximum_length"], &[("max_length", "")]),
    same("spring", &["F0", "F_0", "pretension", "initial_force"], &[("initial_tension", "")]),
    same("spring", &["F_nom", "rated_force", "max_force", "maximum_force"], &[("nominal_force", "")]),
    same("spring", &["ends", "end"], &[("end_type", "")]),
    same("spring", &["G"], &[("shear_modulus", "")]),
    same("spring", &["E", "elastic_modulus"], &[("youngs_modulus", "")]),
    same("mount", &["zeta", "xi", "damping_factor", "damping_coefficient"], &[("damping_ratio", "")]),
    same("mount", &["alpha"], &[("mass_damping", "")]),
    same("mount", &["beta"], &[("stiffness_damping", "")]),
    same("mount", &["m", "load", "load_mass", "payload"], &[("end_mass", "")]),
    same("condition", &["type"], &[("kind", "")]),
    same(
        "condition",
        &["v", "v0", "speed", "impact_speed", "impact_velocity"],
        &[("velocity", ""), ("playback_speed", "a share of the speed at which the file was recorded")],
    ),
    same("condition", &["playback", "time_scale", "play_speed", "rpm"], &[("playback_speed", "")]),
    same("condition", &["f", "hertz"], &[("frequency", "")]),
    same("condition", &["a", "height", "stroke", "displacement", "travel"], &[("amplitude", "")]),
    same("condition", &["t", "time", "end_time"], &[("duration", "")]),
    same(
        "condition",
        &["dt", "fs", "rate", "time_step", "sampling", "sampling_rate", "sampling_frequency"],
        &[("sample_rate", "")],
    ),
    same("condition", &["csv", "path", "input", "data"], &[("file", "")]),
    same("condition", &["start_time", "delay", "at_time", "t0"], &[("begin", "")]),
    same("sensor", &["type"], &[("kind", "")]),
    same("sensor", &["fs", "rate", "sampling", "sampling_rate", "sampling_frequency"], &[("sample_rate", "")]),
    same("sensor", &["full_scale", "capacity", "span"], &[("range", "")]),
    same(
        "sensor",
        &["accuracy", "linearity", "nonlinearity"],
        &[("accuracy_full_scale", "of the range; accuracy_reading is of the reading")],
    ),
    same("sensor", &["latency", "lag", "dead_time"], &[("delay", "")]),
    same("sensor", &["cutoff", "cut_off", "filter", "low_pass"], &[("bandwidth", "")]),
    same("goal", &["accuracy", "uncertainty", "tolerance"], &[("error", "")]),
    same("goal", &["reference", "truth", "true_force"], &[("force", "")]),
];

/// The key that a table calls by another word, as the kind at hand has it, and what to mind.
pub(super) fn synonym(table: &Table, kind: Option<&str>, word: &str) -> Option<(&'static str, &'static str)> {
    let found = SYNONYMS.iter().find(|synonym| synonym.table == table.name && synonym.words.contains(&word))?;
    let names = table.names(kind);
    found.keys.iter().find(|(key, _)| names.contains(key)).or(found.keys.first()).copied()
}

/// What to say of an unknown key: what it probably means, among the keys of the kind at hand first, then among those of other kinds; empty
/// where nothing is like it.
pub(super) fn meant(table: &Table, kind: Option<&str>, word: &str) -> String {
    let own = || nearest(word, table.names(kind)).or_else(|| nearest(word, table.names(None)));
    let Some((name, mind)) = synonym(table, kind, word).or_else(|| Some((own()?, ""))) else { return String::new() };
    let mind = if mind.is_empty() { String::new() } else { format!(" ({mind})") };
    let strange = table.keys.iter().find(|key| key.name == name && !key.applies_to(kind));
    let what = if table.name == "spring" { "a spring " } else { "" };
    let elsewhere =
        strange.map_or_else(String::new, |key| format!(", which only {what}{} has", key.kinds.join(" or ")));
    format!("; did you mean \"{name}\"{mind}{elsewhere}?")
}

#[cfg(test)]
mod tests {
    use super::super::keys::TABLES;
    use super::SYNONYMS;

    #[test]
    fn every_synonym_leads_to_a_key_and_is_none_itself() {
        for synonym in &SYNONYMS {
            let table = TABLES.iter().find(|table| table.name == synonym.table).expect(synonym.table);
            let names = table.names(None);
            for (key, _) in synonym.keys {
                assert!(names.contains(key), "{key} in {}", table.name);
            }
            assert!(synonym.words.iter().all(|word| !names.contains(word)), "{:?}", synonym.words);
        }
    }
}
