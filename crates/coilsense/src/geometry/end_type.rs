//! How the wire ends: what an end adds to the active windings, and how long the coil is when all windings touch.
//!
//! Next door: the spring that has such ends (`geometry`).

/// The ends of a spring, both alike.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum EndType {
    /// Extension spring with hooks or loops; its body is close-wound.
    Hooks,
    /// Compression spring, ends cut off ("plain").
    Open,
    /// Compression spring, ends cut off and ground flat.
    OpenGround,
    /// Compression spring, ends bent to the neighbouring winding ("squared").
    Closed,
    /// Compression spring, ends closed and ground flat.
    ClosedGround,
}

impl EndType {
    /// Windings that do not spring, both ends together: total less active \[1\].
    ///
    /// n_t − n = 0 (hooks, open), 1 (open and ground), 2 (closed; closed and ground)
    ///
    /// Source:   `[Shigley2011]` table 10–1 (compression); hooks: `[EN13906-2]`, where every winding of the body is active.
    /// Valid:    a default: a maker's own number goes into `total_windings`.
    /// Accuracy: a convention, not a measurement; real ends differ by ±¼ winding.
    /// Differs:  hooks bend too: `[Shigley2011]` eq. 10–40 counts them as G/E of a winding more, about 0.4.
    ///
    /// ```
    /// assert_eq!(coilsense::geometry::EndType::ClosedGround.inactive_windings(), 2.0);
    /// ```
    pub fn inactive_windings(self) -> f64 {
        match self {
            Self::Hooks | Self::Open => 0.0,
            Self::OpenGround => 1.0,
            Self::Closed | Self::ClosedGround => 2.0,
        }
    }

    /// Length of the coil with all windings touching \[m\]; hooks: of the body between them.
    ///
    /// l_s = (n_t + 1) d (hooks, open, closed), n_t d (ground)
    ///
    /// - `total_windings`: n_t; `wire_diameter`: d \[m\]
    ///
    /// Source:   `[Shigley2011]` table 10–1, `[MachineryHandbook31]` p. 318 (compression); hooks: body length of `[EN13906-2]`.
    /// Valid:    wire of exactly the diameter d; real springs stop some per cent earlier.
    /// Accuracy: exact but for rounding.
    /// Differs:  [`crate::Spring::solid_length`] counts n d, the active windings alone, as the paper's model does.
    ///
    /// ```
    /// let length = coilsense::geometry::EndType::Closed.solid_length(10.0, 0.002);
    /// assert!((length - 0.022).abs() < 1e-15);
    /// ```
    pub fn solid_length(self, total_windings: f64, wire_diameter: f64) -> f64 {
        match self {
            Self::Hooks | Self::Open | Self::Closed => (total_windings + 1.0) * wire_diameter,
            Self::OpenGround | Self::ClosedGround => total_windings * wire_diameter,
        }
    }

    /// Whether it is made to be pulled.
    pub fn is_extension(self) -> bool {
        self == Self::Hooks
    }
}
