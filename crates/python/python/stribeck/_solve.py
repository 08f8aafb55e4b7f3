"""`solve`: points of α, β and f."""

from __future__ import annotations

import sys
from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _native
from ._datasets import Variable, dataset, variables
from ._errors import InputError
from ._given import number, numbers, whole

if TYPE_CHECKING:
    import xarray

_INPUTS = ("slide_roll", "f", "alpha", "beta")


def solve(
    alpha: ArrayLike,
    beta: ArrayLike,
    f: ArrayLike,
    *,
    modes: Iterable[Sequence[float]] | None = None,
    roller_modes: Iterable[Sequence[float]] | None = None,
    slide_roll: ArrayLike = 1.0,
    tolerance: float = 1e-5,
    fields: bool | str | Sequence[str] = False,
    x: ArrayLike | None = None,
    sensitivities: bool = False,
    threads: int | None = None,
) -> xarray.Dataset:
    """Solve the lubricated sliding of a cylinder on a viscoelastic half space.

    The numbers are broadcast as numpy does it, and every place of the result is solved by the collocation method, in
    parallel. Places that are near to each other are solved one after the other, each from the solution before it;
    which these are depends on the set of places alone, so the same call gives the same bytes with any number of
    threads.

    Parameters
    ----------
    alpha : array_like or xarray.DataArray
        Slide time over retardation time a0/(V tau), at least 0, or inf. Dimensionless.
    beta : array_like or xarray.DataArray
        Inverse Hersey number, finite and above 0. Dimensionless.
    f : array_like or xarray.DataArray
        Strength of retardation E0/Einf - 1, finite and at least 0.
    modes : sequence of (share, time), optional
        Retardation spectrum: parts of f, which add up to 1, and times over the one in alpha. One time by default.
    roller_modes : sequence of (share, time), optional
        Those of the roller; shares of both bodies add up to 1. A rigid or elastic roller by default. Times are over
        the one in alpha, too, which is that of the flat as it moves; the roller moves by as `slide_roll` says.
    slide_roll : array_like or xarray.DataArray, default 1.0
        Slide-to-roll ratio (u2 - u1)/(u1 + u2) of flat and roller, from -1 to 1: 1 is a roller that does not turn.
    tolerance : float, default 1e-5
        Relative error wanted in mu_v, mu_h and c, from 1e-10 to 0.1.
    fields : bool, str or sequence of str, default False
        Fields along x: True for all, or some of ``pressure``, ``film_thickness``, ``displacement``,
        ``shear_traction``, ``hysteresis_traction``.
    x : array_like, shape (n,), optional
        Where the fields are wanted, ascending, in units of a0. By default 601 places from -3 to 3.
    sensitivities : bool, default False
        Also d ln(mu)/d ln(alpha) and the like, as ``dln_mu_tot_dln_alpha``, with their errors. alpha and f are those
        of both bodies, which change together.
    threads : int, optional
        Solver threads, from 1 to 1024. One for each core by default.

    Returns
    -------
    xarray.Dataset
        The columns of results.h5 with their units and long names, of the broadcast shape; fields have x as their last
        dimension. Friction coefficients are over a0/R, film thicknesses over a0^2/R, pressures over 2N/(pi a0). A
        place that failed has NaN, the status 1 and a reason. A dimension along which one input alone changes has its
        name; others are called ``point``, or ``axis_0``, ``axis_1``, …. Without xarray it is a mapping of arrays.

    Raises
    ------
    InputError
        If a number or an option may not be.
    KeyboardInterrupt
        Soon after Ctrl-C.

    Notes
    -----
    The threads are started for each call and end with it, so a process may fork between calls.

    Examples
    --------
    >>> import numpy as np, stribeck
    >>> curve = stribeck.solve(1.0, np.geomspace(10, 1000, 5), 10.0)
    >>> curve.mu_tot.dims
    ('beta',)
    """
    tolerance = number("tolerance", tolerance)
    given = dict(zip(_INPUTS, (slide_roll, f, alpha, beta), strict=True))
    dims, arrays = _broadcast(given)
    shape = arrays["alpha"].shape
    request = {name: np.ascontiguousarray(array, dtype=float).ravel() for name, array in arrays.items()}
    answer = _native.solve(
        {
            **request,
            "modes": None if modes is None else _modes("modes", modes),
            "roller_modes": None if roller_modes is None else _modes("roller_modes", roller_modes),
            "tolerance": tolerance,
            "fields": _fields(fields),
            "x": None if x is None else numbers("x", x).ravel().tolist(),
            "sensitivities": bool(sensitivities),
            "threads": whole("threads", threads),
        }
    )
    described = {name: dict(attrs) for name, _, attrs in answer["inputs"]}
    _, places, attrs = answer["x"]
    data = variables(answer["variables"], dict(zip(dims, shape, strict=True)), len(places))
    coordinates = {name: _coordinate(name, arrays[name], dims, described[name]) for name in _INPUTS}
    if any("x" in variable.dims for variable in data.values()):
        coordinates["x"] = Variable(("x",), places, dict(attrs))
    return dataset(data, coordinates, {"Conventions": "CF-1.10", "source": f"stribeck.solve, tolerance {tolerance:g}"})


def _broadcast(given: dict[str, Any]) -> tuple[tuple[str, ...], dict[str, NDArray[np.float64]]]:
    """Give all inputs one shape, and name its dimensions: as xarray's arrays among them do, or after the inputs."""
    xarray = sys.modules.get("xarray")
    if xarray is not None and any(isinstance(values, xarray.DataArray) for values in given.values()):
        plain = [name for name, it in given.items() if not isinstance(it, xarray.DataArray) and np.ndim(it) > 0]
        if plain:
            raise InputError(f"{plain[0]} is an array without named dimensions beside one with: give it as a DataArray")
        try:
            same = xarray.broadcast(*(xarray.DataArray(values) for values in given.values()))
        except ValueError as error:
            raise InputError(f"the dimensions of the arrays do not go together: {error}") from None
        for name, it in given.items():
            for dim, size in it.sizes.items() if isinstance(it, xarray.DataArray) else ():
                if size != same[0].sizes[dim]:
                    raise InputError(f"{name} has other coordinates along {dim} than the others: give all the same")
        dims = tuple(str(dim) for dim in same[0].dims)
        return dims, {name: numbers(name, array.values) for name, array in zip(given, same, strict=True)}
    arrays = {name: numbers(name, values) for name, values in given.items()}
    try:
        same = np.broadcast_arrays(*arrays.values())
    except ValueError:
        shapes = ", ".join(f"{name} {array.shape}" for name, array in arrays.items() if array.ndim)
        raise InputError(f"shapes do not go together: {shapes}; numpy.broadcast_shapes tells how they may") from None
    return _dims(arrays, same[0].shape), dict(zip(arrays, same, strict=True))


def _dims(given: dict[str, NDArray[np.float64]], shape: tuple[int, ...]) -> tuple[str, ...]:
    """Name each dimension after the input that alone changes along it."""
    names = []
    for axis in range(len(shape)):
        # Counted from the last one, as numpy broadcasts.
        back = axis - len(shape)
        shapes = {name: values.shape for name, values in given.items()}
        having = [name for name, own in shapes.items() if len(own) >= -back]
        changing = [name for name in having if shapes[name][back] > 1] or having
        # An input that changes along another dimension, too, is no coordinate of this one.
        alone = [name for name in changing if np.prod(shapes[name]) == shapes[name][back]]
        names.append(
            changing[0] if len(changing) == len(alone) == 1 else "point" if len(shape) == 1 else f"axis_{axis}"
        )
    return tuple(names)


def _coordinate(name: str, array: NDArray[np.float64], dims: tuple[str, ...], attrs: dict[str, Any]) -> Variable:
    """Make an input a coordinate: along its own dimension, or as one number, or at each place."""
    if name in dims:
        axis = dims.index(name)
        index = tuple(slice(None) if i == axis else 0 for i in range(array.ndim))
        # Without places there is nothing to pick.
        values = array[index] if array.size else np.empty(array.shape[axis])
        return Variable((name,), np.array(values), attrs)
    if array.size and np.all(array == array.flat[0]):
        return Variable((), np.array(array.flat[0]), attrs)
    return Variable(dims, np.array(array), attrs)


def _modes(name: str, modes: Iterable[Sequence[float]]) -> list[tuple[float, float]]:
    try:
        return [(float(share), float(time)) for share, time in modes]
    except (TypeError, ValueError):
        raise InputError(
            f"{name} are pairs of a share of f and a time, as in [(0.7, 1.0), (0.3, 100.0)]; those of a Material "
            "are its attribute modes"
        ) from None


def _fields(fields: bool | str | Sequence[str]) -> list[str]:
    if isinstance(fields, str):
        return [fields]
    if isinstance(fields, (bool, np.bool_)):
        return list(_native.FIELDS) if fields else []
    try:
        return [str(field) for field in fields]
    except TypeError:
        known = ", ".join(_native.FIELDS)
        raise InputError(f"fields must be True, False, or a list of {known}; found {fields!r:.60}") from None
