//! How an image is cut into blocks.

use super::super::circles::Circles;
use super::super::filtration::{ImageConstruction, require_axes};
use super::super::grid::MOST_AXES;
use crate::homology::Coefficients;
use crate::persistence::reduction::prime;
use coface_algebra::{Error, ErrorKind};

/// No image is cut into more blocks.
const MOST_BLOCKS: usize = 1_000_000;

/// An image cut into blocks, boxes of voxels, with what is asked about it. It knows the shape of the image, not its numbers.
///
/// Blocks are numbered so that neighbors have near numbers, along a curve of Morton; numbers run from 0.
///
/// # Examples
/// Two valleys with a pass between them, in two blocks: the second one knows of the first one the voxel beside it alone.
/// ```
/// use coface_topology::{ImageBlocks, ImageFiltration, ImagePart, Coefficients};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let row = [0.0, 5.0, 1.0, 2.0];
/// let blocks = ImageBlocks::new(&[4], &[2])?;
/// assert_eq!(blocks.count(), 2);
/// assert_eq!(blocks.window(1), [[1, 2, 3]]);
/// let part = |number: u32| blocks.part(number, blocks.window(number)[0].iter().map(|&voxel| row[voxel]));
/// let diagram = ImagePart::merged(&[part(0)?, part(1)?])?.diagram()?;
/// assert_eq!(diagram, ImageFiltration::new(&[4], row)?.persistence(Coefficients::Modulo(2))?);
/// assert_eq!((diagram.pairs()[1].birth(), diagram.pairs()[1].death()), (1.0, Some(5.0)));
/// # Ok(()) }
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ImageBlocks {
    shape: Vec<usize>,
    /// The voxels of a block along each axis; those at the end may have fewer.
    sides: Vec<usize>,
    construction: ImageConstruction,
    is_superlevel: bool,
    is_periodic: Vec<bool>,
    prime: u32,
    /// The number of blocks along each axis.
    counts: Vec<usize>,
    /// The number of the block at each place; places run along the last axis first.
    numbers: Vec<u32>,
    /// The place of each block.
    places: Vec<u32>,
}

impl ImageBlocks {
    /// An image of this shape cut into blocks of so many voxels along each axis, those at the end of an axis perhaps with fewer. It grows by sublevel
    /// sets in the T-construction, over two elements.
    ///
    /// # Errors
    /// [`ErrorKind::Shape`] unless one to four axes are longer than 1 and each has a side of a block of one voxel or more; [`ErrorKind::TooLarge`]
    /// for more than a million blocks, for 2^57 voxels, and for 2^32 - 1 voxels in a block with the layer around it.
    ///
    /// # Complexity
    /// $O(b \log b)$ time and $O(b)$ space for b blocks.
    ///
    /// # Examples
    /// See [`ImageBlocks`].
    pub fn new(shape: &[usize], block: &[usize]) -> Result<Self, Error> {
        require_axes(shape)?;
        if block.len() != shape.len() || block.contains(&0) {
            return Err(Error::new(
                ErrorKind::Shape,
                format!("blocks of shape {block:?} for an image of shape {shape:?}"),
            )
            .with_cure("give the number of voxels of a block along each axis, one or more"));
        }
        let sides: Vec<usize> =
            block.iter().zip(shape).map(|(&side, &length)| side.min(length.max(1))).collect();
        let counts: Vec<usize> =
            shape.iter().zip(&sides).map(|(length, side)| length.div_ceil(*side).max(1)).collect();
        let voxels = shape.iter().try_fold(1usize, |count, &length| count.checked_mul(length));
        if voxels.is_none_or(|count| count as u64 >> 57 != 0) {
            return Err(Error::new(
                ErrorKind::TooLarge,
                format!("an image of shape {shape:?} has too many voxels"),
            )
            .with_cure("take a part of it, or every second voxel along each axis"));
        }
        let window = sides.iter().try_fold(1usize, |count, &side| count.checked_mul(side.checked_add(2)?));
        if window.is_none_or(|count| count >= u32::MAX as usize) {
            return Err(Error::new(ErrorKind::TooLarge, format!("a block of {sides:?} voxels is too large"))
                .with_cure("give fewer voxels along each axis"));
        }
        let count = counts.iter().try_fold(1usize, |total, &count| total.checked_mul(count));
        let Some(count) = count.filter(|&count| count <= MOST_BLOCKS) else {
            return Err(Error::new(
                ErrorKind::TooLarge,
                format!("an image of shape {shape:?} has more than {MOST_BLOCKS} blocks of {sides:?} voxels"),
            )
            .with_cure("give more voxels along each axis"));
        };
        let mut places: Vec<u32> = (0..count as u32).collect();
        places.sort_by_cached_key(|&place| along_curve(&counts, place as usize));
        let mut numbers = vec![0; count];
        for (number, &place) in places.iter().enumerate() {
            numbers[place as usize] = number as u32;
        }
        Ok(Self {
            shape: shape.to_vec(),
            sides,
            construction: ImageConstruction::default(),
            is_superlevel: false,
            is_periodic: vec![false; shape.len()],
            prime: 2,
            counts,
            numbers,
            places,
        })
    }

    /// An image of this shape cut into so many blocks or a few more, as far as there are voxels: the longest blocks are cut again, until there are enough.
    ///
    /// # Errors
    /// Those of [`Self::new`].
    ///
    /// # Examples
    /// ```
    /// use coface_topology::ImageBlocks;
    /// let blocks = ImageBlocks::at_least(&[40, 20], 3)?;
    /// assert_eq!(blocks, ImageBlocks::new(&[40, 20], &[10, 20])?);
    /// assert_eq!(ImageBlocks::at_least(&[2, 2], 9)?.count(), 4);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn at_least(shape: &[usize], count: u32) -> Result<Self, Error> {
        let mut sides: Vec<usize> = shape.iter().map(|&length| length.max(1)).collect();
        let blocks = |sides: &[usize]| {
            let along = shape.iter().zip(sides).map(|(length, &side)| length.div_ceil(side).max(1));
            along.fold(1usize, usize::saturating_mul)
        };
        while blocks(&sides) < count as usize {
            // Of equal sides that of the slowest axis is cut, so that rows stay long.
            match (0..sides.len()).rev().max_by_key(|&axis| sides[axis]) {
                Some(axis) if sides[axis] > 1 => sides[axis] = sides[axis].div_ceil(2),
                _ => break,
            }
        }
        Self::new(shape, &sides)
    }

    /// What voxels are.
    ///
    /// # Examples
    /// Two dark pixels that share a corner are connected where pixels are top cells.
    /// ```
    /// use coface_topology::{ImageBlocks, ImageConstruction};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let blocks = ImageBlocks::new(&[2, 2], &[2, 2])?;
    /// let pairs = |blocks: ImageBlocks| Ok::<_, coface_algebra::Error>(blocks.part(0, [0.0, 9.0, 9.0, 0.0])?.diagram()?.pairs().len());
    /// assert_eq!(pairs(blocks.clone())?, 1);
    /// assert_eq!(pairs(blocks.construction(ImageConstruction::Vertices))?, 2);
    /// # Ok(()) }
    /// ```
    #[must_use]
    pub fn construction(mut self, construction: ImageConstruction) -> Self {
        self.construction = construction;
        self
    }

    /// Whether it grows by superlevel sets, from high numbers to low ones, instead of sublevel sets.
    ///
    /// # Examples
    /// ```
    /// use coface_topology::ImageBlocks;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let blocks = ImageBlocks::new(&[4], &[4])?.superlevel(true);
    /// let diagram = blocks.part(0, [0.0, 5.0, 1.0, 2.0])?.diagram()?;
    /// assert_eq!((diagram.pairs()[1].birth(), diagram.pairs()[1].death()), (2.0, Some(1.0)));
    /// # Ok(()) }
    /// ```
    #[must_use]
    pub fn superlevel(mut self, is_superlevel: bool) -> Self {
        self.is_superlevel = is_superlevel;
        self
    }

    /// Which axes are periodic, so that their last voxels meet their first.
    ///
    /// # Errors
    /// [`ErrorKind::Shape`] unless there is one truth value for each axis.
    ///
    /// # Examples
    /// The window of a block goes around.
    /// ```
    /// use coface_topology::ImageBlocks;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let ring = ImageBlocks::new(&[6], &[2])?.periodic(&[true])?;
    /// assert_eq!(ring.window(0), [[5, 0, 1, 2]]);
    /// # Ok(()) }
    /// ```
    pub fn periodic(mut self, is_periodic: &[bool]) -> Result<Self, Error> {
        if is_periodic.len() != self.shape.len() {
            return Err(Error::new(
                ErrorKind::Shape,
                format!("{} truth values for {} axes", is_periodic.len(), self.shape.len()),
            )
            .with_cure("say of each axis whether it is periodic"));
        }
        self.is_periodic = is_periodic.to_vec();
        Ok(self)
    }

    /// The field of coefficients.
    ///
    /// # Errors
    /// [`ErrorKind::Coefficient`] unless they are modulo a prime below 2^31.
    ///
    /// # Examples
    /// ```
    /// use coface_topology::{Coefficients, ImageBlocks};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let blocks = ImageBlocks::new(&[2], &[2])?.coefficients(Coefficients::Modulo(3))?;
    /// assert_eq!(blocks.part(0, [0.0, 1.0])?.diagram()?.prime(), 3);
    /// # Ok(()) }
    /// ```
    pub fn coefficients(mut self, coefficients: Coefficients) -> Result<Self, Error> {
        self.prime = prime(coefficients)?;
        Ok(self)
    }

    /// The numbers of voxels along the axes of the image.
    ///
    /// # Examples
    /// ```
    /// use coface_topology::ImageBlocks;
    /// assert_eq!(ImageBlocks::new(&[4, 7], &[2, 5])?.shape(), [4, 7]);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn shape(&self) -> &[usize] {
        &self.shape
    }

    /// The number of blocks.
    ///
    /// # Examples
    /// ```
    /// use coface_topology::ImageBlocks;
    /// assert_eq!(ImageBlocks::new(&[4, 7], &[2, 5])?.count(), 4);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn count(&self) -> u32 {
        self.places.len() as u32
    }

    /// The voxels that a block is read with: for each axis where they are along it. The window has the product of these, in their order, the last
    /// axis fastest.
    ///
    /// Along a periodic axis the window goes around, and may have a voxel twice; a block that is as long as the axis has no layer along it.
    ///
    /// # Panics
    /// If there is no such block.
    ///
    /// # Examples
    /// ```
    /// use coface_topology::ImageBlocks;
    /// let blocks = ImageBlocks::new(&[4, 7], &[2, 5])?;
    /// assert_eq!(blocks.window(0), [vec![0, 1, 2], vec![0, 1, 2, 3, 4, 5]]);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn window(&self, number: u32) -> Vec<Vec<usize>> {
        (0..self.shape.len()).map(|axis| self.along(number, axis).into_iter().flatten().collect()).collect()
    }

    /// About how many bytes [`ImageBlocks::part`] takes beside the numbers of the window and the part.
    ///
    /// # Examples
    /// ```
    /// use coface_topology::ImageBlocks;
    /// // 102^3 vertices: 8 cells each, a rank, two forests, and the order of voxels twice.
    /// assert_eq!(ImageBlocks::new(&[1000; 3], &[100; 3])?.bytes(), 102 * 102 * 102 * (8 + 12 + 48));
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn bytes(&self) -> u64 {
        let vertices: u64 = (0..self.shape.len())
            .map(|axis| match self.shape[axis] {
                1 => 1,
                _ if self.closes(axis) => self.sides[axis] as u64,
                _ => self.sides[axis] as u64 + 2,
            })
            .product();
        vertices.saturating_mul((1 << self.long_axes().len()) + 12 + 48)
    }

    /// Whether blocks are as long as an axis that is periodic, and no circle.
    pub(super) fn closes(&self, axis: usize) -> bool {
        self.is_periodic[axis] && self.sides[axis] == self.shape[axis] && self.shape[axis] != 1
    }

    /// The axes that are periodic and have a single voxel.
    pub(super) fn circles(&self) -> Circles {
        Circles::new(&self.shape, &self.is_periodic)
    }

    /// The voxels of a block along an axis with those of the layer around it, of which those beyond an end of the axis are none.
    pub(super) fn along(&self, number: u32, axis: usize) -> Vec<Option<usize>> {
        let (length, side) = (self.shape[axis], self.sides[axis]);
        let at = self.place_along(self.places[number as usize] as usize, axis);
        let (start, end) = (at * side, length.min((at + 1) * side));
        let own = (start..end).map(Some);
        if self.closes(axis) || length == 1 {
            return own.collect();
        }
        let before = match start.checked_sub(1) {
            None => self.is_periodic[axis].then(|| length - 1),
            before => before,
        };
        let behind = if end < length { Some(end) } else { self.is_periodic[axis].then_some(0) };
        [before].into_iter().chain(own).chain([behind]).collect()
    }

    fn place_along(&self, place: usize, axis: usize) -> usize {
        let below: usize = self.counts[axis + 1..].iter().product();
        place / below % self.counts[axis]
    }

    /// The block that a voxel is of.
    pub(super) fn block_of(&self, voxel: u64) -> u32 {
        let (mut rest, mut place, mut stride) = (voxel as usize, 0, 1);
        for axis in (0..self.shape.len()).rev() {
            place += rest % self.shape[axis] / self.sides[axis] * stride;
            rest /= self.shape[axis];
            stride *= self.counts[axis];
        }
        self.numbers[place]
    }

    /// The axes that are longer than 1, or the first one if none is.
    pub(super) fn long_axes(&self) -> Vec<usize> {
        let long: Vec<usize> = (0..self.shape.len()).filter(|&axis| self.shape[axis] != 1).collect();
        if long.is_empty() { vec![0] } else { long }
    }

    pub(super) fn is_dual(&self) -> bool {
        self.construction == ImageConstruction::TopCells
    }

    pub(super) fn is_falling(&self) -> bool {
        self.is_superlevel
    }

    /// The number of elements of the field.
    ///
    /// # Examples
    /// ```
    /// use coface_topology::ImageBlocks;
    /// assert_eq!(ImageBlocks::new(&[4], &[2])?.prime(), 2);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn prime(&self) -> u32 {
        self.prime
    }

    /// The key of a value.
    pub(super) fn key(&self, value: f64) -> u64 {
        // -0 and 0 are equal.
        let bits = (value + 0.0).to_bits();
        let rising = if bits >> 63 == 1 { !bits } else { bits | 1 << 63 };
        if self.is_superlevel != self.is_dual() { !rising } else { rising }
    }

    /// The value of a key.
    pub(super) fn value(&self, key: u64) -> f64 {
        let rising = if self.is_superlevel != self.is_dual() { !key } else { key };
        f64::from_bits(if rising >> 63 == 1 { rising & !(1 << 63) } else { !rising })
    }

    /// All of it as numbers.
    #[doc(hidden)]
    pub fn to_words(&self) -> Vec<u64> {
        let mut words = vec![self.shape.len() as u64];
        words.extend(self.shape.iter().map(|&length| length as u64));
        words.extend(self.sides.iter().map(|&side| side as u64));
        words.extend(self.is_periodic.iter().map(|&is_periodic| u64::from(is_periodic)));
        words.extend([u64::from(self.is_dual()), u64::from(self.is_superlevel), self.prime.into()]);
        words
    }

    /// What [`Self::to_words`] has made numbers of, from the first of these; takes them away.
    #[doc(hidden)]
    pub fn of_words(words: &mut &[u64]) -> Option<Self> {
        let (&axes, rest) = words.split_first()?;
        let axes = usize::try_from(axes).ok().filter(|&axes| axes <= rest.len() / 3)?;
        let (lists, rest) = rest.split_at_checked(3 * axes)?;
        let (&[is_dual, is_superlevel, prime], rest) = rest.split_first_chunk()?;
        *words = rest;
        let list = |number: usize| -> Option<Vec<usize>> {
            lists[number * axes..][..axes].iter().map(|&word| usize::try_from(word).ok()).collect()
        };
        let is_periodic: Vec<bool> = list(2)?.into_iter().map(|word| word == 1).collect();
        let blocks = Self::new(&list(0)?, &list(1)?).ok()?.periodic(&is_periodic).ok()?;
        let construction =
            if is_dual == 1 { ImageConstruction::TopCells } else { ImageConstruction::Vertices };
        let blocks = blocks.construction(construction).superlevel(is_superlevel == 1);
        blocks.coefficients(Coefficients::Modulo(prime)).ok()
    }
}

/// How far along the curve of Morton a block is: the bits of its places along the axes, in turns.
fn along_curve(counts: &[usize], place: usize) -> u128 {
    let mut rest = place;
    let mut along = [0usize; MOST_AXES];
    // Axes with one block have no bits; at most four have more.
    for (slot, &count) in along.iter_mut().zip(counts.iter().rev().filter(|&&count| count > 1)) {
        *slot = rest % count;
        rest /= count;
    }
    let bit = |bit: usize| (0..MOST_AXES).map(move |axis| (along[axis] >> bit & 1) << axis);
    (0..20).rev().fold(0, |curve, number| curve << MOST_AXES | bit(number).sum::<usize>() as u128)
}
