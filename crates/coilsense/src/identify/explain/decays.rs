//! What decay rates and amplitudes after each hit say: a coil's modes ring on their own, multiples of one motion hang together.
//!
//! Next door: where the lines lie (`place`), the ends (`ends`).

use super::fit::sum_of_logs;
use super::heard::Heard;
use super::normal::density;
use super::place::Place;
use crate::identify::median::median;
use crate::identify::phase_law::Law;

/// Scatter of decay rates about a law \[1\], relative, and of those that follow none.
const OFF: f64 = 0.05;
const STRANGE: f64 = 1.2;
/// Scatter of ln |A_n/A_1| of multiples about what their cause makes of them.
const SIZES_OFF: f64 = 0.6;
/// Share of lines whose decay is disturbed.
const DISTURBED: f64 = 0.1;
/// Scatter of ln |A| about a power of the lowest line's amplitude, and of amplitudes that follow nothing.
const AMPLITUDE_OFF: f64 = 0.15;
const AMPLITUDE_STRANGE: f64 = 1.0;

/// ln of the evidence of the decays over that of decays that follow nothing: one ζ, one decay rate or loss of the material for a coil, beam or
/// string; n times that of the first for multiples of one motion, whose amplitudes are then powers of its own.
pub(super) fn of(place: &Place, heard: &[Heard]) -> f64 {
    match place.trial.law {
        Law::Harmonics => {
            let powers = power(place, heard, 1.0);
            // A machine's run down together; a motion that is cut has multiples that die out as they like.
            let of_sizes = sizes(place, heard, |n| 1.2 * (n - 1.0)).max(sizes(place, heard, |n| n.ln()) - 0.7);
            let of_powers = powers + amplitudes(place, heard) + of_sizes;
            let of_machine = power(place, heard, 0.0) + sizes(place, heard, |n| 0.7 * n.ln()) - 0.7;
            of_powers.max(of_machine).max(sizes(place, heard, |n| n.ln()) - 1.0)
        }
        // A comb keeps all multiples alike.
        Law::Mains(_) => power(place, heard, 0.0).max(0.0),
        _ => {
            let each = [0.0, 1.0, 2.0].map(|exponent| power(place, heard, exponent));
            sum_of_logs(&[0.0, each[0], each[1], each[2]]) - 4.0_f64.ln()
        }
    }
}

/// Decay rates that go with a power of frequency.
fn power(place: &Place, heard: &[Heard], exponent: f64) -> f64 {
    let lines: Vec<(f64, f64)> = place
        .modes
        .iter()
        .map(|(line, _)| &heard[*line])
        .map(|heard| (heard.decay.ln() - exponent * heard.frequency.ln(), heard.decay_spread.hypot(OFF)))
        .collect();
    if lines.is_empty() {
        return 0.0;
    }
    let mut rates: Vec<f64> = lines.iter().map(|line| line.0).collect();
    let middle = median(&mut rates);
    let mut overall: Vec<f64> = place.modes.iter().map(|(line, _)| heard[*line].decay.ln()).collect();
    let usual = median(&mut overall);
    let gain = |(line, of): (&(f64, f64), &(usize, usize))| {
        let strange = density(heard[of.0].decay.ln() - usual, line.1.hypot(STRANGE)).max(1e-6);
        ((1.0 - DISTURBED) * density(line.0 - middle, line.1) + DISTURBED * strange).ln() - strange.ln()
    };
    let all: f64 = lines.iter().zip(&place.modes).map(gain).sum();
    // The rate itself is learnt from one line.
    all - (STRANGE / OFF).ln()
}

/// ln of how much better than a coil's modes, which are as large as the first or larger, the lines' sizes fit multiples that fall by e to the
/// power of `fall(n)`.
fn sizes(place: &Place, heard: &[Heard], fall: impl Fn(f64) -> f64) -> f64 {
    let Some(&(lowest, begin)) = place.modes.first() else { return 0.0 };
    let first = heard[lowest].loudness.ln();
    let each = place.modes[1..].iter().filter(|(line, _)| heard[*line].sized).map(|&(line, mode)| {
        let ratio = 0.5 * (heard[line].loudness.ln() - first);
        let of_multiples = density(ratio + fall(mode as f64) - fall(begin as f64), SIZES_OFF).max(1e-6);
        (of_multiples / density(ratio, STRANGE).max(1e-6)).ln()
    });
    each.sum()
}

/// |A_n| of each hit beside |A_1|ⁿ: what one motion's powers do, and modes do only by chance.
fn amplitudes(place: &Place, heard: &[Heard]) -> f64 {
    let Some(&(lowest, first)) = place.modes.first() else { return 0.0 };
    if first != 1 {
        return 0.0;
    }
    let base = &heard[lowest].by_hit;
    let mut sum = 0.0;
    for &(line, mode) in &place.modes[1..] {
        let pairs: Vec<(f64, f64)> = heard[line]
            .by_hit
            .iter()
            .filter_map(|(hit, amplitude)| {
                let own = base.iter().find(|entry| entry.0 == *hit)?.1;
                Some((own.norm().max(1e-300).ln(), amplitude.norm().max(1e-300).ln()))
            })
            .collect();
        if pairs.len() < 3 {
            continue;
        }
        let spread_about = |power: f64, spread: f64| {
            let left: Vec<f64> = pairs.iter().map(|(own, other)| other - power * own).collect();
            let mean = left.iter().sum::<f64>() / left.len() as f64;
            left.iter().map(|l| density(l - mean, spread).max(1e-6).ln()).sum::<f64>()
        };
        let wanted = spread_about(mode as f64, AMPLITUDE_OFF);
        let free =
            sum_of_logs(&[spread_about(1.0, AMPLITUDE_OFF), spread_about(1.0, AMPLITUDE_STRANGE)]) - 2.0_f64.ln();
        sum += (wanted - free).clamp(-8.0, 6.0);
    }
    sum
}
