//! What must hold before a figure is drawn: parts that pair up, lines that have a width.
//!
//! Ranges are judged by `ruler`, and the room for bars, once it is known, by `bars`.

use crate::{Band, Curve, Figure, HeatMap, Panel, PlotError, Points};

/// Refuses a figure whose parts do not fit together.
pub(crate) fn figure(figure: &Figure) -> Result<(), PlotError> {
    let (panels, columns) = (figure.panels.len(), figure.columns);
    if panels == 0 || columns == 0 {
        return Err(PlotError::Empty { panels, columns });
    }
    for panel in &figure.panels {
        panel.curves.iter().try_for_each(curve)?;
        panel.bands.iter().try_for_each(band)?;
        panel.points.iter().try_for_each(points)?;
        panel.heat.iter().try_for_each(heat)?;
        bars(panel)?;
    }
    Ok(())
}

fn curve(Curve { label, x, y, stroke }: &Curve) -> Result<(), PlotError> {
    let (label, width) = (label.clone(), stroke.width);
    if x.len() != y.len() {
        let (x, y) = (x.len(), y.len());
        return Err(PlotError::Lengths { label, x, y });
    }
    if !(width.is_finite() && width > 0.0) {
        return Err(PlotError::Width { label, width });
    }
    Ok(())
}

fn band(band: &Band) -> Result<(), PlotError> {
    let [x, lower, upper] = [&band.x, &band.lower, &band.upper].map(Vec::len);
    if x == lower && x == upper {
        return Ok(());
    }
    Err(PlotError::BandLengths { label: band.label.clone(), x, lower, upper })
}

fn points(points: &Points) -> Result<(), PlotError> {
    let [x, y, errors] = [&points.x, &points.y, &points.errors].map(Vec::len);
    let names = points.names.len();
    if names != 0 && names != x {
        return Err(PlotError::PointNames { label: points.label.clone(), x, names });
    }
    if x == y && (errors == 0 || errors == x) {
        return Ok(());
    }
    Err(PlotError::PointLengths { label: points.label.clone(), x, y, errors })
}

fn heat(heat: &HeatMap) -> Result<(), PlotError> {
    let (label, values) = (heat.label.clone(), heat.values.len());
    if heat.rows == 0 || values == 0 || !values.is_multiple_of(heat.rows) {
        return Err(PlotError::Cells { label, rows: heat.rows, values });
    }
    for (lower, upper) in [heat.x, heat.y] {
        if !(lower.is_finite() && upper.is_finite() && lower < upper) {
            return Err(PlotError::Range { label, lower, upper });
        }
    }
    match &heat.marked {
        Some(marked) if marked.cells.len() != values => {
            let (label, cells) = (marked.label.clone(), marked.cells.len());
            Err(PlotError::MarkedCells { label, values, cells })
        }
        _ => Ok(()),
    }
}

fn bars(panel: &Panel) -> Result<(), PlotError> {
    let Some(bars) = &panel.bars else { return Ok(()) };
    let label = panel.x.label.clone();
    if bars.bars.is_empty() {
        return Err(PlotError::NoBars { label });
    }
    let unjoined = panel.bands.is_empty() && panel.points.is_empty();
    let alone = panel.curves.is_empty() && unjoined && panel.limits.is_empty() && panel.heat.is_none();
    if alone { Ok(()) } else { Err(PlotError::BarsNotAlone { label }) }
}
