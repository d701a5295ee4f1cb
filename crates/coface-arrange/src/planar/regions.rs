//! Arrangements of the rims of regions: how often each region winds around each face.

use super::PlanarArrangement;
use super::windings::Windings;
use coface_algebra::RaggedArray;
use coface_algebra::{Error, ErrorKind, FaceId};
use coface_geometry::Positions;

/// The arrangement of closed rings, with the winding number of every region around every face.
///
/// # Examples
/// Two squares that overlap in a quarter: inclusion and exclusion.
/// ```
/// use coface_algebra::RaggedArray;
/// use coface_arrange::planar::PlanarRegions;
/// use coface_geometry::Positions;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let points = Positions::from_flat(2, vec![0., 0., 2., 0., 2., 2., 0., 2., 1., 1., 3., 1., 3., 3., 1., 3.])?;
/// let rings = RaggedArray::from_lists([[0, 1, 2, 3], [7, 6, 5, 4]]);
/// let regions = PlanarRegions::new(&points, &rings, &[0, 1])?;
/// let both = regions.faces_where(|winding| winding.len() == 2);
/// assert_eq!(both.len(), 1);
/// // The second square runs clockwise: it winds minus once around what is in it.
/// assert_eq!(regions.winding_numbers(both[0]), [(0, 1), (1, -1)]);
/// let areas = regions.arrangement().areas();
/// assert_eq!((areas[both[0].index()], areas.iter().sum()), (1.0, 7.0));
/// # Ok(()) }
/// ```
#[derive(Clone, Debug)]
pub struct PlanarRegions {
    arrangement: PlanarArrangement,
    region_count: usize,
    windings: Windings,
}

impl PlanarRegions {
    /// The arrangement of rings. Each ring runs through its points and back to the first; `regions[i]` is the region
    /// that ring i belongs to. A ring winds once around what it has on its left: outer rings run counterclockwise,
    /// holes clockwise, or the parity of the winding number tells what is inside.
    ///
    /// # Errors
    /// [`ErrorKind::Shape`] unless there is one region for each ring; else as [`PlanarArrangement::new`].
    ///
    /// # Complexity
    /// That of the arrangement, and linear in the lengths of the lists of winding numbers.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_arrange::planar::PlanarRegions;
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let corners = Positions::from_flat(2, vec![0., 0., 1., 0., 0., 1.])?;
    /// let regions = PlanarRegions::new(&corners, &RaggedArray::from_lists([[0, 1, 2]]), &[0])?;
    /// assert_eq!(regions.arrangement().f_vector(), [3, 3, 1]);
    /// # Ok(()) }
    /// ```
    pub fn new(positions: &Positions, rings: &RaggedArray, regions: &[u32]) -> Result<Self, Error> {
        if rings.len() != regions.len() {
            return Err(Error::new(
                ErrorKind::Shape,
                format!("{} regions are named for {} rings", regions.len(), rings.len()),
            )
            .with_cure("name the region of each ring"));
        }
        let mut sides = Vec::with_capacity(rings.item_count());
        let mut region_of_side = Vec::with_capacity(rings.item_count());
        for (ring, &region) in rings.iter().zip(regions) {
            for (i, &from) in ring.iter().enumerate() {
                sides.push([from, ring[(i + 1) % ring.len()]]);
                region_of_side.push(region);
            }
        }
        let arrangement = PlanarArrangement::new(positions, &sides)?;
        // What is left of a side winds this much more than what is right of it.
        let step = |halfedge: u32, list: &mut Vec<(u32, i32)>| {
            let sign = if halfedge.is_multiple_of(2) { 1 } else { -1 };
            for &side in arrangement.segments_of_edge.list(halfedge as usize / 2) {
                let [a, b] = sides[side as usize].map(|point| arrangement.vertex_of_point[point as usize]);
                list.push((region_of_side[side as usize], if a < b { sign } else { -sign }));
            }
        };
        let windings = Windings::new(&arrangement.orbits, &arrangement.faces, step)?;
        let region_count = regions.iter().max().map_or(0, |&last| last as usize + 1);
        Ok(Self { arrangement, region_count, windings })
    }

    /// The arrangement of all sides of all rings, one segment a side, ring after ring.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_arrange::planar::PlanarRegions;
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // Two squares that overlap in a quarter.
    /// let points = Positions::from_flat(2, vec![0., 0., 2., 0., 2., 2., 0., 2., 1., 1., 3., 1., 3., 3., 1., 3.])?;
    /// let rings = RaggedArray::from_lists([[0, 1, 2, 3], [4, 5, 6, 7]]);
    /// let regions = PlanarRegions::new(&points, &rings, &[0, 1])?;
    /// assert_eq!(regions.arrangement().f_vector(), [10, 12, 3]);
    /// # Ok(()) }
    /// ```
    pub fn arrangement(&self) -> &PlanarArrangement {
        &self.arrangement
    }

    /// One more than the highest region that a ring belongs to.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_arrange::planar::PlanarRegions;
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // Two squares that overlap in a quarter.
    /// let points = Positions::from_flat(2, vec![0., 0., 2., 0., 2., 2., 0., 2., 1., 1., 3., 1., 3., 3., 1., 3.])?;
    /// let rings = RaggedArray::from_lists([[0, 1, 2, 3], [4, 5, 6, 7]]);
    /// let regions = PlanarRegions::new(&points, &rings, &[0, 1])?;
    /// assert_eq!(regions.region_count(), 2);
    /// # Ok(()) }
    /// ```
    pub fn region_count(&self) -> usize {
        self.region_count
    }

    /// The regions that wind around a face, rising, each with its winding number, which is not zero.
    ///
    /// # Panics
    /// If there is no such face.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_arrange::planar::PlanarRegions;
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // Two squares that overlap in a quarter.
    /// let points = Positions::from_flat(2, vec![0., 0., 2., 0., 2., 2., 0., 2., 1., 1., 3., 1., 3., 3., 1., 3.])?;
    /// let rings = RaggedArray::from_lists([[0, 1, 2, 3], [4, 5, 6, 7]]);
    /// let regions = PlanarRegions::new(&points, &rings, &[0, 1])?;
    /// let both = regions.faces_where(|windings| windings.len() == 2)[0];
    /// assert_eq!(regions.winding_numbers(both), [(0, 1), (1, 1)]);
    /// # Ok(()) }
    /// ```
    pub fn winding_numbers(&self, face: FaceId) -> &[(u32, i32)] {
        assert!(
            face.index() < self.arrangement.face_count(),
            "there are {} faces",
            self.arrangement.face_count()
        );
        self.windings.of_face(face.to_u32())
    }

    /// The bounded faces whose winding numbers satisfy a condition: any Boolean formula of the regions.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_arrange::planar::PlanarRegions;
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // Two squares that overlap in a quarter.
    /// let points = Positions::from_flat(2, vec![0., 0., 2., 0., 2., 2., 0., 2., 1., 1., 3., 1., 3., 3., 1., 3.])?;
    /// let rings = RaggedArray::from_lists([[0, 1, 2, 3], [4, 5, 6, 7]]);
    /// let regions = PlanarRegions::new(&points, &rings, &[0, 1])?;
    /// assert_eq!(regions.faces_where(|windings| windings == [(0, 1)]).len(), 1);
    /// # Ok(()) }
    /// ```
    pub fn faces_where(&self, mut condition: impl FnMut(&[(u32, i32)]) -> bool) -> Vec<FaceId> {
        let faces = (0..self.arrangement.face_count()).map(FaceId::new);
        faces.filter(|&face| condition(self.winding_numbers(face))).collect()
    }
}
