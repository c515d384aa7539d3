//! What is said at the end of a report, for every program that shows one.

use crate::check::Tally;
use crate::finding::List;
use crate::verdict::Verdict;

/// "1 chain", "2 chains", "12,345 chains".
pub fn count(number: usize, thing: &str) -> String {
    let digits = number.to_string();
    let mut text = String::new();
    for (at, digit) in digits.char_indices() {
        if at > 0 && (digits.len() - at).is_multiple_of(3) {
            text.push(',');
        }
        text.push(digit);
    }
    format!("{text} {thing}{}", if number == 1 { "" } else { "s" })
}

/// How many findings there are and on which lists, such as `2 findings: 1 on a number, 1 on units alone`; `number_on` tells how
/// many a list has. None if there are none.
pub fn findings(number_on: impl Fn(List) -> usize) -> Option<String> {
    const LISTS: [(List, &str); 4] = [
        (List::Numbers, "on a number"),
        (List::Bindings, "with values from elsewhere in the text"),
        (List::Units, "on units alone"),
        (List::Doubts, "in doubt"),
    ];
    let numbers = LISTS.map(|(list, words)| (number_on(list), words));
    let parts: Vec<String> = numbers
        .iter()
        .filter(|(number, _)| *number > 0)
        .map(|(number, words)| format!("{} {words}", count(*number, "").trim_end_matches([' ', 's'])))
        .collect();
    let all = numbers.iter().map(|(number, _)| number).sum();
    (!parts.is_empty()).then(|| format!("{}: {}", count(all, "finding"), parts.join(", ")))
}

/// The chains that arithmetic cannot check, in a sentence; none if there are none.
pub fn others(tally: &Tally) -> Option<String> {
    match tally.chains.saturating_sub(tally.checkable.max(tally.checked)) {
        0 => None,
        1 => Some("1 other chain only defines something or contains letters.".to_owned()),
        others => Some(format!("{} only define something or contain letters.", count(others, "other chain"))),
    }
}

/// The formulas that are not read to their end, in a sentence; none if there are none.
pub fn unread(tally: &Tally) -> Option<String> {
    const WHY: &str = "too long, or nests too deeply, or has macros that never end";
    match tally.unread {
        0 => None,
        1 => Some(format!("1 formula or line was not read to its end: it is {WHY}.")),
        some => {
            let some = count(some, "formula or line").replace("formula or lines", "formulas or lines");
            Some(format!("{some} were not read to their end: each is {WHY}."))
        }
    }
}

/// The places in which only units differ, in words without a full stop; none if there are none.
pub fn units_alone(tally: &Tally) -> Option<String> {
    match tally.with(Verdict::Units) {
        0 => None,
        1 => Some("1 place agrees in its numbers but not in its units".to_owned()),
        places => Some(format!("{} agree in their numbers but not in their units", count(places, "place"))),
    }
}

/// The differences that are set aside, in words without a full stop; none if there are none.
pub fn doubts(tally: &Tally) -> Option<String> {
    match tally.doubts {
        0 => None,
        1 => Some(
            "1 difference is set aside, since the text may have been misread or the result is truncated".to_owned(),
        ),
        some => Some(format!(
            "{} are set aside, since the text may have been misread or the results are truncated",
            count(some, "difference")
        )),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_and_many_are_told_apart() {
        let one_each = |list| usize::from(matches!(list, List::Numbers | List::Units));
        assert_eq!(findings(one_each).as_deref(), Some("2 findings: 1 on a number, 1 on units alone"));
        assert_eq!(
            findings(|list| 1200 * usize::from(list == List::Numbers)).as_deref(),
            Some("1,200 findings: 1,200 on a number")
        );
        assert_eq!(findings(|_| 0), None);
        let doubt = |list| usize::from(list == List::Doubts);
        assert_eq!(findings(doubt).as_deref(), Some("1 finding: 1 in doubt"));
        let tally = Tally { doubts: 2, ..Tally::default() };
        assert!(doubts(&tally).is_some_and(|said| said.starts_with("2 differences are set aside")));
        let tally = Tally { chains: 3, checkable: 1, checked: 2, ..Tally::default() };
        assert_eq!(others(&tally).as_deref(), Some("1 other chain only defines something or contains letters."));
        assert_eq!((units_alone(&tally), unread(&tally)), (None, None));
        let tally = Tally { unread: 2, ..Tally::default() };
        assert!(unread(&tally).is_some_and(|said| said.starts_with("2 formulas or lines were not read")));
    }
}
