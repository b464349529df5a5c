//! `experiment.toml` and the comment lines: what a person with a real rig writes down.
//!
//! Next door: who reads it (`experiment`), the files it lists (`write`).

use super::plan::averaging;
use super::{Kind, Rig, Run};

impl Rig {
    /// Who made this: every file says so in its first line.
    pub(super) fn mark(&self) -> String {
        let version = env!("CARGO_PKG_VERSION");
        format!(
            "simulated by coilsense {version} rig, seed {}, spring {}, {}",
            self.seed, self.spring_name, self.damping
        )
    }

    /// First lines of the fast file of a run.
    pub(super) fn fast_comments(&self, run: &Run) -> Vec<String> {
        let devices = &self.devices;
        let what = format!("{}; F_o: {}; u1: {}", self.what(run), devices.load_cell.name, devices.laser.name);
        vec![
            self.mark(),
            what,
            "u1 grows from end 1 to end 2: the spring is as long as under the preload, less u1".into(),
        ]
    }

    /// First lines of the slow file of a run.
    pub(super) fn slow_comments(&self, run: &Run) -> Vec<String> {
        let window = short(1e3 * averaging(&self.settings));
        let mean = match run.kind {
            Kind::Calibration => "every value is a mean",
            _ => "L is a mean",
        };
        let what =
            format!("{}; L: {}; {mean} over the {window} ms before its time", self.what(run), self.devices.meter.name);
        vec![self.mark(), what]
    }

    fn what(&self, run: &Run) -> String {
        let begun = format!("{}, begun {} s after the first run", run.name, short(run.begin));
        match run.kind {
            Kind::Harmonic => format!("{begun}, u1 about a sine of {:.3} Hz", run.frequency),
            _ => begun,
        }
    }

    /// The whole of `experiment.toml`.
    pub(super) fn description(&self) -> String {
        let newton = short(self.spring.nominal_force());
        let mut text = format!(
            "# {}\n\nsimulated = true\nnominal_force = \"{newton} N\"\naveraging = \"{} ms\"\nlength_at_zero_force = \"{} mm\"\n",
            self.mark(),
            short(1e3 * averaging(&self.settings)),
            short(1e3 * self.spring.rest_length())
        );
        for run in &self.runs {
            text.push_str(&format!("\n[[run]]\nkind = \"{}\"\n", run.kind.word()));
            if run.kind == Kind::Harmonic {
                let amplitude = short(1e3 * self.settings.amplitude);
                text.push_str(&format!(
                    "frequency = \"{} Hz\"\namplitude = \"{amplitude} mm\"\n",
                    short(run.frequency)
                ));
            }
            text.push_str(&format!("fast = \"{0}-fast.csv\"\nslow = \"{0}-slow.csv\"\n", run.name));
        }
        text
    }
}

/// A number without the dust of a change of units.
pub(super) fn short(value: f64) -> String {
    let rounded: f64 = format!("{value:.11e}").parse().unwrap_or(value);
    rounded.to_string()
}
