//! The stretched helix.
//!
//! | ours | beside it |
//! |---|---|
//! | `helix::Modes`, `helix::Helix` | straight beam elements of another formulation, extrapolated (`elements`) |
//! | `helix::Modes` | figures of an independent program of the same rod (`figures`) |
//! | `neighbours::Column` | figures of an independent program, the helix, the formula of buckling (`column`) |
//! | `helix::Helix` | closed forms of a wire that neither shears nor extends, textbook couple of the unloaded helix (`limits`) |
//! | `helix::Modes` | straight beam, bar, shaft, column that buckles (`limits`) |
//! | `helix::Surge` | `helix::Response`, the chain of a long flat spring (`motion`), work and energy (`energy`) |
//! | `helix::ChangedSurge`, `helix::StaticCurve` | helices found anew (`changed`) |
//! | `helix::Response` | the static state at a length nearby, residues of its own modes (`laws`) |

mod cases;
mod changed;
mod column;
mod elements;
mod energy;
mod figures;
mod laws;
mod limits;
mod lines;
mod motion;
mod refused;
mod tied;
