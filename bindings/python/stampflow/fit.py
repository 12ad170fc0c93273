"""Numbers from measurements: hardening laws from tension tests, keys of a case from measured curves."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, overload

from . import _native, given
from ._html import Page
from .case import Case, Progress
from .errors import StudyError, finished
from .given import Path, Table, assigned
from .picture import Picture
from .plots import Plots
from .study import Told

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from ._native import _Told


@dataclass(frozen=True)
class Parameter:
    """A fitted number."""

    #: Of a law, ``k``, or the key of a case.
    name: str
    #: Empty for plain numbers.
    unit: str
    #: In ``unit``, as all that follows.
    value: float
    #: None where the points do not tell it.
    standard_error: float | None
    #: Ends of its interval of 95 %, by the profile of the sum of squares; None where one is open or not known.
    low: float | None
    high: float | None
    #: Between what it was looked for.
    bounds: tuple[float, float]
    #: Whether it is pushed against one of them.
    at_bound: bool

    def __float__(self) -> float:
        return self.value


@dataclass(frozen=True)
class FittedLaw:
    """A hardening law through tension tests."""

    #: ``swift``, ``voce``, ``hockett-sherby``, ``ludwik`` or ``mixed``.
    name: str
    #: With its numbers.
    formula: str
    #: The rate law, where tests differ in their rate.
    rate: str | None
    #: By their names.
    parameters: dict[str, Parameter]
    #: In the order of the parameters; None where one has no error.
    correlations: list[list[float | None]]
    #: Share of the points' variance that the law explains [–].
    r2: float
    #: What it misses the points by, root of the mean square [MPa].
    rms: float
    #: Akaike's criterion: the less, the better the law for its numbers.
    aic: float
    #: Whether misses bow to one side and the other: the law is not of the points' shape.
    bows: bool


@dataclass(frozen=True)
class TensionTest:
    """A tension test, reduced."""

    #: Its file; of arrays ``test 1``.
    file: str
    #: Slope of the elastic line [MPa].
    young: float | None
    #: Engineering stress at the yield offset [MPa].
    yield_stress: float | None
    #: Largest engineering stress [MPa].
    strength: float
    #: Plastic strain at the largest force, where the force falls thereafter [–].
    uniform: float | None
    #: Points that laws are fitted to.
    points: int
    #: Largest plastic strain of them [–].
    end: float
    #: Width over thickness strain [–].
    r: float | None
    #: Strain rate [1/s].
    rate: float | None
    #: To the rolling direction [°].
    direction: float | None


@dataclass(frozen=True)
class FittedCurve:
    """A measured curve beside the fitted run."""

    #: Its file; of arrays ``curve 1``.
    file: str
    #: In the units of the solver: mm, N, or N/mm of depth.
    x: NDArray[np.float64]
    measured: NDArray[np.float64]
    #: NaN where the run does not come.
    computed: NDArray[np.float64]
    #: Points that no run came to.
    left_out: int


class FitPlots(Plots):
    """The pictures of a fit."""

    def fit(self, curve: int = 0) -> Picture:
        """Points, laws or runs, and what the chosen one misses the points by; of several measured curves each its own."""
        return self._picture(f"fit_{curve + 1}" if curve else "fit")


class _Fitted(Told):
    _title = "Fit"

    @property
    def plot(self) -> FitPlots:
        """Its pictures: ``plot.fit()``."""
        return FitPlots(self._pictures.get, "this fit")

    def _table(self, parameters: Mapping[str, Parameter]) -> Page:
        page = super()._page()
        told = [
            (one.name, f"{one.value:.6g} {one.unit}", _told(one.standard_error), f"{_told(one.low)} … {_told(one.high)}")
            for one in parameters.values()
        ]
        return Page(
            title=page.title,
            answer=page.answer,
            picture=page.picture,
            notes=page.notes,
            summary="Numbers",
            header=("", "value", "standard error", "interval of 95 %"),
            rows=told,
        )


class FittedLaws(_Fitted):
    """Hardening laws through tension tests, and the one to use."""

    def __init__(self, told: _Told, setting: str) -> None:
        super().__init__(told)
        found = self.json
        self._setting = setting
        #: All that were fitted, by their names.
        self.laws = {law["law"]: _law(law) for law in found["laws"]}
        #: The one to use; ``notes`` say why.
        self.best = self.laws[found["best"]]
        self.answer, self.notes = self.best.formula, [self.answer, *self.notes]
        #: The tests.
        self.tests = [TensionTest(*(test[key] for key in _TEST)) for test in found["tests"]]
        #: Of each direction ``direction_deg``, ``tests``, ``stress_ratio``, ``r`` and ``r_error``.
        self.directions: list[dict[str, float | None]] = found["directions"]
        #: ``[material]`` of a case, to paste.
        self.material: str = found["material"]

    def applied_to(self, case: Case) -> Case:
        """The case with this sheet: its ``[material]`` is replaced."""
        return Case(case._native.with_settings([self._setting]))

    def _page(self) -> Page:
        return self._table(self.best.parameters)


class FittedCase(_Fitted):
    """Keys of a case with which its run meets measured curves."""

    def __init__(self, told: _Told, case: _native.Case) -> None:
        import numpy

        super().__init__(told)
        found = self.json
        #: By their keys.
        self.parameters = _parameters(found)
        #: In the order of the parameters; None where one has no error.
        self.correlations: list[list[float | None]] = found["correlations"]
        #: The fitted case.
        self.case = Case(case)
        #: What makes it of the first, ``key=value``.
        self.settings: list[str] = found["set"]
        #: Root of the mean square of the weighted misses, at the ``start``, at the ``end``, and of a run's numerical noise [–].
        self.rms: dict[str, float | None] = found["rms"]
        #: Runs that were made, and those of them that came to nothing.
        self.runs: int = found["runs"]
        self.failed: int = found["failed"]
        #: The measured curves.
        self.curves = []
        for curve in found["curves"]:
            x, measured, computed = numpy.array(curve["x_measured_computed"], dtype=float).reshape(-1, 3).T.copy()
            self.curves.append(FittedCurve(curve["file"], x, measured, computed, curve["left_out"]))

    def _page(self) -> Page:
        return self._table(self.parameters)


@overload
def fit(
    measured: Table | Sequence[Table],
    *,
    law: str | None = None,
    young: str | None = None,
    offset: str | None = None,
    from_: str | None = None,
    until: str | None = None,
    section: str | None = None,
    gauge: str | None = None,
    rate: Sequence[float] = (),
    rate_law: str | None = None,
    direction: Sequence[float] = (),
) -> FittedLaws: ...
@overload
def fit(
    measured: Case | Path,
    vary: Mapping[str, str] | Sequence[str] | str | None,
    *,
    to: Table | Sequence[Table] = (),
    settings: Mapping[str, object] | None = None,
    threads: int | None = None,
    progress: Progress | None = None,
) -> FittedCase: ...
def fit(
    measured: Case | Table | Sequence[Table],
    vary: Mapping[str, str] | Sequence[str] | str | None = None,
    *,
    to: Table | Sequence[Table] = (),
    settings: Mapping[str, object] | None = None,
    threads: int | None = None,
    progress: Progress | None = None,
    law: str | None = None,
    young: str | None = None,
    offset: str | None = None,
    from_: str | None = None,
    until: str | None = None,
    section: str | None = None,
    gauge: str | None = None,
    rate: Sequence[float] = (),
    rate_law: str | None = None,
    direction: Sequence[float] = (),
) -> FittedLaws | FittedCase:
    """A hardening law from tension tests, or keys of a case from measured curves: ``stampflow fit``.

    ``fit("test.csv")`` compares all laws, ``law`` takes one: ``swift``, ``voce``, ``hockett-sherby``, ``ludwik``, ``mixed``.
    Names of columns say what is in a test and end with the unit: ``engineering_strain_percent``, ``true_stress_MPa``,
    ``plastic_strain``, ``elongation_mm`` and ``force_kN`` with ``gauge`` (``"80 mm"``) and ``section`` (``"20 mm^2"``). A test
    is a CSV file, a frame of pandas, or arrays: ``fit({"engineering_strain": strain, "engineering_stress_MPa": stress})``;
    several are in a list. ``young`` is the modulus, ``"210 GPa"``; ``offset`` the plastic strain at yield, ``"0.2 %"``;
    ``from_`` and ``until`` are the plastic strains between which is fitted. Tests with ``rate`` [1/s] give a rate law
    (``power``, ``johnson-cook``, ``cowper-symonds``), tests with ``direction`` [° to rolling] r-values.

    ``fit(case, {"friction": "0.1 in 0.01..0.3"}, to="curve.csv")`` runs the case, on all cores, without the interpreter's
    lock, until it meets measured curves: travel and force, travel and draw-in, s0 or radius and thickness; those of its
    ``[[compare]]`` unless ``to`` is given. Curves are given as tests are: ``to={"travel_mm": travel, "punch_force_kN": force}``.
    Each key says where to begin and between what. ``fit("study.toml")`` takes from a study file what is not given here; a
    type checker is told that it is no test by ``fit("study.toml", None)``. ``settings`` are those of all runs. ``progress`` is called with the share that is done, from 0 to 1. Ctrl-C raises
    :class:`Interrupted`, whose ``partial`` has the best so far; before the first step, KeyboardInterrupt.
    """
    if isinstance(measured, Case) or given.is_case_file(measured):
        of, curves = given.of(measured, settings), given.tables(to, "curve")
        told, case, raised = _native.fit_case(of, assigned(vary), curves, threads, progress)
        return finished(FittedCase(told, case), raised)
    if vary is not None or settings is not None or given.is_table(to) or to:
        raise StudyError("vary, settings and to are of a case", "give a case in place of a test")
    reduced = [young, offset, from_, until, section, gauge]
    laws = (law, rate_law)
    return FittedLaws(*_native.fit_law(given.tables(measured, "test"), laws, reduced, list(rate), list(direction)))


_TEST = (
    "file",
    "young_MPa",
    "yield_stress_MPa",
    "strength_MPa",
    "uniform_plastic_strain",
    "points",
    "end",
    "r",
    "rate_per_s",
    "direction_deg",
)


def _law(found: dict[str, Any]) -> FittedLaw:
    names = ("formula", "rate", "correlations", "r2", "aic", "bows")
    of = {name: found[name] for name in names}
    return FittedLaw(name=found["law"], parameters=_parameters(found), rms=found["rms_MPa"], **of)


def _parameters(found: dict[str, Any]) -> dict[str, Parameter]:
    keys = ("parameter", "unit", "value", "standard_error", "low_95", "high_95", "bounds", "at_bound")
    return {one["parameter"]: Parameter(*(one[key] for key in keys)) for one in found["parameters"]}


def _told(value: float | None) -> str:
    return "–" if value is None else f"{value:.4g}"
