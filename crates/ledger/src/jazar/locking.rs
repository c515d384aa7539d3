//! The arcs and the journal that lock the wheel between two advances.

use super::text::{SIMPLE, VARIETIES};
use super::*;
use nalgebra::Vector2;

pub(super) fn journal_bearing() -> Claim {
    VARIETIES
        .statement(
            "jazar.journal-bearing",
            "journal bearing",
            "while it holds, the wheel's arc and the driver's journal are a bearing: they have the same centre",
        )
        .by(ClosedForm, |stated| {
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
        .by(Vectors, |stated| {
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
            "a journal in an arc of the wheel locks it, whichever way it is pushed",
        )
        .by(ClosedForm, |stated| {
            for_all_stations(
                |wheel| locks(wheel, between_rim_and_pin(wheel, 0.5), stated.pick(&[1.0, -1.0], &[1.0])),
                "turned a little either way, an end of the arc would be inside the journal",
            )
        })
        .by(Vectors, |stated| {
            for_all_stations(
                |wheel| holds(wheel, between_rim_and_pin(wheel, 0.5), stated.pick(&[1.0, -1.0], &[1.0])),
                "turning either way, an end of the arc would approach the driver's axis",
            )
        })
        .but_not("half of the arc, on one side of the line of centres, locks it as well")
}

pub(super) fn journal_radius() -> Claim {
    SIMPLE
        .statement("jazar.journal-radius", "flexible", "the radius of the journal can be chosen")
        .by(ClosedForm, |stated| {
            for_all_stations(
                |wheel| radii(wheel, stated).all(|journal| locks(wheel, journal, &[1.0, -1.0])),
                "turned a little either way, an end of the arc would be inside the journal",
            )
        })
        .by(Vectors, |stated| {
            for_all_stations(
                |wheel| radii(wheel, stated).all(|journal| holds(wheel, journal, &[1.0, -1.0])),
                "turning either way, an end of the arc would approach the driver's axis",
            )
        })
        .but_not("a journal that does not reach the wheel's rim locks it as well")
        .read_as("Any journal that reaches the wheel's rim and leaves room for the pin's path locks the wheel.")
}

pub(super) fn cutout_centres() -> Claim {
    SIMPLE
        .equation(
            "jazar.cutout-centres",
            r"\sqrt{2}r",
            "radius of the circle of the locking arcs' centres, four stations",
        )
        .by(ClosedForm, || {
            // Of the wheel as it is made.
            same(of(4, Wheel::locking_centres_ratio), 2f64.sqrt())
        })
        .by(Vectors, || {
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
        .by(ClosedForm, |stated| {
            // Half the arc as seen from its centre: cos ψ = sin α (1 + ρ²) / (2 ρ), with the journal's radius ρ.
            get_short(stated, |wheel, journal| {
                let sine = libm::sin(wheel.half_pitch_angle());
                2.0 * journal * libm::acos(sine * (1.0 + journal * journal) / (2.0 * journal))
            })
        })
        .by(Vectors, |stated| get_short(stated, |wheel, journal| 2.0 * journal * end_of_the_arc(wheel, journal)))
        .but_not("they do on a driver of one size, whose wheel is larger with more stations")
        .read_as(
            "For a wheel of one size, and a journal of six to nine tenths of the crank radius: from four stations on \
             each station more makes the arc shorter, and with a thousand it is less than a hundredth of the wheel's \
             radius. How short is too short the text does not say.",
        )
}

/// Whether an arc's length over the wheel's radius, or over the crank radius, falls with each station more to less than a
/// hundredth. Lengths are given in crank radii.
fn get_short(stated: Stated, arc: impl Fn(&Wheel, f64) -> f64) -> Finding {
    let wheels = &wheels()[1..];
    let length = |wheel: &Wheel, journal: f64| arc(wheel, journal) / stated.pick(wheel.wheel_radius_ratio(), 1.0);
    let at_last = |journal: f64| wheels.last().map_or(f64::NAN, |wheel| length(wheel, journal));
    let falls = |journal: f64| wheels.windows(2).all(|pair| length(&pair[0], journal) > length(&pair[1], journal));
    let journals = [0.6, 0.7, 0.8, 0.9];
    let most = greatest(journals.map(at_last).into_iter());
    Finding::new(
        journals.into_iter().all(falls) && most < 0.01,
        format!("four journals, from four stations on: at last {most:.4}"),
    )
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

/// The same with the driver's axis so far from the wheel's.
fn on_a_journal(axis: f64, journal: f64, angle: f64) -> Vector2<f64> {
    Vector2::new(axis, 0.0) - Turn::from_radians(angle).direction() * journal
}

/// The angle at the driver's axis from the line of centres to where the journal comes out of the wheel.
fn end_of_the_arc(wheel: &Wheel, journal: f64) -> f64 {
    let (axis, rim) = (wheel.centre_distance_ratio(), wheel.wheel_radius_ratio());
    halved(0.0, PI, |angle| on_a_journal(axis, journal, angle).norm() < rim).0
}
