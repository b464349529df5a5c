//! How fast an input moves, and how fast that changes.
//!
//! Next door: where it is, and its jumps (`input`).

use std::f64::consts::TAU;

use super::input::EndInput;

impl EndInput {
    /// Velocity at time `time` \[s\], from the right where it jumps, in \[m/s\] (\[N/s\] at an end under force).
    pub fn velocity(&self, time: f64) -> f64 {
        match self {
            Self::Held | Self::Step { .. } => 0.0,
            Self::Chirp { amplitude, duration, .. } => {
                let (angle, rate) = self.chirp_angle(time);
                if time < *duration { amplitude * rate * angle.cos() } else { 0.0 }
            }
            Self::Ramp { height, from, duration } => {
                if (*from..from + duration).contains(&time) {
                    height / duration
                } else {
                    0.0
                }
            }
            Self::Harmonics(_) | Self::HalfSine { .. } => self.sines().map(|sine| sine.velocity(time)).sum(),
            Self::Sampled(sampled) => sampled.slope(time),
        }
    }

    /// Acceleration at time `time` \[s\] but for the jumps of [`Self::kicks`], in \[m/s²\] (\[N/s²\] at an end under force).
    pub(crate) fn acceleration(&self, time: f64) -> f64 {
        match self {
            Self::Chirp { amplitude, from, to, duration, .. } if time < *duration => {
                let (angle, rate) = self.chirp_angle(time);
                let growth = TAU * (to - from) / duration;
                amplitude * (growth * angle.cos() - rate * rate * angle.sin())
            }
            Self::Harmonics(_) | Self::HalfSine { .. } => {
                self.sines().map(|sine| -sine.angular * sine.angular * sine.displacement(time)).sum()
            }
            Self::Held | Self::Chirp { .. } | Self::Step { .. } | Self::Ramp { .. } | Self::Sampled(_) => 0.0,
        }
    }

    /// Rate of [`Self::acceleration`] at time `time` \[s\], but for its jumps, in \[m/s³\].
    pub(crate) fn jerk(&self, time: f64) -> f64 {
        match self {
            Self::Chirp { amplitude, from, to, duration, .. } if time < *duration => {
                let (angle, rate) = self.chirp_angle(time);
                let growth = TAU * (to - from) / duration;
                -amplitude * rate * (3.0 * growth * angle.sin() + rate * rate * angle.cos())
            }
            Self::Harmonics(_) | Self::HalfSine { .. } => {
                self.sines().map(|sine| -sine.angular * sine.angular * sine.velocity(time)).sum()
            }
            Self::Held | Self::Chirp { .. } | Self::Step { .. } | Self::Ramp { .. } | Self::Sampled(_) => 0.0,
        }
    }

    /// Rate of [`Self::jerk`] at time `time` \[s\], but for its jumps, in \[m/s⁴\].
    pub(crate) fn snap(&self, time: f64) -> f64 {
        match self {
            Self::Chirp { amplitude, from, to, duration, .. } if time < *duration => {
                let (angle, rate) = self.chirp_angle(time);
                let growth = TAU * (to - from) / duration;
                let (sine, cosine) = angle.sin_cos();
                amplitude * ((rate.powi(4) - 3.0 * growth * growth) * sine - 6.0 * growth * rate * rate * cosine)
            }
            Self::Harmonics(_) | Self::HalfSine { .. } => {
                self.sines().map(|sine| sine.angular.powi(4) * sine.displacement(time)).sum()
            }
            Self::Held | Self::Chirp { .. } | Self::Step { .. } | Self::Ramp { .. } | Self::Sampled(_) => 0.0,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_derivative_is_the_rate_of_the_one_before() {
        let chirp = EndInput::Chirp { amplitude: 0.3, from: 2.0, to: 9.0, duration: 1.0, phase: 0.4 };
        let half = EndInput::HalfSine { height: 0.3, from: 0.1, duration: 0.5 };
        for input in
            [chirp, half, EndInput::harmonic(0.3, 5.0, 1.0), EndInput::Ramp { height: 1.0, from: 0.0, duration: 1.0 }]
        {
            let derivatives = [EndInput::velocity, EndInput::acceleration, EndInput::jerk, EndInput::snap];
            for (order, pair) in derivatives.windows(2).enumerate() {
                let (step, time) = (1e-5, 0.37);
                let rate = (pair[0](&input, time + step) - pair[0](&input, time - step)) / (2.0 * step);
                // Differences: 2π·6 Hz to the third of the step's square, and their rounding.
                let size = (TAU * 6.0).powi(order as i32 + 2);
                assert!((rate - pair[1](&input, time)).abs() < 1e-6 * size, "{order}: {rate} {input:?}");
            }
            assert_eq!(
                [input.acceleration(1.5), input.jerk(1.5), input.snap(1.5)].map(f64::abs) == [0.0; 3],
                !matches!(input, EndInput::Harmonics(_))
            );
        }
    }
}
