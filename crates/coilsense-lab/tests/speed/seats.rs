//! End turns whose seats are left out.

use coilsense_lab::report::speed_columns;
use coilsense_lab::speed::{SpeedMap, answer};

use super::{CAM, map, text};

#[test]
fn pushes_that_no_spring_has_are_not_to_be_trusted_and_said_first() {
    let text = text("0.01", "follower_mass = \"80 g\"", "restitution = 0.0", CAM);
    let text = text.replace("masses_per_winding = 1", "masses_per_winding = 5");
    let without_seats = text.replace("\n[contact]\n", "\n[contact]\nends = false\n");
    assert!(text.contains("masses_per_winding = 5") && text != without_seats);
    let fast = map(&without_seats, 7500.0, 8000.0);
    let spring = &fast.spec.spring.spring;
    // 57 mm long, and solid with 5.75 active and two end windings of 4 mm, ground: 31 mm.
    let solid = spring.stiffness() * (57e-3 - 31e-3);
    let push = |map: &SpeedMap| map.points.iter().map(|point| -point.input[0].min(point.output[0])).fold(0.0, f64::max);
    assert!(push(&fast) > 1.02 * solid, "{} N, solid at {solid} N", push(&fast));
    let first = answer(&fast).remove(0);
    assert!(first.starts_with("Not to be trusted ") && first.contains("pass through their seats"), "{first}");
    // With seats, which are there unless a spec leaves them out, no push is beyond it; at low speeds nothing is near, and seats that are left out are not said to be clear.
    let seated = map(&text, 7500.0, 8000.0);
    assert!(push(&seated) <= 1.02 * solid, "{} N, solid at {solid} N", push(&seated));
    let slow = map(&without_seats, 1500.0, 2000.0);
    // What was not looked at is no zero: not in a table, nor in JSON.
    for (map, looked) in [(&fast, false), (&seated, true), (&slow, false)] {
        assert!(map.points.iter().all(|point| point.blow.is_some() == looked), "{looked}");
        let blows = &speed_columns(map, 0).into_iter().find(|(key, _)| *key == "blow_on_seat_n_s").unwrap().1;
        assert!(!blows.is_empty() && blows.iter().all(|blow| blow.is_nan() != looked), "{blows:?}");
    }
    assert!(seated.points.iter().any(|point| point.blow > Some(0.0)));
    for calm in [&seated, &slow] {
        assert!(!answer(calm).join("\n").contains("Not to be trusted"), "{:?}", answer(calm));
    }
    let words = answer(&slow).join("\n");
    assert!(words.contains("Windings stay clear of each other at all speeds run"), "{words}");
    let words = answer(&map(&text, 1500.0, 2000.0)).join("\n");
    assert!(words.contains("Windings stay clear of each other and of their seats at all speeds run"), "{words}");
}
