//! Sheets brought together.

use super::cells::FlatFaces;
use super::sheet::{CutSheet, Point, Sheet};
use crate::congruence::{
    CellClasses, ChainCongruence, ClassRule, Collisions, CongruenceOptions, Representative, chain_congruence,
    vertex_congruence,
};
use coface_algebra::chains::ChainComplex;
use coface_algebra::{CellId, EdgeId, Error, ErrorKind, FaceId, VertexId};
use coface_algebra::{RaggedArray, Sign, SparseMatrix};
use coface_geometry::Positions;
use rayon::prelude::*;

/// No vertex.
const NONE: u32 = u32::MAX;

/// The arrangement of polygons in space up to a tolerance.
#[derive(Clone, Debug)]
pub struct CongruenceArrangement {
    complex: ChainComplex,
    positions: Positions,
    volumes: Vec<f64>,
    void_count: usize,
    /// For each face the polygons that it is in, as `2 * polygon + against`, rising.
    polygons_of_face: RaggedArray,
    /// The polygons with a piece at each vertex and along each edge, rising.
    polygons_of_low: [RaggedArray; 2],
    /// The vertex of each point that is a corner of a polygon that is there, else no number.
    vertex_of_point: Vec<u32>,
    dropped: Vec<u32>,
    stacked_f_vector: [usize; 3],
    glued_f_vector: [usize; 3],
    largest_class_diameter: f64,
}

/// The arrangement of polygons in space by congruence: each polygon is cut by the others in its own plane, the parts
/// are stacked as one chain complex, vertices within a tolerance of each other become one, the cells above them follow,
/// and gift wrapping makes the cells of space.
///
/// Walk i runs around polygon `polygon_of_walk[i]`: outer walks counterclockwise seen from the polygon's front, holes
/// clockwise. `tolerance` is a length in the unit of the positions: well above the rounding of coordinates, well below
/// the smallest distance of features that are different. Polygons that are nowhere wider are dropped and named.
///
/// This is the pipeline of the source texts, arrangement by congruence, beside the exact
/// [`SpatialArrangement`](crate::spatial::SpatialArrangement).
///
/// # Errors
/// [`ErrorKind::Shape`] unless there are three coordinates a point and a polygon for each walk;
/// [`ErrorKind::NotInComplex`] naming a walk with a point that is not there; [`ErrorKind::InvalidInput`] for a
/// tolerance that is negative or no number, naming a polygon that is farther from flat than the tolerance with its
/// deviation, and where the tolerance is so large that a face falls to pieces.
///
/// # Complexity
/// Quadratic in the sides and traces within one polygon; near-linear in the polygons if each meets few others.
///
/// # References
/// A. Paoluzzi, V. Shapiro, A. DiCarlo, F. Furiani, G. Martella, G. Scorzelli, *Topological computing of arrangements
/// with (co)chains* (2020). What is different: points are brought together within each plane before they are cut there,
/// slits are kept, and components are nested.
///
/// # Examples
/// A tetrahedron that a triangle cuts into a tip and a frustum:
/// ```
/// use coface_algebra::RaggedArray;
/// use coface_arrange::spatial::arrange_by_congruence;
/// use coface_geometry::Positions;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let tetrahedron = [0., 0., 0., 2., 0., 0., 0., 2., 0., 0., 0., 2.];
/// let blade = [-1., -1., 1., 5., -1., 1., -1., 5., 1.];
/// let positions = Positions::from_flat(3, [&tetrahedron[..], &blade].concat())?;
/// let walks = RaggedArray::from_lists([[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3], [4, 5, 6]]);
/// let cut = arrange_by_congruence(&positions, &walks, &[0, 1, 2, 3, 4], 1e-9)?;
/// assert_eq!(cut.f_vector(), [10, 15, 9, 2]);
/// let mut volumes = cut.volumes().to_vec();
/// volumes.sort_by(f64::total_cmp);
/// assert!((volumes[0] - 1.0 / 6.0).abs() < 1e-12 && (volumes[1] - 7.0 / 6.0).abs() < 1e-12);
/// # Ok(()) }
/// ```
pub fn arrange_by_congruence(
    positions: &Positions,
    walks: &RaggedArray,
    polygon_of_walk: &[u32],
    tolerance: f64,
) -> Result<CongruenceArrangement, Error> {
    let (sheets, dropped) = sheets(positions, walks, polygon_of_walk, tolerance)?;
    let numbers: Vec<u32> = (0..sheets.len() as u32).filter(|&i| sheets[i as usize].is_some()).collect();
    let sheets: Vec<Sheet> = sheets.into_iter().flatten().collect();
    let near = near_pairs(&sheets, tolerance);
    let cut: Vec<CutSheet> = (0..sheets.len())
        .into_par_iter()
        .map(|i| sheets[i].cut(near.list(i).iter().map(|&j| &sheets[j as usize]), tolerance))
        .collect::<Result<_, Error>>()?;
    let stack = Stack::new(&sheets, &cut)?;
    let vertices =
        vertex_congruence(&stack.positions, tolerance, ClassRule::Transitive, Representative::Lowest)?;
    let options = CongruenceOptions::new().collisions(Collisions::Rewrap);
    let classes = CellClasses::unsigned(vertices.class_of().to_vec())?;
    let merged = chain_congruence(&stack.complex, classes, Some(vertices.positions()), options)?;
    let [edges, faces] = merged.complex().boundary_matrices() else {
        return Err(Error::new(ErrorKind::Shape, "a quotient of faces has no faces"));
    };
    let slits = stack.slits(&merged)?;
    let (polygons_of_face, normals) = stack.sources(&merged, &sheets, &numbers);
    let polygons_of_low = [0, 1].map(|degree| stack.polygons_of(&merged, degree, &numbers));
    let vertex_of_point = vertices_of_points(positions.len(), walks, polygon_of_walk, &dropped, |corner| {
        merged.classes()[0].image(CellId::new(corner)).next().map(|(vertex, _)| vertex as u32)
    });
    let glued_f_vector =
        [0, 1, 2].map(|degree| merged.classes()[degree].members().iter().filter(|own| own.len() > 1).count());
    let flat = FlatFaces {
        positions: vertices.positions(),
        edges,
        faces,
        normals: &normals,
        slits: &slits,
        tolerance,
    };
    let cells = flat.cells()?;
    let complex = ChainComplex::new(vec![edges.clone(), faces.clone(), cells.boundaries])?;
    Ok(CongruenceArrangement {
        complex,
        positions: vertices.positions().clone(),
        volumes: cells.volumes,
        void_count: cells.void_count,
        polygons_of_face,
        polygons_of_low,
        vertex_of_point,
        dropped,
        glued_f_vector,
        stacked_f_vector: [0, 1, 2].map(|degree| stack.complex.cell_count(degree)),
        largest_class_diameter: vertices.largest_diameter(),
    })
}

impl CongruenceArrangement {
    /// The numbers of vertices, edges, faces and bounded cells.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_arrange::spatial::arrange_by_congruence;
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let corners = Positions::from_flat(3, vec![0., 0., 0., 1., 0., 0., 0., 1., 0., 0., 0., 1.])?;
    /// let sides = RaggedArray::from_lists([[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]);
    /// let tetrahedron = arrange_by_congruence(&corners, &sides, &[0, 1, 2, 3], 1e-9)?;
    /// assert_eq!(tetrahedron.f_vector(), [4, 6, 4, 1]);
    /// # Ok(()) }
    /// ```
    pub fn f_vector(&self) -> Vec<usize> {
        self.complex.f_vector().to_vec()
    }

    /// The chain complex of vertices, edges, faces and cells. A face has coefficient 1 in the boundary of the cell
    /// behind it and -1 in that of the cell in front. An edge inside a face (a slit) is not in its boundary.
    ///
    /// # Errors
    /// None: it is copied.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_arrange::spatial::arrange_by_congruence;
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let corners = Positions::from_flat(3, vec![0., 0., 0., 1., 0., 0., 0., 1., 0., 0., 0., 1.])?;
    /// let sides = RaggedArray::from_lists([[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]);
    /// let tetrahedron = arrange_by_congruence(&corners, &sides, &[0, 1, 2, 3], 1e-9)?;
    /// assert_eq!(tetrahedron.chain_complex()?.cell_count(3), 1);
    /// # Ok(()) }
    /// ```
    pub fn chain_complex(&self) -> Result<ChainComplex, Error> {
        Ok(self.complex.clone())
    }

    /// The positions of the vertices: corners of polygons where they are.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_arrange::spatial::arrange_by_congruence;
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let corners = Positions::from_flat(3, vec![0., 0., 0., 1., 0., 0., 0., 1., 0., 0., 0., 1.])?;
    /// let sides = RaggedArray::from_lists([[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]);
    /// let tetrahedron = arrange_by_congruence(&corners, &sides, &[0, 1, 2, 3], 1e-9)?;
    /// assert_eq!(tetrahedron.positions().len(), 4);
    /// # Ok(()) }
    /// ```
    pub fn positions(&self) -> &Positions {
        &self.positions
    }

    /// The volume of each cell, without its voids, in the cube of the unit of the positions, rounded.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_arrange::spatial::arrange_by_congruence;
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let corners = Positions::from_flat(3, vec![0., 0., 0., 1., 0., 0., 0., 1., 0., 0., 0., 1.])?;
    /// let sides = RaggedArray::from_lists([[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]);
    /// let tetrahedron = arrange_by_congruence(&corners, &sides, &[0, 1, 2, 3], 1e-9)?;
    /// assert!((tetrahedron.volumes()[0] - 1.0 / 6.0).abs() < 1e-12);
    /// # Ok(()) }
    /// ```
    pub fn volumes(&self) -> &[f64] {
        &self.volumes
    }

    /// The number of voids in cells: components that lie in them.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_arrange::spatial::arrange_by_congruence;
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let corners = Positions::from_flat(3, vec![0., 0., 0., 1., 0., 0., 0., 1., 0., 0., 0., 1.])?;
    /// let sides = RaggedArray::from_lists([[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]);
    /// let tetrahedron = arrange_by_congruence(&corners, &sides, &[0, 1, 2, 3], 1e-9)?;
    /// assert_eq!(tetrahedron.void_count(), 0);
    /// # Ok(()) }
    /// ```
    pub fn void_count(&self) -> usize {
        self.void_count
    }

    /// The polygons that a face is part of, rising, with minus where their fronts are at its back.
    ///
    /// # Panics
    /// If there is no such face.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::{FaceId, RaggedArray};
    /// use coface_arrange::spatial::arrange_by_congruence;
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let corners = Positions::from_flat(3, vec![0., 0., 0., 1., 0., 0., 0., 1., 0., 0., 0., 1.])?;
    /// let sides = RaggedArray::from_lists([[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]);
    /// let tetrahedron = arrange_by_congruence(&corners, &sides, &[0, 1, 2, 3], 1e-9)?;
    /// assert_eq!(tetrahedron.polygons_of_face(FaceId::new(0)).len(), 1);
    /// # Ok(()) }
    /// ```
    pub fn polygons_of_face(&self, face: FaceId) -> impl ExactSizeIterator<Item = (usize, Sign)> + '_ {
        let list = self.polygons_of_face.list(face.index()).iter();
        list.map(|&packed| {
            (packed as usize / 2, if packed.is_multiple_of(2) { Sign::Plus } else { Sign::Minus })
        })
    }

    /// The polygons with a piece at a vertex, rising: several where several pieces became one.
    ///
    /// # Panics
    /// If there is no such vertex.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::{RaggedArray, VertexId};
    /// use coface_arrange::spatial::arrange_by_congruence;
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let corners = Positions::from_flat(3, vec![0., 0., 0., 1., 0., 0., 0., 1., 0., 0., 0., 1.])?;
    /// let sides = RaggedArray::from_lists([[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]);
    /// let tetrahedron = arrange_by_congruence(&corners, &sides, &[0, 1, 2, 3], 1e-9)?;
    /// assert_eq!(tetrahedron.polygons_of_vertex(VertexId::new(0)).len(), 3);
    /// # Ok(()) }
    /// ```
    pub fn polygons_of_vertex(&self, vertex: VertexId) -> &[u32] {
        self.polygons_of_low[0].list(vertex.index())
    }

    /// The polygons with a piece along an edge, rising.
    ///
    /// # Panics
    /// If there is no such edge.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::{EdgeId, RaggedArray};
    /// use coface_arrange::spatial::arrange_by_congruence;
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let corners = Positions::from_flat(3, vec![0., 0., 0., 1., 0., 0., 0., 1., 0., 0., 0., 1.])?;
    /// let sides = RaggedArray::from_lists([[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]);
    /// let tetrahedron = arrange_by_congruence(&corners, &sides, &[0, 1, 2, 3], 1e-9)?;
    /// assert!((0..6).all(|edge| tetrahedron.polygons_of_edge(EdgeId::new(edge)).len() == 2));
    /// # Ok(()) }
    /// ```
    pub fn polygons_of_edge(&self, edge: EdgeId) -> &[u32] {
        self.polygons_of_low[1].list(edge.index())
    }

    /// The vertex that a point became; `None` for points that no polygon of the arrangement has as a corner.
    ///
    /// # Panics
    /// If there is no such point.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_arrange::spatial::arrange_by_congruence;
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let points = vec![0., 0., 0., 1., 0., 0., 0., 1., 0., 0., 0., 1., 0., 0., 1e-12];
    /// let sides = RaggedArray::from_lists([[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 4, 3]]);
    /// let tetrahedron = arrange_by_congruence(&Positions::from_flat(3, points)?, &sides, &[0, 1, 2, 3], 1e-9)?;
    /// assert_eq!(tetrahedron.vertex_of_point(4), tetrahedron.vertex_of_point(0));
    /// # Ok(()) }
    /// ```
    pub fn vertex_of_point(&self, point: usize) -> Option<VertexId> {
        Some(self.vertex_of_point[point]).filter(|&vertex| vertex != NONE).map(VertexId::from_u32)
    }

    /// The numbers of vertices, edges and faces that several pieces became.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_arrange::spatial::arrange_by_congruence;
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let corners = Positions::from_flat(3, vec![0., 0., 0., 1., 0., 0., 0., 1., 0., 0., 0., 1.])?;
    /// let sides = RaggedArray::from_lists([[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]);
    /// let tetrahedron = arrange_by_congruence(&corners, &sides, &[0, 1, 2, 3], 1e-9)?;
    /// // Each edge is a side of two triangles.
    /// assert_eq!(tetrahedron.glued_f_vector(), [4, 6, 0]);
    /// # Ok(()) }
    /// ```
    pub fn glued_f_vector(&self) -> [usize; 3] {
        self.glued_f_vector
    }

    /// The polygons that are nowhere wider than the tolerance, rising. They are not in the arrangement.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_arrange::spatial::arrange_by_congruence;
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let corners = Positions::from_flat(3, vec![0., 0., 0., 1., 0., 0., 0., 1., 0., 0., 0., 1.])?;
    /// let sides = RaggedArray::from_lists([[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]);
    /// let tetrahedron = arrange_by_congruence(&corners, &sides, &[0, 1, 2, 3], 1e-9)?;
    /// assert!(tetrahedron.dropped_polygons().is_empty());
    /// # Ok(()) }
    /// ```
    pub fn dropped_polygons(&self) -> &[u32] {
        &self.dropped
    }

    /// The numbers of vertices, edges and faces of all sheets together, before they were brought together.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_arrange::spatial::arrange_by_congruence;
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let corners = Positions::from_flat(3, vec![0., 0., 0., 1., 0., 0., 0., 1., 0., 0., 0., 1.])?;
    /// let sides = RaggedArray::from_lists([[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]);
    /// let tetrahedron = arrange_by_congruence(&corners, &sides, &[0, 1, 2, 3], 1e-9)?;
    /// // Each of the four sheets is a triangle with three edges of its own.
    /// assert_eq!(tetrahedron.stacked_f_vector()[1..], [12, 4]);
    /// # Ok(()) }
    /// ```
    pub fn stacked_f_vector(&self) -> [usize; 3] {
        self.stacked_f_vector
    }

    /// The largest distance of two vertices that became one: far below the tolerance if that was chosen well.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_arrange::spatial::arrange_by_congruence;
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let corners = Positions::from_flat(3, vec![0., 0., 0., 1., 0., 0., 0., 1., 0., 0., 0., 1.])?;
    /// let sides = RaggedArray::from_lists([[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]);
    /// let tetrahedron = arrange_by_congruence(&corners, &sides, &[0, 1, 2, 3], 1e-9)?;
    /// assert!(tetrahedron.largest_class_diameter() < 1e-12);
    /// # Ok(()) }
    /// ```
    pub fn largest_class_diameter(&self) -> f64 {
        self.largest_class_diameter
    }
}

/// The sheet of each polygon, and the polygons without one.
fn sheets(
    positions: &Positions,
    walks: &RaggedArray,
    polygon_of_walk: &[u32],
    tolerance: f64,
) -> Result<(Vec<Option<Sheet>>, Vec<u32>), Error> {
    if !(tolerance >= 0.0 && tolerance.is_finite()) {
        return Err(Error::invalid(format!("{tolerance} is not a tolerance"))
            .with_cure("give a length that is not negative, in the unit of the positions"));
    }
    if positions.dimension() != 3 && !positions.is_empty() {
        return Err(Error::new(
            ErrorKind::Shape,
            format!("points with {} coordinates are not points in space", positions.dimension()),
        )
        .with_cure("give three coordinates a point"));
    }
    let polygon_count = polygon_of_walk.iter().max().map_or(0, |&last| last as usize + 1);
    if polygon_of_walk.len() != walks.len() || polygon_count > walks.len() {
        return Err(Error::new(
            ErrorKind::Shape,
            format!(
                "{} walks of {polygon_count} polygons in a list of {}",
                walks.len(),
                polygon_of_walk.len()
            ),
        )
        .with_cure("name the polygon of each walk, polygons numbered without gaps"));
    }
    if let Some((walk, point)) = (walks.iter().enumerate())
        .find_map(|(i, walk)| Some((i, walk.iter().find(|&&point| point as usize >= positions.len())?)))
    {
        return Err(Error::new(
            ErrorKind::NotInComplex,
            format!("walk {walk} runs through point {point}; there are {} points", positions.len()),
        ));
    }
    let by_polygon = RaggedArray::grouped(polygon_count, polygon_of_walk.iter().copied());
    let place = |point: u32| -> Point {
        let point = positions.point(VertexId::from_u32(point));
        [point[0], point[1], point[2]]
    };
    let sheet = |polygon: usize| {
        let own = by_polygon.list(polygon);
        let corners = own.iter().map(|&walk| walks.list(walk as usize).iter().map(|&p| place(p)).collect());
        Sheet::new(corners.collect(), tolerance).map_err(|(deviation, walk, corner)| {
            let point = walks.list(own[walk] as usize)[corner];
            Error::invalid(format!(
                "polygon {polygon} is not flat: point {point} is {deviation:e} from its plane"
            ))
            .with_cells([vec![polygon as u32]])
            .with_cure("triangulate it, or choose a larger tolerance")
        })
    };
    let sheets: Vec<Option<Sheet>> = (0..polygon_count).map(sheet).collect::<Result<_, Error>>()?;
    let dropped = (0..).zip(&sheets).filter(|(_, sheet)| sheet.is_none()).map(|(polygon, _)| polygon);
    let dropped = dropped.collect();
    Ok((sheets, dropped))
}

/// The vertex of each point, from that of each corner of the polygons that are there, one polygon after the other.
fn vertices_of_points(
    count: usize,
    walks: &RaggedArray,
    polygon_of_walk: &[u32],
    dropped: &[u32],
    vertex_of_corner: impl Fn(usize) -> Option<u32>,
) -> Vec<u32> {
    let polygon_count = polygon_of_walk.iter().max().map_or(0, |&last| last as usize + 1);
    let by_polygon = RaggedArray::grouped(polygon_count, polygon_of_walk.iter().copied());
    let there = (0..polygon_count as u32).filter(|polygon| dropped.binary_search(polygon).is_err());
    let own = there.flat_map(|polygon| by_polygon.list(polygon as usize));
    let points = own.flat_map(|&walk| walks.list(walk as usize));
    let mut vertices = vec![NONE; count];
    for (corner, &point) in points.enumerate() {
        vertices[point as usize] = vertex_of_corner(corner).unwrap_or(NONE);
    }
    vertices
}

/// For each sheet the others whose boxes come within the tolerance, rising.
fn near_pairs(sheets: &[Sheet], tolerance: f64) -> RaggedArray {
    let mut order: Vec<usize> = (0..sheets.len()).collect();
    order.sort_by(|&i, &j| sheets[i].low[0].total_cmp(&sheets[j].low[0]).then(i.cmp(&j)));
    let mut near: Vec<Vec<u32>> = vec![Vec::new(); sheets.len()];
    for (place, &i) in order.iter().enumerate() {
        for &j in &order[place + 1..] {
            let (here, there) = (&sheets[i], &sheets[j]);
            if there.low[0] > here.high[0] + tolerance {
                break;
            }
            let meets = |axis: usize| {
                here.low[axis] <= there.high[axis] + tolerance
                    && there.low[axis] <= here.high[axis] + tolerance
            };
            if meets(1) && meets(2) {
                near[i].push(j as u32);
                near[j].push(i as u32);
            }
        }
    }
    near.iter_mut().for_each(|list| list.sort_unstable());
    RaggedArray::from_lists(near)
}

/// All sheets side by side, after the corners of the polygons: so that corners give their positions to the vertices at
/// them.
struct Stack {
    complex: ChainComplex,
    positions: Positions,
    /// Faces with edges inside of them.
    slits: Vec<[u32; 2]>,
    /// The sheet of each face.
    sheet_of_face: Vec<u32>,
    /// The sheet of each vertex and of each edge.
    sheet_of_low: [Vec<u32>; 2],
}

impl Stack {
    fn new(sheets: &[Sheet], cut: &[CutSheet]) -> Result<Self, Error> {
        let mut flat: Vec<f64> = sheets.iter().flat_map(|sheet| sheet.corners().flatten()).collect();
        let (mut edges, mut faces) = (Vec::new(), Vec::new());
        let (mut slits, mut sheet_of_face) = (Vec::new(), Vec::new());
        let mut edge_count = 0;
        let corners = (0..).zip(sheets).flat_map(|(sheet, own)| own.corners().map(move |_| sheet));
        let mut sheet_of_low: [Vec<u32>; 2] = [corners.collect(), Vec::new()];
        for (sheet, CutSheet { vertices, edges: own, faces: own_faces, slits: own_slits }) in (0..).zip(cut) {
            let (first_vertex, first_edge, first_face) = (flat.len() / 3, edge_count, sheet_of_face.len());
            flat.extend(vertices.iter().flatten());
            for (edge, ends) in own.iter().enumerate() {
                let [tail, head] = ends.map(|end| first_vertex + end as usize);
                edges.extend([(tail, first_edge + edge, -1i64), (head, first_edge + edge, 1)]);
            }
            edge_count += own.len();
            sheet_of_low[0].resize(flat.len() / 3, sheet);
            sheet_of_low[1].resize(edge_count, sheet);
            for (face, sides) in own_faces.iter().enumerate() {
                let side = |&(edge, sign)| (first_edge + edge as usize, first_face + face, i64::from(sign));
                faces.extend(sides.iter().map(side));
                sheet_of_face.push(sheet);
            }
            if edge_count >= 1 << 31 || first_face >= 1 << 30 || flat.len() / 3 >= 1 << 31 {
                return Err(Error::new(
                    ErrorKind::TooLarge,
                    "more than 2^30 faces, or 2^31 vertices or edges",
                ));
            }
            let packed = |&[face, edge]: &[u32; 2]| [first_face as u32 + face, first_edge as u32 + edge];
            slits.extend(own_slits.iter().map(packed));
        }
        let edges = SparseMatrix::from_entries(flat.len() / 3, edge_count, edges)?;
        let faces = SparseMatrix::from_entries(edge_count, sheet_of_face.len(), faces)?;
        let complex = ChainComplex::new(vec![edges, faces])?;
        Ok(Self { complex, positions: Positions::from_flat(3, flat)?, slits, sheet_of_face, sheet_of_low })
    }

    /// The polygons with a piece at each vertex or along each edge of the quotient, rising.
    fn polygons_of(&self, merged: &ChainCongruence, degree: usize, numbers: &[u32]) -> RaggedArray {
        let classes = &merged.classes()[degree];
        let mut pairs: Vec<(u32, u32)> = Vec::with_capacity(self.sheet_of_low[degree].len());
        for (piece, &sheet) in self.sheet_of_low[degree].iter().enumerate() {
            let own = classes.image(CellId::new(piece));
            pairs.extend(own.map(|(class, _)| (class as u32, numbers[sheet as usize])));
        }
        pairs.sort_unstable();
        pairs.dedup();
        let mut lists = RaggedArray::grouped(classes.class_count(), pairs.iter().map(|pair| pair.0));
        lists.items_mut().iter_mut().for_each(|item| *item = pairs[*item as usize].1);
        lists
    }

    /// The slits of the faces of the quotient, in order.
    fn slits(&self, merged: &ChainCongruence) -> Result<Vec<[u32; 2]>, Error> {
        let (edges, faces) = (&merged.classes()[1], &merged.classes()[2]);
        let boundaries = &merged.complex().boundary_matrices()[1];
        let mut slits = Vec::new();
        for &[face, edge] in &self.slits {
            let face = faces.image(CellId::from_u32(face));
            let Some((edge, _)) = edges.image(CellId::from_u32(edge)).next() else { continue };
            if face.len() > 1 {
                return Err(Error::invalid("a face with edges inside of it falls to pieces")
                    .with_cure("choose a smaller tolerance"));
            }
            for (face, _) in face {
                if boundaries.column(face).entry(edge) == 0 {
                    slits.push([face as u32, edge as u32]);
                }
            }
        }
        slits.sort_unstable();
        slits.dedup();
        Ok(slits)
    }

    /// The polygons of the faces of the quotient, and the normals of these faces.
    fn sources(
        &self,
        merged: &ChainCongruence,
        sheets: &[Sheet],
        numbers: &[u32],
    ) -> (RaggedArray, Vec<Point>) {
        let classes = &merged.classes()[2];
        let mut lists: Vec<Vec<u32>> = vec![Vec::new(); merged.complex().cell_count(2)];
        let mut normals = vec![[0.0; 3]; lists.len()];
        for (face, &sheet) in self.sheet_of_face.iter().enumerate() {
            for (class, sign) in classes.image(CellId::new(face)) {
                if lists[class].is_empty() {
                    let factor = f64::from(sign.to_i32());
                    normals[class] = sheets[sheet as usize].normal().map(|x| factor * x);
                }
                lists[class].push(2 * numbers[sheet as usize] + u32::from(sign == Sign::Minus));
            }
        }
        for list in &mut lists {
            list.sort_unstable();
            list.dedup();
        }
        (RaggedArray::from_lists(lists), normals)
    }
}
