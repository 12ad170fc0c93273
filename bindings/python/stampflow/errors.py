"""Exceptions."""

from __future__ import annotations

import re
from keyword import iskeyword
from typing import Any, TypeVar

_Result = TypeVar("_Result")


class Error(Exception):
    """What this package refuses to do, and why."""


class CaseError(Error):
    """A case that cannot be solved as it is written. Its text shows the line and what to write instead."""

    def __init__(
        self,
        text: str,
        message: str,
        file: str | None = None,
        line: int | None = None,
        column: int | None = None,
        key: str = "",
        help: str | None = None,
    ) -> None:
        if line is None:
            # Of no text, but of what was asked for.
            text, message, help = _as_in_python(text), _as_in_python(message), help and _as_in_python(help)
        super().__init__(text)
        #: What is wrong, in one sentence.
        self.message = message
        #: The file as it was named; None of an error outside of any file's text.
        self.file = file
        #: Line of the place, from 1; None where there is none.
        self.line = line
        #: Column of the place, from 1, in characters.
        self.column = column
        #: The key that is wrong: ``tools.punch.travel``.
        self.key = key
        #: What to write instead.
        self.help = help


class StudyError(Error):
    """A study that cannot be run as it is asked for."""

    def __init__(self, message: str, help: str) -> None:
        message, help = _as_in_python(message), _as_in_python(help)
        super().__init__(f"{message}\n  help: {help}")
        #: What is wrong, in one sentence.
        self.message = message
        #: What to write instead.
        self.help = help


class DrawingError(Error):
    """A drawing that no case is made of."""

    def __init__(self, message: str, help: str, file: str, line: int | None) -> None:
        super().__init__(f"{file}{f', line {line}' if line else ''}: {message}\n  help: {help}")
        #: What is wrong, with the entities and the place in the drawing.
        self.message = message
        #: What to do about it.
        self.help = help
        #: The drawing as it was named.
        self.file = file
        #: Line of the file, from 1, of the first entity that is named; None where none is.
        self.line = line


class CompareError(Error):
    """A reference that a case is compared with and that cannot be used."""


class Interrupted(KeyboardInterrupt):
    """Ctrl-C while something was solved; what is done is kept in ``partial``."""

    def __init__(self, partial: Any) -> None:
        super().__init__("interrupted; what is done is kept in .partial of this exception")
        #: What had been computed: a solution up to its last step, a study up to its last run.
        self.partial = partial


def _as_in_python(text: str) -> str:
    """Options of the command line as the keywords that they are here: ``--while "no red"`` as ``while_="no red"``."""

    def keyword(option: re.Match[str]) -> str:
        name = option[1].replace("-", "_")
        file = f'"{option[3]}"' if option[3] else ""
        return f"{name}{'_' if iskeyword(name) else ''}{'=' if option[2] or file else ''}{file}"

    return re.sub(r'--([a-z](?:[a-z-]*[a-z])?)(?:( )(?=")| (\w+\.\w+))?', keyword, text)


def finished(result: _Result, raised: BaseException | None) -> _Result:
    """A result, or the exception that cut it short: of Ctrl-C with what is done in it."""
    if isinstance(raised, KeyboardInterrupt):
        raise Interrupted(result) from raised
    if raised is not None:
        raise raised
    return result
