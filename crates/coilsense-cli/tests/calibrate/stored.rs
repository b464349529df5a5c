//! Calibrations that are stored by one command and applied by another.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use super::{COIL, done, magnetic};

/// A spring of magnetic wire whose calibration is stored; R is 0.2697 Ω.
struct Bench {
    place: tempfile::TempDir,
    stored: PathBuf,
}

/// What came of an import: whether it was done, what was said, and the file.
struct Imported {
    fine: bool,
    told: String,
    read: String,
}

impl Bench {
    fn new() -> Self {
        let place = tempfile::tempdir().unwrap();
        let points = |index: usize, length: f64, henry: f64| {
            let head = if index == 0 { "u2 [mm],L [uH],R [Ohm]\n" } else { "" };
            format!("{head}{},{},0.2697\n", 1e3 * length, 1e6 * henry)
        };
        let log = magnetic(place.path(), "points.csv", 2.2, -3e-8, &points);
        let out = place.path().join("calibration");
        let force = ["--stiffness", "2 N/mm", "--stiffness-uncertainty", "0.5 %"];
        done(&log, &[&COIL[..], &["--theory", "steel", "--out", out.to_str().unwrap()], &force].concat());
        let stored = out.join("calibration.toml");
        Self { place, stored }
    }

    /// A new log of the same spring with so much more L \[H\], and R by row.
    fn log(&self, name: &str, shift: f64, resistance: impl Fn(usize) -> f64) -> PathBuf {
        magnetic(self.place.path(), name, 2.2, -3e-8, &|index, length, henry| {
            let head = if index == 0 { "time [s],u2 [mm],L [uH],R [Ohm]\n" } else { "" };
            let (time, ohm) = (0.01 * index as f64, resistance(index));
            format!("{head}{time},{},{},{ohm}\n", 1e3 * length, 1e6 * (henry + shift))
        })
    }

    fn import(&self, log: &Path, more: &[&str]) -> Imported {
        let file = self.place.path().join("read.csv");
        let _ = fs::remove_file(&file);
        let mut command = Command::new(env!("CARGO_BIN_EXE_coilsense"));
        command.arg("import").arg(log).args(["--calibration", self.stored.to_str().unwrap()]);
        let output = command.args(["--out", file.to_str().unwrap()]).args(more).output().unwrap();
        let fine = output.status.success();
        let told = String::from_utf8_lossy(if fine { &output.stdout } else { &output.stderr }).into_owned();
        Imported { fine, told, read: fs::read_to_string(&file).unwrap_or_default() }
    }
}

impl Imported {
    fn rows(&self) -> Vec<Vec<f64>> {
        let numbers = |line: &str| line.split(',').map(|cell| cell.parse().unwrap()).collect();
        self.read.lines().skip(1).map(numbers).collect()
    }

    /// How far the worst length is off \[m\], and its standard uncertainty.
    fn worst(&self) -> (f64, f64) {
        let off = self.rows().into_iter().map(|cells| ((cells[4] - cells[1]).abs(), cells[5]));
        off.fold((0.0, 0.0), |worst: (f64, f64), one| if one.0 > worst.0 { one } else { worst })
    }

    fn is_refused(&self, part: &str) {
        assert!(!self.fine && self.read.is_empty() && self.told.lines().count() == 1, "{}", self.told);
        assert!(self.told.contains(part), "{part}: {}", self.told);
    }
}

#[test]
fn a_stored_calibration_makes_length_and_force_of_a_new_log_in_one_command() {
    let bench = Bench::new();
    let text = fs::read_to_string(&bench.stored).unwrap();
    assert!(text.contains("relation = \"steel\"") && text.contains("resistance_ohm = 0.2697"), "{text}");
    let found = bench.import(&bench.log("new.csv", 0.0, |_| 0.2697), &[]);
    let told = &found.told;
    assert!(found.fine && told.contains("Length by ") && told.contains("Force by it (F_L)"), "{told}");
    let titles = "time [s],u2 [m],L [H],R [Ohm],length [m],u_length [m],F_L [N],u_F_L [N]";
    assert_eq!(found.read.lines().next().unwrap(), titles);
    let settled = bench.import(&bench.log("new.csv", 0.0, |_| 0.2697), &["--re-zero", &bench.zero("new.csv")]);
    for (cells, without) in found.rows().iter().zip(settled.rows()) {
        let [_, given, henry, _, length, length_u, force, force_u] = cells[..] else { panic!("{cells:?}") };
        // The meter's last digit, 0.1 nH, and the table.
        assert!((length - given).abs() < 5e-6, "{cells:?}");
        assert!((force - 2000.0 * (length - 0.0246)).abs() < 1e-9);
        // Remounting is a quarter of a percent of L on top of what is left when it is zeroed; L falls by 2e-5 to 5e-5 H/m.
        let remounting = (length_u * length_u - without[5] * without[5]).sqrt();
        let slope = 0.0025 * henry / remounting;
        assert!((1.2e-5..6e-5).contains(&slope), "{slope}");
        assert!((2e-5..4e-4).contains(&length_u) && force_u >= 2000.0 * length_u, "{cells:?}");
    }
}

impl Bench {
    /// Length and inductance of a row of a log, for `--re-zero`.
    fn zero(&self, log: &str) -> String {
        let text = fs::read_to_string(self.place.path().join(log)).unwrap();
        let cells: Vec<&str> = text.lines().nth(6).unwrap().split(',').collect();
        format!("{} mm, {} uH", cells[1], cells[2])
    }
}

#[test]
fn a_spring_that_was_remounted_is_within_its_uncertainty_and_re_zeroed_at_one_point() {
    let bench = Bench::new();
    let log = bench.log("moved.csv", 3e-9, |_| 0.2720);
    let found = bench.import(&log, &[]);
    let (off, length_u) = found.worst();
    assert!(off > 1e-4 && off < 1.96 * length_u, "{off} {length_u}");
    assert!(found.told.contains("R is 0.853 % off that of the calibration: clips or leads moved"), "{}", found.told);
    let found = bench.import(&log, &["--re-zero", &bench.zero("moved.csv")]);
    let (off, _) = found.worst();
    assert!(off < 1e-5 && found.told.contains("Re-zeroed: L is moved by 2.9"), "{off} {}", found.told);
    let log = bench.log("touching.csv", 0.0, |row| if row < 2 { 0.2684 } else { 0.2697 });
    let found = bench.import(&log, &[]);
    assert!(found.fine && found.told.contains("Turns touch in 2 of 12 rows, first at 0 s"), "{}", found.told);
}

#[test]
fn what_is_not_of_this_spring_is_not_read_and_nothing_is_written() {
    let bench = Bench::new();
    let other = bench.import(&bench.log("other.csv", 9e-7, |_| 0.2697), &[]);
    other.is_refused("L must be from");
    other.is_refused("calibration.toml tells between");
    let log = bench.log("new.csv", 0.0, |_| 0.2697);
    bench.import(&log, &["--re-zero", "80 mm, 1 uH"]).is_refused("re_zero: length must be from");
    bench.import(&log, &["--re-zero", "30 mm"]).is_refused("a length and an inductance");
    let text = fs::read_to_string(&bench.stored).unwrap();
    for (from, to, part) in [
        ("rows = [", "rows = 3 [", "is no stored calibration"),
        ("stored-calibration/1", "stored-calibration/9", "schema must be"),
        ("remounting = 0.0025", "remounting = 2", "remounting must be from 0 to below 1"),
        ("relation = ", "colour = 1\nrelation = ", "unknown field"),
    ] {
        fs::write(&bench.stored, text.replace(from, to)).unwrap();
        let found = bench.import(&log, &[]);
        found.is_refused(part);
        found.is_refused("calibration.toml");
    }
    fs::remove_file(&bench.stored).unwrap();
    bench.import(&log, &[]).is_refused("calibration.toml: ");
}
