//! Do all browsers set formulas with the same widths? Opens the font of formulas that is in the repository.

use ttf_parser::{Face, GlyphId};

/// A glyph has its width in two places, in a table and with its drawing, and each browser reads one of them.
#[test]
fn each_sign_is_as_wide_in_its_drawing_as_in_the_table_of_widths() {
    let packed = std::fs::read(crate::path("book/theme/fonts/wheel-math.woff2")).expect("the font");
    let font = wuff::decompress_woff2(&packed).expect("WOFF2");
    let face = Face::parse(&font, 0).expect("OpenType");
    let drawings = face.tables().cff.expect("drawings");
    let glyphs = face.number_of_glyphs();
    let widths = |glyph| (face.glyph_hor_advance(glyph), drawings.glyph_width(glyph));
    let found: Vec<_> = (0..glyphs)
        .map(|glyph| (glyph, widths(GlyphId(glyph))))
        .filter(|(_, (advance, drawn))| advance.is_none() || advance != drawn)
        .collect();
    assert!(glyphs > 0 && found.is_empty(), "{} of {glyphs} glyphs, with both widths: {found:?}", found.len());
}
