//! Places of a grid, by their indices and by their number.

/// The indices of a place of a grid.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct GridIndex {
    /// Which value of f.
    pub f: usize,
    /// Which row of those with this f: α in a dimensionless sweep, else the quantities between f and the speed
    /// together.
    pub row: usize,
    /// Which place along the row: β, or the speed.
    pub along: usize,
}

impl From<[usize; 3]> for GridIndex {
    /// Takes the indices in the order f, row, place along the row.
    fn from([f, row, along]: [usize; 3]) -> Self {
        Self { f, row, along }
    }
}

/// The lengths of a grid. Places are counted in the order f, row, place along the row, the last one fastest.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct GridShape {
    /// Number of values of f.
    pub strengths: usize,
    /// Number of rows with each f.
    pub rows: usize,
    /// Number of places along a row.
    pub length: usize,
}

impl GridShape {
    /// The lengths in the order f, row, place along the row.
    pub fn lengths(self) -> [usize; 3] {
        [self.strengths, self.rows, self.length]
    }

    /// Number of places.
    pub fn places(self) -> usize {
        self.strengths * self.rows * self.length
    }

    /// The number of the place with these indices.
    pub fn place(self, index: GridIndex) -> usize {
        (index.f * self.rows + index.row) * self.length + index.along
    }

    /// The indices of the place with this number.
    pub fn index(self, place: usize) -> GridIndex {
        let row = place / self.length;
        GridIndex { f: row / self.rows, row: row % self.rows, along: place % self.length }
    }

    /// The indices of all places of a row, which are counted as places are.
    pub fn row(self, row: usize) -> impl Iterator<Item = GridIndex> {
        let (f, row) = (row / self.rows, row % self.rows);
        (0..self.length).map(move |along| GridIndex { f, row, along })
    }
}

/// The indices on dimensions of these lengths of a place that is counted with the last dimension fastest.
///
/// # Panics
/// If there is no such place.
pub(crate) fn indices(lengths: impl DoubleEndedIterator<Item = usize>, place: usize) -> Vec<usize> {
    let mut rest = place;
    let mut indices: Vec<usize> = lengths
        .rev()
        .map(|length| {
            let index = rest % length;
            rest /= length;
            index
        })
        .collect();
    assert_eq!(rest, 0, "place {place} is not in the grid");
    indices.reverse();
    indices
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn places_are_counted_along_rows() {
        let shape = GridShape { strengths: 2, rows: 3, length: 4 };
        let all = (0..6).flat_map(|row| shape.row(row));
        for (place, index) in all.enumerate() {
            assert_eq!((shape.place(index), shape.index(place)), (place, index));
            assert_eq!(indices(shape.lengths().into_iter(), place), [index.f, index.row, index.along]);
        }
        assert_eq!(shape.places(), 24);
    }
}
