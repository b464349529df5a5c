//! Chains that are not uniform: modes against closed forms of rods, and slow compression against closed forms.

use std::f64::consts::PI;

use coilsense::contact::{Chain, Contact, Drive, Path, Start, follow};
use coilsense::sections::{Section, Sections};
use coilsense::{Damping, EndInput, Excitation, FarEnd, Motion, Mount, Spring, excitation, paper};

const NEVER: f64 = f64::INFINITY;

/// The chain of a coil, without seats.
fn chain_of(coil: &Sections, masses: usize) -> Chain {
    let spring = wound(coil, masses);
    Chain::of(&spring, FarEnd::Position, spring.wire_diameter(), false).unwrap()
}

fn wound(coil: &Sections, masses: usize) -> Spring {
    let solid = coil.place_at(coil.windings(), coil.solid_force());
    let spring = Spring::of_sections(coil.clone(), 0.0, (solid * 1.001, coil.span())).unwrap();
    spring.with_masses_per_winding(masses).unwrap()
}

/// What holds the ends of the progressive spring \[N/m\].
const STIFF: f64 = 3e6;

/// A rod as a chain: masses at the middle of N equal stretches, `mass` and `stiffness` per length at a place from 0 to 1.
fn rod(lumps: usize, mass: impl Fn(f64) -> f64, compliance: impl Fn(f64, f64) -> f64) -> Chain {
    let width = 1.0 / lumps as f64;
    let at = |lump: usize| (lump as f64 + 0.5) * width;
    let masses = (0..lumps).map(|lump| mass(at(lump)) * width).collect();
    let mut places: Vec<f64> = (0..lumps).map(at).collect();
    places.insert(0, 0.0);
    places.push(1.0);
    let stiffnesses = places.windows(2).map(|pair| 1.0 / compliance(pair[0], pair[1])).collect();
    Chain::new(masses, stiffnesses, vec![NEVER; lumps + 1]).unwrap()
}

#[test]
fn a_stepped_rod_rings_as_its_closed_form_at_second_order() {
    // The first 40 % with stiffness 1 and mass 1, the rest with 3 and 0.6: Z_1 cot(ωt_1) + Z_2 cot(ωt_2) = 0.
    let expected = [4.830_512_237_909, 9.196_389_764_677, 14.310_358_494_097];
    let of = |lumps: usize| {
        let compliance = |from: f64, to: f64| {
            let soft = (to.min(0.4) - from.min(0.4)).max(0.0);
            soft + (to - from - soft) / 3.0
        };
        let chain = rod(lumps, |place| if place < 0.4 { 1.0 } else { 0.6 }, compliance);
        let modes = chain.modes().unwrap();
        expected.iter().zip(modes.frequencies()).map(|(expected, found)| found / expected - 1.0).collect::<Vec<f64>>()
    };
    let (coarse, fine) = (of(100), of(1000));
    for ((coarse, fine), stated) in coarse.iter().zip(&fine).zip([-8.31e-5, -1.83e-4, -6.94e-4]) {
        assert!((coarse / stated - 1.0).abs() < 0.02, "{coarse} for {stated}");
        assert!((coarse / fine / 100.0 - 1.0).abs() < 0.02, "{coarse} {fine}");
    }
}

#[test]
fn a_tapered_rod_rings_at_multiples_of_pi() {
    // Stiffness and mass (1 + 1.5 s)² per length.
    let of = |lumps: usize| {
        let area = |place: f64| (1.0 + 1.5 * place).powi(2);
        let compliance = |from: f64, to: f64| (to - from) / ((1.0 + 1.5 * from) * (1.0 + 1.5 * to));
        rod(lumps, area, compliance).modes().unwrap().frequencies()[0] / PI - 1.0
    };
    for (lumps, stated) in [(50, -1.64e-4), (200, -1.03e-5), (1000, -4.11e-7)] {
        let found = of(lumps);
        assert!(
            (found / stated - 1.0).abs() < 0.5 && found.abs() < 2.0 * stated.abs(),
            "{lumps}: {found} for {stated}"
        );
    }
}

#[test]
fn a_uniform_chain_found_so_moves_as_the_spring() {
    let spring = paper::s_t();
    for far_end in [FarEnd::Position, FarEnd::Force, FarEnd::Mass(0.4)] {
        let chain = Chain::of(&spring, far_end, spring.wire_diameter(), false).unwrap();
        let modes = chain.modes().unwrap();
        let own = Motion::mounted(&spring, &Mount::new(far_end, Damping::None).unwrap(), &push(far_end)).unwrap();
        for (found, expected) in modes.frequencies().iter().zip(own.modes().frequencies()) {
            assert!((found / expected - 1.0).abs() < 1e-12, "{far_end:?}");
        }
        let motion = Motion::of_modes(&spring, modes, Damping::None, &push(far_end)).unwrap();
        let times: Vec<f64> = (0..500).map(|sample| f64::from(sample) * 1e-4).collect();
        let (here, there) = (motion.end_forces(&times).unwrap(), own.end_forces(&times).unwrap());
        for (a, b) in here.input.iter().chain(&here.output).zip(there.input.iter().chain(&there.output)) {
            assert!((a - b).abs() < 1e-8, "{far_end:?}: {a} {b}");
        }
    }
}

fn push(far_end: FarEnd) -> Excitation {
    let size = if far_end == FarEnd::Position { 1e-3 } else { 1.0 };
    let second = EndInput::harmonic(size, 31.0, 0.2);
    Excitation::new(0.23, EndInput::harmonic(1e-3, 20.0, 0.0), second, excitation::Start::Rest).unwrap()
}

/// Eight windings of 160 N/mm, gaps of 0.5 to 4 mm, the outer half windings at the ends.
#[test]
fn a_progressive_spring_pressed_slowly_follows_its_static_curve() {
    let (k, knees) = (160e3, [4.0, 7.5, 10.5, 13.0, 15.0, 16.5, 17.5, 18.0]);
    let gaps: Vec<f64> = (1..=8).map(|step| 0.5e-3 * f64::from(step)).collect();
    // Nine lumps, each between two windings; the ends go straight on.
    let mut all = vec![NEVER];
    all.extend(&gaps);
    all.push(NEVER);
    let mut stiffnesses = vec![k; 10];
    (stiffnesses[0], stiffnesses[9]) = (STIFF, STIFF);
    let chain = Chain::new(vec![0.005; 9], stiffnesses, all).unwrap();
    let (stroke, last) = (0.3, 0.0179);
    // A cam's rise: 10 p³ − 15 p⁴ + 6 p⁵.
    let rise = [0.0, 0.0, 0.0, 10.0, -15.0, 6.0].iter().zip(0..).map(|(c, power)| last * c / f64::powi(stroke, power));
    let drive = Drive::Path(Path::new(vec![0.0, stroke], vec![rise.collect()]).unwrap());
    let times: Vec<f64> = (0..=300).map(|sample| f64::from(sample) * stroke / 300.0).collect();
    let start = Start { time: 0.0, places: vec![0.0; 9], speeds: vec![0.0; 9] };
    let damping = Damping::StiffnessProportional { time: 2e-5 };
    let held = Drive::Input(EndInput::Held, 0.0);
    let course = follow(&chain, &Contact::default(), &damping, [drive.clone(), held], &start, &times).unwrap();
    let static_force = |x: f64| {
        // x(F) = Σ min(F/k, g): straight between knees at F = k g.
        let mut before = (0.0, 0.0);
        for (step, knee) in knees.iter().enumerate() {
            let at = (knee * 1e-3, k * 0.5e-3 * (step + 1) as f64);
            if x <= at.0 {
                return before.1 + (at.1 - before.1) * (x - before.0) / (at.0 - before.0);
            }
            before = at;
        }
        f64::NAN
    };
    let Drive::Path(path) = &drive else { unreachable!() };
    for (&time, force) in times.iter().zip(&course.output) {
        let x = path.value(time);
        // The two stiff ends give way as well.
        let x = x + 2.0 * force / STIFF;
        assert!((-force - static_force(x.max(0.0))).abs() < 1.0, "{x}: {force} for {}", static_force(x));
    }
}

#[test]
fn sections_are_pressed_as_their_closed_forms() {
    // Eight windings of 160 N/mm, gaps from 0.5 to 4 mm, linear between.
    let wire = 4e-3;
    let diameter = (79.3e9 * f64::powi(wire, 4) / (8.0 * 160e3)).cbrt();
    let section = Section {
        windings: 8.0,
        pitch: [wire + 0.5e-3, wire + 4e-3],
        coil_diameter: [diameter; 2],
        wire_diameter: wire,
        telescopes: false,
    };
    let coil = Sections::new(vec![section], 79.3e9, 7850.0).unwrap();
    for (x, force) in [(5e-3, 100.3705), (10e-3, 216.6798), (15e-3, 380.7704)] {
        assert!((coil.force(x).unwrap() - force).abs() < 1e-4, "{x}: {}", coil.force(x).unwrap());
        assert!((coil.compression(coil.force(x).unwrap()).unwrap() - x).abs() < 1e-15);
    }
    let turned = Section { pitch: [section.pitch[1], section.pitch[0]], ..section };
    let mirrored = Sections::new(vec![turned], 79.3e9, 7850.0).unwrap();
    assert!((mirrored.force(0.01).unwrap() - coil.force(0.01).unwrap()).abs() < 1e-9);
    // A cone that telescopes.
    let cone = Section {
        windings: 5.0,
        pitch: [8e-3; 2],
        coil_diameter: [40e-3, 20e-3],
        wire_diameter: wire,
        telescopes: true,
    };
    let cone = Sections::new(vec![cone], 79.3e9, 7850.0).unwrap();
    assert!((cone.rate(0.0).unwrap() - 16_917.33).abs() < 0.01 && (cone.solid_force() - 2537.6).abs() < 1e-9);
    for (force, x) in [(400.0, 22.887_573e-3), (600.0, 29.120_279e-3), (1000.0, 35.139_895e-3)] {
        assert!((cone.compression(force).unwrap() - x).abs() < 1e-9);
    }
    assert!(cone.rate(3000.0).unwrap().is_infinite() && cone.rate(-1.0).is_err());
    assert!(cone.force(0.041).unwrap_err().to_string().contains("where all windings are closed"));
    // Sections in a row are one coil.
    let halves = Section { windings: 4.0, pitch: [section.pitch[0], wire + 2.25e-3], ..section };
    let second = Section { windings: 4.0, pitch: [wire + 2.25e-3, section.pitch[1]], ..section };
    let two = Sections::new(vec![halves, second], 79.3e9, 7850.0).unwrap();
    assert!((two.force(0.01).unwrap() - coil.force(0.01).unwrap()).abs() < 1e-9);
    let narrow = Section { pitch: [3e-3, 5e-3], ..section };
    let error = Sections::new(vec![narrow], 79.3e9, 7850.0).unwrap_err();
    assert!(error.to_string().starts_with("pitch[0] must be at least the wire's 0.004 m"), "{error}");
}

#[test]
fn a_uniform_section_is_the_uniform_chain() {
    let uniform =
        Section { windings: 6.0, pitch: [8e-3; 2], coil_diameter: [25e-3; 2], wire_diameter: 4e-3, telescopes: false };
    let whole = Sections::new(vec![uniform], 79.3e9, 7850.0).unwrap();
    let parts = [1.5, 2.0, 2.5].map(|windings| Section { windings, ..uniform });
    let parts = Sections::new(parts.to_vec(), 79.3e9, 7850.0).unwrap();
    for masses in [1, 4] {
        let (whole, parts) = (chain_of(&whole, masses), chain_of(&parts, masses));
        let frequency = |mode: usize, lumps: usize| {
            let (k, m) = (whole.stiffness(), whole.masses().iter().sum::<f64>());
            2.0 * lumps as f64 * (k / m).sqrt() * (0.5 * mode as f64 * PI / lumps as f64).sin()
        };
        let pairs = whole
            .modes()
            .unwrap()
            .frequencies()
            .to_vec()
            .into_iter()
            .zip(parts.modes().unwrap().frequencies().to_vec());
        for (index, (one, other)) in pairs.enumerate() {
            assert!((one / other - 1.0).abs() < 1e-12 && (one / frequency(index + 1, 6 * masses) - 1.0).abs() < 1e-12);
        }
        for (one, other) in whole.pairs().iter().zip(parts.pairs()) {
            assert!((one.gap - other.gap).abs() < 1e-15 && (one.gap - 4e-3).abs() < 1e-15);
        }
    }
}

#[test]
fn a_chain_of_sections_pressed_slowly_follows_their_static_curve() {
    let wire = 4e-3;
    let section = Section {
        windings: 6.0,
        pitch: [5e-3, 8e-3],
        coil_diameter: [25e-3, 20e-3],
        wire_diameter: wire,
        telescopes: false,
    };
    let coil = Sections::new(vec![section], 79.3e9, 7850.0).unwrap();
    let stroke = 0.9 * coil.compression(coil.solid_force()).unwrap();
    let apart = |masses: usize, by_turns: bool| {
        let chain = chain_of(&coil, masses);
        let lumps = chain.lumps();
        let chain = if by_turns {
            chain
        } else {
            // Each stretch closes by itself, as the closed form has it; its gap from 1 to 4 mm a winding.
            let gap = |place: f64| 6.0 * (1e-3 * place + 0.5 * 3e-3 * place * place);
            let mut places: Vec<f64> = (0..lumps).map(|lump| (lump as f64 + 0.5) / lumps as f64).collect();
            places.insert(0, 0.0);
            places.push(1.0);
            let gaps = places.windows(2).map(|pair| gap(pair[1]) - gap(pair[0])).collect();
            Chain::new(chain.masses().to_vec(), chain.stiffnesses().to_vec(), gaps).unwrap()
        };
        let rise =
            [0.0, 0.0, 0.0, 10.0, -15.0, 6.0].iter().zip(0..).map(|(c, power)| stroke * c / f64::powi(0.5, power));
        let path = Path::new(vec![0.0, 0.5], vec![rise.collect()]).unwrap();
        let times: Vec<f64> = (0..=50).map(|sample| f64::from(sample) * 0.01).collect();
        let start = Start { time: 0.0, places: vec![0.0; lumps], speeds: vec![0.0; lumps] };
        let drives = [Drive::Path(path.clone()), Drive::Input(EndInput::Held, 0.0)];
        let damping = Damping::MassProportional { rate: 200.0 };
        let course = follow(&chain, &Contact::default(), &damping, drives, &start, &times).unwrap();
        assert!(course.given_up.is_none());
        let each = times.iter().zip(course.output).map(|(&time, force)| {
            let open = coil.force(path.value(time).clamp(0.0, stroke)).unwrap();
            (-force - open).abs()
        });
        each.fold(0.0, f64::max)
    };
    let most = coil.force(stroke).unwrap();
    let [coarse, fine] = [apart(2, false), apart(8, false)];
    assert!(fine < 0.005 * most && fine < 0.3 * coarse, "{coarse} {fine} of {most}");
    // A point that meets the one a turn further on closes on the mean gap of that turn: 4 % where the last windings close.
    let [coarse, fine] = [apart(2, true), apart(8, true)];
    assert!(fine < 0.05 * most && fine < 0.5 * coarse, "{coarse} {fine} of {most}");
}
