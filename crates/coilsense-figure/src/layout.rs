//! Puts a figure together: settles its axes, and gives each panel its place.
//!
//! Next door: whether it can be drawn (`check`), the places (`grid`), what fills them (`legend`,
//! `panel`, `head`, `beside`).

use crate::drawing::{Drawing, Frame};
use crate::grid::{Grid, most_y_ticks, shows_x_label, shows_y_label};
use crate::legend::Legend;
use crate::ruler::Ruler;
use crate::scene::Scene;
use crate::sheet::EDGE;
use crate::{Figure, Panel, PlotError, Points, Scale, Theme, bars, check, panel};

/// Draws the whole figure.
pub(crate) fn draw(figure: &Figure, theme: Theme) -> Result<Drawing, PlotError> {
    check::figure(figure)?;
    let width = figure.panel_width;
    let mut rulers = figure.panels.iter().map(|panel| rulers(panel, width)).collect::<Result<Vec<_>, _>>()?;
    let columns = figure.columns.min(figure.panels.len());
    let sheet = columns as f64 * figure.panel_width;
    let legend = Legend::new(figure, sheet - 2.0 * EDGE);
    let mut grid = Grid::new(figure, &rulers, legend.height())?;
    if figure.panels.iter().any(|panel| panel.equal_units) {
        equalise(figure, &grid, &mut rulers);
        // Other ticks may take other room; what that changes of the frames is made up for.
        grid = Grid::new(figure, &rulers, legend.height())?;
        equalise(figure, &grid, &mut rulers);
    }
    let middle = 0.5 * (grid.frame(0).left + grid.frame(columns - 1).right());
    let half = 0.5 * legend.width();
    // Centred on the frames, unless that would push it over an edge of the sheet.
    let mut shapes = legend.shapes(middle.min(sheet - half - EDGE).max(half + EDGE), theme);
    for (index, panel) in figure.panels.iter().enumerate() {
        let scene = Scene {
            panel,
            panel_width: width,
            frame: grid.frame(index),
            rulers: rulers[index],
            y_ticks: most_y_ticks(figure),
            x_label: shows_x_label(figure, index),
            y_label: shows_y_label(figure, index),
            y_room: grid.left[index % columns],
            right_room: grid.right[index % columns],
            theme,
        };
        panel::draw(&scene, &mut shapes)?;
    }
    let height = legend.height() + grid.rows() as f64 * figure.panel_height;
    Ok(Drawing { width: sheet, height, paper: theme.paper(), shapes })
}

/// Widens rulers until a unit of each is equally long, in panels that ask for it.
fn equalise(figure: &Figure, grid: &Grid, rulers: &mut [[Ruler; 2]]) {
    for (index, panel) in figure.panels.iter().enumerate().filter(|(_, panel)| panel.equal_units) {
        let Frame { width, height, .. } = grid.frame(index);
        let [x, y] = &mut rulers[index];
        if [&panel.x, &panel.y].iter().any(|axis| axis.scale != Scale::Linear) {
            continue;
        }
        let unit = ((x.upper - x.lower) / width).max((y.upper - y.lower) / height);
        x.widen_to(unit * width);
        y.widen_to(unit * height);
    }
}

/// The rulers of a panel, x first; a fitted y axis leaves 5 % free above and below, but a colour
/// map fills its axes.
fn rulers(panel: &Panel, width: f64) -> Result<[Ruler; 2], PlotError> {
    if let Some(bars) = &panel.bars {
        return bars::rulers(panel, bars, width);
    }
    let (curves, bands, points, heat) = (&panel.curves, &panel.bands, &panel.points, panel.heat.iter());
    let xs = curves.iter().flat_map(|curve| &curve.x).chain(bands.iter().flat_map(|band| &band.x));
    let xs = xs.chain(points.iter().flat_map(|points| &points.x));
    let xs = xs.copied().chain(heat.clone().flat_map(|heat| [heat.x.0, heat.x.1]));
    let edges = bands.iter().flat_map(|band| band.lower.iter().chain(&band.upper));
    let ys = curves.iter().flat_map(|curve| &curve.y).chain(edges);
    let ys = ys.copied().chain(points.iter().flat_map(Points::reach)).chain(panel.limits.iter().map(|limit| limit.y));
    let ys = ys.chain(heat.flat_map(|heat| [heat.y.0, heat.y.1]));
    let slack = if panel.heat.is_some() { 0.0 } else { 0.05 };
    Ok([Ruler::new(&panel.x, xs, 0.0)?, Ruler::new(&panel.y, ys, slack)?])
}
