//! A drawing in the exchange format DXF.
//!
//! Release 12 (AC1009), which every program for cutting and milling reads: single `LINE`, `ARC` and `CIRCLE` entities,
//! whose centres, radii and angles stand in the file as they are, not as the bulge of a polyline. Numbers are written
//! with as many digits as give the same number back. The header says that lengths are millimetres.

use crate::drawing::{PartLayout, edges};
use crate::parts::{Layer, Part};
use geneva_kinematics::wheel::Edge;
use std::f64::consts::PI;
use std::fmt::{Display, Write};

/// The drawing of all parts, with a cross at each axis and pin.
pub fn dxf(parts: &[Part], layout: PartLayout) -> String {
    let mut file = File(String::new());
    file.group(0, "SECTION").group(2, "HEADER");
    file.group(9, "$ACADVER").group(1, "AC1009");
    // Millimetres.
    file.group(9, "$INSUNITS").group(70, 4);
    file.group(0, "ENDSEC");

    file.group(0, "SECTION").group(2, "TABLES");
    file.group(0, "TABLE").group(2, "LTYPE").group(70, 1);
    file.group(0, "LTYPE").group(2, "CONTINUOUS").group(70, 0).group(3, "Solid line").group(72, 65).group(73, 0);
    file.group(40, "0.0").group(0, "ENDTAB");
    file.group(0, "TABLE").group(2, "LAYER").group(70, Layer::ALL.len());
    for (layer, colour) in Layer::ALL.into_iter().zip(1..) {
        file.group(0, "LAYER").group(2, layer.name()).group(70, 0).group(62, colour).group(6, "CONTINUOUS");
    }
    file.group(0, "ENDTAB").group(0, "ENDSEC");

    file.group(0, "SECTION").group(2, "ENTITIES");
    edges(parts, layout).iter().for_each(|(layer, edge)| file.entity(*layer, edge));
    file.group(0, "ENDSEC").group(0, "EOF");
    file.0
}

/// Text of pairs of lines: a group's code and its value.
struct File(String);

impl File {
    fn group(&mut self, code: u16, value: impl Display) -> &mut Self {
        // Writing to a string cannot fail.
        let _ = writeln!(self.0, "{code:>3}\n{value}");
        self
    }

    fn number(&mut self, code: u16, value: f64) -> &mut Self {
        // An integer is written with its point, and no zero with a sign.
        self.group(code, format_args!("{:?}", value + 0.0))
    }

    fn entity(&mut self, layer: Layer, edge: &Edge) {
        match *edge {
            Edge::Line { from, to } => {
                self.group(0, "LINE").group(8, layer.name());
                self.number(10, from.x).number(20, from.y).number(30, 0.0);
                self.number(11, to.x).number(21, to.y).number(31, 0.0);
            }
            Edge::Arc { centre, radius, start, sweep } => {
                let is_whole = sweep.abs() >= 2.0 * PI;
                self.group(0, if is_whole { "CIRCLE" } else { "ARC" }).group(8, layer.name());
                self.number(10, centre.x).number(20, centre.y).number(30, 0.0).number(40, radius);
                if !is_whole {
                    // An ARC always goes counter-clockwise.
                    let (first, last) = if sweep < 0.0 { (start + sweep, start) } else { (start, start + sweep) };
                    self.number(50, degrees(first)).number(51, degrees(last));
                }
            }
        }
    }
}

/// An angle in radians as degrees from 0 to 360.
fn degrees(angle: f64) -> f64 {
    let turn = angle.to_degrees() % 360.0;
    if turn < 0.0 { turn + 360.0 } else { turn }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::parts::{BasePlate, Fastener, Mounting, Pattern, PinMount, ScrewHole, Thread, parts};
    use geneva_kinematics::wheel::{Choices, Scale, Sizes, Wheel};
    use nalgebra::Vector2;

    /// The parts of a wheel with a crank of 50 mm, bare and with a base plate, a hub and nuts.
    fn lists(stations: u32, pins: u32) -> [Vec<Part>; 2] {
        let wheel = Wheel::with_pins(stations, pins).unwrap();
        let sizes = Sizes::new(wheel, Scale::CrankRadius(50.0), &Choices::default()).unwrap();
        let fastener = Fastener::Screw(Thread::M3, ScrewHole::NutTrap);
        let mounted = Mounting {
            wheel_hub: Some(Pattern { count: 3, circle: 0.6 * sizes.wheel_shaft_limit, fastener }),
            pins: PinMount::Screw(Thread::M3, ScrewHole::Tapped),
            base: Some(BasePlate { screws: Some(Thread::M5), ..BasePlate::default() }),
            ..Mounting::default()
        };
        [Mounting::default(), mounted].map(|mounting| parts(&sizes, 6.0, &mounting).unwrap().parts)
    }

    /// A record of the file: what begins it, and the groups that follow, as the reference of release 12 describes them.
    struct Record {
        kind: String,
        groups: Vec<(u16, String)>,
    }

    impl Record {
        fn text(&self, code: u16) -> &str {
            let mut found = self.groups.iter().filter(|(of, _)| *of == code);
            let (Some((_, text)), None) = (found.next(), found.next()) else {
                panic!("{} does not have one group {code}: {:?}", self.kind, self.groups)
            };
            text
        }

        fn number(&self, code: u16) -> f64 {
            let text = self.text(code);
            // A reader takes a number without a point for a whole one.
            assert!(text.contains('.'), "{text}");
            text.parse().unwrap()
        }

        fn point(&self, first: u16) -> Vector2<f64> {
            assert_eq!(self.number(first + 20), 0.0);
            Vector2::new(self.number(first), self.number(first + 10))
        }

        /// Counter-clockwise if it is an arc.
        fn edge(&self) -> Edge {
            match self.kind.as_str() {
                "LINE" => Edge::Line { from: self.point(10), to: self.point(11) },
                "CIRCLE" => Edge::Arc { centre: self.point(10), radius: self.number(40), start: 0.0, sweep: 2.0 * PI },
                "ARC" => {
                    let [start, end] = [50, 51].map(|code| self.number(code));
                    assert!([start, end].iter().all(|angle| (0.0..=360.0).contains(angle)), "{start} {end}");
                    let [start, sweep] = [start, (end - start).rem_euclid(360.0)].map(f64::to_radians);
                    Edge::Arc { centre: self.point(10), radius: self.number(40), start, sweep }
                }
                other => panic!("{other}"),
            }
        }
    }

    /// The records of a file by their sections: header, tables, entities.
    fn sections(text: &str) -> Vec<(String, Vec<Record>)> {
        let lines: Vec<&str> = text.lines().collect();
        let mut records: Vec<Record> = Vec::new();
        for pair in lines.chunks(2) {
            let [code, value] = pair else { panic!("a code without its value: {pair:?}") };
            let (code, value) = (code.trim().parse().unwrap(), (*value).to_owned());
            match (code, records.last_mut()) {
                (0, _) => records.push(Record { kind: value, groups: Vec::new() }),
                (_, Some(record)) => record.groups.push((code, value)),
                (_, None) => panic!("{code} before any record"),
            }
        }
        assert_eq!(records.pop().map(|last| last.kind).as_deref(), Some("EOF"));
        let mut sections: Vec<(String, Vec<Record>)> = Vec::new();
        let mut is_open = false;
        for record in records {
            match record.kind.as_str() {
                "SECTION" => {
                    assert!(!is_open, "a section in a section");
                    // A header has no records of its own: its groups follow its name.
                    let name = record.groups[0].clone();
                    assert_eq!(name.0, 2);
                    sections.push((name.1, vec![Record { groups: record.groups[1..].to_vec(), ..record }]));
                    is_open = true;
                }
                "ENDSEC" => is_open = false,
                _ => {
                    assert!(is_open, "{} outside of a section", record.kind);
                    sections.last_mut().unwrap().1.push(record);
                }
            }
        }
        assert!(!is_open);
        sections
    }

    #[track_caller]
    fn same(read: &Edge, ours: &Edge, size: f64) {
        match (*read, *ours) {
            (Edge::Line { .. }, Edge::Line { .. }) => assert_eq!(read, ours),
            (
                Edge::Arc { centre, radius, sweep, .. },
                Edge::Arc { centre: our_centre, radius: our_radius, sweep: our_sweep, .. },
            ) => {
                assert_eq!((centre, radius), (our_centre, our_radius));
                assert!((sweep - our_sweep.abs()).abs() < 1e-12, "{read:?} {ours:?}");
                // A whole circle has no ends.
                if our_sweep.abs() >= 2.0 * PI {
                    return;
                }
                let ends = if our_sweep < 0.0 {
                    [ours.end_point(), ours.start_point()]
                } else {
                    [ours.start_point(), ours.end_point()]
                };
                assert!((read.start_point() - ends[0]).norm() < 1e-12 * size, "{read:?} {ours:?}");
                assert!((read.end_point() - ends[1]).norm() < 1e-12 * size, "{read:?} {ours:?}");
            }
            _ => panic!("{read:?} is read, {ours:?} was written"),
        }
    }

    #[test]
    fn a_reader_of_the_format_finds_the_same_lines_and_arcs() {
        for (stations, pins) in [(4, 4), (6, 1), (6, 2), (12, 2), (60, 1)] {
            for (parts, layout) in lists(stations, pins)
                .iter()
                .flat_map(|parts| [PartLayout::Assembled, PartLayout::Apart].map(|layout| (parts, layout)))
            {
                let sections = sections(&dxf(parts, layout));
                let names: Vec<_> = sections.iter().map(|(name, _)| name.as_str()).collect();
                assert_eq!(names, ["HEADER", "TABLES", "ENTITIES"]);
                let header: Vec<_> = sections[0].1[0].groups.iter().map(|(code, of)| (*code, of.as_str())).collect();
                // Release 12, and 4 for millimetres.
                assert_eq!(header, [(9, "$ACADVER"), (1, "AC1009"), (9, "$INSUNITS"), (70, "4")]);

                let tables = &sections[1].1;
                let layers: Vec<_> = tables.iter().filter(|of| of.kind == "LAYER").map(|of| of.text(2)).collect();
                assert_eq!(layers, Layer::ALL.map(Layer::name));
                for (table, name) in [("LTYPE", "CONTINUOUS"), ("LAYER", layers[0])] {
                    let at = tables.iter().position(|of| of.kind == "TABLE" && of.text(2) == table).unwrap();
                    let rows: Vec<_> = tables[at + 1..].iter().take_while(|of| of.kind != "ENDTAB").collect();
                    assert_eq!(tables[at].text(70), rows.len().to_string());
                    assert!(rows.iter().all(|row| row.kind == table) && rows[0].text(2) == name);
                }

                let written = edges(parts, layout);
                let found = &sections[2].1[1..];
                assert_eq!(found.len(), written.len());
                for (entity, (layer, edge)) in found.iter().zip(&written) {
                    assert_eq!(entity.text(8), layer.name());
                    same(&entity.edge(), edge, 100.0);
                }
            }
        }
    }

    /// The entities of a layer.
    fn on(parts: &[Part], layout: PartLayout, layer: Layer) -> Vec<Edge> {
        let sections = sections(&dxf(parts, layout));
        sections[2].1[1..].iter().filter(|of| of.text(8) == layer.name()).map(Record::edge).collect()
    }

    #[test]
    fn a_file_of_bare_parts_has_no_bore_and_a_cross_at_each_axis_and_pin() {
        for (stations, pins) in [(4, 1), (6, 2), (12, 1), (24, 2)] {
            let [bare, _] = lists(stations, pins);
            let circles = |layer| {
                on(&bare, PartLayout::Apart, layer).into_iter().filter_map(|edge| match edge {
                    Edge::Arc { centre, radius, sweep, .. } if sweep >= 2.0 * PI => Some((centre, radius)),
                    _ => None,
                })
            };
            assert_eq!([Layer::Wheel, Layer::LockingDisc].map(|layer| circles(layer).count()), [0, 0]);
            let (plate, _) = circles(Layer::Plate).next().unwrap();
            let crosses: Vec<Vector2<f64>> = on(&bare, PartLayout::Apart, Layer::Centres)
                .chunks(2)
                .map(|pair| {
                    let middle = |edge: &Edge| (edge.start_point() + edge.end_point()) / 2.0;
                    assert!((middle(&pair[0]) - middle(&pair[1])).norm() < 1e-12);
                    middle(&pair[0])
                })
                .collect();
            assert_eq!(crosses.len(), 3 + pins as usize, "wheel, disc, plate and pins");
            let expected = circles(Layer::Pins).map(|(centre, _)| centre).chain([Vector2::zeros(), plate]);
            for centre in expected {
                assert!(crosses.iter().any(|cross| (cross - centre).norm() < 1e-9), "{centre}");
            }
        }
    }

    #[test]
    fn parts_to_be_cut_out_lie_apart() {
        for parts in lists(6, 1) {
            let reach = |layer: Layer| {
                let points = on(&parts, PartLayout::Apart, layer)
                    .into_iter()
                    .flat_map(|edge| geneva_kinematics::wheel::Loop { edges: vec![edge] }.corners(0.01).unwrap());
                points.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), p| (a.min(p.x), b.max(p.x)))
            };
            let all = [Layer::Wheel, Layer::LockingDisc, Layer::Plate, Layer::BasePlate].map(reach);
            for pair in all.windows(2).filter(|pair| pair[1].0.is_finite()) {
                assert!(pair[0].1 < pair[1].0, "{all:?}");
            }
            let (pins, plate) = (reach(Layer::Pins), reach(Layer::Plate));
            assert!(plate.0 < pins.0 && pins.1 < plate.1, "the holes of pins are in the plate");
        }
    }
}
