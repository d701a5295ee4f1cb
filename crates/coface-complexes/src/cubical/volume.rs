//! Arrays of voxels.

use super::bits::Bits;
use super::blocks::CubicalBlocks;
use super::boxes::VoxelBox;
use super::simplices::SimplicialBlocks;
use super::voxels::{Voxels, check_shape};
use super::window::VoxelWindow;
use coface_algebra::chains::ChainComplex;
use coface_algebra::{Error, ErrorKind, RaggedArray};

/// Voxels that are set or not, all in memory: a bit each.
///
/// # Examples
/// Three by three voxels without the one in the middle make an annulus:
/// ```
/// use coface_complexes::cubical::CubicalVolume;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let ring = CubicalVolume::new(&[3, 3], &[false, false], |voxel| voxel != [1, 1])?;
/// let complex = ring.chain_complex()?;
/// assert_eq!(complex.f_vector(), [16, 24, 8]);
/// assert_eq!(complex.euler_characteristic(), 0);
/// # Ok(()) }
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct CubicalVolume {
    shape: Vec<u32>,
    is_periodic: Vec<bool>,
    /// A bit for each voxel, the last axis running fastest.
    bits: Bits,
}

impl CubicalVolume {
    /// The most axes that a volume has: a cell has up to 2 to the power of them voxels around it.
    pub const MOST_AXES: usize = 8;

    /// The volume of this shape whose voxels are set where `is_set` says so; it is asked in order, the last axis running fastest.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`] for no axis, more than [`Self::MOST_AXES`], an axis without voxels, or lists of different lengths;
    /// [`ErrorKind::TooLarge`] where places of cells do not fit in 63 bits, or voxels in memory.
    pub fn new(
        shape: &[u32],
        is_periodic: &[bool],
        mut is_set: impl FnMut(&[u32]) -> bool,
    ) -> Result<Self, Error> {
        let mut volume = Self::empty(shape, is_periodic)?;
        let mut voxel = vec![0; shape.len()];
        for at in 0..volume.voxel_count() {
            if is_set(&voxel) {
                volume.bits.insert(at);
            }
            for axis in (0..shape.len()).rev() {
                voxel[axis] += 1;
                if voxel[axis] < shape[axis] {
                    break;
                }
                voxel[axis] = 0;
            }
        }
        Ok(volume)
    }

    /// The volume of this shape with every voxel set.
    ///
    /// # Errors
    /// As [`Self::new`].
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::cubical::CubicalVolume;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let volume = CubicalVolume::full(&[2, 3], &[false, false])?;
    /// assert_eq!(volume.set_count(), 6);
    /// # Ok(()) }
    /// ```
    pub fn full(shape: &[u32], is_periodic: &[bool]) -> Result<Self, Error> {
        let mut volume = Self::empty(shape, is_periodic)?;
        volume.bits.fill();
        Ok(volume)
    }

    /// The volume whose voxels are given as bits, 64 in a word, the first one lowest, the last axis running fastest; bits beyond the last
    /// voxel do not matter.
    ///
    /// # Errors
    /// As [`Self::new`]; [`ErrorKind::Shape`] unless there are as many words as the voxels need.
    pub fn from_words(shape: &[u32], is_periodic: &[bool], mut words: Vec<u64>) -> Result<Self, Error> {
        let len = voxel_count(shape, is_periodic)?;
        check_words(shape, len, words.len())?;
        if !len.is_multiple_of(64)
            && let Some(last) = words.last_mut()
        {
            *last &= (1 << (len % 64)) - 1;
        }
        Ok(Self { shape: shape.to_vec(), is_periodic: is_periodic.to_vec(), bits: Bits { words, len } })
    }

    /// The same with the first axis running fastest in the words.
    ///
    /// # Errors
    /// As [`Self::from_words`].
    pub fn from_words_first_fastest(
        shape: &[u32],
        is_periodic: &[bool],
        words: &[u64],
    ) -> Result<Self, Error> {
        check_words(shape, voxel_count(shape, is_periodic)?, words.len())?;
        let mut volume = Self::empty(shape, is_periodic)?;
        let given = |at: usize| words[at / 64] & (1 << (at % 64)) != 0;
        let mut strides = vec![1usize; shape.len()];
        for axis in (1..shape.len()).rev() {
            strides[axis - 1] = strides[axis] * shape[axis] as usize;
        }
        let row = shape[0] as usize;
        let mut voxel = vec![0u32; shape.len()];
        let mut base = 0;
        for start in (0..volume.bits.len).step_by(row) {
            for along in (0..row).filter(|along| given(start + along)) {
                volume.bits.insert(base + along * strides[0]);
            }
            for axis in 1..shape.len() {
                voxel[axis] += 1;
                base += strides[axis];
                if voxel[axis] < shape[axis] {
                    break;
                }
                base -= shape[axis] as usize * strides[axis];
                voxel[axis] = 0;
            }
        }
        Ok(volume)
    }

    fn empty(shape: &[u32], is_periodic: &[bool]) -> Result<Self, Error> {
        Ok(Self {
            shape: shape.to_vec(),
            is_periodic: is_periodic.to_vec(),
            bits: Bits::zeros(voxel_count(shape, is_periodic)?)?,
        })
    }

    /// The number of voxels along each axis.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::cubical::CubicalVolume;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let volume = CubicalVolume::full(&[2, 3], &[false, false])?;
    /// assert_eq!(volume.shape(), [2, 3]);
    /// # Ok(()) }
    /// ```
    pub fn shape(&self) -> &[u32] {
        &self.shape
    }

    /// For each axis whether its last voxel meets its first.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::cubical::CubicalVolume;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let volume = CubicalVolume::full(&[2, 3], &[false, false])?;
    /// assert_eq!(volume.is_periodic(), [false, false]);
    /// # Ok(()) }
    /// ```
    pub fn is_periodic(&self) -> &[bool] {
        &self.is_periodic
    }

    /// The number of voxels, set or not.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::cubical::CubicalVolume;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let volume = CubicalVolume::full(&[2, 3], &[false, false])?;
    /// assert_eq!(volume.voxel_count(), 6);
    /// # Ok(()) }
    /// ```
    pub fn voxel_count(&self) -> usize {
        self.bits.len
    }

    /// The number of voxels that are set.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::cubical::CubicalVolume;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let volume = CubicalVolume::full(&[2, 3], &[false, false])?;
    /// assert_eq!(volume.set_count(), 6);
    /// # Ok(()) }
    /// ```
    pub fn set_count(&self) -> usize {
        self.bits.words.iter().map(|word| word.count_ones() as usize).sum()
    }

    /// Whether a voxel is set.
    ///
    /// # Panics
    /// If there is no such voxel.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::cubical::CubicalVolume;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let volume = CubicalVolume::full(&[2, 3], &[false, false])?;
    /// assert!(volume.is_set(&[1, 2]));
    /// # Ok(()) }
    /// ```
    pub fn is_set(&self, voxel: &[u32]) -> bool {
        let is_voxel = voxel.len() == self.shape.len() && voxel.iter().zip(&self.shape).all(|(x, n)| x < n);
        assert!(is_voxel, "there is no voxel {voxel:?} in a volume of shape {:?}", self.shape);
        self.bits.contains(self.place(voxel))
    }

    /// A bit for each voxel, 64 in a word, the first one lowest, the last axis running fastest; beyond the end zeros.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::cubical::CubicalVolume;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let volume = CubicalVolume::full(&[2, 3], &[false, false])?;
    /// assert_eq!(volume.words(), [0b11_1111]);
    /// # Ok(()) }
    /// ```
    pub fn words(&self) -> &[u64] {
        &self.bits.words
    }

    /// Whether the voxel at this place is set, places counted with the last axis running fastest.
    #[doc(hidden)]
    pub fn is_set_at(&self, at: usize) -> bool {
        self.bits.contains(at)
    }

    fn place(&self, voxel: &[u32]) -> usize {
        voxel.iter().zip(&self.shape).fold(0, |at, (&x, &length)| at * length as usize + x as usize)
    }

    /// The chain complex of all cells, in order of their ids.
    ///
    /// # Errors
    /// [`ErrorKind::TooLarge`] beyond 2^32 cells or entries of one dimension.
    ///
    /// # Complexity
    /// Linear in the places of cells.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::cubical::CubicalVolume;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let volume = CubicalVolume::full(&[2, 3], &[false, false])?;
    /// assert_eq!(volume.chain_complex()?.f_vector(), [12, 17, 6]);
    /// # Ok(()) }
    /// ```
    pub fn chain_complex(&self) -> Result<ChainComplex, Error> {
        Ok(CubicalBlocks::new(self, &vec![1; self.shape.len()])?.block(0)?.into_complex())
    }

    /// The cells of each dimension by their ids, which are their places, rising.
    ///
    /// # Errors
    /// [`ErrorKind::TooLarge`] beyond 2^32 places of cells.
    ///
    /// # Complexity
    /// Linear in the places of cells.
    ///
    /// # Examples
    /// One voxel: its corners are at places 0 and 2 along each axis, and its inside is at place 1.
    /// ```
    /// use coface_complexes::cubical::CubicalVolume;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let ids = CubicalVolume::full(&[1], &[false])?.cell_ids()?;
    /// assert_eq!(ids, [vec![0, 2], vec![1]]);
    /// # Ok(()) }
    /// ```
    pub fn cell_ids(&self) -> Result<Vec<Vec<u64>>, Error> {
        CubicalBlocks::new(self, &vec![1; self.shape.len()])?.cell_ids(0)
    }

    /// The corners of each cell of this degree as numbers of cells of degree 0: of an edge from its start to its end, of a
    /// square around, of other cells with the last axis fastest. A corner stands twice where a periodic axis is short.
    ///
    /// # Errors
    /// [`ErrorKind::TooLarge`] beyond 2^32 places of cells or corners.
    ///
    /// # Complexity
    /// Linear in the places of cells, and $O(c \log n)$ for c corners of cells among n vertices.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::cubical::CubicalVolume;
    /// let pixel = CubicalVolume::full(&[1, 1], &[false, false])?;
    /// assert_eq!(pixel.cell_vertices(2)?.list(0), [0, 1, 3, 2]);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn cell_vertices(&self, degree: usize) -> Result<RaggedArray, Error> {
        let ids = self.cell_ids()?;
        let (Some(cells), Some(vertices)) = (ids.get(degree), ids.first()) else {
            return Ok(RaggedArray::new());
        };
        let axes = self.shape.iter().zip(&self.is_periodic);
        let lengths: Vec<u64> =
            axes.map(|(&length, periodic)| 2 * u64::from(length) + u64::from(!periodic)).collect();
        let mut items = Vec::with_capacity(cells.len() << degree);
        let mut place = vec![0; lengths.len()];
        for &id in cells {
            let mut rest = id;
            for (place, &length) in place.iter_mut().zip(&lengths).rev() {
                *place = rest % length;
                rest /= length;
            }
            for corner in 0..1usize << degree {
                // Around a square the corners run 00, 01, 11, 10.
                let corner = if degree == 2 { corner ^ corner >> 1 } else { corner };
                let mut shift = degree;
                let at = place.iter().zip(&lengths).fold(0, |at, (&x, &length)| {
                    shift -= (x % 2) as usize;
                    let x = match (x % 2, corner >> shift & 1) {
                        (0, _) => x,
                        (_, 0) => x - 1,
                        _ => (x + 1) % length,
                    };
                    at * length + x
                });
                items.push(vertices.binary_search(&at).expect("the corners of a cell are cells") as u32);
            }
        }
        RaggedArray::uniform(1 << degree, items)
    }

    /// The chain complex of all simplices that the voxels are cut into, in order of their ids; see [`SimplicialBlocks`].
    ///
    /// # Errors
    /// [`ErrorKind::TooLarge`] beyond 2^32 simplices or entries of one dimension.
    ///
    /// # Complexity
    /// Linear in the places of cells and in the simplices.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::cubical::CubicalVolume;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let volume = CubicalVolume::full(&[2, 3], &[false, false])?;
    /// assert_eq!(volume.simplicial_chain_complex()?.euler_characteristic(), 1);
    /// # Ok(()) }
    /// ```
    pub fn simplicial_chain_complex(&self) -> Result<ChainComplex, Error> {
        Ok(SimplicialBlocks::new(self, &vec![1; self.shape.len()])?.block(0)?.into_complex())
    }
}

/// How many voxels a volume of this shape has.
fn voxel_count(shape: &[u32], is_periodic: &[bool]) -> Result<usize, Error> {
    check_shape(shape, is_periodic)?;
    let count = shape.iter().try_fold(1usize, |count, &length| count.checked_mul(length as usize));
    count.ok_or_else(|| {
        Error::new(ErrorKind::TooLarge, format!("a volume of shape {shape:?} does not fit in memory"))
    })
}

fn check_words(shape: &[u32], voxel_count: usize, word_count: usize) -> Result<(), Error> {
    if word_count == voxel_count.div_ceil(64) {
        return Ok(());
    }
    Err(Error::new(
        ErrorKind::Shape,
        format!("a volume of shape {shape:?} is not given by {word_count} words"),
    ))
}

impl Voxels for CubicalVolume {
    fn shape(&self) -> &[u32] {
        &self.shape
    }

    fn is_periodic(&self) -> &[bool] {
        &self.is_periodic
    }

    fn window(&self, inner: &VoxelBox) -> Result<VoxelWindow, Error> {
        let mut window = VoxelWindow::empty(&self.shape, &self.is_periodic, inner)?;
        window.add(&self.bits, |voxel| self.place(voxel));
        Ok(window)
    }
}
