//! Springs of coils wound in sections.
//!
//! | ours | held against |
//! |---|---|
//! | a uniform coil as sections | the uniform spring: forces, places, inductance |
//! | the curve as a table | the closed form of the sections |
//! | f1 where windings are closed | that of the uniform coil which is left |
//! | a start with closed windings | the static curve; the energy that is there |
//! | rings of unequal radii | 40 digits (mpmath) |

use std::sync::Arc;

use coilsense::contact::{Contact, Path, Touching};
use coilsense::excitation::Start;
use coilsense::inductance::{MaxwellSum, SelfDistance, mutual_inductance_of_rings};
use coilsense::mitigation::SampledSpring;
use coilsense::sections::{Section, Sections};
use coilsense::two_port::TwoPort;
use coilsense::{
    Clash, Damping, EndInput, Excitation, FarEnd, Motion, Mount, Spring, SpringParameters, VelocityProfile,
};

const G: f64 = 79.3e9;
const RHO: f64 = 7850.0;

fn section(windings: f64, pitch: [f64; 2], coil_diameter: [f64; 2]) -> Section {
    Section { windings, pitch, coil_diameter, wire_diameter: 4e-3, telescopes: false }
}

fn coil(sections: &[Section]) -> Sections {
    Sections::new(sections.to_vec(), G, RHO).unwrap()
}

/// Narrow windings at either end, which lie on one another at lengths in use.
fn progressive() -> Sections {
    let narrow = section(1.5, [4e-3, 8e-3], [25e-3; 2]);
    coil(&[narrow, section(4.0, [8e-3; 2], [25e-3; 2]), Section { pitch: [8e-3, 4e-3], ..narrow }])
}

fn spring(coil: &Sections, masses: usize) -> Spring {
    let solid = coil.place_at(coil.windings(), coil.solid_force());
    let spring = Spring::of_sections(coil.clone(), 0.0, (solid + 1e-3, coil.span())).unwrap();
    spring.with_masses_per_winding(masses).unwrap()
}

#[test]
fn a_uniform_coil_as_sections_is_the_uniform_spring() {
    let sections = coil(&[section(2.5, [8e-3; 2], [25e-3; 2]), section(3.5, [8e-3; 2], [25e-3; 2])]);
    let wound = spring(&sections, 3);
    let uniform = Spring::new(SpringParameters { sections: None, ..wound.parameters().clone() }).unwrap();
    let uniform = uniform.with_masses_per_winding(3).unwrap();
    assert!((wound.chain_frequency() / uniform.chain_frequency() - 1.0).abs() < 1e-12);
    assert!((wound.surge_frequency() / uniform.surge_frequency() - 1.0).abs() < 1e-5);
    let excitation = Excitation::impact(0.043, 0.4).unwrap();
    let times: Vec<f64> = (0..400).map(|sample| f64::from(sample) * 5e-5).collect();
    for far_end in [FarEnd::Position, FarEnd::Force, FarEnd::Mass(0.3)] {
        let mount = Mount::new(far_end, Damping::Modal(0.01)).unwrap();
        let of = |spring: &Spring| Motion::mounted(spring, &mount, &excitation).unwrap();
        let (here, there) = (of(&wound), of(&uniform));
        let (a, b) = (here.end_forces(&times).unwrap(), there.end_forces(&times).unwrap());
        for (a, b) in a.input.iter().zip(&b.input).chain(a.output.iter().zip(&b.output)) {
            // 1e-12 of some 400 N.
            assert!((a - b).abs() < 4e-10, "{far_end:?}: {a} {b}");
        }
        let (a, b) = (here.windings(&times).unwrap(), there.windings(&times).unwrap());
        assert!(a.positions().iter().zip(b.positions()).all(|(a, b)| (a - b).abs() < 1e-14));
        let [first, second] =
            [&wound, &uniform].map(|spring| MaxwellSum::new(spring, SelfDistance::GeometricMean).series(&b));
        assert!(first.iter().zip(&second).all(|(a, b)| (a / b - 1.0).abs() < 1e-13));
    }
    let [first, second] =
        [&wound, &uniform].map(|spring| MaxwellSum::new(spring, SelfDistance::AsPrinted).at_length(0.04));
    assert!((first / second - 1.0).abs() < 1e-13, "{first:e} {second:e}");
}

#[test]
fn the_static_force_is_the_curve_of_the_sections_in_either_sense() {
    let cone = Section { telescopes: true, ..section(5.0, [8e-3; 2], [40e-3, 20e-3]) };
    // Its gap over compliance turns within the section: the curve bends like a root there.
    let turning = Section { wire_diameter: 3e-3, ..section(6.0, [5e-3, 9e-3], [16e-3, 26e-3]) };
    for sections in [progressive(), coil(&[cone]), coil(&[turning])] {
        let spring = spring(&sections, 1);
        let most = sections.compression(sections.solid_force()).unwrap();
        for step in 1..=997 {
            let compression = most * f64::from(step) / 997.5;
            let exact = sections.force(compression).unwrap();
            let found = -spring.static_force(spring.rest_length() - compression);
            assert!(
                (found - exact).abs() < 1e-7 * exact.max(1e-3 * sections.solid_force()),
                "{compression} {found} {exact}"
            );
        }
        let rate = spring.rate_at(spring.rest_length() - 0.3 * most);
        let exact = sections.rate(sections.force(0.3 * most).unwrap()).unwrap();
        assert!((rate / exact - 1.0).abs() < 1e-4, "{rate} {exact}");
        // Pulled, all windings are open; a stiffer specimen is stiffer throughout.
        let pulled = spring.static_force(spring.rest_length() + 1e-3);
        assert!((pulled / (1e-3 * spring.stiffness()) - 1.0).abs() < 1e-12);
        let stiffer = SpringParameters { stiffness: 1.1 * spring.stiffness(), ..spring.parameters().clone() };
        let length = spring.rest_length() - 0.8 * most;
        let stiffer = Spring::new(stiffer).unwrap();
        assert!((stiffer.static_force(length) / spring.static_force(length) - 1.1).abs() < 1e-12);
    }
}

#[test]
fn closed_windings_fall_out_of_the_surge() {
    let narrow = section(2.0, [5e-3; 2], [25e-3; 2]);
    let wide = section(4.0, [8e-3; 2], [25e-3; 2]);
    let both = coil(&[narrow, wide]);
    let alone = coil(&[wide]);
    // The closed form of a uniform bar: π √(k/m).
    let bar = |coil: &Sections| std::f64::consts::PI * (coil.stiffness() / coil.mass()).sqrt();
    assert!((alone.first_frequency() / bar(&alone) - 1.0).abs() < 1e-5);
    let closing = both.first_closing();
    let (open, left) =
        (both.first_frequency_at(0.5 * closing).unwrap(), both.first_frequency_at(1.1 * closing).unwrap());
    assert!((open / both.first_frequency() - 1.0).abs() < 1e-12);
    assert!((left / bar(&alone) - 1.0).abs() < 2e-3, "{left} {}", bar(&alone));
    assert!((both.closed_at(1.1 * closing) - 2.0).abs() < 1e-12 && both.closed_at(0.9 * closing) == 0.0);
    assert!(both.first_frequency_at(2.0 * both.solid_force()).is_none());
}

#[test]
fn a_spring_with_closed_windings_stays_at_rest_at_its_static_force() {
    let sections = progressive();
    for masses in [2, 8] {
        let spring = spring(&sections, masses);
        let length = spring.rest_length() - 0.6 * sections.compression(sections.solid_force()).unwrap();
        let still = Excitation::new(length, EndInput::Held, EndInput::Held, Start::Rest).unwrap();
        let motion = Motion::new(&spring, &still).unwrap();
        let times: Vec<f64> = (0..100).map(|sample| f64::from(sample) * 1e-4).collect();
        for contact in [Contact::hard(0.0).unwrap(), Contact::elastic(1e9, 1.0).unwrap()] {
            let contact = contact.with_ends(true).with_lift_off(true);
            let touching = Touching::of(&motion, &contact, &times, true).unwrap();
            let course = touching.course.as_ref().unwrap();
            assert!(course.given_up.is_none() && course.touches.iter().all(|touch| touch.closing_speed < 1e-6));
            let expected = spring.static_force(length);
            for force in course.input.iter().chain(&course.output) {
                assert!((force - course.input[0]).abs() < 1e-6 * expected.abs(), "{force} {}", course.input[0]);
            }
            // By turns a point closes on the mean gap of the wire below it: first order in the masses, and less where windings give.
            let apart = (course.input[0] / expected - 1.0).abs();
            assert!(apart < 0.12 / masses as f64, "{masses}: {} {expected}", course.input[0]);
            assert!(course.balance.open().abs() < 1e-9, "{:?}", course.balance);
        }
    }
}

#[test]
fn pressed_slowly_it_follows_its_curve_the_better_the_more_masses() {
    let sections = progressive();
    let stroke = 0.9 * sections.compression(sections.solid_force()).unwrap();
    let most = sections.force(stroke).unwrap();
    let apart = |masses: usize| {
        let spring = spring(&sections, masses);
        let still = Excitation::new(spring.rest_length() - 1e-6, EndInput::Held, EndInput::Held, Start::Rest).unwrap();
        let mount = Mount::new(FarEnd::Position, Damping::MassProportional { rate: 300.0 }).unwrap();
        let motion = Motion::mounted(&spring, &mount, &still).unwrap();
        let rise =
            [0.0, 0.0, 0.0, 10.0, -15.0, 6.0].iter().zip(0..).map(|(c, power)| stroke * c / f64::powi(0.5, power));
        let path = Path::new(vec![0.0, 0.5], vec![rise.collect()]).unwrap();
        let times: Vec<f64> = (1..=50).map(|sample| f64::from(sample) * 0.01).collect();
        let contact = Contact::hard(0.0).unwrap().with_ends(true);
        let course = Touching::driven(&motion, &contact, path.clone(), &times).unwrap();
        assert!(course.given_up.is_none());
        let each = times.iter().zip(course.output).map(|(&time, force)| {
            let open = sections.force((path.value(time) + 1e-6).clamp(0.0, stroke)).unwrap();
            (-force - open).abs()
        });
        each.fold(0.0, f64::max)
    };
    let [coarse, fine] = [apart(2), apart(8)];
    assert!(fine < 0.02 * most && fine < 0.5 * coarse, "{coarse} {fine} of {most}");
}

#[test]
fn without_contact_it_is_said_when_windings_would_touch() {
    let sections = coil(&[section(2.0, [5e-3; 2], [25e-3; 2]), section(4.0, [8e-3; 2], [25e-3; 2])]);
    let spring = spring(&sections, 4);
    let slow = |amplitude: f64| {
        let ends = [EndInput::harmonic(amplitude, 0.5, 0.0), EndInput::Held];
        let [first, second] = ends;
        let length = spring.rest_length() - 0.5 * sections.compression(sections.first_closing()).unwrap();
        let motion = Motion::new(&spring, &Excitation::new(length, first, second, Start::Massless).unwrap()).unwrap();
        let times: Vec<f64> = (0..=1000).map(|sample| f64::from(sample) * 1e-3).collect();
        (Clash::of(&motion, &times).unwrap(), Clash::excluded(&motion, 1.0, spring.wire_diameter()))
    };
    let room = 0.5 * sections.compression(sections.first_closing()).unwrap();
    let (clear, _) = slow(0.9 * room);
    assert!(!clear.happens() && clear.clearance() > 0.0, "{clear:?}");
    let (touches, excluded) = slow(1.1 * room);
    assert!(touches.happens() && touches.winding <= 2 && !excluded, "{touches:?}");
    // u1 = 1.1 room sin(πt) reaches the room at asin(1/1.1)/π.
    let expected = (1.0_f64 / 1.1).asin() / std::f64::consts::PI;
    assert!((touches.first_contact.unwrap() - expected).abs() < 2e-3, "{touches:?} {expected}");
}

#[test]
fn rings_of_unequal_radii_have_maxwells_inductance() {
    // μ₀ √(ab) ((2/κ − κ)K − (2/κ)E), mpmath at 40 digits.
    for ([a, b], h, expected) in [
        ([0.02, 0.01], 0.0, 1.097_235_894_694_795_9e-8),
        ([0.02, 0.0199], 0.0003, 1.059_009_211_276_418_6e-7),
        ([0.02, 0.01], 0.05, 4.845_676_410_778_945e-10),
        ([0.02, 0.005], 2.0, 2.467_007_913_333_381e-15),
    ] {
        let found = mutual_inductance_of_rings([a, b], h);
        assert!((found / expected - 1.0).abs() < 3e-15, "{a} {b} {h}: {found:e}");
        assert_eq!(found, mutual_inductance_of_rings([b, a], -h));
    }
}

#[test]
fn what_knows_no_sections_refuses_them() {
    let spring = spring(&progressive(), 1);
    let two_port = TwoPort::chain(&spring, Damping::None).map(|_| ()).unwrap_err();
    let sampled = SampledSpring::new(&spring, &Damping::None, 10_000.0).map(|_| ()).unwrap_err();
    let coil = MaxwellSum::new(&spring, SelfDistance::AsPrinted);
    let gradient = coil.gradient([0.0, 0.05], &[0.01; 7]).map(|_| ()).unwrap_err();
    for error in [two_port, sampled, gradient] {
        assert!(error.to_string().contains("sections"), "{error}");
    }
    let steady = Excitation::new(0.04, EndInput::harmonic(1e-4, 20.0, 0.0), EndInput::Held, Start::Steady).unwrap();
    let motion = Motion::new(&spring, &steady).unwrap();
    let refused =
        Touching::of(&motion, &Contact::default().with_ends(true), &[0.0, 0.01], false).map(|_| ()).unwrap_err();
    assert!(refused.to_string().contains("no steady state"), "{refused}");
    // Windings that are none of its sections.
    let mut parameters = spring.parameters().clone();
    parameters.windings += 1.0;
    assert!(Spring::new(parameters.clone()).unwrap_err().to_string().contains("of its sections"));
    parameters.windings -= 1.0;
    parameters.sections = Some(Arc::new(coil_of_one()));
    assert!(Spring::new(parameters).is_err());
}

fn coil_of_one() -> Sections {
    coil(&[section(1.0, [8e-3; 2], [25e-3; 2])])
}

#[test]
fn an_impact_on_closed_windings_makes_no_energy() {
    let spring = spring(&progressive(), 6);
    let length = 0.042;
    for (velocity, profile) in [(1.5, VelocityProfile::Uniform), (-1.5, VelocityProfile::Linear)] {
        let start = Start::Moving { velocity, profile };
        let excitation = Excitation::new(length, EndInput::Held, EndInput::Held, start).unwrap();
        let motion = Motion::new(&spring, &excitation).unwrap();
        let times: Vec<f64> = (0..200).map(|sample| f64::from(sample) * 1e-4).collect();
        for contact in [Contact::hard(0.0).unwrap(), Contact::hard(0.5).unwrap(), Contact::elastic(5e8, 0.3).unwrap()] {
            let touching = Touching::of(&motion, &contact.with_ends(true).with_lift_off(true), &times, true).unwrap();
            let balance = touching.course.as_ref().unwrap().balance;
            let scale = balance.moved + balance.gained.abs() + balance.lost;
            assert!(balance.open().abs() < 1e-10 * scale, "{velocity}: {balance:?}");
            assert!(balance.lost > -1e-9, "{balance:?}");
        }
    }
}
