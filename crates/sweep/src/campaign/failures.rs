//! Failed cases of a sweep, listed and by region.

use std::cmp::Reverse;
use std::collections::{BTreeMap, HashMap};
use std::fmt;

use super::MergedCatalog;
use crate::store::{Catalog, Status, StoreError};
use crate::{CaseId, Part, Plan};
use stribeck_solver::{Parameters, shortest};

/// A case that failed.
#[derive(Clone, Debug, PartialEq)]
pub struct FailedCase {
    /// Its parameters.
    pub parameters: Parameters,
    /// Why it failed.
    pub reason: String,
}

impl fmt::Display for FailedCase {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Parameters { f, alpha, beta, .. } = &self.parameters;
        let [f, alpha, beta] = [*f, *alpha, *beta].map(shortest);
        match self.parameters.is_relaxed_elastic() {
            true => write!(formatter, "f = 0, beta = {beta}: {}", self.reason),
            false => write!(formatter, "f = {f}, alpha = {alpha}, beta = {beta}: {}", self.reason),
        }
    }
}

/// The first failed cases of a plan, or of a part of it, in its order.
pub(super) fn first_failures(
    plan: &Plan,
    part: Option<Part>,
    stored: &Catalog,
    most: usize,
) -> Result<Vec<FailedCase>, StoreError> {
    let chains = plan.chains_of(part).into_iter().map(|index| plan.chain(index as usize));
    let cases = chains.flat_map(|chain| plan.parameters(&chain));
    let failed = cases.map(|case| (plan.id(&case), case)).filter(|(id, _)| stored.holds(*id) == Some(Status::Failed));
    let mut list = Vec::new();
    for (id, parameters) in failed.take(most) {
        let reason = stored.entry(id)?.map_or_else(String::new, |entry| entry.reason);
        list.push(FailedCase { parameters, reason });
    }
    Ok(list)
}

/// The failed cases within one decade of each parameter.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FailureRegion {
    /// The decades of f, α and β.
    pub decades: [Decade; 3],
    /// The number of cases that failed there.
    pub failed: u64,
    /// The failures of the kind that is commonest there.
    pub commonest: FailureGroup,
}

impl fmt::Display for FailureRegion {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [f, alpha, beta] = self.decades;
        write!(formatter, "f {f}, alpha {alpha}, beta {beta}: {} failed", self.failed)
    }
}

/// Failures of one kind.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct FailureGroup {
    /// The name of their kind, as [`FailureKind::name`](stribeck_solver::continuation::FailureKind::name) gives it.
    pub kind: String,
    /// The number of failures.
    pub cases: u64,
    /// The reason of one of them.
    pub example: String,
}

/// Where a parameter is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Decade {
    /// At 0.
    Zero,
    /// From this power of ten up to the next, the next excluded.
    Power(i32),
    /// At ∞.
    Infinity,
}

impl Decade {
    fn of(value: f64) -> Self {
        match value {
            0.0 => Self::Zero,
            f64::INFINITY => Self::Infinity,
            value => Self::Power(value.log10().floor() as i32),
        }
    }
}

impl fmt::Display for Decade {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Zero => formatter.write_str("0"),
            Self::Power(power @ -3..=4) => write!(formatter, "{} to {}", 10f64.powi(*power), 10f64.powi(power + 1)),
            Self::Power(power) => write!(formatter, "1e{power} to 1e{}", power + 1),
            Self::Infinity => formatter.write_str("inf"),
        }
    }
}

/// Failures of a region by the name of their kind.
type Kinds = BTreeMap<String, FailureGroup>;

/// The regions of a plan with failed cases, those with most failures first.
pub(super) fn failure_regions(plan: &Plan, stored: &MergedCatalog<'_>) -> Result<Vec<FailureRegion>, StoreError> {
    let mut places = failed_places(plan, stored);
    let mut regions: BTreeMap<[Decade; 3], Kinds> = BTreeMap::new();
    for catalog in stored.catalogs() {
        catalog.visit_failures(|id, kind, reason| {
            // Once, though it may have failed in several directories.
            if let Some(decades) = places.remove(&id) {
                add(regions.entry(decades).or_default(), kind, reason);
            }
        })?;
    }
    let region = |(decades, kinds): ([Decade; 3], Kinds)| {
        let failed = kinds.values().map(|group| group.cases).sum();
        let commonest = kinds.into_values().max_by_key(|group| group.cases).unwrap_or_default();
        FailureRegion { decades, failed, commonest }
    };
    let mut regions: Vec<FailureRegion> = regions.into_iter().map(region).collect();
    regions.sort_by_key(|region| Reverse(region.failed));
    Ok(regions)
}

/// The regions of all failed cases.
fn failed_places(plan: &Plan, stored: &MergedCatalog<'_>) -> HashMap<CaseId, [Decade; 3]> {
    let cases = plan.chains().flat_map(|chain| plan.parameters(&chain));
    let failed = cases.map(|case| (plan.id(&case), case)).filter(|(id, _)| stored.holds(*id) == Some(Status::Failed));
    failed.map(|(id, case)| (id, [case.f, case.alpha, case.beta].map(Decade::of))).collect()
}

/// Counts a failure among those of its kind.
fn add(kinds: &mut Kinds, kind: &str, reason: &str) {
    let first = || FailureGroup { kind: kind.to_owned(), cases: 0, example: reason.to_owned() };
    kinds.entry(kind.to_owned()).or_insert_with(first).cases += 1;
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn decades_begin_at_powers_of_ten() {
        for power in -12..=12 {
            let start: f64 = format!("1e{power}").parse().expect("a number");
            assert_eq!(Decade::of(start), Decade::Power(power));
            assert_eq!(Decade::of(start * (1.0 - 1e-12)), Decade::Power(power - 1), "{start}");
        }
        assert_eq!([0.0, f64::INFINITY].map(Decade::of), [Decade::Zero, Decade::Infinity]);
        assert_eq!(Decade::of(30.0).to_string(), "10 to 100");
        assert_eq!(Decade::of(3e-7).to_string(), "1e-7 to 1e-6");
    }
}
