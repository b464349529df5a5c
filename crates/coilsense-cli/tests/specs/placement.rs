//! `coilsense placement`.

use coilsense::modes::ChainModes;

use super::{done, names, path, place, refused};

const CONTINUOUS: &str = r#"
[mount]
damping_ratio = [0, 0.005, 0.02]
[control]
drive = "velocity"
"#;

fn json(tables: &str) -> serde_json::Value {
    let (_place, spec) = place(tables);
    serde_json::from_str(&done(&["placement", path(&spec), "--json"])).expect("JSON")
}

/// What a result says of a force.
pub(super) fn candidate<'a>(result: &'a serde_json::Value, name: &str) -> &'a serde_json::Value {
    result["candidates"].as_array().unwrap().iter().find(|candidate| candidate["force"] == name).unwrap()
}

#[test]
fn the_placement_rule_is_what_the_command_answers() {
    let result = json(CONTINUOUS);
    let spring = coilsense_lab::spec::Spec::parse(
        "S_T",
        include_str!("../../../coilsense-lab/data/springs/S_T.toml"),
        &|_| unreachable!(),
    );
    let surge = ChainModes::of(&spring.unwrap().spring.spring).frequencies()[0] / std::f64::consts::TAU;
    let force = |name: &str| candidate(&result, name);
    // ζ f_1, to the 0.5 % that the higher modes may add.
    for (index, ratio) in [0.005, 0.02].into_iter().enumerate() {
        let limit = force("F_o")["dampings"][index]["stable_crossover_hz"].as_f64().unwrap();
        assert!((limit / (ratio * surge) - 1.0).abs() < 5e-3, "{limit} at {ratio}");
    }
    for name in ["F_i", "F_x"] {
        assert!(force(name)["stable_crossover_hz"].is_null(), "{name} has no limit");
    }
    assert_eq!(result["feed_back"], "F_i");
    assert!(
        result["answer"].as_array().unwrap().iter().any(|line| line.as_str().unwrap().contains("ζ = 0) is left out"))
    );
}

#[test]
fn a_sampled_loops_limit_holds_over_time() {
    let tables =
        "[mount]\ndamping_ratio = 0.01\n[control]\ndrive = \"velocity\"\nsample_time = \"0.5 ms\"\ndelay = \"1 ms\"\n";
    let result = json(tables);
    assert_eq!(result["limit_confirmed_over_time"], true);
    let estimates = result["estimates"].as_array().unwrap();
    assert_eq!(estimates.len(), 2);
    // A true estimate of F_o is bound as F_o is, by ζ f_1 = 0.54 Hz; on softer and heavier springs by less.
    let kalman = estimates[1]["stable_crossover_hz"].as_f64().unwrap();
    assert!((0.2..0.65).contains(&kalman), "{kalman}");
    assert!(estimates[0]["stable_crossover_hz"].as_f64().unwrap() > kalman);
}

/// Runs over time by what is fed back.
pub(super) fn over_time(result: &serde_json::Value) -> std::collections::BTreeMap<String, serde_json::Value> {
    let runs = result["over_time"].as_array().unwrap().iter();
    runs.map(|run| (run["fed_back"].as_str().unwrap().to_owned(), run.clone())).collect()
}

pub(super) fn lines(result: &serde_json::Value) -> String {
    let lines = result["answer"].as_array().unwrap().iter();
    lines.map(|line| line.as_str().unwrap()).collect::<Vec<_>>().join("\n")
}

#[test]
fn a_motors_loops_are_run_over_time_on_every_force_and_behind_every_estimator() {
    let tables = "[mount]\ndamping_ratio = 0.01\n[control]\ndrive = \"force\"\nmotor_mass = \"2 kg\"\nmotor_friction = \"30 N s/m\"\n\
                  drive_bandwidth = \"300 Hz\"\nsample_time = \"0.5 ms\"\ndelay = \"0.5 ms\"\n";
    let result = json(tables);
    let (runs, answer) = (over_time(&result), lines(&result));
    assert_eq!(runs.len(), 6, "four forces and two estimates");
    for (name, run) in &runs {
        assert_eq!((&run["limit_confirmed"], &run["stable"]), (&true.into(), &true.into()), "{name}");
        // An integral brings F_o to the reference within a second, to some per cent of the slow loop's swing.
        assert!((run["load_percent"].as_f64().unwrap() - 100.0).abs() < 3.0, "{name}: {run}");
        assert!(answer.contains(name), "{name}");
    }
    // F_L is the only one that is read off windings.
    assert!(runs["F_L"]["coil_error_percent"].as_f64().unwrap() < 0.1 && runs["F_x"]["coil_error_percent"].is_null());
    assert_eq!(result["drive"], "a motor of 2.00 kg with 30.0 N s/m of friction and a current loop of 300 Hz");
    for expected in
        ["a current loop of 300 Hz", "in samples of 0.500 ms", "Kalman", "no dry friction", "no windings that touch"]
    {
        assert!(answer.contains(expected), "{expected}: {answer}");
    }
}

#[test]
fn a_continuous_loop_is_run_over_time_and_says_so() {
    let tables = "[mount]\ndamping_ratio = 0.02\n[control]\ndrive = \"velocity\"\ndrive_bandwidth = \"60 Hz\"\ndelay = \"1 ms\"\n";
    let result = json(tables);
    for (name, run) in over_time(&result) {
        assert_eq!(run["limit_confirmed"], true, "{name}");
    }
    let answer = lines(&result);
    assert!(answer.contains("continuous, with a velocity source with a bandwidth of 60.0 Hz"), "{answer}");
    // Without a limit there is nothing to confirm, and an ideal source is called one.
    let ideal = json(CONTINUOUS);
    assert!(ideal["limit_confirmed_over_time"].is_null());
    assert!(over_time(&ideal)["F_o"]["limit_confirmed"] == true && lines(&ideal).contains("an ideal velocity source"));
}

#[test]
fn a_loop_that_is_set_too_fast_tells_no_place_where_it_settles() {
    let tables = "[mount]\ndamping_ratio = 0.01\n[control]\ndrive = \"force\"\nmotor_mass = \"2 kg\"\nmotor_friction = \"30 N s/m\"\n\
                  crossover = \"120 Hz\"\nsample_time = \"0.5 ms\"\ndelay = \"0.5 ms\"\n";
    let result = json(tables);
    let answer = lines(&result);
    for (name, run) in over_time(&result) {
        assert_eq!(run["stable"], false, "{name}");
        // It ran away, or it moves by far more than the step.
        let moves = run["load_swing_percent"].as_f64().unwrap_or(f64::INFINITY);
        assert_eq!(run["ran_away_at_s"].is_null(), moves.is_finite(), "{name}: {run}");
        assert!(moves > 1000.0, "{name}: {run}");
    }
    assert!(answer.contains("runs away, past 1e8 N after") || answer.contains("unstable, F_o moves by"), "{answer}");
    assert!(!answer.contains("F_o is at"), "{answer}");
}

#[test]
fn a_loop_that_cannot_be_run_says_why_and_is_judged_all_the_same() {
    let tables = "[mount]\ndamping_ratio = 0.01\n[control]\ndrive = \"velocity\"\ndrive_bandwidth = \"80 Hz\"\nsample_time = \"0.5 ms\"\n";
    let (place, spec) = place(tables);
    let text = std::fs::read_to_string(&spec).unwrap();
    let spec = place.path().join("long.toml");
    assert!(text.contains("masses_per_winding = 1"));
    std::fs::write(&spec, text.replace("masses_per_winding = 1", "masses_per_winding = 4")).unwrap();
    let result: serde_json::Value = serde_json::from_str(&done(&["placement", path(&spec), "--json"])).unwrap();
    let expected = "number of winding masses must be at most 200 for a run over time of this drive and load, got 208";
    assert_eq!(over_time(&result)["F_i"]["not_run"], expected);
    assert!(result["limit_confirmed_over_time"].is_null());
    assert!(lines(&result).contains(&format!("Not run over time: {expected}.")));
    assert!(result["crossover_hz"].as_f64().unwrap() > 0.0);
}

#[test]
fn a_motor_and_a_load_are_judged_too() {
    let tables = "[mount]\ndamping_ratio = 0.01\n[control]\ndrive = \"force\"\nmotor_mass = \"2 kg\"\nmotor_friction = \"30 N s/m\"\n\
                  controller = \"PID\"\ncrossover = \"3 Hz\"\nobserver_bandwidth = \"1 Hz\"\nload_mass = \"1 kg\"\nload_damping = \"2 N s/m\"\n";
    let result = json(tables);
    let best = result["feed_back"].as_str().unwrap();
    assert!(["F_i", "F_x", "F_L", "F_o"].contains(&best));
    assert!((result["crossover_hz"].as_f64().unwrap() - 3.0).abs() < 1e-12);
}

#[test]
fn a_report_is_written_whole() {
    let (place, spec) = place(CONTINUOUS);
    let out = place.path().join("loop");
    let text = done(&["placement", path(&spec), "--out", path(&out), "--date", "2026-11-21"]);
    assert!(text.starts_with("Feed back F_i (load cell at the drive's end), up to a crossover of 51.8 Hz: "), "{text}");
    assert_eq!(names(&out), ["report.html", "results.json"]);
    let page = std::fs::read_to_string(out.join("report.html")).unwrap();
    assert!(page.contains("Feed back F_i") && !page.contains("src=\"http") && !page.contains("href=\"http"));
}

#[test]
fn what_cannot_be_is_refused_at_its_key() {
    let message = |tables: &str| {
        let (_place, spec) = place(tables);
        refused(&["placement", path(&spec)])
    };
    for (tables, expected) in [
        ("", "the table [control] is missing"),
        (
            "[mount]\ndamping_ratio = 0\n[control]\ndrive = \"velocity\"\n",
            "damping_ratio = 0: must be above zero for a loop",
        ),
        ("[control]\ndrive = \"magic\"\n", "drive = \"magic\": must be one of \"velocity\", \"force\""),
        ("[control]\n", "lacks the key \"drive\""),
        ("[control]\ndrive = \"force\"\n", "lacks the key \"motor_mass\""),
        (
            "[control]\ndrive = \"velocity\"\nmotor_mass = \"1 kg\"\n",
            "motor_mass in [control] is no key of a drive that is \"velocity\"",
        ),
        (
            "[control]\ndrive = \"velocity\"\ndrive_bandwidth = \"0 Hz\"\n",
            "drive_bandwidth = \"0 Hz\": must be above zero",
        ),
        (
            "[control]\ndrive = \"velocity\"\nsample_time = \"10 ms\"\n",
            "sample_time = \"10 ms\": must be below 9.2480e-3 s",
        ),
        (
            "[control]\ndrive = \"velocity\"\nsample_time = \"1 ms\"\ndelay = \"1.5 ms\"\n",
            "delay = \"1.5 ms\": must be a whole number",
        ),
        ("[control]\ndrive = \"force\"\nmotor_mass = \"0 kg\"\n", "motor_mass = \"0 kg\": must be above zero"),
        (
            "[control]\ndrive = \"force\"\nmotor_mass = \"1 kg\"\nmotor_friction = \"-1 N s/m\"\n",
            "motor_friction = \"-1 N s/m\": must be",
        ),
        ("[contact]\n[control]\ndrive = \"velocity\"\n", "[contact]"),
        (
            "[control]\ndrive = \"velocity\"\nintegral_time = \"1 s\"\n",
            "integral_time = \"1 s\": goes with a controller that has I",
        ),
        ("[control]\ndrive = \"velocity\"\ncrossover = \"0 Hz\"\n", "crossover = \"0 Hz\": must be above zero"),
        (
            "[control]\ndrive = \"velocity\"\npassive_up_to = \"1 mHz\"\n",
            "passive_up_to = \"1 mHz\": must be a frequency",
        ),
        ("[control]\ndrive = \"velocity\"\nload_mass = \"-1 kg\"\n", "load_mass = \"-1 kg\": must be from 0"),
        ("[mount]\nend2 = \"force\"\n[control]\ndrive = \"velocity\"\n", "lacks the key \"load_mass\""),
    ] {
        let found = message(tables);
        assert!(found.contains(expected), "{tables}: {found}");
    }
}

/// The spring of the recipe: 4.5 mm of wire on 28 mm, pushed by a drive of its own inertia.
const STIFF: &str = r#"
[spring]
name = "stiff"
rest_length = "90 mm"
min_length = "60 mm"
max_length = "85 mm"
windings = 8
wire_diameter = "4.5 mm"
coil_diameter = "28 mm"
end_type = "closed-ground"
[mount]
end2 = "held"
[control]
drive = "velocity"
drive_bandwidth = "80 Hz"
"#;

#[test]
fn no_crossover_is_advised_at_which_either_end_rings() {
    let place = tempfile::tempdir().unwrap();
    let judge = |tables: &str| -> serde_json::Value {
        let spec = place.path().join("spec.toml");
        std::fs::write(&spec, tables).unwrap();
        serde_json::from_str(&done(&["placement", path(&spec), "--json"])).expect("JSON")
    };
    let best = |result: &serde_json::Value| candidate(result, result["feed_back"].as_str().unwrap()).clone();
    // Of an ideal drive a loop on F_i has a sensitivity of at most 2 at any gain; F_o, which nobody watches, rings.
    let ideal = STIFF.replace("drive_bandwidth = \"80 Hz\"\n", "");
    let result = judge(&ideal);
    let advised = result["crossover_hz"].as_f64().unwrap();
    assert_eq!(result["feed_back"], "F_i");
    assert!(best(&result)["robust_crossover_hz"].is_null());
    assert_eq!(best(&result)["calm_crossover_hz"], result["crossover_hz"]);
    for damping in best(&result)["dampings"].as_array().unwrap() {
        for peak in ["drive_peak", "load_peak"] {
            let size = damping["as_set"][peak].as_f64().unwrap();
            // Of a velocity drive the static response is the reference.
            assert!(size <= 3.0 * (1.0 + 1e-6), "{peak} {size} at {advised} Hz");
        }
    }
    let answer = result["answer"].to_string();
    let calm = ", up to a crossover of 215 Hz: its sensitivity is at most 2 there, and both ends stay within 3 times their static response.";
    assert!(answer.contains(calm) && answer.contains(" Hz F_o peaks at "), "{answer}");
    // Half as fast again it rings, which is said where a person wants it so.
    let answer = judge(&format!("{ideal}crossover = \"{} Hz\"\n", 1.5 * advised))["answer"].to_string();
    let loud = "above the limit of 3";
    assert!(answer.contains("times its static response at") && answer.contains(loud), "{answer}");
    // A free mass takes no lasting force, so that the reference counts.
    let free = judge(&ideal.replace("drive = \"velocity\"", "drive = \"velocity\"\nload_mass = \"2 kg\""));
    let none = best(&free)["calm_crossover_hz"] == 0.0;
    assert_eq!(
        none,
        free["answer"].to_string().contains("no slower loop keeps both ends within"),
        "{}",
        free["answer"]
    );
    // With a lag of the drive none is robust at any gain: where a loop on F_i is set, its sensitivity is at most 2, and at twice that more.
    let lagging = judge(STIFF);
    for force in lagging["candidates"].as_array().unwrap() {
        assert!(force["robust_crossover_hz"].is_f64(), "{}", force["force"]);
    }
    let modulus = |force: &serde_json::Value| force["dampings"][0]["as_set"]["modulus_margin"].as_f64().unwrap();
    let (set, force) = (lagging["crossover_hz"].as_f64().unwrap(), candidate(&lagging, "F_i"));
    assert_eq!(lagging["feed_back"], "F_i");
    assert!(modulus(force) > 0.495 && set >= 0.99 * force["robust_crossover_hz"].as_f64().unwrap(), "{set} Hz");
    let faster = judge(&format!("{STIFF}crossover = \"{} Hz\"\n", 2.0 * set));
    assert!(modulus(candidate(&faster, "F_i")) < 0.49);
}

#[test]
fn forces_that_are_as_fast_within_one_per_cent_are_named_together_and_the_first_is_fed_back() {
    let place = tempfile::tempdir().unwrap();
    let (mut ties, mut alone) = (0, 0);
    for more in [
        "",
        "load_mass = \"2 kg\"\n",
        "sample_time = \"0.8 ms\"\n",
        "controller = \"PI\"\nintegral_time = \"1 s\"\n",
        "delay = \"2 ms\"\n",
    ] {
        for drive in ["drive_bandwidth = \"80 Hz\"\n", "drive_bandwidth = \"2 Hz\"\n", ""] {
            let spec = place.path().join("spec.toml");
            std::fs::write(&spec, format!("{}{more}", STIFF.replace("drive_bandwidth = \"80 Hz\"\n", drive))).unwrap();
            let result: serde_json::Value = serde_json::from_str(&done(&["placement", path(&spec), "--json"])).unwrap();
            let speeds = |force: &serde_json::Value| {
                let calm = force["calm_crossover_hz"].as_f64().unwrap();
                [calm, force["robust_crossover_hz"].as_f64().unwrap_or(f64::INFINITY)]
            };
            let best = candidate(&result, result["feed_back"].as_str().unwrap());
            let answer = lines(&result);
            let named = answer.lines().find(|line| line.starts_with("As fast, within 1 %: ")).unwrap_or_default();
            for force in result["candidates"].as_array().unwrap().iter().filter(|force| force["force"] != best["force"])
            {
                let name = force["force"].as_str().unwrap();
                let pairs: Vec<(f64, f64)> = speeds(force).into_iter().zip(speeds(best)).collect();
                let near = pairs.iter().all(|(one, other)| one == other || (one / other - 1.0).abs() < 0.0095);
                let far = pairs.iter().any(|(one, other)| one != other && (one / other - 1.0).abs() > 0.0105);
                assert!(near || far, "{more}{drive}{name}: the test is to be clear of the limit: {pairs:?}");
                assert_eq!(named.contains(name), near, "{more}{drive}{name}: {pairs:?}\n{answer}");
                ties += usize::from(near);
                alone += usize::from(far);
            }
        }
    }
    assert!(ties > 0 && alone > 0, "{ties} ties, {alone} others");
}

#[test]
fn a_crossover_that_is_wanted_is_left_to_a_force_that_reaches_it() {
    // With the band of dampings F_i is calm to the highest crossover of all four, yet in samples stable to 0.7 Hz only.
    let result =
        json("[control]\ndrive = \"velocity\"\ncrossover = \"2 Hz\"\nsample_time = \"0.5 ms\"\ndelay = \"0.5 ms\"\n");
    let best = candidate(&result, result["feed_back"].as_str().unwrap());
    assert_eq!((result["feed_back"].as_str(), &best["stable_as_set"]), (Some("F_x"), &serde_json::Value::Bool(true)));
}

#[test]
fn a_loop_that_is_damped_only_if_it_is_fast_is_never_praised_up_to_a_crossover() {
    let tables =
        |more: &str| format!("[control]\ndrive = \"velocity\"\ncontroller = \"PI\"\nintegral_time = \"0.1 s\"\n{more}");
    let result = json(&tables(""));
    let modulus = |force: &serde_json::Value| {
        let dampings = force["dampings"].as_array().unwrap();
        dampings
            .iter()
            .map(|damping| damping["as_set"]["modulus_margin"].as_f64().unwrap())
            .fold(f64::INFINITY, f64::min)
    };
    let best = result["feed_back"].as_str().unwrap();
    let (from, set) =
        (candidate(&result, best)["robust_from_hz"].as_f64().unwrap(), result["crossover_hz"].as_f64().unwrap());
    // |L| = 1 at x² = (a² + √(a⁴ + 4a²))/2 with a = 2 − √3, x = ω T.
    let square = (2.0 - 3.0_f64.sqrt()).powi(2);
    let expected = ((square + (square * square + 4.0 * square).sqrt()) / 2.0).sqrt() / (0.1 * std::f64::consts::TAU);
    assert!((from / expected - 1.0).abs() < 0.02, "{from} Hz, {expected} Hz");
    assert!(set >= 0.999 * from, "{set} Hz is advised, {from} Hz is the least");
    assert!(modulus(candidate(&result, best)) > 0.49);
    let answer = result["answer"].to_string();
    assert!(answer.contains("a sensitivity of at most 2 from a crossover of 0.8"), "{answer}");
    assert!(
        answer.contains("F_o (load cell at the far end): at no gain a sensitivity of at most 2, stable up to"),
        "{answer}"
    );
    // At half of it the sensitivity is larger, as the loop that is set there shows.
    let slower = json(&tables(&format!("crossover = \"{} Hz\"\n", 0.5 * from)));
    assert!(modulus(candidate(&slower, best)) < 0.45);
    // With samples and a lag an end rings at every crossover of that range; slower loops, which may be quiet, are not denied.
    let ringing = json(
        "[control]\ndrive = \"velocity\"\ndrive_bandwidth = \"40 Hz\"\ncontroller = \"PI\"\nintegral_time = \"50 ms\"\nsample_time = \"1 ms\"\ndelay = \"1 ms\"\n",
    );
    let best = candidate(&ringing, ringing["feed_back"].as_str().unwrap());
    assert!(best["robust_from_hz"].as_f64().unwrap() > 2.0 && best["calm_crossover_hz"] == 0.0);
    let answer = ringing["answer"].to_string();
    assert!(answer.contains("no slower loop with a sensitivity of at most 2 keeps both ends within"), "{answer}");
}
