//! F_L and the closest pitch of a plant as it is written: the C header gives the bits that `coilsense-rt` gives, the matrices have its row; what
//! cannot have them is refused, and what is doubtful is said.

use coilsense::calibrate::Calibration;
use coilsense::inductance::{MaxwellSum, SelfDistance};
use coilsense::plant::{ModalPlant, Order};
use coilsense::{FarEnd, Mount};
use coilsense_lab::mitigation::export::Precision;
use coilsense_lab::plant::{Also, Form, Plant, Request};
use coilsense_lab::report::export_file;
use coilsense_rt::Real;

use super::{RUST, S_T, STEP, inputs, mounts, request, run_in_c_for, spec};

fn asked(form: Form, also: &str) -> Request {
    Request { also: Also::of(also).unwrap(), ..request(form) }
}

/// L, its bound, F_L, its bound and the closest pitch of every sample.
fn read_here<T: Real>(plant: &ModalPlant, made: &Plant, [k, m, ratio]: [f64; 3]) -> Vec<T> {
    let steps = plant.settings::<8>().unwrap().changed::<T>(k, m, ratio, STEP).unwrap();
    let coil = made.coil.as_ref().unwrap().settings::<T, 8, 51, 13>().unwrap();
    let windings = made.windings.as_ref().unwrap().settings::<T, 8, 51>().unwrap();
    let mut state = steps.settled([T::ZERO; 2]);
    let each = inputs().into_iter().take(2000).flat_map(|row| {
        steps.step(&mut state, row.map(T::nearest));
        let read = coil.reading(&steps, &state);
        let pitch = windings.closest_pitch(&steps, &state);
        [read.inductance, read.inductance_bound, read.force, read.force_bound, pitch]
    });
    each.collect()
}

const IN_C: &str = "struct { x_reading read; x_real pitch; } out; (void)x_step(&plant, &state, row[0], row[1]);
        out.read = x_coil(&plant, &state); out.pitch = x_closest_pitch(&plant, &state);";

#[test]
fn c_reads_the_bits_that_rust_reads() {
    for (text, mount) in mounts() {
        let plant = ModalPlant::new(&coilsense::paper::s_t(), &mount, 0.23, Order::Modes(6)).unwrap();
        let settings = plant.settings::<8>().unwrap();
        let other = if let FarEnd::Mass(_) = mount.far_end() { settings.mass } else { 0.05 };
        for begun in [[settings.stiffness, settings.mass, settings.damping_ratio], [900.0, other, 0.02]] {
            let made = |precision| {
                Plant::of(spec(&text), &asked(Form::C { precision, step: None }, "F_L, closest_pitch")).unwrap()
            };
            let double = made(Precision::Double);
            let rows = || inputs().into_iter().take(2000).flatten();
            let bytes: Vec<u8> = rows().flat_map(f64::to_ne_bytes).collect();
            let theirs = run_in_c_for(IN_C, &double.header("x", Precision::Double, None).unwrap(), begun, &bytes);
            let ours: Vec<u8> = read_here::<f64>(&plant, &double, begun).iter().flat_map(|y| y.to_ne_bytes()).collect();
            assert!(ours == theirs, "double: {text}{begun:?}");

            let bytes: Vec<u8> = rows().flat_map(|value| (value as f32).to_ne_bytes()).collect();
            let single = made(Precision::Single).header("x", Precision::Single, None).unwrap();
            let theirs = run_in_c_for(IN_C, &single, begun, &bytes);
            let ours: Vec<u8> = read_here::<f32>(&plant, &double, begun).iter().flat_map(|y| y.to_ne_bytes()).collect();
            assert!(ours == theirs, "single: {text}{begun:?}");
        }
    }
}

#[test]
fn either_goes_without_the_other() {
    let text = format!("{S_T}[mount]\ndamping_ratio = 0.005\n");
    let bytes: Vec<u8> = [0.0_f64; 2].iter().flat_map(|value| value.to_ne_bytes()).collect();
    let of = |also: &str, wanted: &str| {
        let made = Plant::of(spec(&text), &asked(Form::C { precision: Precision::Double, step: None }, also)).unwrap();
        let header = made.header("x", Precision::Double, None).unwrap();
        let begun = [760.0, 0.065, 0.005];
        let out = run_in_c_for(wanted, &header, begun, &bytes);
        let numbers = out.chunks_exact(8).map(|eight| f64::from_ne_bytes(eight.try_into().unwrap()));
        (numbers.collect::<Vec<f64>>(), header)
    };
    let (read, header) =
        of("F_L", "x_reading out; (void)x_step(&plant, &state, row[0], row[1]); out = x_coil(&plant, &state);");
    // At rest it is set to zero: F_L is k times the stretch.
    assert!((read[2] - 760.0 * 0.126).abs() < 1e-9 && !header.contains("closest_pitch"), "{read:?}");
    let (read, header) = of(
        "closest_pitch",
        "x_real out; (void)x_step(&plant, &state, row[0], row[1]); out = x_closest_pitch(&plant, &state);",
    );
    assert!((read[0] - 0.23 / 52.0).abs() < 1e-16 && !header.contains("x_coil"), "{read:?}");
    assert!(header.contains("#define X_CONTACT_PITCH 0.002"));
}

#[test]
fn matrices_have_a_row_of_f_l_and_none_of_a_pitch() {
    let text = format!("{S_T}[mount]\ndamping_ratio = 0.005\n");
    let form = Form::StateSpace { step: Some(1e-3) };
    let made = Plant::of(spec(&text), &asked(form, "F_L")).unwrap();
    let json: serde_json::Value = serde_json::from_slice(&export_file(&made, "x").unwrap().bytes).unwrap();
    assert_eq!(json["outputs"][4]["name"], "F_L");
    let rows = |which: &str, name: &str| json[which][name].as_array().unwrap().len();
    assert_eq!([rows("continuous", "c"), rows("continuous", "d"), rows("sampled", "c"), rows("sampled", "d")], [5; 4]);
    let made = Plant::of(spec(&text), &asked(form, "closest_pitch")).unwrap();
    let refused = export_file(&made, "x").unwrap_err().to_string();
    assert!(refused.contains("closest_pitch is no straight line"), "{refused}");
}

#[test]
fn an_error_is_one_of_f_l_too() {
    let text = format!("{S_T}[mount]\ndamping_ratio = 0.005\n");
    let kept = |also: Also, modes| {
        let asked = Request { modes, error: Some(0.01), bandwidth: Some(100.0), also, ..request(RUST) };
        Plant::of(spec(&text), &asked).map(|made| (made.plant.kept(), made.error.unwrap().1))
    };
    let (forces, with_force) = (Also::default(), Also { inductance: true, ..Also::default() });
    let (few, _) = kept(forces, None).unwrap();
    let (enough, error) = kept(with_force, None).unwrap();
    assert!(enough >= few && error <= 0.01, "{few}, {enough}, {error}");
    let spring = coilsense::paper::s_t();
    let coil = MaxwellSum::new(&spring, SelfDistance::AsPrinted);
    let calibration = Calibration::theoretical(&spring, &coil, 0.23).unwrap();
    let mount = Mount::new(FarEnd::Position, coilsense::Damping::Modal(0.005)).unwrap();
    let left = |modes| {
        let plant = ModalPlant::new(&spring, &mount, 0.23, Order::Modes(modes)).unwrap();
        plant.error(100.0).unwrap().max(plant.coil_error(&coil, calibration, 100.0).unwrap())
    };
    assert!(left(enough) <= 0.01 && (enough == few || left(enough - 1) > 0.01));
    let refused = kept(with_force, Some(2)).unwrap_err().to_string();
    assert!(refused.contains(&format!("1.000 % takes {enough} modes")), "{refused}");
}

#[test]
fn words_that_are_no_outputs_and_wire_that_is_magnetic_are_refused() {
    for wrong in ["", "F_l", "F_L;closest_pitch", "F_L,", "L"] {
        let refused = Also::of(wrong).unwrap_err();
        assert!(refused.starts_with("must be of F_L, closest_pitch, readings, with commas between, got"), "{refused}");
    }
    let wire = |line: &str| format!("{S_T}{line}\n[mount]\ndamping_ratio = 0.005\n");
    let of = |line: &str, also: &str| Plant::of(spec(&wire(line)), &asked(RUST, also));
    let refused = of("relative_permeability = 2.5", "F_L").map(|_| ()).unwrap_err().to_string();
    assert!(
        refused.starts_with("a.toml: [spring] relative_permeability: a plant's F_L is that of wire that is not"),
        "{refused}"
    );
    assert!(of("relative_permeability = 2.5", "closest_pitch").unwrap().warnings.is_empty());
    assert!(of("", "F_L").unwrap().warnings.is_empty());
    let doubtful = of("material = \"stainless 1.4310\"", "F_L").unwrap();
    assert!(doubtful.warnings[0].contains("found with a relative permeability of 1 to 3"), "{:?}", doubtful.warnings);
    let carbon = of("material = \"steel EN 10270-1\"", "F_L").unwrap();
    assert!(carbon.warnings[0].contains("above 20"), "{:?}", carbon.warnings);
    assert!(of("material = \"steel EN 10270-1\"", "closest_pitch").unwrap().warnings.is_empty());
}
