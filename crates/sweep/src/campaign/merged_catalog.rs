//! Several results directories, seen as one.

use std::collections::HashMap;

use crate::CaseId;
use crate::store::{Catalog, Status};

/// The catalogs of several results directories, seen as one: each case where it is stored best.
///
/// Best is where the case converged with all that is asked for, then where it failed so; of failures the one that was
/// given most time; then where the case is stored at all.
#[derive(Debug)]
pub struct MergedCatalog<'a> {
    catalogs: Vec<&'a Catalog>,
    /// The place in `catalogs` of the best holder of each case; `None` for a single catalog, which is asked itself.
    best: Option<HashMap<CaseId, u32>>,
}

impl<'a> MergedCatalog<'a> {
    /// Merges catalogs. With more than one it takes some 16 bytes for each case.
    pub fn new(catalogs: Vec<&'a Catalog>) -> Self {
        if catalogs.len() <= 1 {
            return Self { catalogs, best: None };
        }
        let mut best: HashMap<CaseId, u32> = HashMap::new();
        for (number, catalog) in (0..).zip(&catalogs) {
            for id in catalog.ids() {
                let better = |there: &u32| worth(catalog, id) > worth(catalogs[*there as usize], id);
                if best.get(&id).is_none_or(better) {
                    best.insert(id, number);
                }
            }
        }
        Self { catalogs, best: Some(best) }
    }

    /// The catalogs that were merged, in their order.
    pub fn catalogs(&self) -> &[&'a Catalog] {
        &self.catalogs
    }

    /// The catalog that holds a case best; `None` if none holds it.
    pub fn holder(&self, id: CaseId) -> Option<&'a Catalog> {
        match &self.best {
            Some(best) => best.get(&id).map(|&number| self.catalogs[number as usize]),
            None => self.catalogs.first().copied().filter(|catalog| catalog.knows(id)),
        }
    }

    /// The status of a case; `None` if it is nowhere with all that is asked for.
    pub fn holds(&self, id: CaseId) -> Option<Status> {
        self.holder(id)?.holds(id)
    }

    /// The number of distinct cases.
    pub fn known(&self) -> u64 {
        match &self.best {
            Some(best) => best.len() as u64,
            None => self.catalogs.first().map_or(0, |catalog| catalog.known()),
        }
    }
}

/// How good it is to have a case from a directory that knows it.
fn worth(catalog: &Catalog, id: CaseId) -> (bool, bool, u64) {
    let status = catalog.holds(id);
    // Numbers above 0 are in the order of their bits; one that ended by itself had all the time it wanted.
    let time = catalog.time_limit(id).unwrap_or(f64::INFINITY).to_bits();
    (status.is_some(), status == Some(Status::Converged), time)
}
