"""What the classes of :mod:`stampflow.parts` have in common."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import fields
from typing import ClassVar

from . import _toml
from .case import Case


class Part:
    """A table of a case file. Fields that are None are not written: the case has its default then."""

    #: The key that says which of several laws it is.
    _law: ClassVar[str | None] = None

    def toml(self) -> str:
        """As in a case file."""
        table = _plain(self)
        assert isinstance(table, dict)
        return _toml.document(table)


class Whole(Part):
    """All of a case."""

    def case(self, name: str = "model.toml") -> Case:
        """The case, read by the reader of case files: with the same checks and messages, which show its text as ``name``.

        Files that it names are looked up from there.
        """
        return Case.from_text(self.toml(), name)


def _plain(value: object) -> object:
    """Parts as tables, in lists and tables too."""
    if isinstance(value, Part):
        table = {
            field.name.rstrip("_"): _plain(given)
            for field in fields(value)  # type: ignore[arg-type]
            if (given := getattr(value, field.name)) is not None
        }
        return {value._law: table} if value._law else table
    if isinstance(value, Mapping):
        return {key: _plain(item) for key, item in value.items()}
    if isinstance(value, (list, tuple)):
        return [_plain(item) for item in value]
    return value
