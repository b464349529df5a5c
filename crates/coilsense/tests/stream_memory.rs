//! The streaming forms need no memory that grows: counted by an allocator that counts.

mod paper_springs;

use std::alloc::System;

use coilsense::motion::Live;
use coilsense::{Damping, EndInput, Excitation, FarEnd, Motion, Mount, Start};
use stats_alloc::{INSTRUMENTED_SYSTEM, Region, StatsAlloc};

#[global_allocator]
static ALLOCATOR: &StatsAlloc<System> = &INSTRUMENTED_SYSTEM;

#[test]
fn a_hundred_thousand_steps_allocate_nothing() {
    let spring = paper_springs::s_t();
    let mount = Mount::new(FarEnd::Mass(0.1), Damping::Modal(0.005)).unwrap();
    // A mean length, a start and a sine: everything but a recording, which is itself memory.
    let excitation = Excitation::new(0.23, EndInput::harmonic(1e-3, 20.0, 0.0), EndInput::Held, Start::Rest).unwrap();
    let motion = Motion::mounted(&spring, &mount, &excitation).unwrap();
    let mut stream = motion.stream(1e-4).unwrap();
    let mut live = Live::new(&spring, &mount, 0.23, 1e-4).unwrap();
    // The first steps find their transitions.
    for sample in stream.by_ref().take(10) {
        live.advance([1e-4 * sample.time, 0.0]).unwrap();
    }
    let mut sum = 0.0;
    // The counter sees all threads, and the one that runs the tests may still be busy with itself: a step that allocates would show in
    // every tenth of the steps.
    let mut least = usize::MAX;
    for _ in 0..10 {
        let region = Region::new(ALLOCATOR);
        for sample in stream.by_ref().take(10_000) {
            sum += sample.output + live.advance([1e-3 * (40.0 * sample.time).sin(), 0.0]).unwrap().input;
        }
        least = least.min(region.change().bytes_allocated);
    }
    assert!(f64::is_finite(sum));
    assert_eq!(least, 0, "bytes allocated by 10 000 steps");
}

#[test]
fn a_clone_of_a_live_spring_costs_its_coordinates_and_rates() {
    let spring = paper_springs::s_t();
    let live = Live::new(&spring, &Mount::default(), 0.23, 1e-4).unwrap();
    // The other test's thread allocates as well: the least of ten.
    let least = (0..10).map(|_| {
        let region = Region::new(ALLOCATOR);
        let clones: Vec<Live> = (0..100).map(|_| live.clone()).collect();
        let bytes = region.change().bytes_allocated / clones.len();
        assert_eq!(clones[99].time(), 0.0);
        bytes
    });
    // 56 padded modes, two numbers each, to whole cache lines; and what stands in the struct.
    let allowed = 2 * 56 * 8 + size_of::<Live>() + 256;
    assert!(least.min().unwrap() <= allowed, "{allowed}");
}
