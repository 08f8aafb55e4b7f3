"""Runs a command and prints its run time, processor time and peak memory; what the command prints goes to stderr.

Usage:
    python3 scripts/measure.py COMMAND...
"""

import resource
import subprocess
import sys
import time


def main():
    """Runs the command of the command line and ends with its exit code."""
    command = sys.argv[1:]
    if not command:
        print(__doc__, file=sys.stderr)
        sys.exit(2)
    start = time.monotonic()
    code = subprocess.run(command, stdout=sys.stderr, check=False).returncode
    seconds = time.monotonic() - start
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    cpu, peak = used.ru_utime + used.ru_stime, used.ru_maxrss / 1024
    print(f"{seconds:.1f} s, {cpu:.1f} s of processors, {peak:.0f} MB at most, exit code {code}")
    sys.exit(code)


if __name__ == "__main__":
    main()
