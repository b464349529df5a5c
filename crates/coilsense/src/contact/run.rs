//! One run of a chain, step by step, and what it writes down.
//!
//! Next door: what happens between steps (`events`, `knots`), one step (`series`), energy and touches (`book`).

use super::bonds::Bonds;
use super::book::{Book, end_forces};
use super::complementarity::pushes;
use super::course::{Course, GivenUp};
use super::drive::Drive;
use super::law::Contact;
use super::meet::MARGIN;
use super::polynomial::{ORDER, Polynomial, side_by_side, value, values};
use super::series::{Now, Series, System};
use super::start::{Start, Watch};
use crate::error::{Error, check};
use crate::mount::FarEnd;

/// How far a step goes \[rad\] at the fastest that the chain or its drive can do: order 26 leaves out 1e-20 then.
const REACH: f64 = 2.0;

/// A chain on its way.
pub(super) struct Run<'a> {
    pub system: &'a System<'a>,
    pub contact: &'a Contact,
    pub times: &'a [f64],
    pub watch: Watch,
    pub now: Now,
    pub series: Series,
    pub book: Book,
    /// Of each open pair: how far it overlapped, by rounding, when it was let go \[m\].
    pub rest: Vec<f64>,
    /// Of each open elastic pair: whether it has not yet come back from being pressed.
    pub pressed: Vec<bool>,
    pub least: Vec<f64>,
    pub knots: Vec<f64>,
    pub input: Vec<f64>,
    pub output: Vec<f64>,
    pub end1: Vec<f64>,
    pub cam_force: Vec<f64>,
    pub end2: Vec<f64>,
    pub places: Vec<f64>,
    pub tensions: Vec<[f64; 2]>,
    pub events: usize,
    pub deepest: f64,
    /// How long a step may be as it stands \[s\].
    pub step: f64,
}

impl<'a> Run<'a> {
    pub(super) fn new(
        system: &'a System<'a>,
        contact: &'a Contact,
        start: &Start,
        times: &'a [f64],
        watch: Watch,
    ) -> Self {
        let chain = system.chain;
        let pairs = chain.pairs().len();
        let with_ends = |inner: &[f64]| std::iter::once(0.0).chain(inner.iter().copied()).chain([0.0]).collect();
        let now = Now {
            time: start.time,
            places: with_ends(&start.places),
            speeds: with_ends(&start.speeds),
            closed: vec![false; pairs],
            bonds: Bonds::default(),
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
            end1: Vec::with_capacity(samples),
            cam_force: Vec::new(),
            end2: Vec::with_capacity(samples),
            places: Vec::new(),
            tensions: Vec::new(),
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
    pub(super) fn drive_ends(&mut self) {
        let last = self.system.chain.lumps() + 1;
        let ends = if self.system.chain.is_open() { &[0][..] } else { &[0, last][..] };
        for (drive, &point) in self.system.drives.iter().zip(ends) {
            // The first two coefficients over a second are place and speed.
            let series = drive.series(self.now.time, 1.0);
            (self.now.places[point], self.now.speeds[point]) = (series[0], series[1]);
        }
    }

    pub(super) fn gap(&self, number: usize) -> f64 {
        self.now.gap(self.system.chain, number)
    }

    pub(super) fn check_start(&self) -> Result<(), Error> {
        for number in 0..self.rest.len() {
            let pair = self.system.chain.pairs()[number];
            let quantity = format!("distance of points {} and {} at the start", pair.first, pair.second);
            let may = self.gap(number) >= -MARGIN || self.system.elastic.is_some() && self.begins_closed(number);
            check(may, quantity, self.gap(number), "m", "not below zero: they overlap")?;
        }
        Ok(())
    }

    pub(super) fn follow(&mut self) -> Result<(), GivenUp> {
        if self.contact.lifts() {
            self.lift_at_once();
        }
        let until = self.times.last().copied().unwrap_or(self.now.time);
        if let Some(cam) = self.system.chain.cam().filter(|cam| self.begins_closed(*cam)) {
            // It stands on the cam, unless it would have to be pulled there by what stands on it.
            self.now.closed[cam] = true;
        }
        self.hold_what_rests()?;
        let touches = |run: &mut Self, number: usize| !run.now.closed[number] && run.gap(number) <= MARGIN;
        let touching: Vec<usize> =
            (0..self.rest.len()).filter(|&number| touches(self, number) && self.closes(number)).collect();
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
            let forces = end_forces(self.system, &self.now, &self.series);
            self.write_down(tau, &forces);
            let counted = self.watch.counts_energy().then_some(&forces);
            self.book.stepped(self.system, &self.now, &self.series, tau, counted);
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
        let forces = end_forces(self.system, &self.now, &self.series);
        self.write_down(f64::MIN_POSITIVE, &forces);
        Ok(())
    }

    /// Whether a pair touches and does not move against each other, or is pressed where windings give way.
    fn begins_closed(&self, number: usize) -> bool {
        let (pair, gap) = (self.system.chain.pairs()[number], self.gap(number));
        let is_pressed = self.system.elastic.is_some() && gap < 0.0;
        gap <= MARGIN && (is_pressed || self.now.speeds[pair.first] == self.now.speeds[pair.second])
    }

    /// Holds together what begins closed, as far as it pushes.
    fn hold_what_rests(&mut self) -> Result<(), GivenUp> {
        let rests: Vec<bool> =
            (0..self.rest.len()).map(|number| self.now.closed[number] || self.begins_closed(number)).collect();
        if rests == self.now.closed {
            return if rests.contains(&true) { self.let_go(None) } else { Ok(()) };
        }
        let pushing = if self.system.elastic.is_some() {
            rests
        } else {
            let opening = self.series.opening(self.system, &self.now, self.step);
            pushes(self.system.chain, &rests, &opening).ok_or(GivenUp::Solid)?.pushing
        };
        for number in (0..pushing.len()).filter(|number| pushing[*number]) {
            if !self.now.closed[number] {
                self.book.met(self.system.chain, number, self.now.time, 0.0);
                self.now.closed[number] = true;
                if let Some((stiffness, _)) = &self.system.elastic {
                    let gap = self.gap(number);
                    self.book.put_in(0.5 * stiffness * gap * gap);
                }
            }
        }
        self.let_go(None)
    }

    /// How long a step lasts \[s\].
    pub(super) fn nominal(&self) -> f64 {
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

    /// Samples of the step before τ, and of all of it the one at which it begins.
    pub(super) fn write_down(&mut self, tau: f64, [input, output]: &[Polynomial; 2]) {
        let (begin, step) = (self.now.time, self.series.step);
        let end = begin + tau * step;
        let from = self.input.len();
        let to = from + self.times[from..].partition_point(|time| *time < end || *time <= begin);
        if from == to {
            return;
        }
        let chain = self.system.chain;
        let lumps = chain.lumps();
        let (end2, beyond): (Polynomial, f64) = match chain.far_end() {
            FarEnd::Position => (self.series.place(lumps + 1), 0.0),
            FarEnd::Mass(_) => (self.series.place(lumps), 0.0),
            FarEnd::Force => (self.series.place(lumps), chain.beyond()),
        };
        let end1 = self.series.place(chain.base());
        let cam = chain.cam().map(|cam| if self.now.closed[cam] { self.series.push(cam) } else { [0.0; ORDER + 1] });
        let all = side_by_side([input, output, &end1, &end2]);
        let places = matches!(self.watch, Watch::Places | Watch::Tensions);
        let mut row = if places { vec![0.0; lumps + 2] } else { Vec::new() };
        for &time in &self.times[from..to] {
            let at = ((time - begin) / step).clamp(0.0, tau);
            let [input, output, end1, end2] = values(&all, at);
            self.input.push(input);
            self.output.push(output);
            self.end1.push(end1);
            self.cam_force.extend(cam.as_ref().map(|push| value(push, at)));
            let farther = if beyond == 0.0 { 0.0 } else { beyond * value(&self.series.force, at) };
            self.end2.push(end2 + farther);
            if places {
                self.series.places_at(at, &mut row);
            }
            match self.watch {
                Watch::Places => self.places.extend_from_slice(&row[1..=lumps]),
                Watch::Tensions => self.stretch(&row),
                Watch::Ends | Watch::Forces => {}
            }
        }
    }

    /// Widens the extremes of the segments' tensions to what they are with the points at `places`.
    fn stretch(&mut self, places: &[f64]) {
        let chain = self.system.chain;
        let (base, last) = (chain.base(), chain.last_segment());
        self.tensions.resize(last + 1 - base, [f64::INFINITY, f64::NEG_INFINITY]);
        for (segment, [least, largest]) in (base..=last).zip(&mut self.tensions) {
            let hangs_loose = segment == base && !self.now.attached[0] || segment == last && !self.now.attached[1];
            let stretch = if hangs_loose { 0.0 } else { places[segment + 1] - places[segment] };
            let tension = chain.stiffnesses()[segment] * stretch;
            (*least, *largest) = (least.min(tension), largest.max(tension));
        }
    }

    pub(super) fn finish(self, given_up: Option<GivenUp>) -> Course {
        let balance = self.book.closed(self.system, &self.now);
        Course {
            input: self.input,
            output: self.output,
            end1: self.end1,
            cam_force: self.cam_force,
            end2: self.end2,
            places: self.places,
            tensions: self.tensions,
            touches: self.book.touches,
            lifts: self.book.lifts,
            floats: self.book.floats,
            balance,
            until: self.now.time,
            given_up,
            events: self.events,
            deepest: self.deepest,
        }
    }
}
