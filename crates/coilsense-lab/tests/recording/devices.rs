//! Two devices with clocks of their own that saw the same motion.

use coilsense::Channel;
use coilsense_lab::recording::{Clock, Reason, Recording};

use super::fixtures::read;

/// A motion that does not repeat itself.
fn motion(time: f64) -> f64 {
    (21.0 * time).sin() * (-0.3 * (time - 2.0).powi(2)).exp()
        + 0.5 * (13.0 * time + 1.0).cos() * (-0.2 * (time - 5.0).powi(2)).exp()
}

/// What a device records from `from` \[s\] on its own clock, which reads `ahead` more than the motion's.
fn device(channels: &str, from: f64, rows: usize, step: f64, ahead: f64) -> Recording {
    let names: String = channels.split(' ').map(|name| format!(",{name}")).collect();
    let units = names.replace("F_o", "F_o [N]").replace("F_x", "F_x [N]").replace(",u1", ",u1 [m]");
    let row = |index: usize| {
        let time = from + index as f64 * step;
        let value = motion(time - ahead);
        channels.split(' ').fold(time.to_string(), |row, _| format!("{row},{value}")) + "\n"
    };
    read(format!("time [s]{units}\n{}", (0..rows).map(row).collect::<String>())).unwrap()
}

#[test]
fn a_second_device_comes_to_the_clock_of_the_first() {
    let (first, second) = (device("F_o", 0.0, 8000, 1e-3, 0.0), device("F_o u1", 101.0, 3000, 2e-3, 100.3));
    let joined = first.joined(&second, Clock::Found(None)).unwrap();
    let with = joined.account().joined.as_deref().unwrap();
    // Its clock reads 100.3 s more; steps of 2 ms on straight lines leave 1e-4 of a step.
    assert!((with.offset + 100.3).abs() < 1e-6, "{}", with.offset);
    let time = joined.signals().time();
    let error =
        time.iter().zip(joined.channel(Channel::U1).unwrap()).map(|(t, u)| (u - motion(*t)).abs()).fold(0.0, f64::max);
    // A straight line over h departs by h²/8 times the second derivative, here up to 21² m/s²: 2.2e-4.
    assert!(error < 2.3e-4, "{error}");
    // It was switched on 0.7 s later and off 1.3 s before.
    let account = joined.account();
    assert_eq!(account.read, account.rows + account.left_out());
    // The two rows on its ends are left out where the offset is found 1e-7 s to the wrong side.
    let lost = account.left_out[&Reason::OtherDevice].count;
    assert!((2000..=2002).contains(&lost), "{account}");
    assert!(account.to_string().contains("its clock is off by -100.3"), "{account}");
}

#[test]
fn an_offset_may_be_given_and_channels_named() {
    let (first, second) = (device("F_o", 0.0, 8000, 1e-3, 0.0), device("F_x", 0.0, 8000, 1e-3, 0.25));
    let given = first.clone().joined(&second, Clock::Offset(-0.25)).unwrap();
    assert_eq!(given.account().joined.as_deref().unwrap().offset, -0.25);
    let pair = Clock::Found(Some([Channel::OutputForce, Channel::DeflectionForce]));
    let found = first.clone().joined(&second, pair).unwrap().account().joined.as_deref().unwrap().offset;
    assert!((found + 0.25).abs() < 1e-6, "{found}");
    let message = first.clone().joined(&second, Clock::Found(None)).unwrap_err().to_string();
    assert!(message.contains("no channel is in both") && message.contains("--clock F_o=F_x"), "{message}");
    let message = first.joined(&second, Clock::Offset(1e4)).unwrap_err().to_string();
    assert!(message.contains("covers 10000 s to"), "{message}");
}

/// What a device records of twelve sines over ten minutes at 50 Hz, whose clock reads `late` less in the middle and runs slow by `drift`.
fn long(channel: &str, late: f64, drift: f64) -> Recording {
    let row = |index: usize| {
        let time = index as f64 / 50.0;
        let at = time + late + drift * (time - 300.0);
        let sines = (1..13).map(f64::from).map(|n| (n.powf(1.3) * 0.37 * at + n * n).sin());
        format!("{time},{}\n", sines.sum::<f64>() * (1.0 + 0.5 * (0.01 * at * (1.0 + 0.003 * at)).sin()))
    };
    read(format!("time [s],{channel}\n{}", (0..30_000).map(row).collect::<String>())).unwrap()
}

#[test]
fn a_clock_that_drifts_by_50_ppm_over_ten_minutes_is_followed_and_told() {
    let (first, second) = (long("F_o [N]", 0.0, 0.0), long("F_o [N]", -0.252, -50e-6));
    let joined = first.clone().joined(&second, Clock::Found(None)).unwrap();
    let with = joined.account().joined.as_deref().unwrap();
    // The offset runs from -0.237 s to -0.267 s; one offset alone was told as -0.2521 s ± 3.7 ms.
    for (own, added) in [(0.0, -0.237), (300.0, -0.252), (600.0, -0.267)] {
        assert!((with.of_first(own) - own - added).abs() < 1e-4, "{own}: {}", with.of_first(own));
        assert!((with.own(with.of_first(own)) - own).abs() < 1e-9);
    }
    let told = joined.account().to_string();
    println!("{told}");
    assert!(told.contains("its clock drifts: -50.0") && told.contains("-0.2370") && told.contains("-0.2669"), "{told}");
    // The other channel comes at the right times, all along.
    let pair = Clock::Found(Some([Channel::OutputForce, Channel::DeflectionForce]));
    let second = long("F_x [N]", -0.252, -50e-6);
    let joined = first.joined(&second, pair).unwrap();
    let (ours, theirs) =
        (joined.channel(Channel::OutputForce).unwrap(), joined.channel(Channel::DeflectionForce).unwrap());
    let rms = (ours.iter().zip(theirs).map(|(a, b)| (a - b).powi(2)).sum::<f64>() / ours.len() as f64).sqrt();
    let own = (ours.iter().map(|a| a * a).sum::<f64>() / ours.len() as f64).sqrt();
    // Straight lines over 20 ms of sines up to 1.5 Hz leave (ωh)²/12 = 0.3 %; 15 ms at the ends would leave 5 %.
    assert!(rms < 0.005 * own, "{rms} of {own}");
}

#[test]
fn a_record_that_does_not_tell_a_drift_says_what_one_would_add() {
    let (first, second) = (device("F_o", 0.0, 1500, 5e-3, 0.0), device("F_o", 0.0, 1500, 5e-3, 0.25));
    let joined = first.joined(&second, Clock::Found(None)).unwrap();
    let told = joined.account().to_string();
    assert!(told.contains("its drift is not resolved by the record; up to 100 ppm"), "{told}");
    let given = device("F_o", 0.0, 1500, 5e-3, 0.0).joined(&second, Clock::Offset(-0.25)).unwrap();
    assert!(given.account().to_string().contains("as told; a drift of it is not looked for"));
}
