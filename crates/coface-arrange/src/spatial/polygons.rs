//! Polygons in space to make an arrangement of.

use super::closed_walks;
use super::exact_polygons::ExactPolygons;
use coface_algebra::RaggedArray;
use coface_algebra::{Error, ErrorKind};
use coface_geometry::Positions;
use coface_geometry::predicates::SpatialPoint;
use std::sync::Arc;

/// Polygons in space, with holes, that belong to one or more inputs.
///
/// A polygon is one or more **walks**, closed lists of points: outer ones run counterclockwise seen from the front of
/// the polygon, holes the other way. An **input** is what a winding number is counted for: a mesh, say.
///
/// # Examples
/// A square with a triangular hole, and the same two walks as two polygons of two inputs:
/// ```
/// use coface_algebra::RaggedArray;
/// use coface_arrange::spatial::SpatialPolygons;
/// use coface_geometry::Positions;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let square = [0., 0., 0., 4., 0., 0., 4., 4., 0., 0., 4., 0.];
/// let triangle = [1., 1., 0., 1., 2., 0., 2., 1., 0.];
/// let positions = Positions::from_flat(3, [&square[..], &triangle].concat())?;
/// let walks = RaggedArray::from_lists([vec![0, 1, 2, 3], vec![4, 5, 6]]);
/// let holed = SpatialPolygons::new(positions.clone(), walks.clone(), vec![0, 0])?;
/// let apart = SpatialPolygons::from_polygons(positions, walks)?.with_inputs(vec![0, 1])?;
/// assert_eq!((holed.polygon_count(), holed.input_count()), (1, 1));
/// assert_eq!((apart.polygon_count(), apart.input_count()), (2, 2));
/// # Ok(()) }
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct SpatialPolygons {
    positions: Positions,
    walks: RaggedArray,
    polygon_of_walk: Vec<u32>,
    input_of_polygon: Vec<u32>,
    input_count: usize,
    /// Polygons that are known exactly, each lot with the number of its first polygon, rising. Their walks are rounded.
    exact: Vec<(u32, Arc<ExactPolygons>)>,
    /// The surface that each polygon is a part of; empty where none is known.
    surface_of_polygon: Vec<u32>,
}

impl SpatialPolygons {
    /// The polygons with these walks: walk i is one of polygon `polygon_of_walk[i]`. All belong to one input.
    ///
    /// # Errors
    /// [`ErrorKind::Shape`] unless points have three coordinates and there is a polygon for each walk and a walk for
    /// each polygon; [`ErrorKind::NotInComplex`] naming a walk with a point that is not there.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_arrange::spatial::SpatialPolygons;
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // A triangle with a triangular hole: two walks of one polygon.
    /// let flat = vec![0., 0., 0., 9., 0., 0., 0., 9., 0., 1., 1., 0., 1., 2., 0., 2., 1., 0.];
    /// let walks = RaggedArray::from_lists([[0, 1, 2], [3, 4, 5]]);
    /// let polygons = SpatialPolygons::new(Positions::from_flat(3, flat)?, walks, vec![0, 0])?;
    /// assert_eq!(polygons.polygon_count(), 1);
    /// # Ok(()) }
    /// ```
    pub fn new(positions: Positions, walks: RaggedArray, polygon_of_walk: Vec<u32>) -> Result<Self, Error> {
        if positions.dimension() != 3 && !positions.is_empty() {
            return Err(Error::new(
                ErrorKind::Shape,
                format!("points with {} coordinates are not points in space", positions.dimension()),
            )
            .with_cure("give three coordinates for each point"));
        }
        let positions = if positions.is_empty() { Positions::from_flat(3, Vec::new())? } else { positions };
        if polygon_of_walk.len() != walks.len() {
            return Err(Error::new(
                ErrorKind::Shape,
                format!("{} walks beside the polygons of {}", walks.len(), polygon_of_walk.len()),
            ));
        }
        let polygon_count = polygon_of_walk.iter().max().map_or(0, |&last| last as usize + 1);
        let mut is_there = vec![false; polygon_count.min(walks.len())];
        for &polygon in &polygon_of_walk {
            if let Some(here) = is_there.get_mut(polygon as usize) {
                *here = true;
            }
        }
        if polygon_count > walks.len() || !is_there.iter().all(|&here| here) {
            return Err(Error::new(ErrorKind::Shape, "there are polygons without walks")
                .with_cure("number the polygons without gaps"));
        }
        let count = positions.len();
        if let Some(bad) = walks.items().iter().position(|&point| point as usize >= count) {
            let walk = (0..walks.len()).find(|&walk| walks.start(walk + 1) > bad).unwrap_or(0);
            return Err(Error::new(
                ErrorKind::NotInComplex,
                format!("walk {walk} runs through v{}, but there are {count} points", walks.items()[bad]),
            ));
        }
        let input_count = usize::from(polygon_count > 0);
        let input_of_polygon = vec![0; polygon_count];
        Ok(Self {
            positions,
            walks,
            polygon_of_walk,
            input_of_polygon,
            input_count,
            exact: Vec::new(),
            surface_of_polygon: Vec::new(),
        })
    }

    /// Polygons without holes, each a walk. All belong to one input.
    ///
    /// # Errors
    /// As [`Self::new`].
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_arrange::spatial::SpatialPolygons;
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let corners = Positions::from_flat(3, vec![0., 0., 0., 1., 0., 0., 0., 1., 0., 0., 0., 1.])?;
    /// let sides = RaggedArray::from_lists([[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]);
    /// let polygons = SpatialPolygons::from_polygons(corners, sides)?;
    /// assert_eq!(polygons.polygon_count(), 4);
    /// # Ok(()) }
    /// ```
    pub fn from_polygons(positions: Positions, polygons: RaggedArray) -> Result<Self, Error> {
        let numbers = (0..polygons.len() as u32).collect();
        Self::new(positions, polygons, numbers)
    }

    /// The same polygons belonging to these inputs.
    ///
    /// # Errors
    /// [`ErrorKind::Shape`] unless there is an input for each polygon.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_arrange::spatial::SpatialPolygons;
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let corners = Positions::from_flat(3, vec![0., 0., 0., 1., 0., 0., 0., 1., 0., 0., 0., 1.])?;
    /// let sides = RaggedArray::from_lists([[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]);
    /// let polygons = SpatialPolygons::from_polygons(corners, sides)?;
    /// let apart = polygons.with_inputs(vec![0, 0, 0, 1])?;
    /// assert_eq!(apart.input_count(), 2);
    /// # Ok(()) }
    /// ```
    pub fn with_inputs(mut self, input_of_polygon: Vec<u32>) -> Result<Self, Error> {
        if input_of_polygon.len() != self.polygon_count() {
            return Err(Error::new(
                ErrorKind::Shape,
                format!("{} inputs are named for {} polygons", input_of_polygon.len(), self.polygon_count()),
            )
            .with_cure("name the input of each polygon"));
        }
        self.input_count = input_of_polygon.iter().max().map_or(0, |&last| last as usize + 1);
        self.input_of_polygon = input_of_polygon;
        Ok(self)
    }

    /// Polygons of one input that are known exactly, in their order, with rounded walks around them.
    ///
    /// # Errors
    /// [`ErrorKind::TooLarge`] for 2^32 or more corners.
    ///
    /// # Examples
    /// ```
    /// use coface_arrange::spatial::{ExactPart, ExactPolygons, SpatialPolygons};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let points = vec![[0., 0., 0.], [3., 0., 0.], [0., 3., 0.]];
    /// let part = ExactPart { polygon: 0, triangle: [0, 1, 2], walks: vec![vec![0, 1, 2]] };
    /// let exact = ExactPolygons::new(points, &[vec![0], vec![1], vec![2]], vec![part], vec![false])?;
    /// let polygons = SpatialPolygons::from_exact(exact.into())?;
    /// assert_eq!((polygons.polygon_count(), polygons.walks().list(0)), (1, &[0, 1, 2][..]));
    /// # Ok(()) }
    /// ```
    pub fn from_exact(exact: Arc<ExactPolygons>) -> Result<Self, Error> {
        let flat = exact.vertex_points().iter().flat_map(SpatialPoint::rounded).collect();
        let mut sides: Vec<Vec<[u32; 2]>> = vec![Vec::new(); exact.shared().len()];
        for part in exact.parts() {
            sides[part.polygon as usize].extend(part.sides());
        }
        let (mut lists, mut polygon_of_walk) = (RaggedArray::new(), Vec::new());
        for (sides, polygon) in sides.iter_mut().zip(0..) {
            sides.sort_unstable();
            let is_outer = |&&[a, b]: &&[u32; 2]| sides.binary_search(&[b, a]).is_err();
            let mut outline: Vec<[u32; 2]> = sides.iter().filter(is_outer).copied().collect();
            let walks = closed_walks(&mut outline);
            polygon_of_walk.extend(walks.iter().map(|_| polygon));
            walks.iter().for_each(|walk| lists.push(walk));
        }
        Self::new(Positions::from_flat(3, flat)?, lists, polygon_of_walk)?.with_exact(0, exact)
    }

    /// The same, where the polygons from `first` on are known exactly: polygon i of `exact` is polygon `first + i`, whose
    /// walks are taken only where rounded coordinates are asked for, as within a tolerance.
    ///
    /// # Errors
    /// [`ErrorKind::Shape`] unless there are as many polygons, and none of them is known exactly already.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_arrange::spatial::{ExactPart, ExactPolygons, SpatialArrangement, SpatialPolygons};
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let points = vec![[0., 0., 0.], [3., 0., 0.], [0., 3., 0.]];
    /// let part = ExactPart { polygon: 0, triangle: [0, 1, 2], walks: vec![vec![0, 1, 2]] };
    /// let exact = ExactPolygons::new(points.clone(), &[vec![0], vec![1], vec![2]], vec![part], vec![false])?;
    /// let rounded = Positions::from_flat(3, points.concat())?;
    /// let polygons = SpatialPolygons::from_polygons(rounded, RaggedArray::from_lists([[0, 1, 2]]))?;
    /// let polygons = polygons.with_exact(0, exact.into())?;
    /// assert_eq!(SpatialArrangement::new(&polygons, &Default::default())?.f_vector(), [3, 3, 1, 0]);
    /// # Ok(()) }
    /// ```
    pub fn with_exact(mut self, first: u32, exact: Arc<ExactPolygons>) -> Result<Self, Error> {
        let known = self.exact.last().map_or(0, |(first, own)| *first as usize + own.shared().len());
        let end = first as usize + exact.shared().len();
        if (first as usize) < known || end > self.polygon_count() {
            return Err(Error::new(
                ErrorKind::Shape,
                format!(
                    "polygons {first} to {end} cannot be exact: there are {}, exact up to {known}",
                    self.polygon_count()
                ),
            ));
        }
        self.exact.push((first, exact));
        Ok(self)
    }

    /// The same where triangles are parts of surfaces that are meant to be flat, as those of a face with holes: the number of the
    /// surface of each polygon, `u32::MAX` for one that is a surface by itself. A tolerance keeps them one face where all of
    /// them are within it of a plane.
    ///
    /// # Errors
    /// [`Shape`](ErrorKind::Shape) unless each polygon has a number.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_arrange::spatial::SpatialPolygons;
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let corners = Positions::from_flat(3, vec![0., 0., 0., 1., 0., 0., 1., 1., 0.01, 0., 1., 0.])?;
    /// let halves = SpatialPolygons::from_polygons(corners, RaggedArray::from_lists([[0, 1, 2], [0, 2, 3]]))?;
    /// assert!(halves.clone().with_surfaces(vec![0]).is_err());
    /// assert_eq!(halves.with_surfaces(vec![0, 0])?.polygon_count(), 2);
    /// # Ok(()) }
    /// ```
    pub fn with_surfaces(mut self, surface_of_polygon: Vec<u32>) -> Result<Self, Error> {
        if surface_of_polygon.len() != self.polygon_count() {
            let (numbers, count) = (surface_of_polygon.len(), self.polygon_count());
            let fault = format!("{numbers} surfaces are named for {count} polygons");
            return Err(Error::new(ErrorKind::Shape, fault).with_cure("name the surface of each polygon"));
        }
        self.surface_of_polygon = surface_of_polygon;
        Ok(self)
    }

    /// The surface that a polygon is a part of with others, if it is known.
    pub(super) fn surface_of(&self, polygon: u32) -> Option<u32> {
        self.surface_of_polygon.get(polygon as usize).copied().filter(|&surface| surface != u32::MAX)
    }

    /// The polygons that are known exactly, each lot with the number of its first polygon, rising.
    pub(super) fn exact(&self) -> &[(u32, Arc<ExactPolygons>)] {
        &self.exact
    }

    /// Whether a polygon is known exactly.
    pub(super) fn is_exact(&self, polygon: u32) -> bool {
        let after = self.exact.partition_point(|own| own.0 <= polygon);
        self.exact[..after]
            .last()
            .is_some_and(|(first, own)| ((polygon - first) as usize) < own.shared().len())
    }

    /// The same polygons on these points.
    pub(super) fn with_points(mut self, points: &[[f64; 3]]) -> Result<Self, Error> {
        self.positions = Positions::from_flat(3, points.as_flattened().to_vec())?;
        self.exact.clear();
        Ok(self)
    }

    /// All polygons of several lots, each with its inputs after those of the ones before.
    ///
    /// # Errors
    /// [`ErrorKind::TooLarge`] beyond 2^32 - 1 points or polygons.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_arrange::spatial::SpatialPolygons;
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let positions = Positions::from_flat(3, vec![0., 0., 0., 1., 0., 0., 0., 1., 0.])?;
    /// let one = SpatialPolygons::from_polygons(positions, RaggedArray::from_lists([[0, 1, 2]]))?;
    /// let two = SpatialPolygons::joined(&[one.clone(), one])?;
    /// assert_eq!(two.input_of_polygon(), [0, 1]);
    /// assert_eq!(two.walks().list(1), [3, 4, 5]);
    /// # Ok(()) }
    /// ```
    pub fn joined(lots: &[Self]) -> Result<Self, Error> {
        let sum = |count: fn(&Self) -> usize| lots.iter().map(count).sum::<usize>();
        if [sum(|lot| lot.positions.len()), sum(|lot| lot.walks.item_count()), sum(|lot| lot.input_count)]
            .iter()
            .any(|&count| u32::try_from(count).is_err())
        {
            return Err(Error::new(ErrorKind::TooLarge, "more than 2^32 - 1 points or sides of polygons"));
        }
        let (mut flat, mut walks) = (Vec::new(), RaggedArray::new());
        let (mut polygon_of_walk, mut input_of_polygon) = (Vec::new(), Vec::new());
        let mut input_count = 0;
        let (mut list, mut exact) = (Vec::new(), Vec::new());
        for lot in lots {
            let (points, polygons) = ((flat.len() / 3) as u32, input_of_polygon.len() as u32);
            flat.extend_from_slice(lot.positions.as_flat());
            for walk in lot.walks.iter() {
                list.clear();
                list.extend(walk.iter().map(|&point| point + points));
                walks.push(&list);
            }
            exact.extend(lot.exact.iter().map(|(first, own)| (first + polygons, Arc::clone(own))));
            polygon_of_walk.extend(lot.polygon_of_walk.iter().map(|&polygon| polygon + polygons));
            input_of_polygon.extend(lot.input_of_polygon.iter().map(|&input| input + input_count));
            input_count += lot.input_count as u32;
        }
        let mut joined = Self::new(Positions::from_flat(3, flat)?, walks, polygon_of_walk)?;
        joined.input_of_polygon = input_of_polygon;
        joined.input_count = input_count as usize;
        joined.exact = exact;
        Ok(joined)
    }

    /// The points that walks run through.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_arrange::spatial::SpatialPolygons;
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let corners = Positions::from_flat(3, vec![0., 0., 0., 1., 0., 0., 0., 1., 0., 0., 0., 1.])?;
    /// let sides = RaggedArray::from_lists([[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]);
    /// let polygons = SpatialPolygons::from_polygons(corners, sides)?;
    /// assert_eq!(polygons.positions().len(), 4);
    /// # Ok(()) }
    /// ```
    pub fn positions(&self) -> &Positions {
        &self.positions
    }

    /// The walks around the polygons.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_arrange::spatial::SpatialPolygons;
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let corners = Positions::from_flat(3, vec![0., 0., 0., 1., 0., 0., 0., 1., 0., 0., 0., 1.])?;
    /// let sides = RaggedArray::from_lists([[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]);
    /// let polygons = SpatialPolygons::from_polygons(corners, sides)?;
    /// assert_eq!(polygons.walks().list(0), [0, 2, 1]);
    /// # Ok(()) }
    /// ```
    pub fn walks(&self) -> &RaggedArray {
        &self.walks
    }

    /// The polygon that each walk belongs to.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_arrange::spatial::SpatialPolygons;
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let corners = Positions::from_flat(3, vec![0., 0., 0., 1., 0., 0., 0., 1., 0., 0., 0., 1.])?;
    /// let sides = RaggedArray::from_lists([[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]);
    /// let polygons = SpatialPolygons::from_polygons(corners, sides)?;
    /// assert_eq!(polygons.polygon_of_walk(), [0, 1, 2, 3]);
    /// # Ok(()) }
    /// ```
    pub fn polygon_of_walk(&self) -> &[u32] {
        &self.polygon_of_walk
    }

    /// The input that each polygon belongs to.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_arrange::spatial::SpatialPolygons;
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let corners = Positions::from_flat(3, vec![0., 0., 0., 1., 0., 0., 0., 1., 0., 0., 0., 1.])?;
    /// let sides = RaggedArray::from_lists([[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]);
    /// let polygons = SpatialPolygons::from_polygons(corners, sides)?;
    /// assert_eq!(polygons.input_of_polygon(), [0; 4]);
    /// # Ok(()) }
    /// ```
    pub fn input_of_polygon(&self) -> &[u32] {
        &self.input_of_polygon
    }

    /// The number of polygons.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_arrange::spatial::SpatialPolygons;
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let corners = Positions::from_flat(3, vec![0., 0., 0., 1., 0., 0., 0., 1., 0., 0., 0., 1.])?;
    /// let sides = RaggedArray::from_lists([[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]);
    /// let polygons = SpatialPolygons::from_polygons(corners, sides)?;
    /// assert_eq!(polygons.polygon_count(), 4);
    /// # Ok(()) }
    /// ```
    pub fn polygon_count(&self) -> usize {
        self.input_of_polygon.len()
    }

    /// The number of inputs, those without polygons included.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_arrange::spatial::SpatialPolygons;
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let corners = Positions::from_flat(3, vec![0., 0., 0., 1., 0., 0., 0., 1., 0., 0., 0., 1.])?;
    /// let sides = RaggedArray::from_lists([[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]);
    /// let polygons = SpatialPolygons::from_polygons(corners, sides)?;
    /// assert_eq!(polygons.input_count(), 1);
    /// # Ok(()) }
    /// ```
    pub fn input_count(&self) -> usize {
        self.input_count
    }
}
