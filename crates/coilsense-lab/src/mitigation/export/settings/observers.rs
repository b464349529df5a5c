//! Settings of what takes more than one force: fusion, observers by waves and by modes.
//!
//! Next door: filters and shapers (`filters`).

use coilsense_rt::{Bank, DelayLineObserver, Fusion, ModalKalman};
use serde_json::{Value, json};

use super::super::Precision;
use super::{Settings, delay, single, written};

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
        include_str!("../c/fusion.h")
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
        include_str!("../c/delay_line.h")
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
        include_str!("../c/kalman.h")
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
        include_str!("../c/bank.h")
    }
}
