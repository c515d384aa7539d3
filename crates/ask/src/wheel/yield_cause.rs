//! Why too few assemblies turn: the largest of the causes, and a value that helps.
//!
//! Each cause is left out in turn and the assemblies are counted again; the one without which most turn is the largest. A value that is
//! named was tried with all 1000 assemblies.

use super::design::WheelDesign;
use super::process::{ENOUGH, SEED};
use super::question::WheelQuestion;
use crate::Error;
use crate::number_format::{as_typed, to_digits};
use geneva_kinematics::wheel::as_built::{Assemblies, ErrorShape, SizeErrors};
use geneva_workshop::ScrewHole;

/// Assemblies that are counted without each of the causes.
const COUNTED: u64 = 300;
/// Tried values over the one of the design, from that on which costs least.
const LESS: [f64; 7] = [0.75, 0.5, 0.35, 0.25, 0.15, 0.1, 0.05];
const MORE: [f64; 6] = [1.2, 1.5, 1.75, 2.0, 2.5, 3.0];
/// Significant digits of a value that is tried.
const DIGITS: usize = 2;

/// What keeps assemblies from turning.
#[derive(Clone, Copy, PartialEq)]
enum JamCause {
    BorePlay,
    PinScrew,
    DiscOnPlate,
    Errors,
}

impl JamCause {
    const ALL: [Self; 4] = [Self::BorePlay, Self::PinScrew, Self::DiscOnPlate, Self::Errors];

    fn words(self, design: &WheelDesign) -> String {
        let mm = |length: f64| to_digits(length, 3);
        let play = design.sizes.map(|sizes| sizes.play);
        match self {
            Self::BorePlay => format!("the bore play of {} mm", mm(play.map_or(0.0, |play| play.bore))),
            Self::PinScrew => {
                format!(
                    "the holes of the pin's screw, in which it is off by up to {} mm",
                    mm(play.map_or(0.0, |play| play.pin))
                )
            }
            Self::DiscOnPlate => "the locking disc, which is loose on its plate".to_owned(),
            Self::Errors => "the errors of the sizes, for which the play is small".to_owned(),
        }
    }
}

impl WheelDesign {
    /// Why too few assemblies of an external wheel turn, with what helps; none where enough do, or no process is named.
    ///
    /// # Errors
    ///
    /// As for [`count_assemblies`](Self::count_assemblies).
    pub(super) fn yield_cause(&self) -> Result<Option<String>, Error> {
        let Some((sizes, numbers)) = self.sizes.as_ref().zip(self.process_numbers()?) else { return Ok(None) };
        let Some(found) = self.assemblies_that_turn()?.filter(|found| found.share() < ENOUGH) else { return Ok(None) };
        let without = |cause: JamCause| {
            let unless = |other: JamCause, value: f64| if cause == other { 0.0 } else { value };
            let errors = if cause == JamCause::Errors { SizeErrors::from_greatest(0.0) } else { numbers.errors() };
            let assemblies = Assemblies::new(sizes, errors, ErrorShape::Normal, SEED)
                .with_bore_play(unless(JamCause::BorePlay, sizes.play.bore))
                .with_pin_shift(unless(JamCause::PinScrew, sizes.play.pin))
                .with_disc_turn(unless(JamCause::DiscOnPlate, self.disc_turn()));
            assemblies.count(0..COUNTED).map_or(0.0, |found| found.share())
        };
        let is_there = |cause: &JamCause| match cause {
            JamCause::BorePlay => sizes.play.bore > 0.0,
            JamCause::PinScrew => sizes.play.pin > 0.0,
            JamCause::DiscOnPlate => self.disc_turn() > 0.0,
            JamCause::Errors => true,
        };
        let mut causes: Vec<(JamCause, f64)> =
            JamCause::ALL.into_iter().filter(is_there).map(|cause| (cause, without(cause))).collect();
        causes.sort_by(|one, other| other.1.total_cmp(&one.1));
        // What helps against the largest cause goes before what helps against the next.
        let remedy = causes.iter().find_map(|(cause, _)| self.remedy(*cause));
        let Some((cause, share)) = causes.first() else { return Ok(None) };
        let helps = remedy.unwrap_or_else(|| {
            "no one change is enough: give tighter bores and more --play, or choose a process with smaller errors"
                .to_owned()
        });
        Ok(Some(format!(
            "only {} of the assemblies turn; the largest cause is {}: without it, {} would; {helps}",
            percent(found.share()),
            cause.words(self),
            percent(*share)
        )))
    }

    /// A change with which enough assemblies turn, and how many then do; none if nothing that was tried is enough.
    fn remedy(&self, cause: JamCause) -> Option<String> {
        let play = self.sizes?.play;
        let value = |part: f64, length: f64| to_digits(part * length, DIGITS).parse().ok();
        let changes: Vec<(String, WheelQuestion)> = match cause {
            JamCause::BorePlay => {
                let with = |bore: f64| {
                    let other = WheelQuestion { bore_play: Some(bore), ..self.question.clone() };
                    (format!("--bore-play {}", as_typed(bore)), other)
                };
                LESS.into_iter().filter_map(|part| value(part, play.bore)).chain([0.0]).map(with).collect()
            }
            JamCause::Errors => {
                let with = |slot: f64| {
                    let bore_play = self.question.bore_play.or(Some(play.bore));
                    let other =
                        WheelQuestion { play: Some(slot), slot_width: None, bore_play, ..self.question.clone() };
                    let also = if self.question.bore_play.is_some() {
                        String::new()
                    } else {
                        format!(" --bore-play {}", as_typed(play.bore))
                    };
                    (format!("--play {}{also}", as_typed(slot)), other)
                };
                MORE.into_iter().filter_map(|part| value(part, play.slot)).map(with).collect()
            }
            JamCause::PinScrew => {
                let mut tapped = self.question.clone();
                tapped.mounting.pin_screw_hole = Some(ScrewHole::Tapped);
                let mut itself = tapped.clone();
                itself.pin_diameter = self.question.mounting.pin_screw.map(|thread| thread.diameter());
                let diameter = itself.pin_diameter.map_or_else(String::new, as_typed);
                vec![
                    ("--pin-screw-hole tapped".to_owned(), tapped),
                    (format!("--pin-screw-hole tapped --pin-diameter {diameter}"), itself),
                ]
            }
            JamCause::DiscOnPlate => {
                let mut one = self.question.clone();
                one.mounting.stacked = Some(false);
                vec![("--driver-pieces one-piece".to_owned(), one)]
            }
        };
        changes.into_iter().find_map(|(words, other)| {
            let design = WheelDesign::new(WheelQuestion { is_trial: true, ..other }).ok()?;
            design.makeable_parts().ok()?;
            let found = design.enough_that_turn().ok()??;
            Some(format!("with {words}, {} do", percent(found.share())))
        })
    }
}

fn percent(share: f64) -> String {
    format!("{:.0} %", libm::floor(100.0 * share))
}

#[cfg(test)]
mod tests {
    use crate::wheel::{WheelDesign, WheelQuestion};

    fn cause(question: &str) -> Option<String> {
        let design = WheelDesign::new(WheelQuestion::parse(question).expect(question)).expect(question);
        design.yield_cause().expect(question)
    }

    #[test]
    fn the_largest_cause_is_named_with_a_value_that_helps() {
        let wheel = "--stations 4 --crank-radius 25 --process fdm --wheel-shaft 5 --driver-shaft 5";
        for (more, named, option) in [
            ("--measured-play 0.2", "the bore play of 0.400 mm", "--bore-play "),
            ("--play 0.3 --bore-play 0.02", "the errors of the sizes", "--play "),
        ] {
            let question = format!("{wheel} {more}");
            let said = cause(&question).expect(&question);
            assert!(said.contains(&format!("the largest cause is {named}")), "{said}");
            let (_, change) = said.split_once("with --").expect(&said);
            let (change, _) = change.split_once(',').expect(&said);
            assert!(format!("--{change}").starts_with(option), "{said}");
            // What is changed is given once.
            let kept = question.split(" --").filter(|part| {
                !part.starts_with("--stations")
                    && change.split(" --").all(|new| new.split(' ').next() != part.split(' ').next())
            });
            let changed = format!("--stations 4 --{} --{change}", kept.collect::<Vec<_>>().join(" --"));
            assert_eq!(cause(&changed), None, "{said}: {changed}");
        }
        assert_eq!(cause(&format!("{wheel} --bore-play 0.1")), None);
    }
}
