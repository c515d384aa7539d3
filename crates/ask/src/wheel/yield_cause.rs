//! Why too few assemblies turn: the largest of the causes, and a value that helps.
//!
//! Each cause is left out in turn and the assemblies are counted again; the one without which most turn is the largest. A value that is
//! named was tried with all 1000 assemblies.

use super::design::WheelDesign;
use super::mounting::PinKind;
use super::process::{ASSEMBLIES, ENOUGH, SEED};
use super::question::WheelQuestion;
use crate::Error;
use crate::number_format::{as_typed, to_digits};
use geneva_kinematics::wheel::as_built::{Assemblies, ErrorShape, SizeErrors, Yield};
use geneva_workshop::ScrewHole;

/// Assemblies that are counted without each of the causes.
const COUNTED: u64 = 300;
/// Assemblies that are counted before it is looked whether they are enough.
const AT_ONCE: u64 = 100;
/// Tried values over the one of the design, from that on which costs least.
const LESS: [f64; 7] = [0.75, 0.5, 0.35, 0.25, 0.15, 0.1, 0.05];
const MORE: [f64; 6] = [1.2, 1.5, 1.75, 2.0, 2.5, 3.0];
/// Significant digits of a value that is tried.
const DIGITS: usize = 2;

/// What keeps assemblies from turning.
#[derive(Clone, Copy, Debug, PartialEq)]
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

/// A search for why too few assemblies of an external wheel turn, and for a change that helps. It goes on by a few assemblies at each
/// step, so that a page can answer in between.
#[derive(Debug)]
pub struct CauseSearch {
    /// The assemblies of the design itself.
    found: Yield,
    /// Assemblies without each of the causes; the largest cause is first once all are counted.
    causes: Vec<(JamCause, Yield)>,
    /// Changes that are still to be tried, the next one last; none until the causes are sorted.
    changes: Option<Vec<Change>>,
    /// How many changes have been tried.
    tried: usize,
    /// How many of them can't be made.
    refused: usize,
    /// The change that is being tried.
    trial: Option<(Change, WheelDesign, Yield)>,
    /// The changes that help, each in words; all are against the same cause.
    helping: Vec<String>,
}

/// A change that may help.
#[derive(Clone, Debug)]
struct Change {
    /// What it is against.
    cause: JamCause,
    /// Which of the ways against that cause: of each way, the change that costs least is told.
    way: u32,
    /// The change as it is typed, such as `--play 0.3`, and what it replaces.
    words: String,
    /// The question with that change and no other.
    question: WheelQuestion,
}

impl CauseSearch {
    /// A search that has not begun, for a design of which so many assemblies turn; none where enough do, or no process is named.
    ///
    /// # Errors
    ///
    /// A measured play that is not above zero.
    pub fn new(design: &WheelDesign, found: Yield) -> Result<Option<Self>, Error> {
        let Some((sizes, _)) = design.sizes.as_ref().zip(design.process_numbers()?) else { return Ok(None) };
        let is_there = |cause: &JamCause| match cause {
            JamCause::BorePlay => sizes.play.bore > 0.0,
            JamCause::PinScrew => sizes.play.pin > 0.0,
            JamCause::DiscOnPlate => design.disc_turn() > 0.0,
            JamCause::Errors => true,
        };
        let causes = JamCause::ALL.into_iter().filter(is_there).map(|cause| (cause, Yield::default()));
        let search = Self {
            found,
            causes: causes.collect(),
            changes: None,
            tried: 0,
            refused: 0,
            trial: None,
            helping: Vec::new(),
        };
        Ok((found.share() < ENOUGH).then_some(search))
    }

    /// Counts at most so many further assemblies for the same design; the finding in words, once there is one.
    ///
    /// # Errors
    ///
    /// A measured play that is not above zero.
    pub fn step(&mut self, design: &WheelDesign, more: u64) -> Result<Option<String>, Error> {
        if let Some((cause, counted)) = self.causes.iter_mut().find(|(_, counted)| counted.tried < COUNTED) {
            let most = COUNTED.min(counted.tried.saturating_add(more));
            let none = Yield { tried: COUNTED, turning: 0 };
            *counted = match design.assemblies_without(*cause)? {
                Some(assemblies) => assemblies.count(counted.tried..most).map_or(none, |found| counted.plus(found)),
                None => none,
            };
            return Ok(None);
        }
        let changes = match &mut self.changes {
            Some(changes) => changes,
            empty => {
                self.causes.sort_by(|one, other| other.1.share().total_cmp(&one.1.share()));
                // What helps against the largest cause goes before what helps against the next.
                let all: Vec<Change> = self.causes.iter().flat_map(|(cause, _)| design.changes(*cause)).collect();
                empty.insert(all.into_iter().rev().collect())
            }
        };
        let Some((change, trial, counted)) = &mut self.trial else {
            let Some(change) = changes.pop() else {
                return Ok(Some(self.words(design, &self.remedy_words())));
            };
            self.tried += 1;
            let question = WheelQuestion { is_trial: true, ..change.question.clone() };
            let trial = WheelDesign::new(question).ok().filter(|trial| trial.makeable_parts().is_ok());
            self.refused += usize::from(trial.is_none());
            self.trial = trial.map(|trial| (change, trial, Yield::default()));
            return Ok(None);
        };
        let counts = trial.count_assemblies(*counted, more).ok().flatten();
        // Where more fail than may, the rest needs no counting.
        let may_fail = ((1.0 - ENOUGH) * ASSEMBLIES as f64) as u64 + 1;
        match counts.filter(|now| now.tried - now.turning <= may_fail) {
            Some(now) if now.tried < ASSEMBLIES => *counted = now,
            Some(now) if now.share() >= ENOUGH => {
                self.helping.push(format!("with {}, {} do", change.words, percent(now.share())));
                // Another way against the same cause may suit the maker better.
                let (cause, way) = (change.cause, change.way);
                changes.retain(|other| other.cause == cause && other.way != way);
                self.trial = None;
            }
            _ => self.trial = None,
        }
        Ok(None)
    }

    /// What helps, in words.
    fn remedy_words(&self) -> String {
        if !self.helping.is_empty() {
            return self.helping.join(", or ");
        }
        let can_be_made = if self.refused > 0 { " that can be made" } else { "" };
        format!(
            "no one change{can_be_made} is enough: give tighter bores and more --play, or choose a process with smaller errors"
        )
    }

    /// What is counted at the moment, how much of it is done, and how much there is of it at most.
    pub fn progress(&self) -> (&'static str, u64, u64) {
        match &self.changes {
            None => {
                let counted = self.causes.iter().map(|(_, counted)| counted.tried).sum();
                ("assemblies without one of the causes", counted, COUNTED * self.causes.len() as u64)
            }
            Some(left) => ("changes tried that may help", self.tried as u64, (self.tried + left.len()) as u64),
        }
    }

    fn words(&self, design: &WheelDesign, helps: &str) -> String {
        let largest = self.causes.first().map_or_else(String::new, |(cause, counted)| {
            let (cause, share) = (cause.words(design), percent(counted.share()));
            format!("the largest cause is {cause}: without it, {share} would; ")
        });
        format!("only {} of the assemblies turn; {largest}{helps}", percent(self.found.share()))
    }
}

impl WheelDesign {
    /// Why too few assemblies of an external wheel turn, with what helps; none where enough do, or no process is named.
    ///
    /// # Errors
    ///
    /// As for [`count_assemblies`](Self::count_assemblies).
    pub(super) fn yield_cause(&self) -> Result<Option<String>, Error> {
        if self.sizes.is_none() {
            return Ok(None);
        }
        let Some(found) = self.assemblies_that_turn()? else { return Ok(None) };
        let Some(mut search) = CauseSearch::new(self, found)? else { return Ok(None) };
        loop {
            if let Some(words) = search.step(self, AT_ONCE)? {
                return Ok(Some(words));
            }
        }
    }

    /// The assemblies of this design without one of the causes; none without sizes or a process.
    fn assemblies_without(&self, cause: JamCause) -> Result<Option<Assemblies>, Error> {
        let Some((sizes, numbers)) = self.sizes.as_ref().zip(self.process_numbers()?) else { return Ok(None) };
        let unless = |other: JamCause, value: f64| if cause == other { 0.0 } else { value };
        let errors = if cause == JamCause::Errors { SizeErrors::from_greatest(0.0) } else { numbers.errors() };
        let assemblies = Assemblies::new(sizes, errors, ErrorShape::Normal, SEED)
            .with_bore_play(unless(JamCause::BorePlay, sizes.play.bore))
            .with_pin_shift(unless(JamCause::PinScrew, sizes.play.pin))
            .with_disc_turn(unless(JamCause::DiscOnPlate, self.disc_turn()));
        Ok(Some(assemblies))
    }

    /// Changes that may help against a cause, from the one that costs least: each is the question as it was asked, with what the words
    /// say changed.
    fn changes(&self, cause: JamCause) -> Vec<Change> {
        let Some(sizes) = &self.sizes else { return Vec::new() };
        let play = sizes.play;
        let value = |part: f64, length: f64| to_digits(part * length, DIGITS).parse().ok();
        let change = |way: u32, words: String, question: WheelQuestion| Change { cause, way, words, question };
        match cause {
            JamCause::BorePlay => {
                let with = |bore: f64| {
                    let other = WheelQuestion { bore_play: Some(bore), ..self.question.clone() };
                    change(0, format!("--bore-play {}", as_typed(bore)), other)
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
                    change(0, format!("--play {}{also}", as_typed(slot)), other)
                };
                MORE.into_iter().filter_map(|part| value(part, play.slot)).map(with).collect()
            }
            JamCause::PinScrew => {
                let mut tapped = self.question.clone();
                tapped.mounting.pin_screw_hole = Some(ScrewHole::Tapped);
                let mut itself = tapped.clone();
                itself.pin_diameter = self.question.mounting.pin_screw.map(|thread| thread.diameter());
                let diameter = itself.pin_diameter.map_or_else(String::new, as_typed);
                let mut dowel = self.question.clone();
                dowel.mounting.pin_screw = None;
                dowel.mounting.pin_screw_hole = None;
                dowel.mounting.pin_mount = Some(PinKind::Dowel);
                // A dowel is as thick as the bush that it replaces.
                dowel.pin_diameter = Some(sizes.pin_diameter);
                let same = if self.question.pin_diameter.is_some() {
                    String::new()
                } else {
                    format!(" --pin-diameter {}", as_typed(sizes.pin_diameter))
                };
                vec![
                    change(0, "--pin-screw-hole tapped".to_owned(), tapped),
                    change(0, format!("--pin-screw-hole tapped --pin-diameter {diameter}"), itself),
                    change(1, format!("--pin-mount dowel{same} instead of --pin-screw"), dowel),
                ]
            }
            JamCause::DiscOnPlate => {
                let mut one = self.question.clone();
                one.mounting.stacked = Some(false);
                vec![change(0, "--driver-pieces one-piece".to_owned(), one)]
            }
        }
    }
}

fn percent(share: f64) -> String {
    format!("{:.0} %", libm::floor(100.0 * share))
}

#[cfg(test)]
mod tests {
    use super::ENOUGH;
    use crate::wheel::{WheelDesign, WheelQuestion};

    fn cause(question: &str) -> Option<String> {
        let design = WheelDesign::new(WheelQuestion::parse(question).expect(question)).expect(question);
        design.yield_cause().expect(question)
    }

    /// The changes that are said to help: `--play 0.3`.
    fn helping(said: &str) -> Vec<String> {
        let each = said.split("with --").skip(1).filter_map(|rest| rest.split_once(','));
        each.map(|(change, _)| format!("--{change}")).collect()
    }

    /// A question with a change; what it changes is given once.
    fn changed(question: &str, change: &str) -> String {
        let (change, without) = change.split_once(" instead of ").unwrap_or((change, ""));
        let named =
            |text: &str| text.split("--").filter_map(|part| part.split(' ').next()).map(str::to_owned).collect();
        let new: Vec<String> = named(&format!("{change} {without}"));
        let is_kept = |part: &&str| !new.iter().any(|name| !name.is_empty() && part.split(' ').next() == Some(name));
        let kept = question.split("--").filter(|part| !part.is_empty()).filter(is_kept);
        format!("{} {change}", kept.map(|part| format!("--{}", part.trim())).collect::<Vec<_>>().join(" "))
    }

    #[test]
    fn what_helps_is_the_same_however_the_speed_is_given() {
        let wheels = [
            ("--stations 6 --crank-radius 40 --process mill --pin-screw M5", 2),
            ("--stations 6 --crank-radius 40 --process fdm --play 0.3", 1),
        ];
        for (wheel, ways) in wheels {
            let without = cause(wheel).expect(wheel);
            let all = helping(&without);
            assert_eq!(all.len(), ways, "{without}");
            for change in &all {
                let question = changed(wheel, change);
                let design = WheelDesign::new(WheelQuestion::parse(&question).expect(&question)).expect(&question);
                let found = design.assemblies_that_turn().expect("a yield").expect("a process");
                assert!(found.share() >= ENOUGH, "{question}: {}", found.share());
            }
            for speed in ["--rpm 50", "--rad-s 5", "--index-time 0.4", "--dwell-time 0.4"] {
                assert_eq!(cause(&format!("{wheel} {speed}")).as_ref(), Some(&without), "{speed}");
            }
        }
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
            let change = helping(&said).remove(0);
            assert!(change.starts_with(option), "{said}");
            assert_eq!(cause(&changed(&question, &change)), None, "{said}");
        }
        assert_eq!(cause(&format!("{wheel} --bore-play 0.1")), None);
    }
}
