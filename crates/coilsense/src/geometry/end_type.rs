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
    /// l_s = n_t d (hooks, ground), (n_t + 1) d (open, closed)
    ///
    /// - `total_windings`: n_t; `wire_diameter`: d \[m\]
    ///
    /// Source:   `[Shigley2011]` table 10–1, `[MachineryHandbook31]` p. 318 (compression); hooks: n_t pitches of d.
    /// Valid:    wire of exactly the diameter d; real springs stop some per cent earlier.
    /// Accuracy: exact but for rounding.
    /// Differs:  hooks: `[EN13906-2]` gives the body's length over the outside, (n_t + 1) d. A hook leaves the body at the wire's centre,
    ///           so that a pulled coil spans n_t pitches from centre to centre: what the paper's l is (S_T: 52 · 2 mm = 104 mm = l0), and
    ///           what windings and inductance are spread over here. Seats hold a compressed coil from outside.
    ///
    /// ```
    /// let length = coilsense::geometry::EndType::Closed.solid_length(10.0, 0.002);
    /// assert!((length - 0.022).abs() < 1e-15);
    /// ```
    pub fn solid_length(self, total_windings: f64, wire_diameter: f64) -> f64 {
        match self {
            Self::Open | Self::Closed => (total_windings + 1.0) * wire_diameter,
            Self::Hooks | Self::OpenGround | Self::ClosedGround => total_windings * wire_diameter,
        }
    }

    /// Whether it is made to be pulled.
    pub fn is_extension(self) -> bool {
        self == Self::Hooks
    }
}
