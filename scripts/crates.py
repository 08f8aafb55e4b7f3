"""Prints a table of the crates of this repository, in Markdown: how large each is, and what it builds on.

Its lines are those of `src`; its public items are those at its root, named in `lib.rs`; its dependencies are the direct
ones. With the report of a cold `cargo build --release --timings`, on a machine that does nothing else, it also prints
the seconds that the crate took to build by itself, when what it depends on was there.

Usage:
    python3 scripts/crates.py [target/cargo-timings/cargo-timing.html]
"""

import json
import re
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
NAMES = re.compile(r"pub (?:const )?(?:struct|enum|trait|type|const|static|fn|mod) (\w+)")


def exports(path):
    """The names that a `use` makes public, of its text behind `pub use`."""
    return [name.split(" as ")[-1] for name in re.findall(r"[\w:]+(?: as \w+)?(?=\s*[,};]|$)", path)]


def public_items(library):
    """The public items at the root of a crate."""
    text = re.sub(r"^\s*//.*$", "", library.read_text(encoding="utf-8"), flags=re.MULTILINE)
    root = [line for line in text.splitlines() if line.startswith("pub ")]
    own = [found[1] for line in root if (found := NAMES.match(line))]
    used = re.findall(r"^pub use ([^;]+);", text, flags=re.MULTILINE)
    return own + [name for path in used for name in exports(path)]


def seconds(report):
    """The seconds that each crate of the report took to build, without its build script."""
    text = report.read_text(encoding="utf-8")
    units = json.loads(re.search(r"UNIT_DATA = (\[.*?\]);\n", text, flags=re.DOTALL)[1])
    found = {}
    for unit in units:
        is_program = '(bin "' in unit["target"]
        if unit["target"].strip() == "" or is_program:
            found[unit["name"]] = found.get(unit["name"], 0.0) + unit["duration"]
    return found


def main():
    """Prints the table."""
    if len(sys.argv) > 2:
        print(__doc__, file=sys.stderr)
        sys.exit(2)
    took = seconds(Path(sys.argv[1])) if len(sys.argv) == 2 else None
    described = subprocess.run(
        ["cargo", "metadata", "--no-deps", "--format-version=1"], cwd=ROOT, check=True, stdout=subprocess.PIPE
    )
    heads = ["crate", "lines", "public items", "dependencies"] + ([] if took is None else ["seconds"])
    print(f"| {' | '.join(heads)} |\n|{' --- |' * len(heads)}")
    for package in sorted(json.loads(described.stdout)["packages"], key=lambda package: package["name"]):
        source = Path(package["manifest_path"]).parent / "src"
        lines = sum(len(file.read_text(encoding="utf-8").splitlines()) for file in source.rglob("*.rs"))
        direct = {it["name"] for it in package["dependencies"] if it["kind"] is None}
        cells = [f"`{package['name']}`", lines, len(public_items(source / "lib.rs")), len(direct)]
        if took is not None:
            cells.append(f"{took[package['name']]:.0f}" if package["name"] in took else "–")
        print(f"| {' | '.join(map(str, cells))} |")


if __name__ == "__main__":
    main()
