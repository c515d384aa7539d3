//! What the letters and words of programs mean, as the programs say and as they draw.

use super::fit::ANY;
use super::models::SHIPPED;
use super::*;
use geneva_evidence::agreement::{agrees, vanishes};
use nalgebra::Vector2;

pub(super) fn claims() -> Vec<Claim> {
    vec![
        pin_diameter(),
        slot_width(),
        half_slot_width(
            WINDOW,
            "wild.freecad-window.slot-width",
            SHIPPED,
            "This version has no pin and no tolerance of its own, so we take both from the macro on which it is based. \
             With any other pin and tolerance the result is the same.",
        ),
        half_slot_width(
            WORKBENCH,
            "wild.gear-workbench.slot-width",
            WORKBENCH_SHIPPED,
            "We take the pin and the tolerance that the program is shipped with. With any other pin and tolerance the \
             result is the same.",
        ),
        slot_centre(MACRO, "wild.freecad.slot-centre", r"s = \text{Slot Center Width}", MACRO_BOX)
            .interpreted_as(ALONG)
            .but_not("the length s is the slot's width from side to side"),
        slot_centre(WINDOW, "wild.freecad-window.slot-centre", r"s = \text{Slot Center Width}", WINDOW_BOX)
            .interpreted_as(ALONG)
            .but_not("the length s is the slot's width from side to side"),
        slot_centre(WORKBENCH, "wild.gear-workbench.slot-centre", "Width of slot at center (s)", WORKBENCH_BOX)
            .corrected(
                "Length of slot (s)",
                word(
                    "The program draws a slot whose length is s. The slot's width is another length, and it is the \
                     same at the slot's centre as everywhere else.",
                    "For 3 to 60 slots, we used coordinates to find the rim and the deepest position of the pin's \
                     centre. The length s reaches from one to the other.",
                    "The drawing does not change.",
                ),
            ),
        stop_arc(),
        aligned(),
        right_angle(),
        from_entry(),
    ]
}

/// The slip of a word; what is computed with the letter is not touched by it.
const fn word(reason: &'static str, witness: &'static str, changes: &'static str) -> Slip {
    Slip { consequence: Consequence::Wording, origin: Origin::Misprint, ..slip(reason, witness, changes) }
}

/// The slip of a sentence that describes something.
const fn remark(reason: &'static str, witness: &'static str, changes: &'static str) -> Slip {
    Slip { consequence: Consequence::Remark, ..word(reason, witness, changes) }
}

/// Pin radius and tolerance with which the workbench is shipped, and its crank radius and number of slots.
const WORKBENCH_SHIPPED: [f64; 2] = [1.5, 0.5];

/// Crank, rim, pin and tolerance of a slot that is drawn; the axes are at a right angle at the pin.
type Boxed = ([f64; 2], [f64; 2]);

/// As the macro is shipped.
const MACRO_BOX: Boxed = ([25.0, 60.0], SHIPPED);

/// With the macro's crank, pin, tolerance and number of slots.
const WINDOW_BOX: Boxed = ([25.0, 25.0 * 1.732_050_807_568_877_2], SHIPPED);

/// As the workbench is shipped, with four slots.
const WORKBENCH_BOX: Boxed = ([15.0, 15.0], WORKBENCH_SHIPPED);

const ALONG: &str = "We read it as how far the slot extends along its centre line, from the rim to the deepest place \
                     of the pin's centre. The width is another length of the same list.";

fn pin_diameter() -> Claim {
    MACRO
        .statement("wild.freecad.pin", r"p = \text{Drive Pin Diameter}", "what the length p is")
        .first_route(Evidence::VECTORS, |stated| {
            // The drawn pin is a cylinder of radius p: two opposite points of it.
            let [p, _] = SHIPPED;
            let [one, other] = [0.0, PI].map(|angle| Vector2::new(libm::cos(angle), libm::sin(angle)) * p);
            let (width, said) = ((one - other).norm(), stated.pick(2.0, 1.0) * p);
            Finding::new(
                agrees(width, said),
                format!("the pin is drawn {width:.1} across, and this form says {said:.1}"),
            )
        })
        .second_route(Evidence::OTHER_PLACE_IN_SOURCE, |stated| {
            // The drawn slot reaches p + t to either side: the tolerance should be what is left beside the pin.
            let [p, t] = SHIPPED;
            let left = p + t - stated.pick(1.0, 0.5) * p;
            Finding::new(
                vanishes(left - t),
                format!("the tolerance is {t:.2}, and by this form the slot leaves {left:.2} on each side of the pin"),
            )
        })
        .corrected(
            r"p = \text{Drive Pin Radius}",
            word(
                "The program makes the pin a cylinder of radius p, and it cuts a slot that reaches w = p + t to either \
                 side of its centre line, where t is the tolerance. So pin and slot are twice as wide as the program's \
                 list of sizes says.",
                "The version of the macro that opens a window calls p the radius.",
                "If you enter the pin's diameter for p, the pin and the slot are twice as wide as you want them.",
            ),
        )
}

/// The width of a slot for a pin of diameter p, as the macro's own list says.
fn slot_width() -> Claim {
    MACRO
        .statement(
            "wild.freecad.slot-width",
            r"w = p + t = \text{Slot Width}",
            "what the length w is, if p is the pin's diameter and t the tolerance",
        )
        .first_route(Evidence::VECTORS, |stated| {
            // The pin in the middle between the sides of a slot as wide as is said.
            let [p, t] = SHIPPED;
            let side = stated.pick(0.5, 1.0) * (p + t);
            let gap = |sign: f64| (Vector2::new(0.0, sign * side) - Vector2::new(0.0, sign * p / 2.0)).norm();
            let play = gap(1.0) + gap(-1.0);
            Finding::new(
                vanishes(play - t),
                format!("the slot leaves a pin of diameter {p:.1} a play of {play:.2}, and the tolerance is {t:.2}"),
            )
        })
        .second_route(Evidence::OTHER_PLACE_IN_SOURCE, |stated| {
            // The program draws both to either side of the middle: the slot is to the pin as it is said to be.
            let [p, t] = SHIPPED;
            let [slot, pin] = [p + t, p].map(|half| (Vector2::new(0.0, half) - Vector2::new(0.0, -half)).norm());
            let (drawn, said) = (slot / pin, stated.pick(1.0, 2.0) * (p + t) / p);
            Finding::new(
                agrees(drawn, said),
                format!(
                    "the slot is drawn {drawn:.4} times as wide as the pin and is said to be {said:.4} times as wide"
                ),
            )
        })
        .interpreted_as(
            "We take p as the pin's diameter, as the same list says. The program draws pin and slot twice as wide, but \
             we count this once, with the pin.",
        )
        .but_not("the length w is half the slot's width")
}

/// The width of a slot for a pin of radius p, of which the programs draw twice as much: w to either side of its middle.
fn half_slot_width(place: Locator, id: &'static str, sizes: [f64; 2], reading: &'static str) -> Claim {
    place
        .statement(
            id,
            r"w = p + t = \text{Slot Width}",
            "what the length w is, if p is the pin's radius and t the tolerance",
        )
        .first_route(Evidence::VECTORS, move |stated| {
            // Two corners of what is cut out, on either side of the slot.
            let [p, t] = sizes;
            let w = p + t;
            let [one, other] = [-w, w].map(|aside| Vector2::new(0.0, aside));
            let (width, said) = ((one - other).norm(), stated.pick(2.0, 1.0) * w);
            Finding::new(
                agrees(width, said),
                format!("the slot is drawn {width:.2} wide, and this form says {said:.2}"),
            )
        })
        .second_route(Evidence::OTHER_PLACE_IN_SOURCE, move |stated| {
            // What a slot as wide as is said leaves beside the pin, which is drawn with p for its radius.
            let [p, t] = sizes;
            let left = stated.pick(1.0, 0.5) * (p + t) - p;
            Finding::new(
                vanishes(left - t),
                format!(
                    "if we subtract the pin's radius from half of the slot width, we should get the tolerance, {t:.2}, and \
                     we get {left:.2}"
                ),
            )
        })
        .interpreted_as(reading)
        .corrected(
            r"w = p + t = \text{half the Slot Width}",
            word(
                "The program cuts a slot that reaches w to either side of its centre line and ends in an arc of radius \
                 w.",
                "A slot of width w would be narrower than the pin.",
                "The drawing does not change.",
            ),
        )
}

/// What the length s of a slot is called: how far it extends along its middle, or from side to side.
fn slot_centre(place: Locator, id: &'static str, printed: &'static str, (arms, sizes): Boxed) -> Claim {
    place
        .statement(
            id,
            printed,
            "what the length s = a + b − c is, for crank radius a, wheel radius b and centre distance c",
        )
        .first_route(Evidence::VECTORS, move |stated| {
            // Two corners of what is cut out, across from one another.
            let ([a, b], [p, t]) = (arms, sizes);
            let (s, w) = (a + b - libm::hypot(a, b), p + t);
            let across = Vector2::new(s - a, w) - Vector2::new(-a, -w);
            let extent = stated.pick(across.x, across.y);
            Finding::new(
                agrees(extent, s),
                format!("the slot is drawn {extent:.2} {}, and this form says {s:.2}", stated.pick("long", "wide")),
            )
        })
        .second_route(Evidence::CLOSED_FORM, move |stated| {
            let [p, t] = sizes;
            let holds = |slots: u32| {
                let Fit { crank, rim, centres, deepest, .. } = Fit::by_vectors(slots);
                let width = 2.0 * (p + t) / arms[0] * crank;
                agrees(stated.pick(rim - deepest, width), crank + rim - centres)
            };
            let what = stated.pick("length", "width");
            Finding::for_all(ANY, holds, |holding, all| {
                format!("s is the slot's {what} for {holding} of the {all} numbers of slots that we tried")
            })
        })
}

/// The factor between the pin and what the wheel's arcs are smaller than the crank.
fn stop_arc() -> Claim {
    GENERATOR
        .statement(
            "wild.generator.stop-arc",
            "1.5 × pin radius",
            "crank radius a less the radius y of the wheel's arcs, in a program with y = a − 1.5 p",
        )
        .first_route(Evidence::CLOSED_FORM, |stated| {
            let p = 4.0;
            let said = stated.number() * stated.pick(p, p / 2.0);
            Finding::new(
                agrees(said, 1.5 * p),
                format!(
                    "the difference a − y is {:.1} for a pin of diameter {p:.1}, and this form says {said:.1}",
                    1.5 * p
                ),
            )
        })
        .second_route(Evidence::OTHER_PLACE_IN_SOURCE, |stated| {
            // The pin is drawn with p/2 for its radius, and slots as wide as p and the clearance.
            let (p, crank) = (4.0, 25.0);
            let drawn = [-p / 2.0, p / 2.0].map(|aside| Vector2::new(crank, aside));
            let across = (drawn[0] - drawn[1]).norm();
            let arc = crank - 1.5 * p;
            let said = crank - stated.number() * stated.pick(across, across / 2.0);
            Finding::new(
                agrees(arc, said),
                format!("the arcs have a radius of {arc:.1}, and with the pin as drawn, this form gives {said:.1}"),
            )
        })
        .corrected(
            "1.5 × pin diameter",
            word(
                "In y = a − 1.5 p, the letter p is the pin's diameter. The program says so, and it draws the pin with \
                 the radius p/2.",
                "We looked at the pin as the program draws it.",
                "The drawing does not change.",
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
            format!(
                "as the pin enters with the wheel at rest, the angle between slot and crank is {:.1} degrees",
                angle(4)
            ),
        )
    };
    ANVILATE
        .statement(
            "wild.anvilate.aligned",
            "aligned with the crank arm",
            "direction of the slot relative to the crank as the pin enters, for a wheel that starts from rest",
        )
        .first_route(Evidence::CLOSED_FORM, move |stated| {
            // The law of cosines in the triangle of the axes and the pin.
            let angle = |slots: u32| {
                let Fit { crank: a, centres: c, rim: r, .. } = Fit::by_wheel(slots);
                libm::acos((a * a + r * r - c * c) / (2.0 * a * r)).to_degrees()
            };
            found(stated, &angle)
        })
        .second_route(Evidence::VECTORS, move |stated| {
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
            remark(
                "The pin moves at right angles to the crank, and it must move along the slot. If the slot were along \
                 the crank, the pin would move across the slot at full speed.",
                "Coordinates give the pin's position at entry, for 3 to 60 slots.",
                "Nothing changes, because the next line of the page puts the right angle at the pin, and the page's \
                 formulas follow from this.",
            ),
        )
}

/// Where the right angle is as the pin enters.
fn right_angle() -> Claim {
    // The two sides of the angle at the pin, or of the angle at the driver's axis.
    let is_right = |stated: Stated, wheel: fn(u32) -> Fit| {
        let square = |slots: u32| {
            let Fit { crank, centres, rim, .. } = wheel(slots);
            let [one, other, opposite] = stated.pick([crank, rim, centres], [crank, centres, rim]);
            vanishes((one * one + other * other - opposite * opposite) / (centres * centres))
        };
        Finding::for_all(ANY, square, |right, all| format!("the angle is right for {right} of {all} numbers of slots"))
    };
    ANVILATE
        .statement(
            "wild.anvilate.right-angle",
            "a right angle at the pin",
            "where the triangle of the axes and the pin has its right angle as the pin enters with the wheel at rest",
        )
        .first_route(Evidence::CLOSED_FORM, move |stated| is_right(stated, Fit::by_wheel))
        .second_route(Evidence::VECTORS, move |stated| is_right(stated, Fit::by_vectors))
        .but_not("at the driver's axis")
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
            "where the driver's angle φ is measured from, if the wheel's angle is the inverse tangent of r sin φ/(a − \
             r cos φ), with crank radius r and centre distance a",
        )
        .first_route(Evidence::CLOSED_FORM, move |stated| {
            let off = |slots: u32| {
                let (r, a, half, start) = entry(slots, stated);
                let angle = |phi: f64| {
                    if phi.abs() > half * (1.0 + 1e-12) {
                        // Outside of the driving phase the program keeps the wheel half a step from the line of centres.
                        (PI / f64::from(slots)).copysign(phi)
                    } else {
                        libm::atan2(r * libm::sin(phi), a - r * libm::cos(phi))
                    }
                };
                // A move turns the wheel by one step, from the entry to the exit.
                angle(start + 2.0 * half) - angle(start) - 2.0 * PI / f64::from(slots)
            };
            let holds = ANY.filter(|slots| !vanishes(off(*slots))).count() == 0;
            let lost = off(4).to_degrees().abs();
            Finding::new(holds, format!("in a move, a four-slot wheel turns {lost:.1} degrees less than one step"))
        })
        .second_route(Evidence::VECTORS, move |stated| {
            let aside = |slots: u32| {
                // The pin enters where its path meets the slot along the slot: across its own arm.
                let (r, a, _, start) = entry(slots, stated);
                let arm = Vector2::new(r * libm::cos(start), r * libm::sin(start));
                arm.dot(&(arm - Vector2::new(a, 0.0))) / (r * a)
            };
            let holds = ANY.filter(|slots| !vanishes(aside(*slots))).count() == 0;
            Finding::new(
                holds,
                format!(
                    "at the start of a move the scalar product of crank and slot should be zero, and it is {:.2} times the \
                     product of crank radius and centre distance",
                    aside(4)
                ),
            )
        })
        .corrected(
            "from the line of centres",
            remark(
                "The formula gives zero for the angle zero, and the wheel's angle is zero on the line of centres. But \
                 the driving phase starts half a move earlier. The formula for the wheel's speed, printed beside this \
                 one, measures the angle from the line of centres, too.",
                "Coordinates give the pin's position and the slot's direction as the pin enters.",
                "If you pass an angle measured from the entry, the wheel moves by only half a step.",
            ),
        )
}
