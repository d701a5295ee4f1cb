//! Persistence of images: arrays and volume files whose numbers are grey values.

use super::diagram::{DiagramFormat, Line, write_lines};
use crate::answer::{PersistenceAnswer, PersistencePairAnswer};
use coface_algebra::{Error, ErrorKind};
use coface_complexes::cubical::CubicalVolume;
use coface_io::{Remark, VolumeReading, VolumeStream, VoxelFrame};
use coface_topology::{Coefficients, ImageConstruction, ImageDiagram, ImageFiltration, ImagePair};
use std::io::Write;

/// The grey values of an array or of a volume file.
///
/// # Examples
/// ```
/// use coface_answers::GreyImage;
/// use coface_io::{Format, VolumeStream};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let text = b"NRRD0004\ntype: double\ndimension: 2\nsizes: 3 1\nencoding: ascii\n\n1 0.5 -2";
/// let (image, remarks) = GreyImage::read(VolumeStream::new(&text[..], Format::Nrrd)?)?;
/// assert_eq!(image.shape(), [3, 1]);
/// assert!(remarks.is_empty());
/// # Ok(()) }
/// ```
#[derive(Clone, Debug)]
pub struct GreyImage {
    pub(super) axes: Axes,
    pub(super) filtration: ImageFiltration,
    /// Whether a mask has left voxels out.
    pub(super) is_cut: bool,
    /// Where the file places voxels.
    pub(super) frame: Option<VoxelFrame>,
}

/// How the axes of an image are numbered.
#[derive(Clone, Debug)]
pub(super) struct Axes {
    /// The number of voxels along each.
    shape: Vec<usize>,
    pub(super) is_first_fastest: bool,
}

impl Axes {
    /// Something for each axis in the order of the library, in which the last axis runs fastest, or back.
    fn turned<T: Clone>(&self, mut list: Vec<T>) -> Vec<T> {
        if self.is_first_fastest {
            list.reverse();
        }
        list
    }

    /// The number of voxels along each axis.
    pub(super) fn shape(&self) -> &[usize] {
        &self.shape
    }

    pub(super) fn voxel_count(&self) -> usize {
        self.shape.iter().product()
    }

    /// The number of the voxel at this place along each axis.
    pub(super) fn number(&self, voxel: &[u32]) -> usize {
        let along = |number: usize, axis: usize| number * self.shape[axis] + voxel[axis] as usize;
        match self.is_first_fastest {
            true => (0..voxel.len()).rev().fold(0, along),
            false => (0..voxel.len()).fold(0, along),
        }
    }

    /// The place of a voxel along each axis.
    pub(super) fn voxel(&self, number: usize) -> Vec<u32> {
        let mut rest = number;
        let mut voxel = vec![0; self.shape.len()];
        let place = |axis: usize| if self.is_first_fastest { axis } else { self.shape.len() - 1 - axis };
        for axis in (0..self.shape.len()).map(place) {
            voxel[axis] = (rest % self.shape[axis]) as u32;
            rest /= self.shape[axis];
        }
        voxel
    }
}

impl GreyImage {
    /// The image of this shape with these numbers, of which those along the last axis come first.
    ///
    /// # Errors
    /// Those of [`ImageFiltration::new`].
    ///
    /// # Examples
    /// ```
    /// use coface_answers::GreyImage;
    /// assert_eq!(GreyImage::new(&[1, 3], [1.0, 0.5, -2.0])?.shape(), [1, 3]);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn new(shape: &[usize], numbers: impl IntoIterator<Item = f64>) -> Result<Self, Error> {
        let axes = Axes { shape: shape.to_vec(), is_first_fastest: false };
        Ok(Self { axes, filtration: ImageFiltration::new(shape, numbers)?, is_cut: false, frame: None })
    }

    /// The image in a volume file, with the axes of the file. Gives remarks too.
    ///
    /// # Errors
    /// Those of [`VolumeStream::numbers`] and [`ImageFiltration::new`].
    ///
    /// # Examples
    /// See [`GreyImage`].
    pub fn read(stream: VolumeStream<'_>) -> Result<(Self, Vec<Remark>), Error> {
        let shape: Vec<usize> = stream.shape().iter().map(|&length| length as usize).collect();
        let is_first_fastest = shape.len() > 1 && stream.fastest_axis() == 0;
        let axes = Axes { shape: shape.clone(), is_first_fastest };
        let frame = stream.frame();
        let (numbers, remarks) = stream.numbers()?;
        let filtration = ImageFiltration::new(&axes.turned(shape), numbers)?;
        Ok((Self { axes, filtration, is_cut: false, frame }, remarks))
    }

    /// The number of voxels along each axis.
    ///
    /// # Examples
    /// See [`GreyImage`].
    pub fn shape(&self) -> &[usize] {
        &self.axes.shape
    }

    /// Leaves only the voxels that are set in a mask.
    ///
    /// # Errors
    /// [`ErrorKind::Shape`] unless both have one shape.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::{GreyImage, ImageRequest};
    /// use coface_complexes::cubical::CubicalVolume;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let ends = CubicalVolume::new(&[3], &[false], |voxel| voxel[0] != 1)?;
    /// let image = GreyImage::new(&[3], [0.0, 5.0, 1.0])?.mask(&ends)?;
    /// assert_eq!(ImageRequest::new().found("row", image)?.answer().betti, [2, 0]);
    /// # Ok(()) }
    /// ```
    pub fn mask(self, mask: &CubicalVolume) -> Result<Self, Error> {
        let shape: Vec<usize> = mask.shape().iter().map(|&length| length as usize).collect();
        if shape != self.axes.shape {
            return Err(Error::new(
                ErrorKind::Shape,
                format!("the mask has the shape {shape:?}, and the image {:?}", self.axes.shape),
            )
            .with_cure("give a mask of the shape of the image"));
        }
        let count: usize = shape.iter().product();
        let Self { axes, filtration, frame, .. } = self;
        let filtration = filtration.mask((0..count).map(|voxel| mask.is_set(&axes.voxel(voxel))))?;
        Ok(Self { axes, filtration, is_cut: true, frame })
    }
}

/// Asks for persistent homology of an image.
///
/// # Examples
/// Two dark pixels with a bright one between them.
/// ```
/// use coface_answers::{GreyImage, ImageRequest};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let answer = ImageRequest::new().found("row", GreyImage::new(&[1, 3], [0.0, 5.0, 1.0])?)?.answer();
/// let pair = &answer.diagram[1];
/// assert_eq!((pair.birth, pair.death), (1.0, Some(5.0)));
/// assert_eq!((&pair.birth_cell[..], pair.death_cell.as_deref()), (&[0, 2][..], Some(&[0, 1][..])));
/// # Ok(()) }
/// ```
#[derive(Clone, Debug)]
pub struct ImageRequest {
    pub(super) coefficients: Coefficients,
    pub(super) construction: ImageConstruction,
    pub(super) is_superlevel: bool,
    periodic: VolumeReading,
    pub(super) min_persistence: f64,
}

impl Default for ImageRequest {
    fn default() -> Self {
        Self {
            coefficients: Coefficients::Modulo(2),
            construction: ImageConstruction::default(),
            is_superlevel: false,
            periodic: VolumeReading::default(),
            min_persistence: 0.0,
        }
    }
}

impl ImageRequest {
    /// Asks for persistence over two elements of sublevel sets, with voxels as top cells.
    ///
    /// # Examples
    /// See [`ImageRequest`].
    pub fn new() -> Self {
        Self::default()
    }

    /// The field of coefficients.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{GreyImage, ImageRequest};
    /// let request = ImageRequest::new().coefficients(coface_topology::Coefficients::Modulo(3));
    /// assert_eq!(request.found("row", GreyImage::new(&[2], [0.0, 1.0])?)?.answer().field, 3);
    /// # Ok(()) }
    /// ```
    pub fn coefficients(mut self, coefficients: Coefficients) -> Self {
        self.coefficients = coefficients;
        self
    }

    /// What voxels are.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{GreyImage, ImageRequest};
    /// use coface_topology::ImageConstruction;
    /// // Two dark pixels that share a corner are one component only where pixels are top cells.
    /// let corners = || GreyImage::new(&[2, 2], [0.0, 9.0, 9.0, 0.0]);
    /// assert_eq!(ImageRequest::new().found("corners", corners()?)?.answer().diagram.len(), 1);
    /// let request = ImageRequest::new().construction(ImageConstruction::Vertices);
    /// assert_eq!(request.found("corners", corners()?)?.answer().diagram.len(), 2);
    /// # Ok(()) }
    /// ```
    pub fn construction(mut self, construction: ImageConstruction) -> Self {
        self.construction = construction;
        self
    }

    /// Whether superlevel sets grow, from high numbers to low ones.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{GreyImage, ImageRequest};
    /// let found = ImageRequest::new().superlevel(true).found("row", GreyImage::new(&[2], [0.0, 1.0])?)?;
    /// assert_eq!(found.answer().diagram[0].birth, 1.0);
    /// # Ok(()) }
    /// ```
    pub fn superlevel(mut self, is_superlevel: bool) -> Self {
        self.is_superlevel = is_superlevel;
        self
    }

    /// Which axes are periodic: those of the reading; its rule is not asked.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{GreyImage, ImageRequest};
    /// use coface_io::VolumeReading;
    /// let mut reading = VolumeReading::default();
    /// reading.periodic[0] = true;
    /// let found = ImageRequest::new().periodic(reading).found("circle", GreyImage::new(&[3], [0.0, 1.0, 2.0])?)?;
    /// assert_eq!(found.answer().betti, [1, 1]);
    /// # Ok(()) }
    /// ```
    pub fn periodic(mut self, reading: VolumeReading) -> Self {
        self.periodic = reading;
        self
    }

    /// Leaves out the pairs whose persistence is not greater. Pairs of persistence 0 are never listed: they are not computed one by one.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{GreyImage, ImageRequest};
    /// let row = GreyImage::new(&[3], [0.0, 5.0, 1.0])?;
    /// assert_eq!(ImageRequest::new().min_persistence(4.0).found("row", row)?.answer().diagram.len(), 1);
    /// # Ok(()) }
    /// ```
    pub fn min_persistence(mut self, least: f64) -> Self {
        self.min_persistence = least;
        self
    }

    /// Finds the diagram of an image with this name.
    ///
    /// # Errors
    /// Those of [`ImageFiltration::periodic`] and [`ImageFiltration::persistence`].
    ///
    /// # Examples
    /// See [`ImageRequest`].
    pub fn found(&self, name: &str, image: GreyImage) -> Result<FoundImage, Error> {
        let GreyImage { axes, filtration, is_cut, .. } = image;
        let mut has_periodic = false;
        let find = || {
            let (filtration, is_periodic) = self.filtration(&axes, filtration)?;
            has_periodic = is_periodic.contains(&true);
            Ok(filtration.persistence(self.coefficients)?.longer_than(self.min_persistence))
        };
        let diagram = find().map_err(|error: Error| error.in_file(name))?;
        Ok(FoundImage {
            name: name.to_owned(),
            construction: self.construction,
            axes,
            diagram,
            is_cut,
            is_periodic: has_periodic,
            min_persistence: self.min_persistence.max(0.0),
        })
    }

    /// The image as it grows, and which of its axes are periodic.
    pub(super) fn filtration(
        &self,
        axes: &Axes,
        filtration: ImageFiltration,
    ) -> Result<(ImageFiltration, Vec<bool>), Error> {
        let is_periodic = self.periodic.periodic_axes(axes.shape.len())?;
        let filtration = filtration
            .construction(self.construction)
            .superlevel(self.is_superlevel)
            .periodic(&axes.turned(is_periodic.clone()))?;
        if let Some(place) = filtration.voxel_born_at_infinity() {
            let from = if self.is_superlevel { "inf" } else { "-inf" };
            return Err(Error::invalid(format!(
                "voxel {:?} is at {from}, so classes would be born at infinity",
                axes.voxel(place)
            ))
            .with_cure("write a finite number there, or NaN if the voxel is outside"));
        }
        Ok((filtration, is_periodic))
    }
}

/// A persistence diagram of an image.
#[derive(Clone, Debug)]
pub struct FoundImage {
    pub(super) name: String,
    pub(super) construction: ImageConstruction,
    pub(super) axes: Axes,
    pub(super) diagram: ImageDiagram,
    /// Whether a mask has left voxels out.
    pub(super) is_cut: bool,
    pub(super) is_periodic: bool,
    pub(super) min_persistence: f64,
}

impl FoundImage {
    /// The diagram of an image that was made otherwise, such as by blocks, without the pairs whose persistence is not greater than `least`. Its axes are
    /// those of an array, of which the last one runs fastest.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::FoundImage;
    /// use coface_topology::{ImageBlocks, ImageConstruction};
    /// let diagram = ImageBlocks::new(&[1, 3], &[1, 3])?.part(0, [0.0, 5.0, 1.0])?.diagram()?;
    /// let found = FoundImage::of_diagram("row", ImageConstruction::TopCells, &diagram, false, 0.0);
    /// assert_eq!(found.voxels(&found.diagram().pairs()[1]), (vec![0, 2], Some(vec![0, 1])));
    /// # Ok(()) }
    /// ```
    pub fn of_diagram(
        name: &str,
        construction: ImageConstruction,
        diagram: &ImageDiagram,
        is_periodic: bool,
        least: f64,
    ) -> Self {
        Self {
            name: name.to_owned(),
            construction,
            axes: Axes { shape: diagram.shape().to_vec(), is_first_fastest: false },
            diagram: diagram.longer_than(least),
            is_cut: false,
            is_periodic,
            min_persistence: least.max(0.0),
        }
    }

    /// The same with the axes of a file whose first axis runs fastest: they are numbered the other way round.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::FoundImage;
    /// use coface_topology::{ImageBlocks, ImageConstruction};
    /// let diagram = ImageBlocks::new(&[1, 3], &[1, 3])?.part(0, [0.0, 5.0, 1.0])?.diagram()?;
    /// let found = FoundImage::of_diagram("row", ImageConstruction::TopCells, &diagram, false, 0.0).first_fastest();
    /// assert_eq!(found.voxels(&found.diagram().pairs()[1]), (vec![2, 0], Some(vec![1, 0])));
    /// # Ok(()) }
    /// ```
    #[must_use]
    pub fn first_fastest(mut self) -> Self {
        self.axes.shape.reverse();
        self.axes.is_first_fastest = !self.axes.is_first_fastest;
        self
    }

    /// The diagram; numbers of voxels are those of an image whose last axis runs fastest.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{GreyImage, ImageRequest};
    /// let found = ImageRequest::new().found("row", GreyImage::new(&[3], [0.0, 5.0, 1.0])?)?;
    /// assert_eq!(found.diagram().pairs().len(), 2);
    /// # Ok(()) }
    /// ```
    pub fn diagram(&self) -> &ImageDiagram {
        &self.diagram
    }

    /// Pairs whose persistence is not greater were left out.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{GreyImage, ImageRequest};
    /// let found = ImageRequest::new().found("row", GreyImage::new(&[2], [0.0, 5.0])?)?;
    /// assert_eq!(found.longer_than(4.0).min_persistence(), 4.0);
    /// # Ok(()) }
    /// ```
    pub fn min_persistence(&self) -> f64 {
        self.min_persistence
    }

    /// The same without the pairs whose persistence is not greater.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{GreyImage, ImageRequest};
    /// let found = ImageRequest::new().found("row", GreyImage::new(&[3], [0.0, 5.0, 1.0])?)?;
    /// assert_eq!(found.longer_than(4.0).diagram().pairs().len(), 1);
    /// # Ok(()) }
    /// ```
    #[must_use]
    pub fn longer_than(&self, least: f64) -> Self {
        let min_persistence = self.min_persistence.max(least);
        Self { diagram: self.diagram.longer_than(least), min_persistence, ..self.clone() }
    }

    /// The voxels that have the birth and the death of a pair, by their places along the axes.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{GreyImage, ImageRequest};
    /// let found = ImageRequest::new().found("row", GreyImage::new(&[1, 3], [0.0, 5.0, 1.0])?)?;
    /// assert_eq!(found.voxels(&found.diagram().pairs()[1]), (vec![0, 2], Some(vec![0, 1])));
    /// # Ok(()) }
    /// ```
    pub fn voxels(&self, pair: &ImagePair) -> (Vec<u32>, Option<Vec<u32>>) {
        (self.axes.voxel(pair.birth_voxel()), pair.death_voxel().map(|voxel| self.axes.voxel(voxel)))
    }

    /// The answer as plain data.
    ///
    /// # Examples
    /// See [`ImageRequest`].
    pub fn answer(&self) -> PersistenceAnswer {
        let pair = |pair: &ImagePair| {
            let (birth_cell, death_cell) = self.voxels(pair);
            PersistencePairAnswer {
                degree: pair.degree(),
                kind: None,
                birth: pair.birth(),
                death: pair.death(),
                birth_cell,
                death_cell,
                cycle: None,
                bounding_chain: None,
                cocycle: None,
            }
        };
        PersistenceAnswer {
            file: self.name.clone(),
            field: self.diagram.prime(),
            function: format!("voxels, {}-construction", self.construction),
            star: Some(if self.diagram.is_falling() { "upper" } else { "lower" }.to_owned()),
            threshold: None,
            diagram: self.diagram.pairs().iter().map(pair).collect(),
            betti: self.diagram.betti_numbers(),
            torsion_primes: None,
            collapsed: None,
            relative_to: None,
            image_of: None,
            vertex_names: None,
            remarks: Vec::new(),
        }
    }

    /// Writes the diagram as [`write_diagram`](crate::write_diagram) does; voxels are given by their places along the axes, with blanks between
    /// them.
    ///
    /// # Errors
    /// [`ErrorKind::Io`] if the stream cannot be written.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{DiagramFormat, GreyImage, ImageRequest};
    /// let found = ImageRequest::new().found("row", GreyImage::new(&[3], [0.0, 5.0, 1.0])?)?;
    /// let mut text = Vec::new();
    /// found.write(&mut text, DiagramFormat::Gudhi)?;
    /// assert_eq!(text, b"2 0 0 inf\n2 0 1 5\n");
    /// # Ok(()) }
    /// ```
    pub fn write(&self, out: impl Write, format: DiagramFormat) -> Result<(), Error> {
        let name = |voxel: Vec<u32>| voxel.iter().map(u32::to_string).collect::<Vec<_>>().join(" ");
        let lines = self.diagram.pairs().iter().map(|pair| {
            let (birth_cell, death_cell) = self.voxels(pair);
            Line {
                degree: pair.degree(),
                birth: pair.birth(),
                death: pair.death(),
                birth_cell: name(birth_cell),
                death_cell: death_cell.map(name),
            }
        });
        let never = if self.diagram.is_falling() { f64::NEG_INFINITY } else { f64::INFINITY };
        write_lines(self.diagram.prime(), never, self.diagram.degree_count(), lines, out, format)
    }
}
