"""A solution as notebooks show it."""

from __future__ import annotations

from html import escape
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from .solution import Solution

#: From the worst on.
_COLORS = {"red": "#D55E00", "amber": "#E69F00", "grey": "#787878", "green": "#009E73"}


def solution(solved: Solution) -> str:
    """The verdict, its rows from the worst on, and the section of the last stage."""
    rows = sorted(solved.findings, key=lambda row: list(_COLORS).index(row.light))
    body = "".join(
        f"<tr><td>{_light(row.light)}</td><td>{escape(row.label)}</td><td>{escape(row.found)}</td>"
        f"<td>{escape(row.limit)}</td><td>{escape(row.advice)}</td></tr>"
        for row in rows
    )
    try:
        section = str(solved.stages[-1].plot.part()) if solved.stages else ""
    except ValueError:
        section = ""
    return (
        f"<h4>{escape(solved.case.title)}</h4>"
        f"<p>{_light(solved.light)} <b>{escape(solved.verdict)}</b></p>{section}"
        f"<details><summary>{escape(solved.headline)}</summary><table><thead><tr><th></th><th></th><th>found</th>"
        f"<th>limit</th><th>what to change</th></tr></thead><tbody>{body}</tbody></table></details>"
    )


def _light(light: str) -> str:
    return f'<span style="color:{_COLORS[light]}">&#9679;</span> {light}'
