//! What was not checked or not read is counted, named and listed.

use proofread::{CheckOptions, CheckReport, NamePolicy, TextFormat, UncheckedKind, UnreadKind, proofread, summary};

fn report(text: &str, format: TextFormat) -> CheckReport {
    let options = CheckOptions { unchecked: true, name_policy: NamePolicy::Never, ..CheckOptions::default() };
    proofread(text, format, options).expect("it can be read")
}

/// The kind and the name of the only chain that was not checked.
#[track_caller]
fn only(text: &str) -> (UncheckedKind, String) {
    let chains = report(text, TextFormat::Markdown).unchecked;
    let [chain] = chains.as_slice() else { panic!("{text}: {chains:?}") };
    (chain.kind, chain.name.clone())
}

#[test]
fn each_chain_that_was_not_checked_has_its_reason() {
    for (text, kind, name) in [
        (r"$\foo{7}{4} = 36$", UncheckedKind::Command, r"\foo"),
        (r"$2 + 3\,\unknownfunction(4) = 9$", UncheckedKind::Command, r"\unknownfunction"),
        (r"$\begin{strange} 1 + 2 \end{strange} = 3$", UncheckedKind::Environment, "strange"),
        (r"$\operatorname{frob}(4, 6) = 12$", UncheckedKind::Function, "frob"),
        ("Here frob(4, 6) = 12", UncheckedKind::Function, "frob"),
        ("$2x + 1 = 7$", UncheckedKind::Letter, "x"),
        ("$x = 7$", UncheckedKind::Definition, "x"),
        (r"$5\text{ apples} + 3 = 8$", UncheckedKind::Word, "apples"),
        (r"$\int_0^1 2 = 2$", UncheckedKind::Notation, "an integral"),
        ("Is $2 + 2 = 5$?", UncheckedKind::Denied, ""),
        ("So $2 + 2 = 5$???", UncheckedKind::Denied, ""),
        (r"$6!^{(2)} = 48$", UncheckedKind::Notation, "a factorial of several steps"),
        (r"$(0,1)\times(0,1) = (-1,0)$", UncheckedKind::Notation, "a product of pairs"),
        (r"$\arctan2(3, 4) = 36.9°$", UncheckedKind::Notation, "a function of two numbers"),
        ("$= 5$", UncheckedKind::Cut, ""),
    ] {
        assert_eq!(only(text), (kind, name.to_owned()), "{text}");
    }
    let long = format!("${}2 = 3$", "1 + ".repeat(10_000));
    assert_eq!(only(&long).0, UncheckedKind::Unread);
    assert_eq!(report("$2 + 2 = 4$ and $x > 2$ and $1 + 1 = 3$", TextFormat::Markdown).unchecked, []);
}

#[test]
fn an_entry_of_a_matrix_whose_digits_a_computer_loses_is_not_compared_and_the_chain_says_so() {
    let product = |large: &str, last: &str| {
        let matrix = |entries: &str| format!(r"\begin{{pmatrix}} {entries} \end{{pmatrix}}");
        let factors = [format!(r"1 & 0 \\ {large} & 1"), format!(r"1 & 1 \\ 0 & 1-{large}")];
        let [first, second, result] =
            [&factors[0], &factors[1], &format!(r"1 & 1 \\ {large} & {last}")].map(|entries| matrix(entries));
        report(&format!("${first} {second} = {result}$"), TextFormat::Markdown)
    };
    let lost = product("10^{30}", "1");
    assert_eq!((lost.findings.len(), lost.tally.pairs), (0, 3));
    let [chain] = lost.unchecked.as_slice() else { panic!("{:?}", lost.unchecked) };
    assert!(chain.partly && chain.name == "a matrix", "{chain:?}");
    let kept = [product("10", "1"), product("10", "2")];
    assert_eq!(
        kept.each_ref().map(|of| (of.findings.len(), of.tally.pairs, of.unchecked.len())),
        [(0, 4, 0), (1, 4, 0)]
    );
}

#[test]
fn what_the_program_does_not_know_counts_as_checkable() {
    let text = r"$2 + 2 = 4$, $1 + 2 = 3$, $\foo{7}{4} = 36$, $\foo{5}{2} = 10$, $\begin{strange} 2 \end{strange} = 2$";
    let found = report(text, TextFormat::Markdown);
    assert_eq!((found.tally.checked, found.tally.checkable), (2, 5));
    let words = summary::describe_unchecked_chains(&found.not_checked);
    assert_eq!(words.as_deref(), Some(r"Not checked: 2 chains with `\foo`, 1 with `strange`."));
    // What was checked though it has letters counts, too, and hides nothing that was not.
    let found = report(r"We have $\left. x^2 \right|_0^2 = 4$ and $\foo{7}{4} = 36$.", TextFormat::Markdown);
    assert_eq!((found.tally.checked, found.tally.checkable), (1, 2));
    // Letters are no numbers, whatever stands beside them.
    let found = report(r"$\foo{n}{2} = 3k$, $x = 5$", TextFormat::Markdown);
    assert_eq!((found.tally.checked, found.tally.checkable), (0, 0));
}

#[test]
fn a_part_of_a_chain_that_was_not_checked_is_listed() {
    let found = report(r"$2 + 2 = 4 = \foo{4}{1}$ and $y = 2 + 2 = 4$", TextFormat::Markdown);
    let [part] = found.unchecked.as_slice() else { panic!("{:?}", found.unchecked) };
    assert!(part.partly && part.name == r"\foo" && part.chain == r"2 + 2 = 4 = \foo{4}{1}", "{part:?}");
    assert_eq!((found.tally.partly, found.tally.checked, found.not_checked.total()), (1, 2, 0));
    // What another relation joins is no part of the equation.
    assert_eq!(report(r"$3^2 = 9 \equiv 2 \pmod 7$", TextFormat::Markdown).unchecked, []);
}

#[test]
fn a_chain_that_was_not_checked_has_its_place() {
    for (text, format) in [
        (r"Über $\foo{7} = 36$", TextFormat::Markdown),
        (r"Über $\foo{7} = 36$", TextFormat::Latex),
        (r"Über \emph{so}: 7 Kekse + 1 = 36.", TextFormat::Latex),
        ("<p>Über <b>x</b>: 7 Kekse + 1 = 36.</p>", TextFormat::Html),
    ] {
        let found = report(text, format);
        let [chain] = found.unchecked.as_slice() else { panic!("{text}: {:?}", found.unchecked) };
        assert!(text[chain.span.range()].ends_with("= 36"), "{text}: {chain:?}");
    }
}

#[test]
fn parts_that_are_not_read_are_counted_by_name() {
    let counts = |text: &str, format| -> Vec<(UnreadKind, String, usize)> {
        let parts = report(text, format).not_read;
        parts.iter().map(|(kind, name, times)| (kind, name.to_owned(), times)).collect()
    };
    let of = |kind, name: &str, times| (kind, name.to_owned(), times);
    let text = "```python\nx = 2 + 2\n```\n\n```{r, echo=F}\nx = 1\n```\n\n~~~\nx = 1\n~~~\n\n```python\nx = y\n```\n\n`x = 3` <!-- 1 = 2 -->";
    assert_eq!(
        counts(text, TextFormat::Markdown),
        [
            of(UnreadKind::Fence, "", 1),
            of(UnreadKind::Fence, "python", 1),
            of(UnreadKind::Fence, "r", 1),
            of(UnreadKind::Code, "", 1),
            of(UnreadKind::Comment, "", 1),
        ]
    );
    let text = "% 1 = 2\n\\begin{verbatim}1 = 2\\end{verbatim} \\verb|1 = 2| \\begin{lstlisting}x\\end{lstlisting}";
    assert_eq!(
        counts(text, TextFormat::Latex),
        [of(UnreadKind::Code, "", 1), of(UnreadKind::Environment, "verbatim", 1), of(UnreadKind::Comment, "", 1),]
    );
    let text = "<p>1</p><!-- 1 = 2 --><pre>1 = 2</pre><pre>1</pre>";
    assert_eq!(counts(text, TextFormat::Html), [of(UnreadKind::Element, "pre", 1), of(UnreadKind::Comment, "", 1)]);
    let text = r#"{"cells": [{"cell_type": "code", "source": ["x = 1"]}]}"#;
    assert_eq!(counts(text, TextFormat::Notebook), [of(UnreadKind::Cell, "", 1)]);
    // An older dialect of PreTeXt, and elements of the same names whose content is read.
    let text = "<p><equation>2+2 = 5</equation><equation>x = y</equation><alignmath>1+1&amp;=3\\\\</alignmath></p>";
    assert_eq!(
        counts(text, TextFormat::Xml),
        [of(UnreadKind::Element, "alignmath", 1), of(UnreadKind::Element, "equation", 1)]
    );
    let text =
        "<equation><math><mn>2</mn><mo>=</mo><mn>2</mn></math></equation><equation>$$2+2 = 4$$</equation><equation>";
    assert_eq!(counts(text, TextFormat::Xml), []);
    // What is read is not among them.
    assert_eq!(counts("```{note}\n$1 + 1 = 2$\n```\n\n```math\n1 + 1 = 2\n```", TextFormat::Markdown), []);
}

#[test]
fn one_chain_and_several_are_told_apart() {
    let said = |text: &str| {
        let report = crate::report(text, TextFormat::Latex);
        summary::describe_unchecked_chains(&report.not_checked).unwrap_or_default()
    };
    assert_eq!(said("$x = 4$"), "Not checked: 1 chain that only gives a letter a value.");
    // A reason stands behind "with" alike.
    let told = said(r"$\sqrt{(1, 2)} = 3$");
    assert_eq!(told, "Not checked: 1 chain with a vector that stands where a number is needed.");
    assert_eq!(said("$x = 4$ and $y = 5$"), "Not checked: 2 chains that only give a letter a value.");
}

#[test]
fn what_is_compared_as_a_statistic_is_not_unchecked() {
    let said = |text: &str| {
        let mut report = report(text, TextFormat::Latex);
        proofread::find_statistics(text, TextFormat::Latex).expect("a text").add_to(&mut report);
        let chains: Vec<String> = report.unchecked.into_iter().map(|chain| chain.chain).collect();
        (chains, summary::describe_unchecked_chains(&report.not_checked))
    };
    assert_eq!(said("It is $t(28) = 2.20$, $p = .36$."), (vec![], None));
    assert_eq!(said("It is $t(28) = 2.20$, $p = .036$ for men."), (vec![], None));
    // What stands beside it is unchecked as before.
    let (chains, told) = said("It is $t(28) = 2.20$, $p = .36$, and $x = 4$.");
    assert_eq!(chains, ["x = 4"]);
    assert_eq!(told.as_deref(), Some("Not checked: 1 chain that only gives a letter a value."));
    assert_eq!(said("It is $t(28) = 2.20$ in all.").0.len(), 1);
}

#[test]
fn what_stays_open_is_listed_as_unchecked() {
    let unchecked = |text: &str, format: TextFormat| {
        let options = CheckOptions { unchecked: true, ..CheckOptions::default() };
        let report = proofread(text, format, options).expect("a text");
        report.unchecked.into_iter().map(|chain| (chain.kind, chain.name)).collect::<Vec<_>>()
    };
    for text in [r"$$1^2 (0.8) + 2^2 (0.2) =4.8$$", r"$\log_{10}(100) = 6$"] {
        let found = unchecked(text, TextFormat::Markdown);
        assert!(found.iter().any(|(_, name)| name.starts_with("sides that may agree")), "{text}: {found:?}");
    }
    assert_eq!(unchecked("$2 + 2 = 4$", TextFormat::Markdown), []);
}
