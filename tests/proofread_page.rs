//! Does the page that proofreads a text show what the library finds, whatever is pasted, and send it nowhere?

use crate::browser::devtools::{Browser, Medium};
use crate::live::module::{BROKEN, module, served};
use geneva_proofread_page::{MOST_BYTES, answer, too_long_message};
use serde_json::{Value, json};

/// Whether the page has its module. With `$LIVE_REQUIRED` it is a fault if it has none.
fn is_live() -> bool {
    let is_live = crate::book_pages::book().join("data/proofread-module.js").is_file();
    assert!(
        is_live || std::env::var_os("LIVE_REQUIRED").is_none(),
        "the page for texts of the reader's own has no module"
    );
    is_live
}

/// A browser with the page open, if there is one and the page is live.
fn opened() -> Option<Browser> {
    let mut browser = if is_live() { Browser::start()? } else { return None };
    browser.show(1280, Medium::Light);
    open(&mut browser);
    Some(browser)
}

fn open(browser: &mut Browser) {
    browser.open(&format!("file://{}/proofread.html", crate::book_pages::book().display()));
}

/// The page's parts, and functions that type a text, wait for its result and say what is shown.
const TOOLS: &str = "const place = document.querySelector('[data-proofread]'), form = place.querySelector('form'), area = \
     form.querySelector('textarea'), result = place.querySelector('.result'); const settled = () => until(() => \
     !place.hasAttribute('aria-busy')); const put = inputType => area.dispatchEvent(new InputEvent('input', { bubbles: true, inputType \
     })); const paste = async text => { area.value = text; put('insertFromPaste'); await settled() }; const said = () => [...place.querySelectorAll('.summary p')].map(of => of.textContent); \
     const found = () => [...place.querySelectorAll('.findings li')].map(of => of.textContent); const drop = async (...files) => { \
     const data = new DataTransfer(); files.forEach(file => data.items.add(file)); const told = kind => \
     document.querySelector('main').dispatchEvent(new DragEvent(kind, { dataTransfer: data, bubbles: true, cancelable: true })); \
     const read = new Promise(done => new MutationObserver(done).observe(place, { childList: true, subtree: true })); \
     const isKept = [told('dragover'), told('drop')]; await read; await settled(); return isKept };";

/// The value of an expression that may use these tools.
#[track_caller]
fn of(browser: &mut Browser, expression: &str) -> Value {
    browser.evaluate(&format!("(async () => {{ {TOOLS} return {expression} }})()"))
}

/// A text in each format, with chains that are wrong in numbers, in units and with values of names.
const TEXTS: [(&str, &str); 7] = [
    ("markdown", "# Wärme 🔥\n\n$v = 2.0$ and $3 v = 7.0$, $\\tan 31.0^\\circ = 0.609$, `2+2=5`\n\n2 + 2 = 5 & <b>\n"),
    (
        "latex",
        "\\documentclass{article}\\begin{document}\n\\begin{align} 4 \\times 5 &= 21 \\\\ &= 20 \\end{align}\n% 1+1=3\n\\end{document}",
    ),
    (
        "xml",
        "<?xml version=\"1.0\"?><a><m:math><m:mn>2</m:mn><m:mo>+</m:mo><m:mn>2</m:mn><m:mo>=</m:mo><m:mn>5</m:mn></m:math></a>",
    ),
    (
        "html",
        "<!doctype html><p>\\(2.0\\,\\mathrm{m} \\times 3.0\\,\\mathrm{m} = 6.0\\,\\mathrm{m}\\) &amp; \\(2+2=5\\)</p>",
    ),
    ("notebook", "{\"cells\":[{\"cell_type\":\"markdown\",\"source\":[\"\\u00e9 $2+2=5$\\n\",\"x = 3*4 = 13\"]}]}"),
    ("plain", "F = (2.0 kg)(3.0 m/s²) = 7.0 N\n1.5e-3 * 2 = 3.1e-3\n"),
    ("plain", "a < b and nothing else"),
];

#[test]
fn a_paste_is_checked_at_once_and_what_is_typed_after_a_pause() {
    let Some(mut browser) = opened() else { return };
    let busy = of(
        &mut browser,
        "(async () => { const by = inputType => { area.value = '2 + 2 = 5'; put(inputType); return place.hasAttribute('aria-busy') }; \
         const typed = by('insertText'), last = await until(() => found().length === 1), pasted = by('insertFromPaste'); await settled(); \
         return [typed, last, pasted, found().length] })()",
    );
    assert_eq!(busy, json!([false, true, true, 1]));
}

#[test]
fn the_example_stands_as_the_script_shows_it() {
    // But for the spaces at which the page breaks no line.
    let Some(mut browser) = opened() else { return };
    let shown = of(
        &mut browser,
        "(async () => { const html = () => result.innerHTML.replace(/>\\s+</g, '><').replace(/&nbsp;/g, ' '); const before = html(); await paste(''); const empty = [said(), found()]; \
         form.querySelector('[data-do=example]').click(); await settled(); const after = html(); const at = \
         [...before].findIndex((of, at) => of !== after[at]); return [at, empty, found().length, before.slice(at - 40, at + 40), \
         after.slice(at - 40, at + 40)] })()",
    );
    assert_eq!([&shown[0], &shown[2]], [&json!(-1), &json!(5)], "{shown}");
    assert_eq!(shown[1], json!([["Paste a text, or drop a file anywhere on this page."], []]));
}

#[test]
fn the_page_finds_the_same_characters_as_the_library() {
    let Some(mut browser) = opened() else { return };
    for (format, text) in TEXTS {
        for options in
            ["", "units=yes bindings=always hints=no", &format!("format={format} bindings=never"), "format=plain"]
        {
            let question = format!("{options}\n{text}");
            let theirs = browser.evaluate(&format!("genevaProofread({})", json!(question)));
            assert!(theirs.as_str() == Some(&answer(&question)), "{options}: {text} is answered otherwise in the page");
        }
        let shown = of(
            &mut browser,
            &format!(
                "(async () => {{ await paste({}); return [said(), found(), result.querySelectorAll('b, script, img').length] }})()",
                json!(text)
            ),
        );
        let own: Value = serde_json::from_str(&answer(&format!("\n{text}"))).expect("JSON");
        assert_eq!((&shown[0], &own["format"]), (&own["summary"], &json!(format)), "{text}");
        let findings = own["findings"].as_array().expect("findings");
        let lines: Vec<String> = findings.iter().map(in_one_line).collect();
        assert_eq!([&shown[1], &shown[2]], [&json!(lines), &json!(0)], "{text}");
        // A place is counted as the page counts it, also behind characters that it counts twice.
        for finding in findings {
            let [from, to] = ["from", "to"].map(|end| finding[end].as_u64().expect("a place") as usize);
            let units: Vec<u16> = text.encode_utf16().collect();
            let marked = String::from_utf16(units.get(from..to).expect("inside")).expect("whole characters");
            // A power of ten behind an `e` is shown as one.
            let is_plain = !marked.contains(['\\', '<']) && !marked.contains("e-");
            assert!(!is_plain || finding["chain"][1] == json!(marked), "{text}: {marked}, {finding}");
            assert!(is_plain || format != "markdown" || marked.contains("e-"), "{text}: {marked}");
        }
    }
}

/// A finding as the words of its entry.
fn in_one_line(finding: &Value) -> String {
    let text = |of: &Value| of.as_str().unwrap_or_default().to_owned();
    let list =
        |of: &Value, each: &dyn Fn(&Value) -> String| of.as_array().into_iter().flatten().map(each).collect::<String>();
    let others: Vec<String> = { finding["others"].as_array().into_iter().flatten() }
        .map(|of| format!("line {}, column {}", of["line"], of["column"]))
        .chain(finding["more"].as_u64().filter(|more| *more > 0).map(|more| format!("and {more} more")))
        .collect();
    let also = if others.is_empty() { String::new() } else { format!("also {}", others.join("; ")) };
    format!(
        "line {}, column {}: {}{}{}{also}",
        finding["line"],
        finding["column"],
        text(&finding["verdict"]),
        list(&finding["chain"], &text),
        list(&finding["facts"], &|fact| format!("{} {}", text(&fact["label"]), text(&fact["text"])))
    )
}

#[test]
fn hostile_texts_are_answered_in_words_and_nothing_of_them_runs_or_is_sent() {
    let Some(mut browser) = opened() else { return };
    browser.events();
    let script = "<img src=x onerror=\"window.ran=1\"><script>window.ran=2</script><svg onload=\"window.ran=3\">";
    let texts = [
        format!("{script} $2 + 2 = 5\\ \\text{{{script}}}$ 2 + 2 = 5 {script}"),
        format!("<p>\\(2+2=5\\) {script} <math><mtext>{script}</mtext><mn>2</mn><mo>=</mo><mn>3</mn></math></p>"),
        format!("format=latex\n$v_{{{script}}} = 2$ $2 v_{{{script}}} = 5$"),
        format!("$v_{{\\text{{{script}}}}} = 2 + 2 = 5$"),
        "javascript:window.ran=4 = 5 = 6".to_owned(),
        format!("${}1{}=2$", "(".repeat(50_000), ")".repeat(50_000)),
        format!("${}1{}=2$", "\\frac{1}{".repeat(50_000), "}".repeat(50_000)),
        format!("${}2=5$", "2^".repeat(9000)),
        format!("${}2=5$", "\\sqrt".repeat(3000)),
        format!("${}2=5$", "\\sqrt[".repeat(3000)),
        format!("${}2=5$", "√".repeat(9000)),
        format!("5 = {}2", "√".repeat(1000)),
        format!("<math>{}<mn>1</mn>", "<mrow>".repeat(100_000)),
        format!("{{\"cells\":{}", "[".repeat(200_000)),
        format!("${}$", vec!["7"; 2000].join("=8=")),
        "\u{202e}\u{7} 2 + 2 = 5 \u{feff}".to_owned(),
        "$2+2=5$ ".repeat(20_000),
    ];
    for text in &texts {
        let shown = of(
            &mut browser,
            &format!(
                "(async () => {{ await paste({}); return [said(), found().length, window.ran ?? null, \
            [...new Set([...result.querySelectorAll('*')].map(of => of.localName))].sort().join(' ')] }})()",
                json!(text)
            ),
        );
        let start: String = text.chars().take(60).collect();
        assert!(shown[0][0].as_str().is_some_and(|words| !words.is_empty()), "{start}: {shown}");
        assert_eq!(shown[2], json!(null), "{start}");
        assert!(!shown[0].to_string().contains("call stack"), "{start}: {shown}");
        let known = ["a", "dd", "details", "div", "dl", "dt", "li", "mark", "ol", "p", "samp", "strong", "summary"];
        let elements = shown[3].as_str().unwrap_or_default();
        assert!(elements.split(' ').all(|element| known.contains(&element)), "{start}: {elements}");
    }
    let shown = of(&mut browser, &format!("(await paste({}), found())", json!(texts[3])));
    assert!(shown[0].as_str().is_some_and(|chain| chain.contains("<img")), "what would run is not shown: {shown}");
    // What is too long is refused by the page and by the module alike.
    let refused = of(
        &mut browser,
        &format!("(async () => {{ await paste('1 '.repeat({})); return [said(), found()] }})()", MOST_BYTES / 2 + 1),
    );
    assert_eq!(refused, json!([[too_long_message()], []]));
    let refused = of(
        &mut browser,
        &format!("(async () => {{ await paste('ä'.repeat({})); return said() }})()", MOST_BYTES / 2 + 1),
    );
    assert_eq!(refused, json!([too_long_message()]));
    let after = of(&mut browser, "(async () => { await paste('2 + 2 = 5'); return found().length })()");
    assert_eq!(after, json!(1));
    no_request(&mut browser, "hostile texts");
}

/// That the page has asked for nothing but its own files, and that its policy had nothing to block.
#[track_caller]
fn no_request(browser: &mut Browser, what: &str) {
    for event in browser.events() {
        let url = event["params"]["request"]["url"].as_str().unwrap_or_default();
        let files = ["/data/proofread-module.js", "/proofread.html", ".css", ".svg", ".woff2", ".js"];
        let own = !url.contains('?') && files.iter().any(|file| url.ends_with(file));
        assert!(
            event["method"] != "Network.requestWillBeSent" || own || url.starts_with("blob:"),
            "{what}: asks for {url}"
        );
        assert!(event["method"] != "Log.entryAdded", "{what}: {event:#}");
    }
}

#[test]
fn a_file_is_read_by_its_ending_and_what_is_no_text_is_refused() {
    let Some(mut browser) = opened() else { return };
    let shown = of(
        &mut browser,
        "(async () => { const from = form.querySelector('.from'); const all = []; const one = async (parts, name) => { const kept = \
         await drop(new File(parts, name)); all.push([kept, from.textContent, said()[0], area.value.length]) }; \
         await one(['$2+2=5$'], 'a.TEX'); await one([new Uint8Array([0x32, 0x2b, 0x32, 0x3d, 0x35, 0x0a, 0xff, 0xc3])], 'b.txt'); \
         await one([new Uint8Array([0xff, 0xfe, 0x32, 0, 0x2b, 0, 0x32, 0, 0x3d, 0, 0x35, 0])], 'c'); \
         await one([new Uint8Array([0x25, 0x50, 0x44, 0x46, 0, 1])], '<b>.pdf'); await one(['x'.repeat(2000001)], 'd.md'); \
         await one(['$2+2=5$'], 'e.' + 'x'.repeat(3000)); await one(['$2+2=5$'], '\u{202e}f.md'); \
         return all })()",
    );
    let kept = json!([false, false]);
    let refused = "The file “<b>.pdf” is not text. Save it as text first, for example with pdftotext if it is a PDF.";
    let strange = "From the file “b.txt”. It is not all UTF-8, and 2 of its characters could not be read.";
    // Of a long name the end is shown, and a long ending says nothing of the format.
    let long = format!("From the file “…{}”.", "x".repeat(59));
    let expected = json!([
        [kept, "From the file “a.TEX”.", "1 finding: 1 on a number.", 7],
        [kept, strange, "1 finding: 1 on a number.", 8],
        [kept, "From the file “c”.", "1 finding: 1 on a number.", 5],
        [kept, "From the file “c”.", refused, 5],
        [kept, "", too_long_message(), 5],
        [kept, long, "1 finding: 1 on a number.", 7],
        [kept, "From the file “\\u{202e}f.md”.", "1 finding: 1 on a number.", 7],
    ]);
    assert_eq!(shown, expected);
    let read = of(
        &mut browser,
        "(async () => { await drop(new File(['$2+2=5$'], 'a.tex'), new File([''], 'b')); return [said()[1], \
        form.querySelector('.from').textContent] })()",
    );
    assert!(read[0].as_str().is_some_and(|words| words.starts_with("Read as LaTeX, ")), "{read}");
    assert!(read[1].as_str().is_some_and(|words| words.contains("other files were left out")), "{read}");
}

#[test]
fn all_of_it_goes_by_keyboard_and_the_page_stays() {
    let Some(mut browser) = opened() else { return };
    of(&mut browser, "(area.focus(), area.select())");
    browser.command("Input.insertText", json!({ "text": "one\ntwo: 2 + 2 = 5" }));
    browser.press("ArrowLeft", 37);
    browser.press("ArrowRight", 39);
    let typed = of(
        &mut browser,
        "(await until(() => found().length === 1), await settled(), [said()[0], location.pathname.split('/').pop(), area.value])",
    );
    assert_eq!(typed, json!(["1 finding: 1 on a number.", "proofread.html", "one\ntwo: 2 + 2 = 5"]));
    // The controls follow one another, and then the findings.
    let mut reached = Vec::new();
    for _ in 0..9 {
        browser.press("Tab", 9);
        let now = of(
            &mut browser,
            "document.activeElement.name || document.activeElement.dataset.do || document.activeElement.textContent",
        );
        reached.push(now.as_str().unwrap_or_default().to_owned());
    }
    assert_eq!(
        reached,
        ["format", "bindings", "units", "doubts", "file", "copy", "clear", "example", "line 2, column 14"]
    );
    for kind in ["keyDown", "keyUp"] {
        let event = json!({ "type": kind, "key": "Enter", "code": "Enter", "windowsVirtualKeyCode": 13, "text": "\r" });
        browser.command("Input.dispatchKeyEvent", event);
    }
    let selected =
        of(&mut browser, "[document.activeElement === area, area.value.slice(area.selectionStart, area.selectionEnd)]");
    assert_eq!(selected, json!([true, "5"]));
}

#[test]
fn options_change_the_result_and_it_can_be_copied() {
    let Some(mut browser) = opened() else { return };
    let shown = of(
        &mut browser,
        "(async () => { let copied; Object.defineProperty(navigator, 'clipboard', { value: { writeText: async text => { copied = text } \
         } }); const set = async (name, value) => { const of = form.elements[name]; of.type === 'checkbox' ? of.checked = value : \
         of.value = value; of.dispatchEvent(new Event('change', { bubbles: true })); await settled(); return said()[0] }; \
         await paste('v = 2.0\\n\\n3 v = 7.0\\n\\n2.0 m × 3.0 m = 6.0 m'); const all = [said()[0], await set('bindings', 'once'), await \
         set('bindings', 'never'), await set('units', true)]; form.querySelector('[data-do=copy]').click(); const done = await until(() => form.querySelector('.done').textContent); \
         return [all, copied, done] })()",
    );
    let own = answer("bindings=never units=yes\nv = 2.0\n\n3 v = 7.0\n\n2.0 m × 3.0 m = 6.0 m");
    let own: Value = serde_json::from_str(&own).expect("JSON");
    assert_eq!([&shown[0][0], &shown[0][2]], [&json!("Nothing found."); 2], "{shown}");
    assert_eq!(shown[0][1], json!("1 finding: 1 with values from elsewhere in the text."), "{shown}");
    assert_eq!(shown[0][3], json!("1 finding: 1 on units alone."), "{shown}");
    assert_eq!([&shown[1], &shown[2]], [&own["text"], &json!("The result is in the clipboard.")], "{shown}");
}

#[test]
fn a_module_that_traps_or_never_ends_is_replaced_and_the_page_says_so() {
    let Some(mut browser) = opened() else { return };
    for (ask, why, before) in BROKEN {
        open(&mut browser);
        browser.evaluate(before);
        let shown = of(
            &mut browser,
            &format!(
                "(async () => {{ const own = Worker; let made = 0; globalThis.Worker = class extends own {{ postMessage(message) {{ if \
                 (message.code) {{ made += 1 }} super.postMessage(message.code && made === 1 ? {{ code: broken }} : message) }} }}; \
                 const broken = await WebAssembly.compile(new Uint8Array({})); area.value = '2 + 2 = 5'; area.dispatchEvent(new \
                 Event('input', {{ bubbles: true }})); await until(() => said()[0].startsWith('This text')); const refused = \
                 [said()[0], found().length]; await paste('2 + 2 = 6'); return [refused, found().length] }})()",
                json!(module(ask))
            ),
        );
        assert!(
            shown[0][0].as_str().is_some_and(|words| words.contains(why) && words.contains("use the command")),
            "{shown}"
        );
        assert_eq!([&shown[0][1], &shown[1]], [&json!(0), &json!(1)], "{shown}");
    }
}

#[test]
fn a_long_text_is_answered_in_the_page() {
    let Some(mut browser) = opened() else { return };
    let line = "The area is $A = 10.1\\,\\mathrm{m} \\times 2.00\\,\\mathrm{m} = 20.2\\,\\mathrm{m^2}$, and so on in words, line by line.\n\n";
    let text = line.repeat(100_000 / line.len()) + "$2 + 2 = 5$";
    let found = browser.evaluate(&format!(
        "genevaProofread({}).then(answer => JSON.parse(answer).findings.length)",
        json!(format!("\n{text}"))
    ));
    assert_eq!(found, json!(1));
}

#[test]
fn without_webassembly_the_page_names_the_command() {
    let Some(mut browser) = opened() else { return };
    let source = json!({ "source": "delete globalThis.WebAssembly" });
    let added = browser.command("Page.addScriptToEvaluateOnNewDocument", source);
    open(&mut browser);
    let shown = browser.evaluate(&format!(
        "(() => {{ {TOOLS} return [form.querySelector('.without').checkVisibility(), form.querySelector('.controls').checkVisibility(), \
         area.readOnly, found().length, document.querySelector('main').textContent.includes('cargo run -- proofread FILE')] }})()"
    ));
    browser.command("Page.removeScriptToEvaluateOnNewDocument", added);
    assert_eq!(shown, json!([true, false, true, 5, true]));
}

#[test]
fn text_and_findings_share_a_screen() {
    let Some(mut browser) = opened() else { return };
    for window in [[390, 844], [1280, 800]] {
        browser.show_in(window, Medium::Light);
        open(&mut browser);
        // A reader has scrolled to a finding: the text must still be in sight, and not on the finding.
        let apart = of(
            &mut browser,
            "(async () => { const found = []; for (const item of (result.querySelector('details').open = true, result.querySelectorAll('li'))) { scrollBy({ top: \
             place.getBoundingClientRect().top - 60, behavior: 'instant' }); item.scrollIntoView({ block: 'nearest', behavior: \
             'instant' }); await new Promise(requestAnimationFrame); const [text, own] = [area, item].map(of => \
             of.getBoundingClientRect()); const isOver = text.right > own.left && text.bottom > own.top; if (text.top < 0 || \
             text.bottom > innerHeight + 1 || own.bottom > innerHeight + 1 || isOver) { found.push([text.top, text.bottom, own.top, \
             own.bottom]) } } return found })()",
        );
        assert_eq!(apart, json!([]), "{window:?}");
    }
}

#[test]
fn it_works_under_its_policy_from_disk_and_from_a_server_and_asks_for_nothing() {
    let Some(mut browser) = opened() else { return };
    let book = crate::book_pages::book();
    for place in [format!("file://{}", book.display()), served(book)] {
        browser.open(&format!("{place}/proofread.html"));
        browser.events();
        let shown = of(&mut browser, "(async () => { await paste('2 + 2 = 5'); return found().length })()");
        assert_eq!(shown, json!(1), "{place}");
        no_request(&mut browser, &place);
    }
    let page = std::fs::read_to_string(book.join("proofread.html")).expect("a page");
    let policy = "content=\"default-src 'none'; script-src 'self' 'wasm-unsafe-eval'";
    assert!(page.contains(policy) && !page.contains("connect-src"), "another policy");
}

#[test]
fn the_module_is_not_too_heavy_and_no_other_page_loads_it() {
    if !is_live() {
        return;
    }
    let book = crate::book_pages::book();
    let weight = std::fs::metadata(book.join("data/proofread-module.js")).expect("a module").len() as usize;
    let most = geneva_chapters::proofreading_form::HEAVIEST_MODULE;
    assert!((100_000..most).contains(&weight), "{weight} bytes; {most} are allowed");
    for page in crate::book_pages::names() {
        let text = std::fs::read_to_string(book.join(&page)).expect("a page");
        assert_eq!(text.contains("data/proofread.js"), page == "proofread.html", "{page}");
        assert!(!text.contains("proofread-module.js"), "{page} loads the module before it is needed");
    }
}
