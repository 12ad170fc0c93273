"""How sure a verdict is when coil, friction, thickness and press scatter."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from . import _native, given
from ._html import Page
from .case import Case, Progress
from .errors import finished
from .given import Path, assigned
from .picture import Picture
from .plots import Plots
from .study import Rows, Told

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from ._native import _Band, _Table, _Told


@dataclass(frozen=True)
class Estimate:
    """A number of a sample, and between what it is, with 95 % confidence."""

    value: float
    low: float
    high: float

    def __float__(self) -> float:
        return self.value


@dataclass(frozen=True)
class Sobol:
    """What of a number's variance a key decides [–]."""

    #: By itself.
    first_order: Estimate
    #: With what it does together with others.
    total: Estimate


@dataclass(frozen=True)
class Influence:
    """What a number or a light hangs on."""

    #: Spearman's rank correlation with each key [–]; None where there is none.
    rank_correlation: dict[str, float | None]
    #: Of each key, or group of correlated keys; None where indices were not asked for.
    sobol: dict[str, Sobol] | None


@dataclass(frozen=True)
class Chance:
    """How likely a light is."""

    #: The row of the verdict: ``thinning``; ``tear`` is any row by which the sheet tears, ``verdict`` all together.
    row: str
    #: ``red`` or ``amber``.
    light: str
    #: Runs that have it.
    runs: int
    #: Share of parts [–].
    probability: Estimate
    influence: Influence


@dataclass(frozen=True)
class Spread:
    """How a number scatters, in the unit at the end of its name."""

    #: Runs that have it.
    runs: int
    mean: float
    standard_deviation: float
    #: 5 %, half and 95 % of the parts are below.
    q05: float
    q50: float
    q95: float
    influence: Influence


@dataclass(frozen=True)
class Band:
    """Curves of nine parts in ten."""

    #: Punch travel, or initial distance from the axis [mm].
    x: NDArray[np.float64]
    #: 5 %, half and 95 % of the parts are below: punch force [N, or N/mm of depth], or thickness [mm].
    q05: NDArray[np.float64]
    q50: NDArray[np.float64]
    q95: NDArray[np.float64]
    #: Runs that come there.
    runs: list[int]


class ScatterPlots(Plots):
    """The pictures of a scatter, each a method; one that has nothing to draw is a ValueError that says so."""

    def scatter(self) -> Picture:
        """How the numbers that decide lie to their limits."""
        return self._picture("scatter")

    def load_band(self) -> Picture:
        """Punch force [N, or N/mm of depth] over the travel [mm] of nine parts in ten."""
        return self._picture("load_band")

    def thickness_band(self) -> Picture:
        """Thickness [mm] over the blank of nine parts in ten."""
        return self._picture("thickness_band")

    def influence(self) -> Picture:
        """What decides each number: Sobol indices where they were asked for, else rank correlations."""
        return self._picture("influence")


class Scatter(Told, Rows):
    """What a sample of parts says. Its columns have a row for every run: ``scatter["friction"]``, ``scatter["thinnest_mm"]``.

    Of a sample that was cut short, or a shard of one, there are the columns alone: ``lights`` and ``numbers`` are empty.
    """

    _title = "Scatter"

    def __init__(self, said: tuple[_Told, _Band | None, _Band | None] | None, table: _Table) -> None:
        told, load, thickness = said or (("{}", [], []), None, None)
        super().__init__(told)
        self._hold(table)
        #: The lights, and how likely each is: of tearing, of the verdict, of every row that is red or amber in some run.
        self.lights = [_chance(light) for light in self.json.get("lights", [])]
        #: Every number by its name with its unit.
        self.numbers = {number["number"]: _spread(number) for number in self.json.get("numbers", [])}
        #: What scatters, names with units.
        self.scatters: list[str] = self.json.get("scatters", [])
        #: What was declared, for want of what scatters.
        self.declared: list[str] = self.json.get("declared", [])
        #: Runs that say nothing of the part, and why.
        self.failures: dict[str, int] = self.json.get("failures", {})
        #: Punch force over the travel; None where no punch moves.
        self.load = _band(load)
        #: Thickness over the initial distance from the axis.
        self.thickness = _band(thickness)

    def probability(self, row: str, light: str = "red") -> Estimate:
        """Share of parts in which a row has a light [–]; a KeyError of a row that has it in no run."""
        for chance in self.lights:
            if (chance.row, chance.light) == (row, light):
                return chance.probability
        raise KeyError(f"{row} is {light} in no run")

    @property
    def plot(self) -> ScatterPlots:
        """Its pictures: ``plot.load_band()``."""
        return ScatterPlots(self._pictures.get, "this scatter")

    def _page(self) -> Page:
        page = super()._page()
        rows = [
            (chance.light, chance.row, *(f"{100 * share:.3g} %" for share in (p.value, p.low, p.high)))
            for chance in self.lights
            for p in [chance.probability]
        ]
        return Page(
            title=page.title,
            answer=page.answer or f"{self.runs} runs",
            picture=page.picture,
            notes=page.notes,
            summary="How likely each light is",
            header=("", "row", "share of parts", "from", "to"),
            rows=rows,
        )


def scatter(
    case: Case | Path,
    vary: Mapping[str, str] | Sequence[str] | str | None = None,
    *,
    correlate: Mapping[tuple[str, str], float] | None = None,
    runs: int | None = None,
    seed: int | None = None,
    indices: bool = False,
    settings: Mapping[str, object] | None = None,
    shard: tuple[int, int] | None = None,
    out: Path | None = None,
    resume: bool = False,
    restart: bool = False,
    threads: int | None = None,
    progress: Progress | None = None,
) -> Scatter:
    """Runs a quasi-random sample of what a case meets, on all cores, without the interpreter's lock: ``stampflow scatter``.

    ``vary`` says how each key scatters: ``{"friction": "uniform 0.05..0.12", "blank.thickness": "normal ± 0.02 mm in ± 0.05
    mm"}``, without a middle about the case's own value, % of it. ``friction`` is that of every tool, ``strength`` a factor on
    all stresses of the hardening law. Without ``vary`` what is declared scatters. ``correlate`` has pairs that go together:
    ``{("material.hardening.swift.k", "material.hardening.swift.n"): -0.8}``. ``runs`` are the points of the sample, best a
    power of two, 1024 unless given; ``seed`` makes another sample of the same. ``indices`` also says what share of each
    number's variance is whose, which takes as many times the runs as there are keys, and two more. ``scatter("study.toml")``
    takes from a study file what is not given here. ``settings`` are those of all runs.

    ``out``, ``resume``, ``restart`` and ``shard`` are those of :func:`sweep`, of the table ``scatter.csv``.

    ``threads`` is one for each core unless given. ``progress`` is called with the share that is done, from 0 to 1. Ctrl-C
    raises :class:`Interrupted`, whose ``partial`` has the runs that were made, without statistics.
    """
    pairs = [f"{a},{b}={coefficient}" for (a, b), coefficient in (correlate or {}).items()]
    size = (runs, seed, indices)
    of, part = given.of(case, settings), given.part(shard, out, resume, restart)
    name = given.stem(case)
    said, table, raised = _native.scatter(of, assigned(vary), pairs, size, name, part, threads, progress)
    return finished(Scatter(said, table), raised)


def _influence(found: dict[str, Any]) -> Influence:
    sobol = found["sobol"]
    indices = sobol and {
        key: Sobol(Estimate(**index["first_order"]), Estimate(**index["total"])) for key, index in sobol.items()
    }
    return Influence(found["rank_correlation"], indices)


def _chance(found: dict[str, Any]) -> Chance:
    probability, influence = Estimate(**found["probability"]), _influence(found["influence"])
    return Chance(found["row"], found["light"], found["runs"], probability, influence)


def _spread(found: dict[str, Any]) -> Spread:
    names = ("runs", "mean", "standard_deviation", "q05", "q50", "q95")
    return Spread(**{name: found[name] for name in names}, influence=_influence(found["influence"]))


def _band(parts: _Band | None) -> Band | None:
    if parts is None:
        return None
    x, (q05, q50, q95), runs = parts
    return Band(x, q05, q50, q95, runs)
