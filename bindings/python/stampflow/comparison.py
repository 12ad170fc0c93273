"""A published reference beside what was computed."""

from __future__ import annotations

from dataclasses import dataclass

from .columns import Columns


@dataclass(frozen=True)
class Comparison:
    """A curve or a value of a reference, and what the solution has there."""

    #: What is compared: ``punch_force``.
    quantity: str
    #: Where the reference comes from.
    source: str
    #: How they differ, in one sentence.
    sentence: str
    #: Whether the difference is beyond what is accepted.
    failure: bool
    #: Point by point.
    table: Columns
