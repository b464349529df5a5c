//! `coilsense placement` on the springs that a spec allows.
//!
//! Next door: its other answers (`placement`).

use super::placement::{candidate, lines, over_time};
use super::{done, path};

/// The compression spring of `init`, looped.
fn pressed(loop_: &str) -> String {
    done(&["init", "--from", "pressed"]).replace("# [control]\n", &format!("[control]\ndrive = \"velocity\"\n{loop_}"))
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
    assert!(answer.contains("Not included from the spec: lag, noise and sampling of the sensors"), "{answer}");
    assert!(answer.contains("For the nominal spring alone the crossover could be 2.12 Hz"), "{answer}");
    // Without sensors and without tolerances: what the model leaves open is all that is left, and said to be.
    let (head, rest) = text.split_once("[[sensor]]").unwrap();
    let bare: Vec<&str> = head.lines().filter(|line| !line.contains("_tolerance")).collect();
    let result = of(&format!("{}\n{}", bare.join("\n"), &rest[rest.find("[goal]").unwrap()..]));
    let answer = lines(&result);
    assert!(!answer.contains("Not included from the spec") && !answer.contains("k within"), "{answer}");
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
