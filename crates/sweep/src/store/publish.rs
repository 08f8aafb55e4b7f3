//! From shards to the files of the user.

use std::ops::Range;
use std::path::{Path, PathBuf};

use super::claims::{Inspection, LastPublished, fault};
use super::contents::field_names;
use super::directory::PUBLISHED;
use super::field_blocks::FieldSource;
use super::files::Staged;
use super::further_columns;
use super::open_shards::OpenShards;
use super::placed::PlacedNumbers;
use super::publication::{Place, Point, Publication};
use super::record::{CaseRecord, FileRecord, Record};
use super::replacement::put_in_place;
use super::results::Results;
use super::tables::{Summary, Timings};
use super::{Catalog, Contents, Status, Store, StoreError, clock, program};
use crate::{CaseId, Field, NoteCounts, Values};

/// Places of the grid that are written in one go, if a row has not more: a write of HDF5 costs as much as many numbers.
const PLACES_AT_ONCE: usize = 4096;

/// The reason of a place that has no case yet.
const NOT_SOLVED: &str = "not solved yet";

/// What was published.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Published {
    /// The files: results.h5, summary.csv, timings.csv.
    pub files: [PathBuf; 3],
    /// False if they were there already, made of the same cases.
    pub rewritten: bool,
    /// Places of the grid that converged.
    pub converged: u64,
    /// Places of the grid that failed.
    pub failed: u64,
    /// Places of the grid without a case: 0 but for a partial publication.
    pub missing: u64,
    /// How many places have each note; `None` if the files were there already.
    pub notes: Option<NoteCounts>,
}

impl Store {
    /// Publishes the sweep: writes `results.h5`, `summary.csv` and `timings.csv` under temporary names and puts them in
    /// place together, unless they are there already, made of the same cases and as they were written.
    ///
    /// The bytes of the first two depend on nothing but the publication, the cases and the version of the program. Goes
    /// through the grid row by row; memory does not depend on its size.
    ///
    /// # Errors
    /// [`StoreError::Unfinished`] if places of the grid have no case and all should (nothing is written then),
    /// [`StoreError::Publication`] if a row does not have a case for each β, others if the disk fails.
    pub fn publish(&mut self, publication: &Publication<'_>) -> Result<Published, StoreError> {
        let Survey { key, converged, failed, missing } = survey(self, publication)?;
        let files = PUBLISHED.map(|name| self.directory.published(name));
        if is_in_place(self, &key) {
            if self.history.unpublished {
                // Shards were lost and came back as they were. The record stands behind theirs again.
                let files = self.published.as_ref().map_or_else(Vec::new, |last| last.files.clone());
                self.append(&Record::Published { key, files, time: clock() })?;
            }
            return Ok(Published { files, rewritten: false, converged, failed, missing, notes: None });
        }
        let staged = files.clone().map(Staged::new);
        let notes = write(self, publication, missing, &staged)?;
        let mut records = Vec::new();
        for (name, file) in PUBLISHED.iter().zip(&staged) {
            let (bytes, hash) = file.synchronise()?;
            records.push(FileRecord { file: (*name).to_owned(), bytes, blake3: hash.to_hex().to_string() });
        }
        put_in_place(staged.into())?;
        self.append(&Record::Published { key: key.clone(), files: records.clone(), time: clock() })?;
        self.catalog_mut().published = Some(LastPublished { key, files: records });
        Ok(Published { files, rewritten: true, converged, failed, missing, notes: Some(notes) })
    }
}

/// True if the files of a publication with this key are there, byte for byte.
fn is_in_place(store: &Catalog, key: &str) -> bool {
    let sound = |file: &FileRecord| fault(&store.directory.published(&file.file), file, Inspection::Bytes).is_none();
    store.published.as_ref().is_some_and(|last| last.key == key && last.files.iter().all(sound))
}

struct Survey {
    /// Hash of all that the published bytes depend on.
    key: String,
    converged: u64,
    failed: u64,
    missing: u64,
}

/// Looks up every place of the grid before anything is written.
fn survey(store: &Catalog, publication: &Publication<'_>) -> Result<Survey, StoreError> {
    let mut hasher = blake3::Hasher::new();
    for text in [program().as_str(), publication.title, publication.sweep_text] {
        hasher.update(&(text.len() as u64).to_le_bytes()).update(text.as_bytes());
    }
    let contents = Contents::of(&store.wanted);
    hasher.update(field_names(contents.fields).as_bytes()).update(&contents.x.to_le_bytes());
    hasher.update(&[u8::from(contents.limits), u8::from(contents.sensitivities)]);
    if let Some(kept) = contents.field_precision.kept_bits() {
        hasher.update(&kept.to_le_bytes());
    }
    for dimension in publication.dimensions {
        hasher.update(&(dimension.name.len() as u64).to_le_bytes()).update(dimension.name.as_bytes());
        hasher.update(&(dimension.values.len() as u64).to_le_bytes());
        for value in &dimension.values {
            hasher.update(&value.to_bits().to_le_bytes());
        }
    }
    let (mut converged, mut failed, mut missing) = (0, 0, 0);
    for row in 0..publication.rows() {
        for Point { case: id, swapped, .. } in publication.places(row)? {
            let is_whole = swapped.is_none_or(|case| store.index.complete(case).is_some());
            let Some(slot) = store.index.complete(id).filter(|_| is_whole) else {
                missing += 1;
                hasher.update(b"no case");
                continue;
            };
            hasher.update(&id.0.to_le_bytes()).update(store.index.shard(slot.shard).hash.as_bytes());
            match slot.status {
                Status::Converged => converged += 1,
                Status::Failed => failed += 1,
            }
        }
    }
    if missing > 0 && !publication.partial {
        return Err(StoreError::Unfinished { missing, places: missing + converged + failed });
    }
    Ok(Survey { key: hasher.finalize().to_hex().to_string(), converged, failed, missing })
}

/// Writes the files under their temporary names. Returns how many places have each note.
fn write(
    store: &Catalog,
    publication: &Publication<'_>,
    missing: u64,
    staged: &[Staged; 3],
) -> Result<NoteCounts, StoreError> {
    let (mut files, mut summary) = Files::create(store, publication, staged)?;
    if missing > 0 {
        let places: usize = publication.shape().iter().product();
        let marked = files.results.set_partial(&format!("{missing} of {places} places are not solved yet"));
        marked.map_err(StoreError::hdf5(files.results_path, "write"))?;
    }
    let shape = publication.shape();
    let &[.., neighbours, length] = &shape[..] else {
        return Err(StoreError::Publication { what: "results have at least two dimensions".to_owned() });
    };
    let rows_at_once = (PLACES_AT_ONCE / length).max(1);
    let (mut written, mut notes) = (Vec::new(), NoteCounts::default());
    for block in 0..publication.rows() / neighbours {
        for first in (0..neighbours).step_by(rows_at_once) {
            // Text takes a third of the time. It is written while the next places are read.
            let range = first..neighbours.min(first + rows_at_once);
            let mut summarised = Ok(());
            let places = rayon::in_place_scope(|scope| {
                scope.spawn(|_| summarised = summary.rows(&written));
                files.rows(block, range)
            });
            summarised?;
            written = places?;
            written.iter().for_each(|place| notes.add(place.notes));
        }
    }
    summary.rows(&written)?;
    summary.finish()?;
    files.finish()?;
    Ok(notes)
}

/// The published files but the summary, while they are written.
struct Files<'a> {
    store: &'a Catalog,
    publication: &'a Publication<'a>,
    open: OpenShards<'a>,
    results: Results,
    results_path: &'a Path,
    timings: Timings,
}

impl<'a> Files<'a> {
    /// All three files, without a place yet.
    fn create(
        store: &'a Catalog,
        publication: &'a Publication<'a>,
        [results, summary, timings]: &'a [Staged; 3],
    ) -> Result<(Self, Summary), StoreError> {
        let results_path = results.path();
        let first = publication.places(0)?[0];
        let more = further_columns::columns(Some(&first), store.output());
        let first = first.experiment;
        let has_ratios = publication.has_ratios();
        let files = Self {
            store,
            publication,
            open: OpenShards::new(store),
            results: Results::create(results_path, publication, first.as_ref(), &more, &store.wanted)
                .map_err(StoreError::hdf5(results_path, "write"))?,
            results_path,
            timings: Timings::create(timings.path(), has_ratios)?,
        };
        Ok((files, Summary::create(summary.path(), has_ratios, first.as_ref(), &more)?))
    }

    /// Writes neighbouring rows, those of a range of the last dimension but one, and returns their places.
    fn rows(&mut self, block: usize, range: Range<usize>) -> Result<Vec<Place>, StoreError> {
        let shape = self.publication.shape();
        let (neighbours, length) = (shape[shape.len() - 2], shape[shape.len() - 1]);
        let mut places = Vec::with_capacity(range.len() * length);
        for row in range.clone() {
            let row = block * neighbours + row;
            for (column, point) in self.publication.places(row)?.into_iter().enumerate() {
                places.push(self.place(row * length + column, point)?);
            }
        }
        let written = self.results.rows(block, range, &places);
        written.map(|()| places).map_err(StoreError::hdf5(self.results_path, "write"))
    }

    /// Writes what is written place by place: timings and fields. Returns the rest.
    fn place(&mut self, at: usize, point: Point) -> Result<Place, StoreError> {
        let is_held = |case: CaseId| self.store.index.complete(case).is_some();
        let Some(slot) = self.store.index.complete(point.case).filter(|_| point.swapped.is_none_or(is_held)) else {
            return self.missing_place(point);
        };
        let swapped = point.swapped.map(|case| self.values(case, -point.slide_roll)).transpose()?;
        let output = self.store.output();
        let (shard, case) = self.open.case(point.case, slot)?;
        let reader = &shard.reader;
        let (status, reason) = (reader.status(case), reader.reason(case).to_owned());
        let sensitivities = if output.sensitivities { reader.sensitivities(case) } else { [None; 2] };
        let numbers = point.numbers_of(&reader.values(case), sensitivities, swapped.as_ref(), output);
        let mut sources = Vec::new();
        for field in self.results.fields().fields() {
            let source = if point.follows_from_film(field) { Field::FilmThickness } else { field };
            if let Some(stored) = reader.packed_field(source, case)? {
                sources.push(FieldSource { stored, placing: point.placing(field, &numbers) });
            }
        }
        let PlacedNumbers { values, more, notes, .. } = numbers;
        let place = Place { point, status, reason, values, more, notes };
        self.timings.row(&place, &shard.cases[case])?;
        if !sources.is_empty() {
            let written = self.results.fields().write(at, sources);
            written.map_err(StoreError::hdf5(self.results_path, "write"))?;
        }
        Ok(place)
    }

    /// A place without a case, of a partial publication.
    fn missing_place(&mut self, point: Point) -> Result<Place, StoreError> {
        let output = self.store.output();
        let numbers = point.numbers_of(&Values::NONE, [None; 2], point.swapped.map(|_| Values::NONE).as_ref(), output);
        let PlacedNumbers { values, more, notes, .. } = numbers;
        let place = Place { point, status: Status::Failed, reason: NOT_SOLVED.to_owned(), values, more, notes };
        self.timings.row(&place, &CaseRecord::unsolved(place.point.case))?;
        Ok(place)
    }

    /// The numbers of a case at a slide-to-roll ratio.
    fn values(&mut self, case: CaseId, slide_roll: f64) -> Result<Values, StoreError> {
        let slot = self.store.index.complete(case).expect("a place that is published whole has both cases");
        let (shard, row) = self.open.case(case, slot)?;
        Ok(shard.reader.values(row).at_slide_roll(slide_roll))
    }

    fn finish(self) -> Result<(), StoreError> {
        self.results.finish().map_err(StoreError::hdf5(self.results_path, "write"))?;
        self.timings.finish()
    }
}
