//! What rows hold: the numbers of `analyze` for the same design, whatever the chunk and the threads.

use coilsense_lab::analysis::Analysis;
use coilsense_lab::spec::Spec;
use coilsense_lab::sweep::{Catalogue, Plan, PlanParameters, Sampling};
use proptest::prelude::*;

use super::{QUICK, example, numbers, of, plan, texts, whole};

/// Both ways compute the same closed forms, over the window alone or from t = 0 on: 1e-12 of F_nom is what the motion's accuracy leaves.
const SAME: f64 = 1e-10; // in %

#[test]
fn a_row_holds_the_numbers_that_analyze_gives_for_its_design() {
    let columns = [
        "stiffness",
        "F_i.rmsd",
        "F_i.max",
        "F_o.rmsd",
        "F_o.bias",
        "F_o.rmsd[heel strike]",
        "F_x.rmsd",
        "worst",
        "F_o.worst",
        "laser.combined",
        "laser.lag",
        "laser.meets",
        "clearance",
    ];
    let over = ["spring.stiffness=650, 812.5 N/m", "condition.\"heel strike\".velocity=0.2 m/s"];
    let plan = plan(&over, &columns, None).unwrap();
    let chunk = &whole(&plan)[0];
    for (row, stiffness) in [650.0, 812.5].into_iter().enumerate() {
        let text = QUICK.replace("760 N/m", &format!("{stiffness} N/m")).replace("0.25 m/s", "0.2 m/s");
        let spec = Spec::parse("spec.toml", &text, &|name| Err(name.to_owned())).unwrap();
        let analysis = Analysis::run(spec, &|_, _| true).unwrap();
        let nominal = analysis.spec.spring.spring.nominal_force();
        let worst = |force: usize, of: fn(&coilsense::Deviation) -> f64| {
            let each = analysis.cases.iter().map(|case| of(&case.ideal[force].1));
            100.0 * each.max_by(|a, b| a.abs().total_cmp(&b.abs())).unwrap() / nominal
        };
        let expected = [
            ("F_i.rmsd [%]", worst(0, |d| d.rmsd)),
            ("F_i.max [%]", worst(0, |d| d.maximum_absolute)),
            ("F_o.rmsd [%]", worst(1, |d| d.rmsd)),
            ("F_o.bias [%]", worst(1, |d| d.mean)),
            ("F_o.rmsd[heel strike] [%]", 100.0 * analysis.cases[0].ideal[1].1.rmsd / nominal),
            ("F_x.rmsd [%]", 0.0),
            ("laser.combined [%]", 100.0 * analysis.verdicts[0].combined() / nominal),
            ("laser.lag [s]", analysis.verdicts[0].lag),
            ("stiffness [N/m]", stiffness),
            ("spring.stiffness [N/m]", stiffness),
            ("clearance [m]", analysis.cases.iter().map(|c| c.clash.clearance()).fold(f64::INFINITY, f64::min)),
        ];
        for (title, value) in expected {
            let found = numbers(chunk, title)[row];
            assert!((found - value).abs() <= SAME, "{title}: {found} and {value}");
        }
        assert_eq!(texts(chunk, "worst")[row], "resonance");
        assert_eq!(texts(chunk, "status")[row], "ok");
    }
}

/// The example itself: five conditions, the band of dampings, F_L by its second-order form where that is good to 1e-6 of L.
#[test]
fn force_by_inductance_is_that_of_analyze_within_its_stated_bound() {
    let text = example("sea-ankle.toml").replace("end2 = \"held\"", "end2 = \"held\"\ndamping_ratio = 0.005");
    let columns = ["F_L.rmsd", "F_L.bias", "F_L.method", "F_L.bound", "F_L.method[resonance]"];
    let plan = Plan::new(of(&text, &["spring.mass=65 g"], &columns)).unwrap();
    let chunk = &whole(&plan)[0];
    let spec = Spec::parse("spec.toml", &text, &|name| Err(name.to_owned())).unwrap();
    let analysis = Analysis::run(spec, &|_, _| true).unwrap();
    let nominal = analysis.spec.spring.spring.nominal_force();
    let rmsd = analysis.cases.iter().map(|case| case.ideal[3].1.rmsd).fold(0.0, f64::max);
    let found = numbers(chunk, "F_L.rmsd [%]")[0];
    // 1e-6 of L is 1.5e-6 of F_nom (0.1 % of L is 0.15 % of it).
    assert!((found - 100.0 * rmsd / nominal).abs() < 1.5e-4, "{found}");
    assert!(numbers(chunk, "F_L.bound [1]")[0] <= 1e-6);
    assert!(["second-order", "exact", "mixed"].contains(&texts(chunk, "F_L.method")[0].as_str()));
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(12))]
    /// The same row comes out of any chunk, on any number of threads.
    #[test]
    fn a_row_does_not_depend_on_its_chunk_nor_on_threads(chunk in 1u64..40, jobs in 1usize..4, seed in 0u64..1000, which in 0usize..3) {
        let sampling = [Sampling::Lhs, Sampling::MonteCarlo, Sampling::Sobol][which];
        let over = ["spring.stiffness=normal(760 N/m, 5 %)", "mount.damping_ratio=log 1e-4..1e-1", "spring.mass=50, 65 g"];
        let parameters = PlanParameters { rows: Some(40), seed, sampling: Some(sampling), ..of(QUICK, &over, &["F_o.rmsd", "worst"]) };
        let one = Plan::new(PlanParameters { chunk_rows: Some(40), ..parameters.clone() }).unwrap();
        let many = Plan::new(PlanParameters { chunk_rows: Some(chunk), ..parameters }).unwrap();
        let pool = rayon::ThreadPoolBuilder::new().num_threads(jobs).build().unwrap();
        let (one, many) = (whole(&one), pool.install(|| whole(&many)));
        for title in ["spring.stiffness [N/m]", "mount.damping_ratio [1]", "spring.mass [kg]", "F_o.rmsd [%]"] {
            let apart: Vec<u64> = many.iter().flat_map(|chunk| numbers(chunk, title)).map(f64::to_bits).collect();
            let together: Vec<u64> = numbers(&one[0], title).into_iter().map(f64::to_bits).collect();
            prop_assert_eq!(apart, together);
        }
    }
}

#[test]
fn a_plan_as_text_makes_the_same_rows() {
    let plan = plan(&["spring.mass=50..80 g"], &[], Some(10)).unwrap();
    let again = Plan::from_json(&plan.to_json()).unwrap();
    assert_eq!((again.digest(), whole(&again)), (plan.digest(), whole(&plan)));
}

#[test]
fn a_catalogue_meets_every_row_of_the_sampling_and_carries_its_own_columns() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("springs.csv");
    let table =
        "article,price,spring.name,spring.stiffness [N/mm],spring.mass\nA-1,3.5,soft,0.6,60 g\nB-2,4,hard,0.9,70 g\n";
    std::fs::write(&path, table).unwrap();
    let parameters = PlanParameters {
        catalogue: Some(Catalogue::read(&path).unwrap()),
        ..of(QUICK, &["spring.windings=10..12 : 3"], &["stiffness", "mass"])
    };
    let chunk = &whole(&Plan::new(parameters).unwrap())[0];
    assert_eq!(texts(chunk, "article"), ["A-1", "A-1", "A-1", "B-2", "B-2", "B-2"]);
    assert_eq!(numbers(chunk, "price"), [3.5, 3.5, 3.5, 4.0, 4.0, 4.0]);
    assert_eq!(texts(chunk, "spring.name")[3], "hard");
    assert_eq!(numbers(chunk, "spring.windings [1]"), [10.0, 11.0, 12.0, 10.0, 11.0, 12.0]);
    assert_eq!(numbers(chunk, "stiffness [N/m]")[..4], [600.0, 600.0, 600.0, 900.0]);
    assert_eq!(numbers(chunk, "mass [kg]")[..4], [0.06, 0.06, 0.06, 0.07]);
}

#[test]
fn an_impossible_design_is_a_row_with_its_reason() {
    let plan = plan(&["spring.wire_radius=1, 9 mm", "spring.mass=-1, 65 g"], &["F_o.rmsd", "mass"], None).unwrap();
    let chunk = &whole(&plan)[0];
    assert_eq!(texts(chunk, "status"), ["refused", "ok", "refused", "refused"]);
    let reasons = texts(chunk, "reason");
    assert_eq!(reasons[0], "spec.toml:8: mass = \"-1 g\": mass must be above zero and finite, got -0.001 kg");
    assert!(reasons[1].is_empty() && reasons[3].contains("wire_radius = \"9 mm\""), "{}", reasons[3]);
    let rmsd = numbers(chunk, "F_o.rmsd [%]");
    assert!(rmsd[0].is_nan() && rmsd[1] > 0.0 && rmsd[3].is_nan());
    assert_eq!(numbers(chunk, "spring.mass [kg]"), [-0.001, 0.065, -0.001, 0.065]);
}

#[test]
fn windings_that_touch_are_a_row_with_where_and_when() {
    let plan = plan(&["condition.resonance.amplitude=0.1, 8 %"], &["F_o.rmsd"], None).unwrap();
    let chunk = &whole(&plan)[0];
    assert_eq!(texts(chunk, "status"), ["ok", "clash"]);
    let reason = &texts(chunk, "reason")[1];
    assert!(reason.starts_with("windings touch in resonance at 0."), "{reason}");
    assert!(numbers(chunk, "F_o.rmsd [%]")[1] > 0.0);
}

#[test]
fn columns_of_other_modes_follow_ends_and_lengths() {
    let of = |mount: &str, over: &str| {
        let text = QUICK.replace("[mount]\n", &format!("[mount]\n{mount}\n")).replace("windings = 12", "windings = 52");
        let columns = ["f_lateral", "f_torsional", "buckling"];
        let plan = Plan::new(of(&text, &[over], &columns)).unwrap();
        let chunk = &whole(&plan)[0];
        columns.map(|column| {
            let unit = if column == "buckling" { "1" } else { "Hz" };
            numbers(chunk, &format!("{column} [{unit}]"))
        })
    };
    let over = "spring.mass=65, 260 g";
    let ([pinned, ..], [clamped, torsional, buckling]) = (of("", over), of("ends_tilt = \"held\"", over));
    // S_T at 196 mm by the column: 37.5 and 42.2 Hz, torsion 60.6 Hz; all fall with the root of the mass.
    assert!((pinned[0] - 37.5).abs() < 0.2 && (clamped[0] - 42.2).abs() < 0.2, "{pinned:?} {clamped:?}");
    assert!((torsional[0] - 60.7).abs() < 0.3 && buckling == [0.0, 0.0], "{torsional:?} {buckling:?}");
    for column in [pinned, clamped, torsional] {
        assert!((column[0] / column[1] - 2.0).abs() < 1e-6, "{column:?}");
    }
}
