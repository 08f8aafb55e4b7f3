"""Compares the packages that each script names in its head (PEP 723) with its imports and scripts/requirements.txt.

Usage:
    python tests/python/inline_metadata.py

Prints the names of the scripts that need packages.
"""

import ast
import re
import sys
from pathlib import Path

import tomllib

SCRIPTS = Path(__file__).parents[2] / "scripts"
# What xarray opens results.h5 with, though no script imports it.
ENGINES = {"h5netcdf", "h5py"}
BLOCK = re.compile(r"(?m)^# /// script$\s(?P<content>(^#(| .*)$\s)+)^# ///$")


def packages(path):
    """Names of the packages outside the standard library that a file imports, by way of scripts/lib/ too."""
    modules = set()
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.Import):
            modules |= {alias.name for alias in node.names}
        elif isinstance(node, ast.ImportFrom):
            assert node.level == 0, f"{path}: relative import"
            modules.add(node.module)
    outside = set()
    for module in modules:
        package = module.split(".")[0]
        if package == "lib":
            outside |= packages(SCRIPTS / f"{module.replace('.', '/')}.py")
        elif package not in sys.stdlib_module_names:
            outside.add(package)
    return outside


def metadata(path):
    """The inline metadata of a script; None if it has none."""
    blocks = list(BLOCK.finditer(path.read_text(encoding="utf-8")))
    assert len(blocks) <= 1, f"{path}: several blocks"
    if not blocks:
        return None
    lines = blocks[0]["content"].splitlines(keepends=True)
    return tomllib.loads("".join(line[2:] if line.startswith("# ") else line[1:] for line in lines))


def check(path, requirements):
    """Compares the packages that a script names with its imports; returns whether it needs any."""
    outside, block = packages(path), metadata(path)
    if block is None:
        assert not outside, f"{path.name} imports {outside} and has no inline metadata"
        return False
    assert re.fullmatch(r">=3\.\d+", block["requires-python"]), path
    names = {re.match(r"[A-Za-z0-9_-]+", requirement)[0] for requirement in block["dependencies"]}
    assert len(names) == len(block["dependencies"]), f"{path.name} names a package twice"
    expected = outside | (ENGINES if "xarray" in outside else set())
    assert names == expected, f"{path.name} names {sorted(names)} and imports {sorted(expected)}"
    unknown = set(block["dependencies"]) - requirements
    assert not unknown, f"{path.name} names {unknown}, which scripts/requirements.txt does not"
    return True


def main():
    """Checks every script."""
    lines = (SCRIPTS / "requirements.txt").read_text(encoding="utf-8").splitlines()
    requirements = {line.strip() for line in lines if line.strip() and not line.startswith("#")}
    for path in sorted(SCRIPTS.glob("*.py")):
        if check(path, requirements):
            print(path.name)


if __name__ == "__main__":
    main()
