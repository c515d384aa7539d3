//! The first sheet: all parts in place, with the distance of the axes and the list of the parts.

use super::callout::{Row, Side};
use super::dimension::{Measured, PrintedDimension};
use super::ink::Pen;
use super::length::mm;
use super::making::Making;
use super::text::SheetText;
use super::view::{Target, View, polylines};
use crate::geometry::{Point, direction, encloses, turned};
use crate::parts::{HolePurpose, Layer, Part, Place};
use geneva_kinematics::wheel::Loop;
use std::f64::consts::PI;

/// A part in its place, with what hides it.
struct Placed<'a> {
    part: &'a Part,
    outer: Loop,
    /// The hollow of a ring.
    inside: Option<Loop>,
    at: Point,
}

impl<'a> Placed<'a> {
    fn new(part: &'a Part, place: &Place) -> Self {
        let inside = part.holes.iter().find(|hole| hole.purpose == HolePurpose::Inside);
        let moved = |of: &Loop| of.transform(place.turn, place.at);
        Self { part, outer: moved(&part.outer), inside: inside.map(|hole| moved(&hole.outline)), at: place.at }
    }

    /// Whether it hides what is below it at a point.
    fn covers(&self, p: Point) -> bool {
        encloses(&self.outer, p) && !self.inside.as_ref().is_some_and(|inside| encloses(inside, p))
    }

    /// Its place that is farthest in a direction.
    fn edge(&self, towards: f64) -> Point {
        let aim = direction(towards);
        let points = polylines(Pen::Thick, &self.outer).flat_map(|(_, points)| points);
        points
            .max_by(|a, b| {
                let along = |p: &Point| p.dot(&aim);
                along(a).total_cmp(&along(b))
            })
            .unwrap_or(self.at)
    }
}

/// Lines that are seen or hidden by the outlines above them.
fn seen(of: &Loop, above: &[&Placed<'_>]) -> Vec<(Pen, Vec<Point>)> {
    let mut lines: Vec<(Pen, Vec<Point>)> = Vec::new();
    for (_, points) in polylines(Pen::Thick, of) {
        for pair in points.windows(2) {
            let middle = (pair[0] + pair[1]) / 2.0;
            let pen = if above.iter().any(|part| part.covers(middle)) { Pen::Hidden } else { Pen::Thick };
            match lines.last_mut() {
                Some((last, line)) if *last == pen && line.last() == Some(&pair[0]) => line.push(pair[1]),
                _ => lines.push((pen, pair.to_vec())),
            }
        }
    }
    lines
}

impl Making<'_> {
    /// All parts in place, from the wheel's side, in the middle of a dwell.
    pub(super) fn assembly(&self, list: &[Part], text: &SheetText<'_>) -> Option<View> {
        let wheel = list.iter().find(|part| part.layer == Layer::Wheel)?;
        let mut view = View::new(wheel, wheel.places.first()?.turn);
        let all = |part| -> Vec<Placed<'_>> {
            let part: &Part = part;
            part.places.iter().map(|place| Placed::new(part, place)).collect()
        };
        let placed: Vec<Placed<'_>> = list.iter().flat_map(all).collect();
        let of = |layer: Layer| placed.iter().filter(move |placed| placed.part.layer == layer);
        let in_layers = |layers: &[Layer]| -> Vec<&Placed<'_>> { layers.iter().flat_map(|layer| of(*layer)).collect() };
        let above_plate = in_layers(&[Layer::Wheel, Layer::LockingDisc, Layer::LockingSegment]);
        let above_base = in_layers(&[Layer::Wheel, Layer::LockingDisc, Layer::Plate]);
        for placed in &placed {
            match placed.part.layer {
                // The ring plate would hide all others.
                Layer::Wheel | Layer::RingPlate => {}
                Layer::LockingDisc | Layer::LockingSegment | Layer::Pins => {
                    view.lines.extend(polylines(Pen::Thick, &placed.outer))
                }
                Layer::BasePlate => view.lines.extend(seen(&placed.outer, &above_base)),
                _ => view.lines.extend(seen(&placed.outer, &above_plate)),
            }
        }
        let holes = list.iter().filter(|part| part.layer != Layer::Wheel).flat_map(|part| {
            let place = part.places.first();
            let is_top = |layer| layer == Layer::LockingDisc || layer == Layer::Pins;
            place
                .into_iter()
                .flat_map(move |place| part.holes.iter().filter(move |_| is_top(part.layer)).map(|hole| (hole, *place)))
        });
        let bores: Vec<Loop> = holes.map(|(hole, place)| hole.outline.transform(place.turn, place.at)).collect();
        bores.iter().for_each(|bore| view.lines.extend(polylines(Pen::Thick, bore)));
        let driver = Point::new(self.sizes.centre_distance(), 0.0);
        view.part.marks.push(driver);

        let axes = PrintedDimension::new(Measured::AxisDistance, "", self.sizes.centre_distance(), "");
        view.add(
            Target::Across([Point::zeros(), driver]),
            Side::Right,
            vec![Row::Size(axes.limited(self.held_place(self.chain.axes)))],
        );
        self.add_list(&mut view, list, &placed, text);
        view.notes.push(format!(
            "Axial play between wheel and plate: {}. Drawn in the middle of a dwell, from the wheel's side{}.",
            mm(self.axial_play()),
            if self.sizes.is_internal() { ", without the ring plate" } else { "" }
        ));
        Some(view)
    }

    /// The list of parts, each with a leader to where it is.
    fn add_list(&self, view: &mut View, list: &[Part], placed: &[Placed<'_>], text: &SheetText<'_>) {
        let mut number = 0;
        for part in list.iter().filter(|part| !part.is_joined) {
            number += 1;
            let Some(first) = placed.iter().find(|placed| placed.part.layer == part.layer) else { continue };
            // The plate beside wheel and pins; what is below, at its far corner.
            let (target, side) = match part.layer {
                Layer::Wheel => (first.edge(0.85 * PI), Side::Left),
                Layer::RingPlate => (first.edge(1.15 * PI), Side::Left),
                Layer::LockingDisc => (first.edge(-0.45 * PI), Side::Right),
                Layer::LockingSegment => (first.edge(-0.2 * PI), Side::Right),
                Layer::Pins => (first.at + direction(0.15 * PI) * (self.sizes.pin_diameter() / 2.0), Side::Right),
                Layer::BasePlate => (first.edge(-0.22 * PI), Side::Right),
                _ => (first.at + turned(direction(0.25 * PI) * self.sizes.plate_radius(), 0.0), Side::Right),
            };
            let material = text.material(part.layer);
            let pieces =
                if part.quantity() == 1 { "1 piece".to_owned() } else { format!("{} pieces", part.quantity()) };
            let mut rows = vec![Row::Words(format!("{number}  {}", self.listed_name(part)))];
            rows.extend(self.joined_names(part, list).map(Row::Words));
            rows.push(Row::Words(format!("{pieces}, {}", material.name)));
            let size = if part.is_cut() { "t = " } else { "length " };
            let on_it = list
                .iter()
                .find(|other| other.is_joined && matches!(other.layer, Layer::LockingDisc | Layer::LockingSegment));
            let on_it = on_it.filter(|_| part.layer == Layer::Plate);
            let on_it = on_it.map_or_else(String::new, |disc| format!(" + {}", mm(disc.thickness)));
            rows.push(Row::Words(format!("{size}{}{on_it}", mm(part.thickness))));
            view.add(Target::Edge(target), side, rows);
        }
    }

    fn listed_name(&self, part: &Part) -> &'static str {
        match part.layer {
            Layer::Plate if self.is_one_piece() => "Driver",
            Layer::Plate => "Driver plate",
            Layer::LockingDisc => "Locking disc",
            Layer::RingPlate => "Ring plate, not drawn",
            _ => self.name(part),
        }
    }

    /// What is in one piece with the plate.
    fn joined_names(&self, part: &Part, list: &[Part]) -> Option<String> {
        let joined = list.iter().filter(|other| other.is_joined).map(|other| other.words());
        let names: Vec<&str> = std::iter::once("plate").chain(joined).collect();
        (part.layer == Layer::Plate && names.len() > 1).then(|| format!("{} in one piece", names.join(", ")))
    }
}
