//! Which candidates there are: what one tries first, and what is fitted to noise, shocks and tolerances.
//!
//! Next door: how they run (`candidate`), how they are judged (`judge`).

use coilsense::Error;
use coilsense::mitigation::{
    BankDesign, KalmanNoise, SampledSpring, ToleranceBox, WindowDesign, delay_line_observer, double_mean, low_pass,
    modal_kalman, notch, observer_bank, surge_comb, surge_mean, surge_notches, surge_window,
};
use coilsense_rt::{Biquad, Cascade, ModalKalman};

use super::candidate::{Candidate, LeftOut, Origin, Truth};
use super::start::{Deflection, Plain, RING};

/// What designs are fitted to.
pub(super) struct Brief<'a> {
    pub spring: &'a SampledSpring,
    pub tolerances: ToleranceBox,
    /// N rms.
    pub noise: f64,
    /// m/s.
    pub impact: f64,
    /// s.
    pub interval: f64,
    /// Hz.
    pub bandwidth: f64,
    /// N rms.
    pub motion: f64,
}

/// Candidates, and those that cannot be on this spring at this rate.
#[derive(Default)]
pub(super) struct Candidates {
    pub all: Vec<Candidate>,
    pub left_out: Vec<LeftOut>,
}

impl Candidates {
    fn add(&mut self, name: &str, made: impl FnOnce(&str) -> Result<Candidate, Error>) {
        match made(name) {
            Ok(candidate) => self.all.push(candidate),
            Err(error) => self.left_out.push(LeftOut { name: name.to_owned(), reason: error.to_string() }),
        }
    }

    pub fn of(brief: &Brief<'_>) -> Self {
        let mut candidates = Self::default();
        candidates.all.push(Candidate::new("F_i, unfiltered", Origin::Raw, Truth::Static, Plain));
        candidates.first_filters(brief);
        candidates.fitted_filters(brief);
        let deflection = Deflection(brief.spring.spring().clone());
        candidates.all.push(Candidate::new("k·Δl of the nominal spring", Origin::Raw, Truth::Output, deflection));
        candidates.first_estimators(brief);
        candidates.fitted_estimators(brief);
        let fits = |candidate: &Candidate| candidate.settings().and_then(|s| s.ring()).is_none_or(|ring| ring <= RING);
        let (fitting, longer) = candidates.all.into_iter().partition(fits);
        candidates.all = fitting;
        let longer: Vec<Candidate> = longer;
        candidates.left_out.extend(longer.into_iter().map(|candidate| LeftOut {
            name: candidate.name,
            reason: format!("its ring must be at most {RING} samples"),
        }));
        candidates
    }

    fn first_filters(&mut self, brief: &Brief<'_>) {
        let (spring, rate) = (brief.spring, brief.spring.rate());
        let first = spring.spring().surge_frequency();
        let filter = |name: &str, sections: Vec<Biquad<f64>>| cascade(name, &sections);
        self.add("Butterworth of order 2 at f1/2", |name| filter(name, low_pass(2, 0.5 * first, rate)?));
        self.add("notch at f1, Q = 2", |name| filter(name, vec![notch(first, 2.0, rate)?]));
        self.add("five notches n·f1, Q = 3", |name| filter(name, surge_notches(spring, 5, 3.0)?));
        self.add("mean over 2τ", |name| Ok(Candidate::new(name, Origin::Textbook, Truth::Static, surge_mean(spring))));
    }

    fn fitted_filters(&mut self, brief: &Brief<'_>) {
        let first = brief.spring.spring().surge_frequency();
        self.add("comb n·f1, as wide as 0.4 f1", |name| {
            Ok(Candidate::new(name, Origin::Fitted, Truth::Static, surge_comb(brief.spring, 0.4 * first)?))
        });
        self.add("two means, 2τ ± 7 %", |name| {
            Ok(Candidate::new(name, Origin::Fitted, Truth::Static, double_mean(brief.spring, 0.07)?))
        });
        for (periods, length) in [("one surge period", 1.0), ("two surge periods", 2.0), ("three surge periods", 3.0)] {
            for (kind, tolerances) in [("nominal", None), ("tolerant", Some(brief.tolerances))] {
                let name = format!("fitted FIR filter, {periods}, {kind}");
                self.add(&name, |name| window(name, brief, length * brief.spring.surge_period(), tolerances));
            }
        }
    }

    fn first_estimators(&mut self, brief: &Brief<'_>) {
        let spring = brief.spring;
        let truth = Truth::Output;
        let noise =
            KalmanNoise { force: brief.noise, shock: 0.0, ringing: 8.3 * brief.noise, drift: 2.1 * brief.noise };
        self.add("Kalman filter, 3 modes, no bias", |name| {
            let mut filter: ModalKalman<f64, 3> = modal_kalman(spring, &noise)?;
            filter.bias_gain = 0.0;
            Ok(Candidate::new(name, Origin::Textbook, truth, filter))
        });
        self.add("Kalman filter, 3 modes, bias", |name| {
            Ok(Candidate::new(name, Origin::Textbook, truth, modal_kalman::<3>(spring, &noise)?))
        });
        self.add("delay line", |name| {
            Ok(Candidate::new(name, Origin::Textbook, truth, delay_line_observer(spring, 1.0)?))
        });
    }

    fn fitted_estimators(&mut self, brief: &Brief<'_>) {
        let spring = brief.spring;
        let truth = Truth::Output;
        self.add("delay line, gain 0.5", |name| {
            Ok(Candidate::new(name, Origin::Fitted, truth, delay_line_observer(spring, 0.5)?))
        });
        for (word, share) in [("smooth", 0.6), ("fast", 1.2)] {
            // What one shock a second brings; the bias wanders, and modes are knocked about, by a share of the noise.
            let noise = KalmanNoise {
                force: brief.noise,
                shock: share * brief.impact,
                ringing: 0.42 * brief.noise,
                drift: 0.42 * brief.noise,
            };
            let agile = KalmanNoise { drift: 2.1 * brief.noise, ..noise };
            self.add(&format!("Kalman filter, 5 modes, bias, impacts ({word})"), |name| {
                Ok(Candidate::new(name, Origin::Fitted, truth, modal_kalman::<5>(spring, &agile)?))
            });
            let design = BankDesign { noise, stiffnesses: 3, memory: 0.1, sharpness: 30.0 };
            self.add(&format!("bank of 21 Kalman filters ({word})"), |name| {
                let bank = observer_bank::<5, 21>(spring, &brief.tolerances, &design)?;
                Ok(Candidate::new(name, Origin::Fitted, truth, bank))
            });
        }
    }
}

/// Sections as a cascade: one, two or five of them.
fn cascade(name: &str, sections: &[Biquad<f64>]) -> Result<Candidate, Error> {
    let made = |start| Ok(start);
    let (origin, truth) = (Origin::Textbook, Truth::Static);
    match sections {
        [a] => made(Candidate::new(name, origin, truth, Cascade { sections: [*a] })),
        [a, b] => made(Candidate::new(name, origin, truth, Cascade { sections: [*a, *b] })),
        [a, b, c, d, e] => made(Candidate::new(name, origin, truth, Cascade { sections: [*a, *b, *c, *d, *e] })),
        _ => Err(Error::Count {
            field: None,
            quantity: "sections".into(),
            found: sections.len(),
            allowed: "1, 2 or 5".into(),
        }),
    }
}

/// A fitted window of about `length` samples: sizes are steps of a third or less, since they are fixed when this is compiled.
fn window(name: &str, brief: &Brief<'_>, length: f64, tolerances: Option<ToleranceBox>) -> Result<Candidate, Error> {
    const SIZES: [usize; 11] = [16, 24, 32, 48, 64, 96, 144, 192, 288, 384, 512];
    let distance = |size: &&usize| (**size as f64 / length).ln().abs();
    let size = SIZES.iter().min_by(|a, b| distance(a).total_cmp(&distance(b))).copied().unwrap_or(SIZES[0]);
    match size {
        16 => sized::<16>(name, brief, tolerances),
        24 => sized::<24>(name, brief, tolerances),
        32 => sized::<32>(name, brief, tolerances),
        48 => sized::<48>(name, brief, tolerances),
        64 => sized::<64>(name, brief, tolerances),
        96 => sized::<96>(name, brief, tolerances),
        144 => sized::<144>(name, brief, tolerances),
        192 => sized::<192>(name, brief, tolerances),
        288 => sized::<288>(name, brief, tolerances),
        384 => sized::<384>(name, brief, tolerances),
        _ => sized::<512>(name, brief, tolerances),
    }
}

fn sized<const TAPS: usize>(
    name: &str,
    brief: &Brief<'_>,
    tolerances: Option<ToleranceBox>,
) -> Result<Candidate, Error> {
    let design = WindowDesign {
        impact: brief.impact,
        interval: brief.interval,
        bandwidth: brief.bandwidth,
        motion: brief.motion,
        noise: brief.noise,
        tolerances,
    };
    let window = surge_window::<TAPS>(brief.spring, &design)?;
    Ok(Candidate::new(format!("{name} ({TAPS} taps)"), Origin::Fitted, Truth::Static, window))
}
