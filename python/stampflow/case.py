"""A case: the problem to solve."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from os import PathLike, fspath
from typing import TypeAlias

from . import _native, _toml, finding
from .errors import Interrupted
from .finding import Finding
from .solution import Solution

Progress: TypeAlias = Callable[[float], object]
"""What is called now and then with the share that is done, from 0 to 1. An exception of it ends the work."""


class Case:
    """A case as it was read. It never changes; :meth:`with_` gives another one."""

    def __init__(self, native: _native.Case) -> None:
        self._native = native

    @classmethod
    def load(cls, path: str | PathLike[str]) -> Case:
        """Reads a case file. What is wrong with it is a :class:`CaseError` with file, line and help."""
        return cls(_native.Case.load(fspath(path)))

    @classmethod
    def from_text(cls, text: str, name: str = "case.toml") -> Case:
        """Reads a case from the text of a case file.

        ``name`` is the path that messages show and from which files beside it are looked up.
        """
        return cls(_native.Case.parse(text, name, []))

    def with_(self, settings: Mapping[str, object] | None = None, /, **more: object) -> Case:
        """The same case with other values of some keys: ``case.with_(**{"tools.punch.friction": 0.1})``.

        Keys are dotted paths; values are written as in case files: texts with units, plain numbers only for plain numbers.
        As ``--set`` on the command line, ``friction`` is that of every tool.
        """
        return Case(self._native.with_settings(_toml.settings({**(settings or {}), **more})))

    @property
    def name(self) -> str:
        """Stem of the file's name."""
        return self._native.name

    @property
    def path(self) -> str:
        """The file as it was named."""
        return self._native.path

    @property
    def title(self) -> str:
        """Shown above plots and reports."""
        return self._native.title

    @property
    def text(self) -> str:
        """The text of the case, settings applied: enough to repeat the run."""
        return self._native.text

    @property
    def settings(self) -> list[str]:
        """``key=value`` settings that replaced what the file says."""
        return self._native.settings

    @property
    def stages(self) -> list[str]:
        """Names of its stages."""
        return self._native.stages

    def check(self) -> list[Finding]:
        """What should be known before it is solved: what was assumed while it was read, and what looks odd."""
        return finding.read(self._native.findings())

    def solve(self, progress: Progress | None = None) -> Solution:
        """Solves it, without the interpreter's lock.

        ``progress`` is called now and then with the share that is done, from 0 to 1. Ctrl-C ends the run within a step: it
        raises :class:`Interrupted`, a KeyboardInterrupt whose ``partial`` is the solution up to there.
        """
        native, raised = self._native.solve(progress)
        solution = Solution(self, native)
        if isinstance(raised, KeyboardInterrupt):
            raise Interrupted(solution) from raised
        if raised is not None:
            raise raised
        return solution

    def __repr__(self) -> str:
        return f"<Case {self.name}: {self.title}>"
