//! Texts of instruments and programs, each in the form that its maker documents: at the first try, or with the one line that the error prints.
//!
//! The samples are written here after the makers' descriptions, not by the instruments.

use coilsense::Channel;
use coilsense_lab::recording::{Account, Cleaning, Mapping, Recording};

use super::fixtures::{mapping, read_with};

/// Reads with what the error proposes, put into a mapping as the command would.
#[track_caller]
fn with_the_line(text: &str) -> Recording {
    let message = read_with(text, &Mapping::default(), &Cleaning::default()).unwrap_err();
    let mut mapping = Mapping::default();
    let Some((_, line)) = message.split_once(": --") else { panic!("no line to add: {message}") };
    let line = line.split(';').next().unwrap_or_default();
    for option in line.split(" --").map(|option| option.trim_start_matches("--")) {
        let (name, value) = option.split_once(' ').expect("an option and its value");
        let value = value.replace('"', "");
        match name {
            "column" => mapping.set(&value).unwrap(),
            "gain" => mapping.set_gain(&value).unwrap(),
            "sample-rate" => mapping.format.sample_rate = Some(1000.0),
            other => panic!("{other}: {message}"),
        }
    }
    read_with(text, &mapping, &Cleaning::default()).unwrap()
}

#[track_caller]
fn holds(recording: &Recording, time: &[f64], force: &[f64]) {
    assert_eq!(recording.signals().time(), time);
    assert_eq!(recording.channel(Channel::OutputForce).unwrap(), force);
}

fn notes(account: &Account) -> String {
    account.lines().join("\n")
}

const LVM: &str = "LabVIEW Measurement\t\nWriter_Version\t2\nReader_Version\t2\nSeparator\tTab\nDecimal_Separator\t.\nMulti_Headings\tYes\n\
    X_Columns\tOne\nTime_Pref\tRelative\nOperator\tme\nDate\t2026/11/21\nTime\t12:00:00.5\n***End_of_Header***\t\n\t\n\
    Channels\t2\t\t\nSamples\t3\t3\t\nDate\t2026/11/21\t2026/11/21\t\nTime\t12:00:00.5\t12:00:00.5\t\nY_Unit_Label\tNewton\tmm\t\n\
    X_Dimension\tTime\tTime\t\nX0\t0.0\t0.0\t\nDelta_X\t0.5\t0.5\t\n***End_of_Header***\t\t\t\nX_Value\tForce\tLaser\tComment\n";

#[test]
fn labview_measurement_files_with_one_clock_several_segments_or_none() {
    let rows = "0.0\t1.5\t10\n0.5\t-2500\t11\tknocked\n1.0\t0.001\t12\n";
    let recording = with_the_line(&format!("{LVM}{rows}"));
    holds(&recording, &[0.0, 0.5, 1.0], &[1.5, -2500.0, 0.001]);
    assert_eq!(recording.channel(Channel::U1).unwrap(), [0.010, 0.011, 0.012]);
    let told = mapping(&["F_o=Force"]);
    let second = "\nChannels\t2\t\t\nSamples\t1\t1\t\nX0\t1.5\t1.5\t\nDelta_X\t0.5\t0.5\t\n***End_of_Header***\t\t\t\nX_Value\tForce\tLaser\tComment\n1.5\t7\t13\n";
    let recording = read_with(format!("{LVM}{rows}{second}"), &told, &Cleaning::default()).unwrap();
    holds(&recording, &[0.0, 0.5, 1.0, 1.5], &[1.5, -2500.0, 0.001, 7.0]);
    // No column of x: the clock is that of the segment's head.
    let without = LVM.replace("X_Columns\tOne", "X_Columns\tNo");
    let recording = read_with(format!("{without}\t1.5\t10\n\t-2500\t11\n"), &told, &Cleaning::default()).unwrap();
    holds(&recording, &[0.0, 0.5], &[1.5, -2500.0]);
    assert!(notes(recording.account()).contains("clock from its header: 2 Hz"), "{}", notes(recording.account()));
    // A European LabVIEW.
    let comma = LVM.replace("Decimal_Separator\t.", "Decimal_Separator\t,").replace("0.5\t", "0,5\t");
    let recording = read_with(format!("{comma}0,0\t1,5\t10\n0,5\t-2,5\t11\n"), &told, &Cleaning::default()).unwrap();
    holds(&recording, &[0.0, 0.5], &[1.5, -2.5]);
    let message = read_with("LabVIEW Measurement\t\nSeparator\tTab\n", &told, &Cleaning::default()).unwrap_err();
    assert_eq!(message, "run.csv: is a LabVIEW measurement file without the head of a segment");
}

#[test]
fn oscilloscopes_of_tektronix() {
    let old = "Record Length,2.5e+03,,-0.004,0.04,\nSample Interval,0.002,,-0.002,0.08,\nVertical Units,V,,0.0,0.12,\nHorizontal Units,s,,0.002,-0.04,\n\
        Source,CH2,,0.004,0.0,\n,,,0.006,0.02,\n";
    let recording = with_the_line(old);
    holds(&recording, &[-0.004, -0.002, 0.0, 0.002, 0.004, 0.006], &[0.04, 0.08, 0.12, -0.04, 0.0, 0.02]);
    let rows: String = (0..12).map(|i| format!("{},{}\n", f64::from(i) / 1000.0, 0.5 * f64::from(i))).collect();
    let new = format!(
        "Model,MSO24\nFirmware Version,2.0.3\n\nWaveform Type,ANALOG\nPoint Format,Y\nHorizontal Units,s\nHorizontal Scale,0.004\nHorizontal Delay,0\n\
        Sample Interval,0.001\nRecord Length,12\nGating,0.0% to 100.0%\nProbe Attenuation,1\nVertical Units,V\nVertical Offset,0\nVertical Scale,0.2\n\
        Vertical Position,0\n,\n,\n,\nLabel,\nTIME,CH1\n{rows}"
    );
    let told = mapping(&["F_o=CH1 [N]"]);
    let message = read_with(&new, &told, &Cleaning::default()).unwrap_err();
    assert!(message.starts_with("run.csv: column 1 \"TIME\": its unit is not told"), "{message}");
    let recording = with_the_line(&new);
    assert_eq!(recording.account().rows, 12);
    assert_eq!(recording.channel(Channel::OutputForce).unwrap()[11], 5.5);
}

#[test]
fn oscilloscopes_of_rigol_siglent_keysight_rohde_and_pico() {
    let rigol = "X,CH1,CH2,Start,Increment,\nSequence,Volt,Volt,-0.5,0.25,\n0,1.5,0,,\n1,-2500,0,,\n2,0.001,0,,\n";
    let recording = with_the_line(rigol);
    holds(&recording, &[-0.5, -0.25, 0.0], &[1.5, -2500.0, 0.001]);
    assert!(notes(recording.account()).contains("clock from its header: 4 Hz, from -500 ms on"));
    let siglent = "Record Length,Analog:3\nSample Interval,Analog:0.25\nVertical Units,CH1:V\nHorizontal Units,s\nHorizontal Scale,5e-05\n\
        Model Number,SDS1104X-E\nSource,CH1\nSecond,Volt\n-0.5,1.5\n-0.25,-2500\n0,0.001\n0.25,7\n";
    holds(&with_the_line(siglent), &[-0.5, -0.25, 0.0, 0.25], &[1.5, -2500.0, 0.001, 7.0]);
    let keysight = "x-axis,1,2\nsecond,Volt,Volt\n-0.5,1.5,0\n-0.25,-2500,0\n0,0.001,0\n";
    holds(&with_the_line(keysight), &[-0.5, -0.25, 0.0], &[1.5, -2500.0, 0.001]);
    let rohde = "in s,CH1 in V\n-0.5,1.5\n-0.25,-2500\n0,0.001\n";
    holds(&with_the_line(rohde), &[-0.5, -0.25, 0.0], &[1.5, -2500.0, 0.001]);
    let pico = "Time,Channel A\n(ms),(mV)\n\n-500,1.5\n-250,-2500\n0,1\n";
    let recording = with_the_line(pico);
    holds(&recording, &[-0.5, -0.25, 0.0], &[1.5, -2500.0, 1.0]);
    let mut scaled = mapping(&["F_o=Channel A"]);
    scaled.set_gain("F_o=10 N/V").unwrap();
    scaled.set_offset("F_o=-1 N").unwrap();
    scaled.set_negated("F_o").unwrap();
    let recording = read_with(pico, &scaled, &Cleaning::default()).unwrap();
    assert_eq!(recording.channel(Channel::OutputForce).unwrap(), [-0.015 - 1.0, 25.0 - 1.0, -0.01 - 1.0]);
    assert!(notes(recording.account()).contains("\"Channel A\", 10 N/V, its sign turned, an offset added"));
}

#[test]
fn times_of_matlab_pandas_spreadsheets_and_people() {
    for [first, second, third] in [
        ["0 sec", "0.25 sec", "0.5 sec"],
        ["0 days 00:00:00", "0 days 00:00:00.250000", "0 days 00:00:00.500000"],
        ["00:00.0", "00:00.25", "00:00.5"],
        ["00:00:00", "00:00:00.25", "00:00:00.5"],
        ["00:00:00:000", "00:00:00:250", "00:00:00:500"],
    ] {
        let text = format!("clock;F_o [N]\n{first};1.5\n{second};-2500\n{third};1e-3\n");
        holds(
            &read_with(text, &Mapping::default(), &Cleaning::default()).unwrap(),
            &[0.0, 0.25, 0.5],
            &[1.5, -2500.0, 1e-3],
        );
    }
    for day in ["2026-11-21 ", "21.11.2026 ", "11/21/2026 ", "21/11/2026 ", "21-Nov-2026 ", "Nov 21, 2026 "] {
        let text = format!("when;F_o [N]\n{day}12:00:00,25;1,5\n{day}12:00:00,5;-2500\n{day}12:00:00,75;0,001\n");
        let recording = read_with(text, &Mapping::default(), &Cleaning::default()).unwrap();
        holds(&recording, &[43_200.25, 43_200.5, 43_200.75], &[1.5, -2500.0, 1e-3]);
    }
    let text = "when,F_o [N]\n11/21/2026 11:59:59.5 PM,1\n11/22/2026 12:00:00.5 AM,2\n";
    let recording = read_with(text, &Mapping::default(), &Cleaning::default()).unwrap();
    assert_eq!(recording.signals().time(), [86_399.5, 86_400.5]);
}

#[test]
fn thousands_are_read_where_they_are_certain_and_refused_where_they_are_not() {
    let read = |text: &str| read_with(text, &Mapping::default(), &Cleaning::default());
    holds(
        &read("time [s];F_o [mN]\n0;1.234,5\n1;12.345.678\n2;998\n").unwrap(),
        &[0.0, 1.0, 2.0],
        &[1.2345, 12_345.678, 0.998],
    );
    holds(
        &read("time [s],F_o [N]\n0,\"1,234.5\"\n1,998\n2,\"1,001\"\n").unwrap(),
        &[0.0, 1.0, 2.0],
        &[1234.5, 998.0, 1001.0],
    );
    holds(&read("time [s]\tF_o [N]\n0\t1'234.5\n1\t1 000\n2\t3\n").unwrap(), &[0.0, 1.0, 2.0], &[1234.5, 1000.0, 3.0]);
    // 60.005 may be sixty or sixty thousand: whole numbers stand beside it, and nothing else has decimals.
    let message = read("time [s];F_o [mN]\n0;998\n1;999\n2;1.001\n3;60.005\n").unwrap_err();
    assert_eq!(
        message,
        "run.csv: column 2 \"F_o [mN]\": 1.001 may be a decimal, or 1001 with its thousands parted; --decimal . takes it for a decimal, --decimal , for thousands"
    );
    let mut told = Mapping::default();
    told.format.decimal_comma = Some(true);
    let text = "time [s];F_o [mN]\n0;998\n1;999\n2;1.001\n3;60.005\n";
    let recording = read_with(text, &told, &Cleaning::default()).unwrap();
    assert_eq!(recording.channel(Channel::OutputForce).unwrap(), [0.998, 0.999, 1.001, 60.005]);
    told.format.decimal_comma = Some(false);
    let recording = read_with(text, &told, &Cleaning::default()).unwrap();
    assert_eq!(recording.channel(Channel::OutputForce).unwrap()[3], 0.060_005);
    // Decimals of fixed length need nothing told.
    read("time [s];F_o [mN]\n0;60.005\n1;59.998\n2;1.001\n").unwrap();
}

#[test]
fn a_held_end_needs_no_column() {
    let mut held = mapping(&["F_o=F [N]"]);
    held.set_constant("u2=104 mm").unwrap();
    let recording = read_with("time [s],F [N]\n0,1\n1,2\n", &held, &Cleaning::default()).unwrap();
    assert_eq!(recording.channel(Channel::U2).unwrap(), [0.104, 0.104]);
    assert!(notes(recording.account()).contains("u2   from no column: 0.104 m in every row, as told"));
    for (text, words) in [
        ("u2=104", "\"u2=104\": must be a length with its unit"),
        ("time=1 s", "time cannot stand still"),
        ("u3=1 mm", "the name before = must be one of time, u1"),
        ("u2", "must be NAME="),
    ] {
        let message = Mapping::default().set_constant(text).unwrap_err().to_string();
        assert!(message.starts_with("--constant ") && message.contains(words), "{message}");
    }
    // A log of constants alone holds nothing.
    let message = read_with("time [s],b\n0,1\n1,2\n", &held_only(), &Cleaning::default()).unwrap_err();
    assert!(message.contains("no column is recognised as a channel"), "{message}");
}

fn held_only() -> Mapping {
    let mut held = Mapping::default();
    held.set_constant("u2=104 mm").unwrap();
    held
}

#[test]
fn all_that_is_missing_is_asked_for_at_once_by_a_line_that_works() {
    for (text, expected) in [
        (
            "Zeit (ms);Kraft (V);Weg (counts)\n0;1,5;3\n1;2,5;4\n",
            "--column F_o=\"Kraft\" --gain F_o=\"1 N/V\" --column u1=\"Weg\" --gain u1=\"1 mm/counts\"",
        ),
        ("t,force,pos\n0,1,2\n1,2,3\n", "--column F_o=\"force [N]\" --column u1=\"pos [mm]\""),
        ("zeit,kraft\n0,1\n1,2\n", "--column time=\"zeit [s]\" --column F_o=\"kraft [N]\""),
        ("F_o,u1\n1,2\n2,3\n", "--sample-rate \"1 kHz\""),
    ] {
        let message = read_with(text, &Mapping::default(), &Cleaning::default()).unwrap_err();
        assert!(message.contains(expected), "{message}");
        if !expected.contains("sample-rate") {
            with_the_line(text);
        }
    }
    // A gain for another kind of signal, or for a column that has a unit of its own.
    for (gain, words) in
        [("F_o=1 N/count", "its unit is V, the gain is for one count"), ("F_o=1 mm/V", "so many N for one V")]
    {
        let mut told = mapping(&["F_o=F"]);
        let message = match told.set_gain(gain) {
            Ok(()) => read_with("time [s],F [V]\n0,1\n1,2\n", &told, &Cleaning::default()).unwrap_err(),
            Err(error) => error.to_string(),
        };
        assert!(message.contains(words), "{message}");
    }
    let mut told = Mapping::default();
    told.set_gain("F_i=2 N/V").unwrap();
    let message = read_with("time [s],F_o [N]\n0,1\n1,2\n", &told, &Cleaning::default()).unwrap_err();
    assert_eq!(message, "run.csv: no column is called F_i");
}
