//! Does a page's policy hold? Puts into each page what would run a script or ask for something elsewhere.

use super::devtools::Browser;
use serde_json::{Value, json};

/// What must be said to be blocked.
const BLOCKED: [&str; 5] = ["base-uri", "connect-src", "object-src", "script-src-attr", "script-src-elem"];

/// Puts into the open page whatever could run or load something, and tries to lead its links elsewhere: what has run, whether
/// something was fetched, whether links lead elsewhere, and what was blocked. The page is of no use afterwards.
const HOSTILE: &str = "(async () => { const turns = count => { let left = count; return () => left-- <= 0 }; const place = document.createElement('div'); document.querySelector('main').append(place); const blocked = \
             []; document.addEventListener('securitypolicyviolation', event => blocked.push(event.effectiveDirective)); \
             place.innerHTML = '<img src=\"data:,x\" onerror=\"window.ran=1\"><svg onload=\"window.ran=2\"></svg><iframe \
             srcdoc=\"<script>parent.ran=3</script>\"></iframe><object data=\"data:text/html,x\"></object><a \
             href=\"javascript:window.ran=4\">a</a><form action=\"https://example.org/\"><button>b</button></form>'; \
             const script = document.createElement('script'); script.textContent = 'window.ran=5'; place.append(script); \
             const far = document.createElement('script'); far.src = 'data:text/javascript,window.ran=6'; place.append(far); \
             place.querySelector('button').click(); await until(turns(2)); place.querySelector('a').click(); setTimeout('window.ran=7'); \
             const base = document.createElement('base'); base.href = 'https://example.org/'; document.head.append(base); \
             const reached = await fetch('data:,x').then(() => true, () => false); \
             await until(turns(3)); if (document.querySelector('meta[content^=\"default-src\"]')) { const late = turns(10000); \
             await until(() => late() || ['base-uri', 'connect-src', 'object-src', 'script-src-attr', \
             'script-src-elem'].every(of => blocked.includes(of))); } \
             return [window.ran ?? null, reached, document.baseURI.startsWith('https:'), [...new Set(blocked)].sort()] })()";

/// What of all that is not prevented on the open page. What it has said until now is forgotten.
pub(super) fn holes(browser: &mut Browser) -> Vec<String> {
    browser.events();
    let ran = browser.evaluate(HOSTILE);
    // What it says of the last of it comes before this answer.
    browser.evaluate("null");
    let mut holes = Vec::new();
    if [&ran[0], &ran[1], &ran[2]] != [&json!(null), &json!(false), &json!(false)] {
        holes.push(format!("something runs or leads elsewhere: {ran}"));
    }
    let blocked: Vec<&str> = ran[3].as_array().into_iter().flatten().filter_map(Value::as_str).collect();
    holes.extend(
        BLOCKED.iter().filter(|of| !blocked.contains(of)).map(|of| format!("{of} is not blocked: {blocked:?}")),
    );
    let asks = |event: &Value| {
        let url = event["params"]["request"]["url"].as_str().unwrap_or_default();
        event["method"] == "Network.requestWillBeSent"
            && !["file:", "data:", "blob:"].iter().any(|own| url.starts_with(own))
    };
    holes.extend(browser.events().iter().find(|event| asks(event)).map(|asked| format!("asks: {asked}")));
    holes
}

#[test]
fn no_page_runs_a_script_or_asks_for_anything_that_is_put_into_it() {
    super::assert_none_of_the_book("policy");
}
