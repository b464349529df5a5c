//! What an FMU says of itself: its values, their units and words.
//!
//! Next door: the same numbers in C (`unit.h`), the form of the file (`fmi2.xml`, `fmi3.xml`).

use coilsense::plant::ModalPlant;
use coilsense_rt::FarEnd;
use minijinja::{Value, context};

use super::super::{Fmi, Plant, header};

/// All that the templates tell.
pub(super) struct Told<'a> {
    name: &'a str,
    step: String,
    title: String,
    description: String,
    has_mass: bool,
    has_coil: bool,
    variables: Vec<Variable>,
    outputs: Vec<Output>,
    states: Vec<State>,
}

/// A value of the FMU; its number is its place among all, counted from one.
#[derive(Default)]
struct Variable {
    name: String,
    causality: &'static str,
    variability: &'static str,
    unit: &'static str,
    start: Option<String>,
    /// Its usual size, by which a solver's tolerance counts.
    nominal: Option<String>,
    /// Of a derivative: the number of its state, and the numbers of what it depends on.
    derivative: Option<(usize, Vec<usize>)>,
    description: String,
}

/// A state of a mode, for a solver.
struct State {
    name: String,
    nominal: String,
    description: String,
    /// Places among all states of those on which its derivative depends.
    dependencies: Vec<usize>,
}

/// A value that the spring gives. One that is added is one more row here.
struct Output {
    name: &'static str,
    unit: &'static str,
    /// Where it comes from, in C.
    from: String,
    description: String,
}

/// A unit in powers of SI's base units, in the order in which the standard has them.
struct Unit {
    name: &'static str,
    powers: &'static [(&'static str, i8)],
}

/// A motion of an end \[m\] that matters: what it pulls is what a solver's tolerance is a share of, in every mode. With 1 mm in its place, forces of
/// S_T shaken by 1 mm were 20 times as far off at a tolerance of 1e-6.
const SMALL_MOTION: f64 = 1e-5;

const UNITS: [Unit; 8] = [
    Unit { name: "m", powers: &[("m", 1)] },
    Unit { name: "m/s", powers: &[("m", 1), ("s", -1)] },
    Unit { name: "N", powers: &[("kg", 1), ("m", 1), ("s", -2)] },
    Unit { name: "N/s", powers: &[("kg", 1), ("m", 1), ("s", -3)] },
    Unit { name: "N/m", powers: &[("kg", 1), ("s", -2)] },
    Unit { name: "kg", powers: &[("kg", 1)] },
    Unit { name: "H", powers: &[("kg", 1), ("m", 2), ("s", -2), ("A", -2)] },
    Unit { name: "1", powers: &[] },
];

impl Unit {
    fn value(&self) -> Value {
        let powers = self.powers.iter().map(|(base, power)| Value::from(vec![Value::from(*base), Value::from(*power)]));
        context! { name => self.name, powers => powers.collect::<Vec<_>>() }
    }
}

impl Variable {
    /// Where its value comes from when it starts; an input's always from outside.
    fn initial(&self) -> Option<&'static str> {
        match (self.causality, &self.start) {
            ("input", _) => None,
            (_, Some(_)) => Some("exact"),
            (_, None) => Some("calculated"),
        }
    }

    fn value(&self) -> Value {
        let Self { name, causality, variability, unit, start, nominal, derivative, description } = self;
        context! {
            name => name.as_str(),
            causality => *causality,
            variability => *variability,
            initial => self.initial(),
            unit => *unit,
            start => start.clone(),
            nominal => nominal.clone(),
            derivative => derivative.as_ref().map(|(state, _)| *state),
            dependencies => derivative.as_ref().map(|(_, numbers)| numbers.clone()),
            description => description.as_str(),
        }
    }
}

impl Output {
    fn variable(&self) -> Variable {
        Variable {
            name: self.name.to_owned(),
            causality: "output",
            variability: "continuous",
            unit: self.unit,
            description: self.description.clone(),
            ..Variable::default()
        }
    }
}

impl<'a> Told<'a> {
    pub fn of(made: &Plant, name: &'a str, version: Fmi, step: f64) -> Self {
        let plant = &made.plant;
        let doubts: String = made.warnings.iter().map(|warning| format!(" {warning}.")).collect();
        let description = format!(
            "Forces of the coil spring {}, {}, {} modes, about {} mm. {}{doubts}",
            made.spring,
            made.damping,
            plant.count(),
            1e3 * plant.mean_length(),
            how_inputs_go(version, plant.dashpot_time() > 0.0)
        );
        let outputs = outputs(made, name);
        let mut variables = inputs(plant.far_end() == FarEnd::Position);
        variables.extend(parameters(made));
        variables.extend(outputs.iter().map(Output::variable));
        let states = if version == Fmi::Two { states(&made.plant) } else { Vec::new() };
        let before = variables.len() + 1;
        variables.extend(states.iter().map(State::variable));
        variables.extend(states.iter().enumerate().map(|(place, state)| state.derivative(before, place)));
        let (title, step) = (header::title(made, name), format!("{step:?}"));
        let (has_mass, has_coil) = (plant.far_end() == FarEnd::Mass, made.coil.is_some());
        Self { name, step, title, description, has_mass, has_coil, variables, outputs, states }
    }

    pub fn context(&self) -> Value {
        context! {
            name => self.name,
            upper => self.name.to_ascii_uppercase(),
            step => self.step.as_str(),
            title => self.title.as_str(),
            description => self.description.as_str(),
            tool => concat!("coilsense ", env!("CARGO_PKG_VERSION")),
            has_mass => self.has_mass,
            has_coil => self.has_coil,
            outputs => self.outputs.iter().map(|output| output.from.clone()).collect::<Vec<_>>(),
            nominals => self.states.iter().map(|state| state.nominal.clone()).collect::<Vec<_>>(),
            variables => self.variables.iter().map(Variable::value).collect::<Vec<_>>(),
            units => UNITS.map(|unit| unit.value()).to_vec(),
        }
    }
}

/// How inputs go between two communication points, and what rates are to equations.
fn how_inputs_go(version: Fmi, has_dashpots: bool) -> String {
    let rates = match version {
        Fmi::Two => "the rates der_... (or fmi2SetRealInputDerivatives)",
        Fmi::Three => "the rates der_...",
    };
    let steps = format!(
        "Inputs count from their means and run straight within a communication step: from where they were at its start to u + du/dt h at its end, \
         with {rates}, where a step is exact. Where a host sets no rate, they run to the value that is set, that is, straight between its last two \
         values, one step late. Rates stay until they are set again."
    );
    let equations = match (version, has_dashpots) {
        (Fmi::Three, _) => "",
        (Fmi::Two, true) => {
            " In model exchange inputs are what is set at each moment, and der_... their true rates then: the dashpots at the ends pull with them, \
             and where a host sets none, F_i and F_o lack that part."
        }
        (Fmi::Two, false) => {
            " In model exchange inputs are what is set at each moment, and the rates der_... are not used: only dashpots at the ends would need them."
        }
    };
    steps + equations
}

impl State {
    fn variable(&self) -> Variable {
        Variable {
            name: self.name.clone(),
            causality: "local",
            variability: "continuous",
            unit: "m",
            nominal: Some(self.nominal.clone()),
            description: self.description.clone(),
            ..Variable::default()
        }
    }

    /// - `first`: the number of the first state; `place`: this one's place among them
    fn derivative(&self, first: usize, place: usize) -> Variable {
        let inputs = [1, 2].into_iter();
        let numbers = inputs.chain(self.dependencies.iter().map(|state| first + state)).collect();
        Variable {
            name: format!("der_{}", self.name),
            causality: "local",
            variability: "continuous",
            unit: "m/s",
            derivative: Some((first + place, numbers)),
            description: format!("Rate of {}", self.name),
            ..Variable::default()
        }
    }
}

/// Two states a mode, each so large that a solver's tolerance is about that share of what a small motion of an end pulls.
fn states(plant: &ModalPlant) -> Vec<State> {
    let (stiffness, has_dashpots) = (plant.spring().stiffness(), plant.dashpot_time() > 0.0);
    let each = plant.modes().iter().zip(plant.ratios()).enumerate().flat_map(|(index, (mode, ratio))| {
        let [input, output] = mode.weights;
        let pull = input.abs().max(output.abs()).max((stiffness * mode.end).abs());
        let size = if pull > 0.0 { SMALL_MOTION * stiffness / pull } else { SMALL_MOTION };
        // A mode that creeps forgives what is wrong with its pace; dashpots pull with that.
        let creeps = (2.0 * ratio).max(1.0);
        let of_pace = if has_dashpots { size / creeps } else { size * creeps };
        let (number, hertz) = (index + 1, mode.frequency / std::f64::consts::TAU);
        let of = if index < plant.kept() { "Mode" } else { "For all modes left out, mode" };
        let (place, pace) = (2 * index, 2 * index + 1);
        [
            State {
                name: format!("z_{number}"),
                nominal: format!("{size:e}"),
                description: format!("{of} {number}, {hertz:.4} Hz: its motion relative to the mean"),
                dependencies: vec![pace],
            },
            State {
                name: format!("w_{number}"),
                nominal: format!("{of_pace:e}"),
                description: format!(
                    "{of} {number}: its pace over its angular frequency, less 2 zeta times what the ends drag along"
                ),
                dependencies: vec![place, pace],
            },
        ]
    });
    each.collect()
}

/// Inputs and their rates.
fn inputs(is_position: bool) -> Vec<Variable> {
    let input = |name: &str, unit, description: &str| {
        let (causality, variability, start) = ("input", "continuous", Some("0.0".to_owned()));
        Variable {
            name: name.to_owned(),
            causality,
            variability,
            unit,
            start,
            description: description.to_owned(),
            ..Variable::default()
        }
    };
    let first = input("u1", "m", "Position of end 1 from its mean");
    let rate = input("der_u1", "m/s", "Rate of u1, in co-simulation during the next step");
    if is_position {
        let second = input("u2", "m", "Position of end 2 from its mean");
        return vec![first, second, rate, input("der_u2", "m/s", "Rate of u2, in co-simulation during the next step")];
    }
    let second = input("F_2", "N", "Force on end 2 away from end 1, from its mean");
    vec![first, second, rate, input("der_F_2", "N/s", "Rate of F_2, in co-simulation during the next step")]
}

/// k, m and ζ.
fn parameters(made: &Plant) -> [Variable; 3] {
    let numbers = header::Numbers::of(&made.plant);
    let parameter = |name: &str, unit, start: f64, description: &str| {
        let (causality, variability, start) = ("parameter", "fixed", Some(format!("{start:?}")));
        Variable {
            name: name.to_owned(),
            causality,
            variability,
            unit,
            start,
            description: description.to_owned(),
            ..Variable::default()
        }
    };
    let mut mass = parameter("m", "kg", numbers.mass, "Mass of the windings");
    if made.plant.far_end() == FarEnd::Mass {
        (mass.causality, mass.variability) = ("local", "constant");
        mass.description += "; fixed, as the modes belong to the mass at end 2";
    }
    let ratio = "Damping ratio of the first mode that is damped; the others keep their share of it";
    [parameter("k", "N/m", numbers.stiffness, "Stiffness"), mass, parameter("zeta", "1", numbers.damping_ratio, ratio)]
}

fn outputs(made: &Plant, header: &str) -> Vec<Output> {
    let mean = made.plant.mean_force();
    let force = |what: &str| {
        format!(
            "{what}, tension positive; {mean:?} N where all inputs are zero and nothing moves, with the spring's own k"
        )
    };
    let output = |name, unit, from: &str, description| Output { name, unit, from: from.to_owned(), description };
    let mut outputs = vec![
        output("F_i", "N", "out->input", force("Force at end 1")),
        output("F_o", "N", "out->output", force("Force at end 2")),
        output("F_x", "N", "out->deflection", force("k times the stretch between the ends")),
    ];
    if made.plant.far_end() != FarEnd::Position {
        outputs.push(output("u2", "m", "out->end", "Position of end 2 from its mean".to_owned()));
    }
    if made.coil.is_some() {
        let bound = |of: &str| {
            format!(
                "How far {of} may be from Maxwell's sum over these windings; the largest number where nothing is known: beyond the lengths in use, or \
                 where windings would meet"
            )
        };
        let of_inductance =
            force("Force by the inductance of wire that is not magnetic, by its calibration over the lengths in use");
        outputs.extend([
            output("F_L", "N", "coil.force", of_inductance),
            output("F_L_bound", "N", "coil.force_bound", bound("F_L")),
            output("L", "H", "coil.inductance", "Inductance".to_owned()),
            output("L_bound", "H", "coil.inductance_bound", bound("L")),
        ]);
    }
    if let Some(windings) = &made.windings {
        let description = format!(
            "Smallest distance between neighbouring windings, centre to centre; below {:?} m they would have met, and this is no longer the spring",
            windings.contact_pitch()
        );
        outputs.push(output("closest_pitch", "m", &format!("{header}_closest_pitch(plant, state)"), description));
    }
    outputs
}
