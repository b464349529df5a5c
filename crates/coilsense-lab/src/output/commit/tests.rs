//! Runs that end, or fail, at each of their steps.
//!
//! Next door: runs of the command that are killed (`coilsense-cli/tests/killed.rs`).

use std::cell::Cell;
use std::collections::BTreeMap;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use super::NEW;
use crate::output::Staging;

/// What becomes of a run: how many steps it still makes, and whether all steps after these fail or only the next one.
#[derive(Clone, Copy)]
enum End {
    Never,
    /// As if the process were killed: nothing is done any more.
    Killed(usize),
    /// As if the system refused one step; of those after it, so many are made.
    Refused(usize, usize),
}

thread_local! {
    static END: Cell<End> = const { Cell::new(End::Never) };
}

pub(super) fn step() -> io::Result<()> {
    let (left, made) = match END.get() {
        End::Never => return Ok(()),
        End::Killed(0) => (End::Killed(0), false),
        End::Killed(steps) => (End::Killed(steps - 1), true),
        End::Refused(0, after) => (End::Killed(after), false),
        End::Refused(steps, after) => (End::Refused(steps - 1, after), true),
    };
    END.set(left);
    if made { Ok(()) } else { Err(io::ErrorKind::StorageFull.into()) }
}

/// All files below a folder.
fn files(folder: &Path) -> BTreeMap<PathBuf, String> {
    let mut found = BTreeMap::new();
    for entry in fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()) {
        match entry.is_dir() {
            true => found.extend(files(&entry)),
            false => drop(found.insert(entry.clone(), fs::read_to_string(&entry).unwrap())),
        }
    }
    found
}

/// A folder with what an earlier run and somebody else left there.
fn place() -> tempfile::TempDir {
    let place = tempfile::tempdir().unwrap();
    fs::create_dir(place.path().join("figures")).unwrap();
    for name in ["report.html", "figures/one.svg", "gone.csv", "gone-too.csv"] {
        fs::write(place.path().join(name), "old").unwrap();
    }
    fs::write(place.path().join("mine.txt"), "mine").unwrap();
    place
}

const NEW_FILES: [&str; 4] = ["report.html", "figures/one.svg", "figures/two.svg", "deep/er/three.csv"];
const GONE: [&str; 2] = ["gone.csv", "gone-too.csv"];

/// A run into that folder.
fn run(folder: &Path, end: End) -> (bool, Staging) {
    let staging = Staging::within(folder).unwrap();
    for name in NEW_FILES {
        let file = staging.path().join(NEW).join(name);
        fs::create_dir_all(file.parent().unwrap()).unwrap();
        fs::write(file, "new").unwrap();
    }
    END.set(end);
    let done = super::run(staging.path(), folder, &NEW_FILES.map(PathBuf::from), &GONE.map(PathBuf::from));
    END.set(End::Never);
    (done.is_ok(), staging)
}

fn is_old(folder: &Path) -> bool {
    files(folder) == files(place().path()).into_iter().map(|(file, text)| (moved(&file, folder), text)).collect()
}

fn is_new(folder: &Path) -> bool {
    let text = |name: &str| (folder.join(name), if name == "mine.txt" { "mine" } else { "new" }.to_owned());
    files(folder) == NEW_FILES.into_iter().chain(["mine.txt"]).map(text).collect()
}

/// The same file of another folder.
fn moved(file: &Path, folder: &Path) -> PathBuf {
    let depth = std::env::temp_dir().components().count() + 1;
    file.components().skip(depth).fold(folder.to_owned(), |path, part| path.join(part))
}

/// Steps of a run that nothing disturbs.
fn steps() -> usize {
    const MANY: usize = 1000;
    let place = place();
    let (done, _staging) = run(place.path(), End::Killed(MANY));
    assert!(done && place.path().join("deep/er/three.csv").exists());
    (1..MANY).find(|steps| run(self::place().path(), End::Killed(*steps)).0).unwrap()
}

#[test]
fn a_run_that_is_killed_at_any_step_is_brought_to_one_of_its_ends_by_the_next() {
    let steps = steps();
    assert!(steps > NEW_FILES.len() + GONE.len(), "{steps}");
    let mut ends = [0, 0];
    for made in 0..=steps {
        let place = place();
        let (_, killed) = run(place.path(), End::Killed(made));
        killed.lose();
        // At no time is a file missing that was there before and stays.
        for name in &NEW_FILES[..2] {
            assert!(place.path().join(name).exists(), "{name} after {made} steps");
        }
        drop(Staging::within(place.path()).unwrap());
        let (old, new) = (is_old(place.path()), is_new(place.path()));
        assert!(old != new, "after {made} steps: {:?}", files(place.path()));
        ends[usize::from(new)] += 1;
    }
    assert!(ends[0] >= 4 && ends[1] > NEW_FILES.len(), "{ends:?}");
}

#[test]
fn a_step_that_is_refused_leaves_what_was_there_even_where_undoing_it_is_killed() {
    for made in 0..steps() - 1 {
        for after in 0..12 {
            let place = place();
            let (done, killed) = run(place.path(), End::Refused(made, after));
            if done {
                // Only the journal of a run that was through already could not be removed.
                assert_eq!(made + 2, steps());
                continue;
            }
            // Killed, or only refused: what was there is not thrown away before it is back.
            if after % 2 == 0 {
                killed.lose()
            } else {
                drop(killed)
            }
            drop(Staging::within(place.path()).unwrap());
            assert!(is_old(place.path()) || is_new(place.path()), "{made}, {after}: {:?}", files(place.path()));
        }
        let place = place();
        let (done, staging) = run(place.path(), End::Refused(made, 1000));
        drop(staging);
        assert!(done || is_old(place.path()), "{made}: {:?}", files(place.path()));
    }
}

#[test]
fn what_somebody_changed_after_the_kill_stays() {
    for made in 0..=steps() {
        let place = place();
        let (_, killed) = run(place.path(), End::Killed(made));
        killed.lose();
        for name in ["report.html", "gone.csv"] {
            let _ = fs::remove_file(place.path().join(name));
            fs::write(place.path().join(name), "changed since").unwrap();
        }
        drop(Staging::within(place.path()).unwrap());
        for name in ["report.html", "gone.csv"] {
            assert_eq!(fs::read_to_string(place.path().join(name)).unwrap(), "changed since", "{name}, {made}");
        }
    }
}

#[test]
fn what_is_not_ours_or_lives_is_left_alone() {
    let place = place();
    let living = Staging::within(place.path()).unwrap();
    for (name, file) in [(".coilsense-mine", "lock"), (".coilsense-1-a", "lock"), (".coilsense-77-1", "notes.txt")] {
        fs::create_dir(place.path().join(name)).unwrap();
        fs::write(place.path().join(name).join(file), "mine").unwrap();
    }
    // A journal that would write elsewhere.
    let hostile = place.path().join(".coilsense-77-2");
    fs::create_dir_all(hostile.join("new")).unwrap();
    for (name, text) in
        [("lock", ""), ("new/x", "x"), ("journal", r#"{"way":"forward","new":["../x"],"removed":["/x"],"kept":[]}"#)]
    {
        fs::write(hostile.join(name), text).unwrap();
    }
    fs::create_dir(place.path().join(".coilsense-77-3")).unwrap();
    drop(Staging::within(&place.path().join("figures")).unwrap());
    assert!(living.path().exists() && hostile.exists() && !place.path().parent().unwrap().join("x").exists());
    for name in [".coilsense-mine/lock", ".coilsense-1-a/lock", ".coilsense-77-1/notes.txt"] {
        assert!(place.path().join(name).exists(), "{name}");
    }
    // Killed before it had a lock.
    assert!(!place.path().join(".coilsense-77-3").exists());
}
