//! Quotients as meshes.

use super::ModelCongruence;
use super::merging::source;
use crate::producer::Cells;
use coface_algebra::{CellId, Error, ErrorKind, VertexId};
use coface_algebra::{RaggedArray, Sign, SparseMatrix};
use coface_complexes::cell_mesh::CellShape;
use coface_io::{Model, ModelParts, repeated_vertex};

impl ModelCongruence {
    /// The quotient as a mesh: points, lines, polygons and 3-cells on the representatives.
    ///
    /// Cells in the boundary of no other are listed, and those that the models list. A cell that lost facets is what is
    /// left of it: a quadrangle becomes a triangle, a hexahedron a wedge or a pyramid. Groups and data are not kept.
    ///
    /// # Errors
    /// [`ErrorKind::UnsupportedFormat`] naming a class that no mesh holds: of degree 4 or more, an edge that is no segment, a
    /// face that is no polygon, a 3-cell of no known shape.
    ///
    /// # Complexity
    /// Linear in the incidences.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{CongruenceRequest, ModelCongruence};
    /// // Two triangles with a side in common, whose corners there are 0.001 apart.
    /// let a = coface_io::read(&b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"[..], coface_io::Format::Obj)?;
    /// let b = coface_io::read(&b"v 1 0 0\nv 1 1 0\nv 0 1 0.001\nf 1 2 3\n"[..], coface_io::Format::Obj)?;
    /// let models = vec![("a".to_owned(), a), ("b".to_owned(), b)];
    /// let merged = ModelCongruence::of(models, &CongruenceRequest::within(0.01))?;
    /// assert_eq!(merged.to_mesh()?.polygons().len(), 2);
    /// # Ok(()) }
    /// ```
    pub fn to_mesh(&self) -> Result<Model, Error> {
        let complex = self.complex();
        if complex.dimension().is_some_and(|dimension| dimension > 3) {
            return Err(refused("the quotient has cells of degree 4 or more"));
        }
        let listed: Vec<Vec<bool>> = (1..4).map(|degree| self.listed_classes(degree)).collect();
        let positions = self.vertices.positions().clone();
        let (mut lines, mut polygons) = (RaggedArray::new(), RaggedArray::new());
        for class in (0..complex.cell_count(1)).filter(|&class| listed[0][class]) {
            lines.push(&self.segment(class)?);
        }
        for class in (0..complex.cell_count(2)).filter(|&class| listed[1][class]) {
            polygons.push(&self.polygon(class)?);
        }
        let (mut shapes, mut cells) = (Vec::new(), RaggedArray::new());
        for class in 0..complex.cell_count(3) {
            let (shape, vertices) = self.cell(class)?;
            shapes.push(shape);
            cells.push(&vertices);
        }
        let model = ModelParts {
            vertex_count: positions.len(),
            positions,
            polygons,
            shapes,
            cells,
            lines,
            points: self.points(),
            ..ModelParts::default()
        }
        .into_model();
        model.check()?;
        Ok(model)
    }

    /// The classes of the vertices that models list as points, rising.
    fn points(&self) -> Vec<VertexId> {
        let points = self.listed.iter().enumerate().flat_map(|(model, listed)| {
            listed.points.iter().map(move |point| self.class_of_vertex(model, point.to_u32()))
        });
        let mut points: Vec<u32> = points.collect();
        points.sort_unstable();
        points.dedup();
        points.into_iter().map(VertexId::from_u32).collect()
    }

    fn class_of_vertex(&self, model: usize, vertex: u32) -> u32 {
        self.vertices.class_of()[self.starts[0][model] + vertex as usize]
    }

    /// Whether each class of a degree is in the boundary of no other, or the image of a cell that a model lists.
    fn listed_classes(&self, degree: usize) -> Vec<bool> {
        let mut listed = vec![true; self.complex().cell_count(degree)];
        if let Some(above) = self.complex().boundary_matrix(degree + 1) {
            above.rows().iter().for_each(|&row| listed[row as usize] = false);
        }
        for (model, (own, producer)) in self.listed.iter().zip(&self.producers).enumerate() {
            let mut list = |cell: usize| {
                let cell = CellId::new(self.starts[degree][model] + cell);
                self.chains.classes()[degree].image(cell).for_each(|(class, _)| listed[class] = true);
            };
            match (&producer.cells, degree) {
                (Cells::Polygons(mesh), 1) => {
                    let ends = own.segments.iter().map(|ends| ends.map(VertexId::from_u32));
                    let edges = ends.filter_map(|[a, b]| mesh.edge_between(a, b));
                    edges.for_each(|edge| list(edge.index()));
                }
                (Cells::Solids(mesh), 1) => {
                    let ends = own.segments.iter().map(|ends| ends.map(VertexId::from_u32));
                    let edges = ends.filter_map(|[a, b]| mesh.skeleton().edge_between(a, b));
                    edges.for_each(|edge| list(edge.index()));
                }
                (Cells::Solids(mesh), 2) => {
                    (0..own.polygon_count).for_each(|i| list(mesh.face_of_polygon(i).0.index()));
                }
                _ => {}
            }
        }
        listed
    }

    /// The classes of the vertices of the lowest member of a class, in the order of the model, unless they say nothing: the model
    /// has no such lists, the member was split, or vertices became one.
    fn vertices_of_member(&self, degree: usize, class: usize) -> Option<(usize, usize, Vec<u32>)> {
        let classes = &self.chains.classes()[degree];
        let member = *classes.members().list(class).first()? as usize;
        classes.class(CellId::new(member)).filter(|&(_, sign)| sign == Sign::Plus)?;
        let (model, cell) = source(&self.starts[degree], member);
        let producer = &self.producers[model];
        if !matches!(producer.cells, Cells::Polygons(_) | Cells::Solids(_)) {
            return None;
        }
        let vertices = producer.cell_vertices(degree, CellId::new(cell));
        let vertices: Vec<u32> =
            vertices.into_iter().map(|vertex| self.class_of_vertex(model, vertex)).collect();
        repeated_vertex(&vertices).is_none().then_some((model, cell, vertices))
    }

    fn boundary(&self, degree: usize) -> Option<&SparseMatrix> {
        self.complex().boundary_matrix(degree)
    }

    /// The ends of an edge class, from its start.
    fn segment(&self, class: usize) -> Result<[u32; 2], Error> {
        let column = self.boundary(1).map(|edges| edges.column(class));
        column.and_then(|column| ends(column.rows(), column.entries())).ok_or_else(|| {
            refused(format!("the boundary of edge class {class} is not one vertex less another"))
        })
    }

    /// The vertices around a face class.
    fn polygon(&self, class: usize) -> Result<Vec<u32>, Error> {
        if let Some((_, _, vertices)) = self.vertices_of_member(2, class) {
            return Ok(vertices);
        }
        self.cycle(class).ok_or_else(|| {
            refused(format!("the boundary of face class {class} is not one simple cycle of edges"))
        })
    }

    /// The vertices around a face class by its boundary, if that is one simple cycle of three or more edges.
    fn cycle(&self, class: usize) -> Option<Vec<u32>> {
        let (edges, faces) = (self.boundary(1)?, self.boundary(2)?);
        let mut steps: Vec<[u32; 2]> = Vec::new();
        for (edge, entry) in faces.column(class).iter() {
            let [a, b] = ends(edges.column(edge).rows(), edges.column(edge).entries())?;
            match entry {
                1 => steps.push([a, b]),
                -1 => steps.push([b, a]),
                _ => return None,
            }
        }
        let [start, mut at] = *steps.first()?;
        steps.sort_unstable();
        let mut cycle = vec![start];
        while at != start {
            cycle.push(at);
            let place = steps.partition_point(|step| step[0] < at);
            at = steps.get(place).filter(|step| step[0] == at)?[1];
            if cycle.len() > steps.len() {
                return None;
            }
        }
        let is_simple = cycle.len() == steps.len() && steps.windows(2).all(|pair| pair[0][0] != pair[1][0]);
        (is_simple && cycle.len() > 2).then_some(cycle)
    }

    /// The shape and the vertices of a 3-cell class.
    fn cell(&self, class: usize) -> Result<(CellShape, Vec<u32>), Error> {
        if let Some((model, cell, vertices)) = self.vertices_of_member(3, class)
            && let Cells::Solids(mesh) = &self.producers[model].cells
        {
            return Ok((mesh.shapes()[cell], vertices));
        }
        self.sides(class).and_then(|sides| recognized(&sides)).ok_or_else(|| {
            refused(format!(
                "cell class {class} is no tetrahedron, hexahedron, wedge or pyramid: its boundary has other sides"
            ))
        })
    }

    /// The sides of a 3-cell class, each counterclockwise seen from outside.
    fn sides(&self, class: usize) -> Option<Vec<Vec<u32>>> {
        let column = self.boundary(3)?.column(class);
        let sides = column.iter().map(|(face, entry)| {
            let mut cycle = self.cycle(face)?;
            match entry {
                1 => {}
                -1 => cycle.reverse(),
                _ => return None,
            }
            Some(cycle)
        });
        sides.collect()
    }
}

/// Start and end of an edge with this boundary.
fn ends(rows: &[u32], entries: &[i32]) -> Option<[u32; 2]> {
    match (rows, entries) {
        (&[a, b], [-1, 1]) => Some([a, b]),
        (&[a, b], [1, -1]) => Some([b, a]),
        _ => None,
    }
}

/// The cell with these sides: the first side that can be its bottom, and above each of its vertices the neighbor that is not in it.
fn recognized(sides: &[Vec<u32>]) -> Option<(CellShape, Vec<u32>)> {
    let mut all: Vec<u32> = sides.concat();
    all.sort_unstable();
    all.dedup();
    let shape = CellShape::ALL
        .into_iter()
        .find(|shape| shape.vertex_count() == all.len() && shape.faces().len() == sides.len())?;
    let bottom = shape.faces()[0];
    let base = sides.iter().find(|side| side.len() == bottom.len())?;
    let above = |vertex: u32| {
        let neighbors = sides.iter().flat_map(|side| {
            let place = side.iter().position(|&other| other == vertex);
            place.map(|place| side[(place + 1) % side.len()])
        });
        neighbors.into_iter().find(|neighbor| !base.contains(neighbor))
    };
    let mut vertices = vec![None; shape.vertex_count()];
    for (&local, &vertex) in bottom.iter().zip(base) {
        vertices[local] = Some(vertex);
    }
    for upper in bottom.len()..shape.vertex_count() {
        vertices[upper] = above(vertices[upper - bottom.len()]?);
    }
    let vertices: Vec<u32> = vertices.into_iter().collect::<Option<_>>()?;
    let is_side = |face: &&[usize]| {
        let face: Vec<u32> = face.iter().map(|&local| vertices[local]).collect();
        sides.iter().any(|side| is_same_cycle(side, &face))
    };
    shape.faces().iter().all(is_side).then_some((shape, vertices))
}

fn is_same_cycle(a: &[u32], b: &[u32]) -> bool {
    let Some(shift) = b.first().and_then(|first| a.iter().position(|vertex| vertex == first)) else {
        return false;
    };
    a.len() == b.len() && (0..a.len()).all(|i| a[(i + shift) % a.len()] == b[i])
}

fn refused(fault: impl Into<String>) -> Error {
    Error::new(ErrorKind::UnsupportedFormat, fault).with_cure("write JSON, which holds any chain complex")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{CongruenceRequest, Producer};
    use coface_geometry::Positions;
    use proptest::prelude::*;

    fn merged(model: Model) -> ModelCongruence {
        ModelCongruence::of(vec![("model".to_owned(), model)], &CongruenceRequest::within(1e-9)).unwrap()
    }

    /// Hexahedra on the corners of a unit cube, vertex i at the place of corner `corners[i]`.
    fn hexahedra(corners: &[usize], cells: &[[u32; 8]]) -> Model {
        const CORNERS: [[u8; 3]; 8] =
            [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]];
        let flat = corners.iter().flat_map(|&corner| CORNERS[corner]).map(f64::from).collect();
        let positions = Positions::from_flat(3, flat).unwrap();
        let shapes = vec![CellShape::Hexahedron; cells.len()];
        Model::from_cells(positions, shapes, RaggedArray::from_lists(cells)).unwrap()
    }

    #[test]
    fn hexahedra_with_short_edges_become_wedges_and_pyramids() {
        let own = [0, 1, 2, 3, 4, 5, 6, 7];
        let wedge = merged(hexahedra(&[0, 1, 2, 2, 4, 5, 6, 6], &[own]));
        let mesh = wedge.to_mesh().unwrap();
        assert_eq!(wedge.complex().f_vector(), [6, 9, 5, 1]);
        assert_eq!((mesh.shapes(), mesh.polygons().len()), (&[CellShape::Wedge][..], 0));
        let volume = |mesh: &Model| {
            coface_complexes::cell_mesh::cell_volumes(mesh.positions(), mesh.shapes(), mesh.cells())
                .unwrap()
                .signed()
        };
        assert!((volume(&mesh) - 0.5).abs() < 1e-15);
        let pyramid = merged(hexahedra(&[0, 1, 2, 3, 6, 6, 6, 6], &[own])).to_mesh().unwrap();
        assert_eq!(pyramid.shapes(), [CellShape::Pyramid]);
        assert!((volume(&pyramid) - 1.0 / 3.0).abs() < 1e-15);
        let tetrahedron = merged(hexahedra(&[0, 1, 2, 2, 6, 6, 6, 6], &[own])).to_mesh().unwrap();
        assert_eq!(tetrahedron.shapes(), [CellShape::Tetrahedron]);
        assert!((volume(&tetrahedron) - 1.0 / 6.0).abs() < 1e-15);
        // One edge less is no shape that a mesh knows.
        let odd = merged(hexahedra(&[0, 1, 2, 2, 4, 5, 6, 7], &[own]));
        assert!(odd.to_mesh().unwrap_err().to_string().contains("cell class 0 is no tetrahedron"));
        assert!(odd.to_chains().is_ok());
    }

    #[test]
    fn what_models_list_is_kept() {
        let own = [0, 1, 2, 3, 4, 5, 6, 7];
        let mut model = hexahedra(&[0, 1, 2, 3, 4, 5, 6, 7, 0, 1, 2, 7], &[own]).into_parts();
        model.polygons = RaggedArray::from_lists([[8, 9, 10]]);
        model.lines = RaggedArray::from_lists([[0, 1], [2, 11]]);
        model.points = vec![VertexId::new(8), VertexId::new(0)];
        let model = model.into_model();
        model.check().unwrap();
        let mesh = merged(model).to_mesh().unwrap();
        assert_eq!((mesh.vertex_count(), mesh.points()), (8, &[VertexId::new(0)][..]));
        // The triangle 0 1 2 is no side of the cube, and its third edge is new.
        assert_eq!(mesh.polygons(), &RaggedArray::from_lists([[0, 1, 2]]));
        assert_eq!(mesh.lines(), &RaggedArray::from_lists([[0, 1], [2, 7]]));
        assert_eq!(mesh.cells(), &RaggedArray::from_lists([own]));
    }

    proptest! {
        /// A mesh taken apart is put together again: polygons with vertices of their own against those of the mesh.
        #[test]
        fn soups_become_their_meshes(
            polygons in prop::collection::vec(prop::sample::subsequence((0..9u32).collect::<Vec<_>>(), 3..6), 1..12),
            turns in prop::collection::vec(0..5usize, 12),
        ) {
            let point = |vertex: u32| [f64::from(vertex % 3), f64::from(vertex / 3)];
            let mut corners = Vec::new();
            let mut lists = RaggedArray::new();
            let mut turned = Vec::new();
            for (polygon, turn) in polygons.iter().zip(&turns) {
                let mut polygon = polygon.clone();
                let middle = turn % polygon.len();
                polygon.rotate_left(middle);
                let first = (corners.len() / 2) as u32;
                polygon.iter().for_each(|&vertex| corners.extend(point(vertex)));
                lists.push(&(first..first + polygon.len() as u32).collect::<Vec<_>>());
                turned.push(polygon);
            }
            let positions = Positions::from_flat(2, corners).unwrap();
            let soup = merged(Model::from_polygons(positions, lists).unwrap());
            let mesh = soup.to_mesh().unwrap();
            // The quotient and the chain complex of the mesh that is written have the same cells.
            let again = Producer::of(mesh.clone()).unwrap().chain_complex().unwrap();
            prop_assert_eq!(again.f_vector(), soup.complex().f_vector());
            let numbers: Vec<u32> = {
                let mut first: Vec<u32> = Vec::new();
                turned.iter().flatten().for_each(|vertex| if !first.contains(vertex) { first.push(*vertex) });
                first
            };
            let named = |list: &[u32]| list.iter().map(|&vertex| numbers[vertex as usize]).collect::<Vec<_>>();
            let written: Vec<Vec<u32>> = mesh.polygons().iter().map(named).collect();
            prop_assert!(written.iter().all(|polygon| turned.contains(polygon)));
            // By the boundary alone the same cycles come out, up to where they start.
            for (class, polygon) in written.iter().enumerate() {
                let cycle = named(&soup.cycle(class).unwrap());
                prop_assert!(is_same_cycle(&cycle, polygon));
            }
        }
    }
}
