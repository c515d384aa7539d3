//! The arcs and the journal that lock the wheel between two advances.

use super::letters::SIZES_OF_FOUR;
use super::text::{SIMPLE, VARIETIES};
use super::*;
use crate::duals::halved;
use geneva_evidence::equal_to;
use geneva_kinematics::indexing::Indexing;
use nalgebra::Vector2;

pub(super) fn journal_bearing() -> Claim {
    VARIETIES
        .statement(
            "jazar.journal-bearing",
            "journal bearing",
            "while the wheel is held, its arc and the driver's journal form a bearing, because arc and journal have \
             the same centre",
        )
        .first_route(Evidence::CLOSED_FORM, |stated| {
            for_all_stations(
                |wheel| {
                    // Law of cosines, with 2 sin² of half the angle for what its cosine leaves of one: the pin, a
                    // crank radius from the driver's axis, enters at the rim, and the slot is half a pitch from the
                    // arc's middle.
                    let (rim, centres) = (wheel.wheel_radius_ratio(), centres(wheel, stated));
                    let sine = libm::sin(wheel.half_pitch_angle() / 2.0);
                    agrees((rim - centres) * (rim - centres) + 4.0 * rim * centres * sine * sine, 1.0)
                },
                "the mouth of a slot is a crank radius from the centre of the arc beside it",
            )
        })
        .second_route(Evidence::VECTORS, |stated| {
            for_all_stations(
                |wheel| {
                    let end = wheel.engagement_half_angle();
                    // The pin from the end of one engagement to the beginning of the next, the wheel at rest.
                    (0..=20).map(|step| end + (2.0 * PI - 2.0 * end) * f64::from(step) / 20.0).all(|crank| {
                        let pin = pin_from_pivot(&wheel.centre_distance_ratio(), &Turn::from_radians(crank));
                        agrees((pin - Vector2::new(centres(wheel, stated), 0.0)).norm(), 1.0)
                    })
                },
                "in the dwell the driver turns about the centre of an arc",
            )
        })
        .but_not("the arcs have their centres on the wheel's rim")
}

pub(super) fn locking() -> Claim {
    SIMPLE
        .statement(
            "jazar.locking",
            "to lock the star wheel",
            "a journal in an arc of the wheel locks the wheel, whichever way the wheel is pushed",
        )
        .first_route(Evidence::CLOSED_FORM, |stated| {
            for_all_stations(
                |wheel| locks(wheel, between_rim_and_pin(wheel, 0.5), stated.pick(&[1.0, -1.0], &[1.0])),
                "if the wheel turned a little either way, an end of the arc would be inside the journal",
            )
        })
        .second_route(Evidence::VECTORS, |stated| {
            for_all_stations(
                |wheel| holds(wheel, between_rim_and_pin(wheel, 0.5), stated.pick(&[1.0, -1.0], &[1.0])),
                "whichever way the wheel turned, an end of the arc would approach the driver's axis",
            )
        })
        .but_not("half of the arc, on one side of the line of centres, locks the wheel as well")
}

pub(super) fn journal_radius() -> Claim {
    SIMPLE
        .statement("jazar.journal-radius", "flexible", "the radius of the journal can be chosen")
        .first_route(Evidence::CLOSED_FORM, |stated| {
            for_all_stations(
                |wheel| radii(wheel, stated).all(|journal| locks(wheel, journal, &[1.0, -1.0])),
                "if the wheel turned a little either way, an end of the arc would be inside the journal",
            )
        })
        .second_route(Evidence::VECTORS, |stated| {
            for_all_stations(
                |wheel| radii(wheel, stated).all(|journal| holds(wheel, journal, &[1.0, -1.0])),
                "whichever way the wheel turned, an end of the arc would approach the driver's axis",
            )
        })
        .but_not("a journal that does not reach the wheel's rim locks the wheel as well")
        .interpreted_as("Any journal that reaches the wheel's rim and leaves room for the pin's path locks the wheel.")
}

pub(super) fn cutout_centres() -> Claim {
    SIMPLE
        .equation(
            "jazar.cutout-centres",
            r"\sqrt{2}r",
            "radius of the circle through the centres of the locking arcs, for four stations",
        )
        .rewritten_and_proven(SIZES_OF_FOUR, equal_to(r"\text{arcs}"))
        .with_second_witness(Evidence::VECTORS, || {
            // The arc for a journal as large as the pin's circle, in the wheel at rest, by three of its points: the
            // mouths of the two slots beside it, and on the line of centres the point of that circle next to the wheel.
            let centre = |wheel: &Wheel| {
                let mouth = Turn::from_radians(wheel.half_pitch_angle()).direction() * wheel.wheel_radius_ratio();
                let nearest = pin_from_pivot(&wheel.centre_distance_ratio(), &Turn::from_radians(0.0)).x;
                // On the line of centres, as far from a mouth as from the nearest point.
                (mouth.norm_squared() - nearest * nearest) / (2.0 * (mouth.x - nearest))
            };
            same(of(4, centre), 2f64.sqrt())
        })
}

pub(super) fn most_stations() -> Claim {
    curves::STATIONS
        .statement(
            "jazar.most-stations",
            "too short",
            "with very many stations the arcs that lock the wheel become too short",
        )
        .missing(
            "The text does not say by what measure an arc is too short, and the measures disagree. Take a locking disc \
             whose radius is six to nine tenths of the crank radius. Measured in wheel radii, the arcs get shorter \
             with each station beyond four. But measured in crank radii, or by the angle that they span, they grow. \
             With any number of stations the arcs lock the wheel, whichever way it is pushed. Measured in wheel \
             radii, the arcs of a spherical wheel get just as short as the arcs of a planar wheel, so this measure \
             does not explain why the handout says that the spherical wheel stays locked. No measure that we tried \
             makes both sentences of the handout true",
        )
}

/// How long the locking arcs of a wheel are, by several measures: planar, and spherical with axes at right angles.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LockingArcs {
    /// Length in wheel radii.
    pub in_wheel_radii: f64,
    /// Length in crank radii.
    pub in_crank_radii: f64,
    /// The angle that the arc embraces, as seen from its centre, in radians.
    pub angle: f64,
}

impl LockingArcs {
    /// Of a planar wheel, for a journal of so many crank radii.
    ///
    /// Half the angle is ψ with cos ψ = sin α (1 + f²) / (2 f), the journal's radius f.
    pub fn planar(wheel: &Wheel, journal: f64) -> Self {
        let sine = libm::sin(wheel.half_pitch_angle());
        let angle = 2.0 * libm::acos(sine * (1.0 + journal * journal) / (2.0 * journal));
        let in_crank_radii = journal * angle;
        Self { in_wheel_radii: in_crank_radii / wheel.wheel_radius_ratio(), in_crank_radii, angle }
    }

    /// Of a spherical wheel of as many stations, which is a hemisphere, for a journal whose angular radius is so much of
    /// that of the pin's circle.
    ///
    /// The centre of the arc is on the edge of the hemisphere, so the arc is half a circle, of the radius sin f α.
    pub fn spherical(wheel: &Wheel, journal: f64) -> Self {
        let alpha = wheel.half_pitch_angle();
        let in_wheel_radii = PI * libm::sin(journal * alpha);
        Self { in_wheel_radii, in_crank_radii: in_wheel_radii / libm::sin(alpha), angle: PI }
    }
}

/// Radius of the circle of the arcs' centres, or that of the rim.
fn centres(wheel: &Wheel, stated: Stated) -> f64 {
    stated.pick(wheel.locking_centres_ratio(), wheel.wheel_radius_ratio())
}

/// A journal's radius between the least, which touches the rim, and the pin's circle; below it for a part below zero.
fn between_rim_and_pin(wheel: &Wheel, part: f64) -> f64 {
    libm::pow(wheel.centre_distance_ratio() - wheel.wheel_radius_ratio(), 1.0 - part)
}

/// Nine radii all over that range, or one that is too small.
fn radii(wheel: &Wheel, stated: Stated) -> impl Iterator<Item = f64> {
    let parts: &[f64] = stated.pick(&[0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9], &[-0.1]);
    parts.iter().map(|part| between_rim_and_pin(wheel, *part))
}

/// Whether the journal fits in the arc, and the wheel, turned by a thousandth of half a pitch either way, would have an
/// end of the arc inside the journal.
///
/// The arc's ends are where its circle meets the rim, on the sides of the line of centres with these signs. The journal
/// has a clearance of a billionth.
fn locks(wheel: &Wheel, journal: f64, sides: &[f64]) -> bool {
    let (rim, distance) = (wheel.wheel_radius_ratio(), wheel.centre_distance_ratio());
    // Law of cosines, with 2 sin² of half the angle for what its cosine leaves of one.
    let (gap, product) = (distance - rim, 4.0 * rim * distance);
    let end = 2.0 * libm::asin(((journal - gap) * (journal + gap) / product).sqrt());
    let surface = journal * (1.0 - 1e-9);
    let inside = |angle: f64| {
        let sine = libm::sin(angle / 2.0);
        gap * gap + product * sine * sine < surface * surface
    };
    let fits = sides.iter().all(|side| !inside(side * end));
    let stops = |turn: &f64| sides.iter().any(|side| inside(side * end + turn * wheel.half_pitch_angle()));
    fits && [1e-3, -1e-3].iter().all(stops)
}

/// Whether, whichever way the wheel turns, an end of the arc approaches the driver's axis.
///
/// The ends are looked for along the journal, from the line of centres to the rim.
fn holds(wheel: &Wheel, journal: f64, sides: &[f64]) -> bool {
    let axis = Vector2::new(wheel.centre_distance_ratio(), 0.0);
    let end = end_of_the_arc(wheel, journal);
    let approach = |side: &f64| {
        let place = on_the_journal(wheel, journal, side * end);
        Vector2::new(-place.y, place.x).dot(&(axis - place))
    };
    let reaches = on_the_journal(wheel, journal, 0.0).norm() < wheel.wheel_radius_ratio();
    reaches && [1.0, -1.0].iter().all(|way| sides.iter().any(|side| approach(side) * way > 0.0))
}

/// The point of the journal at this angle from the line of centres, from the wheel's axis.
fn on_the_journal(wheel: &Wheel, journal: f64, angle: f64) -> Vector2<f64> {
    on_a_journal(wheel.centre_distance_ratio(), journal, angle)
}

/// The point of a journal at this angle from the line of centres, from the wheel's axis, with the driver's axis so far from
/// the wheel's.
fn on_a_journal(axis: f64, journal: f64, angle: f64) -> Vector2<f64> {
    Vector2::new(axis, 0.0) - Turn::from_radians(angle).direction() * journal
}

/// The angle at the driver's axis from the line of centres to where the journal comes out of the wheel.
fn end_of_the_arc(wheel: &Wheel, journal: f64) -> f64 {
    let (axis, rim) = (wheel.centre_distance_ratio(), wheel.wheel_radius_ratio());
    halved([0.0, PI], |angle| on_a_journal(axis, journal, angle).norm() < rim)[0]
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::Vector3;

    const JOURNALS: [f64; 4] = [0.6, 0.7, 0.8, 0.9];

    /// How a measure goes from each number of stations to the next, from four stations on.
    fn goes(of: impl Fn(&Wheel) -> f64) -> std::cmp::Ordering {
        let steps = wheels()[1..].windows(2).map(|pair| of(&pair[1]).total_cmp(&of(&pair[0])));
        let steps: Vec<_> = steps.collect();
        assert!(steps.iter().all(|step| *step == steps[0]), "not from each number of stations to the next");
        steps[0]
    }

    #[test]
    fn the_measures_of_an_arc_disagree_as_the_reason_says() {
        use std::cmp::Ordering::{Greater, Less};
        for journal in JOURNALS {
            assert_eq!(goes(|wheel| LockingArcs::planar(wheel, journal).in_wheel_radii), Less);
            assert_eq!(goes(|wheel| LockingArcs::planar(wheel, journal).in_crank_radii), Greater);
            assert_eq!(goes(|wheel| LockingArcs::planar(wheel, journal).angle), Greater);
            // A spherical wheel's arcs get shorter by the same measure, and as short.
            assert_eq!(goes(|wheel| LockingArcs::spherical(wheel, journal).in_wheel_radii), Less);
            let last = wheels().last().expect("a wheel");
            let [planar, spherical] =
                [LockingArcs::planar, LockingArcs::spherical].map(|of| of(last, journal).in_wheel_radii);
            assert!((planar / spherical - 1.0).abs() < 0.01 && planar < 0.01, "{planar} and {spherical}");
        }
        // From three stations to four the arc of a small journal grows by every measure.
        let [three, four] = [0, 1].map(|at| LockingArcs::planar(&wheels()[at], JOURNALS[0]));
        assert!(three.in_wheel_radii < four.in_wheel_radii);
    }

    #[test]
    fn the_arcs_are_as_long_as_their_places_say() {
        for wheel in wheels().iter().step_by(37) {
            for journal in JOURNALS {
                // By where the journal comes out of the wheel, found by halving.
                let found = 2.0 * end_of_the_arc(wheel, journal);
                assert!((found - LockingArcs::planar(wheel, journal).angle).abs() < 1e-9, "{found}");
                // On the sphere: the circle about a place of the edge, of which half is on the wheel, from step to step.
                let half = journal * wheel.half_pitch_angle();
                let place = |step: i32| {
                    let (s, c) = libm::sincos(PI * f64::from(step) / 1000.0);
                    Vector3::new(libm::cos(half), libm::sin(half) * c, libm::sin(half) * s)
                };
                assert!((0..=1000).all(|step| place(step).z >= 0.0) && (1001..2000).all(|step| place(step).z < 0.0));
                let length: f64 = (0..1000).map(|step| (place(step + 1) - place(step)).norm()).sum();
                let by_formula = LockingArcs::spherical(wheel, journal);
                assert!((length / by_formula.in_wheel_radii - 1.0).abs() < 1e-5, "{length}");
                let crank_radius = libm::sin(wheel.half_pitch_angle());
                assert!(agrees(by_formula.in_crank_radii * crank_radius, by_formula.in_wheel_radii));
            }
        }
    }
}
