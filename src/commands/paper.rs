//! Options of commands that draw: how their pictures stand on paper.

use clap::Args;

use super::CliError;
use super::number::number;
use crate::pictures::Chart;
use stribeck_charts::Paper;

/// Title, size and letters of pictures.
#[derive(Clone, Debug, Args)]
pub struct PaperArguments {
    /// Another title above the pictures; "" for none
    #[arg(long, value_name = "TEXT", conflicts_with = "no_title")]
    title: Option<String>,
    /// Neither a title nor the line below it
    #[arg(long)]
    no_title: bool,
    /// Width of the pictures, as in 85mm, 3.3in or 700 (pixels) [default: 700, PNG 1600]
    #[arg(long, value_name = "LENGTH", value_parser = length)]
    width: Option<Length>,
    /// Height of the pictures, as in 60mm [default: it follows from the width]
    #[arg(long, value_name = "LENGTH", value_parser = length)]
    height: Option<Length>,
    /// Size of letters at this width, in points [default: by the number of panels]
    #[arg(long, value_name = "POINTS", value_parser = points)]
    font_size: Option<f64>,
}

/// A length in both of its meanings.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Length {
    /// In pixels of 1/96 inch.
    on_paper: f64,
    /// Pixels of a PNG.
    pixels: u32,
}

/// Pixels for an inch in a PNG whose width has a unit.
const PER_INCH: f64 = 300.0;

/// A length with its unit.
fn length(text: &str) -> Result<Length, String> {
    const UNITS: [(&str, f64); 5] = [("mm", 25.4), ("cm", 2.54), ("in", 1.0), ("pt", 72.0), ("px", 96.0)];
    let text = text.trim();
    let (digits, unit, per_inch) = UNITS
        .into_iter()
        .find_map(|(unit, per_inch)| Some((text.strip_suffix(unit)?.trim_end(), unit, per_inch)))
        .unwrap_or((text, "px", 96.0));
    let inches = number(digits).map(|length| length / per_inch).filter(|inches| (0.5..=40.0).contains(inches));
    let inches = inches.ok_or("a length from 0.5 to 40 inches, as in 85mm, 17cm, 3.3in, 240pt or 700 (pixels)")?;
    let pixels = if unit == "px" { 96.0 * inches } else { (PER_INCH * inches).min(4000.0) };
    Ok(Length { on_paper: 96.0 * inches, pixels: pixels.round() as u32 })
}

/// A size of letters; whether it fits the width is for the chart to say.
fn points(text: &str) -> Result<f64, String> {
    number(text).filter(|points| (1.0..=200.0).contains(points)).ok_or_else(|| "points, as in 8".to_owned())
}

impl PaperArguments {
    /// The paper of pictures that are made with these options, too.
    pub fn paper(&self, others: &[&'static str]) -> Paper {
        let paper = Paper::default();
        let Length { on_paper: width, pixels } =
            self.width.unwrap_or(Length { on_paper: paper.width, pixels: paper.pixels });
        let height = self.height.map(|height| height.on_paper);
        let note = others.iter().copied().chain(self.given()).collect::<Vec<_>>().join(" ");
        Paper { width, height, pixels, font_size: self.font_size, heading: !self.no_title, note }
    }

    /// Refuses these options where no picture is drawn; `draw` says how one is.
    pub fn check_drawn(&self, is_drawn: bool, draw: &str) -> Result<(), CliError> {
        match self.given().next().filter(|_| !is_drawn) {
            Some(option) => {
                Err(CliError::Unused { option, why: format!("no picture is drawn; {draw}, or leave it out") })
            }
            None => Ok(()),
        }
    }

    /// Gives a chart its title, if one was asked for.
    pub fn entitle(&self, chart: &mut Chart) {
        if let Some(title) = &self.title {
            chart.set_title(title);
        }
    }

    /// The names of the options that are there.
    fn given(&self) -> impl Iterator<Item = &'static str> {
        let all = [
            ("--title", self.title.is_some()),
            ("--no-title", self.no_title),
            ("--width", self.width.is_some()),
            ("--height", self.height.is_some()),
            ("--font-size", self.font_size.is_some()),
        ];
        all.into_iter().filter(|(_, is_there)| *is_there).map(|(name, _)| name)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lengths_have_a_unit_or_are_pixels() {
        assert_eq!(length("700"), Ok(Length { on_paper: 700.0, pixels: 700 }));
        let column = length("85 mm").unwrap();
        assert!((column.on_paper - 321.26).abs() < 0.01 && column.pixels == 1004, "{column:?}");
        assert_eq!(length("3.3in").unwrap().pixels, 990);
        for text in ["", "mm", "85 km", "1mm", "nan", "-700", "1e9"] {
            assert!(length(text).is_err(), "{text}");
        }
    }
}
