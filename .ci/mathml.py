"""Preprocessor of mdbook: LaTeX between dollars becomes MathML, which browsers draw without a script or the network.

`$...$` stands in a line. `$$...$$` is an equation: its parts, between `\\qquad`, wrap where the page is narrow, and `\\tag{1}` is its number.
"""

import json
import re
import sys

LATEX = re.compile(r"^```.*?^```|<!--.*?-->|`[^`\n]+`|\$\$(?P<equation>.+?)\$\$|(?<![\\\w])\$(?P<inline>[^\s$](?:[^$\n]*[^\s$])?)\$(?!\w)", re.S | re.M)


def mathml(match: re.Match[str]) -> str:
    from latex2mathml.converter import convert

    def converted(latex: str, display: str) -> str:
        markup = convert(latex.replace(r"\cr", r"\\"), display=display)
        # A thin space after a function's name, but before a parenthesis.
        return re.sub(r"(<m[io]>(?:ln|exp|sin|cos|cosh)</m[io]>)(?!<mrow><mo|<mo)", r'\1<mspace width="0.17em" />', markup)

    if match["inline"]:
        return converted(match["inline"], "inline")
    if not match["equation"]:
        return match[0]
    latex, _, tag = match["equation"].partition(r"\tag")
    parts = "".join(f"<span>{converted(part.strip(), 'block')}</span>" for part in latex.split(r"\qquad"))
    number = f'<span class="number">({tag.strip()[1:-1]})</span>' if tag else ""
    return f'<span class="equation">{parts}{number}</span>'


def typeset(items: list) -> None:
    for chapter in (item["Chapter"] for item in items if "Chapter" in item):
        chapter["content"] = LATEX.sub(mathml, chapter["content"])
        typeset(chapter["sub_items"])


if sys.argv[1:2] != ["supports"]:
    _, book = json.load(sys.stdin)
    typeset(book["items"])
    json.dump(book, sys.stdout)
