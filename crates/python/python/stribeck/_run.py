"""`run`: sweeps that are stored."""

from __future__ import annotations

import os
import sys
import warnings
from pathlib import Path
from typing import TYPE_CHECKING, Any

from . import _native
from ._given import path, whole
from ._results import open_results, require_reader

if TYPE_CHECKING:
    import xarray


def run(
    sweep: str | os.PathLike[str],
    output: str | os.PathLike[str] | None = None,
    *,
    progress: bool = True,
    threads: int | None = None,
) -> xarray.Dataset:
    """Run a sweep into a results directory, or resume it, and open what it publishes.

    Parameters
    ----------
    sweep : path
        The sweep file (TOML).
    output : path, optional
        The results directory; by default ``results/NAME`` for a file NAME.toml.
    progress : bool, default True
        Show how far it is: a bar of tqdm where that is installed, else a line at the end.
    threads : int, optional
        Solver threads; one for each core by default.

    Returns
    -------
    xarray.Dataset
        As of `stribeck.open`.

    Raises
    ------
    InputError
        If the sweep file is not valid: the message shows the line and what to do.
    StorageError
        If the disk or a file fails; what was solved before is stored.
    KeyboardInterrupt
        Soon after Ctrl-C. What is finished is stored, and the same call resumes the sweep.
    ImportError
        Without xarray, h5netcdf and h5py, before anything is solved; the program `stribeck run` needs none of these.
    """
    require_reader()
    sweep = path("sweep", sweep)
    directory = Path("results") / sweep.stem if output is None else path("output", output)
    with _Progress(progress) as shown:
        _native.run(sweep, directory, whole("threads", threads), shown.told)
    return open_results(directory)


class _Progress:
    """Shows how far a run is."""

    def __init__(self, wanted: bool):
        self._wanted = wanted
        self._bar: Any = None
        self._failed = 0

    def __enter__(self) -> _Progress:
        return self

    def __exit__(self, *_: object) -> None:
        if self._bar is not None:
            self._bar.close()

    def told(self, what: str, first: Any, second: int) -> None:
        """Take an event of the extension module."""
        if what == "warning":
            warnings.warn(first, stacklevel=4)
        elif what == "solving" and self._wanted:
            self._bar = _bar(first)
        elif what == "committed" and self._bar is not None:
            self._failed += second
            if self._failed:
                self._bar.set_postfix(failed=self._failed, refresh=False)
            self._bar.update(first + second)


def _bar(cases: int) -> Any:
    try:
        from tqdm.auto import tqdm  # type: ignore[import-untyped, unused-ignore] # noqa: PLC0415
    except ImportError:
        return _Line(cases)
    with warnings.catch_warnings():
        # tqdm says so where a notebook lacks its widgets; its bar of characters is as good.
        warnings.simplefilter("ignore")
        return tqdm(total=cases, unit="case")


class _Line:
    """A line of progress without tqdm."""

    def __init__(self, cases: int):
        self._cases, self._done, self._last = cases, 0, ""

    def set_postfix(self, *, failed: int, refresh: bool) -> None:  # noqa: ARG002
        self._last = f", {failed} failed"

    def update(self, cases: int) -> None:
        self._done += cases

    def close(self) -> None:
        print(f"{self._done} of {self._cases} cases{self._last}", file=sys.stderr)
