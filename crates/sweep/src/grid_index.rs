//! Places of a grid, by their indices and by their number.

/// The indices of a place of a grid.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct GridIndex {
    /// Which block of rows: f, together with the slide-to-roll ratio before it where that is an axis.
    pub block: usize,
    /// Which row of the block: α in a dimensionless sweep, else the quantities between f and the speed together.
    pub row: usize,
    /// Which place along the row: β, or the speed.
    pub along: usize,
}

impl From<[usize; 3]> for GridIndex {
    /// Takes the indices in the order block, row, place along the row.
    fn from([block, row, along]: [usize; 3]) -> Self {
        Self { block, row, along }
    }
}

/// The lengths of a grid. Places are counted in the order block, row, place along the row, the last one fastest.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct GridShape {
    /// Number of blocks.
    pub blocks: usize,
    /// Number of rows of each block.
    pub rows: usize,
    /// Number of places along a row.
    pub length: usize,
}

impl GridShape {
    /// The lengths in the order block, row, place along the row.
    pub fn lengths(self) -> [usize; 3] {
        [self.blocks, self.rows, self.length]
    }

    /// Number of places.
    pub fn places(self) -> usize {
        self.blocks * self.rows * self.length
    }

    /// The number of the place with these indices.
    pub fn place(self, index: GridIndex) -> usize {
        (index.block * self.rows + index.row) * self.length + index.along
    }

    /// The indices of the place with this number.
    pub fn index(self, place: usize) -> GridIndex {
        let row = place / self.length;
        GridIndex { block: row / self.rows, row: row % self.rows, along: place % self.length }
    }

    /// The indices of all places of a row, which are counted as places are.
    pub fn row(self, row: usize) -> impl Iterator<Item = GridIndex> {
        let (block, row) = (row / self.rows, row % self.rows);
        (0..self.length).map(move |along| GridIndex { block, row, along })
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

/// The place with these indices on dimensions of these lengths.
pub(crate) fn place(lengths: impl Iterator<Item = usize>, indices: &[usize]) -> usize {
    lengths.zip(indices).fold(0, |place, (length, index)| place * length + index)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn places_are_counted_along_rows() {
        let shape = GridShape { blocks: 2, rows: 3, length: 4 };
        let all = (0..6).flat_map(|row| shape.row(row));
        for (number, index) in all.enumerate() {
            assert_eq!((shape.place(index), shape.index(number)), (number, index));
            let on_axes = indices(shape.lengths().into_iter(), number);
            assert_eq!(on_axes, [index.block, index.row, index.along]);
            assert_eq!(place(shape.lengths().into_iter(), &on_axes), number);
        }
        assert_eq!(shape.places(), 24);
    }
}
