"""Makes the book's mathematical font out of TeX Gyre Pagella Math: see README.md."""

import sys

from fontTools import subset
from fontTools.pens.boundsPen import BoundsPen
from fontTools.pens.t2CharStringPen import T2CharStringPen
from fontTools.pens.transformPen import TransformPen
from fontTools.ttLib import TTFont, newTable
from fontTools.ttLib.tables import otTables

NAME = "Wheel Math"
BRACKETS = "()[]{}|‖⟨⟩⌊⌋⌈⌉"
# How much wider than a bracket the tallest form of it may be.
WIDEST = 1.12
# How many sizes of a bracket or a brace there are before it is assembled from pieces.
SIZES = 5


def main(source, characters, target):
    font = TTFont(source, recalcTimestamp=False)
    wanted = {character for character in open(characters, encoding="utf-8").read() if character >= " "}
    missing = sorted(wanted - {chr(code) for code in font.getBestCmap()})
    if missing:
        sys.exit("the font has no " + " ".join(f"U+{ord(character):04X}" for character in missing))
    lower_primes(font)
    drop_sizes(font)
    options = subset.Options(layout_features=[], desubroutinize=True, hinting=False, notdef_outline=True)
    options.drop_tables += ["FFTM", "GSUB", "GPOS", "DSIG"]
    subsetter = subset.Subsetter(options)
    subsetter.populate(unicodes=[ord(character) for character in wanted])
    subsetter.subset(font)
    narrow_brackets(font)
    widen_accents(font)
    rename(font)
    font.flavor = "woff2"
    font.save(target)


def lower_primes(font):
    """Primes stand in superscripts, and only Firefox would take the forms meant for them by itself."""
    cmap = font.getBestCmap()
    for prime in "′″‴":
        name = cmap[ord(prime)]
        redraw(font, {name: (1, 0)}, drawn_as=name + ".st")


def drop_sizes(font):
    variants = font["MATH"].table.MathVariants
    for construction in variants.VertGlyphConstruction + variants.HorizGlyphConstruction:
        if construction.GlyphAssembly:
            del construction.MathGlyphVariantRecord[SIZES:]
            construction.VariantCount = len(construction.MathGlyphVariantRecord)


def narrow_brackets(font):
    """Chromium gives every stretched bracket the width of the widest form of it."""
    cmap = font.getBestCmap()
    variants = font["MATH"].table.MathVariants
    constructions = dict(zip(variants.VertGlyphCoverage.glyphs, variants.VertGlyphConstruction))
    for bracket in BRACKETS:
        name = cmap[ord(bracket)]
        allowed = font["hmtx"][name][0] * WIDEST
        construction = constructions[name]
        taller = [[record.VariantGlyph] for record in construction.MathGlyphVariantRecord[1:]]
        if construction.GlyphAssembly:
            taller.append(sorted({part.glyph for part in construction.GlyphAssembly.PartRecords}))
        for glyphs in taller:
            narrow(font, glyphs, allowed)


def narrow(font, glyphs, allowed):
    advance = max(font["hmtx"][glyph][0] for glyph in glyphs)
    if advance <= allowed:
        return
    left = min(bounds(font, glyph)[0] for glyph in glyphs)
    right = max(bounds(font, glyph)[2] for glyph in glyphs)
    scale = min(1, (allowed - 90) / (right - left))
    # What room is left beside the ink is shared as it was.
    room = allowed - (right - left) * scale
    start = room * left / (left + advance - right)
    redraw(font, {glyph: (scale, start - left * scale) for glyph in glyphs}, advance=round(allowed))


def widen_accents(font):
    """A sign without width, as a combining accent is, would not be centred over its letter."""
    cmap = font.getBestCmap()
    table = font["MATH"].table.MathVariants
    forms = dict(zip(table.HorizGlyphCoverage.glyphs, table.HorizGlyphConstruction))
    accents = {name for code, name in cmap.items() if 0x300 <= code < 0x370 or 0x20D0 <= code < 0x2100}
    points = font["MATH"].table.MathGlyphInfo.MathTopAccentAttachment
    attached = dict(zip(points.TopAccentCoverage.glyphs, points.TopAccentAttachment))
    letters = {}
    for name in sorted(accents):
        records = forms[name].MathGlyphVariantRecord if name in forms else []
        for glyph in sorted({name} | {record.VariantGlyph for record in records}):
            left, _, right, _ = bounds(font, glyph)
            redraw(font, {glyph: (1, -left)}, advance=round(right - left))
            if glyph in attached:
                attached[glyph].Value = round((right - left) / 2)
            letters[glyph] = 1
    # They are called letters now; from a mark a browser would take its width away again.
    classes = otTables.GlyphClassDef()
    classes.classDefs = letters
    table = otTables.GDEF()
    table.Version = 0x00010000
    table.GlyphClassDef = classes
    table.AttachList = table.LigCaretList = table.MarkAttachClassDef = None
    font["GDEF"] = newTable("GDEF")
    font["GDEF"].table = table


def bounds(font, glyph):
    glyphs = font.getGlyphSet()
    pen = BoundsPen(glyphs)
    glyphs[glyph].draw(pen)
    return pen.bounds or (0, 0, 0, 0)


def redraw(font, changes, advance=None, drawn_as=None):
    """Scales and shifts glyphs sideways."""
    top = font["CFF "].cff.topDictIndex[0]
    for glyph, (scale, shift) in changes.items():
        glyphs = font.getGlyphSet()
        width = font["hmtx"][drawn_as or glyph][0] if advance is None else advance
        old = top.CharStrings[glyph]
        # A drawing says its width as a difference, and some browsers read it there instead of in hmtx.
        pen = T2CharStringPen(width - old.private.nominalWidthX, glyphs)
        glyphs[drawn_as or glyph].draw(TransformPen(pen, (scale, 0, 0, 1, shift, 0)))
        top.CharStrings[glyph] = pen.getCharString(old.private, old.globalSubrs)
        font["hmtx"][glyph] = (width, round(bounds(font, glyph)[0]))


def rename(font):
    names = font["name"]
    names.names = [record for record in names.names if record.nameID in (0, 5)]
    for number, text in {
        1: NAME,
        2: "Regular",
        4: NAME,
        6: NAME.replace(" ", ""),
        10: "A changed part of TeX Gyre Pagella Math",
        13: "GUST Font License",
    }.items():
        names.setName(text, number, 3, 1, 0x409)
    cff = font["CFF "].cff
    cff.fontNames = [NAME.replace(" ", "")]
    top = cff.topDictIndex[0]
    top.FullName = top.FamilyName = NAME


main(*sys.argv[1:])
