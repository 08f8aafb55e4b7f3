"""Exceptions of the package, with the messages of the program: what happened, where, and what to do."""


class Error(Exception):
    """What any other exception of this package is one of."""


class InputError(Error, ValueError):
    """A value, a file or a text that was given is wrong.

    The message names the value, says what is allowed and what to do; of a file it shows the line.
    """


class StorageError(Error, OSError):
    """The disk, or a file of results, is not as it should be."""


class FitError(Error, ValueError):
    """Nothing was fitted: the message says why, and where to begin instead."""


for _exception in (Error, InputError, StorageError, FitError):
    # As users write them, in tracebacks and pickles.
    _exception.__module__ = "stribeck"
