"""Materials: relaxation of a soft body."""

from __future__ import annotations

import os
from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from . import _native, _toml
from ._errors import InputError


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
        How the times change with temperature, as ``shift`` of a sweep file.
    measured : numpy.ndarray, shape (rows, 3), or None
        What the material was fitted to: angular frequency in rad/s with storage and loss modulus in Pa, or time in s
        with the modulus in Pa and NaN.
    rms_residual : float or None
        The relative residual of that fit.
    understood : str
        What was understood of a file.
    """

    relaxed_modulus: float
    instantaneous_modulus: float
    f: float
    retardation_time: float
    moduli: np.ndarray = field(repr=False)
    times: np.ndarray = field(repr=False)
    modes: np.ndarray = field(repr=False)
    poisson_ratio: float | None = None
    shift: dict[str, Any] | None = None
    measured: np.ndarray | None = field(default=None, repr=False)
    rms_residual: float | None = None
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
        parts = np.atleast_1d(np.asarray(fractions, dtype=float) if moduli is None else _toml.si("modulus", moduli))
        if times.shape != parts.shape:
            raise InputError(f"as many times as terms, not {times.size} times of {parts.size} terms")
        is_relaxed = instantaneous_modulus is None
        kind = "relaxed_modulus" if is_relaxed else "instantaneous_modulus"
        modulus = float(_toml.si(kind, relaxed_modulus if is_relaxed else instantaneous_modulus))
        terms = list(zip(parts.tolist(), times.tolist(), strict=True))
        return cls._of(_native.prony(moduli is None, terms, is_relaxed, modulus), poisson_ratio, shift)

    @classmethod
    def from_file(
        cls,
        path: str | os.PathLike[str],
        *,
        terms: int | None = None,
        shear: bool = False,
        poisson_ratio: float | None = None,
        modulus_unit: str | None = None,
        reference_temperature: str | None = None,
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
        reference_temperature : str, optional
            Where moduli at several temperatures are shifted to by their overlap, as in "20 degC".
        columns : str, optional
            What columns hold whose names do not tell, as in ``"storage=#2,loss=#3"``.
        shift : dict, optional
            A law of temperature, as for `from_prony`.

        Raises
        ------
        InputError
            If the file cannot be read, or describes no material.
        """
        unit = None if modulus_unit is None else float(_toml.si("modulus", f"1 {modulus_unit}"))
        options = {
            "terms": terms,
            "shear": bool(shear),
            "poisson_ratio": poisson_ratio,
            "modulus_unit": unit,
            "reference_temperature": reference_temperature,
            "columns": columns,
        }
        return cls._of(_native.material_file(os.fspath(path), options), poisson_ratio, shift)

    @classmethod
    def _of(cls, native: dict[str, Any], poisson_ratio: float | None, shift: dict[str, Any] | None) -> Material:
        if poisson_ratio is not None:
            poisson_ratio = float(_toml.si("poisson_ratio", poisson_ratio))
        terms = np.array(native.pop("terms"), dtype=float).reshape(-1, 2)
        modes = np.array(native.pop("modes"), dtype=float).reshape(-1, 2)
        measured = native.pop("measured", None)
        return cls(
            **native,
            moduli=terms[:, 0],
            times=terms[:, 1],
            modes=modes,
            poisson_ratio=poisson_ratio,
            shift=shift,
            measured=None if measured is None else np.array(measured, dtype=float),
        )

    def modulus(self, time: Any) -> np.ndarray:
        """E(t) in Pa at times in s after a step of strain, of the shape of `time`."""
        time = np.asarray(time, dtype=float)[..., np.newaxis]
        return self.relaxed_modulus + (self.moduli * np.exp(-time / self.times)).sum(axis=-1)

    def storage_and_loss(self, omega: Any) -> tuple[np.ndarray, np.ndarray]:
        """Storage and loss modulus in Pa at angular frequencies in rad/s, of the shape of `omega`."""
        x = np.asarray(omega, dtype=float)[..., np.newaxis] * self.times
        response = self.moduli * (x / (x - 1j))
        # x/(x − i) = (x² + ix)/(1 + x²)
        return self.relaxed_modulus + response.real.sum(axis=-1), response.imag.sum(axis=-1)

    def body(self) -> dict[str, Any]:
        """Give the section of a body of a sweep file."""
        terms = zip(self.moduli.tolist(), self.times.tolist(), strict=True)
        return {
            "relaxed_modulus": self.relaxed_modulus,
            "poisson_ratio": self.poisson_ratio,
            "relaxation": [{"modulus": modulus, "time": time} for modulus, time in terms],
            "shift": self.shift,
        }

    def plot(self, ax: Any = None) -> Any:
        """Draw storage and loss modulus over frequency, with what was measured, and return the axes of matplotlib."""
        import matplotlib.pyplot as plt  # noqa: PLC0415

        ax = plt.subplots(figsize=(4.5, 3.2), layout="constrained")[1] if ax is None else ax
        omega = np.geomspace(0.01 / self.times.max(), 100 / self.times.min(), 201)
        names = ("storage modulus", "loss modulus")
        for i, (name, values) in enumerate(zip(names, self.storage_and_loss(omega), strict=True)):
            (line,) = ax.loglog(omega, values, label=name)
            if self.measured is not None and not np.isnan(self.measured[:, 2]).any():
                ax.loglog(self.measured[:, 0], self.measured[:, i + 1], "o", ms=3, color=line.get_color())
        ax.set(xlabel="angular frequency (rad/s)", ylabel="modulus (Pa)")
        ax.legend()
        return ax
