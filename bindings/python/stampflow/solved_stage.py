"""One operation on the sheet, and what was kept of it."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import cached_property
from typing import TYPE_CHECKING, overload

from ._html import Page, Shown
from .columns import Columns
from .frame import Frame
from .stage_plots import StagePlots

if TYPE_CHECKING:
    from ._native import Solution


class SolvedStage(Shown):
    """A stage that was run."""

    def __init__(self, native: Solution, index: int, parts: tuple[str, str, str, bool, int, int]) -> None:
        self._native = native
        self._index = index
        #: Its name in the case.
        self.name = parts[0]
        #: Why it ended, in a few words: ``full travel``, ``localised``, ``interrupted`` ...
        self.stop = parts[1]
        #: The same as a sentence.
        self.why = parts[2]
        #: Whether it came to the end that was asked for.
        self.complete = parts[3]
        #: Iterations of all accepted steps.
        self.iterations = parts[4]
        #: What was kept of some instants, the last of them the end: ``frames[-1].thickness``.
        self.frames: Sequence[Frame] = Frames(native, index, parts[5])

    def __repr__(self) -> str:
        return f"<SolvedStage {self.name}: {self.stop}, {len(self.frames)} frames>"

    def _table(self, name: str) -> Columns:
        columns = self._native.table(self._index, f"{name}.csv")
        if columns is None:
            raise ValueError(f"the stage {self.name} has no {name}")
        return Columns(columns)

    @cached_property
    def load_travel(self) -> Columns:
        """Every accepted step: ``travel_mm``, ``punch_force_N`` (``punch_force_N_per_mm`` in plane strain), ``draw_in_mm``,
        works in J, iterations, and more."""
        return self._table("load_travel")

    @cached_property
    def profile(self) -> Columns:
        """Every element of every kept frame: ``travel_mm``, ``s0_mm``, ``thickness_mm``, strains, stresses in MPa."""
        return self._table("profile")

    @cached_property
    def strain_paths(self) -> Columns:
        """Strains of every element over the steps and their margin to the forming limit; where the case gives one."""
        return self._table("strain_paths")

    @cached_property
    def forming_limit(self) -> Columns:
        """The forming limit curve in true strains; where the case gives one."""
        return self._table("forming_limit")

    @cached_property
    def residual_stress(self) -> Columns:
        """Stress in MPa at every thickness point; of a stage that releases the sheet."""
        return self._table("residual_stress")

    @cached_property
    def pressure_cycle(self) -> Columns:
        """Gas pressure in MPa and strain rate in 1/s over time; where a gas holds a rate."""
        return self._table("pressure_cycle")

    @property
    def plot(self) -> StagePlots:
        """Its pictures: ``plot.load_travel()``."""
        return StagePlots(lambda name: self._native.picture(self._index, f"{name}.png"), "this stage")

    def _page(self) -> Page:
        return Page(title=self.name, answer=self.why, picture=self.plot._first("part"))


class Frames(Sequence[Frame]):
    """The kept frames of a stage, each made when it is asked for."""

    def __init__(self, native: Solution, stage: int, count: int) -> None:
        self._native = native
        self._stage = stage
        self._count = count

    def __len__(self) -> int:
        return self._count

    @overload
    def __getitem__(self, index: int) -> Frame: ...
    @overload
    def __getitem__(self, index: slice) -> list[Frame]: ...
    def __getitem__(self, index: int | slice) -> Frame | list[Frame]:
        if isinstance(index, slice):
            return [self[i] for i in range(*index.indices(self._count))]
        at = index + self._count if index < 0 else index
        if not 0 <= at < self._count:
            raise IndexError(f"there is no frame {index}: {self._count} were kept")
        return Frame(*self._native.frame(self._stage, at))

    def __iter__(self) -> Iterator[Frame]:
        return (self[i] for i in range(self._count))

    def __repr__(self) -> str:
        return f"<{self._count} frames>"
