//! Logs as instruments and people write them: read to the last bit, mended when that is allowed, each row accounted for.
//!
//! | file | holds |
//! |---|---|
//! | `layouts` | how texts are written: delimiters, decimal signs, titles, units, stamps |
//! | `repairs` | what is mended, and that nothing is lost without being counted |
//! | `fixtures` | writing and reading a log |

mod fixtures;
mod layouts;
mod repairs;
