//! The sizes of an external or an internal wheel from what a question gives: choices, plays and pins of a process, own inertia.

use super::fitting::{Fit, remedies};
use super::mouth::asked_mouth;
use super::question::{WheelQuestion, given};
use crate::Error;
use geneva_kinematics::KinematicsError;
use geneva_kinematics::internal_sizes::InternalSizes;
use geneva_kinematics::internal_wheel::InternalWheel;
use geneva_kinematics::wheel::as_built::ProcessNumbers;
use geneva_kinematics::wheel::{Choices, Play, Remedy, Scale, Sizes, SizesError, Wheel};
use geneva_workshop::Thread;

/// Moment of inertia of the wheel alone, in kg m², if size and thickness are given.
pub(super) fn own_inertia(sizes: Option<&Sizes>, thickness: Option<f64>, density: f64) -> Result<Option<f64>, Error> {
    let outline = sizes.zip(thickness);
    Ok(outline.map(|(sizes, thickness)| sizes.outline().wheel.moment_of_inertia(thickness, density)).transpose()?)
}

/// Moment of inertia of an internal wheel's ring with its plate, in kg m², if crank radius and thickness are given.
pub(super) fn own_inertia_of_internal(
    wheel: InternalWheel,
    crank_radius: Option<f64>,
    density: f64,
    question: &WheelQuestion,
) -> Result<Option<f64>, Error> {
    let (Some(radius), Some(thickness)) = (crank_radius, question.thickness) else { return Ok(None) };
    Ok(Some(internal_sizes(wheel, radius, question)?.moment_of_inertia(thickness, density)?))
}

/// What was chosen of the parts.
fn choices(question: &WheelQuestion) -> Choices {
    Choices {
        pin_diameter: question.pin_diameter,
        play: question.play.map(Play::from_slot),
        bottom_clearance: question.bottom_clearance,
        horn_thickness: question.horn,
        locking_arc_radius: question.locking_arc_radius,
        wheel_shaft: given(question.wheel_shaft),
        driver_shaft: given(question.driver_shaft),
        plate_shaft: given(question.plate_shaft),
        mouth: asked_mouth(question).unwrap_or_default(),
    }
}

pub(super) fn sizes(wheel: Wheel, scale: Scale, question: &WheelQuestion) -> Result<Sizes, SizesError> {
    let usual = |choices: &Choices| {
        Sizes::new(wheel, scale, choices).map(|sizes| (sizes.pin_diameter, sizes.play, sizes.centre_distance))
    };
    let of = |question: &WheelQuestion| Sizes::new(wheel, scale, &with_plays(question, &usual)?);
    let mut sizes = of(question)?;
    // A bush with a wall that can be made, or the screw itself.
    for pin in pins_for_screw(question, sizes.pin_diameter, |thread| vec![thread.least_bush(), thread.diameter()]) {
        let other = of(&WheelQuestion { pin_diameter: Some(pin), ..question.clone() });
        if let Some(other) = other.ok().filter(Sizes::has_sound_walls) {
            sizes = other;
            break;
        }
    }
    sizes.play.pin = pin_shift(question, sizes.pin_diameter);
    Ok(sizes)
}

/// The pin diameters in millimetres to try with the screw that is asked for; none where a diameter is given, too, and where the usual one
/// will do.
fn pins_for_screw(question: &WheelQuestion, usual: f64, pins: impl Fn(Thread) -> Vec<f64>) -> Vec<f64> {
    let screw = question.mounting.pin_screw.filter(|_| question.pin_diameter.is_none());
    screw
        .map(pins)
        .filter(|pins| !pins.contains(&usual) && screw.is_some_and(|screw| !screw.holds_pin(usual) || pins.len() == 1))
        .unwrap_or_default()
}

/// How far a pin of this diameter may be off its place as it is mounted, in millimetres; zero where its mounting contradicts itself,
/// which is refused where parts are listed.
fn pin_shift(question: &WheelQuestion, pin_diameter: f64) -> f64 {
    question.mounting.pins().map_or(0.0, |pins| pins.shift(pin_diameter))
}

/// Sizes of an internal wheel with a crank radius in millimetres; what does not fit is refused with values that fit.
pub(super) fn internal_sizes(
    wheel: InternalWheel,
    crank_radius: f64,
    question: &WheelQuestion,
) -> Result<InternalSizes, Error> {
    let usual = |choices: &Choices| {
        let sizes = InternalSizes::new(wheel, crank_radius, choices)?;
        Ok((sizes.pin_diameter, sizes.play, sizes.centre_distance))
    };
    let sizes = |question: &WheelQuestion| -> Result<InternalSizes, SizesError> {
        let of = |question: &WheelQuestion| InternalSizes::new(wheel, crank_radius, &with_plays(question, &usual)?);
        let mut sizes = of(question)?;
        // The ring plate leaves no room for the head of a bush's screw.
        for pin in pins_for_screw(question, sizes.pin_diameter, |thread| vec![thread.diameter()]) {
            let other = of(&WheelQuestion { pin_diameter: Some(pin), ..question.clone() });
            sizes = other.ok().filter(InternalSizes::has_sound_walls).unwrap_or(sizes);
        }
        sizes.play.pin = pin_shift(question, sizes.pin_diameter);
        Ok(sizes)
    };
    let fits = |other: &WheelQuestion| sizes(other).map_or(Fit::Not, |sizes| Fit::of(sizes.has_sound_walls()));
    sizes(question).map_err(|error| with_remedies(error, question, &fits))
}

/// Pin diameter, plays and centre distance of a wheel, in millimetres.
type UsualSizes = (f64, Play, f64);

/// What was chosen, with plays and pin of the process where these are not given. Pin diameter, play and centre distance of a wheel
/// with some choices are what `usual` says, in millimetres.
fn with_plays(
    question: &WheelQuestion,
    usual: &dyn Fn(&Choices) -> Result<UsualSizes, SizesError>,
) -> Result<Choices, SizesError> {
    let choices = choices(question);
    let (locking, bore, slot) = (question.locking_play, question.bore_play, question.slot_width);
    let is_of_process = question.process.is_some() && (question.play.is_none() || question.pin_diameter.is_none());
    if locking.or(bore).or(slot).is_none() && !is_of_process {
        return Ok(choices);
    }
    // What is not given is as it is without, or as the process has it.
    let bare = Choices { wheel_shaft: None, driver_shaft: None, plate_shaft: None, ..choices };
    let (usual_pin, usual_play, centre_distance) = usual(&bare)?;
    let of_process = process_numbers(question, centre_distance)?.filter(|_| question.play.is_none());
    let play_as_usual = of_process.map_or(usual_play, |numbers| numbers.play());
    let with_pin = |pin_diameter: Option<f64>| {
        let pin = pin_diameter.unwrap_or(usual_pin);
        let play = slot.map_or(play_as_usual, |width| Play::from_slot(width - pin));
        if play.slot < 0.0 {
            let what = "the pin is thicker than the slot is wide";
            return Err(SizesError::DoesNotFit { what, by: -play.slot, remedies: &[Remedy::ThinnerPin] });
        }
        let play = Play { locking: locking.unwrap_or(play.locking), bore: bore.unwrap_or(play.bore), ..play };
        Ok(Choices { pin_diameter, play: Some(play), ..choices })
    };
    if question.process.is_none() || question.pin_diameter.is_some() {
        return with_pin(choices.pin_diameter);
    }
    // With the play of a process the thickest pin that fits without it may not fit.
    let fits = |pin: f64| with_pin(Some(pin)).ok().filter(|choices| usual(choices).is_ok());
    stock_pins(usual_pin).find_map(fits).map_or_else(|| with_pin(stock_pins(usual_pin).next()), Ok)
}

/// Diameters of parallel pins in millimetres as they are sold (ISO 2338), without the thinnest and the thickest.
const STOCK_PINS: [f64; 16] = [1.0, 1.2, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0, 10.0, 12.0, 16.0, 20.0, 25.0, 30.0];

/// The pins that are sold and no thicker than this one, the thickest first; diameters in millimetres.
fn stock_pins(diameter: f64) -> impl Iterator<Item = f64> {
    STOCK_PINS.into_iter().rev().filter(move |pin| *pin <= diameter)
}

/// The numbers of the process by which the parts are made, for a centre distance in millimetres, if one is named.
pub(super) fn process_numbers(
    question: &WheelQuestion,
    centre_distance: f64,
) -> Result<Option<ProcessNumbers>, KinematicsError> {
    let Some(process) = question.process else { return Ok(None) };
    let numbers = ProcessNumbers::new(process, centre_distance)?;
    question.measured_play.map_or(Ok(numbers), |play| numbers.with_measured_play(play)).map(Some)
}

/// The error about sizes that don't fit, with the arguments that make them fit; `fits` says how those of a question do.
pub(super) fn with_remedies(
    error: SizesError,
    question: &WheelQuestion,
    fits: &dyn Fn(&WheelQuestion) -> Fit,
) -> Error {
    let remedies = match &error {
        // What no wheel has says itself what to give.
        SizesError::Kinematics(_) | SizesError::Play { .. } => Vec::new(),
        _ if question.is_trial => Vec::new(),
        _ => remedies(question, &|other| if other.is_in_range() { fits(other) } else { Fit::Not }),
    };
    Error::Sizes { error, remedies }
}
