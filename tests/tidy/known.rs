//! Lists of what broke a rule before there was the rule. They only get shorter: what the code no longer has is taken out of the
//! list by the test itself, which then fails once, and what is new is never put in.

/// What a list of known cases becomes, by the code.
pub(super) struct Comparison {
    /// The lines of the list that the code still has, in their order.
    pub left: Vec<String>,
    /// What is new in the code, and what is wrong with a line.
    pub complaints: Vec<String>,
}

/// The lines of a list; a test of its own says that they are in order.
pub(super) fn lines(list: &str) -> Vec<String> {
    let text = std::fs::read_to_string(crate::path(list)).expect("the list");
    let lines: Vec<String> = text.lines().map(str::to_owned).collect();
    assert!(lines.is_sorted(), "{list} is sorted");
    lines
}

/// Holds that the code has what a list says and no more. A list that says more is written anew.
#[track_caller]
pub(super) fn assert_known(list: &str, known: &[String], comparison: Comparison) {
    let Comparison { left, mut complaints } = comparison;
    if left != known {
        let text: String = left.iter().map(|line| format!("{line}\n")).collect();
        std::fs::write(crate::path(list), text).expect("written");
        complaints
            .push("the code has less than the list said, which is written anew: look at the difference".to_owned());
    }
    assert!(complaints.is_empty(), "{list}:\n{}", complaints.join("\n"));
}
