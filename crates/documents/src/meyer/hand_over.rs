//! Which numbers of pins and slots have one pin take over from the next without a blow: the condition before Fig. 4 and
//! the third conclusion.

use super::newton::Newton;
use super::runs::table::rows;
use super::slips::ENTRY_ALONG_THE_SLOT;
use super::*;
use crate::evidence::RUNGE_KUTTA;
use geneva_case1973::Column;
use geneva_evidence::agreement::joined;
use geneva_kinematics::escapement::{ContinuityStep, ContinuousEscapement};
use geneva_kinematics::pin_slot::{pin_from_pivot, velocity_ratio};
use geneva_kinematics::{Jet, angular_velocity};
use std::sync::OnceLock;

/// The claim on how a pin must enter.
pub(super) fn along_the_slot() -> Claim {
    geometry::INSTANT
        .statement(
            "meyer.along-the-slot",
            "along the centerline",
            "for the motion to be continuous, the pin's velocity must be along the slot's centre line as the pin \
             enters and leaves",
        )
        .first_route(Evidence::JET, entry_by_series)
        .second_route(Evidence::VECTORS, entry_by_places)
        .corrected("along the centerline, as seen from the follower,", ENTRY_ALONG_THE_SLOT)
        .interpreted_as(
            "We take the velocity seen from the frame, because from it the text concludes that crank and slot are at \
             right angles and that the follower is at rest as a pin enters.",
        )
}

/// The claims of the third conclusion.
pub(super) fn conclusion() -> Vec<Claim> {
    let locator = "Conclusion 3";
    let reading = "“To work” means to reach a terminal velocity, as in the first conclusion. By a configuration we \
                   mean numbers of pins and slots for which each pin takes over from the previous one without a gap. \
                   (Chapter I demands this, and it is open whether as a need or as a choice. Configurations with gaps \
                   could only add to those that work.) Up to sixty pins and sixty slots, we tested whether the \
                   hand-over is without a gap and without a jump. Up to eight pins and eight slots, we also tested \
                   whether the motion reaches a terminal velocity. In these tests we used the friction values \
                   of the runs and the inertias of the six-pin runs. (With other inertias and more friction, a \
                   configuration may have no terminal velocity. This can happen to the thesis's three configurations, \
                   too.)";
    vec![
        at(locator)
            .statement(
                "meyer.conclusion.three",
                "Only three geometrical configurations",
                "three combinations of pins and slots work, and no more",
            )
            .first_route(Evidence::CLOSED_FORM, |stated| said_of_pairs(stated, &HANDS_OVER))
            .second_route(RUNGE_KUTTA, |stated| said_of_pairs(stated, &WORKS))
            .interpreted_as(reading)
            .corrected(
                "All geometrical configurations of m pins and n slots with 1/m + 2/n < 1 and inertias that suit the \
                 friction, although only in three of them is the follower at rest at each hand-over",
                ENTRY_ALONG_THE_SLOT,
            ),
        at(locator)
            .statement(
                "meyer.conclusion.the-three",
                "three pin / six slot mechanism; the four pin / four slot mechanism; and the six pin / three slot",
                "the three mechanisms that the conclusion names do work",
            )
            .first_route(Evidence::CLOSED_FORM, |stated| named_work(stated, &HANDS_OVER))
            .second_route(RUNGE_KUTTA, |stated| named_work(stated, &WORKS))
            .but_not("each of the three works with two slots")
            .interpreted_as(reading),
    ]
}

/// Driver and follower by coordinates, for any numbers; lengths in radii of the pins' circle.
#[derive(Clone, Copy)]
pub(super) struct Drawn {
    pub pins: u32,
    pub slots: u32,
    /// Distance of the follower's axis from the driver's.
    pub axis: f64,
}

impl Drawn {
    /// Driver and follower for these numbers of pins and slots.
    ///
    /// The slot of the pin at π/m leaves the follower's axis at the angle π/n, so the axis is where that line meets the
    /// line of centres.
    pub(super) fn new(pins: u32, slots: u32) -> Self {
        let [crank, slot] = [pins, slots].map(|count| Turn::from_radians(PI / f64::from(count)));
        Self { pins, slots, axis: crank.cos + crank.sin * slot.cos / slot.sin }
    }

    /// π/m.
    pub(super) fn half(&self) -> f64 {
        PI / f64::from(self.pins)
    }

    /// A pin at this angle from the follower's axis, first coordinate towards the driver.
    pub(super) fn place(&self, angle: f64) -> Vector2<f64> {
        Vector2::new(self.axis - libm::cos(angle), libm::sin(angle))
    }

    /// Velocity of the pin for a driver of angular velocity one.
    pub(super) fn velocity(angle: f64) -> Vector2<f64> {
        Vector2::new(libm::sin(angle), libm::cos(angle))
    }

    /// Direction of the pin from the follower's axis.
    pub(super) fn direction(&self, angle: f64) -> f64 {
        let place = self.place(angle);
        libm::atan2(place.y, place.x)
    }

    /// Angular velocity of a follower that the pin carries.
    pub(super) fn turning(&self, angle: f64) -> f64 {
        let place = self.place(angle);
        place.perp(&Self::velocity(angle)) / place.norm_squared()
    }

    /// How many pins are no further from the follower's axis than this, with the first at an angle.
    pub(super) fn within(&self, rim: f64, angle: f64) -> usize {
        let inside = rim * (1.0 + geneva_evidence::CLOSURE.relative);
        let place = |k: u32| self.place(angle + 2.0 * self.half() * f64::from(k));
        (0..self.pins).filter(|k| place(*k).norm() <= inside).count()
    }

    /// Distance of the pin from the follower's axis where it moves along its slot: the length of the tangent.
    pub(super) fn tangent(&self) -> f64 {
        (self.axis * self.axis - 1.0).sqrt()
    }

    /// The fewest pins inside a rim over a turn of the driver, of so many instants.
    pub(super) fn fewest_within(&self, rim: f64) -> usize {
        const INSTANTS: u32 = 997;
        let counts = (0..INSTANTS).map(|k| self.within(rim, 2.0 * PI * f64::from(k) / f64::from(INSTANTS)));
        counts.min().unwrap_or(0)
    }
}

/// A pin that comes into a slot.
struct Coming {
    drawn: Drawn,
    /// Angle of the pin that leaves at that instant; none if the follower is at rest.
    leaving: Option<f64>,
    entering: f64,
}

/// Pairs with one pin always engaged; single pins that come to a follower at rest, at the distance of Eq. (1-2); and
/// the same with the axes a tenth nearer.
fn comings() -> impl Iterator<Item = Coming> {
    let pairs = (2..=12).flat_map(|pins| (3..=12).map(move |slots| Drawn::new(pins, slots)));
    let taking_over = pairs.filter(|drawn| drawn.axis > 1.0 + 1e-9).map(|drawn| {
        let half = drawn.half();
        Coming { drawn, leaving: Some(half), entering: -half }
    });
    let single = (3..=18_u32).flat_map(|slots| {
        let slot = PI / f64::from(slots);
        [1.0, 0.9].map(|part| Coming {
            drawn: Drawn { pins: 1, slots, axis: part / libm::sin(slot) },
            leaving: None,
            // The outer of the two places where the circle of the pin meets the slot's centre line.
            entering: -(PI - libm::asin(part) - slot),
        })
    });
    taking_over.chain(single)
}

/// Whether the follower's speed is without a jump exactly where the velocity of the pin is along the slot: that seen
/// from the follower, or that of the pin itself.
fn entry(stated: Stated, jump: fn(&Coming) -> f64, across: fn(&Coming, f64) -> f64) -> Finding {
    let (mut all, mut smooth, mut wrong) = (0, 0, Vec::new());
    for coming in comings() {
        let continuous = jump(&coming).abs() < SMALL;
        let along = across(&coming, stated.pick(1.0, 0.0)).abs() < SMALL;
        all += 1;
        smooth += usize::from(continuous);
        if continuous != along {
            wrong.push((coming.drawn.pins, coming.drawn.slots));
        }
    }
    let holds = wrong.is_empty() && smooth > 0 && smooth < all;
    let but = wrong.first().map_or(String::new(), |(pins, slots)| {
        format!("; the statement fails for {} of them, for example with {pins} pins and {slots} slots", wrong.len())
    });
    Finding::new(holds, format!("{smooth} of {all} entries have no jump in the follower's speed{but}"))
}

/// A jump that is none: of an angular velocity over the driver's, and of quotients of small differences.
const SMALL: f64 = 1e-6;

fn entry_by_series(stated: Stated) -> Finding {
    entry(
        stated,
        |coming| {
            let speed = |angle: f64| {
                let crank = Turn::from_radians(angle).moving::<2>(1.0);
                let place = pin_from_pivot(&Jet::constant(coming.drawn.axis), &crank);
                angular_velocity(&place).map_or(f64::NAN, |series| series.value())
            };
            speed(coming.entering) - coming.leaving.map_or(0.0, speed)
        },
        |coming, follower| {
            let ratio = |angle: f64| velocity_ratio(&coming.drawn.axis, &Turn::from_radians(angle));
            ratio(coming.entering) - follower * coming.leaving.map_or(0.0, ratio)
        },
    )
}

fn entry_by_places(stated: Stated) -> Finding {
    entry(
        stated,
        |coming| {
            // How far the follower turns in a short time before and after; twice, for the limit of shorter and shorter.
            let speed = |angle: f64, time: f64| {
                let over = |time: f64| (coming.drawn.direction(angle + time) - coming.drawn.direction(angle)) / time;
                2.0 * over(time / 2.0) - over(time)
            };
            speed(coming.entering, 1e-5) - coming.leaving.map_or(0.0, |leaving| speed(leaving, -1e-5))
        },
        |coming, follower| {
            let turning = follower * coming.leaving.map_or(0.0, |leaving| coming.drawn.turning(leaving));
            let place = coming.drawn.place(coming.entering);
            let relative = Drawn::velocity(coming.entering) - quarter_turn(&place) * turning;
            place.normalize().perp(&relative)
        },
    )
}

/// Up to how many pins and slots the formulas and the steps go.
const FORMULA_TO: u32 = 60;
const STEPS_TO: u32 = 8;

/// What a route asks of numbers of pins and slots.
struct Asked {
    /// The greatest number of either.
    most: u32,
    holds: fn(u32, u32) -> bool,
    /// What those do for which it holds, and what the others do.
    words: [&'static str; 2],
}

/// What is needed to work: a hand-over without a gap and without a jump, by formulas.
const HANDS_OVER: Asked = Asked {
    most: FORMULA_TO,
    holds: hands_over,
    words: ["hand over without a gap or a jump", "do not hand over without a gap or a jump"],
};

/// A terminal velocity, by steps.
const WORKS: Asked =
    Asked { most: STEPS_TO, holds: works_by_steps, words: ["reach a terminal velocity", "reach no terminal velocity"] };

/// Whether the pairs that do what is asked are those that are said to work.
fn said_of_pairs(stated: Stated, asked: &Asked) -> Finding {
    let Asked { most, holds: works, words: [do_it, fail] } = *asked;
    let said = |pins: u32, slots: u32| {
        // p/m + q/n < r, with the whole numbers of the correction.
        let [p, q, r] = stated.numbers().iter().take(3).map(|number| *number as u64).collect::<Vec<_>>()[..] else {
            return stated.pick(false, 2 * (pins + slots) == pins * slots);
        };
        let [pins, slots] = [pins, slots].map(u64::from);
        p.saturating_mul(slots).saturating_add(q.saturating_mul(pins)) < r.saturating_mul(pins * slots)
    };
    let pairs = || (2..=most).flat_map(|pins| (2..=most).map(move |slots| (pins, slots)));
    let working = pairs().filter(|&(pins, slots)| works(pins, slots)).count();
    let other = pairs().find(|&(pins, slots)| works(pins, slots) != said(pins, slots));
    let resting = pairs().filter(|(pins, slots)| 2 * (pins + slots) == pins * slots).count();
    let as_said = || "; this form includes exactly those".to_owned();
    let but = other.map_or_else(as_said, |(pins, slots)| {
        let [do_they, says] = if works(pins, slots) { [do_it, "excludes"] } else { [fail, "includes"] };
        format!("; but this form {says} {pins} pins with {slots} slots, for example, which {do_they}")
    });
    Finding::new(
        other.is_none(),
        format!(
            "of the configurations with up to {most} pins and {most} slots, {working} {do_it}, and in {resting} of \
             them the follower is at rest at the hand-over{but}"
        ),
    )
}

/// Whether the follower's angle and speed are without a jump at the hand-over, which is proven for any two angles, with
/// its axis outside the circle of the pins.
fn hands_over(pins: u32, slots: u32) -> bool {
    static PROVEN: OnceLock<bool> = OnceLock::new();
    let proven = *PROVEN.get_or_init(|| all_proven(&ContinuityStep::ALL).holds);
    proven && ContinuousEscapement::new(pins, slots).is_some()
}

/// Whether a pair works, by coordinates, and with a terminal velocity by steps.
///
/// It takes the printed frictions and the two inertias of the runs with six pins, with which the motion of all these
/// pairs is well defined.
fn works_by_steps(pins: u32, slots: u32) -> bool {
    static FOUND: OnceLock<Vec<(u32, u32)>> = OnceLock::new();
    let found = FOUND.get_or_init(|| {
        let pairs = (2..=STEPS_TO).flat_map(|pins| (2..=STEPS_TO).map(move |slots| (pins, slots)));
        pairs.filter(|&(pins, slots)| takes_over(&Drawn::new(pins, slots)) && settles(pins, slots)).collect()
    });
    found.contains(&(pins, slots))
}

/// Whether a pin is always within the rim and never two but at the hand-over, where both give the follower the same
/// angle and speed.
fn takes_over(drawn: &Drawn) -> bool {
    if drawn.axis <= 1.0 + 1e-9 {
        return false;
    }
    let half = drawn.half();
    let rim = drawn.place(half).norm();
    let one_slot = 2.0 * PI / f64::from(drawn.slots);
    let [leaving, entering] = [half, -half].map(|angle| (drawn.direction(angle), drawn.turning(angle)));
    let inside = |part: i32| drawn.within(rim, half * f64::from(part) / 20.0);
    (leaving.0 - entering.0 - one_slot).abs() < SMALL
        && (leaving.1 - entering.1).abs() < SMALL
        && (-19..=19).all(|part| inside(part) == 1)
        && inside(20) == 2
}

fn settles(pins: u32, slots: u32) -> bool {
    let drawn = Drawn::new(pins, slots);
    let [driver, follower] = ["meyer.fig-11.driver", "meyer.fig-11.follower"].map(|id| MEYER.printed_number(id));
    frictions().iter().all(|friction| {
        let pair = Newton { radius: 1.0, distance: drawn.axis, friction: *friction, driver, follower };
        has_terminal_speed(&pair, drawn.half(), 0.0)
    })
}

/// The frictions of the runs, each once.
fn frictions() -> Vec<f64> {
    let mut frictions: Vec<f64> = rows().iter().map(|row| row.number(Column::Friction)).collect();
    frictions.sort_by(f64::total_cmp);
    frictions.dedup();
    frictions
}

/// Whether there is an engagement that starts as the one before, and starts from near it and from rest come nearer to it.
/// Between two engagements the driver may turn by an angle without a pin in a slot: then the torque moves it alone.
fn has_terminal_speed(pair: &Newton, half: f64, gap: f64) -> bool {
    const STEPS: u32 = 60;
    // A torque of the follower's inertia: speeds are then of the size of one.
    let between = 2.0 * pair.follower * gap / pair.driver;
    let engagements = pair.engagements(half, STEPS);
    let end = |square: f64| engagements.passage(square, &|_| pair.follower).map_or(f64::NAN, |to| to.end);
    let next = |square: f64| end(square) + between;
    let mut fixed = next(0.0);
    for _ in 0..40 {
        let (once, twice) = (next(fixed), next(next(fixed)));
        let (angular_acceleration, next_acceleration) = (once - fixed, twice - once);
        if angular_acceleration.abs() <= 1e-10 * fixed {
            break;
        }
        fixed = once + next_acceleration / (1.0 - next_acceleration / angular_acceleration);
    }
    let nearer = |from: f64| (next(from) - fixed).abs() < 0.999 * (from - fixed).abs();
    fixed > 0.0 && (next(fixed) - fixed).abs() < 1e-6 * fixed && [0.0, 0.9 * fixed, 1.1 * fixed].into_iter().all(nearer)
}

/// Whether the three mechanisms that the conclusion names work, or these mechanisms with two slots.
fn named_work(stated: Stated, asked: &Asked) -> Finding {
    let named = front::pins_and_slots(stated.characters());
    let pairs: Vec<_> = named.iter().map(|(pins, slots)| (*pins, stated.pick(*slots, 2))).collect();
    let working = pairs.iter().filter(|(pins, slots)| (asked.holds)(*pins, *slots)).count();
    Finding::new(
        working == 3 && pairs.len() == 3,
        format!(
            "{working} of {} {}: {}",
            pairs.len(),
            asked.words[0],
            joined(pairs.iter().map(|(pins, slots)| format!("{pins} pins with {slots} slots")))
        ),
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::meyer::singularity::inertia_ratios;

    #[test]
    fn with_fewer_pins_and_a_follower_that_is_held_between_them_there_is_a_terminal_speed_too() {
        let mut tried = 0;
        for (mechanism, inertia) in inertia_ratios() {
            let half = mechanism.engagement_half_angle();
            for friction in frictions() {
                let pair = Newton {
                    radius: 1.0,
                    distance: mechanism.centre_distance_ratio(),
                    friction,
                    driver: inertia,
                    follower: 1.0,
                };
                for pins in 1..=mechanism.pins() {
                    let gap = 2.0 * PI / f64::from(pins) - 2.0 * half;
                    assert!(has_terminal_speed(&pair, half, gap), "{mechanism:?} {friction} {pins}");
                    tried += 1;
                }
            }
        }
        assert_eq!(tried, 13 * frictions().len());
    }

    #[test]
    fn configurations_beyond_those_of_the_check_reach_a_terminal_velocity_too() {
        let numbers = [2, 3, 4, 6, 9, 12];
        let pairs = numbers.iter().flat_map(|pins| numbers.iter().map(move |slots| (*pins, *slots)));
        let beyond = pairs.filter(|(pins, slots)| *pins.max(slots) > STEPS_TO && hands_over(*pins, *slots));
        let beyond: Vec<_> = beyond.collect();
        assert!(beyond.len() > 15, "{}", beyond.len());
        for (pins, slots) in beyond {
            assert!(settles(pins, slots), "{pins} pins, {slots} slots");
        }
    }

    #[test]
    fn mechanisms_that_turn_back_at_the_hand_over_have_a_terminal_speed_too() {
        let back = |pins: &u32, slots: &u32| 2 * (pins + slots) > pins * slots;
        let pairs = (2..=STEPS_TO).flat_map(|pins| (2..=STEPS_TO).map(move |slots| (pins, slots)));
        let found: Vec<_> = pairs.filter(|(pins, slots)| back(pins, slots) && works_by_steps(*pins, *slots)).collect();
        assert_eq!(found, [(2, 5), (2, 6), (2, 7), (2, 8), (3, 4), (3, 5), (4, 3), (5, 3)]);
    }
}
