"""`solve`: agreement with the program, broadcasting, and input that is wrong."""

import json
import pickle
import subprocess
import sys

import numpy as np
import pytest
import xarray

import stribeck

POINTS = [(1.0, 100.0, 10.0, 1.0), (0.1, 1e3, 100.0, 0.5), (np.inf, 50.0, 3.0, 0.0), (2.0, 3.0, 0.0, 1.0)]


@pytest.mark.parametrize("point", POINTS)
def test_one_point_has_the_numbers_of_the_program_to_the_last_bit(program, point):
    alpha, beta, f, slide_roll = point
    case = stribeck.solve(alpha, beta, f, slide_roll=slide_roll)
    options = ("--alpha", alpha, "--beta", beta, "--f", f, "--slide-roll", slide_roll)
    told = json.loads(program("solve", *options, "--json").stdout)
    assert (case["case"].item(), case["status"].item()) == (told["case"], 0)
    compared = 0
    for name, value in told.items():
        if name.startswith(("mu_", "error_", "film", "p_", "c", "dry", "approx")) and name != "case":
            expected = np.nan if value is None else value
            np.testing.assert_array_equal(case[name].item(), expected, err_msg=name)
            compared += 1
    assert compared > 15


def test_a_grid_has_the_numbers_names_and_units_of_a_published_sweep(program, tmp_path):
    (tmp_path / "s.toml").write_text(
        "[axes]\nf = [0.0, 10.0]\nalpha = [0.1, 1.0]\nbeta = [10.0, 30.0, 90.0]\n[output]\nsensitivities = true\n"
        'fields = ["pressure"]\nx = { from = -2.0, to = 2.0, points = 5 }\n'
    )
    run = program("run", "s.toml", "-o", "r", "--quiet", cwd=tmp_path)
    assert run.returncode == 0, run.stderr
    published = stribeck.open(tmp_path / "r")
    f, alpha, beta = np.array([0.0, 10.0])[:, None, None], np.array([0.1, 1.0])[:, None], [10.0, 30.0, 90.0]
    solved = stribeck.solve(alpha, beta, f, fields="pressure", x=np.linspace(-2, 2, 5), sensitivities=True)
    assert set(solved.data_vars) == set(published.data_vars)
    assert solved.mu_v.dims == published.mu_v.dims == ("f", "alpha", "beta")
    for name, variable in published.variables.items():
        assert solved[name].attrs.keys() == {key for key in variable.attrs if key != "_FillValue"}, name
        assert [solved[name].attrs.get(key) for key in ("units", "long_name")] == [
            variable.attrs.get(key) for key in ("units", "long_name")
        ]
    np.testing.assert_array_equal(solved["case"], published["case"])
    for name in ("mu_v", "mu_h", "mu_drag", "c", "pressure"):
        np.testing.assert_allclose(solved[name], published[name], rtol=2e-5, atol=1e-5, err_msg=name)


def test_shapes_are_broadcast_and_dimensions_named():
    beta = np.geomspace(10, 100, 3)
    assert stribeck.solve(1.0, 10.0, 1.0).mu_v.shape == ()
    assert stribeck.solve(1.0, beta, 1.0).mu_v.dims == ("beta",)
    assert stribeck.solve([1.0], 10.0, 1.0).mu_v.dims == ("alpha",)
    curve = stribeck.solve(beta / 10, beta, 1.0)
    assert curve.mu_v.dims == ("point",)
    np.testing.assert_array_equal(curve.alpha, beta / 10)
    both = stribeck.solve(np.array([1.0, 2.0])[:, None], beta, 1.0)
    assert dict(both.sizes) == {"alpha": 2, "beta": 3}
    skew = stribeck.solve(np.array([[1.0, 2.0], [3.0, 4.0]]), 10.0, 1.0)
    assert skew.mu_v.dims == ("axis_0", "axis_1")
    for i, j in np.ndindex(2, 2):
        assert abs(skew.mu_v.values[i, j] / stribeck.solve(skew.alpha.values[i, j], 10.0, 1.0).mu_v.item() - 1) < 1e-5
    named = stribeck.solve(xarray.DataArray([1.0, 2.0], dims="sample"), xarray.DataArray(beta, dims="speed"), 1.0)
    assert named.mu_v.dims == ("sample", "speed")
    assert stribeck.solve([], beta[:1], 1.0).mu_v.shape == (0,)


def test_a_place_that_fails_is_nan_with_a_reason():
    cases = stribeck.solve(1.0, [10.0, 1e30], 1.0, fields=True)
    assert cases["status"].values.tolist() == [0, 1]
    assert np.isfinite(cases.mu_v[0]) and np.isnan(cases.mu_v[1]) and np.isnan(cases.pressure[1]).all()
    assert cases.reason.values[0] == "" and "rounding errors" in cases.reason.values[1]
    assert np.isfinite(cases.dry_mu_v).all()


@pytest.mark.parametrize(
    ("given", "told"),
    [
        ({"alpha": -1.0}, "alpha must be at least 0, or inf, found -1.0"),
        ({"beta": np.nan}, "beta must be finite and above 0, found NaN"),
        ({"beta": [1.0, np.inf]}, "beta must be finite and above 0, found inf"),
        ({"f": "soft"}, "f must be a number or an array of numbers"),
        ({"alpha": [1.0, 2.0], "f": [1.0, 2.0, 3.0]}, "shapes do not go together"),
        ({"slide_roll": 1.5}, "slide_roll must be from -1 to 1"),
        ({"slide_roll": -1.0}, "the flat is at rest"),
        ({"modes": [(0.5, 1.0)]}, "must add up to 1, not 0.5"),
        ({"modes": [0.5]}, "modes are pairs"),
        ({"tolerance": 1.0}, "from 1e-10 to 1e-1"),
        ({"threads": 0}, "threads must be a whole number from 1"),
        ({"fields": "presure"}, 'no field "presure": fields are pressure'),
        ({"fields": True, "x": [1.0, 0.0]}, "finite numbers that ascend"),
    ],
)
def test_wrong_input_is_told_with_what_is_allowed(given, told):
    with pytest.raises(stribeck.InputError) as error:
        stribeck.solve(**{"alpha": 1.0, "beta": 10.0, "f": 1.0, **given})
    assert told in str(error.value)
    assert isinstance(error.value, ValueError) and isinstance(error.value, stribeck.Error)
    again = pickle.loads(pickle.dumps(error.value))
    assert type(again) is stribeck.InputError and str(again) == str(error.value)


def test_threads_and_order_change_no_bit():
    rng = np.random.default_rng(3)
    alpha, beta = 10 ** rng.uniform(-1, 1, 60), 10 ** rng.uniform(0, 2, 60)
    one, two = (stribeck.solve(alpha, beta, 5.0, threads=threads) for threads in (1, 2))
    assert one.identical(two)
    order = rng.permutation(60)
    np.testing.assert_array_equal(stribeck.solve(alpha[order], beta[order], 5.0).mu_v, one.mu_v[order])


def test_rolling_shear_follows_from_the_film_that_is_there_too():
    rolling = stribeck.solve(1.0, 10.0, 1.0, slide_roll=0.0, fields="shear_traction")
    assert np.isfinite(rolling.shear_traction).all() and rolling.slide_roll.item() == 0.0
    sliding = stribeck.solve(1.0, 10.0, 1.0, fields=["shear_traction"])
    assert not np.allclose(sliding.shear_traction, rolling.shear_traction)


def test_results_are_pickled_and_without_xarray_they_are_arrays():
    case = stribeck.solve(1.0, [10.0, 20.0], 1.0)
    assert pickle.loads(pickle.dumps(case)).identical(case)
    code = (
        "import sys, importlib.util as u; find = u.find_spec\n"
        "u.find_spec = lambda name, *rest: None if name == 'xarray' else find(name, *rest)\n"
        "import pickle, stribeck\n"
        "case = stribeck.solve(1.0, [10.0, 20.0], 1.0)\n"
        "again = pickle.loads(pickle.dumps(case))\n"
        "assert 'xarray' not in sys.modules and again.dims['mu_v'] == ('beta',)\n"
        "assert again.attrs['c']['units'] == '1' and again.attrs['c']['scale'] == 'a0^2/R'\n"
        "print(repr(again['mu_v'].tolist()))"
    )
    said = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout
    assert json.loads(said) == case.mu_v.values.tolist()
