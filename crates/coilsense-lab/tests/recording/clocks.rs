//! Clocks that begin anew, go back, stand still or jitter: told apart, mended when asked, and never destroyed by what is advised.

use coilsense::Channel;
use coilsense_lab::recording::{Cleaning, Mapping, Reason, Recording};

use super::fixtures::{mapping, read_with};

/// Rows `(time, row number)` under a title of the time.
fn log(title: &str, times: impl IntoIterator<Item = String>) -> String {
    let rows: String = times.into_iter().enumerate().map(|(row, time)| format!("{time},{row}\n")).collect();
    format!("{title},F_o [N]\n{rows}")
}

fn read(text: &str, cleaning: Cleaning) -> Result<Recording, String> {
    read_with(text, &Mapping::default(), &cleaning)
}

const UNWRAPPED: Cleaning = Cleaning {
    unwrap: true,
    drop_incomplete: false,
    sort: false,
    merge_repeated: false,
    fill_gaps: None,
    resample: None,
    repair_up_to: None,
    from: None,
    to: None,
};

#[test]
fn midnight_and_rollover_are_named_and_counted_on_when_asked() {
    let day = |k: usize| format!("{:02}:59:{:04.1}", 23 * usize::from(k < 20), 58.0 + 0.1 * k as f64);
    let midnight =
        log("clock", (0..40).map(|k| if k < 20 { day(k) } else { format!("00:00:{:04.1}", 0.1 * (k - 20) as f64) }));
    let counter = log("time [ms]", (0..40).map(|k| ((65_526 + k) % 65_536).to_string()));
    for (text, words, span) in [
        (&midnight, "midnight has passed", 3.9),
        (&counter, "a counter rolls over at 65.536 s, or another run begins", 0.039),
    ] {
        let sorting = Cleaning { sort: true, merge_repeated: true, ..Cleaning::default() };
        for cleaning in [Cleaning::default(), sorting] {
            let message = read(text, cleaning).unwrap_err();
            assert!(message.contains(words) && message.ends_with("--unwrap counts on from there"), "{message}");
        }
        let recording = read(text, UNWRAPPED).unwrap();
        let time = recording.signals().time();
        assert!((time[39] - time[0] - span).abs() < 1e-9 && recording.account().rows == 40, "{time:?}");
        assert!(recording.account().lines().iter().any(|line| line.contains(words)));
        recording.sample_rate().unwrap();
    }
    // Two turns, and rows missing across one of them.
    let twice = log(
        "time [ms]",
        (0..140_000).step_by(7).filter(|k| !(65_530..65_560).contains(k)).map(|k| (k % 65_536).to_string()),
    );
    let recording = read(&twice, UNWRAPPED).unwrap();
    assert_eq!(recording.account().turns.map(|(turn, tally)| (turn, tally.count)), Some((65.536, 2)));
    assert_eq!(recording.account().gaps.count, 1);
}

#[test]
fn a_clock_that_is_set_back_is_not_sorted_into_itself() {
    let set_back = |k: usize| format!("{:.3}", 0.01 * k as f64 - if k < 500 { 0.0 } else { 2.0 });
    let text = log("time [s]", (0..1000).map(set_back));
    let message = read(&text, Cleaning::default()).unwrap_err();
    assert_eq!(
        message,
        "run.csv:502: time goes back from 4.99 s to 3 s and goes on from there: the clock was set back, or another run begins; cut the file at this line, or take its rows for evenly sampled by --sample-rate \"100 Hz\""
    );
    // Told to sort: two hundred of a thousand rows would change places.
    let sorting = Cleaning { sort: true, merge_repeated: true, ..Cleaning::default() };
    let message = read(&text, sorting).unwrap_err();
    assert_eq!(
        message,
        "run.csv: --sort would move 199 of 1000 rows, more than 1 %; if that is intended, add --repair-up-to \"20 %\""
    );
    let told = Cleaning { repair_up_to: Some(0.2), ..sorting };
    assert_eq!(read(&text, told).unwrap().account().sorted, 199);
    // A few rows that came late are what sorting is for.
    let late = |k: usize| {
        if k == 300 {
            302
        } else if k == 302 {
            300
        } else {
            k
        }
    };
    let text = log("time [s]", (0..1000).map(|k| format!("{:.2}", 0.01 * late(k) as f64)));
    let message = read(&text, Cleaning::default()).unwrap_err();
    assert!(message.ends_with("--sort puts the rows in order"), "{message}");
    assert_eq!(read(&text, Cleaning { sort: true, ..Cleaning::default() }).unwrap().account().sorted, 2);
}

#[test]
fn a_clock_coarser_than_the_rows_is_not_merged_away() {
    // 2.5 kHz with stamps of a millisecond: as 20,904 of 25,000 rows were once merged.
    let text = log("time [s]", (0..2500).map(|k| format!("{:.3}", (f64::from(k) * 0.4).floor() / 1000.0)));
    let message = read(&text, Cleaning::default()).unwrap_err();
    assert!(
        message.starts_with("run.csv:3: time 0 s is there again; 60 % of the rows repeat the time before them"),
        "{message}"
    );
    assert!(message.ends_with("--sample-rate \"2.5 kHz\" takes them so"), "{message}");
    let merging = Cleaning { merge_repeated: true, ..Cleaning::default() };
    let message = read(&text, merging).unwrap_err();
    assert!(message.contains("--merge-repeated would merge away 1500 of 2500 rows, more than 1 %"), "{message}");
    let told = Cleaning { repair_up_to: Some(0.6), ..merging };
    assert_eq!(read(&text, told).unwrap().account().left_out[&Reason::Merged].count, 1500);
    let mut rated = Mapping::default();
    rated.format.sample_rate = Some(2500.0);
    let recording = read_with(&text, &rated, &Cleaning::default()).unwrap();
    assert_eq!((recording.account().rows, recording.signals().time()[2499]), (2500, 2499.0 / 2500.0));
}

#[test]
fn jitter_is_told_from_rows_that_are_missing() {
    // Deterministic jitter of up to ±0.15 ms at 2.5 kHz.
    let jitter = |k: usize| 0.15e-3 * ((k * k % 1009) as f64 / 504.0 - 1.0);
    let text = log("time [s]", (0..5000).map(|k| format!("{:.7}", k as f64 / 2500.0 + jitter(k))));
    let message = read(&text, Cleaning::default()).unwrap().sample_rate().unwrap_err().to_string();
    assert!(message.contains("around an even clock of 2.5 kHz; --resample \"2.5 kHz\" interpolates"), "{message}");
    assert!(message.ends_with("--sample-rate \"2.5 kHz\" takes them so"), "{message}");
    // Ten rows are missing: even rows would be wrong by as many.
    let text = log(
        "time [s]",
        (0..5000).filter(|k| !(2000..2010).contains(k)).map(|k| format!("{:.7}", f64::from(k) / 2500.0)),
    );
    let message = read(&text, Cleaning::default()).unwrap().sample_rate().unwrap_err().to_string();
    assert!(
        !message.contains("--sample-rate") && message.contains("--resample \"2.5 kHz\" makes them even"),
        "{message}"
    );
}

#[test]
fn repairs_of_many_rows_are_said_twice() {
    let gappy: String =
        (0..1000).map(|k| format!("{k},{}\n", if k % 50 == 7 { String::new() } else { k.to_string() })).collect();
    let text = format!("time [s],F_o [N]\n{gappy}");
    for (cleaning, words) in [
        (
            Cleaning { drop_incomplete: true, ..Cleaning::default() },
            "--drop-incomplete would leave out 20 of 1000 rows",
        ),
        (Cleaning { fill_gaps: Some(2.0), ..Cleaning::default() }, "--fill-gaps would make up 20 of 1000 rows"),
    ] {
        let message = read(&text, cleaning).unwrap_err();
        assert!(message.contains(words) && message.ends_with("add --repair-up-to \"2 %\""), "{message}");
        read(&text, Cleaning { repair_up_to: Some(0.02), ..cleaning }).unwrap();
    }
    // Resampling over what rows are not there: a day at 1 kHz is not made up in silence.
    let text = "time [s],F_o [N]\n0,1\n0.001,2\n0.002,3\n86400,4\n86400.001,5\n";
    let message = read(text, Cleaning { resample: Some(1000.0), ..Cleaning::default() }).unwrap_err();
    assert!(
        message.contains("over which 86399998 rows would be made up") && message.ends_with("--fill-gaps \"86400 s\""),
        "{message}"
    );
}

#[test]
fn a_column_of_time_needs_no_name_where_it_stands_first() {
    let recording = read_with("Zeit (ms);LC (N)\n0;1\n1;2\n", &mapping(&["F_o=LC"]), &Cleaning::default()).unwrap();
    assert_eq!(recording.signals().time(), [0.0, 0.001]);
    assert_eq!(recording.channel(Channel::OutputForce).unwrap(), [1.0, 2.0]);
    // Elsewhere a time is no clock.
    let message =
        read_with("LC (N);settling (ms)\n1;7\n2;3\n", &mapping(&["F_o=LC"]), &Cleaning::default()).unwrap_err();
    assert!(message.contains("no column is recognised as the time"), "{message}");
}
