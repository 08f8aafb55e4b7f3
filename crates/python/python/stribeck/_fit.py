"""`fit`: quantities of the laboratory from measured friction."""

from __future__ import annotations

import os
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from . import _native, _toml
from ._errors import InputError
from ._given import is_quantity, magnitude, number, path, refuse_masked, text, whole
from ._packages import axes
from .experiment import Experiment

if TYPE_CHECKING:
    from matplotlib.axes import Axes


@dataclass(frozen=True, eq=False)
class Fit:
    """Quantities of an experiment that were found from measured friction.

    Attributes
    ----------
    values, errors : dict of str to float
        The value of each unknown in SI units, and its standard error; NaN at a bound.
    start : dict of str to float
        Where the search began.
    at_bound : dict of str to bool
        True for an unknown that is at its bound.
    intervals : dict of str to tuple of float, or None
        The ends of each unknown by the profile of the residuals, if that was asked for; NaN for an end not found.
    covariance, correlation : numpy.ndarray, shape (n, n)
        Of the unknowns, in the order of `values`.
    points : dict of str to numpy.ndarray, shape (m,)
        The speed and what else says where a point was measured, ``measured``, its ``error``, ``fitted`` and
        ``residual``.
    along : str
        The name of the speed in `points`.
    reduced_chi_squared, degrees_of_freedom : float, int
        Of the residuals.
    evaluations : int
        How often all points were solved.
    experiment : Experiment or None
        The experiment with the values found, whose ``curve`` is the fitted one; None for a fit to a sweep file.
    understood : str
        What was understood of the files.
    """

    values: dict[str, float]
    errors: dict[str, float]
    start: dict[str, float] = field(repr=False)
    at_bound: dict[str, bool] = field(repr=False)
    intervals: dict[str, tuple[float, float]] | None = field(repr=False)
    covariance: NDArray[np.float64] = field(repr=False)
    correlation: NDArray[np.float64] = field(repr=False)
    points: dict[str, NDArray[np.float64]] = field(repr=False)
    along: str = field(repr=False)
    reduced_chi_squared: float
    degrees_of_freedom: int
    evaluations: int = field(repr=False)
    experiment: Experiment | None = field(repr=False)
    understood: str = field(repr=False)

    def plot(self, ax: Axes | None = None) -> Axes:
        """Draw the measured points with their errors, and the fitted ones.

        Parameters
        ----------
        ax : matplotlib.axes.Axes, optional
            Where it is drawn; a new picture by default.

        Returns
        -------
        matplotlib.axes.Axes
            What it is drawn into.

        Raises
        ------
        ImportError
            Without matplotlib.
        """
        ax = axes(ax)
        speed, errors = self.points[self.along], self.points["error"]
        order = np.argsort(speed)
        known = None if np.isnan(errors).all() else errors
        ax.errorbar(speed, self.points["measured"], known, fmt="o", ms=4, capsize=2, label="measured")
        ax.plot(speed[order], self.points["fitted"][order], "x-", ms=4, label="fitted")
        ax.set(xscale="log", xlabel=f"{self.along.replace('_', ' ')} (m/s)", ylabel="friction coefficient")
        ax.legend()
        return ax


def fit(
    data: Any,
    experiment: Experiment | str | os.PathLike[str],
    unknown: str | Sequence[str],
    *,
    bounds: Mapping[str, tuple[Any, Any]] | None = None,
    columns: str | None = None,
    search: bool = False,
    profile: bool = False,
    threads: int | None = None,
) -> Fit:
    """Find quantities of the laboratory from measured friction.

    Parameters
    ----------
    data : path, sequence of paths, mapping or pandas.DataFrame
        The measured points: tables of instruments, or columns of numbers by name. They have ``mu`` (what a load cell
        reads), where it was measured (``speed``, ``load``, … in SI units, or ``"speed (mm/s)"``), and its standard
        error ``error`` if that is known.
    experiment : Experiment or path
        All else, with the value that each unknown begins at; or a sweep file with ``[laboratory]``.
    unknown : str or sequence of str
        What is looked for: ``f``, ``relaxed_modulus``, ``viscosity``, ``retardation_time`` or others of `Experiment`.
    bounds : dict of str to (low, high), optional
        Where unknowns must stay: numbers in SI units, texts with units, or None for an open end.
    columns : str, optional
        What columns hold whose names do not tell, as in ``"speed=My V (mm/s),mu=#3"``.
    search : bool, default False
        Begin at the best of thousands of values between the bounds, or up to a thousand times off, by the built-in
        surface: for one retardation time and a rigid roller that slides.
    profile : bool, default False
        Find intervals from the profile of the residuals, too, which takes more fits.
    threads : int, optional
        Solver threads; one for each core by default.

    Returns
    -------
    Fit
        Values, errors and covariance of the unknowns, the fitted points, and the experiment with the values.

    Raises
    ------
    InputError
        If points, experiment and unknowns do not go together.
    FitError
        If no minimum is found, a point has no solution at the start, or unknowns have the same effect.
    KeyboardInterrupt
        Soon after Ctrl-C.
    """
    described = experiment if isinstance(experiment, Experiment) else None
    answer = _native.fit(
        {
            "files": _files(data),
            "columns": text("columns", columns, '"speed=My V (mm/s),mu=#3"'),
            "sweep": None if isinstance(experiment, Experiment) else _sweep_file(experiment),
            "text": "" if described is None else described.to_toml(),
            "unknown": _unknown(unknown),
            "bounds": _bounds({} if bounds is None else bounds),
            "search": bool(search),
            "profile": bool(profile),
            "threads": whole("threads", threads),
        }
    )
    estimates = answer.pop("estimates")
    names = [name for name, *_ in estimates]
    values, errors, start, at_bound = (
        {name: estimate[i] for name, estimate in zip(names, estimates, strict=True)} for i in (2, 3, 4, 5)
    )
    correlation = np.array(answer.pop("correlation"), dtype=float)
    deviations = np.array(list(errors.values()))
    intervals = answer.pop("intervals")
    if intervals is not None:
        ends = [tuple(np.nan if end is None else end for end in pair) for pair in intervals]
        intervals = dict(zip(names, ends, strict=True))
    return Fit(
        values=values,
        errors=errors,
        start=start,
        at_bound=at_bound,
        intervals=intervals,
        covariance=correlation * np.outer(deviations, deviations),
        correlation=correlation,
        points={name: np.array(numbers, dtype=float) for name, numbers in answer.pop("points").items()},
        experiment=None if described is None else described.replace(**values),
        **answer,
    )


def _files(data: Any) -> list[tuple[Path, bytes | None]]:
    """Give the files, or the text of a table for columns in memory."""
    if isinstance(data, (str, os.PathLike)):
        return [(Path(data), None)]
    if hasattr(data, "to_dict") and hasattr(data, "columns"):
        data = {str(name): data[name] for name in data.columns}
    if isinstance(data, Mapping):
        return [(Path("data.csv"), _table(data).encode())]
    files = list(data) if isinstance(data, Iterable) else []
    if files and all(isinstance(file, (str, os.PathLike)) for file in files):
        return [(Path(file), None) for file in files]
    raise InputError(
        "measured points are a path, a list of paths, or columns by name, as in "
        f'{{"speed": speed, "mu": mu}}; found {type(data).__name__}'
    )


def _sweep_file(experiment: Any) -> Path:
    return path("experiment", experiment, "an Experiment, or the path of a sweep file")


def _table(data: Mapping[Any, Any]) -> str:
    """Write columns as a file of separated values: what the columns hold is understood as in a file."""
    columns = {str(name): _column(str(name), values) for name, values in data.items()}
    if not columns:
        raise InputError('there are no measured points: give columns by name, as in {"speed": speed, "mu": mu}')
    lengths = {name: len(cells) for name, cells in columns.items()}
    if len(set(lengths.values())) != 1:
        told = ", ".join(f"{name} {length}" for name, length in lengths.items())
        raise InputError(f"the columns of the measured points have different lengths: {told}")
    rows = zip(*columns.values(), strict=True)
    return "\n".join([",".join(map(_quoted, columns)), *map(",".join, rows), ""])


def _column(name: str, values: Any) -> list[str]:
    """Write the cells of a column: numbers, or what else it holds; quantities of pint in SI units."""
    refuse_masked(name, values)
    if is_quantity(values):
        values = magnitude(name, values, _toml.UNITS.get(name, "1"))
    array = np.atleast_1d(np.asarray(values))
    if array.ndim != 1:
        raise InputError(f"{name} must be a list of numbers, found an array of shape {array.shape}")
    return ["" if each is None else repr(each) if isinstance(each, float) else _quoted(each) for each in _plain(array)]


def _plain(array: NDArray[Any]) -> list[Any]:
    plain: list[Any] = array.astype(float).tolist() if array.dtype.kind in "iuf" else array.tolist()
    return plain


def _quoted(it: Any) -> str:
    return '"' + str(it).replace('"', '""') + '"'


def _bounds(bounds: Any) -> list[tuple[str, float | None, float | None]]:
    if not isinstance(bounds, Mapping):
        raise InputError(f'bounds are pairs by name, as in {{"viscosity": ("1 Pa s", None)}}; found {bounds!r:.60}')
    return [(str(name), *_ends(name, ends)) for name, ends in bounds.items()]


def _unknown(unknown: Any) -> list[str]:
    names = [unknown] if isinstance(unknown, str) else list(unknown) if isinstance(unknown, Iterable) else []
    if names and all(isinstance(name, str) for name in names):
        return names
    raise InputError(f'unknown is a name, or a list of names, as in ["viscosity", "f"]; found {unknown!r:.60}')


def _ends(name: str, ends: tuple[Any, Any]) -> tuple[float | None, float | None]:
    try:
        low, high = ends
    except (TypeError, ValueError):
        raise InputError(f"bounds of {name} are a pair (low, high), either of them may be None") from None
    return _end(name, low), _end(name, high)


def _end(name: str, end: Any) -> float | None:
    if end is None or name == "f":
        return None if end is None else number(f"a bound of {name}", end)
    # 0 is an end that no quantity has as its value.
    return 0.0 if isinstance(end, (int, float)) and end == 0 else float(_toml.si(name, end))
