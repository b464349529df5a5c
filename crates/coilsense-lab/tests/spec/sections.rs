//! Coils of sections: what follows from them, and what no coil is.

use coilsense_lab::data_sheet::DataSheet;
use coilsense_lab::spec::{Model, Spec};

use super::fixtures::{BY_SECTIONS, read};

/// A valve spring with closed ends, narrow windings at both and wide ones between.
fn progressive() -> String {
    let section = |windings: &str, pitch: &str| {
        format!(
            "[[spring.section]]\nwindings = {windings}\npitch = {pitch}\ncoil_diameter = \"25 mm\"\nwire_diameter = \"4 mm\"\n\n"
        )
    };
    let head = "[spring]\nname = \"progressive\"\nmin_length = \"36 mm\"\nmax_length = \"44 mm\"\nend_type = \"closed-ground\"\n\n";
    let closed = section("1", "\"4 mm\"");
    let narrow = section("1.5", "[\"4 mm\", \"8 mm\"]");
    let back = section("1", "[\"8 mm\", \"4 mm\"]");
    format!("{head}{closed}{narrow}{}{back}{closed}", section("4", "\"8 mm\""))
}

fn spec(text: &str) -> Spec {
    read(text).unwrap()
}

#[test]
fn closed_ends_lie_on_their_seats_and_the_rest_is_the_spring() {
    let spec = spec(&progressive());
    let (spring, dead) = (&spec.spring.spring, spec.spring.dead_ends.unwrap());
    assert_eq!(dead.windings, [1.0, 1.0]);
    // 4 + 1.5 · 6 + 4 · 8 + 6 + 4 mm; closed by 15 mm in all.
    assert!((spring.rest_length() - 55e-3).abs() < 1e-12, "{}", spring.rest_length());
    assert!((spec.spring.solid_length() - 34e-3).abs() < 1e-12, "{}", spec.spring.solid_length());
    assert!((spring.windings() - 6.5).abs() < 1e-12 && spec.spring.model == Model::Chain);
    // G d⁴/(8 D³ n) of EN 10270-1.
    let shear = spec.spring.geometry.material().shear_modulus();
    let expected = shear * 4e-3_f64.powi(4) / (8.0 * 25e-3_f64.powi(3) * 6.5);
    assert!((spring.stiffness() / expected - 1.0).abs() < 1e-12);
    // Open ends stand on wire: one diameter longer.
    let open = self::spec(&progressive().replace("closed-ground", "closed").replace("36 mm", "40 mm"));
    assert!((open.spring.spring.rest_length() - 59e-3).abs() < 1e-12);
}

#[test]
fn the_data_sheet_tells_the_curve_with_its_knees() {
    let spec = spec(BY_SECTIONS);
    let sheet = DataSheet::of(&spec).unwrap();
    let spring = &spec.spring.spring;
    // The first two windings close at k_w · 1 mm, 6.5 k in all.
    let first = 6.5 * spring.stiffness() * 1e-3;
    let row = |key: &str| {
        sheet.groups.iter().flat_map(|(_, rows)| rows).find(|row| row.key == key).and_then(|row| row.value).unwrap()
    };
    assert!((row("first_closing_force_n") / first - 1.0).abs() < 1e-12);
    // 2 mm of them and 4.5 mm of the others under that force: 46 − 6.5 mm, below the range in use.
    assert!((row("first_closing_length_m") - 39.5e-3).abs() < 1e-12 && sheet.static_curve.iter().all(|at| !at.is_knee));
    assert_eq!(row("dead_mass_kg"), 0.0);
    let deeper = self::spec(&BY_SECTIONS.replace("40 mm", "32 mm"));
    let curve = DataSheet::of(&deeper).unwrap().static_curve;
    let knee = curve.iter().find(|at| at.is_knee).unwrap();
    assert!((knee.length_m - 39.5e-3).abs() < 1e-9 && (knee.force_n / -first - 1.0).abs() < 1e-7);
    let last = curve.last().unwrap();
    assert!((last.closed_windings - 2.0).abs() < 1e-9 && last.length_m == 32e-3);
    assert!((last.stiffness_n_per_m / spring.stiffness() - 6.5 / 4.5).abs() < 1e-6, "{last:?}");
    // A uniform coil of 4.5 windings: f1 over that of 6.5 is 6.5/4.5, but for half the first gap between masses.
    let ratio = last.first_surge_hz.unwrap() / curve[0].first_surge_hz.unwrap();
    assert!((ratio / (6.5 / 4.5) - 1.0).abs() < 5e-3, "{ratio}");
    // A uniform spring has neither.
    let uniform = DataSheet::of(&self::spec(super::fixtures::BY_GEOMETRY)).unwrap();
    assert!(uniform.static_curve.is_empty() && uniform.groups.iter().all(|(heading, _)| *heading != "Sections"));
}

#[test]
fn windings_that_close_in_use_take_contact() {
    let condition = "\n[[condition]]\nkind = \"impact\"\nvelocity = \"0.1 m/s\"\n";
    read(&format!("{BY_SECTIONS}{condition}")).unwrap();
    let deeper = BY_SECTIONS.replace("40 mm", "32 mm");
    // Alone it is a spring with a data sheet.
    read(&deeper).unwrap();
    let refused = read(&format!("{deeper}{condition}")).unwrap_err();
    assert!(refused.contains("close from 39.500 mm on") && refused.contains("[contact]"), "{refused}");
    assert_eq!(refused.lines().count(), 1);
    read(&format!("{deeper}\n[contact]\nwindings = \"hard\"\n{condition}")).unwrap();
}

#[test]
fn what_is_no_coil_is_refused_at_its_line() {
    for (from, to, line, part) in [
        ("pitch = \"8 mm\"", "pitch = \"3 mm\"", 15, "at least 0.004 m, where wires touch"),
        ("pitch = \"8 mm\"", "pitch = [\"8 mm\"]", 15, "must be a list of two"),
        ("pitch = \"8 mm\"", "pitch = \"4 mm\"", 4, "cannot be pulled"),
        ("windings = 4.5", "windings = 0", 14, "above zero"),
        ("windings = 4.5", "windings = 4.5\nwindigs = 2", 15, "no key of a section"),
        ("windings = 4.5", "", 0, "lacks the key \"windings\""),
        ("coil_diameter = \"25 mm\"", "coil_diameter = \"3 mm\"", 10, "above the wire's 0.004 m"),
        ("end_type = \"open-ground\"", "end_type = \"closed-ground\"", 9, "must touch there"),
        ("end_type = \"open-ground\"", "model = \"helix\"", 5, "no key of a spring by sections"),
        ("end_type = \"open-ground\"", "rest_length = \"46 mm\"", 5, "no key of a spring by sections"),
        ("min_length = \"40 mm\"", "min_length = \"20 mm\"", 3, "at least the solid length"),
        ("max_length = \"45 mm\"", "max_length = \"60 mm\"", 4, "cannot be pulled"),
    ] {
        let message = read(&BY_SECTIONS.replacen(from, to, 1)).map(|_| ()).unwrap_err();
        assert!(message.contains(part) && message.lines().count() == 1, "{to}: {message}");
        assert!(line == 0 || message.contains(&format!(":{line}: ")), "{line}: {message}");
    }
    let closed = BY_SECTIONS.replace("\"5 mm\"", "\"4 mm\"").replace("\"8 mm\"", "\"4 mm\"");
    assert!(read(&closed).unwrap_err().contains("at least one section must have a gap"));
    let middle = format!(
        "{}\n{}",
        BY_SECTIONS.replace("\"8 mm\"", "\"4 mm\""),
        &BY_SECTIONS[BY_SECTIONS.rfind("[[spring").unwrap()..]
    );
    assert!(read(&middle).unwrap_err().contains("is closed between open sections"));
    let table = "[spring]\nname = \"x\"\nmin_length = \"1 mm\"\nmax_length = \"2 mm\"\nsection = 3\n";
    assert!(read(table).unwrap_err().contains("must be tables [[spring.section]]"));
}

#[test]
fn what_knows_no_sections_says_so() {
    let spec = spec(BY_SECTIONS);
    let refused = spec.needs_chain("placement").unwrap_err().to_string();
    assert!(refused.contains("[[spring.section]]: placement takes a uniform coil"), "{refused}");
}
