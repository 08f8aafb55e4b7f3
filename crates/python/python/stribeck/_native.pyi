"""The extension module: numbers, and the names, units and descriptions that belong to them."""

from collections.abc import Callable
from pathlib import Path
from typing import Any

__all__ = [
    "FIELDS",
    "QUANTITIES",
    "__version__",
    "check_sweep",
    "fit",
    "main",
    "material_file",
    "prony",
    "run",
    "si",
    "solve",
    "solve_sweep",
    "universe",
]
__version__: str
FIELDS: list[str]
QUANTITIES: list[tuple[str, str]]

def solve(request: dict[str, Any]) -> dict[str, Any]: ...
def solve_sweep(name: str, text: str, asked: int | None) -> dict[str, Any]: ...
def run(sweep: Path, directory: Path, asked: int | None, told: Callable[[str, Any, int], None]) -> tuple[int, int]: ...
def fit(request: dict[str, Any]) -> dict[str, Any]: ...
def prony(
    are_fractions: bool, terms: list[tuple[float, float]], is_relaxed: bool, modulus: float
) -> dict[str, Any]: ...
def material_file(path: Path, options: dict[str, Any]) -> dict[str, Any]: ...
def si(kind: str, value: str) -> float: ...
def check_sweep(name: str, text: str) -> None: ...
def universe() -> str: ...
def main(words: list[str]) -> int: ...
