//! Triangles cut against each other: the conforming complex of their fragments.

use super::fragments::{Fragmenting, Fragments};
use super::lines::{Lines, OnLines, Support};
use super::meetings::{Meetings, Place};
use super::predicates::CutPredicates;
use super::sheets::Sheets;
use super::triples::triples;
use super::vertices::Vertices;
use crate::spatial::cells::OrderedFaces;
use crate::spatial::{PolygonalComplex, SpatialCells, SpatialPredicates};
use coface_algebra::RaggedArray;
use coface_algebra::progress::{Steps, stage};
use coface_algebra::{Error, ErrorKind, FaceId, VertexId};
use coface_geometry::Positions;
use coface_geometry::predicates::{SpatialPlane, SpatialPoint};
use rayon::prelude::*;
use std::sync::Arc;

/// Bounds on what cutting may do.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct CutOptions {
    max_cells: Option<usize>,
}

impl CutOptions {
    /// No bound but what 32 bits number.
    ///
    /// # Examples
    /// ```
    /// use coface_arrange::spatial::CutOptions;
    /// assert_eq!(CutOptions::new(), CutOptions::default());
    /// ```
    pub const fn new() -> Self {
        Self { max_cells: None }
    }

    /// Refuses more vertices, edges and faces together than this. The places where triangles meet count while they are
    /// found, so that memory stays in proportion.
    ///
    /// # Examples
    /// A triangle has seven cells.
    /// ```
    /// use coface_arrange::spatial::{CutOptions, CutTriangles};
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let corners = Positions::from_flat(3, vec![0., 0., 0., 1., 0., 0., 0., 1., 0.])?;
    /// let cut = |most| CutTriangles::new(&corners, &[[0, 1, 2]], &CutOptions::new().max_cells(most));
    /// assert!(cut(7).is_ok() && cut(6).is_err());
    /// # Ok(()) }
    /// ```
    #[must_use]
    pub fn max_cells(mut self, most: impl Into<Option<usize>>) -> Self {
        self.max_cells = most.into();
        self
    }
}

/// What a vertex of cut triangles is. Numbers are those of the points and triangles of the input; equal points, and
/// triangles with the same corners, go by the first of them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SpatialVertexSource {
    /// A point of the input.
    Given(usize),
    /// The crossing of two edges of triangles, each by its ends.
    Edges([[usize; 2]; 2]),
    /// The point where an edge, given by its ends, goes through a triangle.
    EdgeAndTriangle([usize; 2], usize),
    /// The point that three triangles have in common.
    Triangles([usize; 3]),
}

/// The conforming complex that triangles of space become when they are cut against each other, exactly.
///
/// Triangles may cross, touch, overlap in a plane, be there twice or have no area: those without area are left out and
/// named. Faces are flat polygons, with holes and slits where need be; faces meet only in common edges and vertices. A
/// vertex may also lie inside a face of other triangles, where these touch it in a single point.
///
/// # Conventions
/// Vertices are the points of the input by their first occurrences, points that no triangle has included, then new ones
/// by rising rounded coordinates. Edges rise by their ends and point from the lower to the higher one. Faces are in the
/// order of their first triangles, and run as these do.
///
/// # Algorithm
/// All decisions are signs about given points, or about points that are known by the lines and planes that meet there.
/// Pairs of triangles near each other are found by a tree of boxes. The segment that two triangles have in common has
/// its ends where an edge of one meets the other; where such segments cross inside a triangle, three triangles meet.
/// Points are one if they are equal. A point inside two triangles is on their segment, so what lies along an edge or a
/// segment is known without further decisions. Directions around a point in a triangle are compared by determinants of
/// normals.
///
/// # References
/// Q. Zhou, E. Grinspun, D. Zorin, A. Jacobson, *Mesh arrangements for solid geometry* (2016); M. Attene, *Indirect
/// predicates for geometric constructions* (2020).
///
/// # Examples
/// Two triangles that cross. Each has a cut that ends inside the other, a slit:
/// ```
/// use coface_arrange::spatial::{CutOptions, CutTriangles};
/// use coface_geometry::Positions;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let points = vec![0., 0., 0., 4., 0., 0., 0., 4., 0., 1., 1., -1., 1., 1., 1., 9., 9., 0.];
/// let positions = Positions::from_flat(3, points)?;
/// let cut = CutTriangles::new(&positions, &[[0, 1, 2], [3, 4, 5]], &CutOptions::default())?;
/// // New are (1, 1, 0), and (2, 2, 0) on the edge of the first triangle.
/// assert_eq!(cut.complex().f_vector(), [8, 9, 2]);
/// assert_eq!(cut.positions().point(coface_algebra::VertexId::new(7)), [2.0, 2.0, 0.0]);
/// # Ok(()) }
/// ```
#[derive(Clone, Debug)]
pub struct CutTriangles {
    sheets: Sheets,
    vertices: Vertices,
    positions: Positions,
    pub(super) complex: Arc<PolygonalComplex>,
    /// The sheet of each face, or the first of those that overlap there.
    pub(super) sheet_of_face: Vec<u32>,
    pub(super) triangles_of_face: RaggedArray,
    pub(super) supports: Vec<Support>,
    /// The vertices inside a face that no edge of it ends at, as pairs of face and vertex, rising.
    pub(super) points_in_faces: Vec<[u32; 2]>,
}

impl CutTriangles {
    /// Cuts triangles against each other.
    ///
    /// # Errors
    /// [`ErrorKind::Shape`] unless positions have three coordinates; [`ErrorKind::NotInComplex`] naming a triangle with
    /// a corner that is not there; [`ErrorKind::TooLarge`] when the result would have more cells than the options
    /// allow, or than 32 bits number.
    ///
    /// # Complexity
    /// $O((n + k) \log (n + k))$ for n triangles and a result of size k where boxes that meet are not many more than
    /// triangles that do; in parallel, with the same result whatever the number of threads.
    ///
    /// # Examples
    /// ```
    /// use coface_arrange::spatial::CutTriangles;
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // Two triangles that cross along a segment from (1, 1, 0) to (2, 2, 0).
    /// let points = vec![0., 0., 0., 4., 0., 0., 0., 4., 0., 1., 1., -1., 1., 1., 1., 9., 9., 0.];
    /// let positions = Positions::from_flat(3, points)?;
    /// let cut = CutTriangles::new(&positions, &[[0, 1, 2], [3, 4, 5]], &Default::default())?;
    /// assert_eq!(cut.complex().f_vector(), [8, 9, 2]);
    /// # Ok(()) }
    /// ```
    pub fn new(positions: &Positions, triangles: &[[u32; 3]], options: &CutOptions) -> Result<Self, Error> {
        check_input(positions, triangles)?;
        let most = options.max_cells.unwrap_or(1 << 29).min(1 << 29);
        let check = |count: usize| check_size(count, most);
        let making = stage("making sheets", 0);
        let (sheets, tree) = Sheets::new(positions, triangles);
        drop(making);
        let meetings = Meetings::new(&sheets, &tree, |_| true, check)?;
        drop(tree);
        let point = |place: &Place| place.point(&sheets);
        let rounding = stage("rounding points", 0);
        let mut points: Vec<SpatialPoint> = meetings.places.par_iter().map(point).collect();
        drop(rounding);
        let triples = triples(&sheets, &meetings, &points, |count| check(meetings.places.len() + count))?;
        let mut places = meetings.places.clone();
        // Places rise: those of three sheets come last.
        places.extend(triples.into_iter().map(Place::Sheets));
        points.par_extend(places[points.len()..].par_iter().map(point));
        let (vertices, vertex_of_place) = Vertices::new(&sheets, &places, &points);
        drop(points);
        check(vertices.count())?;
        let on = OnLines {
            sheets: &sheets,
            vertices: &vertices,
            places: &places,
            vertex_of_place: &vertex_of_place,
        };
        let lines = Lines::new(&on, &meetings);
        check(vertices.count() + lines.ends.len())?;
        let steps = stage("dividing sheets", sheets.count());
        let (supports, faces) = rayon::join(
            || lines.supports(&sheets, &meetings),
            || Faces::new(&Fragmenting::new(on, &lines, &meetings), &meetings.overlapping, &steps),
        );
        drop(steps);
        check(vertices.count() + lines.ends.len() + faces.sides.len())?;
        let mut flat = Vec::with_capacity(3 * vertices.count());
        flat.extend_from_slice(sheets.points.as_flattened());
        flat.extend(vertices.points.iter().flat_map(SpatialPoint::rounded));
        let positions = Positions::from_flat(3, flat)?;
        let Faces { sides, sheet_of, triangles, points: points_in_faces } = faces;
        let complex = PolygonalComplex::from_trusted_parts(vertices.count(), lines.ends, sides);
        Ok(Self {
            sheets,
            vertices,
            positions,
            complex: Arc::new(complex),
            sheet_of_face: sheet_of,
            triangles_of_face: triangles,
            supports,
            points_in_faces,
        })
    }

    /// The vertices, edges and faces.
    ///
    /// # Examples
    /// ```
    /// use coface_arrange::spatial::CutTriangles;
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // Two triangles that cross along a segment from (1, 1, 0) to (2, 2, 0).
    /// let points = vec![0., 0., 0., 4., 0., 0., 0., 4., 0., 1., 1., -1., 1., 1., 1., 9., 9., 0.];
    /// let positions = Positions::from_flat(3, points)?;
    /// let cut = CutTriangles::new(&positions, &[[0, 1, 2], [3, 4, 5]], &Default::default())?;
    /// assert_eq!(cut.complex().f_vector(), [8, 9, 2]);
    /// # Ok(()) }
    /// ```
    pub fn complex(&self) -> &PolygonalComplex {
        &self.complex
    }

    /// The cells that the triangles cut space into.
    ///
    /// # Errors
    /// None for triangles; as [`SpatialCells::with_predicates`].
    ///
    /// # Examples
    /// ```
    /// use coface_arrange::spatial::{CutOptions, CutTriangles};
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // A tetrahedron, and a triangle through it.
    /// let points = vec![0., 0., 0., 4., 0., 0., 0., 4., 0., 0., 0., 4., -9., -9., 1., 20., -9., 1., -9., 20., 1.];
    /// let positions = Positions::from_flat(3, points)?;
    /// let triangles = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2], [4, 5, 6]];
    /// let cut = CutTriangles::new(&positions, &triangles, &CutOptions::default())?;
    /// let cells = cut.cells()?;
    /// assert_eq!(cells.volumes(cut.positions())?, [(64.0 - 27.0) / 6.0, 27.0 / 6.0]);
    /// # Ok(()) }
    /// ```
    pub fn cells(&self) -> Result<SpatialCells, Error> {
        SpatialCells::with_predicates(Arc::clone(&self.complex), &self.predicates())
    }

    /// The faces around each edge in their order.
    pub(in crate::spatial) fn ordered_faces(
        &self,
        predicates: &impl SpatialPredicates,
        steps: &Steps,
    ) -> Result<OrderedFaces, Error> {
        OrderedFaces::new(Arc::clone(&self.complex), predicates, steps)
    }

    /// Exact decisions about the vertices.
    ///
    /// # Examples
    /// ```
    /// use coface_arrange::spatial::{CutTriangles, SpatialPredicates};
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // Two triangles that cross along a segment from (1, 1, 0) to (2, 2, 0).
    /// let points = vec![0., 0., 0., 4., 0., 0., 0., 4., 0., 1., 1., -1., 1., 1., 1., 9., 9., 0.];
    /// let positions = Positions::from_flat(3, points)?;
    /// let cut = CutTriangles::new(&positions, &[[0, 1, 2], [3, 4, 5]], &Default::default())?;
    /// // The point (1, 1, 0) is in the plane of the first triangle.
    /// assert!(cut.predicates().orientation([0, 1, 2, 6]).is_eq());
    /// # Ok(()) }
    /// ```
    pub fn predicates(&self) -> impl SpatialPredicates + '_ {
        CutPredicates {
            sheets: &self.sheets,
            vertices: &self.vertices,
            ends: self.complex.edges(),
            sheet_of_face: &self.sheet_of_face,
            supports: &self.supports,
        }
    }

    /// The exact position of a vertex.
    ///
    /// # Panics
    /// If there is no such vertex.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::VertexId;
    /// use coface_arrange::spatial::CutTriangles;
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // Two triangles that cross along a segment from (1, 1, 0) to (2, 2, 0).
    /// let points = vec![0., 0., 0., 4., 0., 0., 0., 4., 0., 1., 1., -1., 1., 1., 1., 9., 9., 0.];
    /// let positions = Positions::from_flat(3, points)?;
    /// let cut = CutTriangles::new(&positions, &[[0, 1, 2], [3, 4, 5]], &Default::default())?;
    /// assert!(cut.point(VertexId::new(6)).is_exactly_rounded());
    /// # Ok(()) }
    /// ```
    pub fn point(&self, vertex: VertexId) -> SpatialPoint {
        self.vertices.point(&self.sheets, vertex.to_u32()).into_owned()
    }

    /// The positions of the vertices: each coordinate is the floating-point number nearest to the exact one.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::VertexId;
    /// use coface_arrange::spatial::CutTriangles;
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // Two triangles that cross along a segment from (1, 1, 0) to (2, 2, 0).
    /// let points = vec![0., 0., 0., 4., 0., 0., 0., 4., 0., 1., 1., -1., 1., 1., 1., 9., 9., 0.];
    /// let positions = Positions::from_flat(3, points)?;
    /// let cut = CutTriangles::new(&positions, &[[0, 1, 2], [3, 4, 5]], &Default::default())?;
    /// assert_eq!(cut.positions().point(VertexId::new(7)), [2.0, 2.0, 0.0]);
    /// # Ok(()) }
    /// ```
    pub fn positions(&self) -> &Positions {
        &self.positions
    }

    /// What a vertex is.
    ///
    /// # Panics
    /// If there is no such vertex.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::VertexId;
    /// use coface_arrange::spatial::{CutTriangles, SpatialVertexSource};
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // Two triangles that cross along a segment from (1, 1, 0) to (2, 2, 0).
    /// let points = vec![0., 0., 0., 4., 0., 0., 0., 4., 0., 1., 1., -1., 1., 1., 1., 9., 9., 0.];
    /// let positions = Positions::from_flat(3, points)?;
    /// let cut = CutTriangles::new(&positions, &[[0, 1, 2], [3, 4, 5]], &Default::default())?;
    /// assert_eq!(cut.source(VertexId::new(0)), SpatialVertexSource::Given(0));
    /// # Ok(()) }
    /// ```
    pub fn source(&self, vertex: VertexId) -> SpatialVertexSource {
        let point = |vertex: u32| self.sheets.first_points[vertex as usize] as usize;
        let edge = |edge: u32| self.sheets.edges[edge as usize].map(point);
        let triangle = |sheet: u32| (self.sheets.sources.list(sheet as usize)[0] >> 1) as usize;
        let place = vertex.index().checked_sub(self.vertices.given).map(|new| self.vertices.places[new]);
        match place.unwrap_or(Place::Corner(vertex.to_u32())) {
            Place::Corner(vertex) => SpatialVertexSource::Given(point(vertex)),
            Place::Edges(edges) => SpatialVertexSource::Edges(edges.map(edge)),
            Place::EdgeAndSheet([e, sheet]) => SpatialVertexSource::EdgeAndTriangle(edge(e), triangle(sheet)),
            Place::Sheets(three) => SpatialVertexSource::Triangles(three.map(triangle)),
        }
    }

    /// The triangles of the input that a face is part of, rising, each as `2 * triangle + against`: against is 1 for
    /// triangles that run the other way than the face.
    ///
    /// # Panics
    /// If there is no such face.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::FaceId;
    /// use coface_arrange::spatial::CutTriangles;
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // Two triangles that cross along a segment from (1, 1, 0) to (2, 2, 0).
    /// let points = vec![0., 0., 0., 4., 0., 0., 0., 4., 0., 1., 1., -1., 1., 1., 1., 9., 9., 0.];
    /// let positions = Positions::from_flat(3, points)?;
    /// let cut = CutTriangles::new(&positions, &[[0, 1, 2], [3, 4, 5]], &Default::default())?;
    /// assert_eq!(cut.triangles_of_face(FaceId::new(0)), [0]);
    /// # Ok(()) }
    /// ```
    pub fn triangles_of_face(&self, face: FaceId) -> &[u32] {
        self.triangles_of_face.list(face.index())
    }

    /// The list of [`Self::triangles_of_face`] for each face.
    pub(in crate::spatial) fn triangles_of_faces(&self) -> &RaggedArray {
        &self.triangles_of_face
    }

    /// The plane of a face by three given points, which run counterclockwise seen from its front.
    ///
    /// # Panics
    /// If there is no such face.
    pub fn plane(&self, face: FaceId) -> SpatialPlane {
        self.sheets.plane(self.sheet_of_face[face.index()])
    }

    /// The sheet that a face is part of, which has the number of the first triangle of the input among equal ones, not
    /// counting those without area.
    pub(in crate::spatial) fn sheet_of_face(&self, face: FaceId) -> u32 {
        self.sheet_of_face[face.index()]
    }

    /// The vertices inside a face at which no edge of it ends, as where the apex of a pyramid touches it: face and vertex, rising.
    pub(in crate::spatial) fn points_in_faces(&self) -> &[[u32; 2]] {
        &self.points_in_faces
    }

    /// The distinct points and the triangles on them that were cut, as they were given: those without area left out are
    /// replaced by a corner three times.
    pub(in crate::spatial) fn input(&self, count: usize) -> (Vec<[f64; 3]>, Vec<[u32; 3]>) {
        let mut triangles = vec![[0; 3]; count];
        for (sheet, corners) in self.sheets.corners.iter().enumerate() {
            for &source in self.sheets.sources.list(sheet) {
                let [a, b, c] = *corners;
                triangles[(source >> 1) as usize] = if source & 1 == 0 { [a, b, c] } else { [a, c, b] };
            }
        }
        (self.sheets.points.clone(), triangles)
    }

    /// The vertex of each point of the input.
    ///
    /// # Examples
    /// ```
    /// use coface_arrange::spatial::CutTriangles;
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // Two triangles that cross along a segment from (1, 1, 0) to (2, 2, 0).
    /// let points = vec![0., 0., 0., 4., 0., 0., 0., 4., 0., 1., 1., -1., 1., 1., 1., 9., 9., 0.];
    /// let positions = Positions::from_flat(3, points)?;
    /// let cut = CutTriangles::new(&positions, &[[0, 1, 2], [3, 4, 5]], &Default::default())?;
    /// assert_eq!(cut.vertex_of_point(), [0, 1, 2, 3, 4, 5]);
    /// # Ok(()) }
    /// ```
    pub fn vertex_of_point(&self) -> &[u32] {
        &self.sheets.vertex_of_point
    }

    /// The triangles without area, rising. They are part of no face.
    ///
    /// # Examples
    /// ```
    /// use coface_arrange::spatial::CutTriangles;
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // Two triangles that cross along a segment from (1, 1, 0) to (2, 2, 0).
    /// let points = vec![0., 0., 0., 4., 0., 0., 0., 4., 0., 1., 1., -1., 1., 1., 1., 9., 9., 0.];
    /// let positions = Positions::from_flat(3, points)?;
    /// let cut = CutTriangles::new(&positions, &[[0, 1, 2], [3, 4, 5]], &Default::default())?;
    /// assert!(cut.degenerate_triangles().is_empty());
    /// # Ok(()) }
    /// ```
    pub fn degenerate_triangles(&self) -> &[u32] {
        &self.sheets.degenerate
    }
}

pub(super) fn check_input(positions: &Positions, triangles: &[[u32; 3]]) -> Result<(), Error> {
    if positions.dimension() != 3 && !positions.is_empty() {
        return Err(Error::new(
            ErrorKind::Shape,
            format!("points with {} coordinates are not points in space", positions.dimension()),
        )
        .with_cure("give three coordinates a point"));
    }
    let count = positions.len();
    if count >= 1 << 29 || triangles.len() >= 1 << 29 {
        return Err(Error::new(ErrorKind::TooLarge, "2^29 or more points or triangles"));
    }
    let is_outside = |triangle: &[u32; 3]| triangle.iter().any(|&corner| corner as usize >= count);
    match triangles.iter().position(is_outside) {
        None => Ok(()),
        Some(bad) => {
            let [a, b, c] = triangles[bad];
            Err(Error::new(
                ErrorKind::NotInComplex,
                format!("triangle {bad} has the corners {a}, {b}, {c}; there are {count} points"),
            ))
        }
    }
}

fn check_size(count: usize, most: usize) -> Result<(), Error> {
    if count <= most {
        return Ok(());
    }
    Err(Error::new(
        ErrorKind::TooLarge,
        format!("the triangles cut each other into more than {most} cells: {count} were found so far"),
    )
    .with_cure("allow more cells, or cut fewer triangles at a time"))
}

/// The fragments of all sheets, equal ones made one.
struct Faces {
    sides: RaggedArray,
    sheet_of: Vec<u32>,
    /// The triangles of each face as `2 * triangle + against`.
    triangles: RaggedArray,
    /// Faces with the vertices inside of them that no edge of them ends at.
    points: Vec<[u32; 2]>,
}

impl Faces {
    /// Each sheet is a step.
    fn new(all: &Fragmenting<'_>, overlapping: &[u32], steps: &Steps) -> Self {
        let sheets = all.on.sheets;
        let whole: Vec<Option<[u32; 3]>> = (0..sheets.count() as u32)
            .into_par_iter()
            .with_min_len(1 << 10)
            .map(|sheet| {
                let whole = all.is_whole(sheet).then(|| all.whole(sheet));
                if whole.is_some() {
                    steps.advance(1);
                }
                whole
            })
            .collect();
        let divided: Vec<u32> =
            (0..).zip(&whole).filter(|(_, whole)| whole.is_none()).map(|(sheet, _)| sheet).collect();
        let fragments_of = |&sheet: &u32| {
            let fragments = all.fragments(sheet);
            steps.advance(1);
            fragments
        };
        let fragments: Vec<Fragments> = divided.par_iter().with_min_len(16).map(fragments_of).collect();
        let mut fragments = fragments.into_iter();
        let (mut starts, mut items) =
            (Vec::with_capacity(whole.len() + 1), Vec::with_capacity(3 * whole.len()));
        let mut sheet_of = Vec::with_capacity(whole.len());
        starts.push(0u32);
        let mut add = |sheet: u32, list: &[u32]| {
            items.extend_from_slice(list);
            starts.push(u32::try_from(items.len()).expect("sides are fewer than 2^32"));
            sheet_of.push(sheet);
            sheet_of.len() as u32
        };
        let mut points: Vec<[u32; 2]> = Vec::new();
        let mut count = 0;
        for (sheet, own) in (0..).zip(whole) {
            match own {
                Some(own) => {
                    count = add(sheet, &own);
                    points.extend(all.points_of(sheet).map(|vertex| [count - 1, vertex]));
                }
                None => {
                    let (lists, own_points) = fragments.next().expect("divided sheets have fragments");
                    points
                        .extend(own_points.into_iter().map(|[fragment, vertex]| [count + fragment, vertex]));
                    lists.iter().for_each(|list| count = add(sheet, list));
                }
            }
        }
        points.sort_unstable();
        let sides = RaggedArray::from_parts(starts, items).expect("starts rise to the number of sides");
        if overlapping.is_empty() {
            let triangles = if sheets.sources.uniform_width() == Some(1) {
                let own = sheet_of.iter().map(|&sheet| sheets.sources.items()[sheet as usize]);
                RaggedArray::uniform(1, own.collect()).expect("faces are fewer than 2^32")
            } else {
                RaggedArray::from_lists(sheet_of.iter().map(|&sheet| sheets.sources.list(sheet as usize)))
            };
            return Self { sides, sheet_of, triangles, points };
        }
        Self::merged(sheets, &sides, &sheet_of, overlapping, &points)
    }

    /// Makes faces one that have the same edges, on the sheets that overlap others.
    fn merged(
        sheets: &Sheets,
        sides: &RaggedArray,
        sheet_of: &[u32],
        overlapping: &[u32],
        points: &[[u32; 2]],
    ) -> Self {
        let mut candidates: Vec<(Vec<u32>, u32)> = (0..sheet_of.len() as u32)
            .into_par_iter()
            .filter(|&face| overlapping.binary_search(&sheet_of[face as usize]).is_ok())
            .map(|face| {
                let mut edges: Vec<u32> = sides.list(face as usize).iter().map(|side| side >> 1).collect();
                edges.sort_unstable();
                (edges, face)
            })
            .collect();
        candidates.par_sort_unstable();
        // Each face as the first that is equal, times two, plus one if it runs the other way.
        let mut alike: Vec<u32> = (0..sheet_of.len() as u32).map(|face| face << 1).collect();
        for same in candidates.chunk_by(|a, b| a.0 == b.0).filter(|same| same.len() > 1) {
            let edges = &same[0].0;
            // A slit is there twice, the outer boundary once.
            let edge = edges
                .chunk_by(|a, b| a == b)
                .find(|own| own.len() == 1)
                .expect("a face has an outer boundary")[0];
            let against = |face: u32| sides.list(face as usize).contains(&(edge << 1 | 1));
            let first = same[0].1;
            for &(_, face) in &same[1..] {
                alike[face as usize] = first << 1 | u32::from(against(face) != against(first));
            }
        }
        let mut number = 0;
        let (mut keys, mut terms) = (Vec::new(), Vec::new());
        let mut numbers = vec![0; sheet_of.len()];
        let (mut own_sides, mut own_sheets) = (RaggedArray::new(), Vec::new());
        for (face, &packed) in alike.iter().enumerate() {
            let first = (packed >> 1) as usize;
            if first == face {
                numbers[face] = number;
                number += 1;
                own_sides.push(sides.list(face));
                own_sheets.push(sheet_of[face]);
            }
            for &source in sheets.sources.list(sheet_of[face] as usize) {
                keys.push(numbers[first]);
                terms.push(source ^ packed & 1);
            }
        }
        let mut triangles = RaggedArray::grouped(number as usize, keys.iter().copied());
        triangles.items_mut().iter_mut().for_each(|item| *item = terms[*item as usize]);
        let starts: Vec<usize> = (0..=triangles.len()).map(|face| triangles.start(face)).collect();
        for own in starts.windows(2) {
            triangles.items_mut()[own[0]..own[1]].sort_unstable();
        }
        let mut points: Vec<[u32; 2]> = points
            .iter()
            .map(|&[face, vertex]| [numbers[(alike[face as usize] >> 1) as usize], vertex])
            .collect();
        points.sort_unstable();
        points.dedup();
        Self { sides: own_sides, sheet_of: own_sheets, triangles, points }
    }
}
