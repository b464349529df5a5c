//! What a shaped command leaves of a mode's ringing, in closed form.
//!
//! Next door: the shapers that are held against each other by it (`shaping`).

/// The last sample at which something arrives.
pub(super) fn last(taps: &[f64]) -> usize {
    taps.iter().rposition(|tap| *tap != 0.0).unwrap_or(0)
}

/// What a shaped command leaves of a mode's ringing, of what the plain one leaves when it ends \[1\].
///
/// V = e^(−ζω t_N) |Σ_j h_j e^((ζω + iω√(1−ζ²)) t_j)|, t_j = j/f_s, t_N the last with a tap
///
/// - `taps`: h_j \[1\], what the shaper makes of a unit impulse; those of a shaper add up to 1
/// - `rate`: f_s \[Hz\], `omega`: ω \[rad/s\], `ratio`: ζ, below 1
///
/// Source:   `[Singer1990]`; their V with the shaper's impulses as they are sampled.
/// Valid:    linear vibration, any command; what the controller's hold does to it is the same for both.
/// Accuracy: 1e-12 against cos(ωΔ/2) of two halves Δ apart without damping.
pub fn residual_vibration(taps: &[f64], rate: f64, omega: f64, ratio: f64) -> f64 {
    let (decay, swing) = (ratio * omega / rate, omega * (1.0 - ratio * ratio).sqrt() / rate);
    let end = last(taps) as f64;
    let sums = taps.iter().enumerate().fold((0.0, 0.0), |(re, im), (index, tap)| {
        let (sine, cosine) = (swing * index as f64).sin_cos();
        // Counted from the end, so that no power overflows.
        let size = tap * (decay * (index as f64 - end)).exp();
        (re + size * cosine, im + size * sine)
    });
    f64::hypot(sums.0, sums.1)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn two_halves_leave_the_cosine_of_half_the_angle_between_them() {
        let mut taps = [0.0; 101];
        (taps[0], taps[100]) = (0.5, 0.5);
        for omega in [0.3, 3.0, 31.4, 94.2] {
            let left = residual_vibration(&taps, 1000.0, omega, 0.0);
            // Rounding of an angle up to 10 and of two terms.
            assert!((left - (0.05 * omega).cos().abs()).abs() < 1e-12, "{left}");
        }
        assert!((residual_vibration(&[1.0], 1000.0, 50.0, 0.1) - 1.0).abs() < 1e-15);
    }

    #[test]
    fn a_damped_mode_rests_after_the_impulses_made_for_it() {
        // κ = e^(−ζπ/√(1−ζ²)), half a damped period of 100 samples.
        let (rate, ratio) = (1000.0, 0.05_f64);
        let omega = std::f64::consts::PI * rate / (100.0 * (1.0 - ratio * ratio).sqrt());
        let decay = (-ratio * std::f64::consts::PI / (1.0 - ratio * ratio).sqrt()).exp();
        let mut taps = [0.0; 101];
        (taps[0], taps[100]) = (1.0 / (1.0 + decay), decay / (1.0 + decay));
        assert!(residual_vibration(&taps, rate, omega, ratio) < 1e-14);
        // One that rings 10 % higher is left with sin(π/20), and a little for the damping.
        assert!((residual_vibration(&taps, rate, 1.1 * omega, ratio) - 0.156).abs() < 0.02);
    }
}
