"""The tests of pages, on pages made up: they find what is wrong, say where, and leave what is right alone."""

import re

import pytest

from commands import split_commands, wrong_command
from lib.markdown import read_anchors, read_fences, read_formulas, read_links, slug
from pages import Directories, PageError, copy_files, run_page, tracked, wrong_fences


def made_page(text):
    """A page from a text in which ''' stand for fences."""
    return text.replace("'''", "```")


@pytest.fixture
def run(tmp_path):
    """Runs a made-up page in a made-up repository; gives the repository."""
    source, repository, work = (tmp_path / name for name in ("source", "repository", "work"))
    work.mkdir()
    source.mkdir()
    (source / "sweep.toml").write_text("kept")

    def run(text, **options):
        copy_files(source, ["sweep.toml"], repository)
        run_page("made-up.md", made_page(text), Directories(repository, work, tmp_path), **options)
        assert (source / "sweep.toml").read_text() == "kept"
        assert sorted(source.iterdir()) == [source / "sweep.toml"]
        return repository

    return run


def test_blocks_share_one_terminal_and_one_interpreter(run):
    """Variables, directories, files and names go from block to block."""
    repository = run("""# A page
'''sh
mkdir results; cd results
NAME=one
'''
Some words.
'''python
from pathlib import Path

text = "from Python"
Path("file").write_text(text)
'''
'''sh
cat file | grep -q Python
cat <<END >"$NAME"
two lines
of text
END
cd ..
(exit 3) || true
echo changed >sweep.toml
'''
'''python
assert text == "from Python"
assert (Path.cwd().name, Path("results/one").read_text()) == ("repository", "two lines\\nof text\\n")
'''
'''text
false
'''
'''sh,no-run
sbatch job.sh
'''
""")
    assert (repository / "sweep.toml").read_text() == "changed\n"


@pytest.mark.parametrize(
    ("block", "line", "said"),
    [
        ("'''sh\necho before\nfalse\necho after\n'''", 5, "exit code 1 of: false"),
        ("'''sh\necho \\\n  before\nls nowhere | cat\n'''", 6, "exit code 2 of"),
        ("'''sh\n(exit 4)\n'''", 4, "exit code 4"),
        ("'''sh\nif true; then\n  no-such-command\nfi\n'''", 5, "no-such-command"),
        ("'''sh\nno-such-command-at-the-end\n'''", 4, "no-such-command-at-the-end"),
        ("- an item\n  '''sh\n  false\n  '''", 5, "of: false"),
        ("'''sh,exits-3\ntrue\n'''", 4, "should exit with 3"),
        ("'''sh,exits-3\n(exit 3)\n(exit 4)\n'''", 5, "exit code 4"),
        ("'''sh,exits-3\n(exit 3)\n'''\n'''sh\n(exit 3)\n'''", 7, "exit code 3"),
        ("'''sh\nexit 0\n'''", 1, "before the end of the page"),
        ("'''sh\ncat <<END\n'''\n'''sh\nfalse\n'''", 1, "before the end of the page"),
        ("'''sh\ntrap - ERR\nfalse\n'''", 5, "exit with 0"),
        ("'''python\nx = 1\n\nprint('said', y)\n'''", 6, "NameError"),
        ("'''python\nx = = 1\n'''", 4, "SyntaxError"),
        ("'''python\nraise SystemExit\n'''", 4, "SystemExit"),
    ],
)
def test_a_failure_names_page_line_command_and_output(run, block, line, said):
    """The line is that of the page."""
    with pytest.raises(PageError) as caught:
        run(f"# A page\n\n{block}\n")
    assert str(caught.value).startswith(f"made-up.md:{line}: "), str(caught.value)
    assert said in str(caught.value)


def test_output_stands_beside_a_failure(run):
    """That of the program, stdout and stderr."""
    with pytest.raises(PageError, match=r"(?s)of: false\n.*one\ntwo"):
        run("'''sh\necho one\necho two >&2\nfalse\n'''\n")


def test_announced_codes_and_closed_pipes_are_no_failures(run):
    """`… | head` closes the pipe of the program before it."""
    run("'''sh,exits-3\ntrue\n(exit 3)\n'''\n'''sh\nyes | head -n 1\n'''\n'''sh\nyes | head -n 1\ntrue\n'''\n")


def test_a_page_that_hangs_is_ended_with_what_it_started(run):
    """Also a process in the background."""
    with pytest.raises(PageError, match="more than 1 s"):
        run("'''sh\nsleep 1000 & sleep 1000\n'''\n", seconds=1)


def test_fences_say_what_is_known():
    """What no test may run is short and named; no block goes unnoticed."""
    fine = "'''sh\nls\n'''\n'''sh,exits-3\nls\n'''\n'''text\n'''\n"
    fine += "'''sh,no-run\n# a comment\nX=1 pip install \\\n  x | git y; cd z # run it\nmake 'a\nb'\n'''\n"
    assert wrong_fences(made_page(fine)) == []
    for text, message in [
        ("'''\nls\n'''", "no language"),
        ("'''bash\nls\n'''", "no language"),
        ("'''sh,norun\nls\n'''", "is no fence"),
        ("'''text,no-run\nls\n'''", "is no fence"),
        ("'''sh,no-run,exits-3\nls\n'''", "one option"),
        ("'''sh,no-run\npip install x\nls x\n'''", "line 3: `ls` can be run"),
        ("'''sh,no-run\npip install x && ls x\n'''", "line 2: `ls` can be run"),
    ]:
        assert any(message in wrong for wrong in wrong_fences(made_page(text))), (text, wrong_fences(made_page(text)))
    with pytest.raises(SyntaxError):
        wrong_fences(made_page("'''python,no-run\nx = = 1\n'''"))
    with pytest.raises(ValueError, match="line 2"):
        read_fences(made_page("\n'''sh\nls\n"))


def test_anchors_follow_the_rule_of_forges():
    """Small letters, no signs, numbers where a heading repeats."""
    assert slug("What an instrument reads: `mu_drag`, α & β (Eq. 3)") == "what-an-instrument-reads-mu_drag-α--β-eq-3"
    assert slug("[A link](other.md#there) and *stress*, _both_, 0.5 µm²") == "a-link-and-stress-both-05-µm"
    page = made_page("# One\n## Two\n## Two\n'''sh\n# Three\n'''\n<a id=\"four\"></a>\n## Five ##\n")
    assert read_anchors(page) == {"one", "two", "two-1", "four", "five"}


def test_links_are_found_outside_of_code():
    """Pictures, definitions and tags are links too."""
    page = made_page(
        "[a](b.md#c) ![d e](<f.svg> \"title\") `[no](no.md)`\n'''text\n[no](no.md)\n'''\n[`code`](g(1).md)\n"
        '<!-- [no](no.md) --> <img alt="x" src="h.png">\n\n[i]: j.md\n'
    )
    assert read_links(page) == [(1, "b.md#c"), (1, "f.svg"), (5, "g(1).md"), (6, "h.png"), (8, "j.md")]


def test_formulas_are_found_outside_of_code():
    """A dollar alone, or in code, is none."""
    page = made_page("$a$ and `$b$`, $c_1 +\nc_2$; 5 $ or \\$6 $\n\n$$\nd\n$$\n'''sh\n$HOME $PATH\n'''\nat $$e$$.\n")
    formulas = read_formulas(page)
    assert [re.sub(r"\s+", " ", formula.source.strip()) for formula in formulas] == ["a", "c_1 + c_2", "d", "e"]
    assert [formula.display for formula in formulas] == [False, False, True, True]
    assert [page[formula.start : formula.end][0] for formula in formulas] == ["$"] * 4


@pytest.mark.parametrize(
    ("command", "message"),
    [
        ("stribeck run sweeps/quick.toml -o sweeps/made --threads 2", None),
        ("X=1 time -v target/release/stribeck run sweeps/quick.toml", None),
        ("stribeck --version", None),
        ("stribeck run sweeps/none.toml", "there is no sweeps/none.toml"),
        ("stribeck run sweeps/quick.toml --fast", "stribeck has no option --fast"),
        ("stribeck bake sweeps/quick.toml", "stribeck has no command bake"),
        ("python scripts/compare.py results/quick results/fine --csv all.csv", None),
        ("python scripts/compare.py results/quick results/fine --xml", "scripts/compare.py has no option --xml"),
        ("python scripts/none.py", "there is no scripts/none.py"),
        ("./scripts/run sweeps/quick.toml", None),
        ("scripts/none", "there is no scripts/none"),
        ("cargo run --release --example left_out -- --repeats 3", None),
        ("cargo run --release -p stribeck-solver --example accuracy", None),
        ("cargo run --release --example right_out", "there is no example right_out"),
        ("cargo test --release -p stribeck-solver collocation::agreement -- --ignored", None),
        ("cargo test --release -p stribeck-solver collocation::disagreement", "there is no test disagreement"),
        ("cargo test --release -p stribeck-none", "there is no crate stribeck-none"),
    ],
)
def test_commands_that_are_not_run_are_read(command, message):
    """Their options are in the help, and what they name is there."""
    fence = read_fences(made_page(f"'''sh,no-run\n{command}\n'''"))[0]
    assert [wrong_command(words, tracked()) for _, words in split_commands(fence)] == [message]
