//! How far off each force is over frequency: what one place of the spring says of the force at another while an end is moved by a sine.
//!
//! Next door: the same over time (`crate::analysis`), the response itself (`coilsense::plant`).

use std::f64::consts::TAU;

use coilsense::excitation::{Content, EndInput};
use coilsense::modes::ModalModel;
use coilsense::plant::{ModalPlant, Order};
use coilsense::{Channel, End, Error, FarEnd};
use coilsense_figure::{Axis, Band, Colour, Curve, Dash, Figure, HorizontalMark, Mark, Panel, Scale, Stroke};

use crate::quantity::digits;
use crate::spec::Spec;
use crate::study;

/// From and up to which share of the first surge frequency it is drawn, in so many steps.
const FROM: f64 = 0.01;
const TO: f64 = 4.5;
const STEPS: u32 = 900;
/// The error up to which a force is said to follow \[1\].
const WITHIN: f64 = 0.01;
/// Errors that are drawn \[%\].
const SHOWN: (f64, f64) = (1e-3, 1e3);
/// The forces of a plant, as it numbers them.
const FORCES: [Channel; 3] = [Channel::InputForce, Channel::OutputForce, Channel::DeflectionForce];
const LOOKS: [(Colour, Dash); 3] =
    [(Colour::Blue, Dash::DashDot), (Colour::Red, Dash::Solid), (Colour::Green, Dash::Dotted)];

/// The figure, and what its caption says.
pub(super) struct OverFrequency {
    pub figure: Figure,
    pub caption: String,
}

/// A spring on its mount at one damping, moved at one end; its forces against one of them.
struct Response {
    plant: ModalPlant,
    input: usize,
    reference: usize,
}

impl Response {
    /// `None` for a coil of sections, which has no response to a sine.
    fn of(spec: &Spec, damping: usize, input: End) -> Option<Self> {
        let spring = &spec.spring.spring;
        let mount = study::mounted(&spec.mount.cases[damping].mount, spring).ok()?;
        let plant = ModalPlant::new(spring, &mount, spring.rest_length(), Order::All).ok()?;
        let reference = FORCES.iter().position(|force| *force == spec.goal.force).unwrap_or(2);
        Some(Self { plant, input: usize::from(input == End::Two), reference })
    }

    /// How far a force is off, over the reference's size \[1\].
    fn error(&self, force: usize, hertz: f64) -> Result<f64, Error> {
        let response = self.plant.response(hertz)?;
        let reference = response[self.reference][self.input];
        Ok((response[force][self.input] - reference).norm() / reference.norm())
    }

    fn errors(&self, force: usize, frequencies: &[f64]) -> Result<Vec<f64>, Error> {
        frequencies.iter().map(|hertz| self.error(force, *hertz)).collect()
    }

    /// Up to which of some frequencies \[Hz\] a force keeps within [`WITHIN`]; `None` where it does over all of them.
    fn follows(&self, force: usize, frequencies: &[f64]) -> Result<Option<f64>, Error> {
        let errors = self.errors(force, frequencies)?;
        let Some(beyond) = errors.iter().position(|error| error.is_nan() || *error > WITHIN) else { return Ok(None) };
        let (mut low, mut high) = (if beyond == 0 { 0.0 } else { frequencies[beyond - 1] }, frequencies[beyond]);
        while high - low > 1e-6 * high {
            let middle = 0.5 * (low + high);
            if self.error(force, middle)? <= WITHIN { low = middle } else { high = middle }
        }
        Ok(Some(low))
    }
}

/// The figure of a spec; `None` for a coil whose response to a sine is not one.
pub(super) fn over_frequency(spec: &Spec) -> Option<OverFrequency> {
    let input = driven(spec);
    let cases = &spec.mount.cases;
    let responses: Vec<Response> =
        (0..cases.len()).map(|damping| Response::of(spec, damping, input)).collect::<Option<_>>()?;
    let frequencies = frequencies(spec);
    let others = || (0..FORCES.len()).filter(|force| *force != responses[0].reference);
    let reference = FORCES[responses[0].reference].name();
    let parts: Vec<(Curve, Option<Band>)> =
        others().map(|force| part(&responses, force, &frequencies)).collect::<Result<_, _>>().ok()?;
    let (curves, bands): (Vec<Curve>, Vec<Option<Band>>) = parts.into_iter().unzip();
    let lines = ModalModel::chain(&spec.spring.spring, spec.mount.far_end());
    let lines = lines.frequencies().iter().map(|angular| angular / TAU).enumerate();
    let (from, to) = (frequencies[0], frequencies[frequencies.len() - 1]);
    let marks = lines.filter(|(_, line)| *line < to).map(|(j, x)| Mark { x, label: format!("f_{{{}}}", j + 1) });
    let panel = Panel {
        x: Axis { label: "Frequency [Hz]".into(), range: Some((from, to)), scale: Scale::Log10 },
        y: Axis { label: format!("Deviation from {reference} [% of it]"), range: Some(SHOWN), scale: Scale::Log10 },
        curves,
        bands: bands.into_iter().flatten().collect(),
        limits: vec![HorizontalMark { y: 100.0 * WITHIN, label: format!("{} %", 100.0 * WITHIN) }],
        marks: marks.collect(),
        ..Panel::default()
    };
    let follows = others().map(|force| {
        let found: Result<Vec<Option<f64>>, Error> =
            responses.iter().map(|response| response.follows(force, &frequencies)).collect();
        let least = found.ok()?.into_iter().flatten().fold(f64::INFINITY, f64::min);
        let up_to = if least.is_finite() { format!("up to {} Hz", digits(least)) } else { "at all of them".to_owned() };
        Some(format!("{} is within {} % of {reference} {up_to}", FORCES[force].name(), 100.0 * WITHIN))
    });
    let follows: Vec<String> = follows.collect::<Option<_>>()?;
    let drawn = if cases.len() > 1 {
        format!("Curves: {}; shaded: {} to {}.", cases[0].label, cases[0].label, cases[cases.len() - 1].label)
    } else {
        format!("{}.", cases[0].label)
    };
    let caption = format!(
        "While end {} is {} sinusoidally, {}. {drawn} Axial motion only; windings do not touch.",
        if input == End::One { 1 } else { 2 },
        if spec.mount.far_end() == FarEnd::Force { "pulled" } else { "moved" },
        follows.join(" and ")
    );
    Some(OverFrequency {
        figure: Figure { panels: vec![panel], columns: 1, panel_width: 760.0, panel_height: 300.0 },
        caption,
    })
}

/// From which share of the goal's bandwidth on a sine shows what the ends do at it \[1\].
const NEAR: f64 = 0.25;

/// Where the force is wanted and no condition moves: what the figures of the sensors do not contain; `None` where they do, or where the ends agree within
/// the goal.
pub(super) fn unmoved(spec: &Spec) -> Option<String> {
    let (error, bandwidth) = (spec.goal.error?, spec.goal.bandwidth?);
    let moves = |input: &EndInput| match input {
        EndInput::Harmonics(sines) => sines.iter().any(|sine| (NEAR * bandwidth..=bandwidth).contains(&sine.frequency)),
        EndInput::Chirp { .. } | EndInput::HalfSine { .. } | EndInput::Sampled(_) => true,
        EndInput::Held | EndInput::Step { .. } | EndInput::Ramp { .. } => false,
    };
    let is_moved = spec
        .conditions
        .iter()
        .any(|each| [End::One, End::Two].map(|end| moves(each.excitation.input(end))).contains(&true));
    if is_moved {
        return None;
    }
    let input = driven(spec);
    let responses: Vec<Response> =
        (0..spec.mount.cases.len()).map(|damping| Response::of(spec, damping, input)).collect::<Option<_>>()?;
    let mut up_to: Vec<f64> = frequencies(spec).into_iter().filter(|hertz| *hertz < bandwidth).collect();
    up_to.push(bandwidth);
    let largest = |force: usize| -> Result<f64, Error> {
        let each = responses.iter().map(|response| response.errors(force, &up_to)).collect::<Result<Vec<_>, _>>()?;
        Ok(each.into_iter().flatten().fold(0.0, f64::max))
    };
    let others: Vec<usize> = (0..FORCES.len()).filter(|force| *force != responses[0].reference).collect();
    let off: Vec<f64> = others.iter().map(|&force| largest(force)).collect::<Result<_, _>>().ok()?;
    let goal = error / spec.spring.spring.nominal_force();
    if off.iter().all(|off| *off <= goal) {
        return None;
    }
    let reference = FORCES[responses[0].reference].name();
    let each = others.iter().zip(&off).map(|(&force, off)| {
        format!("{} is off {reference} by up to {} % of its swing", FORCES[force].name(), digits(100.0 * off))
    });
    let (from, to) = (digits(NEAR * bandwidth), digits(bandwidth));
    Some(format!(
        "No condition moves the spring by a sine from {from} to {to} Hz, although the force is wanted up to there. Moved so, {}; no figure contains that. Add \
         a harmonic condition at {to} Hz.",
        each.collect::<Vec<_>>().join(" and ")
    ))
}

/// A force at the first damping, and over all of them where there are several.
fn part(responses: &[Response], force: usize, frequencies: &[f64]) -> Result<(Curve, Option<Band>), Error> {
    let of = |response: &Response| {
        let errors = response.errors(force, frequencies)?;
        Ok::<Vec<f64>, Error>(
            errors.into_iter().map(|error| (100.0 * error).clamp(0.1 * SHOWN.0, 10.0 * SHOWN.1)).collect(),
        )
    };
    let all = responses.iter().map(of).collect::<Result<Vec<_>, _>>()?;
    let (colour, dash) = LOOKS[force];
    let extreme = |pick: fn(f64, f64) -> f64| -> Vec<f64> {
        (0..frequencies.len()).map(|at| all.iter().map(|each| each[at]).reduce(pick).unwrap_or(f64::NAN)).collect()
    };
    let band = (all.len() > 1).then(|| Band {
        label: String::new(),
        x: frequencies.to_vec(),
        lower: extreme(f64::min),
        upper: extreme(f64::max),
        colour,
    });
    let curve = Curve {
        label: FORCES[force].name().into(),
        x: frequencies.to_vec(),
        y: all[0].clone(),
        stroke: Stroke { colour, dash, width: 1.5 },
    };
    Ok((curve, band))
}

/// The end that conditions move; end 1 where they move both.
fn driven(spec: &Spec) -> End {
    let rests = |end: End| {
        spec.conditions.iter().all(|condition| condition.excitation.input(end).content() == Content::Nothing)
    };
    match spec.mount.far_end() {
        FarEnd::Force => End::Two,
        _ if rests(End::One) && !rests(End::Two) => End::Two,
        _ => End::One,
    }
}

/// Even on a logarithm, from a hundredth of the surge frequency or of a slower first mode on.
fn frequencies(spec: &Spec) -> Vec<f64> {
    let spring = &spec.spring.spring;
    let first =
        ModalModel::chain(spring, spec.mount.far_end()).frequencies().first().map_or(f64::INFINITY, |w| w / TAU);
    let (from, to) = (FROM * spring.surge_frequency().min(first), TO * spring.surge_frequency());
    (0..=STEPS).map(|step| from * (to / from).powf(f64::from(step) / f64::from(STEPS))).collect()
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::*;

    fn example(name: &str) -> Spec {
        Spec::read(&Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples").join(name)).unwrap()
    }

    /// Where a rising function of ωτ reaches [`WITHIN`].
    fn reached(error: impl Fn(f64) -> f64) -> f64 {
        let (mut low, mut high) = (1e-6, 1.0);
        while high - low > 1e-12 {
            let middle = 0.5 * (low + high);
            if error(middle) < WITHIN { low = middle } else { high = middle }
        }
        low
    }

    #[test]
    fn an_undamped_spring_is_off_as_the_closed_forms_of_its_wave_say() {
        let spec = example("sea-ankle.toml");
        let tau = spec.spring.spring.transit_time();
        let undamped = Response::of(&spec, 0, End::One).unwrap();
        assert!(undamped.plant.ratios().all(|ratio| ratio == 0.0));
        let frequencies = frequencies(&spec);
        // F_i = k ωτ cot ωτ, F_o = k ωτ / sin ωτ; a chain of 52 masses is some 1e-4 beside it.
        for (force, closed) in [(0, reached(|z| 1.0 - z / z.tan())), (1, reached(|z| z / z.sin() - 1.0))] {
            let found = undamped.follows(force, &frequencies).unwrap().unwrap();
            assert!((TAU * found * tau / closed - 1.0).abs() < 1e-3, "{force}: {found} Hz, ωτ = {closed}");
        }
        // F_x is what both are compared with.
        assert_eq!(undamped.follows(2, &frequencies).unwrap(), None);
    }

    #[test]
    fn the_caption_names_the_least_of_all_dampings_and_what_is_left_out() {
        let shown = over_frequency(&example("sea-ankle.toml")).unwrap();
        for said in [
            "of F_x",
            "end 1 is moved",
            "F_i is within 1 % of F_x up to 2.9",
            "F_o is within 1 % of F_x up to 4.2",
            "windings do not touch",
        ] {
            assert!(shown.caption.contains(said), "{said}: {}", shown.caption);
        }
        assert_eq!(shown.figure.panels[0].curves.len(), 2);
        assert_eq!(shown.figure.panels[0].bands.len(), 2);
    }

    /// S_T by the template, whose goal reaches to 20 Hz and whose sines are at 27 and 54 Hz.
    fn template(tables: impl Fn(&str) -> String) -> Spec {
        Spec::parse("template", &tables(&crate::spec::template(Some("S_T")).unwrap()), &|_| unreachable!()).unwrap()
    }

    #[test]
    fn a_goal_up_to_where_no_condition_moves_says_what_its_figures_leave_out() {
        let spec = template(str::to_owned);
        let said = unmoved(&spec).unwrap();
        // F_i = k ωτ cot ωτ, F_o = k ωτ / sin ωτ at 20 Hz.
        let z = TAU * 20.0 * spec.spring.spring.transit_time();
        for off in [1.0 - z / z.tan(), z / z.sin() - 1.0] {
            assert!(said.contains(&format!("by up to {:.1}", 100.0 * off)), "{off}: {said}");
        }
        assert!(said.contains("from 5.00 to 20.0 Hz") && said.contains("off F_x"), "{said}");
        // Where one moves there, where everything counts, where nothing is asked, or the ends agree within the goal, there is nothing to say.
        let moved = template(|text| text.replace("frequency = \"0.5 f1\"", "frequency = \"15 Hz\""));
        assert_eq!(unmoved(&moved), None);
        let still = template(|text| text.replace("frequency = \"0.5 f1\"", "frequency = \"4 Hz\""));
        assert!(unmoved(&still).is_some());
        let everywhere = template(|text| text.replace("bandwidth = \"20 Hz\" ", "# "));
        assert_eq!((everywhere.goal.bandwidth, unmoved(&everywhere)), (None, None));
        let slow = template(|text| text.replace("bandwidth = \"20 Hz\" ", "bandwidth = \"2 Hz\" "));
        assert_eq!(unmoved(&slow), None, "0.5 % at 2 Hz");
        // A recorded road moves at many frequencies.
        assert_eq!(unmoved(&example("car-suspension.toml")), None);
    }

    #[test]
    fn a_coil_of_sections_has_no_such_figure() {
        assert!(over_frequency(&example("progressive-spring.toml")).is_none());
    }
}
