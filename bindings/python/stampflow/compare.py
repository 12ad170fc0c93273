"""Several cases, variants and measured curves side by side."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from . import _native, _toml, given
from ._html import Page
from .case import Case, Progress
from .columns import ByName
from .errors import finished
from .given import Path, Table
from .picture import Picture
from .plots import Plots
from .solution import Solution
from .study import Told

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from ._native import _NumberOfRuns, _Told


@dataclass(frozen=True)
class ComparedNumber:
    """A number of all runs, in their order; NaN where a run has none."""

    #: Name for readers: ``Punch force``.
    label: str
    #: As it is printed: ``N``.
    unit: str
    #: In ``unit``, as all that follows.
    values: NDArray[np.float64]
    #: The truth lies within this of each value.
    error_bars: NDArray[np.float64]
    #: Against the first run.
    differences: NDArray[np.float64]
    #: Whether the error bars leave open that it is the same as of the first run; None where that is not known.
    within_error: list[bool | None]


@dataclass(frozen=True)
class Misfit:
    """How far a measured curve is from every run."""

    #: Its file, of arrays ``curve 1``, and the column where the file has several.
    curve: str
    #: Of the curve.
    points: int
    #: Root of the mean square of the distances, in ``unit``; None of a run that comes to no point.
    rms: list[float | None]
    unit: str


class ComparePlots(Plots):
    """The pictures of a comparison, each a method; one that has nothing to draw is a ValueError that says so."""

    def load(self) -> Picture:
        """Punch force [N, or N/mm of depth] over the travel [mm] of every run, and what was measured."""
        return self._picture("compare_load")

    def thickness(self) -> Picture:
        """Thickness [mm] over the blank of every run, and what was measured."""
        return self._picture("compare_thickness")

    def strains(self) -> Picture:
        """Strains [–] of every run and the forming limit, where a case gives one."""
        return self._picture("compare_strains")

    def sections(self) -> Picture:
        """The sections at the end."""
        return self._picture("compare_sections")


class Compared(Told, ByName[ComparedNumber]):
    """Runs side by side: ``compared["thinnest_mm"].differences``."""

    _title = "Compared"

    def __init__(
        self, told: _Told, numbers: Sequence[_NumberOfRuns], cases: Sequence[Case], solved: Sequence[_native.Solution]
    ) -> None:
        super().__init__(told)
        self._columns = {
            header: ComparedNumber(label, unit, values, bars, differences, within)
            for header, label, unit, (values, bars, differences), within in numbers
        }
        #: What each run, and behind them each measured curve, is called: ``A: friction 0.08``.
        self.legend = [self.answer, *self.notes] if self.answer else []
        self.answer, self.notes = "; ".join(self.legend), []
        #: The runs with their error bars, in the order of the cases, variants behind the first.
        self.solutions = [Solution(case, native) for case, native in zip(cases, solved)]
        #: What was measured.
        self.measured = [_misfit(curve) for curve in self.json["measured"]]

    def to_pandas(self) -> Any:
        """As a ``pandas.DataFrame``, a row for every run and a column for every number."""
        import pandas

        names = [run["name"] for run in self.json["runs"]]
        return pandas.DataFrame({name: number.values for name, number in self.items()}, index=names)

    @property
    def plot(self) -> ComparePlots:
        """Its pictures: ``plot.load()``."""
        return ComparePlots(self._pictures.get, "this comparison")

    def _page(self) -> Page:
        page = super()._page()
        told = [solution.numbers for solution in self.solutions]
        rows = [
            (number.label, *(str(numbers[name]) if name in numbers else "–" for numbers in told))
            for name, number in self.items()
        ]
        marks = [run["run"] for run in self.json["runs"]]
        lights = ("verdict", *(run["verdict"] for run in self.json["runs"]))
        return Page(
            title=page.title,
            answer=page.answer,
            picture=page.picture,
            summary="All numbers",
            header=("", *marks),
            rows=[lights, *rows],
        )


def compare(
    case: Case | Path,
    *others: Case | Table,
    also: Sequence[Mapping[str, object]] = (),
    threads: int | None = None,
    progress: Progress | None = None,
) -> Compared:
    """Solves cases with error bars and holds them against the first, and against measured curves, on all cores, without the
    interpreter's lock: ``stampflow compare``.

    ``compare(cup, "measured.csv", also=[{"friction": 0.12}])``: ``others`` are further cases, or what was measured: CSV files,
    frames of pandas or arrays by their names, with ``travel_mm`` and ``punch_force_kN``, or ``s0_mm`` and ``thickness_mm``.
    Each of ``also`` is one more run, the first case with settings of its own. Files that end with .csv are curves, others
    cases. ``threads`` is one for each core unless given. ``progress`` is called with the share that is done, from 0 to 1.
    Ctrl-C raises :class:`Interrupted`, whose ``partial`` has the runs that have ended.
    """
    case = given.case(case)
    own = [_toml.settings(settings) for settings in also]
    cases = [case, *(Case(case._native.with_settings(settings)) for settings in own)]
    curves = []
    for other in others:
        if isinstance(other, Case) or given.is_case_file(other):
            cases.append(given.case(other))
        else:
            curves.append(other)
    asked = [(one._native, settings) for one, settings in zip(cases, [[], *own, *[[] for _ in others]])]
    told, numbers, solved, raised = _native.compare(asked, given.tables(curves, "curve"), threads, progress)
    return finished(Compared(told, numbers, cases, solved), raised)


def _misfit(found: dict[str, Any]) -> Misfit:
    runs: list[dict[str, Any] | None] = found["of_runs"]
    unit = next((run["unit"] for run in runs if run), "")
    return Misfit(found["curve"], found["points"], [run["rms"] if run else None for run in runs], unit)
