//! What happens between steps: points meet and part, ends leave their seats and come back.
//!
//! Next door: the run (`run`), what points that meet give each other (`meet`).

use super::book::tension;
use super::course::{GivenUp, Lift};
use super::meet::{MARGIN, Solid, collide, settle};
use super::polynomial::{Polynomial, first_fall};
use super::run::Run;
use crate::mount::FarEnd;

/// What comes next.
#[derive(Debug, Clone, Copy)]
pub(super) enum Event {
    Meets(usize),
    Parts(usize),
    Leaves(usize),
    Returns(usize),
}

impl Run<'_> {
    /// The first that happens within the step.
    pub(super) fn first_event(&mut self) -> Option<(f64, Event)> {
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
            for end in (0..2).filter(|end| self.may_lift(*end)) {
                if self.now.attached[end] {
                    let closed =
                        chain.pairs().iter().enumerate().any(|(number, pair)| {
                            self.now.closed[number] && self.is_seat(end, [pair.first, pair.second])
                        });
                    if !closed {
                        // Of its own segment: points of a turn that rolls on the seat may press on it all the while.
                        let pull = tension(self.system, &self.series, self.segment_of(end));
                        offer(first_fall(&pull.map(|value| -value), stiffest * MARGIN, 1.0), Event::Leaves(end));
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

    /// Whether a pair that touches comes nearer, or would if nothing held it.
    pub(super) fn closes(&mut self, number: usize) -> bool {
        let pair = self.system.chain.pairs()[number];
        let speed = self.now.speeds[pair.second] - self.now.speeds[pair.first];
        speed < 0.0 || speed == 0.0 && self.series.opening(self.system, &self.now, 1e-6)[number] < 0.0
    }

    pub(super) fn segment_of(&self, end: usize) -> usize {
        if end == 0 { self.system.chain.base() } else { self.system.chain.last_segment() }
    }

    /// Energy in an end's segment \[J\].
    pub(super) fn strain(&self, end: usize) -> f64 {
        let segment = self.segment_of(end);
        let longer = self.now.places[segment + 1] - self.now.places[segment];
        0.5 * self.system.chain.stiffnesses()[segment] * longer * longer
    }

    pub(super) fn is_seat(&self, end: usize, [first, second]: [usize; 2]) -> bool {
        let segment = self.segment_of(end);
        first == segment && second == segment + 1
    }

    /// A prescribed force holds on to its end.
    pub(super) fn may_lift(&self, end: usize) -> bool {
        end == 0 || self.system.chain.far_end() != FarEnd::Force
    }

    pub(super) fn lift_at_once(&mut self) {
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

    pub(super) fn happens(&mut self, event: Event) -> Result<(), GivenUp> {
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

    pub(super) fn meets(&mut self, meeting: &[usize], is_jump: bool) -> Result<(), GivenUp> {
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
    pub(super) fn let_go(&mut self, freed: Option<usize>) -> Result<(), GivenUp> {
        self.step = self.nominal();
        settle(self.system, &mut self.series, &mut self.now, self.step, freed, &mut self.book).map_err(solid)?;
        for number in 0..self.rest.len() {
            let gap = self.gap(number);
            self.rest[number] = gap.min(0.0);
            self.pressed[number] = self.system.elastic.is_some() && !self.now.closed[number] && gap < 0.0;
        }
        Ok(())
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
