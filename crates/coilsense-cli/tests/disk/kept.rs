//! What is never overwritten, what is only where that is asked for, and names that would move a terminal.

use std::fs;
use std::os::unix::fs::symlink;

use super::{Place, WRITING};

#[test]
fn what_is_read_is_never_overwritten_by_whatever_name_it_is_called() {
    let place = Place::whole();
    let log = "time [s],u1 [mm]\n0,0\n0.005,1\n0.01,2\n";
    fs::write(place.path("my.csv"), log).unwrap();
    let recorded = super::SPEC.replace(
        "kind = \"impact\"\nvelocity = \"0.25 m/s\"\nduration = \"10 ms\"",
        "kind = \"recorded\"\nfile = \"my.csv\"",
    );
    fs::write(place.path("my.toml"), recorded).unwrap();
    fs::write(place.path("mapping.toml"), "[columns]\nu2 = \"l\"\n").unwrap();
    fs::create_dir(place.path("sub")).unwrap();
    for (name, of) in [("link.csv", "my.csv"), ("sub/link.toml", "../spec.toml"), ("hit.csv", "bench/hit-1-fast.csv")] {
        symlink(of, place.path(name)).unwrap();
    }
    fs::hard_link(place.path("my.csv"), place.path("hard.csv")).unwrap();
    let before = place.files();
    for (arguments, named) in [
        ("simulate my.toml --one-file --out my.csv", "my.csv"),
        ("simulate my.toml --one-file --out ./sub/../my.csv", "my.csv"),
        ("simulate my.toml --one-file --out link.csv", "link.csv"),
        ("simulate my.toml --one-file --out hard.csv", "hard.csv"),
        ("export spec.toml --as c --out sub/link.toml", "link.toml"),
        ("identify bench/hit-1-fast.csv --spec spec.toml --spec-out bench/hit-1-fast.csv", "hit-1-fast.csv"),
        ("identify bench/hit-1-fast.csv --spec spec.toml --spec-out spec.toml", "spec.toml"),
        ("import bench/hit-1-fast.csv --to 0.05s --out bench/hit-1-fast.csv", "hit-1-fast.csv"),
        ("import bench/hit-1-fast.csv --to 0.05s --out hit.csv", "hit.csv"),
        ("import hit.csv --to 0.05s --out bench/hit-1-fast.csv", "hit-1-fast.csv"),
        ("import hit.csv --with bench/hit-1-slow.csv --out bench/hit-1-slow.csv", "hit-1-slow.csv"),
        ("import points.csv --mapping mapping.toml --out mapping.toml.csv", ""),
        ("export spec.toml --as c --out spec.toml", "spec.toml"),
    ] {
        for more in ["", " --overwrite"] {
            let output = place.run(&format!("{arguments}{more}"));
            let message = super::refusal(arguments, &output);
            let told =
                format!("{named}: is read by this command, and is not overwritten; name another file to write\n");
            assert!(named.is_empty() || message.ends_with(&told), "{arguments}{more}: {message}");
            assert!(place.files() == before, "{arguments}{more}");
        }
    }
}

#[test]
fn what_coilsense_wrote_is_replaced_and_all_else_only_where_that_is_asked_for() {
    let place = Place::whole();
    for arguments in WRITING {
        place.done(arguments);
        // Init keeps even its own.
        if !arguments.starts_with("init") {
            place.done(arguments);
        }
        let written = super::files(&place.path("new"));
        assert!(!written.is_empty(), "{arguments}");
        let file = written.keys().next().unwrap();
        fs::write(file, "mine").unwrap();
        let before = place.files();
        let message = place.refusal(arguments);
        assert!(
            message.contains("--overwrite") && message.contains(file.file_name().unwrap().to_str().unwrap()),
            "{message}"
        );
        fs::remove_dir_all(place.path("new.points")).unwrap_or_default();
        assert!(place.files() == before, "{arguments}");
        place.done(&format!("{arguments} --overwrite"));
        assert_ne!(fs::read(file).unwrap(), b"mine", "{arguments}");
        fs::remove_dir_all(place.path("new")).unwrap();
    }
}

#[test]
fn what_a_name_would_do_to_a_terminal_is_shown() {
    let place = Place::new();
    let name = "a\u{1b}[2J\u{1b}]0;b\u{7}\u{202e}c.toml";
    fs::write(place.path(name), super::SPEC.replace("\"strike\"", "\"x\\u001b[8my\"")).unwrap();
    fs::write(place.path("b\u{1b}[2J\nerror: c.toml"), "no = spec").unwrap();
    for arguments in [
        vec!["spring", name],
        vec!["spring", "b\u{1b}[2J\nerror: c.toml"],
        vec!["spring", "not\u{1b}[2Jthere"],
        vec!["simulate", name, "--out", "\u{1b}[2J.csv"],
        vec!["spring", "--\u{1b}[2J"],
        vec!["simulate", name, "--json", "--out", "\u{9b}2J.csv"],
    ] {
        let mut command = place.command("spring");
        command = {
            let mut with = std::process::Command::new(command.get_program());
            with.args(&arguments).current_dir(place.path(""));
            with
        };
        let output = command.output().unwrap();
        for said in [&output.stdout, &output.stderr] {
            let said = super::text(said);
            let is_plain = |sign: char| sign == '\n' || !(sign.is_control() || sign == '\u{202e}');
            assert!(said.chars().all(is_plain), "{arguments:?}: {said:?}");
        }
        let said = super::text(&output.stdout) + &super::text(&output.stderr);
        assert!(said.contains("[2J") || said.contains("2J.csv"), "{arguments:?}: {said}");
        assert!(!said.contains("\nerror: c.toml"), "{said}");
    }
}
