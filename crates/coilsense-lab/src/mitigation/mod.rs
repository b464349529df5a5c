//! Doing something about ringing, for people: settings as files that a controller takes.
//!
//! Next door: the designs (`coilsense::mitigation`), the steps (`coilsense-rt`).

pub mod export;
