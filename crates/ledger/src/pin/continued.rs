//! A public page that continues the problem: it asks for the angular acceleration of the wheel, and prints again what it
//! needs of the first solution. It is another copy of the same text, so it says what some lost characters were.

/// The address of the page.
pub const ADDRESS: &str = "https://holooly.com/?p=937608";

/// The day on which a stored copy of it was read.
pub const READ: &str = "2026-11-23";

/// What the page prints again: our claim, and the characters there.
pub const AGAIN: &[(&str, &str)] = &[
    ("pin.driver-speed", "10"),
    ("pin.crank-angle", "150"),
    ("pin.radius", "37.1"),
    ("pin.angle-at-pivot", "42.4"),
    ("pin.sliding-speed", "477"),
    ("pin.sliding-velocity-direction", "42.4"),
    ("pin.follower-speed", "4.08"),
];

/// The arrow there before the angle of the sliding velocity, in words.
pub const SLIDING: &str = "down and to the left, with the angle from the horizontal";

/// The arrow there behind the angular velocity of the wheel, in words.
pub const SENSE: &str = "clockwise";

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_page_prints_the_same_numbers() {
        for (id, characters) in AGAIN {
            assert_eq!(crate::by_id::characters(id), *characters, "{id}");
        }
    }
}
