//! Which errors count where a bandwidth is wanted.

use super::{HEEL_STRIKE, S_T, undamped, verdict};

const LOAD_CELL: &str = "[[sensor]]\nkind = \"load-cell\"\nname = \"cell\"\n";

/// Rms of what counts \[N\].
fn counts(condition: &str, goal: &str) -> f64 {
    let analysis = undamped(S_T, &format!("{condition}{LOAD_CELL}[goal]\nerror = \"1 %\"\n{goal}"));
    verdict(&analysis, "cell").assessments[0].oscillation
}

#[test]
fn a_surge_far_above_the_band_does_not_leak_into_it() {
    // The judged quarter of a second holds 13.5 periods of 54 Hz: a plain mean of them is 2 % of the amplitude, and no slow error.
    for (condition, all_at_least) in [
        (HEEL_STRIKE.to_owned(), 1.7),
        ("[[condition]]\nkind = \"harmonic\"\nfrequency = \"1 f1\"\namplitude = \"0.1 %\"\nphase = \"-90 deg\"\nstart = \"massless\"\n\
          window = [\"0.75 s\", \"1 s\"]\n".to_owned(), 10.0),
    ] {
        let (all, slow) = (counts(&condition, ""), counts(&condition, "bandwidth = \"20 Hz\"\n"));
        assert!(all > all_at_least, "{all}");
        // (20/54)^8 = 0.04 % of the line itself, as much again for what begins at t = 0.
        assert!(slow < 1e-3 * all, "{slow} of {all}");
    }
}

#[test]
fn a_line_counts_as_the_low_pass_of_the_band_lets_it_through() {
    let all = counts(HEEL_STRIKE, "");
    let of_band = |hertz: f64| counts(HEEL_STRIKE, &format!("bandwidth = \"{hertz} Hz\"\n")) / all;
    // Odd modes alone, 54 Hz and upward; the first holds 8/π² = 81 % of the power of a square wave.
    let first = (8.0_f64).sqrt() / std::f64::consts::PI;
    // A line is let through as 1/√(1 + (f/B)^16); 0.25 s know a rms to some 2 %.
    for hertz in [35.0, 40.0, 54.06, 70.0] {
        let expected = first / (1.0 + (54.06_f64 / hertz).powi(16)).sqrt();
        assert!((of_band(hertz) / expected - 1.0).abs() < 0.04, "{hertz} {} {expected}", of_band(hertz));
    }
    assert!((of_band(4000.0) - 1.0).abs() < 0.02, "a band above all modes holds everything: {}", of_band(4000.0));
}

#[test]
fn a_shock_at_the_beginning_of_the_window_counts() {
    // Half a sine of 100 ms from t = 0 on: nothing in it is faster than 20 Hz, all of it lies at the window's first tenth.
    let pulse = "[[condition]]\nkind = \"pulse\"\namplitude = \"5 mm\"\nwidth = \"100 ms\"\nduration = \"1 s\"\n";
    let sensor = "[[sensor]]\nkind = \"deflection\"\nname = \"cell\"\ndelay = \"10 ms\"\n";
    let of = |goal: &str| {
        let analysis = undamped(S_T, &format!("{pulse}{sensor}[goal]\nerror = \"1 %\"\n{goal}"));
        verdict(&analysis, "cell").assessments[0].oscillation
    };
    let (all, slow) = (of(""), of("bandwidth = \"20 Hz\"\n"));
    assert!(slow > 0.8 * all && slow < all, "{slow} of {all}");
}

#[test]
fn a_window_shorter_than_a_period_of_the_band_still_shows_a_steady_error() {
    // A gauge that is 20 ms late is off by the same all along a ramp.
    let ramp = "[[condition]]\nkind = \"ramp\"\namplitude = \"10 mm\"\nrise_time = \"1 s\"\nduration = \"1 s\"\nwindow = [\"0.9 s\", \"1 s\"]\n";
    let sensor = "[[sensor]]\nkind = \"deflection\"\nname = \"cell\"\ndelay = \"20 ms\"\n";
    for band in ["0.1 Hz", "1 Hz", "5 Hz", "20 Hz"] {
        let analysis = undamped(S_T, &format!("{ramp}{sensor}[goal]\nerror = \"1 %\"\nbandwidth = \"{band}\"\n"));
        let off = verdict(&analysis, "cell").assessments[0].oscillation;
        // k · 10 mm/s · 20 ms; up to 3 % where the filter still remembers the first 20 ms, when the error was not there yet.
        assert!((off / (760.0 * 0.01 * 0.02) - 1.0).abs() < 0.03, "{band}: {off}");
    }
}
