//! What the text after the program says of its start, its angle and the way from pin to pin.

use super::example::first_derivative;
use super::fold::fold;
use super::listing_start::start_solves;
use super::program::{as_letters, by_coefficients};
use super::*;
use crate::meyer::runs;
use geneva_dynamics::{Inertias, Parameters, Slots};

const AFTER: &str = "Appendix B, paragraphs after the program";

pub fn claims() -> Vec<Claim> {
    vec![
        statement(
            "meyer.app-b.initial-angles",
            AFTER,
            "driver's angle at the start for six, four and three pins",
            r"-30° , -45° , or -60°",
            (LimitCase, || angles("meyer.app-b.initial-angles")),
            (Vectors, at_entry),
        ),
        statement(
            "meyer.app-b.from-rest",
            AFTER,
            "the driver starts from rest",
            "0 rad/sec",
            (OtherPlaceInSource, || {
                let zero = |id: &str| numbers(id).last() == Some(&0);
                Finding::new(zero("meyer.app-d.from-rest") && zero("meyer.app-b.from-rest"), "Appendix D has it")
            }),
            (ClosedForm, || start_solves(0.0)),
        ),
        statement(
            "meyer.app-b.large-time",
            AFTER,
            "the equation of motion is shut off at the start, where the acceleration has its own line",
            "LGT (\"large time\")",
            (ClosedForm, || start_solves(0.0)),
            (OtherPlaceInSource, || {
                let opposite = claim("meyer.app-b.small-time").is_some_and(|claim| claim.printed == "SMT");
                Finding::new(opposite, "the program has it as the opposite of SMT")
            }),
        ),
        statement(
            "meyer.app-b.primary",
            AFTER,
            "the program's line for the acceleration is the equation derived",
            "identical to the equation derived",
            (ClosedForm, || by_coefficients(|lines, at| (lines.acceleration, at.acceleration))),
            (Vectors, || as_letters(|lines| lines.acceleration, "theta''")),
        ),
        first_derivative(Kind::Statement, "meyer.app-b.speed-name", AFTER, "name of the driver's speed", "LDX", "1DX"),
        first_derivative(Kind::Statement, "meyer.app-b.angle-name", AFTER, "name of the driver's speed", "LDX", "1DX"),
        statement(
            "meyer.app-b.engaged",
            AFTER,
            "a pin is in its slot within these angles, for six, four and three pins",
            "±30°, ±45°, or ±60°",
            (LimitCase, || angles("meyer.app-b.engaged")),
            (Vectors, at_entry),
        ),
        fold(
            "meyer.app-b.fold",
            AFTER,
            "the angle within an engagement is the driver's angle modulo 90°, less 30°, 45° or 60°",
            r"90° , minus either 30° , 45° , or 60°",
            "60°, 90° or 120°, minus 30°, 45° or 60°",
        ),
        statement(
            "meyer.app-b.hand-over",
            AFTER,
            "the next pin takes over the driver's speed and acceleration; the \
                    follower's acceleration changes sign",
            "initial values of velocity and acceleration",
            (ClosedForm, || {
                let holds = Slots::ALL.iter().all(|slots| {
                    let sound = Inertias::new(1.0, 2.0).and_then(|both| Parameters::new(*slots, both, 1.0, 0.25));
                    sound.is_ok_and(|sound| {
                        let end = slots.engagement_half_angle();
                        let [last, first] =
                            [end, -end].map(|at| sound.acceleration(at, 1.5).map_or(f64::NAN, |a| a.value));
                        agrees(last, first)
                    })
                });
                Finding::new(
                    holds,
                    "the driver's acceleration is the same as a pin leaves and as the next \
                        enters",
                )
            }),
            (Vectors, || {
                for_each(
                    |at| {
                        let end = at.driver_half_angle();
                        let [leaving, entering] = [end, -end].map(|angle| Seen::new(at, angle));
                        let still = [&leaving, &entering].iter().all(|pin| vanishes(pin.turning()));
                        still && agrees(leaving.turning_rate(), -entering.turning_rate())
                    },
                    "the follower stands still by either pin, and its acceleration changes sign",
                )
            }),
        ),
        statement(
            "meyer.app-b.one-pin-at-a-time",
            AFTER,
            "the motion is a row of engagements of one pin each",
            "discrete, single pin engagements",
            (Vectors, || {
                for_each(
                    |at| {
                        (-9..=9).all(|k| {
                            let layout = at.layout(at.driver_half_angle() * f64::from(k) / 10.0);
                            layout.is_ok_and(|layout| layout.engaged.len() == 1)
                        })
                    },
                    "one pin is in a slot between two hand-overs",
                )
            }),
            (ExactIdentity, || exactly(|at| at.layout.engaged.len() == 2, "two at the hand-over itself")),
        ),
        statement(
            "meyer.app-b.run-length",
            AFTER,
            "time at which a run ends",
            "0.2 seconds",
            (OtherPlaceInSource, || {
                let end = claim("meyer.listing.run-length").and_then(|claim| claim.printed.parse::<f64>().ok());
                let said =
                    claim("meyer.app-b.run-length").and_then(|claim| claim.printed.split(' ').next()?.parse().ok());
                Finding::new(end.is_some() && end == said, "the program ends there")
            }),
            (LimitCase, || {
                let said = claim("meyer.app-b.run-length")
                    .and_then(|claim| claim.printed.split(' ').next()?.parse::<f64>().ok());
                let points = said.map_or(f64::NAN, |said| said / runs::interval());
                Finding::new(agrees(points, points.round()), format!("{points:.0} print intervals"))
            }),
        ),
    ]
}

/// Whether the printed angles are, in order, those of three, four and six slots.
fn angles(id: &str) -> Finding {
    let printed = numbers(id);
    let degrees = |at: &Escapement| 180.0 / f64::from(at.pins());
    let same = Escapement::all().iter().zip(&printed).all(|(at, angle)| agrees(degrees(at), f64::from(*angle)));
    Finding::new(same && printed.len() == 3, "180° over the number of pins, for six, four and three")
}

/// Whether the follower stands still at the printed angles.
fn at_entry() -> Finding {
    let printed = numbers("meyer.app-b.initial-angles");
    let still = Escapement::all()
        .iter()
        .zip(&printed)
        .all(|(at, angle)| vanishes(Seen::new(at, -f64::from(*angle).to_radians()).turning()));
    Finding::new(still && printed.len() == 3, "the pin moves along its slot at these angles")
}
