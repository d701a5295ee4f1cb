//! The voxels of a box with one layer around it.

use super::bits::Bits;
use super::boxes::{VoxelBox, window_span};
use super::voxels::{Voxels, check_shape};
use coface_algebra::{Error, ErrorKind};

/// The voxels of one box of a volume and the layer around it: all that the block of this box is made from.
///
/// Along an axis the window runs from the voxel before the box to the one after it, around the end of a periodic axis and no further than
/// the end of another; where that is the whole axis, it runs from voxel 0.
///
/// # Examples
/// ```
/// use coface_complexes::cubical::{CubicalVolume, VoxelBox, Voxels};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let volume = CubicalVolume::new(&[9], &[true], |voxel| voxel[0] % 2 == 0)?;
/// let window = volume.window(&VoxelBox { start: vec![0], end: vec![2] })?;
/// assert_eq!(window.lengths(), [4]);
/// // Voxels 8, 0, 1, 2.
/// assert_eq!(window.words(), [0b1011]);
/// # Ok(()) }
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct VoxelWindow {
    shape: Vec<u32>,
    is_periodic: Vec<bool>,
    inner: VoxelBox,
    /// The first voxel of the window along each axis, and how many it has.
    starts: Vec<u32>,
    lengths: Vec<u32>,
    /// A bit for each voxel of the window, the last axis running fastest.
    bits: Bits,
}

impl VoxelWindow {
    /// A window with no voxel set.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`] for a shape that no volume has, and a box that is empty or not in the volume; [`ErrorKind::TooLarge`]
    /// where it does not fit in memory.
    pub fn empty(shape: &[u32], is_periodic: &[bool], inner: &VoxelBox) -> Result<Self, Error> {
        let (starts, lengths, voxel_count) = extent(shape, is_periodic, inner)?;
        Ok(Self {
            shape: shape.to_vec(),
            is_periodic: is_periodic.to_vec(),
            inner: inner.clone(),
            starts,
            lengths,
            bits: Bits::zeros(voxel_count)?,
        })
    }

    /// The window whose voxels are given by [`Self::words`].
    ///
    /// # Errors
    /// Those of [`Self::empty`]; [`ErrorKind::Shape`] unless there are as many words as the voxels need;
    /// [`ErrorKind::InvalidInput`] for a bit beyond the last voxel.
    pub fn from_words(
        shape: &[u32],
        is_periodic: &[bool],
        inner: &VoxelBox,
        words: Vec<u64>,
    ) -> Result<Self, Error> {
        let (starts, lengths, len) = extent(shape, is_periodic, inner)?;
        if words.len() != len.div_ceil(64) {
            return Err(Error::new(
                ErrorKind::Shape,
                format!("a window of {len} voxels has {} words, not {}", len.div_ceil(64), words.len()),
            ));
        }
        if !len.is_multiple_of(64) && words.last().is_some_and(|last| last >> (len % 64) != 0) {
            return Err(Error::invalid(format!("a window of {len} voxels has a bit beyond the last")));
        }
        Ok(Self {
            shape: shape.to_vec(),
            is_periodic: is_periodic.to_vec(),
            inner: inner.clone(),
            starts,
            lengths,
            bits: Bits { words, len },
        })
    }

    /// The box, without the layer around it.
    pub fn inner(&self) -> &VoxelBox {
        &self.inner
    }

    /// The first voxel of the window along each axis.
    pub fn starts(&self) -> &[u32] {
        &self.starts
    }

    /// The number of voxels of the window along each axis.
    pub fn lengths(&self) -> &[u32] {
        &self.lengths
    }

    /// A bit for each voxel of the window, 64 in a word, the first one lowest, the last axis running fastest; beyond the end zeros.
    pub fn words(&self) -> &[u64] {
        &self.bits.words
    }

    /// How many words a window has, without making it: 8 bytes for 64 voxels.
    ///
    /// # Errors
    /// As [`Self::empty`].
    pub fn word_count(shape: &[u32], is_periodic: &[bool], inner: &VoxelBox) -> Result<usize, Error> {
        Ok(extent(shape, is_periodic, inner)?.2.div_ceil(64))
    }

    /// Whether a voxel of the volume is in the window.
    pub fn contains(&self, voxel: &[u32]) -> bool {
        self.place(voxel).is_some()
    }

    /// Whether a voxel of the volume is set; not if it is outside the window.
    pub fn is_set(&self, voxel: &[u32]) -> bool {
        self.place(voxel).is_some_and(|place| self.bits.contains(place))
    }

    /// Sets a voxel of the volume, if the window has it.
    pub fn insert(&mut self, voxel: &[u32]) {
        if let Some(place) = self.place(voxel) {
            self.bits.insert(place);
        }
    }

    /// Sets those voxels of a run along an axis that `is_set` says, as far as the window has them; `voxel` is the first one.
    ///
    /// # Panics
    /// If the volume has no such axis, or no such voxel.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::cubical::{VoxelBox, VoxelWindow};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let mut window = VoxelWindow::empty(&[9], &[true], &VoxelBox { start: vec![0], end: vec![2] })?;
    /// window.insert_run(&[0], 0, &[true, false, true, true, true, true, true, true, true]);
    /// // Voxels 8, 0, 1, 2.
    /// assert_eq!(window.words(), [0b1011]);
    /// # Ok(()) }
    /// ```
    pub fn insert_run(&mut self, voxel: &[u32], axis: usize, is_set: &[bool]) {
        let (mut base, mut stride) = (0, 1);
        for (other, &at) in voxel.iter().enumerate() {
            let length = self.lengths[other] as usize;
            base *= length;
            if other != axis {
                match self.place_along(other, at) {
                    Some(place) => base += place,
                    None => return,
                }
            }
            if other > axis {
                stride *= length;
            }
        }
        // The voxels of the window along the axis, before and behind the end of the axis, and where they are in the window.
        let (start, count) = (self.starts[axis] as usize, self.lengths[axis] as usize);
        let length = self.shape[axis] as usize;
        let before_end = count.min(length - start);
        let (first, end) = (voxel[axis] as usize, voxel[axis] as usize + is_set.len());
        assert!(end <= length, "a run ends where its axis ends");
        for (low, high, place) in [(start, start + before_end, 0), (0, count - before_end, before_end)] {
            for at in low.max(first)..high.min(end) {
                if is_set[at - first] {
                    self.bits.insert(base + (place + at - low) * stride);
                }
            }
        }
    }

    pub(super) fn fill(&mut self) {
        self.bits.fill();
    }

    pub(super) fn bits(&self) -> &Bits {
        &self.bits
    }

    fn place(&self, voxel: &[u32]) -> Option<usize> {
        if voxel.len() != self.shape.len() {
            return None;
        }
        let mut place = 0;
        for (axis, &voxel) in voxel.iter().enumerate() {
            place = place * self.lengths[axis] as usize + self.place_along(axis, voxel)?;
        }
        Some(place)
    }

    /// Where a voxel is along an axis of the window.
    pub(super) fn place_along(&self, axis: usize, voxel: u32) -> Option<usize> {
        let (start, length) = (self.starts[axis], self.shape[axis]);
        let place = if voxel >= start { voxel - start } else { length - start + voxel };
        (voxel < length && place < self.lengths[axis]).then_some(place as usize)
    }

    /// Sets what is set in bits of which `place` says where a voxel is; voxels that follow each other along the last axis are
    /// neighbors in them.
    pub(super) fn add(&mut self, other: &Bits, place: impl Fn(&[u32]) -> usize) {
        let bits = &mut self.bits;
        for_each_run(&self.shape, &self.starts, &self.lengths, |voxel, count, at| {
            bits.add(at, other, place(voxel), count);
        });
    }
}

/// Calls with the runs of voxels of a window that follow each other in the volume along the last axis: the first voxel, how many there are,
/// and where in the window they begin.
fn for_each_run(shape: &[u32], starts: &[u32], lengths: &[u32], mut visit: impl FnMut(&[u32], usize, usize)) {
    let last = shape.len() - 1;
    let (start, length) = (starts[last], lengths[last]);
    let before_end = length.min(shape[last] - start);
    let mut voxel = starts.to_vec();
    let mut at = vec![0; last];
    let row_count: usize = lengths[..last].iter().map(|&length| length as usize).product();
    for row in 0..row_count {
        let place = row * length as usize;
        voxel[last] = start;
        visit(&voxel, before_end as usize, place);
        if before_end < length {
            voxel[last] = 0;
            visit(&voxel, (length - before_end) as usize, place + before_end as usize);
        }
        for axis in (0..last).rev() {
            at[axis] += 1;
            if at[axis] == lengths[axis] {
                at[axis] = 0;
            }
            voxel[axis] = ((u64::from(starts[axis]) + u64::from(at[axis])) % u64::from(shape[axis])) as u32;
            if at[axis] > 0 {
                break;
            }
        }
    }
}

impl Voxels for VoxelWindow {
    fn shape(&self) -> &[u32] {
        &self.shape
    }

    fn is_periodic(&self) -> &[bool] {
        &self.is_periodic
    }

    /// # Errors
    /// Those of [`VoxelWindow::empty`]; [`ErrorKind::InvalidInput`] for a box whose layer is not in this window.
    fn window(&self, inner: &VoxelBox) -> Result<VoxelWindow, Error> {
        if *inner == self.inner {
            return Ok(self.clone());
        }
        let mut window = Self::empty(&self.shape, &self.is_periodic, inner)?;
        let mut is_known = true;
        for_each_run(&self.shape, &window.starts, &window.lengths, |voxel, count, _| {
            let last = voxel.len() - 1;
            let mut end = voxel.to_vec();
            end[last] += count as u32 - 1;
            is_known &= matches!((self.place(voxel), self.place(&end)), (Some(a), Some(b)) if a <= b && b - a < count);
        });
        if !is_known {
            return Err(Error::invalid(format!(
                "the voxels from {:?} to {:?} are not known with their neighbors, only those from {:?} to {:?}",
                inner.start, inner.end, self.inner.start, self.inner.end
            ))
            .with_cure("ask for the block of the window, cut as the volume was"));
        }
        window.add(&self.bits, |voxel| self.place(voxel).expect("the voxel was found in the window"));
        Ok(window)
    }
}

/// Where the window of a box begins along each axis, how many voxels it has, and how many in all.
fn extent(
    shape: &[u32],
    is_periodic: &[bool],
    inner: &VoxelBox,
) -> Result<(Vec<u32>, Vec<u32>, usize), Error> {
    check_shape(shape, is_periodic)?;
    let fits = inner.start.len() == shape.len()
        && inner.end.len() == shape.len()
        && inner
            .start
            .iter()
            .zip(&inner.end)
            .zip(shape)
            .all(|((start, end), length)| start < end && end <= length);
    if !fits {
        return Err(Error::invalid(format!(
            "there is no box of voxels from {:?} to {:?} in a volume of shape {shape:?}",
            inner.start, inner.end
        ))
        .with_cure("give a first voxel along each axis and the one after the last"));
    }
    let (mut starts, mut lengths) = (Vec::new(), Vec::new());
    let mut voxel_count = Some(1usize);
    for (axis, &length) in shape.iter().enumerate() {
        let (first, count) = window_span(length, is_periodic[axis], inner.start[axis], inner.end[axis]);
        starts.push(first);
        lengths.push(count);
        voxel_count = voxel_count.and_then(|total| total.checked_mul(count as usize));
    }
    let too_large = || {
        Error::new(ErrorKind::TooLarge, format!("a volume of shape {lengths:?} does not fit in memory"))
            .with_cure("take the volume in smaller blocks")
    };
    let voxel_count = voxel_count.ok_or_else(too_large)?;
    Ok((starts, lengths, voxel_count))
}
