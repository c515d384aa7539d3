//! Is what a reader checks in a page what this program finds, to the letter, whatever characters are put in?

use crate::browser::devtools::{Browser, Medium};
use crate::live::module::{module, served};
use fastrand::Rng;
use geneva_documents::LEDGER;
use geneva_evidence::MOST_CHARACTERS;
use serde_json::{Value, json};

/// The module is loaded at the first touch; these are its bytes, and what is loaded with it.
const MODULE: &str = "data/verify-module.js";
const HEAVIEST_MODULE: usize = 2_200_000;
const HEAVIEST_PACKED: usize = 830_000;
/// What each page loads before the first touch.
const HEAVIEST_SCRIPT: usize = 3_000;

/// Whether claims can be checked in the pages. With `$LIVE_REQUIRED` it is a fault if they cannot.
fn is_live() -> bool {
    let is_live = crate::book_pages::book().join(MODULE).is_file();
    assert!(is_live || std::env::var_os("LIVE_REQUIRED").is_none(), "no claim can be checked in the pages");
    is_live
}

/// A browser with a page open, if there is one and claims can be checked in it.
fn opened(page: &str) -> Option<Browser> {
    let mut browser = if is_live() { Browser::start()? } else { return None };
    browser.show(1280, Medium::Light);
    open(&mut browser, page);
    Some(browser)
}

fn open(browser: &mut Browser, page: &str) {
    browser.open(&format!("file://{}/{page}", crate::book_pages::book().display()));
}

/// The parts of the page, and what a reader does with them.
const TOOLS: &str = "const box = () => document.querySelector('dialog.verify'), status = () => \
     box()?.querySelector('.status').textContent ?? '', settled = () => until(() => box() && !box().hasAttribute('aria-busy') && \
     /Derived|no answer|Nothing/.test(status())), field = () => box().querySelector('textarea'), lines = () => \
     Object.fromEntries([...box().querySelectorAll('dt')].map(of => [of.textContent, of.nextElementSibling.textContent])), \
     put = async text => { const before = status(); field().value = text; field().dispatchEvent(new Event('input')); await until(() => \
     box().hasAttribute('aria-busy') || status() !== before); await settled() }, pageButton = () => until(() => document.querySelector('main > div > button.verify'));";

/// The value of an expression that may use these tools.
#[track_caller]
fn of(browser: &mut Browser, expression: &str) -> Value {
    browser.evaluate(&format!("(async () => {{ {TOOLS} return {expression} }})()"))
}

/// The page's replies to some questions.
#[track_caller]
fn replies(browser: &mut Browser, questions: &[String]) -> Vec<String> {
    let asked = format!(
        "(async () => {{ const all = []; for (const question of {}) {{ all.push(await genevaVerify.ask(question)) }} return all }})()",
        json!(questions)
    );
    let all = browser.evaluate(&asked);
    all.as_array().expect("replies").iter().map(|of| of.as_str().expect("text").to_owned()).collect()
}

/// Opens the check of a claim, which loads what is needed.
#[track_caller]
fn begin(browser: &mut Browser) {
    browser.evaluate("location.hash = '#check:pin.radius'; null");
    of(browser, "await settled()");
}

#[test]
fn every_claim_has_the_same_account_in_the_page_to_the_letter() {
    let Some(mut browser) = opened("pin.html") else { return };
    begin(&mut browser);
    let list = replies(&mut browser, &["list".to_owned()]).remove(0);
    assert_eq!(list, LEDGER.reply("list"));
    assert_eq!(list.lines().count(), LEDGER.claims().len());
    for some in LEDGER.claims().chunks(60) {
        let questions: Vec<String> = some.iter().map(|claim| format!("account {}", claim.id)).collect();
        for (question, theirs) in questions.iter().zip(replies(&mut browser, &questions)) {
            assert_eq!(theirs, LEDGER.reply(question), "{question}");
            assert_eq!(theirs.split('\t').nth(2), Some("holds"), "{question}");
        }
    }
}

/// Characters that are put into what is printed.
const PIECES: [&str; 30] = [
    "9",
    "0",
    "-",
    "+",
    "^",
    "_",
    "{",
    "}",
    "\\frac",
    "\\",
    "x",
    "=",
    ".",
    ",",
    " ",
    "(",
    ")",
    "^{9}",
    "\u{0}",
    "é",
    "\\theta",
    "'",
    "/0",
    "\\sqrt",
    "|",
    "999999999999",
    "&",
    "\\\\",
    "<b onclick=\"ran=1\">",
    "\u{202e}",
];

/// What is printed, spoilt in one to three places.
fn spoilt(printed: &str, dice: &mut Rng) -> String {
    let mut signs: Vec<String> = printed.chars().map(String::from).collect();
    for _ in 0..dice.usize(1..=3) {
        let at = dice.usize(..=signs.len());
        let piece = PIECES[dice.usize(..PIECES.len())].to_owned();
        match dice.usize(..3) {
            0 if at < signs.len() => drop(signs.remove(at)),
            1 if at < signs.len() => signs[at] = piece,
            _ => signs.insert(at, piece),
        }
    }
    signs.concat()
}

#[test]
fn three_hundred_spoilings_are_told_alike_in_the_page_and_here_and_none_ends_the_module() {
    let Some(mut browser) = opened("pin.html") else { return };
    begin(&mut browser);
    let mut dice = Rng::with_seed(53);
    let questions: Vec<String> = (0..300)
        .map(|_| {
            let claim = LEDGER.claims()[dice.usize(..LEDGER.claims().len())];
            format!("account {}\n{}", claim.id, spoilt(claim.printed, &mut dice))
        })
        .collect();
    let mut noticed = 0;
    for some in questions.chunks(50) {
        for (question, theirs) in some.iter().zip(replies(&mut browser, some)) {
            assert_eq!(theirs, LEDGER.reply(question), "{question:?}");
            noticed += usize::from(matches!(theirs.split('\t').nth(2), Some("differs" | "unreadable")));
        }
    }
    // Others are statements whose words are not read, or say the same.
    assert!(noticed > 150, "{noticed} of 300 are noticed");
    assert_eq!(browser.evaluate("globalThis.ran ?? null"), Value::Null);
}

#[test]
fn a_module_with_another_digit_in_a_formula_shows_differences() {
    let Some(mut browser) = opened("pin.html") else { return };
    // Degrees in one radian, with another first digit, wherever the module has them.
    let [old, new] = [57.295_779_513_082_32_f64, 67.295_779_513_082_32].map(|of| of.to_le_bytes().to_vec());
    let shown = of(
        &mut browser,
        &format!(
            "(async () => {{ const own = WebAssembly.compile; let changed = 0; WebAssembly.compile = code => {{ const bytes = new \
             Uint8Array(code); const old = {}, other = {}; for (let at = 0; at < bytes.length - 8; at++) {{ if (old.every((of, k) => bytes[at \
             + k] === of)) {{ bytes.set(other, at); changed++ }} }} return own(bytes) }}; (await pageButton()).click(); \
             await until(() => /as recorded/.test(status())); return [changed, status(), \
             [...box().querySelectorAll('li')].map(of => of.textContent), box().classList.contains('differs')] }})()",
            json!(old),
            json!(new)
        ),
    );
    assert!(shown[0].as_u64().is_some_and(|changed| changed > 0), "{shown}");
    let list = shown[2].as_array().expect("a list");
    assert!(!list.is_empty() && shown[3] == json!(true), "{shown}");
    assert!(shown[1].as_str().is_some_and(|told| told.starts_with('✗') && told.contains("are not")), "{shown}");
    assert!(
        list.iter().all(|of| of
            .as_str()
            .is_some_and(|of| of.contains("disagrees") || of.contains("recorded as") || of.contains("gives"))),
        "{shown}"
    );
}

#[test]
fn a_page_and_the_first_page_check_what_they_say_and_can_be_stopped() {
    let Some(mut browser) = opened("quick-return.html") else { return };
    let notes = browser.evaluate("document.querySelectorAll('.note[popover]').length");
    let page = of(
        &mut browser,
        "(async () => { const button = await pageButton(), words = button.textContent; button.click(); \
         await until(() => /as recorded/.test(status())); return [words, status(), box().querySelectorAll('li').length, \
         box().querySelector('progress').value] })()",
    );
    assert_eq!(page[0], json!(format!("Check this page: {notes} claims")));
    assert!(
        page[1].as_str().is_some_and(|told| told
            .starts_with(&format!("✓ {notes} of {notes} verdicts derived in your browser, each as recorded"))),
        "{page}"
    );
    assert_eq!([&page[2], &page[3]], [&json!(0), &notes]);
    open(&mut browser, "index.html");
    let first = of(
        &mut browser,
        "(async () => { document.querySelector('[data-verify-all] button').click(); const button = () => \
         [...box().querySelectorAll('button')].find(of => /Stop|Go on/.test(of.textContent)); await until(() => \
         box()?.querySelector('progress').value > 0); button().click(); await until(() => /^Stopped/.test(status())); const stopped = \
         status(); button().click(); await until(() => /^\\d+ of \\d+ checked/.test(status())); const going = status(); box().close(); await until(() => !box()); \
         return [stopped, going, document.querySelectorAll('dialog').length] })()",
    );
    let all = LEDGER.claims().len();
    let told = |at: usize| first[at].as_str().unwrap_or_default();
    let checked: usize =
        told(0).split(" of ").nth(1).and_then(|of| of.split(' ').next()?.parse().ok()).expect("a count");
    assert!((1..all).contains(&checked), "{first}");
    assert_eq!(told(0), format!("Stopped: {checked} of {checked} as recorded, {} not checked.", all - checked));
    assert!(told(1).contains(&format!(" of {all} checked")), "{first}");
    assert_eq!(first[2], json!(0));
}

#[test]
fn a_note_and_a_row_of_the_ledger_open_the_check_and_other_characters_change_it() {
    let Some(mut browser) = opened("pin.html") else { return };
    let check = "(async () => { await settled(); const first = [status(), lines()]; await put('37.2'); const other = [status(), lines(), \
                 box().querySelector('a').getAttribute('href')]; const reset = [...box().querySelectorAll('button')].find(of => \
                 of.textContent === 'As printed'); reset.click(); await until(() => /as recorded/.test(status())); return [first, other, \
                 field().value] })()";
    let places = [
        (
            "pin.html",
            "const note = document.getElementById('note-pin.radius'); note.showPopover(); await until(() => \
                      note.querySelector('button.verify')); note.querySelector('button.verify').click()",
        ),
        (
            "ledger.html",
            "const row = document.getElementById('pin.radius'); row.querySelector('details').open = true; await until(() => \
                         row.querySelector('button.verify')); row.querySelector('button.verify').click()",
        ),
    ];
    for (page, touch) in places {
        open(&mut browser, page);
        let shown = of(&mut browser, &format!("await (async () => {{ {touch} }})(), await {check}"));
        let (first, other) = (&shown[0], &shown[1]);
        assert!(
            first[0].as_str().is_some_and(|told| told.starts_with("✓ The same as recorded: right. Derived")),
            "{shown}"
        );
        assert!(first[1]["Near miss"].as_str().is_some_and(|told| told.ends_with("both routes refuse it")), "{shown}");
        assert!(first[1]["First route"] != first[1]["Second route"] && first[1]["Record"] == "as recorded", "{shown}");
        let told = "✗ Refused: the verdict changes from right to wrong.";
        assert!(other[0].as_str().is_some_and(|of| of.starts_with(told)), "{shown}");
        assert!(other[1]["Found"].as_str().is_some_and(|of| of.contains("are not a rounding of 37.098")), "{shown}");
        assert_eq!(
            (&other[2], &shown[2]),
            (&json!("#check:pin.radius:37.2"), &json!(LEDGER.claim("pin.radius").expect("a claim").printed)),
            "{shown}"
        );
    }
}

#[test]
fn the_prepared_spoilings_of_the_first_page_show_that_a_check_can_fail() {
    let Some(mut browser) = opened("index.html") else { return };
    let links = browser.evaluate(
        "[...document.querySelectorAll('a[data-verify]')].map(of => [of.dataset.verify, of.dataset.characters])",
    );
    let links = links.as_array().expect("links").clone();
    assert_eq!(links.len(), 3);
    for (at, link) in links.iter().enumerate() {
        let [id, characters] = [0, 1].map(|part| link[part].as_str().expect("text"));
        let reply = LEDGER.reply(&format!("account {id}\n{characters}"));
        let shown = of(
            &mut browser,
            &format!(
                "(async () => {{ document.querySelectorAll('a[data-verify]')[{at}].click(); await until(() => box()); await settled(); \
                 const found = [field().value, Object.entries(lines()).map(of => of.join('\\t')).join('\\n'), status()]; box().close(); await \
                 until(() => !box()); return found }})()"
            ),
        );
        assert_eq!(shown[0], json!(characters));
        let head = reply.lines().next().unwrap_or_default();
        assert_eq!(shown[1].as_str(), reply.strip_prefix(head).and_then(|of| of.strip_prefix('\n')), "{id}");
        assert!(!reply.contains("Not read"), "{id}: its check does not read what is spoilt");
    }
}

#[test]
fn hostile_characters_do_nothing_and_an_address_is_anybodys() {
    let Some(mut browser) = opened("pin.html") else { return };
    browser.events();
    let hostile = [
        "<img src=x onerror=\"window.ran=1\"><script>window.ran=2</script>".to_owned(),
        "{".repeat(100_000),
        "\u{0}\u{1b}[31m\u{202e}".to_owned(),
        "\\frac{".repeat(900),
        "9".repeat(3000),
    ];
    for characters in &hostile {
        let shown = of(
            &mut browser,
            &format!(
                "(async () => {{ location.hash = '#check:pin.radius:' + encodeURIComponent({}); await until(() => box()); await settled(); \
                 const found = [field().value.length, status(), box().querySelectorAll('img, script, b').length, window.ran ?? null]; \
                 box().close(); await until(() => !box()); return found }})()",
                json!(characters)
            ),
        );
        assert!(shown[0].as_u64().is_some_and(|length| length <= MOST_CHARACTERS as u64), "{shown}");
        assert!(shown[1].as_str().is_some_and(|told| told.starts_with(['✗', '?'])), "{shown}");
        assert_eq!([&shown[2], &shown[3]], [&json!(0), &Value::Null], "{shown}");
    }
    for (hash, told) in
        [("check:no.such-claim", "no claim has the id"), ("check:pin.radius:%", ""), ("check:<b>", ""), ("check:", "")]
    {
        let shown = of(
            &mut browser,
            &format!(
                "(async () => {{ location.hash = {}; let left = 60; await until(() => box() && !/loaded/.test(status()) || left-- <= 0); \
                 const found = box() ? status() : ''; box()?.close(); await until(() => !box()); return found }})()",
                json!(hash)
            ),
        );
        assert!(
            shown.as_str().is_some_and(|of| of.contains(told) && of.is_empty() == told.is_empty()),
            "{hash}: {shown}"
        );
    }
    let asks = |event: &Value| {
        let url = event["params"]["request"]["url"].as_str().unwrap_or_default();
        event["method"] == "Network.requestWillBeSent"
            && !["file:", "data:", "blob:"].iter().any(|own| url.starts_with(own))
    };
    assert!(!browser.events().iter().any(asks));
}

#[test]
fn nothing_is_loaded_before_the_first_touch_and_what_then_comes_is_not_too_heavy() {
    if !is_live() {
        return;
    }
    let book = crate::book_pages::book();
    let read = |name: &str| std::fs::read(book.join(name)).expect(name);
    let script = read("data/verify.js");
    assert!(script.len() < HEAVIEST_SCRIPT, "{} bytes", script.len());
    let text = String::from_utf8(read(MODULE)).expect("text");
    let packed = text.rsplit("genevaModule('").next().and_then(|of| of.split('\'').next()).expect("a module");
    let packed_bytes = packed.len() / 5 * 4;
    assert!((100_000..HEAVIEST_PACKED).contains(&packed_bytes), "{packed_bytes} bytes; {HEAVIEST_PACKED} are allowed");
    let Some(mut browser) = opened("pin.html") else { return };
    let loaded = "performance.getEntriesByType('resource').map(of => of.name).filter(of => /verify-|verify\\.css/.test(of)).length";
    assert_eq!(browser.evaluate(loaded), json!(0));
    let bytes = of(
        &mut browser,
        "(async () => { const own = WebAssembly.compile; let bytes = 0; WebAssembly.compile = code => { bytes = code.byteLength; return \
         own(code) }; location.hash = '#check:pin.radius'; await until(() => box()); await settled(); return bytes })()",
    );
    assert!(
        bytes.as_u64().is_some_and(|bytes| (bytes as usize) < HEAVIEST_MODULE),
        "{bytes} bytes; {HEAVIEST_MODULE} are allowed"
    );
}

#[test]
fn a_broken_module_and_an_old_browser_are_told_with_the_command_or_the_reason() {
    let Some(mut browser) = opened("pin.html") else { return };
    let shown = of(
        &mut browser,
        &format!(
            "(async () => {{ const own = WebAssembly.compile; WebAssembly.compile = () => own(new Uint8Array({})); location.hash = \
             '#check:pin.radius'; await until(() => box()); await until(() => !/loaded/.test(status())); return status() }})()",
            json!(module(&[0x00]))
        ),
    );
    assert!(shown.as_str().is_some_and(|told| told.contains("unreachable") && told.contains("cargo run")), "{shown}");
    open(&mut browser, "jazar.html");
    let shown = of(
        &mut browser,
        "(async () => { delete globalThis.DecompressionStream; location.hash = '#check:pin.radius'; await until(() => box()); await until(() \
         => !/loaded/.test(status())); return status() })()",
    );
    assert!(shown.as_str().is_some_and(|told| told.starts_with("Nothing can be checked here")), "{shown}");
}

#[test]
fn the_check_is_reached_and_left_by_keyboard_fits_a_phone_and_works_where_it_is_served() {
    let Some(mut browser) = opened("pin.html") else { return };
    for address in [format!("file://{}", crate::book_pages::book().display()), served(crate::book_pages::book())] {
        browser.show_in([390, 664], Medium::Dark);
        browser.open(&format!("{address}/pin.html"));
        // A native button: what has the focus is pressed by every key that presses buttons.
        let pressed = of(
            &mut browser,
            "(async () => { const button = await pageButton(); button.focus(); const has = \
             document.activeElement === button; document.activeElement.click(); return has && button.localName === 'button' })()",
        );
        assert_eq!(pressed, json!(true));
        let shown = of(
            &mut browser,
            "(async () => { let left = 900; await until(() => /as recorded/.test(status()) || left-- <= 0); const at = box().getBoundingClientRect(); return \
             [status(), box().matches(':modal'), document.getElementById(box().getAttribute('aria-labelledby')).textContent, at.left >= 0 && at.right <= \
             innerWidth && at.bottom <= innerHeight, box().scrollWidth <= box().clientWidth, box().contains(document.activeElement)] })()",
        );
        assert!(shown[0].as_str().is_some_and(|told| told.starts_with('✓')), "{address}: {shown}");
        let rest: Vec<Value> = shown.as_array().expect("a list")[1..].to_vec();
        assert_eq!(json!(rest), json!([true, "Check this page", true, true, true]), "{address}");
        browser.press("Escape", 27);
        let left = "(async () => { let left = 300; await until(() => !box() || left-- <= 0); return \
                    document.activeElement.className })()";
        assert_eq!(of(&mut browser, left), json!("verify"), "{address}: the focus is not on the button again");
    }
}
