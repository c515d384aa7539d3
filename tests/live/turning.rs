//! The designer on its page: does its wheel turn without a new drawing, by play button, keyboard and pointer; does a row of its
//! tolerances light up; and are drawing, numbers and controls on one screen?

use super::{browser, of, open, typed};
use crate::browser::devtools::Medium;
use geneva_ask::wheel::{SHAPE_FILES, WheelDesign, WheelQuestion};
use geneva_live::NUMBERS_FILE;
use serde_json::{Value, json};
use sha2::{Digest, Sha256};

const NAME: &str = "design";

/// The turns of wheel and plate, and what is said of them.
const TURNED: &str = "[f.querySelector('.wheel').getAttribute('transform'), f.querySelector('.plate').getAttribute('transform'), \
     f.querySelector('.turned').textContent, f.querySelectorAll('.contact').length]";

#[test]
fn the_drawing_turns_without_a_new_one_and_comes_back() {
    let Some(mut browser) = browser() else { return };
    browser.show_in([1280, 800], Medium::Light);
    open(&mut browser, "making", "");
    let still = of(&mut browser, NAME, "f.querySelector('svg').outerHTML");
    // The first answer draws; what follows only turns.
    of(&mut browser, NAME, &typed("crank", "10"));
    of(&mut browser, NAME, "f.querySelector('.wheel').kept = true");
    of(&mut browser, NAME, &typed("crank", "25"));
    of(&mut browser, NAME, &typed("larger", "20"));
    let turned = of(&mut browser, NAME, &format!("[f.querySelector('.wheel').kept, ...{TURNED}]"));
    assert_eq!(turned[0], json!(true), "it was drawn anew");
    let parts = geneva_live::by_name(NAME).expect("a figure");
    let settings = geneva_live::LiveArguments::parse("crank=25&larger=20").expect("arguments");
    let parts = parts.turned_parts(&settings).expect("an answer").expect("parts");
    let is_turned = |text: &Value, by: f64| {
        let told = text.as_str().and_then(|text| text.split("rotate(").nth(1)?.split(' ').next()?.parse::<f64>().ok());
        told.is_some_and(|told| (told - by).abs() < 1e-9)
    };
    assert!(is_turned(&turned[1], -parts.wheel) && is_turned(&turned[2], parts.driver), "{turned}");
    assert_eq!(turned[3], json!(parts.words));
    // What is to be seen is told to who doesn't see it.
    let told = of(&mut browser, NAME, "f.querySelector('svg desc').textContent");
    assert!(told.as_str().is_some_and(|told| told.ends_with(&parts.words)), "{told}");
    of(&mut browser, NAME, "g.querySelector('[data-do=reset]').click()");
    assert!(of(&mut browser, NAME, "f.querySelector('svg').outerHTML") == still, "it is not as at first again");
}

#[test]
fn play_turns_it_until_it_jams() {
    let Some(mut browser) = browser() else { return };
    browser.show_in([1280, 800], Medium::Light);
    let features = json!({ "features": [{ "name": "prefers-reduced-motion", "value": "no-preference" }] });
    browser.command("Emulation.setEmulatedMedia", features);
    open(&mut browser, "making", "#fig-wheel-dimensions?crank=-90&slot-direction-error=0.5&larger=10");
    let shown = of(
        &mut browser,
        NAME,
        "await (async () => { const play = g.querySelector('[data-do=play]'); f.scrollIntoView({ behavior: 'instant' }); \
         const fold = play.closest('details'); fold.querySelector('summary').click(); play.click(); const during = play.textContent; \
         await until(() => f.classList.contains('jams')); await settled(); return [during, play.textContent, \
         f.querySelector('.turned').textContent, Number(g.elements.crank.value), f.querySelectorAll('.contact').length, \
         [...g.querySelectorAll('.moved details')].filter(fold => fold.open).length] })()",
    );
    assert_eq!([&shown[0], &shown[1], &shown[4], &shown[5]], [&json!("Pause"), &json!("Play"), &json!(2), &json!(1)]);
    assert!(shown[2].as_str().is_some_and(|told| told.contains("It jams here")), "{shown}");
    assert!(shown[3].as_f64().is_some_and(|crank| (-90.0..0.0).contains(&crank)), "{shown}");
}

#[test]
fn the_wheel_is_dragged_within_its_play_by_pointer_and_by_keys() {
    let Some(mut browser) = browser() else { return };
    browser.show_in([1280, 800], Medium::Light);
    open(&mut browser, "making", "#fig-wheel-dimensions?larger=50");
    of(
        &mut browser,
        NAME,
        "g.querySelectorAll('details').forEach(fold => fold.open = fold.contains(g.elements.turned))",
    );
    // From the left half of the wheel, beside a slot, straight up and down: clockwise and counter-clockwise.
    let place = of(
        &mut browser,
        NAME,
        "(() => { f.scrollIntoView({ behavior: 'instant' }); const c = f.querySelector('.wheel').getBoundingClientRect(); \
         return [c.left + 0.3 * c.width, c.top + 0.38 * c.height] })()",
    );
    let at = |k: usize| place[k].as_f64().expect("a place");
    for (by, end, side) in [(-120.0, "-100", "backwards"), (240.0, "100", "forwards")] {
        for (kind, y) in [("mousePressed", 0.0), ("mouseMoved", by), ("mouseReleased", by)] {
            let event =
                json!({ "type": kind, "x": at(0), "y": at(1) + y, "button": "left", "buttons": 1, "clickCount": 1 });
            browser.command("Input.dispatchMouseEvent", event);
            of(&mut browser, NAME, "null");
        }
        let shown = of(&mut browser, NAME, &format!("[g.elements.turned.value, ...{TURNED}]"));
        assert_eq!([&shown[0], &shown[4]], [&json!(end), &json!(1)], "{shown}");
        assert!(shown[3].as_str().is_some_and(|told| told.contains(&format!("stopped {side}"))), "{shown}");
    }
    of(&mut browser, NAME, "g.elements.turned.focus()");
    browser.press("ArrowLeft", 37);
    let shown = of(&mut browser, NAME, &format!("[g.elements.turned.value, ...{TURNED}]"));
    assert_eq!([&shown[0], &shown[4]], [&json!("99"), &json!(0)], "{shown}");
}

/// Where a finger is put in a drawing: on the parts that are turned by hand, and beside them.
const FINGERS: &str = "(() => { f.scrollIntoView({ behavior: 'instant' }); const svg = f.querySelector('.drawing svg'); const box = \
     svg.getBoundingClientRect(), circle = svg.querySelector('.pin-circle').getBoundingClientRect(); const turns = (x, y) => f.dataset.hand ? \
     document.elementFromPoint(x, y).matches('.wheel') : Math.hypot(x - circle.left - circle.width / 2, y - circle.top - circle.height / 2) < \
     circle.width / 2; const places = []; for (let y = box.top + 8; y < box.bottom - 8; y += 6) { for (let x = box.left + 8; x < box.right - 8; \
     x += 6) { if (svg.contains(document.elementFromPoint(x, y))) { places.push([x, y, turns(x, y)]) } } } \
     const on = places.filter(([, , on]) => on), off = places.filter(([x, y]) => on.every(([a, b]) => Math.hypot(a - x, b - y) > \
     14)); return [on[Math.floor(on.length / 2)], off[0]] })()";

#[test]
fn a_finger_on_what_turns_moves_no_page_and_one_beside_it_does() {
    let Some(mut browser) = browser() else { return };
    browser.show_in([390, 844], Medium::Light);
    browser.command("Emulation.setTouchEmulationEnabled", json!({ "enabled": true, "maxTouchPoints": 1 }));
    for (name, page, control) in [(NAME, "making", "turned"), ("pin", "pin", "theta"), ("wheel", "jazar", "crank")] {
        let setting = if name == NAME { "#fig-wheel-dimensions?larger=50" } else { "" };
        open(&mut browser, page, setting);
        let places = of(&mut browser, name, FINGERS);
        let state = format!("[Math.round(scrollY), g.elements['{control}'].value]");
        let mut swipe = |place: &Value| {
            let before = of(&mut browser, name, &state);
            let [x, y] = [0, 1].map(|k| place[k].as_f64().unwrap_or_else(|| panic!("{name}: no place: {places}")));
            let touch = |kind: &str, y: Option<f64>| {
                let points: Vec<Value> = y.into_iter().map(|y| json!({ "x": x, "y": y })).collect();
                json!({ "type": kind, "touchPoints": points })
            };
            browser.command("Input.dispatchTouchEvent", touch("touchStart", Some(y)));
            for step in 1..=8 {
                browser.command("Input.dispatchTouchEvent", touch("touchMove", Some(y - 10.0 * f64::from(step))));
                of(&mut browser, name, "await new Promise(requestAnimationFrame)");
            }
            browser.command("Input.dispatchTouchEvent", touch("touchEnd", None));
            of(&mut browser, name, "await new Promise(requestAnimationFrame)");
            [before, of(&mut browser, name, &state)]
        };
        let [before, after] = swipe(&places[0]);
        assert_eq!(before[0], after[0], "{name}: the page moves with what turns: {places}");
        assert_ne!(before[1], after[1], "{name}: nothing turns: {places}");
        let [before, after] = swipe(&places[1]);
        assert_ne!(before[0], after[0], "{name}: a finger beside what turns does not move the page: {places}");
        assert_eq!(before[1], after[1], "{name}: something turns: {places}");
    }
}

#[test]
fn a_row_of_the_tolerances_lights_up_in_words_when_its_limit_is_passed() {
    let Some(mut browser) = browser() else { return };
    browser.show_in([1280, 800], Medium::Light);
    open(&mut browser, "making", "");
    of(
        &mut browser,
        NAME,
        "g.querySelectorAll('details').forEach(fold => fold.open = fold.contains(g.elements['slot-direction-error']))",
    );
    let row = "(() => { const row = [...f.querySelectorAll('.tolerances tr')].find(row => row.textContent.includes('slot out of \
               direction')); return [row.className, row.querySelector('.state').checkVisibility() && row.querySelector('.state').textContent, \
               row.cells[1].textContent] })()";
    assert_eq!(of(&mut browser, NAME, row), json!(["within", false, "–"]));
    of(&mut browser, NAME, &typed("slot-direction-error", "0.5"));
    assert_eq!(of(&mut browser, NAME, row), json!(["beyond", "limit passed", "0.500°"]));
    of(&mut browser, NAME, &typed("slot-direction-error", "0"));
    assert_eq!(of(&mut browser, NAME, row), json!(["within", false, "–"]));
}

#[test]
fn with_one_open_fold_drawing_numbers_and_controls_are_on_one_screen() {
    let Some(mut browser) = browser() else { return };
    browser.show_in([1280, 800], Medium::Light);
    open(&mut browser, "making", "");
    let shown = of(
        &mut browser,
        NAME,
        "await (async () => { const found = []; for (const fold of g.querySelectorAll('.moved details')) { \
         g.querySelectorAll('details').forEach(other => other.open = other === fold); \
         scrollTo({ top: f.getBoundingClientRect().top + scrollY - 55, behavior: 'instant' }); await new Promise(requestAnimationFrame); \
         for (const name of ['.drawing', '.results', '.moved']) { const { top, bottom } = f.querySelector(name).getBoundingClientRect(); \
         if (top < 50 || bottom > innerHeight) { found.push(`${fold.querySelector('summary').textContent}: ${name} ${top} to ${bottom}`) } } } \
         return found })()",
    );
    assert_eq!(shown, json!([]));
}

#[test]
fn on_a_phone_the_drawing_is_small_and_stays_beside_any_control() {
    let Some(mut browser) = browser() else { return };
    browser.show_in([390, 664], Medium::Light);
    open(&mut browser, "making", "");
    let shown = of(&mut browser, NAME, "[f.querySelector('.drawing svg').getBoundingClientRect().height, f.className]");
    assert!(shown[0].as_f64().is_some_and(|height| (160.0..=200.0).contains(&height)), "{shown}");
    assert!(shown[1].as_str().is_some_and(|class| class.contains("stays")), "{shown}");
}

#[test]
fn on_a_phone_the_drawing_has_no_dimensions_until_the_window_is_wide_and_numbers_out_of_sight_are_of_the_setting() {
    let Some(mut browser) = browser() else { return };
    browser.show_in([390, 664], Medium::Light);
    open(&mut browser, "making", "#fig-wheel-dimensions");
    of(&mut browser, NAME, &typed("crank-radius", "31"));
    let state = "[f.querySelectorAll('.drawing text').length, f.querySelector('.others').getBoundingClientRect().top > innerHeight, \
                 f.querySelector('output[name=crank-radius]').value]";
    assert_eq!(of(&mut browser, NAME, state), json!([0, true, "31.000 mm"]));
    browser.show_in([1280, 800], Medium::Light);
    let label = "until(() => [...f.querySelectorAll('.drawing text')].map(text => text.textContent).find(text => \
                 text.startsWith('crank radius')))";
    assert_eq!(of(&mut browser, NAME, &format!("await {label}")), json!("crank radius 31"));
}

#[test]
fn each_file_is_there_and_the_command_follows_the_setting() {
    let Some(mut browser) = browser() else { return };
    browser.show_in([1280, 800], Medium::Light);
    open(&mut browser, "making", "");
    of(&mut browser, NAME, &typed("stations", "8"));
    let command = of(&mut browser, NAME, "f.querySelector('.command').textContent");
    assert!(command.as_str().is_some_and(|command| command.starts_with("geneva wheel --stations 8 ")), "{command}");
    let loaded = "performance.getEntriesByType('resource').filter(({ name }) => name.includes('live-files')).length";
    assert_eq!(of(&mut browser, NAME, loaded), json!(0), "what makes files is loaded before the first one");
    let saved = of(
        &mut browser,
        NAME,
        "await (async () => { const saved = [], own = HTMLAnchorElement.prototype.click; let blob; const make = URL.createObjectURL; \
         URL.createObjectURL = of => { blob = of; return make(of) }; HTMLAnchorElement.prototype.click = function () { \
         saved.push([this.download, blob]) }; const files = [...f.querySelectorAll('[data-file]')]; for (const [at, file] of \
         files.entries()) { file.click(); await until(() => saved.length > at) } HTMLAnchorElement.prototype.click = own; \
         URL.createObjectURL = make; return Promise.all(saved.map(async ([name, blob]) => [name, [...new Uint8Array(await \
         crypto.subtle.digest('SHA-256', await blob.arrayBuffer()))]])) })()",
    );
    // The bytes are those of the command that the figure shows.
    let question = command.as_str().and_then(|command| command.strip_prefix("geneva wheel ")).expect("a command");
    let design = WheelDesign::new(WheelQuestion::parse(question).expect(question)).expect(question);
    let answer = design.answer().expect(question);
    let file = |name: &str| match SHAPE_FILES.iter().find(|file| file.name == name) {
        Some(file) => (file.make)(&design).expect(name),
        None if name == NUMBERS_FILE => answer.table().into_bytes(),
        None => answer.plain_sheet().into_bytes(),
    };
    let names = geneva_live::by_name(NAME).expect("a figure").files.iter().map(|file| file.name);
    let right = names.map(|name| json!([name, Sha256::digest(file(name)).as_slice()]));
    assert_eq!(saved, Value::Array(right.collect()));
}
