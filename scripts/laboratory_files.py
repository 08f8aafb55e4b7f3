# /// script
# requires-python = ">=3.10"
# dependencies = []
# ///
"""Reads ten public files of laboratories and prints what was understood of them (docs/how-to/from-instrument-files.md).

Usage:
    uv run scripts/laboratory_files.py DIRECTORY

The files are those of the projects that the table names, under the names that it has. None of them is kept here.
Needs the program: the path in STRIBECK, or `stribeck`.
"""

import json
import os
import re
import subprocess
import sys
import tempfile
from pathlib import Path

PYVISCO = "NREL/pyvisco"
REFERENCE = ["--reference-temperature", "20 degC"]
RUBBER = ["--poisson-ratio", "0.5"]
FACTORS = "pyvisco_freq_user_master__shift_factors.csv"
# File, project, options of `stribeck material`.
MATERIALS = [
    ("pyvisco_freq_user_raw.csv", PYVISCO, REFERENCE),
    ("pyvisco_freq_user_master.csv", PYVISCO, ["--shift-factors", FACTORS]),
    ("pyvisco_time_user_raw.csv", PYVISCO, REFERENCE),
    ("pyvisco_prony_terms_KPf_MD.csv", PYVISCO, []),
    ("pyvisco_ansys_freq_master_prony_terms.MPL", PYVISCO, []),
    ("epdm70_tf_015p.csv", "MarcusNi96/dma-prony-validation", RUBBER + REFERENCE),
    ("reptate.osc", "jorge-ramirez-upm/RepTate", RUBBER),
    ("rheos_freq.csv", "JuliaRheology/RHEOS.jl", ["--columns", "omega=#1,shear_storage=#2,shear_loss=#3", *RUBBER]),
]
TRACTION = ("mtm_export_first_steps.txt", "moritzploss/tribology")
SWEEP = """[laboratory]
radius = "9.5 mm"
load = "400 N/m"
viscosity = "100 mPa s"
entrainment_speed = { from = "0.1 m/s", to = "3 m/s", points = 3, scale = "log" }
slide_roll_ratio = 1.0
[flat]
relaxed_modulus = "3 MPa"
poisson_ratio = 0.5
f = 1.0
retardation_time = "10 ms"
"""


class Said:
    """What the program said when it was asked."""

    def __init__(self, directory, arguments):
        program = [os.environ.get("STRIBECK", "stribeck"), *arguments]
        run = subprocess.run(program, check=False, cwd=directory, capture_output=True, text=True)
        self.code, self.notes = run.returncode, run.stderr
        self.result = json.loads(run.stdout) if run.returncode == 0 else None

    def understood(self):
        """How the file is written, its rows and what its columns hold."""
        first = self.notes.splitlines()[0].split(": ", 1)[1]
        columns = re.search(r"^  columns: (.*)$", self.notes, re.MULTILINE)
        fields = [field(column) for column in columns[1].split("; ")] if columns else []
        parts = first.split("; ")
        return "; ".join([parts[-1], ", ".join(fields), *parts[:-1]]) if fields else first


def field(column):
    """The name of what a column holds, from "`COF` as mu, in %"."""
    return re.sub(r"^`(.*?)`( as (\w+))?.*$", lambda found: found[3] or found[1], column)


def outcome(said):
    """What became of a material, in a few words."""
    if said.result is None:
        return "refused: " + said.notes.strip().splitlines()[-1].split(": ", 2)[-1].split(". ")[0]
    words, result = [], said.result
    if curve := result.get("master_curve"):
        law = curve["laws"][0]
        name = re.search('law = "(\\w+)"', law["toml"])[1]
        words.append(f"{len(curve['shifts'])} shift factors, {name} within {law['rms_residual']:.2f} decades rms")
    terms = len(result["relaxation"])
    if "rms_residual" in result:
        words.append(f"{terms} terms, {100 * result['rms_residual']:.1f} % rms")
    else:
        words.append(f"{terms} terms as they stand there")
    if doubt := result.get("doubt"):
        words.append(doubt.split(": ")[0].split(";")[0])
    return "; ".join(words)


def command(name, options, of):
    """A command as a cell of the table."""
    quoted = [f'"{option}"' if re.search(r"[ #]", option) else option for option in options]
    return f"`{' '.join([of, name, *quoted])}`"


def rows(directory):
    """The cells of each file."""
    for name, project, options in MATERIALS:
        said = Said(directory, ["material", name, *options, "--json"])
        yield command(name, options, "material"), project, said.understood(), outcome(said)
        if FACTORS in options:
            lines = [line for line in said.notes.splitlines() if line.startswith(FACTORS)]
            yield f"`{FACTORS}`", project, lines[0].split(": ", 1)[1], "taken in the row above"
    name, project = TRACTION
    with tempfile.TemporaryDirectory() as temporary:
        sweep = Path(temporary, "sweep.toml")
        sweep.write_text(SWEEP)
        said = Said(directory, ["fit", name, str(sweep), "--unknown", "viscosity", "--json"])
    steps = re.search(r"note: (\d+ steps; \d+ points)", said.notes)
    yield command(name, ["SWEEP", "--unknown", "viscosity"], "fit"), project, said.understood(), steps[1]


def main():
    """Prints the table."""
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    print("| `stribeck` … | from | what was read | what came of it |\n| --- | --- | --- | --- |")
    for cells in rows(Path(sys.argv[1])):
        print(f"| {' | '.join(cell.replace('|', chr(92) + '|') for cell in cells)} |")


main()
