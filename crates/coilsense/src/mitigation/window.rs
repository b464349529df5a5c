//! The window that makes the least of an impact's ringing, of noise and of its own lateness together.
//!
//! Next door: the mean over a surge period (`surge`), of which this is the refinement.

use coilsense_rt::Window;
use nalgebra::{DMatrix, DVector};

use super::sampled_spring::SampledSpring;
use super::tolerance::ToleranceBox;
use crate::damping::Damping;
use crate::error::{Error, above_zero, called, check, not_negative};
use crate::excitation::Excitation;
use crate::motion::Motion;
use crate::mount::{FarEnd, Mount};
use crate::signals::sampled_window;

/// What the window is to be good at.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct WindowDesign {
    /// v of the shocks \[m/s\], above zero.
    pub impact: f64,
    /// A shock every so long \[s\], at least the window's own length.
    pub interval: f64,
    /// Up to which frequency the force itself moves \[Hz\], below f1.
    pub bandwidth: f64,
    /// By how much it moves \[N rms\].
    pub motion: f64,
    /// White noise of the force \[N rms per sample\], above zero.
    pub noise: f64,
    /// The springs over which errors are averaged; `None` is the nominal one alone.
    pub tolerances: Option<ToleranceBox>,
}

/// The window of `N` taps with the least mean square of y − F_x over one impact after the other.
///
/// min over h, Σ h_i = 1: hᵀ (R + σ² 1) h + ∫ |H(f) − 1|² S(f) df, R_ij the mean of d(t − i) d(t − j) over an interval,
/// d = F_i − F_x after an impact, S the force's own power, even up to the bandwidth
///
/// Source:   `[Oppenheim2010]` section 11 (least squares, normal equations), with the ringing of [`Motion`] for the signal to be rid of.
/// Valid:    a force held at rest before each shock; N up to 1024.
/// Accuracy: no other window does better on its own conditions: neighbours are tried in the tests.
///
/// # Errors
/// [`Error::Value`] for values outside of what [`WindowDesign`] says, and for no or too many taps.
pub fn surge_window<const N: usize>(spring: &SampledSpring, design: &WindowDesign) -> Result<Window<f64, N>, Error> {
    checked(spring, design, N)?;
    let springs = match &design.tolerances {
        None => vec![spring.spring().clone()],
        Some(tolerances) => tolerances
            .corners()
            .into_iter()
            .map(|corner| ToleranceBox::changed(spring.spring(), corner))
            .collect::<Result<_, _>>()?,
    };
    let mut unwanted = DVector::<f64>::zeros(N);
    for spring_there in &springs {
        unwanted += ringing(&spring.on(spring_there)?, design, N)? / springs.len() as f64;
    }
    unwanted[0] += design.noise * design.noise;
    let power = design.motion * design.motion;
    let own = |lag: f64| power * sinc(2.0 * design.bandwidth * lag / spring.rate());
    let quadratic = DMatrix::from_fn(N, N, |i, j| unwanted[i.abs_diff(j)] + own(i.abs_diff(j) as f64));
    let wanted = DVector::from_fn(N, |i, _| own(i as f64));
    let taps = solve(quadratic, &wanted)?;
    Ok(Window { taps: std::array::from_fn(|i| taps[i]) })
}

fn checked(spring: &SampledSpring, design: &WindowDesign, taps: usize) -> Result<(), Error> {
    check((1..=1024).contains(&taps), "taps of the window", taps as f64, "", "from 1 to 1024")?;
    above_zero(called("impact", "impact velocity"), design.impact, "m/s")?;
    let shortest = taps as f64 / spring.rate();
    let allowed = format!("from the window's own {shortest} s to 60 s");
    check(
        (shortest..=60.0).contains(&design.interval),
        called("interval", "interval of shocks"),
        design.interval,
        "s",
        allowed,
    )?;
    let first = spring.spring().surge_frequency();
    let holds = design.bandwidth > 0.0 && design.bandwidth < first;
    let allowed = format!("above zero and below the first surge frequency of {first:.3} Hz");
    check(holds, "bandwidth", design.bandwidth, "Hz", allowed)?;
    not_negative(called("motion", "motion of the force"), design.motion, "N")?;
    above_zero(called("noise", "noise of the force"), design.noise, "N")?;
    Ok(())
}

/// Mean of d(t) d(t + lag) over an interval that begins with an impact; shape `lags`.
fn ringing(spring: &SampledSpring, design: &WindowDesign, lags: usize) -> Result<DVector<f64>, Error> {
    let mount = Mount::new(FarEnd::Position, Damping::ModalEach(spring.ratios().to_vec()))?;
    let length = spring.spring().mid_length();
    let motion = Motion::mounted(spring.spring(), &mount, &Excitation::impact(length, design.impact)?)?;
    let times = sampled_window(spring.rate(), 0.0, design.interval)?;
    let still = spring.spring().static_force(length);
    let ringing: Vec<f64> = motion.end_forces(&times)?.input.iter().map(|force| force - still).collect();
    let mean = |lag: usize| ringing.iter().zip(&ringing[lag.min(ringing.len())..]).map(|(a, b)| a * b).sum::<f64>();
    Ok(DVector::from_fn(lags, |lag, _| mean(lag) / ringing.len() as f64))
}

/// h of min hᵀQh − 2wᵀh with Σ h = 1.
fn solve(quadratic: DMatrix<f64>, wanted: &DVector<f64>) -> Result<DVector<f64>, Error> {
    let ones = DVector::from_element(wanted.len(), 1.0);
    let Some(factor) = quadratic.cholesky() else {
        let allowed = "large enough against the ringing and the motion to tell windows apart";
        return check(false, called("noise", "noise of the force"), 0.0, "N", allowed).map(|_| ones);
    };
    let (free, level) = (factor.solve(wanted), factor.solve(&ones));
    let share = (1.0 - free.sum()) / level.sum();
    Ok(free + level * share)
}

fn sinc(x: f64) -> f64 {
    let angle = std::f64::consts::PI * x;
    if angle == 0.0 { 1.0 } else { angle.sin() / angle }
}
