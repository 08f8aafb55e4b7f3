//! The nodes of a surface: a set of indices that holds with each index all smaller ones.

use std::collections::HashMap;

use super::leja::Leja;

/// An index of a node along each axis; 0 on axes that are not there.
pub type Index = [u16; 3];

/// The most nodes along one axis.
pub const MOST_ALONG: usize = 400;

/// How many neighbours in a row are added at once.
const GENERATIONS: usize = 4;

/// What an index is expected to change, over what the one before it does.
const DECAY: f64 = 0.5;

/// A lower set of indices.
#[derive(Clone, Debug)]
pub struct LowerSet {
    dimensions: usize,
    indices: Vec<Index>,
    places: HashMap<Index, usize>,
}

impl LowerSet {
    /// All indices whose sum is at most `degree`.
    pub fn simplex(dimensions: usize, degree: u16) -> Self {
        let mut set = Self { dimensions, indices: Vec::new(), places: HashMap::new() };
        let most = |place: usize| if place < dimensions { degree } else { 0 };
        for i in 0..=most(0) {
            for j in 0..=most(1) {
                for k in 0..=most(2) {
                    if i + j + k <= degree {
                        set.add([i, j, k]);
                    }
                }
            }
        }
        set
    }

    /// The indices, in the order in which they came.
    pub fn indices(&self) -> &[Index] {
        &self.indices
    }

    /// The number of nodes along each axis.
    pub fn shape(&self) -> Vec<usize> {
        let most = |axis: usize| self.indices.iter().map(|index| index[axis]).max().unwrap_or(0);
        (0..self.dimensions).map(|axis| usize::from(most(axis)) + 1).collect()
    }

    fn add(&mut self, index: Index) {
        if let std::collections::hash_map::Entry::Vacant(place) = self.places.entry(index) {
            place.insert(self.indices.len());
            self.indices.push(index);
        }
    }

    /// The neighbours of an index that may be added: all indices before them are there.
    fn possible(&self, index: Index) -> impl Iterator<Item = Index> + '_ {
        (0..self.dimensions).filter_map(move |axis| {
            let mut next = index;
            next[axis] += 1;
            let is_new = !self.places.contains_key(&next) && usize::from(next[axis]) < MOST_ALONG;
            (is_new && self.before(next).all(|before| self.places.contains_key(&before))).then_some(next)
        })
    }

    /// The indices one before an index.
    fn before(&self, index: Index) -> impl Iterator<Item = Index> + '_ {
        (0..self.dimensions).filter(move |axis| index[*axis] > 0).map(move |axis| {
            let mut before = index;
            before[axis] -= 1;
            before
        })
    }

    /// How much each index matters, from what each changes: that, and half of what those before it do. One index of a
    /// series may be small by chance, two seldom are.
    fn weights(&self, changes: &[f64]) -> Vec<f64> {
        let of_those_before = |index: Index| self.before(index).map(|before| changes[self.places[&before]]);
        let weight =
            |(&index, &change): (&Index, &f64)| of_those_before(index).fold(change, |most, it| most.max(0.5 * it));
        self.indices.iter().zip(changes).map(weight).collect()
    }

    /// The largest weight of an index that has a neighbour to add; 0 if none has.
    pub fn open_weight(&self, changes: &[f64]) -> f64 {
        let weights = self.weights(changes);
        let open = self.indices.iter().zip(weights).filter(|(index, _)| self.possible(**index).next().is_some());
        open.map(|(_, weight)| weight).fold(0.0, f64::max)
    }

    /// Adds the neighbours of all indices of a weight of at least `threshold`, and theirs, as far as they are expected
    /// to change so much: so a round has work for many threads.
    pub fn grow(&mut self, changes: &[f64], threshold: f64) {
        let mut weights = self.weights(changes);
        // What an index is expected to change; what it is known to, where it is there already.
        let mut expected = changes.to_vec();
        for _ in 0..GENERATIONS {
            let heavy = self.indices.iter().enumerate().filter(|(place, _)| weights[*place] >= threshold);
            let new: Vec<(Index, f64)> = heavy
                .flat_map(|(place, index)| {
                    let change = DECAY * expected[place];
                    self.possible(*index).map(move |next| (next, change))
                })
                .collect();
            for (index, change) in new {
                self.add(index);
                expected.resize(self.indices.len(), 0.0);
                let known = &mut expected[self.places[&index]];
                *known = known.max(change);
            }
            weights.extend_from_slice(&expected[weights.len()..]);
        }
    }

    /// From values at the nodes to what each index adds to the interpolant of those before it, at most, anywhere.
    pub fn surpluses(&self, leja: &Leja, values: &[f64]) -> Vec<f64> {
        self.along_lines(values, |line| leja.surpluses(line))
    }

    /// From surpluses to Chebyshev coefficients, on the full box of [`LowerSet::shape`], the last axis fastest.
    pub fn coefficients(&self, leja: &Leja, surpluses: &[f64]) -> Vec<f64> {
        let coefficients = self.along_lines(surpluses, |line| leja.chebyshev(line));
        let shape = self.shape();
        let mut all = vec![0.0; shape.iter().product()];
        for (index, coefficient) in self.indices.iter().zip(coefficients) {
            let place = shape.iter().zip(index).fold(0, |place, (length, i)| place * length + usize::from(*i));
            all[place] = coefficient;
        }
        all
    }

    /// Changes numbers along all lines of each axis in turn.
    fn along_lines(&self, numbers: &[f64], change: impl Fn(&mut [f64])) -> Vec<f64> {
        let mut numbers = numbers.to_vec();
        let mut line = Vec::new();
        for axis in 0..self.dimensions {
            for start in self.indices.iter().filter(|index| index[axis] == 0) {
                let along = |k: u16| {
                    let mut index = *start;
                    index[axis] = k;
                    self.places.get(&index).copied()
                };
                let places: Vec<usize> = (0..).map_while(along).collect();
                line.clear();
                line.extend(places.iter().map(|&place| numbers[place]));
                change(&mut line);
                places.iter().zip(&line).for_each(|(&place, number)| numbers[place] = *number);
            }
        }
        numbers
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The function of a node.
    fn values(set: &LowerSet, leja: &Leja, function: impl Fn([f64; 3]) -> f64) -> Vec<f64> {
        let at = |index: &Index| function(index.map(|i| leja.nodes[usize::from(i)]));
        set.indices().iter().map(at).collect()
    }

    /// A polynomial within the set is itself: T_2(x) T_1(y) + 3 T_3(z), and nothing else.
    #[test]
    fn a_polynomial_of_the_set_comes_back() {
        let (set, leja) = (LowerSet::simplex(3, 4), Leja::new(10));
        let numbers = values(&set, &leja, |[x, y, z]| (2.0 * x * x - 1.0) * y + 3.0 * (4.0 * z * z * z - 3.0 * z));
        let coefficients = set.coefficients(&leja, &set.surpluses(&leja, &numbers));
        let shape = set.shape();
        assert_eq!(shape, [5, 5, 5]);
        for (place, coefficient) in coefficients.iter().enumerate() {
            let expected = match place {
                55 => 1.0, // (2, 1, 0)
                3 => 3.0,  // (0, 0, 3)
                _ => 0.0,
            };
            assert!((coefficient - expected).abs() < 1e-13, "{place}: {coefficient}");
        }
    }

    /// Growing keeps the set lower, and follows the direction in which a function changes.
    #[test]
    fn growing_follows_the_function() {
        let (mut set, leja) = (LowerSet::simplex(2, 2), Leja::new(MOST_ALONG));
        for _ in 0..20 {
            let numbers = values(&set, &leja, |[x, y, _]| 1.0 / (1.3 - x) + 0.1 * y);
            let changes: Vec<f64> = set.surpluses(&leja, &numbers).iter().map(|change| change.abs()).collect();
            set.grow(&changes, 1e-3);
        }
        let shape = set.shape();
        assert!(shape[0] > 8 && shape[1] < 6, "{shape:?}");
        for index in set.indices() {
            assert!(set.before(*index).all(|before| set.places.contains_key(&before)), "{index:?}");
        }
        let numbers = values(&set, &leja, |[x, y, _]| 1.0 / (1.3 - x) + 0.1 * y);
        let changes: Vec<f64> = set.surpluses(&leja, &numbers).iter().map(|change| change.abs()).collect();
        assert!(set.open_weight(&changes) < 1e-3);
    }
}
