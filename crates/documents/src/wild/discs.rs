//! The locking disc: the wheel's arcs in which it turns, and the cut through which the wheel's horns pass.

use super::fit::{ANY, tried};
use super::models::{SHIPPED, macro_sizes, size, whole};
use super::*;
use geneva_evidence::agreement::agrees;
use geneva_evidence::tex::{Moment, by_name, value};
use geneva_kinematics::Turn;
use geneva_kinematics::pin_slot::pin_from_pivot;
use nalgebra::Vector2;

/// Wheel and locking disc as they are drawn, lengths in millimetres.
#[derive(Clone, Copy)]
struct Drawn {
    slots: u32,
    /// Of the pin's centre from the driver's axis.
    crank: f64,
    /// Distance of the axes.
    centres: f64,
    /// Of the pin's centre from the wheel's axis as it comes to the slot, half a pitch from the line of centres.
    mouth: f64,
    /// Radius of the wheel.
    rim: f64,
    /// The wheel's arc in which the disc turns while the wheel rests: how far its centre is from the driver's axis,
    /// towards the wheel's, and its radius.
    arc: [f64; 2],
    /// Radius of the locking disc.
    disc: f64,
    /// The circle that is cut out of the disc: how far its centre is from the driver's axis, towards the pin, and its
    /// radius.
    cut: [f64; 2],
}

pub(super) fn claims() -> Vec<Claim> {
    vec![
        arc(OPENSCAD, "wild.openscad.arc"),
        centre(OPENSCAD, "wild.openscad.arc-centre"),
        openscad(),
        arc(GENERATOR, "wild.generator.arc"),
        arc(WINDOW, "wild.freecad-window.arc"),
        centre(WINDOW, "wild.freecad-window.arc-centre"),
        arc(MACRO, "wild.freecad.arc"),
        arc(WORKBENCH, "wild.gear-workbench.arc"),
        centre(WORKBENCH, "wild.gear-workbench.arc-centre"),
        freecad(),
        freecad_arcs(),
        cosmo(),
        sdfx(),
    ]
}

/// Letters of the cut whose edges stand where the pin enters, at right angles to the disc's rim.
fn letters(fit: &Fit, disc: f64, radius: f64, centre: f64) -> Vec<Moment> {
    let letters = [("a", fit.crank), ("b", fit.rim), ("z", disc), ("v", radius), ("m", centre)];
    vec![Moment::default().with(letters)]
}

/// By the angle from the line of centres at which the pin enters.
fn by_angle(slots: u32) -> Vec<Moment> {
    let fit = Fit::by_wheel(slots);
    let (disc, half) = (0.7 * fit.crank, fit.moving / 2.0);
    letters(&fit, disc, disc * libm::tan(half), disc / libm::cos(half))
}

/// By coordinates: the tangent of the disc's rim at its edge meets the line through the pin in the centre of the cut.
fn by_tangent(slots: u32) -> Vec<Moment> {
    let fit = Fit::by_vectors(slots);
    let disc = 0.7 * fit.crank;
    // The pin as it enters, from the driver's axis, with the line of centres for the other axis.
    let along = fit.crank * fit.crank / fit.centres;
    let pin = Vector2::new(along, (fit.crank * fit.crank - along * along).sqrt());
    let edge = pin * (disc / pin.norm());
    let centre = Vector2::new(edge.dot(&edge) / edge.x, 0.0);
    letters(&fit, disc, (centre - edge).norm(), centre.norm())
}

fn arc(place: Locator, id: &'static str) -> Claim {
    let meaning = "radius v of the cut in the locking disc, for disc radius z, wheel radius b and crank radius a";
    tried(place, id, "v = b z/a", meaning, ANY, (Evidence::CLOSED_FORM, by_angle), (Evidence::VECTORS, by_tangent))
        .interpreted_as(EDGES)
}

fn centre(place: Locator, id: &'static str) -> Claim {
    let meaning = "distance m of the centre of the cut in the locking disc from the driver's axis, towards the pin, \
                   for disc radius z and cut radius v";
    tried(
        place,
        id,
        r"m = \sqrt{z^2 + v^2}",
        meaning,
        ANY,
        (Evidence::CLOSED_FORM, by_angle),
        (Evidence::VECTORS, by_tangent),
    )
    .interpreted_as(EDGES)
}

/// What the formulas of the cut are meant to give.
const EDGES: &str = "We read the cut as one whose edges are where the pin enters and leaves, so that the disc releases \
                     the wheel as the pin takes it over. The cut meets the disc's rim at right angles.";

impl Drawn {
    /// A wheel that fits a crank, with this rim, with nothing cut out of the disc.
    fn fitting(slots: u32, crank: f64, rim: f64, arc: [f64; 2], disc: f64) -> Self {
        let pitch = PI / f64::from(slots);
        let (centres, mouth) = (crank / libm::sin(pitch), crank / libm::tan(pitch));
        Self { slots, crank, centres, mouth, rim, arc, disc, cut: [0.0; 2] }
    }

    /// The crank's angle from the line of centres as the pin comes to the slot.
    fn entry(&self) -> f64 {
        let [a, c, m] = [self.crank, self.centres, self.mouth];
        libm::acos((a * a + c * c - m * m) / (2.0 * a * c))
    }

    /// Adds the cut whose edges are where the pin enters and leaves, for a wheel that fits, of radius b z/a.
    fn with_clear_cut(self) -> Self {
        let entry = self.entry();
        Self { cut: [self.disc / libm::cos(entry), self.disc * libm::tan(entry)], ..self }
    }

    /// Adds a cut about the wheel's axis, of the radius of the slots' mouths.
    fn with_wheel_for_cut(self) -> Self {
        Self { cut: [self.centres, self.mouth], ..self }
    }

    /// The deepest that a tip of the wheel's horns comes into the disc that is left, below zero outside. In the driver's
    /// plane, by coordinates: crank angles, the wheel's angle by the formula crate.
    fn by_crank(&self) -> f64 {
        let (c, pitch) = (self.centres, PI / f64::from(self.slots));
        // A tip is where the rim meets the arc, half a pitch from the slot.
        let [from, radius] = self.arc;
        let along = (self.rim * self.rim + (c - from) * (c - from) - radius * radius) / (2.0 * (c - from));
        let tip = libm::acos(along / self.rim);
        let end = self.entry();
        let at = |step: u32, side: f64| {
            let crank = end * (f64::from(step) / 720.0 - 1.0);
            let pin = pin_from_pivot(&(c / self.crank), &Turn::from_radians(crank));
            let angle = libm::atan2(pin.y, pin.x) + side * (pitch - tip);
            let place = Vector2::new(self.rim * libm::cos(angle) - c, self.rim * libm::sin(angle));
            let towards_the_pin = Vector2::new(-libm::cos(crank), libm::sin(crank));
            let [centre, cut] = self.cut;
            (self.disc - place.norm()).min((place - towards_the_pin * centre).norm() - cut)
        };
        let all = (0..=1440).flat_map(|step| [at(step, 1.0), at(step, -1.0)]);
        greatest(all)
    }

    /// The deepest place again by triangles, from the pin's place in its slot: of the two axes and the pin, and of the
    /// tip and two of them.
    fn by_triangles(&self) -> f64 {
        let square = |x: f64| x * x;
        let (c, a, r) = (self.centres, self.crank, self.rim);
        let beside = |near: f64, far: f64, across: f64| {
            libm::acos((square(near) + square(far) - square(across)) / (2.0 * near * far))
        };
        // Of the tip from the slot, at the wheel's axis.
        let tip = PI / f64::from(self.slots) - beside(r, c - self.arc[0], self.arc[1]);
        let across = |far: f64, angle: f64| square(r) + square(far) - 2.0 * r * far * libm::cos(angle);
        let (deepest, mouth) = (c - a, self.mouth);
        let at = |step: u32, side: f64| {
            // About as many steps to each crank angle.
            let pin = deepest + (mouth - deepest) * square(f64::from(step) / 1440.0);
            let axis = if step == 0 { 0.0 } else { beside(c, pin, a) };
            let [to_axis, to_pin] = [across(c, tip - side * axis), across(pin, tip)];
            // The centre of the cut divides the crank, or lengthens it: Stewart's theorem.
            let part = self.cut[0] / a;
            let to_cut = (1.0 - part) * to_axis + part * to_pin - part * (1.0 - part) * square(a);
            (self.disc - to_axis.sqrt()).min(to_cut.sqrt() - self.cut[1])
        };
        let all = (0..=1440).flat_map(|step| [at(step, 1.0), at(step, -1.0)]);
        greatest(all)
    }

    fn clears(depth: f64) -> Finding {
        let how = if depth < 0.0 {
            format!("the tips of the horns pass the edge of the cut with {:.2} mm to spare", -depth)
        } else {
            format!("the tips of the horns run into the disc by {depth:.2} mm")
        };
        Finding::new(depth < 0.0, how)
    }
}

/// The greatest depth; not a number if one of them is not.
fn greatest(depths: impl Iterator<Item = f64>) -> f64 {
    depths.fold(f64::NEG_INFINITY, |most, depth| if most >= depth || most.is_nan() { most } else { depth })
}

/// The wheels that the macro draws with the pin and the tolerance that it is shipped with, and the sizes of its comment: one
/// that keeps the crank of the example, one that keeps the wheel's radius. Nothing is cut out of the disc yet.
fn freecad_wheels() -> [Drawn; 2] {
    let [pin, tolerance] = SHIPPED;
    let (crank, rim, slots) = macro_sizes(WILD.printed_text("wild.freecad.example"));
    let tangent = libm::tan(PI / f64::from(slots));
    [(crank, crank / tangent), (rim * tangent, rim)].map(|(crank, rim)| {
        let radius = crank - 1.5 * pin;
        let arc = [towards_the_wheel(WILD.printed_text("wild.freecad.arcs"), radius, rim), radius];
        Drawn::fitting(slots, crank, rim, arc, radius - tolerance)
    })
}

/// Where characters put the centre of the wheel's arcs of this radius y, for a wheel of radius b: from the driver's axis
/// towards the wheel's.
fn towards_the_wheel(characters: &str, y: f64, b: f64) -> f64 {
    let formula = characters.strip_prefix("x =").unwrap_or_default();
    -value(formula, &by_name([("y", y), ("b", b)]))
}

/// How the macro's wheels are read.
const MACRO_WHEELS: &str = "With both radii as shipped, the wheel cannot turn. With the example's pin and tolerance, \
                            the formulas in the program's comment give two other wheels. One keeps the example's \
                            crank radius, and the other keeps the example's wheel radius. For both wheels we checked \
                            what the program's own lines draw.";

fn freecad() -> Claim {
    let clear = |stated: Stated, depth: fn(&Drawn) -> f64| {
        let depths =
            freecad_wheels().map(|wheel| depth(&stated.pick(wheel.with_clear_cut(), wheel.with_wheel_for_cut())));
        let [crank, rim] = depths.map(Drawn::clears);
        Finding::new(
            crank.holds && rim.holds,
            format!("with the example's crank radius, {}, and with the example's wheel radius, {}", crank.how, rim.how),
        )
    };
    MACRO
        .example(
            "wild.freecad.cut",
            "m = c, R = b",
            "circle that is cut out of the locking disc: its radius R and the distance m of its centre from the \
             driver's axis, for disc radius z, crank radius a, wheel radius b and centre distance c",
        )
        .first_route(Evidence::VECTORS, move |stated| clear(stated, Drawn::by_crank))
        .second_route(Evidence::CLOSED_FORM, move |stated| clear(stated, Drawn::by_triangles))
        .interpreted_as(MACRO_WHEELS)
        .corrected(
            "m = c z/a, R = b z/a",
            cut_in_the_middle(
                "The tips of the wheel's horns (the walls beside the slots) run into the disc by 0.17 mm, although the \
                 play is 0.01 mm. The program computes the radius b z/a, which would clear the horns, but it does not \
                 use this radius. But another version of the macro, which opens a window, uses it.",
            ),
        )
}

fn freecad_arcs() -> Claim {
    let said = |stated: Stated, wheel: &Drawn| towards_the_wheel(stated.characters(), wheel.arc[1], wheel.rim);
    MACRO
        .example(
            "wild.freecad.arcs",
            "x = y - b/2",
            "position x of the centre of an arc of the wheel at rest, measured from the driver's axis, for wheel \
             radius b and arc radius y, with the wheel's axis at −c",
        )
        .first_route(Evidence::CLOSED_FORM, move |stated| {
            rests(freecad_wheels().map(|wheel| {
                // What is left of the wheel on the line of centres, and what the disc leaves room for.
                let left = wheel.centres - said(stated, &wheel) - wheel.arc[1];
                wheel.centres - wheel.disc - left
            }))
        })
        .second_route(Evidence::VECTORS, move |stated| {
            let gaps = freecad_wheels().map(|wheel| {
                // Places of the arc all along it, from the driver's axis.
                let [from, radius] = [said(stated, &wheel), wheel.arc[1]];
                let place = |step: i32| {
                    let angle = f64::from(step) / 100.0;
                    Vector2::new(radius * libm::cos(angle) + from, radius * libm::sin(angle))
                };
                let inside = |place: &Vector2<f64>| (place - Vector2::new(wheel.centres, 0.0)).norm() <= wheel.rim;
                let gaps = (-157..=157).map(place).filter(inside).map(|place| place.norm() - wheel.disc);
                gaps.fold(f64::NEG_INFINITY, f64::max)
            });
            rests(gaps)
        })
        .interpreted_as(MACRO_WHEELS)
        .corrected(
            "x = 0",
            slip(
                "While the wheel rests, the disc turns in one of the wheel's arcs, so the arc's centre must be on the \
                 driver's axis. In the program, the disc's radius is the radius of the arcs less the tolerance.",
                "We used coordinates to check points all along an arc.",
                "The gap between disc and arc is up to 2.66 mm, although the tolerance is 0.01 mm. So the wheel is \
                 loose when it should rest. The version of the macro that opens a window puts the arc's centre on the \
                 driver's axis.",
            ),
        )
}

/// Whether what is between disc and arc is the tolerance.
fn rests(gaps: [f64; 2]) -> Finding {
    let ([crank, rim], [_, tolerance]) = (gaps, SHIPPED);
    Finding::new(
        gaps.iter().all(|gap| agrees(*gap, tolerance)),
        format!(
            "the gap between disc and arc should be the tolerance, {tolerance} mm, and it is up to {crank:.2} mm with \
             the example's crank radius and up to {rim:.2} mm with the example's wheel radius"
        ),
    )
}

fn cosmo() -> Claim {
    let drawn = |stated: Stated| {
        let fitting = 16.0 * 3f64.sqrt();
        let rim = stated.characters().rsplit(", ").next().unwrap_or_default();
        let rim = stated.pick(value(rim, &by_name([("b", fitting)])), fitting);
        Drawn::fitting(6, 16.0, rim, [0.0, 11.225], 11.125).with_wheel_for_cut()
    };
    COSMO
        .example(
            "wild.cosmo.cut",
            "m = c, R = b, b - 0.2 - 0.6",
            "circle that is cut out of the locking disc (distance m of its centre from the driver's axis, radius R), \
             and the wheel's radius less two clearances",
        )
        .first_route(Evidence::VECTORS, move |stated| Drawn::clears(drawn(stated).by_crank()))
        .second_route(Evidence::CLOSED_FORM, move |stated| Drawn::clears(drawn(stated).by_triangles()))
        .interpreted_as("We ask whether the wheel clears the disc, with its clearances in millimetres.")
        .but_not("the wheel clears the disc without them")
}

fn openscad() -> Claim {
    let drawn = |stated: Stated| {
        let (rim, slots) = (stated.number(), whole(stated.numbers().last().copied().unwrap_or(f64::NAN)));
        let crank = rim * libm::tan(PI / f64::from(slots));
        let (arc, disc) = ([0.0, crank - 7.5], crank - 7.75);
        let wheel = Drawn::fitting(slots, crank, rim, arc, disc);
        stated.pick(wheel.with_clear_cut(), wheel.with_wheel_for_cut())
    };
    OPENSCAD
        .example(
            "wild.openscad.cut",
            "v = 25 z/a, 5 slots",
            "radius v of the cut in the locking disc of the wheel as it is shipped, for disc radius z and crank radius \
             a",
        )
        .first_route(Evidence::VECTORS, move |stated| Drawn::clears(drawn(stated).by_crank()))
        .second_route(Evidence::CLOSED_FORM, move |stated| Drawn::clears(drawn(stated).by_triangles()))
        .interpreted_as("We ask whether the wheel clears the disc.")
        .but_not("the wheel clears a disc with a cut of the wheel's radius about the wheel's axis")
}

/// The first example of the program with its clearance; its wheel is smaller than the one that fits.
fn sdfx() -> Claim {
    let drawn = |stated: Stated| {
        let [disc, radius, rim, arc] =
            ["disc", "cut", "rim", "arc"].map(|name| size(WILD.printed_text("wild.sdfx.cut"), name));
        let wheel = WILD.printed_text("wild.sdfx.example");
        let [centres, mouth] = ["centres", "driven radius"].map(|name| size(wheel, name));
        let slots = whole(Stated::right(wheel).number());
        let square = centres * centres + mouth * mouth - 2.0 * centres * mouth * libm::cos(PI / f64::from(slots));
        let drawn =
            Drawn { slots, crank: square.sqrt(), centres, mouth, rim, arc: [0.0, arc], disc, cut: [centres, radius] };
        stated.pick(drawn.with_clear_cut(), drawn)
    };
    SDFX_EXAMPLE
        .example(
            "wild.sdfx.cut",
            "disc 20.0 - 0.1, cut 40.0 + 0.1, rim 40.0 - 0.1, arc 20.0 + 0.1",
            "radii of the first example with its clearance: of the locking disc, of the circle about the wheel's axis \
             that is cut out of the disc, of the wheel's rim, and of the arcs in which the disc turns",
        )
        .first_route(Evidence::VECTORS, move |stated| Drawn::clears(drawn(stated).by_crank()))
        .second_route(Evidence::CLOSED_FORM, move |stated| Drawn::clears(drawn(stated).by_triangles()))
        .interpreted_as(
            "We put the pin where the program puts it, although the wheel then starts with a jump in speed. We ask \
             only whether the horns clear the disc.",
        )
        .corrected(
            "a cut whose edges are where the pin enters and leaves",
            cut_in_the_middle(
                "The tips of the wheel's horns (the walls beside the slots) run into the disc by 0.05 mm, although the \
                 clearance is 0.1 mm on either side.",
            ),
        )
}
/// The slip of a program that cuts its locking disc along the rim as the rim stands in the middle of a move.
const fn cut_in_the_middle(changes: &'static str) -> Slip {
    slip(
        "The program puts the driver in the middle of a move and cuts a circle out of the disc. The circle is \
         centred on the wheel's axis and has the wheel's radius. But the disc turns together with its cut, so the \
         horns run into the disc before and after the middle of the move.",
        "We computed the clearance from the triangles that the two axes form with the pin and with the tip of a horn.",
        changes,
    )
}
