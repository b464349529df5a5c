//! Settings of filters and command shapers: one force or command in, one out.
//!
//! Next door: observers and fusion (`observers`).

use coilsense_rt::{Biquad, Boxcar, Cascade, Comb, DoubleBoxcar, Shaper, Window};
use serde_json::{Value, json};

use super::super::Precision;
use super::{Settings, delay, single, written};

fn biquad(section: &Biquad<f64>) -> Value {
    json!({ "b0": section.b0, "b1": section.b1, "b2": section.b2, "a1": section.a1, "a2": section.a2 })
}

fn boxcar(mean: &Boxcar<f64>) -> Value {
    json!({ "whole": mean.whole, "fraction": mean.fraction, "scale": mean.scale })
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
        include_str!("../c/cascade.h")
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
        include_str!("../c/means.h")
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
        include_str!("../c/means.h")
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
        include_str!("../c/comb.h")
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
        include_str!("../c/window.h")
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
        include_str!("../c/shaper.h")
    }
}
