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

impl Job<'_> {
    /// The lines that sbatch reads, and the lines of the site.
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
        let setup: String = self.setup.iter().map(|line| format!("{line}\n")).collect();
        format!("#!/bin/bash\n{lines}\n{setup}")
    }
}

/// The script of one part: the task's number, plus the number that is given to the script, of all.
pub fn part_script(job: &Job<'_>) -> String {
    let mut own = vec!["--requeue".to_owned(), format!("--cpus-per-task={}", job.cpus)];
    own.extend(job.time.map(|time| format!("--time={time}")));
    own.push(format!("--signal=B:USR1@{}", job.signal_seconds));
    let [program, sweep, directory] = [job.program, job.sweep, job.directory].map(|path| quoted(path.as_os_str()));
    let tasks = job.tasks;
    job.head("part", "%A_%a.out", &own)
        + &format!(
            r#"
part=$((SLURM_ARRAY_TASK_ID + ${{1:-0}}))
echo "part $part of {tasks}, start $((${{SLURM_RESTART_COUNT:-0}} + 1)), on $SLURMD_NODENAME, $(date -u '+%Y-%m-%d %H:%M:%S') UTC"

# Ahead of the time limit Slurm sends USR1, to this shell alone: the program is to store what is finished and end.
program=
limit=no
trap 'limit=yes; [ -z "$program" ] || kill -TERM "$program" 2>/dev/null' USR1
{program} run {sweep} -o {directory} \
    --shard "$part/{tasks}" --threads "${{SLURM_CPUS_PER_TASK:-1}}" --quiet &
program=$!
[ "$limit" = no ] || kill -TERM "$program"
# A signal ends the waiting, and not the program.
while wait "$program"; code=$?; kill -0 "$program" 2>/dev/null; do :; done

case $code in
    0) ;;
    # Some cases failed, which is a result: the part is done.
    3) code=0 ;;
    2 | 4) echo "part $part of {tasks} failed with exit code $code; see above" ;;
    *)
        if [ "$limit" = yes ]; then
            echo "part $part of {tasks} is near its time limit: it goes on where it is when it is started again"
            scontrol requeue "${{SLURM_ARRAY_JOB_ID}}_$SLURM_ARRAY_TASK_ID"
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
    job.head("merge", "merge_%j.out", &[])
        + &format!(
            r#"
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
    use std::process::Command;

    use super::*;

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
            std::fs::write(&file, script).expect("written");
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
        assert!(said.contains(&format!("run {sweep} -o {directory} --shard 8/12 --threads 4 --quiet\n")), "{said}");
        assert!(said.starts_with("part 8 of 12, start 1, on n1, "), "{said}");
        let said = run(merge_script(&job), &[]);
        assert_eq!(said, format!("merge {directory}\n"));
    }
}
