//! Failed cases, for people to read.

use crate::model::Parameters;
use crate::store::{Holdings, Status, StoreError};
use crate::sweep::Plan;

/// The parameters of a case in words.
pub fn place(parameters: &Parameters) -> String {
    if parameters.is_relaxed_elastic() {
        return format!("f = 0, beta = {}", parameters.beta);
    }
    format!("f = {}, alpha = {}, beta = {}", parameters.f, parameters.alpha, parameters.beta)
}

/// The first failed cases of a plan in its order, each with its reason.
pub fn first(plan: &Plan, held: &Holdings, most: usize) -> Result<Vec<(Parameters, String)>, StoreError> {
    let cases = plan.chains().flat_map(|chain| plan.parameters(&chain));
    let failed = cases.map(|case| (plan.id(&case), case)).filter(|(id, _)| held.holds(*id) == Some(Status::Failed));
    let mut list = Vec::new();
    for (id, parameters) in failed.take(most) {
        let reason = held.entry(id)?.map_or_else(String::new, |entry| entry.reason);
        list.push((parameters, reason));
    }
    Ok(list)
}
