"""Friction, film and pressure of a lubricated cylinder on a viscoelastic half space.

`solve` takes α, β and f, and gives a data set.
"""

from ._errors import Error, FitError, InputError, StorageError
from ._native import __version__
from ._solve import solve

__all__ = ["Error", "FitError", "InputError", "StorageError", "__version__", "solve"]
