"""Packages that are not required: what needs one says so."""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from matplotlib.axes import Axes


def package(name: str, purpose: str) -> Any:
    """Import a package.

    Raises
    ------
    ImportError
        If it is not installed: what needs it, and how it is installed.
    """
    try:
        return import_module(name)
    except ImportError as error:
        root = name.partition(".")[0]
        raise ImportError(
            f'{purpose} needs {root}, which is not installed here: pip install {root}, or "stribeck[all]"', name=root
        ) from error


def axes(ax: Axes | None) -> Axes:
    """Give the axes to draw into: those of the caller, or new ones."""
    if ax is not None:
        return ax
    pyplot = package("matplotlib.pyplot", "a picture")
    new: Axes = pyplot.subplots(figsize=(4.5, 3.2), layout="constrained")[1]
    return new
