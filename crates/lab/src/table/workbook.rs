//! Workbooks (.xlsx): the first sheet that holds a table.

use std::io::{self, Cursor, Read};
use std::sync::Arc;

use calamine::{DataRef, Reader, Xlsx, XlsxError};
use zip::ZipArchive;

use super::blocks::tables as tables_of;
use super::layout::{Decimal, Layout, Separator};
use super::rows::Table;
use stribeck_input::printable;

/// How the text of a sheet is written.
pub(super) const LAYOUT: Layout = Layout { separator: Separator::Tab, decimal: Decimal::Point };
/// How the name of a sheet begins.
pub(super) const SHEET: &str = "workbook, sheet ";
/// Most bytes of a workbook when it is unpacked: few bytes may be packed gigabytes.
const MOST_UNPACKED: u64 = 256 << 20;
/// Most bytes of the text of a sheet.
const MOST_BYTES: usize = 64 << 20;

type Workbook<'b> = Xlsx<Cursor<&'b [u8]>>;

/// True for the bytes of a workbook, of this kind or an older one.
pub(super) fn is_one(bytes: &[u8]) -> bool {
    bytes.starts_with(b"PK\x03\x04") || is_old(bytes)
}

fn is_old(bytes: &[u8]) -> bool {
    bytes.starts_with(b"\xd0\xcf\x11\xe0")
}

/// What is read of a workbook.
pub(super) struct Sheet {
    /// Its name, in words.
    pub(super) words: String,
    pub(super) tables: Vec<Table>,
    /// The names of the sheets behind it, without those that are empty.
    pub(super) unread: Vec<String>,
}

/// The first sheet that has a table with rows.
///
/// # Errors
/// What is wrong with the workbook.
pub(super) fn first_sheet(bytes: &[u8]) -> Result<Sheet, String> {
    if is_old(bytes) {
        return Err("it is a workbook of the old kind; save it as .xlsx or CSV".to_owned());
    }
    let no_workbook =
        |error: String| format!("it is no workbook (.xlsx) that can be read: {}; save it as CSV", printable(&error));
    let broken = |error: XlsxError| no_workbook(error.to_string());
    if !unpacks_below(bytes, MOST_UNPACKED).map_err(|error| no_workbook(error.to_string()))? {
        let most = MOST_UNPACKED >> 20;
        return Err(format!("it unpacks to more than {most} MiB, the most that is read; save what is needed as CSV"));
    }
    let mut workbook: Workbook<'_> = Xlsx::new(Cursor::new(bytes)).map_err(broken)?;
    let names = workbook.sheet_names();
    for (place, name) in names.iter().enumerate() {
        let text = text(&mut workbook, name).map_err(broken)?;
        let too_large = || format!("its sheet {} is too large; save what is needed as CSV", printable(name));
        let text: Arc<str> = padded(&text).ok_or_else(too_large)?.into();
        let found = tables_of(&text, LAYOUT).map_err(|(_, what)| format!("sheet {}: {what}", printable(name)))?;
        if found.iter().any(|table| !table.is_empty()) {
            let unread = names[place + 1..].iter().filter(|name| has_cells(&mut workbook, name));
            let unread = unread.map(|name| printable(name).to_string()).collect();
            return Ok(Sheet { words: format!("{SHEET}{}", printable(name)), tables: found, unread });
        }
    }
    Err("none of its sheets holds a table: names of columns, and rows of numbers below".to_owned())
}

/// True for a sheet with cells, be they readable or not.
fn has_cells(workbook: &mut Workbook<'_>, sheet: &str) -> bool {
    text(workbook, sheet).map_or(true, |text| !text.trim().is_empty())
}

/// True if all parts of an archive together have fewer bytes than `most` when they are unpacked. None is kept.
fn unpacks_below(bytes: &[u8], most: u64) -> io::Result<bool> {
    let mut archive = ZipArchive::new(Cursor::new(bytes))?;
    let mut left = most;
    for part in 0..archive.len() {
        left -= io::copy(&mut archive.by_index(part)?.take(left), &mut io::sink())?;
    }
    Ok(left > 0)
}

/// A sheet as text: cells with tabs between them, a line for each row; cut where it gets too large.
fn text(workbook: &mut Workbook<'_>, sheet: &str) -> Result<String, XlsxError> {
    let mut text = String::new();
    let (mut row, mut column) = (0, 0);
    let mut cells = workbook.worksheet_cells_reader(sheet)?;
    while let Some(cell) = cells.next_cell()? {
        let (own_row, own_column) = cell.get_position();
        let value = written(cell.get_value());
        // cells stand in their order; one that does not begins no row
        if value.is_empty() || own_row < row || text.len() >= MOST_BYTES {
            continue;
        }
        if own_row > row {
            text.extend(std::iter::repeat_n('\n', (own_row - row) as usize));
            (row, column) = (own_row, 0);
        }
        text.extend(std::iter::repeat_n('\t', own_column.saturating_sub(column) as usize));
        column = own_column;
        text += &value;
    }
    Ok(text)
}

/// A text whose lines have the same number of cells; `None` if it is too large.
fn padded(text: &str) -> Option<String> {
    let tabs = |line: &str| line.matches('\t').count();
    let most = text.lines().map(tabs).max().unwrap_or(0);
    let size = text.lines().count().saturating_mul(most).saturating_add(text.len());
    let pad = |line: &str| format!("{line}{}\n", "\t".repeat(most - tabs(line)));
    (size < MOST_BYTES).then(|| text.lines().map(pad).collect())
}

/// A cell as a piece of a line.
fn written(value: &DataRef<'_>) -> String {
    let text = match value {
        DataRef::Int(number) => number.to_string(),
        DataRef::Float(number) => format!("{number:?}"),
        DataRef::String(text) | DataRef::DateTimeIso(text) | DataRef::DurationIso(text) => text.clone(),
        DataRef::SharedString(text) => (*text).to_owned(),
        DataRef::Bool(value) => value.to_string(),
        DataRef::DateTime(time) => format!("date {}", time.as_f64()),
        DataRef::Error(error) => format!("{error}"),
        DataRef::Empty => String::new(),
    };
    let text = text.replace(['\t', '\n', '\r'], " ");
    if text.starts_with('"') { format!("\"{}\"", text.replace('"', "\"\"")) } else { text }
}

#[cfg(test)]
mod tests {
    use std::io::Write;

    use zip::ZipWriter;
    use zip::write::SimpleFileOptions;

    use super::*;

    /// An archive with two parts of zeros.
    fn archive(size: usize) -> Vec<u8> {
        let mut writer = ZipWriter::new(Cursor::new(Vec::new()));
        for name in ["xl/sharedStrings.xml", "xl/workbook.xml"] {
            writer.start_file(name, SimpleFileOptions::default()).expect("a part");
            writer.write_all(&vec![0; size]).expect("written");
        }
        writer.finish().expect("an archive").into_inner()
    }

    /// What counts is what all parts unpack to, and not the size of the file.
    #[test]
    fn a_small_file_may_be_too_large() {
        let bytes = archive(1 << 20);
        assert!(bytes.len() < 1 << 14);
        assert!(unpacks_below(&bytes, (2 << 20) + 1).expect("an archive"));
        assert!(!unpacks_below(&bytes, 2 << 20).expect("an archive"));
        let refused = first_sheet(&archive(MOST_UNPACKED as usize / 2)).map(|_| ()).expect_err("too large");
        assert!(refused.starts_with("it unpacks to more than 256 MiB"), "{refused}");
    }
}
