//! What was found of a claim, in sentences of plain text.

use crate::{Check, Finding, Judged};

/// How a form was found to hold or to fail, after the reading, if there is one; for a missing value, what is missing.
pub fn sentences(judged: &Judged) -> Vec<String> {
    let found = match &judged.claim.check {
        Check::Missing { reason } => vec![(*reason).to_owned()],
        Check::Statement { neighbour: Some(neighbour), .. } => statement(judged, neighbour),
        _ => forms(judged),
    };
    let reading = judged.claim.reading.filter(|_| !judged.claim.check.evidence().is_empty()).map(str::to_owned);
    reading.into_iter().chain(found).map(ended).collect()
}

/// A sentence with a full stop at its end, or within the brackets around it.
fn ended(sentence: String) -> String {
    let has_end = [".", ".)"].iter().any(|end| sentence.ends_with(end));
    if has_end { sentence } else { sentence + "." }
}

/// The sentences on a form as printed and on its correction, by both routes.
fn forms(judged: &Judged) -> Vec<String> {
    let [first, second] = routes(judged);
    let (printed, corrected) = (finding_on(judged, "as printed"), finding_on(judged, "corrected"));
    let (again, refused) = (finding_on(judged, "witness"), finding_on(judged, "as printed by the witness"));
    let right = ["The printed form", "The corrected form"][usize::from(corrected.is_some())];
    let mut sentences = match (printed, corrected) {
        (Some(printed), Some(corrected)) if printed.how == corrected.how => {
            vec![format!(
                "One result{first} shows that the printed form {} and the corrected form {}: {}",
                says(printed),
                says(corrected),
                printed.how
            )]
        }
        _ => {
            let both = [("The printed form", printed), ("The corrected form", corrected)].into_iter();
            let found = both.filter_map(|(form, found)| Some((form, found?)));
            found.map(|(form, found)| format!("{form} {}{first}: {}", says(found), found.how)).collect()
        }
    };
    let Some(again) = again else { return sentences };
    let known = corrected.or(printed);
    sentences.push(match refused {
        _ if known.is_some_and(|known| known == again) && (refused.is_none() || refused == printed) => {
            format!("A second way{second} gives the same result")
        }
        Some(refused) if refused.how == again.how => format!(
            "In a second way{second}, one result shows that the printed form {} and the corrected form {}: {}",
            says(refused),
            says(again),
            again.how
        ),
        _ => format!("Checked in a second way{second}, {} {}: {}", lowered(right), says(again), again.how),
    });
    let told = refused.filter(|refused| refused.how != again.how && Some(*refused) != printed);
    sentences.extend(
        told.map(|refused| format!("Checked in this second way, the printed form {}: {}", says(refused), refused.how)),
    );
    sentences
}

/// The sentences on a statement that is right as printed and on a false version of it, by both routes.
fn statement(judged: &Judged, neighbour: &str) -> Vec<String> {
    let [first, second] = routes(judged);
    let all = ["as printed", "neighbour", "witness", "neighbour by the witness"].map(|form| finding_on(judged, form));
    let [Some(printed), Some(wrong), Some(again), Some(refused)] = all else { return Vec::new() };
    let mut sentences = vec![format!("What is printed {}{first}: {}", says(printed), printed.how)];
    let version = format!("A false version of it ({neighbour}) {}", says(wrong));
    sentences.push(if wrong.how == printed.how { version } else { format!("{version}: {}", wrong.how) });
    if (again, refused) == (printed, wrong) {
        sentences.push(format!("A second way{second} gives the same results"));
        return sentences;
    }
    sentences.push(format!("Checked in a second way{second}, what is printed {}: {}", says(again), again.how));
    let version = format!("Checked in this second way, too, the false version {}", says(refused));
    sentences.push(if refused.how == again.how { version } else { format!("{version}: {}", refused.how) });
    sentences
}

/// What was found of a form.
pub(crate) fn finding_on<'a>(judged: &'a Judged, form: &str) -> Option<&'a Finding> {
    judged.findings.iter().find(|(name, _)| *name == form).map(|(_, finding)| finding)
}

fn says(finding: &Finding) -> &'static str {
    match (finding.evaluated, finding.holds) {
        (false, _) => "cannot be read",
        (true, true) => "holds",
        (true, false) => "fails",
    }
}

fn lowered(words: &str) -> String {
    words.replacen("The", "the", 1)
}

/// The kinds of evidence of both routes, in brackets.
fn routes(judged: &Judged) -> [String; 2] {
    let evidence = judged.claim.check.evidence();
    [evidence.first(), evidence.last()].map(|kind| kind.map_or_else(String::new, |kind| format!(" (by {})", kind.name)))
}
