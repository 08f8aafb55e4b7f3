//! The three axes of a sweep as pictures show them.

use super::engineering::{ShownUnit, digits, with_unit};
use stribeck_sweep::Dimension;
use stribeck_sweep::store::DataSet;

/// An axis of a sweep, in the order of the indices of a place.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Axis {
    /// Strength of retardation, together with the slide-to-roll ratio where that is a dimension.
    F,
    /// α, or the quantities of the laboratory between f and the speed, taken together.
    Middle,
    /// Along rows: β, or the speed.
    Inner,
}

/// What an axis of a data set is called, and its values.
#[derive(Clone, Debug, PartialEq)]
pub struct AxisWords {
    /// Name in files and options; empty for an axis that is none.
    pub name: String,
    /// Symbol in pictures.
    pub symbol: String,
    /// Symbol and definition or unit, beside an axis of a picture.
    pub label: String,
    /// Unit behind a value; empty for pure numbers.
    pub unit: String,
    /// Symbol and definition without the unit.
    pub title: String,
    /// How many digits tell the values apart.
    digits: usize,
    /// The values; where several quantities are taken together, their numbers from 1.
    pub values: Vec<f64>,
    /// What each value stands for, where several quantities are taken together.
    pub combinations: Vec<String>,
    /// The same as names and values.
    pub members: Vec<Vec<(String, f64)>>,
}

impl Axis {
    /// All, in the order of the indices.
    pub const ALL: [Self; 3] = [Self::F, Self::Middle, Self::Inner];

    /// Its place among the indices.
    pub fn dimension(self) -> usize {
        self as usize
    }

    /// The two others.
    pub fn others(self) -> [Self; 2] {
        match self {
            Axis::F => [Axis::Middle, Axis::Inner],
            Axis::Middle => [Axis::F, Axis::Inner],
            Axis::Inner => [Axis::F, Axis::Middle],
        }
    }
}

impl AxisWords {
    /// What several quantities that are taken together are called.
    pub const COMBINATION: &'static str = "combination";

    /// The axes of a data set, of which the dimensions that these values are asked for of may be fixed to one.
    pub fn of(data: &DataSet, asked: &[(String, Vec<f64>)]) -> [Self; 3] {
        let is_fixed = |name: &str| asked.iter().any(|(asked, values)| asked == name && values.len() == 1);
        let (last, before) = data.dimensions.split_last().expect("a data set has at least two dimensions");
        let named = |it: &Dimension| Self::named(&it.name, &it.units, &it.values);
        let (outer, between) = before.split_at(data.outer());
        let middle = match between {
            [] => Self { values: vec![0.0], ..Self::none() },
            [one] => named(one),
            several => Self::together(&several.iter().map(named).collect::<Vec<_>>(), is_fixed),
        };
        let first = match outer {
            [one] => named(one),
            several => Self::together(&several.iter().map(named).collect::<Vec<_>>(), is_fixed),
        };
        [first, middle, named(last)]
    }

    fn none() -> Self {
        let empty = String::new;
        Self {
            name: empty(),
            symbol: empty(),
            label: empty(),
            unit: empty(),
            title: empty(),
            digits: 3,
            values: Vec::new(),
            combinations: Vec::new(),
            members: Vec::new(),
        }
    }

    fn named(name: &str, units: &str, values: &[f64]) -> Self {
        let (symbol, words) = symbol_and_words(name);
        let unit = if units == "1" { String::new() } else { units.to_owned() };
        let label = if unit.is_empty() { words.to_owned() } else { format!("{words}  ({unit})") };
        let [name, symbol, title] = [name, symbol, words].map(str::to_owned);
        Self { name, symbol, label, unit, title, digits: digits(values), values: values.to_vec(), ..Self::none() }
    }

    /// Several axes as one, the last fastest. Where one of them alone has several values, or is not fixed, it lends its
    /// name and numbers.
    fn together(axes: &[Self], is_fixed: impl Fn(&str) -> bool) -> Self {
        // Indices on the axes.
        let mut places: Vec<Vec<usize>> = vec![Vec::new()];
        for axis in axes {
            let longer = |begun: &Vec<usize>| {
                let next = |i| begun.iter().copied().chain([i]).collect();
                (0..axis.values.len()).map(next).collect::<Vec<Vec<usize>>>()
            };
            places = places.iter().flat_map(longer).collect();
        }
        let words =
            |place: &Vec<usize>| place.iter().zip(axes).map(|(i, axis)| axis.words(*i)).collect::<Vec<_>>().join(", ");
        let members =
            |place: &Vec<usize>| place.iter().zip(axes).map(|(i, axis)| (axis.name.clone(), axis.values[*i])).collect();
        let symbols: Vec<String> = axes.iter().map(|axis| axis.symbol.clone()).collect();
        let combinations = places.iter().map(words).collect();
        let members = places.iter().map(members).collect();
        let mut varied = axes.iter().enumerate().filter(|(_, axis)| axis.values.len() > 1 && !is_fixed(&axis.name));
        if let (Some((at, alone)), None) = (varied.next(), varied.next()) {
            let values = places.iter().map(|place| alone.values[place[at]]).collect();
            return Self { values, combinations, members, ..alone.clone() };
        }
        Self {
            name: Self::COMBINATION.to_owned(),
            symbol: format!("({})", symbols.join(", ")),
            label: format!("combination of {}", symbols.join(", ")),
            title: format!("combination of {}", symbols.join(", ")),
            values: (1..=places.len()).map(|number| number as f64).collect(),
            combinations,
            members,
            ..Self::none()
        }
    }

    /// The unit of these numbers of the axis, and its name with the unit, in a picture.
    pub fn shown(&self, numbers: impl Iterator<Item = f64>) -> (ShownUnit, String) {
        let largest = numbers.filter(|number| number.is_finite()).fold(0.0, |largest: f64, it| largest.max(it.abs()));
        let unit = ShownUnit::of(&self.unit, largest);
        let label = unit.label(&typeset(&self.title));
        (unit, label)
    }

    /// "β = 100", "V = 1 mm/s"; empty for an axis that is none.
    pub fn words(&self, index: usize) -> String {
        if self.name.is_empty() {
            return String::new();
        }
        match self.combinations.get(index) {
            Some(combination) => combination.clone(),
            None => format!("{} = {}", self.symbol, with_unit(self.values[index], &self.unit, self.digits)),
        }
    }
}

/// A quantity held at one value: "N = 400 N/m".
pub fn held(name: &str, si: &str, value: f64) -> String {
    let unit = if si == "1" { "" } else { si };
    format!("{} = {}", symbol_and_words(name).0, with_unit(value, unit, 3))
}

/// Symbol of an axis or a quantity of the laboratory, and what it is.
pub fn symbol_and_words(name: &str) -> (&str, &str) {
    match name {
        "slide_roll" => ("S", "slide-to-sum ratio S = (u₂ − u₁)/(u₁ + u₂)"),
        "f" => ("f", "f = E₀/E∞ − 1"),
        "alpha" => ("α", "α = a₀/(Vτ)"),
        "beta" => ("β", "β = E∞* a₀⁴/(12ηVR³)"),
        "radius" => ("R", "radius R"),
        "load" => ("N", "load N"),
        "relaxed_modulus" => ("E∞", "relaxed modulus E∞"),
        "instantaneous_modulus" => ("E₀", "instantaneous modulus E₀"),
        "poisson_ratio" => ("ν", "Poisson's ratio ν"),
        "viscosity" => ("η", "viscosity η"),
        "retardation_time" => ("τ", "retardation time τ"),
        "temperature" => ("T", "temperature T"),
        "speed" => ("V", "speed V"),
        "entrainment_speed" => ("U", "entrainment speed U = (u₁ + u₂)/2"),
        "slide_roll_ratio" => ("SRR", "slide-to-roll ratio SRR = (u₂ − u₁)/U"),
        "roller_speed" => ("u₁", "speed of the roller's surface u₁"),
        "flat_speed" => ("u₂", "speed of the flat u₂"),
        other => (other, other),
    }
}

/// Words with the ∞ of E∞ as a subscript.
pub fn typeset(words: &str) -> String {
    words.replace("E∞", "E_{∞}")
}
