"""Compares the tables of two folders of results, here those of Linux and Windows: `windows.py LINUX WINDOWS`.

Two numbers are equal if they differ by no more than 1e-6 of the largest in their column, at least 1e-9 in its unit, below which are
the roundings of a zero. What the solver's iterations leave, the norms, is no result. Prints the largest difference of each
case and exits with 1 if one is larger or a table or a row is missing.
"""

import csv
import pathlib
import sys

TOLERANCE = 1e-6
ZERO = 1e-9
NORMS = ("velocity_norm", "residual_norm")


def columns(path):
    rows = list(csv.reader(path.open(encoding="utf-8", newline="")))
    return list(zip(*rows)), len(rows)


def number(cell):
    try:
        return float(cell)
    except ValueError:
        return None


def differences(ours, theirs):
    """Largest difference of each column over its largest number, with its place; text that differs counts as 1."""
    (a, rows), (b, others) = columns(ours), columns(theirs)
    if len(a) != len(b) or rows != others:
        return [(1.0, f"{ours.name}: {rows} rows and {others}")]
    found = []
    for x, y in zip(a, b):
        if x[0] in NORMS:
            continue
        numbers = [number(cell) for cell in x]
        scale = max((abs(n) for n in numbers if n is not None), default=0.0)
        scale = max(scale, ZERO)
        for row, (n, cell) in enumerate(zip(numbers, y)):
            m = number(cell)
            size = abs(n - m) / scale if n is not None and m is not None else float(x[row] != cell)
            found.append((size, f"{ours.name}, {x[0]}, row {row}: {x[row]} and {cell}"))
    return found


def main():
    linux, windows = map(pathlib.Path, sys.argv[1:3])
    failed = False
    tables = sorted(linux.rglob("*.csv"))
    worst = {}
    for table in tables:
        case, other = table.relative_to(linux).parts[0], windows / table.relative_to(linux)
        size, place = max(differences(table, other)) if other.is_file() else (1.0, f"{table.name} is missing")
        worst[case] = max(worst.get(case, (0.0, "")), (size, place))
    for case, (size, place) in worst.items():
        failed |= size > TOLERANCE
        print(f"{size:.1e}  {case}: {place}" if size else f"equal    {case}")
    print(f"{len(tables)} tables of {len(worst)} cases, largest difference {max(size for size, _ in worst.values()):.1e}")
    sys.exit(failed or not tables)


main()
