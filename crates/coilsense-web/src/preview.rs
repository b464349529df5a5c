//! Curves while a slider moves: few times, L to second order; quick enough for the next frame.
//!
//! Next door: the same at rest (`exact`).

use coilsense::measures::Spectrum;
use coilsense::motion::Windings;
use coilsense::{Channel, Clash, Deviation, Error, Motion};
use coilsense_lab::spec::{ConditionSpec, Spec, SpringInductance};
use coilsense_lab::study::{self, Coil, Meets, Method, Setup, Simulation};
use serde_json::{Map, Value, json};

use crate::answer::Answer;
use crate::{contact, facts};

/// Most times of a preview.
pub const MOST_SAMPLES: usize = 2000;

/// So much of L may its second-order form be off by: all of it, so that only turns that touch fall back on the exact sum.
const ANY: f64 = 1.0;

/// Forces, spectrum and positions of a case between two times \[s\].
///
/// Series: `time`, `u1`, `u2`, `F_i`, `F_o`, `F_x`, `F_L` over `samples` times; `frequency` and `spectrum F_i` … over the judged window, which is
/// sampled anew, and without F_L. Positions: u1, x_1…x_N, u2 at each of the times.
///
/// # Errors
/// One line: what the science says of the case, or of the times.
pub fn run(spec: &Spec, condition: usize, damping: usize, shown: (f64, f64), samples: usize) -> Result<Answer, String> {
    let (Some(asked), Some(mounted)) = (spec.conditions.get(condition), spec.mount.cases.get(damping)) else {
        return Err(format!("condition {condition}, damping {damping}: is not in the spec"));
    };
    if !(2..=MOST_SAMPLES).contains(&samples) {
        return Err(format!("samples must be from 2 to {MOST_SAMPLES}, got {samples}"));
    }
    let times = (shown.0.max(0.0), shown.1.min(asked.duration));
    if !(shown.0.is_finite() && shown.1.is_finite() && times.0 < times.1) {
        return Err(format!("times from {} s to {} s: must rise, within {} s", shown.0, shown.1, asked.duration));
    }
    let science = |error: Error| format!("{}: {error}", asked.name);
    let times = evenly(times.0, times.1, samples);
    let sum = SpringInductance::Air(spec.spring.inductance_in_air());
    let coil = Coil::of(&spec.spring.spring, &sum, asked.excitation.mean_length(), Method::Within(ANY)).ok();
    let (spring, mount) = (&spec.spring.spring, &mounted.mount);
    let excitation = &asked.excitation;
    let meets = mounted.contact.as_ref().map(|way| Meets { contact: &way.contact, apart: None });
    let setup = Setup { spring, mount, excitation, coil, positions: true, helix: None, contact: meets };
    let Simulation { motion, signals, windings, contacts, .. } = study::simulate(&setup, &times).map_err(science)?;
    let windings = windings.map_or_else(|| motion.windings(&times), Ok).map_err(science)?;
    let pitch = spec.spring.contact_pitch();
    let clash = match &contacts {
        Some(contacts) => Clash::met(spring, &times, &windings, pitch, contacts.first),
        None => Clash::seen(&motion, &times, &windings, pitch),
    };
    let clash = clash.map_err(science)?;
    let judged = Judged::of(spec, asked, &motion, &setup).map_err(science)?;
    let mut meta = facts::of_spec(spec, condition, damping);
    meta["exact"] = json!(false);
    meta["contact"] = contact::of_case(mounted, contacts.as_ref());
    meta["clash"] = facts::of_clash(&clash);
    meta["forces"] = judged.deviations;
    let mut series = vec![("time".to_owned(), times)];
    series.extend(signals.channels().map(|(channel, values)| (channel.name().to_owned(), values.to_vec())));
    series.extend(judged.spectra);
    series.extend(contacts.iter().flat_map(contact::series));
    let turns = windings.turns(spring.masses_per_winding()).map_err(science)?;
    Ok(Answer::new(&meta, series).with_positions(rows(&turns)))
}

/// `samples` times from one to the other \[s\], both included.
fn evenly(from: f64, to: f64, samples: usize) -> Vec<f64> {
    let step = (to - from) / (samples - 1) as f64;
    (0..samples).map(|index| from + step * index as f64).collect()
}

/// What the forces do in the judged window.
struct Judged {
    deviations: Value,
    spectra: Vec<(String, Vec<f64>)>,
}

impl Judged {
    /// Of the motion, or where windings meet of the setup's once more, at other times.
    fn of(spec: &Spec, asked: &ConditionSpec, motion: &Motion, setup: &Setup<'_>) -> Result<Self, Error> {
        let (from, to) = asked.window;
        let samples = ((to - from) * asked.sample_rate).round() as usize + 1;
        let times = evenly(from, to.min(asked.duration), samples.clamp(3, MOST_SAMPLES));
        let signals = match setup.contact {
            Some(_) => study::simulate(&Setup { coil: None, positions: false, ..*setup }, &times)?.signals,
            None => motion.signals(&times)?,
        };
        let truth = signals.channel(spec.goal.force)?;
        let mut deviations = Map::new();
        let mut spectra = Vec::new();
        for force in [Channel::InputForce, Channel::OutputForce, Channel::DeflectionForce] {
            let values = signals.channel(force)?;
            deviations.insert(force.name().to_owned(), facts::of_deviation(&Deviation::between(values, truth)?));
            let spectrum = Spectrum::of(&times, values)?;
            if spectra.is_empty() {
                spectra.push(("frequency".to_owned(), spectrum.frequencies()));
            }
            spectra.push((format!("spectrum {}", force.name()), spectrum.amplitudes().to_vec()));
        }
        Ok(Self { deviations: Value::Object(deviations), spectra })
    }
}

/// u1, x_1…x_N, u2 of every sample.
fn rows(windings: &Windings) -> Vec<f32> {
    let mut rows = Vec::with_capacity(windings.samples() * (windings.count() + 2));
    for sample in 0..windings.samples() {
        let [first, last] = windings.ends(sample);
        rows.push(first as f32);
        rows.extend(windings.row(sample).iter().map(|position| *position as f32));
        rows.push(last as f32);
    }
    rows
}
