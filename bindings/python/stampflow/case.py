"""Cases: from files, text, tables, templates and drawings."""

from __future__ import annotations

import json
import re
from collections.abc import Callable, Mapping, Sequence
from os import PathLike, fspath
from typing import Any

from . import _native
from .columns import Named
from .errors import finished
from .picture import Picture
from .solution import Finding, Solution
from .trace import Trace

Progress = Callable[[float], object]

#: Keys of the families of laws, and their tables in the schema.
FAMILIES = {"hardening": "Hardening", "rate": "Rate", "softening": "ThermalLaw", "friction": "FrictionLaw", "fracture": "Fracture"}


class Case:
    """A case as it was read. It never changes; :meth:`with_` gives another one."""

    def __init__(self, native: _native.Case, notes: list[str] | None = None, drawing: Picture | None = None) -> None:
        self._native = native
        #: How a drawing was understood; empty for other cases.
        self.notes = notes or []
        #: Picture of what was read of a drawing.
        self.drawing = drawing

    @classmethod
    def load(cls, path: str | PathLike[str]) -> Case:
        """Reads a case file."""
        return cls(_native.Case.load(existing(path)))

    @classmethod
    def from_text(cls, text: str, name: str = "case.toml") -> Case:
        """Reads a case from TOML text. Files that it names are looked up beside ``name``."""
        return cls(_native.Case.parse(text, name, []))

    @classmethod
    def from_dict(cls, tables: Mapping[str, Any], name: str = "case.toml") -> Case:
        """Reads a case from nested dictionaries with the keys of case files."""
        return cls.from_text(_native.toml(json.dumps(tables)), name)

    @classmethod
    def from_drawing(cls, path: str | PathLike[str], **options: Any) -> Case:
        """Makes a case around the tools of a DXF drawing.

        Options: ``layers`` (dict from layer to tool), ``units``, ``axis``, ``join``, ``tolerance``, ``punch_moves``,
        ``geometry``, ``material``, ``thickness``, ``blank_radius``, ``travel``, ``holder_force``, texts with units;
        ``friction``; ``drawn_through``, True; ``settings`` as of ``with_``. The rest are placeholders, marked in ``text``.
        """
        named = {"holder_force": "tools.holder.force", "drawn_through": "stop.drawn_through"}
        pairs = {key: options.pop(name) for name, key in named.items() if name in options} | options.pop("settings", {})
        options["set"] = [f"{key}={setting(value)}" for key, value in pairs.items()]
        text, name, notes, drawing = _native.from_drawing(existing(path), json.dumps(options))
        return cls(_native.Case.parse(text, name, []), notes, Picture._of(*drawing))

    def with_(self, settings: Mapping[str, object] | None = None, /, **more: object) -> Case:
        """Returns the case with other values of some keys: ``case.with_({"blank.thickness": "0.8 mm"})``.

        Keys are dotted paths, values as in case files. ``friction`` is that of every tool.
        """
        pairs = {**(settings or {}), **more}
        return Case(self._native.with_settings([f"{key}={setting(value)}" for key, value in pairs.items()]))

    @property
    def name(self) -> str:
        """Stem of the file's name."""
        return self._native.name

    @property
    def title(self) -> str:
        """Title above plots and reports."""
        return self._native.title

    @property
    def text(self) -> str:
        """Text of the case with all settings applied: enough to repeat the run."""
        return self._native.text

    @property
    def settings(self) -> list[str]:
        """``key=value`` settings that replaced values of the file."""
        return self._native.settings

    @property
    def stages(self) -> list[str]:
        """Names of the stages."""
        return self._native.stages

    def check(self) -> list[Finding]:
        """Findings before the run: assumptions made while the case was read, and odd values."""
        return [Finding._of(row) for row in json.loads(self._native.findings())]

    def solve(self, progress: Progress | None = None) -> Solution:
        """Solves the case, without the interpreter's lock.

        ``progress`` is called with the share that is done, from 0 to 1; raise an exception in it to abort. Ctrl-C raises
        :class:`Interrupted`, whose ``partial`` is the solution so far.
        """
        native, raised = self._native.solve(progress)
        return finished(Solution(self, native), raised)

    def trace(
        self,
        step: int,
        matrices: str | Sequence[str] = (),
        *,
        stage: int = 1,
        tolerance: float | None = None,
        progress: Progress | None = None,
    ) -> Trace:
        """Repeats one step from the same state with each matrix of the corrector and keeps every iteration.

        Steps count from 1, as the rows of ``load_travel``. ``matrices`` are ``primal_dual``, ``newton``, ``secant``, or
        ``"all"``; none for the case's own. ``tolerance`` replaces that of the norm in this step.
        """
        names = [matrices] if isinstance(matrices, str) else list(matrices)
        traced = _native.trace(self._native, (stage, step), names, tolerance, progress)
        return Trace(stage, step, *traced)

    def __reduce__(self) -> tuple[object, ...]:
        return _restored, (self._native.written, self._native.path, self.settings, self.notes)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Case) and (self.text, self.name) == (other.text, other.name)

    def __hash__(self) -> int:
        return hash((self.text, self.name))

    def __repr__(self) -> str:
        return f"<Case {self.name}: {self.title}>"


def _restored(text: str, path: str, settings: list[str], notes: list[str]) -> Case:
    return Case(_native.Case.parse(text, path, settings), notes)


def existing(path: str | PathLike[str]) -> str:
    """Path of a file that can be read; raises ``FileNotFoundError`` and its like."""
    with open(path, "rb"):
        return fspath(path)


def setting(value: object) -> str:
    """A value as ``--set`` takes it; numpy's numbers and arrays too."""
    return value if isinstance(value, str) else json.dumps(value, default=lambda other: other.tolist())


def new(template: str, **sizes: str | float) -> Case:
    """Makes a case from a template and a few sizes with units: ``new("cup", height="35 mm")``.

    Other sizes follow from stated rules; :func:`templates` lists the options.
    """
    given = [(name.replace("_", "-"), str(size)) for name, size in sizes.items()]
    return Case.from_text(_native.fill(template, given), f"{template}.toml")


def templates() -> dict[str, dict[str, str]]:
    """Options of each template, with what each one is."""
    return {
        name: {key.replace("-", "_"): about for key, about in options} for name, options in _native.templates().items()
    }


def materials() -> Named[Mapping[str, Any]]:
    """Built-in sheets by name: ``materials()["drawing-steel"]["law"]``.

    Each has ``title``, ``stands_for`` (grades), ``source``, ``grade`` of the source, ``licence``, ``thickness``, ``law``,
    ``notes``, ``case`` (its table), and, None where it is not known, ``r``, ``n``, ``proof_stress_MPa``,
    ``tensile_strength_MPa``, ``uniform_elongation`` and ``young_MPa``.
    """
    return Named("material", json.loads(_native.materials()))


def laws() -> Named[Mapping[str, Any]]:
    """Laws of case files by name: ``laws()["hardening.swift"]["formula"]``.

    Each has ``formula``, ``range`` (of validity) and ``source``, empty where none is given, and ``keys``, a description
    and an example of each.
    """
    tables = json.loads(_native.schema())["$defs"]
    found = {}
    for family, title in FAMILIES.items():
        for name, reference in tables[title]["properties"].items():
            law = tables[reference["$ref"].rpartition("/")[2]]
            parts = re.fullmatch(r"(.*?)(?:\s+Valid (.*?))?(?:\s+Source: (.*))?", " ".join(law["description"].split()))
            formula, valid, source = parts.groups("") if parts else ("", "", "")
            keys = {
                key: {"about": about.get("description", ""), "example": about.get("examples", [None])[0]}
                for key, about in law["properties"].items()
            }
            found[f"{family}.{name}"] = {"formula": formula, "range": valid, "source": source, "keys": keys}
    return Named("law", found)
