//! A disk that takes no more, and folders that take nothing: every command says so in a line, and leaves nothing half-written.

use std::fs::{self, File};
use std::io::Read;
use std::os::unix::fs::PermissionsExt;
use std::path::Path;
use std::process::{Command, Stdio};

use super::{Place, WRITING, refusal, text};

/// What says something on standard output, beside [`WRITING`].
const SAYING: [&str; 10] = [
    "--help",
    "--version",
    "help spring",
    "sweep --help",
    "init --from S_A",
    "init --sensors",
    "spring --materials",
    "spring spec.toml",
    "spring spec.toml --json",
    "placement sea-ankle.toml --json",
];

#[test]
fn words_that_a_full_disk_does_not_take_are_an_error_of_every_command() {
    let place = Place::whole();
    for arguments in SAYING.into_iter().chain(WRITING) {
        let full = File::options().write(true).open("/dev/full").expect("/dev/full");
        let output = place.command(arguments).stdout(full).stderr(Stdio::piped()).output().expect("it starts");
        let told = "error: standard output: cannot be written: no space left on device\n";
        let message = text(&output.stderr);
        assert_eq!(
            (output.status.code(), message.lines().last().map(|line| format!("{line}\n"))),
            (Some(2), Some(told.to_owned())),
            "{arguments}"
        );
        fs::remove_dir_all(place.path("new")).unwrap_or_default();
    }
}

#[test]
fn a_reader_that_leaves_early_has_all_it_wants() {
    let place = Place::new();
    for arguments in ["--help", "--version", "init", "spring spec.toml", "spring spec.toml --json"] {
        let mut child =
            place.command(arguments).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().expect("it starts");
        drop(child.stdout.take());
        let mut said = String::new();
        child.stderr.take().expect("piped").read_to_string(&mut said).expect("text");
        assert!(child.wait().expect("a child").success() && said.is_empty(), "{arguments}: {said}");
    }
}

/// No file may grow beyond a few blocks: what a disk does that is full in the middle.
fn limited(place: &Place, arguments: &str, blocks: u32) -> std::process::Output {
    let mut shell = Command::new("sh");
    let run = format!("trap '' XFSZ; ulimit -f {blocks}; exec \"$0\" \"$@\"");
    shell.args(["-c", &run, env!("CARGO_BIN_EXE_coilsense")]).args(arguments.split(' '));
    shell.current_dir(place.path("")).output().expect("a shell")
}

#[test]
fn a_disk_that_is_full_in_the_middle_leaves_what_was_there() {
    let place = Place::whole();
    for arguments in WRITING {
        let before = place.files();
        let output = limited(&place, arguments, 0);
        let message = refusal(arguments, &output);
        assert!(message.contains(": cannot be written: file too large"), "{arguments}: {message}");
        assert!(output.stdout.is_empty(), "{arguments}");
        // A map of speeds goes on from the points that it has.
        fs::remove_dir_all(place.path("new.points")).unwrap_or_default();
        assert!(place.files() == before && !place.path("new").exists(), "{arguments}");
    }
}

#[test]
fn a_folder_that_takes_nothing_is_named_by_every_command() {
    let place = Place::whole();
    let closed = place.path("closed");
    fs::create_dir(&closed).unwrap();
    fs::set_permissions(&closed, fs::Permissions::from_mode(0o555)).unwrap();
    // Who may write everywhere is stopped only by a folder that is none of the disk.
    let is_all_powerful = File::create(closed.join("x")).is_ok();
    let closed = if is_all_powerful { Path::new("/proc/self/fdinfo") } else { closed.as_path() };
    for arguments in WRITING {
        let before = place.files();
        let there = arguments.replace("--out new", &format!("--out {}", closed.display()));
        let message = place.refusal(&there);
        assert!(message.starts_with(&format!("error: {}", closed.display())), "{arguments}: {message}");
        assert!(message.contains(": cannot be written: "), "{arguments}: {message}");
        assert!(!message.contains(".coilsense"), "{arguments}: {message}");
        assert_eq!(place.files().len(), before.len(), "{arguments}");
    }
}
