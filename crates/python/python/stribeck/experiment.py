"""Experiments: a cylinder, a fluid and a flat in quantities of the laboratory."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from . import _native, _toml
from ._datasets import Variable, dataset, variables
from ._errors import InputError
from ._given import whole
from ._packages import require
from .material import Material

if TYPE_CHECKING:
    import xarray
    from matplotlib.axes import Axes

_NAME = "Experiment"
#: The speed along which curves run, by what is given beside it.
_ALONG = {"slide_roll_ratio": "entrainment_speed", "roller_speed": "flat_speed"}


class Experiment:
    """A lubricated cylinder on a soft flat, in quantities of the laboratory.

    Parameters
    ----------
    flat, roller : Material or dict, optional
        What the bodies are made of: a material, or the keys of ``[flat]`` and ``[roller]`` of a sweep file. The flat
        may be described by the quantities below instead; a roller is rigid by default.
    tolerance : float, default 1e-5
        Relative error wanted of the solutions.
    cavity_shear : {"full", "streamers", "none"}, default "full"
        What fills the gap behind the film.
    sensitivities : bool, default False
        Curves also have d ln(mu)/d ln(q) for each quantity q.
    **quantities
        The keys of ``[laboratory]`` of a sweep file: radius, load (per length), viscosity, poisson_ratio,
        relaxed_modulus or instantaneous_modulus, f, retardation_time, temperature, roughness, thickness, and of the
        motion ``slide_roll_ratio``, or ``roller_speed``. Each is a number in SI units, a text with a unit as in
        "2 mm", or a quantity of pint; several values in a list make a curve of each. The speed is given to `curve` and
        `friction`, or here.

    Raises
    ------
    InputError
        If a quantity is missing, unknown, or may not be. The message shows the line of `to_toml`.

    Examples
    --------
    >>> import stribeck
    >>> oil = dict(radius="2 mm", load="119 N/m", viscosity="5.1 Pa s", poisson_ratio=0.5)
    >>> experiment = stribeck.Experiment(**oil, relaxed_modulus="75 kPa", f=10.0, retardation_time="0.1 s")
    >>> float(experiment.friction("1 mm/s").round(3))
    0.074
    """

    def __init__(
        self,
        *,
        flat: Material | Mapping[str, Any] | None = None,
        roller: Material | Mapping[str, Any] | None = None,
        tolerance: float = 1e-5,
        cavity_shear: str = "full",
        sensitivities: bool = False,
        **quantities: Any,
    ):
        for name, body in {"flat": flat, "roller": roller}.items():
            if not (body is None or isinstance(body, (Material, Mapping))):
                raise InputError(
                    f"{name} must be a Material, or the keys of [{name}] in a dict, found {body!r:.60}; "
                    "Material.from_file reads one from a file"
                )
        self._given = {"flat": flat, "roller": roller, **quantities}
        self._options = {"tolerance": tolerance, "cavity_shear": cavity_shear, "sensitivities": sensitivities}
        _native.check_sweep(_NAME, self.to_toml())

    def __repr__(self) -> str:
        """Write the experiment as the call that makes it."""
        given = {name: it for name, it in self._given.items() if it is not None}
        return f"Experiment({', '.join(f'{name}={it!r}' for name, it in given.items())})"

    @property
    def along(self) -> str:
        """The name of the speed along which curves run."""
        return next((speed for beside, speed in _ALONG.items() if self._given.get(beside) is not None), "speed")

    def replace(self, **changes: Any) -> Experiment:
        """Make an experiment with some arguments changed.

        Parameters
        ----------
        **changes
            Arguments of `Experiment`; None leaves one out.

        Returns
        -------
        Experiment
            The new one.

        Raises
        ------
        InputError
            As of `Experiment`.
        """
        return Experiment(**{**self._given, **self._options, **changes})

    def to_toml(self, speed: Any = None) -> str:
        """Write the experiment as a sweep file, for `stribeck.run` and the program.

        Parameters
        ----------
        speed : float, str, list or dict, optional
            The speeds: a list that ascends, or a range ``{"from": "1 um/s", "to": "1 m/s", "points": 31, "scale":
            "log"}``. By default those of the experiment, or 1 mm/s.

        Returns
        -------
        str
            The text of the file, TOML.
        """
        quantities = {name: it for name, it in self._given.items() if name not in ("flat", "roller") and it is not None}
        if speed is not None:
            quantities[self.along] = speed
        quantities.setdefault(self.along, "1 mm/s")
        bodies = {name: _body(self._given[name]) for name in ("flat", "roller") if self._given[name] is not None}
        flat = self._given["flat"]
        if isinstance(flat, Material) and flat.poisson_ratio is not None and "poisson_ratio" in quantities:
            raise InputError("the material of the flat has a poisson_ratio, and one is given beside it: leave one out")
        options = self._options
        output = {key: options[key] for key in ("cavity_shear", "sensitivities")}
        return "\n".join(
            [
                *(_toml.section(name, body) for name, body in bodies.items()),
                _toml.section("laboratory", quantities),
                _toml.section("solver", {"tolerance": options["tolerance"]}),
                _toml.section("output", {"fields": [], **output}),
            ]
        )

    def curve(self, speed: Any = None, *, threads: int | None = None) -> xarray.Dataset:
        """Solve the Stribeck curve: friction, film and pressure against speed.

        Parameters
        ----------
        speed : array_like, list or dict, optional
            Speeds: m/s, texts or quantities of pint, in any order; or a range as in `to_toml`. By default those of the
            experiment.
        threads : int, optional
            Solver threads; one for each core by default.

        Returns
        -------
        xarray.Dataset
            The columns of results.h5 in SI units over the ascending speeds, and over each quantity with several
            values. ``mu_drag`` is what a load cell reads. A speed that failed has NaN, the status 1 and a reason.

        Raises
        ------
        InputError
            If a speed may not be.
        KeyboardInterrupt
            Soon after Ctrl-C.
        """
        if speed is None and self._given.get(self.along) is None:
            raise InputError(f"give the speeds, as in curve(numpy.geomspace(1e-6, 1, 31)); {self.along} is in m/s")
        if speed is not None and not isinstance(speed, Mapping):
            speed = np.unique(_toml.si(self.along, speed)).tolist()
        return solve_text(self.to_toml(speed), whole("threads", threads))

    def friction(self, speed: Any, *, quantity: str = "mu_drag", threads: int | None = None) -> NDArray[np.float64]:
        """Solve friction at speeds.

        Parameters
        ----------
        speed : float, str, pint quantity or array of these
            Speeds, in any order; plain numbers are m/s.
        quantity : str, default "mu_drag"
            A column: ``mu_drag`` is what a load cell reads, ``mu_v`` and ``mu_shear`` are parts of it.
        threads : int, optional
            Solver threads; one for each core by default.

        Returns
        -------
        numpy.ndarray
            Of the shape of `speed`; NaN where there is no solution. Of several values of other quantities, see `curve`.

        Raises
        ------
        InputError
            If a speed may not be, or the experiment has several values of a quantity.
        """
        speeds = _toml.si(self.along, speed)
        if speeds.size == 0:
            return np.empty(speeds.shape)
        ascending, place = np.unique(speeds, return_inverse=True)
        solved = _native.solve_sweep(_NAME, self.to_toml(ascending.tolist()), whole("threads", threads))
        several = [name for name, values, _ in solved["dimensions"] if name != self.along and len(values) > 1]
        if several:
            raise InputError(f"{several[0]} has several values, and friction is of one: take curve, or replace(...)")
        columns = [name for name, (values, *_) in solved["variables"].items() if isinstance(values, np.ndarray)]
        if quantity not in columns:
            raise InputError(f"there is no column {quantity!r}: there are {', '.join(columns)}")
        values = np.asarray(solved["variables"][quantity][0], dtype=float)
        return values[place].reshape(speeds.shape)

    def plot(self, speed: Any = None, *, ax: Axes | None = None, threads: int | None = None) -> Axes:
        """Draw friction against speed with its parts; of several values of one more quantity the drag of each.

        Parameters
        ----------
        speed : array_like, list or dict, optional
            As of `curve`.
        ax : matplotlib.axes.Axes, optional
            Where it is drawn; a new picture by default.
        threads : int, optional
            Solver threads; one for each core by default.

        Returns
        -------
        matplotlib.axes.Axes
            What it is drawn into.

        Raises
        ------
        InputError
            As of `curve`, or if more than one other quantity has several values.
        ImportError
            Without xarray or matplotlib.
        """
        require(["xarray", "matplotlib"], "a picture of a curve")
        drawn: Axes = self.curve(speed, threads=threads).stribeck.plot_curve(ax=ax)
        return drawn


def _body(body: Material | Mapping[str, Any]) -> Mapping[str, Any]:
    return body.body() if isinstance(body, Material) else body


def solve_text(text: str, threads: int | None) -> xarray.Dataset:
    """Solve the sweep that a text describes, in memory."""
    answer = _native.solve_sweep(_NAME, text, threads)
    sizes = {name: len(values) for name, values, _ in answer["dimensions"]}
    coordinates = {name: Variable((name,), values, dict(attrs)) for name, values, attrs in answer["dimensions"]}
    _, x, _ = answer["x"]
    data = variables(answer["variables"], sizes, len(x))
    coordinates |= variables(answer["coordinates"], sizes, len(x))
    for name, (number, attrs) in answer["quantities"].items():
        coordinates[name] = Variable((), np.array(number), dict(attrs))
    return dataset(data, coordinates, {"Conventions": "CF-1.10", "sweep": text})
