//! What a page may load and run: a Content-Security-Policy in each page.
//!
//! Scripts and styles that stand in a page are allowed by their hashes, so that text that finds its way into a page is never
//! run as a script. Scripts, styles, fonts and pictures in files are allowed from the book's own place. (A hash for a
//! script in a file needs subresource integrity, and browsers refuse that for a page that is opened from disk.) WebAssembly
//! and a thread of its own are allowed where a figure moves, a text is proofread or a claim can be checked. Nothing may be sent anywhere.

use anyhow::{Context, ensure};
use html5ever::tokenizer::states::RawKind;
use html5ever::tokenizer::{
    BufferQueue, EndTag, StartTag, Token, TokenSink, TokenSinkResult, Tokenizer, TokenizerOpts,
};
use sha2::{Digest, Sha256};
use std::cell::RefCell;
use std::collections::BTreeSet;

use crate::base64::base64;
use crate::book::PageModule;
use crate::cache::Shelf;
use crate::citing;
use crate::verify;

/// The element behind which the policy stands: as the pages have it, and as those that lead on to another have it.
const BEFORE: [&str; 2] = ["<meta charset=\"UTF-8\">", "<meta charset=\"utf-8\">"];

/// A page with its policy, which is the first thing that a browser reads. These modules may answer it.
pub(crate) fn guarded(page: &str, modules: &[PageModule], shelf: &Shelf) -> anyhow::Result<String> {
    let split = BEFORE.iter().find_map(|before| page.split_once(before).map(|(head, rest)| (head, before, rest)));
    let (head, before, rest) = split.with_context(|| format!("it has no `{}`", BEFORE[0]))?;
    ensure!(!head.contains("<script"), "a script stands before `{before}`");
    let policy = policy(&inline_by_parts(page, modules, shelf)?);
    Ok(format!("{head}{before}<meta http-equiv=\"Content-Security-Policy\" content=\"{policy}\">{rest}"))
}

/// What stands in a page, and whether a figure of it moves.
#[derive(Debug, Default)]
struct Inline {
    scripts: BTreeSet<String>,
    styles: BTreeSet<String>,
    moves: bool,
}

fn policy(inline: &Inline) -> String {
    let hashes = |texts: &BTreeSet<String>| {
        texts.iter().map(|text| format!(" 'sha256-{}'", base64(&Sha256::digest(text)))).collect::<String>()
    };
    let (module, thread) = if inline.moves { (" 'wasm-unsafe-eval'", "; worker-src blob:") } else { ("", "") };
    format!(
        "default-src 'none'; script-src 'self'{module}{}; style-src 'self'{}; style-src-attr 'unsafe-inline'; img-src 'self' \
         data:; font-src 'self'; frame-src 'self'{thread}; base-uri 'none'; form-action 'none'",
        hashes(&inline.scripts),
        hashes(&inline.styles)
    )
}

/// What stands in a page: in its text, which may come from a shelf, and in its frame, which names files by their content.
fn inline_by_parts(page: &str, modules: &[PageModule], shelf: &Shelf) -> anyhow::Result<Inline> {
    let (Some(start), Some(end)) = (page.find("<main>"), page.rfind("</main>")) else {
        return Ok(inline(page, modules));
    };
    let Some(text) = page.get(start..end) else { return Ok(inline(page, modules)) };
    // The foot of a page has neither scripts nor styles.
    let text = citing::without_foot(text);
    let texts = shelf.recall("inline", &[&text], || {
        let Inline { scripts, styles, moves } = inline(&text, modules);
        let [scripts, styles] = [(SCRIPT, scripts), (STYLE, styles)]
            .map(|(what, texts)| texts.into_iter().flat_map(move |text| [what.to_owned(), text]));
        Ok(scripts.chain(styles).chain(moves.then(|| MOVES.to_owned())).collect())
    })?;
    let mut all = inline(&page[..start], modules);
    let behind = inline(&page[end..], modules);
    all.scripts.extend(behind.scripts);
    all.styles.extend(behind.styles);
    all.moves |= behind.moves;
    let mut texts = texts.into_iter();
    while let Some(what) = texts.next() {
        match &*what {
            SCRIPT => all.scripts.extend(texts.next()),
            STYLE => all.styles.extend(texts.next()),
            _ => all.moves = true,
        }
    }
    Ok(all)
}

/// What says of the next text on a shelf what it is, and that a figure moves.
const SCRIPT: &str = "script";
const STYLE: &str = "style";
const MOVES: &str = "moves";

fn inline(page: &str, modules: &[PageModule]) -> Inline {
    let tokenizer = Tokenizer::new(InlineSink { modules, state: RefCell::default() }, TokenizerOpts::default());
    let queue = BufferQueue::default();
    queue.push_back(page.into());
    // A page holds no script that would have to run while it is read.
    let _ = tokenizer.feed(&queue);
    tokenizer.end();
    tokenizer.sink.state.into_inner().inline
}

struct InlineSink<'a> {
    modules: &'a [PageModule],
    state: RefCell<State>,
}

#[derive(Default)]
struct State {
    inline: Inline,
    /// The text of the script or style that is open.
    open: Option<String>,
}

impl TokenSink for InlineSink<'_> {
    type Handle = ();

    fn process_token(&self, token: Token, _: u64) -> TokenSinkResult<()> {
        let mut state = self.state.borrow_mut();
        match token {
            Token::TagToken(tag) if tag.kind == StartTag => {
                let has = |name: &str| tag.attrs.iter().any(|of| &*of.name.local == name);
                state.inline.moves |= self.modules.iter().any(|module| has(module.asking()))
                    || tag.attrs.iter().any(|of| &*of.name.local == "src" && &*of.value == verify::SCRIPT);
                let raw = match &*tag.name {
                    "script" => RawKind::ScriptData,
                    "style" => RawKind::Rawtext,
                    _ => return TokenSinkResult::Continue,
                };
                state.open = (!has("src")).then(String::new);
                return TokenSinkResult::RawData(raw);
            }
            Token::TagToken(tag) if tag.kind == EndTag && ["script", "style"].contains(&&*tag.name) => {
                if let Some(text) = state.open.take().filter(|text| !text.is_empty()) {
                    let inline = &mut state.inline;
                    let texts = if &*tag.name == "script" { &mut inline.scripts } else { &mut inline.styles };
                    texts.insert(text);
                }
            }
            Token::CharacterTokens(text) => {
                if let Some(open) = &mut state.open {
                    open.push_str(&text);
                }
            }
            _ => {}
        }
        TokenSinkResult::Continue
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::samples::BOOK;

    #[test]
    fn scripts_and_styles_in_a_page_are_allowed_by_their_hashes() {
        let page = "<html><head><meta charset=\"UTF-8\"><script>alert('Hello, world.');</script><script src=\"a.js\"></script>\
                    <style>a{}</style></head><body><pre>&lt;script&gt;no&lt;/script&gt;</pre></body></html>";
        let guarded = guarded(page, BOOK.modules, &Shelf::empty()).expect("a policy");
        let policy = guarded.split("content=\"").nth(1).and_then(|rest| rest.split('"').next()).expect("a policy");
        // The hash is the example of the specification, Content Security Policy Level 3, section 8.
        let script = "script-src 'self' 'sha256-qznLcsROx4GACP2dm0UCKCzCG+HiZ1guq6ZZDob/Tng=';";
        assert!(policy.contains(script), "{policy}");
        assert_eq!(policy.matches("sha256-").count(), 2, "{policy}");
        assert!(!policy.contains("wasm") && !policy.contains("worker"), "{policy}");
        assert_eq!(
            guarded.replace(&format!("<meta http-equiv=\"Content-Security-Policy\" content=\"{policy}\">"), ""),
            page
        );
    }

    #[test]
    fn a_module_is_allowed_where_a_figure_moves() {
        let page = "<head><meta charset=\"UTF-8\"></head><figure data-live=\"wheel\"></figure>";
        let guarded = guarded(page, BOOK.modules, &Shelf::empty()).expect("a policy");
        assert!(guarded.contains("script-src 'self' 'wasm-unsafe-eval';") && guarded.contains("worker-src blob:"));
    }

    #[test]
    fn a_page_without_a_place_for_its_policy_is_refused() {
        assert!(guarded("<head></head>", &[], &Shelf::empty()).is_err());
        assert!(guarded("<script>a</script><meta charset=\"UTF-8\">", &[], &Shelf::empty()).is_err());
    }
}
