//! What an FMU says of itself: its values, their numbers, units and words.
//!
//! Next door: the same numbers in C (`unit.h`), the form of the file (`fmi2.xml`).

use coilsense_rt::FarEnd;
use minijinja::{Value, context};

use super::super::{Plant, header};

/// All that the templates tell.
pub(super) struct Told<'a> {
    name: &'a str,
    step: String,
    title: String,
    description: String,
    far_end: FarEnd,
    variables: Vec<Variable>,
}

/// A value of the FMU.
struct Variable {
    name: &'static str,
    number: u32,
    causality: &'static str,
    variability: &'static str,
    unit: &'static str,
    start: Option<String>,
    description: String,
}

/// A unit in powers of SI's base units, in the order in which the standard has them.
struct Unit {
    name: &'static str,
    powers: &'static [(&'static str, i8)],
}

const UNITS: [Unit; 7] = [
    Unit { name: "m", powers: &[("m", 1)] },
    Unit { name: "m/s", powers: &[("m", 1), ("s", -1)] },
    Unit { name: "N", powers: &[("kg", 1), ("m", 1), ("s", -2)] },
    Unit { name: "N/s", powers: &[("kg", 1), ("m", 1), ("s", -3)] },
    Unit { name: "N/m", powers: &[("kg", 1), ("s", -2)] },
    Unit { name: "kg", powers: &[("kg", 1)] },
    Unit { name: "1", powers: &[] },
];

/// How inputs go between two communication points.
const INPUTS: &str = "Inputs count from their means and run straight within a communication step: from where they were at its start to u + du/dt h at \
    its end, with the rates der_... (or fmi2SetRealInputDerivatives), where a step is exact. Where a host sets no rate, they run to the value that is set, \
    that is, straight between its last two values, one step late. Rates stay until they are set again.";

impl Unit {
    fn value(&self) -> Value {
        let powers = self.powers.iter().map(|(base, power)| Value::from(vec![Value::from(*base), Value::from(*power)]));
        context! { name => self.name, powers => powers.collect::<Vec<_>>() }
    }
}

impl Variable {
    fn value(&self) -> Value {
        let Self { name, number, causality, variability, unit, start, description } = self;
        context! {
            name => *name,
            number => *number,
            causality => *causality,
            variability => *variability,
            unit => *unit,
            start => start.clone(),
            description => description.as_str(),
        }
    }
}

impl<'a> Told<'a> {
    pub fn of(made: &Plant, name: &'a str, step: f64) -> Self {
        let plant = &made.plant;
        let description = format!(
            "Forces of the coil spring {}, {}, {} modes, about {} mm. {INPUTS}",
            made.spring,
            made.damping,
            plant.count(),
            1e3 * plant.mean_length()
        );
        let step = format!("{step:?}");
        let (title, far_end) = (header::title(made, name), plant.far_end());
        Self { name, step, title, description, far_end, variables: variables(made) }
    }

    pub fn context(&self) -> Value {
        context! {
            name => self.name,
            upper => self.name.to_ascii_uppercase(),
            step => self.step.as_str(),
            title => self.title.as_str(),
            description => self.description.as_str(),
            tool => concat!("coilsense ", env!("CARGO_PKG_VERSION")),
            is_position => self.far_end == FarEnd::Position,
            has_mass => self.far_end == FarEnd::Mass,
            variables => self.variables.iter().map(Variable::value).collect::<Vec<_>>(),
            units => UNITS.map(|unit| unit.value()).to_vec(),
        }
    }
}

fn variables(made: &Plant) -> Vec<Variable> {
    let plant = &made.plant;
    let numbers = header::Numbers::of(plant);
    let is_position = plant.far_end() == FarEnd::Position;
    let mut variables = inputs(is_position);
    let force = format!(
        "tension positive; {:?} N where all inputs are zero and nothing moves, with the spring's own k",
        plant.mean_force()
    );
    let output = |number, name, unit, description: String| {
        let (causality, variability) = ("output", "continuous");
        Variable { name, number, causality, variability, unit, start: None, description }
    };
    variables.extend([
        output(5, "F_i", "N", format!("Force at end 1, {force}")),
        output(6, "F_o", "N", format!("Force at end 2, {force}")),
        output(7, "F_x", "N", format!("k times the stretch between the ends, {force}")),
    ]);
    if !is_position {
        variables.push(output(8, "u2", "m", "Position of end 2 from its mean".to_owned()));
    }
    let parameter = |number, name, unit, start: f64, description: &str| {
        let (causality, variability) = ("parameter", "fixed");
        Variable {
            name,
            number,
            causality,
            variability,
            unit,
            start: Some(format!("{start:?}")),
            description: description.to_owned(),
        }
    };
    variables.push(parameter(9, "k", "N/m", numbers.stiffness, "Stiffness"));
    variables.push(parameter(10, "m", "kg", numbers.mass, "Mass of the windings"));
    if let (FarEnd::Mass, Some(mass)) = (plant.far_end(), variables.last_mut()) {
        (mass.causality, mass.variability) = ("local", "constant");
        mass.description += "; fixed, as the modes belong to the mass at end 2";
    }
    let ratio = "Damping ratio of the first mode that is damped; the others keep their share of it";
    variables.push(parameter(11, "zeta", "1", numbers.damping_ratio, ratio));
    variables
}

/// Inputs and their rates.
fn inputs(is_position: bool) -> Vec<Variable> {
    let input = |number, name, unit, description: &str| {
        let (causality, variability, start) = ("input", "continuous", Some("0.0".to_owned()));
        Variable { name, number, causality, variability, unit, start, description: description.to_owned() }
    };
    let first = input(1, "u1", "m", "Position of end 1 from its mean");
    let rate = input(3, "der_u1", "m/s", "Rate of u1 during the next communication step");
    if is_position {
        let second = input(2, "u2", "m", "Position of end 2 from its mean");
        return vec![first, second, rate, input(4, "der_u2", "m/s", "Rate of u2 during the next communication step")];
    }
    let second = input(2, "F_2", "N", "Force on end 2 away from end 1, from its mean");
    vec![first, second, rate, input(4, "der_F_2", "N/s", "Rate of F_2 during the next communication step")]
}
