"""`solve`: agreement with the program, broadcasting, and input that is wrong."""

import json
import pickle

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
        ({"roller_modes": [0.5]}, "roller_modes are pairs"),
        ({"modes": [(1.0, 1.0)], "roller_modes": [(0.5, 1.0)]}, "must add up to 1, not 1.5; the shares of both bodies"),
        ({"roller_modes": [(1.0, 1.0)], "slide_roll": -1.0, "alpha": np.inf}, "describe both bodies in an Experiment"),
        (
            {"roller_modes": [(1.0, 1e308)], "slide_roll": -0.999},
            "roller_modes at slide_roll = -0.999: mode 1: the time",
        ),
        ({"tolerance": 1.0}, "from 1e-10 to 1e-1"),
        ({"threads": 0}, "threads must be a whole number from 1"),
        ({"fields": "presure"}, 'no field "presure": fields are pressure'),
        ({"fields": True, "x": [1.0, 0.0]}, "finite numbers that ascend"),
        ({"fields": True, "x": "wide"}, "x must be a number or an array of numbers"),
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


def test_results_are_pickled_and_without_xarray_they_are_arrays(said_without):
    case = stribeck.solve(1.0, [10.0, 20.0], 1.0)
    assert pickle.loads(pickle.dumps(case)).identical(case)
    said = said_without(
        ["xarray"],
        """
        import pickle, sys, stribeck
        case = stribeck.solve(1.0, [10.0, 20.0], 1.0)
        again = pickle.loads(pickle.dumps(case))
        assert "xarray" not in sys.modules and again.dims["mu_v"] == ("beta",)
        assert again.attrs["c"]["units"] == "1" and again.attrs["c"]["scale"] == "a0^2/R"
        print(again["mu_v"].tolist())
        """,
    )
    assert json.loads(said) == case.mu_v.values.tolist()


def test_both_bodies_have_the_numbers_of_the_program_to_the_last_bit(program):
    flat, roller = [(0.4, 1.0), (0.2, 10.0)], [(0.3, 1.0), (0.1, 20.0)]
    options = ("--modes", "0.4:1,0.2:10", "--roller-modes", "0.3:1,0.1:20", "--alpha", 1, "--beta", 100, "--f", 10)
    for slide_roll in (0.0, 0.5, 1.0):
        case = stribeck.solve(1.0, 100.0, 10.0, modes=flat, roller_modes=roller, slide_roll=slide_roll)
        told = json.loads(program("solve", *options, "--slide-roll", slide_roll, "--json").stdout)
        assert case["case"].item() == told["case"]
        for name in ("mu_v", "mu_v_roller", "mu_h", "mu_drag", "mu_torque", "c"):
            assert case[name].item() == told[name], name
    several = stribeck.solve(1.0, 100.0, 10.0, modes=flat, roller_modes=roller, slide_roll=[0.0, 0.5, 1.0])
    assert len(set(several["case"].values)) == 3, "another speed of the roller is another problem"
    assert several.mu_drag[1].item() == pytest.approx(
        stribeck.solve(1.0, 100.0, 10.0, modes=flat, roller_modes=roller, slide_roll=0.5).mu_drag.item(), rel=1e-5
    )
    # A roller alone that is soft, in pure rolling, loses what the flat would.
    of_flat = stribeck.solve(1.0, 100.0, 10.0, slide_roll=0.0, tolerance=1e-7)
    of_roller = stribeck.solve(1.0, 100.0, 10.0, roller_modes=[(1.0, 1.0)], slide_roll=0.0, tolerance=1e-7)
    assert of_roller.mu_v_roller.item() == pytest.approx(of_flat.mu_v.item(), rel=1e-5) and of_flat.mu_v_roller == 0.0


def test_sensitivities_to_both_bodies_are_the_changes_of_friction_and_those_of_the_program(program):
    flat, roller = [(0.4, 1.0)], [(0.35, 0.5), (0.25, 20.0)]
    point, step = {"alpha": 0.5, "beta": 100.0, "f": 8.0}, 0.02
    options = {"modes": flat, "roller_modes": roller, "tolerance": 1e-9}
    words = ("--modes", "0.4:1", "--roller-modes", "0.35:0.5,0.25:20", "--tolerance", 1e-9, "--sensitivities", "--json")
    for slide_roll in (-0.5, 0.3, 1.0):
        case = stribeck.solve(**point, **options, slide_roll=slide_roll, sensitivities=True)
        place = [word for name, value in point.items() for word in (f"--{name}", value)]
        told = json.loads(program("solve", *place, *words, f"--slide-roll={slide_roll}").stdout)
        for name, value in point.items():
            shifted = {**point, name: value * np.exp(step * np.array([-2.0, -1.0, 1.0, 2.0]))}
            near = stribeck.solve(**shifted, **options, slide_roll=slide_roll)
            for mu in ("mu_v", "mu_h", "mu_tot", "mu_drag", "mu_pressure", "mu_shear"):
                far_below, below, above, far_above = np.log(np.abs(near[mu].values))
                difference = (8 * (above - below) - (far_above - far_below)) / (12 * step)
                stated = case[f"dln_{mu}_dln_{name}"].item()
                assert abs(stated - difference) < 1e-5, (mu, name, slide_roll, stated, difference)
                assert 0.0 < case[f"error_dln_{mu}_dln_{name}"].item() < 1e-4, (mu, name, slide_roll)
            for mu in ("mu_v", "mu_h", "mu_pressure"):
                slope = case[f"dln_{mu}_dln_{name}"] * case[mu]
                assert slope.item() == pytest.approx(told[f"d{mu}_dln_{name}"], rel=1e-12), (mu, name, slide_roll)


def test_a_soft_roller_in_pure_rolling_has_the_sensitivities_of_a_soft_flat():
    spectrum = [(0.7, 1.0), (0.3, 30.0)]
    of_flat, of_roller = (
        stribeck.solve(1.0, [30.0, 100.0], 10.0, **body, slide_roll=0.0, tolerance=1e-8, sensitivities=True)
        for body in ({"modes": spectrum}, {"roller_modes": spectrum})
    )
    for mu in ("mu_v", "mu_h", "mu_pressure", "mu_shear"):
        for name in ("alpha", "beta", "f"):
            np.testing.assert_allclose(of_roller[f"dln_{mu}_dln_{name}"], of_flat[f"dln_{mu}_dln_{name}"], rtol=1e-6)
