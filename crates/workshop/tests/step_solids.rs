//! Are the solids of a STEP file closed and as large as the parts? The file is read here by a strict reader of its own: every
//! reference leads to an entity of the kind that the standard wants there, each edge is in two faces in opposite senses and ends
//! on its curve, each face's bounds lie on its surface, and the volume follows from the faces.

use geneva_kinematics::internal_sizes::InternalSizes;
use geneva_kinematics::internal_wheel::InternalWheel;
use geneva_kinematics::wheel::{Choices, Scale, Sizes, Wheel};
use geneva_workshop::{
    BasePlate, Fastener, Layer, Mounting, Part, Pattern, PinMount, ScrewHole, ShaftFit, Thread, internal_parts, parts,
    step,
};
use nalgebra::Vector3;
use std::collections::BTreeMap;
use std::f64::consts::PI;

type Point = Vector3<f64>;

/// A value of an entity.
#[derive(Clone, Debug, PartialEq)]
enum Value {
    Reference(u32),
    Number(f64),
    Text(String),
    /// A word between points, `$` or `*`.
    Word(String),
    List(Vec<Value>),
}

/// The entities of a file: name and values; of entities of several kinds the names of all.
struct File(BTreeMap<u32, (String, Vec<Value>)>);

/// Reads values up to a closing bracket.
fn values(text: &mut &str) -> Vec<Value> {
    let mut all = Vec::new();
    loop {
        *text = text.trim_start_matches([',', ' ', '\n']);
        let Some(first) = text.chars().next() else { panic!("no closing bracket") };
        let length = text.find([',', ')']).unwrap_or(text.len());
        match first {
            ')' => {
                *text = &text[1..];
                return all;
            }
            '(' => {
                *text = &text[1..];
                all.push(Value::List(values(text)));
                continue;
            }
            '\'' => {
                let end = text[1..].find('\'').expect("the end of a text") + 2;
                all.push(Value::Text(text[1..end - 1].to_owned()));
                *text = &text[end..];
                continue;
            }
            '#' => all.push(Value::Reference(text[1..length].parse().expect("a number"))),
            '.' | '$' | '*' => all.push(Value::Word(text[..length].to_owned())),
            c if c.is_ascii_uppercase() => {
                // A measure with its type: the value within counts.
                let open = text.find('(').expect("a typed value");
                *text = &text[open + 1..];
                all.extend(values(text));
                continue;
            }
            _ => {
                let number = &text[..length];
                // A real number has a point, and only then a power of ten.
                assert!(
                    number.parse::<i64>().is_ok() || number.split('E').next().is_some_and(|of| of.contains('.')),
                    "{number}"
                );
                all.push(Value::Number(number.parse().unwrap_or_else(|_| panic!("{number}"))));
            }
        }
        *text = &text[length..];
    }
}

fn read(text: &str) -> File {
    let body = text.strip_prefix("ISO-10303-21;\n").and_then(|rest| rest.strip_suffix("ENDSEC;\nEND-ISO-10303-21;\n"));
    let (header, data) = body.expect("a file of the format").split_once("DATA;\n").expect("data");
    assert!(header.contains("FILE_SCHEMA(('AUTOMOTIVE_DESIGN"));
    let mut entities = BTreeMap::new();
    for line in data.lines() {
        let (id, rest) = line.strip_prefix('#').and_then(|rest| rest.split_once('=')).expect("an entity");
        let rest = rest.strip_suffix(';').expect("the end of an entity");
        let entity = if let Some(inside) = rest.strip_prefix('(') {
            (inside.to_owned(), Vec::new())
        } else {
            let (name, mut rest) = rest.split_once('(').expect("values");
            let found = values(&mut rest);
            assert!(rest.is_empty(), "{line}");
            (name.to_owned(), found)
        };
        assert!(entities.insert(id.parse().expect("a number"), entity).is_none(), "#{id} twice");
    }
    let file = File(entities);
    for (id, (name, values)) in &file.0 {
        references(values).for_each(|to| assert!(file.0.contains_key(&to), "#{id} {name}: no #{to}"));
    }
    file
}

fn references(values: &[Value]) -> Box<dyn Iterator<Item = u32> + '_> {
    Box::new(values.iter().flat_map(|value| match value {
        Value::Reference(to) => vec![*to],
        Value::List(inner) => references(inner).collect(),
        _ => Vec::new(),
    }))
}

/// A curve or a surface about a place with an axis and a first direction.
#[derive(Clone, Copy, Debug)]
struct Axes {
    at: Point,
    axis: Point,
    first: Point,
}

#[derive(Clone, Copy, Debug)]
enum Curve {
    Line { at: Point, along: Point },
    Circle { axes: Axes, radius: f64 },
}

/// An edge as a face uses it.
#[derive(Clone, Copy, Debug)]
struct Used {
    from: Point,
    to: Point,
    curve: Curve,
    /// Whether it runs as its circle does, counter-clockwise about the axis.
    is_with_curve: bool,
}

impl File {
    fn values(&self, id: u32, name: &str) -> &[Value] {
        let (found, values) = &self.0[&id];
        assert_eq!(found, name, "#{id}");
        values
    }

    fn to(value: &Value) -> u32 {
        let Value::Reference(to) = value else { panic!("{value:?} is no reference") };
        *to
    }

    fn list(value: &Value) -> &[Value] {
        let Value::List(of) = value else { panic!("{value:?} is no list") };
        of
    }

    fn is_true(value: &Value) -> bool {
        match value {
            Value::Word(word) if word == ".T." => true,
            Value::Word(word) if word == ".F." => false,
            other => panic!("{other:?} is neither true nor false"),
        }
    }

    fn numbers(&self, id: u32, name: &str) -> Point {
        let of = Self::list(&self.values(id, name)[1]);
        let number = |value: &Value| if let Value::Number(x) = value { *x } else { panic!("{value:?}") };
        assert_eq!(of.len(), 3);
        Point::new(number(&of[0]), number(&of[1]), number(&of[2]))
    }

    fn point(&self, id: u32) -> Point {
        self.numbers(id, "CARTESIAN_POINT")
    }

    fn direction(&self, id: u32) -> Point {
        let of = self.numbers(id, "DIRECTION");
        assert!((of.norm() - 1.0).abs() < 1e-12);
        of
    }

    fn axes(&self, id: u32) -> Axes {
        let of = self.values(id, "AXIS2_PLACEMENT_3D");
        let axes = Axes {
            at: self.point(Self::to(&of[1])),
            axis: self.direction(Self::to(&of[2])),
            first: self.direction(Self::to(&of[3])),
        };
        assert!(axes.axis.dot(&axes.first).abs() < 1e-12);
        axes
    }

    fn radius(value: &Value) -> f64 {
        let Value::Number(radius) = value else { panic!("{value:?}") };
        assert!(*radius > 0.0);
        *radius
    }

    fn curve(&self, id: u32) -> Curve {
        match self.0[&id].0.as_str() {
            "LINE" => {
                let of = self.values(id, "LINE");
                let vector = self.values(Self::to(&of[2]), "VECTOR");
                Curve::Line { at: self.point(Self::to(&of[1])), along: self.direction(Self::to(&vector[1])) }
            }
            _ => {
                let of = self.values(id, "CIRCLE");
                Curve::Circle { axes: self.axes(Self::to(&of[1])), radius: Self::radius(&of[2]) }
            }
        }
    }

    fn vertex(&self, value: &Value) -> Point {
        self.point(Self::to(&self.values(Self::to(value), "VERTEX_POINT")[1]))
    }

    /// The edge that an oriented edge uses: which it is, and how.
    fn used(&self, id: u32) -> (u32, bool, Used) {
        let oriented = self.values(id, "ORIENTED_EDGE");
        let (edge, is_forward) = (Self::to(&oriented[3]), Self::is_true(&oriented[4]));
        let of = self.values(edge, "EDGE_CURVE");
        let (from, to, curve) = (self.vertex(&of[1]), self.vertex(&of[2]), self.curve(Self::to(&of[3])));
        let is_same = Self::is_true(&of[4]);
        for end in [from, to] {
            let off = match curve {
                Curve::Line { at, along } => (end - at).cross(&along).norm(),
                Curve::Circle { axes, radius } => {
                    let from = end - axes.at;
                    from.dot(&axes.axis).abs().max((from.norm() - radius).abs())
                }
            };
            assert!(off < 1e-9, "#{edge} ends {off} mm off its curve");
        }
        if let Curve::Line { along, .. } = curve {
            assert!(is_same && (to - from).dot(&along) > 0.0, "#{edge}");
        }
        let (from, to) = if is_forward { (from, to) } else { (to, from) };
        (edge, is_forward, Used { from, to, curve, is_with_curve: is_same == is_forward })
    }
}

impl Used {
    /// The angle that it sweeps about its circle, in radians, in the circle's sense or against it.
    fn sweep(&self, axes: &Axes) -> f64 {
        let angle = |p: Point| {
            let p = p - axes.at;
            p.dot(&axes.axis.cross(&axes.first)).atan2(p.dot(&axes.first))
        };
        let turn = (angle(self.to) - angle(self.from)).rem_euclid(2.0 * PI);
        if self.is_with_curve { turn } else { turn - 2.0 * PI }
    }

    /// What it adds to twice the area that a bound encloses, as a vector.
    fn twice_area(&self) -> Point {
        match self.curve {
            Curve::Line { .. } => self.from.cross(&self.to),
            Curve::Circle { axes, radius } => {
                axes.at.cross(&(self.to - self.from)) + axes.axis * (radius * radius * self.sweep(&axes))
            }
        }
    }
}

/// A solid of the file: its volume by the divergence theorem, and the areas of its cylinders by their radii.
fn volume(file: &File, solid: u32) -> f64 {
    let shell = File::to(&file.values(solid, "MANIFOLD_SOLID_BREP")[1]);
    let mut uses: BTreeMap<u32, Vec<bool>> = BTreeMap::new();
    let mut volume = 0.0;
    for face in File::list(&file.values(shell, "CLOSED_SHELL")[1]) {
        let of = file.values(File::to(face), "ADVANCED_FACE");
        let (surface, is_same) = (File::to(&of[2]), File::is_true(&of[3]));
        let mut area = Point::zeros();
        let mut all: Vec<Used> = Vec::new();
        for (k, bound) in File::list(&of[1]).iter().enumerate() {
            let kind = if k == 0 { "FACE_OUTER_BOUND" } else { "FACE_BOUND" };
            let bound = file.values(File::to(bound), kind);
            assert!(File::is_true(&bound[2]));
            let edges = File::list(&file.values(File::to(&bound[1]), "EDGE_LOOP")[1]);
            let used: Vec<Used> = edges
                .iter()
                .map(|edge| {
                    let (edge, is_forward, used) = file.used(File::to(edge));
                    uses.entry(edge).or_default().push(is_forward);
                    used
                })
                .collect();
            for (one, next) in used.iter().zip(used.iter().cycle().skip(1)) {
                assert_eq!(one.to, next.from, "a bound is not closed");
            }
            let its: Point = used.iter().map(Used::twice_area).sum::<Point>() / 2.0;
            // The outer bound turns one way, and the holes in it the other.
            assert!(k == 0 || its.dot(&area) < 0.0);
            area += its;
            all.extend(used);
        }
        match file.0[&surface].0.as_str() {
            "PLANE" => {
                let axes = file.axes(File::to(&file.values(surface, "PLANE")[1]));
                assert!(all.iter().all(|edge| (edge.from - axes.at).dot(&axes.axis).abs() < 1e-9));
                let out = axes.axis * if is_same { 1.0 } else { -1.0 };
                // Seen against the outer normal a face's bound runs counter-clockwise.
                assert!(area.normalize().dot(&out) > 1.0 - 1e-9, "{area:?} {out:?}");
                volume += area.norm() * axes.at.dot(&out) / 3.0;
            }
            _ => {
                let of = file.values(surface, "CYLINDRICAL_SURFACE");
                let (axes, radius) = (file.axes(File::to(&of[1])), File::radius(&of[2]));
                let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
                let mut sweep = None;
                // ∮ of the outer normal over the piece of the wall, per height.
                let mut normal = Point::zeros();
                for edge in &all {
                    let height = (edge.from - axes.at).dot(&axes.axis);
                    (low, high) = (low.min(height), high.max(height));
                    let off = edge.from - axes.at - axes.axis * height;
                    assert!((off.norm() - radius).abs() < 1e-9);
                    let Curve::Circle { axes: own, radius: its } = edge.curve else { continue };
                    assert!((its - radius).abs() < 1e-12 && own.axis == axes.axis);
                    // The lower edge runs with the wall seen from outside.
                    if sweep.is_none() {
                        sweep = Some(edge.sweep(&own));
                        normal = (edge.to - edge.from).cross(&axes.axis);
                    }
                }
                let sweep = sweep.expect("an edge around");
                assert_eq!(sweep > 0.0, is_same, "a wall that turns with its edge has its normal outside");
                // (1/3) ∫ p · n dA with p = centre + r e + z k: the centre's part follows from the ends, r's from the sweep.
                volume += (axes.at.dot(&normal) + radius * radius * sweep) * (high - low) / 3.0;
            }
        }
    }
    for (edge, mut senses) in uses {
        senses.sort_unstable();
        assert_eq!(senses, [false, true], "#{edge} is not in two faces in opposite senses");
    }
    volume
}

fn volumes(text: &str) -> Vec<(String, f64)> {
    let file = read(text);
    let solids = file.0.iter().filter(|(_, (name, _))| name == "MANIFOLD_SOLID_BREP");
    solids
        .map(|(id, (_, values))| {
            let Value::Text(name) = &values[0] else { panic!("a solid without a name") };
            (name.clone(), volume(&file, *id))
        })
        .collect()
}

fn list(stations: u32, pins: u32, choices: &Choices, mounting: &Mounting) -> (Sizes, Vec<Part>) {
    let wheel = Wheel::with_pins(stations, pins).expect("possible");
    let sizes = Sizes::new(wheel, Scale::CrankRadius(60.0), choices).expect("possible");
    (sizes, parts(&sizes, 8.0, mounting).expect("possible").parts)
}

/// Volumes of the parts in the file's order, with pins that are one with the plate.
fn expected(sizes: &Sizes, list: &[Part]) -> f64 {
    let all: f64 = list.iter().map(|part| part.volume() * part.quantity() as f64).sum();
    let joined = list.iter().find(|part| part.layer == Layer::Pins && part.is_joined);
    all + joined.map_or(0.0, |pin| PI * sizes.pin_radius().powi(2) * 8.0 * pin.quantity() as f64)
}

#[test]
fn solids_of_bare_parts_are_closed_and_as_large_as_their_outlines() {
    let stacked = Mounting { is_stacked: true, ..Mounting::default() };
    for (stations, pins) in [(3, 1), (4, 4), (5, 3), (6, 2), (8, 1), (12, 1), (24, 2)] {
        for mounting in [Mounting::default(), stacked] {
            let (sizes, list) = list(stations, pins, &Choices::default(), &mounting);
            let found = volumes(&step(&list).unwrap());
            let count = if mounting.is_stacked { list.iter().map(Part::quantity).sum() } else { 2 };
            assert_eq!(found.len(), count);
            let all: f64 = found.iter().map(|(_, volume)| volume).sum();
            approx::assert_relative_eq!(all, expected(&sizes, &list), max_relative = 1e-9);
            assert_eq!(found[0].0, "wheel");
            approx::assert_relative_eq!(found[0].1, list[0].volume(), max_relative = 1e-9);
        }
    }
}

#[test]
fn solids_with_holes_keyways_nuts_and_a_base_are_closed_too() {
    let choices = Choices { wheel_shaft: Some(16.0), driver_shaft: Some(8.0), ..Choices::default() };
    let fastener = Fastener::Screw(Thread::M4, ScrewHole::NutTrap);
    let mounting = Mounting {
        wheel_fit: ShaftFit::Key,
        driver_fit: ShaftFit::Flat { across: 7.0 },
        wheel_hub: Some(Pattern { count: 4, circle: 36.0, fastener }),
        driver_hub: Some(Pattern { count: 3, circle: 24.0, fastener }),
        pins: PinMount::Screw(Thread::M5, ScrewHole::NutTrap),
        base: Some(BasePlate { thickness: Some(10.0), shoulder: Some([24.0, 3.0]), screws: Some(Thread::M6) }),
        ..Mounting::default()
    };
    let dowels = Pattern { count: 2, circle: 30.0, fastener: Fastener::Dowel(3.0) };
    let stacked = Mounting { disc_dowels: Some(dowels), driver_hub: None, pins: PinMount::Dowel, ..mounting };
    for (stations, pins, mounting) in [(6, 1, mounting), (6, 2, stacked), (5, 1, mounting), (8, 1, stacked)] {
        let (sizes, list) = list(stations, pins, &choices, &mounting);
        let found = volumes(&step(&list).unwrap());
        let all: f64 = found.iter().map(|(_, volume)| volume).sum();
        approx::assert_relative_eq!(all, expected(&sizes, &list), max_relative = 1e-9);
        assert!(found.iter().any(|(name, _)| name == "base plate"));
    }
}

#[test]
fn solids_of_an_internal_wheel_are_closed_too() {
    let choices =
        Choices { wheel_shaft: Some(10.0), plate_shaft: Some(12.0), pin_diameter: Some(5.0), ..Choices::default() };
    let nut = Fastener::Screw(Thread::M4, ScrewHole::NutTrap);
    let mounted = Mounting {
        wheel_fit: ShaftFit::Key,
        driver_hub: Some(Pattern { count: 3, circle: 40.0, fastener: nut }),
        pins: PinMount::Screw(Thread::M5, ScrewHole::NutTrap),
        ..Mounting::default()
    };
    for (stations, choices, mounting) in [
        (3, Choices::default(), Mounting::default()),
        (4, Choices::default(), Mounting { is_stacked: true, ..Mounting::default() }),
        (6, choices, mounted),
        (24, Choices::default(), Mounting::default()),
    ] {
        let wheel = InternalWheel::new(stations).unwrap();
        let sizes = InternalSizes::new(wheel, 60.0, &choices).unwrap();
        let list = internal_parts(&sizes, 8.0, &mounting).unwrap().parts;
        let found = volumes(&step(&list).unwrap());
        let all: f64 = found.iter().map(|(_, volume)| volume).sum();
        let joined = list.iter().any(|part| part.layer == Layer::Pins && part.is_joined);
        let filled = if joined { PI * sizes.pin_radius().powi(2) * 8.0 } else { 0.0 };
        let drawn: f64 = list.iter().map(|part| part.volume() * part.quantity() as f64).sum();
        approx::assert_relative_eq!(all, drawn + filled, max_relative = 1e-9);
        approx::assert_relative_eq!(found[0].1, sizes.outline().ring.area() * 8.0, max_relative = 1e-9);
    }
}

#[test]
fn solids_whose_plate_bore_crosses_the_disc_or_its_bore_are_closed_too() {
    let shafts = |driver: f64, plate: f64| Choices {
        driver_shaft: Some(driver).filter(|driver| *driver > 0.0),
        plate_shaft: Some(plate),
        ..Choices::default()
    };
    let with = |driver_fit| Mounting { driver_fit, ..Mounting::default() };
    for (stations, pins, choices, fit) in [
        (6, 1, shafts(0.0, 30.0), ShaftFit::Round),
        (12, 1, shafts(0.0, 15.0), ShaftFit::Round),
        (4, 2, shafts(0.0, 45.0), ShaftFit::Round),
        (3, 1, shafts(0.0, 70.0), ShaftFit::Round),
        (6, 1, shafts(8.0, 8.4), ShaftFit::Flat { across: 7.5 }),
        (6, 1, shafts(8.0, 9.0), ShaftFit::Key),
        (6, 1, shafts(10.0, 11.0), ShaftFit::Key),
    ] {
        let (sizes, list) = list(stations, pins, &choices, &with(fit));
        let found = volumes(&step(&list).unwrap());
        let all: f64 = found.iter().map(|(_, volume)| volume).sum();
        assert_eq!(found.len(), 2);
        approx::assert_relative_eq!(all, expected(&sizes, &list), max_relative = 1e-9);
    }
}

#[test]
fn a_reader_that_finds_a_hole_in_a_shell_says_so() {
    let (_, list) = list(6, 1, &Choices::default(), &Mounting::default());
    let text = step(&list).unwrap();
    let shell = text.lines().find(|line| line.contains("CLOSED_SHELL")).unwrap();
    let (first, rest) = shell.split_once("(#").unwrap();
    let open = format!("{first}(#{}", rest.split_once(",#").unwrap().1);
    let wrong = text.replace(shell, &open);
    assert!(std::panic::catch_unwind(|| volumes(&wrong)).is_err());
}
