//! A line as its fit left it.
//!
//! Next door: the fits (`refine`), what is heard of it by them (`explain`).

use num_complex::Complex;

/// A line, fitted.
#[derive(Debug, Clone)]
pub(super) struct Fitted {
    /// In which series it rings.
    pub(super) series: Vec<usize>,
    /// λ \[per sample\].
    pub(super) pole: Complex<f64>,
    /// Standard uncertainty of Re λ and Im λ each \[per sample\]; infinite before it is fitted.
    pub(super) standard: f64,
    /// Real degrees of freedom.
    pub(super) freedom: f64,
    /// Hits used.
    pub(super) hits: Vec<usize>,
    /// Peak amplitude \[N\] per series and hit, at the stretch's begin: (series, hit, 2|A|, its phase).
    pub(super) amplitudes: Vec<(usize, usize, Complex<f64>)>,
    /// The same in series in which it was not fitted.
    pub(super) elsewhere: Vec<(usize, usize, Complex<f64>)>,
    /// Strength of the peak it came from.
    pub(super) strength: f64,
}

impl Fitted {
    /// Whether it is the mode that the fit was sent for.
    pub(super) fn is_mode(&self, guess: Complex<f64>) -> bool {
        let damped = self.pole.re / guess.re;
        let sure = -self.pole.re > 6.0 * self.standard;
        sure && (self.pole.im / guess.im - 1.0).abs() < 0.06 && (0.3..3.0).contains(&damped)
    }
}

/// Lines that came to the same pole are one: the surer one stays.
pub(super) fn without_doubles(mut lines: Vec<Fitted>) -> Vec<Fitted> {
    let mut kept: Vec<Fitted> = Vec::new();
    lines.sort_by(|a, b| b.strength.total_cmp(&a.strength));
    for line in lines {
        let same = |other: &&mut Fitted| {
            let near =
                0.3 * (line.pole.re.abs().min(other.pole.re.abs())) + 4.0 * line.standard.min(1.0).min(other.standard);
            (other.pole.im - line.pole.im).abs() < near
        };
        match kept.iter_mut().find(same) {
            Some(other) => {
                for series in &line.series {
                    if !other.series.contains(series) {
                        other.series.push(*series);
                    }
                }
            }
            None => kept.push(line),
        }
    }
    kept
}
