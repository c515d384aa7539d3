//! The printed rise times against definitions, and against the law of similarity; the terms of the thesis.

use geneva_case1973::rise_times::{
    DefinitionTrial, EVENTS, Misread, OF_A_PART, RiseTolerance, Target, TorqueGroup, Whole, groups as all_groups, parts,
};
use geneva_documents::LEDGER;
use geneva_documents::meyer::runs::study::explained;
use geneva_documents::meyer::runs::table::rows;
use geneva_documents::meyer::terms::{MISSING, TERMS};
use geneva_press::html::escape;
use geneva_press::numbers::fixed;
use geneva_press::table::{Cells, Table};

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
    let ways: Vec<Vec<&DefinitionTrial>> = ways.collect();
    let name = |own: &Vec<&DefinitionTrial>| {
        let (name, of) = (own.first().map_or("", |tried| tried.name), own.first().and_then(|tried| tried.near));
        escape(name) + of.map_or("", whole)
    };
    let is_ideal = |tried: &&&DefinitionTrial| tried.near.is_some_and(|near| near.part == MISSING);
    let per_cent = |part: f64| format!("{}&nbsp;%", 100.0 * part);
    let parts = parts(MISSING).into_iter().enumerate();
    Table::with_rows(Cells::NamedNumbers, ways)
        .column("Time from rest until this quantity is near its steady value", name)
        .columns(
            parts,
            |(_, part)| per_cent(*part),
            |own, (at, _)| own.get(*at).map_or_else(String::new, |tried| tried.as_run.rows().to_string()),
        )
        .column("by chance, <br>at most", |own| {
            fixed(own.iter().map(|tried| tried.as_run.by_chance).fold(0.0, f64::max), 0)
        })
        .column(format!("the mechanism, <br>{}", per_cent(MISSING)), |own| {
            own.iter().find(is_ideal).map_or_else(String::new, |tried| tried.ideal.rows().to_string())
        })
        .finish()
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
    let events = EVENTS.iter().filter_map(|event| explained().iter().find(|tried| tried.name == event.name));
    Table::with_rows(Cells::NamedNumbers, events)
        .column("Time from rest until", |tried| escape(tried.name))
        .column("As run, <br>of 49", |tried| tried.as_run.rows())
        .columns(
            ["six", "four", "three"].into_iter().enumerate(),
            |(_, pins)| format!("{pins} <br>pins"),
            |tried, (at, _)| tried.as_run.within_one[*at],
        )
        .column("by <br>chance", |tried| fixed(tried.as_run.by_chance, 0))
        .column("The mechanism, <br>of 49", |tried| tried.ideal.rows())
        .finish()
}

/// The words of the thesis on which claims turn.
pub(super) fn terms() -> anyhow::Result<Table> {
    Table::with_rows(Cells::Words, TERMS)
        .column("Word", |term| escape(term.word))
        .column("Meaning", |term| escape(term.meaning))
        .column("Rests on", |term| escape(term.rests_on))
        .column("Claims", |term| LEDGER.claims().iter().filter(|claim| term.is_used_by(claim.id)).count())
        .finish()
}

/// Printed rise times times √K: equal within a group, were they defined by the motion alone.
pub(super) fn groups() -> anyhow::Result<Table> {
    let scaled = |group: &TorqueGroup<'_>| {
        let times: Vec<String> = group.scaled.iter().map(|time| format!("{:.1}", 1e3 * time)).collect();
        times.join(", ")
    };
    let misread = |group: &TorqueGroup<'_>| match (group.possible, group.misread.is_empty()) {
        (true, _) => "–".to_owned(),
        (false, true) => "no".to_owned(),
        (false, false) => group.misread.iter().map(misread).collect::<Vec<_>>().join("; or "),
    };
    Table::with_rows(Cells::Words, all_groups(rows()))
        .column("Rows", |group| format!("{} pins, μ = {}", group.mechanism.pins(), group.friction))
        .column("1000 t √K, by rising K", scaled)
        .column("One number <br>for all?", |group| if group.possible { "yes" } else { "no" })
        .column("If not: for all <br>but one row?", misread)
        .finish()
}

/// A row that may be misread, and what it should have been.
fn misread(row: &Misread) -> String {
    let [low, high] = row.between.map(|time| format!("{time:.4}"));
    format!("K = {} ({low} to {high} s)", row.torque)
}
