"""Recomputes the chains of numbers that a text prints.

>>> import proofread
>>> [finding] = proofread.check("It is $3 + 3 = 7$.")
>>> finding.printed, finding.recomputed
('7', '6')

The program of the same name does the work. It comes with this package and is started once for each call.
"""

from ._check import FORMATS, check, report
from ._findings import Finding, Place, Report, Span, UncheckedChain
from ._program import ProgramError, ProofreadError, UnreadableText, program

__all__ = [
    "FORMATS",
    "Finding",
    "Place",
    "ProgramError",
    "ProofreadError",
    "Report",
    "Span",
    "UncheckedChain",
    "UnreadableText",
    "check",
    "program",
    "report",
]
