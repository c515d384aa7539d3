//! What the project counts in words: turns, frictional torques, statements and conclusions, and a watch's beats.

use super::*;
use geneva_evidence::numbers_in;
use geneva_kinematics::indexing::Indexing;
use geneva_kinematics::pin_slot::pin_from_pivot;
use std::collections::BTreeSet;

/// The claims of chapter I.
pub(super) fn of_the_derivation() -> Vec<Claim> {
    vec![
        at("Chapter I, 1st paragraph")
            .statement(
                "meyer.indexing-revolution",
                "one revolution",
                "one turn of the driver moves the follower on once; how far is a claim of its own",
            )
            .first_route(Evidence::LIMIT_CASE, |stated| {
                let turns = i64::from(stated.pick(stated.count(), 2));
                let moved = |slots| Wheel::new(slots).ok()?.motion(turns, 0.0).ok().map(|motion| motion.stations);
                let once = (3..=18).filter(|slots| moved(*slots) == Some(1)).count();
                Finding::new(once == 16, format!("the follower is one slot on with {once} of 16 numbers of slots"))
            })
            .second_route(Evidence::VECTORS, |stated| {
                // From entry to exit the pin's direction from the follower's axis turns by an angle, once in each turn.
                let advance = |slots: u32| {
                    let wheel = Wheel::new(slots).ok()?;
                    let pin = pin_from_pivot(
                        &wheel.centre_distance_ratio(),
                        &Turn::from_radians(wheel.engagement_half_angle()),
                    );
                    Some(2.0 * libm::atan2(pin.y, pin.x) * f64::from(slots) / (2.0 * PI))
                };
                let turns = stated.pick(stated.number(), 2.0);
                Finding::for_all(
                    3..=18,
                    |slots| advance(slots).is_some_and(|slot| agrees(slot * turns, 1.0)),
                    |right, all| format!("the pin's advances make one slot with {right} of {all} numbers of slots"),
                )
            })
            .but_not("it takes two turns")
            .interpreted_as("The driver has a single pin, as the paragraph says before."),
        at("Chapter I, sentence on the frictional torques")
            .statement(
                "meyer.three-frictions",
                "three frictional torques",
                "there is friction in three places: in two bearings and between pin and slot",
            )
            .first_route(Evidence::LIMIT_CASE, |stated| {
                let parts = ["frame", "driver", "follower"];
                let pairs = parts.len() * (parts.len() - 1) / 2;
                Finding::new(
                    f64::from(stated.pick(stated.count(), 2)) == pairs as f64,
                    format!("frame, driver and follower touch in {pairs} pairs"),
                )
            })
            .second_route(Evidence::OTHER_PLACE_IN_SOURCE, |stated| {
                // All but the pin in its slot are bearings. Grübler's count must leave the freedom that the text gives.
                let places = f64::from(stated.pick(stated.count(), 2));
                let freedom = 6.0 - 2.0 * (places - 1.0) - 1.0;
                let said =
                    numbers_in(MEYER.printed_text("meyer.one-degree")).first().map_or(f64::NAN, |(_, number)| *number);
                same(freedom, said)
            })
            .but_not("there are two")
            .interpreted_as(
                "We count one place for each pair of parts that touch. At the hand-over a second pin touches.",
            ),
    ]
}

/// The claims of chapter II and of the conclusions.
pub(super) fn of_the_study() -> Vec<Claim> {
    vec![
        at("Chapter II, paragraph on the rise time")
            .statement(
                "meyer.watch-resolution",
                "one second, if the pallet oscillates once a second",
                "a watch whose pallet oscillates once a second resolves one second",
            )
            .first_route(Evidence::CLOSED_FORM, |stated| match stated.numbers()[..] {
                // The word for the unit is the same as for a number, so it is kept as a letter would be.
                [resolution, unit, beats, time] => same(stated.pick(resolution, 2.0) * unit / time, 1.0 / beats),
                _ => Finding::new(false, "a resolution and a rate, each with its unit, are expected"),
            })
            .second_route(Evidence::LIMIT_CASE, |stated| match stated.numbers()[..] {
                [resolution, unit, beats, time] => {
                    // Beats of a minute, one after the other, each as long as the resolution.
                    let minute = 60.0 * time;
                    let ends = std::iter::successors(Some(0.0), |end| Some(end + stated.pick(resolution, 2.0) * unit));
                    let counted = ends.skip(1).take(1000).take_while(|end| *end <= minute * (1.0 + 1e-9)).count();
                    same(counted as f64, 60.0 * beats)
                }
                _ => Finding::new(false, "a resolution and a rate, each with its unit, are expected"),
            })
            .but_not("it resolves two seconds")
            .interpreted_as(
                "The resolution is the period, as the sentence has it, and one oscillation takes one period.",
            ),
        listed_below(
            "meyer.three-statements",
            "Chapter II, sentence before the general statements",
            "Three general statements",
            "general statement",
        ),
        listed_below(
            "meyer.three-conclusions",
            "Conclusions, sentence before the list",
            "Three important conclusions",
            "Conclusion",
        ),
    ]
}

/// The claim that so many items with numbers follow a sentence. The places of the claims on the items have the word `item`.
fn listed_below(id: &'static str, locator: &'static str, printed: &'static str, item: &'static str) -> Claim {
    at(locator)
        .statement(id, printed, "three of them follow, each with its number")
        .first_route(Evidence::LIMIT_CASE, move |stated| {
            let found = numbered_after(id);
            let how = format!("the items below the sentence are numbered from 1 to {found}");
            Finding::new(found == stated.pick(stated.count(), 4), how)
        })
        .second_route(Evidence::OTHER_PLACE_IN_SOURCE, move |stated| {
            let ordinal =
                |locator: &str| locator.split(|c: char| !c.is_ascii_digit()).find_map(|n| n.parse::<u32>().ok());
            let of_items = MEYER.claims().iter();
            let ordinals: BTreeSet<u32> = of_items
                .filter(|claim| claim.locator.contains(item))
                .filter_map(|claim| ordinal(claim.locator))
                .collect();
            let found: Vec<u32> = ordinals.into_iter().collect();
            let said: Vec<u32> = (1..=stated.pick(stated.count(), 4)).collect();
            Finding::new(found == said, format!("the ledger has claims on {} numbered items", found.len()))
        })
        .but_not("four follow")
}

/// How many lines after a claim's are the next item of a list: they begin with its number, and the numbers begin with 1.
fn numbered_after(id: &str) -> u32 {
    let lines = MEYER.lines().unwrap_or_default();
    let after = lines.iter().skip_while(|line| line.entries.iter().all(|entry| entry.claimed() != Some(id))).skip(1);
    let mut items = 0;
    for line in after {
        let begins = match line.entries.first() {
            Some(geneva_evidence::Entry::Exception { numbers, .. }) if numbers.len() == 1 => numbers[0].parse().ok(),
            _ => None,
        };
        match begins {
            Some(number) if number == items + 1 => items = number,
            // The next list.
            Some(1) => break,
            _ => {}
        }
    }
    items
}
