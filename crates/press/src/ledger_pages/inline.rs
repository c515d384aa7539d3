//! Pieces of the ledger inside a sentence.

use crate::book::Book;
use crate::formula::{breakable, tex_or_text};
use crate::html::{GLUED, escape, prose};
use crate::{lookup, maths};
use anyhow::{anyhow, bail, ensure};
use geneva_evidence::{Check, Claim, Judged, PlainVerdict, without_ellipses};

/// The printed characters with their unit.
pub fn printed(book: &Book, id: &str) -> anyhow::Result<String> {
    let claim = lookup::verdict(book.ledger, id)?.claim;
    Ok(format!(
        "<span class=\"claim\">{}</span>",
        with_unit(book, &tex_or_text(&without_ellipses(claim))?, claim.unit)?
    ))
}

/// The computed number with its unit.
pub fn computed_value(book: &Book, judged: &'static Judged) -> anyhow::Result<String> {
    let number = computed(judged).ok_or_else(|| anyhow!("claim `{}` computes no number", judged.claim.id))?;
    Ok(format!("<span class=\"claim\">{}</span>", with_unit(book, &number, judged.claim.unit)?))
}

/// The right number with its unit, where the printed one is not right.
pub fn right(book: &Book, id: &str) -> anyhow::Result<String> {
    let judged = lookup::verdict(book.ledger, id)?;
    let in_places = || judged.right_value.map(|right| judged.rounded(right));
    let right = judged.corrected().or_else(in_places);
    let right = right.ok_or_else(|| anyhow!("claim `{id}` has no other number that is right"))?;
    Ok(format!("<span class=\"claim\">{}</span>", with_unit(book, &tex_or_text(&right)?, judged.claim.unit)?))
}

/// The printed characters with their unit and mark.
pub fn claim(book: &Book, id: &str) -> anyhow::Result<String> {
    Ok(printed(book, id)? + &mark(book, id)?)
}

/// A mark that says whether what is printed is right, and opens the [`note`] on how we know.
pub fn mark(book: &Book, id: &str) -> anyhow::Result<String> {
    let verdict = lookup::verdict(book.ledger, id)?.plain();
    Ok(format!(
        "{MARK}verdict-{verdict}\" popovertarget=\"note-{id}\" aria-label=\"{}: how this was checked\">{}{MARKED}",
        verdict.words(),
        verdict.sign()
    ))
}

/// How the markup of a mark begins and ends.
const MARK: &str = "&#8288;<button type=\"button\" class=\"mark ";
const MARKED: &str = "</button>&#8288;";

/// A page whose marks stay on one line with the word before them and the punctuation behind them.
///
/// A joiner of words does not keep a browser from breaking a line beside a button. A word with markup of its own other than a
/// formula or a claim's number is left alone, and so are tables, whose cells would grow.
pub fn glued(page: &str) -> String {
    let mut out = String::with_capacity(page.len());
    let mut rest = page;
    while let Some(at) = rest.find(MARK) {
        let (before, marks) = rest.split_at(at);
        out.push_str(before);
        let mut end = 0;
        while let Some(length) = marks[end..].strip_prefix(MARK).and_then(|mark| mark.find(MARKED)) {
            end += MARK.len() + length + MARKED.len();
        }
        if end == 0 {
            rest = marks;
            break;
        }
        end += marks[end..].chars().take_while(|c| maths::JOINED.contains(c)).map(char::len_utf8).sum::<usize>();
        let word = start_of_word(&out);
        if let Some(start) = word {
            out.insert_str(start, GLUED);
        }
        out.push_str(&marks[..end]);
        if word.is_some() {
            out.push_str("</span>");
        }
        rest = &marks[end..];
    }
    out + rest
}

/// Where the last word of a text begins, if it can be put into an element as it is.
fn start_of_word(text: &str) -> Option<usize> {
    let line = text.rfind('\n').map_or(0, |at| at + 1);
    if text[line..].starts_with('|') {
        return None;
    }
    let opening = [("</math>", "<math>"), ("</span>", "<span class=\"claim\"")];
    if let Some((_, open)) = opening.iter().find(|(close, _)| text.ends_with(close)) {
        let start = line + text[line..].rfind(open)?;
        let is_one = ["<math", "<span"].iter().all(|tag| text[start..].matches(tag).count() <= 1);
        return is_one.then_some(start);
    }
    let start = line + text[line..].rfind(char::is_whitespace).map_or(0, |at| at + 1);
    let word = &text[start..];
    (!word.is_empty() && !word.contains(['<', '>', '*', '`', '[', ']', '$', '|', '#', '{'])).then_some(start)
}

/// What a mark opens: where the claim stands, what is printed, what is right, by what evidence.
pub fn note(book: &Book, id: &str) -> anyhow::Result<String> {
    let judged = lookup::verdict(book.ledger, id)?;
    let claim = judged.claim;
    let mut out = format!(
        "<div popover class=\"note\" id=\"note-{id}\">\n<p>{}, {}: {}. {}</p>\n<dl>\n",
        escape(&claim.document.to_string()),
        place(book, claim),
        prose(claim.meaning),
        badge(judged.plain())
    );
    let mut entry = |term: &str, text: String| out.push_str(&format!("<dt>{term}</dt><dd>{text}</dd>\n"));
    entry("Printed", with_unit(book, &breakable(&tex_or_text(&without_ellipses(claim))?), claim.unit)?);
    if let Some(number) = computed(judged) {
        entry("Computed", with_unit(book, &number, claim.unit)?);
    }
    if let Some(corrected) = judged.corrected() {
        entry("Right", with_unit(book, &breakable(&tex_or_text(&corrected)?), claim.unit)?);
    }
    if judged.is_miscopied() {
        entry("Where", "The mistake is only in the copy we had, which has lost or changed a character.".to_owned());
    }
    if let Check::Missing { reason } = claim.check {
        entry("Why", prose(reason));
    }
    let mut evidence = claim.check.evidence();
    evidence.dedup();
    for (number, kind) in evidence.iter().enumerate() {
        entry(["Checked by", "and by"][number.min(1)], escape(kind.meaning));
    }
    out.push_str(&format!("</dl>\n<p><a href=\"{}\">In the ledger</a></p>\n</div>", book.address_of_claim(id)));
    Ok(out)
}

/// A link to the check of a claim with some of its characters replaced; without scripts it leads to the claim's row in the ledger.
pub fn spoiling(book: &Book, of: &str) -> anyhow::Result<String> {
    let parts: Vec<&str> = of.splitn(4, ';').map(str::trim).collect();
    let [id, old, new, words] = parts[..] else { bail!("`{of}`: give `ID; CHARACTERS; OTHERS; WORDS`") };
    let claim = lookup::verdict(book.ledger, id)?.claim;
    let count = claim.printed.matches(old).count();
    ensure!(
        count == 1,
        "`{old}` stands {count} times in what `{id}` prints, `{}`: give characters that stand there once",
        claim.printed
    );
    let spoilt = claim.printed.replace(old, new);
    Ok(format!(
        "<a href=\"{}\" data-verify=\"{id}\" data-characters=\"{}\">{}</a>",
        book.address_of_claim(id),
        escape(&spoilt),
        escape(words)
    ))
}

/// The number of claims of a source, or of `all` documents.
pub fn claim_count(book: &Book, of: &str) -> anyhow::Result<String> {
    match of {
        "all" => Ok(lookup::verdicts_of_documents(book.ledger).count().to_string()),
        slug => Ok(lookup::verdicts_of(book.ledger, lookup::document(book.ledger, slug)?).count().to_string()),
    }
}

/// Where a claim stands in its source; of one that stands on a page elsewhere a link to it, and when it was read.
pub fn place(book: &Book, claim: &Claim) -> String {
    match (book.address_and_day)(claim.locator) {
        Some((address, day)) => format!("{}, as read on {day}", linked_page(address)),
        None => escape(claim.locator),
    }
}

/// A link to a page elsewhere: its host, its owner if it is a repository, and its last part.
pub fn linked_page(address: &str) -> String {
    let path = address.split_once("://").map_or(address, |(_, path)| path).trim_end_matches('/');
    let parts: Vec<&str> = path.trim_start_matches("www.").split('/').collect();
    // What is left out is between the owner's name and the last part.
    let first = if parts[0] == "github.com" { parts.len().min(3) } else { 1 };
    let (start, rest) = parts.split_at(first);
    let last = match rest {
        [] => String::new(),
        [only] => format!("/{only}"),
        [.., "pull", number] => format!(", request {number}"),
        [.., last] => format!("/…/{last}"),
    };
    let start = start.join("/");
    let name = start.trim_start_matches("github.com/").to_owned() + &last;
    // Long names may be broken behind what parts them.
    let name = escape(&name).replace('/', "/<wbr>").replace("&#95;", "&#95;<wbr>");
    format!("<a href=\"{}\">{name}</a>", escape(address))
}

/// What the source is.
pub fn citation(book: &Book, slug: &str) -> anyhow::Result<String> {
    Ok(escape(lookup::document(book.ledger, slug)?.citation))
}

/// The verdict of a claim in a table, which leads to the claim's row in the ledger: the sign, with the words where it does not say
/// all. Those who listen, and the data of the table, always have the words.
pub fn linked_sign(book: &Book, judged: &Judged) -> String {
    let (address, verdict) = (book.address_of_claim(judged.claim.id), judged.plain());
    let (words, sign) = (verdict.words(), verdict.sign());
    let seen = match verdict {
        PlainVerdict::Right | PlainVerdict::Wrong | PlainVerdict::Open => sign.to_owned(),
        PlainVerdict::RightAsRead | PlainVerdict::WrongInCopy => format!("{sign} {words}"),
    };
    format!(
        "<a class=\"to-ledger\" href=\"{address}\" aria-label=\"{words}\"><span data-text=\"{words}\" class=\"verdict \
         verdict-{verdict}\">{seen}</span></a>"
    )
}

/// The id of a claim, leading to its row in the ledger.
pub fn linked_id(book: &Book, id: &str) -> String {
    format!("<a href=\"{}\"><code>{id}</code></a>", book.address_of_claim(id))
}

/// A verdict as a badge: the word, to which style only adds.
pub fn badge(verdict: PlainVerdict) -> String {
    format!("<span class=\"verdict verdict-{verdict}\">{}</span>", verdict.words())
}

/// The computed number, with some places more than the printed one.
pub fn computed(judged: &Judged) -> Option<String> {
    Some(judged.rounded(judged.computed?))
}

/// A number, already HTML, with its unit behind.
pub fn with_unit(book: &Book, number: &str, unit: &str) -> anyhow::Result<String> {
    Ok(match unit {
        "" => number.to_owned(),
        "°" => format!("{number}°"),
        _ if unit.ends_with("^2") => format!("{number}&nbsp;{}²", escape(unit.trim_end_matches("^2"))),
        _ if book.letter_units.contains(&unit) => format!("{number}&nbsp;{}", maths::formula(unit, false)?),
        _ => format!("{number}&nbsp;{}", tex_or_text(unit)?.replace("10&#94;-6", "10<sup>−6</sup>")),
    })
}
