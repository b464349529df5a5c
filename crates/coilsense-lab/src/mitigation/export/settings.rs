//! What each kind of settings consists of: its name, its type, its numbers.
//!
//! Next door: the files made of them (`export`).

use std::fmt::Debug;

use coilsense_rt::{
    Bank, Biquad, Boxcar, Cascade, Comb, Delay, DelayLineObserver, DoubleBoxcar, Fusion, ModalKalman, Shaper, Window,
};
use serde_json::{Value, json};

use super::Precision;

/// Settings of `coilsense-rt` that can be written down.
pub trait Settings {
    /// In words.
    fn kind(&self) -> &'static str;
    /// The type in Rust, over the number type `scalar`.
    fn rust_type(&self, scalar: &str) -> String;
    /// The value in Rust.
    fn rust_value(&self, precision: Precision) -> String;
    /// Every number by its name.
    fn numbers(&self) -> Value;
    /// How many samples the state's ring holds, where it has one.
    fn ring(&self) -> Option<usize>;
    /// The steps in C.
    fn c_template(&self) -> &'static str;
}

/// `Debug` of plain structs and arrays of numbers is how Rust writes them.
fn written(single: &impl Debug, double: &impl Debug, precision: Precision) -> String {
    match precision {
        Precision::Single => format!("{single:#?}"),
        Precision::Double => format!("{double:#?}"),
    }
}

fn single(value: f64) -> f32 {
    value as f32
}

fn biquad(section: &Biquad<f64>) -> Value {
    json!({ "b0": section.b0, "b1": section.b1, "b2": section.b2, "a1": section.a1, "a2": section.a2 })
}

fn delay(delay: &Delay<f64>) -> Value {
    json!({ "whole": delay.whole, "fraction": delay.fraction })
}

fn boxcar(mean: &Boxcar<f64>) -> Value {
    json!({ "whole": mean.whole, "fraction": mean.fraction, "scale": mean.scale })
}

fn member<const MODES: usize>(filter: &ModalKalman<f64, MODES>) -> Value {
    let mode = |mode: &coilsense_rt::Mode<f64>| json!({ "turn": mode.turn, "kick": mode.kick, "input": mode.input, "output": mode.output, "gain": mode.gain });
    json!({
        "stiffness": filter.stiffness,
        "rest_length": filter.rest_length,
        "rate": filter.rate,
        "bias_gain": filter.bias_gain,
        "modes": filter.modes.iter().map(mode).collect::<Vec<_>>(),
    })
}

impl<const SECTIONS: usize> Settings for Cascade<f64, SECTIONS> {
    fn kind(&self) -> &'static str {
        "biquad cascade"
    }
    fn rust_type(&self, scalar: &str) -> String {
        format!("Cascade<{scalar}, {SECTIONS}>")
    }
    fn rust_value(&self, precision: Precision) -> String {
        written(&self.map(single), self, precision)
    }
    fn numbers(&self) -> Value {
        json!({ "sections": self.sections.iter().map(biquad).collect::<Vec<_>>() })
    }
    fn ring(&self) -> Option<usize> {
        None
    }
    fn c_template(&self) -> &'static str {
        include_str!("c/cascade.h")
    }
}

impl Settings for Boxcar<f64> {
    fn kind(&self) -> &'static str {
        "mean"
    }
    fn rust_type(&self, scalar: &str) -> String {
        format!("Boxcar<{scalar}>")
    }
    fn rust_value(&self, precision: Precision) -> String {
        written(&self.map(single), self, precision)
    }
    fn numbers(&self) -> Value {
        json!({ "means": [boxcar(self)] })
    }
    fn ring(&self) -> Option<usize> {
        Some(self.whole + 1)
    }
    fn c_template(&self) -> &'static str {
        include_str!("c/means.h")
    }
}

impl Settings for DoubleBoxcar<f64> {
    fn kind(&self) -> &'static str {
        "mean of means"
    }
    fn rust_type(&self, scalar: &str) -> String {
        format!("DoubleBoxcar<{scalar}>")
    }
    fn rust_value(&self, precision: Precision) -> String {
        written(&self.map(single), self, precision)
    }
    fn numbers(&self) -> Value {
        json!({ "means": [boxcar(&self.first), boxcar(&self.second)] })
    }
    fn ring(&self) -> Option<usize> {
        Some(self.first.whole.max(self.second.whole) + 1)
    }
    fn c_template(&self) -> &'static str {
        include_str!("c/means.h")
    }
}

impl Settings for Comb<f64> {
    fn kind(&self) -> &'static str {
        "comb"
    }
    fn rust_type(&self, scalar: &str) -> String {
        format!("Comb<{scalar}>")
    }
    fn rust_value(&self, precision: Precision) -> String {
        written(&self.map(single), self, precision)
    }
    fn numbers(&self) -> Value {
        json!({ "means": [boxcar(&self.period)], "radius": self.radius, "feedback": self.feedback })
    }
    fn ring(&self) -> Option<usize> {
        Some(self.period.whole + 2)
    }
    fn c_template(&self) -> &'static str {
        include_str!("c/comb.h")
    }
}

impl<const TAPS: usize> Settings for Window<f64, TAPS> {
    fn kind(&self) -> &'static str {
        "window"
    }
    fn rust_type(&self, scalar: &str) -> String {
        format!("Window<{scalar}, {TAPS}>")
    }
    fn rust_value(&self, precision: Precision) -> String {
        written(&self.map(single), self, precision)
    }
    fn numbers(&self) -> Value {
        json!({ "taps": self.taps.to_vec() })
    }
    fn ring(&self) -> Option<usize> {
        Some(TAPS)
    }
    fn c_template(&self) -> &'static str {
        include_str!("c/window.h")
    }
}

impl<const IMPULSES: usize> Settings for Shaper<f64, IMPULSES> {
    fn kind(&self) -> &'static str {
        "command shaper"
    }
    fn rust_type(&self, scalar: &str) -> String {
        format!("Shaper<{scalar}, {IMPULSES}>")
    }
    fn rust_value(&self, precision: Precision) -> String {
        written(&self.map(single), self, precision)
    }
    fn numbers(&self) -> Value {
        let impulses = self.impulses.iter();
        let each = impulses.map(|i| json!({ "amplitude": i.amplitude, "delay": delay(&i.delay) }));
        json!({ "impulses": each.collect::<Vec<_>>() })
    }
    fn ring(&self) -> Option<usize> {
        self.impulses.iter().map(|impulse| impulse.delay.whole + 2).max()
    }
    fn c_template(&self) -> &'static str {
        include_str!("c/shaper.h")
    }
}

impl Settings for Fusion<f64> {
    fn kind(&self) -> &'static str {
        "fusion of a slow and a fast force"
    }
    fn rust_type(&self, scalar: &str) -> String {
        format!("Fusion<{scalar}>")
    }
    fn rust_value(&self, precision: Precision) -> String {
        written(&self.map(single), self, precision)
    }
    fn numbers(&self) -> Value {
        json!({ "gain": self.gain, "lateness": delay(&self.lateness) })
    }
    fn ring(&self) -> Option<usize> {
        Some(self.lateness.whole + 2)
    }
    fn c_template(&self) -> &'static str {
        include_str!("c/fusion.h")
    }
}

impl Settings for DelayLineObserver<f64> {
    fn kind(&self) -> &'static str {
        "delay-line observer"
    }
    fn rust_type(&self, scalar: &str) -> String {
        format!("DelayLineObserver<{scalar}>")
    }
    fn rust_value(&self, precision: Precision) -> String {
        written(&self.map(single), self, precision)
    }
    fn numbers(&self) -> Value {
        json!({
            "stiffness": self.stiffness,
            "rest_length": self.rest_length,
            "impedance": self.impedance,
            "rate": self.rate,
            "transit": delay(&self.transit),
            "gain": self.gain,
            "loss": self.loss,
        })
    }
    fn ring(&self) -> Option<usize> {
        Some(self.transit.whole + 1)
    }
    fn c_template(&self) -> &'static str {
        include_str!("c/delay_line.h")
    }
}

impl<const MODES: usize> Settings for ModalKalman<f64, MODES> {
    fn kind(&self) -> &'static str {
        "modal Kalman filter"
    }
    fn rust_type(&self, scalar: &str) -> String {
        format!("ModalKalman<{scalar}, {MODES}>")
    }
    fn rust_value(&self, precision: Precision) -> String {
        written(&self.map(single), self, precision)
    }
    fn numbers(&self) -> Value {
        json!({ "members": [member(self)] })
    }
    fn ring(&self) -> Option<usize> {
        None
    }
    fn c_template(&self) -> &'static str {
        include_str!("c/kalman.h")
    }
}

impl<const MODES: usize, const MEMBERS: usize> Settings for Bank<f64, MODES, MEMBERS> {
    fn kind(&self) -> &'static str {
        "bank of modal Kalman filters"
    }
    fn rust_type(&self, scalar: &str) -> String {
        format!("Bank<{scalar}, {MODES}, {MEMBERS}>")
    }
    fn rust_value(&self, precision: Precision) -> String {
        written(&self.map(single), self, precision)
    }
    fn numbers(&self) -> Value {
        json!({
            "forgetting": self.forgetting,
            "sharpness": self.sharpness,
            "members": self.members.iter().map(member).collect::<Vec<_>>(),
        })
    }
    fn ring(&self) -> Option<usize> {
        None
    }
    fn c_template(&self) -> &'static str {
        include_str!("c/bank.h")
    }
}
