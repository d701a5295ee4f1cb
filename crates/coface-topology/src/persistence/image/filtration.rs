//! Images whose sublevel or superlevel sets grow.

use super::circles::Circles;
use super::diagram::{ImageDiagram, ImagePair};
use super::gradient::{Cell, Gradient, NEVER, OUTSIDE};
use super::grid::{Grid, MOST_AXES};
use super::pairing::{Class, Pairing};
use crate::homology::Coefficients;
use crate::persistence::reduction::prime;
use coface_algebra::progress::stage;
use coface_algebra::{Binary, Error, ErrorKind, Odd, memory};
use rayon::prelude::*;
use std::fmt;
use std::str::FromStr;

/// What the voxels of an image are in its cubical complex.
///
/// # Examples
/// ```
/// use coface_topology::ImageConstruction;
/// assert_eq!("v".parse(), Ok(ImageConstruction::Vertices));
/// assert_eq!(ImageConstruction::default().to_string(), "t");
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum ImageConstruction {
    /// The V-construction: voxels are vertices, and neighbors share a facet. `vertices` of GUDHI.
    Vertices,
    /// The T-construction: voxels are top cells, and neighbors share a corner at least. `top_dimensional_cells` of GUDHI.
    #[default]
    TopCells,
}

impl fmt::Display for ImageConstruction {
    /// `v` or `t`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Vertices => "v",
            Self::TopCells => "t",
        })
    }
}

impl FromStr for ImageConstruction {
    type Err = Error;

    /// # Errors
    /// [`ErrorKind::InvalidInput`] unless the name is `v` or `t`, small or large.
    fn from_str(name: &str) -> Result<Self, Error> {
        match name {
            "v" | "V" => Ok(Self::Vertices),
            "t" | "T" => Ok(Self::TopCells),
            _ => Err(Error::invalid(format!("there is no construction {name:?}"))
                .with_cure("give v (voxels are vertices) or t (voxels are top cells)")),
        }
    }
}

/// The numbers of an image, 32 bits each where that loses nothing.
#[derive(Clone, Debug)]
enum Numbers {
    Single(Vec<f32>),
    Double(Vec<f64>),
}

impl Numbers {
    fn new(numbers: impl IntoIterator<Item = f64>) -> Self {
        let mut single = Vec::new();
        let mut numbers = numbers.into_iter();
        while let Some(number) = numbers.next() {
            let short = number as f32;
            if f64::from(short) != number && !number.is_nan() {
                let mut double: Vec<f64> = single.iter().map(|&short| f64::from(short)).collect();
                double.push(number);
                double.extend(numbers);
                return Self::Double(double);
            }
            single.push(short);
        }
        Self::Single(single)
    }

    fn len(&self) -> usize {
        match self {
            Self::Single(numbers) => numbers.len(),
            Self::Double(numbers) => numbers.len(),
        }
    }

    fn at(&self, place: usize) -> f64 {
        let number = match self {
            Self::Single(numbers) => numbers[place].into(),
            Self::Double(numbers) => numbers[place],
        };
        // No negative zero is given.
        number + 0.0
    }

    fn remove(&mut self, place: usize) {
        match self {
            Self::Single(numbers) => numbers[place] = f32::NAN,
            Self::Double(numbers) => numbers[place] = f64::NAN,
        }
    }

    /// The places of all numbers that enter, as they do: equal numbers by their places.
    fn order(&self, is_falling: bool) -> Vec<u32> {
        let enters = f64::is_finite;
        match self {
            Self::Single(numbers) => {
                let key = |(place, &number): (usize, &f32)| {
                    // -0 and 0 are equal.
                    let bits = (number + 0.0).to_bits();
                    let rising = if bits >> 31 == 1 { !bits } else { bits | 1 << 31 };
                    let key = if is_falling { !rising } else { rising };
                    enters(number.into()).then_some(u64::from(key) << 32 | place as u64)
                };
                let mut keys: Vec<u64> = numbers.par_iter().enumerate().filter_map(key).collect();
                keys.par_sort_unstable();
                keys.into_par_iter().map(|key| key as u32).collect()
            }
            Self::Double(numbers) => {
                let key = |(place, &number): (usize, &f64)| {
                    let bits = (number + 0.0).to_bits();
                    let rising = if bits >> 63 == 1 { !bits } else { bits | 1 << 63 };
                    enters(number).then_some((if is_falling { !rising } else { rising }, place as u32))
                };
                let mut keys: Vec<(u64, u32)> = numbers.par_iter().enumerate().filter_map(key).collect();
                keys.par_sort_unstable();
                keys.into_par_iter().map(|key| key.1).collect()
            }
        }
    }
}

/// That one to four axes are longer than 1.
pub(super) fn require_axes(shape: &[usize]) -> Result<(), Error> {
    let long = shape.iter().filter(|&&length| length != 1).count();
    if long > MOST_AXES || shape.is_empty() {
        return Err(Error::new(
            ErrorKind::Shape,
            format!("the image has the shape {shape:?}: {long} axes are longer than 1"),
        )
        .with_cure("give an image with one to four axes"));
    }
    Ok(())
}

/// An image, an array of numbers with one to four axes, whose sublevel or superlevel sets grow.
///
/// A voxel whose number is NaN never enters; nor does one at infinity, where values go to.
///
/// # Examples
/// A ring of low pixels around a high one is a hole until the high one enters.
/// ```
/// use coface_topology::{Coefficients, ImageConstruction, ImageFiltration};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let ring = [1.0, 2.0, 1.0, 2.0, 9.0, 2.0, 1.0, 2.0, 1.0];
/// let image = ImageFiltration::new(&[3, 3], ring)?.construction(ImageConstruction::Vertices);
/// let diagram = image.persistence(Coefficients::Modulo(2))?;
/// let hole = &diagram.pairs_of_degree(1)[0];
/// assert_eq!((hole.birth(), hole.death()), (2.0, Some(9.0)));
/// assert_eq!(diagram.pairs_of_degree(0).len(), 4);
/// # Ok(()) }
/// ```
#[derive(Clone, Debug)]
pub struct ImageFiltration {
    shape: Vec<usize>,
    numbers: Numbers,
    construction: ImageConstruction,
    is_superlevel: bool,
    is_periodic: Vec<bool>,
}

impl ImageFiltration {
    /// The image of this shape with these numbers, of which those along the last axis come first. It grows by sublevel sets in the
    /// T-construction.
    ///
    /// # Errors
    /// [`ErrorKind::Shape`] for another number of numbers than the shape says, and unless one to four axes are longer than 1;
    /// [`ErrorKind::TooLarge`] from 2^32 - 1 voxels on, with a layer around them.
    ///
    /// # Complexity
    /// Linear. Numbers are held with 32 bits where that loses nothing.
    ///
    /// # Examples
    /// See [`ImageFiltration`].
    pub fn new(shape: &[usize], numbers: impl IntoIterator<Item = f64>) -> Result<Self, Error> {
        let numbers = Numbers::new(numbers);
        let is_periodic = vec![false; shape.len()];
        require_axes(shape)?;
        if shape.iter().try_fold(1usize, |count, &length| count.checked_mul(length)) != Some(numbers.len()) {
            return Err(Error::new(
                ErrorKind::Shape,
                format!("{} numbers for an image of shape {shape:?}", numbers.len()),
            )
            .with_cure("give one number for each voxel"));
        }
        let count = Grid::vertex_count_of(shape, &is_periodic);
        if count.is_none_or(|count| count >= u32::MAX as usize) {
            return Err(Error::new(
                ErrorKind::TooLarge,
                format!("an image of shape {shape:?} has too many voxels"),
            )
            .with_cure("take a part of it, or every second voxel along each axis"));
        }
        let construction = ImageConstruction::default();
        Ok(Self { shape: shape.to_vec(), numbers, construction, is_superlevel: false, is_periodic })
    }

    /// What voxels are.
    ///
    /// # Examples
    /// See [`ImageFiltration`].
    #[must_use]
    pub fn construction(mut self, construction: ImageConstruction) -> Self {
        self.construction = construction;
        self
    }

    /// Whether it grows by superlevel sets, from high numbers to low ones, instead of sublevel sets.
    ///
    /// # Examples
    /// ```
    /// use coface_topology::{Coefficients, ImageFiltration};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let image = ImageFiltration::new(&[4], [0.0, 5.0, 1.0, 2.0])?.superlevel(true);
    /// let diagram = image.persistence(Coefficients::Modulo(2))?;
    /// assert_eq!((diagram.pairs()[1].birth(), diagram.pairs()[1].death()), (2.0, Some(1.0)));
    /// # Ok(()) }
    /// ```
    #[must_use]
    pub fn superlevel(mut self, is_superlevel: bool) -> Self {
        self.is_superlevel = is_superlevel;
        self
    }

    /// Which axes are periodic, so that their last voxels meet their first. A single voxel meets itself, and goes around a loop.
    ///
    /// # Errors
    /// [`ErrorKind::Shape`] unless there is one truth value for each axis.
    ///
    /// # Examples
    /// ```
    /// use coface_topology::{Coefficients, ImageFiltration};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let torus = ImageFiltration::new(&[2, 3], [0.0; 6])?.periodic(&[true, true])?;
    /// assert_eq!(torus.persistence(Coefficients::Modulo(2))?.betti_numbers(), [1, 2, 1]);
    /// let torus = ImageFiltration::new(&[1, 1], [0.0])?.periodic(&[true, true])?;
    /// assert_eq!(torus.persistence(Coefficients::Modulo(2))?.betti_numbers(), [1, 2, 1]);
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

    /// Lets only the voxels enter for which the mask is true.
    ///
    /// # Errors
    /// [`ErrorKind::Shape`] unless there is one truth value for each voxel.
    ///
    /// # Examples
    /// ```
    /// use coface_topology::{Coefficients, ImageFiltration};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let parts = ImageFiltration::new(&[3], [0.0, 5.0, 1.0])?.mask([true, false, true])?;
    /// assert_eq!(parts.persistence(Coefficients::Modulo(2))?.betti_numbers(), [2, 0]);
    /// # Ok(()) }
    /// ```
    pub fn mask(mut self, is_inside: impl IntoIterator<Item = bool>) -> Result<Self, Error> {
        let mut count = 0;
        for (place, is_inside) in is_inside.into_iter().enumerate() {
            count = place + 1;
            if !is_inside && place < self.numbers.len() {
                self.numbers.remove(place);
            }
        }
        if count != self.numbers.len() {
            return Err(Error::new(
                ErrorKind::Shape,
                format!("the mask has {count} voxels, and the image {}", self.numbers.len()),
            )
            .with_cure("give a mask of the shape of the image"));
        }
        Ok(self)
    }

    /// The bytes that [`Self::persistence`] takes beside the image, but for the critical cells: those of smooth images are few, and white noise
    /// has about 100 bytes of them a voxel.
    ///
    /// # Examples
    /// ```
    /// use coface_topology::ImageFiltration;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let image = ImageFiltration::new(&[10, 10, 10], [0.0; 1000])?;
    /// // 12^3 vertices of 8 cells each.
    /// assert_eq!(image.bytes(), 12 * 12 * 12 * (8 + 8) + 1000 * 16);
    /// # Ok(()) }
    /// ```
    pub fn bytes(&self) -> u64 {
        // A forest and what became of cells.
        let (axes, vertices) = (self.long_axes().0.len(), self.vertex_count());
        vertices.saturating_mul(4 + (1 << axes)).saturating_add(self.bytes_of_ranks())
    }

    /// About how much memory ranks of vertices take: ranks, the order of vertices, and what is held while it is made.
    pub(super) fn bytes_of_ranks(&self) -> u64 {
        let sorting = match self.numbers {
            Numbers::Single(_) => 16,
            Numbers::Double(_) => 24,
        };
        self.vertex_count().saturating_mul(4).saturating_add(sorting * self.numbers.len() as u64)
    }

    /// The number of vertices of the grid.
    pub(super) fn vertex_count(&self) -> u64 {
        let (shape, is_periodic) = self.long_axes();
        Grid::vertex_count_of(&shape, &is_periodic).unwrap_or(usize::MAX) as u64
    }

    /// The axes that are longer than 1, or one of a single voxel with ends if none is.
    fn long_axes(&self) -> (Vec<usize>, Vec<bool>) {
        let axes = self.shape.iter().copied().zip(self.is_periodic.iter().copied());
        let long: (Vec<usize>, Vec<bool>) = axes.filter(|&(length, _)| length != 1).unzip();
        if long.0.is_empty() { (vec![1], vec![false]) } else { long }
    }

    /// The numbers of the axes that are longer than 1. If none is, that of the first one with ends; if all are circles, the first one.
    pub(super) fn long_axis_numbers(&self) -> Vec<usize> {
        let long: Vec<usize> = (0..self.shape.len()).filter(|&axis| self.shape[axis] != 1).collect();
        if !long.is_empty() {
            return long;
        }
        vec![self.is_periodic.iter().position(|is_periodic| !is_periodic).unwrap_or(0)]
    }

    /// The axes that are periodic and have a single voxel.
    pub(super) fn circles(&self) -> Circles {
        Circles::new(&self.shape, &self.is_periodic)
    }

    /// The number of voxels along each axis.
    pub(super) fn lengths(&self) -> &[usize] {
        &self.shape
    }

    /// How many places cubes have along each axis: see [`ImageCycles::doubled_shape`](super::ImageCycles::doubled_shape).
    pub(super) fn doubled_shape(&self) -> Vec<u64> {
        let length = |(axis, &length): (usize, &usize)| {
            let length = length as u64;
            match (self.is_dual(), self.is_periodic[axis]) {
                (_, true) => 2 * length,
                (true, false) => 2 * length + 1,
                (false, false) => (2 * length).saturating_sub(1),
            }
        };
        self.shape.iter().enumerate().map(length).collect()
    }

    /// The persistent homology of all degrees: the pairs that live longer than a moment.
    ///
    /// # Errors
    /// [`ErrorKind::Coefficient`] unless the coefficients are modulo a prime below 2^31; [`ErrorKind::InvalidInput`] for a voxel at infinity where
    /// values come from; [`ErrorKind::TooLarge`] where the free memory would not do.
    ///
    /// # Complexity
    /// Near-linear but for the degrees strictly between 0 and the last one, in which the boundaries of critical cells are reduced: cubic in their
    /// number at worst. Memory: see [`Self::bytes`].
    ///
    /// # References
    /// V. Robins, P. J. Wood, A. P. Sheppard, *Theory and algorithms for constructing discrete Morse complexes from grayscale digital images*
    /// (2011); A. Garin, T. Heiss, K. Maggs, B. Bleile, V. Robins, *Duality in persistent homology of images* (2020); P. Guillou, J. Vidal, J.
    /// Tierny, *Discrete Morse sandwich* (2023). Lower stars are matched by the coreduction of M. Mrozek and B. Batko (2009).
    ///
    /// # Examples
    /// See [`ImageFiltration`].
    pub fn persistence(&self, coefficients: Coefficients) -> Result<ImageDiagram, Error> {
        let prime = prime(coefficients)?;
        self.require_births()?;
        self.require_memory()?;
        let shape = &self.shape;
        let gradient = self.gradient();
        let critical: u64 = gradient.critical.iter().map(|cells| cells.len() as u64).sum();
        memory::require(critical.saturating_mul(48), || {
            format!("persistence of an image of shape {shape:?} with {critical} critical cells")
        })?;
        let classes = match prime {
            2 => Pairing::classes(&Binary, &gradient),
            _ => Pairing::classes(&Odd::new(prime), &gradient),
        };
        let pairs = self.pairs(&gradient, &classes);
        Ok(ImageDiagram { prime, is_falling: self.is_superlevel, shape: self.shape.clone(), pairs })
    }

    /// The value of a voxel.
    ///
    /// # Panics
    /// If there is no voxel of this number.
    ///
    /// # Examples
    /// See [`Self::entrance`].
    pub fn value(&self, voxel: usize) -> f64 {
        self.numbers.at(voxel)
    }

    /// The voxels in the order in which they enter; those that never do are left out. Of voxels with one value those of lower numbers come first in the
    /// V-construction, and last in the T-construction.
    ///
    /// # Complexity
    /// That of sorting them.
    ///
    /// # Examples
    /// ```
    /// use coface_topology::{ImageConstruction, ImageFiltration};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let image = ImageFiltration::new(&[4], [3.0, 1.0, f64::NAN, 1.0])?;
    /// assert_eq!(image.value(0), 3.0);
    /// assert_eq!(image.entrance(), [3, 1, 0]);
    /// assert_eq!(image.construction(ImageConstruction::Vertices).entrance(), [1, 3, 0]);
    /// # Ok(()) }
    /// ```
    pub fn entrance(&self) -> Vec<u32> {
        let mut voxels = self.numbers.order(self.is_superlevel != self.is_dual());
        if self.is_dual() {
            voxels.reverse();
        }
        voxels
    }

    /// The number of the first voxel at infinity where values come from, which has no persistence.
    ///
    /// # Examples
    /// ```
    /// use coface_topology::ImageFiltration;
    /// let image = ImageFiltration::new(&[3], [0.0, f64::NEG_INFINITY, f64::INFINITY])?;
    /// assert_eq!(image.voxel_born_at_infinity(), Some(1));
    /// assert_eq!(image.superlevel(true).voxel_born_at_infinity(), Some(2));
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn voxel_born_at_infinity(&self) -> Option<usize> {
        let first = if self.is_superlevel { f64::INFINITY } else { f64::NEG_INFINITY };
        (0..self.numbers.len()).find(|&place| self.numbers.at(place) == first)
    }

    /// Whether superlevel sets grow.
    pub(super) fn is_falling(&self) -> bool {
        self.is_superlevel
    }

    /// That no voxel is at infinity where values come from.
    pub(super) fn require_births(&self) -> Result<(), Error> {
        let Some(place) = self.voxel_born_at_infinity() else { return Ok(()) };
        Err(Error::invalid(format!(
            "voxel {:?} is at {}, so classes would be born at infinity",
            self.voxel(place),
            self.numbers.at(place)
        ))
        .with_cure("write a finite number there, or NaN if the voxel is outside"))
    }

    /// The place of a voxel along each axis.
    fn voxel(&self, place: usize) -> Vec<usize> {
        let mut rest = place;
        let mut voxel: Vec<usize> = self
            .shape
            .iter()
            .rev()
            .map(|&length| {
                let at = rest % length;
                rest /= length;
                at
            })
            .collect();
        voxel.reverse();
        voxel
    }

    pub(super) fn is_dual(&self) -> bool {
        // Where all axes are circles both constructions have the same cells: one vertex of the grid is enough.
        let is_torus = || self.shape.iter().zip(&self.is_periodic).all(|axis| axis == (&1, &true));
        self.construction == ImageConstruction::TopCells && !is_torus()
    }

    pub(super) fn gradient(&self) -> Gradient {
        let (grid, ranks, vertices) = self.ranked();
        Gradient::new(grid, ranks, vertices, |_| true)
    }

    /// The grid, the rank of each of its vertices, and the vertices by rank.
    pub(super) fn ranked(&self) -> (Grid, Vec<u32>, Vec<u32>) {
        let (shape, is_periodic) = self.long_axes();
        let grid = Grid::new(&shape, &is_periodic);
        let _steps = stage("sorting voxels", 0);
        let mut vertices = self.numbers.order(self.is_superlevel != self.is_dual());
        let mut ranks = vec![if self.is_dual() { OUTSIDE } else { NEVER }; grid.vertex_count()];
        for (rank, vertex) in vertices.iter_mut().enumerate() {
            let place = grid.vertex_of_voxel(*vertex as usize);
            ranks[place] = rank as u32 + 1;
            *vertex = place as u32;
        }
        (grid, ranks, vertices)
    }

    /// That there is memory for the matching of cells.
    pub(super) fn require_memory(&self) -> Result<(), Error> {
        let shape = &self.shape;
        memory::require(self.bytes(), || format!("persistence of an image of shape {shape:?}"))
    }

    /// The classes as those of the image, off the diagonal.
    fn pairs(&self, gradient: &Gradient, classes: &[Vec<Class>]) -> Vec<ImagePair> {
        let _steps = stage("sorting pairs", 0);
        let axes = gradient.grid.axes();
        let voxel = |cell: Cell| gradient.grid.voxel_of_vertex(gradient.vertex(cell.rank()));
        // Rising with the order in which cells enter.
        let moment = |cell: Cell| if self.is_dual() { u32::MAX - cell.rank() } else { cell.rank() };
        let rises = self.circles().rises();
        let mut pairs = Vec::new();
        for (below, classes) in classes.iter().enumerate() {
            for &(birth, death) in classes {
                let (degree, birth, death) = match (self.is_dual(), death) {
                    (false, death) => (below, birth, death),
                    (true, None) => (axes - below, birth, None),
                    (true, Some(death)) => (axes - below - 1, death, Some(birth)),
                };
                let pair = ImagePair {
                    degree,
                    birth: self.numbers.at(voxel(birth)),
                    death: death.map(|death| self.numbers.at(voxel(death))),
                    birth_voxel: voxel(birth),
                    death_voxel: death.map(voxel),
                };
                if pair.death != Some(pair.birth) {
                    let moments = (moment(birth), death.map(moment));
                    pairs.extend(rises.iter().map(|rise| {
                        let pair = ImagePair { degree: degree + rise, ..pair };
                        (pair.degree, moments.0, moments.1, pair)
                    }));
                }
            }
        }
        pairs.par_sort_by_key(|&(degree, birth, death, _)| (degree, birth, death));
        pairs.into_iter().map(|(.., pair)| pair).collect()
    }
}
