//! Whether a text says that a formula is false, or asks whether it holds.

use crate::effort;
use crate::join::chain::{Chain, Relation};
use crate::judge::chain_verdict::ChainVerdict;
use crate::judge::surroundings::{text_around, text_before, without_tags};
use crate::judge::verdict::judge;
use crate::token::Span;

/// Whether the chain at a place follows from one that is false, or one that is false follows from it, and it is false itself: −1 = 1 ⇒ 5 − 6 = 7 − 6.
pub(crate) fn is_derived_from_false(text: &str, chains: &[Chain], at: usize) -> bool {
    const ARROWS: [&str; 5] = ["\\Rightarrow", "\\Longrightarrow", "\\implies", "⇒", "⟹"];
    let follows = |pair: &[Chain]| {
        let end = pair[0].sides.last().map_or(0, |side| side.span.end as usize);
        let between = text.get(end..pair[1].sides[0].span.start as usize).unwrap_or_default();
        ARROWS.iter().any(|arrow| between.contains(arrow))
    };
    let is_false = |chain: &Chain| match chain.sides.as_slice() {
        [left, right] => {
            right.relation == Some(Relation::Equal)
                && judge(&left.tokens, &right.tokens, Relation::Equal, None).verdict == ChainVerdict::Inconsistent
        }
        _ => false,
    };
    let pairs = [at.checked_sub(1), Some(at)].into_iter().flatten().filter_map(|from| chains.get(from..from + 2));
    { pairs }.any(|pair| follows(pair) && pair.iter().all(is_false))
}

/// Whether empty brackets stand before a formula, into which the reader writes whether it holds: `( ) $2 + 2 = 5$`.
fn follows_empty_brackets(before: &str) -> bool {
    let before = before.trim_end().trim_end_matches(['$', ' ']);
    let before = before.strip_suffix("\\(").unwrap_or(before).trim_end();
    let Some(inside) = before.strip_suffix(')') else { return false };
    let inside = inside.trim_end_matches([' ', '~', '_', '\u{a0}']);
    let inside = inside.strip_suffix("\\quad").unwrap_or(inside).trim_end();
    // Not of a call without arguments.
    inside.strip_suffix('(').is_some_and(|rest| !rest.ends_with(|c: char| c.is_alphanumeric()))
}

/// Whether the text asks if the formula holds, or says that it does not.
pub(crate) fn is_meant_false(text: &str, span: Span) -> bool {
    let (before, after) = text_around(text, span);
    let sentence = before.rsplit(['.', '?', '!']).next().unwrap_or_default().to_ascii_lowercase();
    let rest = after.split_once(['.', '?', '!']).map_or(after.as_str(), |(rest, _)| rest).to_ascii_lowercase();
    let asked =
        after.find(['.', '?', '!']).is_some_and(|at| after[at..].starts_with('?')) && !ends_before_question(text, span);
    // Asked at once: 1 + 5 = 2? – but not behind a word.
    if after.trim_start_matches(['$', ')', ' ']).starts_with('?') {
        return true;
    }
    let marks = |c: char| c.is_whitespace() || "$({[\\".contains(c);
    if sentence.trim_end_matches(marks).ends_with("whether") {
        return true;
    }
    let mut words = sentence.split(|c: char| !c.is_alphabetic());
    let question = words.any(|word| ["is", "are", "does", "do", "can", "could", "will", "whether"].contains(&word));
    if asked && question {
        return true;
    }
    // Data of an exercise that say so: [4, false, "2 + 4 = 8"].
    if before.trim_end_matches(|c: char| c.is_whitespace() || "$({[\\\"'".contains(c)).ends_with("false,") {
        return true;
    }
    if follows_empty_brackets(&before) {
        return true;
    }
    // Its denial stands beside it.
    if is_denied_near([&before, &after], text.get(span.range()).unwrap_or_default()) {
        return true;
    }
    if is_false_below(text, span) {
        return true;
    }
    // One of the answers to choose from.
    let example = text_before(text, span);
    if is_choice_of_list(example) {
        return true;
    }
    if before.trim_end().ends_with("\\choice") || is_answer_to_choose(&before, &after) {
        return true;
    }
    let behind = after.split("\n\n").next().unwrap_or_default();
    if sentence.contains("what if ")
        || behind.contains("This fallacy")
        || behind.contains("this fallacy")
        || behind.contains("extraneous")
    {
        return true;
    }
    if [&*before, behind].into_iter().any(|text| text.to_ascii_lowercase().contains("true or false")) {
        return true;
    }
    if example.contains("a proportion") && example.contains("hether") {
        return true;
    }
    // An item with its answer behind.
    let line = text.get(span.end as usize..).unwrap_or_default();
    let line = line[..line.floor_char_boundary(STATEMENT)].split(['\n', '<']).next().unwrap_or_default();
    effort::count_steps(line.len() / 8);
    if is_answered_false(line) || is_implication(&before, &after) {
        return true;
    }
    // An exercise that has the reader put in brackets, or say which of several statements hold.
    const EXERCISES: [&str; 11] = [
        "what is wrong with",
        "sentences are statements",
        "following are statements",
        "these are statements?",
        "to make the following statements true",
        "to make the statement true",
        "to make each statement true",
        "to make the equation true",
        "are true, and which are false",
        "are true and which are false",
        "which of the following are true",
    ];
    let task = example.to_ascii_lowercase();
    let asked = EXERCISES.iter().filter_map(|exercise| task.rfind(exercise)).max();
    if asked.is_some_and(|at| !["solution", "answer", "example"].iter().any(|end| task[at..].contains(end))) {
        return true;
    }
    // The items of a list of statements.
    const LISTS: [&str; 4] = [
        "true or false",
        "whether the following statements",
        "whether each statement",
        "whether each of the following",
    ];
    const ITEMS: [&str; 6] = ["<li", "\\item", "\n- ", "\n* ", "> - ", "(a)"];
    let list = LISTS.iter().filter_map(|list| task.rfind(list)).max().map(|at| &task[at..]);
    let is_item = |list: &str| ITEMS.iter().any(|item| list.contains(item));
    if list.is_some_and(|list| is_item(list) && !["solution", "answer", "example"].iter().any(|end| list.contains(end)))
    {
        return true;
    }
    const REPORTS: [&str; 15] = [
        "false statement",
        "false equation",
        "false equality",
        "untrue statement",
        "mistake",
        "wrongly",
        "incorrectly",
        "fallacy",
        "misconception",
        "you wrote",
        "not true",
        "student writes",
        "student wrote",
        "student claims",
        "on purpose",
    ];
    if REPORTS.iter().any(|report| sentence.contains(report)) {
        return true;
    }
    // A heading over what is false, up to where the text says what is right.
    const HEADINGS: [&str; 8] = [
        "for errors",
        "common error",
        "common mistake",
        "typical error",
        "typical mistake",
        "false on purpose",
        "wrong on purpose",
        "find the error",
    ];
    let before = before.to_ascii_lowercase();
    let headed = HEADINGS.iter().filter_map(|heading| before.rfind(heading)).max();
    if let Some(at) = headed
        && !["in fact", "no:", "right", "correct", "actually", "really", "instead"]
            .iter()
            .any(|word| before[at..].contains(word))
    {
        return true;
    }
    let behind = text.get(span.end as usize..).unwrap_or_default();
    let behind = behind[..behind.floor_char_boundary(STATEMENT)].to_ascii_lowercase();
    if ["the statement is false", "the equation is false", "the proposition is false"]
        .iter()
        .any(|of| behind.contains(of))
    {
        return true;
    }
    const DENIALS: [&str; 16] = [
        "not a true",
        "(falsch)",
        "(faux)",
        "(falso)",
        "no longer true",
        "no longer holds",
        "would be false",
        "would be wrong",
        "is false",
        "not true",
        "a false statement",
        "incorrect",
        "is wrong",
        "are not equal",
        "is not a solution",
        "is inconsistent",
    ];
    // The word alone, or a cross: 40/48 = 1/9 ✗ Wrong!
    let mut words = rest.split(|c: char| !c.is_alphabetic()).filter(|word| !word.is_empty());
    let verdict = words.next().filter(|_| words.next().is_none());
    if after.trim_start_matches([' ', '\n', '$', ')', '\\', ']']).starts_with(['✗', '✘'])
        || verdict.is_some_and(|word| ["wrong", "false", "incorrect", "falsch", "faux", "falso"].contains(&word))
    {
        return true;
    }
    DENIALS.iter().any(|denial| rest.contains(denial))
        || contradicts(&after.to_ascii_lowercase(), text.get(span.range()).unwrap_or_default())
}

/// Whether the sentence or paragraph of a formula ends before the next question mark although no mark says so: the question is in the
/// argument of a command behind it such as `\question{`, in the next element, or in the next paragraph.
fn ends_before_question(text: &str, span: Span) -> bool {
    const STYLES: [&str; 12] = [
        "emph",
        "textbf",
        "textit",
        "text",
        "textrm",
        "textsf",
        "texttt",
        "textsc",
        "underline",
        "textcolor",
        "mbox",
        "enquote",
    ];
    const ELEMENTS: [&str; 8] = ["</p", "</li", "</title", "</h", "</statement", "</td", "<p", "<li"];
    let behind = text.get(span.end as usize..).unwrap_or_default();
    let behind = &behind[..behind.floor_char_boundary(STATEMENT)];
    let Some(question) = behind.find('?') else { return false };
    let between = &behind[..question];
    let formula = text.get(span.range()).unwrap_or_default();
    // The sentence of a display goes on behind it.
    let is_display = ["$$", "\\[", "\\begin", "<me", "<md"].iter().any(|mark| formula.starts_with(mark));
    if !is_display
        && (between.contains("\n\n") || between.contains("\n#") || ELEMENTS.iter().any(|tag| between.contains(tag)))
    {
        return true;
    }
    // The groups that are open at the question mark, each with the command before it.
    let mut open: Vec<&str> = Vec::new();
    for (at, c) in between.char_indices() {
        match c {
            '{' => {
                let before = between[..at].trim_end_matches(|c: char| c.is_ascii_alphabetic() || c == '*');
                open.push(if before.ends_with('\\') { &between[before.len()..at] } else { "" });
            }
            '}' => drop(open.pop()),
            _ => {}
        }
    }
    open.iter().any(|command| !command.is_empty() && !STYLES.contains(&command.trim_end_matches('*')))
}

/// Whether the display that follows a display, with nothing between them, says that it is false: a check of a root that is none.
fn is_false_below(text: &str, span: Span) -> bool {
    let behind = text.get(span.end as usize..).unwrap_or_default();
    let behind = behind[..behind.floor_char_boundary(STATEMENT)].trim_start();
    let inside = [("$$", "$$"), ("\\[", "\\]")].into_iter().find_map(|(opens, closes)| {
        let (inside, _) = behind.strip_prefix(opens)?.split_once(closes)?;
        Some(inside.to_ascii_lowercase())
    });
    let words = ["{false}", "{(false)}", "(false)", "{false.}"];
    inside.is_some_and(|inside| words.iter().any(|word| inside.replace(' ', "").contains(word)))
}

/// How far behind a formula a text may say that the statement is false, in bytes.
const STATEMENT: usize = 300;

/// Whether the text near an equation has it with a sign that denies it: `8 − 5 = 2` beside `8 − 5 ≠ 2`.
fn is_denied_near(near: [&str; 2], formula: &str) -> bool {
    if !near.iter().any(|text| ["\\ne", "≠", "\\not"].iter().any(|sign| text.contains(sign))) {
        return false;
    }
    let solid = |text: &str| -> String { text.chars().filter(|c| !c.is_whitespace() && !"{}$".contains(*c)).collect() };
    let formula = solid(formula);
    let Some((left, right)) = formula.split_once('=').filter(|(left, right)| !left.is_empty() && !right.is_empty())
    else {
        return false;
    };
    let signs = ["\\neq", "\\ne", "≠", "\\not="].map(|sign| format!("{left}{sign}{right}"));
    near.into_iter().map(solid).any(|text| signs.iter().any(|denial| text.contains(denial)))
}

/// Whether a place is in a list with capital letters for its items that is part of a statement in PreTeXt: answers to choose from.
fn is_choice_of_list(before: &str) -> bool {
    let inside =
        |tag: &str| before.rfind(&format!("<{tag}")).filter(|at| !before[*at..].contains(&format!("</{tag}>")));
    let Some(list) = inside("ol") else { return false };
    let tag: String = before[list..].split('>').next().unwrap_or_default().replace(' ', "");
    ["marker=\"A", "marker=\"(A", "marker='A"].iter().any(|mark| tag.contains(mark)) && inside("statement").is_some()
}

/// Whether what stands behind a formula says that it is a contradiction, absurd or impossible itself: not that a number of elements is, nor
/// what an inequality in the formula says.
fn contradicts(rest: &str, formula: &str) -> bool {
    const LINKS: &str = " a an the is are this that which gives giving yields leads leading to us we have get arrive at so clearly and but \
        in by again our another obvious clear clearly it which therefore hence thus contrary ";
    let words = ["contradiction", "absurd", "impossible"];
    let Some(at) = words.iter().filter_map(|word| rest.find(word)).min() else { return false };
    let mut words = rest[..at].split(|c: char| !c.is_alphabetic()).filter(|word| !word.is_empty());
    // Only then is the formula looked at, which may be long and has as many equations.
    words.all(|word| LINKS.split_ascii_whitespace().any(|link| link == word))
        && !{
            let formula = if formula.starts_with('<') { without_tags(formula) } else { formula.to_owned() };
            ["<", ">", "\\le", "\\ge", "\\lt", "\\gt", "≤", "≥"].iter().any(|sign| formula.contains(sign))
        }
}

/// Whether the rest of a line says that the answer to a statement is *false*, or asks for it.
fn is_answered_false(line: &str) -> bool {
    let line = line.to_ascii_lowercase();
    let Some(at) = line.find("answer") else { return false };
    let behind = line[at + "answer".len()..].trim_start_matches(|c: char| !c.is_alphabetic());
    ["false", "r torf(false", "r mcq("].iter().any(|answer| behind.starts_with(answer))
}

/// Whether a formula is one of the two of an implication: if *F*, then *F*.
fn is_implication(before: &str, after: &str) -> bool {
    let letters = |text: &str| -> String {
        text.chars().filter(|c| c.is_alphabetic() || c.is_whitespace()).collect::<String>().to_ascii_lowercase()
    };
    let sentence = letters(before.rsplit(['.', '?', '!', ':']).next().unwrap_or_default());
    let words: Vec<&str> = sentence.split_whitespace().filter(|word| word.len() > 1).collect();
    let goes_on = letters(after).trim_start().starts_with("then ");
    words == ["if", "then"] || (words == ["if"] && goes_on)
}

/// Whether a formula stands behind a capital letter in brackets, with the letter before or after it behind another one: `(B)` near
/// `(A)` or `(C)`.
fn is_answer_to_choose(before: &str, after: &str) -> bool {
    let marks = |c: char| c.is_whitespace() || "$({[\\".contains(c);
    let Some(label) = before.trim_end_matches(marks).strip_suffix(')') else { return false };
    let Some(letter) = label.chars().next_back().filter(|c| ('A'..='F').contains(c)) else { return false };
    let Some(rest) = label.strip_suffix(letter).and_then(|rest| rest.strip_suffix('(')) else { return false };
    let near = |by: i8| char::from((letter as u8).wrapping_add_signed(by));
    rest.contains(&format!("({})", near(-1))) || after.contains(&format!("({})", near(1)))
}
