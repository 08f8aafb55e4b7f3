//! The pages of `docs/reference/` that are made from the program: its commands, and the columns of results.
//!
//! The committed pages must be what is made here. `STRIBECK_WRITE_DOCS=1` in the environment of the tests writes them.

use std::fmt::Write;
use std::fs;
use std::path::Path;

use clap::{Arg, ArgAction, Command};
use stribeck::commands::{GROUPS, command_line};
use stribeck_lab::{Experiment, LaboratoryQuantity, Scales};
use stribeck_sweep::{Axes, Column, Field, Grid, Note, Unit};

/// The command that makes the pages again.
const MAKE: &str = "STRIBECK_WRITE_DOCS=1 cargo test --release --workspace --test program -- reference_pages";

/// Compares a page with its file, or writes that.
fn check(name: &str, page: &str) {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/reference").join(name);
    if std::env::var_os("STRIBECK_WRITE_DOCS").is_some() {
        fs::write(&file, page).expect("written");
    }
    let there = fs::read_to_string(&file).unwrap_or_default();
    let (made, kept) = (page.lines(), there.lines().chain(std::iter::repeat("")));
    let differs = made.zip(kept).position(|(made, kept)| made != kept).map_or(0, |line| line + 1);
    assert!(
        there == page,
        "docs/reference/{name} is not what the program says (line {differs}); make it again with\n    {MAKE}"
    );
}

/// A text of help in Markdown, without what Markdown would take for something else, and with links to pages.
fn escaped(text: &str) -> String {
    // What stands in backticks stays.
    let parts = text.split('`').enumerate().map(|(place, part)| match place % 2 {
        0 => linked(&part.replace('<', "\\<").replace('*', "\\*").replace('|', "\\|")),
        _ => format!("`{}`", part.replace('|', "\\|")),
    });
    parts.collect()
}

/// The same with a link in place of each page that is named by its path.
fn linked(text: &str) -> String {
    let Some((before, rest)) = text.split_once("docs/") else { return text.to_owned() };
    let (page, after) = rest.split_once(".md").expect("a page is named whole");
    let file = format!("docs/{page}.md");
    assert!(Path::new(env!("CARGO_MANIFEST_DIR")).join(&file).exists(), "{file} is named in help and not there");
    let name = page.rsplit('/').next().unwrap_or(page);
    let path = page.strip_prefix("reference/").map_or_else(|| format!("../{page}"), str::to_owned);
    format!("{before}[{name}]({path}.md){}", linked(after))
}

/// The examples of a help text as lines of a shell, their comments behind a #.
fn examples(help: &str) -> String {
    let lines = help.trim_start_matches("Examples:\n").lines().map(|line| {
        let line = line.strip_prefix("  ").unwrap_or(line);
        let begins = line.len() - line.trim_start().len();
        let (command, comment) = line[begins..].split_once("  ").unwrap_or((&line[begins..], ""));
        let command = format!("{}{command}", &line[..begins]);
        match comment.trim() {
            "" => command,
            comment => format!("{command:<56}  # {comment}"),
        }
    });
    // The test `examples` runs them, in the order in which one needs what another made.
    format!("```sh,no-run\n{}\n```\n", lines.collect::<Vec<_>>().join("\n"))
}

/// What stands below the options in help: paragraphs, and lines that are indented.
fn notes(help: &str) -> String {
    let is_block = |line: &&str| line.starts_with("  ");
    let lines: Vec<&str> = help.lines().collect();
    let mut parts = Vec::new();
    for run in lines.chunk_by(|one, next| is_block(one) == is_block(next) && !one.is_empty() && !next.is_empty()) {
        match run[0] {
            "" => {}
            first if is_block(&first) => {
                let inner: Vec<&str> = run.iter().map(|line| &line[2..]).collect();
                parts.push(format!("```text\n{}\n```\n", inner.join("\n")));
            }
            _ => parts.push(filled(&escaped(&run.join(" ")))),
        }
    }
    parts.join("\n")
}

/// A paragraph in lines of at most 120 characters.
fn filled(text: &str) -> String {
    let mut lines = vec![String::new()];
    for word in text.split_whitespace() {
        let line = lines.last_mut().expect("one line at least");
        match line.is_empty() {
            true => line.push_str(word),
            false if line.chars().count() + 1 + word.chars().count() <= 120 => *line += &format!(" {word}"),
            false => lines.push(word.to_owned()),
        }
    }
    lines.join("\n") + "\n"
}

/// The row of an option or an argument.
fn row(argument: &Arg) -> String {
    let takes_value = matches!(argument.get_action(), ArgAction::Set | ArgAction::Append);
    let names = argument.get_value_names().unwrap_or_default();
    let value = names.iter().map(|name| name.to_string()).collect::<Vec<_>>().join(" ");
    let mut name = match (argument.get_short(), argument.get_long()) {
        (None, None) => format!("`{value}`"),
        (Some(short), Some(long)) => format!("`-{short}`, `--{long}"),
        (None, Some(long)) => format!("`--{long}"),
        (Some(short), None) => format!("`-{short}"),
    };
    if !argument.is_positional() {
        name += &if takes_value { format!(" {value}`") } else { "`".to_owned() };
    }
    let mut help = escaped(&argument.get_help().map(ToString::to_string).unwrap_or_default().replace('\n', " "));
    let values: Vec<String> = argument
        .get_possible_values()
        .into_iter()
        .filter(|_| takes_value && argument.get_long() != Some("estimate"))
        .map(|value| format!("`{}`", value.get_name()))
        .collect();
    if !values.is_empty() {
        let _ = write!(help, ": {}", values.join(", "));
    }
    let defaults: Vec<_> = argument.get_default_values().iter().map(|value| value.to_string_lossy()).collect();
    if takes_value && !defaults.is_empty() {
        let _ = write!(help, " [default: {}]", defaults.join(","));
    }
    format!("| {} | {help} |\n", name.replace('|', "\\|"))
}

fn command_section(command: &Command) -> String {
    let name = command.get_name();
    let about = command.get_about().expect("it says what it does");
    let mut usage = command.clone().bin_name(format!("stribeck {name}"));
    let usage = usage.render_usage().to_string().replace("Usage: ", "");
    let help = |text: Option<&clap::builder::StyledStr>| text.map(ToString::to_string).unwrap_or_default();
    let mut text = format!("### stribeck {name}\n\n{}.\n\n", escaped(&about.to_string()));
    text += &examples(&help(command.get_before_help()));
    let usage: Vec<&str> = usage.lines().map(str::trim).collect();
    let _ = write!(text, "\n```text\n{}\n```\n", usage.join("\n"));
    // Help and version are options of every command.
    let is_own = |argument: &&Arg| !matches!(argument.get_id().as_str(), "help" | "version");
    let (positional, options): (Vec<&Arg>, Vec<&Arg>) =
        command.get_arguments().filter(is_own).partition(|argument| argument.is_positional());
    if !(positional.is_empty() && options.is_empty()) {
        text += "\n| argument or option | what it is |\n| --- | --- |\n";
        text.extend(positional.into_iter().chain(options).map(row));
    }
    match help(command.get_after_help()) {
        notes_of if notes_of.is_empty() => text + "\n",
        notes_of => format!("{text}\n{}\n", notes(&notes_of)),
    }
}

#[test]
fn commands_are_documented_as_help_has_them() {
    let mut all = command_line();
    all.build();
    let mut page =
        "# Commands\n\n*Reference.* Every command of `stribeck` with its usage, options and examples; `stribeck \
                    COMMAND --help` says the\nsame in the terminal. This page is made from the program.\n\n"
            .to_owned();
    page += &examples(&all.get_before_help().expect("it has examples").to_string());
    page += "\nThe examples run in the order of this page, in a directory with the shipped `sweeps/` and `docs/`.\n\n";
    page += "| group | commands |\n| --- | --- |\n";
    for (group, names) in GROUPS {
        let links: Vec<String> = names.iter().map(|name| format!("[{name}](#stribeck-{name})")).collect();
        let _ = writeln!(page, "| {group} | {} |", links.join(", "));
    }
    page += "\n| exit code | meaning |\n| --- | --- |\n";
    for (code, meaning) in [
        ("0", "all is well; all cases converged"),
        ("1", "`evaluate --check` found an error above the tolerance"),
        ("2", "bad input: a file, an option, a value"),
        ("3", "done, but some cases failed, or points lie outside of a surface"),
        ("4", "the disk or a file"),
        ("5", "a time limit ended `fit`: the best values so far, or nothing"),
        ("130", "interrupted; the same command resumes"),
    ] {
        let _ = writeln!(page, "| {code} | {meaning} |");
    }
    for (group, names) in GROUPS {
        let _ = write!(page, "\n## {group}\n\n");
        let sections = names.iter().map(|name| command_section(all.find_subcommand(name).expect(name)));
        page += sections.map(|section| section.trim_end().to_owned()).collect::<Vec<_>>().join("\n\n").as_str();
        page.push('\n');
    }
    check("commands.md", &page);
}

/// The units of a column in a table: over what it is, and in what it is in a sweep of the laboratory.
fn units(scale: &'static str) -> String {
    let over = Unit::of(scale, false).scale.map_or("–".to_owned(), |scale| format!("`{scale}`"));
    format!("{over} | `{}`", Unit::of(scale, true).units)
}

#[test]
fn columns_are_documented_as_they_are_declared() {
    let mut page = "# Columns\n\n*Reference.* Every number in `results.h5`, `summary.csv` and `timings.csv`: name, \
                    meaning and unit. This page is made\nfrom the program; [output.md](output.md) tells how the files are \
                    laid out.\n\n\
                    A dimensionless number is *over* a scale: multiply it by that. a0 is the contact half-width of the \
                    relaxed dry contact,\nR the radius, N the load per length. Sweeps with `[laboratory]` are in SI units \
                    instead. NaN in `results.h5`, and an\nempty field in a table, is a number that is not known.\n\n\
                    ## Where a case stands\n\n| name | what it is | unit |\n| --- | --- | --- |\n\
                    | `case` | id of the case, 16 hexadecimal digits: a text | – |\n"
        .to_owned();
    let axes = Axes { slide_roll: Some(vec![1.0]), f: vec![1.0], alpha: vec![1.0], beta: vec![1.0] };
    let place = |name: &str, what: &str, units: &str| format!("| `{name}` | {what} | `{units}` |\n");
    for dimension in Grid::Dimensionless(axes).dimensions() {
        page += &place(&dimension.name, &dimension.long_name, &dimension.units);
    }
    page += &place("x", Field::X_LONG_NAME, Field::X_UNITS);
    page += "| `status` | `converged` or `failed` | – |\n| `reason` | why the case failed, in one line | – |\n";
    let masks: Vec<String> = Note::ALL.map(|note| format!("{} `{}`", note.mask(), note.name())).into();
    let _ =
        writeln!(page, "| `notes` | {}, by bits: {}; in `results.h5` alone | – |", Note::LONG_NAME, masks.join(", "));
    page += "\n`slide_roll` is there where the sweep has that axis, `x` where it keeps fields.\n\n\
             ## Numbers of a case\n\n| name | what it is | over | in SI | where |\n| --- | --- | --- | --- | --- |\n";
    for column in Column::ALL {
        let place = if column.in_summary() { "`summary.csv`, `results.h5`" } else { "`results.h5`" };
        let _ =
            writeln!(page, "| `{}` | {} | {} | {place} |", column.name(), column.long_name(), units(column.units()));
    }
    page += "\n`dry_mu_v` and `approx_mu_h` are there with `output.limits`, and of failed cases too.\n\n\
             ## Fields along x\n\n| name | what it is | over | in SI |\n| --- | --- | --- | --- |\n";
    for field in Field::ALL {
        let _ = writeln!(page, "| `{}` | {} | {} |", field.name(), field.long_name(), units(field.units()));
    }
    page += "\nThey are in `results.h5`, those that `output.fields` names.\n\n\
             ## Quantities of the laboratory\n\n| name | what it is | unit |\n| --- | --- | --- |\n";
    for quantity in LaboratoryQuantity::ALL {
        page += &place(quantity.name(), quantity.long_name(), quantity.units());
    }
    for (name, unit, what) in Scales::VARIABLES.into_iter().chain(Experiment::AT_TEMPERATURE) {
        page += &place(name, what, unit);
    }
    page += "\nA sweep with `[laboratory]` has those that it gives, and `a0` to `friction_scale`. With a `temperature` it has the last\n\
             two, and `viscosity` and `retardation_time` are those at the reference of their laws.\n\n\
             ## More columns of some sweeps\n\n| name | what it is | when |\n| --- | --- | --- |\n";
    for column in stribeck_sweep::store::further_columns(
        None,
        &stribeck_solver::Output { sensitivities: true, ..stribeck_solver::Output::default() },
    ) {
        let _ = writeln!(page, "| `{}` | {} | `output.sensitivities` |", column.name, column.long_name);
    }
    for average in stribeck_sweep::store::AVERAGES {
        let (name, what) = (average.name, average.long_name());
        let _ = writeln!(page, "| `{name}` | {what} | `laboratory.swap` |");
    }
    page += "\nOver quantities of the laboratory the sensitivities are those to f and to each of these.\n\n\
             ## timings.csv\n\n| name | what it is | unit |\n| --- | --- | --- |\n";
    for (name, what, unit) in [
        ("seconds", "wall-clock time of the case on its thread, failed attempts included", "s"),
        ("iterations", "Newton iterations (collocation) or passes (relaxation), on the way to the case too", "1"),
        ("factorisations", "matrix factorisations; 0 with the relaxation method", "1"),
    ] {
        page += &place(name, what, unit);
    }
    page += "| `seed` | where the first guess came from | – |\n\n\
             They stand behind `case`, `f`, `alpha` and `beta`; `status` is the last column.\n";
    check("columns.md", &page);
}
