"""The pictures of a stage."""

from __future__ import annotations

from .picture import Picture
from .plots import Plots


class StagePlots(Plots):
    """The pictures of a stage, each a method; one that has nothing to draw is a ValueError that says so."""

    def part(self) -> Picture:
        """The part coloured by thinning, and its thinnest place."""
        return self._picture("part")

    def shapes(self) -> Picture:
        """The section over the travel, coloured by thinning, and the tools where they were then."""
        return self._picture("shapes")

    def load_travel(self) -> Picture:
        """Forces [N, or N/mm of depth] over the punch travel [mm]."""
        return self._picture("load_travel")

    def thickness(self) -> Picture:
        """Thickness [mm] over the blank at every kept frame, and over the part."""
        return self._picture("thickness")

    def strains(self) -> Picture:
        """Strains [–] over the blank at the last frame."""
        return self._picture("strains")

    def forming_limit(self) -> Picture:
        """How near every place comes to the forming limit."""
        return self._picture("forming_limit")

    def springback(self) -> Picture:
        """The section before and after release."""
        return self._picture("springback")

    def residual_stress(self) -> Picture:
        """Residual stress [MPa] through the thickness."""
        return self._picture("residual_stress")

    def pressure_cycle(self) -> Picture:
        """Gas pressure [MPa], strain rate [1/s] and height of the dome [mm] over time [s], where a rate is held."""
        return self._picture("pressure_cycle")

    def temperature(self) -> Picture:
        """Temperature [°C] over the blank, where it is given."""
        return self._picture("temperature")

    def porosity(self) -> Picture:
        """Porosity [–] over the blank, of a sheet with voids."""
        return self._picture("porosity")
