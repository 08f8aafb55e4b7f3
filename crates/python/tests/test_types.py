"""Types: the package and typical calls under a strict checker, and the stub of the extension module."""

import subprocess
import sys

import pytest

TYPICAL = """
import matplotlib.axes
import numpy as np
import xarray
from numpy.typing import NDArray

import stribeck

cases: xarray.Dataset = stribeck.solve(1.0, np.geomspace(10, 1000, 5), 10, modes=[(1.0, 1.0)], fields=["pressure"])
again: xarray.Dataset = stribeck.solve([1, 2], cases.beta, f=1.0, roller_modes=[[1.0, 1.0]], slide_roll=0.0, threads=1)
rubber: stribeck.Material = stribeck.Material.from_prony(times=["1 s"], moduli=[1e6], relaxed_modulus="1 MPa")
rubber = stribeck.Material.from_file("rubber.csv", reference_temperature=293.15, shift_factors="factors.csv")
rubber = stribeck.Material.from_file("rubber.csv", vertical_shift="density", expansion=6e-4)
rubber.storage_and_loss(np.array([1.0]))[0].mean()
bench = stribeck.Experiment(flat=rubber, radius="2 mm", load=119.0, viscosity="5.1 Pa s", poisson_ratio=0.5)
mu: NDArray[np.float64] = bench.replace(load="2 N/mm").friction(["1 mm/s", "2 mm/s"])
curve: xarray.Dataset = bench.curve({"from": 1e-4, "to": 1.0, "points": 31, "scale": "log"})
ax: matplotlib.axes.Axes = bench.plot(np.geomspace(1e-4, 1, 31))
curve.stribeck.plot_curve(ax=ax)
found: stribeck.Fit = stribeck.fit({"speed": [1e-3], "mu": mu}, bench, "viscosity", bounds={"viscosity": (0, None)})
viscosity: float = found.values["viscosity"] + found.errors["viscosity"]
data: xarray.Dataset = stribeck.run("sweep.toml", "results", progress=False)
data = stribeck.open("results")
surface = stribeck.Surface("surface.json")
drag: NDArray[np.float64] = surface(alpha=1.0, beta=[10, 20])["mu_drag"]
values, slopes = surface(1.0, 10.0, derivatives=True)
drag = slopes["mu_drag"]["beta"]
try:
    stribeck.solve(-1.0, 1.0, 1.0)
except stribeck.InputError as error:
    told: str = str(error)
"""
# The comment of a line is the kind of error that it is.
WRONG = """
import stribeck

stribeck.solve(1.0, 10.0)  # call-arg
stribeck.solve(1.0, 10.0, 1.0, threads="two")  # arg-type
stribeck.solve(1.0, 10.0, 1.0, tolerence=1e-6)  # call-arg
stribeck.run(3)  # arg-type
text: str = stribeck.Experiment(radius=1.0).friction(1.0)  # assignment
stribeck.Material.from_file("rubber.csv", terms="auto")  # arg-type
stribeck.Material.from_file("rubber.csv", vertical_shift="up")  # arg-type
number: float = stribeck.Surface("surface.json")(1.0, derivatives=True)  # assignment
"""


def mypy(*arguments, directory):
    command = [sys.executable, "-m", *arguments]
    return subprocess.run(command, cwd=directory, capture_output=True, text=True, check=False)


@pytest.fixture(scope="module")
def checked(tmp_path_factory):
    """What a strict checker says of the package and of both files."""
    directory = tmp_path_factory.mktemp("types")
    (directory / "typical.py").write_text(TYPICAL)
    (directory / "wrong.py").write_text(WRONG)
    return mypy("mypy", "--strict", "-m", "typical", "-m", "wrong", "-p", "stribeck", directory=directory)


def test_the_package_and_typical_calls_are_strictly_typed(checked):
    said = [line for line in checked.stdout.splitlines() if not line.startswith(("wrong.py", "Found"))]
    assert not said and not checked.stderr, checked.stdout + checked.stderr


def test_wrong_calls_are_found(checked):
    told = [line.partition("  # ")[2] for line in WRONG.splitlines()]
    expected = [f"wrong.py:{i + 1}: [{kind}]" for i, kind in enumerate(told) if kind]
    found = [line for line in checked.stdout.splitlines() if line.startswith("wrong.py") and ": error:" in line]
    assert [line.partition(": error:")[0] + ": " + line.rsplit("  ", 1)[1] for line in found] == expected


def test_the_stub_is_that_of_the_extension_module(tmp_path):
    done = mypy("mypy.stubtest", "stribeck._native", directory=tmp_path)
    assert done.returncode == 0, done.stdout + done.stderr
