"""One case with many settings."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from os import fspath
from typing import TYPE_CHECKING, Any, TypeAlias

from . import _native, given
from .case import Case, Progress
from .errors import StudyError, finished
from .given import Path, listed
from .picture import Picture
from .plots import Plots
from .study import Rows, Told

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from ._native import _Table, _Told

Values: TypeAlias = "str | float | Iterable[str | float]"
"""Values of a key: ``"4..10 mm/7"``, ``"4,6,8 mm"``, ``["4 mm", "6 mm"]``, plain numbers, or a single one."""


class SweepPlots(Plots):
    """The pictures of a sweep, each a method; one that has nothing to draw is a ValueError that says so."""

    def curves(self) -> Picture:
        """The numbers that decide over the one key that is varied, and the ways to fail."""
        return self._picture("curves")

    def window(self) -> Picture:
        """The process window over two keys, of three one for each value of the third."""
        return self._first("window", "windows") or self._picture("window")

    def tornado(self) -> Picture:
        """What moves the numbers that decide most, of a sweep of one key at a time."""
        return self._picture("tornado")


class Sweep(Told, Rows):
    """What came of a sweep, column by column: what was varied, every number of the solutions, and the verdict.

    ``sweep["thinnest_mm"]`` are the numbers of all designs in order, the last key that was varied fastest; NaN where a design
    has no such number; ``sweep["thinnest_mm_error"]`` half their error bars where there are some. Words are arrays of objects:
    ``verdict`` (a light), the ways in which a design ``fails``, the rows of the verdict that are ``red`` and ``amber``, why a
    run ended (``end``, ``reason``). ``seconds`` is what each took. A sweep that was cut short, a shard of one, or one of more
    than 100 000 designs has its columns alone and no answer.
    """

    _title = "Sweep"

    def __init__(self, shape: Sequence[int] | None, told: _Told | None, table: _Table) -> None:
        super().__init__(told or ("{}", [], []))
        self._hold(table)
        #: How many values each axis has, in the order in which they were given; None of one key at a time.
        self.shape = None if shape is None else tuple(shape)
        #: Designs that were run: all of them, unless the sweep was interrupted.
        self.designs = self.runs

    def __repr__(self) -> str:
        how = "one key at a time" if self.shape is None else " x ".join(map(str, self.shape))
        return f"<Sweep of {how}: {self.answer or f'{self.designs} designs'}>"

    @property
    def plot(self) -> SweepPlots:
        """Its pictures: ``plot.window()``."""
        return SweepPlots(self._pictures.get, "this sweep")

    def grid(self, name: str) -> NDArray[Any]:
        """A column with one index for every axis: ``grid("thinnest_mm")[i, j]``. What was not run is NaN, or None of words."""
        import numpy

        if self.shape is None:
            raise StudyError("a sweep of one key at a time has no grid", "take its columns by their names")
        column = self[name]
        filled = numpy.full(int(numpy.prod(self.shape)), None if column.dtype == object else numpy.nan, column.dtype)
        filled[self.index] = column
        return filled.reshape(self.shape)


def sweep(
    case: Case | Path,
    vary: Mapping[str, Values] | Sequence[str] | str | None = None,
    *,
    together: Sequence[Mapping[str, Values]] = (),
    settings: Mapping[str, object] | None = None,
    one_at_a_time: bool = False,
    error_bars: bool | None = None,
    shard: tuple[int, int] | None = None,
    out: Path | None = None,
    resume: bool = False,
    restart: bool = False,
    threads: int | None = None,
    progress: Progress | None = None,
) -> Sweep:
    """Runs a case with every combination of some values, on all cores, without the interpreter's lock: ``stampflow sweep``.

    ``vary`` has the values of each key, the last key fastest: ``{"tools.die.shoulder": "4..10 mm/7", "friction": [0.04,
    0.08]}``; or texts as on the command line, ``["tools.die.shoulder=4..10 mm/7"]``. Each of ``together`` has keys that go
    together, one value each. ``sweep("study.toml")`` runs a study file, which has all of this in it. ``settings`` are those of
    all designs, ``{"blank.elements": 60}``. With ``one_at_a_time`` each key has each of its values by itself, all else as the
    case has it, which is the first design. ``error_bars`` stand beside all numbers, from one coarser run of each design, a
    third of its time: over one key unless False is given, else where True is.

    With ``out`` the rows are kept in that folder as they come, as on the command line, in ``study.csv`` once it is whole: the
    columns have the digits of the table then. Rows that an earlier run has left there are an error unless ``resume`` goes on
    with them or ``restart`` removes them. ``shard=(7, 64)`` runs the seventh of 64 parts, with ``out`` into a table of its own,
    which :func:`merge` puts together with the others.

    ``threads`` is one for each core unless given. ``progress`` is called with the share that is done, from 0 to 1. Ctrl-C
    raises :class:`Interrupted`, whose ``partial`` has the designs that were done. A design that is no case, or does not come
    to its end, is a row that says why; a key that no case has is an error.
    """
    if isinstance(vary, Mapping):
        axes = [_axis({key: values}) for key, values in vary.items()]
    else:
        axes = given.assigned(vary)
    axes += [_axis(keys) for keys in together]
    if not axes and isinstance(case, Case):
        raise StudyError("there is nothing to vary", 'give vary={"friction": [0.04, 0.08]}, or a study file')
    of, part = given.of(case, settings), given.part(shard, out, resume, restart)
    shape, told, table, raised = _native.sweep(of, axes, one_at_a_time, error_bars, part, threads, progress)
    return finished(Sweep(shape, told, table), raised)


def merge(shards: Iterable[Path], out: Path) -> int:
    """Puts the tables of all shards of a study, in any order, together into one: ``stampflow merge``. How many designs it has.

    What is missing, there twice or of another study is a :class:`StudyError`, and nothing is written then. The same study with
    ``resume`` and the folder of ``out`` answers and draws: ``sweep("study.toml", out="out", resume=True)`` of ``out/study.csv``.
    """
    return _native.merge([fspath(path) for path in shards], fspath(out))


def _axis(keys: Mapping[str, Values]) -> str:
    """Keys that go together, as on the command line."""
    return " & ".join(f"{key}={listed(values)}" for key, values in keys.items())
