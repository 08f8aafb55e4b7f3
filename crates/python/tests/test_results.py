"""Stored sweeps, data sets, pictures and the program."""

import doctest
import importlib
import pkgutil
import signal
import subprocess
import sys
import time

import matplotlib.pyplot as plt
import numpy as np
import pytest

import stribeck

SWEEP = """title = "small"
[axes]
f = [1.0, 100.0]
alpha = [0.1, 1.0, 10.0]
beta = { from = 10.0, to = 1000.0, points = 4, scale = "log" }
[output]
fields = ["pressure", "film_thickness"]
x = { from = -2.0, to = 2.0, points = 41 }
"""


@pytest.fixture(scope="module")
def results(tmp_path_factory):
    """A small sweep, run by the package."""
    directory = tmp_path_factory.mktemp("results")
    (directory / "small.toml").write_text(SWEEP)
    stribeck.run(directory / "small.toml", directory / "out", progress=False)
    return directory / "out"


def test_run_tells_how_far_it_is_and_opens_what_it_published(tmp_path, capfd):
    (tmp_path / "small.toml").write_text(SWEEP)
    data = stribeck.run(tmp_path / "small.toml", tmp_path / "out", threads=2)
    assert dict(data.sizes) == {"f": 2, "alpha": 3, "beta": 4, "x": 41} and data.attrs["title"] == "small"
    assert "24/24" in capfd.readouterr().err
    stribeck.run(tmp_path / "small.toml", tmp_path / "out")
    assert "case" not in capfd.readouterr().err, "nothing is left to do"


def test_a_case_is_found_by_its_place_and_by_its_id(results):
    data = stribeck.open(results)
    case = data.stribeck.nearest(alpha=2.0, beta=900.0, f=30.0)
    assert (case.alpha.item(), case.f.item()) == (1.0, 100.0) and case.beta.item() == pytest.approx(1000.0)
    assert data.stribeck.case(case["case"].item()).mu_v.item() == case.mu_v.item()
    assert data.stribeck.curve(f=1, alpha=1).mu_v.dims == ("beta",)
    assert not data.stribeck.failed.any()
    for call, told in [
        (lambda: data.stribeck.case("0"), "no case '0'"),
        (lambda: data.stribeck.nearest(gamma=1), "gamma is no dimension"),
        (lambda: data.stribeck.curve(f=1), "are left: name the others"),
        (data.stribeck.plot_surface, "over two dimensions"),
        (lambda: data.stribeck.plot_profile(f=1), "a profile is of one case"),
        (data.drop_vars(["pressure", "film_thickness"]).stribeck.plot_profile, "has no fields"),
    ]:
        with pytest.raises(stribeck.InputError, match=told):
            call()


def test_pictures_show_the_numbers(results):
    data = stribeck.open(results)
    axes = data.stribeck.plot_curve(f=1, alpha=1)
    drag, *parts = (line.get_ydata() for line in axes.lines)
    np.testing.assert_array_equal(drag, data.stribeck.curve(f=1, alpha=1).mu_drag)
    np.testing.assert_allclose(np.sum(parts, axis=0), drag)
    assert len(data.stribeck.plot_curve(f=1).lines) == 3
    assert data.stribeck.plot_surface("mu_tot", f=1).get_ylabel() == "α"
    profile = data.stribeck.plot_profile(f=1, alpha=1, beta=100)
    assert len(profile.lines) == 2 and "2N/(pi a0)" in profile.get_legend().get_texts()[0].get_text()
    plt.close("all")


def test_what_is_no_sweep_and_no_results_is_told_with_a_remedy(tmp_path):
    with pytest.raises(stribeck.InputError, match="check the path"):
        stribeck.run(tmp_path / "nowhere.toml")
    (tmp_path / "wrong.toml").write_text("[axes]\nf = [1.0]\nalpa = [1.0]\n")
    with pytest.raises(stribeck.InputError, match="did you mean `alpha`"):
        stribeck.run(tmp_path / "wrong.toml")
    with pytest.raises(stribeck.StorageError, match="no such file; `stribeck run` publishes it"):
        stribeck.open(tmp_path)
    (tmp_path / "results.h5").write_text("no HDF5")
    with pytest.raises(stribeck.StorageError, match="stribeck verify"):
        stribeck.open(tmp_path)
    (tmp_path / "small.toml").write_text(SWEEP)
    (tmp_path / "file").write_text("")
    with pytest.raises(stribeck.StorageError, match="is a file"):
        stribeck.run(tmp_path / "small.toml", tmp_path / "file")


def test_the_program_has_its_exit_codes(program, tmp_path):
    assert program("--version").stdout.startswith(f"stribeck {stribeck.__version__}")
    assert program("solve", "--alpha", 1).returncode == 2
    assert program("solve", "--alpha", 1, "--beta", 1e30, "--f", 1).returncode == 3
    assert program("status", tmp_path).returncode == 4
    assert "Usage" in program("--help").stdout


def test_ctrl_c_ends_the_program_which_says_how_to_resume(program, tmp_path):
    many = SWEEP.replace("points = 4,", "points = 4000,").replace('["pressure", "film_thickness"]', "[]")
    (tmp_path / "many.toml").write_text(many)
    command = [sys.executable, str(program.path), "run", "many.toml", "--quiet"]
    running = subprocess.Popen(command, cwd=tmp_path, stderr=subprocess.PIPE, text=True)
    while not (tmp_path / "results/many/log").exists():
        time.sleep(0.01)
    time.sleep(0.5)
    running.send_signal(signal.SIGINT)
    _, said = running.communicate(timeout=30)
    assert running.returncode == 130 and "interrupted by SIGINT" in said
    # The command that it names is the one that was typed.
    assert f"{program.path} run many.toml --quiet" in said and "python" not in said.split("run many")[0].split("/")[-1]


def test_examples_of_docstrings_hold():
    names = [module.name for module in pkgutil.iter_modules(stribeck.__path__) if module.name != "_native"]
    modules = [importlib.import_module(f"stribeck.{name}") for name in names]
    results = [doctest.testmod(module) for module in modules]
    assert sum(result.attempted for result in results) >= 6
    assert not any(result.failed for result in results)
