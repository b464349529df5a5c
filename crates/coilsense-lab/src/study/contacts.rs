//! What windings did when they met, in the figures that people ask for.
//!
//! Next door: the run itself (`coilsense::contact`), one simulation (`simulation`).

use coilsense::Error;
use coilsense::contact::{Balance, Float, Lift, Touch, Touching};

/// Whether windings meet in this build: known when it is compiled, so that one without the feature does not carry what follows them.
pub const MEET: Result<(), Error> = if cfg!(feature = "contact") {
    Ok(())
} else {
    Err(Error::Value {
        field: None,
        quantity: std::borrow::Cow::Borrowed("feature \"contact\" of this build"),
        value: 0.0,
        unit: "",
        allowed: std::borrow::Cow::Borrowed("on where windings are to meet"),
    })
};

/// What met in a run, for how long the answer holds, and where the energy went.
#[derive(Debug, Clone, PartialEq)]
pub struct Contacts {
    /// When something first met, an end first left its seat or a follower its cam \[s\]; `None` where nothing did.
    pub first: Option<f64>,
    /// Everything that met, in the order in which it did; points are numbers of masses, 0 and one more than there are being the ends.
    pub touches: Vec<Touch>,
    /// The same by winding, from end 1 on; those that never met are left out.
    pub meetings: Vec<Meeting>,
    /// When ends left their seats, and when they were back.
    pub lifts: Vec<Lift>,
    /// When a follower left its cam, and when it came back; what comes down slower than [`GRAZES`] only grazes it.
    pub floats: Vec<Float>,
    /// The smallest force of the cam on a follower from the first event on \[N\]; `None` without one.
    pub least_cam_force: Option<f64>,
    /// Where energy came from and went \[J\].
    pub balance: Balance,
    /// How many times something met, parted, left or came back.
    pub events: usize,
    /// Up to when both end forces are within [`Self::apart`] of those under an input larger by a millionth \[s\]; `None` where nobody asked.
    pub holds_until: Option<f64>,
    /// That force \[N\].
    pub apart: f64,
    /// When the run ended \[s\].
    pub until: f64,
    /// Masses for a winding.
    pub masses_per_winding: usize,
    /// Points before the spring's end 1: one where that stands on a follower.
    base: usize,
    /// Masses in all.
    pub masses: usize,
}

/// What two neighbouring windings did, or a winding and its seat.
#[derive(Debug, Clone, PartialEq)]
pub struct Meeting {
    /// Which.
    pub between: Between,
    /// How often points of them met.
    pub count: usize,
    /// Share of the run during which they were together \[1\], the mean over their points.
    pub closed: f64,
    /// The largest closing speed \[m/s\].
    pub speed: f64,
    /// What they gave each other in no time, all of it \[N s\].
    pub impulse: f64,
    /// The largest such impulse \[N s\].
    pub largest_impulse: f64,
    /// Energy lost there \[J\].
    pub lost: f64,
}

/// Two neighbours.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Between {
    /// Seat 1 and the first winding.
    Seat1,
    /// A winding, from 1, and the next.
    Windings(usize),
    /// The last winding and seat 2.
    Seat2,
}

impl Between {
    /// Both seats.
    pub const SEATS: [Self; 2] = [Self::Seat1, Self::Seat2];

    /// `3|4`, `seat 1`.
    pub fn words(self) -> String {
        match self {
            Self::Seat1 => "seat 1".to_owned(),
            Self::Windings(first) => format!("{first}|{}", first + 1),
            Self::Seat2 => "seat 2".to_owned(),
        }
    }
}

/// A follower that comes down slower than this \[m/s\] has grazed its cam: where the cam's force just goes through zero, the rounding of a recorded
/// lift opens gaps of picometres.
pub const GRAZES: f64 = 2e-3;

fn is_aloft(float: &Float) -> bool {
    float.back.is_none() || float.closing_speed >= GRAZES
}

impl Contacts {
    /// Of a run up to `until` \[s\]; `apart` is the force \[N\] by which it is judged how long the run holds, where it was made twice.
    ///
    /// # Errors
    /// Those of [`Touching::holds_until`].
    pub(super) fn of(touching: &Touching, masses: [usize; 2], until: f64, apart: Option<f64>) -> Result<Self, Error> {
        let [in_all, per_winding] = masses;
        let course = touching.course.as_ref();
        let first = course.and_then(|course| {
            let touches = course.touches.iter().map(|touch| touch.time);
            let lifts = course.lifts.iter().map(|lift| lift.time);
            let floats = course.floats.iter().filter(|float| is_aloft(float)).map(|float| float.time);
            touches.chain(lifts).chain(floats).reduce(f64::min)
        });
        let mut contacts = Self {
            first,
            touches: touching.touches().to_vec(),
            meetings: Vec::new(),
            lifts: course.map_or_else(Vec::new, |course| course.lifts.clone()),
            floats: course.map_or_else(Vec::new, |course| course.floats.iter().copied().filter(is_aloft).collect()),
            least_cam_force: course.and_then(|course| course.cam_force.iter().copied().reduce(f64::min)),
            balance: course.map_or_else(Balance::default, |course| course.balance),
            events: course.map_or(0, |course| course.events),
            holds_until: apart.map(|apart| touching.holds_until(apart)).transpose()?,
            apart: apart.unwrap_or(0.0),
            until,
            masses_per_winding: per_winding,
            base: usize::from(course.is_some_and(|course| !course.cam_force.is_empty())),
            masses: in_all,
        };
        contacts.meetings = contacts.by_winding();
        Ok(contacts)
    }

    /// Points of the spring, of which end 1 is 0.
    fn points(&self, touch: &Touch) -> [usize; 2] {
        touch.points.map(|point| point - self.base)
    }

    /// How long a follower flew in all \[s\].
    pub fn floated(&self) -> f64 {
        self.floats.iter().map(|float| float.back.unwrap_or(self.until) - float.time).sum()
    }

    /// Which neighbours a touch is of.
    pub fn between(&self, touch: &Touch) -> Between {
        let [first, second] = self.points(touch);
        if first == 0 {
            Between::Seat1
        } else if second > self.masses {
            Between::Seat2
        } else {
            Between::Windings((first - 1) / self.masses_per_winding + 1)
        }
    }

    /// Where along the wire a touch is: turns from end 1 to the point nearer to it, or to the one that meets seat 1.
    pub fn turn(&self, touch: &Touch) -> f64 {
        let [first, second] = self.points(touch);
        let point = if first == 0 { second } else { first };
        (point as f64 - 0.5) / self.masses_per_winding as f64
    }

    /// What seat 1 and seat 2 got in an instant: when \[s\], and how much \[N s\].
    pub fn seat_impulses(&self, seat: Between) -> impl Iterator<Item = (f64, f64)> {
        let of_seat = move |touch: &&Touch| self.between(touch) == seat && touch.impulse > 0.0;
        self.touches.iter().filter(of_seat).map(|touch| (touch.time, touch.impulse))
    }

    fn by_winding(&self) -> Vec<Meeting> {
        let mut meetings: std::collections::BTreeMap<Between, Meeting> = std::collections::BTreeMap::new();
        for touch in &self.touches {
            let between = self.between(touch);
            let nothing = || Meeting {
                between,
                count: 0,
                closed: 0.0,
                speed: 0.0,
                impulse: 0.0,
                largest_impulse: 0.0,
                lost: 0.0,
            };
            let meeting = meetings.entry(between).or_insert_with(nothing);
            meeting.count += 1;
            meeting.closed += touch.parted.unwrap_or(self.until) - touch.time;
            meeting.speed = meeting.speed.max(touch.closing_speed);
            meeting.impulse += touch.impulse;
            meeting.largest_impulse = meeting.largest_impulse.max(touch.impulse);
            meeting.lost += touch.lost;
        }
        let points = self.masses_per_winding as f64;
        let share = |meeting: Meeting| Meeting {
            closed: meeting.closed / (self.until * points).max(f64::MIN_POSITIVE),
            ..meeting
        };
        meetings.into_values().map(share).collect()
    }
}
