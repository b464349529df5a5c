//! From a log to numbers: is it the spring that rings, how stiff, how heavy and how damped is it, and up to where can its forces be trusted?
//!
//! ```text
//! Signals ─► stiffness (slow parts) ─► forces less the slow ones ─► hits ─► lines ─► ring-down fit ─► mode series ─► verdict
//! ```
//!
//! Both ends' forces are taken apart into what they pull in turn and what they pull together: between held ends a spring's odd modes
//! are in the first and its even ones in the second. Next door: what is recorded (`signals`), the modes that are expected (`modes`).

mod beginning;
mod end_motion;
mod half_power;
mod hits;
mod line;
mod lines;
mod mode_series;
mod naming;
mod pole_fit;
mod quasi_static;
mod refine;
mod ring_down;
mod ringing;
mod run;
mod sampling;
mod settings;
mod trust;
mod value;
mod verdict;
mod welch;
mod whitening;

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

/// What a record says of its spring.
#[derive(Debug, Clone, PartialEq)]
pub struct Identification {
    /// When it was sampled.
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
    /// N of the chain whose mode series fits best; none for the continuous coil, or where it was given.
    pub fitted_windings: Option<f64>,
    /// Mass at end 2 \[kg\], where end 2 moves with the ringing and F_o and u2 were recorded.
    pub end_mass: Option<f64>,
    /// f1 \[Hz\] of the spring with both ends held, undamped.
    pub first_frequency: Option<Estimate>,
    /// ζ \[1\] of the lowest mode that was found.
    pub ratio: Option<Estimate>,
    /// τ \[s\].
    pub transit_time: Option<Estimate>,
    /// m = k τ² \[kg\]: the mass that rings.
    pub mass: Option<Estimate>,
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
