"""What came of many runs: columns, an answer in words, pictures."""

from __future__ import annotations

import json
from collections.abc import Iterable, Mapping, Sequence
from typing import TYPE_CHECKING, Any

from . import _toml
from ._html import Page, Shown
from .columns import ByName
from .plots import Plots

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from ._native import _Picture, _Table, _Told


class Told(Shown):
    """What a study says. Notebooks show its answer and its picture."""

    _title = "Study"

    def __init__(self, told: _Told) -> None:
        found, sentences, pictures = told
        #: As the command line prints it with ``--json``.
        self.json: dict[str, Any] = json.loads(found) or {}
        #: The answer in one sentence.
        self.answer = sentences[0] if sentences else ""
        #: What is to be known besides, a sentence each.
        self.notes = sentences[1:]
        self._pictures: dict[str, _Picture] = dict(pictures)

    def __repr__(self) -> str:
        return f"<{type(self).__name__}: {self.answer}>"

    def _page(self) -> Page:
        picture = Plots(self._pictures.get, "it")._first(*self._pictures)
        return Page(title=self._title, answer=self.answer, picture=picture, notes=self.notes)


class Rows(ByName["NDArray[Any]"]):
    """Every run as a row, column by column: what was varied, every number of the solutions, and the verdict.

    Numbers are NaN where a run has none. Words are arrays of objects: ``verdict`` (a light), the rows of the verdict that are
    ``red`` and ``amber``, why a run ended (``end``, ``reason``). ``seconds`` is what each took.
    """

    def _hold(self, table: _Table) -> None:
        import numpy

        numbers, words = table
        self._columns = dict(numbers)
        self._columns.update((header, numpy.array(column, dtype=object)) for header, column in words)
        #: Runs that were made.
        self.runs = len(self._columns["verdict"])


def assigned(given: Mapping[str, str | None] | Sequence[str] | str | None) -> list[str]:
    """Texts as on the command line, ``KEY=WHAT``, of a mapping or of such texts."""
    if given is None:
        return []
    if isinstance(given, str):
        return [given]
    if isinstance(given, Mapping):
        return [key if what is None else f"{key}={what}" for key, what in given.items()]
    return list(given)


def listed(values: Iterable[str | float]) -> str:
    """Values as on the command line: ``4 mm, 6 mm``."""
    return ", ".join(value if isinstance(value, str) else _toml.value(value) for value in values)
