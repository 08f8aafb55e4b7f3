"""Runs a command and says what it cost: `python3 scripts/measured.py COMMAND…`. What the command prints goes to stderr."""

import resource
import subprocess
import sys
import time

if len(sys.argv) < 2:
    sys.exit(__doc__)
start = time.monotonic()
code = subprocess.run(sys.argv[1:], stdout=sys.stderr).returncode
seconds = time.monotonic() - start
used = resource.getrusage(resource.RUSAGE_CHILDREN)
cpu, peak = used.ru_utime + used.ru_stime, used.ru_maxrss / 1024
print(f"{seconds:.1f} s, {cpu:.1f} s of processors, {peak:.0f} MB at most, exit code {code}")
sys.exit(code)
