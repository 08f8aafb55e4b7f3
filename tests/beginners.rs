//! What a user starts with: sweep files of `init`, completions and manual pages.

use std::fs;
use std::process::Command;

use crate::program::{code, err, out, paths, say};
use tempfile::tempdir;

#[test]
fn the_sweep_files_to_start_from_are_solved_in_seconds() {
    let directory = tempdir().expect("a temporary directory");
    let here = directory.path();
    for (option, next, command, results) in [
        (None, "run", "run", "results.h5"),
        (Some("--laboratory"), "curve", "run", "results.h5"),
        (Some("--surface"), "surface", "surface", "surface.json"),
    ] {
        let name = option.map_or("plain", |option| &option[2..]);
        let file = format!("{name}.toml");
        let printed = out(&say(here, &[&["init"], option.as_slice()].concat()));
        let written = say(here, &[&["init", "-o", file.as_str()], option.as_slice()].concat());
        assert_eq!(code(&written), 0, "{}", err(&written));
        assert_eq!(out(&written), format!("wrote {file}; next: stribeck {next} {file}\n"));
        assert_eq!(fs::read_to_string(here.join(&file)).expect("written"), printed);
        let comments = printed.lines().filter(|line| line.starts_with('#')).count();
        assert!(comments > 10, "{printed}");
        let plan = out(&say(here, &["plan", &file]));
        let run = say(here, &[command, &file, "--quiet"]);
        assert_eq!(code(&run), 0, "{name}: {}{plan}", err(&run));
        assert!(here.join("results").join(name).join(results).exists(), "{name}");
    }
    let curve = say(here, &["curve", "laboratory.toml"]);
    assert_eq!(code(&curve), 0, "{}", err(&curve));
}

#[test]
fn init_writes_over_nothing() {
    let directory = tempdir().expect("a temporary directory");
    let here = directory.path();
    let write = |name: &str| say(here, &["init", "-o", name]);
    fs::write(here.join("empty.toml"), "").expect("written");
    assert_eq!(code(&write("empty.toml")), 0);
    fs::write(here.join("mine.toml"), "# mine\n").expect("written");
    let mut taken = vec!["empty.toml", "mine.toml"];
    #[cfg(unix)]
    {
        std::os::unix::fs::symlink("mine.toml", here.join("link.toml")).expect("linked");
        taken.push("link.toml");
    }
    for name in taken {
        let refused = write(name);
        assert_eq!(code(&refused), 4, "{name}");
        assert!(err(&refused).contains("writes over no file; choose another name with -o"), "{}", err(&refused));
    }
    assert_eq!(fs::read_to_string(here.join("mine.toml")).expect("kept"), "# mine\n");
    let both = say(here, &["init", "--laboratory", "--surface"]);
    assert_eq!(code(&both), 2);
    assert!(err(&both).contains("cannot be used with"), "{}", err(&both));
}

#[test]
fn completions_are_what_the_shells_read() {
    let directory = tempdir().expect("a temporary directory");
    let here = directory.path();
    for (shell, words) in [
        ("bash", ["complete -F _stribeck", "--slide-roll"]),
        ("zsh", ["#compdef stribeck", "--slide-roll"]),
        ("fish", ["complete -c stribeck", "slide-roll"]),
    ] {
        let said = say(here, &["completions", shell]);
        assert_eq!(code(&said), 0, "{}", err(&said));
        assert!(words.iter().all(|word| out(&said).contains(word)), "{shell}");
        fs::write(here.join(shell), out(&said)).expect("written");
        // Where the shell is there it says whether it can read them.
        if let Ok(read) = Command::new(shell).arg("-n").arg(here.join(shell)).output() {
            assert!(read.status.success(), "{shell}: {}", err(&read));
        }
    }
    let script = "source ./bash; COMP_WORDS=(stribeck plo); COMP_CWORD=1; _stribeck stribeck plo stribeck; \
                  echo \"${COMPREPLY[@]}\"";
    let completed = Command::new("bash").args(["-c", script]).current_dir(here).output().expect("bash runs");
    assert_eq!(out(&completed), "plot\n", "{}", err(&completed));
    assert_eq!(code(&say(here, &["completions", "tcsh"])), 2);
}

#[test]
fn every_command_has_a_manual_page() {
    let directory = tempdir().expect("a temporary directory");
    let here = directory.path();
    let written = say(here, &["man", "share/man1"]);
    assert_eq!(code(&written), 0, "{}", err(&written));
    let all = stribeck::commands::command_line();
    let pages = all.get_subcommands().count() + 1;
    assert_eq!(out(&written), format!("{pages} pages in share/man1\n"));
    let text = |name: &str| fs::read_to_string(here.join("share/man1").join(name)).expect(name);
    let names = all.get_subcommands().map(|command| format!("stribeck-{}.1", command.get_name()));
    for name in names.chain(["stribeck.1".to_owned()]) {
        let page = text(&name);
        for word in [".TH stribeck", ".SH NAME", ".SH SYNOPSIS", ".SH EXAMPLES\n.nf\n", ".SH OPTIONS"] {
            assert!(page.contains(word), "{name} has no {word}\n{page}");
        }
    }
    let page = text("stribeck-run.1");
    assert!(page.contains("stribeck run sweeps/quick.toml") && page.contains("\\-\\-accept\\-failures"), "{page}");
    // A second time they are written anew; what is something else stays.
    let before = paths(here);
    assert_eq!(code(&say(here, &["man", "share/man1"])), 0);
    assert_eq!(paths(here), before);
    fs::write(here.join("share/man1/stribeck-plan.1"), "mine").expect("written");
    assert_eq!(code(&say(here, &["man", "share/man1"])), 4);
    assert_eq!(text("stribeck-plan.1"), "mine");
}

#[test]
fn the_version_names_the_commit_where_it_is_known() {
    let directory = tempdir().expect("a temporary directory");
    let said = out(&say(directory.path(), &["--version"]));
    assert_eq!(said, format!("stribeck {}\n", stribeck::VERSION));
    let version = env!("CARGO_PKG_VERSION");
    let rest = said.trim_end().strip_prefix(&format!("stribeck {version}")).expect("it begins so");
    let git = Command::new("git").args(["rev-list", "HEAD"]).current_dir(env!("CARGO_MANIFEST_DIR")).output();
    let of_clone = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join(".git").exists();
    match git.ok().filter(|git| of_clone && git.status.success()) {
        Some(git) if std::env::var_os("STRIBECK_COMMIT").is_none() => {
            let commit = rest.trim_start_matches(" (").trim_end_matches(')').trim_end_matches(", modified");
            // of the last change of the sources, which need not be the last commit
            let is_one = |line: &str| line.starts_with(commit);
            assert!(commit.len() >= 12 && out(&git).lines().any(is_one), "{said}");
        }
        _ => assert!(rest.is_empty() || rest.starts_with(" ("), "{said}"),
    }
}
