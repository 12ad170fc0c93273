"""A solved case."""

from __future__ import annotations

import json
from collections.abc import Callable, Sequence
from functools import cached_property
from os import PathLike, fspath
from typing import TYPE_CHECKING, Any

from . import _html, finding
from ._html import Page, Shown
from .comparison import Comparison
from .errors import finished
from .finding import Finding
from .number import Number, Numbers
from .solved_stage import SolvedStage
from .columns import Columns

if TYPE_CHECKING:
    from . import _native
    from .case import Case
    from .frame import Frame
    from .stage_plots import StagePlots


class Solution(Shown):
    """What came out of a case, stage by stage. Notebooks show its verdict and its section.

    ``load_travel``, ``frames``, ``profile`` and ``plot`` are those of the only stage; a case with several has them at each:
    ``solution.stages[0].load_travel``.
    """

    def __init__(self, case: Case, native: _native.Solution) -> None:
        #: What was solved.
        self.case = case
        self._native = native
        #: The stages that were run, in order: up to the first that did not come to its end.
        self.stages = [SolvedStage(native, i, parts) for i, parts in enumerate(native.stages())]

    @property
    def complete(self) -> bool:
        """Whether every stage was run and came to its end."""
        return self._native.complete

    @property
    def interrupted(self) -> bool:
        """Whether it was ended by Ctrl-C."""
        return any(stage.stop == "interrupted" for stage in self.stages)

    @property
    def wall_time(self) -> float:
        """Time that the solution took [s]."""
        return self._native.wall_time

    @cached_property
    def summary(self) -> dict[str, Any]:
        """What ``summary.json`` says, names with units: ``summary["peak_punch_force_N"]``. Of several stages a list of them is
        in ``summary["stages"]``."""
        summary: dict[str, Any] = json.loads(self._native.summary())
        return summary

    @property
    def verdict(self) -> str:
        """The verdict in one sentence."""
        return self._native.verdict()[1]

    @property
    def headline(self) -> str:
        """How many rows of the verdict have which light."""
        return self._native.verdict()[2]

    @property
    def light(self) -> str:
        """The worst light of the verdict: ``green``, ``amber``, ``red``, or ``grey`` where nothing was judged."""
        return self._native.verdict()[0]

    @cached_property
    def findings(self) -> list[Finding]:
        """The rows of the verdict."""
        return finding.read(self._native.findings())

    @cached_property
    def numbers(self) -> Numbers:
        """The numbers that a part is known by, names with units: ``numbers["punch_force_N"].value``. With error bars after
        :meth:`verify`; what a row of the verdict judges ends with ``_judged``."""
        return Numbers({told[0]: Number(*told[1:]) for told in self._native.numbers()})

    def verify(self, *, quick: bool = False, progress: Callable[[float], object] | None = None) -> Solution:
        """The same solution with an error bar at every number, in its findings and in its pictures.

        Mesh, steps, points through the thickness and contact are refined in runs of their own, which takes some twenty times
        as long as the solution; ``quick`` estimates the bars from one coarser run.
        """
        native, raised = self._native.verify(quick, progress)
        finished(self, raised)  # of some finer runs nothing can be said: what is kept is the solution
        return Solution(self.case, native)

    @property
    def about_error_bars(self) -> list[str]:
        """What the error bars are from, and whatever is no small error, a sentence each; empty without them."""
        return self._native.told_of_bars()

    @cached_property
    def comparisons(self) -> list[Comparison]:
        """The case's published references beside what was computed; a CompareError where one cannot be read."""
        return [
            Comparison(quantity, source, sentence, failure, Columns(columns))
            for quantity, source, sentence, failure, columns in self._native.comparisons()
        ]

    @property
    def load_travel(self) -> Columns:
        """Every accepted step of the only stage: see :attr:`SolvedStage.load_travel`."""
        return self._only.load_travel

    @property
    def profile(self) -> Columns:
        """Every element of every kept frame of the only stage: see :attr:`SolvedStage.profile`."""
        return self._only.profile

    @property
    def frames(self) -> Sequence[Frame]:
        """The kept frames of the only stage; ``frames[-1]`` is its end."""
        return self._only.frames

    @property
    def plot(self) -> StagePlots:
        """The pictures of the only stage: ``plot.load_travel()``."""
        return self._only.plot

    def to_pandas(self) -> Any:
        """``load_travel`` as a ``pandas.DataFrame``; of several stages one below the other, with a column ``stage``."""
        import pandas

        tables = {stage.name: stage.load_travel.to_pandas() for stage in self.stages}
        if len(tables) == 1:
            return self.load_travel.to_pandas()
        return pandas.concat(tables, names=["stage"]).reset_index(level="stage").reset_index(drop=True)

    def write(self, folder: str | PathLike[str]) -> list[str]:
        """Writes every table and picture into a folder, as ``stampflow run --out``; the paths of the files."""
        return self._native.write(fspath(folder))

    @property
    def _only(self) -> SolvedStage:
        if len(self.case.stages) == 1:
            return self.stages[0]
        each = ", ".join(f"stages[{i}] ({stage.name})" for i, stage in enumerate(self.stages))
        raise ValueError(f"this case has several stages: say of which it is, {each}")

    def __str__(self) -> str:
        return self._native.told()

    def __repr__(self) -> str:
        return f"<Solution of {self.case.name}: {self.light}, {self.verdict}>"

    def _page(self) -> Page:
        return Page(
            title=self.case.title,
            answer=self.verdict,
            light=self.light,
            picture=self.stages[-1].plot._first("part") if self.stages else None,
            summary=self.headline,
            header=_html.FINDINGS,
            rows=_html.findings(self.findings),
        )
