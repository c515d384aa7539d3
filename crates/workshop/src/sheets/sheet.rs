//! A sheet for each part: its view, callouts, notes and title block.

use super::callout::{Callout, Side, draw_columns};
use super::dimension::PrintedDimension;
use super::drawn_sizes::DrawnSizes;
use super::ink::{Ink, Pen};
use super::length::mm;
use super::limits::{Chain, LimitOrigin, whole_micrometres};
use super::making::{Making, SheetLimits};
use super::paper::{DrawingScale, Paper};
use super::text::SheetText;
use super::title::{Title, frame};
use super::view::{Feature, Target, View};
use crate::geometry::Point;
use crate::parts::{Layer, Mounting, MountingError, Part, internal_parts, parts};
use geneva_kinematics::internal_sizes::InternalSizes;
use geneva_kinematics::wheel::{Edge, Loop, Sizes};

/// Between a part and the first dimension line, and between dimension lines, in millimetres on paper.
const LANE: f64 = 8.0;
/// Between callouts and what is drawn, in millimetres on paper.
const GAP: f64 = 8.0;
/// How much of the room a part fills at most that is drawn larger than it is.
const ENLARGED: f64 = 0.7;
/// From a part or its outermost dimension line to the callouts beside it, in millimetres on paper.
const LEADER: f64 = 18.0;
/// PrintedDimension lines shorter than this have their arrows outside, in millimetres on paper.
const NARROW: f64 = 9.0;

/// How far a centre line goes on beyond the part, in millimetres on paper.
const BEYOND: f64 = 3.0;
/// How far a dimension line goes on beyond its ends, in millimetres on paper.
const OUTSIDE: f64 = 6.0;

/// Below this, in millimetres, a limit is said to be fine: what good milling holds, our choice.
const FINE: f64 = 0.01;

/// A sheet with the drawing of one part, or of all in place.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct Sheet {
    /// Which part it shows; none for all in place.
    pub layer: Option<Layer>,
    /// Its paper.
    pub paper: Paper,
    /// Its scale.
    pub scale: DrawingScale,
    /// All dimensions on it.
    pub dimensions: Vec<PrintedDimension>,
    pub(super) ink: Ink,
    #[cfg_attr(not(test), expect(dead_code, reason = "the tests look at it"))]
    pub(super) has_room: bool,
}

impl Sheet {
    /// The sheet as an SVG file, whose unit is a millimetre on paper.
    pub fn svg(&self) -> String {
        let [width, height] = self.paper.size();
        format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}mm\" height=\"{height}mm\" viewBox=\"0 0 {width} {height}\">\n{}</svg>\n",
            self.markup()
        )
    }

    pub(super) fn markup(&self) -> String {
        let [width, height] = self.paper.size();
        let words = self.layer.map_or("assembly", Layer::words);
        format!(
            "<title>Drawing of the {words}</title>\n<path fill=\"#fff\" d=\"M0 0H{width}V{height}H0Z\"/>\n{}",
            self.ink.markup()
        )
    }
}

/// The drawings of a wheel and its driver on paper of one size: all parts in place, and a sheet for each part.
///
/// Sizes have limits of ISO 286, and narrower ones where the tolerance chains leave less: what [`Sizes::shared_tolerance`] finds.
/// Of a process that holds no less than its error, they have that. What is in one piece with the plate is said to be, and pins of one
/// piece with it have no sheet. Paper and scale are chosen so that each part fits: A4 where no part is drawn smaller
/// than it is, or where A3 would not help.
///
/// ```
/// use geneva_kinematics::wheel::{Choices, Scale, Sizes, Wheel};
/// use geneva_workshop::{Layer, Mounting, SheetLimits, SheetMaterial, SheetText, sheets};
///
/// let sizes = Sizes::new(Wheel::new(6)?, Scale::CrankRadius(40.0), &Choices::default())?; // mm
/// let steel = SheetMaterial { name: "steel", hardness: Some("58 HRC") };
/// let text = SheetText { project: "Turret", wheel_material: steel, driver_material: steel, pin_material: steel };
/// let limits = SheetLimits { shared: sizes.shared_tolerance(), ..SheetLimits::default() };
/// let sheets = sheets(&sizes, 8.0, &Mounting::default(), &limits, &text).expect("bare parts");
/// assert_eq!(sheets.len(), 4); // all in place, wheel, locking disc, and plate with its pin
/// assert_eq!((sheets[1].layer, sheets[1].scale.to_string()), (Some(Layer::Wheel), "1:1".to_owned()));
/// # Ok::<(), geneva_kinematics::wheel::SizesError>(())
/// ```
///
/// # Errors
///
/// [`MountingError`] for a choice that does not fit these sizes.
pub fn sheets(
    sizes: &Sizes,
    thickness: f64,
    mounting: &Mounting,
    limits: &SheetLimits,
    text: &SheetText<'_>,
) -> Result<Vec<Sheet>, MountingError> {
    let list = parts(sizes, thickness, mounting)?.parts;
    Ok(sheets_of(DrawnSizes::External(sizes), &list, mounting, limits, text))
}

/// The drawings of an internal wheel and its driver, as [`sheets()`] of an external one.
///
/// ```
/// use geneva_kinematics::internal_sizes::InternalSizes;
/// use geneva_kinematics::internal_wheel::InternalWheel;
/// use geneva_kinematics::wheel::Choices;
/// use geneva_workshop::{Layer, Mounting, SheetLimits, SheetMaterial, SheetText, internal_sheets};
///
/// let sizes = InternalSizes::new(InternalWheel::new(6)?, 30.0, &Choices::default())?; // mm
/// let steel = SheetMaterial { name: "steel", hardness: Some("58 HRC") };
/// let text = SheetText { project: "Turret", wheel_material: steel, driver_material: steel, pin_material: steel };
/// let sheets = internal_sheets(&sizes, 8.0, &Mounting::default(), &SheetLimits::default(), &text).expect("bare parts");
/// let layers: Vec<Layer> = sheets.iter().filter_map(|sheet| sheet.layer).collect(); // the first has all parts
/// assert_eq!(layers, [Layer::Wheel, Layer::RingPlate, Layer::LockingSegment, Layer::Plate]);
/// # Ok::<(), geneva_kinematics::wheel::SizesError>(())
/// ```
///
/// # Errors
///
/// [`MountingError`] for a choice that does not fit these sizes.
pub fn internal_sheets(
    sizes: &InternalSizes,
    thickness: f64,
    mounting: &Mounting,
    limits: &SheetLimits,
    text: &SheetText<'_>,
) -> Result<Vec<Sheet>, MountingError> {
    let list = internal_parts(sizes, thickness, mounting)?.parts;
    Ok(sheets_of(DrawnSizes::Internal(sizes), &list, mounting, limits, text))
}

fn sheets_of(
    sizes: DrawnSizes<'_>,
    list: &[Part],
    mounting: &Mounting,
    limits: &SheetLimits,
    text: &SheetText<'_>,
) -> Vec<Sheet> {
    let chain = Chain::new(sizes, limits.shared, limits.process.is_some());
    let has_metal_pins = text.pin_material.hardness.is_some();
    let making = Making { sizes, mounting, chain, limits: *limits, has_metal_pins };
    let has_sheet = |part: &&Part| !(part.is_joined && part.layer == Layer::Pins);
    let assembly = making.assembly(list, text).map(|view| (None, view));
    let each = list.iter().filter(has_sheet).map(|part| (Some(part), making.view(part)));
    let (shown, views): (Vec<Option<&Part>>, Vec<View>) = assembly.into_iter().chain(each).unzip();
    let scales = |paper| views.iter().map(|view| scale(view, paper)).collect::<Vec<_>>();
    let [small, large] = [Paper::A4, Paper::A3].map(scales);
    let is_small_enough = small.iter().zip(&large).all(|(small, large)| small.factor() >= 1.0 || small == large);
    let (paper, scales) = if is_small_enough { (Paper::A4, small) } else { (Paper::A3, large) };
    let count = views.len();
    let sheet = |(k, (view, scale)): (usize, (View, DrawingScale))| {
        let part = shown.get(k).copied().flatten();
        let title = Title {
            text,
            part,
            name: part.map_or("Assembly", |part| making.name(part)),
            material: part.map(|part| text.material(part.layer)),
            general: making.general_class(),
            scale,
            paper,
            sheet: [k + 1, count],
        };
        draw(&view, &making, &title)
    };
    views.into_iter().zip(scales).enumerate().map(sheet).collect()
}

/// The room between the columns of a sheet, for a view and the dimension lines beside and above it: left, right, top, bottom.
fn room(view: &View, paper: Paper) -> [f64; 4] {
    let ([least, greatest], strip) = frame(paper);
    let lanes = |is_along: bool| {
        let of = view.features.iter().filter(|feature| match feature.target {
            Target::Along(_) => is_along,
            Target::Across(_) => !is_along,
            Target::Edge(_) => false,
        });
        LANE * of.count() as f64
    };
    let widest = |side| {
        let of = view.features.iter().filter(|feature| feature.side == side);
        of.map(|feature| callout(feature, Point::zeros()).width()).fold(0.0, f64::max)
    };
    [
        least.x + 3.0 + widest(Side::Left) + GAP + lanes(true),
        greatest.x - 3.0 - widest(Side::Right) - GAP,
        least.y + 4.0 + lanes(false),
        strip - 4.0,
    ]
}

/// The largest scale in which a view fits, and fills no more than a part of the room if it is drawn larger than it is; the
/// smallest of all scales where none does.
fn scale(view: &View, paper: Paper) -> DrawingScale {
    let [left, right, top, bottom] = room(view, paper);
    let [least, greatest] = reach(view);
    let size = greatest - least;
    let fits = |size: Point| largest([right - left, bottom - top], size);
    let (full, enlarged) = (fits(size), fits(size / ENLARGED));
    if full.factor() > 1.0 {
        if enlarged.factor() < 1.0 { DrawingScale { drawn: 1, real: 1 } } else { enlarged }
    } else {
        full
    }
}

/// The largest scale in which something fits into a room of this width and height, in millimetres.
fn largest(room: [f64; 2], size: Point) -> DrawingScale {
    let smallest = DrawingScale { drawn: 1, real: 10_000 };
    let [across, along] = [(room[0], size.x), (room[1], size.y)]
        .map(|(room, size)| DrawingScale::largest(room, size).unwrap_or(smallest));
    if across.factor() < along.factor() { across } else { along }
}

/// Least and greatest corner of a part and the places that are dimensioned on it.
fn reach(view: &View) -> [Point; 2] {
    let mut corners = view.extent();
    for feature in &view.features {
        let points: &[Point] = match &feature.target {
            Target::Edge(at) => std::slice::from_ref(at),
            Target::Across(ends) | Target::Along(ends) => ends,
        };
        for p in points {
            corners = [corners[0].inf(p), corners[1].sup(p)];
        }
    }
    corners
}

fn callout(feature: &Feature, target: Point) -> Callout {
    Callout {
        rows: feature.rows.clone(),
        side: feature.side,
        target,
        has_arrow: matches!(feature.target, Target::Edge(_)),
    }
}

fn draw(view: &View, making: &Making<'_>, title: &Title<'_>) -> Sheet {
    let (scale, paper) = (title.scale, title.paper);
    let [left, right, top, bottom] = room(view, paper);
    let [least, greatest] = reach(view);
    let s = scale.factor();
    let middle = (least + greatest) / 2.0;
    let origin = Point::new((left + right) / 2.0 - s * middle.x, (top + bottom) / 2.0 + s * middle.y);
    let place = |p: Point| Point::new(origin.x + s * p.x, origin.y - s * p.y);
    let mut ink = Ink::default();

    ink.outline(Pen::Thick, &on_paper(&view.part.outer, s, origin));
    for hole in &view.part.holes {
        ink.outline(Pen::Thick, &on_paper(&hole.outline, s, origin));
        if let Some(wide) = &hole.widening {
            let pen = if wide.is_from_below { Pen::Hidden } else { Pen::Thick };
            ink.outline(pen, &on_paper(&wide.outline, s, origin));
        }
    }
    for mark in view.part.marks.iter().chain(view.part.holes.iter().map(|hole| &hole.centre)) {
        let at = place(*mark);
        for arm in [Point::new(4.0, 0.0), Point::new(0.0, 4.0)] {
            ink.line(Pen::Thin, &[at - arm, at + arm]);
        }
    }
    for (pen, points) in &view.lines {
        ink.line(*pen, &points.iter().map(|p| place(*p)).collect::<Vec<_>>());
    }
    for radius in &view.circles {
        ink.circle(Pen::Centre, origin, s * radius);
    }
    if view.part.is_cut() {
        let [from, to] = view.extent().map(place);
        ink.line(Pen::Centre, &[Point::new(from.x - BEYOND, origin.y), Point::new(to.x + BEYOND, origin.y)]);
        ink.line(Pen::Centre, &[Point::new(origin.x, from.y + BEYOND), Point::new(origin.x, to.y - BEYOND)]);
    } else {
        let [from, to] = view.extent().map(place);
        let middle = (from.y + to.y) / 2.0;
        ink.line(Pen::Centre, &[Point::new(from.x - BEYOND, middle), Point::new(to.x + BEYOND, middle)]);
    }

    let (edge_left, edge_top) = (place(least).x, place(greatest).y);
    let (mut lanes_left, mut lanes_top) = (0.0, 0.0);
    let mut callouts = Vec::new();
    for feature in &view.features {
        let target = match feature.target {
            Target::Edge(at) => place(at),
            Target::Along(ends) => {
                lanes_left += 1.0;
                dimension_line(&mut ink, ends.map(place), edge_left - LANE * lanes_left + 2.0, None)
            }
            Target::Across(ends) => {
                lanes_top += 1.0;
                dimension_line(&mut ink, ends.map(place), edge_top - LANE * lanes_top + 2.0, Some(feature.side))
            }
        };
        callouts.push(callout(feature, target));
    }
    let ([_, corner], strip) = frame(paper);
    // Beside the part, or as far out as the frame lets them.
    let edges = [
        (edge_left - LANE * lanes_left - LEADER).max(left - GAP - LANE * lanes_left),
        (place(greatest).x + LEADER).min(corner.x - 3.0 - widest(&callouts, Side::Right)),
    ];
    let has_room = draw_columns(&mut ink, &callouts, edges, [top - LANE * lanes_top - 1.0, strip - 2.0]);

    let mut notes = limit_notes(view, making);
    let process = making.limits.process;
    if process.is_none() && making.chain.is_known && making.chain.least() < FINE {
        notes.push(format!(
            "The chain leaves only {} here and there. For wider limits, choose more play.",
            mm(making.chain.least())
        ));
    }
    if process.is_none() && !making.chain.is_known {
        notes.push("The play is too small for these limits at their worst: fit the parts together.".to_owned());
    }
    notes.extend(view.notes.iter().cloned());
    let notes_have_room = title.draw(&mut ink, &notes);
    Sheet {
        layer: title.part.map(|part| part.layer),
        paper,
        scale,
        dimensions: view.dimensions().cloned().collect(),
        ink,
        has_room: has_room && notes_have_room,
    }
}

/// What the limits on a sheet mean and what their marks say.
fn limit_notes(view: &View, making: &Making<'_>) -> Vec<String> {
    let general = making.general_class();
    let mut notes = vec![edges_note(making.sizes.pin_diameter())];
    let numbers = making.limits.process;
    notes.push(match numbers {
        None => format!("Letters: ISO 286. Frames: ISO 1101. All else: {general}."),
        Some(numbers) => format!(
            "Process {}: it holds ±{}, of radii half, and no limit is narrower. Frames: ISO 1101. All else: {general}.",
            numbers.process.name(),
            mm(whole_micrometres(numbers.error.value))
        ),
    });
    if making.chain.is_known && view.has_limits_of(LimitOrigin::Chain) {
        let mark = LimitOrigin::Chain.mark();
        // With limits beside them that are wider than the chain, these alone don't say that.
        notes.push(if view.has_limits_of(LimitOrigin::ProcessBeyondChain) {
            format!("{mark} From the tolerance chain.")
        } else {
            format!("{mark} From the tolerance chain: even with all sizes at their worst, nothing jams.")
        });
    }
    if view.has_limits_of(LimitOrigin::ProcessBeyondChain) {
        let mark = LimitOrigin::ProcessBeyondChain.mark();
        // Of an internal wheel a lower bound is known.
        let least = if making.sizes.is_internal() { "at least " } else { "" };
        let turn = making.limits.yield_share.map_or_else(
            || "some assemblies may jam".to_owned(),
            |share| format!("expect {least}{} % of assemblies to turn", mm(libm::floor(share * 1000.0) / 10.0)),
        );
        notes.push(format!("{mark} The tolerance chain leaves less at its worst: {turn}."));
    }
    notes
}

fn widest(callouts: &[Callout], side: Side) -> f64 {
    callouts.iter().filter(|callout| callout.side == side).map(Callout::width).fold(0.0, f64::max)
}

/// A line of a part on paper; its second axis still points up.
fn on_paper(of: &Loop, s: f64, origin: Point) -> Loop {
    let place = |p: Point| Point::new(origin.x + s * p.x, -origin.y + s * p.y);
    let edge = |edge: &Edge| match *edge {
        Edge::Line { from, to } => Edge::Line { from: place(from), to: place(to) },
        Edge::Arc { centre, radius, start, sweep } => {
            Edge::Arc { centre: place(centre), radius: s * radius, start, sweep }
        }
    };
    Loop { edges: of.edges.iter().map(edge).collect() }
}

/// Draws a dimension line with its extension lines, along the page, or across it if it is read on a side, and says where its
/// leader ends.
fn dimension_line(ink: &mut Ink, ends: [Point; 2], lane: f64, read_on: Option<Side>) -> Point {
    let foot = |p: Point| if read_on.is_none() { Point::new(lane, p.y) } else { Point::new(p.x, lane) };
    let away = if read_on.is_none() { Point::new(-1.0, 0.0) } else { Point::new(0.0, -1.0) };
    for end in ends {
        ink.line(Pen::Thin, &[end + away, foot(end) + away * 1.5]);
    }
    let [a, b] = ends.map(foot);
    let along = (b - a).try_normalize(1e-9).unwrap_or(Point::new(1.0, 0.0));
    let is_narrow = (b - a).norm() < NARROW;
    // Outside of a narrow one, and on the side where the leader begins, the line goes on.
    let beyond = |is_read: bool| if is_narrow || is_read { OUTSIDE } else { 0.0 };
    let (before, behind) = (beyond(read_on == Some(Side::Left)), beyond(read_on == Some(Side::Right)));
    let line = [a - along * before, b + along * behind];
    ink.line(Pen::Thin, &line);
    let inward = if is_narrow { -along } else { along };
    ink.arrow(a, a + inward);
    ink.arrow(b, b - inward);
    match read_on {
        Some(Side::Left) => line[0],
        Some(Side::Right) => line[1],
        None => (a + b) / 2.0,
    }
}

/// What is done to edges, in plain words: to a thirtieth of the pin's diameter, from 0.02 to 0.3 mm, our choice.
fn edges_note(pin: f64) -> String {
    let most = (libm::round(pin / 30.0 * 100.0) / 100.0).clamp(0.02, 0.3);
    format!("Edges broken by {} at most, where no note says otherwise.", mm(most))
}
