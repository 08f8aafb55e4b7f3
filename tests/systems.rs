//! Odd systems and odd places: what the environment, the terminal and the file system do to a run.

use std::fs;
use std::path::Path;
use std::process::{Command, Stdio};
use std::time::Duration;

use tempfile::{TempDir, tempdir};

use crate::program::{code, err, out, say, stribeck};

const SWEEP: &str = "[axes]\nf = [10.0]\nalpha = [1.0]\nbeta = [10.0, 100.0]\n[output]\nfields = []\n";

fn place(sweep: &str) -> TempDir {
    let place = tempdir().expect("a temporary directory");
    fs::write(place.path().join("small.toml"), sweep).expect("written");
    place
}

fn results(place: &Path) -> Vec<u8> {
    fs::read(place.join("results/small/results.h5")).expect("published")
}

/// Sites set these for programs with an HDF5 library of their own.
#[test]
fn variables_of_the_hdf5_library_change_nothing() {
    let reference = place(SWEEP);
    assert_eq!(code(&say(reference.path(), &["run", "small.toml", "-q"])), 0);
    let variables = [
        ("HDF5_DRIVER", "no-such-driver"),
        ("HDF5_DRIVER", "split"),
        ("HDF5_DRIVER", "log"),
        ("HDF5_VOL_CONNECTOR", "async under_vol=0;under_info={}"),
        ("HDF5_PLUGIN_PATH", "/nowhere"),
        ("HDF5_USE_FILE_LOCKING", "TRUE"),
    ];
    for variable in variables {
        let place = place(SWEEP);
        let run =
            stribeck(place.path()).args(["run", "small.toml", "-q"]).envs([variable]).output().expect("it starts");
        assert_eq!(code(&run), 0, "{variable:?}: {}", err(&run));
        assert!(err(&run).is_empty() && results(place.path()) == results(reference.path()), "{variable:?}");
        for command in ["verify", "report", "plot", "status"] {
            let shown = stribeck(place.path()).args([command, "results/small"]).envs([variable]).output();
            assert_eq!(code(&shown.expect("it starts")), 0, "{variable:?}: {command}");
        }
    }
}

/// `nohup` starts a program so, to outlive its terminal.
#[test]
fn a_run_that_ignores_hang_ups_goes_on_ignoring_them() {
    let place = place(&SWEEP.replace("[10.0, 100.0]", "{ from = 1.0, to = 1e6, points = 3001, scale = \"log\" }"));
    let program = stribeck(place.path());
    let mut run = Command::new("sh")
        .args(["-c", "trap '' HUP; exec \"$0\" run small.toml --threads 1 -q"])
        .arg(program.get_program())
        .current_dir(place.path())
        .stdout(Stdio::null())
        .spawn()
        .expect("it starts");
    let shards = place.path().join("results/small/shards");
    while !fs::read_dir(&shards).is_ok_and(|mut entries| entries.next().is_some()) {
        std::thread::sleep(Duration::from_millis(5));
    }
    let sent = Command::new("kill").args(["-HUP", &run.id().to_string()]).status().expect("kill runs");
    assert!(sent.success(), "it was at work");
    assert_eq!(run.wait().expect("it ends").code(), Some(0));
    assert!(place.path().join("results/small/summary.csv").exists());
}

/// A user's sweep file may be linked into a results directory: a run replaces the link, not the file.
#[test]
fn a_linked_sweep_file_is_not_written() {
    let place = place(SWEEP);
    fs::create_dir_all(place.path().join("results/small")).expect("made");
    assert_eq!(code(&say(place.path(), &["run", "small.toml", "-q"])), 0);
    let (copy, mine) = (place.path().join("results/small/sweep.toml"), place.path().join("mine.toml"));
    fs::write(&mine, "precious").expect("written");
    fs::remove_file(&copy).expect("removed");
    std::os::unix::fs::symlink("../../mine.toml", &copy).expect("linked");
    assert_eq!(code(&say(place.path(), &["run", "small.toml", "-q"])), 0);
    assert_eq!(fs::read_to_string(mine).expect("there"), "precious");
    assert_eq!(fs::read_to_string(copy).expect("there"), SWEEP);
}

/// Some other program may have a file of the name of one of ours.
#[test]
fn files_of_others_are_left_alone() {
    let place = place(SWEEP);
    let directory = place.path().join("mine");
    fs::create_dir(&directory).expect("made");
    let run = || say(place.path(), &["run", "small.toml", "-o", "mine", "-q"]);
    for (name, code_then) in [("lock", 4), ("summary.csv", 4), (".draft.stribeck-part", 0)] {
        fs::write(directory.join(name), "precious").expect("written");
        let output = run();
        assert_eq!(code(&output), code_then, "{name}: {}", err(&output));
        assert_eq!(fs::read_to_string(directory.join(name)).expect("there"), "precious");
        fs::remove_file(directory.join(name)).expect("removed");
    }
    fs::write(place.path().join("thesis.tex"), "precious").expect("written");
    fs::remove_file(directory.join("lock")).expect("there was a run");
    std::os::unix::fs::symlink("../thesis.tex", directory.join("lock")).expect("linked");
    assert_eq!(code(&run()), 4, "a lock is no link");
    assert_eq!(fs::read_to_string(place.path().join("thesis.tex")).expect("there"), "precious");
}

/// A pipe without a writer would be waited for, for ever.
#[test]
fn a_pipe_in_the_place_of_a_file_of_ours_is_told() {
    let place = place(SWEEP);
    assert_eq!(code(&say(place.path(), &["run", "small.toml", "-q"])), 0);
    let home = place.path().join("results/small");
    for name in ["results.h5", "timings.csv", "sweep.toml", "log/0001.jsonl", "lock"] {
        let file = home.join(name);
        let content = fs::read(&file).expect("there");
        fs::remove_file(&file).expect("removed");
        rustix::fs::mkfifoat(rustix::fs::CWD, &file, rustix::fs::Mode::from_raw_mode(0o600)).expect("made");
        for arguments in [&["status", "results/small"][..], &["report", "results/small"], &["run", "small.toml", "-q"]]
        {
            let mut command = assert_cmd::Command::from_std(stribeck(place.path()));
            let output = command.args(arguments).timeout(Duration::from_secs(60)).output().expect("it starts");
            assert!(output.status.code().is_some(), "{name}: {arguments:?} waits");
            assert!(!err(&output).contains("panicked"), "{name}: {arguments:?}: {}", err(&output));
        }
        fs::remove_file(&file).expect("removed");
        fs::write(&file, content).expect("written");
    }
}

#[test]
fn no_output_takes_the_place_of_an_input() {
    const LABORATORY: &str = "\
[laboratory]
radius = \"5 mm\"
load = 200.0
relaxed_modulus = \"1.2 MPa\"
poisson_ratio = 0.5
viscosity = \"1 Pa s\"
retardation_time = \"1 s\"
speed = { from = \"1 mm/s\", to = \"1 m/s\", points = 5, scale = \"log\" }
f = [1.0]
";
    let place = place(LABORATORY);
    let points = "speed,mu\n0.01,0.1\n0.1,0.2\n1,0.3\n";
    fs::write(place.path().join("fit.csv"), points).expect("written");
    fs::write(place.path().join("friction.svg"), "my notes").expect("written");
    let refused = |arguments: &[&str], exit: i32| {
        let output = say(place.path(), arguments);
        assert_eq!(code(&output), exit, "{arguments:?}: {}", err(&output));
    };
    refused(&["curve", "small.toml", "--csv", "small.toml"], 2);
    refused(&["curve", "small.toml", "--measured", "fit.csv", "--csv", "fit.csv"], 2);
    refused(&["fit", "fit.csv", "small.toml", "--unknown", "viscosity", "-o", "."], 2);
    fs::rename(place.path().join("fit.csv"), place.path().join("data.csv")).expect("renamed");
    refused(&["fit", "data.csv", "small.toml", "--unknown", "viscosity", "-o", "."], 4);
    assert_eq!(fs::read_to_string(place.path().join("small.toml")).expect("there"), LABORATORY);
    assert_eq!(fs::read_to_string(place.path().join("data.csv")).expect("there"), points);
    assert_eq!(fs::read_to_string(place.path().join("friction.svg")).expect("there"), "my notes");
}

#[test]
fn a_name_that_leads_out_of_the_results_is_refused() {
    let place = place(SWEEP);
    fs::copy(place.path().join("small.toml"), place.path().join("...toml")).expect("copied");
    let run = say(place.path(), &["run", "...toml"]);
    assert_eq!(code(&run), 2, "{}", err(&run));
    assert!(err(&run).contains("name one with -o"), "{}", err(&run));
    assert_eq!(fs::read_dir(place.path()).expect("listed").count(), 2);
}

#[test]
fn a_sweep_that_the_disk_has_no_room_for_is_warned_of() {
    let large = SWEEP.replace("f = [10.0]", "f = { from = 1.0, to = 1e6, points = 100000, scale = \"log\" }");
    let large = large.replace("alpha = [1.0]", "alpha = { from = 1.0, to = 10.0, points = 5000, scale = \"log\" }");
    let place = place(&large.replace("fields = []", "fields = [\"pressure\", \"film_thickness\"]"));
    let plan = say(place.path(), &["plan", "small.toml"]);
    assert_eq!(code(&plan), 0);
    assert!(err(&plan).starts_with("warning: the sweep takes about "), "{}{}", out(&plan), err(&plan));
}

/// The Makefile of docs/how-to/build-systems.md, as it stands there.
#[test]
fn make_asks_once_and_goes_on_after_failed_cases() {
    let text = fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/docs/how-to/build-systems.md")).expect("there");
    let (_, rest) = text.split_once("```make\n").expect("a Makefile");
    let place = tempdir().expect("a temporary directory");
    fs::write(place.path().join("Makefile"), rest.split("```").next().expect("its end")).expect("written");
    fs::create_dir(place.path().join("sweeps")).expect("made");
    // The second case is beyond what can be computed, and fails.
    fs::write(place.path().join("sweeps/small.toml"), SWEEP.replace("100.0]", "1e60]")).expect("written");
    let program = stribeck(place.path());
    let home = Path::new(program.get_program()).parent().expect("a directory").to_owned();
    let path = format!("{}:{}", home.display(), std::env::var("PATH").expect("a path"));
    let make = || Command::new("make").current_dir(place.path()).env("PATH", &path).output().expect("make runs");
    let first = make();
    assert!(first.status.success(), "{}", err(&first));
    assert!(place.path().join("results/small/report.html").exists());
    assert!(out(&make()).contains("Nothing to be done"), "{}", out(&make()));
    // The sweep file is younger, and says the same.
    std::thread::sleep(Duration::from_millis(20));
    fs::File::open(place.path().join("sweeps/small.toml"))
        .and_then(|file| file.set_modified(std::time::SystemTime::now()))
        .expect("touched");
    assert!(out(&make()).contains("stribeck run"), "it is asked once");
    assert!(out(&make()).contains("Nothing to be done"), "and not again");
    assert_eq!(code(&say(place.path(), &["run", "sweeps/small.toml", "-o", "results/small", "-q"])), 3);
}

#[test]
fn much_room_for_fields_is_told_with_the_line_that_saves_it() {
    let many = SWEEP.replace("[1.0]", "{ from = 1.0, to = 10.0, points = 5000, scale = \"log\" }");
    let place = place(&many.replace("[output]\nfields = []\n", ""));
    let plan = say(place.path(), &["plan", "small.toml", "--threads", "1"]);
    assert_eq!(code(&plan), 0, "{}", err(&plan));
    assert!(err(&plan).contains("note: fields at 601 values of x take about "), "{}", err(&plan));
    assert!(err(&plan).contains("fields = [] below [output]"), "{}", err(&plan));
    fs::write(place.path().join("small.toml"), many).expect("written");
    assert!(err(&say(place.path(), &["plan", "small.toml"])).is_empty());
}

#[test]
fn a_data_set_is_named_by_its_file_as_well() {
    let place = place(SWEEP);
    assert_eq!(code(&say(place.path(), &["run", "small.toml", "-q"])), 0);
    for command in ["plot", "report"] {
        let shown = say(place.path(), &[command, "results/small/results.h5"]);
        assert_eq!(code(&shown), 0, "{}", err(&shown));
    }
    assert!(place.path().join("results/small/report.html").exists());
    let inside = say(&place.path().join("results/small"), &["report", "results.h5"]);
    assert_eq!(code(&inside), 0, "{}", err(&inside));
}

/// What an unfinished sweep has can be shown, and the finished one has the bytes of one that nobody looked at.
#[test]
fn an_unfinished_sweep_is_published_in_part_and_says_so() {
    let sweep = SWEEP.replace("f = [10.0]", "f = [1.0, 10.0]").replace("fields = []", "fields = [\"pressure\"]");
    let (undisturbed, unfinished) = (place(&sweep), place(&sweep));
    assert_eq!(code(&say(undisturbed.path(), &["run", "small.toml", "-q"])), 0);
    let here = unfinished.path();
    assert_eq!(code(&say(here, &["run", "small.toml", "-q", "--part", "1/2"])), 0);
    let refused = say(here, &["publish", "results/small"]);
    assert_eq!(code(&refused), 4, "{}", err(&refused));
    assert!(err(&refused).contains("2 of 4 places of the sweep have no case yet"), "{}", err(&refused));
    assert!(!here.join("results/small/results.h5").exists());

    let published = say(here, &["publish", "results/small", "--partial"]);
    assert_eq!(code(&published), 0, "{}", err(&published));
    assert!(out(&published).contains("2 not solved yet: these files are partial"), "{}", out(&published));
    let summary = fs::read_to_string(here.join("results/small/summary.csv")).expect("published");
    assert_eq!(summary.matches("failed,not solved yet,").count(), 2, "{summary}");
    for command in ["plot", "report"] {
        let shown = say(here, &[command, "results/small"]);
        assert_eq!(code(&shown), 0, "{}", err(&shown));
        assert!(err(&shown).contains("is partial: 2 of 4 places are not solved yet"), "{}", err(&shown));
    }

    // The other part is solved now, and what is published is not all of it.
    assert_eq!(code(&say(here, &["run", "small.toml", "-q", "--part", "2/2"])), 0);
    let status = say(here, &["status", "results/small"]);
    assert!(out(&status).contains("stopped, all cases were tried, but not yet published"), "{}", out(&status));

    assert_eq!(code(&say(here, &["run", "small.toml", "-q"])), 0);
    assert!(results(here) == results(undisturbed.path()));
    let whole = say(here, &["publish", "results/small"]);
    assert!(code(&whole) == 0 && out(&whole).contains("in place already"), "{}{}", out(&whole), err(&whole));
    assert_eq!(code(&say(here, &["publish", "nowhere"])), 2);
    assert!(!here.join("nowhere").exists());
}

#[test]
fn a_sweep_comes_from_the_standard_input_as_well() {
    let (file, place) = (place(SWEEP), tempdir().expect("a temporary directory"));
    assert_eq!(code(&say(file.path(), &["run", "small.toml", "-q", "-o", "out"])), 0);
    let mut run = assert_cmd::Command::from_std(stribeck(place.path()));
    let output = run.args(["run", "-", "-o", "out", "-q"]).write_stdin(SWEEP).output().expect("it starts");
    assert_eq!(code(&output), 0, "{}", err(&output));
    let summary = |place: &Path| fs::read(place.join("out/summary.csv")).expect("published");
    assert!(summary(place.path()) == summary(file.path()));
    let mut run = assert_cmd::Command::from_std(stribeck(place.path()));
    let output = run.args(["plan", "-"]).write_stdin("[axes]\nf = [-1.0]\n").output().expect("it starts");
    assert!(code(&output) == 2 && err(&output).contains("stdin:2:6: "), "{}", err(&output));
}

/// Open files have names as well: `/dev/stdout`, or `/dev/fd/63` of a process substitution.
#[test]
fn an_output_may_be_an_open_file() {
    let place = place("[axes]\nf = 10.0\nalpha = 1.0\nbeta = [10.0, 100.0]\n[output]\nfields = []\n");
    assert_eq!(code(&say(place.path(), &["run", "small.toml", "-q"])), 0);
    let expected = say(place.path(), &["report", "results/small", "-o", "page.html"]);
    assert_eq!(code(&expected), 0, "{}", err(&expected));
    let page = fs::read_to_string(place.path().join("page.html")).expect("written");
    let to_pipe = say(place.path(), &["report", "results/small", "-o", "/dev/stdout"]);
    assert!(code(&to_pipe) == 0 && out(&to_pipe).starts_with(&page), "{}", err(&to_pipe));
    let script = "exec 7> seven.html; \"$0\" report results/small -o /dev/fd/7";
    let program = stribeck(place.path());
    let to_file = Command::new("sh").args(["-c", script]).arg(program.get_program()).current_dir(place.path()).output();
    assert_eq!(code(&to_file.expect("sh runs")), 0);
    assert!(fs::read_to_string(place.path().join("seven.html")).expect("written") == page);
    let full = say(place.path(), &["report", "results/small", "-o", "/dev/full"]);
    assert!(code(&full) == 4 && err(&full).contains("cannot write /dev/full: No space left"), "{}", err(&full));
    // What only looks like one is a file as any other.
    let shared = tempfile::NamedTempFile::new_in("/dev/shm").expect("a file in memory");
    fs::write(shared.path(), "precious").expect("written");
    let foreign = say(place.path(), &["report", "results/small", "-o", &shared.path().to_string_lossy()]);
    assert_eq!(code(&foreign), 4, "{}", err(&foreign));
    assert_eq!(fs::read_to_string(shared.path()).expect("there"), "precious");
    assert!(!Path::new("/dev/full").is_file());
}
