//! What proofreading found: the texts of the first contact, and the misprints that still stand in a textbook.

use crate::found::{Answer, Contact, Judgement, Run, contacts, flags, runs, unit_flags};
use crate::html::{Cells, Table, escape, table};
use geneva_figures::with_minus_sign;

/// The texts that nobody had looked at, with what became of their flags: the third and fourth round by text, the others in one row each.
pub fn texts() -> anyhow::Result<Table> {
    let contacts = contacts()?;
    let runs = runs()?;
    let row = |name: String, round: &str, format: &str, of: &[&Run]| {
        let such = |flag: &&Contact| flag.round == round && of.iter().any(|run| run.text == flag.text);
        let count = |judgement| contacts.iter().filter(such).filter(|flag| flag.judgement == judgement).count();
        let sum = |what: fn(&Run) -> u32| of.iter().map(|run| what(run)).sum::<u32>();
        vec![
            escape(&name),
            escape(format),
            format!("{} of {}", sum(|run| run.checked), sum(|run| run.checkable)),
            sum(|run| run.flags).to_string(),
            count(Judgement::Real).to_string(),
            (count(Judgement::Rounding) + count(Judgement::Convention)).to_string(),
            count(Judgement::Ours).to_string(),
        ]
    };
    let of_round = |name: &str| runs.iter().filter(|run| run.run == name).collect::<Vec<&Run>>();
    let mut rows = Vec::new();
    for (name, words) in [("first", "First round"), ("second", "Second round")] {
        let of = of_round(name);
        rows.push(row(format!("{words}, {} texts", of.len()), name, "several", &of));
    }
    for name in ["third", "fourth"] {
        let (with, without): (Vec<&Run>, Vec<&Run>) = of_round(name).into_iter().partition(|run| run.flags > 0);
        rows.extend(with.iter().map(|run| row(run.text.clone(), name, &run.format, &[run])));
        rows.push(row(format!("{} more texts of the {name} round", without.len()), name, "several", &without));
    }
    rows.extend(of_round("fifth").iter().map(|run| row(run.text.clone(), "fifth", &run.format, &[run])));
    table(
        "Texts that we had not looked at before, those from the third round on in the order in which they were run, and all flags on a \
         number",
        Cells::NamedNumbers,
        &["Text", "Format", "Chains checked", "Flags", "Real errors", "Rounding, convention", "Misread"],
        rows.into_iter().map(Ok).collect::<Vec<_>>(),
    )
}

/// The misprints on a number that still stand in the newest state.
pub fn misprints() -> anyhow::Result<Table> {
    let rows = flags()?
        .into_iter()
        .filter(|flag| flag.judgement == Judgement::Real && flag.printed_new == Answer::Yes)
        .map(|flag| {
            let or_none = |text: &str| if text.is_empty() { "–".to_owned() } else { chain(text) };
            Ok(vec![
                place(&flag.module, &flag.element),
                chain(&flag.chain),
                or_none(&flag.recomputed),
                or_none(flag.hint.replace('`', "").as_str()),
                chain(&flag.why),
            ])
        });
    table(
        "Numbers in University Physics, newest state, that don't follow from what is printed beside them",
        Cells::Words,
        &["Module, element", "Printed", "Recomputed", "Hint of the program", "Our reading"],
        rows,
    )
}

/// The misprints on a unit that still stand in the newest state.
pub fn units() -> anyhow::Result<Table> {
    let rows = unit_flags()?
        .into_iter()
        .filter(|flag| flag.judgement == Judgement::Real)
        .map(|flag| Ok(vec![place(&flag.module, &flag.element), chain(&flag.chain), chain(&flag.why)]));
    table(
        "Places in University Physics, newest state, where the number is right and the unit or an exponent isn't",
        Cells::Words,
        &["Module, element", "Printed", "Our reading"],
        rows,
    )
}

fn place(module: &str, element: &str) -> String {
    format!("<code>{}</code> <small>{}</small>", escape(module), escape(element))
}

/// A chain in HTML: powers are raised, and `1e-3` is written as a power of ten.
fn chain(text: &str) -> String {
    let mut out = String::new();
    let mut rest = text;
    while let Some(at) = rest.find(['^', 'e']) {
        let (before, sign) = rest.split_at(at);
        out.push_str(&escape(before));
        let power = &sign[1..];
        let length = power_length(power);
        let is_exponent = before.ends_with(|c: char| c.is_ascii_digit()) && length > 0;
        if sign.starts_with('^') && length > 0 {
            out.push_str(&format!("<sup>{}</sup>", escape(power[..length].trim_matches(['(', ')']))));
            rest = &power[length..];
        } else if sign.starts_with('e') && is_exponent {
            out.push_str(&format!(" × 10<sup>{}</sup>", with_minus_sign(&power[..length])));
            rest = &power[length..];
        } else {
            out.push_str(&sign[..1]);
            rest = power;
        }
    }
    out + &escape(rest)
}

/// How many bytes of the text are an exponent: a number with its sign, or a fraction in brackets.
fn power_length(text: &str) -> usize {
    if text.starts_with('(') {
        let end = text.find(')').map_or(0, |at| at + 1);
        let inside = text.get(1..end.saturating_sub(1)).unwrap_or_default();
        return if inside.chars().all(|c| c.is_ascii_digit() || c == '/') { end } else { 0 };
    }
    let digits = text.trim_start_matches(['-', '−']);
    let end = digits.find(|c: char| !c.is_ascii_digit() && c != '.').unwrap_or(digits.len());
    let end = digits[..end].trim_end_matches('.').len();
    if end == 0 { 0 } else { text.len() - digits.len() + end }
}

#[cfg(test)]
mod tests {
    use super::chain;

    #[test]
    fn powers_are_raised() {
        assert_eq!(chain("2.2 × 10^−9 m/s^2"), "2.2 × 10<sup>−9</sup> m/s<sup>2</sup>");
        assert_eq!(chain("(a/b)^(1/2)"), "(a/b)<sup>1/2</sup>");
        assert_eq!(
            chain("the result is 1.96e10 J, not 2e-3"),
            "the result is 1.96 × 10<sup>10</sup> J, not 2 × 10<sup>−3</sup>"
        );
        assert_eq!(chain("1.44e^−51.2 = the same"), "1.44e<sup>−51.2</sup> = the same");
    }
}
