//! Does a word have one meaning in the whole book? Each rise is called by its measure (the thesis leaves its own undefined), the
//! book's terminal speed is not the thesis's terminal velocity, and a verdict is said in one of five words.

use geneva_chapters::figures;
use geneva_dynamics::steady::RiseMeasure;
use geneva_evidence::{PlainVerdict, Verdict};

/// What tells that a rise is the thesis's own, whose end it leaves open, or leads to where the measures are listed.
const OF_THE_THESIS: [&str; 9] = [
    "thesis",
    "printed",
    "tables",
    "column",
    "rows",
    "definition",
    "{{verdict:meyer.",
    "#the-terms",
    "#the-rise-times",
];

/// How a text may say that it speaks of a rise as a time.
const RISES: [&str; 7] =
    ["rise time", "the rise ", "a rise ", "settling time", "time to settle", "motion settles", "rise from rest"];

/// Whether a text speaks of a rise without a measure, and not of the thesis's own.
fn is_bare(text: &str) -> bool {
    let text = text.to_lowercase();
    let measures = RiseMeasure::ALL.map(RiseMeasure::name);
    let named = measures.iter().chain(&["every angle", "each angle"]).any(|name| text.contains(name));
    RISES.iter().any(|word| text.contains(word)) && !named && !OF_THE_THESIS.iter().any(|word| text.contains(word))
}

#[test]
fn chapters_and_the_readme_call_each_rise_by_its_measure() {
    let mut bare = Vec::new();
    let readme = std::fs::read_to_string(crate::path("README.md")).expect("a README");
    let all = crate::texts().into_iter().chain([(crate::path("README.md"), readme)]);
    for (path, text) in all {
        // Neither headings, which stand over a paragraph that says it, nor the architecture of the code.
        let paragraphs = text.split("\n\n").filter(|part| !part.starts_with('#') && !part.starts_with("```"));
        let paragraphs = paragraphs.filter(|_| !path.ends_with("architecture.md"));
        bare.extend(paragraphs.filter(|part| is_bare(part)).map(|part| format!("{}: {part}", path.display())));
    }
    assert!(bare.is_empty(), "{}", bare.join("\n\n"));
}

#[test]
fn captions_call_each_rise_by_its_measure() {
    let mut named = 0;
    for (name, _) in figures::FIGURES {
        let figure = figures::by_name(name).expect("a figure");
        for text in [&figure.title, &figure.description, &figure.caption] {
            assert!(!is_bare(text), "{name}: {text}");
        }
        named += usize::from(figure.caption.contains(RiseMeasure::SmallDifference.name()));
    }
    assert!(named >= 4, "{named}");
}

#[test]
fn a_bare_word_is_noticed_and_one_with_its_measure_is_not() {
    assert!(is_bare("A lighter follower saves a quarter of the settling time."));
    assert!(is_bare("The rise time is 50 ms."));
    assert!(!is_bare("By the profile, the rise time is 50 ms."));
    assert!(!is_bare("The thesis gives a rise time."));
    assert!(!is_bare("Both pieces rise."));
}

#[test]
fn a_terminal_velocity_is_the_thesiss_and_a_terminal_speed_is_ours() {
    // The thesis means several things by its word, and the book one by its own: the speed at entry.
    let mut bare = Vec::new();
    for (path, text) in crate::texts() {
        for paragraph in text.split("\n\n").filter(|part| !part.starts_with("```")) {
            let says = paragraph.to_lowercase().replace('\n', " ");
            if says.contains("terminal velocity")
                && !OF_THE_THESIS.iter().chain(&["abstract", "figs."]).any(|word| says.contains(word))
            {
                bare.push(format!("{}: {paragraph}", path.display()));
            }
        }
    }
    assert!(bare.is_empty(), "{} paragraphs:\n{}", bare.len(), bare.join("\n\n"));
}

#[test]
fn an_escapement_may_jam_and_is_never_said_to() {
    // Where the equation of motion has no single solution, nothing says what a real mechanism does.
    let mut said = 0;
    for name in ["escapement", "joints", "timer", "terminal-speed", "never-printed", "mistake"] {
        let text = std::fs::read_to_string(crate::path(&format!("book/src/{name}.md"))).expect("a chapter");
        let words: Vec<&str> = text.split(|c: char| !c.is_alphanumeric()).filter(|word| !word.is_empty()).collect();
        for (at, word) in words.iter().enumerate().filter(|(_, word)| word.starts_with("jam")) {
            let before = &words[at.saturating_sub(1)..at];
            // `{{computed:built.jam.four}}` is a key.
            assert!(matches!(before, ["may" | "against" | "built"]), "{name}: {} {word}", before.join(" "));
            said += usize::from(before == ["may"]);
        }
    }
    assert!(said >= 3, "only {said}");
}

/// Words of a page that are classes of verdict in the data, or verdicts in other than the plain words. Data are set as code.
fn verdicts_in_other_words(page: &str) -> Vec<String> {
    let mut text = String::new();
    for (at, piece) in page.split("<code").enumerate() {
        text.push_str(if at == 0 { piece } else { piece.split_once("</code>").map_or(piece, |(_, behind)| behind) });
    }
    let classes = Verdict::ALL.iter().map(|class| class.slug()).filter(|slug| slug.contains('-'));
    let mut found: Vec<String> = classes.filter(|class| text.contains(class)).map(str::to_owned).collect();
    let plain = |slug: &str| PlainVerdict::ALL.iter().any(|verdict| verdict.slug() == slug);
    for piece in text.split(" verdict-").skip(1) {
        let slug: String = piece.chars().take_while(|c| c.is_ascii_lowercase() || *c == '-').collect();
        if !plain(&slug) {
            found.push(format!("verdict-{slug}"));
        }
    }
    found
}

#[test]
fn pages_say_a_verdict_in_one_of_five_words() {
    let mut marked = 0;
    for name in crate::book_pages::names() {
        let page = std::fs::read_to_string(crate::book_pages::book().join(&name)).expect("a page");
        let page = &page;
        assert_eq!(verdicts_in_other_words(page), Vec::<String>::new(), "{name}");
        marked += page.matches(" verdict-").count();
    }
    assert!(marked > 100, "{marked} verdicts on all pages");
    for other in ["the verdict is from-rounded", "<b class=\"mark verdict-corrected\">", "<code>x</code> read-off"] {
        assert_eq!(verdicts_in_other_words(other).len(), 1, "{other}");
    }
    assert!(verdicts_in_other_words("<code>from-rounded</code> <b class=\"verdict verdict-wrong\">").is_empty());
}
