//! How the ends are driven, as power series about a time: exact for everything that an input is made of.
//!
//! Next door: paths of polynomials (`path`), the lumps' series that follow (`series`).

use super::path::Path;
use super::polynomial::{ORDER, Polynomial};
use crate::excitation::EndInput;

/// What moves an end, or pulls at it.
#[derive(Debug, Clone, PartialEq)]
pub enum Drive {
    /// An input of an [`crate::Excitation`], counted from this value \[m, or N at an end under force\].
    Input(EndInput, f64),
    /// Polynomials, one after the other.
    Path(Path),
}

impl Drive {
    /// Coefficients of its series in τ = (t − `time`)/`step`, valid up to the next knot.
    pub(super) fn series(&self, time: f64, step: f64) -> Polynomial {
        let mut series = [0.0; ORDER + 1];
        match self {
            Self::Path(path) => shifted(path, time, step, &mut series),
            Self::Input(EndInput::Chirp { amplitude, from, to, duration, phase }, _) if time < *duration => {
                let growth = std::f64::consts::TAU * (to - from) / duration;
                let rate = std::f64::consts::TAU * from + growth * time;
                let angle = phase + std::f64::consts::TAU * time * (from + 0.5 * (to - from) / duration * time);
                chirp(*amplitude, angle, [rate * step, 0.5 * growth * step * step], &mut series);
            }
            Self::Input(input @ EndInput::Chirp { .. }, _) => series[0] = input.displacement(time),
            Self::Input(input, _) => {
                let (value, rate) = input.straight_part(time);
                (series[0], series[1]) = (value, rate * step);
                for sine in input.sines().filter(|sine| sine.acts_at(time)) {
                    let angle = sine.angular * (time - sine.since) + sine.phase;
                    add_sine(sine.amplitude, angle, sine.angular * step, &mut series);
                }
            }
        }
        if let Self::Input(_, mean) = self {
            series[0] += mean;
        }
        series
    }

    /// Times after zero at which the series changes \[s\], ascending.
    pub(super) fn knots(&self) -> Vec<f64> {
        match self {
            Self::Path(path) => path.knots().iter().copied().filter(|knot| *knot > 0.0).collect(),
            Self::Input(input, _) => input.kicks().into_iter().map(|kick| kick.time).collect(),
        }
    }

    /// Largest angular frequency \[rad/s\] of its series.
    pub(super) fn highest_angular(&self) -> f64 {
        match self {
            Self::Path(_) => 0.0,
            Self::Input(input, _) => input.highest_angular(),
        }
    }
}

/// a sin(angle + x τ): every derivative is the sine a quarter turn on.
fn add_sine(amplitude: f64, angle: f64, x: f64, series: &mut Polynomial) {
    let (sine, cosine) = angle.sin_cos();
    let turns = [sine, cosine, -sine, -cosine];
    let mut factor = amplitude;
    for (power, coefficient) in series.iter_mut().enumerate() {
        *coefficient += factor * turns[power % 4];
        factor *= x / (power + 1) as f64;
    }
}

/// a sin(angle + r τ + g τ²) with its cosine: s' = (r + 2gτ) c, c' = −(r + 2gτ) s, power by power.
fn chirp(amplitude: f64, angle: f64, [r, g]: [f64; 2], series: &mut Polynomial) {
    let mut cosines = [0.0; ORDER + 1];
    (series[0], cosines[0]) = (amplitude * angle.sin(), amplitude * angle.cos());
    for power in 1..=ORDER {
        let of =
            |values: &Polynomial| r * values[power - 1] + if power > 1 { 2.0 * g * values[power - 2] } else { 0.0 };
        let [sine, cosine] = [of(&cosines), -of(series)];
        (series[power], cosines[power]) = (sine / power as f64, cosine / power as f64);
    }
}

/// The polynomial under way, about another time.
fn shifted(path: &Path, time: f64, step: f64, series: &mut Polynomial) {
    let (piece, since) = path.at(time);
    series[..piece.len()].copy_from_slice(piece);
    for from in 0..piece.len() {
        for power in (from..piece.len() - 1).rev() {
            series[power] += since * series[power + 1];
        }
    }
    let mut factor = 1.0;
    for coefficient in &mut series[..piece.len()] {
        *coefficient *= factor;
        factor *= step;
    }
}

#[cfg(test)]
mod tests {
    use super::super::polynomial::value;
    use super::*;

    #[test]
    fn a_series_is_its_input_over_a_step() {
        let chirp = EndInput::Chirp { amplitude: 0.3, from: 2.0, to: 90.0, duration: 1.0, phase: 0.4 };
        let half = EndInput::HalfSine { height: 0.3, from: 0.1, duration: 0.5 };
        let ramp = EndInput::Ramp { height: 1.0, from: 0.0, duration: 1.0 };
        for input in [chirp, half, ramp, EndInput::harmonic(0.3, 50.0, 1.0), EndInput::Held] {
            let series = Drive::Input(input.clone(), 0.5).series(0.37, 4e-3);
            // A step of 1.3 rad at most: the first power left out is 1e-25.
            for tau in [0.0, 0.4, 1.0] {
                let expected = 0.5 + input.displacement(0.37 + tau * 4e-3);
                assert!((value(&series, tau) - expected).abs() < 1e-14, "{input:?}");
            }
        }
        let path = Path::new(vec![0.1, 0.9], vec![vec![0.2, -1.0, 3.0, 0.7, -2.0]]).unwrap();
        let series = Drive::Path(path.clone()).series(0.37, 0.1);
        assert!((value(&series, 0.6) - path.value(0.43)).abs() < 1e-15);
    }
}
