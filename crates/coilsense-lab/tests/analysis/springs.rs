//! Several springs between the same ends: what each does is what it does alone, and what all do is the sum.
//!
//! Negatives first: which springs are not taken together, and which commands take one.

use coilsense::Channel;
use coilsense_lab::analysis::{Analysis, Case, Together, simulate};
use coilsense_lab::spec::{Side, Spec};

/// A valve's outer spring, by values.
const OUTER: &str = r#"name = "outer"
rest_length = "57 mm"
min_length = "38 mm"
max_length = "48 mm"
windings = 6
coil_radius = "12.5 mm"
wire_radius = "2 mm"
stiffness = "29 kN/m"
mass = "44 g"
end_type = "closed-ground"
masses_per_winding = 2
"#;

/// The one within it, a step of 3 mm shorter.
const INNER: &str = r#"name = "inner"
length_at_mid = "40 mm"
rest_length = "50 mm"
min_length = "35 mm"
max_length = "45 mm"
windings = 7
coil_radius = "9 mm"
wire_radius = "1.5 mm"
stiffness = "14 kN/m"
mass = "21 g"
end_type = "closed-ground"
masses_per_winding = 2
"#;

const USED: &str = r#"
[mount]
damping_ratio = [0.0, 0.01]

[[condition]]
name = "shuts"
kind = "impact"
velocity = "0.5 m/s"
profile = "linear"
duration = "10 ms"
sample_rate = "20 kHz"

[[condition]]
name = "runs"
kind = "harmonic"
frequency = "90 Hz"
amplitude = "3 mm"
length = "43.5 mm"
duration = "10 ms"
sample_rate = "20 kHz"
"#;

fn springs(each: &[&str], used: &str) -> String {
    each.iter().map(|spring| format!("[[spring]]\n{spring}\n")).collect::<String>() + used
}

fn read(text: &str) -> Result<Spec, String> {
    Spec::parse("valve.toml", text, &|name| Err(format!("{name}: no files"))).map_err(|error| error.to_string())
}

fn together(text: &str) -> Together {
    Together::of(&read(text).unwrap(), &|_, _| true).unwrap()
}

fn alone(spring: &str, used: &str) -> Vec<Case> {
    let bare: String = spring
        .lines()
        .filter(|line| !line.starts_with("side") && !line.starts_with("length_at_mid"))
        .collect::<Vec<_>>()
        .join("\n");
    simulate(&read(&format!("[spring]\n{bare}\n{used}")).unwrap(), &|_, _| true).unwrap()
}

const FORCES: [Channel; 3] = [Channel::InputForce, Channel::OutputForce, Channel::DeflectionForce];

/// The largest difference of two series, and the largest value of the second.
fn apart(a: &[f64], b: impl Iterator<Item = f64>) -> (f64, f64) {
    a.iter().zip(b).fold((0.0, 0.0), |(apart, most): (f64, f64), (a, b)| (apart.max((a - b).abs()), most.max(b.abs())))
}

#[test]
fn what_is_not_taken_together_is_refused_at_its_line() {
    let refused = |text: &str| read(text).unwrap_err();
    let good = springs(&[OUTER, INNER], USED);
    let line = |needle: &str| 1 + good[..good.find(needle).unwrap()].matches('\n').count();

    let same = refused(&good.replace("name = \"inner\"", "name = \"Outer\""));
    assert_eq!(
        same,
        format!(
            "valve.toml:{}: name = \"Outer\": is that of another spring; give each its own",
            line("name = \"inner\"")
        )
    );

    let at = line("length_at_mid");
    let out = refused(&good.replace("\"40 mm\"", "\"41 mm\""));
    let why = "while \"outer\" is 38 mm to 48 mm long, \"inner\" is 36 mm to 46 mm; its own range in use must hold that, and is 35 mm to 45 mm";
    assert_eq!(out, format!("valve.toml:{at}: length_at_mid = \"41 mm\": {why}"));
    // Without the key it is as long as the first, which its range does not hold.
    let left_out = refused(&good.replace("length_at_mid = \"40 mm\"\n", ""));
    assert!(left_out.contains("[[spring]] 2 length_at_mid: while \"outer\""), "{left_out}");
    let negative = refused(&good.replace("\"40 mm\"", "\"-40 mm\""));
    assert!(negative.contains("length_at_mid = \"-40 mm\": must be above zero"), "{negative}");

    for (mount, why) in [
        ("end2 = \"force\"", "take [mount] end2 = \"held\""),
        ("end2 = \"mass\"\nend_mass = \"1 kg\"", "take [mount] end2 = \"held\""),
    ] {
        let message = refused(&good.replace("[mount]", &format!("[mount]\n{mount}")));
        assert!(message.contains(why) && message.contains("[[spring]] 2: several springs"), "{message}");
    }
    let follower = refused(&format!("{}\n[contact]\n", good.replace("[mount]", "[mount]\nfollower_mass = \"80 g\"")));
    assert!(follower.contains("take no follower_mass"), "{follower}");
    let helix = refused(
        &good.replace("length_at_mid", "model = \"helix\"\nlength_at_mid").replace("masses_per_winding = 2\n", ""),
    );
    assert!(helix.contains("model = \"helix\": of several springs must be \"coil\" or \"chain\""), "{helix}");
    let sensor = refused(&format!("{good}\n[[sensor]]\nkind = \"load-cell\"\nend = 2\n"));
    assert!(sensor.contains("[[sensor]] 1: several springs take no sensors"), "{sensor}");
    // The keys of a spring beside the first are no keys of the first, nor of one that stands alone.
    let first = refused(&good.replacen("rest_length", "side = \"same\"\nrest_length", 1));
    assert!(first.starts_with("valve.toml:3: unknown key \"side\" in [[spring]] 1"), "{first}");
    let single = refused(&format!("[spring]\nside = \"same\"\n{OUTER}{USED}"));
    assert!(single.starts_with("valve.toml:2: unknown key \"side\" in [spring]"), "{single}");
    // A spring that is wrong by itself is refused as one.
    let wrong = refused(&good.replace("\"21 g\"", "\"-21 g\""));
    assert!(wrong.contains("mass = \"-21 g\": mass must be above zero"), "{wrong}");
    assert!(refused("spring = []\n").contains("the table [spring] is missing"));
}

#[test]
fn what_takes_one_spring_says_so() {
    let spec = read(&springs(&[OUTER, INNER], USED)).unwrap();
    let message = "valve.toml: [[spring]] \"inner\": analyze takes one spring; several between the same ends are for simulate and sweep";
    assert_eq!(Analysis::run(spec.clone(), &|_, _| true).unwrap_err().to_string(), message);
    assert!(simulate(&spec, &|_, _| true).unwrap_err().to_string().contains("takes one spring"));
    assert!(spec.needs_chain("placement").unwrap_err().to_string().contains("placement takes one spring"));
    // A single table of several is one spring.
    let one = read(&springs(&[OUTER], USED)).unwrap();
    assert!(one.beside.is_empty());
    assert_eq!(one.spring, read(&format!("[spring]\n{OUTER}{USED}")).unwrap().spring);
}

#[test]
fn two_alike_are_one_of_twice_the_rate_and_mass() {
    let twin = OUTER.replace("\"outer\"", "\"twin\"");
    let two = together(&springs(&[OUTER, &twin], USED));
    let one = alone(&OUTER.replace("29 kN/m", "58 kN/m").replace("44 g", "88 g"), USED);
    for (all, case) in two.all.iter().zip(&one) {
        for force in FORCES {
            let (apart, most) =
                apart(all.channel(force).unwrap(), case.signals.channel(force).unwrap().iter().copied());
            assert!(apart <= 1e-9 * most, "{force:?}: {apart} of {most}");
        }
    }
}

#[test]
fn each_moves_as_it_does_alone_and_all_is_the_sum() {
    let both = together(&springs(&[OUTER, INNER], USED));
    // The inner spring is 3 mm shorter than the outer at any time.
    let inner = USED.replace("43.5 mm", "40.5 mm");
    let each = [alone(OUTER, USED), alone(INNER, &inner)];
    assert_eq!(both.all.len(), 4);
    for (number, all) in both.all.iter().enumerate() {
        for force in FORCES {
            let [outer, inner] = [0, 1].map(|spring| each[spring][number].signals.channel(force).unwrap());
            for (strand, alone) in both.springs.iter().zip([outer, inner]) {
                let own = strand.cases[number].signals.channel(force).unwrap();
                let (apart, most) = apart(own, alone.iter().copied());
                assert!(apart <= 1e-12 * most, "{} {force:?}: {apart} of {most}", strand.spec.spring.name);
            }
            let (apart, most) = apart(all.channel(force).unwrap(), outer.iter().zip(inner).map(|(a, b)| a + b));
            assert!(apart <= 1e-12 * most, "{force:?}: {apart} of {most}");
        }
        // The ends are where the first has them.
        assert_eq!(all.channel(Channel::U2).unwrap(), each[0][number].signals.channel(Channel::U2).unwrap());
    }
}

#[test]
fn one_that_pulls_the_other_way_is_moved_and_struck_the_other_way() {
    // Pretensioned by 11 mm at mid as the first is by 14: then 3 mm of it each.
    let other = OUTER
        .replace("\"outer\"", "\"return\"\nside = \"opposite\"\nlength_at_mid = \"46 mm\"")
        .replace("max_length = \"48 mm\"", "max_length = \"52 mm\"");
    let both = together(&springs(&[OUTER, &other], USED));
    assert_eq!(both.springs[1].side, Side::Opposite);
    // The same spring alone, under what it undergoes written by hand: as far from 46 mm as the first is from 43 mm, the other way.
    let by_hand = USED
        .replace("0.5 m/s\"", "-0.5 m/s\"\nlength = \"46 mm\"")
        .replace("\"3 mm\"", "\"-3 mm\"")
        .replace("43.5 mm", "45.5 mm");
    let other_alone = alone(&other.replace("side = \"opposite\"\n", ""), &by_hand);
    let first_alone = alone(OUTER, USED);
    for (number, all) in both.all.iter().enumerate() {
        for force in FORCES {
            let [first, other] =
                [&first_alone, &other_alone].map(|cases| cases[number].signals.channel(force).unwrap());
            let (apart, most) = apart(all.channel(force).unwrap(), first.iter().zip(other).map(|(a, b)| a - b));
            assert!(apart <= 1e-9 * most.max(1.0), "{number} {force:?}: {apart} of {most}");
        }
    }
    // At rest at mid: k (43 − 57 mm) − k (46 − 57 mm).
    let still = both.all[0].channel(Channel::DeflectionForce).unwrap()[0];
    assert!((still - 29e3 * -3e-3).abs() < 1e-9, "{still}");
    // Both get stiffer together: the force of all moves by twice the rate.
    let runs = &both.all[2];
    let (stretch, force) = (runs.channel(Channel::U1).unwrap(), runs.channel(Channel::DeflectionForce).unwrap());
    let slope = (force[50] - force[0]) / (stretch[0] - stretch[50]);
    assert!((slope / 58e3 - 1.0).abs() < 1e-9, "{slope}");
}

#[test]
fn a_pair_balanced_against_each_other_puts_no_force_on_ends_that_stand() {
    let other = OUTER.replace("\"outer\"", "\"return\"\nside = \"opposite\"");
    let both = together(&springs(&[OUTER, &other], USED));
    let still = both.all[0].channel(Channel::DeflectionForce).unwrap();
    assert!(still.iter().all(|force| force.abs() < 1e-10), "{still:?}");
    // Yet the blow rings in both, and does not cancel: windings that move on push one spring and pull the other.
    let [input, alone] =
        [&both.all[0], &both.springs[0].cases[0].signals].map(|s| s.channel(Channel::InputForce).unwrap());
    let least = alone.iter().copied().fold(f64::INFINITY, f64::min) - alone[0];
    let sum = input.iter().copied().fold(f64::INFINITY, f64::min);
    assert!((sum / (2.0 * least) - 1.0).abs() < 0.2, "{sum} {least}");
}

#[test]
fn windings_of_each_meet_as_they_do_alone() {
    let hard = USED.replace("0.5 m/s", "15 m/s") + "\n[contact]\nrestitution = 0\n";
    let both = together(&springs(&[OUTER, INNER], &hard));
    let inner = alone(INNER, &hard.replace("43.5 mm", "40.5 mm"));
    let contacts =
        |case: &Case| case.contacts.as_ref().map(|contacts| (contacts.first, contacts.touches.len())).unwrap();
    assert!(contacts(&both.springs[0].cases[0]).1 > 0 && contacts(&both.springs[1].cases[0]).1 > 0);
    for (case, alone) in both.springs[1].cases.iter().zip(&inner) {
        let ((first, count), (alone_first, alone_count)) = (contacts(case), contacts(alone));
        assert_eq!(count, alone_count);
        assert!(first.zip(alone_first).is_none_or(|(a, b)| (a - b).abs() < 1e-9), "{first:?} {alone_first:?}");
    }
}

#[test]
fn the_goal_is_a_share_of_the_force_of_all() {
    let goal = "\n[goal]\nerror = \"1 %\"\n";
    let spec = read(&springs(&[OUTER, INNER], &format!("{USED}{goal}"))).unwrap();
    // 29 kN/m (57 − 38 mm) and 14 kN/m (50 − 35 mm).
    let expected = 0.01 * (29e3 * 19e-3 + 14e3 * 15e-3);
    assert!((spec.goal.error.unwrap() / expected - 1.0).abs() < 1e-12, "{:?}", spec.goal.error);
}

#[test]
fn a_file_has_the_forces_of_all_and_then_those_of_each_by_name() {
    let both = together(&springs(&[OUTER, INNER], USED));
    let titles: Vec<String> =
        both.series(0).columns.iter().map(|column| format!("{} [{}]", column.name, column.unit)).collect();
    assert_eq!(titles[..6], ["time [s]", "u1 [m]", "u2 [m]", "F_i [N]", "F_o [N]", "F_x [N]"]);
    let of = |name: &str| {
        ["F_i", "F_o", "F_x", "F_L"]
            .map(|force| format!("{force} {name} [N]"))
            .into_iter()
            .chain([format!("L {name} [H]")])
            .collect::<Vec<_>>()
    };
    assert_eq!(titles[6..], [of("outer"), of("inner")].concat());
}
