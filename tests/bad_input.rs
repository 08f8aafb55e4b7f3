//! The program and input that is meant badly: too much of it, from odd places, under odd names. Every case ends by
//! itself, in bounded memory, with an exit code and a message that leaves the terminal alone.

#![cfg(unix)]

use std::ffi::{OsStr, OsString};
use std::fs::{self, File, OpenOptions};
use std::io::Write;
use std::os::unix::ffi::OsStrExt;
use std::os::unix::fs::symlink;
use std::path::Path;
use std::process::{Command, Output};

use crate::program::{code, err, out, stribeck};
use tempfile::{TempDir, tempdir};

/// Address space of the program in kB: all that it maps, itself and its threads included.
const MEMORY: usize = 1_200_000;

/// Most bytes of a file that is read.
const LARGEST: usize = 8 << 20;

/// Four lines that make a sweep of one case.
const AXES: &str = "[axes]\nf = [0.0]\nalpha = [1.0]\nbeta = [10.0]\n";

/// Runs the program in a directory, in bounded memory. If it hangs it is ended, which no one takes for an exit of its
/// own.
fn bounded<A: AsRef<OsStr>>(directory: &Path, arguments: &[A]) -> Output {
    let program = stribeck(directory);
    let limit = format!("ulimit -v {MEMORY} && exec timeout --signal KILL 300 \"$0\" \"$@\"");
    let mut command = Command::new("bash");
    command.current_dir(directory).arg("-c").arg(limit).arg(program.get_program()).args(arguments);
    let output = command.output().expect("bash starts");
    for text in [out(&output), err(&output)] {
        assert!(!text.chars().any(|c| c.is_control() && c != '\n'), "{text:?}");
        assert!(text.len() < 20_000, "{} bytes are said, beginning with {}", text.len(), &text[..1000]);
    }
    output
}

/// What `stribeck plan` says of a file with this text.
fn plan(text: &str) -> Output {
    let directory = tempdir().expect("a temporary directory");
    fs::write(directory.path().join("bad.toml"), text).expect("written");
    bounded(directory.path(), &["plan", "bad.toml"])
}

fn refused(output: &Output, words: &str) {
    assert_eq!(code(output), 2, "{}", err(output));
    let said = err(output)
        .split(|c: char| c.is_whitespace() || c == '│')
        .filter(|word| !word.is_empty())
        .collect::<Vec<_>>()
        .join(" ");
    assert!(said.contains(words), "{words} is not in {said}");
    assert_eq!(out(output), "");
}

/// A file as large as is read, filled with one thing.
fn full_of(before: &str, thing: &str, after: &str) -> String {
    let text = format!("{before}{}{after}", thing.repeat((LARGEST - before.len() - after.len()) / thing.len()));
    assert!(text.len() > LARGEST - 100 && text.len() <= LARGEST);
    text
}

/// A file as large as is read, filled with things that differ.
fn full_of_different(thing: impl Fn(usize) -> String) -> String {
    let mut text = String::with_capacity(LARGEST);
    for number in 0.. {
        let thing = thing(number);
        if text.len() + thing.len() > LARGEST {
            break;
        }
        text += &thing;
    }
    text
}

#[test]
fn a_sweep_of_a_million_millions_is_refused_at_once() {
    let range = "{ from = 1.0, to = 2.0, points = 10000 }";
    let list = (1..=10_000).map(|value| value.to_string()).collect::<Vec<_>>().join(", ");
    for axis in [range.to_owned(), format!("[{list}]")] {
        let output = plan(&format!("[axes]\nf = {axis}\nalpha = {axis}\nbeta = {axis}\n"));
        refused(&output, "at most 1000000000 cases, this one has 10000 f x 10000 alpha x 10000 beta");
    }
    let most = "{ from = 1.0, to = 2.0, points = 1000000 }";
    refused(&plan(&format!("[axes]\nf = {most}\nalpha = {most}\nbeta = {most}\n")), "at most 1000000000 cases");
}

#[test]
fn a_hundred_megabytes_are_not_read() {
    let directory = tempdir().expect("a temporary directory");
    let mut file = File::create(directory.path().join("large.toml")).expect("created");
    file.write_all(AXES.as_bytes()).expect("written");
    file.set_len(100_000_000).expect("written");
    refused(&bounded(directory.path(), &["plan", "large.toml"]), "larger than 8 MiB");
}

#[test]
fn the_largest_file_that_makes_sense_is_taken() {
    let values = (0..400_000).map(|i| format!("{}.25", i + 1)).collect::<Vec<_>>().join(", ");
    let output = plan(&format!("[axes]\nf = [1.0]\nalpha = [1.0]\nbeta = [{values}]\n# {}", "x".repeat(1 << 20)));
    assert_eq!(code(&output), 0, "{}", err(&output));
    assert!(out(&output).contains("400000 = 1 f x 1 alpha x 400000 beta"), "{}", out(&output));
}

#[test]
fn a_full_file_of_values_texts_or_comments_is_judged() {
    let in_list = |thing: &str| full_of("[axes]\nf = [1.0]\nalpha = [1.0]\nbeta = [", thing, "]\n");
    refused(&plan(&in_list("1,")), "`axes.beta` may have at most 1000000 values");
    refused(&plan(&in_list("1\n,")), "`axes.beta` may have at most 1000000 values");
    refused(&plan(&in_list("'',")), "`axes.beta` may have at most 1000000 values");
    refused(&plan(&in_list("1979-05-27,")), "must be a number");
    let ascending = full_of_different(|number| format!("{},", number + 1));
    refused(
        &plan(&format!("[axes]\nbeta = [1.0]\nalpha = [1.0]\nf = [{}]", &ascending[..LARGEST - 100])),
        "at most 1000000 values",
    );
    let fields = full_of(&format!("{AXES}[output]\nfields = ["), "'pressure',", "]\n");
    refused(&plan(&fields), "only once");

    refused(&plan(&full_of("title = '", "x", &format!("'\n{AXES}"))), "1 to 500 characters");
    refused(&plan(&full_of("title = \"", "\\u0041", &format!("\"\n{AXES}"))), "1 to 500 characters");
    refused(&plan(&full_of("title = \"\"\"", "\n", &format!("\"\"\"\n{AXES}"))), "1 to 500 characters");
    refused(&plan(&full_of("", "x", "")), "key with no value");
    refused(&plan(&full_of("", "\u{1b}", "")), "not valid TOML");
    refused(&plan(&full_of("", "\r", "")), "not valid TOML");
    for comments in ["#", "#\n", "\n", " ", "# τ\r\n"] {
        let output = plan(&full_of(&format!("{AXES}#"), comments, "\n"));
        assert_eq!(code(&output), 0, "{}", err(&output));
    }
}

#[test]
fn a_full_file_of_keys_tables_or_brackets_is_not_parsed() {
    let too_many = "at most 20000 keys, tables and lists";
    for part in ["[", "]", "{", "[[", "a=1\n", "[a]\n", "[[a]]\n", "=\n", "a.", "a={a={a={", "[]\n", "a=[{},[],{}]\n"] {
        refused(&plan(&full_of("", part, "")), too_many);
    }
    refused(&plan(&full_of(&format!("{AXES}[substrate]\nmodes=["), "{share=1,time=1},", "]\n")), too_many);
    refused(&plan(&full_of_different(|number| format!("k{number} = 1\n"))), too_many);
    refused(&plan(&full_of_different(|number| format!("[t{number}]\n"))), too_many);
    refused(&plan(&full_of_different(|number| format!("a{number:x}.a.a.a.a.a.a.a.a.a.a.a.a.a=1\n"))), too_many);
}

#[test]
fn as_many_parts_as_are_parsed_take_little_memory() {
    refused(
        &plan(&(0..250).map(|number| format!("k{number}{}=1\n", ".a".repeat(78))).collect::<String>()),
        "is not a key",
    );
    refused(&plan(&format!("{}{}", "[".repeat(9_000), "]".repeat(9_000))), "not valid TOML");
    refused(&plan(&format!("a = {}", "[".repeat(19_000))), "not valid TOML");
    refused(&plan(&format!("a = {}", "{a=".repeat(9_000))), "not valid TOML");
    refused(&plan(&format!("[{}a]\n", "a.".repeat(19_000))), "not valid TOML");
    refused(&plan(&format!("{}a = 1\n", "a.".repeat(19_000))), "not valid TOML");
}

#[test]
fn a_sweep_comes_from_a_file_or_a_pipe_and_from_nothing_that_has_no_end() {
    let directory = tempdir().expect("a temporary directory");
    let here = directory.path();
    refused(&bounded(here, &["plan", "/dev/zero"]), "larger than 8 MiB");
    refused(&bounded(here, &["plan", "/dev/null"]), "needs `axes`");
    refused(&bounded(here, &["plan", "."]), "name the file in that directory");
    refused(&bounded(here, &["plan", ""]), "a value is required");
    refused(&bounded(here, &["plan", &"x".repeat(5000)]), "cannot read the sweep file");

    let pipe = here.join("pipe");
    assert!(Command::new("mkfifo").arg(&pipe).status().expect("mkfifo starts").success());
    let written = |thing: Vec<u8>, times: usize| {
        let writer = pipe.clone();
        let writer = std::thread::spawn(move || {
            let mut pipe = OpenOptions::new().write(true).open(writer).expect("opened");
            // A reader that has enough goes away.
            (0..times).all(|_| pipe.write_all(&thing).is_ok())
        });
        let output = bounded(here, &["plan", "pipe"]);
        (output, writer.join().expect("it ends"))
    };
    let (output, all) = written(AXES.into(), 1);
    assert!(code(&output) == 0 && all, "{}", err(&output));
    let (output, all) = written(vec![b'#'; 1 << 20], 1000);
    refused(&output, "larger than 8 MiB");
    assert!(!all, "it is not read to its end");
}

/// Names that do something on a terminal, or are no text.
fn odd_names() -> Vec<OsString> {
    let names: [&[u8]; 7] = [
        b"two\nlines",
        b"a\ttab\rreturn\x08",
        b"\x1b[31mred\x1b]0;title\x07",
        "\u{202e}lmot \u{9b}31m \u{2028}".as_bytes(),
        b"not \xff text \xfe",
        b"'quotes' \"double\" `back` $(x) \\ ;",
        &[b'n'; 240],
    ];
    names.map(|name| OsStr::from_bytes(name).to_owned()).into()
}

fn with_file(name: &OsStr, text: &str) -> (TempDir, OsString) {
    let directory = tempdir().expect("a temporary directory");
    let file = [name, OsStr::new(".toml")].into_iter().collect::<OsString>();
    fs::write(directory.path().join(&file), text).expect("written");
    (directory, file)
}

#[test]
fn odd_names_are_said_in_one_line_wherever_they_stand() {
    let lines =
        |name: &OsStr, text: &str, commands: &dyn Fn(&OsStr) -> Vec<Vec<OsString>>| -> Vec<(i32, usize, usize)> {
            let (directory, file) = with_file(name, text);
            let run = |arguments: Vec<OsString>| {
                let output = bounded(directory.path(), &arguments);
                // How fast the run was is only told of one that took some time. Where a long name fills a line, the rest
                // stands indented below.
                let counts = |line: &&str| !line.starts_with("rate ") && !line.starts_with(' ');
                let said = out(&output).lines().filter(counts).count();
                (code(&output), said, err(&output).lines().count())
            };
            commands(&file).into_iter().map(run).collect()
        };
    let words = |words: &[&OsStr]| words.iter().map(|word| (*word).to_owned()).collect::<Vec<_>>();
    let [run, plan, status, verify, quiet, into] = ["run", "plan", "status", "verify", "--quiet", "-o"].map(OsStr::new);
    let good = |file: &OsStr| {
        // Without the ending: the results stand beside the sweep, under a name that is no less odd.
        let results = OsStr::from_bytes(file.as_bytes().strip_suffix(b".toml").expect("as it was named"));
        vec![
            words(&[plan, file]),
            words(&[run, file, quiet]),
            words(&[run, file, quiet, into, results]),
            words(&[plan, file, into, results]),
            words(&[status, results]),
            words(&[verify, results]),
        ]
    };
    let bad = |file: &OsStr| vec![words(&[status, file]), words(&[verify, file]), words(&[plan, file, into, file])];
    let expected = lines(OsStr::new("plain"), AXES, &good);
    assert!(expected.iter().all(|(code, ..)| *code == 0), "{expected:?}");
    let expected_bad = lines(OsStr::new("plain"), AXES, &bad);
    assert!(expected_bad.iter().all(|(code, said, told)| (*code, *said, *told) == (4, 0, 1)), "{expected_bad:?}");
    for name in odd_names() {
        match name.to_str() {
            Some(_) => assert_eq!(lines(&name, AXES, &good), expected, "{name:?}"),
            None => assert_eq!(lines(&name, AXES, &|file| good(file)[..2].to_vec()), expected[..2], "{name:?}"),
        }
        assert_eq!(lines(&name, AXES, &bad), expected_bad, "{name:?}");
    }
}

#[test]
fn a_directory_that_hdf5_cannot_name_is_refused_before_anything_is_solved() {
    let (directory, _) = with_file(OsStr::new("small"), AXES);
    for command in ["run", "plan"] {
        let arguments = [command, "small.toml", "-o"].map(OsStr::new);
        let output = bounded(directory.path(), &[&arguments[..], &[OsStr::from_bytes(b"out \xff")]].concat());
        assert_eq!(code(&output), 4);
        assert!(err(&output).contains("choose another directory with -o"), "{}", err(&output));
        assert_eq!(err(&output).lines().count(), 1);
        assert_eq!(crate::program::paths(directory.path()).len(), 1, "nothing is made");
    }
}

#[test]
fn odd_keys_and_texts_are_shown_harmless() {
    for name in odd_names().iter().filter_map(|name| name.to_str()) {
        for text in [
            name.to_owned(),
            format!("{AXES}'{name}' = 1\n"),
            format!("{name:?} = 1\n{AXES}"),
            format!("title = {name:?}{}\n{AXES}", "x".repeat(500)),
            format!("# {name}\n[axes]\nf = [true] # {name}\n# {name}\n"),
            format!("{AXES}[output]\nfields = ['{name}']\n"),
        ] {
            let output = plan(&text);
            assert_eq!(code(&output), 2, "{text:?}\n{}", err(&output));
        }
        let (directory, file) = with_file(OsStr::new(name), "[axes]\nf = [true]\n");
        let output = bounded(directory.path(), &[OsStr::new("plan"), &file]);
        assert_eq!(code(&output), 2);
        assert!(err(&output).contains(":2:6"), "{}", err(&output));
    }
}

#[test]
fn what_has_no_end_in_a_results_directory_is_not_read() {
    let (directory, _) = with_file(OsStr::new("small"), AXES);
    let here = directory.path();
    let run = || bounded(here, &["run", "small.toml", "--quiet", "-o", "out"]);
    assert_eq!(code(&run()), 0);
    let replaced = |path: &str| {
        fs::remove_file(here.join(path)).expect("removed");
        symlink("/dev/zero", here.join(path)).expect("linked");
    };
    for path in ["out/sweep.toml", "out/summary.csv", "out/log/0002.jsonl"] {
        if here.join(path).exists() {
            replaced(path);
        } else {
            symlink("/dev/zero", here.join(path)).expect("linked");
        }
        for command in [["status", "out"], ["verify", "out"]] {
            let output = bounded(here, &command);
            assert!([0, 4].contains(&code(&output)), "{}", err(&output));
        }
        assert_eq!(code(&bounded(here, &["plan", "small.toml", "-o", "out"])), 0);
        let output = run();
        assert!([0, 4].contains(&code(&output)), "{}", err(&output));
    }
    // A link to a device gives way; the device stays what it is.
    assert!(!Path::new("/dev/zero").is_file() && !Path::new("/dev/null").is_file());
}

#[test]
fn a_log_of_a_hundred_megabytes_without_a_record_takes_little_memory() {
    let (directory, _) = with_file(OsStr::new("small"), AXES);
    let here = directory.path();
    let run = || bounded(here, &["run", "small.toml", "--quiet", "-o", "out"]);
    assert_eq!(code(&run()), 0);
    let log = here.join("out/log/0001.jsonl");
    let whole = fs::read(&log).expect("read");
    let zeros = File::options().append(true).open(&log).expect("opened");
    zeros.set_len(whole.len() as u64 + 100_000_000).expect("written");
    let lines = vec![b'\n'; 100_000_000];
    for (damage, place) in
        [(None, "line 5: it has 100000000 bytes"), (Some(lines), "lines 5 to 100000004: not a whole")]
    {
        if let Some(lines) = damage {
            fs::write(&log, [&whole[..], &lines].concat()).expect("written");
        }
        let output = run();
        assert_eq!(code(&output), 0, "{}", err(&output));
        assert!(err(&output).contains(place), "{}", err(&output));
        assert!(out(&output).contains("nothing to do"), "the records before are whole: {}", out(&output));
    }
}
