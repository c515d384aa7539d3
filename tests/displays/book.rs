//! The displays of the chapters hold, and misprints in them would not.

use super::mechanisms::{When, making, pin, quick_return, step, wheel};
use super::{Harmless, Misprints, escapement, joints};
use geneva_evidence::tex::{Display, Moment, value_at};

/// Misprints that no state of motion shows.
const HARMLESS: &Harmless = &[
    (
        r"quick-return: \vec{a}_2^\mathrm{n} +",
        "the term behind the sign is zero in a straight slot",
        &["piece 47: + becomes -"],
    ),
    (r"pin: (k^2 - 1)(k^2 - 2) = 0", "zero has no sign", &["piece 0: a minus is put before it"]),
];

/// A display's chapter, how it starts, and the states in which it holds.
type Condition = (&'static str, &'static str, fn(usize) -> Moment);

/// Displays that hold under a condition that the text before them states.
const UNDER_CONDITIONS: &[Condition] = &[
    // At entry, where the pin moves along the slot.
    ("pin", r"l \cos\theta = R", entering),
    // The four roots of the quartic.
    ("pin", r"(k^2 - 1)(k^2 - 2) = 0", |number| {
        Moment::default().with([("k", [1.0, -1.0, 2f64.sqrt(), -(2f64.sqrt())][number % 4])])
    }),
    // Four stations at a third of a right angle from the line of centres, and on it.
    ("pin", r"\frac{\dot\varphi}{\dot\theta} = \frac{\tfrac12", at_the_instant),
    ("pin", r"\frac{\ddot\varphi}{\dot\theta^2} = \frac{\tfrac12", at_the_instant),
    ("pin", r"\frac{\dot\varphi}{\dot\theta} = \frac{k - 1}{(k-1)^2}", |number| {
        pin(number, Some(2f64.sqrt()), Some(0.0))
    }),
    // With an acceleration of the crank, which the other displays do without.
    ("quick-return", r"\vec{a}_2^\mathrm{n} +", |number| quick_return(number, 1.5)),
    ("jazar", r"\cos^2\theta + \gamma\cos\theta", |number| wheel(number, None, When::AtPeak)),
    // Any numbers of pins and slots, as one pin takes over from the next.
    ("escapement", r"k = \frac{\sin(\pi/m + \pi/N)}", escapement::taking_over),
    ("escapement", r"\frac{\dot\varphi}{\dot\theta} = \cos", escapement::taking_over),
];

pub(super) fn entering(number: usize) -> Moment {
    let ratio = 1.0 + 3.0 * super::spread(number, 4);
    pin(number, Some(ratio), Some(libm::acos(1.0 / ratio)))
}

fn at_the_instant(number: usize) -> Moment {
    pin(number, Some(2f64.sqrt()), Some(30f64.to_radians()))
}

/// One display of a chapter, and the states in which it must hold.
struct Printed {
    chapter: String,
    tex: String,
    states: Vec<Moment>,
}

impl Printed {
    fn starts(&self, chapter: &str, start: &str) -> bool {
        self.chapter == chapter && self.tex.starts_with(start)
    }
}

/// The states in which what a chapter says of its mechanism must hold; none for a chapter without one.
pub(super) fn states_of(chapter: &str) -> Option<Vec<Moment>> {
    let many = |state: fn(usize) -> Moment| Some((0..40).map(state).collect());
    match chapter {
        "pin" => many(|number| pin(number, None, None)),
        "quick-return" => many(|number| quick_return(number, 0.0)),
        "jazar" | "glossary" => many(|number| wheel(number, None, When::Steady)),
        "making" => many(making),
        "program" => many(step),
        "escapement" => Some(escapement::states()),
        "terminal-speed" | "solver" => Some(escapement::over_the_angle()),
        "joints" => Some(joints::states()),
        _ => None,
    }
}

/// All displays of the book.
fn displays() -> Vec<Printed> {
    let mut found = Vec::new();
    for (path, text) in crate::texts() {
        let chapter = path.file_stem().expect("a name").to_string_lossy().into_owned();
        // Between fences is code. Whether Markdown sees the same displays, the press tells.
        let prose: String = text.split("```").step_by(2).collect();
        assert!(prose.matches("$$").count().is_multiple_of(2), "{chapter}: a display has no end");
        for tex in prose.split("$$").skip(1).step_by(2) {
            let mut display = Printed { chapter: chapter.clone(), tex: tex.trim().to_owned(), states: Vec::new() };
            let condition = UNDER_CONDITIONS.iter().find(|(chapter, start, _)| display.starts(chapter, start));
            display.states = match condition {
                Some((_, _, state)) => (0..40).map(*state).collect(),
                None => states_of(&chapter)
                    .unwrap_or_else(|| panic!("{chapter}: say here what the letters of `{}` stand for", display.tex)),
            };
            found.push(display);
        }
    }
    found
}

#[test]
fn every_display_holds_wherever_the_mechanism_is() {
    let mut wrong = Vec::new();
    let (mut evaluated, mut tags) = (0, Vec::new());
    for printed in displays() {
        let display = Display::read(&printed.tex);
        match display.as_ref().map(|display| display.holds(&printed.states)) {
            Ok(Ok(true)) => evaluated += 1,
            other => wrong.push(format!("{}: `{}`: {other:?}", printed.chapter, printed.tex)),
        }
        tags.extend(display.ok().and_then(|display| display.tag));
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    println!("{evaluated} displays hold, {} by number: {}", tags.len(), tags.join(", "));
    assert!(evaluated >= 38, "only {evaluated} displays are evaluated");
    let numbers = ["1-2", "1-3", "1-6", "1-7", "1-8", "1-13", "1-14", "1-16", "1-17", "1-18", "1-19"];
    assert!(numbers.iter().all(|number| tags.iter().any(|tag| tag == number)), "{tags:?}");
}

/// The book's letters, called as in the thesis.
const OF_THE_THESIS: [(&str, &str); 9] = [
    ("a", "k"),
    ("c", "l"),
    ("n", "N"),
    ("r", "R"),
    ("R", "r"),
    ("N", "F"),
    (r"\phi", r"\varphi"),
    (r"\ddot\phi", r"\ddot\varphi"),
    (r"\phi_0", r"\varphi_0"),
];

#[test]
fn a_display_with_a_number_is_the_equation_with_this_number() {
    let first_side =
        |tex: &str| tex.split('=').next().unwrap_or_default().replace(r"\begin{aligned}", "").replace('&', "");
    let mut wrong = Vec::new();
    for printed in displays() {
        let Some(tag) = Display::read(&printed.tex).ok().and_then(|display| display.tag) else { continue };
        let ids: Vec<String> = match tag.as_str() {
            // Of its lines, the chapter has the third.
            "1-3" => vec!["meyer.angle-sum".to_owned()],
            tag => ["", ".first-line", ".second-line"].map(|line| format!("meyer.eq-{tag}{line}")).into(),
        };
        let lines: Vec<&str> = ids
            .iter()
            .filter_map(|id| geneva_documents::LEDGER.claim(id))
            .map(|claim| claim.right_characters())
            .collect();
        let [ours, theirs] = [&printed.tex, &lines.join(" ")].map(|tex| first_side(tex));
        let same = |state: &Moment| {
            let there = state.clone().called(OF_THE_THESIS);
            let [ours, theirs] = [value_at(&ours, state), value_at(&theirs, &there)];
            (ours - theirs).abs() <= 1e-9 * ours.abs().max(1.0)
        };
        if !printed.states.iter().all(same) {
            wrong.push(format!("{}: ({tag}) is about `{theirs}`, not `{ours}`", printed.chapter));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn no_condition_is_left_over() {
    let displays = displays();
    for (chapter, start, _) in UNDER_CONDITIONS {
        let of = displays.iter().filter(|printed| printed.starts(chapter, start)).count();
        assert_eq!(of, 1, "{chapter}: so many displays start with {start}");
    }
}

#[test]
fn a_misprint_would_be_noticed() {
    let mut misprints = Misprints::default();
    for Printed { chapter, tex, states } in displays() {
        let holds = |tex: &str| Display::read(tex).and_then(|display| display.holds(&states)).ok();
        misprints.make(&format!("{chapter}: {tex}"), &tex, holds);
    }
    misprints.are_noticed_but_for(HARMLESS);
}
