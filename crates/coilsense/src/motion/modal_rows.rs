//! How the modal coordinates of a block of samples lie in memory: a row a mode, a column a sample.
//!
//! Next door: who fills them (`modal_block`, `stretch`), who reads them (`ends`, `placing`).

/// Samples of a block, the last of which may be left as they were.
pub(crate) const WIDTH: usize = 64;

/// Where a mode, counted from zero, has its row among so many modes.
pub(super) fn row_of(mode: usize, modes: usize) -> usize {
    if mode.is_multiple_of(2) { mode / 2 } else { modes.div_ceil(2) + mode / 2 }
}
