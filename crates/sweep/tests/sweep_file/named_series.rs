//! `relaxation = { file = "…" }`: what is kept stands alone.

use std::fs;
use std::path::Path;

use stribeck_sweep::{CaseId, Plan, Sweep};
use tempfile::{TempDir, tempdir};

const ABAQUS: &str = "*ELASTIC, MODULI=INSTANTANEOUS\n6.5, .5\n*VISCOELASTIC, TIME=PRONY\n.375, 0., .01\n.25, 0., 5.\n";
const LABORATORY: &str =
    "[laboratory]\nradius = 0.002\nload = 100.0\nviscosity = 5.1\npoisson_ratio = 0.5\nspeed = [0.01, 0.1]\n";

/// A folder with a sweep file and a series beside it.
fn folder(sweep: &str, series: &str) -> TempDir {
    let folder = tempdir().expect("a temporary directory");
    fs::create_dir(folder.path().join("series")).expect("made");
    fs::write(folder.path().join("series/rubber.inp"), series).expect("written");
    fs::write(folder.path().join("sweep.toml"), sweep).expect("written");
    folder
}

fn read(folder: &Path) -> Result<Sweep, String> {
    Sweep::read(folder.join("sweep.toml")).map_err(|error| format!("{error}; {}", error.remedy()))
}

fn ids(sweep: &Sweep) -> Vec<CaseId> {
    let plan = Plan::new(sweep);
    plan.chains().flat_map(|chain| plan.ids(&chain)).collect()
}

/// The text that is kept is a sweep without a file beside it, with the same cases; written by hand, they are the same.
#[test]
fn what_is_kept_has_the_terms_and_no_file() {
    let section = "relaxation = { file = \"series/rubber.inp\", modulus_unit = \"MPa\" } # of a friend\n";
    let by_hand = "relaxation = [{ fraction = 0.375, time = 0.01 }, { fraction = 0.25, time = 5.0 }]\n";
    for modulus in ["instantaneous_modulus = 6.5e6\n", "relaxed_modulus = 2e6\n", ""] {
        let text = format!("{LABORATORY}[substrate]\n{modulus}{section}[solver]\ntolerance = 1e-4\n");
        let sweep = read(folder(&text, ABAQUS).path()).expect("a sweep");
        assert!(!sweep.text.contains("file =") && sweep.text.contains("# series/rubber.inp"), "{}", sweep.text);
        let kept = Sweep::parse("sweep", &sweep.text).expect("stands alone");
        assert_eq!(kept, sweep);
        let known = if modulus.is_empty() { "instantaneous_modulus = 6.5e6\n" } else { modulus };
        let by_hand = format!("{LABORATORY}[substrate]\n{known}{by_hand}[solver]\ntolerance = 1e-4\n");
        let by_hand = Sweep::parse("sweep", &by_hand).expect("a sweep");
        assert_eq!((&by_hand.grid, &by_hand.substrate), (&sweep.grid, &sweep.substrate));
        assert_eq!(ids(&by_hand), ids(&kept));
    }
}

/// Another content of the file is another sweep: no stored result is taken for it.
#[test]
fn a_file_that_changes_is_another_sweep() {
    let text =
        format!("{LABORATORY}[substrate]\nrelaxed_modulus = 2e6\nrelaxation = {{ file = \"series/rubber.inp\" }}\n");
    let folder = folder(&text, ABAQUS);
    let before = read(folder.path()).expect("a sweep");
    fs::write(folder.path().join("series/rubber.inp"), ABAQUS.replace(".25,", ".26,")).expect("written");
    let after = read(folder.path()).expect("a sweep");
    assert!(before.text != after.text && before.substrate != after.substrate);
    assert!(ids(&before).iter().all(|id| !ids(&after).contains(id)));
}

/// In a sweep without quantities of the laboratory fractions need no modulus, and the unit is not asked for.
#[test]
fn a_dimensionless_sweep_takes_the_fractions() {
    let text = "[axes]\nalpha = [1.0]\nbeta = [10.0]\n[substrate]\nrelaxation = { file = \"series/rubber.inp\" }\n";
    let sweep = read(folder(text, ABAQUS).path()).expect("a sweep");
    assert_eq!(Sweep::parse("sweep", &sweep.text).expect("stands alone"), sweep);
    // one in a line is written anew as well
    let text = "substrate = { relaxation = { file = \"series/rubber.inp\" } }\n[axes]\nalpha = [1.0]\nbeta = [10.0]\n";
    let sweep = read(folder(text, ABAQUS).path()).expect("a sweep");
    assert_eq!(Sweep::parse("sweep", &sweep.text).expect("stands alone"), sweep);
}

#[test]
fn what_is_no_series_is_told_with_both_places() {
    let with = |substrate: &str| format!("[axes]\nalpha = [1.0]\nbeta = [10.0]\n{substrate}");
    let named = |rest: &str| with(&format!("[substrate]\nrelaxation = {{ file = \"series/rubber.inp\"{rest} }}\n"));
    for (sweep, series, said) in [
        (named(""), ABAQUS.replace(".25,", "x,"), &["sweep.toml:5:23", "rubber.inp:5:1", "must be a number"][..]),
        (named(""), ABAQUS.replace(".25,", ".625,"), &["sweep.toml:5:14", "1.0000", "per cent"]),
        (named(""), "omega,storage,loss\n1,2,3\n2,3,4\n".to_owned(), &["measured moduli", "stribeck material"]),
        (named(", modulus_unit = \"mm\""), ABAQUS.to_owned(), &["unit of a modulus"]),
        (named("").replace("rubber", "absent"), ABAQUS.to_owned(), &["sweep.toml:5:23", "absent.inp"]),
        (
            with("substrate = { relaxation = { file = \"series/rubber.inp\", modulus_unit = \"MPa\" } }\n")
                .replace("[axes]\nalpha = [1.0]\nbeta = [10.0]\n", "axes = { alpha = [1.0], beta = [10.0] }\n"),
            ABAQUS.to_owned(),
            &["written in one line", "[substrate]"],
        ),
    ] {
        let error = read(folder(&sweep, &series).path()).expect_err("no series");
        assert!(said.iter().all(|word| error.contains(word)), "{error}");
    }
    let error = Sweep::parse("sweep", &named("")).expect_err("no folder").to_string();
    assert!(error.contains("a file can be named in a sweep file only"), "{error}");
}
