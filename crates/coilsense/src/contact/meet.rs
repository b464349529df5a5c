//! What happens at once: points that meet give each other impulses, and some of what touches is let go.
//!
//! Next door: when it happens (`follow`), which of the pairs push (`complementarity`).

use super::bonds::{Bonds, meet};
use super::book::Book;
use super::chain::Chain;
use super::complementarity::pushes;
use super::law::Law;
use super::series::{Now, Series, System};

/// Two points have met when they are this much nearer than where they touch \[m\]; the moment is then that of touching itself.
pub(super) const MARGIN: f64 = 1e-13;

/// Slower than this \[m/s\] nothing bounces: the distance by which a contact is found sets a smallest bounce of 1e-4 m/s. Nor does what lies on a shared point
/// part from it that slowly when others strike that: end turns would take turns without end to throw one another off a follower, ever more slowly.
const STICKS: f64 = 2e-3;

/// Slower than this share \[1\] of the fastest, what is held does not part at a blow: rounding alone is so fast.
const ROUNDING: f64 = 1e-12;

/// After so many blows at one instant what still comes together stays together.
const MOST_ROUNDS: usize = 50;

/// A stack that is solid between two ends.
pub(super) struct Solid;

/// Gives the impulses of pairs that come together, `meeting` among them, and lets go what they drive apart.
pub(super) fn collide(
    system: &System<'_>,
    law: Law,
    now: &mut Now,
    meeting: &[usize],
    book: &mut Book,
) -> Result<(), Solid> {
    let chain = system.chain;
    let Law::Hard { restitution } = law else {
        let opening = opening_speeds(chain, now);
        for &number in meeting {
            book.met(chain, number, now.time, -opening[number]);
            now.closed[number] = true;
        }
        return Ok(());
    };
    strike(system, restitution, now, meeting, book)?;
    // What touches without being held takes part where it now comes together: else three that meet would hit each other in turn without end.
    // One after the other, since a pair that opens and is driven back within one blow would give Newton's law energy.
    for round in 0.. {
        let opening = opening_speeds(chain, now);
        let largest = opening.iter().fold(0.0_f64, |most, speed| most.max(speed.abs()));
        let touches = |&number: &usize| {
            !now.closed[number] && now.gap(chain, number) <= MARGIN && opening[number] < -ROUNDING * largest
        };
        let next: Vec<usize> = (0..opening.len()).filter(touches).collect();
        if next.is_empty() {
            return Ok(());
        }
        let restitution = if round < MOST_ROUNDS { restitution } else { 0.0 };
        strike(system, restitution, now, &next, book)?;
    }
    Ok(())
}

/// How fast pairs open \[m/s\].
fn opening_speeds(chain: &Chain, now: &Now) -> Vec<f64> {
    chain.pairs().iter().map(|pair| now.speeds[pair.second] - now.speeds[pair.first]).collect()
}

/// One blow: `meeting` come together, and what is held together feels it.
///
/// Energy changes by Σ Λ (v⁺ + v⁻)/2, v⁺ = −e v⁻ of a pair that pushes: it never grows, whatever the e of each, as long as no v⁻ is above zero.
fn strike(
    system: &System<'_>,
    restitution: f64,
    now: &mut Now,
    meeting: &[usize],
    book: &mut Book,
) -> Result<(), Solid> {
    let chain = system.chain;
    let opening = opening_speeds(chain, now);
    let may: Vec<bool> = (0..opening.len()).map(|number| now.closed[number] || meeting.contains(&number)).collect();
    // A follower stays on its cam.
    let bounces = |number: usize| {
        restitution > 0.0 && chain.cam() != Some(number) && !now.closed[number] && opening[number] < -STICKS
    };
    let bouncing: Vec<bool> = (0..opening.len()).map(bounces).collect();
    let q: Vec<f64> = opening
        .iter()
        .zip(&bouncing)
        .map(|(speed, bounces)| speed * if *bounces { 1.0 + restitution } else { 1.0 })
        .collect();
    let found = pushes(chain, &may, &q).ok_or(Solid)?;
    for number in (0..opening.len()).filter(|&number| !now.closed[number] && found.pushing[number]) {
        book.met(chain, number, now.time, -opening[number]);
    }
    let before = now.speeds.clone();
    let inverse = chain.inverse_masses();
    let pushing = || chain.pairs().iter().enumerate().filter(|(number, _)| found.pushing[*number]);
    for (number, pair) in pushing() {
        now.speeds[pair.first] -= found.amounts[number] * inverse[pair.first];
        now.speeds[pair.second] += found.amounts[number] * inverse[pair.second];
    }
    for (number, pair) in pushing() {
        let impulse = found.amounts[number];
        let apart = |speeds: &[f64]| speeds[pair.second] - speeds[pair.first];
        book.gave(number, impulse, -0.5 * impulse * (apart(&before) + apart(&now.speeds)));
        // An end that does not give way puts in what is pushed at it.
        for (point, sign) in [(pair.first, -1.0), (pair.second, 1.0)] {
            if inverse[point] == 0.0 {
                book.put_in(-sign * impulse * before[point]);
            }
        }
    }
    let slow = ROUNDING * before.iter().fold(0.0_f64, |most, speed| most.max(speed.abs()));
    for number in (0..opening.len()).filter(|number| may[*number]) {
        let is_shared = !meeting.is_empty() && chain.shared() == Some(chain.pairs()[number].first);
        let parts_from = if is_shared { slow.max(STICKS) } else { slow };
        let is_held = now.closed[number] && found.opening[number] <= parts_from;
        let stays = if found.pushing[number] { !bouncing[number] } else { is_held };
        book.parted_unless(stays, number, now.time);
        now.closed[number] = stays;
    }
    let [lost, work] = even_out(chain, now);
    book.lost(lost);
    book.put_in(work);
    Ok(())
}

/// Lets go what would have to be pulled, and makes what is left ready for the next step. `freed` is not held again.
pub(super) fn settle(
    system: &System<'_>,
    series: &mut Series,
    now: &mut Now,
    step: f64,
    freed: Option<usize>,
    book: &mut Book,
) -> Result<(), Solid> {
    if system.elastic.is_some() {
        return Ok(());
    }
    if let Some(freed) = freed {
        now.closed[freed] = false;
        book.parted(freed, now.time);
    }
    if now.closed.iter().any(|closed| *closed) {
        let q = series.opening(system, now, step);
        let found = pushes(system.chain, &now.closed, &q).ok_or(Solid)?;
        for number in 0..q.len() {
            if now.closed[number] && !found.pushing[number] {
                now.closed[number] = false;
                book.parted(number, now.time);
            }
        }
    }
    now.bonds = Bonds::new(system.chain, &now.closed).ok_or(Solid)?;
    Ok(())
}

/// Points that are held together have one speed to the last digit: that of their common momentum, or of the end that they lie on. Energy that goes, and
/// work of the ends \[J\].
fn even_out(chain: &Chain, now: &mut Now) -> [f64; 2] {
    even_out_groups(chain, now, false)
}

/// The same of what lies on an end alone: it goes on as fast as that.
pub(super) fn go_along(chain: &Chain, now: &mut Now) {
    even_out_groups(chain, now, true);
}

fn even_out_groups(chain: &Chain, now: &mut Now, at_ends_only: bool) -> [f64; 2] {
    let inverse = chain.inverse_masses();
    let [mut lost, mut work] = [0.0; 2];
    for points in groups(chain, &now.closed) {
        let (mut momentum, mut mass) = (0.0, 0.0);
        for &point in points.iter().filter(|point| inverse[**point] > 0.0) {
            momentum += now.speeds[point] / inverse[point];
            mass += 1.0 / inverse[point];
        }
        let held = points.iter().find(|point| inverse[**point] == 0.0).copied();
        if at_ends_only && held.is_none() {
            continue;
        }
        let speed = held.map_or(momentum / mass, |point| now.speeds[point]);
        for point in points {
            if inverse[point] > 0.0 {
                let faster = speed - now.speeds[point];
                lost += 0.5 * faster * faster / inverse[point];
                work += if held.is_some() { faster * speed / inverse[point] } else { 0.0 };
            }
            now.speeds[point] = speed;
        }
    }
    [lost, work]
}

/// Points that closed pairs hold together, each once.
fn groups(chain: &Chain, closed: &[bool]) -> Vec<Vec<usize>> {
    let pairs = chain.pairs();
    let mut groups: Vec<Vec<usize>> = Vec::new();
    for number in (0..pairs.len()).filter(|number| closed[*number]) {
        let follows = number > 0 && closed[number - 1] && meet(pairs, number - 1);
        match groups.last_mut().filter(|_| follows) {
            Some(group) => group.push(pairs[number].second),
            None => groups.push(vec![pairs[number].first, pairs[number].second]),
        }
    }
    if let Some(shared) = chain.shared() {
        let (of_it, mut others): (Vec<_>, Vec<_>) = groups.into_iter().partition(|group| group.contains(&shared));
        let mut together = of_it.concat();
        together.sort_unstable();
        together.dedup();
        if !together.is_empty() {
            others.push(together);
        }
        return others;
    }
    groups
}
