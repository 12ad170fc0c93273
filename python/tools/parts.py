"""Writes the keyword dataclasses of ``stampflow/parts.py`` from the schema of case files, which is their only source.

    stampflow schema | python tools/parts.py > stampflow/parts.py
"""

from __future__ import annotations

import json
import keyword
import sys
import textwrap
from typing import Any

WIDTH = 116
HEAD = '''"""The tables of case files as keyword dataclasses, each with the words of the case-file reference.

Quantities are texts with units, ``"0.9 mm"``; plain numbers are only for plain numbers. What is not given is not written.
``Model(...).case()`` is a case, with the checks and messages of one that was read from a file.

Written by ``tools/parts.py`` from ``stampflow schema``.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import ClassVar, Literal, TypeAlias

from .part import Part, Whole
'''
PLAIN = {"string": "str", "number": "float", "integer": "int", "boolean": "bool"}


def main(schema: dict[str, Any]) -> str:
    defs: dict[str, Any] = schema["$defs"]
    laws = {name: law for definition in defs.values() for name, law in variants(definition)}
    classes = [written("Model", schema, "Whole", None)]
    classes += [written(name, d, "Part", laws.get(name)) for name, d in defs.items() if is_class(d)]
    aliases = [alias(name, d) for name, d in defs.items() if not is_class(d)]
    names = sorted(["Model", *defs])
    exported = "\n".join(["__all__ = [", *(f'    "{name}",' for name in names), "]"])
    return "\n".join([HEAD, exported, *classes, "", *aliases]) + "\n"


def is_class(definition: dict[str, Any]) -> bool:
    """Whether it is a table with fields, and none of which only one may be given."""
    return "properties" in definition and definition.get("maxProperties") != 1


def variants(definition: dict[str, Any]) -> list[tuple[str, str]]:
    """Class and key of the laws of which it is one."""
    tables = [definition] if definition.get("maxProperties") == 1 else []
    tables += [one for one in definition.get("oneOf", []) if one.get("type") == "object"]
    return [(reference(value), key) for table in tables for key, value in table["properties"].items()]


def reference(value: dict[str, Any]) -> str:
    return str(value["$ref"]).rpartition("/")[2]


def written(name: str, definition: dict[str, Any], base: str, law: str | None) -> str:
    """A dataclass."""
    needed = definition.get("required") or []
    known = definition["properties"].items()
    lines = ["", "", "@dataclass(frozen=True, kw_only=True)", f"class {name}({base}):"]
    lines += docstring(definition["description"], [(identifier(key), value) for key, value in known])
    lines += [f'    _law: ClassVar[str | None] = "{law}"', ""] if law else []
    lines += [f"    {identifier(key)}: {hint(value)}" for key, value in known if key in needed]
    for key, value in known:
        if key not in needed:
            kind = " | ".join(dict.fromkeys([*hint(value).split(" | "), "None"]))
            lines.append(f"    {identifier(key)}: {kind} = None")
    return "\n".join(lines)


def identifier(key: str) -> str:
    return f"{key}_" if keyword.iskeyword(key) else key


def docstring(about: str, fields: list[tuple[str, dict[str, Any]]]) -> list[str]:
    text = filled(about, "    ")
    text[0] = '    """' + text[0].lstrip()
    text += ["", "    Attributes:"]
    for name, value in fields:
        example = f" Such as {json.dumps(value['examples'][0], ensure_ascii=False)}." if value.get("examples") else ""
        said = value.get("description") or "See its class."
        text += filled(f"{name}: {said}{example}", "        ", "    ")
    raw = any("\\" in line for line in text)
    text[0] = text[0].replace('"""', 'r"""', 1) if raw else text[0]
    return [*text, '    """', ""]


def filled(text: str, indent: str, further: str = "") -> list[str]:
    lines: list[str] = []
    for paragraph in text.replace("\\[", "[").replace("\\]", "]").split("\n"):
        more = further if lines else ""
        lines += textwrap.wrap(
            paragraph, WIDTH, initial_indent=indent + more, subsequent_indent=indent + further, break_long_words=False
        ) or [""]
    return lines


def hint(value: dict[str, Any]) -> str:
    """The type of a value."""
    if "$ref" in value:
        return reference(value)
    if "const" in value:
        return f"Literal[{json.dumps(value['const'])}]"
    several = value.get("anyOf") or value.get("oneOf") or value.get("prefixItems")
    if value.get("type") == "object":
        return reference(next(iter(value["properties"].values())))
    if several:
        kinds = dict.fromkeys(kind for one in several for kind in split(hint(one)))
        union = " | ".join(merged(list(kinds)))
        return f"Sequence[{union}]" if "prefixItems" in value else union
    kinds_of = value["type"] if isinstance(value["type"], list) else [value["type"]]
    return " | ".join(one(kind, value) for kind in kinds_of)


def one(kind: str, value: dict[str, Any]) -> str:
    if kind == "null":
        return "None"
    if kind != "array":
        return PLAIN[kind]
    if "prefixItems" in value:
        return f"Sequence[{' | '.join(dict.fromkeys(k for item in value['prefixItems'] for k in split(hint(item))))}]"
    return f"Sequence[{hint(value['items'])}]"


def split(kind: str) -> list[str]:
    """The parts of a union, those inside brackets left together."""
    parts, depth, start = [], 0, 0
    for i, letter in enumerate(kind):
        depth += {"[": 1, "]": -1}.get(letter, 0)
        if depth == 0 and kind.startswith(" | ", i):
            parts.append(kind[start:i])
            start = i + 3
    return [*parts, kind[start:]]


def merged(kinds: list[str]) -> list[str]:
    """With all words in one Literal."""
    words = [kind[len("Literal[") : -1] for kind in kinds if kind.startswith("Literal[")]
    others = [kind for kind in kinds if not kind.startswith("Literal[")]
    return [f"Literal[{', '.join(words)}]", *others] if words else others


def alias(name: str, definition: dict[str, Any]) -> str:
    """A choice: words, or one of some laws."""
    if definition.get("maxProperties") == 1:
        number = ["float"] if "number" in definition.get("type", []) else []
        kind = " | ".join([*number, *(reference(value) for value in definition["properties"].values())])
    else:
        kind = hint(definition)
    about = " ".join(definition["description"].split())
    words = [f"{one['const']}: {one['description']}" for one in definition.get("oneOf", []) if "const" in one]
    text = [line for said in [about, *words] for line in textwrap.wrap(said, WIDTH, subsequent_indent="    ")]
    lines = "\n".join(text)
    statement = f'{name}: TypeAlias = "{kind}"' if "Literal" not in kind else f"{name}: TypeAlias = '{kind}'"
    return f'{statement}\n"""{lines}"""\n'


if __name__ == "__main__":
    sys.stdout.write(main(json.load(sys.stdin)))
