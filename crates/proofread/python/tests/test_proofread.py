"""The package finds what the program finds, at the same places, and tells what goes wrong."""

import doctest
import os
import subprocess
import sys
import unittest
from pathlib import Path
from unittest import mock

import proofread

TEXT = "Größe: it is $\\tan 31.0^\\circ = 0.609$ – no.\r\n\r\nAnd $2 + 2 = 4$, 😀 $5 + 5 = 11$.\n"


class Checks(unittest.TestCase):
    def test_findings_have_numbers_and_places(self):
        first, second = proofread.check(TEXT)
        self.assertEqual((first.section, first.verdict), ("numbers", "inconsistent"))
        self.assertEqual((first.printed, first.recomputed), ("0.609", "0.601"))
        self.assertEqual(first.hint, "`0.601` for `0.609`")
        self.assertEqual([TEXT[of.at.start : of.at.end] for of in (first, second)], ["0.609", "11"])
        self.assertEqual((second.at.line, second.at.column), (3, 29))
        self.assertEqual(TEXT[second.chain_at.start : second.chain_at.end], "5 + 5 = 11")

    def test_nothing_is_found_in_a_text_that_is_right(self):
        for text in ["", "\n", "$2 + 2 = 4$", "😀"]:
            self.assertEqual(proofread.check(text), [])

    def test_a_format_is_read_as_it_is_named(self):
        self.assertEqual(len(proofread.check("\\[ 2 + 2 = 5 \\] % $1 + 1 = 3$", "latex")), 1)
        self.assertEqual(len(proofread.check("<p>2 + 2 = 5</p>", format="html")), 1)
        typst = "Ü: $ 7/2 = 3.6 $ and $ 7/2 = 3.5 $"
        [finding] = proofread.check(typst, "typst")
        self.assertEqual((finding.recomputed, typst[finding.at.start : finding.at.end]), ("3.5", "3.6"))
        for format in proofread.FORMATS:
            text = '{"cells": []}' if format == "notebook" else ""
            self.assertEqual(proofread.check(text, format), [])

    def test_options_are_those_of_the_program(self):
        self.assertEqual(proofread.check("t(28) = 2.20, p = .36", "plain", statistics=False), [])
        self.assertEqual(proofread.check("t(28) = 2.20, p = .36", "plain")[0].section, "statistics")
        agreeing = proofread.check("$2 + 2 = 4$", agreeing=True)
        self.assertEqual([of.section for of in agreeing], ["agreeing"])
        names = "Let $a = 5.0$. Then $2a = 12.0$."
        self.assertEqual((proofread.check(names), len(proofread.check(names, bindings="always"))), ([], 1))
        report = proofread.report("$\\foo + 1 = 2$ and $1 + 1 = 2$", unchecked=True)
        self.assertEqual((report.tally["checked"], report.findings), (1, ()))
        self.assertIn("\\foo", [of.name for of in report.unchecked])
        self.assertEqual(proofread.report("$\\foo + 1 = 2$").unchecked, ())

    def test_what_is_less_certain_stands_apart_and_one_shape_is_told_once(self):
        text = "Ä $2 + 2 = 5$\n\n$3 + 3 = 7$, $|3| = 4$"
        [finding] = proofread.check(text)
        self.assertEqual([place.chain for place in finding.places], ["2 + 2 = 5", "3 + 3 = 7"])
        self.assertEqual([text[place.at.start : place.at.end] for place in finding.places], ["5", "7"])
        [listed, apart] = proofread.check(text, less_certain=True)
        self.assertEqual((listed, apart.section), (finding, "less-certain"))
        self.assertIn("neither side computes anything", apart.caveat)

    def test_what_goes_wrong_is_raised(self):
        with self.assertRaisesRegex(proofread.UnreadableText, "not a Jupyter notebook"):
            proofread.check("no notebook", "notebook")
        with self.assertRaises(proofread.UnreadableText):
            proofread.check("half a pair: \ud800")
        with self.assertRaisesRegex(ValueError, "format is 'word'; it is one of markdown, latex"):
            proofread.check("", "word")
        with self.assertRaisesRegex(ValueError, "bindings is 'often'; it is one of never"):
            proofread.check("", bindings="often")
        with self.assertRaisesRegex(TypeError, "text is of type bytes; give a str"):
            proofread.check(b"")
        for given in [b"PK", bytearray(b"PK"), Path("thesis.docx")]:
            with self.assertRaisesRegex(TypeError, "give a str: .*, or read a document of Word .*proofread --format json thesis.docx"):
                proofread.check(given, "docx")
        for format in ["docx", "odt", "epub"]:
            with self.assertRaisesRegex(ValueError, "no format of a text .*typst.*; read a document of Word"):
                proofread.check("", format)
        with mock.patch.dict(os.environ, {"PROOFREAD_PROGRAM": "no-such-program"}):
            with self.assertRaisesRegex(proofread.ProgramError, "PROOFREAD_PROGRAM names 'no-such-program'"):
                proofread.check("")
        with mock.patch.dict(os.environ, {"PROOFREAD_PROGRAM": __file__}):
            with self.assertRaises(proofread.ProofreadError):
                proofread.check("")
        with self.assertRaisesRegex(proofread.ProgramError, "give a shorter text or a longer timeout"):
            proofread.check("$2 + 2 = 4$\n" * 100000, timeout=0.001)

    def test_a_long_text_is_read_whole(self):
        text = "Ä line.\n" * 100000 + "$2 + 2 = 5$"
        [finding] = proofread.check(text)
        self.assertEqual(text[finding.at.start : finding.at.end], "5")

    def test_the_program_runs_as_a_module(self):
        done = subprocess.run([sys.executable, "-m", "proofread", "-"], input=b"$2 + 2 = 5$", capture_output=True)
        self.assertEqual(done.returncode, 1)
        self.assertIn(b"printed 5, recomputed 4", done.stdout)

    def test_the_example_is_right(self):
        self.assertEqual(doctest.testmod(proofread).failed, 0)


if __name__ == "__main__":
    unittest.main()
