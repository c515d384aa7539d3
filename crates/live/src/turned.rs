//! How the parts of a drawing stand when they turn: what a page moves without a new drawing.

use crate::json::{array, string};

/// Where wheel and driver stand at a crank angle, as they are drawn: play and errors may be drawn larger than they are.
#[derive(Clone, Debug, PartialEq)]
pub struct TurnedParts {
    /// Turn of the driver from where it is in the drawing, in degrees, clockwise.
    pub driver: f64,
    /// Turn of the wheel from where it is in the drawing, in degrees, counter-clockwise.
    pub wheel: f64,
    /// Centre distance of the drawing without errors, in millimetres: the scale of the lengths below.
    pub centre_distance: f64,
    /// How far the driver's axis is drawn out of its place, away from the wheel, in millimetres.
    pub apart: f64,
    /// How much larger than in the drawing the pins are drawn, dimensionless.
    pub pin_scale: f64,
    /// How far the pins are drawn out of their places, away from the driver's axis, in millimetres.
    pub pins_out: f64,
    /// How much larger than in the drawing the locking disc is drawn, dimensionless.
    pub disc_scale: f64,
    /// By how many degrees the drawn wheel turns when it goes through half of its free angles.
    pub half_free: f64,
    /// Where parts touch, in millimetres from the wheel's axis, along the line of centres and to the left of it.
    pub contacts: Vec<[f64; 2]>,
    /// What is to be seen, in words.
    pub words: String,
    /// Whether the parts leave the wheel no angle at all.
    pub jams: bool,
    /// Controls that move these parts alone, so that the drawing stays.
    pub moved_by: Vec<&'static str>,
}

impl TurnedParts {
    /// The places as a JSON object whose names are those of the fields.
    pub fn to_json(&self) -> String {
        let contacts = array(self.contacts.iter().map(|[x, y]| format!("[{x:?},{y:?}]")));
        let moved_by = array(self.moved_by.iter().map(|name| string(name)));
        let numbers = [
            ("driver", self.driver),
            ("wheel", self.wheel),
            ("centre_distance", self.centre_distance),
            ("apart", self.apart),
            ("pin_scale", self.pin_scale),
            ("pins_out", self.pins_out),
            ("disc_scale", self.disc_scale),
            ("half_free", self.half_free),
        ];
        // A zero has no sign.
        let numbers = numbers.map(|(name, number)| format!("\"{name}\":{:?},", number + 0.0)).concat();
        format!(
            "{{{numbers}\"contacts\":{contacts},\"words\":{},\"jams\":{},\"moved_by\":{moved_by}}}",
            string(&self.words),
            self.jams
        )
    }
}

/// A size that may be wrong, by how much it is, and by how much it may be.
#[derive(Clone, Debug, PartialEq)]
pub struct ToleranceRow {
    /// What may be wrong.
    pub name: &'static str,
    /// How wrong it is set.
    pub set: String,
    /// How wrong it may be if all else is right.
    pub alone: String,
    /// How wrong it may be if all sizes are wrong at once.
    pub together: String,
    /// Which limits are passed.
    pub state: ToleranceState,
}

/// How an error stands to its limits.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ToleranceState {
    /// Within both.
    Within,
    /// Beyond what all sizes may be wrong by at once.
    BeyondTogether,
    /// Beyond what it may be wrong by if all else is right.
    Beyond,
}

impl ToleranceState {
    /// Its name in the answer and on the page.
    pub fn name(self) -> &'static str {
        match self {
            Self::Within => "within",
            Self::BeyondTogether => "beyond-together",
            Self::Beyond => "beyond",
        }
    }

    /// What it means.
    pub fn words(self) -> &'static str {
        match self {
            Self::Within => "within its limits",
            Self::BeyondTogether => "too much if others are wrong too",
            Self::Beyond => "limit passed",
        }
    }
}

impl ToleranceRow {
    /// The row as a JSON object.
    pub fn to_json(&self) -> String {
        format!(
            "{{\"name\":{},\"set\":{},\"alone\":{},\"together\":{},\"state\":{},\"words\":{}}}",
            string(self.name),
            string(&self.set),
            string(&self.alone),
            string(&self.together),
            string(self.state.name()),
            string(self.state.words())
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_zero_has_no_sign_and_a_place_has_two_numbers() {
        let parts = TurnedParts {
            driver: -0.0,
            wheel: 1.5,
            centre_distance: 50.0,
            apart: 0.0,
            pin_scale: 1.0,
            pins_out: 0.0,
            disc_scale: 1.0,
            half_free: 0.25,
            contacts: vec![[1.0, -2.0]],
            words: "It \"jams\".".to_owned(),
            jams: true,
            moved_by: vec!["crank"],
        };
        let json = parts.to_json();
        assert!(json.starts_with("{\"driver\":0.0,\"wheel\":1.5,"), "{json}");
        assert!(json.ends_with(
            "\"contacts\":[[1.0,-2.0]],\"words\":\"It \\\"jams\\\".\",\"jams\":true,\"moved_by\":[\"crank\"]}"
        ));
    }
}
