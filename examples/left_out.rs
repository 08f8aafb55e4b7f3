//! What leaving out saves: seconds and bytes of sweeps with one thing on or off, as Markdown tables.
//!
//! ```text
//! cargo build --release
//! cargo run --release --example left_out -- [--repeats 5]
//! ```
//!
//! Runs the program itself, one thread, into temporary directories. Seconds are those of the processor (user and
//! system, from Linux's `/proc`), medians of runs in turn; ratios are to the first row of a table. Bytes are per grid
//! point.

use std::error::Error;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

/// 61 × 61 viscoelastic cases, and how they are solved in all tables but that of the relaxation solver.
const AXES: &str = "[axes]\nalpha = { from = 1e-3, to = 1e3, points = 61, scale = \"log\" }\nf = [100.0]\n";
const BETA: &str = "beta = { from = 10.0, to = 1e4, points = 61, scale = \"log\" }\n";
const NUMBERS: &str = "[output]\nfields = []\nlimits = false\ncavity_shear = \"none\"\n";

/// A sweep of a table.
struct Entry {
    name: &'static str,
    sweep: String,
    /// How often the program has run the sweep into the same directory before it is measured.
    earlier_runs: usize,
}

/// What was measured of one run.
struct Run {
    seconds: f64,
    points: usize,
    solved: usize,
    /// Of shards, log, results.h5 and summary.csv.
    bytes: [u64; 4],
}

fn entry(name: &'static str, sections: &[&str]) -> Entry {
    Entry { name, sweep: sections.concat(), earlier_runs: 0 }
}

fn outputs() -> Vec<Entry> {
    let sweep = |name, output| entry(name, &[AXES, BETA, "[output]\n", output]);
    vec![
        sweep("three fields, limits, full cavity", "fields = [\"pressure\", \"film_thickness\", \"displacement\"]\n"),
        sweep("two fields: no `displacement`", "fields = [\"pressure\", \"film_thickness\"]\n"),
        sweep("one field: `pressure`", "fields = [\"pressure\"]\n"),
        sweep("`fields = []`", "fields = []\n"),
        sweep("`fields = []`, `limits = false`", "fields = []\nlimits = false\n"),
        sweep("`fields = []`, `cavity_shear = \"none\"`", "fields = []\ncavity_shear = \"none\"\n"),
        entry("numbers alone: all three left out", &[AXES, BETA, NUMBERS]),
    ]
}

fn substrates() -> Vec<Entry> {
    let modes = |times: &[f64]| {
        let share = 1.0 / times.len() as f64;
        let modes: Vec<String> = times.iter().map(|time| format!("{{ share = {share}, time = {time} }}")).collect();
        format!("[substrate]\nmodes = [{}]\n", modes.join(", "))
    };
    let instantaneous = "[axes]\nalpha = [0.0]\nf = { from = 1.0, to = 1e3, points = 61, scale = \"log\" }\n";
    let elastic = AXES.replace("[100.0]", "[0.0]");
    vec![
        entry("four retardation times", &[AXES, BETA, &modes(&[1.0, 0.1, 0.01, 0.001]), NUMBERS]),
        entry("two", &[AXES, BETA, &modes(&[1.0, 0.1]), NUMBERS]),
        entry("one", &[AXES, BETA, NUMBERS]),
        entry("none: α = 0, 61 values of f", &[instantaneous, BETA, NUMBERS]),
        entry("none, and one problem at every α: f = 0", &[&elastic, BETA, NUMBERS]),
    ]
}

fn repeated() -> Vec<Entry> {
    let again = |name, earlier_runs| Entry { name, sweep: [AXES, BETA, NUMBERS].concat(), earlier_runs };
    vec![again("run for the first time", 0), again("run again", 1)]
}

fn relaxation() -> Vec<Entry> {
    let axes = "[axes]\nalpha = [1.0, 10.0, 100.0]\nf = [10.0]\nbeta = [10.0, 30.0, 100.0]\n";
    let solver = |more: &str| format!("[solver]\nmethod = \"relaxation\"\n[solver.relaxation]\npoints = 401\n{more}");
    vec![
        entry("`estimate = true`", &[axes, &solver("estimate = true\n"), NUMBERS]),
        entry("`estimate = false`, the default", &[axes, &solver(""), NUMBERS]),
        entry("and elastic: f = 0", &[&axes.replace("[10.0]", "[0.0]"), &solver(""), NUMBERS]),
    ]
}

/// Processor seconds of the children that have ended so far.
fn child_seconds() -> Result<f64, Box<dyn Error>> {
    let stat = fs::read_to_string("/proc/self/stat")?;
    let after_name = stat.rsplit(')').next().ok_or("no name in /proc/self/stat")?;
    let ticks: Vec<f64> = after_name.split_whitespace().skip(13).take(2).map(str::parse).collect::<Result<_, _>>()?;
    // Linux counts a hundred ticks a second
    Ok(ticks.iter().sum::<f64>() / 100.0)
}

/// Bytes of a file, or of the files in a directory.
fn size(path: &Path) -> std::io::Result<u64> {
    if path.is_file() {
        return Ok(fs::metadata(path)?.len());
    }
    fs::read_dir(path)?.map(|entry| Ok(entry?.metadata()?.len())).sum()
}

/// Runs the program on a sweep file.
fn stribeck(program: &Path, sweep: &Path, results: &Path) -> Result<String, Box<dyn Error>> {
    let output = Command::new(program)
        .arg("run")
        .args([sweep, Path::new("-o"), results])
        .args(["--threads", "1", "--quiet"])
        .output()?;
    if !output.status.success() {
        return Err(format!("{} failed: {}", sweep.display(), String::from_utf8_lossy(&output.stderr)).into());
    }
    Ok(String::from_utf8(output.stdout)?)
}

fn measure(program: &Path, entry: &Entry) -> Result<Run, Box<dyn Error>> {
    let directory = tempfile::tempdir()?;
    let (sweep, results) = (directory.path().join("sweep.toml"), directory.path().join("results"));
    fs::write(&sweep, &entry.sweep)?;
    for _ in 0..entry.earlier_runs {
        stribeck(program, &sweep, &results)?;
    }
    let before = child_seconds()?;
    let summary = stribeck(program, &sweep, &results)?;
    let seconds = child_seconds()? - before;
    let solved = summary.lines().find_map(|line| line.strip_prefix("solved ")?.split_whitespace().next());
    let bytes = ["shards", "log", "results.h5", "summary.csv"].map(|name| size(&results.join(name)));
    let [shards, log, data, table] = bytes;
    Ok(Run {
        seconds,
        points: fs::read_to_string(results.join("summary.csv"))?.lines().count() - 1,
        solved: solved.map_or(Ok(0), str::parse)?,
        bytes: [shards?, log?, data?, table?],
    })
}

fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}

fn print_table(program: &Path, title: &str, entries: &[Entry], repeats: usize) -> Result<(), Box<dyn Error>> {
    let mut seconds = vec![Vec::new(); entries.len()];
    let mut runs = Vec::new();
    for repeat in 0..repeats {
        for (entry, seconds) in entries.iter().zip(&mut seconds) {
            let run = measure(program, entry)?;
            seconds.push(run.seconds);
            if repeat == 0 {
                runs.push(run);
            }
        }
    }
    let seconds: Vec<f64> = seconds.into_iter().map(median).collect();
    println!(
        "| {title} | grid points | solved | seconds (1.00 = {:.2} s) | shards | log | results.h5 | summary.csv |",
        seconds[0]
    );
    println!("| --- | --- | --- | --- | --- | --- | --- | --- |");
    for ((entry, run), time) in entries.iter().zip(&runs).zip(&seconds) {
        let bytes = run.bytes.map(|bytes| format!("{:.0}", bytes as f64 / run.points as f64)).join(" | ");
        let ratio = time / seconds[0];
        let ratio = if ratio < 0.005 { "< 0.01".into() } else { format!("{ratio:.2}") };
        println!("| {} | {} | {} | {ratio} | {bytes} |", entry.name, run.points, run.solved);
    }
    println!();
    Ok(())
}

/// The program, which Cargo has put beside the directory of the examples.
fn program() -> Result<PathBuf, Box<dyn Error>> {
    let examples = std::env::current_exe()?;
    let target = examples.parent().and_then(Path::parent).ok_or("an example without a directory")?;
    let program = target.join("stribeck").with_extension(std::env::consts::EXE_EXTENSION);
    if program.is_file() {
        Ok(program)
    } else {
        Err(format!("{} is not there; run `cargo build --release` first", program.display()).into())
    }
}

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let repeats: usize = match arguments.as_slice() {
        [] => 5,
        [name, value] if name == "--repeats" => value.parse()?,
        _ => return Err("the only option is --repeats N".into()),
    };
    if repeats == 0 {
        return Err("--repeats must be at least 1".into());
    }
    let program = program()?;
    let tables =
        [("output", outputs()), ("substrate", substrates()), ("sweep", repeated()), ("relaxation", relaxation())];
    for (title, entries) in &tables {
        print_table(&program, title, entries, repeats)?;
    }
    Ok(())
}
