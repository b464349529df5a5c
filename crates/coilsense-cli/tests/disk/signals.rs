//! Ctrl-C and TERM: every command ends within a second, as a shell expects it, and leaves nothing.

use std::fs;
use std::process::{Child, Command, Output, Stdio};
use std::time::{Duration, Instant};

use super::answering::answering;
use super::{Place, text};

fn send(signal: &str, child: &Child) {
    assert!(Command::new("kill").args([signal, &child.id().to_string()]).status().expect("kill").success());
}

/// Starts a command, lets it get to work, and ends it; what it says, and how long it still took.
fn ended(place: &Place, arguments: &str, signal: &str) -> (Output, Duration) {
    let mut command = answering();
    command.args(arguments.split(' ')).current_dir(place.path(""));
    let mut child =
        command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().expect("starts");
    // Longer than it takes to start, much shorter than its work.
    std::thread::sleep(Duration::from_millis(300));
    let held = child.stdin.take();
    assert!(child.try_wait().expect("a child").is_none(), "{arguments}: it is through already");
    send(signal, &child);
    let begun = Instant::now();
    let output = child.wait_with_output().expect("a child");
    let took = begun.elapsed();
    drop(held);
    (output, took)
}

#[test]
fn every_command_ends_within_a_second_of_a_signal() {
    let place = Place::new();
    let examples = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples");
    fs::copy(examples.join("virtual-rig.toml"), place.path("virtual-rig.toml")).unwrap();
    assert!(Command::new("mkfifo").arg(place.path("pipe.csv")).status().unwrap().success());
    let recorded = "kind = \"recorded\"\nfile = \"pipe.csv\"";
    let spec = super::SPEC.replace("kind = \"impact\"\nvelocity = \"0.25 m/s\"\nduration = \"10 ms\"", recorded);
    fs::write(place.path("recorded.toml"), spec).unwrap();
    // Hours of a spring that is heavy to follow.
    let ratios: Vec<String> = (0..64).map(|index| format!("{}", f64::from(index) / 1000.0)).collect();
    let slow = super::SPEC.replace("damping_ratio = 0", &format!("damping_ratio = [{}]", ratios.join(", ")));
    let slow = slow.replace("\"10 ms\"", "\"20 s\"").replace("windings = 4", "windings = 10");
    fs::write(place.path("slow.toml"), slow.replace("window = [\"8 ms\", \"20 s\"]", "")).unwrap();
    let before = place.files();
    for (number, arguments) in [
        "spring /dev/stdin",
        "spring pipe.csv",
        "simulate recorded.toml --out new/run.csv",
        "simulate slow.toml --out new/run.csv",
        "analyze slow.toml --out new",
        "mitigate slow.toml --seeds 900 --out new",
        "mitigate spec.toml --log pipe.csv --out new",
        "placement recorded.toml --out new",
        "identify pipe.csv --out new",
        "calibrate pipe.csv --out new",
        "import pipe.csv --out new/run.csv",
        "import /dev/stdin --out new/run.csv",
        "sweep spec.toml --over spring.stiffness=600..900N/m --rows 1000000000 --out designs",
    ]
    .into_iter()
    .enumerate()
    {
        let (signal, code) = [("-INT", 130), ("-TERM", 143), ("-HUP", 129)][number % 3];
        // A machine with other work may be late once.
        let tries = (0..3).map(|_| ended(&place, arguments, signal)).find(|(output, took)| {
            let said = text(&output.stderr);
            assert_eq!(output.status.code(), Some(code), "{arguments}: {said}");
            assert!(said.starts_with("error: interrupted") && said.lines().count() == 1, "{arguments}: {said}");
            *took < Duration::from_secs(1)
        });
        assert!(tries.is_some(), "{arguments}: it took over a second, three times");
        fs::remove_dir_all(place.path("designs")).unwrap_or_default();
        assert!(place.files() == before && !place.path("new").exists(), "{arguments}: something is left");
    }
}

#[test]
fn a_signal_that_is_ignored_from_the_start_stays_so() {
    let place = Place::new();
    let mut shell = Command::new("sh");
    shell.args(["-c", "trap '' INT HUP; exec \"$0\" spring /dev/stdin", env!("CARGO_BIN_EXE_coilsense")]);
    let mut child =
        shell.current_dir(place.path("")).stdin(Stdio::piped()).stderr(Stdio::piped()).spawn().expect("it starts");
    std::thread::sleep(Duration::from_millis(300));
    send("-INT", &child);
    send("-HUP", &child);
    std::thread::sleep(Duration::from_millis(900));
    // Linux says which signals are ignored; elsewhere the command cannot know.
    if cfg!(target_os = "linux") {
        assert!(child.try_wait().expect("a child").is_none());
        // Who waits closes a child's input, by which it would end before the signal on a machine with other work.
        let _open = child.stdin.take();
        send("-TERM", &child);
        assert_eq!(child.wait().expect("a child").code(), Some(143));
    }
    let _ = child.kill();
    let _ = child.wait();
}

#[test]
fn a_sweep_that_is_ended_goes_on_where_it_was() {
    let place = Place::new();
    let run = "sweep spec.toml --over spring.stiffness=600..900N/m --rows 4000 --chunk 20 --jobs 1 --out designs";
    let child = place.command(run).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().expect("it starts");
    let begun = Instant::now();
    let chunks = || fs::read_dir(place.path("designs")).map_or(0, Iterator::count);
    while chunks() < 4 {
        assert!(begun.elapsed() < Duration::from_secs(60), "it never began");
        std::thread::sleep(Duration::from_millis(2));
    }
    send("-TERM", &child);
    let output = child.wait_with_output().expect("a child");
    let said = text(&output.stderr);
    assert_eq!(output.status.code(), Some(143), "{said}");
    assert!(said.contains("the same command goes on from there"), "{said}");
    let there = chunks();
    let told = place.done(run);
    assert!(told.contains("from before") && there >= 4 && told.contains("4000 rows"), "{told}");
}
