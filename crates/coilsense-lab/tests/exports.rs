//! What is exported runs as it runs here: the C header, compiled with the system's compiler, gives the same bits.
//!
//! Next door: the Rust constants, compiled into the firmware that the test command builds.

use std::io::Write;
use std::path::Path;
use std::process::{Command, Stdio};

use coilsense::mitigation::{
    BankDesign, KalmanNoise, SampledSpring, ToleranceBox, WindowDesign, delay_line_observer, double_mean,
    inductance_fusion, low_pass, modal_kalman, observer_bank, surge_comb, surge_mean, surge_notches, surge_window,
    zero_vibration_derivative,
};
use coilsense::{Damping, Spring};
use coilsense_lab::mitigation::export::{Export, ExportError, Precision, Settings};
use coilsense_lab::plant;
use coilsense_lab::spec::Spec;
use coilsense_rt::{Biquad, Cascade, Measured, Window};
use rand::RngExt;

const SAMPLES: usize = 100_000;
const RATE: f64 = 2500.0;

fn sampled() -> SampledSpring {
    let spring = Spring::new(coilsense::paper::S_T);
    SampledSpring::new(&spring.unwrap(), &Damping::Modal(0.005), RATE).unwrap()
}

/// Forces near 96 N, and end positions near 0 and 0.23 m; the third of every hundred is a new slow force.
fn inputs() -> Vec<[f64; 3]> {
    let mut random = rand_pcg::Pcg64::new(42, 1);
    let mut each =
        || [96.0, 0.0, 0.23].map(|middle: f64| middle + random.random_range(-1.0..1.0) * (0.01 + 0.1 * middle));
    (0..SAMPLES).map(|_| each()).collect()
}

/// How the header is called: settle on the first sample, then a step per sample.
#[derive(Clone, Copy)]
enum Call {
    Filter,
    Fusion,
    Waves,
    Modes,
}

impl Call {
    fn settle(self) -> &'static str {
        match self {
            Self::Filter => "x_settle(&state, row[0])",
            Self::Fusion => "x_settle(&state, row[0], row[2])",
            Self::Waves | Self::Modes => "x_settle(&state, row[0], row[1], row[2])",
        }
    }

    fn step(self) -> &'static str {
        match self {
            Self::Filter => "x_step(&state, row[0])",
            Self::Fusion => "x_step(&state, row[0], n % 100 == 0 ? &row[2] : NULL)",
            Self::Waves => "x_step(&state, row[0], row[1], row[2])",
            Self::Modes => "x_step(&state, row[0], row[1], row[2]).output",
        }
    }
}

/// Compiles `header` with a program around it, feeds it `input`, gives what it writes.
fn run_in_c(folder: &Path, header: &str, call: Call, input: &[u8]) -> Vec<u8> {
    let program = format!(
        "#include <stdio.h>\n#include \"x.h\"\nint main(void)\n{{\n    x_state state;\n    x_real row[3], y;\n    long n = 0;\n    \
         while (fread(row, sizeof row, 1, stdin) == 1) {{\n        if (n == 0) {{ {}; }}\n        y = {};\n        n++;\n        \
         if (fwrite(&y, sizeof y, 1, stdout) != 1) return 1;\n    }}\n    return 0;\n}}\n",
        call.settle(),
        call.step()
    );
    std::fs::write(folder.join("x.h"), header).unwrap();
    std::fs::write(folder.join("x.c"), program).unwrap();
    let mut compiler = Command::new("cc");
    compiler
        .args(["-std=c99", "-pedantic", "-Wall", "-Wextra", "-Werror", "-O2", "-o", "x", "x.c"])
        .current_dir(folder);
    let made = compiler.output().expect("cc, the C compiler that Rust links with, must be there");
    assert!(made.status.success(), "{}\n{header}", String::from_utf8_lossy(&made.stderr));
    let mut child = Command::new(folder.join("x"))
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .expect("what was compiled runs");
    let mut pipe = child.stdin.take().unwrap();
    let input = input.to_vec();
    let writer = std::thread::spawn(move || pipe.write_all(&input));
    let output = child.wait_with_output().unwrap();
    writer.join().unwrap().unwrap();
    assert!(output.status.success());
    output.stdout
}

/// The header's bits against those of steps here, in both precisions.
fn assert_same(
    settings: &dyn Settings,
    call: Call,
    mut double: impl FnMut(usize, [f64; 3]) -> f64,
    mut single: impl FnMut(usize, [f32; 3]) -> f32,
) {
    let folder = tempfile::tempdir().unwrap();
    let rows = inputs();
    let header = |precision| Export::new("x", RATE, precision, settings).unwrap().c().unwrap();

    let bytes: Vec<u8> = rows.iter().flatten().flat_map(|value| value.to_ne_bytes()).collect();
    let theirs = run_in_c(folder.path(), &header(Precision::Double), call, &bytes);
    let ours: Vec<u64> = rows.iter().enumerate().map(|(n, row)| double(n, *row).to_bits()).collect();
    let (theirs, _) = theirs.as_chunks::<8>();
    let theirs: Vec<u64> = theirs.iter().map(|bytes| u64::from_ne_bytes(*bytes)).collect();
    assert_eq!(first_difference(&ours, &theirs), None, "{} in double precision", settings.kind());

    let bytes: Vec<u8> = rows.iter().flatten().flat_map(|value| (*value as f32).to_ne_bytes()).collect();
    let theirs = run_in_c(folder.path(), &header(Precision::Single), call, &bytes);
    let ours: Vec<u32> =
        rows.iter().enumerate().map(|(n, row)| single(n, row.map(|value| value as f32)).to_bits()).collect();
    let (theirs, _) = theirs.as_chunks::<4>();
    let theirs: Vec<u32> = theirs.iter().map(|bytes| u32::from_ne_bytes(*bytes)).collect();
    assert_eq!(first_difference(&ours, &theirs), None, "{} in single precision", settings.kind());
}

fn first_difference<T: PartialEq + Copy>(ours: &[T], theirs: &[T]) -> Option<usize> {
    assert_eq!((ours.len(), theirs.len()), (SAMPLES, SAMPLES));
    ours.iter().zip(theirs).position(|(a, b)| a != b)
}

fn to_single(value: f64) -> f32 {
    value as f32
}

fn measured<T: Copy>([force, first, second]: [T; 3]) -> Measured<T> {
    Measured { force, ends: [first, second] }
}

#[test]
fn cascades_in_c_give_the_bits_that_they_give_here() {
    let mut sections = low_pass(3, 100.0, RATE).unwrap();
    sections.extend(surge_notches(&sampled(), 2, 2.0).unwrap());
    let wide: Cascade<f64, 4> = Cascade { sections: sections.try_into().unwrap() };
    let narrow = wide.map(to_single);
    let (mut a, mut b) = (wide.settled(inputs()[0][0]), narrow.settled(inputs()[0][0] as f32));
    assert_same(&wide, Call::Filter, |_, row| wide.step(&mut a, row[0]), |_, row| narrow.step(&mut b, row[0]));
}

#[test]
fn means_and_combs_in_c_give_the_bits_that_they_give_here() {
    let (first, first_single) = (inputs()[0][0], inputs()[0][0] as f32);
    let wide = surge_mean(&sampled());
    let narrow = wide.map(to_single);
    let (mut a, mut b) = (wide.settled::<64>(first), narrow.settled::<64>(first_single));
    assert_same(&wide, Call::Filter, |_, row| wide.step(&mut a, row[0]), |_, row| narrow.step(&mut b, row[0]));
    let wide = double_mean(&sampled(), 0.07).unwrap();
    let narrow = wide.map(to_single);
    let (mut a, mut b) = (wide.settled::<64>(first), narrow.settled::<64>(first_single));
    assert_same(&wide, Call::Filter, |_, row| wide.step(&mut a, row[0]), |_, row| narrow.step(&mut b, row[0]));
    let wide = surge_comb(&sampled(), 5.0).unwrap();
    let narrow = wide.map(to_single);
    let (mut a, mut b) = (wide.settled::<64>(first), narrow.settled::<64>(first_single));
    assert_same(&wide, Call::Filter, |_, row| wide.step(&mut a, row[0]), |_, row| narrow.step(&mut b, row[0]));
}

#[test]
fn windows_shapers_and_fusion_in_c_give_the_bits_that_they_give_here() {
    let (first, slow) = (inputs()[0][0], inputs()[0][2]);
    let design =
        WindowDesign { impact: 0.25, interval: 2.0, bandwidth: 1.5, motion: 2.7, noise: 0.24, tolerances: None };
    let wide: Window<f64, 93> = surge_window(&sampled(), &design).unwrap();
    let narrow = wide.map(to_single);
    let (mut a, mut b) = (wide.settled(first), narrow.settled(first as f32));
    assert_same(&wide, Call::Filter, |_, row| wide.step(&mut a, row[0]), |_, row| narrow.step(&mut b, row[0]));
    let wide = zero_vibration_derivative(&sampled());
    let narrow = wide.map(to_single);
    let (mut a, mut b) = (wide.settled::<64>(first), narrow.settled::<64>(first as f32));
    assert_same(&wide, Call::Filter, |_, row| wide.step(&mut a, row[0]), |_, row| narrow.step(&mut b, row[0]));
    let wide = inductance_fusion(1.0, 25.0, 0.0213, RATE).unwrap();
    let narrow = wide.map(to_single);
    let (mut a, mut b) = (wide.settled::<64>(first, slow), narrow.settled::<64>(first as f32, slow as f32));
    assert_same(
        &wide,
        Call::Fusion,
        |n, row| wide.step(&mut a, row[0], (n % 100 == 0).then_some(row[2])),
        |n, row| narrow.step(&mut b, row[0], (n % 100 == 0).then_some(row[2])),
    );
}

#[test]
fn observers_in_c_give_the_bits_that_they_give_here() {
    let first = inputs()[0];
    let (start, start_single) = (measured(first), measured(first.map(to_single)));
    let wide = delay_line_observer(&sampled(), 0.3).unwrap();
    let narrow = wide.map(to_single);
    let (mut a, mut b) = (wide.settled::<64>(&start), narrow.settled::<64>(&start_single));
    let here = |_: usize, row: [f64; 3]| wide.step(&mut a, &measured(row));
    assert_same(&wide, Call::Waves, here, |_, row| narrow.step(&mut b, &measured(row)));
    let noise = KalmanNoise { force: 0.24, shock: 0.1, ringing: 2.0, drift: 0.5 };
    let wide = modal_kalman::<3>(&sampled(), &noise).unwrap();
    let narrow = wide.map(to_single);
    let (mut a, mut b) = (wide.settled(&start), narrow.settled(&start_single));
    let here = |_: usize, row: [f64; 3]| wide.step(&mut a, &measured(row)).output;
    assert_same(&wide, Call::Modes, here, |_, row| narrow.step(&mut b, &measured(row)).output);
    let design = BankDesign { noise, stiffnesses: 1, memory: 0.1, sharpness: 1e-4 };
    let wide = observer_bank::<3, 5>(&sampled(), &ToleranceBox::new(0.1, 0.1).unwrap(), &design).unwrap();
    let narrow = wide.map(to_single);
    let (mut a, mut b) = (wide.settled(&start), narrow.settled(&start_single));
    let here = |_: usize, row: [f64; 3]| wide.step(&mut a, &measured(row)).output;
    assert_same(&wide, Call::Modes, here, |_, row| narrow.step(&mut b, &measured(row)).output);
}

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

/// S_T in eight modes, two of which stand for all others.
fn plant() -> String {
    let spec = format!("{S_T}[mount]\nend2 = \"held\"\ndamping_ratio = 0.005\n");
    let spec = Spec::parse("plant.toml", &spec, &|_: &str| unreachable!()).unwrap();
    let request = plant::Request {
        form: plant::Form::Rust { precision: Precision::Single, step: None },
        also: plant::Also { inductance: true, closest_pitch: true, readings: false },
        modes: Some(6),
        error: None,
        bandwidth: None,
        damping_ratio: None,
        mean_length: None,
    };
    plant::Plant::of(spec, &request).unwrap().constant("plant", Precision::Single, None).unwrap()
}

/// The settings that the firmware is compiled with, by file name.
fn firmware() -> Vec<(&'static str, String)> {
    let spring = sampled();
    let rust = |name: &'static str, settings: &dyn Settings| {
        (name, Export::new(name, RATE, Precision::Single, settings).unwrap().rust())
    };
    let notches = |count, quality| surge_notches(&spring, count, quality).unwrap();
    let one: Cascade<f64, 1> = Cascade { sections: notches(1, 2.0).try_into().unwrap() };
    let five: Cascade<f64, 5> = Cascade { sections: notches(5, 3.0).try_into().unwrap() };
    let tolerances = Some(ToleranceBox::new(0.1, 0.1).unwrap());
    let design = WindowDesign { impact: 0.25, interval: 2.0, bandwidth: 1.5, motion: 2.7, noise: 0.24, tolerances };
    let window: Window<f64, 96> = surge_window(&spring, &design).unwrap();
    let noise = KalmanNoise { force: 0.24, shock: 0.15, ringing: 0.1, drift: 0.5 };
    vec![
        rust("notch", &one),
        rust("five_notches", &five),
        rust("surge_mean", &surge_mean(&spring)),
        rust("comb", &surge_comb(&spring, 20.0).unwrap()),
        rust("window", &window),
        rust("kalman", &modal_kalman::<3>(&spring, &noise).unwrap()),
        ("plant", plant()),
    ]
}

fn firmware_file(name: &str) -> std::path::PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("../coilsense-rt/robot/src/settings/{name}.rs"))
}

#[test]
fn the_firmware_is_compiled_with_what_is_exported() {
    for (name, text) in firmware() {
        let path = firmware_file(name);
        if std::env::var_os("COILSENSE_WRITE_DOCS").is_some() {
            std::fs::write(&path, &text).unwrap();
        }
        let found = std::fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
        assert_eq!(without_numbers(&found), without_numbers(&text), "{name}: COILSENSE_WRITE_DOCS=1 writes it anew");
        // Another processor may round a design's last digit otherwise.
        for (found, ours) in numbers(&found).into_iter().zip(numbers(&text)) {
            assert!(
                (found - ours).abs() <= 1e-6 * ours.abs().max(1e-6),
                "{name}: {found} against {ours}: COILSENSE_WRITE_DOCS=1 writes it anew"
            );
        }
    }
}

/// The numbers of a text, signs and exponents with them.
fn numbers(text: &str) -> Vec<f64> {
    let part = |c: char| !(c.is_ascii_digit() || ".-e".contains(c));
    text.split(part).filter_map(|word| word.parse().ok()).collect()
}

/// Words and brackets; what a formatter moves is left out.
fn without_numbers(text: &str) -> String {
    let moved = |c: char| c.is_whitespace() || c == ',';
    text.chars().filter(|c| !(moved(*c) || c.is_ascii_digit() || ".-e".contains(*c))).collect()
}

#[test]
fn a_rust_constant_and_json_say_the_same_numbers() {
    let mean = surge_mean(&sampled());
    let export = Export::new("surge_mean", RATE, Precision::Single, &mean).unwrap();
    let rust = export.rust();
    assert!(
        rust.contains("pub const SURGE_MEAN: Boxcar<f32> = Boxcar {\n    whole: 46,\n    fraction: 0.2402"),
        "{rust}"
    );
    assert!(rust.contains("pub const SURGE_MEAN_RING: usize = 47;"), "{rust}");
    let json = export.json();
    assert_eq!(json["settings"]["means"][0]["scale"].as_f64(), Some(mean.scale));
    assert_eq!((json["ring"].as_u64(), json["kind"].as_str()), (Some(47), Some("mean")));
}

#[test]
fn names_and_numbers_that_no_compiler_takes_are_refused() {
    let cascade = |b0| Cascade { sections: [Biquad { b0, b1: 0.0, b2: 0.0, a1: 0.0, a2: 0.0 }] };
    for name in ["", "Notch", "a-b", "2nd", "x*/", "trailing_"] {
        assert!(
            matches!(Export::new(name, RATE, Precision::Double, &cascade(1.0)), Err(ExportError::Name(_))),
            "{name}"
        );
    }
    let told = |b0, precision| Export::new("notch", RATE, precision, &cascade(b0)).err().unwrap().to_string();
    assert_eq!(told(f64::NAN, Precision::Double), "notch: settings.sections[0].b0 must be finite, got NaN");
    assert!(
        told(1e300, Precision::Single).contains("settings.sections[0].b0 must be within what single precision holds")
    );
}
