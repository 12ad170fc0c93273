"""Sections of stamping dies: axisymmetric and plane-strain sheet forming in well under a second.

>>> import stampflow as sf
>>> solution = sf.Case.load("cup.toml").with_(**{"tools.punch.friction": 0.1}).solve()
>>> solution.load_travel["punch_force_N"]  # a numpy array

Lengths in mm, forces in N (in plane strain per mm of depth, or of the whole part if the depth is given), stresses in MPa,
times in s, work in J, temperatures in °C. Names of columns and numbers end with the unit. Values of keys carry their unit, as
in case files: ``"0.9 mm"``.
"""

from ._native import __version__
from .case import Case, laws, materials, new, templates
from .columns import Columns, Named
from .errors import CaseError, CompareError, DrawingError, Error, Interrupted, StudyError
from .picture import Picture, Plots
from .solution import Finding, Frame, Number, Solution, Stage, Verdict
from .study import Study, compare, fit, scatter, search, sweep
from .trace import Iterate, IterationHistory, Trace

__all__ = [
    "Case",
    "CaseError",
    "Columns",
    "CompareError",
    "DrawingError",
    "Error",
    "Finding",
    "Frame",
    "Interrupted",
    "Iterate",
    "IterationHistory",
    "Named",
    "Number",
    "Picture",
    "Plots",
    "Solution",
    "Stage",
    "Study",
    "StudyError",
    "Trace",
    "Verdict",
    "__version__",
    "compare",
    "fit",
    "laws",
    "materials",
    "new",
    "scatter",
    "search",
    "sweep",
    "templates",
]


def __dir__() -> list[str]:
    return list(__all__)
