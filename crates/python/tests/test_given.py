"""What people give: numbers in other forms mean the same, and what is none is refused with its name."""

import warnings

import numpy as np
import pandas as pd
import pint
import pytest
import xarray

import stribeck

UNIT = pint.UnitRegistry()
OIL = {"radius": "2 mm", "load": "119 N/m", "viscosity": "5.1 Pa s", "poisson_ratio": 0.5}
RUBBER = {"relaxed_modulus": "75 kPa", "f": 10.0, "retardation_time": "0.1 s"}
MEASURED = {"speed": [1e-3, 3e-3, 1e-2, 3e-2], "mu": [0.072, 0.18, 0.43, 0.53]}
MASKED = np.ma.array([1.0, 2.0, 4.0], mask=[False, True, False])
MATERIAL = stribeck.Material.from_prony(times=[1.0], moduli=[1e6], relaxed_modulus=1e6)

BETA = [16.0, 32.0]
FORMS = {
    "integers": np.array([16, 32]),
    "small floats": np.array(BETA, dtype=np.float32),
    "a series": pd.Series(BETA, index=[7, 3]),
    "a nullable series": pd.Series([16, 32], dtype="Int64"),
    "no mask": np.ma.array(BETA),
    "a range": range(16, 33, 16),
    "a quantity": UNIT.Quantity([16e3, 32e3], "mm/m"),
    "quantities": [UNIT.Quantity(16.0, ""), 32.0],
    "arrays without dimensions": [np.array(16.0), np.array(32)],
    "texts": ["16", "3.2e1"],
    "a view": np.array([16.0, 0.0, 32.0, 0.0])[::2],
}


@pytest.mark.parametrize("name", FORMS)
def test_numbers_in_another_form_are_the_same_numbers(name):
    with warnings.catch_warnings():
        # A unit that is dropped warns.
        warnings.simplefilter("error")
        solved, surface = stribeck.solve(1.0, FORMS[name], 3.0), stribeck.Surface()(1.0, FORMS[name], 3.0)
    assert solved.identical(stribeck.solve(1.0, BETA, 3.0))
    np.testing.assert_array_equal(surface["mu_drag"], stribeck.Surface()(1.0, BETA, 3.0)["mu_drag"])


def test_measured_points_in_another_form_are_the_same_points(experiment):
    expected = stribeck.fit(MEASURED, experiment, "viscosity").values
    columns = {"speed": UNIT.Quantity(np.array(MEASURED["speed"]) * 1e3, "mm/s"), "mu": pd.Series(MEASURED["mu"])}
    named = {"speed (mm/s)": [1, 3, 10, 30], "mu": np.array(MEASURED["mu"])[:, None][:, 0]}
    table = pd.DataFrame({**MEASURED, "sample": ["a", 'b, "old"', None, "d"]})
    for data in (columns, named, table, xarray.Dataset({name: ("i", it) for name, it in MEASURED.items()})):
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            found = stribeck.fit(data, experiment, ("viscosity",)).values
        assert found == pytest.approx(expected, rel=1e-9), type(data)


def test_times_and_rates_of_a_material_may_have_units():
    assert MATERIAL.modulus(UNIT.Quantity(1.0, "min")) == MATERIAL.modulus(60.0)
    for of_unit, plain in zip(
        MATERIAL.storage_and_loss(UNIT.Quantity([2.0], "rad/ms")), MATERIAL.storage_and_loss([2e3]), strict=True
    ):
        np.testing.assert_allclose(of_unit, plain, rtol=1e-12)


def refused(call):
    """The message of an error of the package, with no other one and no warning on the way."""
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        with pytest.raises(stribeck.InputError) as error:
            call()
    return str(error.value)


@pytest.mark.parametrize(
    ("given", "told"),
    [
        ({"alpha": "2 in"}, "alpha must be a number or an array of numbers without a unit, found '2 in'"),
        ({"alpha": "1,5"}, "found '1,5'"),
        ({"alpha": None}, "alpha must be a number or an array of numbers without a unit, found None"),
        ({"alpha": [1.0, None]}, "found None"),
        ({"alpha": [[1.0, 2.0], [3.0]]}, "found [[1.0, 2.0], [3.0]]"),
        ({"alpha": UNIT.Quantity(2.0, "mm")}, "alpha must have no unit, found 2.0 millimeter"),
        ({"alpha": [1.0, UNIT.Quantity(2.0, "mm")]}, "alpha must have no unit, found 2.0 millimeter"),
        ({"beta": MASKED}, "beta has masked values, 1 of 3: leave them out"),
        ({"beta": np.array([1 + 0j])}, "found (1+0j)"),
        ({"beta": np.array(["2026-01-01"], dtype="M8[D]")}, "beta must be a number"),
        ({"beta": pd.Series(["10", "x"])}, "found 'x'"),
        ({"f": xarray.DataArray(["soft"], dims="sample")}, "found 'soft'"),
        (
            {
                axis: xarray.DataArray([1.0, 2.0], dims="i", coords={"i": i})
                for axis, i in {"f": [0, 1], "beta": [1, 2]}.items()
            },
            "f has other coordinates along i than the others",
        ),
        (
            {axis: xarray.DataArray(np.ones(size), dims="i") for axis, size in {"f": 2, "beta": 3}.items()},
            "the dimensions of the arrays do not go together",
        ),
        ({"tolerance": "small"}, "tolerance must be a number without a unit, found 'small'"),
        ({"tolerance": None}, "tolerance must be a number without a unit, found None"),
        ({"tolerance": [1e-5, 1e-6]}, "tolerance must be one number"),
        ({"threads": "two"}, "threads must be a whole number, found 'two'"),
        ({"threads": 2.0}, "threads must be a whole number, found 2.0"),
        ({"threads": 10**30}, "threads must be a whole number of at most 18 digits"),
        ({"fields": None}, "fields must be True, False, or a list of pressure"),
        ({"modes": MATERIAL}, "those of a Material are its attribute modes"),
    ],
)
def test_solve_refuses_what_is_no_number(given, told):
    assert told in refused(lambda: stribeck.solve(**{"alpha": 1.0, "beta": 10.0, "f": 1.0, **given}))


CALLS = [
    (
        lambda _: stribeck.Experiment(**OIL, flat="rubber.csv"),
        "flat must be a Material, or the keys of [flat] in a dict",
    ),
    (lambda _: stribeck.Experiment(**{**OIL, "load": MASKED}, **RUBBER), "load has masked values"),
    (
        lambda _: stribeck.Experiment(**{**OIL, "radius": UNIT.Quantity(2.0, "kg")}, **RUBBER),
        "radius must be in m or a",
    ),
    (lambda it: it.friction([[1e-3], [1e-3, 2e-3]]), "speed has lists of different lengths"),
    (lambda it: it.friction(MASKED), "speed has masked values"),
    (
        lambda it: it.friction(UNIT.Quantity(1.0, "kg")),
        "speed must be in m/s or a unit of that kind, found 1.0 kilogram",
    ),
    (lambda it: it.friction(1e-3, threads="all"), "threads must be a whole number, found 'all'"),
    (lambda it: it.curve(1e-3, threads=0.5), "threads must be a whole number, found 0.5"),
    (lambda _: stribeck.Material.from_file(None), "path must be the path of a file, found None"),
    (lambda _: stribeck.Material.from_file("absent.csv"), "absent.csv: No such file"),
    (lambda _: stribeck.Material.from_file("absent.csv", terms="auto"), "terms must be a whole number, found 'auto'"),
    (lambda _: stribeck.Material.from_file("absent.csv", columns=["a"]), 'columns must be a text as in "storage=#2'),
    (lambda _: stribeck.Material.from_prony(times=[1.0], fractions=["half"], relaxed_modulus=1.0), "found 'half'"),
    (lambda _: MATERIAL.modulus("1 s"), "time must be a number or an array of numbers in s, found '1 s'"),
    (lambda _: MATERIAL.storage_and_loss(UNIT.Quantity(1.0, "m")), "omega must be in rad/s or a unit of that kind"),
    (lambda it: stribeck.fit(None, it, "viscosity"), "measured points are a path, a list of paths, or columns by name"),
    (lambda it: stribeck.fit(pd.Series([0.1]), it, "viscosity"), "found Series"),
    (lambda it: stribeck.fit({}, it, "viscosity"), "there are no measured points"),
    (lambda it: stribeck.fit({**MEASURED, "mu": [0.1]}, it, "viscosity"), "different lengths: speed 4, mu 1"),
    (lambda it: stribeck.fit({**MEASURED, "mu": [[0.1]] * 4}, it, "viscosity"), "found an array of shape (4, 1)"),
    (lambda it: stribeck.fit({"speed": MASKED, "mu": [0.1] * 3}, it, "viscosity"), "speed has masked values, 1 of 3"),
    (lambda it: stribeck.fit({**MEASURED, "speed": UNIT.Quantity([1.0] * 4, "kg")}, it, "f"), "speed must be in m/s"),
    (lambda it: stribeck.fit({**MEASURED, "speed": ["1 mm/s"] * 4}, it, "viscosity"), '"1 mm/s" is not allowed'),
    (
        lambda it: stribeck.fit({**MEASURED, "mu": [0.1, np.nan, 0.2, 0.3]}, it, "viscosity"),
        'mu = "nan" is not allowed',
    ),
    (lambda it: stribeck.fit(MEASURED, it, []), "unknown is a name, or a list of names"),
    (lambda it: stribeck.fit(MEASURED, it, 3), "unknown is a name, or a list of names"),
    (lambda it: stribeck.fit(MEASURED, it, "f", bounds=(1, 2)), "bounds are pairs by name"),
    (
        lambda it: stribeck.fit(MEASURED, it, "f", bounds={"f": ("1 m", 2)}),
        "a bound of f must be a number without a unit",
    ),
    (lambda _: stribeck.fit(MEASURED, OIL, "f"), "experiment must be an Experiment, or the path of a sweep file"),
    (lambda it: stribeck.fit(MEASURED, it, "f", columns=3), 'columns must be a text as in "speed=My V (mm/s),mu=#3"'),
    (lambda _: stribeck.run(None), "sweep must be the path of a file, found None"),
    (lambda _: stribeck.run("absent.toml", threads="x"), "threads must be a whole number, found 'x'"),
    (lambda _: stribeck.open(None), "directory must be the path of a file, found None"),
    (lambda _: stribeck.Surface()(1.0, MASKED, 1.0), "beta has masked values, 1 of 3"),
    (lambda _: stribeck.Surface()(None, 10.0, 1.0), "alpha must be a number or an array of numbers without a unit"),
    (lambda _: stribeck.Surface()(UNIT.Quantity(1.0, "mm"), 10.0, 1.0), "without a unit, found <Quantity(1.0, 'milli"),
    (lambda _: stribeck.Surface()(np.array([1 + 1j]), 10.0, 1.0), "alpha must be a number or an array of numbers"),
]


@pytest.mark.parametrize(("call", "told"), CALLS, ids=[told for _, told in CALLS])
def test_what_may_not_be_is_told(call, told, experiment):
    assert told in refused(lambda: call(experiment))
