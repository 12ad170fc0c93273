"""One case with many settings."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import TYPE_CHECKING, Any, TypeAlias

from . import _native
from .case import Case, Progress
from .errors import finished
from .picture import Picture
from .plots import Plots
from .study import Rows, Told, listed

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from ._native import _Table, _Told

Values: TypeAlias = "str | Iterable[str | float]"
"""Values of a key: ``"4..10 mm/7"``, ``"4,6,8 mm"``, ``["4 mm", "6 mm"]`` or plain numbers."""


class SweepPlots(Plots):
    """The pictures of a sweep, each a method; one that has nothing to draw is a ValueError that says so."""

    def curves(self) -> Picture:
        """The numbers that decide over the one key that is varied, and the ways to fail."""
        return self._picture("curves")

    def window(self) -> Picture:
        """The process window over two keys, of three one for each value of the third."""
        return self._first("window", "windows") or self._picture("window")


class Sweep(Told, Rows):
    """What came of a sweep, column by column: what was varied, every number of the solutions, and the verdict.

    ``sweep["thinnest_mm"]`` are the numbers of all designs in order, the last key that was varied fastest; NaN where a design
    has no such number. Words are arrays of objects: ``verdict`` (a light), the rows of the verdict that are ``red`` and
    ``amber``, why a run ended (``end``, ``reason``). ``seconds`` is what each took. A sweep that was cut short, or that has
    more than 100 000 designs, has its columns alone and no answer.
    """

    _title = "Sweep"

    def __init__(self, shape: Sequence[int], told: _Told | None, table: _Table) -> None:
        super().__init__(told or ("{}", [], []))
        #: How many values each axis has, in the order in which they were given.
        self.shape = tuple(shape)
        self._hold(table)
        #: Designs that were run: all of them, unless the sweep was interrupted.
        self.designs = self.runs

    def __repr__(self) -> str:
        return f"<Sweep: {self.designs} designs, {' x '.join(map(str, self.shape))}>"

    @property
    def plot(self) -> SweepPlots:
        """Its pictures: ``plot.window()``."""
        return SweepPlots(self._pictures.get, "this sweep")

    def grid(self, name: str) -> NDArray[Any]:
        """A column with one index for every axis: ``grid("thinnest_mm")[i, j]``. What was not run is NaN, or None of words."""
        import numpy

        column = self[name]
        filled = numpy.full(int(numpy.prod(self.shape)), None if column.dtype == object else numpy.nan, column.dtype)
        filled[: len(column)] = column
        return filled.reshape(self.shape)


def sweep(
    case: Case,
    vary: Mapping[str, Values] | Sequence[str],
    *,
    together: Sequence[Mapping[str, Values]] = (),
    threads: int | None = None,
    progress: Progress | None = None,
) -> Sweep:
    """Runs a case with every combination of some values, on all cores, without the interpreter's lock.

    ``vary`` has the values of each key, the last key fastest: ``{"tools.die.shoulder": "4..10 mm/7", "friction": [0.04,
    0.08]}``; or texts as on the command line, ``["tools.die.shoulder=4..10 mm/7"]``. Each of ``together`` has keys that go
    together, one value each.

    ``threads`` is one for each core unless given. ``progress`` is called with the share that is done, from 0 to 1. Ctrl-C
    raises :class:`Interrupted`, whose ``partial`` has the designs that were done. A design that is no case, or does not come
    to its end, is a row that says why; a key that no case has is an error.
    """
    if isinstance(vary, Mapping):
        axes = [_axis({key: values}) for key, values in vary.items()]
    else:
        axes = [vary] if isinstance(vary, str) else list(vary)
    axes += [_axis(keys) for keys in together]
    shape, told, table, raised = _native.sweep(case._native, axes, threads, progress)
    return finished(Sweep(shape, told, table), raised)


def _axis(keys: Mapping[str, Values]) -> str:
    """Keys that go together, as on the command line."""
    return " & ".join(f"{key}={values if isinstance(values, str) else listed(values)}" for key, values in keys.items())
