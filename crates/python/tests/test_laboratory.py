"""Experiments, materials and fits."""

import contextlib
import pickle

import numpy as np
import pandas
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
    table = pandas.DataFrame({"speed": speed, "mu": mu, "error": 0.01 * mu})
    assert stribeck.fit(table, start, ["viscosity", "f"]).values == found.values


def test_a_search_finds_where_a_fit_begins(experiment):
    speed = np.geomspace(1e-4, 0.1, 10)
    points = {"speed": speed, "mu": experiment.friction(speed)}
    unknown = ["relaxed_modulus", "retardation_time", "f"]
    far = experiment.replace(relaxed_modulus="15 MPa", retardation_time="0.3 ms", f=100.0)

    def values(**options):
        return list(stribeck.fit(points, far, unknown, **options).values.values())

    true = pytest.approx([75e3, 0.1, 10.0], rel=1e-3)
    # From so far off the fit ends elsewhere, or nowhere.
    with contextlib.suppress(stribeck.FitError):
        assert values() != true
    assert values(search=True) == true
    with pytest.raises(stribeck.InputError, match="the bounds of f leave nothing between them"):
        values(search=True, bounds={"f": (100, 1)})


def test_all_can_be_pickled(experiment):
    curve = experiment.curve([1e-3, 1e-2])
    assert pickle.loads(pickle.dumps(curve)).identical(curve)
    assert pickle.loads(pickle.dumps(experiment)).curve([1e-3, 1e-2]).identical(curve)
    material = stribeck.Material.from_prony(times=[1.0], moduli=[1e6], relaxed_modulus=1e6)
    np.testing.assert_array_equal(pickle.loads(pickle.dumps(material)).modes, material.modes)
    for kind in (stribeck.FitError, stribeck.StorageError, stribeck.Error):
        assert str(pickle.loads(pickle.dumps(kind("why")))) == "why"


def test_messages_name_arguments_of_python(experiment, tmp_path):
    speed, mu = [1e-3, 1e-2, 1e-1], [0.1, 0.2, 0.3]
    (tmp_path / "two.csv").write_text("speed,speed,mu\n1,2,3\n")
    (tmp_path / "other.csv").write_text("V,F\n1,2\n2,3\n")
    (tmp_path / "shear.csv").write_text("omega,G',G\"\n1,2,3\n2,3,4\n")
    (tmp_path / "moduli.csv").write_text("omega,storage,los\n1,2,3\n2,3,4\n")
    (tmp_path / "warm.csv").write_text(
        "omega,storage,loss,temperature (degC)\n1,2,3,20\n2,3,4,20\n1,2,1,40\n2,3,2,40\n"
    )
    (tmp_path / "factors.csv").write_text("temperature (degC),log_aT\n20,3\n40,2\n")
    (tmp_path / "series.inp").write_text("*viscoelastic, time=prony\n.1,,1\n")

    def fit(data, unknown="f", **options):
        data = tmp_path / data if isinstance(data, str) else data
        return lambda: stribeck.fit(data, experiment, unknown, **options)

    def material(name, **options):
        return lambda: stribeck.Material.from_file(tmp_path / name, **options)

    for call, told in [
        (fit({"speed": speed, "mu": mu}, "colour"), "give some of f, radius"),
        (fit({"speed": speed, "mu": mu[1:]}), "different lengths"),
        (fit({"speed": speed, "mu": mu}, ["f", "f"]), "f is among the unknowns twice"),
        (fit({"speed": speed, "mu": mu}, bounds={"load": (1, 2)}), "add it to the unknowns, or leave its bounds out"),
        (fit({"speed": speed, "mu": mu}, bounds={"f": 1}), r"bounds of f are a pair \(low, high\)"),
        (fit({"speed": speed, "mu": mu}, bounds={"f": (20, 30)}), "begins at 1e1, which is not between its bounds"),
        (fit("two.csv"), 'choose with columns="speed=#1"'),
        (fit("other.csv"), 'columns="'),
        (fit("other.csv", columns="velocities=V"), 'columns="velocities=…": there are mu'),
        (fit("other.csv", columns="speed=My V (m/s)"), r'columns="speed=My V \(m/s\)": there is no column'),
        (fit("other.csv", columns="speed"), "write quantity=column"),
        (fit("nowhere.csv"), r"nowhere\.csv.*check the path"),
        (material("shear.csv"), r"give Poisson's ratio \(poisson_ratio=0.5\)"),
        (material("moduli.csv"), 'as in columns="loss=los": `los`'),
        (material("moduli.csv", terms=-1, columns="loss=los"), "from 1 to 100 terms, not 0"),
        (material("moduli.csv", terms=2, columns="loss=los", reference_temperature=300), 'columns="temperature=#4"'),
        (material("moduli.csv", modulus_unit="m", columns="loss=los"), "must be a modulus"),
        (material("warm.csv"), 'as in reference_temperature="20 degC"'),
        (
            material("warm.csv", shift_factors=tmp_path / "factors.csv"),
            'give it, as in reference_temperature="20 degC"',
        ),
        (material("warm.csv", reference_temperature="warm"), "must be a temperature, a number with a unit"),
        (material("warm.csv", shift_factors=tmp_path / "nowhere.csv"), r"nowhere\.csv.*check the path"),
        (
            material("series.inp", reference_temperature=300.0),
            "leave out reference_temperature=T, or give shift_factors=FILE",
        ),
        (material("series.inp", terms=2), "leave out terms=N"),
        (material("series.inp", shear=True, poisson_ratio=0.5), "leave out shear=True"),
        (material("series.inp", modulus_unit="MPa"), r"leave out its unit \(modulus_unit=MPa\)"),
    ]:
        with pytest.raises(stribeck.InputError, match=told) as error:
            call()
        assert "--" not in str(error.value)
