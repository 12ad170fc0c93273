"""Studies: many runs of one case, as ``stampflow sweep``, ``search``, ``scatter``, ``fit`` and ``compare`` have them."""

from __future__ import annotations

import json
from collections.abc import Callable, Mapping, Sequence
from os import PathLike, fspath
from typing import TYPE_CHECKING, Any

from . import _native
from .case import Case
from .errors import finished
from .picture import Plots

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

Progress = Callable[[float], object]
Path = str | PathLike[str]


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
        self._header, self._rows = runs
        self._pictures = pictures
        #: Pictures, each a method.
        self.plot = Plots(lambda: list(pictures), lambda name: pictures.get(name))

    def __len__(self) -> int:
        return len(self._rows)

    @property
    def columns(self) -> list[str]:
        """Columns of the run table: variables, then responses, then light, end and reason."""
        return self._header

    def __getitem__(self, name: str) -> NDArray[Any]:
        """Column of the run table: floats if every cell is a number or empty, else text."""
        import numpy as np

        if name not in self._header:
            raise KeyError(f"there is no column {name}; there are {', '.join(self._header)}")
        cells = [row[self._header.index(name)] for row in self._rows]
        try:
            return np.array([float(cell) if cell else np.nan for cell in cells])
        except ValueError:
            return np.array(cells)

    def to_pandas(self) -> Any:
        """``pandas.DataFrame`` with one row per run."""
        import pandas

        return pandas.DataFrame({name: self[name] for name in self._header})

    def __repr__(self) -> str:
        return f"<Study of {len(self)} runs: {self.headline}>"

    def _repr_html_(self) -> str:
        from html import escape

        first = next(iter(self._pictures.values()), None)
        notes = "".join(f"<li>{escape(note)}</li>" for note in self.notes)
        return f"<p><b>{escape(self.headline)}</b></p>" + (first[0] if first else "") + f"<ul>{notes}</ul>"


def texts(variables: Mapping[str, Any] | Sequence[str]) -> list[str]:
    """Variables as ``KEY=RANGE``: a text, or a list of values."""
    if not isinstance(variables, Mapping):
        return list(variables)
    listed = {key: value if isinstance(value, str) else ", ".join(str(one) for one in value) for key, value in variables.items()}
    return [f"{key}={value}" for key, value in listed.items()]


def _run(kind: str, case: Case | Path, request: dict[str, Any], progress: Progress | None) -> Study:
    base = case if isinstance(case, Case) else Case.load(case)
    report, runs, pictures, raised = _native.study(kind, base._native, json.dumps(request), progress)
    return finished(Study(report, runs, pictures), raised)


def sweep(
    case: Case | Path,
    vary: Mapping[str, Any] | Sequence[str],
    *,
    one_at_a_time: bool = False,
    threads: int | None = None,
    progress: Progress | None = None,
) -> Study:
    """Runs every combination of values: ``sweep(case, {"friction": [0.04, 0.08], "tools.die.shoulder": "4..10 mm/4"})``."""
    request = {"vary": texts(vary), "one_at_a_time": one_at_a_time, "threads": threads}
    return _run("sweep", case, request, progress)


def search(
    case: Case | Path,
    vary: str | None = None,
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
    ``search(case, "blank.radius=45..70 mm", largest=True, while_="no red")``."""
    side = "largest" if largest else "smallest" if smallest else None
    request = {"vary": [vary] if vary else [], "goal": goal, "side": side, "condition": while_, "target": target}
    return _run("search", case, {**request, "tolerance": tolerance, "threads": threads}, progress)


def scatter(
    case: Case | Path,
    vary: Mapping[str, Any] | Sequence[str] = (),
    *,
    runs: int = 256,
    seed: int = 1,
    threads: int | None = None,
    progress: Progress | None = None,
) -> Study:
    """Runs a sample of scattering inputs: ``scatter(case, {"friction": "uniform 0.06..0.10"}, runs=64)``."""
    return _run("scatter", case, {"vary": texts(vary), "runs": runs, "seed": seed, "threads": threads}, progress)


def fit(
    case: Case | Path,
    vary: Mapping[str, Any] | Sequence[str] = (),
    to: Path | Sequence[Path] = (),
    *,
    threads: int | None = None,
    progress: Progress | None = None,
) -> Study:
    """Fits keys of a case to measured curves, or hardening laws to a tension test (a CSV file in place of the case)."""
    files = [fspath(to)] if isinstance(to, (str, PathLike)) else [fspath(path) for path in to]
    if not isinstance(case, Case) and fspath(case).endswith(".csv"):
        report, runs, pictures = _native.fit_law([fspath(case), *files])
        return Study(report, runs, pictures)
    return _run("fit", case, {"vary": texts(vary), "to": files, "threads": threads}, progress)


def compare(*cases: Case | Path, also: Sequence[str] = (), to: Sequence[Path] = ()) -> Study:
    """Compares cases, variants of the first one (``also="friction=0.12"``) and measured curves."""
    bases = [case if isinstance(case, Case) else Case.load(case) for case in cases]
    variants = [also] if isinstance(also, str) else list(also)
    report, runs, pictures = _native.compare([base._native for base in bases], variants, [fspath(path) for path in to])
    return Study(report, runs, pictures)
