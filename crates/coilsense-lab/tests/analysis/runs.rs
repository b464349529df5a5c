//! The run itself: stopped, repeated, on any number of threads, refused.

use std::sync::atomic::{AtomicUsize, Ordering};

use coilsense_lab::analysis::{Analysis, AnalysisError, simulate};

use super::{HEEL_STRIKE, S_T, STILL, spec};

const SENSORS: &str = "[[sensor]]\nkind = \"load-cell\"\nnoise = \"0.1 %\"\nsample_rate = \"1 kHz\"\nresolution = \"0.1 N\"\n\
                       [[sensor]]\nkind = \"inductance\"\naveraging = \"20 ms\"\nnoise = \"0.01 %\"\n[goal]\nerror = \"0.5 %\"\nbandwidth = \"20 Hz\"\n\
                       [uncertainty]\ntrials = 2000\n";

#[test]
fn who_says_stop_gets_an_interruption() {
    let text = format!("{S_T}\n{STILL}{SENSORS}");
    for most in 0..6 {
        let told = AtomicUsize::new(0);
        let result = Analysis::run(spec(&text), &|_, _| told.fetch_add(1, Ordering::Relaxed) < most);
        assert!(matches!(result, Err(AnalysisError::Interrupted)), "after {most}");
    }
    assert!(matches!(simulate(&spec(&text), &|_, _| false), Err(AnalysisError::Interrupted)));
}

#[test]
fn progress_runs_from_nothing_to_all() {
    let most = AtomicUsize::new(0);
    let watch = |done: usize, of: usize| {
        assert!(of == 4 && done <= of);
        most.fetch_max(done, Ordering::Relaxed);
        true
    };
    Analysis::run(spec(&format!("{S_T}\n{STILL}{SENSORS}")), &watch).unwrap();
    assert_eq!(most.into_inner(), 4);
}

#[test]
fn the_same_spec_gives_the_same_numbers_on_any_number_of_threads() {
    let text = format!("{S_T}\n{HEEL_STRIKE}{SENSORS}");
    // A number prints so that it reads back as itself: equal texts are equal bits.
    let on = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        let analysis = pool.install(|| Analysis::run(spec(&text), &|_, _| true)).unwrap();
        format!("{:?} {:?} {:?}", analysis.verdicts, analysis.warnings, analysis.cases)
    };
    let once = on(1);
    for threads in [1, 2, 3] {
        assert!(on(threads) == once, "{threads} threads");
    }
}

#[test]
fn each_sensor_has_noise_of_its_own_that_a_seed_repeats() {
    let noisy = "[[sensor]]\nname = \"a\"\nkind = \"load-cell\"\nnoise = \"1 N\"\n[[sensor]]\nname = \"b\"\nkind = \"load-cell\"\nnoise = \"1 N\"\n";
    let read = |seed: u64| {
        let text = format!("{S_T}\n{STILL}{noisy}[uncertainty]\ntrials = 1000\nseed = {seed}\n");
        let cases = simulate(&spec(&text), &|_, _| true).unwrap();
        cases.into_iter().flat_map(|case| case.readings).map(|reading| reading.native).collect::<Vec<_>>()
    };
    let (first, again, other) = (read(1), read(1), read(9));
    assert_eq!(first, again);
    assert_eq!(first.len(), 8, "two sensors under four dampings");
    for (number, series) in first.iter().enumerate() {
        assert!(first[..number].iter().all(|earlier| earlier != series));
    }
    assert_ne!(first, other);
}

#[test]
fn a_spec_without_conditions_is_refused() {
    let error = Analysis::run(spec(S_T), &|_, _| true).unwrap_err().to_string();
    assert_eq!(error, "test.toml: no [[condition]] says what is done to the spring; give at least one");
}
