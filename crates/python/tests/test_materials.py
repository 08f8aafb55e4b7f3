"""Materials from series and files, their temperature, and experiments with both."""

import json
from pathlib import Path

import numpy as np
import pint
import pytest

import stribeck

FILES = Path(__file__).parents[3] / "docs/how-to/instrument-files"
GIVEN = {"times": ["1 s", 10.0], "moduli": ["1607.1 kPa", 228.6e3], "relaxed_modulus": "1.2 MPa"}
WLF = {"law": "wlf", "c1": 10.0, "c2": "80 K", "reference": "20 degC"}


def test_a_prony_series_is_a_material_and_a_flat():
    material = stribeck.Material.from_prony(**GIVEN, poisson_ratio=0.5)
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


@pytest.mark.parametrize(
    ("change", "told"),
    [
        ({"times": [1.0]}, "as many times as terms"),
        ({"instantaneous_modulus": 1e7}, "one of both"),
        ({"moduli": None, "fractions": [0.7, 0.5]}, "1.2"),
        ({"poisson_ratio": 0.6}, "poisson_ratio"),
    ],
)
def test_what_is_no_series_is_told(change, told):
    with pytest.raises(stribeck.InputError, match=told):
        stribeck.Material.from_prony(**{**GIVEN, **change})


def test_a_material_is_fitted_to_a_file_as_the_program_does_it(program):
    file = FILES / "moduli.csv"
    for options, words in [
        ({}, ()),
        ({"terms": 4}, ("--terms", 4)),
        ({"shear": True, "poisson_ratio": 0.4}, ("--shear", "--poisson-ratio", 0.4)),
    ]:
        fitted = stribeck.Material.from_file(file, **options)
        told = json.loads(program("material", file, "--json", *words).stdout)
        for name in ("relaxed_modulus", "instantaneous_modulus", "f", "retardation_time", "rms_residual"):
            assert getattr(fitted, name) == told[name], name
        assert fitted.measured.shape == (27, 3) and "storage" in fitted.understood
        assert fitted.shifts is None and fitted.shift is None


def test_isotherms_are_shifted_as_the_program_does_it(program, tmp_path):
    file = FILES / "isotherms.csv"
    unit = pint.UnitRegistry()
    for reference in ("20 degC", 293.15, unit.Quantity(20.0, "degC")):
        fitted = stribeck.Material.from_file(file, reference_temperature=reference)
        told = json.loads(program("material", file, "--reference-temperature", "20 degC", "--json").stdout)
        assert fitted.f == told["f"] and fitted.rms_residual == told["rms_residual"]
        shifts = [
            [shift["temperature"], shift["log_shift_factor"], np.nan if shift["overlap"] is None else shift["overlap"]]
            for shift in told["master_curve"]["shifts"]
        ]
        np.testing.assert_array_equal(fitted.shifts, shifts)
        assert fitted.shift["law"] == "arrhenius" and fitted.shift_residual < 0.01
        assert fitted.shift["activation_energy"] == pytest.approx(80e3, rel=0.02), "what the file was made with"
    factors = tmp_path / "factors.csv"
    log = 80e3 / 8.314462618 * (1 / (fitted.shifts[:, 0]) - 1 / 293.15) * np.log10(np.e)
    table = np.column_stack([fitted.shifts[:, 0] - 273.15, log])
    np.savetxt(factors, table, delimiter=",", header="temperature (degC),log_shift_factor", comments="")
    given = stribeck.Material.from_file(file, shift_factors=factors)
    told = json.loads(program("material", file, "--shift-factors", factors, "--json").stdout)
    assert given.f == told["f"] and "factors.csv" in given.understood
    assert given.shift["activation_energy"] == pytest.approx(80e3, rel=1e-6)
    # Beside moduli at one temperature, and beside a series, they give the law alone.
    (tmp_path / "series.csv").write_text("tau,fraction\n1,0.25\n10,0.5\n")
    series = stribeck.Material.from_file(tmp_path / "series.csv", shift_factors=factors)
    assert series.shift["activation_energy"] == pytest.approx(80e3, rel=1e-6) and series.f == pytest.approx(3.0)
    alone = stribeck.Material.from_file(FILES / "moduli.csv", shift_factors=factors)
    assert alone.shift["activation_energy"] == pytest.approx(80e3, rel=1e-6)
    assert alone.f == stribeck.Material.from_file(FILES / "moduli.csv").f
    assert stribeck.Material.from_file(file, reference_temperature="20 degC", shift=WLF).shift == WLF


@pytest.mark.parametrize(
    ("options", "words", "law"),
    [
        ({}, (), lambda temperature: temperature**0),
        ({"vertical_shift": "fit"}, ("--vertical-shift", "fit"), None),
        ({"vertical_shift": "density"}, ("--vertical-shift", "density"), lambda temperature: 293.15 / temperature),
        (
            {"vertical_shift": "density", "expansion": 6e-4},
            ("--vertical-shift", "density", "--expansion", 6e-4),
            lambda temperature: (1.0 + 6e-4 * (temperature - 293.15)) * 293.15 / temperature,
        ),
    ],
)
def test_moduli_of_isotherms_are_shifted_as_the_program_does_it(options, words, law, program):
    file = FILES / "isotherms.csv"
    fitted = stribeck.Material.from_file(file, reference_temperature="20 degC", **options)
    told = json.loads(program("material", file, "--reference-temperature", "20 degC", *words, "--json").stdout)
    for name in ("relaxed_modulus", "instantaneous_modulus", "f", "rms_residual"):
        assert getattr(fitted, name) == told[name], name
    shifts = told["master_curve"]["shifts"]
    np.testing.assert_array_equal(fitted.vertical_shift_factors, [shift["vertical_shift_factor"] for shift in shifts])
    np.testing.assert_array_equal(fitted.shifts[:, 1], [shift["log_shift_factor"] for shift in shifts])
    if law is not None:
        np.testing.assert_allclose(fitted.vertical_shift_factors, law(fitted.shifts[:, 0]), rtol=1e-12)
    else:
        reference = np.argmin(np.abs(fitted.shifts[:, 0] - 293.15))
        assert fitted.vertical_shift_factors[reference] == 1.0 and np.ptp(fitted.vertical_shift_factors) > 0.0
    unit = pint.UnitRegistry()
    if "expansion" in options:
        by_pint = {**options, "expansion": unit.Quantity(600.0, "ppm/delta_degC")}
        again = stribeck.Material.from_file(file, reference_temperature="20 degC", **by_pint)
        np.testing.assert_allclose(again.moduli, fitted.moduli, rtol=1e-9)


@pytest.mark.parametrize(
    ("file", "options", "words", "told"),
    [
        (
            "moduli.csv",
            {"vertical_shift": "fit"},
            ("--vertical-shift", "fit"),
            "there are no isotherms here whose moduli could be shifted, but a series, or moduli at one temperature or "
            "none; leave out ",
        ),
        (
            "isotherms.csv",
            {"vertical_shift": "density", "expansion": 1.0},
            ("--vertical-shift", "density", "--expansion", 1.0),
            "a number from 0 to 0.002; rubber has 6e-4",
        ),
        ("isotherms.csv", {"expansion": 6e-4}, ("--expansion", 6e-4), "expansion would change nothing: no density is"),
    ],
)
def test_a_shift_of_moduli_that_may_not_be_is_told_as_by_the_program(file, options, words, told, program):
    path = FILES / file
    said = program("material", path, "--reference-temperature", "20 degC", *words).stderr
    assert told in " ".join(said.split()).replace("--expansion would", "expansion would"), said
    with pytest.raises(stribeck.InputError) as error:
        stribeck.Material.from_file(path, reference_temperature="20 degC", **options)
    assert told in str(error.value) and "--" not in str(error.value)


def test_what_to_do_about_a_shift_of_moduli_is_said_in_the_words_of_python(tmp_path):
    # The moduli of a glass hardly change with the rate, and do not go with the temperature.
    rows = [
        f"{omega},{1e9 * omega**0.01:.6e},1e7,{celsius}" for celsius in (20, 160) for omega in np.logspace(-1, 2, 9)
    ]
    (tmp_path / "glass.csv").write_text("\n".join(["omega,storage,loss,T (degC)", *rows, ""]))
    for how, told in [("density", 'Leave out vertical_shift="density", or'), ("up", '"fit" or "density", found "up"')]:
        with pytest.raises(stribeck.InputError, match=told):
            stribeck.Material.from_file(tmp_path / "glass.csv", reference_temperature=293.15, vertical_shift=how)
    with pytest.raises(stribeck.InputError, match='add vertical_shift="density", or leave it out'):
        stribeck.Material.from_file(tmp_path / "glass.csv", reference_temperature=293.15, expansion=6e-4)


def test_a_doubtful_fit_warns(tmp_path):
    rows = "1,100,300\n3,500,800\n10,2000,1500\n30,4000,1200\n100,5000,500\n"
    (tmp_path / "liquid.csv").write_text("omega,storage,loss\n" + rows)
    with pytest.warns(UserWarning, match=r"liquid\.csv: at the lowest frequency.*extrapolated"):
        stribeck.Material.from_file(tmp_path / "liquid.csv", terms=3)


def test_temperature_shifts_times_and_viscosity():
    rubber = stribeck.Material.from_prony(**GIVEN, poisson_ratio=0.5, shift=WLF)
    oil = {"law": "arrhenius", "value": "1 Pa s", "activation_energy": "30 kJ/mol", "reference": "20 degC"}
    bench = {"radius": "5 mm", "load": "200 N/m"}
    speeds = [1e-4, 1e-2]
    experiment = stribeck.Experiment(flat=rubber, viscosity=oil, temperature=["20 degC", 313.15], **bench)
    curves = experiment.curve(speeds)
    assert curves.mu_drag.dims == ("f", "temperature", "speed")
    np.testing.assert_allclose(curves.temperature, [293.15, 313.15])
    slower = 10 ** (-10.0 * 20.0 / (80.0 + 20.0))
    thinner = np.exp(30e3 / 8.314462618 * (1 / 313.15 - 1 / 293.15))
    warm = stribeck.Material.from_prony(**{**GIVEN, "times": [slower, 10 * slower]}, poisson_ratio=0.5)
    cold = stribeck.Material.from_prony(**GIVEN, poisson_ratio=0.5)
    for place, (flat, viscosity) in enumerate([(cold, 1.0), (warm, thinner)]):
        single = stribeck.Experiment(flat=flat, viscosity=viscosity, **bench)
        np.testing.assert_allclose(curves.mu_drag[0, place], single.friction(speeds), rtol=2e-5)
    unit = pint.UnitRegistry()
    by_pint = {**oil, "activation_energy": 30 * unit.kJ / unit.mol, "value": 10 * unit.poise, "reference": 293.15}
    shift = {**WLF, "c2": unit.Quantity(80.0, "delta_degC"), "reference": unit.Quantity(20.0, "degC")}
    rubber = stribeck.Material.from_prony(**GIVEN, poisson_ratio=0.5, shift=shift)
    again = stribeck.Experiment(flat=rubber, viscosity=by_pint, temperature=[293.15, 313.15], **bench).curve(speeds)
    np.testing.assert_allclose(again.mu_drag, curves.mu_drag, rtol=1e-9)
    with pytest.raises(stribeck.InputError, match="temperature"):
        stribeck.Experiment(flat=cold, viscosity=1.0, temperature=300.0, **bench)
