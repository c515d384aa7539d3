//! The letters of the triangle of the two axes and the pin: one notation for chapters, drawings and tables.
//!
//! A drawing marks the part that a letter stands for by `data-letter`, with the letter as [`Letter::part`] has it.

/// A letter of the book.
#[derive(Clone, Copy, Debug)]
pub struct Letter {
    /// The letter in TeX.
    pub tex: &'static str,
    /// The letter by which a drawing marks its part; empty if it stands for no part of a drawing.
    pub part: &'static str,
    /// What it stands for.
    pub meaning: &'static str,
    /// From where and in which sense it counts, or what it is equal to; empty if there is nothing to say.
    pub counted: &'static str,
}

const fn letter(tex: &'static str, part: &'static str, meaning: &'static str, counted: &'static str) -> Letter {
    Letter { tex, part, meaning, counted }
}

/// All letters of the triangle, of its motion and of the force in the slot.
pub const NOTATION: &[Letter] = &[
    letter("R", "R", "crank radius", "from the driver's axis to the pin's centre"),
    letter("r", "r", "distance of the pin", "from the axis of the wheel or lever to the pin's centre"),
    letter("l", "l", "centre distance", "between the two axes"),
    letter("k", "", "ratio of the lengths", "centre distance over crank radius"),
    letter("N", "", "number of slots", "of a wheel that stops: its stations"),
    letter("m", "", "number of pins", ""),
    letter(
        r"\alpha",
        "α",
        "half pitch angle",
        "half the angle between neighbouring slots, a half turn over their number",
    ),
    letter(
        r"\theta",
        "θ",
        "crank angle",
        "from the line of centres, in the sense in which the driver turns: negative before the line, positive past it",
    ),
    letter(
        r"\varphi",
        "φ",
        "angle of the wheel or lever",
        "from the line of centres to the slot: for a wheel, opposite to the driver's sense, so that it has the sign of \
         the crank angle; for a lever, in the crank's sense",
    ),
    letter(r"\dot\theta", "θ'", "angular velocity of the driver", "two dots: its angular acceleration"),
    letter(r"\dot\varphi", "φ'", "angular velocity of the wheel or lever", "two dots: its angular acceleration"),
    letter("F", "F", "force of the pin across the slot", "positive where the pin drives the wheel"),
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_letter_stands_for_one_thing() {
        for letter in NOTATION {
            assert_eq!(NOTATION.iter().filter(|other| other.tex == letter.tex).count(), 1, "{}", letter.tex);
            let alike = NOTATION.iter().filter(|other| !other.part.is_empty() && other.part == letter.part).count();
            assert_eq!(alike, usize::from(!letter.part.is_empty()), "{}", letter.tex);
        }
    }
}
