"""Solved cases: stages, frames, numbers and findings."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from html import escape
from os import PathLike, fspath
from typing import TYPE_CHECKING, Any

from .columns import Columns
from .errors import finished
from .picture import Plots

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from . import _native

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

    def __init__(self, time: float, travel: float, elements: Sequence[Any], nodes: Sequence[Any]) -> None:
        #: Time [s].
        self.time = time
        #: Punch travel [mm].
        self.travel = travel
        #: Columns of the elements: ``s0_mm``, ``r_mm``, ``z_mm``, ``thickness_mm``, strains, ``stress_meridional_MPa`` …
        self.elements = Columns(elements)
        #: Columns of the nodes on the mid-surface: ``r_mm``, ``z_mm``, ``theta`` [rad], ``thickness_mm``.
        self.nodes = Columns(nodes)

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


class Frames(Sequence[Frame]):
    """Kept frames of a stage, each made on access."""

    def __init__(self, native: _native.Solution, stage: int, count: int) -> None:
        self._native, self._stage, self._count = native, stage, count

    def __len__(self) -> int:
        return self._count

    def __getitem__(self, index: Any) -> Any:
        if isinstance(index, slice):
            return [self[i] for i in range(*index.indices(self._count))]
        at = index + self._count if index < 0 else index
        if not 0 <= at < self._count:
            raise IndexError(f"there is no frame {index}: {self._count} were kept")
        return Frame(*self._native.frame(self._stage, at))

    def __iter__(self) -> Iterator[Frame]:
        return (self[i] for i in range(self._count))


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
        #: Kept frames; the last one is the end.
        self.frames: Sequence[Frame] = Frames(native, index, facts["frames"])

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

    @cached_property
    def profile(self) -> Columns:
        """Every element of every kept frame: ``travel_mm``, ``s0_mm``, ``thickness_mm``, strains, stresses."""
        return self.table("profile")

    @property
    def plot(self) -> Plots:
        """Pictures of the stage: ``plot.load_travel()``."""
        return Plots(self._native.pictures, lambda name: self._native.picture(self._index, name))

    def __repr__(self) -> str:
        return f"<Stage {self.name}: {self.stop}, {len(self.frames)} frames>"


class Solution:
    """A solved case. Notebooks show its verdict and its section.

    ``load_travel``, ``profile``, ``frames`` and ``plot`` are those of the last stage.
    """

    def __init__(self, native: _native.Solution) -> None:
        self._native = native
        #: Stages that were run, in order.
        self.stages = [Stage(native, i, facts) for i, facts in enumerate(json.loads(native.stages()))]

    @property
    def complete(self) -> bool:
        """Whether every stage came to its end."""
        return self._native.complete

    @cached_property
    def summary(self) -> dict[str, Any]:
        """Contents of ``summary.json``; with several stages a list in ``summary["stages"]``."""
        summary: dict[str, Any] = json.loads(self._native.summary())
        return summary

    @cached_property
    def _verdict(self) -> dict[str, Any]:
        verdict: dict[str, Any] = json.loads(self._native.verdict())
        return verdict

    @property
    def verdict(self) -> str:
        """Verdict in one sentence."""
        return str(self._verdict["sentence"])

    @property
    def light(self) -> str:
        """Worst light of the verdict."""
        return str(self._verdict["light"])

    @cached_property
    def findings(self) -> list[Finding]:
        """Rows of the verdict."""
        return [Finding._of(row) for row in self._verdict["findings"]]

    @cached_property
    def numbers(self) -> dict[str, Number]:
        """Numbers of the part by names with units: ``numbers["punch_force_N"]``."""
        return {row[0]: Number(*row[1:]) for row in self._native.numbers()}

    def verify(self, *, progress: Callable[[float], object] | None = None) -> Solution:
        """Returns the solution with error bars on numbers, findings and pictures.

        Mesh, steps, points and contact are refined one by one, which takes some twenty times as long as the solution.
        """
        native, raised = self._native.verify(progress)
        finished(self, raised)
        return Solution(native)

    @property
    def load_travel(self) -> Columns:
        """See :attr:`Stage.load_travel`."""
        return self.stages[-1].load_travel

    @property
    def profile(self) -> Columns:
        """See :attr:`Stage.profile`."""
        return self.stages[-1].profile

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

    def __repr__(self) -> str:
        return f"<Solution: {self.light}, {self.verdict}>"

    def _repr_html_(self) -> str:
        rows = sorted(self.findings, key=lambda row: list(COLORS).index(row.light))
        cells = "".join(
            f'<tr><td style="color:{COLORS[row.light]}">&#9679; {row.light}</td>'
            + "".join(f"<td>{escape(text)}</td>" for text in (row.label, row.found, row.limit, row.advice))
            + "</tr>"
            for row in rows
        )
        part = self._native.picture(len(self.stages) - 1, "part") if self.stages else None
        return (
            f'<p><span style="color:{COLORS[self.light]}">&#9679;</span> <b>{escape(self.verdict)}</b></p>'
            + (part[0] if part else "")
            + f"<details><summary>{len(rows)} rows of the verdict</summary><table>{cells}</table></details>"
        )
