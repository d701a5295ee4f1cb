//! The graph of the cells of an arranged scene.

use super::boolean::sides_of_faces;
use super::{CongruentScene, SceneArrangement};
use crate::answer::{CellEdge, CellGraph, CellNode};
use coface_algebra::{CellId, Error, VertexId};
use coface_arrange::boolean::InsideRule;
use coface_geometry::determinant;

const EXTERIOR: u32 = u32::MAX;

impl SceneArrangement {
    /// The graph of the bounded cells: two are adjacent if they have a face in common. `inputs` of a cell is by the
    /// rule, as in
    /// [`Self::answer`].
    ///
    /// Areas, centroids and volumes are those of the rounded positions, in floating point.
    ///
    /// # Errors
    /// Those of [`Self::answer`].
    ///
    /// # Complexity
    /// $O(n \log n)$ for n corners of faces.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{SceneArrangement, SpatialRequest};
    /// // A tetrahedron of volume 1.
    /// let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 6\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
    /// let solid = coface_io::read(text.as_bytes(), coface_io::Format::Obj)?;
    /// let arranged = SceneArrangement::of([("solid", &solid)], &SpatialRequest::default())?;
    /// let graph = arranged.graph(Default::default())?;
    /// assert_eq!((graph.nodes[0].centroid, graph.edges.len()), ([0.25, 0.25, 1.5], 0));
    /// # Ok(()) }
    /// ```
    pub fn graph(&self, rule: InsideRule) -> Result<CellGraph, Error> {
        let membership = self.membership(rule)?;
        let parts = CellParts {
            names: self.scene.names(),
            volumes: self.volumes(),
            sides: self.sides_of_faces(),
            inputs_of_cell: &|cell| membership.inputs_around(cell),
            inputs_of_face: &|face| self.inputs_of_face(face),
            triangles: &|face| self.triangles_at(face),
        };
        parts.graph()
    }

    /// The corners of triangles that make up a face.
    fn triangles_at(&self, face: CellId) -> Result<Vec<[[f64; 3]; 3]>, Error> {
        let positions = self.arranged.drawn_positions();
        let point = |vertex: u32| {
            let point = positions.point(VertexId::from_u32(vertex));
            [point[0], point[1], point[2]]
        };
        Ok(self.arranged.triangles(face)?.into_iter().map(|corners| corners.map(point)).collect())
    }
}

impl CongruentScene {
    /// The graph of the bounded cells, as that of [`SceneArrangement::graph`]: two are adjacent if they have a face in common.
    ///
    /// # Errors
    /// [`coface_algebra::ErrorKind::InvalidInput`] where a face cannot be cut into triangles.
    ///
    /// # Complexity
    /// $O(n \log n)$ for n corners of faces.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 6\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
    /// let solid = coface_io::read(text.as_bytes(), coface_io::Format::Obj)?;
    /// let scene = coface_answers::SpatialScene::of([("solid", &solid)], true)?;
    /// let graph = coface_answers::CongruentScene::of_scene(scene, 1e-9)?.graph(Default::default())?;
    /// assert_eq!((graph.nodes[0].centroid, graph.edges.len()), ([0.25, 0.25, 1.5], 0));
    /// # Ok(()) }
    /// ```
    pub fn graph(&self, rule: InsideRule) -> Result<CellGraph, Error> {
        let membership = self.inputs().membership_of_closed(rule);
        let point = |vertex: u32| {
            let point = self.positions().point(VertexId::from_u32(vertex));
            [point[0], point[1], point[2]]
        };
        let parts = CellParts {
            names: self.scene().names(),
            volumes: self.volumes(),
            sides: sides_of_faces(self.complex()),
            inputs_of_cell: &|cell| membership.inputs_around(cell),
            inputs_of_face: &|face| self.inputs_of_face(face),
            triangles: &|face| {
                let pieces = self.pieces_of(face, true)?.into_iter();
                Ok(pieces.map(|own| [point(own[0]), point(own[1]), point(own[2])]).collect())
            },
        };
        parts.graph()
    }
}

/// What a graph of cells is made of.
struct CellParts<'a> {
    names: &'a [String],
    volumes: &'a [f64],
    /// The cells behind and in front of each face.
    sides: Vec<[u32; 2]>,
    inputs_of_cell: &'a dyn Fn(CellId) -> Vec<usize>,
    inputs_of_face: &'a dyn Fn(CellId) -> Vec<usize>,
    /// The corners of triangles that make up a face.
    triangles: &'a dyn Fn(CellId) -> Result<Vec<[[f64; 3]; 3]>, Error>,
}

impl CellParts<'_> {
    fn graph(&self) -> Result<CellGraph, Error> {
        let cell_count = self.volumes.len();
        let (volumes, sides) = (self.volumes, &self.sides);
        let mut nodes: Vec<CellNode> = (0..cell_count)
            .map(|cell| CellNode {
                cell,
                volume: volumes[cell],
                centroid: [0.0; 3],
                bounds: [[f64::INFINITY; 3], [f64::NEG_INFINITY; 3]],
                inputs: (self.inputs_of_cell)(CellId::new(cell)),
                exterior: false,
                exterior_area: 0.0,
                exterior_faces: 0,
                exterior_inputs: Vec::new(),
            })
            .collect();
        let is_wall = |face: &u32| {
            let [back, front] = sides[*face as usize];
            back != front
        };
        let faces: Vec<u32> = (0..sides.len() as u32).filter(is_wall).collect();
        let triangles = |face: u32| (self.triangles)(CellId::from_u32(face));
        for &face in &faces {
            for point in triangles(face)?.into_iter().flatten() {
                for cell in sides[face as usize].into_iter().filter(|&cell| cell != EXTERIOR) {
                    let [low, high] = &mut nodes[cell as usize].bounds;
                    for axis in 0..3 {
                        low[axis] = low[axis].min(point[axis]);
                        high[axis] = high[axis].max(point[axis]);
                    }
                }
            }
        }
        let middle = |[low, high]: [[f64; 3]; 2]| [0, 1, 2].map(|axis| low[axis] / 2.0 + high[axis] / 2.0);
        // Moments about the middle of each cell: sixfold volumes, and 24-fold first moments.
        let mut moments = vec![[0.0; 4]; cell_count];
        // For each face its cells, the smaller first and the exterior last, with its area.
        let mut between: Vec<([u32; 2], u32, f64)> = Vec::with_capacity(faces.len());
        for &face in &faces {
            let [back, front] = sides[face as usize];
            let mut area = 0.0;
            for corners in triangles(face)? {
                area += triangle_area(corners);
                for (cell, sign) in
                    [(back, 1.0), (front, -1.0)].into_iter().filter(|&(cell, _)| cell != EXTERIOR)
                {
                    let origin = middle(nodes[cell as usize].bounds);
                    let [a, b, c] = corners.map(|point| [0, 1, 2].map(|axis| point[axis] - origin[axis]));
                    let volume = sign * determinant(a, b, c);
                    let sums = &mut moments[cell as usize];
                    sums[3] += volume;
                    for axis in 0..3 {
                        sums[axis] += volume * (a[axis] + b[axis] + c[axis]);
                    }
                }
            }
            between.push(([back.min(front), back.max(front)], face, area));
        }
        for (node, sums) in nodes.iter_mut().zip(moments) {
            let origin = middle(node.bounds);
            let [low, high] = node.bounds;
            node.centroid = [0, 1, 2].map(|axis| {
                let offset = sums[axis] / (4.0 * sums[3]);
                // Rounding may leave nothing of a thin cell.
                if offset.is_finite() {
                    (origin[axis] + offset).clamp(low[axis], high[axis])
                } else {
                    origin[axis]
                }
            });
        }
        between.sort_unstable_by_key(|&(cells, face, _)| (cells, face));
        let mut edges = Vec::new();
        for group in between.chunk_by(|x, y| x.0 == y.0) {
            let area = group.iter().map(|&(_, _, area)| area).sum();
            let mut inputs: Vec<usize> = group
                .iter()
                .flat_map(|&(_, face, _)| (self.inputs_of_face)(CellId::from_u32(face)))
                .collect();
            inputs.sort_unstable();
            inputs.dedup();
            let [first, second] = group[0].0;
            if second == EXTERIOR {
                let node = &mut nodes[first as usize];
                (node.exterior, node.exterior_area, node.exterior_faces) = (true, area, group.len());
                node.exterior_inputs = inputs;
            } else {
                edges.push(CellEdge {
                    cells: [first as usize, second as usize],
                    area,
                    faces: group.len(),
                    inputs,
                });
            }
        }
        Ok(CellGraph { inputs: self.names.to_vec(), nodes, edges })
    }
}

fn triangle_area([a, b, c]: [[f64; 3]; 3]) -> f64 {
    let [u, v] = [b, c].map(|point| [0, 1, 2].map(|axis| point[axis] - a[axis]));
    let cross = [0, 1, 2].map(|axis| {
        let (next, last) = ((axis + 1) % 3, (axis + 2) % 3);
        u[next] * v[last] - u[last] * v[next]
    });
    cross[0].hypot(cross[1]).hypot(cross[2]) / 2.0
}
