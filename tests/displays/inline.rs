//! The formulas in the lines of the chapters hold as the displays do, and misprints in them would not.
//!
//! A formula that relates letters must hold wherever the mechanism of its chapter is, or in the states that its text names. One
//! that only gives a letter a number names an instant, and says nothing that holds elsewhere; but numbers that it equates with
//! each other must be equal. One that relates nothing is put where it belongs, by [`super::expressions`].

use super::book::{entering, states_of};
use super::mechanisms::pin;
use super::{Misprints, escapement};
use geneva_evidence::tex::{Class, Display, Moment, changed_part, letters_in, name, value_at};
use geneva_kinematics::indexing::Indexing;
use geneva_kinematics::wheel::Wheel;
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
    ("jazar", r"\cos\theta = \sin\alpha", |number| at_the_wheel(number, Wheel::engagement_half_angle)),
    ("making", r"\tfrac12 + \tfrac1N = \tfrac23", |_| Moment::default().with([("N", 6.0)])),
    ("pin", r"r^2 = (5 - 2\sqrt{3})\,R^2", |number| pin(number, Some(2.0), Some(30f64.to_radians()))),
    ("pin", r"\cos\theta = \tfrac12\sqrt{3}", |number| pin(number, None, Some(30f64.to_radians()))),
    ("pin", r"\cos\theta = 1", |number| pin(number, None, Some(0.0))),
    ("pin", r"k\cos\theta = 1", entering),
    ("pin", r"\dot\varphi/\dot\theta = (1 + \sqrt{3})/2", |number| {
        pin(number, Some(2f64.sqrt()), Some(15f64.to_radians()))
    }),
    ("pin", r"\cos\theta = \tfrac12", |number| pin(number, Some(2.0), Some(60f64.to_radians()))),
    ("pin", r"\dot\varphi/\dot\theta = (\sqrt{3} - 1)/(5 - 2\sqrt{3})", |number| {
        pin(number, Some(2.0), Some(30f64.to_radians()))
    }),
    ("pin", r"1/(k-1) = 1", of_six),
    ("jazar", r"\cos\theta = 1", |number| at_the_wheel(number, |_| 0.0)),
    ("jazar", r"k\cos\theta = 1", |number| at_the_wheel(number, Wheel::engagement_half_angle)),
];

/// Formulas that are not evaluated, and why.
const NOT_EVALUATED: &[(&str, &str, &str)] = &[
    ("pin", r"l = OB = \sqrt{2}\,R", TWO_POINTS),
    ("pin", "r = OP", TWO_POINTS),
    ("quick-return", r"a_4^\mathrm{t} = a_2^\mathrm{n}\sin\beta + a_\mathrm{Cor}", "it is of the fast stroke"),
    ("escapement", r"dr/d\theta = l\sin\varphi", "a derivative on one line is not read"),
    ("escapement", r"\dot T = K\dot\theta - \mu\,|F|\,|\dot r|", NO_LETTER),
    ("joints", r"\dot r = -\dot\theta", ENDS),
    ("joints", r"\dot r = \dot\theta", ENDS),
    ("joints", r"b = \mu_b r_b\sqrt{1+\mu^2}", NO_LETTER),
    ("making", r"J_t = \tfrac12 m_t r_t^2", NO_LETTER),
    ("making", r"l = R/\sin\alpha", NO_LETTER),
    ("making", r"\alpha = \pi/N", NO_LETTER),
    ("program", "y' = f(x, y)", NO_LETTER),
    ("terminal-speed", r"u = u_0/(1 - \lambda)", NO_LETTER),
    ("terminal-speed", r"\lambda < 1", NO_LETTER),
    ("found", "43.4 - 29.8 = 13.8", "it is a misprint that the page quotes"),
    ("runs", r"e \approx 2.7", "it says what a letter stands for, to two digits"),
    ("runs", r"P = \int_{x - u/2}^{x + u/2} f_s(t - y)\, dt", "an integral is not read"),
    ("runs", r"\ln L = \sum_{\text{columns}} \max_s \sum_{\text{cells}} \ln P", "a sum over cells is not read"),
];

/// Relations that fail in every state of the chapter, as the text says of other states; each once.
const REFUTED: &[(&str, &str)] = &[("escapement", "A < |D|"), ("joints", r"\mu\rho + b_f \ge k - 1")];

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

/// A wheel with its driver at an angle, for letters that need no speed.
fn at_the_wheel(number: usize, angle: fn(&Wheel) -> f64) -> Moment {
    let wheel = Wheel::new(3 + number as u32 % 16).expect("a wheel");
    Moment::default()
        .with([(r"\theta", angle(&wheel)), (r"\alpha", wheel.half_pitch_angle())])
        .with([("k", wheel.centre_distance_ratio())])
}

/// The formulas in the lines of a text, with single blanks, degrees as TeX writes them, and no sign of equality that a number
/// follows.
pub(super) fn formulas(text: &str) -> Vec<String> {
    let prose: String = text.split("```").step_by(2).collect();
    // Displays have two signs at either end.
    let lines: String = prose.split("$$").step_by(2).collect();
    let formulas = lines.split('$').skip(1).step_by(2);
    let whole = formulas.map(|tex| tex.split_whitespace().collect::<Vec<_>>().join(" ").replace('°', r"^\circ"));
    whole.map(|tex| tex.trim_end_matches(['=', ' ']).to_owned()).collect()
}

/// How the sides of an inequality must compare.
type Compares = fn(&f64, &f64) -> bool;

const COMPARISONS: [(&str, Compares); 4] = [(">", f64::gt), ("<", f64::lt), (r"\ge ", f64::ge), (r"\le ", f64::le)];

/// The two sides of an inequality, and how they must compare.
fn inequality(tex: &str) -> Option<([&str; 2], Compares)> {
    COMPARISONS.iter().find_map(|(sign, compares)| {
        let (left, right) = tex.split_once(sign)?;
        Some(([left, right], *compares))
    })
}

/// Whether a formula relates anything: by a sign that stands between two sides.
pub(super) fn relates(tex: &str) -> bool {
    ["=", r"\approx"].iter().any(|sign| tex.contains(sign)) || inequality(tex).is_some()
}

/// Whether a formula of the lines holds in these states; why not, if it cannot be read.
fn holds_in(tex: &str, states: &[Moment]) -> Result<bool, String> {
    let Some((sides, compares)) = inequality(tex) else {
        return Display::read(tex).and_then(|display| display.holds(states)).map_err(|error| error.to_string());
    };
    let compared: Vec<[f64; 2]> = states.iter().map(|state| sides.map(|side| value_at(side, state))).collect();
    if compared.iter().flatten().any(|number| number.is_nan()) {
        return Err("a side has no value".to_owned());
    }
    Ok(compared.iter().all(|[left, right]| compares(left, right)))
}

/// The numbers that a formula equates, if that is all it does but for giving them to a name.
fn numbers_in(tex: &str) -> Option<&str> {
    let (first, numbers) = tex.split_once('=')?;
    let are_numbers = |tex: &str| Display::read(tex).is_ok() && letters_in(tex).is_empty();
    match name(first) {
        Ok(_) => numbers.split('=').all(are_numbers).then_some(numbers),
        Err(_) => tex.split('=').all(are_numbers).then_some(tex),
    }
}

#[test]
fn every_formula_in_a_line_holds_where_its_text_says() {
    let (mut wrong, mut evaluated, mut misprints) = (Vec::new(), 0, Misprints::default());
    let mut left_over: Vec<_> = UNDER_CONDITIONS.iter().map(|(chapter, tex, _)| (*chapter, *tex)).collect();
    left_over.extend(NOT_EVALUATED.iter().map(|(chapter, tex, _)| (*chapter, *tex)));
    let mut refuted = REFUTED.to_vec();
    for (path, text) in crate::texts() {
        let chapter = path.file_stem().expect("a name").to_string_lossy().into_owned();
        for tex in formulas(&text).into_iter().filter(|tex| relates(tex)) {
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
            if let Some(numbers) = condition.is_none().then(|| numbers_in(&tex)).flatten() {
                if numbers.contains('=') && holds_in(numbers, &[Moment::default()]) != Ok(true) {
                    wrong.push(format!("{chapter}: `{tex}`: its numbers are not equal"));
                }
                continue;
            }
            let Some(states) = states else {
                wrong.push(format!("{chapter}: `{tex}`: the chapter has no states"));
                continue;
            };
            if let Some(at) = refuted.iter().position(|known| is(*known)) {
                refuted.swap_remove(at);
                // In no state, not only not in all.
                let fails = |state: &Moment| holds_in(&tex, std::slice::from_ref(state)) == Ok(false);
                if !states.iter().all(fails) {
                    wrong.push(format!("{chapter}: `{tex}`: it holds in some state"));
                }
                continue;
            }
            match holds_in(&tex, &states) {
                Ok(true) => evaluated += 1,
                other => wrong.push(format!("{chapter}: `{tex}`: {other:?}")),
            }
            misprints.make(&format!("{chapter}: {tex}"), &tex, |tex| holds_in(tex, &states).ok());
            // The changed part has the value that it had, or an inequality says less than it could.
            let same = |(whose, misprint): &(String, geneva_evidence::tex::Misprint)| {
                let is_equal = |part: String| holds_in(&part, &states) == Ok(true);
                *whose == format!("{chapter}: {tex}")
                    && (changed_part(&tex, &misprint.tex).is_some_and(is_equal)
                        || (inequality(&tex).is_some() && misprint.class != Class::Relation))
            };
            misprints.survivors.retain(|survivor| !same(survivor));
        }
    }
    println!("{evaluated} formulas hold, {} are not evaluated", NOT_EVALUATED.len());
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    assert!(left_over.is_empty() && refuted.is_empty(), "in no chapter: {left_over:?} {refuted:?}");
    assert!(evaluated >= 40, "only {evaluated} formulas are evaluated");
    misprints.are_noticed_but_for(&[]);
}
