//! A wheel that fits its driver, twice: by the formula crate and by coordinates; and formulas evaluated on it.

use super::*;
use geneva_evidence::agreement::joined;
use geneva_evidence::tex::{Moment, holds};
use geneva_kinematics::indexing::Indexing;
use geneva_kinematics::wheel::Wheel;
use nalgebra::Vector2;
use std::ops::RangeInclusive;

/// The numbers of slots for which a statement about any number is tried.
pub(super) const ANY: RangeInclusive<u32> = 3..=60;

/// Sizes and angles of a wheel whose pin enters and leaves along the slot. Lengths in one unit, angles in radians.
#[derive(Clone, Copy, Debug)]
pub(super) struct Fit {
    /// Number of slots.
    pub slots: f64,
    /// Distance of the pin's centre from the driver's axis.
    pub crank: f64,
    /// Distance of the axes.
    pub centres: f64,
    /// Distance of the pin's centre from the wheel's axis as it enters.
    pub rim: f64,
    /// Distance of the pin's centre from the wheel's axis where it is deepest in the slot.
    pub deepest: f64,
    /// What the driver turns while the wheel turns.
    pub moving: f64,
    /// What the driver turns while the wheel rests.
    pub resting: f64,
    /// What the wheel turns each time.
    pub step: f64,
}

/// A crank radius for each number of slots, so that a formula which adds a length to a number is noticed.
fn unit(slots: u32) -> f64 {
    1.0 + f64::from(slots) / 7.0
}

impl Fit {
    /// By the formula crate.
    pub(super) fn by_wheel(slots: u32) -> Self {
        let wheel = Wheel::new(slots);
        let of = |quantity: fn(&Wheel) -> f64| wheel.as_ref().map_or(f64::NAN, quantity);
        Self {
            slots: of(|wheel| f64::from(wheel.stations())),
            crank: unit(slots),
            centres: unit(slots) * of(Wheel::centre_distance_ratio),
            rim: unit(slots) * of(Wheel::wheel_radius_ratio),
            deepest: unit(slots) * of(|wheel| wheel.wheel_radius_ratio() - wheel.slot_length_ratio()),
            moving: 2.0 * PI * of(Wheel::motion_fraction),
            resting: 2.0 * PI * of(Wheel::dwell_fraction),
            step: 2.0 * of(Wheel::half_pitch_angle),
        }
    }

    /// By coordinates: the wheel's axis at the origin, a slot half a pitch from the line of centres, and the pin where
    /// the slot's line is nearest to the driver's axis. There the pin's circle touches it.
    pub(super) fn by_vectors(slots: u32) -> Self {
        let direction = |pitches: f64| {
            let angle = pitches * 2.0 * PI / f64::from(slots);
            Vector2::new(libm::cos(angle), libm::sin(angle))
        };
        let (slot, before) = (direction(0.5), direction(-0.5));
        let driver = Vector2::new(1.0, 0.0);
        let pin = slot * slot.dot(&driver);
        let (arm, line) = (pin - driver, -driver);
        let half = libm::atan2(line.perp(&arm).abs(), line.dot(&arm));
        let scale = unit(slots) / arm.norm();
        Self {
            slots: f64::from(slots),
            crank: scale * arm.norm(),
            centres: scale * driver.norm(),
            rim: scale * pin.norm(),
            deepest: scale * (driver + line.normalize() * arm.norm()).norm(),
            moving: 2.0 * half,
            resting: 2.0 * PI - 2.0 * half,
            step: libm::atan2(before.perp(&slot), before.dot(&slot)),
        }
    }
}

/// What the letters of a page stand for.
pub(super) type Letters = fn(&Fit) -> Vec<(&'static str, f64)>;

/// A formula for the sizes or angles of wheels of these numbers of slots.
pub(super) fn formula(
    place: Locator,
    id: &'static str,
    printed: &'static str,
    meaning: &'static str,
    slots: RangeInclusive<u32>,
    letters: Letters,
) -> Claim {
    let by = |wheel: fn(u32) -> Fit| move |slots: u32| vec![Moment::default().with(letters(&wheel(slots)))];
    tried(
        place,
        id,
        printed,
        meaning,
        slots,
        (Evidence::CLOSED_FORM, by(Fit::by_wheel)),
        (Evidence::VECTORS, by(Fit::by_vectors)),
    )
}

/// A formula that is tried at some moments of wheels of these numbers of slots, which two routes give.
pub(super) fn tried(
    place: Locator,
    id: &'static str,
    printed: &'static str,
    meaning: &'static str,
    slots: RangeInclusive<u32>,
    (first, moments): (&'static Evidence, impl Fn(u32) -> Vec<Moment> + Send + Sync + 'static),
    (second, again): (&'static Evidence, impl Fn(u32) -> Vec<Moment> + Send + Sync + 'static),
) -> Claim {
    let same = slots.clone();
    place
        .equation(id, printed, meaning)
        .evaluated(first, move |tex| counted(slots.clone(), |slots| holds(tex, &moments(slots))))
        .read(second, move |tex| {
            let found: Option<Vec<bool>> = same.clone().map(|slots| holds(tex, &again(slots))).collect();
            Some(found?.into_iter().all(|holds| holds))
        })
}

/// For which numbers of slots something holds; it must for all. What cannot be read for one of them is not evaluated.
pub(super) fn counted(slots: RangeInclusive<u32>, holds: impl Fn(u32) -> Option<bool>) -> Finding {
    let all = slots.clone().count();
    let mut holding = Vec::new();
    for number in slots.clone() {
        match holds(number) {
            Some(true) => holding.push(number),
            Some(false) => {}
            None => return Finding::not_evaluated("the characters cannot be read"),
        }
    }
    let range = if all == 1 {
        format!("{} slots", slots.start())
    } else {
        format!("every number of slots from {} to {}", slots.start(), slots.end())
    };
    let how = match &holding[..] {
        _ if holding.len() == all => format!("it is right for {range}"),
        [] => format!("we tried it for {range}, and it is right for none"),
        [only] => format!("we tried it for {range}, and it is right only for {only}"),
        some => {
            format!("we tried it for {range}, and it is right only for {}", joined(some))
        }
    };
    Finding::new(holding.len() == all, how)
}

/// A number about a wheel of so many slots.
pub(super) fn number(
    place: Locator,
    id: &'static str,
    printed: &'static str,
    unit: &'static str,
    meaning: &'static str,
    slots: u32,
    quantity: fn(&Fit) -> f64,
) -> Claim {
    place
        .value(id, printed, unit, meaning)
        .first_route(Evidence::CLOSED_FORM, move || quantity(&Fit::by_wheel(slots)))
        .second_route(Evidence::VECTORS, move || quantity(&Fit::by_vectors(slots)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn both_routes_give_the_same_wheel() {
        for slots in ANY {
            let [one, other] = [Fit::by_wheel(slots), Fit::by_vectors(slots)];
            let all = |fit: Fit| {
                let Fit { slots, crank, centres, rim, deepest, moving, resting, step } = fit;
                [slots, crank, centres, rim, deepest, moving, resting, step]
            };
            for (one, other) in all(one).into_iter().zip(all(other)) {
                assert!(geneva_evidence::agreement::agrees(one, other), "{slots} slots: {one} and {other}");
            }
        }
    }

    #[test]
    fn what_holds_for_some_is_counted() {
        let how = |holds: fn(u32) -> bool| counted(3..=6, |slots| Some(holds(slots))).how;
        assert_eq!(how(|_| true), "it is right for every number of slots from 3 to 6");
        assert_eq!(
            how(|slots| slots == 4),
            "we tried it for every number of slots from 3 to 6, and it is right only for 4"
        );
        assert_eq!(
            how(|slots| slots < 5),
            "we tried it for every number of slots from 3 to 6, and it is right only for 3 and 4"
        );
        assert_eq!(how(|_| false), "we tried it for every number of slots from 3 to 6, and it is right for none");
        assert!(!counted(3..=6, |slots| (slots == 4).then_some(true)).evaluated);
    }
}
