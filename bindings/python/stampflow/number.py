"""A number with its error bar."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from .columns import ByName


@dataclass(frozen=True)
class Number:
    """A number of a solution. ``float(number)`` is its value."""

    #: Name for readers: ``Punch force``.
    label: str
    #: In ``unit``.
    value: float
    #: As it is printed: ``N``; empty for plain numbers.
    unit: str
    #: The truth, on a mesh and with steps as fine as can be, lies within this of it, in ``unit``; None where it is not known.
    error_bar: float | None
    #: As the program tells it: ``47.2 ± 0.4 kN``, with no digit beyond the bar.
    told: str
    #: What the bar is made of, or why there is none; empty where it was not asked for.
    about: str

    def __float__(self) -> float:
        return self.value

    def __str__(self) -> str:
        return self.told


class Numbers(ByName[Number]):
    """Numbers by their names, which end with the unit: ``numbers["punch_force_N"].value``."""

    _what = "number"

    def __init__(self, numbers: dict[str, Number]) -> None:
        self._columns = numbers

    def __repr__(self) -> str:
        return "\n".join(f"{name}: {number.label} {number.told}" for name, number in self.items())

    def to_pandas(self) -> Any:
        """As a ``pandas.DataFrame``, a row for every number with its label, value, unit and error bar, where pandas is
        installed."""
        import pandas

        rows = [(number.label, number.value, number.unit, number.error_bar) for number in self.values()]
        return pandas.DataFrame(rows, index=list(self), columns=["label", "value", "unit", "error_bar"])
