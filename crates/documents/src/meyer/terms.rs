//! The words on which claims of this source turn.
//!
//! Each word has one meaning, which is the meaning that the source's own words bear best, and one function by which all
//! claims measure it. Where the source leaves two readings equally near, we measure both, and a verdict needs both to
//! agree.

use super::by_steps::{self, Motion};
use super::runs::table::rows;
use geneva_case1973::{Hypothesis, Row};
use geneva_dynamics::steady::{Engagement, MOST_CYCLES};
use std::sync::OnceLock;

/// A word of the source with its meaning.
#[derive(Clone, Copy, Debug)]
pub struct Term {
    /// The word.
    pub word: &'static str,
    /// Characters that tell that a claim speaks of it; none if the word is too common for that.
    pub known_by: &'static [&'static str],
    /// What it means.
    pub meaning: &'static str,
    /// Where the source says so, or where it comes nearest to saying so.
    pub rests_on: &'static str,
    /// The function that measures it, if anything does.
    pub measure: &'static str,
    /// The claims that use it; an id that ends in a star stands for all ids that begin so.
    pub claims: &'static [&'static str],
}

impl Term {
    /// Whether a claim is among those that use the term.
    pub fn is_used_by(&self, id: &str) -> bool {
        self.claims.iter().any(|known| stands_for(known, id))
    }
}

/// Whether an id, or the start of some with a star behind it, stands for this one.
fn stands_for(known: &str, id: &str) -> bool {
    known.strip_suffix('*').map_or(known == id, |start| id.starts_with(start))
}

/// The terms, in the order in which the source first uses them.
pub const TERMS: [Term; 9] = [
    Term {
        word: "terminal velocity",
        known_by: &["terminal velocit"],
        meaning: "the velocity in the motion that repeats itself from engagement to engagement. As one number, it is \
                  the mean of its peak and its minimum",
        rests_on: "introduction, which also calls it steady state; chapter II, paragraph on the rise time, for the \
                   average",
        measure: "terms::Start::by_integrals",
        claims: &[
            "meyer.abstract.terminal",
            "meyer.abstract.fifty",
            "meyer.list-of-figures",
            "meyer.scales",
            "meyer.fig-9",
            "meyer.fig-10",
            "meyer.fig-11",
            "meyer.fig-10.rise-axis",
            "meyer.more-torque",
            "meyer.less-friction",
            "meyer.no-friction",
            "meyer.almost-linear",
            "meyer.conclusion.timing",
            "meyer.conclusion.three",
            "meyer.conclusion.the-three",
            "meyer.page-of-definition",
            "meyer.app-e.*",
        ],
    },
    Term {
        word: "rise time",
        known_by: &["rise time"],
        meaning: "the time from rest until the terminal velocity is reached, to one per cent. The thesis leaves open \
                  which velocity this is, so we allow two measures. By the profile, the velocity at each angle must be \
                  steady from then on. By the average, the average of peak and minimum of an engagement must be steady, \
                  and the time is counted to the end of that engagement",
        rests_on: "introduction, which defines it; axes of Figs. 10 and 11, for the one per cent; chapter II, \
                   paragraph on the rise time, for the steady state velocity profile and for the average",
        measure: "terms::Start::by_integrals",
        claims: &[
            "meyer.abstract.fifty",
            "meyer.list-of-figures",
            "meyer.scales",
            "meyer.fig-8.rise",
            "meyer.first-minimum",
            "meyer.fig-9",
            "meyer.fig-10",
            "meyer.fig-11",
            "meyer.fig-10.rise-axis",
            "meyer.more-torque",
            "meyer.least-rise-time",
            "meyer.less-friction",
            "meyer.small-variations",
            "meyer.not-fast-enough",
            "meyer.app-e.*",
        ],
    },
    Term {
        word: "can be used, or works, as a timing device",
        known_by: &["timing device", "timing application", "timing mechanism"],
        meaning: "started from rest, the mechanism comes to a terminal velocity. We do not ask how accurate it is",
        rests_on: "abstract, which infers the use from the terminal velocity; chapter II, first paragraph",
        measure: "conclusions::settles",
        claims: &["meyer.conclusion.timing", "meyer.conclusion.three", "meyer.always-engaged"],
    },
    Term {
        word: "singularity",
        known_by: &["singularit"],
        meaning: "an angle at which the equation of motion, as it is written, divides by zero",
        rests_on: "chapter I, paragraphs after Eq. (1-18)",
        measure: "singularity::divisors",
        claims: &["meyer.possible-flaw", "meyer.singularity.*"],
    },
    Term {
        word: "any of the three mechanisms",
        known_by: &["any of the three mechanisms"],
        meaning: "what the thesis says of the curves of Fig. 8, it says of all runs",
        rests_on: "chapter II, sentence after Fig. 8",
        measure: "table::rows",
        claims: &[
            "meyer.shape",
            "meyer.scales",
            "meyer.first-minimum",
            "meyer.peaks-at-*",
            "meyer.still-at-entry",
            "meyer.driver-slows",
            "meyer.driver-increases",
            "meyer.extremes-on-centres",
            "meyer.follower-decreases",
        ],
    },
    Term {
        word: "is a maximum, is a minimum, coincides, has achieved, slows down, increases, decreases, shape, significant \
               (of speeds on the curves)",
        known_by: &["the unit of the tables"],
        meaning: "speeds on the curves of the driver and the follower are compared to one unit of the tables, 1 rad/s. A \
                  speed is a maximum, a minimum or steady if it differs from that speed by no more than this unit. A \
                  member slows down, or its speed decreases, if the speed never rises by more than one such unit above \
                  its lowest value so far",
        rests_on: "Appendix E, whose speeds have no decimals",
        measure: "terms::is_there",
        claims: &[
            "meyer.shape",
            "meyer.first-minimum",
            "meyer.peaks-at-*",
            "meyer.driver-slows",
            "meyer.driver-increases",
            "meyer.extremes-on-centres",
            "meyer.follower-decreases",
            "meyer.cyclic-oscillations",
        ],
    },
    Term {
        word: "lower, greater, fast enough, as much as (of rise times and terminal velocities)",
        known_by: &[],
        meaning: "sentences that compare the rise times or terminal velocities of the runs, or set them a limit, are \
                  judged against the rows of Appendix E and against the mechanisms themselves. A sentence is right or \
                  wrong only if the two agree, or if one of them cannot decide. Otherwise it is open",
        rests_on: "chapter II, which makes its general statements about the graphs, and draws conclusions on the \
                   mechanisms from them",
        measure: "",
        claims: &[
            "meyer.abstract.fifty",
            "meyer.more-torque",
            "meyer.least-rise-time",
            "meyer.less-friction",
            "meyer.almost-linear",
            "meyer.not-fast-enough",
        ],
    },
    Term {
        word: "almost",
        known_by: &["almost"],
        meaning: "a straight line misses each velocity by less than a twentieth. The source does not define the word",
        rests_on: "no place in the thesis, because the measure is ours. Any measure from 3 to 16 per cent gives the \
                   same verdict",
        measure: "general_statements::straight",
        claims: &["meyer.almost-linear"],
    },
    Term {
        word: "seriously, small",
        known_by: &["seriously"],
        meaning: "left open, because the source has no measure of it and the obvious measures disagree",
        rests_on: "Conclusion 2",
        measure: "",
        claims: &["meyer.small-variations"],
    },
];

/// The part of the terminal velocity that may be missing at the end of the rise.
///
/// The axes of Figs. 10 and 11 have 99 per cent of that velocity.
pub const MISSING: f64 = 0.01;

/// A start from rest, as the terms measure it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Start {
    /// The average terminal velocity, in rad/s: the mean of peak and minimum of the steady motion.
    pub velocity: f64,
    /// The rise times in s, each to one per cent.
    ///
    /// The first lasts until the velocity is the steady velocity at each angle, and the second until the average of
    /// peak and minimum of an engagement is the steady average.
    pub rise_times: [f64; 2],
}

impl Start {
    /// The start, by the solution over the angle.
    pub fn by_integrals(of: &Engagement) -> Option<Self> {
        Self::by_integrals_to(of, MISSING)
    }

    /// The start by the solution over the angle, with another part of the velocity that may be missing.
    pub fn by_integrals_to(of: &Engagement, missing: f64) -> Option<Self> {
        let velocity = of.steady_state().ok()?.mean_of_extremes();
        let average = of.until_average_in(missing, MOST_CYCLES).ok()?;
        Some(Self { velocity, rise_times: [of.until_profile(missing).ok()?, average] })
    }

    /// The start, by equal steps of the angle.
    pub fn by_steps(motion: &Motion) -> Option<Self> {
        let steady = motion.steady()?;
        let average = |of: &by_steps::Engagement| {
            let peak = motion.greatest(of, |_, speed| speed).value;
            Some(f64::midpoint(peak, motion.least(of)?.value))
        };
        let velocity = average(steady)?;
        let is_it = |of: &&by_steps::Engagement| average(of).is_some_and(|average| is_near(average, velocity, MISSING));
        Some(Self { velocity, rise_times: [last_departure(motion)?, motion.engagements.iter().find(is_it)?.finish()] })
    }
}

/// Whether a velocity is the steady one but for a part that may be missing.
fn is_near(velocity: f64, steady: f64, missing: f64) -> bool {
    (velocity / steady - 1.0).abs() <= missing
}

/// The time at which a motion in steps last departs by one per cent from the steady speed at the same angle.
fn last_departure(motion: &Motion) -> Option<f64> {
    let steady = &motion.steady()?.squares;
    for engagement in motion.engagements.iter().rev() {
        let off = |k: usize| ((engagement.squares[k] / steady[k]).sqrt() - 1.0).abs();
        let Some(last) = (0..steady.len()).rev().find(|k| off(*k) > MISSING) else { continue };
        let times = &engagement.times;
        if last + 1 == times.len() {
            return times.last().copied();
        }
        let share = (off(last) - MISSING) / (off(last) - off(last + 1));
        return Some(times[last] + share * (times[last + 1] - times[last]));
    }
    None
}

/// The starts of all rows by the solution over the angle, for the mechanisms as they are.
pub fn starts() -> &'static [(&'static Row, Start)] {
    static STARTS: OnceLock<Vec<(&Row, Start)>> = OnceLock::new();
    let of = |row| Some((row, Start::by_integrals(&Hypothesis::IDEAL.engagement(row)?)?));
    STARTS.get_or_init(|| rows().iter().filter_map(of).collect())
}

/// Whether a speed, in rad/s, is at the place of an extreme from which it differs by so much: to one unit of the tables'
/// speeds, which have no decimals.
pub fn is_there(departure: f64) -> bool {
    departure.abs() <= 1.0
}

#[cfg(test)]
mod tests {
    use super::super::by_steps::groups;
    use super::*;
    use crate::MEYER;
    use geneva_evidence::Check;
    use geneva_evidence::Evidence;

    /// What a claim says, all in one.
    fn text(claim: &geneva_evidence::Claim) -> String {
        let neighbour = match &claim.check {
            Check::Statement { neighbour, .. } => neighbour.unwrap_or_default(),
            Check::Missing { reason } => reason,
            _ => "",
        };
        let corrected = claim.erratum.map_or("", |erratum| erratum.corrected);
        [claim.printed, claim.meaning, claim.reading.unwrap_or_default(), neighbour, corrected].join(" ").to_lowercase()
    }

    #[test]
    fn a_claim_that_uses_a_term_is_listed_and_each_that_is_listed_exists() {
        let own: Vec<_> = MEYER.claims().iter().collect();
        for term in &TERMS {
            let speaks = |claim: &&&geneva_evidence::Claim| term.known_by.iter().any(|word| text(claim).contains(word));
            let unlisted = own.iter().filter(speaks).filter(|claim| !term.is_used_by(claim.id));
            let unlisted: Vec<_> = unlisted.map(|claim| claim.id).collect();
            assert!(unlisted.is_empty(), "not listed, but they speak of “{}”: {}", term.word, unlisted.join(", "));
            for known in term.claims {
                let exists = own.iter().any(|claim| stands_for(known, claim.id));
                assert!(exists, "{}: no claim {known}", term.word);
            }
        }
    }

    /// The term with this in its word.
    fn term(word: &str) -> &'static Term {
        TERMS.iter().find(|term| term.word.contains(word)).expect("a term")
    }

    #[test]
    fn all_claims_on_a_speed_of_the_curves_state_one_tolerance() {
        let own = MEYER.claims().iter().filter(|claim| term("coincides").is_used_by(claim.id));
        for claim in own {
            let reading = claim.reading.expect("a reading");
            assert!(reading.contains("1 rad/s"), "{}: {reading}", claim.id);
        }
    }

    #[test]
    fn a_sentence_on_the_runs_is_judged_against_tables_and_mechanisms_or_is_open() {
        for claim in MEYER.claims().iter().filter(|claim| term("fast enough").is_used_by(claim.id)) {
            let evidence = claim.check.evidence();
            let (tables, mechanisms) = (
                evidence.contains(&Evidence::OTHER_PLACE_IN_SOURCE),
                evidence.iter().any(|evidence| *evidence != Evidence::OTHER_PLACE_IN_SOURCE),
            );
            let open = matches!(claim.check, Check::Missing { .. });
            // The torques of the tables end where this sentence begins.
            let beyond = claim.id == "meyer.least-rise-time";
            assert!(open || mechanisms && tables != beyond, "{}: {evidence:?}", claim.id);
        }
    }

    #[test]
    fn the_function_that_measures_a_term_exists() {
        let root = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
        let (mut folders, mut sources) = (vec![root.clone()], Vec::new());
        while let Some(folder) = folders.pop() {
            for entry in std::fs::read_dir(folder).expect("a folder") {
                let path = entry.expect("readable").path();
                if path.is_dir() {
                    folders.push(path);
                } else if path.extension().is_some_and(|ending| ending == "rs") {
                    let text = std::fs::read_to_string(&path).expect("readable");
                    let place = path.strip_prefix(&root).expect("below it").with_extension("");
                    sources.push((place, text.split("#[cfg(test)]").next().unwrap_or_default().to_owned()));
                }
            }
        }
        let exists = |measure: &str| {
            let (module, rest) = measure.split_once("::").expect("a module");
            let name = rest.rsplit("::").next().expect("a name");
            let of_type = rest.split_once("::").map(|(of, _)| format!("impl {of} {{"));
            sources.iter().any(|(place, text)| {
                place.iter().any(|part| part == module)
                    && text.contains(&format!("fn {name}("))
                    && of_type.as_ref().is_none_or(|of| text.contains(of))
            })
        };
        for term in TERMS.iter().filter(|term| !term.measure.is_empty()) {
            assert!(exists(term.measure), "{}: there is no {}", term.word, term.measure);
        }
        assert!(!exists("terms::Start::by_guess") && !exists("terms::Motion::by_integrals"));
    }

    #[test]
    fn claims_measure_a_term_by_its_function_and_by_nothing_else() {
        // What would measure a rise or an average terminal velocity otherwise, and the files whose question it is: which
        // run Fig. 8 shows, the minimum of which the text speaks, and what a run is read off as.
        let elsewhere = [
            ("until_", &["terms.rs"][..]),
            ("first_minimum", &["terms.rs", "choice.rs", "profile.rs", "cells.rs", "statistics.rs"]),
            ("mean_of_extremes", &["terms.rs"]),
            (".mean_speed", &[]),
            ("engagements_to_settle", &[]),
        ];
        let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("src/meyer");
        for folder in [folder.clone(), folder.join("runs")] {
            for entry in std::fs::read_dir(folder).expect("a folder") {
                let path = entry.expect("readable").path();
                let Some(name) = path.file_name().and_then(|name| name.to_str()).filter(|name| name.ends_with(".rs"))
                else {
                    continue;
                };
                let text = std::fs::read_to_string(&path).expect("readable");
                let code = text.split("#[cfg(test)]").next().unwrap_or_default();
                let code: Vec<_> = code.lines().filter(|line| !line.trim_start().starts_with("//")).collect();
                for (call, allowed) in elsewhere {
                    let calls = code.iter().any(|line| line.contains(call));
                    assert!(!calls || allowed.contains(&name), "{name} calls {call}: measure the term by terms.rs");
                }
            }
        }
    }

    #[test]
    fn both_routes_give_the_same_rise_times_and_velocities() {
        assert_eq!(starts().len(), rows().len());
        for group in groups() {
            let row = &group.rows[0];
            let solved = starts().iter().find(|(other, _)| *other == row).expect("a start").1;
            let stepped = Start::by_steps(&group.motion).expect("a start");
            let pairs = [
                (solved.velocity, stepped.velocity),
                (solved.rise_times[0], stepped.rise_times[0]),
                (solved.rise_times[1], stepped.rise_times[1]),
            ];
            for (a, b) in pairs {
                assert!((a / b - 1.0).abs() < 1e-4, "{}: {solved:?} {stepped:?}", row.slug());
            }
        }
    }

    #[test]
    fn no_verdict_on_a_rise_time_hangs_on_which_of_the_readings_is_taken() {
        // The abstract's fifty milliseconds are too few by both, and the recommendation's are too many by both.
        for reading in [0, 1] {
            let times = || starts().iter().map(|(_, start)| start.rise_times[reading]);
            assert!(times().fold(0.0, f64::max) > 0.0505 && times().all(|time| time > 0.01), "{reading}");
        }
    }
}
