//! Folders that are written, and what must not be replaced in them.
//!
//! Next door: runs that end in the middle (`commit`).

use std::path::{Path, PathBuf};

use super::{Output, OutputError, WRITTEN};

/// What a folder holds besides the list of what was written.
fn count(folder: &Path) -> usize {
    std::fs::read_dir(folder).unwrap().filter(|entry| entry.as_ref().unwrap().file_name() != WRITTEN).count()
}

fn write(folder: &Path, files: &[(&str, &str)]) -> Result<usize, OutputError> {
    let mut output = Output::begin(folder)?;
    files.iter().try_for_each(|(name, text)| output.add(name, text.as_bytes()))?;
    output.commit()
}

fn read(path: PathBuf) -> String {
    std::fs::read_to_string(path).unwrap()
}

#[test]
fn nothing_is_seen_before_the_commit_and_nothing_stays_without_it() {
    let place = tempfile::tempdir().unwrap();
    let target = place.path().join("a/b");
    let mut output = Output::begin(&target).unwrap();
    output.add("figures/one.svg", b"<svg/>").unwrap();
    assert!(!target.exists());
    drop(output);
    assert_eq!(std::fs::read_dir(place.path()).unwrap().count(), 0);
}

#[test]
fn a_commit_replaces_its_own_files_and_keeps_the_others() {
    let place = tempfile::tempdir().unwrap();
    let path = |name: &str| place.path().join(name);
    std::fs::write(path("mine.txt"), "mine").unwrap();
    write(place.path(), &[("report.html", "old")]).unwrap();
    assert_eq!(write(place.path(), &[("report.html", "new"), ("deep/er.csv", "1")]).unwrap(), 2);
    assert_eq!(read(path("mine.txt")), "mine");
    assert_eq!(read(path("report.html")), "new");
    assert_eq!(count(place.path()), 3);
}

#[test]
fn what_is_in_the_way_of_a_commit_is_named_and_nothing_changes() {
    let place = tempfile::tempdir().unwrap();
    let path = |name: &str| place.path().join(name);
    std::fs::write(path("a.txt"), "old").unwrap();
    std::fs::create_dir(path("report.html")).unwrap();
    std::fs::write(path("signals"), "a file").unwrap();
    for (obstacle, word) in [("report.html", "folder"), ("signals/one.csv", "file")] {
        let mut output = Output::begin(place.path()).unwrap().overwriting(true);
        output.add("a.txt", b"new").unwrap();
        output.add("b/c.txt", b"new").unwrap();
        output.add(obstacle, b"new").unwrap();
        let error = output.commit().unwrap_err().to_string();
        let named = path(obstacle.split('/').next().unwrap());
        assert!(error.starts_with(&format!("{}: is a {word}", named.display())), "{error}");
        assert_eq!(std::fs::read_to_string(path("a.txt")).unwrap(), "old");
        assert_eq!(count(place.path()), 3);
    }
}

#[test]
fn a_file_of_an_earlier_run_is_removed_unless_it_is_written_again() {
    let place = tempfile::tempdir().unwrap();
    write(place.path(), &[("one.csv", "old"), ("two.csv", "old"), ("four.csv", "old")]).unwrap();
    for (name, text) in [("mine.csv", "mine"), ("four.csv", "mended"), ("five.csv", "mine")] {
        std::fs::write(place.path().join(name), text).unwrap();
    }
    let mut output = Output::begin(place.path()).unwrap();
    output.add("one.csv", b"new").unwrap();
    for name in ["one.csv", "two.csv", "three.csv", "four.csv", "five.csv"] {
        output.remove(name);
    }
    output.commit().unwrap();
    assert_eq!(std::fs::read_to_string(place.path().join("one.csv")).unwrap(), "new");
    assert!(!place.path().join("two.csv").exists() && place.path().join("mine.csv").exists());
    // What somebody has changed, or made himself, stays, whatever its name.
    assert_eq!([read(place.path().join("four.csv")), read(place.path().join("five.csv"))], ["mended", "mine"]);
    assert_eq!(read(place.path().join(WRITTEN)).lines().count(), 3, "the head, one.csv, and four.csv, which is there");
}

#[test]
fn what_coilsense_did_not_write_or_somebody_has_changed_is_replaced_only_where_that_is_asked_for() {
    let place = tempfile::tempdir().unwrap();
    let path = place.path().join("a.csv");
    std::fs::write(&path, "mine").unwrap();
    let error = write(place.path(), &[("a.csv", "new")]).unwrap_err().to_string();
    let told = "is there, and coilsense did not write it; name another, or replace it with --overwrite";
    assert_eq!(error, format!("{}: {told}", path.display()));
    assert_eq!((read(path.clone()), count(place.path())), ("mine".to_owned(), 1));
    let over = |text: &[u8]| {
        let mut output = Output::begin(place.path()).unwrap().overwriting(true);
        output.add("a.csv", text).unwrap();
        output.commit().unwrap();
    };
    over(b"new");
    write(place.path(), &[("a.csv", "newer")]).unwrap();
    assert_eq!(read(path.clone()), "newer");
    std::fs::write(&path, "newer, and mended by hand").unwrap();
    let error = write(place.path(), &[("a.csv", "newest")]).unwrap_err().to_string();
    assert!(error.contains("has changed since coilsense wrote it"), "{error}");
    over(b"newest");
    // A folder that is copied keeps its list.
    let other = place.path().join("copy");
    std::fs::create_dir(&other).unwrap();
    for name in ["a.csv", WRITTEN] {
        std::fs::copy(place.path().join(name), other.join(name)).unwrap();
    }
    write(&other, &[("a.csv", "again")]).unwrap();
}

#[test]
fn a_folder_that_appears_meanwhile_takes_the_files_one_by_one() {
    let place = tempfile::tempdir().unwrap();
    for (target, first) in [("a/b", "a"), ("c/d/e", "c/d/e"), ("f", "f")] {
        let target = place.path().join(target);
        let mut output = Output::begin(&target).unwrap();
        output.add("x/new.csv", b"new").unwrap();
        write(&place.path().join(first), &[("x/other.csv", "other")]).unwrap();
        assert_eq!(output.commit().unwrap(), 1);
        assert_eq!(read(target.join("x/new.csv")), "new");
        assert_eq!(read(place.path().join(first).join("x/other.csv")), "other");
        assert!(read(target.join(WRITTEN)).contains("x/new.csv"));
    }
    assert_eq!(count(place.path()), 3);
}

#[cfg(unix)]
#[test]
fn a_device_and_a_way_up_from_nowhere_are_named() {
    let (output, name) = Output::of_file(Path::new("/dev/null")).unwrap_or_else(|_| {
        // Whoever may not write there is told so.
        Output::of_file(&std::env::temp_dir().join("x")).unwrap()
    });
    if name == "null" {
        assert!(output.check(&name).unwrap_err().to_string().starts_with("/dev/null: is no file but a device"));
    }
    let place = tempfile::tempdir().unwrap();
    let error = Output::begin(&place.path().join("not/there/../out")).unwrap_err().to_string();
    assert!(error.ends_with("goes up from a folder that is not there"), "{error}");
    assert_eq!(count(place.path()), 0);
}

#[test]
fn a_file_in_the_way_is_named() {
    let place = tempfile::tempdir().unwrap();
    let file = place.path().join("file");
    std::fs::write(&file, "").unwrap();
    for target in [file.clone(), file.join("below")] {
        let error = Output::begin(&target).unwrap_err().to_string();
        assert!(error.starts_with(&target.display().to_string()), "{error}");
    }
}
