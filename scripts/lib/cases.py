"""Converged cases of a data set, dimensionless and with what its sweep file says of them."""

import h5py
import numpy as np
import tomllib

from lib.creep import modes_of
from lib.messages import fail

SCALES = {"a0/R": "friction_scale", "a0^2/R": "film_scale", "2N/(pi a0)": "pressure_scale"}
SCALES |= {"m": "film_scale", "Pa": "pressure_scale"}
FIELDS = ["pressure", "film_thickness", "displacement"]
NEEDED = ["mu_v", "mu_h", "mu_drag", "mu_pressure", "mu_shear", "mu_v_roller", "energy_residual", "c", "separation"]
NEEDED += ["x_outlet", "error_mu_v", "error_mu_h", "error_mu_drag", "error_mu_pressure", "error_mu_shear", "error_c"]


def open_fields(path):
    """The data set and its sweep file; ends the script where there is nothing to audit."""
    if not path.is_file():
        fail(f"{path}: no such file; give a directory in which `stribeck run` has published its results")
    data = h5py.File(path)
    sweep = tomllib.loads(data.attrs["sweep"])
    if not all(field in data for field in FIELDS[:2]):
        fail(
            f"{path}: no pressure or no film_thickness among its fields; name both in `output.fields` and run it again"
        )
    return data, sweep


def sliding(at):
    """S, half of the slide-to-roll ratio."""
    if "roller_speed" in at:
        return (at["flat_speed"] - at["roller_speed"]) / (at["flat_speed"] + at["roller_speed"])
    return at.get("slide_roll", at.get("slide_roll_ratio", 2.0) / 2)


def read_cases(data, sweep):
    """Yields each converged case once, dimensionless: a dictionary of its place, columns, fields and settings."""
    modes, solver = modes_of(sweep), sweep.get("solver", {})
    speeds = [name for name in ("slide_roll_ratio", "roller_speed", "flat_speed") if name in data]
    fixed = {name: float(data[name][()]) for name in speeds if data[name].ndim == 0}
    axes = [scale.name.strip("/") for scale in (dimension[0] for dimension in data["mu_v"].dims)]
    seen = set()
    for index in np.ndindex(data["mu_v"].shape):
        at = {axis: float(data[axis][i]) for axis, i in zip(axes, index, strict=True)}
        ratio = sliding(at | fixed)
        name = (data["case"][index], ratio)
        if data["status"][index] or name in seen:
            continue
        seen.add(name)
        case = {"place": ", ".join(f"{axis} = {value:.6g}" for axis, value in at.items()), "S": ratio, **at}
        for key in ["alpha", "beta"]:
            case[key] = float(data[key][index]) if data[key].ndim > 1 else at[key]
        for key in NEEDED + [field for field in FIELDS if field in data]:
            case[key] = data[key][index] / scale_of(data, key, index)
        case["x"], case["cavity_shear"] = data["x"][:], data.attrs["cavity_shear"]
        case["modes"] = list(retardation(case, modes))
        case["tolerance"] = solver.get("tolerance", 1e-5)
        if solver.get("method") == "relaxation":
            case["tolerance"] = sum(case[f"error_{name}"] for name in ("mu_v", "mu_h", "c"))
        if np.isnan(case["tolerance"]):
            raise ValueError(
                f"no estimated errors at {case['place']}; the relaxation method has them by `estimate = true`"
            )
        yield case


def retardation(case, modes):
    """Strength and rate of each mode of a case; α is that of the flat, and the roller's surface has another speed."""
    faster = (1 + case["S"]) / (1 - case["S"]) if case["S"] < 1 else np.inf
    for share, rate, on_roller in modes:
        yield case["f"] * share, case["alpha"] * rate * (faster if on_roller else 1)


def scale_of(data, key, index):
    """What a number in SI units is divided by to be dimensionless."""
    if "friction_scale" not in data or key.startswith(("error", "energy")):
        return 1.0
    if key == "x_outlet":
        return data["a0"][index]
    return data["friction_scale" if key.startswith("mu_") else SCALES[data[key].attrs["units"]]][index]
