//! A study as Markdown.

use std::collections::BTreeMap;

use super::reference::{Errors, settings};
use super::{Reference, Row, Start, Study};
use crate::format::count;
use crate::pictures::Format;
use stribeck_charts::geometric_median;
use stribeck_solver::shortest;

/// Failed cases that are listed for each variant.
const LISTED: usize = 5;

/// Names of the quantities of [`Row::errors`] in a text.
const NAMES: [&str; 4] = ["μ_v", "μ_h", "c", "u_min"];

/// The tables of a study, with references to pictures by their names and their format.
pub fn markdown(study: &Study, rows: &[Row], (pictures, format): (&[&str], Format)) -> String {
    let mut text = format!("# {}\n\n", study.title);
    let mut write = |line: String| text.push_str(&(line + "\n"));
    write(introduction(study, rows));
    if study.measure.error {
        write(format!("## Error against run time\n\n{}", error_table(study, rows)));
    }
    if study.measure.stability {
        write(format!("## Stability\n\n{}", stability_table(study, rows)));
    }
    let failures = failures(study, rows);
    if !failures.is_empty() {
        write(format!("## Failures\n\n{failures}"));
    }
    if !pictures.is_empty() {
        write("## Pictures\n".to_owned());
        for name in pictures {
            let mark = if format == Format::Pdf { "" } else { "!" };
            write(format!("{mark}[{name}]({name}.{})\n", format.extension()));
        }
    }
    text.truncate(text.trim_end().len());
    text + "\n"
}

fn introduction(study: &Study, rows: &[Row]) -> String {
    let start = match study.start {
        Start::Alone => "each case alone, from its own first guess",
        Start::Chain => "each case seeded by those of smaller β with the same α and f",
    };
    let references: BTreeMap<usize, &Result<Reference, String>> =
        rows.iter().map(|row| (row.case, &row.reference)).collect();
    let known: Vec<(f64, f64)> = references
        .values()
        .filter_map(|reference| reference.as_ref().ok())
        .map(|reference| (reference.tolerance, reference.error()))
        .collect();
    let degree = settings(&study.variants).degree;
    let missing = references.len() - known.len();
    let tightest = known.iter().map(|(tolerance, _)| *tolerance).fold(f64::INFINITY, f64::min);
    let looser = known.iter().filter(|(tolerance, _)| *tolerance > tightest).count();
    let worst = known.iter().map(|(_, error)| *error).fold(0.0, f64::max);
    let (cases, variants) = (count(references.len() as u64, "case"), count(study.variants.len() as u64, "setting"));
    let mut text = format!("{cases}, {variants}; {start}. ");
    if !known.is_empty() {
        text += &format!(
            "Errors are relative, against collocation solutions with panels of degree {degree} and a tolerance of \
             {tightest:e}"
        );
        if looser > 0 {
            text += &format!(" (looser in {}, where that cannot be reached)", count(looser as u64, "case"));
        }
        text += &format!(
            "; the largest of their own estimated errors is {worst:.0e}, and smaller errors than that of its \
             reference are left out. "
        );
    }
    if missing > 0 {
        text += &format!("{} without a reference. ", count(missing as u64, "case"));
    }
    text.truncate(text.trim_end().len());
    text + "\n"
}

/// A text that breaks no table.
fn cell(text: &str) -> String {
    text.replace('|', "\\|")
}

/// The rows of one variant.
fn of(rows: &[Row], variant: usize) -> impl Iterator<Item = &Row> + Clone {
    rows.iter().filter(move |row| row.variant == variant)
}

/// Median, as in the pictures, and largest of some numbers; a dash if there are none.
fn spread(numbers: impl Iterator<Item = f64>) -> [String; 2] {
    let numbers: Vec<f64> = numbers.collect();
    let largest = numbers.iter().copied().reduce(f64::max);
    [geometric_median(numbers), largest].map(|number| number.map_or("–".to_owned(), short))
}

/// Two digits.
fn short(number: f64) -> String {
    match number.abs() {
        0.0 => "0".to_owned(),
        magnitude if (0.1..1e4).contains(&magnitude) => {
            format!("{number:.1e}").parse::<f64>().expect("a number").to_string()
        }
        _ => format!("{number:.1e}"),
    }
}

fn error_table(study: &Study, rows: &[Row]) -> String {
    let mut header =
        "| method | setting | solved | seconds, median | largest | largest of failed | unknowns | iterations | MB |"
            .to_owned();
    for name in NAMES {
        header += &format!(" {name}, median | worst |");
    }
    let mut text = format!("{header}\n|{}\n", " --- |".repeat(9 + 2 * NAMES.len()));
    for (j, variant) in study.variants.iter().enumerate() {
        let rows = of(rows, j);
        let solved = rows.clone().filter(|row| row.failure.is_none());
        let [seconds, longest] = spread(solved.clone().filter_map(|row| Some(row.cost?.seconds)));
        let failed = rows.clone().filter(|row| row.failure.is_some());
        let [_, given_up] = spread(failed.filter_map(|row| Some(row.cost?.seconds)));
        let [unknowns, _] = spread(solved.clone().filter_map(|row| Some(row.unknowns? as f64)));
        let [iterations, _] = spread(solved.clone().map(|row| row.iterations as f64));
        let [_, memory] = spread(rows.clone().filter_map(|row| Some(row.cost?.peak_bytes as f64 / 1e6)));
        let (count, all) = (solved.clone().count(), rows.clone().count());
        let (method, setting) = (cell(&variant.method), variant.setting.words());
        let mut line = format!(
            "| {method} | {setting} | {count} of {all} | {seconds} | {longest} | {given_up} | {unknowns} | \
             {iterations} | {memory} |"
        );
        for quantity in 0..Errors::QUANTITIES.len() {
            let [middle, worst] = spread(rows.clone().filter_map(|row| row.errors[quantity]));
            line += &format!(" {middle} | {worst} |");
        }
        text += &(line + "\n");
    }
    text + "\nMedians are of solved cases; MB are the most in use at once for any case.\n"
}

fn stability_table(study: &Study, rows: &[Row]) -> String {
    let mut text =
        "| method | setting | converged | iterations, median | most | least p over largest | load residual, \
                    worst | condition, median | worst | estimated error, worst | error, worst | other seed: failed | \
                    disagree | difference, worst |\n"
            .to_owned();
    text += &format!("|{}\n", " --- |".repeat(14));
    for (j, variant) in study.variants.iter().enumerate() {
        let rows = of(rows, j);
        let stable = |row: &'_ Row| row.stability.clone();
        let converged = rows.clone().filter(|row| row.failure.is_none()).count();
        let [iterations, most] = spread(rows.clone().map(|row| row.iterations as f64));
        let least = rows.clone().filter_map(|row| stable(row)?.pressure_min).fold(0.0, f64::min);
        let [_, load] = spread(rows.clone().filter_map(|row| stable(row)?.load_residual));
        let [condition, worst_condition] = spread(rows.clone().filter_map(|row| stable(row)?.condition));
        let [_, estimated] = spread(rows.clone().filter_map(|row| stable(row)?.estimated_error));
        let [_, error] = spread(rows.clone().filter_map(|row| row.largest_error()));
        let other_failed =
            |row: &&Row| row.failure.is_none() && stable(row).is_some_and(|found| found.other_failure.is_some());
        let failed = rows.clone().filter(other_failed).count();
        let disagree = rows.clone().filter(|row| stable(row).is_some_and(|found| found.seeds_agree == Some(false)));
        let disagree = disagree.count();
        let [_, difference] = spread(rows.clone().filter_map(|row| stable(row)?.seed_difference));
        let all = rows.clone().count();
        let (method, setting, least) = (cell(&variant.method), variant.setting.words(), short(least));
        text += &format!(
            "| {method} | {setting} | {converged} of {all} | {iterations} | {most} | {least} | {load} | {condition} | \
             {worst_condition} | {estimated} | {error} | {failed} | {disagree} | {difference} |\n"
        );
    }
    text + "\nThe other seed is the solution at twice the β, or half of it where that fails; counted are cases \
            that converge only without it. Two solutions disagree if μ_v, μ_h or c differ by more than two \
            tolerances (collocation), their estimated errors (fixed panels), or 10⁴ residuals (relaxation).\n"
}

/// The failed cases of each variant, alike ones together.
fn failures(study: &Study, rows: &[Row]) -> String {
    let mut text = String::new();
    for (j, variant) in study.variants.iter().enumerate() {
        let failed: Vec<(&Row, &String)> = of(rows, j).filter_map(|row| Some((row, row.failure.as_ref()?))).collect();
        if failed.is_empty() {
            continue;
        }
        text += &format!("{}, {}: {} failed\n\n", variant.method, variant.setting.words(), failed.len());
        for (row, reason) in failed.iter().take(LISTED) {
            let case = &study.cases[row.case];
            let [alpha, beta, f] = [case.alpha, case.beta, case.f].map(shortest);
            text += &format!("- case {}, α = {alpha}, β = {beta}, f = {f}: {reason}\n", row.case + 1);
        }
        if failed.len() > LISTED {
            text += &format!("- and {} more, in `study.csv`\n", failed.len() - LISTED);
        }
        text.push('\n');
    }
    text
}
