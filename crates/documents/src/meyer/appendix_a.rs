//! Appendix A: the sizes of the three escapements for their drawings, figures 12 to 14.

use super::hand_over_letters::{self, RIGHT_TRIANGLE, UNIT};
use super::*;
use geneva_evidence::Vocabulary;
use geneva_evidence::tex::decide;
use geneva_kinematics::indexing::Indexing;

/// What the appendix prints for one mechanism; each with its id.
struct Printed {
    /// Where the first of the four lines stands.
    locator: &'static str,
    theta: [&'static str; 2],
    phi: [&'static str; 2],
    centre_equation: [&'static str; 2],
    centre: [&'static str; 2],
    radius_equation: [&'static str; 2],
    radius: [&'static str; 2],
}

pub(super) fn claims() -> Vec<Claim> {
    let [theta, phi, centre_equation, centre, radius_equation, radius] = three_slots();
    let three_slots =
        [theta, phi, centre_equation, corrected_centre(centre), radius_equation, corrected_radius(radius)];
    [vec![unit()], four_slots().into(), three_slots.into(), six_slots().into(), drawings()].concat()
}

fn unit() -> Claim {
    at("Appendix A, 2nd sentence")
        .equation("meyer.app-a.unit", "R = 1.000", "unit of length for the drawings")
        .in_letters(UNIT)
        .with_second_witness(Evidence::OTHER_PLACE_IN_SOURCE, || {
            let ids =
                ["meyer.app-a.four-slots.radius", "meyer.app-a.three-slots.radius", "meyer.app-a.six-slots.radius"];
            let radii = ids.map(|id| MEYER.printed_number(id));
            Finding::new(
                radii.iter().any(|radius| *radius != radii[0]),
                format!("R is computed below, as {}, {} and {}", radii[0], radii[1], radii[2]),
            )
        })
        .corrected(
            "r = 1.000",
            Slip {
                id: "",
                reason: "R is the distance of the pin from the follower's axis, which differs from mechanism to \
                         mechanism. But everything that follows is computed with the radius r of the pins' circle as \
                         one. With four slots the two are equal. We cannot tell whether the capital is the copy's or \
                         the author's. We count it as a mistake of the copy, because r is printed correctly in the \
                         displays below.",
                witness: "The appendix computes R three times, with different results.",
                origin: Origin::Copy,
                consequence: Consequence::Copy,
                changes: "",
            },
        )
}

fn four_slots() -> [Claim; 6] {
    mechanism::<4>(Printed {
        locator: "Appendix A, four pins and four slots",
        theta: ["meyer.app-a.four-slots.theta", "45"],
        phi: ["meyer.app-a.four-slots.phi", "45"],
        centre_equation: [
            "meyer.app-a.four-slots.centre-equation",
            r"c = \frac{r}{\sin(\pi/n)} = \frac{1.}{\sin(\pi/4)}",
        ],
        centre: ["meyer.app-a.four-slots.centre", "1.414"],
        radius_equation: [
            "meyer.app-a.four-slots.radius-equation",
            r"R = \frac{r \sin \theta_o}{\sin \phi_o} = \frac{1 \sin 45^\circ}{\sin 45^\circ}",
        ],
        radius: ["meyer.app-a.four-slots.radius", "1.000"],
    })
}

fn three_slots() -> [Claim; 6] {
    mechanism::<3>(Printed {
        locator: "Appendix A, six pins and three slots",
        theta: ["meyer.app-a.three-slots.theta", "30"],
        phi: ["meyer.app-a.three-slots.phi", "60"],
        centre_equation: [
            "meyer.app-a.three-slots.centre-equation",
            r"c = \frac{r}{\sin(\pi/n)} = \frac{1.}{\sin(\pi/3)}",
        ],
        centre: ["meyer.app-a.three-slots.centre", "1.156"],
        radius_equation: [
            "meyer.app-a.three-slots.radius-equation",
            r"R = \frac{r \sin \theta_o}{\sin \phi_o} = \frac{1 \sin 30^\circ}{\sin 60^\circ}",
        ],
        radius: ["meyer.app-a.three-slots.radius", "0.557"],
    })
}

fn six_slots() -> [Claim; 6] {
    mechanism::<6>(Printed {
        locator: "Appendix A, three pins and six slots",
        theta: ["meyer.app-a.six-slots.theta", "60"],
        phi: ["meyer.app-a.six-slots.phi", "30"],
        centre_equation: [
            "meyer.app-a.six-slots.centre-equation",
            r"c = \frac{r}{\sin(\pi/n)} = \frac{1.}{\sin(\pi/6)}",
        ],
        centre: ["meyer.app-a.six-slots.centre", "2.000"],
        radius_equation: [
            "meyer.app-a.six-slots.radius-equation",
            r"R = \frac{r \sin \theta_o}{\sin \phi_o} = \frac{1 \sin 60^\circ}{\sin 30^\circ}",
        ],
        radius: ["meyer.app-a.six-slots.radius", "1.732"],
    })
}

/// The sides in letters, which hold at every size. With the numbers of one mechanism some letters are equal, and one for another
/// goes unnoticed.
fn without_numbers(tex: &str) -> &str {
    tex.rsplit_once('=').map_or(tex, |(letters, _)| letters)
}

fn holds_with(tex: &str, vocabulary: Vocabulary) -> Option<bool> {
    reading::holds(tex, (vocabulary.numbers)())
}

/// The six claims of one mechanism, in the order of its four lines.
fn mechanism<const SLOTS: u32>(is: Printed) -> [Claim; 6] {
    let value = |[id, printed]: [&'static str; 2], meaning, unit, computed: fn() -> f64, witness: fn() -> f64| {
        at(is.locator)
            .value(id, printed, unit, meaning)
            .first_route(Evidence::CLOSED_FORM, computed)
            .second_route(Evidence::VECTORS, witness)
    };
    let equation = |[id, printed]: [&'static str; 2], meaning| {
        let [drawn, any] = [hand_over_letters::drawn::<SLOTS>(), RIGHT_TRIANGLE];
        at(is.locator)
            .equation(id, printed, meaning)
            .decided(move |tex| decide(tex, drawn.exact).and(decide(without_numbers(tex), any.exact)))
            .read(Evidence::VECTORS, move |tex| {
                let letters = without_numbers(tex);
                Some(holds_with(tex, drawn)? && (!letters.contains('=') || holds_with(letters, any)?))
            })
    };
    [
        value(
            is.theta,
            "driver's angle at the hand-over",
            "°",
            || of::<SLOTS>(|at| at.wheel().engagement_half_angle().to_degrees()),
            || drawn::<SLOTS>(|pin, _| degrees(pin)),
        ),
        value(
            is.phi,
            "follower's angle at the hand-over",
            "°",
            || of::<SLOTS>(|at| at.follower_half_angle().to_degrees()),
            || drawn::<SLOTS>(|pin, axis| degrees(&seen_from(axis, pin))),
        ),
        equation(is.centre_equation, "centre distance in the unit of the drawings, from Eqs. (1-1) and (1-2)"),
        value(
            is.centre,
            "centre distance",
            "",
            || of::<SLOTS>(Mechanism::centre_distance_ratio),
            || drawn::<SLOTS>(|_, axis| axis.norm()),
        ),
        equation(is.radius_equation, "distance of the pin from the follower's axis at the hand-over, from Eq. (1-5)"),
        value(
            is.radius,
            "distance of the pin from the follower's axis at the hand-over",
            "",
            || of::<SLOTS>(Mechanism::rim_radius),
            || drawn::<SLOTS>(|pin, axis| (pin - axis).norm()),
        ),
    ]
}

fn corrected_centre(claim: Claim) -> Claim {
    claim.corrected(
        "1.155",
        Slip {
            id: "",
            reason: "The centre distance is one over the sine of 60°, or 2/√3, which is a little less than the printed \
                     number. Taking √3 as 1.73 would give the printed number, but the appendix itself, further down, \
                     gives √3 to one more place. It is also possible that a digit was misread, by the author or in the \
                     copy.",
            witness: "We computed the hand-over in coordinates, with exact square roots.",
            origin: Origin::Unknown,
            consequence: Consequence::Number,
            changes: "The last digit of one centre distance is wrong, but nothing is computed from this distance.",
        },
    )
}

fn corrected_radius(claim: Claim) -> Claim {
    claim.corrected(
        "0.577",
        Slip {
            id: "",
            reason: "The appendix divides the sine of 30° by the sine of 60°, which gives one over the square root of \
                     three. No rounding of the sines gives the printed digits, and the printed centre distance does \
                     not give them either. Only the middle digit is wrong, and we cannot tell whether it was \
                     misprinted or misread in copying.",
            witness: "We computed the hand-over in coordinates, with exact square roots.",
            origin: Origin::Unknown,
            consequence: Consequence::Result,
            changes: "For six pins, a follower cut to the printed radius would be too small, so each pin would leave \
                      its slot before the next pin enters.",
        },
    )
}

fn drawings() -> Vec<Claim> {
    let drawing = |id, locator, meaning, printed| {
        let reason = "The copy we had does not contain the drawing, so there is no length to measure";
        at(locator).figure(id, printed, meaning).missing(reason)
    };
    vec![
        drawing(
            "meyer.fig-12",
            "Fig. 12",
            "scale of the drawing of four pins and four slots",
            r"\text{SCALE: } 2\frac{1}{2} \text{ to } 1",
        ),
        drawing(
            "meyer.fig-13",
            "Fig. 13",
            "scale of the drawing of six pins and three slots",
            r"\text{SCALE: } 2\frac{1}{2} \text{ to } 1",
        ),
        drawing(
            "meyer.fig-14",
            "Fig. 14",
            "scale of the drawing of three pins and six slots",
            r"\text{SCALE: } 1\frac{1}{2} \text{ to } 1",
        ),
    ]
}

/// A quantity of the escapement of so many slots.
fn of<const SLOTS: u32>(quantity: fn(Mechanism) -> f64) -> f64 {
    Mechanism::new(SLOTS).map_or(f64::NAN, quantity)
}

/// A length or angle in the drawing of the hand-over: from the places of the pin that leaves and of the follower's
/// axis, both from the driver's axis, with their roots exact until then.
fn drawn<const SLOTS: u32>(quantity: fn(&Vector2<f64>, &Vector2<f64>) -> f64) -> f64 {
    Mechanism::new(SLOTS).map_or(f64::NAN, |at| {
        let layout = at.hand_over().layout;
        let [pin, axis] = [&layout.pins[0], &layout.follower_axis].map(|place| place.map(|x| x.approximate()));
        quantity(&pin, &axis)
    })
}

/// A place from the follower's axis, first coordinate towards the driver.
fn seen_from(axis: &Vector2<f64>, place: &Vector2<f64>) -> Vector2<f64> {
    Vector2::new(axis.x - place.x, place.y)
}

fn degrees(direction: &Vector2<f64>) -> f64 {
    libm::atan2(direction.y, direction.x).to_degrees()
}
