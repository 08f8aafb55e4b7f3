//! `stribeck explain`: why a case is as it is.

use std::fmt::Write;
use std::path::PathBuf;

use clap::Args;

use super::collection::{Collection, Held, sweep_file};
use super::destination::read_sweep;
use super::repeat::solve_command;
use super::shell::quoted;
use super::solution::numbers;
use super::way::{seed_in_words, way};
use super::wording::{count, duration, moment};
use super::workload::{inspection, stale_reason};
use super::{CliError, Exit, console};
use stribeck_input::shown;
use stribeck_solver::{COLUMNS, Parameters, SolvedCase, Solver, shortest};
use stribeck_sweep::CaseId;
use stribeck_sweep::store::{CaseEntry, Holdings, Status};
use stribeck_sweep::{Grid, Method, Plan, Sweep};

const IN_MEMORY: &str = "writing to memory does not fail";

#[derive(Clone, Debug, Args)]
#[command(after_help = "\
Examples:
  stribeck explain results/quick 100,1,1000             the place of the sweep nearest to these f, alpha and beta
  stribeck explain results/quick 4f0c2b9e61d3a785       by the id in the column `case` of summary.csv
  stribeck explain results/quick 100,1,1000 --stored    what is stored only; nothing is solved

Shows where a case stands in the sweep, what is stored of it and how it came there. Then its chain is solved again up to
it, on one thread, to show how it was reached: every point on the way with its residuals and estimated errors, and
whether the numbers are still the same. The directory is only read, also while a run works there.")]
pub struct Arguments {
    /// A results directory
    #[arg(value_name = "DIR")]
    directory: PathBuf,
    /// A case: its id, or its place as F,ALPHA,BETA
    #[arg(value_name = "CASE", value_parser = wanted, allow_hyphen_values = true)]
    case: Wanted,
    /// Tell what is stored; solve nothing again
    #[arg(long)]
    stored: bool,
}

/// How a case is named.
#[derive(Clone, Copy, Debug)]
enum Wanted {
    Id(CaseId),
    /// f, α, β.
    Near([f64; 3]),
}

fn wanted(text: &str) -> Result<Wanted, String> {
    if let Ok(id) = text.parse() {
        return Ok(Wanted::Id(id));
    }
    let numbers: Option<Vec<f64>> = text.split(',').map(|number| number.trim().parse().ok()).collect();
    match numbers.as_deref() {
        Some(&[f, alpha, beta]) if [f, alpha, beta].iter().all(|number| *number >= 0.0) => {
            Ok(Wanted::Near([f, alpha, beta]))
        }
        _ => Err("give the id of a case (16 hexadecimal digits, as in the column `case` of summary.csv), or f, alpha and beta \
                  with commas between them, as in 100,1,1000"
            .to_owned()),
    }
}

/// A case of the sweep: its first place on the axes f, α, β.
struct Found<'a> {
    sweep: &'a Sweep,
    plan: &'a Plan,
    place: [usize; 3],
    parameters: Parameters,
    id: CaseId,
}

pub fn execute(arguments: &Arguments) -> Result<Exit, CliError> {
    let sweep = read_sweep(&sweep_file(&arguments.directory)?)?;
    let plan = Plan::new(&sweep);
    let mut collection = Collection::read(&arguments.directory, &sweep.output, inspection(false))?;
    if collection.is_empty() {
        collection.whole = Some(Holdings::read(&arguments.directory, &sweep.output, inspection(false))?);
    }
    let all = collection.held();
    let found = match arguments.case {
        Wanted::Near(numbers) => Some(nearest(&sweep, numbers)),
        Wanted::Id(id) => plan.find(id).map(|(i_f, i_alpha, i_beta)| [i_f, i_alpha, i_beta]),
    };
    let found = found.map(|place @ [i_f, i_alpha, i_beta]| {
        let parameters = plan.parameters_at(i_f, i_alpha, i_beta);
        Found { sweep: &sweep, plan: &plan, place, id: plan.id(&parameters), parameters }
    });
    let id = match (&found, arguments.case) {
        (Some(found), _) => found.id,
        (None, Wanted::Id(id)) if all.holder(id).is_some() => id,
        (None, _) => return Err(CliError::NoSuchCase { directory: arguments.directory.clone() }),
    };
    for warning in all.all().iter().flat_map(|held| held.warnings()) {
        console::tell(&format!("warning: {warning}"));
    }
    let held = all.holder(id).unwrap_or(all.all()[0]);
    let entry = held.entry(id)?;
    let mut text = heading(id, entry.as_ref(), held);
    match &found {
        Some(found) => text += &found.place_in_words(),
        None => text += "  it has no place in the present sweep.toml, so its f, alpha and beta are not known here\n",
    }
    text += &stored(id, entry.as_ref(), found.as_ref(), held, &all)?;
    console::print(&text)?;
    if let (Some(found), Some(entry)) = (&found, &entry) {
        if !arguments.stored {
            console::print(&found.solved_again(entry))?;
        }
        let mut text = String::from("\nto solve it again\n");
        writeln!(text, "  alone          {}", solve_command(plan.recipe(), &found.parameters)).expect(IN_MEMORY);
        let directory = quoted(arguments.directory.as_os_str());
        writeln!(text, "  in its chain   stribeck explain {directory} {id}").expect(IN_MEMORY);
        console::print(&text)?;
    }
    Ok(Exit::Success)
}

/// The place whose f, α and β are nearest by their ratios, f first, then α, then β.
fn nearest(sweep: &Sweep, wanted: [f64; 3]) -> [usize; 3] {
    // These are magnitudes; the ends, 0 and infinity, are near to themselves alone.
    let distance = |value: f64, wanted: f64| if value == wanted { 0.0 } else { (value.ln() - wanted.ln()).abs() };
    let [strengths, rows, length] = sweep.grid.shape();
    match &sweep.grid {
        Grid::Dimensionless(axes) => {
            let near = |axis: &[f64], wanted| {
                let by_distance =
                    |a: &usize, b: &usize| distance(axis[*a], wanted).total_cmp(&distance(axis[*b], wanted));
                (0..axis.len()).min_by(by_distance).expect("an axis has values")
            };
            [near(&axes.f, wanted[0]), near(&axes.alpha, wanted[1]), near(&axes.beta, wanted[2])]
        }
        Grid::Laboratory(_) => {
            // α and β change together: f comes first, then both.
            let places = (0..strengths * rows * length)
                .map(|place| [place / (rows * length), place / length % rows, place % length]);
            let distances = |place: [usize; 3]| {
                let [f, alpha, beta] = sweep.grid.numbers(place);
                (distance(f, wanted[0]), distance(alpha, wanted[1]).hypot(distance(beta, wanted[2])))
            };
            let key = |a: &(f64, f64), b: &(f64, f64)| a.0.total_cmp(&b.0).then(a.1.total_cmp(&b.1));
            places.min_by(|a, b| key(&distances(*a), &distances(*b))).expect("a sweep has places")
        }
    }
}

fn heading(id: CaseId, entry: Option<&CaseEntry>, held: &Holdings) -> String {
    match entry {
        Some(entry) if held.holds(id).is_none() => {
            format!("case {id}: {}, but stored without {}\n", entry.outcome.name(), held.lacks(id).join(", "))
        }
        Some(entry) => format!("case {id}: {}\n", entry.outcome.name()),
        None => format!("case {id}: not solved yet\n"),
    }
}

/// What is stored of a case, and how it came there.
fn stored(
    id: CaseId,
    entry: Option<&CaseEntry>,
    found: Option<&Found<'_>>,
    held: &Holdings,
    all: &Held<'_>,
) -> Result<String, CliError> {
    let mut text = "\n".to_owned();
    let mut line = |name: &str, words: &str| writeln!(text, "{name:<10} {words}").expect(IN_MEMORY);
    let (Some(entry), Some(origin)) = (entry, held.origin(id)?) else {
        let next = match held.owner()? {
            Some(owner) => format!("a run works here ({owner})"),
            None => "`stribeck run` solves it".to_owned(),
        };
        line("to do", &next);
        let stale = found.and_then(|found| stale_reason(found.sweep, found.plan, all, &found.parameters));
        if let Some(why) = stale {
            line("stale", &format!("it is stored, but {why}"));
        }
        return Ok(text);
    };
    if entry.outcome == Status::Failed {
        line("reason", &entry.reason);
    }
    line("stored", &format!("{}, row {}, as its record says", shown(&origin.shard), origin.row));
    line("solved", &format!("in start {}, before {}", origin.start, moment(origin.time)));
    if !origin.recipe.is_null() {
        line("with", &recipe_in_words(&origin.recipe));
    }
    let timing = &entry.timing;
    line("seed", &format!("{}: {}", timing.seed, seed_in_words(&timing.seed)));
    let factorisations = match timing.factorisations {
        0 => String::new(),
        number => format!("{}, ", count(number, "factorisation")),
    };
    let iterations = count(timing.iterations, "iteration");
    line("cost", &format!("{iterations}, {factorisations}{}", duration(timing.seconds)));
    if let Some(limit) = timing.time_limit {
        line("time limit", &format!("given up at {} s", shortest(limit)));
    }
    Ok(text + "\n" + &numbers(entry))
}

/// The keys and values of a recipe.
fn recipe_in_words(recipe: &serde_json::Value) -> String {
    let pairs = recipe.as_object().into_iter().flatten();
    let words = |(key, value): (&String, &serde_json::Value)| {
        let value = value.as_f64().map_or_else(|| value.to_string().replace('"', ""), shortest);
        format!("{key} {value}")
    };
    pairs.map(words).collect::<Vec<_>>().join(", ")
}

impl Found<'_> {
    fn place_in_words(&self) -> String {
        let [f, alpha, beta] = self.sweep.grid.numbers(self.place).map(shortest);
        let experiment = self.sweep.grid.experiment(self.place).map_or_else(String::new, |experiment| {
            let given = experiment.given().map(|quantity| {
                let value = shortest(experiment.value(quantity));
                format!("{} = {value} {}", quantity.name(), quantity.units().trim_start_matches('1'))
                    .trim_end()
                    .to_owned()
            });
            format!("  {}\n", given.collect::<Vec<_>>().join(", "))
        });
        let same = match self.parameters.is_relaxed_elastic() {
            true => ", solved once for all places of this beta whose substrate is elastic (f = 0 or alpha = inf)",
            false => "",
        };
        let (chain, number) = self.chain();
        let betas = |case: Option<&Parameters>| case.map_or_else(String::new, |case| shortest(case.beta));
        format!(
            "{experiment}  f = {f}, alpha = {alpha}, beta = {beta}{same}\n  number {number} of the {} of its chain, beta from {} to {}\n",
            chain.len(),
            betas(chain.first()),
            betas(chain.last()),
        )
    }

    /// The cases of the chain that this one is in, and its number among them, from 1.
    fn chain(&self) -> (Vec<Parameters>, usize) {
        let in_chain = |chain: &Vec<Parameters>| chain.iter().position(|case| *case == self.parameters);
        let chains = self.plan.chains().map(|chain| self.plan.parameters(&chain));
        let found = chains.into_iter().find_map(|chain| in_chain(&chain).map(|place| (chain, place + 1)));
        found.expect("every case of a plan is in a chain")
    }

    /// The way to the case, by solving its chain again, and whether it leads to what is stored.
    fn solved_again(&self, entry: &CaseEntry) -> String {
        let (chain, number) = self.chain();
        let solver = Solver::new(&self.sweep.solver_settings());
        let Some(case) = solver.trace_last(&chain[..number]) else { return String::new() };
        let before = match number - 1 {
            0 => "it is the first of its chain".to_owned(),
            others => format!("after the {others} before it in its chain"),
        };
        let same = self.comparison(entry, &case);
        let residual = match self.sweep.solver.method {
            Method::Collocation => "step over solution",
            Method::Relaxation => "residual",
        };
        format!("\nsolved again, {before}: {same}\n{}", way(&case, residual))
    }

    /// Whether a case that is solved again is what is stored.
    fn comparison(&self, entry: &CaseEntry, case: &SolvedCase) -> String {
        let solution = match (&case.outcome, entry.outcome) {
            (Ok(_), Status::Failed) => return "it converges now".to_owned(),
            (Err(failure), Status::Converged) => return format!("it fails now: {failure}"),
            (Err(_), Status::Failed) => return "it fails again".to_owned(),
            (Ok(solution), Status::Converged) => solution,
        };
        let row = solution.quantities.row(&solution.errors, &case.limits);
        // Limits may not have been asked for when it was stored.
        let same = |(a, b): (&f64, &f64)| a.to_bits() == b.to_bits() || a.is_nan() || b.is_nan();
        if row.iter().zip(&entry.values).all(same) {
            return "the same numbers to the last bit".to_owned();
        }
        let mut differences = Vec::new();
        for name in ["mu_v", "mu_h", "c"] {
            let place = COLUMNS.iter().position(|column| column.name == name).expect("a column");
            differences.push(format!("{name} by {:.0e}", (row[place] / entry.values[place] - 1.0).abs()));
        }
        format!(
            "other numbers than those stored ({} of themselves), as after an extension of the sweep, where it had another \
             chain, or on another machine",
            differences.join(", ")
        )
    }
}
