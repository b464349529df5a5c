//! Whether a series of modes may be that of the spring that was predicted: not where it passes a line by that lies at its first mode's place, nor where
//! it has no line there and holds little of what rings.
//!
//! Next door: what follows from that (`run`), the answer (`verdict`).

use super::Identification;
use super::explain::Coil;
use super::line::Line;
use super::reasons;
use super::verdict::{EXPLAINED, SMALL};

/// Why nothing follows of the series' f1; none where nothing was predicted, or the series has the line at its place.
pub(super) fn doubt(found: &Identification, coil: &Coil) -> Option<String> {
    let (predicted, room) = (found.predicted?, found.settings.prediction_tolerance);
    let agrees = (coil.first / predicted - 1.0).abs() <= room;
    // The first mode of an end that moves lies elsewhere than f1, which is that between held ends.
    if agrees && (found.has_first_mode() || coil.share >= EXPLAINED) {
        return None;
    }
    let decaying = || found.lines.iter().filter(|line| line.decays);
    let largest = decaying().map(|line| line.amplitude).fold(0.0, f64::max);
    let passed = decaying().filter(|line| line.amplitude >= SMALL * largest && near(line, predicted, room));
    if let Some(line) = passed.max_by(|a, b| a.amplitude.total_cmp(&b.amplitude)) {
        return Some(reasons::passed_by(line.frequency.value, predicted, found.sampling.rate, coil));
    }
    agrees.then(|| reasons::without_first(predicted, coil))
}

fn near(line: &Line, predicted: f64, room: f64) -> bool {
    (line.frequency.value / predicted - 1.0).abs() <= room
}
