"""Makes the three cuts of the book's text face out of TeX Gyre Pagella: see README.md."""

import sys
from pathlib import Path

from fontTools import subset
from fontTools.pens.boundsPen import BoundsPen
from fontTools.pens.t2CharStringPen import T2CharStringPen
from fontTools.pens.transformPen import TransformPen
from fontTools.ttLib import TTFont

NAME = "Wheel Text"
# Cuts by the end of their files' names, with their weights.
CUTS = {"regular": 400, "bold": 700, "italic": 400}
# Pairs of letters stand close, and f with i is one sign. The figures of this face are all equally wide and stand on the line.
FEATURES = ["kern", "liga"]
# The face has the exponents 1 to 3. The other small signs are made of the large ones, in the same size.
SMALL = {
    **dict(zip("⁰⁴⁵⁶⁷⁸⁹⁺⁻", zip("0456789+−", [1] * 9))),
    **dict(zip("₀₁₂₃₄₅₆₇₈₉", zip("0123456789", [0] * 10))),
}


def main(source, characters, target):
    wanted = {character for character in open(characters, encoding="utf-8").read() if character >= " "}
    for cut, weight in CUTS.items():
        font = TTFont(Path(source) / f"texgyrepagella-{cut}.otf", recalcTimestamp=False)
        add_small_signs(font)
        missing = sorted(wanted - {chr(code) for code in font.getBestCmap()})
        if missing:
            sys.exit(f"the {cut} cut has no " + " ".join(f"U+{ord(character):04X}" for character in missing))
        options = subset.Options(layout_features=FEATURES, desubroutinize=True, hinting=False, notdef_outline=True)
        options.drop_tables += ["FFTM", "DSIG"]
        subsetter = subset.Subsetter(options)
        subsetter.populate(unicodes=[ord(character) for character in wanted])
        subsetter.subset(font)
        rename(font, cut)
        # A file that another one has been made from says its weight and slope as that one does.
        assert font["OS/2"].usWeightClass == weight, cut
        font.flavor = "woff2"
        font.save(Path(target) / f"wheel-text-{cut}.woff2")


def add_small_signs(font):
    cmap = font.getBestCmap()
    (_, low, _, high), (_, raised, _, top) = bounds(font, cmap[ord("1")]), bounds(font, cmap[ord("¹")])
    scale = (top - raised) / (high - low)
    for character, (large, is_raised) in SMALL.items():
        up = raised if is_raised else -0.4 * (top - raised)
        draw(font, character, cmap[ord(large)], scale, up - low * scale)


def bounds(font, glyph):
    glyphs = font.getGlyphSet()
    pen = BoundsPen(glyphs)
    glyphs[glyph].draw(pen)
    return pen.bounds


def draw(font, character, glyph, scale, up):
    """Adds a sign that is another one in another size and height."""
    name, glyphs = f"uni{ord(character):04X}", font.getGlyphSet()
    top = font["CFF "].cff.topDictIndex[0]
    old = top.CharStrings[glyph]
    width = round(scale * font["hmtx"][glyph][0])
    pen = T2CharStringPen(width - old.private.nominalWidthX, glyphs)
    glyphs[glyph].draw(TransformPen(pen, (scale, 0, 0, scale, 0, up)))
    top.CharStrings.charStringsIndex.append(pen.getCharString(old.private, old.globalSubrs))
    top.CharStrings.charStrings[name] = len(top.CharStrings.charStringsIndex) - 1
    top.charset.append(name)
    font["maxp"].numGlyphs += 1
    font["hmtx"][name] = (width, round(scale * font["hmtx"][glyph][1]))
    for table in font["cmap"].tables:
        if table.isUnicode():
            table.cmap[ord(character)] = name


def rename(font, cut):
    names = font["name"]
    names.names = [record for record in names.names if record.nameID in (0, 5)]
    style = cut.capitalize()
    postscript = f"{NAME.replace(' ', '')}-{style}"
    for number, text in {
        1: NAME,
        2: style,
        4: f"{NAME} {style}",
        6: postscript,
        10: "A part of TeX Gyre Pagella",
        13: "GUST Font License",
    }.items():
        names.setName(text, number, 3, 1, 0x409)
    cff = font["CFF "].cff
    cff.fontNames = [postscript]
    top = cff.topDictIndex[0]
    top.FullName, top.FamilyName = f"{NAME} {style}", NAME


main(*sys.argv[1:])
