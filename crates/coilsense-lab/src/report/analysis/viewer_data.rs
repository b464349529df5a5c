//! The data of the report's interactive part, as its README (`report/viewer`) has them: numbers packed, thinned out where there are many.
//!
//! Next door: the page that holds them (`html`), the viewer itself (`report/viewer`).

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use coilsense::Channel;
use coilsense::modes::ModalModel;
use serde_json::{Value, json};

use crate::analysis::{Analysis, Case};

/// Most samples of a signal in the page; a file beside it holds all.
const MOST_SAMPLES: usize = 6000;
/// Surge lines that are named.
const LINES: usize = 8;

/// The JSON block of the page, safe inside of a script element.
pub(super) fn viewer_json(analysis: &Analysis) -> Result<String, serde_json::Error> {
    let value = json!({
        "spring": analysis.spec.spring.name,
        "nominal_force_n": analysis.spec.spring.spring.nominal_force(),
        "reference": analysis.spec.goal.force.name(),
        "cases": analysis.cases.iter().map(|case| case_value(analysis, case)).collect::<Vec<_>>(),
    });
    Ok(serde_json::to_string(&value)?.replace('<', "\\u003c"))
}

fn case_value(analysis: &Analysis, case: &Case) -> Value {
    let spec = &analysis.spec;
    let (condition, damping) = (&spec.conditions[case.condition], &spec.mount.cases[case.damping]);
    let times = case.judged_times();
    let step = if times.len() > 1 { (times[times.len() - 1] - times[0]) / (times.len() - 1) as f64 } else { 1.0 };
    let thin = Thinning::of(times.len());
    let ideal = case.signals.channels().filter(|(channel, _)| *channel != Channel::Inductance);
    let ideal = ideal.map(|(channel, values)| {
        let kind = if channel.unit() == "m" { "position" } else { "force" };
        signal(channel.name(), kind, &thin.series(&values[case.judged.clone()]))
    });
    let sensors = analysis
        .sensors
        .iter()
        .zip(&case.readings)
        .map(|(sensor, reading)| signal(&sensor.name, "force", &thin.series(&reading.force[case.judged.clone()])));
    let modes = ModalModel::chain(&spec.spring.spring, spec.mount.far_end());
    let lines = modes.frequencies().iter().take(LINES).map(|angular| angular / std::f64::consts::TAU);
    json!({
        "id": format!("{}--{}", condition.stem(), damping.stem),
        "condition": condition.name,
        "damping": damping.label,
        "start_s": times[0],
        "step_s": step * thin.stride(),
        "count": thin.count(),
        "signals": ideal.chain(sensors).collect::<Vec<_>>(),
        "goal_n": spec.goal.error,
        "surge_lines_hz": lines.collect::<Vec<_>>(),
        "first_contact_s": case.clash.first_contact,
        "windings": windings(analysis, case),
    })
}

/// Many samples shown by fewer: of each bin the least and the largest, so that no peak is lost.
struct Thinning {
    samples: usize,
    /// Samples per bin; 1 shows all.
    bin: usize,
}

impl Thinning {
    fn of(samples: usize) -> Self {
        let bin = if samples > MOST_SAMPLES { (2 * samples).div_ceil(MOST_SAMPLES) } else { 1 };
        Self { samples, bin }
    }

    /// Samples between two that are shown.
    fn stride(&self) -> f64 {
        if self.bin == 1 { 1.0 } else { 0.5 * self.bin as f64 }
    }

    fn count(&self) -> usize {
        if self.bin == 1 { self.samples } else { 2 * (self.samples / self.bin) }
    }

    fn series(&self, values: &[f64]) -> Vec<f64> {
        if self.bin == 1 {
            return values.to_vec();
        }
        let both = |bin: &[f64]| {
            let least = (0..bin.len()).min_by(|&a, &b| bin[a].total_cmp(&bin[b])).unwrap_or(0);
            let most = (0..bin.len()).max_by(|&a, &b| bin[a].total_cmp(&bin[b])).unwrap_or(0);
            [bin[least.min(most)], bin[least.max(most)]]
        };
        values.chunks_exact(self.bin).flat_map(both).collect()
    }
}

fn signal(name: &str, kind: &str, values: &[f64]) -> Value {
    let offset = values.iter().sum::<f64>() / values.len().max(1) as f64;
    let bytes: Vec<u8> = values.iter().flat_map(|value| ((value - offset) as f32).to_le_bytes()).collect();
    json!({ "name": name, "kind": kind, "offset": offset, "data": STANDARD.encode(bytes) })
}

fn windings(analysis: &Analysis, case: &Case) -> Value {
    let (frames, spring) = (&case.frames, &analysis.spec.spring.spring);
    if frames.times.len() < 2 {
        return Value::Null;
    }
    let bounds = |(least, most): (f64, f64), &x: &f64| (least.min(x), most.max(x));
    let (least, most) = frames.positions.iter().fold((f64::INFINITY, f64::NEG_INFINITY), bounds);
    let zero = 0.5 * (least + most);
    let unit = (0.5 * (most - least) / f64::from(i16::MAX)).max(f64::MIN_POSITIVE);
    // Windings that lie on each other are apart by just that, to the rounding of what is packed.
    let rounding = if case.contacts.is_some() { 2.0 * unit } else { 0.0 };
    let packed = frames.positions.iter().flat_map(|x| (((x - zero) / unit).round() as i16).to_le_bytes());
    json!({
        "count": frames.columns - 2,
        "frames": frames.times.len(),
        "start_s": frames.times[0],
        "step_s": frames.times[1] - frames.times[0],
        // What the viewer draws is the chain, whose masses stand for windings that touch at this distance, …
        "contact_pitch_m": case.clash.contact_pitch + rounding,
        // … and which are so many gaps of the wire to a pitch of the chain.
        "gaps_per_pitch": spring.whole_windings() as f64 / spring.windings(),
        "wire_diameter_m": spring.wire_diameter(),
        "coil_radius_m": spring.coil_radius(),
        "metres_per_unit": unit,
        "zero_m": zero,
        "data": STANDARD.encode(packed.collect::<Vec<u8>>()),
    })
}
