"""Sections of stamping dies: axisymmetric and plane-strain sheet forming in well under a second.

>>> import stampflow as sf
>>> solution = sf.Case.load("cup.toml").with_(**{"tools.punch.friction": 0.1}).solve()
>>> solution.load_travel["punch_force_N"]  # a numpy array

Lengths in mm, forces in N (in plane strain per mm of depth, or in all where the depth is given), stresses in MPa, times in s,
work in J, temperatures in °C; names of columns and numbers end with the unit. What is given has its unit with it, as in case
files: ``"0.9 mm"``.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

from ._native import __version__
from .case import Case
from .columns import Columns
from .compare import Compared, ComparedNumber, Misfit, compare
from .comparison import Comparison
from .errors import CaseError, CompareError, DrawingError, Error, Interrupted, StudyError
from .finding import Finding
from .fit import FittedCase, FittedCurve, FittedLaw, FittedLaws, Parameter, TensionTest, fit
from .frame import Frame
from .number import Number
from .picture import Picture
from .plots import Plots
from .scatter import Band, Chance, Estimate, Influence, Scatter, Sobol, Spread, scatter
from .search import Best, Search, search
from .solution import Solution
from .solved_stage import SolvedStage
from .sweep import Sweep, merge, sweep
from .templates import new, templates

__all__ = [
    "Band",
    "Best",
    "Case",
    "CaseError",
    "Chance",
    "Columns",
    "CompareError",
    "Compared",
    "ComparedNumber",
    "Comparison",
    "DrawingError",
    "Error",
    "Estimate",
    "Finding",
    "FittedCase",
    "FittedCurve",
    "FittedLaw",
    "FittedLaws",
    "Frame",
    "Influence",
    "Interrupted",
    "Misfit",
    "Number",
    "Parameter",
    "Picture",
    "Plots",
    "Scatter",
    "Search",
    "Sobol",
    "Solution",
    "SolvedStage",
    "Spread",
    "StudyError",
    "Sweep",
    "TensionTest",
    "__version__",
    "compare",
    "fit",
    "merge",
    "new",
    "scatter",
    "search",
    "sweep",
    "templates",
]

if TYPE_CHECKING:
    from .parts import *


def __getattr__(name: str) -> Any:
    # The keyword dataclasses are many: whoever reads cases from files does not wait for them.
    parts = import_module(".parts", __name__)
    if name in parts.__all__:
        return getattr(parts, name)
    raise AttributeError(f"module {__name__} has no attribute {name}")


def __dir__() -> list[str]:
    return sorted([*globals(), *import_module(".parts", __name__).__all__])
