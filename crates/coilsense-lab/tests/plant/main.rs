//! A plant as it is written: the C header, compiled with the system's compiler, gives the bits that `coilsense-rt` gives; matrices read back are
//! the plant; what has no plant is refused in a line.
//!
//! Next door: the steps against the motion (`coilsense`, `tests/plant.rs`), the Rust constant in the firmware (`exports`).

mod coil;
mod readings;

use std::io::Write;
use std::path::Path;
use std::process::{Command, Stdio};

use coilsense::plant::{ModalPlant, Order};
use coilsense::{Damping, FarEnd, Mount};
use coilsense_lab::mitigation::export::Precision;
use coilsense_lab::plant::{Also, Fmi, Form, Plant, Request};
use coilsense_lab::report::export_file;
use coilsense_lab::spec::Spec;
use coilsense_rt::{PlantSettings, Real};
use rand::RngExt;

const SAMPLES: usize = 20_000;
const STEP: f64 = 2e-4;
const RUST: Form = Form::Rust { precision: Precision::Double, step: None };

/// S_T; a mount follows.
const S_T: &str = r#"[spring]
name = "S_T"
model = "chain"
rest_length = "104 mm"
windings = 52
coil_radius = "8 mm"
wire_radius = "1 mm"
mass = "65 g"
stiffness = "760 N/m"
min_length = "196 mm"
max_length = "264 mm"
"#;

fn spec(text: &str) -> Spec {
    Spec::parse("a.toml", text, &|name: &str| Err(format!("{name} is not there"))).unwrap()
}

fn request(form: Form) -> Request {
    Request {
        form,
        also: Also::default(),
        modes: Some(6),
        error: None,
        bandwidth: None,
        damping_ratio: None,
        mean_length: None,
    }
}

/// Every end with every kind of damping: the spec's words, the mount, and another ζ to begin with.
fn mounts() -> Vec<(String, Mount)> {
    let ends = [("held", FarEnd::Position), ("force", FarEnd::Force), ("mass", FarEnd::Mass(0.1))];
    let dampings = [
        ("damping_ratio = 0", Damping::Modal(0.0)),
        ("damping_ratio = 0.005", Damping::Modal(0.005)),
        ("damping_ratio = 1", Damping::Modal(1.0)),
        ("damping_ratio = 3", Damping::Modal(3.0)),
        ("mass_damping = \"20 1/s\"", Damping::MassProportional { rate: 20.0 }),
        ("stiffness_damping = \"0.3 ms\"", Damping::StiffnessProportional { time: 3e-4 }),
    ];
    let of = |(word, end): (&str, FarEnd)| {
        let mass = if word == "mass" { "end_mass = \"100 g\"\n" } else { "" };
        let head = format!("{S_T}[mount]\nend2 = \"{word}\"\n{mass}");
        dampings.clone().map(|(text, damping)| (format!("{head}{text}\n"), Mount::new(end, damping).unwrap()))
    };
    ends.into_iter().flat_map(of).collect()
}

/// Steps of every 64th sample are as rough as can be, the others are those of a hand that shakes.
fn inputs() -> Vec<[f64; 2]> {
    let mut random = rand_pcg::Pcg64::new(42, 1);
    let mut each = |size: f64| size * random.random_range(-1.0..1.0);
    let (mut first, mut second) = (0.0, 0.0);
    (0..SAMPLES)
        .map(|k| {
            first = if k % 64 == 0 { each(2e-3) } else { first + each(1e-5) };
            second = if k % 97 == 0 { each(2e-3) } else { second + each(1e-5) };
            [first, second]
        })
        .collect()
}

/// Compiles a header with a program around it that begins with k, m, ζ and h, feeds it the inputs, and gives what it writes.
fn run_in_c(header: &str, [k, m, ratio]: [f64; 3], input: &[u8]) -> Vec<u8> {
    let wanted = "x_output out = x_step(&plant, &state, row[0], row[1]);";
    run_in_c_for(wanted, header, [k, m, ratio], input)
}

/// The same for what is read after each row into `out`.
fn run_in_c_for(wanted: &str, header: &str, [k, m, ratio]: [f64; 3], input: &[u8]) -> Vec<u8> {
    let folder = tempfile::tempdir().unwrap();
    let program = format!(
        "#include <stdio.h>\n#include \"x.h\"\nint main(void)\n{{\n    static x_plant plant;\n    static x_state state;\n    x_real row[2];\n    \
         if (x_init(&plant, {k:?}, {m:?}, {ratio:?}, {STEP:?}) != 0) return 2;\n    x_settle(&state, 0, 0);\n    \
         while (fread(row, sizeof row, 1, stdin) == 1) {{\n        {wanted}\n        \
         if (fwrite(&out, sizeof out, 1, stdout) != 1) return 1;\n    }}\n    return 0;\n}}\n"
    );
    std::fs::write(folder.path().join("x.h"), header).unwrap();
    std::fs::write(folder.path().join("x.c"), program).unwrap();
    let mut compiler = Command::new("cc");
    compiler.args(["-std=c99", "-pedantic", "-Wall", "-Wextra", "-Werror", "-O2", "-o", "x", "x.c"]);
    let made = compiler.current_dir(folder.path()).output().expect("cc, the compiler that Rust links with, is there");
    assert!(made.status.success(), "{}\n{header}", String::from_utf8_lossy(&made.stderr));
    ran(&folder.path().join("x"), input)
}

fn ran(program: &Path, input: &[u8]) -> Vec<u8> {
    let mut child = Command::new(program).stdin(Stdio::piped()).stdout(Stdio::piped()).spawn().unwrap();
    let mut pipe = child.stdin.take().unwrap();
    let input = input.to_vec();
    let writer = std::thread::spawn(move || pipe.write_all(&input));
    let output = child.wait_with_output().unwrap();
    writer.join().unwrap().unwrap();
    assert!(output.status.success(), "{:?}", output.status);
    output.stdout
}

/// All outputs of all samples, one after the other.
fn run_here<T: Real, const MODES: usize>(settings: &PlantSettings<MODES>, [k, m, ratio]: [f64; 3]) -> Vec<T> {
    let steps = settings.changed::<T>(k, m, ratio, STEP).unwrap();
    let mut state = steps.settled([T::ZERO; 2]);
    let each = inputs().into_iter().flat_map(|row| {
        let out = steps.step(&mut state, row.map(T::nearest));
        [out.input, out.output, out.deflection, out.end]
    });
    each.collect()
}

fn header(text: &str, precision: Precision) -> String {
    Plant::of(spec(text), &request(Form::C { precision, step: None })).unwrap().header("x", precision, None).unwrap()
}

#[test]
fn c_gives_the_bits_that_rust_gives_on_every_mount() {
    for (text, mount) in mounts() {
        let plant = ModalPlant::new(&coilsense::paper::s_t(), &mount, 0.23, Order::Modes(6)).unwrap();
        let settings = plant.settings::<8>().unwrap();
        let other = if let FarEnd::Mass(_) = mount.far_end() { settings.mass } else { 0.05 };
        for begun in [[settings.stiffness, settings.mass, settings.damping_ratio], [900.0, other, 0.02]] {
            let bytes: Vec<u8> = inputs().iter().flatten().flat_map(|value| value.to_ne_bytes()).collect();
            let theirs = run_in_c(&header(&text, Precision::Double), begun, &bytes);
            let ours: Vec<u8> = run_here::<f64, 8>(&settings, begun).iter().flat_map(|y| y.to_ne_bytes()).collect();
            assert!(ours == theirs, "double: {text}{begun:?}");

            let bytes: Vec<u8> = inputs().iter().flatten().flat_map(|value| (*value as f32).to_ne_bytes()).collect();
            let theirs = run_in_c(&header(&text, Precision::Single), begun, &bytes);
            let ours: Vec<u8> = run_here::<f32, 8>(&settings, begun).iter().flat_map(|y| y.to_ne_bytes()).collect();
            assert!(ours == theirs, "single: {text}{begun:?}");
        }
    }
}

#[test]
fn the_books_c_is_compiled() {
    let page = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../book/src/guide/export.md");
    let page = std::fs::read_to_string(&page).unwrap_or_else(|error| panic!("{}: {error}", page.display()));
    let code = page.split("```c\n").nth(1).and_then(|rest| rest.split("\n```").next()).expect("a block of C");
    let folder = tempfile::tempdir().unwrap();
    let text = format!("{S_T}[mount]\ndamping_ratio = 0.005\n");
    let made = Plant::of(spec(&text), &request(Form::C { precision: Precision::Double, step: None })).unwrap();
    std::fs::write(folder.path().join("ankle_spring.h"), made.header("ankle_spring", Precision::Double, None).unwrap())
        .unwrap();
    let program =
        format!("{code}\nint main(void)\n{{\n    return begin() != 0 || force_at_the_leg(0.0, 0.0) < 95.0;\n}}\n");
    std::fs::write(folder.path().join("x.c"), program).unwrap();
    let mut compiler = Command::new("cc");
    compiler.args(["-std=c99", "-pedantic", "-Wall", "-Wextra", "-Werror", "-o", "x", "x.c"]);
    let made = compiler.current_dir(folder.path()).output().unwrap();
    assert!(made.status.success(), "{}", String::from_utf8_lossy(&made.stderr));
    ran(&folder.path().join("x"), &[]);
}

#[test]
fn c_refuses_what_rust_refuses() {
    let program = "#include <stdio.h>\n#include <math.h>\n#include \"x.h\"\nint main(void)\n{\n    static x_plant plant;\n    \
        printf(\"%d%d%d%d%d%d%d%d\\n\", x_init(&plant, 0.0, 0.065, 0.0, 1e-4), x_init(&plant, NAN, 0.065, 0.0, 1e-4),\n    \
        x_init(&plant, 760.0, -1.0, 0.0, 1e-4), x_init(&plant, 760.0, 0.065, -0.1, 1e-4), x_init(&plant, 760.0, 0.065, 1001.0, 1e-4),\n    \
        x_init(&plant, 760.0, 0.065, 0.0, 0.0), x_init(&plant, 760.0, 0.065, 0.0, 1e7), x_init(&plant, 760.0, 0.065, 0.0, 1e-4));\n    \
        printf(\"%d\\n\", x_init(&plant, 760.0, 0.07, 0.0, 1e-4));\n    return 0;\n}\n";
    for (end, expected) in [("held\"", "11233440\n0\n"), ("mass\"\nend_mass = \"0.1 kg\"", "11233440\n2\n")] {
        let text = format!("{S_T}[mount]\nend2 = \"{end}\ndamping_ratio = 0.01\n");
        let folder = tempfile::tempdir().unwrap();
        std::fs::write(folder.path().join("x.h"), header(&text, Precision::Single)).unwrap();
        std::fs::write(folder.path().join("x.c"), program).unwrap();
        let mut compiler = Command::new("cc");
        // Of what is called nothing here, a compiler may say that it is not.
        let made = compiler.args(["-std=c99", "-o", "x", "x.c"]).current_dir(folder.path()).output().unwrap();
        assert!(made.status.success(), "{}", String::from_utf8_lossy(&made.stderr));
        assert_eq!(String::from_utf8(ran(&folder.path().join("x"), &[])).unwrap(), expected);
    }
}

#[test]
fn matrices_read_back_are_those_of_the_plant() {
    let text = format!("{S_T}[mount]\nend2 = \"force\"\nstiffness_damping = \"0.1 ms\"\n");
    let made = Plant::of(spec(&text), &request(Form::StateSpace { step: Some(1e-3) })).unwrap();
    let json: serde_json::Value = serde_json::from_slice(&export_file(&made, "x").unwrap().bytes).unwrap();
    let numbers = |value: &serde_json::Value| -> Vec<f64> {
        let rows = value.as_array().unwrap().iter();
        rows.flat_map(|row| row.as_array().unwrap()).map(|number| number.as_f64().unwrap()).collect()
    };
    let (space, sampled) = (made.plant.state_space(None), made.plant.sampled(1e-3, None).unwrap());
    // A reader of JSON may be off by a last digit.
    let assert_read = |value: &serde_json::Value, expected: Vec<f64>| {
        let found = numbers(value);
        assert_eq!(found.len(), expected.len());
        let near = |(a, b): (&f64, &f64)| (a - b).abs() <= 1e-15 * b.abs();
        assert!(found.iter().zip(&expected).all(near));
    };
    assert_read(&json["continuous"]["a"], space.a.concat());
    assert_read(&json["continuous"]["b"], space.b.concat());
    assert_read(&json["continuous"]["d_rate"], space.d_rate.concat());
    assert_read(&json["sampled"]["a"], sampled.a.concat());
    assert_read(&json["sampled"]["c"], sampled.c.concat());
    assert_eq!(json["schema"], "coilsense/state-space/1");
    assert_eq!(json["inputs"][1]["unit"], "N");
    assert_eq!((json["kept_modes"].as_u64(), json["available_modes"].as_u64()), (Some(6), Some(52)));
}

#[test]
fn what_has_no_plant_is_refused_in_a_line() {
    let s_t = S_T;
    let told = |text: &str, change: &dyn Fn(&mut Request)| {
        let mut asked = request(RUST);
        asked.modes = None;
        change(&mut asked);
        let refused = Plant::of(spec(text), &asked).map(|_| ()).unwrap_err().to_string();
        assert!(!refused.contains('\n'), "{refused}");
        refused
    };
    let as_it_is = |text: &str| told(text, &|_| ());
    assert!(as_it_is(s_t).contains("one damping makes a plant, got ζ = 0, ζ = 0.001, ζ = 0.005, ζ = 0.02"));
    let one = format!("{s_t}[mount]\ndamping_ratio = 0.005\n");
    let refused = told(&one, &|asked| asked.damping_ratio = Some(0.01));
    assert_eq!(refused, "a.toml: [mount]: --damping-ratio must be one of ζ = 0.005, got 0.01");
    let refused = told(&one, &|asked| (asked.modes, asked.error, asked.bandwidth) = (Some(2), Some(0.01), Some(100.0)));
    assert_eq!(refused, "a.toml: modes = 2 leaves an error of 27.776 % up to 100 Hz: 1.000 % takes 5 modes");
    let refused = told(&one, &|asked| (asked.modes, asked.error, asked.bandwidth) = (Some(2), Some(0.01), Some(300.0)));
    assert!(refused.starts_with("a.toml: modes = 2 leaves modes out up to 300 Hz: 1.000 % takes"), "{refused}");
    let refused = told(&one, &|asked| asked.modes = Some(53));
    assert_eq!(refused, "a.toml: modes must be from 1 to 52, got 53");
    let apart = one.replace("104 mm", "150 mm");
    assert!(as_it_is(&format!("{apart}[contact]\nwindings = \"hard\"\n")).contains("[contact]: export takes windings"));
    let helix = one.replace("\"chain\"", "\"helix\"");
    assert!(as_it_is(&helix).contains("[spring] model = \"helix\": export takes"), "{}", as_it_is(&helix));
    let refused =
        Plant::of(spec(&one), &request(RUST)).unwrap().constant("2x", Precision::Double, None).unwrap_err().to_string();
    assert!(refused.contains("must be a lower-case letter"), "{refused}");
}

#[test]
fn an_fmu_says_what_its_inputs_are() {
    for (end, second, has_end) in
        [("held\"", "u2", false), ("force\"", "F_2", true), ("mass\"\nend_mass = \"1 kg\"", "F_2", true)]
    {
        let text = format!("{S_T}[mount]\nend2 = \"{end}\ndamping_ratio = 0.01\n");
        for (version, element) in [(Fmi::Two, "ScalarVariable"), (Fmi::Three, "Float64")] {
            let made = Plant::of(spec(&text), &request(Form::Fmu { version, step: 5e-4 })).unwrap();
            // Packed without compression.
            let bytes = export_file(&made, "x").unwrap().bytes;
            let told = String::from_utf8_lossy(&bytes);
            for name in ["u1", second, "der_u1", &format!("der_{second}"), "F_i", "F_o", "F_x", "k", "m", "zeta"] {
                assert!(told.contains(&format!("<{element} name=\"{name}\" ")), "{name}: {told}");
            }
            assert_eq!(told.contains("name=\"u2\" valueReference=\"11\" causality=\"output\""), has_end);
            assert!(
                told.contains("straight between its last two values, one step late")
                    && told.contains("stepSize=\"0.0005\"")
            );
            assert_eq!(told.contains("fmi2SetRealInputDerivatives)"), version == Fmi::Two);
        }
    }
}

#[test]
fn a_large_chain_needs_an_order() {
    let text = format!("{S_T}masses_per_winding = 16\n[mount]\ndamping_ratio = 0.005\n");
    let asked = Request { modes: None, ..request(RUST) };
    let refused = Plant::of(spec(&text), &asked).map(|_| ()).unwrap_err().to_string();
    assert!(refused.contains("modes must be at most 512 for an export, got 832; --error and --bandwidth"), "{refused}");
    let few = Request { error: Some(0.001), bandwidth: Some(200.0), ..asked };
    let count = Plant::of(spec(&text), &few).unwrap().plant.count();
    assert!(count < 30, "{count}");
}
