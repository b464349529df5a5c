//! Figures of an independent program of the same rod (a determinant's count, by bisection), to the digits that it printed; straight
//! finite elements of another formulation agree with it to 1e-5 to 9e-5.

use coilsense::helix::{Ends, Helix, Holding, Modes, Turning};

use crate::cases::{Case, car, frequencies, helix, knee, relative, s_a, s_t, standard, valve};

#[test]
fn the_standard_spring_has_its_ten_lowest_modes() {
    let printed = [393.416, 395.995, 462.770, 525.570, 863.618, 876.792, 913.567, 1037.253, 1310.433, 1364.330];
    let rod = standard();
    let helix = Helix::new(&rod, rod.parameters().rest_span, Turning::Held).unwrap();
    for (value, printed) in frequencies(&helix, Ends::clamped(), 10).iter().zip(printed) {
        // Half a unit of the last printed digit is 1.3e-6 of the lowest.
        assert!((value - printed).abs() < 5.01e-4, "{value} {printed}");
    }
    // Without shear, extension and rotary inertia.
    let printed = [393.995, 396.576, 463.981, 526.268, 865.544, 878.842, 915.890, 1038.718, 1313.531, 1367.504];
    let helix = Helix::new(&rod.thin(), rod.parameters().rest_span, Turning::Held).unwrap();
    for (value, printed) in frequencies(&helix, Ends::clamped(), 10).iter().zip(printed) {
        assert!((value - printed).abs() < 5.01e-4, "{value} {printed}");
    }
}

#[test]
fn the_standard_spring_with_a_free_end() {
    let printed = [73.554, 73.887, 230.712, 263.327, 380.749, 384.207, 681.011, 773.809];
    let rod = standard();
    let helix = Helix::new(&rod, rod.parameters().rest_span, Turning::Held).unwrap();
    let ends = Ends::new(Holding::clamped(), Holding::free());
    for (value, printed) in frequencies(&helix, ends, 8).iter().zip(printed) {
        assert!((value - printed).abs() < 5.01e-4, "{value} {printed}");
    }
}

/// Length \[m\] and its ten lowest frequencies \[Hz\], ends clamped.
type Row = (Case, f64, [f64; 10]);

fn rows() -> [Row; 7] {
    [
        (s_t(), 0.196, [42.189, 42.193, 54.005, 60.710, 87.206, 87.218, 107.973, 121.349, 136.663, 136.698]),
        (s_t(), 0.230, [44.112, 44.118, 54.079, 60.796, 90.125, 90.140, 108.119, 121.524, 139.340, 139.376]),
        (s_t(), 0.264, [45.513, 45.520, 54.151, 60.907, 92.385, 92.402, 108.263, 121.748, 141.648, 141.686]),
        (s_a(), 0.102, [121.540, 121.590, 167.077, 188.187, 272.106, 272.295, 333.737, 375.480, 450.691, 451.220]),
        (valve(), 0.043, [388.737, 440.328, 483.853, 504.559, 753.186, 791.115, 797.911, 895.051, 1052.405, 1141.168]),
        (car(), 0.2233, [50.736, 53.540, 54.651, 59.286, 98.077, 101.441, 104.928, 116.125, 140.419, 151.191]),
        (knee(), 0.105, [81.005, 81.033, 94.327, 106.051, 169.202, 169.288, 188.569, 211.919, 267.048, 267.288]),
    ]
}

#[test]
fn springs_under_load_have_their_ten_lowest_modes() {
    for (case, length, printed) in rows() {
        let found = frequencies(&helix(&case, length), Ends::clamped(), 10);
        for (value, printed) in found.iter().zip(printed) {
            // Half a unit of the last printed digit.
            assert!((value - printed).abs() < 5.01e-4, "{length} m: {value} {printed}");
        }
    }
}

#[test]
fn as_many_modes_lie_below_a_frequency_as_finite_elements_count() {
    let counts = |case: &Case, length: f64, at: [f64; 3]| {
        let modes = Modes::new(&helix(case, length), Ends::clamped()).unwrap();
        at.map(|frequency| modes.count_below(frequency).unwrap())
    };
    assert_eq!(counts(&s_t(), 0.230, [460.0, 697.0, 1142.0]), [31, 46, 89]);
    // Between the rows' sixth and seventh, ninth and tenth frequencies; the fifteenth lies below 1600 Hz.
    assert_eq!(counts(&valve(), 0.043, [795.0, 1100.0, 1600.0])[..2], [6, 9]);
}

#[test]
fn other_ends_give_other_lines() {
    let s_t = helix(&s_t(), 0.230);
    let hinge = |direction: f64| Holding::hinged(direction).unwrap();
    let lateral = |ends: Ends| frequencies(&s_t, ends, 2);
    let across = std::f64::consts::FRAC_PI_2;
    for (ends, printed) in [
        (Ends::pinned(), [40.29, 40.29]),
        (Ends::both(hinge(0.0)), [40.29, 44.12]),
        (Ends::new(hinge(0.0), hinge(across)), [42.10, 42.14]),
        (Ends::new(Holding::clamped(), Holding::pinned()), [42.11, 42.13]),
    ] {
        for (value, printed) in lateral(ends).iter().zip(printed) {
            // Printed to 0.01 Hz.
            assert!((value - printed).abs() < 0.0101, "{value} {printed}");
        }
    }
}

#[test]
fn print_ends() {
    for (name, case, length) in [
        ("S_T", s_t(), 0.23),
        ("S_A", s_a(), 0.102),
        ("valve", valve(), 0.043),
        ("car", car(), 0.2233),
        ("knee", knee(), 0.105),
        ("car", car(), 0.1533),
        ("car", car(), 0.2933),
    ] {
        let h = helix(&case, length);
        println!("{name} pinned {:.3?}", frequencies(&h, Ends::pinned(), 4));
        println!("{name} clamped {:.3?}", frequencies(&h, Ends::clamped(), 4));
        let free = Helix::new(h.rod(), h.span(), Turning::Free).unwrap();
        println!(
            "{name} swivel {:.3?} k {} turn {} {}",
            frequencies(&free, Ends::swivel(), 6),
            free.stiffness() / h.stiffness(),
            free.turn() / 6.283185307,
            h.stiffness()
        );
    }
    let v = Modes::new(&helix(&valve(), 0.043), Ends::clamped()).unwrap();
    println!("{:?}", v.frequencies(17).unwrap());
    let h = helix(&s_t(), 0.23);
    let _ = relative(1.0, 1.0);
    let t = std::time::Instant::now();
    for _ in 0..100 {
        Modes::new(&h, Ends::clamped()).unwrap();
    }
    println!("new {:?}", t.elapsed() / 100);
    let m = Modes::new(&h, Ends::clamped()).unwrap();
    let t = std::time::Instant::now();
    for k in 0..1000 {
        std::hint::black_box(m.count_below(k as f64)).unwrap();
    }
    println!("count {:?}", t.elapsed() / 1000);
    let t = std::time::Instant::now();
    for _ in 0..10 {
        m.frequencies(10).unwrap();
    }
    println!("ten {:?}", t.elapsed() / 10);
}

#[test]
fn print_modes() {
    for (name, case, length) in [
        ("S_T", s_t(), 0.196),
        ("S_T", s_t(), 0.23),
        ("S_T", s_t(), 0.264),
        ("S_A", s_a(), 0.102),
        ("valve", valve(), 0.043),
        ("car", car(), 0.2233),
        ("knee", knee(), 0.105),
    ] {
        let h = helix(&case, length);
        let modes = Modes::new(&h, Ends::clamped()).unwrap();
        println!("{name} {length}");
        for i in 1..=10 {
            let m = modes.mode(i).unwrap();
            let s = m.shares();
            let n = (m.shape().len() - 1) as f64;
            let (mut a, mut b, mut c) = (0.0, 0.0, 0.0);
            for (k, w) in m.shape().iter().enumerate() {
                a += w[2] * k as f64 / n / n;
                b += (w[0] * w[0] + w[1] * w[1] + w[2] * w[2]) / n;
                c += w[2] * w[2] / n;
            }
            let om = (6.283185307 * m.frequency()).powi(2);
            println!(
                "   {:.5} {:.5} {:.5}",
                om * h.rod().mass() * a * a / b / 2.0 / h.stiffness(),
                om * h.rod().mass() * a * a / b / 2.0 / case.0.stiffness(),
                c / b
            );
            let r = m.reaction(coilsense::End::Two);
            println!(
                "{:9.3} {:10} {:.3} {:.3} {:.3} {:.3}  {:.5}  {:.4} {:.5} {:.5}",
                m.frequency(),
                format!("{:?}", m.kind()),
                s.axial,
                s.torsional,
                s.lateral,
                s.within,
                m.line_strength(),
                r.side_force(),
                1e3 * r.tilting_couple(),
                1e3 * r.axis_couple()
            );
        }
    }
    let m = Modes::new(&helix(&s_t(), 0.23), Ends::clamped()).unwrap();
    let t = std::time::Instant::now();
    m.mode(3).unwrap();
    println!("mode {:?}", t.elapsed());
}
