//! The solution goes on with rounded numbers, and this spoils some of its results.

use super::*;

/// Every step rounded, and the next one computed from it.
pub(super) const STEPS: Slip = Slip {
    id: "quick-return.pin-speed",
    reason: "The solution rounds each step to the digits that it prints and goes on with the rounded number. The \
             angular velocity of the crank and the speeds along and across the lever are printed with three digits, and \
             the pin's distance from the lever's pivot with two. But the results of these numbers are printed with three \
             or four. No single rounding reproduces all of these \
             results. Rounding the crank's angular velocity alone is enough for four of them: speed and acceleration of \
             the pin, and angular velocity and normal acceleration of the lever. Rounding only the pin's distance from \
             the pivot is enough for these two numbers of the lever as well, and also for the Coriolis acceleration. So \
             each of these two roundings alone spoils the lever's angular velocity. For the last three results, we need at least \
             two roundings together.",
    witness: "Differentiating the loop closure with power series gives the corrected digits, too.",
    origin: Origin::Arithmetic,
    consequence: Consequence::Number,
    changes: "Eight results are wrong in their last digits, among them the lever's angular velocity and acceleration.",
};

#[cfg(test)]
mod tests {
    use super::*;
    use crate::LEDGER;

    /// The results that come out wrong.
    const SPOILED: [&str; 8] = [
        "pin-speed",
        "lever-speed",
        "pin-normal",
        "lever-normal",
        "coriolis",
        "sliding-acceleration",
        "lever-tangential",
        "lever-acceleration",
    ];

    /// What the solution computes, in its order.
    const ALL: [&str; 13] = [
        "driver-rate",
        "angle-at-pin",
        "lever-length",
        "pin-speed",
        "lever-point-speed",
        "sliding-speed",
        "lever-speed",
        "pin-normal",
        "lever-normal",
        "coriolis",
        "sliding-acceleration",
        "lever-tangential",
        "lever-acceleration",
    ];

    /// Where a result is in the order.
    fn place(name: &str) -> usize {
        ALL.iter().position(|other| *other == name).expect("a result")
    }

    fn id(name: &str) -> String {
        format!("quick-return.{name}")
    }

    /// What the solution computes if it rounds these results, each to its printed places.
    fn rounded(results: &[&str]) -> [f64; 13] {
        let keep = |name: &str, value: f64| match results.contains(&name) {
            true => QUICK_RETURN.printed_decimal(&id(name)).like(value).parse().expect("a number"),
            false => value,
        };
        let (crank, ground) =
            (QUICK_RETURN.printed_number("quick-return.crank"), QUICK_RETURN.printed_number("quick-return.ground"));
        let lever = QUICK_RETURN.printed_number("quick-return.lever-angle");
        let rate = keep("driver-rate", QUICK_RETURN.printed_number("quick-return.driver-speed") * PI / 30.0);
        let beta = keep("angle-at-pin", angle_at_pin(lever));
        let length = keep("lever-length", ground * cosine(lever) + crank * cosine(beta));
        let speed = keep("pin-speed", rate * crank);
        let point = keep("lever-point-speed", speed * cosine(beta));
        let sliding = keep("sliding-speed", speed * sine(beta));
        let turning = keep("lever-speed", point / length);
        let normal = keep("pin-normal", rate * rate * crank);
        let inwards = keep("lever-normal", turning * turning * length);
        let coriolis = keep("coriolis", 2.0 * turning * sliding);
        let along = keep("sliding-acceleration", normal * cosine(beta) - inwards);
        let across = keep("lever-tangential", normal * sine(beta) - coriolis);
        let last = keep("lever-acceleration", across / length);
        [rate, beta, length, speed, point, sliding, turning, normal, inwards, coriolis, along, across, last]
    }

    /// Whether these roundings are enough for the printed digits of a result.
    fn are_enough(roundings: &[&str], name: &str) -> bool {
        QUICK_RETURN.prints_rounding_of(&id(name), rounded(roundings)[place(name)])
    }

    #[test]
    fn the_slip_reaches_these_results_and_no_others() {
        let reached =
            QUICK_RETURN.claims().iter().filter(|claim| claim.erratum.is_some_and(|erratum| erratum.slip == STEPS));
        let mut reached: Vec<_> = reached.map(|claim| claim.id.to_owned()).collect();
        let mut spoiled = SPOILED.map(id);
        reached.sort_unstable();
        spoiled.sort_unstable();
        assert_eq!(reached, spoiled);
    }

    #[test]
    fn the_reason_says_which_roundings_are_enough() {
        // For each result, the roundings before it of which each alone is enough.
        let alone = SPOILED.map(|name| {
            let before = ALL[..place(name)].iter().copied();
            before.filter(|rounding| are_enough(&[rounding], name)).collect::<Vec<_>>()
        });
        let [rate, both] = [vec!["driver-rate"], vec!["driver-rate", "lever-length"]];
        let normal = vec!["driver-rate", "lever-length", "lever-point-speed", "lever-speed"];
        let coriolis = vec!["lever-length"];
        assert_eq!(alone, [rate.clone(), both, rate, normal, coriolis, vec![], vec![], vec![]]);
        for name in SPOILED {
            // None without a rounding, and each with all of them.
            assert!(!are_enough(&[], name) && are_enough(&ALL, name), "{name}");
        }
        // The last three need two, and some two are enough for each.
        for name in &SPOILED[5..] {
            let before = &ALL[..place(name)];
            let mut two = before.iter().flat_map(|one| before.iter().map(move |other| [*one, *other]));
            assert!(two.any(|two| are_enough(&two, name)), "{name}");
        }
    }

    #[test]
    fn six_accelerations_are_wrong_in_the_last_digit_and_three_in_the_last_two() {
        let names = [
            "pin-normal",
            "lever-normal",
            "coriolis",
            "sliding-acceleration",
            "lever-tangential",
            "lever-acceleration",
        ];
        let wrong = names.map(|name| {
            let judged = LEDGER.verdict(&format!("quick-return.{name}")).expect("a claim");
            let corrected = judged.corrected().expect("a correction");
            let [printed, right] =
                [judged.claim.printed, &corrected].map(|digits| digits.chars().rev().collect::<Vec<_>>());
            assert_eq!(printed[2..], right[2..], "{name}");
            [printed[0] != right[0], printed[1] != right[1]]
        });
        assert!(wrong.iter().all(|[last, _]| *last), "{wrong:?}");
        assert_eq!(wrong.iter().filter(|[_, before]| *before).count(), 3, "{wrong:?}");
    }
}
