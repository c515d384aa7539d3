//! The module in its own thread: what happens when it fails or never ends, and whether every figure works where it is served.

use super::{PAGES, browser, of, open};
use crate::browser::devtools::Medium;
use serde_json::json;
use std::collections::BTreeSet;
use std::io::{BufRead, BufReader, Write};
use std::net::{TcpListener, TcpStream};
use std::path::Path;

/// A module with the interface of ours whose `ask` does nothing but this.
pub(crate) fn module(ask: &[u8]) -> Vec<u8> {
    let section = |kind: u8, content: &[u8]| [&[kind, content.len() as u8], content].concat();
    let export = |name: &str, kind: u8, index: u8| [&[name.len() as u8], name.as_bytes(), &[kind, index]].concat();
    // Two types: (i32) -> i32 and () -> i32; three functions, `room`, `ask` and `answer`; one page of memory.
    let body = |code: &[u8]| [&[code.len() as u8 + 2, 0], code, &[0x0b]].concat();
    let exports =
        [vec![4], export("memory", 2, 0), export("room", 0, 0), export("ask", 0, 1), export("answer", 0, 2)].concat();
    [
        b"\0asm\x01\0\0\0".to_vec(),
        section(1, &[2, 0x60, 1, 0x7f, 1, 0x7f, 0x60, 0, 1, 0x7f]),
        section(3, &[3, 0, 1, 1]),
        section(5, &[1, 0, 1]),
        section(7, &exports),
        section(10, &[vec![3], body(&[0x41, 0]), body(ask), body(&[0x41, 0])].concat()),
    ]
    .concat()
}

/// What a broken module does when it is asked, what the page says of it, and what is to be done before.
///
/// The code is `unreachable`, and `loop br 0 end i32.const 0`. The one that never ends keeps a processor busy as long as the page
/// waits, so instead of five seconds the page gives its first question a few frames.
pub(crate) const BROKEN: [(&[u8], &str, &str); 2] = [
    (&[0x00], "unreachable", "null"),
    (
        &[0x03, 0x40, 0x0c, 0, 0x0b, 0x41, 0],
        "no answer within 5 s",
        "{ const own = setTimeout; globalThis.setTimeout = (run, time, ...rest) => { if (time !== 5000) { return own(run, time, \
         ...rest) } globalThis.setTimeout = own; let left = 5; const look = () => left-- ? requestAnimationFrame(look) : run(); \
         look() }; null }",
    ),
];

#[test]
fn a_module_that_traps_or_never_ends_is_replaced_and_the_figure_says_so() {
    let Some(mut browser) = browser() else { return };
    browser.show(1280, Medium::Light);
    for (ask, why, before) in BROKEN {
        open(&mut browser, "jazar", "");
        browser.evaluate(before);
        // The first module is the broken one, all later ones are the book's own.
        let shown = browser.evaluate(&format!(
            "(async () => {{ const own = Worker; let made = 0; globalThis.Worker = class extends own {{ postMessage(message) {{ \
             if (message.code) {{ made += 1 }} super.postMessage(message.code && made === 1 ? {{ code: broken }} : message) }} }}; \
             const broken = await WebAssembly.compile(new Uint8Array({})); \
             const f = document.querySelector('[data-live=wheel]'), g = f.querySelector('form'); \
             const says = () => [f.querySelector('.message').textContent, f.querySelector('.stale').hidden, \
             [...f.querySelectorAll('output')].map(of => of.value).join('')]; \
             let frames = 0; const count = () => {{ frames += 1; requestAnimationFrame(count) }}; count(); \
             const box = g.querySelector('[data-box=crank]'), type = value => {{ box.value = value; box.dispatchEvent(new Event('input', \
             {{ bubbles: true }})) }}; \
             type(20); await until(() => f.classList.contains('refused')); const refused = says(), meanwhile = frames; \
             type(21); await until(() => !f.classList.contains('refused')); \
             return [refused, meanwhile, says(), made] }})()",
            json!(module(ask))
        ));
        let (refused, after) = (&shown[0], &shown[2]);
        assert!(refused[0].as_str().is_some_and(|told| told.contains(why)), "{shown}");
        assert_eq!([&refused[1], &refused[2]], [&json!(false), &json!("–––––––")], "{shown}");
        assert!(shown[1].as_u64().is_some_and(|frames| frames > 1), "the page stood still: {shown}");
        assert_eq!([&after[0], &after[1], &shown[3]], [&json!(""), &json!(true), &json!(2)], "{shown}");
        assert!(after[2].as_str().is_some_and(|numbers| numbers.contains('°')), "{shown}");
    }
}

/// A list of words of the script that draws.
fn words(script: &str, name: &str) -> BTreeSet<String> {
    let list = script.split(&format!("const {name} = new Set(")).nth(1).and_then(|rest| rest.split(".split").next());
    let list = list.expect("a list").replace(['(', ')', '\'', '+', '\n'], " ");
    list.split_whitespace().map(str::to_owned).collect()
}

#[test]
fn the_parts_that_a_drawing_may_have_are_those_that_drawings_have() {
    let script = std::fs::read_to_string(crate::path("book/theme/live.js")).expect("a script");
    let (mut elements, mut attributes) = (BTreeSet::new(), BTreeSet::new());
    for (name, page) in PAGES {
        let given = if super::moves() { super::given_on(page) } else { return };
        for setting in super::grid(name) {
            let answer = geneva_live::answer(&format!("{name}?{given}&{setting}"));
            let answer: serde_json::Value = serde_json::from_str(&answer).expect("JSON");
            let Some(svg) = answer["svg"].as_str() else { continue };
            for tag in svg.split('<').skip(1).filter(|tag| !tag.starts_with('/')) {
                let tag = tag.split('>').next().unwrap_or_default();
                elements.extend(tag.split_whitespace().next().map(|name| name.trim_end_matches('/').to_owned()));
                let pieces: Vec<&str> = tag.split('"').collect();
                attributes.extend(
                    pieces
                        .iter()
                        .step_by(2)
                        .filter_map(|piece| Some(piece.trim_end().strip_suffix('=')?.rsplit(' ').next()?.to_owned())),
                );
            }
        }
    }
    assert_eq!(elements, words(&script, "elements"));
    assert_eq!(attributes, words(&script, "attributes"));
}

#[test]
fn a_drawing_with_parts_that_no_drawing_has_is_refused() {
    let Some(mut browser) = browser() else { return };
    browser.show(1280, Medium::Light);
    open(&mut browser, "jazar", "");
    of(&mut browser, "wheel", "1");
    for part in [
        "<script>document.title='ran'</script>",
        "<image href='x' onerror=\"document.title='ran'\"/>",
        "<g onclick=\"document.title='ran'\"/>",
        "<a href=\"javascript:document.title='ran'\"><text>a</text></a>",
        "<foreignObject><p xmlns='http://www.w3.org/1999/xhtml'>a</p></foreignObject>",
        "<style>*{fill:red}</style>",
        "<path fill='url(https://example.org)' d='M0 0'/>",
        "<g>",
    ] {
        let shown = of(
            &mut browser,
            "wheel",
            &format!(
                "(async () => {{ const own = JSON.parse, before = f.querySelector('.drawing').innerHTML; JSON.parse = text => {{ \
                 const answer = own(text); if (answer.svg) {{ answer.svg = answer.svg.replace('</svg>', {} + '</svg>') }} return \
                 answer }}; const box = g.querySelector('[data-box=crank]'); box.value = 33; box.dispatchEvent(new Event('input', {{ \
                 bubbles: true }})); await settled(); JSON.parse = own; return [f.classList.contains('refused'), before === \
                 f.querySelector('.drawing').innerHTML, document.title.includes('ran')] }})()",
                json!(part)
            ),
        );
        assert_eq!(shown, json!([true, true, false]), "{part}");
    }
}

/// Serves a folder on this machine, until the test ends, and gives the address.
pub(crate) fn served(folder: &'static Path) -> String {
    let listener = TcpListener::bind("127.0.0.1:0").expect("a port of this machine");
    let address = format!("http://{}", listener.local_addr().expect("an address"));
    std::thread::spawn(move || listener.incoming().flatten().for_each(|stream| drop(serve(folder, stream))));
    address
}

fn serve(folder: &Path, mut stream: TcpStream) -> std::io::Result<()> {
    let mut request = String::new();
    let mut lines = BufReader::new(stream.try_clone()?);
    lines.read_line(&mut request)?;
    let mut line = String::new();
    while lines.read_line(&mut line)? > 2 {
        line.clear();
    }
    let path = request.split(' ').nth(1).unwrap_or("/").split(['?', '#']).next().unwrap_or_default();
    let kind = match path.rsplit('.').next() {
        Some("html") => "text/html",
        Some("js") => "text/javascript",
        Some("css") => "text/css",
        Some("svg") => "image/svg+xml",
        _ => "application/octet-stream",
    };
    let (status, body) = match std::fs::read(folder.join(path.trim_start_matches('/'))) {
        Ok(body) => ("200 OK", body),
        Err(_) => ("404 Not Found", Vec::new()),
    };
    write!(
        stream,
        "HTTP/1.1 {status}\r\nContent-Type: {kind}\r\nContent-Length: {}\r\nConnection: close\r\n\r\n",
        body.len()
    )?;
    stream.write_all(&body)
}

#[test]
fn every_figure_moves_under_its_policy_from_disk_and_from_a_server() {
    let Some(mut browser) = browser() else { return };
    browser.show(1280, Medium::Light);
    let book = crate::book_pages::book();
    for place in [format!("file://{}", book.display()), served(book)] {
        for (name, page) in PAGES {
            browser.events();
            browser.open(&format!("{place}/{page}.html"));
            let shown = of(
                &mut browser,
                name,
                "(async () => { const before = f.querySelector('.drawing').innerHTML; const box = [...g.querySelectorAll('[data-box]')] \
                 .find(of => !of.closest('span').previousElementSibling.dataset.follows); box.value = Number(box.value) + \
                 Number(box.closest('span').previousElementSibling.step); box.dispatchEvent(new Event('input', { bubbles: true })); \
                 await settled(); return [before !== f.querySelector('.drawing').innerHTML, \
                 f.classList.contains('refused'), f.querySelector('.message').textContent] })()",
            );
            assert_eq!([&shown[0], &shown[1]], [&json!(true), &json!(false)], "{place} {page}: {shown}");
            let violation = browser.events().into_iter().find(|event| event["method"] == "Log.entryAdded");
            assert!(violation.is_none(), "{place} {page}: {violation:#?}");
        }
    }
}
