//! Tables in any dialect are read back the same: numbers of any size, and what instruments export.

use std::path::Path;

use proptest::prelude::*;
use proptest::test_runner::RngSeed;
use stribeck_lab::table::{Field, Measures, TableFile};
use stribeck_lab::{Dimension, MaterialFile, MaterialOptions, Measured};

/// What the columns hold; none is a ratio, so that units have to be found.
const FIELDS: [Field; 4] = [
    Field { name: "speed", synonyms: &["geschwindigkeit"], measures: Measures::Dimensions(&[Dimension::Speed]) },
    Field { name: "load", synonyms: &["linienlast"], measures: Measures::Dimensions(&[Dimension::LineLoad]) },
    Field { name: "viscosity", synonyms: &["viskosität"], measures: Measures::Dimensions(&[Dimension::Viscosity]) },
    Field { name: "time", synonyms: &["zeit"], measures: Measures::Dimensions(&[Dimension::Time]) },
];
/// The SI units of these, as people write them.
const UNITS: [&str; 4] = ["m/s", "N/m", "Pa s", "s"];

/// How a table is written.
#[derive(Clone, Debug)]
struct Dialect {
    separator: &'static str,
    decimal: char,
    is_quoted: bool,
    /// 0 to 3: none, in brackets behind the name, behind a slash, in a line of their own.
    units: usize,
    /// True for the second name of each field.
    in_german: bool,
    above: &'static str,
    end: &'static str,
    encoding: usize,
    /// True where each line ends with a separator.
    has_empty_end: bool,
    exponent: &'static str,
}

fn dialect() -> impl Strategy<Value = Dialect> {
    let separator = prop::sample::select(vec!["\t", ";", ",", "  ", ", ", "; "]);
    let decimal = prop::sample::select(vec!['.', ',']);
    let above = vec!["", "# made up\n", "Machine 3\nDate:;12/3\n\n", "\n\nOperator\tnobody\n", "T=25;Mw=3;chem=PI;\n"];
    let end = prop::sample::select(vec!["\n", "\r\n", "\r"]);
    let exponent = prop::sample::select(vec!["", "e", "E", "E+"]);
    let flags = (any::<bool>(), any::<bool>(), any::<bool>());
    let numbers = (0..4_usize, 0..5_usize);
    (separator, decimal, prop::sample::select(above), end, exponent, flags, numbers).prop_map(
        |(separator, decimal, above, end, exponent, (quoted, in_german, has_empty_end), (units, encoding))| Dialect {
            separator,
            decimal,
            // what separates must not stand in numbers without quotes
            is_quoted: quoted || (decimal == ',' && separator.starts_with(',')),
            units,
            in_german,
            above,
            end,
            encoding,
            has_empty_end: has_empty_end && separator != "  ",
            exponent,
        },
    )
}

/// A number as its text: digits, how many of them stand behind the mark, and a power of ten.
fn number() -> impl Strategy<Value = (i64, u32, i32)> {
    (-9_999_999..9_999_999_i64, 0..6_u32, -12..12_i32)
}

impl Dialect {
    /// A number in this dialect.
    fn number(&self, (digits, behind, power): (i64, u32, i32)) -> String {
        let text = format!("{:.*}", behind as usize, digits as f64 / 10_f64.powi(behind as i32));
        let text = text.replace('.', &self.decimal.to_string());
        match self.exponent {
            "" => text,
            "E+" if power < 0 => format!("{text}E{power:03}"),
            "E+" => format!("{text}E+{power:03}"),
            mark => format!("{text}{mark}{power}"),
        }
    }

    fn line(&self, cells: impl Iterator<Item = String>) -> String {
        let quote = |cell: String| if self.is_quoted { format!("\"{cell}\"") } else { cell };
        let mut line = cells.map(quote).collect::<Vec<_>>().join(self.separator);
        if self.has_empty_end {
            line += self.separator.trim_end_matches(' ');
        }
        line + "\n"
    }

    fn text(&self, columns: usize, rows: &[Vec<(i64, u32, i32)>]) -> String {
        // a name of two words, or a unit of them, is one between other separators than blanks alone
        let field = |column: usize| if self.in_german { FIELDS[column].synonyms[0] } else { FIELDS[column].name };
        let unit = |column: usize| UNITS[column].replace(' ', if self.separator == "  " { "·" } else { " " });
        let name = |column: usize| match self.units {
            1 => format!("{} ({})", field(column), unit(column)),
            2 => format!("{} / {}", field(column), unit(column)),
            _ => field(column).to_owned(),
        };
        let mut text = self.above.to_owned() + &self.line((0..columns).map(name));
        if self.units == 3 {
            text += &self.line((0..columns).map(unit));
        }
        for row in rows {
            text += &self.line(row[..columns].iter().map(|number| self.number(*number)));
        }
        text.replace('\n', self.end)
    }
}

/// A text in one of five encodings.
fn encoded(text: &str, encoding: usize) -> Vec<u8> {
    let wide = |mark: &[u8], to: fn(u16) -> [u8; 2]| {
        mark.iter().copied().chain(text.encode_utf16().flat_map(to)).collect::<Vec<u8>>()
    };
    match encoding {
        0 => text.as_bytes().to_vec(),
        1 => ["\u{feff}".as_bytes(), text.as_bytes()].concat(),
        2 => wide(&[0xff, 0xfe], u16::to_le_bytes),
        3 => wide(&[0xfe, 0xff], u16::to_be_bytes),
        _ => text.chars().map(|c| u8::try_from(u32::from(c)).expect("Latin-1")).collect(),
    }
}

/// The numbers of a file, by rows, in the order of the fields.
fn read(bytes: &[u8], columns: usize) -> Vec<Vec<Option<f64>>> {
    let file = TableFile::of(Path::new("made.csv"), bytes).unwrap_or_else(|error| panic!("{error}"));
    let [table] = &file.tables[..] else { panic!("{:?}", file.tables) };
    let found = table.columns(&FIELDS, &[]).unwrap_or_else(|what| panic!("{what}"));
    let found = FIELDS[..columns].iter().map(|field| found.find(field.name).unwrap_or_else(|| panic!("{table:?}")));
    let found: Vec<_> = found.collect();
    table.rows().map(|row| found.iter().map(|column| column.value(&row)).collect()).collect()
}

proptest! {
    #![proptest_config(ProptestConfig {
        cases: 3000,
        rng_seed: RngSeed::Fixed(2022),
        failure_persistence: None,
        ..ProptestConfig::default()
    })]

    #[test]
    fn numbers_are_read_back_in_every_dialect(
        dialect in dialect(),
        columns in 2..=4_usize,
        rows in prop::collection::vec(prop::collection::vec(number(), 4), 2..8),
    ) {
        let plain = Dialect { decimal: '.', ..dialect.clone() };
        let exact = |number: &(i64, u32, i32)| Some(plain.number(*number).parse::<f64>().expect("a number"));
        let expected: Vec<Vec<_>> = rows.iter().map(|row| row[..columns].iter().map(exact).collect()).collect();
        let text = dialect.text(columns, &rows);
        prop_assert_eq!(read(&encoded(&text, dialect.encoding), columns), expected, "{:?}", text);
    }
}

/// Two steps of a traction machine.
const TRACTION: &str = include_str!("findings/table/steps-of-readings.txt");
/// Two steps of a rheometer, each with names and units of its own.
const STEPS: &str = "Filename\tmade up\nInstrument\tG2\n[step]\nFrequency sweep - 1\n\
    Angular frequency\tStorage modulus\tLoss modulus\tTan(delta)\tTemperature\nrad/s\tPa\tPa\t\t°C\n\
    0.1\t100.5\t10.25\t0.102\t25.0\n1\t120\t15\t0.125\t25.1\n10.5\t150\t20\t0.133\t25.0\n\
    [step]\nFrequency sweep - 2\n\
    Angular frequency\tStorage modulus\tLoss modulus\tTan(delta)\tTemperature\nrad/s\tPa\tPa\t\t°C\n\
    0.1\t90.5\t9.5\t0.105\t35.0\n1\t105\t12\t0.114\t35.0\n10.5\t130.25\t16.5\t0.127\t35.1\n";
/// An interval of a rheometer, whose names stand behind a word.
const INTERVAL: &str = "Project:\tmade up\nTest:\t3\n\nResult:\tFrequency sweep 1\n\nInterval and data points:\t1\t3\n\
    Interval data:\tPoint No.\tAngular Frequency\tStorage Modulus\tLoss Modulus\tLoss Factor\tStatus\n\
    \t\t[rad/s]\t[kPa]\t[kPa]\t[1]\t\n\
    \t1\t0.1\t1.05\t0.1\t0.095\tDy_\n\t2\t1.5\t1.2\t0.15\t0.125\tDy_\n\t3\t10\t1.55\t0.25\t0.161\tDy_\n";
/// A melt in the manner of RepTate.
const MELT: &str = "T=-10;Mw=94.9;chem=PI;label=made up\nFreq\tG'\tG\"\tTemp\tStrain\nrad/s\tPa\tPa\t°C\t%\n\
    100\t3.9E5\t82274.5\t-9.99\t0.97\n68.1\t3.7E5\t74797\t-10.01\t0.96\n46.4\t3.6E5\t70832\t-9.98\t0.96\n";

/// A table of tabs and decimal points as spreadsheets and instruments of other countries write it.
fn rewritten(text: &str) -> Vec<(String, Vec<u8>)> {
    let mut all = Vec::new();
    for (separator, decimal) in [("\t", '.'), ("\t", ','), (";", '.'), (";", ','), (",", '.'), (",", ',')] {
        let cell = |cell: &str| match cell.parse::<f64>() {
            Ok(_) if separator == "," && decimal == ',' => format!("\"{}\"", cell.replace('.', ",")),
            Ok(_) => cell.replace('.', &decimal.to_string()),
            Err(_) => cell.to_owned(),
        };
        let line = |line: &str| line.split('\t').map(cell).collect::<Vec<_>>().join(separator);
        let text: String = text.lines().map(|text| line(text) + "\n").collect();
        for end in ["\n", "\r\n", "\r"] {
            let text = text.replace('\n', end);
            for encoding in 0..5 {
                let bytes = encoded(&text, encoding);
                all.push((format!("{separator:?} {decimal:?} {end:?} {encoding}: {text}"), bytes));
            }
        }
    }
    all
}

/// What instruments export is the same in every dialect.
#[test]
fn exports_are_the_same_in_every_dialect() {
    let friction = |bytes: &[u8]| {
        let found = Measured::of(Path::new("made.txt"), bytes, &[], None);
        found.map(|(points, _)| points).map_err(|error| error.to_string())
    };
    let expected = friction(TRACTION.as_bytes()).expect("steps");
    for (dialect, bytes) in rewritten(TRACTION) {
        assert_eq!(friction(&bytes).as_ref(), Ok(&expected), "{dialect}");
    }
    let options = MaterialOptions { is_shear: true, poisson_ratio: Some(0.5), ..MaterialOptions::default() };
    let material = |bytes: &[u8]| {
        let found = MaterialFile::of(Path::new("made.txt"), bytes, &options);
        found.map(|file| file.data).map_err(|error| error.to_string())
    };
    for text in [STEPS, INTERVAL, MELT] {
        let expected = material(text.as_bytes()).expect("moduli");
        for (dialect, bytes) in rewritten(text) {
            assert_eq!(material(&bytes).as_ref(), Ok(&expected), "{dialect}");
        }
    }
}
