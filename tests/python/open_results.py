"""Opens results.h5 as a user does and compares it with summary.csv.

Usage:
    python tests/python/open_results.py RESULTS_DIR ENGINE

ENGINE is h5netcdf or netcdf4.
"""

import csv
import sys
from pathlib import Path

import numpy as np
import pandas as pd
import pint
import xarray as xr

directory, engine = Path(sys.argv[1]), sys.argv[2]
path = directory / "results.h5"
data = xr.open_dataset(path, engine=engine)
with (directory / "summary.csv").open(newline="", encoding="utf-8") as file:
    rows = list(csv.DictReader(file))
summary = {name: [row[name] for row in rows] for name in rows[0]}


def numbers(name):
    """A column of the summary."""
    return np.array([float(cell) if cell else np.nan for cell in summary[name]])


# Named coordinates, on every variable.
assert set(data.dims) == {"f", "alpha", "beta", "x"}, data.dims
assert set(data.coords) == {"f", "alpha", "beta", "x"}, data.coords
shape = tuple(data.sizes[name] for name in ("f", "alpha", "beta"))
fields = ["pressure", "film_thickness", "displacement", "shear_traction", "hysteresis_traction"]
for name, variable in data.data_vars.items():
    expected = ("f", "alpha", "beta") + (("x",) if name in fields else ())
    assert variable.dims == expected, (name, variable.dims)
    assert variable.attrs["long_name"], name
    assert variable.dtype.kind in "fiOSU" and variable.dtype != np.float16, (name, variable.dtype)
for name, coordinate in data.coords.items():
    assert coordinate.attrs.get("scale") == ("a0" if name == "x" else None), name
    assert coordinate.dtype == np.float64 and coordinate.attrs["units"] and coordinate.attrs["long_name"], name

# The whole summary, bit for bit, in plan order (f, then alpha, then beta).
grid = np.array(np.meshgrid(data.f, data.alpha, data.beta, indexing="ij")).reshape(3, -1)
for place, name in enumerate(("f", "alpha", "beta")):
    assert np.array_equal(grid[place], numbers(name)), name
for name in ("case", "reason"):
    assert data[name].values.ravel().tolist() == summary[name], name
assert int((data["case"] == summary["case"][0]).sum()) == summary["case"].count(summary["case"][0])
for name in list(summary)[6:]:
    assert np.array_equal(data[name].values.ravel(), numbers(name), equal_nan=True), name
    assert np.isnan(data[name].encoding["_FillValue"]) and data[name].attrs["units"], name
for name in ("x_p_max", "centroid", "separation", "mu_h_film"):
    assert data[name].shape == shape

# Status, and what failed is NaN everywhere.
status = data["status"]
assert status.dtype == np.int8
meanings = dict(zip(status.attrs["flag_values"].tolist(), status.attrs["flag_meanings"].split(), strict=True))
assert meanings == {0: "converged", 1: "failed"}, meanings
assert [meanings[v] for v in status.values.ravel().tolist()] == summary["status"]
failed = data.where(status == 1, drop=True)
assert (status == 1).sum() == 1 and np.isnan(failed["mu_v"]).all() and np.isnan(failed["mu_h"]).all()
for name in fields:
    assert data[name].attrs["units"] and np.isnan(data[name].encoding["_FillValue"])
    assert np.isnan(data[name].where(status == 1)).all()
    assert not np.isnan(data[name].values[status.values == 0]).any()

# Selecting as the documentation shows it, with an infinite alpha on the axis.
assert np.isinf(data.alpha.values[-1])
one = data.sel(alpha=1.0, beta=100.0, method="nearest").sel(f=100.0)
assert float(one.alpha) == 1.0 and float(one.beta) == 100.0
assert float(one["pressure"].sel(x=0.0, method="nearest")) == 1.0
assert float(data.sel(alpha=1.2, method="nearest").alpha) == 1.0
assert float(data.sel(alpha=np.inf).alpha) == np.inf

# Units are those that libraries of units know; what a number is over is another attribute.
for name, variable in data.variables.items():
    if "units" in variable.attrs:
        assert pint.Unit(variable.attrs["units"]).dimensionless, name
assert data["mu_v"].attrs["scale"] == "a0/R" and data["pressure"].attrs["scale"] == "2N/(pi a0)"

# The summary as pandas reads it.
table = pd.read_csv(directory / "summary.csv", dtype={"case": str})
assert (table.dtypes.drop(["case", "status", "reason"]).map(lambda dtype: dtype.kind) == "f").all(), table.dtypes
assert np.isinf(table["alpha"].max()) and table["mu_v"].isna().sum() == 1

# The file speaks for itself.
assert data.attrs["Conventions"] == "CF-1.10"
assert data.attrs["title"] == "synthetic, β from 10"
assert data.attrs["sweep"] == (directory / "sweep.toml").read_text(encoding="utf-8")
assert data.attrs["history"] == f"stribeck {data.attrs['stribeck_version']}: run sweep.toml"
assert data.attrs["source"] and "doi.org" in data.attrs["references"]
assert (data.attrs["method"], data.attrs["tolerance"]) == ("made up", 1e-5)
print(f"{engine}: {len(data.data_vars)} variables on {dict(data.sizes)}")
