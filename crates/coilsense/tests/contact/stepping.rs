//! A second formulation that shares no code with the first: small steps, and impulses where the next places would overlap (Moreau's scheme,
//! velocities half a step apart, Gauss and Seidel's iteration). It converges to the events at first order.

use coilsense::contact::Contact;

use super::reference::valve;

const LUMPS: usize = 6;
const STIFFNESS: f64 = 29028.0;
const MASS: f64 = 44.549e-3;

/// F_o every 10 µs up to 0.12 s, of the valve spring under its cam, windings that stay together.
fn stepped(step: f64) -> Vec<f64> {
    let (mass, stiffness) = (MASS / LUMPS as f64, STIFFNESS * LUMPS as f64);
    let gap = (0.048 - 0.031) / LUMPS as f64;
    let (mut x, mut v) = ([0.0; LUMPS], [0.0; LUMPS]);
    let every = (1e-5 / step).round() as usize;
    let mut forces = Vec::new();
    for count in 0..12_000 * every {
        let time = count as f64 * step;
        if count % every == 0 {
            forces.push(-2.0 * stiffness * x[LUMPS - 1]);
        }
        let turn = (time / 0.02 - 0.25).rem_euclid(1.0) / (130.0 / 360.0);
        let cam = if turn < 1.0 && time > 0.005 { 0.01 * 64.0 * (turn * (1.0 - turn)).powi(3) } else { 0.0 };
        let mut before = 2.0 * stiffness * (x[0] - cam);
        for lump in 0..LUMPS {
            let after = if lump + 1 < LUMPS { stiffness * (x[lump + 1] - x[lump]) } else { -2.0 * stiffness * x[lump] };
            v[lump] += step * (after - before) / mass;
            before = after;
        }
        let near = |pair: usize, x: &[f64; LUMPS], v: &[f64; LUMPS]| {
            x[pair + 1] - x[pair] + gap + step * (v[pair + 1] - v[pair]) < 0.0
        };
        let meets: Vec<usize> = (0..LUMPS - 1).filter(|&pair| near(pair, &x, &v)).collect();
        let mut impulses = [0.0; LUMPS - 1];
        for _ in 0..if meets.is_empty() { 0 } else { 200 } {
            for &pair in &meets {
                let next: f64 = (impulses[pair] - 0.5 * mass * (v[pair + 1] - v[pair])).max(0.0);
                let more = next - impulses[pair];
                impulses[pair] = next;
                v[pair] -= more / mass;
                v[pair + 1] += more / mass;
            }
        }
        x.iter_mut().zip(v).for_each(|(x, v)| *x += step * v);
    }
    forces
}

#[test]
fn small_steps_converge_to_the_events_at_first_order() {
    let exact = valve(&Contact::default(), LUMPS, 0.12, 100_000.0);
    let apart = |step: f64| {
        let stepped = stepped(step);
        let each = stepped.iter().zip(&exact.output).skip(8000).map(|(a, b)| (a - b) * (a - b));
        (each.sum::<f64>() / 4000.0).sqrt()
    };
    // The other program of this scheme has 4.06, 0.863, 0.410 and 0.248 N.
    let apart = [1e-5, 2e-6, 1e-6, 5e-7, 2e-7].map(apart);
    assert!(apart[0] < 8.0 && apart[4] < 0.2, "{apart:?}");
    let order = (apart[0] / apart[4]).ln() / 50.0_f64.ln();
    assert!((0.8..1.3).contains(&order), "{apart:?}: of order {order}");
}
