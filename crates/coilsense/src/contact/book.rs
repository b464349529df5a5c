//! Keeps book while a chain is followed: what touches, for how long and how hard, and where the energy goes.
//!
//! Next door: who tells it (`follow`, `meet`), what is handed out (`course`).

use super::chain::Chain;
use super::course::{Balance, Float, Lift, Touch};
use super::polynomial::{ORDER, Polynomial, integral_of_product, value};
use super::series::{Now, Series, System};

/// What has happened so far.
pub(super) struct Book {
    pub touches: Vec<Touch>,
    pub lifts: Vec<Lift>,
    pub floats: Vec<Float>,
    pub balance: Balance,
    /// Of each pair the touch that goes on.
    going_on: Vec<Option<usize>>,
    begun: f64,
    /// The pair of cam and follower.
    cam: Option<usize>,
}

impl Book {
    pub fn new(system: &System<'_>, now: &Now) -> Self {
        let going_on = vec![None; system.chain.pairs().len()];
        let begun = energy(system, now);
        Self {
            touches: Vec::new(),
            lifts: Vec::new(),
            floats: Vec::new(),
            cam: system.chain.cam(),
            balance: Balance::default(),
            going_on,
            begun,
        }
    }

    /// Energy counts from here on.
    pub fn begin(&mut self, system: &System<'_>, now: &Now) {
        self.begun = energy(system, now);
    }

    /// Two points meet.
    pub fn met(&mut self, chain: &Chain, number: usize, time: f64, closing_speed: f64) {
        if self.cam == Some(number) {
            if let Some(float) = self.floats.last_mut().filter(|float| float.back.is_none()) {
                (float.back, float.closing_speed) = (Some(time), closing_speed);
            }
            return;
        }
        let pair = chain.pairs()[number];
        self.going_on[number] = Some(self.touches.len());
        let points = [pair.first, pair.second];
        self.touches.push(Touch {
            points,
            time,
            closing_speed,
            parted: None,
            impulse: 0.0,
            pressed: 0.0,
            peak: 0.0,
            lost: 0.0,
        });
    }

    /// They part.
    pub fn parted(&mut self, number: usize, time: f64) {
        if self.cam == Some(number) {
            self.floats.push(Float { time, back: None, closing_speed: 0.0, impulse: 0.0 });
        }
        if let Some(touch) = self.going_on[number].take() {
            self.touches[touch].parted = Some(time);
        }
    }

    /// They part, unless they stay.
    pub fn parted_unless(&mut self, stay: bool, number: usize, time: f64) {
        if !stay {
            self.parted(number, time);
        }
    }

    /// They give each other an impulse, which takes an energy.
    pub fn gave(&mut self, number: usize, impulse: f64, lost: f64) {
        self.balance.lost += lost;
        if self.cam == Some(number)
            && let Some(float) = self.floats.last_mut()
        {
            float.impulse += impulse;
        }
        if let Some(touch) = self.going_on[number] {
            self.touches[touch].impulse += impulse;
            self.touches[touch].lost += lost;
        }
    }

    /// Meeting takes this much at once, wherever.
    pub fn lost(&mut self, energy: f64) {
        self.balance.lost += energy;
    }

    /// The ends put in this much at once.
    pub fn put_in(&mut self, work: f64) {
        self.balance.work += work;
        self.balance.moved += work.abs();
    }

    /// Damping takes this much at once.
    pub fn damped(&mut self, energy: f64) {
        self.balance.damped += energy;
    }

    /// A step has gone to τ; what the ends put in and damping took is counted where their `forces` are told.
    pub fn stepped(
        &mut self,
        system: &System<'_>,
        now: &Now,
        series: &Series,
        tau: f64,
        forces: Option<&[Polynomial; 2]>,
    ) {
        let chain = system.chain;
        for (number, touch) in self.going_on.iter().enumerate() {
            let Some(touch) = touch.map(|touch| &mut self.touches[touch]) else { continue };
            let push = series.push(number);
            touch.pressed += series.step * integral(&push, tau);
            touch.peak = touch.peak.max(push[0]).max(value(&push, tau));
            if let Some((_, dashpots)) = system.elastic.as_ref().filter(|(_, dashpots)| dashpots[number] > 0.0) {
                let rate = rate_of(&series.gap(chain, number), series.step);
                let lost = series.step * dashpots[number] * integral_of(|at| value(&rate, at).powi(2), tau);
                touch.lost += lost;
                self.balance.lost += lost;
            }
        }
        let Some([input, output]) = forces else { return };
        let moved = |force: &Polynomial, place: &Polynomial| integral_of_product(force, &rate_of(place, 1.0), tau);
        let lumps = chain.lumps();
        let first = match chain.cam() {
            Some(cam) if now.closed[cam] => moved(&series.push(cam), &series.place(0)),
            Some(_) => 0.0,
            None => -moved(input, &series.place(0)),
        };
        let second = if chain.is_open() {
            moved(&series.force, &series.place(lumps))
        } else {
            moved(output, &series.place(lumps + 1))
        };
        self.balance.work += first + second;
        self.balance.moved += first.abs() + second.abs();
        if !system.damper.is_none() {
            let (mut forces, mut relative, mut speeds) = (vec![0.0; lumps], vec![0.0; lumps + 2], vec![0.0; lumps + 2]);
            let power = |at: f64| {
                forces.fill(0.0);
                series.relative_at(at, &mut relative);
                series.speeds_at(at, &mut speeds);
                let pulls = system.brake(now.attached, &relative, &mut forces);
                let of_lumps = forces.iter().zip(&speeds[1..]).map(|(force, speed)| -force * speed).sum::<f64>();
                // What a dashpot in an end's segment takes of the end's work.
                let second = if chain.is_open() { 0.0 } else { pulls[1] * speeds[lumps + 1] };
                let first = if chain.cam().is_some() { 0.0 } else { pulls[0] * speeds[0] };
                of_lumps - first + second
            };
            self.balance.damped += series.step * integral_of(power, tau);
        }
    }

    /// The balance now.
    pub fn closed(&self, system: &System<'_>, now: &Now) -> Balance {
        Balance { gained: energy(system, now) - self.begun, ..self.balance }
    }
}

/// F_i and F_o over a step \[N\].
pub(super) fn end_forces(system: &System<'_>, now: &Now, series: &Series) -> [Polynomial; 2] {
    let chain = system.chain;
    let last = chain.last_segment();
    let mut forces = [
        if now.attached[0] { tension(system, series, chain.base()) } else { [0.0; ORDER + 1] },
        match chain.far_end() {
            crate::mount::FarEnd::Force => series.force,
            _ if now.attached[1] => tension(system, series, last),
            _ => [0.0; ORDER + 1],
        },
    ];
    let seats = chain.pairs().iter().enumerate().filter(|(number, _)| now.closed[*number]);
    for (number, pair) in seats {
        for (end, force) in forces.iter_mut().enumerate() {
            let is_its = if end == 0 {
                pair.first == chain.base()
            } else {
                pair.second == last + 1 && chain.far_end() != crate::mount::FarEnd::Force
            };
            if is_its {
                force.iter_mut().zip(series.push(number)).for_each(|(force, push)| *force -= push);
            }
        }
    }
    forces
}

/// What a segment pulls with over a step \[N\], dashpot and all, if it hangs on its ends.
pub(super) fn tension(system: &System<'_>, series: &Series, segment: usize) -> Polynomial {
    let time = system.damper.dashpot_time();
    let stiffness = system.chain.stiffnesses()[segment];
    let mut tension = series.difference(segment, segment + 1);
    if time > 0.0 {
        let rates = [series.relative(segment), series.relative(segment + 1)];
        for (order, value) in tension.iter_mut().enumerate() {
            *value += time * (rates[1][order] - rates[0][order]);
        }
    }
    tension.map(|value| stiffness * value)
}

/// Moving and strained \[J\].
pub(super) fn energy(system: &System<'_>, now: &Now) -> f64 {
    let chain = system.chain;
    let moving: f64 = chain.masses().iter().zip(&now.speeds[1..]).map(|(mass, speed)| mass * speed * speed).sum();
    let loose = |segment: usize| {
        segment == chain.base() && !now.attached[0] || segment == chain.last_segment() && !now.attached[1]
    };
    let each = chain.stiffnesses().iter().zip(now.places.windows(2)).enumerate();
    let strained: f64 =
        each.filter(|(segment, _)| !loose(*segment)).map(|(_, (k, pair))| k * (pair[1] - pair[0]).powi(2)).sum();
    let pressed: f64 = system.elastic.as_ref().map_or(0.0, |(stiffness, _)| {
        let closed = chain.pairs().iter().zip(&now.closed).filter(|(_, closed)| **closed);
        closed.map(|(pair, _)| stiffness * (now.places[pair.second] - now.places[pair.first] + pair.gap).powi(2)).sum()
    });
    0.5 * (moving + strained + pressed)
}

/// dp/dt \[1/s\] where a step lasts `step`.
fn rate_of(p: &Polynomial, step: f64) -> Polynomial {
    let mut rate = [0.0; ORDER + 1];
    for order in 0..ORDER {
        rate[order] = (order + 1) as f64 * p[order + 1] / step;
    }
    rate
}

/// ∫ p dτ from zero.
fn integral(p: &Polynomial, tau: f64) -> f64 {
    p.iter().enumerate().rev().fold(0.0, |sum, (order, coefficient)| sum * tau + coefficient / (order + 1) as f64) * tau
}

/// The same of what is no polynomial of this order.
fn integral_of(f: impl FnMut(f64) -> f64, tau: f64) -> f64 {
    crate::quadrature::panel(0.0, tau, f)
}
