//! What the letters and words of programs stand for, as they say and as they draw.

use super::fit::ANY;
use super::models::SHIPPED;
use super::*;
use crate::agreement::{agrees, vanishes};
use nalgebra::Vector2;

pub fn claims() -> Vec<Claim> {
    vec![
        pin_diameter(),
        slot_width(MACRO, "wild.freecad.slot-width"),
        slot_width(WINDOW, "wild.freecad-window.slot-width"),
        slot_width(WORKBENCH, "wild.gear-workbench.slot-width"),
        stop_arc(),
        aligned(),
        from_entry(),
    ]
}

/// The slip of a word; what is computed with the letter is not touched by it.
const fn word(reason: &'static str, witness: &'static str, changes: &'static str) -> Slip {
    Slip { consequence: Consequence::Wording, origin: Origin::Misprint, ..slip(reason, witness, changes) }
}

fn pin_diameter() -> Claim {
    MACRO
        .statement("wild.freecad.pin", r"p = \text{Drive Pin Diameter}", "what the length p is")
        .by(Vectors, |stated| {
            // The drawn pin is a cylinder of radius p: two opposite points of it.
            let [p, _] = SHIPPED;
            let [one, other] = [0.0, PI].map(|angle| Vector2::new(libm::cos(angle), libm::sin(angle)) * p);
            let (width, said) = ((one - other).norm(), stated.pick(2.0, 1.0) * p);
            Finding::new(agrees(width, said), format!("the pin is {width:.1} across, said to be {said:.1}"))
        })
        .by(Evidence::OtherPlaceInSource, |stated| {
            // The drawn slot reaches p + t to either side: the tolerance should be what is left beside the pin.
            let [p, t] = SHIPPED;
            let left = p + t - stated.pick(1.0, 0.5) * p;
            Finding::new(
                vanishes(left - t),
                format!("{left:.2} are left on either side of the pin, the tolerance is {t:.2}"),
            )
        })
        .corrected(
            r"p = \text{Drive Pin Radius}",
            word("The program makes a cylinder with p for its radius.", "The version with a window says radius.", ""),
        )
}

/// The width of a slot, of which the programs draw twice as much: w to either side of its middle.
fn slot_width(place: Place, id: &'static str) -> Claim {
    place
        .statement(
            id,
            r"w = p + t = \text{Slot Width}",
            "what the length w is, with the pin's radius p and the tolerance t",
        )
        .by(Vectors, |stated| {
            // Two corners of the box that is cut out, on either side of the slot.
            let [p, t] = SHIPPED;
            let w = p + t;
            let [one, other] = [-w, w].map(|aside| Vector2::new(0.0, aside));
            let (width, said) = ((one - other).norm(), stated.pick(2.0, 1.0) * w);
            Finding::new(agrees(width, said), format!("the slot is {width:.2} wide, said to be {said:.2}"))
        })
        .by(Evidence::OtherPlaceInSource, |stated| {
            // What a slot as wide as is said leaves beside the pin, which is drawn with p for its radius.
            let [p, t] = SHIPPED;
            let left = stated.pick(1.0, 0.5) * (p + t) - p;
            Finding::new(
                vanishes(left - t),
                format!("a slot of that width leaves {left:.2} on either side of the pin, the tolerance is {t:.2}"),
            )
        })
        .read_as("With the pin and the tolerance that the macro is shipped with; the same holds with any others.")
        .corrected(
            r"w = p + t = \text{half the Slot Width}",
            word(
                "The program cuts a box 2w wide, and rounds its end with a cylinder of radius w.",
                "A slot of width w would be narrower than the pin.",
                "Nothing that is drawn.",
            ),
        )
}

/// The factor between the pin and what the wheel's arcs are smaller than the crank.
fn stop_arc() -> Claim {
    GENERATOR
        .statement(
            "wild.generator.stop-arc",
            "1.5 × pin radius",
            "by how much the radius of the wheel's arcs is less than the crank radius, with the pin's diameter p: y = a - 1.5 p",
        )
        .by(ClosedForm, |stated| {
            let p = 4.0;
            let said = stated.number() * stated.pick(p, p / 2.0);
            Finding::new(agrees(said, 1.5 * p), format!("{:.1} for a pin of diameter {p:.1}, said to be {said:.1}", 1.5 * p))
        })
        .by(Evidence::OtherPlaceInSource, |stated| {
            // The pin is drawn with p/2 for its radius, and slots as wide as p and the clearance.
            let (p, crank) = (4.0, 25.0);
            let drawn = [-p / 2.0, p / 2.0].map(|aside| Vector2::new(crank, aside));
            let across = (drawn[0] - drawn[1]).norm();
            let arc = crank - 1.5 * p;
            let said = crank - stated.number() * stated.pick(across, across / 2.0);
            Finding::new(agrees(arc, said), format!("the arcs have the radius {arc:.1}, by the comment {said:.1}"))
        })
        .corrected(
            "1.5 × pin diameter",
            word(
                "The letter p is the pin's diameter: the program says so and draws the pin with p/2 for its radius.",
                "The pin as it is drawn.",
                "Nothing that is drawn.",
            ),
        )
}

/// How slot and crank stand to each other as the pin enters.
fn aligned() -> Claim {
    let found = |stated: Stated, angle: &dyn Fn(u32) -> f64| {
        let said = stated.pick(90.0, 0.0);
        let right = |slots: u32| vanishes((angle(slots) - said) / 90.0);
        Finding::new(
            ANY.filter(|slots| !right(*slots)).count() == 0,
            format!("as the pin enters at rest, slot and crank are {:.1} degrees apart", angle(4)),
        )
    };
    ANVILATE
        .statement(
            "wild.anvilate.aligned",
            "aligned with the crank arm",
            "how the slot stands to the crank as the pin enters, so that the wheel starts from rest",
        )
        .by(ClosedForm, move |stated| {
            // The law of cosines in the triangle of the axes and the pin.
            let angle = |slots: u32| {
                let Fit { crank: a, centres: c, rim: r, .. } = Fit::by_wheel(slots);
                libm::acos((a * a + r * r - c * c) / (2.0 * a * r)).to_degrees()
            };
            found(stated, &angle)
        })
        .by(Vectors, move |stated| {
            let angle = |slots: u32| {
                let fit = Fit::by_vectors(slots);
                let half = fit.moving / 2.0;
                let arm = Vector2::new(-libm::cos(half), libm::sin(half)) * fit.crank;
                let pin = arm + Vector2::new(fit.centres, 0.0);
                libm::atan2(arm.perp(&pin).abs(), arm.dot(&pin).abs()).to_degrees()
            };
            found(stated, &angle)
        })
        .corrected(
            "at right angles to the crank arm",
            word(
                "The pin moves at right angles to the crank, and it must move along the slot. A slot along the crank would be \
                 crossed at the pin's full speed.",
                "The pin's place at entry, by coordinates, for 3 to 60 slots.",
                "Nothing: the next line has the right angle at the pin, and the formulas follow from that.",
            ),
        )
}

/// From where the driver's angle counts for which a program gives the wheel's angle.
fn from_entry() -> Claim {
    // The sizes of a wheel, half the driver's angle of a move, and the angle that the program is given at the entry.
    let entry = |slots: u32, stated: Stated| {
        let Fit { crank, centres, moving, .. } = Fit::by_wheel(slots);
        (crank, centres, moving / 2.0, stated.pick(-moving / 2.0, 0.0))
    };
    CONSTRAINTS
        .statement(
            "wild.oxiphysics.from-entry",
            "from start of driving phase",
            "from where the driver's angle φ counts: the wheel's angle is the inverse tangent of r sin φ/(a − r cos φ)",
        )
        .by(ClosedForm, move |stated| {
            let off = |slots: u32| {
                let (r, a, half, start) = entry(slots, stated);
                let angle = |phi: f64| libm::atan2(r * libm::sin(phi), a - r * libm::cos(phi));
                // A move turns the wheel by one step, from the entry to the exit.
                angle(start + 2.0 * half) - angle(start) - 2.0 * PI / f64::from(slots)
            };
            let holds = ANY.filter(|slots| !vanishes(off(*slots))).count() == 0;
            let lost = off(4).to_degrees().abs();
            Finding::new(holds, format!("in one move of four slots {lost:.1} degrees are missing"))
        })
        .by(Vectors, move |stated| {
            let aside = |slots: u32| {
                // The pin enters where its path meets the slot along the slot: across its own arm.
                let (r, a, _, start) = entry(slots, stated);
                let arm = Vector2::new(r * libm::cos(start), r * libm::sin(start));
                arm.dot(&(arm - Vector2::new(a, 0.0))) / (r * a)
            };
            let holds = ANY.filter(|slots| !vanishes(aside(*slots))).count() == 0;
            Finding::new(holds, format!("at the start arm and slot make {:.2} of a right angle's cosine", aside(4)))
        })
        .corrected(
            "from the line of centres",
            word(
                "The formula gives zero for the angle zero, and the wheel's angle is zero on the line of centres. The driving \
                 phase starts half a move before. The wheel's speed, beside it, counts the angle from the line of centres, \
                 too.",
                "The pin by its coordinates, and the direction of the slot as the pin enters.",
                "Somebody who passes an angle counted from the entry gets a wheel that moves by half a step.",
            ),
        )
}
