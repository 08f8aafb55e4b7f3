"""Threads, forks, Ctrl-C, pools of processes, and memory."""

import concurrent.futures
import gc
import multiprocessing
import os
import signal
import threading
import time

import numpy as np
import psutil
import pytest

import stribeck


def friction(beta):
    """Solve a case."""
    return stribeck.solve(1.0, beta, 10.0).mu_tot.item()


def test_a_pool_of_processes_solves_after_a_fork_and_in_new_interpreters():
    points = ([1.0, 1.0, 2.0], [10.0, 20.0, 30.0], [10.0, 10.0, 10.0])
    expected = list(map(stribeck.solve, *points))
    for start in ("fork", "spawn"):
        context = multiprocessing.get_context(start)
        with concurrent.futures.ProcessPoolExecutor(2, context) as pool:
            for case, again in zip(expected, pool.map(stribeck.solve, *points, timeout=30), strict=True):
                assert again.identical(case), start


def test_threads_of_python_solve_at_the_same_time():
    expected = friction(20.0)
    with concurrent.futures.ThreadPoolExecutor(4) as pool:
        assert list(pool.map(friction, [20.0] * 8)) == [expected] * 8


def interrupted(work, ready):
    """Send Ctrl-C to some work as soon as it is ready; tell how long the work went on after it."""
    sent = []

    def send():
        while not ready():
            time.sleep(0.01)
        sent.append(time.monotonic())
        os.kill(os.getpid(), signal.SIGINT)

    sender = threading.Thread(target=send)
    with pytest.raises(KeyboardInterrupt):
        sender.start()
        work()
        # Ctrl-C that comes too late ends the wait, not the tests.
        time.sleep(10.0)
    sender.join()
    return time.monotonic() - sent[0]


def test_ctrl_c_ends_a_long_call_soon():
    alpha, beta = np.geomspace(0.01, 100, 100)[:, None], np.geomspace(1, 1e4, 1000)
    begin = time.monotonic()
    after = interrupted(
        lambda: stribeck.solve(alpha, beta, 100.0, tolerance=1e-9), ready=lambda: time.monotonic() > begin + 0.5
    )
    assert after < 3.0
    assert friction(20.0) > 0.0


def test_ctrl_c_stops_a_run_which_the_same_call_resumes(tmp_path, program):
    sweep = tmp_path / "long.toml"
    sweep.write_text(
        '[axes]\nf = [10.0, 100.0]\nalpha = { from = 0.1, to = 10.0, points = 10, scale = "log" }\n'
        'beta = { from = 10.0, to = 1000.0, points = 256, scale = "log" }\n[output]\nfields = []\n'
    )
    stopped, whole = tmp_path / "stopped", tmp_path / "whole"
    interrupted(lambda: stribeck.run(sweep, stopped, progress=False), lambda: any((stopped / "shards").glob("*.h5")))
    assert not (stopped / "summary.csv").exists()
    stribeck.run(sweep, stopped, progress=False)
    run = program("run", sweep, "-o", whole, "--quiet")
    assert run.returncode == 0, run.stderr
    for name in ("summary.csv", "results.h5"):
        assert (stopped / name).read_bytes() == (whole / name).read_bytes(), name


def resident(call, calls):
    """Bytes that a process has in memory before some calls and after them, after a hundredth of these to warm up."""
    process = psutil.Process()
    for _ in range(calls // 100 + 100):
        call()
    gc.collect()
    before = process.memory_info().rss
    for _ in range(calls):
        call()
    gc.collect()
    return before, process.memory_info().rss


def refuse():
    with pytest.raises(stribeck.InputError):
        stribeck.solve(-1.0, 20.0, 0.0)


SMALL = stribeck.Material.from_prony(times=[1.0], moduli=[1e6], relaxed_modulus=1e6, poisson_ratio=0.5)
SURFACE = stribeck.Surface()
CALLS = {
    "a case": lambda: stribeck.solve(1.0, 20.0, 0.0, threads=1),
    "a case with fields": lambda: stribeck.solve(1.0, 20.0, 0.0, fields=True, x=[0.0, 1.0], threads=2),
    "what is refused": refuse,
    "an experiment": lambda: stribeck.Experiment(flat=SMALL, radius="5 mm", load=200.0, viscosity=1.0),
    "a surface": lambda: SURFACE(1.0, 20.0, 1.0),
}


@pytest.mark.parametrize("name", CALLS)
def test_calls_leak_no_memory(name):
    before, after = resident(CALLS[name], 1000)
    # A kilobyte a call would be seen.
    assert after - before < 1_000_000


def test_many_readings_of_a_quantity_leak_no_memory():
    def read():
        with pytest.raises(stribeck.InputError):
            stribeck._native.si("radius", "-1.0")
        stribeck._native.si("radius", '"2 mm"')

    before, after = resident(read, 50_000)
    # A kilobyte for each hundred calls would be seen.
    assert after - before < 1 << 20


@pytest.mark.slow
@pytest.mark.parametrize("name", [name for name in CALLS if name != "a case"])
def test_a_hundred_thousand_calls_leak_no_memory(name, monkeypatch):
    # What xarray makes of the arrays takes longer than to solve a case, and is not of this package.
    monkeypatch.setattr("stribeck._datasets.find_spec", lambda _: None)
    before, after = resident(CALLS[name], 100_000)
    print(f"{name}: {before / 1e6:.1f} MB before and {after / 1e6:.1f} MB after 100000 calls")
    # 20 bytes a call would be seen.
    assert after - before < 2_000_000
