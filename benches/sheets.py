#!/usr/bin/env python3
"""Erichsen index and limiting draw ratio of every sheet made from a band, beside the literature's.

    cargo build --release && benches/sheets.py > benches/measured/made_sheets.csv
    benches/sheets.py --influences > benches/measured/made_sheets_influences.csv

The index is the punch travel at the largest force in the template `erichsen` (1 mm, friction 0.08); the ratio is found by
`search --for limiting-draw-ratio` in the template `cup` with a punch of 60 mm and the holder by Siebel's rule. The influences
are those on the index of the two sheets that the literature has.
"""
import csv
import json
import math
import os
import subprocess
import sys
import tempfile

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..")
PROGRAM = os.environ.get("STAMPFLOW", os.path.join(ROOT, "target", "release", "stampflow"))


def run(*words):
    done = subprocess.run([PROGRAM, *words], capture_output=True, text=True, check=False)
    assert done.returncode in (0, 3), (words, done.stderr)
    return done.stdout


def erichsen(name, folder, thickness="1 mm", overrides=()):
    case, out = os.path.join(folder, "e.toml"), os.path.join(folder, "e")
    run("new", "erichsen", "--material", name, "--thickness", thickness, "-o", case, "--force")
    run("run", case, "--out", out, "--no-advice", "--quiet", *(word for value in overrides for word in ("--set", value)))
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


def voce(name):
    """Voce's law with the proof stress and the load maximum of the sheet's own: beyond that it saturates."""
    sheet = json.loads(run("materials", name, "--json"))
    proof, strength, strain = (float(sheet[key]) for key in ("Rp0.2", "Rm", "n"))
    top = strength * math.exp(strain)
    low, high = 1.0001 * top, 20 * top
    for _ in range(200):
        end = 0.5 * (low + high)
        rate = top / (end - top)
        steep = (end - proof) * math.exp(-rate * (strain - 0.002)) < end - top
        low, high = (end, high) if steep else (low, end)
    first = end - (end - proof) * math.exp(0.002 * rate)
    return f'material.hardening={{ voce = {{ saturation = "{end} MPa", initial = "{first} MPa", rate = {rate} }} }}'


def influences():
    sheets = {"1.4301": "1 mm", "1.4016": "0.8 mm"}
    ball = "tools.punch.friction="
    changes = {"none": lambda _: []}
    changes |= {f"friction of the ball {value} for 0.08": lambda _, value=value: [f"{ball}{value}"] for value in (0, 0.04, 0.12)}
    changes |= {
        "Voce's law for Swift's": lambda name: [voce(name)],
        "Voce's law and no friction of the ball": lambda name: [voce(name), f"{ball}0"],
        "r = 1.5": lambda _: ["material.anisotropy=1.5"],
        "weakest coil of the band": lambda _: ['material.coil="weak"'],
        "600 elements for 160": lambda _: ["blank.elements=600"],
    }
    print("change," + ",".join(f"{name} at {thickness}" for name, thickness in sheets.items()))
    with tempfile.TemporaryDirectory() as folder:
        for change, overrides in changes.items():
            found = [erichsen(name, folder, thickness, overrides(name)) for name, thickness in sheets.items()]
            print(change, *(f"{index:.1f}" for index in found), sep=",", flush=True)


def main():
    sheets = [sheet for sheet in json.loads(run("materials", "--json")) if sheet["made"]]
    print("sheet,erichsen_mm,erichsen_literature_mm,grade,limiting_draw_ratio,draw_ratio_literature")
    with tempfile.TemporaryDirectory() as folder:
        for sheet in sheets:
            name = sheet["name"]
            index, grade = literature(name if name.startswith("1.") else name.upper())
            print(f"{name},{erichsen(name, folder):.1f},{index},{grade},{draw_ratio(name, folder)},", flush=True)


if __name__ == "__main__":
    influences() if "--influences" in sys.argv else main()
