//! Doing something about it: from a spring, its damping, its tolerances and a sampling rate to the settings of what `coilsense-rt` runs.
//!
//! | for | designed by | runs as |
//! |---|---|---|
//! | a force without its ringing | [`low_pass`], [`notch()`], [`surge_notches`] | [`coilsense_rt::Cascade`] |
//! | the same, all n·f1 at once | [`surge_mean`], [`surge_comb`], [`surge_window`] | [`coilsense_rt::Boxcar`], [`coilsense_rt::Comb`], [`coilsense_rt::Window`] |
//! | F_o from F_i, u1, u2 | [`delay_line_observer`], [`modal_kalman`], [`observer_bank`] | [`coilsense_rt::DelayLineObserver`] … |
//! | F_i with F_L's truth | [`inductance_fusion`] | [`coilsense_rt::Fusion`] |
//! | commands that do not ring | [`zero_vibration`], [`zero_vibration_derivative`], [`surge_mean`], [`double_mean`] | [`coilsense_rt::Shaper`] … |
//!
//! [`Coefficients`] says whether a cascade is stable, and what it is once its coefficients are rounded; [`ringing_error_bound`] how wrong an
//! observer can be on any spring of a box. Next door: which of them does best under given conditions (`coilsense-lab`), the steps themselves (`coilsense-rt`).
//!
//! [`low_pass`]: crate::mitigation::low_pass
//! [`notch()`]: crate::mitigation::notch
//! [`surge_notches`]: crate::mitigation::surge_notches
//! [`surge_mean`]: crate::mitigation::surge_mean
//! [`surge_comb`]: crate::mitigation::surge_comb
//! [`surge_window`]: crate::mitigation::surge_window
//! [`delay_line_observer`]: crate::mitigation::delay_line_observer
//! [`modal_kalman`]: crate::mitigation::modal_kalman
//! [`observer_bank`]: crate::mitigation::observer_bank
//! [`inductance_fusion`]: crate::mitigation::inductance_fusion
//! [`zero_vibration`]: crate::mitigation::zero_vibration
//! [`zero_vibration_derivative`]: crate::mitigation::zero_vibration_derivative
//! [`double_mean`]: crate::mitigation::double_mean
//! [`Coefficients`]: crate::mitigation::Coefficients
//! [`ringing_error_bound`]: crate::mitigation::ringing_error_bound

mod bank;
mod bound;
mod butterworth;
mod coefficients;
mod fusion;
mod kalman;
mod notch;
mod riccati;
mod sampled_spring;
mod shapers;
mod surge;
mod tolerance;
mod waves;
mod window;

pub use bank::{BankDesign, observer_bank};
pub use bound::ringing_error_bound;
pub use butterworth::low_pass;
pub use coefficients::{Coefficients, Rounding};
pub use fusion::inductance_fusion;
pub use kalman::{KalmanNoise, modal_kalman};
pub use notch::{notch, surge_notches};
pub use riccati::steady_covariance;
pub use sampled_spring::SampledSpring;
pub use shapers::{zero_vibration, zero_vibration_derivative};
pub use surge::{double_mean, surge_comb, surge_mean};
pub use tolerance::ToleranceBox;
pub use waves::delay_line_observer;
pub use window::{WindowDesign, surge_window};
