//! Does a model whose variables are changed either refuse itself or still run? The text is evaluated here, as OpenSCAD would,
//! and its parts are turned past each other, each as circles and squares.

use geneva_kinematics::wheel::{Choices, Mouth, Play, Scale, Sizes, Wheel};
use geneva_workshop::{Solid, scad};
use std::collections::BTreeMap;
use std::f64::consts::{PI, TAU};

/// Variables with their numbers.
type Names = BTreeMap<String, f64>;

/// An expression of the file: `+ - * /`, comparisons, `||`, brackets, and `sin` of degrees.
struct Expression<'a> {
    words: Vec<&'a str>,
    at: usize,
    names: &'a Names,
}

fn words(text: &str) -> Vec<&str> {
    let mut words = Vec::new();
    let mut rest = text.trim_start();
    while let Some(first) = rest.chars().next() {
        let is_word = |c: char| c.is_alphanumeric() || matches!(c, '_' | '.' | '$');
        let length = if is_word(first) {
            rest.find(|c| !is_word(c)).unwrap_or(rest.len())
        } else if ["==", "<=", ">=", "||"].iter().any(|sign| rest.starts_with(sign)) {
            2
        } else {
            first.len_utf8()
        };
        words.push(&rest[..length]);
        rest = rest[length..].trim_start();
    }
    words
}

impl Expression<'_> {
    fn value(text: &str, names: &Names) -> f64 {
        let mut expression = Expression { words: words(text), at: 0, names };
        let value = expression.either();
        assert_eq!(expression.at, expression.words.len(), "not read to its end: {text}");
        value
    }

    fn take(&mut self, signs: &[&str]) -> Option<String> {
        let word = self.words.get(self.at).filter(|word| signs.contains(word))?;
        self.at += 1;
        Some((*word).to_owned())
    }

    fn either(&mut self) -> f64 {
        let mut value = self.compared();
        while self.take(&["||"]).is_some() {
            let other = self.compared();
            value = f64::from(value != 0.0 || other != 0.0);
        }
        value
    }

    fn compared(&mut self) -> f64 {
        let left = self.sum();
        let Some(sign) = self.take(&["==", "<=", ">=", "<", ">"]) else { return left };
        let right = self.sum();
        f64::from(match &*sign {
            "==" => left == right,
            "<=" => left <= right,
            ">=" => left >= right,
            "<" => left < right,
            _ => left > right,
        })
    }

    fn sum(&mut self) -> f64 {
        let mut value = self.product();
        while let Some(sign) = self.take(&["+", "-"]) {
            let term = self.product();
            value += if sign == "+" { term } else { -term };
        }
        value
    }

    fn product(&mut self) -> f64 {
        let mut value = self.single();
        while let Some(sign) = self.take(&["*", "/"]) {
            let factor = self.single();
            value = if sign == "*" { value * factor } else { value / factor };
        }
        value
    }

    fn single(&mut self) -> f64 {
        let word = self.words[self.at];
        self.at += 1;
        match word {
            "(" => {
                let value = self.either();
                assert!(self.take(&[")"]).is_some());
                value
            }
            "-" => -self.single(),
            "sin" => self.single().to_radians().sin(),
            _ => word.parse().unwrap_or_else(|_| *self.names.get(word).unwrap_or_else(|| panic!("no {word}"))),
        }
    }
}

/// The file up to its drawing, with some variables changed: its variables and why it refuses itself, if it does.
fn read(text: &str, changed: &[(&str, f64)]) -> (Names, Option<String>) {
    let code: String =
        text.lines().map(|line| line.split("//").next().unwrap_or_default()).collect::<Vec<_>>().join(" ");
    let mut names = Names::new();
    for statement in code.split(';').map(str::trim).take_while(|statement| !statement.starts_with("part = ")) {
        if let Some(inside) = statement.strip_prefix("assert(").and_then(|rest| rest.strip_suffix(')')) {
            let (condition, why) = inside.split_once(", ").expect("a condition and a reason");
            if Expression::value(condition, &names) == 0.0 {
                return (names, Some(why.trim().trim_matches('"').to_owned()));
            }
        } else {
            let (name, value) = statement.split_once(" = ").expect("a variable");
            let given = changed.iter().find(|(of, _)| *of == name).map(|(_, value)| *value);
            let value = given.unwrap_or_else(|| Expression::value(value, &names));
            names.insert(name.to_owned(), value);
        }
    }
    (names, None)
}

/// How deep, in millimetres, some point of one part is in the other over the whole turn, by the text's circles and squares.
fn overlap(names: &Names) -> f64 {
    let of = |name: &str| names[name];
    let (half_pitch, pins) = (of("half_pitch").to_radians(), of("pins"));
    let (centre, crank) = (of("centre_distance"), of("crank_radius"));
    let (half, pin, disc) = (of("slot_width") / 2.0, of("pin_diameter") / 2.0, of("locking_disc_radius"));
    // How deep a point is in the wheel, below zero outside.
    let in_wheel = |[x, y]: [f64; 2]| {
        let (far, angle) = (x.hypot(y), y.atan2(x));
        let from_slot = angle - 2.0 * half_pitch * (angle / (2.0 * half_pitch)).round();
        let [along, across] = [far * from_slot.cos(), (far * from_slot.sin()).abs()];
        let end = (along - of("slot_end")).hypot(across) - half;
        let slot = if along > of("slot_end") { end.min(across - half) } else { end };
        let arc = (far * (half_pitch - from_slot.abs()).cos() - centre)
            .hypot(far * (half_pitch - from_slot.abs()).sin())
            - of("locking_arc_radius");
        (of("tip_radius") - far).min(slot).min(arc)
    };
    let around = |radius: f64, step: f64| {
        let all = (TAU * radius / step).ceil().max(8.0) as usize;
        (0..all).map(move |k| TAU * k as f64 / all as f64).map(move |at| [radius * at.cos(), radius * at.sin()])
    };
    let step = crank / 80.0;
    // Points on the outlines of pins and disc; the first pin is to the right of the driver's axis.
    let turns = || (0..pins as u32).map(|k| TAU * f64::from(k) / pins);
    let turned = |[x, y]: [f64; 2], turn: f64| [x * turn.cos() - y * turn.sin(), x * turn.sin() + y * turn.cos()];
    let (at, cut) = (of("crescent_centre"), of("crescent_radius"));
    let is_of_disc = |[x, y]: &[f64; 2]| {
        let is_cut = |turn: f64| (x - at * turn.cos()).hypot(y - at * turn.sin()) < cut - 1e-9;
        x.hypot(*y) <= disc + 1e-9 && !turns().any(is_cut)
    };
    let mut driver: Vec<[f64; 2]> = Vec::new();
    if disc > 0.0 {
        // The edges of the opening, its wall, and the rim.
        let along = (disc * disc + at * at - cut * cut) / (2.0 * at);
        let across = (disc * disc - along * along).max(0.0).sqrt();
        let edges = [[along, across], [along, -across]];
        let opening: Vec<_> = around(cut, step).map(|[x, y]| [at + x, y]).chain(edges).collect();
        driver.extend(turns().flat_map(|turn| opening.iter().map(move |point| turned(*point, turn))));
        driver.extend(around(disc, step));
        driver.retain(is_of_disc);
    }
    driver.extend(turns().flat_map(|turn| around(pin, step).map(move |[x, y]| turned([crank + x, y], turn))));
    let engagement = PI / 2.0 - half_pitch;
    let mut deepest = f64::NEG_INFINITY;
    for k in -60..=60 {
        let theta = PI / pins * f64::from(k) / 60.0;
        let phi = if theta.abs() < engagement {
            (crank * theta.sin()).atan2(centre - crank * theta.cos())
        } else {
            theta.signum() * half_pitch
        };
        for [x, y] in &driver {
            let turn = PI - theta;
            let [x, y] = [centre + x * turn.cos() - y * turn.sin(), x * turn.sin() + y * turn.cos()];
            let back = [x * phi.cos() + y * phi.sin(), y * phi.cos() - x * phi.sin()];
            deepest = deepest.max(in_wheel(back));
        }
    }
    deepest
}

fn model(stations: u32, pins: u32, choices: &Choices) -> String {
    let wheel = Wheel::with_pins(stations, pins).expect("possible");
    let sizes = Sizes::new(wheel, Scale::CrankRadius(25.0), choices).expect("fits");
    scad(&sizes, Solid { thickness: 6.0, tolerance: 0.005 }).expect("a model")
}

const WHEELS: [(u32, u32); 7] = [(3, 1), (4, 1), (4, 4), (5, 2), (6, 1), (8, 2), (12, 1)];

#[test]
fn a_model_that_is_not_changed_runs_and_refuses_nothing() {
    let loose = Choices { play: Some(Play::from_slot(0.4)), ..Choices::default() };
    let tight = Choices { play: Some(Play::from_slot(0.0)), ..Choices::default() };
    for (stations, pins) in WHEELS {
        for choices in [&Choices::default(), &loose, &tight] {
            let (names, refused) = read(&model(stations, pins, choices), &[]);
            assert_eq!(refused, None, "{stations} stations, {pins} pins");
            let deepest = overlap(&names);
            assert!(deepest < 1e-9, "{stations} stations, {pins} pins: {deepest} mm");
        }
    }
    for (stations, pins) in [(60, 1), (400, 1), (24, 2)] {
        assert_eq!(read(&model(stations, pins, &Choices::default()), &[]).1, None, "{stations} stations");
    }
}

#[test]
fn a_model_with_a_changed_variable_refuses_itself_or_runs() {
    let (mut runs, mut refuses) = (0, 0);
    for (stations, pins) in [(4, 1), (6, 1), (8, 2)] {
        let text = model(stations, pins, &Choices::default());
        let (at_first, _) = read(&text, &[]);
        let variables = text.lines().take_while(|line| !line.is_empty()).filter_map(|line| line.split_once(" = "));
        for (name, _) in variables {
            let others: Vec<f64> = match name {
                "stations" => (3..=24).map(f64::from).filter(|other| *other != f64::from(stations)).collect(),
                "pins" => (1..=6).map(f64::from).filter(|other| *other != f64::from(pins)).collect(),
                _ => [0.8, 0.99, 1.01, 1.2].map(|factor| factor * at_first[name]).to_vec(),
            };
            for value in others.into_iter().filter(|value| *value != at_first[name]) {
                let (names, refused) = read(&text, &[(name, value)]);
                if let Some(why) = refused {
                    assert!(why.contains("must be") || why.contains("make "), "{name} = {value}: {why}");
                    refuses += 1;
                    continue;
                }
                let deepest = overlap(&names);
                assert!(deepest < 1e-9, "{stations} stations, {pins} pins, {name} = {value}: {deepest} mm");
                runs += 1;
            }
        }
    }
    assert!(runs > 50 && refuses > 50, "{runs} run, {refuses} refuse themselves");
}

#[test]
fn the_overlap_of_a_wheel_with_other_stations_would_be_found() {
    // The crescent of six stations in a wheel of eight.
    let (mut names, _) = read(&model(6, 1, &Choices::default()), &[]);
    let (eight, _) = read(&model(8, 1, &Choices::default()), &[]);
    for name in ["stations", "half_pitch", "centre_distance", "slot_end", "tip_radius"] {
        names.insert(name.to_owned(), eight[name]);
    }
    assert!(overlap(&names) > 0.1, "{} mm", overlap(&names));
}

/// The mouth of the text, point by point, is the face of the outline.
#[test]
fn a_model_has_the_mouths_of_the_outline() {
    for mouth in [
        Mouth::Chamfer { width: 2.0, angle: 0.4 },
        Mouth::Round { radius: 1.5 },
        Mouth::LeadIn { length: 5.0, flare: 0.6 },
    ] {
        let wheel = Wheel::new(6).expect("possible");
        let sizes =
            Sizes::new(wheel, Scale::CrankRadius(25.0), &Choices { mouth, ..Choices::default() }).expect("fits");
        let text = scad(&sizes, Solid { thickness: 6.0, tolerance: 0.001 }).expect("a model");
        let list = text.lines().find_map(|line| line.strip_prefix("mouth = [")?.strip_suffix("];")).expect("a mouth");
        let points: Vec<[f64; 2]> = list
            .trim_matches(['[', ']'])
            .split("], [")
            .map(|point| point.split_once(", ").expect("two numbers"))
            .map(|(x, y)| [x.parse::<f64>().expect("a number"), y.parse::<f64>().expect("a number")])
            .collect();
        let half = sizes.slot_width / 2.0;
        let placed: Vec<[f64; 2]> = points.iter().map(|[x, y]| [x + sizes.wheel_radius, y + half]).collect();
        // It begins on the wall and ends on the rim; between, it is on the face.
        assert!(points[0][1].abs() < 1e-12, "{mouth:?}: {points:?}");
        let end = placed.last().expect("points");
        approx::assert_relative_eq!(end[0].hypot(end[1]), sizes.tip_radius, max_relative = 1e-12);
        let outline = sizes.outline().wheel.outer.corners(0.001).expect("corners");
        for [x, y] in &placed {
            let nearest = outline.iter().map(|p| (p.x - x).hypot(p.y - y)).fold(f64::INFINITY, f64::min);
            assert!(nearest < 1e-9, "{mouth:?}: {x} {y} is {nearest} mm from a corner of the outline");
        }
    }
    assert!(model(6, 1, &Choices::default()).contains("\nmouth = [];\n"));
}
