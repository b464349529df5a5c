//! What conditions are read against: the spring, its mount and the files.
//!
//! Next door: the conditions (`condition`).

use coilsense::Spring;

use super::Files;
use super::mount::MountSpec;
use super::recordings::Recordings;

/// What conditions are read against.
pub(super) struct Setting<'a> {
    pub spring: &'a Spring,
    pub mount: &'a MountSpec,
    pub files: &'a Files<'a>,
    pub recordings: &'a Recordings,
}
