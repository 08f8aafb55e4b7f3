"""Friction, film and pressure of a lubricated cylinder on a viscoelastic half space.

`solve` takes α, β and f. `Experiment` and `Material` take quantities of the laboratory, `fit` finds these from measured
friction. `run` and `open` are for sweeps that are stored, `Surface` for friction as a function in a file.
"""

from ._errors import Error, FitError, InputError, StorageError
from ._fit import Fit, fit
from ._native import __version__
from ._results import open
from ._run import run
from ._solve import solve
from .experiment import Experiment
from .material import Material
from .surface import Surface

__all__ = [
    "Error",
    "Experiment",
    "Fit",
    "FitError",
    "InputError",
    "Material",
    "StorageError",
    "Surface",
    "__version__",
    "fit",
    "open",
    "run",
    "solve",
]
