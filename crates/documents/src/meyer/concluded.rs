//! What the project concludes, as opposed to what it describes.

/// Statements that the project concludes, each with what shows that it is a conclusion.
///
/// They are the statements of its abstract and of its last chapter, and the statements that it draws from its graphs in
/// so many words.
pub const CONCLUSIONS: &[(&str, &str)] = &[
    ("meyer.abstract.fifty", "the abstract says what was found"),
    ("meyer.least-rise-time", "one of three general statements that are drawn from the graphs"),
    ("meyer.conclusion.three", "a numbered conclusion"),
];
