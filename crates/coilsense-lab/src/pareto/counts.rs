//! What became of a sweep's rows on the way to its front.
//!
//! Next door: who counts (`pass`).

/// What became of the rows.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Counts {
    /// Rows of the plan.
    pub planned: u64,
    /// Rows that are there.
    pub rows: u64,
    /// Of them, those in which windings would touch: none of them is on the front.
    pub clash: u64,
    /// Those that could not be judged.
    pub refused: u64,
    /// Those that fail a condition.
    pub excluded: u64,
    /// Those that lack a number for an objective.
    pub without_number: u64,
    /// Those that were compared.
    pub compared: u64,
}

impl Counts {
    /// What became of the rows, in words: `3000 rows: 12 in which windings would touch, 2988 compared`.
    pub fn account(&self) -> String {
        let parts = [
            (self.planned - self.rows, "not computed yet"),
            (self.clash, "in which windings would touch"),
            (self.refused, "that could not be judged"),
            (self.excluded, "that fail a condition"),
            (self.without_number, "without a number for an objective"),
        ];
        let told = parts.iter().filter(|(count, _)| *count > 0).map(|(count, what)| format!("{count} {what}"));
        let told: Vec<String> = told.chain([format!("{} compared", self.compared)]).collect();
        format!("{} rows: {}", self.planned, told.join(", "))
    }
}
