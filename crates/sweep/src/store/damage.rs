//! Damaged shards, and what is lost with them.
//!
//! A run that finds a shard damaged solves its cases again and commits them in other shards: no file in `shards` is ever
//! replaced. So a damaged shard is of no concern any more once other shards hold all of its cases.

use std::collections::HashMap;

use super::StoreError;
use super::claims::{Claim, shard_record};
use super::directory::Directory;
use crate::CaseId;

/// A shard that is not what its record says.
pub(super) struct Damage {
    pub claim: Claim,
    /// What is wrong with it.
    pub what: String,
    /// How many of its cases no sound shard holds with all that this one had.
    pub lost: usize,
}

/// Looks at the shards of all claims: the sound ones, and the damaged ones with what is lost with them.
pub(super) fn inspect(
    directory: &Directory,
    claims: Vec<Claim>,
    fault: impl Fn(&Claim) -> Option<String>,
) -> Result<(Vec<Claim>, Vec<Damage>), StoreError> {
    let (mut sound, mut damaged) = (Vec::with_capacity(claims.len()), Vec::new());
    for claim in claims {
        match fault(&claim) {
            None => sound.push(claim),
            Some(what) => damaged.push(Damage { lost: claim.cases, claim, what }),
        }
    }
    count_losses(directory, &sound, &mut damaged)?;
    Ok((sound, damaged))
}

fn count_losses(directory: &Directory, sound: &[Claim], damaged: &mut [Damage]) -> Result<(), StoreError> {
    if damaged.is_empty() {
        return Ok(());
    }
    // The damaged shards that hold a case, each once.
    let mut holders: HashMap<CaseId, Vec<usize>> = HashMap::new();
    for (number, damage) in damaged.iter().enumerate() {
        for case in shard_record(directory, damage.claim.place)?.cases {
            holders.entry(case.case).or_default().push(number);
        }
    }
    for claim in sound {
        for case in shard_record(directory, claim.place)?.cases {
            let Some(holders) = holders.get_mut(&case.case) else { continue };
            holders.retain(|&number| {
                let replaced = claim.contents.covers(&damaged[number].claim.contents);
                damaged[number].lost -= usize::from(replaced);
                !replaced
            });
        }
    }
    Ok(())
}
