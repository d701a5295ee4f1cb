//! The universal cover of a surface.

use super::domain::Domain;
use super::isometry::{Isometry, Point};
use super::springs::Springs;
use crate::curves::CutSurface;
use crate::groups::{Ball, NormalForm, SurfaceGroup};
use coface_algebra::chains::{Cells, ChainComplex, TwoSkeleton};
use coface_algebra::progress::stage;
use coface_algebra::{EdgeId, Error, ErrorKind, FaceId, VertexId};
use coface_algebra::{Integer, RaggedArray, Sign, UnionFind, Word};
use coface_complexes::surface::GeneralizedMap;

/// No copy.
const NONE: u32 = u32::MAX;

/// How much of a universal cover is wanted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CoverExtent {
    /// All copies that are reached by at most so many letters.
    Radius(usize),
    /// So many copies, the nearest first; all of a finite cover that has fewer.
    Copies(usize),
}

/// Part of the universal cover of a component of a surface: copies of its fundamental domain, glued.
///
/// # Conventions
/// Copies are numbered in the shortlex order of their words in the letters; copy 0 is the unit. Face f of the cover
/// is face f mod n of the component in copy f / n, for a component with n faces. Edges run as the edges below them.
/// Vertices, edges and faces of copy 0 come first.
///
/// # Examples
/// The torus with 7 vertices. Around the first copy there are 4 others, and the plane has no hole:
/// ```
/// use coface_complexes::known_spaces;
/// use coface_complexes::surface::GeneralizedMap;
/// use coface_topology::{CoverExtent, CutSurface, TreeCotree, UniversalCover};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let torus = GeneralizedMap::new(known_spaces::cyclic_torus(2)?.freeze().two_skeleton()?)?;
/// let cut = CutSurface::new(&torus, &TreeCotree::new(&torus));
/// let cover = UniversalCover::new(&torus, &cut, 0, CoverExtent::Radius(2), 1_000_000)?;
/// assert_eq!(cover.sphere_sizes(), [1, 4, 8]);
/// assert_eq!(cover.f_vector()[2], 13 * 14);
/// assert_eq!(cover.euler_characteristic(), 1);
/// # Ok(()) }
/// ```
#[derive(Clone, Debug)]
pub struct UniversalCover {
    pub(super) domain: Domain,
    ball: Ball,
    skeleton: TwoSkeleton,
    vertex_sources: Vec<VertexId>,
    /// The first copy with each vertex, and its position on the boundary of the domain.
    vertex_corners: Vec<[u32; 2]>,
    edge_sources: Vec<EdgeId>,
    is_complete: bool,
}

/// The cells are those of [`UniversalCover::skeleton`].
impl Cells for UniversalCover {
    fn chain_complex(&self) -> Result<ChainComplex, Error> {
        self.skeleton.chain_complex()
    }

    fn two_skeleton(&self) -> Result<TwoSkeleton, Error> {
        Ok(self.skeleton.clone())
    }

    fn cell_vertices(&self, degree: usize) -> Result<RaggedArray, Error> {
        self.skeleton.cell_vertices(degree)
    }

    fn f_vector(&self) -> Result<Vec<usize>, Error> {
        Ok(self.skeleton.f_vector())
    }
}

impl UniversalCover {
    /// A limit for the number of cells that suits most machines: some gigabytes.
    pub const MOST_CELLS: usize = 100_000_000;

    /// The part of the universal cover of a component that is asked for.
    ///
    /// # Errors
    /// [`ErrorKind::NotInComplex`] if there is no such component; [`ErrorKind::InvalidInput`] for no copies at all, and
    /// for more copies than a finite cover has: a sphere has 1 copy, a projective plane 2. A radius has no such bound.
    /// [`ErrorKind::TooLarge`] if there would be more than `most_cells` cells, with the number of copies that it takes;
    /// nothing is built then.
    ///
    /// # Complexity
    /// Near-linear in the number of cells of the cover, about 12 bytes a side of a face and 30 a vertex or edge; the
    /// copies take $O(m n^2)$ for m copies and n generators.
    ///
    /// # References
    /// H. Seifert, W. Threlfall, *Lehrbuch der Topologie* (1934), chapter 8.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::known_spaces;
    /// use coface_complexes::surface::GeneralizedMap;
    /// use coface_topology::{CoverExtent, CutSurface, TreeCotree, UniversalCover};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let plane = GeneralizedMap::new(known_spaces::projective_plane()?.freeze().two_skeleton()?)?;
    /// let cut = CutSurface::new(&plane, &TreeCotree::new(&plane));
    /// let sphere = UniversalCover::new(&plane, &cut, 0, CoverExtent::Copies(2), 1000)?;
    /// assert_eq!(sphere.f_vector(), [12, 30, 20]);
    /// assert_eq!(sphere.euler_characteristic(), 2);
    /// // More than the whole cover is the whole cover.
    /// for extent in [CoverExtent::Copies(5), CoverExtent::Radius(5)] {
    ///     assert!(UniversalCover::new(&plane, &cut, 0, extent, 1000)?.is_complete());
    /// }
    /// # Ok(()) }
    /// ```
    pub fn new(
        map: &GeneralizedMap,
        cut: &CutSurface,
        component: usize,
        extent: CoverExtent,
        most_cells: usize,
    ) -> Result<Self, Error> {
        let domain = Domain::new(map, cut, component)?;
        let copies = copy_count(&domain, extent, most_cells)?;
        let letters = domain.letters.iter();
        let generators: Vec<Word> = letters
            .map(|&position| domain.sides[position as usize].crossing)
            .map(|crossing| domain.crossings[crossing as usize].clone())
            .collect();
        let ball = Ball::of_generators(&domain.group, &generators, copies);
        let is_complete = domain.group.order() == Some(copies);
        Glued::new(map, cut, &domain, &ball)?.into_cover(domain, ball, is_complete)
    }

    /// The vertices, edges and faces. Give it to [`GeneralizedMap::new`] to walk on it.
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
    /// assert_eq!(cover.skeleton().face_count(), 5);
    /// # Ok(()) }
    /// ```
    pub fn skeleton(&self) -> &TwoSkeleton {
        &self.skeleton
    }

    /// The numbers of vertices, edges and faces.
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
    /// assert_eq!(cover.f_vector(), [12, 16, 5]);
    /// # Ok(()) }
    /// ```
    pub fn f_vector(&self) -> Vec<usize> {
        self.skeleton.f_vector()
    }

    /// Vertices minus edges plus faces: 2 for the whole cover of a sphere or projective plane, else 1, a disk.
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
    /// assert_eq!(cover.euler_characteristic(), 1);
    /// # Ok(()) }
    /// ```
    pub fn euler_characteristic(&self) -> i64 {
        let skeleton = &self.skeleton;
        skeleton.vertex_count() as i64 - skeleton.edge_count() as i64 + skeleton.face_count() as i64
    }

    /// The fundamental group of the component. Its generators are the loops of the fundamental domain.
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
    /// assert_eq!(cover.group().name().to_string(), "Z^2");
    /// # Ok(()) }
    /// ```
    pub fn group(&self) -> &SurfaceGroup {
        &self.domain.group
    }

    /// Whether this is the whole cover.
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
    /// assert!(!cover.is_complete(), "the plane goes on");
    /// # Ok(()) }
    /// ```
    pub fn is_complete(&self) -> bool {
        self.is_complete
    }

    /// The number of copies.
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
    /// assert_eq!(cover.copy_count(), 5);
    /// # Ok(()) }
    /// ```
    pub fn copy_count(&self) -> usize {
        self.ball.len()
    }

    /// The number of copies for each length of their words; the last sphere need not be whole.
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
    /// assert_eq!(cover.sphere_sizes(), [1, 4]);
    /// # Ok(()) }
    /// ```
    pub fn sphere_sizes(&self) -> Vec<usize> {
        self.ball.sphere_sizes()
    }

    /// The edge of the surface that each letter crosses: letter i is entry i - 1.
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
    /// assert_eq!(cover.letters().len(), 2);
    /// # Ok(()) }
    /// ```
    pub fn letters(&self) -> Vec<EdgeId> {
        self.domain.letters.iter().map(|&position| self.domain.sides[position as usize].edge).collect()
    }

    /// The shortest word of a copy in the letters: the edges that a path from copy 0 crosses.
    ///
    /// # Panics
    /// If there is no such copy. Likewise the functions that follow panic where there is no such cell.
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
    /// assert!(cover.copy_word(0).is_empty());
    /// assert_eq!(cover.copy_word(1).letters(), [1]);
    /// # Ok(()) }
    /// ```
    pub fn copy_word(&self, copy: usize) -> Word {
        self.ball.word(copy)
    }

    /// The element of the fundamental group that a copy belongs to: its deck transformation takes copy 0 there.
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
    /// assert!(cover.copy_element(0).is_identity());
    /// # Ok(()) }
    /// ```
    pub fn copy_element(&self, copy: usize) -> &NormalForm {
        &self.ball.elements()[copy]
    }

    /// The copies with their words and elements.
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
    /// assert_eq!(cover.copies().len(), 5);
    /// # Ok(()) }
    /// ```
    pub fn copies(&self) -> &Ball {
        &self.ball
    }

    /// The vertex of the surface below a vertex of the cover.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::VertexId;
    /// use coface_complexes::surface::{GeneralizedMap, HalfedgeMesh};
    /// use coface_topology::{CoverExtent, CutSurface, TreeCotree, UniversalCover};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The torus made of one square.
    /// let torus = GeneralizedMap::new(HalfedgeMesh::from_next(vec![2, 3, 1, 0])?.two_skeleton()?)?;
    /// let cut = CutSurface::new(&torus, &TreeCotree::new(&torus));
    /// // A square of the plane and the four squares around it.
    /// let cover = UniversalCover::new(&torus, &cut, 0, CoverExtent::Radius(1), 1000)?;
    /// assert_eq!(cover.vertex_below(VertexId::new(11)), VertexId::new(0));
    /// # Ok(()) }
    /// ```
    pub fn vertex_below(&self, vertex: VertexId) -> VertexId {
        self.vertex_sources[vertex.index()]
    }

    /// The first copy that a vertex is in.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::VertexId;
    /// use coface_complexes::surface::{GeneralizedMap, HalfedgeMesh};
    /// use coface_topology::{CoverExtent, CutSurface, TreeCotree, UniversalCover};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The torus made of one square.
    /// let torus = GeneralizedMap::new(HalfedgeMesh::from_next(vec![2, 3, 1, 0])?.two_skeleton()?)?;
    /// let cut = CutSurface::new(&torus, &TreeCotree::new(&torus));
    /// // A square of the plane and the four squares around it.
    /// let cover = UniversalCover::new(&torus, &cut, 0, CoverExtent::Radius(1), 1000)?;
    /// assert_eq!(cover.vertex_copy(VertexId::new(0)), 0);
    /// # Ok(()) }
    /// ```
    pub fn vertex_copy(&self, vertex: VertexId) -> usize {
        self.vertex_corners[vertex.index()][0] as usize
    }

    /// The deck transformation that takes to a vertex the one above the same vertex of the surface that is joined to
    /// the base vertex of copy 0 by the spanning tree of the surface.
    ///
    /// # Complexity
    /// That of one product in the group.
    pub fn vertex_element(&self, vertex: VertexId) -> NormalForm {
        let [copy, position] = self.vertex_corners[vertex.index()].map(|number| number as usize);
        self.domain.group.times_word(&self.ball.elements()[copy], &self.prefix(position))
    }

    fn prefix(&self, position: usize) -> Word {
        if self.domain.sides.is_empty() { Word::new() } else { self.domain.prefix(position) }
    }

    /// The position on the boundary of the domain where a vertex is in its first copy.
    pub fn vertex_position(&self, vertex: VertexId) -> usize {
        self.vertex_corners[vertex.index()][1] as usize
    }

    /// The edge of the surface below an edge of the cover.
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
    /// let above = (0..16).filter(|&edge| cover.edge_below(EdgeId::new(edge)) == EdgeId::new(0));
    /// assert_eq!(above.count(), 8);
    /// # Ok(()) }
    /// ```
    pub fn edge_below(&self, edge: EdgeId) -> EdgeId {
        self.edge_sources[edge.index()]
    }

    /// The face of the surface below a face of the cover.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::FaceId;
    /// use coface_complexes::surface::{GeneralizedMap, HalfedgeMesh};
    /// use coface_topology::{CoverExtent, CutSurface, TreeCotree, UniversalCover};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The torus made of one square.
    /// let torus = GeneralizedMap::new(HalfedgeMesh::from_next(vec![2, 3, 1, 0])?.two_skeleton()?)?;
    /// let cut = CutSurface::new(&torus, &TreeCotree::new(&torus));
    /// // A square of the plane and the four squares around it.
    /// let cover = UniversalCover::new(&torus, &cut, 0, CoverExtent::Radius(1), 1000)?;
    /// assert_eq!(cover.face_below(FaceId::new(4)), FaceId::new(0));
    /// # Ok(()) }
    /// ```
    pub fn face_below(&self, face: FaceId) -> FaceId {
        self.domain.faces[face.index() % self.domain.faces.len()]
    }

    /// The copy that a face is in.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::FaceId;
    /// use coface_complexes::surface::{GeneralizedMap, HalfedgeMesh};
    /// use coface_topology::{CoverExtent, CutSurface, TreeCotree, UniversalCover};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The torus made of one square.
    /// let torus = GeneralizedMap::new(HalfedgeMesh::from_next(vec![2, 3, 1, 0])?.two_skeleton()?)?;
    /// let cut = CutSurface::new(&torus, &TreeCotree::new(&torus));
    /// // A square of the plane and the four squares around it.
    /// let cover = UniversalCover::new(&torus, &cut, 0, CoverExtent::Radius(1), 1000)?;
    /// assert_eq!(cover.face_copy(FaceId::new(4)), 4);
    /// # Ok(()) }
    /// ```
    pub fn face_copy(&self, face: FaceId) -> usize {
        face.index() / self.domain.faces.len()
    }

    /// The points of all vertices: those of the surface's vertices, moved by the isometries of prefix and copy, drawn.
    pub(super) fn points_of(
        &self,
        copies: &[Isometry],
        prefixes: &[Isometry],
        place: impl Fn(usize) -> Point,
        springs: &Springs,
        draw: impl Fn(Point) -> [f64; 2],
    ) -> Vec<[f64; 2]> {
        let corners: Vec<Point> = (springs.at_positions.iter().zip(&self.domain.prefixes))
            .map(|(&vertex, &prefix)| prefixes[prefix as usize].apply(place(vertex as usize)))
            .collect();
        let points = self.vertex_corners.iter();
        points
            .map(|&[copy, position]| draw(copies[copy as usize].apply(corners[position as usize])))
            .collect()
    }

    /// The vertices around each face.
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
    /// assert_eq!(cover.polygons().iter().map(<[u32]>::len).collect::<Vec<_>>(), [4; 5]);
    /// # Ok(()) }
    /// ```
    pub fn polygons(&self) -> RaggedArray {
        let ends = self.skeleton.edge_ends();
        let faces = self.skeleton.faces();
        let mut polygons = faces.clone();
        for corner in polygons.items_mut() {
            *corner = ends[*corner as usize];
        }
        polygons
    }
}

/// The number of copies, if they can be had.
fn copy_count(domain: &Domain, extent: CoverExtent, most_cells: usize) -> Result<usize, Error> {
    let group = &domain.group;
    let most = (most_cells / domain.cell_count().max(1)).min(NONE as usize - 1);
    let too_large = |copies: String| {
        Error::new(
            ErrorKind::TooLarge,
            format!(
                "the universal cover would have {copies} copies of a domain with {} cells; the limit is {most_cells} \
                 cells, which is {most} copies",
                domain.cell_count()
            ),
        )
        .with_cure("ask for a smaller radius or fewer copies, or raise the limit")
    };
    match extent {
        CoverExtent::Copies(0) => {
            Err(Error::invalid("a cover of 0 copies was asked for").with_cure("ask for at least 1 copy"))
        }
        CoverExtent::Copies(count) => match group.order().map_or(count, |order| count.min(order)) {
            count if count > most => Err(too_large(count.to_string())),
            count => Ok(count),
        },
        CoverExtent::Radius(radius) => group.ball_size(radius, most).ok_or_else(|| {
            too_large(if radius <= 1000 {
                let sizes = group.sphere_sizes(radius);
                sizes.into_iter().fold(Integer::ZERO, |sum, size| sum + size).to_string()
            } else {
                format!("more than {most}")
            })
        }),
    }
}

/// The cells of the cover while it is glued.
struct Glued {
    /// Vertices of all copies by copy and position, with their classes.
    corners: UnionFind,
    /// The edge at each position of each copy.
    outer_edges: Vec<u32>,
    /// The first inner edge of each copy.
    inner_starts: Vec<u32>,
    edge_sources: Vec<EdgeId>,
    /// The ends of edges as corners.
    ends: Vec<u32>,
    faces: RaggedArray,
}

impl Glued {
    fn new(map: &GeneralizedMap, cut: &CutSurface, domain: &Domain, ball: &Ball) -> Result<Self, Error> {
        let (copies, width) = (ball.len(), domain.vertices.len());
        let corner_count = copies.checked_mul(width).filter(|&count| count < 1 << 31);
        let Some(corner_count) = corner_count else {
            return Err(Error::new(
                ErrorKind::TooLarge,
                format!("{copies} copies of a domain with {width} corners; the limit is 2^31 corners"),
            ));
        };
        let mut glued = Self {
            corners: UnionFind::new(corner_count),
            outer_edges: Vec::with_capacity(copies * domain.sides.len()),
            inner_starts: Vec::with_capacity(copies),
            edge_sources: Vec::new(),
            ends: Vec::new(),
            faces: RaggedArray::new(),
        };
        // Crossings that are letters are looked up, the others multiplied.
        let mut letter_of_crossing = vec![0; domain.crossings.len()];
        for (letter, &position) in (1..).zip(&domain.letters) {
            let side = domain.sides[position as usize];
            let mate = side.mate.expect("a letter crosses an edge inside the surface");
            letter_of_crossing[domain.sides[mate as usize].crossing as usize] = -letter;
            letter_of_crossing[side.crossing as usize] = letter;
        }
        let crossings: Vec<NormalForm> =
            domain.crossings.iter().map(|word| domain.group.normal_form(word)).collect();
        let mut neighbors = vec![NONE; crossings.len()];
        let steps = stage("finding neighbors of copies", copies);
        for copy in steps.each(0..copies) {
            for ((neighbor, crossing), &letter) in
                neighbors.iter_mut().zip(&crossings).zip(&letter_of_crossing)
            {
                let found = if letter != 0 {
                    ball.neighbor(copy, letter)
                } else {
                    ball.number(&domain.group.product(&ball.elements()[copy], crossing))
                };
                *neighbor = found.map_or(NONE, |found| found as u32);
            }
            glued.add_copy(domain, copy, &neighbors);
            glued.add_faces(map, cut, domain, copy);
        }
        Ok(glued)
    }

    fn add_edge(&mut self, source: EdgeId, ends: [usize; 2]) -> u32 {
        let edge = self.edge_sources.len() as u32;
        self.edge_sources.push(source);
        self.ends.extend(ends.map(|end| end as u32));
        edge
    }

    /// Adds the edges of a copy and glues them to the copies before it.
    fn add_copy(&mut self, domain: &Domain, copy: usize, neighbors: &[u32]) {
        let (count, width) = (domain.sides.len(), domain.vertices.len());
        for (position, side) in domain.sides.iter().enumerate() {
            let [start, end] = [position, domain.after(position)].map(|at| copy * width + at);
            let found = side.mate.map(|mate| (neighbors[side.crossing as usize], mate as usize));
            let is_there =
                |&(other, mate): &(u32, usize)| other != NONE && (other as usize, mate) < (copy, position);
            let edge = match found.filter(is_there) {
                Some((other, mate)) => {
                    let other = other as usize;
                    let [at_start, at_end] = domain.mate_corners(position, mate);
                    self.corners.unite(start as u32, (other * width + at_start) as u32);
                    self.corners.unite(end as u32, (other * width + at_end) as u32);
                    self.outer_edges[other * count + mate]
                }
                None if side.direction == Sign::Plus => self.add_edge(side.edge, [start, end]),
                None => self.add_edge(side.edge, [end, start]),
            };
            self.outer_edges.push(edge);
        }
        self.inner_starts.push(self.edge_sources.len() as u32);
        for (&edge, ends) in domain.inner_edges.iter().zip(&domain.inner_ends) {
            self.add_edge(edge, ends.map(|end| copy * width + end as usize));
        }
    }

    /// Adds the faces of a copy, whose edges are there.
    fn add_faces(&mut self, map: &GeneralizedMap, cut: &CutSurface, domain: &Domain, copy: usize) {
        let mut rim = Vec::new();
        for &face in &domain.faces {
            for side in map.sides_of(face) {
                let edge = match cut.side_position(side) {
                    Some(position) => self.outer_edges[copy * domain.sides.len() + position],
                    None => {
                        let inner = domain.inner_numbers[map.edge(side).index()];
                        self.inner_starts[copy] + inner
                    }
                };
                rim.push(2 * edge + (map.step(side) & 1));
            }
            self.faces.push(&rim);
            rim.clear();
        }
    }

    fn into_cover(mut self, domain: Domain, ball: Ball, is_complete: bool) -> Result<UniversalCover, Error> {
        let width = domain.vertices.len() as u32;
        let numbers = self.corners.class_numbers();
        let mut vertex_corners: Vec<[u32; 2]> = Vec::with_capacity(self.corners.class_count());
        for (corner, &number) in (0..).zip(&numbers) {
            if number as usize == vertex_corners.len() {
                vertex_corners.push([corner / width, corner % width]);
            }
        }
        let vertex_sources =
            vertex_corners.iter().map(|&[_, position]| domain.vertices[position as usize]).collect();
        for end in &mut self.ends {
            *end = numbers[*end as usize];
        }
        let skeleton = TwoSkeleton::new(vertex_corners.len(), self.ends, self.faces)?;
        let edge_sources = self.edge_sources;
        Ok(UniversalCover {
            domain,
            ball,
            skeleton,
            vertex_sources,
            vertex_corners,
            edge_sources,
            is_complete,
        })
    }
}
