"""Cases: from files, text, tables, templates and drawings."""

from __future__ import annotations

import json
from collections.abc import Callable, Mapping
from os import PathLike, fspath
from typing import Any

from . import _native
from .errors import finished
from .picture import Picture
from .solution import Finding, Solution

Progress = Callable[[float], object]


class Case:
    """A case as it was read. It never changes; :meth:`with_` gives another one."""

    def __init__(self, native: _native.Case, notes: list[str] | None = None, drawing: Picture | None = None) -> None:
        self._native = native
        #: How a drawing was understood; empty for other cases.
        self.notes = notes or []
        #: Picture of what was read of a drawing.
        self.drawing = drawing

    @classmethod
    def load(cls, path: str | PathLike[str]) -> Case:
        """Reads a case file."""
        with open(path, "rb"):
            return cls(_native.Case.load(fspath(path)))

    @classmethod
    def from_text(cls, text: str, name: str = "case.toml") -> Case:
        """Reads a case from TOML text. Files that it names are looked up beside ``name``."""
        return cls(_native.Case.parse(text, name, []))

    @classmethod
    def from_dict(cls, tables: Mapping[str, Any], name: str = "case.toml") -> Case:
        """Reads a case from nested dictionaries with the keys of case files."""
        return cls.from_text(_native.toml(json.dumps(tables)), name)

    @classmethod
    def from_drawing(cls, path: str | PathLike[str], **options: Any) -> Case:
        """Makes a case around the tools of a DXF drawing.

        Options: ``layers`` (dict from layer to tool), ``units``, ``axis``, ``join``, ``tolerance``, ``punch_moves``,
        ``geometry``, ``material``, ``thickness``, ``blank_radius``, ``travel``; texts with units. What is not given is a
        placeholder, marked in ``case.text``.
        """
        text, name, notes, drawing = _native.from_drawing(fspath(path), json.dumps(options))
        return cls(_native.Case.parse(text, name, []), notes, Picture._of(*drawing))

    def with_(self, settings: Mapping[str, object] | None = None, /, **more: object) -> Case:
        """Returns the case with other values of some keys: ``case.with_({"blank.thickness": "0.8 mm"})``.

        Keys are dotted paths, values as in case files. ``friction`` is that of every tool.
        """
        pairs = {**(settings or {}), **more}
        return Case(self._native.with_settings([f"{key}={setting(value)}" for key, value in pairs.items()]))

    @property
    def name(self) -> str:
        """Stem of the file's name."""
        return self._native.name

    @property
    def title(self) -> str:
        """Title above plots and reports."""
        return self._native.title

    @property
    def text(self) -> str:
        """Text of the case with all settings applied: enough to repeat the run."""
        return self._native.text

    @property
    def settings(self) -> list[str]:
        """``key=value`` settings that replaced values of the file."""
        return self._native.settings

    @property
    def stages(self) -> list[str]:
        """Names of the stages."""
        return self._native.stages

    def check(self) -> list[Finding]:
        """Findings before the run: assumptions made while the case was read, and odd values."""
        return [Finding._of(row) for row in json.loads(self._native.findings())]

    def solve(self, progress: Progress | None = None) -> Solution:
        """Solves the case, without the interpreter's lock.

        ``progress`` is called with the share that is done, from 0 to 1; raise an exception in it to abort. Ctrl-C raises
        :class:`Interrupted`, whose ``partial`` is the solution so far.
        """
        native, raised = self._native.solve(progress)
        return finished(Solution(native), raised)

    def __reduce__(self) -> tuple[object, ...]:
        return _restored, (self._native.written, self._native.path, self.settings, self.notes)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Case) and (self.text, self.name) == (other.text, other.name)

    def __hash__(self) -> int:
        return hash((self.text, self.name))

    def __repr__(self) -> str:
        return f"<Case {self.name}: {self.title}>"


def _restored(text: str, path: str, settings: list[str], notes: list[str]) -> Case:
    return Case(_native.Case.parse(text, path, settings), notes)


def setting(value: object) -> str:
    """A value as ``--set`` takes it."""
    if isinstance(value, str):
        return value
    return json.dumps(value)


def new(template: str, **sizes: str | float) -> Case:
    """Makes a case from a template and a few sizes with units: ``new("cup", height="35 mm")``.

    Other sizes follow from stated rules; :func:`templates` lists the options.
    """
    given = [(name.replace("_", "-"), str(size)) for name, size in sizes.items()]
    return Case.from_text(_native.fill(template, given), f"{template}.toml")


def templates() -> dict[str, dict[str, str]]:
    """Options of each template, with what each one is."""
    return {
        name: {key.replace("-", "_"): about for key, about in options} for name, options in _native.templates().items()
    }


def materials() -> list[str]:
    """Names of the built-in sheets."""
    return _native.materials()
