//! A directory with a sweep file and its results, and the program at work there.

use std::fs::{self, DirEntry};
use std::io::ErrorKind;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Output, Stdio};
use std::thread::sleep;
use std::time::Duration;

use tempfile::TempDir;

use crate::program::{say, stribeck};
use crate::torture::stored::{Cases, Stored, logs};
use crate::torture::sweep::Sweep;

/// A directory with `sweep.toml` and its results in `out`.
pub struct Place {
    pub sweep: Sweep,
    home: PathBuf,
    /// Removes the directory at the end; a place on a [`Disk`](crate::torture::disk::Disk) goes with the disk.
    own: Option<TempDir>,
}

impl Drop for Place {
    /// What is left after a failure is kept to be looked at.
    fn drop(&mut self) {
        if let Some(own) = self.own.as_mut().filter(|_| std::thread::panicking()) {
            own.disable_cleanup(true);
            eprintln!("kept: {}", self.home.display());
        }
    }
}

impl Place {
    /// A directory with nothing but the sweep file.
    pub fn fresh(sweep: Sweep) -> Self {
        let own = TempDir::with_prefix("stribeck-torture-").expect("a temporary directory");
        let place = Self { sweep, home: own.path().to_owned(), own: Some(own) };
        place.write_sweep();
        place
    }

    /// The same in a directory of someone else.
    pub fn fresh_in(home: &Path, sweep: Sweep) -> Self {
        let place = Self { sweep, home: home.to_owned(), own: None };
        place.write_sweep();
        place
    }

    fn write_sweep(&self) {
        fs::write(self.home.join("sweep.toml"), self.sweep.text()).expect("written");
    }

    /// A copy with files of its own, in a directory of someone else.
    pub fn copy_to(&self, home: &Path) -> Self {
        copy(&self.home, home);
        Self { sweep: self.sweep, home: home.to_owned(), own: None }
    }

    /// A copy with files of its own, under another path.
    pub fn copy(&self) -> Self {
        let copy = Self::fresh(self.sweep);
        self.copy_to(&copy.home);
        copy
    }

    /// The results directory.
    pub fn results(&self) -> PathBuf {
        self.home.join("out")
    }

    /// What is stored.
    pub fn stored(&self) -> Stored {
        Stored::read(&self.results())
    }

    /// The cases of the sweep that are done.
    pub fn cases(&self) -> Cases {
        self.cases_of(&self.stored())
    }

    /// The cases of the sweep among those stored.
    pub fn cases_of(&self, stored: &Stored) -> Cases {
        self.of_the_sweep(stored.cases_without(&self.sweep.undisturbed().contents, |_| false))
    }

    /// Without those of other sweeps.
    pub fn of_the_sweep(&self, mut cases: Cases) -> Cases {
        cases.retain(|case, _| self.sweep.undisturbed().cases.contains_key(case));
        cases
    }

    /// Whether every case of the sweep is done.
    pub fn is_solved(&self) -> bool {
        self.cases() == self.sweep.undisturbed().cases
    }

    /// The command that runs the sweep.
    pub fn command(&self, threads: usize) -> Command {
        let mut command = stribeck(&self.home);
        command.args(["run", "sweep.toml", "-o", "out", "--threads", &threads.to_string(), "--quiet"]);
        command
    }

    /// The same as it is typed.
    pub fn typed(&self, threads: usize) -> String {
        let command = self.command(threads);
        let words = std::iter::once(command.get_program()).chain(command.get_args());
        words.map(|word| word.to_str().expect("text")).collect::<Vec<_>>().join(" ")
    }

    /// Starts the command that runs the sweep.
    pub fn start(&self, threads: usize) -> Run {
        Run::start(self.command(threads))
    }

    /// Runs the sweep to its end.
    pub fn run(&self, threads: usize) -> End {
        self.start(threads).end()
    }

    /// What the program says of the sweep and its results.
    pub fn say(&self, arguments: &[&str]) -> Output {
        say(&self.home, arguments)
    }

    /// How many shards the logs record, without a look at the shards: quick, to wait for the next one.
    pub fn commits(&self) -> usize {
        let lines = |(_, path): (u32, PathBuf)| {
            let log = String::from_utf8_lossy(&fs::read(path).expect("a log can be read")).into_owned();
            log.split_inclusive('\n').filter(|line| line.ends_with('\n') && line.contains(r#""kind":"shard""#)).count()
        };
        logs(&self.results()).into_iter().map(lines).sum()
    }
}

/// A run at work. It does not outlive the test.
pub struct Run {
    child: Option<Child>,
}

/// How a run ended.
#[derive(Debug)]
pub struct End {
    /// Its exit code; `None` if a signal killed it.
    pub code: Option<i32>,
    pub out: String,
    pub err: String,
}

impl Run {
    /// Starts a command.
    pub fn start(mut command: Command) -> Self {
        let child = command.stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn();
        Self { child: Some(child.expect("the program starts")) }
    }

    fn child(&mut self) -> &mut Child {
        self.child.as_mut().expect("there until its end is waited for")
    }

    /// Its process number.
    pub fn id(&mut self) -> u32 {
        self.child().id()
    }

    /// True after it ended.
    pub fn has_ended(&mut self) -> bool {
        self.child().try_wait().expect("asked").is_some()
    }

    /// Waits until something happened, or the run has ended; true if it happened.
    pub fn wait_until(&mut self, mut happened: impl FnMut() -> bool) -> bool {
        loop {
            if happened() {
                return true;
            }
            if self.has_ended() {
                return false;
            }
            sleep(Duration::from_micros(500));
        }
    }

    /// Waits for more commits, shard and record; false if it ends before.
    pub fn wait_for_commits(&mut self, place: &Place, more: usize) -> bool {
        let before = place.commits();
        self.wait_until(|| place.commits() >= before + more)
    }

    /// Sends a signal, named without SIG; false if the run has ended.
    pub fn signal(&mut self, name: &str) -> bool {
        let in_time = !self.has_ended();
        if in_time {
            // Should it end just now it takes the signal all the same, until its end is waited for.
            let sent = Command::new("kill").args(["-s", name, &self.id().to_string()]).status();
            assert!(sent.expect("kill runs").success(), "SIG{name} was not sent");
        }
        in_time
    }

    /// Halts it, so that it keeps what it has and does nothing more; false if it has ended.
    pub fn halt(&mut self) -> bool {
        self.signal("STOP");
        let tasks = PathBuf::from(format!("/proc/{}/task", self.id()));
        self.wait_until(|| fs::read_dir(&tasks).is_ok_and(|mut threads| threads.all(|thread| is_halted(thread.ok()))))
    }

    /// Lets it go on.
    pub fn go_on(&mut self) {
        self.signal("CONT");
    }

    /// Ends it at once.
    pub fn kill(&mut self) {
        self.child().kill().expect("killed, or gone");
    }

    /// Waits for its end.
    pub fn end(mut self) -> End {
        let child = self.child.take().expect("there until its end is waited for");
        let Output { status, stdout, stderr } = child.wait_with_output().expect("ends");
        let text = |bytes| String::from_utf8(bytes).expect("text");
        End { code: status.code(), out: text(stdout), err: text(stderr) }
    }
}

impl Drop for Run {
    fn drop(&mut self) {
        if let Some(child) = &mut self.child {
            // It has ended, or the test has failed: neither leaves anything to do about an error.
            let _ = child.kill();
            let _ = child.wait();
        }
    }
}

/// Whether a thread, an entry of `/proc/PID/task`, is halted by a signal.
fn is_halted(thread: Option<DirEntry>) -> bool {
    let stat = thread.and_then(|thread| fs::read_to_string(thread.path().join("stat")).ok()).unwrap_or_default();
    // The state follows the name, which stands in brackets and may have any character.
    stat.rsplit_once(") ").is_some_and(|(_, rest)| rest.starts_with('T'))
}

/// Copies a directory to another, file by file. What vanishes meanwhile is left out, as by `cp` and `rsync`.
pub fn copy(from: &Path, to: &Path) {
    fs::create_dir_all(to).expect("made");
    for entry in fs::read_dir(from).expect("listed") {
        let path = entry.expect("listed").path();
        let target = to.join(path.file_name().expect("a name"));
        if path.is_dir() {
            copy(&path, &target);
            continue;
        }
        match fs::read(&path) {
            Ok(bytes) => fs::write(target, bytes).expect("written"),
            Err(error) => assert_eq!(error.kind(), ErrorKind::NotFound, "{}", path.display()),
        }
    }
}
