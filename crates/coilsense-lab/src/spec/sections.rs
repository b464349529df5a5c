//! The tables `[[spring.section]]`: a coil whose pitch and diameters change along the wire.
//!
//! Next door: the spring that it makes (`spring`), its static curve (`coilsense::sections`).

use coilsense::geometry::{EndType, Geometry, Material};
use coilsense::sections::{Section as Wound, Sections};
use coilsense::{Spring, SpringParameters};

use super::section::Section;
use super::{SpecError, plain};
use crate::quantity::Dimension;

/// What is said of a coil of sections beside its spring.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DeadEnds {
    /// Closed windings at end 1 and at end 2, which lie on their seats \[1\].
    pub windings: [f64; 2],
    /// What they add to the coil's length \[m\].
    pub length: f64,
    /// Their mass \[kg\].
    pub mass: f64,
}

/// Most sections: a drawing has a dozen.
const MOST: usize = 64;
/// A gap below this share of the wire's diameter is none.
const CLOSED: f64 = 1e-9;

/// What a spring of sections is used for: between which lengths, and the like.
pub(super) struct Use<'a> {
    /// The table `[spring]`.
    pub section: &'a Section<'a>,
    pub material: Material,
    pub end_type: EndType,
    /// Range in use and what else both other ways to describe a spring have.
    pub parameters: SpringParameters,
}

impl DeadEnds {
    /// The spring of the tables, its uniform stand-in for what hangs on wire and ends alone, and its dead ends.
    pub(super) fn parse(used: Use<'_>) -> Result<(Spring, Geometry, Self), SpecError> {
        let Use { section, material, end_type, parameters } = used;
        if !cfg!(feature = "contact") {
            return Err(section.refuse("section", "is not read in this build; coils of sections are for the command"));
        }
        let tables = section.tables("section")?;
        if tables.is_empty() || tables.len() > MOST {
            return Err(section.refuse("section", format!("must be 1 to {MOST} tables, got {}", tables.len())));
        }
        let each: Vec<Wound> = tables.iter().map(wound).collect::<Result<_, _>>()?;
        let is_closed = |section: &Wound| !section.telescopes && largest_gap(section) <= CLOSED * section.wire_diameter;
        let dead = [
            each.iter().take_while(|section| is_closed(section)).count(),
            each.iter().rev().take_while(|section| is_closed(section)).count(),
        ];
        if dead[0] == each.len() {
            return Err(tables[0].refuse("pitch", "is closed, as all others are: at least one section must have a gap"));
        }
        let (active, ends) = (&each[dead[0]..each.len() - dead[1]], [&each[..dead[0]], &each[each.len() - dead[1]..]]);
        if let Some(number) = active.iter().position(is_closed) {
            let why =
                "is closed between open sections: give its windings to an end, or a pitch above the wire's diameter";
            return Err(tables[dead[0] + number].refuse("pitch", why));
        }
        closed_ends(end_type, &tables, &each)?;
        let (shear, density) = (material.shear_modulus(), material.density());
        let coil =
            Sections::new(active.to_vec(), shear, density).map_err(|error| located(&tables[dead[0]..], &error))?;
        let seat = if matches!(end_type, EndType::OpenGround | EndType::ClosedGround | EndType::Hooks) {
            0.0
        } else {
            0.5 * (each[0].wire_diameter + each[each.len() - 1].wire_diameter)
        };
        let of_ends = || ends.iter().flat_map(|end| end.iter());
        let dead_ends = Self {
            windings: ends.map(|end| end.iter().map(|section| section.windings).sum()),
            length: of_ends().map(|section| section.windings * section.wire_diameter).sum::<f64>() + seat,
            mass: of_ends().map(|section| mass(section, density)).sum(),
        };
        let wound = Spring::of_sections(coil, dead_ends.length, (parameters.min_length, parameters.max_length));
        let refuse = |error: coilsense::Error| section.refuse_science(&error, &[]);
        let own = wound.map_err(refuse)?.parameters().clone();
        let spring = Spring::new(SpringParameters {
            nominal_force: parameters.nominal_force,
            inductance_windings: parameters.inductance_windings,
            ..own
        })
        .map_err(refuse)?;
        let geometry = Geometry::of_spring(&spring, end_type, material).map_err(refuse)?;
        Ok((spring, geometry, dead_ends))
    }
}

/// One table.
fn wound(table: &Section<'_>) -> Result<Wound, SpecError> {
    let windings = table.number("windings")?;
    table.check("windings", windings > 0.0 && windings <= 1000.0, windings, "above zero and at most 1000")?;
    let wire_diameter = table.positive("wire_diameter", Dimension::Length)?;
    let both = |key: &str| -> Result<[f64; 2], SpecError> {
        if table.is_list(key) {
            return Ok(table.pair(key, &[Dimension::Length])?.map(|(_, value)| value));
        }
        table.quantity(key, Dimension::Length).map(|value| [value; 2])
    };
    let coil_diameter = both("coil_diameter")?;
    for value in coil_diameter {
        table.check(
            "coil_diameter",
            value > wire_diameter,
            value,
            &format!("above the wire's {} m", plain(wire_diameter)),
        )?;
    }
    let telescopes = table.optional_flag("telescopes")?.unwrap_or(false);
    let given = |key: &str| table.has(key).then(|| both(key)).transpose();
    let (key, more, pitch) = match (given("pitch")?, given("gap")?) {
        (Some(_), Some(_)) => {
            return Err(table.refuse("gap", "is the pitch less the wire's diameter: give one of both"));
        }
        (None, Some(gap)) => ("gap", wire_diameter, gap.map(|gap| gap + wire_diameter)),
        (Some(pitch), None) => ("pitch", 0.0, pitch),
        (None, None) => ("pitch", 0.0, both("pitch")?),
    };
    let least = if telescopes { 0.0 } else { wire_diameter };
    for value in pitch {
        let allowed = match key {
            "gap" => "zero or above".to_owned(),
            _ => format!("at least {} m, where wires touch", plain(least)),
        };
        table.check(key, value.is_finite() && value >= least * (1.0 - CLOSED), value - more, &allowed)?;
    }
    Ok(Wound { windings, pitch: pitch.map(|pitch| pitch.max(least)), coil_diameter, wire_diameter, telescopes })
}

/// That ends which are said to be closed are.
fn closed_ends(end_type: EndType, tables: &[Section<'_>], each: &[Wound]) -> Result<(), SpecError> {
    if !matches!(end_type, EndType::Closed | EndType::ClosedGround) {
        return Ok(());
    }
    let last = each.len() - 1;
    for (number, side, whose) in [(0, 0, "begins at end 1"), (last, 1, "ends at end 2")] {
        let section = &each[number];
        let gap = section.pitch[side] - section.wire_diameter;
        if gap > CLOSED * section.wire_diameter {
            let key = if tables[number].has("gap") { "gap" } else { "pitch" };
            let why = format!(
                "{whose} of closed ends with a gap of {} mm: must touch there, so that the wire lies on its seat; closed windings are a section of their own",
                plain(1e3 * gap)
            );
            return Err(tables[number].refuse(key, why));
        }
    }
    Ok(())
}

fn largest_gap(section: &Wound) -> f64 {
    section.pitch[0].max(section.pitch[1]) - section.wire_diameter
}

fn mass(section: &Wound, density: f64) -> f64 {
    let wire = 0.25 * std::f64::consts::PI * section.wire_diameter.powi(2);
    let turn = 0.5 * std::f64::consts::PI * (section.coil_diameter[0] + section.coil_diameter[1]);
    density * wire * section.windings * turn.hypot(section.wire_diameter)
}

/// An error of the science at the table that it is about.
fn located(tables: &[Section<'_>], error: &coilsense::Error) -> SpecError {
    tables[0].refuse_science(error, &[])
}
