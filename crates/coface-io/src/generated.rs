//! Cells that were made by rule, as models.

use super::{Group, GroupKind, Model, Structure};
use coface_algebra::RaggedArray;
use coface_algebra::{Error, VertexId};
use coface_complexes::cell_mesh::CellShape;
use coface_complexes::shapes::{CellKind, FlatAssembly, PlacedCells, turn_cell};
use coface_geometry::Positions;
use std::collections::BTreeMap;

impl Model {
    /// The model of these cells and positions.
    ///
    /// Points become points, segments lines of two vertices, triangles and squares polygons (a square by its cycle), simplices and
    /// cuboids of dimension 3 tetrahedra and hexahedra. Cells of the dimension of the space around them are turned so
    /// that they are positive: polygons in the plane run counterclockwise, 3-cells are as [`CellShape`] describes. Other cells
    /// keep their orientation.
    ///
    /// No mesh holds cells of dimension 4 and more: simplices become the structure [`Structure::Facets`], cuboids
    /// [`Structure::Chains`], the chain complex of [`PlacedCells::chain_complex`]. Neither has positions.
    ///
    /// # Errors
    /// [`coface_algebra::ErrorKind::TooLarge`] beyond $2^{32}$ incidences.
    ///
    /// # Complexity
    /// Linear up to dimension 3; beyond it that of [`PlacedCells::chain_complex`].
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_complexes::shapes::{CellKind, PlacedCells};
    /// use coface_geometry::Positions;
    /// use coface_io::Model;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let corners = Positions::from_flat(2, vec![0., 0., 0., 1., 1., 0., 1., 1.])?;
    /// let cells = RaggedArray::from_lists([[0, 1, 2, 3]]);
    /// let square = PlacedCells::new(corners, CellKind::Cuboid, 2, cells)?;
    /// assert_eq!(Model::from_placed_cells(square)?.polygons().list(0), [0, 2, 3, 1]);
    /// # Ok(()) }
    /// ```
    pub fn from_placed_cells(placed: PlacedCells) -> Result<Self, Error> {
        let (kind, dimension) = (placed.kind(), placed.dimension());
        if dimension > 3 {
            return Ok(Self::from_structure(match kind {
                CellKind::Simplex => Structure::Facets(placed.into_parts().1),
                CellKind::Cuboid => Structure::Chains(placed.chain_complex()?),
            }));
        }
        let (positions, cells) = placed.into_parts();
        let mut model = Self { vertex_count: positions.len(), positions, ..Self::default() };
        model.add_cells(kind, dimension, &cells);
        debug_assert_eq!(model.check(), Ok(()));
        Ok(model)
    }

    /// The cells of the model as lists of one kind and dimension each, all on the positions of the model: points, segments,
    /// triangles, squares for quadrangles, tetrahedra, cuboids for hexahedra; a list that would be empty is left out.
    ///
    /// # Errors
    /// [`coface_algebra::ErrorKind::InvalidInput`] without positions, and naming the first cell that is neither simplex nor cuboid.
    ///
    /// # Examples
    /// ```
    /// use coface_io as io;
    /// use coface_io::{Format, Model};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let text = &b"v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 0\nf 1 2 3 4\nf 2 5 3\n"[..];
    /// let parts = io::read(text, Format::Obj)?.placed_cells()?;
    /// assert_eq!(parts[0].cells().list(0), [1, 4, 2]);
    /// assert_eq!(parts[1].cells().list(0), [0, 3, 1, 2]);
    /// # Ok(()) }
    /// ```
    pub fn placed_cells(&self) -> Result<Vec<PlacedCells>, Error> {
        self.require_finite()?;
        if self.structure.is_some() || self.positions.dimension() == 0 {
            return Err(Error::invalid("the model has no positions").with_cure("give a mesh with positions"));
        }
        let no_cell = |what: String| {
            Err(Error::invalid(format!("{what} is neither a simplex nor a cuboid"))
                .with_cure("cut it into triangles or tetrahedra first"))
        };
        let mut lists: [RaggedArray; 6] = Default::default();
        self.points.iter().for_each(|point| lists[0].push(&[point.to_u32()]));
        self.lines.iter().flat_map(|line| line.windows(2)).for_each(|segment| lists[1].push(segment));
        for (i, polygon) in self.polygons.iter().enumerate() {
            match *polygon {
                [a, b, c] => lists[2].push(&[a, b, c]),
                [a, b, c, d] => lists[3].push(&[a, d, b, c]),
                _ => return no_cell(format!("face f{i}, with {} sides,", polygon.len())),
            }
        }
        for (i, (cell, shape)) in self.cells.iter().zip(&self.shapes).enumerate() {
            match (shape, cell) {
                (CellShape::Tetrahedron, _) => lists[4].push(cell),
                (CellShape::Hexahedron, &[a, b, c, d, e, f, g, h]) => {
                    lists[5].push(&[a, e, d, h, b, f, c, g]);
                }
                _ => return no_cell(format!("cell c{i}, a {},", shape.name())),
            }
        }
        let (s, c) = (CellKind::Simplex, CellKind::Cuboid);
        let sorts = [(s, 0), (s, 1), (s, 2), (c, 2), (s, 3), (c, 3)];
        let parts = sorts.into_iter().zip(lists).filter(|(_, cells)| !cells.is_empty());
        parts.map(|((kind, d), cells)| PlacedCells::new(self.positions.clone(), kind, d, cells)).collect()
    }

    /// The model of an assembly: points, lines, polygons and 3-cells as [`Self::from_placed_cells`] makes them, with a group for
    /// the cells of each leaf of an assembly of several, named by its path: `0.2` for the third item of the list that is the
    /// first item.
    ///
    /// # Errors
    /// [`coface_algebra::ErrorKind::InvalidInput`] for cells of dimension 4 and more.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::shapes;
    /// use coface_complexes::shapes::Assembly;
    /// use coface_io::Model;
    /// use std::sync::Arc;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let mut assembly = Assembly::new();
    /// assembly.push_cells(Arc::new(shapes::circle(1.0, 4)?));
    /// assembly.push_cells(Arc::new(shapes::circle(2.0, 6)?));
    /// let model = Model::from_assembly(&assembly.flatten()?)?;
    /// assert_eq!((model.vertex_count(), model.lines().len()), (10, 10));
    /// assert_eq!(model.groups()[1].members(), [4, 5, 6, 7, 8, 9]);
    /// # Ok(()) }
    /// ```
    pub fn from_assembly(assembly: &FlatAssembly) -> Result<Self, Error> {
        let positions = assembly.positions().clone();
        let mut model = Self { vertex_count: positions.len(), positions, ..Self::default() };
        let mut members: BTreeMap<(u32, GroupKind), Vec<u32>> = BTreeMap::new();
        for part in assembly.parts() {
            let kind = match part.dimension() {
                0 => GroupKind::Vertices,
                1 => GroupKind::Lines,
                2 => GroupKind::Polygons,
                3 => GroupKind::Cells,
                dimension => {
                    let leaf = part.leaves().first().map_or(0, |&leaf| leaf as usize);
                    return Err(Error::invalid(format!(
                        "item {} has cells of dimension {dimension}; a mesh holds dimension 3 at most",
                        path_name(assembly.path(leaf))
                    ))
                    .with_cure("take their skeleton of dimension 3 or less"));
                }
            };
            let first = match kind {
                GroupKind::Vertices => 0,
                kind => model.count_of(kind),
            };
            for (i, &leaf) in part.leaves().iter().enumerate() {
                let member =
                    if kind == GroupKind::Vertices { part.cells().list(i)[0] } else { (first + i) as u32 };
                members.entry((leaf, kind)).or_default().push(member);
            }
            model.add_cells(part.kind(), part.dimension(), part.cells());
        }
        if assembly.leaf_count() > 1 {
            model.groups = members
                .into_iter()
                .map(|((leaf, kind), members)| {
                    Group::new(path_name(assembly.path(leaf as usize)), kind, members)
                })
                .collect();
        }
        model.check()?;
        Ok(model)
    }

    /// Adds cells of dimension 3 or less on vertices of the model.
    pub(crate) fn add_cells(&mut self, kind: CellKind, dimension: usize, cells: &RaggedArray) {
        let is_full = self.positions.dimension() == dimension;
        for list in cells.iter() {
            let mut cell = [0u32; 8];
            let cell = &mut cell[..list.len()];
            cell.copy_from_slice(list);
            if is_full && volume_sign(&self.positions, kind, cell) < 0.0 {
                turn_cell(kind, cell);
            }
            let reorder = |order: &[usize]| -> Vec<u32> { order.iter().map(|&i| cell[i]).collect() };
            match (dimension, kind) {
                (0, _) => self.points.push(VertexId::from_u32(cell[0])),
                (1, _) => self.lines.push(cell),
                (2, CellKind::Simplex) => self.polygons.push(cell),
                (2, CellKind::Cuboid) => self.polygons.push(&reorder(&SQUARE)),
                (_, CellKind::Simplex) => {
                    self.shapes.push(CellShape::Tetrahedron);
                    self.cells.push(cell);
                }
                (_, CellKind::Cuboid) => {
                    self.shapes.push(CellShape::Hexahedron);
                    self.cells.push(&reorder(&CUBE));
                }
            }
        }
    }
}

/// A path as a name: its numbers with dots between them.
fn path_name(path: &[usize]) -> String {
    path.iter().map(ToString::to_string).collect::<Vec<_>>().join(".")
}

/// The cycle of a square by its local vertices: 00, 10, 11, 01.
const SQUARE: [usize; 4] = [0, 2, 3, 1];
/// The vertices of a cube as a hexahedron lists them: the cycle of the first two axes below, then above.
const CUBE: [usize; 8] = [0, 4, 6, 2, 1, 5, 7, 3];

/// A number with the sign of the volume of a cell of full dimension, up to rounding: of a simplex the determinant of its
/// edges at the first vertex, of a cuboid that of the mean edges along its axes.
fn volume_sign(positions: &Positions, kind: CellKind, cell: &[u32]) -> f64 {
    let dimension = positions.dimension();
    let point = |local: usize| positions.point(VertexId::from_u32(cell[local]));
    let mut edges = [[0.0; 3]; 3];
    for (axis, edge) in edges.iter_mut().enumerate().take(dimension) {
        for (k, x) in edge.iter_mut().enumerate().take(dimension) {
            *x = match kind {
                CellKind::Simplex => point(axis + 1)[k] - point(0)[k],
                CellKind::Cuboid => {
                    let bit = 1 << (dimension - 1 - axis);
                    (0..cell.len()).map(|i| if i & bit == 0 { -point(i)[k] } else { point(i)[k] }).sum()
                }
            };
        }
    }
    let [a, b, c] = edges;
    match dimension {
        1 => a[0],
        2 => a[0] * b[1] - a[1] * b[0],
        3 => {
            a[0] * (b[1] * c[2] - b[2] * c[1])
                + a[1] * (b[2] * c[0] - b[0] * c[2])
                + a[2] * (b[0] * c[1] - b[1] * c[0])
        }
        _ => 0.0,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use coface_complexes::cell_mesh::cell_volumes;

    fn cube(dimension: usize) -> Positions {
        let corner = |i: usize| (0..dimension).map(move |axis| (i >> (dimension - 1 - axis) & 1) as f64);
        Positions::from_flat(dimension, (0..1 << dimension).flat_map(corner).collect()).unwrap()
    }

    fn model(kind: CellKind, dimension: usize, space: usize, cells: &[&[u32]]) -> Model {
        let cells = RaggedArray::from_lists(cells);
        Model::from_placed_cells(PlacedCells::new(cube(space), kind, dimension, cells).unwrap()).unwrap()
    }

    fn volume(model: &Model) -> f64 {
        cell_volumes(model.positions(), model.shapes(), model.cells()).unwrap().signed()
    }

    #[test]
    fn cells_of_full_dimension_are_positive() {
        for mirrored in [false, true] {
            let cell: Vec<u32> = (0..8).map(|i| if mirrored { i ^ 2 } else { i }).collect();
            let hexahedron = model(CellKind::Cuboid, 3, 3, &[&cell]);
            assert_eq!(volume(&hexahedron), 1.0, "{cell:?}");
        }
        let five: [&[u32]; 5] = [&[0, 1, 2, 4], &[3, 1, 2, 7], &[5, 1, 4, 7], &[6, 2, 4, 7], &[1, 2, 4, 7]];
        assert!((volume(&model(CellKind::Simplex, 3, 3, &five)) - 1.0).abs() < 1e-12);
        let squares = model(CellKind::Cuboid, 2, 2, &[&[1, 0, 3, 2], &[0, 1, 2, 3]]);
        assert_eq!(squares.polygons(), &RaggedArray::from_lists([[3, 1, 0, 2], [0, 2, 3, 1]]));
    }

    #[test]
    fn lower_cells_keep_their_orientation() {
        let squares = model(CellKind::Cuboid, 2, 3, &[&[0, 1, 2, 3], &[0, 2, 1, 3]]);
        assert_eq!(squares.polygons(), &RaggedArray::from_lists([[0, 2, 3, 1], [0, 1, 3, 2]]));
        let segments = model(CellKind::Cuboid, 1, 2, &[&[3, 1]]);
        assert_eq!(segments.lines(), &RaggedArray::from_lists([[3, 1]]));
        let points = model(CellKind::Simplex, 0, 2, &[&[2]]);
        assert_eq!((points.points(), points.vertex_count()), (&[VertexId::new(2)][..], 4));
    }

    #[test]
    fn placed_cells_of_a_model_are_the_same_model() {
        let models = [
            model(CellKind::Cuboid, 3, 3, &[&[0, 1, 2, 3, 4, 5, 6, 7]]),
            model(CellKind::Simplex, 3, 3, &[&[0, 4, 2, 1]]),
            model(CellKind::Cuboid, 2, 3, &[&[0, 1, 2, 3], &[4, 0, 5, 1]]),
            model(CellKind::Simplex, 1, 2, &[&[0, 1], &[3, 1]]),
            model(CellKind::Simplex, 0, 2, &[&[3]]),
        ];
        for model in models {
            let [placed] = model.placed_cells().unwrap().try_into().unwrap();
            assert_eq!(Model::from_placed_cells(placed).unwrap(), model);
        }
        let pentagon = RaggedArray::from_lists([[0, 1, 2, 3, 4]]);
        let pentagon = Model::from_polygons(cube(3), pentagon).unwrap();
        assert!(pentagon.placed_cells().unwrap_err().to_string().contains("face f0, with 5 sides"));
        assert!(Model::default().placed_cells().is_err());
    }

    #[test]
    fn higher_cells_become_structures() {
        let simplices = model(CellKind::Simplex, 4, 4, &[&[0, 1, 2, 4, 8]]);
        assert_eq!(
            simplices.structure(),
            Some(&Structure::Facets(RaggedArray::from_lists([[0, 1, 2, 4, 8]])))
        );
        let all: Vec<u32> = (0..16).collect();
        let tesseract = model(CellKind::Cuboid, 4, 4, &[&all]);
        let Some(Structure::Chains(complex)) = tesseract.structure() else { panic!("no chains") };
        assert_eq!(complex.f_vector(), [16, 32, 24, 8, 1]);
    }
}
