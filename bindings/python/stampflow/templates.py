"""Cases from a few sizes."""

from __future__ import annotations

from dataclasses import dataclass

from . import _native
from .case import Case


@dataclass(frozen=True)
class Option:
    """What may be given to a template."""

    #: Name, as :func:`new` takes it: ``punch_radius``.
    name: str
    #: What it is.
    about: str
    #: What is taken where it is not given: a value, or a rule in words.
    default: str


@dataclass(frozen=True)
class Template:
    """A kind of part that a case can be written for."""

    #: What it forms.
    about: str
    #: What may be given, the sheet's options last.
    options: list[Option]


def templates() -> dict[str, Template]:
    """All templates by name."""
    return {
        name: Template(about, [Option(key.replace("-", "_"), *told) for key, *told in options])
        for name, about, options in _native.templates()
    }


def new(template: str, **sizes: str | float) -> Case:
    """A case from a template and a few sizes with units: ``new("cup", height="35 mm")``.

    What is not given follows from stated rules; :func:`templates` lists what may be given, ``case.text`` is the file.
    """
    given = [(name.replace("_", "-"), str(size)) for name, size in sizes.items()]
    return Case.from_text(_native.fill(template, given), f"{template}.toml")
