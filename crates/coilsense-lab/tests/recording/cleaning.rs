//! What is cleaned, and that nothing is lost without being counted.

use coilsense::Channel;
use coilsense_lab::recording::{Cleaning, Mapping, Reason, Recording};

use super::fixtures::read_with;

const GOOD: &str = "time [s],F_o [N]\n0,1\n1,2\n2,3\n3,4\n";

/// Reads with a repair; without any, the message must name the line and the repair's flag.
#[track_caller]
fn cleaned(text: &str, line: u64, flag: &str, cleaning: Cleaning) -> Recording {
    let message = read_with(text, &Mapping::default(), &Cleaning::default()).unwrap_err();
    assert!(message.starts_with(&format!("run.csv:{line}: ")) && message.contains(flag), "{message}");
    read_with(text, &Mapping::default(), &cleaning).unwrap()
}

fn force(recording: &Recording) -> &[f64] {
    recording.channel(Channel::OutputForce).unwrap()
}

#[test]
fn rows_out_of_order_are_sorted() {
    let cleaning = Cleaning { sort: true, ..Cleaning::default() };
    let recording = cleaned("time [s],F_o [N]\n0,1\n2,3\n1,2\n3,4\n", 4, "--sort", cleaning);
    assert_eq!(recording.signals().time(), [0.0, 1.0, 2.0, 3.0]);
    assert_eq!(force(&recording), [1.0, 2.0, 3.0, 4.0]);
    assert_eq!(recording.account().sorted, 1);
}

#[test]
fn rows_of_the_same_time_are_one_row_of_their_mean() {
    let cleaning = Cleaning { merge_repeated: true, ..Cleaning::default() };
    let recording = cleaned("time [s],F_o [N]\n0,1\n1,2\n1,4\n1,6\n2,3\n", 4, "--merge-repeated", cleaning);
    assert_eq!(force(&recording), [1.0, 4.0, 3.0]);
    assert_eq!(recording.account().left_out[&Reason::Merged].count, 2);
}

#[test]
fn incomplete_rows_are_left_out_each_for_its_reason() {
    let text = "time [s],F_o [N]\n0,1\n1,nan\n2\n3,4\n4,abc\n5,inf\n,7\n8,1e10\n9,10\n";
    let recording = cleaned(text, 3, "--drop-incomplete", Cleaning { drop_incomplete: true, ..Cleaning::default() });
    assert_eq!(recording.signals().time(), [0.0, 3.0, 9.0]);
    let left_out: Vec<_> =
        recording.account().left_out.iter().map(|(reason, tally)| (*reason, tally.count, tally.line)).collect();
    assert_eq!(
        left_out,
        [(Reason::CellCount, 1, 4), (Reason::NoNumber, 1, 6), (Reason::TooLarge, 2, 7), (Reason::MissingValue, 2, 3)]
    );
    assert_eq!((recording.account().read, recording.account().left_out(), recording.account().rows), (9, 6, 3));
}

#[test]
fn gaps_and_missing_values_up_to_a_length_are_filled_along_straight_lines() {
    let text = "time [s],F_o [N]\n0,1\n1,\n2,3\n5,6\n6,7\n7,8\n";
    let recording = cleaned(text, 3, "--fill-gaps", Cleaning { fill_gaps: Some(3.0), ..Cleaning::default() });
    assert_eq!(recording.signals().time(), [0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0]);
    // A straight line is filled by itself; thirds round in the last bit.
    assert!(force(&recording).iter().enumerate().all(|(index, force)| (force - index as f64 - 1.0).abs() < 1e-14));
    let account = recording.account();
    assert_eq!((account.filled_values["F_o"], account.filled_rows, account.gaps.count), ((1, 2.0), 2, 1));
    let short = Cleaning { fill_gaps: Some(1.0), ..Cleaning::default() };
    let message = read_with(text, &Mapping::default(), &short).unwrap_err();
    assert!(message.starts_with("run.csv:3: F_o has no value for longer than --fill-gaps"), "{message}");
}

#[test]
fn a_gap_is_reported_and_makes_the_log_uneven() {
    let recording = read_with(GOOD.replace("3,4", "9,4"), &Mapping::default(), &Cleaning::default()).unwrap();
    assert_eq!((recording.account().gaps.count, recording.account().gaps.longest), (1, 7.0));
    let message = recording.sample_rate().unwrap_err().to_string();
    assert!(message.ends_with("7.00 s at 2 s; --resample \"1 Hz\" makes them even"), "{message}");
}

#[test]
fn channels_of_different_rates_come_to_one_rate() {
    // F_o = 10 t at 10 Hz, L = t at 2.5 Hz from 0.2 s on: both straight, so that interpolation is exact but for rounding.
    let rows: String = (0..=20)
        .map(|i| {
            let slow = if i % 4 == 2 { format!("{}", f64::from(i) / 10.0) } else { String::new() };
            format!("{},{i},{slow}\n", f64::from(i) / 10.0)
        })
        .collect();
    let text = format!("time [s],F_o [N],L [H]\n{rows}");
    let recording = cleaned(&text, 2, "--resample", Cleaning { resample: Some(20.0), ..Cleaning::default() });
    let time = recording.signals().time();
    assert_eq!((time.first(), time.last(), time.len()), (Some(&0.2), Some(&1.8), 33));
    for (channel, slope) in [(Channel::OutputForce, 10.0), (Channel::Inductance, 1.0)] {
        let values = recording.channel(channel).unwrap();
        assert!(time.iter().zip(values).all(|(t, value)| (value - slope * t).abs() < 1e-13), "{channel:?}");
    }
    let account = recording.account();
    assert_eq!((account.left_out[&Reason::Ends].count, account.filled_values["L"].0), (4, 12));
    assert_eq!(recording.sample_rate().unwrap().round(), 20.0);
}

#[test]
fn a_window_of_time_counts_what_it_leaves_out() {
    let cleaning = Cleaning { from: Some(1.0), to: Some(2.0), ..Cleaning::default() };
    let recording = read_with(GOOD, &Mapping::default(), &cleaning).unwrap();
    assert_eq!(force(&recording), [2.0, 3.0]);
    assert_eq!(recording.account().left_out[&Reason::OutsideWindow].count, 2);
}
