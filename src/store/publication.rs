//! From shards to the files of the user.

use std::ops::Range;
use std::path::{Path, PathBuf};

use super::contents::places;
use super::directory::{PUBLISHED, Staged};
use super::holdings::{Inspection, LastPublished, fault};
use super::open_shards::OpenShards;
use super::record::{FileRecord, Record};
use super::results::Results;
use super::tables::{Summary, Timings};
use super::{Contents, Holdings, PROGRAM, Status, Store, StoreError, clock};
use crate::model::{COLUMNS, CaseId, Limits};

/// Places of the grid that are written in one go, if a row has not more: a write of HDF5 costs as much as many numbers.
const PLACES_AT_ONCE: usize = 4096;

/// What is published: a grid over (f, α, β), and which case stands at each place of it.
pub struct Publication<'a> {
    /// Title of the sweep.
    pub title: &'a str,
    /// The sweep file.
    pub sweep_text: &'a str,
    /// Values of f, ascending.
    pub f: &'a [f64],
    /// Values of α, ascending; the last may be +∞.
    pub alpha: &'a [f64],
    /// Values of β, ascending.
    pub beta: &'a [f64],
    /// The cases of the row at a place in `f` and one in `alpha`: one for each β. A case may stand at many places.
    pub cases: &'a dyn Fn(usize, usize) -> Vec<CaseId>,
}

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
}

/// One place of the grid.
pub(super) struct Place {
    pub case: CaseId,
    pub status: Status,
    pub reason: String,
    pub values: [f64; COLUMNS.len()],
}

impl Store {
    /// Publishes the sweep: writes `results.h5`, `summary.csv` and `timings.csv` under temporary names and puts them in
    /// place together, unless they are there already, made of the same cases and as they were written.
    ///
    /// The bytes of the first two depend on nothing but the publication, the cases and the version of the program. Goes
    /// through the grid row by row; memory does not depend on its size.
    ///
    /// # Errors
    /// [`StoreError::Unfinished`] if places of the grid have no case (nothing is written then),
    /// [`StoreError::Publication`] if a row does not have a case for each β, others if the disk fails.
    pub fn publish(&mut self, publication: &Publication<'_>) -> Result<Published, StoreError> {
        let Survey { key, converged, failed } = survey(self, publication)?;
        let files = PUBLISHED.map(|name| self.directory.published(name));
        if is_in_place(self, &key)? {
            if self.history.unpublished {
                // Shards were lost and came back as they were. The record stands behind theirs again.
                let files = self.published.as_ref().map_or_else(Vec::new, |last| last.files.clone());
                self.append(&Record::Published { key, files, time: clock() })?;
            }
            return Ok(Published { files, rewritten: false, converged, failed });
        }
        let staged = files.clone().map(Staged::new);
        write(self, publication, &staged)?;
        let mut records = Vec::new();
        for (name, file) in PUBLISHED.iter().zip(&staged) {
            let (bytes, hash) = file.synchronise()?;
            records.push(FileRecord { file: (*name).to_owned(), bytes, blake3: hash.to_hex().to_string() });
        }
        for file in staged {
            file.put_in_place()?;
        }
        self.append(&Record::Published { key: key.clone(), files: records.clone(), time: clock() })?;
        self.holdings_mut().published = Some(LastPublished { key, files: records });
        Ok(Published { files, rewritten: true, converged, failed })
    }
}

/// True if the files of a publication with this key are there, byte for byte.
fn is_in_place(store: &Holdings, key: &str) -> Result<bool, StoreError> {
    let Some(last) = store.published.as_ref().filter(|last| last.key == key) else { return Ok(false) };
    for file in &last.files {
        if fault(&store.directory.published(&file.file), file, Inspection::Bytes)?.is_some() {
            return Ok(false);
        }
    }
    Ok(true)
}

struct Survey {
    /// Hash of all that the published bytes depend on.
    key: String,
    converged: u64,
    failed: u64,
}

/// Looks up every place of the grid before anything is written.
fn survey(store: &Holdings, publication: &Publication<'_>) -> Result<Survey, StoreError> {
    let mut hasher = blake3::Hasher::new();
    for text in [PROGRAM, publication.title, publication.sweep_text] {
        hasher.update(&(text.len() as u64).to_le_bytes()).update(text.as_bytes());
    }
    let contents = Contents::of(&store.output);
    hasher.update(contents.fields.names().join(" ").as_bytes()).update(&contents.x.to_le_bytes());
    hasher.update(&[u8::from(contents.limits)]);
    for axis in [publication.f, publication.alpha, publication.beta] {
        hasher.update(&(axis.len() as u64).to_le_bytes());
        for value in axis {
            hasher.update(&value.to_bits().to_le_bytes());
        }
    }
    let (mut converged, mut failed, mut missing) = (0, 0, 0);
    for (i_f, i_alpha) in rows(publication) {
        for id in row_cases(publication, i_f, i_alpha)? {
            let Some(slot) = store.index.complete(id) else {
                missing += 1;
                continue;
            };
            hasher.update(&id.0.to_le_bytes()).update(store.index.shard(slot.shard).hash.as_bytes());
            match slot.status {
                Status::Converged => converged += 1,
                Status::Failed => failed += 1,
            }
        }
    }
    if missing > 0 {
        return Err(StoreError::Unfinished { missing, places: missing + converged + failed });
    }
    Ok(Survey { key: hasher.finalize().to_hex().to_string(), converged, failed })
}

/// The rows of the grid in plan order: f, then α.
fn rows(publication: &Publication<'_>) -> impl Iterator<Item = (usize, usize)> {
    let alphas = publication.alpha.len();
    (0..publication.f.len()).flat_map(move |i_f| (0..alphas).map(move |i_alpha| (i_f, i_alpha)))
}

fn row_cases(publication: &Publication<'_>, i_f: usize, i_alpha: usize) -> Result<Vec<CaseId>, StoreError> {
    let ids = (publication.cases)(i_f, i_alpha);
    if ids.len() != publication.beta.len() {
        let what =
            format!("row ({i_f}, {i_alpha}) has {} cases for {} values of beta", ids.len(), publication.beta.len());
        return Err(StoreError::Publication { what });
    }
    Ok(ids)
}

fn write(store: &Holdings, publication: &Publication<'_>, staged: &[Staged; 3]) -> Result<(), StoreError> {
    let mut files = Files::create(store, publication, staged)?;
    let alphas = publication.alpha.len();
    let rows_at_once = (PLACES_AT_ONCE / publication.beta.len()).max(1);
    for i_f in 0..publication.f.len() {
        for first in (0..alphas).step_by(rows_at_once) {
            files.rows(i_f, first..alphas.min(first + rows_at_once))?;
        }
    }
    files.finish()
}

/// The published files while they are written.
struct Files<'a> {
    store: &'a Holdings,
    publication: &'a Publication<'a>,
    open: OpenShards<'a>,
    results: Results,
    results_path: &'a Path,
    summary: Summary,
    timings: Timings,
}

impl<'a> Files<'a> {
    fn create(
        store: &'a Holdings,
        publication: &'a Publication<'a>,
        [results, summary, timings]: &'a [Staged; 3],
    ) -> Result<Self, StoreError> {
        let results_path = results.path();
        Ok(Self {
            store,
            publication,
            open: OpenShards::new(store),
            results: Results::create(results_path, publication, &store.output)
                .map_err(StoreError::hdf5(results_path, "write"))?,
            results_path,
            summary: Summary::create(summary.path())?,
            timings: Timings::create(timings.path())?,
        })
    }

    /// Writes neighbouring rows.
    fn rows(&mut self, i_f: usize, alphas: Range<usize>) -> Result<(), StoreError> {
        let mut places = Vec::with_capacity(alphas.len() * self.publication.beta.len());
        for i_alpha in alphas.clone() {
            for (i_beta, id) in row_cases(self.publication, i_f, i_alpha)?.into_iter().enumerate() {
                places.push(self.place([i_f, i_alpha, i_beta], id)?);
            }
        }
        self.results.rows(i_f, alphas, &places).map_err(StoreError::hdf5(self.results_path, "write"))
    }

    /// Writes what is written place by place: tables and fields. Returns the rest.
    fn place(&mut self, at: [usize; 3], id: CaseId) -> Result<Place, StoreError> {
        let Publication { f, alpha, beta, .. } = self.publication;
        let parameters = [f[at[0]], alpha[at[1]], beta[at[2]]];
        let output = &self.store.output;
        let slot = self.store.index.complete(id).expect("the survey found every case");
        let (shard, case) = self.open.case(id, slot)?;
        let reader = &shard.reader;
        let (status, reason) = (reader.status(case), reader.reason(case).to_owned());
        let values = asked(reader.values(case), output.limits);
        let place = Place { case: id, status, reason, values };
        self.summary.row(&place, parameters)?;
        self.timings.row(&place, parameters, &shard.cases[case])?;
        for field in places(output.fields) {
            if let Some(values) = reader.field(field, case)? {
                let written = self.results.field(field, at, &values);
                written.map_err(StoreError::hdf5(self.results_path, "write"))?;
            }
        }
        Ok(place)
    }

    fn finish(self) -> Result<(), StoreError> {
        self.results.finish().map_err(StoreError::hdf5(self.results_path, "write"))?;
        self.summary.finish()?;
        self.timings.finish()
    }
}

/// The numbers of a case that the sweep asks for; a shard of an earlier run may have the limits as well.
fn asked(mut values: [f64; COLUMNS.len()], limits: bool) -> [f64; COLUMNS.len()] {
    for (value, column) in values.iter_mut().zip(&COLUMNS) {
        if !limits && Limits::COLUMNS.contains(&column.name) {
            *value = f64::NAN;
        }
    }
    values
}
