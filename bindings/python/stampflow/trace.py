"""One step of a run, iteration by iteration."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from .columns import Columns, Named

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray


class Iterate:
    """Sheet and forces after one iteration. Forces are those of the whole part."""

    def __init__(self, nodes: Sequence[Any], elements: Sequence[Any], contacts: Sequence[Any]) -> None:
        #: Nodes: ``r_mm``, ``z_mm``, ``theta`` [rad], and the force out of balance ``imbalance_r_N``, ``imbalance_z_N``.
        self.nodes = Columns(nodes)
        #: Elements at the thickness point that strains most: ``strain_increment``, ``strain_equivalent``,
        #: ``yield_stress_MPa``, ``stress_meridional_MPa``, ``stress_hoop_MPa``, ``viscosity_MPa_s`` (flow law), and
        #: ``cut_off``, 1 where the element strains by less than ten cut-offs.
        self.elements = Columns(elements)
        #: Points under a tool's pressure: ``r_mm``, ``z_mm``, ``force_r_N``, ``force_z_N``, and ``sticks``, 1 or 0.
        self.contacts = Columns(contacts)


class IterationHistory:
    """Iterations of a step with one matrix. A try that fails is followed by another one from another start."""

    def __init__(
        self, matrix: str, converged: bool, order: float | None, rows: Sequence[Any], starts: list[str], iterates: list[Any]
    ) -> None:
        #: ``primal_dual``, ``newton`` or ``secant``.
        self.matrix = matrix
        #: Whether the step came to equilibrium.
        self.converged = converged
        #: Order of convergence at the end of the last try; None if it is not clear.
        self.order = order
        #: Every iteration of all tries: ``iteration``, ``velocity_norm``, ``residual_norm``, ``cut``, ``contacts`` …
        self.iterations = Columns(rows)
        #: Start of the try of each row of ``iterations``: ``predictor``, ``secant``, ``softened`` …
        self.starts = tuple(starts)
        self._begin = int((self.iterations["iteration"] == 0).nonzero()[0][-1])
        #: Sheet and forces of each iteration of the last try, from iteration 0.
        self.iterates = tuple(Iterate(*parts) for parts in iterates[self._begin :])

    @property
    def velocity(self) -> NDArray[np.float64]:
        """Relative velocity increment of each iteration of the last try; 0 of iteration 0, the start."""
        return self.iterations["velocity_norm"][self._begin :]

    @property
    def residual(self) -> NDArray[np.float64]:
        """Relative residual of each iteration of the last try, from iteration 0."""
        return self.iterations["residual_norm"][self._begin :]

    def __repr__(self) -> str:
        end = "converged" if self.converged else "not converged"
        return f"<IterationHistory: {self.matrix}, {end}, {len(self.iterates) - 1} iterations>"


class Trace(Named[IterationHistory]):
    """A step repeated from the same state: histories by matrix, ``trace["newton"]``."""

    def __init__(self, stage: int, step: int, travel: float, duration: float, tolerance: float, histories: list[Any]) -> None:
        super().__init__("matrix", {parts[0]: IterationHistory(*parts) for parts in histories})
        #: Number of the stage and of the step in it, from 1.
        self.stage, self.step = stage, step
        #: Punch travel at the end of the step [mm].
        self.travel = travel
        #: Duration of the step [s].
        self.duration = duration
        #: Accepted norm of the step.
        self.tolerance = tolerance
