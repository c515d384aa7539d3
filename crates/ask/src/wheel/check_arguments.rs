//! The measured sizes that can be asked about, as they are typed.

use crate::Error;
use crate::typed_number::{TypedNumber, advice, length};
use geneva_kinematics::wheel::as_built::{MeasuredError, MeasuredSize, MeasuredWheel};
use std::f64::consts::PI;

/// An argument of the question that is a measured size: its name, its unit, what it is, and by what a typed number is multiplied.
#[derive(Clone, Copy, Debug)]
pub struct CheckArgument {
    /// Its name as it is typed, without hyphens before it.
    pub name: &'static str,
    /// What its value is called, and its unit.
    pub value: &'static str,
    /// What it is.
    pub help: &'static str,
    /// Which size it is, of all slots or arcs; with a number, of one of them.
    size: fn(Option<usize>) -> MeasuredSize,
    scale: f64,
}

/// The arguments that are measured sizes. Each value may carry its uncertainty, `6.1+-0.05`; those of slots and arcs may be of single
/// ones, `1:6.1,2:6.0`.
pub const CHECK_ARGUMENTS: [CheckArgument; 17] = [
    argument("centre-distance", "MM", "Distance between the two axes", |_| MeasuredSize::CentreDistance, 1.0),
    argument(
        "crank-radius",
        "MM",
        "Distance from the driver's axis to the pin's centre",
        |_| MeasuredSize::CrankRadius,
        1.0,
    ),
    argument("pin-diameter", "MM", "Diameter of the pins", |_| MeasuredSize::PinDiameter, 1.0),
    argument("outside-diameter", "MM", "Outside diameter of the wheel", |_| MeasuredSize::TipRadius, 0.5),
    argument(
        "tip-radius",
        "MM",
        "Radius of the wheel's rim: half the outside diameter",
        |_| MeasuredSize::TipRadius,
        1.0,
    ),
    argument("slot-width", "MM", "Width of the slots, or of single slots", MeasuredSize::SlotWidth, 1.0),
    argument(
        "slot-end",
        "MM",
        "Distance from the wheel's axis to the centre of the slots' round ends",
        MeasuredSize::SlotEnd,
        1.0,
    ),
    argument(
        "slot-direction",
        "DEG",
        "How far single slots are counter-clockwise of their right direction",
        |number| MeasuredSize::SlotDirection(number.unwrap_or_default()),
        PI / 180.0,
    ),
    argument("locking-arc-radius", "MM", "Radius of the locking arcs", MeasuredSize::ArcRadius, 1.0),
    argument(
        "locking-arc-centre",
        "MM",
        "Distance from the wheel's axis to the centres of the locking arcs",
        MeasuredSize::ArcCentre,
        1.0,
    ),
    argument("locking-disc-radius", "MM", "Radius of the locking disc", |_| MeasuredSize::DiscRadius, 1.0),
    argument(
        "crescent-centre",
        "MM",
        "Distance from the driver's axis to the centre of the cut in the disc",
        |_| MeasuredSize::CrescentCentre,
        1.0,
    ),
    argument("crescent-radius", "MM", "Radius of the cut in the disc", |_| MeasuredSize::CrescentRadius, 1.0),
    argument(
        "new-pin-diameter",
        "MM",
        "Diameter of the pins when they were new: by a drawing, a spare part, or where nothing rubs",
        |_| MeasuredSize::NewPinDiameter,
        1.0,
    ),
    argument(
        "new-slot-width",
        "MM",
        "Width of the slots when they were new: by a drawing, or where no pin runs",
        |_| MeasuredSize::NewSlotWidth,
        1.0,
    ),
    argument(
        "new-locking-disc-radius",
        "MM",
        "Radius of the locking disc when it was new",
        |_| MeasuredSize::NewDiscRadius,
        1.0,
    ),
    argument(
        "new-locking-arc-radius",
        "MM",
        "Radius of the locking arcs when they were new",
        |_| MeasuredSize::NewArcRadius,
        1.0,
    ),
];

const fn argument(
    name: &'static str,
    value: &'static str,
    help: &'static str,
    size: fn(Option<usize>) -> MeasuredSize,
    scale: f64,
) -> CheckArgument {
    CheckArgument { name, value, help, size, scale }
}

impl CheckArgument {
    /// Which size it is, of all slots or arcs.
    pub(super) fn size_of_all(&self) -> MeasuredSize {
        (self.size)(None)
    }

    /// Adds the measurements of a typed value.
    ///
    /// # Errors
    ///
    /// What is no number, a comma in a number, a slot or an arc that there is not or that is given twice.
    pub(super) fn add(&self, measured: &mut MeasuredWheel, text: &str, default: f64) -> Result<(), Error> {
        let entries: Vec<&str> = text.split(',').map(str::trim).collect();
        if entries.len() > 1 && !entries.iter().all(|one| one.contains(':')) {
            return Err(refused!("--{} {text}: {}", self.name, self.comma_advice(measured, &entries, default)));
        }
        let mut places = Vec::new();
        for one in entries {
            let (place, value) = one.split_once(':').map_or((None, one), |(place, value)| (Some(place), value));
            let place = place.map(|place| crate::number::<usize>(self.name, place.trim())).transpose()?;
            if let Some(place) = place.filter(|place| places.contains(place)) {
                return Err(refused!("--{} {text}: number {place} is given twice; give each number once", self.name));
            }
            places.extend(place);
            let is_of_one = matches!((self.size)(None), MeasuredSize::SlotDirection(_));
            let is_of_many = (self.size)(Some(0)).number().is_some();
            if place == Some(0) || (place.is_some() && !is_of_many) || (place.is_none() && is_of_one) {
                return Err(refused!(
                    "--{} {text}: {}",
                    self.name,
                    if is_of_many {
                        "slots and arcs are numbered from 1; give such as 1:6.1,2:6.0"
                    } else {
                        "there is one only; give a number"
                    }
                ));
            }
            let (value, uncertainty) = value
                .split_once("+-")
                .or_else(|| value.split_once('±'))
                .map_or((value, None), |(value, uncertainty)| (value, Some(uncertainty)));
            let read = |text: &str| if is_of_one { crate::number(self.name, text) } else { length(self.name, text) };
            let value: f64 = read(value.trim())?;
            let uncertainty = uncertainty.map(|text| read(text.trim())).transpose()?;
            // An angle without an uncertainty of its own has that of a length at half the size of the unit circle: a degree's tenth.
            let default = if is_of_one { DIRECTION_UNCERTAINTY } else { default };
            let size = (self.size)(place.map(|place| place - 1));
            let uncertainty = self.scale * uncertainty.unwrap_or(default);
            measured.add(size, self.scale * value, uncertainty).map_err(measured_error)?;
        }
        Ok(())
    }
}

impl CheckArgument {
    /// What to write instead of these entries, some of which have no number of a slot or an arc: a comma may be meant for a point.
    fn comma_advice(&self, measured: &MeasuredWheel, entries: &[&str], default: f64) -> String {
        let mut with_points = String::new();
        for (k, one) in entries.iter().enumerate() {
            let mark = if one.contains(':') { "," } else { "." };
            with_points += if k == 0 { "" } else { mark };
            with_points += one;
        }
        let is_numbered = with_points.contains(':');
        let of_one = if is_numbered { None } else { advice(&entries.join(","), TypedNumber::Length) };
        let is_read = || self.add(&mut measured.clone(), &with_points, default).is_ok();
        let written =
            of_one.or_else(|| is_read().then(|| format!("give {with_points}, with a decimal point, not a comma")));
        match (written, (self.size)(Some(0)).number().is_some()) {
            (Some(written), false) => written,
            (Some(written), true) => {
                format!("{written}; commas are between slots or arcs with their numbers, as in 1:6.1,2:6.0")
            }
            (None, true) => "give each slot or arc with its number, as in 1:6.1,2:6.0".to_owned(),
            (None, false) => "there is one only; give a single number, with a decimal point".to_owned(),
        }
    }
}

/// The standard uncertainty of a direction without one, in degrees: our choice.
const DIRECTION_UNCERTAINTY: f64 = 0.1;

pub(super) fn measured_error(error: MeasuredError) -> Error {
    Error::Argument(error.to_string())
}
