"""What works where packages that are not required are missing, and what is said of the rest."""

import json

import numpy as np
import pytest

OIL = {"radius": "2 mm", "load": "119 N/m", "viscosity": "5.1 Pa s", "poisson_ratio": 0.5}
ALL = ["h5netcdf", "h5py", "matplotlib", "pandas", "pint", "tqdm", "xarray"]


def test_numpy_alone_is_enough_to_solve_and_fit(experiment, said_without):
    speed = [1e-3, 1e-2, 1e-1]
    mu = experiment.friction(speed)
    said = said_without(
        ALL,
        f"""
        import json, sys, numpy as np, stribeck
        experiment = stribeck.Experiment(**{OIL}, relaxed_modulus="75 kPa", f=10.0, retardation_time="0.1 s")
        speed = {speed}
        mu = experiment.friction(speed)
        curve = experiment.curve(speed)
        assert curve.dims["mu_drag"] == ("f", "speed") and curve.attrs["film_min"]["units"] == "m"
        found = stribeck.fit({{"speed": speed, "mu": mu}}, experiment.replace(viscosity=3.0), "viscosity")
        material = stribeck.Material.from_prony(times=[1.0], moduli=[1e6], relaxed_modulus=1e6)
        assert not set({ALL}) & set(sys.modules) and material.f == 1.0
        print(json.dumps([mu.tolist(), curve["mu_drag"].ravel().tolist(), found.values["viscosity"]]))
        """,
    )
    friction, curve, viscosity = json.loads(said)
    np.testing.assert_array_equal(friction, mu)
    assert curve == friction and viscosity == pytest.approx(5.1, rel=1e-4)


@pytest.mark.parametrize(
    ("missing", "call"),
    [
        ("xarray", "stribeck.open('results')"),
        ("xarray", "stribeck.run('sweep.toml')"),
        ("h5netcdf", "stribeck.run('sweep.toml')"),
        ("matplotlib", "material.plot()"),
        ("matplotlib", "stribeck.solve(1.0, [1.0, 2.0], 1.0).stribeck.plot_curve()"),
        ("xarray", "experiment.plot([1e-3, 1e-2])"),
    ],
)
def test_what_is_missing_is_named_with_how_to_install_it(missing, call, said_without):
    said = said_without(
        [missing],
        f"""
        import stribeck
        experiment = stribeck.Experiment(**{OIL}, relaxed_modulus="75 kPa", f=10.0, retardation_time="0.1 s")
        material = stribeck.Material.from_prony(times=[1.0], moduli=[1e6], relaxed_modulus=1e6)
        try:
            {call}
        except ImportError as error:
            print(error.name, error)
        """,
    )
    assert (
        said.startswith(f"{missing} ")
        and f'needs {missing}, which is not installed here: pip install {missing}, or "st' in said
    )


def test_all_that_is_missing_is_named_at_once(said_without):
    said = said_without(
        ALL,
        f"""
        import stribeck
        experiment = stribeck.Experiment(**{OIL}, relaxed_modulus="75 kPa", f=10.0, retardation_time="0.1 s")
        for call in (lambda: experiment.plot([1e-3]), lambda: stribeck.run("sweep.toml")):
            try:
                call()
            except ImportError as error:
                print(error)
        """,
    )
    picture, stored = said.splitlines()
    assert picture == (
        "a picture of a curve needs xarray and matplotlib, which are not installed here: "
        'pip install xarray matplotlib, or "stribeck[all]"'
    )
    assert 'pip install xarray h5netcdf h5py, or "stribeck[all]"' in stored


def test_arrays_by_name_say_what_they_are_and_what_they_have_not(said_without):
    said = said_without(
        ["xarray"],
        """
        import copy, pickle, stribeck
        case = stribeck.solve(1.0, [10.0, 20.0], 1.0, fields="pressure")
        print(case)
        for name in ("mu_drag", "stribeck"):
            try:
                getattr(case, name)
            except AttributeError as error:
                print(error)
        assert copy.deepcopy(case).dims == pickle.loads(pickle.dumps(case)).dims == case.dims
        """,
    )
    lines = said.splitlines()
    assert (
        "  mu_drag (beta: 2) " in said and "  pressure (beta: 2, x: 601) " in said and "  c (beta: 2) [a0^2/R] " in said
    )
    assert max(map(len, lines[:-2])) <= 80 and len(lines) < 60
    assert lines[-2].endswith("not installed here: take ['mu_drag']")
    assert lines[-1].endswith("install xarray for a data set that may have .stribeck")


def test_progress_is_a_line_without_tqdm(tmp_path, said_without):
    (tmp_path / "small.toml").write_text("[axes]\nf = [1.0]\nalpha = [1.0]\nbeta = [10.0, 20.0, 1e30]\n")
    said = said_without(
        ["tqdm"],
        f"""
        import contextlib, sys, stribeck
        with contextlib.redirect_stderr(sys.stdout):
            stribeck.run({str(tmp_path / "small.toml")!r}, {str(tmp_path / "out")!r})
        """,
    )
    assert said == "3 of 3 cases, 1 failed\n"
