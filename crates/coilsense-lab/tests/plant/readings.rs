//! What a spec's sensors read of a plant as it is written: the C header gives the bits that `coilsense-rt` gives, and the readings of the sensors
//! over the motion's signals; what is not read is said.

use std::path::Path;
use std::process::Command;

use coilsense::plant::{ModalPlant, Order};
use coilsense::sensors::Readout;
use coilsense_lab::mitigation::export::Precision;
use coilsense_lab::plant::{Also, Fmi, Form, Plant, Request};
use coilsense_lab::report::export_file;
use coilsense_lab::spec::Spec;
use coilsense_rt::Real;

use super::{RUST, S_T, STEP, inputs, mounts, ran, request, run_in_c_for, spec};

const SAMPLES: usize = 3000;
const SENSORS: &str = r#"
[[sensor]]
name = "load cell, motor side"
kind = "load-cell"
end = 1
bandwidth = "1 kHz"
sample_rate = "2.3 kHz"
noise = "0.01 N"

[[sensor]]
name = "float"
kind = "load-cell"
end = 2
bandwidth = "200 Hz"
order = 3
delay = "1.3 ms"
resolution = "0.02 N"

[[sensor]]
name = "2 lasers"
kind = "deflection"
sample_rate = "1 kHz"
resolution = "2.4 um"

[[sensor]]
name = "LCR meter"
kind = "inductance"
averaging = "10 ms"
sample_rate = "100 Hz"

[[sensor]]
name = "two encoders"
kind = "two-encoder"
compliance = "20 um/N"
"#;

fn with_sensors(text: &str) -> String {
    format!("{text}{SENSORS}")
}

fn asked(form: Form) -> Request {
    Request { also: Also::of("readings").unwrap(), ..request(form) }
}

/// The forces of all four in Rust, sample by sample.
fn read_here<T: Real>(plant: &ModalPlant, made: &Plant, seed: u64) -> Vec<T> {
    let steps = plant.settings::<8>().unwrap().plant::<T>(STEP).unwrap();
    let coil = made.coil.as_ref().unwrap();
    let calibration = [coil.calibration().alpha(), coil.calibration().beta()].map(T::nearest);
    let coil = coil.settings::<T, 8, 51, 13>().unwrap();
    let sensors = made.sensors.as_ref().unwrap();
    let of =
        |index: usize| Readout::new(sensors[index].readout.clone()).unwrap().steps(STEP, seed + index as u64).unwrap();
    let (first, second) = (of(0).settings::<T, 1>().unwrap(), of(1).settings::<T, 2>().unwrap());
    let (third, fourth) = (of(2).settings::<T, 0>().unwrap(), of(3).settings::<T, 0>().unwrap());
    let mean = T::nearest(plant.mean_length());
    let preload = T::nearest(plant.spring().stiffness() * plant.stretch());
    let force = |length: T| preload + T::nearest(plant.spring().stiffness()) * (length - mean);
    let mut state = steps.settled([T::ZERO; 2]);
    let mut at_rest = state;
    let out = steps.step(&mut at_rest, [T::ZERO; 2]);
    let still = coil.reading(&steps, &at_rest).inductance;
    let mut states = (
        first.settled::<64>(out.input),
        second.settled::<64>(out.output),
        third.settled::<64>(mean + (out.end - T::ZERO)),
        fourth.settled::<64>(still),
    );
    let each = inputs().into_iter().take(SAMPLES).flat_map(|row| {
        let row = row.map(T::nearest);
        let out = steps.step(&mut state, row);
        let henry = fourth.step(&mut states.3, coil.reading(&steps, &state).inductance);
        [
            first.step(&mut states.0, out.input),
            second.step(&mut states.1, out.output),
            force(third.step(&mut states.2, mean + (out.end - row[0]))),
            force(T::ONE / (calibration[0] * henry + calibration[1])),
        ]
    });
    each.collect()
}

const IN_C: &str = "static x_sensors sensors; static int begun; x_readings out; x_output now;
        if (!begun) { x_state still = state; now = x_step(&plant, &still, 0, 0); x_sensors_settle(&sensors, &plant, &still, now, 5); begun = 1; }
        now = x_step(&plant, &state, row[0], row[1]); out = x_read(&sensors, &plant, &state, now);";

#[test]
fn c_reads_what_rust_reads() {
    for (text, mount) in mounts().into_iter().step_by(3) {
        let plant = ModalPlant::new(&coilsense::paper::s_t(), &mount, 0.23, Order::Modes(6)).unwrap();
        let settings = plant.settings::<8>().unwrap();
        let begun = [settings.stiffness, settings.mass, settings.damping_ratio];
        let form = Form::C { precision: Precision::Double, step: Some(STEP) };
        let made = Plant::of(spec(&with_sensors(&text)), &asked(form)).unwrap();
        let rows = || inputs().into_iter().take(SAMPLES).flatten();
        let bytes: Vec<u8> = rows().flat_map(f64::to_ne_bytes).collect();
        let header = made.header("x", Precision::Double, Some(STEP)).unwrap();
        for member in ["load_cell_motor_side", "sensor_float", "sensor_2_lasers", "lcr_meter"] {
            assert!(header.contains(&format!("forces.{member} =")), "{member}: {header}");
        }
        let theirs = run_in_c_for(IN_C, &header, begun, &bytes);
        let ours: Vec<u8> = read_here::<f64>(&plant, &made, 5).iter().flat_map(|y| y.to_ne_bytes()).collect();
        assert!(ours == theirs, "double: {text}");

        let bytes: Vec<u8> = rows().flat_map(|value| (value as f32).to_ne_bytes()).collect();
        let single = made.header("x", Precision::Single, Some(STEP)).unwrap();
        let theirs = run_in_c_for(IN_C, &single, begun, &bytes);
        let ours: Vec<u8> = read_here::<f32>(&plant, &made, 5).iter().flat_map(|y| y.to_ne_bytes()).collect();
        assert!(ours == theirs, "single: {text}");
    }
}

#[test]
fn the_books_c_reads_its_sensors() {
    let page = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../book/src/guide/export.md");
    let page = std::fs::read_to_string(&page).unwrap_or_else(|error| panic!("{}: {error}", page.display()));
    let code = page.split("```c\n").nth(2).and_then(|rest| rest.split("\n```").next()).expect("a second block of C");
    let example = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples/sea-ankle.toml");
    let form = Form::C { precision: Precision::Single, step: Some(1e-4) };
    let request = Request { modes: None, damping_ratio: Some(0.005), ..asked(form) };
    let made = Plant::of(Spec::read(&example).unwrap(), &request).unwrap();
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("ankle_sensors.h"), export_file(&made, "ankle_sensors").unwrap().bytes).unwrap();
    let program = format!(
        "#include \"ankle_sensors.h\"\nint main(void)\n{{\n    static ankle_sensors_plant plant;\n    static ankle_sensors_state state;\n    \
         ankle_sensors_output out;\n    if (ankle_sensors_init(&plant, ANKLE_SENSORS_STIFFNESS, ANKLE_SENSORS_MASS, 0.005, 1e-4) != 0) return 2;\n    \
         ankle_sensors_settle(&state, 0, 0);\n    out = ankle_sensors_step(&plant, &state, 0, 0);\n    {{\n{code}\n    \
         return read.laser < 95.0f || read.laser > 96.5f;\n    }}\n}}\n"
    );
    std::fs::write(folder.path().join("x.c"), program).unwrap();
    let mut compiler = Command::new("cc");
    compiler.args(["-std=c99", "-pedantic", "-Wall", "-Wextra", "-Werror", "-o", "x", "x.c"]);
    let made = compiler.current_dir(folder.path()).output().unwrap();
    assert!(made.status.success(), "{}", String::from_utf8_lossy(&made.stderr));
    ran(&folder.path().join("x"), &[]);
}

#[test]
fn a_sensor_that_is_not_read_is_named() {
    let text = with_sensors(&format!("{S_T}[mount]\ndamping_ratio = 0.005\n"));
    let made = Plant::of(spec(&text), &asked(RUST)).unwrap();
    assert_eq!(made.sensors.as_ref().unwrap().len(), 4);
    assert!(made.warnings[0].starts_with("two encoders is not read: the drive train"), "{:?}", made.warnings);
    let rust = made.constant("x", Precision::Single, Some(STEP)).unwrap();
    assert!(
        rust.contains("pub const X_LCR_METER: coilsense_rt::Readout<f32, 0>")
            && rust.contains("X_LCR_METER_SLOTS: usize = 52")
    );
}

#[test]
fn readings_go_with_their_step_and_with_c_and_rust() {
    let text = with_sensors(&format!("{S_T}[mount]\ndamping_ratio = 0.005\n"));
    let made = |form| Plant::of(spec(&text), &asked(form)).unwrap();
    let told = |form| export_file(&made(form), "x").map(|_| ()).unwrap_err().to_string();
    let c = |step| Form::C { precision: Precision::Double, step };
    assert_eq!(told(c(None)), "a.toml: readings need a step, in which the instruments are read");
    assert!(
        told(c(Some(1e-9))).starts_with("a.toml: float: step must be at least 1.300e-9 s"),
        "{}",
        told(c(Some(1e-9)))
    );
    for (form, word) in
        [(Form::StateSpace { step: Some(STEP) }, "state-space"), (Form::Fmu { version: Fmi::Two, step: STEP }, "fmu")]
    {
        assert!(told(form).contains(&format!("readings go with c and rust, got {word}")), "{}", told(form));
    }
    let none = format!("{S_T}[mount]\ndamping_ratio = 0.005\n");
    let refused = Plant::of(spec(&none), &asked(RUST)).map(|_| ()).unwrap_err().to_string();
    assert!(refused.contains("readings: no [[sensor]] looks at"), "{refused}");
    let plain = Plant::of(spec(&none), &request(c(Some(STEP)))).unwrap();
    let refused = export_file(&plain, "x").map(|_| ()).unwrap_err().to_string();
    assert!(refused.contains("step goes with state-space, fmu or readings, got c"), "{refused}");
}
