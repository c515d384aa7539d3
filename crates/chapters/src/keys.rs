//! The keys in double braces that this book adds to those of every book.

use crate::{elsewhere, live, proofreading_form, questions, tables};
use geneva_press::book::Expansion::{Bare, Interactive, Numbered, Of};
use geneva_press::book::PlaceholderKey;

/// Every key of this book, what it says or shows, and how that is made.
pub(crate) const KEYS: &[PlaceholderKey] = &[
    PlaceholderKey::new(
        "ask",
        "a number of a mechanism's answer: QUESTION.KEY, and after a colon its digits",
        Of(|_, number| questions::number(number)),
    ),
    PlaceholderKey::new(
        "elsewhere",
        "every statement elsewhere that is wrong, in a fold",
        Bare(elsewhere::statement_folds),
    ),
    PlaceholderKey::new(
        "elsewhere-addresses",
        "where statements were read, and how many",
        Bare(|_| Ok(elsewhere::addresses()?.html("Where it was read"))),
    ),
    PlaceholderKey::new(
        "elsewhere-examples",
        "examples that do not fit, in a table",
        Bare(|book| Ok(elsewhere::wrong_examples(book)?.html("Examples that do not fit"))),
    ),
    PlaceholderKey::new(
        "elsewhere-wrong",
        "what is wrong elsewhere, in a table",
        Bare(|book| Ok(elsewhere::wrong_statements(book)?.html("What is wrong elsewhere"))),
    ),
    PlaceholderKey::new(
        "live",
        "a numbered figure that a reader moves",
        Interactive(live::figure_name, live::interactive),
    ),
    PlaceholderKey::new(
        "proofread",
        "the form for a text of the reader's own, with an example",
        Bare(|_| proofreading_form::form()),
    )
    .without_text(),
    PlaceholderKey::new("proofread-weight", "what that form loads at most", Bare(|_| Ok(proofreading_form::weight()))),
    PlaceholderKey::new(
        "question",
        "a question to a mechanism, as it is typed at the command line",
        Of(|_, name| questions::question(name)),
    ),
    PlaceholderKey::new(
        "wheels",
        "a table of wheels, from one number of stations to another, and its caption after a semicolon",
        Numbered(|_, range| tables::wheels(range)),
    ),
];
