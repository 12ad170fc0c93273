"""Studies: many runs of one case, as ``stampflow sweep``, ``search``, ``scatter``, ``fit`` and ``compare`` have them."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterable, Mapping, Sequence
from os import PathLike, fspath
from typing import TYPE_CHECKING, Any

from . import _native
from .case import Case, existing
from .columns import Named, read_only
from .errors import finished
from .picture import Plots

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

Progress = Callable[[float], object]
Path = str | PathLike[str]
#: ``KEY=VALUES`` texts, or values by key: a text, a number, a list, or a range (from, to) or (from, to, count).
Variables = Mapping[str, Any] | Sequence[str]


class Study:
    """Results of a study. Notebooks show its headline and its first picture."""

    def __init__(self, report: str, runs: tuple[list[str], list[list[str]]], pictures: dict[str, tuple[str, str]]) -> None:
        #: Contents of ``--json``.
        self.json: dict[str, Any] = json.loads(report)
        #: Result in one sentence.
        self.headline = str(self.json["headline"])
        #: Further sentences.
        self.notes: list[str] = self.json["notes"]
        #: Whether it found what was wanted.
        self.found = bool(self.json["found"])
        self._parts = report, runs, pictures
        header, self._rows = runs
        self._columns = Named("column", {name: column(row[i] for row in self._rows) for i, name in enumerate(header)})
        #: Columns of the run table: variables, then responses, then light, end and reason.
        self.columns = tuple(header)
        #: Pictures, each a method.
        self.plot = Plots(lambda: list(pictures), lambda name: pictures.get(name))

    def __len__(self) -> int:
        return len(self._rows)

    def __getitem__(self, name: str) -> NDArray[Any]:
        """Read-only column of the run table: floats if every cell is a number or empty, else text."""
        return self._columns[name]

    def __reduce__(self) -> tuple[object, ...]:
        return Study, self._parts

    def to_pandas(self) -> Any:
        """``pandas.DataFrame`` with one row per run."""
        import pandas

        return pandas.DataFrame(dict(self._columns))

    def __repr__(self) -> str:
        return f"<Study of {len(self)} runs: {self.headline}>"

    def _repr_html_(self) -> str:
        from html import escape

        first = next(iter(self._parts[2].values()), None)
        notes = "".join(f"<li>{escape(note)}</li>" for note in self.notes)
        return f"<p><b>{escape(self.headline)}</b></p>" + (first[0] if first else "") + f"<ul>{notes}</ul>"


def column(cells: Iterable[str]) -> NDArray[Any]:
    """Cells as floats, or as text if one is no number."""
    import numpy as np

    cells = list(cells)
    try:
        return read_only(np.array([float(cell) if cell else np.nan for cell in cells]))
    except ValueError:
        return read_only(np.array(cells))


def texts(variables: Variables, between: str = "") -> list[str]:
    """Variables as ``KEY=VALUES``; ``between`` stands before a range that is given as a tuple."""
    if not isinstance(variables, Mapping):
        return [variables] if isinstance(variables, str) else list(variables)

    def values(value: Any) -> str:
        if isinstance(value, tuple):
            low, high, *count = value
            return f"{between}{low}..{high}" + "".join(f"/{number}" for number in count)
        return ", ".join(map(str, value)) if isinstance(value, Iterable) and not isinstance(value, str) else str(value)

    return [f"{key}={values(value)}" for key, value in variables.items()]


def _run(kind: str, case: Case | Path, request: dict[str, Any], progress: Progress | None) -> Study:
    base = case if isinstance(case, Case) else Case.load(case)
    report, runs, pictures, raised = _native.study(kind, base._native, json.dumps(request), progress)
    return finished(Study(report, runs, pictures), raised)


def sweep(
    case: Case | Path,
    vary: Variables,
    *,
    one_at_a_time: bool = False,
    threads: int | None = None,
    progress: Progress | None = None,
) -> Study:
    """Runs every combination of values: ``sweep(case, {"friction": [0.04, 0.08], "tools.die.shoulder": ("4 mm", "10 mm", 4)})``."""
    request = {"vary": texts(vary), "one_at_a_time": one_at_a_time, "threads": threads}
    return _run("sweep", case, request, progress)


def search(
    case: Case | Path,
    vary: Variables = (),
    *,
    goal: str | None = None,
    largest: bool = False,
    smallest: bool = False,
    while_: str | None = None,
    target: str | None = None,
    tolerance: str | None = None,
    threads: int | None = None,
    progress: Progress | None = None,
) -> Study:
    """Finds where a condition ends or a number has a wanted value: ``search(case, goal="limiting-draw-ratio")``,
    ``search(case, {"blank.radius": ("45 mm", "70 mm")}, largest=True, while_="no red")``."""
    side = "largest" if largest else "smallest" if smallest else None
    request = {"vary": texts(vary), "goal": goal, "side": side, "condition": while_, "target": target}
    return _run("search", case, {**request, "tolerance": tolerance, "threads": threads}, progress)


def scatter(
    case: Case | Path,
    vary: Variables = (),
    *,
    runs: int = 256,
    seed: int = 1,
    threads: int | None = None,
    progress: Progress | None = None,
) -> Study:
    """Runs a sample of scattering inputs: ``scatter(case, {"friction": "normal 0.08 ± 0.01"}, runs=64)``.

    A range, ``(0.06, 0.10)``, is a uniform distribution.
    """
    return _run("scatter", case, {"vary": texts(vary, "uniform "), "runs": runs, "seed": seed, "threads": threads}, progress)


def fit(
    case: Case | Path,
    vary: Variables = (),
    to: Path | Sequence[Path] = (),
    *,
    threads: int | None = None,
    progress: Progress | None = None,
) -> Study:
    """Fits keys of a case to measured curves, or hardening laws to a tension test (a CSV file in place of the case)."""
    files = [existing(path) for path in ([to] if isinstance(to, (str, PathLike)) else to)]
    if not isinstance(case, Case) and fspath(case).endswith(".csv"):
        report, runs, pictures = _native.fit_law([existing(case), *files])
        return Study(report, runs, pictures)
    return _run("fit", case, {"vary": texts(vary), "to": files, "threads": threads}, progress)


def compare(*cases: Case | Path, also: Sequence[str] = (), to: Sequence[Path] = ()) -> Study:
    """Compares cases, variants of the first one (``also="friction=0.12"``) and measured curves."""
    bases = [case if isinstance(case, Case) else Case.load(case) for case in cases]
    variants = [also] if isinstance(also, str) else list(also)
    report, runs, pictures = _native.compare([base._native for base in bases], variants, [existing(path) for path in to])
    return Study(report, runs, pictures)
