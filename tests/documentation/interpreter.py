"""Executes blocks of a page in one interpreter: `interpreter.py PAGE NAME`.

Reads a first line, a last line and a directory from each line of stdin, runs what stands between these two lines of the
page there, and answers `done`, or the line that failed. What the blocks print goes to stderr.
"""

import os
import sys
import textwrap
import traceback
from pathlib import Path


def failed_line(error, name, first):
    """The line of the page at which an error began."""
    if isinstance(error, SyntaxError) and error.filename == name:
        return error.lineno or first
    lines = [frame.lineno for frame in traceback.extract_tb(error.__traceback__) if frame.filename == name]
    return lines[-1] if lines else first


def main():
    """Answers until stdin ends."""
    path, name = sys.argv[1:]
    lines = Path(path).read_text(encoding="utf-8").splitlines()
    answers = os.fdopen(os.dup(1), "w")
    os.dup2(2, 1)
    sys.path.insert(0, "")
    names = {"__name__": "__main__"}
    for request in sys.stdin:
        first, last, directory = request.rstrip("\n").split(" ", 2)
        first = int(first)
        os.chdir(directory)
        block = textwrap.dedent("\n".join(lines[first : int(last) - 1]))
        answer = "done"
        try:
            # Empty lines before it give each line the number that it has in the page.
            exec(compile("\n" * first + block, name, "exec"), names)
        except BaseException as error:  # Also SystemExit: a block that ends the interpreter has failed.
            traceback.print_exc()
            answer = failed_line(error, name, first)
        sys.stdout.flush()
        print(answer, file=answers, flush=True)


if __name__ == "__main__":
    main()
