//! What a sweep costs beside its solver: plan, engine, store and publication, with a solver that takes a given time.
//!
//! ```text
//! cargo run --release -p stribeck-sweep --example store_throughput -- \
//!     [--cases 100000] [--beta 1000] [--chain 64] [--threads 2]
//!                                                   [--queue 16] [--microseconds 0] [--directory DIR]
//! ```
//!
//! A solved case is made up and costs `--microseconds` of computing. Without `--directory` a temporary one is used and
//! removed. Seconds are wall clock; "cpu" is what all threads used, that of the solver included. The highest memory is
//! that of the process up to the end of the stage, as Linux tells it.

use std::error::Error;
use std::fs;
use std::hint::black_box;
use std::num::NonZeroUsize;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use stribeck_solver::continuation::{Effort, Interrupt, Interrupted, Seed, Solution, SolvedCase};
use stribeck_solver::{Fields, Friction, Limits, Parameters, Quantities, RelativeErrors};
use stribeck_sweep::engine::{Engine, Finished};
use stribeck_sweep::store::{CaseEntry, Ending, Point, Publication, Status, Store, StoreError, Timing};
use stribeck_sweep::{Chain, GridIndex, Plan, Sweep, Values};

struct Options {
    cases: usize,
    beta: usize,
    chain: usize,
    queue: usize,
    threads: NonZeroUsize,
    microseconds: u64,
    directory: Option<PathBuf>,
}

impl Options {
    fn parse() -> Result<Self, Box<dyn Error>> {
        let threads = NonZeroUsize::new(2).expect("2 is not 0");
        let mut options =
            Self { cases: 100_000, beta: 1000, chain: 64, queue: 16, threads, microseconds: 0, directory: None };
        let mut arguments = std::env::args().skip(1);
        while let Some(name) = arguments.next() {
            let value = arguments.next().ok_or_else(|| format!("{name} needs a value"))?;
            match name.as_str() {
                "--cases" => options.cases = value.parse()?,
                "--beta" => options.beta = value.parse()?,
                "--chain" => options.chain = value.parse()?,
                "--queue" => options.queue = value.parse()?,
                "--threads" => options.threads = value.parse()?,
                "--microseconds" => options.microseconds = value.parse()?,
                "--directory" => options.directory = Some(value.into()),
                _ => return Err(format!("unknown option {name}").into()),
            }
        }
        if options.beta < 2 || options.chain == 0 || options.cases < 2 * options.beta {
            return Err("needs at least two values of beta, two rows and chains of one case".into());
        }
        Ok(options)
    }

    /// A sweep of about as many cases as wanted.
    fn sweep(&self) -> Result<Sweep, Box<dyn Error>> {
        let text = format!(
            "[axes]\nalpha = {{ from = 1e-3, to = 1e3, points = {}, scale = \"log\" }}\n\
             beta = {{ from = 10.0, to = 1e4, points = {}, scale = \"log\" }}\nf = [100.0]\n\
             [output]\nfields = []\n",
            self.cases / self.beta,
            self.beta,
        );
        Ok(Sweep::parse("store_throughput", &text)?)
    }
}

/// Keeps a processor busy.
fn compute(steps: u64) {
    let sum: f64 = (0..steps).map(|step| black_box(step as f64).sqrt()).sum();
    black_box(sum);
}

/// Steps of [`compute`] in a microsecond of an otherwise idle processor: the best of a few tries.
fn steps_per_microsecond() -> f64 {
    const STEPS: u64 = 20_000_000;
    let tries = (0..5).map(|_| {
        let start = Instant::now();
        compute(black_box(STEPS));
        STEPS as f64 / start.elapsed().as_secs_f64() / 1e6
    });
    tries.fold(0.0, f64::max)
}

/// A made-up solution; smooth, with all digits in use as those of a real one.
fn solved(parameters: &Parameters, steps: u64) -> SolvedCase {
    let start = Instant::now();
    let Parameters { alpha, beta, f, .. } = *parameters;
    let mu_v = f.ln_1p() * alpha / (1.0 + alpha * alpha);
    let film = 0.4458 * beta.powf(-0.6);
    compute(steps);
    let friction = Friction {
        viscoelastic: mu_v,
        viscoelastic_roller: 0.0,
        hydrodynamic_film: film.sqrt() / 3.0,
        hydrodynamic_cavity: film / 7.0,
        pressure: -film / 5.0,
        drag: mu_v + film.sqrt(),
    };
    let quantities = Quantities {
        friction,
        c: film,
        film_min: 0.796 * film,
        p_max: 1.0 + film / 3.0,
        x_p_max: -film / 11.0,
        x_outlet: -1.0 - film,
        centroid: mu_v / 13.0,
        dissipation: film / 5.0,
        separation: 0.5 + film,
        load_residual: film * 1e-12,
    };
    let errors = RelativeErrors {
        mu_v: film * 1e-6,
        mu_h: film * 2e-6,
        c: film * 3e-6,
        drag: film * 4e-6,
        pressure: film * 5e-6,
        shear: film * 6e-6,
        film_min: film * 7e-6,
        p_max: film * 8e-6,
    };
    SolvedCase {
        outcome: Ok(Solution {
            quantities,
            errors,
            fields: Fields::default(),
            sensitivities: None,
            sensitivity_errors: None,
        }),
        limits: Limits { dry_mu_v: mu_v * 1.01, approx_mu_h: film.sqrt() / 2.9 },
        seed: Seed::Hertz,
        path: stribeck_solver::continuation::Path::default(),
        trace: stribeck_solver::continuation::Trace::default(),
        effort: Effort {
            iterations: 5,
            factorisations: 3,
            seconds: start.elapsed().as_secs_f64(),
            ..Effort::default()
        },
    }
}

fn entry(plan: &Plan, parameters: &Parameters, case: SolvedCase) -> CaseEntry {
    let Effort { iterations, factorisations, seconds, .. } = case.effort;
    let solution = case.outcome.expect("made-up cases converge");
    CaseEntry {
        id: plan.id(parameters),
        outcome: Status::Converged,
        reason: String::new(),
        failure_kind: None,
        values: Values::converged(&solution.quantities, &solution.errors, &case.limits),
        fields: solution.fields,
        sensitivities: solution.sensitivities,
        sensitivity_errors: solution.sensitivity_errors,
        timing: Timing { seconds, iterations, factorisations, seed: Some(case.seed), time_limit: None },
    }
}

/// The chains of a sweep, as long as wanted.
fn chains(plan: &Plan, beta: usize, length: usize) -> Vec<Chain> {
    let pieces = beta.div_ceil(length);
    let cut = |piece: usize| piece * beta / pieces;
    (0..plan.rows())
        .flat_map(|row| (0..pieces).map(move |piece| Chain { row, cases: cut(piece)..cut(piece + 1) }))
        .collect()
}

fn publish(sweep: &Sweep, plan: &Plan, store: &mut Store) -> Result<bool, StoreError> {
    let point = |place: GridIndex| Point::new(plan.case_at(place), sweep.grid.numbers(place));
    let row = |row: usize| sweep.grid.shape().row(row).map(point).collect();
    let dimensions = sweep.grid.dimensions();
    let published = store.publish(&Publication {
        title: &sweep.title,
        sweep_text: &sweep.text,
        method: "made up",
        tolerance: 1e-5,
        partial: false,
        dimensions: &dimensions,
        row: &row,
    })?;
    Ok(published.rewritten)
}

/// Cases of the plan that the store does not hold.
fn missing(plan: &Plan, chains: &[Chain], store: &Store) -> usize {
    chains.iter().flat_map(|chain| plan.ids(chain)).filter(|id| store.holds(*id).is_none()).count()
}

/// Prints a line for each stage.
struct Clock {
    cases: f64,
    start: Instant,
    cpu: f64,
}

impl Clock {
    fn new(cases: usize) -> Self {
        println!("{:<30}{:>9}{:>9}{:>12}{:>12}{:>9}", "stage", "s", "cpu s", "us/case", "cpu us/case", "peak MB");
        Self { cases: cases as f64, start: Instant::now(), cpu: cpu_seconds() }
    }

    fn stage(&mut self, name: &str) -> f64 {
        let (seconds, cpu) = (self.start.elapsed().as_secs_f64(), cpu_seconds() - self.cpu);
        self.line(name, seconds, Some(cpu));
        (self.start, self.cpu) = (Instant::now(), cpu_seconds());
        seconds
    }

    fn line(&self, name: &str, seconds: f64, cpu: Option<f64>) {
        let each = |seconds: f64| format!("{:.2}", seconds / self.cases * 1e6);
        let (cpu, cpu_each) = (cpu.map_or(String::new(), |cpu| format!("{cpu:.2}")), cpu.map_or(String::new(), each));
        println!("{name:<30}{seconds:>9.2}{cpu:>9}{:>12}{cpu_each:>12}{:>9.0}", each(seconds), peak_megabytes());
    }
}

/// User and system time of all threads so far.
fn cpu_seconds() -> f64 {
    // Nanoseconds on a processor are the first number of each thread's `schedstat`; those of ended threads are lost
    // there. So the ticks of the whole process are taken, of which Linux has a hundred a second.
    let stat = fs::read_to_string("/proc/self/stat").unwrap_or_default();
    let after_name = stat.rsplit(')').next().unwrap_or_default();
    let ticks = |place: usize| after_name.split_whitespace().nth(place).and_then(|text| text.parse::<f64>().ok());
    match (ticks(11), ticks(12)) {
        (Some(user), Some(system)) => (user + system) / 100.0,
        _ => f64::NAN,
    }
}

/// Highest resident memory so far; NaN where there is no `/proc`.
fn peak_megabytes() -> f64 {
    let status = fs::read_to_string("/proc/self/status").unwrap_or_default();
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"));
    line.and_then(|line| line.split_whitespace().next()?.parse::<f64>().ok()).map_or(f64::NAN, |kb| kb / 1024.0)
}

/// Files and bytes under a directory.
fn size(directory: &Path) -> std::io::Result<(u64, u64)> {
    let (mut files, mut bytes) = (0, 0);
    for entry in fs::read_dir(directory)? {
        let metadata = entry?.metadata()?;
        if metadata.is_file() {
            files += 1;
            bytes += metadata.len();
        }
    }
    Ok((files, bytes))
}

fn main() -> Result<(), Box<dyn Error>> {
    let options = Options::parse()?;
    let sweep = options.sweep()?;
    let temporary = tempfile::tempdir()?;
    let directory = options.directory.clone().unwrap_or_else(|| temporary.path().to_owned());
    let steps = match options.microseconds {
        0 => 0,
        microseconds => (microseconds as f64 * steps_per_microsecond()) as u64,
    };

    let whole = Instant::now();
    let plan = Plan::new(&sweep);
    let cases = plan.cases();
    let mut clock = Clock::new(cases);
    let mut store = Store::open(&directory, &sweep.text, &sweep)?;
    let chains = chains(&plan, options.beta, options.chain);
    if missing(&plan, &chains, &store) != cases {
        return Err("the directory holds cases already".into());
    }
    clock.stage("open, survey");

    store.begin("throughput", cases as u64, options.threads.get() as u64)?;
    let engine = Engine::new(options.threads)?.with_queue(options.queue);
    let (mut commits, mut committing) = (0, Duration::ZERO);
    engine.run(
        &chains,
        &Interrupt::new(),
        |chain, _| -> Result<_, Interrupted> {
            Ok(plan.parameters(chain).iter().map(|parameters| solved(parameters, steps)).collect())
        },
        |_, message| panic!("{message}"),
        |group| -> Result<(), StoreError> {
            let start = Instant::now();
            commits += 1;
            let mut entries = Vec::new();
            for Finished { chain, cases, .. } in group {
                let parameters = plan.parameters(chain);
                entries.extend(parameters.iter().zip(cases).map(|(parameters, case)| entry(&plan, parameters, case)));
            }
            store.commit(&entries)?;
            committing += start.elapsed();
            Ok(())
        },
    )?;
    store.end(Ending::Completed)?;
    let solving = clock.stage("solve, commit");
    clock.line("  of it the writer", committing.as_secs_f64(), None);
    publish(&sweep, &plan, &mut store)?;
    clock.stage("publish");
    let seconds = whole.elapsed().as_secs_f64();

    drop(store);
    let mut store = Store::open(&directory, &sweep.text, &sweep)?;
    if missing(&plan, &chains, &store) != 0 || publish(&sweep, &plan, &mut store)? {
        return Err("a second run found something to do".into());
    }
    clock.stage("run again: nothing to do");

    println!(
        "\n{cases} cases in {} chains and {commits} commits, {:.0} cases a second end to end",
        chains.len(),
        cases as f64 / seconds
    );
    if options.microseconds > 0 {
        let share = options.microseconds as f64 * 1e-6 * cases as f64 / options.threads.get() as f64 / solving;
        println!("solver threads at work for {:.1} % of the time of the stage in which they run", 100.0 * share);
    }
    for (name, (files, bytes)) in [
        ("shards", size(&directory.join("shards"))?),
        ("log", size(&directory.join("log"))?),
        ("published, sweep.toml", size(&directory)?),
    ] {
        println!(
            "{name:<24}{files:>7} files{:>9.1} MB{:>8.0} bytes a case",
            bytes as f64 / 1e6,
            bytes as f64 / cases as f64
        );
    }
    Ok(())
}
