"""`fit`: quantities of the laboratory from measured friction."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from . import _native, _toml
from ._errors import InputError
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
    unknown = [unknown] if isinstance(unknown, str) else list(unknown)
    described = experiment if isinstance(experiment, Experiment) else None
    answer = _native.fit(
        {
            "files": _files(data),
            "columns": columns,
            "sweep": None if isinstance(experiment, Experiment) else Path(experiment),
            "text": "" if described is None else described.to_toml(),
            "unknown": unknown,
            "bounds": [(name, *_ends(name, ends)) for name, ends in (bounds or {}).items()],
            "profile": profile,
            "threads": threads,
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
        data = {str(name): data[name].to_numpy() for name in data.columns}
    if isinstance(data, Mapping):
        columns = {name: np.atleast_1d(np.asarray(values, dtype=float)) for name, values in data.items()}
        lengths = {array.size for array in columns.values()}
        if len(lengths) != 1:
            raise InputError("the columns of the measured points have different lengths")
        heading = ",".join(f'"{name}"' for name in columns)
        rows = [",".join(repr(float(number)) for number in row) for row in zip(*columns.values(), strict=True)]
        return [(Path("data.csv"), "\n".join([heading, *rows, ""]).encode())]
    return [(Path(file), None) for file in data]


def _ends(name: str, ends: tuple[Any, Any]) -> tuple[float | None, float | None]:
    try:
        low, high = ends
    except (TypeError, ValueError):
        raise InputError(f"bounds of {name} are a pair (low, high), either of them may be None") from None
    return _end(name, low), _end(name, high)


def _end(name: str, end: Any) -> float | None:
    if end is None or name == "f":
        return None if end is None else float(end)
    # 0 is an end that no quantity has as its value.
    return 0.0 if isinstance(end, (int, float)) and end == 0 else float(_toml.si(name, end))
