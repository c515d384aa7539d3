//! The formulas in the lines of the chapters hold as the displays do, and misprints in them would not.
//!
//! A formula that equates letters with letters must hold wherever the mechanism of its chapter is, or in the states that its
//! text names. One that gives a letter a number names an instant, and says nothing that holds elsewhere.

use super::book::{entering, states_of};
use super::mechanisms::pin;
use super::{Misprints, escapement};
use geneva_kinematics::indexing::Indexing;
use geneva_kinematics::wheel::Wheel;
use geneva_ledger::tex::{Display, Moment, changed_part, letters_in};
use std::f64::consts::PI;

/// A chapter, a formula of it, and the states that its text names.
type Condition = (&'static str, &'static str, fn(usize) -> Moment);

/// Formulas that hold in the states that the text names.
const UNDER_CONDITIONS: &[Condition] = &[
    ("pin", r"l = \sqrt{2}\,R", of_four),
    ("pin", r"\ddot\varphi = \dot\theta^2/\sqrt{k^2 - 1}", entering),
    ("pin", r"l - R\cos\theta = R\sin|\theta|", entering_four),
    ("pin", r"\cos\theta = 1/k", entering),
    ("pin", r"\sin|\theta| = k - 1/k", entering_four),
    ("pin", r"R = l \sin(180^\circ/N)", |number| {
        let slots = 3 + number % 6;
        pin(number, Some(1.0 / libm::sin(PI / slots as f64)), None).with([("N", slots as f64)])
    }),
    ("pin", r"R = l\sin 30^\circ", of_six),
    ("pin", r"l = 2R", of_six),
    ("escapement", r"\theta = \pi/m", escapement::at_the_hand_over),
    ("escapement", r"\varphi = \pi/N", escapement::at_the_hand_over),
    ("jazar", r"\cos\theta = \sin\alpha", |number| {
        let wheel = Wheel::new(3 + number as u32 % 16).expect("a wheel");
        Moment::default().with([(r"\theta", wheel.engagement_half_angle()), (r"\alpha", wheel.half_pitch_angle())])
    }),
    ("pin", r"r^2 = (5 - 2\sqrt{3})\,R^2", |number| pin(number, Some(2.0), Some(30f64.to_radians()))),
];

/// Formulas that are not evaluated, and why.
const NOT_EVALUATED: &[(&str, &str, &str)] = &[
    ("pin", r"l = OB = \sqrt{2}\,R", TWO_POINTS),
    ("pin", "r = OP", TWO_POINTS),
    ("quick-return", "k = l/R", NO_LETTER),
    ("quick-return", r"a_4^\mathrm{t} = a_2^\mathrm{n}\sin\beta + a_\mathrm{Cor}", "it is of the fast stroke"),
    ("escapement", r"dr/d\theta = l\sin\varphi", "a derivative on one line is not read"),
    ("escapement", r"\dot T = K\dot\theta - \mu\,|F|\,|\dot r|", NO_LETTER),
    ("joints", r"\dot r = -\dot\theta", ENDS),
    ("joints", r"\dot r = \dot\theta", ENDS),
    ("joints", r"b = \mu_b r_b\sqrt{1+\mu^2}", NO_LETTER),
    ("making", r"J_t = \tfrac12 m_t r_t^2", NO_LETTER),
    ("making", r"l = R/\sin\alpha", NO_LETTER),
    ("making", r"\alpha = \pi/N", NO_LETTER),
    ("making", r"b R^4 = J_t/3", NO_LETTER),
    ("program", "y' = f(x, y)", NO_LETTER),
    ("terminal-speed", r"u = u_0/(1 - \lambda)", NO_LETTER),
];

const TWO_POINTS: &str = "two points name a length";
const NO_LETTER: &str = "the states of the chapter have no value for one of its letters";
const ENDS: &str = "it is of an end of the engagement";

fn of_four(number: usize) -> Moment {
    pin(number, Some(2f64.sqrt()), None)
}

fn of_six(number: usize) -> Moment {
    pin(number, Some(2.0), None)
}

fn entering_four(number: usize) -> Moment {
    pin(number, Some(2f64.sqrt()), Some(PI / 4.0))
}

/// The formulas in the lines of a text that equate letters with letters, without a sign of equality that a number follows.
fn relations(text: &str) -> Vec<String> {
    let prose: String = text.split("```").step_by(2).collect();
    // Displays have two signs at either end.
    let lines: String = prose.split("$$").step_by(2).collect();
    let formulas = lines.split('$').skip(1).step_by(2);
    let whole = formulas.map(|tex| tex.split_whitespace().collect::<Vec<_>>().join(" "));
    let relates = |tex: &String| {
        let sides: Vec<&str> = tex.split('=').collect();
        sides.len() > 1 && sides.iter().all(|side| !letters_in(side).is_empty())
    };
    whole.map(|tex| tex.trim_end_matches(['=', ' ']).to_owned()).filter(relates).collect()
}

#[test]
fn every_formula_in_a_line_holds_where_its_text_says() {
    let (mut wrong, mut evaluated, mut misprints) = (Vec::new(), 0, Misprints::default());
    let mut left_over: Vec<_> = UNDER_CONDITIONS.iter().map(|(chapter, tex, _)| (*chapter, *tex)).collect();
    left_over.extend(NOT_EVALUATED.iter().map(|(chapter, tex, _)| (*chapter, *tex)));
    for (path, text) in crate::files("book/src", &[".md"]) {
        let chapter = path.file_stem().expect("a name").to_string_lossy().into_owned();
        for tex in relations(&text) {
            let is = |(of, formula): (&str, &str)| of == chapter && formula == tex;
            left_over.retain(|known| !is(*known));
            if NOT_EVALUATED.iter().any(|(of, formula, _)| is((of, formula))) {
                continue;
            }
            let condition = UNDER_CONDITIONS.iter().find(|(of, formula, _)| is((of, formula)));
            let states = match condition {
                Some((_, _, state)) => Some((0..20).map(*state).collect()),
                None => states_of(&chapter),
            };
            let Some(states) = states else {
                wrong.push(format!("{chapter}: `{tex}`: the chapter has no states"));
                continue;
            };
            let holds = |tex: &str| Display::read(tex).and_then(|display| display.holds(&states));
            match holds(&tex) {
                Ok(true) => evaluated += 1,
                other => wrong.push(format!("{chapter}: `{tex}`: {other:?}")),
            }
            misprints.make(&format!("{chapter}: {tex}"), &tex, |tex| holds(tex).ok());
            // The changed part has the value that it had.
            let same = |(whose, misprint): &(String, geneva_ledger::tex::Misprint)| {
                *whose == format!("{chapter}: {tex}")
                    && changed_part(&tex, &misprint.tex).is_some_and(|part| holds(&part) == Ok(true))
            };
            misprints.survivors.retain(|survivor| !same(survivor));
        }
    }
    println!("{evaluated} formulas hold, {} are not evaluated", NOT_EVALUATED.len());
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    assert!(left_over.is_empty(), "in no chapter: {left_over:?}");
    assert!(evaluated >= 40, "only {evaluated} formulas are evaluated");
    misprints.are_noticed_but_for(&[]);
}
