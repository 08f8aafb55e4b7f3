# /// script
# requires-python = ">=3.10"
# dependencies = ["numpy>=1.26"]
# ///
"""Makes the files of docs/how-to/from-instrument-files.md: what two instruments would write of a known experiment.

Usage:
    uv run scripts/instrument_files.py [DIRECTORY]

Friction is that of `stribeck curve` with 2 % of noise, moduli are those of a Prony series with 0.5 %.
`isotherms.csv` has the same moduli at five temperatures, for docs/how-to/materials.md.
Needs the program: the path in STRIBECK, or `stribeck`.
"""

import csv
import os
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np

# Moduli in MPa, times in s.
RELAXED, TERMS = 3.0, [(1.5, 0.003), (1.0, 0.03), (0.5, 0.3)]
# Of the shift with temperature, J/mol, and the gas constant.
ACTIVATION, GAS = 80e3, 8.314462618
VISCOSITY = "80 mPa s"
RATIOS = [0.2, 1.0]
READINGS = 6
noise = np.random.default_rng(2022)


def write_moduli(path):
    """Writes storage and loss modulus over the frequency, with semicolons and decimal commas."""
    lines = ["Frequency (Hz);Storage modulus (MPa);Loss modulus (MPa)"]
    for frequency in np.geomspace(0.01, 200, 27):
        storage, loss = moduli(2 * np.pi * frequency) * (1 + 0.005 * noise.standard_normal(2))
        lines.append(f"{frequency:.5g};{storage:.5g};{loss:.5g}".replace(".", ","))
    path.write_text("\n".join(lines) + "\n")


def friction():
    """Rows of `stribeck curve` at each ratio."""
    series = ", ".join(f'{{ modulus = "{modulus} MPa", time = {time} }}' for modulus, time in TERMS)
    sweep = f"""[laboratory]
radius = "10 mm"
load = "400 N/m"
viscosity = "{VISCOSITY}"
entrainment_speed = {{ from = "10 mm/s", to = "1 m/s", points = 9, scale = "log" }}
slide_roll_ratio = {RATIOS}
[flat]
relaxed_modulus = "{RELAXED} MPa"
poisson_ratio = 0.5
relaxation = [{series}]
"""
    with tempfile.TemporaryDirectory() as directory:
        file, table = Path(directory, "sweep.toml"), Path(directory, "curve.csv")
        file.write_text(sweep)
        for ratio in RATIOS:
            program = [os.environ.get("STRIBECK", "stribeck"), "curve", file, "--at", f"slide_roll_ratio={ratio}"]
            subprocess.run([*program, "--csv", table], check=True, stdout=subprocess.DEVNULL)
            with table.open() as rows:
                yield from csv.DictReader(rows)


def write_traction(path):
    """Writes a table of readings for each step, as traction machines export them."""
    lines = ["Traction test", "Specimen:\trubber disc, steel roller", "Lubricant:\tmineral oil", ""]
    names = ["Step Time (s)", "Traction Coeff (-)", "Lube Temp (degC)", "Rolling Speed (mm/s)", "Sliding Speed (mm/s)"]
    for step, row in enumerate(friction(), 1):
        speed, ratio = 1e3 * float(row["entrainment_speed"]), float(row["slide_roll_ratio"])
        lines += [f"Step {step}", "Step type\tTIMED", "\t".join([*names, "SRR (%)"])]
        for reading in range(1, READINGS + 1):
            friction_coefficient = float(row["mu_drag"]) * (1 + 0.02 * noise.standard_normal())
            cells = [f"{reading}", f"{friction_coefficient:.5f}", "40.0", f"{speed:.2f}", f"{speed * ratio:.2f}"]
            lines.append("\t".join([*cells, f"{100 * ratio:.1f}"]))
        lines.append("")
    path.write_bytes("\r\n".join(lines).encode("latin-1"))


def moduli(omega):
    """Storage and loss modulus in MPa of the rubber at a rate in rad/s."""
    terms = [(modulus, omega * time) for modulus, time in TERMS]
    storage = RELAXED + sum(modulus * z**2 / (1 + z**2) for modulus, z in terms)
    return np.array([storage, sum(modulus * z / (1 + z**2) for modulus, z in terms)])


def write_isotherms(path):
    """Writes storage and loss modulus over the frequency at five temperatures, shifted by a law of Arrhenius."""
    noise = np.random.default_rng(2023)
    lines = ["Temperature (degC),Frequency (Hz),Storage modulus (MPa),Loss modulus (MPa)"]
    for celsius in [-10, 0, 10, 20, 30]:
        factor = np.exp(ACTIVATION / GAS * (1 / (celsius + 273.15) - 1 / 293.15))
        for frequency in np.geomspace(0.1, 20, 9):
            numbers = moduli(2 * np.pi * frequency * factor) * (1 + 0.005 * noise.standard_normal(2))
            lines.append(f"{celsius},{frequency:.4g},{numbers[0]:.5g},{numbers[1]:.5g}")
    path.write_text("\n".join(lines) + "\n")


def main():
    """Writes all files."""
    directory = Path(sys.argv[1] if len(sys.argv) > 1 else "docs/how-to/instrument-files")
    directory.mkdir(parents=True, exist_ok=True)
    write_moduli(directory / "moduli.csv")
    write_traction(directory / "traction.txt")
    write_isotherms(directory / "isotherms.csv")


main()
