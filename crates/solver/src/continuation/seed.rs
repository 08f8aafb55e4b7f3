//! Where first guesses come from.

use std::fmt;
use std::str::FromStr;

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
    /// The built-in table of solutions, at the case itself.
    Table,
    /// The converged neighbour along the chain.
    Neighbour,
    /// Extrapolated from the last two cases of the chain.
    Predictor,
    /// The neighbour, by way of this number of intermediate points, which are not published.
    Intermediate(usize),
    /// The start of another case where films are thicker, from the thick film or the table, by way of so many cases
    /// that are not published, this one included.
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
            Seed::Table => "table",
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

/// A text that names no [`Seed`].
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("`{0}` is not the name of a seed")]
pub struct NotASeed(String);

impl FromStr for Seed {
    type Err = NotASeed;

    /// The seed that is displayed as this text.
    fn from_str(text: &str) -> Result<Self, NotASeed> {
        let points = text.rsplit_once('-').and_then(|(_, points)| points.parse().ok()).unwrap_or(0);
        let seeds = [
            Seed::None,
            Seed::Hertz,
            Seed::Elastic,
            Seed::RescaledElastic,
            Seed::ThickFilm,
            Seed::Table,
            Seed::Neighbour,
            Seed::Predictor,
            Seed::Intermediate(points),
            Seed::March(points),
        ];
        seeds.into_iter().find(|seed| seed.to_string() == text).ok_or_else(|| NotASeed(text.to_owned()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_seed_is_read_as_it_is_written() {
        let alone = [Seed::None, Seed::Hertz, Seed::Elastic, Seed::RescaledElastic, Seed::ThickFilm, Seed::Table];
        let counted = [0, 1, 12].into_iter().flat_map(|points| [Seed::Intermediate(points), Seed::March(points)]);
        for seed in alone.into_iter().chain([Seed::Neighbour, Seed::Predictor]).chain(counted) {
            assert_eq!(seed.to_string().parse(), Ok(seed));
        }
        for text in ["", "march", "march-", "march--1", "march-01", "Hertz", "hertz-1"] {
            assert!(text.parse::<Seed>().is_err(), "{text}");
        }
    }
}
