//! Maps that were stopped, or made in parts.

use coilsense_lab::spec::Spec;
use coilsense_lab::speed::{Part, Range, SpeedMap};

use super::{CAM, read, read_with, text};

/// All points that are kept in a folder, as bytes, and in how many files.
fn kept(folder: &std::path::Path) -> (u64, usize) {
    let files: Vec<_> =
        std::fs::read_dir(folder).unwrap().map(|file| file.unwrap().metadata().unwrap().len()).collect();
    (files.iter().sum(), files.len())
}

const FEW: Range = Range { from: 30.0, to: 110.0, step: 40.0, ratio: 0.5 };

#[test]
fn a_map_that_was_stopped_goes_on_from_there_and_is_the_same() {
    let text = text("0.01", "", "restitution = [0.0, 0.5]", CAM);
    let whole = SpeedMap::of(read(&text).unwrap(), FEW, &|_, _| true).unwrap();
    let home = tempfile::tempdir().unwrap();
    let (folder, full) = (home.path().join("map.points"), home.path().join("full.points"));
    assert_eq!(SpeedMap::kept(read(&text).unwrap(), FEW, &full, &|_, _| true).unwrap(), whole);
    let stopped = SpeedMap::kept(read(&text).unwrap(), FEW, &folder, &|done, _| done < 5).map(|_| ()).unwrap_err();
    let message = stopped.to_string();
    assert!(message.contains("map.points, the same command goes on from there"), "{message}");
    let (before, _) = kept(&folder);
    assert!(before > 0 && before < kept(&full).0, "{before} bytes are kept");
    // A killed run leaves half a point.
    let torn = std::fs::read_dir(&folder).unwrap().next().unwrap().unwrap().path();
    let file = std::fs::OpenOptions::new().write(true).open(&torn).unwrap();
    file.set_len(before - 7).unwrap();
    assert_eq!(SpeedMap::kept(read(&text).unwrap(), FEW, &folder, &|_, _| true).unwrap(), whole);
    // It made what was not there, the torn point among them, and no more.
    assert_eq!(kept(&folder).1, 2);
    let again = kept(&folder).0 - (before - 7);
    assert!(again < kept(&full).0 - before + before / 4, "{again} bytes more");
    // All are there: none is made.
    assert_eq!(SpeedMap::kept(read(&text).unwrap(), FEW, &folder, &|_, _| true).unwrap(), whole);
    assert_eq!(kept(&folder).1, 2);
}

#[test]
fn parts_of_several_machines_make_one_map() {
    let text = text("0.01", "", "restitution = [0.0, 0.5]", CAM);
    let folder = tempfile::tempdir().unwrap();
    let mut made = 0;
    for number in [3, 1, 2] {
        let part = Part::parse(&format!("{number}/3")).unwrap();
        let share = SpeedMap::part(read(&text).unwrap(), FEW, folder.path(), part, &|_, _| true).unwrap();
        made += share.points;
        assert_eq!(share.there, made, "{share:?}");
        assert!(share.points >= share.of / 3 && share.points <= share.of.div_ceil(3), "{share:?}");
        if number == 2 {
            assert_eq!(share.there, share.of);
        }
    }
    let whole = SpeedMap::of(read(&text).unwrap(), FEW, &|_, _| true).unwrap();
    assert_eq!(SpeedMap::kept(read(&text).unwrap(), FEW, folder.path(), &|_, _| true).unwrap(), whole);
    assert_eq!(kept(folder.path()).1, 3);
}

#[test]
fn points_of_another_spring_range_or_cam_are_not_taken() {
    let base = text("0.01", "", "restitution = 0.0", CAM);
    let folder = tempfile::tempdir().unwrap();
    SpeedMap::kept(read(&base).unwrap(), FEW, folder.path(), &|_, _| true).unwrap();
    let law = read(&base).unwrap().cam.unwrap();
    let lift = |angle: u32| 1e3 * law.lift_at(f64::from(angle) / 360.0);
    let row = |angle: u32, higher: f64| format!("{angle},{}\n", higher * lift(angle));
    let file = |higher: f64| {
        format!("angle [deg],lift [mm]\n{}", (0..=360).map(|angle| row(angle, higher)).collect::<String>())
    };
    let by_file = base.replace(CAM, "file = \"cam.csv\"");
    for (spec, range) in [
        (read(&base.replace("0.01", "0.02")), FEW),
        (read(&base), Range { ratio: 1.0, ..FEW }),
        (read_with(&by_file, &file(1.0)), FEW),
        // The same text, and another file of that name.
        (read_with(&by_file, &file(0.9)), FEW),
    ] {
        let spec = spec.unwrap();
        let alone = SpeedMap::of(spec.clone(), range, &|_, _| true).unwrap();
        assert_eq!(SpeedMap::kept(spec, range, folder.path(), &|_, _| true).unwrap(), alone);
    }
    // Each left its own, and what is no point is passed over.
    assert_eq!(kept(folder.path()).1, 5);
    for part in ["", "2", "0/3", "4/3", "a/b", "1/0", "-1/2"] {
        let message = Part::parse(part).unwrap_err().to_string();
        assert!(message.starts_with("part must be") && message.lines().count() == 1, "{message}");
    }
    let taken = folder.path().join("taken");
    std::fs::write(&taken, "a file").unwrap();
    let refused = SpeedMap::kept(read(&base).unwrap(), FEW, &taken, &|_, _| true).map(|_| ()).unwrap_err().to_string();
    assert!(refused.contains("taken: ") && refused.lines().count() == 1, "{refused}");
}

#[test]
fn what_is_asked_counts_and_not_how_it_is_written() {
    let base = text("0.01", "", "restitution = 0.0", CAM);
    let folder = tempfile::tempdir().unwrap();
    let go_on = |spec| SpeedMap::kept(spec, FEW, folder.path(), &|_, _| true).unwrap();
    let map = go_on(read(&base).unwrap());
    // Another file's name and a comment: nothing is made again.
    let spec = Spec::parse("elsewhere/valve.toml", &format!("# mine\n{base}"), &|_| Ok(String::new())).unwrap();
    assert_eq!(go_on(spec).points, map.points);
    assert_eq!(kept(folder.path()).1, 1);
    // A spec that a program changed, whose text does not say so.
    let mut changed = read(&base).unwrap();
    changed.mount = read(&base.replace("0.01", "0.03")).unwrap().mount;
    let alone = SpeedMap::of(changed.clone(), FEW, &|_, _| true).unwrap();
    assert_ne!(alone.points, map.points);
    assert_eq!(go_on(changed).points, alone.points);
    // What goes is the map's own.
    map.forget(folder.path()).unwrap();
    assert_eq!(kept(folder.path()).1, 1);
    alone.forget(folder.path()).unwrap();
    assert!(!folder.path().exists());
    alone.forget(folder.path()).unwrap();
}
