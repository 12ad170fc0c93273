"""Python values as TOML, the language of case files."""

from __future__ import annotations

import json
import re
from collections.abc import Iterable, Mapping
from numbers import Integral, Real

_BARE = re.compile(r"[A-Za-z0-9_-]+")


def value(given: object) -> str:
    """A value on one line: texts in quotes, numbers as they are, lists and tables inline."""
    if isinstance(given, bool):
        return "true" if given else "false"
    if isinstance(given, str):
        # The escapes of JSON are those of TOML, but for DEL.
        return json.dumps(given, ensure_ascii=False).replace("\x7f", "\\u007f")
    if isinstance(given, Integral):
        return str(int(given))
    if isinstance(given, Real):
        return repr(float(given))
    if isinstance(given, Mapping):
        return "{ " + ", ".join(f"{key(name)} = {value(item)}" for name, item in given.items()) + " }"
    if isinstance(given, Iterable):
        return "[" + ", ".join(value(item) for item in given) + "]"
    raise TypeError(f"a {type(given).__name__} is no value of a case file: write a text with its unit, a number, or a list")


def key(name: str) -> str:
    """A key, in quotes where it needs them."""
    return name if _BARE.fullmatch(name) else value(name)


def document(table: Mapping[str, object], above: str = "") -> str:
    """A table as a file: its values, then the tables below it, each with its heading."""
    own, below = [], []
    for name, item in table.items():
        path = f"{above}.{key(name)}" if above else key(name)
        if isinstance(item, Mapping):
            below.append(f"\n[{path}]\n" + document(item, path))
        elif isinstance(item, list) and item and all(isinstance(entry, Mapping) for entry in item):
            below.extend(f"\n[[{path}]]\n" + document(entry, path) for entry in item)
        else:
            own.append(f"{key(name)} = {value(item)}\n")
    return "".join(own + below)


def settings(given: Mapping[str, object]) -> list[str]:
    """Overrides, ``key=value``, of dotted keys."""
    return [f"{name}={value(item)}" for name, item in given.items()]
