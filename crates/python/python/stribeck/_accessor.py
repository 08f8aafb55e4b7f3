"""The accessor ``.stribeck`` of data sets."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
import xarray

from ._errors import InputError
from ._packages import axes

if TYPE_CHECKING:
    from matplotlib.axes import Axes


class Accessor:
    """Cases, curves and pictures of the results of `stribeck.solve`, `stribeck.open` and `Experiment.curve`."""

    def __init__(self, data: xarray.Dataset):
        self._data = data

    @property
    def failed(self) -> xarray.DataArray:
        """True where a case failed."""
        return self._data["status"] != 0

    def nearest(self, **wanted: float) -> xarray.Dataset:
        """Take the nearest case: ``nearest(alpha=1, beta=100)``.

        Distances are those of logarithms; 0 and inf are near to themselves alone. A dimension with one value need not
        be named.

        Parameters
        ----------
        **wanted : float
            A value of each dimension, as in ``alpha=1``; the nearest one is taken.

        Returns
        -------
        xarray.Dataset
            What is left of the data set there.

        Raises
        ------
        InputError
            If a name is no dimension.
        """
        places = {name: self._nearest(name, value) for name, value in wanted.items()}
        return self._data.isel(places)

    def _nearest(self, name: str, wanted: float) -> int:
        if name not in self._data.indexes:
            known = ", ".join(str(known) for known in self._data.indexes if known != "x")
            raise InputError(f"{name} is no dimension of this data set, which has {known}")
        values = self._data[name].values.astype(float)
        if (values < 0).any() or wanted < 0:
            return int(np.argmin(np.abs(values - wanted)))
        with np.errstate(divide="ignore", invalid="ignore"):
            distances = np.where(values == wanted, 0.0, np.abs(np.log(values) - np.log(wanted)))
        return int(np.argmin(np.where(np.isnan(distances), np.inf, distances)))

    def case(self, identity: str) -> xarray.Dataset:
        """Take a case by its id; of several places with it the first.

        Parameters
        ----------
        identity : str
            The id, as in the variable ``case`` or the column of summary.csv.

        Returns
        -------
        xarray.Dataset
            The case.

        Raises
        ------
        InputError
            If there is none.
        """
        found = np.argwhere(self._data["case"].values.astype(str) == identity)
        if found.size == 0:
            raise InputError(f"there is no case {identity!r}: ids stand in the variable `case`")
        return self._data.isel(dict(zip(self._data["case"].dims, found[0].tolist(), strict=True)))

    def curve(self, **wanted: float) -> xarray.Dataset:
        """Take a Stribeck curve: nearest in the named dimensions, along the last one that is left.

        Parameters
        ----------
        **wanted : float
            A value of each dimension, as in ``alpha=1``; the nearest one is taken.

        Returns
        -------
        xarray.Dataset
            The curve, of one dimension, and x for fields.

        Raises
        ------
        InputError
            If more than one dimension with several values is left.
        """
        picked = self.nearest(**wanted) if wanted else self._data
        dims = [str(dim) for dim in picked["mu_drag"].dims]
        others = [dim for dim in dims[:-1] if picked.sizes[dim] > 1]
        if others or not dims:
            raise InputError(
                f"a curve is along one dimension, and {', '.join(dims) or 'none'} are left: name the others"
            )
        return picked.isel(dict.fromkeys(dims[:-1], 0))

    def plot_curve(self, *, ax: Axes | None = None, **wanted: float) -> Axes:
        """Draw friction and its parts along a curve; with several values of one more dimension the drag of each.

        Parameters
        ----------
        ax : matplotlib.axes.Axes, optional
            Where it is drawn; a new picture by default.
        **wanted : float
            A value of each dimension, as in ``alpha=1``; the nearest one is taken.

        Returns
        -------
        matplotlib.axes.Axes
            What it is drawn into.

        Raises
        ------
        InputError
            If more dimensions with several values are left.
        ImportError
            Without matplotlib.
        """
        ax = axes(ax)
        data = self.nearest(**wanted) if wanted else self._data
        data = data.squeeze([dim for dim in data["mu_drag"].dims[:-1] if data.sizes[dim] == 1])
        dims = [str(dim) for dim in data["mu_drag"].dims]
        if len(dims) > 2 or not dims:
            raise InputError(f"a picture has one curve or a family of them, and {', '.join(dims) or 'none'} are left")
        along = dims[-1]
        if len(dims) == 2:
            units = data[dims[0]].attrs.get("units", "1").replace("1", "")
            for value in data[dims[0]].values:
                label = f"{_SYMBOLS.get(dims[0], dims[0].replace('_', ' '))} = {value:.5g} {units}".rstrip()
                ax.plot(data[along], data["mu_drag"].sel({dims[0]: value}), ".-", ms=4, label=label)
        else:
            # The drag is the sum of the others, whatever the slide-to-roll ratio is.
            parts = {
                "drag": data["mu_drag"],
                "hysteresis": data["mu_v"],
                "shear": data["mu_drag"] - data["mu_v"] + data["mu_pressure"],
                "pressure flow": -data["mu_pressure"],
            }
            for label, part in parts.items():
                ax.plot(data[along], part, ".-", ms=4, label=label)
        ax.set(xscale="log", xlabel=_label(data[along]), ylabel=_friction(data["mu_drag"]))
        ax.legend(loc="lower left", bbox_to_anchor=(0, 1), frameon=False, ncols=2)
        return ax

    def plot_surface(self, quantity: str = "mu_drag", *, ax: Axes | None = None, **wanted: float) -> Axes:
        """Draw a quantity over α and β, or over two other dimensions, as a map with contours.

        Cases that failed are crossed.

        Parameters
        ----------
        quantity : str, default "mu_drag"
            A column.
        ax : matplotlib.axes.Axes, optional
            Where it is drawn; a new picture by default.
        **wanted : float
            A value of each dimension, as in ``alpha=1``; the nearest one is taken.

        Returns
        -------
        matplotlib.axes.Axes
            What it is drawn into.

        Raises
        ------
        InputError
            If there is no such column, or not two dimensions are left.
        ImportError
            Without matplotlib.
        """
        ax = axes(ax)
        if quantity not in self._data:
            raise InputError(f"there is no column {quantity!r}: there are {', '.join(map(str, self._data.data_vars))}")
        data = (self.nearest(**wanted) if wanted else self._data)[quantity]
        data = data.squeeze([dim for dim in data.dims if data.sizes[dim] == 1])
        if data.ndim != 2:
            raise InputError(f"a surface is over two dimensions, and {', '.join(map(str, data.dims))} are left")
        y, x = data.dims
        finite = data.isel({dim: np.isfinite(data[dim].values) & (data[dim].values > 0) for dim in data.dims})
        filled = ax.contourf(finite[x], finite[y], finite, levels=15)
        ax.contour(finite[x], finite[y], finite, levels=filled.levels, colors="white", linewidths=0.4)
        ax.figure.colorbar(filled, ax=ax, label=_friction(data) if quantity.startswith("mu_") else _label(data))
        failed = self.failed.squeeze().where(self.failed.squeeze(), drop=True)
        if failed.size:
            rows, columns = np.nonzero(self.failed.squeeze().transpose(y, x).values)
            ax.plot(data[x].values[columns], data[y].values[rows], "kx", ms=4)
        ax.set(xscale="log", yscale="log", xlabel=_label(data[x]), ylabel=_label(data[y]))
        return ax

    def plot_profile(self, *, ax: Axes | None = None, **wanted: float) -> Axes:
        """Draw pressure and film of the nearest case along x.

        Parameters
        ----------
        ax : matplotlib.axes.Axes, optional
            Where it is drawn; a new picture by default.
        **wanted : float
            A value of each dimension, as in ``alpha=1``; the nearest one is taken.

        Returns
        -------
        matplotlib.axes.Axes
            What it is drawn into.

        Raises
        ------
        InputError
            If the data set has no such fields, or several cases are left.
        """
        ax = axes(ax)
        case = self.nearest(**wanted) if wanted else self._data
        names = [name for name in ("pressure", "film_thickness", "displacement") if name in case]
        if not names:
            raise InputError("the data set has no fields: solve with fields=True, or name them in [output]")
        for name in names:
            profile = case[name].squeeze()
            if profile.ndim != 1:
                raise InputError(f"a profile is of one case, and {', '.join(map(str, profile.dims[:-1]))} are left")
            ax.plot(case["x"], profile, label=f"{profile.attrs['long_name']} ({_unit(profile)})")
        ax.set(xlabel="x (a₀)")
        ax.legend(loc="lower left", bbox_to_anchor=(0, 1), frameon=False)
        return ax


register: Any = xarray.register_dataset_accessor
register("stribeck")(Accessor)

_SYMBOLS = {"alpha": "α", "beta": "β", "f": "f", "slide_roll": "S"}


def _unit(array: xarray.DataArray) -> str:
    """What the numbers are in: a unit of SI, or what they are over."""
    return str(array.attrs.get("scale", array.attrs.get("units", "1")))


def _label(array: xarray.DataArray) -> str:
    """Name and unit of a coordinate."""
    name = str(array.name)
    text = _SYMBOLS.get(name, name.replace("_", " "))
    unit = _unit(array)
    return text if unit == "1" else f"{text} ({unit})"


def _friction(array: xarray.DataArray) -> str:
    name = str(array.name)
    return name if _unit(array) == "1" else f"{name} over a₀/R"
