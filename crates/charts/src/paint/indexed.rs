//! A picture in at most 256 colours, which a PNG holds in a byte for each pixel.

use std::collections::HashMap;

type Colour = [u8; 3];

/// A palette, and for each pixel its place there.
pub(crate) struct Indexed {
    pub(crate) palette: Vec<Colour>,
    pub(crate) pixels: Vec<u8>,
}

/// Two colours nearer than this (squared, over three channels) look the same.
const ALIKE: u32 = 60;

/// Up to 256 colours are kept as they are. Of more, the most frequent are kept, but of those that look alike only one
/// while there are others; the rest, which are shades along edges, become the nearest of those kept.
pub(crate) fn indexed(pixels: &[Colour]) -> Indexed {
    let mut counts: HashMap<Colour, usize> = HashMap::new();
    for pixel in pixels {
        *counts.entry(*pixel).or_default() += 1;
    }
    let mut colours: Vec<(Colour, usize)> = counts.into_iter().collect();
    // By colour where counts are equal, so that the picture does not depend on the order of the map.
    colours.sort_by(|one, other| other.1.cmp(&one.1).then(one.0.cmp(&other.0)));

    let mut palette: Vec<Colour> = Vec::new();
    let mut alike: Vec<Colour> = Vec::new();
    for (colour, _) in &colours {
        let new = palette.iter().all(|kept| distance(kept, colour) >= ALIKE);
        if new { &mut palette } else { &mut alike }.push(*colour);
    }
    palette.extend(alike);
    palette.truncate(256);

    let nearest = |colour: &Colour| {
        (0..palette.len()).min_by_key(|i| distance(&palette[*i], colour)).expect("a picture has a pixel") as u8
    };
    let places: HashMap<Colour, u8> = colours.iter().map(|(colour, _)| (*colour, nearest(colour))).collect();
    Indexed { pixels: pixels.iter().map(|pixel| places[pixel]).collect(), palette }
}

fn distance(one: &Colour, other: &Colour) -> u32 {
    one.iter().zip(other).map(|(a, b)| u32::from(a.abs_diff(*b)).pow(2)).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn few_colours_are_kept_exactly() {
        let pixels: Vec<Colour> = (0..5000u32).map(|i| [(i % 256) as u8, (i % 2) as u8, 7]).collect();
        let Indexed { palette, pixels: places } = indexed(&pixels);
        assert_eq!(palette.len(), 256);
        assert!(pixels.iter().zip(places).all(|(pixel, place)| palette[usize::from(place)] == *pixel));
    }

    #[test]
    fn rare_colours_become_near_ones() {
        let frequent = (0..=255u8).flat_map(|i| [[i, i.wrapping_mul(37), 0]; 3]);
        let pixels: Vec<Colour> = frequent.chain([[10, 114, 1], [200, 232, 2]]).collect();
        let Indexed { palette, pixels: places } = indexed(&pixels);
        assert_eq!(palette.len(), 256);
        for (pixel, place) in pixels.iter().zip(places) {
            assert!(distance(&palette[usize::from(place)], pixel) < ALIKE);
        }
    }
}
