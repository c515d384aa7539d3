"""What was found, as the program tells it."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Dict, Optional, Set, Tuple


@dataclass(frozen=True)
class Span:
    """A stretch of a text: `text[span.start:span.end]`. Lines and columns begin with 1, and a column is a character."""

    start: int
    end: int
    line: int
    column: int
    end_line: int
    end_column: int


@dataclass(frozen=True)
class Place:
    """A place of a finding: differences of one shape in one text are one finding."""

    chain: str
    left: str
    right: str
    #: The printed result with its unit.
    printed: str
    #: The result that is computed, with as many digits; none if the sides have no common unit.
    recomputed: Optional[str]
    #: The single edit that would make the sides agree, in words, if there is exactly one near.
    hint: Optional[str]
    #: The place to look at.
    at: Span
    #: The place of the chain.
    chain_at: Span


@dataclass(frozen=True)
class Finding:
    """Two neighbouring sides of a chain that do not agree."""

    #: The list on which it stands: `numbers`, `units`, `bindings`, `agreeing`, `doubts`, `statistics` or `less-certain`.
    section: str
    #: How the sides compare, such as `inconsistent` or `last-digit`.
    verdict: str
    #: The verdict in words.
    message: str
    #: The chain as one line; of a long one, the part around the two sides.
    chain: str
    left: str
    right: str
    #: The printed result with its unit.
    printed: str
    #: The result that is computed, with as many digits; none if the sides have no common unit.
    recomputed: Optional[str]
    #: The single edit that would make the sides agree, in words, if there is exactly one near.
    hint: Optional[str]
    #: The name of the explanation that decided the verdict, if there is one.
    explanation: Optional[str]
    #: What keeps the sides from being compared.
    why: Optional[str]
    #: Why the difference is set aside, if it is.
    doubt: Optional[str]
    #: What makes it less certain that the text is wrong there.
    caveat: Optional[str]
    #: How the characters were read, where there was a choice.
    reading: Tuple[str, ...]
    #: Names whose values were taken from elsewhere in the text.
    names: Tuple[str, ...]
    #: The place to look at.
    at: Span
    #: The place of the chain.
    chain_at: Span
    #: All places with a difference of this shape, this one first.
    places: Tuple[Place, ...]


@dataclass(frozen=True)
class UncheckedChain:
    """A chain that was not checked, or not in all of its parts."""

    #: The kind of the reason, such as `letters`.
    kind: str
    #: The command, letter or word that is the reason; may be empty.
    name: str
    #: The reason in words.
    reason: str
    chain: str
    #: Whether some of its sides were compared.
    partly: bool
    chain_at: Span


@dataclass(frozen=True)
class Report:
    """What a text gave."""

    findings: Tuple[Finding, ...]
    #: The chains that were not checked; empty unless they were asked for.
    unchecked: Tuple[UncheckedChain, ...]
    #: Counts, as in the `tally` of the program's JSON: of `chains`, `checkable` and `checked` ones, of `pairs`, and others.
    tally: Dict[str, Any]


def _offsets(value: Any, found: Set[int]) -> None:
    for key in ("at", "chain_at"):
        if key in value:
            found.update(value[key]["bytes"])
    for place in value.get("places", []):
        _offsets(place, found)


def _indices(text: str, offsets: Set[int]) -> Dict[int, int]:
    """The index in the text of each offset in its bytes."""
    if text.isascii():
        return {offset: offset for offset in offsets}
    data = text.encode("utf-8")
    indices: Dict[int, int] = {}
    at, index = 0, 0
    for offset in sorted(offsets):
        index += len(data[at:offset].decode("utf-8", "ignore"))
        at = offset
        indices[offset] = index
    return indices


def _span(value: Any, indices: Dict[int, int]) -> Span:
    start, end = (indices[offset] for offset in value["bytes"])
    return Span(
        start,
        end,
        value["start"]["line"],
        value["start"]["column"],
        value["end"]["line"],
        value["end"]["column"],
    )


def _of_place(value: Any, indices: Dict[int, int]) -> Dict[str, Any]:
    """What a finding and each of its places have alike."""
    words = ("chain", "left", "right", "printed", "recomputed", "hint")
    spans = ("at", "chain_at")
    return {**{key: value[key] for key in words}, **{key: _span(value[key], indices) for key in spans}}


def read_report(document: Any, text: str) -> Report:
    """The report of a document of the program's JSON."""
    listed = document.get("unchecked", [])
    offsets: Set[int] = set()
    for value in [*document["findings"], *listed]:
        _offsets(value, offsets)
    indices = _indices(text, offsets)
    findings = tuple(
        Finding(
            section=value["list"],
            verdict=value["verdict"],
            message=value["message"],
            explanation=value["explanation"],
            why=value["why"],
            doubt=value["doubt"],
            caveat=value["caveat"],
            reading=tuple(value["reading"]),
            names=tuple(value["names"]),
            places=tuple(Place(**_of_place(place, indices)) for place in value["places"]),
            **_of_place(value, indices),
        )
        for value in document["findings"]
    )
    unchecked = tuple(
        UncheckedChain(
            kind=value["kind"],
            name=value["name"],
            reason=value["reason"],
            chain=value["chain"],
            partly=value["partly"],
            chain_at=_span(value["chain_at"], indices),
        )
        for value in listed
    )
    return Report(findings, unchecked, document["tally"])
