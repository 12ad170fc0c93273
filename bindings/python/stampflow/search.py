"""The last value of a key up to which a condition holds; the value at which a number is as wanted; the best of several keys."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, TypeAlias, overload

from . import _native, given
from .case import Case, Progress
from .errors import StudyError, finished
from .given import Path, assigned
from .picture import Picture
from .plots import Plots
from .solution import Solution
from .study import Rows, Told

if TYPE_CHECKING:
    from ._native import _Searched

Spans: TypeAlias = "Mapping[str, str | None] | Sequence[str] | str"
"""Keys and what is looked through: ``{"blank.diameter": "90..140 mm"}``, ``"50..2000 N/mm log"`` in even ratios, None for half
to twice what the case has; or texts as on the command line, of keys that move together joined by ``&``."""


class SearchPlots(Plots):
    """The picture of a search."""

    def search(self) -> Picture:
        """The numbers of all runs over each key, their lights, and what was found."""
        return self._picture("search")


class _Found(Told, Rows):
    """What both kinds of searches have."""

    _title = "Search"

    def __init__(self, case: Case, searched: _Searched) -> None:
        told, table, solved, _ = searched
        Told.__init__(self, told)
        self._hold(table)
        #: The answer's run, with error bars; None where nothing was found.
        self.solution = Solution(Case(solved[0]), solved[1]) if solved else None

    @property
    def plot(self) -> SearchPlots:
        """Its picture: ``plot.search()``."""
        return SearchPlots(self._pictures.get, "this search")


class Search(_Found):
    """Where a condition ends, or where a number is as wanted. Its columns have a row for every run, in their order:
    ``search["blank.diameter_mm"]``, ``search["verdict"]``."""

    def __init__(self, case: Case, searched: _Searched) -> None:
        super().__init__(case, searched)
        found = self.json
        #: The key that was varied, and its unit.
        self.key: str = found["key"]
        self.unit: str = found["unit"]
        #: ``between`` two runs; ``everywhere`` or ``nowhere`` in the span; ``open`` or ``failed`` where runs came to nothing;
        #: ``interrupted``.
        self.found: str = found["found"]
        #: The last value that keeps the condition, or the nearest to the target, in ``unit``; None where there is none.
        self.value: float | None = found["value"]
        #: The first value on the other side, in ``unit``.
        self.other: float | None = found["other"]["value"] if found["other"] else None
        #: How near the limit is known, in ``unit``.
        self.tolerance: float | None = found["tolerance"]
        #: The wanted value of a target, in the unit of its column.
        self.wanted: float | None = found["wanted"]
        #: Draw ratios at ``value`` and ``other``, where a blank is drawn in over a punch [–].
        self.draw_ratios: tuple[float, float] | None = tuple(found["draw_ratios"]) if found["draw_ratios"] else None
        #: First and last value of each stretch on which the condition holds, in ``unit``.
        self.stretches: list[tuple[float, float]] = [(low, high) for low, high in found["stretches"]]
        #: Where the condition comes and goes about the limit, in ``unit``; None where it does not.
        self.mixed: tuple[float, float] | None = tuple(found["mixed"]) if found["mixed"] else None
        #: Why runs came to nothing, and how many.
        self.failed: dict[str, int] = {entry["why"]: entry["runs"] for entry in found["failed"]}


class Best(_Found):
    """The least or the most of a number over several keys. Its columns have a row for every run, in their order."""

    def __init__(self, case: Case, searched: _Searched) -> None:
        super().__init__(case, searched)
        #: The number that is best.
        self.number: str = self.json["number"]
        #: Where it is: keys, ending with their units, and their values; None where no run keeps the condition.
        self.at: dict[str, float] | None = self.json["values"]
        #: Parts of the condition, and ends of spans, that the best run comes to within a hundredth.
        self.binding: list[str] = self.json["binding"]


@overload
def search(
    case: Case | Path,
    vary: Spans | None = None,
    *,
    for_: str | None = None,
    largest: bool = False,
    smallest: bool = False,
    while_: str | None = None,
    target: str | None = None,
    tolerance: str | None = None,
    error_bars: bool = True,
    threads: int | None = None,
    progress: Progress | None = None,
) -> Search: ...
@overload
def search(
    case: Case | Path,
    vary: Spans,
    *,
    minimise: str,
    while_: str | None = None,
    error_bars: bool = True,
    threads: int | None = None,
    progress: Progress | None = None,
) -> Best: ...
@overload
def search(
    case: Case | Path,
    vary: Spans,
    *,
    maximise: str,
    while_: str | None = None,
    error_bars: bool = True,
    threads: int | None = None,
    progress: Progress | None = None,
) -> Best: ...
def search(
    case: Case | Path,
    vary: Spans | None = None,
    *,
    for_: str | None = None,
    largest: bool = False,
    smallest: bool = False,
    while_: str | None = None,
    target: str | None = None,
    minimise: str | None = None,
    maximise: str | None = None,
    tolerance: str | None = None,
    error_bars: bool = True,
    threads: int | None = None,
    progress: Progress | None = None,
) -> Search | Best:
    """Varies a key until a condition ends or a number is as wanted, or several keys for the best of a number, on all cores,
    without the interpreter's lock: ``stampflow search``.

    ``search(cup, {"blank.diameter": "90..140 mm"}, largest=True, while_="no red")``, of a case or a case file, finds
    the largest blank without a red light; ``smallest`` the smallest. Conditions, joined by ``and``: ``no red``, ``no red or
    amber``, ``no tear``, ``ROW not red``, ``NUMBER < VALUE UNIT``. ``target="draw_in=20 mm"`` finds where a number has a value.
    ``for_`` takes key, span and condition from the case: ``limiting-draw-ratio``, ``greatest-height``, ``least-holder-force``, ``smallest-radius``,
    ``over-bend`` and ``bead-force``. ``minimise`` and ``maximise`` name a number that is to be best over 1 to 6 keys.
    ``tolerance`` is how near a limit is to be found, in the unit of the key; 0.5 % of the span unless given.

    The answer's run is solved with error bars from a coarser one, but for ``error_bars=False``. ``threads`` is one for each
    core unless given. ``progress`` is called with the share that is done, from 0 to 1. Ctrl-C raises :class:`Interrupted`,
    whose ``partial`` has the runs that were made; where nothing was made yet, KeyboardInterrupt.
    """
    case = given.case(case)
    extreme = minimise or maximise
    if extreme is not None:
        others = [for_, target, tolerance, minimise and maximise, largest or None, smallest or None]
        if any(other is not None for other in others):
            raise StudyError("a best goes with keys and while_ only", "give minimise or maximise, without a limit besides")
        wanted = (assigned(vary), extreme, maximise is not None, while_)
        best = _native.optimise(case._native, wanted, error_bars, threads, progress)
        return finished(Best(case, best), best[3])
    if largest and smallest:
        raise StudyError("both the largest and the smallest are asked for", "give one of them")
    side = largest if largest or smallest else None
    limit = (assigned(vary), for_, side, while_, target, tolerance)
    found = _native.search(case._native, limit, error_bars, threads, progress)
    return finished(Search(case, found), found[3])
