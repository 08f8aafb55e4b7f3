"""Materials: relaxation of a soft body."""

from __future__ import annotations

import os
import warnings
from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _native, _toml
from ._errors import InputError
from ._given import number, numbers, text, whole
from ._given import path as path_of
from ._packages import axes

if TYPE_CHECKING:
    from matplotlib.axes import Axes


#: A residual of a law of temperature, in decades, that is worth a word: times are wrong by a factor of 2.
_FAR = 0.3


@dataclass(frozen=True, eq=False)
class Material:
    """A viscoelastic solid by its relaxation, E(t) = Einf + sum of E_i exp(-t/tau_i).

    Make one by `from_prony` or `from_file`. All numbers are in SI units; moduli are Young's.

    Attributes
    ----------
    relaxed_modulus, instantaneous_modulus : float
        Einf and E0 in Pa.
    f : float
        E0/Einf - 1.
    retardation_time : float
        The mean of the retardation times, the tau in alpha, in s.
    moduli, times : numpy.ndarray, shape (n,)
        E_i in Pa and tau_i in s.
    modes : numpy.ndarray, shape (m, 2)
        Retardation modes: shares of f, and times over `retardation_time`; what `solve` takes as ``modes``.
    poisson_ratio : float or None
        Poisson's ratio, which an `Experiment` with this material has.
    shift : dict or None
        How the times change with temperature, as ``shift`` of a sweep file: the law that was given, or the better one
        of those fitted to `shifts`.
    measured : numpy.ndarray, shape (rows, 3), or None
        What the material was fitted to: angular frequency in rad/s with storage and loss modulus in Pa, or time in s
        with the modulus in Pa and NaN.
    rms_residual : float or None
        The relative residual of that fit.
    shifts : numpy.ndarray, shape (isotherms, 3), or None
        Where isotherms went: temperature in K, log10 of the shift factor a_T, and the relative residual over the next
        colder one, NaN where there is none.
    vertical_shift_factors : numpy.ndarray, shape (isotherms,), or None
        b_T by which the moduli of each isotherm were multiplied; 1 where moduli were not shifted.
    shift_residual : float or None
        How far the fitted law `shift` is from these, in decades, root mean square.
    understood : str
        What was understood of a file.
    """

    relaxed_modulus: float
    instantaneous_modulus: float
    f: float
    retardation_time: float
    moduli: NDArray[np.float64] = field(repr=False)
    times: NDArray[np.float64] = field(repr=False)
    modes: NDArray[np.float64] = field(repr=False)
    poisson_ratio: float | None = None
    shift: dict[str, Any] | None = None
    measured: NDArray[np.float64] | None = field(default=None, repr=False)
    rms_residual: float | None = None
    shifts: NDArray[np.float64] | None = field(default=None, repr=False)
    vertical_shift_factors: NDArray[np.float64] | None = field(default=None, repr=False)
    shift_residual: float | None = None
    understood: str = field(default="", repr=False)

    @classmethod
    def from_prony(
        cls,
        *,
        times: Any,
        moduli: Any = None,
        fractions: Sequence[float] | None = None,
        relaxed_modulus: Any = None,
        instantaneous_modulus: Any = None,
        poisson_ratio: float | None = None,
        shift: dict[str, Any] | None = None,
    ) -> Material:
        """Make a material from a Prony series.

        Parameters
        ----------
        times : array_like, shape (n,)
            Relaxation times: seconds, texts as in "20 ms", or quantities of pint.
        moduli : array_like, shape (n,), optional
            Young's moduli of the terms: Pa, texts or quantities of pint.
        fractions : array_like, shape (n,), optional
            Parts of the instantaneous modulus, in place of `moduli`.
        relaxed_modulus, instantaneous_modulus : float, str or pint quantity
            One of both.
        poisson_ratio : float, optional
            From 0 to 0.5.
        shift : dict, optional
            A law of temperature, as in ``{"law": "wlf", "c1": 17.4, "c2": "51.6 K", "reference": "20 degC"}``.

        Raises
        ------
        InputError
            If the numbers are not those of a solid.
        """
        if (moduli is None) == (fractions is None):
            raise InputError("a Prony series has moduli or fractions: give one of both")
        if (relaxed_modulus is None) == (instantaneous_modulus is None):
            raise InputError("give relaxed_modulus or instantaneous_modulus, one of both")
        times = np.atleast_1d(_toml.si("time", times))
        parts = np.atleast_1d(numbers("fractions", fractions) if moduli is None else _toml.si("modulus", moduli))
        if times.shape != parts.shape:
            raise InputError(f"as many times as terms, not {times.size} times of {parts.size} terms")
        is_relaxed = instantaneous_modulus is None
        kind = "relaxed_modulus" if is_relaxed else "instantaneous_modulus"
        modulus = float(_toml.si(kind, relaxed_modulus if is_relaxed else instantaneous_modulus))
        terms = list(zip(parts.tolist(), times.tolist(), strict=True))
        native = _native.prony(moduli is None, terms, is_relaxed, modulus)
        return cls._of(native, poisson_ratio=_ratio(poisson_ratio), shift=shift)

    @classmethod
    def from_file(
        cls,
        path: str | os.PathLike[str],
        *,
        terms: int | None = None,
        shear: bool = False,
        poisson_ratio: float | None = None,
        modulus_unit: str | None = None,
        reference_temperature: float | str | None = None,
        shift_factors: str | os.PathLike[str] | None = None,
        vertical_shift: Literal["none", "fit", "density"] = "none",
        expansion: float | None = None,
        columns: str | None = None,
        shift: dict[str, Any] | None = None,
    ) -> Material:
        """Read a material: a table of moduli, which is fitted, or a Prony series of Abaqus or Ansys.

        Parameters
        ----------
        path : path
            The file.
        terms : int, optional
            Relaxation terms that are offered to a fit; by default as many as the residuals ask for.
        shear : bool, default False
            The moduli are shear moduli, for which `poisson_ratio` is needed.
        poisson_ratio : float, optional
            From 0 to 0.5.
        modulus_unit : str, optional
            The unit of moduli in a file that names none, as in "MPa".
        reference_temperature : float, str or pint quantity, optional
            Where moduli at several temperatures are shifted to, as in "20 degC"; K without a unit.
        shift_factors : path, optional
            A table of the factors by which they are shifted, in place of those found from their overlap. Beside moduli
            that were shifted before, or a Prony series, it gives the law.
        vertical_shift : {"none", "fit", "density"}, default "none"
            Multiply the moduli at T by b_T, too: by what fits the overlaps best, or by rho_0 T_0/(rho T), as of a
            rubber.
        expansion : float or pint quantity, optional
            Thermal expansion of the volume in 1/K, for the density of ``vertical_shift="density"``; 0 by default.
        columns : str, optional
            What columns hold whose names do not tell, as in ``"storage=#2,loss=#3"``.
        shift : dict, optional
            A law of temperature as for `from_prony`, in place of the one fitted to the shift factors.

        Raises
        ------
        InputError
            If a file is not there, or describes no material.
        StorageError
            If the disk does not give a file.

        Warns
        -----
        UserWarning
            If the measurements do not tell the relaxed modulus, or no law follows the shift factors.
        """
        unit = None if modulus_unit is None else float(_toml.si("modulus", f"1 {modulus_unit}"))
        options = {
            "terms": whole("terms", terms),
            "shear": bool(shear),
            "poisson_ratio": _ratio(poisson_ratio),
            "modulus_unit": unit,
            "reference_temperature": None
            if reference_temperature is None
            else float(_toml.si("temperature", reference_temperature)),
            "shift_factors": None if shift_factors is None else path_of("shift_factors", shift_factors),
            "vertical_shift": text("vertical_shift", vertical_shift, '"density"') or "none",
            "expansion": None if expansion is None else number("expansion", expansion, "1/K"),
            "columns": text("columns", columns, '"storage=#2,loss=#3"'),
        }
        file = path_of("path", path)
        read = _native.material_file(file, options)
        law, shift_residual = read.pop("law", (None, None))
        doubts = [read.pop("doubt", None)]
        if shift is None and shift_residual is not None and shift_residual > _FAR:
            doubts.append(f"no law follows the shift factors: the best one misses them by {shift_residual:.2f} decades")
        for doubt in filter(None, doubts):
            warnings.warn(f"{file}: {doubt}", stacklevel=2)
        return cls._of(
            read,
            poisson_ratio=options["poisson_ratio"],
            shift=law if shift is None else shift,
            shift_residual=shift_residual if shift is None else None,
        )

    @classmethod
    def _of(cls, native: dict[str, Any], **more: Any) -> Material:
        for name in ("measured", "shifts", "vertical_shift_factors"):
            if name in native:
                native[name] = np.array(native[name], dtype=float)
        terms, modes = (np.array(native.pop(name), dtype=float).reshape(-1, 2) for name in ("terms", "modes"))
        return cls(**native, **more, moduli=terms[:, 0], times=terms[:, 1], modes=modes)

    def modulus(self, time: ArrayLike) -> NDArray[np.float64]:
        """Give the relaxation modulus E(t).

        Parameters
        ----------
        time : array_like or pint quantity
            Times after a step of strain in s, from 0.

        Returns
        -------
        numpy.ndarray
            E(t) in Pa, of the shape of `time`.
        """
        time = numbers("time", time, "s")[..., np.newaxis]
        relaxing: NDArray[np.float64] = (self.moduli * np.exp(-time / self.times)).sum(axis=-1)
        return self.relaxed_modulus + relaxing

    def storage_and_loss(self, omega: ArrayLike) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Give storage and loss modulus.

        Parameters
        ----------
        omega : array_like or pint quantity
            Angular frequencies in rad/s.

        Returns
        -------
        storage, loss : numpy.ndarray
            Both in Pa, of the shape of `omega`.
        """
        x = numbers("omega", omega, "rad/s")[..., np.newaxis] * self.times
        response = self.moduli * (x / (x - 1j))
        # x/(x − i) = (x² + ix)/(1 + x²)
        return self.relaxed_modulus + response.real.sum(axis=-1), response.imag.sum(axis=-1)

    def body(self) -> dict[str, Any]:
        """Give the section of a body of a sweep file.

        Returns
        -------
        dict of str to object
            The keys of ``[flat]`` or ``[roller]``.
        """
        terms = zip(self.moduli.tolist(), self.times.tolist(), strict=True)
        return {
            "relaxed_modulus": self.relaxed_modulus,
            "poisson_ratio": self.poisson_ratio,
            "relaxation": [{"modulus": modulus, "time": time} for modulus, time in terms],
            "shift": self.shift,
        }

    def plot(self, ax: Axes | None = None) -> Axes:
        """Draw storage and loss modulus over angular frequency, with what was measured.

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
        omega = np.geomspace(0.01 / self.times.max(), 100 / self.times.min(), 201)
        names = ("storage modulus", "loss modulus")
        for i, (name, values) in enumerate(zip(names, self.storage_and_loss(omega), strict=True)):
            (line,) = ax.loglog(omega, values, label=name)
            if self.measured is not None and not np.isnan(self.measured[:, 2]).any():
                ax.loglog(self.measured[:, 0], self.measured[:, i + 1], "o", ms=3, color=line.get_color())
        ax.set(xlabel="angular frequency (rad/s)", ylabel="modulus (Pa)")
        ax.legend()
        return ax


def _ratio(poisson_ratio: float | None) -> float | None:
    """Check Poisson's ratio."""
    return None if poisson_ratio is None else float(_toml.si("poisson_ratio", poisson_ratio))
