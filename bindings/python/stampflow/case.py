"""A case: the problem to solve."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from os import PathLike, fspath
from typing import TypeAlias

from . import _html, _native, _toml, finding
from ._html import Page, Shown
from .errors import finished
from .finding import Finding
from .picture import Picture
from .solution import Solution

Progress: TypeAlias = Callable[[float], object]
"""What is called now and then with the share that is done, from 0 to 1. An exception of it ends the work."""


class Case(Shown):
    """A case as it was read. It never changes; :meth:`with_` gives another one."""

    def __init__(self, native: _native.Case) -> None:
        self._native = native
        #: How a drawing was understood, what follows from it, and what is doubted; empty of other cases.
        self.notes: list[str] = []
        #: What was read of a drawing; None of other cases.
        self.drawing: Picture | None = None

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

    @classmethod
    def from_drawing(
        cls,
        path: str | PathLike[str],
        *,
        layers: Mapping[str, str] | None = None,
        units: str | None = None,
        axis: str | None = None,
        punch_moves: str | None = None,
        geometry: str | None = None,
        material: str | None = None,
        thickness: str | None = None,
        blank_radius: str | None = None,
        travel: str | None = None,
        join: str | None = None,
        tolerance: str | None = None,
    ) -> Case:
        """A case from a die's drawing (DXF), as ``stampflow import`` writes it.

        Layers whose names hold punch, die, holder or another word for one are those tools; ``layers`` says what others are:
        ``{"Stempel": "punch", "Hilfslinien": "none"}``. ``units`` is the drawing's, ``"mm"`` or ``"in"``, where its header
        does not say it; ``axis`` the x of the axis there; ``punch_moves`` is ``"down"`` or ``"up"``; ``geometry`` is
        ``"axisymmetric"`` unless it is ``"plane_strain"``, where ``blank_radius`` is the half-length. Ends that are no
        farther apart than ``join`` meet (``"0.01 mm"``), arcs leave a spline by ``tolerance`` at most (``"0.001 mm"``).

        What is not given is a placeholder, marked in ``case.text``. ``case.notes`` says how the drawing was understood,
        ``case.drawing`` shows what was read. What is wrong with the drawing is a :class:`DrawingError` with line and help.
        """
        tools = [f"{layer}={tool}" for layer, tool in (layers or {}).items()]
        how = [units, axis, join, tolerance, punch_moves, geometry]
        sizes = [material, thickness, blank_radius, travel]
        native, notes, drawing = _native.from_drawing(fspath(path), tools, how, sizes)
        case = cls(native)
        case.notes, case.drawing = notes, Picture._of(drawing)
        return case

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

    def value(self, key: str) -> str | None:
        """What the case has for a key, as it is written there: ``case.value("blank.thickness")`` is ``"0.9 mm"``.

        ``friction`` is that of every tool. None where the case does not say it, or where tools have different values.
        """
        return self._native.value(key)

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
        return finished(Solution(self, native), raised)

    def __reduce__(self) -> tuple[object, ...]:
        # Another process, and a copy, read it anew.
        return _again, (self._native.written, self.path, self.settings, self.notes, self.drawing)

    def __repr__(self) -> str:
        return f"<Case {self.name}: {self.title}>"

    def _page(self) -> Page:
        found = self.check()
        return Page(
            title=self.title,
            answer=f"{self.name}: {', '.join(self.stages)}" if len(self.stages) > 1 else self.name,
            picture=self.drawing,
            notes=self.notes,
            summary=f"{len(found)} findings before it is solved",
            header=_html.FINDINGS,
            rows=_html.findings(found),
        )


def _again(text: str, path: str, settings: list[str], notes: list[str], drawing: Picture | None) -> Case:
    case = Case(_native.Case.parse(text, path, settings))
    case.notes, case.drawing = notes, drawing
    return case
