//! Anybody can write an address: it moves controls within their ranges, and does nothing else.

use super::{PAGES, SETTLED, browser, of, open};
use crate::browser::devtools::{Browser, Medium};
use geneva_live::Control;
use serde_json::{Value, json};

/// Values that are no number, or none that a control can have, as they stand in an address: most of them broke something once.
const HOSTILE: [&str; 16] = [
    "70%26unit%3Dm%0A%0Acaption%0A%3Cimg%20src%3Dx%20onerror%3D%22document.title%3D'ran'%22%3E%3C!--",
    "1%26unit%3Dx%0A%0A%0A%3Cimg%20src=x%20onerror=document.title='ran'%3E",
    "%3Cscript%3Edocument.title='ran'%3C/script%3E",
    "%3Csvg%20onload=document.title='ran'%3E",
    "javascript:document.title='ran'",
    "1%26follower%3D1e-308",
    "90%26duration%3D1000",
    "1%261",
    "NaN",
    "Infinity",
    "1e300",
    "-1e300",
    "1e-300%00",
    "%0A%0A",
    "0x10",
    "1,5",
];

/// What the open page's figure shows, without the words about the address.
const SHOWN: &str = "[[...f.querySelectorAll('[name]')].map(of => of.value).join(), [...g.querySelectorAll('[data-box]')].map(of => \
                     of.value).join(), f.querySelector('.says').textContent, f.querySelector('svg').outerHTML]";

/// Opens addresses of a figure's page one after the other, and gives what the figure shows and says of each. The rest of the
/// page is not shown meanwhile: it would be laid out again for each.
fn visit(browser: &mut Browser, name: &str, figure: &str, settings: &[String]) -> Vec<Value> {
    let visited = of(
        browser,
        name,
        &format!(
            "(async () => {{ {SETTLED}; const others = of => of.matches('main') ? [] : [...[...of.parentElement.children].filter(one => \
             one !== of), ...others(of.parentElement)]; others(f).forEach(of => {{ of.hidden = true }}); const all = []; for (const setting of {}) {{ const before = location.href, \
             went = new Promise(done => addEventListener('hashchange', done, {{ once: true }})); \
             location.hash = '#fig-{figure}?' + setting; if (location.href !== before) {{ await went }} await \
             settled(); all.push({{ setting, shown: {SHOWN}, ignored: f.querySelector('.ignored').textContent, refused: \
             f.classList.contains('refused') }}) }} return all }})()",
            json!(settings)
        ),
    );
    visited.as_array().expect("a list").clone()
}

#[test]
fn no_value_in_an_address_does_anything_but_move_a_control_within_its_range() {
    let Some(mut browser) = browser() else { return };
    browser.show(1280, Medium::Light);
    for (name, page) in PAGES {
        let live = geneva_live::by_name(name).expect("a figure");
        open(&mut browser, page, "");
        let title = browser.evaluate("document.title");
        let first = of(&mut browser, name, SHOWN);
        // All controls at once, each with another value, and each alone.
        let all = |value: &dyn Fn(usize, &Control) -> String| {
            let of_each =
                live.controls.iter().enumerate().map(|(k, control)| format!("{}={}", control.name, value(k, control)));
            of_each.collect::<Vec<_>>().join("&")
        };
        let mut settings: Vec<String> =
            (0..HOSTILE.len()).map(|turn| all(&|k, _| HOSTILE[(turn + k) % HOSTILE.len()].to_owned())).collect();
        settings.push(all(&|_, control| (control.range[0] - 1.0).to_string()));
        settings.push(all(&|_, control| (control.range[1] + 1.0).to_string()));
        settings.push(all(&|_, control| format!("{}&{}={}", control.preset, control.name, control.preset)));
        let of_all = settings.len();
        for (k, control) in live.controls.iter().enumerate() {
            settings.push(format!("{}={}", control.name, HOSTILE[k % HOSTILE.len()]));
        }
        for given in live.given.iter().chain(&["onload", "innerHTML", "__proto__", ""]) {
            settings.push(format!("{given}=1"));
        }
        browser.events();
        for (k, visited) in visit(&mut browser, name, live.figure, &settings).into_iter().enumerate() {
            let told = visited["ignored"].as_str().unwrap_or_default();
            let named = told.matches('“').count();
            assert!(k >= of_all || named == live.controls.len(), "{name}: {} of {told}", visited["setting"]);
            assert!(told.contains("it was ignored"), "{name}: nothing is said of {}", visited["setting"]);
            assert!(visited["shown"] == first, "{name}: {} changes the figure", visited["setting"]);
        }
        assert_eq!(browser.evaluate("document.title"), title, "{name}: an address ran a script");
        let events = browser.events();
        let wrong = events.iter().find(|event| event["method"] == "Runtime.exceptionThrown");
        assert!(wrong.is_none(), "{name}: {wrong:#?}");
    }
}

#[test]
fn fuzz_addresses() {
    let Some(mut browser) = browser() else { return };
    browser.show(1280, Medium::Light);
    let setting = |name: &str, usual| std::env::var(name).ok().and_then(|text| text.parse().ok()).unwrap_or(usual);
    let mut random = fastrand::Rng::with_seed(setting("GENEVA_FUZZ_SEED", 1));
    for (name, page) in PAGES {
        let live = geneva_live::by_name(name).expect("a figure");
        let names: Vec<&str> =
            live.controls.iter().map(|control| control.name).chain(live.given.iter().copied()).collect();
        let mut one = || {
            let mut text = String::new();
            for _ in 0..random.usize(1..5) {
                match random.usize(..3) {
                    0 => text += &HOSTILE[random.usize(..HOSTILE.len())].replace('\'', "%27"),
                    1 => text += &format!("{:.2}", 400.0 * random.f64() - 200.0),
                    _ => text.extend(std::iter::repeat_with(|| random.char(' '..'\u{2100}')).take(4)),
                }
                text += [&format!("&{}=", names[random.usize(..names.len())]), "=", "&", "?", "#", "%", ""]
                    [random.usize(..7)];
            }
            format!("{}={text}", names[random.usize(..names.len())])
        };
        let settings: Vec<String> = (0..setting("GENEVA_FUZZ", 100).div_ceil(5)).map(|_| one()).collect();
        open(&mut browser, page, "");
        let title = browser.evaluate("document.title");
        for visited in visit(&mut browser, name, live.figure, &settings) {
            let drawing = visited["shown"][3].as_str().unwrap_or_default();
            assert!(drawing.starts_with("<svg") && !drawing.contains("NaN"), "{name}: {}", visited["setting"]);
            assert!(!visited["shown"].to_string().contains("onerror"), "{name}: {}", visited["setting"]);
        }
        assert_eq!(browser.evaluate("document.title"), title, "{name}");
        let events = browser.events();
        let wrong = events.iter().find(|event| event["method"] == "Runtime.exceptionThrown");
        assert!(wrong.is_none(), "{name}: {wrong:#?}");
    }
}

#[test]
fn the_addresses_that_ran_scripts_and_the_one_that_froze_open_the_figure_as_at_first() {
    let Some(mut browser) = browser() else { return };
    browser.show(1280, Medium::Light);
    for (name, page, setting) in [
        ("polygon", "quick-return", format!("crank={}", HOSTILE[0])),
        ("polygon", "quick-return", format!("factor=2{}", &HOSTILE[1][1..])),
        ("escapement", "escapement", "friction=0.16%26follower%3D1e-308".to_owned()),
        ("mistake", "mistake", "late=1&reset=90%26duration%3D1000".to_owned()),
    ] {
        let live = geneva_live::by_name(name).expect("a figure");
        open(&mut browser, "about", "");
        open(&mut browser, page, &format!("#fig-{}?{setting}", live.figure));
        let shown = of(
            &mut browser,
            name,
            "[document.title, f.querySelector('.ignored').textContent, f.querySelectorAll('img, script').length, \
             f.classList.contains('refused')]",
        );
        assert!(!shown[0].as_str().is_some_and(|title| title.contains("ran")), "{page} {setting}");
        assert!(shown[1].as_str().is_some_and(|told| told.contains("was ignored")), "{page} {setting}: {shown}");
        assert_eq!([&shown[2], &shown[3]], [&json!(0), &json!(false)], "{page} {setting}");
    }
}

#[test]
fn own_links_open_again() {
    let Some(mut browser) = browser() else { return };
    browser.show(1280, Medium::Light);
    for (name, page, control, typed) in [
        ("escapement", "escapement", "torque", "3e+2"),
        ("wheel", "jazar", "error", "1e-1"),
        ("design", "making", "pin-diameter", ""),
    ] {
        open(&mut browser, page, "");
        of(&mut browser, name, &super::typed(control, typed));
        let shown = of(&mut browser, name, &format!("[g.querySelector('[data-do=link]').hash, {SHOWN}]"));
        open(&mut browser, "about", "");
        open(&mut browser, page, shown[0].as_str().expect("a link"));
        let again = of(&mut browser, name, &format!("[f.querySelector('.ignored').textContent, {SHOWN}]"));
        assert_eq!(again[0], json!(""), "{name} {}", shown[0]);
        assert!(again[1][2] == shown[1][2] && again[1][3] == shown[1][3], "{name} {}", shown[0]);
    }
}
