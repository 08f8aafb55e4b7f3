"""Surfaces: friction as a function of its axes, from the file that `stribeck surface` makes.

This file needs numpy alone: a copy of it reads surfaces where the package is not installed.
"""

from __future__ import annotations

import base64
import json
import math
import os
from pathlib import Path
from typing import Any, Literal, TypeAlias, overload

import numpy as np
from numpy.polynomial import chebyshev
from numpy.typing import ArrayLike, NDArray

try:
    from ._errors import InputError, StorageError
    from ._native import universe
except ImportError:  # a copy, without the package
    InputError, StorageError = ValueError, OSError  # type: ignore[misc, assignment]

    def universe() -> str:
        """Have no surface."""
        raise InputError("the surface that is built in comes with the package stribeck; name a surface.json")


_Array: TypeAlias = NDArray[Any]
_Values: TypeAlias = dict[str, _Array]

#: What the key `format` of a file says that is known here.
FORMAT = "stribeck surface 1"

_CHECK = 1e-12  # how far a value at a check point may be from the one in the file
_NUMBERS = {"float32": "<f4", "float64": "<f8"}
_BLOCK = 1 << 18  # numbers in the largest array that is made for a block of points
_PRODUCT = 1 << 18  # multiplications in a product of matrices that OpenBLAS leaves to one thread


class Surface:
    """Friction and film as functions of one to three axes, with a measured error.

    Reading compares the surface with the check points of its file. Calling it gives the quantities at points.

    Parameters
    ----------
    path : path, optional
        A surface.json, as `stribeck surface` makes it; docs/reference/surface-file.md has the format. Without one, the
        surface that is built in: materials with one retardation mode under a sliding roller, over all alpha, beta
        from 1 to 1e8 and f from 0 to 1e4.

    Attributes
    ----------
    axes : dict of str to (float, float)
        The least and the largest value of each axis, in the order of the coordinates.
    quantities : dict of str to str
        What each quantity is, in words.
    units : dict of str to str
        Unit of each axis and quantity; of a dimensionless quantity what it is over, as in "a0/R".
    tolerance : float
        The relative error that was asked for.
    certificate : dict
        How far the surface was from `points` solutions at random places: `errors` has the `largest`, that which 99 %
        do not exceed (`percentile_99`) and the `median` of each quantity. Measured, not proved.

    Raises
    ------
    InputError
        If the file is of another format or damaged; a ValueError.
    StorageError
        If the file cannot be read; an OSError.

    Examples
    --------
    >>> surface = Surface()
    >>> surface(alpha=1.0, beta=[100.0, 200.0], f=100.0)["mu_drag"].round(2)
    array([0.75, 0.72])
    """

    def __init__(self, path: str | os.PathLike[str] | None = None):
        try:
            file = json.loads(universe() if path is None else Path(path).read_bytes())
            found = file["format"]
        except OSError as error:
            raise StorageError(f"{path}: cannot read the surface: {error.strerror}; is it the right path?") from error
        except (ValueError, TypeError, KeyError):
            raise InputError(f"{path}: not a surface; `stribeck surface` makes the file") from None
        if found != FORMAT:
            raise InputError(
                f"{path}: the format is `{found}`, and this reader knows `{FORMAT}`; take one that fits it"
            )
        try:
            # Numbers of a damaged file may be anything.
            with np.errstate(all="ignore"):
                self._take(file)
                self._compare(file["checks"])
        except (ValueError, TypeError, KeyError, AttributeError) as error:
            what = f"it has no key {error}" if isinstance(error, KeyError) else error
            raise InputError(f"{path}: {what}; the file is damaged, make it again with `stribeck surface`") from None

    @overload
    def __call__(self, *coordinates: ArrayLike, derivatives: Literal[False] = ..., **named: ArrayLike) -> _Values: ...

    @overload
    def __call__(
        self, *coordinates: ArrayLike, derivatives: Literal[True], **named: ArrayLike
    ) -> tuple[_Values, dict[str, _Values]]: ...

    def __call__(
        self, *coordinates: ArrayLike, derivatives: bool = False, **named: ArrayLike
    ) -> _Values | tuple[_Values, dict[str, _Values]]:
        """Evaluate the surface at points.

        Parameters
        ----------
        *coordinates, **named : array_like
            A value of each axis, in the order of `axes` or by name, in its unit; broadcast as numpy does it.
        derivatives : bool, default False
            Also the derivatives with respect to the axes.

        Returns
        -------
        values : dict of str to numpy.ndarray
            Each quantity, of the broadcast shape.
        slopes : dict of str to dict of str to numpy.ndarray
            With `derivatives`: those of each quantity with respect to each axis, ``slopes["mu_drag"]["beta"]``. NaN
            at the end 0 of a compact axis.

        Raises
        ------
        InputError
            If a point lies outside the surface, which names the axis: nothing is extrapolated. Also if a coordinate
            is missing, unknown or no number, or shapes do not go together.
        """
        points = self._points(coordinates, named)
        shape, count = points[0].shape, points[0].size
        points = [np.ravel(x) for x in points]
        values = np.empty((len(self._series), count))
        slopes = np.empty((len(self._series), len(points), count)) if derivatives else None
        for start in range(0, count, self._block):
            block = np.s_[..., start : start + self._block]
            self._evaluate([x[block] for x in points], values[block], None if slopes is None else slopes[block])
        # [()] makes numbers of arrays without dimensions.
        named_values = {name: row.reshape(shape)[()] for name, row in zip(self.quantities, values, strict=True)}
        if slopes is None:
            return named_values
        along = [dict(zip(self.axes, (row.reshape(shape)[()] for row in rows), strict=True)) for rows in slopes]
        return named_values, dict(zip(self.quantities, along, strict=True))

    def __repr__(self) -> str:
        """Name the quantities and the ranges."""
        ranges = ", ".join(f"{name} from {start:g} to {end:g}" for name, (start, end) in self.axes.items())
        return f"<Surface of {', '.join(self.quantities)} over {ranges}>"

    def _take(self, file: dict[str, Any]) -> None:
        """Take the parts of a file."""
        self._axes = [_Axis(record) for record in file["axes"]]
        if not 1 <= len(self._axes) <= 3:
            raise ValueError(f"{len(self._axes)} axes, and one to three are possible")
        records = file["quantities"]
        self.axes = {axis.name: (axis.start, axis.end) for axis in self._axes}
        self.quantities = {record["name"]: record["long_name"] for record in records}
        self.units = {record["name"]: record.get("scale") or record["units"] for record in file["axes"] + records}
        self.tolerance = float(file["tolerance"])
        errors = zip(self.quantities, file["certificate"]["errors"], strict=True)
        self.certificate = {**file["certificate"], "errors": dict(errors)}
        names = list(self.quantities)
        self._series = [_Series(record, len(self._axes), names[:place]) for place, record in enumerate(records)]
        self._degrees = [max(len(series.factors[m]) for series in self._series) for m in range(len(self._axes))]
        largest = max(series.core[0].size for series in self._series)
        self._block = max(1, _BLOCK // max(largest, *self._degrees))

    def _compare(self, checks: list[dict[str, Any]]) -> None:
        """Compare the surface with the check points; a part to its share of the whole where it is below that."""
        points = np.array([check["point"] for check in checks], dtype=float).reshape(len(checks), len(self.axes))
        values = np.array([check["values"] for check in checks], dtype=float).reshape(len(checks), len(self._series))
        least = np.zeros_like(values)
        for place, series in enumerate(self._series):
            if series.whole is not None:
                least[:, place] = series.share * np.abs(values[:, series.whole])
        found = np.stack(list(self(*points.T).values()), axis=-1)
        wrong = ~(np.abs(found - values) <= _CHECK * np.maximum(np.abs(values), least))
        if wrong.any():
            number, place = np.argwhere(wrong)[0]
            raise ValueError(
                f"{list(self.quantities)[place]} at check point {number + 1} is {found[number, place]}, and the "
                f"file says {values[number, place]}"
            )

    def _points(self, coordinates: tuple[Any, ...], named: dict[str, Any]) -> list[_Array]:
        """Coordinates on the axes, of one shape."""
        by_order = dict(zip(self.axes, coordinates, strict=False))
        given = by_order | named
        if len(coordinates) + len(named) != len(given) or given.keys() != self.axes.keys():
            names = ", ".join(self.axes)
            raise InputError(f"a point of this surface has {names}: give each of them once, in this order or by name")
        arrays = []
        for axis in self._axes:
            x = _numbers(axis.name, self.units[axis.name], given[axis.name])
            outside = x[~((axis.start <= x) & (x <= axis.end))]
            if outside.size:
                raise InputError(
                    f"{axis.name} = {outside[0]} is outside the surface, which has {axis.name} from "
                    f"{axis.start} to {axis.end}"
                )
            arrays.append(x)
        try:
            return list(np.broadcast_arrays(*arrays))
        except ValueError:
            shapes = ", ".join(f"{name} {x.shape}" for name, x in zip(self.axes, arrays, strict=True) if x.ndim)
            raise InputError(f"shapes do not go together: {shapes}") from None

    def _evaluate(self, points: list[_Array], values: _Array, slopes: _Array | None) -> None:
        """Fill in the values and slopes of a block of points, the last dimension of all arrays."""
        axes = list(zip(self._axes, points, self._degrees, strict=True))
        # Polynomials by points.
        bases = [chebyshev.chebvander(axis.t(x), degrees - 1).T for axis, x, degrees in axes]
        for place, series in enumerate(self._series):
            weights = _weights(series.factors, bases)
            changes = [] if slopes is None else _weights(series.slopes, bases)
            y, dy = _contract(series.core, weights, changes)
            values[place] = series.value(y, values)
            if slopes is not None:
                for m, (axis, x, _) in enumerate(axes):
                    slopes[place, m] = series.slope(y, dy[m] * axis.slope(x), values[: place + 1], slopes[:, m])


def _numbers(name: str, units: str, it: Any) -> _Array:
    """Give the values of a coordinate, which may be a quantity of pint, as floats."""
    mask: Any = it.mask if isinstance(it, np.ma.MaskedArray) else np.False_
    if mask.any():
        raise InputError(f"{name} has masked values, {mask.sum()} of {mask.size}: leave them out")
    try:
        if hasattr(it, "magnitude") and hasattr(it, "to"):
            it = it.to("" if units == "1" else units).magnitude
        x = np.asarray(it)
        # None is no NaN.
        if x.dtype.kind not in "biufOSU" or any(each is None for each in x.flat if x.dtype.kind == "O"):
            raise TypeError
        return x.astype(float)
    except Exception as error:  # of numpy, and pint's own kinds
        unit = "without a unit" if units == "1" else f"in {units}"
        raise InputError(f"{name} must be a number or an array of numbers {unit}, found {it!r:.60}") from error


class _Axis:
    """An axis: t from -1 to 1 is linear in z(x)."""

    def __init__(self, record: dict[str, Any]):
        self.name, self.map = record["name"], record["map"]
        self.start, self.end = float(record["from"]), float(record["to"])
        if self.map not in ("linear", "log", "compact"):
            raise ValueError(f"{self.name} has the map `{self.map}`, which is none")
        self.center = float(record["center"]) if self.map == "compact" else 1.0
        self.z_start, self.z_end = (float(self.z(np.array(end))) for end in (self.start, self.end))
        if not (self.z_start < self.z_end and math.isfinite(self.z_end - self.z_start)):
            raise ValueError(f"{self.name} from {self.start} to {self.end} is no range")

    def z(self, x: _Array) -> _Array:
        """Give z, which reaches x = 0 and infinity on a compact axis."""
        if self.map != "compact":
            return np.log(x) if self.map == "log" else x
        s = self.s(x)
        with np.errstate(invalid="ignore"):
            return np.where(np.isinf(s), 1.0, s / (1.0 + s))

    def s(self, x: _Array) -> _Array:
        """Give the fourth root of x over the center."""
        root: _Array = np.sqrt(np.sqrt(x / self.center))
        return root

    def t(self, x: _Array) -> _Array:
        """Give t; rounding may lead beyond the ends."""
        return np.clip(2.0 * (self.z(x) - self.z_start) / (self.z_end - self.z_start) - 1.0, -1.0, 1.0)

    def slope(self, x: _Array) -> _Array:
        """Give dt/dx; NaN at x = 0 of a compact axis, where it is infinite."""
        if self.map == "linear":
            slope = np.ones_like(x)
        elif self.map == "log":
            slope = 1.0 / x
        else:
            with np.errstate(invalid="ignore"):
                slope = self.z(x) / (4.0 * x * (1.0 + self.s(x)))
        return 2.0 * slope / (self.z_end - self.z_start)


class _Series:
    """The series y of a quantity, in Tucker form, and how the quantity follows from y."""

    def __init__(self, record: dict[str, Any], axes: int, before: list[str]):
        name, shape = record["name"], record["shape"]
        if not len(shape) == len(record["factors"]) == axes:
            raise ValueError(f"{name}: {len(record['factors'])} factors, and {axes} axes")
        self.transform = record["transform"]
        if self.transform not in ("identity", "exp", "sinh", "root"):
            raise ValueError(f"{name} has the transform `{self.transform}`, which is none")
        self.share, self.whole = 0.0, None
        if self.transform in ("sinh", "root"):
            if record["of"] not in before:
                raise ValueError(f"{name}: the quantity that it is a part of is not before it")
            self.share, self.whole = float(record["share"]), before.index(record["of"])
        self.offset = float(record["offset"]) if self.transform == "root" else 0.0
        numbers = _NUMBERS[record["numbers"]]
        # For each axis polynomials by ranks.
        self.factors = [_decode(name, text, numbers, own) for text, own in zip(record["factors"], shape, strict=True)]
        self.core = _decode(name, record["core"], numbers, [rank for _, rank in shape])
        # Chebyshev series of the derivatives with respect to t.
        self.slopes = [chebyshev.chebder(factor) for factor in self.factors]

    def value(self, y: _Array, values: _Array) -> _Array:
        """Give the quantity from y and the quantities before it."""
        if self.whole is not None:
            return np.asarray(self.share * values[self.whole] * self._part(y)[0])
        return np.exp(y) if self.transform == "exp" else y

    def slope(self, y: _Array, dy: _Array, values: _Array, slopes: _Array) -> _Array:
        """Give the derivative of the quantity, the last of the values, from that of y."""
        if self.whole is not None:
            part, change = self._part(y)
            return np.asarray(self.share * (slopes[self.whole] * part + values[self.whole] * change * dy))
        return values[-1] * dy if self.transform == "exp" else dy

    def _part(self, y: _Array) -> tuple[_Array, _Array]:
        """Give what a part is over its share of the whole, and the derivative of that."""
        if self.transform == "sinh":
            return np.sinh(y), np.cosh(y)
        change, least = np.expm1(0.5 * y), math.sqrt(self.offset)
        return change * (change + 2.0 * least), (change + least) * (change + 1.0)


def _decode(name: str, text: str, numbers: str, shape: list[int]) -> _Array:
    """Read numbers in base64."""
    found = np.frombuffer(base64.b64decode(text, validate=True), dtype=numbers).astype(float)
    if found.size != math.prod(shape) or not found.size or not np.isfinite(found).all():
        raise ValueError(f"{name}: {found.size} numbers, and {math.prod(shape)} finite ones are expected")
    return found.reshape(shape)


def _weights(factors: list[_Array], bases: list[_Array]) -> list[_Array]:
    """Give ranks by points of each axis."""
    return [_product(factor.T, basis[: len(factor)]) for factor, basis in zip(factors, bases, strict=True)]


def _product(matrix: _Array, columns: _Array) -> _Array:
    """Multiply in slices: threads that start and wait for each other take longer, much longer if cores are busy."""
    out = np.empty((len(matrix), columns.shape[-1]))
    step = max(1, _PRODUCT // matrix.size)
    for start in range(0, columns.shape[-1], step):
        part = np.s_[:, start : start + step]
        np.matmul(matrix, columns[part], out=out[part])
    return out


def _contract(core: _Array, weights: list[_Array], changes: list[_Array]) -> tuple[_Array, list[_Array]]:
    """Contract the core with the weights of one axis after the other; also with each change in place of its weight."""

    def first(weight: _Array) -> _Array:
        return _product(core.reshape(len(core), -1).T, weight).reshape(*core.shape[1:], -1)

    def then(part: _Array, weight: _Array) -> _Array:
        return np.asarray(np.einsum("a...n,an->...n", part, weight))

    y, slopes = first(weights[0]), [first(change) for change in changes[:1]]
    for m, weight in enumerate(weights[1:], start=1):
        slopes = [then(slope, weight) for slope in slopes] + [then(y, change) for change in changes[m : m + 1]]
        y = then(y, weight)
    return y, slopes
