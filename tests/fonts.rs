//! Do all browsers set letters with the same widths, and has the text's face every sign that the pages need? Opens the fonts
//! that are in the repository.

use crate::book_pages::{Piece, pages};
use std::collections::BTreeSet;
use std::ops::RangeInclusive;
use ttf_parser::{Face, GlyphId};

/// The cuts of the text's face, which a page may weigh together.
const TEXT: [&str; 3] = ["wheel-text-regular", "wheel-text-bold", "wheel-text-italic"];
const HEAVIEST_TEXT: usize = 60_000;

/// What the text takes from the font of formulas: `Wheel Signs` in `fonts.css`.
const SIGNS: [RangeInclusive<char>; 3] = ['\u{370}'..='\u{3ff}', '\u{2010}'..='\u{22ff}', '\u{2a00}'..='\u{2aff}'];

/// What no font of the book has: dots above a letter, some lowered letters, marks, which have fonts of their own, and what is
/// not drawn.
const ELSEWHERE: &str = "\u{307}\u{308}ᵣₑₗ✓✗\u{2060}\u{ad}";

/// A font in WOFF2, and unpacked.
fn font(name: &str) -> (Vec<u8>, Vec<u8>) {
    let packed = std::fs::read(crate::path("book/theme/fonts").join(name).with_extension("woff2")).expect("a font");
    let font = wuff::decompress_woff2(&packed).expect("WOFF2");
    (packed, font)
}

/// A glyph has its width in two places, in a table and with its drawing, and each browser reads one of them.
#[test]
fn each_sign_is_as_wide_in_its_drawing_as_in_the_table_of_widths() {
    for name in TEXT.into_iter().chain(["wheel-math"]) {
        let (_, font) = font(name);
        let face = Face::parse(&font, 0).expect("OpenType");
        let drawings = face.tables().cff.expect("drawings");
        let glyphs = face.number_of_glyphs();
        let widths = |glyph| (face.glyph_hor_advance(glyph), drawings.glyph_width(glyph));
        let found: Vec<_> = (0..glyphs)
            .map(|glyph| (glyph, widths(GlyphId(glyph))))
            .filter(|(_, (advance, drawn))| advance.is_none() || advance != drawn)
            .collect();
        assert!(
            glyphs > 0 && found.is_empty(),
            "{name}: {} of {glyphs} glyphs, with both widths: {found:?}",
            found.len()
        );
    }
}

#[test]
fn the_face_of_the_text_is_light_and_its_digits_are_all_as_wide() {
    let fonts = TEXT.map(font);
    let weight: usize = fonts.iter().map(|(packed, _)| packed.len()).sum();
    assert!((30_000..=HEAVIEST_TEXT).contains(&weight), "{weight} bytes; {HEAVIEST_TEXT} are allowed");
    let widths: BTreeSet<_> = fonts
        .iter()
        .flat_map(|(_, font)| {
            let face = Face::parse(font, 0).expect("OpenType");
            ('0'..='9').map(|digit| face.glyph_hor_advance(face.glyph_index(digit)?)).collect::<Vec<_>>()
        })
        .collect();
    assert!(widths.len() == 1 && !widths.contains(&None), "columns of numbers would not align: {widths:?}");
}

/// What is set in other fonts: formulas and drawings, programs, the marks of claims.
const OTHERS: [&str; 5] = ["math", "svg", "pre", "code", "button"];

#[test]
fn the_book_has_every_sign_that_its_text_needs() {
    let (texts, (_, signs)) = (TEXT.map(|name| font(name).1), font("wheel-math"));
    let texts: Vec<_> = texts.iter().map(|font| Face::parse(font, 0).expect("OpenType")).collect();
    let signs = Face::parse(&signs, 0).expect("OpenType");
    let is_set = |c: char| {
        texts.iter().all(|face| face.glyph_index(c).is_some())
            || SIGNS.iter().any(|range| range.contains(&c)) && signs.glyph_index(c).is_some()
    };
    let mut read = BTreeSet::new();
    for page in pages().values() {
        let (mut main, mut other) = (0_i32, 0_i32);
        for piece in page {
            match piece {
                Piece::Start { element, .. } if OTHERS.contains(&element.as_str()) => other += 1,
                Piece::End(element) if OTHERS.contains(&element.as_str()) => other -= 1,
                Piece::Start { element, .. } if element == "main" => main += 1,
                Piece::End(element) if element == "main" => main -= 1,
                Piece::Text(text) if main > 0 && other == 0 => read.extend(text.chars().filter(|c| !c.is_control())),
                _ => {}
            }
        }
    }
    let missing: String = read.iter().filter(|c| !is_set(**c) && !ELSEWHERE.contains(**c)).collect();
    assert!(read.len() > 100 && missing.is_empty(), "add to book/theme/maths/text-characters.txt: {missing:?}");
    let needless: String = ELSEWHERE.chars().filter(|c| *c != '\u{ad}' && !read.contains(c)).collect();
    assert!(needless.is_empty(), "no page has {needless:?} any more");
}
