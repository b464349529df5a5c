//! Two measured runs of real springs beside what their authors made of them.
//!
//! The runs carry no licence and are not part of this project: they are read from the folder in `COILSENSE_LAB_DATA`, else from
//! `lab-data` in `shared` beside the project's folder. Without them the tests are ignored. Expected figures are the authors'.

use std::path::PathBuf;

use coilsense::calibrate::{
    CalibrationPoints, FitMethod, InductanceFit, InverseLengthFit, Inversion, Misfit, Permeability, SteelDoubts,
    SteelFit,
};
use coilsense::inductance::theories::{
    Coil, HelixSelf, ReturnPath, Theory, helix, ideal_solenoid, nagaoka, nagaoka_rosa,
};
use coilsense::inductance::{Leads, MU_0, SteelCoil};

/// A run: its coil, and what its authors print.
struct Run {
    name: &'static str,
    coil: Coil,
    zero_length: f64,
    /// α \[µH m\] and β \[µH\] of L = α/l + β through the first and the last point used.
    fit: [f64; 2],
    /// R² and RMSE in percent of the range.
    printed: [(&'static str, f64, f64); 6],
}

fn runs() -> [Run; 2] {
    [
        Run {
            name: "S1_01",
            coil: Coil::new(41.90425531914894, 8.47e-3, 1.41e-3).unwrap(),
            zero_length: 118.17e-3,
            fit: [0.4635405915777, 0.0953103266667],
            printed: [
                ("fit", 0.99825, 1.339),
                ("ideal", 0.82872, 12.593),
                ("Nagaoka", 0.99720, 1.426),
                ("Rosa", 0.21587, 30.182),
                ("Maxwell", 0.29390, 28.379),
                ("Neumann", 0.79317, 14.699),
            ],
        },
        Run {
            name: "S2_01",
            coil: Coil::new(38.76377952755905, 12.545e-3, 1.27e-3).unwrap(),
            zero_length: 98.46e-3,
            fit: [0.8592920030142, 0.4629404933333],
            printed: [
                ("fit", 0.99923, 0.876),
                ("ideal", 0.95334, 5.753),
                ("Nagaoka", 0.65322, 19.220),
                ("Rosa", -0.41432, 41.377),
                ("Maxwell", -0.09690, 35.346),
                ("Neumann", 0.18199, 30.355),
            ],
        },
    ]
}

/// Where the runs are, if anywhere.
fn folder() -> PathBuf {
    let named = std::env::var_os("COILSENSE_LAB_DATA").map(PathBuf::from);
    let folder = named.unwrap_or_else(|| PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../../../shared/lab-data"));
    assert!(folder.join("S1_01.csv").is_file(), "no measured runs in {}; set COILSENSE_LAB_DATA", folder.display());
    folder
}

/// Lengths and mean inductances of a run but its first row, which is at zero displacement.
fn points(folder: &std::path::Path, run: &Run) -> CalibrationPoints {
    let path = folder.join(format!("{}.csv", run.name));
    let mut reader =
        csv::ReaderBuilder::new().delimiter(b';').has_headers(false).trim(csv::Trim::All).from_path(&path).unwrap();
    let rows: Vec<Vec<f64>> =
        reader.records().map(|row| row.unwrap().iter().map(|text| text.parse().unwrap()).collect()).collect();
    assert!(rows.iter().all(|row| row.len() == 24), "{}", path.display());
    let lengths: Vec<f64> = rows[1..].iter().map(|row| run.zero_length + 1e-3 * row[3]).collect();
    let mean = |row: &Vec<f64>| row[5..].iter().step_by(2).sum::<f64>() / 10.0;
    let inductances: Vec<f64> = rows[1..].iter().map(mean).collect();
    CalibrationPoints::new(&lengths, &inductances).unwrap()
}

impl Run {
    /// Asserts that a misfit is what the authors print, to all their digits.
    fn assert_printed(&self, name: &str, misfit: &Misfit) {
        let row = self.printed.iter().find(|row| row.0 == name).unwrap();
        let percent = 100.0 * misfit.rmse_share_of_range;
        println!("{} {name}: {:.5} / {percent:.3} %, printed {} / {} %", self.name, misfit.r2, row.1, row.2);
        assert!((misfit.r2 - row.1).abs() <= 0.5001e-5, "{} {name}: R² {}", self.name, misfit.r2);
        assert!((percent - row.2).abs() <= 0.5001e-3, "{} {name}: {percent} %", self.name);
    }

    fn authors(&self, points: &CalibrationPoints, relation: impl Fn(f64) -> f64) -> Misfit {
        Inversion::TwentyFiveLengths { zero_length: self.zero_length }.judge(points, relation).unwrap()
    }
}

#[test]
#[ignore = "needs the measured runs, which carry no licence: COILSENSE_LAB_DATA"]
fn the_fits_of_the_measured_runs_are_their_authors() {
    let folder = folder();
    for run in runs() {
        let points = points(&folder, &run);
        let fit = InductanceFit::new(&points, FitMethod::first_and_last(&points)).unwrap();
        // The figures carry thirteen digits.
        assert!((1e6 * fit.alpha / run.fit[0] - 1.0).abs() < 1e-9, "{}", fit.alpha);
        assert!((1e6 * fit.beta / run.fit[1] - 1.0).abs() < 1e-9, "{}", fit.beta);
        assert!(fit.alpha_se.is_none() && fit.degrees_of_freedom == 0);
        run.assert_printed("fit", &fit.misfit);
        // Eq. (13) through two points is the same curve.
        let same = InverseLengthFit::new(&points, FitMethod::first_and_last(&points)).unwrap();
        assert!((same.alpha * fit.alpha - 1.0).abs() < 1e-12 && (same.beta + fit.beta / fit.alpha).abs() < 1e-10);
        assert!((same.misfit.rmse / fit.misfit.rmse - 1.0).abs() < 1e-9);
        // All points leave less than two of them do.
        for method in [
            FitMethod::AllPoints,
            FitMethod::Through { length: points.lengths()[4], inductance: points.inductances()[4] },
        ] {
            let one = InverseLengthFit::new(&points, method).unwrap();
            let other = InductanceFit::new(&points, method).unwrap();
            for (name, misfit) in [("eq. 13", &one.misfit), ("L over 1/l", &other.misfit)] {
                println!(
                    "{} {name} {method:?}: {:.5} / {:.3} %",
                    run.name,
                    misfit.r2,
                    100.0 * misfit.rmse_share_of_range
                );
                assert!(misfit.rmse < fit.misfit.rmse);
            }
            assert!(one.alpha_se.unwrap() < 0.03 * one.alpha && other.alpha_se.unwrap() < 0.03 * other.alpha);
        }
    }
}

#[test]
#[ignore = "needs the measured runs, which carry no licence: COILSENSE_LAB_DATA"]
fn the_theories_beside_the_measured_runs_are_as_far_off_as_their_authors_say() {
    let folder = folder();
    for run in runs() {
        let points = points(&folder, &run);
        for (name, theory) in
            [("ideal", Theory::IdealSolenoid), ("Nagaoka", Theory::Nagaoka), ("Maxwell", Theory::MaxwellSum)]
        {
            run.assert_printed(name, &run.authors(&points, |l| theory.inductance(&run.coil, l)));
        }
    }
}

/// Nagaoka's coefficient with K and E where the arithmetic–geometric mean has not made a step: K = π/2, K − E = ½ K (k² + ½ (1 − k')²).
fn nagaoka_without_a_step(coil: &Coil, length: f64) -> f64 {
    let ratio = length / (2.0 * coil.coil_radius());
    let diagonal = ratio.hypot(1.0);
    let (k, kc) = (1.0 / diagonal, ratio / diagonal);
    let big_k = std::f64::consts::FRAC_PI_2;
    let difference = 0.5 * big_k * (k * k + 0.5 * (1.0 - kc) * (1.0 - kc));
    let bracket = kc * kc / (k * k) * difference + big_k - difference - k;
    4.0 / (3.0 * std::f64::consts::PI * kc) * bracket * ideal_solenoid(coil, length)
}

#[test]
#[ignore = "needs the measured runs, which carry no licence: COILSENSE_LAB_DATA"]
fn on_the_measured_runs_rosas_theory_differs_from_the_authors_by_an_elliptic_integral_that_never_iterates() {
    let folder = folder();
    // Ours, R² and RMSE in percent, where the authors print 0.21587 / 30.182 and −0.41432 / 41.377.
    let ours = [(0.27319, 28.844), (-0.17950, 36.777)];
    for (run, (r2, percent)) in runs().into_iter().zip(ours) {
        let points = points(&folder, &run);
        let misfit = run.authors(&points, |l| nagaoka_rosa(&run.coil, l));
        assert!((misfit.r2 - r2).abs() < 1e-5, "{}: {}", run.name, misfit.r2);
        assert!((100.0 * misfit.rmse_share_of_range - percent).abs() < 1e-3, "{}: {misfit:?}", run.name);
        // Their Rosa takes K and E from a loop of its own, whose condition compares a variable with itself at the start: it never runs.
        // With that Nagaoka and the same corrections their figures come out to the last digit.
        let correction = |l: f64| nagaoka_rosa(&run.coil, l) - nagaoka(&run.coil, l);
        let theirs = |l: f64| nagaoka_without_a_step(&run.coil, l) + correction(l);
        run.assert_printed("Rosa", &run.authors(&points, theirs));
        // It costs 0.4 and 1 % of L.
        let off = nagaoka_without_a_step(&run.coil, 0.13) / nagaoka(&run.coil, 0.13) - 1.0;
        println!("{} Nagaoka without a step: {off:e}", run.name);
        assert!((-0.011..-0.003).contains(&off));
    }
}

#[test]
#[ignore = "needs the measured runs, which carry no licence: COILSENSE_LAB_DATA"]
fn on_the_measured_runs_neumanns_helix_differs_from_the_authors_by_where_the_second_filament_lies() {
    let folder = folder();
    // Ours: 0.55968 / 22.566 and −0.06152 / 35.183, asserted below.
    for run in runs() {
        let points = points(&folder, &run);
        // Their filament beside the axis reproduces theirs: their quadrature (512 panels an octave) is not what differs.
        let beside = |l: f64| helix(&run.coil, l, HelixSelf::ParallelFilament, ReturnPath::Open);
        run.assert_printed("Neumann", &run.authors(&points, beside));
        // Such a filament is also g nearer to the turns on one side and g farther from those on the other, which turns of round wire are
        // not: Σ_j −ln(1 − (g/jp)²) = −ln(sin(πx)/πx), x = g/p, per turn, but for the turns that the coil's ends leave out.
        let x =
            std::f64::consts::PI * run.coil.wire_radius() * (-0.25_f64).exp() * run.coil.windings() / run.zero_length;
        let nearer = -(x.sin() / x).ln() * MU_0 * run.coil.coil_radius() * run.coil.windings();
        let difference = beside(run.zero_length) - Theory::NeumannHelix.inductance(&run.coil, run.zero_length);
        println!("{}: {difference:e} H of filaments, {nearer:e} H by nearer turns", run.name);
        assert!((0.93..1.0).contains(&(difference / nearer)));
    }
}

#[test]
#[ignore = "needs the measured runs, which carry no licence: COILSENSE_LAB_DATA"]
fn on_the_measured_runs_the_theories_that_the_authors_do_not_have_are_as_far_off_as_we_say() {
    let folder = folder();
    // R² and RMSE in percent on both runs, by the authors' inversion.
    let ours = [
        (Theory::Lundin, [(0.99720, 1.426), (0.65320, 19.221)]),
        (Theory::Wheeler1928, [(0.99157, 2.710), (0.59231, 20.889)]),
        (Theory::Wheeler1982, [(0.99748, 1.343), (0.66029, 19.015)]),
        (Theory::NeumannHelix, [(0.55968, 22.566), (-0.06152, 35.183)]),
        (Theory::NeumannHelixReturn, [(0.49369, 24.187), (-0.03851, 34.776)]),
    ];
    for (theory, expected) in ours {
        for (run, (r2, percent)) in runs().into_iter().zip(expected) {
            let misfit = run.authors(&points(&folder, &run), |l| theory.inductance(&run.coil, l));
            assert!((misfit.r2 - r2).abs() <= 0.5001e-5, "{} {}: {}", run.name, theory.name(), misfit.r2);
            assert!(
                (100.0 * misfit.rmse_share_of_range - percent).abs() <= 0.5001e-3,
                "{} {}",
                run.name,
                theory.name()
            );
        }
    }
}

#[test]
#[ignore = "needs the measured runs, which carry no licence: COILSENSE_LAB_DATA"]
fn on_the_measured_runs_the_authors_straight_lines_between_25_lengths_cost_less_than_half_a_percent() {
    let folder = folder();
    for run in runs() {
        let points = points(&folder, &run);
        for theory in Theory::ALL {
            let relation = |l: f64| theory.inductance(&run.coil, l);
            let (theirs, exact) = (run.authors(&points, relation), Inversion::Exact.judge(&points, relation).unwrap());
            let [theirs, exact] = [theirs, exact].map(|misfit| 100.0 * misfit.rmse_share_of_range);
            println!("{} {}: {theirs:.3} %, exactly {exact:.3} %", run.name, theory.name());
            // Inside of the 25 they cost 0.02; the rest is prolonged lines.
            assert!((theirs - exact).abs() < 0.4);
        }
    }
}

/// Which rows calibrate of ten, spread from the first to the last.
fn spread(points: &CalibrationPoints, count: usize) -> (CalibrationPoints, CalibrationPoints) {
    let all = points.lengths().len();
    let taken: Vec<usize> =
        (0..count).map(|index| (index as f64 * (all - 1) as f64 / (count - 1) as f64).round() as usize).collect();
    let pick = |keep: &dyn Fn(usize) -> bool| {
        let of =
            |values: &[f64]| -> Vec<f64> { (0..all).filter(|&index| keep(index)).map(|index| values[index]).collect() };
        CalibrationPoints::new(&of(points.lengths()), &of(points.inductances())).unwrap()
    };
    (pick(&|index| taken.contains(&index)), pick(&|index| !taken.contains(&index)))
}

/// The run's coil over the lengths of its points and a margin.
fn steel(run: &Run, points: &CalibrationPoints, leads: Leads) -> SteelCoil {
    let lengths = points.lengths();
    let least = 1.04 * 2.0 * run.coil.wire_radius() * run.coil.windings();
    let shortest = lengths.iter().copied().fold(f64::INFINITY, f64::min) - 0.05 * points.range();
    let longest = lengths.iter().copied().fold(0.0, f64::max) + 0.05 * points.range();
    SteelCoil::new(&run.coil, run.zero_length, leads, [shortest.max(least), longest]).unwrap()
}

#[test]
#[ignore = "needs the measured runs, which carry no licence: COILSENSE_LAB_DATA"]
fn the_wire_of_the_measured_springs_is_magnetic() {
    let folder = folder();
    for (run, (permeability, within), nanohenry) in [(&runs()[0], (2.08, 0.03), 2.5), (&runs()[1], (2.75, 0.04), 5.5)] {
        let points = points(&folder, run);
        let fit = |coil: &SteelCoil, points: &CalibrationPoints| {
            SteelFit::new(coil, points, Permeability::Fitted, &SteelDoubts::default()).unwrap()
        };
        let open = steel(run, &points, Leads::Open);
        let of_all = fit(&open, &points);
        println!("{}: {} ± {:?}, {} nH left", run.name, of_all.permeability, of_all.permeability_u, 1e9 * of_all.rms);
        assert!((of_all.permeability - permeability).abs() < within && 1e9 * of_all.rms < nanohenry);
        assert!(of_all.is_magnetic());
        // The current's way back tells where the rest is: 5 cm off fits both better.
        let beside = steel(run, &points, Leads::Beside(0.05));
        assert!(fit(&beside, &points).rms < of_all.rms);
        for coil in [open, beside] {
            for count in [2, 3, 4] {
                let (taken, others) = spread(&points, count);
                let fit = fit(&coil, &taken);
                let misfit = fit.misfit(&others).unwrap();
                let mut halves: Vec<f64> =
                    others.inductances().iter().map(|&henry| 1.96 * fit.length_u(henry)).collect();
                let inside = misfit.residuals.iter().zip(&halves).filter(|(rest, half)| rest.abs() <= **half).count();
                halves.sort_by(f64::total_cmp);
                let percent = |length: f64| 100.0 * length / points.range();
                let (rms, half) = (percent(misfit.rmse), percent(halves[halves.len() / 2]));
                println!(
                    "{} points: {rms:.3} % of the range, {inside} of {} inside ± {half:.3} %",
                    count,
                    halves.len()
                );
                assert!(rms <= 0.45 && half <= 1.0 && inside as f64 >= 0.9 * halves.len() as f64);
                // Eq. (13) from the same points is further off.
                if count == 2 {
                    let line = InductanceFit::new(&taken, FitMethod::first_and_last(&taken)).unwrap();
                    let read: Vec<f64> = others.inductances().iter().map(|&l| line.calibration().length(l)).collect();
                    let squares = read.iter().zip(others.lengths()).map(|(read, length)| (read - length).powi(2));
                    assert!(percent((squares.sum::<f64>() / 8.0).sqrt()) > 2.0 * rms);
                }
            }
        }
    }
}
