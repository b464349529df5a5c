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
