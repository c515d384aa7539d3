//! Does the fold below a figure show the steps of the solution as the library writes them, for the numbers of its reader?

use super::{browser, of, open};
use crate::browser::devtools::Medium;
use geneva_live::LiveArguments;
use serde_json::json;

/// The steps of a figure at a setting, as a page shows them: each with its heading and its lines, without the signs of their
/// symbols, in which a colon stands before an index.
fn written(name: &str, query: &str) -> Vec<String> {
    let live = geneva_live::by_name(name).expect("a figure");
    let reply = live.answer(&LiveArguments::parse(query).expect("a query")).expect("an answer");
    let shown = |line: &str| {
        let parts = line.split(['{', '}']).enumerate();
        // Between a letter and its index stands what a copy has there.
        let indexed = |part: &str| part.replacen(':', "_", 1).replacen(':', "^", 1);
        parts.map(|(at, part)| if at % 2 == 1 { indexed(part) } else { part.to_owned() }).collect::<String>()
    };
    let step = |step: &geneva_ask::worked::WorkedStep| {
        let text = step.heading.to_owned() + &step.lines.iter().map(|line| shown(line)).collect::<String>();
        text.replace(char::is_whitespace, "")
    };
    reply.steps.iter().map(step).collect()
}

#[test]
fn the_fold_shows_the_steps_of_the_library_and_follows_what_is_set() {
    const STEPS: &str = "[...f.querySelectorAll('.worked li')].map(step => step.textContent.replace(/\\s+/g, ''))";
    let Some(mut browser) = browser() else { return };
    for (page, name, setting) in [
        ("pin", "pin", "radius=60&stations=5&theta=12&rpm=90"),
        ("quick-return", "polygon", "ground=200&radius=90&direction=40&rpm=30"),
    ] {
        browser.show(390, Medium::Light);
        open(&mut browser, page, &format!("#fig-live-{name}?{setting}"));
        let opened = format!(
            "(f.querySelector('.worked summary').click(), await new Promise(requestAnimationFrame), \
                             await new Promise(requestAnimationFrame), await settled(), {STEPS})"
        );
        let shown = of(&mut browser, name, &opened);
        assert_eq!(shown, json!(written(name, setting)), "{name}");
        // Another number, and one for which there are no steps.
        let (last, value) = setting.split('&').next_back().and_then(|last| last.split_once('=')).expect("a number");
        let (first, _) = setting.split_once('=').expect("a number");
        let set = |input: &str, value: &str, told: &str| {
            format!(
                "(g.elements.{input}.value = '{value}', g.elements.{input}.dispatchEvent(new Event('input', {{ bubbles: true }})), \
                 await settled(), {told})"
            )
        };
        let changed = of(&mut browser, name, &set(last, "77", STEPS));
        assert_eq!(
            changed,
            json!(written(name, &setting.replace(&format!("{last}={value}"), &format!("{last}=77")))),
            "{name}"
        );
        let refused = of(&mut browser, name, &set(first, "-1", "f.querySelector('.worked').hidden"));
        assert_eq!(refused, json!(true), "{name}: steps of another setting");
    }
}
