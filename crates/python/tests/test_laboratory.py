"""Experiments, materials and fits."""

import pickle

import numpy as np
import pint
import pytest

import stribeck


def test_units_are_texts_quantities_of_pint_or_si_numbers(experiment):
    unit = pint.UnitRegistry()
    numbers = {"radius": 2e-3, "load": 119.0, "viscosity": 5.1, "poisson_ratio": 0.5}
    soft = {"relaxed_modulus": 75e3, "f": 10.0, "retardation_time": 0.1}
    quantities = {
        "radius": 2 * unit.mm,
        "load": 119 * unit.N / unit.m,
        "viscosity": 51 * unit.poise,
        "poisson_ratio": 0.5,
    }
    expected = experiment.friction("1 mm/s")
    assert stribeck.Experiment(**numbers, **soft).friction(1e-3) == expected
    by_pint = stribeck.Experiment(**quantities, **{**soft, "relaxed_modulus": 75 * unit.kPa})
    assert by_pint.friction(1 * unit.mm / unit.s) == pytest.approx(expected, rel=1e-12)


def test_friction_has_the_shape_of_the_speeds(experiment):
    speeds = np.array([[1e-2, 1e-3], [1e-3, 1e-4]])
    friction = experiment.friction(speeds)
    assert friction.shape == (2, 2) and friction[0, 1] == friction[1, 0]
    curve = experiment.curve(speeds)
    np.testing.assert_array_equal(curve.speed, [1e-4, 1e-3, 1e-2])
    np.testing.assert_array_equal(curve.mu_drag.values.ravel(), friction.ravel()[[3, 1, 0]])
    assert experiment.friction([]).shape == (0,)


def test_a_curve_has_the_numbers_of_the_program_to_the_last_bit(experiment, program, tmp_path):
    speeds = {"from": "10 um/s", "to": "1 m/s", "points": 7, "scale": "log"}
    (tmp_path / "e.toml").write_text(experiment.to_toml(speeds))
    run = program("curve", "e.toml", "--csv", "e.csv", cwd=tmp_path)
    assert run.returncode == 0, run.stderr
    table = np.genfromtxt(tmp_path / "e.csv", delimiter=",", names=True, dtype=None, encoding=None)
    curve = experiment.curve(speeds)
    compared = [name for name in table.dtype.names if name in curve and name.startswith(("mu_", "film_min", "p_max"))]
    assert len(compared) > 8
    for name in compared:
        np.testing.assert_array_equal(curve[name].values.ravel(), table[name], err_msg=name)
    assert curve.film_min.attrs["units"] == "m" and curve.p_max.attrs["units"] == "Pa"


def test_wrong_quantities_are_told_with_their_line(experiment):
    for change, told in [
        ({"radius": "2 kg"}, "must be a length"),
        ({"load": None}, "needs `load`, which is missing"),
        ({"raduis": 1.0}, "did you mean `radius`?"),
        ({"poisson_ratio": 0.7}, "from 0 to 0.5"),
    ]:
        with pytest.raises(stribeck.InputError) as error:
            experiment.replace(**change)
        assert told in str(error.value).replace("\n  │ ", " ")
    for speed in ("1 kg", -1.0, np.nan, "fast", [1e-3, -1e-3]):
        with pytest.raises(stribeck.InputError, match="speed"):
            experiment.friction(speed)
    with pytest.raises(stribeck.InputError, match="give the speeds"):
        experiment.curve()
    with pytest.raises(stribeck.InputError, match="load has several values"):
        experiment.replace(load=[100.0, 200.0]).friction(1e-3)


def test_rolling_goes_along_the_entrainment_speed(experiment):
    rolling = experiment.replace(slide_roll_ratio=0.1)
    assert rolling.along == "entrainment_speed"
    assert rolling.curve([1e-3, 1e-2]).mu_drag.dims[-1] == "entrainment_speed"
    sliding = experiment.replace(slide_roll_ratio=2.0)
    assert sliding.friction(0.5e-3) == pytest.approx(experiment.friction(1e-3), rel=1e-5)


def test_a_prony_series_is_a_material_and_a_flat():
    given = {"times": ["1 s", 10.0], "moduli": ["1607.1 kPa", 228.6e3], "relaxed_modulus": "1.2 MPa"}
    material = stribeck.Material.from_prony(**given, poisson_ratio=0.5)
    assert material.modulus(0.0) == pytest.approx(material.instantaneous_modulus)
    assert material.modulus(1e6) == pytest.approx(1.2e6)
    assert material.modes[:, 0].sum() == pytest.approx(1.0)
    assert material.f == pytest.approx((1607.1 + 228.6) / 1200)
    storage, loss = material.storage_and_loss([1e-9, 1e9])
    np.testing.assert_allclose(storage, [1.2e6, material.instantaneous_modulus])
    np.testing.assert_allclose(loss, 0.0, atol=0.1)
    fractions = np.array([1607.1, 228.6]) / (1200 + 1607.1 + 228.6)
    same = stribeck.Material.from_prony(times=[1, 10], fractions=fractions, relaxed_modulus=1.2e6)
    np.testing.assert_allclose(same.moduli, material.moduli)
    experiment = stribeck.Experiment(flat=material, radius="5 mm", load="200 N/m", viscosity="1 Pa s")
    curve = experiment.curve([1e-4, 1e-2])
    # In the units of the solver it is the same problem.
    solved = stribeck.solve(curve.alpha.values.ravel(), curve.beta.values.ravel(), material.f, modes=material.modes)
    drag = solved.mu_drag.values * curve.friction_scale.values.ravel()
    np.testing.assert_allclose(curve.mu_drag.values.ravel(), drag, rtol=1e-5)
    for wrong, told in [
        ({**given, "times": [1.0]}, "as many times as terms"),
        ({**given, "instantaneous_modulus": 1e7}, "one of both"),
        ({**given, "moduli": None, "fractions": [0.7, 0.5]}, "1.2"),
    ]:
        with pytest.raises(stribeck.InputError, match=told):
            stribeck.Material.from_prony(**wrong)


def test_a_material_is_fitted_to_a_file(tmp_path):
    material = stribeck.Material.from_prony(times=[0.01, 1.0], moduli=[1e6, 2e6], relaxed_modulus=1e6)
    omega = np.geomspace(0.01, 1e4, 40)
    rows = np.column_stack([omega, *material.storage_and_loss(omega)])
    file = tmp_path / "rubber.csv"
    np.savetxt(file, rows, delimiter=",", header="angular_frequency,storage_modulus,loss_modulus", comments="")
    fitted = stribeck.Material.from_file(file, poisson_ratio=0.5)
    assert fitted.rms_residual < 0.01 and fitted.measured.shape == (40, 3) and "storage" in fitted.understood
    assert fitted.instantaneous_modulus == pytest.approx(4e6, rel=0.01)
    with pytest.raises(stribeck.InputError, match="nowhere"):
        stribeck.Material.from_file(tmp_path / "nowhere.csv")
    with pytest.raises(stribeck.InputError, match="no column has a temperature"):
        stribeck.Material.from_file(file, reference_temperature="20 degC")


def test_a_fit_finds_what_the_points_were_made_with(experiment):
    speed = np.geomspace(1e-4, 0.1, 10)
    scatter = 1 + 0.01 * np.random.default_rng(1).normal(size=speed.size)
    mu = experiment.friction(speed) * scatter
    start = experiment.replace(viscosity=3.0, f=5.0)
    found = stribeck.fit({"speed": speed, "mu": mu, "error": 0.01 * mu}, start, ["viscosity", "f"])
    for name, true in (("viscosity", 5.1), ("f", 10.0)):
        assert abs(found.values[name] - true) < 4 * found.errors[name], name
    assert found.covariance[0, 0] == pytest.approx(found.errors["viscosity"] ** 2)
    np.testing.assert_allclose(found.experiment.friction(speed), found.points["fitted"], rtol=1e-4)
    np.testing.assert_array_equal(found.points["measured"], mu)
    bounded = stribeck.fit(
        {"speed (mm/s)": 1e3 * speed, "mu": mu}, start, "viscosity", bounds={"viscosity": (0, "4 Pa s")}
    )
    assert bounded.at_bound["viscosity"] and bounded.values["viscosity"] == pytest.approx(4.0)
    with pytest.raises(stribeck.InputError, match="give some of f, radius"):
        stribeck.fit({"speed": speed, "mu": mu}, start, "colour")
    with pytest.raises(stribeck.InputError, match="different lengths"):
        stribeck.fit({"speed": speed, "mu": mu[1:]}, start, "f")


def test_all_can_be_pickled(experiment):
    curve = experiment.curve([1e-3, 1e-2])
    assert pickle.loads(pickle.dumps(curve)).identical(curve)
    assert pickle.loads(pickle.dumps(experiment)).curve([1e-3, 1e-2]).identical(curve)
    material = stribeck.Material.from_prony(times=[1.0], moduli=[1e6], relaxed_modulus=1e6)
    np.testing.assert_array_equal(pickle.loads(pickle.dumps(material)).modes, material.modes)
    for kind in (stribeck.FitError, stribeck.StorageError, stribeck.Error):
        assert str(pickle.loads(pickle.dumps(kind("why")))) == "why"
