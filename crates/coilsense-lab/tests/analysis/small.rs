//! Springs of a few windings or millimetres, as watches and pens have them: judged as all others.

use coilsense::inductance::MaxwellSum;
use coilsense_lab::data_sheet::DataSheet;

use super::{STILL, run, spec};

/// A spring pulled from 1.5 to 2.5 times its body, seen by a load cell only.
fn pulled(coil: f64, windings: u32) -> String {
    let wire = 0.1 * coil;
    let body = f64::from(windings) * wire;
    format!(
        "[spring]\nname = \"small\"\nwire_diameter = \"{wire} mm\"\ncoil_diameter = \"{coil} mm\"\nwindings = {windings}\n\
         rest_length = \"{body} mm\"\nmin_length = \"{} mm\"\nmax_length = \"{} mm\"\n[mount]\ndamping_ratio = 0\n\
         [uncertainty]\ntrials = 1000\n[[sensor]]\nkind = \"load-cell\"\n{STILL}",
        1.5 * body,
        2.5 * body
    )
}

#[test]
fn nobody_is_refused_for_an_inductance_that_was_not_asked_for() {
    for (coil, windings) in [(4.0, 8), (10.0, 5), (12.0, 4), (20.0, 2), (20.0, 3)] {
        let analysis = run(&pulled(coil, windings));
        // α is 1/(μ₀ N² π r²) of a long coil, above 1e9/(H m) in all of these but the widest; F_L is right where it was set.
        let force = analysis.cases[0].signals.channel(coilsense::Channel::InductanceForce).unwrap();
        let true_force = analysis.spec.spring.spring.static_force(analysis.spec.spring.spring.mid_length());
        assert!((force[0] / true_force - 1.0).abs() < 1e-6, "{coil} mm × {windings}: {} for {true_force}", force[0]);
    }
}

#[test]
fn a_single_winding_has_a_data_sheet_and_no_force_by_inductance() {
    let spec = spec(&pulled(20.0, 1));
    let sheet = DataSheet::of(&spec).unwrap();
    let slope = sheet.groups.iter().flat_map(|(_, rows)| rows).find(|row| row.key == "inductance_per_length_h_per_m");
    assert_eq!(slope.unwrap().value, Some(0.0));
    let coil = MaxwellSum::new(&spec.spring.spring, spec.spring.self_distance);
    let (spring, length) = (&spec.spring.spring, spec.spring.spring.mid_length());
    assert!(coilsense::Calibration::theoretical(spring, &coil, length).is_err());
}
