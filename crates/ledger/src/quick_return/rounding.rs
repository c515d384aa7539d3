//! The solution goes on with rounded numbers, and this spoils some of its results.

use super::*;

/// Every step rounded, and the next one computed from it.
pub const STEPS: Slip = Slip {
    id: "quick-return.pin-speed",
    reason: "The solution rounds each step to the digits that it prints and goes on with the rounded number. The \
             angular velocity of the crank is printed with three digits, the pin's distance from the lever's pivot \
             with two and the speeds along and across the lever with three, but the results that are computed from \
             these numbers are printed with three or four. No single rounding reproduces all of these results. But \
             rounding the crank's angular velocity alone is enough for the printed speed of the pin, and rounding \
             only the pin's distance from the pivot is enough for the printed angular velocity of the lever.",
    witness: "Differentiating the loop closure with power series gives the corrected digits, too.",
    origin: Origin::Arithmetic,
    consequence: Consequence::Number,
    changes: "Eight results are wrong in their last digits, among them the lever's angular velocity and acceleration.",
};

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{claims, verdict};

    /// Results of the solution's steps, unrounded, from a rate of the crank and a length of the lever.
    fn steps(rate: f64, length: f64) -> [(&'static str, f64); 8] {
        let (radius, beta) = (printed("quick-return.crank"), position_of(Position::angle_at_pin));
        let (pin_speed, pin_normal) = (rate * radius, rate * rate * radius);
        let lever_speed = pin_speed * beta.cos() / length;
        let (lever_normal, coriolis) = (lever_speed * lever_speed * length, 2.0 * lever_speed * pin_speed * beta.sin());
        let [sliding, tangential] = [pin_normal * beta.cos() - lever_normal, pin_normal * beta.sin() - coriolis];
        [
            ("quick-return.pin-speed", pin_speed),
            ("quick-return.lever-speed", lever_speed),
            ("quick-return.pin-normal", pin_normal),
            ("quick-return.lever-normal", lever_normal),
            ("quick-return.coriolis", coriolis),
            ("quick-return.sliding-acceleration", sliding),
            ("quick-return.lever-tangential", tangential),
            ("quick-return.lever-acceleration", tangential / length),
        ]
    }

    /// Which of the printed results come from a rate and a length.
    fn come_from(rate: f64, length: f64) -> Vec<&'static str> {
        steps(rate, length).into_iter().filter(|(id, value)| rounds(id, *value)).map(|(id, _)| id).collect()
    }

    fn rate() -> f64 {
        Instant::printed().expect("a mechanism").drive.speed
    }

    fn length() -> f64 {
        position_of(|position| position.pin_distance)
    }

    #[test]
    fn the_slip_reaches_what_the_steps_compute() {
        let reached = claims().iter().filter(|claim| claim.erratum.is_some_and(|erratum| erratum.slip == STEPS));
        let mut reached: Vec<_> = reached.map(|claim| claim.id).collect();
        let mut computed: Vec<_> = steps(rate(), length()).into_iter().map(|(id, _)| id).collect();
        reached.sort_unstable();
        computed.sort_unstable();
        assert_eq!(reached, computed);
        // And without a rounding none of these is right as printed.
        assert!(come_from(rate(), length()).is_empty());
    }

    #[test]
    fn no_rounding_alone_gives_all_and_two_of_them_do_not_either() {
        let [rounded_rate, rounded_length] = ["quick-return.driver-rate", "quick-return.lever-length"].map(printed);
        let by_rate = come_from(rounded_rate, length());
        assert!(["quick-return.pin-speed", "quick-return.pin-normal"].iter().all(|id| by_rate.contains(id)));
        let by_length = come_from(rate(), rounded_length);
        assert!(by_length.contains(&"quick-return.lever-speed"));
        for found in [by_rate, by_length, come_from(rounded_rate, rounded_length)] {
            assert!(found.len() < 8, "{found:?}");
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
            let judged = verdict(&format!("quick-return.{name}")).expect("a claim");
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
