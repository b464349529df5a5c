//! A calibration as a file: what length an inductance is, how surely, and what force that is.
//!
//! A table over length, so that whoever reads it needs no theory: rows of inductance, length and the length's standard uncertainty. Next door: who makes it
//! and whose log it is read with (`crate::calibration`), who takes a force by it (`crate::spec`, `crate::experiment`, `crate::mitigation`).

use std::fmt::Write;
use std::path::Path;

use serde::Deserialize;

use crate::message::Message;

/// Length over inductance with its uncertainty, over the lengths of the points.
#[derive(Debug, Clone, PartialEq)]
pub struct StoredCalibration {
    /// Its name for messages: its file's.
    pub name: String,
    /// Which relation it was made by.
    pub relation: String,
    /// What it says of itself.
    pub about: String,
    /// Standard uncertainty of L where the spring was mounted anew, as a share of L; zero where it was zeroed since.
    pub remounting: f64,
    /// What is taken from an inductance before it is read \[H\].
    pub shift: f64,
    /// The coil's resistance, as the points had it \[Ω\].
    pub resistance: Option<f64>,
    /// From length to force.
    pub force: Option<ForceLaw>,
    /// Inductance falling, length rising.
    pub rows: Vec<Row>,
}

/// A length and what L is there.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Row {
    /// L \[H\].
    pub inductance: f64,
    /// l \[m\].
    pub length: f64,
    /// u(l) \[m\]; none where the calibration does not tell it.
    pub length_u: Option<f64>,
}

/// A length that was read.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Reading {
    /// l \[m\].
    pub length: f64,
    /// u(l) \[m\]; none where the calibration does not tell it.
    pub length_u: Option<f64>,
}

/// What the file says of its form.
const SCHEMA: &str = "coilsense/stored-calibration/1";

impl StoredCalibration {
    /// Reads a file.
    ///
    /// # Errors
    /// [`StoredError`] with the file and what is wrong in it.
    pub fn read(path: &Path) -> Result<Self, StoredError> {
        let name = path.display().to_string();
        crate::input::note(path);
        let text = std::fs::read_to_string(path).map_err(|error| StoredError::of(&name, error.to_string()))?;
        Self::of_text(&name, &text)
    }

    /// Reads a file's text, under a name for messages.
    ///
    /// # Errors
    /// As [`Self::read`].
    pub fn of_text(name: &str, text: &str) -> Result<Self, StoredError> {
        let refuse = |message: String| StoredError::of(name, message);
        let file: File = toml::from_str(text).map_err(|error| {
            let line = error
                .span()
                .map_or(String::new(), |span| format!("line {}: ", 1 + text[..span.start].matches('\n').count()));
            let what = error.message().lines().next().unwrap_or_default();
            refuse(format!("is no stored calibration ({line}{what})"))
        })?;
        if file.schema != SCHEMA {
            return Err(refuse(format!("schema must be {SCHEMA:?}, got {:?}", file.schema)));
        }
        let row = |[inductance, length, length_u]: [f64; 3]| Row {
            inductance,
            length,
            length_u: Some(length_u).filter(|length_u| length_u.is_finite()),
        };
        let force = file.force.map(|force| ForceLaw {
            stiffness: force.stiffness_n_per_m,
            stiffness_u: force.stiffness_n_per_m_u,
            rest_length: force.length_at_zero_force_m,
            rest_length_u: force.length_at_zero_force_m_u,
        });
        let stored = Self {
            name: name.to_owned(),
            relation: file.relation,
            about: file.about,
            remounting: file.remounting,
            shift: 0.0,
            resistance: file.resistance_ohm,
            force,
            rows: file.rows.into_iter().map(row).collect(),
        };
        stored.checked()
    }

    /// What must hold of its rows and values.
    ///
    /// # Errors
    /// [`StoredError`] with the name and what does not.
    pub fn checked(self) -> Result<Self, StoredError> {
        let refuse = |message: String| Err(StoredError::of(&self.name, message));
        if self.rows.len() < 4 {
            return refuse(format!("rows must be at least 4, got {}", self.rows.len()));
        }
        for (index, row) in self.rows.iter().enumerate() {
            let is_number = row.inductance.is_finite() && row.length.is_finite() && row.length > 0.0;
            if !is_number || row.length_u.is_some_and(|length_u| length_u < 0.0) {
                return refuse(format!("rows[{index}] must be an inductance, a length above zero and its uncertainty"));
            }
        }
        for (index, pair) in self.rows.windows(2).enumerate() {
            if !(pair[1].inductance < pair[0].inductance && pair[1].length > pair[0].length) {
                return refuse(format!("rows[{}]: inductance must fall and length rise from row to row", index + 1));
            }
        }
        if !(0.0..1.0).contains(&self.remounting) {
            return refuse(format!("remounting must be from 0 to below 1, got {}", self.remounting));
        }
        if let Some(force) = self.force {
            let holds = force.stiffness > 0.0 && force.stiffness_u >= 0.0 && force.rest_length_u >= 0.0;
            if !(holds && force.stiffness.is_finite() && force.rest_length.is_finite()) {
                return refuse("force: stiffness must be above zero, uncertainties not below".to_owned());
            }
        }
        Ok(self)
    }

    /// The file's text.
    pub fn to_text(&self, date: &str) -> String {
        let mut text = String::new();
        // Writing to a String cannot fail.
        let _ = writeln!(
            text,
            "# Length from inductance: coilsense {} calibrate, {date}. Apply it: coilsense import LOG --calibration THIS --out FILE\n\
             schema = {SCHEMA:?}\nrelation = {:?}\nabout = {:?}\n\
             # standard uncertainty of L by remounting the spring, as a share of L; --re-zero removes it\nremounting = {}",
            env!("CARGO_PKG_VERSION"),
            self.relation,
            self.about,
            self.remounting,
        );
        if let Some(resistance) = self.resistance {
            let _ = writeln!(text, "resistance_ohm = {resistance:?}");
        }
        let _ = writeln!(text, "# inductance [H], length [m], its standard uncertainty [m] (nan: not told)\nrows = [");
        for row in &self.rows {
            let length_u = row.length_u.map_or("nan".to_owned(), |length_u| format!("{length_u:?}"));
            let _ = writeln!(text, "  [{:?}, {:?}, {length_u}],", row.inductance, row.length);
        }
        let _ = writeln!(text, "]");
        if let Some(force) = self.force {
            let _ = writeln!(
                text,
                "\n[force]\nstiffness_n_per_m = {:?}\nstiffness_n_per_m_u = {:?}\nlength_at_zero_force_m = {:?}\nlength_at_zero_force_m_u = {:?}",
                force.stiffness, force.stiffness_u, force.rest_length, force.rest_length_u
            );
        }
        text
    }

    /// Inductances between which it reads \[H\], the least first.
    pub fn inductances(&self) -> [f64; 2] {
        [self.rows[self.rows.len() - 1].inductance + self.shift, self.rows[0].inductance + self.shift]
    }

    /// Lengths between which it reads \[m\].
    pub fn lengths(&self) -> [f64; 2] {
        [self.rows[0].length, self.rows[self.rows.len() - 1].length]
    }

    /// How far lengths between two may be off, and what mounting the spring anew adds: rms \[m\]; none where it is not told.
    pub fn doubts(&self, [shortest, longest]: [f64; 2]) -> Option<[f64; 2]> {
        let within = |pair: &&[Row]| pair[1].length >= shortest && pair[0].length <= longest;
        let (mut squares, mut count) = ([0.0; 2], 0.0);
        for pair in self.rows.windows(2).filter(within) {
            let [before, next] = [pair[0], pair[1]];
            let slope = (next.length - before.length) / (before.inductance - next.inductance);
            let own = 0.5 * (before.length_u? + next.length_u?);
            squares[0] += own * own;
            squares[1] += (self.remounting * before.inductance * slope).powi(2);
            count += 1.0;
        }
        Some(squares.map(|square| (square / count).sqrt()))
    }

    /// The same of a spring that was mounted anew and has this inductance at this length.
    ///
    /// # Errors
    /// [`StoredError`] for a length outside of the calibration.
    pub fn re_zeroed(self, length: f64, inductance: f64) -> Result<Self, StoredError> {
        let [shortest, longest] = self.lengths();
        if !(shortest..=longest).contains(&length) {
            let millimetres = [length, shortest, longest].map(|metre| 1e3 * metre);
            let [at, from, to] = millimetres;
            return Err(StoredError::of(
                &self.name,
                format!(
                    "re_zero: length must be from {from:.3} to {to:.3} mm, where the calibration holds, got {at:.3} mm"
                ),
            ));
        }
        let by_length: Vec<[f64; 2]> = self.rows.iter().map(|row| [row.length, row.inductance]).collect();
        let now = cubic(&by_length, length);
        Ok(Self { shift: inductance - now, remounting: 0.0, ..self })
    }

    /// The length of an inductance \[H\]; none outside of the calibration's lengths.
    pub fn at(&self, inductance: f64) -> Option<Reading> {
        let own = inductance - self.shift;
        let last = self.rows.len() - 1;
        if !(own <= self.rows[0].inductance && own >= self.rows[last].inductance) {
            return None;
        }
        // Rising in −L, and 1/l nearly straight in it.
        let after = self.rows.partition_point(|row| row.inductance > own).clamp(1, last);
        let first = after.saturating_sub(2).min(last - 3);
        let near: [[f64; 2]; 4] = std::array::from_fn(|index| {
            let row = self.rows[first + index];
            [-row.inductance, 1.0 / row.length]
        });
        let length = 1.0 / through(near, -own);
        let [before, next] = [self.rows[after - 1], self.rows[after]];
        let share = (before.inductance - own) / (before.inductance - next.inductance);
        let slope = (next.length - before.length) / (before.inductance - next.inductance);
        let told = before.length_u.zip(next.length_u).map(|(a, b)| a + share * (b - a));
        let length_u = told.map(|told| told.hypot(self.remounting * inductance * slope));
        Some(Reading { length, length_u })
    }

    /// Force \[N\] of a length that was read and its standard uncertainty; none without a stiffness.
    pub fn force_of(&self, reading: Reading) -> Option<(f64, Option<f64>)> {
        let law = self.force?;
        Some((law.force(reading.length), reading.length_u.map(|length_u| law.uncertainty(reading.length, length_u))))
    }
}

/// Through four pairs.
fn through(pairs: [[f64; 2]; 4], x: f64) -> f64 {
    let term = |index: usize| {
        let [own, value] = pairs[index];
        let others = pairs.iter().enumerate().filter(|(other, _)| *other != index);
        value * others.map(|(_, [other, _])| (x - other) / (own - other)).product::<f64>()
    };
    (0..4).map(term).sum()
}

/// Through the four pairs about a place; `pairs` rising.
fn cubic(pairs: &[[f64; 2]], x: f64) -> f64 {
    let after = pairs.partition_point(|[own, _]| *own < x).clamp(1, pairs.len() - 1);
    let first = after.saturating_sub(2).min(pairs.len() - 4);
    through(std::array::from_fn(|index| pairs[first + index]), x)
}

/// The file.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct File {
    schema: String,
    relation: String,
    #[serde(default)]
    about: String,
    remounting: f64,
    resistance_ohm: Option<f64>,
    rows: Vec<[f64; 3]>,
    force: Option<ForceFile>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct ForceFile {
    stiffness_n_per_m: f64,
    stiffness_n_per_m_u: f64,
    length_at_zero_force_m: f64,
    length_at_zero_force_m_u: f64,
}

/// F = k(l − l0) with what is known of k and l0.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ForceLaw {
    /// k \[N/m\].
    pub stiffness: f64,
    /// u(k) \[N/m\].
    pub stiffness_u: f64,
    /// l0, the length without force \[m\]; of a spring with initial tension, where its straight line meets zero.
    pub rest_length: f64,
    /// u(l0) \[m\].
    pub rest_length_u: f64,
}

impl ForceLaw {
    /// F \[N\] at a length \[m\].
    pub fn force(&self, length: f64) -> f64 {
        self.stiffness * (length - self.rest_length)
    }

    /// u(F) \[N\] at a length \[m\] that is itself known to `length_u` \[m\].
    ///
    /// u(F)² = k² u(l)² + (l − l0)² u(k)² + k² u(l0)²
    ///
    /// Source:   law of propagation, `[JCGM100]` eq. 10.
    /// Valid:    l, k and l0 found apart from each other; shares u(k)/k well below 1.
    /// Accuracy: first order: it leaves out u(k)² u(l)², 1e-4 of u(F)² where both are known to 1 % of the deflection.
    pub fn uncertainty(&self, length: f64, length_u: f64) -> f64 {
        let by_stiffness = (length - self.rest_length) * self.stiffness_u;
        (self.stiffness * length_u.hypot(self.rest_length_u)).hypot(by_stiffness)
    }
}

/// A file that is no stored calibration, or a question beyond it: one line with the file, the value and what is allowed.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("{file}: {message}")]
pub struct StoredError {
    /// The file.
    pub file: String,
    /// What is wrong, the value and what is allowed.
    pub message: String,
}

impl StoredError {
    fn of(file: &str, message: String) -> Self {
        Self { file: file.to_owned(), message }
    }
}

impl From<StoredError> for Message {
    fn from(error: StoredError) -> Self {
        Self::from(error.to_string())
    }
}
