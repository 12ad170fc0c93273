"""Every numbered equation of docs/theory.md against what the code computes: equations.py, in the project's folder.

`cargo test` writes random samples of all symbols to target/equations.json. A symbol with several values is one that a sum runs
over. Equations become Python, which evaluates both sides. An equation whose left side is one unknown symbol defines it, and
another equation must use it.
"""

import functools
import json
import pathlib
import re

import numpy


class Matrix(numpy.ndarray):
    """Matrices along a first axis, the terms of sums; numbers have one row and one column."""

    def __mul__(self, other):
        numbers = [numpy.shape(factor)[1:] in [(), (1, 1)] for factor in (self, other)]
        return numpy.multiply(self, other) if any(numbers) else self @ other

    def __pow__(self, exponent):
        is_inverse = numpy.ndim(exponent) == 0 and exponent == -1 and self.shape[-1] > 1
        return numpy.linalg.inv(self) if is_inverse else numpy.power(self, exponent)

    def transposed(self):
        return self.swapaxes(1, 2)


def matrix(rows):
    entries = numpy.broadcast_arrays(*(numpy.ravel(entry) for row in rows for entry in row))
    return numpy.stack(entries, axis=1).reshape(-1, len(rows), len(rows[0])).view(Matrix)


FUNCTIONS = {name: getattr(numpy, name) for name in ["sqrt", "exp", "sin", "cos", "cosh"]} | {
    "ln": numpy.log,
    "min": lambda *values: functools.reduce(numpy.minimum, values),
    "norm": lambda value: numpy.sqrt(numpy.square(value).sum(axis=(1, 2), keepdims=True)),
    "sum": lambda terms: terms.sum(axis=0, keepdims=True),
    "matrix": matrix,
    "SIGN1": numpy.reshape([1.0, -1.0], (2, 1, 1)).view(Matrix),  # ±
}
WORDS = {rf"\{name}": f" {name} " for name in FUNCTIONS} | {
    r"\begin{pmatrix}": " matrix([[", r"\cr": "],[", "&": ",", r"\end{pmatrix}": "]])", r"\lvert": " norm(", r"\rvert": ")",
    r"^\top": ".transposed()", "^": "**", r"\pm": "+SIGN1*", r"\frac": r"\frac", r"\left": "", r"\right": "",
}
SYMBOL = (
    r"(?:\\(?:Delta|delta|partial|mathbf|boldsymbol|bar|dot) ?)*(?:\\[a-zA-Z]+|[a-zA-Z]|(?<=dot)\{\\(?:bar|mathbf) ?\\?[a-z]+\})"
    r"(?:_(?:\{[^{}]*\}|\\[a-z]+|.))?'?"
)
TOKEN = re.compile(rf"\\(?:begin|end){{pmatrix}}|\^\\top|[&^]|{SYMBOL}")


def plain(symbol):
    return re.sub("[{} ]", "", symbol)


def python(latex, names):
    """A side of an equation as Python, in which `S` and its place in `names` stand for a symbol."""

    def word(token):
        if token[0].startswith(r"\sum_"):
            return " sum "
        if token[0] in WORDS:
            return WORDS[token[0]]
        name = plain(token[0])
        if name not in names:
            names.append(name)
        return f" S{names.index(name)} "

    code, before = TOKEN.sub(word, latex), ""
    while code != before:
        before = code
        code = re.sub(r"\\frac *\{([^{}]*)\} *\{([^{}]*)\}", r"((\1)/(\2))", code)
        code = re.sub(r"(?<!frac)(?<!\})\{([^{}]*)\}(?!\{)", r"(\1)", code)
    code = re.sub(r"\b(sqrt|ln|sin|cos|exp) +(S\d+)", r"\1(\2)", code)
    # A sum runs over the product that follows.
    code = re.sub(r"sum ((?:[^-+()]|\((?:[^()]|\([^()]*\))*\))*)", r"sum(\1)", code)
    return re.sub(r"(?<=[\d)]) *(?=[A-Za-z(])", "*", code).strip()


def hold(equation, values, error, idle):
    """Compares the sides of an equation, or defines the symbol on its left; symbols are idle from their definition to their use."""
    names = []
    sides = [python(side, names) for side in equation.split("=")]
    is_definition = sides[0] == "S0" and names[0] not in values
    idle.difference_update(names[is_definition:])
    known = FUNCTIONS | {f"S{index}": values[name] for index, name in enumerate(names) if name in values}
    evaluated = [eval(side, known) for side in sides[is_definition:]]
    if is_definition:
        values[names[0]] = evaluated[0]
        idle.add(names[0])
        return
    for right in evaluated[1:]:
        left, right = numpy.broadcast_arrays(evaluated[0], right)
        difference, *largest = [numpy.abs(side).max(axis=(1, 2)) for side in (left - right, left, right)]
        wrong = (difference / numpy.maximum(*largest).clip(1e-300)).max()
        assert wrong <= error, f"{equation} is wrong by {wrong:.1e}:\n{left}\n{right}"


page = pathlib.Path("docs/theory.md").read_text()
# The rows of B as one more equation.
rows = [row.replace("$", "").split("|")[2:8] for row in page.splitlines() if re.match(r"\| \$\\Delta\\.*\|.*\|.*\|", row)]
table = r"\cr".join("&".join(row) for row in rows)
page += "\n" rf"$$ \mathbf B=\begin{{pmatrix}}{table}\end{{pmatrix}} \tag{{33}} $$"
equations = re.findall(r"^\$\$ (.*) \\tag\{(\d+)\} \$\$$", page, re.M)
assert [int(number) for _, number in equations] == [*range(1, len(equations) + 1)], "numbers from 1 on"
assert page.count("$$") == 2 * len(equations), "each equation has a line of its own"
inline = [latex for text in page.split("$$")[::2] for latex in text.split("$")[1::2] if "=" in latex]
assert not inline, f"equations in sentences: {inline}"
checks = json.loads(pathlib.Path("target/equations.json").read_text())
unchecked = {*range(1, len(equations) + 1)} - {number for check in checks for number in check["equations"]}
assert not unchecked, f"in no check of src/theory/tests.rs: {unchecked}"
for check in checks:
    for sample in check["samples"]:
        values = {plain(name): numpy.array(matrices).view(Matrix) for name, matrices in sample.items()}
        idle = set()
        for number in check["equations"]:
            for equation in equations[number - 1][0].split(r"\qquad"):
                hold(equation.strip(), values, check["error"], idle)
        assert not idle, f"in no other equation: {idle}"
print(f"{len(equations)} equations")
