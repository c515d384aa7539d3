//! The printed rise times against definitions, and against the law of similarity; the terms of the thesis.

use geneva_case1973::rise_times::{
    DefinitionTrial, EVENTS, Misread, OF_A_PART, RiseTolerance, Target, Whole, groups as all_groups, parts,
};
use geneva_documents::LEDGER;
use geneva_documents::meyer::runs::study::explained;
use geneva_documents::meyer::runs::table::rows;
use geneva_documents::meyer::terms::{MISSING, TERMS};
use geneva_press::html::{Cells, Table, escape, table};
use geneva_press::numbers::fixed;

/// How many rows each definition explains, with each part of a velocity that may be missing.
pub(super) fn definitions() -> anyhow::Result<Table> {
    let ways = OF_A_PART.iter().flat_map(|definition| {
        let own = move || explained().iter().filter(move |tried| tried.name == definition.name);
        let first = parts(MISSING)[0];
        own().filter(move |tried| tried.near.is_some_and(|near| near.part == first)).map(move |tried| {
            let way = tried.near.map(|near| (near.target, near.whole));
            own().filter(|tried| tried.near.map(|near| (near.target, near.whole)) == way).collect::<Vec<_>>()
        })
    });
    let rows = ways.map(|own: Vec<&DefinitionTrial>| {
        let ideal = own.iter().find(|tried| tried.near.is_some_and(|near| near.part == MISSING));
        let (name, of) = (own.first().map_or("", |tried| tried.name), own.first().and_then(|tried| tried.near));
        let mut row = vec![escape(name) + of.map_or("", whole)];
        row.extend(own.iter().map(|tried| tried.as_run.rows().to_string()));
        row.push(fixed(own.iter().map(|tried| tried.as_run.by_chance).fold(0.0, f64::max), 0));
        row.push(ideal.map_or_else(String::new, |tried| tried.ideal.rows().to_string()));
        Ok(row)
    });
    let part = |part: f64| format!("{}&nbsp;%", 100.0 * part);
    let parts = parts(MISSING).map(part);
    let ideal = format!("the mechanism, <br>{}", part(MISSING));
    let mut head = vec!["Time from rest until this quantity is near its steady value"];
    head.extend(parts.iter().map(String::as_str));
    head.extend(["by chance, <br>at most", &ideal]);
    let caption = "How many of the 49 printed rise times each definition explains, to within one unit of the last \
                   place. The columns headed by a percentage are for the program's runs, and the percentage says how \
                   far the quantity may still be from its steady value, as a part of this value unless the row names \
                   something else. One per cent of 100 rad/s is a unit of the tables. A printed value is the peak, the minimum or their \
                   mean as the table has them. The last two columns give the largest number that is expected by \
                   chance, and the number for the real mechanisms";
    table(caption, Cells::NamedNumbers, &head, rows)
}

/// What the difference is a part of, and from which value it is taken.
fn whole(near: RiseTolerance) -> &'static str {
    match (near.target, near.whole) {
        (Target::Computed, Whole::Itself) => "",
        (Target::Computed, Whole::TerminalVelocity) => " (a part of the average terminal velocity)",
        (Target::Computed, Whole::Units) => " (a part of 100 rad/s)",
        (Target::Printed, Whole::Itself) => " (from its printed value)",
        (Target::Printed, Whole::TerminalVelocity) => " (from its printed value, a part of the printed average)",
        (Target::Printed, Whole::Units) => " (from its printed value, a part of 100 rad/s)",
    }
}

/// How many rows each other event of a start explains.
pub(super) fn events() -> anyhow::Result<Table> {
    let rows =
        EVENTS.iter().filter_map(|event| explained().iter().find(|tried| tried.name == event.name)).map(|tried| {
            let mut row = vec![escape(tried.name), tried.as_run.rows().to_string()];
            row.extend(tried.as_run.within_one.map(|count| count.to_string()));
            row.push(fixed(tried.as_run.by_chance, 0));
            row.push(tried.ideal.rows().to_string());
            Ok(row)
        });
    let head = [
        "Time from rest until",
        "As run, <br>of 49",
        "six <br>pins",
        "four <br>pins",
        "three <br>pins",
        "by <br>chance",
        "The mechanism, <br>of 49",
    ];
    table(
        "How many printed rise times are explained if the rise ends at one of these events",
        Cells::NamedNumbers,
        &head,
        rows,
    )
}

/// The words of the thesis on which claims turn.
pub(super) fn terms() -> anyhow::Result<Table> {
    let rows = TERMS.iter().map(|term| {
        let used = LEDGER.claims().iter().filter(|claim| term.is_used_by(claim.id)).count();
        let meaning = escape(term.meaning);
        Ok(vec![escape(term.word), meaning, escape(term.rests_on), used.to_string()])
    });
    let head = ["Word", "Meaning", "Rests on", "Claims"];
    table(
        "Words of the thesis on which verdicts depend, each with one meaning for all claims",
        Cells::Words,
        &head,
        rows,
    )
}

/// Printed rise times times √K: equal within a group, were they defined by the motion alone.
pub(super) fn groups() -> anyhow::Result<Table> {
    let all = all_groups(rows());
    let rows = all.iter().map(|group| {
        let scaled: Vec<String> = group.scaled.iter().map(|time| format!("{:.1}", 1e3 * time)).collect();
        let possible = if group.possible { "yes" } else { "no" };
        let misread: Vec<String> = group.misread.iter().map(misread).collect();
        let misread = match (group.possible, misread.is_empty()) {
            (true, _) => "–".to_owned(),
            (false, true) => "no".to_owned(),
            (false, false) => misread.join("; or "),
        };
        let name = format!("{} pins, μ = {}", group.mechanism.pins(), group.friction);
        Ok(vec![name, scaled.join(", "), possible.to_owned(), misread])
    });
    let head = ["Rows", "1000 t √K, by rising K", "One number <br>for all?", "If not: for all <br>but one row?"];
    table(
        "Printed rise times t, in s, times the square root of K, in in·lb. By the law of similarity, all numbers of a \
         group should be equal. The last column names any row that may have been misread, with the range in which its \
         time should be",
        Cells::Words,
        &head,
        rows,
    )
}

/// A row that may be misread, and what it should have been.
fn misread(row: &Misread) -> String {
    let [low, high] = row.between.map(|time| format!("{time:.4}"));
    format!("K = {} ({low} to {high} s)", row.torque)
}
