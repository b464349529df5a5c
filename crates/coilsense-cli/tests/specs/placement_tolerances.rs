//! `coilsense placement` on the springs that a spec allows.
//!
//! Next door: its other answers (`placement`).

use super::placement::{candidate, lines, over_time};
use super::{done, path};

/// The compression spring of `init`, looped, with its sensors.
fn equipped(loop_: &str) -> String {
    done(&["init", "--from", "pressed"]).replace("# [control]\n", &format!("[control]\ndrive = \"velocity\"\n{loop_}"))
}

/// The same without sensors, so that each force is read at once.
fn pressed(loop_: &str) -> String {
    let text = equipped(loop_);
    let (head, rest) = text.split_once("[[sensor]]").unwrap();
    format!("{head}{}", &rest[rest.find("[goal]").unwrap()..])
}

/// What is answered of a spec, as JSON.
fn of(text: &str) -> serde_json::Value {
    let place = tempfile::tempdir().unwrap();
    let file = place.path().join("spec.toml");
    std::fs::write(&file, text).unwrap();
    serde_json::from_str(&done(&["placement", path(&file), "--json"])).expect("JSON")
}

#[test]
fn a_choice_that_turns_within_the_tolerances_is_not_made() {
    // Where a mode lies near half of the controller's rate, or its phase near where a sign turns.
    for (loop_, nominal) in
        [("sample_time = \"0.7 ms\"\ndelay = \"0.7 ms\"\n", "F_o"), ("sample_time = \"1.1 ms\"\n", "F_i")]
    {
        let result = of(&pressed(loop_));
        let number = |value: &serde_json::Value| value.as_f64().unwrap();
        assert_eq!((&result["nominal_feed_back"], &result["feed_back"]), (&nominal.into(), &"F_x".into()), "{loop_}");
        // 4 × 1 % of the wire, 3 × 1 % of the coil, 0.5 % of the windings and 2 % of G: 5.41 % of k. Of the frequency 1, 2, 0.5 and 1 %, 2.5 %
        // together, and what the model leaves open.
        let (rate, surge) =
            (number(&result["stiffness_tolerance_percent"]), number(&result["surge_tolerance_percent"]));
        assert!((rate - 29.25_f64.sqrt()).abs() < 1e-9 && surge > 2.5 && surge < 2.6, "{rate} {surge}");
        let turned = candidate(&result, nominal);
        let [all, alone] = ["calm_crossover_hz", "nominal_calm_crossover_hz"].map(|key| number(&turned[key]));
        assert!(alone > 1.5 * all && alone > 1.5, "{alone} Hz, on all {all} Hz");
        assert!(number(&result["crossover_hz"]) > 1.02 * all, "{all}");
        let answer = lines(&result);
        let told = format!("For the nominal spring alone the choice would be {nominal} (load cell at the ");
        assert!(answer.contains(&told) && answer.contains(" Hz; over all of them it reaches "), "{answer}");
        assert!(
            answer.contains("k within ±5.41 % and all surge frequencies shifted together by up to ±2.5"),
            "{answer}"
        );
        assert!(answer.contains(" F_x is computed with the nominal k, so the true force is within ±5.41 % of it."));
        // A limit that all springs share is run on the nominal one.
        assert_eq!(over_time(&result)["F_x"]["stiffness_off_percent"], 0.0);
        // A spring that is known to a twentieth of that may keep it.
        let mut known = pressed(loop_);
        for percent in ["1 %", "0.5 %", "2 %"] {
            known = known.replace(&format!("_tolerance = \"{percent}\""), "_tolerance = \"0.05 %\"");
        }
        let result = of(&known);
        assert_eq!((&result["nominal_feed_back"], &result["feed_back"]), (&nominal.into(), &nominal.into()));
        let answer = lines(&result);
        assert!(!answer.contains("the choice would be") && !answer.contains("is computed with"), "{answer}");
    }
}

#[test]
fn no_sampled_loop_is_stable_at_any_gain() {
    // z − 1 + K k h: from K k h = 2 on it alternates from sample to sample, 1/(π h) as a crossover; it was told to be stable at any gain.
    let result = of(&pressed("sample_time = \"1 ms\"\n"));
    let deflection = candidate(&result, "F_x");
    let limit = deflection["stable_crossover_hz"].as_f64().unwrap();
    assert!((limit / (1e3 / std::f64::consts::PI) - 1.0).abs() < 1e-9, "{limit}");
    assert!((deflection["dampings"][0]["oscillates_at_hz"].as_f64().unwrap() - 500.0).abs() < 1e-6);
    for (name, run) in over_time(&result) {
        assert_eq!(run["limit_confirmed"], true, "{name}");
    }
    // Where deflection's loop alternates, F_o rings freely beside it, folded to near there: that is none of the loop's growth.
    for step in ["0.9 ms", "1.1 ms"] {
        let result = of(&pressed(&format!("sample_time = \"{step}\"\n")));
        assert_eq!(over_time(&result)["F_x"]["limit_confirmed"], true, "{step}");
    }
}

#[test]
fn what_is_in_no_limit_is_said() {
    let text = pressed("sample_time = \"0.5 ms\"\n");
    let answer = lines(&of(&text));
    assert!(answer.contains("For the nominal spring alone the crossover could be 2.12 Hz"), "{answer}");
    // Without sensors and without tolerances: what the model leaves open is all that is left, and said to be.
    let bare: Vec<&str> = text.lines().filter(|line| !line.contains("_tolerance")).collect();
    let result = of(&bare.join("\n"));
    let answer = lines(&result);
    assert!(!answer.contains("quickest sensor") && !answer.contains("k within"), "{answer}");
    assert!(answer.contains("The spec gives no tolerance of the rate, so k counts as exact."), "{answer}");
    assert_eq!(result["stiffness_tolerance_percent"], 0.0);
    assert!(result["surge_tolerance_percent"].as_f64().unwrap() > 0.05, "{result}");
    // A tolerance that is given as none is no silence.
    let sure = text.replace("wire_diameter_tolerance = \"1 %\"", "stiffness_tolerance = \"0 %\"");
    let answer = lines(&of(&sure));
    assert!(answer.contains("All figures are worst cases over springs with all surge frequencies shifted"), "{answer}");
    assert!(answer.contains("the spec's tolerances and") && !answer.contains("counts as exact"), "{answer}");
}

#[test]
fn peaks_in_samples_are_those_of_the_loop_in_samples() {
    // With the hold and its aliases a loop of a sensitivity of at most 2 answers at most 1 + 2 times its reference: F_o at 1.0 Hz of 3.4 was told to
    // peak at 14, by the continuous loop, and F_x was fed back.
    let result = of(&pressed("sample_time = \"1 ms\"\ndelay = \"1 ms\"\n"));
    let load = candidate(&result, "F_o");
    let [robust, calm] = ["robust_crossover_hz", "calm_crossover_hz"].map(|key| load[key].as_f64().unwrap());
    assert!((calm / robust - 1.0).abs() < 1e-9 && result["feed_back"] == "F_o", "{calm} of {robust} Hz");
    for candidate in result["candidates"].as_array().unwrap() {
        for damping in candidate["dampings"].as_array().unwrap() {
            let set = &damping["as_set"];
            let own = match candidate["force"].as_str().unwrap() {
                "F_i" => &set["drive_peak"],
                "F_o" => &set["load_peak"],
                _ => continue,
            };
            // Below half the rate; what is seen at an alias is less by the hold.
            if let (Some(peak), Some(modulus)) = (own.as_f64(), set["modulus_margin"].as_f64()) {
                assert!(peak <= 1.0 + 1.0 / modulus + 1e-6, "{peak} at a sensitivity of {}", 1.0 / modulus);
            }
        }
    }
    // Deflection's loop excites F_o at the first surge by the hold's own gain less: sin(x)/x, x = π f1 h.
    let peak = |step: f64| {
        let text = pressed(&format!("sample_time = \"{step} ms\"\ncrossover = \"1 Hz\"\n"));
        let result = of(&text.replace("_tolerance = ", "_tolerance = \"0 %\" # "));
        let set = candidate(&result, "F_x")["dampings"][0]["as_set"].clone();
        [set["load_peak"].as_f64().unwrap(), set["load_peak_hz"].as_f64().unwrap()]
    };
    let ([fine, at], [coarse, _]) = (peak(0.05), peak(1.0));
    let hold = |step: f64| (std::f64::consts::PI * at * step).sin() / (std::f64::consts::PI * at * step);
    assert!((coarse / fine / (hold(1e-3) / hold(5e-5)) - 1.0).abs() < 0.01, "{coarse} {fine} at {at} Hz");
}

#[test]
fn a_run_confirms_the_limit_on_the_spring_that_has_it() {
    let result = of(&pressed("sample_time = \"0.8 ms\"\ndelay = \"0.8 ms\"\n"));
    let runs = over_time(&result);
    let off = |name: &str| {
        [&runs[name]["stiffness_off_percent"], &runs[name]["surge_off_percent"]].map(|value| value.as_f64().unwrap())
    };
    for (name, run) in &runs {
        assert_eq!(run["limit_confirmed"], true, "{name}");
        // Inside of what is allowed.
        let [stiffness, surge] = off(name);
        assert!(stiffness.abs() < 5.41 && surge.abs() < 3.0, "{name}: {stiffness} {surge}");
    }
    // A load cell on a stiffer spring closes a faster loop; deflection is read by the nominal k, whatever the spring's is.
    assert!(off("F_i").iter().any(|share| share.abs() > 1.0), "{:?}", off("F_i"));
    // Samples that are too slow for the fastest of them are refused by its name.
    let place = tempfile::tempdir().unwrap();
    let file = place.path().join("slow.toml");
    std::fs::write(&file, pressed("sample_time = \"1.39 ms\"\n")).unwrap();
    let message = super::refused(&["placement", path(&file)]);
    assert!(
        message.contains("sample_time = 0.00139 s: must be below 1.3") && message.contains("is up to 36"),
        "{message}"
    );
}

#[test]
fn an_observer_on_a_spring_of_another_k_is_judged_and_run_as_it_is() {
    // Two poles of a slow law at z = 1: their polynomials cancelled, and Nyquist's count made of it "not stable at any gain".
    let text = done(&["init", "--from", "S_T"]);
    let tables = "stiffness_tolerance = \"10 %\"\nmass_tolerance = \"5 %\"\n";
    let control = "[control]\ndrive = \"force\"\nmotor_mass = \"1 kg\"\nmotor_friction = \"10 N s/m\"\ncontroller = \"PID\"\n\
                   observer_bandwidth = \"5 Hz\"\nsample_time = \"0.5 ms\"\ndelay = \"0.5 ms\"\n";
    let text = text.replace("# [control]\n", control).replace("[spring]\n", &format!("[spring]\n{tables}"));
    let result = of(&text.replace("[mount]\n", "[mount]\ndamping_ratio = 0.005\n"));
    for candidate in result["candidates"].as_array().unwrap() {
        let [all, alone] =
            ["stable_crossover_hz", "nominal_stable_crossover_hz"].map(|key| candidate[key].as_f64().unwrap());
        assert!(all > 0.2 * alone && all <= alone * (1.0 + 1e-9), "{}: {all} of {alone} Hz", candidate["force"]);
    }
}

/// The spring of the paper with a loop and these sensors.
fn with_sensors(loop_: &str, sensors: &str) -> serde_json::Value {
    let text = include_str!("../../../coilsense-lab/data/springs/S_T.toml");
    of(&format!("{text}\n[mount]\ndamping_ratio = 0.01\n[control]\ndrive = \"velocity\"\n{loop_}\n{sensors}"))
}

const METER: &str =
    "[[sensor]]\nname = \"meter\"\nkind = \"inductance\"\naveraging = \"100 ms\"\nsample_rate = \"10 Hz\"\n";

#[test]
fn a_slow_sensor_is_no_quick_one() {
    let number = |result: &serde_json::Value, force: &str, key: &str| candidate(result, force)[key].as_f64();
    // An integrator behind a lag T oscillates at 1/4T whatever the spring, well below its surge: 50 ms of averaging, and a hold of up to 100 ms.
    let quick = with_sensors("", "");
    let slow = with_sensors("", METER);
    assert!(number(&quick, "F_L", "stable_crossover_hz").is_none_or(|limit| limit > 10.0));
    let limit = number(&slow, "F_L", "stable_crossover_hz").unwrap();
    assert!((limit / (0.25 / 0.15) - 1.0).abs() < 0.01, "{limit}");
    // It was as fast as deflection within 1 %; now it is not named so, and the others are as they were, without a sensor, which is said.
    let answer = lines(&slow);
    assert!(answer.contains("These have lost 3 dB below 3 f1: F_L at 3."), "{answer}");
    assert!(candidate(&slow, "F_L")["sensor_coarse_hz"].as_f64().is_some_and(|hertz| hertz < 5.0));
    assert!(
        answer.contains("F_L 100 ms (meter)") && answer.contains("No sensor of the spec measures F_i, F_o, F_x"),
        "{answer}"
    );
    assert!(answer.lines().next().unwrap().contains("; the spec has no sensor of it)"), "{answer}");
    assert!((candidate(&slow, "F_L")["sensor_lag_s"].as_f64().unwrap() - 0.1).abs() < 1e-15);
    assert_eq!(candidate(&slow, "F_L")["sensor"], "meter");
    assert!(candidate(&slow, "F_i")["sensor"].is_null() && candidate(&quick, "F_L")["sensor"].is_null());
    for force in ["F_i", "F_o", "F_x"] {
        for key in ["stable_crossover_hz", "robust_crossover_hz", "calm_crossover_hz"] {
            assert_eq!(candidate(&quick, force)[key], candidate(&slow, force)[key], "{force} {key}");
        }
    }
    // The quicker of two counts, and the laboratory's meter of 445 ms is judged, too, not refused.
    let quicker = METER.replace("\"meter\"", "\"other\"").replace("100 ms", "4 ms").replace("10 Hz", "250 Hz");
    let both = with_sensors("", &format!("{METER}{quicker}"));
    assert_eq!(candidate(&both, "F_L")["sensor"], "other");
    let paper = METER.replace("100 ms", "445 ms").replace("10 Hz", "2.2471910112 Hz");
    for loop_ in ["", "sample_time = \"0.5 ms\"\n"] {
        let limit = number(&with_sensors(loop_, &paper), "F_L", "stable_crossover_hz").unwrap();
        assert!((limit / (0.25 / 0.6675) - 1.0).abs() < 0.01, "{limit}");
    }
}

#[test]
fn a_sensor_that_nobody_has_is_not_chosen() {
    // F_L without a meter ties with deflection where the ends ring, and bears more sensitivity, since nothing delays it.
    let encoders =
        "[[sensor]]\nkind = \"two-encoder\"\nname = \"encoders\"\nrange = \"68 mm\"\nsample_rate = \"4 kHz\"\n";
    let cell = "[[sensor]]\nkind = \"load-cell\"\nname = \"cell\"\nend = 2\nrange = \"150 N\"\nbandwidth = \"1 kHz\"\n";
    let loop_ = "drive_bandwidth = \"60 Hz\"\nsample_time = \"1 ms\"\ndelay = \"1 ms\"\n";
    let result = with_sensors(loop_, &format!("{encoders}{cell}"));
    let fed = candidate(&result, result["feed_back"].as_str().unwrap());
    assert!(fed["sensor"].is_string(), "{}", lines(&result));
    assert!(!lines(&result).lines().next().unwrap().contains("no sensor of it"));
    // And where the only sensor is too coarse, a force that is still to be measured is named as such.
    let none = with_sensors(loop_, METER);
    assert!(lines(&none).lines().next().unwrap().contains("the spec has no sensor of it"), "{}", lines(&none));
}

#[test]
fn a_lag_within_a_sample_is_judged_at_both_of_its_ends() {
    let loop_ = "sample_time = \"0.5 ms\"\n";
    let cell = |delay: &str| {
        format!("[[sensor]]\nname = \"cell\"\nkind = \"load-cell\"\nend = 2\nrange = \"150 N\"\ndelay = \"{delay}\"\n")
    };
    let limit = |sensors: &str, more: &str| {
        let result = with_sensors(&format!("{loop_}{more}"), sensors);
        candidate(&result, "F_o")["stable_crossover_hz"].as_f64().unwrap()
    };
    let none = limit("", "");
    // A whole number of samples is the same delay, given at the sensor or at the controller.
    let (at_sensor, at_controller) = (limit(&cell("0.5 ms"), ""), limit("", "delay = \"0.5 ms\"\n"));
    assert!((at_sensor / at_controller - 1.0).abs() < 1e-12, "{at_sensor} {at_controller}");
    // More delay raises the limit of F_o here, so that half a sample may not be rounded up to it.
    assert!(at_controller > none);
    assert!((limit(&cell("0.2 ms"), "") / none - 1.0).abs() < 1e-12);
    // That of F_x falls with each: there the later end counts.
    let length = cell("0.2 ms").replace("load-cell", "deflection").replace("end = 2\n", "").replace("150 N", "68 mm");
    let deflection = |sensors: &str, more: &str| {
        let result = with_sensors(&format!("{loop_}{more}"), sensors);
        candidate(&result, "F_x")["stable_crossover_hz"].as_f64().unwrap()
    };
    let (late, read) = (deflection("", "delay = \"0.5 ms\"\n"), deflection(&length, ""));
    assert!(late < 0.6 * deflection("", "") && (read / late - 1.0).abs() < 1e-12, "{read} {late}");
    // What holds a reading for T is not borne better than a controller that does: π/2T, with T in place of the mean age, is below 2/T.
    let held = "[[sensor]]\nkind = \"deflection\"\nname = \"slow\"\nrange = \"68 mm\"\nsample_rate = \"125 Hz\"\n";
    let stable = |result: &serde_json::Value| candidate(result, "F_x")["stable_crossover_hz"].as_f64().unwrap();
    let by_sensor = stable(&with_sensors("", held));
    let by_controller = stable(&with_sensors("sample_time = \"8 ms\"\n", ""));
    assert!(by_sensor < by_controller && by_sensor > 0.7 * by_controller, "{by_sensor} {by_controller}");
}

/// The paper's spring with a loop at ζ = 0.02.
fn damped(loop_: &str) -> String {
    let text = include_str!("../../../coilsense-lab/data/springs/S_T.toml");
    format!("{text}\n[mount]\ndamping_ratio = 0.02\n[control]\n{loop_}")
}

#[test]
fn what_is_set_is_what_is_judged() {
    // Where end 2 is elastic the gain does not grow with the crossover: a force whose loop is unstable as set was fed back.
    let elastic = "drive = \"velocity\"\nsample_time = \"0.5 ms\"\ndelay = \"0.5 ms\"\nload_mass = \"1 kg\"\nload_damping = \"5 N s/m\"\n\
                   load_stiffness = \"500 N/m\"\ncrossover = \"3 Hz\"\n";
    let result = of(&damped(elastic));
    let fed = candidate(&result, result["feed_back"].as_str().unwrap());
    assert_eq!(fed["stable_as_set"], true, "{}", lines(&result));
    // Where none is stable as set, that is said, and which comes nearest; nothing is said of the impedance of an unstable loop.
    let fast = "drive = \"velocity\"\nsample_time = \"0.5 ms\"\ndelay = \"0.5 ms\"\ncrossover = \"450 Hz\"\n";
    let answer = lines(&of(&damped(fast)));
    let none = "No force is stable at the crossover of 450 Hz; F_x (deflection) comes nearest: stability up to";
    assert!(answer.starts_with(none), "{answer}");
    assert!(!answer.contains("is passive") && !answer.contains("As fast"), "{answer}");
    // A motor with PID is stable again at 20 Hz where slower loops are not; and what hardly controls the force says so first.
    let motor =
        |more: &str| of(&damped(&format!("drive = \"force\"\nmotor_mass = \"2 kg\"\ncontroller = \"PID\"\n{more}")));
    let again = lines(&motor("crossover = \"20 Hz\"\n"));
    assert!(again.contains("past a range in which it is not stable, and stable again"), "{again}");
    let weak = lines(&motor(""));
    let hardly = "Such gains hardly control the force: F_o is at 0.";
    assert!(weak.lines().next().unwrap().contains(hardly), "{weak}");
}

#[test]
fn a_loop_that_no_gain_makes_robust_is_answered_all_the_same() {
    let sensors = "[[sensor]]\nkind = \"load-cell\"\nname = \"1\"\nend = 1\nrange = \"150 N\"\ndelay = \"20 ms\"\n\
                   [[sensor]]\nkind = \"load-cell\"\nname = \"2\"\nend = 2\nrange = \"150 N\"\ndelay = \"20 ms\"\n\
                   [[sensor]]\nkind = \"deflection\"\nname = \"3\"\nrange = \"68 mm\"\ndelay = \"6 ms\"\n\
                   [[sensor]]\nkind = \"inductance\"\nname = \"4\"\naveraging = \"40 ms\"\n";
    let loop_ = "drive = \"velocity\"\ncontroller = \"PI\"\nintegral_time = \"10 ms\"\n";
    let answer = lines(&of(&format!("{}{sensors}", damped(loop_))));
    let first = answer.lines().next().unwrap();
    assert!(
        first.contains("yet at every gain its sensitivity is above 2 at some damping: stability up to"),
        "{answer}"
    );
    // Nor does an observer that carries the loop by itself leave a gain of nothing.
    let place = tempfile::tempdir().unwrap();
    let file = place.path().join("spec.toml");
    let observed = damped("drive = \"velocity\"\nobserver_bandwidth = \"2 Hz\"\ncrossover = \"0.5 Hz\"\n");
    std::fs::write(&file, observed).unwrap();
    let said = super::refused(&["placement", path(&file)]);
    assert!(
        said.contains("at a crossover of 0.500 Hz the observer alone carries the loop, whatever the gain"),
        "{said}"
    );
}

#[test]
fn how_far_a_reference_is_followed_is_the_loops_own() {
    // An integrator of crossover f_c follows to f_c: |1/(1 + jf/f_c)| = 1/√2 there.
    let result = with_sensors("crossover = \"1 Hz\"", "");
    assert_eq!(result["feed_back"], "F_i");
    let up_to = result["follows_up_to_hz"].as_f64().unwrap();
    assert!((up_to - 1.0).abs() < 0.02, "{up_to}");
    // A motor without an integral: L = K/(k + …) at rest, a slow reference is reached to L/(1 + L) only, which is no following.
    let text = include_str!("../../../coilsense-lab/data/springs/S_T.toml");
    let drive = "drive = \"force\"\nmotor_mass = \"2 kg\"\nmotor_friction = \"200 N s/m\"\n";
    let motor = |more: &str| of(&format!("{text}\n[mount]\ndamping_ratio = 0.01\n[control]\n{drive}{more}"));
    let weak = motor("controller = \"P\"\ncrossover = \"0.8 Hz\"\n");
    let slow = weak["follows_slowly"].as_f64().unwrap();
    assert!(slow > 0.01 && slow < 0.7, "{slow}");
    let answer = lines(&weak);
    assert!(answer.contains("of even a slow reference") && weak["follows_up_to_hz"].is_null(), "{answer}");
    // With one it comes to the reference, up to some hertz less than the crossover of motor and spring.
    let integral = motor("crossover = \"6 Hz\"\n");
    assert!((integral["follows_slowly"].as_f64().unwrap() - 1.0).abs() < 1e-3, "{integral}");
    let up_to = integral["follows_up_to_hz"].as_f64().unwrap();
    assert!(
        up_to > 2.0 && up_to < 12.0 && lines(&integral).contains("F_o following the reference within 3 dB up to"),
        "{up_to} {}",
        lines(&integral)
    );
}
