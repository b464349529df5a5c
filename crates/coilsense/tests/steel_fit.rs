//! A coil of magnetic wire fitted to points: what comes back, what is stated of it, and what must not pass for it.

use coilsense::calibrate::{CalibrationPoints, CubicFit, Permeability, SteelDoubts, SteelFit};
use coilsense::inductance::theories::Coil;
use coilsense::inductance::{Leads, SteelCoil};
use rand::{RngExt, SeedableRng};
use rand_distr::{Distribution, StandardNormal};
use rand_pcg::Pcg64Mcg;

/// A coil of twelve windings, close wound at 25 mm, and the lengths at which it is measured.
const NUMBERS: [f64; 3] = [12.3, 8e-3, 1e-3];
const MEASURED_AT: f64 = 0.0246;
const RANGE: [f64; 2] = [0.0259, 0.0420];

fn lengths(count: usize) -> Vec<f64> {
    (0..count).map(|index| 0.0265 + 0.0145 * index as f64 / (count - 1) as f64).collect()
}

fn steel([windings, radius, wire]: [f64; 3], leads: Leads) -> SteelCoil {
    SteelCoil::new(&Coil::new(windings, radius, wire).unwrap(), MEASURED_AT, leads, RANGE).unwrap()
}

fn points(lengths: &[f64], inductances: &[f64]) -> CalibrationPoints {
    CalibrationPoints::new(lengths, inductances).unwrap()
}

fn fit(points: &CalibrationPoints) -> Result<SteelFit, coilsense::Error> {
    SteelFit::new(&steel(NUMBERS, Leads::Open), points, Permeability::Fitted, &SteelDoubts::default())
}

#[test]
fn what_a_coil_has_comes_back_from_two_points_on() {
    let coil = steel(NUMBERS, Leads::Open);
    for permeability in [1.0, 1.02, 2.5, 8.0, 19.0] {
        let wire = coil.of(permeability).unwrap();
        for count in [2, 3, 10] {
            let lengths = lengths(count);
            let inductances: Vec<f64> = lengths.iter().map(|&length| wire.inductance(length) - 4e-8).collect();
            let fit = fit(&points(&lengths, &inductances)).unwrap();
            assert!((fit.permeability / permeability - 1.0).abs() < 1e-9, "{permeability}: {}", fit.permeability);
            assert!((fit.offset + 4e-8).abs() < 1e-15 && fit.rms < 1e-15);
            let more = fit.inductance(0.03) - fit.not_magnetic(0.03);
            assert!((more > 0.0) == (permeability > 1.0) || more.abs() < 1e-14, "{more}");
            for length in [0.0262, 0.03, 0.0415] {
                let read = fit.length(fit.inductance(length)).unwrap();
                assert!((read - length).abs() < 1e-12, "{read}");
            }
            // What windings, radius, wire and leads make comes on top of the meter's noise.
            let (stated, noise) = (fit.permeability_u.unwrap(), fit.permeability_noise.unwrap());
            assert!(stated > 1.1 * noise && stated < permeability, "{stated}, {noise}");
        }
    }
}

#[test]
fn stated_intervals_hold_for_coils_that_are_not_quite_what_is_told() {
    // Truth: windings, radius, wire and leads off by their uncertainties, a smooth rest of the theory, a meter's noise.
    let doubts = SteelDoubts { theory: 0.0, ..SteelDoubts::default() };
    let told = steel(NUMBERS, Leads::Open);
    let mut random = Pcg64Mcg::seed_from_u64(20);
    let normal = |random: &mut Pcg64Mcg| -> f64 { StandardNormal.sample(random) };
    let (mut inside, mut judged, mut of_permeability, mut called) = (0, 0, 0, 0);
    const RUNS: usize = 60;
    for run in 0..RUNS {
        let [n, r, a] = NUMBERS;
        let windings = n * (1.0 + doubts.windings * normal(&mut random));
        let radius = r * (1.0 + doubts.coil_radius * normal(&mut random));
        let wire = a + 0.5 * doubts.wire_diameter * normal(&mut random);
        let leads = if random.random_bool(0.5) { Leads::Open } else { Leads::Beside(0.05) };
        // Half of the springs are not magnetic.
        let permeability = if run % 2 == 0 { 1.0 } else { 2.2 };
        let truth = Coil::new(windings, radius, wire).unwrap();
        let range = [RANGE[0].max(1.041 * 2.0 * wire * windings), RANGE[1]];
        let truth = SteelCoil::new(&truth, MEASURED_AT, leads, range).unwrap().of(permeability).unwrap();
        let lengths = lengths(9);
        let inductances: Vec<f64> = lengths
            .iter()
            .map(|&length| truth.inductance(length) + 3e-8 + doubts.meter * normal(&mut random))
            .collect();
        let two = points(&[lengths[0], lengths[8]], &[inductances[0], inductances[8]]);
        let fit = SteelFit::new(&told, &two, Permeability::Fitted, &doubts).unwrap();
        for (&length, &henry) in lengths.iter().zip(&inductances).skip(1).take(7) {
            judged += 1;
            inside += usize::from((fit.length(henry).unwrap() - length).abs() <= 1.96 * fit.length_u(henry));
        }
        of_permeability += usize::from((fit.permeability - permeability).abs() <= 1.96 * fit.permeability_u.unwrap());
        called += usize::from(permeability == 1.0 && fit.is_magnetic());
    }
    println!(
        "{inside} of {judged} lengths, {of_permeability} of {RUNS} permeabilities, {called} of {} called",
        RUNS / 2
    );
    // 95 % of them, less three standard deviations of what 60 springs show.
    assert!(inside as f64 >= 0.88 * judged as f64, "{inside} of {judged}");
    assert!(of_permeability as f64 >= 0.87 * RUNS as f64, "{of_permeability}");
    assert!(called <= 1, "{called} springs of air called magnetic");
}

#[test]
fn a_spring_mounted_anew_is_zeroed_at_one_point() {
    let wire = steel(NUMBERS, Leads::Open).of(2.0).unwrap();
    let lengths = lengths(5);
    let before = fit(&points(&lengths, &lengths.iter().map(|&l| wire.inductance(l)).collect::<Vec<_>>())).unwrap();
    let moved = |length: f64| wire.inductance(length) + 1.1e-8;
    let after = before.re_zeroed(0.03, moved(0.03)).unwrap();
    assert!((after.length(moved(0.04)).unwrap() - 0.04).abs() < 1e-9);
    assert!((before.length(moved(0.04)).unwrap() - 0.04).abs() > 1e-4);
    let message = before.re_zeroed(0.05, 1e-6).unwrap_err().to_string();
    assert!(message.contains("length to zero at must be from 0.0259 to 0.042 m"), "{message}");
}

#[test]
fn a_known_permeability_leaves_the_constant_alone() {
    let coil = steel(NUMBERS, Leads::Open);
    let wire = coil.of(2.0).unwrap();
    let lengths = lengths(4);
    let points = points(&lengths, &lengths.iter().map(|&l| wire.inductance(l) + 2e-8).collect::<Vec<_>>());
    let known = |value| SteelFit::new(&coil, &points, Permeability::Known(value), &SteelDoubts::default());
    let fit = known(2.0).unwrap();
    assert!((fit.offset - 2e-8).abs() < 1e-15 && fit.permeability_u.is_none() && fit.rms < 1e-15);
    // A wrong one shows in what is left.
    assert!(known(4.0).unwrap().rms > 1e-8);
    for wrong in [0.5, 60.0, f64::NAN] {
        assert!(known(wrong).unwrap_err().to_string().contains("permeability must be 1 to 20"));
    }
}

#[test]
fn points_of_something_else_are_refused_in_a_line() {
    let wire = steel(NUMBERS, Leads::Open).of(2.0).unwrap();
    let lengths = lengths(3);
    let of = |change: &dyn Fn(f64) -> f64| {
        points(&lengths, &lengths.iter().map(|&l| change(wire.inductance(l))).collect::<Vec<_>>())
    };
    for (what, points) in [
        // Twice the slope: another coil; a slope that is turned; a tenth of it.
        ("more", of(&|henry| 4.0 * henry)),
        ("turned", of(&|henry| 2e-6 - henry)),
        ("less", of(&|henry| 0.5 * henry)),
    ] {
        let message = fit(&points).unwrap_err().to_string();
        assert!(message.contains("relative permeability of the fit must be 0.5 to 20"), "{what}: {message}");
        assert!(message.lines().count() == 1, "{message}");
    }
    let outside = points(&[0.02, 0.03], &[2e-6, 1.5e-6]);
    let message = fit(&outside).unwrap_err().to_string();
    assert!(message.contains("lengths[0] must be from 0.0259 to 0.042 m, the range of the coil"), "{message}");
    assert!(CalibrationPoints::new(&[0.03; 3], &[1e-6; 3]).unwrap_err().to_string().contains("range of the lengths"));
    let wrong = SteelDoubts { meter: -1e-9, ..SteelDoubts::default() };
    let points = of(&|henry| henry);
    let refused = SteelFit::new(&steel(NUMBERS, Leads::Open), &points, Permeability::Fitted, &wrong).unwrap_err();
    assert!(refused.to_string().contains("uncertainty of the meter must be zero or above"), "{refused}");
    // What it never has is not read.
    let fit = fit(&points).unwrap();
    let most = fit.inductance(RANGE[0]);
    assert!(fit.length(1.01 * most).unwrap_err().to_string().contains("inductance must be from"));
    assert!(fit.length_u(1.01 * most).is_nan());
}

#[test]
fn one_term_more_follows_magnetic_wire_between_its_points_only() {
    let wire = steel(NUMBERS, Leads::Open).of(2.5).unwrap();
    let lengths = lengths(10);
    let inductances: Vec<f64> = lengths.iter().map(|&length| wire.inductance(length)).collect();
    let pick = |rows: &[usize]| {
        let of = |values: &[f64]| rows.iter().map(|&row| values[row]).collect::<Vec<f64>>();
        points(&of(&lengths), &of(&inductances))
    };
    let all = points(&lengths, &inductances);
    let cubic = CubicFit::new(&pick(&[0, 5, 9])).unwrap();
    assert!(cubic.standard_errors.is_none() && cubic.length_u(inductances[3]).is_none());
    let share = |rmse: f64| rmse / all.range();
    let between = share(cubic.misfit(&all).unwrap().rmse);
    let ends = [lengths[0], lengths[9]];
    let line =
        coilsense::calibrate::InductanceFit::new(&all, coilsense::calibrate::FitMethod::first_and_last(&all)).unwrap();
    assert!(ends[1] > ends[0] && between < 0.2 * line.misfit.rmse_share_of_range, "{between}");
    let beyond = share(CubicFit::new(&pick(&[0, 1, 2])).unwrap().misfit(&all).unwrap().rmse);
    assert!(beyond > 3.0 * between, "{beyond} and {between}");
    // Its standard errors are those of noise.
    let mut random = Pcg64Mcg::seed_from_u64(7);
    let noisy: Vec<f64> = inductances
        .iter()
        .map(|henry| {
            let noise: f64 = StandardNormal.sample(&mut random);
            henry + 1e-9 * noise
        })
        .collect();
    let noisy = CubicFit::new(&points(&lengths, &noisy)).unwrap();
    assert!(noisy.degrees_of_freedom == 7 && noisy.length_u(inductances[4]).unwrap() > 1e-6);
    let moved = cubic.re_zeroed(lengths[2], inductances[2] + 1e-8);
    assert!((moved.inductance(lengths[7]) - cubic.inductance(lengths[7]) - 1e-8).abs() < 1e-9);
    for (refused, part) in [
        (CubicFit::new(&pick(&[0, 9])), "must hold at least 3 values, got 2"),
        (CubicFit::new(&points(&[0.03, 0.03, 0.04], &[1.2e-6, 1.21e-6, 1e-6])), "at least three lengths"),
        (CubicFit::new(&points(&[0.03, 0.035, 0.04], &[1e-6, 1.1e-6, 1.2e-6])), "so that L falls with length"),
    ] {
        let message = refused.unwrap_err().to_string();
        assert!(message.contains(part), "{message}");
    }
}

#[test]
fn a_permeability_that_was_told_is_doubted_too() {
    // Told as 2, as another spring had it; in truth 15 % more.
    let coil = steel(NUMBERS, Leads::Open);
    let wire = coil.of(2.3).unwrap();
    let lengths = lengths(7);
    let inductances: Vec<f64> = lengths.iter().map(|&length| wire.inductance(length)).collect();
    let points = points(&lengths, &inductances);
    let fit = |share: f64| {
        // Of nothing else.
        let doubts = SteelDoubts {
            meter: 0.0,
            windings: 0.0,
            coil_radius: 0.0,
            wire_diameter: 0.0,
            permeability: share,
            leads: Leads::Open,
            theory: 0.0,
        };
        SteelFit::new(&coil, &points, Permeability::Known(2.0), &doubts).unwrap()
    };
    let (doubted, trusted) = (fit(0.15), fit(0.0));
    for (&length, &henry) in lengths.iter().zip(&inductances) {
        let off = (doubted.length(henry).unwrap() - length).abs();
        // One standard uncertainty is what it is off by, to what L bends in μ_r.
        assert!(off < 1.2 * doubted.length_u(henry) + 1e-7, "{length}: {off}, {}", doubted.length_u(henry));
        assert!(trusted.length_u(henry) < 1e-9);
    }
    assert!(doubted.offset_u > 1e-9 && trusted.offset_u < 1e-12);
}

#[test]
fn a_lead_inside_the_coil_is_no_doubt() {
    let coil = steel(NUMBERS, Leads::Open);
    let wire = coil.of(2.0).unwrap();
    let lengths = lengths(3);
    let points = points(&lengths, &lengths.iter().map(|&l| wire.inductance(l)).collect::<Vec<_>>());
    let doubts = SteelDoubts { leads: Leads::Beside(5e-3), ..SteelDoubts::default() };
    let refused = SteelFit::new(&coil, &points, Permeability::Fitted, &doubts).unwrap_err().to_string();
    assert!(refused.contains("leads must be above the coil radius"), "{refused}");
}
