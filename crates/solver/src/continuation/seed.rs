//! Where first guesses come from.

use std::fmt;

/// Where the first guess of a case came from; recorded with the case.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Seed {
    /// No first guess was found.
    None,
    /// Hertz pressure on the dry contact.
    Hertz,
    /// Dry pressure, and the film of the elastic (EHL) solution at ā²β on the dry contact of half width ā.
    Elastic,
    /// As [`Seed::Elastic`], where the dry contact is nearer to the contact of the instantaneous modulus.
    RescaledElastic,
    /// The film under a rigid cylinder on a rigid plane, at the case itself.
    ThickFilm,
    /// The converged neighbour along the chain.
    Neighbour,
    /// Extrapolated from the last two cases of the chain.
    Predictor,
    /// The neighbour, by way of this number of intermediate points, which are not published.
    Intermediate(usize),
    /// The start of another case where films are thicker, by way of so many cases that are not published, this one
    /// included.
    March(usize),
}

impl Seed {
    /// The name of the seed, without its number of points.
    pub fn name(&self) -> &'static str {
        match self {
            Seed::None => "none",
            Seed::Hertz => "hertz",
            Seed::Elastic => "elastic",
            Seed::RescaledElastic => "rescaled-elastic",
            Seed::ThickFilm => "thick-film",
            Seed::Neighbour => "neighbour",
            Seed::Predictor => "predictor",
            Seed::Intermediate(_) => "intermediate",
            Seed::March(_) => "march",
        }
    }

    /// The number of points on the way that are not published; `None` if there is no way.
    pub fn points(&self) -> Option<usize> {
        match self {
            Seed::Intermediate(points) | Seed::March(points) => Some(*points),
            _ => None,
        }
    }
}

/// The name, and the number of points after a hyphen: `predictor`, `march-4`.
impl fmt::Display for Seed {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.points() {
            Some(points) => write!(formatter, "{}-{points}", self.name()),
            None => formatter.write_str(self.name()),
        }
    }
}
