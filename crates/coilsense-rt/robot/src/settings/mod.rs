//! Settings for S_T at 2.5 kHz as coilsense exports them; a test of the exports holds them to be just that.

pub mod comb;
pub mod five_notches;
pub mod kalman;
pub mod notch;
#[allow(dead_code, reason = "the plant's own type tells its modes")]
pub mod plant;
pub mod surge_mean;
#[allow(dead_code, reason = "a window's state tells its ring by its own type")]
pub mod window;
