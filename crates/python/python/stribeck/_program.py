"""The program `stribeck`."""

import signal
import sys

from . import _native


def main() -> int:
    """Run the program with the command line of this process and return its exit code."""
    # The program looks after Ctrl-C itself where that has something to save.
    signal.signal(signal.SIGINT, signal.SIG_DFL)
    return _native.main(sys.argv)
