//! From a log to numbers: is it the spring that rings, how stiff, how heavy and how damped is it, and up to where can its forces be trusted?
//!
//! ```text
//! Signals ─► channels checked, at their own pace ─► stiffness (slow parts) ─► forces less the slow ones ─► hits ─► lines ─► ring-down fit
//!         ─► explanations weighed ─► verdict ─► satellites named
//! ```
//!
//! Both ends' forces are taken apart into what they pull in turn and what they pull together: between held ends a spring's odd modes
//! are in the first and its even ones in the second. Next door: what is recorded (`signals`), the modes that are expected (`modes`).

mod beginning;
mod channel_check;
mod clipping;
mod decaying;
mod end_motion;
mod explain;
mod filtering;
mod fitted;
mod forces;
mod half_power;
mod hits;
mod last_digit;
mod line;
mod lines;
mod median;
mod mode_series;
mod naming;
mod phase_law;
mod pole_fit;
mod prediction;
mod quasi_static;
mod reasons;
mod record_lines;
mod record_stiffness;
mod refine;
mod residuals;
mod ring_down;
mod ringing;
mod run;
mod running_mean;
mod sampling;
mod satellites;
mod settings;
mod signs;
mod slow_motion;
mod taken_out;
mod trust;
mod update_clock;
mod value;
mod verdict;
mod weak_lines;
mod welch;
mod whitening;

pub use channel_check::ChannelCheck;
pub use clipping::Clipping;
pub use explain::Weight;
pub use hits::Hit;
pub use line::{Line, Meaning};
pub use mode_series::ModeSeries;
pub use quasi_static::Stiffness;
pub use ring_down::RingDown;
pub use ringing::Part;
pub use sampling::Sampling;
pub use settings::Settings;
pub use trust::Trust;
pub use value::Estimate;
pub use verdict::{Answer, Verdict};
pub use welch::Welch;

use crate::signals::Channel;

/// What a record says of its spring.
#[derive(Debug, Clone, PartialEq)]
pub struct Identification {
    /// What each force channel can show.
    pub channels: Vec<ChannelCheck>,
    /// When it was sampled, or, where all forces are held, when they have new values.
    pub sampling: Sampling,
    /// What was known beforehand.
    pub settings: Settings,
    /// Whether forces at both ends were recorded.
    pub has_both_forces: bool,
    /// Stiffness and length without force, or why there is none.
    pub stiffness: Result<Stiffness, String>,
    /// The hits.
    pub hits: Vec<Hit>,
    /// The lines, lowest frequency first.
    pub lines: Vec<Line>,
    /// The mount whose mode series fits, where modes were found.
    pub mode_series: Option<ModeSeries>,
    /// What may be the cause of the lines, the likeliest first.
    pub explanations: Vec<Weight>,
    /// N of the chain whose mode series fits best; none for the continuous coil, or where it was given.
    pub fitted_windings: Option<f64>,
    /// Whether the windings that were said count for nothing, since the lines contradict them.
    pub windings_left_out: bool,
    /// Mass at end 2 \[kg\], where end 2 moves with the ringing and F_o and u2 were recorded.
    pub end_mass: Option<f64>,
    /// f1 \[Hz\] of the spring with both ends held, undamped.
    pub first_frequency: Option<Estimate>,
    /// Where f1 lies \[Hz\] with 95 %: noise, and what the mount may do to it.
    pub first_range: Option<(f64, f64)>,
    /// ζ \[1\] of the lowest mode that was found.
    pub ratio: Option<Estimate>,
    /// Which mode that is.
    pub ratio_mode: Option<usize>,
    /// τ \[s\].
    pub transit_time: Option<Estimate>,
    /// m = k τ² \[kg\]: the mass that rings.
    pub mass: Option<Estimate>,
    /// Where m lies \[kg\] with 95 %: noise, and what the mount may do to f1.
    pub mass_range: Option<(f64, f64)>,
    /// The channel whose sign is turned, where one is.
    pub turned: Option<Channel>,
    /// Whether F_i and F_o have opposite signs, and nothing tells which is turned.
    pub opposed: bool,
    /// f1 \[Hz\] that mass or spec predicted.
    pub predicted: Option<f64>,
    /// Up to where forces can be trusted.
    pub trust: Option<Trust>,
    /// Power spectra of the parts of the forces \[N²/Hz\].
    pub spectra: Vec<(Part, Welch)>,
    /// Standard deviation of each part's noise \[N\].
    pub noise: Vec<(Part, f64)>,
    /// The strongest hit's ringing beside its fit.
    pub ring_down: Option<RingDown>,
    /// The answer.
    pub verdict: Verdict,
}
