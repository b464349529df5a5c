//! Puts a figure together: checks it, settles its axes, and gives each panel its place.
//!
//! The places come from `grid`; what fills them from `legend`, `panel` and `head`.

use super::drawing::Drawing;
use super::grid::{Grid, most_y_ticks, shows_x_label, shows_y_label};
use super::legend::Legend;
use super::panel;
use super::ruler::Ruler;
use super::scene::Scene;
use super::sheet::EDGE;
use super::{Curve, Figure, Panel, PlotError, Theme};

/// Draws the whole figure.
pub(super) fn draw(figure: &Figure, theme: Theme) -> Result<Drawing, PlotError> {
    check(figure)?;
    let rulers = figure.panels.iter().map(rulers).collect::<Result<Vec<_>, _>>()?;
    let columns = figure.columns.min(figure.panels.len());
    let sheet = columns as f64 * figure.panel_width;
    let legend = Legend::new(figure, sheet - 2.0 * EDGE);
    let grid = Grid::new(figure, &rulers, legend.height())?;
    let middle = 0.5 * (grid.frame(0).left + grid.frame(columns - 1).right());
    let half = 0.5 * legend.width();
    // Centred on the frames, unless that would push it over an edge of the sheet.
    let mut shapes = legend.shapes(middle.min(sheet - half - EDGE).max(half + EDGE), theme);
    for (index, panel) in figure.panels.iter().enumerate() {
        let scene = Scene {
            panel,
            frame: grid.frame(index),
            rulers: rulers[index],
            y_ticks: most_y_ticks(figure),
            x_label: shows_x_label(figure, index),
            y_label: shows_y_label(figure, index),
            y_room: grid.left[index % columns],
            theme,
        };
        panel::draw(&scene, &mut shapes);
    }
    let height = legend.height() + grid.rows() as f64 * figure.panel_height;
    Ok(Drawing { width: sheet, height, paper: theme.paper(), shapes })
}

fn check(figure: &Figure) -> Result<(), PlotError> {
    let (panels, columns) = (figure.panels.len(), figure.columns);
    if panels == 0 || columns == 0 {
        return Err(PlotError::Empty { panels, columns });
    }
    for Curve { label, x, y, stroke } in figure.panels.iter().flat_map(|panel| &panel.curves) {
        let (label, width) = (label.clone(), stroke.width);
        if x.len() != y.len() {
            let (x, y) = (x.len(), y.len());
            return Err(PlotError::Lengths { label, x, y });
        }
        if !(width.is_finite() && width > 0.0) {
            return Err(PlotError::Width { label, width });
        }
    }
    Ok(())
}

/// The rulers of a panel, x first; a fitted y axis leaves 5 % free above and below.
fn rulers(panel: &Panel) -> Result<[Ruler; 2], PlotError> {
    let xs = panel.curves.iter().flat_map(|curve| curve.x.iter().copied());
    let ys = panel.curves.iter().flat_map(|curve| curve.y.iter().copied());
    Ok([Ruler::new(&panel.x, xs, 0.0)?, Ruler::new(&panel.y, ys, 0.05)?])
}
