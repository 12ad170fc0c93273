from collections.abc import Callable
from typing import TypeAlias, TypedDict, final

import numpy as np
from numpy.typing import NDArray

__all__ = [
    "Case",
    "Solution",
    "__version__",
    "compare",
    "fill",
    "fit_case",
    "fit_law",
    "from_drawing",
    "merge",
    "optimise",
    "scatter",
    "search",
    "sweep",
    "templates",
]

__version__: str

_Array: TypeAlias = NDArray[np.float64]
_Progress: TypeAlias = Callable[[float], object] | None
_Column: TypeAlias = tuple[str, str, str, _Array]
_Look: TypeAlias = tuple[str, str | None, str | None, float, list[float], float]
_Series: TypeAlias = tuple[str | None, _Array, _Array, _Look]
_Axis: TypeAlias = tuple[str, bool, list[str]]
_Window: TypeAlias = tuple[tuple[float, float], tuple[float, float]]
_Panel: TypeAlias = tuple[tuple[_Axis, _Axis], list[_Series], _Window, tuple[str, float | None]]
_Picture: TypeAlias = tuple[str, str, str, list[_Panel], list[str]]
_Raised: TypeAlias = BaseException | None
_Table: TypeAlias = tuple[NDArray[np.uint64], list[tuple[str, _Array]], list[tuple[str, list[str]]]]
_Told: TypeAlias = tuple[str, list[str], list[tuple[str, _Picture]]]
_Searched: TypeAlias = tuple[_Told, _Table, tuple[Case, Solution] | None, _Raised]
_Band: TypeAlias = tuple[_Array, list[_Array], list[int]]
_NumberOfRuns: TypeAlias = tuple[str, str, str, list[_Array], list[bool | None]]
_Text: TypeAlias = str | None
_Of: TypeAlias = Case | tuple[str, list[str]]
_Given: TypeAlias = str | tuple[str, list[tuple[str, _Array]]]

class _Part(TypedDict):
    shard: tuple[int, int] | None
    out: str | None
    resume: bool
    restart: bool

@final
class Case:
    @staticmethod
    def load(path: str) -> Case: ...
    @staticmethod
    def parse(text: str, name: str, settings: list[str]) -> Case: ...
    def with_settings(self, settings: list[str]) -> Case: ...
    @property
    def name(self) -> str: ...
    @property
    def path(self) -> str: ...
    @property
    def title(self) -> str: ...
    @property
    def text(self) -> str: ...
    @property
    def written(self) -> str: ...
    def value(self, key: str) -> str | None: ...
    @property
    def settings(self) -> list[str]: ...
    @property
    def stages(self) -> list[str]: ...
    def findings(self) -> str: ...
    def solve(self, progress: _Progress) -> tuple[Solution, _Raised]: ...

@final
class Solution:
    @property
    def complete(self) -> bool: ...
    @property
    def wall_time(self) -> float: ...
    def stages(self) -> list[tuple[str, str, str, bool, int, int]]: ...
    def frame(self, stage: int, frame: int) -> tuple[float, float, list[_Column], list[_Column]]: ...
    def table(self, stage: int, file: str) -> list[_Column] | None: ...
    def picture(self, stage: int, file: str) -> _Picture | None: ...
    def summary(self) -> str: ...
    def told(self) -> str: ...
    def verdict(self) -> tuple[str, str, str]: ...
    def findings(self) -> str: ...
    def numbers(self) -> list[tuple[str, str, float, str, float | None, str, str]]: ...
    def verify(self, quick: bool, progress: _Progress) -> tuple[Solution, _Raised]: ...
    def told_of_bars(self) -> list[str]: ...
    def comparisons(self) -> list[tuple[str, str, str, bool, list[_Column]]]: ...
    def write(self, folder: str) -> list[str]: ...

def compare(
    cases: list[tuple[Case, list[str]]], measured: list[_Given], threads: int | None, progress: _Progress
) -> tuple[_Told, list[_NumberOfRuns], list[Solution], _Raised]: ...
def fit_case(
    of: _Of, ranges: list[str], to: list[_Given], threads: int | None, progress: _Progress
) -> tuple[_Told, Case, _Raised]: ...
def fit_law(
    tests: list[_Given], laws: tuple[_Text, _Text], reduced: list[_Text], rate: list[float], direction: list[float]
) -> tuple[_Told, str]: ...
def from_drawing(
    path: str, layers: list[str], how: list[_Text], sizes: list[_Text]
) -> tuple[Case, list[str], _Picture]: ...
def optimise(
    case: Case,
    extreme: tuple[list[str], str, bool, _Text],
    error_bars: bool,
    threads: int | None,
    progress: _Progress,
) -> _Searched: ...
def merge(shards: list[str], out: str) -> int: ...
def scatter(
    of: _Of,
    vary: list[str],
    correlate: list[str],
    size: tuple[int | None, int | None, bool],
    name: str,
    part: _Part,
    threads: int | None,
    progress: _Progress,
) -> tuple[tuple[_Told, _Band | None, _Band | None] | None, _Table, _Raised]: ...
def search(
    case: Case,
    limit: tuple[list[str], _Text, bool | None, _Text, _Text, _Text],
    error_bars: bool,
    threads: int | None,
    progress: _Progress,
) -> _Searched: ...
def sweep(
    of: _Of,
    axes: list[str],
    one_at_a_time: bool,
    error_bars: bool | None,
    part: _Part,
    threads: int | None,
    progress: _Progress,
) -> tuple[list[int] | None, _Told | None, _Table, _Raised]: ...
def fill(name: str, given: list[tuple[str, str]]) -> str: ...
def templates() -> list[tuple[str, str, list[tuple[str, str, str]]]]: ...
