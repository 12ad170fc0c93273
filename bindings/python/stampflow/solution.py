"""Solved cases: stages, frames, verdict and numbers."""

from __future__ import annotations

import json
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property
from html import escape
from os import PathLike, fspath
from typing import TYPE_CHECKING, Any, Literal

from .columns import Columns, Named
from .errors import finished
from .picture import Plots

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from . import _native
    from .case import Case

COLORS = {"red": "#D55E00", "amber": "#E69F00", "grey": "#787878", "green": "#009E73"}


@dataclass(frozen=True)
class Finding:
    """A row of the verdict, a warning, or an assumption."""

    #: Name for programs: ``thinning``.
    key: str
    #: Name for readers: ``Thinning``.
    label: str
    #: ``green``, ``amber``, ``red``, or ``grey`` if it was not checked.
    light: str
    #: Sentence with the number, its unit and its place.
    found: str
    #: Limit with its unit.
    limit: str
    #: Source of the limit.
    source: str
    #: What to change; empty if all is well.
    advice: str
    #: Number in ``unit``; None if there is none.
    value: float | None
    #: Half-width of the error bar in ``unit``; None if it is not known.
    error_bar: float | None
    #: Unit of the number: ``percent``, ``mm``; empty for plain numbers.
    unit: str

    @classmethod
    def _of(cls, row: dict[str, Any]) -> Finding:
        values: dict[str, Any] = {name: row.get(name) for name in cls.__dataclass_fields__}
        return cls(**values)


class Verdict(Named[Finding]):
    """Judgement of a part. As text its sentence; a mapping of its findings: ``verdict["thinning"].found``."""

    def __init__(self, light: str, sentence: str, findings: Sequence[Finding]) -> None:
        super().__init__("finding", {row.key: row for row in findings})
        #: Worst light of the findings: ``green``, ``amber``, ``red``.
        self.light = light
        #: Failure, or the most important warning.
        self.sentence = sentence

    def __str__(self) -> str:
        return self.sentence

    def __repr__(self) -> str:
        return f"<Verdict: {self.light}, {self.sentence}>"


@dataclass(frozen=True)
class Number:
    """A number of the part. ``float(number)`` is its value."""

    #: Name for readers: ``Punch force``.
    label: str
    #: Value in ``unit``.
    value: float
    #: Printed unit; empty for plain numbers.
    unit: str
    #: Half-width of the error bar in ``unit``; None if it is not known.
    error_bar: float | None
    #: Printed form without digits beyond the bar: ``47.2 ± 0.4 kN``.
    text: str

    def __float__(self) -> float:
        return self.value

    def __str__(self) -> str:
        return self.text


class Frame:
    """The sheet at one instant: arrays over its elements, from the axis or symmetry plane outward."""

    def __init__(
        self, time: float, travel: float, elements: Sequence[Any], nodes: Sequence[Any], tools: dict[str, Any]
    ) -> None:
        #: Time [s].
        self.time = time
        #: Punch travel [mm].
        self.travel = travel
        #: Columns of the elements: ``s0_mm``, ``r_mm``, ``z_mm``, ``thickness_mm``, strains, ``stress_meridional_MPa`` …
        self.elements = Columns(elements)
        #: Columns of the nodes on the mid-surface: ``r_mm``, ``z_mm``, ``theta`` [rad], ``thickness_mm``.
        self.nodes = Columns(nodes)
        #: Outlines of the tools where they stand, by name: columns ``r_mm`` and ``z_mm``.
        self.tools = outlines(tools)

    @property
    def s0(self) -> NDArray[np.float64]:
        """Initial distance from the axis or symmetry plane [mm]."""
        return self.elements["s0_mm"]

    @property
    def thickness(self) -> NDArray[np.float64]:
        """Thickness [mm]."""
        return self.elements["thickness_mm"]

    def __repr__(self) -> str:
        return f"<Frame at {self.travel:g} mm, {self.time:g} s: {len(self.s0)} elements>"


def outlines(tools: dict[str, Any]) -> Named[Columns]:
    """Columns of each tool by its name."""
    return Named("tool", {name: Columns(columns) for name, columns in tools.items()})


class Stage:
    """One operation on the sheet."""

    def __init__(self, native: _native.Solution, index: int, facts: dict[str, Any]) -> None:
        self._native, self._index = native, index
        #: Name in the case.
        self.name: str = facts["name"]
        #: Kind of its end: ``full travel``, ``localised``, ``interrupted`` …
        self.stop: str = facts["stop"]
        #: Reason of its end as a sentence.
        self.why: str = facts["why"]
        #: Whether it came to the wanted end.
        self.complete: bool = facts["complete"]
        #: Iterations of all accepted steps.
        self.iterations: int = facts["iterations"]
        self._frames: int = facts["frames"]

    @cached_property
    def frames(self) -> Sequence[Frame]:
        """Kept frames; the last one is the end."""
        return tuple(Frame(*self._native.frame(self._index, i)) for i in range(self._frames))

    @property
    def tools(self) -> Named[Columns]:
        """Outlines of the tools as drawn, where they touch the flat sheet: ``tools["die"]["r_mm"]``, ``["z_mm"]``."""
        return outlines(self._native.tools(self._index))

    def table(self, name: str) -> Columns:
        """Table by the name of its CSV file: ``load_travel``, ``profile``, ``strain_paths``, ``residual_stress`` …"""
        columns = self._native.table(self._index, f"{name}.csv")
        if columns is None:
            raise ValueError(f"the stage {self.name} has no table {name}")
        return Columns(columns)

    @cached_property
    def load_travel(self) -> Columns:
        """Every accepted step: ``travel_mm``, ``punch_force_N`` (``punch_force_N_per_mm`` in plane strain), works, iterations."""
        return self.table("load_travel")

    @property
    def plot(self) -> Plots:
        """Pictures of the stage: ``plot.load_travel()``."""
        return Plots(self._native.pictures, lambda name: self._native.picture(self._index, name))

    def __repr__(self) -> str:
        return f"<Stage {self.name}: {self.stop}, {self._frames} frames>"


class Solution:
    """A solved case: ``verdict`` judges it, ``numbers`` describe it, tables, frames and pictures show it.

    ``load_travel``, ``frames`` and ``plot`` are those of the last stage. A solution is pickled as its case and
    solved again when it is first used.
    """

    def __init__(self, case: Case, native: _native.Solution | None = None, verified: bool = False) -> None:
        #: The case.
        self.case = case
        self._verified = verified
        if native is not None:
            self._native = native

    @cached_property
    def _native(self) -> _native.Solution:
        solved = self.case.solve()
        return (solved.verify() if self._verified else solved)._native

    @cached_property
    def stages(self) -> Sequence[Stage]:
        """Stages that were run, in order."""
        return tuple(Stage(self._native, i, facts) for i, facts in enumerate(json.loads(self._native.stages())))

    @property
    def complete(self) -> bool:
        """Whether every stage came to its end."""
        return self._native.complete

    @cached_property
    def verdict(self) -> Verdict:
        """Light, sentence and findings."""
        verdict = json.loads(self._native.verdict())
        return Verdict(verdict["light"], verdict["sentence"], [Finding._of(row) for row in verdict["findings"]])

    @cached_property
    def numbers(self) -> Named[Number]:
        """Numbers by names with units: of the part, ``numbers["punch_force_N"]``, then of the last stage's summary."""
        return Named("number", {row[0]: Number(*row[1:]) for row in self._native.numbers()})

    def verify(self, *, progress: Callable[[float], object] | None = None) -> Solution:
        """Returns the solution with error bars on numbers, findings and pictures.

        Mesh, steps, points and contact are refined one by one, which takes some twenty times as long as the solution.
        """
        native, raised = self._native.verify(progress)
        finished(self, raised)
        return Solution(self.case, native, verified=True)

    @property
    def load_travel(self) -> Columns:
        """See :attr:`Stage.load_travel`."""
        return self.stages[-1].load_travel

    @property
    def frames(self) -> Sequence[Frame]:
        """See :attr:`Stage.frames`."""
        return self.stages[-1].frames

    @property
    def plot(self) -> Plots:
        """See :attr:`Stage.plot`."""
        return self.stages[-1].plot

    def write(self, folder: str | PathLike[str]) -> list[str]:
        """Writes every table and picture into a folder, as ``stampflow run --out``; returns the paths."""
        return self._native.write(fspath(folder))

    def report(self, path: str | PathLike[str]) -> None:
        """Writes the HTML report."""
        self._native.report(fspath(path))

    def export(self, path: str | PathLike[str], *, dxf: Literal["r12", "2000"] = "r12", unit: str = "mm") -> list[str]:
        """Draws tools, blank and formed sheet for CAD, as ``stampflow export``: DXF, SVG or CSV by the ending of ``path``.

        ``dxf`` is the version and ``unit`` that of a DXF file, ``"mm"`` or ``"in"``. Returns the names of the layers.
        """
        return self._native.export(fspath(path), dxf, unit)

    def _parts(self) -> tuple[object, ...]:
        # An interrupted solution does not follow from its case.
        partial = any(stage.stop == "interrupted" for stage in self.stages)
        return self.case, self._native if partial else None, self._verified

    def __reduce__(self) -> tuple[object, ...]:
        return Solution, self._parts()

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Solution) and self._parts() == other._parts()

    def __hash__(self) -> int:
        return hash((self.case, self._verified))

    def __repr__(self) -> str:
        return f"<Solution: {self.verdict.light}, {self.verdict}>"

    def _repr_html_(self) -> str:
        rows = sorted(self.verdict.values(), key=lambda row: list(COLORS).index(row.light))
        cells = "".join(
            f'<tr><td style="color:{COLORS[row.light]}">&#9679; {row.light}</td>'
            + "".join(f"<td>{escape(text)}</td>" for text in (row.label, row.found, row.limit, row.advice))
            + "</tr>"
            for row in rows
        )
        part = self._native.picture(len(self.stages) - 1, "part") if self.stages else None
        return (
            f'<p><span style="color:{COLORS[self.verdict.light]}">&#9679;</span> <b>{escape(str(self.verdict))}</b></p>'
            + (part[0] if part else "")
            + f"<details><summary>{len(rows)} rows of the verdict</summary><table>{cells}</table></details>"
        )
