"""What the tests of the wheel share. They run against the package that is installed."""

import subprocess
import sys
import sysconfig
import textwrap
from pathlib import Path

import matplotlib as mpl
import pytest

import stribeck

mpl.use("agg")

ROOT = Path(__file__).parents[3]


def pytest_configure():
    """Refuse to test the sources in place of what is installed."""
    if ROOT in Path(stribeck.__file__).parents and "site-packages" not in stribeck.__file__:
        raise pytest.UsageError("these tests are for the wheel: install it (pip install .)")


@pytest.fixture(scope="session")
def program():
    """The program that the wheel brings: takes arguments and gives what it printed, stderr and exit code."""
    path = Path(sysconfig.get_path("scripts")) / "stribeck"

    def run(*arguments, **options):
        return subprocess.run(
            [sys.executable, str(path), *map(str, arguments)], capture_output=True, text=True, check=False, **options
        )

    run.path = path
    return run


HIDE = """
import importlib.machinery
find = importlib.machinery.PathFinder.find_spec
def find_spec(cls, name, *rest):
    return None if name.partition(".")[0] in {names} else find(name, *rest)
importlib.machinery.PathFinder.find_spec = classmethod(find_spec)
"""


@pytest.fixture(scope="session")
def said_without():
    """Give what some code prints in an interpreter that finds no packages of these names."""

    def run(names, code):
        script = HIDE.format(names=tuple(names)) + textwrap.dedent(code)
        done = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, check=False)
        assert done.returncode == 0, done.stderr
        return done.stdout

    return run


OIL = {"radius": "2 mm", "load": "119 N/m", "viscosity": "5.1 Pa s", "poisson_ratio": 0.5}


@pytest.fixture
def experiment():
    """A rubber in oil."""
    return stribeck.Experiment(**OIL, relaxed_modulus="75 kPa", f=10.0, retardation_time="0.1 s")
