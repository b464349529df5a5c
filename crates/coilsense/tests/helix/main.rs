//! The stretched helix.
//!
//! | ours | beside it |
//! |---|---|
//! | `helix::Modes::frequencies` | figures of an independent program of the same rod, by bisection of a determinant's count |

mod cases;
mod figures;
mod scratch;
