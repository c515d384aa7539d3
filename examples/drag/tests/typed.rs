//! Every number that we type in a reason, a reading or a mistake is computed in two ways, and is still in the text. The page
//! on the newest edition has its numbers from the code.

use geneva_evidence::{Check, Decimal};
use geneva_example_drag::{BOOK, LEDGER};
use std::f64::consts::PI;

const G: f64 = 9.80;

/// A claim, a phrase of ours on it, the number in it, and two ways to that.
type Typed = (&'static str, &'static str, &'static str, fn() -> [f64; 2]);

/// Claims, phrases of ours on them, and the number in each by two ways. A number that is said to few digits is rounded so.
const TYPED: &[Typed] = &[
    ("drag.spread-speed", "it would be 150 km/h", "150", || {
        let speed = (2.0 * 75.0 * G / (1.21 * 0.70_f64)).sqrt() * 3.6;
        // From the printed 44 m/s of a heavier one, the exact one of which is 44.35.
        [speed, 44.352 * (75.0 / 85.0_f64).sqrt() * 3600.0 / 1000.0]
    }),
    ("drag.squirrel-falls", "0.80 of its terminal speed", "0.80", || {
        let limit = (2.0 * 0.560 * G / (1.21 * 0.0930_f64)).sqrt();
        [(1.0 - (-2.0 * G * 5.0 / limit / limit).exp()).sqrt(), fallen(0.560, 1.21 * 0.0930 / 2.0, 5.0) / limit]
    }),
    ("drag.bacterium-speed", "from 0.05 μm/s", "0.05", || [slowest() * 1e6, slowest() / 1e-6]),
    ("drag.bacterium-speed", "to 2.4 μm/s", "2.4", || {
        let weight = 1100.0 * G * 4.0 / 3.0 * PI * 1e-18;
        [2.0 / 9.0 * 1100.0 * G * 1e-12 / 1e-3 * 1e6, weight / (6.0 * PI * 1e-3 * 1e-6) * 1e6]
    }),
    ("drag.dense", "about 100,000", "100,000", || [1000.0 * 0.1 / 1e-3, 0.1 / 1e-6]),
    ("drag.dense", "about 0.001 N", "0.001", || [6.0 * PI * 0.05 * 1e-3, 3.0 * PI * 0.1 / 1000.0]),
    ("drag.dense", "nearly 2 N", "2", || [0.45 * 1000.0 * PI * 0.0025 / 2.0, 0.45 * 500.0 * PI / 4.0 * 0.01]),
    ("drag.squirrel-speed", "9.88 m/s", "9.88", || {
        [(2.0 * 0.560 * G / (1.21 * 0.0930_f64)).sqrt(), fallen(0.560, 1.21 * 0.0930 / 2.0, 200.0)]
    }),
    ("drag.usual-scale", "4.470 m/s", "4.470", || [10.0 * 1609.344 / 3600.0, 10.0 * 0.447_04]),
    ("drag.usual-scale", "903 N", "903", || [75.0 * (G + 4.4704 / 2.0), 735.0 + 75.0 * 2.2352]),
    ("drag.string-tension", "199.5 N", "199.5", || {
        let [s, c] = [40.0_f64.to_radians().sin(), 40.0_f64.to_radians().cos()];
        [5.5 * G / (c * c / s - s), 5.5 * G * s / 80.0_f64.to_radians().cos()]
    }),
    ("drag.child", "33.7 N", "33.7", || [58.8 * 35.0_f64.to_radians().sin(), 58.8 * 55.0_f64.to_radians().cos()]),
    ("drag.child", "-0.006", "-0.006", || {
        let angle = 35.0_f64.to_radians();
        [angle.tan() - 34.0 / (58.8 * angle.cos()), (58.8 * angle.sin() - 34.0) / (58.8 * angle.cos())]
    }),
    ("drag.crate-up-force", "1062 N", "1062", || {
        let angle = 37.0_f64.to_radians();
        [980.0 * 1.8 * angle.sin(), 980.0 * (angle.sin() + 0.8 * angle.tan() * angle.cos())]
    }),
    ("drag.crate-up-force", "1.7 per cent", "1.7", || {
        let force = 1764.0 * 37.0_f64.to_radians().sin();
        [100.0 * (1080.0 - force) / 1080.0, 100.0 - 100.0 * force / 1080.0]
    }),
    ("drag.road-friction", "is 0.787", "0.787", || [(100.0 / 3.6_f64).powi(2) / 980.0, 1e4 / 12.96 / 2.0 / G / 50.0]),
    ("drag.road-friction", "would be 0.789", "0.789", || [27.8 * 27.8 / 980.0, 27.8 / G * 27.8 / 100.0]),
    ("drag.bacon", "is 0.218", "0.218", || [5.0 / (23.5_f64.powi(2) - 25.0).sqrt(), (5.0 / 23.5_f64).asin().tan()]),
    ("drag.bacon", "of 0.2178", "0.2178", || [5.0 / 527.25_f64.sqrt(), 1.0 / ((23.5 / 5.0_f64).powi(2) - 1.0).sqrt()]),
    ("drag.turn-radius", "2545 m, which", "2545", || {
        let angle = 30.0_f64.to_radians();
        [14_400.0 / (G * angle.tan()), 14_400.0 * 3.0_f64.sqrt() / G]
    }),
    ("drag.turn-radius", "gives 2544 m", "2544", || [2500.0 * 14_400.0 / (28_300.0 * 0.5), 3.6e7 / 14_150.0]),
    ("drag.parachute-limit", "is 1071 m/s", "1071", || [82.0 * G / 0.750, 803.6 * 4.0 / 3.0]),
    ("drag.parachute-time", "1030 m", "1030", || [1520.0 - 490.0, 1520.0 - G * 50.0]),
    ("drag.parachute-time", "needs 7.8 s", "7.8", || [below(0.750), below_by_formula(0.750)]),
    ("drag.parachute-time", "10.2 s", "10.2", || [below(7.50), below_by_formula(7.50)]),
];

/// The slowest bacterium: half a micrometre of radius, a tenth denser than water.
fn slowest() -> f64 {
    2.0 / 9.0 * 100.0 * G * 0.25e-12 / 1e-3
}

/// The speed of what falls through a way, in small steps of time; the drag is a factor times the square of the speed.
fn fallen(mass: f64, factor: f64, way: f64) -> f64 {
    let (mut speed, mut left, step) = (0.0, way, 1e-5);
    while left > 0.0 {
        let middle = speed + step / 2.0 * (G - factor * speed * speed / mass);
        speed += step * (G - factor * middle * middle / mass);
        left -= middle * step;
    }
    speed
}

/// The time below the parachute in small steps.
fn below(factor: f64) -> f64 {
    let (mut speed, mut left, mut time, step) = (98.0, 1030.0, 0.0, 1e-4);
    while left > 0.0 {
        let middle = speed + step / 2.0 * (G - factor * speed / 82.0);
        speed += step * (G - factor * middle / 82.0);
        left -= middle * step;
        time += step;
    }
    time
}

/// The time below the parachute by the exponential law, from halving an interval.
fn below_by_formula(factor: f64) -> f64 {
    let (constant, limit) = (82.0 / factor, 82.0 * G / factor);
    let way = |time: f64| limit * time + (98.0 - limit) * constant * (1.0 - (-time / constant).exp());
    let (mut early, mut late) = (0.0, 20.0);
    for _ in 0..60 {
        let middle = (early + late) / 2.0;
        if way(middle) < 1030.0 { early = middle } else { late = middle }
    }
    late
}

#[test]
fn numbers_of_ours_are_computed_in_two_ways() {
    for (id, phrase, number, ways) in TYPED {
        let claim = LEDGER.claim(id).unwrap_or_else(|| panic!("no claim {id}"));
        let missing = if let Check::Missing { reason } = claim.check { reason } else { "" };
        let slip = claim.erratum.map(|erratum| erratum.slip);
        let words = slip.map_or(String::new(), |slip| [slip.reason, slip.witness, slip.changes].join(" "));
        assert!(format!("{missing} {words}").contains(phrase), "{id} no longer says: {phrase}");
        assert!(phrase.contains(number), "{phrase}: {number}");
        let said: Decimal = number.parse().expect("a number");
        for way in ways() {
            // What is said to be about something, or nearly, is rounded to one digit.
            let about =
                (way / said.to_f64() - 1.0).abs() < 0.15 && (phrase.contains("about") || phrase.contains("nearly"));
            assert!(said.is_rounding_of(way) || about, "{id}: {phrase}: {way}");
        }
    }
}

/// What the page on the newest edition may type: days, commits, and the name of a block.
const NAMES: &[&str] = &[
    "September 2022",
    "9 September 2022",
    "13 September 2022",
    "16 September 2022",
    "18 January 2023",
    "29 March 2023",
    "2 February 2026",
    "23 April 2026",
    "11 June 2026",
    "In 2022",
    "in 2022",
    "| 2022 |",
    "In 2023",
    "In 2026",
    "6225f58",
    "d0ed34a",
    "lock 1 ",
];

#[test]
fn numbers_of_the_newest_edition_come_from_the_code() {
    let numbers = (BOOK.own_numbers)();
    let page = include_str!("../book/src/editions.md");
    for number in numbers {
        let backing = number.check().unwrap_or_else(|error| panic!("{error}"));
        assert!(page.contains(&format!("{{{{computed:{}}}}}", number.id)), "{} ({backing:?}) is not shown", number.id);
    }
    let mut typed = page.to_owned();
    while let Some((before, rest)) = typed.split_once("{{") {
        let (_, behind) = rest.split_once("}}").expect("an end of the placeholder");
        typed = format!("{before}…{behind}");
    }
    let mut names = NAMES.to_vec();
    names.sort_by_key(|name| std::cmp::Reverse(name.len()));
    for name in names {
        assert!(typed.contains(name), "the page no longer says {name}");
        typed = typed.replace(name, "");
    }
    let left: Vec<&str> = typed.lines().filter(|line| line.contains(|of: char| of.is_ascii_digit())).collect();
    assert!(left.is_empty(), "typed and in no list: {left:#?}");
}
