//! Solids of the parts: walls over closed lines, and flat faces between them, at as many heights as a part has.
//!
//! A part is a stack of slabs; each has the material between its lines. Where two slabs meet there is a flat face over what
//! only the lower one has, and one below what only the upper one has. Mostly the lines of a solid don't meet one another, so each
//! cell between them is in a slab or not as a whole, and crossing a line changes that. Where lines of two slabs meet, they are cut
//! there first.

use crate::chords::inner_polygon;
use crate::crossings::{BoundPiece, CutLines};
use crate::geometry::{Point, area, encloses, point_along, turned};
use crate::parts::{HolePurpose, Layer, MountingError, Part, Place, remedy};
use geneva_kinematics::KinematicsError;
use geneva_kinematics::wheel::{Edge, Loop};
use std::f64::consts::PI;

/// The wall over a line, with the material on the line's left.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Wall {
    /// Which of the solid's lines.
    pub line: usize,
    /// Lower end, in millimetres.
    pub bottom: f64,
    /// Upper end, in millimetres.
    pub top: f64,
}

/// A flat face.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Cap {
    /// Its height, in millimetres.
    pub height: f64,
    /// Whether the material is below it.
    pub is_up: bool,
    /// Its outer bound and its holes, as pieces of the solid's lines in the order and sense in which they are seen from above: the
    /// outer one counter-clockwise, holes clockwise.
    pub bounds: Vec<Vec<BoundPiece>>,
}

/// A solid, about the axis of its lowest part, which stands on the plane z = 0.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Body {
    /// What it is, as a name in files.
    pub name: &'static str,
    /// Its lines; no piece of one is a whole circle.
    pub lines: Vec<Loop>,
    /// Which pieces of its lines are in the same place, or begin there.
    pub cut: CutLines,
    /// The heights at which lines meet, in millimetres.
    pub crossed: Vec<f64>,
    pub walls: Vec<Wall>,
    pub caps: Vec<Cap>,
    /// Where it is in the assembly.
    pub places: Vec<Place>,
    /// How far it reaches along the first axis, in millimetres.
    pub extent: [f64; 2],
}

/// Lines between two heights.
#[derive(Clone)]
struct Slab {
    bottom: f64,
    top: f64,
    lines: Vec<usize>,
}

/// A corner that is nearer to another line than this part of the solid's greatest coordinate is on it: in a file of solids, and in a
/// mesh, whose readers keep single precision.
const SNAP: [f64; 2] = [1e-8, 1e-6];

/// The solids of these parts: those that are joined to the plate are one with it.
///
/// # Errors
///
/// As of [`validate_solids`].
pub(crate) fn bodies(parts: &[Part]) -> Result<Vec<Body>, MountingError> {
    Ok(stacks(parts)?.into_iter().map(|stack| Body::new(stack, SNAP[0])).collect())
}

/// How often chords are made finer where they meet across a wall that is thinner than they leave their arcs, and by how much.
const FINER: i32 = 6;
const BY: f64 = 0.25;

/// The solids of these parts with chords in place of arcs, which leave them by this much at most, in millimetres, and by less where a
/// wall between two lines is thinner than that.
///
/// # Errors
///
/// As of [`validate_solids`], and [`MountingError::Kinematics`] for a tolerance that is not positive and finite.
pub(crate) fn bodies_of_chords(parts: &[Part], tolerance: f64) -> Result<Vec<Body>, MountingError> {
    let with_chords = |of: &Loop, tolerance: f64| -> Result<Loop, KinematicsError> {
        let corners = inner_polygon(of, tolerance)?;
        let next = corners.iter().cycle().skip(1);
        let edges = corners.iter().zip(next).map(|(from, to)| Edge::Line { from: *from, to: *to });
        Ok(Loop { edges: edges.collect() })
    };
    let solid = |stack: Stack<'_>| {
        let chords = |tolerance: f64| -> Result<Body, KinematicsError> {
            let lines = stack.lines.iter().map(|of| with_chords(of, tolerance)).collect::<Result<_, _>>()?;
            Ok(Body::new(Stack { lines, ..stack.clone() }, SNAP[1]))
        };
        let mut body = chords(tolerance)?;
        let arcs = Body::new(stack.clone(), SNAP[0]);
        let mut finer = tolerance;
        for _ in 0..FINER {
            if body.cut.meets_only_as(&arcs.cut) {
                break;
            }
            finer *= BY;
            body = chords(finer)?;
        }
        Ok(body)
    };
    stacks(parts)?.into_iter().map(solid).collect()
}

/// A part, those that are one piece with it, and the lines and slabs of the solid.
#[derive(Clone)]
struct Stack<'p> {
    part: &'p Part,
    joined: Vec<&'p Part>,
    lines: Vec<Loop>,
    slabs: Vec<Slab>,
}

/// Each part that is none with the plate, with those that are joined to it, and its slabs.
fn stacks(parts: &[Part]) -> Result<Vec<Stack<'_>>, MountingError> {
    validate_solids(parts)?;
    let joined: Vec<&Part> = parts.iter().filter(|part| part.is_joined).collect();
    let alone = parts.iter().filter(|part| !part.is_joined);
    let with_slabs = |part| Stack::new(part, if part.layer == Layer::Plate { joined.clone() } else { Vec::new() });
    Ok(alone.map(with_slabs).collect())
}

impl<'p> Stack<'p> {
    fn new(part: &'p Part, joined: Vec<&'p Part>) -> Self {
        let (mut lines, mut slabs) = (Vec::new(), Vec::new());
        let has_pins = joined.iter().any(|of| of.layer == Layer::Pins);
        let place = part.places.first().copied().unwrap_or(Place { turn: 0.0, at: Point::zeros(), bottom: 0.0 });
        slab(part, has_pins, 0.0, (0.0, Point::zeros()), &mut lines, &mut slabs);
        for above in &joined {
            for its in &above.places {
                let by = turned(its.at - place.at, -place.turn);
                slab(above, false, part.thickness, (its.turn - place.turn, by), &mut lines, &mut slabs);
            }
        }
        Self { part, joined, lines, slabs }
    }
}

impl Body {
    fn new(stack: Stack<'_>, snap: f64) -> Self {
        let Stack { part, joined, mut lines, slabs } = stack;
        let mut heights: Vec<f64> = slabs.iter().flat_map(|slab| [slab.bottom, slab.top]).collect();
        heights.sort_by(f64::total_cmp);
        heights.dedup();
        // The lines between each two heights.
        let between = |bottom: f64, top: f64| -> Vec<usize> {
            let there = slabs.iter().filter(|slab| slab.bottom <= bottom && slab.top >= top);
            there.flat_map(|slab| slab.lines.iter().copied()).collect()
        };
        let levels: Vec<Vec<usize>> = heights.windows(2).map(|pair| between(pair[0], pair[1])).collect();
        let groups: Vec<Vec<usize>> = levels.windows(levels.len().clamp(1, 2)).map(|pair| pair.concat()).collect();
        let points = lines.iter().flat_map(|of| &of.edges).map(Edge::start_point);
        let size = points.map(|p| p.amax()).fold(0.0, f64::max);
        let cut = CutLines::new(&mut lines, &groups, snap * size);

        let mut walls: Vec<Wall> = Vec::new();
        for (level, pair) in levels.iter().zip(heights.windows(2)) {
            for line in level {
                let is_below = |wall: &&mut Wall| wall.line == *line && wall.top == pair[0] && !cut.is_cut(*line);
                match walls.iter_mut().find(is_below) {
                    Some(wall) => wall.top = pair[1],
                    None => walls.push(Wall { line: *line, bottom: pair[0], top: pair[1] }),
                }
            }
        }
        let none = Vec::new();
        let (mut caps, mut crossed) = (Vec::new(), Vec::new());
        for (k, height) in heights.iter().enumerate() {
            let below = k.checked_sub(1).and_then(|k| levels.get(k)).unwrap_or(&none);
            let above = levels.get(k).unwrap_or(&none);
            if cut.has_crossings(&[below.as_slice(), above].concat()) {
                crossed.push(*height);
                for (faces, is_up) in cut.faces(&lines, below, above).into_iter().zip([true, false]) {
                    caps.extend(faces.into_iter().map(|bounds| Cap { height: *height, is_up, bounds }));
                }
            } else {
                caps_between(&lines, *height, below, above, &mut caps);
            }
        }
        let name = if joined.is_empty() { part.words() } else { "driver" };
        let extent = crate::drawing::extent(part);
        Self { name, lines, cut, crossed, walls, caps, places: part.places.clone(), extent }
    }
}

/// Refuses what no file of solids has: pockets and shoulders that are as deep as their part is thick, and a locking disc or segment
/// in one piece with a plate that it touches nowhere.
///
/// ```
/// use geneva_kinematics::wheel::{Choices, Scale, Sizes, Wheel};
/// use geneva_workshop::{Mounting, PinMount, ScrewHole, Thread, parts, validate_solids};
///
/// let with = |plate_shaft, thickness, mounting: &Mounting| {
///     let choices = Choices { plate_shaft: Some(plate_shaft), ..Choices::default() };
///     let sizes = Sizes::new(Wheel::new(6)?, Scale::CrankRadius(60.0), &choices)?; // mm
///     Ok::<_, Box<dyn std::error::Error>>(validate_solids(&parts(&sizes, thickness, mounting)?.parts))
/// };
/// let solid = Mounting::default();
/// assert!(with(30.0, 6.0, &solid)?.is_ok() && with(90.0, 6.0, &solid)?.is_err()); // the disc would hang over the bore
/// let nuts = Mounting { pins: PinMount::Screw(Thread::M6, ScrewHole::NutTrap), ..solid };
/// assert!(with(8.0, 6.0, &nuts)?.is_ok() && with(8.0, 5.0, &nuts)?.is_err()); // the nut is 5.2 mm high
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
///
/// [`MountingError::Floating`], and [`MountingError::TooDeep`].
pub fn validate_solids(parts: &[Part]) -> Result<(), MountingError> {
    validate_pockets(parts)?;
    validate_joined(parts)
}

/// Refuses a locking disc or segment in one piece with a plate that it touches nowhere, whatever the thickness of the parts.
///
/// ```
/// use geneva_kinematics::wheel::{Choices, Scale, Sizes, Wheel};
/// use geneva_workshop::{Mounting, parts, validate_joined};
///
/// let with = |plate_shaft, is_stacked| {
///     let choices = Choices { plate_shaft: Some(plate_shaft), ..Choices::default() };
///     let sizes = Sizes::new(Wheel::new(6)?, Scale::CrankRadius(60.0), &choices)?; // mm
///     let mounting = Mounting { is_stacked, ..Mounting::default() };
///     Ok::<_, Box<dyn std::error::Error>>(validate_joined(&parts(&sizes, 6.0, &mounting)?.parts))
/// };
/// assert!(with(30.0, false)?.is_ok() && with(90.0, false)?.is_err()); // the disc would hang over the bore
/// assert!(with(90.0, true)?.is_ok()); // a piece of its own hangs on its shaft or its dowels
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
///
/// [`MountingError::Floating`].
pub fn validate_joined(parts: &[Part]) -> Result<(), MountingError> {
    let Some(plate) = parts.iter().find(|part| part.layer == Layer::Plate) else { return Ok(()) };
    let is_disc = |part: &&Part| matches!(part.layer, Layer::LockingDisc | Layer::LockingSegment);
    for part in parts.iter().filter(|part| part.is_joined).filter(is_disc) {
        let (from, to) = (part.places.first(), plate.places.first());
        let turn = from.zip(to).map_or(0.0, |(from, to)| from.turn - to.turn);
        let outline = part.outer.transform(turn, Point::zeros());
        let points = || outline.edges.iter().flat_map(|edge| (0..4).map(|k| point_along(edge, f64::from(k) / 4.0)));
        let around = plate.holes.iter().find(|hole| points().all(|p| encloses(&hole.outline, p)));
        if let Some(hole) = around {
            let farthest = points().map(|p| p.norm()).fold(0.0, f64::max);
            return Err(MountingError::Floating {
                part: part.layer.words(),
                hole: hole.purpose.words(),
                width: 2.0 * farthest,
            });
        }
    }
    Ok(())
}

/// Refuses pockets and shoulders that are as deep as their part is thick, which no file of solids has.
fn validate_pockets(parts: &[Part]) -> Result<(), MountingError> {
    for part in parts {
        for hole in &part.holes {
            let Some(wide) = hole.widening.as_ref().filter(|wide| wide.depth >= part.thickness) else { continue };
            return Err(MountingError::TooDeep {
                part: part.layer.words(),
                hole: hole.purpose.words(),
                depth: wide.depth,
                thickness: part.thickness,
                remedy: remedy(hole),
            });
        }
    }
    Ok(())
}

/// The lines of a part, turned and moved, in slabs from a height on.
fn slab(
    part: &Part,
    without_pins: bool,
    bottom: f64,
    (turn, by): (f64, Point),
    lines: &mut Vec<Loop>,
    slabs: &mut Vec<Slab>,
) {
    let top = bottom + part.thickness;
    let mut heights = vec![bottom, top];
    let holes: Vec<_> = part.holes.iter().filter(|hole| !(without_pins && hole.purpose == HolePurpose::Pin)).collect();
    for hole in &holes {
        let Some(wide) = &hole.widening else { continue };
        heights.push(if wide.is_from_below { bottom + wide.depth } else { top - wide.depth });
    }
    heights.sort_by(f64::total_cmp);
    heights.dedup();
    let mut index = |of: &Loop| {
        let of = halved(of).transform(turn, by);
        lines.iter().position(|line| *line == of).unwrap_or_else(|| {
            lines.push(of);
            lines.len() - 1
        })
    };
    let outer = index(&part.outer);
    for pair in heights.windows(2) {
        let (from, to) = (pair[0], pair[1]);
        let mut its = vec![outer];
        for hole in &holes {
            let wide = hole
                .widening
                .as_ref()
                .filter(|wide| if wide.is_from_below { to <= bottom + wide.depth } else { from >= top - wide.depth });
            its.push(index(wide.map_or(&hole.outline, |wide| &wide.outline)));
        }
        slabs.push(Slab { bottom: from, top: to, lines: its });
    }
}

/// A loop whose whole circles are two halves each.
fn halved(of: &Loop) -> Loop {
    let half = |edge: &Edge| match *edge {
        Edge::Arc { centre, radius, start, sweep } if sweep.abs() >= 2.0 * PI => {
            let sweep = sweep / 2.0;
            let first = Edge::Arc { centre, radius, start, sweep };
            vec![first, Edge::Arc { centre, radius, start: start + sweep, sweep }]
        }
        edge => vec![edge],
    };
    Loop { edges: of.edges.iter().flat_map(half).collect() }
}

/// The flat faces at a height, where the lines below and above it differ.
fn caps_between(lines: &[Loop], height: f64, below: &[usize], above: &[usize], caps: &mut Vec<Cap>) {
    let mut all: Vec<usize> = below.iter().chain(above).copied().collect();
    all.sort_unstable();
    all.dedup();
    // From the widest to the narrowest, so that a line comes after those around it.
    let mut sorted: Vec<(usize, f64)> =
        all.iter().filter_map(|line| Some((*line, area(lines.get(*line)?).abs()))).collect();
    sorted.sort_by(|a, b| b.1.total_cmp(&a.1));
    // The line, the place in this list of the one just around it, and whether the cell inside is below and above material.
    let mut cells: Vec<(usize, Option<usize>, [bool; 2])> = Vec::new();
    for (line, _) in &sorted {
        let start = lines.get(*line).and_then(|of| of.edges.first()).map(Edge::start_point);
        let Some(start) = start else { continue };
        let around = cells.iter().rposition(|(other, ..)| lines.get(*other).is_some_and(|of| encloses(of, start)));
        let outside = around.and_then(|k| cells.get(k)).map_or([false; 2], |cell| cell.2);
        let crosses = [below.contains(line), above.contains(line)];
        let inside = [outside[0] != crosses[0], outside[1] != crosses[1]];
        cells.push((*line, around, inside));
    }
    for (k, (line, _, inside)) in cells.iter().enumerate() {
        if inside[0] != inside[1] {
            let within =
                cells.iter().filter(|(_, around, _)| *around == Some(k)).map(|(line, ..)| bound(lines, *line, false));
            let bounds = std::iter::once(bound(lines, *line, true)).chain(within).collect();
            caps.push(Cap { height, is_up: inside[0], bounds });
        }
    }
}

/// A whole line as a bound: counter-clockwise as an outer one, clockwise as a hole.
fn bound(lines: &[Loop], line: usize, is_outer: bool) -> Vec<BoundPiece> {
    let Some(of) = lines.get(line) else { return Vec::new() };
    let is_forward = (area(of) > 0.0) == is_outer;
    let mut sides: Vec<BoundPiece> =
        (0..of.edges.len()).map(|piece| BoundPiece { piece: (line, piece), is_forward }).collect();
    if !is_forward {
        sides.reverse();
    }
    sides
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::parts::{BasePlate, Fastener, Mounting, Pattern, PinMount, ScrewHole, ShaftFit, Thread, parts};
    use geneva_kinematics::wheel::{Choices, Scale, Sizes, Wheel};

    /// Areas of the flat faces times their heights: the volume, by the divergence theorem.
    fn volume(body: &Body) -> f64 {
        let size = |cap: &Cap| {
            cap.bounds.iter().map(|bound| area(&crate::crossings::bound_loop(&body.lines, bound))).sum::<f64>()
        };
        body.caps.iter().map(|cap| size(cap) * cap.height * if cap.is_up { 1.0 } else { -1.0 }).sum()
    }

    #[test]
    fn a_solid_has_the_volume_of_its_parts() {
        let nut = Fastener::Screw(Thread::M3, ScrewHole::NutTrap);
        let mounted = Mounting {
            wheel_fit: ShaftFit::Key,
            driver_fit: ShaftFit::Flat { across: 7.0 },
            driver_hub: Some(Pattern { count: 3, circle: 22.0, fastener: nut }),
            base: Some(BasePlate { thickness: Some(9.0), shoulder: Some([30.0, 4.0]), screws: Some(Thread::M5) }),
            ..Mounting::default()
        };
        let screwed = Mounting { pins: PinMount::Screw(Thread::M6, ScrewHole::NutTrap), ..mounted };
        let stacked = Mounting { is_stacked: true, ..mounted };
        let choices = Choices { wheel_shaft: Some(20.0), driver_shaft: Some(8.0), ..Choices::default() };
        for (stations, pins, choices, mounting) in [
            (6, 1, choices, mounted),
            (6, 1, choices, screwed),
            (6, 2, choices, stacked),
            (3, 1, Choices::default(), Mounting::default()),
            (4, 4, Choices::default(), Mounting::default()),
            (24, 2, Choices { plate_shaft: Some(20.0), ..Choices::default() }, Mounting::default()),
        ] {
            let wheel = Wheel::with_pins(stations, pins).unwrap();
            let sizes = Sizes::new(wheel, Scale::CrankRadius(60.0), &choices).unwrap();
            let list = parts(&sizes, 8.0, &mounting).unwrap().parts;
            let ours: f64 = bodies(&list).unwrap().iter().map(|body| volume(body) * body.places.len() as f64).sum();
            let mut theirs: f64 = list.iter().map(|part| part.volume() * part.quantity() as f64).sum();
            // Pins in one piece with the plate fill the holes that a drawing has for them.
            if list.iter().any(|part| part.layer == Layer::Pins && part.is_joined) {
                theirs += PI * sizes.pin_radius() * sizes.pin_radius() * 8.0 * f64::from(pins);
            }
            approx::assert_relative_eq!(ours, theirs, max_relative = 1e-12);
        }
    }

    #[test]
    fn a_pocket_that_is_as_deep_as_its_part_is_refused() {
        let sizes = Sizes::new(Wheel::new(6).unwrap(), Scale::CrankRadius(60.0), &Choices::default()).unwrap();
        let mounting = Mounting { pins: PinMount::Screw(Thread::M6, ScrewHole::NutTrap), ..Mounting::default() };
        let list = parts(&sizes, 5.0, &mounting).unwrap().parts;
        assert!(matches!(bodies(&list), Err(MountingError::TooDeep { thickness: 5.0, .. })));
    }
}
