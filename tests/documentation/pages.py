"""Runs the blocks of a page as a reader would: in one terminal, from the root of a copy of the repository.

A page becomes a script of bash with as many lines as the page, in which each command stands on its own line of the
page, so that what bash says of lines holds for the page. Blocks of Python go, in their order, to one interpreter.
"""

import contextlib
import functools
import os
import re
import shutil
import signal
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path

from commands import PATH, split_commands, wrong_command
from lib.markdown import read_fences

HERE = Path(__file__).parent
ROOT = HERE.parents[1]

# What a fence may say. Blocks in the first two are run unless they say `no-run`.
LANGUAGES = {"sh", "python", "text", "toml", "csv", "json", "html", "js", "make", "snakemake", "rust"}
EXITS = re.compile(r"exits-([1-9][0-9]{0,2})")

PRELUDE = r"""
set -E -o pipefail
__announced=0
__fail() {
    trap - ERR
    printf '%s\n%s\n%s\n' "$1" "$2" "$3" >"$PAGE_FAILURE"
    exit 1
}
# Whether a pipeline with these codes of its commands has failed. A pipe that its reader closed (`… | head`) has not.
__broken() {
    local code last=${!#}
    [ "$last" -eq 0 ] || return 0
    for code; do
        [ "$code" -eq 0 ] || [ "$code" -eq 141 ] || return 0
    done
    return 1
}
# Of each command that fails: line, exit code, codes of the pipeline, command. The code that the fence announces is no
# failure.
__judge() {
    [ "$2" -eq "$__announced" ] && return
    __broken $3 && __fail "$1" "$2" "$4"
}
# The beginning of a block, with the code that its fence announces.
__open() {
    __announced=$1
    trap '__judge "$LINENO" "$?" "${PIPESTATUS[*]}" "$BASH_COMMAND"' ERR
}
# The end of a block: line and exit code of the last command.
__close() {
    if [ "$2" -ne "$__announced" ] && ! { [ "$__announced" -eq 0 ] && [ "$2" -eq 141 ]; }; then
        __fail "$1" "$2" "the last command of this block, which should exit with $__announced"
    fi
    __announced=0
}
__python() {
    local answer
    printf '%s %s %s\n' "$1" "$2" "$PWD" >&"${PYTHON[1]}"
    read -r answer <&"${PYTHON[0]}" || answer=$1
    [ "$answer" = done ] || __fail "$answer" 1 "this line of Python"
}
"""


@dataclass
class PageError(Exception):
    """A command of a page that did not do what the page says."""

    page: str
    line: int
    command: str
    output: str

    def __str__(self):
        """What a reader of the test's log needs."""
        return f"{self.page}:{self.line}: {self.command}\n{self.output}"


def is_run(fence):
    """Whether the block of a fence is one that is run."""
    return fence.language in ("sh", "python") and "no-run" not in fence.options


def hides_failures(fence):
    """Whether a block that is run joins commands so that the failure of one is not seen."""
    is_shell = fence.language == "sh" and "no-run" not in fence.options
    return is_shell and any("&&" in line for line in fence.lines)


def wrong_options(fence):
    """What is wrong with the options of a fence."""
    for option in fence.options:
        known = option == "no-run" or (fence.language == "sh" and EXITS.fullmatch(option))
        if not known or fence.language not in ("sh", "python"):
            yield f"`{fence.language},{option}` is no fence here"
    if len(fence.options) > 1:
        yield "a fence has one option at most"


def wrong_fences(text):
    """What is wrong with the fences of a page: a message for each, with its line."""
    wrong = []
    for fence in read_fences(text):
        say = lambda message, line=fence.line: wrong.append(f"line {line}: {message}")  # noqa: E731
        if fence.language not in LANGUAGES:
            say(f"`{fence.language}` is no language of a fence here; there are {', '.join(sorted(LANGUAGES))}")
            continue
        for message in wrong_options(fence):
            say(message)
        if hides_failures(fence):
            say("a block that is run has one command a line: bash does not see what fails before `&&`")
        if "no-run" in fence.options and fence.language == "sh":
            for line, words in split_commands(fence):
                message = wrong_command(words, tracked())
                if message:
                    say(message, line)
        elif "no-run" in fence.options:
            compile(fence.text, f"line {fence.line}", "exec")
    return wrong


def as_script(text):
    """The script of bash for a page, without its prelude."""
    lines = [""] * len(text.splitlines())
    for fence in filter(is_run, read_fences(text)):
        if fence.language == "python":
            lines[fence.line - 1] = f"__python {fence.line} {fence.end}"
            continue
        code = next((int(match[1]) for match in map(EXITS.fullmatch, fence.options) if match), 0)
        lines[fence.line - 1] = f"__open {code}"
        lines[fence.line : fence.end - 1] = fence.lines
        lines[fence.end - 1] = f'__close {fence.end - 1} "$?"'
    return "\n".join(lines) + '\n: >"$PAGE_DONE"\n'


@functools.cache
def tracked(root=ROOT):
    """The names of the files in the repository, with new ones that it does not ignore: no results, no build."""
    git = ["git", "-c", "safe.directory=*", "-C", str(root), "ls-files", "-z", "-co", "--exclude-standard"]
    if (root / ".git").exists():
        names = subprocess.run(git, capture_output=True, check=True).stdout.decode().split("\0")
    else:
        # A tree without its repository, as a release has it.
        built = {"target", ".venv", ".tools", "results"}
        names = [
            str(path.relative_to(root)) for path in root.rglob("*") if path.relative_to(root).parts[0] not in built
        ]
    # A file that was removed is listed until that is committed.
    return sorted(name for name in names if name and (root / name).is_file())


def executed_pages():
    """The pages whose blocks are run."""
    return [name for name in tracked() if name == "README.md" or (name.startswith("docs/") and name.endswith(".md"))]


def copy_files(root, names, target):
    """Copies files of a repository."""
    for name in names:
        copy = target / name
        copy.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy2(root / name, copy)


def environment(directories):
    """Variables of a page's terminal: the interpreter and the program of the tests first, and a home of its own."""
    kept = {name: value for name, value in os.environ.items() if not name.startswith(("PYTEST", "SLURM", "STRIBECK"))}
    home, temporary = directories.work / "home", directories.work / "tmp"
    for directory in (home, temporary):
        directory.mkdir()
    return kept | {
        "PATH": PATH,
        "HOME": str(home),
        "TMPDIR": str(temporary),
        "MPLBACKEND": "agg",
        "MPLCONFIGDIR": str(directories.caches),
        "NO_COLOR": "1",
        "PYTHONDONTWRITEBYTECODE": "1",
    }


@dataclass(frozen=True)
class Directories:
    """Where a page runs: a copy of the repository, an empty directory beside it, and one that pages share."""

    repository: Path
    work: Path
    caches: Path


def run_page(name, text, directories, *, seconds=60):
    """Runs the blocks of a page.

    Raises:
        PageError: with the line, the command and the output of the first block that fails.
    """
    work = directories.work
    script, page, failure, done, log = (work / file for file in ("page.sh", "page.md", "failure", "done", "output"))
    page.write_text(text, encoding="utf-8")
    # The prelude is a file of its own: the page's script has the lines of the page.
    prelude = work / "prelude.sh"
    interpreter = f"coproc PYTHON {{ exec '{sys.executable}' '{HERE / 'interpreter.py'}' '{page}' '{name}'; }}\n"
    has_python = any(fence.language == "python" for fence in filter(is_run, read_fences(text)))
    prelude.write_text((interpreter if has_python else "") + PRELUDE, encoding="utf-8")
    script.write_text(as_script(text), encoding="utf-8")
    variables = environment(directories) | {"PAGE_FAILURE": str(failure), "PAGE_DONE": str(done)}
    with log.open("wb") as output:
        process = subprocess.Popen(
            ["bash", "-c", f". '{prelude}'; . '{script}'"],
            cwd=directories.repository,
            env=variables,
            stdin=subprocess.DEVNULL,
            stdout=output,
            stderr=subprocess.STDOUT,
            start_new_session=True,
        )
        try:
            code = process.wait(timeout=seconds)
        except subprocess.TimeoutExpired:
            code = None
        finally:
            # Also what the page has left in the background.
            with contextlib.suppress(ProcessLookupError):
                os.killpg(process.pid, signal.SIGKILL)
            process.wait()
    said = log.read_text(encoding="utf-8", errors="replace")[-4000:]
    if code is None:
        raise PageError(name, 1, f"the page takes more than {seconds} s", said)
    if failure.exists():
        line, status, command = failure.read_text(encoding="utf-8", errors="replace").split("\n", 2)
        raise PageError(name, int(line), f"exit code {status} of: {command.strip()}", said)
    if code != 0:
        raise PageError(name, 1, f"the terminal ended with exit code {code}", said)
    if not done.exists():
        raise PageError(name, 1, "the terminal ended before the end of the page", said)
