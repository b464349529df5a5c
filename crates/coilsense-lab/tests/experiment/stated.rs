//! Each run's stated frequency against the motion in its log.

use coilsense_lab::experiment::Experiment;

use super::*;

/// The usual experiment, of which the description says other frequencies than the logs hold.
fn stating(of: impl Fn(usize, f64) -> String, logs: &[Sines]) -> TempDir {
    let place = folder(&format!("{TOP}{GIVEN}"), logs);
    let path = place.path().join("experiment.toml");
    let mut text = fs::read_to_string(&path).unwrap();
    for (index, run) in logs.iter().enumerate().filter(|(_, run)| run.frequency > 0.0) {
        let line =
            format!("fast = \"{index}-fast.csv\"\nslow = \"{index}-slow.csv\"\nfrequency = \"{} Hz\"\n", run.frequency);
        assert!(text.contains(&line));
        text = text.replace(&line, &line.replace(&format!("{} Hz", run.frequency), &of(index, run.frequency)));
    }
    fs::write(path, text).unwrap();
    place
}

fn refused(place: &TempDir) -> String {
    let told = read(place).unwrap_err().to_string();
    assert_eq!(told.lines().count(), 1, "{told}");
    told
}

fn said(experiment: &Experiment) -> String {
    experiment.account().join("\n")
}

#[test]
fn two_files_that_changed_places_are_told_by_name() {
    let place = folder(&format!("{TOP}{GIVEN}"), &usual());
    let path = |index: usize| place.path().join(format!("{index}-fast.csv"));
    let (second, third) = (fs::read(path(2)).unwrap(), fs::read(path(3)).unwrap());
    fs::write(path(2), third).unwrap();
    fs::write(path(3), second).unwrap();
    let told = refused(&place);
    assert!(told.contains("2-fast.csv: moves at 20.0000 ± 0.0001 Hz, as 3 states, and"), "{told}");
    assert!(told.contains("3-fast.csv as 2 does: the two files are swapped"), "{told}");
}

#[test]
fn a_slip_of_the_pen_is_refused_and_a_rounded_number_is_not() {
    let mut runs = usual();
    runs[3].frequency = 26.97;
    let as_typed = |typed: &'static str| {
        let of =
            move |index: usize, frequency: f64| if index == 3 { typed.to_owned() } else { format!("{frequency} Hz") };
        stating(of, &runs)
    };
    let told = refused(&as_typed("27.5 Hz"));
    assert!(told.contains("3-fast.csv: moves at 26.97") && told.contains("not at the 27.5 Hz that 3 states"), "{told}");
    assert!(refused(&as_typed("13.485 Hz")).contains("moves at 26.97"));
    // Rounded to 27 Hz, 4 s part by 0.12 periods; to 27.1 Hz by half a period, which is said.
    assert!(!said(&read(&as_typed("27 Hz")).unwrap()).contains("states"));
    let rounded = said(&read(&as_typed("27.1 Hz")).unwrap());
    assert!(rounded.contains("3 states 27.1 Hz and moves at 26.97"), "{rounded}");
    // Another run's frequency is named as its.
    assert!(refused(&as_typed("10 Hz")).contains("not at the 10 Hz that 3 states"));
}

#[test]
fn a_motion_with_harmonics_or_noise_is_not_refused() {
    let rewritten = |motion: &dyn Fn(f64, u32) -> f64| {
        let place = folder(&format!("{TOP}{GIVEN}"), &usual());
        let mut state = 1_u32;
        let row = |index: usize| {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            let time = index as f64 / RATE;
            format!("{time},{},{}\n", preload(), motion(time, state))
        };
        let rows: String = (0..SAMPLES).map(row).collect();
        write(place.path(), "2-fast.csv", &format!("time [s],F_o [N],u1 [mm]\n{rows}"));
        read(&place)
    };
    let sine = |n: f64, time: f64| (n * TAU * 10.0 * time).sin();
    // The third harmonic is stronger than the sine itself, which is there.
    assert!(rewritten(&|time, _| 0.4 * sine(1.0, time) + 0.6 * sine(3.0, time)).is_ok());
    assert!(rewritten(&|time, _| sine(1.0, time) + 0.7 * sine(2.0, time)).is_ok());
    let noise = |state: u32| f64::from(state) / f64::from(u32::MAX) - 0.5;
    let noisy = said(&rewritten(&|_, state| noise(state)).unwrap());
    assert!(noisy.contains("No one frequency stands out of the motion of 2"), "{noisy}");
    assert!(
        said(&rewritten(&|time, state| 0.1 * sine(1.0, time) + noise(state)).unwrap()).contains("No one frequency")
    );
    assert!(rewritten(&|time, _| 0.01 * time).is_ok());
    let other = rewritten(&|time, state| sine(1.4, time) + 0.2 * noise(state)).unwrap_err().to_string();
    assert!(other.contains("2-fast.csv: moves at 14.0"), "{other}");
}

#[test]
fn a_sine_above_half_the_sampling_rate_is_held_against_its_alias() {
    let place = folder(&format!("{TOP}{GIVEN}"), &usual());
    let slow = |frequency: f64| {
        let row = |index: usize| {
            let time = index as f64 / 32.0;
            format!("{time},{},{}\n", preload(), (TAU * frequency * time).sin())
        };
        "time [s],F_o [N],u1 [mm]\n".to_owned() + &(0..320).map(row).collect::<String>()
    };
    write(place.path(), "3-fast.csv", &slow(20.0));
    let account = said(&read(&place).unwrap());
    assert!(account.contains("3: sampled at 32.0 Hz, 20 Hz shows as 12.0 Hz; the motion fits that."), "{account}");
    write(place.path(), "3-fast.csv", &slow(22.5));
    let told = refused(&place);
    assert!(told.contains("moves at 9.50") && told.contains("sampled at 32.0 Hz, 20 Hz shows as 12.0 Hz"), "{told}");
}
