//! Is what a reader moves the same as what is tested? Compares the module in the page with the library on this machine, and
//! moves the controls by keyboard, pointer and address.

mod addresses;
mod covered;
pub(crate) mod module;
mod presets;
mod steps;
mod turning;

use crate::browser::devtools::{Browser, Medium};
use geneva_chapters::figures;
use geneva_live::LIVE;
use serde_json::{Value, json};

/// The pages that show the figures.
const PAGES: [(&str, &str); 6] = [
    ("pin", "pin"),
    ("wheel", "jazar"),
    ("design", "making"),
    ("polygon", "quick-return"),
    ("mistake", "mistake"),
    ("escapement", "escapement"),
];

/// Whether the book's figures move. They stand still where their module cannot be compiled; with `$LIVE_REQUIRED` that is a
/// fault.
pub(crate) fn moves() -> bool {
    let moves = crate::book_pages::book().join("data/live-module.js").is_file();
    assert!(moves || std::env::var_os("LIVE_REQUIRED").is_none(), "the figures of the book stand still");
    if !moves {
        eprintln!("skipped: the figures of this book stand still, for their module is not compiled here");
    }
    moves
}

/// A browser, if there is one and something moves.
fn browser() -> Option<Browser> {
    if moves() { Browser::start() } else { None }
}

fn page_text(page: &str) -> String {
    std::fs::read_to_string(crate::book_pages::book().join(format!("{page}.html"))).expect("a page")
}

/// What the figure of a page is given with each question.
fn given_on(page: &str) -> String {
    let page = page_text(page);
    let given = page.split("data-given=\"").nth(1).and_then(|rest| rest.split('"').next()).expect("what is given");
    given.replace("&amp;", "&")
}

fn open(browser: &mut Browser, page: &str, rest: &str) {
    browser.open(&format!("file://{}/{page}.html{rest}", crate::book_pages::book().display()));
}

/// What a figure of the open page is given with each question.
fn given(browser: &mut Browser, name: &str) -> String {
    let given = browser.evaluate(&format!("document.querySelector('[data-live={name}]').dataset.given"));
    given.as_str().expect("a figure").to_owned()
}

/// Settings all over the range of a figure: each control at five places with the others as at first, and the presets.
fn grid(name: &str) -> Vec<String> {
    let live = geneva_live::by_name(name).expect("a figure");
    let mut settings: Vec<String> = live.presets.iter().map(|preset| preset.arguments.to_owned()).collect();
    for control in live.controls {
        for part in 0..=4 {
            let value = control.least + (control.most - control.least) * f64::from(part) / 4.0;
            let value = (value / control.step).round() * control.step;
            settings.push(format!("{}={value}", control.name));
        }
    }
    settings
}

#[test]
fn every_figure_that_moves_is_on_its_page_and_stands_still_as_at_first() {
    let shown: Vec<&str> = PAGES.iter().map(|(name, _)| *name).collect();
    assert_eq!(LIVE.map(|live| live.name).to_vec(), shown);
    let Some(mut browser) = browser() else { return };
    for (name, page) in PAGES {
        open(&mut browser, page, "");
        let figure = figures::by_name(geneva_live::by_name(name).expect("a figure").figure).expect("a figure");
        // Both as the browser reads them.
        let still = format!(
            "f.querySelector('.drawing').innerHTML.trim() === (() => {{ const d = document.createElement('div'); \
                             d.innerHTML = {}; return d.innerHTML }})()",
            json!(figure.svg.trim_end())
        );
        assert_eq!(of(&mut browser, name, &still), json!(true), "{name} is not as at first on {page}");
    }
}

#[test]
fn the_module_in_the_page_gives_the_same_characters_as_the_library() {
    let Some(mut browser) = browser() else { return };
    browser.show(1280, Medium::Light);
    for (name, page) in PAGES {
        open(&mut browser, page, "");
        let given = given(&mut browser, name);
        // A few of those that run the program itself to the end are enough: each takes its time.
        let settings = grid(name);
        let wrong = [format!("{}=x", LIVE.iter().find(|live| live.name == name).expect("one").controls[0].name)];
        for setting in settings.iter().chain(&wrong) {
            let question = format!("{name}?{given}&{setting}");
            loop {
                let answer = geneva_live::answer(&question);
                let theirs = browser.evaluate(&format!("genevaLive({})", json!(question)));
                assert!(theirs.as_str() == Some(&answer), "{name}?{setting} is answered otherwise in the page");
                if !answer.contains("\"progress\":{") || !setting.contains("late=1") {
                    break;
                }
            }
        }
    }
}

/// The value of an expression about a figure's element `f` and its form `g`.
fn of(browser: &mut Browser, name: &str, expression: &str) -> Value {
    browser.evaluate(&format!(
        "(async () => {{ const f = document.querySelector('[data-live={name}]'), g = f.querySelector('form'); {SETTLED}; await \
         settled(); return {expression} }})()"
    ))
}

/// A function that waits until a figure `f` shows what it is set to.
const SETTLED: &str = "const settled = () => until(() => !f.matches('[aria-busy]'))";

#[test]
fn a_slider_goes_by_arrow_keys_and_the_page_stays() {
    let Some(mut browser) = browser() else { return };
    browser.show(1280, Medium::Light);
    open(&mut browser, "jazar", "");
    let before = of(&mut browser, "wheel", "[g.elements.crank.value, f.querySelector('svg').outerHTML]");
    of(&mut browser, "wheel", "g.elements.crank.focus()");
    browser.press("ArrowRight", 39);
    let after =
        of(&mut browser, "wheel", "[g.elements.crank.value, f.querySelector('svg').outerHTML, location.pathname]");
    assert_eq!([&before[0], &after[0]], [&json!("-30"), &json!("-29.5")]);
    assert!(before[1] != after[1], "the drawing stays as it was");
    assert!(after[2].as_str().is_some_and(|path| path.ends_with("/jazar.html")), "{after}");
    // Reset brings the still figure back.
    let reset = of(
        &mut browser,
        "wheel",
        "(g.querySelector('[data-do=reset]').click(), await settled(), f.querySelector('svg').outerHTML)",
    );
    assert!(reset == before[1], "the still figure is not back");
}

#[test]
fn a_number_beyond_the_slider_is_computed_or_refused_as_at_the_command_line() {
    let Some(mut browser) = browser() else { return };
    browser.show(1280, Medium::Light);
    open(&mut browser, "jazar", "");
    of(&mut browser, "wheel", &typed("stations", "30"));
    let title = of(&mut browser, "wheel", "f.querySelector('svg title').textContent");
    assert!(title.as_str().is_some_and(|title| title.contains("30 stations")), "{title}");
    let message = "f.querySelector('.message').textContent";
    of(&mut browser, "wheel", &typed("pins", "40"));
    let refused = geneva_kinematics::wheel::Wheel::with_pins(30, 40).expect_err("too many").to_string();
    assert_eq!(of(&mut browser, "wheel", message), json!(refused));
    of(&mut browser, "wheel", &typed("stations", "2"));
    assert_eq!(of(&mut browser, "wheel", message), json!("stations N 2: give 3 to 100"));
}

/// Controls that cannot be seen together with the whole drawing and the numbers. A reader has opened its fold, scrolled to the
/// figure and then to the control if it is not in sight, and moves it once the page's bar stands still: nothing of the three may be
/// outside the window, under its bar or under another. In place of the numbers a refusal has its words. Not all browsers scroll to keep a
/// control where it is if the drawing above it grows, so this one doesn't.
const APART: &str = "(async () => { document.documentElement.style.overflowAnchor = 'none'; const found = []; const bar = \
     document.querySelector('#mdbook-menu-bar'); for (const input of g.querySelectorAll('.moved input[name], .moved select')) { \
     if (f.classList.contains('refused')) { g.querySelector('[data-do=reset]').click(); await settled() } \
     g.querySelectorAll('details').forEach(fold => fold.open = fold.contains(input)); const inside = input.closest('.inside'); \
     if (inside) { inside.scrollTop += input.getBoundingClientRect().top - inside.getBoundingClientRect().top - 60 } \
     const label = input.labels[0], box = g.querySelector(`[data-box=${input.name}]`) ?? input; \
     const end = Math.max(...[label, input, box].map(of => of.getBoundingClientRect().bottom)); \
     const figure = f.getBoundingClientRect().top - 60; \
     scrollBy({ top: Math.max(figure, end - innerHeight + 6), behavior: 'instant' }); \
     for (let k = 0; k < 4; k++) { await new Promise(requestAnimationFrame) } \
     input.dispatchEvent(new Event('input', { bubbles: true })); await settled(); await new Promise(requestAnimationFrame); \
     const isHit = of => { const { left, right, top, bottom } = of.getBoundingClientRect(); const hit = \
     document.elementFromPoint((left + right) / 2, (top + bottom) / 2); return top >= 0 && bottom <= innerHeight && (hit === of || of.contains(hit)) }; \
     const from = Math.max(bar.getBoundingClientRect().bottom, 0); \
     const results = f.classList.contains('refused') ? f.querySelector('.message') : f.querySelector('.results'); \
     for (const [of, name] of [[f.querySelector('svg'), 'drawing'], [results, 'numbers']]) { \
     const { top, bottom } = of.getBoundingClientRect(); if (top < from - 1 || bottom > innerHeight + 1) { \
     found.push(`${input.name}: ${name} ${Math.round(top)} to ${Math.round(bottom)}`) } } \
     for (const of of [label, input, box]) { if (!isHit(of)) { found.push(`${input.name} is covered`) } } } return found })()";

#[test]
fn drawing_numbers_and_the_control_in_use_share_a_screen() {
    let Some(mut browser) = browser() else { return };
    // The last is a phone whose browser shows its own bars.
    for window in [[390, 844], [1280, 800], [390, 664]] {
        browser.show_in(window, Medium::Light);
        for (name, page) in PAGES {
            open(&mut browser, page, "");
            let apart = of(&mut browser, name, &format!("await {APART}"));
            assert_eq!(apart, json!([]), "{name} at {window:?}");
        }
    }
}

/// Types a number into the box of a control.
fn typed(name: &str, value: &str) -> String {
    format!(
        "(() => {{ const box = g.querySelector('[data-box={name}]') ?? g.elements['{name}']; box.value = '{value}'; box.dispatchEvent(new \
         Event('input', {{ bubbles: true }})) }})()"
    )
}

#[test]
fn a_figure_in_which_nothing_turns_has_nothing_to_play() {
    for (name, page) in PAGES {
        let plays = geneva_live::by_name(name)
            .expect("a figure")
            .controls
            .iter()
            .any(|control| matches!(control.kind, geneva_live::ControlKind::Player(_)));
        assert_eq!(page_text(page).contains("data-do=\"play\""), plays && moves(), "{name}");
    }
}

#[test]
fn a_refused_setting_leaves_no_number_of_another_one() {
    let Some(mut browser) = browser() else { return };
    browser.show(1280, Medium::Light);
    open(&mut browser, "making", "");
    let shown = "[[...f.querySelectorAll('output')].map(o => o.value).join(), f.querySelector('svg').outerHTML, \
                 f.querySelector('.stale').checkVisibility(), f.querySelector('.message').textContent, \
                 [...new Set([...f.querySelectorAll('[data-file]')].map(file => file.disabled))].join()]";
    let first = of(&mut browser, "design", shown);
    assert_eq!([&first[2], &first[3], &first[4]], [&json!(false), &json!(""), &json!("false")]);
    of(&mut browser, "design", &typed("pin-diameter", "60"));
    let refused = of(&mut browser, "design", shown);
    assert!(refused[0].as_str().is_some_and(|told| told.split(',').all(|number| number == "–")), "{refused}");
    assert!(refused[1] == first[1] && refused[2] == json!(true), "it is not said whose drawing it is");
    assert!(refused[3].as_str().is_some_and(|why| why.contains("Give “diameter of a pin” up to")), "{}", refused[3]);
    // There is nothing to draw a file of, and the page says so.
    assert_eq!(refused[4], json!("true"));
    let stale = of(&mut browser, "design", "f.querySelector('.stale').textContent");
    assert!(stale.as_str().is_some_and(|told| told.contains("no files for this setting")), "{stale}");
    of(&mut browser, "design", "g.querySelector('[data-do=reset]').click()");
    assert!(of(&mut browser, "design", shown) == first, "not as at first again");
}

#[test]
fn pin_and_play_follow_the_library_until_they_are_moved() {
    use geneva_kinematics::wheel::{Choices, Scale, Sizes, Wheel};
    let Some(mut browser) = browser() else { return };
    browser.show(1280, Medium::Light);
    open(&mut browser, "making", "");
    let by_default = |stations: u32| {
        let wheel = Wheel::new(stations).expect("possible");
        Sizes::new(wheel, Scale::CrankRadius(25.0), &Choices::default()).expect("it fits")
    };
    let boxes =
        "[g.querySelector('[data-box=pin-diameter]').value, g.querySelector('[data-box=play]').value].map(Number)";
    for stations in [6, 4, 12] {
        of(&mut browser, "design", &typed("stations", &stations.to_string()));
        let sizes = by_default(stations);
        let (told, right) = (of(&mut browser, "design", boxes), [sizes.pin_diameter, sizes.play.slot]);
        for (k, right) in right.into_iter().enumerate() {
            assert!((told[k].as_f64().expect("a number") - right).abs() < 6e-5, "{stations}: {told}, {right}");
        }
    }
    // A number between two steps of the slider, and one beyond its end.
    of(&mut browser, "design", &typed("pin-diameter", "6.25"));
    of(&mut browser, "design", &typed("stations", "25"));
    let told =
        of(&mut browser, "design", "[f.querySelector('svg desc').textContent, g.querySelector('[data-do=link]').hash]");
    assert!(told[0].as_str().is_some_and(|told| told.contains("pins 6.25 mm in diameter")), "{told}");
    assert!(
        told[1].as_str().is_some_and(|hash| hash.contains("stations=25&") && hash.contains("pin-diameter=6.25&play=&")),
        "{told}"
    );
}

#[test]
fn the_crank_follows_the_lever_and_the_lever_follows_the_crank() {
    let Some(mut browser) = browser() else { return };
    browser.show(1280, Medium::Light);
    open(&mut browser, "quick-return", "");
    let state = "[...['crank', 'lever'].map(name => Number((g.querySelector(`[data-box=${name}]`) ?? g.elements[name]).value)), \
                 g.elements.branch.value, f.querySelector('output[name=lever-acceleration]').value, \
                 g.querySelector('[data-do=link]').hash]";
    let first = of(&mut browser, "polygon", state);
    for (name, value) in [("ground", "0.28"), ("radius", "0.12"), ("rpm", "60"), ("lever", "18")] {
        of(&mut browser, "polygon", &typed(name, value));
    }
    let far = of(&mut browser, "polygon", state);
    // θ = φ + β − 180°, with β = asin(l sin φ / R).
    let beta = (0.28 * 18_f64.to_radians().sin() / 0.12).asin().to_degrees();
    let crank = |told: &Value| told[0].as_f64().expect("an angle");
    approx::assert_abs_diff_eq!(crank(&far), 18.0 + beta - 180.0, epsilon = 1e-4);
    assert_eq!([&far[1], &far[2], &far[3]], [&json!(18), &json!("0"), &json!("−5.123 rad/s²")]);
    assert!(
        far[4].as_str().is_some_and(|hash| hash.contains("crank=&direction=&lever=18&branch=0&ground=0.28")),
        "{far}"
    );
    of(
        &mut browser,
        "polygon",
        "(g.elements.branch.value = 1, g.elements.branch.dispatchEvent(new Event('input', { bubbles: true })))",
    );
    let near = of(&mut browser, "polygon", state);
    assert_eq!([&near[1], &near[2], &near[3]], [&json!(18), &json!("1"), &json!("−35.59 rad/s²")]);
    approx::assert_abs_diff_eq!(crank(&near), 18.0 - beta, epsilon = 1e-4);
    // The link opens the same setting, from which the crank takes over.
    open(&mut browser, "about", "");
    open(&mut browser, "quick-return", near[4].as_str().expect("a link"));
    assert_eq!(of(&mut browser, "polygon", state), near);
    of(&mut browser, "polygon", &typed("crank", "-90"));
    let turned = of(&mut browser, "polygon", state);
    let lever = (0.12_f64 / 0.28).atan().to_degrees();
    approx::assert_abs_diff_eq!(turned[1].as_f64().expect("an angle"), lever, epsilon = 1e-4);
    assert_eq!(turned[2], json!("0"));
    assert!(turned[4].as_str().is_some_and(|hash| hash.contains("crank=-90&direction=&lever=&branch=&")), "{turned}");
    of(&mut browser, "polygon", "g.querySelector('[data-do=reset]').click()");
    let reset = of(&mut browser, "polygon", state);
    // All but the link, which the page begins without a setting.
    for k in 0..4 {
        assert_eq!(reset[k], first[k]);
    }
}

#[test]
fn a_link_carries_the_setting_and_the_pointer_turns_the_crank() {
    let Some(mut browser) = browser() else { return };
    browser.show(1280, Medium::Light);
    open(&mut browser, "jazar", "#fig-live-wheel?stations=7&error=1&crank=-20");
    let told =
        of(&mut browser, "wheel", "[f.querySelector('svg title').textContent, g.querySelector('[data-do=link]').hash]");
    assert!(
        told[0].as_str().is_some_and(|title| title.contains("7 stations") && title.contains("1.00 % too far")),
        "{told}"
    );
    assert!(told[1].as_str().is_some_and(|hash| hash.contains("stations=7") && hash.contains("error=1")), "{told}");
    // The right end of the pin's circle is half a turn from the line of centres.
    let place = of(
        &mut browser,
        "wheel",
        "(() => { const c = f.querySelector('.pin-circle').getBoundingClientRect(); return [c.right - 2, (c.top + c.bottom) / 2, \
         (c.left + c.right) / 2, c.top + 2] })()",
    );
    let at = |k: usize| place[k].as_f64().expect("a place");
    for (kind, x, y) in [("mousePressed", at(0), at(1)), ("mouseMoved", at(2), at(3)), ("mouseReleased", at(2), at(3))]
    {
        let event = json!({ "type": kind, "x": x, "y": y, "button": "left", "buttons": 1, "clickCount": 1 });
        browser.command("Input.dispatchMouseEvent", event);
    }
    assert_eq!(of(&mut browser, "wheel", "await until(() => g.elements.crank.value === '90')"), json!(true));
}

#[test]
fn what_plays_can_be_paused_and_makes_steps_for_who_wants_less_motion() {
    let Some(mut browser) = browser() else { return };
    browser.show(1280, Medium::Light);
    open(&mut browser, "jazar", "#fig-live-wheel?crank=0");
    // The page's clock goes on by 50 ms when the test says so, however long that takes.
    const CLOCK: &str = "const own = requestAnimationFrame; let clock = 1e6; globalThis.requestAnimationFrame = run => own(() => run(clock)); \
         const tick = async () => { clock += 50; await new Promise(done => own(done)); seen.add(g.elements.crank.value) }";
    let values = |browser: &mut Browser, ticks: &str| {
        of(
            browser,
            "wheel",
            &format!(
                "(async () => {{ const play = g.querySelector('[data-do=play]'), seen = new Set([g.elements.crank.value]); {CLOCK}; \
                 play.click(); {ticks}; const during = play.textContent; play.click(); await settled(); seen.add(g.elements.crank.value); \
                 const played = seen.size; for (let k = 0; k < 30; k++) {{ await tick() }} globalThis.requestAnimationFrame = own; \
                 return [played, during, play.textContent, seen.size === played] }})()"
            ),
        )
    };
    let wanted = |browser: &mut Browser, motion: &str| {
        let features = json!({ "features": [{ "name": "prefers-reduced-motion", "value": motion }] });
        browser.command("Emulation.setEmulatedMedia", features);
    };
    wanted(&mut browser, "no-preference");
    let smooth = values(&mut browser, "await until(async () => { await tick(); return seen.size > 20 })");
    assert_eq!([&smooth[1], &smooth[2], &smooth[3]], [&json!("Pause"), &json!("Play"), &json!(true)], "{smooth}");
    wanted(&mut browser, "reduce");
    // One step in a second: the first frame starts the clock, and two seconds and a half are left.
    let stepped = values(&mut browser, "for (let k = 0; k < 51; k++) { await tick(); await settled() }");
    assert_eq!(stepped, json!([3, "Pause", "Play", true]));
}

#[test]
fn what_may_jam_stops_says_why_and_plays_no_more_until_it_may_turn() {
    let Some(mut browser) = browser() else { return };
    browser.show(1280, Medium::Light);
    let features = json!({ "features": [{ "name": "prefers-reduced-motion", "value": "no-preference" }] });
    browser.command("Emulation.setEmulatedMedia", features);
    open(&mut browser, "escapement", "");
    let shown = of(
        &mut browser,
        "escapement",
        "await (async () => { const play = g.querySelector('[data-do=play]'), share = g.elements.share; \
         const turns = async () => { const before = share.value; await until(() => share.value !== before); return true }; \
         f.scrollIntoView({ behavior: 'instant' }); play.click(); await turns(); \
         [...g.querySelectorAll('[data-set]')].find(of => of.textContent.includes('may jam')).click(); await settled(); \
         const message = f.querySelector('.message').textContent, stopped = play.textContent, before = share.value; \
         play.click(); await new Promise(requestAnimationFrame); const still = play.textContent === 'Play' && share.value === before; \
         g.querySelector('[data-do=reset]').click(); await settled(); play.click(); await turns(); \
         const again = play.textContent; play.click(); await settled(); return [stopped, still, again, message] })()",
    );
    assert_eq!([&shown[0], &shown[1], &shown[2]], [&json!("Play"), &json!(true), &json!("Pause")], "{shown}");
    assert!(shown[3].as_str().is_some_and(|why| why.contains("may jam there, so nothing plays")), "{shown}");
}

#[test]
fn pages_without_a_figure_that_moves_load_nothing_of_it() {
    if !moves() {
        return;
    }
    for page in crate::book_pages::names() {
        let text = page_text(page.trim_end_matches(".html"));
        let moves = PAGES.iter().any(|(_, own)| page == format!("{own}.html"));
        assert_eq!(text.contains("data/live.js"), moves, "{page}");
    }
}

#[test]
fn the_mistake_is_scored_as_the_ledger_scores_it() {
    use geneva_case1973::{Hypothesis, SixPin};
    use geneva_documents::meyer::runs::study::scores;
    let given = given_on("mistake");
    let headed = Hypothesis { six_pin: SixPin::AsHeaded, ..Hypothesis::WITHOUT_LAG };
    for (setting, hypothesis) in [
        ("own=1&late=0", Hypothesis::IDEAL),
        ("late=0", Hypothesis::WITHOUT_LAG),
        ("late=0&six=0", headed),
        ("", Hypothesis::AS_RUN),
    ] {
        let answer: Value = loop {
            let answer = geneva_live::answer(&format!("mistake?{given}&{setting}"));
            let answer: Value = serde_json::from_str(&answer).expect("JSON");
            if answer["progress"].is_null() {
                break answer;
            }
        };
        let number = |name: &str| -> f64 {
            let all = answer["numbers"].as_array().expect("numbers");
            let number = all.iter().find(|number| number["name"] == name).expect("a number");
            number["value"].as_f64().expect("a finite number")
        };
        let score = scores().iter().find(|score| score.hypothesis == hypothesis).expect("compared");
        assert_eq!(number("agree"), score.within_one() as f64, "{setting}");
        // The program's quarter turn has four digits behind the point, the slider's is exact.
        for (name, log) in ["normal", "exponential"].into_iter().zip(score.likelihoods()) {
            approx::assert_abs_diff_eq!(number(name), log, epsilon = 0.1);
        }
    }
}
