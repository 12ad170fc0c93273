"""Every template makes the whole round: new, check, run, report, export, import. `round.py PROGRAM`.

The tools that import reads are those that export wrote, each end and centre within 1e-6 mm. A template without a punch, which import
refuses, ends with its drawing.
"""

import csv
import json
import pathlib
import subprocess
import sys
import tempfile
import tomllib

TOLERANCE = 1e-6
TOOLS = ("PUNCH", "DIE", "HOLDER")
program = str(pathlib.Path(sys.argv[1]).resolve())


def stampflow(folder, *words, codes=(0,)):
    done = subprocess.run([program, *words], cwd=folder, capture_output=True, text=True)
    if done.returncode not in codes:
        raise SystemExit(f"stampflow {' '.join(words)}: exit code {done.returncode}\n{done.stdout}{done.stderr}")
    return done.stdout


def drawn(folder):
    """Numbers of each tool's lines and arcs, ends before centres, by layer."""
    tools = {}
    for row in csv.DictReader((folder / "tools.csv").open()):
        if row["layer"].rpartition("_")[2] in TOOLS:
            piece = [row[key] for key in ("r0_mm", "z0_mm", "r1_mm", "z1_mm", "centre_r_mm", "centre_z_mm")]
            tools.setdefault(row["layer"], []).append([float(number) for number in piece if number])
    return tools


def read(folder):
    """The same of an imported case; of one operation its layers have no prefix."""
    case = tomllib.loads((folder / "again.toml").read_text(encoding="utf-8"))
    tools = {}
    for i, stage in enumerate([case["tools"], *case.get("stages", [])]):
        for role in TOOLS:
            steps = stage.get(role.lower(), {}).get("profile", [])
            points = [{key: [float(text.split()[0]) for text in step[key]] for key in step if key != "turn"} for step in steps]
            ends = [next(step[key] for key in ("from", "to", "arc_to") if key in step) for step in points]
            pieces = [a + b + step.get("center", []) for a, b, step in zip(ends, ends[1:], points[1:])]
            if pieces:
                tools[f"OP{10 * (i + 1)}_{role}"] = pieces
    return tools


def apart(a, b):
    same = len(a) == len(b) and all(len(x) == len(y) for x, y in zip(a, b))
    return max(abs(p - q) for x, y in zip(a, b) for p, q in zip(x, y)) if same else float("inf")


worst, failed = 0.0, []
for name in [template["name"] for template in json.loads(stampflow(".", "new", "--list", "--json"))]:
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        stampflow(folder, "new", name, "-o", "case.toml")
        stampflow(folder, "check", "case.toml")
        stampflow(folder, "run", "case.toml", "--quiet", "--no-advice")
        stampflow(folder, "report", "case.toml", "--quiet", "--no-advice", "--no-error-bars")
        for ending in ("csv", "dxf"):
            stampflow(folder, "export", "case.toml", "--quiet", "-o", f"tools.{ending}")
        tools = drawn(folder)
        case = tomllib.loads((folder / "case.toml").read_text(encoding="utf-8"))
        stampflow(folder, "import", "tools.dxf", "--geometry", case["geometry"], "--axis", "0 mm", "-o", "again.toml")
        again = {layer if layer in tools else layer.partition("_")[2]: pieces for layer, pieces in read(folder).items()}
        most = max((apart(pieces, again.get(layer, [])) for layer, pieces in tools.items()), default=float("inf"))
        print(f"{name}: {len(tools)} tools, {most:.1e} mm")
        worst = max(worst, most)
        if most > TOLERANCE or tools.keys() != again.keys():
            failed.append(f"{name}: {most} mm apart; {sorted(tools)} and {sorted(again)}")
print(f"largest difference {worst:.1e} mm")
sys.exit("\n".join(failed) or 0)
