//! What was heard of each line that decays: where it lies, how sure that is, how it dies out, and how the two ends pull in it.
//!
//! Next door: where the numbers come from (`refine`), what explains them (the parent).

use std::f64::consts::TAU;

use num_complex::Complex;

use crate::identify::fitted::Fitted;
use crate::identify::ringing::{Part, Series};

/// One line that decays.
#[derive(Debug, Clone)]
pub(in crate::identify) struct Heard {
    /// Its place among the lines of the record.
    pub(in crate::identify) line: usize,
    /// Undamped frequency \[Hz\], and its relative standard uncertainty \[1\].
    pub(super) frequency: f64,
    /// ln of it.
    pub(super) log: f64,
    pub(super) spread: f64,
    /// Decay rate of the amplitude \[1/s\], and its relative standard uncertainty \[1\].
    pub(super) decay: f64,
    pub(super) decay_spread: f64,
    /// Σ over hits and ends of ∫ a² dt, a its amplitude \[N² s\].
    pub(super) energy: f64,
    /// Σ over hits and ends of the amplitudes' squares right after the hit \[N²\].
    pub(super) loudness: f64,
    /// Whether its size is what drove it, and not what a filter left of it.
    pub(in crate::identify) sized: bool,
    /// How the ends pull, where both forces were recorded.
    pub(super) ends: Option<Ends>,
    /// Amplitude after each hit where it is heard better \[N\]: (hit, complex amplitude).
    pub(super) by_hit: Vec<(usize, Complex<f64>)>,
}

/// F_o beside F_i in one line, over all hits.
#[derive(Debug, Clone, Copy)]
pub(in crate::identify) struct Ends {
    /// Phase of F_o over F_i \[rad\].
    pub(super) phase: f64,
    /// ln |F_o/F_i|.
    pub(super) ratio: f64,
    /// Standard uncertainty of either.
    pub(super) spread: f64,
    /// Whether sizes say anything: a channel that is late may be soft, too.
    pub(super) sized: bool,
}

impl Heard {
    /// Undamped frequency \[Hz\].
    pub(in crate::identify) fn frequency(&self) -> f64 {
        self.frequency
    }

    /// ζ \[1\].
    pub(super) fn ratio(&self) -> f64 {
        self.decay / (TAU * self.frequency)
    }

    /// The same with F_o earlier by `delay` \[s\].
    pub(super) fn earlier(&self, delay: f64) -> Self {
        let ends =
            self.ends.map(|ends| Ends { phase: ends.phase + TAU * self.frequency * delay, sized: false, ..ends });
        Self { ends, ..self.clone() }
    }

    /// Of a fitted line; none where it has no amplitude at all.
    pub(in crate::identify) fn of(line: usize, fitted: &Fitted, series: &[Series], rate: f64) -> Option<Self> {
        let size = fitted.pole.norm();
        let amplitude = |part: Part, hit: usize| -> Complex<f64> {
            let of = |entry: &&(usize, usize, Complex<f64>)| entry.1 == hit && series[entry.0].part == part;
            fitted.amplitudes.iter().chain(&fitted.elsewhere).find(of).map_or(Complex::default(), |entry| entry.2)
        };
        // Standard uncertainty of an amplitude: white noise against an exponential that lasts 1/2σ samples.
        let noise = |part: Part| {
            let own = series.iter().find(|series| series.part == part).map_or(0.0, |series| series.noise);
            own * (4.0 * fitted.pole.re.abs()).sqrt()
        };
        let both = series.len() > 1;
        let mut own: [Vec<(usize, Complex<f64>)>; 2] = Default::default();
        for &hit in &fitted.hits {
            if both {
                let (difference, sum) = (amplitude(Part::Difference, hit), amplitude(Part::Sum, hit));
                own[0].push((hit, sum - difference));
                own[1].push((hit, sum + difference));
            } else {
                own[0].push((hit, amplitude(series[0].part, hit)));
            }
        }
        let power = |end: usize| own[end].iter().map(|entry| entry.1.norm_sqr()).sum::<f64>();
        let powers = [power(0), power(1)];
        let energy = powers[0] + powers[1];
        let ends = both.then(|| {
            let cross: Complex<f64> = own[1].iter().zip(&own[0]).map(|(o, i)| o.1 * i.1.conj()).sum();
            let each = (noise(Part::Difference).powi(2) + noise(Part::Sum).powi(2)) * fitted.hits.len() as f64;
            let least = powers[0].min(powers[1]).max(f64::MIN_POSITIVE);
            // What is incoherent between hits is uncertainty too.
            let coherence = cross.norm_sqr() / (powers[0] * powers[1]).max(f64::MIN_POSITIVE);
            let loose = ((1.0 - coherence).max(0.0) / (2.0 * fitted.hits.len() as f64)).sqrt();
            Ends {
                phase: cross.arg(),
                ratio: 0.5 * (powers[1].max(each) / powers[0].max(each).max(f64::MIN_POSITIVE)).ln(),
                spread: (each / least / fitted.hits.len() as f64).sqrt().hypot(loose).min(3.0),
                sized: true,
            }
        });
        let by_hit = std::mem::take(&mut own[usize::from(powers[1] > powers[0])]);
        (energy > 0.0 && size > 0.0).then_some(Self {
            line,
            frequency: size * rate / TAU,
            log: (size * rate / TAU).ln(),
            spread: fitted.standard / size,
            decay: -fitted.pole.re * rate,
            decay_spread: (fitted.standard / fitted.pole.re).abs(),
            loudness: energy,
            sized: true,
            energy: 0.5 * energy / (-fitted.pole.re * rate).max(f64::MIN_POSITIVE),
            ends,
            by_hit,
        })
    }
}
