//! Failed cases, for people to read.

use std::cmp::Reverse;
use std::collections::{BTreeMap, HashMap};
use std::fmt;

use super::collection::Held;
use stribeck_solver::{Parameters, shortest};
use stribeck_sweep::CaseId;
use stribeck_sweep::store::{Holdings, Status, StoreError, kind_of_reason};
use stribeck_sweep::{Part, Plan};

/// The parameters of a case in words.
pub fn place(parameters: &Parameters) -> String {
    let [f, alpha, beta] = [parameters.f, parameters.alpha, parameters.beta].map(shortest);
    if parameters.is_relaxed_elastic() {
        return format!("f = 0, beta = {beta}");
    }
    format!("f = {f}, alpha = {alpha}, beta = {beta}")
}

/// The first failed cases of a plan in its order, each with its reason.
pub fn first(
    plan: &Plan,
    part: Option<Part>,
    held: &Holdings,
    most: usize,
) -> Result<Vec<(Parameters, String)>, StoreError> {
    let chains = plan.chains_of(part).into_iter().map(|index| plan.chain(index as usize));
    let cases = chains.flat_map(|chain| plan.parameters(&chain));
    let failed = cases.map(|case| (plan.id(&case), case)).filter(|(id, _)| held.holds(*id) == Some(Status::Failed));
    let mut list = Vec::new();
    for (id, parameters) in failed.take(most) {
        let reason = held.entry(id)?.map_or_else(String::new, |entry| entry.reason);
        list.push((parameters, reason));
    }
    Ok(list)
}

/// Failed cases of one decade of each parameter.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Region {
    /// The decades of f, α and β.
    pub decades: [Decade; 3],
    /// How many cases failed there.
    pub failed: u64,
    /// A reason of the kind that is commonest there.
    pub reason: String,
    /// How many of them failed for such a reason.
    pub alike: u64,
}

impl fmt::Display for Region {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [f, alpha, beta] = self.decades;
        write!(formatter, "f {f}, alpha {alpha}, beta {beta}: {} failed", self.failed)
    }
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

/// The regions of a plan with failed cases, those with most failures first.
pub fn regions(plan: &Plan, held: &Held<'_>) -> Result<Vec<Region>, StoreError> {
    let mut boxes: HashMap<CaseId, [Decade; 3]> = HashMap::new();
    for chain in plan.chains() {
        for case in plan.parameters(&chain) {
            let id = plan.id(&case);
            if held.holds(id) == Some(Status::Failed) {
                boxes.insert(id, [case.f, case.alpha, case.beta].map(Decade::of));
            }
        }
    }
    // Of each region the kinds of reasons, each with its number and an example.
    let mut tally: BTreeMap<[Decade; 3], BTreeMap<String, (u64, String)>> = BTreeMap::new();
    for held in held.all() {
        held.visit_failures(|id, reason| {
            // Once, though it may have failed in several directories.
            if let Some(decades) = boxes.remove(&id) {
                let kinds = tally.entry(decades).or_default();
                kinds.entry(kind_of_reason(reason)).or_insert_with(|| (0, reason.to_owned())).0 += 1;
            }
        })?;
    }
    let region = |(decades, kinds): ([Decade; 3], BTreeMap<String, (u64, String)>)| {
        let failed = kinds.values().map(|(number, _)| number).sum();
        let (alike, reason) = kinds.into_values().max_by_key(|(number, _)| *number).unwrap_or_default();
        Region { decades, failed, reason, alike }
    };
    let mut regions: Vec<Region> = tally.into_iter().map(region).collect();
    regions.sort_by_key(|region| Reverse(region.failed));
    Ok(regions)
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
