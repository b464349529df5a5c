//! What cannot be swept is said in one line, before anything is computed.

use coilsense_lab::sweep::{Plan, PlanParameters, Sampling};

use super::{QUICK, of, plan};

/// What is written, and a part of what is said.
const WRONG: [(&str, &str); 29] = [
    ("spring.stiffness", "KEY=VALUES"),
    ("stiffness=1..2 N/m", "did you mean spring.stiffness"),
    ("spring.stifness=1..2 N/m", "did you mean spring.stiffness"),
    ("sping.stiffness=1..2 N/m", "did you mean spring.stiffness"),
    ("mount.damping=1..2", "did you mean mount.damping_ratio"),
    ("condition.velocity=1..2 m/s", "condition.\"heel strike\".velocity"),
    ("condition.\"heel\".velocity=1..2 m/s", "there are: 1 \"heel strike\", 2 \"resonance\""),
    ("condition.3.velocity=1..2 m/s", "no condition \"3\""),
    ("condition.1.window=1..2 s", "takes a list"),
    ("sensor.lidar.delay=1..2 ms", "no sensor \"lidar\""),
    ("spring.1.mass=1..2 g", "write spring.mass"),
    ("spring.stiffness=", "no values"),
    ("spring.stiffness=1..2", "unit is missing; must be a stiffness"),
    ("spring.stiffness=1..2 mm", "must be a stiffness"),
    ("spring.stiffness=2..1 N/m", "must rise"),
    ("spring.stiffness=1..2 N/m : 1", "from 2 to 1000000"),
    ("spring.stiffness=1..2 N/m : many", "number of points"),
    ("spring.stiffness=1, 2 N/m : 3", "a list has its own points"),
    ("spring.stiffness=1, two N/m", "\"two N/m\" is no number"),
    ("spring.stiffness=log -1..2 N/m", "above zero"),
    ("spring.stiffness=normal(760 N/m)", "takes 2 numbers"),
    ("spring.stiffness=normal(760 N/m, 0 %)", "above zero"),
    ("spring.stiffness=cauchy(1, 2 N/m)", "no distribution"),
    ("spring.stiffness=inf, 2 N/m", "no number"),
    ("spring.windings=10..12 mm", "without a unit"),
    ("spring.windings=\"ten\"", "without quotes"),
    ("spring.material=steel", "in quotes"),
    ("spring.material=\"steel", "not closed"),
    ("spring.stiffness=600..700 N/m : 3 : 4", "must be a stiffness"),
];

#[test]
fn a_malformed_variable_is_one_clear_line() {
    for (over, said) in WRONG {
        let error = plan(&[over], &["mass"], Some(3)).map(|_| over).unwrap_err().to_string();
        assert!(error.contains(said) && !error.contains('\n'), "{over}: {error}");
        let key = over.split('=').next().unwrap_or(over);
        assert!(
            error.contains(key) || error.contains("no sensor") || error.contains("no condition"),
            "{over}: {error}"
        );
    }
}

#[test]
fn a_plan_that_decides_nothing_is_refused() {
    let refused = |parameters: PlanParameters, said: &str| {
        let error = Plan::new(parameters).unwrap_err().to_string();
        assert!(error.contains(said) && !error.contains('\n'), "{error}");
    };
    let mass = ["spring.mass=50..80 g"];
    refused(of(QUICK, &[], &[]), "nothing is varied");
    refused(of(QUICK, &mass, &[]), "--rows");
    refused(PlanParameters { sampling: Some(Sampling::Grid), ..of(QUICK, &mass, &[]) }, "a grid needs");
    refused(PlanParameters { rows: Some(0), ..of(QUICK, &mass, &[]) }, "at least 1");
    refused(PlanParameters { rows: Some(u64::MAX), ..of(QUICK, &mass, &[]) }, "at most 1000000000");
    refused(PlanParameters { chunk_rows: Some(0), rows: Some(1), ..of(QUICK, &mass, &[]) }, "a chunk must have");
    let twice = ["spring.mass=50..80 g", "spring.mass=1, 2 g"];
    refused(PlanParameters { rows: Some(3), ..of(QUICK, &twice, &[]) }, "spring.mass: is varied twice");
    let huge = ["spring.mass=1..2 g : 1000000", "spring.stiffness=1..2 N/m : 1000000"];
    refused(of(QUICK, &huge, &[]), "more than 1000000000 rows");
    for (column, said) in [
        ("F_o.rms", "did you mean F_o.rmsd"),
        ("F_o.rmsd[heel]", "no condition \"heel\""),
        ("lidar.lag", "no sensor \"lidar\""),
        ("mass[resonance]", "only forces"),
        ("F_i.method", "is not known"),
    ] {
        refused(PlanParameters { rows: Some(3), ..of(QUICK, &mass, &[column]) }, said);
    }
    refused(PlanParameters { rows: Some(3), ..of(QUICK, &mass, &["mass", "mass"]) }, "two columns are called");
    // The spec's own fault, where no row mends it.
    let broken = QUICK.replace("\"8 mm\"", "\"8 g\"");
    refused(PlanParameters { rows: Some(3), ..of(&broken, &mass, &[]) }, "spec.toml:6: coil_radius");
    let unknown = QUICK.replace("coil_radius", "coil_radios");
    refused(PlanParameters { rows: Some(3), ..of(&unknown, &mass, &[]) }, "did you mean \"coil_radius\"");
}

#[test]
fn a_key_that_the_spec_leaves_out_can_be_swept() {
    let text = QUICK.replace("stiffness = \"760 N/m\"\n", "").replace("[mount]\ndamping_ratio = 0\n", "");
    let over = ["spring.stiffness=700, 800 N/m", "mount.damping_ratio=0.01"];
    let plan = Plan::new(of(&text, &over, &["stiffness"])).unwrap();
    let chunk = &super::whole(&plan)[0];
    assert_eq!(super::numbers(chunk, "stiffness [N/m]"), [700.0, 800.0]);
}
