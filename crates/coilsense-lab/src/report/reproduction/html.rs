//! `report.html`: one page, readable offline, in light and dark, on paper.
//!
//! Next door: its words about limits (`limits`), its layout (`page.html`).

use minijinja::{Value, context};

use super::text::{finding, reasons_in_use, summary, table_title};
use super::{Drawn, ReportError, limits};
use crate::published::{COLUMNS, Table};
use crate::report::page::{self, shown};
use crate::reproduce::{Cell, Condition, Protocol, Reproduction, TOLERANCE_POINTS};

/// The page of a reproduction.
pub(super) fn page(reproduction: &Reproduction, drawn: &[Drawn]) -> Result<String, ReportError> {
    let tables: Vec<Value> =
        [Table::Two, Table::Three].into_iter().map(|table| table_value(reproduction, table)).collect();
    let reasons: Vec<Value> = reasons_in_use(reproduction)
        .into_iter()
        .map(|reason| context! { letter => reason.letter(), sentence => reason.sentence() })
        .collect();
    let figures: Vec<Value> = drawn.iter().map(shown).collect();
    let limits: Vec<Value> =
        limits::limits(reproduction)?.into_iter().map(|(heading, paragraph)| context! { heading, paragraph }).collect();
    let protocols: Vec<&str> = reproduction.protocols.iter().map(|protocol| protocol.name()).collect();
    Ok(page::page(
        include_str!("page.html"),
        context! {
            summary => summary(reproduction),
            finding => finding(reproduction),
            warnings => reproduction.warnings(),
            table_i => reproduction.springs_are_table_i,
            protocols,
            tables,
            reasons,
            figures,
            limits,
            springs => springs(reproduction),
            tolerance => TOLERANCE_POINTS,
        },
    )?)
}

/// A table: one row per spring and condition, and in it one group of cells per force.
fn table_value(reproduction: &Reproduction, table: Table) -> Value {
    let mut rows = Vec::new();
    for (spring, _) in reproduction.springs.each() {
        for (index, condition) in Condition::ALL.into_iter().enumerate() {
            let of_row = |cell: &&Cell| {
                let (name, of, _) = cell.place();
                cell.table() == table && name == spring && of == condition
            };
            let cells: Vec<Value> = reproduction
                .cells
                .iter()
                .filter(of_row)
                .map(|cell| cell_value(cell, &reproduction.protocols))
                .collect();
            rows.push(context! { spring, first => index == 0, count => Condition::ALL.len(), condition => condition.name(), cells });
        }
    }
    let mut titles: Vec<&str> = reproduction.protocols.iter().map(|&protocol| table_title(table, protocol)).collect();
    titles.dedup();
    let title = match titles.as_slice() {
        [one] => (*one).to_owned(),
        _ => {
            let each = reproduction.protocols.iter().zip(&titles);
            let named: Vec<String> = each.map(|(protocol, title)| format!("{}: {title}", protocol.name())).collect();
            named.join("; ")
        }
    };
    let forces: Vec<&str> = COLUMNS.iter().map(|force| force.name()).collect();
    context! { numeral => table.numeral(), title, forces, rows, sampled => table == Table::Three }
}

fn cell_value(cell: &Cell, protocols: &[Protocol]) -> Value {
    let computed: Vec<Value> = protocols
        .iter()
        .filter_map(|&protocol| cell.by(protocol))
        .map(|computed| {
            let letters: String = computed.reasons.iter().map(|reason| reason.letter()).collect();
            let shown = |(low, high)| format!("{low:.2} … {high:.2}");
            context! {
                percent => format!("{:.3}", computed.percent),
                differs => computed.differs_from(cell.published.percent),
                letters,
                range => computed.sampling_range.map(shown),
            }
        })
        .collect();
    context! { printed => format!("{:.2}", cell.published.percent), computed }
}

/// Table I and what follows from it.
fn springs(reproduction: &Reproduction) -> Vec<Value> {
    // mm and g alike are thousandths of the SI unit.
    let thousandths = |si: f64| format!("{:.6}", 1e3 * si).trim_end_matches('0').trim_end_matches('.').to_owned();
    let value = |(name, spring): (&'static str, &coilsense::Spring)| {
        let (shortest, longest) = spring.operating_range();
        context! {
            name,
            rest_length => thousandths(spring.rest_length()),
            windings => spring.windings().to_string(),
            coil_radius => thousandths(spring.coil_radius()),
            wire_radius => thousandths(spring.wire_radius()),
            mass => thousandths(spring.mass()),
            stiffness => spring.stiffness().to_string(),
            min_length => thousandths(shortest),
            max_length => thousandths(longest),
            transit_time => format!("{:.3}", 1e3 * spring.transit_time()),
            f1 => format!("{:.3}", spring.surge_frequency()),
            mode1 => format!("{:.3}", coilsense::modes::ChainModes::of(spring).frequencies()[0] / std::f64::consts::TAU),
            impedance => format!("{:.2}", spring.wave_impedance()),
            nominal_force => format!("{:.2}", spring.nominal_force()),
            solid_length => thousandths(spring.solid_length()),
        }
    };
    reproduction.springs.each().map(value).collect()
}
