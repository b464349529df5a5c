//! Runs steps of `coilsense-rt` on a Cortex-M4F under QEMU and prints how many instructions each takes.
//!
//! QEMU counts one instruction a nanosecond (`-icount shift=0`), and the board's timer ticks at 25 MHz: 40 instructions a tick. What the loop
//! itself takes is measured with a step that does nothing, and taken off. Settings in `settings` are exports of coilsense.

#![no_std]
#![no_main]

mod settings;

use core::fmt::Write as _;
use core::hint::black_box;
use core::panic::PanicInfo;

use coilsense_rt::Measured;
use cortex_m::peripheral::syst::SystClkSource;
use cortex_m::peripheral::{Peripherals, SYST};
use cortex_m_rt::entry;
use cortex_m_semihosting::debug::{EXIT_FAILURE, EXIT_SUCCESS, exit};
use cortex_m_semihosting::hio::{self, HostStream};

use settings::{comb, five_notches, kalman, notch, plant, surge_mean, window};

/// Steps of each kind.
const STEPS: u32 = 4096;
/// Instructions a tick of the timer.
const PER_TICK: u32 = 40;

#[panic_handler]
fn panic(_: &PanicInfo) -> ! {
    exit(EXIT_FAILURE);
    loop {}
}

/// What is measured at a sample: a ringing force, and ends that move.
fn measured(sample: u32) -> Measured<f32> {
    let phase = (sample % 46) as f32 - 22.5;
    Measured { force: 96.0 + 0.1 * phase, ends: [1e-5 * phase, 0.23] }
}

/// Runs `step` on every sample; ticks for all of them. A step is called as a controller calls it: by address, its state in memory.
#[inline(never)]
fn count(timer: &mut SYST, step: &mut dyn FnMut(&Measured<f32>) -> f32) -> u32 {
    timer.clear_current();
    let begun = SYST::get_current();
    for sample in 0..STEPS {
        black_box(step(black_box(&measured(sample))));
    }
    let ended = SYST::get_current();
    begun.wrapping_sub(ended) & 0x00ff_ffff
}

/// Prints a whole number without the formatting machinery, which can panic.
fn number(out: &mut HostStream, value: u32) {
    let mut divisor = 1;
    while value / divisor >= 10 {
        divisor *= 10;
    }
    while divisor > 0 {
        let digit = (value / divisor % 10) as u8;
        let _ = out.write_char((b'0' + digit) as char);
        divisor /= 10;
    }
}

#[entry]
fn main() -> ! {
    let (Some(peripherals), Ok(mut out)) = (Peripherals::take(), hio::hstdout()) else {
        exit(EXIT_FAILURE);
        loop {}
    };
    let mut timer = peripherals.SYST;
    timer.set_clock_source(SystClkSource::Core);
    timer.set_reload(0x00ff_ffff);
    timer.clear_current();
    timer.enable_counter();

    let nothing = count(&mut timer, &mut |measured| measured.force);
    let mut tell = |name: &str, ticks: u32| {
        let _ = out.write_str(name);
        let _ = out.write_str(": ");
        number(&mut out, (ticks.saturating_sub(nothing) * PER_TICK + STEPS / 2) / STEPS);
        let _ = out.write_str(" instructions a step\n");
    };
    let rest = measured(22);

    let mut state = notch::NOTCH.settled(rest.force);
    tell("notch", count(&mut timer, &mut |measured| notch::NOTCH.step(&mut state, measured.force)));
    let mut state = five_notches::FIVE_NOTCHES.settled(rest.force);
    tell(
        "five notches",
        count(&mut timer, &mut |measured| five_notches::FIVE_NOTCHES.step(&mut state, measured.force)),
    );
    let mut state = surge_mean::SURGE_MEAN.settled::<{ surge_mean::SURGE_MEAN_RING }>(rest.force);
    tell("mean over 2τ", count(&mut timer, &mut |measured| surge_mean::SURGE_MEAN.step(&mut state, measured.force)));
    let mut state = comb::COMB.settled::<{ comb::COMB_RING }>(rest.force);
    tell("comb", count(&mut timer, &mut |measured| comb::COMB.step(&mut state, measured.force)));
    let mut state = window::WINDOW.settled(rest.force);
    tell("window of 96 taps", count(&mut timer, &mut |measured| window::WINDOW.step(&mut state, measured.force)));
    let mut state = kalman::KALMAN.settled(&rest);
    tell("Kalman, 3 modes", count(&mut timer, &mut |measured| kalman::KALMAN.step(&mut state, measured).output));
    let Ok(spring) = plant::PLANT.plant::<f32>(4e-4) else {
        exit(EXIT_FAILURE);
        loop {}
    };
    let mut state = spring.settled([0.0; 2]);
    tell(
        "plant, 8 modes",
        count(&mut timer, &mut |measured| spring.step(&mut state, [measured.ends[0], 0.0]).output),
    );
    tell("its F_L, 51 gaps", count(&mut timer, &mut |_| plant::PLANT_COIL.reading(&spring, &state).force));
    tell("its closest pitch", count(&mut timer, &mut |_| plant::PLANT_WINDINGS.closest_pitch(&spring, &state)));

    exit(EXIT_SUCCESS);
    loop {}
}
