//! Which numbers are behind the figures, the verdicts and the sentences? They are pinned as text, with the drawings beside them.

use geneva_documents::LEDGER;
use geneva_press::{figures, placeholders};
use insta::{Settings, assert_snapshot};

/// Binds snapshots to `snapshots/<area>`, named without a module.
fn in_area(area: &str, pin: impl FnOnce()) {
    let mut settings = Settings::clone_current();
    settings.set_snapshot_path(crate::path("snapshots").join(area));
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    settings.bind(pin);
}

#[test]
fn the_figures_and_the_numbers_behind_them() {
    for (name, _) in figures::FIGURES {
        let figure = figures::by_name(name).expect("a figure");
        in_area("series", || assert_snapshot!(*name, figure.series.to_text()));
        in_area("drawings", || assert_snapshot!(*name, figure.svg));
    }
}

#[test]
fn what_a_reader_reads_for_each_placeholder() {
    for (page, text) in placeholders::readings(&crate::path("book/src")).expect("all are known") {
        in_area("pages", || assert_snapshot!(page, text));
    }
}

#[test]
fn the_verdicts() {
    let mut text = format!("{:<36} {:<17} {:>18} {:>18}\n", "claim", "verdict", "computed", "from rounded");
    for judged in LEDGER.verdicts() {
        // Eight digits: with tolerances ten times finer these are the same.
        let number = |number: Option<f64>| number.map_or_else(|| "-".to_owned(), |number| format!("{number:.7e}"));
        let (computed, rounded) = (number(judged.computed), number(judged.from_rounded));
        text.push_str(&format!("{:<36} {:<17} {computed:>18} {rounded:>18}\n", judged.claim.id, judged.verdict));
    }
    in_area("ledger", || assert_snapshot!("verdicts", text));
}

#[test]
fn how_each_form_was_found() {
    let mut text = String::new();
    for judged in LEDGER.verdicts().iter().filter(|judged| !judged.findings.is_empty()) {
        text.push_str(&format!("{}\n", judged.claim.id));
        for (role, finding) in &judged.findings {
            let says = if finding.holds { "holds" } else { "fails" };
            text.push_str(&format!("    {role} {says}: {}\n", finding.how));
        }
    }
    in_area("ledger", || assert_snapshot!("findings", text));
}

#[test]
fn the_controls_of_the_live_figures() {
    let mut text = String::new();
    for live in geneva_live::LIVE {
        text.push_str(&format!("{}\n", live.name));
        for of in live.controls {
            let [least, most] = of.range;
            text.push_str(&format!(
                "    {}: {}, {}, {} to {} by {}, typed {least} to {most}, at first {}, {:?} {:?}\n",
                of.name, of.label, of.unit, of.least, of.most, of.step, of.preset, of.kind, of.side
            ));
        }
        for preset in live.presets {
            text.push_str(&format!("    “{}”: {}\n", preset.name, preset.arguments));
        }
    }
    in_area("live", || assert_snapshot!("controls", text));
}
