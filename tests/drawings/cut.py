"""Cuts drawings down to what says something of a tool: python cut.py FILE.dxf ..."""
import sys

HEADER = {"$ACADVER", "$INSUNITS", "$MEASUREMENT", "$DWGCODEPAGE"}


def pairs(path):
    lines = open(path, encoding="utf-8", newline="").read().splitlines()
    return [(int(lines[i]), lines[i + 1]) for i in range(0, len(lines) - 1, 2)]


def groups(body, starts):
    """The pairs in groups, each beginning with one that `starts`."""
    all = []
    for pair in body:
        if starts(pair) or not all:
            all.append([])
        all[-1].append(pair)
    return all


def cut(path):
    kept, sections = [], groups(pairs(path), lambda pair: pair == (0, "SECTION"))
    text = [value for section in sections for code, value in section if code == 2]
    for section in sections:
        name = next((value for code, value in section if code == 2), "")
        if name == "HEADER":
            variables = groups(section, lambda pair: pair[0] in (0, 9))
            section = [p for group in variables if group[0][0] == 0 or group[0][1] in HEADER for p in group]
        elif name == "TABLES":
            tables = groups(section, lambda pair: pair in ((0, "TABLE"), (0, "ENDSEC")))
            section = [p for table in tables if table[0][0] == 0 and (2, "LAYER") in table[:2] or table[0] != (0, "TABLE") for p in table]
        elif name == "BLOCKS":
            blocks = groups(section, lambda pair: pair in ((0, "BLOCK"), (0, "ENDSEC")))
            named = lambda block: next(value for code, value in block if code == 2)
            used = lambda block: text.count(named(block)) > 2 and not named(block).startswith("*")
            section = [p for block in blocks if block[0] != (0, "BLOCK") or used(block) for p in block]
        elif name not in ("ENTITIES",):
            continue
        kept += section
    if (0, "EOF") in sections[-1] and kept[-1] != (0, "EOF"):
        kept.append((0, "EOF"))
    open(path, "w", encoding="utf-8", newline="\n").write("".join(f"{code}\n{value}\n" for code, value in kept))


for path in sys.argv[1:]:
    cut(path)
