//! Whether the ends move while a line rings, and whether the force then only follows them.
//!
//! Next door: the lines (`refine`), what that says of the mount and of the cause (`verdict`).

use num_complex::Complex;

use super::hits::Hit;
use super::sampling::Sampling;

/// Stretches that are looked at, at most; and of a record without hits, how long each is in turns of the line.
const STRETCHES: usize = 16;
const TURNS: f64 = 60.0;

/// H = X/F at one frequency, averaged over stretches: how far an end moves per force that rings \[m/N\].
///
/// H = Σ X F*/Σ |F|², X and F the tapered transforms of position and force over each stretch at that frequency
///
/// Source:   the H1 estimator, `[Bendat2010]` section 6.1.4.
/// Valid:    force noise far below the line.
/// Accuracy: position noise averages out; what is left is below 1/√stretches of it.
pub(super) fn receptance(
    position: &[f64],
    force: &[f64],
    frequency: f64,
    folding: f64,
    hits: &[Hit],
    sampling: &Sampling,
) -> Complex<f64> {
    let rate = sampling.rate;
    let wanted = if folding.is_finite() { 3.0 * folding } else { TURNS / frequency };
    let length = ((wanted * rate) as usize).clamp(16, (sampling.samples / 2).max(16));
    let decaying = !hits.is_empty();
    let starts: Vec<usize> = if decaying {
        hits.iter().map(|hit| hit.after).collect()
    } else {
        let step = (sampling.samples / STRETCHES).max(length);
        (0..sampling.samples).step_by(step.max(1)).collect()
    };
    let (mut cross, mut power) = (Complex::new(0.0, 0.0), 0.0);
    for &start in starts.iter().filter(|start| *start + 16 <= sampling.samples).take(STRETCHES) {
        let end = (start + length).min(sampling.samples);
        let x = tapered(&position[start..end], frequency / rate, decaying);
        let f = tapered(&force[start..end], frequency / rate, decaying);
        cross += x * f.conj();
        power += f.norm_sqr();
    }
    if power > 0.0 { cross / power } else { Complex::new(0.0, 0.0) }
}

/// Transform of a stretch at one frequency \[turns per sample\], its straight trend taken out; tapered at the end only where it decays.
fn tapered(values: &[f64], frequency: f64, decaying: bool) -> Complex<f64> {
    let count = values.len() as f64;
    let middle = 0.5 * (count - 1.0);
    let mean = values.iter().sum::<f64>() / count;
    let lever: f64 = (0..values.len()).map(|n| (n as f64 - middle).powi(2)).sum();
    let slope = values.iter().enumerate().map(|(n, x)| (n as f64 - middle) * (x - mean)).sum::<f64>() / lever.max(1.0);
    let turn = Complex::new(0.0, -std::f64::consts::TAU * frequency).exp();
    let mut phasor = Complex::new(1.0, 0.0);
    let mut sum = Complex::new(0.0, 0.0);
    for (n, x) in values.iter().enumerate() {
        let part = (n as f64 + 0.5) / count;
        let taper = if decaying {
            (std::f64::consts::FRAC_PI_2 * part).cos().powi(2)
        } else {
            (std::f64::consts::PI * part).sin().powi(2)
        };
        sum += phasor * (taper * (x - mean - slope * (n as f64 - middle)));
        phasor *= turn;
    }
    sum
}
