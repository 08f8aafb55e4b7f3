"""Packages that are not required: what needs one says so."""

from __future__ import annotations

from importlib import import_module
from importlib.util import find_spec
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from matplotlib.axes import Axes


def require(names: list[str], purpose: str) -> None:
    """Refuse to go on without some packages.

    Raises
    ------
    ImportError
        If they are not all installed: what needs them, and how those that are missing are installed.
    """
    missing = [name for name in names if find_spec(name) is None]
    if missing:
        raise _missing(missing, purpose)


def _missing(names: list[str], purpose: str) -> ImportError:
    are = "is" if len(names) == 1 else "are"
    return ImportError(
        f"{purpose} needs {' and '.join(names)}, which {are} not installed here: "
        f'pip install {" ".join(names)}, or "stribeck[all]"',
        name=names[0],
    )


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
        raise _missing([name.partition(".")[0]], purpose) from error


def axes(ax: Axes | None) -> Axes:
    """Give the axes to draw into: those of the caller, or new ones."""
    if ax is not None:
        return ax
    pyplot = package("matplotlib.pyplot", "a picture")
    new: Axes = pyplot.subplots(figsize=(4.5, 3.2), layout="constrained")[1]
    return new
