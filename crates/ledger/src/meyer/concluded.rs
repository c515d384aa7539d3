//! What the project concludes, as opposed to what it describes.

/// Statements that the project concludes: those of its abstract and of its last chapter, and those that it draws from its
/// graphs in so many words. Each with what shows it.
pub const CONCLUSIONS: &[(&str, &str)] = &[
    ("meyer.abstract.fifty", "the abstract says what was found"),
    ("meyer.least-rise-time", "one of three general statements that are drawn from the graphs"),
    ("meyer.conclusion.three", "a numbered conclusion"),
];
