"""A number with its error bar."""

from __future__ import annotations

from dataclasses import dataclass


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
    #: What the bar is made of, or why there is none; empty where it was not asked for.
    about: str

    def __float__(self) -> float:
        return self.value

    def __str__(self) -> str:
        bar = f" ± {self.error_bar:.2g}" if self.error_bar is not None else ""
        return f"{self.value:.6g}{bar} {self.unit}".rstrip()
