"""The tables of case files as keyword dataclasses, each with the words of the case-file reference.

Quantities are texts with units, ``"0.9 mm"``; plain numbers are only for plain numbers. What is not given is not written.
``Model(...).case()`` is a case, with the checks and messages of one that was read from a file.

Written by ``tools/parts.py`` from ``stampflow schema``.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import ClassVar, Literal, TypeAlias

from .part import Part, Whole

__all__ = [
    "Anisotropy",
    "Arrhenius",
    "BackStress",
    "Bead",
    "Blank",
    "Branch",
    "Coalescence",
    "Compare",
    "ComparedQuantity",
    "ContactMethod",
    "CowperSymonds",
    "Crowned",
    "Crystal",
    "Die",
    "Directions",
    "Edge",
    "Exponential",
    "Extrapolation",
    "FirstStage",
    "Flat",
    "FormingLimit",
    "Friction",
    "Gas",
    "GasFace",
    "Geometry",
    "Grading",
    "Gtn",
    "Hardening",
    "Heat",
    "Hemispherical",
    "HockettSherby",
    "Holder",
    "Hollomon",
    "HosfordLaw",
    "InitialTemperature",
    "Isotherm",
    "Isotherms",
    "Iteration",
    "JohnsonCook",
    "KeelerBrazier",
    "Ludwik",
    "MarciniakKuczynski",
    "Material",
    "Melting",
    "Mixed",
    "Mode",
    "Model",
    "Norm",
    "Nucleation",
    "Output",
    "PiecewisePower",
    "PowerRate",
    "Press",
    "PressureDependent",
    "ProfileStep",
    "Punch",
    "Rate",
    "ReleaseStiffness",
    "Ring",
    "Role",
    "Section",
    "SectionTable",
    "Sides",
    "Solver",
    "Spring",
    "Springback",
    "Stage",
    "StageDie",
    "StageHolder",
    "StagePunch",
    "Stop",
    "Strain",
    "Stribeck",
    "Swift",
    "Table",
    "Theory",
    "ThermalLaw",
    "TitleBlock",
    "ToolHeat",
    "Tools",
    "Tresca",
    "Turn",
    "Voce",
    "YieldCondition",
    "Zones",
]


@dataclass(frozen=True, kw_only=True)
class Model(Whole):
    """A forming case: blank, material, tools.

    Attributes:
        blank: The flat sheet.
        compare: Published curves and values to hold the result against.
        forming_limit: The forming limit that the strains are held against; none when not given.
        friction: Friction by the face of the sheet, for tools that do not name their own, and where all of it comes
            from.
        gas: Gas or oil that presses on the sheet.
        geometry: Axisymmetric or plane strain. Such as "axisymmetric".
        heat: Temperature of the sheet; 20 °C throughout when not given.
        material: What the sheet is made of.
        notes: Shown wherever results are shown; an assumption begins with "declared: ".
        output: What is kept of the run.
        press: What the press can give, for the verdict; the run does not depend on it.
        report: The title block of reports.
        solver: How the problem is solved.
        springback: The part's tolerances on spring-back, for the verdict; not judged when not given.
        stage: The first stage, where there are several.
        stages: Operations after the first one, on the same sheet.
        stop: What ends the run before its full travel.
        title: Shown above plots and reports. Such as "Steel cup, 60 mm punch".
        tools: The rigid tools.
    """

    blank: Blank
    geometry: Geometry
    material: Material
    title: str
    compare: Sequence[Compare] | None = None
    forming_limit: FormingLimit | None = None
    friction: Sides | None = None
    gas: Gas | None = None
    heat: Heat | None = None
    notes: Sequence[str] | None = None
    output: Output | None = None
    press: Press | None = None
    report: TitleBlock | None = None
    solver: Solver | None = None
    springback: Springback | None = None
    stage: FirstStage | None = None
    stages: Sequence[Stage] | None = None
    stop: Stop | None = None
    tools: Tools | None = None


@dataclass(frozen=True, kw_only=True)
class Arrhenius(Part):
    """exp(exponent activation/R (1/T − 1/reference)): with a power of the strain rate of the same exponent the stress
    depends on the Zener-Hollomon parameter Z = ε̄̇ exp(Q/RT) alone.

    Valid for hot metal, above half its absolute melting point.
    Source: in common use; C. Zener, J. H. Hollomon, J. Appl. Phys. 15 (1944) 22–32 (not read).

    Attributes:
        activation: Activation energy Q [N mm/mol]. Such as "150 kJ/mol".
        exponent: m, 0 to 1. Such as 0.1.
        reference: Temperature at which the hardening law was measured [K]. Such as "420 °C".
    """

    _law: ClassVar[str | None] = "arrhenius"

    activation: str
    exponent: float
    reference: str


@dataclass(frozen=True, kw_only=True)
class BackStress(Part):
    """A back-stress.

    Attributes:
        modulus: C: its first slope over the plastic strain [MPa]. Such as "2500 MPa".
        recall: γ, its dynamic recovery: it comes to C/γ; 0 when not given, which is Prager's linear hardening. Such
            as 30.
    """

    modulus: str
    recall: float | None = None


@dataclass(frozen=True, kw_only=True)
class Bead(Part):
    """A draw bead as a line restraint: it holds the sheet back while the sheet passes it.

    Attributes:
        at: Distance of its line from the axis or symmetry plane. Such as "70 mm".
        closing: Closing force per length of the line, taken from the holder's force; none when not given. Such as
            "150 N/mm".
        diameter: Instead of `at`, of a round part: its diameter, twice as much.
        restraining: Restraining force per length of the line, of which a plane section has one on each side. Such
            as "100 N/mm".
    """

    restraining: str
    at: str | None = None
    closing: str | None = None
    diameter: str | None = None


@dataclass(frozen=True, kw_only=True)
class Blank(Part):
    """The flat sheet before forming.

    Attributes:
        depth: Length of the part across the section (plane strain): forces and works are then of the whole part, in
            N and J. When
            not given they are of the whole section per mm of depth. Such as "800 mm".
        diameter: Instead of `radius`, of a round part: its diameter, twice as much.
        edge: How the outer edge is held.
        elements: Number of elements from the axis or symmetry plane to the edge, 2 to 2000. Such as 100.
        grading: How element sizes are spread.
        half_length: Length from the symmetry plane to the edge (plane strain). Such as "420 mm".
        layers: Integration points through the thickness of elements that bend, 3 to 101. When not given: 5 by the
            flow law, 9 in
            plane strain, where bending is most of the load; 15 for an elasto-viscoplastic sheet (with fewer the
            moment grows in
            jumps), 25 where a stage releases the sheet. Such as 5.
        radius: Radius of the blank (axisymmetric). Such as "55 mm".
        theory: Shell theory of the sheet.
        thickness: Initial thickness, 0.001 to 50 mm. Such as "0.9 mm".
    """

    thickness: str
    depth: str | None = None
    diameter: str | None = None
    edge: Edge | None = None
    elements: int | None = None
    grading: Grading | None = None
    half_length: str | None = None
    layers: int | None = None
    radius: str | None = None
    theory: Theory | None = None


@dataclass(frozen=True, kw_only=True)
class Branch(Part):
    """One branch; it must meet the next one.

    Attributes:
        initial: Yield stress σ₀ of the branch at ε = 0 [MPa]. Such as "5.4 tonf_uk/in^2".
        k: K [MPa]. Such as "27.8 tonf_uk/in^2".
        n: Exponent, above 0 and up to 1. Such as 0.504.
        up_to: Strain where the branch ends; left out in the last one. Such as 0.36.
    """

    initial: str
    k: str
    n: float
    up_to: float | None = None


@dataclass(frozen=True, kw_only=True)
class Coalescence(Part):
    """Faster loss of strength from a critical porosity on.

    Attributes:
        critical: f_c. Such as 0.15.
        fracture: f_F, at which the sheet bears nothing any more: the run ends there. Such as 0.25.
    """

    critical: float
    fracture: float


@dataclass(frozen=True, kw_only=True)
class Compare(Part):
    """One comparison with a reference: a curve (`x`, `y`, `tolerance`) or a band (`band`), as the quantity asks for.

    Attributes:
        band: Columns of the CSV whose values, all rows of them, span the band. Such as ["diameter_x_mm",
            "diameter_y_mm"].
        demonstration: Whether the difference is shown without failing a validation, because the input is not that
            of the reference.
        error: Column of the CSV with each row's error of measurement, which widens the band. Such as "error_mm".
        optional: Whether the file may be missing: drop the CSV into `reference_data` to see the overlay.
        quantity: What is compared. Such as "punch_force".
        range: Part of the curve that is compared, in units of the x column; all of it when not given.
        reason: Why that tolerance, or where a difference comes from. Such as "reading error of the published
            graph".
        reference: CSV file, looked for in `reference_data` beside the folder of the case, then beside the case.
            Such as "woo_load_travel.csv".
        tolerance: Accepted relative difference from a curve. Such as "5 %".
        x: Column of the CSV along which to compare with a curve. Such as "travel_mm".
        y: Column of the CSV that is compared with a curve. Forces of a plane section are of both halves: per mm of
            depth, N_per_mm,
            or in all where blank.depth is given; a published curve of one half is doubled in the file, with a word
            on it. Such as "punch_force_N".
    """

    quantity: ComparedQuantity
    reason: str
    reference: str
    band: Sequence[str] | None = None
    demonstration: bool | None = None
    error: str | None = None
    optional: bool | None = None
    range: Sequence[float] | None = None
    tolerance: str | None = None
    x: str | None = None
    y: str | None = None


@dataclass(frozen=True, kw_only=True)
class CowperSymonds(Part):
    """1 + (rate/C)^(1/p), which is Perzyna's law ε̄̇ = C ⟨σ̄/σ_s − 1⟩^p with the fluidity C.

    Valid for the strong rate dependence of mild steel at press speeds and beyond.
    Source: in common use; G. R. Cowper, P. S. Symonds, Brown University Tech. Rep. 28 (1957), P. Perzyna, Adv.
    Appl. Mech.
    9 (1966) 243–377 (not read).

    Attributes:
        exponent: p. Such as 5.0.
        rate: C [1/s]. Such as "40 /s".
    """

    _law: ClassVar[str | None] = "cowper_symonds"

    exponent: float
    rate: str


@dataclass(frozen=True, kw_only=True)
class Crowned(Part):
    """Gently curved face, corner and straight wall.

    Attributes:
        diameter: Instead of `radius`, of a round part: its diameter, twice as much.
        face: Radius of curvature of the face, larger than the punch's own radius. Such as "2800 mm".
        half_width: Half width between the walls (plane strain). Such as "330 mm".
        nose: Radius of the corner. Such as "10 mm".
        radius: Radius of the wall (axisymmetric). Such as "330 mm".
    """

    face: str
    nose: str
    diameter: str | None = None
    half_width: str | None = None
    radius: str | None = None


@dataclass(frozen=True, kw_only=True)
class Die(Part):
    """The die stands still above the sheet: `throat` and `shoulder`, or a `profile`.

    Attributes:
        friction: Coulomb's coefficient of friction, 0 to 1, or another law; that of its side of the sheet when not
            given. Such as 0.08.
        profile: A section of one's own, from outside inward.
        shoulder: Radius of the corner over which the sheet is drawn. Such as "6 mm".
        throat: Radius of the opening (plane strain: half width). Such as "31.25 mm".
        throat_diameter: Instead of `throat`, of a round part: its diameter, twice as much.
    """

    friction: Friction | None = None
    profile: Section | None = None
    shoulder: str | None = None
    throat: str | None = None
    throat_diameter: str | None = None


@dataclass(frozen=True, kw_only=True)
class Directions(Part):
    """r at 0°, 45° and 90° to the rolling direction; r̄ = (r0 + 2 r45 + r90)/4.

    Attributes:
        r0: Along the rolling direction. Such as 0.525.
        r45: At 45°. Such as 0.248.
        r90: Across. Such as 0.429.
    """

    r0: float
    r45: float
    r90: float


@dataclass(frozen=True, kw_only=True)
class Exponential(Part):
    """exp(−coefficient (T − reference)).

    Valid in the range of temperatures that the coefficient was fitted to: 0.001 to 0.005 /K in warm forming.
    Source: in common use for warm forming.

    Attributes:
        coefficient: Share of the strength lost per kelvin [1/K]. Such as "0.003 /K".
        reference: Temperature at which the hardening law was measured [K]. Such as "20 °C".
    """

    _law: ClassVar[str | None] = "exponential"

    coefficient: str
    reference: str


@dataclass(frozen=True, kw_only=True)
class FirstStage(Part):
    """The first stage, which is what the rest of the file describes.

    Attributes:
        name: Names its folder where there are several stages; "forming" when not given. Such as "draw".
    """

    name: str | None = None


@dataclass(frozen=True, kw_only=True)
class Flat(Part):
    """Flat face, corner and straight wall.

    Attributes:
        diameter: Instead of `radius`, of a round part: its diameter, twice as much.
        half_width: Half width between the walls (plane strain). Such as "30 mm".
        nose: Radius of the corner. Such as "6 mm".
        radius: Radius of the wall (axisymmetric). Such as "30 mm".
    """

    nose: str
    diameter: str | None = None
    half_width: str | None = None
    radius: str | None = None


@dataclass(frozen=True, kw_only=True)
class FormingLimit(Part):
    """A forming limit curve, exactly one: `points`, `measured`, `keeler_brazier`, `hill`, `swift` or
    `marciniak_kuczynski`.

    Attributes:
        hill: Hill's localised necking on the left, Swift's diffuse necking on the right: from the hardening law and
            r̄. Such as true.
        keeler_brazier: The empirical curve of steels; `{}` takes n from the hardening law.
        marciniak_kuczynski: A groove in the sheet: from the hardening law, the rate law and r̄.
        measured: The measured points of the library's sheet that `[material] name` names, where it has some. Such
            as true.
        n: Hardening exponent of `keeler_brazier`, `hill` or `swift` in place of the hardening law's own: without it
            `keeler_brazier` takes the uniform strain at the load maximum of the law, the others the law itself.
            Such as 0.21.
        points: Pairs of minor and major strain from left to right, plain numbers: `[[-0.2, 0.5], [0, 0.3], [0.3,
            0.45]]`.

            Valid for the sheet and the thickness it was measured on, and for straight strain paths. Source: the
            case's own.
        strain: How `points` are measured: needed with them. Such as "logarithmic".
        swift: Swift's diffuse necking on both sides: from the hardening law and r̄. Such as true.
    """

    hill: bool | None = None
    keeler_brazier: KeelerBrazier | None = None
    marciniak_kuczynski: MarciniakKuczynski | None = None
    measured: bool | None = None
    n: float | None = None
    points: Sequence[Sequence[float]] | None = None
    strain: Strain | None = None
    swift: bool | None = None


@dataclass(frozen=True, kw_only=True)
class Gas(Part):
    """Gas or oil pressure; alone it bulges the blank, against a punch it forms the sheet over it.

    Attributes:
        duration: How long the run takes when there is no punch. Such as "10 s".
        lower: On the punch's side: pushes along the punch travel.
        upper: On the die's side: pushes against the punch travel.
    """

    duration: str | None = None
    lower: GasFace | None = None
    upper: GasFace | None = None


@dataclass(frozen=True, kw_only=True)
class GasFace(Part):
    """Pressure on one face.

    Attributes:
        max_pressure: With a strain rate: the largest pressure that the press gives; where the rate would ask for
            more, the pressure stays
            here and the rate falls below its target. Such as "2 MPa".
        max_pressure_rate: With a strain rate: the fastest rise of the pressure that the press gives. Such as "0.01
            MPa/s".
        norm: Norm of the strain rate over the sheet's volume, 1 to 50: 1 is the mean, a large one the fastest
            place; 10 when not
            given. Such as 10.0.
        pressure: The pressure, or its history over time: [["0 s", "0 MPa"], ["10 s", "5 MPa"]]. One pressure and no
            punch: it is
            raised evenly over the duration, for a flat sheet cannot bear it at once. Such as "5 MPa".
        strain_rate: Superplastic forming, instead of a pressure: the strain rate that the pressure holds in every
            step. Such as "0.001 /s".
        within: Distance of the seal from the axis or symmetry plane; when not given, the holder's inner edge (lower
            face) or the
            end of the die's shoulder (upper face), or else the whole blank. Such as "50 mm".
    """

    max_pressure: str | None = None
    max_pressure_rate: str | None = None
    norm: float | None = None
    pressure: str | Sequence[Sequence[str]] | None = None
    strain_rate: str | None = None
    within: str | None = None


@dataclass(frozen=True, kw_only=True)
class Gtn(Part):
    """σ̄²/σ_y² + 2 q1 f* cosh(3 q2 p/2σ_y) = 1 + q3 f*² with the mean stress p: Gurson's yield condition.

    Valid for small, spread-out voids under tension; without shear it says little about compression.
    Source: in common use; A. L. Gurson (1977), V. Tvergaard, A. Needleman (1984), nucleation C. C. Chu, A.
    Needleman
    (1980) (not read).

    Attributes:
        coalescence: Voids that join; they keep apart when not given.
        initial: Initial porosity f₀, below 0.3. Such as 0.01.
        nucleation: Voids that open at particles as the sheet strains; none when not given.
        q1: 1.5 when not given (Tvergaard). Such as 1.5.
        q2: 1 when not given. Such as 1.0.
        q3: q1² when not given, which 0 stands for until [`Gtn::prepare`]. Such as 2.25.
    """

    initial: float
    coalescence: Coalescence | None = None
    nucleation: Nucleation | None = None
    q1: float | None = None
    q2: float | None = None
    q3: float | None = None


@dataclass(frozen=True, kw_only=True)
class Heat(Part):
    """Temperature of the sheet. Without density and specific heat it stays as it is given.

    Attributes:
        conductivity: Along the sheet; none when not given. Such as "130 W/m/K".
        density: Of the sheet; with the specific heat, its temperature changes. Such as "2700 kg/m^3".
        die: As `punch`, of the die.
        holder: As `punch`, of the holder.
        initial: Of the flat sheet: one temperature, one for the part under the punch and one for the flange, or a
            CSV file.
        plastic_share: Share of the plastic work that becomes heat; 0.9 when not given. Such as 0.9.
        punch: A tool that heats or cools what lies on it.
        specific_heat: Of the sheet, per mass. Such as "900 J/kg/K".
    """

    initial: InitialTemperature
    conductivity: str | None = None
    density: str | None = None
    die: ToolHeat | None = None
    holder: ToolHeat | None = None
    plastic_share: float | None = None
    punch: ToolHeat | None = None
    specific_heat: str | None = None


@dataclass(frozen=True, kw_only=True)
class Hemispherical(Part):
    """Spherical nose (plane strain: cylindrical).

    Attributes:
        diameter: Instead of `radius`, of a round part: its diameter, twice as much.
        radius: Radius of the nose and of the wall. Such as "25.4 mm".
    """

    diameter: str | None = None
    radius: str | None = None


@dataclass(frozen=True, kw_only=True)
class HockettSherby(Part):
    """σ = saturation − (saturation − initial) exp(−rate ε^exponent).

    Valid for metals whose hardening comes to an end at large strains, such as aluminium and deep-drawing steel;
    just beyond
    yield its slope is infinite for an exponent below 1, a chord over 1e-6 takes its place.
    Source: J. E. Hockett, O. D. Sherby, J. Mech. Phys. Solids 23 (1975) 87–98 (not read; the form is in common
    use).

    Attributes:
        exponent: p, above 0 and up to 1. Such as 0.75.
        initial: σ₀ at the start of yield [MPa]. Such as "130 MPa".
        rate: N. Such as 5.0.
        saturation: σ_s at large strains [MPa]. Such as "390 MPa".
    """

    _law: ClassVar[str | None] = "hockett_sherby"

    exponent: float
    initial: str
    rate: float
    saturation: str


@dataclass(frozen=True, kw_only=True)
class Holder(Part):
    """The blank holder presses the sheet against the die: a flat ring from its inner radius outward, or a `profile`.

    Attributes:
        force: Force of the whole holder ("80 kN"); in plane strain on both sides of the symmetry plane together,
            per mm of depth
            ("2600 N/mm"), or in all where blank.depth is given. Or its history over the punch travel: [["0 mm", "40
            kN"],
            ["20 mm", "80 kN"]]. The holder's position follows. Such as "10 kN".
        friction: Coulomb's coefficient of friction, 0 to 1, or another law; that of the punch's side or of the die
            when not given. Such as 0.08.
        gap: Fixed distance between the faces of holder and die: distance blocks. Such as "1.1 mm".
        inner_diameter: Instead of `inner_radius`, of a round part: its diameter, twice as much.
        inner_half_width: Distance of its inner edge from the symmetry plane (plane strain). Such as "341 mm".
        inner_radius: Inner radius (axisymmetric). Such as "32 mm".
        pressure: Pressure times the initial area between holder and the die's flat: a force that stays. Such as
            "2.5 MPa".
        profile: A section of one's own, from inside outward. Where it and the die cannot both lie on the flat
            sheet, for a bead or a slope,
            the holder closes over the sheet before the punch comes.
        spring: Springs or a cushion: the force grows as the holder is pushed away from the die.
    """

    force: str | Sequence[Sequence[str]] | None = None
    friction: Friction | None = None
    gap: str | None = None
    inner_diameter: str | None = None
    inner_half_width: str | None = None
    inner_radius: str | None = None
    pressure: str | None = None
    profile: Section | None = None
    spring: Spring | None = None


@dataclass(frozen=True, kw_only=True)
class Hollomon(Part):
    """σ = k ε^n, started at the elastic line or at a declared offset strain.

    Valid beyond a strain of some per cent; at yield it says little.
    Source: J. H. Hollomon, Tensile deformation, Trans. AIME 162 (1945) 268–290.

    Attributes:
        k: K, the stress at a strain of 1 [MPa]. Such as "547 MPa".
        n: Hardening exponent, 0 to 1. Such as 0.18.
        offset: Offset strain; without it `young` must be given, and the law starts where it meets the elastic line.
            Such as 0.001.
    """

    _law: ClassVar[str | None] = "hollomon"

    k: str
    n: float
    offset: float | None = None


@dataclass(frozen=True, kw_only=True)
class HosfordLaw(Part):
    """(1 + r̄) σ_y^a = |σ_s|^a + |σ_θ|^a + r̄ |σ_s − σ_θ|^a.

    The crystals' own curve: flatter sides and sharper corners than Hill's, which is its a = 2. Valid for sheet that
    is alike in
    all its directions, without voids; the transverse shear is added quadratically, as Hill's condition has it.
    Source: W. F. Hosford, J. Appl. Mech. 39 (1972) 607–609; R. W. Logan, W. F. Hosford, Int. J. Mech. Sci. 22
    (1980) 419–430
    (not read; the form is in common use).

    Attributes:
        crystal: Lattice of the metal, which says a: 8 for fcc, 6 for bcc. Such as "fcc".
        exponent: a, 2 to 10, in the place of `crystal`. Such as 8.
    """

    _law: ClassVar[str | None] = "hosford"

    crystal: Crystal | None = None
    exponent: float | None = None


@dataclass(frozen=True, kw_only=True)
class Isotherm(Part):
    """One curve.

    Attributes:
        points: Pairs of strain and stress, the first at strain 0: `[[0, "90 MPa"], [0.1, "170 MPa"]]`.
        temperature: a temperature with its unit; solved in K Such as "150 °C".
    """

    points: Sequence[Sequence[float | str]]
    temperature: str


@dataclass(frozen=True, kw_only=True)
class Isotherms(Part):
    """Measured points at several temperatures, interpolated straight over the temperature.

    Valid between the coldest and the hottest curve; beyond them these are held.
    Source: each curve as `table`.

    Attributes:
        curves: At rising temperatures.
        extrapolation: What the curves do beyond their last point: a choice that has to be made. Such as "slope".
    """

    _law: ClassVar[str | None] = "isotherms"

    curves: Sequence[Isotherm]
    extrapolation: Extrapolation


@dataclass(frozen=True, kw_only=True)
class JohnsonCook(Part):
    """1 + C ln(rate/reference) above the reference rate, smoothly 1 below it.

    Valid above the reference rate, for a weak dependence.
    Source: in common use; G. R. Johnson, W. H. Cook, Proc. 7th Int. Symp. on Ballistics, The Hague (1983) 541–547
    (not
    read).

    Attributes:
        coefficient: C. Such as 0.015.
        reference: ε̇₀ [1/s]. Such as "0.001 /s".
    """

    _law: ClassVar[str | None] = "johnson_cook"

    coefficient: float
    reference: str


@dataclass(frozen=True, kw_only=True)
class KeelerBrazier(Part):
    """FLC₀ = (23.3 + 14.13 t/mm) n/0.21 percent (engineering) at plane strain; left ε₁ + ε₂ = const, right a slope of
    0.6.

    Valid for mild and conventional high-strength steel up to 3.1 mm, not for aluminium; n counts as 0.21 at most.
    Source: S. P. Keeler, W. G. Brazier, Micro Alloying 75 (1977) 517–530 (not read; as AHSS Insights and programs
    quote it).

    Attributes:
        thickness: Thickness that counts, 3.1 mm at most; that of the blank when not given [mm]. Such as "1 mm".
    """

    thickness: str | None = None


@dataclass(frozen=True, kw_only=True)
class Ludwik(Part):
    """σ = initial + k ε^n.

    Valid for metals with a marked yield stress; just beyond yield its slope is infinite, a chord over 1e-6 takes
    its place.
    Source: P. Ludwik, Elemente der technologischen Mechanik, Springer, Berlin (1909).

    Attributes:
        initial: Yield stress σ₀ [MPa]. Such as "150 MPa".
        k: K, the hardening at a strain of 1 [MPa]. Such as "400 MPa".
        n: Hardening exponent, above 0 and up to 1. Such as 0.5.
    """

    _law: ClassVar[str | None] = "ludwik"

    initial: str
    k: str
    n: float


@dataclass(frozen=True, kw_only=True)
class MarciniakKuczynski(Part):
    """A groove of `imperfection` times the sheet's thickness takes over.

    Valid for straight strain paths; by Hill's condition with r̄ below 1 it ends in plane strain: beyond it is too
    high.
    Source: Z. Marciniak, K. Kuczyński, Int. J. Mech. Sci. 9 (1967) 609–620 (not read; derived in the program).

    Attributes:
        imperfection: f₀, 0.9 to 0.9999: thickness of the groove over that around it; 0.995 when not given, an
            assumption. Such as 0.995.
        strain_rate: Strain rate of the sheet [1/s]; 1 /s when not given, an assumption. A power law of the rate
            does not feel it. Such as "1 /s".
    """

    imperfection: float | None = None
    strain_rate: str | None = None


@dataclass(frozen=True, kw_only=True)
class Material(Part):
    """The sheet's material, isotropic in its plane.

    Attributes:
        anisotropy: Normal anisotropy r̄, 0.1 to 10: width strain over thickness strain in tension, mean over the
            directions in the
            sheet; 1 when not given. Or r of three directions, `{ r0 = 0.525, r45 = 0.248, r90 = 0.429 }`, whose
            mean
            r̄ = (r0 + 2 r45 + r90)/4 is taken, and by which the ears to be expected are told.
            σ_y² = σ_s² − 2 r̄/(1 + r̄) σ_s σ_θ + σ_θ², unless `yield_condition` says otherwise.

            Valid for sheet that is alike in all its directions; it cannot show ears, and aluminium with r̄ below 1
            is stronger in
            equi-biaxial tension than it says: `yield_condition` has another curve for it. Source: R. Hill, Proc. R.
            Soc. London A 193 (1948) 281–297. Such as 1.6.
        fitted_up_to: Largest strain of the measurements that a formula of hardening is fitted to; a run that
            strains the sheet further says
            so. A table ends where it ends. Such as 0.22.
        hardening: Exactly one law, such as `[material.hardening.swift]`.
        kinematic: Back-stresses of an elasto-viscoplastic sheet, at most two; none when not given. The hardening
            law is then what is
            left of the yield stress without them.

            dα = C ξ/σ_R dε − γ α dε: valid for metal that is bent and bent back; it needs tests with reversed
            strain. Source:
            J. L. Chaboche, Int. J. Plasticity 2 (1986) 149–188 (not read; the form is in common use).
        mode: How the metal answers to strain; "flow" when not given. The others need `young` and `poisson`. Such as
            "elasto_viscoplastic".
        name: A sheet of the built-in library (`stampflow materials` lists them); what else is written here replaces
            what the
            library says. Such as "aa6016-t4".
        poisson: Poisson's ratio, below 0.5. Such as 0.3.
        rate: Strain-rate dependence; none when not given. The punch's `speed` then matters.
        softening: Dependence on the temperature; none when not given. `[heat]` says what the temperature is.
        source: Where the numbers come from: author and year, or how they were measured; left out where they are
            assumed. Such as "tension tests of this coil".
        voids: Microscopic voids; none when not given.
        yield_condition: The curve of the stresses at which the sheet yields; "hill48" when not given. Such as
            "hill48".
        young: Young's modulus; given together with `poisson`. Such as "210 GPa".
    """

    anisotropy: Anisotropy | None = None
    fitted_up_to: float | None = None
    hardening: Hardening | None = None
    kinematic: Sequence[BackStress] | None = None
    mode: Mode | None = None
    name: str | None = None
    poisson: float | None = None
    rate: Rate | None = None
    softening: ThermalLaw | None = None
    source: str | None = None
    voids: Gtn | None = None
    yield_condition: YieldCondition | None = None
    young: str | None = None


@dataclass(frozen=True, kw_only=True)
class Melting(Part):
    """1 − ((T − reference)/(melting − reference))^exponent; 1 below the reference.

    Valid up to some tenths of the way to the melting point; held at a thousandth just below it.
    Source: in common use; G. R. Johnson, W. H. Cook, Proc. 7th Int. Symp. on Ballistics, The Hague (1983) 541–547
    (not
    read).

    Attributes:
        exponent: Thermal exponent. Such as 1.0.
        melting: Melting point [K]. Such as "600 °C".
        reference: Temperature at which the hardening law was measured [K]. Such as "20 °C".
    """

    _law: ClassVar[str | None] = "johnson_cook"

    exponent: float
    melting: str
    reference: str


@dataclass(frozen=True, kw_only=True)
class Mixed(Part):
    """σ = weight σ_swift + (1 − weight) σ_voce.

    Valid where each of both was fitted to the same test: the weight says how far beyond its end hardening goes on.
    With an
    exponent below 1 the second is Hockett and Sherby's.
    Source: in common use for sheet; no first author is known.

    Attributes:
        swift: The law that hardens without end.
        voce: The law that comes to an end.
        weight: Share of Swift's law, 0 to 1. Such as 0.5.
    """

    _law: ClassVar[str | None] = "mixed"

    swift: Swift
    voce: Voce
    weight: float


@dataclass(frozen=True, kw_only=True)
class Nucleation(Part):
    """Strain-controlled nucleation, spread normally.

    Attributes:
        deviation: Standard deviation s_N. Such as 0.1.
        fraction: Porosity f_N that all particles make. Such as 0.04.
        strain: Mean strain ε_N. Such as 0.3.
    """

    deviation: float
    fraction: float
    strain: float


@dataclass(frozen=True, kw_only=True)
class Output(Part):
    """Which instants are kept: `frames` or `count`; the end of the travel always is.

    Attributes:
        count: Number of equally spaced instants, 1 to 1000; 4 when neither is given. Such as 4.
        frames: Punch travels at which the state is kept.
    """

    count: int | None = None
    frames: Sequence[str] | None = None


@dataclass(frozen=True, kw_only=True)
class PiecewisePower(Part):
    """σ = initial + k ε^n with other constants on each range of strain.

    Valid where the branches were fitted; they must meet within 0.5 %.
    Source: D. M. Woo, Int. J. Mech. Sci. 10 (1968) 83–94.

    Attributes:
        branches: In order of strain.
    """

    _law: ClassVar[str | None] = "piecewise_power"

    branches: Sequence[Branch]


@dataclass(frozen=True, kw_only=True)
class PowerRate(Part):
    """(rate/reference)^exponent; with a reference of 1/s on a Hollomon law the superplastic K ε^n ε̇^m.

    Valid over the two or three decades of the rate that m was measured in.
    Source: in common use; W. A. Backofen, I. R. Turner, D. H. Avery, Superplasticity in an Al-Zn alloy, Trans. ASM
    57
    (1964) 980–990 (not read).

    Attributes:
        exponent: m, 0 to 1. Such as 0.02.
        reference: Strain rate at which the hardening law was measured [1/s]. Such as "0.001 /s".
    """

    _law: ClassVar[str | None] = "power"

    exponent: float
    reference: str


@dataclass(frozen=True, kw_only=True)
class Press(Part):
    """What the press can give, as its data sheet says.

    Attributes:
        energy: Work of one stroke; in plane strain only where blank.depth is given. Such as "20 kJ".
        force: Largest force; in plane strain per mm of depth of the whole section, or in all where blank.depth is
            given. Such as "1000 kN".
    """

    energy: str | None = None
    force: str | None = None


@dataclass(frozen=True, kw_only=True)
class PressureDependent(Part):
    """Coefficient that falls with pressure: μ = coefficient (p/reference)^(exponent − 1).

    Source: in common use for lubricated sheet; I. Gil, J. Mendiguren, L. Galdos, E. Mugarra, E. Saenz de Argandoña,
    Tribology International 103 (2016) 266–273 (not read).

    Attributes:
        coefficient: At the reference pressure, 0 to 1. Such as 0.12.
        exponent: 0 to 1; 1 is Coulomb's law, 0 a friction stress that does not depend on the pressure. Such as 0.9.
        reference: Reference pressure [MPa]. Such as "5 MPa".
    """

    _law: ClassVar[str | None] = "pressure_dependent"

    coefficient: float
    exponent: float
    reference: str


@dataclass(frozen=True, kw_only=True)
class ProfileStep(Part):
    """One step of a drawn section: `from` first, then `to` for straight lines, `arc_to` with `center` and `turn` for
    arcs.

    Attributes:
        arc_to: End of an arc: [r, z].
        center: Centre of the arc: [r, z].
        from_: First point: [r, z].
        to: End of a straight line: [r, z].
        turn: Which way the arc turns as one goes along it. Such as "right".
    """

    arc_to: Sequence[str] | None = None
    center: Sequence[str] | None = None
    from_: Sequence[str] | None = None
    to: Sequence[str] | None = None
    turn: Turn | None = None


@dataclass(frozen=True, kw_only=True)
class Punch(Part):
    """The punch moves towards +z; exactly one of the shapes is given.

    Attributes:
        crowned: Gently curved face, corner and straight wall.
        flat: Flat face, corner and straight wall.
        friction: Coulomb's coefficient of friction, 0 to 1, or another law; that of its side of the sheet when not
            given. Such as 0.08.
        hemispherical: Spherical nose.
        motion: Instead of travel and speed: the travel over time, rising from 0 mm at 0 s, straight between its
            points; the last one is
            the whole travel. Such as [["0 s", "0 mm"], ["2 s", "10 mm"], ["4 s", "30 mm"]].
        profile: A section of one's own, from the axis outward.
        speed: Punch speed, 1 mm/s when not given; hardening without rate dependence does not feel it. Such as "1
            mm/s".
        travel: How far the punch goes from where it touches the flat sheet. Such as "25 mm".
    """

    crowned: Crowned | None = None
    flat: Flat | None = None
    friction: Friction | None = None
    hemispherical: Hemispherical | None = None
    motion: Sequence[Sequence[str]] | None = None
    profile: Section | None = None
    speed: str | None = None
    travel: str | None = None


@dataclass(frozen=True, kw_only=True)
class Ring(Part):
    """A ring of the wall of a cup that stands on its bottom.

    Attributes:
        from_: Height of its lower edge over the outside of the bottom. Such as "20 mm".
        height: Its height, from edge to edge. Such as "5 mm".
    """

    from_: str
    height: str


@dataclass(frozen=True, kw_only=True)
class SectionTable(Part):
    """`{ file, fillet }`, `{ offset_of, by, shoulder, closed_at }` or `{ mirror_of }`.

    Attributes:
        by: The gap between the two tools when they have closed: the sheet's thickness and the clearance. Such as
            "1.2 mm".
        closed_at: With `shoulder`: the punch's travel at which the gap is `by` everywhere, which is how deep the
            cavity is; the
            whole travel when not given. Without `shoulder` it follows from the die touching the flat sheet. Such as
            "25 mm".
        file: CSV file with points. Such as "die.csv".
        fillet: Fillet radius of all inner points of the file that have none of their own; "0 mm" keeps them sharp.
            Such as "5 mm".
        mirror_of: The tool on the other side of the flat sheet of which this one is the mirror image: a holder of
            the die's form,
            or a die of the holder's. Such as "die".
        offset_of: The punch or the die whose outline this tool follows, so that the two close on each other: every
            point of this
            tool then lies `by` away from the other. A sharp corner of the other becomes an arc of radius `by`. Such
            as "punch".
        shoulder: For a die around a punch with a wall: the cavity ends at the die's face, on which the flat sheet
            lies, with this
            radius. Without it the offset is the whole die: for a punch that is drawn as far as the blank reaches.
            Such as "6 mm".
    """

    by: str | None = None
    closed_at: str | None = None
    file: str | None = None
    fillet: str | None = None
    mirror_of: Role | None = None
    offset_of: Role | None = None
    shoulder: str | None = None


@dataclass(frozen=True, kw_only=True)
class Sides(Part):
    """Friction by the face of the sheet, for tools that do not name their own, and where all of the case's friction
    comes from.

    Attributes:
        die_side: Of the face that the die touches: a coefficient, 0 to 1, or a law. Such as 0.08.
        punch_side: Of the face that punch and holder touch: a coefficient, 0 to 1, or a law. Such as 0.08.
        source: Where the coefficients of all tools come from: how they were measured, or author and year; left out
            where they are
            assumed. Such as "strip drawing with this oil".
    """

    die_side: Friction | None = None
    punch_side: Friction | None = None
    source: str | None = None


@dataclass(frozen=True, kw_only=True)
class Solver(Part):
    """Numerical parameters; one default serves every case, so most files have no `[solver]`.

    Attributes:
        bend_ratio: Thickness over bending radius from which an element bends where `blank.theory` is "selective";
            0.05 when not given. Such as 0.05.
        contact: What keeps tools out of the sheet; "penalty" when not given. Such as "penalty".
        contact_smoothing: Gap over which contact sets in, over the sheet thickness; 0.003 when not given. Such as
            0.003.
        contact_stiffness: Contact stiffness times the sheet thickness, in MPa; "30 GPa" when not given. Such as "30
            GPa".
        cutoff_strain: Equivalent strain that a hundredth of the travel adds below which the sheet counts as rigid;
            5e-6 when not given. Other
            steps cut off in proportion, so that it stays a strain rate and small against what any step strains.
            Such as 5e-06.
        facets: Chords per 90° that replace the tools' arcs, 1 to 1000; exact arcs when not given. Such as 20.
        first_step: First step as a fraction of the travel; 0.002 when not given. Such as 0.002.
        iteration: Matrix of the corrector; "primal_dual" when not given. Such as "primal_dual".
        max_iterations: Most iterations of one step (the secant matrix gets ten times as many); 40 when not given.
            Such as 40.
        max_step: Largest step as a fraction of the travel; 0.01 when not given. Such as 0.01.
        min_step: Smallest step as a fraction of the travel, below which the run stops; 1e-6 when not given. Such as
            1e-06.
        norm: What must be small for a step to be accepted; "velocity" when not given. Such as "velocity".
        round_facets: Rounds chords off by arcs with common tangents, so that the load does not tick at their
            vertices; true by default.
        slip_speed: Sliding speed at which friction has reached 71 % of its full value, over the punch speed, or
            over that of one sheet
            thickness in the whole run or stage where the punch goes less far; 0.003 when not given. Such as 0.003.
        strain_step: Equivalent strain that one step may add anywhere; 0.1 when not given. The next step is chosen
            by it, and one that
            goes beyond twice as much is repeated shorter. Such as 0.1.
        tolerance: Accepted value of the norm; 1e-5 when not given. Such as 1e-05.
    """

    bend_ratio: float | None = None
    contact: ContactMethod | None = None
    contact_smoothing: float | None = None
    contact_stiffness: str | None = None
    cutoff_strain: float | None = None
    facets: int | None = None
    first_step: float | None = None
    iteration: Iteration | None = None
    max_iterations: int | None = None
    max_step: float | None = None
    min_step: float | None = None
    norm: Norm | None = None
    round_facets: bool | None = None
    slip_speed: float | None = None
    strain_step: float | None = None
    tolerance: float | None = None


@dataclass(frozen=True, kw_only=True)
class Spring(Part):
    """A soft holder.

    Attributes:
        preload: Force where the holder touches the flat sheet, of the whole holder as `force`. Such as "10 kN".
        stiffness: Force per move of the whole holder, "5 kN/mm"; in plane strain per depth as well, "50 N/mm^2",
            unless blank.depth is
            given. Such as "5 kN/mm".
    """

    preload: str
    stiffness: str


@dataclass(frozen=True, kw_only=True)
class Springback(Part):
    """The part's tolerances, for the verdict on a case whose last stage takes the tools away, and the split-ring test;
    the run does
    not depend on them.

    Attributes:
        angle: Wanted angle between the two legs or walls of the whole section, 0 deg where they are upright. When
            not given, that of
            the punch's straight wall where the sheet lies against it, else the one under the tools. Such as "90
            deg".
        edge_tolerance: By how much each edge may move inward or outward from where it is under the tools. Such as
            "0.5 mm".
        flange_tolerance: By how much each flange may turn from where it is under the tools. Such as "1 deg".
        ring: A ring that is cut from the wall of a drawn cup and slit: its opening is told.
        tolerance: By how much that angle, of both walls together, may miss; instead of `wall_tolerance`. Such as "1
            deg".
        wall_tolerance: By how much the angle of each wall may miss: half of what the angle between both may. Such
            as "0.5 deg".
    """

    angle: str | None = None
    edge_tolerance: str | None = None
    flange_tolerance: str | None = None
    ring: Ring | None = None
    tolerance: str | None = None
    wall_tolerance: str | None = None


@dataclass(frozen=True, kw_only=True)
class Stage(Part):
    """One more operation on the same sheet; what is not said stays as in the stage before, but tools that went stand
    still.

    Attributes:
        anneal: Sets equivalent strain and stress back to nothing before the stage.
        die: The die, likewise.
        duration: Instead of the speed; 1 s where no tool goes anywhere and it is not given. Such as "2 s".
        edge: How the outer edge is held.
        frames: Number of equally spaced instants that are kept, 1 to 1000; 4 when not given. Such as 4.
        holder: The holder, likewise, or with another force.
        mode: How the metal answers to strain.
        name: Letters, digits, `-` and `_`: it names a folder. Such as "retract".
        punch: The punch, where it is new, moves or has another friction.
        release: Takes the tools away: the forces of contact fade to nothing, and the sheet springs back. True, or
            the stiffness that it
            is iterated with: "updated", which true means, or "constant".
        remove: Tools that are no longer there. Such as ["holder"].
        speed: Speed of the tool that goes furthest; that of the first stage when not given. Such as "1 mm/s".
        trim: Cuts the sheet at this current distance from the axis or symmetry plane before the stage; whole
            elements go. Such as "80 mm".
        trim_diameter: Instead of `trim`, of a round part: its diameter, twice as much.
    """

    name: str
    anneal: bool | None = None
    die: StageDie | None = None
    duration: str | None = None
    edge: Edge | None = None
    frames: int | None = None
    holder: StageHolder | None = None
    mode: Mode | None = None
    punch: StagePunch | None = None
    release: bool | ReleaseStiffness | None = None
    remove: Sequence[Role] | None = None
    speed: str | None = None
    trim: str | None = None
    trim_diameter: str | None = None


@dataclass(frozen=True, kw_only=True)
class StageDie(Part):
    """The die of a later stage; a shape makes it a new one, which is brought down from above until it touches the
    sheet.

    Attributes:
        aside: How far it goes away from the axis or symmetry plane in the stage. Such as "5 mm".
        friction: As in the first stage. Such as 0.08.
        move: How far it goes along z in the stage, away from the punch where positive. Such as "30 mm".
        profile: A section of one's own, from outside inward.
        shoulder: Radius of the corner over which the sheet is drawn. Such as "6 mm".
        throat: Radius of the opening (plane strain: half width). Such as "31.25 mm".
        throat_diameter: Instead of `throat`, of a round part: its diameter, twice as much.
    """

    aside: str | None = None
    friction: Friction | None = None
    move: str | None = None
    profile: Section | None = None
    shoulder: str | None = None
    throat: str | None = None
    throat_diameter: str | None = None


@dataclass(frozen=True, kw_only=True)
class StageHolder(Part):
    """The blank holder of a later stage; a shape makes it a new one, which is brought up from below until it touches
    the sheet.

    Attributes:
        aside: How far it goes away from the axis or symmetry plane in the stage. Such as "5 mm".
        force: As in the first stage, a history over the travel of this one. One force is reached from that of the
            stage before over
            the first fifth of the travel, at once where nothing moves. Such as "20 N".
        friction: As in the first stage. Such as 0.08.
        inner_diameter: Instead of `inner_radius`, of a round part: its diameter, twice as much.
        inner_half_width: Distance of its inner edge from the symmetry plane (plane strain). Such as "341 mm".
        inner_radius: Inner radius (axisymmetric). Such as "32 mm".
        move: How far it goes along z in the stage, away from the die where negative; it then has no force. Such as
            "-5 mm".
        profile: A section of one's own, from inside outward.
    """

    aside: str | None = None
    force: str | Sequence[Sequence[str]] | None = None
    friction: Friction | None = None
    inner_diameter: str | None = None
    inner_half_width: str | None = None
    inner_radius: str | None = None
    move: str | None = None
    profile: Section | None = None


@dataclass(frozen=True, kw_only=True)
class StagePunch(Part):
    """The punch of a later stage; a shape makes it a new one, which is brought up from below until it touches the
    sheet.

    Attributes:
        aside: How far it goes away from the axis or symmetry plane in the stage. Such as "5 mm".
        crowned: A new punch with a gently curved face.
        flat: A new punch with a flat face.
        friction: As in the first stage. Such as 0.08.
        hemispherical: A new punch with a spherical nose.
        move: How far it goes along z in the stage, towards the die where positive. Such as "-30 mm".
        profile: A section of one's own, from the axis outward.
    """

    aside: str | None = None
    crowned: Crowned | None = None
    flat: Flat | None = None
    friction: Friction | None = None
    hemispherical: Hemispherical | None = None
    move: str | None = None
    profile: Section | None = None


@dataclass(frozen=True, kw_only=True)
class Stop(Part):
    """When a run ends before its full travel: at the instant, found to a thousandth of a step, that a rule is first
    met.

    Attributes:
        contact_share: Ends when this share of the sheet's area, inside the gas's seal where there is gas, lies on
            the punch or the die: the
            part is formed. Never when not given. Such as "95 %".
        drawn_through: Ends, as wished, when the cup is through the die: its rim stands in the throat, a thickness
            behind the shoulder; in every
            stage whose travel is long enough. False when not given: then a run ends early as soon as the rim comes
            to the throat. Such as true.
        load_drop: Ends when the punch force has fallen by this much from its maximum; never when not given. Such as
            "20 %".
        localised: Ends where one place of the sheet takes all the stretching; true when not given. Such as true.
    """

    contact_share: str | None = None
    drawn_through: bool | None = None
    load_drop: str | None = None
    localised: bool | None = None


@dataclass(frozen=True, kw_only=True)
class Stribeck(Part):
    """Coefficient that depends on the sliding speed v: sliding + (at_rest − sliding) exp(−(v/speed)²) + viscous v.

    Source: in common use (as in MathWorks, Simscape, Translational Friction, but for its smoothing);
    B. Armstrong-Hélouvry, P. Dupont, C. Canudas de Wit, Automatica 30 (1994) 1083–1138 (not read).

    Attributes:
        at_rest: Of the slowest sliding, 0 to 1. Such as 0.15.
        sliding: Of fast sliding, 0 to 1. Such as 0.05.
        speed: Stribeck's speed [mm/s]. Such as "10 mm/s".
        viscous: Rise of the coefficient with the speed, per mm/s; none when not given. Such as 0.0001.
    """

    _law: ClassVar[str | None] = "stribeck"

    at_rest: float
    sliding: float
    speed: str
    viscous: float | None = None


@dataclass(frozen=True, kw_only=True)
class Swift(Part):
    """σ = k (offset + ε)^n.

    Valid up to large strains for most steels; it hardens without end.
    Source: H. W. Swift, Plastic instability under plane stress, J. Mech. Phys. Solids 1 (1952) 1–18.

    Attributes:
        k: K, the stress at a total strain of 1 [MPa]. Such as "520 MPa".
        n: Hardening exponent, 0 to 1. Such as 0.22.
        offset: Offset strain, 1e-6 to 1. Such as 0.005.
    """

    _law: ClassVar[str | None] = "swift"

    k: str
    n: float
    offset: float


@dataclass(frozen=True, kw_only=True)
class Table(Part):
    """Measured points, interpolated smoothly: `points`, or `strain` and `stress`.

    Up to 50 points it goes through each of them; more are taken as a record with scatter, which is smoothed first
    over a third
    of the strain, 0.1 at most.

    Valid up to the last point; beyond it the case says what is assumed, and the run warns.
    Source: monotone cubics of F. N. Fritsch, R. E. Carlson, SIAM J. Numer. Anal. 17 (1980) 238–246.

    Attributes:
        extrapolation: What the law does beyond the last point: a choice that has to be made. Such as "slope".
        points: Pairs of strain and stress, the first at strain 0: `[[0, "150 MPa"], [0.1, "290 MPa"]]`.
        strain: Strains, when not given as `points`.
        stress: Stresses, when not given as `points`.
    """

    _law: ClassVar[str | None] = "table"

    extrapolation: Extrapolation
    points: Sequence[Sequence[float | str]] | None = None
    strain: Sequence[float] | None = None
    stress: Sequence[str] | None = None


@dataclass(frozen=True, kw_only=True)
class TitleBlock(Part):
    """The title block of a report: as it is written, and only what is given is shown.

    Attributes:
        author: Who answers for the report. Such as "A. Ito".
        company: For whom the author works. Such as "Ito Tools Ltd".
        date: Day of the report; the program looks at no clock. Such as "2026-11-22".
        number: Number of the part or of its drawing. Such as "4711-02".
        part: Name of the part. Such as "Bearing cup".
        revision: Revision of the part or of its drawing. Such as "C".
    """

    author: str | None = None
    company: str | None = None
    date: str | None = None
    number: str | None = None
    part: str | None = None
    revision: str | None = None


@dataclass(frozen=True, kw_only=True)
class ToolHeat(Part):
    """Heat transfer from and to a tool whose temperature stays.

    Attributes:
        temperature: Temperature of the tool. Such as "25 °C".
        transfer: Heat-transfer coefficient of the contact. Such as "1.4 kW/m^2/K".
    """

    temperature: str
    transfer: str


@dataclass(frozen=True, kw_only=True)
class Tools(Part):
    """The rigid tools; each is placed where it touches the flat sheet.

    Attributes:
        beads: Draw beads across the flange, as line restraints.
        die: The die, above the sheet.
        holder: The blank holder, below the sheet.
        punch: The punch, below the sheet.
    """

    beads: Sequence[Bead] | None = None
    die: Die | None = None
    holder: Holder | None = None
    punch: Punch | None = None


@dataclass(frozen=True, kw_only=True)
class Tresca(Part):
    """Friction stress of at most a share of the sheet's shear yield stress k.

    Source: the combined law of Coulomb and constant shear friction, as I. Bobrovskij et al., Metals 12 (2022) 239,
    describes
    it; E. Orowan, Proc. Inst. Mech. Engrs. 150 (1943) 140–167 (not read), for min(μ p, k). The smooth passage is
    ours.

    Attributes:
        coefficient: Coulomb's coefficient under light pressure; 1/√3, the largest that makes sense, when not given.
            Such as 0.1.
        factor: Share m of k, 0 to 1. Such as 0.2.
    """

    _law: ClassVar[str | None] = "tresca"

    factor: float
    coefficient: float | None = None


@dataclass(frozen=True, kw_only=True)
class Voce(Part):
    """σ = saturation − (saturation − initial) exp(−rate ε^exponent).

    Valid for metals whose hardening comes to an end, such as aluminium.
    Source: E. Voce, J. Inst. Metals 74 (1948) 537–562; the exponent: J. E. Hockett, O. D. Sherby (1975).

    Attributes:
        exponent: Power of the strain; 1 when not given. Such as 1.0.
        initial: Yield stress σ₀ [MPa]. Such as "125 MPa".
        rate: b: how fast it comes there. Such as 7.5.
        saturation: Stress σ_s that hardening comes to [MPa]. Such as "320 MPa".
    """

    _law: ClassVar[str | None] = "voce"

    initial: str
    rate: float
    saturation: str
    exponent: float | None = None


@dataclass(frozen=True, kw_only=True)
class Zones(Part):
    """Temperatures by the tools' places on the flat sheet.

    Attributes:
        flange: From the die's throat outward. Such as "230 °C".
        punch: Inside the punch's radius. Such as "25 °C".
    """

    flange: str
    punch: str

Anisotropy: TypeAlias = "float | Directions"
"""Normal anisotropy: the mean, or what it is the mean of."""

ComparedQuantity: TypeAlias = 'Literal["punch_force", "travel", "thickness_at_s0", "thickness_at_radius", "strain_path", "draw_in_at_travel", "edge_diameter", "draw_in", "thinnest", "thickness", "peak_force", "peak_travel", "ring_opening"]'
"""What is compared.
punch_force: Punch force at equal travel, a curve.
travel: Punch travel at equal force, a curve.
thickness_at_s0: Thickness over the initial distance from the axis or symmetry plane at the end, a curve.
thickness_at_radius: Thickness over the present radius at the end, a curve.
strain_path: Minor over major true strain of the place that is thinnest at the end, on its way there, a curve; with
    `[forming_limit]`.
draw_in_at_travel: Draw-in of the edge at equal travel, a curve.
edge_diameter: Diameter at the blank's edge (in plane strain the width between both edges) at the end, a band.
draw_in: How far the edge has moved inward at the end, a band.
thinnest: Smallest thickness at the end, a band.
thickness: Thickness of the whole section at the end, a band.
peak_force: Largest punch force of the run, a band.
peak_travel: Punch travel at the largest punch force, once the force has fallen from it, a band: the index of a
    cupping test.
ring_opening: By how much the ring of `[springback]` opens when it is slit, a band."""

ContactMethod: TypeAlias = 'Literal["penalty", "augmented_lagrangian"]'
"""What keeps tools out of the sheet.
penalty: Stiff springs: tools penetrate by thousandths of the thickness.
augmented_lagrangian: The springs shifted until nothing penetrates by more than a ten-thousandth of the thickness."""

Crystal: TypeAlias = 'Literal["bcc", "fcc"]'
"""Lattice of a metal.
bcc: Body-centred cubic: ferritic steel; a = 6.
fcc: Face-centred cubic: aluminium, copper, austenitic steel; a = 8."""

Edge: TypeAlias = 'Literal["free", "clamped"]'
"""The blank's outer edge.
free: Draws in under the holder.
clamped: Does not move: a locking bead."""

Extrapolation: TypeAlias = 'Literal["hold", "slope"]'
"""Beyond the last point of a table: a declared choice.
hold: Keeps the last stress.
slope: Goes on along the last two points."""

Friction: TypeAlias = "float | PressureDependent | Stribeck | Tresca"
"""The friction law of one tool: Coulomb's coefficient, 0 to 1, or exactly one other law."""

Geometry: TypeAlias = 'Literal["axisymmetric", "plane_strain"]'
"""Which section is solved.
axisymmetric: Body of revolution.
plane_strain: A section that is the same at every depth; one half of it is solved, symmetric to the other."""

Grading: TypeAlias = 'Literal["uniform", "radii"]'
"""How element sizes are spread over the blank.
uniform: Equal elements.
radii: Smaller elements where the sheet meets the tools' radii."""

Hardening: TypeAlias = "HockettSherby | Hollomon | Isotherms | Ludwik | Mixed | PiecewisePower | Swift | Table | Voce"
"""Yield stress σ over equivalent plastic strain ε of uniaxial tension: exactly one law."""

InitialTemperature: TypeAlias = "str | Zones"
"""Temperature of the flat sheet."""

Iteration: TypeAlias = 'Literal["primal_dual", "newton", "secant"]'
"""Matrix of the corrector.
primal_dual: Newton's matrix with an independently carried stress.
newton: Newton's consistent tangent.
secant: Secant (Picard): slow, hardly ever fails."""

Mode: TypeAlias = 'Literal["flow", "elasto_viscoplastic", "elastic"]'
"""How the metal answers to strain.
flow: The flow approach, rigid-viscoplastic: σ = 3 μ A ε̇ with the flow viscosity μ = σ_y/(3 ε̄̇) and ε̄̇² = ε̇ᵀ A
    ε̇, all at the end of the step; where the sheet hardly flows ε̄̇² + ε̇₀² takes the place of ε̄̇²
    (`solver.cutoff_strain`).  Valid where plastic strains are many times the elastic ones; nothing springs back.
    Source: O. C. Zienkiewicz, P. C. Jain, E. Oñate, Int. J. Solids Struct. 14 (1978) 15–38; W. Sosnowski (1994),
    equations 3 and 4.
elasto_viscoplastic: Elastic and plastic strains on the same elements: Δσ = D(E, ν) (Δε − Δε_p), with Δε_p normal to
    the yield surface σ̄(σ − Σ α) = σ_y(ε̄, ε̄̇) at the end of the step.  Valid for loads from the first contact on,
    for bending and spring-back. The elastic change of volume counts in the thickness, and yield is by force per
    current area (Cauchy's stress).  Source: J. C. Simo, R. L. Taylor, Int. J. Num. Meth. Engng. 22 (1986) 649–670.
elastic: Elastic on the stress that the sheet carries, without yield: Δσ = D(E, ν) Δε.  Valid for the release of a
    sheet that the flow law formed, as a first guess.  Source: W. Sosnowski (1994), equations 10 to 13."""

Norm: TypeAlias = 'Literal["velocity", "residual", "both"]'
"""Norm of acceptance.
velocity: Relative increment of the velocities.
residual: Residual force over the largest internal force.
both: Both of them."""

Rate: TypeAlias = "CowperSymonds | JohnsonCook | PowerRate"
"""A factor on the hardening law: exactly one."""

ReleaseStiffness: TypeAlias = 'Literal["updated", "constant"]'
"""Which stiffness a release iterates with.
updated: Formed anew in every iteration, with the geometric stiffness.
constant: The one at the start of each increment."""

Role: TypeAlias = 'Literal["punch", "die", "holder"]'
"""Which tool.
punch: Below the sheet, forms it towards +z.
die: Above the sheet.
holder: Below the sheet, holds its flange against the die."""

Section: TypeAlias = "Sequence[ProfileStep] | str | SectionTable"
"""A tool's section, the sheet on the left as one goes along it: steps, the name of a CSV file with points, or a table.
    Wherever it is drawn along z, it is moved to where it touches the flat sheet."""

Strain: TypeAlias = 'Literal["logarithmic", "engineering"]'
"""Strains of a measured curve.
logarithmic: True strain.
engineering: Change of length over the initial length."""

Theory: TypeAlias = 'Literal["bending", "membrane", "selective"]'
"""Shell theory.
bending: Membrane, bending and transverse shear.
membrane: Membrane only.
selective: Bending where the sheet is curved, chosen in every step, membrane elsewhere."""

ThermalLaw: TypeAlias = "Arrhenius | Exponential | Melting"
"""A factor on the hardening law: exactly one. A table of curves by temperature is `[material.hardening.isotherms]`."""

Turn: TypeAlias = 'Literal["left", "right"]'
"""Sense of an arc as one goes along it, r to the right and z upward.
left: Counter-clockwise: a hollow of the tool.
right: Clockwise: a convex corner that bends the sheet."""

YieldCondition: TypeAlias = 'Literal["hill48"] | HosfordLaw'
"""The curve of the stresses at which the sheet yields; both take r̄ from `anisotropy`.
hill48: Hill's of 1948, quadratic."""

