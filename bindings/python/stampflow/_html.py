"""How notebooks show things: a title, an answer with its light, a picture, and rows that unfold."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from html import escape
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from .finding import Finding
    from .picture import Picture

#: From the worst on.
_COLORS = {"red": "#D55E00", "amber": "#E69F00", "grey": "#787878", "green": "#009E73"}


@dataclass(frozen=True)
class Page:
    """What is shown of a thing."""

    title: str
    #: In a sentence.
    answer: str
    #: Of the answer; empty where it has none.
    light: str = ""
    picture: Picture | None = None
    #: What is to be known besides, a sentence each.
    notes: Sequence[str] = ()
    #: What unfolds the rows.
    summary: str = ""
    header: Sequence[str] = ()
    #: Cells; one that is the name of a light is coloured.
    rows: Sequence[Sequence[str]] = ()

    def html(self) -> str:
        """As HTML without scripts or styles of its own."""
        answer = f"<b>{escape(self.answer)}</b>"
        notes = "".join(f"<li>{escape(note)}</li>" for note in self.notes)
        return (
            f"<h4>{escape(self.title)}</h4>"
            f"<p>{_light(self.light)} {answer}</p>"
            + (str(self.picture) if self.picture is not None else "")
            + (f"<ul>{notes}</ul>" if notes else "")
            + (self._table() if self.rows else "")
        )

    def _table(self) -> str:
        head = "".join(f"<th>{escape(cell)}</th>" for cell in self.header)
        body = "".join("<tr>" + "".join(f"<td>{_cell(cell)}</td>" for cell in row) + "</tr>" for row in self.rows)
        return (
            f"<details><summary>{escape(self.summary)}</summary>"
            f"<table><thead><tr>{head}</tr></thead><tbody>{body}</tbody></table></details>"
        )


class Shown(ABC):
    """What notebooks show as a page."""

    @abstractmethod
    def _page(self) -> Page: ...

    def _repr_html_(self) -> str:
        return self._page().html()


#: Above rows of findings.
FINDINGS = ("", "", "found", "limit", "what to change")


def findings(rows: Iterable[Finding]) -> list[tuple[str, ...]]:
    """Rows of a verdict, from the worst on."""
    worst = sorted(rows, key=lambda row: list(_COLORS).index(row.light))
    return [(row.light, row.label, row.found, row.limit, row.advice) for row in worst]


def _cell(text: str) -> str:
    return _light(text) if text in _COLORS else escape(text)


def _light(light: str) -> str:
    return f'<span style="color:{_COLORS[light]}">&#9679;</span> {light}' if light else ""
