//! A list of cases in a file.

use std::collections::HashMap;
use std::fs;

use tempfile::tempdir;

use crate::program::{code, err, out, say};

const SWEEP: &str = "\
[axes]
f = [0.0, 10.0]
alpha = [0.1, 1.0]
beta = [30.0, 1000.0]
[output]
fields = []
";

/// The rows of a table, by its column names.
fn rows(text: &str) -> Vec<HashMap<String, String>> {
    csv::Reader::from_reader(text.as_bytes()).deserialize().map(|row| row.expect("a row")).collect()
}

#[test]
fn a_list_has_the_ids_and_the_numbers_of_a_sweep_in_its_own_order() {
    let home = tempdir().expect("a temporary directory");
    fs::write(home.path().join("s.toml"), SWEEP).expect("written");
    assert_eq!(code(&say(home.path(), &["run", "s.toml", "-q"])), 0);
    let published = rows(&fs::read_to_string(home.path().join("results/s/summary.csv")).expect("published"));
    let mut list = "name,beta,alpha,f\n".to_owned();
    for row in published.iter().rev() {
        list += &format!("x,{},{},{}\n", row["beta"], row["alpha"], row["f"]);
    }
    fs::write(home.path().join("list.csv"), list).expect("written");
    let solved = say(home.path(), &["solve", "--batch", "list.csv"]);
    assert_eq!(code(&solved), 0, "{}", err(&solved));
    let solved = rows(&out(&solved));
    assert_eq!(solved.len(), published.len());
    for (row, expected) in solved.iter().zip(published.iter().rev()) {
        assert_eq!(row.len(), expected.len(), "the columns of a summary");
        for name in ["case", "f", "alpha", "beta", "status"] {
            assert_eq!(row[name], expected[name]);
        }
        for name in ["mu_v", "mu_h", "mu_drag", "c"] {
            let [found, expected] = [row, expected].map(|row| row[name].parse::<f64>().expect("a number"));
            assert!((found - expected).abs() <= 2e-5 * expected.abs(), "{name}: {found} {expected}");
        }
    }
}

#[test]
fn modes_and_ratios_may_stand_in_a_list() {
    let home = tempdir().expect("a temporary directory");
    fs::write(
        home.path().join("list.csv"),
        "f,alpha,beta,modes,slide_roll\n10,1,100,,0.5\n10,1,100,\"0.5:1,0.5:10\",1\n",
    )
    .expect("written");
    let solved = say(home.path(), &["solve", "--batch", "list.csv"]);
    assert_eq!(code(&solved), 0, "{}", err(&solved));
    let solved = rows(&out(&solved));
    let alone = |more: &[&str]| {
        let one = [&["solve", "--alpha", "1", "--beta", "100", "--f", "10", "--json"], more].concat();
        let one = say(home.path(), &one);
        serde_json::from_str::<serde_json::Value>(&out(&one)).expect("JSON")
    };
    for (row, alone) in solved.iter().zip([alone(&["--slide-roll", "0.5"]), alone(&["--modes", "0.5:1,0.5:10"])]) {
        assert_eq!(row["case"], alone["case"].as_str().expect("an id"));
        let (found, expected) =
            (row["mu_drag"].parse::<f64>().expect("a number"), alone["mu_drag"].as_f64().expect("one"));
        assert!((found - expected).abs() <= 2e-5 * expected, "{found} {expected}");
    }
}

/// Modes of the roller are passed at the speed of its surface, so a case of a list is that of `solve` at each ratio.
#[test]
fn a_soft_roller_turns_as_fast_as_the_ratio_says() {
    let home = tempdir().expect("a temporary directory");
    let bodies = ["--modes", "0.5:1", "--roller-modes", "0.5:1"];
    fs::write(home.path().join("list.csv"), "f,alpha,beta,slide_roll\n10,1,100,1\n10,1,100,0.5\n10,1,100,0\n")
        .expect("written");
    let solved = say(home.path(), &[&["solve", "--batch", "list.csv"][..], &bodies].concat());
    assert_eq!(code(&solved), 0, "{}", err(&solved));
    let solved = rows(&out(&solved));
    for (row, ratio) in solved.iter().zip(["1", "0.5", "0"]) {
        let one = ["solve", "--alpha", "1", "--beta", "100", "--f", "10", "--json", "--slide-roll", ratio];
        let one = say(home.path(), &[&one[..], &bodies].concat());
        let one: serde_json::Value = serde_json::from_str(&out(&one)).expect("JSON");
        assert_eq!((row["f"].as_str(), row["alpha"].as_str()), ("10.0", "1.0"));
        assert_eq!(row["case"], one["case"].as_str().expect("an id"), "{ratio}");
        for name in ["mu_drag", "mu_v", "mu_v_roller"] {
            let (found, expected) = (row[name].parse::<f64>().expect("a number"), one[name].as_f64().expect("one"));
            assert!((found - expected).abs() <= 2e-5 * expected.abs(), "{name} at {ratio}: {found} {expected}");
        }
    }
    for more in [&["--alpha", "inf", "--beta", "10", "--f", "1"][..], &["--batch", "list.csv"]] {
        let at_rest = say(home.path(), &[&["solve", "--slide-roll", "-1"], more, &bodies].concat());
        assert!(code(&at_rest) == 2 && err(&at_rest).contains("alpha tells no time of a roller"), "{}", err(&at_rest));
    }
}

#[test]
fn what_is_wrong_in_a_list_is_told_with_its_line() {
    let home = tempdir().expect("a temporary directory");
    for (list, said) in [
        ("f,alpha\n1,1\n", "it has no column `beta`"),
        ("f,alpha,beta\n", "no case below its first line"),
        ("f,alpha,beta\n1,1,10\n1,1,-10\n", "line 3: `beta` must be a finite number above 0, found `-10`"),
        ("f,alpha,beta\n1e999,1,10\n", "line 2: `f` must be a finite number"),
        ("f,alpha,beta\n1,1\n", "found record with 2 fields"),
        ("f,alpha,beta,modes\n1,1,10,0.5:1\n", "line 2: `modes`: "),
    ] {
        fs::write(home.path().join("list.csv"), list).expect("written");
        let refused = say(home.path(), &["solve", "--batch", "list.csv"]);
        assert_eq!(code(&refused), 2, "{list}: {}", err(&refused));
        assert!(err(&refused).contains(said), "{list}: {}", err(&refused));
    }
    fs::write(home.path().join("list.csv"), "f,alpha,beta\n1,1,100\n").expect("written");
    let at_rest = say(home.path(), &["solve", "--batch", "list.csv", "--slide-roll", "-1"]);
    assert!(code(&at_rest) == 2 && err(&at_rest).contains("the flat is at rest"), "{}", err(&at_rest));
    assert_eq!(code(&say(home.path(), &["solve", "--batch", "list.csv", "--alpha", "1"])), 2);
    assert_eq!(code(&say(home.path(), &["solve", "--alpha", "1"])), 2);
}
