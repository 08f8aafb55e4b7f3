"""Values and sections as the text of a sweep file."""

from __future__ import annotations

import json
from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from . import _native
from ._errors import InputError
from ._given import is_quantity, magnitude, refuse_masked

#: The unit of SI that belongs to a name.
UNITS = (
    dict(_native.QUANTITIES)
    | {"roughness": "m", "thickness": "m", "modulus": "Pa", "time": "s"}
    # Keys of the laws of temperature.
    | {"activation_energy": "J/mol", "reference": "K", "c2": "K", "b": "K", "c": "K", "value": "Pa s"}
)


def section(name: str, values: Mapping[str, Any]) -> str:
    """Write a section of a sweep file."""
    lines = [f"{key} = {value(key, it)}" for key, it in values.items() if it is not None]
    return "\n".join([f"[{name}]", *lines, ""])


def value(key: str, it: Any) -> str:
    """Write a value: a number in SI units, a text with a unit, a quantity of pint, a list or a table of these."""
    refuse_masked(key, it)
    if is_quantity(it):
        return value(key, _magnitude(key, it))
    if isinstance(it, Mapping):
        return "{ " + ", ".join(f"{inner} = {value(_inner(key, inner), its)}" for inner, its in it.items()) + " }"
    if isinstance(it, str):
        # A text of JSON is one of TOML.
        return json.dumps(it, ensure_ascii=False).replace("\x7f", "\\u007f")
    if isinstance(it, (list, tuple)) or np.ndim(it) > 0:
        return "[" + ", ".join(value(key, each) for each in it) + "]"
    if isinstance(it, (bool, np.bool_)):
        return "true" if it else "false"
    try:
        return str(int(it)) if key == "points" else repr(float(it))
    except (TypeError, ValueError):
        raise InputError(
            f'{key} must be a number in SI units, a text with a unit as in "2 mm", or a quantity of pint, '
            f"found {it!r:.60}"
        ) from None


def _inner(key: str, inner: str) -> str:
    """The name by which the unit of a value of a table is known: ends of a range have that of the range."""
    return key if inner in ("from", "to") else inner


def _magnitude(key: str, quantity: Any) -> Any:
    """Take the number of a quantity of pint in SI units."""
    if key not in UNITS:
        raise InputError(f"{key} has no unit here, found {quantity}")
    return magnitude(key, quantity, UNITS[key])


def si(kind: str, it: Any) -> NDArray[np.float64]:
    """Read a number, or an array of numbers or texts, in SI units.

    Parameters
    ----------
    kind : str
        A quantity of the laboratory, or ``modulus``, ``time``.
    it : float, str, pint quantity, or an array of these
        What was given.
    """
    refuse_masked(kind, it)
    if is_quantity(it):
        it = _magnitude(kind, it)
    # Numbers beside texts would become texts.
    array = np.asarray(it, dtype=object if isinstance(it, (list, tuple)) else None)
    if array.dtype == object and all(isinstance(each, (int, float)) for each in array.flat):
        array = array.astype(float)
    if array.dtype.kind in "fiu":
        # One by one the same is asked of numbers and of texts; of many numbers the least and the largest tell.
        array = array.astype(float)
        if array.size:
            ends = array if np.isnan(array).any() else (array.min(), array.max())
            for end in np.ravel(ends):
                _native.si(kind, repr(float(end)))
        return array
    given = array.ravel().tolist()
    if any(isinstance(each, (list, tuple)) for each in given):
        raise InputError(f"{kind} has lists of different lengths: give one list, or an array")
    flat = [_native.si(kind, value(kind, each)) for each in given]
    return np.array(flat, dtype=float).reshape(array.shape)
