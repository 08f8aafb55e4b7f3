"""Surfaces: the readers of Rust, Python and JavaScript give the same numbers and refuse the same files."""

import csv
import json
import pickle
import shutil
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

import stribeck
import stribeck.surface

READER = Path(__file__).parents[3] / "assets/surface.js"
# Reads points as lines of text, and prints at each the values, the derivatives, and for each axis the values by its
# line and the coordinate that came back from its place.
NODE = """
import { readFileSync } from "node:fs";
const { readSurface } = await import(process.argv[1]);
const { axes, evaluate, derivatives, line: lineAlong } = readSurface(JSON.parse(readFileSync(process.argv[2], "utf8")));
const found = readFileSync(0, "utf8").trim().split("\\n").filter(Boolean).map((line, row) => {
  const list = line.split(",").map(Number);
  const point = row % 2 ? list : Object.fromEntries(axes.map(({ name }, m) => [name, list[m]]));
  const along = axes.map(({ name, place, value }, m) => [lineAlong(name, point)(list[m]), value(place(list[m]))]);
  return [evaluate(point), derivatives(point), along.map(([values]) => values), along.map(([, x]) => x)];
});
console.log(JSON.stringify(found));
"""

SWEEPS = {
    "compact": """[axes]
        alpha = { from = 0.0, to = inf }
        beta = { from = 10.0, to = 1000.0, scale = "log" }
        f = [10.0]
        [surface]
        tolerance = 1e-3
        quantities = ["mu_drag", "mu_v", "mu_h", "c", "x_outlet"]""",
    "laboratory": """[laboratory]
        radius = "2 mm"
        relaxed_modulus = "100 kPa"
        poisson_ratio = 0.5
        viscosity = "1 Pa s"
        retardation_time = "20 ms"
        f = { from = 0.0, to = 10.0, scale = "log" }
        load = { from = "100 N/m", to = "200 N/m" }
        speed = { from = "10 mm/s", to = "100 mm/s", scale = "log" }
        [surface]
        tolerance = 1e-2
        quantities = ["mu_drag", "mu_v"]""",
    # In double precision, and with parts that may change their sign.
    "tight": """[axes]
        slide_roll = [0.5]
        alpha = [1.0]
        beta = { from = 10.0, to = 100.0, scale = "log" }
        f = [10.0]
        [surface]
        tolerance = 1e-6""",
}


@pytest.fixture(scope="module")
def files(tmp_path_factory, program):
    """A surface.json of each sweep."""
    directory = tmp_path_factory.mktemp("surfaces")
    for name, sweep in SWEEPS.items():
        (directory / f"{name}.toml").write_text(sweep)
        made = program("surface", directory / f"{name}.toml", "-o", directory / name, "--quiet")
        assert made.returncode == 0, made.stderr
    return {name: directory / name / "surface.json" for name in SWEEPS}


def node(file, points=""):
    """Read a surface by JavaScript and evaluate it at lines of points."""
    command = [shutil.which("node"), "--input-type=module", "-e", NODE, READER.as_uri(), str(file)]
    return subprocess.run(command, input=points, capture_output=True, text=True, check=False)


def random_points(file, count):
    """Random points of a surface, spread as its axes are; its two opposite corners first."""
    random = np.random.default_rng(7)
    points = []
    for axis in json.loads(file.read_text())["axes"]:
        low, high = float(axis["from"]), float(axis["to"])
        ends = (low, high) if axis["map"] == "linear" else np.log([max(low, 1e-6), min(high, 1e6)])
        x = random.uniform(*ends, count)
        x = np.clip(x if axis["map"] == "linear" else np.exp(x), low, high)
        x[:2] = low, high
        points.append(x)
    return np.array(points)


def expect_same(found, expected, scale):
    """Expect that numbers agree to 1e-12 of themselves, or of the scale where that is larger, and are missing alike."""
    missing = np.isnan(expected)
    assert (np.isnan(found) == missing).all()
    assert (np.abs(found - expected) <= 1e-12 * np.maximum(np.abs(expected), scale))[~missing].all()


@pytest.mark.parametrize("name", SWEEPS)
def test_three_readers_agree(name, files, program, tmp_path):
    surface, points = stribeck.Surface(files[name]), random_points(files[name], 1000)
    values, slopes = surface(*points, derivatives=True)
    # A part of the drag is known to a share of it.
    scales = {key: 1e-3 * values["mu_drag"] if key in ("mu_v", "mu_h") else np.zeros(1000) for key in values}

    table = [list(surface.axes), *(map(repr, map(float, point)) for point in points.T)]
    (tmp_path / "points.csv").write_text("".join(",".join(row) + "\n" for row in table))
    done = program("evaluate", files[name], "--points", tmp_path / "points.csv")
    assert done.returncode == 0, done.stderr
    rows = list(csv.DictReader(done.stdout.splitlines()))
    for key, value in values.items():
        expect_same(value, np.array([float(row[key]) for row in rows]), scales[key])

    lines = "".join(",".join(str(x).replace("inf", "Infinity") for x in point) + "\n" for point in points.T)
    done = node(files[name], lines)
    assert done.returncode == 0, done.stderr
    in_script = json.loads(done.stdout)
    with np.errstate(invalid="ignore"):
        for key, value in values.items():
            expect_same(np.array([found[key] for found, *_ in in_script]), value, scales[key])
            for m, (axis, x) in enumerate(zip(surface.axes, points, strict=True)):
                slope = np.array([found[key][axis] for _, found, *_ in in_script], dtype=float)
                expect_same(x * slope, x * slopes[key][axis], np.abs(value))
                expect_same(np.array([lines[m][key] for *_, lines, _ in in_script]), value, scales[key])
                # JSON has null for infinity.
                back = np.array([np.inf if xs[m] is None else xs[m] for *_, xs in in_script])
                assert (back == x)[:2].all() and np.allclose(back, x, rtol=1e-9), "a value comes back from its place"

        for place in range(20):
            at = [f"--at={axis}={x}" for axis, x in zip(surface.axes, points[:, place].tolist(), strict=True)]
            done = program("evaluate", files[name], *at, "--derivatives", "--json")
            assert done.returncode == 0, done.stderr
            for key, found in json.loads(done.stdout).items():
                for axis, x in zip(surface.axes, points[:, place], strict=True):
                    slope = float("nan" if found["derivatives"][axis] is None else found["derivatives"][axis])
                    expect_same(x * slope, x * slopes[key][axis][place], np.abs(values[key][place]))


def test_derivatives_are_limits_of_differences(files):
    for name, file in files.items():
        surface, points = stribeck.Surface(file), random_points(file, 300)[:, 2:]
        points = np.clip(points, *(np.array(list(surface.axes.values())).T[:, :, None] * [[[1.001]], [[0.999]]]))
        values, slopes = surface(*points, derivatives=True)
        for m, axis in enumerate(surface.axes):
            step = np.ones((len(points), 1))
            step[m] = 1e-4
            above, below = (surface(*(points * (1.0 + sign * step * (step < 1)))) for sign in (1, -1))
            for key, value in values.items():
                difference = (above[key] - below[key]) / 2e-4
                assert np.abs(points[m] * slopes[key][axis] - difference).max() < 1e-4 * np.abs(value).max(), (
                    name,
                    key,
                )


def test_the_ends_of_compact_axes_have_values_and_known_slopes(files):
    surface = stribeck.Surface(files["compact"])
    values, slopes = surface([0.0, np.inf], 100.0, derivatives=True)
    assert all(np.isfinite(value).all() for value in values.values())
    for slope in slopes.values():
        assert np.isnan(slope["alpha"][0]) and slope["alpha"][1] == 0.0 and np.isfinite(slope["beta"]).all()


def test_points_are_broadcast_and_blocks_do_not_show(files):
    surface = stribeck.Surface(files["compact"])
    alpha, beta = np.geomspace(1e-3, 1e3, 70)[:, None], np.geomspace(10.0, 1000.0, 300)
    assert alpha.size * beta.size > 2 * surface._block
    grid, slopes = surface(beta=beta, alpha=alpha, derivatives=True)
    one, one_slopes = surface(alpha[40, 0], beta=float(beta[250]), derivatives=True)
    for key, value in grid.items():
        assert value.shape == slopes[key]["beta"].shape == (70, 300) and isinstance(one[key], float)
        assert one[key] == pytest.approx(value[40, 250], rel=1e-12)
        assert one_slopes[key]["alpha"] == pytest.approx(slopes[key]["alpha"][40, 250], rel=1e-9)
    assert surface([], 20.0)["c"].shape == (0,)


def test_a_surface_tells_what_it_is(files):
    surface = stribeck.Surface(files["laboratory"])
    assert surface.axes == {"load": (100.0, 200.0), "speed": (0.01, 0.1), "f": (0.0, 10.0)}
    assert list(surface.quantities) == ["mu_drag", "mu_v"] and surface.units["speed"] == "m/s"
    assert surface.tolerance == 1e-2 and 0.0 < surface.certificate["errors"]["mu_v"]["largest"] <= 1e-2
    assert repr(surface).endswith("over load from 100 to 200, speed from 0.01 to 0.1, f from 0 to 10>")
    assert pickle.loads(pickle.dumps(surface))(150.0, 0.05, 1.0) == surface(150.0, 0.05, 1.0)
    assert stribeck.Surface(files["compact"]).units["mu_v"] == "a0/R"


def test_what_is_no_point_of_the_surface_is_refused(files):
    surface = stribeck.Surface(files["compact"])
    for call, told in [
        (
            lambda: surface(1.0, [20.0, 1001.0]),
            "beta = 1001.0 is outside the surface, which has beta from 10.0 to 1000.0",
        ),
        (lambda: surface(-1.0, 20.0), "alpha = -1.0 is outside"),
        (lambda: surface(float("nan"), 20.0), "alpha = nan is outside"),
        (lambda: surface(1.0), "a point of this surface has alpha, beta"),
        (lambda: surface(1.0, 20.0, 3.0), "a point of this surface has alpha, beta"),
        (lambda: surface(1.0, 20.0, alpha=1.0), "a point of this surface has alpha, beta"),
        (lambda: surface(1.0, gamma=20.0), "a point of this surface has alpha, beta"),
        (lambda: surface("one", 20.0), "alpha must be a number"),
        (lambda: surface([1.0, 2.0], [20.0, 30.0, 40.0]), "shapes do not go together"),
    ]:
        with pytest.raises(stribeck.InputError, match=told):
            call()
    for point in ["1,1001", "-1,20", "NaN,20", "1", "1,20,3"]:
        refused = node(files["compact"], f"1,20\n{point}\n")
        assert refused.returncode == 1 and "RangeError" in refused.stderr, point


def other_letter(text):
    """Change one letter of numbers in base64: the first digits of the first one."""
    return text[:3] + ("A" if text[3] != "A" else "B") + text[4:]


def damages(text):
    """Texts that a damaged surface may have."""
    for quantity, record in enumerate(json.loads(text)["quantities"]):
        for axis in range(len(record["factors"])):
            file = json.loads(text)
            factors = file["quantities"][quantity]["factors"]
            factors[axis] = other_letter(factors[axis])
            yield json.dumps(file)
    for change in [
        lambda file: file.update(format="stribeck surface 2"),
        lambda file: file.pop("axes"),
        lambda file: file["axes"][0].update(map="other"),
        lambda file: file["axes"][0].update({"from": 1.0, "to": 1.0}),
        lambda file: file["quantities"][0].update(core="!" + file["quantities"][0]["core"][1:]),
        lambda file: file["quantities"][0].update(shape=[[1, 1], [1, 1]]),
        lambda file: file["quantities"][1].update(of="mu_h"),
        lambda file: file["quantities"][1].update(transform="other"),
        lambda file: file["checks"][2]["values"].__setitem__(0, 1.0),
    ]:
        file = json.loads(text)
        change(file)
        yield json.dumps(file)
    yield text[: len(text) // 2]


def test_damaged_and_unknown_files_are_refused_by_all_readers(files, program, tmp_path):
    file, point = files["compact"], ("--alpha", "1", "--beta", "20")
    assert program("evaluate", file, *point).returncode == node(file).returncode == 0
    for number, text in enumerate(damages(file.read_text())):
        damaged = tmp_path / "damaged.json"
        damaged.write_text(text)
        with pytest.raises(stribeck.InputError, match=r"damaged\.json: .*(`stribeck surface` makes|damaged|format)"):
            stribeck.Surface(damaged)
        assert program("evaluate", damaged, *point).returncode == 2, number
        in_script = node(damaged)
        assert in_script.returncode == 1 and "Error" in in_script.stderr, number
    with pytest.raises(stribeck.StorageError, match="cannot read the surface"):
        stribeck.Surface(tmp_path / "nowhere.json")


def test_a_copy_of_the_file_reads_without_the_package(files, tmp_path):
    shutil.copy(stribeck.surface.__file__, tmp_path / "surfaces.py")
    code = (
        "import sys; sys.path.insert(0, sys.argv[1]); sys.modules['stribeck'] = None\n"
        "from surfaces import Surface\n"
        "surface = Surface(sys.argv[2]); print(repr(float(surface(beta=20.0)['mu_drag'])))\n"
        "try:\n    surface(1e9)\nexcept ValueError as error:\n    print(error)\n"
    )
    command = [sys.executable, "-c", code, tmp_path, files["tight"]]
    said = subprocess.run(command, capture_output=True, text=True, check=True).stdout.splitlines()
    assert float(said[0]) == stribeck.Surface(files["tight"])(20.0)["mu_drag"]
    assert said[1] == "beta = 1000000000.0 is outside the surface, which has beta from 10.0 to 100.0"
