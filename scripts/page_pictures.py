"""Makes the pictures of pages: runs the commands of a page and takes the files that its pictures name in their titles.

Usage:
    python3 scripts/page_pictures.py [PAGE…]

A picture `![text](gallery/x.svg "results/x/figures/y.svg")` is a copy of the second file, which the blocks `sh` of its
page make in a scratch copy of the repository. Without a page: all of those that have such pictures.
Needs the program: the path in STRIBECK, or `stribeck`.
"""

import os
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
PICTURE = re.compile(r'!\[[^\]]*\]\(([^) ]+) "([^"]+)"\)')
BLOCK = re.compile(r"^```sh\n(.*?)^```$", re.DOTALL | re.MULTILINE)
# What the commands of pages read.
READ = ["sweeps", "docs/how-to/instrument-files"]


def environment(scratch):
    """The environment with the program as `stribeck` on its path."""
    program = shutil.which(os.environ.get("STRIBECK", "stribeck"))
    if program is None:
        sys.exit("the program is not found: build it, and say where it is: STRIBECK=target/release/stribeck")
    programs = scratch / ".programs"
    programs.mkdir()
    (programs / "stribeck").symlink_to(Path(program).resolve())
    return os.environ | {"PATH": f"{programs}{os.pathsep}{os.environ['PATH']}"}


def draw(page):
    """Runs the commands of a page and copies its pictures."""
    text = page.read_text(encoding="utf-8")
    with tempfile.TemporaryDirectory() as directory:
        scratch = Path(directory)
        for name in READ:
            shutil.copytree(ROOT / name, scratch / name)
        commands = "set -e\n" + "\n".join(BLOCK.findall(text))
        run = subprocess.run(
            ["bash", "-c", commands],
            cwd=scratch,
            env=environment(scratch),
            stdout=subprocess.DEVNULL,
            stderr=subprocess.PIPE,
            text=True,
            check=False,
        )
        if run.returncode != 0:
            sys.exit(f"{page}: a command failed with exit code {run.returncode}\n{run.stderr}")
        for name, made in PICTURE.findall(text):
            picture = page.parent / name
            picture.parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(scratch / made, picture)
            print(f"{picture.resolve().relative_to(ROOT)}: {picture.stat().st_size} bytes")


def main():
    """Draws the pictures of the pages that are named, or of all."""
    pages = [Path(name) for name in sys.argv[1:]] or sorted((ROOT / "docs").rglob("*.md"))
    for page in pages:
        if PICTURE.search(page.read_text(encoding="utf-8")):
            draw(page)


main()
