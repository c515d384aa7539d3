//! Has a formula no holes? Measures signs and letters where the browser takes widths from the drawings in the font, and where
//! it takes them from the font's table of widths.

use super::address;
use super::devtools::{Browser, Letters, Medium};
use super::{PHONE, WIDE};
use serde_json::Value;

/// How much wider the second of two may be than the first: a letter alone and with what stands above or beside it; a low and
/// a tall bracket.
const PAIRS: [(&str, &str, f64); 4] = [
    ("<mi>P</mi>", "<msup><mi>P</mi><mo>′</mo></msup>", 1.7),
    ("<mi>v</mi>", "<mover accent='true'><mi>v</mi><mo stretchy='false'>⃗</mo></mover>", 1.5),
    (
        "<mo>(</mo><mi>x</mi><mo>)</mo>",
        "<mo>(</mo><mpadded height='2em' depth='2em'><mi>x</mi></mpadded><mo>)</mo>",
        1.3,
    ),
    (
        "<mo>[</mo><mi>x</mi><mo>]</mo>",
        "<mo>[</mo><mpadded height='2em' depth='2em'><mi>x</mi></mpadded><mo>]</mo>",
        1.3,
    ),
];

/// Signs of formulas, each with its two widths, that differ by more than rounding to whole pixels, and how many signs are shown.
const UNEVEN: &str = "(() => { document.querySelectorAll('main details').forEach(of => { of.open = true }); const signs = \
     [...document.querySelectorAll('main math :is(mi, mo, mn, mtext)')].filter(of => of.checkVisibility()); const widths = way => { \
     document.documentElement.style.textRendering = way; return signs.map(of => of.getBoundingClientRect().width) }; const \
     [drawn, exact] = ['auto', 'geometricPrecision'].map(widths); const uneven = signs.flatMap((sign, at) => \
     Math.abs(drawn[at] - exact[at]) > [...sign.textContent].length ? `${sign.textContent}: ${drawn[at]} px for ${exact[at]}` : \
     []); return [[...new Set(uneven)], signs.length] })()";

#[test]
fn a_sign_takes_no_more_room_than_it_needs() {
    for letters in [Letters::Exact, Letters::OnPixels] {
        let Some(mut browser) = Browser::start_with(letters) else { return };
        browser.show(WIDE, Medium::Light);
        browser.open(&format!("{}/pin.html", address(crate::book_pages::book())));
        for (first, second, most) in PAIRS {
            let widths = [first, second].map(|formula| {
                let width = browser.evaluate(&format!(
                    "{{ const place = document.createElement('p'); document.querySelector('main').append(place); \
                     place.innerHTML = `<math style='font-size: 100px'>${{{}}}</math>`; \
                     place.firstChild.getBoundingClientRect().width }}",
                    serde_json::json!(formula)
                ));
                width
                    .as_f64()
                    .filter(|width| *width > 10.0)
                    .unwrap_or_else(|| panic!("{formula} is not shown: {width}"))
            });
            let ratio = widths[1] / widths[0];
            assert!(ratio < most, "{letters:?}: {second} is {ratio:.2} times as wide as {first}, {widths:?}");
        }
    }
}

#[test]
fn formulas_are_as_wide_by_the_drawings_of_their_signs_as_by_the_table_of_widths() {
    let Some(mut browser) = Browser::start_with(Letters::OnPixels) else { return };
    browser.show(PHONE, Medium::Light);
    let (mut shown, mut found) = (0, Vec::new());
    for page in crate::book_pages::names() {
        browser.open(&format!("{}/{page}", address(crate::book_pages::book())));
        let uneven = browser.evaluate(UNEVEN);
        shown += uneven[1].as_u64().unwrap_or_default();
        found.extend(
            uneven[0].as_array().into_iter().flatten().filter_map(Value::as_str).map(|of| format!("{page}: {of}")),
        );
    }
    assert!(shown > 0 && found.is_empty(), "of {shown} signs:\n{}", found.join("\n"));
}
