//! What a sweep says of sensors is what `analyze` says, to rounding, whichever of them are asked for; recorded files are shared by all rows.

use coilsense_lab::analysis::{Analysis, Verdict};
use coilsense_lab::spec::Spec;
use coilsense_lab::sweep::{Plan, PlanParameters};

use super::{QUICK, numbers, of, texts, whole};

/// A sensor of every kind, two of them late, one out of reach of the wanted bandwidth; two dampings and a recorded motion.
const WATCHED: &str = r#"
[[condition]]
name = "shaken"
kind = "recorded"
file = "motion.csv"
window = ["0.05 s", "0.1 s"]

[[sensor]]
name = "cell 1"
kind = "load-cell"
end = 1
bandwidth = "1 kHz"
delay = "1 ms"

[[sensor]]
name = "cell 2"
kind = "load-cell"
noise = "0.1 %"
averaging = "5 ms"

[[sensor]]
name = "encoders"
kind = "two-encoder"
compliance = "2 um/N"
backlash = "20 um"

[[sensor]]
name = "coil"
kind = "inductance"
sample_rate = "500 Hz"
"#;

const SENSORS: [&str; 5] = ["laser", "cell 1", "cell 2", "encoders", "coil"];

fn spec() -> String {
    let damped = QUICK.replace("damping_ratio = 0", "damping_ratio = [0, 0.02]");
    damped.replace("error = \"1 %\"", "error = \"1 %\"\nbandwidth = \"150 Hz\"") + WATCHED
}

/// End 1 to and fro, a millimetre at 20 Hz.
fn motion(name: &str) -> Result<String, String> {
    let row = |n: u32| format!("{},{}\n", f64::from(n) / 1000.0, (0.04 * std::f64::consts::PI * f64::from(n)).sin());
    match name {
        "motion.csv" => Ok("time [s],u1 [mm]\n".to_owned() + &(0..150).map(row).collect::<String>()),
        _ => Err(format!("{name} is not there")),
    }
}

fn plan(over: &[&str], columns: &[&str], rows: u64) -> Plan {
    let parameters = PlanParameters { rows: Some(rows), ..of("", over, columns) };
    Plan::new(parameters.with_text("spec.toml", &spec(), &motion).unwrap()).unwrap()
}

#[test]
fn every_sensor_is_judged_as_the_analysis_judges_it() {
    let over = ["spring.stiffness=600..900 N/m", "spring.mass=50..80 g", "sensor.laser.delay=0..1 ms"];
    let asked: Vec<String> =
        SENSORS.iter().flat_map(|name| ["combined", "lag", "meets"].map(|of| format!("{name}.{of}"))).collect();
    let asked: Vec<&str> = asked.iter().map(String::as_str).collect();
    let together = plan(&over, &asked, 3);
    let chunk = &whole(&together)[0];
    assert_eq!(texts(chunk, "status"), ["ok", "ok", "ok"], "{:?}", texts(chunk, "reason"));
    for row in 0..3 {
        let spec = Spec::parse("row.toml", &together.spec_of(row as u64).unwrap(), &motion).unwrap();
        let analysis = Analysis::run(spec, &|_, _| true).unwrap();
        let nominal = analysis.spec.spring.spring.nominal_force();
        for (index, name) in SENSORS.iter().enumerate() {
            let verdict: &Verdict = analysis.verdicts.iter().find(|verdict| verdict.sensor == index).unwrap();
            let combined = 100.0 * verdict.combined() / nominal;
            let found = numbers(chunk, &format!("{name}.combined [%]"))[row];
            assert!((found / combined - 1.0).abs() < 1e-9, "{name} of row {row}: {found} and {combined}");
            assert_eq!(numbers(chunk, &format!("{name}.lag [s]"))[row], verdict.lag, "{name} of row {row}");
            let meets = chunk.columns.iter().find(|(title, _)| *title == format!("{name}.meets")).unwrap();
            let coilsense_lab::sweep::Data::Flags(meets) = &meets.1 else { panic!("flags") };
            assert_eq!(meets[row], verdict.meets_always(), "{name} of row {row}");
        }
    }
    // What one sensor is found to do does not hang on which others are asked for.
    for name in SENSORS {
        let title = format!("{name}.combined");
        let alone = &whole(&plan(&over, &[&title], 3))[0];
        let title = format!("{title} [%]");
        for (alone, together) in numbers(alone, &title).iter().zip(numbers(chunk, &title)) {
            assert!((alone / together - 1.0).abs() < 1e-9, "{name}: {alone} and {together}");
        }
    }
}

#[test]
fn a_recorded_motion_is_each_rows_own_though_it_is_read_once() {
    let over = ["condition.shaken.length=200, 215, 230 mm", "spring.mass=65 g"];
    let plan = plan(&over, &["F_o.rmsd[shaken]", "F_o.max[shaken]"], 3);
    let chunk = &whole(&plan)[0];
    for row in 0..3 {
        let spec = Spec::parse("row.toml", &plan.spec_of(row as u64).unwrap(), &motion).unwrap();
        let analysis = Analysis::run(spec, &|_, _| true).unwrap();
        let nominal = analysis.spec.spring.spring.nominal_force();
        let shaken = analysis.cases.iter().filter(|case| case.condition == 2);
        let rmsd = shaken.map(|case| 100.0 * case.ideal[1].1.rmsd / nominal).fold(0.0, f64::max);
        let found = numbers(chunk, "F_o.rmsd[shaken] [%]")[row];
        assert!(rmsd > 0.1 && (found - rmsd).abs() < 1e-9, "{found} and {rmsd}");
    }
    // A file that is not there is a row's reason, as ever.
    let parameters = of("", &["condition.shaken.file=\"motion.csv\", \"broken.csv\""], &["F_o.rmsd[shaken]"]);
    let broken = |name: &str| match name {
        "broken.csv" => Ok("time [s],u1 [mm]\n0,0\n0.1,x\n".to_owned()),
        _ => motion(name),
    };
    let plan = Plan::new(parameters.with_text("spec.toml", &spec(), &broken).unwrap()).unwrap();
    let chunk = &whole(&plan)[0];
    assert_eq!(texts(chunk, "status"), ["ok", "refused"]);
    let reason = &texts(chunk, "reason")[1];
    assert!(reason.contains("broken.csv") && reason.contains("line 3, column 2: \"x\" must be a number"), "{reason}");
}

#[test]
fn magnetic_wire_is_noted_where_forces_by_inductance_are_asked_for_and_nowhere_else() {
    let note = |wire: &str, over: &str, column: &str| {
        let text = spec().replacen("[spring]", &format!("[spring]\n{wire}"), 1);
        let parameters = PlanParameters { rows: Some(2), ..of("", &[over], &[column]) };
        Plan::new(parameters.with_text("spec.toml", &text, &motion).unwrap()).unwrap().note()
    };
    let (wire, mass) = ("relative_permeability = 2.5", "spring.mass=50..80 g");
    for column in ["F_L.rmsd", "coil.combined"] {
        let told = note(wire, mass, column).unwrap();
        assert!(told.contains("non-magnetic wire") && told.contains("analyze"), "{told}");
        assert_eq!(note("", mass, column), None);
        assert_eq!(note("relative_permeability = 1", mass, column), None);
        assert!(note("", "spring.relative_permeability=1..3", column).is_some());
    }
    for column in ["laser.combined", "F_o.rmsd", "mass"] {
        assert_eq!(note(wire, mass, column), None, "{column}");
    }
}
