//! A progressive spring, from its sections to the answer.

use coilsense::Channel;
use coilsense_lab::analysis::{Analysis, simulate};
use coilsense_lab::data_sheet::DataSheet;
use coilsense_lab::spec::Spec;

const PROGRESSIVE: &str = include_str!("../../../../examples/progressive-spring.toml");

fn read(text: &str) -> Result<Spec, String> {
    Spec::parse("progressive.toml", text, &|_| Err("none".to_owned())).map_err(|error| error.to_string())
}

#[test]
fn a_progressive_spring_begins_closed_and_its_sensor_of_length_knows_its_knees() {
    let spec = read(PROGRESSIVE).unwrap();
    let spring = spec.spring.spring.clone();
    let analysis = Analysis::run(spec, &|_, _| true).unwrap();
    let case = &analysis.cases[0];
    let contacts = case.contacts.as_ref().unwrap();
    // Turns that lie on the seats at 46 mm do so from the start.
    assert_eq!(contacts.first, Some(0.0));
    assert!(contacts.touches.iter().any(|touch| touch.time > 0.0));
    // F_x is the static curve: k (l − l0) would be far from it.
    let of = |channel: Channel| case.signals.channel(channel).unwrap();
    let expected = spring.static_force(46e-3);
    assert!(of(Channel::DeflectionForce).iter().all(|force| (force - expected).abs() < 1e-6 * expected.abs()));
    let straight = spring.stiffness() * (46e-3 - spring.rest_length());
    assert!((straight / expected - 1.0).abs() > 0.01, "{straight} {expected}");
    // At the end of the run both ends swing about it: the mean is within the chain's few per cent.
    for channel in [Channel::InputForce, Channel::OutputForce] {
        let force = of(channel);
        let mean = force.iter().sum::<f64>() / force.len() as f64;
        assert!((mean / expected - 1.0).abs() < 0.05, "{mean} {expected}");
    }
    // The probe reads a length that stands still: what it errs by is its own, the load cell errs by the surge.
    let [cell, probe] = [0, 1].map(|sensor| case.readings[sensor].deviation.rmsd);
    assert!(probe < 0.05 * cell, "{probe} {cell}");
    let (head, _) = PROGRESSIVE.split_once("kind = \"impact\"").unwrap();
    let (_, tail) = PROGRESSIVE.split_once("profile = \"linear\"\n").unwrap();
    let shaken =
        format!("{head}kind = \"harmonic\"\nfrequency = \"50 Hz\"\namplitude = \"0.5 mm\"\nlength = \"45 mm\"\n{tail}");
    let analysis = Analysis::run(read(&shaken).unwrap(), &|_, _| true).unwrap();
    let contacts = analysis.cases[0].contacts.as_ref().unwrap();
    // They lie on end 1, which sets out at 2π · 50 Hz · 0.5 mm, as fast as a sine begins.
    let resting: Vec<_> = contacts.touches.iter().take_while(|touch| touch.time == 0.0).collect();
    let blow = std::f64::consts::TAU * 50.0 * 0.5e-3;
    assert!(!resting.is_empty() && resting.iter().all(|touch| touch.points[0] == 0), "{resting:#?}");
    assert!(resting.iter().all(|touch| (touch.closing_speed - blow).abs() < 1e-9), "{resting:#?}");
    let said = analysis.warnings.iter().map(|warning| warning.text.clone()).collect::<Vec<_>>().join("\n");
    assert!(said.contains("closed from the start"), "{said}");
}

#[test]
fn longer_it_rings_lower_and_f_l_is_of_its_rings() {
    let sheet = DataSheet::of(&read(PROGRESSIVE).unwrap()).unwrap();
    let curve = &sheet.static_curve;
    assert!(curve.windows(2).all(|pair| pair[1].length_m < pair[0].length_m));
    let (long, short) = (curve[0], curve[curve.len() - 1]);
    assert!(short.first_surge_hz.unwrap() > 1.05 * long.first_surge_hz.unwrap(), "{long:?} {short:?}");
    assert!(short.closed_windings > long.closed_windings + 0.2);
    assert!(short.stiffness_n_per_m > 1.05 * long.stiffness_n_per_m);
    let cases = simulate(&read(PROGRESSIVE).unwrap(), &|_, _| true).unwrap();
    let signals = &cases[0].signals;
    // Of a coil whose windings close F_L exists, too; it is that of a spring whose length stands still.
    let mean = |channel| {
        let values = signals.channel(channel).unwrap();
        values.iter().sum::<f64>() / values.len() as f64
    };
    let (meant, found) = (mean(Channel::DeflectionForce), mean(Channel::InductanceForce));
    assert!((found / meant - 1.0).abs() < 0.1, "{found} {meant}");
}
