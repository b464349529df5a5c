//! Logs as instruments and people write them: read to the last bit, cleaned when that is allowed, each row accounted for.
//!
//! | file | holds |
//! |---|---|
//! | `layouts` | how texts are written: delimiters, decimal signs, titles, units, stamps |
//! | `cleaning` | what is cleaned, and that nothing is lost without being counted |
//! | `clocks` | times that do not rise evenly |
//! | `formats`, `matlab`, `instruments` | files of other programs, values compared exactly |
//! | `golden` | those files, and the log that they hold |
//! | `inputs` | pipes, compressed files, encodings |
//! | `sheets` | workbooks |
//! | `devices` | two clocks |
//! | `dialects` | what instruments and programs write, as their makers document it |
//! | `damaged` | binary files of instruments, cut off anywhere and with wrong bytes |
//! | `hostile` | what is wrong, said in one line; random bytes and edits |
//! | `fixtures` | writing and reading a log |

mod cleaning;
mod clocks;
mod damaged;
mod devices;
mod dialects;
mod fixtures;
mod formats;
mod golden;
mod hostile;
mod inputs;
#[cfg(any(feature = "mdf", feature = "tdms", feature = "mcap"))]
mod instruments;
mod layouts;
#[cfg(any(feature = "matlab", feature = "hdf5"))]
mod matlab;
#[cfg(feature = "sheets")]
mod sheets;
