//! Bad sweep files: each row says what is wrong, where, and what the error has to say. Tests of the library and of the
//! program share them.

#![allow(dead_code)]

/// Axes that are valid, in four lines; the rows of the table put something wrong after or instead of them.
pub const AXES: &str = "[axes]\nf = [100.0]\nalpha = [1.0]\nbeta = [10.0]\n";

pub fn with_axes(rest: &str) -> String {
    format!("{AXES}{rest}")
}

pub fn with_alpha(alpha: &str) -> String {
    format!("[axes]\nf = [100.0]\nalpha = {alpha}\nbeta = [10.0]\n")
}

pub fn with_beta(beta: &str) -> String {
    format!("[axes]\nf = [100.0]\nalpha = [1.0]\nbeta = {beta}\n")
}

pub fn with_f(f: &str) -> String {
    format!("[axes]\nf = {f}\nalpha = [1.0]\nbeta = [10.0]\n")
}

/// Quantities of the laboratory in nine lines, and more sections.
fn with_body(sections: &str) -> String {
    with_laboratory("", "") + sections
}

/// Quantities of the laboratory, a line each, one of them replaced.
pub fn with_laboratory(key: &str, value: &str) -> String {
    let lines = [
        ("radius", "0.002"),
        ("load", "100.0"),
        ("relaxed_modulus", "1e5"),
        ("poisson_ratio", "0.5"),
        ("viscosity", "5.1"),
        ("retardation_time", "0.02"),
        ("speed", "[0.01, 0.1]"),
        ("f", "10.0"),
    ];
    let lines = lines.map(|(name, usual)| format!("{name} = {}\n", if name == key { value } else { usual }));
    format!("[laboratory]\n{}", lines.concat())
}

/// The same with other speeds.
fn with_speeds(speeds: &str) -> String {
    with_laboratory("speed", "V").replace("speed = V", speeds)
}

/// (text, place `line:column`, words of the message, words of the remedy)
pub type Row = (String, &'static str, &'static str, &'static str);

/// One row for each mistake.
pub fn bad_files() -> Vec<Row> {
    vec![
        // No TOML.
        ("[axes\nf = [1.0]".into(), "1:5", "unclosed table, expected `]`", "headers [section]"),
        (with_axes("[solver]\ntolerance = 0,5\n"), "6:14", "not valid TOML", "the decimal mark of a number is a point"),
        (with_axes("[solver]\nmethod = relaxation\n"), "6:10", "quoted", "double quotes"),
        (
            with_axes("[solver]\nmethod = \"relaxation\"\nmethod = \"relaxation\"\n"),
            "7:1",
            "duplicate key",
            "only once",
        ),
        ("[axes]\nf = [1.0".into(), "2:8", "unclosed array", "brackets"),
        // Keys.
        (String::new(), "1:1", "needs `axes`", "[axes]"),
        ("title = \"empty\"\n".into(), "1:1", "needs `axes`", "[axes]"),
        ("title = \"t\"\n[axes]\nf = [1.0]\nalpha = [1.0]\n".into(), "2:1", "[axes] needs `beta`", "beta = ["),
        (with_axes("[solvr]\n"), "5:2", "`solvr` is not a key of the top level", "did you mean `solver`?"),
        ("[axes]\nf = [1.0]\nalhpa = [1.0]\n".into(), "3:1", "`alhpa` is not a key of [axes]", "`alpha`?"),
        ("alpha = [1.0]\n".into(), "1:1", "top level, which has `title`, `axes`", "key of [axes]: move it there"),
        (with_axes("[solver]\npoints = 401\n"), "6:1", "`points`", "[solver.relaxation]: move it there"),
        (with_axes("[solver.relaxation]\nTolerance = 1e-8\n"), "6:1", "`Tolerance`", "did you mean `tolerance`?"),
        (with_axes("[output]\nqwertyuiop = 1\n"), "6:1", "`qwertyuiop`", "remove the key, or write one of `fields`"),
        (with_alpha("{ from = 1.0, to = 2.0, points = 3, step = 1 }"), "3:45", "`step`", "one of `from`"),
        // Types.
        ("axes = 3\n".into(), "1:8", "`axes` must be a table, found `3`", "`f`, `alpha`, `beta`"),
        (with_f("-100.0"), "2:5", "finite and at least 0", "positive for a viscoelastic one"),
        (with_f("\"100\""), "2:5", "number, a list or a range", "[10.0, 100.0]"),
        (with_beta("[\"10\"]"), "4:9", "must be a number, found `\"10\"`", "without quotes"),
        (with_beta("[1979-05-27]"), "4:9", "must be a number", "plain number"),
        (with_axes("[output]\nlimits = \"yes\"\n"), "6:10", "must be true or false", "without quotes"),
        (with_axes("[output]\nfields = \"pressure\"\n"), "6:10", "must be a list", "[\"pressure\""),
        ("title = 5\n[axes]\nf = [1]\nalpha = [1]\nbeta = [1]\n".into(), "1:9", "must be a text", "double quotes"),
        (with_axes("[substrate]\nmodes = 2\n"), "6:9", "must be a list", "share = 0.7"),
        (with_axes("[substrate]\nmodes = [1.0]\n"), "6:10", "must be a table", "`share`, `time`"),
        // Lists.
        (with_alpha("[]"), "3:9", "at least one value", "[100.0]"),
        (with_alpha("[10.0, 1.0]"), "3:16", "must ascend, found `1.0`", "sort the list"),
        (with_alpha("[1, 1.0]"), "3:13", "only once, found `1.0`", "remove one"),
        (with_alpha("[inf, inf]"), "3:15", "only once", "remove one"),
        (with_alpha("[-1.0]"), "3:10", "at least 0, or inf, found `-1.0`", "positive"),
        (with_alpha("[-inf]"), "3:10", "at least 0, or inf", "positive"),
        (with_alpha("[1.0, nan]"), "3:15", "at least 0, or inf, found `nan`", "positive"),
        (with_beta("[0.0]"), "4:9", "finite and above 0, found `0.0`", "beta is positive"),
        (with_beta("[10.0, inf]"), "4:15", "finite and above 0", "large beta"),
        (with_beta("[1e400]"), "4:9", "double precision, found `1e400`", "at most 1.79"),
        (with_f("[-1]"), "2:6", "finite and at least 0, found `-1`", "elastic"),
        (with_f("[inf]"), "2:6", "finite and at least 0", "elastic"),
        // Ranges.
        (with_alpha("{ from = 1.0, to = 2.0 }"), "3:9", "[axes.alpha] needs `points`", "points = 41"),
        (with_alpha("{ from = 1.0, to = 2.0, points = 1 }"), "3:42", "from 2 to", "whole number"),
        (with_alpha("{ from = 1.0, to = 2.0, points = 2.5 }"), "3:42", "whole number", "decimal point"),
        (with_alpha("{ from = 1.0, to = 2.0, points = 100000000000 }"), "3:42", "to 1000000, found", "whole number"),
        (with_alpha("{ from = 2.0, to = 1.0, points = 3 }"), "3:28", "above `axes.alpha.from` = 2.0", "swap"),
        (with_alpha("{ from = 1.0, to = 1.0, points = 3 }"), "3:28", "above `axes.alpha.from`", "single value"),
        (
            with_alpha("{ from = 0.0, to = 1.0, points = 3, scale = \"log\" }"),
            "3:18",
            "above 0 on a log",
            "begin above 0",
        ),
        (with_alpha("{ from = 1.0, to = inf, points = 3 }"), "3:28", "must be finite", "end of a list"),
        (with_alpha("{ from = -1.0, to = 1.0, points = 3 }"), "3:18", "at least 0", "positive"),
        (
            with_alpha("{ from = 1.0, to = 2.0, points = 3, scale = \"lin\" }"),
            "3:53",
            "\"linear\" or \"log\"",
            "\"linear\"?",
        ),
        (
            with_beta("{ from = 1.0, to = 1.0000000000000002, points = 9 }"),
            "4:8",
            "9 points of `axes.beta` are not distinct",
            "fewer points",
        ),
        (
            "[axes]\nf = { from = 1, to = 2, points = 1001 }\nalpha = { from = 1, to = 2, points = 1000 }\n\
             beta = { from = 1, to = 2, points = 1000 }\n"
                .into(),
            "1:1",
            "at most 1000000000 cases, this one has 1001 f x 1000 alpha x 1000 beta",
            "fewer points",
        ),
        // Bodies.
        (with_axes("[flat]\n[substrate]\n"), "5:1", "two names of one section", "keep one"),
        (with_axes("[flat]\nrigid = true\n"), "6:9", "`flat.rigid` goes with [laboratory]", "remove it"),
        (with_axes("[roller]\nmodes = []\n"), "5:1", "at least one retardation mode", "that they add up to 1"),
        (
            with_axes(
                "[flat]\nmodes = [{ share = 0.6, time = 1.0 }]\n[roller]\nmodes = [{ share = 0.5, time = 1.0 }]\n",
            ),
            "7:1",
            "must add up to 1",
            "those of flat and roller together",
        ),
        (
            with_axes("[roller]\nrelaxation = [{ fraction = 0.5, time = 1.0 }]\n"),
            "6:14",
            "beside [roller] goes with [laboratory]",
            "`modes` of both bodies",
        ),
        (with_body("[roller]\n"), "10:1", "[roller] needs `poisson_ratio`", "poisson_ratio = 0.5"),
        (with_body("[roller]\npoisson_ratio = 0.5\n"), "10:1", "needs a modulus", "leave the section out"),
        (with_body("[roller]\npoisson_ratio = 0.6\n"), "11:17", "from 0 to 0.5", "soft solids"),
        (
            with_body("[roller]\npoisson_ratio = 0.5\nrelaxed_modulus = 1e6\nf = 1.0\n"),
            "10:1",
            "needs `retardation_time`",
            "20 ms",
        ),
        (
            with_body("[roller]\npoisson_ratio = 0.5\nrelaxed_modulus = 1e6\nmodes = [{ share = 1.0, time = 1.0 }]\n"),
            "10:1",
            "needs `f` beside `modes`",
            "f = E0/Einf - 1",
        ),
        (with_body("[roller]\nrigid = true\nf = 1.0\n"), "12:5", "says nothing of a rigid body", "remove it"),
        (with_body("[flat]\nrigid = true\n"), "10:1", "both bodies are rigid", "give [roller] a modulus"),
        (
            with_body("[flat]\nrigid = true\n[roller]\npoisson_ratio = 0.5\nrelaxed_modulus = 1e6\n"),
            "4:19",
            "says nothing of a rigid flat",
            "remove it",
        ),
        (with_speeds("speed = 1.0\nswap = true"), "9:8", "needs `slide_roll_ratio`", "entrainment_speed"),
        (
            with_speeds("entrainment_speed = 1.0\nslide_roll_ratio = [-1.0, 1.0]\nswap = true"),
            "9:20",
            "opposite ones are added",
            "below 0",
        ),
        (with_axes("slide_roll = [-1.0, 1.0]\n"), "5:14", "at rest in the contact", "alpha = [inf]"),
        (
            with_alpha("[inf]").replace("beta", "slide_roll = [-1.0, 0.0]\nbeta")
                + "[roller]\nmodes = [{ share = 1.0, time = 1.0 }]\n",
            "4:14",
            "at slide_roll = -1 the flat is at rest and the soft roller alone moves",
            "slide_roll_ratio = -2",
        ),
        (with_axes("slide_roll = [1.5]\n"), "5:15", "from -1 to 1", "pure rolling"),
        // Substrate.
        (with_axes("[substrate]\nmodes = []\n"), "6:9", "at least one retardation mode", "leave [substrate] out"),
        (
            with_axes("[substrate]\nmodes = [{ share = 0.5, time = 1.0 }, { share = 0.4, time = 2.0 }]\n"),
            "6:9",
            "add up to 1, not 0.9",
            "scale the shares",
        ),
        (
            with_axes("[substrate]\nmodes = [{ share = 0.0, time = 1.0 }]\n"),
            "6:20",
            "above 0 and at most 1",
            "leave out",
        ),
        (
            with_axes("[substrate]\nmodes = [{ share = 1.0, time = 0.0 }]\n"),
            "6:32",
            "finite and above 0",
            "as in 100.0",
        ),
        (with_axes("[substrate]\nmodes = [{ share = 1.0 }]\n"), "6:10", "needs `time`", "time = 1.0"),
        // Solver.
        (
            with_axes("[solver]\nmethod = \"newton\"\n"),
            "6:10",
            "\"collocation\" or \"relaxation\"",
            "write \"collocation\"",
        ),
        (with_axes("[solver]\ndegree = 8\n"), "6:1", "`degree`", "remove the key"),
        (with_axes("[solver]\ntolerance = 0.2\n"), "6:13", "from 1e-10 to 1e-1, found `0.2`", "as in 1e-5"),
        (with_axes("[solver]\ntolerance = 9e-11\n"), "6:13", "from 1e-10 to 1e-1, found", "relative error"),
        (with_axes("[solver]\ntolerance = 0\n"), "6:13", "from 1e-10 to 1e-1", "relative error"),
        (with_axes("[solver]\ntolerance = nan\n"), "6:13", "from 1e-10 to 1e-1", "[solver.relaxation]"),
        (with_axes("[solver]\ntolerance = \"small\"\n"), "6:13", "must be a number", "without quotes"),
        (with_axes("[solver]\ntime_limit = 0.0\n"), "6:14", "must be above 0, found `0.0`", "inf is no limit"),
        (with_axes("[solver]\ntime_limit = nan\n"), "6:14", "must be above 0", "seconds"),
        (with_axes("[solver]\ntime_limit = \"10 min\"\n"), "6:14", "must be a number", "without quotes"),
        (with_axes("[solver.relaxation]\npoints = 800\n"), "6:10", "an odd number", "halves the grid"),
        (with_axes("[solver.relaxation]\npoints = 49\n"), "6:10", "from 51 to 20001, found `49`", "whole number"),
        (with_axes("[solver.relaxation]\npoints = 401.0\n"), "6:10", "whole number", "decimal point"),
        (with_axes("[solver.relaxation]\ntolerance = 1e-13\n"), "6:13", "from 1e-12 to 1e-2", "1e-8"),
        (
            with_axes("[solver.relaxation]\nacceleration = \"andersen\"\n"),
            "6:16",
            "\"anderson\" or \"none\"",
            "\"anderson\"?",
        ),
        (with_axes("[solver.relaxation]\nestimate = 1\n"), "6:12", "true or false", "without quotes"),
        (
            with_axes("[solver.relaxation]\npoints = 199\nestimate = true\n"),
            "7:12",
            "needs at least 201 points",
            "estimate = false",
        ),
        (with_axes("[solver.relaxation]\ndomain = \"wide\"\n"), "6:10", "\"auto\" or [x_min, x_max]", "[-3.0, 4.0]"),
        (with_axes("[solver.relaxation]\ndomain = [-3.0]\n"), "6:10", "\"auto\" or [x_min, x_max]", "both ends"),
        (with_axes("[solver.relaxation]\ndomain = [0.5, 4.0]\n"), "6:11", "below 0", "on both sides"),
        (
            with_axes("[solver.relaxation]\ndomain = [-3.0, inf]\n"),
            "6:17",
            "above 0 and at most 100.0",
            "on both sides",
        ),
        // Output.
        (
            with_axes("[output]\nfields = [\"presure\"]\n"),
            "6:11",
            "\"shear_traction\" or \"hysteresis_traction\"",
            "\"pressure\"?",
        ),
        (with_axes("[output]\nfields = [\"pressure\", \"pressure\"]\n"), "6:23", "only once", "remove one"),
        (with_axes("[output]\nx = { from = 3.0, to = -3.0, points = 601 }\n"), "6:24", "must be above", "swap"),
        (with_axes("[output]\nx = { from = -3.0, to = 3.0, points = 10002 }\n"), "6:39", "to 10001", "whole number"),
        (with_axes("[output]\nx = [0.0, inf]\n"), "6:11", "must be finite", "a0"),
        (
            with_axes("[output]\nsensitivities = true\n[solver]\nmethod = \"relaxation\"\n"),
            "6:17",
            "needs the collocation method",
            "sensitivities = false",
        ),
        (with_axes("[output]\nfield_precision = \"half\"\n"), "6:19", "\"double\" or \"single\"", "write"),
        (
            with_axes("[output]\nfield_precision = \"single\"\n[solver]\ntolerance = 9e-8\n"),
            "6:19",
            "from a tolerance of 1e-7 on, and `solver.tolerance` is 9e-8",
            "field_precision = \"double\", or tolerance = 1e-7",
        ),
        (with_axes("[output]\ncavity_shear = \"ful\"\n"), "6:16", "\"full\", \"streamers\" or \"none\"", "\"full\"?"),
        ("title = \"two\\nlines\"\n".to_owned() + AXES, "1:9", "one line", "file's name"),
        // Quantities of the laboratory.
        (with_laboratory("viscosity", "\"5.1 Pa\""), "6:13", "must be a viscosity, in Pa s", "\"5.1 Pa s\" or 5.1"),
        (with_laboratory("viscosity", "\"5.1 Pa\""), "6:13", "`laboratory.viscosity`", "(in Pa s)"),
        (with_laboratory("load", "\"119 N\""), "3:8", "must be a load per length, in N/m", "\"119 N/m\""),
        (with_laboratory("speed", "[\"1 mm\", 1.0]"), "8:10", "must be a speed, in m/s", "\"1 mm/s\""),
        (with_laboratory("radius", "\"wide\""), "2:10", "a number with a unit", "\"2 mm\" or 2e-3"),
        (with_laboratory("radius", "\"2\""), "2:10", "a number with a unit", "stands without quotes"),
        (with_laboratory("radius", "\"-2 mm\""), "2:10", "must be finite and above 0", "with its unit in quotes"),
        (with_laboratory("radius", "0.0"), "2:10", "must be finite and above 0", "SI units"),
        (with_laboratory("poisson_ratio", "0.6"), "5:17", "must be from 0 to 0.5", "0.5 is usual"),
        (with_speeds("speed = 1.0\nflat_speed = 1.0"), "9:14", "two ways to say", "give `speed`"),
        (with_speeds("roller_speed = -1.0\nflat_speed = 1.0"), "8:16", "at least 0", "enters from both sides"),
        (with_speeds("roller_speed = 0.0\nflat_speed = 0.0"), "9:14", "nothing drives a film", "begin one of the two"),
        (
            with_speeds("entrainment_speed = 1.0\nslide_roll_ratio = 50.0"),
            "9:20",
            "from -2 to 2",
            "In per cent write \"50 %\"",
        ),
        (with_speeds("entrainment_speed = 1.0"), "1:1", "needs `slide_roll_ratio`", "slide_roll_ratio = 0.5"),
        (with_laboratory("speed", "[2.0, 1.0]"), "8:15", "must ascend", "sort the list"),
        (
            with_laboratory("radius", "[0.002, 0.003]").replace("[0.01, 0.1]", "[\"1 rpm\", \"10 rpm\"]"),
            "8:10",
            "in turns, which one radius makes a speed, but this sweep has several",
            "give one `radius`, or the speed in m/s",
        ),
        (with_speeds("entrainment_speed = \"1 rpm\"\nslide_roll_ratio = 1.0"), "8:21", "must be a speed", "\"1 mm/s\""),
        (with_laboratory("speed", "\"-1 rpm\""), "8:9", "finite and above 0", "SI units"),
        (with_laboratory("speed", "[]"), "8:9", "at least one value", "[100.0]"),
        (
            with_laboratory("relaxed_modulus", "1.0\ninstantaneous_modulus = 2.0"),
            "5:25",
            "`relaxed_modulus` or `instantaneous_modulus`, not both",
            "remove one",
        ),
        (
            with_laboratory("f", "1.0\n[axes]\nf = [1.0]\n"),
            "9:5",
            "in [laboratory] or in [axes], not in both",
            "remove one",
        ),
        (
            with_laboratory("f", "1.0\n[axes]\nalpha = [1.0]\n"),
            "11:9",
            "`axes.alpha` may not stand beside [laboratory]",
            "an axis of [laboratory]",
        ),
        ("[laboratory]\nspeed = 1.0\n".into(), "1:1", "[laboratory] needs `f`", "add f = 10.0"),
        ("[laboratory]\nf = 1.0\n".into(), "1:1", "[laboratory] needs `radius`", "radius = \"2 mm\""),
        (with_axes("speed = [1.0]\n"), "5:1", "`speed` is not a key of [axes]", "key of [laboratory]: move it there"),
        // Materials.
        (
            with_axes("[substrate]\nrelaxation = []\nmodes = []\n"),
            "6:14",
            "`modes` or `relaxation`, not both",
            "remove one",
        ),
        (
            with_axes("[substrate]\nrelaxation = [{ modulus = 1e6, time = 1.0 }]\n"),
            "5:1",
            "needs a modulus beside `relaxation`",
            "relaxed_modulus = ",
        ),
        (
            with_axes("[substrate]\nrelaxation = [{ fraction = 0.6, time = 1.0 }, { fraction = 0.4, time = 2.0 }]\n"),
            "6:14",
            "must leave a relaxed modulus above 0",
            "what flows at last is no substrate",
        ),
        (
            with_axes("[substrate]\nrelaxation = [{ fraction = 0.6, time = 1.0 }, { modulus = 0.4, time = 2.0 }]\n"),
            "6:14",
            "all of them the same",
            "fractions of the instantaneous modulus",
        ),
        (
            with_axes("[substrate]\nrelaxed_modulus = 1e6\nrelaxation = [{ modulus = 1e6, time = \"1 m\" }]\n"),
            "7:39",
            "must be a time, in s",
            "\"20 ms\" or 0.02",
        ),
        (
            with_axes("[substrate]\nrelaxation = [{ fraction = 1.5, time = 1.0 }]\n"),
            "6:28",
            "above 0 and below 1",
            "g_i",
        ),
        (
            with_axes("[substrate]\nrelaxed_modulus = 1e6\n"),
            "6:19",
            "goes with `relaxation`",
            "in [laboratory]: move it",
        ),
        (
            with_axes("[substrate]\nrelaxed_modulus = 1e6\nrelaxation = [{ time = 1.0 }]\n"),
            "7:15",
            "a term has `modulus` or `fraction`",
            "relaxation = [",
        ),
        (
            with_axes("[substrate]\nshear_modulus = 1e6\n"),
            "6:17",
            "`substrate.shear_modulus` does not say which modulus it is",
            "three times where Poisson's ratio is 0.5",
        ),
        (
            with_laboratory("relaxed_modulus", "1e5\nshear_modulus = 1e5"),
            "5:17",
            "`laboratory.shear_modulus` does not say which modulus it is",
            "relaxed_shear_modulus or instantaneous_shear_modulus",
        ),
        (
            with_laboratory("relaxed_modulus", "1e5\nrelaxed_shear_modulus = 1e5"),
            "5:25",
            "`relaxed_modulus` or `relaxed_shear_modulus`, not both",
            "remove one",
        ),
        (
            with_laboratory("poisson_ratio", "[0.4, 0.5]").replace("relaxed_modulus", "relaxed_shear_modulus"),
            "5:17",
            "beside a shear modulus `laboratory.poisson_ratio` must be one number",
            "would change along this axis",
        ),
    ]
}
