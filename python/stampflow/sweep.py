"""One case with many settings."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import TYPE_CHECKING, Any, TypeAlias

from . import _native, _toml
from .case import Case
from .columns import ByName
from .errors import Interrupted

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

Values: TypeAlias = "str | Iterable[str | float]"
"""Values of a key: ``"4..10 mm/7"``, ``"4,6,8 mm"``, ``["4 mm", "6 mm"]`` or plain numbers."""


class Sweep(ByName["NDArray[Any]"]):
    """What came of a sweep, column by column: what was varied, every number of the solutions, and the verdict.

    ``sweep["thinnest_mm"]`` are the numbers of all designs in order, the last key that was varied fastest; NaN where a design
    has no such number. Words are arrays of objects: ``verdict`` (a light), the rows of the verdict that are ``red`` and
    ``amber``, why a run ended (``end``, ``reason``). ``seconds`` is what each took.
    """

    def __init__(
        self,
        shape: Sequence[int],
        numbers: Iterable[tuple[str, NDArray[np.float64]]],
        words: Iterable[tuple[str, list[str]]],
    ) -> None:
        import numpy

        #: How many values each axis has, in the order in which they were given.
        self.shape = tuple(shape)
        self._columns = dict(numbers)
        self._columns.update((header, numpy.array(column, dtype=object)) for header, column in words)
        #: Designs that were run: all of them, unless the sweep was interrupted.
        self.designs = len(self._columns["verdict"])

    def __repr__(self) -> str:
        return f"<Sweep: {self.designs} designs, {' x '.join(map(str, self.shape))}>"

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
    progress: Callable[[float], object] | None = None,
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
    shape, (numbers, words), raised = _native.sweep(case._native, axes, threads, progress)
    found = Sweep(shape, numbers, words)
    if isinstance(raised, KeyboardInterrupt):
        raise Interrupted(found) from raised
    if raised is not None:
        raise raised
    return found


def _axis(keys: Mapping[str, Values]) -> str:
    """Keys that go together, as on the command line."""
    return " & ".join(f"{key}={values if isinstance(values, str) else _list(values)}" for key, values in keys.items())


def _list(values: Iterable[str | float]) -> str:
    return ",".join(value if isinstance(value, str) else _toml.value(value) for value in values)
