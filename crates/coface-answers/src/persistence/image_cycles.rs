//! Cycles of the classes of an image, on the cells that its voxels make.

use super::{FoundDiagram, GreyImage, ImageRequest, PersistenceRequest};
use crate::Producer;
use crate::answer::PersistenceAnswer;
use crate::persistence::image::Axes;
use coface_algebra::chains::ChainComplex;
use coface_algebra::progress::stage;
use coface_algebra::{CellId, Error};
use coface_complexes::cubical::CubicalVolume;
use coface_geometry::Positions;
use coface_io::{ModelParts, Structure, VoxelFrame};
use coface_topology::{Filtration, ImageConstruction, ImageFiltration};

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
    producer: Producer,
    /// For each degree the voxel by which each cell of the producer enters, `NEVER` for a cell that does not.
    entering: Vec<Vec<u32>>,
    /// For each degree the cells that enter, unless all do.
    kept: Option<Vec<Vec<CellId>>>,
    /// The rank of each voxel among those that enter, `NEVER` for the others.
    ranks: Vec<u32>,
    filtration: ImageFiltration,
}

impl ImageRequest {
    /// The cubes of an image with this name, for cycles of its classes.
    ///
    /// # Errors
    /// Those of [`Self::found`]; [`ErrorKind::TooLarge`](coface_algebra::ErrorKind::TooLarge) if there are too many cubes for one complex.
    ///
    /// # Complexity
    /// Linear in the cubes, $2^n$ for each voxel of n axes, which are all stored.
    ///
    /// # Examples
    /// See [`ImageCells`].
    pub fn cells(&self, name: &str, image: GreyImage) -> Result<ImageCells, Error> {
        let GreyImage { axes, filtration, frame, .. } = image;
        let make = || {
            let (filtration, is_periodic) = self.filtration(&axes, filtration)?;
            let _steps = stage("making cubes", 0);
            let mut ranks = vec![NEVER; axes.voxel_count()];
            (0..).zip(filtration.entrance()).for_each(|(rank, voxel)| ranks[voxel as usize] = rank);
            let are_vertices = self.construction == ImageConstruction::Vertices;
            let around = Around::new(axes.shape(), is_periodic, are_vertices);
            let volume = around.volume(|voxel| ranks[axes.number(voxel)] != NEVER)?;
            let entering = entering(&volume, &axes, &ranks, &around)?;
            let producer = around.placed(volume, frame)?;
            Ok((filtration, ranks, entering, producer))
        };
        let (filtration, ranks, entering, producer) = make().map_err(|error: Error| error.in_file(name))?;
        let is_whole = entering.iter().flatten().all(|&voxel| voxel != NEVER);
        let kept = (!is_whole).then(|| {
            let enter = |voxels: &Vec<u32>| {
                let cells = voxels.iter().enumerate().filter(|&(_, &voxel)| voxel != NEVER);
                cells.map(|(cell, _)| CellId::new(cell)).collect()
            };
            entering.iter().map(enter).collect()
        });
        let (name, request) = (name.to_owned(), self.clone());
        Ok(ImageCells { name, request, axes, producer, entering, kept, ranks, filtration })
    }
}

/// The voxels that a cell has to do with: those that it is a face of, or those that are its corners.
struct Around {
    shape: Vec<u32>,
    is_periodic: Vec<bool>,
    are_vertices: bool,
    /// The axes along which cells extend: of corners those with more than one voxel, or a single one.
    axes: Vec<usize>,
}

impl Around {
    fn new(shape: &[usize], is_periodic: Vec<bool>, are_vertices: bool) -> Self {
        let is_long = |&axis: &usize| !are_vertices || shape[axis] != 1;
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
    axes: &Axes,
    ranks: &[u32],
    around: &Around,
) -> Result<Vec<Vec<u32>>, Error> {
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
    let degrees = volume.cell_ids()?;
    Ok(degrees.iter().map(|ids| ids.iter().map(|&id| of_cell(id)).collect()).collect())
}

impl ImageCells {
    /// Finds the diagram with its cycles.
    ///
    /// # Errors
    /// Those of [`ImageRequest::found`] and [`coface_topology::persistent_cycles`].
    ///
    /// # Complexity
    /// That of [`coface_topology::persistent_cycles`] of all cubes.
    ///
    /// # Examples
    /// See [`ImageCells`].
    pub fn found(&self) -> Result<FoundImageCycles<'_>, Error> {
        let find = || {
            let (complex, filtration) = self.complex()?;
            let request = PersistenceRequest::new().coefficients(self.request.coefficients);
            let request = request.min_persistence(self.least_persistence()).cycles(true);
            Ok((request.classes(&complex, &filtration)?, filtration))
        };
        let ((diagram, cycles, torsion_primes), filtration) =
            find().map_err(|error: Error| error.in_file(&self.name))?;
        let kept = self.kept.clone();
        let diagram = match &kept {
            Some(kept) => diagram.with_cells(kept),
            None => diagram,
        };
        let least = self.least_persistence();
        let found = FoundDiagram {
            producer: &self.producer,
            name: self.name.clone(),
            function: format!("voxels, {}-construction", self.request.construction),
            star: Some(if self.request.is_superlevel { "upper" } else { "lower" }),
            filtration,
            min_persistence: least,
            diagram: diagram.longer_than(least),
            most_degree: None,
            threshold: None,
            cycles,
            torsion_primes,
            kept,
            relative_to: None,
            image_of: None,
        };
        Ok(FoundImageCycles { cells: self, found })
    }

    fn least_persistence(&self) -> f64 {
        self.request.min_persistence.max(0.0)
    }

    /// The cubes that enter as a chain complex, and when they enter. Classes are born and die by the same voxels as those of [`ImageRequest::found`].
    ///
    /// # Errors
    /// Those of [`Producer::chain_complex`].
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
        let complex = self.producer.chain_complex()?;
        let complex = match &self.kept {
            Some(kept) => complex.subcomplex(kept)?,
            None => complex,
        };
        let filtration = self.filtration_of(&complex)?;
        Ok((complex, filtration))
    }

    /// The vertices of a cell of the [complex](Self::complex), and the place of the voxel by which it enters among those that enter.
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
    /// assert_eq!(ImageRequest::new().cells("row", row)?.cell(1, CellId::new(0)), (vec![0, 1], 1));
    /// # Ok(()) }
    /// ```
    pub fn cell(&self, degree: usize, cell: CellId) -> (Vec<u32>, u32) {
        let cell = self.kept.as_ref().map_or(cell, |kept| kept[degree][cell.index()]);
        let voxel = self.entering[degree][cell.index()];
        (self.producer.cell_vertices(degree, cell), self.ranks[voxel as usize])
    }

    /// The cells that enter, by their voxels, and of one voxel by their numbers.
    fn filtration_of(&self, complex: &ChainComplex) -> Result<Filtration, Error> {
        let degrees = self.entering.iter().take(complex.degree_count());
        let voxels: Vec<Vec<u32>> =
            degrees.map(|voxels| voxels.iter().copied().filter(|&voxel| voxel != NEVER).collect()).collect();
        let value = |&voxel: &u32| self.filtration.value(voxel as usize);
        let values = voxels.iter().map(|voxels| voxels.iter().map(value).collect()).collect();
        let sorted = |voxels: &Vec<u32>| {
            let mut order: Vec<u32> = (0..voxels.len() as u32).collect();
            order.sort_by_key(|&cell| self.ranks[voxels[cell as usize] as usize]);
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
    /// # Examples
    /// ```
    /// use coface_answers::{GreyImage, ImageRequest};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let row = GreyImage::new(&[3], [0.0, 5.0, 1.0])?;
    /// assert_eq!(ImageRequest::new().cells("row", row)?.producer().chain_complex()?.f_vector(), [4, 3]);
    /// # Ok(()) }
    /// ```
    pub fn producer(&self) -> &Producer {
        &self.producer
    }
}

/// A persistence diagram of an image with the cycles of its classes.
#[derive(Clone, Debug)]
pub struct FoundImageCycles<'a> {
    cells: &'a ImageCells,
    found: FoundDiagram<'a>,
}

impl<'a> FoundImageCycles<'a> {
    /// The diagram with its cycles, whose cells have numbers in the complex of [`ImageCells::producer`]. It gives them as a model too, unless there are four axes or
    /// periodic ones, whose cubes have no positions.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::{GreyImage, ImageRequest};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let cells = ImageRequest::new().cells("row", GreyImage::new(&[3], [0.0, 5.0, 1.0])?)?;
    /// let found = cells.found()?;
    /// assert_eq!(found.found().cycles().map(<[_]>::len), Some(2));
    /// assert_eq!(found.found().cycles_model()?.groups()[0].name(), "H0_0_from_0_to_inf");
    /// # Ok(()) }
    /// ```
    pub fn found(&self) -> &FoundDiagram<'a> {
        &self.found
    }

    /// The answer as plain data: classes are born and die by voxels, and chains have the vertices of their cells.
    ///
    /// # Examples
    /// See [`ImageCells`].
    pub fn answer(&self) -> PersistenceAnswer {
        let mut answer = self.found.answer();
        let entering = |degree: usize, cell: CellId| self.cells.entering[degree][cell.index()];
        let rank = |voxel: u32| self.cells.ranks[voxel as usize];
        let place = |voxel: u32| self.cells.axes.voxel(voxel as usize);
        let mut told = Vec::with_capacity(answer.diagram.len());
        for (mut class, pair) in answer.diagram.into_iter().zip(self.found.diagram().pairs()) {
            let birth = entering(pair.degree(), pair.birth_cell());
            let death = pair.death_cell().map(|cell| entering(pair.degree() + 1, cell));
            class.birth_cell = place(birth);
            class.death_cell = death.map(place);
            told.push((pair.degree(), rank(birth), death.map(rank), class));
        }
        // As they are without cycles.
        told.sort_by_key(|&(degree, birth, death, _)| (degree, birth, death));
        answer.diagram = told.into_iter().map(|(.., class)| class).collect();
        answer
    }
}
