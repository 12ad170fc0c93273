"""What a user should know of a case or of what came out of it."""

from __future__ import annotations

import json
from dataclasses import dataclass


@dataclass(frozen=True, repr=False)
class Finding:
    """A row of the verdict, a warning, or an assumption."""

    #: Name for programs: ``thinning``.
    key: str
    #: Name for readers: ``Thinning``.
    label: str
    #: ``green``, ``amber``, ``red``, or ``grey`` where it was not judged.
    light: str
    #: What was found, with its unit, and where.
    found: str
    #: The limit that it is held against, with its unit.
    limit: str
    #: Where the limit comes from.
    source: str
    #: What to change; empty where all is well.
    advice: str
    #: The number, in ``unit``; None where words say it.
    value: float | None
    #: The truth lies within this of the number, in ``unit``; None where it is not known.
    error_bar: float | None
    #: Unit of the number: ``percent``, ``mm``, empty for plain numbers.
    unit: str

    def __repr__(self) -> str:
        return f"<Finding {self.key}: {self.light}, {self.found}>"


def read(text: str) -> list[Finding]:
    """From the JSON of the library."""
    fields = Finding.__dataclass_fields__
    return [Finding(**{name: entry.get(name) for name in fields}) for entry in json.loads(text)]
