//! Errors about what can't be mounted, with the arguments that change it.

use super::arguments::{Argument, MOUNTING};
use super::design::WheelDesign;
use super::fitting::{Fit, fitting_values, refusal, remedies_among};
use super::mounting::{BoreShape, PinKind};
use super::question::WheelQuestion;
use crate::Error;
use crate::number_format::{as_typed, rounded_down};
use geneva_workshop::{MountingError, Thread};

/// The play of a bore over the depth of a flat with which the flat is told to hold: our choice.
const HALF: f64 = 0.5;

/// The shaft of a plate over the width of the disc on it with which the disc is told to rest on the plate: our choice.
const LEDGES: [f64; 3] = [0.9, 0.75, 0.5];

/// The depth of a shoulder over the thickness of its base plate with which it is told to leave enough below it: our choice.
const OF_THICKNESS: f64 = 0.9;

/// How many changes are named at most.
const NAMED: usize = 3;

/// Thinner dowels that are tried, over the one that was asked for.
const THINNER: [f64; 6] = [0.8, 0.65, 0.5, 0.35, 0.25, 0.15];

/// The error about what can't be mounted, with the arguments that mend it; `fits` says how the parts of a question fit that differs in
/// the mounting only.
pub(super) fn with_remedies_of_mounting(
    error: MountingError,
    question: &WheelQuestion,
    fits: &dyn Fn(&WheelQuestion) -> Fit,
) -> Error {
    // What to choose stands behind what is wrong, and values say it better.
    let words = error.to_string();
    let reason = words.split_once("; ").map_or(words.as_str(), |(reason, _)| reason);
    if question.is_trial {
        return Error::Argument(words);
    }
    let changes = tried_changes(&error, question);
    if !changes.is_empty() {
        return refused!("{reason}; give {}", changes.join(", or "));
    }
    let in_range = |other: &WheelQuestion| if other.is_in_range() { fits(other) } else { Fit::Not };
    let remedies = remedies_among(MOUNTING, question, &in_range);
    if remedies.is_empty() {
        let pairs = pairs_that_fit(&error, question, &|other| in_range(other) != Fit::Not);
        return if pairs.is_empty() { with_given(&error, question) } else { refused!("{reason}; give {pairs}") };
    }
    let less_play = match error {
        MountingError::LooseFlat { across, shaft, .. } => {
            format!(", or --bore-play up to {}", rounded_down(HALF * (shaft - across)))
        }
        _ => String::new(),
    };
    Error::Argument(refusal(reason, &remedies) + &less_play)
}

/// A change of a question in words, and the question so changed.
type Change = (String, WheelQuestion);

/// What can be given instead so that all files can be made, in words: each was tried.
fn tried_changes(error: &MountingError, question: &WheelQuestion) -> Vec<String> {
    let changes = changes(error, question).into_iter().filter(|(_, other)| can_be_made(other));
    changes.take(NAMED).map(|(words, _)| words).collect()
}

/// Whether all files of a question can be made.
fn can_be_made(other: &WheelQuestion) -> bool {
    let tried = WheelDesign::new(WheelQuestion { is_trial: true, ..other.clone() });
    tried.is_ok_and(|design| design.makeable_parts().is_ok())
}

/// What may be given instead where a screw and its pin, a shaft and its key, or a pocket and its part don't go together.
fn changes(error: &MountingError, question: &WheelQuestion) -> Vec<Change> {
    let with_pin = |pin: f64| WheelQuestion { pin_diameter: Some(pin), ..question.clone() };
    let screwed = |thread: Option<Thread>| {
        let mut other = question.clone();
        other.mounting.pin_screw = thread;
        other
    };
    match error {
        MountingError::ThickScrew { .. } | MountingError::ThinBush { .. } | MountingError::HeadUnderRing { .. } => {
            let Some(thread) = question.mounting.pin_screw else { return Vec::new() };
            let itself = thread.diameter();
            let mut changes = vec![(
                format!("--pin-diameter {}, which is then the screw itself", as_typed(itself)),
                with_pin(itself),
            )];
            let bush = thread.least_bush();
            changes.push((format!("--pin-diameter {}", as_typed(bush)), with_pin(bush)));
            let thinner = Thread::ALL.into_iter().rev().filter(|other| other.diameter() < itself);
            changes.extend(thinner.map(|other| (format!("--pin-screw {}", other.name()), screwed(Some(other)))));
            let mut dowel = screwed(None);
            (dowel.mounting.pin_screw_hole, dowel.mounting.pin_mount) = (None, Some(PinKind::Dowel));
            changes.push(("--pin-mount dowel without --pin-screw".to_owned(), dowel));
            changes
        }
        MountingError::Floating { width, .. } => {
            let thinner = LEDGES.map(|part| {
                let shaft = rounded_down(part * width);
                let other = WheelQuestion { plate_shaft: shaft.parse().ok(), ..question.clone() };
                (format!("--plate-shaft up to {shaft}"), other)
            });
            let mut apart = question.clone();
            apart.mounting.stacked = Some(true);
            let apart = ("--driver-pieces two-pieces".to_owned(), apart);
            thinner.into_iter().filter(|(_, other)| can_be_made(other)).take(1).chain([apart]).collect()
        }
        MountingError::Keyed { shaft, least, most, .. } => keyed_changes(question, *shaft, shaft.clamp(*least, *most)),
        MountingError::TooDeep { part, hole, depth, thickness, .. } => {
            // The next half millimetre that leaves as much below the pocket.
            let thick = libm::floor(2.0 * depth + 1.0) / 2.0;
            let (mut thicker, mut flatter, mut without) = (question.clone(), question.clone(), question.clone());
            if *part == "base plate" {
                thicker.mounting.base_thickness = Some(thick);
                let depth = rounded_down(OF_THICKNESS * thickness);
                flatter.mounting.shoulder_depth = depth.parse().ok();
                let thicker = (format!("--base-thickness {} or more", as_typed(thick)), thicker);
                return vec![thicker, (format!("--shoulder-depth up to {depth}"), flatter)];
            }
            thicker.thickness = Some(thick);
            let option = if *hole == "a hole of the hub" {
                without.mounting.hub_screw_hole = None;
                "hub-screw-hole"
            } else {
                without.mounting.pin_screw_hole = None;
                "pin-screw-hole"
            };
            let mut changes = vec![(format!("--thickness {} or more", as_typed(thick)), thicker)];
            // A thinner screw has a flatter nut.
            let screw =
                if option == "hub-screw-hole" { question.mounting.hub_screw } else { question.mounting.pin_screw };
            let thinner =
                Thread::ALL.into_iter().rev().filter(|other| screw.is_some_and(|of| other.diameter() < of.diameter()));
            changes.extend(thinner.filter(|_| option == "hub-screw-hole").map(|other| {
                let mut changed = question.clone();
                changed.mounting.hub_screw = Some(other);
                (format!("--hub-screw {}", other.name()), changed)
            }));
            changes.push((format!("--{option} clearance"), without));
            changes
        }
        _ => Vec::new(),
    }
}

/// Other shafts, or bores without a keyway, where no key is made for a shaft of this diameter in millimetres.
fn keyed_changes(question: &WheelQuestion, shaft: f64, nearest: f64) -> Vec<Change> {
    let is_of_wheel = |name: &str| name == "wheel-shaft";
    let of = |name: &str| match name {
        "wheel-shaft" => question.wheel_shaft,
        "driver-shaft" => question.driver_shaft,
        _ => question.plate_shaft,
    };
    let all = ["wheel-shaft", "driver-shaft", "plate-shaft"].into_iter().filter(|name| of(name) == Some(shaft));
    all.flat_map(|name| {
        let (mut thick, mut round) = (question.clone(), question.clone());
        match name {
            "wheel-shaft" => thick.wheel_shaft = Some(nearest),
            "driver-shaft" => thick.driver_shaft = Some(nearest),
            _ => thick.plate_shaft = Some(nearest),
        }
        let asked = &mut round.mounting;
        let part = if is_of_wheel(name) { "wheel" } else { "driver" };
        *(if is_of_wheel(name) { &mut asked.wheel_bore_shape } else { &mut asked.driver_bore_shape }) =
            Some(BoreShape::Round);
        [(format!("--{name} {}", as_typed(nearest)), thick), (format!("--{part}-bore-shape round"), round)]
    })
    .collect()
}

/// Dowels or screws that are thinner, with the circles on which they then fit, where no circle alone helps; empty if none does.
fn pairs_that_fit(error: &MountingError, question: &WheelQuestion, fits: &dyn Fn(&WheelQuestion) -> bool) -> String {
    let MountingError::BreaksOut { hole, .. } = error else { return String::new() };
    let argument = |name: &str| -> Option<&Argument> { MOUNTING.iter().find(|argument| argument.name == name) };
    let (circles, dowel): (&[&str], _) = match *hole {
        "a hole of the hub" => (&["wheel-hub-circle", "driver-hub-circle"], "hub-dowel"),
        "a dowel's hole" => (&["disc-dowel-circle"], "disc-dowel"),
        _ => return String::new(),
    };
    let mut thinner: Vec<Change> = Vec::new();
    if let Some(given) = argument(dowel).and_then(|dowel| question.number(dowel)) {
        for part in THINNER {
            let value = rounded_down(part * given);
            let Some(argument) = argument(dowel) else { continue };
            let other = value.parse().ok().and_then(|value| question.with_number(argument, Some(value)));
            thinner.extend(other.map(|other| (format!("--{dowel} {value}"), other)));
        }
    } else if let Some(thread) = question.mounting.hub_screw {
        for other in Thread::ALL.into_iter().rev().filter(|other| other.diameter() < thread.diameter()) {
            let mut changed = question.clone();
            changed.mounting.hub_screw = Some(other);
            thinner.push((format!("--hub-screw {}", other.name()), changed));
        }
    }
    let given = circles.iter().filter_map(|name| argument(name)).filter(|circle| question.number(circle).is_some());
    let given: Vec<&Argument> = given.collect();
    for (words, other) in thinner {
        for circle in &given {
            if let Some(values) = fitting_values(circle, &other, fits) {
                return format!("{words} with --{} {}", values.name, values.range());
            }
        }
    }
    String::new()
}

/// The error with the arguments that were given for what it is about.
fn with_given(error: &MountingError, question: &WheelQuestion) -> Error {
    let asked = &question.mounting;
    let numbers = match error {
        MountingError::NoShaft { part, what } => {
            let shaft = match *part {
                "wheel" | "ring plate" => "wheel-shaft",
                _ if question.kind == Some(super::kind::WheelKind::Internal) => "plate-shaft",
                _ => "driver-shaft",
            };
            return refused!("{part}: {what} needs a shaft; add its diameter, --{shaft} MM");
        }
        MountingError::BreaksOut { hole, .. } | MountingError::TooDeep { hole, .. } => match *hole {
            "a hole of the hub" => vec![
                ("wheel-hub-circle", asked.wheel_hub_circle),
                ("driver-hub-circle", asked.driver_hub_circle),
                ("hub-dowel", asked.hub_dowel),
            ],
            "a dowel's hole" => {
                vec![("disc-dowel-circle", asked.disc_dowel_circle), ("disc-dowel", asked.disc_dowel)]
            }
            "the bore" => vec![
                ("wheel-shaft", question.wheel_shaft),
                ("driver-shaft", question.driver_shaft),
                ("plate-shaft", question.plate_shaft),
            ],
            _ => Vec::new(),
        },
        _ => Vec::new(),
    };
    let given = numbers.iter().filter_map(|(name, value)| Some(format!("--{name} {}", as_typed((*value)?))));
    let given = given.collect::<Vec<_>>().join(", ");
    if given.is_empty() { refused!("{error}") } else { refused!("{error} ({given})") }
}

#[cfg(test)]
mod tests {
    use crate::Error;
    use crate::wheel::{WheelDesign, WheelQuestion};

    fn made(question: &str) -> Result<f64, Error> {
        let design = WheelDesign::new(WheelQuestion::parse(question)?)?;
        let pin = design.makeable_parts()?.map(|_| design.sizes.map_or(0.0, |sizes| sizes.pin_diameter));
        Ok(pin.unwrap_or(0.0))
    }

    #[test]
    fn what_a_refusal_says_to_give_can_be_made() {
        for (wheel, wrong, kept) in [
            ("--stations 4 --crank-radius 25", "--pin-diameter 3 --pin-screw M4", "--pin-screw M4"),
            ("--stations 4 --crank-radius 25", "--pin-diameter 6 --pin-screw M4", "--pin-screw M4"),
            ("--stations 6 --crank-radius 25", "--wheel-bore-shape key --wheel-shaft 5", "--wheel-bore-shape key"),
            (
                "--stations 6 --crank-radius 60",
                "--thickness 2 --pin-diameter 12 --pin-screw M3 --pin-screw-hole nut-trap",
                "--pin-diameter 12 --pin-screw M3 --pin-screw-hole nut-trap",
            ),
            (
                "--stations 6 --type internal --crank-radius 40 --thickness 6",
                "--disc-dowel 30 --disc-dowel-circle 150",
                "",
            ),
            (
                "--stations 6 --crank-radius 60 --wheel-hub-circle 40",
                "--thickness 3 --hub-screw M4 --hub-screw-hole nut-trap",
                "--hub-screw M4 --hub-screw-hole nut-trap",
            ),
            (
                "--stations 6 --type internal --crank-radius 60 --wheel-hub-circle 30 --hub-screw-hole nut-trap",
                "--thickness 2 --hub-screw M5",
                "--hub-screw M5",
            ),
            (
                "--stations 6 --crank-radius 60 --wheel-shaft 6 --plate-shaft 6 --base-thickness 10 --shoulder-diameter 12",
                "--shoulder-depth 12",
                "--shoulder-depth 12",
            ),
            ("--stations 6 --crank-radius 40", "--plate-shaft 60", ""),
            ("--stations 6 --crank-radius 40", "--plate-shaft 60 --driver-shaft 8", "--driver-shaft 8"),
            ("--stations 6 --type internal --crank-radius 40 --thickness 6", "--plate-shaft 70", ""),
        ] {
            let said = made(&format!("{wheel} {wrong}")).expect_err(wrong).to_string();
            let (_, change) = said.split_once("; give ").expect(&said);
            let change = change.split(", or ").next().and_then(|first| first.split(", which").next()).expect(&said);
            let words: Vec<&str> =
                change.split(' ').filter(|word| !matches!(*word, "with" | "from" | "or" | "more" | "up")).collect();
            // Of a range, the least value.
            let [from, until] = ["from", "up"].map(|word| change.contains(&format!(" {word} ")));
            let change: String = if until && !from {
                words.iter().filter(|word| **word != "to").copied().collect::<Vec<_>>().join(" ")
            } else {
                words.split(|word| *word == "to").next().map(|words| words.join(" ")).expect(&said)
            };
            assert!(made(&format!("{wheel} {kept} {change}")).is_ok(), "{said}: {change}");
            assert!(!said.contains("thinner pin"), "{said}");
        }
        let bare = made("--stations 6 --crank-radius 25 --wheel-flat 5").expect_err("no shaft").to_string();
        assert!(bare.ends_with("add its diameter, --wheel-shaft MM"), "{bare}");
    }

    #[test]
    fn a_screw_without_a_pin_gets_a_bush_with_a_wall_or_is_the_pin() {
        let printed = "--stations 4 --crank-radius 25 --process fdm";
        assert_eq!([made(printed), made(&format!("{printed} --pin-screw M4"))], [Ok(6.0), Ok(6.5)]);
        assert_eq!(made(&format!("{printed} --pin-screw M3")), Ok(6.0));
        assert_eq!(made(&format!("{printed} --pin-screw M6")), Ok(6.0));
    }
}
