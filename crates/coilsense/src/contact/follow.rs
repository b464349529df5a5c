//! Follows a chain from event to event.
//!
//! Next door: one step (`series`), what happens at an event (`meet`), what is written down (`book`).

use super::book::{Book, end_forces, energy, tension};
use super::chain::Chain;
use super::course::{Course, GivenUp, Lift};
use super::damper::Damper;
use super::drive::Drive;
use super::law::{Contact, Law};
use super::meet::{MARGIN, Solid, collide, settle};
use super::polynomial::{Polynomial, first_fall, value};
use super::series::{Now, Series, System};
use super::tridiagonal::Runs;
use crate::damping::Damping;
use crate::error::{Error, all_bounded, check, count, finite};
use crate::mount::FarEnd;

/// How far a step goes \[rad\] at the fastest that the chain or its drive can do: order 26 leaves out 1e-20 then.
const REACH: f64 = 2.0;

/// Where a chain is when it is first looked at.
#[derive(Debug, Clone, PartialEq)]
pub struct Start {
    /// \[s\].
    pub time: f64,
    /// Displacements of the lumps from the unloaded spring whose end 1 is at zero \[m\], shape `N`.
    pub places: Vec<f64>,
    /// \[m/s\], shape `N`.
    pub speeds: Vec<f64>,
}

/// Follows a chain and tells what it does at `times` \[s\], ascending, none before its start.
///
/// m_i ÿ_i = k_i (y_(i+1) − y_i) − k_(i−1) (y_i − y_(i−1)) + damping + λ_(c) − λ_(c+1), 0 ≤ λ ⟂ gap ≥ 0, gap = y_2 − y_1 + g; where points meet
/// a Newton impulse, v⁺ = −e v⁻
///
/// - `drives`: the displacement of end 1 and, counted from where end 2 of the unloaded spring is, that of end 2 \[m\]; where end 2 is under a
///   force or has a mass, the force \[N\]
///
/// Source:   Taylor series of the linear chain between events; impulses and forces as linear complementarity problems.
/// Valid:    what meets are points; friction, rolling and the shock inside a wire are left out. No value of e for windings was found.
/// Accuracy: energy adds up to 1e-10 of what moves; what follows from a motion that a small change turns round is only good in its mean squares.
///
/// # Errors
/// [`Error::Count`] for a start of other than N lumps; [`Error::Value`] for times before the start or out of order, numbers that are not
/// finite, a pair that overlaps at the start, and for damping by ratios, which asks for modes.
pub fn follow(
    chain: &Chain,
    contact: &Contact,
    damping: &Damping,
    drives: [Drive; 2],
    start: &Start,
    times: &[f64],
) -> Result<Course, Error> {
    follow_damped(chain, contact, &Damper::without_modes(damping)?, &drives, start, times, Watch::Forces)
}

/// What is told at each time.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Watch {
    Forces,
    Places,
}

/// The same where damping may need the chain's modes.
pub(super) fn follow_damped(
    chain: &Chain,
    contact: &Contact,
    damper: &Damper,
    drives: &[Drive; 2],
    start: &Start,
    times: &[f64],
    watch: Watch,
) -> Result<Course, Error> {
    crate::signals::increasing(times)?;
    finite("time", start.time, "s")?;
    if let Some(&first) = times.first() {
        check(first >= start.time, "time[0]", first, "s", format!("from the start at {} s on", start.time))?;
    }
    count("places", start.places.len(), chain.lumps())?;
    count("speeds", start.speeds.len(), chain.lumps())?;
    all_bounded("places", &start.places, "m")?;
    all_bounded("speeds", &start.speeds, "m/s")?;
    let system = System { chain, damper, drives, elastic: elastic(chain, contact) };
    let mut run = Run::new(&system, contact, start, times, watch);
    run.check_start()?;
    let given_up = run.follow().err();
    Ok(run.finish(given_up))
}

/// Stiffness and dashpots of windings that give way.
fn elastic(chain: &Chain, contact: &Contact) -> Option<(f64, Vec<f64>)> {
    let Law::Elastic { stiffness, damping_ratio } = contact.law() else { return None };
    let inverse = chain.inverse_masses();
    let dashpot = |mass: f64| 2.0 * damping_ratio * (stiffness * mass).sqrt();
    let each = chain.pairs().iter().map(|pair| dashpot(1.0 / (inverse[pair.first] + inverse[pair.second])));
    Some((stiffness, each.collect()))
}

/// What comes next.
#[derive(Debug, Clone, Copy)]
enum Event {
    Meets(usize),
    Parts(usize),
    Leaves(usize),
    Returns(usize),
}

struct Run<'a> {
    system: &'a System<'a>,
    contact: &'a Contact,
    times: &'a [f64],
    watch: Watch,
    now: Now,
    series: Series,
    book: Book,
    /// Of each open pair: how far it overlapped, by rounding, when it was let go \[m\].
    rest: Vec<f64>,
    /// Of each open elastic pair: whether it has not yet come back from being pressed.
    pressed: Vec<bool>,
    least: Vec<f64>,
    knots: Vec<f64>,
    input: Vec<f64>,
    output: Vec<f64>,
    end2: Vec<f64>,
    places: Vec<f64>,
    events: usize,
    deepest: f64,
    /// How long a step may be as it stands \[s\].
    step: f64,
}

impl<'a> Run<'a> {
    fn new(system: &'a System<'a>, contact: &'a Contact, start: &Start, times: &'a [f64], watch: Watch) -> Self {
        let chain = system.chain;
        let pairs = chain.pairs().len();
        let with_ends = |inner: &[f64]| std::iter::once(0.0).chain(inner.iter().copied()).chain([0.0]).collect();
        let now = Now {
            time: start.time,
            places: with_ends(&start.places),
            speeds: with_ends(&start.speeds),
            closed: vec![false; pairs],
            bonds: Runs::default(),
            attached: [true; 2],
        };
        let mut knots: Vec<f64> =
            system.drives.iter().flat_map(Drive::knots).filter(|knot| *knot > start.time).collect();
        knots.sort_by(f64::total_cmp);
        knots.dedup();
        let samples = times.len();
        let mut run = Self {
            system,
            contact,
            times,
            watch,
            book: Book::new(system, &now),
            now,
            series: Series::new(chain),
            rest: vec![0.0; pairs],
            pressed: vec![false; pairs],
            least: vec![0.0; pairs],
            knots,
            input: Vec::with_capacity(samples),
            output: Vec::with_capacity(samples),
            end2: Vec::with_capacity(samples),
            places: Vec::new(),
            events: 0,
            deepest: f64::INFINITY,
            step: 0.0,
        };
        run.drive_ends();
        run.step = run.nominal();
        run.book = Book::new(system, &run.now);
        run
    }

    /// Ends are where their drives are now: places and speeds, from the right.
    fn drive_ends(&mut self) {
        let last = self.system.chain.lumps() + 1;
        let ends = if self.system.chain.is_open() { &[0][..] } else { &[0, last][..] };
        for (drive, &point) in self.system.drives.iter().zip(ends) {
            // The first two coefficients over a second are place and speed.
            let series = drive.series(self.now.time, 1.0);
            (self.now.places[point], self.now.speeds[point]) = (series[0], series[1]);
        }
    }

    fn gap(&self, number: usize) -> f64 {
        self.now.gap(self.system.chain, number)
    }

    fn check_start(&self) -> Result<(), Error> {
        for number in 0..self.rest.len() {
            let pair = self.system.chain.pairs()[number];
            let quantity = format!("distance of points {} and {} at the start", pair.first, pair.second);
            check(self.gap(number) >= -MARGIN, quantity, self.gap(number), "m", "not below zero: they overlap")?;
        }
        Ok(())
    }

    fn follow(&mut self) -> Result<(), GivenUp> {
        if self.contact.lifts() {
            self.lift_at_once();
        }
        let until = self.times.last().copied().unwrap_or(self.now.time);
        let touching: Vec<usize> =
            (0..self.rest.len()).filter(|&number| self.gap(number) <= MARGIN && self.closes(number)).collect();
        if !touching.is_empty() {
            self.meets(&touching, false)?;
        }
        let mut knot = 0;
        while self.now.time < until {
            let to_knot = self.knots.get(knot).copied().unwrap_or(f64::INFINITY);
            let target = to_knot.min(until);
            let nominal = self.step;
            let left = target - self.now.time;
            let (step, reaches) = if left <= 1.01 * nominal { (left, true) } else { (nominal, false) };
            self.series.find(self.system, &self.now, step);
            let event = self.first_event();
            let tau = event.map_or(1.0, |(tau, _)| tau);
            self.write_down(tau);
            self.book.stepped(self.system, &self.now, &self.series, tau);
            self.series.advance(tau, &mut self.now);
            match event {
                Some((_, event)) => self.happens(event)?,
                None if reaches => {
                    self.now.time = target;
                    if to_knot == target {
                        knot += 1;
                        self.pass_knot()?;
                    }
                }
                None => {}
            }
            for number in 0..self.rest.len() {
                self.deepest = self.deepest.min(self.gap(number));
                if self.pressed[number] && self.gap(number) > 0.0 {
                    self.pressed[number] = false;
                }
            }
        }
        // The last sample is told from its right, as all others are.
        self.series.find(self.system, &self.now, self.step);
        self.write_down(f64::MIN_POSITIVE);
        Ok(())
    }

    /// Whether a pair that touches comes nearer, or would if nothing held it.
    fn closes(&mut self, number: usize) -> bool {
        let pair = self.system.chain.pairs()[number];
        let speed = self.now.speeds[pair.second] - self.now.speeds[pair.first];
        speed < 0.0 || speed == 0.0 && self.series.opening(self.system, &self.now, 1e-6)[number] < 0.0
    }

    /// How long a step lasts \[s\].
    fn nominal(&self) -> f64 {
        let chain = self.system.chain;
        let mut rates = vec![0.0; chain.lumps() + 2];
        for (segment, stiffness) in chain.stiffnesses().iter().enumerate() {
            rates[segment] += stiffness;
            rates[segment + 1] += stiffness;
        }
        let mut slowed: f64 = 0.0;
        if let Some((stiffness, dashpots)) = &self.system.elastic {
            let closed = chain.pairs().iter().zip(dashpots).zip(&self.now.closed).filter(|(_, closed)| **closed);
            for ((pair, dashpot), _) in closed {
                rates[pair.first] += stiffness;
                rates[pair.second] += stiffness;
                slowed = slowed.max(
                    4.0 * dashpot * chain.inverse_masses().iter().fold(0.0_f64, |most, inverse| most.max(*inverse)),
                );
            }
        }
        let each = rates.iter().zip(chain.inverse_masses());
        let angular = each.map(|(rate, inverse)| 2.0 * rate * inverse).fold(0.0, f64::max).sqrt();
        let driven = self.system.drives.iter().map(Drive::highest_angular).fold(0.0, f64::max);
        REACH / angular.max(driven).max(self.system.damper.fastest(chain, angular)).max(slowed)
    }

    /// The first that happens within the step.
    fn first_event(&mut self) -> Option<(f64, Event)> {
        let chain = self.system.chain;
        let mut first: Option<(f64, Event)> = None;
        let mut offer = |fall: Option<f64>, event: Event| {
            if let Some(tau) = fall
                && first.is_none_or(|(earliest, _)| tau < earliest)
            {
                first = Some((tau, event));
            }
        };
        self.series.least_gaps(chain, &mut self.least);
        let stiffest = chain.stiffnesses().iter().fold(0.0_f64, |most, stiffness| most.max(*stiffness));
        for number in 0..self.rest.len() {
            if self.now.closed[number] {
                let stiffness = self.system.elastic.as_ref().map_or(stiffest, |(stiffness, _)| *stiffness);
                offer(first_fall(&self.series.push(number), stiffness * MARGIN, 1.0), Event::Parts(number));
            } else if self.pressed[number] {
                if let Some((stiffness, dashpots)) = &self.system.elastic {
                    let gap = self.series.gap(chain, number);
                    offer(
                        first_fall(
                            &pull(&gap, *stiffness, dashpots[number], self.series.step),
                            stiffness * MARGIN,
                            1.0,
                        ),
                        Event::Meets(number),
                    );
                }
            } else if self.least[number] < self.rest[number] - MARGIN {
                let mut gap = self.series.gap(chain, number);
                gap[0] -= self.rest[number];
                offer(first_fall(&gap, MARGIN, 1.0), Event::Meets(number));
            }
        }
        if self.contact.lifts() {
            let [input, output] = end_forces(self.system, &self.now, &self.series);
            for (end, force) in [input, output].into_iter().enumerate().filter(|(end, _)| self.may_lift(*end)) {
                if self.now.attached[end] {
                    let closed =
                        chain.pairs().iter().enumerate().any(|(number, pair)| {
                            self.now.closed[number] && self.is_seat(end, [pair.first, pair.second])
                        });
                    if !closed {
                        offer(first_fall(&force.map(|value| -value), stiffest * MARGIN, 1.0), Event::Leaves(end));
                    }
                } else {
                    let segment = self.segment_of(end);
                    let pull = tension(self.system, &self.series, segment);
                    offer(first_fall(&pull, stiffest * MARGIN, 1.0), Event::Returns(end));
                }
            }
        }
        first
    }

    fn segment_of(&self, end: usize) -> usize {
        if end == 0 { 0 } else { self.system.chain.last_segment() }
    }

    /// Energy in an end's segment \[J\].
    fn strain(&self, end: usize) -> f64 {
        let segment = self.segment_of(end);
        let longer = self.now.places[segment + 1] - self.now.places[segment];
        0.5 * self.system.chain.stiffnesses()[segment] * longer * longer
    }

    fn is_seat(&self, end: usize, [first, second]: [usize; 2]) -> bool {
        let segment = self.segment_of(end);
        first == segment && second == segment + 1
    }

    /// A prescribed force holds on to its end.
    fn may_lift(&self, end: usize) -> bool {
        end == 0 || self.system.chain.far_end() != FarEnd::Force
    }

    fn lift_at_once(&mut self) {
        for end in 0..2 {
            let segment = self.segment_of(end);
            if self.may_lift(end) && self.now.places[segment + 1] - self.now.places[segment] > MARGIN {
                self.now.attached[end] = false;
                self.book.lifts.push(Lift { is_end2: end == 1, time: self.now.time, back: None });
            }
        }
        // An end that begins loose is unstrained from the begin on.
        self.book.begin(self.system, &self.now);
    }

    fn happens(&mut self, event: Event) -> Result<(), GivenUp> {
        self.events += 1;
        if self.events > self.contact.most_events() {
            return Err(GivenUp::TooManyEvents);
        }
        match event {
            Event::Meets(number) => {
                let comes = self.gap(number) <= self.rest[number] + 2.0 * MARGIN;
                if !comes {
                    // Was pressed, came free without a sign of it, and is far: nothing meets.
                    self.pressed[number] = false;
                    return Ok(());
                }
                self.meets(&[number], false)
            }
            Event::Parts(number) => {
                if let Some((stiffness, _)) = &self.system.elastic {
                    self.now.closed[number] = false;
                    // What is still strained when nothing pushes any more is lost: what gives way does not pull.
                    let gap = self.gap(number);
                    self.book.gave(number, 0.0, 0.5 * stiffness * gap * gap);
                    self.book.parted(number, self.now.time);
                }
                self.let_go(Some(number))
            }
            Event::Leaves(end) => {
                self.now.attached[end] = false;
                // A loose end is unstrained at once: it has no mass.
                self.book.damped(self.strain(end));
                self.book.lifts.push(Lift { is_end2: end == 1, time: self.now.time, back: None });
                self.let_go(None)
            }
            Event::Returns(end) => {
                self.now.attached[end] = true;
                self.book.damped(-self.strain(end));
                let time = self.now.time;
                let left = self.book.lifts.iter_mut().rev().find(|lift| lift.is_end2 == (end == 1));
                left.into_iter().for_each(|lift| lift.back = Some(time));
                self.let_go(None)
            }
        }
    }

    fn meets(&mut self, meeting: &[usize], is_jump: bool) -> Result<(), GivenUp> {
        collide(self.system, self.contact.law(), &mut self.now, meeting, &mut self.book).map_err(solid)?;
        if let Some((stiffness, _)) = &self.system.elastic {
            for &number in meeting {
                // What it holds at once: left there when nothing pushed any more, or put in by an end that jumped.
                let gap = self.gap(number);
                let held = 0.5 * stiffness * gap * gap;
                if is_jump { self.book.put_in(held) } else { self.book.gave(number, 0.0, -held) }
            }
        }
        self.let_go(None)
    }

    /// Lets go what would have to be pulled.
    fn let_go(&mut self, freed: Option<usize>) -> Result<(), GivenUp> {
        self.step = self.nominal();
        settle(self.system, &mut self.series, &mut self.now, self.step, freed, &mut self.book).map_err(solid)?;
        for number in 0..self.rest.len() {
            let gap = self.gap(number);
            self.rest[number] = gap.min(0.0);
            self.pressed[number] = self.system.elastic.is_some() && !self.now.closed[number] && gap < 0.0;
        }
        Ok(())
    }

    /// An input changes: an end may jump, or its speed.
    fn pass_knot(&mut self) -> Result<(), GivenUp> {
        let chain = self.system.chain;
        let last = chain.lumps() + 1;
        let before = [self.now.places[0], self.now.places[last]];
        let force = |run: &Self, time: f64| run.system.drives[1].series(time, 1.0)[0];
        let old_force = if chain.is_open() { value(&self.series.force, 1.0) } else { 0.0 };
        let energy_before = energy(self.system, &self.now);
        self.drive_ends();
        let first = self.now.places[0] - before[0];
        let second = if chain.is_open() {
            first + (force(self, self.now.time) - old_force) / chain.stiffness()
        } else {
            self.now.places[last] - before[1]
        };
        let small = 1e-15 * (before[0].abs() + before[1].abs() + 1e-3);
        if !self.system.damper.is_none() && (first.abs() > small || second.abs() > small) {
            let relative: Vec<f64> = chain.shares().iter().map(|share| -(first + share * (second - first))).collect();
            let relative: Vec<f64> = relative
                .iter()
                .enumerate()
                .map(|(point, jump)| if point == 0 || point == last { 0.0 } else { *jump })
                .collect();
            let mut impulses = vec![0.0; chain.lumps()];
            self.system.brake(self.now.attached, &relative, &mut impulses);
            for ((speed, impulse), inverse) in
                self.now.speeds[1..].iter_mut().zip(impulses).zip(&chain.inverse_masses()[1..])
            {
                *speed += impulse * inverse;
            }
        }
        self.book.put_in(energy(self.system, &self.now) - energy_before);
        let hard = self.system.elastic.is_none();
        let overlaps = (0..self.rest.len()).any(|number| self.gap(number) < -1e-9);
        if hard && overlaps {
            return Err(GivenUp::Solid);
        }
        let jumps = first.abs() > small || second.abs() > small;
        let meets = |run: &mut Self, number: usize| {
            let is_open = !run.now.closed[number] && run.gap(number) <= 0.0;
            is_open && (jumps && !hard || !run.pressed[number] && run.closes(number))
        };
        let meeting: Vec<usize> = (0..self.rest.len()).filter(|&number| meets(self, number)).collect();
        let held = hard && self.now.closed.iter().any(|closed| *closed);
        if held || !meeting.is_empty() { self.meets(&meeting, true) } else { Ok(()) }
    }

    /// Samples of the step before τ, and of all of it the one at which it begins.
    fn write_down(&mut self, tau: f64) {
        let (begin, step) = (self.now.time, self.series.step);
        let end = begin + tau * step;
        let from = self.input.len();
        let to = from + self.times[from..].partition_point(|time| *time < end || *time <= begin);
        if from == to {
            return;
        }
        let chain = self.system.chain;
        let [input, output] = end_forces(self.system, &self.now, &self.series);
        let lumps = chain.lumps();
        let (end2, beyond): (Polynomial, f64) = match chain.far_end() {
            FarEnd::Position => (self.series.place(lumps + 1), 0.0),
            FarEnd::Mass(_) => (self.series.place(lumps), 0.0),
            FarEnd::Force => (self.series.place(lumps), chain.beyond()),
        };
        let mut row = vec![0.0; lumps + 2];
        for &time in &self.times[from..to] {
            let at = ((time - begin) / step).clamp(0.0, tau);
            self.input.push(value(&input, at));
            self.output.push(value(&output, at));
            self.end2.push(value(&end2, at) + beyond * value(&self.series.force, at));
            if self.watch == Watch::Places {
                self.series.places_at(at, &mut row);
                self.places.extend_from_slice(&row[1..=lumps]);
            }
        }
    }

    fn finish(self, given_up: Option<GivenUp>) -> Course {
        let balance = self.book.closed(self.system, &self.now);
        Course {
            input: self.input,
            output: self.output,
            end2: self.end2,
            places: self.places,
            touches: self.book.touches,
            lifts: self.book.lifts,
            balance,
            until: self.now.time,
            given_up,
            events: self.events,
            deepest: self.deepest,
        }
    }
}

fn solid(_: Solid) -> GivenUp {
    GivenUp::Solid
}

/// What pulls a pressed pair, K g + C ġ \[N\]: it meets again where that falls below zero.
fn pull(gap: &Polynomial, stiffness: f64, dashpot: f64, step: f64) -> Polynomial {
    let mut pull = gap.map(|value| stiffness * value);
    for order in 0..gap.len() - 1 {
        pull[order] += dashpot * (order + 1) as f64 * gap[order + 1] / step;
    }
    pull
}
