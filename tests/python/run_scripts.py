"""Runs scripts for the tests, each in a fork of one interpreter that has imported the packages already.

Usage:
    python tests/python/run_scripts.py

Prints the path of a Unix socket and listens there. A request is a line of JSON, the list of a script and its
arguments; the answer is an object of JSON with the exit code and what the script printed. Ends soon after the process
that started it.
"""

import importlib
import json
import os
import runpy
import socketserver
import sys
import tempfile
import traceback
from pathlib import Path

# Importing these takes most of the time of a script.
PACKAGES = ("h5netcdf", "matplotlib.pyplot", "xarray")


def run(arguments):
    """Runs a script as `python` would; returns its exit code."""
    sys.argv, sys.path[0] = arguments, str(Path(arguments[0]).parent)
    try:
        runpy.run_path(arguments[0], run_name="__main__")
    except SystemExit as end:
        if end.code is None or isinstance(end.code, int):
            return end.code or 0
        print(end.code, file=sys.stderr)
        return 1
    except BaseException:
        traceback.print_exc()
        return 1
    return 0


class Request(socketserver.StreamRequestHandler):
    """One script, in a process of its own."""

    def handle(self):
        """Runs the script with its output in files, and answers."""
        arguments = json.loads(self.rfile.readline())
        with tempfile.TemporaryFile() as out, tempfile.TemporaryFile() as err:
            os.dup2(out.fileno(), 1)
            os.dup2(err.fileno(), 2)
            code = run(arguments)
            sys.stdout.flush()
            sys.stderr.flush()
            out.seek(0)
            err.seek(0)
            answer = {"code": code, "stdout": out.read().decode(), "stderr": err.read().decode()}
        self.wfile.write(json.dumps(answer).encode())


class Server(socketserver.ForkingMixIn, socketserver.UnixStreamServer):
    """Answers requests side by side for as long as the process lives that started it."""

    request_queue_size = 64
    parent = os.getppid()

    def service_actions(self):
        """Ends the server when another process has become its parent."""
        super().service_actions()
        if os.getppid() != self.parent:
            sys.exit()


def main():
    """Listens in a directory that goes away with the server."""
    for name in PACKAGES:
        importlib.import_module(name)
    with tempfile.TemporaryDirectory() as directory, Server(f"{directory}/socket", Request) as server:
        print(server.server_address, flush=True)
        server.serve_forever()


if __name__ == "__main__":
    main()
