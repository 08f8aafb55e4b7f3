"""Compares the inline metadata of every script (PEP 723) with what the script imports and with scripts/requirements.txt."""

import ast
import re
import sys
import tomllib
from pathlib import Path

SCRIPTS = Path(__file__).parents[2] / "scripts"
# What xarray opens results.h5 with, though no script imports it.
ENGINES = {"h5netcdf", "h5py"}
BLOCK = re.compile(r"(?m)^# /// script$\s(?P<content>(^#(| .*)$\s)+)^# ///$")


def imports(path):
    """Names of the packages outside the standard library that a script imports, by way of its neighbours too."""
    names = set()
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.Import):
            names |= {alias.name.split(".")[0] for alias in node.names}
        elif isinstance(node, ast.ImportFrom):
            assert node.level == 0, f"{path}: relative import"
            names.add(node.module.split(".")[0])
    outside = set()
    for name in names - sys.stdlib_module_names:
        neighbour = SCRIPTS / f"{name}.py"
        outside |= imports(neighbour) if neighbour.is_file() else {name}
    return outside


def metadata(path):
    """The inline metadata of a script; None if it has none."""
    blocks = list(BLOCK.finditer(path.read_text(encoding="utf-8")))
    assert len(blocks) <= 1, f"{path}: several blocks"
    if not blocks:
        return None
    lines = blocks[0]["content"].splitlines(keepends=True)
    return tomllib.loads("".join(line[2:] if line.startswith("# ") else line[1:] for line in lines))


lines = (SCRIPTS / "requirements.txt").read_text(encoding="utf-8").splitlines()
requirements = {line.strip() for line in lines if line.strip() and not line.startswith("#")}

def neighbours(path):
    """Names of the scripts that a script imports."""
    text = path.read_text(encoding="utf-8")
    return {name for name in re.findall(r"(?m)^(?:from|import) (\w+)", text) if (SCRIPTS / f"{name}.py").is_file()}


paths = sorted(SCRIPTS.glob("*.py"))
shared = set().union(*map(neighbours, paths))
looked_at = []
for path in paths:
    # What others import alone is no script: its packages count for those.
    if path.stem in shared and metadata(path) is None:
        continue
    outside, block = imports(path), metadata(path)
    if block is None:
        assert not outside, f"{path.name} imports {outside} and has no inline metadata"
        continue
    assert re.fullmatch(r">=3\.\d+", block["requires-python"]), path
    names = {re.match(r"[A-Za-z0-9_-]+", requirement)[0] for requirement in block["dependencies"]}
    assert len(names) == len(block["dependencies"]), f"{path.name} names a package twice"
    expected = outside | (ENGINES if "xarray" in outside else set())
    assert names == expected, f"{path.name} names {sorted(names)} and imports {sorted(expected)}"
    unknown = set(block["dependencies"]) - requirements
    assert not unknown, f"{path.name} names {unknown}, which scripts/requirements.txt does not"
    looked_at.append(path.name)
print("\n".join(looked_at))
