//! The views of all parts with their sizes.

use super::callout::{Row, Side};
use super::dimension::{Measured, PrintedDimension};
use super::drawn_sizes::DrawnSizes;
use super::ink::Pen;
use super::length::mm;
use super::limits::{BORE, DISC, Limits, RIM, SLOT, general_tolerance, to_micrometres};
use super::making::Making;
use super::view::{Target, View, on_circle, pocket_rows, polylines};
use crate::geometry::{Point, direction, point_along};
use crate::parts::{Hole, HolePurpose, Layer, Part, PinMount, ScrewHole};
use geneva_kinematics::indexing::Indexing;
use geneva_kinematics::wheel::{Edge, LockingDisc, Loop, Sizes, ToleranceClass, ToleranceLetter};
use std::f64::consts::{FRAC_PI_2, PI};

/// Turned so, what is on the first axis points up.
pub(super) const UPRIGHT: f64 = FRAC_PI_2;
/// Below the view's right, and above its left, in radians: where leaders find a rim.
pub(super) const LOWER_RIGHT: f64 = -0.2 * PI;
/// A crescent's centre that is farther from the axis, over the disc's radius, is given in words.
const FAR: f64 = 1.4;
/// Length of a pin's chamfers over its diameter: our choice.
const CHAMFER: f64 = 0.05;

impl Making<'_> {
    /// The view of a part.
    pub(super) fn view(&self, part: &Part) -> View {
        match (part.layer, self.sizes) {
            (Layer::Wheel, DrawnSizes::External(sizes)) => self.wheel(part, sizes),
            (Layer::LockingDisc, DrawnSizes::External(sizes)) => self.disc(part, sizes),
            (Layer::Wheel, DrawnSizes::Internal(sizes)) => self.ring(part, sizes),
            (Layer::RingPlate, DrawnSizes::Internal(sizes)) => self.ring_plate(part, sizes),
            (Layer::LockingSegment, DrawnSizes::Internal(sizes)) => self.segment(part, sizes),
            (Layer::Pins, _) => self.pin(part),
            (Layer::BasePlate, _) => self.base(part),
            _ => self.plate(part),
        }
    }

    /// The rows about the slots of a wheel, of this width in millimetres.
    pub(super) fn slot_rows(&self, width: f64) -> Vec<Row> {
        let wheel = self.sizes.indexing();
        let slot = PrintedDimension::new(Measured::SlotWidth, &format!("{}× ", wheel.stations()), width, "")
            .limited(self.held(Limits::class(SLOT, width), [self.chain.width, f64::INFINITY]));
        vec![
            Row::Size(slot),
            self.position("", self.chain.slot_zone, &["A"]),
            Row::Words(format!("at exact {}°", mm(2.0 * wheel.half_pitch_angle().to_degrees()))),
            Row::Datum("B"),
        ]
    }

    /// The rows about the end of a slot of this width, in millimetres: `chain` is what a tolerance chain leaves below and above.
    pub(super) fn slot_end_rows(&self, width: f64, chain: [f64; 2]) -> Vec<Row> {
        let end = PrintedDimension::new(Measured::SlotEnd, "", self.sizes.slot_end(), "");
        let general = general_tolerance(self.sizes.slot_end());
        let end = end.limited(self.held(Limits::new([-general, general]), chain));
        let radius = PrintedDimension::new(Measured::SlotEndRadius, "slot end R", width / 2.0, "");
        vec![Row::Size(end), Row::Size(radius)]
    }

    /// The rows about the locking arcs of a wheel, of this radius in millimetres.
    pub(super) fn arc_rows(&self, radius: f64) -> Vec<Row> {
        let many = format!("{}× R", self.sizes.indexing().stations());
        let limits = self.held_radius(Limits::of_radius(SLOT, radius), [self.chain.locking, f64::INFINITY]);
        let arc = PrintedDimension::new(Measured::LockingArc, &many, radius, "").limited(limits);
        let centres = 2.0 * self.sizes.centre_distance();
        let centres = PrintedDimension::new(Measured::LockingArcCentres, "centres on exact Ø", centres, "");
        vec![
            Row::Size(arc),
            self.position("Ø", self.chain.arc_zone, &["A", "B"]),
            Row::Size(centres),
            Row::Words("midway between slots".to_owned()),
        ]
    }

    fn wheel(&self, part: &Part, sizes: &Sizes) -> View {
        let mut view = View::new(part, UPRIGHT);
        let half = sizes.slot_width / 2.0;
        let corner = |x: f64| Point::new(x, sizes.wheel_radius - sizes.mouth_length());
        view.add(Target::Across([corner(-half), corner(half)]), Side::Right, self.slot_rows(sizes.slot_width));
        view.add(
            Target::Along([Point::zeros(), Point::new(0.0, sizes.slot_end)]),
            Side::Left,
            self.slot_end_rows(sizes.slot_width, [f64::INFINITY, self.chain.slot_end]),
        );
        let arc = nearest_arc(&view.part.outer, sizes.locking_arc_radius, direction(0.12 * PI));
        view.add(Target::Edge(arc), Side::Right, self.arc_rows(sizes.locking_arc_radius));
        let rim = rim_point(&view.part.outer, sizes.tip_radius, direction(LOWER_RIGHT));
        let rim_size = PrintedDimension::new(Measured::Rim, "Ø", 2.0 * sizes.tip_radius, "");
        let mut rows = vec![
            Row::Size(rim_size.limited(self.held(Limits::class(RIM, 2.0 * sizes.tip_radius), [f64::INFINITY; 2]))),
            self.thickness(part),
        ];
        if !view.has_bore() {
            rows.insert(1, Row::Datum("A"));
        }
        view.add(Target::Edge(rim), Side::Right, rows);
        self.add_mouth(&mut view, sizes);
        view.add_holes(self);
        view.notes.push(self.surface("Slot walls, locking arcs", 1.6));
        if self.is_machined() {
            view.notes.push("Corners of mouths: 0.1 at most.".to_owned());
        }
        view
    }

    /// The mouths of the slots where they are not sharp: on the left of the upper slot.
    fn add_mouth(&self, view: &mut View, sizes: &Sizes) {
        let Some(face) = sizes.mouth_face() else { return };
        let length = PrintedDimension::new(Measured::MouthLength, "mouths ", sizes.mouth_length(), " along the slot");
        let shape = match face {
            Edge::Line { from, to } => {
                let angle = libm::atan2(to.y - from.y, to.x - from.x).to_degrees();
                Row::Words(format!("chamfer {}° to the wall", mm(angle)))
            }
            Edge::Arc { radius, .. } => {
                Row::Size(PrintedDimension::new(Measured::MouthRadius, "from the wall R", radius, ""))
            }
        };
        let middle = point_along(&face, 0.5);
        view.add(Target::Edge(Point::new(-middle.y, middle.x)), Side::Left, vec![Row::Size(length), shape]);
    }

    fn disc(&self, part: &Part, sizes: &Sizes) -> View {
        let mut view = View::new(part, UPRIGHT);
        let Some(disc) = sizes.locking_disc else { return view };
        let pins = sizes.wheel.pins();
        let cut = disc.crescent;
        let many = if pins > 1 { format!("{pins}× ") } else { String::new() };
        let rim = rim_point(&view.part.outer, disc.radius, direction(LOWER_RIGHT));
        let size = PrintedDimension::new(Measured::Disc, "Ø", 2.0 * disc.radius, "");
        let limits = self.held(Limits::class(DISC, 2.0 * disc.radius), [f64::INFINITY, 2.0 * self.chain.locking]);
        let mut rows = vec![Row::Size(size.limited(limits)), self.thickness(part)];
        if !view.has_bore() {
            rows.insert(1, Row::Datum("A"));
        }
        view.add(Target::Edge(rim), Side::Right, rows);

        let shift = crescent_shift(&disc);
        let wider = Limits::class(SLOT, 2.0 * cut.radius);
        let limits = Limits::new([2.0 * shift, 2.0 * shift + to_micrometres(wider.upper / 2.0)]);
        let limits = self.held_radius(limits, [f64::INFINITY; 2]);
        let radius = PrintedDimension::new(Measured::Crescent, &format!("{many}R"), cut.radius, "").limited(limits);
        let to = cut_point(&disc);
        let place = self.position_of_crescent(2.0 * shift);
        let mut rows = vec![Row::Size(radius), place];
        let centre = |before: &str| Row::Size(PrintedDimension::new(Measured::CrescentCentre, before, cut.centre, ""));
        let is_far = cut.centre > FAR * disc.radius;
        if is_far {
            rows.push(centre("centre at exact "));
        }
        if pins > 1 {
            rows.push(Row::Words(format!("at exact {}°", mm(360.0 / f64::from(pins)))));
        }
        view.add(Target::Edge(to), Side::Right, rows);
        if !is_far {
            view.add(
                Target::Along([Point::zeros(), Point::new(0.0, cut.centre)]),
                Side::Left,
                vec![centre("exact "), Row::Words("to crescent's centre".to_owned())],
            );
        }
        let [y, x] = [libm::cos(cut.half_angle), libm::sin(cut.half_angle)].map(|part| part * disc.radius);
        let opening = PrintedDimension::new(Measured::Opening, "(", 2.0 * x, ")");
        view.add(
            Target::Across([Point::new(-x, y), Point::new(x, y)]),
            Side::Left,
            vec![Row::Size(opening), Row::Words("opening, for checking".to_owned())],
        );
        view.add_holes(self);
        view.notes.push(self.surface("Rim", 1.6));
        if self.is_machined() {
            view.notes.push("Edges of the opening: 0.1 at most.".to_owned());
        }
        let to = self.limits.process.map_or(shift, |numbers| shift.max(numbers.error.value / 2.0));
        view.notes.push(format!("On the plate: crescent's centre in line with axis and pin to {}.", mm(to)));
        if !self.is_one_piece() && self.mounting.disc_dowels.is_none() && self.mounting.driver_hub.is_none() {
            view.notes
                .push("No dowels or screws are drawn: bond the disc to the plate, or drill both together.".to_owned());
        }
        view
    }

    fn plate(&self, part: &Part) -> View {
        let (sizes, chain) = (self.sizes, &self.chain);
        let pins = sizes.pins();
        let many = if pins > 1 { format!("{pins}× ") } else { String::new() };
        let mut view = View::new(part, UPRIGHT);
        let rim = direction(LOWER_RIGHT) * sizes.plate_radius();
        let mut rows = vec![
            Row::Size(PrintedDimension::new(Measured::Plate, "Ø", 2.0 * sizes.plate_radius(), "")),
            self.thickness(part),
        ];
        if !view.has_bore() {
            rows[0] = Row::Size(
                PrintedDimension::new(Measured::Plate, "Ø", 2.0 * sizes.plate_radius(), "")
                    .limited(self.held(Limits::class(RIM, 2.0 * sizes.plate_radius()), [f64::INFINITY; 2])),
            );
            rows.insert(1, Row::Datum("A"));
        }
        view.add(Target::Edge(rim), Side::Right, rows);
        let crank = PrintedDimension::new(Measured::CrankRadius, "", sizes.crank_radius(), "");
        let limits = self.held_place([chain.crank; 2]);
        view.add(
            Target::Along([Point::zeros(), Point::new(0.0, sizes.crank_radius())]),
            Side::Left,
            vec![Row::Size(crank.limited(limits))],
        );
        let hole = view
            .part
            .holes
            .iter()
            .find(|hole| matches!(hole.purpose, HolePurpose::Pin | HolePurpose::PinScrew))
            .cloned();
        if let Some(hole) = hole
            && let Some(diameter) = hole.diameter()
        {
            let size = |measured| PrintedDimension::new(measured, &format!("{many}Ø"), diameter, "");
            let free = [f64::INFINITY; 2];
            let mut rows = match self.mounting.pins {
                _ if self.has_solid_pins() => {
                    let height = self.pin_height(part.thickness);
                    let limits = self.held(Limits::class(DISC, diameter), [f64::INFINITY, chain.width]);
                    let height = PrintedDimension::new(Measured::PinLength, "above the plate h = ", height, "")
                        .limited(self.height(height));
                    vec![Row::Size(size(Measured::Pin).limited(limits)), Row::Size(height)]
                }
                PinMount::Screw(_, ScrewHole::Tapped) => vec![Row::Size(size(Measured::PinHole))],
                PinMount::Screw(..) => {
                    vec![Row::Size(size(Measured::PinHole).limited(self.held(Limits::class(BORE, diameter), free)))]
                }
                PinMount::Solid | PinMount::Dowel => {
                    let limits = Limits::class(chain.pin_classes(diameter)[1], diameter);
                    vec![Row::Size(size(Measured::PinHole).limited(self.held(limits, free)))]
                }
            };
            if pins > 1 {
                rows.push(Row::Words(format!("at {}°", mm(360.0 / f64::from(pins)))));
            }
            rows.extend(pocket_rows(&hole));
            view.add(Target::Edge(on_circle(&hole, Side::Right, 0.6)), Side::Right, rows);
        }
        view.circles.push(sizes.crank_radius());
        view.add_holes(self);
        view.notes.push(match self.mounting.pins {
            _ if self.has_solid_pins() => self.surface("Pins", 1.6),
            PinMount::Screw(thread, hole) => {
                let tapped = if hole == ScrewHole::Tapped {
                    format!("Holes of pins tapped {0}. ", thread.name())
                } else {
                    String::new()
                };
                let pins = if thread.diameter() == sizes.pin_diameter() {
                    format!("Pins: the shanks of screws {}.", thread.name())
                } else {
                    format!("Pins: bushes Ø{} on screws {}.", mm(sizes.pin_diameter()), thread.name())
                };
                tapped + &pins
            }
            _ if self.is_machined() => "Pins pressed or bonded in, square within 0.01 on 10.".to_owned(),
            _ => "Holes fitted to the pins; pins pressed or bonded in, square.".to_owned(),
        });
        let standing = match self.sizes {
            DrawnSizes::External(sizes) => sizes.outline().disc.map(|disc| (disc, "disc")),
            DrawnSizes::Internal(sizes) => Some((sizes.outline().segment, "segment")),
        };
        if let (true, Some((face, name))) = (self.is_one_piece(), standing) {
            let standing = face.outer.transform(UPRIGHT, Point::zeros());
            view.lines.extend(polylines(Pen::Thick, &standing));
            view.notes.push(format!("The locking {name} on it has a sheet of its own."));
        }
        view
    }

    fn pin(&self, part: &Part) -> View {
        let (radius, length) = (self.sizes.pin_diameter() / 2.0, part.thickness);
        // From the side: the outline is that of its middle plane.
        let mut side = part.clone();
        let cut = chamfer(2.0 * radius);
        let p = Point::new;
        let corners = [
            p(0.0, cut - radius),
            p(cut, -radius),
            p(length - cut, -radius),
            p(length, cut - radius),
            p(length, radius - cut),
            p(length - cut, radius),
            p(cut, radius),
            p(0.0, radius - cut),
        ];
        let line = |k: usize| Edge::Line { from: corners[k], to: corners[(k + 1) % 8] };
        side.outer = Loop { edges: (0..8).map(line).collect() };
        side.marks = Vec::new();
        side.holes = Vec::new();
        let mut view = View::new(&side, 0.0);
        let diameter = 2.0 * radius;
        let classes = self.chain.pin_classes(diameter);
        let class = if part.is_bush() { DISC } else { classes[0] };
        let limits = self.held(Limits::class(class, diameter), [f64::INFINITY, self.chain.width.max(0.0)]);
        let size = PrintedDimension::new(Measured::Pin, "Ø", diameter, "").limited(limits);
        view.add(Target::Along([p(cut, -radius), p(cut, radius)]), Side::Left, vec![Row::Size(size)]);
        let across = Target::Across([p(0.0, radius - cut), p(length, radius - cut)]);
        let long = PrintedDimension::new(Measured::PinLength, "", length, "");
        // A bush that is too short would let its screw's head hold the wheel.
        let limits = match part.is_bush() {
            true => Limits { lower: 0.0, ..self.general(length) },
            false => self.height(length),
        };
        view.add(across, Side::Right, vec![Row::Size(long.limited(limits))]);
        if let Some(inner) = part.holes.first().and_then(Hole::diameter) {
            let half = inner / 2.0;
            view.lines.extend([-half, half].map(|y| (Pen::Hidden, vec![p(0.0, y), p(length, y)])));
            let size = PrintedDimension::new(Measured::PinHole, "Ø", inner, " through");
            view.add(Target::Edge(p(0.0, -half)), Side::Left, vec![Row::Size(size)]);
        }
        view.add(
            Target::Edge(p(length - cut / 2.0, cut / 2.0 - radius)),
            Side::Right,
            vec![Row::Words(format!("2× {} × 45°", mm(cut)))],
        );
        view.notes.push(self.pin_surface(if part.is_bush() { "Outside" } else { "Surface of the pin" }));
        if part.is_bush() {
            if let PinMount::Screw(thread, _) = self.mounting.pins {
                view.notes.push(format!("For a screw {}; the bush stands on the plate.", thread.name()));
            }
        } else if classes[0].letter == ToleranceLetter::LowerM || !self.is_machined() {
            view.notes.push("A dowel as ISO 8734 of this diameter will do.".to_owned());
        } else {
            view.notes.push("The slots leave no room for dowels of class m6.".to_owned());
        }
        view
    }

    fn base(&self, part: &Part) -> View {
        let (sizes, chain) = (self.sizes, &self.chain);
        let mut view = View::new(part, 0.0);
        let [least, greatest] = view.extent();
        let axes = PrintedDimension::new(Measured::AxisDistance, "", sizes.centre_distance(), "");
        let limits = self.held_place(chain.axes);
        view.add(
            Target::Across([Point::zeros(), Point::new(sizes.centre_distance(), 0.0)]),
            Side::Right,
            vec![Row::Size(axes.limited(limits))],
        );
        let (length, width) = (greatest.x - least.x, greatest.y - least.y);
        view.add(
            Target::Across([Point::new(least.x, 0.0), Point::new(greatest.x, 0.0)]),
            Side::Left,
            vec![Row::Size(PrintedDimension::new(Measured::BaseLength, "", length, ""))],
        );
        view.add(
            Target::Across([Point::new(least.x, 0.0), Point::zeros()]),
            Side::Left,
            vec![Row::Size(PrintedDimension::new(Measured::AxisPlace, "", -least.x, ""))],
        );
        view.add(
            Target::Along([Point::new(0.0, least.y), Point::new(0.0, greatest.y)]),
            Side::Left,
            vec![Row::Size(PrintedDimension::new(Measured::BaseWidth, "", width, "")), self.thickness(part)],
        );
        let bores: Vec<_> = view.part.holes.iter().filter(|hole| hole.purpose == HolePurpose::Bore).cloned().collect();
        for (hole, side) in bores.iter().map(|hole| (hole, if hole.centre.x > 0.0 { Side::Right } else { Side::Left }))
        {
            let Some(diameter) = hole.diameter() else { continue };
            let limits = self.held_bore(diameter);
            let mut rows = vec![Row::Size(PrintedDimension::new(Measured::Bore, "Ø", diameter, "").limited(limits))];
            rows.push(self.shaft_row(diameter));
            rows.extend(pocket_rows(hole));
            view.add(Target::Edge(on_circle(hole, side, -0.5)), side, rows);
        }
        let fixing: Vec<_> =
            view.part.holes.iter().filter(|hole| hole.purpose == HolePurpose::Fixing).cloned().collect();
        let corner = fixing.iter().max_by(|a, b| (a.centre.x - a.centre.y).total_cmp(&(b.centre.x - b.centre.y)));
        if let Some((hole, diameter)) = corner.and_then(|hole| Some((hole, hole.diameter()?))) {
            let reach = |of: fn(&Point) -> f64| {
                let places = || fixing.iter().map(|hole| of(&hole.centre));
                places().fold(f64::NEG_INFINITY, f64::max) - places().fold(f64::INFINITY, f64::min)
            };
            let size =
                |measured, before: &str, nominal| Row::Size(PrintedDimension::new(measured, before, nominal, ""));
            let rows = vec![
                size(Measured::FixingHole, &format!("{}× Ø", fixing.len()), diameter),
                size(Measured::FixingLength, "apart ", reach(|p| p.x)),
                size(Measured::FixingWidth, "and across ", reach(|p| p.y)),
            ];
            view.add(Target::Edge(on_circle(hole, Side::Right, 0.4)), Side::Right, rows);
        }
        if let Some(Edge::Arc { centre, radius, .. }) = view.part.outer.edges.first() {
            let at = *centre + direction(0.25 * PI) * *radius;
            let size = PrintedDimension::new(Measured::BaseCorner, "4× R", *radius, "");
            let mut rows = vec![Row::Size(size)];
            if !fixing.is_empty() {
                rows.push(Row::Words("about the holes".to_owned()));
            }
            view.add(Target::Edge(at), Side::Right, rows);
        }
        view
    }
}

/// A pin's chamfer in millimetres: in tenths, or in hundredths for thin pins.
fn chamfer(diameter: f64) -> f64 {
    let step = if diameter < 10.0 { 100.0 } else { 10.0 };
    libm::floor(CHAMFER * diameter * step) / step
}

/// How far the middle of a crescent may be off its place, in millimetres: half of the grade IT8 of its distance, our choice. The
/// crescent's radius is larger by twice as much at least, for its place on the disc and for the disc's on the plate; so it holds
/// the crescent that was found to be large enough.
pub(super) fn crescent_shift(disc: &LockingDisc) -> f64 {
    let class = ToleranceClass { letter: ToleranceLetter::UpperJs, grade: 8 };
    let shift = to_micrometres(Limits::class(class, disc.crescent.centre).upper / 2.0);
    shift.max(0.001)
}

/// A point of the crescent that is cut out before the upper pin, to the right of its middle.
fn cut_point(disc: &LockingDisc) -> Point {
    let cut = disc.crescent;
    let (x, y) = (disc.radius * libm::sin(cut.half_angle), disc.radius * libm::cos(cut.half_angle));
    // From straight down, a good part of the way to the edge of the opening.
    let to_edge = libm::atan2(x, cut.centre - y);
    Point::new(0.0, cut.centre) + direction(0.6 * to_edge - FRAC_PI_2) * cut.radius
}

/// The middle of that arc of a radius whose middle is nearest to a direction.
pub(super) fn nearest_arc(of: &Loop, wanted: f64, towards: Point) -> Point {
    let middles = of.edges.iter().filter_map(|edge| match *edge {
        Edge::Arc { centre, radius, start, sweep }
            if (radius - wanted).abs() < 1e-9 * wanted && centre.norm() > radius =>
        {
            Some(centre + direction(start + sweep / 2.0) * radius)
        }
        _ => None,
    });
    middles.max_by(|a, b| a.normalize().dot(&towards).total_cmp(&b.normalize().dot(&towards))).unwrap_or_default()
}

/// The middle of that arc about the axis whose middle is nearest to a direction, or the place there if the arc passes it.
pub(super) fn rim_point(of: &Loop, wanted: f64, towards: Point) -> Point {
    let places = of.edges.iter().filter_map(|edge| match *edge {
        Edge::Arc { centre, radius, start, sweep }
            if centre.norm() < 1e-9 && (radius - wanted).abs() < 1e-9 * wanted =>
        {
            let aim = libm::atan2(towards.y, towards.x);
            // In the middle of a short piece, clear of its corners.
            let passes = sweep.abs() > 1.0 && crate::geometry::into_arc(start, sweep, aim) <= sweep.abs();
            Some(if passes { towards * radius } else { direction(start + sweep / 2.0) * radius })
        }
        _ => None,
    });
    places.max_by(|a, b| a.normalize().dot(&towards).total_cmp(&b.normalize().dot(&towards))).unwrap_or_default()
}
