"""The program that does the work, and what may go wrong with it."""

from __future__ import annotations

import os
import subprocess
import sys
import sysconfig
from importlib import metadata
from pathlib import Path
from typing import Iterator, Optional, Sequence

#: The variable that names another program than the one that comes with this package.
VARIABLE = "PROOFREAD_PROGRAM"

_NAME = "proofread.exe" if sys.platform == "win32" else "proofread"


class ProofreadError(Exception):
    """Something went wrong, with the reason and a remedy."""


class UnreadableText(ProofreadError, ValueError):
    """The text cannot be read in its format."""


class ProgramError(ProofreadError, RuntimeError):
    """The program is missing, cannot be started, is of another version, or did not end in time."""


def _candidates() -> Iterator[Path]:
    try:
        files = metadata.files("geneva-proofread") or []
    except metadata.PackageNotFoundError:
        files = []
    for file in files:
        if file.name == _NAME:
            yield Path(str(file.locate()))
    yield Path(sysconfig.get_path("scripts")) / _NAME


def program() -> str:
    """The path of the program: the one that `PROOFREAD_PROGRAM` names, or else the one that was installed with this package.

    Raises `ProgramError` if there is none.
    """
    named = os.environ.get(VARIABLE)
    if named:
        if not Path(named).is_file():
            raise ProgramError(f"{VARIABLE} names {named!r}, which is no file; give the path of the program `proofread`")
        return named
    for path in _candidates():
        if path.is_file():
            return str(path)
    raise ProgramError(
        f"the program `proofread` is not installed beside this package; install geneva-proofread again, or name the program in {VARIABLE}"
    )


def answer(arguments: Sequence[str], given: bytes, timeout: Optional[float]) -> bytes:
    """What the program writes if it is given this on standard input."""
    command = [program(), *arguments]
    try:
        done = subprocess.run(command, input=given, capture_output=True, timeout=timeout)
    except subprocess.TimeoutExpired:
        raise ProgramError(
            f"the text was not read within {timeout} s; give a shorter text or a longer timeout"
        ) from None
    except OSError as error:
        raise ProgramError(f"cannot start {command[0]}: {error}; install geneva-proofread again") from error
    said = done.stderr.decode("utf-8", "replace").strip()
    if said.startswith("error: "):
        said = said[len("error: ") :]
    if done.returncode == 2:
        raise UnreadableText(said)
    if done.returncode not in (0, 1):
        raise ProgramError(f"{command[0]} ended with code {done.returncode}: {said or 'it said nothing'}")
    return done.stdout
