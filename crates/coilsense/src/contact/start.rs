//! What a run begins with.
//!
//! Next door: the run (`run`).

/// Where a chain is when it is first looked at.
#[derive(Debug, Clone, PartialEq)]
pub struct Start {
    /// \[s\].
    pub time: f64,
    /// Displacements of the lumps from the unloaded spring whose end 1 is at zero \[m\], shape `N`.
    pub places: Vec<f64>,
    /// \[m/s\], shape `N`.
    pub speeds: Vec<f64>,
}

/// What is told at each time.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Watch {
    /// End forces alone: nobody asks where the energy went that damping took.
    Ends,
    /// End forces, and between which tensions each segment of the wire goes.
    Tensions,
    /// End forces, and where the energy went.
    Forces,
    /// And where the lumps are.
    Places,
}

impl Watch {
    /// Whether anybody asks where the energy went.
    pub fn counts_energy(self) -> bool {
        matches!(self, Self::Forces | Self::Places)
    }
}
