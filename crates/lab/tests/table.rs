//! The reader of tables: one table written in every way is one table, and no bytes make it panic.

use std::path::Path;

use proptest::prelude::*;
use proptest::test_runner::RngSeed;
use stribeck_lab::Dimension;
use stribeck_lab::table::{ColumnChoice, Field, Measures, Table, TableFile};

const SPEEDS: &[Dimension] = &[Dimension::Speed];
const FIELDS: [Field; 2] = [
    Field { name: "speed", synonyms: &["slidingspeed"], measures: Measures::Dimensions(SPEEDS) },
    Field { name: "mu", synonyms: &["frictioncoefficient"], measures: Measures::Ratio },
];

/// The numbers of one table, in mm/s and per cent.
const ROWS: [[f64; 2]; 4] = [[1.0, 2.5], [12.25, -3.125], [1.5e3, 1e-3], [0.125, 40.0]];

fn read(bytes: &[u8]) -> TableFile {
    TableFile::of(Path::new("made.csv"), bytes).expect("a table")
}

/// The rows of the fields in SI units.
fn numbers(table: &Table) -> Vec<[f64; 2]> {
    let columns = table.columns(&FIELDS, &[]).expect("both");
    let [speed, mu] = ["speed", "mu"].map(|name| columns.find(name).unwrap_or_else(|| panic!("{name}: {table:?}")));
    table.rows().map(|row| [speed, mu].map(|column| column.value(&row).expect("a number"))).collect()
}

/// Every way of writing: separator, decimal mark, encoding, end of lines, header, quotes and lines above.
#[test]
fn one_table_written_in_every_way_is_one_table() {
    let expected: Vec<[f64; 2]> = read(b"speed (mm/s),mu (%)\n1,2.5\n12.25,-3.125\n1.5e3,1e-3\n0.125,40\n")
        .tables
        .iter()
        .flat_map(numbers)
        .collect();
    assert_eq!(expected.len(), ROWS.len());
    for (row, [speed, mu]) in expected.iter().zip(ROWS) {
        assert!((row[0] / speed * 1e3 - 1.0).abs() < 1e-14 && (row[1] / mu * 1e2 - 1.0).abs() < 1e-14);
    }
    let headers: [(&[&str], &str); 9] = [
        (&["speed (mm/s)", "mu (%)"], ""),
        (&["Speed [mm/s]", "MU [%]"], ""),
        (&["speed / mm/s", "mu / %"], ""),
        (&["SPEED in mm/s", "mu in %"], ""),
        (&["Sliding Speed (mm s-1)", "Friction Coefficient (%)"], ""),
        (&["sliding_speed (mm s^-1)", "friction coefficient (%)"], ""),
        (&["speed", "mu"], "mm/s|%"),
        (&["speed", "mu"], "(mm/s)|[%]"),
        (&["Sliding speed (mm·s⁻¹)", "mu (%)"], ""),
    ];
    let mut ways = 0;
    for (names, units) in headers {
        for separator in ["\t", ";", ",", "  "] {
            for comma in [false, true] {
                for quoted in [false, true] {
                    if comma && separator == "," && !quoted {
                        continue;
                    }
                    let quote = |cell: &str| if quoted { format!("\"{cell}\"") } else { cell.to_owned() };
                    let number = |number: f64| {
                        let text = format!("{number}");
                        quote(&if comma { text.replace('.', ",") } else { text })
                    };
                    let join = |cells: &[String]| cells.join(separator);
                    let mut lines = vec![join(&names.iter().map(|name| quote(name)).collect::<Vec<_>>())];
                    if !units.is_empty() {
                        lines.push(join(&units.split('|').map(quote).collect::<Vec<_>>()));
                    }
                    lines.extend(ROWS.iter().map(|row| join(&row.map(number))));
                    for above in ["", "# a comment", "A gel in water\n\nOperator: nobody\nLoad\t3 N"] {
                        for end in ["\n", "\r\n", "\r"] {
                            let all = above.lines().map(str::to_owned).chain(lines.iter().cloned());
                            let text = all.map(|line| line + end).collect::<String>();
                            for bytes in encoded(&text) {
                                let file = read(&bytes);
                                let found: Vec<[f64; 2]> = file.tables.iter().flat_map(numbers).collect();
                                assert_eq!(found, expected, "{text:?} {}", file.encoding);
                                ways += 1;
                            }
                        }
                    }
                }
            }
        }
    }
    assert!(ways > 5000, "{ways}");
}

/// A text in every encoding that holds it.
fn encoded(text: &str) -> Vec<Vec<u8>> {
    let wide = |mark: [u8; 2], to: fn(u16) -> [u8; 2]| {
        mark.into_iter().chain(text.encode_utf16().flat_map(to)).collect::<Vec<u8>>()
    };
    let latin: Option<Vec<u8>> = text.chars().map(|c| u8::try_from(u32::from(c)).ok()).collect();
    let mut all = vec![
        text.as_bytes().to_vec(),
        ["\u{feff}".as_bytes(), text.as_bytes()].concat(),
        wide([0xff, 0xfe], u16::to_le_bytes),
        wide([0xfe, 0xff], u16::to_be_bytes),
    ];
    all.extend(latin);
    all
}

/// Micro and the degree in Latin-1, a line of units, tabs above rows of blanks: the shape of a rheometer's export.
#[test]
fn a_table_has_its_lines_above_and_its_units_below() {
    let text =
        "T=-10;Mw=94.9;label=made\nV\tTemp\tmu\n\u{b5}m/s\t\u{b0}C\t \n      1     20.1     0.5\n   2.5  20.2   0.25\n";
    let bytes: Vec<u8> = text.chars().map(|c| u8::try_from(u32::from(c)).expect("Latin-1")).collect();
    let file = read(&bytes);
    let [table] = &file.tables[..] else { panic!("{file:?}") };
    assert_eq!(table.above, [(1, "T=-10;Mw=94.9;label=made".to_owned())]);
    let choices = ColumnChoice::list("speed=V").expect("a choice");
    let columns = table.columns(&FIELDS, &choices).expect("both");
    let speed = columns.find("speed").expect("chosen");
    assert_eq!(table.rows().map(|row| speed.value(&row)).collect::<Vec<_>>(), [Some(1e-6), Some(2.5e-6)]);
    assert_eq!(columns.left_out[0].heading, "Temp");
}

#[test]
fn tables_of_one_file_are_kept_apart() {
    let text = "Machine\nSteps:\t2\n\nStep 1 started\nType\tA\tsome words\nZero (N)\t-0.5\t(measured)\nspeed\tmu\n1\t0.5\n2\t0.4\n\n\
                Step 2 started\nType\tB\tmore words\nZero (N)\t-0.4\t(measured)\nspeed\tmu\n3\t0.3\n";
    let file = read(text.as_bytes());
    let rows: Vec<Vec<[f64; 2]>> = file.tables.iter().map(numbers).collect();
    assert_eq!(rows, [vec![[1.0, 0.5], [2.0, 0.4]], vec![[3.0, 0.3]]]);
    assert_eq!(file.tables[1].above.len(), 3);
}

#[test]
fn rows_without_names_are_a_table_of_numbered_columns() {
    let file = read(b"0.1,0.8,0.15\n0.3,0.9,0.14\n");
    let [table] = &file.tables[..] else { panic!("{file:?}") };
    let choices = ColumnChoice::list("speed=#1 (mm/s),mu=#3").expect("choices");
    let columns = table.columns(&FIELDS, &choices).expect("both");
    let value = |name: &str| table.rows().map(|row| columns.find(name)?.value(&row)).collect::<Vec<_>>();
    assert_eq!(value("speed"), [Some(1e-4), Some(3e-4)]);
    assert_eq!(value("mu"), [Some(0.15), Some(0.14)]);
}

/// Words among rows are left out, a comment is none of them, and a cell over two lines is one.
#[test]
fn lines_that_are_no_rows_are_told() {
    let text = "\"speed\n(mm/s)\",mu,remark\n1,0.5,\n# paused\n2,0.4,a\npaused\n3,0.3,b\nend of test\n";
    let file = read(text.as_bytes());
    let [table] = &file.tables[..] else { panic!("{file:?}") };
    assert_eq!(table.rows().map(|row| row.line).collect::<Vec<_>>(), [3, 5, 7]);
    assert_eq!(table.left_out.iter().map(|(line, _)| *line).collect::<Vec<_>>(), [6, 8]);
}

#[path = "laws/table.rs"]
mod law;

/// What fuzzing found or begins with: every file keeps the law.
#[test]
fn findings_keep_the_law() {
    let directory = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/findings/table");
    let files = std::fs::read_dir(directory).expect("a directory").map(|entry| entry.expect("an entry").path());
    let count = files.map(|file| check(&std::fs::read(file).expect("a file"))).count();
    assert!(count >= 15, "{count}");
}

fn check(bytes: &[u8]) {
    law::check(bytes);
    law::check_material(bytes);
}

/// Pieces that tables are made of.
fn piece() -> impl Strategy<Value = String> {
    let pieces = [
        "1",
        "0.5",
        "0,5",
        "-3e4",
        "nan",
        "speed",
        "mu",
        "speed (mm/s)",
        "mm/s",
        "[%]",
        "\"",
        "\"\"",
        ",",
        ";",
        "\t",
        " ",
        "\n",
        "\r\n",
        "\r",
        "#",
        "µ",
        "\u{feff}",
        "=",
        "(",
        ")",
        "error",
        "status",
        "reason",
        "SRR (%)",
        "load (N)",
    ];
    prop_oneof![6 => proptest::sample::select(pieces.to_vec()).prop_map(str::to_owned), 1 => ".{0,3}"]
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 4000, rng_seed: RngSeed::Fixed(2022), failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn no_bytes_make_it_panic(bytes in prop::collection::vec(any::<u8>(), 0..200)) {
        check(&bytes);
    }

    #[test]
    fn no_pieces_of_tables_make_it_panic(pieces in prop::collection::vec(piece(), 0..60)) {
        check(pieces.concat().as_bytes());
    }
}

/// What would take long if it were read again for each cell.
#[test]
fn long_lines_and_open_quotes_take_no_time() {
    let started = std::time::Instant::now();
    for piece in ["\"", "\"\"\"", "\"a,", "\"\",", ",", "1,", "\n", "\"\n", "1,2\n", "a,b\n", "\r", "#\n", "1 "] {
        law::check(piece.repeat(200_000 / piece.len()).as_bytes());
    }
    assert!(started.elapsed().as_secs() < 20, "{:?}", started.elapsed());
}
