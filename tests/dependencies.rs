//! The table of dependencies in CONTRIBUTING.md says what the crates of the workspace need, with the licence of each.

use std::collections::BTreeMap;
use std::path::Path;
use std::process::Command;

use serde_json::Value;

/// What a crate is for, and its licence.
#[derive(Debug)]
struct Row {
    purpose: String,
    licence: String,
}

/// The rows of the table; those with several crates once for each.
fn table() -> BTreeMap<String, Row> {
    let text = include_str!("../CONTRIBUTING.md");
    let (_, rest) = text.split_once("\n| crate | for | licence |\n| --- | --- | --- |\n").expect("the table is there");
    let rows = rest.lines().take_while(|line| line.starts_with('|'));
    rows.flat_map(|line| {
        let cells: Vec<&str> = line.trim_matches('|').split('|').map(str::trim).collect();
        let [crates, purpose, licence] = cells[..] else { panic!("a row of three cells: {line}") };
        crates
            .split(", ")
            .map(|name| {
                let row = Row { purpose: purpose.to_owned(), licence: licence.to_owned() };
                (name.trim_matches('`').to_owned(), row)
            })
            .collect::<Vec<_>>()
    })
    .collect()
}

/// What cargo says of the packages in the tree, for the platform of this machine: others may not be there.
fn metadata() -> Value {
    let said = |command: &mut Command| {
        let output = command.output().expect("it starts");
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        String::from_utf8(output.stdout).expect("text")
    };
    let version = said(Command::new("rustc").arg("-vV"));
    let host = version.lines().find_map(|line| line.strip_prefix("host: ")).expect("rustc names its host");
    let arguments = ["metadata", "--format-version", "1", "--locked", "--offline", "--filter-platform", host];
    let here = Path::new(env!("CARGO_MANIFEST_DIR"));
    serde_json::from_str(&said(Command::new(env!("CARGO")).args(arguments).current_dir(here))).expect("JSON")
}

/// What the crates of the workspace need from elsewhere, and whether tests alone need it.
fn dependencies(metadata: &Value) -> BTreeMap<&str, bool> {
    let members = metadata["workspace_members"].as_array().expect("a list");
    let packages = metadata["packages"].as_array().expect("a list");
    let mut found = BTreeMap::new();
    for package in packages.iter().filter(|package| members.contains(&package["id"])) {
        for dependency in package["dependencies"].as_array().expect("a list") {
            if dependency["path"].is_null() {
                let name = dependency["name"].as_str().expect("a name");
                *found.entry(name).or_insert(true) &= dependency["kind"] == "dev";
            }
        }
    }
    found
}

#[test]
fn the_table_lists_every_dependency_with_its_purpose_and_licence() {
    let (metadata, mut table) = (metadata(), table());
    let packages = metadata["packages"].as_array().expect("a list");
    let dependencies = dependencies(&metadata);
    assert!(dependencies.len() > 20);
    for (name, for_tests) in dependencies {
        let row = table.remove(name).unwrap_or_else(|| panic!("CONTRIBUTING.md has no row for `{name}`"));
        let package = packages.iter().find(|package| package["name"] == name).expect("in the tree");
        let declared = package["license"].as_str().expect("declared").replace('/', " OR ");
        let (licence, _more) = row.licence.split_once(';').unwrap_or((&row.licence, ""));
        assert_eq!(licence, declared, "licence of `{name}`");
        assert_eq!(row.purpose.starts_with("tests"), for_tests, "purpose of `{name}`: {row:?}");
        assert!(row.purpose.len() > 3, "purpose of `{name}`");
    }
    assert!(table.is_empty(), "rows of what is no dependency: {table:?}");
}

#[test]
fn the_licences_that_are_allowed_are_those_that_are_named() {
    let text = include_str!("../CONTRIBUTING.md");
    let (_, rest) = text.split_once("## Dependencies").expect("the section is there");
    let (_, list) = include_str!("../deny.toml").split_once("\nallow = [").expect("a list");
    let allowed: Vec<&str> = list.split(']').next().expect("its end").split('"').skip(1).step_by(2).collect();
    assert!(allowed.len() >= 5);
    let named = rest.split("\n\n").nth(1).expect("a paragraph").replace('\n', " ");
    for licence in &allowed {
        assert!(named.contains(&format!("`{licence}`")), "CONTRIBUTING.md does not name {licence}");
    }
    assert_eq!(named.matches('`').count() / 2, allowed.len() + 2, "the licences, the script and its file: {named}");
}
