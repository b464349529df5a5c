//! A window that begins after the ringing: what it leaves out is told, and nothing is where nothing louder was left out.

use coilsense_lab::analysis::{Analysis, Check, Sooner, Subject, answer};

use super::{S_T, run, verdict};

const SENSORS: &str = "[[sensor]]\nkind = \"load-cell\"\nname = \"cell\"\naccuracy_full_scale = \"0.02 %\"\n[[sensor]]\nkind = \"deflection\"\nname = \"laser\"\n\
                       accuracy_full_scale = \"0.1 %\"\n[goal]\nerror = \"0.5 %\"\n";

/// S_T with a damping, one condition, and both sensors.
fn of(ratio: f64, condition: &str) -> Analysis {
    let mount = format!("[mount]\ndamping_ratio = {ratio}\n[uncertainty]\ntrials = 1000\n");
    run(&format!("{S_T}\n{mount}[[condition]]\n{condition}\n{SENSORS}"))
}

fn told(analysis: &Analysis, sensor: &str) -> Option<Sooner> {
    verdict(analysis, sensor).sooner
}

const STRIKE: &str = "kind = \"impact\"\nvelocity = \"0.25 m/s\"\n";

#[test]
fn a_stop_whose_ringing_has_faded_is_told_with_what_was_left_out() {
    let late = of(0.02, &format!("{STRIKE}window = [\"0.75 s\", \"1 s\"]"));
    let sooner = told(&late, "cell").unwrap();
    assert_eq!(sooner.window, (0.0, 0.2499));
    // The same part, asked for by the spec.
    let soon = of(0.02, &format!("{STRIKE}window = [\"0 s\", \"0.2499 s\"]"));
    let asked = verdict(&soon, "cell").at_worst().nominal;
    assert!((sooner.error / asked - 1.0).abs() < 1e-12, "{sooner:?} {asked}");
    // The first mode alone, 4kv/ω e^(−ζωt), has an rms of 4kv/ω √((1 − e^(−2ζωT)) / 4ζωT); the third and fifth add a ninth of its variance and less.
    let (spring, angular) = (coilsense::paper::s_t(), 54.057 * std::f64::consts::TAU);
    let (decay, amplitude) = (0.02 * angular, 4.0 * spring.stiffness() * 0.25 / angular);
    let first = amplitude * ((1.0 - (-2.0 * decay * 0.25).exp()) / (4.0 * decay * 0.25)).sqrt();
    assert!((1.0..1.1).contains(&(sooner.error / first)), "{} {first}", sooner.error);
    // Ends that stand carry no surge to a laser.
    assert!(told(&late, "laser").is_none(), "{:?}", told(&late, "laser"));

    let words = &answer(&late)[0];
    assert!(words.starts_with("Choose cell. Both sensors meet the goal of 0.608 N (0.5 % of F_nom)."), "{words}");
    assert!(
        words.contains("; before the window of impact, from 0 to 0.25 s, it errs by 0.868 N (0.714 % of F_nom) rms, which misses the goal"),
        "{words}"
    );
    assert!(words.contains("rms, which misses the goal (laser meets it there too). Of the springs"), "{words}");
    // Where the goal is met there as well, or none is set: a warning, and the figure of what was asked for.
    let easy = run(&format!(
        "{S_T}\n[mount]\ndamping_ratio = 0.02\n[[condition]]\n{STRIKE}window = [\"0.75 s\", \"1 s\"]\n{}",
        SENSORS.replace("0.5 %", "1 %")
    ));
    assert!(
        !answer(&easy)[0].contains("before the window")
            && answer(&easy).concat().contains("a window begins after the loudest part")
    );
    let none = run(&format!(
        "{S_T}\n[mount]\ndamping_ratio = 0.02\n[[condition]]\n{STRIKE}window = [\"0.75 s\", \"1 s\"]\n{}",
        SENSORS.split("[goal]").next().unwrap()
    ));
    assert!(
        answer(&none)[0].contains("; before the window of impact, from 0 to 0.25 s, it errs by 0.868 N")
            && !answer(&none)[0].contains("misses")
    );
    assert!(
        matches!(Check::of(&late), Check::Undecided(why) if why == "in impact cell misses the goal before the window begins; begin the window at 0 s")
    );
    assert_eq!(Check::of(&easy), Check::Met("cell".to_owned()));
    let warned = |analysis: &Analysis| analysis.warnings.iter().filter(|w| w.subject == Subject::Window).count();
    let text = &late.warnings.iter().find(|warning| warning.subject == Subject::Window).unwrap().text;
    assert!(
        text.contains("the window leaves out what comes before 0.75 s")
            && text.contains("cell 0.868 N instead of 0.0150 N"),
        "{text}"
    );
    assert_eq!((warned(&late), warned(&soon)), (1, 0));
    assert!(told(&soon, "cell").is_none() && answer(&soon)[0].starts_with("Choose laser. One of 2 sensors meets"));
}

#[test]
fn ringing_that_lasts_and_motion_that_goes_on_are_not_told() {
    // Undamped, one quarter of a second is like the other.
    assert!(told(&of(0.0, &format!("{STRIKE}window = [\"0.75 s\", \"1 s\"]")), "cell").is_none());
    // Sines that begin from rest are judged once they have settled.
    let sine = "kind = \"harmonic\"\nfrequency = \"0.9 f1\"\namplitude = \"1 %\"\nwindow = [\"0.75 s\", \"1 s\"]";
    assert!(told(&of(0.02, sine), "cell").is_none());
    // A window that leaves out less than a sample, and one that leaves out what comes before a step.
    assert!(told(&of(0.02, &format!("{STRIKE}window = [\"0.1 ms\", \"1 s\"]")), "cell").is_none());
    let step = "kind = \"step\"\namplitude = \"1 %\"\nbegin = \"0.5 s\"\nwindow = [\"0.5 s\", \"1 s\"]";
    assert!(told(&of(0.02, step), "cell").is_none());
}

#[test]
fn what_follows_a_step_counts_from_the_step_on() {
    for kind in ["kind = \"step\"", "kind = \"ramp\"\nrise_time = \"1 ms\"", "kind = \"pulse\"\nwidth = \"1 ms\""] {
        let condition = format!("{kind}\namplitude = \"1 %\"\nbegin = \"0.2 s\"\nwindow = [\"0.8 s\", \"1 s\"]");
        let sooner = told(&of(0.02, &condition), "cell").unwrap();
        assert!(sooner.window.0 == 0.2 && (sooner.window.1 - 0.3999).abs() < 1e-12, "{kind}: {sooner:?}");
    }
    // What is left out is shorter than what is judged.
    let step = "kind = \"step\"\namplitude = \"1 %\"\nwindow = [\"0.2 s\", \"1 s\"]";
    assert!((told(&of(0.02, step), "cell").unwrap().window.1 - 0.1999).abs() < 1e-12);
}

#[test]
fn what_is_left_of_a_ringing_that_is_over_is_not_said_to_hang_on_a_frequency() {
    // 3e-12 N: from spring to spring it differs twofold, and decides nothing.
    let tolerance = S_T.replacen("[spring]", "[spring]\nstiffness_tolerance = \"5 %\"", 1);
    let of = |ratio: f64| {
        let mount = format!("[mount]\ndamping_ratio = {ratio}\n[uncertainty]\ntrials = 1000\n");
        let cell = "[[sensor]]\nkind = \"load-cell\"\nname = \"cell\"\n[goal]\nerror = \"0.5 %\"\n";
        run(&format!("{tolerance}\n{mount}[[condition]]\n{STRIKE}window = [\"0.75 s\", \"1 s\"]\n{cell}"))
    };
    let quiet = of(0.1);
    assert!(verdict(&quiet, "cell").at_worst().loudest < 1e-11);
    assert!(quiet.warnings.iter().all(|warning| warning.subject != Subject::Resonance), "{:?}", quiet.warnings);
    assert!(!answer(&quiet).concat().contains("cannot be told more closely"));
    // What was left out is told all the same, 0.401 N of 0.608.
    assert!(quiet.warnings.iter().any(|warning| warning.subject == Subject::Window), "{:?}", quiet.warnings);
}

#[test]
fn sweeps_and_recordings_are_looked_at_before_the_window_too() {
    // From 5 to 90 Hz within a second, through f1 = 54 Hz at 0.58 s: what is judged comes after, or is that.
    let sweep = |window: &str| {
        let keys = "kind = \"sweep\"\nfrequency = [\"5 Hz\", \"90 Hz\"]\namplitude = \"1 %\"\n";
        of(0.02, &format!("{keys}window = [{window}]"))
    };
    let late = told(&sweep("\"0.9 s\", \"1 s\""), "cell").unwrap();
    assert!((0.5..0.7).contains(&late.window.0), "{late:?}");
    assert!(told(&sweep("\"0.55 s\", \"0.75 s\""), "cell").is_none(), "the loudest part is judged");
    // Half a sine of 10 ms at 0.3 s, as a file; the loudest part is found wherever it lies, to half a window.
    let rows: String = (0..=1000)
        .map(|n| f64::from(n) * 1e-3)
        .map(|t| {
            let u1 = if (0.3..0.31).contains(&t) { (std::f64::consts::PI * (t - 0.3) / 0.01).sin() } else { 0.0 };
            format!("{t},{u1},0\n")
        })
        .collect();
    let text = format!(
        "{S_T}\n[mount]\ndamping_ratio = 0.02\n[uncertainty]\ntrials = 1000\n[[condition]]\nkind = \"recorded\"\nfile = \"bump.csv\"\n\
         window = [\"0.8 s\", \"0.9 s\"]\n{SENSORS}"
    );
    let files = |_: &str| Ok(format!("time [s],u1 [mm],u2 [mm]\n{rows}"));
    let spec = coilsense_lab::spec::Spec::parse("bump.toml", &text, &files).unwrap();
    let late = told(&Analysis::run(spec, &|_, _| true).unwrap(), "cell").unwrap();
    assert!((0.2..=0.3).contains(&late.window.0) && late.window.1 > 0.31, "{late:?}");
}
