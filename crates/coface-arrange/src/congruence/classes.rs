//! Classes of cells with signs.

use coface_algebra::CellId;
use coface_algebra::Error;
use coface_algebra::{RaggedArray, Sign, SparseMatrix};

/// No class.
pub(super) const NONE: u32 = u32::MAX;
/// More than one class: they are in the list of split cells.
const SEVERAL: u32 = u32::MAX - 1;

/// Classes of congruent cells of one degree, with signs.
///
/// The **image** of a cell is what it becomes: one class with a sign; no class when it collapsed; several when it was
/// split into pieces.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct CellClasses {
    members: RaggedArray,
    class_of: Vec<u32>,
    signs: Vec<Sign>,
    split: SplitCells,
}

/// Cells with several classes, rising, with the lists of these and their signs.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
struct SplitCells {
    cells: Vec<u32>,
    classes: RaggedArray,
    signs: Vec<Sign>,
}

impl CellClasses {
    /// The classes with these numbers, all signs plus: the class of each cell, counted from 0 without gaps in the order
    /// of the lowest members.
    ///
    /// # Errors
    /// [`coface_algebra::ErrorKind::InvalidInput`] naming the first cell where the numbers are not in that order.
    ///
    /// # Examples
    /// ```
    /// use coface_arrange::congruence::CellClasses;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let classes = CellClasses::unsigned(vec![0, 1, 0])?;
    /// assert_eq!(classes.members().list(0), [0, 2]);
    /// assert!(CellClasses::unsigned(vec![1, 0]).is_err());
    /// # Ok(()) }
    /// ```
    pub fn unsigned(class_of: Vec<u32>) -> Result<Self, Error> {
        let mut count = 0;
        for (cell, &class) in class_of.iter().enumerate() {
            if class > count {
                return Err(Error::invalid(format!(
                    "cell {cell} is in class {class}, but no cell before it in class {count}"
                ))
                .with_cure("number the classes by their lowest members"));
            }
            count += u32::from(class == count);
        }
        let signs = vec![Sign::Plus; class_of.len()];
        let members = RaggedArray::grouped(count as usize, class_of.iter().copied());
        Ok(Self { members, class_of, signs, split: SplitCells::default() })
    }

    /// The classes of cells that have one class or [`NONE`].
    pub(super) fn single(class_count: usize, class_of: Vec<u32>, signs: Vec<Sign>) -> Self {
        let members = if class_of.contains(&NONE) {
            let with_classes: Vec<u32> =
                (0..class_of.len() as u32).filter(|&cell| class_of[cell as usize] != NONE).collect();
            let keys = with_classes.iter().map(|&cell| class_of[cell as usize]);
            let mut members = RaggedArray::grouped(class_count, keys);
            members.items_mut().iter_mut().for_each(|position| *position = with_classes[*position as usize]);
            members
        } else {
            RaggedArray::grouped(class_count, class_of.iter().copied())
        };
        Self { members, class_of, signs, split: SplitCells::default() }
    }

    /// The classes of cells that have one or more columns each, by the class of each column or [`NONE`].
    pub(super) fn of_columns(
        class_count: usize,
        cell_count: usize,
        owners: &[u32],
        class_of_column: &[u32],
        signs: &[Sign],
    ) -> Self {
        let mut found = Self {
            members: RaggedArray::new(),
            class_of: Vec::with_capacity(cell_count),
            signs: Vec::with_capacity(cell_count),
            split: SplitCells::default(),
        };
        let mut start = 0;
        for columns in owners.chunk_by(|a, b| a == b) {
            let range = start..start + columns.len();
            start = range.end;
            if let [class] = class_of_column[range.clone()] {
                found.class_of.push(class);
                found.signs.push(signs[range.start]);
            } else {
                found.split.cells.push(columns[0]);
                found.split.classes.push(&class_of_column[range.clone()]);
                found.split.signs.extend_from_slice(&signs[range]);
                found.class_of.push(SEVERAL);
                found.signs.push(Sign::Plus);
            }
        }
        found.members = grouped_members(class_count, &found);
        found
    }

    /// The same with new numbers for the classes, rising, or [`NONE`] for classes that are no more.
    pub(super) fn renumbered(&self, numbers: &[u32]) -> Self {
        let number = |&class: &u32| numbers.get(class as usize).copied().unwrap_or(class);
        let mut split = self.split.clone();
        split.classes.items_mut().iter_mut().for_each(|class| *class = number(class));
        Self {
            members: RaggedArray::from_lists(
                self.members.iter().zip(numbers).filter(|&(_, &number)| number != NONE).map(|(list, _)| list),
            ),
            class_of: self.class_of.iter().map(number).collect(),
            signs: self.signs.clone(),
            split,
        }
    }

    /// The number of classes.
    ///
    /// # Examples
    /// ```
    /// use coface_arrange::congruence::CellClasses;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let classes = CellClasses::unsigned(vec![0, 1, 0])?;
    /// assert_eq!(classes.class_count(), 2);
    /// # Ok(()) }
    /// ```
    pub fn class_count(&self) -> usize {
        self.members.len()
    }

    /// The members of each class, rising: the cells that have it in their images; classes by their lowest members.
    ///
    /// # Examples
    /// ```
    /// use coface_arrange::congruence::CellClasses;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let classes = CellClasses::unsigned(vec![0, 1, 0])?;
    /// assert_eq!(classes.members().list(0), [0, 2]);
    /// # Ok(()) }
    /// ```
    pub fn members(&self) -> &RaggedArray {
        &self.members
    }

    /// The class of a cell and its sign against the lowest member; `None` for a cell that collapsed or has several
    /// classes.
    ///
    /// # Panics
    /// If there is no such cell.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::{CellId, Sign};
    /// use coface_arrange::congruence::CellClasses;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let classes = CellClasses::unsigned(vec![0, 1, 0])?;
    /// assert_eq!(classes.class(CellId::new(2)), Some((0, Sign::Plus)));
    /// # Ok(()) }
    /// ```
    pub fn class(&self, cell: CellId) -> Option<(usize, Sign)> {
        let class = self.class_of[cell.index()];
        (class < SEVERAL).then(|| (class as usize, self.signs[cell.index()]))
    }

    /// The image of a cell: classes with signs against their lowest members. There is none for a collapsed cell; a
    /// class that occurs twice counts twice.
    ///
    /// # Panics
    /// If there is no such cell.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::CellId;
    /// use coface_algebra::Sign;
    /// use coface_arrange::congruence::CellClasses;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let classes = CellClasses::unsigned(vec![0, 1, 0])?;
    /// assert!(classes.image(CellId::new(2)).eq([(0, Sign::Plus)]));
    /// # Ok(()) }
    /// ```
    pub fn image(&self, cell: CellId) -> impl ExactSizeIterator<Item = (usize, Sign)> + Clone + '_ {
        let (classes, signs) = self.image_lists(cell.index());
        classes.iter().zip(signs).map(|(&class, &sign)| (class as usize, sign))
    }

    /// The image of a cell as two lists.
    pub(super) fn image_lists(&self, cell: usize) -> (&[u32], &[Sign]) {
        match self.class_of[cell] {
            NONE => (&[], &[]),
            SEVERAL => {
                let place =
                    self.split.cells.binary_search(&(cell as u32)).expect("the split cells are listed");
                let range = self.split.classes.start(place)..self.split.classes.start(place + 1);
                (&self.split.classes.items()[range.clone()], &self.split.signs[range])
            }
            _ => (&self.class_of[cell..=cell], &self.signs[cell..=cell]),
        }
    }

    /// Class and sign of each cell, if no cell has several classes; [`NONE`] for a collapsed cell.
    pub(super) fn as_single(&self) -> Option<(&[u32], &[Sign])> {
        self.split.cells.is_empty().then_some((&self.class_of, &self.signs))
    }

    /// The number of cells without a class.
    ///
    /// # Examples
    /// ```
    /// use coface_arrange::congruence::CellClasses;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let classes = CellClasses::unsigned(vec![0, 1, 0])?;
    /// assert_eq!(classes.collapsed_count(), 0);
    /// # Ok(()) }
    /// ```
    pub fn collapsed_count(&self) -> usize {
        self.class_of.iter().filter(|&&class| class == NONE).count()
    }

    /// The number of cells.
    ///
    /// # Examples
    /// ```
    /// use coface_arrange::congruence::CellClasses;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let classes = CellClasses::unsigned(vec![0, 1, 0])?;
    /// assert_eq!(classes.cell_count(), 3);
    /// # Ok(()) }
    /// ```
    pub fn cell_count(&self) -> usize {
        self.class_of.len()
    }

    /// The cells with several classes, rising.
    ///
    /// # Examples
    /// ```
    /// use coface_arrange::congruence::CellClasses;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let classes = CellClasses::unsigned(vec![0, 1, 0])?;
    /// assert!(classes.split_cells().is_empty());
    /// # Ok(()) }
    /// ```
    pub fn split_cells(&self) -> &[u32] {
        &self.split.cells
    }

    /// The matrix that takes cells to classes: a row for each class, a column for each cell.
    ///
    /// # Errors
    /// [`coface_algebra::ErrorKind::TooLarge`] for counts beyond 32 bits.
    ///
    /// # Examples
    /// ```
    /// use coface_arrange::congruence::CellClasses;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let classes = CellClasses::unsigned(vec![0, 1, 0])?;
    /// let matrix = classes.matrix()?;
    /// assert_eq!((matrix.row_count(), matrix.column_count()), (2, 3));
    /// assert_eq!(matrix.column(2).rows(), [0]);
    /// # Ok(()) }
    /// ```
    pub fn matrix(&self) -> Result<SparseMatrix, Error> {
        let entries = (0..self.cell_count()).flat_map(|cell| {
            self.image(CellId::new(cell)).map(move |(class, sign)| (class, cell, i64::from(sign.to_i32())))
        });
        SparseMatrix::from_entries(self.class_count(), self.cell_count(), entries)
    }
}

/// The members of each class: each cell once, however often it has the class.
fn grouped_members(class_count: usize, classes: &CellClasses) -> RaggedArray {
    let mut pairs: Vec<(u32, u32)> = Vec::with_capacity(classes.cell_count());
    for cell in 0..classes.cell_count() {
        pairs.extend(classes.image_lists(cell).0.iter().map(|&class| (class, cell as u32)));
    }
    pairs.sort_unstable();
    pairs.dedup();
    let mut members = RaggedArray::grouped(class_count, pairs.iter().map(|&(class, _)| class));
    members.items_mut().iter_mut().for_each(|position| *position = pairs[*position as usize].1);
    members
}
