"""From the arrays of the extension module to data sets."""

from __future__ import annotations

from collections.abc import Mapping
from importlib.util import find_spec
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

if TYPE_CHECKING:
    import xarray


class Variable(NamedTuple):
    """An array with the names of its dimensions and its attributes."""

    dims: tuple[str, ...]
    values: NDArray[Any]
    attrs: dict[str, Any]


class Arrays(dict[str, NDArray[Any]]):
    """A mapping of names to arrays: what stands in for a data set where xarray is not installed.

    Attributes
    ----------
    dims : dict of str to tuple of str
        The names of the dimensions of each array.
    attrs : dict of str to dict
        The attributes of each array: ``units``, ``long_name``.
    """

    def __init__(self, variables: Mapping[str, Variable]):
        super().__init__({name: variable.values for name, variable in variables.items()})
        self.dims = {name: variable.dims for name, variable in variables.items()}
        self.attrs = {name: variable.attrs for name, variable in variables.items()}

    def __getattr__(self, name: str) -> Any:
        """Say what takes the place of an attribute of a data set of xarray."""
        place = f"take [{name!r}]" if name in self else f"install xarray for a data set that may have .{name}"
        raise AttributeError(f"these are arrays by name, as xarray is not installed here: {place}", name=name, obj=self)

    def __repr__(self) -> str:
        """Name the arrays with their dimensions, units and descriptions, a line for each."""
        lines = [f"<{len(self)} arrays by name; with xarray installed they are a data set>"]
        for name, array in self.items():
            sizes = ", ".join(f"{dim}: {size}" for dim, size in zip(self.dims[name], array.shape, strict=True))
            attrs = self.attrs[name]
            unit = attrs.get("scale", attrs.get("units", "no unit"))
            lines.append(f"  {name} ({sizes}) [{unit}] {attrs.get('long_name', '')}"[:80])
        return "\n".join(lines)

    def __reduce__(self) -> tuple[type[Arrays], tuple[dict[str, Variable]]]:
        """Pickle the arrays with their descriptions."""
        parts = {name: Variable(self.dims[name], self[name], self.attrs[name]) for name in self.dims}
        return type(self), (parts,)


def variables(
    native: Mapping[str, tuple[Any, dict[str, Any], bool]], dims: dict[str, int], places_along_x: int
) -> dict[str, Variable]:
    """Give the flat arrays of the extension module the dimensions of the places, and x to fields."""
    made = {}
    for name, (values, attrs, has_x) in native.items():
        array = np.array(values, dtype=object) if isinstance(values, list) else values
        sizes = {**dims, "x": places_along_x} if has_x else dims
        made[name] = Variable(tuple(sizes), array.reshape(tuple(sizes.values())), dict(attrs))
    return made


def dataset(
    data: Mapping[str, Variable], coordinates: Mapping[str, Variable], attrs: Mapping[str, Any]
) -> xarray.Dataset:
    """Make an ``xarray.Dataset``, or `Arrays` where xarray is not installed."""
    if find_spec("xarray") is None:
        arrays: Any = Arrays({**coordinates, **data})
        return arrays  # type: ignore[no-any-return]
    import xarray  # noqa: PLC0415

    from . import _accessor  # noqa: F401, PLC0415

    return xarray.Dataset(dict(data), dict(coordinates), dict(attrs))
