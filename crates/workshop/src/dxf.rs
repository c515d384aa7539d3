//! A drawing in the exchange format DXF.
//!
//! Release 12 (AC1009), which every program for cutting and milling reads: single `LINE`, `ARC` and `CIRCLE` entities,
//! whose centres, radii and angles stand in the file as they are, not as the bulge of a polyline. Numbers are written
//! with as many digits as give the same number back. The header says that lengths are millimetres.

use crate::drawing::{Layer, Layout, loops};
use geneva_kinematics::wheel::{Edge, Sizes};
use std::f64::consts::PI;
use std::fmt::{Display, Write};

/// The drawing of both parts.
pub fn dxf(sizes: &Sizes, layout: Layout) -> String {
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
    for (layer, of) in loops(sizes, layout) {
        of.edges.iter().for_each(|edge| file.entity(layer, edge));
    }
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
        // A whole number is written with its point, and no zero with a sign.
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
    use ::dxf::Drawing;
    use ::dxf::entities::EntityType;
    use geneva_kinematics::wheel::{Choices, Loop, Scale, Wheel};
    use nalgebra::Vector2;

    fn sizes(stations: u32, pins: u32) -> Sizes {
        let wheel = Wheel::with_pins(stations, pins).unwrap();
        Sizes::new(wheel, Scale::CrankRadius(50.0), &Choices::default()).unwrap()
    }

    /// An edge as a reader finds it: counter-clockwise if it is an arc.
    fn read(entity: &EntityType) -> Edge {
        let point = |p: &::dxf::Point| Vector2::new(p.x, p.y);
        match entity {
            EntityType::Line(line) => Edge::Line { from: point(&line.p1), to: point(&line.p2) },
            EntityType::Circle(circle) => {
                Edge::Arc { centre: point(&circle.center), radius: circle.radius, start: 0.0, sweep: 2.0 * PI }
            }
            EntityType::Arc(arc) => {
                let sweep = (arc.end_angle - arc.start_angle).rem_euclid(360.0);
                let [start, sweep] = [arc.start_angle, sweep].map(f64::to_radians);
                Edge::Arc { centre: point(&arc.center), radius: arc.radius, start, sweep }
            }
            other => panic!("{other:?}"),
        }
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
                let ends = if our_sweep < 0.0 { [ours.to(), ours.from()] } else { [ours.from(), ours.to()] };
                assert!((read.from() - ends[0]).norm() < 1e-12 * size, "{read:?} {ours:?}");
                assert!((read.to() - ends[1]).norm() < 1e-12 * size, "{read:?} {ours:?}");
            }
            _ => panic!("{read:?} is read, {ours:?} was written"),
        }
    }

    #[test]
    fn another_reader_finds_the_same_lines_and_arcs() {
        for (stations, pins) in [(3, 1), (4, 4), (6, 1), (6, 2), (12, 2), (60, 1)] {
            let sizes = sizes(stations, pins);
            for layout in [Layout::Assembled, Layout::Apart] {
                let text = dxf(&sizes, layout);
                let drawing = Drawing::load(&mut text.as_bytes()).unwrap();
                assert_eq!(drawing.header.default_drawing_units, ::dxf::enums::Units::Millimeters);
                let written: Vec<(Layer, Edge)> = loops(&sizes, layout)
                    .into_iter()
                    .flat_map(|(layer, of): (Layer, Loop)| of.edges.into_iter().map(move |edge| (layer, edge)))
                    .collect();
                let found: Vec<_> = drawing.entities().collect();
                assert_eq!(found.len(), written.len());
                for (entity, (layer, edge)) in found.into_iter().zip(&written) {
                    assert_eq!(entity.common.layer, layer.name());
                    same(&read(&entity.specific), edge, sizes.centre_distance);
                }
                let layers: Vec<_> = drawing.layers().map(|layer| layer.name.clone()).collect();
                for layer in Layer::ALL {
                    assert!(layers.contains(&layer.name().to_owned()), "{layers:?}");
                }
            }
        }
    }

    #[test]
    fn parts_to_be_cut_out_lie_apart() {
        let sizes = sizes(6, 1);
        let right_of = |layer: Layer| {
            let all = loops(&sizes, Layout::Apart);
            let points = all.iter().filter(|(of, _)| *of == layer).flat_map(|(_, of)| of.corners(0.01).unwrap());
            points.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), p| (a.min(p.x), b.max(p.x)))
        };
        assert!(right_of(Layer::Wheel).1 < right_of(Layer::LockingDisc).0);
        assert!(right_of(Layer::LockingDisc).1 < right_of(Layer::Plate).0);
        assert!(right_of(Layer::Plate).0 < right_of(Layer::Pins).0);
    }
}
