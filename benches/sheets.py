#!/usr/bin/env python3
"""Erichsen index and limiting draw ratio of every sheet made from a band, beside the literature's.

    cargo build --release && benches/sheets.py > benches/measured/made_sheets.csv

The index is the punch travel at the largest force in the template `erichsen` (1 mm, friction 0.08); the ratio is found by
`search --for limiting-draw-ratio` in the template `cup` with a punch of 60 mm and the holder by Siebel's rule.
"""
import csv
import json
import os
import subprocess
import tempfile

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..")
PROGRAM = os.environ.get("STAMPFLOW", os.path.join(ROOT, "target", "release", "stampflow"))


def run(*words):
    done = subprocess.run([PROGRAM, *words], capture_output=True, text=True, check=False)
    assert done.returncode in (0, 3), (words, done.stderr)
    return done.stdout


def erichsen(name, folder):
    case, out = os.path.join(folder, "e.toml"), os.path.join(folder, "e")
    run("new", "erichsen", "--material", name, "--thickness", "1 mm", "-o", case, "--force")
    run("run", case, "--out", out, "--no-advice", "--quiet")
    with open(os.path.join(out, "load_travel.csv"), encoding="utf8") as file:
        rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
    return float(max(rows, key=lambda row: float(row["punch_force_N"]))["travel_mm"])


def draw_ratio(name, folder):
    case, out = os.path.join(folder, "c.toml"), os.path.join(folder, "c")
    run("new", "cup", "--material", name, "--punch-diameter", "60 mm", "-o", case, "--force")
    found = json.loads(run("search", case, "--for", "limiting-draw-ratio", "--json", "--restart", "--out", out))
    return next(note.split()[2].strip(",") for note in found["notes"] if note.startswith("Draw ratio"))


def literature(grade):
    with open(os.path.join(ROOT, "reference_data", "erichsen_ldr.csv"), encoding="utf8") as file:
        rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
    rows = [row for row in rows if row["grade"].startswith(grade)]
    own = max(([row for row in rows if row["thickness_mm"] == t] for t in ("1.0", "0.8")), key=bool)
    values = [row["erichsen_typ_mm"] for row in own]
    at = "" if not own or own[0]["thickness_mm"] == "1.0" else f" at {own[0]['thickness_mm']} mm"
    return " to ".join(sorted(set(values), key=float)) + at, own[0]["how_read"] if own else ""


def main():
    sheets = [sheet for sheet in json.loads(run("materials", "--json")) if sheet["made"]]
    print("sheet,erichsen_mm,erichsen_literature_mm,grade,limiting_draw_ratio,draw_ratio_literature")
    with tempfile.TemporaryDirectory() as folder:
        for sheet in sheets:
            name = sheet["name"]
            index, grade = literature(name if name.startswith("1.") else name.upper())
            print(f"{name},{erichsen(name, folder):.1f},{index},{grade},{draw_ratio(name, folder)},", flush=True)


if __name__ == "__main__":
    main()
