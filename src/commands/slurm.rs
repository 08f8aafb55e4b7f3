//! `stribeck slurm`: a sweep as a job array of Slurm, and a job that merges it.

use std::io;
use std::num::NonZeroU32;
use std::path::{Path, PathBuf};
use std::process::Command;

use clap::Args;

use super::destination::destination;
use super::output_file::{OutputFile, OutputFiles};
use super::sbatch_option::sbatch_option;
use super::slurm_script::{Job, MARK, merge_script, part_script};
use super::{CliError, Exit, console, shell};
use crate::format::count;
use stribeck_input::shown;
use stribeck_sweep::campaign::{check_available, read_sweep};
use stribeck_sweep::store::create_directory;
use stribeck_sweep::{Part, Plan};

/// Slurm's own default of MaxArraySize.
const USUAL_ARRAY_SIZE: u32 = 1001;

/// A signal may come this many seconds early.
const EARLY: u64 = 60;

#[derive(Clone, Debug, Args)]
#[command(
    before_help = "\
Examples:
  stribeck slurm sweeps/hundred-thousand.toml -o shared/many --tasks 64 --cpus 4 --time 02:00:00
  stribeck slurm sweeps/film.toml -o shared/film --tasks 8 --account abc --sbatch=--constraint=avx2
  stribeck slurm sweeps/surface.toml -o shared/surface --tasks 4 --setup \"module load hdf5\"",
    after_help = "\
Writes DIR/slurm/part.sh and DIR/slurm/merge.sh, and prints the commands that submit them. With --submit it submits
them itself: an array of the parts (several arrays, if there are more tasks than the site allows in one), and a job that
merges when all of them have ended. A part that is near its time limit stores what is finished and requeues itself; one
whose node fails is requeued by Slurm. docs/how-to/cluster.md has more."
)]
pub struct Arguments {
    /// The sweep file (TOML)
    sweep: PathBuf,
    /// Results directory, on a file system that all nodes see [default: results/<file stem>]
    #[arg(short, long, value_name = "DIR")]
    output: Option<PathBuf>,
    /// Parts that the sweep is cut into, each a task of the array
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=i64::from(Part::MOST)))]
    tasks: u32,
    /// Processors of a task, and its solver threads
    #[arg(long, value_name = "C", default_value = "1")]
    cpus: NonZeroU32,
    /// Time limit of a task in Slurm's form, as in 90, 02:00:00 or 1-12 [default: that of the partition]
    #[arg(long, value_name = "T", value_parser = time)]
    time: Option<TimeLimit>,
    /// Seconds before the limit at which a part is told to store what is finished
    #[arg(long, value_name = "S", default_value = "180", value_parser = clap::value_parser!(u64).range(0..=65_535))]
    signal_seconds: u64,
    /// Partition
    #[arg(long, value_name = "P", value_parser = one_word)]
    partition: Option<String>,
    /// Account
    #[arg(long, value_name = "A", value_parser = one_word)]
    account: Option<String>,
    /// Memory of a task, as in 2G
    #[arg(long, value_name = "M", value_parser = one_word)]
    mem: Option<String>,
    /// One more option of sbatch for both jobs, as in --sbatch=--constraint=avx2; may be repeated
    #[arg(long, value_name = "OPTION", value_parser = sbatch_option, allow_hyphen_values = true)]
    sbatch: Vec<String>,
    /// A line of shell before the program starts, as in "module load hdf5"; may be repeated
    #[arg(long, value_name = "LINE", value_parser = one_line)]
    setup: Vec<String>,
    /// Submit the jobs
    #[arg(long)]
    submit: bool,
}

/// A time limit as it was given, and in seconds.
#[derive(Clone, Debug, PartialEq, Eq)]
struct TimeLimit {
    text: String,
    seconds: u64,
}

/// Reads a time as sbatch does: minutes, minutes:seconds, hours:minutes:seconds, days-hours, and so on.
fn time(text: &str) -> Result<TimeLimit, String> {
    let allowed = || {
        "give it as sbatch takes it: minutes, hours:minutes:seconds or days-hours, as in 90, 02:00:00 or 1-12"
            .to_owned()
    };
    let (days, rest) = match text.split_once('-') {
        Some((days, rest)) => (Some(days.parse::<u64>().map_err(|_| allowed())?), rest),
        None => (None, text),
    };
    let fields =
        rest.split(':').map(|field| field.parse::<u64>().map_err(|_| allowed())).collect::<Result<Vec<_>, _>>()?;
    let [hours, minutes, seconds] = match (days.is_some(), fields.as_slice()) {
        (true, &[hours]) => [hours, 0, 0],
        (true, &[hours, minutes]) => [hours, minutes, 0],
        (false, &[minutes]) => [0, minutes, 0],
        (false, &[minutes, seconds]) => [0, minutes, seconds],
        (_, &[hours, minutes, seconds]) => [hours, minutes, seconds],
        _ => return Err(allowed()),
    };
    let parts = [(days.unwrap_or(0), 86_400), (hours, 3600), (minutes, 60), (seconds, 1)];
    let total = parts.into_iter().try_fold(0_u64, |sum, (number, unit)| sum.checked_add(number.checked_mul(unit)?));
    match total {
        Some(seconds) if seconds > 0 => Ok(TimeLimit { text: text.to_owned(), seconds }),
        _ => Err(allowed()),
    }
}

fn one_line(text: &str) -> Result<String, String> {
    match text.trim().is_empty() || text.chars().any(char::is_control) {
        true => Err("give one line that is not empty".to_owned()),
        false => Ok(text.to_owned()),
    }
}

fn one_word(text: &str) -> Result<String, String> {
    match one_line(text)? {
        line if line.contains(char::is_whitespace) => Err("give one word".to_owned()),
        word => Ok(word),
    }
}

pub fn execute(arguments: &Arguments) -> Result<Exit, CliError> {
    if let Some(TimeLimit { text, seconds }) = &arguments.time
        && *seconds <= arguments.signal_seconds + EARLY
    {
        let (limit, signal) = (text.clone(), arguments.signal_seconds);
        return Err(CliError::NoTimeToWork { limit, signal, early: EARLY });
    }
    let sweep = read_sweep(&arguments.sweep)?;
    let chains = Plan::new(&sweep).chain_count();
    if arguments.tasks as usize > chains {
        let idle = arguments.tasks as usize - chains;
        console::tell(&format!(
            "note: the sweep has {}; {idle} of the tasks have nothing to do",
            count(chains as u64, "chain")
        ));
    }
    let directory = absolute(&destination(arguments.output.as_deref(), &sweep.name)?)?;
    // In the name of a log Slurm replaces what follows a %, and there is no writing a quote.
    if directory.to_string_lossy().contains(['%', '"', '\\', '\n', '\u{fffd}']) {
        return Err(CliError::NameForSlurm { path: directory });
    }
    check_available(&directory)?;
    let home = directory.join("slurm");
    let (part, merge) = (home.join("part.sh"), home.join("merge.sh"));
    let kept = home.join(format!("{}.toml", sweep.name));
    let [kept_file, part_file, merge_file] = outputs(&arguments.sweep, &kept, &part, &merge)?;
    create_directory(&home.join("log"))?;
    // The sweep as it is now: whoever edits the file while jobs wait in the queue does not change half of them.
    kept_file.write(sweep.text.as_bytes())?;
    let program =
        shell::own_path().map_err(|source| CliError::System { action: "find out where this program is", source })?;
    let job = Job {
        name: &sweep.name,
        program: &program,
        sweep: &kept,
        directory: &directory,
        tasks: arguments.tasks,
        cpus: arguments.cpus.get(),
        time: arguments.time.as_ref().map(|time| time.text.as_str()),
        signal_seconds: arguments.signal_seconds,
        options: options(arguments),
        setup: &arguments.setup,
    };
    part_file.write(part_script(&job).as_bytes())?;
    merge_file.write(merge_script(&job).as_bytes())?;
    console::print(&format!("wrote {} and {}\n", shown(&part), shown(&merge)))?;
    if arguments.submit {
        submit(&part, &merge, arguments.tasks)?;
    } else {
        console::print(&by_hand(&part, &merge, arguments.tasks))?;
    }
    Ok(Exit::Success)
}

/// The files of the sweep and of the two scripts. A sweep file beside scripts of ours is ours too.
fn outputs(sweep: &Path, kept: &Path, part: &Path, merge: &Path) -> Result<[OutputFile; 3], CliError> {
    let files = OutputFiles::new("slurm", [sweep]);
    let is_script = |beginning: &[u8]| beginning.split(|byte| *byte == b'\n').nth(1) == Some(MARK.as_bytes());
    let [part_file, merge_file] = [files.check(part, is_script)?, files.check(merge, is_script)?];
    Ok([files.check(kept, |_| part.exists())?, part_file, merge_file])
}

/// The options of sbatch for both jobs.
fn options(arguments: &Arguments) -> Vec<String> {
    let named = [("partition", &arguments.partition), ("account", &arguments.account), ("mem", &arguments.mem)];
    let named = named.into_iter().filter_map(|(name, value)| value.as_ref().map(|value| format!("--{name}={value}")));
    named.chain(arguments.sbatch.iter().cloned()).collect()
}

fn absolute(path: &Path) -> Result<PathBuf, CliError> {
    std::path::absolute(path).map_err(|source| CliError::Directory { action: "find", path: path.to_owned(), source })
}

/// The arrays that have so many tasks: how many each has, and how many there are in those before it. Slurm numbers
/// the tasks of an array up to its MaxArraySize, which is excluded.
fn arrays(tasks: u32, max_array_size: u32) -> Vec<(u32, u32)> {
    let most = max_array_size.saturating_sub(1).max(1);
    (0..tasks.div_ceil(most)).map(|number| ((tasks - number * most).min(most), number * most)).collect()
}

/// The commands that submit the jobs.
fn by_hand(part: &Path, merge: &Path, tasks: u32) -> String {
    let (part, merge) = (shell::quoted(part.as_os_str()), shell::quoted(merge.as_os_str()));
    let arrays = arrays(tasks, USUAL_ARRAY_SIZE);
    let mut text = "submit them by --submit, or by hand:\n".to_owned();
    for (tasks, before) in &arrays {
        let before = if *before == 0 { String::new() } else { format!(" {before}") };
        text += &format!("    sbatch --array=1-{tasks} {part}{before}\n");
    }
    let ids = if arrays.len() == 1 { "JOB".to_owned() } else { "JOB:JOB:…".to_owned() };
    text + &format!("    sbatch --dependency=afterany:{ids} {merge}\n")
}

/// Submits the arrays of parts, and the merge after them.
fn submit(part: &Path, merge: &Path, tasks: u32) -> Result<(), CliError> {
    let config = ask("scontrol", &["show", "config"])?;
    let unknown =
        || CliError::Slurm { program: "scontrol", said: "its configuration tells no MaxArraySize".to_owned() };
    let size = max_array_size(&config).ok_or_else(unknown)?;
    let path = |path: &Path| path.to_string_lossy().into_owned();
    let mut jobs: Vec<String> = Vec::new();
    for (tasks, before) in arrays(tasks, size) {
        let (array, before) = (format!("--array=1-{tasks}"), before.to_string());
        let job = submit_one(&jobs, &[&array, &path(part), &before])?;
        console::print(&format!("submitted {} as job {job}\n", count(u64::from(tasks), "part")))?;
        jobs.push(job);
    }
    let dependency = format!("--dependency=afterany:{}", jobs.join(":"));
    let job = submit_one(&jobs, &[&dependency, &path(merge)])?;
    console::print(&format!("submitted the merge as job {job}\n"))
}

/// Submits a job after others; its number.
fn submit_one(others: &[String], arguments: &[&str]) -> Result<String, CliError> {
    let job = ask("sbatch", &[&["--parsable"], arguments].concat()).map_err(|error| match error {
        CliError::Slurm { program, said } if !others.is_empty() => {
            let others = others.join(" ");
            let said =
                format!("{said}; what was submitted before stays in the queue, `scancel {others}` takes it back");
            CliError::Slurm { program, said }
        }
        error => error,
    })?;
    // A cluster's name may follow the number.
    Ok(job.trim().split(';').next().unwrap_or_default().to_owned())
}

/// MaxArraySize in what `scontrol show config` prints.
fn max_array_size(config: &str) -> Option<u32> {
    let line = config.lines().find(|line| line.split('=').next().is_some_and(|key| key.trim() == "MaxArraySize"))?;
    line.split_once('=')?.1.trim().parse().ok()
}

/// What a program of Slurm prints.
fn ask(program: &'static str, arguments: &[&str]) -> Result<String, CliError> {
    let said = Command::new(program).args(arguments).output();
    let refused = |said: String| CliError::Slurm { program, said };
    match said {
        Ok(said) if said.status.success() => Ok(String::from_utf8_lossy(&said.stdout).into_owned()),
        Ok(said) => Err(refused(String::from_utf8_lossy(&said.stderr).trim().to_owned())),
        Err(error) if error.kind() == io::ErrorKind::NotFound => Err(refused("there is no such program".to_owned())),
        Err(error) => Err(refused(error.to_string())),
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    #[test]
    fn times_are_read_as_sbatch_reads_them() {
        // man sbatch, option --time
        let known = [
            ("90", 5400),
            ("1:30", 90),
            ("02:00:00", 7200),
            ("1-12", 129_600),
            ("1-12:30", 131_400),
            ("0-00:00:30", 30),
        ];
        for (text, seconds) in known {
            assert_eq!(time(text).map(|time| time.seconds), Ok(seconds), "{text}");
        }
        for text in ["", "0", "-5", "1-", "1:2:3:4", "1h", "99999999999999999999", "1-99999999999999999"] {
            assert!(time(text).is_err(), "{text}");
        }
    }

    proptest! {
        #![proptest_config(ProptestConfig {
            rng_seed: proptest::test_runner::RngSeed::Fixed(2022),
            ..ProptestConfig::default()
        })]

        #[test]
        fn every_task_is_in_one_array_and_no_array_is_too_large(tasks in 1..=Part::MOST, size in 2u32..5000) {
            let arrays = arrays(tasks, size);
            let mut next = 0;
            for (number, before) in arrays {
                prop_assert_eq!(before, next);
                prop_assert!(number >= 1 && number < size, "the largest number is below MaxArraySize");
                next += number;
            }
            prop_assert_eq!(next, tasks);
        }
    }

    #[test]
    fn the_size_of_arrays_is_found_among_other_settings() {
        let config = "MailProg                = /usr/bin/mail\nMaxArraySize            = 1001\nMaxArraySizeX = 3\n";
        assert_eq!(max_array_size(config), Some(1001));
        assert_eq!(max_array_size("MaxJobCount = 10000\n"), None);
    }
}
