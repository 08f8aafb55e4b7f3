//! The scripts of `stribeck slurm`.

use std::path::Path;

use super::shell::quoted;

/// What the scripts are about.
pub struct Job<'a> {
    /// Name of the sweep.
    pub name: &'a str,
    /// This program.
    pub program: &'a Path,
    /// The sweep file.
    pub sweep: &'a Path,
    /// Results directory.
    pub directory: &'a Path,
    /// Parts.
    pub tasks: u32,
    /// Processors of a part.
    pub cpus: u32,
    /// Time limit of a part.
    pub time: Option<&'a str>,
    /// Seconds before it at which a part is told.
    pub signal_seconds: u64,
    /// More options of sbatch.
    pub options: Vec<String>,
    /// Lines of shell before the program starts.
    pub setup: &'a [String],
}

/// The second line of every script, by which they are known.
pub const MARK: &str = "# Written by `stribeck slurm`, which replaces it when it is run again.";

impl Job<'_> {
    /// The lines that sbatch reads.
    fn head(&self, what: &str, log: &str, own: &[String]) -> String {
        // Sbatch reads a word in double quotes as one; a job's name is a label, so blanks in it become lines.
        let name: String = self.name.chars().map(|c| if c.is_ascii_alphanumeric() { c } else { '-' }).collect();
        let output = self.directory.join("slurm/log").join(log);
        let mut options = vec![
            format!("--job-name=stribeck-{name}-{what}"),
            format!("--output=\"{}\"", output.display()),
            "--open-mode=append".to_owned(),
            "--nodes=1".to_owned(),
            "--ntasks=1".to_owned(),
        ];
        options.extend(own.iter().cloned());
        options.extend(self.options.iter().cloned());
        let lines: String = options.into_iter().map(|option| format!("#SBATCH {option}\n")).collect();
        format!("#!/bin/bash\n{MARK}\n{lines}")
    }

    /// The lines of the site.
    fn setup(&self) -> String {
        self.setup.iter().map(|line| format!("{line}\n")).collect()
    }
}

/// The script of one part: the task's number, plus the number that is given to the script, of all.
///
/// A part that stored nothing before its time limit is not started again: it would not get further the next time, and be
/// started for ever.
pub fn part_script(job: &Job<'_>) -> String {
    let mut own = vec!["--requeue".to_owned(), format!("--cpus-per-task={}", job.cpus)];
    own.extend(job.time.map(|time| format!("--time={time}")));
    own.push(format!("--signal=B:USR1@{}", job.signal_seconds));
    let [program, sweep, directory] = [job.program, job.sweep, job.directory].map(|path| quoted(path.as_os_str()));
    let (tasks, setup) = (job.tasks, job.setup());
    job.head("part", "%A_%a.out", &own)
        + &format!(
            r#"
# Ahead of the time limit Slurm sends USR1, to this shell alone: the program is to store what is finished and end.
program=
limit=no
trap 'waiting=yes limit=yes; [ -z "$program" ] || kill -TERM "$program" 2>/dev/null' USR1
# TERM, for a job that is cancelled or gives way to another, reaches the program as well at some sites and this shell alone at
# others. A program that has it already is gone in a second; a second one too early would end it before it has stored all.
trap 'waiting=yes; [ -z "$program" ] || {{ sleep 1; kill -TERM "$program" 2>/dev/null; }}' TERM

{setup}
part=$((SLURM_ARRAY_TASK_ID + ${{1:-0}}))
echo "part $part of {tasks}, start $((${{SLURM_RESTART_COUNT:-0}} + 1)), on $SLURMD_NODENAME, $(date -u '+%Y-%m-%d %H:%M:%S') UTC"
stored() {{ find {directory}/parts/"$part-of-{tasks}"/shards -name '*.h5' 2>/dev/null | wc -l; }}
before=$(stored)
{program} run {sweep} -o {directory} \
    --part "$part/{tasks}" --threads "${{SLURM_CPUS_PER_TASK:-1}}" --quiet &
program=$!
[ "$limit" = no ] || kill -TERM "$program"
# A signal ends the waiting, and not the program; bash remembers how a program ended that it has waited for.
waiting=yes
while [ "$waiting" = yes ]; do
    waiting=no
    wait "$program"
    code=$?
done

case $code in
    0) ;;
    # Some cases failed, which is a result: the part is done.
    3) code=0 ;;
    2 | 4) echo "part $part of {tasks} failed with exit code $code; see above" ;;
    *)
        if [ "$limit" = yes ] && [ "$(stored)" -gt "$before" ]; then
            echo "part $part of {tasks} is near its time limit: it goes on where it is when it is started again"
            scontrol requeue "${{SLURM_ARRAY_JOB_ID}}_$SLURM_ARRAY_TASK_ID"
        elif [ "$limit" = yes ]; then
            echo "part $part of {tasks} has come to its time limit and stored nothing: it is not started again;" \
                "give the parts a longer --time"
        fi
        ;;
esac
exit "$code"
"#
        )
}

/// The script that merges when all parts have ended, and fails if one lacks cases.
pub fn merge_script(job: &Job<'_>) -> String {
    let [program, directory] = [job.program, job.directory].map(|path| quoted(path.as_os_str()));
    let setup = job.setup();
    job.head("merge", "merge_%j.out", &[])
        + &format!(
            r#"
{setup}
{program} merge {directory}
code=$?
# Failed cases are results.
[ "$code" -ne 3 ] || code=0
exit "$code"
"#
        )
}

#[cfg(test)]
mod tests {
    use std::fs;
    use std::os::unix::fs::PermissionsExt;
    use std::path::PathBuf;
    use std::process::{Child, Command, Stdio};

    use super::*;

    /// Part 2 of 2 at work, with a program and an `scontrol` that only note what reaches them.
    struct Works {
        home: tempfile::TempDir,
        shell: Child,
    }

    impl Works {
        /// Starts it; `program` is what the program does, in its home.
        fn new(program: &str) -> Self {
            let home = tempfile::tempdir().expect("a temporary directory");
            let directory = home.path().join("my out");
            fs::create_dir_all(directory.join("parts/2-of-2/shards")).expect("created");
            fs::write(directory.join("parts/2-of-2/shards/before.h5"), "").expect("written");
            let executable = |name: &str, text: &str| -> PathBuf {
                let file = home.path().join(name);
                fs::write(&file, format!("#!/bin/bash\ncd '{}'\n{text}\n", home.path().display())).expect("written");
                fs::set_permissions(&file, fs::Permissions::from_mode(0o755)).expect("made executable");
                file
            };
            executable("scontrol", "echo \"$*\" > requeued");
            let program = executable("program", program);
            let sweep = directory.join("sweep.toml");
            let (name, time, signal_seconds, options, setup) = ("small", None, 180, Vec::new(), &[][..]);
            let directory = &directory;
            let job = Job {
                name,
                program: &program,
                sweep: &sweep,
                directory,
                tasks: 2,
                cpus: 1,
                time,
                signal_seconds,
                options,
                setup,
            };
            let script = executable("part.sh", &part_script(&job));
            let path = format!("{}:{}", home.path().display(), std::env::var("PATH").expect("a path"));
            let mut bash = Command::new("bash");
            bash.arg(script).env("PATH", path).env("SLURM_ARRAY_JOB_ID", "7").env("SLURM_ARRAY_TASK_ID", "2");
            let shell = bash.stdout(Stdio::piped()).stderr(Stdio::null()).spawn().expect("bash starts");
            Self { home, shell }
        }

        fn noted(&self, name: &str) -> Option<String> {
            fs::read_to_string(self.home.path().join(name)).ok()
        }

        /// Sends a signal to the shell alone, once the program is at work.
        fn signalled(self, signal: &str) -> Self {
            while self.noted("working").is_none() {
                std::thread::sleep(std::time::Duration::from_millis(10));
            }
            let sent = Command::new("kill").args(["-s", signal, &self.shell.id().to_string()]).status();
            assert!(sent.expect("kill runs").success());
            self
        }

        /// Exit code, what was said, and the task that was requeued.
        fn ending(self) -> (Option<i32>, String, Option<String>) {
            let Self { home, shell } = self;
            let output = shell.wait_with_output().expect("bash ends");
            let said = String::from_utf8(output.stdout).expect("text");
            (output.status.code(), said, fs::read_to_string(home.path().join("requeued")).ok())
        }
    }

    const STORES: &str = "touch \"my out/parts/2-of-2/shards/more.h5\";";

    /// A program at work that stops for SIGTERM, after it has done what is given.
    fn stops(after: &str) -> String {
        format!("trap '{after} exit 130' TERM\ntouch working\nwhile :; do sleep 0.02; done")
    }

    #[test]
    fn a_part_requeues_itself_at_its_time_limit_if_it_got_further() {
        let (code, said, requeued) = Works::new(&stops(STORES)).signalled("USR1").ending();
        assert_eq!((code, requeued.as_deref()), (Some(130), Some("requeue 7_2\n")), "{said}");
        assert!(said.contains("part 2 of 2 is near its time limit"), "{said}");
        // One that stored nothing would be started for ever.
        let (code, said, requeued) = Works::new(&stops("")).signalled("USR1").ending();
        assert_eq!((code, requeued), (Some(130), None), "{said}");
        assert!(said.contains("stored nothing: it is not started again; give the parts a longer --time"), "{said}");
        // One that has just finished is done.
        let (code, said, requeued) = Works::new(&stops("exit 0;")).signalled("USR1").ending();
        assert_eq!((code, requeued), (Some(0), None), "{said}");
    }

    #[test]
    fn a_part_that_is_cancelled_stores_what_is_finished_and_is_not_requeued() {
        let (code, said, requeued) = Works::new(&stops(STORES)).signalled("TERM").ending();
        assert_eq!((code, requeued), (Some(130), None), "{said}");
    }

    #[test]
    fn a_part_ends_as_its_program_does_but_failed_cases_are_results() {
        for (program, ends) in [(0, 0), (2, 2), (3, 0), (4, 4), (101, 101)] {
            let (code, said, requeued) = Works::new(&format!("exit {program}")).ending();
            assert_eq!((code, requeued), (Some(ends), None), "{said}");
        }
    }

    /// What a shell is asked to run for a program, sweep and directory whose names it would take apart.
    #[test]
    fn scripts_are_valid_whatever_names_are_in_them() {
        let home = tempfile::tempdir().expect("a temporary directory");
        let directory = home.path().join("it's $HOME `here`");
        let setup = ["module() { :; }".to_owned(), "module load hdf5".to_owned()];
        let job = Job {
            name: "my sweep (1)",
            program: Path::new("/bin/echo"),
            sweep: &directory.join("my sweep.toml"),
            directory: &directory,
            tasks: 12,
            cpus: 4,
            time: Some("02:00:00"),
            signal_seconds: 180,
            options: vec!["--partition=short".to_owned(), "--constraint=avx2".to_owned()],
            setup: &setup,
        };
        let run = |script: String, arguments: &[&str]| {
            let file = home.path().join("script.sh");
            fs::write(&file, script).expect("written");
            let mut command = Command::new("bash");
            command.arg(&file).args(arguments).env("SLURM_ARRAY_TASK_ID", "3").env("SLURM_CPUS_PER_TASK", "4");
            let output = command.env("SLURMD_NODENAME", "n1").output().expect("bash runs");
            assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
            String::from_utf8(output.stdout).expect("text")
        };
        let script = part_script(&job);
        for line in [
            "--job-name=stribeck-my-sweep--1--part",
            "--requeue",
            "--open-mode=append",
            "--cpus-per-task=4",
            "--time=02:00:00",
            "--signal=B:USR1@180",
            "--partition=short",
            "--constraint=avx2",
        ] {
            assert!(script.contains(&format!("\n#SBATCH {line}\n")), "{line}: {script}");
        }
        let said = run(script, &["5"]);
        let [sweep, directory] = [job.sweep, job.directory].map(|path| path.display().to_string());
        assert!(said.contains(&format!("run {sweep} -o {directory} --part 8/12 --threads 4 --quiet\n")), "{said}");
        assert!(said.starts_with("part 8 of 12, start 1, on n1, "), "{said}");
        let said = run(merge_script(&job), &[]);
        assert_eq!(said, format!("merge {directory}\n"));
    }
}
