//! Pictures of universal covers.

use super::springs::Springs;
use super::universal_cover::UniversalCover;
use super::{flat, hyperbolic};
use coface_algebra::{Error, ErrorKind, VertexId};
use coface_complexes::surface::GeneralizedMap;

/// The plane that a [`CoverLayout`] is in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum CoverPlane {
    /// The Euclidean plane.
    Flat,
    /// The disk of Poincare: the hyperbolic plane as the inside of the unit circle.
    Hyperbolic,
}

/// A point for each vertex of a [`UniversalCover`], so that deck transformations are isometries.
///
/// Edges are geodesics: straight in the plane, arcs perpendicular to the unit circle in the disk. Floating point; the
/// cover itself never depends on it.
#[derive(Clone, Debug, PartialEq)]
pub struct CoverLayout {
    plane: CoverPlane,
    points: Vec<[f64; 2]>,
}

impl CoverLayout {
    /// The plane that it is in.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::surface::{GeneralizedMap, HalfedgeMesh};
    /// use coface_topology::{CoverExtent, CoverPlane, CutSurface, TreeCotree, UniversalCover};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The torus made of one square.
    /// let torus = GeneralizedMap::new(HalfedgeMesh::from_next(vec![2, 3, 1, 0])?.two_skeleton()?)?;
    /// let cut = CutSurface::new(&torus, &TreeCotree::new(&torus));
    /// // A square of the plane and the four squares around it.
    /// let cover = UniversalCover::new(&torus, &cut, 0, CoverExtent::Radius(1), 1000)?;
    /// let layout = cover.layout(&torus, None)?;
    /// assert_eq!(layout.plane(), CoverPlane::Flat);
    /// # Ok(()) }
    /// ```
    pub fn plane(&self) -> CoverPlane {
        self.plane
    }

    /// The points in the order of the vertices.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::surface::{GeneralizedMap, HalfedgeMesh};
    /// use coface_topology::{CoverExtent, CutSurface, TreeCotree, UniversalCover};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The torus made of one square.
    /// let torus = GeneralizedMap::new(HalfedgeMesh::from_next(vec![2, 3, 1, 0])?.two_skeleton()?)?;
    /// let cut = CutSurface::new(&torus, &TreeCotree::new(&torus));
    /// // A square of the plane and the four squares around it.
    /// let cover = UniversalCover::new(&torus, &cut, 0, CoverExtent::Radius(1), 1000)?;
    /// let layout = cover.layout(&torus, None)?;
    /// assert_eq!(layout.points().len(), 12);
    /// # Ok(()) }
    /// ```
    pub fn points(&self) -> &[[f64; 2]] {
        &self.points
    }

    /// The distance of two vertices in this plane.
    ///
    /// # Panics
    /// If there is no such vertex.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::EdgeId;
    /// use coface_complexes::surface::{GeneralizedMap, HalfedgeMesh};
    /// use coface_topology::{CoverExtent, CutSurface, TreeCotree, UniversalCover};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The torus made of one square.
    /// let torus = GeneralizedMap::new(HalfedgeMesh::from_next(vec![2, 3, 1, 0])?.two_skeleton()?)?;
    /// let cut = CutSurface::new(&torus, &TreeCotree::new(&torus));
    /// // A square of the plane and the four squares around it.
    /// let cover = UniversalCover::new(&torus, &cut, 0, CoverExtent::Radius(1), 1000)?;
    /// let layout = cover.layout(&torus, None)?;
    /// // All four sides of the first square are of one length.
    /// let sides = [0, 1].map(|edge| cover.skeleton().edge(EdgeId::new(edge)));
    /// let [a, b] = sides.map(|[from, to]| layout.distance(from, to));
    /// assert!(a > 0.0 && (a - b).abs() < 1e-9 * a);
    /// # Ok(()) }
    /// ```
    pub fn distance(&self, a: VertexId, b: VertexId) -> f64 {
        let [p, q] = [a, b].map(|vertex| self.points[vertex.index()]);
        let chord = (p[0] - q[0]).hypot(p[1] - q[1]);
        match self.plane {
            CoverPlane::Flat => chord,
            CoverPlane::Hyperbolic => {
                let room = |[x, y]: [f64; 2]| 1.0 - x * x - y * y;
                2.0 * (chord / (room(p) * room(q)).sqrt()).asinh()
            }
        }
    }
}

impl UniversalCover {
    /// A layout in which deck transformations are isometries: in the plane for torus, Klein bottle, annulus and
    /// Moebius band, in the disk of Poincare for closed surfaces of negative Euler characteristic.
    ///
    /// Vertices are placed such that springs along the edges are in balance, with these weights or all alike (W. T.
    /// Tutte, *How to draw a graph*, 1963, and its generalizations to flat and hyperbolic surfaces by Y. Colin de
    /// Verdiere, 1991). On a simplicial surface no face is turned over. In the plane the shape of the lattice is
    /// chosen such that the springs pull alike in all directions; a boundary is straight. In the disk, copies lie as
    /// the tiles around the regular polygon with as many sides as the relator has letters, and angles that add up to
    /// $2 \pi$ at each corner. `map` is the surface that the cover was made of; the domain's boundary is
    /// counterclockwise in copy 0.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`] for other surfaces, which have no such layout here, for another map, and for
    /// weights that are not positive; [`ErrorKind::Shape`] unless there are as many weights as edges of the map;
    /// [`ErrorKind::TooLarge`] if the equations are too many or too badly scaled, and in the disk from genus 61 on.
    ///
    /// # Complexity
    /// One sparse Cholesky factor of as many equations as the surface has vertices for each coordinate in the plane;
    /// in the disk one of twice as many in each of some ten steps of Newton's method. Then linear in the vertices of
    /// the cover.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::VertexId;
    /// use coface_complexes::known_spaces;
    /// use coface_complexes::surface::GeneralizedMap;
    /// use coface_topology::{CoverExtent, CutSurface, TreeCotree, UniversalCover};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let torus = GeneralizedMap::new(known_spaces::torus_grid(&[3, 3])?.freeze().two_skeleton()?)?;
    /// let cut = CutSurface::new(&torus, &TreeCotree::new(&torus));
    /// let cover = UniversalCover::new(&torus, &cut, 0, CoverExtent::Radius(1), 1_000_000)?;
    /// let layout = cover.layout(&torus, None)?;
    /// assert_eq!(layout.points().len(), cover.f_vector()[0]);
    /// # Ok(()) }
    /// ```
    pub fn layout(&self, map: &GeneralizedMap, weights: Option<&[f64]>) -> Result<CoverLayout, Error> {
        let domain = &self.domain;
        let last_edge =
            domain.sides.iter().map(|side| side.edge).chain(domain.inner_edges.iter().copied()).max();
        if last_edge.is_some_and(|edge| edge.index() >= map.f_vector()[1]) {
            return Err(Error::new(
                ErrorKind::InvalidInput,
                "the cover was made of another surface than the one given",
            ));
        }
        let characteristic = domain.euler_characteristic();
        let springs = || Springs::new(map, domain, weights);
        let (plane, points) = match (characteristic, domain.is_closed()) {
            (0, _) => (CoverPlane::Flat, flat::points(self, &springs()?)?),
            (..0, true) => (CoverPlane::Hyperbolic, hyperbolic::points(self, &springs()?)?),
            _ => {
                let kind = if domain.is_closed() { "closed" } else { "bounded" };
                return Err(Error::new(
                    ErrorKind::InvalidInput,
                    format!(
                        "there is no layout of covers of {kind} surfaces with Euler characteristic {characteristic}"
                    ),
                )
                .with_cure("layouts are for characteristic 0, and for closed surfaces below 0"));
            }
        };
        Ok(CoverLayout { plane, points })
    }
}
