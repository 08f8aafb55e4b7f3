//! The columns of a table that hold given quantities.

use std::str::FromStr;

use super::heading::{Field, Named, Unit, bracketed, named, squeezed};
use super::layout::Decimal;
use super::rows::{Row, Table, finite};
use crate::Dimension;
use stribeck_input::printable;

/// What a user says of a column: `speed=My V (mm/s)`, or `speed=#3` for the third one.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ColumnChoice {
    /// The quantity that it holds.
    pub field: String,
    /// Its name in the file, or its place.
    pub column: String,
}

impl ColumnChoice {
    /// The choices of a text as in `speed=My V (mm/s),mu=F`. A piece without `=` belongs to the name before it.
    ///
    /// # Errors
    /// What is wrong, and how it is written.
    pub fn list(text: &str) -> Result<Vec<Self>, String> {
        let mut choices: Vec<String> = Vec::new();
        for piece in text.split(',') {
            match choices.last_mut() {
                Some(last) if !piece.contains('=') => *last += &format!(",{piece}"),
                _ => choices.push(piece.to_owned()),
            }
        }
        choices.iter().map(|choice| choice.parse()).collect()
    }
}

impl FromStr for ColumnChoice {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        match text.split_once('=').map(|(field, column)| (field.trim(), column.trim())) {
            Some((field, column)) if !field.is_empty() && !column.is_empty() => {
                Ok(Self { field: field.to_owned(), column: column.to_owned() })
            }
            _ => Err("write quantity=column, as in speed=\"My V (mm/s)\" or speed=#3 for the third column".to_owned()),
        }
    }
}

/// A column that holds a quantity.
#[derive(Clone, Debug, PartialEq)]
pub struct Column {
    /// The name of the field.
    pub field: &'static str,
    /// Its place among the columns, from 0.
    pub place: usize,
    /// Its name in the file.
    pub heading: String,
    /// What its unit measures; `None` for ratios.
    pub dimension: Option<Dimension>,
    /// True if it has the field's own name, to the letter, or was chosen.
    pub is_own: bool,
    /// True if a choice named it.
    pub is_chosen: bool,
    pub(super) unit: Unit,
    decimal: Decimal,
}

impl Column {
    /// The text of the column in a row; empty where the row ends before.
    pub fn text<'r>(&self, row: &'r Row<'_>) -> &'r str {
        row.cells.get(self.place).map_or("", |cell| cell)
    }

    /// True if the file names its unit.
    pub fn has_unit(&self) -> bool {
        self.unit.is_given
    }

    /// The decimal mark of its numbers.
    pub fn decimal(&self) -> Decimal {
        self.decimal
    }

    /// The value in a row, in SI units; `None` if its text is no finite number.
    pub fn value(&self, row: &Row<'_>) -> Option<f64> {
        finite(self.decimal, self.text(row)).map(|number| self.unit.conversion.in_si(number))
    }
}

/// A column that is not taken.
#[derive(Clone, Debug, PartialEq)]
pub struct LeftOutColumn {
    /// Its name in the file, or its place.
    pub heading: String,
    /// Why.
    pub why: String,
}

/// The columns of a table that hold fields, and the others.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Columns {
    /// Those that hold a field, in the order of the file.
    pub taken: Vec<Column>,
    /// The others.
    pub left_out: Vec<LeftOutColumn>,
}

impl Columns {
    /// The column of a field.
    pub fn find(&self, field: &str) -> Option<&Column> {
        self.taken.iter().find(|column| column.field == field)
    }

    /// The column left out that may well hold a field, by its unit and its name; or the only one.
    pub fn likely(&self, field: &Field) -> Option<&LeftOutColumn> {
        let alone = self.left_out.len() == 1;
        let ranked = self.left_out.iter().rev().filter_map(|column| Some((field.likeness(&column.heading)?, column)));
        ranked.max_by_key(|(likeness, _)| *likeness).filter(|(likeness, _)| alone || *likeness > 0).map(|(_, it)| it)
    }

    /// The columns left out, each with the reason.
    pub fn describe_left_out(&self) -> String {
        let described = self.left_out.iter().map(|it| format!("`{}` ({})", printable(&it.heading), it.why));
        described.collect::<Vec<_>>().join(", ")
    }

    /// Leaves the column of a field out, if there is one.
    pub fn leave_out(&mut self, field: &str, why: &str) {
        if let Some(place) = self.taken.iter().position(|column| column.field == field) {
            let heading = self.taken.remove(place).heading;
            self.left_out.push(LeftOutColumn { heading, why: why.to_owned() });
        }
    }
}

/// A column and the field that it may hold.
struct Candidate {
    place: usize,
    named: Named,
    is_chosen: bool,
}

impl Table {
    /// The columns that hold fields: those of the choices, and those whose names are known.
    ///
    /// # Errors
    /// What is wrong: a choice that is none, a unit that a column cannot have, or two columns for one field.
    pub fn columns(&self, fields: &[Field], choices: &[ColumnChoice]) -> Result<Columns, String> {
        let chosen = choices.iter().map(|choice| self.chosen(choice, fields)).collect::<Result<Vec<_>, _>>()?;
        let free = |place: &usize| !chosen.iter().any(|candidate| candidate.place == *place);
        let known = |place: usize| {
            let named = named(&self.headings[place], fields)?;
            Some(Candidate { place, named, is_chosen: false })
        };
        let known: Vec<Candidate> = (0..self.headings.len()).filter(free).filter_map(known).collect();
        let mut columns = Columns::default();
        let mut candidates: Vec<Candidate> = chosen.into_iter().chain(known).collect();
        candidates.sort_by_key(|candidate| candidate.place);
        for place in 0..self.headings.len() {
            let heading = self.name(place);
            let Some(candidate) = candidates.iter().find(|candidate| candidate.place == place) else {
                if !self.headings[place].text.is_empty() {
                    columns.left_out.push(LeftOutColumn { heading, why: "not known here".to_owned() });
                }
                continue;
            };
            if self.is_blank(place) {
                columns.left_out.push(LeftOutColumn { heading, why: "empty".to_owned() });
                continue;
            }
            let field = &fields[candidate.named.field];
            match &candidate.named.unit {
                Err(why) if candidate.named.is_own || candidate.is_chosen => {
                    return Err(format!("its column `{}` {why}", printable(&heading)));
                }
                Err(why) => columns.left_out.push(LeftOutColumn { heading, why: why.clone() }),
                Ok(unit) => match self.better(candidate, &candidates, field)? {
                    Some(why) => columns.left_out.push(LeftOutColumn { heading, why }),
                    None => columns.taken.push(Column {
                        field: field.name,
                        place,
                        heading,
                        dimension: unit.dimension,
                        is_own: candidate.named.is_own || candidate.is_chosen,
                        is_chosen: candidate.is_chosen,
                        unit: unit.clone(),
                        decimal: self.layout.decimal,
                    }),
                },
            }
        }
        Ok(columns)
    }

    /// The name of a column for people.
    pub(super) fn name(&self, place: usize) -> String {
        match self.headings[place].text.trim() {
            "" => format!("#{}", place + 1),
            text => text.to_owned(),
        }
    }

    /// Why another column stands for the field of a candidate; `None` if none does.
    ///
    /// # Errors
    /// If two columns may hold the field.
    fn better(&self, candidate: &Candidate, all: &[Candidate], field: &Field) -> Result<Option<String>, String> {
        let rank = |it: &Candidate| (it.is_chosen, it.named.is_own);
        let rivals = all.iter().filter(|it| it.named.field == candidate.named.field && it.named.unit.is_ok());
        for rival in rivals.filter(|rival| rival.place != candidate.place && !self.is_blank(rival.place)) {
            let (own, other) = (self.name(candidate.place), self.name(rival.place));
            if rank(rival) > rank(candidate) {
                return Ok(Some(format!("{} is the column `{}`", field.name, printable(&other))));
            }
            if rank(rival) < rank(candidate) {
                continue;
            }
            if candidate.named.is_own || !self.are_equal(candidate.place, rival.place) {
                return Err(format!(
                    "it has two columns of {}, `{}` and `{}`; remove one, or choose with --columns \"{}=#{}\"",
                    field.name,
                    printable(&own),
                    printable(&other),
                    field.name,
                    candidate.place.min(rival.place) + 1,
                ));
            }
            if rival.place < candidate.place {
                return Ok(Some(format!("the same numbers as in column {}", rival.place + 1)));
            }
        }
        Ok(None)
    }

    /// True if there are rows, and a column is empty in all of them.
    fn is_blank(&self, place: usize) -> bool {
        !self.is_empty() && self.rows().all(|row| row.cells.get(place).is_none_or(|cell| cell.is_empty()))
    }

    /// True if two columns hold the same in every row.
    fn are_equal(&self, one: usize, other: usize) -> bool {
        self.rows().all(|row| row.cells.get(one) == row.cells.get(other))
    }

    /// The column that a choice names.
    fn chosen(&self, choice: &ColumnChoice, fields: &[Field]) -> Result<Candidate, String> {
        let ColumnChoice { field: name, column } = choice;
        let Some(field) = fields.iter().position(|field| field.name == name || field.is_called(name)) else {
            let known: Vec<&str> = fields.iter().map(|field| field.name).collect();
            return Err(format!("--columns {}=…: there are {}", printable(name), known.join(", ")));
        };
        let (bare, unit) = bracketed(column).map_or((column.as_str(), None), |(name, unit)| (name, Some(unit)));
        let place = self.place_of(column).or_else(|| self.place_of(bare)).ok_or_else(|| {
            let headings: Vec<String> =
                (0..self.headings.len()).map(|place| format!("`{}`", self.name(place))).collect();
            format!(
                "--columns {0}={1}: there is no column {1}, but {2}",
                printable(name),
                printable(column),
                printable(&headings.join(", "))
            )
        })?;
        let heading = &self.headings[place];
        let own = bracketed(&heading.text).map(|(_, unit)| unit).or(heading.unit.as_deref());
        let unit = fields[field].unit(unit.or(own));
        Ok(Candidate { place, named: Named { field, is_own: false, unit }, is_chosen: true })
    }

    /// The place of a column by its name, the name without its unit, or its number.
    fn place_of(&self, column: &str) -> Option<usize> {
        if let Some(number) = column.strip_prefix('#') {
            let number: usize = number.trim().parse().ok()?;
            return (1..=self.headings.len()).contains(&number).then(|| number - 1);
        }
        let find = |is: &dyn Fn(&str) -> bool| self.headings.iter().position(|heading| is(heading.text.trim()));
        let bare = |text: &str| squeezed(bracketed(text).map_or(text, |(name, _)| name));
        find(&|text| text == column)
            .or_else(|| find(&|text| squeezed(text) == squeezed(column)))
            .or_else(|| find(&|text| bare(text) == squeezed(column)))
            .filter(|_| !squeezed(column).is_empty())
    }
}
