//! The page that proofreads a text of the reader's own: its form, and an example from the sources with what is found in it.

use crate::lookup;
use geneva_press::html::escape;
use geneva_proofread_page::{
    Fact, MOST_BYTES, NamePolicyChoice, PageAnswer, PageQuestion, ShownFinding, ShownPlace, name_of_format,
    too_long_message,
};
use proofread::{ReportSection, TextFormat};

/// What the module may weigh that the page loads, in bytes.
pub const HEAVIEST_MODULE: usize = 500_000;

/// The chains of the sources that the proofreader finds wrong, as a text in Markdown: `<ID>` stands for what a claim prints. In the
/// last two, the speed that their source gives stands for its letter, since the form begins without values of names.
const EXAMPLE: &str = r"# Five chains that are wrong

From a handout, the time of a dwell:

$$\tau = <jazar.ex-c.dwell> = <jazar.ex-c.dwell-seconds>\ \mathrm{s}$$

From a thesis, a wheel with three slots:

$$<meyer.app-a.three-slots.centre-equation> = <meyer.app-a.three-slots.centre>$$

$$<meyer.app-a.three-slots.radius-equation> = <meyer.app-a.three-slots.radius>$$

From an examination problem, the parts of a pin's speed across and along a lever:

$$v_{P4} = <quick-return.pin-speed>\ \mathrm{m/s} \cdot \cos <quick-return.crank-angle>^\circ = <quick-return.lever-point-speed>\ \mathrm{m/s}$$

$$v_{P2/P4} = <quick-return.pin-speed>\ \mathrm{m/s} \cdot \sin <quick-return.crank-angle>^\circ = <quick-return.sliding-speed>\ \mathrm{m/s}$$
";

/// The example with what the claims print.
pub fn example() -> anyhow::Result<String> {
    let mut pieces = EXAMPLE.split('<');
    let mut text = pieces.next().unwrap_or_default().to_owned();
    for piece in pieces {
        let (id, rest) = piece.split_once('>').unwrap_or((piece, ""));
        text += lookup::judged(id)?.claim.printed;
        text += rest;
    }
    Ok(text)
}

/// How much the page loads when the reader turns to the form.
pub fn weight() -> String {
    format!("{} kB", HEAVIEST_MODULE / 1000)
}

/// The form with the example in it, and what is found in the example.
pub fn form() -> anyhow::Result<String> {
    let example = example()?;
    let answer = PageAnswer::for_question(&PageQuestion::new(&example)).map_err(anyhow::Error::msg)?;
    let option = |value: &str, words: &str| format!("<option value=\"{value}\">{}</option>", escape(words));
    // What is checked in a table alone is the command's.
    let formats = TextFormat::ALL.into_iter().filter(|(_, format)| *format != TextFormat::Csv);
    let formats: String = formats.map(|(name, format)| option(name, name_of_format(format))).collect();
    let bindings = NamePolicyChoice::ALL.map(|of| option(of.word, of.label)).concat();
    let buttons = [("file", "Open a file"), ("copy", "Copy the result"), ("clear", "Clear"), ("example", "Example")]
        .map(|(action, words)| format!("<button type=\"button\" data-do=\"{action}\">{words}</button>"));
    let sentences: String = answer.summary.iter().map(|sentence| format!("<p>{}</p>", escape(sentence))).collect();
    let less_certain = ReportSection::LessCertain.name();
    let (folded, listed): (Vec<_>, Vec<_>) = answer.findings.iter().partition(|of| of.list == less_certain);
    Ok(format!(
        "<section class=\"proofread\" data-proofread=\"{MOST_BYTES}\" data-proofread-refusal=\"{}\" aria-label=\"Proofread a \
         text\">\n<form autocomplete=\"off\">\n<div class=\"text\"><label for=\"proofread-text\">Your text, or a file dropped \
         here</label><textarea id=\"proofread-text\" spellcheck=\"false\" autocapitalize=\"off\" readonly>{}</textarea></div>\n\
         <p class=\"from\" role=\"status\"></p>\n<p class=\"without\">You can only read the example here, because scripts \
         or WebAssembly are not available on this page. Use the command below.</p>\n<div class=\"controls\" hidden><label \
         for=\"proofread-format\">Format</label><select id=\"proofread-format\" name=\"format\">{}{formats}</select><label \
         for=\"proofread-bindings\">Use values given to names</label><select id=\"proofread-bindings\" \
         name=\"bindings\">{bindings}</select><span class=\"check\"><input type=\"checkbox\" id=\"proofread-units\" \
         name=\"units\"><label for=\"proofread-units\">List units that do not agree, too</label></span><span \
         class=\"check\"><input type=\"checkbox\" id=\"proofread-doubts\" name=\"doubts\" checked><label \
         for=\"proofread-doubts\">List doubts, too</label></span><p \
         class=\"buttons\">{}</p><input type=\"file\" name=\"file\" aria-label=\"File\" hidden></div>\n<p class=\"done\" \
         role=\"status\"></p>\n</form>\n<div class=\"result\"><div class=\"summary\" role=\"status\" \
         aria-live=\"polite\">{sentences}</div><ol class=\"findings\">{}</ol><details \
         class=\"apart\"{}><summary>{}</summary><ol class=\"findings\">{}</ol></details></div>\n</section>",
        escape(&too_long_message()),
        text(&example),
        option("recognised", "recognised"),
        buttons.join(" "),
        listed.iter().map(|of| finding(of)).collect::<String>(),
        if folded.is_empty() { " hidden=\"\"" } else { "" },
        escape(&answer.less_certain),
        folded.iter().map(|of| finding(of)).collect::<String>(),
    ))
}

/// A finding as `book/theme/proofread.js` shows it.
fn finding(ShownFinding { list, verdict, line, column, place, chain, facts, others, more }: &ShownFinding) -> String {
    let [before, marked, after] = chain.each_ref().map(|piece| escape(piece));
    let fact = |Fact { label, text }: &Fact| format!("<div><dt>{label}</dt> <dd>{}</dd></div>", escape(text));
    let link = |ShownPlace { line, column, place }: &ShownPlace| {
        format!(
            "<a href=\"#proofread-text\" data-from=\"{}\" data-to=\"{}\">line {line}, column {column}</a>",
            place.start, place.end
        )
    };
    let mut links: Vec<String> = others.iter().map(link).collect();
    links.extend((*more > 0).then(|| format!("and {more} more")));
    let also = if links.is_empty() {
        String::new()
    } else {
        format!("<div><dt>also</dt> <dd>{}</dd></div>", links.join("; "))
    };
    format!(
        "<li data-list=\"{list}\"><p class=\"where\"><a href=\"#proofread-text\" data-from=\"{}\" data-to=\"{}\">line {line}, column \
         {column}</a>: <strong>{verdict}</strong></p><p class=\"chain\"><samp>{before}<mark>{marked}</mark>{after}</samp></p>\
         <dl>{}{also}</dl></li>",
        place.start,
        place.end,
        facts.iter().map(fact).collect::<String>(),
    )
}

/// Several lines inside an element: an empty one would end a block of HTML in Markdown.
fn text(lines: &str) -> String {
    escape(lines).replace('\n', "&#10;")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_example_has_the_five_known_mistakes_and_no_other() {
        let text = example().expect("claims");
        let answer = PageAnswer::for_question(&PageQuestion::new(&text)).expect("it can be read");
        let found: Vec<_> = answer.findings.iter().map(|of| (of.list, of.chain[1].as_str())).collect();
        let printed = |list, id, unit| (list, format!("{}{unit}", lookup::judged(id).expect("a claim").claim.printed));
        let known = [
            printed("doubts", "jazar.ex-c.dwell-seconds", " s"),
            printed("numbers", "meyer.app-a.three-slots.centre", ""),
            printed("numbers", "meyer.app-a.three-slots.radius", ""),
            printed("numbers", "quick-return.lever-point-speed", " m/s"),
            // Where so many differ, one without a likely slip is less certain.
            printed("less-certain", "quick-return.sliding-speed", " m/s"),
        ];
        assert_eq!(found, known.each_ref().map(|(list, text)| (*list, text.as_str())));
        assert_eq!(answer.format, TextFormat::Markdown);
    }
}
