"""The sheet at one instant."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from .columns import Columns

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from ._native import _Column


class Frame:
    """The sheet at one instant: arrays over its elements, from the axis or symmetry plane outward."""

    def __init__(self, time: float, travel: float, elements: Sequence[_Column], nodes: Sequence[_Column]) -> None:
        #: Time [s].
        self.time = time
        #: Punch travel [mm].
        self.travel = travel
        #: All that is known of the elements, by names with units.
        self.elements = Columns(elements)
        #: The mid-surface at the nodes: ``r_mm``, ``z_mm``, rotation ``theta`` [rad], ``thickness_mm`` that contact sees.
        self.nodes = Columns(nodes)

    def __repr__(self) -> str:
        return f"<Frame at {self.travel:g} mm, {self.time:g} s: {len(self.s0)} elements>"

    @property
    def s0(self) -> NDArray[np.float64]:
        """Initial distance from the axis or symmetry plane [mm]."""
        return self.elements["s0_mm"]

    @property
    def r(self) -> NDArray[np.float64]:
        """Distance from the axis or symmetry plane [mm]."""
        return self.elements["r_mm"]

    @property
    def z(self) -> NDArray[np.float64]:
        """Height along the punch travel [mm]."""
        return self.elements["z_mm"]

    @property
    def thickness(self) -> NDArray[np.float64]:
        """Thickness [mm]."""
        return self.elements["thickness_mm"]

    @property
    def strain_meridional(self) -> NDArray[np.float64]:
        """Logarithmic mid-surface strain along the section [–]."""
        return self.elements["strain_meridional"]

    @property
    def strain_hoop(self) -> NDArray[np.float64]:
        """Logarithmic mid-surface strain across the section [–]."""
        return self.elements["strain_hoop"]

    @property
    def strain_thickness(self) -> NDArray[np.float64]:
        """ln(t/t₀) [–]."""
        return self.elements["strain_thickness"]

    @property
    def strain_equivalent(self) -> NDArray[np.float64]:
        """Equivalent plastic strain, mean over the thickness [–]."""
        return self.elements["strain_equivalent"]

    @property
    def stress_meridional(self) -> NDArray[np.float64]:
        """Cauchy stress along the section, mean over the thickness [MPa]."""
        return self.elements["stress_meridional_MPa"]

    @property
    def stress_hoop(self) -> NDArray[np.float64]:
        """Cauchy stress across the section, mean over the thickness [MPa]."""
        return self.elements["stress_hoop_MPa"]

    @property
    def temperature(self) -> NDArray[np.float64]:
        """Temperature [°C]; a KeyError where the case gives none."""
        return self.elements["temperature_C"]

    @property
    def porosity(self) -> NDArray[np.float64]:
        """Volume of voids over that of the sheet [–]; a KeyError of a sheet without voids."""
        return self.elements["porosity"]
