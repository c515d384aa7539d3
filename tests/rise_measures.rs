//! Is each rise time called by its measure? The thesis leaves its own undefined, so the bare word says little.

use geneva_dynamics::steady::RiseMeasure;
use geneva_press::figures;

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
    let all = crate::files("book/src", &["md"]).into_iter().chain([(crate::path("README.md"), readme)]);
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
