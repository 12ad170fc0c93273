"""How runs behave: interrupted, side by side, many after another; and how fast the package is there."""

from __future__ import annotations

import resource
import signal
import subprocess
import sys
import threading
import time
from collections.abc import Callable
from pathlib import Path

import pytest
import stampflow as sf
from conftest import QUICKSTART

CUP = sf.Case.load(QUICKSTART)
#: Some seconds long.
FINE = CUP.with_(**{"blank.elements": 2000, "solver.strain_step": 0.002})


def test_ctrl_c_ends_a_run_and_keeps_it() -> None:
    """Trust: pressed after a tenth of some seconds; it is heard within 30 ms and a step of some 20 ms, which is far from half."""
    pressed: list[float] = []

    def press(share: float) -> None:
        if share > 0.1 and not pressed:
            pressed.append(share)
            signal.raise_signal(signal.SIGINT)

    with pytest.raises(KeyboardInterrupt) as caught:
        FINE.solve(press)
    assert isinstance(caught.value, sf.Interrupted)
    kept = caught.value.partial
    assert isinstance(kept, sf.Solution) and kept.interrupted and not kept.complete
    assert pressed[0] <= kept.load_travel["travel_mm"][-1] / 25 < 0.5
    assert len(kept.frames[-1].thickness) == 2000 and kept.summary["complete"] is False


#: Solves, says when it has begun, and how it ended.
INTERRUPTED = """
import sys
import stampflow as sf

begun = []
def progress(share):
    begun or print("begun", flush=True)
    begun.append(share)

case = sf.Case.load(sys.argv[1]).with_({"blank.elements": 2000, "solver.strain_step": 0.002})
try:
    case.solve(progress)
except KeyboardInterrupt as caught:
    travel = caught.partial.load_travel["travel_mm"]
    print(len(travel), travel[-1], caught.partial.interrupted)
"""


def test_a_signal_from_outside_ends_a_run_and_keeps_it() -> None:
    """Trust: as above; half a second after the first step."""
    command = [sys.executable, "-c", INTERRUPTED, str(QUICKSTART)]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as child:
        assert child.stdout and child.stdout.readline() == "begun\n"
        time.sleep(0.5)
        child.send_signal(signal.SIGINT)
        steps, travel, interrupted = child.stdout.read().split()
    assert child.returncode == 0 and interrupted == "True"
    assert int(steps) > 1 and 0 < float(travel) < 12.5


def test_an_exception_of_the_callback_ends_a_run() -> None:
    def progress(share: float) -> None:
        raise RuntimeError(f"no more after {share}")

    with pytest.raises(RuntimeError, match="no more after 0"):
        FINE.solve(progress)


def test_progress_rises_to_one() -> None:
    shares: list[float] = []
    CUP.with_(**{"blank.elements": 300}).solve(shares.append)
    assert shares == sorted(shares) and shares[-1] == 1.0


def test_python_goes_on_while_a_case_is_solved() -> None:
    """Trust: with the lock held throughout, nothing is counted before the run ends."""
    case = CUP.with_(**{"blank.elements": 400})
    worker = threading.Thread(target=case.solve)
    worker.start()
    counted = 0
    while worker.is_alive():
        counted += 1
        time.sleep(0.001)
    assert counted > 10


def test_two_runs_go_on_at_the_same_time() -> None:
    """Trust: with the lock held, the second begins when the first has ended."""
    case = CUP.with_(**{"blank.elements": 400})
    spans: list[tuple[float, float]] = []

    def solve() -> None:
        start = time.perf_counter()
        case.solve()
        spans.append((start, time.perf_counter()))

    in_threads(solve, 2)
    (a, b), (c, d) = spans
    assert min(b, d) - max(a, c) > 0.5 * max(b - a, d - c)


def in_threads(work: Callable[[], object], count: int) -> None:
    workers = [threading.Thread(target=work) for _ in range(count)]
    for worker in workers:
        worker.start()
    for worker in workers:
        worker.join()


def resident() -> float:
    """Memory of this process [MB]."""
    pages = int(Path("/proc/self/statm").read_text().split()[1])
    return pages * resource.getpagesize() / 1e6


@pytest.mark.skipif(not Path("/proc/self/statm").exists(), reason="no /proc")
def test_a_thousand_runs_need_no_more_memory_than_a_hundred() -> None:
    """Trust: one such solution takes 0.4 MB, so a leak of a tenth of it would grow by 36 MB."""
    case = CUP.with_(**{"blank.elements": 24})

    def run(times: int) -> None:
        for _ in range(times):
            solution = case.solve()
            solution.load_travel["punch_force_N"].sum()
            solution.frames[-1].thickness.min()
            assert solution.summary["complete"] and solution.findings

    run(100)
    before = resident()
    run(900)
    assert resident() - before < 10


def test_the_import_is_felt_by_nobody() -> None:
    """Trust: the processor's time, to which others on the machine add little; the best of some tries."""
    script = "import time; t = time.process_time(); import stampflow; print(time.process_time() - t)"
    times = [float(subprocess.check_output([sys.executable, "-c", script], text=True)) for _ in range(5)]
    assert min(times) < 0.1, times
