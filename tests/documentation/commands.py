"""Reads commands that no test runs: what they start, and whether what they name is there."""

import os
import re
import shlex
import subprocess
import sys
from functools import cache
from itertools import pairwise
from pathlib import Path, PurePosixPath

ROOT = Path(__file__).parents[2]
# Programs beside this interpreter first: the package of the repository is installed there.
PATH = f"{Path(sys.executable).parent}:{os.environ['PATH']}"

# What a page may show and no test runs: it fetches, compiles, asks a cluster, takes minutes, or needs what such a
# command made before it. Scripts of the repository are allowed too.
NOT_RUN = {
    *("apt-get", "cargo", "git", "make", "module", "pip", "rustup", "sudo", "uv"),
    *("sbatch", "scancel", "snakemake", "squeue"),
    *("cat", "cd", "eval", "export"),
    *("python", "python3", "stribeck"),
}
WRITES = {"-o", "--output", "--csv", ">"}
TAKES_A_VALUE = {"-p", "--bench", "--example", "--features", "--manifest-path", "--path", "--root", "--test"}


def split_commands(fence):
    """The line and the words of each command of a block of simple commands."""
    commands, held, first = [], "", 0
    for line, text in enumerate(fence.lines, start=fence.line + 1):
        held, first = (f"{held}\n{text}", first) if held else (text, line)
        if held.endswith("\\"):
            held = held[:-1]
            continue
        lexer = shlex.shlex(held, posix=True, punctuation_chars="|&;")
        lexer.whitespace_split = True
        try:
            parts = list(lexer)
        except ValueError:  # A quotation goes on in the next line.
            continue
        commands += [(first, plain(words)) for words in split_at_signs(parts)]
        held = ""
    if held:
        raise ValueError(f"line {first}: a quotation is not closed")
    return commands


def split_at_signs(parts):
    """The words between `|`, `;`, `&&` and the like."""
    words = []
    for part in [*parts, ";"]:
        if set(part) <= set("|&;"):
            if words:
                yield words
            words = []
        else:
            words.append(part)


def plain(words):
    """A command without variables and `time` before it, and by the name that the program has on the path."""
    while len(words) > 1 and re.match(r"\w+=", words[0]):
        words = words[1:]
    if words[0] in ("time", "/usr/bin/time"):
        words = words[1:]
        while words[0].startswith("-"):
            words = words[1:]
    name = re.sub(r"^(\./)?(scripts/)", r"./\2", words[0])
    return ["stribeck" if name == "target/release/stribeck" else name, *words[1:]]


def wrong_command(words, names):
    """What is wrong with a command that is not run, in a repository with these names; None if nothing is."""
    name = words[0]
    if name not in NOT_RUN and not name.startswith("./scripts/"):
        return f"`{name}` can be run; no-run is for {', '.join(sorted(NOT_RUN))}"
    missing = [path for path in named_files(words) if path not in names]
    if missing:
        return f"there is no {missing[0]}"
    if name == "stribeck":
        return wrong_option(words, help_of(words[1]), "stribeck")
    if name in ("python", "python3") and words[1].endswith(".py"):
        return wrong_option(words, (ROOT / words[1]).read_text(encoding="utf-8"), words[1])
    if name == "cargo":
        return wrong_target(words, names) or (wrong_filter(words, names) if words[1] == "test" else None)
    return None


def named_files(words):
    """The files of the repository that a command names, save those that it would write."""
    for before, word in pairwise(["", *words]):
        path = word.removeprefix("./")
        if re.fullmatch(r"(docs|examples|scripts|sweeps)/[\w./-]+", path) and before not in WRITES:
            yield path


@cache
def help_of(command):
    """What the program says of a command; nothing if it has no such command."""
    arguments = ["--help"] if command.startswith("-") else ["help", command]
    run = subprocess.run(["stribeck", *arguments], capture_output=True, text=True, check=False, env={"PATH": PATH})
    return run.stdout if run.returncode == 0 else ""


def wrong_option(words, text, place):
    """An option of a command that a text does not have."""
    if not text:
        return f"{place} has no command {words[1]}"
    for word in words[1:]:
        option = word.split("=")[0]
        if re.match(r"--?[a-z]", option) and not re.search(rf"(?<![\w-]){re.escape(option)}(?![\w-])", text):
            return f"{place} has no option {option}"
    return None


def wrong_target(words, names):
    """A crate, an example or a benchmark that a command of cargo names and that is not there."""
    files = [PurePosixPath(name) for name in names if name.endswith(".rs")]
    stems = {path.parent.name if path.stem == "main" else path.stem for path in files}
    crates = {f"stribeck-{name.split('/')[1]}" for name in names if name.startswith("crates/")} | {"stribeck"}
    for option, value in pairwise(words):
        if option == "-p" and value not in crates:
            return f"there is no crate {value}"
        if option in ("--bench", "--example") and value not in stems:
            return f"there is no {option.removeprefix('--')} {value}"
    return None


def wrong_filter(words, names):
    """A part of the name of tests, as `collocation::errors`, with which no file, module or function begins."""
    known = [part for name in names if name.endswith(".rs") for part in PurePosixPath(name).with_suffix("").parts]
    known += functions()
    own = words[: words.index("--")] if "--" in words else words
    for option, word in pairwise(own[1:]):
        if option in TAKES_A_VALUE or word.startswith("-"):
            continue
        for part in filter(None, word.split("::")):
            if not any(name.startswith(part) for name in known):
                return f"there is no test {part}"
    return None


@cache
def functions():
    """The names of all functions and modules of the crates."""
    files = [path for place in ("tests", "crates", "src") for path in (ROOT / place).rglob("*.rs")]
    return [name for path in files for name in re.findall(r"\b(?:fn|mod) (\w+)", path.read_text(encoding="utf-8"))]
