//! Sweeps on a cluster: a real Slurm with four nodes on this machine (`scripts/slurm-local`), whose nodes die and whose
//! time limits are reached. What is merged has the bytes of a run on one machine.

use std::cell::Cell;
use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

use crate::program::{code, err, out, say, stribeck};
use tempfile::{TempDir, tempdir};

/// Nothing here takes longer, or it hangs.
const PATIENCE: Duration = Duration::from_secs(360);

/// Some seconds of work for each of eight parts, in twenty chains: long enough to find them in its midst.
const LONG: &str = r#"
[axes]
f = [10.0]
alpha = { from = 0.01, to = 100.0, points = 160, scale = "log" }
beta = { from = 10.0, to = 1000.0, points = 64, scale = "log" }
[solver]
tolerance = 1e-9
[output]
fields = []
"#;

/// Parts of the long sweep.
const PARTS: u32 = 8;

const SIGTERM: u32 = 15;

const SHORT: &str = r#"
[axes]
f = [10.0]
alpha = { from = 0.1, to = 10.0, points = 8, scale = "log" }
beta = { from = 10.0, to = 100.0, points = 5 }
[output]
fields = []
"#;

/// A Slurm of its own in a directory; ended with it, however the test ends.
struct Cluster {
    home: TempDir,
}

impl Cluster {
    fn up(max_array_size: u32) -> Self {
        let cluster = Self { home: tempdir().expect("a temporary directory") };
        let size = max_array_size.to_string();
        let up = cluster.local(&["up"]).env("SLURM_LOCAL_MAX_ARRAY_SIZE", size).output().expect("bash runs");
        assert!(up.status.success(), "{}", err(&up));
        cluster
    }

    fn slurm(&self) -> PathBuf {
        self.home.path().join("slurm")
    }

    fn local(&self, arguments: &[&str]) -> Command {
        let mut command = Command::new(Path::new(env!("CARGO_MANIFEST_DIR")).join("scripts/slurm-local"));
        command.arg(arguments[0]).arg(self.slurm()).args(&arguments[1..]);
        command
    }

    fn node(&self, what: &str, node: &str) {
        let done = self.local(&[what, node]).output().expect("bash runs");
        assert!(done.status.success(), "{}", err(&done));
    }

    /// A program that talks to this Slurm.
    fn run(&self, program: &str, arguments: &[&str]) -> Output {
        let mut command = Command::new(program);
        command.args(arguments).env("SLURM_CONF", self.slurm().join("slurm.conf")).current_dir(self.home.path());
        command.output().expect("the program starts")
    }

    fn ask(&self, program: &str, arguments: &[&str]) -> String {
        let said = self.run(program, arguments);
        assert!(said.status.success(), "{program} {arguments:?}: {}", err(&said));
        out(&said)
    }

    fn stribeck(&self, arguments: &[&str]) -> Output {
        self.run(env!("CARGO_BIN_EXE_stribeck"), arguments)
    }

    /// The parts that run, each with its task of the array and its node.
    fn running(&self) -> BTreeMap<u32, (String, String)> {
        let listed = self.ask("squeue", &["-h", "-r", "-t", "RUNNING", "-o", "%K %i %N"]);
        let task = |line: &str| {
            let words: Vec<&str> = line.split_whitespace().collect();
            match words.as_slice() {
                [task, id, node] => Some((task.parse().ok()?, ((*id).to_owned(), (*node).to_owned()))),
                _ => None,
            }
        };
        listed.lines().filter_map(task).collect()
    }

    /// The program of a part: no other process has this share of the sweep in the directory of this cluster.
    fn process(&self, part: u32) -> u32 {
        let (share, home) = (format!("\0{part}/{PARTS}\0"), self.home.path().to_str().expect("a plain path"));
        let processes = fs::read_dir("/proc").expect("listed").map(|entry| entry.expect("listed").path());
        let is_it = |process: &PathBuf| {
            let command = fs::read(process.join("cmdline")).unwrap_or_default();
            let command = String::from_utf8_lossy(&command);
            command.contains(&share) && command.contains(home)
        };
        let found = processes.filter(is_it).find_map(|process| process.file_name()?.to_str()?.parse().ok());
        found.unwrap_or_else(|| panic!("part {part} has a process"))
    }

    /// Holds a part where it is (STOP), so that it cannot be done before something happens to it, or lets it go on
    /// (CONT).
    fn signal(&self, part: u32, signal: &str) {
        let sent = Command::new("kill").args([format!("-{signal}"), self.process(part).to_string()]).status();
        assert!(sent.expect("kill starts").success(), "part {part} gets {signal}");
    }

    /// Whether a SIGTERM awaits a part that is held.
    fn is_asked_to_end(&self, part: u32) -> bool {
        let status = fs::read_to_string(format!("/proc/{}/status", self.process(part))).expect("read");
        let pending = status.lines().find_map(|line| line.strip_prefix("ShdPnd:")).expect("a mask of signals");
        u64::from_str_radix(pending.trim(), 16).expect("hexadecimal") >> (SIGTERM - 1) & 1 == 1
    }

    fn wait(&self, for_what: &str, mut is_so: impl FnMut() -> bool) {
        let end = Instant::now() + PATIENCE;
        while !is_so() {
            let queue = || self.ask("squeue", &["-r"]);
            assert!(Instant::now() < end, "waited in vain for {for_what}; the queue is\n{}", queue());
            sleep(Duration::from_millis(100));
        }
    }

    /// Waits until no job is left.
    fn wait_for_the_end(&self) {
        self.wait("the end of all jobs", || self.ask("squeue", &["-h"]).is_empty());
    }

    /// What the logs of jobs of a kind say.
    fn logs(&self, results: &str, kind: impl Fn(&str) -> bool) -> String {
        let directory = self.home.path().join(results).join("slurm/log");
        let entries = fs::read_dir(directory).expect("there are logs").map(|entry| entry.expect("listed").path());
        let logs = entries.filter(|path| kind(&path.file_name().expect("a name").to_string_lossy()));
        logs.map(|path| fs::read_to_string(path).expect("read")).collect()
    }
}

impl Drop for Cluster {
    fn drop(&mut self) {
        let down = self.local(&["down"]).output();
        if !down.is_ok_and(|down| down.status.success()) {
            eprintln!("the Slurm in {} may still run", self.slurm().display());
        }
    }
}

/// The records in the logs of a part, by start.
fn starts(results: &Path, part: u32, of: u32) -> Vec<Vec<serde_json::Value>> {
    let logs = results.join(format!("parts/{part}-of-{of}/log"));
    let mut files: Vec<PathBuf> = match fs::read_dir(logs) {
        Ok(entries) => entries.map(|entry| entry.expect("listed").path()).collect(),
        Err(_) => return Vec::new(),
    };
    files.sort();
    let records = |file: &PathBuf| {
        let text = fs::read_to_string(file).expect("read");
        // The last line may be half written, while the part is at work or where it was killed.
        let whole = text.lines().filter_map(|line| serde_json::from_str::<serde_json::Value>(line).ok());
        whole.map(|mut line| line["record"].take()).collect()
    };
    files.iter().map(records).collect()
}

fn cases(records: &[serde_json::Value]) -> usize {
    records
        .iter()
        .filter(|record| record["kind"] == "shard")
        .map(|shard| shard["cases"].as_array().unwrap().len())
        .sum()
}

#[test]
#[ignore = "slow: a cluster solves a sweep while a node dies and a time limit is reached"]
fn a_sweep_on_a_cluster_whose_node_dies_has_the_bytes_of_one_machine() {
    let cluster = Cluster::up(1001);
    let here = cluster.home.path();
    fs::write(here.join("long.toml"), LONG).expect("written");
    let results = here.join("out");
    let submitted = cluster.stribeck(&[
        "slurm",
        "long.toml",
        "-o",
        "out",
        "--tasks",
        &PARTS.to_string(),
        "--time",
        "2",
        "--signal-seconds",
        "50",
        "--submit",
    ]);
    assert_eq!(code(&submitted), 0, "{}", err(&submitted));
    assert!(out(&submitted).contains("submitted 8 parts as job "), "{}", out(&submitted));

    // A node dies while both of its parts have stored something, and are not done.
    let committed = |part: u32| starts(&results, part, PARTS).iter().map(|start| cases(start)).sum::<usize>();
    let victims = || -> Vec<u32> {
        cluster.running().into_iter().filter(|(_, (_, node))| node == "n2").map(|(part, _)| part).collect()
    };
    cluster.wait("two parts at work on node n2", || {
        victims().len() == 2 && victims().into_iter().all(|part| committed(part) > 0)
    });
    let lost = victims();
    lost.iter().for_each(|&part| cluster.signal(part, "STOP"));

    // Another part gets a shorter limit, which it runs into. One that had stored nothing would not be started again.
    let mut other = None;
    cluster.wait("another part to store something", || {
        other = cluster.running().into_iter().find(|(part, _)| !lost.contains(part) && committed(*part) > 0);
        other.is_some()
    });
    let (limited, (task, _)) = other.expect("found");
    cluster.signal(limited, "STOP");
    cluster.ask("scontrol", &["update", &format!("JobId={task}"), "TimeLimit=1"]);

    cluster.node("kill", "n2");
    let before: Vec<usize> = lost.iter().map(|&part| committed(part)).collect();
    let mut whole = stribeck(here);
    whole.args(["run", "long.toml", "-o", "whole", "--quiet"]).stdout(Stdio::null());
    let mut whole = whole.spawn().expect("the program starts");
    // The part goes on as soon as it is asked to end, for what it has left until its time limit is as little as
    // elsewhere.
    let held = Cell::new(true);
    let came_to_its_limit = || {
        if held.get() && cluster.is_asked_to_end(limited) {
            cluster.signal(limited, "CONT");
            held.set(false);
        }
        !held.get()
    };
    cluster.wait("the parts of the dead node to be requeued", || {
        came_to_its_limit();
        lost.iter().all(|part| !cluster.running().contains_key(part))
    });
    cluster.node("start", "n2");
    let status = cluster.stribeck(&["status", "out"]);
    assert_eq!(code(&status), 0, "{}", err(&status));
    assert!(out(&status).contains("8 parts: "), "{}", out(&status));
    cluster.wait("the time limit of a part", came_to_its_limit);
    cluster.wait_for_the_end();

    for (part, before) in lost.into_iter().zip(before) {
        let starts = starts(&results, part, PARTS);
        assert!(starts.len() >= 2, "part {part} was started again");
        assert!(starts[0].iter().all(|record| record["kind"] != "end"), "part {part} was killed");
        let planned = starts[0][0]["cases"].as_u64().expect("a number") as usize;
        let left = starts[1][0]["cases"].as_u64().expect("a number") as usize;
        assert!(
            before > 0 && planned - left >= before,
            "part {part} went on where it was: {planned}, {before}, {left}"
        );
        assert!(cluster.logs("out", |log| log.ends_with(&format!("_{part}.out"))).contains(", start 2, on "));
    }
    let starts = starts(&results, limited, PARTS);
    assert!(
        starts.len() >= 2 && starts[0].last().is_some_and(|record| record["ending"] == "interrupted"),
        "{starts:?}"
    );
    let said = cluster.logs("out", |log| log.ends_with(&format!("_{limited}.out")));
    assert!(said.contains(&format!("part {limited} of 8 is near its time limit")), "{said}");
    assert!(said.contains("interrupted by SIGTERM: ") && said.contains(", start 2, on "), "{said}");

    let merged = cluster.logs("out", |log| log.starts_with("merge_"));
    assert!(merged.contains("10240 cases: 10240 converged, 0 failed\njoined 10240 cases in "), "{merged}");
    assert!(whole.wait().expect("it ends").success());
    for name in ["summary.csv", "results.h5"] {
        let [parts, whole] =
            ["out", "whole"].map(|results| fs::read(here.join(results).join(name)).expect("published"));
        assert!(parts == whole, "{name} differs");
    }
}

#[test]
#[ignore = "slow: a cluster with small arrays solves a sweep"]
fn more_tasks_than_an_array_may_have_are_several_arrays_and_a_missing_part_fails_the_merge() {
    let cluster = Cluster::up(5);
    let here = cluster.home.path();
    fs::write(here.join("short.toml"), SHORT).expect("written");
    // Held, so that one of the parts can be taken out.
    let arguments = ["slurm", "short.toml", "-o", "out", "--tasks", "8", "--sbatch=--hold", "--submit"];
    let submitted = cluster.stribeck(&arguments);
    assert_eq!(code(&submitted), 0, "{}", err(&submitted));
    let words: Vec<String> = out(&submitted).split_whitespace().map(str::to_owned).collect();
    let jobs: Vec<&String> =
        words.iter().zip(&words[1..]).filter(|(word, _)| *word == "job").map(|(_, number)| number).collect();
    assert_eq!(jobs.len(), 3, "two arrays and the merge: {}", out(&submitted));
    // The third task of the second array is part 7.
    cluster.ask("scancel", &[&format!("{}_3", jobs[1])]);
    for job in &jobs {
        cluster.ask("scontrol", &["release", job]);
    }
    cluster.wait_for_the_end();
    let merged = cluster.logs("out", |log| log.starts_with("merge_"));
    assert!(merged.contains("nothing is published: ") && merged.contains("part 7/8 lacks "), "{merged}");
    let state = cluster.ask("scontrol", &["show", "job", jobs[2]]);
    assert!(state.contains("JobState=FAILED") && state.contains("ExitCode=4:0"), "{state}");
    assert!(!here.join("out/summary.csv").exists());

    // The message has the command that finishes it.
    let command = merged.lines().find_map(|line| line.trim().strip_prefix("stribeck run ")).expect("a command");
    let script = format!("'{}' run {command}", env!("CARGO_BIN_EXE_stribeck"));
    let finished = Command::new("sh").args(["-c", &script]).current_dir(here).output().expect("sh runs");
    assert_eq!(code(&finished), 0, "{script}: {}", err(&finished));
    assert_eq!(code(&say(here, &["merge", "out"])), 0);
    assert_eq!(code(&say(here, &["run", "short.toml", "-o", "whole", "--quiet"])), 0);
    for name in ["summary.csv", "results.h5"] {
        let [parts, whole] =
            ["out", "whole"].map(|results| fs::read(here.join(results).join(name)).expect("published"));
        assert!(parts == whole, "{name} differs");
    }
}
