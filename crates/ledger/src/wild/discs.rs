//! The cut in the locking disc, through which the wheel's horns pass.

use super::fit::{ANY, tried};
use super::*;
use crate::tex::Moment;
use geneva_kinematics::Turn;
use geneva_kinematics::pin_slot::pin_from_pivot;
use nalgebra::Vector2;

const MACRO: Place = at(page!("https://github.com/FreeCAD/FreeCAD-documentation/blob/HEAD/wiki/Macro_Geneva_Wheel.md"));
const OPENSCAD: Place = at(page!("https://github.com/tllilleh/openscad-geneva-drive/blob/HEAD/geneva-drive.scad"));
const WORKBENCH: Place = at(page!("https://github.com/iplayfast/GearWorkBench/blob/HEAD/genevaWheel.py"));
const GENERATOR: Place =
    at(page!("https://github.com/SindiSekkas/geneva-drive-generator/blob/HEAD/src/geneva/params.ts"));
const COSMO: Place = at(page!("https://github.com/ascii-dresden/ascii-cosmo/blob/HEAD/openscad/geneva_drive.scad"));

/// Wheel and locking disc as they are drawn, lengths in millimetres.
#[derive(Clone, Copy)]
struct Drawn {
    slots: u32,
    /// Of the pin's centre from the driver's axis.
    crank: f64,
    /// Radius of the wheel.
    rim: f64,
    /// Radius of the wheel's arcs in which the disc turns while the wheel rests.
    arc: f64,
    /// Radius of the locking disc.
    disc: f64,
    /// The circle that is cut out of the disc: how far its centre is from the driver's axis, towards the pin, and its
    /// radius.
    cut: [f64; 2],
}

pub fn claims() -> Vec<Claim> {
    vec![
        arc(OPENSCAD, "wild.openscad.arc"),
        centre(OPENSCAD, "wild.openscad.arc-centre"),
        openscad(),
        arc(GENERATOR, "wild.generator.arc"),
        centre(WORKBENCH, "wild.gear-workbench.arc-centre"),
        cosmo(),
        freecad(),
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

fn arc(place: Place, id: &'static str) -> Claim {
    let meaning = "radius of the cut in the locking disc, of radius z, for wheel radius b and crank radius a";
    tried(place, id, "v = b z/a", meaning, ANY, (ClosedForm, by_angle), (Vectors, by_tangent)).read_as(EDGES)
}

fn centre(place: Place, id: &'static str) -> Claim {
    let meaning = "distance of the centre of that cut from the driver's axis, towards the pin";
    tried(place, id, r"m = \sqrt{z^2 + v^2}", meaning, ANY, (ClosedForm, by_angle), (Vectors, by_tangent))
        .read_as(EDGES)
}

/// What the formulas of the cut are meant to give.
const EDGES: &str = "The edges of the cut stand where the pin enters and leaves, so that the disc lets the wheel go as the pin \
     takes it. The cut meets the disc's rim at right angles.";

impl Drawn {
    fn centres(&self) -> f64 {
        self.crank / libm::sin(PI / f64::from(self.slots))
    }

    /// The same with the cut of radius b z/a.
    fn with_clear_cut(self) -> Self {
        let (c, b) = (self.centres(), self.crank / libm::tan(PI / f64::from(self.slots)));
        Self { cut: [c * self.disc / self.crank, b * self.disc / self.crank], ..self }
    }

    /// The same with a cut of the radius of a wheel that fits, about the wheel's axis.
    fn with_wheel_for_cut(self) -> Self {
        Self { cut: [self.centres(), self.crank / libm::tan(PI / f64::from(self.slots))], ..self }
    }

    /// How deep a place is inside the disc that is left, below zero outside: from the place's distances to the driver's
    /// axis and to the centre of the cut.
    fn depth(&self, [axis, centre]: [f64; 2]) -> f64 {
        (self.disc - axis).min(centre - self.cut[1])
    }

    /// The deepest that a tip of the wheel's horns comes into the disc, in the driver's plane: crank angles, the wheel's
    /// angle by the formula crate.
    fn by_crank(&self) -> f64 {
        let (c, pitch) = (self.centres(), PI / f64::from(self.slots));
        let tip = libm::acos((self.rim * self.rim + c * c - self.arc * self.arc) / (2.0 * self.rim * c));
        let end = PI / 2.0 - pitch;
        let at = |step: u32, side: f64| {
            let crank = end * (f64::from(step) / 720.0 - 1.0);
            let pin = pin_from_pivot(&(c / self.crank), &Turn::from_radians(crank));
            let angle = libm::atan2(pin.y, pin.x) + side * (pitch - tip);
            let place = Vector2::new(self.rim * libm::cos(angle) - c, self.rim * libm::sin(angle));
            let towards_the_pin = Vector2::new(-libm::cos(crank), libm::sin(crank));
            self.depth([place.norm(), (place - towards_the_pin * self.cut[0]).norm()])
        };
        let all = (0..=1440).flat_map(|step| [at(step, 1.0), at(step, -1.0)]);
        all.fold(f64::NEG_INFINITY, f64::max)
    }

    /// The same in the plane of the wheel, with the pin's slot along the first axis: the driver's axis goes round.
    fn by_slot(&self) -> f64 {
        let (c, a) = (self.centres(), self.crank);
        // A tip is where the rim meets the arc about the driver's axis at rest, half a pitch from the slot.
        let rest = Vector2::new(libm::cos(PI / f64::from(self.slots)), libm::sin(PI / f64::from(self.slots)));
        let along = (self.rim * self.rim + c * c - self.arc * self.arc) / (2.0 * c);
        let aside = (self.rim * self.rim - along * along).sqrt();
        let tip = rest * along + Vector2::new(rest.y, -rest.x) * aside;
        let (deepest, mouth) = (c - a, (c * c - a * a).sqrt());
        let at = |step: u32, side: f64| {
            // About as many steps to each crank angle.
            let pin = deepest + (mouth - deepest) * libm::pow(f64::from(step) / 1440.0, 2.0);
            let x = (c * c + pin * pin - a * a) / (2.0 * pin);
            let axis = Vector2::new(x, side * (c * c - x * x).max(0.0).sqrt());
            let centre = axis + (Vector2::new(pin, 0.0) - axis) * (self.cut[0] / a);
            self.depth([(tip - axis).norm(), (tip - centre).norm()])
        };
        let all = (0..=1440).flat_map(|step| [at(step, 1.0), at(step, -1.0)]);
        all.fold(f64::NEG_INFINITY, f64::max)
    }

    fn clears(depth: f64) -> Finding {
        let how = if depth < 0.0 {
            format!("the tips of the horns pass the disc with {:.2} mm to spare", -depth)
        } else {
            format!("the tips of the horns run into the disc by {depth:.2} mm")
        };
        Finding::new(depth < 0.0, how)
    }
}

fn freecad() -> Claim {
    // Crank 25, six slots, a pin of radius 4, a tolerance of 0.01; the wheel's radius is the one that fits.
    let wheel = Drawn { slots: 6, crank: 25.0, rim: 25.0 * 3f64.sqrt(), arc: 19.0, disc: 18.99, cut: [0.0; 2] };
    let [right, drawn] = [wheel.with_clear_cut(), wheel.with_wheel_for_cut()];
    MACRO
        .figure(
            "wild.freecad.cut",
            "m = c, R = b",
            "circle that is cut out of the locking disc: distance of its centre from the driver's axis, and radius",
        )
        .by(ClosedForm, move |stated| Drawn::clears(stated.pick(right, drawn).by_crank()))
        .by(Vectors, move |stated| Drawn::clears(stated.pick(right, drawn).by_slot()))
        .read_as("The crank, pin and tolerance of the example, with the wheel radius that fits them.")
        .corrected(
            "m = c z/a, R = b z/a",
            slip(
                "The circle of the wheel's radius about the wheel's axis is where the rim is in the middle of a move. The disc \
                 turns on, and the horns come inside it on both sides of the middle.",
                "The same in the plane of the wheel, by coordinates.",
                "The tips of the horns run into the disc by 0.26 mm, where the play is 0.01 mm. The program computes the radius \
                 b z/a, which clears, and does not use it.",
            ),
        )
}

fn cosmo() -> Claim {
    let fitting = 16.0 * 3f64.sqrt();
    let wheel = Drawn { slots: 6, crank: 16.0, rim: fitting, arc: 11.225, disc: 11.125, cut: [0.0; 2] };
    let without_play = wheel.with_wheel_for_cut();
    let drawn = Drawn { rim: fitting - 0.2 - 0.6, ..without_play };
    COSMO
        .figure(
            "wild.cosmo.cut",
            "m = c, R = b, b - 0.2 - 0.6",
            "circle that is cut out of the locking disc, and the wheel's radius less two clearances",
        )
        .by(ClosedForm, move |stated| Drawn::clears(stated.pick(drawn, without_play).by_crank()))
        .by(Vectors, move |stated| Drawn::clears(stated.pick(drawn, without_play).by_slot()))
        .read_as("The wheel clears the disc with its clearances, in millimetres.")
        .but_not("the wheel clears the disc without them")
}

fn openscad() -> Claim {
    let crank = 25.0 * libm::tan(PI / 5.0);
    let wheel = Drawn { slots: 5, crank, rim: 25.0, arc: crank - 7.5, disc: crank - 7.75, cut: [0.0; 2] };
    let [drawn, other] = [wheel.with_clear_cut(), wheel.with_wheel_for_cut()];
    OPENSCAD
        .figure("wild.openscad.cut", "v = 25 z/a, 5 slots", "cut in the locking disc of the wheel that is shipped")
        .by(ClosedForm, move |stated| Drawn::clears(stated.pick(drawn, other).by_crank()))
        .by(Vectors, move |stated| Drawn::clears(stated.pick(drawn, other).by_slot()))
        .read_as("The wheel clears the disc.")
        .but_not("it does so with a cut of the wheel's radius about the wheel's axis")
}
