"""What is given to studies: cases, files, settings, measured tables."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from os import PathLike, fspath
from typing import TYPE_CHECKING, Any, Protocol, TypeAlias, TypeGuard

from . import _toml
from .case import Case
from .errors import StudyError

if TYPE_CHECKING:
    from ._native import _Given, _Of, _Part

Path: TypeAlias = "str | PathLike[str]"


class Frame(Protocol):
    """A ``pandas.DataFrame``, or what is as one: named columns."""

    @property
    def columns(self) -> Any: ...
    def items(self) -> Iterable[tuple[Any, Any]]: ...


Table: TypeAlias = "Path | Mapping[str, Any] | Frame"
"""What was measured: a CSV file, a ``pandas.DataFrame``, or arrays by their names, which end with their units:
``{"travel_mm": travel, "punch_force_kN": force}``. NaN is a gap."""


def of(given: Case | Path, settings: Mapping[str, object] | None) -> _Of:
    """A case, or a case or study file, with settings besides."""
    if isinstance(given, Case):
        return (given.with_(settings) if settings else given)._native
    return fspath(given), _toml.settings(settings or {})


def case(given: Case | Path) -> Case:
    """A case that was read, or is."""
    return given if isinstance(given, Case) else Case.load(given)


def is_case_file(given: object) -> TypeGuard[Path]:
    """Whether it is the file of a case or of a study: as on the command line what ends with .csv was measured."""
    return isinstance(given, (str, PathLike)) and not fspath(given).lower().endswith(".csv")


def stem(given: Case | Path) -> str:
    """What pictures call it."""
    from pathlib import PurePath

    return given.name if isinstance(given, Case) else PurePath(given).stem


def part(shard: tuple[int, int] | None, out: Path | None, resume: bool, restart: bool) -> _Part:
    """Which rows are run, and what becomes of them."""
    if resume and restart:
        raise StudyError("both resume and restart are asked for", "give one of them")
    if (resume or restart) and out is None:
        raise StudyError("there is no table of an earlier run in memory", "give its folder with out")
    if shard is not None and not (len(shard) == 2 and 1 <= shard[0] <= shard[1]):
        raise StudyError(f"{shard} is no shard", "give its number, from 1, and how many there are: (7, 64)")
    return {"shard": shard, "out": None if out is None else fspath(out), "resume": resume, "restart": restart}


def is_table(given: object) -> bool:
    """Whether it is one table, and not several."""
    return isinstance(given, (str, PathLike, Mapping)) or hasattr(given, "columns")


def tables(given: Table | Sequence[Table], what: str) -> list[_Given]:
    """Measured tables; those that are no files are called by ``what`` they are, from 1."""
    several = [given] if is_table(given) else list(given)  # type: ignore[arg-type]
    return [_table(one, f"{what} {i}") for i, one in enumerate(several, 1)]  # type: ignore[arg-type]


def _table(given: Table, called: str) -> _Given:
    import numpy

    if isinstance(given, (str, PathLike)):
        return fspath(given)
    if not is_table(given):
        kind = type(given).__name__
        raise StudyError(f"{called} is a {kind}", 'give a CSV file, a frame, or arrays by their names: {"travel_mm": ...}')
    columns = []
    for name, values in given.items():
        try:
            array = numpy.ascontiguousarray(values, dtype=float)
        except (TypeError, ValueError) as error:
            raise StudyError(f"{called}: the column {name} is no numbers: {error}", "leave it out, or make it numbers") from None
        if array.ndim != 1:
            raise StudyError(f"{called}: the column {name} has {array.ndim} dimensions", "give one-dimensional arrays")
        columns.append((str(name), array))
    return called, columns


def assigned(given: Mapping[str, str | None] | Sequence[str] | str | None) -> list[str]:
    """Texts as on the command line, ``KEY=WHAT``, of a mapping or of such texts."""
    if given is None:
        return []
    if isinstance(given, str):
        return [given]
    if isinstance(given, Mapping):
        return [key if what is None else f"{key}={what}" for key, what in given.items()]
    return list(given)


def listed(values: str | float | Iterable[str | float]) -> str:
    """Values as on the command line: ``4 mm, 6 mm``."""
    if isinstance(values, str):
        return values
    if not isinstance(values, Iterable):
        return _toml.value(values)
    return ", ".join(value if isinstance(value, str) else _toml.value(value) for value in values)
