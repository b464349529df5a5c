//! Cams by law and from files: what is read, refused and doubted.

use std::f64::consts::TAU;

use coilsense_lab::speed::{Range, SpeedMap, answer};

use super::{CAM, map, read, read_with, text};

#[test]
fn laws_lift_as_they_say_and_join_smoothly() {
    for (law, joins) in [("3-4-5-6", 2), ("3-4-5", 2), ("4-5-6-7", 3), ("cycloid", 2), ("harmonic", 1)] {
        let text = text("0.01", "", "", &format!("{CAM}\nlaw = \"{law}\""));
        let cam = read(&text).unwrap().cam.unwrap();
        assert!((cam.lift_at(0.5) - 0.01).abs() < 1e-12, "{law}");
        let open = 130.0 / 360.0;
        assert!(cam.lift_at(0.5 - 0.5 * open - 1e-6) == 0.0 && cam.lift_at(0.5 + 0.5 * open + 1e-6) == 0.0);
        for share in [0.1, 0.37, 0.8] {
            let (up, down) = (cam.lift_at(0.5 - 0.5 * open * share), cam.lift_at(0.5 + 0.5 * open * share));
            assert!((up - down).abs() < 1e-12, "{law}: {up} {down}");
        }
        for (number, pair) in cam.pieces.windows(2).enumerate() {
            let since = cam.begins[number + 1] - cam.begins[number];
            let mut factorial = 1.0;
            for order in 0..=joins {
                factorial *= (order as f64).max(1.0);
                let derivative = |powers: &[f64], at: f64| {
                    let each = powers.iter().enumerate().skip(order).map(|(power, c)| {
                        let falling: f64 = (0..order).map(|below| (power - below) as f64).product();
                        falling * c * at.powi((power - order) as i32)
                    });
                    each.sum::<f64>()
                };
                let (end, begin) = (derivative(&pair[0], since), derivative(&pair[1], 0.0));
                let scale = 0.01 * (2.0 / open).powi(order as i32) * factorial;
                assert!((end - begin).abs() < 1e-8 * scale, "{law} {number} {order}: {end} {begin}");
            }
        }
    }
}

#[test]
fn a_cam_of_a_file_is_the_law_that_it_was_written_from() {
    let law = read(&text("0.01", "", "", CAM)).unwrap().cam.unwrap();
    let rows = |from: u32| {
        (from..=360).map(|angle| format!("{angle},{}", 1e3 * law.lift_at(f64::from(angle) / 360.0))).collect::<Vec<_>>()
    };
    for from in [0, 7] {
        let file = format!("# a cam\nangle [deg],lift [mm]\n{}\n", rows(from).join("\n"));
        let cam = read_with(&text("0.01", "", "", "file = \"cam.csv\""), &file).unwrap().cam.unwrap();
        for sample in 0..1000 {
            let turn = f64::from(sample) / 1000.0;
            assert!(
                (cam.lift_at(turn) - law.lift_at(turn)).abs() < 1e-7,
                "{turn}: {:e}",
                cam.lift_at(turn) - law.lift_at(turn)
            );
        }
    }
    // Units are those of the heading: a lift in metres was taken for one in millimetres, an angle in radians for one in degrees.
    let of = |head: &str, angle: f64, lift: f64| {
        let row = |degree: u32| {
            let share = f64::from(degree) / 360.0;
            format!("{},{}", angle * share, lift * law.lift_at(share))
        };
        let file = format!("{head}\n{}\n", (0..=360).map(row).collect::<Vec<_>>().join("\n"));
        read_with(&text("0.01", "", "", "file = \"cam.csv\""), &file).unwrap().cam.unwrap()
    };
    for (head, angle, lift) in [
        ("angle [deg],lift [m]", 360.0, 1.0),
        ("angle [rad],lift [mm]", TAU, 1e3),
        ("angle (deg),lift (um)", 360.0, 1e6),
        ("angle,lift", 360.0, 1e3),
    ] {
        let cam = of(head, angle, lift);
        assert!(
            (cam.lift - 0.01).abs() < 1e-9 && cam.words == "lift of cam.csv, 10.0 mm",
            "{head}: {} {}",
            cam.lift,
            cam.words
        );
        assert!((cam.lift_at(0.41) - law.lift_at(0.41)).abs() < 1e-7, "{head}");
    }
    let bad = |file: &str| read_with(&text("0.01", "", "", "file = \"cam.csv\""), file).map(|_| ()).unwrap_err();
    for (file, part) in [
        ("0,0\n1,1\n", "must hold 8 to"),
        (&rows(0)[..200].join("\n") as &str, "must end where it begins"),
        (&format!("{}\n5,1\n", rows(0).join("\n")), "angles must rise"),
        (&format!("{}\n361,none\n", rows(0).join("\n")), "must be an angle in degrees"),
        (&format!("angle [deg],lift [kg]\n{}\n", rows(0).join("\n")), "cam.csv:1: the unit \"kg\" must be one of"),
        (&format!("angle [N],lift [mm]\n{}\n", rows(0).join("\n")), "the unit \"N\" must be one of"),
        (&rows(0).join("\n").replace(',', ",-"), "lifts must be zero or above, got -10.0 mm"),
    ] {
        assert!(bad(file).contains(part) && bad(file).lines().count() == 1, "{}", bad(file));
    }
}

#[test]
fn what_no_coil_or_spec_has_is_said_of_a_cam() {
    // A lift that goes half a millimetre beyond the range in use; damping that was meant as half a per cent.
    let spec = text("0.5", "", "restitution = 0.0", CAM);
    let cam = read(&spec).unwrap().cam.unwrap();
    let (shortest, least) =
        (1e3 * (cam.length - cam.lift), spec.lines().find(|line| line.starts_with("min_length")).unwrap().to_owned());
    let words = |above: f64| {
        let given = spec.replace(&least, &format!("min_length = \"{} mm\"", shortest + above));
        answer(&map(&given, 3000.0, 3000.0)).join("\n")
    };
    assert!(words(0.5).contains("Warning: ζ = 0.5 is unusually high for a coil's own ringing"), "{}", words(0.5));
    assert!(words(0.5).contains("mm leave the range in use"), "{}", words(0.5));
    assert!(!words(0.0).contains("leave the range in use"), "{}", words(0.0));
    let calm = answer(&map(&text("0.01", "", "restitution = 0.0", CAM), 3000.0, 3000.0)).join("\n");
    assert!(!calm.contains("Warning:"), "{calm}");
}

#[test]
fn a_cam_that_is_written_coarsely_is_told() {
    let law = read(&text("0.01", "", "", CAM)).unwrap().cam.unwrap();
    let words = |step: usize, digits: usize| {
        let row = |degree: usize| format!("{degree},{:.digits$}", 1e3 * law.lift_at(degree as f64 / 360.0));
        let file = (0..=360).step_by(step).map(row).collect::<Vec<_>>().join("\n");
        let spec = read_with(&text("0.01", "", "restitution = 0.0", "file = \"cam.csv\""), &file).unwrap();
        let range = Range { from: 50.0, to: 50.0, step: 10.0, ratio: 0.5 };
        answer(&SpeedMap::of(spec, range, &|_, _| true).unwrap()).join("\n")
    };
    // A degree and a nanometre.
    let fine = words(1, 6);
    assert!(!fine.contains("Warning:"), "{fine}");
    // A hundredth of a millimetre: 0.71 · 10 µm/(1 deg)² = 23 mm/rad², as much as the cam's own.
    let rounded = words(1, 2);
    assert!(rounded.contains("Warning: the cam's lifts are rounded to 0.0100 mm, which alone makes"), "{rounded}");
    let percent: f64 = rounded.split("alone makes ").nth(1).unwrap().split(' ').next().unwrap().parse().unwrap();
    assert!((50.0..=100.0).contains(&percent), "{rounded}");
    // 20 degrees: a bit more than a row for each period of harmonic 16.
    let coarse = words(20, 6);
    assert!(coarse.contains("rows lie up to 20.0 deg apart, 1.1"), "{coarse}");
    assert!(coarse.contains("which has the first surge frequency at the highest speed"), "{coarse}");
}
