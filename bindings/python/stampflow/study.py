"""What came of many runs: columns, an answer in words, pictures."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING, Any

from ._html import Page, Shown
from .columns import ByName
from .plots import Plots

if TYPE_CHECKING:
    import numpy as np
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

    Numbers are NaN where a run has none; with error bars half of each is in ``..._error``. Words are arrays of objects:
    ``verdict`` (a light), the ways in which a design ``fails`` (empty where it is sound), the rows of the verdict that are
    ``red`` and ``amber``, why a run ended (``end``, ``reason``). ``seconds`` is what each took, of runs of this call.
    """

    def _hold(self, table: _Table) -> None:
        import numpy

        #: Which design of the study each row is, from 0.
        self.index: NDArray[np.uint64]
        self.index, numbers, words = table
        self._columns = dict(numbers)
        self._columns.update((header, numpy.array(column, dtype=object)) for header, column in words)
        #: Runs that were made.
        self.runs = len(self._columns["verdict"])

    def to_pandas(self) -> Any:
        """As a ``pandas.DataFrame``, a row for every run under its ``index``, where pandas is installed."""
        import pandas

        return pandas.DataFrame(self._columns, index=pandas.Index(self.index, name="index"))

