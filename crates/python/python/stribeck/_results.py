"""`open`: what a sweep has published."""

from __future__ import annotations

import os
import warnings
from pathlib import Path
from typing import TYPE_CHECKING

from ._errors import StorageError
from ._given import path
from ._packages import require

if TYPE_CHECKING:
    import xarray


def open(directory: str | os.PathLike[str]) -> xarray.Dataset:
    """Open the published data set of a results directory.

    Parameters
    ----------
    directory : path
        The results directory, or its results.h5.

    Returns
    -------
    xarray.Dataset
        Of dimensions f, alpha and beta, or quantities of the laboratory, and x; its variables are read when they are
        used. ``.stribeck`` has the nearest case, a case by its id, Stribeck curves and pictures.

    Raises
    ------
    StorageError
        If nothing is published there, or the file is damaged.
    ImportError
        Without xarray, h5netcdf and h5py.
    """
    return open_results(path("directory", directory))


def require_reader() -> None:
    """Refuse to go on without the packages that read results.h5."""
    require(["xarray", "h5netcdf", "h5py"], "a stored data set")


def open_results(directory: Path) -> xarray.Dataset:
    """Open results.h5 of a directory."""
    require_reader()
    import xarray  # noqa: PLC0415

    from . import _accessor  # noqa: F401, PLC0415

    file = directory if directory.is_file() else directory / "results.h5"
    if not file.exists():
        raise StorageError(f"{file}: no such file; `stribeck run` publishes it when all cases are solved")
    try:
        data = xarray.open_dataset(file, engine="h5netcdf")
    except (OSError, KeyError) as error:
        raise StorageError(f"{file} is not readable ({error}): `stribeck verify {directory}` tells more") from error
    if "partial" in data.attrs:
        warnings.warn(f"{file} is partial: {data.attrs['partial']}, and stand among the failed", stacklevel=3)
    # In files of earlier versions ids are bytes of a fixed length.
    return data.assign(case=data["case"].astype(str))
