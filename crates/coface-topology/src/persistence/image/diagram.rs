//! Diagrams of images.

use crate::persistence::Barcode;

/// A class of an image: the values at which it is born and dies, and the voxels that have them.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct ImagePair {
    pub(super) degree: usize,
    pub(super) birth: f64,
    pub(super) death: Option<f64>,
    pub(super) birth_voxel: usize,
    pub(super) death_voxel: Option<usize>,
}

impl ImagePair {
    /// The degree of the class.
    ///
    /// # Examples
    /// See [`ImageDiagram`].
    pub fn degree(&self) -> usize {
        self.degree
    }

    /// The value at which it is born.
    ///
    /// # Examples
    /// See [`ImageDiagram`].
    pub fn birth(&self) -> f64 {
        self.birth
    }

    /// The value at which it dies; `None` for an essential class.
    ///
    /// # Examples
    /// See [`ImageDiagram`].
    pub fn death(&self) -> Option<f64> {
        self.death
    }

    /// The voxel whose value the birth is, by its number in the image, of which the last axis runs fastest.
    ///
    /// # Examples
    /// See [`ImageDiagram`].
    pub fn birth_voxel(&self) -> usize {
        self.birth_voxel
    }

    /// The voxel whose value the death is; `None` for an essential class.
    ///
    /// # Examples
    /// See [`ImageDiagram`].
    pub fn death_voxel(&self) -> Option<usize> {
        self.death_voxel
    }

    /// The distance between birth and death; infinite for an essential class.
    ///
    /// # Examples
    /// See [`ImageDiagram`].
    pub fn persistence(&self) -> f64 {
        self.death.map_or(f64::INFINITY, |death| (death - self.birth).abs())
    }
}

/// The classes of an image that live longer than a moment: by rising degree, then in the order of births.
///
/// # Examples
/// Two valleys, at 0 and 1, with a pass at 5 between them.
/// ```
/// use coface_topology::{Coefficients, ImageFiltration};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let diagram = ImageFiltration::new(&[4], [0.0, 5.0, 1.0, 2.0])?.persistence(Coefficients::Modulo(2))?;
/// let [first, second] = diagram.pairs() else { panic!("two valleys") };
/// assert_eq!((first.degree(), first.birth(), first.death()), (0, 0.0, None));
/// assert_eq!((second.birth(), second.death(), second.persistence()), (1.0, Some(5.0), 4.0));
/// assert_eq!((second.birth_voxel(), second.death_voxel()), (2, Some(1)));
/// # Ok(()) }
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct ImageDiagram {
    pub(super) prime: u32,
    pub(super) is_falling: bool,
    pub(super) shape: Vec<usize>,
    pub(super) pairs: Vec<ImagePair>,
}

impl ImageDiagram {
    /// The number of elements of the field.
    ///
    /// # Examples
    /// ```
    /// use coface_topology::{Coefficients, ImageFiltration};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let image = ImageFiltration::new(&[2], [0.0, 5.0])?;
    /// assert_eq!(image.persistence(Coefficients::Modulo(3))?.prime(), 3);
    /// # Ok(()) }
    /// ```
    pub fn prime(&self) -> u32 {
        self.prime
    }

    /// Whether superlevel sets grow, so that no class dies above its birth.
    ///
    /// # Examples
    /// ```
    /// use coface_topology::{Coefficients, ImageFiltration};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let image = ImageFiltration::new(&[2], [0.0, 5.0])?.superlevel(true);
    /// assert!(image.persistence(Coefficients::Modulo(2))?.is_falling());
    /// # Ok(()) }
    /// ```
    pub fn is_falling(&self) -> bool {
        self.is_falling
    }

    /// The number of degrees, one more than the image has axes.
    ///
    /// # Examples
    /// ```
    /// use coface_topology::{Coefficients, ImageFiltration};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let image = ImageFiltration::new(&[2], [0.0, 5.0])?;
    /// assert_eq!(image.persistence(Coefficients::Modulo(2))?.degree_count(), 2);
    /// # Ok(()) }
    /// ```
    pub fn degree_count(&self) -> usize {
        self.shape.len() + 1
    }

    /// The numbers of voxels along the axes of the image.
    ///
    /// # Examples
    /// ```
    /// use coface_topology::{Coefficients, ImageFiltration};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let image = ImageFiltration::new(&[2], [0.0, 5.0])?;
    /// assert_eq!(image.persistence(Coefficients::Modulo(2))?.shape(), [2]);
    /// # Ok(()) }
    /// ```
    pub fn shape(&self) -> &[usize] {
        &self.shape
    }

    /// All pairs.
    ///
    /// # Examples
    /// See [`ImageDiagram`].
    pub fn pairs(&self) -> &[ImagePair] {
        &self.pairs
    }

    /// The pairs of a degree.
    ///
    /// # Examples
    /// ```
    /// use coface_topology::{Coefficients, ImageFiltration};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // A ring of eight pixels around a high one.
    /// let ring = ImageFiltration::new(&[3, 3], [1.0, 1.0, 1.0, 1.0, 7.0, 1.0, 1.0, 1.0, 1.0])?;
    /// let diagram = ring.persistence(Coefficients::Modulo(2))?;
    /// assert_eq!(diagram.pairs_of_degree(1)[0].death(), Some(7.0));
    /// # Ok(()) }
    /// ```
    pub fn pairs_of_degree(&self, degree: usize) -> &[ImagePair] {
        let start = self.pairs.partition_point(|pair| pair.degree < degree);
        let end = self.pairs.partition_point(|pair| pair.degree <= degree);
        &self.pairs[start..end]
    }

    /// The births and deaths of a degree; deaths of essential classes are infinite.
    ///
    /// # Examples
    /// ```
    /// use coface_topology::{Coefficients, ImageFiltration};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let image = ImageFiltration::new(&[3], [0.0, 5.0, 1.0])?.superlevel(true);
    /// let diagram = image.persistence(Coefficients::Modulo(2))?;
    /// assert_eq!(diagram.barcode(0).intervals(), [[5.0, f64::NEG_INFINITY]]);
    /// # Ok(()) }
    /// ```
    pub fn barcode(&self, degree: usize) -> Barcode {
        let never = if self.is_falling { f64::NEG_INFINITY } else { f64::INFINITY };
        let pairs = self.pairs_of_degree(degree).iter();
        Barcode::of(pairs.map(|pair| [pair.birth, pair.death.unwrap_or(never)]))
    }

    /// The numbers of classes that never die, by degree.
    ///
    /// # Examples
    /// ```
    /// use coface_topology::{Coefficients, ImageFiltration};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let circle = ImageFiltration::new(&[3], [0.0, 5.0, 1.0])?.periodic(&[true])?;
    /// assert_eq!(circle.persistence(Coefficients::Modulo(2))?.betti_numbers(), [1, 1]);
    /// # Ok(()) }
    /// ```
    pub fn betti_numbers(&self) -> Vec<usize> {
        let essential =
            |degree| self.pairs_of_degree(degree).iter().filter(|pair| pair.death.is_none()).count();
        (0..self.degree_count()).map(essential).collect()
    }

    /// The diagram without the pairs whose persistence is `length` or less. Essential classes stay.
    ///
    /// # Examples
    /// ```
    /// use coface_topology::{Coefficients, ImageFiltration};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let diagram = ImageFiltration::new(&[4], [0.0, 5.0, 1.0, 2.0])?.persistence(Coefficients::Modulo(2))?;
    /// assert_eq!(diagram.longer_than(4.0).pairs().len(), 1);
    /// # Ok(()) }
    /// ```
    #[must_use]
    pub fn longer_than(&self, length: f64) -> Self {
        let pairs = self.pairs.iter().filter(|pair| pair.persistence() > length).copied().collect();
        Self { pairs, shape: self.shape.clone(), ..*self }
    }
}
