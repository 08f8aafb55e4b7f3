//! From a table to what it says of a material: moduli over frequency or time, or the terms of a series.

use super::material_file::{MaterialData, MaterialFile, MaterialOptions};
use super::measurement::{Measurement, Measurements};
use super::table_fields::FIELDS;
use super::{Isotherms, ModulusKind, PronyParts, PronySeries};
use crate::notation::{Comma, parts, with_point};
use crate::table::{Column, ColumnChoice, Columns, Heading, Row, Table, TableError, TableFile, Understood};
use crate::{Dimension, Modulus};
use std::f64::consts::{FRAC_PI_2, TAU};
use stribeck_input::{nearest, printable};

/// What the columns of a material may be, for a table that has none of these.
const WANTED: &str = "it has no columns of a material; these are storage and loss (Pa) over omega (rad/s) or frequency (Hz), \
                      |E*| and tan_delta over the same, relaxation (Pa) over time (s), or the terms of a Prony series, \
                      modulus (Pa) or fraction beside tau (s)";

/// The end of the names of files in which RepTate keeps moduli over frequency: what a line of names says there does not
/// count, the columns are always these.
const REPTATE: &str = "tts";
const REPTATE_COLUMNS: &str = "omega=#1,shear_storage=#2,shear_loss=#3";

/// How the columns of a table describe a material.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Form {
    /// E′ and E″.
    StorageAndLoss,
    /// E′ and tan δ.
    StorageAndTangent,
    /// |E*| and δ, or tan δ.
    SizeAndAngle,
    /// E(t).
    Relaxation,
    /// Terms of a series.
    Terms(PronyParts),
}

/// A form with the kind of its moduli.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Description {
    form: Form,
    kind: ModulusKind,
}

/// What a file of tables says of a material, and how it was understood.
pub(super) fn read(file: &TableFile, options: &MaterialOptions) -> Result<MaterialFile, TableError> {
    let refuse = |what: String| TableError::NotATable { path: file.path.clone(), what };
    let is_reptate = file.path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case(REPTATE));
    let choices = if is_reptate && options.columns.is_empty() {
        ColumnChoice::list(REPTATE_COLUMNS).map_err(refuse)?
    } else {
        options.columns.clone()
    };
    let (tables, columns, description) = choose(file, &choices).map_err(refuse)?;
    let factor = options.young_factor(description.kind).map_err(refuse)?;
    let mut understood = Understood::new(file, tables[0], &columns);
    tables[1..].iter().for_each(|table| understood.add(table));
    if factor != 1.0 {
        understood.note(format!("shear moduli are multiplied by 2 (1 + nu) = {factor}, for Young's modulus"));
    }
    if is_reptate {
        understood.note("a file of RepTate: its columns are the angular frequency, G' and G\" at one temperature");
    }
    if description.kind == ModulusKind::Young && !options.is_shear && columns.taken.iter().any(may_be_shear) {
        understood
            .note("taken for Young's moduli; rheometers write shear moduli so: --shear and --poisson-ratio 0.5 say it");
    }
    let mut reader = Reader { file, columns: &columns, options, understood, has_bare_modulus: false };
    let data = match description.form {
        Form::Terms(parts) => MaterialData::Series(reader.series(&tables, parts, factor)?),
        form => reader.measurements(&tables, form, factor)?,
    };
    reader.check_options(description, &data).map_err(refuse)?;
    let is_of_shear = options.is_shear || description.kind == ModulusKind::Shear;
    Ok(MaterialFile { data, is_of_shear, understood: reader.understood.to_string() })
}

/// True for a column of moduli whose name, as in `Storage modulus`, leaves open of what they are.
fn may_be_shear(column: &Column) -> bool {
    let names_its_kind = column.heading.trim_start_matches(['|', ' ']).starts_with(['E', 'e', 'T', 't']);
    column.dimension == Some(Dimension::Modulus) && !column.is_own && !names_its_kind
}

/// The tables with the columns of a material, which are those of the first one, and what these describe.
fn choose<'f>(file: &'f TableFile, choices: &[ColumnChoice]) -> Result<(Vec<&'f Table>, Columns, Description), String> {
    let mut error = None;
    for table in &file.tables {
        // a bare T is the temperature, and t the time
        let is_bare = |heading: &Heading| heading.text.trim() == "T" && heading.unit.is_none();
        let bare = table.headings.iter().find(|heading| is_bare(heading));
        let bare = bare.map(|_| ColumnChoice { field: "temperature".to_owned(), column: "T".to_owned() });
        let is_chosen = choices.iter().any(|choice| choice.field == "temperature" || choice.column == "T");
        let choices: Vec<ColumnChoice> = choices.iter().cloned().chain(bare.filter(|_| !is_chosen)).collect();
        match table.columns(&FIELDS, &choices).and_then(|columns| Ok((describe(&columns)?, columns))) {
            Ok((description, mut columns)) => {
                leave_out(&mut columns, description);
                let alike = file.tables.iter().filter(|other| other.headings == table.headings).collect();
                return Ok((alike, columns, description));
            }
            // of several tables that are none of a material the largest one was meant
            Err(what) => match &error {
                Some((size, _)) if *size >= table.len() => {}
                _ => error = Some((table.len(), what)),
            },
        }
    }
    Err(error.map_or_else(|| WANTED.to_owned(), |(_, what)| what))
}

/// What columns describe: moduli in oscillation if there are some, then a relaxation modulus, then terms.
fn describe(columns: &Columns) -> Result<Description, String> {
    let has = |name: &str| columns.find(name).is_some();
    let is_over_frequency = has("omega") || has("frequency");
    for (kind, mark) in [(ModulusKind::Young, ""), (ModulusKind::Shear, "shear_")] {
        let has_marked = |name: &str| has(&format!("{mark}{name}"));
        let form = match () {
            () if is_over_frequency && has_marked("storage") && has_marked("loss") => Form::StorageAndLoss,
            () if is_over_frequency && has_marked("storage") && has("tan_delta") => Form::StorageAndTangent,
            () if is_over_frequency && has_marked("size") && (has("tan_delta") || has("delta")) => Form::SizeAndAngle,
            () if has("time") && has_marked("relaxation") => Form::Relaxation,
            () if has("tau") && has_marked("modulus") => Form::Terms(PronyParts::Moduli),
            () if has("tau") && has("fraction") => Form::Terms(PronyParts::Fractions),
            () => continue,
        };
        return Ok(Description { form, kind });
    }
    if has("time") && has("modulus") {
        return Err(
            "its columns of time and modulus are a relaxation modulus over time or the terms of a series; say \
                    which, with --columns \"relaxation=…\" or --columns \"tau=…\""
                .to_owned(),
        );
    }
    Err(missing(columns))
}

/// Which columns are there, and which are not.
fn missing(columns: &Columns) -> String {
    let taken: Vec<&str> = columns.taken.iter().map(|column| column.field).collect();
    let has = if taken.is_empty() { String::new() } else { format!(". It has {}", taken.join(", ")) };
    if columns.left_out.is_empty() {
        return format!(
            "{WANTED}{has}. Name the columns, or say which they are: --columns \"omega=#1,storage=#2,loss=#3\""
        );
    }
    let absent: Vec<&str> = FIELDS.iter().map(|field| field.name).filter(|name| columns.find(name).is_none()).collect();
    let misspelt = columns.left_out.iter().find_map(|it| Some((nearest(&it.heading, &absent)?, it)));
    let likely = || {
        let fields = FIELDS.iter().filter(|field| absent.contains(&field.name));
        fields.filter_map(|field| Some((field.name, columns.likely(field)?))).next()
    };
    let found = misspelt.or_else(likely).map(|(field, column)| (field, printable(&column.heading)));
    let (field, column) = found.unwrap_or(("storage", "NAME".into()));
    let all = columns.describe_left_out();
    format!("{WANTED}{has}. Or say which of these it is, as in --columns \"{field}={column}\": {all}")
}

/// Leaves the columns out that a form does not need.
fn leave_out(columns: &mut Columns, Description { form, kind }: Description) {
    let needed: &[&str] = match form {
        Form::StorageAndLoss => &["omega", "frequency", "storage", "loss", "temperature"],
        Form::StorageAndTangent => &["omega", "frequency", "storage", "tan_delta", "temperature"],
        Form::SizeAndAngle => &["omega", "frequency", "size", "tan_delta", "delta", "temperature"],
        Form::Relaxation => &["time", "relaxation", "temperature"],
        Form::Terms(PronyParts::Moduli) => &["tau", "modulus"],
        Form::Terms(PronyParts::Fractions) => &["tau", "fraction"],
    };
    let is_needed = |field: &str| match (kind, field.strip_prefix("shear_")) {
        (ModulusKind::Shear, Some(bare)) => needed.contains(&bare),
        (ModulusKind::Young, None) => needed.contains(&field),
        (ModulusKind::Shear, None) => {
            needed.contains(&field) && !FIELDS.iter().any(|it| it.name.strip_prefix("shear_") == Some(field))
        }
        (ModulusKind::Young, Some(_)) => false,
    };
    let others: Vec<&str> = columns.taken.iter().map(|column| column.field).filter(|field| !is_needed(field)).collect();
    others.into_iter().for_each(|field| columns.leave_out(field, "not needed beside the others"));
    if columns.find("omega").is_some() {
        columns.leave_out("frequency", "omega says it");
    }
    if columns.find("tan_delta").is_some() {
        columns.leave_out("delta", "tan_delta says it");
    }
}

/// Reads rows by their columns.
struct Reader<'f> {
    file: &'f TableFile,
    columns: &'f Columns,
    options: &'f MaterialOptions,
    understood: Understood,
    /// True if the lines above the table name a modulus without a unit.
    has_bare_modulus: bool,
}

impl Reader<'_> {
    /// Measured moduli, at their temperatures if a column has these.
    fn measurements(&mut self, tables: &[&Table], form: Form, factor: f64) -> Result<MaterialData, TableError> {
        let refuse = |what: String| TableError::NotATable { path: self.file.path.clone(), what };
        let (mut rows, mut temperatures) = (Vec::new(), Vec::new());
        for row in tables.iter().flat_map(|table| table.rows()) {
            if self.is_empty(&row) {
                continue;
            }
            rows.push(self.measurement(&row, form)?.stiffer(factor));
            if self.columns.find("temperature").is_some() {
                temperatures.push(self.temperature(&row)?);
            }
        }
        if temperatures.is_empty() {
            let what = "it must have rows at two frequencies or times at least: from how moduli change between them follow \
                        the times of the material";
            return Ok(MaterialData::Moduli(Measurements::new(rows).ok_or_else(|| refuse(what.to_owned()))?));
        }
        let isotherms = Isotherms::new(temperatures.into_iter().zip(rows).collect());
        Ok(MaterialData::Isotherms(isotherms.map_err(|error| refuse(error.to_string()))?))
    }

    /// The terms of a series, without those of zero, and the modulus that a comment above them names.
    fn series(&mut self, tables: &[&Table], parts: PronyParts, factor: f64) -> Result<PronySeries, TableError> {
        let mut terms = Vec::new();
        for row in tables.iter().flat_map(|table| table.rows()) {
            if self.is_empty(&row) {
                continue;
            }
            let part = match parts {
                PronyParts::Moduli => factor * self.value(&row, "modulus", "a number from 0", |value| value >= 0.0)?,
                PronyParts::Fractions => self.value(&row, "fraction", "a number from 0", |value| value >= 0.0)?,
            };
            if part == 0.0 {
                self.understood.leave_out(row.line, "a term of zero");
                continue;
            }
            terms.push((part, self.value(&row, "tau", "a number above 0", |value| value > 0.0)?));
        }
        let modulus = self.modulus_above(tables);
        Ok(PronySeries { parts, terms, modulus: modulus.map(|it| it.times(factor)), kind: ModulusKind::Young })
    }

    /// The modulus that the lines above the tables name, in Pa; one without a unit is in that of the options.
    fn modulus_above(&mut self, tables: &[&Table]) -> Option<Modulus> {
        let comments = tables.iter().flat_map(|table| &table.above);
        let (modulus, has_unit) = comments.filter_map(|(_, line)| modulus_of(line)).next()?;
        self.has_bare_modulus = !has_unit;
        let taken = if has_unit { Some(modulus) } else { self.options.modulus_unit.map(|unit| modulus.times(unit)) };
        let (name, value) = match taken.unwrap_or(modulus) {
            Modulus::Relaxed(value) => ("relaxed", value),
            Modulus::Instantaneous(value) => ("instantaneous", value),
        };
        self.understood.note(match taken {
            Some(_) => format!("the {name} modulus, {value:e} Pa, is that of the lines above the table"),
            None => format!(
                "the {name} modulus in the lines above the table, {value}, has no unit there and is left out; give the \
                 unit of moduli, MPa say"
            ),
        });
        taken
    }

    /// Refuses options that say nothing of what was read.
    ///
    /// # Errors
    /// What to leave out.
    fn check_options(&self, description: Description, data: &MaterialData) -> Result<(), String> {
        let are_fractions = description.form == Form::Terms(PronyParts::Fractions);
        let has_modulus = !matches!(data, MaterialData::Series(series) if series.modulus.is_none());
        if self.options.is_shear && are_fractions && !has_modulus {
            return Err("its terms are fractions without a modulus, and those of shear and of Young's moduli are the \
                        same; leave out --shear"
                .to_owned());
        }
        let lacks_unit = |column: &Column| column.dimension == Some(Dimension::Modulus) && !column.has_unit();
        let has_unit = self.options.modulus_unit.is_some();
        if has_unit && !self.has_bare_modulus && !self.columns.taken.iter().any(lacks_unit) {
            return Err("it holds no modulus without a unit; leave out --modulus-unit MPa, or say the right unit of \
                        a column, as in --columns \"storage=#2 (kPa)\""
                .to_owned());
        }
        Ok(())
    }

    /// True for a row in which a column that is needed has nothing; it is left out.
    fn is_empty(&mut self, row: &Row<'_>) -> bool {
        let empty = self.columns.taken.iter().find(|column| column.text(row).trim().is_empty());
        if let Some(column) = empty {
            self.understood.leave_out(row.line, format!("no value of {}", column.field));
        }
        empty.is_some()
    }

    fn measurement(&self, row: &Row<'_>, form: Form) -> Result<Measurement, TableError> {
        let above = |name: &str| self.value(row, name, "a number above 0", |value| value > 0.0);
        let least = |name: &str| self.value(row, name, "a number from 0", |value| value >= 0.0);
        if form == Form::Relaxation {
            return Ok(Measurement::Relaxation { time: above("time")?, modulus: above("relaxation")? });
        }
        let omega = match self.columns.find("omega").is_some() {
            true => above("omega")?,
            false => above("frequency")? * self.turns(),
        };
        let (storage, loss) = match form {
            Form::StorageAndLoss => (above("storage")?, least("loss")?),
            Form::StorageAndTangent => {
                let storage = above("storage")?;
                (storage, storage * least("tan_delta")?)
            }
            _ => {
                let size = above("size")?;
                let angle = match self.columns.find("tan_delta").is_some() {
                    true => least("tan_delta")?.atan(),
                    false => self.value(
                        row,
                        "delta",
                        "an angle from 0 to less than 90 deg; write the unit, as in delta (deg)",
                        |angle| (0.0..FRAC_PI_2).contains(&angle),
                    )?,
                };
                (size * angle.cos(), size * angle.sin())
            }
        };
        Ok(Measurement::Oscillation { omega, storage, loss })
    }

    /// ω over the numbers of the column of frequencies: some have rad/s.
    fn turns(&self) -> f64 {
        let dimension = self.columns.find("frequency").and_then(|column| column.dimension);
        if dimension == Some(Dimension::AngularFrequency) { 1.0 } else { TAU }
    }

    fn temperature(&self, row: &Row<'_>) -> Result<f64, TableError> {
        let allowed = "a temperature of a laboratory, above 100 K; write the unit, as in temperature (degC)";
        self.value(row, "temperature", allowed, |value| value > 100.0)
    }

    /// The value of a field of either kind of modulus, in SI units; moduli without a unit are in that of the options.
    fn value(&self, row: &Row<'_>, name: &str, allowed: &str, fits: impl Fn(f64) -> bool) -> Result<f64, TableError> {
        let column = self.columns.find(name).or_else(|| self.columns.find(&format!("shear_{name}")));
        let column = column.expect("the form needs it");
        let unit = match column.dimension {
            Some(Dimension::Modulus) if !column.has_unit() => self.options.modulus_unit.unwrap_or(1.0),
            _ => 1.0,
        };
        column.value(row).map(|value| value * unit).filter(|value| is_measurable(*value) && fits(*value)).ok_or_else(
            || TableError::Value {
                path: self.file.path.clone(),
                line: row.line,
                column: printable(&column.heading).into_owned(),
                value: column.text(row).to_owned(),
                allowed: format!("{} is {allowed}; leave out rows that were not measured", column.field),
            },
        )
    }
}

/// True for zero and for numbers whose reciprocals and products are numbers, too.
fn is_measurable(value: f64) -> bool {
    value == 0.0 || (1e-100..=1e100).contains(&value.abs())
}

/// The modulus that a line such as `E0 = 1.7 GPa` names, in Pa, and true; or, without a unit, the number and false.
fn modulus_of(line: &str) -> Option<(Modulus, bool)> {
    let (name, value) = line.trim_start_matches(['#', ' ']).split_once(['=', ':'])?;
    let (number, unit) = parts(value);
    let Comma::None(number) = with_point(number) else { return None };
    let number: f64 = number.parse().ok()?;
    let has_unit = !unit.trim().is_empty();
    let value = if has_unit { Dimension::Modulus.conversion(unit.trim())?.in_si(number) } else { number };
    let name: String = name.chars().filter(|c| c.is_alphanumeric() || *c == '∞').flat_map(char::to_lowercase).collect();
    match name.as_str() {
        "e0" | "instantaneousmodulus" => Some((Modulus::Instantaneous(value), has_unit)),
        "einf" | "e∞" | "relaxedmodulus" | "longtermmodulus" => Some((Modulus::Relaxed(value), has_unit)),
        _ => None,
    }
}
