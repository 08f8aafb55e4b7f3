//! Measured friction from a CSV file: to be laid over solutions, and to be fitted.

use std::fs::File;
use std::io::{self, Read};
use std::path::{Path, PathBuf};

use crate::units::in_si;
use crate::{Experiment, LaboratoryQuantity};
use stribeck_input::{printable, shown};

/// Names of columns that hold friction coefficients, with the column of the results that they are compared with.
const FRICTION: [(&str, &str); 5] =
    [("mu", "mu_drag"), ("mu_drag", "mu_drag"), ("mu_tot", "mu_tot"), ("mu_v", "mu_v"), ("mu_h", "mu_h")];
/// Name of the column of the standard error of the friction coefficient.
const ERROR: &str = "error";
/// Numbers without a unit that say where a point belongs.
const DIMENSIONLESS: [&str; 3] = ["f", "alpha", "beta"];
/// Most bytes of a file that are read.
const MOST_BYTES: u64 = 64 << 20;

/// Measured points: a friction coefficient and where it was measured, in SI units.
#[derive(Clone, Debug, PartialEq)]
pub struct Measured {
    /// The file, for messages.
    pub path: PathBuf,
    /// The column of the results that the friction coefficients are compared with.
    pub column: &'static str,
    /// The friction coefficients.
    pub friction: Vec<f64>,
    /// Their standard errors, if the file has them.
    pub errors: Option<Vec<f64>>,
    /// Line of each point in the file, from 1.
    pub lines: Vec<u64>,
    /// Names of the columns that say where a point belongs, each with a value for each point.
    pub coordinates: Vec<(&'static str, Vec<f64>)>,
}

/// The reason why a file of measured points is refused.
#[derive(Debug, thiserror::Error)]
pub enum MeasuredError {
    /// The file cannot be read.
    #[error("cannot read the measured points {}: {source}; check the path", shown(path))]
    Unreadable {
        /// The file.
        path: PathBuf,
        /// What the system said.
        #[source]
        source: io::Error,
    },
    /// The file is not a table of measured points.
    #[error("{}: {what}", shown(path))]
    NotATable {
        /// The file.
        path: PathBuf,
        /// What is wrong, and what to do.
        what: String,
    },
    /// A value is not allowed.
    #[error("{}:{line}: {column} = {:?} is not allowed: {allowed}", shown(path), printable(value))]
    Value {
        /// The file.
        path: PathBuf,
        /// Line, from 1.
        line: u64,
        /// Name of the column.
        column: String,
        /// The text found.
        value: String,
        /// What is allowed.
        allowed: &'static str,
    },
}

/// The content of a column; a coordinate has its factor to SI units.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Role {
    Friction(&'static str),
    Error,
    Coordinate(&'static str, f64),
}

impl Role {
    /// True for a value that the column may have.
    fn admits(self, value: f64) -> bool {
        match self {
            Role::Friction(_) => true,
            Role::Error => value > 0.0,
            Role::Coordinate(name, _) => match LaboratoryQuantity::named(name) {
                Some(quantity) => quantity.admits(value),
                None if name == "beta" => value > 0.0,
                None => value >= 0.0,
            },
        }
    }

    /// The values that the column may have, in words.
    fn allowed(self) -> &'static str {
        match self {
            Role::Friction(_) => "a friction coefficient is a number",
            Role::Error => "a standard error is a number above 0",
            Role::Coordinate(name, _) => match LaboratoryQuantity::named(name) {
                Some(LaboratoryQuantity::PoissonRatio) => "it is a number from 0 to 0.5",
                Some(LaboratoryQuantity::SlideRollRatio) => {
                    "it is a number from -2 to 2, flat less roller over the mean"
                }
                Some(LaboratoryQuantity::RollerSpeed | LaboratoryQuantity::FlatSpeed) => {
                    "it is a number from 0: both surfaces move the same way"
                }
                None if name != "beta" => "it is a number from 0",
                _ => "it is a number above 0",
            },
        }
    }
}

impl Measured {
    /// Reads a CSV file with one header line. Lines that begin with # are comments.
    ///
    /// Columns: one friction coefficient (`mu` or `mu_drag`, what a load cell reads; or the part of it or the paper's
    /// total that the file holds instead, `mu_tot`, `mu_v`, `mu_h`), its standard error `error` if
    /// it is known, and where it was measured: `speed`, `load` and the other names of `[laboratory]`, in SI units or
    /// with the unit behind the name as in `speed (mm/s)`; `f`, `alpha` and `beta` beside dimensionless results.
    ///
    /// # Errors
    /// [`MeasuredError`] if the file cannot be read, a column has another name, or a value is not allowed.
    pub fn read(path: &Path) -> Result<Self, MeasuredError> {
        let table = |what: String| MeasuredError::NotATable { path: path.to_owned(), what };
        let text = read_text(path)?;
        let mut reader =
            csv::ReaderBuilder::new().comment(Some(b'#')).trim(csv::Trim::All).from_reader(text.as_bytes());
        let malformed = |error: csv::Error| table(format!("it is no CSV table: {}", csv_words(error.kind(), &text)));
        let header = reader.headers().map_err(malformed)?.clone();
        let roles = header.iter().map(role).collect::<Result<Vec<_>, _>>().map_err(table)?;
        check_roles(&header, &roles).map_err(table)?;
        let Some(column) =
            roles.iter().find_map(|role| if let Role::Friction(name) = role { Some(*name) } else { None })
        else {
            return Err(table("it has no column of friction; call it `mu`".to_owned()));
        };
        let mut found = Self {
            path: path.to_owned(),
            column,
            friction: Vec::new(),
            errors: roles.contains(&Role::Error).then(Vec::new),
            lines: Vec::new(),
            coordinates: roles
                .iter()
                .filter_map(|role| if let Role::Coordinate(name, _) = role { Some((*name, Vec::new())) } else { None })
                .collect(),
        };
        if found.coordinates.is_empty() {
            return Err(table("no column says where the points were measured; add `speed`, in m/s".to_owned()));
        }
        let mut lines = Lines { text: &text, byte: 0, line: 1 };
        for record in reader.records() {
            let record = record.map_err(malformed)?;
            let line = record.position().map_or(0, |position| lines.of(position));
            found.add(&record, line, &header, &roles)?;
        }
        if found.friction.is_empty() {
            return Err(table("it has no points below its header".to_owned()));
        }
        Ok(found)
    }

    /// Adds the point of a row.
    fn add(
        &mut self,
        record: &csv::StringRecord,
        line: u64,
        header: &csv::StringRecord,
        roles: &[Role],
    ) -> Result<(), MeasuredError> {
        let mut coordinates = self.coordinates.iter_mut();
        for ((text, name), role) in record.iter().zip(header).zip(roles) {
            let value = text.parse::<f64>().ok().filter(|value| value.is_finite());
            let factor = if let Role::Coordinate(_, factor) = role { *factor } else { 1.0 };
            let Some(value) = value.map(|value| in_si(value, factor)).filter(|value| role.admits(*value)) else {
                let allowed = role.allowed();
                let (path, column, value) = (self.path.clone(), printable(name).into_owned(), text.to_owned());
                return Err(MeasuredError::Value { path, line, column, value, allowed });
            };
            match role {
                Role::Friction(_) => self.friction.push(value),
                Role::Error => self.errors.iter_mut().for_each(|errors| errors.push(value)),
                Role::Coordinate(..) => {
                    let (_, values) = coordinates.next().expect("a list for each column of coordinates");
                    values.push(value);
                }
            }
        }
        self.lines.push(line);
        Ok(())
    }

    /// True if a point was measured at the quantities of an experiment, the speed along which curves run apart, as far
    /// as the file has them.
    pub fn belongs_to(&self, point: usize, experiment: &Experiment) -> bool {
        let along = experiment.motion.along().0.name();
        self.coordinates.iter().filter(|(name, _)| *name != along).all(|(name, values)| {
            let own = match LaboratoryQuantity::named(name) {
                Some(quantity) => experiment.value(quantity),
                None if *name == "f" => experiment.f,
                // these change with the speed
                None => return true,
            };
            Self::is_same(values[point], own)
        })
    }

    /// True for values that differ by less than 1 %.
    pub fn is_same(one: f64, other: f64) -> bool {
        one == other || (one / other).ln().abs() < 0.01
    }

    /// The values of a coordinate, if the file has it.
    pub fn coordinate(&self, name: &str) -> Option<&[f64]> {
        self.coordinates.iter().find(|(known, _)| *known == name).map(|(_, values)| values.as_slice())
    }
}

/// Checks that no two columns hold the same quantity, or one that follows from the other.
fn check_roles(header: &csv::StringRecord, roles: &[Role]) -> Result<(), String> {
    for (place, role) in roles.iter().enumerate() {
        let same = |other: &Role| match (role, other) {
            (Role::Coordinate(one, _), Role::Coordinate(other, _)) => one == other || are_moduli(one, other),
            (Role::Friction(_), Role::Friction(_)) | (Role::Error, Role::Error) => true,
            _ => false,
        };
        if roles[..place].iter().any(same) {
            let what = match role {
                Role::Friction(_) => "it has two columns of friction; keep one",
                _ => "it has a column twice, or both moduli; remove one",
            };
            return Err(format!("{what} (`{}`)", printable(&header[place])));
        }
    }
    Ok(())
}

/// True for the two moduli, of which one follows from the other.
fn are_moduli(one: &str, other: &str) -> bool {
    let moduli =
        [LaboratoryQuantity::RelaxedModulus, LaboratoryQuantity::InstantaneousModulus].map(LaboratoryQuantity::name);
    moduli.contains(&one) && moduli.contains(&other)
}

/// What a column of this name holds.
fn role(name: &str) -> Result<Role, String> {
    let (word, unit) = match name.find(['(', '[']) {
        Some(place) => (name[..place].trim(), Some(name[place + 1..].trim_end_matches([')', ']']).trim())),
        None => (name.trim(), None),
    };
    let known_unit = |quantity: LaboratoryQuantity, unit: &str| {
        quantity.dimension().and_then(|dimension| dimension.factor_of(unit)).ok_or_else(|| {
            let (name, unit) = (printable(name), quantity.units());
            format!("the unit of its column `{name}` is none of this quantity; write ({unit}), or a unit of that kind")
        })
    };
    let without_unit = match unit {
        None => Ok(()),
        Some(_) => Err(format!("its column `{}` has no unit; leave it out", printable(name))),
    };
    if let Some((_, column)) = FRICTION.into_iter().find(|(known, _)| *known == word) {
        return without_unit.map(|()| Role::Friction(column));
    }
    if word == ERROR {
        return without_unit.map(|()| Role::Error);
    }
    if let Some(known) = DIMENSIONLESS.into_iter().find(|known| *known == word) {
        return without_unit.map(|()| Role::Coordinate(known, 1.0));
    }
    match LaboratoryQuantity::named(word) {
        Some(ratio) if ratio.dimension().is_none() => without_unit.map(|()| Role::Coordinate(ratio.name(), 1.0)),
        Some(quantity) => {
            Ok(Role::Coordinate(quantity.name(), unit.map_or(Ok(1.0), |unit| known_unit(quantity, unit))?))
        }
        None => {
            let quantities = LaboratoryQuantity::ALL.map(LaboratoryQuantity::name).join(", ");
            Err(format!(
                "`{}` is no column that is known here: there are mu (or mu_drag, mu_tot, mu_v, mu_h), error, f, \
                 alpha, beta, {quantities}",
                printable(name)
            ))
        }
    }
}

/// The whole file.
fn read_text(path: &Path) -> Result<String, MeasuredError> {
    let unreadable = |source| MeasuredError::Unreadable { path: path.to_owned(), source };
    let table = |what: String| MeasuredError::NotATable { path: path.to_owned(), what };
    let mut bytes = Vec::new();
    let file = File::open(path).map_err(unreadable)?;
    file.take(MOST_BYTES + 1).read_to_end(&mut bytes).map_err(unreadable)?;
    if bytes.len() as u64 > MOST_BYTES {
        return Err(table(format!("it is larger than {} MiB, the most that is read", MOST_BYTES >> 20)));
    }
    String::from_utf8(bytes).map_err(|error| {
        let line =
            error.as_bytes()[..error.utf8_error().valid_up_to()].iter().filter(|byte| **byte == b'\n').count() + 1;
        table(format!("line {line} is not UTF-8 text; save it as UTF-8"))
    })
}

/// Counts the lines of a text, forward only.
struct Lines<'t> {
    text: &'t str,
    byte: usize,
    line: u64,
}

impl Lines<'_> {
    /// The line on which a record begins, from 1: empty lines and comments before it do not belong to it.
    fn of(&mut self, position: &csv::Position) -> u64 {
        let start = usize::try_from(position.byte()).expect("a place in memory");
        self.line += self.text[self.byte..start].matches('\n').count() as u64;
        self.byte = start;
        let rest = self.text[start..].lines();
        self.line + rest.take_while(|line| line.trim().is_empty() || line.starts_with('#')).count() as u64
    }
}

fn csv_words(kind: &csv::ErrorKind, text: &str) -> String {
    match kind {
        csv::ErrorKind::UnequalLengths { pos: Some(position), expected_len, len } => {
            format!(
                "line {} has {len} values for {expected_len} columns",
                Lines { text, byte: 0, line: 1 }.of(position)
            )
        }
        other => format!("{other:?}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: &str) -> Result<Measured, String> {
        let directory = tempfile::tempdir().expect("a directory");
        let path = directory.path().join("points.csv");
        std::fs::write(&path, text).expect("written");
        Measured::read(&path).map_err(|error| error.to_string().replace(&*path.to_string_lossy(), "points.csv"))
    }

    #[test]
    fn points_are_read_in_si_units() {
        let text = "# friction of a gel\nspeed (mm/s), mu, error,load\n1,0.5,0.01,100\n\n2.5, 0.25, 0.02, 100\n";
        let found = read(text).expect("valid");
        assert_eq!(found.column, "mu_drag");
        assert_eq!(found.friction, [0.5, 0.25]);
        assert_eq!(found.errors.as_deref(), Some(&[0.01, 0.02][..]));
        assert_eq!(found.coordinate("speed"), Some(&[1e-3, 2.5e-3][..]));
        assert_eq!(found.coordinate("load"), Some(&[100.0, 100.0][..]));
        assert_eq!(found.coordinate("radius"), None);
        assert_eq!(found.lines, [3, 5]);
    }

    #[test]
    fn what_is_wrong_is_named_with_its_place() {
        for (text, expected) in [
            ("speed\n1\n", "points.csv: it has no column of friction; call it `mu`"),
            ("mu\n1\n", "points.csv: no column says where the points were measured; add `speed`, in m/s"),
            ("speed,mu\n", "points.csv: it has no points below its header"),
            ("speed,mu\n1,fast\n", "points.csv:2: mu = \"fast\" is not allowed: a friction coefficient is a number"),
            ("speed,mu\n0,1\n", "points.csv:2: speed = \"0\" is not allowed: it is a number above 0"),
            ("speed,mu\n1,nan\n", "points.csv:2: mu = \"nan\" is not allowed: a friction coefficient is a number"),
            (
                "speed,mu,error\n1,1,0\n",
                "points.csv:2: error = \"0\" is not allowed: a standard error is a number above 0",
            ),
            ("speed,mu\n1,1,2\n", "points.csv: it is no CSV table: line 2 has 3 values for 2 columns"),
            ("speed,mu,mu_v\n1,1,1\n", "points.csv: it has two columns of friction; keep one (`mu_v`)"),
            ("speed,speed,mu\n1,1,1\n", "points.csv: it has a column twice, or both moduli; remove one (`speed`)"),
            (
                "speed (Pa),mu\n1,1\n",
                "points.csv: the unit of its column `speed (Pa)` is none of this quantity; write (m/s), or a unit of \
                 that kind",
            ),
            ("speed,mu (N)\n1,1\n", "points.csv: its column `mu (N)` has no unit; leave it out"),
        ] {
            assert_eq!(read(text).unwrap_err(), expected, "{text}");
        }
        let error = read("velocity,mu\n1,1\n").unwrap_err();
        assert!(error.starts_with("points.csv: `velocity` is no column that is known here"), "{error}");
        assert!(Measured::read(Path::new("nowhere.csv")).unwrap_err().to_string().contains("nowhere.csv"));
    }
}
