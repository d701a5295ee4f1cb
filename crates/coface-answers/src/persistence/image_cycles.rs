//! Cycles of the classes of an image, on the cells that its voxels make.

use super::image::Axes;
use super::{FoundImage, GreyImage, ImageRequest};
use crate::Producer;
use crate::answer::{ChainTerm, PersistenceAnswer, WholeNumber};
use crate::producer::{CubeChain, picture_of_cubes};
use coface_algebra::chains::{Chain, ChainComplex};
use coface_algebra::progress::stage;
use coface_algebra::{CellId, Error, Integer};
use coface_complexes::cubical::CubicalVolume;
use coface_geometry::Positions;
use coface_io::{Model, ModelParts, Structure, VoxelFrame};
use coface_topology::{
    Coefficients, Filtration, ImageConstruction, ImageCycle, ImageCycles, ImageFiltration,
};
use std::sync::OnceLock;

/// The rank of a voxel that never enters.
const NEVER: u32 = u32::MAX;

/// The cubes that an image makes, with the voxels by which they enter: what cycles of its persistence are made of.
///
/// In the T-construction they are the cells of the volume of all voxels that enter, with the numbers of vertices that this volume has elsewhere. In the
/// V-construction voxels are the vertices: they are numbered along the last axis first, and have their positions in the middle of the voxels.
///
/// # Examples
/// A ring of eight dark pixels around a bright one: a loop from 1 to 9. It goes through a side of the dark pixel that comes last, and around this one and the
/// bright one.
/// ```
/// use coface_answers::{GreyImage, ImageRequest};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let ring = GreyImage::new(&[3, 3], [1.0, 1.0, 1.0, 1.0, 9.0, 1.0, 1.0, 1.0, 1.0])?;
/// let cells = ImageRequest::new().cells("ring", ring)?;
/// let answer = cells.found()?.answer();
/// let rim = &answer.diagram[1];
/// assert_eq!((rim.degree, rim.birth, rim.death), (1, 1.0, Some(9.0)));
/// assert_eq!(rim.death_cell.as_deref(), Some(&[1, 1][..]));
/// assert_eq!(rim.cycle.as_ref().map(Vec::len), Some(6));
/// assert_eq!(rim.bounding_chain.as_ref().map(Vec::len), Some(2));
/// # Ok(()) }
/// ```
#[derive(Debug)]
pub struct ImageCells {
    name: String,
    request: ImageRequest,
    axes: Axes,
    filtration: ImageFiltration,
    around: Around,
    corners: Corners,
    frame: Option<VoxelFrame>,
    /// Whether a mask has left voxels out.
    is_cut: bool,
    /// The cells of the volume by their places, for each degree, once they are asked for.
    ids: OnceLock<Vec<Vec<u64>>>,
    producer: OnceLock<Producer>,
    entrance: OnceLock<Entrance>,
}

/// When the cells of the volume enter.
#[derive(Debug)]
struct Entrance {
    /// For each degree the voxel by which each cell of the producer enters, `NEVER` for a cell that does not.
    entering: Vec<Vec<u32>>,
    /// For each degree the cells that enter, unless all do.
    kept: Option<Vec<Vec<CellId>>>,
    /// The rank of each voxel among those that enter, `NEVER` for the others.
    ranks: Vec<u32>,
}

/// What is there, or what is made.
fn made<T>(place: &OnceLock<T>, make: impl FnOnce() -> Result<T, Error>) -> Result<&T, Error> {
    if let Some(there) = place.get() {
        return Ok(there);
    }
    let new = make()?;
    Ok(place.get_or_init(|| new))
}

impl ImageRequest {
    /// The cubes of an image with this name, for cycles of its classes. They are made when they are asked for: the cycles need none of them.
    ///
    /// # Errors
    /// Those of [`ImageFiltration::periodic`], and for a voxel at infinity where values come from.
    ///
    /// # Complexity
    /// Linear in the voxels.
    ///
    /// # Examples
    /// See [`ImageCells`].
    pub fn cells(&self, name: &str, image: GreyImage) -> Result<ImageCells, Error> {
        let GreyImage { axes, filtration, frame, is_cut } = image;
        let (filtration, is_periodic) =
            self.filtration(&axes, filtration).map_err(|error: Error| error.in_file(name))?;
        let around = Around::new(axes.shape(), is_periodic, self.construction == ImageConstruction::Vertices);
        let corners = Corners::new(&around, &axes, &filtration);
        let (ids, producer, entrance) = (OnceLock::new(), OnceLock::new(), OnceLock::new());
        let (name, request) = (name.to_owned(), self.clone());
        Ok(ImageCells {
            name,
            request,
            axes,
            filtration,
            around,
            corners,
            frame,
            is_cut,
            ids,
            producer,
            entrance,
        })
    }
}

/// The vertices of cubes by their numbers.
#[derive(Debug)]
struct Corners {
    /// For each axis of cubes: how many places there are, and how many vertices.
    lengths: Vec<(u64, u64)>,
    /// For each axis of cubes the step between numbers of cubes in the library.
    steps: Vec<u64>,
    /// A bit for each vertex that there is, and how many there are before each word; `None` if there is one at each place.
    there: Option<(Vec<u64>, Vec<u32>)>,
}

impl Corners {
    fn new(around: &Around, axes: &Axes, filtration: &ImageFiltration) -> Self {
        let length = |&axis: &usize| {
            let length = u64::from(around.shape[axis]);
            match (around.is_periodic[axis], around.are_vertices) {
                (true, _) => (2 * length, length),
                (false, true) => ((2 * length).saturating_sub(1), length),
                (false, false) => (2 * length + 1, length + 1),
            }
        };
        let lengths: Vec<(u64, u64)> = around.axes.iter().map(length).collect();
        // Axes that cubes do not span have one place.
        let mut order: Vec<usize> = (0..lengths.len()).collect();
        if !axes.is_first_fastest {
            order.reverse();
        }
        let (mut steps, mut step) = (vec![1; lengths.len()], 1);
        for axis in order {
            steps[axis] = step;
            step *= lengths[axis].0;
        }
        let mut corners = Self { lengths, steps, there: None };
        let count = axes.voxel_count();
        if !around.are_vertices && (0..count).any(|voxel| !filtration.value(voxel).is_finite()) {
            corners.there = Some(corners.around_voxels(axes, filtration));
        }
        corners
    }

    /// The corners of the voxels that enter, of which there is one at each odd place.
    fn around_voxels(&self, axes: &Axes, filtration: &ImageFiltration) -> (Vec<u64>, Vec<u32>) {
        let total: u64 = self.lengths.iter().map(|length| length.1).product();
        let mut words = vec![0u64; (total as usize).div_ceil(64)];
        for voxel in (0..axes.voxel_count()).filter(|&voxel| filtration.value(voxel).is_finite()) {
            let place: Vec<u64> = axes.voxel(voxel).iter().map(|&x| 2 * u64::from(x) + 1).collect();
            self.of_place(&place, |corner| words[corner as usize / 64] |= 1 << (corner % 64));
        }
        let mut before = Vec::with_capacity(words.len());
        let mut count = 0;
        for word in &words {
            before.push(count);
            count += word.count_ones();
        }
        (words, before)
    }

    /// The place of a cube of the library along each axis.
    fn place(&self, cube: u64, place: &mut Vec<u64>) {
        let axes = self.steps.iter().zip(&self.lengths);
        place.clear();
        place.extend(axes.map(|(step, (length, _))| cube / step % length));
    }

    /// The corners of the cube at this place along each axis, in the order of [`Producer::cell_vertices`], by their numbers among all places of vertices.
    fn of_place(&self, place: &[u64], mut found: impl FnMut(u64)) {
        /// The corners around a square, a bit for the end behind along each of its axes.
        const AROUND: [usize; 4] = [0, 2, 3, 1];
        let degree = place.iter().filter(|&&x| x % 2 == 1).count();
        let in_order = |corner: usize| if degree == 2 { AROUND[corner] } else { corner };
        for corner in (0..1usize << degree).map(in_order) {
            let mut shift = degree;
            found(place.iter().zip(&self.lengths).fold(0, |at, (&x, &(places, count))| {
                shift -= (x % 2) as usize;
                let x = match (x % 2, corner >> shift & 1) {
                    (0, _) => x,
                    (_, 0) => x - 1,
                    _ => (x + 1) % places,
                };
                at * count + x / 2
            }));
        }
    }

    /// The number of a vertex.
    fn number(&self, corner: u64) -> u64 {
        let Some((words, before)) = &self.there else { return corner };
        let at = corner as usize / 64;
        let below = words[at] & ((1 << (corner % 64)) - 1);
        u64::from(before[at] + below.count_ones())
    }
}

/// The voxels that a cell has to do with: those that it is a face of, or those that are its corners.
#[derive(Debug)]
struct Around {
    shape: Vec<u32>,
    is_periodic: Vec<bool>,
    are_vertices: bool,
    /// The axes along which cells extend: of corners those with more than one voxel and periodic ones, or a single one.
    axes: Vec<usize>,
}

impl Around {
    fn new(shape: &[usize], is_periodic: Vec<bool>, are_vertices: bool) -> Self {
        let is_long = |&axis: &usize| !are_vertices || shape[axis] != 1 || is_periodic[axis];
        let mut axes: Vec<usize> = (0..shape.len()).filter(is_long).collect();
        if axes.is_empty() {
            axes.push(0);
        }
        let shape = shape.iter().map(|&length| length as u32).collect();
        Self { shape, is_periodic, are_vertices, axes }
    }

    /// The volume that has the cells: of the voxels that enter, or of all cubes between voxels.
    fn volume(&self, enters: impl FnMut(&[u32]) -> bool) -> Result<CubicalVolume, Error> {
        if !self.are_vertices {
            return CubicalVolume::new(&self.shape, &self.is_periodic, enters);
        }
        let is_periodic: Vec<bool> = self.axes.iter().map(|&axis| self.is_periodic[axis]).collect();
        let lengths = self.axes.iter().map(|&axis| self.shape[axis]).zip(&is_periodic);
        let cubes: Vec<u32> = lengths
            .map(|(length, &periodic)| if periodic { length } else { length.saturating_sub(1).max(1) })
            .collect();
        CubicalVolume::full(&cubes, &is_periodic)
    }

    /// The volume with the positions of its vertices: of voxels, if they are the vertices, their centers.
    fn placed(&self, volume: CubicalVolume, frame: Option<VoxelFrame>) -> Result<Producer, Error> {
        let structure = Some(Structure::Volume(volume));
        if !self.are_vertices {
            return Producer::of(ModelParts { structure, frame, ..ModelParts::default() }.into_model());
        }
        let mut producer = Producer::of(ModelParts { structure, ..ModelParts::default() }.into_model())?;
        let dimension = self.shape.len();
        if producer.positions.dimension() > 0 && dimension <= 3 {
            let mut centers = Vec::with_capacity(producer.positions.len() * dimension);
            for corner in producer.positions.as_flat().chunks_exact(self.axes.len()) {
                let first = centers.len();
                centers.resize(first + dimension, 0.5);
                self.axes.iter().zip(corner).for_each(|(axis, x)| centers[first + axis] += x);
            }
            let centers = Positions::from_flat(dimension, centers)?;
            producer.positions = match frame {
                Some(frame) => frame.place(&centers)?,
                None => centers,
            };
        }
        Ok(producer)
    }

    /// The places of these voxels along an axis, of a cell at this place in doubled coordinates; `None` for what is outside.
    fn along(&self, axis: usize, place: u64) -> [Option<u32>; 2] {
        let length = u64::from(self.shape[axis]);
        let (half, is_odd) = (place / 2, place % 2 == 1);
        let at = |voxel: u64| match self.is_periodic[axis] {
            true => Some((voxel % length) as u32),
            false => (voxel < length).then_some(voxel as u32),
        };
        match (self.are_vertices, is_odd) {
            (false, true) | (true, false) => [at(half); 2],
            (true, true) => [at(half), at(half + 1)],
            (false, false) if half > 0 => [at(half - 1), at(half)],
            (false, false) => [self.is_periodic[axis].then(|| (length - 1) as u32), at(half)],
        }
    }
}

/// For each degree the voxel by which each cell enters: the first one around it, or the last one of its corners.
fn entering(
    volume: &CubicalVolume,
    degrees: &[Vec<u64>],
    axes: &Axes,
    ranks: &[u32],
    around: &Around,
) -> Vec<Vec<u32>> {
    let along = volume.shape().iter().zip(volume.is_periodic());
    let lengths: Vec<u64> =
        along.map(|(&length, periodic)| 2 * u64::from(length) + u64::from(!periodic)).collect();
    let axis_count = lengths.len();
    let mut near = vec![[None; 2]; axis_count];
    let mut voxel = vec![0; around.shape.len()];
    let mut of_cell = |mut id: u64| {
        for axis in (0..axis_count).rev() {
            near[axis] = around.along(around.axes[axis], id % lengths[axis]);
            id /= lengths[axis];
        }
        // The rank and the number of the voxel.
        let mut found: Option<(u32, usize)> = None;
        for choice in 0..1_usize << axis_count {
            let mut is_inside = true;
            for axis in 0..axis_count {
                match near[axis][choice >> axis & 1] {
                    Some(place) => voxel[around.axes[axis]] = place,
                    None => is_inside = false,
                }
            }
            let number = if is_inside { axes.number(&voxel) } else { usize::MAX };
            let rank = if is_inside { ranks[number] } else { NEVER };
            // A voxel that never enters has the highest rank: a corner of it never does either.
            let is_better = found.is_none_or(|(best, _)| match around.are_vertices {
                true => rank > best,
                false => rank < best,
            });
            if is_better {
                found = Some((rank, number));
            }
        }
        found.filter(|&(rank, _)| rank != NEVER).map_or(NEVER, |(_, number)| number as u32)
    };
    degrees.iter().map(|ids| ids.iter().map(|&id| of_cell(id)).collect()).collect()
}

impl ImageCells {
    /// Finds the diagram with its cycles.
    ///
    /// # Errors
    /// Those of [`ImageFiltration::persistent_cycles`].
    ///
    /// # Complexity
    /// That of [`ImageFiltration::persistent_cycles`]: no cubes are made but those of cycles.
    ///
    /// # Examples
    /// See [`ImageCells`].
    pub fn found(&self) -> Result<FoundImageCycles<'_>, Error> {
        let least = self.request.min_persistence;
        let found = self
            .filtration
            .persistent_cycles(self.request.coefficients, least)
            .map_err(|error: Error| error.in_file(&self.name))?;
        let image = FoundImage {
            name: self.name.clone(),
            construction: self.request.construction,
            axes: self.axes.clone(),
            diagram: found.diagram().longer_than(least),
            is_cut: self.is_cut,
            is_periodic: self.around.is_periodic.contains(&true),
            min_persistence: least.max(0.0),
        };
        Ok(FoundImageCycles { cells: self, image, found })
    }

    /// The volume that has the cells.
    fn volume(&self) -> Result<CubicalVolume, Error> {
        self.around.volume(|voxel| self.filtration.value(self.axes.number(voxel)).is_finite())
    }

    fn ids(&self) -> Result<&Vec<Vec<u64>>, Error> {
        made(&self.ids, || self.volume()?.cell_ids())
    }

    fn entrance(&self) -> Result<&Entrance, Error> {
        made(&self.entrance, || {
            let _steps = stage("making cubes", 0);
            let mut ranks = vec![NEVER; self.axes.voxel_count()];
            (0..).zip(self.filtration.entrance()).for_each(|(rank, voxel)| ranks[voxel as usize] = rank);
            let entering = entering(&self.volume()?, self.ids()?, &self.axes, &ranks, &self.around);
            let is_whole = entering.iter().flatten().all(|&voxel| voxel != NEVER);
            let kept = (!is_whole).then(|| {
                let enter = |voxels: &Vec<u32>| {
                    let cells = voxels.iter().enumerate().filter(|&(_, &voxel)| voxel != NEVER);
                    cells.map(|(cell, _)| CellId::new(cell)).collect()
                };
                entering.iter().map(enter).collect()
            });
            Ok(Entrance { entering, kept, ranks })
        })
    }

    /// The cells that enter, by degree, unless all cells of the volume do.
    fn kept(&self) -> Result<Option<&Vec<Vec<CellId>>>, Error> {
        let is_whole = !self.around.are_vertices
            || (0..self.axes.voxel_count()).all(|voxel| self.filtration.value(voxel).is_finite());
        if is_whole && self.around.shape.iter().any(|&length| length > 1) {
            return Ok(None);
        }
        Ok(self.entrance()?.kept.as_ref())
    }

    /// The number of cells of a degree that enter.
    ///
    /// # Errors
    /// [`ErrorKind::TooLarge`](coface_algebra::ErrorKind::TooLarge) if there are too many cubes for one complex.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::{GreyImage, ImageRequest};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let row = GreyImage::new(&[3], [0.0, f64::NAN, 1.0])?;
    /// assert_eq!(ImageRequest::new().cells("row", row)?.cell_count(0)?, 4);
    /// # Ok(()) }
    /// ```
    pub fn cell_count(&self, degree: usize) -> Result<usize, Error> {
        Ok(match self.kept()? {
            Some(kept) => kept.get(degree).map_or(0, Vec::len),
            None => self.ids()?.get(degree).map_or(0, Vec::len),
        })
    }

    /// A sum of cubes of a cycle of this degree as a chain of the [complex](Self::complex), of the same degree or the next one.
    ///
    /// # Errors
    /// [`ErrorKind::TooLarge`](coface_algebra::ErrorKind::TooLarge) if there are too many cubes for one complex.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::{GreyImage, ImageRequest};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let cells = ImageRequest::new().cells("row", GreyImage::new(&[3], [0.0, 5.0, 1.0])?)?;
    /// let found = cells.found()?;
    /// let filling = cells.chain(0, 1, found.cycles()[1].bounding_chain().expect("it dies"))?;
    /// let (complex, _) = cells.complex()?;
    /// assert_eq!(complex.boundary(&filling)?.terms().len(), 2);
    /// # Ok(()) }
    /// ```
    pub fn chain(
        &self,
        of_cycle: usize,
        degree: usize,
        terms: &[(u64, i64)],
    ) -> Result<Chain<Integer>, Error> {
        let named = self.named_chain(of_cycle, degree, terms)?;
        Chain::of_cells(degree, named.into_iter().map(|(cell, x, _)| (cell, x)))
    }

    /// The cells of a sum of cubes by their numbers in the volume.
    fn cells_of(
        &self,
        of_cycle: usize,
        degree: usize,
        terms: &[(u64, i64)],
    ) -> Result<Vec<(CellId, Integer)>, Error> {
        let ids = self.ids()?.get(degree).map_or(&[][..], Vec::as_slice);
        let lengths = self.volume_lengths();
        let mut place = Vec::new();
        let number = |&(cube, x): &(u64, i64)| {
            self.corners.place(cube, &mut place);
            let id = place.iter().zip(&lengths).fold(0, |id, (x, length)| id * length + x);
            let cell = ids.binary_search(&id).expect("the cubes of chains are cells");
            (CellId::new(cell), Integer::from(self.turned(of_cycle, degree, x)))
        };
        Ok(terms.iter().map(number).collect())
    }

    /// A sum of cubes with the places of their corners, in the order of the cells of the volume.
    fn cubes(&self, of_cycle: usize, degree: usize, terms: &[(u64, i64)]) -> Vec<(Integer, Vec<u64>)> {
        let mut placed: Vec<(Vec<u64>, i64)> = Vec::with_capacity(terms.len());
        for &(cube, x) in terms {
            let mut place = Vec::new();
            self.corners.place(cube, &mut place);
            placed.push((place, x));
        }
        placed.sort_unstable();
        let cube = |(place, x): (Vec<u64>, i64)| {
            let mut corners = Vec::with_capacity(1 << degree);
            self.corners.of_place(&place, |corner| corners.push(corner));
            (Integer::from(self.turned(of_cycle, degree, x)), corners)
        };
        placed.into_iter().map(cube).collect()
    }

    /// The positions of corners by their places; none for more than three axes and for periodic ones.
    fn positions(&self, corners: &[u64]) -> Result<Positions, Error> {
        let axes = &self.around.axes;
        if axes.len() > 3 || axes.iter().any(|&axis| self.around.is_periodic[axis]) {
            return Ok(Positions::default());
        }
        // Where voxels are the vertices, they have their centers, and axes that cubes do not span too.
        let are_centers = self.around.are_vertices && self.around.shape.len() <= 3;
        let dimension = if are_centers { self.around.shape.len() } else { axes.len() };
        let mut flat = Vec::with_capacity(corners.len() * dimension);
        for &corner in corners {
            let first = flat.len();
            flat.resize(first + dimension, if are_centers { 0.5 } else { 0.0 });
            let mut rest = corner;
            for (rank, (&axis, &(_, count))) in axes.iter().zip(&self.corners.lengths).enumerate().rev() {
                flat[first + if are_centers { axis } else { rank }] += (rest % count) as f64;
                rest /= count;
            }
        }
        let positions = Positions::from_flat(dimension, flat)?;
        match self.frame.filter(|_| !corners.is_empty() && dimension == 3) {
            Some(frame) => frame.place(&positions),
            None => Ok(positions),
        }
    }

    /// How many places the cells of the volume have along its axes.
    fn volume_lengths(&self) -> Vec<u64> {
        let long = |(_, &(length, _)): (&usize, &(u64, u64))| {
            // A single voxel, which is a vertex, has an edge behind it.
            if length == 1 { 3 } else { length }
        };
        self.around.axes.iter().zip(&self.corners.lengths).map(long).collect()
    }

    /// A coefficient where cubes are oriented by the axes of the file: the axes of the library run backwards in some, which turns cells of some degrees. Those of cycles
    /// stay, so that the chains that they bound are turned instead.
    fn turned(&self, of_cycle: usize, degree: usize, x: i64) -> i64 {
        let is_turned = self.axes.is_first_fastest && degree != of_cycle && of_cycle % 2 == 1;
        let is_odd = !matches!(self.request.coefficients, Coefficients::Modulo(2));
        if is_turned && is_odd { -x } else { x }
    }

    /// The terms of [`Self::chain`] with the vertices of each cell.
    ///
    /// # Errors
    /// As of [`Self::chain`].
    ///
    /// # Examples
    /// ```
    /// use coface_answers::{GreyImage, ImageRequest};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let cells = ImageRequest::new().cells("row", GreyImage::new(&[3], [0.0, 5.0, 1.0])?)?;
    /// // The pixel in the middle, which has place 3 in doubled places.
    /// let named = cells.named_chain(0, 1, &[(3, 1)])?;
    /// assert_eq!((named[0].0.index(), &named[0].2[..]), (1, &[1, 2][..]));
    /// # Ok(()) }
    /// ```
    pub fn named_chain(
        &self,
        of_cycle: usize,
        degree: usize,
        terms: &[(u64, i64)],
    ) -> Result<Vec<(CellId, Integer, Vec<u32>)>, Error> {
        let kept = self.kept()?;
        let own = |cell: CellId| match kept {
            Some(kept) => CellId::new(kept[degree].binary_search(&cell).expect("cells of a chain enter")),
            None => cell,
        };
        let cells = self.cells_of(of_cycle, degree, terms)?.into_iter();
        let vertices = self.terms(of_cycle, degree, terms).into_iter();
        let named = cells.zip(vertices).map(|((cell, x), (_, vertices))| {
            (own(cell), x, vertices.into_iter().map(|vertex| vertex as u32).collect())
        });
        let mut named: Vec<(CellId, Integer, Vec<u32>)> = named.collect();
        named.sort_unstable_by_key(|term| term.0);
        Ok(named)
    }

    /// The terms of a sum of cubes with the vertices of each.
    fn terms(&self, of_cycle: usize, degree: usize, terms: &[(u64, i64)]) -> Vec<ChainTerm> {
        let mut place = Vec::new();
        let term = |&(cube, x): &(u64, i64)| {
            let mut vertices = Vec::with_capacity(1 << degree);
            self.corners.place(cube, &mut place);
            self.corners.of_place(&place, |corner| vertices.push(self.corners.number(corner)));
            (WholeNumber::Number(self.turned(of_cycle, degree, x)), vertices)
        };
        terms.iter().map(term).collect()
    }

    /// The cubes that enter as a chain complex, and when they enter. Classes are born and die by the same voxels as those of [`ImageRequest::found`].
    ///
    /// # Errors
    /// Those of [`Producer::chain_complex`].
    ///
    /// # Complexity
    /// Linear in the cubes, $2^n$ for each voxel of n axes, which are all stored.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::{GreyImage, ImageRequest};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let row = GreyImage::new(&[3], [0.0, f64::NAN, 1.0])?;
    /// let (complex, filtration) = ImageRequest::new().cells("row", row)?.complex()?;
    /// assert_eq!((complex.f_vector(), filtration.values(1)), (&[4, 2][..], &[0.0, 1.0][..]));
    /// # Ok(()) }
    /// ```
    pub fn complex(&self) -> Result<(ChainComplex, Filtration), Error> {
        let complex = self.producer()?.chain_complex()?;
        let complex = match &self.entrance()?.kept {
            Some(kept) => complex.subcomplex(kept)?,
            None => complex,
        };
        let filtration = self.filtration_of(&complex)?;
        Ok((complex, filtration))
    }

    /// The vertices of a cell of the [complex](Self::complex), and the place of the voxel by which it enters among those that enter.
    ///
    /// # Errors
    /// [`ErrorKind::TooLarge`](coface_algebra::ErrorKind::TooLarge) if there are too many cubes for one complex.
    ///
    /// # Panics
    /// If there is no such cell.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::CellId;
    /// use coface_answers::{GreyImage, ImageRequest};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let row = GreyImage::new(&[2], [7.0, 1.0])?;
    /// assert_eq!(ImageRequest::new().cells("row", row)?.cell(1, CellId::new(0))?, (vec![0, 1], 1));
    /// # Ok(()) }
    /// ```
    pub fn cell(&self, degree: usize, cell: CellId) -> Result<(Vec<u32>, u32), Error> {
        let Entrance { entering, kept, ranks } = self.entrance()?;
        let cell = kept.as_ref().map_or(cell, |kept| kept[degree][cell.index()]);
        let voxel = entering[degree][cell.index()];
        Ok((self.producer()?.cell_vertices(degree, cell), ranks[voxel as usize]))
    }

    /// The cells that enter, by their voxels, and of one voxel by their numbers.
    fn filtration_of(&self, complex: &ChainComplex) -> Result<Filtration, Error> {
        let Entrance { entering, ranks, .. } = self.entrance()?;
        let degrees = entering.iter().take(complex.degree_count());
        let voxels: Vec<Vec<u32>> =
            degrees.map(|voxels| voxels.iter().copied().filter(|&voxel| voxel != NEVER).collect()).collect();
        let value = |&voxel: &u32| self.filtration.value(voxel as usize);
        let values = voxels.iter().map(|voxels| voxels.iter().map(value).collect()).collect();
        let sorted = |voxels: &Vec<u32>| {
            let mut order: Vec<u32> = (0..voxels.len() as u32).collect();
            order.sort_by_key(|&cell| ranks[voxels[cell as usize] as usize]);
            order
        };
        let order = voxels.iter().map(sorted).collect();
        match self.request.is_superlevel {
            true => Filtration::falling_in_order(complex, values, order),
            false => Filtration::in_order(complex, values, order),
        }
    }

    /// The vertices of the cubes, their cells and their positions.
    ///
    /// # Errors
    /// [`ErrorKind::TooLarge`](coface_algebra::ErrorKind::TooLarge) if there are too many cubes for one complex.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::{GreyImage, ImageRequest};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let row = GreyImage::new(&[3], [0.0, 5.0, 1.0])?;
    /// assert_eq!(ImageRequest::new().cells("row", row)?.producer()?.chain_complex()?.f_vector(), [4, 3]);
    /// # Ok(()) }
    /// ```
    pub fn producer(&self) -> Result<&Producer, Error> {
        made(&self.producer, || self.around.placed(self.volume()?, self.frame))
    }
}

/// A persistence diagram of an image with the cycles of its classes.
#[derive(Clone, Debug)]
pub struct FoundImageCycles<'a> {
    cells: &'a ImageCells,
    image: FoundImage,
    found: ImageCycles,
}

impl FoundImageCycles<'_> {
    /// The diagram alone.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::{GreyImage, ImageRequest};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let cells = ImageRequest::new().cells("row", GreyImage::new(&[3], [0.0, 5.0, 1.0])?)?;
    /// assert_eq!(cells.found()?.image().diagram().pairs().len(), 2);
    /// # Ok(()) }
    /// ```
    pub fn image(&self) -> &FoundImage {
        &self.image
    }

    /// The cycles of the classes, in the order of the diagram. Cubes have numbers in doubled places of the [`ImageFiltration`]: [`ImageCells::chain`] gives them those of a complex.
    ///
    /// # Examples
    /// See [`ImageCells::chain`].
    pub fn cycles(&self) -> &[ImageCycle] {
        self.found.classes()
    }

    /// The primes over whose fields the diagram is another one than over the rational numbers.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::{GreyImage, ImageRequest};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let cells = ImageRequest::new().cells("row", GreyImage::new(&[3], [0.0, 5.0, 1.0])?)?;
    /// assert!(cells.found()?.torsion_primes().is_empty());
    /// # Ok(()) }
    /// ```
    pub fn torsion_primes(&self) -> &[u32] {
        self.found.torsion_primes()
    }

    /// The cycles and bounding chains as a model on the vertices that they have, in the order of those of [`ImageCells::producer`], a group for each: `H1_0_from_1_to_5` with the place of the class in its degree, its birth and
    /// its death, and `filling_H1_0` for the chain that it bounds. With four axes or periodic ones cubes have no positions.
    ///
    /// # Errors
    /// Those of [`Producer::picture`].
    ///
    /// # Complexity
    /// $O(m \log m)$ for m cubes in the chains: those of the image are not made.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::{GreyImage, ImageRequest};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let cells = ImageRequest::new().cells("row", GreyImage::new(&[3], [0.0, 5.0, 1.0])?)?;
    /// assert_eq!(cells.found()?.cycles_model()?.groups()[0].name(), "H0_0_from_0_to_inf");
    /// # Ok(()) }
    /// ```
    pub fn cycles_model(&self) -> Result<Model, Error> {
        let mut chains = Vec::new();
        let mut places = vec![0; self.image.diagram.degree_count()];
        let chain = |name: String, of_cycle: usize, degree: usize, terms: &[(u64, i64)]| CubeChain {
            name,
            degree,
            terms: self.cells.cubes(of_cycle, degree, terms),
        };
        for class in self.cycles() {
            let pair = class.pair();
            let (degree, place) = (pair.degree(), places[pair.degree()]);
            places[degree] += 1;
            let death = pair.death().map_or("inf".to_owned(), |death| death.to_string());
            let name = format!("H{degree}_{place}_from_{}_to_{death}", pair.birth());
            chains.push(chain(name, degree, degree, class.cycle()));
            if let Some(bounding) = class.bounding_chain() {
                chains.push(chain(format!("filling_H{degree}_{place}"), degree, degree + 1, bounding));
            }
        }
        picture_of_cubes(&chains, |corners| self.cells.positions(corners))
    }

    /// The answer as plain data: classes are born and die by voxels, and chains have the vertices of their cells.
    ///
    /// # Examples
    /// See [`ImageCells`].
    pub fn answer(&self) -> PersistenceAnswer {
        let mut answer = self.image.answer();
        for (told, class) in answer.diagram.iter_mut().zip(self.cycles()) {
            (told.cycle, told.bounding_chain, told.cocycle) = self.terms(class);
        }
        answer.torsion_primes = Some(self.torsion_primes().to_vec());
        answer
    }

    /// The cycle, the bounding chain and the cocycle of a class, with the vertices of their cells.
    fn terms(&self, class: &ImageCycle) -> ClassTerms {
        let degree = class.pair().degree();
        (
            Some(self.cells.terms(degree, degree, class.cycle())),
            class.bounding_chain().map(|chain| self.cells.terms(degree, degree + 1, chain)),
            Some(self.cells.terms(degree, degree, class.cocycle())),
        )
    }
}

/// A cycle, the chain that it bounds, and a cocycle.
type ClassTerms = (Option<Vec<ChainTerm>>, Option<Vec<ChainTerm>>, Option<Vec<ChainTerm>>);
