//! Two rounded numbers that the solution goes on with, and which of its results each of them spoils.

use super::*;

/// The rate of the crank with the three digits that it is printed with.
pub const RATE: Slip = Slip {
    id: "quick-return.pin-speed",
    reason: "The rate of the crank is used with the three digits it was printed with, and three or four digits are \
             printed of what follows. The centripetal acceleration of the pin takes its square, and the last three \
             results are found from that; for these the rounded length of the lever counts as well.",
    witness: "The loop closure differentiated by power series gives the corrected digits too.",
    origin: Origin::Arithmetic,
    consequence: Consequence::Number,
    changes: "Five results change in the third or fourth digit, the lever's angular acceleration among them.",
};

/// The length of the lever with the two digits that it is printed with.
pub const LENGTH: Slip = Slip {
    id: "quick-return.lever-speed",
    reason: "The length of the lever is used with the two digits it was printed with, and three or four digits are \
             printed of the lever's angular velocity and of what follows from that.",
    witness: "The loop closure differentiated by power series gives the corrected digits too.",
    origin: Origin::Arithmetic,
    consequence: Consequence::Number,
    changes: "Three results change by one or two units of their last digit, the lever's angular velocity among them.",
};

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Decimal, claims};

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

    fn slip_of(id: &str) -> Slip {
        let claim = claims().iter().find(|claim| claim.id == id).expect("a claim");
        claim.erratum.expect("an erratum").slip
    }

    fn rate() -> f64 {
        Instant::printed().expect("a mechanism").drive.speed
    }

    #[test]
    fn what_the_slip_of_the_length_reaches_comes_from_the_rounded_length_alone() {
        let alone = steps(rate(), printed("quick-return.lever-length"));
        let reached: Vec<_> = alone.into_iter().filter(|(id, _)| slip_of(id) == LENGTH).collect();
        assert_eq!(reached.len(), 3);
        for (id, value) in reached {
            assert!(rounds(id, value), "{id}: {value}");
        }
    }

    #[test]
    fn the_pins_own_results_come_from_the_rounded_rate_alone() {
        let alone = steps(printed("quick-return.driver-rate"), position_of(|position| position.pin_distance));
        for (id, value) in [alone[0], alone[2]] {
            assert!(slip_of(id) == RATE && rounds(id, value), "{id}: {value}");
        }
    }

    #[test]
    fn the_last_three_results_are_mended_by_the_rate_and_not_by_the_length() {
        // Of the printed numbers that each is computed from, those that one slip reached are put right.
        let right = steps(rate(), position_of(|position| position.pin_distance));
        let value =
            |id: &str| right.iter().find(|(name, _)| *name == id).map_or_else(|| printed(id), |(_, value)| *value);
        let last = |mended: Slip| {
            let taken = |id: &str| if slip_of(id) == mended { value(id) } else { printed(id) };
            let (length, beta) = (printed("quick-return.lever-length"), printed("quick-return.angle-at-pin"));
            let normal = taken("quick-return.pin-normal");
            let sliding = normal * cosine(beta) - taken("quick-return.lever-normal");
            let tangential = normal * sine(beta) - taken("quick-return.coriolis");
            let length = if mended == LENGTH { position_of(|position| position.pin_distance) } else { length };
            let ids = ["sliding-acceleration", "lever-tangential", "lever-acceleration"];
            ids.map(|id| format!("quick-return.{id}")).into_iter().zip([sliding, tangential, tangential / length])
        };
        for (id, found) in last(RATE) {
            assert_eq!(slip_of(&id), RATE);
            let (wrong, left) = (printed(&id) - value(&id), found - value(&id));
            assert!(left.abs() < wrong.abs(), "{id}: {found} for {}", value(&id));
        }
        for (id, found) in last(LENGTH) {
            let wrong = printed(&id) - value(&id);
            assert!(found - value(&id) > wrong, "{id}: {found} for {}", value(&id));
        }
        // Two of the three come out right to the last digit as soon as the rate is.
        let right_to_the_digit = |(id, found): &(String, f64)| {
            let digits: Decimal =
                claims().iter().find(|claim| claim.id == id).expect("a claim").printed.parse().expect("a number");
            let places = 10f64.powi(digits.places() as i32);
            (found * places).round() == (value(id) * places).round()
        };
        assert_eq!(last(RATE).filter(right_to_the_digit).count(), 2);
    }
}
