//! What the causes are called by which a force errs: the lines of a budget.
//!
//! Next door: how each acts on the force (`measurement`).

/// Noise of the readings.
pub const NOISE: &str = "sensor: noise";
/// Steps between readings.
pub const RESOLUTION: &str = "sensor: resolution";
/// Limits of error that are the same for every reading.
pub const FULL_SCALE: &str = "sensor: accuracy of full scale";
/// Limits of error in proportion to the reading.
pub const OF_READING: &str = "sensor: accuracy of reading";
/// The gain, as far as a calibration knows it.
pub const CALIBRATION: &str = "calibration";
/// Measured springs depart from the form of eq. (13).
pub const MEASURED_FORM: &str = "calibration form: measured springs";
/// The coil's own theory departs from it.
pub const THEORY_FORM: &str = "calibration form: eq. (13) itself";
/// Gain and modulus drift.
pub const TEMPERATURE: &str = "temperature";
/// The stiffness is not the nominal one.
pub const STIFFNESS: &str = "tolerance of the stiffness";
/// Nor the rest length.
pub const REST_LENGTH: &str = "tolerance of the rest length";
/// Nor the initial tension.
pub const INITIAL_TENSION: &str = "tolerance of the initial tension";
/// Nor the compliance of the drive train.
pub const COMPLIANCE: &str = "tolerance of the drive train's compliance";
