"""Opens the published data set of a sweep, and says what is wrong where there is none."""

import xarray as xr

from lib.messages import fail


def open_results(directory):
    """The published data set of a results directory, over f, alpha and beta."""
    path = directory / "results.h5"
    if not path.is_file():
        fail(f"{path}: no such file; give a directory in which `stribeck run` has published its results")
    try:
        data = xr.open_dataset(path, engine="h5netcdf")
    except (OSError, ValueError) as error:
        fail(
            f"{path}: not readable as a data set ({error}); `stribeck verify {directory}` says what is damaged, "
            "and the `stribeck run` that made it writes it again"
        )
    dimensions = data.attrs.get("stribeck_dimensions")
    if dimensions is not None:
        fail(
            f"{path}: its dimensions are {decode(dimensions)}, and this script is for f, alpha and beta; "
            f"`stribeck plot {directory}` draws it"
        )
    return data


def decode(value):
    """A string of the file as text: an engine may hand it over as bytes."""
    return value.decode() if isinstance(value, bytes) else str(value)
