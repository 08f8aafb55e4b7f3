//! From the tables of a file to measured points.

use super::Measured;
use super::fields::{ERROR, FRICTION, admits, allowed, fields};
use super::motion::{keep_one_form, sliding};
use super::repeated::{Scatter, at_one_place, averaged, mean};
use crate::table::{Column, ColumnChoice, Columns, Decimal, Heading, Row, Table, TableError, TableFile, Understood};
use crate::{Dimension, LaboratoryQuantity};
use stribeck_input::printable;

/// How far beyond 2 a slide-to-roll ratio of an instrument may be to be taken for 2.
const BEYOND: f64 = 0.02;

/// The points of a file, and what was understood of it.
pub(super) fn points(
    file: &TableFile,
    choices: &[ColumnChoice],
    radius: Option<f64>,
) -> Result<(Measured, Understood), TableError> {
    let refuse = |what: String| TableError::NotATable { path: file.path.clone(), what };
    let (tables, columns) = tables(file, choices).map_err(refuse)?;
    let radius = columns.taken.iter().find(|column| turns(column)).map(|turning| radius_of(turning, &columns, radius));
    let radius = radius.transpose().map_err(refuse)?;
    let mut understood = Understood::new(file, tables[0], &columns);
    if let Some(Radius::Given(radius)) = radius {
        understood.note(format!("speeds in turns are multiplied by {radius} m, the radius of the cylinder"));
    }
    tables[1..].iter().for_each(|table| understood.add(table));
    for table in file.tables.iter().filter(|table| !tables.iter().any(|taken| std::ptr::eq(*taken, *table))) {
        if let Some(row) = table.rows().next() {
            understood.note(format!("the table at line {} has other columns, and is left out", row.line));
        }
    }
    let mut reader = Reader { file, columns: &columns, radius, understood };
    let steps = tables.iter().map(|table| reader.read(table)).collect::<Result<Vec<_>, _>>()?;
    let Reader { mut understood, .. } = reader;
    let several = steps.len() > 1;
    let steps: Vec<Measured> = steps.into_iter().filter(|step| !step.friction.is_empty()).collect();
    let steps = if several { points_of_steps(steps, &mut understood) } else { steps };
    let count = steps.len();
    let with_errors = steps.iter().filter(|step| step.errors.is_some()).count();
    let readings = Measured::join(
        steps.into_iter().map(|step| Measured { errors: step.errors.filter(|_| with_errors == count), ..step }),
    );
    let readings = match readings {
        Ok(readings) => Measured {
            files: vec![file.path.clone()],
            places: readings.places.iter().map(|(_, line)| (0, *line)).collect(),
            ..readings
        },
        Err(_) => {
            let reasons = understood.reasons();
            let because = if reasons.is_empty() { String::new() } else { format!(": {reasons}") };
            return Err(refuse(format!("it has no points below its header{because}")));
        }
    };
    if several {
        let points = readings.friction.len();
        understood.note(format!(
            "{count} steps; {points} points: readings at one place are one point, with the standard error of their mean"
        ));
    }
    let Some(points) = averaged(&readings) else { return Ok((readings, understood)) };
    understood.note(format!(
        "{} readings at {} places: each is one point, with the standard error of its mean",
        readings.friction.len(),
        points.friction.len()
    ));
    Ok((points, understood))
}

/// The tables of points, which have the same columns, and these columns.
fn tables<'f>(file: &'f TableFile, choices: &[ColumnChoice]) -> Result<(Vec<&'f Table>, Columns), String> {
    let fields = fields();
    let found = file.tables.iter().map(|table| {
        let is_computed = is_computed(&table.headings);
        let columns = table.columns(&fields, choices).and_then(|mut columns| {
            check(&mut columns, is_computed)?;
            Ok(columns)
        });
        (table, columns)
    });
    let mut first: Option<(&Table, Columns)> = None;
    let mut error = None;
    let mut taken = Vec::new();
    for (table, columns) in found {
        match (columns, &first) {
            (Ok(columns), None) => {
                taken.push(table);
                first = Some((table, columns));
            }
            (Ok(_), Some((like, _))) if like.headings == table.headings => taken.push(table),
            (Ok(_), Some(_)) => {}
            // of several tables that are none of points the largest one was meant
            (Err(what), _) => match &error {
                Some((size, _)) if *size >= table.len() => {}
                _ => error = Some((table.len(), what)),
            },
        }
    }
    match first {
        Some((_, columns)) => Ok((taken, columns)),
        None => Err(error.expect("a file has a table").1),
    }
}

/// True for a table that this program wrote: results of a sweep or a curve, or a fit.
fn is_computed(headings: &[Heading]) -> bool {
    let has = |name: &str| headings.iter().any(|heading| heading.text == name);
    (has("status") && has("reason")) || (has("fitted") && has("residual"))
}

/// Checks that there is one column of friction, that others say where it was measured, and that none follows from
/// another.
fn check(columns: &mut Columns, is_computed: bool) -> Result<(), String> {
    let is_friction = |column: &&Column| FRICTION.iter().any(|(name, _)| *name == column.field);
    let frictions: Vec<&Column> = columns.taken.iter().filter(is_friction).collect();
    let chosen: Vec<&&Column> = frictions.iter().filter(|column| column.is_chosen).collect();
    let kept = match (&frictions[..], &chosen[..]) {
        ([], _) => return Err(format!("it has no column of friction; call it `mu`{}", or_choose(columns, "mu"))),
        ([one], _) => one.field,
        (_, [one]) => one.field,
        _ if is_computed && columns.find("mu_drag").is_some() => "mu_drag",
        (several, _) => {
            let last = several.iter().max_by_key(|column| column.place).expect("there are several");
            return Err(format!("it has two columns of friction; keep one (`{}`)", printable(&last.heading)));
        }
    };
    let others: Vec<&str> = frictions.iter().map(|column| column.field).filter(|field| *field != kept).collect();
    others.into_iter().for_each(|field| columns.leave_out(field, &format!("the friction is {kept}")));
    let moduli = [LaboratoryQuantity::RelaxedModulus, LaboratoryQuantity::InstantaneousModulus];
    if let [Some(_), Some(second)] = moduli.map(|quantity| columns.find(quantity.name())) {
        return Err(format!("it has a column twice, or both moduli; remove one (`{}`)", printable(&second.heading)));
    }
    keep_one_form(columns);
    let is_quantity = |column: &Column| LaboratoryQuantity::named(column.field).is_some();
    if is_computed && columns.taken.iter().any(is_quantity) {
        for name in ["alpha", "beta"] {
            columns.leave_out(name, "follows from the quantities of the laboratory");
        }
    }
    let is_coordinate = |column: &Column| column.field != ERROR && column.field != kept;
    if !columns.taken.iter().any(is_coordinate) {
        let choose = or_choose(columns, "speed");
        return Err(format!("no column says where the points were measured; add `speed`, in m/s{choose}"));
    }
    Ok(())
}

/// What else may be done about a column that is not there: to say which of the unknown ones it is.
fn or_choose(columns: &Columns, field: &str) -> String {
    if columns.left_out.is_empty() {
        return String::new();
    }
    let of_field = fields().into_iter().find(|it| it.name == field).expect("it is a field");
    let column = columns.likely(&of_field).map_or_else(|| "NAME".into(), |it| printable(&it.heading));
    format!(", or say which of these it is, as in --columns \"{field}={column}\": {}", columns.describe_left_out())
}

/// The radius of the cylinder, by which turns are speeds.
#[derive(Clone, Copy)]
enum Radius {
    /// It stands in each row, at this place among the columns taken.
    Column(usize),
    /// It is one for all rows (m).
    Given(f64),
}

/// True for a column of speeds in turns.
fn turns(column: &Column) -> bool {
    column.dimension == Some(Dimension::AngularFrequency)
}

/// The radius for a column of speeds in turns.
fn radius_of(turning: &Column, columns: &Columns, given: Option<f64>) -> Result<Radius, String> {
    let column = columns.taken.iter().position(|column| column.field == LaboratoryQuantity::Radius.name());
    column.map(Radius::Column).or(given.map(Radius::Given)).ok_or_else(|| {
        format!(
            "its column `{}` is in turns, not a speed, and the radius that makes one of the other is not known; give \
             [laboratory] one radius, the file a column `radius`, or the speeds in m/s",
            printable(&turning.heading)
        )
    })
}

/// Reads the tables of a file one after the other.
struct Reader<'f> {
    file: &'f TableFile,
    columns: &'f Columns,
    /// Given where there are speeds in turns.
    radius: Option<Radius>,
    understood: Understood,
}

impl Reader<'_> {
    /// The readings in a table.
    fn read(&mut self, table: &Table) -> Result<Measured, TableError> {
        let columns = self.columns;
        let is_friction = |column: &&Column| FRICTION.iter().any(|(name, _)| *name == column.field);
        let friction = columns.taken.iter().find(is_friction).expect("it was checked");
        let column = FRICTION.iter().find(|(name, _)| *name == friction.field).expect("it is friction").1;
        let is_coordinate = |column: &&Column| column.field != ERROR && column.field != friction.field;
        let of_slide = sliding(columns);
        let name =
            |column: &Column| if of_slide && column.field == "speed" { "slide_roll_ratio" } else { column.field };
        let mut found = Measured {
            files: vec![self.file.path.clone()],
            column,
            friction: Vec::new(),
            errors: columns.find(ERROR).map(|_| Vec::new()),
            places: Vec::new(),
            coordinates: columns.taken.iter().filter(is_coordinate).map(|column| (name(column), Vec::new())).collect(),
            is_averaged: false,
            is_computed: is_computed(&table.headings),
            without_unit: columns
                .taken
                .iter()
                .filter(|it| !it.has_unit())
                .map(|it| (it.field, it.heading.clone()))
                .collect(),
        };
        for row in table.rows() {
            let Some(values) = self.values(&row, of_slide)? else { continue };
            let mut coordinates = found.coordinates.iter_mut();
            for (value, column) in values.into_iter().zip(&columns.taken) {
                match column.field {
                    ERROR => found.errors.iter_mut().for_each(|errors| errors.push(value)),
                    field if field == friction.field => found.friction.push(value),
                    _ => coordinates.next().expect("a list for each column of coordinates").1.push(value),
                }
            }
            found.places.push((0, row.line));
        }
        Ok(found)
    }

    /// The values of a row; `None` if it is left out.
    fn values(&mut self, row: &Row<'_>, of_slide: bool) -> Result<Option<Vec<f64>>, TableError> {
        let mut values = Vec::with_capacity(self.columns.taken.len());
        for column in &self.columns.taken {
            let text = column.text(row);
            if text.is_empty() {
                self.understood.leave_out(row.line, format!("no value of {}", column.field));
                return Ok(None);
            }
            let Some(value) = column.value(row) else { return Err(self.refused(column, row, Some(text))) };
            values.push(value);
        }
        if let Some(radius) = self.radius {
            let radius = match radius {
                Radius::Column(place) => values[place],
                Radius::Given(radius) => radius,
            };
            let turning = values.iter_mut().zip(&self.columns.taken).filter(|(_, column)| turns(column));
            turning.for_each(|(value, _)| *value *= radius);
        }
        if of_slide {
            let of =
                |field: &str| self.columns.taken.iter().position(|column| column.field == field).expect("it is there");
            values[of("speed")] /= values[of("entrainment_speed")];
        }
        for (value, column) in values.iter_mut().zip(&self.columns.taken) {
            let field = if of_slide && column.field == "speed" { "slide_roll_ratio" } else { column.field };
            let beyond = value.abs() - 2.0;
            if field == "slide_roll_ratio" && !column.is_own && beyond > 0.0 && beyond <= BEYOND {
                *value = value.clamp(-2.0, 2.0);
            }
            if admits(field, *value) {
                continue;
            }
            if column.is_own {
                return Err(self.refused(column, row, None));
            }
            // an instrument writes what it reads before it runs, too
            self.understood.leave_out(row.line, format!("{field} is not allowed: {}", allowed(field)));
            return Ok(None);
        }
        Ok(Some(values))
    }

    /// The error of a value; `text` is given where it is no number.
    fn refused(&self, column: &Column, row: &Row<'_>, text: Option<&str>) -> TableError {
        let other = match column.decimal() {
            Decimal::Point => Decimal::Comma,
            Decimal::Comma => Decimal::Point,
        };
        let is_other = text.is_some_and(|text| other.number(text).is_some_and(f64::is_finite));
        let allowed = match is_other {
            true => format!(
                "it has {}, and the table {}; give all numbers the same",
                other.words(),
                column.decimal().words()
            ),
            false => allowed(column.field).to_owned(),
        };
        TableError::Value {
            path: self.file.path.clone(),
            line: row.line,
            column: printable(&column.heading).into_owned(),
            value: column.text(row).to_owned(),
            allowed,
        }
    }
}

/// The readings of steps: one point of each that was taken at one place.
fn points_of_steps(steps: Vec<Measured>, understood: &mut Understood) -> Vec<Measured> {
    let near: Vec<Option<Vec<usize>>> =
        steps.iter().map(|step| if step.errors.is_none() { at_one_place(step) } else { None }).collect();
    let scatters = steps.iter().zip(&near).filter_map(|(step, near)| Some(Scatter::of(step, near.as_ref()?)));
    let all: Scatter = scatters.sum();
    let point = |(step, near): (Measured, Option<Vec<usize>>)| {
        let Some(near) = near else { return step };
        let far = (0..step.friction.len()).filter(|reading| !near.contains(reading));
        far.for_each(|reading| understood.leave_out(step.places[reading].1, "not at the speeds of its step"));
        mean(&step, &[near], all)
    };
    steps.into_iter().zip(near).map(point).collect()
}
