//! What makes two cases the same.

use super::recipe::{Recipe, SolverRecipe};
use crate::CaseId;
use stribeck_solver::relaxation::{self, Acceleration, Domain};
use stribeck_solver::{CavityShear, Parameters};

/// Gives the ids of cases that are solved with one [`Recipe`].
///
/// An id is the first 8 bytes (big-endian) of the BLAKE3 hash of these bytes; numbers are little-endian, `f64` are
/// their IEEE 754 bits with −0 taken as 0:
///
/// | bytes | what |
/// | --- | --- |
/// | `stribeck case 1\n` | version of this table |
/// | `collocation\n` or `relaxation\n` | method |
/// | `u32` | the version of the method's results: [`collocation::RESULTS_VERSION`] or [`relaxation::RESULTS_VERSION`] |
/// | the method's settings | see below |
/// | `u8` | cavity shear: 0 full, 1 streamers, 2 none |
/// | `f64`, `f64`, `f64` | f, α, β |
/// | `u64`, then two `f64` each | number of retardation modes, share and time of each |
/// | `u64` | how many of them are the roller's, if any are |
///
/// Settings of the collocation method are
///
/// | bytes | what |
/// | --- | --- |
/// | `f64`, `u64` | tolerance, degree of the panels |
///
/// and those of the relaxation method
///
/// | bytes | what |
/// | --- | --- |
/// | `u8`, then two `f64` if it is 1 | domain: 0 auto, 1 fixed with x_min and x_max |
/// | `u64`, `f64`, `u8`, `u8` | points, tolerance, acceleration (0 none, 1 Anderson), estimate (0 or 1) |
///
/// Where the substrate is elastic what does not matter is left out: f = 0 or α = ∞ counts as f = 0, α = ∞ without
/// modes, α = 0 as without modes. Title, fields, x and limits of the sweep are not part of it: they say what is kept
/// of a solution, not what is solved. Nor is the place in the sweep.
///
/// [`collocation::RESULTS_VERSION`]: stribeck_solver::collocation::RESULTS_VERSION
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Fingerprint {
    settings: Vec<u8>,
}

impl Fingerprint {
    /// The fingerprint of cases that are solved with a recipe.
    pub fn new(recipe: &Recipe) -> Self {
        let mut bytes = b"stribeck case 1\n".to_vec();
        match &recipe.solver {
            SolverRecipe::Collocation { version, tolerance, degree } => {
                bytes.extend(b"collocation\n");
                bytes.extend(version.to_le_bytes());
                put_number(&mut bytes, *tolerance);
                bytes.extend((*degree as u64).to_le_bytes());
            }
            SolverRecipe::Relaxation { version, settings } => {
                bytes.extend(b"relaxation\n");
                bytes.extend(version.to_le_bytes());
                put_relaxation(&mut bytes, settings);
            }
        }
        bytes.push(match recipe.cavity_shear {
            CavityShear::Full => 0,
            CavityShear::Streamers => 1,
            CavityShear::None => 2,
        });
        Self { settings: bytes }
    }

    /// The id of a case.
    pub fn id(&self, parameters: &Parameters) -> CaseId {
        let case = canonical(parameters);
        let modes = if case.retardation().is_empty() { &[] } else { case.substrate.modes() };
        let mut bytes = self.settings.clone();
        for value in [case.f, case.alpha, case.beta] {
            put_number(&mut bytes, value);
        }
        bytes.extend((modes.len() as u64).to_le_bytes());
        for mode in modes {
            put_number(&mut bytes, mode.share);
            put_number(&mut bytes, mode.time);
        }
        if case.substrate.of_roller() > 0 && !modes.is_empty() {
            bytes.extend((case.substrate.of_roller() as u64).to_le_bytes());
        }
        let hash = blake3::hash(&bytes);
        let first = hash.as_bytes().first_chunk().expect("a BLAKE3 hash has 32 bytes");
        CaseId(u64::from_be_bytes(*first))
    }
}

/// The same problem with what does not matter set to its default: the substrate of elastic cases, and α where f = 0 or
/// f where α = ∞.
pub(super) fn canonical(parameters: &Parameters) -> Parameters {
    if parameters.is_relaxed_elastic() {
        Parameters::elastic(parameters.beta)
    } else if parameters.alpha == 0.0 {
        Parameters::new(0.0, parameters.beta, parameters.f)
    } else {
        parameters.clone()
    }
}

fn put_relaxation(bytes: &mut Vec<u8>, settings: &relaxation::Settings) {
    let relaxation::Settings { domain, points, tolerance, acceleration, estimate } = *settings;
    match domain {
        Domain::Auto => bytes.push(0),
        Domain::Fixed { x_min, x_max } => {
            bytes.push(1);
            put_number(bytes, x_min);
            put_number(bytes, x_max);
        }
    }
    bytes.extend((points as u64).to_le_bytes());
    put_number(bytes, tolerance);
    bytes.push(match acceleration {
        Acceleration::None => 0,
        Acceleration::Anderson => 1,
    });
    bytes.push(u8::from(estimate));
}

/// The bits of a number; −0 + 0 is +0.
fn put_number(bytes: &mut Vec<u8>, value: f64) {
    bytes.extend((value + 0.0).to_bits().to_le_bytes());
}
