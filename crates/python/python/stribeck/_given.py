"""What people give: numbers in arrays, series of pandas or quantities of pint; texts; paths. Others are refused."""

from __future__ import annotations

import operator
import os
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ._errors import InputError


def is_quantity(it: Any) -> bool:
    """Tell whether something is a quantity of pint, which need not be installed."""
    return hasattr(it, "magnitude") and hasattr(it, "to")


def magnitude(name: str, quantity: Any, units: str) -> Any:
    """Take the number of a quantity of pint in these units; "1" for what has none."""
    try:
        return quantity.to("" if units == "1" else units).magnitude
    except Exception as error:  # pint's own kinds
        kind = "have no unit" if units == "1" else f"be in {units} or a unit of that kind"
        raise InputError(f"{name} must {kind}, found {quantity!s:.60}: {error}") from error


def refuse_masked(name: str, it: Any) -> None:
    """Refuse arrays with masked values: what is behind the mask is no measurement."""
    mask: Any = it.mask if isinstance(it, np.ma.MaskedArray) else np.False_
    if mask.any():
        raise InputError(f"{name} has masked values, {mask.sum()} of {mask.size}: leave them out, or fill them")


def numbers(name: str, it: Any, units: str = "1") -> NDArray[np.float64]:
    """Give numbers, or quantities of pint in these units, as an array of floats."""
    return _numbers(name, it, units, "a number or an array of numbers")


def number(name: str, it: Any, units: str = "1") -> float:
    """Give one number."""
    array = _numbers(name, it, units, "a number")
    if array.ndim:
        raise InputError(f"{name} must be one number, found {it!r:.60}")
    return float(array)


def _numbers(name: str, it: Any, units: str, kind: str) -> NDArray[np.float64]:
    def none(found: Any) -> InputError:
        plain = found.item() if isinstance(found, np.generic) else found
        unit = "without a unit" if units == "1" else f"in {units}"
        return InputError(f"{name} must be {kind} {unit}, found {plain!r:.60}")

    refuse_masked(name, it)
    if is_quantity(it):
        it = magnitude(name, it, units)
    elif isinstance(it, (list, tuple)) and any(map(is_quantity, it)):
        it = [magnitude(name, each, units) if is_quantity(each) else each for each in it]
    try:
        array = np.asarray(it)
    except (TypeError, ValueError):
        # Lists of different lengths in a list.
        raise none(it) from None
    if array.dtype.kind in "biuf":
        return array.astype(float)
    for each in array.flat:
        try:
            # Texts may be numbers; dates and complex numbers are none.
            if array.dtype.kind not in "OSU":
                raise TypeError
            float(each)
        except (TypeError, ValueError):
            raise none(each) from None
    return array.astype(float)


def whole(name: str, it: Any) -> int | None:
    """Give a whole number, or None."""
    if it is None:
        return None
    try:
        found = operator.index(it)
    except TypeError:
        raise InputError(f"{name} must be a whole number, found {it!r:.60}") from None
    if abs(found) >= 1 << 63:
        raise InputError(f"{name} must be a whole number of at most 18 digits, found {found!r:.60}")
    return found


def text(name: str, it: Any, example: str) -> str | None:
    """Give a text, or None."""
    if it is None or isinstance(it, str):
        return it
    raise InputError(f"{name} must be a text as in {example}, found {it!r:.60}")


def path(name: str, it: Any, kind: str = "the path of a file") -> Path:
    """Give the path of a file."""
    if isinstance(it, (str, os.PathLike)):
        return Path(it)
    raise InputError(f"{name} must be {kind}, found {it!r:.60}")
