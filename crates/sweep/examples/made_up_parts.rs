//! Parts of a large sweep whose results are made up, to measure what planning, merging and publishing cost without a
//! solver.
//!
//! ```text
//! cargo run --release -p stribeck-sweep --example made_up_parts -- --cases 10000000 --parts 1000 --directory DIR
//! ```
//!
//! Writes `DIR/sweep.toml` and the parts below `DIR/results/parts`, as `stribeck run DIR/sweep.toml -o DIR/results
//! --part I/N` would have left them; then `stribeck merge DIR/results` and the other commands find a sweep that is
//! solved.

use std::error::Error;
use std::fs;
use std::path::PathBuf;
use std::time::Instant;

use stribeck_solver::continuation::Seed;
use stribeck_solver::{Fields, Parameters};
use stribeck_sweep::store::{CaseEntry, Ending, Status, Store, Timing};
use stribeck_sweep::{Part, Plan, Sweep, Values};

/// Cases of a commit, as the engine makes them of quick cases in a part of many.
const COMMIT: usize = 4096;

/// Values of β: with 64 cases in a chain the last one of each row is a short one.
const BETAS: usize = 1000;

struct Options {
    cases: usize,
    parts: u32,
    directory: PathBuf,
}

fn options() -> Result<Options, Box<dyn Error>> {
    let (mut cases, mut parts, mut directory) = (100_000, 10, None);
    let mut arguments = std::env::args().skip(1);
    while let Some(name) = arguments.next() {
        let value = arguments.next().ok_or_else(|| format!("{name} needs a value"))?;
        match name.as_str() {
            "--cases" => cases = value.parse()?,
            "--parts" => parts = value.parse()?,
            "--directory" => directory = Some(PathBuf::from(value)),
            _ => return Err(format!("unknown option {name}").into()),
        }
    }
    let directory = directory.ok_or("give --directory DIR, where there is room for some hundred bytes a case")?;
    if cases < 2 * BETAS || Part::new(1, parts).is_none() {
        return Err(format!("needs at least {} cases and one part", 2 * BETAS).into());
    }
    Ok(Options { cases, parts, directory })
}

/// Smooth numbers with all digits in use, as those of a real case.
fn made_up(plan: &Plan, case: &Parameters) -> CaseEntry {
    let seed = case.alpha.ln() + case.beta.ln() / 3.0;
    CaseEntry {
        id: plan.id(case),
        outcome: Status::Converged,
        reason: String::new(),
        failure_kind: None,
        values: Values(std::array::from_fn(|column| (seed + column as f64).sin())),
        fields: Fields::default(),
        sensitivities: None,
        sensitivity_errors: None,
        timing: Timing {
            seconds: 1e-4 * (1.0 + seed.cos().abs()),
            iterations: 3,
            factorisations: 2,
            seed: Some(Seed::Predictor),
            time_limit: None,
        },
    }
}

fn main() -> Result<(), Box<dyn Error>> {
    let Options { cases, parts, directory } = options()?;
    let text = format!(
        "title = \"Made up\"\n[axes]\nalpha = {{ from = 1e-3, to = 1e3, points = {}, scale = \"log\" }}\n\
         beta = {{ from = 10.0, to = 1e4, points = {BETAS}, scale = \"log\" }}\nf = [100.0]\n[output]\nfields = []\n",
        cases / BETAS,
    );
    fs::create_dir_all(&directory)?;
    fs::write(directory.join("sweep.toml"), &text)?;
    let sweep = Sweep::parse("sweep", &text)?;
    let start = Instant::now();
    let plan = Plan::new(&sweep);
    let recipe = serde_json::to_value(plan.recipe())?;
    let split = plan.split(parts);
    println!("{} chains split into {parts} parts in {:.2} s", split.len(), start.elapsed().as_secs_f64());
    let mut chains = vec![Vec::new(); parts as usize];
    for (index, part) in split.into_iter().enumerate() {
        chains[part.number() as usize - 1].push(index);
    }
    let start = Instant::now();
    for (part, chains) in Part::all(parts).zip(chains) {
        let home = directory.join("results/parts").join(part.name());
        let mut store = Store::open(&home, &sweep.text, &sweep)?.solving_with(recipe.clone());
        store.begin(&sweep.name, chains.len() as u64, 1)?;
        let mut entries: Vec<CaseEntry> = Vec::new();
        for index in chains {
            entries.extend(plan.parameters(&plan.chain(index)).iter().map(|case| made_up(&plan, case)));
            if entries.len() >= COMMIT {
                store.commit(&std::mem::take(&mut entries))?;
            }
        }
        store.commit(&entries)?;
        store.end(Ending::Completed)?;
    }
    println!("{} cases made up and committed in {:.1} s", plan.cases(), start.elapsed().as_secs_f64());
    Ok(())
}
