//! How a line looks: colour, dash and width, and what the colours are on each theme.
//!
//! Where a line runs is `trace`'s matter.

/// Red, green and blue, 0 to 255.
pub(crate) type Rgb = [u8; 3];

/// The look of one curve.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stroke {
    /// Colour by name; the theme says which shade.
    pub colour: Colour,
    /// Pattern, which alone must tell curves apart in black and white.
    pub dash: Dash,
    /// Line width \[px\]; 1.3 to 2 px (1 to 1.5 pt) suits print.
    pub width: f64,
}

/// Colours that stay apart for colour-blind readers.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Colour {
    /// A red on the orange side.
    Red,
    /// A plain blue.
    #[default]
    Blue,
    /// A green on the blue side.
    Green,
    /// Black on light ground, near-white on dark.
    Ink,
}

/// Dash patterns, in the order of how much ink they leave.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Dash {
    /// Unbroken.
    Solid,
    /// Long dashes.
    Dashed,
    /// Long dash, dot.
    DashDot,
    /// Dots.
    Dotted,
}

/// The ground a figure is drawn on.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Theme {
    /// White paper.
    Light,
    /// A dark page.
    Dark,
}

impl Dash {
    /// Lengths of line and gap in turn \[px\] for a line of `width`; empty for a solid one.
    pub(crate) fn lengths(self, width: f64) -> Vec<f64> {
        let widths: &[f64] = match self {
            Self::Solid => &[],
            Self::Dashed => &[5.0, 2.5],
            Self::DashDot => &[6.5, 2.0, 1.3, 2.0],
            Self::Dotted => &[1.3, 1.5],
        };
        widths.iter().map(|length| length * width).collect()
    }
}

impl Theme {
    /// What everything is drawn upon.
    pub(crate) fn paper(self) -> Rgb {
        match self {
            Self::Light => [255, 255, 255],
            Self::Dark => [22, 24, 29],
        }
    }

    /// Grid lines, there for who looks for them.
    pub(crate) fn grid(self) -> Rgb {
        match self {
            Self::Light => [226, 226, 226],
            Self::Dark => [52, 56, 64],
        }
    }

    /// Reference lines, behind the curves.
    pub(crate) fn mark(self) -> Rgb {
        match self {
            Self::Light => [125, 125, 125],
            Self::Dark => [140, 145, 155],
        }
    }

    /// The shade of a named colour: at least 4.5 to 1 against the paper.
    pub(crate) fn shade(self, colour: Colour) -> Rgb {
        match (self, colour) {
            (Self::Light, Colour::Red) => [200, 40, 16],
            (Self::Light, Colour::Blue) => [0, 90, 170],
            (Self::Light, Colour::Green) => [0, 125, 92],
            (Self::Light, Colour::Ink) => [0, 0, 0],
            (Self::Dark, Colour::Red) => [255, 120, 96],
            (Self::Dark, Colour::Blue) => [108, 178, 255],
            (Self::Dark, Colour::Green) => [60, 218, 160],
            (Self::Dark, Colour::Ink) => [240, 240, 240],
        }
    }
}
