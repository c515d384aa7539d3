"""Calls of the program with a text."""

from __future__ import annotations

import json
from typing import List, Optional, Sequence, Tuple

from . import _program
from ._findings import Finding, Report, read_report

#: What a text may be written in.
FORMATS: Tuple[str, ...] = ("markdown", "latex", "xml", "html", "notebook", "plain", "csv", "typst")

#: Formats of files that are archives, and no text.
_ARCHIVES = ("docx", "docm", "odt", "epub")

_BINDINGS = ("never", "once", "always")

#: The version of the program's JSON that is read here.
_VERSION = 2


def _one_of(name: str, value: str, allowed: Sequence[str]) -> str:
    if value not in allowed:
        raise ValueError(f"{name} is {value!r}; it is one of {', '.join(allowed)}")
    return value


_GIVE_THE_FILE = "read a document of Word or LibreOffice or an e-book with the program, as in `proofread --format json thesis.docx`"


def report(
    text: str,
    format: str = "markdown",
    *,
    units: bool = False,
    doubts: bool = False,
    less_certain: bool = False,
    agreeing: bool = False,
    unchecked: bool = False,
    bindings: str = "never",
    statistics: bool = True,
    timeout: Optional[float] = None,
) -> Report:
    """What a text gives: its findings, its counts and, with `unchecked`, the chains that were not checked.

    `format` is one of `FORMATS`: `markdown`, `latex`, `xml`, `html`, `notebook`, `plain`, `csv` or `typst`. Documents of Word and
    LibreOffice and e-books are no text and are read by the program alone: `proofread --format json thesis.docx`. `timeout` is in seconds.
    The other options are those of the program: `units`, `doubts`, `less_certain` and `agreeing` add lists; `bindings` (`never`, `once` or `always`)
    puts values of names into formulas; `statistics` compares p-values, intervals, shares and totals.

    Raises `UnreadableText` if the text cannot be read in its format, `ProgramError` if the program cannot be run, `TypeError` if the
    text is no `str`, and `ValueError` for a format or an option that is not known.
    """
    if not isinstance(text, str):
        remedy = "decode it" if isinstance(text, (bytes, bytearray, memoryview)) else "read its text"
        raise TypeError(f"text is of type {type(text).__name__}; give a str: {remedy}, or {_GIVE_THE_FILE}")
    if format in _ARCHIVES:
        raise ValueError(f"format is {format!r}, which is no format of a text ({', '.join(FORMATS)}); {_GIVE_THE_FILE}")
    _one_of("format", format, FORMATS)
    arguments = ["--input", "jsonl", "--format", "jsonl", f"--bindings={_one_of('bindings', bindings, _BINDINGS)}"]
    arguments.append("--statistics=" + ("always" if statistics else "never"))
    switches = {"--units": units, "--doubts": doubts, "--less-certain": less_certain, "--agreeing": agreeing, "--unchecked": unchecked}
    arguments += [name for name, wanted in switches.items() if wanted]
    line = json.dumps({"id": "text", "format": format, "text": text})
    answered = _program.answer([*arguments, "-"], line.encode("ascii"), timeout)
    for answer in answered.decode("utf-8").splitlines():
        value = json.loads(answer)
        if value["version"] != _VERSION:
            raise _program.ProgramError(
                f"the program writes version {value['version']} of its JSON, and this package reads version {_VERSION}; "
                "install both again"
            )
        if "document" in value:
            return read_report(value["document"], text)
    raise _program.ProgramError("the program told nothing of the text; install geneva-proofread again")


def check(
    text: str,
    format: str = "markdown",
    *,
    units: bool = False,
    doubts: bool = False,
    less_certain: bool = False,
    agreeing: bool = False,
    bindings: str = "never",
    statistics: bool = True,
    timeout: Optional[float] = None,
) -> List[Finding]:
    """What is found in a text; the formats, options and errors are those of `report`."""
    found = report(
        text,
        format,
        units=units,
        doubts=doubts,
        less_certain=less_certain,
        agreeing=agreeing,
        bindings=bindings,
        statistics=statistics,
        timeout=timeout,
    )
    return list(found.findings)
