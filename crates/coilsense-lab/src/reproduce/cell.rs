//! One cell of Tables II and III: printed, computed by each protocol, and why they differ.
//!
//! Next door: the simulations (`case`), the reasons (`reason`), how cells are shown (`report`).

use coilsense::{Channel, Deviation};

use super::reason::{Differing, TOLERANCE_POINTS};
use super::{CaseResult, Condition, Protocol, Reason};
use crate::published::{PublishedCell, Table};

/// A cell of Table II or III.
#[derive(Debug, Clone, PartialEq)]
pub struct Cell {
    /// What the paper prints.
    pub published: PublishedCell,
    /// By each protocol that was run.
    pub computed: Vec<Computed>,
}

/// A cell computed by one protocol.
#[derive(Debug, Clone, PartialEq)]
pub struct Computed {
    /// The protocol.
    pub protocol: Protocol,
    /// The value \[% of F_nom\].
    pub percent: f64,
    /// For maxima of end forces: lowest and highest value over sample rates from 1 to 20 kHz \[% of F_nom\].
    pub sampling_range: Option<(f64, f64)>,
    /// Why it differs from the printed value; empty where it does not.
    pub reasons: Vec<Reason>,
}

impl Cell {
    /// Computes a printed cell from the simulations of both protocols; keeps those asked for.
    pub(super) fn fill(published: PublishedCell, cases: &[CaseResult], asked: &[Protocol], table_i: bool) -> Self {
        let by = |protocol: Protocol, reading: Option<&Computed>| {
            let fits = |result: &&CaseResult| {
                let case = &result.case;
                (case.spring_name, case.condition) == (published.spring.as_str(), published.condition)
                    && case.protocols.contains(&protocol)
            };
            let result = cases.iter().find(fits)?;
            Computed::of(&published, protocol, result, reading, table_i)
        };
        let tables = by(Protocol::Tables, None);
        // What the reading of the tables cannot explain, the words cannot either.
        let text = by(Protocol::Text, tables.as_ref());
        let mut computed: Vec<Computed> = tables.into_iter().chain(text).collect();
        computed.retain(|computed| asked.contains(&computed.protocol));
        Self { published, computed }
    }

    /// The value by a protocol \[% of F_nom\], where it was run.
    pub fn by(&self, protocol: Protocol) -> Option<&Computed> {
        self.computed.iter().find(|computed| computed.protocol == protocol)
    }

    /// Its table.
    pub fn table(&self) -> Table {
        self.published.table
    }

    /// Its place in the table: spring, condition, force.
    pub fn place(&self) -> (&str, Condition, Channel) {
        (&self.published.spring, self.published.condition, self.published.force)
    }
}

impl Computed {
    fn of(
        cell: &PublishedCell,
        protocol: Protocol,
        result: &CaseResult,
        tables: Option<&Self>,
        table_i: bool,
    ) -> Option<Self> {
        let nominal = protocol.nominal_force(result.case.spring_name, &result.case.spring);
        let measure = |deviation: &Deviation| match cell.table {
            Table::Two => 100.0 * deviation.rmsd / nominal,
            Table::Three => 100.0 * protocol.maximum(deviation) / nominal,
        };
        let of_force = |(force, _): &&(Channel, Deviation)| *force == cell.force;
        let deviation = &result.deviations.iter().find(of_force)?.1;
        let percent = measure(deviation);
        let sampling_range = match cell.table {
            Table::Two => None,
            Table::Three => result.maxima.iter().find(|(force, _)| *force == cell.force).map(|(_, maxima)| {
                let of_protocol = match protocol {
                    Protocol::Text => maxima.absolute,
                    Protocol::Tables => maxima.signed,
                };
                let (low, high) = of_protocol.map(|force| 100.0 * force / nominal).into();
                (percent.min(low), percent.max(high))
            }),
        };
        let mut computed = Self { protocol, percent, sampling_range, reasons: Vec::new() };
        if computed.differs_from(cell.percent) {
            let signed_matters = deviation.maximum != deviation.maximum_absolute;
            let differing = Differing { cell, protocol, signed_matters, sampling_range, table_i };
            computed.reasons = Reason::of(&differing, tables.map_or(&[], |tables| &tables.reasons));
        }
        Some(computed)
    }

    /// Whether it is further from the printed value than [`TOLERANCE_POINTS`].
    pub fn differs_from(&self, printed_percent: f64) -> bool {
        (self.percent - printed_percent).abs() > TOLERANCE_POINTS
    }
}
