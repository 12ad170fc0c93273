"""Each of the ten lessons of lessons.json shows what it says."""

from __future__ import annotations

import json
import math
import re
from typing import Any

import numpy as np
import pytest
import stampflow as sf
from conftest import ROOT

LESSONS = json.loads((ROOT / "bindings" / "lessons.json").read_text(encoding="utf-8"))
TITLES = [lesson["title"] for lesson in LESSONS]


def case(title: str, value: Any = None) -> sf.Case:
    """Case of a lesson with a value of its control."""
    lesson = LESSONS[TITLES.index(title)]
    control = lesson["control"]
    settings = dict(setting.split("=", 1) for setting in lesson.get("overrides", []))
    if value is not None:
        assert value in control["values"], f"{title}: the control has no {value}"
        settings[control["key"]] = f"{value} {control['unit']}" if "unit" in control else value
    return sf.new(lesson["template"], **lesson.get("given", {})).with_(settings)


def peak(solution: sf.Solution) -> float:
    return float(solution.stages[0].load_travel[force_of(solution)].max())


def force_of(solution: sf.Solution) -> str:
    return next(name for name in solution.stages[0].load_travel if name.startswith("punch_force"))


def at(solution: sf.Solution, travel: float, column: str) -> float:
    """Value in the step that ends at a frame."""
    load = solution.stages[0].load_travel
    [row] = np.isclose(load["travel_mm"], travel).nonzero()[0]
    return float(load[column][row])


def test_every_lesson_is_on_its_page_and_in_its_notebook() -> None:
    page = (ROOT / "docs" / "lessons.md").read_text(encoding="utf-8")
    assert re.findall(r"^## (.*)$", page, re.MULTILINE) == TITLES
    notebook = json.loads((ROOT / "bindings" / "python" / "notebooks" / "lessons.ipynb").read_text(encoding="utf-8"))
    headings = re.findall(r"^## \d+ · (.*)$", "\n".join("".join(cell["source"]) + "\n" for cell in notebook["cells"]), re.MULTILINE)
    assert headings == TITLES
    for lesson in LESSONS:
        control = lesson["control"]
        assert control["key"].rpartition(".")[2] in page and control.get("value", control["values"][0]) in control["values"]


def test_only_the_flange_flows_in_the_end() -> None:
    """Ten cut-offs tell what flows: there the cut-off takes 0.5 % off the viscosity, as √(1 + 0.1²) does."""
    share = {}
    for step in (5, 80):
        trace = case("What flows").trace(step)
        [end] = (history.iterates[-1] for history in trace.values())
        elements, rigid = end.elements, end.elements["cut_off"] > 0.5
        share[step] = rigid.mean()
        own = elements["yield_stress_MPa"] * trace.duration / (3.0 * elements["strain_increment"])
        assert np.allclose(elements["viscosity_MPa_s"][~rigid], own[~rigid], rtol=6e-3)
    assert share[5] < 0.2 and share[80] > 0.7
    # The die's throat of 31.3 mm and its shoulder: what lies beyond flows, what lies on the punch's flat does not.
    middle = 0.5 * (end.nodes["r_mm"][1:] + end.nodes["r_mm"][:-1])
    assert not rigid[middle > 34.0].any() and rigid[middle < 24.0].all()
    assert np.median(elements["viscosity_MPa_s"][rigid]) > 100.0 * np.median(elements["viscosity_MPa_s"][~rigid])


def by_hand(solution: sf.Solution) -> float:
    """F = 2π r t σ̄_y ln(R/r) of the lesson by Tresca's condition [N]."""
    load, blank, wall = solution.load_travel, 51.661, 30.5
    rim = blank - load["draw_in_mm"][load["punch_force_N"].argmax()]
    began = math.sqrt(wall**2 + blank**2 - rim**2)
    stresses = [520.0 * (0.005 + math.log(ratio)) ** 0.22 for ratio in (blank / rim, began / wall)]
    return 2.0 * math.pi * wall * float(np.mean(stresses)) * math.log(rim / wall)


def test_ideal_drawing_is_what_the_hand_computes() -> None:
    """Hosford's condition of the cup lies between Tresca's and 2/√3 of it, von Mises' in pure shear; less than 10 % measured."""
    solutions = [case("Ideal drawing, by hand and by program", friction).solve() for friction in (0, 0.04, 0.08, 0.12)]
    assert 1.0 < peak(solutions[0]) / by_hand(solutions[0]) < 1.1
    added = np.diff([peak(solution) for solution in solutions]) / peak(solutions[0])
    assert (added > 0.05).all() and (added < 0.08).all()
    assert peak(solutions[2]) > 1.1 * by_hand(solutions[2])


def test_volume_is_kept_and_the_rim_thickens_as_the_hand_says() -> None:
    """Volume to round-off of 55 sums; the rim to 0.5 %, which the holder presses off it."""
    solution = case("Volume and thickness", 22).solve()
    end = solution.frames[-1]
    r, z = end.nodes["r_mm"], end.nodes["z_mm"]
    volume = (math.pi * (r[1:] + r[:-1]) * np.hypot(np.diff(r), np.diff(z)) * end.thickness).sum()
    assert volume == pytest.approx(math.pi * 51.661**2, rel=1e-12)
    assert r[-1] < 0.8 * 51.661
    hand = math.exp(-0.5 * end.elements["strain_hoop"][-1])
    assert 0.995 * hand < end.thickness[-1] < hand and end.thickness[-1] > 1.1


def test_the_thinnest_place_moves_with_a_large_cut_off_only() -> None:
    ends = {value: case("The cut-off", value).solve() for value in (1e-6, 5e-6, 1e-5, 3e-4)}
    place = {value: solution.frames[-1].s0[solution.frames[-1].thickness.argmin()] for value, solution in ends.items()}
    thinnest = {value: solution.frames[-1].thickness.min() for value, solution in ends.items()}
    assert place[1e-6] == place[5e-6] == place[1e-5] != place[3e-4]
    # 0.1 % is less than a gauge of a thousandth of a millimetre shows.
    assert thinnest[1e-5] == pytest.approx(thinnest[1e-6], rel=1e-3) and thinnest[3e-4] < 0.99 * thinnest[1e-6]
    load = ends[3e-4].load_travel
    assert load["work_cutoff_J"][-1] > 0.1 * load["work_plastic_J"][-1]
    assert ends[3e-4].frames[-1].thickness[0] < 0.98 < 0.99 < ends[1e-6].frames[-1].thickness[0]


def test_the_predictor_saves_iterations_and_changes_no_force() -> None:
    """The steps are of other lengths: 0.1 % is between two of them at a flat maximum."""
    predicted, rested = (case("The predictor", value).solve() for value in (True, False))
    assert predicted.complete and rested.complete
    assert rested.stages[0].iterations > 3 * predicted.stages[0].iterations
    assert peak(rested) == pytest.approx(peak(predicted), rel=1e-3)


def test_newton_fails_where_the_primal_dual_matrix_does_not() -> None:
    easy, hard = (case("Secant, Newton, primal-dual").trace(step, matrices="all") for step in (20, 80))
    assert all(history.converged for history in easy.values())
    assert [name for name, history in hard.items() if not history.converged] == ["newton"]
    count = {name: len(history.iterates) - 1 for name, history in hard.items()}
    assert count["secant"] > 5 * count["primal_dual"]


def test_the_residual_stays_while_the_velocities_settle() -> None:
    [history] = case("Why two norms").trace(2).values()
    velocity, residual = history.velocity, history.residual
    assert history.converged and velocity[3] < velocity[1] / 20
    # One: the largest force out of balance is the largest force.
    assert (abs(residual[1:3] - 1.0) < 0.1).all() and velocity[3] < 2e-3 and residual[3] > 0.4
    assert residual[-1] < 1e-2


def test_soft_springs_sink_in_and_the_force_hardly_notices() -> None:
    solutions = [case("Contact", stiffness).solve() for stiffness in (0.3, 3, 30, 300)]
    sunk = [solution.load_travel["penetration"].max() for solution in solutions]
    force = [peak(solution) for solution in solutions]
    assert sunk[0] > 0.1 and sunk[3] < 0.005 and np.all(np.diff(sunk) < 0)
    # Half a per cent is what no press shows.
    assert abs(force[1] / force[3] - 1) < 5e-3 < abs(force[0] / force[3] - 1) < 2e-2
    assert np.all(np.diff([solution.stages[0].iterations for solution in solutions]) > 0)


def test_the_flow_law_has_no_first_millimetre_and_no_elastic_core() -> None:
    flow, elastic = (case("Elastic or not", mode).solve() for mode in ("flow", "elasto_viscoplastic"))
    touch = [at(solution, 0.2, force_of(solution)) for solution in (flow, elastic)]
    assert touch[0] > 2.5 * touch[1]
    assert peak(flow) == pytest.approx(peak(elastic), rel=0.03)

    def turned(solution: sf.Solution) -> float:
        drawn, released = (stage.frames[-1].nodes["theta"][-1] for stage in solution.stages)
        return math.degrees(abs(released - drawn))

    assert turned(elastic) > 4.0 > 2.0 > turned(flow)


def test_work_is_of_second_order_and_a_neck_has_no_width_of_its_own() -> None:
    """Contact points come to other places with each mesh, which scatters the order by 0.5."""
    solutions = [case("Mesh, order, and a neck", elements).solve() for elements in (15, 30, 60, 120)]
    changes = np.diff([at(solution, 34, "work_external_J") for solution in solutions])
    orders = np.log2(changes[:-1] / changes[1:])
    assert (abs(orders - 2.0) < 0.5).all(), orders
    sound = [at(solution, 34, "thinnest_mm") for solution in solutions]
    assert sound[2] == pytest.approx(sound[3], rel=1e-3)
    necked = [solution.frames[-1].thickness for solution in solutions]
    # Each halving thins the neck further; its neighbours are those of a sound sheet.
    thinnest = [thickness.min() for thickness in necked]
    assert all(fine < 0.95 * coarse for coarse, fine in zip(thinnest, thinnest[1:])) and thinnest[3] < 0.6 * thinnest[0]
    at_neck = necked[3].argmin()
    assert necked[3][[at_neck - 1, at_neck + 1]].min() > 1.5 * thinnest[3]
